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

std::vector<Message> QualityWatch::see(const Snapshot& now)
{
    const std::vector<Remark> remarks = remarksOn(qualityOf(now));
    forgetWhatIsWell(now, remarks);
    std::vector<Message> sentences;
    for (const Remark& remark : remarks) {
        const bool stays = ++m_frames[remark.concern] >= framesToStay || !now.playing;
        bool& isSaid = m_isSaid[remark.concern];
        if (isSaid || !stays || remark.concern == Concern::unsolved)
            continue;
        isSaid = true;
        sentences.push_back(remark.sentence);
    }
    return sentences;
}

void QualityWatch::begin()
{
    m_frames.clear();
    m_isSaid.clear();
}

void QualityWatch::forgetWhatIsWell(const Snapshot& now, const std::vector<Remark>& remarks)
{
    const bool isElsewhere = now.arrivals != m_arrivals || now.resets != m_resets;
    m_arrivals = now.arrivals;
    m_resets = now.resets;
    std::erase_if(m_frames, [&](const auto& frames) { return !has(remarks, frames.first); });
    if (isElsewhere)
        std::erase_if(m_isSaid, [&](const auto& said) { return !has(remarks, said.first); });
}

} // namespace knead
