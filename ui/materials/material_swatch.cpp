#include "ui/materials/material_swatch.h"

#include <QCoreApplication>
#include <QHash>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace knead {

namespace {

constexpr int side = 96; // [pixels]; icons are drawn smaller, also at twice the scale

enum class Finish { matte, satin, gloss, clear, metal };
enum class Grain { none, pores, stripes, specks };

struct Look {
    QColor color;
    Finish finish = Finish::satin;
    Grain grain = Grain::none;
};

const QHash<QString, Look>& looks()
{
    static const QHash<QString, Look> all{
        {"soft-jelly", {"#e2506e", Finish::clear}},
        {"jelly", {"#59b552", Finish::clear}},
        {"soft-foam", {"#f0dfa8", Finish::matte, Grain::pores}},
        {"sponge-rubber", {"#50565e", Finish::matte, Grain::pores}},
        {"silicone-rubber", {"#6fc3c9", Finish::satin}},
        {"modeling-clay", {"#b5673f", Finish::matte, Grain::specks}},
        {"natural-rubber", {"#c98a3a", Finish::satin}},
        {"plasticine", {"#4a78c8", Finish::matte}},
        {"rigid-foam", {"#dfe4e8", Finish::matte, Grain::specks}},
        {"wax", {"#f2e6c4", Finish::gloss}},
        {"abs", {"#33383e", Finish::gloss}},
        {"wood-along-grain", {"#b98349", Finish::satin, Grain::stripes}},
        {"aluminum", {"#c4cad1", Finish::metal}},
        {"glass", {"#a9d7e8", Finish::clear}},
        {"steel", {"#7f8b99", Finish::metal}},
        {"silicone-shore-10", {"#8fd3d0", Finish::satin}},
        {"silicone-shore-20", {"#7cc6d6", Finish::satin}},
        {"silicone-shore-30", {"#63b3cf", Finish::satin}},
        {"silicone-shore-40", {"#5a9fc6", Finish::satin}},
        {"silicone-shore-50", {"#4f89b5", Finish::satin}},
        {"silicone-shore-60", {"#45729c", Finish::satin}},
        {"tpu-85a", {"#e8883a", Finish::satin}},
        {"tpu-95a", {"#d2622c", Finish::satin}},
        {"pla", {"#6a9e4b", Finish::gloss}},
        {"petg", {"#b9d3c4", Finish::clear}},
        {"nylon-pa12", {"#ecebe4", Finish::matte, Grain::specks}},
        {"oil-clay", {"#8a9a5b", Finish::matte}},
        {"water-clay", {"#8d8578", Finish::matte, Grain::specks}},
    };
    return all;
}

/// Stiff things shine, what flows is dull; the hue goes with the name.
Look lookOf(const MaterialPreset& preset)
{
    const QString id = QString::fromStdString(preset.id);
    if (const auto found = looks().find(id); found != looks().end())
        return *found;
    constexpr double stiff = 1e10;
    constexpr double firm = 1e8;
    unsigned sum = 0; // not qHash(), which differs from run to run
    for (const char letter : preset.name)
        sum = 31 * sum + static_cast<unsigned char>(letter);
    const int hue = static_cast<int>(sum % 360U);
    const Material& material = preset.material;
    if (material.youngsModulus >= stiff)
        return {QColor::fromHsv(hue, 40, 190), Finish::metal};
    const Finish finish = material.yields()                ? Finish::matte
                          : material.youngsModulus >= firm ? Finish::gloss
                                                           : Finish::satin;
    return {QColor::fromHsv(hue, 140, 200), finish};
}

void paintBody(QPainter& painter, const Look& look, const QRectF& ball)
{
    QRadialGradient shade(ball.center() + QPointF(-0.22 * ball.width(), -0.28 * ball.height()), 0.85 * ball.width());
    const bool isMetal = look.finish == Finish::metal;
    shade.setColorAt(0, look.color.lighter(isMetal ? 150 : 122));
    shade.setColorAt(isMetal ? 0.35 : 0.5, look.color);
    shade.setColorAt(isMetal ? 0.55 : 1, look.color.darker(isMetal ? 175 : 185));
    if (isMetal)
        shade.setColorAt(0.8, look.color.darker(112));
    painter.setPen(QPen(look.color.darker(210), 2));
    painter.setBrush(shade);
    painter.drawEllipse(ball);
}

/// Always the same dots: a low-discrepancy sequence instead of chance.
void paintDots(QPainter& painter, const QRectF& ball, const QColor& color, int count, double size)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    for (int i = 1; i <= count; ++i) {
        const double x = std::fmod(0.7548776662 * i, 1.0);
        const double y = std::fmod(0.5698402910 * i, 1.0);
        const double radius = size * (0.6 + 0.4 * std::fmod(0.318 * i, 1.0));
        painter.drawEllipse(QPointF(ball.left() + x * ball.width(), ball.top() + y * ball.height()), radius, radius);
    }
}

void paintGrain(QPainter& painter, const Look& look, const QRectF& ball)
{
    const bool isDark = look.color.lightness() < 110;
    const QColor mark = isDark ? look.color.lighter(150) : look.color.darker(140);
    if (look.grain == Grain::pores) {
        paintDots(painter, ball, mark, 34, 4);
    } else if (look.grain == Grain::specks) {
        paintDots(painter, ball, mark, 60, 1.6);
    } else if (look.grain == Grain::stripes) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(mark, 3));
        for (int i = 0; i < 7; ++i) {
            const double y = ball.top() + (i + 0.5) / 7 * ball.height();
            QPainterPath line(QPointF(ball.left(), y + 4));
            line.cubicTo({ball.center().x() - 12, y - 9}, {ball.center().x() + 12, y + 9}, {ball.right(), y - 4});
            painter.drawPath(line);
        }
    }
}

void paintLight(QPainter& painter, const Look& look, const QRectF& ball)
{
    painter.setPen(Qt::NoPen);
    const QPointF spot = ball.center() + QPointF(-0.2 * ball.width(), -0.24 * ball.height());
    if (look.finish == Finish::clear) { // light gathers on the far side
        QRadialGradient glow(ball.center() + QPointF(0.18 * ball.width(), 0.24 * ball.height()), 0.45 * ball.width());
        glow.setColorAt(0, QColor(255, 255, 255, 170));
        glow.setColorAt(1, QColor(255, 255, 255, 0));
        painter.setBrush(glow);
        painter.drawEllipse(ball);
    }
    if (look.finish == Finish::matte)
        return;
    const double size = look.finish == Finish::satin ? 0.2 : 0.13;
    QRadialGradient light(spot, size * ball.width());
    light.setColorAt(0, QColor(255, 255, 255, look.finish == Finish::satin ? 120 : 240));
    light.setColorAt(1, QColor(255, 255, 255, 0));
    painter.setBrush(light);
    painter.drawEllipse(spot, size * ball.width(), size * ball.height());
}

} // namespace

QIcon materialSwatch(const MaterialPreset& preset)
{
    static QHash<QString, QIcon> known;
    const Look look = lookOf(preset);
    const QString key = QStringLiteral("%1 %2 %3")
                            .arg(look.color.name())
                            .arg(static_cast<int>(look.finish))
                            .arg(static_cast<int>(look.grain));
    QIcon& icon = known[key];
    if (!icon.isNull())
        return icon;
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF ball(5, 5, side - 10, side - 10);
    QPainterPath outline;
    outline.addEllipse(ball);
    paintBody(painter, look, ball);
    painter.setClipPath(outline);
    paintGrain(painter, look, ball);
    paintLight(painter, look, ball);
    painter.end();
    icon = QIcon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // in a selected line, too, it looks like the material
    return icon;
}

QString materialName(const MaterialPreset& preset)
{
    return QCoreApplication::translate("MaterialName", preset.name.c_str());
}

const MaterialField& fieldOf(double Material::*value)
{
    const auto& fields = materialFields();
    return *std::find_if(fields.begin(), fields.end(), [value](const MaterialField& f) { return f.value == value; });
}

} // namespace knead
