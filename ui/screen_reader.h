#pragma once

#include <QAccessible>
#include <QString>

#include <functional>

class QWidget;

namespace knead {

/// Where a number stands between its ends.
struct ReadRange {
    double least = 0;
    double most = 0;
    double now = 0;
};

/// Tells readers of screens what a widget is that draws itself. Its name is its accessibleName.
/// @pre it has no such name yet: from then on it counts as what it was until then
/// @param value in words, asked for each time it is read
/// @param range of what can be moved, as sliders; null: it has none
void readAs(QWidget& widget, QAccessible::Role role, std::function<QString()> value,
            std::function<ReadRange()> range = {});

/// The value of a widget of readAs() is another one. Costs nothing where nobody reads.
void tellReader(QWidget& widget);

} // namespace knead
