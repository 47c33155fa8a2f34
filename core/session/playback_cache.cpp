#include "core/session/playback_cache.h"

#include "core/skin/former_shape.h"

#include <algorithm>
#include <set>
#include <utility>

namespace knead {

namespace {

std::vector<float> floatsOf(const std::vector<Vec3>& places)
{
    std::vector<float> floats;
    floats.reserve(3 * places.size());
    for (const Vec3& place : places)
        for (const double coordinate : place)
            floats.push_back(static_cast<float>(coordinate));
    return floats;
}

/// Of a filling that only the film remembers; the first ones are the document's.
std::size_t memoryOf(const Aggregate& filling)
{
    constexpr std::size_t perObject = sizeof(Lattice::Node) + (Lattice::isotropicCount + 2) * sizeof(double) + 4;
    const FormerShape& former = *filling.former;
    const Aggregate& carriers = *former.carriers();
    const std::size_t own = filling.size() * perObject + filling.skin.size() * sizeof(SkinPoint) +
                            former.displacements().size() * sizeof(Vec3);
    const std::size_t parted = // which keeps its carriers as they are parted, too
        former.isInPieces() ? carriers.size() * perObject + former.broken().size() * sizeof(BrokenConnection) : 0;
    return own + parted + (carriers.former ? memoryOf(carriers) : 0);
}

/// @param before the fillings of the frame before
PlaybackFramePointer filmFrameOf(const Snapshot& snapshot, const std::vector<std::shared_ptr<const Aggregate>>& before)
{
    auto frame = std::make_shared<PlaybackFrame>();
    frame->run = snapshot.resets;
    frame->step = snapshot.step;
    frame->time = snapshot.time;
    frame->tools = snapshot.tools;
    for (std::size_t i = 0; i < snapshot.fixtures.size(); ++i)
        frame->fixtures.push_back({snapshot.fixtureIds[i], snapshot.fixtures[i].name, snapshot.fixtureForces[i]});
    frame->floorHeight = snapshot.floorHeight;
    for (const Snapshot::BodyState& body : snapshot.bodies) {
        frame->objects.push_back(floatsOf(body.positions));
        const std::size_t b = frame->fillings.size();
        const bool isOther = body.aggregate && (b >= before.size() || before[b] != body.aggregate);
        if (isOther && body.aggregate->former)
            frame->ofFillings += memoryOf(*body.aggregate);
        frame->fillings.push_back(body.aggregate);
        frame->broken.push_back(body.broken);
        frame->relaxed.push_back(body.relaxed && !body.relaxed->hasFlowed() ? body.relaxed : nullptr);
    }
    return frame;
}

} // namespace

std::vector<Vec3> PlaybackFrame::places(std::size_t body) const
{
    const std::vector<float>& floats = objects[body];
    std::vector<Vec3> places(floats.size() / 3);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = Vec3(floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]);
    return places;
}

std::size_t PlaybackFrame::memory() const
{
    std::size_t floats = 0;
    for (const std::vector<float>& list : objects)
        floats += list.size();
    for (const auto& list : broken) // mostly shared with other frames: rather too much than too little
        floats += list ? list->size() * sizeof(BrokenConnection) / sizeof(float) : 0;
    return sizeof(PlaybackFrame) + ofFillings + floats * sizeof(float) + tools.size() * sizeof(ToolState) +
           fixtures.size() * sizeof(Held);
}

void PlaybackCache::forget()
{
    dropUnderWay();
    m_entries.clear();
    m_used = 0;
}

void PlaybackCache::see(SnapshotPointer snapshot)
{
    const double time = snapshot->time;
    constexpr double nearly = 0.99;                                    // steps do not fit exactly
    const bool rests = snapshot->rest > 0 && snapshot->rest == m_rest; // one frame shows it all
    if (!rests && m_rest > 0 && m_passed)
        add(*SnapshotPointer(m_passed)); // where the rest ended
    m_rest = snapshot->rest;
    if (!rests && (time < m_keptTime || time >= m_keptTime + nearly * interval))
        add(*snapshot);
    else
        m_passed = std::move(snapshot);
}

void PlaybackCache::add(const Snapshot& snapshot)
{
    m_passed = nullptr;
    m_keptTime = snapshot.time;
    m_underWay.push_back(filmFrameOf(snapshot, m_fillings));
    m_fillings = m_underWay.back()->fillings;
    m_used += m_underWay.back()->memory();
    thin();
}

void PlaybackCache::goOnWith(PlaybackCache other)
{
    for (PlaybackFramePointer& frame : other.m_underWay) {
        m_used += frame->memory();
        m_underWay.push_back(std::move(frame));
    }
    m_keptTime = other.m_keptTime;
    m_fillings = std::move(other.m_fillings);
    thin();
}

void PlaybackCache::repeat(Entry other, std::uint64_t step, std::uint32_t resets)
{
    Reel reel{{}, firstRunOf(other)};
    for (const PlaybackFramePointer& frame : framesOf(other))
        if (std::pair(frame->run - reel.firstRun, frame->step) <= std::pair(resets, step)) {
            reel.frames.push_back(frame);
            m_used += frame->memory();
        }
    m_repeated = std::move(reel);
}

void PlaybackCache::append(Entry entry, std::uint64_t endStep, std::uint32_t resets)
{
    if (m_repeated) {
        m_entries[entry] = *std::exchange(m_repeated, {});
        thin();
        return;
    }
    if (m_passed && m_passed->step == endStep)
        add(*std::exchange(m_passed, nullptr));
    // By steps, since time goes back where a simulation in trouble does; what was seen until then belongs to the entry too.
    const auto placeOf = [](const PlaybackFramePointer& frame) { return std::pair(frame->run, frame->step); };
    const std::uint32_t begin = std::exchange(m_run, m_run + resets);
    auto end = m_underWay.begin();
    for (std::pair last(begin, std::uint64_t{0}); end != m_underWay.end(); ++end) {
        if (placeOf(*end) < last || placeOf(*end) > std::pair(m_run, endStep))
            break;
        last = placeOf(*end);
    }
    if (end == m_underWay.begin())
        return;
    m_entries[entry] = {{m_underWay.begin(), end}, begin};
    m_underWay.erase(m_underWay.begin(), end);
}

void PlaybackCache::dropUnderWay()
{
    for (const PlaybackFramePointer& frame : m_underWay)
        m_used -= frame->memory();
    if (m_repeated)
        for (const PlaybackFramePointer& frame : m_repeated->frames)
            m_used -= frame->memory();
    m_underWay.clear();
    m_passed = nullptr;
    m_rest = 0;
    m_keptTime = -1;
    m_repeated.reset();
    m_run = 0;
}

const std::vector<PlaybackFramePointer>& PlaybackCache::framesOf(Entry entry) const
{
    static const std::vector<PlaybackFramePointer> none;
    const auto found = m_entries.find(entry);
    return found == m_entries.end() ? none : found->second.frames;
}

std::uint32_t PlaybackCache::firstRunOf(Entry entry) const
{
    const auto found = m_entries.find(entry);
    return found == m_entries.end() ? 0 : found->second.firstRun;
}

/// @return the memory that was set free [bytes]
std::size_t PlaybackCache::halve(std::vector<PlaybackFramePointer>& frames)
{
    std::size_t freed = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (i % 2 == 1)
            freed += frames[i]->memory();
        else
            frames[kept++] = frames[i];
    if (frames.size() == 1) // nothing to halve
        freed = frames[kept = 0]->memory();
    frames.resize(kept);
    return freed;
}

void PlaybackCache::thin()
{
    while (m_used > m_most) {
        std::size_t all = m_underWay.size();
        for (const auto& [entry, reel] : m_entries)
            all += reel.frames.size();
        std::size_t seen = 0;
        for (auto& [entry, reel] : m_entries) {
            if (seen >= (all + 1) / 2)
                break;
            seen += reel.frames.size();
            m_used -= halve(reel.frames);
        }
        if (seen < (all + 1) / 2)
            m_used -= halve(m_underWay);
        std::erase_if(m_entries, [](const auto& each) { return each.second.frames.empty(); });
        if (m_entries.empty() && m_underWay.empty())
            return;
    }
}

namespace {

using BrokenPointer = std::shared_ptr<const std::vector<BrokenConnection>>;

/// What is broken between two frames: a crack that one of them has opens from nothing, or closes.
BrokenPointer brokenBetween(const BrokenPointer& before, const BrokenPointer& after)
{
    if (before == after || !before || before->empty())
        return after;
    if (!after || after->empty())
        return before;
    if (before->size() <= after->size() && std::equal(before->begin(), before->end(), after->begin()))
        return after; // more broke
    std::set<ConnectionId> known(after->begin(), after->end());
    std::vector<BrokenConnection> healed;
    for (const BrokenConnection& one : *before)
        if (!known.contains(one))
            healed.push_back(one);
    if (healed.empty())
        return after;
    auto both = std::make_shared<std::vector<BrokenConnection>>(*after);
    both->insert(both->end(), healed.begin(), healed.end());
    return both;
}

} // namespace

PlaybackFrame between(const PlaybackFrame& before, const PlaybackFrame& after, double share)
{
    PlaybackFrame frame = before;
    if (before.fillings != after.fillings)
        return frame;
    frame.time += share * (after.time - before.time);
    const auto part = static_cast<float>(share);
    for (std::size_t b = 0; b < frame.objects.size(); ++b)
        for (std::size_t i = 0; i < frame.objects[b].size(); ++i)
            frame.objects[b][i] += part * (after.objects[b][i] - before.objects[b][i]);
    for (std::size_t b = 0; share > 0 && b < std::min(before.broken.size(), after.broken.size()); ++b)
        frame.broken[b] = brokenBetween(before.broken[b], after.broken[b]);
    for (std::size_t t = 0; t < std::min(before.tools.size(), after.tools.size()); ++t) {
        if (before.tools[t].id != after.tools[t].id)
            break;
        Pose& pose = frame.tools[t].pose;
        pose.position += share * (after.tools[t].pose.position - pose.position);
        pose.rotation = pose.rotation.slerp(share, after.tools[t].pose.rotation);
    }
    return frame;
}

FramePointer drawable(const PlaybackFrame& frame, const FilledBodies& bodies)
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->step = frame.step;
    snapshot->time = frame.time;
    snapshot->tools = frame.tools;
    snapshot->floorHeight = frame.floorHeight;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        snapshot->bodies.push_back({.positions = frame.places(b),
                                    .aggregate = frame.fillings[b],
                                    .broken = frame.broken.empty() ? nullptr : frame.broken[b],
                                    .relaxed = frame.relaxed.empty() ? nullptr : frame.relaxed[b]});
    return prepareFrame(bodies, std::move(snapshot), nullptr);
}

} // namespace knead
