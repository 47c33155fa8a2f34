#pragma once

#include <QScrollArea>

class QFrame;
class QGridLayout;
class QLabel;
class QMenu;
class QVBoxLayout;

namespace knead {

/// What the window shows before a part is open: clay to try at once, where to drop a file, unsaved work that waits, files of late
/// and examples as pictures.
class HomePage final : public QScrollArea {
    Q_OBJECT
public:
    /// @param examplesFolder holds the *.step files that are offered, each with a picture: "bar.step", "bar.png"
    explicit HomePage(const QString& examplesFolder, QWidget* parent = nullptr);

    /// A menu of the examples: parts, and below them recipes.
    void fillExamples(QMenu& menu);
    /// Offers the first few of these to be opened again.
    void showRecent(const QStringList& paths);
    /// Says that unsaved work waits; none: says nothing.
    void showWaiting(const QStringList& names);
    /// A file is held over the window.
    void showDrop(bool isOver);

signals:
    void tryClicked(); ///< a thumb is to be pressed into clay
    void openClicked();
    void fileChosen(const QString& path);
    void recoverClicked();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void listCards();
    QWidget* makeTrial();
    QWidget* makeZone();
    QWidget* makeWaiting();
    void addExamples(QVBoxLayout* column, const QString& folder);

    const QString m_examplesFolder;
    QFrame* m_zone = nullptr;
    QFrame* m_waiting = nullptr;
    QLabel* m_waitingNames = nullptr;
    QLabel* m_recentTitle = nullptr;
    QWidget* m_recent = nullptr;
    QGridLayout* m_recentGrid = nullptr;
    QStringList m_recentPaths;
};

} // namespace knead
