#include "ui/interaction/hand_settings.h"

#include <QSettings>

#include <cmath>

namespace knead {

namespace {

/// A number of the settings file, where it is one in range.
void read(const QSettings& settings, const char* key, double low, double high, double& value)
{
    bool isNumber = false;
    const double read = settings.value(key).toDouble(&isNumber);
    if (isNumber && read >= low && read <= high)
        value = read;
}

} // namespace

HandSettings::HandSettings(QObject* parent)
    : QObject(parent)
{
    const QSettings settings;
    read(settings, "hands/moveStep", 1e-6, 10, m_choices.moveStep);
    read(settings, "hands/turnStep", 1e-4, 4, m_choices.turnStep);
    read(settings, "hands/keyStep", 1e-6, 10, m_choices.keyStep);
    read(settings, "hands/stepsPerSecond", 0.1, 1000, m_choices.stepsPerSecond);
    read(settings, "hands/pullStiffness", 0, 1e12, m_choices.pullStiffness);
    read(settings, "hands/pullLimit", 0, 1e12, m_choices.pullLimit);
    read(settings, "hands/spaceMouseRate", 0.1, 10, m_choices.spaceMouseRate);
    read(settings, "hands/sculptStrength", 0.1, 20, m_choices.sculptStrength);
    m_choices.mirrorX = settings.value("hands/mirrorX", false).toBool();
    m_choices.mirrorY = settings.value("hands/mirrorY", false).toBool();
    m_choices.mirrorZ = settings.value("hands/mirrorZ", false).toBool();
    m_choices.holdsRest = settings.value("hands/holdsRest", true).toBool();
    m_choices.handles = settings.value("hands/handles", true).toBool();
    m_choices.forces = settings.value("hands/forces", true).toBool();
    m_choices.ownAxes = settings.value("hands/ownAxes", false).toBool();
    m_choices.spaceMouseDrivesTool = settings.value("hands/spaceMouseDrivesTool", false).toBool();
}

void HandSettings::set(const HandChoices& choices)
{
    if (choices == m_choices)
        return;
    m_choices = choices;
    QSettings settings;
    settings.setValue("hands/handles", choices.handles);
    settings.setValue("hands/forces", choices.forces);
    settings.setValue("hands/moveStep", choices.moveStep);
    settings.setValue("hands/turnStep", choices.turnStep);
    settings.setValue("hands/keyStep", choices.keyStep);
    settings.setValue("hands/stepsPerSecond", choices.stepsPerSecond);
    settings.setValue("hands/pullStiffness", choices.pullStiffness);
    settings.setValue("hands/pullLimit", choices.pullLimit);
    settings.setValue("hands/spaceMouseRate", choices.spaceMouseRate);
    settings.setValue("hands/ownAxes", choices.ownAxes);
    settings.setValue("hands/spaceMouseDrivesTool", choices.spaceMouseDrivesTool);
    settings.setValue("hands/sculptStrength", choices.sculptStrength);
    settings.setValue("hands/mirrorX", choices.mirrorX);
    settings.setValue("hands/mirrorY", choices.mirrorY);
    settings.setValue("hands/mirrorZ", choices.mirrorZ);
    settings.setValue("hands/holdsRest", choices.holdsRest);
    emit changed();
}

} // namespace knead
