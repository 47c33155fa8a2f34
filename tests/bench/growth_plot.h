#pragma once

#include <string>
#include <vector>

namespace knead {

enum class PlotMarker { none, disc, square, diamond, triangle };

struct PlotCurve {
    struct Point {
        double x;
        double y;
    };
    std::string label;
    std::string color;                    ///< as in SVG
    PlotMarker marker = PlotMarker::none; ///< none: a dashed line, for curves that are no measurements
    std::vector<Point> points;            ///< x and y > 0
};

/// Curves over logarithmic axes.
struct GrowthPlot {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::string dashedLabel;    ///< what dashed curves are
    std::vector<double> xTicks; ///< ascending; the axis reaches a little further
    std::vector<PlotCurve> curves;
};

/// A picture of the plot, to be shown or printed about 18 cm wide.
/// @pre there is at least one tick and one point
std::string svgOf(const GrowthPlot& plot);

} // namespace knead
