// Models, previews and failures from bytes, of which nothing is trusted.
#include "core/message/message.h"
#include "io/json/message_json.h"
#include "io/worker/model_file.h"
#include "io/worker/model_format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::string& what)
{
    throw Problem(Message::verbatim("model file: " + what));
}

std::vector<Message> taken(const Json& json, const std::string& key)
{
    const auto said = json.find(key + "Said");
    return messagesFrom(said != json.end() ? *said : json.at(key));
}

double finite(const Json& json)
{
    const double number = json.get<double>();
    if (!std::isfinite(number))
        fail("a number is not finite");
    return number;
}

int count(const Json& json)
{
    const auto number = json.get<std::int64_t>();
    if (!json.is_number_integer() || number < 0 || number > std::numeric_limits<int>::max())
        fail("a count is out of range");
    return static_cast<int>(number);
}

Vec3 vector(const Json& json)
{
    if (json.size() != 3)
        fail("a vector has not three numbers");
    return {finite(json.at(0)), finite(json.at(1)), finite(json.at(2))};
}

float channel(const Json& json)
{
    const double value = finite(json);
    if (value < 0 || value > 1)
        fail("a color is out of range");
    return static_cast<float>(value);
}

std::optional<Color> colorOrNone(const Json& json)
{
    if (json.is_null())
        return std::nullopt;
    if (json.size() != 3)
        fail("a color has not three channels");
    return Color{channel(json.at(0)), channel(json.at(1)), channel(json.at(2))};
}

/// Files nested deeper than 4000 levels are not opened. Who uses a tree goes down it a call for each level: without an end, a small
/// project of a stranger would use up the stack.
constexpr std::size_t deepestTree = 5000;

/// Parents come before their children.
PartNode treeOf(const Json& nodes, std::size_t parts)
{
    std::vector<PartNode> flat;
    std::vector<std::size_t> parents;
    std::vector<std::size_t> levels;
    for (const Json& json : nodes) {
        PartNode node{json.at("name").get<std::string>(), std::nullopt, {}};
        if (!json.at("part").is_null())
            node.part = json.at("part").get<std::size_t>();
        node.product = json.value("product", std::string());
        node.partNumber = json.value("partNumber", std::string());
        node.holdsBodies = json.value("holdsBodies", false);
        if (node.part && *node.part >= parts)
            fail("the tree names a part that is not there");
        const auto parent = json.at("parent").get<std::int64_t>();
        if (flat.empty() ? parent != -1 : parent < 0 || parent >= static_cast<std::int64_t>(flat.size()))
            fail("the tree of parts is none");
        parents.push_back(flat.empty() ? 0 : static_cast<std::size_t>(parent));
        levels.push_back(flat.empty() ? 0 : levels[parents.back()] + 1);
        if (levels.back() > deepestTree)
            fail("the tree of parts is too deep");
        flat.push_back(std::move(node));
    }
    if (flat.empty())
        fail("there is no tree of parts");
    // Children move into their parents from the last on, and so arrive in reverse.
    for (std::size_t i = flat.size() - 1; i > 0; --i) {
        std::reverse(flat[i].children.begin(), flat[i].children.end());
        flat[parents[i]].children.push_back(std::move(flat[i]));
    }
    std::reverse(flat[0].children.begin(), flat[0].children.end());
    return std::move(flat[0]);
}

class ModelReader {
public:
    explicit ModelReader(std::string_view bytes)
    {
        std::uint64_t length = 0;
        if (bytes.size() < model_format::headerSize || !bytes.starts_with(model_format::modelMark))
            fail("it does not start as one");
        std::memcpy(&length, bytes.data() + model_format::headerSize - sizeof length, sizeof length);
        if (length > bytes.size() - model_format::headerSize)
            fail("it is cut off");
        const std::string_view document = bytes.substr(model_format::headerSize, length);
        m_json = Json::parse(document.begin(), document.end());
        m_arrays = bytes.substr(std::min(bytes.size(), model_format::aligned(model_format::headerSize + length)));
    }

    Model model()
    {
        Model model;
        model.file = m_json.at("file").get<std::string>();
        model.format = m_json.at("format").get<std::string>();
        model.unit = m_json.at("unit").get<std::string>();
        model.warnings = taken(m_json, "warnings");
        model.missing = taken(m_json, "missing");
        if (const auto remark = m_json.find("unitRemark"); remark != m_json.end())
            model.unitRemark = {messageFrom(remark->contains("said") ? remark->at("said") : remark->at("sentence")),
                                remark->at("unit").get<std::string>()};
        for (const Json& json : m_json.at("parts"))
            model.parts.push_back(part(json));
        model.tree = treeOf(m_json.at("nodes"), model.parts.size());
        return model;
    }

private:
    template <class Element>
    std::vector<Element> array(const Json& json) const
    {
        const auto begin = json.at(0).get<std::uint64_t>();
        const auto length = json.at(1).get<std::uint64_t>();
        if (begin > m_arrays.size() || length > (m_arrays.size() - begin) / sizeof(Element))
            fail("an array lies outside");
        std::vector<Element> elements(length);
        if (length > 0)
            std::memcpy(static_cast<void*>(elements.data()), m_arrays.data() + begin, length * sizeof(Element));
        return elements;
    }

    std::vector<Vec3> points(const Json& json) const
    {
        std::vector<Vec3> points = array<Vec3>(json);
        if (!std::all_of(points.begin(), points.end(), [](const Vec3& point) { return point.allFinite(); }))
            fail("a point is not finite");
        return points;
    }

    TriangleMesh mesh(const Json& json, std::size_t faces) const
    {
        TriangleMesh mesh;
        mesh.vertices = points(json.at("vertices"));
        mesh.triangles = array<TriangleMesh::Triangle>(json.at("triangles"));
        mesh.faceOfTriangle = array<std::uint32_t>(json.at("faceOfTriangle"));
        for (const TriangleMesh::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex >= mesh.vertices.size())
                    fail("a triangle has a vertex that is not there");
        if (!mesh.faceOfTriangle.empty() && mesh.faceOfTriangle.size() != mesh.triangles.size())
            fail("not every triangle has a face");
        for (const std::uint32_t face : mesh.faceOfTriangle)
            if (face >= faces)
                fail("a triangle has a face that is not there");
        return mesh;
    }

    ExactShape exact(const Json& json)
    {
        const auto begin = json.at(0).at(0).get<std::uint64_t>();
        std::shared_ptr<const std::string>& bytes = m_exact[begin];
        if (bytes == nullptr) {
            const std::vector<char> all = array<char>(json.at(0));
            bytes = std::make_shared<const std::string>(all.begin(), all.end());
        }
        const double unit = finite(json.at(2));
        if (unit <= 0)
            fail("a length unit is out of range");
        return {bytes, static_cast<std::uint32_t>(count(json.at(1))), unit};
    }

    Part part(const Json& json)
    {
        Part part;
        part.name = json.at("name").get<std::string>();
        part.path = json.at("path").get<std::string>();
        part.bodyOf = json.value("bodyOf", std::string());
        part.color = colorOrNone(json.at("color"));
        for (const Json& face : json.at("faces"))
            part.faces.push_back({colorOrNone(face)});
        for (const Json& named : json.value("faceNames", Json::array())) { // earlier versions have none
            const auto face = static_cast<std::size_t>(count(named.at(0)));
            if (face >= part.faces.size())
                fail("a face that it does not have is named");
            part.faces[face].name = named.at(1).get<std::string>();
        }
        part.mesh = mesh(json, part.faces.size());
        if (const auto shape = json.find("exact"); shape != json.end())
            part.exact = exact(*shape);
        part.solids = count(json.at("solids"));
        part.shells = count(json.at("shells"));
        part.edges = count(json.at("edges"));
        part.volume = finite(json.at("volume"));
        part.area = finite(json.at("area"));
        if (const auto box = json.find("box"); box != json.end())
            part.box = Box(vector(box->at(0)), vector(box->at(1)));
        part.watertight = json.at("watertight").get<bool>();
        part.valid = json.at("valid").get<bool>();
        part.insideOut = json.value("insideOut", false); // earlier versions do not say it
        part.maxTolerance = finite(json.at("maxTolerance"));
        part.visible = json.at("visible").get<bool>();
        part.layer = json.at("layer").get<std::string>();
        part.repairs = taken(json, "repairs");
        for (const Json& edge : json.at("openEdges"))
            part.openEdges.push_back(points(edge));
        part.warnings = taken(json, "warnings");
        return part;
    }

    Json m_json;
    std::string_view m_arrays;
    std::map<std::uint64_t, std::shared_ptr<const std::string>> m_exact; ///< by where they begin
};

} // namespace

Model modelFromBytes(std::string_view bytes)
{
    try {
        return ModelReader(bytes).model();
    } catch (const Json::exception& error) {
        fail(error.what());
    }
}

FilePreview previewFromBytes(std::string_view bytes)
{
    if (!bytes.starts_with(model_format::previewMark))
        fail("it is no preview");
    try {
        const Json json = Json::parse(bytes.substr(model_format::previewMark.size()));
        FilePreview preview;
        preview.size = json.at("size").get<std::uint64_t>();
        preview.format = json.at("format").get<std::string>();
        preview.solids = static_cast<std::size_t>(count(json.at("solids")));
        preview.faces = static_cast<std::size_t>(count(json.at("faces")));
        preview.parts = static_cast<std::size_t>(count(json.at("parts")));
        preview.tree = treeOf(json.at("nodes"), 0);
        return preview;
    } catch (const Json::exception& error) {
        fail(error.what());
    }
}

Message failureIn(std::string_view bytes)
{
    if (!bytes.starts_with(model_format::failureMark))
        return {};
    const std::string_view text = bytes.substr(model_format::failureMark.size());
    try {
        return messageFrom(Json::parse(text));
    } catch (const Json::exception&) {
        return Message::verbatim(std::string(text));
    }
}

} // namespace knead
