#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace knead {

/// Bytes that stand in a file as they are, or as base64 (RFC 4648) of which there may be several pieces, each padded.
class EncodedBytes {
public:
    /// @param text where they begin; outlives this
    EncodedBytes(std::string_view text, bool isBase64)
        : m_text(text)
        , m_isBase64(isBase64)
    {
    }

    /// The next ones. @throws Problem, when there are not as many
    std::string take(std::uint64_t count);

private:
    std::string takeDecoded(std::size_t count);
    void decodeFour();
    int nextLetter();

    std::string_view m_text;
    bool m_isBase64;
    std::string m_ahead; ///< decoded, and not taken yet
    bool m_isOver = false;
};

} // namespace knead
