#include "io/recipe/recipe_text.h"

#include "core/message/message.h"
#include "io/json/exact_number.h"
#include "io/recipe/recipe_events.h"
#include "io/recipe/recipe_objects.h"
#include "io/recipe/recipe_tools.h"
#include "io/recipe/recipe_words.h"

namespace knead {

namespace {

using namespace recipe_keys;

class RecipeWriter {
public:
    RecipeWriter(const Recipe& recipe, const std::string& path, const std::vector<MaterialPreset>& presets)
        : m_recipe(recipe)
        , m_path(path)
        , m_context{presets, path}
    {
    }

    std::string write()
    {
        m_document.put("version", "1");
        putPart();
        putMaterials();
        putBodies();
        putWorld();
        putList("fixtures", m_recipe.fixtures);
        putList("loads", m_recipe.loads);
        putTools();
        putList("probes", m_recipe.probes);
        putEvents();
        putDuration();
        putExports();
        return m_document.take();
    }

private:
    template <class Value>
    std::string textOf(const Value& value) const
    {
        return Object<Value>{m_context}.text(value);
    }

    template <class Value>
    void putList(const char* key, const std::vector<Value>& values)
    {
        std::vector<std::string> texts;
        for (const Value& value : values)
            texts.push_back(textOf(value));
        if (!texts.empty())
            m_document.list(key, texts);
    }

    /// An object whose keys are the names of bodies.
    template <class Items, class NameOf, class TextOf>
    void putByName(const char* key, const Items& items, NameOf nameOf, TextOf textOf)
    {
        ObjectText object;
        for (const auto& item : items) {
            const std::string name = quoted(nameOf(item));
            object.put(name.substr(1, name.size() - 2), textOf(item));
        }
        if (!object.isEmpty())
            m_document.put(key, object.take());
    }

    void putPart()
    {
        if (!m_recipe.extraParts.empty())
            throw Problem(Message("Recipe", "parts beside the first that were placed cannot be written."));
        PartFiles part{.files = {fileSeenFrom(m_path, m_recipe.part)},
                       .import = m_recipe.import,
                       .fillsOpenParts = m_recipe.fillsOpenParts};
        for (const std::string& file : m_recipe.partsBeside)
            part.files.push_back(fileSeenFrom(m_path, file));
        m_document.put("part", textOf(part));
        using Kind = SpacingChoice::Kind;
        const SpacingChoice& spacing = m_recipe.spacing;
        switch (spacing.kind) {
        case Kind::Length:
            m_document.put("spacing_mm", exactThousandfold(spacing.value));
            break;
        case Kind::CellsAlong:
            m_document.put("cells_across", exactText(spacing.value));
            break;
        case Kind::CellsAcrossWall:
            m_document.put("cells_across_wall", exactText(spacing.value));
            break;
        case Kind::Objects:
            m_document.put("objects", exactText(spacing.value));
            break;
        }
        if (m_recipe.arrangement == Arrangement::published)
            m_document.put("arrangement", quoted("published"));
    }

    std::string materialText(const Material& material, const Material& base) const
    {
        return MaterialWords{m_context}.text(materialWords(material, base, m_context.presets));
    }

    void putMaterials()
    {
        m_document.put("material", materialText(m_recipe.material, Material{}));
        putByName(
            "body_materials", m_recipe.bodyMaterials, [](const auto& body) { return body.first; },
            [&](const auto& body) { return materialText(body.second, m_recipe.material); });
        putList("regions", m_recipe.regions);
    }

    void putBodies()
    {
        putByName(
            "bodies", m_recipe.bodies, [](const RecipeBody& body) { return body.name; },
            [&](const RecipeBody& body) { return textOf(body); });
        if (m_recipe.structuralFriction != 0)
            m_document.put("structural_friction", exactText(m_recipe.structuralFriction));
    }

    void putWorld()
    {
        if (m_recipe.touching != Touching::separate)
            m_document.put("touching", quoted(wordFor(m_recipe.touching, touchingWords())));
        if (m_recipe.gravity != Vec3::Zero())
            m_document.put("gravity_m_s2", listText(m_recipe.gravity, exactText));
        if (m_recipe.floor)
            m_document.put("floor", textOf(*m_recipe.floor));
        if (m_recipe.vicinity != VicinityMethod::uniformGrid)
            m_document.put("vicinity", quoted(wordFor(m_recipe.vicinity, vicinityWords())));
        m_document.put("refilling", m_recipe.refilling ? "true" : "false");
        if (m_recipe.analysis == Analysis::equilibrium) {
            m_document.put("analysis", quoted("static")).put("load_steps", std::to_string(m_recipe.loadSteps));
            return;
        }
        m_document.put("integrator", quoted(wordFor(m_recipe.integrator, integratorWords())));
        if (m_recipe.timeStep)
            m_document.put("time_step_s", exactText(*m_recipe.timeStep));
        if (m_recipe.massScalingTimeStep)
            m_document.put("mass_scaling_time_step_s", exactText(*m_recipe.massScalingTimeStep));
    }

    /// With the file of an imported part as the recipe names it.
    RecipeManipulator withFile(RecipeManipulator tool) const
    {
        if (tool.kind == ToolKind::part)
            tool.partFile = fileSeenFrom(m_path, tool.partFile);
        return tool;
    }

    void putTools()
    {
        std::vector<RecipeManipulator> tools;
        for (const RecipeManipulator& tool : m_recipe.manipulators)
            tools.push_back(withFile(tool));
        putList("manipulators", tools);
    }

    void putEvents()
    {
        std::vector<std::string> texts;
        for (const RecipeEvent& event : m_recipe.events) {
            ObjectText text;
            event.step ? text.put("step", std::to_string(*event.step)) : text.put("time_s", exactText(event.time));
            RecipeAction action = event.action;
            if (auto* add = std::get_if<AddRecipeManipulator>(&action))
                add->manipulator = withFile(add->manipulator);
            if (auto* reshape = std::get_if<ReshapeRecipeManipulator>(&action))
                reshape->manipulator = withFile(reshape->manipulator);
            putAction(text, action, m_context);
            texts.push_back(text.take());
        }
        if (!texts.empty())
            m_document.list("events", texts);
    }

    void putDuration()
    {
        if (m_recipe.durationSteps)
            m_document.put("duration_steps", std::to_string(*m_recipe.durationSteps));
        else
            m_document.put("duration_s", exactText(m_recipe.duration));
    }

    void putExports()
    {
        std::vector<std::string> texts;
        for (const RecipeExport& wanted : m_recipe.exports) {
            if (wanted.isPicture())
                throw Problem(Message("Recipe", "pictures to write cannot be written into a recipe."));
            texts.push_back(ObjectText().text("file", wanted.file).take());
        }
        if (!texts.empty())
            m_document.list("exports", texts);
    }

    const Recipe& m_recipe;
    const std::string& m_path;
    Context m_context;
    PageText m_document;
};

} // namespace

std::string recipeText(const Recipe& recipe, const std::string& recipePath, const std::vector<MaterialPreset>& presets)
{
    return RecipeWriter(recipe, recipePath, presets).write();
}

} // namespace knead
