#include "io/formats/iges/iges_entities.h"

#include "io/formats/cad_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace knead {

namespace {

constexpr std::size_t numberColumn = 73; // of the number of a line, counted from 0
constexpr int deepestReferences = 500;   // honest files stay under 20; the reader recurses once a level

/// Types of entities by number, as IGES 5.3 has them.
namespace type {
constexpr int arc = 100;
constexpr int compositeCurve = 102;
constexpr int line = 110;
constexpr int ruledSurface = 118;
constexpr int surfaceOfRevolution = 120;
constexpr int tabulatedCylinder = 122;
constexpr int splineCurve = 126;
constexpr int splineSurface = 128;
constexpr int offsetCurve = 130;
constexpr int offsetSurface = 140;
constexpr int boundary = 141;
constexpr int curveOnSurface = 142;
constexpr int trimmedSurface = 144;
constexpr int solid = 186;
constexpr int group = 402;
constexpr int vertexList = 502;
constexpr int edgeList = 504;
constexpr int loop = 508;
constexpr int face = 510;
constexpr int shell = 514;
} // namespace type

bool isCurve(int number)
{
    static constexpr std::array curves{100, 102, 104, 106, 110, 112, 116, 126, 130};
    return std::find(curves.begin(), curves.end(), number) != curves.end();
}

bool isSurface(int number)
{
    static constexpr std::array surfaces{108, 114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198};
    return std::find(surfaces.begin(), surfaces.end(), number) != surfaces.end();
}

template <int expected>
bool is(int number)
{
    return number == expected;
}

/// Nothing for what is left out or no whole number.
std::optional<long long> integerAt(const std::vector<std::string_view>& values, std::size_t place)
{
    if (place >= values.size())
        return std::nullopt;
    std::string_view text = values[place];
    if (text.starts_with('+'))
        text.remove_prefix(1);
    long long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// 0 for what starts with none.
int integerIn(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// A number of a directory line, which has nine fields of eight columns; 0 for what is none.
int fieldOf(std::string_view line, std::size_t field)
{
    constexpr std::size_t columns = 8;
    return integerIn(line.substr(columns * field, columns));
}

/// Whether walking down from any entity comes back to it, or does not end in time.
class CircularEntitySearch {
public:
    explicit CircularEntitySearch(const std::map<long long, std::vector<long long>>& references)
        : m_references(references)
    {
    }

    bool leadsTooDeep(long long entity, int depth = 0)
    {
        const auto found = m_references.find(entity);
        if (found == m_references.end())
            return false;
        if (depth > deepestReferences)
            return true;
        const auto [known, isNew] = m_isLeft.try_emplace(entity, false);
        if (!isNew)
            return !known->second;
        if (std::any_of(found->second.begin(), found->second.end(),
                        [&](long long to) { return leadsTooDeep(to, depth + 1); }))
            return true;
        return !(m_isLeft[entity] = true);
    }

private:
    const std::map<long long, std::vector<long long>>& m_references;
    std::map<long long, bool> m_isLeft;
};

} // namespace

void IgesEntities::takeDirectoryLine(std::string_view line)
{
    if (m_types.size() == m_forms.size())
        m_types.push_back(fieldOf(line, 0));
    else
        m_forms.push_back(fieldOf(line, 4));
    const std::size_t number = m_types.size() + m_forms.size();
    if (m_failure.empty() && integerIn(line.substr(std::min(numberColumn, line.size()))) != static_cast<int>(number))
        m_failure = aboutFile(
            m_path,
            Message("Iges",
                    "line %1 of section D of the IGES file has another number; lines are lost, get the file again.")
                .with(number));
}

void IgesEntities::takeRecord(int entity, const std::vector<std::string_view>& values)
{
    if (!m_failure.empty())
        return;
    try {
        checkRecord(entity, values);
    } catch (const std::runtime_error& failure) {
        m_failure = messageOf(failure);
    }
}

void IgesEntities::checkRecord(int entity, const Record& values)
{
    if (!m_recorded.insert(entity).second)
        failAt(entity, Message("Iges", "has its values twice"));
    if (integerAt(values, 0) != typeOf(entity))
        failAt(entity, Message("Iges", "is of another type where its values are"));
    switch (typeOf(entity)) {
    case type::group:
        return isPlainGroup(entity) ? takeMembers(entity, values, 2, integerAt(values, 1).value_or(0)) : void();
    case type::compositeCurve:
        return takeMembers(entity, values, 2, integerAt(values, 1).value_or(0));
    case type::arc:
        return requireLength(entity, values, 8);
    case type::line:
        return requireLength(entity, values, 7);
    case type::ruledSurface:
        require(entity, values, 1, isCurve);
        return require(entity, values, 2, isCurve);
    case type::surfaceOfRevolution:
        require(entity, values, 1, is<type::line>);
        return require(entity, values, 2, isCurve);
    case type::tabulatedCylinder:
    case type::offsetCurve:
        return require(entity, values, 1, isCurve);
    case type::offsetSurface:
        return require(entity, values, 5,
                       [](int number) { return isSurface(number) || number == type::trimmedSurface; });
    case type::splineCurve: { // K, M, four flags, K+M+2 knots, K+1 weights and points
        const long long degree = countAt(entity, values, 2);
        const long long points = countAt(entity, values, 1) + 1;
        return requireLength(entity, values, 7 + points + degree + 1 + 4 * points);
    }
    case type::splineSurface: { // K1, K2, M1, M2, five flags, the knots of both ways, weights and points
        const long long columns = countAt(entity, values, 1) + 1;
        const long long rows = countAt(entity, values, 2) + 1;
        const long long degrees = countAt(entity, values, 3) + countAt(entity, values, 4);
        return requireLength(entity, values, 10 + columns + rows + degrees + 2 + 4 * columns * rows);
    }
    case type::curveOnSurface:
        return takeMembers(entity, values, 2, 3); // the surface and two curves
    case type::trimmedSurface:
        return takeTrimmedSurface(entity, values);
    case type::solid:
        return takeSolid(entity, values);
    case type::vertexList:
        m_lengths[entity] = countAt(entity, values, 1);
        return requireLength(entity, values, 2 + 3 * m_lengths[entity]);
    case type::edgeList:
        return takeEdges(entity, values);
    case type::loop:
        return takeLoop(entity, values);
    case type::face:
        return takeFace(entity, values);
    case type::shell: {
        const long long faces = countAt(entity, values, 1);
        for (long long i = 0; i < faces; ++i)
            require(entity, values, static_cast<std::size_t>(2 + 2 * i), is<type::face>);
        return;
    }
    default:
        return;
    }
}

void IgesEntities::finish() const
{
    if (!m_failure.empty())
        throw Problem(m_failure);
    CircularEntitySearch search(m_references);
    for (const auto& [entity, to] : m_references)
        if (search.leadsTooDeep(entity))
            failReading(m_path, Message("Iges", "entity %1 of the IGES file holds itself, or the entities are nested "
                                                "more than %2 deep; export it again.")
                                    .with(entity, deepestReferences));
    for (const auto& [entity, references] : m_references)
        for (const long long to : references)
            if (!m_recorded.contains(to))
                failAt(static_cast<int>(entity), Message("Iges", "refers to one without values"));
    for (const ListMember& member : m_members) {
        const auto length = m_lengths.find(member.list);
        if (length == m_lengths.end() || member.index < 1 || member.index > length->second)
            failAt(member.user, Message("Iges", "refers to a vertex or edge that is not there"));
    }
}

/// A surface that is none is left out by the reader, a boundary that is none it stumbles over.
void IgesEntities::takeTrimmedSurface(int entity, const Record& values)
{
    takeMembers(entity, values, 1, 1);
    const auto isBoundary = [](int number) { return number == type::curveOnSurface || number == type::boundary; };
    // With 0 in the place before, the surface ends where it ends by itself.
    if (integerAt(values, 2).value_or(0) != 0 || integerAt(values, 4).value_or(0) != 0)
        require(entity, values, 4, isBoundary);
    const long long inner = integerAt(values, 3) ? countAt(entity, values, 3) : 0;
    for (long long i = 0; i < inner; ++i)
        require(entity, values, static_cast<std::size_t>(5 + i), isBoundary);
}

void IgesEntities::takeSolid(int entity, const Record& values)
{
    require(entity, values, 1, is<type::shell>);
    const long long voids = integerAt(values, 3) ? countAt(entity, values, 3) : 0;
    for (long long i = 0; i < voids; ++i)
        require(entity, values, static_cast<std::size_t>(4 + 2 * i), is<type::shell>);
}

void IgesEntities::takeFace(int entity, const Record& values)
{
    require(entity, values, 1, isSurface);
    const long long loops = countAt(entity, values, 2);
    for (long long i = 0; i < loops; ++i)
        require(entity, values, static_cast<std::size_t>(4 + i), is<type::loop>);
}

void IgesEntities::takeLoop(int entity, const Record& values)
{
    const long long edges = countAt(entity, values, 1);
    std::size_t place = 2;
    for (long long i = 0; i < edges; ++i) { // kind, list, index, sense, number of curves; a flag and a curve each
        requireLength(entity, values, static_cast<long long>(place) + 5);
        const bool isVertex = integerAt(values, place) == 1;
        require(entity, values, place + 1, isVertex ? is<type::vertexList> : is<type::edgeList>);
        m_members.push_back(
            {integerAt(values, place + 1).value_or(0), integerAt(values, place + 2).value_or(0), entity});
        const long long curves = countAt(entity, values, place + 4);
        for (long long curve = 0; curve < curves; ++curve)
            require(entity, values, place + 6 + static_cast<std::size_t>(2 * curve), isCurve);
        place += 5 + static_cast<std::size_t>(2 * curves);
    }
}

void IgesEntities::takeEdges(int entity, const Record& values)
{
    const long long edges = m_lengths[entity] = countAt(entity, values, 1);
    requireLength(entity, values, 2 + 5 * edges);
    for (long long i = 0; i < edges; ++i) { // curve, list and index of the first vertex, of the last
        const auto place = static_cast<std::size_t>(2 + 5 * i);
        require(entity, values, place, isCurve);
        for (const std::size_t vertex : {place + 1, place + 3}) {
            require(entity, values, vertex, is<type::vertexList>);
            m_members.push_back(
                {integerAt(values, vertex).value_or(0), integerAt(values, vertex + 1).value_or(0), entity});
        }
    }
}

/// Members of other types than they should have are left out by the reader.
void IgesEntities::takeMembers(int entity, const Record& values, std::size_t first, long long count)
{
    for (std::size_t place = first; place < values.size() && count > 0; ++place, --count)
        refer(entity, integerAt(values, place).value_or(0));
}

void IgesEntities::requireLength(int entity, const Record& values, long long length) const
{
    if (static_cast<long long>(values.size()) < length)
        failAt(entity, Message("Iges", "has %1 values where %2 are needed").with(values.size(), length));
}

/// A number of values that follow, so no more than there are.
long long IgesEntities::countAt(int entity, const Record& values, std::size_t place) const
{
    const long long count = integerAt(values, place).value_or(-1);
    if (count < 0 || count > static_cast<long long>(values.size()))
        failAt(entity, Message("Iges", "states an impossible count"));
    return count;
}

void IgesEntities::require(int entity, const Record& values, std::size_t place, IsKind isKind)
{
    const long long pointer = integerAt(values, place).value_or(0);
    if (!isKind(typeOf(pointer)))
        failAt(entity, Message("Iges", "refers to something of the wrong kind or nothing at all"));
    refer(entity, pointer);
}

void IgesEntities::refer(int entity, long long to)
{
    if (typeOf(to) != 0)
        m_references[entity].push_back(to);
}

/// 0 when there is none.
int IgesEntities::typeOf(long long entity) const
{
    const bool isThere = entity > 0 && entity % 2 == 1 && entity / 2 < static_cast<long long>(m_types.size());
    return isThere ? m_types[static_cast<std::size_t>(entity / 2)] : 0;
}

/// Members follow the count in groups of the forms 1, 7, 14 and 15.
bool IgesEntities::isPlainGroup(long long entity) const
{
    const auto index = static_cast<std::size_t>(entity / 2);
    const int form = index < m_forms.size() ? m_forms[index] : 0;
    return form == 1 || form == 7 || form == 14 || form == 15;
}

void IgesEntities::failAt(int entity, const Message& what) const
{
    failReading(m_path,
                Message("Iges", "entity %1 of the IGES file (type %2) %3; the file is damaged, export it again.")
                    .with(entity, typeOf(entity), what));
}

} // namespace knead
