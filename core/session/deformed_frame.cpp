#include "core/session/deformed_frame.h"

#include "core/session/relief.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 1024;
constexpr std::size_t mostLookedAt = 2000; // for folds: each takes six evaluations of the map

std::shared_ptr<const BodyFrame> carried(const FilledBody& body, const BodyFrame& shown, const SmoothMap& map)
{
    auto frame = std::make_shared<BodyFrame>();
    frame->places.resize(shown.places.size());
    evaluateInBlocks(map, shown.places, frame->places);
    frame->points = renderPoints(body.render, frame->places);
    frame->normals = renderNormals(body.render, frame->points);
    frame->shades = reliefShades(body.render, frame->points, frame->normals);
    frame->acrossCracks = shown.acrossCracks;
    return frame;
}

std::vector<float> waysOf(const BodyFrame& from, const BodyFrame& to)
{
    std::vector<float> ways(from.places.size());
    for (std::size_t i = 0; i < ways.size(); ++i)
        ways[i] = static_cast<float>((to.places[i] - from.places[i]).norm());
    return ways;
}

/// The first of some of the places where det F <= 0.
std::optional<Vec3> foldAmong(const std::vector<Vec3>& places, const SmoothMap& map)
{
    const std::size_t stride = std::max<std::size_t>(1, places.size() / mostLookedAt);
    const std::size_t count = (places.size() + stride - 1) / stride;
    std::atomic<std::size_t> first = std::numeric_limits<std::size_t>::max();
    forEachBlock(count, 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && i < first; ++i)
            if (map.gradient(places[i * stride]).determinant() <= 0) {
                std::size_t known = first;
                while (i < known && !first.compare_exchange_weak(known, i)) {}
            }
    });
    return first < count ? std::optional(places[first * stride]) : std::nullopt;
}

} // namespace

void evaluateInBlocks(const SmoothMap& map, std::span<const Vec3> points, std::span<Vec3> places)
{
    forEachBlock(points.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        map.evaluate(points.subspan(begin, end - begin), places.subspan(begin, end - begin));
    });
}

DeformedFrame deformedFrame(const FramePointer& shown, const SmoothMap& map, const std::vector<bool>& which,
                            TaskControl& control)
{
    DeformedFrame result;
    auto frame = std::make_shared<Frame>();
    frame->snapshot = shown->snapshot;
    frame->bodies = shown->bodies;
    frame->filled = shown->filled;
    result.ways.resize(shown->bodies.size());
    for (std::size_t b = 0; b < shown->bodies.size(); ++b) {
        control.throwIfCancelled();
        if (!which.empty() && !which[b])
            continue;
        const BodyFrame& before = *shown->bodies[b];
        frame->bodies[b] = carried(*shown->filled[b], before, map);
        result.ways[b] = waysOf(before, *frame->bodies[b]);
        for (const float way : result.ways[b])
            result.largestWay = std::max(result.largestWay, static_cast<double>(way));
        if (!result.fold)
            result.fold = foldAmong(before.places, map);
    }
    result.frame = std::move(frame);
    return result;
}

} // namespace knead
