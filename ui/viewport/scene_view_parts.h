// What a SceneView consists of, for its own sources.
#pragma once

#include "ui/viewport/blending_renderer.h"
#include "ui/viewport/grid_actor.h"
#include "ui/viewport/ground_shadow_actor.h"
#include "ui/viewport/object_actor.h"
#include "ui/viewport/open_edges_actor.h"
#include "ui/viewport/region_actor.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/skin_actor.h"
#include "ui/viewport/surface_field_actors.h"
#include "ui/viewport/tool_actor.h"
#include "ui/viewport/view_cube.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <map>
#include <memory>
#include <vector>

namespace knead {

struct SceneView::Parts {
    vtkNew<BlendingRenderer> renderer;
    vtkNew<vtkRenderer> front; ///< of all that is in `renderer`: what is selected inside the material
    std::unique_ptr<ViewCube> cube;
    std::unique_ptr<GridActor> grid;
    std::unique_ptr<GroundShadowActor> shadow;
    std::vector<std::unique_ptr<SkinActor>> skins;
    std::vector<std::unique_ptr<SkinActor>> surfaces;
    std::unique_ptr<OpenEdgesActor> openEdges;
    std::unique_ptr<SurfaceFieldActors> fields;
    std::vector<std::unique_ptr<ObjectActor>> objects; ///< empty while they are not shown
    std::map<ToolId, std::unique_ptr<ToolActor>> tools;

    /// Selected and hovered edges among the rest, all else in front.
    struct Regions {
        explicit Regions(vtkRenderer* renderer)
            : selected(renderer)
            , hovered(renderer)
        {
        }
        RegionActor selected;
        RegionActor hovered;
    };
    std::unique_ptr<Regions> within;
    std::unique_ptr<Regions> inFront;
};

} // namespace knead
