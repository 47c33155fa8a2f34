#pragma once

#include "app/sweep/sweep_plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What carrying out one point gave.
struct PointResult {
    int status = 0;      ///< exit status of the run; 128 and the signal when it crashed
    std::string message; ///< why it failed, or its warnings; empty: neither
    double elapsed = 0;  ///< wall time of all of it [s]
    std::string report;  ///< what `knead run --json` said; empty when it failed
};

/// The folder of a sweep: its plan, a file per finished point, and the exports of each in a folder of its own. Files appear
/// whole or not at all. Several processes may write results at the same time.
class SweepFolder {
public:
    /// A folder with a plan in it, or without one yet.
    explicit SweepFolder(const std::string& path);

    const std::string& path() const { return m_path; }
    std::string pathOf(const std::string& name) const;
    std::string exportsOf(std::size_t point) const; ///< the folder

    /// None when no sweep was begun here. @throws std::runtime_error, in a sentence, when it cannot be read
    std::optional<SweepPlan> plan() const;

    /// @throws std::runtime_error, in a sentence, when a sweep with another plan is here
    void checkHasNoOther(const SweepPlan& plan) const;

    /// Begins a sweep, or goes on with it. @throws std::runtime_error, in a sentence, when the folder cannot be written to
    void begin(const SweepPlan& plan) const;

    /// Takes away what a sweep left here, but nothing else.
    void clear() const;

    /// @throws std::runtime_error, in a sentence, when the disk refuses
    void keep(const SweepPlan& plan, std::size_t point, const PointResult& result) const;

    /// None when the point is not finished, or belongs to another plan.
    std::optional<PointResult> result(const SweepPlan& plan, std::size_t point) const;

    /// Points that are not finished, ascending.
    std::vector<std::size_t> missing(const SweepPlan& plan) const;

private:
    std::string resultFile(std::size_t point) const;

    std::string m_path; ///< absolute
};

} // namespace knead
