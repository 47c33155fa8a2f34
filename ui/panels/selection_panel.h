#pragma once

#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace knead {

class QuantityField;

/// The selected faces, edges, objects, connections or parts: how much they are, and what can be done to them.
class SelectionPanel final : public QWidget {
    Q_OBJECT
public:
    SelectionPanel(Document& document, std::vector<MaterialPreset> presets, QWidget* parent = nullptr);

    void fix();
    void renormalize();
    void glue();
    /// Asks for the distance, and for the name, in their fields.
    void beginWithin();
    void beginKeeping();

signals:
    /// All that lies within a distance [m] of the selection is wanted.
    void withinRequested(double distance);

private:
    void makeHead();
    void makeMaterialRows();
    void makeRegionRows();
    void showRegion();
    void showSize();
    void choosePreset(int index);
    void postMaterial(const QString& name);
    void keep();

    Document& m_document;
    std::vector<MaterialPreset> m_presets;
    Material m_material; ///< as it would be given
    QElapsedTimer m_sinceSize;
    QLabel* m_words = nullptr;
    QLabel* m_bodies = nullptr;
    QPushButton* m_fix = nullptr;
    QComboBox* m_preset = nullptr;
    std::vector<std::pair<double Material::*, QuantityField*>> m_fields;
    QuantityField* m_distance = nullptr;
    QLineEdit* m_name = nullptr;
};

} // namespace knead
