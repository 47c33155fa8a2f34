#pragma once

#include <cstddef>
#include <cstdint>

// The numbers that steer the solvers, each with what follows from it. They are part of what a run does, bit for bit:
// whoever changes one changes all runs that are repeated from recipes and projects. Numbers of the physics are not
// among them, nor what only says when to stop or to warn.
namespace knead {

/// Steps of the explicit schemes.
struct ExplicitSettings {
    /// Share of the stable step that is used. The rest is for what the linear analysis leaves out: stiffening under
    /// large compression or stretch, and more than one contact on an object.
    double timeStepShare = 0.8;
    /// Where something stiffens, nothing goes further than this in a step [spacings], unless steps would be shorter
    /// than this share of the stable one. Further: energy from nowhere in blows; less: more steps.
    double farthestInStep = 0.05;
    double shortestShare = 1.0 / 32;
    /// A tool that goes further than this in a step, short as it is, has jumped, as key frames may have it
    /// [spacings].
    double jump = 0.5;
    /// The stable step depends on the shape, so it is found again this often [steps]. It costs about a step.
    std::uint64_t timeStepInterval = 256;
    /// With more contacts on an object at a time than the time step allows for, the step is found again with so much
    /// to spare.
    double crowdingReserve = 1.5;

    // What is slower than a step is done in every so-manieth only, where its cost disappears [steps].
    std::uint64_t shapeDampingInterval = 16;
    std::uint64_t flowInterval =
        4; ///< plastic flow goes with the time of the material; the ledger is off by part of it
    std::uint64_t breakingInterval = 4;
    std::uint64_t annealingInterval = 16; ///< and recovery
    std::uint64_t touchingInterval = 16;  ///< ends of broken connections may touch things from there on
};

/// How long steps of the implicit scheme are, and how they are taken.
struct ImplicitStepSettings {
    /// In a step nothing may go further than this [spacings], so that what is met within it is still on the right
    /// side.
    double travelShare = 0.5;
    /// A step that moved something further than this is taken again at half the length [spacings].
    double farthestShare = 1.25;
    /// Steps are halved so often at most, which is a quarter of a millisecond.
    int mostHalvings = 6;
    /// Before a step is made longer again, speeds must be so much below what it allows: the factor of the system
    /// would be found anew with every change.
    double calmShare = 0.9;
    /// A hand that begins to push as hard as it may within a step is ahead of its tool by so much [spacings]: less is
    /// a stiffer system, more lets tools lag behind.
    double handGive = 0.02;
    /// So near to its force limit a tool is taken to be held up, and to go on as slowly as in the last step.
    double stalledShare = 0.05;
    /// A crack runs on within a step so many times at most. Each time a system is solved for what is left; what it
    /// does not come to runs on in the next step.
    int mostBreakingRounds = 24;
};

/// Newton's method of an implicit step.
///
/// A step is done at its tolerance (PaceNumbers): a share of the residual at its start, by the preconditioned norm.
/// What a step leaves is in the forces at the start of the next, so that a body at rest gets as near to balance as
/// rounding allows, whatever that is.
struct NewtonSettings {
    int mostIterations = 12;
    /// Linear systems are solved to a share of it that is the same for all: friction is fitted to what they give.
    double linearTolerance = 5e-3;
    /// One only so far, by what is there, as the last one served. The first, and the least of later ones. What turns freely gains
    /// energy from what is left out.
    double looseTolerance = 0.1;
    double laterTolerance = 0.03;
    /// The same where something touches and the step begins far from balance: contacts open and close, and slides turn, so that it leads
    /// to others anyway. Solved further, they cost about a fifth more iterations, and there are as many of them. Not those that are
    /// likely the last of a step, which make its accuracy, and not the later ones where material flows: its tangent is what is wrong
    /// there, and mixing makes of well solved systems what would be right.
    double touchingTolerance = 0.3;
    double laterTouchingTolerance = 0.12;
    double singleTolerance = 1e-3; ///< no solution goes further in single precision
    /// To which what is small already is solved, where pieces as a whole lack more than they may.
    double smallTolerance = 1e-2;
    /// Where something touches, springs that do not flow are linearized anew in every so-manieth iteration only, as contacts change
    /// more from one to the next; and where something has gone further since than this [spacings], as what turns does.
    int tangentInterval = 3;
    double tangentReach = 0.1;
    /// Of the tolerance: share of what acts in the step at which it is done as well. What is near balance as it is
    /// costs no solution.
    double loadShare = 0.1;
    double failedTolerance = 0.3; ///< above which a step has failed, and is halved
    /// Of what was there before the first solution, so much is always enough to compare with: a body that is just let
    /// go of by all it touched has loads of nothing.
    double leastReference = 1e-6;
    double leastFreeReference = 1e-4; ///< where nothing touches
    /// Bodies that would move slower than this, in spacings per step, are at rest: no system is solved for less.
    double restShare = 1e-8;
    /// Contacts are taken to be as steep at most as so much more than the deepest one of the last step makes them,
    /// until those of the solution are deeper.
    double steeperShare = 1.2;
    /// Slides slower than this stick [spacings per step]: their friction is proportional to the speed.
    double stickShare = 3e-4;

    /// A hand at its force limit does not answer to ways along the force. This much is taken off what it would
    /// answer, so that Newton's method does not go far beyond where the limit ends.
    double handSlack = 0.9;

    // A line is searched until the force along it is this share of what it was, in so many trials; each within these
    // shares of where it must be. A trial costs the forces once, an iteration that went too far a solution.
    double lineTolerance = 0.5;
    int mostTrials = 6;
    double nearestTrial = 0.1;
    double farthestTrial = 0.9;

    // Share of what touches a piece that it may lack as a whole; and towards what it stands on, which makes up for
    // that in the next step. More: pieces drift and turn; less: more solutions.
    double wholeTolerance = 3e-3;
    double pushedTolerance = 3e-2;
    double flyingShare = 0.1; ///< of its momentum, what a piece that flies is compared with where it weighs less
    /// Steps that end with more than that are halved up to so often: long ones find no slide that steep contacts answer to, and a steel
    /// block would stop on a slope, held by twice the friction that there is. What only grazes something is compared with this share of
    /// the momentum that it gains.
    int mostWholeHalvings = 4;
    double leastGain = 0.1;
    double flatShare = 0.999; ///< of normals that add up, where a piece stands on something flat
};

/// Anderson mixing of Newton iterations.
struct MixingSettings {
    std::size_t mostDifferences = 6; ///< that are remembered: more gain little and take memory
    /// Of the largest diagonal entry, added to all: differences that are nearly the same must not cancel by large
    /// factors.
    double regularization = 1e-10;
    double lost = 1; ///< iterations that make the residual so much larger, squared, are forgotten and begun anew
};

/// The linear systems of an implicit step: conjugate gradients with the preconditioner of rigid modes.
struct LinearSettings {
    int mostIterations = 400; ///< for one system
    /// Where something slips, so many vectors are kept at most, and it begins anew then. More: memory, 12 bytes per object and vector;
    /// less: more iterations of bodies that are pushed and slender.
    std::size_t mostKept = 24;
    /// What nothing holds is solved for without that where contacts are so many times as stiff, in the step, as it has mass: a slide
    /// would follow the rounding of its pressure, which friction multiplies, and a steel block slides by a tenth of its way.
    double mostDragged = 30;
    /// Tools have no mass. In the system they have this share of what their hands do, so that it stays positive.
    double handMassShare = 1e-4;
    // The coarse factor is found again when iterations per decade have grown by this factor and so many since it was
    // new.
    double staleFactor = 1.5;
    double staleMore = 3;
    // Solutions that go no further than this tell nothing of that [decades].
    double ratedDecades = 1;
    double ratedTouchingDecades = 0.75;

    /// Weight of what clusters do: regions that are rigid are stiffer than the material. At 2, bars take .5
    /// (Poisson's ratio .49) to 1 times the iterations of 1; from 1.5 to 3 it makes little difference.
    float clusterWeight = 2;
    std::size_t mostAtTop = 40; ///< clusters of the last level, at most: a dense factor is found for them
    /// What a level above gives is taken so many times, since regions that are rigid are stiffer than what they stand
    /// for. It stays positive definite with any number; the spectrum ends at this to the power of the levels. 1.5
    /// instead of 1 takes a fifth off the iterations at Poisson's ratio .45 and .49, 1.8 a little more.
    float overCorrection = 1.5F;
    double leastGain = 0.8; ///< a level has at most so many of the clusters below it, or it is the last one
    // Clusters of one object, or of objects in a row, have rotations that do nothing; so much of the diagonal keeps
    // inverses finite: in single precision enough for rounding of what does nothing to leave the rest positive
    // definite.
    double singleShift = 1e-4;
    double doubleShift = 1e-8;
};

/// Load steps without inertia, beside StaticEquilibrium::Settings.
struct StaticSettings {
    /// The step in times that sound takes across the body: so slender a body that its first mode is this much slower
    /// than that has masses in its operator that count as much as its stiffness, which costs iterations and no
    /// accuracy.
    double stepShare = 1e4;
    double linearTolerance = 1e-3; ///< to which a linear system is solved, by its preconditioned norm
    int mostIterations = 3000;     ///< of conjugate gradients for one linear system
    int staleFactor = 2;           ///< of iterations, at which the coarse factor is found anew
    /// A step may stretch and turn connections by this much. A turn of t lengthens them by t^2 / 2 when it is taken
    /// as straight.
    double largestStretch = 0.2;
    // A line is searched until the force along it is this share of what it was, in so many trials; none is shorter
    // than this share of the one before.
    double lineTolerance = 0.5;
    int mostTrials = 5;
    double shortestTrial = 0.1;
    /// Where nothing acts any more, what is left is compared with this share of what acted on the way.
    double leastActing = 1e-6;
    double stickShare = 3e-4; ///< slides shorter than this stick [spacings]
    double spanShare =
        1e-6; ///< three held objects hold a piece when they span this share of the square of their distance

    int mostParts = 6;     ///< a load step is gone in so many halvings of itself at most
    double lostShare = 10; ///< a body that went further than this is held by nothing in some direction [diagonals]
    /// Where there is something to meet, no object goes further than this at a time [spacings], or it would pass by.
    double farthestStep = 0.5;
};

struct SolverSettings {
    ExplicitSettings explicitSteps;
    ImplicitStepSettings implicitSteps;
    NewtonSettings newton;
    MixingSettings mixing;
    LinearSettings linear;
    StaticSettings balance;
};

inline constexpr SolverSettings solverSettings;

} // namespace knead
