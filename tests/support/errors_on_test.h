#pragma once

#include "support/history_on_test.h"
#include "ui/commands/command_palette.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/quantity_field.h"

#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <atomic>
#include <fstream>
#include <thread>

namespace knead {

/// A window in which a person does something wrong: it is said in a sentence, and nothing is lost.
class ErrorsOnTest : protected HistoryOnTest {
protected:
    std::unique_ptr<QTemporaryDir> m_folder;

    void begin()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings().clear();
        choosePreferences();
        show(m_services);
    }

    void end()
    {
        m_window.reset();
        m_folder.reset();
    }

    void openBarHere()
    {
        openExample("bar.step", 12);
        settle();
    }

    void openWithBlock()
    {
        openBarHere();
        addBlock();
        settle();
        m_window->banner().hide();
    }

    /// What there is, to be compared with when something went wrong.
    void remember()
    {
        settle();
        m_digest = digest();
        m_entries = tree().records().size();
        m_model = document().content().model->file;
    }

    void verifyNothingLost()
    {
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(digest(), m_digest);
        QCOMPARE(tree().records().size(), m_entries);
        QCOMPARE(document().content().model->file, m_model);
        QVERIFY(m_window->viewport().isVisible());
    }

    /// In the banner, and in the log for later.
    void verifySaid(const QString& words, bool isBusy = false)
    {
        if (!isBusy)
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QTRY_VERIFY2_WITH_TIMEOUT(m_window->banner().sentence().contains(words),
                                  qPrintable(words + " / " + m_window->banner().sentence()), 10'000);
        const QString sentence = m_window->banner().sentence();
        QVERIFY2(sentence.endsWith('.'), qPrintable(sentence));
        QVERIFY(m_window->banner().isVisible());
        QVERIFY(logged().contains("Error: " + sentence));
    }

    QString logged() { return find<QPlainTextEdit>("log")->toPlainText(); }

    void verifyWhyNot(const char* letters, const QString& why)
    {
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        auto* field = find<QLineEdit>("paletteField");
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClicks(field, letters);
        bool isSaid = false;
        QStringList all;
        auto* list = find<QListWidget>("paletteList");
        for (int row = 0; row < list->count(); ++row)
            for (int role = Qt::UserRole; role < Qt::UserRole + 4; ++role) {
                isSaid = isSaid || list->item(row)->data(role).toString() == why;
                all << list->item(row)->data(role).toString();
            }
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY2(isSaid, qPrintable(why + " / " + all.join(", ")));
    }

    /// A task that goes on until letGo().
    void hold()
    {
        m_isHeld = true;
        m_window->tasks().run<bool>(
            "Waiting",
            [this](TaskControl&) {
                while (m_isHeld)
                    std::this_thread::sleep_for(std::chrono::milliseconds(5));
                return true;
            },
            [](bool) {});
        QVERIFY(m_window->tasks().isRunning());
    }

    void letGo()
    {
        m_isHeld = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
    }

    QTreeWidgetItem* line(const QString& name)
    {
        const auto found = m_window->findChild<ModelTree*>()->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }

    void clickLine(const QString& name)
    {
        auto* tree = m_window->findChild<ModelTree*>();
        QTRY_VERIFY(line(name) != nullptr);
        tree->scrollToItem(line(name));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(line(name)).center());
    }

    void renameLine(const QString& name, const QString& wanted)
    {
        auto* tree = m_window->findChild<ModelTree*>();
        clickLine(name);
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_F2);
        QTRY_VERIFY(tree->findChild<QLineEdit*>() != nullptr);
        auto* editor = tree->findChild<QLineEdit*>();
        editor->selectAll();
        QTest::keyClicks(editor, wanted);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(tree->findChild<QLineEdit*>() == nullptr);
        seen();
    }

    static void type(QuantityField* field, const char* text)
    {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

    void write(const char* name, const QByteArray& bytes)
    {
        QFile file(m_folder->filePath(name));
        QVERIFY(file.open(QFile::WriteOnly) && file.write(bytes) == bytes.size());
    }

    /// @param side [mm]
    void writeCube(const char* name, double side, bool isOpen = false)
    {
        std::ofstream out(m_folder->filePath(name).toStdString());
        out << "solid cube\n";
        const double s = side == 1 ? 20 : 20 * side;
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                if (isOpen && axis == 2 && upper)
                    continue;
                Vec3 corner = Vec3::Zero();
                corner[axis] = upper ? s : 0;
                Vec3 u = Vec3::Zero();
                Vec3 v = Vec3::Zero();
                u[(axis + 1) % 3] = v[(axis + 2) % 3] = s;
                if (!upper)
                    std::swap(u, v);
                for (const std::array<Vec3, 3>& t :
                     {std::array<Vec3, 3>{corner, corner + u, corner + u + v}, {corner, corner + u + v, corner + v}}) {
                    out << "facet normal 0 0 0\nouter loop\n";
                    for (const Vec3& p : t)
                        out << "vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
                    out << "endloop\nendfacet\n";
                }
            }
        out << "endsolid cube\n";
    }

private:
    std::uint64_t m_digest = 0;
    std::size_t m_entries = 0;
    std::string m_model;
    std::atomic<bool> m_isHeld = false;
};

} // namespace knead
