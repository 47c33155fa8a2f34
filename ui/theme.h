#pragma once

#include <QIcon>
#include <QString>

class QApplication;

namespace knead {

enum class Theme { Light, Dark };

/// Gives the whole program the look of a theme; may be called again at any time.
void applyTheme(QApplication& application, Theme theme);

/// An icon of ours, drawn in the text color of the present theme, sharp at any size.
/// @param name of a file in resources/icons without its ending
QIcon icon(const QString& name);

} // namespace knead
