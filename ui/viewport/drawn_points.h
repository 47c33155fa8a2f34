#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <numeric>
#include <vector>

namespace knead {

/// What actors of lines, dots and balls consist of: points, what joins them, and how they are drawn. It is in the renderer as long as
/// it lives.
template <class Mapper, class Actor>
struct DrawnPoints {
    explicit DrawnPoints(vtkRenderer* owner)
        : renderer(owner)
    {
        points->SetDataTypeToFloat();
        data->SetPoints(points);
        mapper->SetInputData(data);
        actor->SetMapper(mapper);
        renderer->AddActor(actor);
    }

    ~DrawnPoints() { renderer->RemoveActor(actor); }
    DrawnPoints(const DrawnPoints&) = delete;
    DrawnPoints& operator=(const DrawnPoints&) = delete;

    /// One dot or ball at each point. @param count of points
    void joinNothing(std::size_t count)
    {
        std::vector<vtkIdType> ids(count);
        std::iota(ids.begin(), ids.end(), 0);
        vtkNew<vtkCellArray> vertices;
        if (count > 0)
            vertices->InsertNextCell(static_cast<vtkIdType>(count), ids.data());
        data->SetVerts(vertices);
    }

    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPoints> points;
    vtkNew<vtkPolyData> data;
    vtkNew<Mapper> mapper;
    vtkNew<Actor> actor;
};

} // namespace knead
