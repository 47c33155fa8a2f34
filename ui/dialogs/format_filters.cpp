#include "ui/dialogs/format_filters.h"

namespace knead {

QString filterOf(const Services::Format& format)
{
    QStringList patterns;
    for (const std::string& ending : format.endings)
        patterns << "*." + QString::fromStdString(ending);
    return QStringLiteral("%1 (%2)").arg(QString::fromStdString(format.name), patterns.join(' '));
}

QStringList filtersOf(const std::vector<Services::Format>& formats)
{
    QStringList filters;
    for (const Services::Format& format : formats)
        filters << filterOf(format);
    return filters;
}

} // namespace knead
