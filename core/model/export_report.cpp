#include "core/model/export_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace knead {

namespace {

std::string number(const char* format, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string change(const char* what, int before, int after)
{
    const std::string now = std::to_string(after) + " " + what + (after == 1 ? "" : "s");
    return before == after ? now : now + " (" + std::to_string(before) + " before)";
}

std::string millimetres(double metres)
{
    return number("%.3g mm", 1e3 * metres);
}

std::string volumeLine(const PartExportReport& part)
{
    std::string line = "volume " + number("%.6g cm³", 1e6 * part.volume) + ", of the skin " +
                       number("%.6g cm³", 1e6 * part.skinVolume) + " (" + number("%+.2g %%", 100 * part.volumeError()) +
                       "), at rest " + number("%.6g cm³", 1e6 * part.restVolume);
    if (part.density > 0)
        line += "; mass " + number("%.5g g", 1e3 * part.density * part.volume) + ", at rest " +
                number("%.5g g", 1e3 * part.density * part.restVolume);
    return line;
}

void addLines(const PartExportReport& part, std::vector<std::string>& lines)
{
    const char* form = part.form == PartExportReport::Form::exact     ? "smooth faces"
                       : part.form == PartExportReport::Form::faceted ? "flat triangles"
                                                                      : "a mesh";
    lines.push_back(part.name + ": " + form + ", " + (part.isSound() ? "sound" : "NOT SOUND"));
    if (!part.reason.empty())
        lines.push_back("  not as smooth faces: " + part.reason.english());
    lines.push_back("  " + change("solid", part.solidsBefore, part.solidsAfter) + ", " +
                    change("face", part.facesBefore, part.facesAfter) + ", " +
                    change("edge", part.edgesBefore, part.edgesAfter) +
                    (part.keptFaces > 0 ? "; " + std::to_string(part.keptFaces) + " faces exactly as they were" : ""));
    lines.push_back(std::string("  ") +
                    (part.closed      ? "closed"
                     : part.wasClosed ? "OPEN"
                                      : "open, as it was") +
                    ", " + (part.valid ? "passes the geometry checks" : "DOES NOT PASS the geometry checks") + ", " +
                    std::to_string(part.freeEdges) + " free edges, largest tolerance " +
                    millimetres(part.maxTolerance));
    if (part.samples > 0)
        lines.push_back("  distance to the skin at " + std::to_string(part.samples) +
                        " places: " + millimetres(part.largestDeviation) + " at most, " +
                        millimetres(part.meanDeviation) + " in the mean, " + millimetres(part.tolerance) + " allowed");
    if (part.flatFaces > 0)
        lines.push_back("  " + std::to_string(part.flatFaces) + (part.flatFaces == 1 ? " face is" : " faces are") +
                        " made of flat triangles, " + millimetres(part.largestFlatDeviation) +
                        " off the skin at most, " + millimetres(part.flatTolerance) + " allowed");
    if (part.smoothEdges > 0)
        lines.push_back("  normals across " + std::to_string(part.smoothEdges) + " smooth edges agree within " +
                        number("%.2g°", part.largestKink * 180 / std::numbers::pi));
    lines.push_back("  " + volumeLine(part));
    for (const Message& remark : part.remarks)
        lines.push_back("  " + remark.english());
    if (!part.nameKept)
        lines.emplace_back("  its name was not found again");
    if (!part.colorsKept)
        lines.emplace_back("  not all of its colors were found again");
}

} // namespace

double PartExportReport::volumeError() const
{
    return skinVolume > 0 ? volume / skinVolume - 1 : 0;
}

double PartExportReport::volumeChange() const
{
    const double before = restVolumeOfMesh > 0 ? restVolumeOfMesh : restVolume;
    return before > 0 ? volume / before - 1 : 0;
}

bool PartExportReport::isSound() const
{
    return isFit() && !crossesItself && largestKink <= largestKinkOfSoundParts;
}

bool PartExportReport::isFit() const
{
    return valid && ((closed && freeEdges == 0) || !wasClosed) && std::abs(volumeError()) <= largestVolumeError &&
           largestDeviation <= tolerance && largestFlatDeviation <= flatTolerance;
}

bool ExportReport::isSound() const
{
    return std::ranges::all_of(parts, [](const PartExportReport& part) { return part.isSound(); });
}

std::vector<std::string> linesOf(const ExportReport& report)
{
    std::vector<std::string> lines{
        report.file + ": " + report.format + (report.unit.empty() ? "" : ", " + report.unit) + ", " +
        number("%.3g MB", 1e-6 * static_cast<double>(report.bytes)) + ", " + number("%.2g s", report.seconds)};
    for (const PartExportReport& part : report.parts)
        addLines(part, lines);
    for (const Message& warning : report.warnings)
        lines.push_back(warning.english());
    return lines;
}

} // namespace knead
