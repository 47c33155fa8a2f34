// Momenta of what hangs together, and the damping that leaves them alone.
#include "core/integration/piece_momenta.h"
#include "core/integration/shape_damping.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

/// Two cubes of eight objects each that fly apart, and two objects on a line.
struct Flying {
    ObjectState state;
    Pieces pieces;
};

void add(Flying& flying, const std::vector<Vec3>& places)
{
    ObjectState& state = flying.state;
    const std::size_t before = flying.pieces.ofObject.size();
    VectorArray position(before + places.size());
    for (std::size_t i = 0; i < before; ++i)
        position.set(i, state.position.at(i));
    for (std::size_t i = 0; i < places.size(); ++i) {
        position.set(before + i, places[i]);
        flying.pieces.ofObject.push_back(static_cast<std::uint32_t>(flying.pieces.count));
        state.mass.push_back(1 + 0.1 * static_cast<double>(i));
        state.inverseMass.push_back(1 / state.mass.back());
    }
    ++flying.pieces.count;
    state.position = position;
    state.velocity.resize(position.size());
}

std::vector<Vec3> cube(const Vec3& center)
{
    std::vector<Vec3> places;
    for (int corner = 0; corner < 8; ++corner)
        places.push_back(center + Vec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    return places;
}

Flying threePieces()
{
    Flying flying;
    add(flying, cube(Vec3(0, 0, 0)));
    add(flying, cube(Vec3(10, 0, 0)));
    add(flying, {Vec3(0, 20, 0), Vec3(0, 20, 3)});
    return flying;
}

std::vector<PieceMomenta> momenta(const Flying& flying)
{
    return momentaOf(flying.state, flying.state.position, flying.state.velocity, flying.pieces);
}

/// V + W x (x - c) for the objects of one piece.
void move(Flying& flying, std::uint32_t piece, const Vec3& velocity, const Vec3& spin)
{
    const Vec3 center = momenta(flying)[piece].center;
    for (std::size_t i = 0; i < flying.state.size(); ++i)
        if (flying.pieces.ofObject[i] == piece)
            flying.state.velocity.set(i, velocity + spin.cross(flying.state.position.at(i) - center));
}

double kinetic(const ObjectState& state)
{
    double sum = 0;
    for (std::size_t i = 0; i < state.size(); ++i)
        sum += 0.5 * state.mass[i] * state.velocity.at(i).squaredNorm();
    return sum;
}

/// Velocities without a pattern.
void shake(ObjectState& state)
{
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto n = static_cast<double>(i);
        state.velocity.set(i, Vec3(std::sin(3 * n), std::cos(5 * n), std::sin(7 * n + 1)));
    }
}

} // namespace

class PieceMomentaTest : public QObject {
    Q_OBJECT

private slots:
    void eachPieceHasItsOwn()
    {
        Flying flying = threePieces();
        const Vec3 spin(0.3, -2, 1);
        move(flying, 0, Vec3(1, 2, 3), spin);
        move(flying, 1, Vec3(-4, 0, 0), Vec3::Zero());
        const std::vector<PieceMomenta> pieces = momenta(flying);
        QCOMPARE(pieces.size(), std::size_t{3});
        QCOMPARE(pieces[0].objects, std::size_t{8});
        const double mass = 8 + 0.1 * 28;
        QVERIFY(std::abs(pieces[0].mass - mass) < 1e-12);
        QVERIFY((pieces[0].linear - mass * Vec3(1, 2, 3)).norm() < 1e-11);
        QVERIFY((pieces[0].spinOf(pieces[0].angular) - spin).norm() < 1e-11);
        QVERIFY((pieces[1].linear - mass * Vec3(-4, 0, 0)).norm() < 1e-11);
        QVERIFY(pieces[1].angular.norm() < 1e-11);
        QVERIFY(pieces[0].canTurn());
    }

    /// Of objects on a line nothing is known about a turn around it.
    void aLineDoesNotTurnAboutItself()
    {
        Flying flying = threePieces();
        move(flying, 2, Vec3::Zero(), Vec3(5, 0, 0));
        const PieceMomenta line = momenta(flying)[2];
        QVERIFY(!line.canTurn());
        QVERIFY((line.spinOf(line.angular) - Vec3(5, 0, 0)).norm() < 1e-11);
        QVERIFY(line.spinOf(line.angular + Vec3(0, 0, 1)).z() == 0);
        // One object has none at all.
        const PieceMomenta one{.objects = 1, .mass = 1};
        QVERIFY(one.spinOf(Vec3(1, 1, 1)).isZero(0));
    }

    /// Weight is of the material, inertia of what mass scaling made of it.
    void addedMassDoesNotWeigh()
    {
        Flying flying = threePieces();
        flying.state.trueMass.assign(flying.state.size(), 0.5);
        const PieceMomenta piece = momenta(flying)[1];
        QCOMPARE(piece.weighed, 4.0);
        QVERIFY(piece.mass > 8);
    }

    void dampingKeepsMomentaOfEachPiece()
    {
        Flying flying = threePieces();
        shake(flying.state);
        const std::vector<PieceMomenta> before = momenta(flying);
        const double energy = kinetic(flying.state);
        const double lost = dampShape(flying.state, 100, 0.01, flying.pieces);
        const std::vector<PieceMomenta> after = momenta(flying);
        for (std::size_t piece = 0; piece < 3; ++piece) {
            QVERIFY((after[piece].linear - before[piece].linear).norm() < 1e-11);
            QVERIFY((after[piece].angular - before[piece].angular).norm() < 1e-10);
        }
        QVERIFY(lost > 0);
        QVERIFY(std::abs(kinetic(flying.state) + lost - energy) < 1e-11 * energy);
    }

    void whatKeepsItsShapeIsNotBraked()
    {
        Flying flying = threePieces();
        move(flying, 0, Vec3(1, 2, 3), Vec3(0.3, -2, 1));
        move(flying, 1, Vec3(-4, 0, 0), Vec3(0, 0, 7));
        move(flying, 2, Vec3(0, 1, 0), Vec3(0, 2, 0));
        const ObjectState before = flying.state;
        dampShape(flying.state, 1e4, 0.01, flying.pieces);
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY((flying.state.velocity.at(i) - before.velocity.at(i)).norm() < 1e-10);
    }

    /// (1 - exp(-rate dt)) of the way to what holds it, and the free piece beside it goes on.
    void whatIsHeldComesToRestOnWhatHoldsIt()
    {
        Flying flying = threePieces();
        move(flying, 0, Vec3(1, 0, 0), Vec3::Zero());
        move(flying, 1, Vec3(0, 3, 0), Vec3::Zero());
        flying.state.inverseMass[0] = 0;
        flying.state.velocity.set(0, Vec3(0, 0, 2));
        const double share = 1 - std::exp(-0.5);
        dampShape(flying.state, 50, 0.01, flying.pieces);
        QVERIFY(flying.state.velocity.at(0) == Vec3(0, 0, 2));
        QVERIFY((flying.state.velocity.at(1) - Vec3(1 - share, 0, 2 * share)).norm() < 1e-12);
        QVERIFY((flying.state.velocity.at(8) - Vec3(0, 3, 0)).norm() < 1e-12);
    }
};

QTEST_APPLESS_MAIN(PieceMomentaTest)
#include "piece_momenta_test.moc"
