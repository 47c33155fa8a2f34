// Project files that are not as they were written, all the way: opened as the window does, gone on with, and repeated.
#include "app/gui.h"
#include "app/project_replay.h"
#include "core/session/face_fixtures.h"
#include "core/simulation/moment.h"
#include "io/project/command_json.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/byte_mutation.h"
#include "support/pressed_part.h"
#include "support/workshop.h"
#include "ui/document/face_memory.h"
#include "ui/project/read_project.h"

#include <QtTest>

#include <chrono>
#include <numeric>

using namespace knead;
using namespace knead::sessions;

namespace {

using Clock = std::chrono::steady_clock;

/// As a person who loses patience: what a damaged number makes endless ends.
class Impatient final : public TaskControl {
public:
    explicit Impatient(std::chrono::milliseconds patience)
        : m_end(Clock::now() + patience)
    {
    }
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return Clock::now() > m_end; }

private:
    Clock::time_point m_end;
};

/// What came of a file.
struct Outcome {
    int opened = 0;
    int refused = 0;   ///< in a sentence
    int rescues = 0;   ///< that were tried
    int cancelled = 0; ///< after some time
    std::string wrong; ///< what was said instead of a sentence

    /// @param work throws what the person is told
    void add(const std::function<void()>& work)
    {
        try {
            work();
            ++opened;
        } catch (const Cancelled&) {
            ++cancelled;
        } catch (const std::runtime_error& error) {
            ++refused;
            const std::string said = error.what();
            if (!said.ends_with('.') || said.find('\n') != std::string::npos)
                wrong = said;
        }
    }
};

constexpr const char* fixtureMemory = R"([{"key": 1, "name": "end", "body": 0, "faces": [0, 1]}])";

} // namespace

class DamagedProjectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_services = fileServices();
        // Hundreds of files: without a trial in a process of its own before each, see cad_process_test.
        m_services.projects.read = readProject;
        m_services.projects.rescue = rescueProject;
        m_project = pressedPart(m_shop.path("bar.stl"), 0.005);
        m_project.panels["fixtures"] = fixtureMemory;
        writeProject(path("sound.knead"), packed(m_project));
        m_sound = bytesOf("sound.knead");
    }

    void aSoundFileGoesAllTheWay()
    {
        Outcome outcome;
        goAllTheWay(path("sound.knead"), outcome, std::chrono::minutes(5)); // however busy the machine is
        QCOMPARE(outcome.opened, 2);
    }

    void damagedBytesAreRefusedRescuedOrTheSame()
    {
        fuzz::Random random(61);
        Outcome outcome;
        for (int trial = 0; trial < 100; ++trial) {
            std::string damaged = m_sound;
            for (std::size_t i = random.below(4); i < 4; ++i)
                fuzz::mutateBytes(damaged, random);
            std::ofstream(path("damaged.knead"), std::ios::binary | std::ios::trunc) << damaged;
            goAllTheWay(path("damaged.knead"), outcome);
        }
        report(outcome);
        QCOMPARE(outcome.wrong, std::string());
        QVERIFY(outcome.opened > 0 && outcome.refused > 0);
    }

    /// Files whose checksums are all right and whose content is not.
    void forgedContentIsRefusedOrRescued()
    {
        fuzz::Random random(62);
        Outcome outcome;
        for (int trial = 0; trial < 100; ++trial) {
            Project forged = m_project;
            for (std::size_t i = random.below(3); i < 3; ++i)
                forge(forged, random);
            const bool isForgedMoment = random.chance(50);
            writeProject(path("forged.knead"), packed(forged, isForgedMoment ? &random : nullptr));
            goAllTheWay(path("forged.knead"), outcome);
        }
        report(outcome);
        QCOMPARE(outcome.wrong, std::string());
        QVERIFY(outcome.opened > 0 && outcome.refused + outcome.rescues > 0);
    }

private:
    std::string path(const std::string& name) const { return m_shop.path(name); }

    std::string bytesOf(const std::string& name) const
    {
        std::ifstream in(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    static void report(const Outcome& outcome)
    {
        qInfo("%d went well, %d were refused, %d were cancelled; of %d a part was looked for", outcome.opened,
              outcome.refused, outcome.cancelled, outcome.rescues);
    }

    /// With moments as the window keeps them.
    /// @param random what changes bytes in them, and signs that; null: nothing does
    Project packed(Project project, fuzz::Random* random = nullptr) const
    {
        const Packing packing{.pack = [&](std::span<const std::byte> content) {
            Bytes bytes(content.begin(), content.end());
            for (std::size_t i = 0; random != nullptr && i < 3; ++i)
                bytes[random->chance(50) ? random->below(bytes.size()) : bytes.size() - 1 - random->below(600)] ^=
                    static_cast<std::byte>(1U << random->below(8));
            return zstandardPacking().pack(bytes);
        }};
        for (std::size_t i = 0; i < project.entries.size(); ++i)
            if (const auto& moment = m_project.entries[i].moment; project.entries[i].moment)
                project.entries[i].moment = std::make_shared<const Bytes>(
                    momentToBytes(momentFromBytes(*moment, m_project.starts[0].scene.bodies), packing));
        return project;
    }

    /// Changes one thing that a file says.
    static void forge(Project& project, fuzz::Random& random)
    {
        HistoryRecord& entry = random.oneOf(project.entries);
        switch (random.below(6)) {
        case 0:
            entry.step = random.chance(50) ? random.below(1000) : random.next() >> 11U;
            break;
        case 1:
            entry.hash = random.next();
            break;
        case 2:
            entry.moment = nullptr;
            break;
        case 3:
            project.current = static_cast<std::uint32_t>(random.below(project.entries.size()));
            break;
        case 4:
            fuzz::mutateText(project.panels["fixtures"], random);
            break;
        default:
            forgeCommands(entry, random);
        }
    }

    static void forgeCommands(HistoryRecord& entry, fuzz::Random& random)
    {
        ToolPartTable tools;
        std::string text = commandsToJson(entry.commands, tools);
        fuzz::mutateText(text, random);
        std::size_t longList = 100'000;
        try {
            entry.commands = commandsFromJson(text, "commands", tools, longList);
        } catch (const std::runtime_error&) {
        }
    }

    void goAllTheWay(const std::string& path, Outcome& outcome,
                     std::chrono::milliseconds patience = std::chrono::milliseconds(150)) const
    {
        outcome.add([&] { goOn(opened(path, patience, outcome)); });
        outcome.add([&] { repeat(path, patience); });
    }

    /// As the window opens it; a damaged one is rescued.
    ReadProject opened(const std::string& path, std::chrono::milliseconds patience, Outcome& outcome) const
    {
        Impatient control(patience);
        const ProjectRequest request{.path = path, .isCopy = true};
        ReadProject read = readProjectFor(request, m_services.projects, m_services.packing, control);
        if (read.obstacle == ReadProject::Obstacle::none)
            return read;
        ++outcome.rescues;
        const ProjectRequest rescue{.path = path, .isCopy = true, .rescues = true};
        return readProjectFor(rescue, m_services.projects, m_services.packing, control);
    }

    static void goOn(ReadProject read)
    {
        if (!read.project)
            return;
        HistoryDestination& destination = read.project->destination;
        FaceFixtures fixtures;
        for (const FaceFixture& known : facesRemembered(read.panels["fixtures"]))
            fixtures.keepInMind(known);
        fixtures.follow(*destination.content, destination.moment->fixtures);
        for (int step = 0; step < 5; ++step)
            destination.simulation->step();
        destination.simulation->snapshot();
    }

    /// As `knead replay --all` does.
    static void repeat(const std::string& path, std::chrono::milliseconds patience)
    {
        Impatient control(patience);
        const Project project = rescueProject(path, control).project;
        ReplayChoices all;
        all.entries.resize(project.entries.size());
        std::iota(all.entries.begin(), all.entries.end(), 0U);
        replayProject(project, all, control);
    }

    workshop::Workshop m_shop;
    Services m_services;
    Project m_project;
    std::string m_sound;
};

QTEST_GUILESS_MAIN(DamagedProjectTest)
#include "damaged_project_test.moc"
