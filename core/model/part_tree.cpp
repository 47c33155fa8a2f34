#include "core/model/part_tree.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace knead {

namespace {

void prune(PartNode& node, const std::vector<std::size_t>& numbers, const std::vector<bool>& keep)
{
    if (node.part && keep[*node.part])
        node.part = numbers[*node.part];
    else
        node.part.reset();
    for (PartNode& child : node.children)
        prune(child, numbers, keep);
    std::erase_if(node.children, [](const PartNode& child) { return !child.part && child.children.empty(); });
}

/// The last child when it is an assembly of that name, else a new one: parts of an assembly follow each other.
PartNode& assemblyIn(PartNode& node, const std::string& name)
{
    if (node.children.empty() || node.children.back().name != name || node.children.back().part)
        node.children.push_back({name, std::nullopt, {}});
    return node.children.back();
}

} // namespace

PartNode prunedTree(const PartNode& tree, const std::vector<bool>& keep)
{
    std::vector<std::size_t> numbers(keep.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < keep.size(); ++i)
        numbers[i] = keep[i] ? next++ : 0;
    PartNode result = tree;
    prune(result, numbers, keep);
    return result;
}

PartNode treeOfPaths(const std::vector<const Part*>& parts)
{
    PartNode root;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = *parts[i];
        PartNode* node = &root;
        PartNode* above = &root;
        if (part.path.size() > part.name.size() && part.path.ends_with("/" + part.name)) {
            const std::string assembly = part.path.substr(0, part.path.size() - part.name.size() - 1);
            for (std::size_t begin = 0; begin <= assembly.size();) {
                const std::size_t end = std::min(assembly.find('/', begin), assembly.size());
                above = node;
                node = &assemblyIn(*node, assembly.substr(begin, end - begin));
                begin = end + 1;
            }
        }
        if (node != &root && !part.bodyOf.empty()) {
            // A second instance of a name begins with a body that the first one has.
            const auto isSame = [&](const PartNode& child) {
                return child.part && parts[*child.part]->bodyOf == part.bodyOf;
            };
            if (std::ranges::any_of(node->children, isSame))
                node = &above->children.emplace_back(PartNode{node->name, std::nullopt, {}});
            node->holdsBodies = true;
        }
        node->children.push_back({part.name, i, {}});
    }
    return root;
}

void takeProducts(const PartNode& from, PartNode& to)
{
    to.product = from.product;
    to.partNumber = from.partNumber;
    std::map<std::string_view, std::vector<const PartNode*>> known;
    for (const PartNode& child : from.children)
        known[child.name].push_back(&child);
    std::map<std::string_view, std::size_t> taken;
    for (PartNode& child : to.children) {
        const std::vector<const PartNode*>& alike = known[child.name];
        if (const std::size_t number = taken[child.name]++; number < alike.size())
            takeProducts(*alike[number], child);
    }
}

std::set<std::size_t> stillHidden(const std::set<std::size_t>& hidden, const Model& before, const Model& now)
{
    std::set<std::size_t> still;
    for (std::size_t p = 0; p < now.parts.size(); ++p) {
        bool isPiece = false;
        bool isOfHidden = false; // several may have the same path
        for (std::size_t part = 0; p >= before.parts.size() && part < before.parts.size(); ++part)
            if (now.parts[p].path.starts_with(before.parts[part].path + '/')) {
                isPiece = true;
                isOfHidden = isOfHidden || hidden.contains(part);
            }
        if (p < before.parts.size() ? hidden.contains(p) : isPiece ? isOfHidden : !now.parts[p].visible)
            still.insert(p);
    }
    return still;
}

std::string formerPath(const Part& part)
{
    if (part.bodyOf.empty())
        return part.path;
    const std::size_t own = part.path.size() - std::min(part.path.size(), part.name.size() + 1);
    const std::size_t product = own == 0 ? std::string::npos : part.path.rfind('/', own - 1);
    return product == std::string::npos ? part.bodyOf : part.path.substr(0, product + 1) + part.bodyOf;
}

} // namespace knead
