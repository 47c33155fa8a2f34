#include "io/formats/step/step_check.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string_view>
#include <vector>

namespace knead {

namespace {

constexpr int deepestParentheses = 500; // honest files stay under 10; the reader recurses once a level
constexpr std::size_t longestString = 65'536;
constexpr std::size_t longestWord = 64;
constexpr std::size_t blockLength = 1U << 20U;

bool isWordCharacter(unsigned char c)
{
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '#' || c == '.' || c == '+';
}

bool isNoNumber(std::string_view word)
{
    static constexpr std::array<std::string_view, 4> names{"NAN", "INF", "INFINITY", "IND"};
    if (word.starts_with('-') || word.starts_with('+'))
        word.remove_prefix(1);
    return word.find(".#") != std::string_view::npos || std::find(names.begin(), names.end(), word) != names.end();
}

/// A pass over the text that knows strings, comments and lists, and nothing of their meaning.
class Scanner {
public:
    explicit Scanner(const std::string& path)
        : m_path(path)
    {
    }

    void scan(std::string_view block)
    {
        for (const char character : block)
            take(character);
    }

    /// Called at the end of the file.
    StepCheck result()
    {
        endWord();
        if (m_inString)
            failReading(m_path, Message("Step", "the STEP file ends inside a text; it is cut off, get it again."));
        if (!m_ended)
            failReading(
                m_path,
                Message("Step",
                        "the STEP file ends before its last line (END-ISO-10303-21); it is cut off, get it again."));
        if (!m_hasData)
            failReading(m_path, Message("Step", "the STEP file has no DATA section, so it holds no shapes."));
        return {protocolOf(m_schema), m_schema};
    }

private:
    static std::string protocolOf(const std::string& schema)
    {
        struct Entry {
            std::string_view schema;
            const char* protocol;
        };
        static constexpr std::array entries{
            Entry{"AUTOMOTIVE_DESIGN", "AP214"},
            Entry{"CONFIG_CONTROL_DESIGN", "AP203"},
            Entry{"CONFIG_CONTROL_3D_DESIGN", "AP203e2"},
            Entry{"AP203_CONFIGURATION_CONTROLLED_3D_DESIGN", "AP203e2"},
            Entry{"AP242_MANAGED_MODEL_BASED_3D_ENGINEERING", "AP242"},
            Entry{"INTEGRATED_CNC_SCHEMA", "AP238"},
        };
        for (const Entry& entry : entries)
            if (schema.starts_with(entry.schema))
                return entry.protocol;
        return {};
    }

    void take(char character)
    {
        if (m_inString)
            return takeInString(character);
        if (m_inComment) {
            m_inComment = !(m_last == '*' && character == '/');
            m_last = character;
            return;
        }
        if (m_last == '/' && character == '*') {
            m_inComment = true;
            m_last = '\0';
            return;
        }
        m_last = character;
        if (isWordCharacter(static_cast<unsigned char>(character))) {
            if (m_word.size() < longestWord)
                m_word += static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
            return;
        }
        endWord();
        takeMark(character);
    }

    void takeInString(char character)
    {
        if (character == '\'') {
            m_inString = false;
            m_wantsSchema = m_wantsSchema && m_schema.empty();
            return;
        }
        if (m_wantsSchema && m_schema.size() < longestWord)
            m_schema += static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
        if (++m_stringLength > longestString)
            failReading(
                m_path,
                Message("Step", "a name in the STEP file is longer than 65 thousand letters; the file is damaged."));
    }

    void takeMark(char mark)
    {
        if (mark == '\'') {
            m_inString = true;
            m_stringLength = 0;
        } else if (mark == '(' && ++m_depth > deepestParentheses) {
            failReading(m_path,
                        Message("Step", "lists in the STEP file are nested more than 500 deep; the file is damaged."));
        } else if (mark == ')') {
            --m_depth;
        } else if (mark == ';') {
            m_depth = 0;
            m_wantsSchema = false;
        }
    }

    void endWord()
    {
        if (m_word.empty())
            return;
        if (m_word == "FILE_SCHEMA")
            m_wantsSchema = true;
        else if (m_word == "DATA" && m_depth == 0)
            m_hasData = true;
        else if (m_word == "END-ISO-10303-21")
            m_ended = true;
        else if (m_hasData && m_depth > 0 && isNoNumber(m_word))
            failReading(
                m_path,
                Message("Step", "the STEP file has \"%1\" in place of a number; export it again.").with(m_word));
        m_word.clear();
    }

    const std::string& m_path;
    std::string m_word;
    std::string m_schema;
    std::size_t m_stringLength = 0;
    int m_depth = 0;
    char m_last = '\0';
    bool m_inString = false;
    bool m_inComment = false;
    bool m_wantsSchema = false;
    bool m_hasData = false;
    bool m_ended = false;
};

} // namespace

StepCheck checkStepText(const std::string& path, TaskControl& control)
{
    std::ifstream file(path, std::ios::binary);
    Scanner scanner(path);
    std::vector<char> block(blockLength);
    while (file) {
        control.throwIfCancelled();
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        scanner.scan({block.data(), static_cast<std::size_t>(file.gcount())});
    }
    if (!file.eof())
        failReading(path, Message("Import", "the file cannot be read; the disk or the connection to it failed."));
    return scanner.result();
}

} // namespace knead
