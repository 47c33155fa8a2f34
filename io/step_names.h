#pragma once

#include <string>

class STEPControl_Reader;

namespace knead {

/// The reader takes the name of an instance for empty when no letter of it is ASCII ("螺栓"). Gives such names an ASCII
/// mark before shapes are made of the file; withoutNameMark() takes it off again.
void markForeignNames(const STEPControl_Reader& reader);

std::string withoutNameMark(std::string name);

} // namespace knead
