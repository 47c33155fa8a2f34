#include "io/formats/cad_reader.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/brep/body_check.h"
#include "io/brep/exact_shapes.h"
#include "io/brep/healing.h"
#include "io/brep/occt_session.h"
#include "io/document/cad_document.h"
#include "io/document/cad_part.h"
#include "io/document/part_selection.h"
#include "io/document/size_limits.h"
#include "io/formats/step/step_references.h"

#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace knead {

namespace {

struct Leaf {
    const CadNode* node;
    std::vector<CadBody> bodies; ///< of the leaf, when it is wanted
    PartNode* place;
    std::string assembly; ///< path of what the leaf is in; empty for the file
};

std::string pathOf(const std::string& assembly, const std::string& name)
{
    return assembly.empty() ? name : assembly + "/" + name;
}

/// Copies the tree without its parts and lists its leaves in order.
/// @param path of `from`, empty for the file
void copyTree(const CadNode& from, PartNode& to, const std::string& path, std::vector<Leaf>& leaves)
{
    to.name = from.name;
    to.product = from.product;
    to.partNumber = from.partNumber;
    to.children.resize(from.children.size());
    for (std::size_t i = 0; i < from.children.size(); ++i) {
        const CadNode& child = from.children[i];
        if (child.shape)
            leaves.push_back({&child, {}, &to.children[i], path});
        copyTree(child, to.children[i], pathOf(path, child.name), leaves);
    }
}

std::string numbered(const std::string& name, std::size_t index)
{
    return index == 0 ? name : name + " (" + std::to_string(index + 1) + ")";
}

TaskPortion portionOf(TaskControl& control, std::size_t index, std::size_t count)
{
    const auto total = static_cast<double>(count);
    return {control, static_cast<double>(index) / total, static_cast<double>(index + 1) / total};
}

class PartMaker {
public:
    PartMaker(const std::string& path, const CadDocument& document, const ImportOptions& options, TaskControl& control,
              Model& model)
        : m_path(path)
        , m_document(document)
        , m_options(options)
        , m_control(control)
        , m_model(model)
        , m_selection(options.parts)
    {
    }

    void run()
    {
        std::vector<Leaf> leaves;
        copyTree(m_document.root, m_model.tree, {}, leaves);
        splitLeaves(leaves);
        TaskPortion checking(m_control, 0, 0.2);
        checkSolids(leaves, checking);
        TaskPortion making(m_control, 0.2, 1);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            m_control.throwIfCancelled();
            TaskPortion ofLeaf = portionOf(making, i, leaves.size());
            if (!leaves[i].bodies.empty())
                addLeaf(leaves[i], ofLeaf);
        }
        m_control.report(1, "keeping the exact shapes");
        keepExactShapes();
        m_selection.finish(m_path, m_model);
        removeEmptyNodes(m_model.tree);
    }

private:
    void keepExactShapes()
    {
        const auto bytes = std::make_shared<const std::string>(shapesToBytes(m_shapes));
        for (Part& part : m_model.parts)
            part.exact->bytes = bytes;
    }

    void splitLeaves(std::vector<Leaf>& leaves)
    {
        for (Leaf& leaf : leaves)
            if (m_selection.mayWant(leaf.assembly, leaf.node->name))
                leaf.bodies = splitByVisibility(splitIntoBodies(*leaf.node->shape));
    }

    /// What is no solid changes before it is checked.
    static void checkSolids(std::vector<Leaf>& leaves, TaskControl& control)
    {
        std::vector<CadBody*> solids;
        for (Leaf& leaf : leaves)
            for (CadBody& body : leaf.bodies)
                if (body.shape.ShapeType() == TopAbs_SOLID)
                    solids.push_back(&body);
        checkBodies(solids, control);
    }

    /// Bodies of a product that have names of their own go by these. In IGES products have none.
    std::vector<std::string> namesOf(const std::vector<CadBody>& bodies, const CadNode& leaf) const
    {
        const bool takesOwn = bodies.size() > 1 || m_document.format == "IGES";
        std::vector<std::string> names;
        std::map<std::string, std::size_t> uses;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const std::optional<std::string> own = takesOwn ? m_document.names.find(bodies[i].original) : std::nullopt;
            names.push_back(own ? numbered(*own, uses[*own]++) : numbered(leaf.name, i));
        }
        return names;
    }

    /// One body is the leaf itself; several become its children.
    void addLeaf(const Leaf& leaf, TaskControl& control)
    {
        TaskPortion healing(control, 0, 0.4);
        TaskPortion measuring(control, 0.4, 1);
        const std::vector<CadBody> bodies = bodiesOf(leaf, healing);
        const std::vector<std::string> names = namesOf(bodies, *leaf.node);
        const std::string& leafName = leaf.node->name;
        const bool isWhole = m_selection.wants(leaf.assembly, leafName);
        const std::string assembly = bodies.size() == 1 ? leaf.assembly : pathOf(leaf.assembly, leafName);
        leaf.place->holdsBodies = bodies.size() > 1;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            control.throwIfCancelled();
            const std::string& name = names[i];
            const bool isWanted = m_selection.wants(assembly, name);
            const bool isWantedByFormerName = m_selection.wants(leaf.assembly, numbered(leafName, i));
            if (!isWhole && !isWanted && !isWantedByFormerName)
                continue;
            TaskPortion ofBody = portionOf(measuring, i, bodies.size());
            std::optional<Part> part = soundPart(bodies[i], *leaf.node, name, ofBody);
            if (!part)
                continue;
            part->name = name;
            part->path = pathOf(assembly, name);
            if (bodies.size() > 1)
                part->bodyOf = numbered(leafName, i);
            takeDisplay(bodies[i].original, *leaf.node, *part);
            part->exact = ExactShape{nullptr, static_cast<std::uint32_t>(m_shapes.size())};
            m_shapes.push_back(bodies[i].shape);
            const std::size_t index = m_model.parts.size();
            if (bodies.size() == 1)
                leaf.place->part = index;
            else
                leaf.place->children.push_back({name, index, {}});
            m_model.parts.push_back(std::move(*part));
        }
    }

    /// Surfaces of a body that are hidden are no part of what is shown, they become a body of their own.
    std::vector<CadBody> splitByVisibility(const std::vector<CadBody>& bodies) const
    {
        std::vector<CadBody> result;
        for (const CadBody& body : bodies) {
            if (body.shape.ShapeType() != TopAbs_COMPOUND) {
                result.push_back(body);
                continue;
            }
            for (const bool visible : {true, false}) {
                TopoDS_Compound surfaces;
                const BRep_Builder builder;
                builder.MakeCompound(surfaces);
                for (TopoDS_Iterator parts(body.shape); parts.More(); parts.Next())
                    if (displayOf(parts.Value()).visible == visible)
                        builder.Add(surfaces, parts.Value());
                if (surfaces.NbChildren() > 0)
                    result.push_back({.shape = surfaces, .original = surfaces});
            }
        }
        return result;
    }

    /// What is said of the body itself, of the surfaces it consists of, or else of the leaf.
    void takeDisplay(const TopoDS_Shape& body, const CadNode& leaf, Part& part) const
    {
        const ShapeDisplay own = displayOf(body);
        part.visible = leaf.visible && own.visible;
        part.layer = own.layer.empty() ? leaf.layer : own.layer;
    }

    ShapeDisplay displayOf(const TopoDS_Shape& body) const
    {
        if (const auto own = m_document.displays.find(body); own || body.ShapeType() != TopAbs_COMPOUND)
            return own.value_or(ShapeDisplay{});
        ShapeDisplay common{false, {}}; // hidden when all of it is
        for (TopoDS_Iterator surfaces(body); surfaces.More(); surfaces.Next()) {
            const ShapeDisplay one = displayOf(surfaces.Value());
            common.visible = common.visible || one.visible;
            if (common.layer.empty())
                common.layer = one.layer;
        }
        return common;
    }

    std::vector<CadBody> bodiesOf(const Leaf& leaf, TaskControl& control)
    {
        const std::vector<CadBody>& bodies = leaf.bodies;
        if (!m_options.heal)
            return bodies;
        std::vector<CadBody> result;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            TaskPortion ofBody = portionOf(control, i, bodies.size());
            for (CadBody& one : healed(bodies[i], m_options.capsFlatOpenings, ofBody))
                result.push_back(std::move(one));
        }
        return result;
    }

    void warnOfLostFaces(const CadBody& body, Part& part) const
    {
        for (TopExp_Explorer shells(body.original, TopAbs_SHELL); shells.More(); shells.Next())
            for (const IncompleteShell& shell : m_document.incompleteShells)
                if (shells.Current().IsPartner(*shell.shape))
                    part.warnings.push_back(Message("Import", "is incomplete: %1 of %2 faces of a shell could be read; "
                                                              "the others are damaged in the file.")
                                                .with(shell.read, shell.named));
    }

    /// One sick part does not take the others with it: it is left out, and the model says so.
    std::optional<Part> soundPart(const CadBody& body, const CadNode& node, const std::string& name,
                                  TaskControl& control)
    {
        try {
            Part part = makePart(body, node, m_document, m_options, control);
            warnOfLostFaces(body, part);
            const std::optional<Message> sickness = sicknessOf(part);
            if (!sickness)
                return part;
            m_model.missing.push_back(leftOut(name, *sickness));
        } catch (const Standard_Failure& failure) {
            m_model.missing.push_back(
                leftOut(name, Message("Import", "it could not be measured (%1)").with(failure.DynamicType()->Name())));
        }
        return std::nullopt;
    }

    const std::string& m_path;
    const CadDocument& m_document;
    const ImportOptions& m_options;
    TaskControl& m_control;
    Model& m_model;
    PartSelection m_selection;
    std::vector<TopoDS_Shape> m_shapes; // of the parts
};

/// The same wishes when the lengths of the document will be taken in another unit afterwards.
ImportOptions inUnitOf(const CadDocument& document, ImportOptions options)
{
    const LengthUnit* stated = findLengthUnit(document.unit.empty() ? "mm" : document.unit);
    const LengthUnit* wanted = findLengthUnit(options.unit);
    if (stated != nullptr && wanted != nullptr)
        options.linearDeflection *= stated->metres / wanted->metres;
    return options;
}

} // namespace

Model readCad(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control)
{
    const OcctSession session;
    Model model;
    Message damage;
    guardOcct(path, [&] {
        TaskPortion reading(control, 0, 0.5);
        CadDocument document = readCadDocument(path, kind, options.onlyShapes, reading);
        model.format = document.format;
        model.unit = document.unit;
        model.warnings = document.warnings;
        model.missing = document.missing;
        damage = document.damage;
        TaskPortion measuring(control, 0.5, 1);
        PartMaker(path, document, inUnitOf(document, options), measuring, model).run();
    });
    if (model.parts.empty() && !damage.empty())
        failReading(path, damage);
    if (kind == FormatKind::Step && model.parts.empty() && model.missing.empty())
        if (const Message other = otherContent(path); !other.empty())
            failReading(path, other);
    checkAnyPart(path, model);
    return model;
}

} // namespace knead
