// Models, previews and failures as bytes.
#include "core/message/message.h"
#include "io/json/message_json.h"
#include "io/worker/model_file.h"
#include "io/worker/model_format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::json;

/// In English, as earlier versions read them, and with what goes into them.
void put(Json& json, const std::string& key, const std::vector<Message>& messages)
{
    Json& english = json[key] = Json::array();
    for (const Message& message : messages)
        english.push_back(message.english());
    if (!messages.empty())
        json[key + "Said"] = toJson(messages);
}

/// Flat, each node with the number of its parent, since a tree may be thousands of levels deep.
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
        std::string result(model_format::headerSize, '\0');
        std::copy(model_format::modelMark.begin(), model_format::modelMark.end(), result.begin());
        const std::uint64_t length = document.size();
        std::memcpy(result.data() + model_format::headerSize - sizeof length, &length, sizeof length);
        result += document;
        result.resize(model_format::aligned(result.size()), ' ');
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
        m_arrays.resize(model_format::aligned(m_arrays.size()), '\0');
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
        Json faces = Json::array();
        Json names = Json::array();
        for (std::size_t f = 0; f < part.faces.size(); ++f) {
            faces.push_back(colorOrNull(part.faces[f].color));
            if (!part.faces[f].name.empty())
                names.push_back({f, part.faces[f].name});
        }
        json["faces"] = std::move(faces);
        if (!names.empty())
            json["faceNames"] = std::move(names);
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

} // namespace

std::string modelToBytes(const Model& model)
{
    return ModelWriter().bytes(model);
}

std::string previewToBytes(const FilePreview& preview)
{
    Json json{{"size", preview.size},   {"format", preview.format}, {"solids", preview.solids},
              {"faces", preview.faces}, {"parts", preview.parts},   {"nodes", Json::array()}};
    addNodes(preview.tree, -1, json["nodes"]);
    return std::string(model_format::previewMark) + json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string failureToBytes(const Message& sentence)
{
    try {
        return std::string(model_format::failureMark) + toJson(sentence).dump();
    } catch (const Json::type_error&) { // the name of a file need not be UTF-8
        return std::string(model_format::failureMark) + sentence.english();
    }
}

} // namespace knead
