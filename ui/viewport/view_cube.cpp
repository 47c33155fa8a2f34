#include "ui/viewport/view_cube.h"

#include "ui/viewport/picker.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <QCoreApplication>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double extent = 104;    // of its square [pixels]
constexpr double cubeInset = 8;   // from the corner of the window [pixels]
constexpr double distance = 4.4;  // of the eye, in edges of the cube
constexpr int pixels = 160;       // of the picture of a side
constexpr double sideHalf = 0.31; // a hit further out than this belongs to an edge or a corner

/// A side of the cube as a person in front of it sees it.
struct SideLook {
    const char* name;
    Vec3 right;
    Vec3 up;
};

const std::array<SideLook, 6> looks{{{QT_TRANSLATE_NOOP("ViewCube", "FRONT"), Vec3::UnitX(), Vec3::UnitZ()},
                                     {QT_TRANSLATE_NOOP("ViewCube", "RIGHT"), Vec3::UnitY(), Vec3::UnitZ()},
                                     {QT_TRANSLATE_NOOP("ViewCube", "BACK"), -Vec3::UnitX(), Vec3::UnitZ()},
                                     {QT_TRANSLATE_NOOP("ViewCube", "LEFT"), -Vec3::UnitY(), Vec3::UnitZ()},
                                     {QT_TRANSLATE_NOOP("ViewCube", "TOP"), Vec3::UnitX(), Vec3::UnitY()},
                                     {QT_TRANSLATE_NOOP("ViewCube", "BOTTOM"), Vec3::UnitX(), -Vec3::UnitY()}}};

QColor colorOf(const Color& color)
{
    return QColor::fromRgbF(color.r, color.g, color.b);
}

QImage drawSide(const QString& name, const SceneStyle& style)
{
    QImage image(pixels, pixels, QImage::Format_RGB888);
    image.fill(colorOf(style.cube));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colorOf(style.cubeText), pixels / 26.0));
    painter.drawRect(image.rect());
    QFont font = QGuiApplication::font();
    font.setPixelSize(pixels / 5);
    font.setBold(true);
    painter.setFont(font);
    painter.drawText(image.rect(), Qt::AlignCenter, name);
    return image;
}

/// VTK's rows run upwards.
vtkSmartPointer<vtkImageData> vtkImage(const QImage& image)
{
    auto result = vtkSmartPointer<vtkImageData>::New();
    result->SetDimensions(image.width(), image.height(), 1);
    result->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int row = 0; row < image.height(); ++row)
        std::copy_n(image.constScanLine(row), 3 * image.width(),
                    static_cast<unsigned char*>(result->GetScalarPointer(0, image.height() - 1 - row, 0)));
    return result;
}

} // namespace

struct ViewCube::Parts {
    struct Side {
        vtkNew<vtkPlaneSource> plane;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkTexture> texture;
        vtkNew<vtkActor> actor;
    };
    vtkNew<vtkRenderer> renderer;
    std::array<Side, 6> sides;
};

ViewCube::ViewCube(vtkRenderWindow* window)
    : m_parts(std::make_unique<Parts>())
{
    for (std::size_t s = 0; s < looks.size(); ++s) {
        Parts::Side& side = m_parts->sides[s];
        const Vec3 right = looks[s].right;
        const Vec3 up = looks[s].up;
        const Vec3 corner = 0.5 * (right.cross(up) - right - up);
        side.plane->SetOrigin(corner.data());
        side.plane->SetPoint1(Vec3(corner + right).data());
        side.plane->SetPoint2(Vec3(corner + up).data());
        side.mapper->SetInputConnection(side.plane->GetOutputPort());
        side.texture->InterpolateOn();
        side.texture->MipmapOn();
        side.actor->SetMapper(side.mapper);
        side.actor->SetTexture(side.texture);
        side.actor->GetProperty()->BackfaceCullingOn();
        side.actor->GetProperty()->SetAmbient(0.6);
        side.actor->GetProperty()->SetDiffuse(0.4);
        m_parts->renderer->AddActor(side.actor);
    }
    m_parts->renderer->SetLayer(2);
    m_parts->renderer->InteractiveOff();
    window->SetNumberOfLayers(3);
    window->AddRenderer(m_parts->renderer);
    setCamera(m_camera);
}

ViewCube::~ViewCube() = default;

void ViewCube::setStyle(const SceneStyle& style)
{
    for (std::size_t s = 0; s < looks.size(); ++s)
        m_parts->sides[s].texture->SetInputData(
            vtkImage(drawSide(QCoreApplication::translate("ViewCube", looks[s].name), style)));
}

void ViewCube::setCamera(const Camera& camera)
{
    m_camera = camera;
    m_camera.target = Vec3::Zero();
    m_camera.distance = distance;
    m_camera.perspective = true;
    vtkCamera* eye = m_parts->renderer->GetActiveCamera();
    eye->SetPosition(m_camera.eye().data());
    eye->SetFocalPoint(0, 0, 0);
    eye->SetViewUp(m_camera.up().data());
    eye->SetViewAngle(Camera::viewAngle);
    eye->SetClippingRange(distance - 1.5, distance + 1.5);
}

void ViewCube::setWindow(const WindowSize& window)
{
    m_window = window;
    const double right = 1 - cubeInset / window.width;
    const double top = 1 - cubeInset / window.height;
    m_parts->renderer->SetViewport(right - extent / window.width, top - extent / window.height, right, top);
}

void ViewCube::setDrawn(bool on)
{
    m_parts->renderer->SetDraw(on);
}

std::optional<Vec3> ViewCube::directionAt(const Pixel& pixel) const
{
    const Pixel own{pixel.x - (m_window.width - cubeInset - extent), pixel.y - cubeInset};
    if (own.x < 0 || own.y < 0 || own.x > extent || own.y > extent)
        return std::nullopt;
    const Ray ray = m_camera.ray(own, {extent, extent});
    const std::optional<double> hit = pickBox(ray, Vec3::Ones(), {});
    if (!hit)
        return std::nullopt;
    Vec3 direction = ray.origin + *hit * ray.direction;
    for (double& coordinate : direction)
        coordinate = std::abs(coordinate) > sideHalf ? std::copysign(1.0, coordinate) : 0.0;
    return direction;
}

} // namespace knead
