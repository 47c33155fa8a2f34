#pragma once

#include <cstddef>
#include <cstdint>

namespace knead::fuzz {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on every machine, good ones from any seed. Compilers differ in
/// which argument of a call they evaluate first: let one of them at most ask for a number.
class Random {
public:
    explicit Random(std::uint64_t seed)
        : m_state(seed)
    {
    }

    std::uint64_t next()
    {
        std::uint64_t z = m_state += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    /// 0 .. count - 1; 0 for a count of 0.
    std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(next() % count); }

    bool chance(unsigned percent) { return below(100) < percent; }

    /// @pre the list is not empty
    template <typename List>
    auto& oneOf(List& list)
    {
        return list[below(list.size())];
    }

private:
    std::uint64_t m_state;
};

} // namespace knead::fuzz
