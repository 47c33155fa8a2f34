#include "io/fields/solver_include.h"

#include "core/model/length_units.h"
#include "io/files/safe_file.h"
#include "io/formats/number_stream.h"

#include <array>
#include <charconv>

namespace knead {

namespace {

constexpr double bytesPerLine = 90;

/// One such file while it is written.
class IncludeWriter {
public:
    IncludeWriter(const SolverInclude& include, NumberStream& stream)
        : m_include(include)
        , m_stream(stream)
        , m_metres(findLengthUnit(include.unit)->metres)
    {
    }

    void run()
    {
        m_stream.add("** Written by Knead. Lengths are in " + m_include.unit + ", stress is in N/" + m_include.unit +
                     "^2.\n");
        addNodes();
        addStresses();
        addFlow();
    }

private:
    void addNodes()
    {
        if (m_include.nodes.empty())
            return;
        m_stream.add("** Nodes where the material is now, in place of those of the mesh.\n*NODE\n");
        for (const SolverInclude::Node& node : m_include.nodes) {
            m_stream.add(std::to_string(node.label));
            for (const double coordinate : node.place)
                addNumber(coordinate / m_metres);
            m_stream.add("\n");
        }
    }

    /// Both want xx, yy, zz, xy, xz, yz.
    void addStresses()
    {
        if (m_include.elements.empty())
            return;
        m_stream.add("** Stress that is there at the start.\n"
                     "*INITIAL CONDITIONS, TYPE=STRESS\n");
        const double scale = m_metres * m_metres;
        for (const SolverInclude::Element& element : m_include.elements) {
            for (std::size_t point = 0; point < element.stresses.size(); ++point) {
                m_stream.add(std::to_string(element.label));
                if (m_include.solver == Solver::calculix)
                    m_stream.add(", " + std::to_string(point + 1));
                const Mat3& s = element.stresses[point];
                for (const double component : {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)})
                    addNumber(scale * component);
                m_stream.add("\n");
            }
        }
    }

    void addFlow()
    {
        if (m_include.elements.empty() || !m_include.hasFlow || m_include.solver != Solver::abaqus)
            return;
        m_stream.add("** Equivalent plastic strain.\n*INITIAL CONDITIONS, TYPE=HARDENING\n");
        for (const SolverInclude::Element& element : m_include.elements) {
            m_stream.add(std::to_string(element.label));
            addNumber(element.plasticStrain);
            m_stream.add("\n");
        }
    }

    void addNumber(double number)
    {
        constexpr int digits = 12;
        std::array<char, 32> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::scientific, digits - 1)
                .ptr;
        m_stream.add(", ");
        m_stream.add({text.data(), static_cast<std::size_t>(end - text.data())});
    }

    const SolverInclude& m_include;
    NumberStream& m_stream;
    double m_metres;
};

} // namespace

void writeSolverInclude(const std::string& path, const SolverInclude& include, TaskControl& control)
{
    SafeFile target(path);
    NumberStream stream(target, control,
                        bytesPerLine * static_cast<double>(include.nodes.size() + include.elements.size()));
    IncludeWriter(include, stream).run();
    stream.flush();
    target.keep();
}

} // namespace knead
