// Lengths in recipes keep their bits, though they are millimeters.
#include "io/json/exact_number.h"
#include "io/json/json_reader.h"
#include "support/fuzz_random.h"

#include <QtTest>

#include <bit>
#include <cmath>

using namespace knead;

namespace {

double readAsMillimeters(const std::string& text)
{
    return JsonNode::readText("[" + text + "]", "test").thousandths(1).front();
}

} // namespace

class ExactNumberTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreAsPeopleWriteThem()
    {
        QCOMPARE(exactThousandfold(0.0025), std::string("2.5"));
        QCOMPARE(exactThousandfold(0.1), std::string("100"));
        QCOMPARE(exactThousandfold(-12), std::string("-12000"));
        QCOMPARE(exactThousandfold(1e-6), std::string("0.001"));
        QCOMPARE(exactThousandfold(0.0123456789), std::string("12.3456789"));
        QCOMPARE(exactThousandfold(1e-12), std::string("1e-9"));
        QCOMPARE(exactThousandfold(1.5e20), std::string("1.5e23"));
        QCOMPARE(exactThousandfold(0), std::string("0"));
        QCOMPARE(exactText(-0.0), std::string("-0.0"));
    }

    void anyLengthComesBackToTheLastBit()
    {
        fuzz::Random random(5);
        for (int i = 0; i < 50'000; ++i) {
            const auto bits = random.next();
            double value = std::bit_cast<double>(bits);
            if (i % 2 == 0) // of the size of parts
                value = std::ldexp(1 + static_cast<double>(bits >> 12U) * 0x1p-52, static_cast<int>(bits % 16) - 14);
            if (!std::isfinite(value) || std::abs(value) > 1e300)
                continue;
            QCOMPARE(std::bit_cast<std::uint64_t>(readAsMillimeters(exactThousandfold(value))),
                     std::bit_cast<std::uint64_t>(value));
        }
    }

    void millimetersAreRoundedOnce()
    {
        QCOMPARE(readAsMillimeters("12.3"), 0.0123);
        QCOMPARE(readAsMillimeters("7"), 0.007);
        QCOMPARE(readAsMillimeters("1.1e1"), 0.011);
        QCOMPARE(readAsMillimeters("-3e-3"), -3e-6);
    }
};

QTEST_GUILESS_MAIN(ExactNumberTest)
#include "exact_number_test.moc"
