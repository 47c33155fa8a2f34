#pragma once

#include "core/session/comparison.h"
#include "ui/dialogs/modeless_dialog.h"
#include "ui/panels/place_rows.h"

namespace knead {

/// Shows how far bodies are from their original shape and where, and offers a report. Does not block the window behind it.
class ComparisonDialog final : public ModelessDialog {
    Q_OBJECT
public:
    explicit ComparisonDialog(const Comparison& comparison, QWidget* parent = nullptr);

signals:
    void reportWanted();
    void placeWanted(const knead::ReportPlace& place); ///< where a part is farthest from what it was
};

} // namespace knead
