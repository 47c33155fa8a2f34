#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// sRGB, each channel 0..1.
struct Color {
    float r = 0.72F;
    float g = 0.74F;
    float b = 0.77F;
    friend bool operator==(const Color&, const Color&) = default;
};

/// One face of the CAD part.
struct PartFace {
    std::optional<Color> color; ///< when it differs from the part's
    std::string name = {};      ///< that a person gave it in another program; several may have the same; else empty
    friend bool operator==(const PartFace&, const PartFace&) = default;
};

/// The boundary representation of a part, for those who write CAD again. Only the io layer understands the bytes.
struct ExactShape {
    std::shared_ptr<const std::string> bytes; ///< of all parts of a file together
    std::uint32_t number = 0;                 ///< among these
    double unit = 1e-3;                       ///< a length of 1 in it [m]
};

/// One part of an imported file: one product instance, placed in the world, or one mesh.
/// Lengths are metres whatever the unit of the file.
struct Part {
    std::string name;
    std::string path;   ///< names from the root to the part, joined by '/'
    std::string bodyOf; ///< the name that it would have as the only body of its product; empty when it is that
    std::optional<Color> color;
    std::vector<PartFace> faces;     ///< empty for a mesh
    TriangleMesh mesh;               ///< tessellation, welded, outward
    std::optional<ExactShape> exact; ///< none for a mesh

    int solids = 0;
    int shells = 0;
    int edges = 0;           ///< distinct edges of the b-rep
    double volume = 0;       ///< [m^3], exact from the b-rep, from the triangles for a mesh; 0 without a solid
    double area = 0;         ///< [m^2]
    Box box;                 ///< exact as far as the b-rep allows [m]
    bool watertight = false; ///< closed shells, no free edge
    bool valid = false;      ///< passes the b-rep checks; for a mesh: watertight with positive volume
    bool insideOut = false;  ///< as its exact shape is: volume and triangles have been turned
    double maxTolerance = 0; ///< largest vertex, edge or face tolerance [m]

    bool visible = true;                      ///< false: hidden in the file, and hidden here until the person shows it
    std::string layer;                        ///< that the file puts it on; empty when there is none
    std::vector<Message> repairs;             ///< what was wrong with the shape and what was done about it, in order
    std::vector<std::vector<Vec3>> openEdges; ///< polylines along which the surface ends [m]; empty for a closed one
    std::vector<Message> warnings;            ///< sentences for the person, also why it cannot be filled

    /// Only a closed part can be filled with objects.
    bool canBeFilled() const { return watertight && !mesh.empty(); }
};

/// A node of the assembly tree: an assembly with children, or a part.
struct PartNode {
    std::string name;
    std::optional<std::size_t> part; ///< index into Model::parts
    std::vector<PartNode> children;
    std::string product = {};    ///< whose instance this is, as the file names that; empty when it has the node's name
    std::string partNumber = {}; ///< of that product; empty when it is the product's name
    bool holdsBodies = false;    ///< its children are the bodies of one product, not parts of an assembly
};

/// A doubt about the length unit of a file, with the unit that would make its size plausible.
struct UnitRemark {
    Message sentence;
    std::string unit; ///< to take instead: "mm", "m", "inch" ...
};

/// What an imported file holds.
struct Model {
    std::string file;   ///< path as given
    std::string format; ///< "STEP AP214", "IGES", "BREP", "STL" ...
    std::string unit;   ///< length unit of the file as a person writes it: "mm", "inch", "m"; empty when unknown
    std::optional<UnitRemark> unitRemark; ///< when the size makes one doubt the unit
    std::vector<Message> warnings;
    std::vector<Message> missing; ///< what the file holds and the model does not, a sentence each
    std::vector<Part> parts;
    PartNode tree; ///< the root; its children are the free shapes of the file
};

/// The surface of a part, which keeps its model alive. @pre there is such a part
inline std::shared_ptr<const TriangleMesh> surfaceOf(const std::shared_ptr<const Model>& model, std::size_t part)
{
    return {model, &model->parts[part].mesh};
}

} // namespace knead
