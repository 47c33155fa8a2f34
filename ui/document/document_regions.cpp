// What is done to faces, objects and whatever else of bodies is selected.
#include "ui/document/document.h"

#include "core/session/region_contents.h"
#include "ui/language/said.h"
#include "ui/selection/selection_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

bool isOfOneFilling(Level level)
{
    return level == Level::Edge || level == Level::Connection;
}

/// Objects of another filling in whose cells the objects of this one lie.
Region::Items takenOver(const Region::Items& items, const Lattice& from, const Lattice& to)
{
    Region::Items result;
    for (ObjectIndex object = 0; object < to.size(); ++object) {
        const Vec3 place = from.coordinates(to.position(object));
        const auto round = [](double x) { return static_cast<std::int32_t>(std::lround(x)); };
        const ObjectIndex before = from.find({round(place.x()), round(place.y()), round(place.z())});
        if (before < from.size() && std::binary_search(items.begin(), items.end(), Region::Item{before}))
            result.push_back(object);
    }
    return result;
}

} // namespace

void Document::fixRegion(const Region& region)
{
    const auto again = [this, region] { fixRegion(region); };
    if (laterHere(again) || whenFixturesAreKnown(again))
        return;
    std::uint32_t key = 0;
    const bool isOfFaces = region.level == Level::Face;
    const auto objects = isOfFaces ? std::map<BodyId, std::vector<ObjectIndex>>() : objectsOf(region, *m_content);
    for (const auto& [body, items] : region.items) {
        if (refuseLocked({Selection::Kind::Body, body}) || (!isOfFaces && !objects.contains(body)))
            continue;
        FaceFixtures::Edit edit = isOfFaces ? m_fixtures.add(*m_content, body, {items.begin(), items.end()})
                                            : m_fixtures.addObjects(body, objects.at(body));
        key = edit.key;
        postAll(std::move(edit.commands), Message("Document", "Fix selection"));
    }
    if (key == 0)
        return;
    noticeEmptyFixtures();
    select({Selection::Kind::Fixture, key});
    emit changed(Change::Fixtures);
}

void Document::setMaterialOf(const Region& region, const Material& material, const Message& name)
{
    if (laterHere([this, region, material, name] { setMaterialOf(region, material, name); }))
        return;
    const auto objects = objectsOf(region, *m_content);
    if (objects.empty() && !region.isEmpty())
        emit notice(
            tr("The selection holds no objects: it is smaller than the spacing. Choose a finer spacing and refill."));
    for (const auto& [body, own] : objects) {
        SetMaterial command{.body = body, .material = material, .objects = own};
        if (region.level == Level::Part)
            command.objects.clear();
        post(std::move(command), name.empty() ? Message("Document", "Material of selection")
                                              : Message("Document", "Material of selection → %1").with(name));
    }
}

void Document::renormalizeRegion(const Region& region)
{
    if (laterHere([this, region] { renormalizeRegion(region); }))
        return;
    for (const auto& [body, objects] : objectsOf(region, *m_content)) {
        if (m_frame->snapshot->bodies[body].kind != BodyKind::deformable)
            continue;
        Renormalize command{.body = body, .objects = objects};
        if (region.level == Level::Part)
            command.objects.clear();
        post(std::move(command), Message("Document", "Re-normalize selection"));
    }
}

void Document::setKindOf(const Region& region, BodyKind kind)
{
    if (laterHere([this, region, kind] { setKindOf(region, kind); }))
        return;
    for (const auto& [body, items] : region.items)
        post(SetBodyKind{body, kind});
}

bool Document::keepSet(const QString& name, const Region& region)
{
    if (name.trimmed().isEmpty() || region.isEmpty())
        return false;
    SelectionSet set{.name = name.trimmed().toStdString(), .level = region.level, .start = m_start, .items = {}};
    for (const auto& [body, items] : region.items)
        if (body < m_content->bodies.size())
            set.items[m_content->bodies[body]->part] = items;
    if (set.items.empty())
        return false;
    m_notes->putSet(std::move(set));
    return true;
}

Region Document::regionOf(const SelectionSet& set)
{
    Region region;
    region.level = set.level;
    const bool isOfHere = set.start == m_start;
    if (!isOfHere && isOfOneFilling(set.level)) {
        emit notice(said(
            Message("Document",
                    "\"%1\" names edges or connections of another filling: undo to go back to that, or select them "
                    "again and save them under this name.")
                .with(set.name)));
        return region;
    }
    const auto& starts = m_history.starts();
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const auto found = set.items.find(m_content->bodies[body]->part);
        if (found == set.items.end())
            continue;
        Region::Items items = found->second;
        const Lattice& lattice = m_content->bodies[body]->aggregate->lattice;
        if (set.level == Level::Object && !isOfHere && set.start < starts.size()) {
            const ProjectStart& start = starts[set.start].start;
            for (std::size_t b = 0; b < start.partOfBody.size(); ++b)
                if (start.partOfBody[b] == found->first)
                    items = takenOver(found->second, start.scene.bodies[b].aggregate->lattice, lattice);
        }
        const std::size_t count = set.level == Level::Part     ? 1
                                  : set.level == Level::Face   ? m_content->model->parts[found->first].faces.size()
                                  : set.level == Level::Edge   ? m_content->bodies[body]->render.chains
                                  : set.level == Level::Object ? lattice.size()
                                                               : 0;
        std::erase_if(items, [&](Region::Item item) { // of a damaged project
            return set.level == Level::Connection ? !isConnection(*m_content->bodies[body]->aggregate, item)
                                                  : item >= count;
        });
        if (!items.empty())
            region.items[body] = std::move(items);
    }
    return region;
}

} // namespace knead
