#include "core/session/stretch_warning.h"

#include "core/mechanics/connection_law.h"
#include "core/mechanics/object_strain.h"

#include <Eigen/Eigenvalues>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t objectsBetweenLooks = 1024; // whether to stop

double largestPrincipal(const Mat3& strain)
{
    return Eigen::SelfAdjointEigenSolver<Mat3>(strain, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// What an object bears by what it can bear; 0: it never breaks.
double shareOfBreaking(const ObjectStrains& strains, ObjectIndex object, const ConnectionLaw& law)
{
    double share = 0;
    if (std::isfinite(law.suddenStrain))
        share = std::expm1(largestPrincipal(strains.elastic(object).strain)) / law.suddenStrain;
    if (std::isfinite(law.ductility) && law.ductility > 0)
        share = std::max(share, std::min(strains.plasticStrain(object), largestPrincipal(strains.of(object).strain)) /
                                    law.ductility);
    return share;
}

std::optional<Overstretch> searched(const Snapshot::BodyState& body, TaskControl& control)
{
    const MaterialMap& materials = body.relaxed->materials;
    std::vector<std::optional<ConnectionLaw>> laws; // per material; none for what never breaks
    for (const Material& material : materials.materials())
        laws.push_back(material.breaks()
                           ? std::optional(lawBetween(material, material, body.aggregate->lattice.spacing))
                           : std::nullopt);
    if (std::ranges::none_of(laws, [](const auto& law) { return law.has_value(); }))
        return {};
    const std::vector<Vec3> displacements = body.displacements();
    const ObjectStrains strains(*body.aggregate, displacements, *body.relaxed,
                                body.broken ? std::span<const BrokenConnection>(*body.broken)
                                            : std::span<const BrokenConnection>());
    Overstretch most;
    for (ObjectIndex o = 0; o < body.positions.size(); ++o) {
        if (o % objectsBetweenLooks == 0)
            control.throwIfCancelled();
        const std::optional<ConnectionLaw>& law = laws[materials.indexOf(o)];
        if (!law)
            continue;
        const double share = shareOfBreaking(strains, o, *law);
        if (share > most.share)
            most = {o, body.positions[o], share};
    }
    return most.share >= warningShareOfBreaking ? std::optional(most) : std::nullopt;
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
