#pragma once

#include "core/deformation/displacement_field.h"
#include "core/message/message.h"
#include "core/session/filled_model.h"
#include "core/session/frame.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// What a session did to one body.
struct BodyField {
    BodyId body = 0;
    std::string name;
    DisplacementField field; ///< rest places in the opened part, and how far they went since [m]
};

/// What a session did to all bodies, as fields that go on to other parts.
struct SessionField {
    std::vector<BodyField> bodies;
    std::vector<Message> leftOut; ///< sentences: what fields cannot say
};

/// u(X) = x(X) - X at the vertices X of the surfaces of the opened parts, about a spacing apart, and at the objects inside of their first
/// fillings; x is the map that exports are made with, through all fillings. Of a body that has come apart it is the largest piece, and
/// cracks are left out: a field cannot tear. Any thread; 100,000 places a second.
/// @param content as it is filled there
/// @throws Cancelled
SessionField sessionField(const FilledModel& content, const Frame& frame, TaskControl& control);

/// Those of all bodies as one. Where two have a node in the same place, it is one, in the middle of where these went.
DisplacementField joinedField(const SessionField& session);

} // namespace knead
