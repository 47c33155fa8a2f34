#pragma once

#include <QIcon>
#include <QString>

class QApplication;
class QWidget;

namespace knead {

enum class Theme { Light, Dark };

/// Gives the whole program the look of a theme; may be called again at any time.
/// @param textPercent size of texts, in per cent of what the system asks for
void applyTheme(QApplication& application, Theme theme, int textPercent = 100);

/// The same for the size of texts alone. Before a window is made: what was made and never shown keeps the size that it has.
void applyTextSize(int textPercent);

/// A length in pixels that has room for text: it grows as texts do.
int withText(int pixels);

/// Gives a widget one of the looks that the style sheet has: "dimmed", "heading", "primary", ...; also one that was drawn.
void setRole(QWidget& widget, const char* role);

/// An icon of ours, drawn in the text color of the present theme, sharp at any size.
/// @param name of a file in resources/icons without its ending
QIcon icon(const QString& name);

} // namespace knead
