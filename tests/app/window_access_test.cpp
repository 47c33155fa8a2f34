#include "support/cut_texts.h"
#include "support/window_on_test.h"
#include "ui/panels/plot_view.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/timeline_axis.h"
#include "ui/preferences/preferences_feature.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QToolButton>

using namespace knead;

/// Whether people can use the window who do not see it, see little, or have no mouse.
class WindowAccessTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
        m_usualHeight = QFontMetrics(QApplication::font()).height();
    }

    void init()
    {
        QSettings().clear();
        QSettings().setValue("language", "en");
        if (QTest::currentTestFunction() == QByteArray("textsThatWereChosenAreThereFromTheStart"))
            QSettings().setValue("textPercent", 150);
        show(m_services);
    }

    void cleanup()
    {
        if (m_window != nullptr)
            setTexts(100);
        m_window.reset();
    }

    /// First of all: in a program where no window was yet.
    void textsThatWereChosenAreThereFromTheStart()
    {
        openExample("bar.step", 10);
        QStringList small;
        for (const QLabel* label : m_window->findChildren<QLabel*>())
            if (label->isVisible() && !label->text().isEmpty() &&
                label->fontMetrics().height() < m_usualHeight * 14 / 10)
                small << label->text();
        QVERIFY2(small.isEmpty(), qPrintable(small.join(", ")));
    }

    void whatTakesTheKeyboardHasANameARoleAndAValue()
    {
        fillTheWindow();
        QStringList lacking;
        int count = 0;
        for (QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (widget->focusPolicy() == Qt::NoFocus || isInside(*widget))
                continue;
            const auto* tabs = qobject_cast<QTabBar*>(widget);
            if (tabs != nullptr && tabs->count() == 0)
                continue; // kept by the window for panels that will share a place
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            if (button != nullptr && button->isHidden() && button->text().isEmpty())
                continue; // a banner has it only where there is something to do
            QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
            QVERIFY(told != nullptr);
            ++count;
            if (told->text(QAccessible::Name).isEmpty())
                lacking << wordsOf(*widget) + " has no name";
            if (told->role() == QAccessible::NoRole || told->role() == QAccessible::Client)
                lacking << wordsOf(*widget) + " has no role";
            // The name of a list of choices is what is chosen: what it is for says its label or its description.
            if (qobject_cast<QComboBox*>(widget) != nullptr && told->text(QAccessible::Description).isEmpty() &&
                told->relations(QAccessible::Label).isEmpty())
                lacking << wordsOf(*widget) + " has no label";
            const bool isField = qobject_cast<QLineEdit*>(widget) != nullptr ||
                                 qobject_cast<QComboBox*>(widget) != nullptr ||
                                 qobject_cast<QAbstractSpinBox*>(widget) != nullptr;
            // An empty field says what it means in the words that it shows instead.
            if (isField && !hasNothingChosen(*widget) && told->text(QAccessible::Value).isEmpty() &&
                told->text(QAccessible::Description).isEmpty())
                lacking << wordsOf(*widget) + " has no value";
        }
        QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join("\n")));
        QVERIFY(count > 100);
    }

    void whatIsDrawnSaysItsName()
    {
        fillTheWindow();
        QStringList lacking;
        for (QWidget* widget : m_window->findChildren<QWidget*>()) {
            const QString name = widget->objectName();
            const bool isDrawn = qobject_cast<PlotView*>(widget) != nullptr || name == "frameBudget" ||
                                 name == "timelineAxis" || name == "viewport" || name == "banner";
            if (isDrawn && QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name).isEmpty())
                lacking << wordsOf(*widget);
            if (auto* button = qobject_cast<QToolButton*>(widget);
                button != nullptr && !isInside(*widget) &&
                QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name).isEmpty() && !button->isHidden())
                lacking << wordsOf(*widget);
        }
        QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join("\n")));
    }

    void theViewSaysWhatIsSelected()
    {
        QAccessibleInterface* view = QAccessible::queryAccessibleInterface(&m_window->viewport());
        QCOMPARE(view->role(), QAccessible::Canvas);
        QCOMPARE(view->text(QAccessible::Name), QString("3D view"));
        QCOMPARE(view->text(QAccessible::Value), QString("Nothing is open"));
        openExample("bar.step", 10);
        document().select({});
        QCOMPARE(view->text(QAccessible::Value), QString("Nothing is selected"));
        document().select({Selection::Kind::Body, 0});
        QCOMPARE(view->text(QAccessible::Value), "Selected: " + document().nameOfBody(0));
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        document().select({Selection::Kind::Tool, snapshot().tools[0].id});
        QCOMPARE(view->text(QAccessible::Value), "Selected: " + QString::fromStdString(snapshot().tools[0].name));
    }

    void theTimelineIsASliderThatKeysMove()
    {
        openExample("bar.step", 10);
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        action("gravity")->trigger();
        action("play")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.02, patience);
        action("play")->trigger();
        QTRY_VERIFY(!snapshot().playing);
        auto* axis = find<TimelineAxis>("timelineAxis");
        QTRY_VERIFY(!axis->timeline().pictures.empty() && axis->timeline().end > 0.02);
        QAccessibleInterface* told = QAccessible::queryAccessibleInterface(axis);
        QCOMPARE(told->role(), QAccessible::Slider);
        QVERIFY2(told->text(QAccessible::Value).contains(", entry "), qPrintable(told->text(QAccessible::Value)));
        QVERIFY(told->valueInterface() != nullptr);
        QCOMPARE(told->valueInterface()->maximumValue().toDouble(), axis->timeline().end);
        axis->setFocus(Qt::TabFocusReason);
        QVERIFY(axis->hasFocus());
        QTest::keyClick(axis, Qt::Key_Home);
        QTRY_VERIFY(axis->lookedAt().has_value());
        QCOMPARE(*axis->lookedAt(), 0.0);
        QCOMPARE(told->valueInterface()->currentValue().toDouble(), 0.0);
        QVERIFY2(told->text(QAccessible::Value).startsWith("0 "), qPrintable(told->text(QAccessible::Value)));
        QTest::keyClick(axis, Qt::Key_Right);
        QTRY_VERIFY(axis->lookedAt().value_or(0) > 0);
        QTest::keyClick(axis, Qt::Key_Left);
        QTRY_COMPARE(axis->lookedAt().value_or(1), axis->timeline().pictures.front().at);
        QTest::keyClick(axis, Qt::Key_Escape);
        QTRY_VERIFY(!axis->lookedAt().has_value());
    }

    /// Tab from stop to stop: each looks otherwise with the keyboard than without.
    void whereTabLedToIsSeen()
    {
        openExample("bar.step", 10);
        QApplication::setCursorFlashTime(0);
        m_window->viewport().clearFocus();
        m_window->viewport().setFocus(Qt::TabFocusReason);
        QSet<const QWidget*> stops;
        QStringList unseen;
        QWidget* stop = QApplication::focusWidget();
        for (int i = 0; i < 400 && stop != nullptr && !stops.contains(stop); ++i) {
            stops << stop;
            QTest::qWait(30);
            const QImage with = pictureOf(*stop);
            QTest::keyClick(stop, Qt::Key_Tab);
            QTest::qWait(30);
            if (pictureOf(*stop) == with)
                unseen << wordsOf(*stop);
            stop = QApplication::focusWidget();
        }
        QVERIFY(stops.size() > 20);
        QVERIFY(stops.contains(&m_window->viewport()));
        QVERIFY(stops.contains(find<QWidget>("timelineAxis")));
        QVERIFY2(unseen.isEmpty(), qPrintable(unseen.join("\n")));
    }

    /// One stop of Tab for all brushes, arrows between them; Space stays that of the simulation.
    void stripsAreReachedByKeys()
    {
        openExample("bar.step", 10);
        for (const char* name : {"selectionBar", "sculptBar"}) {
            auto* strip = find<QWidget>(name);
            QList<QToolButton*> buttons = strip->findChildren<QToolButton*>(Qt::FindDirectChildrenOnly);
            buttons.removeIf([](const QToolButton* one) { return one->objectName().startsWith("qt_"); });
            const auto stops = std::ranges::count_if(
                buttons, [](const QToolButton* one) { return one->focusPolicy() & Qt::TabFocus; });
            QCOMPARE(stops, 1);
            buttons[0]->setFocus(Qt::TabFocusReason);
            QTest::keyClick(buttons[0], Qt::Key_Down);
            QVERIFY(buttons[1]->hasFocus());
            QCOMPARE(buttons[0]->focusPolicy(), Qt::NoFocus);
            const bool wasChecked = buttons[1]->isChecked();
            QTest::keyClick(buttons[1], Qt::Key_Return);
            QVERIFY(buttons[1]->isChecked() != wasChecked);
            buttons[1]->setFocus(Qt::TabFocusReason);
            QTest::keyClick(buttons[1], Qt::Key_Up);
            QVERIFY(buttons[0]->hasFocus());
            QTest::keyClick(buttons[0], Qt::Key_Up);
            QVERIFY(buttons[0]->hasFocus());
        }
    }

    void textsGrowAtOnceAndAreNotCut()
    {
        m_window->resize(1920, 1080);
        QTRY_COMPARE(m_window->width(), 1920);
        fillTheWindow();
        const int usual = m_window->fontMetrics().height();
        setTexts(150);
        QTRY_VERIFY(m_window->fontMetrics().height() >= usual * 14 / 10);
        QCOMPARE(m_window->size(), QSize(1920, 1080));
        QStringList cut;
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            drawn();
            QTest::qWait(50);
            picture(qPrintable("texts-150-" + dock->objectName()));
            cut << cutTextsIn(*dock);
        }
        document().select({Selection::Kind::Body, 0});
        auto* properties = find<QDockWidget>("propertiesDock");
        properties->raise();
        drawn();
        QTest::qWait(50);
        picture("texts-150-body");
        cut << cutTextsIn(*properties);
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
    }

    void dialogsOfLargeTextsAreNotCut()
    {
        m_window->resize(1920, 1080);
        openExample("bar.step", 10);
        setTexts(150);
        QStringList cut;
        for (const char* name : {"preferences", "shortcuts", "about", "savePicture", "export"}) {
            QAction* asked = action(name);
            QVERIFY2(asked != nullptr, name);
            asked->trigger();
            QTest::qWait(100);
            int seen = 0;
            for (QDialog* dialog : m_window->findChildren<QDialog*>()) {
                if (!dialog->isVisible())
                    continue;
                picture(qPrintable(QStringLiteral("texts-150-dialog-") + name));
                cut << cutTextsIn(*dialog);
                dialog->close();
                ++seen;
            }
            QVERIFY2(seen > 0, name);
            QCoreApplication::sendPostedEvents(nullptr,
                                               QEvent::DeferredDelete); // one that was closed is not asked again
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
    }

private:
    int m_usualHeight = 0; ///< of a line of text, before there was a window [pixels]

    /// Something of all kinds, so that panels have what they show.
    void fillTheWindow()
    {
        openExample("bar.step", 10);
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>())
            dock->show();
        drawn();
    }

    void setTexts(int percent)
    {
        Preferences wanted = readPreferences();
        wanted.textPercent = percent;
        m_window->features().preferences->set(wanted);
    }

    /// What makes up another widget: the field in a list of choices, the list below it, the ground of lists.
    static bool isInside(const QWidget& widget)
    {
        const QString name = widget.objectName();
        if (name.startsWith("qt_"))
            return true;
        for (const QWidget* owner = widget.parentWidget(); owner != nullptr; owner = owner->parentWidget())
            if (qobject_cast<const QComboBox*>(owner) != nullptr ||
                qobject_cast<const QAbstractSpinBox*>(owner) != nullptr ||
                qobject_cast<const QAbstractItemView*>(owner) != nullptr ||
                qobject_cast<const QLineEdit*>(owner) != nullptr || qobject_cast<const QTabBar*>(owner) != nullptr ||
                owner->inherits("QDialog") != widget.window()->inherits("QDialog"))
                return true;
        return false;
    }

    static bool hasNothingChosen(const QWidget& widget)
    {
        const auto* choice = qobject_cast<const QComboBox*>(&widget);
        const auto* line = qobject_cast<const QLineEdit*>(&widget);
        return (choice != nullptr && choice->currentIndex() < 0) ||
               (line != nullptr && qobject_cast<const QuantityField*>(&widget) == nullptr) ||
               (line != nullptr && line->text().isEmpty() && !line->isEnabled());
    }

    static QString wordsOf(const QWidget& widget)
    {
        QString words = QStringLiteral("%1 '%2' in '%3'")
                            .arg(QString(widget.metaObject()->className()), widget.objectName(),
                                 widget.parentWidget() != nullptr ? widget.parentWidget()->objectName() : QString());
        if (const auto* label = qobject_cast<const QLabel*>(&widget))
            words += " \"" + label->text() + '"';
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
            words += " \"" + button->text() + '"';
        return words + QStringLiteral(" %1x%2, %3x%4")
                           .arg(widget.width())
                           .arg(widget.height())
                           .arg(widget.sizeHint().width())
                           .arg(widget.sizeHint().height());
    }

    /// With what is around it, where frames are drawn outside.
    QImage pictureOf(QWidget& widget) { return widget.grab().toImage(); }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowAccessTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_access_test.moc"
