#include "core/message/message.h"

#include <QtTest>

using namespace knead;

class MessageTest : public QObject {
    Q_OBJECT

private slots:
    void placesAreFilledInTheirOrder()
    {
        const Message message = Message("Filling", "%2 of %1, and %1 again; 100 %").with("a name", 3);
        QCOMPARE(message.english(), std::string("3 of a name, and a name again; 100 %"));
        QVERIFY(!message.isVerbatim());
        QCOMPARE(Message("Filling", "All of %1 and %2").with("one").english(), std::string("All of one and %2"));
    }

    void whatGoesInIsNotReadAgain()
    {
        QCOMPARE(Message("File", "%1 is %2").with("50%2.stl", "%1").english(), std::string("50%2.stl is %1"));
        QCOMPARE(Message::verbatim("100%1").english(), std::string("100%1"));
    }

    void messagesGoIntoMessages()
    {
        const Message inner = Message("Run", "%1 J came from nowhere.").with(5);
        const Message outer = Message("Run", "The simulation was stopped: %1").with(inner);
        QCOMPARE(outer.english(), std::string("The simulation was stopped: 5 J came from nowhere."));
        QCOMPARE(outer.arguments().front(), inner);
        QCOMPARE(Message("Run", "The simulation was stopped: %1").withAll({inner}), outer);
    }

    void sentencesFollowEachOther()
    {
        const Message one("Run", "One.");
        QCOMPARE(Message::sequence({one, {}, Message("Run", "Two.")}).english(), std::string("One. Two."));
        QCOMPARE(Message::sequence({{}, one}), one);
        QVERIFY(Message::sequence({}).empty());
    }

    /// Of a file that somebody made to do harm.
    void whatGrowsWithoutEndIsCutOff()
    {
        Message grown = Message::verbatim(std::string(100, 'a'));
        for (int i = 0; i < 8; ++i)
            grown = Message("File", "%1%1%1%1%1%1%1%1%1%1").with(grown);
        QVERIFY(grown.english().size() < 200'000);
    }

    void problemsCarryTheirMessage()
    {
        const Message message = Message("Filling", "%1 is too thin.").with("plate");
        try {
            throw Problem(message);
        } catch (const std::runtime_error& error) {
            QCOMPARE(error.what(), "plate is too thin.");
            QCOMPARE(messageOf(error), message);
        }
        QCOMPARE(messageOf(std::runtime_error("as it is")), Message::verbatim("as it is"));
    }
};

QTEST_APPLESS_MAIN(MessageTest)
#include "message_test.moc"
