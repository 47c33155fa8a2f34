#pragma once

#include <QDialogButtonBox>

class QDialog;

namespace knead {

/// Buttons for the bottom of a dialog: one that goes on, which stands out, and Cancel. They have no pictures.
/// @param name of the one that goes on
/// @param text of it; empty: as Qt has it
QDialogButtonBox* makeDialogButtons(QDialog& dialog, QDialogButtonBox::StandardButton goOn, const QString& name,
                                    const QString& text = {});

} // namespace knead
