#pragma once

#include "core/simulation/command.h"
#include "core/simulation/snapshot.h"
#include "ui/document/content.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// CAD faces of a body that are held in place.
struct FaceFixture {
    std::uint32_t key = 0; ///< names the fixture as long as the document lives
    std::string name;      ///< unique; the name of the Fixture in the scene
    BodyId body = 0;
    std::vector<std::uint32_t> faces;
};

/// The fixtures a person made by picking faces, and how the simulation comes to have them. The simulation numbers its
/// own
/// fixtures, so changes are posted one set at a time, against what a snapshot shows.
class FaceFixtures {
public:
    const std::vector<FaceFixture>& list() const { return m_list; }
    const FaceFixture* find(std::uint32_t key) const;

    void clear();
    void remove(std::uint32_t key);
    /// Fixes a face, in the fixture `active` when that belongs to the same body, in a new one otherwise; or frees it.
    /// @return the fixture that now holds the face; 0 when it is free
    std::uint32_t toggle(BodyId body, std::uint32_t face, std::uint32_t active);

    /// The content was filled anew: the same faces hold other objects.
    void refilled();

    /// What to post so that the simulation gets these fixtures; empty when it has them, or is about to.
    std::vector<Command> changes(const Snapshot& now, const Content& content);

    /// The fixtures as the scene knows them. Those whose faces hold no object are left out.
    const std::vector<Fixture>& wanted(const Content& content);

private:
    void edited();

    std::vector<FaceFixture> m_list;
    std::uint32_t m_nextKey = 1;
    bool m_isWantedKnown = false;
    std::vector<Fixture> m_wanted;
    bool m_isPosted = false; ///< waiting for the simulation to take m_posted over
    std::vector<Fixture> m_posted;
};

} // namespace knead
