#include "io/formats/threemf/three_mf_model.h"

#include "io/fields/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr std::string_view coreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view draftSpace =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01"; // of the core before 1.0
constexpr std::string_view materialSpace = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view productionSpace = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

constexpr std::array<std::pair<std::string_view, const char*>, 6> unitNames{
    {{"micron", "um"}, {"millimeter", "mm"}, {"centimeter", "cm"}, {"inch", "inch"}, {"foot", "ft"}, {"meter", "m"}}};

[[noreturn]] void failAsBroken()
{
    throw DamagedThreeMf();
}

double finiteOf(std::optional<std::string_view> text)
{
    const std::optional<double> number = text ? numberIn(*text) : std::nullopt;
    if (!number || !std::isfinite(*number))
        failAsBroken();
    return *number;
}

std::uint32_t wholeOf(std::string_view text)
{
    const std::optional<std::int64_t> number = wholeNumberIn(text);
    if (!number || *number < 0 || *number > std::numeric_limits<std::uint32_t>::max())
        failAsBroken();
    return static_cast<std::uint32_t>(*number);
}

std::uint32_t wholeOf(std::optional<std::string_view> text)
{
    return text ? wholeOf(*text) : throw DamagedThreeMf();
}

std::optional<std::uint32_t> wholeIfThere(std::optional<std::string_view> text)
{
    return text ? std::optional(wholeOf(*text)) : std::nullopt;
}

/// "#RRGGBB" or "#RRGGBBAA"
std::optional<Color> colorIn(std::string_view text)
{
    text = trimmedText(text);
    if ((text.size() != 7 && text.size() != 9) || text.front() != '#')
        return std::nullopt;
    std::uint32_t digits = 0;
    const char* end = text.data() + 7;
    if (std::from_chars(text.data() + 1, end, digits, 16).ptr != end)
        return std::nullopt;
    const auto channel = [&](unsigned shift) { return static_cast<float>(digits >> shift & 0xFFU) / 255; };
    return Color{channel(16), channel(8), channel(0)};
}

/// Takes the next of words with spaces between them; empty: there is none.
std::string_view nextWord(std::string_view& text)
{
    text = trimmedText(text);
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    text.remove_prefix(word.size());
    return word;
}

/// Twelve numbers: the rows of the matrix that row vectors are multiplied with, the last of them the shift.
Eigen::Affine3d placementIn(std::string_view text)
{
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 3; ++column)
            placement(column, row) = finiteOf(nextWord(text));
    if (!trimmedText(text).empty())
        failAsBroken();
    return placement;
}

} // namespace

ThreeMfModelListener::ThreeMfModelListener(const std::string& file, bool isRoot, ThreeMfPackage& package)
    : m_file(file)
    , m_isRoot(isRoot)
    , m_package(package)
{
}

void ThreeMfModelListener::begin(const XmlElement& element)
{
    m_places.push_back(beginAt(m_places.back(), element));
}

/// What is not known, such as what other programs add, is passed over with all that is in it.
ThreeMfModelListener::Place ThreeMfModelListener::beginAt(Place parent, const XmlElement& element)
{
    const std::string_view name = element.name;
    const bool isCore = element.space.empty() || element.space == coreSpace || element.space == draftSpace;
    if (parent == Place::document) {
        if (!isCore || name != "model")
            failAsBroken();
        return beginModel(element), Place::model;
    }
    if (parent == Place::resources)
        return isCore || element.space == materialSpace ? beginResource(element) : Place::inner;
    if (parent == Place::colors && (name == "base" || name == "color"))
        return addColor(element), Place::inner;
    if (!isCore)
        return Place::inner;
    if (parent == Place::model && name == "resources")
        return Place::resources;
    if (parent == Place::model && name == "build")
        return Place::build;
    if (parent == Place::build && name == "item")
        return addItem(element), Place::inner;
    if (parent == Place::object && name == "mesh")
        return Place::mesh;
    if (parent == Place::object && name == "components")
        return m_object->isMesh = false, Place::components;
    if (parent == Place::components && name == "component")
        return addComponent(element), Place::inner;
    if (parent == Place::mesh && name == "vertices")
        return Place::vertices;
    if (parent == Place::mesh && name == "triangles")
        return Place::triangles;
    if (parent == Place::vertices && name == "vertex")
        return addVertex(element), Place::inner;
    if (parent == Place::triangles && name == "triangle")
        return addTriangle(element), Place::inner;
    return Place::inner;
}

void ThreeMfModelListener::end()
{
    if (m_places.back() == Place::object)
        endObject();
    m_places.pop_back();
}

void ThreeMfModelListener::space(std::string_view prefix, std::string_view address)
{
    if (m_places.back() == Place::document)
        m_spaces.insert_or_assign(std::string(prefix), address);
}

void ThreeMfModelListener::beginModel(const XmlElement& element)
{
    noteExtensions(element.attribute("requiredextensions").value_or(""));
    const auto unit = element.attribute("unit");
    if (!m_isRoot || !unit)
        return;
    const auto* const found = std::ranges::find(unitNames, *unit, &std::pair<std::string_view, const char*>::first);
    if (found == unitNames.end())
        ++m_package.flaws;
    else
        m_package.unit = found->second;
}

/// @param prefixes of those without which the file is something else
void ThreeMfModelListener::noteExtensions(std::string_view prefixes)
{
    static constexpr std::array known{coreSpace, materialSpace, productionSpace};
    for (std::string_view prefix = nextWord(prefixes); !prefix.empty(); prefix = nextWord(prefixes)) {
        const auto found = m_spaces.find(prefix);
        if (found == m_spaces.end())
            ++m_package.flaws;
        else if (std::ranges::find(known, found->second) == known.end())
            m_package.unknownExtensions.insert(found->second);
    }
}

ThreeMfModelListener::Place ThreeMfModelListener::beginResource(const XmlElement& element)
{
    if (element.name == "object")
        return beginObject(element), Place::object;
    const auto id = element.attribute("id");
    if (!id)
        return Place::inner;
    m_group = &m_groups[wholeOf(id)];
    const bool hasColors = element.name == "basematerials" || element.name == "colorgroup";
    return hasColors ? Place::colors : Place::inner;
}

void ThreeMfModelListener::addColor(const XmlElement& element)
{
    const auto text = element.attribute(element.name == "base" ? "displaycolor" : "color");
    m_group->push_back(text ? colorIn(*text) : std::nullopt);
    if (text && !m_group->back())
        ++m_package.flaws;
}

void ThreeMfModelListener::beginObject(const XmlElement& element)
{
    const auto [place, isNew] = m_package.objects.try_emplace({m_file, wholeOf(element.attribute("id"))});
    if (!isNew)
        failAsBroken();
    m_object = &place->second;
    m_object->name = element.attribute("name").value_or("");
    const std::string_view type = element.attribute("type").value_or("model");
    if (type == "support" || type == "solidsupport")
        m_object->layer = "support";
    else if (type == "other")
        m_object->layer = "other";
    m_groupOfObject = wholeIfThere(element.attribute("pid"));
    m_colorOfObject.reset();
    if (m_groupOfObject)
        m_colorOfObject = color(*m_groupOfObject, wholeIfThere(element.attribute("pindex")));
}

/// Of a group; nothing where it holds something else than colors.
std::optional<Color> ThreeMfModelListener::color(std::uint32_t group, std::optional<std::uint32_t> index)
{
    const auto found = m_groups.find(group);
    const bool isThere = found != m_groups.end();
    if (isThere && (!index || found->second.empty()))
        return std::nullopt;
    if (!isThere || *index >= found->second.size()) {
        ++m_package.flaws;
        return std::nullopt;
    }
    return found->second[*index];
}

void ThreeMfModelListener::addVertex(const XmlElement& element)
{
    if (m_object->mesh.vertices.size() >= 3 * mostThreeMfTriangles)
        failAsBroken();
    m_object->mesh.vertices.emplace_back(finiteOf(element.attribute("x")), finiteOf(element.attribute("y")),
                                         finiteOf(element.attribute("z")));
}

void ThreeMfModelListener::addTriangle(const XmlElement& element)
{
    const std::uint32_t a = wholeOf(element.attribute("v1"));
    const std::uint32_t b = wholeOf(element.attribute("v2"));
    const std::uint32_t c = wholeOf(element.attribute("v3"));
    if (std::max({a, b, c}) >= m_object->mesh.vertices.size() ||
        m_object->mesh.triangles.size() >= mostThreeMfTriangles)
        failAsBroken();
    if (a == b || b == c || c == a) {
        ++m_package.flaws;
        return;
    }
    const auto group = wholeIfThere(element.attribute("pid"));
    const auto index = wholeIfThere(element.attribute("p1"));
    std::optional<Color> own;
    if (index && (group || m_groupOfObject))
        own = color(group ? *group : *m_groupOfObject, index);
    m_object->mesh.triangles.push_back({a, b, c});
    m_object->colors.push_back(own ? own : m_colorOfObject);
}

void ThreeMfModelListener::endObject()
{
    if (!m_object->isMesh)
        m_object->mesh = {};
    m_object = nullptr;
}

ThreeMfPlaced ThreeMfModelListener::placed(const XmlElement& element) const
{
    ThreeMfPlaced result;
    const auto file = element.attribute("path", productionSpace);
    result.object = {file ? threeMfFile(*file) : m_file, wholeOf(element.attribute("objectid"))};
    if (const auto transform = element.attribute("transform"))
        result.placement = placementIn(*transform);
    return result;
}

void ThreeMfModelListener::addComponent(const XmlElement& element)
{
    m_object->components.push_back(placed(element));
}

void ThreeMfModelListener::addItem(const XmlElement& element)
{
    if (m_isRoot)
        m_package.build.push_back(placed(element));
}

} // namespace knead
