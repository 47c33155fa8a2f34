#include "core/aggregate/spacing_choice.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/wall_thickness.h"
#include "core/message/number_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Measured at a million objects: 487 bytes in the aggregate and the simulation, 48 in a snapshot.
constexpr double bytesPerObject = 535;

/// @param fineness one over the spacing [1/m]
double objectsAt(const FillingSize& size, double fineness)
{
    constexpr double layer = 1;
    return fineness * fineness * (fineness * size.volume + layer * size.area);
}

double spacingForObjects(const FillingSize& size, double objects)
{
    double few = 0; // of 1 / spacing
    double many = std::cbrt(objects / size.volume);
    for (int i = 0; i < 60; ++i) {
        const double middle = (few + many) / 2;
        (objectsAt(size, middle) < objects ? few : many) = middle;
    }
    return 1 / many;
}

/// With two digits, as nothing here is known better.
std::string rounded(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return inDigits(std::round(value / unit) * unit);
}

std::string inMillimetres(double length)
{
    return rounded(length * 1000) + " mm";
}

/// "2 million"
Message readableCount(double count)
{
    constexpr double roundedUp = 0.995; // with two digits, what is above this is the next unit
    if (count >= roundedUp * 1e9)
        return Message("Number", "%1 billion").with(rounded(count / 1e9));
    if (count >= roundedUp * 1e6)
        return Message("Number", "%1 million").with(rounded(count / 1e6));
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 1));
    std::string digits = std::to_string(static_cast<long>(std::round(count / unit) * unit));
    if (digits.size() > 3)
        digits.insert(digits.size() - 3, 1, ',');
    return Message::verbatim(digits);
}

/// With two digits, and no more than the value.
double roundedDown(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit * (1 + 1e-9)) * unit;
}

Message thinWallSentence(double cells, const FillingSize& size, double better)
{
    const std::string across = rounded(cells);
    const std::string wall = inMillimetres(size.thinnestWall);
    const std::string spacing = inMillimetres(better);
    const std::string advised = inDigits(advisedCellsAcrossWall);
    const Message objects = readableCount(estimatedObjects(size, better));
    const double error = bendingErrorOf(cells);
    if (!std::isfinite(error))
        return Message("Filling", "Thinnest walls: %1 cells across %2; bending of such walls comes out many times too "
                                  "stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.")
            .with(across, wall, spacing, advised, objects);
    return Message("Filling",
                   "Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. "
                   "Fill with a spacing of %4 for %5 cells, about %6 objects.")
        .with(across, wall, rounded(100 * error), spacing, advised, objects);
}

} // namespace

void FillingSize::add(const FillingSize& other)
{
    volume += other.volume;
    area += other.area;
    box.extend(other.box);
    if (thinnestWall == 0 || (other.thinnestWall > 0 && other.thinnestWall < thinnestWall))
        thinnestWall = other.thinnestWall;
}

FillingSize sizeOf(const TriangleMesh& mesh)
{
    const MassProperties properties = massProperties(mesh);
    return {.volume = std::abs(properties.volume), .area = properties.area, .box = properties.box};
}

FillingSize sizeWithWalls(const TriangleMesh& mesh, TaskControl& control)
{
    FillingSize size = sizeOf(mesh);
    size.thinnestWall = wallThickness(mesh, control).thinnest;
    return size;
}

double estimatedObjects(const FillingSize& size, double spacing)
{
    return objectsAt(size, 1 / spacing);
}

double spacingFor(const SpacingChoice& choice, const FillingSize& size)
{
    assert(choice.value > 0);
    switch (choice.kind) {
    case SpacingChoice::Kind::CellsAlong:
        return size.box.sizes().maxCoeff() / choice.value;
    case SpacingChoice::Kind::CellsAcrossWall:
        return size.thinnestWall / choice.value;
    case SpacingChoice::Kind::Objects:
        return spacingForObjects(size, choice.value);
    case SpacingChoice::Kind::Length:
        break;
    }
    return choice.value;
}

double bendingErrorOf(double cellsAcross)
{
    constexpr double sound = 0.15;
    constexpr double rough = 0.4;  // from 1.3 cells on
    constexpr double coarse = 0.9; // from one cell on
    constexpr double roughest = 1.3;
    constexpr double rounding = 1 - 1e-6;
    if (cellsAcross >= fewestCellsAcrossWall * rounding)
        return sound;
    if (cellsAcross >= roughest * rounding)
        return rough;
    return cellsAcross >= rounding ? coarse : std::numeric_limits<double>::infinity();
}

SpacingAssessment assessSpacing(double spacing, const FillingSize& size)
{
    SpacingAssessment assessment;
    assessment.cellsAcrossWall = size.thinnestWall / spacing;
    assessment.objects = estimatedObjects(size, spacing);
    assessment.bytes = bytesPerObject * assessment.objects;
    if (size.thinnestWall > 0 && assessment.cellsAcrossWall < fewestCellsAcrossWall * (1 - 1e-6)) {
        assessment.advisedSpacing = roundedDown(size.thinnestWall / advisedCellsAcrossWall);
        assessment.warning = thinWallSentence(assessment.cellsAcrossWall, size, assessment.advisedSpacing);
    }
    return assessment;
}

} // namespace knead
