// Grips deform bodies on another thread, as a way on from the present entry: nothing is seen of it before it is there.
#include "ui/document/document.h"

#include "core/simulation/moment.h"
#include "ui/language/said.h"
#include "ui/tasks/task_runner.h"

#include <utility>

namespace knead {

void Document::deformByPhysics(const PhysicalDeformation& deformation, const std::vector<bool>& which,
                               const QString& title, const Message& name)
{
    const auto again = [this, deformation, which, title, name] { deformByPhysics(deformation, which, title, name); };
    if (m_tasks == nullptr || m_history.isEmpty() || laterHere(again))
        return;
    if (m_isPlaying || m_gesture.isAny || !m_history.isSettled()) {
        standStill();
        whenSettled(again);
        return;
    }
    setOutToDeform(deformation, which, title, name);
}

void Document::setOutToDeform(const PhysicalDeformation& deformation, const std::vector<bool>& which,
                              const QString& title, const Message& name)
{
    std::vector<std::string> names;
    for (BodyId body = 0; body < m_content->bodies.size(); ++body)
        names.push_back(nameOfBody(body).toStdString());
    m_target = m_shown;
    m_navigation = NavigationState::looking;
    ++m_travels;
    m_longTitle = title;
    const auto work = [navigation = navigationTo(m_target), deformation, names, which,
                       film = PlaybackCache::defaultMemory](TaskControl& control) {
        TaskPortion going(control, 0, 0.05);
        Simulation simulation(navigation.start.start.scene);
        simulation.goTo(navigation.go(going).moment);
        TaskPortion deforming(control, 0.05, 1);
        return knead::deformByPhysics(std::move(simulation), deformation, names, which, film, deforming);
    };
    const auto finish = [this, name, travel = m_travels](DeformedByPhysics done) {
        if (travel == m_travels)
            arriveDeformed(std::move(done), name);
    };
    if (!m_tasks->run<DeformedByPhysics>(m_longTitle, work, finish))
        giveUp(said(Message("Document", "%1 is still going on: wait for it, or cancel it with Esc, then deform again.")
                        .with(m_tasks->title().toStdString())));
}

void Document::arriveDeformed(DeformedByPhysics done, const Message& name)
{
    if (m_history.tree().current() != m_target) {
        endNavigation();
        return;
    }
    const MomentPointer moment = done.gesture.moment;
    m_history.expect(name)(std::move(done.gesture));
    goInSimulation(moment);
    m_playback.goOnWith(std::move(done.film));
}

} // namespace knead
