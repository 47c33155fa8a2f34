#pragma once

#include "core/geometry/vec3.h"
#include "core/message/message.h"

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What was found when one exported part was read back.
struct PartExportReport {
    enum class Form {
        exact,   ///< smooth trimmed faces, one for each of the original; but see flatFaces
        faceted, ///< a solid of flat triangles
        mesh,    ///< triangles, in a mesh format
    };

    std::string name;
    Form form = Form::exact;
    Message reason;               ///< why it, or a face of it, is flat: a sentence; empty when nothing is
    std::vector<Message> remarks; ///< sentences about what a person should look at

    // Before and after.
    int solidsBefore = 0;
    int solidsAfter = 0;
    int facesBefore = 0;
    int facesAfter = 0;
    int edgesBefore = 0;
    int edgesAfter = 0;
    double restVolume = 0;       ///< of the part as imported [m^3]
    double skinVolume = 0;       ///< of the deformed skin: what the file should hold [m^3]
    double volume = 0;           ///< of what was read back [m^3]
    double restVolumeOfMesh = 0; ///< of the triangles as imported, where triangles leave; 0: not known [m^3]
    double density = 0;          ///< of its material [kg/m^3]; 0: none

    // Of the von Mises stress in the file, if it holds that.
    double largestStress = 0;    ///< [Pa]; 0: none
    double stressErrorShare = 0; ///< about how wrong that may be by the resolution, as a share of it

    // Of what was read back.
    bool valid = false;    ///< by the geometry checks; for a mesh: closed and outward
    bool wasClosed = true; ///< as imported: only then must it be closed in the file
    bool closed = false;   ///< no free edge, and can be covered with a closed net of triangles
    std::size_t freeEdges = 0;
    double maxTolerance = 0;     ///< [m]
    double tolerance = 0;        ///< allowed [m]: as asked for, or for flat faces 1/400 of the size where that is more
    double largestDeviation = 0; ///< between samples of faces and where the skin has them [m]
    double meanDeviation = 0;    ///< [m]
    std::size_t samples = 0;     ///< that were measured; 0 where nothing could be compared
    std::size_t smoothEdges = 0; ///< at which faces met without a kink, as imported, and that could be compared
    double largestKink = 0;      ///< between the normals of two faces at those now [rad]
    bool crossesItself = false;  ///< the surface passes through itself although it did not at rest
    std::optional<Vec3> fold;    ///< near where it does, or where its material is folded over itself [m]
    int keptFaces = 0;           ///< exactly where and what they were

    // Of faces that are made of flat triangles among smooth ones.
    int flatFaces = 0;               ///< of the original
    double flatTolerance = 0;        ///< allowed [m]
    double largestFlatDeviation = 0; ///< between the triangles and the skin, both ways [m]

    bool nameKept = false;
    bool colorsKept = false;

    /// Whether a person can rely on it: it is fit for use, does not pass through itself, and is smooth where it was.
    bool isSound() const;

    /// Whether it is valid, as closed as it was, and where and as large as the skin is.
    bool isFit() const;

    /// Relative error of the volume; 0 for parts without one.
    double volumeError() const;

    /// By how much the volume has changed since the part was imported, as a share of it; 0 for parts without one.
    /// Triangles are compared with triangles: chords hold less than round faces do, before and after.
    double volumeChange() const;
};

/// What came of an export.
struct ExportReport {
    std::string file;
    std::string format; ///< "STEP AP242"
    std::string unit;
    std::uint64_t bytes = 0;
    double seconds = 0; ///< that it took
    std::vector<PartExportReport> parts;
    std::vector<Message> warnings; ///< sentences about the whole

    bool isSound() const;
};

/// Largest volume error of a sound part.
inline constexpr double largestVolumeError = 2e-3;

/// Largest angle between faces that met smoothly, of a sound part [rad]: half a degree shows in reflections.
inline constexpr double largestKinkOfSoundParts = 0.5 * std::numbers::pi / 180;

/// The report as lines for a person to read.
std::vector<std::string> linesOf(const ExportReport& report);

} // namespace knead
