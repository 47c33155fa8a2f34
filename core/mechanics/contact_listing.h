#pragma once

#include "core/mechanics/contact_pairs.h"

#include <vector>

namespace knead {

/// When candidates for contacts must be listed again. They are listed with a margin, and how far things have moved
/// towards each other since uses that up. A body that nothing else is near may move and turn as a whole without that.
class ContactListing {
public:
    explicit ContactListing(std::span<const ContactBody> bodies);

    double reach() const { return m_margin + m_ahead; }                  ///< candidates are listed up to here [m]
    double reachOfSurfaces() const { return m_surfaceMargin + m_ahead; } ///< the same of points near surfaces [m]
    std::size_t count() const { return m_count; }                        ///< of listings of pairs, so far

    /// Steps of the implicit scheme bring together what is further apart: they list it earlier.
    void setScheme(std::span<const ContactBody> bodies, bool isImplicit);

    void invalidate() { m_valid = false; } ///< all is due

    /// @param travel how far the fastest object may have moved since the last call [m] @param surfaceTravel the same
    /// for surfaces [m]
    void move(double travel, double surfaceTravel);

    /// Whether pairs are due. Looks closer where much of the margin seems used up; what has parted meanwhile forgets
    /// its length.
    bool arePairsDue(const ContactObjects& objects, KeptLengths& kept);
    void listedPairs(const ContactObjects& objects);

    /// How far ahead points near surfaces are listed next: where those that do not touch take little, in explicit steps, as far as
    /// things have gone in some hundred of them.
    void lookAhead(bool takesLittle);

    /// Whether what is near surfaces is due. @param surfaces how many there are @pre pairs are listed
    bool areSurfacesDue(std::size_t surfaces) const;
    void listedSurfaces(std::size_t surfaces);

    void end() { m_valid = true; } ///< all that was due is listed

private:
    double travelTowardsOthers(const ContactObjects& objects) const;
    double wantedSurfaceMargin() const;

    double m_margin = 0;               ///< [m]
    double m_surfaceMargin = 0;        ///< with which what is near surfaces was listed [m]
    double m_mostSurfaceMargin = 0;    ///< that it may be listed with [m]
    double m_ahead = 0;                ///< candidates are listed so much earlier than they can touch [m]
    std::vector<Vec3> m_listedAt;      ///< per contact object: its place when pairs were listed [m]
    double m_travel = 0;               ///< of objects towards each other since then, at most [m]
    double m_travelToSurfaces = 0;     ///< of objects and surfaces since those were listed, at most [m]
    std::size_t m_surfaceCount = 0;    ///< when those were listed
    std::size_t m_stepsToSurfaces = 0; ///< since then
    std::size_t m_count = 0;
    bool m_isImplicit = false;
    bool m_valid = false;
};

} // namespace knead
