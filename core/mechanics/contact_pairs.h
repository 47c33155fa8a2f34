#pragma once

#include "core/mechanics/contact_objects.h"

#include <vector>

namespace knead {

/// Two objects that may touch, or do.
struct ContactPair {
    VicinityPair objects;     ///< their numbers in ContactObjects
    double nominalLength = 0; ///< [m]
    double pressed = 0;       ///< for how long now [s]
    bool joined = false;      ///< by a joint, which then acts in its place
    bool healed = false;      ///< and that joint is a healed one
    FrictionMemory friction;
    ContactParameters parameters;

    friend bool operator<(const ContactPair& a, const ContactPair& b) { return a.objects < b.objects; }
};

/// Pairs closer than the margin [m], sorted. They touch where their spheres meet; joints that they have are noted.
std::vector<ContactPair> findPairs(const ContactObjects& objects, const Joints& joints, Vicinity& vicinity,
                                   double margin);

/// Whether the objects have a joint now, to the pair.
void noteJoint(ContactPair& pair, const ContactObjects& objects, const Joints& joints);

/// All of two sorted lists, sorted; of those in both the first.
std::vector<ContactPair> merged(const std::vector<ContactPair>& first, const std::vector<ContactPair>& second);

/// The pair of two objects in a sorted list; its end when there is none.
std::vector<ContactPair>::iterator findPair(std::vector<ContactPair>& sorted, const VicinityPair& objects);

/// Pairs that keep a nominal length of their own: they overlapped before they could touch, and push only where they
/// get nearer.
class KeptLengths {
public:
    KeptLengths() = default;
    explicit KeptLengths(std::vector<ContactPair> sorted)
        : m_pairs(std::move(sorted))
    {
    }
    const std::vector<ContactPair>& all() const { return m_pairs; } ///< sorted

    /// The nominal lengths of these from now on. @param pairs sorted
    void keep(const std::vector<ContactPair>& pairs) { m_pairs = merged(pairs, m_pairs); }

    /// What was kept is forgotten once two are as far apart as contacts are. @return whether there was any
    bool forgetThoseApart(const ContactObjects& objects);

    /// Gives them to the pairs that have them. @param pairs sorted
    void giveTo(std::vector<ContactPair>& pairs, const ContactObjects& objects) const;

private:
    std::vector<ContactPair> m_pairs;
};

} // namespace knead
