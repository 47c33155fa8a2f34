#pragma once

#include "core/message/message.h"

#include <string>
#include <vector>

namespace knead {

/// A format that displacements at nodes are read from. What all layers know of it; io/fields reads.
struct FieldFormat {
    Message name;                     ///< "CalculiX results", for dialogs
    std::vector<std::string> endings; ///< in lower case
    bool isMeshOnly = false;          ///< holds nodes and cells, and no displacements
};

/// All there are, in the order of menus.
const std::vector<FieldFormat>& fieldFormats();

/// Whether the ending is one of a format with displacements. Whether there are some shows when it is read.
bool isFieldFile(const std::string& path);

/// Whether the ending is one of any of the formats.
bool isNodalMeshFile(const std::string& path);

/// Whether a file is called like one of triangles: a scan of a part, which is a field by how far it is from that.
bool isScanFile(const std::string& path);

// FieldFile::format of what is no file of another program.
inline constexpr const char* scanFormat = "scan";
inline constexpr const char* projectFormat = "Knead project";

/// ".frd, .vtu ... and .rpt": the endings of formats with displacements, for sentences in any language.
Message fieldEndingList();

} // namespace knead
