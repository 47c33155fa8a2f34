#pragma once

#include "core/simulation/command.h"
#include "core/simulation/moment.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace knead {

struct BodyRun;

/// The loads of a simulation, by their ids; removed ones leave a gap.
class ActingLoads {
public:
    void add(LoadRun run, const Aggregate& aggregate);
    void remove(LoadId load);
    void change(const SetLoad& to, double time);
    void begin(); ///< as at the start: all rise from nothing
    void restore(const std::vector<std::optional<LoadRun>>& runs, const std::vector<Body>& bodies);

    bool isThere(LoadId load) const { return load < m_acting.size() && m_acting[load]; }
    std::size_t size() const { return m_acting.size(); } ///< with the gaps
    bool empty() const;
    bool isRising(double time) const; ///< any is not what it rises to
    std::vector<std::optional<LoadRun>> runs() const;
    const LoadRun& run(LoadId load) const { return m_acting[load]->run; }
    const Vec3& center(LoadId load) const { return m_acting[load]->forces.center(); }

    /// Adds the forces that loads have at a time to those of the objects where they are now. @return their power [W]
    double addForces(std::vector<std::unique_ptr<BodyRun>>& bodies, double time);

    /// Power of the forces added last, at present velocities [W].
    double power(const std::vector<std::unique_ptr<BodyRun>>& bodies) const;

    /// Sum of the forces added last, and their moment about center().
    struct Sum {
        Vec3 force = Vec3::Zero();
        Vec3 moment = Vec3::Zero();
    };
    const Sum& sum(LoadId load) const { return m_acting[load]->sum; }

    /// Work that is in the ledger already, of the way that goes on from where the ledger stands [J].
    double workAhead = 0;

private:
    struct Acting {
        LoadRun run;
        LoadForces forces;
        std::vector<Vec3> last; ///< per object of its patch [N]
        Sum sum = {};
    };
    std::vector<std::optional<Acting>> m_acting;
};

} // namespace knead
