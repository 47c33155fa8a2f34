#pragma once

#include "io/files/byte_sink.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace knead {

/// Writes a zip archive (PKWARE's APPNOTE 6.3) from front to back. write() goes to the file that was begun last, compressed.
/// No file and no archive of more than 4 GB: what is larger throws std::length_error.
class ZipWriter final : public ByteSink {
public:
    explicit ZipWriter(ByteSink& sink);
    ~ZipWriter() override;
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// @param name in ASCII, with '/' between folders
    void beginFile(const std::string& name);
    void write(std::string_view bytes) override;

    /// Ends the last file and adds the list of all.
    void finish();

private:
    struct Entry {
        std::string name;
        std::uint64_t begin;
        std::uint64_t size;
        std::uint64_t packedSize;
        std::uint32_t checksum; ///< CRC-32
    };

    void endFile();
    void deflateAll(std::string_view bytes, bool isLast);
    void pass(std::string_view bytes);

    ByteSink& m_sink;
    std::uint64_t m_passed = 0;
    std::vector<Entry> m_entries;
    std::unique_ptr<z_stream_s> m_deflater; ///< none between files
    std::vector<unsigned char> m_packed;
};

} // namespace knead
