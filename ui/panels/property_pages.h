#pragma once

#include <QStackedWidget>

namespace knead {

class Document;
class MaterialStore;

/// Properties of what is selected: a page for each Selection::Kind, in its order. The last one, of regions, is added by whoever
/// selects them. Window thread only.
class PropertyPages final : public QStackedWidget {
    Q_OBJECT
public:
    PropertyPages(Document& document, MaterialStore& materials, QWidget* parent);

signals:
    /// The bodies shall be filled anew. @param spacing [m]
    void refillRequested(double spacing);
};

} // namespace knead
