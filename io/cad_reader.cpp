#include "io/cad_reader.h"

#include "io/cad_document.h"
#include "io/cad_part.h"
#include "io/healing.h"
#include "io/occt_session.h"
#include "io/size_limits.h"

#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <utility>
#include <vector>

namespace knead {

namespace {

struct Leaf {
    const CadNode* node;
    PartNode* place;
    std::string path; ///< ends in the leaf's own name
};

/// Copies the tree without its parts and lists its leaves in order.
void copyTree(const CadNode& from, PartNode& to, const std::string& path, std::vector<Leaf>& leaves)
{
    to.name = from.name;
    if (from.shape)
        leaves.push_back({&from, &to, path});
    to.children.resize(from.children.size());
    for (std::size_t i = 0; i < from.children.size(); ++i)
        copyTree(from.children[i], to.children[i],
                 path.empty() ? from.children[i].name : path + "/" + from.children[i].name, leaves);
}

/// What was left out leaves no node behind.
void removeEmptyNodes(PartNode& node)
{
    for (PartNode& child : node.children)
        removeEmptyNodes(child);
    std::erase_if(node.children, [](const PartNode& child) { return !child.part && child.children.empty(); });
}

std::string numbered(const std::string& name, std::size_t index)
{
    return index == 0 ? name : name + " (" + std::to_string(index + 1) + ")";
}

class PartMaker {
public:
    PartMaker(const CadDocument& document, const ImportOptions& options, TaskControl& control, Model& model)
        : m_document(document)
        , m_options(options)
        , m_control(control)
        , m_model(model)
    {
    }

    void run()
    {
        std::vector<Leaf> leaves;
        copyTree(m_document.root, m_model.tree, {}, leaves);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            m_control.report(static_cast<double>(i) / static_cast<double>(leaves.size()), "measuring parts");
            m_control.throwIfCancelled();
            addLeaf(leaves[i]);
        }
        removeEmptyNodes(m_model.tree);
    }

private:
    /// One body is the leaf itself; several become its children.
    void addLeaf(const Leaf& leaf)
    {
        const std::vector<Body> bodies = bodiesOf(leaf);
        const std::string parentPath = leaf.path.substr(0, leaf.path.size() - leaf.node->name.size());
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            m_control.throwIfCancelled();
            const std::string name = numbered(leaf.node->name, i);
            std::optional<Part> part = soundPart(bodies[i], *leaf.node, name);
            if (!part)
                continue;
            part->name = name;
            part->path = parentPath + name;
            const std::size_t index = m_model.parts.size();
            if (bodies.size() == 1)
                leaf.place->part = index;
            else
                leaf.place->children.push_back({name, index, {}});
            m_model.parts.push_back(std::move(*part));
        }
    }

    std::vector<Body> bodiesOf(const Leaf& leaf)
    {
        std::vector<Body> bodies = splitIntoBodies(*leaf.node->shape);
        if (!m_options.heal)
            return bodies;
        std::vector<Body> result;
        for (const Body& body : bodies)
            for (Body& one : healed(body, m_control))
                result.push_back(std::move(one));
        return result;
    }

    void warnOfLostFaces(const Body& body, Part& part) const
    {
        for (TopExp_Explorer shells(body.original, TopAbs_SHELL); shells.More(); shells.Next())
            for (const IncompleteShell& shell : m_document.incompleteShells)
                if (shells.Current().IsPartner(*shell.shape))
                    part.warnings.push_back("is incomplete: " + std::to_string(shell.read) + " of " +
                                            std::to_string(shell.named) +
                                            " faces of a shell could be read; the others are damaged in the file.");
    }

    /// One sick part does not take the others with it: it is left out, and the model says so.
    std::optional<Part> soundPart(const Body& body, const CadNode& node, const std::string& name)
    {
        try {
            Part part = makePart(body, node.color, m_document.colors, m_options);
            warnOfLostFaces(body, part);
            const std::optional<std::string> sickness = sicknessOf(part);
            if (!sickness)
                return part;
            m_model.missing.push_back(leftOut(name, *sickness));
        } catch (const Standard_Failure& failure) {
            m_model.missing.push_back(
                leftOut(name, "it could not be measured (" + std::string(failure.DynamicType()->Name()) + ")"));
        }
        return std::nullopt;
    }

    const CadDocument& m_document;
    const ImportOptions& m_options;
    TaskControl& m_control;
    Model& m_model;
};

} // namespace

Model readCad(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control)
{
    const OcctSession session;
    Model model;
    guardOcct(path, [&] {
        TaskPortion reading(control, 0, 0.5);
        CadDocument document = readCadDocument(path, kind, reading);
        model.format = document.format;
        model.unit = document.unit;
        model.warnings = document.warnings;
        model.missing = document.missing;
        TaskPortion measuring(control, 0.5, 1);
        PartMaker(document, options, measuring, model).run();
    });
    checkAnyPart(path, model);
    return model;
}

} // namespace knead
