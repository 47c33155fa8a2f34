#pragma once

#include "io/json/exact_number.h"
#include "io/recipe/recipe_fields.h"
#include "io/recipe/recipe_values.h"
#include "io/recipe/scene_words.h"

namespace knead::recipe_keys {

// What keys of recipes hold: how it is read, with its bounds, and how it is written.

struct Number {
    double minimum = 0;
    double maximum = 0;
    double read(const JsonNode& node) const { return node.number(minimum, maximum); }
    static std::string text(double value) { return exactText(value); }
};

/// > 0
struct Positive {
    static double read(const JsonNode& node) { return node.positive(); }
    static std::string text(double value) { return exactText(value); }
};

/// Of a value in m.
struct Millimeters {
    static double read(const JsonNode& node) { return node.thousandth(); }
    static std::string text(double meters) { return exactThousandfold(meters); }
};

struct PositiveMillimeters {
    static double read(const JsonNode& node) { return node.positiveThousandth(); }
    static std::string text(double meters) { return exactThousandfold(meters); }
};

struct Whole {
    int minimum = 0;
    int maximum = 0;
    int read(const JsonNode& node) const { return node.integer(minimum, maximum); }
};

/// Three numbers, none larger than the limit in size.
struct Vector {
    double limit = 0;
    Vec3 read(const JsonNode& node) const { return readVector(node, limit); }
    static std::string text(const Vec3& value) { return listText(value, exactText); }
};

/// The same, of a value in m or m/s.
struct VectorInMillimeters {
    double limit = farAway;
    Vec3 read(const JsonNode& node) const { return readMillimeters(node, limit); }
    static std::string text(const Vec3& meters) { return listText(meters, exactThousandfold); }
};

/// Turns about the fixed axes x, y and z, in this order.
struct RotationInDegrees {
    static Quaternion read(const JsonNode& node) { return readRotation(node); }
};

struct BoxInMillimeters {
    static Box read(const JsonNode& node) { return readBox(node); }
    static std::string text(const Box& meters);
};

struct Flag {
    static bool read(const JsonNode& node) { return node.boolean(); }
    static std::string text(bool value) { return value ? "true" : "false"; }
};

/// A text that is not empty.
struct Text {
    static std::string read(const JsonNode& node) { return node.text(); }
    static std::string text(const std::string& value) { return quoted(value); }
};

struct AnyText {
    static std::string read(const JsonNode& node) { return node.anyText(); }
    static std::string text(const std::string& value) { return quoted(value); }
};

/// One of some words.
template <class Choice>
struct Word {
    const Choices<Choice>& words;
    Choice read(const JsonNode& node) const { return readChoice(node, words); }
    std::string text(Choice choice) const { return quoted(wordFor(choice, words)); }
};
template <class Choice>
Word(const Choices<Choice>&) -> Word<Choice>;

struct LengthUnitName {
    static std::string read(const JsonNode& node);
    static std::string text(const std::string& value) { return quoted(value); }
};

/// A file that exists, ready to open. What is written is seen from the recipe already.
struct FilePath {
    const Context& context;
    std::string read(const JsonNode& node) const { return readFilePath(node, context.recipePath); }
    static std::string text(const std::string& value) { return quoted(value); }
};

} // namespace knead::recipe_keys
