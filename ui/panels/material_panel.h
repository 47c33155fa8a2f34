#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace knead {

class MaterialStore;
class QuantityField;

/// What the selected body is made of, what follows from it, and how densely it is filled. A change reaches the simulation at once, also while
/// it runs.
class MaterialPanel final : public QWidget {
    Q_OBJECT
public:
    /// @param store outlives the panel
    MaterialPanel(Document& document, MaterialStore& store, QWidget* parent = nullptr);

signals:
    /// The person wants the document filled with another spacing [m].
    void refillRequested(double spacing);

private:
    void makeBodyRows();
    void makePresetRows();
    void makeFirmnessRow();
    void makeFactRows();
    void makeMaterialRows();
    void makeFillingRows();
    void documentChanged(Document::Change what);
    void showBody();
    void showMaterial();
    void showPreset();
    void showSource();
    void showFacts();
    void listPresets();
    void measureSteps(const Snapshot& now);
    void askForName(const QString& title, const QString& proposed, std::function<void(const QString& name)> take);
    void rename(const std::string& id, const QString& name);
    void compare();
    std::optional<std::size_t> ownPreset() const;
    void showSpacing(double spacing);
    void choosePreset(int index);
    void layOnTable();
    void showFirmnessReading(int notch);
    void findFirmness();
    void chooseFirmness(int notch);
    void chooseKind(int index);
    void commit(double Material::*value, double number);
    void post(const Message& what);
    bool isLocked() const;
    void showWallCells(double cells);
    double cellsAcross(double spacing) const;

    Document& m_document;
    MaterialStore& m_store;
    QString m_chosenName; ///< of a preset, for when several have the same numbers
    BodyId m_body = 0;
    Material m_material;     ///< as posted last
    bool m_isPosted = false; ///< until a snapshot shows it
    QLabel* m_name = nullptr;
    QLabel* m_facts = nullptr;
    QComboBox* m_kind = nullptr;
    std::optional<BodyKind> m_postedKind; ///< until a snapshot shows it
    QComboBox* m_preset = nullptr;
    QToolButton* m_rename = nullptr;
    QToolButton* m_delete = nullptr;
    QToolButton* m_whence = nullptr; ///< shows and hides m_source
    QLabel* m_source = nullptr;
    QWidget* m_firmnessRow = nullptr;
    QSlider* m_firmness = nullptr;
    QLabel* m_firmnessReading = nullptr;
    Material m_firmBase; ///< what the slider is in the middle of
    QLabel* m_soundSpeed = nullptr;
    QLabel* m_stableStep = nullptr;
    QLabel* m_ratio = nullptr;
    QLabel* m_wallCells = nullptr;
    double m_stepSeconds = 0; ///< wall time of a step, smoothed; 0: not measured with these numbers
    Integrator m_measuredIntegrator = Integrator::automatic; ///< that it was measured with
    std::vector<std::pair<double Material::*, QuantityField*>> m_fields;
    QuantityField* m_spacing = nullptr;
    QuantityField* m_cells = nullptr;
    QPushButton* m_refill = nullptr;
};

} // namespace knead
