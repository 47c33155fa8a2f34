#include "core/simulation/governor.h"

#include <cmath>

namespace knead {

namespace {

constexpr double memory = 0.25;  // in which a mean forgets [s]
constexpr double patience = 0.5; // before it gives way [s]
constexpr double easeTime = 2;   // that a finer pace must have been affordable for [s]
// What a finer pace costs more at most, measured from 9,000 to 30,000 objects: 1.4 to 1.8 times.
constexpr double finerCost = 2;

} // namespace

void Governor::forget()
{
    *this = {};
}

std::optional<Pace> Governor::see(double cost, double seconds, Pace present)
{
    const double share = m_watched > 0 ? -std::expm1(-seconds / memory) : 1;
    m_cost += share * (cost - m_cost);
    m_watched += seconds;
    m_easy = finerCost * m_cost < 1 ? m_easy + seconds : 0;
    std::optional<Pace> other;
    if (present == Pace::exact) // somebody wants it so
        return {};
    if (m_cost > 1 && m_watched > patience && present != Pace::wide)
        other = present == Pace::full ? Pace::rough : Pace::wide;
    else if (m_easy > easeTime && present != Pace::full)
        other = present == Pace::wide ? Pace::rough : Pace::full;
    if (other)
        forget();
    return other;
}

} // namespace knead
