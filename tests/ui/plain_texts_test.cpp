#include "ui/plain_texts.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QToolTip>
#include <QtTest>

#include <algorithm>

using namespace knead;

namespace {

const QString name = QStringLiteral("<img src='/etc/hostname'><b>bracket</b>");

} // namespace

/// Names from files are shown as they stand.
class PlainTextsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        showTextsAsTheyStand();
        showTextsAsTheyStand();
        QCOMPARE(qApp->findChildren<QObject*>("plainTexts").size(), 1);
    }

    void labelsShowThem()
    {
        QLabel label(name);
        label.show();
        QCOMPARE(label.textFormat(), Qt::PlainText);
        QCOMPARE(label.text(), name);
        QLabel own("<b>Knead</b>");
        own.setTextFormat(Qt::RichText);
        own.show();
        QCOMPARE(own.textFormat(), Qt::RichText);
    }

    void boxesShowThem()
    {
        QMessageBox box(QMessageBox::Warning, "Knead", name);
        box.setInformativeText(name);
        box.show();
        const QList<QLabel*> labels = box.findChildren<QLabel*>();
        QCOMPARE(std::count_if(labels.begin(), labels.end(), [](const QLabel* label) { return label->text() == name; }),
                 2);
        for (const QLabel* label : labels)
            QVERIFY2(label->textFormat() == Qt::PlainText, qPrintable(label->objectName()));
    }

    void toolTipsShowThem()
    {
        QToolTip::showText({100, 100}, name);
        const QLabel* tip = nullptr;
        for (const QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("QTipLabel"))
                tip = qobject_cast<const QLabel*>(widget);
        QVERIFY(tip != nullptr);
        QCOMPARE(tip->text(), name);
        QCOMPARE(tip->textFormat(), Qt::PlainText);
    }
};

QTEST_MAIN(PlainTextsTest)
#include "plain_texts_test.moc"
