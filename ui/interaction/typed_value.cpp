#include "ui/interaction/typed_value.h"

#include <QKeyEvent>

namespace knead {

bool TypedValue::belongs(const QKeyEvent& event, bool hasText)
{
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return false;
    if (event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backspace) // one too many is no Reset
        return true;
    const QString text = event.text();
    if (text.size() != 1)
        return false;
    const QChar letter = text[0];
    const bool begins = letter.isDigit() || QStringLiteral("+-.,").contains(letter);
    return begins || (hasText && (letter.isLetter() || letter == QChar(0xb0) || letter == QLatin1Char(32)));
}

bool TypedValue::take(const QKeyEvent& event, int count)
{
    QString& text = m_texts[static_cast<std::size_t>(m_current)];
    if (!belongs(event, !isEmpty()))
        return false;
    if (event.key() == Qt::Key_Tab)
        m_current = (m_current + 1) % count;
    else if (event.key() == Qt::Key_Backspace)
        text.chop(1);
    else
        text += event.text();
    return true;
}

std::optional<GizmoAmount> TypedValue::applied(const GizmoAmount& amount, Quantity quantity) const
{
    GizmoAmount result = isEmpty() ? amount : GizmoAmount{{}, amount.count};
    for (std::size_t i = 0; i < m_texts.size(); ++i) {
        if (m_texts[i].isEmpty())
            continue;
        const std::optional<double> value = parseQuantity(m_texts[i], quantity);
        if (!value)
            return {};
        result.values[i] = *value;
    }
    return result;
}

} // namespace knead
