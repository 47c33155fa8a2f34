#pragma once

#include "core/aggregate/material.h"
#include "ui/dialogs/modeless_dialog.h"

#include <vector>

class QComboBox;
class QTreeWidget;

namespace knead {

/// Two materials side by side, number by number, with what follows from them. Does not block the window behind it.
class MaterialComparisonDialog final : public ModelessDialog {
    Q_OBJECT
public:
    /// @param choices at least one; the first one is shown on the left
    MaterialComparisonDialog(std::vector<MaterialPreset> choices, std::size_t right, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showBoth();

    std::vector<MaterialPreset> m_choices;
    QComboBox* m_left;
    QComboBox* m_right;
    QTreeWidget* m_table;
};

} // namespace knead
