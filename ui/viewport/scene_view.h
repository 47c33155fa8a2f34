#pragma once

#include "core/session/frame.h"
#include "core/session/material_look.h"
#include "core/session/part_appearance.h"
#include "core/session/region.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/color_scale.h"
#include "ui/viewport/scene_style.h"
#include "ui/viewport/skin_shading.h"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace knead {

class RegionActor;
class ViewCube;

/// Which objects are drawn as balls.
enum class ObjectDisplay { Off, Surface, All };

/// How a part is cut open to be looked into.
struct SectionOptions {
    std::optional<CutPlane> plane; ///< none: whole
    bool isHatched = true;         ///< the faces of the cut
    bool hasFrame = true;          ///< a rectangle shows where the plane lies

    friend bool operator==(const SectionOptions&, const SectionOptions&) = default;
};

/// What a person chose to see.
struct SceneOptions {
    bool skin = true;         ///< as through glass when objects or connections are shown too
    bool connections = false; ///< of the objects that are drawn, or would be
    bool original = false;    ///< the shape at rest, translucent
    bool breaks = false;      ///< marks where connections broke
    bool warnings = true;     ///< marks where material folds, gets thin or is about to break
    ColorOptions colors;
    Shading shading = Shading::usual; ///< of skins whose colors tell no values
    SectionOptions section;
    /// Left of it the original shape is drawn, right of it that of now; 0 .. 1 of the width.
    std::optional<double> divider;
    ObjectDisplay objects = ObjectDisplay::Off;
    bool edges = true;
    bool grid = true;
    bool openEdges = true;
    bool forces = true;                ///< arrows and numbers on tools
    std::set<std::size_t> hiddenParts; ///< by index into Model::parts

    friend bool operator==(const SceneOptions&, const SceneOptions&) = default;
};

/// Whether no more than the section plane or the divider has moved.
bool isOnlyCutElsewhere(const SceneOptions& before, const SceneOptions& after);

/// What is set apart by color.
struct SceneMarks {
    struct Face {
        BodyId body = 0;
        std::uint32_t face = 0;
        friend bool operator==(const Face&, const Face&) = default;
    };
    std::optional<Face> highlighted;
    std::vector<Face> fixed;
    bool isFixing = false; ///< faces are being fixed: those that are stand out from numbers, too
    std::optional<BodyId> selectedBody;
    std::optional<ToolId> selectedTool;
    std::optional<ToolId> hoveredTool;
    Region selected; ///< a single part of a document with only one is not shown as selected
    Region hovered;
};

/// What a view shows and how.
struct SceneLook {
    FilledModel content;
    SceneOptions options;
    SceneMarks marks;
    SceneStyle style;
    Camera camera;
    PartAppearance looks = {};
    std::vector<Material> materials = {}; ///< per body
};

/// A number that belongs beside a place in the scene.
struct SceneLabel {
    Vec3 place = Vec3::Zero(); ///< [m]
    ToolId tool = 0;
    double force = 0;           ///< [N]
    Vec3 middle = Vec3::Zero(); ///< of the tool, which the number is to leave free [m]
};

/// The actors of the scene and how they follow frames. Draws nothing itself: the viewport asks its window to.
class SceneView {
public:
    explicit SceneView(vtkRenderWindow* window);
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    void setModel(const FilledModel& content);
    void showFrame(const FramePointer& frame);
    void setStyle(const SceneStyle& style);
    void setOptions(const SceneOptions& options);
    void setMarks(const SceneMarks& marks);
    /// What was found out about the frame that is shown, or one shortly before. Null: nothing.
    void setSurfaceFields(const SurfaceFieldsPointer& fields);
    void setAppearance(const PartAppearance& looks);
    /// Of bodies: they shine as these do, and parts without a color of their own get one of them. After setModel().
    /// @return whether anything looks otherwise
    bool setMaterials(std::span<const Material> materials);
    void setCamera(const Camera& camera);
    ViewCube& cube();

    /// Box of all that is drawn except the ground [m].
    Box box() const;
    std::optional<ColorScale> scale() const; ///< that the skin is colored by; none: by parts
    std::vector<SceneLabel> labels() const;

private:
    struct Parts;

    void addLights();
    void dress();
    MaterialLook lookOfBody(BodyId body) const;
    void colorBodies();
    void colorSurfaces();
    bool colorByValues(BodyId body);
    bool isGlass() const;
    void tintValues(BodyId body);
    void showRegions();
    void colorRegions();
    void showSelectedRegion();
    void showHoveredRegion();
    void showRegion(const Region& region, RegionActor& within, RegionActor& inFront, double scale);
    Color markOn(const Region& region, const Color& usual, const Color& other) const;
    Color edgesOf(BodyId body, bool isSelected, bool isHovered) const;
    Region shownOf(const Region& region) const;
    void showObjects();
    void takeSurfaces(const FilledBodies& before);
    void showTools();
    void layGrid();
    void layShadow();
    void showBodies();
    void showOpenEdges();
    void clipToScene();

    std::unique_ptr<Parts> m_parts;
    std::shared_ptr<const Model> m_model;
    FilledBodies m_bodies;
    std::vector<std::shared_ptr<const FilledSurface>> m_surfaces;
    Box m_restBox;
    FramePointer m_frame;
    SceneStyle m_style;
    SceneOptions m_options;
    bool m_hasOptions = false; ///< what m_options say was shown of this model
    SceneMarks m_marks;
    SurfaceFieldsPointer m_fields;
    std::optional<ColorScale> m_scale;
    PartAppearance m_appearance;
    std::vector<MaterialLook> m_materialLooks; ///< per body; none are known at first
    PartAppearance m_shown;                    ///< m_appearance, with colors by material where there are no others
    Camera m_camera;
    double m_gridHeight = 0;
    bool m_isShadowNew = true; ///< something that casts it is not as it was
};

/// What has to be found out for options.
SurfaceFieldsRequest requestOf(const SceneOptions& options);

} // namespace knead
