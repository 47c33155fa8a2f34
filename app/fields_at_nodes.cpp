#include "app/fields_at_nodes.h"

#include "core/mechanics/stress_law.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/model/length_units.h"
#include "io/fields/field_writer.h"
#include "io/fields/integration_points.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace knead {

namespace {

/// A field as it is asked for and written.
struct Field {
    const char* word; ///< as it is typed
    int components = 1;
    bool isLeftOut = false; ///< unless somebody asks for it
};

constexpr std::array<Field, 8> knownFields{{{"displacement", 3},
                                            {"velocity", 3, true},
                                            {"strain", 6},
                                            {"equivalent-strain"},
                                            {"plastic-strain"},
                                            {"stress", 6},
                                            {"von-mises"},
                                            {"contact-force", 3}}};

std::string fieldWords()
{
    std::string words;
    for (const Field& field : knownFields)
        words += (words.empty() ? "" : ", ") + std::string(field.word);
    return words;
}

bool isWanted(const FieldsRequest& request, const Field& field)
{
    return request.fields.empty() ? !field.isLeftOut
                                  : std::ranges::find(request.fields, field.word) != request.fields.end();
}

bool isWanted(const FieldsRequest& request, std::string_view word)
{
    return isWanted(request, *std::ranges::find(knownFields, word, &Field::word));
}

/// Nodes and values as they are written.
class ArraysOfStates {
public:
    ArraysOfStates(const FieldsRequest& request, const NodalMesh& mesh, const NodalStates& states)
        : m_request(request)
        , m_states(states)
        , m_count(mesh.nodes.size())
        , m_unit(mesh.unit)
        , m_perMetre(1 / findLengthUnit(mesh.unit)->metres)
    {
        m_fields.nodes = mesh.nodes;
        m_fields.labels = mesh.labels;
        m_fields.unit = mesh.unit;
        m_fields.cells = mesh.cells;
    }

    NodalFields make()
    {
        const bool isInMegapascal = m_unit == "mm";
        const double stress = isInMegapascal ? 1e-6 : 1;
        const std::string pascal = isInMegapascal ? " [MPa]" : " [Pa]";
        // Nodes of the present shape are no X to which a displacement belongs: nobody should take it for one.
        const char* way = m_request.at == NodesAt::rest ? "displacement [" : "moved from rest by [";
        addVectors("displacement", way + m_unit + "]", m_states.displacement, m_perMetre);
        addVectors("velocity", "velocity [" + m_unit + "/s]", m_states.velocity, m_perMetre);
        addTensors("strain", "strain", m_states.strain, 1);
        addNumbers("equivalent-strain", "equivalent strain", m_states.strain.size(),
                   [&](std::size_t node) { return equivalentStrain(m_states.strain[node]); });
        addNumbers("plastic-strain", "equivalent plastic strain", m_states.plasticStrain.size(),
                   [&](std::size_t node) { return m_states.plasticStrain[node]; });
        addTensors("stress", "stress" + pascal, m_states.stress, stress);
        addNumbers("von-mises", "von Mises stress" + pascal, m_states.stress.size(),
                   [&](std::size_t node) { return stress * vonMisesStress(m_states.stress[node]); });
        addVectors("contact-force", "contact force [N]", m_states.contactForce, 1);
        add("outside by [" + m_unit + "]", 1,
            [&](std::size_t node, double* to) { *to = m_perMetre * m_states.outside[node]; });
        return std::move(m_fields);
    }

private:
    void add(std::string name, int components, const std::function<void(std::size_t node, double* to)>& tell)
    {
        NodalFields::Array array{.name = std::move(name), .components = components, .values = {}};
        array.values.resize(m_count * static_cast<std::size_t>(components));
        for (std::size_t node = 0; node < m_count; ++node)
            tell(node, array.values.data() + node * static_cast<std::size_t>(components));
        m_fields.arrays.push_back(std::move(array));
    }

    void addNumbers(const char* word, const std::string& name, std::size_t known,
                    const std::function<double(std::size_t node)>& number)
    {
        if (known > 0 && isWanted(m_request, word))
            add(name, 1, [&](std::size_t node, double* to) { *to = number(node); });
    }

    void addVectors(const char* word, const std::string& name, const std::vector<Vec3>& vectors, double scale)
    {
        if (!vectors.empty() && isWanted(m_request, word))
            add(name, 3, [&](std::size_t node, double* to) { Vec3::Map(to) = scale * vectors[node]; });
    }

    /// xx, yy, zz, xy, yz, xz
    void addTensors(const char* word, const std::string& name, const std::vector<Mat3>& tensors, double scale)
    {
        if (!tensors.empty() && isWanted(m_request, word))
            add(name, 6, [&](std::size_t node, double* to) {
                const Mat3& t = tensors[node];
                for (const double component : {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)})
                    *to++ = scale * component;
            });
    }

    const FieldsRequest& m_request;
    const NodalStates& m_states;
    std::size_t m_count;
    std::string m_unit;
    double m_perMetre;
    NodalFields m_fields;
};

/// Where in solid elements stress is asked for.
struct ElementPlaces {
    std::vector<Vec3> places; ///< [m]
    std::vector<std::size_t> cells;
    std::vector<std::size_t> first = {0}; ///< per cell of these, and one more: its first place
};

ElementPlaces elementPlaces(const NodalMesh& mesh, Solver solver)
{
    ElementPlaces all;
    for (std::size_t c = 0; c < mesh.cells.types.size(); ++c) {
        if (!isSolidCell(mesh, c))
            continue;
        const std::vector<Vec3> own =
            solver == Solver::calculix ? integrationPlaces(mesh, c) : std::vector{centerOf(mesh, c)};
        all.places.insert(all.places.end(), own.begin(), own.end());
        all.cells.push_back(c);
        all.first.push_back(all.places.size());
    }
    return all;
}

/// @param states of the nodes, then of the places
SolverInclude includeOf(const FieldsRequest& request, const NodalMesh& mesh, const ElementPlaces& elements,
                        const NodalStates& states)
{
    SolverInclude include{.solver = request.solver, .unit = mesh.unit};
    const auto labelOf = [](const std::vector<std::int64_t>& labels, std::size_t i) {
        return labels.empty() ? static_cast<std::int64_t>(i + 1) : labels[i];
    };
    if (isWanted(request, "displacement") && request.at == NodesAt::rest)
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
            if (states.body[n] != NodePlace::none)
                include.nodes.push_back({labelOf(mesh.labels, n), mesh.nodes[n] + states.displacement[n]});
    include.hasFlow = isWanted(request, "plastic-strain") && !states.plasticStrain.empty();
    if (!isWanted(request, "stress") || states.stress.empty())
        return include;
    for (std::size_t i = 0; i < elements.cells.size(); ++i) {
        SolverInclude::Element element{.label = labelOf(mesh.cells.labels, elements.cells[i]), .stresses = {}};
        const std::size_t begin = mesh.nodes.size() + elements.first[i];
        const std::size_t end = mesh.nodes.size() + elements.first[i + 1];
        for (std::size_t at = begin; at < end; ++at)
            if (states.stress[at].allFinite())
                element.stresses.push_back(states.stress[at]);
        element.plasticStrain = states.plasticStrain[begin];
        if (element.stresses.size() == end - begin) // else some of it is outside
            include.elements.push_back(std::move(element));
    }
    return include;
}

/// Of what lies behind the nodes nothing is counted.
WrittenFields summaryOf(const NodalStates& states, std::size_t nodes, std::size_t bodies)
{
    WrittenFields written{.nodes = nodes, .ofBody = std::vector<std::size_t>(bodies, 0), .warnings = states.warnings};
    for (std::size_t n = 0; n < nodes; ++n) {
        if (states.body[n] == NodePlace::none) {
            ++written.outside;
            written.farthest = std::max(written.farthest, states.outside[n]);
            continue;
        }
        ++written.ofBody[states.body[n]];
        written.largestDisplacement = std::max(written.largestDisplacement, states.displacement[n].norm());
        if (!states.stress.empty() && states.stress[n].allFinite())
            written.largestStress = std::max(written.largestStress, vonMisesStress(states.stress[n]));
    }
    return written;
}

bool isInput(const FieldsRequest& request)
{
    return lowerCaseEnding(request.output) == "inp";
}

} // namespace

void addFieldsArguments(CLI::App& command, FieldsRequest& request, const std::string& unit, const std::string& output)
{
    command
        .add_option("--nodes", request.nodes,
                    "Mesh of another program, at whose nodes values are written: .inp, .frd, .msh, .vtu, .csv ...")
        ->type_name("MESH");
    command.add_option(unit, request.unit, "Take the lengths of the mesh in this unit: " + lengthUnitNames())
        ->type_name("UNIT");
    command
        .add_option_function<std::string>(
            "--at",
            [&request](const std::string& where) { request.at = where == "now" ? NodesAt::now : NodesAt::rest; },
            "Where the mesh lies: in the parts as they were opened (rest) or as they are now (now)")
        ->type_name("WHERE")
        ->check(CLI::IsMember({"rest", "now"}));
    command
        .add_option("--fields", request.fields,
                    "Which, with commas between: " + fieldWords() + "; else all but velocity")
        ->type_name("WORDS")
        ->delimiter(',');
    command
        .add_option_function<std::string>(
            "--solver",
            [&request](const std::string& name) {
                request.solver = name == "abaqus" ? Solver::abaqus : Solver::calculix;
            },
            "Whose input an .inp file is for")
        ->type_name("NAME")
        ->check(CLI::IsMember({"calculix", "abaqus"}));
    command
        .add_option(output, request.output,
                    "File for the values at the nodes of a mesh: .vtu, .csv, or .inp to be included by a solver")
        ->type_name("FILE");
}

void checkFields(const FieldsRequest& request)
{
    if (request.nodes.empty() != request.output.empty())
        throw Problem(
            Message("Field", "Values at nodes need a mesh and a file to write: give --nodes and the output."));
    if (request.nodes.empty())
        return;
    for (const std::string& word : request.fields)
        if (std::ranges::find(knownFields, word, &Field::word) == knownFields.end())
            throw Problem(Message("Field", "There is no field \"%1\"; known are %2.").with(word, fieldWords()));
    const std::string ending = lowerCaseEnding(request.output);
    if (ending != "vtu" && ending != "csv" && ending != "inp")
        failReading(request.output, Message("Field", "values at nodes are written to .vtu, .csv and .inp files."));
    checkIsWritable(request.output);
}

WrittenFields writeFieldsAtNodes(const FieldsRequest& request, const NodalMesh& mesh,
                                 std::span<const BodyAtNodes> bodies, TaskControl& control)
{
    TaskPortion asking(control, 0, 0.9);
    const ElementPlaces elements = isInput(request) ? elementPlaces(mesh, request.solver) : ElementPlaces();
    const NodalStates states = nodalStates(bodies,
                                           {.nodes = mesh.nodes,
                                            .at = request.at,
                                            .cells = {mesh.cells.connectivity, mesh.cells.offsets},
                                            .others = elements.places},
                                           asking);
    WrittenFields written = summaryOf(states, mesh.nodes.size(), bodies.size());
    written.warnings.insert(written.warnings.begin(), mesh.warnings.begin(), mesh.warnings.end());
    if (written.outside == mesh.nodes.size())
        failReading(mesh.path,
                    Message::sequence({Message("Field", "no node lies in the bodies."), written.warnings.back()}));
    TaskPortion writing(control, 0.9, 1);
    if (isInput(request)) {
        const SolverInclude include = includeOf(request, mesh, elements, states);
        if (!include.nodes.empty())
            written.names.emplace_back("*NODE");
        if (!include.elements.empty())
            written.names.emplace_back("*INITIAL CONDITIONS, TYPE=STRESS");
        if (written.names.empty())
            failReading(request.output, Message("Field", "there is nothing to write: the mesh has no solid elements "
                                                         "for stress, and no displaced nodes were asked for."));
        writeSolverInclude(request.output, include, writing);
        return written;
    }
    const NodalFields fields = ArraysOfStates(request, mesh, states).make();
    for (const NodalFields::Array& array : fields.arrays)
        written.names.push_back(array.name);
    writeFields(request.output, fields, writing);
    return written;
}

} // namespace knead
