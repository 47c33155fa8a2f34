#pragma once

#include "core/message/message.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace knead {

static_assert(std::endian::native == std::endian::little, "files hold arrays as they lie in memory, lowest byte first");

/// Blocks of bytes, each behind its length.
class BlockWriter {
public:
    void add(std::string_view block)
    {
        const std::uint64_t length = block.size();
        m_bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
        m_bytes.append(block);
    }

    template <typename Element>
    void add(const std::vector<Element>& elements)
    {
        add(std::string_view(reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)));
    }

    std::string bytes() && { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// Reads what BlockWriter wrote; never beyond the end.
class BlockReader {
public:
    /// @param what it is, for messages: "export job"
    BlockReader(std::string_view bytes, const char* what)
        : m_bytes(bytes)
        , m_what(what)
    {
    }

    /// @throws Problem, for the developer
    [[noreturn]] void fail(const char* saying) const
    {
        throw Problem(Message::verbatim(std::string(m_what) + ": " + saying));
    }

    /// @throws as fail(), when it is cut off
    std::string_view next()
    {
        std::uint64_t length = 0;
        if (m_bytes.size() < sizeof length)
            fail("it is cut off");
        std::memcpy(&length, m_bytes.data(), sizeof length);
        m_bytes.remove_prefix(sizeof length);
        if (length > m_bytes.size())
            fail("it is cut off");
        const std::string_view block = m_bytes.substr(0, length);
        m_bytes.remove_prefix(length);
        return block;
    }

    template <typename Element>
    std::vector<Element> nextArray()
    {
        const std::string_view block = next();
        if (block.size() % sizeof(Element) != 0)
            fail("it is cut off");
        std::vector<Element> elements(block.size() / sizeof(Element));
        if (!elements.empty())
            std::memcpy(static_cast<void*>(elements.data()), block.data(), block.size());
        return elements;
    }

private:
    std::string_view m_bytes;
    const char* m_what;
};

} // namespace knead
