#include "io/export/deformation_stages.h"

#include "core/deformation/deformation.h"
#include "core/deformation/number_map.h"
#include "core/message/message.h"
#include "io/export/part_of_shape.h"
#include "io/export/plane_division.h"
#include "io/morph/brep_morph.h"

#include <gp_Pln.hxx>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double stageShare = 0.5; // of the tolerance, for all that is carried further together

using Maps = std::vector<std::shared_ptr<const SmoothMap>>;

/// What a map has planes for across which it is not smooth; null: none.
const NumberMap* creasedMap(const SmoothMap& map)
{
    const auto* number = dynamic_cast<const NumberMap*>(&map);
    return number != nullptr && !number->deformation().eases ? number : nullptr;
}

/// A new stage begins with each map that has planes.
std::vector<Maps> stagesOf(const PartToExport& part, const std::shared_ptr<const SmoothMap>& own)
{
    Maps all;
    if (own != nullptr)
        all.push_back(own);
    if (const auto* chain = dynamic_cast<const ChainedMap*>(part.deformed.get()))
        all.insert(all.end(), chain->maps().begin(), chain->maps().end());
    else
        all.push_back(part.deformed);
    std::vector<Maps> stages;
    for (auto& map : all) {
        if (stages.empty() || creasedMap(*map) != nullptr)
            stages.emplace_back();
        stages.back().push_back(std::move(map));
    }
    return stages;
}

std::shared_ptr<const SmoothMap> joined(const Maps& maps)
{
    return maps.size() == 1 ? maps.front() : std::make_shared<const ChainedMap>(maps);
}

std::array<gp_Pln, 2> planesOf(const NumberDeformation& d)
{
    const auto plane = [&](double along) {
        const Vec3 at = 1e3 * (d.origin + along * d.axis);
        return gp_Pln(gp_Pnt(at.x(), at.y(), at.z()), gp_Dir(d.axis.x(), d.axis.y(), d.axis.z()));
    };
    return {plane(d.from), plane(d.to)};
}

/// By which what a stage is off may grow in those that follow.
double growthAfter(const std::vector<Maps>& stages, std::size_t stage)
{
    double growth = 1;
    for (std::size_t i = stage + 1; i < stages.size(); ++i)
        if (const auto* number = dynamic_cast<const NumberMap*>(stages[i].front().get()))
            growth *= std::max(1.0, number->deformation().factor);
    return growth;
}

class Stages {
public:
    Stages(const PartToExport& part, const TopoDS_Shape& shape)
        : m_part(part)
        , m_shape(shape)
    {
        m_part.before = part.before.value_or(
            PartToExport::Measures{part.part.volume, static_cast<int>(part.part.faces.size()), part.part.edges});
    }

    /// At all planes together, else at each one where that goes.
    void divideFor(const NumberMap& map)
    {
        const std::array<gp_Pln, 2> planes = planesOf(map.deformation());
        if (divideAt(planes))
            return;
        std::size_t missed = 0;
        for (const gp_Pln& plane : planes)
            if (!divideAt({&plane, 1}))
                ++missed;
        if (missed == planes.size())
            m_part.remarks.push_back(
                Message("Export",
                        "\"%1\": its faces could not be divided at the planes of the deformation; each is one surface "
                        "across them.")
                    .with(m_part.part.name));
        else if (missed > 0)
            m_part.remarks.push_back(
                Message("Export",
                        "\"%1\": its faces could not be divided at one of the planes of the deformation; each is one "
                        "surface across it.")
                    .with(m_part.part.name));
    }

    /// @return whether there is a sound shape now, no farther off than the tolerance [m]
    bool carry(const SmoothMap& map, double tolerance, TaskControl& control)
    {
        const MorphOptions options{.tolerance = 1e3 * tolerance, .findsForms = true};
        const MorphedShape morphed = morphShape(m_shape, map, options, control);
        const auto isOff = [&](const MorphedFaceNote& note) { return note.error > options.tolerance; };
        if (!morphed.isValid || std::ranges::any_of(morphed.notes, isOff))
            return false;
        replace(morphed.shape, morphed.origin);
        m_isCarried = true;
        // What objects made of it is done.
        m_part.map = nullptr;
        m_part.aggregate = nullptr;
        m_part.displacements.clear();
        m_part.slit = nullptr;
        m_part.cut = nullptr;
        return true;
    }

    StagedPart last(const std::shared_ptr<const SmoothMap>& map)
    {
        if (m_divided == 1)
            m_part.remarks.push_back(Message("Export", "\"%1\": 1 face was divided at the planes of the deformation.")
                                         .with(m_part.part.name));
        else if (m_divided > 1)
            m_part.remarks.push_back(
                Message("Export", "\"%1\": %2 faces were divided at the planes of the deformation.")
                    .with(m_part.part.name, m_divided));
        m_part.deformed = map;
        return {m_part, m_shape, m_isCarried};
    }

private:
    /// @return whether faces are divided there now, or none goes through
    bool divideAt(std::span<const gp_Pln> planes)
    {
        const auto division = dividedAtPlanes(m_shape, planes);
        if (division && division->divided > 0) {
            m_divided += division->divided;
            replace(division->shape.shape, division->shape.origin);
        }
        return division.has_value();
    }

    void replace(const TopoDS_Shape& shape, const std::vector<std::uint32_t>& origin)
    {
        const bool wasClosed = m_part.part.watertight;
        m_part = withShape(m_part, shape, origin);
        m_part.part.watertight = wasClosed; // that a closed shape was drawn with a gap is no reason to call it open
        m_shape = shape;
    }

    PartToExport m_part;
    TopoDS_Shape m_shape;
    std::size_t m_divided = 0;
    bool m_isCarried = false;
};

} // namespace

StagedPart inStages(const PartToExport& part, const TopoDS_Shape& shape,
                    const std::shared_ptr<const SmoothMap>& ofObjects, double tolerance, TaskControl& control)
{
    const std::vector<Maps> stages = stagesOf(part, ofObjects);
    if (stages.size() == 1 && creasedMap(*stages.front().front()) == nullptr)
        return {part, shape, false}; // smooth everywhere, with what the objects make of it
    Stages made(part, shape);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        control.throwIfCancelled();
        control.report(static_cast<double>(i) / static_cast<double>(stages.size()), "dividing faces");
        if (const NumberMap* number = creasedMap(*stages[i].front()))
            made.divideFor(*number);
        const std::shared_ptr<const SmoothMap> map = joined(stages[i]);
        if (i + 1 == stages.size())
            return made.last(map);
        const double own = tolerance * stageShare / (static_cast<double>(stages.size() - 1) * growthAfter(stages, i));
        TaskPortion portion = TaskPortion::ofItem(control, i, stages.size());
        if (!made.carry(*map, own, portion)) {
            PartToExport whole = part;
            whole.remarks.push_back(
                Message("Export",
                        "\"%1\": it was carried by all deformations in one step, across the planes of single ones.")
                    .with(part.part.name));
            return {whole, shape, false};
        }
    }
    return {part, shape, false};
}

} // namespace knead
