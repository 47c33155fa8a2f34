#pragma once

#include "core/geometry/mass_properties.h"
#include "core/model/part.h"
#include "io/document/size_limits.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Whether a text is one line without control characters, as sentences for a person are.
inline bool isOneLine(std::string_view text)
{
    return std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

inline bool isInside(const std::vector<Vec3>& points, const Box& box)
{
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec3& point) { return point.allFinite() && box.contains(point); });
}

/// What is wrong with a part, whatever it was made of; empty when nothing is.
inline std::string flawOf(const Part& part)
{
    const TriangleMesh& mesh = part.mesh;
    if (!isWithinReach(part.box))
        return "it has no box within reach";
    Box wide = part.box;
    const double size = part.box.diagonal().norm();
    wide.min().array() -= size; // tolerances and coarse triangles reach out a little
    wide.max().array() += size;
    if (!isInside(mesh.vertices, wide))
        return "a vertex lies far outside of the box";
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= mesh.vertices.size())
                return "a triangle has a vertex that is not there";
    if (!mesh.faceOfTriangle.empty() && mesh.faceOfTriangle.size() != mesh.triangles.size())
        return "not every triangle has a face";
    for (const std::uint32_t face : mesh.faceOfTriangle)
        if (face >= part.faces.size())
            return "a triangle has a face that is not there";
    if (!std::isfinite(part.volume) || part.volume < 0 || !std::isfinite(part.area) || part.area < 0)
        return "its volume or area is no size";
    if (!std::isfinite(part.maxTolerance))
        return "its tolerance is no number";
    if (part.watertight && !isWatertight(mesh))
        return "it claims to be watertight and is not";
    if (part.canBeFilled() && !(massProperties(mesh).volume > 0))
        return "it claims to be fillable and is inside out or flat";
    for (const std::vector<Vec3>& edge : part.openEdges)
        if (!isInside(edge, wide))
            return "an open edge lies far outside of the box";
    if (part.name.empty() || !isOneLine(part.name))
        return "its name is empty or not one line";
    for (const std::vector<Message>& texts : {part.warnings, part.repairs})
        for (const Message& text : texts)
            if (const std::string english = text.english(); !isOneLine(english) || !english.ends_with('.'))
                return "it has no sentence: " + english;
    return {};
}

inline void countParts(const PartNode& node, std::vector<int>& counts)
{
    if (node.part && *node.part < counts.size())
        ++counts[*node.part];
    else if (node.part)
        counts.push_back(-1);
    for (const PartNode& child : node.children)
        countParts(child, counts);
}

/// What is wrong with a model; empty when nothing is.
inline std::string flawOf(const Model& model)
{
    if (model.parts.empty())
        return "it has no parts";
    for (const Part& part : model.parts)
        if (const std::string flaw = flawOf(part); !flaw.empty())
            return "part \"" + part.name + "\": " + flaw;
    std::vector<int> counts(model.parts.size(), 0);
    countParts(model.tree, counts);
    if (counts.size() != model.parts.size() || std::any_of(counts.begin(), counts.end(), [](int n) { return n != 1; }))
        return "its tree does not hold every part once";
    for (const std::vector<Message>& texts : {model.warnings, model.missing})
        for (const Message& text : texts)
            if (const std::string english = text.english(); !isOneLine(english) || !english.ends_with('.'))
                return "it has no sentence: " + english;
    return {};
}

/// What is wrong with the sentence by which a file is refused; empty when nothing is.
/// @param name of the file
inline std::string flawOfRefusal(const std::string& sentence, const std::string& name)
{
    if (!sentence.starts_with(name + ": ") || sentence.size() < name.size() + 20)
        return "the sentence does not say which file and what is wrong: " + sentence;
    if (!isOneLine(sentence) || !sentence.ends_with('.') || sentence.size() > name.size() + 400)
        return "the sentence is not one line that is readable at a glance: " + sentence;
    if (sentence.find("result is damaged") != std::string::npos)
        return "the reader handed over what cannot be: " + sentence;
    return {};
}

} // namespace knead
