#include "io/recipe/recipe_of_project.h"

#include "core/document/history.h"
#include "core/message/message.h"
#include "io/json/exact_number.h"
#include "io/recipe/recipe_deformations.h"
#include "io/recipe/recipe_events_text.h"
#include "io/recipe/recipe_objects.h"
#include "io/recipe/recipe_reader.h"
#include "io/recipe/recipe_tools.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// Only the published arrangement has connections along the diagonals of cells.
bool isAsPublished(const Aggregate& aggregate)
{
    return !aggregate.weight.back().empty();
}

/// Moments are kept at the end of whatever a person does, a deformation too; after the first step time has gone on.
bool changesAnything(const RecordedCommand& recorded)
{
    const bool isBookkeeping =
        std::holds_alternative<KeepMoment>(recorded.command) || std::holds_alternative<SetPace>(recorded.command);
    return recorded.step > 0 || !isBookkeeping;
}

class Writer {
public:
    Writer(const Project& project, const RecipeOfProjectChoices& choices, const std::vector<MaterialPreset>& presets)
        : m_project(project)
        , m_choices(choices)
        , m_start(project.starts.at(project.entries.at(project.current).start))
        , m_scene(m_start.scene)
        , m_model(*modelOf(project, m_start))
        , m_names(m_model, m_start)
        , m_words{project, m_start, m_names, {presets, choices.recipePath}, {}, toolPartsOf(project)}
    {
        if (!choices.projectPath.empty())
            m_words.toolPartFile = fileSeenFrom(choices.recipePath, choices.projectPath);
    }

    RecipeOfProject write()
    {
        checkParts();
        m_document.put("version", "1");
        putPart();
        putBodies();
        putWorld();
        putTools();
        putUnlessEmpty("events", events());
        m_document.put("duration_steps", std::to_string(m_project.entries[m_project.current].step));
        return {m_document.take(), std::move(m_remarks)};
    }

private:
    /// Those are filled that a recipe would fill, in the same way.
    void checkParts() const
    {
        if (m_scene.bodies.empty())
            throw Problem(Message("Recipe", "the project has no bodies."));
        std::vector<std::size_t> filled;
        for (std::size_t p = 0; p < m_model.parts.size(); ++p)
            if (const Part& part = m_model.parts[p];
                part.canBeFilled() || (m_project.import.fillsOpenParts && !part.mesh.empty()))
                filled.push_back(p);
        if (filled != m_start.partOfBody)
            throw Problem(Message(
                "Recipe", "some of its parts could not be filled with objects, which a recipe takes for an error."));
        const Body& first = m_scene.bodies.front();
        for (const Body& body : m_scene.bodies)
            if (body.aggregate->lattice.spacing != first.aggregate->lattice.spacing ||
                body.structuralFriction != first.structuralFriction)
                throw Problem(Message("Recipe", "its bodies differ in their spacing or structural friction."));
    }

    static bool isThere(const std::string& path)
    {
        std::error_code error;
        return fs::is_regular_file(path, error);
    }

    /// By numbers or a field.
    bool isDeformed() const { return m_start.model != nullptr; }

    /// Whether the parts are those of the files, or a recipe can say how they came of these.
    bool followFromFiles() const
    {
        const auto canBeSaid = [](const RecipeDeformation& deformation) {
            const auto* field = std::get_if<RecipeField>(&deformation.what);
            return field == nullptr || isThere(field->file);
        };
        return !isDeformed() || (m_choices.saysDeformations && !m_start.deformations.empty() &&
                                 std::ranges::all_of(m_start.deformations, canBeSaid));
    }

    bool namesProject() const
    {
        const std::vector<std::string>& paths = m_project.import.paths;
        return m_choices.namesProject || !followFromFiles() || paths.empty() || !std::ranges::all_of(paths, isThere);
    }

    void putPart()
    {
        recipe_keys::PartFiles part;
        part.fillsOpenParts = m_project.import.fillsOpenParts;
        if (namesProject()) {
            part.files = {projectWithParts()};
        } else {
            for (const std::string& path : m_project.import.paths)
                part.files.push_back(fileSeenFrom(m_choices.recipePath, path));
            part.import = m_project.import.options;
        }
        m_document.put("part", textOf(part));
        if (!namesProject())
            putUnlessEmpty("deform", deformations());
        m_document.put("spacing_mm", exactThousandfold(m_scene.bodies.front().aggregate->lattice.spacing));
        if (isAsPublished(*m_scene.bodies.front().aggregate))
            m_document.put("arrangement", quoted("published"));
    }

    /// As the recipe names it. Says why the parts come from there.
    std::string projectWithParts()
    {
        if (m_choices.projectPath.empty())
            throw Problem(
                followFromFiles()
                    ? Message("Recipe", "the files of its parts are not there any more; save the project first.")
                    : Message("Recipe",
                              "its parts were deformed after they were kneaded, or by a field whose file is "
                              "not there any more, or others were added, and only a project keeps them so; save the "
                              "project first."));
        if (!followFromFiles())
            m_remarks.push_back(Message("Recipe",
                                        "The parts were deformed by numbers or by a field, or others were added: the "
                                        "recipe takes them from the project, as they were then."));
        else if (!m_choices.namesProject)
            m_remarks.push_back(Message("Recipe", "The files that the parts were read from are not there any more: "
                                                  "the recipe takes the parts from the project."));
        return fileSeenFrom(m_choices.recipePath, m_choices.projectPath);
    }

    std::vector<std::string> deformations() const
    {
        std::vector<std::string> texts;
        for (RecipeDeformation deformation : m_start.deformations) {
            if (auto* field = std::get_if<RecipeField>(&deformation.what))
                field->file = fileSeenFrom(m_choices.recipePath, field->file);
            texts.push_back(recipe_keys::DeformationWords{m_words.context}.text(deformation));
        }
        return texts;
    }

    template <class Value>
    std::string textOf(const Value& value) const
    {
        return recipe_keys::Object<Value>{m_words.context}.text(value);
    }

    std::string materialText(const Material& material, const Material& base) const
    {
        return recipe_keys::MaterialWords{m_words.context}.text(m_words.material(material, base));
    }

    void putBodies()
    {
        const Material& common = m_scene.bodies.front().material;
        m_document.put("material", materialText(common, Material{}));
        ObjectText materials;
        ObjectText starts;
        std::vector<std::string> regions;
        for (BodyId b = 0; b < m_scene.bodies.size(); ++b) {
            const Body& body = m_scene.bodies[b];
            if (!(body.material == common))
                materials.put(keyOf(b), materialText(body.material, common));
            if (const std::string start = textOf(startOf(body)); start != "{}")
                starts.put(keyOf(b), start);
            for (const MaterialRegion& region : body.regions)
                regions.push_back(regionText(b, region));
        }
        putUnlessEmpty("body_materials", materials);
        putUnlessEmpty("regions", regions);
        putUnlessEmpty("bodies", starts);
        if (const double friction = m_scene.bodies.front().structuralFriction; friction != 0)
            m_document.put("structural_friction", exactText(friction));
    }

    /// A name as the key of an object, which is put in quotes there.
    std::string keyOf(BodyId body) const
    {
        const std::string name = quoted(m_names.body(body));
        return name.substr(1, name.size() - 2);
    }

    void putUnlessEmpty(const std::string& key, const ObjectText& object)
    {
        if (!object.isEmpty())
            m_document.put(key, object.take());
    }

    void putUnlessEmpty(const std::string& key, const std::vector<std::string>& items)
    {
        if (!items.empty())
            m_document.list(key, items);
    }

    static RecipeBody startOf(const Body& body)
    {
        return {.kind = body.kind, .velocity = body.velocity, .angularVelocity = body.angularVelocity};
    }

    std::string regionText(BodyId body, const MaterialRegion& region)
    {
        RecipeMaterialRegion words{m_words.place(body, region.objects),
                                   m_words.material(region.material, m_scene.bodies[body].material)};
        words.name = m_regions.add(region.name, "region");
        words.body = m_names.body(body);
        return textOf(words);
    }

    void putWorld()
    {
        if (m_scene.touching != Touching::separate)
            m_document.put("touching", quoted(wordFor(m_scene.touching, touchingWords())));
        if (m_scene.gravity != Vec3::Zero())
            m_document.put("gravity_m_s2", listText(m_scene.gravity, exactText));
        if (m_scene.floorHeight)
            m_document.put("floor",
                           textOf(RecipeFloor{*m_scene.floorHeight, m_scene.floorFriction, m_scene.floorAdhesion}));
        m_document.put("integrator", quoted(wordFor(m_scene.integrator, integratorWords())));
        m_document.put("refilling", m_scene.refilling ? "true" : "false");
        if (m_scene.vicinity != VicinityMethod::uniformGrid)
            m_document.put("vicinity", quoted(wordFor(m_scene.vicinity, vicinityWords())));
        if (m_scene.timeStep)
            m_document.put("time_step_s", exactText(*m_scene.timeStep));
        if (m_scene.massScalingTimeStep)
            m_document.put("mass_scaling_time_step_s", exactText(*m_scene.massScalingTimeStep));
    }

    void putTools()
    {
        std::vector<std::string> fixtures;
        for (const Fixture& fixture : m_scene.fixtures)
            fixtures.push_back(textOf(m_words.fixture(fixture)));
        putUnlessEmpty("fixtures", fixtures);
        std::vector<std::string> loads;
        for (const Load& load : m_scene.loads)
            loads.push_back(textOf(m_words.load(load)));
        putUnlessEmpty("loads", loads);
        std::vector<std::string> manipulators;
        for (const Manipulator& manipulator : m_scene.manipulators)
            manipulators.push_back(textOf(m_words.manipulator(manipulator)));
        putUnlessEmpty("manipulators", manipulators);
    }

    std::vector<std::string> events()
    {
        const History history(m_project.entries, m_project.current, std::numeric_limits<std::size_t>::max());
        const std::uint32_t start = history.record(m_project.current).start;
        std::vector<RecipeGesture> gestures;
        bool isAnyBefore = false;
        for (const History::Entry entry : history.pathTo(m_project.current)) {
            const HistoryRecord& record = history.record(entry);
            isAnyBefore =
                isAnyBefore || (record.start != start && std::ranges::any_of(record.commands, changesAnything));
            if (entry != 0 && record.start != history.record(record.parent).start)
                gestures.clear();
            if (record.start == start)
                gestures.push_back({record.name, record.commands});
        }
        if (isAnyBefore)
            m_remarks.push_back(Message("Recipe", "The recipe begins where the part was filled last; what was done "
                                                  "before left nothing behind but tools, materials and fixtures."));
        return eventTexts(m_words, gestures);
    }

    const Project& m_project;
    const RecipeOfProjectChoices& m_choices;
    const ProjectStart& m_start;
    const Scene& m_scene;
    const Model& m_model;
    RecipeNames m_names;
    RecipeWords m_words;
    PageText m_document;
    UniqueNames m_regions;
    std::vector<Message> m_remarks;
};

/// Whatever is out of the ranges of recipes is found by reading.
void readBack(const std::string& text, const RecipeOfProjectChoices& choices,
              const std::vector<MaterialPreset>& presets)
{
    readRecipeText(text, choices.recipePath.empty() ? "recipe" : choices.recipePath, presets);
}

} // namespace

RecipeOfProject recipeOfProject(const Project& project, const RecipeOfProjectChoices& choices,
                                const std::vector<MaterialPreset>& presets)
{
    if (project.model == nullptr || project.starts.empty() || project.entries.empty())
        throw Problem(Message("Recipe", "The project has nothing in it yet that a recipe could say."));
    try {
        RecipeOfProject recipe = Writer(project, choices, presets).write();
        readBack(recipe.text, choices, presets);
        return recipe;
    } catch (const std::runtime_error& error) {
        throw Problem(Message("Recipe", "A recipe cannot say what was done here: %1").with(messageOf(error)));
    }
}

} // namespace knead
