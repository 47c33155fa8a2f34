#pragma once

#include "ui/interaction/key_bindings.h"

#include <QRect>

#include <set>

class QPainter;
class QPalette;

namespace knead {

QSize keyCardsSize();

/// Which key drives which tool: a card for each with its keys as caps; those that are pressed are lit.
/// @param names of the tools; empty where there is none yet
/// @param speed a line under the cards
void drawKeyCards(QPainter& painter, const QRect& area, const std::array<QString, drivenTools>& names,
                  const std::set<int>& pressed, const QString& speed, const QPalette& palette);

} // namespace knead
