#include "ui/screen_reader.h"

#include <QAccessibleWidget>
#include <QWidget>

#include <utility>

namespace knead {

namespace {

/// What a widget was said to be; lives as long as the widget, as its child.
class WidgetReading final : public QObject {
public:
    explicit WidgetReading(QWidget& widget)
        : QObject(&widget)
    {
    }

    static const WidgetReading* of(const QObject& widget)
    {
        for (const QObject* child : widget.children())
            if (const auto* found = dynamic_cast<const WidgetReading*>(child))
                return found;
        return nullptr;
    }

    QAccessible::Role role = QAccessible::Client;
    std::function<QString()> value;
    std::function<ReadRange()> range;
};

/// The value is told as the description too: some readers ask for no other text.
class ReadWidget final : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    explicit ReadWidget(QWidget& widget)
        : QAccessibleWidget(&widget, WidgetReading::of(widget)->role)
    {
    }

    QString text(QAccessible::Text kind) const override
    {
        const WidgetReading* reading = this->reading();
        if (reading != nullptr && (kind == QAccessible::Value || kind == QAccessible::Description))
            return reading->value();
        return QAccessibleWidget::text(kind);
    }

    void* interface_cast(QAccessible::InterfaceType kind) override
    {
        if (kind == QAccessible::ValueInterface && reading() != nullptr && reading()->range)
            return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(kind);
    }

    QVariant currentValue() const override { return reading()->range().now; }
    QVariant minimumValue() const override { return reading()->range().least; }
    QVariant maximumValue() const override { return reading()->range().most; }
    QVariant minimumStepSize() const override { return 0.0; }
    void setCurrentValue(const QVariant& /*value*/) override {} // its keys move it

private:
    const WidgetReading* reading() const { return widget() == nullptr ? nullptr : WidgetReading::of(*widget()); }
};

QAccessibleInterface* readerOf(const QString& /*className*/, QObject* object)
{
    if (object == nullptr || !object->isWidgetType() || WidgetReading::of(*object) == nullptr)
        return nullptr;
    return new ReadWidget(*static_cast<QWidget*>(object));
}

} // namespace

void readAs(QWidget& widget, QAccessible::Role role, std::function<QString()> value, std::function<ReadRange()> range)
{
    QAccessible::installFactory(readerOf); // once: a known one is not added again
    auto* reading = new WidgetReading(widget);
    reading->role = role;
    reading->value = std::move(value);
    reading->range = std::move(range);
}

void tellReader(QWidget& widget)
{
    if (!QAccessible::isActive())
        return;
    const WidgetReading* reading = WidgetReading::of(widget);
    if (reading == nullptr)
        return;
    QAccessibleValueChangeEvent value(&widget, reading->range ? QVariant(reading->range().now) : reading->value());
    QAccessible::updateAccessibility(&value);
    QAccessibleEvent description(&widget, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&description);
}

} // namespace knead
