#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace knead {

/// The handbook, as the program carries it: pages in Markdown from resources/handbook.
namespace handbook {

struct Page {
    QString name;  ///< of its file, without the ending
    QString title; ///< its first line
    QString text;  ///< Markdown, whole
    QString words; ///< the same without the marks, as it is read
};

/// In the order in which they are read.
const std::vector<Page>& pages();

/// Null: there is no such page.
const Page* pageNamed(const QString& name);

/// How often a page has words: those of `wanted`, each of which it must have.
qsizetype hitsIn(const Page& page, const QString& wanted);

/// The page that is about a panel, a dialog or the first page. @param name of it as an object
/// @return empty: there is none about that
QString pageOfPlace(const QString& name);

} // namespace handbook

} // namespace knead
