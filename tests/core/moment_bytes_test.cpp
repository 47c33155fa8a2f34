// Moments come back from their bytes to the bit; damaged bytes are a sentence.
#include "core/document/moment_bytes.h"
#include "core/document/moment_hash.h"
#include "support/fuzz_random.h"
#include "support/scenes_of_every_kind.h"

#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>

using namespace knead;

namespace {

const std::vector<scenes::KindOfScene>& kinds()
{
    static const std::vector<scenes::KindOfScene> all = scenes::scenesOfEveryKind();
    return all;
}

/// What a scene is in its middle.
struct Middle {
    explicit Middle(const scenes::KindOfScene& kind)
        : scene(kind.scene)
        , simulation(scene)
    {
        scenes::runSteps(simulation, kind, 0, kind.steps);
        moment = simulation.keepMoment();
        parts = toolPartsOf(scene, simulation.recording());
    }

    /// As older versions kept it.
    void forgetFriction()
    {
        Moment without = *moment;
        without.contacts.holds.clear();
        without.contacts.touches.clear();
        moment = std::make_shared<const Moment>(without);
        simulation.goTo(moment);
    }

    Scene scene;
    Simulation simulation;
    MomentPointer moment;
    ToolParts parts;
};

/// Runs of equal bytes as a count and the byte: a compressor that damage can reach.
Packing runLengths()
{
    const auto pack = [](std::span<const std::byte> bytes) {
        Bytes packed;
        for (std::size_t i = 0; i < bytes.size();) {
            std::size_t count = 1;
            while (i + count < bytes.size() && count < 255 && bytes[i + count] == bytes[i])
                ++count;
            packed.push_back(static_cast<std::byte>(count));
            packed.push_back(bytes[i]);
            i += count;
        }
        return packed;
    };
    const auto unpack = [](std::span<const std::byte> packed, std::size_t size) {
        Bytes bytes;
        for (std::size_t i = 0; i + 1 < packed.size() && bytes.size() < size; i += 2)
            bytes.insert(bytes.end(), std::to_integer<std::size_t>(packed[i]), packed[i + 1]);
        return bytes;
    };
    return {pack, unpack};
}

/// The sentence that reading ends in; empty when it does not.
std::string refusal(const Bytes& bytes, const Middle& middle)
{
    try {
        momentFromBytes(bytes, middle.scene.bodies, middle.parts);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

constexpr std::size_t header = 36; // mark, version, two sizes, checksum

/// Makes the checksum of what was damaged right, so that the damage itself has to be found.
void sign(Bytes& bytes)
{
    const std::uint64_t sum = momentSum(static_cast<std::uint32_t>(bytes[8]), std::span(bytes).subspan(header));
    for (std::size_t i = 0; i < 8; ++i)
        bytes[header - 8 + i] = static_cast<std::byte>(sum >> (8 * i));
}

void putSizes(Bytes& bytes, std::uint64_t version)
{
    const auto put = [&](std::size_t place, std::uint64_t number, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i)
            bytes[place + i] = static_cast<std::byte>(number >> (8 * i));
    };
    put(8, version, 4);
    put(12, bytes.size() - header, 8);
    put(20, bytes.size() - header, 8);
    sign(bytes);
}

std::size_t firstDifference(const Bytes& one, const Bytes& other)
{
    std::size_t first = header;
    while (one[first] == other[first])
        ++first;
    return first;
}

/// How much of a moment's bytes comes at the end in all versions.
std::ptrdiff_t restOf(const Moment& moment)
{
    return 1 + 1 + 4 + static_cast<std::ptrdiff_t>(moment.watch.health.message.english().size());
}

using Stretches = std::vector<std::pair<std::size_t, std::ptrdiff_t>>; // where, and how much

Bytes without(Bytes bytes, Stretches gone)
{
    std::sort(gone.rbegin(), gone.rend()); // the last one first, so that places stay what they are
    for (const auto& [place, count] : gone) {
        const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(place);
        bytes.erase(first, first + count);
    }
    return bytes;
}

/// Bytes of a moment of first fillings without what sticks to tools and floor, what rolls, and the volume that clay
/// keeps: as version 7 had them.
Bytes beforeSticking(const Moment& moment)
{
    const Bytes whole = momentToBytes(moment);
    Stretches gone;
    const auto forget = [&](std::ptrdiff_t size, const auto& change) {
        Moment other = moment;
        change(other);
        gone.emplace_back(firstDifference(whole, momentToBytes(other)), size);
    };
    const auto inverted = [](double value) { return std::bit_cast<double>(~std::bit_cast<std::uint64_t>(value)); };
    for (std::size_t t = 0; t < moment.tools.size(); ++t) {
        if (!moment.tools[t])
            continue;
        for (Manipulator ToolRun::*tool : {&ToolRun::manipulator, &ToolRun::start}) {
            forget(8, [&](Moment& other) {
                double& adhesion = (*other.tools[t].*tool).adhesion;
                adhesion = inverted(adhesion);
            });
            forget(1, [&](Moment& other) {
                bool& rolls = (*other.tools[t].*tool).rollsFreely;
                rolls = !rolls;
            });
        }
    }
    for (std::size_t b = 0; b < moment.bodies.size(); ++b)
        forget(8, [&](Moment& other) {
            double& volume = other.bodies[b].changes.keptVolume;
            volume = inverted(volume);
        });
    forget(8, [&](Moment& other) { other.around.floorAdhesion = inverted(other.around.floorAdhesion); });
    for (std::size_t h = 0; h < moment.contacts.holds.size(); ++h)
        forget(1, [&](Moment& other) {
            bool& sticks = other.contacts.holds[h].friction.sticks;
            sticks = !sticks;
        });
    for (std::size_t t = 0; t < moment.contacts.touches.size(); ++t)
        forget(1, [&](Moment& other) {
            bool& sticks = other.contacts.touches[t].friction.sticks;
            sticks = !sticks;
        });
    return without(whole, std::move(gone));
}

/// Bytes of a moment of bodies of one material each, of which nothing is broken or being cut, without toughness and what knives hold:
/// as version 6 had them.
Bytes beforeCutting(const Moment& moment)
{
    Bytes bytes = beforeSticking(moment);
    const auto end = bytes.end() - restOf(moment);
    bytes.erase(end - 4, end);
    // Each touch ends with the side of a knife that it is on; the pace comes behind the last one.
    constexpr std::ptrdiff_t touch = 3 * 4 + 6 * 8 + 1;
    const std::ptrdiff_t last = std::ssize(bytes) - restOf(moment) - 2;
    for (std::ptrdiff_t t = 0; t < std::ssize(moment.contacts.touches); ++t)
        bytes.erase(bytes.begin() + last - t * touch);
    for (std::size_t b = moment.bodies.size(); b-- > 0;) { // the last one first, so that places stay what they are
        Moment other = moment;
        Material material = moment.bodies[b].materials.materials().front();
        material.toughness = 1.0 / 3; // all bytes differ from those of 0
        other.bodies[b].materials.setOwn(material);
        const auto first =
            bytes.begin() + static_cast<std::ptrdiff_t>(firstDifference(momentToBytes(moment), momentToBytes(other)));
        bytes.erase(first, first + 8);
    }
    return bytes;
}

/// Bytes of a moment of first fillings without what says so: as version 5 had them.
Bytes beforeRefilling(const Moment& moment)
{
    const Bytes whole = beforeCutting(moment);
    Stretches gone;
    for (std::size_t b = 0; b < moment.bodies.size(); ++b) {
        Moment other = moment;
        other.bodies[b].kind = moment.bodies[b].kind == BodyKind::glue ? BodyKind::rigid : BodyKind::glue;
        gone.emplace_back(firstDifference(whole, beforeCutting(other)) - 1, 1);
    }
    for (std::size_t f = 0; f < moment.fixtures.size(); ++f) {
        if (!moment.fixtures[f])
            continue;
        Moment other = moment;
        other.fixtures[f]->whenOpened = {1};
        gone.emplace_back(firstDifference(whole, beforeCutting(other)), 4);
    }
    return without(whole, std::move(gone));
}

/// Bytes of a moment without the pace, and with what tools kept of their limits: as version 4 had them.
Bytes beforePace(const Moment& moment)
{
    Bytes bytes = beforeRefilling(moment);
    bytes.erase(bytes.end() - restOf(moment) - 1);
    for (std::size_t t = moment.tools.size(); t-- > 0;) { // the last one first, so that places stay what they are
        if (!moment.tools[t])
            continue;
        Moment other = moment;
        const auto bits = std::bit_cast<std::uint64_t>(moment.tools[t]->peakForce);
        other.tools[t]->peakForce = std::bit_cast<double>(~bits); // all bytes differ
        const std::size_t peak = firstDifference(beforeRefilling(moment), beforeRefilling(other));
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(peak), 8, std::byte{0});
    }
    return bytes;
}

/// Bytes of a moment that holds nothing by friction, without the two lists of it, which versions 1 to 3 did not have.
Bytes beforeFriction(const Moment& moment)
{
    Bytes bytes = beforePace(moment);
    const auto end = bytes.end() - restOf(moment);
    bytes.erase(end - 4 - 4, end);
    return bytes;
}

/// Bytes of a moment of one body of one material, without its numbers of rubber as well, which versions 1 and 2 did not have.
Bytes beforeRubber(const Moment& moment)
{
    Moment other = moment;
    Material material = moment.bodies[0].materials.materials().front();
    material.rubberlike = 1.0 / 3; // all bytes differ from those of 0
    other.bodies[0].materials.setOwn(material);
    Bytes bytes = beforeFriction(moment);
    const auto first = static_cast<std::ptrdiff_t>(firstDifference(bytes, beforeFriction(other)));
    bytes.erase(bytes.begin() + first, bytes.begin() + first + 3 * 8);
    return bytes;
}

} // namespace

class MomentBytesTest : public QObject {
    Q_OBJECT

private slots:
    void momentsComeBackToTheBit_data()
    {
        QTest::addColumn<int>("kind");
        for (std::size_t k = 0; k < kinds().size(); ++k)
            QTest::newRow(kinds()[k].name.c_str()) << static_cast<int>(k);
    }
    void momentsComeBackToTheBit()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Middle middle(of);
        const Bytes bytes = momentToBytes(*middle.moment);
        const Moment read = momentFromBytes(bytes, middle.scene.bodies, middle.parts);
        QVERIFY(momentToBytes(read) == bytes);

        Simulation fresh(middle.scene);
        fresh.goTo(std::make_shared<const Moment>(read));
        QVERIFY(fresh.snapshot()->notice.empty());
        QCOMPARE(fresh.stateHash(), middle.simulation.stateHash());
        QCOMPARE(fresh.snapshot()->energy.imbalance, middle.simulation.snapshot()->energy.imbalance);
        scenes::runSteps(fresh, of, of.steps, of.steps + of.steps / 2);
        scenes::runSteps(middle.simulation, of, of.steps, of.steps + of.steps / 2);
        QCOMPARE(fresh.stateHash(), middle.simulation.stateHash());
    }

    void keepingTwiceGivesTheSameBytes()
    {
        for (const scenes::KindOfScene& kind : kinds()) {
            Middle middle(kind);
            const Bytes once = momentToBytes(*middle.moment);
            QVERIFY2(momentToBytes(*middle.simulation.keepMoment()) == once, kind.name.c_str());
            middle.simulation.snapshot(); // looking is no change either
            QVERIFY2(momentToBytes(*middle.simulation.keepMoment()) == once, kind.name.c_str());
        }
    }

    void packedBytesAreSmallerAndComeBack()
    {
        const Scene scene = scenes::smallPress(scenes::clay());
        Simulation simulation(scene);
        const MomentPointer moment = simulation.keepMoment();
        const Bytes plain = momentToBytes(*moment);
        const Bytes packed = momentToBytes(*moment, runLengths());
        QVERIFY(packed.size() < plain.size() / 4); // nothing has moved yet
        const Moment read = momentFromBytes(packed, scene.bodies, {}, runLengths());
        QVERIFY(momentToBytes(read) == plain);
    }

    void numbersOfAnyKindComeBack()
    {
        LaneVector<double> numbers{0,         -0.0, 1e-310, -1e-310, 1e308,   -1e308, 1e308, 1,
                                   1 + 1e-15, 0.1,  0.2,    0.3,     -7.25e9, 3,      3,     3};
        ByteWriter writer;
        writer.numbers(numbers, numbers.size());
        const Bytes bytes = writer.take();
        LaneVector<double> read;
        ByteReader reader(bytes);
        reader.numbers(read, numbers.size());
        QCOMPARE(read.size(), numbers.size());
        QVERIFY(std::equal(read.begin(), read.end(), numbers.begin()));
        QVERIFY(std::signbit(read[1]));
        QVERIFY(reader.atEnd());
    }

    void momentsOfTheEleventhVersionAreRead()
    {
        Middle middle(kinds()[0]);
        const Bytes whole = momentToBytes(*middle.moment);
        Moment other = *middle.moment;
        QCOMPARE(other.bodies.size(), 1);
        other.bodies[0].changes.keptVolume = std::bit_cast<double>(~std::uint64_t{0});
        Bytes old = without(whole, {{firstDifference(whole, momentToBytes(other)), 8}});
        putSizes(old, 11);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        QCOMPARE(read.bodies[0].changes.keptVolume, 0.0);
    }

    void momentsOfTheSeventhVersionAreRead()
    {
        Middle middle(kinds()[0]);
        Bytes old = beforeSticking(*middle.moment);
        putSizes(old, 7);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        QCOMPARE(read.around.floorAdhesion, 0.0);
    }

    void momentsOfTheSixthVersionAreRead()
    {
        Middle middle(kinds()[0]);
        Bytes old = beforeCutting(*middle.moment);
        putSizes(old, 6);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        QCOMPARE(read.bodies[0].materials.of(0).toughness, 0.0);
    }

    void momentsOfTheFifthVersionAreRead()
    {
        Middle middle(kinds()[0]);
        Bytes old = beforeRefilling(*middle.moment);
        putSizes(old, 5);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        QVERIFY(read.bodies[0].refilled == nullptr);
    }

    void momentsOfTheFourthVersionAreRead()
    {
        Middle middle(kinds()[0]);
        Bytes old = beforePace(*middle.moment);
        putSizes(old, 4);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        QCOMPARE(read.scheme.pace, Pace::full);
    }

    void momentsOfTheThirdVersionAreRead()
    {
        Middle middle(kinds()[0]);
        middle.forgetFriction();
        Bytes old = beforeFriction(*middle.moment);
        putSizes(old, 3);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
    }

    void momentsOfTheSecondVersionAreRead()
    {
        Middle middle(kinds()[0]);
        middle.forgetFriction();
        Bytes old = beforeRubber(*middle.moment);
        putSizes(old, 2);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
    }

    /// Version 1 ended before what a run is measured by.
    void momentsOfTheFirstVersionAreRead()
    {
        constexpr std::ptrdiff_t added = 8 + 8 + 4 + 1 + 8;
        Middle middle(kinds()[0]);
        middle.forgetFriction();
        Bytes old = beforeRubber(*middle.moment);
        const auto end = old.end() - restOf(*middle.moment);
        old.erase(end - added, end);
        // Each connection had a plastic strain, where each object has a metric and two numbers now: of nothing that has flowed that
        // is a zero for each array of numbers. They begin where a moment in which something has flowed is another.
        QVERIFY(middle.moment->bodies.size() == 1 && middle.moment->bodies[0].changes.plastic.metric[0].empty());
        Moment flowed = *middle.moment;
        flowed.bodies[0].changes.plastic.nominalLength[0].assign(1, 1);
        const std::size_t first = firstDifference(old, beforeRubber(flowed));
        constexpr std::size_t arraysNow = Lattice::directionCount + 8;
        constexpr std::size_t arraysThen = 2 * Lattice::directionCount;
        old.insert(old.begin() + static_cast<std::ptrdiff_t>(first), arraysThen - arraysNow, std::byte{0});
        putSizes(old, 1);
        const Moment read = momentFromBytes(old, middle.scene.bodies, middle.parts);
        QCOMPARE(momentHash(read), momentHash(*middle.moment));
        Simulation fresh(middle.scene);
        fresh.goTo(std::make_shared<const Moment>(read));
        scenes::runSteps(fresh, kinds()[0], kinds()[0].steps, kinds()[0].steps + 20);
        scenes::runSteps(middle.simulation, kinds()[0], kinds()[0].steps, kinds()[0].steps + 20);
        QCOMPARE(fresh.stateHash(), middle.simulation.stateHash());
    }

    void aMomentOfOtherBodiesIsRefused()
    {
        const Middle middle(kinds()[0]);
        const Bytes bytes = momentToBytes(*middle.moment);
        const Scene larger = scenes::smallPress(scenes::soft(), 7);
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, momentFromBytes(bytes, larger.bodies));
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, momentFromBytes(bytes, {}));
    }

    void aToolPartThatIsMissingIsNamed()
    {
        const auto withPart = std::find_if(kinds().begin(), kinds().end(), [](const scenes::KindOfScene& kind) {
            return std::any_of(kind.scene.manipulators.begin(), kind.scene.manipulators.end(),
                               [](const Manipulator& tool) { return tool.part != nullptr; });
        });
        Middle middle(*withPart);
        const Bytes bytes = momentToBytes(*middle.moment);
        QVERIFY(refusal(bytes, middle).empty());
        middle.parts = {std::make_shared<const ToolPart>(shapes::box(Vec3(1, 2, 3)))};
        QVERIFY(refusal(bytes, middle).find("made of a part") != std::string::npos);
        // The same surface in another place of memory is the same part.
        middle.parts.push_back(std::make_shared<const ToolPart>(shapes::box({0.01, 0.01, 0.03})));
        QVERIFY(refusal(bytes, middle).empty());
    }

    void anythingCutOffIsASentence()
    {
        const Middle middle(kinds()[3]);
        const Bytes whole = momentToBytes(*middle.moment);
        for (std::size_t size = 0; size < whole.size(); size += 97) {
            Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            QVERIFY(!refusal(bytes, middle).empty());
            bytes.resize(whole.size());
            QVERIFY(!refusal(bytes, middle).empty());
        }
    }

    void everyFlippedBitIsFound()
    {
        const Middle middle(kinds()[4]);
        const Bytes whole = momentToBytes(*middle.moment);
        fuzz::Random random(7);
        for (int i = 0; i < 2000; ++i) {
            Bytes bytes = whole;
            const std::size_t place = i < 288 ? static_cast<std::size_t>(i) / 8 : random.below(bytes.size());
            bytes[place] ^= static_cast<std::byte>(1U << random.below(8));
            QVERIFY(!refusal(bytes, middle).empty());
        }
    }

    void whatIsReadFromForgedBytesCanBeSimulated_data()
    {
        QTest::addColumn<int>("kind");
        for (const int kind : {3, 4, 8, 9, 12, 13, 15, 18})
            QTest::newRow(kinds()[static_cast<std::size_t>(kind)].name.c_str()) << kind;
    }
    void whatIsReadFromForgedBytesCanBeSimulated()
    {
        QFETCH(int, kind);
        const Middle middle(kinds()[static_cast<std::size_t>(kind)]);
        const Bytes whole = momentToBytes(*middle.moment);
        fuzz::Random random(static_cast<std::uint64_t>(kind));
        int refused = 0;
        int simulated = 0;
        Simulation simulation(middle.scene);
        for (int i = 0; i < 400; ++i) {
            Bytes bytes = whole;
            // Small things, which numbers and indices are among, lie at the ends.
            const std::size_t from = random.below(3);
            const std::size_t range = from == 0 ? bytes.size() - 36 : std::min<std::size_t>(2000, bytes.size() - 36);
            const std::size_t place = from == 1 ? bytes.size() - 1 - random.below(range) : 36 + random.below(range);
            bytes[place] = random.chance(50) ? static_cast<std::byte>(random.next())
                                             : bytes[place] ^ static_cast<std::byte>(1U << random.below(8));
            sign(bytes);
            try {
                auto moment = std::make_shared<const Moment>(momentFromBytes(bytes, middle.scene.bodies, middle.parts));
                simulation.goTo(std::move(moment));
                for (int step = 0; step < 3; ++step)
                    simulation.step();
                simulation.snapshot();
                simulation.keepMoment();
                ++simulated;
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
        QCOMPARE(refused + simulated, 400);
        QVERIFY(refused > 0 && simulated > 0);
    }
};

QTEST_GUILESS_MAIN(MomentBytesTest)
#include "moment_bytes_test.moc"
