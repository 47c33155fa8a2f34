// A recipe that the document was opened from goes on beside what the person does.
#include "ui/document/document.h"

#include <utility>

namespace knead {

/// Of a start, as far as it was at a moment; null: it has none.
std::unique_ptr<Agenda> Document::agendaAt(std::uint32_t start, const Moment& moment, std::uint64_t hash) const
{
    const AgendaMaker& make = m_history.starts()[start].agenda;
    std::unique_ptr<Agenda> agenda = make ? make() : nullptr;
    if (agenda)
        agenda->wentTo(moment, hash);
    return agenda;
}

void Document::noticeRecipeEnd()
{
    const std::uint64_t ends = m_frame->snapshot->agendaEnds;
    if (std::exchange(m_agendaEnds, ends) < ends)
        emit recipeEnded(tr("The recipe has come to its end. Play goes on without it."));
}

} // namespace knead
