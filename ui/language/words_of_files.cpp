#include "ui/language/words_of_files.h"

#include "ui/language/phrasebook.h"

#include <QCoreApplication>
#include <QStringList>

namespace knead {

namespace {

constexpr const char* fileWords = "FileWords";

// What io and core say of files and of simulations: as they put it together, with places for what differs.
constexpr const char* const sentences[] = {
    // of a part
    QT_TRANSLATE_NOOP("FileWords", "was inside out and has been turned."),
    QT_TRANSLATE_NOOP("FileWords", "is not a closed surface: %1. It is shown and cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "is an open surface: %1. It is shown and cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "is not closed: %1. It is shown and cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "is a closed surface but no solid; it is shown and cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "could not be covered with a closed net of triangles; it cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "has no volume; it cannot be filled."),
    QT_TRANSLATE_NOOP("FileWords", "does not pass the geometry checks; look at it closely before you trust it."),
    QT_TRANSLATE_NOOP("FileWords", "has gaps of up to %1, a hundredth of its size or more."),
    QT_TRANSLATE_NOOP("FileWords", "has faces that do not meet well: its volume is uncertain by %1."),
    QT_TRANSLATE_NOOP("FileWords", "has 1 face that no triangles could be found for; it is not shown there."),
    QT_TRANSLATE_NOOP("FileWords", "has %1 faces that no triangles could be found for; it is not shown there."),
    QT_TRANSLATE_NOOP("FileWords",
                      "is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file."),
    // of its borders
    QT_TRANSLATE_NOOP("FileWords", "%1 in %2, %3 long in all; the largest opening is %4 across"),
    QT_TRANSLATE_NOOP("FileWords", "%1 in %2, %3 long in all; the largest opening is %4 across and flat"),
    QT_TRANSLATE_NOOP("FileWords", "1 open edge"),
    QT_TRANSLATE_NOOP("FileWords", "%1 open edges"),
    QT_TRANSLATE_NOOP("FileWords", "1 border"),
    QT_TRANSLATE_NOOP("FileWords", "%1 borders"),
    // what was repaired
    QT_TRANSLATE_NOOP("FileWords", "1 triangle was there twice and removed."),
    QT_TRANSLATE_NOOP("FileWords", "%1 triangles were there twice and removed."),
    QT_TRANSLATE_NOOP("FileWords", "The surface was given with both its sides; one of them was removed."),
    QT_TRANSLATE_NOOP("FileWords", "1 pair of triangles back to back was removed."),
    QT_TRANSLATE_NOOP("FileWords", "%1 pairs of triangles back to back were removed."),
    QT_TRANSLATE_NOOP("FileWords", "1 triangle faced the wrong way and was turned."),
    QT_TRANSLATE_NOOP("FileWords", "%1 triangles faced the wrong way and were turned."),
    QT_TRANSLATE_NOOP("FileWords", "1 small hole was closed, which added %1 to the area."),
    QT_TRANSLATE_NOOP("FileWords", "%1 small holes were closed, which added %2 to the area."),
    QT_TRANSLATE_NOOP("FileWords", "The surface was inside out and has been turned."),
    QT_TRANSLATE_NOOP("FileWords", "The solid was inside out and has been turned."),
    QT_TRANSLATE_NOOP("FileWords", "1 shell was inside out and turned."),
    QT_TRANSLATE_NOOP("FileWords", "%1 shells were inside out and turned."),
    QT_TRANSLATE_NOOP("FileWords", "The closed surface was made a solid."),
    QT_TRANSLATE_NOOP("FileWords", "The closed surface was made a solid, with 1 void in it."),
    QT_TRANSLATE_NOOP("FileWords", "The closed surface was made a solid, with %1 voids in it."),
    QT_TRANSLATE_NOOP("FileWords", "1 flat opening was closed with a plane face, %1 % of the area."),
    QT_TRANSLATE_NOOP("FileWords", "%1 flat openings were closed with plane faces, %2 % of the area."),
    QT_TRANSLATE_NOOP("FileWords", "Edges that failed the geometry checks were rebuilt."),
    QT_TRANSLATE_NOOP("FileWords", "1 face that failed the geometry checks was rebuilt."),
    QT_TRANSLATE_NOOP("FileWords", "%1 faces that failed the geometry checks were rebuilt."),
    QT_TRANSLATE_NOOP("FileWords", "1 separate face was sewn with a tolerance of %1."),
    QT_TRANSLATE_NOOP("FileWords", "%1 separate faces were sewn with a tolerance of %2."),
    QT_TRANSLATE_NOOP("FileWords",
                      "1 separate face was sewn with a tolerance of %1; the widest gap between two of them is %2."),
    QT_TRANSLATE_NOOP("FileWords",
                      "%1 separate faces were sewn with a tolerance of %2; the widest gap between two of them is %3."),
    // of the file
    QT_TRANSLATE_NOOP("FileWords",
                      "%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that "
                      "wrote it."),
    QT_TRANSLATE_NOOP("FileWords",
                      "%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that "
                      "wrote it."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the file states no length unit; millimetres were taken."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the entity %2 refers to something of the wrong kind or nothing at all; what "
                                   "needs it could not be read (faces: %3)."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the entity %2 refers to something of the wrong kind or nothing at all; what "
                                   "needs it could not be read (shapes: %3)."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at "
                                   "all; what needs them could not be read (faces: %4)."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at "
                                   "all; what needs them could not be read (shapes: %4)."),
    QT_TRANSLATE_NOOP("FileWords", "%1: a turned face is bounded across its seam, and the file does not tell on which "
                                   "side of its border it lies; check the volume of its part."),
    QT_TRANSLATE_NOOP("FileWords", "the assembly refers to the file %1, which is not there: its parts are missing. Put "
                                   "it beside the assembly and open that again."),
    QT_TRANSLATE_NOOP("FileWords", "the assembly refers to %1 files that are not there: %2. Their parts are missing; "
                                   "put them beside the assembly and open that again."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the reader crashed on what the file says beside its shapes; these were read "
                                   "without names, colors and assemblies, and without other files that it refers to."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the file mixes the length units %2 and %3; check the sizes of the parts."),
    QT_TRANSLATE_NOOP("FileWords", "%1: its schema \"%2\" is none for CAD parts; check that nothing is missing."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the part is %2 long; if its lengths are %3, it is %4."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the parts together are %2 long; if their lengths are %3, they are %4."),
    QT_TRANSLATE_NOOP("FileWords",
                      "%1: the part is %2 long; if its lengths are %3, it is %4. Open that file alone to correct it."),
    QT_TRANSLATE_NOOP("FileWords", "%1: the parts together are %2 long; if their lengths are %3, they are %4. Open "
                                   "that file alone to correct it."),
    QT_TRANSLATE_NOOP("FileWords", "millimetres"),
    QT_TRANSLATE_NOOP("FileWords", "centimetres"),
    QT_TRANSLATE_NOOP("FileWords", "metres"),
    QT_TRANSLATE_NOOP("FileWords", "inches"),
    QT_TRANSLATE_NOOP("FileWords", "feet"),
    QT_TRANSLATE_NOOP("FileWords", "micrometres"),
    QT_TRANSLATE_NOOP("FileWords", "decimetres"),
    QT_TRANSLATE_NOOP("FileWords", "kilometres"),
    QT_TRANSLATE_NOOP("FileWords", "miles"),
    // what is missing
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" has no triangles."),
    QT_TRANSLATE_NOOP("FileWords", "1 shape of the STEP file could not be read: its faces are damaged or of an unknown "
                                   "kind."),
    QT_TRANSLATE_NOOP("FileWords", "%1 shapes of the STEP file could not be read: its faces are damaged or of an "
                                   "unknown kind."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" was left out: %2."),
    QT_TRANSLATE_NOOP("FileWords", "it has no finite size: numbers in it are damaged, or its edges are smaller than "
                                   "0.1 um and lost; check the length unit"),
    QT_TRANSLATE_NOOP("FileWords",
                      "it reaches farther than 100 km from the origin; check the length unit and the position"),
    QT_TRANSLATE_NOOP("FileWords", "its faces lead far away from their edges: numbers in it are damaged"),
    QT_TRANSLATE_NOOP("FileWords", "it is smaller than a micrometre; check the length unit"),
    QT_TRANSLATE_NOOP("FileWords", "its faces and edges are up to %1 apart, at a size of %2"),
    QT_TRANSLATE_NOOP("FileWords", "the solid has no volume"),
    QT_TRANSLATE_NOOP("FileWords", "it could not be measured (%1)"),
    // of the filling
    QT_TRANSLATE_NOOP("FileWords", "Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too "
                                   "stiff. Fill with a spacing of %4 for %5 cells, about %6 objects."),
    QT_TRANSLATE_NOOP("FileWords", "Thinnest walls: %1 cells across %2; bending of such walls comes out many times too "
                                   "stiff. Fill with a spacing of %3 for %4 cells, about %5 objects."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" is not simulated: %2"),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" has no surface, so it is not shown."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" is not a closed solid: it is shown, and not simulated. Close its surfaces "
                                   "and import it again."),
    QT_TRANSLATE_NOOP("FileWords", "A spacing of %1 needs more than %2 objects. Choose a larger spacing."),
    QT_TRANSLATE_NOOP("FileWords",
                      "The part has no triangles, so there is nothing to fill. Import a part with a surface."),
    QT_TRANSLATE_NOOP("FileWords",
                      "A vertex of the surface is not at a finite place. Repair the file and import again."),
    QT_TRANSLATE_NOOP(
        "FileWords",
        "The surface is not closed: %1 edges of triangles have no partner. Close the gaps and import again."),
    QT_TRANSLATE_NOOP("FileWords", "The surface does not bound a volume: its holes are too large to tell inside from "
                                   "outside. Close them and import again."),
    QT_TRANSLATE_NOOP(
        "FileWords",
        "The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing."),
    // of what is written
    QT_TRANSLATE_NOOP("FileWords", "its surface passes through itself near %1; other programs may refuse that."),
    QT_TRANSLATE_NOOP("FileWords", "%1 of its faces could not be carried along: %2."),
    QT_TRANSLATE_NOOP("FileWords", "an edge has no curve on its face"),
    QT_TRANSLATE_NOOP("FileWords", "an edge has a curve on its face that does not match it"),
    QT_TRANSLATE_NOOP("FileWords", "a face has no surface"),
    QT_TRANSLATE_NOOP("FileWords", "a face has no border"),
    QT_TRANSLATE_NOOP("FileWords", "a face is degenerate"),
    QT_TRANSLATE_NOOP("FileWords", "its faces do not fit together any more as they are bent now."),
    QT_TRANSLATE_NOOP(
        "FileWords",
        "\"%1\": face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off."),
    QT_TRANSLATE_NOOP(
        "FileWords",
        "\"%1\": %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off."),
    QT_TRANSLATE_NOOP("FileWords", "1 face was added: those that close in themselves came in two, which other programs "
                                   "read more surely."),
    QT_TRANSLATE_NOOP("FileWords", "%1 faces were added: those that close in themselves came in two, which other "
                                   "programs read more surely."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\": face %2 is made of flat triangles; its other faces are smooth."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\": faces %2 are made of flat triangles; its other faces are smooth."),
    QT_TRANSLATE_NOOP("FileWords", "it came as a mesh, which has no smooth faces."),
    QT_TRANSLATE_NOOP("FileWords",
                      "faces that met smoothly now meet at an angle near %1; a smaller tolerance may help."),
    QT_TRANSLATE_NOOP("FileWords", "The file holds %1 parts where %2 were written."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" is cracked but in one piece: 1 of its connections is broken, and its skin "
                                   "spans the crack, stretched to %2 times its length there near %3."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" is cracked but in one piece: %2 of its connections are broken, and its skin "
                                   "spans the crack, stretched to %3 times its length there near %4."),
    QT_TRANSLATE_NOOP("FileWords", "too few of its objects hang together to say how it is deformed: it is written in "
                                   "its shape at rest, moved as they have."),
    QT_TRANSLATE_NOOP("FileWords", "its cracks could not be made into surfaces: other pieces of it are written as one "
                                   "with it; objects in them: %1."),
    QT_TRANSLATE_NOOP("FileWords",
                      "pieces too small for a shape of their own are written as part of it; objects in them: %1."),
    QT_TRANSLATE_NOOP("FileWords", "its bent faces were not found again in the file when that was read back."),
    QT_TRANSLATE_NOOP("FileWords", "its faces were not found again as they were written."),
    QT_TRANSLATE_NOOP("FileWords", "the part is torn; this is one of %1 pieces."),
    QT_TRANSLATE_NOOP("FileWords", "read back from the file, its bent faces do not pass the geometry checks."),
    QT_TRANSLATE_NOOP("FileWords", "read back from the file, its bent faces leave gaps."),
    QT_TRANSLATE_NOOP("FileWords", "read back from the file, its bent faces are inside out."),
    QT_TRANSLATE_NOOP("FileWords", "other programs may read it inside out, as it came back here."),
    QT_TRANSLATE_NOOP("FileWords",
                      "read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed."),
    QT_TRANSLATE_NOOP("FileWords",
                      "read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed."),
    QT_TRANSLATE_NOOP("FileWords",
                      "read back from the file, its bent faces enclose a volume %1 % off that of the skin."),
    QT_TRANSLATE_NOOP("FileWords",
                      "\"%1\" would need %2 flat faces, more than CAD programs can work with; export it as a mesh."),
    QT_TRANSLATE_NOOP("FileWords",
                      "\"%1\" is an open mesh, which CAD files cannot hold; hide it, or export as a mesh."),
    // of a simulation that stopped
    QT_TRANSLATE_NOOP("FileWords", "The simulation was stopped at %1 s: %2 It went back to %3 s."),
    QT_TRANSLATE_NOOP("FileWords", "a position is no longer a number. %1 or make the material softer, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "objects moved at %1 m/s. %2 or raise the damping ratio, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "Make the tools slower"),
    QT_TRANSLATE_NOOP("FileWords", "Lower gravity"),
    QT_TRANSLATE_NOOP("FileWords", "Move bodies and fixtures slower"),
    QT_TRANSLATE_NOOP("FileWords",
                      "material of %1 was squashed flat or turned inside out. Press less far, raise Poisson's ratio or "
                      "the yield stress, or fill the part with a smaller spacing, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "the body"),
    QT_TRANSLATE_NOOP("FileWords", "objects of %1 moved at %2 m/s, and nothing in the scene makes them faster than %3 "
                                   "m/s. %4 or raise the damping ratio, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the "
                                   "material. %3 or raise the damping ratio, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "the equations of %1 steps in a row could not be solved, though the last was only "
                                   "%2 s long. %3 or raise the damping ratio, then reset."),
    QT_TRANSLATE_NOOP("FileWords",
                      "The tool \"%1\" is %2 mm deep in %3: let it begin outside and press less far, make it slower"),
    QT_TRANSLATE_NOOP("FileWords", "Choose a shorter time step for mass scaling, which added %1 % to the mass"),
    QT_TRANSLATE_NOOP("FileWords", "there is not enough memory to go on. Close other programs or fill the part with a "
                                   "larger spacing, then reset."),
    QT_TRANSLATE_NOOP("FileWords", "%1 Reset, or go to an earlier moment."),
    QT_TRANSLATE_NOOP("FileWords", "The simulation was stopped: %1"),
    QT_TRANSLATE_NOOP("FileWords", "The tool \"%1\" begins %2 mm inside %3, which is pushed away with great force, in "
                                   "very short steps. Let it begin outside."),
    QT_TRANSLATE_NOOP("FileWords", "\"%1\" broke into %2 pieces, and a rigid body would weld them together where they "
                                   "are. Keep it deformable, or reset before it becomes rigid."),
    QT_TRANSLATE_NOOP("FileWords", "The equations of the step at %1 s could not be solved: forces and places are rough "
                                   "from there on. Make tools slower, or choose a shorter time step."),
    // of how far a run may be trusted
    QT_TRANSLATE_NOOP("FileWords",
                      "Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools "
                      "slower."),
    QT_TRANSLATE_NOOP("FileWords",
                      "Tools or the floor went %1 spacings into material: shapes and forces there are rough. "
                      "Press less far, or choose a smaller spacing."),
    QT_TRANSLATE_NOOP("FileWords",
                      "Mass scaling made %1 % of the mass: what swings and what is thrown is slower than it "
                      "would be. Choose a shorter time step for it."),
    // of a balance that was not found
    QT_TRANSLATE_NOOP("FileWords",
                      "A body is free to move: hold it, or let time run (dynamic) until it rests on something."),
    QT_TRANSLATE_NOOP("FileWords",
                      "%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic)."),
    QT_TRANSLATE_NOOP("FileWords",
                      "No balance was found at %1 s: forces of %2 of those that act are left. Take more load "
                      "steps or a smaller load, hold what is free to slide or turn, or let time run "
                      "(dynamic)."),
    QT_TRANSLATE_NOOP("FileWords", "the chosen time step of %1 s is longer than the stable one of %2 s. Choose a "
                                   "shorter one, or a softer or more damped material."),
};

const Phrasebook& wordsOfFiles()
{
    static const Phrasebook book = [] {
        Phrasebook made;
        for (const char* sentence : sentences)
            made.add(QString::fromUtf8(sentence), {fileWords, sentence, {}});
        return made;
    }();
    return book;
}

} // namespace

QString inWords(const std::string& sentence)
{
    return wordsOfFiles().translated(QString::fromStdString(sentence), {fileWords}, [](const Phrase& phrase, int) {
        return QCoreApplication::translate(phrase.context, phrase.source);
    });
}

QStringList sentencesOfFiles()
{
    QStringList all;
    for (const char* sentence : sentences)
        all << QString::fromUtf8(sentence);
    return all;
}

} // namespace knead
