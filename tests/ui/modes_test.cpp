#include "ui/modes.h"

#include <QAction>
#include <QtTest>

using namespace knead;

/// Modes of the left mouse button, without a window.
class ModesTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        for (QAction* mode : {&m_pull, &m_measure}) {
            mode->setCheckable(true);
            mode->setChecked(false);
        }
    }

    void oneIsLeftBeforeTheOtherBegins()
    {
        Modes modes;
        modes.add(&m_pull);
        modes.add(&m_measure);
        QStringList told;
        connect(&m_pull, &QAction::toggled, &modes, [&](bool on) { told << (on ? "pull" : "no pull"); });
        connect(&m_measure, &QAction::toggled, &modes, [&](bool on) { told << (on ? "measure" : "no measure"); });
        m_pull.trigger();
        m_measure.trigger();
        QCOMPARE(told, QStringList({"pull", "no pull", "measure"}));
        QCOMPARE(modes.current(), &m_measure);
    }

    void theOneThatIsOnCanBeLeft()
    {
        Modes modes;
        modes.add(&m_pull);
        modes.add(&m_measure);
        const QSignalSpy changes(&modes, &Modes::changed);
        QVERIFY(!modes.leave());
        m_pull.trigger();
        QVERIFY(modes.leave());
        QVERIFY(!m_pull.isChecked());
        QVERIFY(modes.current() == nullptr);
        m_pull.trigger();
        m_pull.trigger(); // by its own button
        QVERIFY(modes.current() == nullptr);
        QCOMPARE(changes.size(), 4);
    }

private:
    QAction m_pull{nullptr};
    QAction m_measure{nullptr};
};

QTEST_MAIN(ModesTest)
#include "modes_test.moc"
