#pragma once

#include <QWidget>

namespace knead {

/// What the window shows before a part is open: where to drop a file, and examples to begin with.
class HomePage final : public QWidget {
    Q_OBJECT
public:
    /// @param examplesFolder holds the *.step files that are offered
    explicit HomePage(const QString& examplesFolder, QWidget* parent = nullptr);

signals:
    void openClicked();
    void fileChosen(const QString& path);
};

} // namespace knead
