#include "ui/run_window.h"

#include "ui/main_window.h"
#include "ui/viewport/viewport_bridge.h"

#include <QApplication>
#include <QFile>
#include <QSurfaceFormat>

namespace knead {

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
    MainWindow window(std::move(services));
    window.show();
    QStringList paths;
    for (const std::string& file : files)
        paths << QFile::decodeName(file.c_str());
    if (!paths.empty())
        window.open(paths);
    window.offerRecoveries();
    if (paths.empty())
        window.offerTour();
    return QApplication::exec();
}

} // namespace knead
