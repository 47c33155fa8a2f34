#include "ui/viewport/view_cells.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double leastCell = 0.15; // share of a view
constexpr int crossReach = 8;      // around the place where lines cross [pixels]

} // namespace

std::vector<ViewSlot> ViewCells::shown() const
{
    switch (arrangement) {
    case ViewArrangement::two:
        return {ViewSlot::free, second};
    case ViewArrangement::four:
        return {ViewSlot::top, ViewSlot::free, ViewSlot::front, ViewSlot::right};
    case ViewArrangement::one:
        break;
    }
    return {};
}

bool ViewCells::shows(ViewSlot slot) const
{
    const std::vector<ViewSlot> all = shown();
    return std::find(all.begin(), all.end(), slot) != all.end();
}

QPoint ViewCells::cross(const QRect& all) const
{
    return all.topLeft() + QPoint(static_cast<int>(std::lround(column * all.width())),
                                  static_cast<int>(std::lround(row * all.height())));
}

/// Top above front, right beside front: edges of the part are in line with each other from view to view.
QRect ViewCells::cell(ViewSlot slot, const QRect& all) const
{
    const QPoint middle = cross(all);
    const bool areFour = arrangement == ViewArrangement::four;
    const bool isLeft = areFour ? slot == ViewSlot::top || slot == ViewSlot::front : slot == ViewSlot::free;
    const bool isUpper = slot == ViewSlot::top || slot == ViewSlot::free;
    QRect cell = all.adjusted(rim, rim, -rim, -rim);
    if (isLeft)
        cell.setRight(middle.x() - gap / 2 - 1);
    else
        cell.setLeft(middle.x() + gap / 2);
    if (areFour && isUpper)
        cell.setBottom(middle.y() - gap / 2 - 1);
    else if (areFour)
        cell.setTop(middle.y() + gap / 2);
    return cell;
}

ViewCells::Lines ViewCells::linesAt(const QPoint& place, const QRect& all) const
{
    if (arrangement == ViewArrangement::one || !all.contains(place))
        return {};
    const QPoint off = place - cross(all);
    const bool areFour = arrangement == ViewArrangement::four;
    Lines lines{.upright = std::abs(off.x()) <= gap / 2, .level = areFour && std::abs(off.y()) <= gap / 2};
    if (areFour && lines && std::abs(off.x()) <= crossReach && std::abs(off.y()) <= crossReach)
        lines = {.upright = true, .level = true};
    return lines;
}

void ViewCells::move(const Lines& lines, const QPoint& place, const QRect& all)
{
    const auto share = [](int at, int whole) {
        return std::clamp(static_cast<double>(at) / std::max(1, whole), leastCell, 1 - leastCell);
    };
    if (lines.upright)
        column = share(place.x() - all.left(), all.width());
    if (lines.level)
        row = share(place.y() - all.top(), all.height());
}

} // namespace knead
