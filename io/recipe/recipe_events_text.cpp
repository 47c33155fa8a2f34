#include "io/recipe/recipe_events_text.h"

#include "io/json/exact_number.h"
#include "io/recipe/recipe_places.h"
#include "io/recipe/scene_words.h"

#include <algorithm>
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
        ObjectText text = event();
        text.put("material", m_words.material(command.material, m_words.start.scene.bodies.at(command.body).material));
        putBody(text, command.body, command.objects);
        finish(text);
    }
    void operator()(const SetBodyKind& command)
    {
        ObjectText change;
        change.text("body", m_words.names.body(command.body))
            .put("kind", quoted(wordFor(command.kind, bodyKindWords())));
        finish(event().put("body_kind", change.take()));
    }
    void operator()(const Renormalize& command)
    {
        ObjectText wanted;
        putBody(wanted, command.body, command.objects);
        if (command.duration != 0)
            wanted.number("duration_s", command.duration);
        finish(event().put("renormalize", wanted.take()));
    }
    void operator()(const SetGravity& command) { finish(event().numbers("gravity_m_s2", command.gravity)); }
    void operator()(const SetFloor& command)
    {
        ObjectText floor;
        if (command.height)
            floor.millimeters("height_mm", *command.height);
        floor.number("friction", command.friction);
        if (command.adhesion > 0)
            floor.number("adhesion_pa", command.adhesion);
        finish(event().put("floor", floor.take()));
    }
    void operator()(const AddManipulator& command)
    {
        finish(event().put("add_manipulator", m_words.manipulator(command.manipulator)));
    }
    void operator()(const RemoveManipulator& command)
    {
        finish(event().text("remove_manipulator", m_words.names.tool(command.tool)));
    }
    void operator()(const SetManipulatorMotion& command)
    {
        if (const auto* goTo = std::get_if<GoTo>(&command.motion))
            return addToPath(command.tool, goTo->target);
        ObjectText move;
        move.text("name", m_words.names.tool(command.tool));
        putMotion(move, command.motion);
        finish(event().put("move_manipulator", move.take()));
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
        finish(event().put("reshape_manipulator", m_words.reshaping(form, m_words.names.tool(command.tool)).take()));
    }
    void operator()(const PlaceManipulator& command)
    {
        ObjectText place;
        place.text("name", m_words.names.tool(command.tool));
        putPose(place, command.pose);
        finish(event().put("place_manipulator", place.take()));
    }
    void operator()(const AddFixture& command)
    {
        finish(event().put("add_fixture", m_words.fixture(command.fixture, m_objectsInBody)));
    }
    void operator()(const RemoveFixture& command)
    {
        finish(event().text("remove_fixture", m_words.names.fixture(command.fixture)));
    }
    void operator()(const MoveFixture& command)
    {
        ObjectText move;
        move.text("name", m_words.names.fixture(command.fixture)).millimeters("velocity_mm_s", command.velocity);
        putTurn(move, command.turn);
        finish(event().put("move_fixture", move.take()));
    }
    void operator()(const AddLoad& command) { finish(event().put("add_load", m_words.load(command.load))); }
    void operator()(const RemoveLoad& command)
    {
        finish(event().text("remove_load", m_words.names.load(command.load)));
    }
    void operator()(const SetLoad& command)
    {
        ObjectText change;
        change.text("name", m_words.names.load(command.load));
        putAmount(change, command.amount, command.ramp);
        finish(event().put("change_load", change.take()));
    }
    void operator()(const SetIntegrator& command)
    {
        finish(event().put("integrator", quoted(wordFor(command.integrator, integratorWords()))));
    }
    void operator()(const SetPace& command) { finish(event().put("pace", quoted(wordFor(command.pace, paceWords())))); }
    void operator()(const FindBalance& command) { finish(event().number("find_balance_s", command.duration)); }
    void operator()(const Refill& command)
    {
        ObjectText wanted;
        putBody(wanted, command.body, {});
        if (command.spacing != 0)
            wanted.put("spacing_mm", exactThousandfold(command.spacing));
        finish(event().put("refill", wanted.take()));
    }
    void operator()(const Cut& command)
    {
        ObjectText plane;
        putBody(plane, command.body, {});
        plane.millimeters("point_mm", command.point).numbers("normal", command.normal);
        finish(event().put("cut", plane.take()));
    }
    void operator()(const Reset&) { finish(event().put("reset", "true")); }
    // Names and colors of parts are those of the file, and tools and fixtures keep the names that they begin with.
    void operator()(const SetPartLook&) {}
    void operator()(const RenameManipulator&) {}
    void operator()(const RenameFixture&) {}
    void operator()(const KeepMoment&) { finish(event().text("keep_moment", m_isLast ? m_name : std::string())); }

private:
    ObjectText event() const { return ObjectText().put("step", std::to_string(m_step)); }

    void finish(const ObjectText& text)
    {
        endPath();
        m_texts.push_back(text.take());
    }

    void addToPath(ToolId tool, const Pose& target)
    {
        if (!m_path || m_pathTool != tool) {
            endPath();
            m_path = std::make_unique<PathText>(m_words.names.tool(tool), m_step);
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

    void putBody(ObjectText& text, BodyId body, const std::vector<ObjectIndex>& objects) const
    {
        text.text("body", m_words.names.body(body));
        if (!objects.empty() && m_objectsInBody > 0)
            putLaterObjects(text, m_objectsInBody, objects);
        else if (!objects.empty())
            putObjects(text, m_words.aggregateOf(body), objects);
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
