#include "support/full_disk.h"
#include "support/window_on_test.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/dialogs/record_dialog.h"
#include "ui/run_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QOpenGLContext>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

using namespace knead;

namespace {

/// What the headers and pages of an Ogg Theora file say. From the specification, section 6.2.
struct VideoFacts {
    int width = 0;
    int height = 0;
    double rate = 0;
    std::int64_t frames = 0;
    bool isWhole = false; ///< its last page says that it is the last one
};

VideoFacts factsOf(const QString& path)
{
    QFile file(path);
    VideoFacts facts;
    if (!file.open(QIODevice::ReadOnly))
        return facts;
    const QByteArray bytes = file.readAll();
    const auto number = [&](qsizetype at, int count) {
        qint64 value = 0;
        for (int i = 0; i < count; ++i)
            value = 256 * value + static_cast<uchar>(bytes[at + i]);
        return value;
    };
    const qsizetype header = bytes.indexOf(QByteArray("\x80theora")) + 7;
    facts.width = static_cast<int>(number(header + 7, 3));
    facts.height = static_cast<int>(number(header + 10, 3));
    facts.rate = static_cast<double>(number(header + 15, 4)) / static_cast<double>(number(header + 19, 4));
    const qint64 shift = (number(header + 33, 2) >> 5) & 31;
    const qsizetype page = bytes.lastIndexOf("OggS");
    const auto granule = qFromLittleEndian<qint64>(bytes.constData() + page + 6);
    facts.frames = (granule >> shift) + (granule & ((qint64{1} << shift) - 1));
    facts.isWhole = (bytes[page + 5] & 4) != 0;
    return facts;
}

bool refusesContexts = false; ///< the graphics card makes no more of them
bool refusesThreads = false;  ///< the driver draws in one thread only

/// Share of pixels that differ visibly.
double difference(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 20 ? 1 : 0;
    return static_cast<double>(count) / a.width() / a.height();
}

} // namespace

// What the program calls instead of QOpenGLContext::create() and supportsThreadedOpenGL(): the linker sees to that.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
bool __real__ZN14QOpenGLContext6createEv(QOpenGLContext* context);
bool __wrap__ZN14QOpenGLContext6createEv(QOpenGLContext* context)
{
    return !refusesContexts && __real__ZN14QOpenGLContext6createEv(context);
}
bool __real__ZN14QOpenGLContext22supportsThreadedOpenGLEv();
bool __wrap__ZN14QOpenGLContext22supportsThreadedOpenGLEv()
{
    return !refusesThreads && __real__ZN14QOpenGLContext22supportsThreadedOpenGLEv();
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}

/// Videos and pictures of what was simulated.
class WindowRecordingTest : public QObject, WindowOnTest {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) { return m_folder->filePath(name); }
    QStringList names()
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    Recording shortOne(Recording::Kind kind)
    {
        return {.kind = kind, .from = 0, .to = 0.4, .rate = 10, .size = {320, 240}, .hasReadings = false};
    }

    /// Of the view, written and read again.
    QImage pictureOf(const Picture& picture, const char* name = "view.png")
    {
        m_window->features().pictures->save(path(name), picture);
        wait();
        return QImage(path(name));
    }

    void wait() { QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience); }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "Without a display there is nothing to draw with.");
        prepare(Eyes::open);
        show(m_services);
        openExample("bar.step", 8);
        document().post(SetGravity{Vec3(0, 0, -0.2)});
        document().post(SetFloor{});
        document().play();
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.45, patience);
        document().pause();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
    }

    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void cleanupTestCase() { m_window.reset(); }

    void picturesFillAFolder()
    {
        m_window->features().recording->record(path("fall"), shortOne(Recording::Kind::pictures));
        wait();
        QCOMPARE(names(), QStringList("fall"));
        const QDir folder(path("fall"));
        QCOMPARE(folder.entryList(QDir::Files),
                 (QStringList{"fall-0001.png", "fall-0002.png", "fall-0003.png", "fall-0004.png", "fall-0005.png"}));
        const QImage first(folder.filePath("fall-0001.png"));
        const QImage second(folder.filePath("fall-0002.png"));
        const QImage last(folder.filePath("fall-0005.png"));
        QCOMPARE(first.size(), QSize(320, 240));
        QVERIFY(difference(first, second) > 0);
        QVERIFY(difference(first, last) > difference(first, second)); // it falls on and on
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    }

    void theyShowWhatTheViewShows()
    {
        Recording whole = shortOne(Recording::Kind::pictures);
        whole.from = whole.to = document().frame()->snapshot->time;
        whole.size = m_window->viewport().size();
        m_window->features().recording->record(path("now"), whole);
        wait();
        QCOMPARE(document().timeline().pictures.back().frame->time, whole.to); // the last moment is there, too
        const QImage drawn(path("now/now-0001.png"));
        const QImage seen = m_window->viewport().grabFramebuffer();
        QCOMPARE(drawn.size(), seen.size());
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty()) {
            drawn.save(folder + "/recording-drawn.png");
            seen.save(folder + "/recording-seen.png");
        }
        const QRect withoutCube(0, 0, drawn.width() * 4 / 5, drawn.height());
        QVERIFY(difference(drawn.copy(withoutCube), seen.copy(withoutCube)) < 0.02);
        QVERIFY(difference(drawn.mirrored(), seen) > 0.05);
    }

    void readingsAreWrittenIntoThem()
    {
        Recording plain = shortOne(Recording::Kind::pictures);
        plain.to = 0;
        Recording read = plain;
        read.hasReadings = true;
        m_window->features().recording->record(path("plain"), plain);
        wait();
        m_window->features().recording->record(path("read"), read);
        wait();
        const QImage without(path("plain/plain-0001.png"));
        const QImage with(path("read/read-0001.png"));
        const double share = difference(without, with);
        QVERIFY(share > 0.0005 && share < 0.05);
    }

    void aVideoHasAllPictures()
    {
        Recording recording = shortOne(Recording::Kind::video);
        recording.speed = 0.5;
        recording.hasReadings = true;
        m_window->features().recording->record(path("fall.ogv"), recording);
        wait();
        QCOMPARE(names(), QStringList("fall.ogv"));
        const VideoFacts facts = factsOf(path("fall.ogv"));
        QCOMPARE(facts.width, 320);
        QCOMPARE(facts.height, 240);
        QCOMPARE(facts.rate, 10.0);
        QCOMPARE(facts.frames, std::int64_t{9});
        QCOMPARE(recording.pictures(), std::size_t{9});
        QVERIFY(facts.isWhole);
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            QFile::copy(path("fall.ogv"), folder + "/recording.ogv");
    }

    void whatIsCancelledLeavesNothing()
    {
        for (const auto kind : {Recording::Kind::pictures, Recording::Kind::video}) {
            Recording recording = shortOne(kind);
            recording.speed = 0.001;
            m_window->features().recording->record(path("long"), recording);
            QTRY_VERIFY_WITH_TIMEOUT(!names().isEmpty(), patience);
            QTest::keyClick(m_window.get(), Qt::Key_Escape);
            QVERIFY(!m_window->tasks().isRunning());
            QTRY_VERIFY_WITH_TIMEOUT(names().isEmpty(), patience);
        }
    }

    void whatIsThereIsNotWrittenOver()
    {
        QVERIFY(QDir(m_folder->path()).mkpath("mine/file"));
        m_window->features().recording->record(path("mine"), shortOne(Recording::Kind::pictures));
        wait();
        QVERIFY(m_window->banner().sentence().contains("is there already"));
        QCOMPARE(QDir(path("mine")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("file"));
        m_window->features().recording->record(path("nowhere/fall.ogv"), shortOne(Recording::Kind::video));
        wait();
        QVERIFY(m_window->banner().sentence().startsWith("fall.ogv: the file cannot be written"));
        m_window->features().recording->record(path("nowhere/fall"), shortOne(Recording::Kind::pictures));
        wait();
        QVERIFY(m_window->banner().sentence().startsWith("No folder can be made in "));
        m_window->banner().hide();
    }

    /// Pictures and videos that find no room leave nothing behind.
    void aFullDiskIsSaid()
    {
        for (const auto kind : {Recording::Kind::pictures, Recording::Kind::video}) {
            {
                const FullDisk disk(3000);
                m_window->features().recording->record(path("fall"), shortOne(kind));
                [&] { wait(); }();
            }
            QVERIFY2(m_window->banner().sentence().startsWith("There is no room left in " + m_folder->path()),
                     qPrintable(m_window->banner().sentence()));
            QVERIFY(names().isEmpty());
            m_window->banner().hide();
        }
    }

    void aFolderThatSomebodyElseMakesMeanwhileStays()
    {
        Recording recording = shortOne(Recording::Kind::pictures);
        recording.speed = 0.1;
        m_window->features().recording->record(path("fall"), recording);
        QTRY_VERIFY_WITH_TIMEOUT(!names().isEmpty(), patience);
        QVERIFY(QDir(m_folder->path()).mkpath("fall/file"));
        wait();
        QVERIFY2(m_window->banner().sentence().startsWith(path("fall") + " cannot be made (") &&
                     m_window->banner().sentence().contains("Choose another name"),
                 qPrintable(m_window->banner().sentence()));
        QCOMPARE(names(), QStringList("fall"));
        QCOMPARE(QDir(path("fall")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("file"));
        m_window->banner().hide();
    }

    void aGraphicsCardThatFailsIsSaid()
    {
        const auto failsWith = [&](const Recording& recording, const char* words) {
            m_window->features().recording->record(path("fall"), recording);
            [&] { wait(); }();
            const QString sentence = m_window->banner().isVisible() ? m_window->banner().sentence() : QString();
            m_window->banner().hide();
            return sentence.contains(words) && names().isEmpty();
        };
        for (const auto kind : {Recording::Kind::pictures, Recording::Kind::video}) {
            {
                const QScopedValueRollback<bool> refuses(refusesContexts, true);
                QVERIFY(failsWith(shortOne(kind), "takes no more pictures. Close other programs"));
            }
            {
                const QScopedValueRollback<bool> refuses(refusesThreads, true);
                QVERIFY(failsWith(shortOne(kind), "LIBGL_ALWAYS_SOFTWARE=1"));
            }
            Recording large = shortOne(kind);
            large.size = {40'000, 16};
            QVERIFY(failsWith(large, "draws no pictures of this size. Choose a smaller one"));
        }
        m_window->features().recording->record(path("fall"), shortOne(Recording::Kind::pictures));
        wait();
        QCOMPARE(names(), QStringList("fall"));
    }

    void aPictureShowsWhatTheViewShows()
    {
        Picture picture;
        picture.size = m_window->viewport().size() * m_window->viewport().devicePixelRatioF();
        picture.hasCube = true;
        const QImage drawn = pictureOf(picture);
        const QImage seen = m_window->viewport().grabFramebuffer();
        QCOMPARE(drawn.size(), seen.size());
        QVERIFY(difference(drawn, seen) < 0.02); // with the cube, too
        QVERIFY(difference(drawn.mirrored(), seen) > 0.05);
        picture.hasCube = false;
        const QImage bare = pictureOf(picture);
        const QRect corner(drawn.width() - 112, 0, 112, 112);
        QVERIFY(difference(drawn.copy(corner), bare.copy(corner)) > 0.1);
        picture.hasGround = false;
        QVERIFY(difference(bare, pictureOf(picture)) > 0.002);
        picture.size = {3000, 100};
        QCOMPARE(pictureOf(picture, "wide.jpg").size(), picture.size);
        QFile wide(path("wide.jpg"));
        QVERIFY(wide.open(QIODevice::ReadOnly) && wide.read(2) == "\xff\xd8"); // the ending decides
        QCOMPARE(names(), (QStringList{"view.png", "wide.jpg"}));
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    }

    void aPictureWithoutBackgroundIsClearBesideThePart()
    {
        Picture picture;
        picture.size = {640, 480};
        picture.hasGround = false;
        const QImage usual = pictureOf(picture);
        QVERIFY(!usual.hasAlphaChannel());
        picture.isClear = true;
        const QImage clear = pictureOf(picture);
        QVERIFY(clear.hasAlphaChannel());
        QCOMPARE(qAlpha(clear.pixel(2, 2)), 0);
        QCOMPARE(qAlpha(clear.pixel(637, 477)), 0);
        int solid = 0;
        int between = 0;
        for (int y = 0; y < clear.height(); ++y)
            for (int x = 0; x < clear.width(); ++x) {
                const int opacity = qAlpha(clear.pixel(x, y));
                solid += opacity == 255 ? 1 : 0;
                between += opacity > 0 && opacity < 255 ? 1 : 0;
                if (opacity == 255)
                    QVERIFY(std::abs(qGray(clear.pixel(x, y)) - qGray(usual.pixel(x, y))) < 3);
            }
        QVERIFY(solid > 5000);                        // the bar
        QVERIFY(between > 20 && between < solid / 4); // its rim alone
        picture.kind = Picture::Kind::jpeg;
        QVERIFY(!pictureOf(picture, "view.jpg").hasAlphaChannel());
    }

    void aPictureThatCannotBeWrittenSaysSo()
    {
        pictureOf({.size = {64, 64}}, "nowhere/view.png");
        QVERIFY(m_window->banner().sentence().startsWith("view.png: the file cannot be written"));
        m_window->banner().hide();
        pictureOf({.size = {40'000, 16}}, "large.png");
        QVERIFY(m_window->banner().sentence().contains("draws no pictures of this size"));
        m_window->banner().hide();
        QCOMPARE(names(), QStringList());
    }

    void theDialogOfPicturesRemembersWhatWasChosen()
    {
        QSettings().remove("picture");
        for (int round = 0; round < 2; ++round) {
            action("savePicture")->trigger();
            QTRY_VERIFY(m_window->findChild<PictureDialog*>("pictureDialog") != nullptr);
            QPointer<PictureDialog> dialog = m_window->findChild<PictureDialog*>("pictureDialog");
            if (round == 0) {
                QCOMPARE(dialog->picture().size,
                         m_window->viewport().size() * m_window->viewport().devicePixelRatioF());
                find<QComboBox>("pictureSize")->setCurrentText("3840 × 2160");
                QCOMPARE(dialog->picture().size, QSize(3840, 2160));
                QVERIFY(!find<QSpinBox>("pictureWidth")->isEnabled());
                find<QComboBox>("pictureSize")->setCurrentText("Other");
                QVERIFY(find<QSpinBox>("pictureWidth")->isEnabled());
                QCOMPARE(find<QSpinBox>("pictureWidth")->maximum(), 8192);
                find<QSpinBox>("pictureWidth")->setValue(1234);
                find<QSpinBox>("pictureHeight")->setValue(567);
                find<QCheckBox>("pictureClear")->setChecked(true);
                find<QComboBox>("pictureKind")->setCurrentIndex(1); // JPEG knows no opacity
                QVERIFY(!find<QCheckBox>("pictureClear")->isEnabled() && !dialog->picture().isClear);
                find<QComboBox>("pictureKind")->setCurrentIndex(0);
                dialog->accept();
                QTRY_VERIFY(m_window->findChild<QDialog*>("pictureFileDialog") != nullptr);
                QPointer<QDialog> place = m_window->findChild<QDialog*>("pictureFileDialog");
                place->reject();
                QTRY_VERIFY(!place);
            } else {
                QCOMPARE(dialog->picture().size, QSize(1234, 567));
                QVERIFY(dialog->picture().isClear && dialog->picture().hasGround && !dialog->picture().hasCube);
                dialog->reject();
            }
            QTRY_VERIFY(!dialog);
        }
    }

    void theDialogSaysWhatThereWillBe()
    {
        for (const char* name : {"recordVideo", "recordPictures"}) {
            action(name)->trigger();
            QTRY_VERIFY(m_window->findChild<RecordDialog*>("recordDialog") != nullptr);
            auto* dialog = m_window->findChild<RecordDialog*>("recordDialog");
            find<QComboBox>("recordSpeed")->setCurrentText("0.5 times");
            find<QComboBox>("recordRate")->setCurrentText("50");
            const Recording recording = dialog->recording();
            QCOMPARE(recording.to, document().frame()->snapshot->time);
            QVERIFY(
                find<QLabel>("recordExtent")->text().startsWith(QString::number(recording.pictures()) + " picture"));
            for (const Theme theme : {Theme::Dark, Theme::Light}) {
                m_window->features().preferences->setTheme(theme);
                drawn();
                const QString folder = qEnvironmentVariable("KNEAD_PICTURES");
                if (!folder.isEmpty())
                    dialog->grab().save(QStringLiteral("%1/%2-%3.png").arg(folder, name).arg(static_cast<int>(theme)));
            }
            QPointer<RecordDialog> gone(dialog);
            dialog->reject();
            QTRY_VERIFY(!gone);
        }
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowRecordingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_recording_test.moc"
