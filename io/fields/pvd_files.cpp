#include "io/fields/pvd_files.h"

#include "core/model/readable_name.h"
#include "io/fields/xml_scanner.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace knead {

std::vector<PvdFile> filesOfCollection(std::string_view bytes, const std::string& path)
{
    std::vector<PvdFile> files;
    XmlScanner xml(bytes);
    while (const auto tag = xml.next())
        if (tag->name == "DataSet" && !tag->isEnd)
            files.push_back({readableName(tag->attribute("timestep")),
                             (std::filesystem::path(path).parent_path() / tag->attribute("file")).string()});
    if (files.empty())
        throw Problem(Message("Field", "the collection names no files."));
    return files;
}

std::vector<PvdFile> filesAtStep(const std::vector<PvdFile>& files, const FieldChoice& choice, FieldContent& content)
{
    for (const PvdFile& file : files)
        if (content.steps.empty() || content.steps.back() != file.time)
            content.steps.push_back(file.time);
    content.step = chosenStep(choice, content.steps.size());
    std::vector<PvdFile> chosen;
    std::size_t step = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (i > 0 && files[i].time != files[i - 1].time)
            ++step;
        if (step == content.step)
            chosen.push_back(files[i]);
    }
    return chosen;
}

void append(FieldContent& content, FieldContent&& more)
{
    const auto first = static_cast<std::int64_t>(content.nodes.size());
    if (content.nodes.empty()) {
        std::swap(more.steps, content.steps);
        std::swap(more.step, content.step);
        content = std::move(more);
        return;
    }
    content.nodes.insert(content.nodes.end(), more.nodes.begin(), more.nodes.end());
    content.values.insert(content.values.end(), more.values.begin(), more.values.end());
    content.cells.labels.clear(); // each file counts from the start
    content.cells.points.clear();
    const auto firstPlace = static_cast<std::int64_t>(content.cells.connectivity.size());
    for (const std::int64_t node : more.cells.connectivity)
        content.cells.connectivity.push_back(first + node);
    if (content.cells.offsets.empty())
        content.cells.offsets = std::move(more.cells.offsets);
    else
        for (std::size_t i = 1; i < more.cells.offsets.size(); ++i)
            content.cells.offsets.push_back(firstPlace + more.cells.offsets[i]);
    content.cells.types.insert(content.cells.types.end(), more.cells.types.begin(), more.cells.types.end());
    content.warnings.insert(content.warnings.end(), more.warnings.begin(), more.warnings.end());
}

} // namespace knead
