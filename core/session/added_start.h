#pragma once

#include "core/session/deformed_start.h"

#include <string>
#include <vector>

namespace knead {

/// Files whose parts come beside those that are worked on.
struct AdditionRequest {
    std::vector<std::string> paths; ///< at least one
    ImportOptions options;          ///< of all of them; none is moved by it
    Material material;              ///< of these parts
};

/// A content with the parts of other files.
struct PreparedAddition {
    PreparedDeformation done;       ///< its report is on parts that were kneaded
    std::size_t first = 0;          ///< of the new parts, which are the last ones
    std::vector<std::string> moved; ///< files whose parts had no room where they lay
    std::vector<Message> missing;   ///< what was not read, or is in doubt: sentences for the person
    std::vector<std::string> freed; ///< fixtures of objects whose part was kneaded: it has others now
};

/// Adds the parts of files to a content, as the next start of the work. Parts that were kneaded begin from the shape that a frame shows,
/// without stress, with exact faces where they had them. Materials of bodies, tools, gravity and fixtures on faces stay, and fixtures of
/// objects on parts that are as they were. New parts lie where their files have them, or where RoomForParts has room for them.
/// Runs on a task thread.
/// @param shown a frame of the content
/// @throws as prepareFiles() when nothing can be read, and prepareDeformation()
PreparedAddition prepareAddition(const FilledModel& before, const FramePointer& shown,
                                 const std::vector<FaceFixture>& fixtures, const AdditionRequest& request,
                                 const ImportFiles& import, const WriteAndRead& writeAndRead, TaskControl& control);

} // namespace knead
