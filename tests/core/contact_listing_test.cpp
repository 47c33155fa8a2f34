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
