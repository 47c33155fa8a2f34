// The report of a comparison as a page, in HTML and PDF.
#include "ui/measuring/comparison_report.h"

#include "ui/units.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QLocale>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <cmath>

namespace knead {

namespace {

constexpr QSize largestPicture(640, 420);       // on the page [pixels]
constexpr QSize smallestPicture(240, 160);      // for which the table comes onto the same page [pixels]
constexpr int dotsPerInch = 150;                // of the PDF
constexpr double pageMargin = 15;               // of the PDF [mm]
constexpr double pixelsPerPoint = 96.0 / 72;    // on the page
constexpr const char* pictureInPdf = "picture"; // its name among the resources of the page

struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(ComparisonReport)
};

QString changed(double rest, double now, Quantity quantity)
{
    constexpr double least = 0.005; // what two decimals show
    const double share = rest != 0 && std::abs(100 * (now / rest - 1)) >= least ? 100 * (now / rest - 1) : 0;
    return QStringLiteral("%1 → %2 (%3 %)")
        .arg(formatQuantity(rest, quantity), formatQuantity(now, quantity),
             share == 0 ? QStringLiteral("0") : localNumber(QString::asprintf("%+.2f", share)));
}

QString cell(const QString& text, const char* tag = "td")
{
    return QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped());
}

QString rowOf(const BodyComparison& body)
{
    const double moved = (body.now.center - body.rest.center).norm();
    return "<tr>" + cell(QString::fromStdString(body.name)) +
           cell(formatReading(body.largestDistance, Quantity::Length)) +
           cell(formatReading(body.meanDistance, Quantity::Length)) +
           cell(std::isnan(body.largestDisplacement) ? QStringLiteral("–")
                                                     : formatReading(body.largestDisplacement, Quantity::Length)) +
           cell(changed(body.rest.volume, body.now.volume, Quantity::Volume)) +
           cell(body.now.mass > 0 ? formatQuantity(body.now.mass, Quantity::Mass) : QStringLiteral("–")) +
           cell(formatReading(moved, Quantity::Length)) + "</tr>";
}

QString tableOf(const Comparison& comparison)
{
    QString text = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"5\"><tr>";
    for (const QString& heading :
         {ReportWords::tr("Part"), ReportWords::tr("Largest distance"), ReportWords::tr("Mean distance"),
          ReportWords::tr("Largest displacement"), ReportWords::tr("Volume"), ReportWords::tr("Mass"),
          ReportWords::tr("Center of mass moved")})
        text += cell(heading, "th");
    text += "</tr>";
    for (const BodyComparison& body : comparison.bodies)
        text += rowOf(body);
    return text + "</table>";
}

/// As an address that holds all of it.
QString addressOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return "data:image/png;base64," + QString::fromLatin1(bytes.toBase64());
}

/// As large as fits into a room, width to height as they are.
QString pictureOf(const QImage& image, const QString& address, const QSize& room)
{
    if (image.isNull())
        return {};
    const QSize size = image.size().scaled(room, Qt::KeepAspectRatio);
    return QStringLiteral("<p><img width=\"%1\" height=\"%2\" src=\"%3\"></p>")
        .arg(size.width())
        .arg(size.height())
        .arg(address);
}

QString pageOf(const ComparisonReport& report, const QString& picture);

/// With the largest picture beside which all is on one page; where nothing helps, with the largest.
void layOut(QTextDocument& page, const ComparisonReport& report)
{
    page.addResource(QTextDocument::ImageResource, QUrl(QLatin1String(pictureInPdf)), report.picture);
    const auto fill = [&](const QSize& room) {
        page.setHtml(pageOf(report, pictureOf(report.picture, QLatin1String(pictureInPdf), room)));
        return page.pageCount() == 1;
    };
    constexpr double smaller = 0.85;
    for (QSize room = largestPicture; room.height() >= smallestPicture.height(); room *= smaller)
        if (fill(room))
            return;
    fill(largestPicture);
}

QByteArray pdfOf(const ComparisonReport& report)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(dotsPerInch);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageOrientation(QPageLayout::Landscape);
        writer.setTitle(report.part);
        writer.setCreator(QStringLiteral("Knead"));
        writer.setPageMargins(QMarginsF(pageMargin, pageMargin, pageMargin, pageMargin), QPageLayout::Millimeter);
        QTextDocument page;
        page.setDefaultFont(QFont("sans-serif", 9));
        page.setPageSize(pixelsPerPoint * writer.pageLayout().paintRect(QPageLayout::Point).size());
        layOut(page, report);
        page.print(&writer);
    }
    return bytes;
}

QString pageOf(const ComparisonReport& report, const QString& picture)
{
    QString text =
        "<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>" + report.part.toHtmlEscaped() +
        "</title><style>body { font-family: sans-serif; color: #1d2126; } table { border-collapse: "
        "collapse; } th { background-color: #e9ecef; } img, tr { break-inside: avoid; }</style></head><body>";
    const bool isOfFiles = !report.original.isEmpty();
    const QString title = isOfFiles ? ReportWords::tr("%1 beside %2").arg(report.part, report.original)
                                    : ReportWords::tr("%1 beside its original").arg(report.part);
    const QString when = QLocale().toString(report.when, QLocale::ShortFormat);
    const QString origin = isOfFiles ? ReportWords::tr("Written by Knead on %1.").arg(when)
                                     : ReportWords::tr("At %1 of simulated time. Written by Knead on %2.")
                                           .arg(formatReading(report.comparison.time, Quantity::Time), when);
    text += "<h2>" + title.toHtmlEscaped() + "</h2><p>" + origin.toHtmlEscaped() + "</p>";
    text += picture + tableOf(report.comparison);
    text +=
        "<p><small>" +
        (isOfFiles ? ReportWords::tr("Distances are those of each surface from the nearest point of the other, the "
                                     "larger of both; the mean is by area.")
                   : ReportWords::tr("Distances are those of the deformed skin from the nearest point of the original "
                                     "surface; the mean is by area. A displacement is the way of a point of the skin "
                                     "since rest."))
            .toHtmlEscaped() +
        "</small></p>";
    if (!report.measurements.isEmpty())
        text += "<h3>" + ReportWords::tr("Measurements").toHtmlEscaped() + "</h3>" + report.measurements;
    return text + "</body></html>";
}

} // namespace

QString htmlOf(const ComparisonReport& report)
{
    return pageOf(report, pictureOf(report.picture, addressOf(report.picture), largestPicture));
}

QByteArray bytesOf(const ComparisonReport& report, const QString& name)
{
    return name.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive) ? pdfOf(report) : htmlOf(report).toUtf8();
}

} // namespace knead
