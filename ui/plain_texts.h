#pragma once

namespace knead {

/// From now on labels, boxes and tool tips show texts as they stand, names from files among them: Qt would take "<img src=...>" for a
/// picture to load. Those that were told to show rich text before they are shown still do.
/// For the one application; again it does nothing.
void showTextsAsTheyStand();

} // namespace knead
