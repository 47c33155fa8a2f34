#include "io/formats/xml_events.h"

#include <expat.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>

namespace knead {

namespace {

constexpr int deepestElement = 64;
constexpr char behindSpace = '\x1F'; // between the address of a namespace and a name; XML cannot say it

/// The address and the name.
std::pair<std::string_view, std::string_view> xmlNameParts(std::string_view name)
{
    const std::size_t place = name.rfind(behindSpace);
    if (place == name.npos)
        return {{}, name};
    return {name.substr(0, place), name.substr(place + 1)};
}

} // namespace

std::optional<std::string_view> XmlElement::attribute(std::string_view wanted, std::string_view wantedSpace) const
{
    for (const char* const* at = attributes; *at != nullptr; at += 2)
        if (xmlNameParts(*at) == std::pair(wantedSpace, wanted))
            return at[1];
    return std::nullopt;
}

void XmlEvents::Closer::operator()(XML_ParserStruct* parser) const
{
    XML_ParserFree(parser);
}

/// What expat calls. It is written in C, through which nothing is thrown.
struct XmlEvents::Callbacks {
    template <typename Work>
    static void guard(void* events, Work work)
    {
        XmlEvents& self = *static_cast<XmlEvents*>(events);
        if (self.m_thrown)
            return;
        try {
            work(self);
        } catch (...) {
            self.m_thrown = std::current_exception();
            XML_StopParser(self.m_parser.get(), XML_FALSE);
        }
    }

    static void space(void* events, const char* prefix, const char* address)
    {
        guard(events, [&](XmlEvents& self) {
            self.m_listener.space(prefix != nullptr ? prefix : "", address != nullptr ? address : "");
        });
    }

    static void begin(void* events, const char* name, const char** attributes)
    {
        guard(events, [&](XmlEvents& self) {
            if (++self.m_depth > deepestElement)
                throw BrokenXml();
            const auto [space, local] = xmlNameParts(name);
            self.m_listener.begin({space, local, attributes});
        });
    }

    static void end(void* events, const char*)
    {
        guard(events, [](XmlEvents& self) {
            --self.m_depth;
            self.m_listener.end();
        });
    }

    static void documentType(void* events, const char*, const char*, const char*, int)
    {
        guard(events, [](XmlEvents&) { throw BrokenXml(); });
    }
};

XmlEvents::XmlEvents(XmlListener& listener)
    : m_listener(listener)
    , m_parser(XML_ParserCreateNS(nullptr, behindSpace))
{
    if (!m_parser)
        throw std::bad_alloc();
    XML_SetUserData(m_parser.get(), this);
    XML_SetStartNamespaceDeclHandler(m_parser.get(), Callbacks::space);
    XML_SetElementHandler(m_parser.get(), Callbacks::begin, Callbacks::end);
    XML_SetStartDoctypeDeclHandler(m_parser.get(), Callbacks::documentType);
}

void XmlEvents::take(std::string_view bytes)
{
    constexpr std::size_t most = std::numeric_limits<int>::max() / 2;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size())))
        parse(bytes.substr(0, most), false);
}

void XmlEvents::finish()
{
    parse({}, true);
}

void XmlEvents::parse(std::string_view bytes, bool isLast)
{
    const XML_Status status = XML_Parse(m_parser.get(), bytes.data(), static_cast<int>(bytes.size()), isLast ? 1 : 0);
    if (m_thrown)
        std::rethrow_exception(m_thrown);
    if (status != XML_STATUS_OK && XML_GetErrorCode(m_parser.get()) == XML_ERROR_NO_MEMORY)
        throw std::bad_alloc();
    if (status != XML_STATUS_OK)
        throw BrokenXml();
}

} // namespace knead
