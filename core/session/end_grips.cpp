#include "core/session/end_grips.h"

#include "core/deformation/number_map.h"
#include "core/deformation/number_placement.h"
#include "core/deformation/number_words.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double shortestOfWays = 0.01; // [s]
constexpr double longestOfWays = 3600;  // [s]
constexpr double planeSlack = 1e-9;     // of the length between the planes
constexpr double leastSpacings = 2;     // between the planes
constexpr double arrivedWithin = 1e-9;  // of a length, and as an angle [rad]
constexpr double stillEnough = 1e-12;   // of a length: rounding
constexpr std::array bothEnds{NumberEnd::first, NumberEnd::second};

Message quotedName(const std::string& name)
{
    return name.empty() ? Message("Deformation", "The body") : Message::verbatim("\"" + name + "\"");
}

void check(const PhysicalDeformation& deformation)
{
    const NumberDeformation& numbers = deformation.numbers;
    if (const Message why = whyNotByPhysics(numbers.kind); !why.empty())
        throw Problem(why);
    if (!(deformation.duration >= shortestOfWays && deformation.duration <= longestOfWays))
        throw Problem(Message("Deformation", "Deforming by physics takes 0.01 to 3600 s."));
    const NumberMap checked(numbers);
}

/// Where objects of a body are along the axis.
struct Layout {
    HeldEnds held;
    std::size_t free = 0;
    HeightRange heights; ///< of what is free, with half a spacing around [m]
    double least = 0;
    double most = 0;

    bool isShaped() const { return free > 0 && !held.first.empty() && !held.second.empty(); }
};

Layout layoutOf(const NumberDeformation& numbers, BodyId body, const Snapshot::BodyState& state)
{
    Layout layout{.held = {.body = body, .first = {}, .second = {}}, .free = 0, .heights = {1e300, -1e300}};
    const double spacing = state.aggregate->lattice.spacing;
    const double slack = planeSlack * numbers.length();
    std::vector<double> along;
    for (const Vec3& place : state.positions)
        along.push_back(numbers.axis.dot(place - numbers.origin));
    if (along.empty())
        return layout;
    layout.least = *std::ranges::min_element(along);
    layout.most = *std::ranges::max_element(along);
    // A plane at the end of a body has nothing beyond: its last layer is held.
    const double first = std::max(numbers.from, layout.least <= numbers.from + spacing ? layout.least : numbers.from);
    const double second = std::min(numbers.to, layout.most >= numbers.to - spacing ? layout.most : numbers.to);
    const double firstLayer = first > numbers.from + slack ? spacing / 2 : slack;
    const double secondLayer = second < numbers.to - slack ? spacing / 2 : slack;
    for (std::size_t i = 0; i < along.size(); ++i)
        if (along[i] <= first + firstLayer)
            layout.held.first.push_back(static_cast<ObjectIndex>(i));
        else if (along[i] >= second - secondLayer)
            layout.held.second.push_back(static_cast<ObjectIndex>(i));
        else {
            ++layout.free;
            const double height = numbers.side.dot(state.positions[i] - numbers.origin);
            layout.heights.least = std::min(layout.heights.least, height - spacing / 2);
            layout.heights.most = std::max(layout.heights.most, height + spacing / 2);
        }
    return layout;
}

/// Why nothing of a body would find a shape of its own.
Message whyNothing(const NumberDeformation& numbers, const Layout& layout, const Message& subject)
{
    if (layout.most <= numbers.from || layout.least >= numbers.to)
        return Message("Deformation",
                       "%1 lies wholly beyond one of the planes, so that it would only be carried along. "
                       "Put the planes where it is to be deformed.")
            .with(subject);
    if (layout.free == 0)
        return Message("Deformation", "Nothing of %1 is free between the planes: move them apart, or fill it with a "
                                      "smaller spacing.")
            .with(subject);
    return Message("Deformation", "%1 does not reach both planes, so that grips cannot hold it on both sides. Put the "
                                  "planes where it is, or at its ends.")
        .with(subject);
}

} // namespace

Message whyNotByPhysics(NumberKind kind)
{
    if (hasRigidEnds(kind))
        return {};
    return Message("Deformation", "Physics bends, twists, stretches and shears, which grips at the ends can do. \"%1\" "
                                  "changes the ends themselves: do it exactly.")
        .with(wordsOf(kind).name);
}

std::string nameOfGrip(const PhysicalDeformation& deformation, NumberEnd end)
{
    const std::string name =
        deformation.name.empty() ? std::string(wordsOf(deformation.numbers.kind).word) : deformation.name;
    return name + (end == NumberEnd::first ? ": first end" : ": second end");
}

NumberEnd freedEnd(const NumberDeformation& numbers)
{
    return numbers.stays > 0.5 ? NumberEnd::first : NumberEnd::second;
}

std::vector<HeldEnds> heldEnds(const PhysicalDeformation& deformation, const Snapshot& now,
                               const std::vector<std::string>& names, const std::vector<bool>& which)
{
    check(deformation);
    NumberDeformation numbers = deformation.numbers;
    numbers.eases = false;
    std::vector<HeldEnds> all;
    bool isAnyShaped = false;
    Message why = Message("Deformation", "There is no part that could be deformed.");
    for (BodyId b = 0; b < now.bodies.size(); ++b) {
        const Snapshot::BodyState& state = now.bodies[b];
        if (!which.empty() && !which[b])
            continue;
        const Message subject = quotedName(b < names.size() ? names[b] : std::string());
        if (state.kind != BodyKind::deformable) {
            why = Message("Deformation", "%1 is rigid: physics deforms what can be deformed. Make it deformable first.")
                      .with(subject);
            continue;
        }
        if (numbers.length() < leastSpacings * state.aggregate->lattice.spacing)
            throw Problem(Message("Deformation",
                                  "Less than two spacings of %1 lie between the planes: move them apart, "
                                  "or fill it with a smaller spacing.")
                              .with(subject));
        Layout layout = layoutOf(numbers, b, state);
        if (!layout.isShaped())
            why = whyNothing(numbers, layout, subject);
        else if (const auto fold = foldOf(numbers, layout.heights))
            throw Problem(*fold);
        isAnyShaped = isAnyShaped || layout.isShaped();
        all.push_back(std::move(layout.held));
    }
    if (!isAnyShaped)
        throw Problem(why);
    return all;
}

std::vector<Command> addedGrips(const PhysicalDeformation& deformation, const std::vector<HeldEnds>& held)
{
    std::vector<Command> commands;
    for (const HeldEnds& body : held)
        for (const NumberEnd end : bothEnds) {
            const std::vector<ObjectIndex>& objects = end == NumberEnd::first ? body.first : body.second;
            if (!objects.empty())
                commands.emplace_back(
                    AddFixture{{.name = nameOfGrip(deformation, end), .body = body.body, .objects = objects}});
        }
    return commands;
}

EndGrips::EndGrips(const PhysicalDeformation& deformation, double begin)
    : EndGrips(deformation, begin, begin)
{
    for (End& end : m_ends)
        end.told = Move{};
}

EndGrips::EndGrips(const PhysicalDeformation& deformation, double begin, double now)
    : m_deformation(deformation)
    , m_begin(begin)
    , m_time(now)
    , m_toldUntil(now)
{
    m_deformation.numbers.eases = false;
    for (std::size_t i = 0; i < bothEnds.size(); ++i)
        m_ends[i] = {.now = endPlace(m_deformation.numbers, bothEnds[i], shareAt(now)), .told = std::nullopt};
}

double EndGrips::shareAt(double time) const
{
    const double u = std::clamp((time - m_begin) / m_deformation.duration, 0.0, 1.0);
    return u * u * (3 - 2 * u);
}

/// By what was told.
void EndGrips::goOn(double time)
{
    for (End& end : m_ends) {
        if (end.told)
            end.now.place += (time - m_time) * end.told->velocity;
        end.now.angle += (time - m_time) * end.turning;
    }
    m_time = time;
}

bool EndGrips::isThere() const
{
    for (std::size_t i = 0; i < bothEnds.size(); ++i) {
        const EndPlace goal = endPlace(m_deformation.numbers, bothEnds[i], 1);
        const bool isNear = (goal.place - m_ends[i].now.place).norm() <= arrivedWithin * m_deformation.numbers.length();
        if (!isNear || std::abs(goal.angle - m_ends[i].now.angle) > arrivedWithin)
            return false;
    }
    return true;
}

std::optional<EndGrips::Move> EndGrips::moveTo(End& end, const EndPlace& target, double horizon) const
{
    const Vec3 way = target.place - end.now.place;
    end.turning = (target.angle - end.now.angle) / horizon;
    Move move;
    if (way.norm() > stillEnough * m_deformation.numbers.length())
        move.velocity = way / horizon;
    if (end.turning != 0)
        move.turn = {.center = end.now.place, .angularVelocity = end.turning * turnAxis(m_deformation.numbers)};
    const bool isSame = end.told == move && end.turning == 0;
    end.told = move;
    return isSame ? std::nullopt : std::optional(move);
}

EndGrips::Moves EndGrips::follow(double time, double step, double horizon)
{
    Moves moves;
    if (m_isOver)
        return moves;
    goOn(time);
    if (time + 0.5 * step < m_toldUntil)
        return moves;
    m_isOver = time + 0.5 * step >= m_begin + m_deformation.duration && isThere();
    const double share = shareAt(time + horizon);
    for (std::size_t i = 0; i < bothEnds.size(); ++i)
        moves[i] =
            moveTo(m_ends[i], m_isOver ? m_ends[i].now : endPlace(m_deformation.numbers, bothEnds[i], share), horizon);
    m_toldUntil = time + horizon;
    return moves;
}

} // namespace knead
