#pragma once

#include "core/document/history_record.h"
#include "core/document/session_trace.h"
#include "core/message/message.h"
#include "core/simulation/simulation_thread.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// What a text is to become: other letters after so many.
struct TextEdit {
    qsizetype kept = 0;
    QString text;
    Message problem = {}; ///< why it goes on no further; empty: nothing is wrong
};

/// The trace of a session, entry by entry of its history: what is undone is taken back by leaving out the end, and what is added is
/// added. One thread at a time, that of the one who writes it.
class TraceText {
public:
    /// Begins anew. @param make the trace of a start
    TextEdit begin(const std::function<std::unique_ptr<SessionTrace>()>& make);

    /// Keeps the first entries, and goes on with others; what was under way is left out. None where it goes on no further.
    std::optional<TextEdit> follow(std::size_t kept, const std::vector<HistoryRecord>& added);

    /// What was done since, and is no entry yet; none as above. @pre it follows what is known of it, or all of it is new
    std::optional<TextEdit> goOn(const RecordingNews& news);

private:
    struct Place {
        std::shared_ptr<const SessionTrace> trace; ///< up to here
        qsizetype length = 0;                      ///< of the text
    };

    template <class Work>
    TextEdit after(qsizetype kept, Work work);
    qsizetype goBack(std::size_t entries);
    void add(std::span<const RecordedCommand> commands, const std::string& name);

    std::vector<Place> m_places;             ///< the beginning, then one after each entry; none: it could not be told
    std::unique_ptr<SessionTrace> m_present; ///< goes on from the last one
    qsizetype m_length = 0;                  ///< of the text, without its ending
    std::uint64_t m_step = 0;
    QString m_new;
};

} // namespace knead
