#pragma once

#include "ui/viewport/camera.h"

#include <QPointF>

namespace knead {

inline Pixel pixelOf(const QPointF& position)
{
    return {position.x(), position.y()};
}

} // namespace knead
