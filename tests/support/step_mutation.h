#pragma once

#include "support/byte_mutation.h"

#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Damage to STEP files (ISO 10303-21) that only a reader of entities notices.
namespace knead::fuzz {

struct StepEntity {
    std::string name; ///< "#12"
    std::string body; ///< "CARTESIAN_POINT('',(0.,0.,0.))"
};

/// A STEP file cut into entities; roughly, but text() gives back what was cut.
struct StepText {
    std::string head; ///< up to and with DATA;
    std::vector<StepEntity> entities;
    std::string tail; ///< from the last ENDSEC; on

    std::string text() const
    {
        std::string result = head;
        for (const StepEntity& entity : entities)
            result += entity.name + "=" + entity.body + ";\n";
        return result + tail;
    }
};

inline std::size_t endOfStatement(std::string_view text, std::size_t begin)
{
    bool isInText = false;
    for (std::size_t i = begin; i < text.size(); ++i)
        if (text[i] == '\'')
            isInText = !isInText;
        else if (text[i] == ';' && !isInText)
            return i;
    return text.npos;
}

inline StepText parsedStep(const std::string& text)
{
    StepText result;
    std::size_t place = text.find("DATA;");
    place = place == text.npos ? text.size() : place + 5;
    result.head = text.substr(0, place) + "\n";
    for (;;) {
        const std::size_t begin = text.find_first_not_of(" \r\n", place);
        const std::size_t end = endOfStatement(text, place);
        const std::size_t equals = begin == text.npos ? text.npos : text.find('=', begin);
        if (begin == text.npos || text[begin] != '#' || end == text.npos || equals == text.npos || equals > end) {
            result.tail = begin == text.npos ? "" : text.substr(begin);
            return result;
        }
        std::string name = text.substr(begin, equals - begin);
        std::erase(name, ' ');
        const std::size_t body = std::min(text.find_first_not_of(" \r\n", equals + 1), end);
        result.entities.push_back({std::move(name), text.substr(body, end - body)});
        place = end + 1;
    }
}

/// A token of the body of an entity.
struct StepToken {
    enum class Kind { word, reference, number, text, mark };
    Kind kind;
    Span place;
};

inline std::vector<StepToken> tokensOf(std::string_view body)
{
    const auto isWordLetter = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-' ||
               c == '#';
    };
    std::vector<StepToken> tokens;
    for (std::size_t i = 0; i < body.size();) {
        std::size_t end = i + 1;
        StepToken::Kind kind = StepToken::Kind::mark;
        if (body[i] == '\'') {
            end = std::min(body.find('\'', end), body.size() - 1) + 1;
            kind = StepToken::Kind::text;
        } else if (isWordLetter(body[i])) {
            while (end < body.size() && isWordLetter(body[end]))
                ++end;
            const char first = body[i];
            kind = first == '#' ? StepToken::Kind::reference
                   : std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '-' || first == '+'
                       ? StepToken::Kind::number
                       : StepToken::Kind::word;
        }
        tokens.push_back({kind, {i, end - i}});
        i = end;
    }
    return tokens;
}

inline std::vector<Span> placesOf(std::string_view body, StepToken::Kind kind)
{
    std::vector<Span> places;
    for (const StepToken& token : tokensOf(body))
        if (token.kind == kind)
            places.push_back(token.place);
    return places;
}

/// The members of one list of the body, any of them; empty when it has none.
inline std::vector<Span> membersOfSomeList(std::string_view body, Random& random)
{
    const std::vector<StepToken> tokens = tokensOf(body);
    std::vector<std::size_t> opening;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (body[tokens[i].place.begin] == '(')
            opening.push_back(i);
    if (opening.empty())
        return {};
    const std::size_t first = random.oneOf(opening);
    std::vector<Span> members;
    std::size_t begin = tokens[first].place.begin + 1;
    int depth = 0;
    for (std::size_t i = first; i < tokens.size(); ++i) {
        const char mark = tokens[i].kind == StepToken::Kind::mark ? body[tokens[i].place.begin] : ' ';
        depth += mark == '(' ? 1 : mark == ')' ? -1 : 0;
        if ((depth == 1 && mark == ',') || depth == 0) {
            members.push_back({begin, tokens[i].place.begin - begin});
            begin = tokens[i].place.begin + 1;
        }
        if (depth == 0)
            break;
    }
    return members;
}

namespace step {

inline void deleteEntity(StepText& step, Random& random)
{
    step.entities.erase(step.entities.begin() + static_cast<std::ptrdiff_t>(random.below(step.entities.size())));
}

inline void duplicateEntity(StepText& step, Random& random)
{
    StepEntity copy = random.oneOf(step.entities);
    if (random.chance(50))
        copy.name = "#" + std::to_string(100'000 + random.below(1000));
    step.entities.insert(step.entities.begin() + static_cast<std::ptrdiff_t>(random.below(step.entities.size())), copy);
}

inline void swapEntities(StepText& step, Random& random)
{
    std::swap(random.oneOf(step.entities).body, random.oneOf(step.entities).body);
}

inline std::string typeOf(const std::string& body)
{
    return body.substr(0, body.find('('));
}

/// To an entity of the same type as it was, of another type, to itself, or to nothing.
inline void redirectReference(StepText& step, Random& random)
{
    StepEntity& entity = random.oneOf(step.entities);
    const std::vector<Span> references = placesOf(entity.body, StepToken::Kind::reference);
    if (references.empty())
        return;
    const Span place = random.oneOf(references);
    std::string target = random.oneOf(step.entities).name;
    if (random.chance(15))
        target = entity.name;
    else if (random.chance(15))
        target = random.chance(50) ? "#99999" : "#99999999999";
    else if (random.chance(40)) {
        const std::string before = entity.body.substr(place.begin, place.length);
        std::string type;
        for (const StepEntity& other : step.entities)
            if (other.name == before)
                type = typeOf(other.body);
        std::vector<std::string> alike;
        for (const StepEntity& other : step.entities)
            if (typeOf(other.body) == type)
                alike.push_back(other.name);
        if (!alike.empty())
            target = random.oneOf(alike);
    }
    entity.body.replace(place.begin, place.length, target);
}

inline void swapReferences(StepText& step, Random& random)
{
    std::string& body = random.oneOf(step.entities).body;
    const std::vector<Span> references = placesOf(body, StepToken::Kind::reference);
    if (references.size() < 2)
        return;
    const std::size_t i = random.below(references.size() - 1);
    const Span a = references[i];
    const Span b = references[i + 1];
    const std::string first = body.substr(a.begin, a.length);
    const std::string second = body.substr(b.begin, b.length);
    body.replace(b.begin, b.length, first); // the later one first, so that the place of the other still holds
    body.replace(a.begin, a.length, second);
}

inline void changeNumber(StepText& step, Random& random)
{
    for (int attempt = 0; attempt < 20; ++attempt) { // most entities have no numbers
        std::string& body = random.oneOf(step.entities).body;
        const std::vector<Span> numbers = placesOf(body, StepToken::Kind::number);
        if (numbers.empty())
            continue;
        const Span place = random.oneOf(numbers);
        body.replace(place.begin, place.length, changedNumber(body.substr(place.begin, place.length), random));
        return;
    }
}

/// To a type that others of the file have.
inline void changeType(StepText& step, Random& random)
{
    std::string& body = random.oneOf(step.entities).body;
    const std::string type = typeOf(random.oneOf(step.entities).body);
    body.replace(0, typeOf(body).size(), random.chance(90) ? type : "NO_SUCH_TYPE");
}

inline void changeEnumeration(StepText& step, Random& random)
{
    static constexpr std::array<std::string_view, 7> words{".T.", ".F.", ".U.", ".UNSPECIFIED.", ".MILLI.", ".X.", "$"};
    for (int attempt = 0; attempt < 20; ++attempt) {
        std::string& body = random.oneOf(step.entities).body;
        const std::size_t begin = body.find("." + std::string(1, random.chance(50) ? 'T' : 'F') + ".");
        if (begin == body.npos)
            continue;
        body.replace(begin, 3, random.oneOf(words));
        return;
    }
}

inline void changeMembers(StepText& step, Random& random)
{
    std::string& body = random.oneOf(step.entities).body;
    const std::vector<Span> members = membersOfSomeList(body, random);
    if (members.empty())
        return;
    const Span member = random.oneOf(members);
    const Span other = random.oneOf(members);
    const std::string text = body.substr(member.begin, member.length);
    const std::size_t depth = random.chance(90) ? 1 + random.below(20) : 400 + random.below(200);
    switch (random.below(8)) {
    case 0: // with the comma before or after it
        body.erase(member.begin, member.length + (body[member.begin + member.length] == ',' ? 1 : 0));
        break;
    case 1:
        body.insert(member.begin, text + ",");
        break;
    case 2:
        for (std::size_t i = random.below(500); i > 0; --i)
            body.insert(member.begin, text + ",");
        break;
    case 3:
        body.replace(member.begin, member.length, std::string(depth, '(') + text + std::string(depth, ')'));
        break;
    case 4:
        body.replace(member.begin, member.length, random.chance(70) ? "$" : "*");
        break;
    case 5:
        body.replace(member.begin, member.length, "()");
        break;
    case 6:
        body.replace(members.front().begin, members.back().begin + members.back().length - members.front().begin, "");
        break;
    default:
        body.replace(other.begin, other.length, text);
    }
}

inline void damageString(StepText& step, Random& random)
{
    static const std::array<std::string, 14> damages{"''",
                                                     "'",
                                                     R"(\X2\D83D\X0\)",
                                                     R"(\X2\00)",
                                                     R"(\X2\ZZZZ\X0\)",
                                                     R"(\X4\0001F600\X0\)",
                                                     R"(\X\)",
                                                     R"(\S\\)",
                                                     R"(\P)",
                                                     "\\",
                                                     "\xFF\xFE",
                                                     "a\nb",
                                                     R"(\X4\FFFFFFFF\X0\)",
                                                     std::string(1, '\0')};
    for (int attempt = 0; attempt < 20; ++attempt) {
        std::string& body = random.oneOf(step.entities).body;
        const std::vector<Span> texts = placesOf(body, StepToken::Kind::text);
        if (texts.empty())
            continue;
        const Span place = random.oneOf(texts);
        const std::string damage = random.chance(95) ? random.oneOf(damages) : std::string(70'000, 'n');
        body.insert(place.begin + 1 + random.below(place.length - 1), damage);
        return;
    }
}

/// Assemblies that hold themselves, by any way round.
inline void closeCycle(StepText& step, Random& random)
{
    std::vector<std::size_t> usages;
    for (std::size_t i = 0; i < step.entities.size(); ++i)
        if (step.entities[i].body.starts_with("NEXT_ASSEMBLY_USAGE_OCCURRENCE"))
            usages.push_back(i);
    if (usages.empty())
        return swapReferences(step, random);
    StepEntity usage = step.entities[random.oneOf(usages)];
    const std::vector<Span> products = placesOf(usage.body, StepToken::Kind::reference);
    const std::string above = usage.body.substr(products[0].begin, products[0].length);
    const std::string below = usage.body.substr(products[1].begin, products[1].length);
    usage.body.replace(products[1].begin, products[1].length, above);
    if (random.chance(50))
        usage.body.replace(products[0].begin, products[0].length, below);
    usage.name = "#100999";
    step.entities.push_back(usage);
}

/// A length unit a thousand times larger or smaller, or none.
inline void changeUnit(StepText& step, Random& random)
{
    static constexpr std::array<std::string_view, 7> prefixes{"$",      ".KILO.", ".MICRO.", ".EXA.",
                                                              ".ATTO.", ".X.",    "1.0"};
    for (StepEntity& entity : step.entities)
        if (const std::size_t place = entity.body.find("SI_UNIT(.MILLI."); place != entity.body.npos)
            entity.body.replace(place + 8, 7, random.oneOf(prefixes));
}

} // namespace step

/// Changes one thing of a STEP text. @param other is what pieces may be taken from
inline void mutateStep(std::string& text, const std::string& other, Random& random)
{
    using Mutation = void (*)(StepText&, Random&);
    static constexpr std::array<Mutation, 24> mutations{
        step::deleteEntity,      step::duplicateEntity,   step::swapEntities,      step::redirectReference,
        step::redirectReference, step::redirectReference, step::redirectReference, step::redirectReference,
        step::swapReferences,    step::swapReferences,    step::changeNumber,      step::changeNumber,
        step::changeNumber,      step::changeNumber,      step::changeType,        step::changeType,
        step::changeEnumeration, step::changeMembers,     step::changeMembers,     step::changeMembers,
        step::damageString,      step::closeCycle,        step::changeUnit,        step::deleteEntity,
    };
    StepText parsed = parsedStep(text);
    const StepText donor = parsedStep(other);
    if (parsed.entities.empty() || donor.entities.empty() || random.chance(5))
        return mutateText(text, random);
    if (random.chance(2)) {
        text.resize(random.below(text.size()));
        return;
    }
    if (random.chance(2)) { // the head of one file and the end of another
        text.resize(random.below(text.size()));
        text += other.substr(random.below(other.size()));
        return;
    }
    if (random.chance(2)) { // a section twice
        const bool isData = random.chance(50);
        text = parsed.head + (isData ? "" : parsed.head) + parsed.text().substr(parsed.head.size()) +
               (isData ? parsed.text().substr(parsed.head.size() - 6) : "");
        return;
    }
    if (random.chance(4)) { // an entity of another file under a name of this
        random.oneOf(parsed.entities).body = donor.entities[random.below(donor.entities.size())].body;
    } else {
        random.oneOf(mutations)(parsed, random);
    }
    text = parsed.text();
}

} // namespace knead::fuzz
