#include "io/material_library.h"
#include "support/window_on_test.h"
#include "ui/dialogs/material_comparison_dialog.h"
#include "ui/panels/quantity_field.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

using namespace knead;

/// Materials of one's own, and what follows from numbers.
class WindowMaterialTest : public QObject, WindowOnTest {
    Q_OBJECT

    QComboBox* presets() { return find<QComboBox>("materialPreset"); }

    void choose(const QString& name)
    {
        presets()->setCurrentText(name);
        emit presets()->activated(presets()->currentIndex());
    }

    void type(const char* field, const QString& text)
    {
        auto* edit = find<QuantityField>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

    /// Clicks a button that asks for a name, and types it.
    void nameWith(const char* button, const QString& name)
    {
        QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton);
        QTRY_VERIFY(find<QInputDialog>("materialNameDialog") != nullptr);
        auto* dialog = find<QInputDialog>("materialNameDialog");
        auto* edit = dialog->findChild<QLineEdit*>();
        edit->selectAll();
        QTest::keyClicks(edit, name);
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_VERIFY(find<QInputDialog>("materialNameDialog") == nullptr);
    }

    static std::string file() { return ownMaterialsFile(); }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        QFile::remove(QString::fromStdString(file()));
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void everyPresetHasAPicture()
    {
        openExample("bar.step");
        QCOMPARE(presets()->count(), static_cast<int>(m_services.materials.size()));
        for (int i = 0; i < presets()->count(); ++i)
            QVERIFY(!presets()->itemIcon(i).isNull());
        presets()->showPopup();
        QTRY_VERIFY(presets()->view()->isVisible());
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            presets()->view()->window()->grab().save(QDir(folder).filePath("presets.png"));
        presets()->hidePopup();
        picture("material-facts");
    }

    void whatFollowsFromTheNumbersIsShown()
    {
        openExample("bar.step");
        QCOMPARE(find<QLabel>("soundSpeed")->text(),
                 formatReading(std::sqrt(snapshot().materials[0].youngsModulus / snapshot().materials[0].density),
                               Quantity::Speed));
        const QString soft = find<QLabel>("stableStep")->text();
        QCOMPARE(find<QLabel>("expectedRatio")->text(), QString("keeps up with real time"));
        const double step = snapshot().stableStep;
        type("youngs_modulus_pa", "2e7 Pa"); // a hundred times as stiff: a tenth of the step
        QTRY_VERIFY(std::abs(snapshot().stableStep / step - 0.1) < 1e-3);
        QTRY_VERIFY(find<QLabel>("stableStep")->text() != soft);
        QTRY_COMPARE(find<QLabel>("soundSpeed")->text(), formatReading(std::sqrt(2e7 / 600), Quantity::Speed));
        QVERIFY(find<QLabel>("wallCells")->text().toDouble() > 1);
        QVERIFY(find<QuantityField>("youngs_modulus_pa")->toolTip().contains("100 Pa to"));
    }

    void theSpeedThatWasMeasuredIsExpected()
    {
        openExample("bar.step", 40);
        choose("Steel");
        QTRY_COMPARE(snapshot().materials[0].youngsModulus, 2.1e11);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        QTRY_VERIFY(!find<QLabel>("expectedRatio")->text().contains("about"));
    }

    void ownMaterialsAreSavedRenamedAndDeleted()
    {
        openExample("bar.step");
        type("youngs_modulus_pa", "0,3 MPa");
        type("friction", "1.5e-1");
        QTRY_COMPARE(snapshot().materials[0].friction, 0.15);
        QTRY_COMPARE(presets()->currentIndex(), -1);
        QVERIFY(!find<QToolButton>("deleteMaterial")->isEnabled());
        nameWith("saveMaterial", "Thumb clay");
        QTRY_COMPARE(presets()->currentText(), QString("Thumb clay"));
        QVERIFY(find<QToolButton>("deleteMaterial")->isEnabled());
        std::vector<MaterialPreset> kept = readMaterials(file());
        QCOMPARE(kept.size(), std::size_t{1});
        QCOMPARE(kept[0].name, std::string("Thumb clay"));
        QCOMPARE(kept[0].material, snapshot().materials[0]);

        nameWith("saveMaterial", "steel"); // there is one of that name
        QTRY_VERIFY(m_window->banner().sentence().contains("already"));
        QCOMPARE(readMaterials(file()).size(), std::size_t{1});

        QCOMPARE(m_window->banner().sentence(),
                 QString("There is a material named \"steel\" already: choose another name."));
        nameWith("saveMaterial", " ");
        QTRY_COMPARE(m_window->banner().sentence(), QString("A material needs a name: type one."));
        QCOMPARE(readMaterials(file()).size(), std::size_t{1});

        // Another window has it too.
        show(m_services);
        openExample("bar.step");
        choose("Thumb clay");
        QTRY_COMPARE(snapshot().materials[0].youngsModulus, 3e5);
        picture("material-own");
        nameWith("renameMaterial", "Print clay");
        QTRY_COMPARE(presets()->currentText(), QString("Print clay"));
        QTest::mouseClick(find<QToolButton>("deleteMaterial"), Qt::LeftButton);
        QTRY_COMPARE(presets()->currentIndex(), -1);
        QVERIFY(readMaterials(file()).empty());
        QCOMPARE(snapshot().materials[0].youngsModulus, 3e5); // bodies keep it
    }

    void aDamagedFileIsNamedAndStays()
    {
        m_window.reset();
        QDir().mkpath(QFileInfo(QString::fromStdString(file())).path());
        QFile damaged(QString::fromStdString(file()));
        QVERIFY(damaged.open(QFile::WriteOnly));
        damaged.write("{\"version\": 1, \"materials\": [{\"id\": ");
        damaged.close();
        show(m_services);
        QTRY_VERIFY(m_window->banner().sentence().contains("materials.json"));
        QVERIFY(m_window->banner().sentence().contains("Mend or remove"));
        openExample("bar.step");
        QCOMPARE(presets()->count(), static_cast<int>(m_services.materials.size()));
        type("friction", "0.11");
        QTRY_COMPARE(snapshot().materials[0].friction, 0.11);
        nameWith("saveMaterial", "Lost");
        QTRY_VERIFY(m_window->banner().sentence().contains("materials.json"));
        QVERIFY(damaged.open(QFile::ReadOnly));
        QVERIFY(damaged.readAll().endsWith("\"id\": "));
    }

    void whatCannotBeWrittenIsASentence()
    {
        m_window.reset();
        Services services = m_services;
        services.writeOwnMaterials = [](const std::vector<MaterialPreset>&) {
            throw std::runtime_error("materials.json cannot be written (no room). Make room on the disk.");
        };
        show(services);
        openExample("bar.step");
        type("friction", "0.12");
        QTRY_COMPARE(snapshot().materials[0].friction, 0.12);
        nameWith("saveMaterial", "Nowhere");
        QTRY_VERIFY(m_window->banner().sentence().contains("no room"));
        QVERIFY(m_window->banner().sentence().startsWith("The material was not saved: "));
        QCOMPARE(presets()->findText("Nowhere"), -1);
    }

    /// Also when it is locked while something is being typed, which is refused then.
    void aLockedBodyShowsWhatItKeeps()
    {
        openExample("bar.step");
        auto* field = find<QuantityField>("friction");
        const double friction = snapshot().materials[0].friction;
        const QString shown = field->text();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "0.77");
        QCOMPARE(field->text(), QString("0.77"));
        document().setLocked({Selection::Kind::Body, 0}, true);
        QVERIFY(m_window->banner().sentence().contains("locked"));
        QVERIFY(!field->isEnabled());
        type("friction", "0.88");
        seen(); // what is posted would have come by now
        QCOMPARE(snapshot().materials[0].friction, friction);
        QCOMPARE(field->value(), friction);
        QCOMPARE(field->text(), shown);
        document().setLocked({Selection::Kind::Body, 0}, false);
        type("friction", "0.66");
        QTRY_COMPARE(snapshot().materials[0].friction, 0.66);
        QCOMPARE(field->value(), 0.66);
    }

    void twoMaterialsStandSideBySide()
    {
        openExample("bar.step");
        QTest::mouseClick(find<QToolButton>("compareMaterials"), Qt::LeftButton);
        QTRY_VERIFY(find<QDialog>("materialComparison") != nullptr);
        auto* right = find<QComboBox>("comparedRight");
        right->setCurrentIndex(right->findText("Steel"));
        auto* table = find<QTreeWidget>("comparedNumbers");
        const auto rows = table->findItems("Young's modulus", Qt::MatchExactly);
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows[0]->text(1), QString("200 kPa"));
        QCOMPARE(rows[0]->text(2), QString("210 GPa"));
        QCOMPARE(rows[0]->text(3), QString("1,050,000 times"));
        QCOMPARE(table->findItems("Density", Qt::MatchExactly)[0]->text(3), QString("13.1 times"));
        auto* left = find<QComboBox>("comparedLeft");
        const int first = left->currentIndex();
        left->setCurrentIndex(right->currentIndex());
        right->setCurrentIndex(first);
        QCOMPARE(table->findItems("Young's modulus", Qt::MatchExactly)[0]->text(3), QString("1/1,050,000 of it"));
        for (int row = 0; row < table->topLevelItemCount(); ++row)
            QVERIFY2(!table->topLevelItem(row)->text(3).contains('e' + QString("+")),
                     qPrintable(table->topLevelItem(row)->text(3)));
        picture("material-comparison");
        find<QDialog>("materialComparison")->close();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowMaterialTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_material_test.moc"
