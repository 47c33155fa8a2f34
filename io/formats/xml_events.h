#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string_view>

struct XML_ParserStruct;

namespace knead {

/// The beginning of an element of an XML text. Valid while it is told.
struct XmlElement {
    std::string_view space; ///< the address that its prefix stands for; empty: none
    std::string_view name;  ///< without prefix
    const char* const* attributes;

    /// The value of an attribute without a prefix, or with one that stands for an address.
    std::optional<std::string_view> attribute(std::string_view wanted, std::string_view wantedSpace = {}) const;
};

/// Is told what stands in an XML text. May throw; then no more is told.
class XmlListener {
public:
    virtual ~XmlListener() = default;
    /// From the next element on a prefix, or, where it is empty, the lack of one, stands for an address.
    virtual void space(std::string_view /*prefix*/, std::string_view /*address*/) {}
    virtual void begin(const XmlElement& element) = 0;
    virtual void end() = 0; ///< of the element that began last and has not ended
};

/// A text is no XML, declares entities, or is nested deeper than any file that is read here.
struct BrokenXml {};

/// Reads XML 1.0 with names of namespaces, piece by piece. Texts of strangers: a document type, which could declare entities, is
/// refused, nothing outside of the text is read, and nesting has an end.
class XmlEvents {
public:
    /// @param listener outlives this
    explicit XmlEvents(XmlListener& listener);

    /// The next bytes. @throws BrokenXml, and what the listener throws
    void take(std::string_view bytes);
    /// There are no more. @throws as take()
    void finish();

private:
    struct Closer {
        void operator()(XML_ParserStruct* parser) const;
    };
    struct Callbacks;

    void parse(std::string_view bytes, bool isLast);

    XmlListener& m_listener;
    std::unique_ptr<XML_ParserStruct, Closer> m_parser;
    int m_depth = 0;
    std::exception_ptr m_thrown;
};

} // namespace knead
