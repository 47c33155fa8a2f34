#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace knead {

class QuantityField;

/// The selected tool: its form, where it is, how large, how fast, and what it feels.
class ToolPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ToolPanel(Document& document, QWidget* parent = nullptr);

private:
    void documentChanged(Document::Change what);
    void showTool();
    void showKind(const ToolState& tool);
    void chooseKind(int index);

    Document& m_document;
    ToolId m_tool = 0;
    QLabel* m_name;
    QComboBox* m_kind;
    std::optional<ToolKind> m_shownKind; ///< whose measures have rows
    std::array<QuantityField*, 3> m_position{};
    std::array<QuantityField*, 3> m_size{};
    QuantityField* m_speed;
    QuantityField* m_forceLimit;
    QuantityField* m_friction;
    QuantityField* m_adhesion;
    QCheckBox* m_rolls; ///< of those that can
    QLabel* m_force;
    QLabel* m_peak;
};

} // namespace knead
