#pragma once

#include "ui/deforming/number_form.h"
#include "ui/units.h"

#include <QWidget>

#include <functional>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFormLayout;

namespace knead {

class QuantityField;

/// Where a deformation by numbers is typed: its kind, its axis, its planes, and how much there is of it. It shows a form and tells
/// when a person has changed it.
class NumberPage final : public QWidget {
    Q_OBJECT
public:
    explicit NumberPage(QWidget* parent = nullptr);

    /// Shows a form. @param hasManyParts a choice of them is offered
    void show(const NumberForm& form, const NumberSubject& subject, bool hasManyParts);
    const NumberForm& form() const { return m_form; }
    bool isOfSelected() const; ///< only the selected parts are meant

signals:
    void changed(const knead::NumberForm& form);
    void partsChanged(); ///< other ones are meant

protected:
    void changeEvent(QEvent* event) override;

private:
    void addKinds(QFormLayout* form);
    void addRows(QFormLayout* form);
    QuantityField* addField(QFormLayout* form, const QString& title, const char* name, Quantity quantity,
                            const QString& tip);
    void connectFields();
    void set(const NumberForm& form);
    void change(const std::function<void(NumberForm&)>& change);
    void showRows();
    void showValues();
    void setRowVisible(QWidget* field, bool on);

    NumberForm m_form;
    NumberSubject m_subject;
    QButtonGroup* m_kinds;
    QComboBox* m_parts;
    QComboBox* m_along;
    QComboBox* m_side;
    QuantityField* m_from = nullptr;
    QuantityField* m_to = nullptr;
    QuantityField* m_angle = nullptr;
    QuantityField* m_radius = nullptr;
    QuantityField* m_neutral = nullptr;
    QuantityField* m_neutralPlace = nullptr;
    QuantityField* m_factor = nullptr;
    QuantityField* m_length = nullptr;
    QuantityField* m_shift = nullptr;
    QComboBox* m_stays;
    QCheckBox* m_eases;
    QComboBox* m_how;
    QuantityField* m_duration = nullptr;
    QCheckBox* m_letsGo;
};

} // namespace knead
