#include "ui/language/language.h"
#include "ui/language/retranslation.h"
#include "ui/language/said.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>
#include <QtTest>

using namespace knead;

namespace {

QString tool(const char* text)
{
    return QCoreApplication::translate("Actions", text);
}

QString tree(const char* text)
{
    return QCoreApplication::translate("ModelTree", text);
}

} // namespace

/// What a window shows, in one language after the other.
class RetranslationTest : public QObject {
    Q_OBJECT

private slots:
    void init() { speak("en"); }
    void cleanup() { speak("en"); }

    void labelsButtonsAndTitlesAreSaidAnew()
    {
        QMainWindow window;
        auto* button = new QPushButton(tool("Ball"), &window);
        button->setToolTip(tool("One time step"));
        auto* dock = new QDockWidget(tree("Tools"), &window);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        QMenu* menu = window.menuBar()->addMenu(tool("Ball"));
        QAction* action = menu->addAction(tool("Ball"));
        auto* form = new QFormLayout(new QWidget(&window));
        auto* field = new QLineEdit;
        field->setPlaceholderText(tool("Ball"));
        form->addRow(tool("Ball"), field);
        speak("de");
        QCOMPARE(button->text(), QString("Kugel"));
        QCOMPARE(button->toolTip(), QString("Ein Zeitschritt"));
        QCOMPARE(dock->windowTitle(), QString("Werkzeuge"));
        QCOMPARE(dock->toggleViewAction()->text(), QString("Werkzeuge"));
        QCOMPARE(menu->title(), QString("Kugel"));
        QCOMPARE(action->text(), QString("Kugel"));
        QCOMPARE(field->placeholderText(), QString("Kugel"));
        QCOMPARE(qobject_cast<QLabel*>(form->labelForField(field))->text(), QString("Kugel"));
        speak("en");
        QCOMPARE(button->text(), QString("Ball"));
        QCOMPARE(action->text(), QString("Ball"));
    }

    void choicesTabsAndLinesAreSaidAnew()
    {
        QWidget window;
        auto* box = new QComboBox(&window);
        box->addItems({tool("Block"), tool("Ball")});
        box->setCurrentIndex(1);
        auto* tabs = new QTabWidget(&window);
        tabs->addTab(new QWidget, tool("Ball"));
        auto* lines = new QTreeWidget(&window);
        lines->setHeaderLabels({tool("Ball")});
        new QTreeWidgetItem(lines, {tree("Tools")});
        QSignalSpy chosen(box, &QComboBox::currentTextChanged);
        speak("de");
        QCOMPARE(box->itemText(1), QString("Kugel"));
        QCOMPARE(box->currentIndex(), 1);
        QVERIFY(chosen.isEmpty());
        QCOMPARE(tabs->tabText(0), QString("Kugel"));
        QCOMPARE(lines->headerItem()->text(0), QString("Kugel"));
        QCOMPARE(lines->topLevelItem(0)->text(0), QString("Werkzeuge"));
    }

    /// "Block" is German, too.
    void whatIsTheSameInOneLanguageIsNotLostForTheNext()
    {
        QLabel label(tool("Block"));
        speak("de");
        QCOMPARE(label.text(), QString("Block"));
        speak("fr");
        QCOMPARE(label.text(), QString("Bloc"));
        speak("en");
        QCOMPARE(label.text(), QString("Block"));
    }

    void numbersInSentencesHaveTheSignOfTheLanguage()
    {
        QWidget window;
        auto* box = new QComboBox(&window);
        box->addItem(said(Message("TimelinePanel", "%1x").with(numberMessage(0.25))));
        QCOMPARE(box->itemText(0), QString("0.25x"));
        speak("de");
        QCOMPARE(box->itemText(0), QString("0,25x"));
        speak("en");
        QCOMPARE(box->itemText(0), QString("0.25x"));
    }

    void sentencesAreSaidAnewWithWhatIsInThem()
    {
        const Message rename = Message("EntryNames", "Add %1").with(Message("Actions", "Ball"));
        QLabel label(said(rename));
        QCOMPARE(label.text(), QString("Add Ball"));
        speak("de");
        QCOMPARE(label.text(), said(rename));
        QCOMPARE(label.text(), QString("Kugel hinzufügen"));
    }

    /// Though it reads like something that the program says.
    void whatAPersonNamedStays()
    {
        QLabel label(QString::fromUtf8("Ball"));
        QLineEdit edit;
        edit.setText(QString::fromUtf8("Tools"));
        QLabel same(tool("Ball"));
        speak("de");
        QCOMPARE(label.text(), QString("Ball"));
        QCOMPARE(edit.text(), QString("Tools"));
        QCOMPARE(same.text(), QString("Kugel"));
    }

    void phrasesThatReadAlikeStayApart()
    {
        QLabel back(QCoreApplication::translate("ViewName", "Back"));
        QLabel before(QCoreApplication::translate("Tour", "Back"));
        QCOMPARE(back.text(), before.text());
        speak("de");
        QCOMPARE(back.text(), QCoreApplication::translate("ViewName", "Back"));
        QCOMPARE(before.text(), QCoreApplication::translate("Tour", "Back"));
        QVERIFY(back.text() != before.text());
    }

    /// Numbers come and go all day; what is shown is known all the same.
    void whatIsShownIsNotForgottenOverMuchElse()
    {
        QLabel label(said(Message("EntryNames", "%1 s").with("0.25")));
        QLabel position(said(Message("ToolPanel", "Position %1").with("X")));
        for (int i = 0; i < 50'000; ++i)
            Q_UNUSED(said(Message("ToolPanel", "Position %1").with(i)));
        speak("nl");
        QCOMPARE(position.text(), QString("Positie X"));
        QCOMPARE(saidAnew(position.text()), position.text());
    }
};

QTEST_MAIN(RetranslationTest)
#include "retranslation_test.moc"
