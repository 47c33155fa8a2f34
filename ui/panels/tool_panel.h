#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <array>

class QLabel;

namespace knead {

class QuantityField;

/// The selected block: where it is, how large, how fast, and what it feels.
class ToolPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ToolPanel(Document& document, QWidget* parent = nullptr);

private:
    void documentChanged(Document::Change what);
    void showTool();
    void place();
    void reshape();

    Document& m_document;
    ToolId m_tool = 0;
    QLabel* m_name;
    std::array<QuantityField*, 3> m_position{};
    std::array<QuantityField*, 3> m_size{};
    QuantityField* m_speed;
    QuantityField* m_forceLimit;
    QuantityField* m_friction;
    QLabel* m_force;
    QLabel* m_peak;
};

} // namespace knead
