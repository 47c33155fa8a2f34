#include "app/compensate/round_tables.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace knead {

namespace {

/// Rounds over a logarithmic axis of millimeters.
class RoundPlot {
public:
    RoundPlot(const std::vector<CompensationRound>& rounds, double tolerance)
        : m_rounds(rounds)
        , m_tolerance(1000 * tolerance)
    {
        double low = m_tolerance;
        double high = m_tolerance;
        for (const CompensationRound& round : rounds)
            for (const double value : {1000 * round.largest, 1000 * round.mean}) {
                low = value > 0 ? std::min(low, value) : low;
                high = std::max(high, value);
            }
        m_lowest = static_cast<int>(std::floor(std::log10(low)));
        m_highest = std::max(m_lowest + 1, static_cast<int>(std::ceil(std::log10(high))));
    }

    std::string svg()
    {
        m_out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
              << "' viewBox='0 0 " << width << ' ' << height
              << "' font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size='14'>\n"
              << "<rect width='" << width << "' height='" << height << "' fill='white'/>\n";
        drawAxes();
        const double y = yOf(m_tolerance);
        m_out << "<line x1='" << left << "' y1='" << y << "' x2='" << right << "' y2='" << y
              << "' stroke='#8a8a8a' stroke-width='1.3' stroke-dasharray='6 4'/>\n";
        label(y, "tolerance", "#606060");
        drawCurve("largest", "#c0392b", &CompensationRound::largest);
        drawCurve("mean", "#2c6fbb", &CompensationRound::mean);
        m_out << "</svg>\n";
        return m_out.str();
    }

private:
    // The drawing area within the picture, in pixels.
    static constexpr double width = 720;
    static constexpr double height = 440;
    static constexpr double left = 84;
    static constexpr double right = 590; // labels of curves stand between it and the border
    static constexpr double top = 30;
    static constexpr double bottom = 380;

    double xOf(std::size_t round) const
    {
        return left + (static_cast<double>(round) + 0.5) * (right - left) / static_cast<double>(m_rounds.size());
    }
    /// Nothing at all stands at the foot.
    double yOf(double value) const
    {
        const double exponent = value > 0 ? std::max<double>(m_lowest, std::log10(value)) : m_lowest;
        return bottom - (exponent - m_lowest) * (bottom - top) / (m_highest - m_lowest);
    }

    void text(double x, double y, const char* anchor, const std::string& words, const char* color = "#222")
    {
        m_out << "<text x='" << x << "' y='" << y << "' text-anchor='" << anchor << "' fill='" << color << "'>" << words
              << "</text>\n";
    }

    /// At the right border, no two in one place.
    void label(double y, const std::string& words, const char* color)
    {
        while (std::ranges::any_of(m_labels, [&](double other) { return std::abs(other - y) < 16; }))
            y += 1;
        m_labels.push_back(y);
        text(right + 8, y + 5, "start", words, color);
    }

    void drawAxes()
    {
        for (int decade = m_lowest; decade <= m_highest; ++decade) {
            const double y = yOf(std::pow(10.0, decade));
            std::ostringstream words;
            words << std::pow(10.0, decade);
            m_out << "<line x1='" << left << "' y1='" << y << "' x2='" << right << "' y2='" << y
                  << "' stroke='#e4e4e4'/>\n";
            text(left - 10, y + 5, "end", words.str());
        }
        for (std::size_t round = 0; round < m_rounds.size(); ++round)
            text(xOf(round), bottom + 22, "middle", std::to_string(m_rounds[round].number));
        m_out << "<polyline fill='none' stroke='#222' stroke-width='1.2' points='" << left << ',' << top << ' ' << left
              << ',' << bottom << ' ' << right << ',' << bottom << "'/>\n";
        text((left + right) / 2, height - 16, "middle", "round");
        text(left, top - 10, "middle", "deviation [mm]");
    }

    void drawCurve(const std::string& name, const char* color, double CompensationRound::*value)
    {
        m_out << "<polyline fill='none' stroke='" << color << "' stroke-width='2' points='";
        for (std::size_t round = 0; round < m_rounds.size(); ++round)
            m_out << xOf(round) << ',' << yOf(1000 * m_rounds[round].*value) << ' ';
        m_out << "'/>\n";
        for (std::size_t round = 0; round < m_rounds.size(); ++round)
            m_out << "<circle cx='" << xOf(round) << "' cy='" << yOf(1000 * m_rounds[round].*value)
                  << "' r='4' fill='white' stroke='" << color << "' stroke-width='2'/>\n";
        label(yOf(1000 * m_rounds.back().*value), name, color);
    }

    const std::vector<CompensationRound>& m_rounds;
    double m_tolerance; ///< [mm]
    int m_lowest = 0;   ///< decades of the axis
    int m_highest = 1;
    std::vector<double> m_labels; ///< heights that are taken
    std::ostringstream m_out;
};

} // namespace

std::string plotOf(const std::vector<CompensationRound>& rounds, double tolerance)
{
    return RoundPlot(rounds, tolerance).svg();
}

} // namespace knead
