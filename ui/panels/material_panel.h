#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace knead {

class QuantityField;

/// What the selected body is made of, how densely it is filled, and how steps are taken. A change reaches the simulation at once, also while
/// it runs.
class MaterialPanel final : public QWidget {
    Q_OBJECT
public:
    MaterialPanel(Document& document, std::vector<MaterialPreset> presets, QWidget* parent = nullptr);

signals:
    /// The person wants the document filled with another spacing [m].
    void refillRequested(double spacing);

private:
    void makeBodyRows();
    void makeMaterialRows();
    void makeFillingRows();
    void makeStepRows();
    void documentChanged(Document::Change what);
    void showBody();
    void showMaterial();
    void showSpacing(double spacing);
    void choosePreset(int index);
    void chooseKind(int index);
    void chooseIntegrator(int index);
    void commit(double Material::*value, double number);
    void post(const QString& what);
    double cellsAcross(double spacing) const;

    Document& m_document;
    std::vector<MaterialPreset> m_presets;
    BodyId m_body = 0;
    Material m_material;     ///< as posted last
    bool m_isPosted = false; ///< until a snapshot shows it
    QLabel* m_name = nullptr;
    QLabel* m_facts = nullptr;
    QComboBox* m_kind = nullptr;
    std::optional<BodyKind> m_postedKind; ///< until a snapshot shows it
    QComboBox* m_preset = nullptr;
    std::vector<std::pair<double Material::*, QuantityField*>> m_fields;
    QuantityField* m_spacing = nullptr;
    QuantityField* m_cells = nullptr;
    QPushButton* m_refill = nullptr;
    QComboBox* m_integrator = nullptr;
    std::optional<Integrator> m_postedIntegrator; ///< until a snapshot shows it
    QLabel* m_integratorReason = nullptr;
};

} // namespace knead
