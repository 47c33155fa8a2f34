#include "io/study/study_reader.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/recipe/recipe_kinds.h"

#include <filesystem>
#include <set>

namespace knead {

namespace recipe_keys {

namespace {

constexpr int mostStudyRounds = 100;
constexpr int mostFieldSteps = 1'000'000; // of a field file
constexpr double longestLimit = 3.2e7;    // a year [s]
constexpr double largestFactor = 2;       // more takes back more than there is, twice
constexpr std::uint64_t highestFace = 10'000'000;

/// Not negative.
struct Distance {
    static double read(const JsonNode& node)
    {
        node.number(0, farAway);
        return node.thousandth();
    }
};

/// An object whose keys are the names of parts, with lists of the numbers of faces.
struct Faces {
    static FacesOfParts read(const JsonNode& node)
    {
        FacesOfParts faces;
        for (const std::string& part : node.keys()) {
            faces.emplace_back(part, std::vector<std::uint32_t>{});
            for (const JsonNode& number : node.at(part).items())
                faces.back().second.push_back(static_cast<std::uint32_t>(number.count(highestFace)));
            if (faces.back().second.empty())
                node.at(part).fail(Message("Study", "must name a face; leave the part out where none counts."));
        }
        if (faces.empty())
            node.fail(Message("Study", "must name a part; leave the key out where all faces count."));
        return faces;
    }
};

/// The name of a file in the folder of a round.
struct PlainName {
    static std::string read(const JsonNode& node)
    {
        std::string name = node.text();
        const bool isPlain = name.find('/') == std::string::npos && name != "." && name != "..";
        if (!isPlain)
            node.failExpecting(
                Message("Study", "must be the name of a file in the folder of the round, without folders"));
        return name;
    }
};

/// Files that go into one folder.
struct Templates {
    const Context& context;
    std::vector<std::string> read(const JsonNode& node) const
    {
        std::vector<std::string> files;
        std::set<std::string> names;
        for (const JsonNode& item : node.items()) {
            files.push_back(FilePath{context}.read(item));
            if (!names.insert(std::filesystem::path(files.back()).filename().string()).second)
                item.fail(Message("Study", "has the name of another one; all of them go into one folder."));
        }
        return files;
    }
};

struct Field {
    std::string file;
    FieldChoice choice;
};

struct StepNumber {
    static std::optional<std::size_t> read(const JsonNode& node)
    {
        return static_cast<std::size_t>(node.integer(1, mostFieldSteps) - 1);
    }
};

template <class Fields>
void describeKeys(Fields& fields, Field& field)
{
    fields.needed("file", field.file, PlainName{});
    fields.optional("step", field.choice.step, StepNumber{});
    fields.optional("name", field.choice.name, Text{});
    fields.optional("unit", field.choice.unit, LengthUnitName{});
    fields.optional("in_place", field.choice.isInPlace, Flag{});
}

/// A name alone, or an object.
struct FieldKind {
    const Context& context;
    Field read(const JsonNode& node) const
    {
        return node.isObject() ? Object<Field>{context}.read(node) : Field{PlainName::read(node), {}};
    }
};

/// Either a recipe, or a command and the field that it writes.
void checkWay(const JsonNode& root, const CompensationStudy& study)
{
    if (study.recipe.empty() == study.command.empty())
        root.fail(Message("Study", "must have exactly one of the keys recipe and command."));
    if (study.recipe.empty() && study.field.empty())
        root.fail(Message("Study", "must have the key \"field\": the file that the command writes."));
    for (const char* key : {"field", "files", "mesh_spacing_mm"})
        if (const auto found = root.find(key); found && !study.recipe.empty())
            found->fail(Message("Study", "belongs to a command; a recipe needs none."));
}

} // namespace

template <class Fields>
void describeKeys(Fields& fields, CompensationStudy& study)
{
    const Context& context = fields.context;
    int version = 1;
    fields.needed("version", version, Whole{1, 1});
    fields.needed("part", study.part, FilePath{context});
    fields.optional("faces", study.faces, Faces{});
    fields.optional("spacing_mm", study.spacing, PositiveMillimeters{});
    fields.needed("tolerance_mm", study.method.tolerance, PositiveMillimeters{});
    fields.optional("rounds", study.method.rounds, Whole{1, mostStudyRounds});
    fields.optional("factor", study.method.factor, Number{0.01, largestFactor});
    fields.optional("smoothing_mm", study.method.smoothing, Distance{});
    fields.optional("best_fit", study.method.fitsBest, Flag{});
    fields.optional("recipe", study.recipe, FilePath{context});
    fields.optional("command", study.command, ListOf{Text{}});
    fields.optional("files", study.files, Templates{context});
    fields.together({"field"}, [&](const JsonNode& root) {
        if (const auto node = root.find("field")) {
            Field field = FieldKind{context}.read(*node);
            study.field = std::move(field.file);
            study.choice = std::move(field.choice);
        }
    });
    fields.optional("mesh_spacing_mm", study.meshSpacing, PositiveMillimeters{});
    fields.optional("time_limit_s", study.timeLimit, Number{0.001, longestLimit});
    fields.check([&](const JsonNode& root) { checkWay(root, study); });
}

} // namespace recipe_keys

CompensationStudy readStudy(const std::string& path)
{
    static const std::vector<MaterialPreset> none;
    const JsonNode root = JsonNode::readFile(path);
    const recipe_keys::Context context{none, path};
    CompensationStudy study = recipe_keys::Object<CompensationStudy>{context}.read(root);
    study.file = path;
    return study;
}

} // namespace knead
