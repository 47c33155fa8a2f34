#include "io/document/part_selection.h"

#include "core/message/message.h"
#include "io/document/size_limits.h"
#include "io/formats/cad_format.h"

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
        m_requests.push_back({path, false});
}

bool PartSelection::wants(const std::string& assembly, const std::string& name)
{
    const std::string path = assembly.empty() ? name : assembly + "/" + name;
    bool wanted = m_requests.empty();
    for (Request& request : m_requests)
        if (path == request.path || (!assembly.empty() && isWithin(assembly, request.path))) {
            request.found = true;
            wanted = true;
        }
    return wanted;
}

bool PartSelection::mayWant(const std::string& assembly, const std::string& leaf) const
{
    const std::string path = assembly.empty() ? leaf : assembly + "/" + leaf;
    return m_requests.empty() || std::any_of(m_requests.begin(), m_requests.end(), [&](const Request& request) {
               return isWithin(path, request.path) || isWithin(request.path, path) ||
                      request.path.starts_with(path + " (");
           });
}

void PartSelection::finish(const std::string& file, Model& model) const
{
    for (const Request& request : m_requests)
        if (!request.found)
            failReading(
                file,
                Message("Import",
                        "there is no part or assembly \"%1\" in it; knead info --json lists the paths of all parts.")
                    .with(request.path));
    if (!m_requests.empty())
        removeEmptyNodes(model.tree);
}

} // namespace knead
