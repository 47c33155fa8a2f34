#pragma once

#include "core/aggregate/spacing_choice.h"
#include "core/message/message.h"
#include "core/model/export_report.h"
#include "core/model/part.h"
#include "core/session/body_stress.h"
#include "core/session/force_series.h"
#include "core/session/probe_series.h"
#include "core/session/recipe.h"
#include "core/session/recipe_files.h"
#include "core/simulation/run_quality.h"
#include "core/simulation/snapshot.h"
#include "core/simulation/static_report.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// How far a body is from where it was at rest.
struct BodyMotion {
    std::string name;                     ///< path in the assembly
    Vec3 meanDisplacement = Vec3::Zero(); ///< of its objects [m]
    double largestDisplacement = 0;       ///< of any object [m]
    BodyStress stress;
};

/// What a run of a recipe did and left behind.
struct RunReport {
    std::size_t bodies = 0;
    std::size_t objects = 0;
    std::size_t connections = 0; ///< structural, at the end
    std::size_t broken = 0;      ///< structural connections that broke
    std::uint64_t refills = 0;   ///< bodies filled anew
    std::size_t joints = 0;      ///< sticking or healed together at the end
    std::size_t components = 0;  ///< connected pieces of material at the end
    double addedMass = 0;        ///< by mass scaling, as a share of all mass
    std::uint64_t steps = 0;
    double timeStep = 0;         ///< mean [s]
    double simulated = 0;        ///< [s]
    double wall = 0;             ///< taken by the steps [s]
    std::uint64_t stateHash = 0; ///< equal for equal histories, whatever the number of threads
    std::string integrator;      ///< a sentence on which one was in use at the end and why
    EnergyLedger energy;
    RunQuality quality;
    SpacingAssessment fineness;      ///< of the filling
    std::vector<BodyMotion> motions; ///< one per body, at the end
    std::vector<ToolState> tools;    ///< as last seen, those taken away included
    ForceSeries forces;              ///< of fixtures, tools and loads over time
    std::string forcesFile;          ///< where they were written as a table; empty: nowhere
    std::vector<ProbeCurve> probes;
    std::string probesFile;             ///< the same
    std::vector<StaticReport> balances; ///< of each load step of a static analysis
    std::vector<std::string> files;     ///< written, in the order of the recipe
    std::vector<ExportReport> exports;  ///< on those that are no pictures
    std::vector<std::string> warnings;  ///< sentences for the person

    /// Why the run ended before it was done: a sentence with its remedy; empty when it was done.
    std::string failure;
    Trouble trouble = Trouble::none; ///< of the simulation, when that was why

    double ratio() const { return wall > 0 ? simulated / wall : 0; }
};

/// The work failed in the midst of a run.
struct RunFailed : std::runtime_error {
    explicit RunFailed(RunReport known)
        : std::runtime_error(known.failure)
        , report(std::move(known))
    {
    }

    RunReport report; ///< what is known, RunReport::failure included
};

/// Takes what is said while a run goes on, at once: that a tool begins inside material (which is among RunReport::warnings,
/// too), that it hardly goes on (which depends on the machine). Sentences for the person; called in any thread.
using SayAtOnce = std::function<void(const std::string& sentence)>;

/// Where tables over time are written; empty: nowhere.
struct RunTables {
    std::string forces; ///< and moments, of fixtures, tools and loads
    std::string probes;
};

/// A file with what the material does at the nodes of a mesh.
struct WrittenAtNodes {
    std::string file;
    std::vector<Message> warnings; ///< sentences for the person
};

/// Writes such a file at the end of a run. Blocks. @param partOfBody index into Model::parts
/// @throws std::runtime_error, in a sentence; Cancelled
using WriteAtNodes =
    std::function<WrittenAtNodes(const Model&, std::span<const std::size_t> partOfBody, const Snapshot&, TaskControl&)>;

/// Carries out a recipe: part -> scene -> steps -> exports. Files appear whole or not at all; when cancelled, those not
/// yet begun are missing.
/// @param outputFolder made when missing
/// @param tables over time, CSV
/// @param writeAtNodes null: nobody asked for it
/// @throws UnusableInput (core/session/recipe_parts.h) when recipe and part do not fit, std::runtime_error when the work failed,
///         each in a sentence, RunFailed when that was after the first step. @throws Cancelled
RunReport runRecipe(const Recipe& recipe, const RecipeFiles& files, const std::string& outputFolder,
                    TaskControl& control = TaskControl::none(), const SayAtOnce& say = {}, const RunTables& tables = {},
                    const WriteAtNodes& writeAtNodes = nullptr);

} // namespace knead
