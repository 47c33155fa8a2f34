#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// How what yields keeps its volume.
///
/// An object's J is that of the mean gradient around it. Where cells shear within that mean, their volume falls behind that of the
/// objects: by 0.5 to 1.5 % in clay pressed by half with friction, however fine. What a body has without pressure,
/// V0 = sum V e^rest, stays what it was; rest dilatations of what has flowed follow so that its surface encloses
///     V0 (sum V J) / (sum V e^rest),
/// J by e^rest being what pressure makes of it. What does not flow has a shape at rest for good: bodies with such material in them are
/// not to be asked for this.

/// sum V e^rest [m^3].
double volumeAtRest(const ConnectionData& data);

/// V0 [m^3].
inline double keptVolume(const ConnectionData& data)
{
    return data.changes.keptVolume > 0 ? data.changes.keptVolume : volumeAtRest(data);
}

/// Share of the volume of a body that has flowed so far that it takes part, 0 .. 1: none of an object up to an equivalent plastic
/// strain of 0.1, all of it from 0.3 on.
double flowedShare(const ConnectionData& data);

/// Moves rest dilatations by a step towards where the surface encloses that volume: by a thousandth of ln V at most, less where a
/// material would feel it as more than 0.3 of its yield stress, and by 0.03 of what has flowed in all.
/// @param enclosed by the surface, by what it enclosed when the body was filled
/// @return energy that this took out of it [J]; 0 where nothing is to be done
/// @pre flowedShare(data) > 0
double keepVolume(ConnectionData& data, const VectorArray& position, double enclosed);

} // namespace knead
