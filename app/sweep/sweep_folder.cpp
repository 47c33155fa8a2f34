#include "app/sweep/sweep_folder.h"

#include "app/file_content.h"
#include "io/files/safe_file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* planName = "sweep.json";
constexpr const char* pointsName = "points";

std::string numbered(std::size_t point)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%05zu", point);
    return text.data();
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (!fs::is_directory(path, error))
        throw std::runtime_error("The folder " + path + " cannot be made; choose another one with --out.");
}

} // namespace

SweepFolder::SweepFolder(const std::string& path)
    : m_path(fs::absolute(path).lexically_normal().string())
{
}

std::string SweepFolder::pathOf(const std::string& name) const
{
    return (fs::path(m_path) / name).string();
}

std::string SweepFolder::exportsOf(std::size_t point) const
{
    return (fs::path(m_path) / pointsName / numbered(point)).string();
}

std::string SweepFolder::resultFile(std::size_t point) const
{
    return exportsOf(point) + ".json";
}

std::optional<SweepPlan> SweepFolder::plan() const
{
    const std::optional<std::string> text = textOf(pathOf(planName));
    if (!text)
        return std::nullopt;
    try {
        return planFromJson(*text);
    } catch (const std::exception&) {
        throw std::runtime_error(pathOf(planName) + ": this is no plan of a sweep; choose another folder with --out.");
    }
}

void SweepFolder::checkHasNoOther(const SweepPlan& plan) const
{
    const std::optional<SweepPlan> before = this->plan();
    const std::string difference = before ? differenceOf(*before, plan) : "";
    if (!difference.empty())
        throw std::runtime_error(m_path + ": the sweep in this folder is another one: " + difference +
                                 ". Choose another folder with --out, or begin anew with --restart.");
}

void SweepFolder::begin(const SweepPlan& plan) const
{
    makeFolder((fs::path(m_path) / pointsName).string());
    writeFileSafely(pathOf(planName), planToJson(plan));
}

void SweepFolder::clear() const
{
    if (!plan())
        return;
    std::error_code ignored;
    for (const char* name : {pointsName, "slurm", "sweep.csv", "timing.csv", planName})
        fs::remove_all(pathOf(name), ignored);
}

void SweepFolder::keep(const SweepPlan& plan, std::size_t point, const PointResult& result) const
{
    Json json{{"sweep", plan.key},
              {"point", point},
              {"status", result.status},
              {"message", result.message},
              {"elapsed_s", result.elapsed}};
    for (std::size_t i = 0; i < plan.paths.size(); ++i)
        json["vary"][plan.paths[i]] = plan.points[point][i];
    if (!result.report.empty())
        json["report"] = Json::parse(result.report);
    writeFileSafely(resultFile(point), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<PointResult> SweepFolder::result(const SweepPlan& plan, std::size_t point) const
{
    const std::optional<std::string> text = textOf(resultFile(point));
    if (!text)
        return std::nullopt;
    try {
        const Json json = Json::parse(*text);
        if (json.at("sweep") != plan.key || json.at("point") != point)
            return std::nullopt;
        PointResult result{json.at("status"), json.at("message"), json.at("elapsed_s"), ""};
        if (json.contains("report"))
            result.report = json.at("report").dump();
        return result;
    } catch (const std::exception&) { // damaged from outside: it is carried out again
        return std::nullopt;
    }
}

std::vector<std::size_t> SweepFolder::missing(const SweepPlan& plan) const
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        if (!result(plan, i))
            points.push_back(i);
    return points;
}

} // namespace knead
