#pragma once

#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace knead {

class MaterialStore;
class QuantityField;

/// The selected faces, edges, objects, connections or parts: how much they are, and what can be done to them.
class SelectionPanel final : public QWidget {
    Q_OBJECT
public:
    /// @param store outlives the panel
    SelectionPanel(Document& document, const MaterialStore& store, QWidget* parent = nullptr);

    void fix();
    void renormalize();
    void glue();
    /// Asks for the distance, and for the name, in their fields.
    void beginWithin();
    void beginKeeping();

signals:
    /// All that lies within a distance [m] of the selection is wanted.
    void withinRequested(double distance);
    /// How much is selected, in words: whenever that is another, and now and then while time runs.
    void read(const QString& words);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeHead();
    void makeMaterialRows();
    void makeRegionRows();
    void listPresets();
    void showRegion();
    void showSize();
    void choosePreset(int index);
    void postMaterial(const Message& name);
    void keep();

    Document& m_document;
    const MaterialStore& m_store;
    Material m_material; ///< as it would be given
    QElapsedTimer m_sinceSize;
    qint64 m_rest = 0; ///< until it is read again while time runs [ms]
    QLabel* m_words = nullptr;
    QLabel* m_bodies = nullptr;
    QPushButton* m_fix = nullptr;
    QComboBox* m_preset = nullptr;
    std::vector<std::pair<double Material::*, QuantityField*>> m_fields;
    QuantityField* m_distance = nullptr;
    QLineEdit* m_name = nullptr;
};

} // namespace knead
