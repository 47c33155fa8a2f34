#pragma once

#include "core/model/file_formats.h"
#include "core/session/export_request.h"
#include "ui/services.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;

namespace knead {

class QuantityField;

/// Asks in which format, which parts and how closely a person wants the deformed parts written; where to is asked next. What was
/// chosen last is offered first.
class ExportDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param selected name of the selected part; empty for none
    /// @param hidden whether some parts are hidden
    ExportDialog(const QString& selected, bool hidden, QWidget* parent = nullptr);

    /// The choices as they stand.
    ExportRequest request() const;
    /// The chosen format.
    const FileFormat& format() const;

private:
    void formatChanged();

    QComboBox* m_format = nullptr;
    QLabel* m_about = nullptr;
    QComboBox* m_parts = nullptr;
    QComboBox* m_unit = nullptr;
    QuantityField* m_tolerance = nullptr;
    QCheckBox* m_ap214 = nullptr;
    QCheckBox* m_text = nullptr;
    QCheckBox* m_onePerPart = nullptr;
    QCheckBox* m_report = nullptr;
};

} // namespace knead
