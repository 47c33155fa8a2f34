#pragma once

#include "core/mechanics/contact_body.h"
#include "core/mechanics/point_spread.h"

#include <cmath>
#include <span>
#include <vector>

namespace knead {

/// Adds up the stiffness of all contacts that an object has at a time, which a time step must allow for.
class ContactCrowd {
public:
    void add(const ContactBody& body, std::uint32_t index, ObjectIndex object, double stiffness)
    {
        add(sumsOf(body, index), index, object, stiffness);
    }

    /// A bound on what a contact at a point adds to the modes of its objects.
    void add(const ContactBody& body, std::uint32_t index, const PointSpread& spread, double stiffness)
    {
        const double sum = spread.weightSum();
        std::vector<double>& sums = sumsOf(body, index);
        for (std::uint32_t n = 0; n < spread.count; ++n)
            add(sums, index, spread.objects[n], sum * std::abs(spread.weights[n]) * stiffness);
    }

    /// The largest stiffness of an object by that of one contact, of bodies that deform; all begin anew.
    double take(std::span<const ContactBody> bodies)
    {
        double largest = 0;
        for (const auto& [body, object] : m_touched) {
            if (bodies[body].kind == BodyKind::deformable)
                largest =
                    std::max(largest, m_stiffness[body][object] / bodies[body].connections->contactStiffness(object));
            m_stiffness[body][object] = 0;
        }
        m_touched.clear();
        return largest;
    }

private:
    struct Touched {
        std::uint32_t body;
        ObjectIndex object;
    };

    std::vector<double>& sumsOf(const ContactBody& body, std::uint32_t index)
    {
        if (m_stiffness.size() <= index)
            m_stiffness.resize(index + 1);
        std::vector<double>& sums = m_stiffness[index];
        if (sums.empty())
            sums.assign(body.state->size(), 0);
        return sums;
    }

    void add(std::vector<double>& sums, std::uint32_t index, ObjectIndex object, double stiffness)
    {
        if (sums[object] == 0 && stiffness > 0)
            m_touched.push_back({index, object});
        sums[object] += stiffness;
    }

    std::vector<std::vector<double>> m_stiffness; ///< per body and object [N/m]
    std::vector<Touched> m_touched;
};

} // namespace knead
