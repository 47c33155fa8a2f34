#pragma once

#include <cstddef>
#include <string_view>

namespace knead::model_format {

// What those who write and read the bytes of model_file.h agree on.

inline constexpr std::string_view modelMark = "KNEADMDL1\n";
inline constexpr std::string_view previewMark = "KNEADPRV1\n";
inline constexpr std::string_view failureMark = "KNEADERR1\n";
inline constexpr std::size_t headerSize = 32; // mark, length of the JSON document; arrays start at multiples of 8

inline std::size_t aligned(std::size_t size)
{
    constexpr std::size_t alignment = 8;
    return (size + alignment - 1) / alignment * alignment;
}

} // namespace knead::model_format
