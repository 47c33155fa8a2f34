#pragma once

#include "core/task/ordered_worker.h"
#include "ui/document/document.h"
#include "ui/project/trace_services.h"
#include "ui/tracing/trace_text.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QTimer;

namespace knead {

class ProjectKeeper;

/// Keeps the trace of what is done in a document while somebody looks at it: entries of its history as they come and go, and, some
/// times a second, what is under way. It is written on another thread, and what was written before is left as it is. Window thread.
class TraceFollower final : public QObject {
    Q_OBJECT
public:
    TraceFollower(Document& document, TraceServices services, ProjectKeeper& projects, QObject* parent);
    ~TraceFollower() override;

    /// Whether anybody looks.
    void follow(bool on);

signals:
    void changed(const knead::TextEdit& edit);

private:
    void keepUp();
    void goBack();
    void writeEntries(std::size_t kept);
    void beginAnew();
    void lookOn();
    void hear(const RecordingNews& news);
    void write(std::function<std::optional<TextEdit>(TraceText&)> work);
    void arrive(const TextEdit& edit);

    /// Which text it is.
    struct Source {
        std::uint64_t document = 0;
        std::uint32_t start = 0;
        QString project; ///< its file
        friend bool operator==(const Source&, const Source&) = default;
    };

    Document& m_document;
    TraceServices m_services;
    ProjectKeeper& m_projects;
    QTimer* m_timer;
    bool m_isFollowing = false;
    bool m_isEmpty = true;
    bool m_isStuck = false;    ///< it could not be told
    bool m_isBehind = false;   ///< the file of the project was, when it was begun
    std::uint64_t m_texts = 0; ///< that were begun: what comes of earlier ones is dropped
    Source m_source;
    std::vector<History::Entry> m_path; ///< that is written
    RecordingMark m_known;              ///< of what is under way
    std::uint64_t m_step = 0;           ///< the same
    std::shared_ptr<TraceText> m_text;  ///< touched on the worker's thread
    OrderedWorker m_worker;             // last: it ends first
};

} // namespace knead
