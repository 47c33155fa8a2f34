#include "core/mechanics/tool_shape.h"
#include "core/model/file_formats.h"
#include "support/full_recipes.h"
#include "support/recipe_texts.h"
#include "support/skip.h"

#include <QtTest>

#include <QDir>
#include <QProcess>
#include <QRegularExpression>

#include <algorithm>
#include <set>
#include <utility>

using namespace knead;
using namespace knead::recipe_texts;

/// The schema that editors check recipes with says the same as the reader, who is asked.
class RecipeSchemaTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void keysAreThoseOfTheReader_data();
    void keysAreThoseOfTheReader();
    void everyObjectIsCompared();
    void keysAreDocumented();
    void examplesFit();
    void verdictsAreThoseOfTheReader();

private:
    /// Whether documents fit; empty when there is no validator.
    std::vector<bool> verdictsOn(const std::vector<std::string>& documents);

    json m_schema;
    std::string m_readme;
};

namespace {

using Place = json::json_pointer;
using Keys = std::set<std::string>;

/// What the reader says is allowed at a place of a recipe, by its refusal of a key that is not.
/// @param place in the first full recipe, or in the second after a "~"
Keys allowedAt(const std::string& where)
{
    const bool isSecond = where.starts_with('~');
    const Place place(where.substr(isSecond ? 1 : 0));
    json recipe = fullRecipes()[isSecond ? 1 : 0];
    recipe[place]["no such key"] = 1;
    QString list = QString::fromStdString(messageFor(recipe)).section("allowed here: ", 1);
    list.chop(1);
    Keys keys;
    for (const QString& key : list.split(", "))
        keys.insert(key.toStdString());
    return keys;
}

Keys keysOf(const json& object)
{
    Keys keys;
    for (const auto& [key, value] : object.items())
        keys.insert(key);
    return keys;
}

/// Objects of the schema that have keys of their own, and where a recipe has one of them.
const std::vector<std::pair<std::string, std::string>>& objects()
{
    static const std::vector<std::pair<std::string, std::string>> all{
        {"", ""},
        {"/properties/part", "/part"},
        {"/properties/floor", "/floor"},
        {"/$defs/materialNumbers", "/material"},
        {"/$defs/deformByNumber", "/deform/0"},
        {"/$defs/deformByField", "/deform/1"},
        {"/$defs/keptFaces", "~/deform/5/kept_faces/0"},
        {"/$defs/extraPart", "/extra_parts/0"},
        {"/$defs/body", "/bodies/lid"},
        {"/$defs/fixture", "/fixtures/0"},
        {"/$defs/materialRegion", "/regions/0"},
        {"/$defs/manipulator", "/manipulators/0"},
        {"/$defs/keyframe", "/manipulators/0/keyframes/0"},
        {"/$defs/turn", "~/fixtures/0/turn"},
        {"/$defs/load", "/loads/0"},
        {"/$defs/probe", "/probes/0"},
        {"/$defs/changeOfLoad", "~/events/8/change_load"},
        {"/$defs/pose", "~/events/10/add_manipulator/motion/go_to"},
        {"/$defs/frame", "~/events/14/move_manipulator/keyframes/1"},
        {"/$defs/motion", "~/manipulators/0/motion"},
        {"/$defs/move", "~/events/11/move_manipulator"},
        {"/$defs/placing", "~/events/15/place_manipulator"},
        {"/$defs/reshaping", "~/events/16/reshape_manipulator"},
        {"/$defs/moveOfFixture", "~/events/5/move_fixture"},
        {"/$defs/changeOfFloor", "~/events/2/floor"},
        {"/$defs/event", "/events/0"},
        {"/$defs/renormalize", "/events/4/renormalize"},
        {"/$defs/changeOfKind", "/events/5/body_kind"},
        {"/$defs/refill", "/events/7/refill"},
        {"/$defs/cut", "/events/8/cut"},
        {"/$defs/deformByPhysics", "/events/9/deform_by_physics"},
        {"/$defs/exportedFile", "/exports/0"},
        {"/$defs/picture", "/exports/1"},
    };
    return all;
}

/// Every value within a value, itself included.
std::vector<Place> placesIn(const json& value, const Place& place = Place())
{
    std::vector<Place> places{place};
    if (!value.is_structured())
        return places;
    for (const auto& [key, member] : value.items()) {
        const Place at = value.is_array() ? place / static_cast<std::size_t>(std::stoul(key)) : place / key;
        const std::vector<Place> more = placesIn(member, at);
        places.insert(places.end(), more.begin(), more.end());
    }
    return places;
}

/// What a person could write instead of a value, right or wrong; of names of kinds and files some only, where it is no text.
std::vector<json> otherValues(const json& was)
{
    std::vector<json> values =
        json::parse(R"([null, true, "", "x", "clay", "box", "part", "rigid", "top", "published", "a.stl",
        "../a.stl", "/a.stl", "a.Png", "a.xyz", -1e7, -1, 0, 1e-10, 0.3, 1, 2.5, 15, 2000, 4e3, 1e6, 2e12, [], {}, [0, 0, 0],
        [1, 2], [1, 2, 3], [1, 2, "3"], [1, 2, 1e7], [0, 0, 0, 1, 1, 1], [-1], [0.5], {"preset": "clay"},
        {"file": "bar.stl"}, {"name": "x", "faces": [1]}])");
    if (!was.is_string())
        return values;
    for (const ToolKind kind : toolKinds)
        values.emplace_back(nameOf(kind));
    for (const FileFormat& format : fileFormats)
        for (const std::string& ending : format.endings)
            values.push_back("a." + ending);
    return values;
}

/// The bounds of the numbers of materials, from inside and from outside.
std::vector<std::string> boundsOfMaterials()
{
    std::vector<std::string> recipes;
    for (const MaterialField& field : materialFields())
        for (const double bound : {field.minimum, field.maximum})
            for (const double factor : {1 - 1e-9, 1.0, 1 + 1e-9}) {
                json recipe = smallest();
                recipe["material"][field.key] = bound == 0 ? factor - 1 : bound * factor;
                recipes.push_back(recipe.dump());
            }
    return recipes;
}

/// Of a list of numbers one is enough.
bool isAnotherItem(const json& recipe, const Place& place)
{
    return !place.empty() && recipe.at(place.parent_pointer()).is_array() && recipe.at(place).is_number() &&
           place.back() != "0";
}

/// Of places in a recipe: another value, nothing, or one key more. Texts, since tens of thousands of trees take more time than all
/// that is asked of them.
void addVariants(json recipe, const std::vector<Place>& places, std::vector<std::string>& variants)
{
    for (const Place& place : places) {
        if (isAnotherItem(recipe, place))
            continue;
        const json was = recipe.at(place);
        for (json& value : otherValues(was)) {
            recipe[place] = std::move(value);
            variants.push_back(recipe.dump());
        }
        recipe[place] = was;
        if (!place.empty() && recipe.at(place.parent_pointer()).is_object()) {
            recipe.at(place.parent_pointer()).erase(place.back());
            variants.push_back(recipe.dump());
            recipe[place] = was;
        }
        for (const char* key : {"no_such_key", "box_mm", "faces", "part_file", "gravity_m_s2"})
            if (was.is_object() && !was.contains(key)) {
                recipe[place][key] = {0, 0, 0, 1, 1, 1};
                variants.push_back(recipe.dump());
                recipe[place].erase(key);
            }
    }
}

/// As messageForText(), of texts by the ten thousand: none is written to a file.
std::string quickMessage(const std::string& text)
{
    static const QTemporaryDir folder;
    static const bool hasPart =
        (std::ofstream(folder.filePath("bar.stl").toStdString()) << "solid").good(); // which recipes name
    try {
        readRecipeText(text, folder.filePath("bend.recipe.json").toStdString(), presets);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return hasPart ? "accepted" : "bar.stl could not be written";
}

bool isAccepted(const json& recipe)
{
    return quickMessage(recipe.dump()) == "accepted";
}

/// Without all members but one that the reader does not miss.
json withoutOthers(json recipe, const std::string& member)
{
    for (const std::string& key : keysOf(recipe)) {
        if (key == member)
            continue;
        const json was = recipe.at(key);
        recipe.erase(key);
        if (!isAccepted(recipe))
            recipe[key] = was;
    }
    return recipe;
}

/// With one item of a list, or those before it, if that is enough for the reader. @return also which it is then
std::pair<json, std::size_t> withItem(const json& recipe, const std::string& member, std::size_t item)
{
    const json& all = recipe.at(member);
    for (const std::size_t first : {item, std::size_t{0}}) {
        json some = recipe;
        some[member] =
            json(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(item + 1));
        if (isAccepted(some))
            return {withoutOthers(some, member), item - first};
    }
    return {withoutOthers(recipe, member), item};
}

/// With the first item of each list, if that is enough for the reader.
json shortened(json recipe)
{
    for (const std::string& member : keysOf(recipe)) {
        if (!recipe[member].is_array() || recipe[member].empty())
            continue;
        const json was = std::exchange(recipe[member], json::array({recipe[member][0]}));
        if (!isAccepted(recipe))
            recipe[member] = was;
    }
    return recipe;
}

/// All recipes that differ from a full one in one place. Within a member the others are left out, if the reader does not miss them:
/// what a value may be depends on what stands beside it, and on what is named elsewhere.
std::vector<std::string> variantsOf(const json& recipe)
{
    const json all = shortened(recipe);
    std::vector<std::string> variants;
    addVariants(all, {Place()}, variants);
    for (const std::string& member : keysOf(recipe)) {
        const json& value = recipe.at(member);
        const Place at = Place() / member;
        addVariants(all, {at}, variants);
        if (value.is_object()) {
            const std::vector<Place> places = placesIn(value, at);
            addVariants(withoutOthers(recipe, member), {places.begin() + 1, places.end()}, variants);
        }
        if (!value.is_array())
            continue;
        for (std::size_t item = 0; item < value.size(); ++item) {
            if (isAnotherItem(recipe, at / item))
                continue;
            const auto [some, number] = withItem(recipe, member, item);
            addVariants(some, placesIn(value[item], at / number), variants);
        }
    }
    return variants;
}

/// What no schema can know: which names and files there are, and how values go together.
bool isBeyondSchemas(const std::string& message)
{
    const std::vector<std::string> words{"names a file that does not exist",
                                         "names the unknown material",
                                         "which is not in the recipe",
                                         "is used twice",
                                         "is written twice",
                                         "must hold the lowest x, y, z",
                                         "asks for a speed",
                                         "must be one of mm, ",
                                         "must not be earlier than",
                                         "must not be less than",
                                         "must go on upwards",
                                         "must be larger than from_mm",
                                         "must point across the axis",
                                         "goes around more than ten times",
                                         "must be later than",
                                         "of length 1",
                                         "needs an event with a step"};
    static const QRegularExpression afterTheEnd("events\\[.\\].time_s must be a number between 0 and [0-9.]+, ");
    return afterTheEnd.match(QString::fromStdString(message)).hasMatch() ||
           std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return message.find(word) != std::string::npos; });
}

} // namespace

void RecipeSchemaTest::initTestCase()
{
    m_schema = json::parse(std::ifstream(KNEAD_RESOURCES "/recipe.schema.json"));
    std::ifstream file(KNEAD_RESOURCES "/examples/README.md");
    m_readme = {std::istreambuf_iterator<char>(file), {}};
    for (const json& recipe : fullRecipes())
        QCOMPARE(messageFor(recipe), std::string("accepted"));
}

std::vector<bool> RecipeSchemaTest::verdictsOn(const std::vector<std::string>& documents)
{
    QProcess process;
    process.start("/usr/bin/python3", {KNEAD_TEST_DATA "/../support/validate_json.py"});
    process.write(QByteArray::fromStdString("{\"schema\": " + m_schema.dump() + ", \"documents\": ["));
    for (const std::string& document : documents)
        process.write(QByteArray::fromStdString((&document == documents.data() ? "" : ", ") + document));
    process.write("]}");
    process.closeWriteChannel();
    process.waitForFinished(300'000);
    const json verdicts = json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);
    return verdicts.is_array() ? verdicts.get<std::vector<bool>>() : std::vector<bool>{};
}

void RecipeSchemaTest::keysAreThoseOfTheReader_data()
{
    QTest::addColumn<QString>("place");
    for (const auto& [definition, place] : objects())
        QTest::newRow(definition.c_str()) << QString::fromStdString(place);
}

void RecipeSchemaTest::keysAreThoseOfTheReader()
{
    QFETCH(QString, place);
    const Keys keys = keysOf(m_schema.at(Place(QTest::currentDataTag())).at("properties"));
    QVERIFY2(keys == allowedAt(place.toStdString()), json(allowedAt(place.toStdString())).dump().c_str());
}

void RecipeSchemaTest::everyObjectIsCompared()
{
    std::size_t strict = 0;
    for (const Place& place : placesIn(m_schema))
        strict +=
            m_schema.at(place).is_object() && m_schema.at(place).value("additionalProperties", json(true)) == false ? 1
                                                                                                                    : 0;
    QCOMPARE(strict, objects().size());
}

void RecipeSchemaTest::keysAreDocumented()
{
    for (const auto& [definition, place] : objects())
        for (const std::string& key : keysOf(m_schema.at(Place(definition)).at("properties")))
            QVERIFY2(m_readme.find("`" + key + "`") != std::string::npos ||
                         m_readme.find("\"" + key + "\"") != std::string::npos,
                     key.c_str());
    for (const ToolKind kind : toolKinds)
        QVERIFY(m_readme.find("\"" + std::string(nameOf(kind)) + "\"") != std::string::npos);
    for (const FileFormat& format : fileFormats)
        for (const std::string& ending : format.endings)
            QVERIFY2(m_readme.find("." + ending) != std::string::npos, ending.c_str());
}

void RecipeSchemaTest::examplesFit()
{
    const QDir folder(KNEAD_RESOURCES "/examples");
    std::vector<std::string> examples;
    for (const json& recipe : fullRecipes())
        examples.push_back(recipe.dump());
    for (const QString& name : folder.entryList({"*.recipe.json"}))
        examples.push_back(json::parse(std::ifstream(folder.filePath(name).toStdString())).dump());
    QVERIFY(examples.size() > 8);
    const std::vector<bool> verdicts = verdictsOn(examples);
    if (verdicts.empty())
        KNEAD_SKIP_WITHOUT("tools", "There is no validator: install python3-jsonschema.");
    QCOMPARE(verdicts, std::vector<bool>(examples.size(), true));
}

void RecipeSchemaTest::verdictsAreThoseOfTheReader()
{
    std::vector<std::string> variants = boundsOfMaterials();
    for (const json& recipe : fullRecipes()) {
        const std::vector<std::string> more = variantsOf(recipe);
        variants.insert(variants.end(), more.begin(), more.end());
    }
    const std::vector<bool> verdicts = verdictsOn(variants);
    if (verdicts.empty())
        KNEAD_SKIP_WITHOUT("tools", "There is no validator: install python3-jsonschema.");
    QCOMPARE(verdicts.size(), variants.size());
    std::size_t good = 0;
    int different = 0;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const std::string message = quickMessage(variants[i]);
        const bool isGood = message == "accepted";
        good += isGood ? 1 : 0;
        if (verdicts[i] != isGood && !isBeyondSchemas(message))
            qWarning("%s %s", message.c_str(),
                     json::diff(fullRecipes()[0], json::parse(variants[i])).dump().substr(0, 300).c_str());
        different += verdicts[i] != isGood && !isBeyondSchemas(message) ? 1 : 0;
    }
    QCOMPARE(different, 0);
    QVERIFY(good > 500 && good < variants.size() / 2);
}

QTEST_GUILESS_MAIN(RecipeSchemaTest)
#include "recipe_schema_test.moc"
