#pragma once

#include "core/document/kept_work.h"

#include <QDialog>

#include <vector>

class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace knead {

/// Offers the work that windows which are gone did not save. Closing it leaves everything as it is, for later.
class RecoveryDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param found at least one
    explicit RecoveryDialog(std::vector<Recovery> found, QWidget* parent = nullptr);

    /// "bracket.knead", or the name of its part while there was no file.
    static QString nameOf(const Recovery& recovery);

signals:
    void recoverClicked(const knead::Recovery& recovery); ///< the dialog closes
    void discardClicked(const knead::Recovery& recovery); ///< it is gone from the list

private:
    void addList(QVBoxLayout* column);
    void addButtons(QVBoxLayout* column);
    void recover();
    void askToDiscard();
    void discard(int row);

    std::vector<Recovery> m_found;
    QListWidget* m_list = nullptr;
    QPushButton* m_recover = nullptr;
    QPushButton* m_discard = nullptr;
};

} // namespace knead
