#include "core/mechanics/contact_pairs.h"

#include <algorithm>

namespace knead {

std::vector<ContactPair> findPairs(const ContactObjects& objects, const Joints& joints, Vicinity& vicinity,
                                   double margin)
{
    const std::vector<VicinityPair> near = objects.findPairs(vicinity, margin);
    std::vector<ContactPair> pairs;
    pairs.reserve(near.size());
    for (const VicinityPair& pair : near) {
        const ContactObject& first = objects[pair.first];
        const ContactObject& second = objects[pair.second];
        pairs.push_back({.objects = pair,
                         .nominalLength = first.radius + second.radius,
                         .parameters = objects.between(first, second)});
        noteJoint(pairs.back(), objects, joints);
    }
    return pairs;
}

void noteJoint(ContactPair& pair, const ContactObjects& objects, const Joints& joints)
{
    const Joint* joint = joints.find(objects[pair.objects.first].ref, objects[pair.objects.second].ref);
    pair.joined = joint != nullptr;
    pair.healed = joint != nullptr && joint->healed;
}

std::vector<ContactPair> merged(const std::vector<ContactPair>& first, const std::vector<ContactPair>& second)
{
    std::vector<ContactPair> all;
    std::set_union(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(all));
    return all;
}

std::vector<ContactPair>::iterator findPair(std::vector<ContactPair>& sorted, const VicinityPair& objects)
{
    const auto found = std::ranges::lower_bound(sorted, objects, {}, &ContactPair::objects);
    return found != sorted.end() && found->objects == objects ? found : sorted.end();
}

bool KeptLengths::forgetThoseApart(const ContactObjects& objects)
{
    return std::erase_if(m_pairs, [&](const ContactPair& pair) {
               return objects.distance(pair.objects) >=
                      objects[pair.objects.first].radius + objects[pair.objects.second].radius;
           }) > 0;
}

void KeptLengths::giveTo(std::vector<ContactPair>& pairs, const ContactObjects& objects) const
{
    auto kept = m_pairs.begin();
    for (ContactPair& pair : pairs) {
        while (kept != m_pairs.end() && kept->objects < pair.objects)
            ++kept;
        // Radii may have become smaller since: what is apart now meets again where its spheres do.
        if (kept != m_pairs.end() && kept->objects == pair.objects)
            pair.nominalLength = objects.distance(pair.objects) < pair.nominalLength
                                     ? kept->nominalLength
                                     : std::min(kept->nominalLength, pair.nominalLength);
    }
}

} // namespace knead
