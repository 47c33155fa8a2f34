#pragma once

#include "core/geometry/vec3.h"
#include "core/mechanics/vector_array.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace knead {

using Bytes = std::vector<std::byte>;

/// A number that tells whether bytes are what they were (FNV-1a over words of eight): for accidents, not against intent.
std::uint64_t checksumOf(std::span<const std::byte> bytes);

/// Writes values one after the other, least byte first on any machine. ByteReader reads them back in the same order, by the
/// same calls, so that one function can describe both.
class ByteWriter {
public:
    static constexpr bool isReader = false;

    template <typename Number>
    requires std::is_integral_v<Number>
    void operator()(const Number& value)
    {
        auto bits = static_cast<std::uint64_t>(value);
        for (std::size_t i = 0; i < sizeof value; ++i, bits >>= 8U)
            m_bytes.push_back(static_cast<std::byte>(bits));
    }
    template <typename Enum>
    void operator()(const Enum& value, Enum /*last*/)
    {
        (*this)(static_cast<std::underlying_type_t<Enum>>(value));
    }
    void operator()(const double& value);
    void operator()(const std::string& value);
    void operator()(const Vec3& value);
    void operator()(const Quaternion& value);

    /// Many numbers that go on evenly, as those of objects in rows do: by how much their bits are beside that, all first bytes
    /// before all second ones. That alone makes nothing smaller, but lets a compressor do so.
    void numbers(const LaneVector<double>& values, std::size_t count);
    void numbers(const VectorArray& values, std::size_t count);

    template <typename List, typename Each>
    void list(List& values, Each each)
    {
        (*this)(static_cast<std::uint32_t>(values.size()));
        for (auto& value : values)
            each(value);
    }

    template <typename List>
    void plainList(List& values)
    {
        list(values, [this](auto& value) { (*this)(value); });
    }

    template <typename Value, typename Each>
    void optional(Value& value, Each each)
    {
        (*this)(value.has_value());
        if (value)
            each(*value);
    }

    Bytes take() { return std::move(m_bytes); }

private:
    void planes(const double* values, std::size_t count);

    Bytes m_bytes;
};

/// What a stream writes from or reads to, so that one description serves both.
template <typename Stream, typename Value>
using Of = std::conditional_t<Stream::isReader, Value, const Value>;

/// The other way. Trusts no count: memory grows only with what is really there.
/// @throws Problem "it ends early" and the like
class ByteReader {
public:
    static constexpr bool isReader = true;

    explicit ByteReader(std::span<const std::byte> bytes)
        : m_rest(bytes)
    {
    }

    template <typename Number>
    requires std::is_integral_v<Number>
    void operator()(Number& value)
    {
        std::uint64_t bits = 0;
        const std::span<const std::byte> bytes = next(sizeof value);
        for (std::size_t i = 0; i < sizeof value; ++i)
            bits |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
        if constexpr (std::is_same_v<Number, bool>)
            requireTruth(bits);
        value = static_cast<Number>(bits);
    }

    /// @param last of the enumeration
    template <typename Enum>
    requires std::is_enum_v<Enum>
    void operator()(Enum& value, Enum last)
    {
        std::underlying_type_t<Enum> number{};
        (*this)(number);
        if (number > static_cast<std::underlying_type_t<Enum>>(last))
            failAtChoice();
        value = static_cast<Enum>(number);
    }
    void operator()(double& value);
    void operator()(std::string& value);
    void operator()(Vec3& value);
    void operator()(Quaternion& value);

    /// @param count how many there are, if any
    void numbers(LaneVector<double>& values, std::size_t count);
    void numbers(VectorArray& values, std::size_t count);

    template <typename List, typename Each>
    void list(List& values, Each each)
    {
        std::uint32_t count = 0;
        (*this)(count);
        values.clear();
        for (std::uint32_t i = 0; i < count; ++i)
            each(values.emplace_back());
    }

    template <typename List>
    void plainList(List& values)
    {
        list(values, [this](auto& value) { (*this)(value); });
    }

    template <typename Value, typename Each>
    void optional(std::optional<Value>& value, Each each)
    {
        bool has = false;
        (*this)(has);
        value.reset();
        if (has)
            each(value.emplace());
    }

    std::span<const std::byte> next(std::size_t count);
    bool atEnd() const { return m_rest.empty(); }

private:
    static void requireTruth(std::uint64_t bits);
    [[noreturn]] static void failAtChoice();
    bool hasNumbers();
    void planes(double* values, std::size_t count);

    std::span<const std::byte> m_rest;
};

} // namespace knead
