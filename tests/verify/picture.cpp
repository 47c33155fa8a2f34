#include "verify/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace knead::book {

namespace {

// Measures of all pictures [px].
constexpr double width = 340;
constexpr double height = 240;
constexpr double margin = 12;
constexpr double left = 58; // of plots, for the labels of the axis
constexpr double bottom = 42;

constexpr std::array<const char*, 6> colors = {"#1f5fa8", "#c2511a", "#2b8a3e", "#8a4fbf", "#a08000", "#444444"};

std::string format(const char* pattern, double a, double b = 0, double c = 0, double d = 0)
{
    char text[200];
    std::snprintf(text, sizeof text, pattern, a, b, c, d);
    return text;
}

std::string head()
{
    return format("<svg xmlns='http://www.w3.org/2000/svg' width='%g' height='%g' viewBox='0 0 %g %g' "
                  "font-family='sans-serif' font-size='11'>\n",
                  width, height, width, height);
}

std::string label(double x, double y, const std::string& text, const std::string& more = "")
{
    return format("<text x='%.1f' y='%.1f' ", x, y) + more + ">" + escaped(text) + "</text>\n";
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// A step of 1, 2 or 5 times a power of ten that divides a range into three to eight.
double niceStep(double range)
{
    const double power = std::pow(10, std::floor(std::log10(range / 3)));
    const double rest = range / 3 / power;
    return power * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
}

/// Axes, and where values stand.
struct Plot {
    Range x, y;

    double px(double value) const { return left + (width - left - margin) * (value - x.low) / (x.high - x.low); }
    double py(double value) const
    {
        return height - bottom - (height - bottom - margin) * (value - y.low) / (y.high - y.low);
    }
    std::string frame(const std::string& xLabel, const std::string& yLabel) const
    {
        return format("<path d='M%g %gV%gH%g' fill='none' stroke='#222'/>\n", left, margin, height - bottom,
                      width - margin) +
               label((left + width) / 2, height - 6, xLabel, "text-anchor='middle'") +
               label(12, height / 2 - 10, yLabel,
                     format("text-anchor='middle' transform='rotate(-90 12 %g)'", height / 2 - 10));
    }
    std::string xTick(double value, const std::string& text) const
    {
        return format("<path d='M%.1f %.1fv4' stroke='#222'/>\n", px(value), height - bottom) +
               label(px(value), height - bottom + 15, text, "text-anchor='middle'");
    }
    std::string yTick(double value, const std::string& text) const
    {
        return format("<path d='M%.1f %.1fH%.1f' stroke='#ddd'/>\n", left, py(value), width - margin) +
               label(left - 5, py(value) + 4, text, "text-anchor='end'");
    }
    std::string line(const Curve& curve, std::size_t color, bool marks) const
    {
        std::string points;
        std::string dots;
        for (const Curve::Point& p : curve.points) {
            points += format("%.1f,%.1f ", px(p.x), py(p.y));
            if (marks)
                dots += format("<circle cx='%.1f' cy='%.1f' r='3' fill='", px(p.x), py(p.y)) + colors[color] + "'/>\n";
        }
        return "<polyline fill='none' stroke-width='1.6' stroke='" + std::string(colors[color]) + "' points='" +
               points + "'/>\n" + dots;
    }
    std::string legend(const std::vector<Curve>& curves) const
    {
        std::string text;
        for (std::size_t i = 0; i < curves.size(); ++i)
            text += label(left + 8, margin + 12 + 13 * static_cast<double>(i), curves[i].name,
                          "fill='" + std::string(colors[i % colors.size()]) + "'");
        return text;
    }
};

} // namespace

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

std::string shadedSvg(const TriangleMesh& mesh)
{
    if (mesh.empty())
        return "";
    // From the front, right and above: x to the right, z up, y away.
    const Mat3 view = (Eigen::AngleAxisd(0.45, Vec3::UnitX()) * Eigen::AngleAxisd(-0.55, Vec3::UnitZ())).matrix();
    const Vec3 light = Vec3(-0.35, -0.75, 0.6).normalized();
    std::vector<Vec3> places;
    Range x, y;
    for (const Vec3& vertex : mesh.vertices) {
        places.push_back(view * vertex);
        x.add(places.back().x());
        y.add(places.back().z());
    }
    const double scale = std::min((width - 2 * margin) / (x.high - x.low), (height - 2 * margin) / (y.high - y.low));
    struct Face {
        double depth;
        std::string text;
    };
    std::vector<Face> faces;
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
        const Vec3 normal = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]);
        if (!(normal.y() < 0) || !normal.allFinite())
            continue; // looks away
        const double brightness = 0.35 + 0.6 * std::max(0.0, normal.normalized().dot(light));
        std::string text = "<path d='";
        for (std::size_t c = 0; c < 3; ++c)
            text += (c == 0 ? "M" : "L") + format("%.1f %.1f",
                                                  width / 2 + scale * (places[t[c]].x() - (x.low + x.high) / 2),
                                                  height / 2 - scale * (places[t[c]].z() - (y.low + y.high) / 2));
        char color[8];
        std::snprintf(color, sizeof color, "#%02x%02x%02x", static_cast<unsigned>(215 * brightness),
                      static_cast<unsigned>(160 * brightness), static_cast<unsigned>(125 * brightness));
        text += "Z' fill='" + std::string(color) + "' stroke='" + color + "' stroke-width='.4'/>\n";
        faces.push_back({std::max({places[t[0]].y(), places[t[1]].y(), places[t[2]].y()}), std::move(text)});
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth > b.depth; });
    std::string svg = head();
    for (const Face& face : faces)
        svg += face.text;
    return svg + "</svg>\n";
}

std::string curvesSvg(const std::vector<Curve>& curves, const std::string& axes)
{
    Plot plot;
    for (const Curve& curve : curves)
        for (const Curve::Point& p : curve.points) {
            plot.x.add(p.x);
            plot.y.add(p.y);
        }
    plot.y.add(0);
    plot.y.high += 0.1 * (plot.y.high - plot.y.low);
    if (!(plot.x.high > plot.x.low && plot.y.high > plot.y.low))
        return "";
    const std::size_t semicolon = axes.find(';');
    std::string svg = head();
    for (const bool upright : {false, true}) {
        const Range& range = upright ? plot.y : plot.x;
        const double step = niceStep(range.high - range.low);
        for (double value = std::ceil(range.low / step) * step; value <= range.high; value += step) {
            const std::string text = format("%g", std::abs(value) < 1e-9 * step ? 0 : value);
            svg += upright ? plot.yTick(value, text) : plot.xTick(value, text);
        }
    }
    svg += plot.frame(axes.substr(0, semicolon), semicolon == std::string::npos ? "" : axes.substr(semicolon + 1));
    for (std::size_t i = 0; i < curves.size(); ++i)
        svg += plot.line(curves[i], i % colors.size(), false);
    return svg + plot.legend(curves) + "</svg>\n";
}

std::string convergenceSvg(const std::vector<Curve>& errors)
{
    constexpr double least = 1e-4; // smaller errors stand on the lower border
    Plot plot;
    std::vector<Curve> logs;
    Range cells;
    for (const Curve& curve : errors) {
        logs.push_back({curve.name, {}});
        for (const Curve::Point& p : curve.points)
            if (std::isfinite(p.y)) {
                logs.back().points.push_back({std::log10(p.x), std::log10(std::max(p.y, least))});
                plot.x.add(logs.back().points.back().x);
                plot.y.add(logs.back().points.back().y);
                cells.add(p.x);
            }
    }
    if (!(plot.x.high > plot.x.low))
        return "";
    plot.y = {std::floor(plot.y.low), std::max(std::ceil(plot.y.high), std::floor(plot.y.low) + 1)};
    plot.x.low -= 0.05;
    plot.x.high += 0.05;
    std::string svg = head();
    for (double decade = plot.y.low; decade <= plot.y.high + 0.5; decade += 1)
        svg += plot.yTick(decade, format("%g %%", 100 * std::pow(10, decade)));
    for (const Curve::Point& p : logs.front().points)
        svg += plot.xTick(p.x, format("%.3g", std::pow(10, p.x)));
    svg += plot.frame("cells across", "error");
    for (std::size_t i = 0; i < logs.size(); ++i)
        svg += plot.line(logs[i], i % colors.size(), true);
    return svg + plot.legend(logs) + "</svg>\n";
}

} // namespace knead::book
