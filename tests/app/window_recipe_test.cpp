// Recipes in the window, as a person has them: opened, played, undone, changed by hand, and written.
#include "app/hexadecimal.h"
#include "support/busy_recipe.h"
#include "support/window_on_test.h"
#include "support/workshop.h"
#include "ui/dialogs/recent_files.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <fstream>

using namespace knead;
using workshop::json;
using workshop::Outcome;

class WindowRecipeTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
        show(m_services);
        m_recipe = m_shop.write(workshop::busyRecipe(example("bar.step").toStdString()), "press.recipe.json");
    }

    void cleanupTestCase() { m_window.reset(); }

    void itOpensReadyToBePlayed()
    {
        open(m_recipe);
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().tools[0].name, std::string("press"));
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        QVERIFY(document().fixtures().list()[0].faces == std::vector<std::uint32_t>{0});
        QCOMPARE(document().history().tree().records()[0].name, std::string("Open press.recipe.json"));
        QVERIFY(recent_files::list().contains(m_recipe));
        QVERIFY(!m_window->projects().isModified());
        rest();
        picture("recipe-opened");
    }

    void playIsWhatKneadRunDoes()
    {
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(document().fixtures().list().size() == 2, patience);
        QCOMPARE(document().fixtures().list()[1].name, std::string("other end"));
        QVERIFY(document().fixtures().list()[1].faces == std::vector<std::uint32_t>{1});
        waitForEnd();
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        QCOMPARE(presentHash(), hashOf({"run", m_recipe}));
        QVERIFY(action("gravity")->isChecked());
        QVERIFY(logText().contains("The recipe has come to its end."));
        picture("recipe-played");
    }

    void undoneItPlaysAgain()
    {
        const std::string end = presentHash();
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        QCOMPARE(snapshot().step, std::uint64_t{0});
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.13, patience);
        key(Qt::Key_Space); // a pause is a gesture; its end changes the last bits
        settle();
        const std::string middle = presentHash();
        key(Qt::Key_Space);
        waitForEnd();
        const std::string longWay = presentHash();
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        QCOMPARE(presentHash(), middle);
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(presentHash(), longWay);
        key(Qt::Key_Z, Qt::ControlModifier);
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(presentHash(), end);
    }

    void undoneBeforeAnythingMovedItPlaysAgain()
    {
        const json late = workshop::lateRecipe(example("bar.step").toStdString());
        const QString recipe = m_shop.write(late, "late.recipe.json");
        open(recipe);
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        key(Qt::Key_Space);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{0});
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(presentHash(), hashOf({"run", recipe}));
        open(m_recipe);
        key(Qt::Key_Space);
        waitForEnd();
    }

    void afterItsEndTimeGoesOn()
    {
        const double end = snapshot().time;
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > end + 0.05, patience);
        key(Qt::Key_Space);
        settle();
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
    }

    void resetPlaysItAgain()
    {
        key(Qt::Key_Backspace);
        settle();
        QCOMPARE(snapshot().step, std::uint64_t{0});
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
    }

    void anotherFillingEndsItAndUndoGoesBack()
    {
        open(m_recipe);
        m_window->features().imports->refill(document().content().spacing * 1.2);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        settle();
        QVERIFY(logText().contains("The recipe belongs to the filling before"));
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.2, patience);
        key(Qt::Key_Space);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1}); // the second did not come
        key(Qt::Key_Z, Qt::ControlModifier);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled() && document().history().tree().current() == 0, patience);
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(presentHash(), hashOf({"run", m_recipe}));
    }

    void fromAMomentInBetweenItGoesOn()
    {
        open(m_recipe);
        key(Qt::Key_Space);
        waitForEnd();
        const std::uint64_t end = snapshot().step;
        document().branchAt(1, end / 2); // the second tool is there, and the other end is held
        QTRY_VERIFY_WITH_TIMEOUT(!document().isGoing() && document().isSettled() && snapshot().step == end / 2,
                                 patience);
        QCOMPARE(snapshot().tools.size(), std::size_t{2});
        QCOMPARE(document().fixtures().list().size(), std::size_t{2});
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
    }

    void gesturesComeOnTopOfIt()
    {
        open(m_recipe);
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{2});
        click(snapshot().tools[1].pose.position);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.04, patience);
        drag(QPoint(0, 40));
        waitForEnd();
        QCOMPARE(snapshot().tools.size(), std::size_t{2});
        picture("recipe-and-hands");
        m_project = m_shop.qPath("hands.knead");
        m_window->projects().saveTo(m_project);
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(m_project) && !m_window->tasks().isRunning(), patience);
        for (const char* threads : {"1", "2"}) {
            const Outcome outcome = workshop::runKnead({"replay", m_project, "--all", "--threads", threads});
            QVERIFY2(outcome.status == 0, (outcome.out + outcome.errors).c_str());
        }
    }

    void theSessionIsWrittenAsARecipe()
    {
        const QString file = m_shop.qPath("hands.recipe.json");
        QVERIFY(action("exportRecipe")->isEnabled());
        m_window->findChild<QMenu*>("fileMenu")->popup(m_window->mapToGlobal(QPoint(0, 30)));
        picture("recipe-menu");
        m_window->findChild<QMenu*>("fileMenu")->setActiveAction(action("exportRecipe"));
        QTest::keyClick(m_window->findChild<QMenu*>("fileMenu"), Qt::Key_Return);
        QTRY_VERIFY(find<QFileDialog>("recipeDialog") != nullptr);
        auto* dialog = find<QFileDialog>("recipeDialog");
        auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
        QCOMPARE(name->text(), QString("hands.recipe.json"));
        name->setText(file);
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(file) && !m_window->tasks().isRunning(), patience);
        QCOMPARE(hashOf({"run", file, "--threads", "2"}), presentHash());
        const std::string hash = presentHash();
        open(file); // and it comes back into the window
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        key(Qt::Key_Space);
        waitForEnd();
        QCOMPARE(presentHash(), hash);
    }

    /// It writes nothing of its own accord, but does not forget them without a word.
    void filesThatARecipeNamesAreOfferedAtItsEnd()
    {
        json wanted = workshop::busyRecipe(example("bar.step").toStdString());
        wanted["exports"] = json::array({{{"file", "bent.step"}}, {{"file", "bent.png"}}});
        open(m_shop.write(wanted, "exporting.recipe.json"));
        QCOMPARE(m_window->features().recipes->namedExports(), (QStringList{"bent.step", "bent.png"}));
        QVERIFY(!m_window->banner().sentence().contains("bent.step"));
        key(Qt::Key_Space);
        waitForEnd();
        QTRY_VERIFY2(m_window->banner().sentence().contains("bent.step, bent.png"),
                     qPrintable(m_window->banner().sentence()));
        QTest::mouseClick(find<QToolButton>("bannerRemedy"), Qt::LeftButton);
        QTRY_VERIFY(find<QDialog>("exportDialog") != nullptr);
        find<QDialog>("exportDialog")->reject();
        open(m_recipe);
        QVERIFY(m_window->features().recipes->namedExports().isEmpty());
    }

    void whatWasDoneGoesToAnotherPart()
    {
        QVERIFY(action("applyToPart")->isEnabled());
        const QString other = m_shop.qPath("bar-2.step");
        QVERIFY(QFile::copy(example("bar.step"), other));
        m_window->features().otherPart->applyTo(other);
        QTRY_VERIFY_WITH_TIMEOUT(find<QMessageBox>("otherPartBox") != nullptr, patience);
        const QString found = find<QMessageBox>("otherPartBox")->informativeText();
        QVERIFY2(found.contains("6 of 6 faces") && found.contains("press"), qPrintable(found));
        picture("recipe-other-part");
        QTest::mouseClick(find<QPushButton>("otherPartOpen"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(document().history().tree().records()[0].name, std::string("Apply to bar-2.step"),
                                  patience);
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QVERIFY(document().fixtures().list()[0].faces == std::vector<std::uint32_t>{0});
    }

    /// What is chosen in the dialog comes to the same as on the command line.
    void whatWasDoneGoesToAPartOfAnotherSize()
    {
        open(m_recipe);
        std::ofstream table(m_shop.path("double.csv"));
        table << "X,Y,Z,DX,DY,DZ\n";
        for (int x = -40; x <= 200; x += 40)
            for (int y = -20; y <= 40; y += 20)
                for (int z = -20; z <= 40; z += 20)
                    table << x << ',' << y << ',' << z << ',' << x << ',' << y << ',' << z << '\n';
        table.close();
        const QString larger = m_shop.qPath("bar-xl.step");
        const workshop::Outcome made = workshop::runKnead(
            {"morph", example("bar.step"), "--field", m_shop.qPath("double.csv"), "--output", larger});
        QVERIFY2(made.status == 0, made.errors.c_str());
        m_window->features().otherPart->askAbout(larger);
        auto* dialog = find<QDialog>("otherPartOptions");
        QVERIFY(dialog != nullptr && !find<QLineEdit>("otherPartFactor")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(dialog->isActiveWindow(), patience);
        find<QComboBox>("otherPartMirror")->setCurrentIndex(2);
        find<QComboBox>("otherPartSize")->setCurrentIndex(2);
        QVERIFY(find<QLineEdit>("otherPartFactor")->isEnabled());
        auto* times = find<QLineEdit>("otherPartFactor");
        times->setFocus();
        times->selectAll();
        QTest::keyClicks(times, "2");
        picture("recipe-other-part-options");
        QTest::mouseClick(find<QPushButton>("otherPartFind"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(find<QMessageBox>("otherPartBox") != nullptr, patience);
        const QString found = find<QMessageBox>("otherPartBox")->informativeText();
        QVERIFY2(found.contains("6 of 6 faces"), qPrintable(found));
        const double spacing = document().content().spacing;
        QTest::mouseClick(find<QPushButton>("otherPartOpen"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(document().history().tree().records()[0].name, std::string("Apply to bar-xl.step"),
                                  patience);
        QVERIFY(std::abs(document().content().spacing / spacing - 2) < 1e-9);
    }

    void recipesAreDroppedOnTheWindow()
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(example("bend-bar.recipe.json"))});
        QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        if (m_window->projects().isModified()) {
            QTRY_VERIFY(document().isSettled());
            m_window->projects().saveTo(m_shop.qPath("before.knead"));
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().isModified(), patience);
        }
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QApplication::sendEvent(m_window.get(), &drop);
        const auto isOpen = [this] {
            return !document().isEmpty() &&
                   document().history().tree().records()[0].name == "Open bend-bar.recipe.json";
        };
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && isOpen(), patience);
        QCOMPARE(snapshot().tools.size(), std::size_t{2});
        QCOMPARE(snapshot().tools[0].name, std::string("anvil"));
        rest();
        picture("recipe-bend-bar");
    }

    void whatCannotBeOpenedChangesNothing()
    {
        const FilledModel* before = &document().content();
        json wrong = workshop::busyRecipe(example("bar.step").toStdString());
        wrong["cells_across"] = -3;
        m_window->open({m_shop.write(wrong, "wrong.json")});
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY2(m_window->banner().sentence().contains("cells_across"), qPrintable(m_window->banner().sentence()));
        m_window->open({m_recipe, example("bar.step")});
        QVERIFY(m_window->banner().sentence().contains("alone"));
        QCOMPARE(&document().content(), before);
    }

private:
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }
    QString logText() { return find<QPlainTextEdit>("log")->toPlainText(); }

    std::string presentHash()
    {
        const History& tree = document().history().tree();
        return hexadecimal(tree.record(tree.current()).hash);
    }

    static std::string hashOf(const QStringList& arguments)
    {
        const Outcome outcome = workshop::runKnead(arguments + QStringList{"--json"});
        return outcome.status == 0 ? json::parse(outcome.out).at("state_hash").get<std::string>() : outcome.errors;
    }

    void open(const QString& recipe)
    {
        m_window->open({recipe});
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
        settle();
        QCOMPARE(snapshot().step, std::uint64_t{0});
    }

    /// Time stands still by itself.
    void waitForEnd()
    {
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled() && snapshot().time > 0.99, patience);
        QVERIFY(std::abs(snapshot().time - 1) < 0.01);
    }

    /// Drags the second tool with the mouse, in pixels.
    void drag(const QPoint& way)
    {
        ViewportWidget& view = m_window->viewport();
        const QPoint from = view.widgetPosition(snapshot().tools[1].pose.position)->toPoint();
        QTest::mouseMove(&view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 6; ++i) {
            QTest::mouseMove(&view, from + way * i / 6);
            seen();
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + way);
    }

    workshop::Workshop m_shop;
    QString m_recipe;
    QString m_project;
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowRecipeTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_recipe_test.moc"
