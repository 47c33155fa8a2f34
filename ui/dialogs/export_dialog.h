#pragma once

#include "core/session/export_request.h"
#include "ui/services.h"

#include <QDialog>

#include <vector>

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
    ExportDialog(const std::vector<Services::Format>& formats, const QString& selected, bool hidden,
                 QWidget* parent = nullptr);

    /// The choices as they stand.
    ExportRequest request() const;
    /// The chosen format.
    const Services::Format& format() const;

private:
    void formatChanged();

    std::vector<Services::Format> m_formats;
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
