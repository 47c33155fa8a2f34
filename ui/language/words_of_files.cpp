#include "ui/language/words_of_files.h"

#include "ui/language/phrasebook.h"

#include <QCoreApplication>
#include <QStringList>

namespace knead {

namespace {

constexpr const char* fileWords = "FileWords";

// What core says of simulations: as it puts it together, with places for what differs.
constexpr const char* const sentences[] = {
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
