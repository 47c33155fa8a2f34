#include "core/session/quality_watch.h"

#include <algorithm>

namespace knead {

namespace {

constexpr int framesToStay = 30;

bool has(const std::vector<Remark>& remarks, Concern concern)
{
    return std::ranges::any_of(remarks, [&](const Remark& one) { return one.concern == concern; });
}

} // namespace

QualityWatch::News QualityWatch::see(const Snapshot& now)
{
    const std::vector<Remark> remarks = remarksOn(qualityOf(now));
    News news{.said = {}, .passed = forgetWhatIsWell(now, remarks)};
    for (const Remark& remark : remarks) {
        const bool stays = ++m_frames[remark.concern] >= framesToStay || !now.playing;
        const auto before = m_said.find(remark.concern);
        const bool isSaid = before != m_said.end() && (remark.isMinor || !before->second.isMinor);
        if (isSaid || !stays || remark.concern == Concern::unsolved)
            continue;
        m_said.insert_or_assign(remark.concern, remark);
        news.said.push_back(remark);
    }
    return news;
}

void QualityWatch::begin()
{
    m_frames.clear();
    m_said.clear();
}

/// @return the sentences that are forgotten
std::vector<Message> QualityWatch::forgetWhatIsWell(const Snapshot& now, const std::vector<Remark>& remarks)
{
    const bool isElsewhere = now.arrivals != m_arrivals || now.resets != m_resets;
    m_arrivals = now.arrivals;
    m_resets = now.resets;
    std::erase_if(m_frames, [&](const auto& frames) { return !has(remarks, frames.first); });
    std::vector<Message> passed;
    if (isElsewhere)
        std::erase_if(m_said, [&](const auto& said) {
            if (has(remarks, said.first))
                return false;
            passed.push_back(said.second.sentence);
            return true;
        });
    return passed;
}

} // namespace knead
