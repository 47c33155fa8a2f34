#pragma once

#include "core/session/quality_watch.h"
#include "core/session/stall_watch.h"
#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QObject>

class QTimer;

namespace knead {

/// Looks at how a document's simulation goes, and says what a person should know of it, each thing once.
class RunRemarks final : public QObject {
    Q_OBJECT
public:
    explicit RunRemarks(Document& document, QObject* parent = nullptr);

signals:
    void said(const QString& sentence);
    void noted(const QString& sentence);  ///< not worth stopping for
    void passed(const QString& sentence); ///< said before, and no longer so

private:
    void documentChanged(Document::Change what);
    void tell(const QualityWatch::News& news);
    void lookAtPace();

    Document& m_document;
    QualityWatch m_quality;
    StallWatch m_stall;
    QElapsedTimer m_clock;
    QTimer* m_timer;
};

} // namespace knead
