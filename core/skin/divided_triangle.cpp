#include "core/skin/divided_triangle.h"

#include "core/skin/crossings.h"

#include <algorithm>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;
constexpr std::uint32_t noTag = DividedTriangle::noTag;

/// One side of a line or of a stretch of the outline, with a face to its left.
struct Half {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t tag = noTag; // noTag: on the outline of the triangle
    TriangleFace::Border border;
    bool isSeen = false;

    bool isOnOutline() const { return tag == noTag; }
};

struct Loop {
    std::vector<std::uint32_t> points;
    std::uint32_t tag = noTag;
    std::vector<TriangleFace::Border> borders;
    double twiceArea = 0;
};

double twiceArea(const std::vector<Vec2>& corners)
{
    double sum = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec2 a = corners[i] - corners[0];
        const Vec2 b = corners[i + 1] - corners[0];
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
}

bool isInside(const Vec2& p, const std::vector<Vec2>& corners)
{
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& a = corners[i];
        const Vec2& b = corners[(i + 1) % corners.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

class Divider {
public:
    Divider(const DividedTriangle& triangle, const std::function<Vec2(std::uint32_t)>& placeOf)
        : m_placeOf(placeOf)
    {
        for (std::size_t side = 0; side < 3; ++side) {
            std::uint32_t from = triangle.corners[side];
            const std::vector<std::uint32_t>& points = triangle.onSides[side];
            for (std::size_t stretch = 0; stretch <= points.size(); ++stretch) {
                const bool isLast = stretch == points.size();
                const std::uint32_t to = isLast ? triangle.corners[(side + 1) % 3] : points[stretch];
                m_halves.push_back({.from = from, .to = to, .border = {side, stretch}});
                from = to;
            }
        }
        for (const DividedTriangle::Line& line : triangle.lines) {
            m_halves.push_back({.from = line.start, .to = line.end, .tag = line.leftTag, .border = {}});
            m_halves.push_back({.from = line.end, .to = line.start, .tag = line.rightTag, .border = {}});
        }
        std::ranges::sort(m_halves, [](const Half& a, const Half& b) {
            return a.from != b.from ? a.from < b.from : a.tag != b.tag ? a.tag < b.tag : a.to < b.to;
        });
    }

    std::vector<TriangleFace> faces()
    {
        std::vector<Loop> holes;
        for (std::size_t half = 0; half < m_halves.size(); ++half) {
            if (m_halves[half].isSeen)
                continue;
            Loop loop = trace(half);
            if (loop.borders.empty() && loop.twiceArea < 0)
                holes.push_back(std::move(loop));
            else
                m_outlines.push_back(std::move(loop));
        }
        std::vector<TriangleFace> faces;
        for (Loop& loop : m_outlines)
            faces.push_back({.loops = {loop.points}, .tag = loop.tag, .borders = std::move(loop.borders)});
        for (Loop& hole : holes) {
            TriangleFace& face = faces[outlineAround(hole)];
            face.tag = hole.tag;
            face.loops.push_back(std::move(hole.points));
        }
        return faces;
    }

private:
    std::vector<Vec2> placesOf(const std::vector<std::uint32_t>& points) const
    {
        std::vector<Vec2> places;
        for (const std::uint32_t point : points)
            places.push_back(m_placeOf(point));
        return places;
    }

    Loop trace(std::size_t first)
    {
        Loop loop;
        for (std::size_t half = first; !m_halves[half].isSeen; half = next(m_halves[half])) {
            Half& here = m_halves[half];
            here.isSeen = true;
            loop.points.push_back(here.from);
            if (here.isOnOutline())
                loop.borders.push_back(here.border);
            else if (loop.tag == noTag)
                loop.tag = here.tag;
            else if (loop.tag != here.tag)
                throw DegenerateCut();
        }
        loop.twiceArea = twiceArea(placesOf(loop.points));
        return loop;
    }

    /// The outline goes on along the line that begins there, a line along the outline or else that of the same tag.
    std::size_t next(const Half& half) const
    {
        const auto begin = std::lower_bound(m_halves.begin(), m_halves.end(), half.to,
                                            [](const Half& h, std::uint32_t from) { return h.from < from; });
        const auto end = std::find_if(begin, m_halves.end(), [&](const Half& h) { return h.from != half.to; });
        const auto find = [&](auto&& isWanted) {
            const auto found = std::find_if(begin, end, isWanted);
            return found == end ? m_halves.size() : static_cast<std::size_t>(found - m_halves.begin());
        };
        const std::size_t outline = find([](const Half& h) { return h.isOnOutline(); });
        if (outline != m_halves.size() && !half.isOnOutline())
            return outline;
        const std::size_t line =
            find([&](const Half& h) { return !h.isOnOutline() && (half.isOnOutline() || h.tag == half.tag); });
        const std::size_t found = line != m_halves.size() ? line : outline;
        if (found == m_halves.size())
            throw DegenerateCut();
        return found;
    }

    /// The smallest one with the hole in it that it may belong to.
    std::size_t outlineAround(const Loop& hole) const
    {
        const Vec2 place = m_placeOf(hole.points.front());
        std::size_t best = m_outlines.size();
        for (std::size_t i = 0; i < m_outlines.size(); ++i) {
            const Loop& outline = m_outlines[i];
            const bool mayHold = outline.tag == hole.tag || outline.tag == noTag;
            if (mayHold && (best == m_outlines.size() || outline.twiceArea < m_outlines[best].twiceArea) &&
                isInside(place, placesOf(outline.points)))
                best = i;
        }
        if (best == m_outlines.size())
            throw DegenerateCut();
        return best;
    }

    const std::function<Vec2(std::uint32_t)>& m_placeOf;
    std::vector<Half> m_halves; // by where they begin
    std::vector<Loop> m_outlines;
};

} // namespace

std::vector<TriangleFace> divide(const DividedTriangle& triangle, const std::function<Vec2(std::uint32_t)>& placeOf)
{
    return Divider(triangle, placeOf).faces();
}

} // namespace knead
