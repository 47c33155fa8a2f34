#include "ui/viewport/scene_style.h"

#include <cmath>

namespace knead {

namespace {

constexpr double clear = 0.9; // of a difference between colors: from here on nobody takes one for the other

} // namespace

double differenceOf(const Color& a, const Color& b)
{
    const double red = (a.r + b.r) / 2;
    const double dr = a.r - b.r;
    const double dg = a.g - b.g;
    const double db = a.b - b.b;
    return std::sqrt((2 + red) * dr * dr + 4 * dg * dg + (3 - red) * db * db);
}

const Color& standingOut(const Color& ground, const Color& usual, const Color& other)
{
    const double difference = differenceOf(ground, usual);
    return difference < clear && differenceOf(ground, other) > difference ? other : usual;
}

SceneStyle lightScene()
{
    return {.top = {0.97F, 0.98F, 0.99F},
            .bottom = {0.78F, 0.82F, 0.87F},
            .edge = {0.12F, 0.13F, 0.15F},
            .selectedEdge = {0.0F, 0.38F, 0.80F},
            .selectedOther = {1.0F, 0.80F, 0.0F},
            .grid = {0.42F, 0.46F, 0.52F},
            .tool = {0.93F, 0.62F, 0.22F},
            .selectedTool = {0.98F, 0.50F, 0.06F},
            .force = {0.80F, 0.10F, 0.16F},
            .openEdge = {0.90F, 0.05F, 0.45F},
            .highlight = {0.25F, 0.62F, 0.98F},
            .highlightOther = {1.0F, 0.89F, 0.42F},
            .fixed = {0.16F, 0.62F, 0.42F},
            .cube = {0.88F, 0.90F, 0.93F},
            .cubeText = {0.20F, 0.23F, 0.28F}};
}

SceneStyle darkScene()
{
    return {.top = {0.23F, 0.25F, 0.28F},
            .bottom = {0.11F, 0.12F, 0.14F},
            .edge = {0.05F, 0.05F, 0.06F},
            .selectedEdge = {0.45F, 0.75F, 1.0F},
            .selectedOther = {1.0F, 0.83F, 0.15F},
            .grid = {0.50F, 0.54F, 0.60F},
            .tool = {0.90F, 0.60F, 0.22F},
            .selectedTool = {1.0F, 0.56F, 0.12F},
            .force = {1.0F, 0.36F, 0.38F},
            .openEdge = {1.0F, 0.30F, 0.65F},
            .highlight = {0.35F, 0.68F, 1.0F},
            .highlightOther = {1.0F, 0.91F, 0.50F},
            .fixed = {0.24F, 0.72F, 0.50F},
            .cube = {0.34F, 0.37F, 0.42F},
            .cubeText = {0.92F, 0.94F, 0.96F}};
}

} // namespace knead
