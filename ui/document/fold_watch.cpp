#include "ui/document/fold_watch.h"

#include "core/geometry/self_intersection.h"
#include "ui/language/said.h"
#include "ui/units.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t most = 1000;  // crossing pairs that are looked at
constexpr double leastDepth = 0.05; // of a fold; less is roughness where surfaces touch or are bent sharply [spacings]

using Corners = std::array<Vec3, 3>;

/// Heights of corners over the plane of a triangle [m].
Vec3 heights(const Corners& corners, const Corners& plane)
{
    const Vec3 normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]).stableNormalized();
    return {normal.dot(corners[0] - plane[0]), normal.dot(corners[1] - plane[0]), normal.dot(corners[2] - plane[0])};
}

/// Where a triangle meets a plane, as coordinates along a line in it.
std::array<double, 2> stretchInPlane(const Corners& corners, const Vec3& height, const Vec3& line)
{
    std::array<double, 2> stretch{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (Eigen::Index a = 0; a < 3; ++a) {
        const Eigen::Index b = (a + 1) % 3;
        if (height[a] * height[b] > 0 || height[a] == height[b])
            continue;
        const double share = height[a] / (height[a] - height[b]);
        const auto at = [&](Eigen::Index c) { return line.dot(corners[static_cast<std::size_t>(c)]); };
        const double place = (1 - share) * at(a) + share * at(b);
        stretch = {std::min(stretch[0], place), std::max(stretch[1], place)};
    }
    return stretch;
}

/// How far one of two crossing triangles would have to go for them to cross no more, roughly: along one of their normals, or along the
/// line in which they cross [m].
double depthOf(const Corners& one, const Corners& other)
{
    const Vec3 first = heights(one, other);
    const Vec3 second = heights(other, one);
    const auto through = [](const Vec3& height) { return std::min(-height.minCoeff(), height.maxCoeff()); };
    const Vec3 line = (one[1] - one[0])
                          .cross(one[2] - one[0])
                          .cross((other[1] - other[0]).cross(other[2] - other[0]))
                          .stableNormalized();
    const std::array<double, 2> a = stretchInPlane(one, first, line);
    const std::array<double, 2> b = stretchInPlane(other, second, line);
    return std::min({through(first), through(second), std::min(a[1], b[1]) - std::max(a[0], b[0])});
}

/// Triangles that cross others deeper than roughness, ascending.
std::vector<std::uint32_t> foldedTriangles(const TriangleMesh& mesh, const std::vector<Vec3>& places, double depth)
{
    const Crossings found =
        findCrossingsAlone({.vertices = places, .triangles = mesh.triangles, .faceOfTriangle = {}}, most);
    const auto cornersOf = [&](std::uint32_t triangle) {
        const TriangleMesh::Triangle& t = mesh.triangles[triangle];
        return Corners{places[t[0]], places[t[1]], places[t[2]]};
    };
    std::vector<std::uint32_t> triangles;
    for (const auto& [one, other] : found.some)
        if ((triangles.empty() || triangles.back() != one) && depthOf(cornersOf(one), cornersOf(other)) > depth)
            triangles.push_back(one);
    return triangles;
}

Vec3 middleOf(const TriangleMesh::Triangle& corners, const std::vector<Vec3>& places)
{
    return (places[corners[0]] + places[corners[1]] + places[corners[2]]) / 3;
}

bool isMoved(const FilledBody& body, const BodyFrame& frame)
{
    return !std::ranges::equal(body.mesh.vertices, frame.places);
}

/// "114.0, -7.6, 0.0 mm"; "114,0; -7,6; 0,0 mm" where a comma begins the decimals.
QString placeText(const Vec3& place)
{
    const ShownUnit unit = shownUnit(place.cwiseAbs().maxCoeff(), Quantity::Length);
    QStringList numbers;
    for (const double coordinate : place)
        numbers << localNumber(coordinate / unit.scale, 'f', 1);
    return numbers.join(localNumber(0, 'f', 1).contains(',') ? "; " : ", ") + ' ' + unit.symbol;
}

} // namespace

std::vector<Fold> foldsOf(const Frame& frame)
{
    std::vector<Fold> folds;
    for (BodyId b = 0; b < frame.bodies.size(); ++b) {
        const FilledBody& body = *frame.filled[b];
        const BodyFrame& drawn = *frame.bodies[b];
        if (frame.snapshot->bodies[b].kind != BodyKind::deformable || body.whole || !isMoved(body, drawn))
            continue;
        const double depth = leastDepth * body.aggregate->lattice.spacing;
        Fold fold{.body = b, .triangles = foldedTriangles(body.mesh, drawn.places, depth)};
        if (fold.triangles.empty() || !foldedTriangles(body.mesh, body.mesh.vertices, depth).empty())
            continue;
        for (const std::uint32_t triangle : fold.triangles)
            fold.place +=
                middleOf(body.mesh.triangles[triangle], drawn.places) / static_cast<double>(fold.triangles.size());
        folds.push_back(std::move(fold));
    }
    return folds;
}

FoldWatch::FoldWatch(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_look(
          document,
          [this](const FramePointer& frame, TaskControl&) -> BackgroundLook::Finish {
              return [this, frame, folds = foldsOf(*frame)] { take(frame, folds); };
          },
          this)
{
    connect(&m_look, &BackgroundLook::forgotten, this, [this] {
        m_found = nullptr;
        if (!std::exchange(m_folds, {}).empty())
            emit changed();
        dropPassed();
    });
}

void FoldWatch::take(const FramePointer& frame, std::vector<Fold> folds)
{
    m_found = frame;
    const std::vector<Fold> before = std::exchange(m_folds, std::move(folds));
    for (const Fold& fold : m_folds)
        if (std::ranges::find(before, fold.body, &Fold::body) == before.end())
            say(fold);
    dropPassed();
    if (!m_folds.empty() || !before.empty())
        emit changed();
}

void FoldWatch::say(const Fold& fold)
{
    m_sentences[fold.body] = knead::said(
        Message("FoldWatch",
                "%1 is folded over itself near (%2): material was pushed over material, and its faces cross there "
                "in files, too. Undo the stroke, or press the place smooth with a larger tool.")
            .with(m_document.nameOfBody(fold.body).toStdString(), placeText(fold.place).toStdString()));
    emit said(m_sentences[fold.body]);
}

/// What was said of bodies that are folded no more.
void FoldWatch::dropPassed()
{
    std::erase_if(m_sentences, [this](const auto& sentence) {
        const bool isThere = std::ranges::find(m_folds, sentence.first, &Fold::body) != m_folds.end();
        if (!isThere)
            emit passed(sentence.second);
        return !isThere;
    });
}

std::vector<Vec3> FoldWatch::placesOf(const Fold& fold) const
{
    const FramePointer frame = m_document.frame();
    if (!frame || !m_found || fold.body >= frame->bodies.size() ||
        !haveSameSurface(*frame->filled[fold.body], *m_found->filled[fold.body]))
        return {};
    const TriangleMesh& mesh = frame->filled[fold.body]->mesh;
    const std::vector<Vec3>& places = frame->bodies[fold.body]->places;
    std::vector<Vec3> middles;
    middles.reserve(fold.triangles.size());
    for (const std::uint32_t triangle : fold.triangles)
        middles.push_back(middleOf(mesh.triangles[triangle], places));
    return middles;
}

} // namespace knead
