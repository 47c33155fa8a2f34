#pragma once

#include <QImage>
#include <QString>

namespace knead {

/// Small pictures of parts and projects of late, kept in the person's cache folder. Who clears that loses nothing else.
namespace thumbnails {

inline constexpr QSize size{480, 300}; ///< [pixels], for sharp cards of half of it

/// Null when none is kept, or the file is another one since.
QImage of(const QString& file);

/// Keeps what is seen of a file, on another thread; the oldest pictures go. Trouble with the disk leaves it without one.
void keep(const QString& file, const QImage& view);

} // namespace thumbnails

} // namespace knead
