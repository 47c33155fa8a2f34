// What a newly opened part is pressed with, so that a person sees what it does.
#include "ui/document/document.h"

#include "core/simulation/first_press.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace knead {

namespace {

std::vector<ObjectIndex> objectsIn(const Box& box, const Lattice& lattice)
{
    std::vector<ObjectIndex> objects;
    for (ObjectIndex object = 0; object < lattice.size(); ++object)
        if (box.contains(lattice.position(object)))
            objects.push_back(object);
    return objects;
}

/// What breaks first decides.
double bearableStrain(const std::vector<Material>& materials)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Material& material : materials)
        least = std::min(least, strainAtBreak(material));
    return least;
}

} // namespace

bool Document::canPressIt() const
{
    if (isEmpty() || m_content->bodies.empty() || m_isPlaying || m_hasScript || isGoing())
        return false;
    const Snapshot& now = *m_frame->snapshot;
    const std::vector<Part>& parts = m_content->model->parts;
    return now.time == 0 && now.tools.empty() && now.fixtures.empty() &&
           std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.canBeFilled(); }) &&
           std::any_of(now.bodies.begin(), now.bodies.end(),
                       [](const auto& body) { return body.kind == BodyKind::deformable; });
}

void Document::pressIt()
{
    const auto again = [this] { pressIt(); };
    if (laterHere(again) || whenFixturesAreKnown(again) || !canPressIt())
        return;
    FirstPress press = firstPress(*m_content->model, bearableStrain(m_frame->snapshot->materials));
    const Message name = Message("Document", "Press it");
    beginGesture();
    if (press.bends && m_frame->snapshot->floorHeight)
        post(SetFloor{}, name);
    for (BodyId body = 0; body < m_content->bodies.size(); ++body)
        if (std::vector<ObjectIndex> held = objectsIn(press.held, m_content->bodies[body]->aggregate->lattice);
            !held.empty())
            postAll(m_fixtures.addObjects(body, std::move(held)).commands, name);
    m_toolToSelect = press.block.name = tr("Block").toStdString();
    post(AddManipulator{std::move(press.block)}, name);
    endGesture();
    emit changed(Change::Fixtures);
    play();
}

} // namespace knead
