#pragma once

namespace knead {

/// Properties of actions whose tool tip has keys added to it.
namespace tip_properties {

inline constexpr const char* withoutKeys = "tipWithoutKeys"; ///< what it says but for the keys
inline constexpr const char* isText = "tipIsText";           ///< it follows the action's text

} // namespace tip_properties

} // namespace knead
