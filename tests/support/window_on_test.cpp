#include "support/window_on_test.h"

namespace knead {

namespace {

/// Reads each file of a folder once, as it comes, which takes half a second in a process of its own. What is chosen otherwise is read
/// anew.
ImportFiles readingOnce(ImportFiles import, const std::string& folder)
{
    static std::mutex mutex;
    static std::map<std::string, Model> known;
    return [import = std::move(import), folder](const std::vector<std::string>& paths, const ImportOptions& options,
                                                TaskControl& control) {
        if (paths.size() != 1 || !paths.front().starts_with(folder) || options != ImportOptions{})
            return import(paths, options, control);
        const std::lock_guard lock(mutex);
        const auto found = known.find(paths.front());
        if (found != known.end())
            return found->second;
        return known.emplace(paths.front(), import(paths, options, control)).first->second;
    };
}

} // namespace

void WindowOnTest::show(const Services& services)
{
    m_window = std::make_unique<MainWindow>(services);
    m_window->resize(windowSize());
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
    m_window->activateWindow(); // there may be no window manager that does it
    QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
}

void WindowOnTest::rest()
{
    const auto turns = [&] {
        return std::ranges::any_of(m_window->findChildren<QVariantAnimation*>(), [](const auto* animation) {
            return animation->state() == QAbstractAnimation::Running;
        });
    };
    QVERIFY2(comesTrue([&] { return !turns(); }), "a view turns on and on");
    drawn();
}

void WindowOnTest::drawn()
{
    QCoreApplication::processEvents(); // what was posted may ask for more
    if (!document().isEmpty())
        seen();
    ViewportWidget& view = m_window->viewport();
    if (!view.isVisible())
        return;
    const QSignalSpy pictures(&view, &QOpenGLWidget::frameSwapped);
    view.update();
    const auto isBehind = [&] {
        const auto sides = m_window->findChildren<SideView*>();
        return view.isSketch() || std::ranges::any_of(sides, [](const SideView* side) {
                   return side->isVisible() && (side->isStale() || side->isSketch());
               });
    };
    QVERIFY2(comesTrue([&] { return !pictures.isEmpty() && (document().isPlaying() || !isBehind()); }),
             "the view is not drawn");
}

void WindowOnTest::seen()
{
    const std::uint64_t asked = document().requests();
    QVERIFY2(comesTrue([&] { return document().hasSeen(asked); }), "no frame shows it");
}

void WindowOnTest::waitForTasks()
{
    QVERIFY2(comesTrue([this] { return !m_window->tasks().isRunning(); }), "a task goes on and on");
}

void WindowOnTest::openExample(const char* name, double cells)
{
    ImportChoices request;
    request.paths = {QFile::encodeName(example(name)).toStdString()};
    request.spacing = SpacingChoice{SpacingChoice::Kind::CellsAlong, cells};
    m_window->open(request);
    waitForTasks();
    QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
    lookWhereItTurns();
}

void WindowOnTest::openAndRefill(const char* name, double cells)
{
    m_window->open(QStringList(example(name)));
    waitForTasks();
    QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
    m_window->features().imports->refill(document().size() / cells);
    waitForTasks();
    lookWhereItTurns();
}

void WindowOnTest::lookWhereItTurns()
{
    m_window->viewport().jumpTo(m_window->viewport().cameraAfterTurning());
    drawn();
}

void WindowOnTest::closeBanner()
{
    if (m_window->banner().isVisible())
        QTest::mouseClick(find<QWidget>("bannerClose"), Qt::LeftButton);
}

QString WindowOnTest::problem()
{
    const QString said = m_window->banner().sentence();
    const auto* log = m_window->findChild<LogPanel*>();
    return log->toPlainText().contains("Warning: " + said) ? QString() : said;
}

void WindowOnTest::click(const Vec3& place)
{
    const std::optional<QPointF> position = m_window->viewport().widgetPosition(place);
    QVERIFY(position.has_value());
    QTest::mouseMove(&m_window->viewport(), position->toPoint());
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, position->toPoint());
}

void WindowOnTest::picture(const char* name)
{
    const QString folder = qEnvironmentVariable("KNEAD_PICTURES");
    if (folder.isEmpty())
        return;
    drawn(); // panels lie where they will
    QPixmap image = m_window->grab();
    QPainter painter(&image);
    for (QWidget* dialog : m_window->findChildren<QDialog*>()) // in front of it, wherever it lies
        if (dialog->isVisible())
            painter.drawPixmap((m_window->width() - dialog->width()) / 2, (m_window->height() - dialog->height()) / 2,
                               dialog->grab());
    painter.end();
    image.save(QDir(folder).filePath(QString(name) + ".png"));
}

QSize WindowOnTest::windowSize()
{
    const QStringList size = qEnvironmentVariable("KNEAD_PICTURES_SIZE", "1280x800").split('x');
    return {size.value(0).toInt(), size.value(1).toInt()};
}

void WindowOnTest::prepare(Eyes eyes)
{
    QStandardPaths::setTestModeEnabled(true);
    static const QTemporaryDir state;
    qputenv("XDG_STATE_HOME", state.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", state.path().toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, state.path());
    QApplication::setOrganizationName("knead-test");
    QApplication::setApplicationName("window-test");
    setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
    choosePreferences(eyes);
    m_services = fileServices();
    m_services.import = readingOnce(std::move(m_services.import), m_services.examplesFolder);
}

void WindowOnTest::choosePreferences(Eyes eyes)
{
    QSettings().setValue("language", "en");
    QSettings().setValue("theme", "light");
    if (eyes == Eyes::none && qEnvironmentVariableIsEmpty("KNEAD_PICTURES"))
        QSettings().setValue("view/smoothing", 1);
}

} // namespace knead
