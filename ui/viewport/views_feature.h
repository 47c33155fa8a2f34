#pragma once

#include "ui/frame/workbench.h"
#include "ui/viewport/view_actions.h"

#include <QObject>

namespace knead {

/// What is seen of the part from where: several views, and directions. Window thread only.
class ViewsFeature final : public QObject {
    Q_OBJECT
public:
    explicit ViewsFeature(const Workbench& bench);

    const ViewActions& actions() const { return m_actions; }

    void showArrangement(); ///< the actions say what the views are

private:
    void connectViews();
    void connectViewActions();
    void sayWhyNot();

    Workbench m_bench;
    ViewActions m_actions;
};

} // namespace knead
