#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace knead {

/// A tag of an XML text.
struct XmlTag {
    std::string_view name;
    std::string_view attributes; ///< as they are written
    bool isEnd = false;          ///< "</name>"
    bool isClosed = false;       ///< "<name/>"

    /// The value of an attribute, its entities resolved; empty where there is none.
    std::string attribute(std::string_view wanted) const;
};

/// Goes through the tags of an XML text, without checking that they match. Comments and declarations are passed over.
class XmlScanner {
public:
    /// @param text outlives this
    explicit XmlScanner(std::string_view text)
        : m_text(text)
    {
    }

    /// The next tag; none at the end, or where the text is cut off in the middle of one.
    std::optional<XmlTag> next();

    /// What stands up to the next "<".
    std::string_view textHere() const;
    /// All of the rest.
    std::string_view rest() const { return m_text.substr(m_at); }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
};

} // namespace knead
