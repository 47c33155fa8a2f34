#include "ui/measuring/comparison_report.h"

#include <QRegularExpression>
#include <QtTest>

#include <cmath>
#include <string>

using namespace knead;

/// The page of a comparison.
class ComparisonReportTest : public QObject {
    Q_OBJECT

    static ComparisonReport reportOf(const QSize& picture, int bodies)
    {
        ComparisonReport report{.part = "part.step",
                                .when = QDateTime::currentDateTime(),
                                .comparison = {},
                                .picture = QImage(picture, QImage::Format_RGB32),
                                .measurements = {}};
        report.picture.fill(Qt::gray);
        for (int i = 0; i < bodies; ++i)
            report.comparison.bodies.push_back({.name = "Body " + std::to_string(i), .rest = {}, .now = {}});
        return report;
    }

    static qsizetype pagesOf(const QByteArray& pdf)
    {
        static const QRegularExpression page("/Type\\s*/Page\\b(?!s)");
        qsizetype count = 0;
        for (auto match = page.globalMatch(QString::fromLatin1(pdf)); match.hasNext(); match.next())
            ++count;
        return count;
    }

private slots:
    void thePictureKeepsItsAspect()
    {
        static const QRegularExpression image("<img width=\"(\\d+)\" height=\"(\\d+)\"");
        for (const QSize& size : {QSize(1600, 900), QSize(900, 1600), QSize(700, 700), QSize(300, 200)}) {
            const QRegularExpressionMatch match = image.match(htmlOf(reportOf(size, 1)));
            QVERIFY(match.hasMatch());
            const double width = match.captured(1).toDouble();
            const double height = match.captured(2).toDouble();
            QVERIFY(std::abs(width / height - 1.0 * size.width() / size.height()) < 0.01);
            QVERIFY(width <= 640 && height <= 420);
        }
    }

    void pictureAndTableShareAPage()
    {
        for (const QSize& size : {QSize(1600, 900), QSize(900, 1600), QSize(700, 700)})
            for (const int bodies : {1, 3, 8})
                QCOMPARE(pagesOf(bytesOf(reportOf(size, bodies), "report.pdf")), 1);
        QVERIFY(pagesOf(bytesOf(reportOf({1600, 900}, 80), "report.pdf")) > 1);
    }

    void aReportNeedsNoPicture()
    {
        const ComparisonReport report = reportOf({}, 2);
        QVERIFY(!htmlOf(report).contains("<img"));
        QCOMPARE(pagesOf(bytesOf(report, "report.pdf")), 1);
    }
};

QTEST_MAIN(ComparisonReportTest)
#include "comparison_report_test.moc"
