#pragma once

#include "core/session/compensation.h"
#include "core/session/compensation_study.h"

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

/// Something that the rounds of a compensation depend on.
struct StudyFact {
    std::string name;  ///< key of the study, or name of a file
    std::string value; ///< of the key, or digest of the file
    bool isFile = false;
};

/// All that rounds depend on. How many there may be, how good they must be and how long they may take is not among it.
std::vector<StudyFact> factsOf(const CompensationStudy& study);

/// The folder of a compensation: what it depends on, and a folder for each round with a file that says it is finished. Files appear
/// whole or not at all, so that a killed compensation goes on from its last finished round.
class CompensationFolder {
public:
    explicit CompensationFolder(const std::string& path);

    const std::string& path() const { return m_path; }
    std::string pathOf(const std::string& name) const;
    std::string folderOf(int round) const; ///< "round-01"

    /// @throws std::runtime_error, in a sentence, when the compensation of another study is here
    void checkHasNoOther(const std::vector<StudyFact>& facts) const;

    /// Begins, or goes on. @throws std::runtime_error, in a sentence, when the folder cannot be written to
    void begin(const std::vector<StudyFact>& facts) const;

    /// Whether a compensation left something here.
    bool isBegun() const;

    /// Takes away what a compensation left here, but nothing else.
    void clear() const;

    /// A round is finished. @throws Problem when the disk refuses
    void keep(const CompensationRound& round) const;

    /// Finished rounds from the first one on.
    /// @param points of the target
    std::vector<CompensationRound> rounds(const TargetPoints& points) const;

private:
    std::string m_path; ///< absolute
};

} // namespace knead
