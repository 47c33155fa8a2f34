#pragma once

#include "ui/frame/workbench.h"

#include <QObject>

namespace knead {

struct Actions;

/// What is seen of the part from where: several views, directions, and what is drawn in them. Window thread only.
class ViewsFeature final : public QObject {
    Q_OBJECT
public:
    ViewsFeature(const Workbench& bench, Actions& actions);

    void showArrangement(); ///< the actions say what the views are

private:
    void connectViews();
    void connectViewActions();
    void followSwitches();

    Workbench m_bench;
    Actions& m_actions;
};

} // namespace knead
