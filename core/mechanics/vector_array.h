#pragma once

#include "core/geometry/vec3.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <span>
#include <vector>

namespace knead {

/// Objects that the vector loops take at a time, whatever the width of the instructions.
inline constexpr std::size_t laneCount = 8;

/// Memory for vector loops: begins on a cache line, and a vector's width before its begin and after its end may be read and
/// written too. All of it starts as zeros, so that lanes that stand for no object compute with numbers.
template <typename T>
struct LaneAllocator {
    using value_type = T;
    static constexpr std::size_t slack = 64;
    static constexpr std::align_val_t alignment{64};

    LaneAllocator() = default;
    template <typename U>
    LaneAllocator(const LaneAllocator<U>& /*other*/)
    {
    }

    T* allocate(std::size_t count)
    {
        const std::size_t bytes = count * sizeof(T) + 2 * slack;
        auto* memory = static_cast<char*>(::operator new(bytes, alignment));
        std::fill_n(memory, bytes, '\0');
        return reinterpret_cast<T*>(memory + slack);
    }
    void deallocate(T* place, std::size_t /*count*/)
    {
        ::operator delete(reinterpret_cast<char*>(place) - slack, alignment);
    }
    friend bool operator==(const LaneAllocator&, const LaneAllocator&) { return true; }
};

template <typename T>
using LaneVector = std::vector<T, LaneAllocator<T>>;

/// A vector per object, stored by component so that loops over objects vectorize. Component c of object i is
/// data()[c * stride() + i]; each component begins on a cache line and has slack around it (see LaneAllocator).
template <typename T>
class VectorArrayOf {
public:
    VectorArrayOf() = default;
    explicit VectorArrayOf(std::size_t size) { resize(size); }
    explicit VectorArrayOf(std::span<const Vec3> vectors)
        : VectorArrayOf(vectors.size())
    {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            set(i, vectors[i]);
    }

    /// All vectors are zero afterwards.
    void resize(std::size_t size)
    {
        m_size = size;
        m_stride = strideFor(size);
        m_values.assign(3 * m_stride, 0);
    }
    void setZero() { std::fill(m_values.begin(), m_values.end(), T(0)); }

    std::size_t size() const { return m_size; }
    std::size_t stride() const { return m_stride; }
    T* data() { return m_values.data(); }
    const T* data() const { return m_values.data(); }
    T* component(std::size_t c) { return data() + c * m_stride; }
    const T* component(std::size_t c) const { return data() + c * m_stride; }

    Vec3 at(std::size_t i) const
    {
        const T* v = data() + i;
        return {v[0], v[m_stride], v[2 * m_stride]};
    }
    void set(std::size_t i, const Vec3& value)
    {
        T* v = data() + i;
        v[0] = static_cast<T>(value.x());
        v[m_stride] = static_cast<T>(value.y());
        v[2 * m_stride] = static_cast<T>(value.z());
    }
    void add(std::size_t i, const Vec3& value)
    {
        T* v = data() + i;
        v[0] += static_cast<T>(value.x());
        v[m_stride] += static_cast<T>(value.y());
        v[2 * m_stride] += static_cast<T>(value.z());
    }

    /// Whether all numbers have the same bits. Reading stops at the first that has not.
    bool hasSameBits(const VectorArrayOf& other) const
    {
        return m_size == other.m_size &&
               std::memcmp(m_values.data(), other.m_values.data(), m_values.size() * sizeof(T)) == 0;
    }

private:
    /// Whole cache lines, at least one of them slack; a third of a page beyond whole pages, since a load that follows a store
    /// to the same place in another page is taken for dependent on it.
    static std::size_t strideFor(std::size_t size)
    {
        constexpr std::size_t line = 64 / sizeof(T);
        constexpr std::size_t linesPerPage = 64;
        constexpr std::size_t third = 21;
        const std::size_t lines = (size + line - 1) / line + 1;
        const std::size_t wanted = lines + (third + linesPerPage - lines % linesPerPage) % linesPerPage;
        return line * (lines < 4 * linesPerPage ? lines : wanted);
    }

    LaneVector<T> m_values;
    std::size_t m_size = 0;
    std::size_t m_stride = 0;
};

using VectorArray = VectorArrayOf<double>;
using FloatArray = VectorArrayOf<float>; ///< of the linear solver

} // namespace knead
