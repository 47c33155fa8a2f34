#include "ui/run_window.h"

#include "ui/frame/main_window.h"
#include "ui/language/language.h"
#include "ui/plain_texts.h"
#include "ui/preferences/preferences.h"
#include "ui/project/project_keeper.h"
#include "ui/theme.h"
#include "ui/viewport/graphics_check.h"
#include "ui/viewport/viewport_bridge.h"

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QSurfaceFormat>

#include <cstdio>

namespace knead {

namespace {

constexpr int failed = 1; // exit code

/// Instead of the window.
int tell(const QString& problem)
{
    std::fprintf(stderr, "knead: %s\n", qPrintable(problem));
    constexpr QChar unbroken(0x2011); // a hyphen that ends no line
    QMessageBox box(QMessageBox::NoIcon, QStringLiteral("Knead"), QString(problem).replace('-', unbroken),
                    QMessageBox::Close);
    box.setObjectName("noGraphicsBox");
    box.setIconPixmap(icon("warning").pixmap(32, 32));
    box.exec();
    return failed;
}

} // namespace

void prepareGraphics()
{
    QSurfaceFormat::setDefaultFormat(ViewportBridge::surfaceFormat());
}

int showMainWindow(int argc, char** argv, Services services, const std::vector<std::string>& files)
{
    prepareGraphics();
    QApplication application(argc, argv);
    QApplication::setApplicationName("knead");
    QApplication::setOrganizationName("knead");
    QApplication::setApplicationDisplayName("Knead");
    QApplication::setDesktopFileName("org.knead.Knead"); // for the icon of the window: see resources/desktop
    showTextsAsTheyStand();
    speak(languageFor(readPreferences().language));
    if (const QString problem = graphicsProblem(); !problem.isEmpty())
        return tell(problem);
    MainWindow window(std::move(services));
    window.show();
    QStringList paths;
    for (const std::string& file : files)
        paths << QFile::decodeName(file.c_str());
    if (!paths.empty())
        window.open(paths);
    window.projects().offerRecoveries(false);
    return QApplication::exec();
}

} // namespace knead
