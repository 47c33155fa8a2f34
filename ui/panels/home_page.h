#pragma once

#include <QWidget>

class QVBoxLayout;

namespace knead {

/// What the window shows before a part is open: where to drop a file, and examples to begin with.
class HomePage final : public QWidget {
    Q_OBJECT
public:
    /// @param examplesFolder holds the *.step files that are offered
    explicit HomePage(const QString& examplesFolder, QWidget* parent = nullptr);

    /// Offers the first few of these to be opened again.
    void showRecent(const QStringList& paths);

signals:
    void openClicked();
    void fileChosen(const QString& path);

private:
    QVBoxLayout* m_recent = nullptr;
};

} // namespace knead
