#include "app/deformation_plan.h"

#include "app/field_source.h"
#include "core/deformation/field_map.h"
#include "core/deformation/kept_faces.h"
#include "core/deformation/number_placement.h"
#include "core/geometry/refine.h"
#include "core/model/file_names.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>
#include <utility>

namespace knead {

namespace {

constexpr double surfaceEdges = 100; // across a part, where it is looked at
constexpr std::size_t mostTrianglesOfPlan = 100'000;

bool isCalled(const Part& part, const std::string& name)
{
    return part.name == name || part.path == name || part.path.starts_with(name + '/');
}

/// "3,7"
std::set<std::uint32_t> faceNumbers(const std::string& text, const Part& part)
{
    std::set<std::uint32_t> faces;
    std::stringstream stream(text);
    for (std::string one; std::getline(stream, one, ',');) {
        std::uint32_t face = 0;
        const auto [end, error] = std::from_chars(one.data(), one.data() + one.size(), face);
        if (error != std::errc() || end != one.data() + one.size() || face >= part.faces.size())
            throw Problem(
                Message("Deformation", "\"%1\" has no face %2; it has %3, numbered from 0, and meshes have none.")
                    .with(part.name, one, part.faces.size()));
        faces.insert(face);
    }
    return faces;
}

/// Which part a choice of faces is of, and the rest of its text.
std::pair<std::size_t, std::string> partOfFaces(const std::string& text, const Model& model,
                                                const std::vector<std::size_t>& meant)
{
    const std::size_t colon = text.rfind(':');
    const std::string name = colon == std::string::npos ? std::string() : text.substr(0, colon);
    std::vector<std::size_t> found;
    for (const std::size_t p : meant)
        if (colon == std::string::npos || isCalled(model.parts[p], name))
            found.push_back(p);
    if (found.size() == 1)
        return {found.front(), colon == std::string::npos ? text : text.substr(colon + 1)};
    if (colon == std::string::npos)
        throw Problem(Message("Deformation",
                              "Which part the faces %1 are of is not clear; put its name before them, as "
                              "Lid:%1.")
                          .with(text));
    throw Problem(Message("Deformation",
                          "%1 parts that are deformed are called \"%2\", not one; knead info --json lists "
                          "the names and paths of all.")
                      .with(found.size(), name));
}

double largestOf(const DisplacementField& field)
{
    double largest = 0;
    for (const Vec3& displacement : field.displacements)
        largest = std::max(largest, displacement.norm());
    return largest;
}

/// The parts on their way through deformations.
class Plan {
public:
    Plan(const Model& model, const std::vector<bool>& which)
        : m_model(model)
        , m_which(which)
    {
        for (std::size_t p = 0; p < model.parts.size(); ++p) {
            const Part& part = model.parts[p];
            if (!which[p] || part.mesh.empty())
                continue;
            m_meant.push_back(p);
            m_rest.push_back(refine(part.mesh, part.box.diagonal().norm() / surfaceEdges, mostTrianglesOfPlan));
        }
        if (m_meant.empty())
            throw Problem(aboutFile(model.file, Message("Deformation", "it has no surface to be deformed.")));
        m_now = m_rest;
    }

    void add(const NumberWish& wish, TaskControl& control)
    {
        NumberDeformation number = numberDeformation(wish, places());
        if (wish.kFactor)
            number.neutral = neutralIn(number, *wish.kFactor);
        for (const TriangleMesh& mesh : m_now)
            if (const auto fold = foldOf(number, mesh))
                throw Problem(*fold);
        Deformation deformation(number);
        carry(*mapOf(deformation, control));
        m_deformations.push_back(std::move(deformation));
        m_sources.emplace_back();
    }

    void add(const FieldWish& wish, TaskControl& control)
    {
        TaskPortion reading(control, 0, 0.6);
        FieldFile file = readFieldSource(wish.path, wish.choice, surface(), reading);
        auto field = std::make_shared<const DisplacementField>(std::exchange(file.field, {}));
        FieldDeformation deformation = deformationOf(wish, field);
        TaskPortion mapping(control, 0.6, 0.9);
        const std::shared_ptr<const SmoothMap> map = fieldMap(deformation, mapping);
        TaskPortion fitting(control, 0.9, 1);
        FieldFit fit = fitOfField(deformation, *map, m_now, file.unit, fitting);
        if (fit.mismatch)
            throw Problem(aboutFile(wish.path, *fit.mismatch));
        for (const std::vector<Message>* remarks : {&file.warnings, &fit.remarks})
            for (const Message& remark : *remarks)
                note(wish.path, remark);
        carry(*map);
        m_deformations.emplace_back(std::move(deformation));
        m_sources.push_back(DeformationPlan::Source{.file = std::move(file),
                                                    .nodes = field->nodes.size(),
                                                    .largest = largestOf(*field),
                                                    .fit = std::move(fit)});
    }

    DeformationPlan finished() &&
    {
        DeformationPlan plan{.deformations =
                                 std::make_shared<const std::vector<Deformation>>(std::move(m_deformations)),
                             .sources = std::move(m_sources),
                             .moves = std::vector<std::optional<SurfaceMove>>(m_model.parts.size()),
                             .remarks = std::move(m_remarks)};
        for (std::size_t i = 0; i < m_meant.size(); ++i)
            plan.moves[m_meant[i]] = surfaceMove(m_rest[i], m_now[i].vertices);
        return plan;
    }

private:
    void note(const std::string& path, const Message& remark)
    {
        const bool namesFile = remark.english().starts_with(shortName(path));
        m_remarks.push_back(namesFile ? remark : aboutFile(path, remark));
    }

    /// In the thickness of what lies between the planes; of all parts where nothing does.
    double neutralIn(const NumberDeformation& number, double kFactor) const
    {
        const HeightRange heights = heightsBetweenPlanes(number, std::span(m_now));
        return heights.isEmpty() ? number.neutral : neutralOfSheet(number, heights, kFactor);
    }

    void carry(const SmoothMap& map)
    {
        for (TriangleMesh& mesh : m_now)
            map.evaluate(std::vector<Vec3>(mesh.vertices), mesh.vertices);
    }

    FieldDeformation deformationOf(const FieldWish& wish, std::shared_ptr<const DisplacementField> field) const
    {
        FieldDeformation deformation{
            .field = std::move(field), .factor = wish.factor, .kept = keptOf(wish), .fade = 0, .locked = wish.locked};
        if (!deformation.kept.empty())
            deformation.fade = wish.fade.value_or(FieldWish::fadeShare * boxOfPlaces(places()).diagonal().norm());
        return deformation;
    }

    /// Of the surfaces as they are now [m].
    std::vector<Vec3> places() const
    {
        std::vector<Vec3> all;
        for (const TriangleMesh& mesh : m_now)
            all.insert(all.end(), mesh.vertices.begin(), mesh.vertices.end());
        return all;
    }

    /// Of all that are deformed, as they are now.
    TriangleMesh surface() const
    {
        TriangleMesh all;
        for (const TriangleMesh& mesh : m_now)
            all = besides(std::move(all), mesh);
        return all;
    }

    TriangleMesh keptOf(const FieldWish& wish) const
    {
        TriangleMesh kept;
        for (const std::string& text : wish.kept) {
            const auto [part, numbers] = partOfFaces(text, m_model, m_meant);
            const auto at = static_cast<std::size_t>(std::ranges::find(m_meant, part) - m_meant.begin());
            kept = besides(std::move(kept), facesOf(m_now[at], faceNumbers(numbers, m_model.parts[part])));
        }
        return kept;
    }

    const Model& m_model;
    const std::vector<bool>& m_which;
    std::vector<std::size_t> m_meant; ///< parts of the model
    std::vector<TriangleMesh> m_rest; ///< surfaces of these
    std::vector<TriangleMesh> m_now;
    std::vector<Deformation> m_deformations;
    std::vector<std::optional<DeformationPlan::Source>> m_sources;
    std::vector<Message> m_remarks;
};

} // namespace

std::vector<bool> partsNamed(const Model& model, const std::vector<std::string>& names)
{
    std::vector<bool> which(model.parts.size(), names.empty());
    for (const std::string& name : names) {
        bool isFound = false;
        for (std::size_t p = 0; p < model.parts.size(); ++p)
            if (isCalled(model.parts[p], name))
                which[p] = isFound = true;
        if (!isFound)
            throw Problem(Message("Deformation",
                                  "There is no part or assembly \"%1\" in %2; knead info --json lists the "
                                  "names and paths of all.")
                              .with(name, shortName(model.file)));
    }
    return which;
}

DeformationPlan planOf(const std::vector<DeformationWish>& wishes, const Model& model, const std::vector<bool>& which,
                       TaskControl& control)
{
    Plan plan(model, which);
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        TaskPortion portion = TaskPortion::ofItem(control, i, wishes.size());
        std::visit([&](const auto& wish) { plan.add(wish, portion); }, wishes[i]);
    }
    return std::move(plan).finished();
}

} // namespace knead
