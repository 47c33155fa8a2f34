#include "core/model/added_model.h"

#include "core/message/message.h"
#include "core/model/joined_model.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

/// Which neither a child of the root has, nor a part whose path is only its name.
std::string freeName(const Model& model, const std::string& wanted)
{
    const auto isTaken = [&model](const std::string& name) {
        return std::ranges::count(model.tree.children, name, &PartNode::name) > 0 ||
               std::ranges::any_of(model.parts, [&name](const Part& part) {
                   return part.path == name || part.path.starts_with(name + "/");
               });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

} // namespace

Model withAdded(Model model, Model added)
{
    added.tree.name = freeName(model, added.tree.name);
    shiftNumbers(added.tree, model.parts.size());
    for (Part& part : added.parts) {
        part.path = added.tree.name + "/" + part.path;
        model.parts.push_back(std::move(part));
    }
    std::ranges::move(added.warnings, std::back_inserter(model.warnings));
    std::ranges::move(added.missing, std::back_inserter(model.missing));
    if (added.unitRemark)
        model.warnings.push_back(doubtOfOneAmongOthers(*added.unitRemark));
    model.tree.children.push_back(std::move(added.tree));
    return model;
}

} // namespace knead
