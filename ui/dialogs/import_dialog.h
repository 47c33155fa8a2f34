#pragma once

#include "core/model/file_preview.h"
#include "core/session/filled_model.h"

#include <QDialog>

#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QSpinBox;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace knead {

class QuantityField;

/// Shows what files hold, before the work of opening them, and asks which of it a person wants and how.
class ImportDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param previews at least one
    explicit ImportDialog(std::vector<FilePreview> previews, QWidget* parent = nullptr);

    /// The choices as they stand.
    ImportChoices request() const;

private:
    QWidget* makeFacts();
    QWidget* makeParts();
    QWidget* makeChoices();
    void addFineness(QFormLayout* form);
    void addLimits(QFormLayout* form);
    void addNodes(const PartNode& node, const QString& path, QTreeWidgetItem* parent);
    void itemChanged(QTreeWidgetItem* item);
    void checkAll(bool checked);
    void addChosen(const QTreeWidgetItem* item, std::vector<std::string>& paths) const;
    void showChosen();

    std::vector<FilePreview> m_previews;
    QTreeWidget* m_parts = nullptr; ///< none when there is nothing to choose from
    QLabel* m_chosen = nullptr;
    QComboBox* m_detail = nullptr;
    QComboBox* m_unit = nullptr;
    QComboBox* m_fineness = nullptr;
    QStackedWidget* m_values = nullptr; ///< one page per choice of fineness
    QSpinBox* m_objects = nullptr;
    QSpinBox* m_cells = nullptr;
    QuantityField* m_spacing = nullptr;
    QComboBox* m_touching = nullptr;
    QCheckBox* m_fillsOpen = nullptr;
    QSpinBox* m_minutes = nullptr;
    QSpinBox* m_gibibytes = nullptr;
    QCheckBox* m_heal = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
    bool m_isUpdating = false;
};

} // namespace knead
