#include "core/model/file_formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace knead {

namespace {

bool isAmong(const std::vector<std::string>& endings, const std::string& path)
{
    return std::ranges::find(endings, lowerCaseEnding(path)) != endings.end();
}

/// "a, b and c".
std::string enumerated(const std::vector<std::string>& items, const std::string& beforeLast)
{
    std::string words;
    for (std::size_t i = 0; i < items.size(); ++i)
        words += (i == 0 ? "" : i + 1 < items.size() ? ", " : beforeLast) + items[i];
    return words;
}

std::vector<std::string> namesOf(WhichFormats which)
{
    std::vector<std::string> names;
    for (const FileFormat& format : fileFormats)
        if (which(format))
            names.push_back(format.name);
    return names;
}

std::vector<std::string> endingsOf(WhichFormats which)
{
    std::vector<std::string> endings;
    for (const FileFormat& format : fileFormats)
        if (which(format))
            for (const std::string& ending : format.endings)
                endings.push_back("." + ending);
    return endings;
}

/// @param items at least two
Message listOf(std::vector<std::string> items)
{
    const std::string last = items.back();
    items.pop_back();
    return Message("File", "%1 and %2").with(enumerated(items, ", "), last);
}

} // namespace

std::vector<std::string> FileFormat::endingsRead() const
{
    std::vector<std::string> all = endings;
    all.insert(all.end(), moreEndings.begin(), moreEndings.end());
    return all;
}

const FileFormat& formatOf(FormatKind kind)
{
    return *std::ranges::find(fileFormats, kind, &FileFormat::kind);
}

const FileFormat* formatToWrite(const std::string& path)
{
    const auto found =
        std::ranges::find_if(fileFormats, [&](const FileFormat& format) { return isAmong(format.endings, path); });
    return found != fileFormats.end() ? &*found : nullptr;
}

bool isNamedAs(FormatKind kind, const std::string& path)
{
    return isAmong(formatOf(kind).endingsRead(), path);
}

bool isPicture(const std::string& path)
{
    return lowerCaseEnding(path) == "png";
}

std::string lowerCaseEnding(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    if (!ending.empty())
        ending.erase(0, 1);
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

std::string formatNames(const std::string& beforeLast, WhichFormats which)
{
    return enumerated(namesOf(which), beforeLast);
}

std::string formatEndings(const std::string& beforeLast, WhichFormats which)
{
    return enumerated(endingsOf(which), beforeLast);
}

Message formatList(WhichFormats which)
{
    return listOf(namesOf(which));
}

Message endingList(WhichFormats which)
{
    return listOf(endingsOf(which));
}

} // namespace knead
