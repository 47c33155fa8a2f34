#pragma once

#include "ui/display.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace knead {

class QuantityField;

/// What is shown of the material and how: what is switched on, colors, section plane, before and after.
class DisplayPanel final : public QWidget {
    Q_OBJECT
public:
    explicit DisplayPanel(Display& display, QWidget* parent = nullptr);

private:
    void addSwitches(QFormLayout* form);
    void addColors(QFormLayout* form);
    void addSection(QFormLayout* form);
    void addCompare(QFormLayout* form);
    void makeRangeFields(SurfaceQuantity quantity);
    void chooseRange();
    void bringUpToDate();
    void showColors(const SceneOptions& options);
    void showSection(const SceneOptions& options);

    Display& m_display;
    QComboBox* m_shading;
    QComboBox* m_quantity;
    QComboBox* m_map;
    QCheckBox* m_isAutomatic;
    QWidget* m_rangeRow;
    QLabel* m_mapLabel;
    QLabel* m_rangeLabel;
    std::optional<SurfaceQuantity> m_rangeQuantity; ///< that the fields are for
    QuantityField* m_least = nullptr;
    QuantityField* m_most = nullptr;
    QWidget* m_sectionBox;
    QComboBox* m_axis;
    QuantityField* m_offset;
    QSlider* m_slider;
};

} // namespace knead
