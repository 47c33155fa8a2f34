#pragma once

#include "core/message/message.h"
#include "core/model/part.h"
#include "core/task/task_control.h"
#include "io/formats/cad_format.h"

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

class TopoDS_Shape;

namespace knead {

constexpr int mostParts = 100'000; ///< of an assembly; no program could show more

/// A node of the assembly as the file has it: an assembly with children, or a leaf with a shape.
struct CadNode {
    std::string name;           ///< never empty
    std::string product;        ///< as PartNode::product
    std::string partNumber;     ///< as PartNode::partNumber
    std::optional<Color> color; ///< of the instance, its product, or what it is part of
    bool visible = true;        ///< false: hidden, on a hidden layer, or part of what is
    std::string layer;          ///< of the instance, its product, or what it is part of; several are joined by ", "
    std::vector<CadNode> children;
    std::shared_ptr<const TopoDS_Shape> shape; ///< of a leaf, placed in the world [mm]
};

/// What instances of a shape share.
const void* geometryOf(const TopoDS_Shape& shape);

/// What a file says of single solids, shells and faces, whatever their place and orientation.
template <typename Value>
class ShapeNotes {
public:
    void set(const TopoDS_Shape& shape, Value value) { m_notes.insert_or_assign(geometryOf(shape), std::move(value)); }
    std::optional<Value> find(const TopoDS_Shape& shape) const
    {
        const auto found = m_notes.find(geometryOf(shape));
        return found == m_notes.end() ? std::nullopt : std::optional(found->second);
    }

private:
    std::unordered_map<const void*, Value> m_notes;
};

/// Where a shape is shown.
struct ShapeDisplay {
    bool visible = true;
    std::string layer; ///< empty when there is none
};

using ShapeColors = ShapeNotes<Color>;
using ShapeDisplays = ShapeNotes<ShapeDisplay>;

/// A shell of which the reader could make some faces only.
struct IncompleteShell {
    std::shared_ptr<const TopoDS_Shape> shape;
    int read = 0;  ///< faces
    int named = 0; ///< in the file
};

/// What a CAD file holds, before any measuring.
struct CadDocument {
    std::string format; ///< "STEP AP214"
    std::string unit;   ///< as Model::unit
    std::vector<Message> warnings;
    std::vector<Message> missing; ///< as Model::missing
    Message damage;               ///< that cost parts of it, a sentence; also among the warnings
    std::vector<IncompleteShell> incompleteShells;
    CadNode root;
    ShapeColors colors;
    ShapeDisplays displays;
    ShapeNotes<std::string> names; ///< of solids and faces, where the file names them apart from the assembly
};

/// Reads STEP, IGES or BREP. OpenCASCADE keeps global state: call within an OcctSession.
/// @param onlyShapes see ImportOptions
/// @throws Problem. @throws Cancelled
CadDocument readCadDocument(const std::string& path, FormatKind kind, bool onlyShapes, TaskControl& control);

} // namespace knead
