#include "ui/display.h"

#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/language/said.h"
#include "ui/theme.h"
#include "ui/viewport/surface_field_overlay.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr const char* quantityNames[surfaceQuantityCount] = {"displacement",  "strain",       "vonMisesStress",
                                                             "plasticStrain", "contactForce", "distance"};

constexpr const char* shadingNames[] = {"usual",     "clay", "polished", "zebra",
                                        "curvature", "wax",  "chrome",   "porcelain"}; // in the order of Shading

QString settingOf(const QAction* action)
{
    return "display/" + action->objectName();
}

/// -1: the colors of the parts.
int numberOf(const std::optional<SurfaceQuantity>& quantity)
{
    return quantity ? static_cast<int>(*quantity) : -1;
}

} // namespace

Display::Display(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
{
    setObjectName("display");
    makeActions();
    makeEdges();
    connectActions();
    makeColors();
    makeMaps();
    makeShadings();
    makeCuts();
    makeMenu();
    sayWhyNot();
    follow();
    connect(&bench.viewport, &ViewportWidget::optionsChanged, this, &Display::follow);
    connect(&bench.document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            contentChanged();
    });
}

QAction* Display::make(const char* name, const QString& text, const char* picture, const QString& keys,
                       const QString& tip)
{
    auto* action = new QAction(text, &m_bench.window);
    action->setObjectName(name);
    action->setCheckable(true);
    if (picture != nullptr)
        action->setIcon(icon(picture));
    action->setShortcut(QKeySequence(keys));
    action->setToolTip(tip);
    m_bench.window.addAction(action);
    return action;
}

void Display::makeActions()
{
    m_skin = make("skin", tr("Skin"), "skin", "Shift+K",
                  tr("Show the surface of the part; as through glass when what is inside is shown too"));
    m_skin->setChecked(true);
    m_connections = make("connections", tr("Connections"), "connections", "Shift+C",
                         tr("Show the connections between objects as lines"));
    m_original = make("original", tr("Original shape"), "original", "Shift+R",
                      tr("Show the shape at rest, translucent, around what became of it"));
    m_breaks = make("breaks", tr("Broken connections"), "breaks", "Shift+B", tr("Mark where connections broke"));
    m_section = make("section", tr("Section plane"), "section", "Shift+S",
                     tr("Cut the part open to look inside; drag the knob to move the plane"));
    m_flip = make("flipSection", tr("Flip section"), nullptr, "Ctrl+Shift+X", tr("Cut off the other side"));
    m_compare = make("compare", tr("Before and after"), "compare", "Shift+V",
                     tr("Divide the view: the original on the left, the part as it is on the right"));
}

void Display::makeEdges()
{
    QMainWindow& window = m_bench.window;
    m_objects = makeSwitch(window, {"objects", QT_TRANSLATE_NOOP("Actions", "Objects"), "objects", "O",
                                    QT_TRANSLATE_NOOP("Actions", "Show the objects the material is made of")});
    m_allObjects =
        makeSwitch(window, {"allObjects", QT_TRANSLATE_NOOP("Actions", "Inner objects too"), nullptr, "Shift+O"});
    m_edges = makeSwitch(window, {"edges", QT_TRANSLATE_NOOP("Actions", "Edges"), nullptr, "E"}, true);
    m_openEdges = makeSwitch(window,
                             {"openEdges", QT_TRANSLATE_NOOP("Actions", "Open edges"), nullptr, "",
                              QT_TRANSLATE_NOOP("Actions", "Show where surfaces that are not closed end")},
                             true);
    m_grid = makeSwitch(window, {"grid", QT_TRANSLATE_NOOP("Actions", "Grid")}, true);
    m_warnings = makeSwitch(
        window,
        {"warnings", QT_TRANSLATE_NOOP("Actions", "Warnings in the view"), nullptr, "",
         QT_TRANSLATE_NOOP("Actions", "Mark where the part is folded over itself, got thin or is about to break")},
        true);
}

void Display::connectActions()
{
    m_shown = {m_skin,   m_objects, m_allObjects, m_connections, m_original,
               m_breaks, m_edges,   m_openEdges,  m_grid,        m_warnings};
    for (QAction* action : m_shown)
        connect(action, &QAction::toggled, this, &Display::apply);
    for (QAction* action : {m_objects, m_connections})
        connect(action, &QAction::toggled, this, &Display::insideToggled);
    connect(m_section, &QAction::toggled, this, &Display::switchSection);
    connect(m_compare, &QAction::toggled, this, &Display::switchCompare);
    connect(m_flip, &QAction::toggled, this, [this](bool on) {
        m_plane.isFlipped = on;
        applySection();
    });
}

void Display::makeColors()
{
    m_colors = new QActionGroup(this);
    const auto add = [this](const QString& name, const QString& text, int number, const QString& tip) {
        QAction* action = make(name.toLatin1(), text, nullptr, {}, tip);
        action->setData(number);
        m_colors->addAction(action);
        return action;
    };
    add("colorParts", tr("Part colors"), -1, tr("Faces have the colors of the part"))->setChecked(true);
    for (std::size_t i = 0; i < surfaceQuantityCount; ++i) {
        const QString text = nameOf(static_cast<SurfaceQuantity>(i));
        add("color-" + QString(quantityNames[i]), text, static_cast<int>(i),
            said(Message("Display", "Color the skin by: %1").with(termOf(static_cast<SurfaceQuantity>(i)))));
    }
    connect(m_colors, &QActionGroup::triggered, this, [this](const QAction* action) {
        const int number = action->data().toInt();
        setQuantity(number < 0 ? std::nullopt : std::optional(static_cast<SurfaceQuantity>(number)));
    });
}

/// Actions of which one is chosen; their data is their place.
QActionGroup* Display::makeGroup(const std::vector<std::pair<QByteArray, QString>>& names, const QString& tip)
{
    auto* group = new QActionGroup(this);
    for (const auto& [name, text] : names) {
        QAction* action = make(name, text, nullptr, {}, tip);
        action->setData(static_cast<int>(group->actions().size()));
        group->addAction(action);
    }
    return group;
}

void Display::makeMaps()
{
    std::vector<std::pair<QByteArray, QString>> names;
    for (const ColorMapChoice& choice : colorMapChoices())
        names.emplace_back(QByteArray("colorMap") + choice.name,
                           said(Message("Display", "Color map: %1").with(Message("ColorMap", choice.title))));
    m_maps = makeGroup(names, tr("From which colors to which numbers are shown"));
    connect(m_maps, &QActionGroup::triggered, this, [this](const QAction* action) {
        setMap(colorMapChoices()[static_cast<std::size_t>(action->data().toInt())].map);
    });
    m_automatic =
        make("automaticRange", tr("Range as needed"), nullptr, {}, tr("The colors reach as far as the numbers do"));
    connect(m_automatic, &QAction::toggled, this, &Display::switchAutomatic);
}

void Display::makeShadings()
{
    m_shadings = makeGroup({{"shadingUsual", tr("Usual")},
                            {"shadingClay", tr("Clay")},
                            {"shadingPolished", tr("Polished")},
                            {"shadingZebra", tr("Zebra")},
                            {"shadingCurvature", tr("Curvature")},
                            {"shadingWax", tr("Wax")},
                            {"shadingChrome", tr("Chrome")},
                            {"shadingPorcelain", tr("Porcelain")}},
                           {});
    const QString tips[] = {tr("Faces have the colors of the part, in soft light"),
                            tr("All parts in one matt color: nothing but their shape is seen"),
                            tr("Parts shine as polished metal does"),
                            tr("Parts mirror stripes, which break where faces do not join smoothly"),
                            tr("Blue where parts are hollow, white where they are flat, orange where they bulge"),
                            tr("Parts are soft and shine through at their rims"),
                            tr("All parts mirror a sky and the ground, which shows every dent"),
                            tr("All parts are white and glazed")};
    for (QAction* action : m_shadings->actions())
        action->setToolTip(tips[action->data().toInt()]);
    connect(m_shadings, &QActionGroup::triggered, this,
            [this](const QAction* action) { setShading(static_cast<Shading>(action->data().toInt())); });
}

void Display::makeCuts()
{
    m_axes = makeGroup({{"sectionX", tr("Section across X")},
                        {"sectionY", tr("Section across Y")},
                        {"sectionZ", tr("Section across Z")},
                        {"sectionEye", tr("Section towards the eye")}},
                       tr("Cut the part open through its middle"));
    connect(m_axes, &QActionGroup::triggered, this,
            [this](const QAction* action) { setSectionAxis(static_cast<Section::Axis>(action->data().toInt())); });
    m_hatched = make("sectionHatched", tr("Hatched"), nullptr, {}, tr("Draw lines across what is cut"));
    connect(m_hatched, &QAction::toggled, this, &Display::setHatched);
}

void Display::sayWhyNot()
{
    Availability& when = m_bench.availability;
    when.needPart(QList{m_edges, m_openEdges, m_grid} + m_shadings->actions());
    when.needBodies(QList{m_skin, m_objects, m_allObjects, m_connections, m_original, m_breaks, m_warnings, m_section,
                          m_flip, m_compare, m_hatched} +
                    m_colors->actions() + m_axes->actions());
    const auto needQuantity = [this]() -> std::optional<QString> {
        if (view().options().colors.quantity)
            return {};
        return tr("Color the skin by a quantity first.");
    };
    when.add({m_automatic}, needQuantity);
    when.add(m_maps->actions(), [this, needQuantity]() -> std::optional<QString> {
        const std::optional<SurfaceQuantity> quantity = view().options().colors.quantity;
        if (quantity && hasSign(*quantity))
            return tr("This quantity has colors of its own, since it has two signs.");
        return needQuantity();
    });
}

void Display::makeMenu()
{
    m_menu = new QMenu(tr("Display"), &m_bench.window);
    m_menu->setObjectName("displayMenu");
    m_menu->setIcon(icon("display"));
    m_menu->setToolTipsVisible(true);
    m_menu->menuAction()->setToolTip(tr("What is shown of the material, and how"));
    m_menu->addActions({m_skin, m_objects, m_allObjects, m_connections, m_original, m_breaks});
    m_menu->addSeparator();
    QMenu* colors = m_menu->addMenu(icon("colors"), tr("Colors"));
    colors->setObjectName("colorsMenu");
    colors->addActions(m_colors->actions());
    colors->addSeparator();
    colors->addActions(m_maps->actions());
    colors->addSeparator();
    colors->addAction(m_automatic);
    QMenu* shadings = m_menu->addMenu(tr("Shading"));
    shadings->setObjectName("shadingMenu");
    shadings->setToolTipsVisible(true);
    shadings->addActions(m_shadings->actions());
    m_menu->addSeparator();
    m_menu->addActions({m_section, m_flip});
    m_menu->addMenu(tr("Section"))->addActions(m_axes->actions() + QList{m_hatched});
    m_menu->addAction(m_compare);
}

void Display::restore()
{
    const QSettings settings;
    std::vector<std::pair<QAction*, bool>> states; // all are read before switching writes them
    for (QAction* action : m_shown)
        states.emplace_back(action, settings.value(settingOf(action), action->isChecked()).toBool());
    for (const auto& [action, isOn] : states)
        action->setChecked(isOn);
    m_skin->setChecked(states.front().second); // what is inside may have switched it
    SceneOptions options = m_bench.viewport.options();
    const QString quantity = settings.value("display/quantity").toString();
    for (std::size_t i = 0; i < surfaceQuantityCount; ++i)
        if (quantity == quantityNames[i])
            options.colors.quantity = static_cast<SurfaceQuantity>(i);
    for (const ColorMapChoice& choice : colorMapChoices())
        if (settings.value("display/map", 0).toInt() == static_cast<int>(choice.map))
            options.colors.map = choice.map;
    const QString shading = settings.value("display/shading").toString();
    for (std::size_t i = 0; i < std::size(shadingNames); ++i)
        if (shading == shadingNames[i])
            options.shading = static_cast<Shading>(i);
    options.section.isHatched = settings.value("display/hatched", true).toBool();
    m_bench.viewport.setOptions(options);
}

/// What is inside is worth nothing behind an opaque skin: the skin goes with it, and may be called back as glass.
void Display::insideToggled()
{
    m_skin->setChecked(!m_objects->isChecked() && !m_connections->isChecked());
}

void Display::lendObjects(bool on)
{
    if (on == m_lendsObjects || (on && m_objects->isChecked()))
        return;
    m_lendsObjects = on; // before they are switched, which writes what is to be remembered
    m_objects->setChecked(on);
}

void Display::apply()
{
    QSettings settings;
    for (const QAction* action : m_shown)
        if (!m_lendsObjects || (action != m_objects && action != m_skin))
            settings.setValue(settingOf(action), action->isChecked());
    SceneOptions options = m_bench.viewport.options();
    options.skin = m_skin->isChecked();
    options.connections = m_connections->isChecked();
    options.original = m_original->isChecked();
    options.breaks = m_breaks->isChecked();
    options.edges = m_edges->isChecked();
    options.openEdges = m_openEdges->isChecked();
    options.grid = m_grid->isChecked();
    options.warnings = m_warnings->isChecked();
    const ObjectDisplay which = m_allObjects->isChecked() ? ObjectDisplay::All : ObjectDisplay::Surface;
    options.objects = m_objects->isChecked() ? which : ObjectDisplay::Off;
    m_bench.viewport.setOptions(options);
}

void Display::setQuantity(std::optional<SurfaceQuantity> quantity)
{
    SceneOptions options = m_bench.viewport.options();
    if (options.colors.quantity != quantity)
        options.colors.range.reset(); // it was of another quantity
    options.colors.quantity = quantity;
    QSettings().setValue("display/quantity", quantity ? quantityNames[static_cast<std::size_t>(*quantity)] : "");
    m_bench.viewport.setOptions(options);
}

void Display::setMap(ColorMap map)
{
    SceneOptions options = m_bench.viewport.options();
    options.colors.map = map;
    QSettings().setValue("display/map", static_cast<int>(map));
    m_bench.viewport.setOptions(options);
}

void Display::setShading(Shading shading)
{
    SceneOptions options = m_bench.viewport.options();
    options.shading = shading;
    QSettings().setValue("display/shading", shadingNames[static_cast<std::size_t>(shading)]);
    m_bench.viewport.setOptions(options);
}

void Display::setRange(const std::optional<std::pair<double, double>>& range)
{
    SceneOptions options = m_bench.viewport.options();
    options.colors.range = range;
    m_bench.viewport.setOptions(options);
}

std::pair<double, double> Display::sectionReach() const
{
    return reachAlong(m_plane.direction, m_bench.viewport.materialBox());
}

void Display::setSectionAxis(Section::Axis axis)
{
    m_plane.axis = axis;
    m_plane.direction = axis == Section::Axis::eye ? m_bench.viewport.camera().towardsEye()
                                                   : Vec3(Vec3::Unit(static_cast<Eigen::Index>(axis)));
    m_placedIn = m_bench.document.content().box;
    m_plane.offset = m_plane.direction.dot(m_placedIn.center());
    m_isFollowing = true;
    m_section->setChecked(true);
    m_isFollowing = false;
    applySection();
}

void Display::setSectionOffset(double offset)
{
    m_plane.offset = offset;
    applySection();
}

/// In the same part it comes back to where it was.
void Display::switchSection(bool on)
{
    if (m_isFollowing)
        return;
    if (on && !m_placedIn.isApprox(m_bench.document.content().box))
        setSectionAxis(m_plane.axis);
    else
        applySection();
}

void Display::switchCompare(bool on)
{
    if (m_isFollowing)
        return;
    SceneOptions options = m_bench.viewport.options();
    options.divider = on ? std::optional(0.5) : std::nullopt;
    m_bench.viewport.setOptions(options);
}

void Display::switchAutomatic(bool on)
{
    if (m_isFollowing)
        return;
    const std::optional<ColorScale> scale =
        m_bench.viewport.scale(); // a typed range begins with the one that was there
    setRange(!on && scale ? std::optional(std::pair(scale->least, scale->most)) : std::nullopt);
}

void Display::setHatched(bool on)
{
    if (m_isFollowing)
        return;
    SceneOptions options = m_bench.viewport.options();
    options.section.isHatched = on;
    QSettings().setValue("display/hatched", on);
    m_bench.viewport.setOptions(options);
}

void Display::applySection()
{
    SceneOptions options = m_bench.viewport.options();
    const double way = m_plane.isFlipped ? -1 : 1;
    if (m_section->isChecked())
        options.section.plane = CutPlane{way * m_plane.direction, way * m_plane.offset};
    else
        options.section.plane.reset();
    m_bench.viewport.setOptions(options);
}

/// The view has other options: from here, from its knobs, or because it shows another part.
void Display::follow()
{
    const SceneOptions& options = m_bench.viewport.options();
    m_isFollowing = true;
    m_section->setChecked(options.section.plane.has_value());
    m_compare->setChecked(options.divider.has_value());
    m_hatched->setChecked(options.section.isHatched);
    m_automatic->setChecked(options.colors.quantity && !options.colors.range);
    m_isFollowing = false;
    m_bench.availability.update();
    for (QAction* action : m_maps->actions())
        if (colorMapChoices()[static_cast<std::size_t>(action->data().toInt())].map == options.colors.map)
            action->setChecked(true);
    m_shadings->actions().at(static_cast<int>(options.shading))->setChecked(true);
    m_axes->actions().at(static_cast<int>(m_plane.axis))->setChecked(true);
    if (options.section.plane)
        m_plane.offset = (m_plane.isFlipped ? -1 : 1) * options.section.plane->offset;
    for (QAction* action : m_colors->actions())
        if (action->data().toInt() == numberOf(options.colors.quantity))
            action->setChecked(true);
    emit changed();
}

/// Another part looks as what it is made of.
void Display::contentChanged()
{
    const std::shared_ptr<const Model> before = std::exchange(m_opened, m_bench.document.opened());
    if (before != nullptr && before != m_opened)
        setQuantity(std::nullopt);
    follow();
}

} // namespace knead
