#include "ui/tracing/trace_panel.h"
#include "ui/tracing/trace_text.h"

#include <QtTest>

using namespace knead;

namespace {

/// A row per command, in a table that its ending closes.
class Rows final : public SessionTrace {
public:
    std::unique_ptr<SessionTrace> copy() const override { return std::make_unique<Rows>(); }
    void add(std::span<const RecordedCommand> commands, const std::string&) override
    {
        for (const RecordedCommand& recorded : commands) {
            if (!std::holds_alternative<KeepMoment>(recorded.command))
                throw Problem(Message::verbatim("This cannot be told."));
            m_text += "row\n";
        }
    }
    std::string take() override { return std::exchange(m_text, {}); }
    std::string ending(std::uint64_t) const override { return "end\n"; }

private:
    std::string m_text;
};

} // namespace

/// The trace as it is shown: whole lines, as they were written.
class TraceTextTest : public QObject {
    Q_OBJECT

private slots:
    void whatCannotBeToldLeavesNothingOpen()
    {
        TraceText text;
        QCOMPARE(text.begin([] { return std::make_unique<Rows>(); }).text, QString("end\n"));
        HistoryRecord record;
        record.commands = {{1, KeepMoment{}}, {2, Reset{}}, {3, KeepMoment{}}};
        const std::optional<TextEdit> edit = text.follow(0, {record});
        QVERIFY(edit.has_value());
        QCOMPARE(edit->text, QString("row\nend\n"));
        QCOMPARE(edit->problem.english(), std::string("This cannot be told."));
        QVERIFY(!text.follow(0, {record}));
        const TextEdit none = text.begin([]() -> std::unique_ptr<SessionTrace> { throw std::runtime_error("no"); });
        QCOMPARE(none.text, QString());
    }

    void thePanelKeepsEveryLetter()
    {
        TracePanel panel;
        const QString text = QString::fromUtf8("a = \"\u00a0\u2028b\"\n\nc\n");
        panel.edit({0, text});
        QCOMPARE(panel.text(), text);
        panel.edit({8, QString::fromUtf8("d\n"), Message::verbatim("No\nmore\u2028of it.")});
        QCOMPARE(panel.text(), text.left(8) + "d\n# No more of it.\n");
    }
};

QTEST_MAIN(TraceTextTest)
#include "trace_text_test.moc"
