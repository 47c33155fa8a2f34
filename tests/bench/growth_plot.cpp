#include "bench/growth_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace knead {

namespace {

// The drawing area within the picture, in pixels.
constexpr double width = 900;
constexpr double height = 620;
constexpr double left = 84;
constexpr double right = 812; // labels of curves stand between it and the border
constexpr double top = 52;
constexpr double bottom = 548;

/// A logarithmic axis: where on the picture a value stands.
struct Axis {
    double low;
    double high;
    double from; ///< pixel of low
    double to;   ///< pixel of high

    double at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }
};

/// Text for SVG; what follows a ^ is raised, to the end.
std::string marked(const std::string& text)
{
    std::string result;
    bool raised = false;
    for (const char c : text)
        if (c == '^') {
            result += "<tspan dy='-5' font-size='80%'>";
            raised = true;
        } else {
            result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
        }
    return raised ? result + "</tspan>" : result;
}

std::string grouped(double value)
{
    std::string digits = std::to_string(static_cast<long long>(std::llround(value)));
    for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
        digits.insert(static_cast<std::size_t>(i), 1, ',');
    return digits;
}

/// 0.01, 0.1, 1, 10, ... as a person writes it.
std::string labelOf(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return value >= 1 ? grouped(value) : text;
}

struct Text {
    const char* anchor = "middle"; ///< start, middle or end
    int size = 14;
    const char* color = "#222";
    const char* more = ""; ///< further attributes
};

class Drawing {
public:
    void line(double x1, double y1, double x2, double y2, const char* color, double strokeWidth)
    {
        m_out << "<line x1='" << x1 << "' y1='" << y1 << "' x2='" << x2 << "' y2='" << y2 << "' stroke='" << color
              << "' stroke-width='" << strokeWidth << "'/>\n";
    }
    void text(double x, double y, const std::string& words, const Text& style = {})
    {
        m_out << "<text x='" << x << "' y='" << y << "' font-size='" << style.size << "' text-anchor='" << style.anchor
              << "' fill='" << style.color << "' " << style.more << ">" << marked(words) << "</text>\n";
    }
    void polyline(const std::vector<PlotCurve::Point>& pixels, const std::string& color, bool dashed)
    {
        m_out << "<polyline fill='none' stroke='" << color << "' stroke-width='" << (dashed ? 1.3 : 2)
              << "' stroke-linejoin='round'" << (dashed ? " stroke-dasharray='6 4'" : "") << " points='";
        for (const auto& [x, y] : pixels)
            m_out << x << ',' << y << ' ';
        m_out << "'/>\n";
    }
    void marker(PlotMarker marker, const PlotCurve::Point& at, const std::string& color)
    {
        const auto polygon = [&](std::initializer_list<PlotCurve::Point> corners) {
            m_out << "<polygon points='";
            for (const auto& [x, y] : corners)
                m_out << at.x + x << ',' << at.y + y << ' ';
            m_out << "' ";
        };
        if (marker == PlotMarker::none)
            return;
        if (marker == PlotMarker::disc)
            m_out << "<circle cx='" << at.x << "' cy='" << at.y << "' r='4' ";
        else if (marker == PlotMarker::square)
            polygon({{-6, -6}, {6, -6}, {6, 6}, {-6, 6}});
        else if (marker == PlotMarker::diamond)
            polygon({{0, -6}, {6, 0}, {0, 6}, {-6, 0}});
        else
            polygon({{0, -5.8}, {5.4, 4.2}, {-5.4, 4.2}});
        m_out << "fill='white' stroke='" << color << "' stroke-width='2'/>\n";
    }
    std::string svg() const
    {
        std::ostringstream page;
        page << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
             << "' viewBox='0 0 " << width << ' ' << height
             << "' font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
             << "<rect width='" << width << "' height='" << height << "' fill='white'/>\n"
             << m_out.str() << "</svg>\n";
        return page.str();
    }

private:
    std::ostringstream m_out;
};

/// The power of ten at or below a value.
int decadeBelow(double value)
{
    return static_cast<int>(std::floor(std::log10(value)));
}

/// From 1, 2 or 5 times a power of ten below all values to a power of ten above them.
Axis verticalAxis(const GrowthPlot& plot)
{
    double low = std::numeric_limits<double>::max();
    double high = 0;
    for (const PlotCurve& curve : plot.curves)
        for (const PlotCurve::Point& point : curve.points) {
            low = std::min(low, point.y);
            high = std::max(high, point.y);
        }
    const double decade = std::pow(10.0, decadeBelow(low));
    const double factor = low > 5 * decade ? 5 : low > 2 * decade ? 2 : 1;
    return {factor * decade, std::pow(10.0, decadeBelow(high) + 1), bottom, top};
}

void drawAxes(Drawing& drawing, const GrowthPlot& plot, const Axis& x, const Axis& y)
{
    for (int decade = decadeBelow(y.low); decade <= decadeBelow(1.5 * y.high); ++decade) {
        const double power = std::pow(10.0, decade);
        for (int digit = 2; digit < 10; ++digit)
            if (power * digit >= y.low && power * digit < y.high)
                drawing.line(left - 4, y.at(power * digit), left, y.at(power * digit), "#222", 0.8);
        if (power < y.low)
            continue;
        drawing.line(left, y.at(power), right, y.at(power), "#e4e4e4", 1);
        drawing.line(left - 7, y.at(power), left, y.at(power), "#222", 1);
        drawing.text(left - 12, y.at(power) + 5, labelOf(power), {.anchor = "end"});
    }
    for (const double tick : plot.xTicks) {
        drawing.line(x.at(tick), top, x.at(tick), bottom, "#f0f0f0", 1);
        drawing.line(x.at(tick), bottom, x.at(tick), bottom + 7, "#222", 1);
        drawing.text(x.at(tick), bottom + 24, grouped(tick));
    }
    drawing.line(left, bottom, right, bottom, "#222", 1.2);
    drawing.line(left, top, left, bottom, "#222", 1.2);
    drawing.text((left + right) / 2, height - 18, plot.xLabel, {.size = 15});
    std::ostringstream turn;
    turn << "transform='rotate(-90 22 " << (top + bottom) / 2 << ")'";
    drawing.text(22, (top + bottom) / 2, plot.yLabel, {.size = 15, .more = turn.str().c_str()});
    drawing.text(left, 30, plot.title, {.anchor = "start", .size = 17, .more = "font-weight='bold'"});
}

std::vector<PlotCurve::Point> pixelsOf(const PlotCurve& curve, const Axis& x, const Axis& y)
{
    std::vector<PlotCurve::Point> pixels;
    for (const PlotCurve::Point& point : curve.points)
        pixels.push_back({x.at(point.x), y.at(point.y)});
    return pixels;
}

/// Names the dashed curves where they end, from the top down, no two closer than a line of text.
void labelEnds(Drawing& drawing, const GrowthPlot& plot, const Axis& y)
{
    struct End {
        double height;
        const PlotCurve* curve;
    };
    std::vector<End> ends;
    for (const PlotCurve& curve : plot.curves)
        if (curve.marker == PlotMarker::none && !curve.points.empty())
            ends.push_back({y.at(curve.points.back().y), &curve});
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.height < b.height; });
    double lowest = 0;
    for (const auto& [place, curve] : ends) {
        lowest = std::max(place, lowest + 17);
        drawing.text(right + 8, lowest + 5, curve->label,
                     {.anchor = "start", .color = curve->color.c_str(), .more = "font-style='italic'"});
    }
}

/// In the corner that growing curves leave free.
void drawLegend(Drawing& drawing, const GrowthPlot& plot)
{
    double line = top + 26;
    for (const PlotCurve& curve : plot.curves) {
        if (curve.marker == PlotMarker::none)
            continue;
        drawing.polyline({{left + 22, line}, {left + 62, line}}, curve.color, false);
        drawing.marker(curve.marker, {left + 42, line}, curve.color);
        drawing.text(left + 72, line + 5, curve.label, {.anchor = "start"});
        line += 24;
    }
    drawing.polyline({{left + 22, line}, {left + 62, line}}, "#8a8a8a", true);
    drawing.text(left + 72, line + 5, plot.dashedLabel, {.anchor = "start"});
}

} // namespace

std::string svgOf(const GrowthPlot& plot)
{
    const Axis x{plot.xTicks.front() / 1.35, plot.xTicks.back() * 1.2, left, right};
    const Axis y = verticalAxis(plot);
    Drawing drawing;
    drawAxes(drawing, plot, x, y);
    for (const bool measured : {false, true})
        for (const PlotCurve& curve : plot.curves) {
            if ((curve.marker != PlotMarker::none) != measured)
                continue;
            const auto pixels = pixelsOf(curve, x, y);
            drawing.polyline(pixels, curve.color, !measured);
            for (const PlotCurve::Point& pixel : pixels)
                drawing.marker(curve.marker, pixel, curve.color);
        }
    labelEnds(drawing, plot, y);
    drawLegend(drawing, plot);
    return drawing.svg();
}

} // namespace knead
