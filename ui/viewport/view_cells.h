#pragma once

#include <QRect>

#include <array>
#include <optional>
#include <vector>

namespace knead {

/// How many views of a document are seen at once.
enum class ViewArrangement { one, two, four };

/// One of the four views, whatever the arrangement.
enum class ViewSlot { free, front, top, right };
constexpr std::size_t viewSlots = 4;
constexpr std::array<ViewSlot, viewSlots> allViewSlots = {ViewSlot::free, ViewSlot::front, ViewSlot::top,
                                                          ViewSlot::right};

/// Where views lie beside and above one another, with lines between them that can be dragged. A value.
struct ViewCells {
    ViewArrangement arrangement = ViewArrangement::one;
    ViewSlot second = ViewSlot::front; ///< beside the free one when there are two
    double column = 0.5;               ///< share of the width left of the upright line
    double row = 0.5;                  ///< share of the height above the level line

    static constexpr int rim = 2; ///< around each of several views, for the frame of the active one [pixels]
    static constexpr int gap = 6; ///< between two [pixels]

    /// What is seen, in reading order.
    std::vector<ViewSlot> shown() const;
    bool shows(ViewSlot slot) const;
    /// Where a view that is shown lies in `all` [pixels].
    QRect cell(ViewSlot slot, const QRect& all) const;

    /// The lines that a mouse takes hold of; both where they cross.
    struct Lines {
        bool upright = false;
        bool level = false;
        explicit operator bool() const { return upright || level; }
    };
    Lines linesAt(const QPoint& place, const QRect& all) const;
    /// Lays the lines through a place, as far as each view stays large enough to see something.
    void move(const Lines& lines, const QPoint& place, const QRect& all);

private:
    QPoint cross(const QRect& all) const;
};

} // namespace knead
