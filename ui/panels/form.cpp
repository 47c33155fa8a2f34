#include "ui/panels/form.h"

#include <QComboBox>
#include <QLabel>
#include <QWheelEvent>

namespace knead {

namespace {

/// The wheel scrolls the panel; a material is not to change on the way.
class Choice final : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
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

QuantityField* makeField(Quantity quantity, const QString& name, QWidget* parent)
{
    auto* field = new QuantityField(quantity, parent);
    field->setObjectName(name);
    return field;
}

} // namespace knead
