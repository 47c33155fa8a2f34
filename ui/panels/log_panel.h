#pragma once

#include <QPlainTextEdit>

namespace knead {

/// What happened, with the time of day, newest last.
class LogPanel final : public QPlainTextEdit {
    Q_OBJECT
public:
    enum class Kind { Info, Warning, Error };

    explicit LogPanel(QWidget* parent = nullptr);

    void add(const QString& sentence, Kind kind = Kind::Info);
};

} // namespace knead
