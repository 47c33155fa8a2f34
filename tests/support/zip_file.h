#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// The bytes of a zip archive with these files in it, not compressed.
inline std::string zipOf(const std::vector<std::pair<std::string, std::string>>& files)
{
    const auto number = [](std::uint32_t value, int length) {
        std::string bytes;
        for (int i = 0; i < length; ++i)
            bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
        return bytes;
    };
    const auto checksum = [](const std::string& bytes) { // CRC-32 as in ISO 3309
        std::uint32_t sum = 0xFFFFFFFFU;
        for (const unsigned char byte : bytes) {
            sum ^= byte;
            for (int bit = 0; bit < 8; ++bit)
                sum = (sum >> 1U) ^ (0xEDB88320U & (0U - (sum & 1U)));
        }
        return ~sum;
    };
    std::string archive;
    std::string directory;
    for (const auto& [name, content] : files) {
        const auto size = static_cast<std::uint32_t>(content.size());
        const std::string common = number(20, 2) + number(0, 2) + number(0, 2) + number(0, 4) +
                                   number(checksum(content), 4) + number(size, 4) + number(size, 4) +
                                   number(static_cast<std::uint32_t>(name.size()), 2) + number(0, 2);
        directory += "PK\x01\x02" + number(20, 2) + common + number(0, 2) + number(0, 2) + number(0, 2) + number(0, 4) +
                     number(static_cast<std::uint32_t>(archive.size()), 4) + name;
        archive += "PK\x03\x04" + common + name + content;
    }
    const auto count = static_cast<std::uint32_t>(files.size());
    return archive + directory + "PK\x05\x06" + number(0, 4) + number(count, 2) + number(count, 2) +
           number(static_cast<std::uint32_t>(directory.size()), 4) +
           number(static_cast<std::uint32_t>(archive.size()), 4) + number(0, 2);
}

} // namespace knead
