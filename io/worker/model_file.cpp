#include "io/worker/model_file.h"

#include "core/message/message.h"
#include "io/json/message_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <type_traits>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr std::string_view modelMark = "KNEADMDL1\n";
constexpr std::string_view previewMark = "KNEADPRV1\n";
constexpr std::string_view failureMark = "KNEADERR1\n";
constexpr std::size_t headerSize = 32; // mark, length of the JSON document; arrays start at multiples of 8
constexpr std::size_t alignment = 8;

[[noreturn]] void fail(const std::string& what)
{
    throw Problem(Message::verbatim("model file: " + what));
}

std::size_t aligned(std::size_t size)
{
    return (size + alignment - 1) / alignment * alignment;
}

// --- writing ----------------------------------------------------------------------------------------------------------

/// Flat, each node with the number of its parent, since a tree may be thousands of levels deep.
/// In English, as earlier versions read them, and with what goes into them.
void put(Json& json, const std::string& key, const std::vector<Message>& messages)
{
    Json& english = json[key] = Json::array();
    for (const Message& message : messages)
        english.push_back(message.english());
    if (!messages.empty())
        json[key + "Said"] = toJson(messages);
}

std::vector<Message> taken(const Json& json, const std::string& key)
{
    const auto said = json.find(key + "Said");
    return messagesFrom(said != json.end() ? *said : json.at(key));
}

void addNodes(const PartNode& node, std::int64_t parent, Json& nodes)
{
    const auto own = static_cast<std::int64_t>(nodes.size());
    Json json{{"name", node.name}, {"parent", parent}, {"part", node.part ? Json(*node.part) : Json()}};
    if (!node.product.empty())
        json["product"] = node.product;
    if (!node.partNumber.empty())
        json["partNumber"] = node.partNumber;
    if (node.holdsBodies)
        json["holdsBodies"] = true;
    nodes.push_back(std::move(json));
    for (const PartNode& child : node.children)
        addNodes(child, own, nodes);
}

class ModelWriter {
public:
    std::string bytes(const Model& model)
    {
        const std::string document = toJson(model).dump(-1, ' ', false, Json::error_handler_t::replace);
        std::string result(headerSize, '\0');
        std::copy(modelMark.begin(), modelMark.end(), result.begin());
        const std::uint64_t length = document.size();
        std::memcpy(result.data() + headerSize - sizeof length, &length, sizeof length);
        result += document;
        result.resize(aligned(result.size()), ' ');
        return result + m_arrays;
    }

private:
    /// Place and length of an array among the others.
    template <class Element>
    Json array(const std::vector<Element>& elements)
    {
        static_assert(std::is_trivially_copyable_v<Element> || std::is_same_v<Element, Vec3>);
        const std::size_t begin = m_arrays.size();
        m_arrays.append(reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element));
        m_arrays.resize(aligned(m_arrays.size()), '\0');
        return {begin, elements.size()};
    }

    /// Parts of a file share theirs.
    Json exactBytes(const std::shared_ptr<const std::string>& bytes)
    {
        const auto found = m_exact.find(bytes.get());
        if (found != m_exact.end())
            return found->second;
        return m_exact[bytes.get()] = array(std::vector<char>(bytes->begin(), bytes->end()));
    }

    static Json numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

    static Json colorOrNull(const std::optional<Color>& color)
    {
        return color ? Json{color->r, color->g, color->b} : Json(nullptr);
    }

    Json toJson(const Part& part)
    {
        Json json{{"name", part.name},
                  {"path", part.path},
                  {"color", colorOrNull(part.color)},
                  {"vertices", array(part.mesh.vertices)},
                  {"triangles", array(part.mesh.triangles)},
                  {"faceOfTriangle", array(part.mesh.faceOfTriangle)},
                  {"solids", part.solids},
                  {"shells", part.shells},
                  {"edges", part.edges},
                  {"volume", part.volume},
                  {"area", part.area},
                  {"watertight", part.watertight},
                  {"valid", part.valid},
                  {"insideOut", part.insideOut},
                  {"maxTolerance", part.maxTolerance},
                  {"visible", part.visible},
                  {"layer", part.layer}};
        put(json, "repairs", part.repairs);
        put(json, "warnings", part.warnings);
        if (!part.bodyOf.empty())
            json["bodyOf"] = part.bodyOf;
        if (!part.box.isEmpty())
            json["box"] = {numbers(part.box.min()), numbers(part.box.max())};
        if (part.exact)
            json["exact"] = {exactBytes(part.exact->bytes), part.exact->number, part.exact->unit};
        Json& faces = json["faces"] = Json::array();
        for (const PartFace& face : part.faces)
            faces.push_back(colorOrNull(face.color));
        Json& edges = json["openEdges"] = Json::array();
        for (const std::vector<Vec3>& edge : part.openEdges)
            edges.push_back(array(edge));
        return json;
    }

    Json toJson(const Model& model)
    {
        Json json{{"file", model.file},
                  {"format", model.format},
                  {"unit", model.unit},
                  {"parts", Json::array()},
                  {"nodes", Json::array()}};
        put(json, "warnings", model.warnings);
        put(json, "missing", model.missing);
        if (model.unitRemark)
            json["unitRemark"] = {{"sentence", model.unitRemark->sentence.english()},
                                  {"said", knead::toJson(model.unitRemark->sentence)},
                                  {"unit", model.unitRemark->unit}};
        for (const Part& part : model.parts)
            json["parts"].push_back(toJson(part));
        addNodes(model.tree, -1, json["nodes"]);
        return json;
    }

    std::string m_arrays;
    std::map<const std::string*, Json> m_exact;
};

// --- reading ----------------------------------------------------------------------------------------------------------

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

/// Parents come before their children.
PartNode treeOf(const Json& nodes, std::size_t parts)
{
    std::vector<PartNode> flat;
    std::vector<std::size_t> parents;
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
        if (bytes.size() < headerSize || !bytes.starts_with(modelMark))
            fail("it does not start as one");
        std::memcpy(&length, bytes.data() + headerSize - sizeof length, sizeof length);
        if (length > bytes.size() - headerSize)
            fail("it is cut off");
        const std::string_view document = bytes.substr(headerSize, length);
        m_json = Json::parse(document.begin(), document.end());
        m_arrays = bytes.substr(std::min(bytes.size(), aligned(headerSize + length)));
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

std::string modelToBytes(const Model& model)
{
    return ModelWriter().bytes(model);
}

Model modelFromBytes(std::string_view bytes)
{
    try {
        return ModelReader(bytes).model();
    } catch (const Json::exception& error) {
        fail(error.what());
    }
}

std::string previewToBytes(const FilePreview& preview)
{
    Json json{{"size", preview.size},   {"format", preview.format}, {"solids", preview.solids},
              {"faces", preview.faces}, {"parts", preview.parts},   {"nodes", Json::array()}};
    addNodes(preview.tree, -1, json["nodes"]);
    return std::string(previewMark) + json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

FilePreview previewFromBytes(std::string_view bytes)
{
    if (!bytes.starts_with(previewMark))
        fail("it is no preview");
    try {
        const Json json = Json::parse(bytes.substr(previewMark.size()));
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

std::string failureToBytes(const Message& sentence)
{
    try {
        return std::string(failureMark) + toJson(sentence).dump();
    } catch (const Json::type_error&) { // the name of a file need not be UTF-8
        return std::string(failureMark) + sentence.english();
    }
}

Message failureIn(std::string_view bytes)
{
    if (!bytes.starts_with(failureMark))
        return {};
    const std::string_view text = bytes.substr(failureMark.size());
    try {
        return messageFrom(Json::parse(text));
    } catch (const Json::exception&) {
        return Message::verbatim(std::string(text));
    }
}

} // namespace knead
