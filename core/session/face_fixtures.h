#pragma once

#include "core/session/face_fixture.h"
#include "core/session/filled_model.h"
#include "core/simulation/command.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// The fixtures that a person made by picking faces. The simulation knows of objects only, so faces are remembered here, also
/// of fixtures that are gone: going back to a moment shows them again.
///
/// Every edit says what to post. The simulation numbers fixtures in the order in which it gets them, so all commands must be
/// told, see posted().
class FaceFixtures {
public:
    const std::vector<FaceFixture>& list() const { return m_list; }
    const FaceFixture* find(std::uint32_t key) const;

    void clear();

    struct Edit {
        std::uint32_t key = 0; ///< of the fixture that now holds the face; 0 when it is free
        std::vector<Command> commands;
    };
    /// Fixes a face, in the fixture `active` when that belongs to the same body, in a new one otherwise; or frees it.
    Edit toggle(const FilledModel& content, BodyId body, std::uint32_t face, std::uint32_t active);
    /// A new fixture of faces of a body, or of objects that no faces are known of.
    Edit add(const FilledModel& content, BodyId body, std::vector<std::uint32_t> faces);
    Edit addObjects(BodyId body, std::vector<ObjectIndex> objects);
    std::vector<Command> remove(std::uint32_t key);
    std::vector<Command> rename(std::uint32_t key, const std::string& name);

    /// A command goes to the simulation.
    void posted(const Command& command);

    /// The simulation is at another moment, or begins: these are the fixtures there.
    /// @param held by their ids; none where one was removed
    void follow(const FilledModel& content, std::span<const std::optional<Fixture>> held);
    /// Whether these are the fixtures, by their ids, and so many there were.
    bool agree(std::span<const FixtureId> ids, FixtureId count) const;

    const std::vector<FaceFixture>& known() const { return m_known; } ///< every one that there was, without ids
    /// Faces that a fixture holds, or will hold. Its id does not matter.
    void keepInMind(const FaceFixture& fixture);

private:
    std::vector<Command> hold(const FilledModel& content, FaceFixture& fixture);
    FaceFixture faceFixtureOf(const FilledModel& content, const Fixture& held) const;

    std::vector<FaceFixture> m_list;
    std::vector<FaceFixture> m_known; ///< every one that there was, without ids
    FixtureId m_nextId = 0;           ///< of the next fixture that the simulation gets
};

/// The fixtures as a scene knows them. Those whose faces hold no object are left out.
std::vector<Fixture> sceneFixtures(const FilledModel& content, const std::vector<FaceFixture>& fixtures);

} // namespace knead
