#pragma once

#include "core/message/message.h"
#include <cstddef>
#include <map>
#include <set>

#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// How the entities of an IGES file refer to each other. The CAD reader trusts pointers of solids, swept surfaces and
/// splines, and the counts that they state; it crashes where these are wrong. Places and types are those of IGES 5.3.
class IgesEntities {
public:
    explicit IgesEntities(const std::string& path)
        : m_path(path)
    {
    }

    /// A line of the section D; all of them come before the first record.
    void takeDirectoryLine(std::string_view line);

    /// The values of the entity whose first directory line has this number. What is wrong with them is kept for finish():
    /// text that is plainly damaged is to be told first.
    void takeRecord(int entity, const std::vector<std::string_view>& values);

    /// @throws Problem, when an entity does not hold what its type must, holds itself, or names
    /// members of a list that are not there
    void finish() const;

private:
    using Record = std::vector<std::string_view>;
    using IsKind = bool (*)(int type);

    struct ListMember {
        long long list = 0;  ///< entity that is a list of vertices or edges
        long long index = 0; ///< from 1
        int user = 0;
    };

    void checkRecord(int entity, const Record& values);
    void takeTrimmedSurface(int entity, const Record& values);
    void takeSolid(int entity, const Record& values);
    void takeFace(int entity, const Record& values);
    void takeLoop(int entity, const Record& values);
    void takeEdges(int entity, const Record& values);
    void takeMembers(int entity, const Record& values, std::size_t first, long long count);
    void requireLength(int entity, const Record& values, long long length) const;
    long long countAt(int entity, const Record& values, std::size_t place) const;
    void require(int entity, const Record& values, std::size_t place, IsKind isKind);
    void refer(int entity, long long to);
    int typeOf(long long entity) const;
    bool isPlainGroup(long long entity) const;
    [[noreturn]] void failAt(int entity, const Message& what) const;

    const std::string& m_path;
    Message m_failure;        ///< the first; empty so far
    std::vector<int> m_types; ///< of the entities, in the order of the section D
    std::vector<int> m_forms; ///< the same
    std::set<long long> m_recorded;
    std::map<long long, std::vector<long long>> m_references;
    std::map<long long, long long> m_lengths; ///< of lists of vertices and edges
    std::vector<ListMember> m_members;
};

} // namespace knead
