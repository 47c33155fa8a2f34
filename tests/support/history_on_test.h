#pragma once

#include "core/document/byte_stream.h"
#include "core/document/history_replay.h"
#include "io/project/packing.h"
#include "support/window_on_test.h"

#include <QtTest>

#include <cmath>
#include <set>

namespace knead {

/// Everything that a person could see of a state, to the last bit.
inline std::uint64_t digestOf(const Snapshot& snapshot)
{
    ByteWriter bytes;
    bytes(snapshot.step);
    bytes(snapshot.time);
    bytes(snapshot.gravity);
    bytes(snapshot.floorHeight.has_value());
    for (const Snapshot::BodyState& body : snapshot.bodies) {
        bytes(static_cast<int>(body.kind));
        for (const Vec3& position : body.positions)
            bytes(position);
    }
    for (const Material& material : snapshot.materials)
        for (const MaterialField& field : materialFields())
            bytes(material.*field.value);
    for (const ToolState& tool : snapshot.tools) {
        bytes(tool.id);
        bytes(tool.name);
        bytes(tool.size);
        bytes(tool.pose.position);
        bytes(tool.friction);
    }
    for (const Fixture& fixture : snapshot.fixtures) {
        bytes(fixture.name);
        for (const ObjectIndex object : fixture.objects)
            bytes(object);
    }
    bytes(snapshot.energy.elastic);
    return checksumOf(bytes.take());
}

/// A window with a part in it, and what tests of its history say over and over.
class HistoryOnTest : protected WindowOnTest {
protected:
    using Entry = Document::Entry;

    const History& tree() { return document().history().tree(); }
    const HistoryRecord& present() { return tree().record(tree().current()); }
    QString presentName() { return QString::fromStdString(present().name); }

    /// A window with a bar in it, filled coarsely.
    void openBar()
    {
        show(m_services);
        QVERIFY(!action("undo")->isEnabled() && !action("redo")->isEnabled());
        openExample("bar.step", 12);
        settle();
    }

    /// The same with two entries in its history: the import, and the coarse filling.
    void openRefilledBar()
    {
        show(m_services);
        QVERIFY(!action("undo")->isEnabled() && !action("redo")->isEnabled());
        openAndRefill("bar.step", 12);
        settle();
    }

    /// Waits until everything that was done is in the history and shown.
    void settle()
    {
        QVERIFY2(comesTrue([this] { return document().isSettled(); }), "something goes on and on");
        QVERIFY(snapshot().step == present().step && snapshot().time == present().time);
    }

    std::uint64_t digest()
    {
        settle();
        return digestOf(snapshot());
    }

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }
    void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

    void simulate(double seconds)
    {
        const double end = snapshot().time + seconds;
        key(Qt::Key_Space);
        QVERIFY2(comesTrue([&] { return snapshot().time >= end; }), "time stands still");
        key(Qt::Key_Space);
        QVERIFY2(comesTrue([this] { return !snapshot().playing; }), "time does not stand still");
    }

    /// For people, when they ask for them: in both themes and two sizes.
    void pictures(const QString& name)
    {
        if (qEnvironmentVariableIsEmpty("KNEAD_PICTURES"))
            return;
        for (const Theme theme : {Theme::Dark, Theme::Light})
            for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
                m_window->features().preferences->setTheme(theme);
                m_window->resize(size);
                drawn();
                const char* word = theme == Theme::Dark ? "dark" : "light";
                picture(qPrintable(QString("%1-%2-%3").arg(name, word).arg(size.width())));
            }
    }

    double spacingOfObjects(double count)
    {
        return std::cbrt(document().content().bodies[0]->aggregate->meshVolume / count);
    }

    void addBlock()
    {
        const std::size_t before = snapshot().tools.size();
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), before + 1);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
    }

    /// Undo and redo lead exactly back and forth.
    void verifyUndo(std::uint64_t before, const QString& name)
    {
        const std::uint64_t after = digest();
        QCOMPARE(presentName(), name);
        QCOMPARE(action("undo")->text(), QString("Undo \"%1\"").arg(name));
        undo();
        QCOMPARE(digest(), before);
        QCOMPARE(action("redo")->text(), QString("Redo \"%1\"").arg(name));
        redo();
        QCOMPARE(digest(), after);
        QVERIFY(!action("redo")->isEnabled());
    }

    /// Repeating all commands from where they began leads to every entry, whatever way a person took.
    void verifyStraightRun()
    {
        const Project project = document().project();
        std::set<Entry> all;
        for (Entry entry = 0; entry < project.entries.size(); ++entry)
            all.insert(entry);
        HistoryReplay replay(project, HistoryReplay::From::starts, zstandardPacking());
        for (const Entry entry : all) {
            const RepeatedEntry repeated = replay.repeat(entry, TaskControl::none(), all);
            QVERIFY2(repeated.isSame, qPrintable(QString("entry %1, \"%2\": %3")
                                                     .arg(entry)
                                                     .arg(QString::fromStdString(project.entries[entry].name))
                                                     .arg(QString::fromStdString(repeated.trouble.english()))));
        }
    }
};

} // namespace knead
