#include "core/session/measurement_text.h"

#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
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

[[noreturn]] void refuse(const std::string& text, const Message& why)
{
    throw Problem(Message("Measurement", "\"%1\" cannot be measured: %2").with(text, why));
}

/// Separated by blanks, but for those between quotes, which are left out.
std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    bool isQuoted = false;
    bool isWithin = false;
    for (const char letter : text) {
        isQuoted = letter == '"' ? !isQuoted : isQuoted;
        const bool isBlank = letter == ' ' && !isQuoted;
        if (!isBlank && !isWithin)
            words.emplace_back();
        isWithin = !isBlank;
        if (isWithin && letter != '"')
            words.back() += letter;
    }
    return words;
}

std::optional<double> number(const std::string& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value)
                                                                                            : std::nullopt;
}

SkinPlace readPlace(const std::string& word, const std::string& text, const FilledModel& content)
{
    std::vector<double> millimetres;
    std::stringstream stream(word);
    for (std::string one; std::getline(stream, one, ',');)
        if (const auto value = number(one))
            millimetres.push_back(*value);
    if (millimetres.size() != 3 || std::ranges::count(word, ',') != 2)
        refuse(text, Message("Measurement", "a place is three coordinates in mm, as 10,0,2.5; this is %1.").with(word));
    const auto place = nearestPlace(1e-3 * Vec3(millimetres[0], millimetres[1], millimetres[2]), content.bodies);
    if (!place)
        refuse(text, Message("Measurement", "%1 lies far away from all bodies; coordinates are in mm.").with(word));
    return *place;
}

BodyId bodyNamed(const std::string& name, const std::string& text, const FilledModel& content)
{
    for (BodyId b = 0; b < content.bodies.size(); ++b)
        if (content.bodies[b]->name == name || name == '#' + std::to_string(b))
            return b;
    std::string known;
    for (const auto& body : content.bodies)
        known += (known.empty() ? "\"" : ", \"") + body->name + "\"";
    refuse(text, Message("Measurement", "there is no body \"%1\"; there are: %2.").with(name, known));
}

SkinPlace readFace(const std::string& word, const std::string& text, const FilledModel& content)
{
    const std::size_t colon = word.rfind(':');
    const bool isNamed = colon != std::string::npos;
    if (!isNamed && content.bodies.size() != 1)
        refuse(text, Message("Measurement", "which body the face %1 is of is not clear; put its name before it, as "
                                            "\"lid\":%1, or its number from 0, as #0:%1.")
                         .with(word));
    const BodyId body = isNamed ? bodyNamed(word.substr(0, colon), text, content) : 0;
    const TriangleMesh& mesh = content.bodies[body]->mesh;
    const auto face = number(isNamed ? word.substr(colon + 1) : word);
    const auto found =
        std::ranges::find_if(mesh.faceOfTriangle, [&](std::uint32_t one) { return face && one == *face; });
    if (found == mesh.faceOfTriangle.end())
        refuse(
            text,
            Message("Measurement", "there is no face %1; faces are numbered from 0, and meshes have none.").with(word));
    return {body, static_cast<std::uint32_t>(found - mesh.faceOfTriangle.begin()), Vec3::Constant(1.0 / 3)};
}

} // namespace

Measurement measurementOf(const std::string& text, const FilledModel& content)
{
    const std::vector<std::string> words = wordsOf(text);
    const auto form =
        std::ranges::find_if(forms, [&](const Form& one) { return !words.empty() && words[0] == one.word; });
    if (form == forms.end()) {
        std::string known;
        for (const Form& one : forms)
            known += (known.empty() ? "" : ", ") + std::string(one.word);
        refuse(text, Message("Measurement", "it begins with none of %1.").with(known));
    }
    const std::string_view picks = form->picks;
    if (words.size() != picks.size() + 1)
        refuse(text, Message("Measurement", "%1 takes %2 places or faces.").with(words[0], picks.size()));
    Measurement measurement{.kind = form->kind, .places = {}};
    for (std::size_t i = 0; i < picks.size(); ++i)
        measurement.places.push_back(picks[i] == 'p' ? readPlace(words[i + 1], text, content)
                                                     : readFace(words[i + 1], text, content));
    return measurement;
}

std::string wordFor(MeasureKind kind)
{
    const auto form = std::ranges::find(forms, kind, &Form::kind);
    return form != forms.end() ? form->word : kind == MeasureKind::box ? "box" : "mass";
}

} // namespace knead
