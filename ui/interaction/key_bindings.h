#pragma once

#include <QString>

#include <array>
#include <cstddef>
#include <optional>

namespace knead {

/// The keys of one tool: where each drives it, as seen in the view.
struct KeyBindings {
    int away, left, towards, right, up, down; ///< Qt::Key

    std::array<int, 6> all() const { return {away, left, towards, right, up, down}; }
};

/// Of the first, second and third tool: arrows; W A S D for the left hand; I J K L.
inline constexpr std::size_t drivenTools = 3;
const std::array<KeyBindings, drivenTools>& keyBindings();

/// Which tool a key drives, and as which arrow key it does.
struct BoundKey {
    std::size_t tool = 0;
    int arrow = 0; ///< Qt::Key_Right ... Qt::Key_PageDown
};
std::optional<BoundKey> boundKey(int key);

QString keyName(int key); ///< as on its cap: "W", "↑", "PgUp"

} // namespace knead
