#include "core/session/timeline.h"

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

/// On the timeline, where time goes on after a reset.
class Place {
public:
    double at() const { return m_at; }

    /// An entry begins.
    void begin(std::uint32_t run, double time)
    {
        m_run = run;
        m_time = time;
        m_begin = m_at;
    }

    void goOn(std::uint32_t run, double time)
    {
        if (run != m_run)
            begin(run, 0);
        m_at = std::max(m_at, m_begin + time - m_time);
    }

private:
    double m_at = 0;    // [s]
    double m_begin = 0; // where the time ...
    double m_time = 0;  // ... was this [s]
    std::uint32_t m_run = 0;
};

/// Where a body is another filling than in the picture before, of the same run.
std::vector<double> fillingsIn(const std::vector<Timeline::Picture>& pictures)
{
    std::vector<double> places;
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        const PlaybackFrame& before = *pictures[i - 1].frame;
        const PlaybackFrame& now = *pictures[i].frame;
        if (before.run == now.run && before.fillings.size() == now.fillings.size() && before.fillings != now.fillings)
            places.push_back(pictures[i].at);
    }
    return places;
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

PlaybackFramePointer Timeline::frameAt(double at) const
{
    const Picture* before = pictureAt(at);
    if (before == nullptr)
        return nullptr;
    const Picture* after = before + 1;
    constexpr double close = 8 * PlaybackCache::interval; // thinned pictures are further apart
    if (after == pictures.data() + pictures.size() || at <= before->at || after->at - before->at > close ||
        after->frame->time <= before->frame->time)
        return before->frame;
    const double share = (at - before->at) / (after->at - before->at);
    return std::make_shared<PlaybackFrame>(between(*before->frame, *after->frame, share));
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

bool Timeline::isFilledAnewAt(double at, double reach) const
{
    const auto first = std::lower_bound(fillings.begin(), fillings.end(), at - reach);
    return first != fillings.end() && *first <= at + reach;
}

Timeline timelineOf(const History& history, const PlaybackCache& film, bool isUnderWay)
{
    Timeline line;
    Place place;
    double time = 0; // at the end of the entry before
    for (const Entry entry : wayOf(history, isUnderWay)) {
        const HistoryRecord& record = history.record(entry);
        const std::uint32_t run = film.firstRunOf(entry);
        place.begin(run, line.ticks.empty() ? record.time : time);
        for (const PlaybackFramePointer& frame : film.framesOf(entry)) {
            place.goOn(frame->run, frame->time);
            line.pictures.push_back({place.at(), entry, false, frame, frame->run - run});
        }
        place.goOn(run + resetsIn(record.commands), record.time);
        time = record.time;
        line.ticks.push_back({entry, place.at(), record.isKey});
        if (entry == history.current())
            line.present = place.at();
    }
    place.begin(film.run(), time);
    for (const PlaybackFramePointer& frame : isUnderWay ? film.underWay() : std::vector<PlaybackFramePointer>()) {
        place.goOn(frame->run, frame->time);
        line.pictures.push_back({place.at(), history.current(), true, frame});
        line.present = place.at();
    }
    line.end = place.at();
    line.fillings = fillingsIn(line.pictures);
    return line;
}

} // namespace knead
