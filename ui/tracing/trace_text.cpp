#include "ui/tracing/trace_text.h"

#include <algorithm>
#include <exception>

namespace knead {

/// If something cannot be told, the text ends there.
template <class Work>
TextEdit TraceText::after(qsizetype kept, Work work)
{
    TextEdit edit{.kept = kept, .text = {}};
    m_new.clear();
    try {
        work();
        edit.text = m_new + QString::fromStdString(m_present->ending(m_step));
    } catch (const std::exception& error) {
        edit.text = m_new;
        if (m_present)
            edit.text += QString::fromStdString(m_present->take() + m_present->ending(0)); // no table stays open
        edit.problem = messageOf(error);
        m_places.clear();
    }
    return edit;
}

/// To where so many entries are written. @return the length of the text
qsizetype TraceText::goBack(std::size_t entries)
{
    m_places.resize(std::min(entries + 1, m_places.size()));
    m_present = m_places.back().trace->copy();
    m_step = 0;
    return m_length = m_places.back().length;
}

void TraceText::add(std::span<const RecordedCommand> commands, const std::string& name)
{
    m_present->add(commands, name);
    const QString text = QString::fromStdString(m_present->take());
    m_new += text;
    m_length += text.size();
}

TextEdit TraceText::begin(const std::function<std::unique_ptr<SessionTrace>()>& make)
{
    m_places.clear();
    m_present.reset();
    m_length = 0;
    m_step = 0;
    return after(0, [&] {
        m_present = make();
        add({}, {});
        m_places.push_back({m_present->copy(), m_length});
    });
}

std::optional<TextEdit> TraceText::follow(std::size_t kept, const std::vector<HistoryRecord>& added)
{
    if (m_places.empty())
        return std::nullopt;
    return after(goBack(kept), [&] {
        for (const HistoryRecord& record : added) {
            add(record.commands, record.label().english());
            m_places.push_back({m_present->copy(), m_length});
        }
    });
}

std::optional<TextEdit> TraceText::goOn(const RecordingNews& news)
{
    if (m_places.empty())
        return std::nullopt;
    const bool isNew = news.after.commands == 0;
    return after(isNew ? goBack(m_places.size() - 1) : m_length, [&] {
        add(news.commands, {});
        m_step = news.step;
    });
}

} // namespace knead
