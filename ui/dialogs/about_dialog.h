#pragma once

#include "ui/services.h"

#include <QDialog>

namespace knead {

/// Knead's version and license, and those of what it is made with.
class AboutDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param libraries that the window cannot know: of files and of computing
    explicit AboutDialog(const std::vector<Services::Library>& libraries, QWidget* parent = nullptr);

private:
    QWidget* makeHead();
    QWidget* makeList();
    void copy() const;

    std::vector<Services::Library> m_libraries; ///< all of them
};

} // namespace knead
