// A recipe that the document was opened from goes on beside what the person does.
#include "ui/document/document.h"

#include <utility>

namespace knead {

/// Of a start, as far as it was at a moment; null: it has none.
std::unique_ptr<ScriptedEvents> Document::scriptAt(std::uint32_t start, const Moment& moment, std::uint64_t hash) const
{
    const ScriptedEventsMaker& make = m_history.starts()[start].script;
    std::unique_ptr<ScriptedEvents> script = make ? make() : nullptr;
    if (script)
        script->wentTo(moment, hash);
    return script;
}

void Document::noticeRecipeEnd()
{
    const std::uint64_t ends = m_frame->snapshot->scriptEnds;
    if (std::exchange(m_scriptEnds, ends) < ends)
        emit recipeEnded(tr("The recipe has come to its end. Play goes on without it."));
}

} // namespace knead
