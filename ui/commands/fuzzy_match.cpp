#include "ui/commands/fuzzy_match.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

namespace knead {

namespace {

constexpr int letterScore = 1;
constexpr int sideBySideScore = 9;
constexpr int wordScore = 8;  // at the beginning of a word
constexpr int startScore = 4; // of the text, on top of that
constexpr int impossible = std::numeric_limits<int>::min() / 2;

/// Without case and accent: "É" becomes "e".
QChar plain(QChar letter)
{
    const QString parts = letter.decomposition();
    return (parts.isEmpty() || letter.decompositionTag() != QChar::Canonical ? letter : parts.front()).toLower();
}

std::vector<QChar> plain(const QString& text)
{
    std::vector<QChar> letters(static_cast<std::size_t>(text.size()));
    std::ranges::transform(text, letters.begin(), [](QChar letter) { return plain(letter); });
    return letters;
}

std::vector<QChar> wanted(const QString& pattern)
{
    std::vector<QChar> letters = plain(pattern);
    std::erase_if(letters, [](QChar letter) { return letter.isSpace(); });
    return letters;
}

int scoreAt(const std::vector<QChar>& text, std::size_t place)
{
    if (place == 0)
        return letterScore + wordScore + startScore;
    return letterScore + (text[place - 1].isLetterOrNumber() ? 0 : wordScore);
}

/// best[p * width + t]: with letter p of the pattern at letter t of the text; the same for where the one before was.
struct Table {
    std::vector<int> best;
    std::vector<std::size_t> before;
    std::size_t width;
};

Table score(const std::vector<QChar>& pattern, const std::vector<QChar>& text)
{
    Table table{std::vector<int>(pattern.size() * text.size(), impossible),
                std::vector<std::size_t>(pattern.size() * text.size(), 0), text.size()};
    for (std::size_t p = 0; p < pattern.size(); ++p) {
        int leading = impossible; // best of the row above, up to two letters back
        std::size_t leader = 0;
        for (std::size_t t = p; t < text.size(); ++t) {
            const std::size_t here = p * table.width + t;
            if (p > 0 && t >= 2 && table.best[here - table.width - 2] > leading) {
                leading = table.best[here - table.width - 2];
                leader = t - 2;
            }
            if (pattern[p] != text[t])
                continue;
            const int adjoining = p > 0 && t > 0 ? table.best[here - table.width - 1] + sideBySideScore : impossible;
            const int until = p == 0 ? 0 : std::max(leading, adjoining);
            table.before[here] = adjoining >= leading && t > 0 ? t - 1 : leader;
            table.best[here] = until <= impossible / 2 ? impossible : until + scoreAt(text, t);
        }
    }
    return table;
}

} // namespace

std::optional<FuzzyMatch> fuzzyMatch(const QString& pattern, const QString& text)
{
    const std::vector<QChar> letters = wanted(pattern);
    if (letters.empty())
        return FuzzyMatch{};
    if (text.isEmpty())
        return std::nullopt;
    const Table table = score(letters, plain(text));
    const auto row = table.best.end() - static_cast<std::ptrdiff_t>(table.width);
    const auto end = std::max_element(row, table.best.end());
    if (*end <= impossible / 2)
        return std::nullopt;
    FuzzyMatch match{*end, {}};
    auto place = static_cast<std::size_t>(end - row);
    for (std::size_t p = letters.size(); p-- > 0; place = table.before[p * table.width + place])
        match.hits.prepend(static_cast<qsizetype>(place));
    match.score -= static_cast<int>(text.size()) / 8; // short texts say it better
    return match;
}

std::optional<FuzzyMatch> wordMatch(const QString& pattern, const QString& text)
{
    const std::vector<QChar> letters = plain(pattern.trimmed());
    const std::vector<QChar> all = plain(text);
    if (letters.empty())
        return std::nullopt;
    for (auto at = all.begin();; ++at) {
        at = std::search(at, all.end(), letters.begin(), letters.end());
        if (at == all.end())
            return std::nullopt;
        if (at != all.begin() && std::prev(at)->isLetterOrNumber())
            continue;
        const auto count = static_cast<int>(letters.size());
        const int start = at == all.begin() ? startScore : 0;
        FuzzyMatch match{count * letterScore + (count - 1) * sideBySideScore + wordScore + start, {}};
        for (int i = 0; i < count; ++i)
            match.hits << at - all.begin() + i;
        match.score -= static_cast<int>(text.size()) / 8;
        return match;
    }
}

} // namespace knead
