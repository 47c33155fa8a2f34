#include "app/compensate/round_tables.h"

#include "core/session/csv.h"
#include "io/fields/field_writer.h"

#include <array>
#include <cstdio>

namespace knead {

namespace {

constexpr double perMillimeter = 1000;

std::vector<double> inMillimeters(const std::vector<Vec3>& vectors)
{
    std::vector<double> numbers;
    for (const Vec3& vector : vectors)
        for (const double number : vector)
            numbers.push_back(perMillimeter * number);
    return numbers;
}

} // namespace

std::string tableOf(const TargetPoints& points, const std::vector<CompensationRound>& rounds)
{
    std::string table = "round,factor,largest_mm,mean_mm,x_mm,y_mm,z_mm\n";
    for (const CompensationRound& round : rounds) {
        table += std::to_string(round.number) + "," + csvNumber(round.factor) + "," +
                 csvNumber(perMillimeter * round.largest) + "," + csvNumber(perMillimeter * round.mean);
        for (const double coordinate : points.places[round.worst])
            table += "," + csvNumber(perMillimeter * coordinate);
        table += "\n";
    }
    return table;
}

std::vector<std::string> linesOf(const TargetPoints& points, const std::vector<CompensationRound>& rounds)
{
    std::vector<std::string> lines{"round  factor  largest [mm]  mean [mm]  of the first  largest at x, y, z [mm]"};
    for (const CompensationRound& round : rounds) {
        const Vec3 place = perMillimeter * points.places[round.worst];
        const double share = rounds[0].largest > 0 ? 100 * round.largest / rounds[0].largest : 0;
        std::array<char, 160> line{};
        std::snprintf(line.data(), line.size(), "%5d  %6.3g  %12.5f  %9.5f  %10.2f %%  %.1f, %.1f, %.1f", round.number,
                      round.factor, perMillimeter * round.largest, perMillimeter * round.mean, share, place.x(),
                      place.y(), place.z());
        lines.emplace_back(line.data());
    }
    return lines;
}

void writeDeviations(const std::string& path, const TargetPoints& points, const CompensationRound& round)
{
    NodalFields fields{.nodes = points.places,
                       .unit = "mm",
                       .arrays = {{"deviation [mm]", 3, inMillimeters(round.deviations)},
                                  {"compensation [mm]", 3, inMillimeters(round.compensation)},
                                  {"counts", 1, {points.counts.begin(), points.counts.end()}}}};
    writeFields(path, fields);
}

} // namespace knead
