#include "core/model/part_tree.h"

#include <algorithm>

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
        if (part.path.size() > part.name.size() && part.path.ends_with("/" + part.name)) {
            const std::string assembly = part.path.substr(0, part.path.size() - part.name.size() - 1);
            for (std::size_t begin = 0; begin <= assembly.size();) {
                const std::size_t end = std::min(assembly.find('/', begin), assembly.size());
                node = &assemblyIn(*node, assembly.substr(begin, end - begin));
                begin = end + 1;
            }
        }
        node->children.push_back({part.name, i, {}});
    }
    return root;
}

} // namespace knead
