#include "ui/dialogs/dialog_buttons.h"

#include "ui/theme.h"

#include <QDialog>
#include <QPushButton>

namespace knead {

QDialogButtonBox* makeDialogButtons(QDialog& dialog, QDialogButtonBox::StandardButton goOn, const QString& name,
                                    const QString& text)
{
    auto* buttons = new QDialogButtonBox(goOn | QDialogButtonBox::Cancel, &dialog);
    QPushButton* primary = buttons->button(goOn);
    primary->setObjectName(name);
    if (!text.isEmpty())
        primary->setText(text);
    setRole(*primary, "primary");
    for (QAbstractButton* button : buttons->buttons())
        button->setIcon({});
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return buttons;
}

} // namespace knead
