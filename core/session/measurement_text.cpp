#include "core/session/measurement_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace knead {

namespace {

/// What a word takes: a letter each, p for a place and f for a face.
struct Form {
    MeasureKind kind;
    const char* word;
    const char* picks;
};
constexpr std::array<Form, 7> forms{{{MeasureKind::point, "point", "p"},
                                     {MeasureKind::distance, "distance", "pp"},
                                     {MeasureKind::distanceToFace, "distance-to-face", "pf"},
                                     {MeasureKind::angle, "angle", "ppp"},
                                     {MeasureKind::angleOfFaces, "face-angle", "ff"},
                                     {MeasureKind::radius, "radius", "ppp"},
                                     {MeasureKind::radiusOfFace, "face-radius", "f"}}};

[[noreturn]] void refuse(const std::string& text, const std::string& why)
{
    throw std::runtime_error("\"" + text + "\" cannot be measured: " + why);
}

std::optional<double> number(const std::string& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

SkinPlace readPlace(const std::string& word, const std::string& text, const FilledModel& content)
{
    std::vector<double> millimetres;
    std::stringstream stream(word);
    for (std::string one; std::getline(stream, one, ',');)
        if (const auto value = number(one))
            millimetres.push_back(*value);
    if (millimetres.size() != 3 || std::ranges::count(word, ',') != 2)
        refuse(text, "a place is three coordinates in mm, as 10,0,2.5; this is " + word + ".");
    return nearestPlace(1e-3 * Vec3(millimetres[0], millimetres[1], millimetres[2]), content.bodies);
}

BodyId bodyNamed(const std::string& name, const std::string& text, const FilledModel& content)
{
    for (BodyId b = 0; b < content.bodies.size(); ++b)
        if (content.bodies[b]->name == name)
            return b;
    std::string known;
    for (const auto& body : content.bodies)
        known += (known.empty() ? "\"" : ", \"") + body->name + "\"";
    refuse(text, "there is no body \"" + name + "\"; there are: " + known + ".");
}

SkinPlace readFace(const std::string& word, const std::string& text, const FilledModel& content)
{
    const std::size_t colon = word.rfind(':');
    const bool isNamed = colon != std::string::npos;
    if (!isNamed && content.bodies.size() > 1)
        refuse(text, "there are several bodies; put the name before the face, as " + content.bodies[0]->name + ":" +
                         word + ".");
    const BodyId body = isNamed ? bodyNamed(word.substr(0, colon), text, content) : 0;
    const TriangleMesh& mesh = content.bodies[body]->mesh;
    const auto face = number(isNamed ? word.substr(colon + 1) : word);
    const auto found =
        std::ranges::find_if(mesh.faceOfTriangle, [&](std::uint32_t one) { return face && one == *face; });
    if (found == mesh.faceOfTriangle.end())
        refuse(text, "there is no face " + word + "; faces are numbered from 0, as in recipes" +
                         (mesh.faceOfTriangle.empty() ? ", and a mesh has none." : "."));
    return {body, static_cast<std::uint32_t>(found - mesh.faceOfTriangle.begin()), Vec3::Constant(1.0 / 3)};
}

} // namespace

Measurement measurementOf(const std::string& text, const FilledModel& content)
{
    std::stringstream stream(text);
    std::string word;
    stream >> word;
    const auto form = std::ranges::find_if(forms, [&](const Form& one) { return word == one.word; });
    if (form == forms.end()) {
        std::string known;
        for (const Form& one : forms)
            known += (known.empty() ? "" : ", ") + std::string(one.word);
        refuse(text, "it begins with none of " + known + ".");
    }
    Measurement measurement{.kind = form->kind, .places = {}};
    for (const char* pick = form->picks; *pick != 0; ++pick) {
        const bool isPlace = *pick == 'p';
        if (!(stream >> word))
            refuse(text, isPlace ? "a place is missing, as 10,0,2.5." : "the number of a face is missing.");
        measurement.places.push_back(isPlace ? readPlace(word, text, content) : readFace(word, text, content));
    }
    if (stream >> word)
        refuse(text, word + " is too much.");
    return measurement;
}

std::string wordFor(MeasureKind kind)
{
    const auto form = std::ranges::find(forms, kind, &Form::kind);
    return form != forms.end() ? form->word : kind == MeasureKind::box ? "box" : "mass";
}

} // namespace knead
