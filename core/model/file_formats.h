#pragma once

#include "core/message/message.h"

#include <string>
#include <vector>

namespace knead {

enum class FormatKind { Step, Iges, Brep, Stl, Obj, Ply, Gltf, ThreeMf, Vtp };

/// A format that parts are written in, and most that they are read from. What all layers know of it; io/formats reads and writes.
struct FileFormat {
    enum class Text { always, asAsked, never };

    FormatKind kind;
    std::string name;                       ///< "STEP"
    std::vector<std::string> endings;       ///< in lower case; a new file gets the first
    std::vector<std::string> moreEndings{}; ///< of files that are read and not written
    Text text = Text::always;
    bool isRead = true;
    bool isSmooth = false;    ///< holds trimmed faces, not triangles
    bool takesAp214 = false;  ///< in place of AP242
    bool isInMetres = false;  ///< whatever one wishes
    bool holdsFields = false; ///< numbers at vertices

    std::vector<std::string> endingsRead() const;
};

/// All there are, in the order of menus and sentences: smooth faces first.
inline const std::vector<FileFormat> fileFormats{
    {.kind = FormatKind::Step,
     .name = "STEP",
     .endings = {"step", "stp"},
     .moreEndings = {"p21"},
     .isSmooth = true,
     .takesAp214 = true},
    {.kind = FormatKind::Iges, .name = "IGES", .endings = {"iges", "igs"}, .isSmooth = true},
    {.kind = FormatKind::Brep, .name = "BREP", .endings = {"brep", "brp"}, .isSmooth = true},
    {.kind = FormatKind::Stl, .name = "STL", .endings = {"stl"}, .text = FileFormat::Text::asAsked},
    {.kind = FormatKind::Obj, .name = "OBJ", .endings = {"obj"}},
    {.kind = FormatKind::Ply, .name = "PLY", .endings = {"ply"}, .text = FileFormat::Text::asAsked},
    {.kind = FormatKind::Gltf, .name = "glTF", .endings = {"glb", "gltf"}, .isInMetres = true},
    {.kind = FormatKind::ThreeMf, .name = "3MF", .endings = {"3mf"}, .text = FileFormat::Text::never},
    {.kind = FormatKind::Vtp, .name = "VTP", .endings = {"vtp"}, .isRead = false, .holdsFields = true},
};

const FileFormat& formatOf(FormatKind kind);

/// The format that the ending of a file to write means; null for any other.
const FileFormat* formatToWrite(const std::string& path);

/// Whether a file is called like those of a format.
bool isNamedAs(FormatKind kind, const std::string& path);

/// Whether the ending of a file to write means a picture, which all can be drawn in that holds triangles.
bool isPicture(const std::string& path);

/// "step" for "/home/ann/bracket.STEP"; empty when there is none.
std::string lowerCaseEnding(const std::string& path);

using WhichFormats = bool (*)(const FileFormat&);

/// "STEP, IGES or STL", for sentences; without more being said, those that are read.
std::string formatNames(
    const std::string& beforeLast, WhichFormats which = [](const FileFormat& f) { return f.isRead; });

/// The same for sentences in any language.
Message formatList(WhichFormats which);
/// The endings likewise.
Message endingList(WhichFormats which);

/// ".step, .stp and .stl": the endings of files to write; without more being said, of all formats.
std::string formatEndings(
    const std::string& beforeLast, WhichFormats which = [](const FileFormat&) { return true; });

} // namespace knead
