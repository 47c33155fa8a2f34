#include "ui/project/project_view.h"

#include <QBuffer>

#include <cmath>

namespace knead {

namespace {

constexpr QSize thumbnailSize(320, 200); // [pixels]

} // namespace

ProjectCamera kept(const Camera& camera)
{
    return {.position = camera.eye(),
            .focalPoint = camera.target,
            .up = camera.up(),
            .parallelScale = camera.viewHeight() / 2,
            .perspective = camera.perspective};
}

Camera restored(const ProjectCamera& kept)
{
    const Vec3 fields = kept.position - kept.focalPoint;
    const double distance = fields.norm();
    const Vec3 right = kept.up.cross(fields);
    Camera camera;
    camera.perspective = kept.perspective;
    if (!std::isfinite(distance) || !kept.focalPoint.allFinite() || !(right.norm() > 0))
        return camera;
    camera.target = kept.focalPoint;
    camera.distance = distance;
    camera.yaw = std::atan2(-right.x(), right.y());
    camera.pitch = std::atan2(fields.z(), distance * kept.up.z());
    return camera;
}

std::vector<std::byte> thumbnailOf(const QImage& view)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    view.scaled(thumbnailSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB32)
        .save(&buffer, "PNG");
    const auto* begin = reinterpret_cast<const std::byte*>(bytes.constData());
    return {begin, begin + bytes.size()};
}

} // namespace knead
