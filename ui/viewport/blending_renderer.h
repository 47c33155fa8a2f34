#pragma once

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkOpenGLRenderer.h>
#include <vtkProp.h>

#include <algorithm>
#include <limits>

namespace knead {

/// Blends what is translucent straight into the picture, from back to front, so that its rims are as smooth as all others.
/// VTK's own way draws it into a picture without multisampling, whose rims are jagged, with gaps along the lines on it.
class BlendingRenderer final : public vtkOpenGLRenderer {
public:
    static BlendingRenderer* New()
    {
        auto* renderer = new BlendingRenderer;
        renderer->InitializeObjectBase();
        return renderer;
    }

    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*buffer*/ = nullptr) override
    {
        std::stable_sort(PropArray, PropArray + PropArrayCount,
                         [this](vtkProp* a, vtkProp* b) { return depthOf(*a) > depthOf(*b); });
        UpdateTranslucentPolygonalGeometry();
    }

private:
    /// Of its middle, along the line of sight; what has no place is the last, and so is the ground: it is here where it
    /// lies before all else.
    double depthOf(vtkProp& prop)
    {
        const double* box = prop.GetUseBounds() ? prop.GetBounds() : nullptr;
        if (box == nullptr || !vtkMath::AreBoundsInitialized(box))
            return std::numeric_limits<double>::lowest();
        const double middle[] = {(box[0] + box[1]) / 2, (box[2] + box[3]) / 2, (box[4] + box[5]) / 2};
        return vtkMath::Dot(middle, GetActiveCamera()->GetDirectionOfProjection());
    }
};

} // namespace knead
