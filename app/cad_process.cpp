#include "app/cad_process.h"

#include "app/cad_program.h"
#include "core/message/message.h"
#include "core/model/joined_model.h"
#include "io/fields/nodal_mesh.h"
#include "io/worker/isolated_export.h"
#include "io/worker/isolated_field.h"
#include "io/worker/isolated_import.h"
#include "io/worker/isolated_project.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

namespace knead {

namespace {

std::string& chosenCadProgram()
{
    static std::string path;
    return path;
}

std::string cadProgram()
{
    return chosenCadProgram().empty() ? ownCadProgram() : chosenCadProgram();
}

/// The progress of several imports as that of one task: their mean, and the stage of the one that spoke last.
class SharedControl {
public:
    SharedControl(TaskControl& control, std::size_t count)
        : m_control(control)
        , m_fractions(count, 0)
    {
    }

    void report(std::size_t import, double fraction, std::string_view stage)
    {
        const std::lock_guard lock(m_mutex);
        m_fractions[import] = fraction;
        const double sum = std::accumulate(m_fractions.begin(), m_fractions.end(), 0.0);
        m_control.report(sum / static_cast<double>(m_fractions.size()), stage);
    }
    bool isCancelled() const { return m_control.isCancelled(); }

private:
    TaskControl& m_control;
    std::mutex m_mutex;
    std::vector<double> m_fractions;
};

class OneOfMany final : public TaskControl {
public:
    OneOfMany(SharedControl& shared, std::size_t import)
        : m_shared(shared)
        , m_import(import)
    {
    }

    void report(double fraction, std::string_view stage) override { m_shared.report(m_import, fraction, stage); }
    bool isCancelled() const override { return m_shared.isCancelled(); }

private:
    SharedControl& m_shared;
    std::size_t m_import;
};

struct Outcome {
    std::optional<Model> model;
    Message failure;
};

Outcome tryImport(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    try {
        return {importInChild(path, options, control), {}};
    } catch (const Cancelled&) {
        return {};
    } catch (const std::exception& error) {
        return {std::nullopt, messageOf(error)};
    }
}

/// In the order of the paths.
std::vector<Outcome> importAll(const std::vector<std::string>& paths, const ImportOptions& options,
                               TaskControl& control)
{
    std::vector<Outcome> outcomes(paths.size());
    SharedControl shared(control, paths.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < paths.size(); i = next++) {
            OneOfMany own(shared, i);
            outcomes[i] = tryImport(paths[i], options, own);
        }
    };
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < std::min(cores, paths.size()); ++i)
        threads.emplace_back(work);
    work();
    threads.clear();
    return outcomes;
}

} // namespace

Model importInChild(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    return importIsolated(cadProgram(), path, options, limitsFor(path, options), control);
}

ExportReport exportInChild(const std::string& path, const ExportJob& job, TaskControl& control)
{
    return exportIsolated(cadProgram(), path, job, control);
}

FilePreview previewInChild(const std::string& path, TaskControl& control)
{
    return previewIsolated(cadProgram(), path, limitsFor(path), control);
}

FieldFile readFieldInChild(const std::string& path, const FieldChoice& choice, TaskControl& control)
{
    return readFieldIsolated(cadProgram(), path, choice, control);
}

NodalMesh readNodesInChild(const std::string& path, const std::string& unit, TaskControl& control)
{
    return readNodesIsolated(cadProgram(), path, unit, control);
}

Project readProjectAfterTrial(const std::string& path, TaskControl& control)
{
    return readTriedProject(cadProgram(), path, control);
}

RescuedProject rescueProjectAfterTrial(const std::string& path, TaskControl& control)
{
    return rescueTriedProject(cadProgram(), path, control);
}

Model importInChildren(const std::vector<std::string>& paths, const ImportOptions& options, TaskControl& control)
{
    if (paths.size() == 1)
        return importInChild(paths.front(), options, control);
    std::vector<Outcome> outcomes = importAll(paths, options, control);
    control.throwIfCancelled();
    std::vector<Model> models;
    std::vector<Message> failures;
    for (Outcome& outcome : outcomes)
        if (outcome.model)
            models.push_back(std::move(*outcome.model));
        else
            failures.push_back(outcome.failure);
    if (models.empty())
        throw Problem(failures.empty() ? Message("Import", "There is no file to open.") : failures.front());
    Model all = joined(std::move(models));
    all.missing.insert(all.missing.end(), failures.begin(), failures.end());
    return all;
}

void setCadProgram(const std::string& path)
{
    chosenCadProgram() = path;
}

} // namespace knead
