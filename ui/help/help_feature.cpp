#include "ui/help/help_feature.h"

#include "ui/commands/make_action.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/help/handbook.h"
#include "ui/help/handbook_window.h"
#include "ui/help/tour.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMessageBox>
#include <QSettings>
#include <QTimer>

namespace knead {

namespace {

constexpr const char* tourSeen = "tour/seen";

} // namespace

HelpFeature::Actions::Actions(QWidget& window)
    : handbook(makeAction(window, {"handbook", QT_TRANSLATE_NOOP("Actions", "&Handbook"), nullptr, "F1",
                                   QT_TRANSLATE_NOOP("Actions", "At the page of what one does")}))
    , tour(makeAction(window, {"tour", QT_TRANSLATE_NOOP("Actions", "&Tour of the window"), nullptr, "",
                               QT_TRANSLATE_NOOP("Actions", "What is where, in a minute")}))
    , controls(makeAction(window, {"controls", QT_TRANSLATE_NOOP("Actions", "Mouse and keys")}))
    , about(makeAction(window, {"about", QT_TRANSLATE_NOOP("Actions", "About Knead")}))
{
}

HelpFeature::HelpFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
{
    connect(m_actions.handbook, &QAction::triggered, this, &HelpFeature::showHandbook);
    connect(m_actions.tour, &QAction::triggered, this, &HelpFeature::showTour);
    connect(m_actions.controls, &QAction::triggered, this, &HelpFeature::showControls);
    connect(m_actions.about, &QAction::triggered, this, &HelpFeature::showAbout);
}

HelpFeature::~HelpFeature()
{
    delete m_tour;
}

/// At the page of the panel that has the keyboard.
void HelpFeature::showHandbook()
{
    QString dock;
    for (const QWidget* at = QApplication::focusWidget(); at != nullptr && dock.isEmpty(); at = at->parentWidget())
        if (qobject_cast<const QDockWidget*>(at) != nullptr)
            dock = at->objectName();
    if (m_handbook == nullptr)
        m_handbook = new HandbookWindow(&m_bench.window);
    m_handbook->open(handbook::pageOfDock(dock));
}

/// At the first start.
void HelpFeature::offerTour()
{
    if (!QSettings().value(tourSeen).toBool())
        QTimer::singleShot(0, this, &HelpFeature::showTour);
}

void HelpFeature::showTour()
{
    QSettings().setValue(tourSeen, true);
    if (m_tour == nullptr)
        m_tour = new Tour(m_bench.window, windowTour(m_bench, *m_toolBar));
    m_tour->begin();
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
