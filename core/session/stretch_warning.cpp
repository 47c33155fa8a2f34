#include "core/session/stretch_warning.h"

#include "core/mechanics/connection_law.h"
#include "core/mechanics/object_strain.h"

#include <Eigen/Eigenvalues>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t objectsBetweenLooks = 1024; // whether to stop

double largestPrincipal(const Mat3& strain)
{
    return Eigen::SelfAdjointEigenSolver<Mat3>(strain, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// How far an object has flowed by how far it can, where it is stretched; 0: it never breaks by that.
double shareOfFlow(const ObjectStrains& strains, ObjectIndex object, const ConnectionLaw& law)
{
    if (!std::isfinite(law.ductility) || law.ductility <= 0)
        return 0;
    return std::min(strains.plasticStrain(object), largestPrincipal(strains.of(object).strain)) / law.ductility;
}

/// Looks for what is nearest to breaking in a body, as the program does that breaks it: connection by connection.
class Search {
public:
    Search(const Snapshot::BodyState& body, TaskControl& control)
        : m_body(body)
        , m_materials(body.relaxed->materials)
        , m_displacements(body.displacements())
        , m_strains(*body.aggregate, m_displacements, *body.relaxed,
                    body.broken ? std::span<const BrokenConnection>(*body.broken) : std::span<const BrokenConnection>())
        , m_control(control)
    {
        for (const Material& one : m_materials.materials())
            for (const Material& other : m_materials.materials())
                m_laws.push_back(lawBetween(one, other, body.aggregate->lattice.spacing));
        if (body.broken)
            m_broken.insert(body.broken->begin(), body.broken->end());
    }

    std::optional<Overstretch> run()
    {
        for (ObjectIndex o = 0; o < m_body.positions.size(); ++o) {
            if (o % objectsBetweenLooks == 0)
                m_control.throwIfCancelled();
            take(o, shareOfFlow(m_strains, o, lawOf(o, o)));
        }
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            stretch(d);
        return m_most.share >= warningShareOfBreaking ? std::optional(m_most) : std::nullopt;
    }

private:
    const ConnectionLaw& lawOf(ObjectIndex one, ObjectIndex other) const
    {
        return m_laws[m_materials.indexOf(one) * m_materials.materials().size() + m_materials.indexOf(other)];
    }

    void take(ObjectIndex object, double share)
    {
        if (share > m_most.share)
            m_most = {object, m_body.positions[object], share};
    }

    /// l / l0 - 1 by what a connection bears; l0 is that of the relaxed material, sqrt(d^T C d) in the mean of both ends.
    void stretch(std::uint32_t d)
    {
        const Aggregate& aggregate = *m_body.aggregate;
        const Vec3 step = aggregate.lattice.direction(static_cast<int>(d));
        const bool hasFlowed = !m_body.relaxed->metric[0].empty();
        const auto relaxed = [&](ObjectIndex o) {
            return hasFlowed ? std::sqrt(step.dot(m_strains.relaxedMetric(o) * step)) : step.norm();
        };
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d]) {
            m_control.throwIfCancelled();
            for (ObjectIndex o = segment.begin; o < segment.end; ++o) {
                const ObjectIndex other = o + static_cast<ObjectIndex>(segment.offset);
                const double limit = lawOf(o, other).suddenStrain;
                if (!(aggregate.weight[d][o] > 0) || !std::isfinite(limit) || m_broken.contains({d, o}))
                    continue;
                const double length = (m_body.positions[other] - m_body.positions[o]).norm();
                take(o, (2 * length / (relaxed(o) + relaxed(other)) - 1) / limit);
            }
        }
    }

    const Snapshot::BodyState& m_body;
    const MaterialMap& m_materials;
    std::vector<Vec3> m_displacements;
    ObjectStrains m_strains;
    TaskControl& m_control;
    std::vector<ConnectionLaw> m_laws; ///< per pair of materials
    std::set<ConnectionId> m_broken;
    Overstretch m_most;
};

std::optional<Overstretch> searched(const Snapshot::BodyState& body, TaskControl& control)
{
    if (std::ranges::none_of(body.relaxed->materials.materials(), &Material::breaks))
        return {}; // what most bodies are of
    return Search(body, control).run();
}

} // namespace

std::optional<Overstretch> mostOverstretched(const Snapshot::BodyState& body, TaskControl& control)
{
    if (body.kind != BodyKind::deformable || !body.relaxed)
        return {};
    tbb::task_arena alone(1); // processors are for what a person waits for
    return alone.execute([&] { return searched(body, control); });
}

} // namespace knead
