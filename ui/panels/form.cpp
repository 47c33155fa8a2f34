#include "ui/panels/form.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

namespace knead {

namespace {

/// The wheel scrolls the panel; a material is not to change on the way. Letters choose from the list when Tab led to it, whatever
/// the window uses them for; after a click they are the window's, which is what one works with by then.
class Choice final : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride && m_isReachedByKeys &&
            isLetter(static_cast<QKeyEvent&>(*event))) {
            event->accept();
            return true;
        }
        return QComboBox::event(event);
    }

    void focusInEvent(QFocusEvent* event) override
    {
        if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
            m_isReachedByKeys = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
        QComboBox::focusInEvent(event);
    }

    void mousePressEvent(QMouseEvent* event) override
    {
        m_isReachedByKeys = false;
        QComboBox::mousePressEvent(event);
    }

    void wheelEvent(QWheelEvent* event) override { event->ignore(); }

private:
    static bool isLetter(const QKeyEvent& event)
    {
        const QString text = event.text();
        return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) && text.size() == 1 &&
               text[0].isLetterOrNumber();
    }

    bool m_isReachedByKeys = false;
};

} // namespace

QFormLayout* makeForm(QWidget* owner)
{
    auto* form = new QFormLayout(owner);
    form->setContentsMargins(10, 8, 10, 8);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

QLabel* makeHeading(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "heading");
    label->setWordWrap(true);
    return label;
}

QLabel* makeReading(const QString& name, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QComboBox* makeChoice(const QString& name, QWidget* parent)
{
    auto* choice = new Choice(parent);
    choice->setObjectName(name);
    return choice;
}

QCheckBox* boxFor(QAction* action, QWidget* parent)
{
    auto* box = new QCheckBox(parent);
    box->setObjectName(action->objectName() + "Box");
    const auto follow = [box, action] {
        box->setText(QString(action->text()).remove('&'));
        box->setChecked(action->isChecked());
        box->setEnabled(action->isEnabled());
        box->setToolTip(action->toolTip());
    };
    follow();
    QObject::connect(action, &QAction::changed, box, follow);
    QObject::connect(box, &QCheckBox::clicked, action, &QAction::setChecked);
    return box;
}

QuantityField* makeField(Quantity quantity, const QString& name, QWidget* parent)
{
    auto* field = new QuantityField(quantity, parent);
    field->setObjectName(name);
    return field;
}

} // namespace knead
