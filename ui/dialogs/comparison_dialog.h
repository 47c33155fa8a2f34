#pragma once

#include "ui/measuring/comparison.h"

#include <QDialog>

namespace knead {

/// Shows how far bodies are from their original shape, and offers a report. Does not block the window behind it.
class ComparisonDialog final : public QDialog {
    Q_OBJECT
public:
    explicit ComparisonDialog(const Comparison& comparison, QWidget* parent = nullptr);

signals:
    void reportWanted();
};

} // namespace knead
