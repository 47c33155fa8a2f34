#include "ui/help/help_feature.h"

#include "ui/commands/make_action.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/exporting/export_feature.h"
#include "ui/help/handbook.h"
#include "ui/help/handbook_window.h"
#include "ui/help/tour_steps.h"
#include "ui/importing/import_feature.h"
#include "ui/interaction/hands.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QMainWindow>
#include <QMessageBox>
#include <QSettings>

#include <algorithm>
#include <string>
#include <vector>

namespace knead {

namespace {

constexpr const char* tourPart = "lump.step";
constexpr const char* tourMaterial = "modeling-clay";
constexpr double tourRadius = 0.13; // of a thumb, in sizes of the part: as a large one of a fist of clay
constexpr const char* strengthBeforeTour = "tour/strengthBefore";
constexpr double tourStrength = 2.5; // so that a dent is seen after half a second

/// Other than QWidget::isAncestorOf(): also of what is a window of its own.
bool belongsTo(const QWidget& window, const QWidget* widget)
{
    while (widget != nullptr && widget != &window)
        widget = widget->parentWidget();
    return widget != nullptr;
}

/// A key that is to be given to a command does nothing else.
bool takesKey(const QWidget* widget, const QKeyEvent& event)
{
    if (widget->testAttribute(Qt::WA_InputMethodEnabled) && !event.text().isEmpty() && event.text()[0].isPrint())
        return true;
    for (; widget != nullptr; widget = widget->parentWidget())
        if (qobject_cast<const QKeySequenceEdit*>(widget) != nullptr)
            return true;
    return false;
}

} // namespace

HelpFeature::Actions::Actions(QWidget& window)
    : handbook(makeAction(window, {"handbook", QT_TRANSLATE_NOOP("Actions", "&Handbook"), nullptr, "F1",
                                   QT_TRANSLATE_NOOP("Actions", "At the page of what one does")}))
    , tour(makeAction(window, {"tour", QT_TRANSLATE_NOOP("Actions", "&Tour on a block of clay"), nullptr, "",
                               QT_TRANSLATE_NOOP("Actions", "Press it, pull it, export it: in two minutes")}))
    , controls(makeAction(window, {"controls", QT_TRANSLATE_NOOP("Actions", "Mouse and keys")}))
    , about(makeAction(window, {"about", QT_TRANSLATE_NOOP("Actions", "About Knead")}))
{
}

HelpFeature::HelpFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
{
    connect(m_actions.handbook, &QAction::triggered, this, [this] {
        const QWidget* at = QApplication::focusWidget();
        openHandbookAt(at != nullptr ? at : QApplication::activeWindow());
    });
    connect(m_actions.tour, &QAction::triggered, this, &HelpFeature::beginTour);
    connect(m_actions.controls, &QAction::triggered, this, &HelpFeature::showControls);
    connect(m_actions.about, &QAction::triggered, this, &HelpFeature::showAbout);
    connect(&bench.document, &Document::changed, this, &HelpFeature::followDocument);
    qApp->installEventFilter(this);
}

HelpFeature::~HelpFeature()
{
    if (m_tour != nullptr)
        m_tour->close(); // what it chose is as it was
    delete m_tour;
}

/// Keys of the window do not reach its dialogs, so the one of the handbook is looked for there.
bool HelpFeature::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto* widget = qobject_cast<const QWidget*>(watched);
    const auto& key = *static_cast<const QKeyEvent*>(event);
    if (widget == nullptr || widget->window() == &m_bench.window || takesKey(widget, key))
        return false;
    const auto* dialog = qobject_cast<const QDialog*>(widget->window());
    if (dialog == nullptr || dialog == m_handbook || !belongsTo(m_bench.window, dialog) ||
        !m_actions.handbook->shortcuts().contains(QKeySequence(key.keyCombination())))
        return false;
    openHandbookAt(widget);
    return true;
}

/// Where the keyboard is, the innermost thing that a page is about; in the view, what the mouse does there.
QString HelpFeature::pageAt(const QWidget* place) const
{
    for (const QWidget* at = place; at != nullptr; at = at->parentWidget()) {
        if (at->objectName() == QLatin1String("propertiesDock"))
            return m_bench.document.selection().kind == Selection::Kind::Tool   ? "hands"
                   : m_bench.document.selection().kind == Selection::Kind::Body ? "measuring"
                                                                                : "selecting";
        if (const QString page = handbook::pageOfPlace(at->objectName()); !page.isEmpty())
            return page;
    }
    const QList<QAction*> modes = m_places ? m_places->hands.modes() : QList<QAction*>();
    if (std::ranges::any_of(modes, &QAction::isChecked))
        return "hands";
    return m_bench.viewport.hasMode() ? "measuring" : "keys";
}

/// Over a dialog that keeps the window waiting it belongs to that, else it would wait, too.
void HelpFeature::openHandbookAt(const QWidget* place)
{
    QWidget* owner = &m_bench.window;
    auto* dialog = place != nullptr ? qobject_cast<QDialog*>(place->window()) : nullptr;
    if (dialog != nullptr && dialog->isModal())
        owner = dialog;
    if (m_handbook == nullptr)
        m_handbook = new HandbookWindow(owner);
    else if (m_handbook->parentWidget() != owner)
        m_handbook->setParent(owner, m_handbook->windowFlags());
    if (owner == dialog)
        connect(dialog, &QDialog::finished, m_handbook, [this] {
            const bool wasShown = m_handbook->isVisible();
            m_handbook->setParent(&m_bench.window, m_handbook->windowFlags());
            m_handbook->setVisible(wasShown);
        });
    m_handbook->open(pageAt(place));
}

void HelpFeature::setPlaces(const Places& places)
{
    m_places.emplace(places);
    const QVariant before = QSettings().value(strengthBeforeTour);
    if (!before.isValid())
        return;
    HandChoices choices = places.hands.settings().choices(); // the program ended in the middle of a tour
    choices.sculptStrength = before.toDouble();
    places.hands.settings().set(choices);
    QSettings().remove(strengthBeforeTour);
}

void HelpFeature::beginTour()
{
    const QString part = QDir(QString::fromStdString(m_bench.services.examplesFolder)).filePath(tourPart);
    m_places->imports.openOf(tourMaterial, part, [this] { showTour(); });
}

/// On what was just opened.
void HelpFeature::showTour()
{
    if (m_tour != nullptr)
        m_tour->close();
    const TourSources sources{m_bench,           m_places->hands,   *m_places->exports.action(),
                              m_places->toolBar, m_places->brushes, m_places->banner};
    m_tour = new Tour(m_bench.window, claySteps(sources), m_bench.viewport);
    connect(m_tour, &Tour::ended, this, &HelpFeature::endTour);
    HandSettings& settings = m_places->hands.settings();
    HandChoices choices = settings.choices();
    m_strengthBefore = choices.sculptStrength;
    QSettings().setValue(strengthBeforeTour, m_strengthBefore); // for when the program ends in the middle
    choices.sculptStrength = tourStrength;
    choices.sculptRadius = tourRadius * m_bench.document.size();
    settings.set(choices);
    m_tour->begin();
}

/// What was chosen for it is as it was, unless the person chose otherwise meanwhile.
void HelpFeature::endTour()
{
    HandSettings& settings = m_places->hands.settings();
    HandChoices choices = settings.choices();
    if (choices.sculptStrength == tourStrength)
        choices.sculptStrength = m_strengthBefore;
    if (choices.sculptRadius == tourRadius * m_bench.document.size())
        choices.sculptRadius = 0; // goes by the part
    settings.set(choices);
    QSettings().remove(strengthBeforeTour);
    if (const QWidget* at = QApplication::focusWidget(); at != nullptr && m_tour->isAncestorOf(at))
        m_bench.viewport.setFocus();
}

/// Another part is not the tour's.
void HelpFeature::followDocument(Document::Change what)
{
    if (what == Document::Change::Frame && m_tour != nullptr && m_tour->isVisible())
        m_tour->look(); // what was done may be over soon
    if (what == Document::Change::Model && m_tour != nullptr) {
        const std::vector<std::string>& paths = m_bench.document.content().request.paths;
        if (paths.size() != 1 || QFileInfo(QFile::decodeName(paths.front().c_str())).fileName() != tourPart)
            m_tour->close();
    }
}

void HelpFeature::showAbout()
{
    auto* about = new AboutDialog(m_bench.services.libraries, &m_bench.window);
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->open();
}

void HelpFeature::showControls()
{
    const NavigationPreset& navigation = m_bench.viewport.navigation();
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Mouse and keys"), {}, QMessageBox::Close, &m_bench.window);
    box->setObjectName("controlsBox");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::RichText);
    box->setText(
        tr("<table cellpadding=3>"
           "<tr><td><b>Left button</b></td><td>select; drag a tool</td></tr>"
           "<tr><td><b>%1</b></td><td>orbit</td></tr>"
           "<tr><td><b>%2</b></td><td>pan</td></tr>"
           "<tr><td><b>Wheel</b></td><td>zoom to the cursor</td></tr>"
           "<tr><td><b>Arrows, PgUp, PgDn</b></td><td>drive the selected tool; Shift is slower</td></tr>"
           "<tr><td><b>Space, . , Backspace</b></td><td>play or pause, one step, reset</td></tr>"
           "<tr><td><b>B, X, Del</b></td><td>add a block, fix faces, remove</td></tr>"
           "<tr><td><b>G, N</b></td><td>gravity, re-normalize</td></tr>"
           "<tr><td><b>O, H, E</b></td><td>objects, hide body, edges</td></tr>"
           "<tr><td><b>0, 7, 8, 9</b></td><td>isometric, top, front, right; Ctrl: from the other side</td></tr>"
           "<tr><td><b>1, 2, 3, 4</b></td><td>clicks select parts, faces, edges, objects; Ctrl adds</td></tr>"
           "<tr><td><b>5, F</b></td><td>perspective or parallel, fit</td></tr>"
           "<tr><td><b>Ctrl+S</b></td><td>save the project; Ctrl+Shift+S under another name</td></tr>"
           "<tr><td><b>Shift+F1, F2, F4</b></td><td>one, two, four views; V: the active view alone</td></tr>"
           "<tr><td><b>Ctrl+K</b></td><td>find any command; F11: full screen</td></tr>"
           "<tr><td><b>Esc</b></td><td>cancel</td></tr></table>")
            .arg(navigation.nameOf(NavigationMotion::orbit), navigation.nameOf(NavigationMotion::pan)));
    box->open();
}

} // namespace knead
