#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// A file in a zip archive, as the directory at its end lists it.
struct ZipEntry {
    std::string name;
    unsigned flags = 0;
    unsigned method = 0;        ///< of compression
    std::uint32_t checksum = 0; ///< CRC-32 of what is inside
    std::uint64_t packedSize = 0;
    std::uint64_t size = 0;  ///< of what is inside
    std::uint64_t begin = 0; ///< in the archive
};

/// The files in a zip archive (PKWARE's APPNOTE 6.3); the first thousand.
/// @return nothing when the directory is missing or damaged, as in an archive that is cut off
std::optional<std::vector<ZipEntry>> zipEntries(const std::string& path);

/// An archive is not what its directory says, or packed in a way that is not read.
struct DamagedZip {};

/// Hands on what is in a file of an archive, in pieces of up to a quarter of a megabyte, never more than the directory says.
/// @throws DamagedZip, also after some of it; and what `take` throws
void unpack(const std::string& path, const ZipEntry& entry, const std::function<void(std::string_view)>& take);

} // namespace knead
