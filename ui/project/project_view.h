#pragma once

#include "core/document/project.h"
#include "ui/viewport/camera.h"

#include <QImage>

#include <cstddef>
#include <vector>

namespace knead {

/// A camera as a project keeps it.
ProjectCamera kept(const Camera& camera);

/// The other way. A camera that another program wrote and that is tilted comes upright; one that makes no sense looks like a new
/// one.
Camera restored(const ProjectCamera& kept);

/// A small PNG picture of what is seen.
std::vector<std::byte> thumbnailOf(const QImage& view);

} // namespace knead
