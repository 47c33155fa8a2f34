#pragma once

#include "core/session/measurement.h"

#include <QString>

#include <vector>

namespace knead {

/// What a click must meet.
enum class PickWhat { place, face, body };

/// What a person has to be told of a way of measuring.
struct MeasureLook {
    MeasureKind kind;
    const char* name; ///< of its action
    const char* text; ///< in menus and lists
    const char* tip;
    const char* icon;
    std::vector<PickWhat> picks; ///< that it takes, in order
};
const std::vector<MeasureLook>& measureLooks(); ///< in the order of MeasureKind
const MeasureLook& lookOf(MeasureKind kind);

/// "Distance 2"
QString nameOf(const Measurement& measurement);

/// What stands beside its mark in the view; empty where nothing was measured.
QString textOf(const Measurement& measurement, const Measured& measured);

/// A sentence about how far the numbers can be trusted, or why there are none; empty: nothing to say.
QString remarkOn(const Measured& measured);

} // namespace knead
