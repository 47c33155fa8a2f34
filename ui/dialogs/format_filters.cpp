#include "ui/dialogs/format_filters.h"

namespace knead {

namespace {

QString patternsOf(const std::vector<std::string>& endings)
{
    QStringList patterns;
    for (const std::string& ending : endings)
        patterns << "*." + QString::fromStdString(ending);
    return patterns.join(' ');
}

QString filterWith(const FileFormat& format, const QString& patterns)
{
    return QStringLiteral("%1 (%2)").arg(QString::fromStdString(format.name), patterns);
}

} // namespace

QString filterOf(const FileFormat& format)
{
    return filterWith(format, patternsOf(format.endings));
}

QStringList filtersToRead()
{
    QStringList filters;
    for (const FileFormat& format : fileFormats)
        if (format.isRead)
            filters << filterWith(format, patternsOf(format.endingsRead()));
    return filters;
}

QString patternsToRead()
{
    QStringList patterns;
    for (const FileFormat& format : fileFormats)
        if (format.isRead)
            patterns << patternsOf(format.endingsRead());
    return patterns.join(' ');
}

} // namespace knead
