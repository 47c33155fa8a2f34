#include "io/formats/vtp/base64_sink.h"

namespace knead {

void Base64Sink::write(std::string_view bytes)
{
    while (!m_rest.empty() && m_rest.size() < 3 && !bytes.empty()) {
        m_rest += bytes.front();
        bytes.remove_prefix(1);
    }
    if (m_rest.size() == 3) {
        encode(m_rest);
        m_rest.clear();
    }
    const std::size_t whole = bytes.size() / 3 * 3;
    encode(bytes.substr(0, whole));
    m_rest += bytes.substr(whole);
}

void Base64Sink::finish()
{
    if (m_rest.empty())
        return;
    const std::size_t missing = 3 - m_rest.size();
    m_rest.resize(3, '\0');
    encode(m_rest, missing);
    m_rest.clear();
}

void Base64Sink::encode(std::string_view triples, std::size_t padding)
{
    static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    m_text.clear();
    for (std::size_t i = 0; i < triples.size(); i += 3) {
        const auto byte = [&](std::size_t at) {
            return static_cast<unsigned>(static_cast<unsigned char>(triples[i + at]));
        };
        const unsigned bits = byte(0) << 16U | byte(1) << 8U | byte(2);
        for (const unsigned shift : {18U, 12U, 6U, 0U})
            m_text += letters[bits >> shift & 63U];
    }
    m_text.replace(m_text.size() - padding, padding, padding, '=');
    m_sink.write(m_text);
}

} // namespace knead
