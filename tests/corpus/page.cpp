#include "corpus/page.h"

#include "support/html.h"

#include <array>
#include <cstdio>

namespace knead::corpus {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array columns{"file",
                             "verdict",
                             "parts",
                             "closed",
                             "info_s",
                             "run_s",
                             "moved_share",
                             "bodies",
                             "smooth",
                             "sound",
                             "off_mm",
                             "allowed_mm",
                             "kb_per_face",
                             "check_valid",
                             "check_free_edges",
                             "check_volume_error",
                             "check_tolerance_mm",
                             "stl_to_step_mm",
                             "step_to_stl_mm",
                             "said"};

std::string textOf(const Json& file, const char* key)
{
    const auto found = file.find(key);
    if (found == file.end())
        return "";
    if (found->is_string())
        return found->get<std::string>();
    if (found->is_number_float()) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", found->get<double>());
        return text;
    }
    return found->dump();
}

} // namespace

std::string tableOf(const std::vector<Json>& files)
{
    std::string table;
    for (const char* column : columns)
        table += std::string(table.empty() ? "" : "\t") + column;
    table += '\n';
    for (const Json& file : files) {
        for (const char* column : columns)
            table += (column == columns.front() ? "" : "\t") + textOf(file, column);
        table += '\n';
    }
    return table;
}

std::string pageOf(const std::vector<Json>& files)
{
    std::string page =
        "<!DOCTYPE html><html><head><meta charset='utf-8'><title>Corpus</title><style>"
        "body{font:14px sans-serif;margin:24px}table{border-collapse:collapse}td,th{border-bottom:1px solid "
        "#ccc;padding:4px 8px;text-align:left;vertical-align:top}img{width:240px}.fault td{background:#fee}"
        "</style></head><body><h1>Corpus</h1><table><tr><th>before</th><th>after</th><th>what came</th></tr>";
    for (const Json& file : files) {
        const std::string name = textOf(file, "file");
        const bool isGood = textOf(file, "verdict") == "good";
        page += std::string("<tr class='") + (isGood ? "good" : "fault") + "'>";
        for (const char* picture : {"before", "after"})
            page += "<td><img loading='lazy' src='" + escaped(name) + "/" + picture + ".png'></td>";
        page += "<td><b>" + escaped(name) + "</b><br>";
        for (const char* column : columns)
            if (const std::string text = textOf(file, column); !text.empty() && column != columns.front())
                page += std::string(column) + ": " + escaped(text) + "<br>";
        page += "</td></tr>\n";
    }
    return page + "</table></body></html>\n";
}

} // namespace knead::corpus
