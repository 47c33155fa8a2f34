#include "ui/frame/docks.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QPainter>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace knead {

namespace {

constexpr int leftWidth = 300;
constexpr int logHeight = 110;

struct DockPlace {
    std::string_view name;
    Qt::DockWidgetArea area;
    std::string_view with; ///< whose place it shares, behind it; empty: it has one of its own
    bool isLow = false;    ///< held at its left, not at its top
    bool isShownAtFirst = true;
};

constexpr std::array<DockPlace, 16> dockPlaces{{
    {"modelDock", Qt::LeftDockWidgetArea, {}},
    {"historyDock", Qt::LeftDockWidgetArea, "modelDock"},
    {"simulationDock", Qt::LeftDockWidgetArea, "modelDock"},
    {"propertiesDock", Qt::LeftDockWidgetArea, {}},
    {"displayDock", Qt::LeftDockWidgetArea, "propertiesDock"},
    {"handsDock", Qt::LeftDockWidgetArea, "propertiesDock"},
    {.name = "deformDock", .area = Qt::LeftDockWidgetArea, .with = "propertiesDock", .isShownAtFirst = false},
    {.name = "timelineDock", .area = Qt::BottomDockWidgetArea, .with = {}, .isLow = true},
    {"logDock", Qt::BottomDockWidgetArea, {}},
    {"importDock", Qt::BottomDockWidgetArea, "logDock"},
    {"exportDock", Qt::BottomDockWidgetArea, "logDock"},
    {"performanceDock", Qt::BottomDockWidgetArea, "logDock"},
    {.name = "measureDock", .area = Qt::BottomDockWidgetArea, .with = "logDock", .isShownAtFirst = false},
    {.name = "probeDock", .area = Qt::BottomDockWidgetArea, .with = "logDock", .isShownAtFirst = false},
    {.name = "forcesDock", .area = Qt::BottomDockWidgetArea, .with = "logDock", .isShownAtFirst = false},
    {.name = "traceDock", .area = Qt::BottomDockWidgetArea, .with = "logDock", .isShownAtFirst = false},
}};

const DockPlace& dockPlaceOf(std::string_view name)
{
    const auto* found = std::find_if(dockPlaces.begin(), dockPlaces.end(),
                                     [name](const DockPlace& place) { return place.name == name; });
    if (found == dockPlaces.end())
        throw std::logic_error("docks.cpp has no place for " + std::string(name));
    return *found;
}

/// What a low dock is held by: a narrow strip at its left.
class Grip final : public QWidget {
public:
    using QWidget::QWidget;

    QSize sizeHint() const override { return {14, 24}; }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::PlaceholderText));
        for (int row = -2; row <= 2; ++row)
            for (const double column : {-2.5, 2.5})
                painter.drawEllipse(QRectF(rect()).center() + QPointF(column, 6.0 * row), 1.2, 1.2);
    }
};

} // namespace

Docks::Docks(QMainWindow& window)
    : m_window(window)
{
}

QDockWidget& Docks::add(std::string_view name, const QString& title, QWidget* panel)
{
    const DockPlace& place = dockPlaceOf(name);
    auto* dock = new QDockWidget(title, &m_window);
    dock->setObjectName(QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())));
    dock->setWidget(panel);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetFloatable);
    if (place.isLow) {
        dock->setFeatures(dock->features() | QDockWidget::DockWidgetVerticalTitleBar);
        dock->setTitleBarWidget(new Grip(dock));
    }
    return *(m_docks[place.name] = dock);
}

void Docks::arrange()
{
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    const QDockWidget* above = nullptr; // at the bottom, one place is above the other
    for (const DockPlace& place : dockPlaces) {
        QDockWidget& dock = of(place.name);
        m_window.addDockWidget(place.area, &dock);
        if (!place.with.empty())
            m_window.tabifyDockWidget(&of(place.with), &dock);
        else if (place.area == Qt::BottomDockWidgetArea && above != nullptr)
            m_window.splitDockWidget(const_cast<QDockWidget*>(above), &dock, Qt::Vertical);
        if (place.area == Qt::BottomDockWidgetArea && place.with.empty())
            above = &dock;
    }
    for (const DockPlace& place : dockPlaces)
        if (place.with.empty())
            of(place.name).raise();
    size();
}

void Docks::hideLaterOnes()
{
    for (const DockPlace& place : dockPlaces)
        if (!place.isShownAtFirst)
            of(place.name).hide();
}

void Docks::size()
{
    QDockWidget* model = &of("modelDock");
    QDockWidget* properties = &of("propertiesDock");
    m_window.resizeDocks({model, properties}, {leftWidth, leftWidth}, Qt::Horizontal);
    m_window.resizeDocks({model, properties}, {1, 2}, Qt::Vertical);
    m_window.resizeDocks({&of("logDock")}, {logHeight}, Qt::Vertical);
}

QDockWidget& Docks::of(std::string_view name) const
{
    return *m_docks.at(name);
}

void Docks::show(std::string_view name) const
{
    of(name).show();
    of(name).raise();
}

void Docks::bringForward(std::string_view name) const
{
    if (!of(name).isHidden())
        of(name).raise();
}

void Docks::showAtLeast(std::string_view name, int least) const
{
    show(name);
    if (of(name).height() < least)
        m_window.resizeDocks({&of(name)}, {least}, Qt::Vertical);
}

} // namespace knead
