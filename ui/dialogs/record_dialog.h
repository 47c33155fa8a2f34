#pragma once

#include "ui/recording/recording.h"

#include <QDialog>

#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;

namespace knead {

class QuantityField;

/// Asks which time of the timeline is recorded, how fast it passes and how large the pictures are; where to is asked next. What
/// was chosen last is offered first.
class RecordDialog final : public QDialog {
    Q_OBJECT
public:
    /// The view that is recorded.
    struct ShownView {
        QSize size;   ///< [pixels]
        QString name; ///< where it is one of several
    };
    /// @param end of the timeline [s]
    RecordDialog(Recording::Kind kind, double end, const ShownView& view, QWidget* parent = nullptr);

    /// The choices as they stand.
    Recording recording() const;

private:
    void makeFields(double end);
    void makeSizes(const QSize& viewSize);
    void restore();
    void remember() const;
    void showExtent();

    Recording::Kind m_kind;
    QuantityField* m_from = nullptr;
    QuantityField* m_to = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_rate = nullptr;
    QComboBox* m_size = nullptr;
    QCheckBox* m_readings = nullptr;
    QLabel* m_extent = nullptr;
};

} // namespace knead
