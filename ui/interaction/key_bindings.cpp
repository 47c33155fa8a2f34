#include "ui/interaction/key_bindings.h"

#include <QKeySequence>

namespace knead {

const std::array<KeyBindings, drivenTools>& keyBindings()
{
    static constexpr std::array<KeyBindings, drivenTools> bindings = {{
        {Qt::Key_Up, Qt::Key_Left, Qt::Key_Down, Qt::Key_Right, Qt::Key_PageUp, Qt::Key_PageDown},
        {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_E, Qt::Key_Q},
        {Qt::Key_I, Qt::Key_J, Qt::Key_K, Qt::Key_L, Qt::Key_O, Qt::Key_U},
    }};
    return bindings;
}

std::optional<BoundKey> boundKey(int key)
{
    const std::array<int, 6> arrows = keyBindings().front().all();
    for (std::size_t tool = 0; tool < drivenTools; ++tool)
        for (std::size_t i = 0; i < arrows.size(); ++i)
            if (keyBindings()[tool].all()[i] == key)
                return BoundKey{tool, arrows[i]};
    return {};
}

QString keyName(int key)
{
    switch (key) {
    case Qt::Key_Up:
        return QStringLiteral("↑");
    case Qt::Key_Down:
        return QStringLiteral("↓");
    case Qt::Key_Left:
        return QStringLiteral("←");
    case Qt::Key_Right:
        return QStringLiteral("→");
    case Qt::Key_PageUp: // Qt's names of these two are too long for a cap
        return QStringLiteral("PgUp");
    case Qt::Key_PageDown:
        return QStringLiteral("PgDn");
    default:
        return QKeySequence(key).toString(QKeySequence::NativeText);
    }
}

} // namespace knead
