#pragma once

#include "ui/viewport/scene_view.h"

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <QPointF>

class QLabel;
class QWidget;

namespace knead {

/// The numbers beside tools that say how hard the material presses on them. They are widgets on top of the scene: text stays
/// sharp, and the scene needs no second drawing. Window thread.
class ForceLabels {
public:
    /// @param view that the labels lie in, and that deletes them in the end
    explicit ForceLabels(QWidget* view)
        : m_view(view)
    {
    }

    /// @param seenAt where a place is seen in the view; empty: not at all
    void place(const std::vector<SceneLabel>& labels,
               const std::function<std::optional<QPointF>(const Vec3& place)>& seenAt);

private:
    QLabel* newLabel(ToolId tool) const;

    QWidget* m_view;
    std::map<ToolId, QLabel*> m_labels;
};

} // namespace knead
