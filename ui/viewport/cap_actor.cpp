#include "ui/viewport/cap_actor.h"

#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <numbers>

namespace knead {

namespace {

constexpr double frameMargin = 0.06; // around the box, in its sizes
constexpr int hatchPixels = 32;      // of the picture of a period
constexpr int linePixels = 5;

/// One period of hatching: a dark line on white.
vtkSmartPointer<vtkImageData> hatchPicture()
{
    constexpr unsigned char dark = 120;
    constexpr unsigned char soft = 190;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(hatchPixels, 2, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int row = 0; row < 2; ++row)
        for (int x = 0; x < hatchPixels; ++x) {
            const bool isRim = x == 0 || x == linePixels - 1;
            const unsigned char value = x >= linePixels ? 255 : isRim ? soft : dark;
            std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer(x, row, 0)), 3, value);
        }
    return image;
}

} // namespace

struct CapActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyData> faces;
    vtkNew<vtkPolyData> edges;
    vtkNew<vtkPolyDataMapper> faceMapper;
    vtkNew<vtkPolyDataMapper> edgeMapper;
    vtkNew<vtkTexture> texture;
    vtkNew<vtkActor> faceActor;
    vtkNew<StrokeActor> edgeActor;
};

CapActor::CapActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    Parts& p = *m_parts;
    p.renderer = renderer;
    p.texture->SetInputData(hatchPicture());
    p.texture->RepeatOn();
    p.texture->InterpolateOn();
    p.texture->MipmapOn();
    p.faceMapper->SetInputData(p.faces);
    p.faceMapper->ScalarVisibilityOff();
    p.faceMapper->SetResolveCoincidentTopologyToPolygonOffset();
    p.faceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    p.edgeMapper->SetInputData(p.edges);
    p.edgeMapper->ScalarVisibilityOff();
    p.faceActor->SetMapper(p.faceMapper);
    p.edgeActor->SetMapper(p.edgeMapper);
    p.faceActor->GetProperty()->SetAmbient(0.6); // it shall look cut, and not like another face
    p.faceActor->GetProperty()->SetDiffuse(0.4);
    p.edgeActor->GetProperty()->LightingOff();
    p.edgeActor->setLineWidth(2);
    renderer->AddActor(p.faceActor);
    renderer->AddActor(p.edgeActor);
}

CapActor::~CapActor()
{
    m_parts->renderer->RemoveActor(m_parts->faceActor);
    m_parts->renderer->RemoveActor(m_parts->edgeActor);
}

void CapActor::show(const PlaneSection& section, const CutPlane& plane, double hatching)
{
    const Mat3 frame = frameOf(plane);
    const Vec3 across = (frame.col(0) + frame.col(1)) / (std::numbers::sqrt2 * hatching);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> places; // in the picture of the hatching
    places->SetNumberOfComponents(2);
    for (const Vec3& point : section.points) {
        points->InsertNextPoint(point.data());
        normals->InsertNextTuple(plane.normal.data());
        places->InsertNextTuple2(point.dot(across), 0.5);
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& t : section.triangles)
        triangles->InsertNextCell({t[0], t[1], t[2]});
    vtkNew<vtkCellArray> lines;
    for (const auto& side : section.outline)
        lines->InsertNextCell({side[0], side[1]});
    m_parts->faces->SetPoints(points);
    m_parts->faces->SetPolys(triangles);
    m_parts->faces->GetPointData()->SetNormals(normals);
    m_parts->faces->GetPointData()->SetTCoords(places);
    m_parts->edges->SetPoints(points);
    m_parts->edges->SetLines(lines);
}

void CapActor::setLook(const Color& face, const Color& edge, bool isHatched)
{
    m_parts->faceActor->GetProperty()->SetColor(face.r, face.g, face.b);
    m_parts->edgeActor->GetProperty()->SetColor(edge.r, edge.g, edge.b);
    m_parts->faceActor->SetTexture(isHatched ? m_parts->texture.Get() : nullptr);
}

void CapActor::setVisible(bool visible)
{
    m_parts->faceActor->SetVisibility(visible);
    m_parts->edgeActor->SetVisibility(visible);
}

void CapActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->faceMapper->SetClippingPlanes(planes);
    m_parts->edgeMapper->SetClippingPlanes(planes);
}

struct PlaneFrameActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<StrokeActor> actor;
};

PlaneFrameActor::PlaneFrameActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    m_parts->renderer = renderer;
    m_parts->mapper->SetInputData(m_parts->data);
    m_parts->actor->SetMapper(m_parts->mapper);
    m_parts->actor->GetProperty()->LightingOff();
    m_parts->actor->setLineWidth(1.6F);
    renderer->AddActor(m_parts->actor);
}

PlaneFrameActor::~PlaneFrameActor()
{
    m_parts->renderer->RemoveActor(m_parts->actor);
}

void PlaneFrameActor::show(const CutPlane& plane, const Box& box)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& corner : frameCorners(plane, box))
        points->InsertNextPoint(corner.data());
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({0, 1, 2, 3, 0});
    m_parts->data->SetPoints(points);
    m_parts->data->SetLines(lines);
}

void PlaneFrameActor::setColor(const Color& color)
{
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
}

void PlaneFrameActor::setVisible(bool visible)
{
    m_parts->actor->SetVisibility(visible);
}

std::array<Vec3, 4> frameCorners(const CutPlane& plane, const Box& box)
{
    const Mat3 frame = frameOf(plane);
    Box inFrame;
    for (int corner = 0; corner < 8; ++corner)
        inFrame.extend(Vec3(frame.transpose() * box.corner(static_cast<Box::CornerType>(corner))));
    const Vec3 margin = Vec3::Constant(frameMargin * box.sizes().maxCoeff());
    const Vec3 low = inFrame.min() - margin;
    const Vec3 high = inFrame.max() + margin;
    const auto at = [&](double x, double y) -> Vec3 { return frame * Vec3(x, y, plane.offset); };
    return {at(low.x(), low.y()), at(high.x(), low.y()), at(high.x(), high.y()), at(low.x(), high.y())};
}

} // namespace knead
