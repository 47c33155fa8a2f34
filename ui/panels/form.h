#pragma once

#include "ui/panels/quantity_field.h"

#include <QFormLayout>
#include <QString>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;

namespace knead {

/// Small helpers with which all property panels are laid out alike.
QFormLayout* makeForm(QWidget* owner);
QLabel* makeHeading(const QString& text, QWidget* parent);
QLabel* makeReading(const QString& name, QWidget* parent); ///< a value that is shown, not typed
/// Scrolling over it does not choose.
QComboBox* makeChoice(const QString& name, QWidget* parent);
/// A box that is the action in another form.
QCheckBox* boxFor(QAction* action, QWidget* parent);
QuantityField* makeField(Quantity quantity, const QString& name, QWidget* parent);

} // namespace knead
