#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace knead::fuzz {

/// A file for those who read files, in memory where the system has a place for that.
class ScratchFile {
public:
    explicit ScratchFile(const std::string& name)
    {
        namespace fs = std::filesystem;
        const fs::path folder = fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path();
        m_path = folder / ("knead-fuzz-" + std::to_string(getpid()) + "-" + name);
    }
    ~ScratchFile()
    {
        std::error_code ignored;
        std::filesystem::remove(m_path, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// @return its path
    std::string with(std::string_view bytes) const
    {
        std::ofstream(m_path, std::ios::binary | std::ios::trunc) << bytes;
        return m_path.string();
    }

private:
    std::filesystem::path m_path;
};

} // namespace knead::fuzz
