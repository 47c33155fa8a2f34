#pragma once

#include "ui/interaction/gizmo.h"

#include <QRect>

class QPainter;

namespace knead {

/// Where a gizmo is drawn; empty when it lies behind the eye.
QRect gizmoArea(const Gizmo& gizmo);

/// Draws the handles: x red, y green, z blue.
/// @param lit the handle under the mouse, or in use
/// @param inUse then the others stand back
void drawGizmo(QPainter& painter, const Gizmo& gizmo, GizmoPart lit, bool inUse);

} // namespace knead
