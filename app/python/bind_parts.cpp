#include "app/python/bindings.h"
#include "app/python/filled_part.h"
#include "app/python/kept_array.h"
#include "app/python/script_control.h"
#include "app/python/words.h"
#include "app/recipe_files.h"
#include "core/document/project.h"
#include "core/message/message.h"
#include "core/model/import_options.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace py = pybind11;

namespace knead::python {

namespace {

using Numbers3 = std::array<double, 3>;

std::vector<py::str> english(const std::vector<Message>& messages)
{
    std::vector<py::str> texts;
    for (const Message& message : messages)
        texts.push_back(readable(message.english()));
    return texts;
}

/// As Python has paths, from which it makes the same bytes again.
py::str pathOf(const Model& model)
{
    PyObject* decoded =
        PyUnicode_DecodeFSDefaultAndSize(model.file.data(), static_cast<py::ssize_t>(model.file.size()));
    return decoded != nullptr ? py::reinterpret_steal<py::str>(decoded) : throw py::error_already_set();
}

using Paths = std::variant<std::filesystem::path, std::vector<std::filesystem::path>>;

/// Parts of files, or those that a project shows.
Model modelFrom(const std::vector<std::string>& paths, const ImportOptions& options, TaskControl& control)
{
    const RecipeFiles files = recipeFiles();
    if (paths.size() != 1 || !files.isProject(paths.front()))
        return files.import(paths, options, control);
    const std::shared_ptr<const Model> shown = shownModel(files.readProject(paths.front(), control));
    if (shown == nullptr)
        throw Problem(Message("Python", "%1 has no parts.").with(paths.front()));
    return *shown;
}

std::shared_ptr<Model> read(const Paths& wanted, const std::string& unit, std::vector<std::string> parts, bool heal,
                            bool capsFlatOpenings, double linearDeflection, double angularDeflection,
                            double relativeDeflection, py::object progress)
{
    const ImportOptions options{.linearDeflection = linearDeflection,
                                .angularDeflection = angularDeflection,
                                .relativeDeflection = relativeDeflection,
                                .heal = heal,
                                .capsFlatOpenings = capsFlatOpenings,
                                .unit = unit,
                                .parts = std::move(parts)};
    std::vector<std::string> paths;
    if (const auto* one = std::get_if<std::filesystem::path>(&wanted))
        paths = {one->string()};
    else
        for (const std::filesystem::path& path : std::get<std::vector<std::filesystem::path>>(wanted))
            paths.push_back(path.string());
    return computing(std::move(progress),
                     [&](TaskControl& control) { return std::make_shared<Model>(modelFrom(paths, options, control)); });
}

std::vector<PartOfModel> partsOf(const std::shared_ptr<const Model>& model)
{
    if (model == nullptr)
        throw py::type_error("parts are those of a model");
    std::vector<PartOfModel> parts;
    for (std::size_t p = 0; p < model->parts.size(); ++p)
        parts.push_back({model, p});
    return parts;
}

py::array trianglesOf(const PartOfModel& part)
{
    const std::vector<TriangleMesh::Triangle>& triangles = part.part().mesh.triangles;
    return keptArray(triangles.empty() ? nullptr : triangles.front().data(),
                     {static_cast<py::ssize_t>(triangles.size()), 3},
                     {sizeof(TriangleMesh::Triangle), sizeof(std::uint32_t)}, part.model);
}

std::optional<Numbers3> colorOf(const PartOfModel& part)
{
    const std::optional<Color>& color = part.part().color;
    return color ? std::optional(Numbers3{color->r, color->g, color->b}) : std::nullopt;
}

void bindModel(py::module_& module)
{
    py::class_<Model, std::shared_ptr<Model>>(module, "Model",
                                              "What a file holds. Lengths are metres, whatever its unit.")
        .def_property_readonly("parts", [](const std::shared_ptr<Model>& model) { return partsOf(model); })
        .def_property_readonly("file", &pathOf)
        .def_readonly("format", &Model::format, "\"STEP AP214\", \"STL\" ...")
        .def_readonly("unit", &Model::unit, "Length unit of the file: \"mm\", \"inch\"; empty when it says none.")
        .def_property_readonly(
            "warnings", [](const Model& model) { return english(model.warnings); }, "Sentences on what was found.")
        .def_property_readonly(
            "missing", [](const Model& model) { return english(model.missing); },
            "What the file holds and the model does not, a sentence each.")
        .def("__repr__", [](const Model& model) {
            return readable("<knead.Model " + model.file + ", " + std::to_string(model.parts.size()) + " parts>");
        });
}

void bindPart(py::module_& module)
{
    py::class_<PartOfModel>(module, "Part", "A part of a model, placed in the world. It keeps its model alive.")
        .def_property_readonly("name", [](const PartOfModel& part) { return part.part().name; })
        .def_property_readonly(
            "path", [](const PartOfModel& part) { return part.part().path; }, "In the assembly, joined by \"/\".")
        .def_property_readonly("color", &colorOf, "(r, g, b), sRGB, 0 to 1; None: the file says none.")
        .def_property_readonly(
            "volume", [](const PartOfModel& part) { return part.part().volume; },
            "[m^3], exact where it has CAD faces; 0 without a solid.")
        .def_property_readonly(
            "area", [](const PartOfModel& part) { return part.part().area; }, "[m^2]")
        .def_property_readonly(
            "faces", [](const PartOfModel& part) { return part.part().faces.size(); },
            "Number of CAD faces, which are counted from 0; 0 for a mesh.")
        .def_property_readonly(
            "box",
            [](const PartOfModel& part) { return std::pair<Vec3, Vec3>(part.part().box.min(), part.part().box.max()); },
            "Its lowest and highest corner [m].")
        .def_property_readonly("is_closed", [](const PartOfModel& part) { return part.part().watertight; })
        .def_property_readonly("warnings", [](const PartOfModel& part) { return english(part.part().warnings); })
        .def_property_readonly(
            "vertices", [](const PartOfModel& part) { return keptArray(part.part().mesh.vertices, part.model); },
            "Places of the vertices of its triangles [m], (n, 3), read-only; no copy, and good for as long as one "
            "keeps it.")
        .def_property_readonly(
            "triangles", &trianglesOf,
            "Three vertices each, counter-clockwise from outside, (n, 3), read-only; no copy, as `vertices`.")
        .def_property_readonly(
            "face_of_triangle",
            [](const PartOfModel& part) { return keptArray(part.part().mesh.faceOfTriangle, part.model); },
            "CAD face of each triangle; empty for a mesh. Read-only; no copy, as `vertices`.")
        .def("__repr__", [](const PartOfModel& part) { return "<knead.Part \"" + part.part().name + "\">"; });
}

std::optional<SpacingChoice> choiceOf(std::optional<double> spacing, std::optional<double> objects,
                                      std::optional<double> cellsAcross, std::optional<double> cellsAcrossWall)
{
    using Kind = SpacingChoice::Kind;
    std::optional<SpacingChoice> choice;
    for (const auto& [kind, value] :
         {std::pair(Kind::Length, spacing), std::pair(Kind::Objects, objects), std::pair(Kind::CellsAlong, cellsAcross),
          std::pair(Kind::CellsAcrossWall, cellsAcrossWall)}) {
        if (!value)
            continue;
        if (choice)
            throw py::type_error("fill() takes one of spacing, objects, cells_across and cells_across_wall");
        if (!(*value > 0))
            throw py::value_error("what fill() is to go by must be above 0");
        choice = {kind, *value};
    }
    return choice;
}

std::shared_ptr<FilledPart> fillForScript(const PartOfModel& part, std::optional<double> spacing,
                                          std::optional<double> objects, std::optional<double> cellsAcross,
                                          std::optional<double> cellsAcrossWall,
                                          const std::optional<Material>& material, bool open, bool published,
                                          py::object progress)
{
    const FillingWish wish{.choice = choiceOf(spacing, objects, cellsAcross, cellsAcrossWall),
                           .material = material.value_or(Material{}),
                           .fillsOpenPart = open,
                           .arrangement = published ? Arrangement::published : Arrangement::cutCells};
    return computing(std::move(progress), [&](TaskControl& control) { return filledPart(part, wish, control); });
}

void addRegion(FilledPart& filled, const Material& material, std::vector<ObjectIndex> objects, const std::string& name)
{
    if (const std::vector<Message> problems = materialProblems(material); !problems.empty())
        throw Problem(problems.front());
    objects = ascending(std::move(objects));
    if (objects.empty() || objects.back() >= filled.body.aggregate->size())
        throw py::index_error("a region has objects of its body");
    filled.body.regions.push_back({name, std::move(objects), material});
}

void bindFilledPart(py::module_& module)
{
    py::class_<FilledPart, std::shared_ptr<FilledPart>>(
        module, "Filling",
        "A part filled with objects of a material, from which simulations begin; they leave it as it is.")
        .def_property_readonly("part", [](const FilledPart& filled) { return filled.source; })
        .def_property(
            "name", [](const FilledPart& filled) { return filled.body.name; },
            [](FilledPart& filled, const std::string& name) { filled.body.name = name; })
        .def_property_readonly("material", [](const FilledPart& filled) { return filled.body.material; })
        .def_property(
            "velocity", [](const FilledPart& filled) { return filled.body.velocity; },
            [](FilledPart& filled, const Vec3& velocity) { filled.body.velocity = velocity; }, "At the start [m/s].")
        .def_property(
            "angular_velocity", [](const FilledPart& filled) { return filled.body.angularVelocity; },
            [](FilledPart& filled, const Vec3& velocity) { filled.body.angularVelocity = velocity; },
            "At the start, about the center of mass [rad/s].")
        .def_property(
            "is_rigid", [](const FilledPart& filled) { return filled.body.kind == BodyKind::rigid; },
            [](FilledPart& filled, bool rigid) { filled.body.kind = rigid ? BodyKind::rigid : BodyKind::deformable; })
        .def_property(
            "kind", [](const FilledPart& filled) { return wordFor(filled.body.kind, bodyKindWords()); },
            [](FilledPart& filled, const std::string& kind) { filled.body.kind = choiceCalled(kind, bodyKindWords()); },
            "\"deformable\", \"rigid\" or \"glue\".")
        .def_property(
            "structural_friction", [](const FilledPart& filled) { return filled.body.structuralFriction; },
            [](FilledPart& filled, double friction) { filled.body.structuralFriction = friction; },
            "Within the body, 0 .. 2: only to repeat published scenes.")
        .def("add_region", &addRegion, py::arg("material"), py::arg("objects"), py::arg("name") = "",
             "Makes some of its objects, by their numbers, of another material; a later region wins.")
        .def_property_readonly(
            "spacing", [](const FilledPart& filled) { return filled.body.aggregate->lattice.spacing; },
            "Distance between neighboring objects [m].")
        .def_property_readonly(
            "warning", [](const FilledPart& filled) { return filled.fineness.warning.english(); },
            "A sentence where walls have too few cells; else empty.")
        .def_property_readonly(
            "rest", [](const FilledPart& filled) { return keptArray(*filled.rest, filled.rest); },
            "Places of the objects as they were filled [m], (n, 3), read-only; no copy, good for as long as one keeps "
            "it.")
        .def_property_readonly(
            "volumes",
            [](const FilledPart& filled) { return keptArray(filled.body.aggregate->volume, filled.body.aggregate); },
            "Share of each object of the volume [m^3], read-only; no copy, as `rest`.")
        .def("__len__", [](const FilledPart& filled) { return filled.body.aggregate->size(); })
        .def("__repr__", [](const FilledPart& filled) {
            return "<knead.Filling \"" + filled.body.name + "\", " + std::to_string(filled.body.aggregate->size()) +
                   " objects>";
        });
    module.def("fill", &fillForScript, py::arg("part"), py::kw_only(), py::arg("spacing") = py::none(),
               py::arg("objects") = py::none(), py::arg("cells_across") = py::none(),
               py::arg("cells_across_wall") = py::none(), py::arg("material") = py::none(), py::arg("open") = false,
               py::arg("published") = false, py::arg("progress") = py::none(),
               "Fills a closed part with objects: at a spacing [m], with about so many, or with so many cells along "
               "its longest "
               "side or across its thinnest wall; without any, as the window chooses. `open`: also a surface that is "
               "not closed. "
               "`published`: in the arrangement of published scenes, to repeat these. Raises Error.");
}

} // namespace

void bindParts(py::module_& module)
{
    bindModel(module);
    bindPart(module);
    bindFilledPart(module);
    module.def(
        "read", &read, py::arg("path"), py::kw_only(), py::arg("unit") = "",
        py::arg("parts") = std::vector<std::string>(), py::arg("heal") = true, py::arg("caps_flat_openings") = false,
        py::arg("linear_deflection") = ImportOptions{}.linearDeflection,
        py::arg("angular_deflection") = ImportOptions{}.angularDeflection,
        py::arg("relative_deflection") = ImportOptions{}.relativeDeflection, py::arg("progress") = py::none(),
        "Reads a CAD or mesh file, or several as one model, in processes of their own; or the parts that a project "
        "shows. `unit`: that lengths are taken in, whatever the file says. `parts`: paths of those wanted; none: all. "
        "caps_flat_openings: closes surfaces whose openings are flat. Curved faces become triangles: "
        "linear_deflection, how far these are from them [m], 0: relative_deflection of the size of each part; "
        "angular_deflection [rad]. `progress(share, stage)` is called on the way. Raises Error.");
}

} // namespace knead::python
