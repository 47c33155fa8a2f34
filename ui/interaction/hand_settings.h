#pragma once

#include "core/geometry/vec3.h"

#include <QObject>

namespace knead {

/// How hands move tools and pull material. A value; SI.
struct HandChoices {
    bool handles = true; ///< shown on the selected tool
    bool forces = true;  ///< shown on tools

    double moveStep = 0.001;     ///< to which moves snap with Ctrl [m], > 0
    double turnStep = 0.0872665; ///< to which turns snap with Ctrl [rad], > 0
    bool ownAxes = false;        ///< handles along the tool's own axes, not the world's

    double keyStep = 0.001;     ///< that a key press moves a tool [m], > 0
    double stepsPerSecond = 20; ///< while a key is held, > 0

    double pullStiffness = 0; ///< of the spring between hand and material [N/m]; 0: goes by the material
    double pullLimit = 0;     ///< the hand does not pull harder [N]; 0: goes by the material

    double sculptRadius = 0;   ///< of brushes [m]; 0: goes by the part. Not kept from session to session
    double sculptStrength = 1; ///< of brushes, in forces that suit the material, 0.1 .. 20
    bool mirrorX = false;      ///< brushes do the same across the plane x = middle of the part
    bool mirrorY = false;
    bool mirrorZ = false;
    bool holdsRest = true; ///< the other hand holds what is far from a brush, where nothing else holds the part

    bool spaceMouseDrivesTool = false; ///< else the camera
    double spaceMouseRate = 1;         ///< of its speeds, 0.1 .. 10

    double keySpeed() const { return keyStep * stepsPerSecond; } ///< [m/s]
    friend bool operator==(const HandChoices&, const HandChoices&) = default;
};

/// The choices of the person, kept from session to session. Window thread only.
class HandSettings final : public QObject {
    Q_OBJECT
public:
    explicit HandSettings(QObject* parent = nullptr);

    const HandChoices& choices() const { return m_choices; }
    void set(const HandChoices& choices);

signals:
    void changed();

private:
    HandChoices m_choices;
};

} // namespace knead
