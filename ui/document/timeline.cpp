#include "ui/document/timeline.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

using Entry = History::Entry;

/// The entries of the way, of one start.
std::vector<Entry> wayOf(const History& history, bool isUnderWay)
{
    std::vector<Entry> way = history.pathTo(history.current());
    const std::uint32_t start = history.record(history.current()).start;
    const auto isOther = [&](Entry entry) { return history.record(entry).start != start; };
    way.erase(way.begin(), std::find_if(way.rbegin(), way.rend(), isOther).base());
    if (!isUnderWay)
        for (const Entry entry : history.wayOn()) {
            if (isOther(entry))
                break;
            way.push_back(entry);
        }
    return way;
}

bool isReset(const HistoryRecord& record)
{
    return std::any_of(record.commands.begin(), record.commands.end(),
                       [](const RecordedCommand& recorded) { return std::holds_alternative<Reset>(recorded.command); });
}

} // namespace

const Timeline::Picture* Timeline::pictureAt(double at) const
{
    if (pictures.empty())
        return nullptr;
    const auto after = std::upper_bound(pictures.begin(), pictures.end(), at,
                                        [](double place, const Picture& picture) { return place < picture.at; });
    return after == pictures.begin() ? &pictures.front() : &*(after - 1);
}

FilmFramePointer Timeline::frameAt(double at) const
{
    const Picture* before = pictureAt(at);
    if (before == nullptr)
        return nullptr;
    const Picture* after = before + 1;
    constexpr double close = 8 * Film::interval; // thinned pictures are further apart
    if (after == pictures.data() + pictures.size() || at <= before->at || after->at - before->at > close ||
        after->frame->time <= before->frame->time)
        return before->frame;
    const double share = (at - before->at) / (after->at - before->at);
    return std::make_shared<FilmFrame>(between(*before->frame, *after->frame, share));
}

const Timeline::Tick* Timeline::tickNear(double at, double reach) const
{
    const Tick* nearest = nullptr;
    for (const Tick& tick : ticks)
        if (std::abs(tick.at - at) <= reach &&
            (nearest == nullptr || std::abs(tick.at - at) <= std::abs(nearest->at - at)))
            nearest = &tick;
    return nearest;
}

Timeline timelineOf(const History& history, const Film& film, bool isUnderWay)
{
    Timeline line;
    double at = 0;
    double time = 0; // simulated at `at`
    for (const Entry entry : wayOf(history, isUnderWay)) {
        const HistoryRecord& record = history.record(entry);
        if (line.ticks.empty() || isReset(record))
            time = std::min(record.time, line.ticks.empty() ? record.time : 0);
        for (const FilmFramePointer& frame : film.framesOf(entry))
            line.pictures.push_back({at + std::max(0.0, frame->time - time), entry, false, frame});
        at += std::max(0.0, record.time - time);
        time = record.time;
        line.ticks.push_back({entry, at, record.isKey});
        if (entry == history.current())
            line.present = at;
    }
    if (isUnderWay)
        for (const FilmFramePointer& frame : film.underWay()) {
            line.pictures.push_back({at + std::max(0.0, frame->time - time), history.current(), true, frame});
            line.present = line.pictures.back().at;
        }
    line.end = std::max(at, line.present);
    return line;
}

} // namespace knead
