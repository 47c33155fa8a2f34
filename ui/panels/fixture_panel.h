#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QLabel;

namespace knead {

/// The selected fixture: what it holds.
class FixturePanel final : public QWidget {
    Q_OBJECT
public:
    explicit FixturePanel(Document& document, QWidget* parent = nullptr);

private:
    void showFixture();

    Document& m_document;
    QLabel* m_name;
    QLabel* m_body;
    QLabel* m_faces;
    QLabel* m_objects;
};

} // namespace knead
