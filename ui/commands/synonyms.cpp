#include "ui/commands/synonyms.h"

#include <QCoreApplication>
#include <QHash>

#include <span>

namespace knead {

namespace {

struct SynonymRow {
    const char* action;
    const char* words; ///< separated by commas, for Synonyms to translate: such as people of that language use
};

std::span<const SynonymRow> synonymRows()
{
    static constexpr SynonymRow rows[] = {
        {"undo", QT_TRANSLATE_NOOP("Synonyms", "revert, back, take back, mistake")},
        {"redo", QT_TRANSLATE_NOOP("Synonyms", "again, forward, repeat")},
        {"open", QT_TRANSLATE_NOOP("Synonyms", "load, import, file, read")},
        {"save", QT_TRANSLATE_NOOP("Synonyms", "write, store, keep, project")},
        {"saveAs", QT_TRANSLATE_NOOP("Synonyms", "write as, copy, duplicate")},
        {"export", QT_TRANSLATE_NOOP("Synonyms", "STEP, IGES, STL, mesh, 3D print, print, write, convert, CAD")},
        {"pythonTrace", QT_TRANSLATE_NOOP("Synonyms", "script, macro, code, program, automate, journal")},
        {"exportRecipe", QT_TRANSLATE_NOOP("Synonyms", "script, macro, batch, automate")},
        {"applyToPart", QT_TRANSLATE_NOOP("Synonyms", "revision, version, transfer, repeat, other part")},
        {"savePicture", QT_TRANSLATE_NOOP("Synonyms", "screenshot, image, photo, snapshot, PNG, JPEG, render")},
        {"recordVideo", QT_TRANSLATE_NOOP("Synonyms", "movie, film, animation, screencast, clip")},
        {"recordPictures", QT_TRANSLATE_NOOP("Synonyms", "frames, image sequence")},
        {"pressIt", QT_TRANSLATE_NOOP("Synonyms", "demo, show me")},
        {"press", QT_TRANSLATE_NOOP("Synonyms", "push, squeeze, poke")},
        {"pull", QT_TRANSLATE_NOOP("Synonyms", "drag, tug, stretch, grab")},
        {"sculptThumb", QT_TRANSLATE_NOOP("Synonyms", "sculpt, mold, mould, clay, knead, dent, finger, groove")},
        {"sculptSmooth", QT_TRANSLATE_NOOP("Synonyms", "polish, even out, relax")},
        {"sculptFlatten", QT_TRANSLATE_NOOP("Synonyms", "flat, plane, iron")},
        {"sculptPinch", QT_TRANSLATE_NOOP("Synonyms", "crease, ridge, gather")},
        {"sculptSmear", QT_TRANSLATE_NOOP("Synonyms", "smudge, spread")},
        {"sculptBend", QT_TRANSLATE_NOOP("Synonyms", "fold, curve")},
        {"sculptTwist", QT_TRANSLATE_NOOP("Synonyms", "wring, turn, screw")},
        {"deform", QT_TRANSLATE_NOOP("Synonyms", "flex, morph, warp, deformer, free form, global modeling")},
        {"deformBend", QT_TRANSLATE_NOOP("Synonyms", "flex, curl, arc, curve, sheet metal, k-factor, tube, roll")},
        {"deformTwist", QT_TRANSLATE_NOOP("Synonyms", "wring, flex, screw, turn, helix, torsion")},
        {"deformTaper", QT_TRANSLATE_NOOP("Synonyms", "flex, cone, draft, narrow, widen")},
        {"deformStretch", QT_TRANSLATE_NOOP("Synonyms", "flex, lengthen, shorten, elongate, compress")},
        {"deformShear", QT_TRANSLATE_NOOP("Synonyms", "offset, skew, slant, joggle, sideways")},
        {"deformScale", QT_TRANSLATE_NOOP("Synonyms", "enlarge, shrink, size, grow")},
        {"deformByField", QT_TRANSLATE_NOOP("Synonyms", "displacements, FEM, FEA, CalculiX, Abaqus, warpage, "
                                                        "springback, compensation, morph, field, vtu, frd")},
        {"mirrorX", QT_TRANSLATE_NOOP("Synonyms", "mirror, both sides")},
        {"controls", QT_TRANSLATE_NOOP("Synonyms", "orbit, rotate view, turn view, pan, navigate, gestures")},
        {"fit", QT_TRANSLATE_NOOP("Synonyms", "zoom, zoom to fit, center, frame, whole part")},
        {"viewIsometric", QT_TRANSLATE_NOOP("Synonyms", "3D view, default view")},
        {"perspective", QT_TRANSLATE_NOOP("Synonyms", "orthographic, parallel, projection")},
        {"glueSelection", QT_TRANSLATE_NOOP("Synonyms", "join, bond, stick, weld, attach, fuse")},
        {"addKnife", QT_TRANSLATE_NOOP("Synonyms", "cut, slice, blade, split, saw")},
        {"addWire", QT_TRANSLATE_NOOP("Synonyms", "cheese wire, cut")},
        {"cutHere", QT_TRANSLATE_NOOP("Synonyms", "slice, split, saw, divide, halve")},
        {"section", QT_TRANSLATE_NOOP("Synonyms", "cross section, clip, cutaway, look inside")},
        {"addBlock", QT_TRANSLATE_NOOP("Synonyms", "box, cube, punch, stamp")},
        {"addBall", QT_TRANSLATE_NOOP("Synonyms", "sphere, bead")},
        {"addRoller", QT_TRANSLATE_NOOP("Synonyms", "rolling pin, roll out")},
        {"fixFaces", QT_TRANSLATE_NOOP("Synonyms", "clamp, hold, anchor, pin, constrain, support, vise")},
        {"measureDistance", QT_TRANSLATE_NOOP("Synonyms", "measure, ruler, length, gap, dimension, caliper")},
        {"measureMass", QT_TRANSLATE_NOOP("Synonyms", "weight, mass, how heavy")},
        {"measureBox", QT_TRANSLATE_NOOP("Synonyms", "size, extent, width, height")},
        {"compareWithOriginal", QT_TRANSLATE_NOOP("Synonyms", "difference, deviation, report")},
        {"placeProbe", QT_TRANSLATE_NOOP("Synonyms", "sensor, strain gauge")},
        {"forcePlot", QT_TRANSLATE_NOOP("Synonyms", "graph, chart, curve")},
        {"exportForces", QT_TRANSLATE_NOOP("Synonyms", "CSV, spreadsheet, data")},
        {"gravity", QT_TRANSLATE_NOOP("Synonyms", "fall, drop, heavy")},
        {"floor", QT_TRANSLATE_NOOP("Synonyms", "ground, table")},
        {"play", QT_TRANSLATE_NOOP("Synonyms", "run, start, simulate, pause, stop")},
        {"reset", QT_TRANSLATE_NOOP("Synonyms", "start over, rewind, restart")},
        {"findBalance", QT_TRANSLATE_NOOP("Synonyms", "equilibrium, settle, static")},
        {"renormalize", QT_TRANSLATE_NOOP("Synonyms", "forget shape, accept shape")},
        {"refillNow", QT_TRANSLATE_NOOP("Synonyms", "remesh, resolution")},
        {"keepUp", QT_TRANSLATE_NOOP("Synonyms", "real time, slow, faster")},
        {"handbook", QT_TRANSLATE_NOOP("Synonyms", "help, manual, documentation, guide, how to")},
        {"tour", QT_TRANSLATE_NOOP("Synonyms", "tutorial, learn, getting started, introduction, first steps")},
        {"shortcuts", QT_TRANSLATE_NOOP("Synonyms", "hotkeys, key bindings, keymap")},
        {"preferences", QT_TRANSLATE_NOOP("Synonyms", "settings, options, language, units, translation")},
        {"darkTheme", QT_TRANSLATE_NOOP("Synonyms", "dark mode, night mode, black")},
        {"lightTheme", QT_TRANSLATE_NOOP("Synonyms", "light mode, day mode, white")},
        {"newWindow", QT_TRANSLATE_NOOP("Synonyms", "new document, second window")},
        {"firstPage", QT_TRANSLATE_NOOP("Synonyms", "home, start page, welcome, examples")},
        {"recover", QT_TRANSLATE_NOOP("Synonyms", "crash, restore, lost work, autosave")},
        {"remove", QT_TRANSLATE_NOOP("Synonyms", "delete, erase")},
        {"hide", QT_TRANSLATE_NOOP("Synonyms", "invisible, conceal")},
        {"showAll", QT_TRANSLATE_NOOP("Synonyms", "unhide, visible")},
        {"isolate", QT_TRANSLATE_NOOP("Synonyms", "only this, solo")},
        {"objects", QT_TRANSLATE_NOOP("Synonyms", "spheres, particles")},
        {"edges", QT_TRANSLATE_NOOP("Synonyms", "lines, outline")},
        {"fullScreen", QT_TRANSLATE_NOOP("Synonyms", "maximize, presentation")},
        {"about", QT_TRANSLATE_NOOP("Synonyms", "version, license, credits")},
        {"palette", QT_TRANSLATE_NOOP("Synonyms", "search, find action")},
        {"quit", QT_TRANSLATE_NOOP("Synonyms", "exit, close, leave")},
        {"rename", QT_TRANSLATE_NOOP("Synonyms", "name, call")},
        {"partColor", QT_TRANSLATE_NOOP("Synonyms", "paint, colour, tint")},
        {"lock", QT_TRANSLATE_NOOP("Synonyms", "protect, freeze")},
        {"original", QT_TRANSLATE_NOOP("Synonyms", "undeformed, ghost")},
        {"gizmo", QT_TRANSLATE_NOOP("Synonyms", "move, rotate, arrows, transform")},
        {"driveByKeys", QT_TRANSLATE_NOOP("Synonyms", "WASD, keyboard control")},
        {"spaceMouseTool", QT_TRANSLATE_NOOP("Synonyms", "3Dconnexion, SpaceMouse, joystick")},
        {"addPart", QT_TRANSLATE_NOOP("Synonyms", "assembly, insert, merge")},
        {"show_simulationDock", QT_TRANSLATE_NOOP("Synonyms", "threads, slow motion, speed")},
        {"show_performanceDock", QT_TRANSLATE_NOOP("Synonyms", "fps, frame rate, profiler")},
        {"show_propertiesDock", QT_TRANSLATE_NOOP("Synonyms", "material, stiffness, rubber, steel")},
    };
    return rows;
}

} // namespace

QStringList synonymsOf(const QString& action)
{
    static const QHash<QString, const char*> wordsOf = [] {
        QHash<QString, const char*> all;
        for (const SynonymRow& row : synonymRows())
            all.insert(QString::fromLatin1(row.action), row.words);
        return all;
    }();
    const char* words = wordsOf.value(action, nullptr);
    if (words == nullptr)
        return {};
    QStringList synonyms;
    for (const QString& list : {QCoreApplication::translate("Synonyms", words), QString::fromUtf8(words)})
        for (const QString& word : list.split(',', Qt::SkipEmptyParts))
            synonyms << word.trimmed();
    synonyms.removeDuplicates();
    return synonyms;
}

QStringList actionsWithSynonyms()
{
    QStringList names;
    for (const SynonymRow& row : synonymRows())
        names << QString::fromLatin1(row.action);
    return names;
}

} // namespace knead
