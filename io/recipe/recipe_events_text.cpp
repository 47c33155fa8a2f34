#include "io/recipe/recipe_events_text.h"

#include "io/json/exact_number.h"
#include "io/recipe/recipe_events.h"
#include "io/recipe/recipe_places.h"

#include <memory>

namespace knead {

namespace {

constexpr std::size_t pathLineLength = 110;

/// The way of a tool from place to place.
class PathText {
public:
    PathText(const std::string& name, std::uint64_t step)
        : m_name(name)
        , m_step(step)
    {
    }

    void add(std::uint64_t step, const Pose& target)
    {
        std::string row = '[' + std::to_string(step - m_step);
        for (const double coordinate : target.position)
            row += ", " + exactThousandfold(coordinate);
        const Quaternion& turn = target.rotation;
        if (turn.coeffs() != m_rotation.coeffs())
            for (const double number : {turn.w(), turn.x(), turn.y(), turn.z()})
                row += ", " + exactText(number);
        m_rotation = turn;
        append(row + ']');
    }

    std::string take() const
    {
        ObjectText move;
        move.text("name", m_name).put("path", "[\n" + m_rows + m_line + "\n    ]");
        return ObjectText().put("step", std::to_string(m_step)).put("move_manipulator", move.take()).take();
    }

private:
    void append(const std::string& row)
    {
        if (m_line.empty()) {
            m_line = "      " + row;
        } else if (m_line.size() + row.size() < pathLineLength) {
            m_line += ", " + row;
        } else {
            m_rows += m_line + ",\n";
            m_line = "      " + row;
        }
    }

    std::string m_name;
    std::uint64_t m_step;
    Quaternion m_rotation = Quaternion::Identity();
    std::string m_rows; ///< whole lines
    std::string m_line;
};

class EventWriter {
public:
    explicit EventWriter(const RecipeWords& words)
        : m_words(words)
    {
    }

    void add(const RecipeGesture& gesture)
    {
        for (const RecordedCommand& recorded : gesture.commands) {
            m_step = recorded.step;
            m_objectsInBody = recorded.objectsInBody;
            m_isLast = &recorded == &gesture.commands.back();
            m_name = gesture.name;
            std::visit(*this, recorded.command);
        }
    }

    std::vector<std::string> take()
    {
        endPath();
        return std::move(m_texts);
    }

    void operator()(const SetMaterial& command)
    {
        ChangeMaterial change;
        setWhere(change, command.body, command.objects);
        change.material = m_words.material(command.material, m_words.start.scene.bodies.at(command.body).material);
        put(change);
    }
    void operator()(const SetBodyKind& command) { put(ChangeBodyKind{bodyName(command.body), command.kind}); }
    void operator()(const Renormalize& command)
    {
        RenormalizeBodies action;
        setWhere(action, command.body, command.objects);
        action.duration = command.duration;
        put(action);
    }
    void operator()(const SetGravity& command) { put(ChangeGravity{command.gravity}); }
    void operator()(const SetFloor& command) { put(ChangeFloor{command.height, command.friction, command.adhesion}); }
    void operator()(const AddManipulator& command)
    {
        put(AddRecipeManipulator{m_words.manipulator(command.manipulator)});
    }
    void operator()(const RemoveManipulator& command) { put(TakeManipulatorAway{toolName(command.tool)}); }
    void operator()(const SetManipulatorMotion& command)
    {
        if (const auto* goTo = std::get_if<GoTo>(&command.motion))
            addToPath(command.tool, goTo->target);
        else
            put(MoveRecipeManipulator{toolName(command.tool), command.motion});
    }
    void operator()(const ReshapeManipulator& command)
    {
        const Manipulator form{.size = command.size,
                               .friction = command.friction,
                               .speedLimit = command.speedLimit,
                               .forceLimit = command.forceLimit,
                               .kind = command.kind,
                               .part = command.part,
                               .adhesion = command.adhesion,
                               .rollsFreely = command.rollsFreely};
        put(ReshapeRecipeManipulator{m_words.named(form, toolName(command.tool))});
    }
    void operator()(const PlaceManipulator& command)
    {
        put(PlaceRecipeManipulator{toolName(command.tool), command.pose});
    }
    void operator()(const AddFixture& command)
    {
        put(AddRecipeFixture{m_words.fixture(command.fixture, m_objectsInBody)});
    }
    void operator()(const RemoveFixture& command) { put(ReleaseFixture{m_words.names.fixtures.at(command.fixture)}); }
    void operator()(const MoveFixture& command)
    {
        put(MoveRecipeFixture{m_words.names.fixtures.at(command.fixture), command.velocity, command.turn});
    }
    void operator()(const AddLoad& command) { put(AddRecipeLoad{m_words.load(command.load)}); }
    void operator()(const RemoveLoad& command) { put(TakeLoadAway{m_words.names.loads.at(command.load)}); }
    void operator()(const SetLoad& command)
    {
        put(ChangeRecipeLoad{m_words.names.loads.at(command.load), command.amount, command.ramp});
    }
    void operator()(const SetIntegrator& command) { put(ChangeIntegrator{command.integrator}); }
    void operator()(const SetPace& command) { put(ChangePace{command.pace}); }
    void operator()(const FindBalance& command) { put(SettleScene{command.duration}); }
    void operator()(const Refill& command) { put(RefillBodies{bodyName(command.body), command.spacing}); }
    void operator()(const Cut& command) { put(CutBodies{bodyName(command.body), command.point, command.normal}); }
    void operator()(const Reset&) { put(StartAgain{}); }
    // Names and colors of parts are those of the file, and tools and fixtures keep the names that they begin with.
    void operator()(const SetPartLook&) {}
    void operator()(const RenameManipulator&) {}
    void operator()(const RenameFixture&) {}
    void operator()(const KeepMoment&) { put(MarkMoment{m_isLast ? m_name : std::string()}); }

private:
    const std::string& bodyName(BodyId body) const { return m_words.names.body(body); }
    const std::string& toolName(ToolId tool) const { return m_words.names.tools.at(tool); }

    void put(const RecipeAction& action)
    {
        endPath();
        ObjectText event;
        event.put("step", std::to_string(m_step));
        recipe_keys::putAction(event, action, m_words.context);
        m_texts.push_back(event.take());
    }

    void addToPath(ToolId tool, const Pose& target)
    {
        if (!m_path || m_pathTool != tool) {
            endPath();
            m_path = std::make_unique<PathText>(toolName(tool), m_step);
            m_pathTool = tool;
        }
        m_path->add(m_step, target);
    }

    void endPath()
    {
        if (m_path)
            m_texts.push_back(m_path->take());
        m_path.reset();
    }

    /// All of a body where no objects are named.
    template <class Where>
    void setWhere(Where& where, BodyId body, const std::vector<ObjectIndex>& objects) const
    {
        where.body = bodyName(body);
        if (objects.empty())
            return;
        const RecipeRegion place = m_objectsInBody > 0 ? laterPlaceOf(m_objectsInBody, objects)
                                                       : placeOf(m_words.aggregateOf(body), nullptr, objects);
        where.box = place.box;
        where.objects = place.objects;
    }

    const RecipeWords& m_words;
    std::vector<std::string> m_texts;
    std::uint64_t m_step = 0;
    std::uint32_t m_objectsInBody = 0; ///< see RecordedCommand
    bool m_isLast = false;
    std::string m_name;
    std::unique_ptr<PathText> m_path; ///< under way
    ToolId m_pathTool = 0;
};

} // namespace

std::vector<std::string> eventTexts(const RecipeWords& words, std::span<const RecipeGesture> gestures)
{
    EventWriter writer(words);
    for (const RecipeGesture& gesture : gestures)
        writer.add(gesture);
    return writer.take();
}

} // namespace knead
