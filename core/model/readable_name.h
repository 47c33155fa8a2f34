#pragma once

#include <string>
#include <string_view>

namespace knead {

/// A name from a file made fit to show: valid UTF-8 on one line without control characters, at most 120 bytes.
/// Bytes that are no UTF-8 are taken as Latin-1, and letters that are the bytes of UTF-8 as that.
std::string readableName(std::string_view utf8);
std::string readableName(std::u16string_view utf16);

/// True for names that programs make up and no person knows by: empty, "NAUO12", "=>[0:1:1:2]", "17", "SOLID", "Body1",
/// "Open CASCADE STEP translator 7.5 1".
bool isGeneratedName(std::string_view name);

/// Names of instances such as "nut_1" say more than "nut", but many programs number them without meaning; then the product's
/// name is better, or else a fallback.
std::string bestPartName(const std::string& instance, const std::string& product, const std::string& fallback);

/// The name for a part that has none: that of its file without the ending, or "part".
std::string partNameFor(const std::string& path);

} // namespace knead
