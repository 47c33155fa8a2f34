#pragma once

#include "ui/interaction/hand_settings.h"
#include "ui/units.h"

#include <QWidget>

#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;

namespace knead {

class QuantityField;

/// How tools are moved by hand: steps, speeds, the spring, the 3D mouse.
class HandPanel final : public QWidget {
    Q_OBJECT
public:
    HandPanel(HandSettings& settings, const QList<QAction*>& modes, QWidget* parent = nullptr);

    void showSpaceMouse(bool isConnected);

private:
    /// A number of the choices.
    struct Number {
        QuantityField* field;
        double HandChoices::*value;
    };

    void add(const QString& title, const char* name, Quantity quantity, double low, double high,
             double HandChoices::*value, const QString& tip);
    void showChoices();

    HandSettings& m_settings;
    std::vector<Number> m_numbers;
    QCheckBox* m_ownAxes;
    QCheckBox* m_holdsRest;
    QComboBox* m_spaceMouse;
    QLabel* m_connection;
};

} // namespace knead
