#include "ui/selection/region_words.h"

#include "ui/units.h"

#include <QCoreApplication>

namespace knead {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Region)
};

} // namespace

QString wordsFor(const Region& region, const RegionSize& size)
{
    const QString count = formatCount(size.count);
    const bool isOne = size.count == 1;
    switch (region.level) {
    case Level::Part:
        return (isOne ? Words::tr("1 part, %2") : Words::tr("%1 parts, %2").arg(count))
            .replace("%2", formatReading(size.volume, Quantity::Volume));
    case Level::Face:
        if (!size.name.empty())
            return Words::tr("Face \"%1\", %2")
                .arg(QString::fromStdString(size.name), formatReading(size.area, Quantity::Area));
        return (isOne ? Words::tr("1 face, %2") : Words::tr("%1 faces, %2").arg(count))
            .replace("%2", formatReading(size.area, Quantity::Area));
    case Level::Edge:
        return (isOne ? Words::tr("1 edge, %2") : Words::tr("%1 edges, %2").arg(count))
            .replace("%2", formatReading(size.length, Quantity::Length));
    case Level::Object:
        return (isOne ? Words::tr("1 object, %2") : Words::tr("%1 objects, %2").arg(count))
            .replace("%2", formatReading(size.volume, Quantity::Volume));
    case Level::Connection:
        break;
    }
    return (isOne ? Words::tr("1 connection, %2") : Words::tr("%1 connections, %2").arg(count))
        .replace("%2", formatReading(size.length, Quantity::Length));
}

} // namespace knead
