#pragma once

#include "core/geometry/triangle_mesh.h"

#include <QMetaType>
#include <QObject>

#include <optional>

class QTreeWidget;
class QTreeWidgetItem;

namespace knead {

/// What a row of a report is about, to be shown in the view.
struct ReportPlace {
    std::optional<std::size_t> part; ///< by index into Model::parts: all of it, wherever it is now
    Box box;                         ///< a place, where there is no part [m]

    static ReportPlace ofPart(std::size_t part) { return {part, {}}; }
    static ReportPlace at(const Vec3& place) { return {{}, Box(place)}; }
};

/// Gives rows of a report that are about a place a "Show me": a link in a column of their own, which Enter on the row follows, too.
/// The column is the second one that is seen, so that it is never out of sight.
class PlaceRows final : public QObject {
    Q_OBJECT
public:
    /// @param tree with all of its columns; gets another one, and owns this
    explicit PlaceRows(QTreeWidget& tree);

    /// Also while the row is shown, when its place becomes another one.
    void set(QTreeWidgetItem& row, const std::optional<ReportPlace>& place);

signals:
    void wanted(const knead::ReportPlace& place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool follow(const QTreeWidgetItem* row);

    QTreeWidget& m_tree;
    int m_column;
};

} // namespace knead

Q_DECLARE_METATYPE(knead::ReportPlace)
