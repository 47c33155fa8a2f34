#include "ui/interaction/hands.h"

#include "ui/commands/availability.h"
#include "ui/interaction/gizmo_hand.h"
#include "ui/interaction/hand_panel.h"
#include "ui/interaction/key_hand.h"
#include "ui/interaction/press_hand.h"
#include "ui/interaction/pull_hand.h"
#include "ui/interaction/space_hand.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>

namespace knead {

Hands::Hands(const Workbench& bench)
    : QObject(&bench.viewport)
    , m_bench(bench)
    , m_keyHand(new KeyHand(bench.document, bench.viewport, m_settings))
    , m_pressHand(new PressHand(bench.document, bench.viewport))
    , m_pullHand(new PullHand(bench.document, bench.viewport, m_settings))
    , m_gizmoHand(new GizmoHand(bench.document, bench.viewport, m_settings))
    , m_spaceHand(new SpaceHand(bench.document, bench.viewport, m_settings))
{
    makeActions();
    connectActions();
    bench.availability.needBodies({m_gizmo, m_ownAxes, m_keys, m_press, m_pull, m_forces, m_forceTable});
}

QAction* Hands::make(const char* name, const QString& text, const char* picture, const QKeySequence& key,
                     const QString& tip, bool isCheckable)
{
    auto* action = new QAction(icon(picture), text, &m_bench.window);
    action->setObjectName(name);
    action->setShortcut(key);
    action->setCheckable(isCheckable);
    action->setToolTip(tip);
    m_bench.window.addAction(action);
    return action;
}

void Hands::makeActions()
{
    m_gizmo = make("gizmo", tr("Handles"), "gizmo", Qt::Key_F3,
                   tr("Show handles on the selected tool to move and turn it; Ctrl: in steps; type numbers"));
    m_gizmo->setChecked(true);
    m_ownAxes = make("ownAxes", tr("Along the tool's own axes"), "gizmo", {},
                     tr("Handles lie along the axes of the tool, not of the world"));
    m_keys = make("driveByKeys", tr("Drive by keys"), "keys", Qt::Key_F4,
                  tr("Drive up to three tools with the keyboard, each with keys of its own"));
    m_press =
        make("press", tr("Press material"), "press", Qt::Key_F5,
             tr("Press on the part: the selected tool, or a thumb, comes straight onto it and goes in until its force "
                "limit holds it"));
    m_pull = make("pull", tr("Pull material"), "pull", Qt::Key_F6,
                  tr("Press on the part and pull its material with a spring"));
    m_spaceMouse = make("spaceMouseTool", tr("3D mouse drives tool"), "space-mouse", Qt::Key_F7,
                        tr("The 3D mouse moves the selected tool, not the camera"));
    m_forces = make("forces", tr("Forces on tools"), "force", Qt::Key_F8,
                    tr("Show the force of the material on each tool as an arrow with its number"));
    m_forces->setChecked(true);
    m_forcePlot = make("forcePlot", tr("Plot of forces"), "plot", Qt::Key_F9, tr("Show forces over time"), false);
    m_forceTable = make("exportForces", tr("Forces as table..."), "export", {},
                        tr("Write the forces over time as a CSV file"), false);
}

void Hands::connectActions()
{
    connect(m_gizmo, &QAction::toggled, m_gizmoHand, &GizmoHand::setOn);
    connect(m_keys, &QAction::toggled, this, [this](bool on) {
        m_keyHand->setOn(on);
        if (on)
            m_bench.viewport.setFocus();
        emit modeChanged();
    });
    connect(m_pull, &QAction::toggled, this, [this](bool on) {
        m_pullHand->setOn(on);
        emit modeChanged();
    });
    connect(m_press, &QAction::toggled, this, [this](bool on) {
        m_pressHand->setOn(on);
        emit modeChanged();
    });
    connect(m_forces, &QAction::toggled, this, [this](bool on) {
        SceneOptions options = m_bench.viewport.options();
        options.forces = on;
        m_bench.viewport.setOptions(options);
    });
    keep(m_gizmo, &HandChoices::handles);
    keep(m_ownAxes, &HandChoices::ownAxes);
    keep(m_forces, &HandChoices::forces);
    keep(m_spaceMouse, &HandChoices::spaceMouseDrivesTool);
    connect(m_pressHand, &PressHand::refused, this, &Hands::problem);
    connect(m_pullHand, &PullHand::refused, this, &Hands::problem);
}

/// The action shows a choice of the person, and is one way to make it.
void Hands::keep(QAction* action, bool HandChoices::*choice)
{
    connect(action, &QAction::toggled, this, [this, choice](bool on) {
        HandChoices choices = m_settings.choices();
        choices.*choice = on;
        m_settings.set(choices);
    });
    const auto show = [this, action, choice] { action->setChecked(m_settings.choices().*choice); };
    connect(&m_settings, &HandSettings::changed, this, show);
    show();
}

HandPanel* Hands::makePanel()
{
    auto* panel = new HandPanel(m_settings, {m_gizmo, m_keys, m_press, m_pull});
    connect(m_spaceHand, &SpaceHand::connectionChanged, panel, &HandPanel::showSpaceMouse);
    return panel;
}

void Hands::addTo(QMenu* menu) const
{
    menu->addSeparator();
    menu->addActions({m_gizmo, m_ownAxes, m_keys, m_press, m_pull, m_spaceMouse});
    menu->addSeparator();
    menu->addActions({m_forces, m_forcePlot, m_forceTable});
}

void Hands::listen(const ListenToSpaceMouse& listen)
{
    m_spaceHand->listen(listen);
}

bool Hands::leaveKeys()
{
    const bool wereOn = m_keys->isChecked();
    m_keys->setChecked(false);
    return wereOn;
}

QString Hands::hint() const
{
    if (m_press->isChecked())
        return tr("Press and hold: the tool goes in until its force limit holds it   Esc: done");
    if (m_pull->isChecked())
        return tr("Press on the part and pull   Esc: done");
    if (m_keys->isChecked())
        return tr("Keys drive tools   Shift: slower   Esc: done");
    return {};
}

} // namespace knead
