#include "ui/frame/notices.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"

#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

using namespace knead;

class NoticesTest : public QObject {
    Q_OBJECT

    struct Desk {
        QWidget window;
        Banner banner{&window};
        LogPanel log{&window};
        Notices notices{banner, log, &window};

        Desk() { banner.hide(); }
        QStringList lines() const { return log.toPlainText().split('\n', Qt::SkipEmptyParts); }
    };

private slots:
    void problemsAreInBoth()
    {
        Desk desk;
        int remedied = 0;
        desk.notices.problem("It broke.", "Mend", [&remedied] { ++remedied; });
        QCOMPARE(desk.notices.shown(), QString("It broke."));
        QVERIFY(!desk.banner.isHidden());
        QCOMPARE(desk.lines().size(), 1);
        QVERIFY(desk.lines().front().contains("It broke."));
        emit desk.banner.remedyClicked();
        QCOMPARE(remedied, 1);
        desk.notices.hide();
        QVERIFY(desk.banner.isHidden());
    }

    void remarksLeaveWhatIsWorse()
    {
        Desk desk;
        desk.notices.remark("By the way.");
        QCOMPARE(desk.notices.shown(), QString("By the way."));
        desk.notices.problem("Walls are thin.", "Fill finer", [] {});
        desk.notices.remark("Another one."); // it would take the remedy away
        QCOMPARE(desk.notices.shown(), QString("Walls are thin."));
        desk.notices.hide();
        desk.notices.remark("A third one.");
        QCOMPARE(desk.notices.shown(), QString("A third one."));
        desk.notices.problem("It stopped.");
        desk.notices.setGrave(true);
        desk.notices.remark("A fourth one.");
        QCOMPARE(desk.notices.shown(), QString("It stopped."));
        desk.notices.setGrave(false);
        desk.notices.remark("A fifth one.");
        QCOMPARE(desk.notices.shown(), QString("A fifth one."));
        QCOMPARE(desk.lines().size(), 7); // all of it
    }

    void onlyWhatIsShownIsWithdrawn()
    {
        Desk desk;
        desk.notices.remark("Folded.");
        desk.notices.withdraw("Something else.");
        desk.notices.withdraw({});
        QVERIFY(!desk.banner.isHidden());
        desk.notices.withdraw("Folded.");
        QVERIFY(desk.banner.isHidden());
        QCOMPARE(desk.lines().size(), 1); // it was so
    }

    void aRemedyGoesWithItsSentence()
    {
        Desk desk;
        int remedied = 0;
        desk.notices.advise("Fill finer?", "Fill finer", [&remedied] { ++remedied; });
        QVERIFY(desk.lines().empty());
        desk.notices.problem("Something else.");
        emit desk.banner.remedyClicked();
        QCOMPARE(remedied, 0);
    }

    void theSecondButtonIsOfItsOwn()
    {
        Desk desk;
        const QSignalSpy other(&desk.notices, &Notices::otherClicked);
        int remedied = 0;
        desk.notices.trouble(
            "It stopped.", "Slower", [&remedied] { ++remedied; }, "Reset");
        emit desk.banner.otherClicked();
        QCOMPARE(other.size(), 1);
        QCOMPARE(remedied, 0);
    }
};

QTEST_MAIN(NoticesTest)
#include "notices_test.moc"
