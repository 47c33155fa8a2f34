#include "core/model/joined_model.h"

#include "core/message/message.h"
#include "core/model/part_tree.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace knead {

namespace {

template <class Element>
void append(std::vector<Element>& from, std::vector<Element>& to)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// A text that all models share, or none.
std::string common(const std::vector<Model>& models, std::string Model::*text)
{
    const auto agrees = [&](const Model& model) { return model.*text == models.front().*text; };
    return std::ranges::all_of(models, agrees) ? models.front().*text : std::string();
}

} // namespace

Message doubtOfOneAmongOthers(const UnitRemark& remark)
{
    return Message::sequence({remark.sentence, Message("Unit", "Open that file alone to correct it.")});
}

void shiftNumbers(PartNode& node, std::size_t by)
{
    if (node.part)
        *node.part += by;
    for (PartNode& child : node.children)
        shiftNumbers(child, by);
}

Model joined(std::vector<Model> models)
{
    assert(!models.empty());
    if (models.size() == 1)
        return std::move(models.front());
    Model all;
    all.file = models.front().file;
    all.format = common(models, &Model::format);
    all.unit = common(models, &Model::unit);
    all.tree.name = models.front().tree.name + " and " + std::to_string(models.size() - 1) + " more";
    for (Model& model : models) {
        for (Part& part : model.parts)
            part.path = model.tree.name + "/" + part.path;
        shiftNumbers(model.tree, all.parts.size());
        append(model.parts, all.parts);
        append(model.warnings, all.warnings);
        append(model.missing, all.missing);
        if (model.unitRemark)
            all.warnings.push_back(doubtOfOneAmongOthers(*model.unitRemark));
        all.tree.children.push_back(std::move(model.tree));
    }
    return all;
}

Model withParts(Model model, std::vector<Part> parts)
{
    model.parts = std::move(parts);
    std::vector<const Part*> all;
    for (const Part& part : model.parts)
        all.push_back(&part);
    PartNode tree = treeOfPaths(all);
    takeProducts(model.tree, tree);
    model.tree = std::move(tree);
    return model;
}

} // namespace knead
