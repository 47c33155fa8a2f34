#pragma once

#include "core/session/part_transfer.h"

#include <QDialog>

class QComboBox;

namespace knead {

class QuantityField;

/// Asks how another part follows from the one that is open: the same way round, its mirrored partner, of another size.
class OtherPartDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param file its name
    explicit OtherPartDialog(const QString& file, QWidget* parent = nullptr);

    /// The choices as they stand.
    TransferOptions options() const;

private:
    void sizeChosen();

    QComboBox* m_mirror; ///< by index: not, across x, y, z
    QComboBox* m_size;
    QuantityField* m_factor;
};

} // namespace knead
