#pragma once

#include "io/files/byte_sink.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace knead {

/// Passes bytes on as base64 (RFC 4648).
class Base64Sink final : public ByteSink {
public:
    explicit Base64Sink(ByteSink& sink)
        : m_sink(sink)
    {
    }

    void write(std::string_view bytes) override;

    /// Passes on what is left, padded.
    void finish();

private:
    /// @param padding letters at the end that stand for no byte
    void encode(std::string_view triples, std::size_t padding = 0);

    ByteSink& m_sink;
    std::string m_rest; ///< up to two bytes that wait for a third
    std::string m_text;
};

} // namespace knead
