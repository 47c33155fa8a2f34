#include "ui/interaction/hands.h"

#include "ui/commands/availability.h"
#include "ui/commands/strip_keys.h"
#include "ui/interaction/gizmo_hand.h"
#include "ui/interaction/hand_panel.h"
#include "ui/interaction/key_hand.h"
#include "ui/interaction/press_hand.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/interaction/space_hand.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

namespace knead {

Hands::Hands(const Workbench& bench)
    : QObject(&bench.viewport)
    , m_bench(bench)
    , m_keyHand(new KeyHand(bench.document, bench.viewport, m_settings))
    , m_pressHand(new PressHand(bench.document, bench.viewport))
    , m_sculptHand(new SculptHand(bench.document, bench.viewport, m_settings))
    , m_gizmoHand(new GizmoHand(bench.document, bench.viewport, m_settings))
    , m_spaceHand(new SpaceHand(bench.document, bench.viewport, m_settings))
{
    makeActions();
    connectActions();
    bench.availability.needBodies({m_gizmo, m_ownAxes, m_keys, m_forces, m_forceTable, m_forcesOfStrokes});
    bench.availability.needBodies(modes());
    bench.availability.needBodies({m_brushChanges.begin(), m_brushChanges.end()});
}

QAction* Hands::make(const char* name, const QString& text, const char* picture, const QKeySequence& key,
                     const QString& tip, bool isCheckable)
{
    auto* action = new QAction(picture == nullptr ? QIcon() : icon(picture), text, &m_bench.window);
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
    makeBrushes();
    m_spaceMouse = make("spaceMouseTool", tr("3D mouse drives tool"), "space-mouse", Qt::Key_F7,
                        tr("The 3D mouse moves the selected tool, not the camera"));
    m_forces = make("forces", tr("Forces on tools"), "force", Qt::Key_F8,
                    tr("Show the force of the material on each tool as an arrow with its number"));
    m_forces->setChecked(true);
    m_forcePlot = make("forcePlot", tr("Plot of forces"), "plot", Qt::Key_F9, tr("Show forces over time"), false);
    m_forceTable = make("exportForces", tr("Forces as table..."), "export", {},
                        tr("Write the forces over time as a CSV file"), false);
    m_forcesOfStrokes = make("forcesOfStrokes", tr("Forces of brushes, too"), nullptr, {},
                             tr("Fingers and grips of brushes have lines in the plot and columns in the table, too"));
}

void Hands::makeBrushes()
{
    m_brushes = {
        make("pull", tr("Pull material"), "pull", Qt::Key_F6,
             tr("Press on the part and pull its material with a spring")),
        make("sculptThumb", tr("Thumb"), "sculpt-thumb", Qt::Key_T,
             tr("Press and hold: a ball goes in until its force limit holds it; draw it along for a groove")),
        make("sculptSmooth", tr("Smooth"), "sculpt-smooth", Qt::Key_S,
             tr("Roll a large ball over the surface, which levels what stands out")),
        make("sculptFlatten", tr("Flatten"), "sculpt-flatten", Qt::Key_K,
             tr("Press a disc down to the plane that the surface has where you begin")),
        make("sculptPinch", tr("Pinch"), "sculpt-pinch", Qt::Key_C,
             tr("Draw material together with four fingers, as for a ridge")),
        make("sculptSmear", tr("Smear"), "sculpt-smear", Qt::Key_Y,
             tr("Take the surface along with a ball that grips it")),
        make("sculptBend", tr("Bend here"), "sculpt-bend", Qt::Key_U,
             tr("Tilt the material at the cursor towards where you draw")),
        make("sculptTwist", tr("Twist here"), "sculpt-twist", Qt::Key_W,
             tr("Turn the material at the cursor about its normal: draw to the right or left")),
    };
    m_mirrors = {
        make("mirrorX", tr("Symmetric in X"), "mirror-x", Qt::SHIFT | Qt::Key_X,
             tr("Brushes do the same on the other side of the middle, along X")),
        make("mirrorY", tr("Symmetric in Y"), "mirror-y", Qt::SHIFT | Qt::Key_Y,
             tr("Brushes do the same on the other side of the middle, along Y")),
        make("mirrorZ", tr("Symmetric in Z"), "mirror-z", Qt::SHIFT | Qt::Key_Z,
             tr("Brushes do the same on the other side of the middle, along Z")),
    };
    m_holdsRest = make("holdsRest", tr("Hold the rest"), nullptr, {},
                       tr("What is far from a brush is held as by the other hand, where nothing else holds the part"));
    constexpr double factor = 1.15;
    const auto add = [&](const char* name, const QString& text, Qt::Key key, const QString& tip, auto change) {
        QAction* action = make(name, text, nullptr, key, tip, false);
        connect(action, &QAction::triggered, this, change);
        m_brushChanges.push_back(action);
    };
    add("brushWeaker", tr("Weaker brush"), Qt::Key_Minus, tr("Also with Shift and the mouse wheel"),
        [this] { m_sculptHand->changeStrength(1 / factor); });
    add("brushStronger", tr("Stronger brush"), Qt::Key_Plus, tr("Also with Shift and the mouse wheel"),
        [this] { m_sculptHand->changeStrength(factor); });
}

QList<QAction*> Hands::modes() const
{
    QList<QAction*> modes{m_press};
    modes.append({m_brushes.begin(), m_brushes.end()});
    return modes;
}

/// Upright, beside the view.
QToolBar* Hands::newSculptBar(QWidget* parent) const
{
    auto* bar = new QToolBar(tr("Sculpting"), parent);
    bar->setObjectName("sculptBar");
    bar->setOrientation(Qt::Vertical);
    bar->setIconSize({20, 20});
    bar->setStyleSheet("QToolBar { border: none; border-left: 1px solid palette(mid); padding: 6px 3px; }");
    bar->addActions({m_brushes.begin(), m_brushes.end()});
    bar->addSeparator();
    bar->addActions({m_mirrors.begin(), m_mirrors.end()});
    new StripKeys(*bar);
    return bar;
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
    for (std::size_t brush = 0; brush < m_brushes.size(); ++brush)
        connect(m_brushes[brush], &QAction::toggled, this, [this, which = static_cast<SculptBrush>(brush)](bool on) {
            if (on || m_sculptHand->brush() == which)
                m_sculptHand->setBrush(on ? std::optional(which) : std::nullopt);
            emit modeChanged();
        });
    keep(m_holdsRest, &HandChoices::holdsRest);
    keep(m_mirrors[0], &HandChoices::mirrorX);
    keep(m_mirrors[1], &HandChoices::mirrorY);
    keep(m_mirrors[2], &HandChoices::mirrorZ);
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
    connect(m_sculptHand, &SculptHand::refused, this, &Hands::problem);
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
    auto* panel = new HandPanel(m_settings, {m_gizmo, m_keys, m_press, m_brushes[0]});
    connect(m_spaceHand, &SpaceHand::connectionChanged, panel, &HandPanel::showSpaceMouse);
    return panel;
}

void Hands::addTo(QMenu* menu) const
{
    menu->addSeparator();
    menu->addActions({m_gizmo, m_ownAxes, m_keys, m_press});
    QMenu* sculpt = menu->addMenu(tr("Sculpt"));
    sculpt->addActions({m_brushes.begin(), m_brushes.end()});
    sculpt->addSeparator();
    sculpt->addActions({m_mirrors.begin(), m_mirrors.end()});
    sculpt->addAction(m_holdsRest);
    sculpt->addSeparator();
    sculpt->addActions({m_brushChanges.begin(), m_brushChanges.end()});
    menu->addAction(m_spaceMouse);
    menu->addSeparator();
    menu->addActions({m_forces, m_forcePlot, m_forceTable, m_forcesOfStrokes});
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

bool Hands::changeBrush(double factor) const
{
    if (!m_sculptHand->brush())
        return false;
    m_sculptHand->changeRadius(factor);
    return true;
}

QString Hands::hint() const
{
    if (m_press->isChecked())
        return tr("Press and hold: the tool goes in until its force limit holds it   Esc: done");
    if (m_sculptHand->brush())
        return tr("Press on the part and draw   [ ]: radius   Shift+wheel: force   Esc: done");
    if (m_keys->isChecked())
        return tr("Keys drive tools   Shift: slower   Esc: done");
    return {};
}

} // namespace knead
