#pragma once

#include "io/fields/field_content.h"

#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// A file that a ParaView collection names.
struct PvdFile {
    std::string time; ///< as it stands there
    std::string path; ///< whole, with the folder of the collection
};

/// The files of a collection in its order. @throws Problem, when there are none
std::vector<PvdFile> filesOfCollection(std::string_view bytes, const std::string& path);

/// Which of them are read: those at the time that is chosen, which become one.
/// @param content gets the steps and which one it is. @throws Problem, when there are not as many steps
std::vector<PvdFile> filesAtStep(const std::vector<PvdFile>& files, const FieldChoice& choice, FieldContent& content);

/// Appends what another file of the same step holds.
void append(FieldContent& content, FieldContent&& more);

} // namespace knead
