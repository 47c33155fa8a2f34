#include "io/formats/foreign_content.h"

#include "core/model/file_formats.h"
#include "core/model/readable_name.h"
#include "io/files/lower_case.h"
#include "io/formats/threemf/zip_archive.h"

#include <algorithm>
#include <array>
#include <vector>

namespace knead {

namespace {

struct Signature {
    std::size_t place; ///< of the bytes in the file
    std::string_view bytes;
    Message sentence;
};

std::optional<Message> matching(std::string_view head)
{
    using namespace std::string_view_literals;
    static const std::array signatures{
        Signature{0, "\x1F\x8B"sv, Message("Import", "this is a gzip archive; unpack it and open the file inside.")},
        Signature{0, "BZh"sv, Message("Import", "this is a bzip2 archive; unpack it and open the file inside.")},
        Signature{0, "7z\xBC\xAF\x27\x1C"sv,
                  Message("Import", "this is a 7z archive; unpack it and open the file inside.")},
        Signature{0,
                  "\xFD"
                  "7zXZ\0"sv,
                  Message("Import", "this is an xz archive; unpack it and open the file inside.")},
        Signature{0, "\x28\xB5\x2F\xFD"sv,
                  Message("Import", "this is a zstd archive; unpack it and open the file inside.")},
        Signature{0, "Rar!\x1A\x07"sv, Message("Import", "this is a rar archive; unpack it and open the file inside.")},
        Signature{257, "ustar"sv, Message("Import", "this is a tar archive; unpack it and open the file inside.")},
        Signature{0, "\xFF\xFE"sv,
                  Message("Import", "the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again.")},
        Signature{0, "\xFE\xFF"sv,
                  Message("Import", "the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again.")},
        Signature{0, "%PDF"sv, Message("Import", "this is a PDF document; ask for the STEP file of the part.")},
        Signature{0, "\x89PNG"sv, Message("Import", "this is a picture; ask for the STEP file of the part.")},
        Signature{0, "\xFF\xD8\xFF"sv, Message("Import", "this is a picture; ask for the STEP file of the part.")},
        Signature{0, "GIF8"sv, Message("Import", "this is a picture; ask for the STEP file of the part.")},
        Signature{0, "SQLite format 3"sv, Message("Import", "this is a database, not a CAD or mesh file.")},
        Signature{0, "\xD0\xCF\x11\xE0"sv,
                  Message("Import", "this is a native file of another program; export it as STEP there.")},
        Signature{0, "AC10"sv, Message("Import", "this is an AutoCAD drawing (DWG); export the part as STEP there.")},
        Signature{0,
                  "\x7F"
                  "ELF"sv,
                  Message("Import", "this is a program, not a CAD or mesh file.")},
    };
    for (const Signature& signature : signatures)
        if (head.size() > signature.place && head.substr(signature.place).starts_with(signature.bytes))
            return signature.sentence;
    return std::nullopt;
}

std::optional<Message> markup(std::string_view head)
{
    std::string_view text = head.starts_with("\xEF\xBB\xBF") ? head.substr(3) : head;
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with('<'))
        return std::nullopt;
    const std::string lower = lowerCase(std::string(text));
    if (lower.starts_with("<!doctype html") || lower.starts_with("<html"))
        return Message("Import", "this is a web page, not a CAD file; the download may have failed.");
    if (lower.find("10303-28") != std::string::npos || lower.find("iso_10303_28") != std::string::npos ||
        lower.find("iso10303") != std::string::npos || lower.find("<n0:uos") != std::string::npos)
        return Message(
            "Import",
            "this is STEP as XML (part 28, stpx), which is not read here; export the part as STEP text (stp).");
    return Message("Import",
                   "this is an XML text and not one of the files that are read here; export the part as STEP.");
}

bool anyStartsWith(const std::vector<ZipEntry>& files, std::string_view start)
{
    return std::ranges::any_of(files, [&](const ZipEntry& file) { return file.name.starts_with(start); });
}

} // namespace

std::optional<Message> foreignContent(std::string_view head)
{
    if (const auto sentence = matching(head))
        return sentence;
    return markup(head);
}

ZipContent zipContent(const std::string& path)
{
    const auto files = zipEntries(path);
    if (!files)
        return {false, Message("Import", "this is a zip archive that is cut off or damaged; get it again.")};
    // A 3MF is known by its model; which file that is, its relations say, but all programs call it the same.
    const auto isModel = [](const ZipEntry& file) { return lowerCase(file.name).ends_with(".model"); };
    if (std::ranges::any_of(*files, isModel))
        return {true, {}};
    struct Kind {
        std::string_view start;
        Message sentence;
    };
    static const std::array kinds{
        Kind{"word/", Message("Import", "this is a Word document; ask for the STEP file of the part.")},
        Kind{"xl/", Message("Import", "this is an Excel workbook; ask for the STEP file of the part.")},
        Kind{"ppt/", Message("Import", "this is a PowerPoint presentation; ask for the STEP file of the part.")},
        Kind{"Document.xml", Message("Import", "this is a FreeCAD document; export the part as STEP there.")},
    };
    for (const Kind& kind : kinds)
        if (anyStartsWith(*files, kind.start))
            return {false, kind.sentence};
    if (files->size() == 1 && isNamedAs(FormatKind::Step, files->front().name))
        return {
            false,
            Message("Import",
                    "this is a zip archive that holds \"%1\" (compressed STEP, stpz); unpack it and open that file.")
                .with(readableName(std::string_view(files->front().name)))};
    return {false, Message("Import", "this is a zip archive; unpack it and open the file inside.")};
}

} // namespace knead
