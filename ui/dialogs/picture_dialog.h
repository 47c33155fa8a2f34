#pragma once

#include "ui/recording/picture.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace knead {

/// Asks how large a picture of the view is and what is in it; where to is asked next. What was chosen last is offered first.
class PictureDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param viewSize [pixels]
    explicit PictureDialog(const QSize& viewSize, QWidget* parent = nullptr);

    /// The choices as they stand.
    Picture picture() const;

private:
    QCheckBox* makeBox(const char* name, const QString& text);
    QWidget* makeSizes(const QSize& viewSize);
    void sizeChosen();
    void kindChosen();
    void restore();
    void remember() const;

    QSize m_viewSize;
    QComboBox* m_size = nullptr; ///< data: the size; not valid: that of the numbers
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QComboBox* m_kind = nullptr;
    QCheckBox* m_clear = nullptr;
    QCheckBox* m_ground = nullptr;
    QCheckBox* m_cube = nullptr;
};

} // namespace knead
