#include "app/compensate/compensation_folder.h"

#include "app/file_content.h"
#include "io/files/safe_file.h"
#include "io/json/exact_number.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* stateName = "compensation.json";
constexpr const char* roundName = "round.json";
constexpr const char* roundPrefix = "round-";

std::string joined(const std::vector<std::string>& words)
{
    return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string textOfFaces(const FacesOfParts& faces)
{
    return Json(faces).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string textOfChoice(const FieldChoice& choice)
{
    return choice.name + " " + choice.unit + " " + (choice.step ? std::to_string(*choice.step + 1) : "") +
           (choice.isInPlace ? " in place" : "");
}

Json toJson(const std::vector<StudyFact>& facts)
{
    Json list = Json::array();
    for (const StudyFact& fact : facts)
        list.push_back({{fact.isFile ? "file" : "key", fact.name}, {"value", fact.value}});
    return {{"rounds_depend_on", list}};
}

std::vector<StudyFact> factsFrom(const Json& json)
{
    std::vector<StudyFact> facts;
    for (const Json& fact : json.at("rounds_depend_on")) {
        const bool isFile = fact.contains("file");
        facts.push_back({fact.at(isFile ? "file" : "key"), fact.at("value"), isFile});
    }
    return facts;
}

/// Empty when there is none.
std::string differenceOf(const std::vector<StudyFact>& before, const std::vector<StudyFact>& now)
{
    for (const StudyFact& fact : now) {
        const auto same = [&](const StudyFact& other) {
            return other.name == fact.name && other.isFile == fact.isFile && other.value == fact.value;
        };
        if (std::ranges::none_of(before, same))
            return fact.isFile ? fact.name + " has changed since" : "its \"" + fact.name + "\" was another";
    }
    return before.size() == now.size() ? "" : "its files were others";
}

Json numbersOf(const std::vector<Vec3>& vectors)
{
    Json numbers = Json::array();
    for (const Vec3& vector : vectors)
        for (const double number : vector)
            numbers.push_back(number);
    return numbers;
}

std::vector<Vec3> vectorsOf(const Json& numbers)
{
    std::vector<Vec3> vectors;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        vectors.emplace_back(numbers.at(i).get<double>(), numbers.at(i + 1).get<double>(),
                             numbers.at(i + 2).get<double>());
    return vectors;
}

/// None when it is not there, or damaged from outside: then the round is carried out again.
std::optional<CompensationRound> roundIn(const std::string& path, const TargetPoints& points)
{
    const std::optional<std::string> text = textOf(path);
    if (!text)
        return std::nullopt;
    try {
        const Json json = Json::parse(*text);
        CompensationRound round;
        round.number = json.at("round");
        round.factor = json.at("factor");
        round.largest = json.at("largest_m");
        round.mean = json.at("mean_m");
        round.worst = json.at("worst_point");
        round.compensation = vectorsOf(json.at("compensation_m"));
        round.deviations = vectorsOf(json.at("deviations_m"));
        const std::size_t count = points.places.size();
        const bool fits = round.compensation.size() == count && round.deviations.size() == count && round.worst < count;
        return fits ? std::optional(std::move(round)) : std::nullopt;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

} // namespace

std::vector<StudyFact> factsOf(const CompensationStudy& study)
{
    const CompensationMethod& method = study.method;
    std::vector<StudyFact> facts{{"faces", textOfFaces(study.faces)},
                                 {"spacing_mm", exactThousandfold(study.spacing)},
                                 {"factor", exactText(method.factor)},
                                 {"smoothing_mm", exactThousandfold(method.smoothing)},
                                 {"best_fit", method.fitsBest ? "true" : "false"},
                                 {"command", joined(study.command)},
                                 {"field", study.field + " " + textOfChoice(study.choice)},
                                 {"mesh_spacing_mm", exactThousandfold(study.meshSpacing)}};
    std::vector<std::string> files{study.part};
    if (!study.recipe.empty())
        files.push_back(study.recipe);
    files.insert(files.end(), study.files.begin(), study.files.end());
    for (const std::string& file : files)
        facts.push_back({fs::path(file).filename().string(), digestOf(file), true});
    return facts;
}

CompensationFolder::CompensationFolder(const std::string& path)
    : m_path(fs::absolute(path).lexically_normal().string())
{
}

std::string CompensationFolder::pathOf(const std::string& name) const
{
    return (fs::path(m_path) / name).string();
}

std::string CompensationFolder::folderOf(int round) const
{
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%02d", round);
    return pathOf(roundPrefix + std::string(number.data()));
}

void CompensationFolder::checkHasNoOther(const std::vector<StudyFact>& facts) const
{
    const std::optional<std::string> text = textOf(pathOf(stateName));
    if (!text)
        return;
    std::string difference;
    try {
        difference = differenceOf(factsFrom(Json::parse(*text)), facts);
    } catch (const std::exception&) {
        difference = std::string(stateName) + " is damaged";
    }
    if (!difference.empty())
        throw std::runtime_error(m_path + ": the compensation in this folder is of another study: " + difference +
                                 ". Choose another folder with --out, or begin anew with --restart.");
}

void CompensationFolder::begin(const std::vector<StudyFact>& facts) const
{
    std::error_code error;
    fs::create_directories(m_path, error);
    if (!fs::is_directory(m_path, error))
        throw std::runtime_error("The folder " + m_path + " cannot be made; choose another one with --out.");
    writeFileSafely(pathOf(stateName), toJson(facts).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

bool CompensationFolder::isBegun() const
{
    std::error_code ignored;
    return fs::exists(pathOf(stateName), ignored);
}

void CompensationFolder::clear() const
{
    if (!isBegun())
        return;
    std::error_code ignored;
    for (int round = 1; fs::is_directory(folderOf(round), ignored); ++round)
        fs::remove_all(folderOf(round), ignored);
    for (const char* name : {"rounds.csv", "rounds.svg", "compensated.step", "compensated.step.report.json", stateName})
        fs::remove(pathOf(name), ignored);
}

void CompensationFolder::keep(const CompensationRound& round) const
{
    const Json json{{"round", round.number},
                    {"factor", round.factor},
                    {"largest_m", round.largest},
                    {"mean_m", round.mean},
                    {"worst_point", round.worst},
                    {"compensation_m", numbersOf(round.compensation)},
                    {"deviations_m", numbersOf(round.deviations)}};
    writeFileSafely((fs::path(folderOf(round.number)) / roundName).string(), json.dump() + "\n");
}

std::vector<CompensationRound> CompensationFolder::rounds(const TargetPoints& points) const
{
    std::vector<CompensationRound> rounds;
    for (int number = 1;; ++number) {
        std::optional<CompensationRound> round = roundIn((fs::path(folderOf(number)) / roundName).string(), points);
        if (!round || round->number != number)
            return rounds;
        rounds.push_back(std::move(*round));
    }
}

} // namespace knead
