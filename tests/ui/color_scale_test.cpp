#include "ui/viewport/color_scale.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace knead;

namespace {

/// Lightness in CIELAB, of an sRGB color under daylight.
double lightness(const Color& color)
{
    const auto linear = [](float channel) {
        const auto c = static_cast<double>(channel);
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double linearOf(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

Triple times(const Matrix& matrix, const Triple& v)
{
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    return product;
}

struct Eyes {
    const char* name;
    Matrix seen; ///< linear sRGB to linear sRGB
};

/// As people see who lack one kind of cones, by Machado, Oliveira and Fernandes (2009), severity 1.
constexpr Eyes eyes[] = {
    {"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
};

/// CIELAB of a color as some eyes see it, under daylight.
Triple labOf(const Color& color, const Matrix& seen)
{
    Triple light = times(seen, {linearOf(color.r), linearOf(color.g), linearOf(color.b)});
    for (double& channel : light)
        channel = std::clamp(channel, 0.0, 1.0);
    constexpr Matrix toXyz{
        {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
    constexpr Triple white{0.95047, 1, 1.08883};
    Triple f = times(toXyz, light);
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = f[i] / white[i];
        f[i] = t > 0.008856 ? std::cbrt(t) : (903.3 * t + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// CIE 1976: about 2 is just seen side by side.
double differenceOf(const Triple& a, const Triple& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

QStringList texts(const ColorScale& scale)
{
    QStringList all;
    for (const ScaleText::Tick& tick : textOf(scale).ticks)
        all << tick.text;
    return all;
}

SurfaceFields fieldsOf(SurfaceQuantity quantity, std::vector<std::vector<float>> values)
{
    SurfaceFields fields;
    fields.request.quantity = quantity;
    fields.values = std::move(values);
    return fields;
}

bool all(std::size_t /*body*/)
{
    return true;
}

} // namespace

class ColorScaleTest : public QObject {
    Q_OBJECT

private slots:
    /// Equal steps along the map are equal steps of lightness, within what ten places of a table can do.
    void lightnessRisesEvenly()
    {
        for (const ColorMapChoice& choice : colorMapChoices()) {
            const ColorMap map = choice.map;
            const double low = lightness(colorAt(map, 0));
            const double high = lightness(colorAt(map, 1));
            QVERIFY(high - low > 70);
            for (int i = 0; i < 100; ++i)
                QVERIFY(lightness(colorAt(map, (i + 1) / 100.0)) > lightness(colorAt(map, i / 100.0)));
            for (int i = 0; i <= 100; ++i)
                QVERIFY(std::abs(lightness(colorAt(map, i / 100.0)) - low - (high - low) * i / 100.0) < 5);
        }
    }

    void signsAreEquallyFarFromTheMiddle()
    {
        for (int i = 0; i <= 50; ++i) {
            const double below = lightness(colorAt(ColorMap::diverging, 0.5 - i / 100.0));
            const double above = lightness(colorAt(ColorMap::diverging, 0.5 + i / 100.0));
            QVERIFY(std::abs(below - above) < 4);
            QVERIFY(std::abs(below - (95 - 57 * i / 50.0)) < 4);
        }
        QVERIFY(colorAt(ColorMap::diverging, 0).b > 0.5F && colorAt(ColorMap::diverging, 1).b < 0.1F);
    }

    /// Ten steps of a legend differ from their neighbors for all eyes, and more is lighter.
    void mapsAreReadWithoutSomeColors()
    {
        constexpr int steps = 10;
        constexpr double wellSeen = 5; // twice what is just seen
        for (const Eyes& eye : eyes)
            for (const ColorMapChoice& choice : colorMapChoices()) {
                const auto at = [&](int i) { return labOf(colorAt(choice.map, 1.0 * i / steps), eye.seen); };
                for (int i = 0; i < steps; ++i) {
                    const std::string where = std::string(choice.name) + ", " + eye.name + ", " + std::to_string(i) +
                                              ": " + std::to_string(differenceOf(at(i), at(i + 1)));
                    QVERIFY2(at(i + 1)[0] > at(i)[0], where.c_str());
                    QVERIFY2(differenceOf(at(i), at(i + 1)) > wellSeen, where.c_str());
                }
            }
    }

    /// Less and more than the middle are as far from each other as they are from it, at least; each half is told by its steps.
    void signsAreToldApartWithoutSomeColors()
    {
        constexpr int steps = 5; // of a half
        constexpr double wellSeen = 5;
        for (const Eyes& eye : eyes) {
            const auto at = [&](int i) { return labOf(colorAt(ColorMap::diverging, 0.5 + 0.5 * i / steps), eye.seen); };
            for (int i = 1; i <= steps; ++i) {
                const std::string where = std::string(eye.name) + ", " + std::to_string(i) + ": " +
                                          std::to_string(differenceOf(at(-i), at(i)));
                QVERIFY2(differenceOf(at(-i), at(i)) > 2 * wellSeen, where.c_str());
                for (const int sign : {-1, 1}) {
                    QVERIFY2(at(sign * i)[0] < at(sign * (i - 1))[0], where.c_str());
                    QVERIFY2(differenceOf(at(sign * i), at(sign * (i - 1))) > wellSeen, where.c_str());
                }
            }
        }
    }

    void tablesEndAsTheMapsDo()
    {
        const ColorTable& table = colorTable(ColorMap::viridis);
        QCOMPARE(int(table[0][0]), 0x44);
        QCOMPARE(int(table[255][0]), 0xfd);
        QCOMPARE(colorAt(ColorMap::viridis, 7).r, colorAt(ColorMap::viridis, 1).r);
    }

    void automaticRangesEndAtRoundNumbers()
    {
        QCOMPARE(roundedUp(0.0), 0.0);
        QVERIFY(std::abs(roundedUp(0.0137) - 0.015) < 1e-12);
        QVERIFY(std::abs(roundedUp(6.1) - 8) < 1e-12);
        QVERIFY(std::abs(roundedUp(9.2e6) - 1e7) < 1e-3);
        const SurfaceFields fields = fieldsOf(SurfaceQuantity::displacement, {{0, 0.004F, 0.0137F}, {0.5F}});
        const ColorScale first =
            colorScale(fields, {}, [](std::size_t body) { return body == 0; }); // the other is hidden
        QCOMPARE(first.least, 0.0);
        QVERIFY(std::abs(first.most - 0.015) < 1e-9);
        QVERIFY(std::abs(first.shareOf(0.0075) - 0.5) < 1e-6);
        QVERIFY(colorScale(fields, {}, all).most > 0.49);
    }

    void distancesHaveZeroInTheMiddle()
    {
        const ColorScale scale = colorScale(fieldsOf(SurfaceQuantity::distance, {{-0.003F, 0.001F}}), {}, all);
        QCOMPARE(scale.map, ColorMap::diverging);
        QCOMPARE(scale.least, -scale.most);
        QVERIFY(std::abs(scale.most - 0.003) < 1e-9);
        QVERIFY(std::abs(scale.shareOf(0) - 0.5) < 1e-12);
        QVERIFY(texts(scale).contains("0") && texts(scale).contains("-1") && texts(scale).contains("1"));
    }

    void stressSaysHowWrongItMayBe()
    {
        SurfaceFields fields = fieldsOf(SurfaceQuantity::vonMisesStress, {{0, 2e6F}});
        fields.errorShare = 0.0771;
        QCOMPARE(textOf(colorScale(fields, {}, all)).title, QString("Von Mises stress [MPa], about ±8 %"));
        fields.errorShare = 0.11;
        QCOMPARE(textOf(colorScale(fields, {}, all)).title, QString("Von Mises stress [MPa], about ±12 %"));
        fields.errorShare = 0;
        QCOMPARE(textOf(colorScale(fields, {}, all)).title, QString("Von Mises stress [MPa]"));
    }

    void nothingToSeeHasARangeToo()
    {
        for (std::size_t i = 0; i < surfaceQuantityCount; ++i) {
            const ColorScale scale = colorScale(fieldsOf(static_cast<SurfaceQuantity>(i), {{0, 0}}), {}, all);
            QVERIFY(scale.most > scale.least);
            QVERIFY(textOf(scale).ticks.size() >= 4);
        }
    }

    void legendsHaveUnitsThatKeepNumbersShort()
    {
        ColorScale scale{.quantity = SurfaceQuantity::vonMisesStress, .least = 0, .most = 2.5e6};
        QCOMPARE(textOf(scale).title, QString("Von Mises stress [MPa]"));
        QCOMPARE(texts(scale), (QStringList{"0", "0.5", "1", "1.5", "2", "2.5"}));
        scale.most = 800;
        QCOMPARE(textOf(scale).title, QString("Von Mises stress [Pa]"));
        QCOMPARE(texts(scale), (QStringList{"0", "200", "400", "600", "800"}));
        scale = {.quantity = SurfaceQuantity::strain, .least = 0, .most = 0.12};
        QCOMPARE(textOf(scale).title, QString("Strain [%]"));
        QCOMPARE(texts(scale), (QStringList{"0", "2", "4", "6", "8", "10", "12"}));
        scale = {.quantity = SurfaceQuantity::displacement, .least = 0.0013, .most = 0.0021}; // as typed
        QCOMPARE(textOf(scale).title, QString("Displacement [mm]"));
        QCOMPARE(texts(scale), (QStringList{"1.4", "1.6", "1.8", "2"}));
        QVERIFY(std::abs(textOf(scale).ticks.front().share - 0.125) < 1e-9);
    }

    void strainsAreTypedInPercent()
    {
        QCOMPARE(parseQuantity("12", Quantity::Strain, 0.05).value_or(0), 0.12);
        QCOMPARE(parseQuantity("1,5 %", Quantity::Strain).value_or(0), 0.015);
        QCOMPARE(formatQuantity(0.125, Quantity::Strain), QString("12.5 %"));
    }
};

QTEST_APPLESS_MAIN(ColorScaleTest)
#include "color_scale_test.moc"
