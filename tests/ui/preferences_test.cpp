#include "ui/preferences/preferences.h"
#include "ui/preferences/system_theme.h"

#include <QDBusVariant>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace knead;

class PreferencesTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QCoreApplication::setOrganizationName("knead-test");
        QCoreApplication::setApplicationName("preferences-test");
        QSettings().clear();
    }

    void whatIsWrittenIsReadAgain()
    {
        Preferences chosen;
        chosen.look = Preferences::Look::Dark;
        chosen.language = "fr";
        chosen.lengthUnit = "in";
        chosen.historyMegabytes = 1024;
        chosen.filmMegabytes = 64;
        chosen.keepingInterval = std::chrono::seconds(20);
        chosen.detail = 1.25e-4;
        chosen.importMinutes = 5;
        chosen.importGibibytes = 8;
        chosen.threads = 3;
        chosen.smoothing = 8;
        chosen.turnsSmoothly = false;
        chosen.navigation = "solidworks";
        chosen.textPercent = 125;
        writePreferences(chosen);
        QVERIFY(readPreferences() == chosen);
    }

    void whatIsAsItComesIsNotWritten()
    {
        writePreferences({});
        QCOMPARE(QSettings().allKeys(), QStringList("theme"));
        QVERIFY(readPreferences() == Preferences());
    }

    void numbersThatMakeNoSenseAreAsTheyCome()
    {
        QSettings settings;
        settings.setValue("history/megabytes", -3);
        settings.setValue("film/megabytes", "much");
        settings.setValue("recovery/seconds", 1e9);
        settings.setValue("import/detail", "nan");
        settings.setValue("theme", "pink");
        settings.setValue("view/smoothing", 1000);
        settings.setValue("view/navigation", "of no program");
        settings.setValue("textPercent", 1000);
        QVERIFY(readPreferences() == Preferences());
    }

    void theDesktopSaysWhetherItIsDark()
    {
        SystemTheme theme;
        theme.take(2U); // light
        const QSignalSpy changes(&theme, &SystemTheme::changed);
        theme.take(QVariant::fromValue(QDBusVariant(QVariant::fromValue(QDBusVariant(1U))))); // as the portal packs it
        QVERIFY(theme.isDark());
        theme.take(1U);
        QCOMPARE(changes.count(), 1);
        theme.take(99U); // means nothing
        QVERIFY(theme.isDark());
        theme.take(0U);
        QVERIFY(!theme.isDark());
        QCOMPARE(changes.count(), 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(PreferencesTest)
#include "preferences_test.moc"
