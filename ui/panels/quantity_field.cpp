#include "ui/panels/quantity_field.h"

#include "ui/language/said.h"

#include <QFocusEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QStyle>
#include <QToolTip>

#include <cmath>

namespace knead {

QuantityField::QuantityField(Quantity quantity, QWidget* parent)
    : QLineEdit(parent)
    , m_quantity(quantity)
{
    setAlignment(Qt::AlignRight);
    setText(formatQuantity(m_value, m_quantity));
}

void QuantityField::setRange(double minimum, double maximum)
{
    m_minimum = minimum;
    m_maximum = maximum;
}

void QuantityField::setTip(const Message& tip)
{
    m_tip = said(tip.with(formatQuantity(m_minimum, m_quantity).toStdString(),
                          formatQuantity(m_maximum, m_quantity).toStdString()));
    if (!hasProblem())
        setToolTip(m_tip);
}

void QuantityField::setZeroText(const QString& text)
{
    m_zeroText = text;
    setPlaceholderText(text);
    restore();
}

/// Nothing where words in its place say it: for a 0 that has some, and without a value.
QString QuantityField::shown() const
{
    if (m_hasNoValue)
        return {};
    return m_value == 0 && !m_zeroText.isEmpty() ? QString() : formatQuantity(m_value, m_quantity);
}

void QuantityField::setValue(double value)
{
    m_value = value;
    m_hasNoValue = false;
    showValue();
}

void QuantityField::setNoValue(const QString& words)
{
    m_value = 0;
    m_hasNoValue = true;
    setPlaceholderText(words);
    showValue();
}

void QuantityField::showValue()
{
    if (!isModified() && !m_isBeingEdited)
        setText(shown());
}

QSize QuantityField::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(QStringLiteral("00000.00 kg/m³")) + 16, QLineEdit::sizeHint().height()};
}

/// Enter and Esc belong to the field while it has the keyboard, whatever the window uses them for.
bool QuantityField::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip(), this);
        return true;
    }
    return QLineEdit::event(event);
}

QString QuantityField::tip() const
{
    if (hasProblem())
        return m_problem;
    QStringList lines;
    if (!toolTip().isEmpty())
        lines << toolTip();
    if (std::isfinite(m_minimum) && std::isfinite(m_maximum))
        lines << tr("Allowed: %1 to %2")
                     .arg(formatQuantity(m_minimum, m_quantity), formatQuantity(m_maximum, m_quantity));
    else if (std::isfinite(m_minimum))
        lines << tr("Allowed: %1 or more").arg(formatQuantity(m_minimum, m_quantity));
    const QStringList units = unitsFor(m_quantity);
    lines << (units.isEmpty() ? tr("A number, such as 0.5, 0,5 or 5e-1") : tr("Units: %1").arg(units.join(", ")));
    return lines.join('\n');
}

void QuantityField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        restore();
        emit finished();
        return;
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (isModified())
            commit();
        else
            restore();
        if (!hasProblem())
            emit finished();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void QuantityField::focusInEvent(QFocusEvent* event)
{
    m_isBeingEdited = true;
    QLineEdit::focusInEvent(event);
}

void QuantityField::mousePressEvent(QMouseEvent* event)
{
    m_isBeingEdited = true;
    QLineEdit::mousePressEvent(event);
}

void QuantityField::focusOutEvent(QFocusEvent* event)
{
    // A menu or another window takes the focus only for a while: the person is still typing.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) {
        commit();
        if (!isModified())
            restore(); // shows what came in meanwhile
    }
    QLineEdit::focusOutEvent(event);
}

void QuantityField::commit()
{
    if (!isModified())
        return;
    const bool isEmptied = text().trimmed().isEmpty() && !m_zeroText.isEmpty();
    const std::optional<double> read = isEmptied ? 0 : parseQuantity(text(), m_quantity, m_value);
    if (!read) {
        showProblem(tr("\"%1\" is not a number here; the value is still %2. Esc restores it.")
                        .arg(text(), formatQuantity(m_value, m_quantity)));
        return;
    }
    if (*read < m_minimum || *read > m_maximum) {
        showProblem(tr("Allowed is %1 to %2; the value is still %3. Esc restores it.")
                        .arg(formatQuantity(m_minimum, m_quantity), formatQuantity(m_maximum, m_quantity),
                             formatQuantity(m_value, m_quantity)));
        return;
    }
    m_value = *read;
    m_hasNoValue = false;
    restore();
    emit committed(m_value);
}

void QuantityField::restore()
{
    m_isBeingEdited = false;
    setText(shown()); // clears isModified()
    showProblem({});
}

void QuantityField::showProblem(const QString& problem)
{
    if (!hasProblem())
        m_tip = toolTip(); // as whoever set it says it now
    m_problem = problem;
    setToolTip(problem.isEmpty() ? m_tip : problem);
    setProperty("problem", hasProblem()); // the style sheet draws the mark
    style()->unpolish(this);
    style()->polish(this);
}

} // namespace knead
