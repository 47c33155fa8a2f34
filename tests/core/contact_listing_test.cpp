#include "core/geometry/rigid_fit.h"
#include "core/mechanics/contacts.h"
#include "support/scenes.h"

#include <QtTest>

using namespace knead;

namespace {

/// Boxes side by side along x that can be moved as wanted.
struct Boxes {
    struct Part {
        std::shared_ptr<const Aggregate> aggregate;
        MaterialMap materials;
        ObjectState state;
        StructuralConnections connections;
        VectorArray start;

        Part()
            : aggregate(scenes::box({6, 6, 6}, 1e-3).aggregate)
            , materials(Material{}, aggregate->size())
            , state(objectsAtRest(*aggregate))
            , connections(aggregate, materials)
        {
        }
    };

    explicit Boxes(std::size_t count, double gap)
        : parts(count)
    {
        std::vector<Contacts::BodyView> views;
        for (std::size_t p = 0; p < count; ++p) {
            ObjectState& state = parts[p].state;
            state.mass.assign(state.size(), 1e-6);
            state.inverseMass.assign(state.size(), 1e6);
            for (std::size_t i = 0; i < state.size(); ++i)
                state.position.add(i, {static_cast<double>(p) * (6e-3 + gap), 0, 0});
            parts[p].start = state.position;
            views.push_back({&state, &parts[p].connections, &parts[p].materials, BodyKind::deformable});
        }
        contacts.emplace(std::move(views), VicinityMethod::uniformGrid);
        contacts->updateVicinity({}, 0, 0);
    }

    /// Moves each object of a box to where a function takes the place it started from.
    template <typename Place>
    void move(std::size_t part, Place&& place)
    {
        ObjectState& state = parts[part].state;
        for (std::size_t i = 0; i < state.size(); ++i) {
            const Vec3 next = place(parts[part].start.at(i));
            travel = std::max(travel, (next - state.position.at(i)).norm());
            state.position.set(i, next);
        }
    }

    std::size_t update()
    {
        contacts->updateVicinity({}, travel, 0);
        travel = 0;
        return contacts->listings();
    }

    std::vector<Part> parts; // never copied: contacts point into it
    std::optional<Contacts> contacts;
    double travel = 0;
};

} // namespace

class ContactListingTest : public QObject {
    Q_OBJECT

private slots:
    void deviationIsWhatNoRigidMotionExplains()
    {
        std::vector<Vec3> before;
        for (int i = 0; i < 60; ++i)
            before.emplace_back(i % 3 - 1, i / 3 % 4 - 1.5, i / 12 - 2);
        const Pose pose{Vec3(3, -1, 7), Quaternion(Eigen::AngleAxisd(2.5, Vec3(1, 2, -1).normalized()))};
        for (const double stretch : {0.0, 0.1, -0.3}) { // along x, where the ends are 1 from the middle
            std::vector<Vec3> after;
            for (const Vec3& place : before)
                after.push_back(pose.toWorld(Vec3((1 + stretch) * place.x(), place.y(), place.z())));
            QVERIFY(std::abs(deviationFromRigidMotion(before, after) - std::abs(stretch)) < 1e-13);
        }
        QCOMPARE(deviationFromRigidMotion({}, {}), 0.0);
    }

    void aMirrorImageIsNoRigidMotion()
    {
        const std::vector<Vec3> before{Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3), Vec3(-1, -1, -1)};
        std::vector<Vec3> after;
        for (const Vec3& place : before)
            after.emplace_back(-place.x(), place.y(), place.z());
        QVERIFY(deviationFromRigidMotion(before, after) > 0.3);
    }

    void aBodyThatFliesAndTurnsAloneIsNotListedAgain()
    {
        Boxes boxes(1, 0);
        for (int step = 1; step <= 400; ++step) {
            const Quaternion turn(Eigen::AngleAxisd(0.01 * step, Vec3(1, 2, 3).normalized()));
            boxes.move(0, [&](const Vec3& place) { return Vec3(turn * place + step * Vec3(1e-4, 0, 2e-4)); });
            QCOMPARE(boxes.update(), std::size_t{1});
        }
    }

    void aBodyThatChangesItsShapeIsListedAgain()
    {
        Boxes boxes(1, 0);
        for (int step = 1; step <= 100; ++step) {
            boxes.move(0, [&](const Vec3& place) {
                return Vec3((1 - 0.004 * step) * place.x() + step * 1e-4, place.y(), place.z());
            });
            boxes.update();
        }
        // The ends come 1.2 mm nearer to the middle, each time by less than a quarter of a spacing of 1 mm.
        QVERIFY2(boxes.contacts->listings() > 5, qPrintable(QString::number(boxes.contacts->listings())));
    }

    /// Points near surfaces, in explicit steps: as far ahead as things go in 128 of them, within a quarter and 1.5 spacings.
    void surfacesAreListedAsFarAsThingsGo()
    {
        Boxes boxes(1, 0);
        Boxes::Part& part = boxes.parts.front();
        const std::array<ContactBody, 1> bodies{
            ContactBody{&part.state, &part.connections, &part.materials, BodyKind::deformable}};
        ContactListing listing(bodies);
        listing.setScheme(bodies, false);
        const double a = bodies[0].spacing();
        const auto list = [&](bool takesLittle) {
            listing.lookAhead(takesLittle);
            listing.listedSurfaces(1);
            listing.end();
            return listing.reachOfSurfaces() / a;
        };
        const auto stepsUntilDue = [&](double spacingsInStep) {
            for (int step = 1; step <= 1000; ++step) {
                listing.move(0.75 * spacingsInStep * a, 0.25 * spacingsInStep * a);
                if (listing.areSurfacesDue(1))
                    return step;
            }
            return 0;
        };
        const auto isNear = [](double value, double wanted) { return std::abs(value - wanted) < 1e-9; };
        QVERIFY(listing.areSurfacesDue(1));
        QVERIFY(isNear(list(true), 1.5)); // nothing is known of how things go
        QVERIFY(listing.areSurfacesDue(2));
        QCOMPARE(stepsUntilDue(0), 128); // the list is longer than it needs to be
        QVERIFY(isNear(list(true), 0.25));
        QCOMPARE(stepsUntilDue(0), 0);
        QVERIFY(isNear(list(true), 0.25));
        QCOMPARE(stepsUntilDue(0.007), 36); // 0.25 / 0.007
        QVERIFY(isNear(list(true), 128 * 0.007));
        QCOMPARE(stepsUntilDue(0.00701), 128);
        QVERIFY(isNear(list(true), 128 * 0.00701));
        QCOMPARE(stepsUntilDue(0.07), 13);
        QVERIFY(isNear(list(true), 1.5)); // and no more
        QCOMPARE(stepsUntilDue(0.07), 22);
        QVERIFY(isNear(list(false), 0.5)); // where a point that does not touch takes time, and knives are
        QCOMPARE(stepsUntilDue(0.00101), 496);
        QVERIFY(isNear(list(false), 0.5));
        listing.setScheme(bodies, true);
        QVERIFY(isNear(list(true), 1.5)); // of which 1 is for a single step
        QCOMPARE(stepsUntilDue(0), 0);
    }

    /// A ball and the floor press a box that shakes; lists as wide as they get at each step, or as they come.
    void nothingDependsOnWhatElseIsListed()
    {
        Boxes asTheyCome(1, 0);
        Boxes wide(1, 0);
        const std::array<Boxes*, 2> both{&asTheyCome, &wide};
        std::array<RigidSurface, 2> surfaces{
            RigidSurface{.id = 0, .shape = {.kind = ToolKind::ball, .size = Vec3::Constant(8e-3)}, .friction = 0.3},
            RigidSurface{.id = RigidSurface::floorId,
                         .isFloor = true,
                         .pose = {Vec3(0, 0, -3e-3), Quaternion::Identity()},
                         .friction = 0.3}};
        constexpr double duration = 1e-4;
        std::size_t touched = 0;
        std::size_t parted = 0;
        std::size_t last = 0;
        double friction = 0;
        for (int step = 0; step < 6000; ++step) {
            const double phase = 0.002 * step; // some thousandths of a spacing in a step
            const Vec3 before = surfaces[0].pose.position;
            surfaces[0].pose.position = Vec3(1e-3 * std::sin(phase), 0, 7.1e-3 - 0.4e-3 * std::sin(2 * phase));
            if (step > 0)
                surfaces[0].velocity = (surfaces[0].pose.position - before) / duration;
            std::array<std::size_t, 2> counts{};
            for (std::size_t n = 0; n < both.size(); ++n) {
                Boxes& boxes = *both[n];
                ObjectState& state = boxes.parts[0].state;
                const VectorArray places = state.position;
                boxes.move(0, [&](const Vec3& place) {
                    return Vec3(place + Vec3(0, 0, 0.1e-3 * std::sin(3 * phase + 500 * place.x())));
                });
                for (std::size_t i = 0; step > 0 && i < state.size(); ++i)
                    state.velocity.set(i, (state.position.at(i) - places.at(i)) / duration);
                if (step == 0)
                    boxes.contacts->setScheme({}, false);
                if (n == 1)
                    boxes.contacts->invalidate();
                boxes.contacts->updateVicinity(surfaces, boxes.travel, surfaces[0].velocity.norm() * duration);
                boxes.travel = 0;
                state.force.setZero();
                state.damping.setZero();
                const Contacts::Report report = boxes.contacts->computeForces(surfaces, {.duration = duration});
                counts[n] = report.count;
                for (const Contacts::Friction& one : report.frictions)
                    friction = std::max(friction, one.force.norm());
            }
            QCOMPARE(counts[0], counts[1]);
            for (std::size_t i = 0; i < wide.parts[0].state.size(); ++i) {
                QVERIFY(asTheyCome.parts[0].state.force.at(i) == wide.parts[0].state.force.at(i));
                QVERIFY(asTheyCome.parts[0].state.damping.at(i) == wide.parts[0].state.damping.at(i));
            }
            touched = std::max(touched, counts[0]);
            parted += counts[0] < last ? 1 : 0;
            last = counts[0];
        }
        QVERIFY(friction > 0);
        QVERIFY2(touched > 30 && parted > 10, qPrintable(QString("%1 %2").arg(touched).arg(parted)));
    }

    void bodiesThatMeetInFlightTouch()
    {
        // From 20 mm apart, in steps much longer than the margin would allow a blind search.
        Boxes boxes(2, 20e-3);
        const auto touching = [&] { return boxes.contacts->computeForces({}, {.duration = 1e-6}).count; };
        for (int step = 0; step <= 203; ++step) { // 0.3 mm into each other
            if (step < 200)
                QCOMPARE(touching(), std::size_t{0});
            boxes.move(1, [&](const Vec3& place) { return Vec3(place - Vec3(1e-4 * step, 0, 0)); });
            boxes.update();
            if (step == 100)
                QCOMPARE(boxes.contacts->listings(), std::size_t{1}); // nothing was near
        }
        QVERIFY(touching() >= 25);
    }

    /// That of the deformable bodies bounds how stiff rigid ones are, and nothing else.
    void anotherFrequencyConcernsRigidBodiesAlone()
    {
        Boxes boxes(2, 0.5e-3);
        boxes.move(1, [](const Vec3& place) { return Vec3(place - Vec3(0.7e-3, 0, 0)); });
        boxes.update();
        const auto energy = [&] { return boxes.contacts->computeForces({}, {.duration = 1e-6}).energy; };
        const auto energyAt = [&](double frequency) {
            boxes.contacts->setFrequency(frequency);
            boxes.update();
            return energy();
        };
        const std::size_t listings = boxes.contacts->listings();
        const double soft = energy();
        QVERIFY(soft > 0);
        QCOMPARE(energyAt(1e2), soft);
        QCOMPARE(energyAt(1e5), soft);
        QCOMPARE(boxes.contacts->listings(), listings);
        boxes.contacts->setKind(1, BodyKind::rigid);
        QVERIFY2(energyAt(1e2) < 0.5 * energyAt(1e5), qPrintable(QString::number(energyAt(1e2) / energyAt(1e5))));
    }

    /// Bodies that begin in each other feel nothing; once apart they meet where their skins do.
    void whatBeganInsideIsForgottenOnceApart()
    {
        Boxes boxes(2, -0.3e-3);
        const auto energy = [&] { return boxes.contacts->computeForces({}, {.duration = 1e-6}).energy; };
        const auto moveTo = [&](double x) {
            boxes.move(1, [&](const Vec3& place) { return Vec3(place + Vec3(x, 0, 0)); });
            boxes.update();
        };
        QCOMPARE(energy(), 0.0);
        moveTo(0.1e-3); // still in each other: what they keep stays
        moveTo(0);
        QCOMPARE(energy(), 0.0);
        moveTo(-0.1e-3);
        const double deeper = energy();
        QVERIFY(deeper > 0);
        moveTo(5e-3);
        QCOMPARE(energy(), 0.0);
        moveTo(-0.1e-3);
        // Opposite ones 0.4 instead of 0.1 mm deep, those across sqrt(2^2) - sqrt(1.6^2 + 1) = 0.113 mm instead of 0.085 mm:
        // (0.4^2 + 4 * 0.113^2) / (0.1^2 + 4 * 0.085^2) = 5.4 inside, more at the rim, which has fewer across.
        QVERIFY2(energy() > 5.4 * deeper && energy() < 8 * deeper, qPrintable(QString::number(energy() / deeper)));
    }
};

QTEST_GUILESS_MAIN(ContactListingTest)
#include "contact_listing_test.moc"
