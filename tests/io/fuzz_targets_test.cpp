#include "fuzz/targets.h"
#include "support/byte_mutation.h"

#include <QtTest>

using namespace knead;

/// What reads bytes of strangers: sound ones are taken, changed ones end in a value or a sentence. tests/fuzz has the same for
/// libFuzzer, which tries millions; here they are compiled by every compiler, and see some of each kind.
class FuzzTargetsTest : public QObject {
    Q_OBJECT

private slots:
    void soundBytesAreTaken_data() { eachTarget(); }
    void soundBytesAreTaken()
    {
        const auto& [name, target, trials] = here();
        const std::vector<std::string> seeds = target.seeds();
        QVERIFY(!seeds.empty());
        const std::size_t each = 1 + seeds.size() / 40;
        for (std::size_t i = 0; i < seeds.size(); i += each)
            QVERIFY2(target.read(seeds[i]), seeds[i].substr(0, 200).c_str());
    }

    void changedBytesAreTakenOrRefused_data() { eachTarget(); }
    void changedBytesAreTakenOrRefused()
    {
        const auto& [name, target, trials] = here();
        const std::vector<std::string> seeds = target.seeds();
        int refused = 0;
        for (std::size_t trial = 0; trial < trials; ++trial) {
            fuzz::Random random(1'000'003 + trial);
            std::string bytes = random.oneOf(seeds);
            for (std::size_t changes = 1 + random.below(3); changes > 0; --changes)
                random.chance(50) ? fuzz::mutateText(bytes, random) : fuzz::mutateBytes(bytes, random);
            try {
                refused += target.read(bytes) ? 0 : 1;
            } catch (const std::exception& error) {
                QFAIL(("trial " + std::to_string(trial) + ": " + error.what()).c_str());
            }
        }
        QVERIFY(refused > 0);
    }

private:
    static void eachTarget()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const fuzz::NamedTarget& target : fuzz::allTargets())
            QTest::newRow(target.name) << number++;
    }
    static fuzz::NamedTarget here()
    {
        QFETCH(int, number);
        return fuzz::allTargets()[static_cast<std::size_t>(number)];
    }
};

QTEST_GUILESS_MAIN(FuzzTargetsTest)
#include "fuzz_targets_test.moc"
