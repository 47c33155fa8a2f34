#pragma once

#include <QStringList>

namespace knead {

/// Files that were opened or saved last, the latest first; kept in the settings of the person.
namespace recent_files {

inline constexpr int most = 10;

QStringList list();
void add(const QString& path);
void remove(const QString& path); ///< it is not there any more
void clear();

} // namespace recent_files

} // namespace knead
