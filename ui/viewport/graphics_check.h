#pragma once

#include <QString>

namespace knead {

/// Why no view can be drawn on this computer, in a sentence that says what to do; empty: it can. Needs the application object.
/// Window thread.
QString graphicsProblem();

} // namespace knead
