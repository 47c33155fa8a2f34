#include "io/worker/file_rules.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace knead {

namespace {

// What later versions of Landlock can take away is not in the headers of all systems that this is built on.
constexpr int newestKnown = 6;

/// All rights to files that a version knows, as bits: 13 at first.
std::uint64_t fileRightsOf(int version)
{
    constexpr std::array<int, newestKnown> counts{13, 14, 15, 15, 16, 16};
    return (1ULL << static_cast<unsigned>(counts.at(static_cast<std::size_t>(version) - 1))) - 1;
}

/// struct landlock_ruleset_attr, as long as a version knows it.
struct RulesetAttributes {
    std::uint64_t fileRights = 0;
    std::uint64_t networkRights = 0; ///< TCP: bind, connect
    std::uint64_t scopes = 0;        ///< sockets without names in the file system, signals
};

std::size_t sizeOfAttributes(int version)
{
    if (version < 4)
        return offsetof(RulesetAttributes, networkRights);
    return version < 6 ? offsetof(RulesetAttributes, scopes) : sizeof(RulesetAttributes);
}

int makeRuleset(int version)
{
    const int known = std::min(version, newestKnown);
    const RulesetAttributes attributes{fileRightsOf(known), known < 4 ? 0U : 3U, known < 6 ? 0U : 3U};
    return static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeOfAttributes(known), 0));
}

void allowReading(int ruleset, const std::string& path)
{
    const int descriptor = open(path.c_str(), O_PATH | O_CLOEXEC);
    struct stat facts {};
    if (descriptor < 0 || fstat(descriptor, &facts) != 0)
        return;
    landlock_path_beneath_attr rule{};
    rule.parent_fd = descriptor;
    rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    if (S_ISDIR(facts.st_mode))
        rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
    syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(descriptor);
}

} // namespace

int landlockVersion()
{
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return std::max(0, static_cast<int>(version));
}

bool restrictFiles(const std::vector<std::string>& readable)
{
    const int version = landlockVersion();
    const int ruleset = version > 0 ? makeRuleset(version) : -1;
    if (ruleset < 0)
        return false;
    for (const std::string& path : readable)
        allowReading(ruleset, path);
    const bool isRestricted = syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    close(ruleset);
    return isRestricted;
}

} // namespace knead
