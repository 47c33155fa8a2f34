#include "io/formats/iges/iges_check.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/formats/iges/iges_entities.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t sectionColumn = 72; // S, G, D, P or T stands here, counted from 0
constexpr std::size_t dataColumns = 64;   // of a P line; then comes the number of its directory entry
constexpr int macroDefinition = 306;      // its parameters are statements, not values
constexpr double largestNumber = 1e100;   // far beyond what the modeler takes for infinite

/// Where the parameters of an entity say how many values follow.
struct CountPlace {
    int type;
    std::size_t place; // 0 is the type itself
};
constexpr std::array countPlaces{CountPlace{102, 1}, CountPlace{106, 2}, CountPlace{112, 4},
                                 CountPlace{126, 1}, CountPlace{128, 1}, CountPlace{128, 2},
                                 CountPlace{141, 4}, CountPlace{144, 3}, CountPlace{402, 1}};

std::string_view withoutBlanksAround(std::string_view text)
{
    const auto first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

template <typename Number>
std::optional<Number> numberIn(std::string_view text)
{
    text = withoutBlanksAround(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// A number as IGES writes it: 12, -1., 1.5E-3, 1.5D-3. Blanks inside do not count.
bool isNumber(std::string_view text)
{
    std::string plain;
    for (const char c : text)
        if (c != ' ')
            plain += c == 'D' || c == 'd' ? 'E' : c;
    const auto value = numberIn<double>(plain);
    return value && std::isfinite(*value) && std::abs(*value) < largestNumber;
}

class IgesCheck {
public:
    explicit IgesCheck(const std::string& path)
        : m_path(path)
        , m_entities(path)
    {
    }

    void take(std::string_view line)
    {
        if (m_lines['T'] > 0)
            return;
        if (line.size() <= sectionColumn || std::string_view("SGDPT").find(line[sectionColumn]) == line.npos)
            failReading(
                m_path,
                Message("Iges", "line %1 of the IGES file is not in 80 columns; the file is damaged, get it again.")
                    .with(m_lineNumber + 1));
        ++m_lineNumber;
        const char section = line[sectionColumn];
        ++m_lines[section];
        if (section == 'G')
            m_global += line.substr(0, sectionColumn);
        else if (section == 'D')
            m_entities.takeDirectoryLine(line);
        else if (section == 'P')
            takeParameters(line);
        else if (section == 'T')
            m_terminate = line.substr(0, sectionColumn);
    }

    void finish()
    {
        endRecord();
        if (m_lines['T'] == 0)
            failReading(m_path,
                        Message("Iges", "the IGES file ends before its last line (T); it is cut off, get it again."));
        for (std::size_t place = 0; place + 8 <= m_terminate.size(); place += 8)
            if (const auto stated = numberIn<int>(std::string_view(m_terminate).substr(place + 1, 7));
                stated && m_lines[m_terminate[place]] < *stated)
                failReading(m_path,
                            Message("Iges", "the IGES file lacks lines of its section %1; it is damaged, get it again.")
                                .with(std::string(1, m_terminate[place])));
        m_entities.finish();
    }

private:
    void takeParameters(std::string_view line)
    {
        if (m_lines['P'] == 1)
            readDelimiters();
        const auto entry = numberIn<int>(line.substr(dataColumns, sectionColumn - dataColumns));
        if (entry != m_entry)
            endRecord();
        m_entry = entry;
        m_record += line.substr(0, dataColumns);
    }

    /// The first two parameters of the global section, and that none of its texts is longer than itself.
    void readDelimiters()
    {
        std::string_view rest = m_global;
        if (rest.size() > 2 && rest.starts_with("1H")) {
            m_separator = rest[2];
            rest.remove_prefix(3);
        }
        if (rest.size() > 3 && rest[0] == m_separator && rest.substr(1).starts_with("1H"))
            m_end = rest[3];
        splitRecord(m_global);
    }

    void endRecord()
    {
        if (!m_record.empty()) {
            const std::vector<std::string_view> values = splitRecord(m_record);
            checkRecord(values);
            if (m_entry)
                m_entities.takeRecord(*m_entry, values);
        }
        m_record.clear();
    }

    /// The values of a record up to its end; what follows is a comment. Texts come out empty.
    std::vector<std::string_view> splitRecord(std::string_view record) const
    {
        std::vector<std::string_view> values;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < record.size(); ++i) {
            if (record[i] == 'H')
                if (const auto length = numberIn<long long>(record.substr(begin, i - begin))) {
                    if (*length < 0 || static_cast<unsigned long long>(*length) > record.size() - i - 1)
                        failReading(m_path, Message("Iges", "a text in the IGES file claims to be %1 letters long, "
                                                            "more than there are; the file is damaged.")
                                                .with(*length));
                    i += static_cast<std::size_t>(*length);
                    begin = i + 1;
                    continue;
                }
            if (record[i] != m_separator && record[i] != m_end)
                continue;
            values.push_back(withoutBlanksAround(record.substr(begin, i - begin)));
            begin = i + 1;
            if (record[i] == m_end)
                return values;
        }
        if (const std::string_view rest = withoutBlanksAround(record.substr(begin)); !rest.empty())
            values.push_back(rest); // the record lacks its end
        return values;
    }

    void checkRecord(const std::vector<std::string_view>& values) const
    {
        const int type = values.empty() ? 0 : numberIn<int>(values.front()).value_or(0);
        if (type == macroDefinition)
            return;
        for (const std::string_view value : values)
            if (!value.empty() && !isNumber(value))
                failReading(
                    m_path,
                    Message("Iges", "the IGES file has \"%1\" in place of a number; it is damaged, export it again.")
                        .with(printable(value)));
        for (const CountPlace& count : countPlaces)
            if (count.type == type && count.place < values.size())
                if (const auto stated = numberIn<long long>(values[count.place]);
                    stated && (*stated < 0 || static_cast<unsigned long long>(*stated) > values.size()))
                    failReading(
                        m_path,
                        Message(
                            "Iges",
                            "an entity of type %1 in the IGES file claims %2 values and has %3; the file is damaged.")
                            .with(type, *stated, values.size()));
    }

    static std::string printable(std::string_view value)
    {
        std::string text(value.substr(0, 20));
        std::replace_if(
            text.begin(), text.end(), [](unsigned char c) { return std::isprint(c) == 0; }, '?');
        return text;
    }

    const std::string& m_path;
    IgesEntities m_entities;
    std::map<char, int> m_lines; // per section
    int m_lineNumber = 0;
    std::string m_global;
    std::string m_terminate;
    std::string m_record;
    std::optional<int> m_entry;
    char m_separator = ',';
    char m_end = ';';
};

} // namespace

void checkIgesText(const std::string& path, TaskControl& control)
{
    std::ifstream file(path, std::ios::binary);
    IgesCheck check(path);
    int lines = 0;
    for (std::string line; std::getline(file, line);) {
        if (++lines % 10'000 == 0)
            control.throwIfCancelled();
        if (line.ends_with('\r'))
            line.pop_back();
        if (!line.empty())
            check.take(line);
    }
    check.finish();
}

} // namespace knead
