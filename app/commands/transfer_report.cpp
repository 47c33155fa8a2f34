#include "app/commands/transfer_report.h"

#include "app/commands/command_output.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

const char* wordFor(const TransferReport::Face& face)
{
    if (!face.after)
        return "not found";
    switch (face.by) {
    case FoundBy::name:
        return "by name";
    case FoundBy::color:
        return "by color";
    case FoundBy::place:
        break;
    }
    return "by place";
}

std::string millimeters(const Vec3& shift)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "(%.3f, %.3f, %.3f) mm", 1000 * shift.x(), 1000 * shift.y(),
                  1000 * shift.z());
    return text.data();
}

} // namespace

void printTransfer(const TransferReport& report)
{
    std::printf("%zu of %zu faces found again\n", report.found(), report.faces.size());
    if (report.scale != 1)
        std::printf("%.4g times as large\n", report.scale);
    std::printf("  face    is face  found      alike\n");
    for (const TransferReport::Face& face : report.faces) {
        std::printf("  %4u", face.before);
        face.after ? std::printf("     %4u", *face.after) : std::printf("        -");
        std::printf("     %-9s", wordFor(face));
        face.after ? std::printf("  %3.0f %%", 100 * face.score) : 0;
        std::printf("  %s\n", face.body.c_str());
    }
    for (const TransferReport::Moved& moved : report.moved)
        std::printf("moved: %s by %s\n", moved.what.english().c_str(), millimeters(moved.shift).c_str());
}

Json jsonOf(const TransferReport& report)
{
    Json json{{"faces_found", report.found()},
              {"scale", report.scale},
              {"faces", Json::array()},
              {"moved", Json::array()},
              {"left_out", Json::array()}};
    for (const TransferReport::Face& face : report.faces) {
        Json row{{"body", face.body}, {"face", face.before}, {"found", wordFor(face)}};
        if (face.after) {
            row["other_body"] = face.bodyAfter;
            row["other_face"] = *face.after;
            row["score"] = face.score;
        }
        json["faces"].push_back(row);
    }
    for (const TransferReport::Moved& moved : report.moved)
        json["moved"].push_back(
            {{"what", moved.what.english()},
             {"shift_mm", {1000 * moved.shift.x(), 1000 * moved.shift.y(), 1000 * moved.shift.z()}}});
    for (const Message& sentence : report.leftOut)
        json["left_out"].push_back(sentence.english());
    return json;
}

} // namespace knead
