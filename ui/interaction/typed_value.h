#pragma once

#include "ui/interaction/gizmo.h"
#include "ui/units.h"

#include <QString>

#include <array>
#include <optional>

class QKeyEvent;

namespace knead {

/// Numbers typed while a handle is dragged: "12.5", "-3 mm", "45 deg". Tab goes to the second of two.
class TypedValue {
public:
    void clear() { *this = {}; }
    bool isEmpty() const { return m_texts[0].isEmpty() && m_texts[1].isEmpty(); }

    /// Takes a key that belongs to a number or its unit.
    /// @param count of numbers that can be typed
    /// @return false for other keys
    bool take(const QKeyEvent& event, int count);
    static bool belongs(const QKeyEvent& event, bool hasText);

    /// What was typed takes the place of what the mouse says.
    /// @return empty when a text is no length, or no angle
    std::optional<GizmoAmount> applied(const GizmoAmount& amount, Quantity quantity) const;
    const QString& text(int index) const { return m_texts[static_cast<std::size_t>(index)]; }
    int current() const { return m_current; }

private:
    std::array<QString, 2> m_texts;
    int m_current = 0;
};

} // namespace knead
