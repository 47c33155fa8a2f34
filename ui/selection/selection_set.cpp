#include "ui/selection/selection_set.h"

#include <QJsonArray>

#include <algorithm>
#include <iterator>

namespace knead {

namespace {

constexpr const char* levelWords[levelCount] = {"parts", "faces", "edges", "objects", "connections"};
constexpr Region::Item mostItems = 50'000'000; // of one part: more is damage

/// Direction and object of connections do not fit together into a number that JSON keeps.
QJsonArray rangeOf(Region::Item first, Region::Item last)
{
    return {static_cast<qint64>(first >> 32U), static_cast<qint64>(first & 0xffffffffU),
            static_cast<qint64>(last & 0xffffffffU)};
}

QJsonArray toJson(const Region::Items& items)
{
    QJsonArray ranges;
    for (std::size_t first = 0, last = 0; first < items.size(); first = last) {
        last = first + 1;
        while (last < items.size() && items[last] == items[last - 1] + 1 && items[last] >> 32U == items[first] >> 32U)
            ++last;
        ranges.append(rangeOf(items[first], items[last - 1]));
    }
    return ranges;
}

Region::Items itemsFrom(const QJsonArray& ranges)
{
    Region::Items items;
    for (const QJsonValue& range : ranges) {
        const auto high = static_cast<Region::Item>(range[0].toInteger(-1)) << 32U;
        const qint64 first = range[1].toInteger(-1);
        const qint64 last = range[2].toInteger(-1);
        if (range[0].toInteger(-1) < 0 || first < 0 || last < first || last > 0xffffffffLL ||
            static_cast<Region::Item>(last - first) + items.size() > mostItems)
            return {};
        for (qint64 item = first; item <= last; ++item)
            items.push_back(high | static_cast<Region::Item>(item));
    }
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    return items;
}

} // namespace

QJsonObject toJson(const SelectionSet& set)
{
    QJsonArray parts;
    for (const auto& [part, items] : set.items)
        parts.append(QJsonObject{{"part", static_cast<qint64>(part)}, {"items", toJson(items)}});
    return {{"name", QString::fromStdString(set.name)},
            {"level", levelWords[static_cast<std::size_t>(set.level)]},
            {"start", static_cast<qint64>(set.start)},
            {"parts", parts}};
}

std::optional<SelectionSet> selectionSetFrom(const QJsonObject& json)
{
    SelectionSet set;
    set.name = json["name"].toString().toStdString();
    const auto* word = std::find(std::begin(levelWords), std::end(levelWords), json["level"].toString());
    if (set.name.empty() || word == std::end(levelWords))
        return std::nullopt;
    set.level = static_cast<Level>(word - std::begin(levelWords));
    set.start = static_cast<std::uint32_t>(json["start"].toInteger());
    for (const QJsonValue& part : json["parts"].toArray())
        if (Region::Items items = itemsFrom(part["items"].toArray()); !items.empty() && part["part"].toInteger(-1) >= 0)
            set.items[static_cast<std::size_t>(part["part"].toInteger())] = std::move(items);
    return set.items.empty() ? std::nullopt : std::optional(set);
}

} // namespace knead
