#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace knead {

/// What the program says of the CAD file that it wrote, over all its parts, as fields of a row of a table.
/// @param report one of "exports" that `knead run --json` prints
inline nlohmann::ordered_json exportSummary(const nlohmann::ordered_json& report)
{
    int smooth = 0;
    int sound = 0;
    int facesBefore = 0;
    int facesAfter = 0;
    int flat = 0;
    double inFile = 0;
    double ofSkin = 0;
    double off = 0;
    double allowed = 0;
    std::string said;
    for (const auto& part : report.at("parts")) {
        smooth += part.at("form") == "smooth faces" ? 1 : 0;
        sound += part.at("sound").get<bool>() ? 1 : 0;
        facesBefore += part.at("faces").at("before").get<int>();
        facesAfter += part.at("faces").at("after").get<int>();
        flat += part.at("flat_faces").at("count").get<int>();
        inFile += part.at("volume_m3").at("file").get<double>();
        ofSkin += part.at("volume_m3").at("skin").get<double>();
        off = std::max(off, 1e3 * part.at("deviation_m").at("largest").get<double>());
        allowed = std::max(allowed, 1e3 * part.at("deviation_m").at("allowed").get<double>());
        for (const auto& remark : part.at("remarks"))
            said += remark.get<std::string>() + " ";
    }
    nlohmann::ordered_json row;
    row["bodies"] = report.at("parts").size();
    row["faces_before"] = facesBefore;
    row["faces_after"] = facesAfter;
    row["smooth"] = smooth;
    row["sound"] = sound;
    row["flat_faces"] = flat;
    row["volume_error"] = ofSkin > 0 ? inFile / ofSkin - 1 : 1;
    row["off_mm"] = off;
    row["allowed_mm"] = allowed;
    row["kb_per_face"] = 1e-3 * report.at("bytes").get<double>() / std::max(1, facesAfter);
    row["said"] = said;
    return row;
}

} // namespace knead
