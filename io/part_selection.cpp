#include "io/part_selection.h"

#include "io/cad_format.h"
#include "io/size_limits.h"

#include <algorithm>

namespace knead {

namespace {

bool isWithin(const std::string& path, const std::string& assembly)
{
    return path == assembly ||
           (path.size() > assembly.size() && path.starts_with(assembly) && path[assembly.size()] == '/');
}

} // namespace

PartSelection::PartSelection(const std::vector<std::string>& wanted)
{
    for (const std::string& path : wanted)
        m_wishes.push_back({path, false});
}

bool PartSelection::wants(const std::string& assembly, const std::string& name)
{
    const std::string path = assembly.empty() ? name : assembly + "/" + name;
    bool wanted = m_wishes.empty();
    for (Wish& wish : m_wishes)
        if (path == wish.path || (!assembly.empty() && isWithin(assembly, wish.path))) {
            wish.found = true;
            wanted = true;
        }
    return wanted;
}

bool PartSelection::mayWant(const std::string& assembly, const std::string& leaf) const
{
    const std::string path = assembly.empty() ? leaf : assembly + "/" + leaf;
    return m_wishes.empty() || std::any_of(m_wishes.begin(), m_wishes.end(), [&](const Wish& wish) {
               return isWithin(path, wish.path) || isWithin(wish.path, path) || wish.path.starts_with(path + " (");
           });
}

void PartSelection::finish(const std::string& file, Model& model) const
{
    for (const Wish& wish : m_wishes)
        if (!wish.found)
            failReading(file, "there is no part or assembly \"" + wish.path +
                                  "\" in it; knead info --json lists the paths of all parts.");
    if (!m_wishes.empty())
        removeEmptyNodes(model.tree);
}

} // namespace knead
