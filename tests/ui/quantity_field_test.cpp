#include "ui/panels/quantity_field.h"

#include <QSignalSpy>
#include <QtTest>

using namespace knead;

class QuantityFieldTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QWidget> m_window;
    QuantityField* m_field = nullptr;
    QLineEdit* m_other = nullptr;

    void type(const QString& text)
    {
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, text);
    }

private slots:
    void init()
    {
        m_window = std::make_unique<QWidget>();
        m_field = new QuantityField(Quantity::Pressure, m_window.get());
        m_other = new QLineEdit(m_window.get());
        m_other->move(0, 60);
        m_field->setRange(100, 1e12);
        m_field->setValue(1.2e6);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow(); // there may be no window manager that does it
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void theUnitIsInTheField() { QCOMPARE(m_field->text(), QString("1.2 MPa")); }

    void enterCommits()
    {
        QSignalSpy commits(m_field, &QuantityField::committed);
        type("3,5");
        QCOMPARE(commits.size(), 0);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(commits.size(), 1);
        QCOMPARE(commits[0][0].toDouble(), 3.5e6);
        QCOMPARE(m_field->text(), QString("3.5 MPa"));
    }

    void aZeroThatMeansSomethingIsSaidInWords()
    {
        m_field->setRange(0, 1e12);
        m_field->setZeroText("never breaks");
        QCOMPARE(m_field->text(), QString("1.2 MPa"));
        m_field->setValue(0);
        QCOMPARE(m_field->text(), QString());
        QCOMPARE(m_field->placeholderText(), QString("never breaks"));
        m_field->setValue(2e6);
        QCOMPARE(m_field->text(), QString("2 MPa"));
        // An emptied field is a 0.
        QSignalSpy commits(m_field, &QuantityField::committed);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClick(m_field, Qt::Key_Delete);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(commits.size(), 1);
        QCOMPARE(m_field->value(), 0.0);
        QVERIFY(!m_field->hasProblem());
    }

    void escapeRestores()
    {
        QSignalSpy commits(m_field, &QuantityField::committed);
        type("77 kPa");
        QTest::keyClick(m_field, Qt::Key_Escape);
        QCOMPARE(m_field->text(), QString("1.2 MPa"));
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(commits.size(), 0);
    }

    void textThatDoesNotParseStaysAndTheOldValueHolds()
    {
        QSignalSpy commits(m_field, &QuantityField::committed);
        type("1.2.3");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->text(), QString("1.2.3"));
        QVERIFY(m_field->hasProblem());
        QVERIFY(!m_field->toolTip().isEmpty());
        QCOMPARE(m_field->value(), 1.2e6);
        QCOMPARE(commits.size(), 0);
        m_field->setValue(2e6); // the simulation reports something else meanwhile
        QCOMPARE(m_field->text(), QString("1.2.3"));
        QTest::keyClick(m_field, Qt::Key_Escape);
        QVERIFY(!m_field->hasProblem());
        QCOMPARE(m_field->text(), QString("2 MPa"));
    }

    void aValueOutOfRangeIsNotTaken()
    {
        type("1 Pa");
        QTest::keyClick(m_field, Qt::Key_Return);
        QVERIFY(m_field->hasProblem());
        QCOMPARE(m_field->value(), 1.2e6);
    }

    void changingFocusNeverChangesAValue()
    {
        QSignalSpy commits(m_field, &QuantityField::committed);
        m_field->setValue(1.23456789e6); // more digits than are shown
        for (int i = 0; i < 10; ++i) {
            m_field->setFocus(Qt::TabFocusReason);
            m_other->setFocus(Qt::TabFocusReason);
        }
        QCOMPARE(m_field->value(), 1.23456789e6);
        QCOMPARE(commits.size(), 0);
    }

    void leavingTheFieldCommitsWhatWasTyped()
    {
        QSignalSpy commits(m_field, &QuantityField::committed);
        type("4 GPa");
        m_other->setFocus(Qt::TabFocusReason);
        QTRY_COMPARE(commits.size(), 1);
        QCOMPARE(m_field->value(), 4e9);
    }

    void aValueFromElsewhereLeavesTheSelectionAlone()
    {
        // While time runs, positions come in sixty times a second.
        m_field->setFocus();
        m_field->selectAll();
        m_field->setValue(7e6);
        QCOMPARE(m_field->selectedText(), QString("1.2 MPa"));
        QTest::keyClicks(m_field, "3 MPa");
        QCOMPARE(m_field->text(), QString("3 MPa"));
        QTest::keyClick(m_field, Qt::Key_Escape);
        QCOMPARE(m_field->text(), QString("7 MPa"));
        m_field->setValue(8e6);
        QCOMPARE(m_field->text(), QString("8 MPa")); // shown again once the edit has ended
    }

    void aValueFromElsewhereDoesNotDisturbTyping()
    {
        type("9");
        m_field->setValue(5e6);
        QCOMPARE(m_field->text(), QString("9"));
    }
};

QTEST_MAIN(QuantityFieldTest)
#include "quantity_field_test.moc"
