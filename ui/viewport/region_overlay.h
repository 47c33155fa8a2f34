#pragma once

#include "ui/viewport/region_tool.h"

#include <QWidget>

namespace knead {

/// Draws what the region tool draws, on top of the view: box, lasso, brush. Takes no clicks.
class RegionOverlay final : public QWidget {
    Q_OBJECT
public:
    RegionOverlay(const RegionTool& tool, QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const RegionTool& m_tool;
};

} // namespace knead
