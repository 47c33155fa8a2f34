#pragma once

class IGESCAFControl_Reader;

namespace knead {

/// Takes out of groups (type 402) and subfigures (type 308) what another entity is made of, and out of groups what an earlier
/// one has. Some programs list in a group a solid, its shell, its faces, and the surfaces that these are cut out of; the
/// reader would make shapes of each. Call it between reading and making shapes.
void keepMembersOnce(IGESCAFControl_Reader& reader);

} // namespace knead
