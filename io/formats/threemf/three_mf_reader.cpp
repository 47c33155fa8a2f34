#include "io/formats/threemf/three_mf_reader.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "core/model/readable_name.h"
#include "io/document/part_selection.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_reader.h"
#include "io/mesh/mesh_colors.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr int mostObjects = 100'000;               // instances; no program could show more
constexpr std::size_t mostTriangles = 200'000'000; // of all instances
constexpr int deepestNesting = 200;

using Placement = Eigen::Affine3d;

/// The library refused to go on; what it says is for programmers.
struct LibraryFailure {};

void check(LIB3MFRESULT result)
{
    if (result != LIB3MF_OK)
        throw LibraryFailure();
}

using Object = NMR::PLib3MFBase*;

/// An object of the library that is released in any case.
class Handle {
public:
    Handle() = default;
    ~Handle()
    {
        if (m_object != nullptr)
            NMR::lib3mf_release(m_object);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    Object get() const { return m_object; }
    Object* out() { return &m_object; }

private:
    Object m_object = nullptr;
};

const char* unitName(DWORD unit)
{
    static constexpr std::array names{"um", "mm", "cm", "inch", "ft", "m"}; // in the order of eModelUnit
    return unit < names.size() ? names[unit] : "mm";
}

template <typename Function>
std::string textFrom(Function function, Object object)
{
    ULONG length = 0;
    check(function(object, nullptr, 0, &length));
    std::string text(length + 1, '\0');
    check(function(object, text.data(), static_cast<ULONG>(text.size()), &length));
    text.resize(std::min<std::size_t>(length, text.size()));
    return readableName(std::string_view(text.c_str()));
}

Placement toPlacement(const NMR::MODELTRANSFORM& transform)
{
    Placement placement = Placement::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            placement(row, column) = transform.m_fFields[row][column];
    return placement;
}

Color toColor(const NMR::MODELMESHCOLOR_SRGB& color)
{
    return {static_cast<float>(color.m_Red) / 255, static_cast<float>(color.m_Green) / 255,
            static_cast<float>(color.m_Blue) / 255};
}

/// Colors of the triangles of a mesh object, as far as it gives any: base materials or colors of its own.
class TriangleColors {
public:
    TriangleColors(Object model, Object mesh)
        : m_model(model)
    {
        check(NMR::lib3mf_meshobject_createpropertyhandler(mesh, m_ofTriangles.out()));
        Handle ofObject;
        check(NMR::lib3mf_object_createdefaultpropertyhandler(mesh, ofObject.out()));
        NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
        check(NMR::lib3mf_defaultpropertyhandler_getpropertytype(ofObject.get(), &type));
        if (type == NMR::MODELPROPERTYTYPE_COLOR) {
            NMR::MODELMESHCOLOR_SRGB color{};
            check(NMR::lib3mf_defaultpropertyhandler_getcolor(ofObject.get(), 0, &color));
            m_default = toColor(color);
        } else if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
            DWORD group = 0;
            DWORD index = 0;
            check(NMR::lib3mf_defaultpropertyhandler_getbasematerial(ofObject.get(), &group, &index));
            m_default = materialColor(group, index);
        }
    }

    std::optional<Color> of(DWORD triangle) const
    {
        NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
        check(NMR::lib3mf_propertyhandler_getpropertytype(m_ofTriangles.get(), triangle, &type));
        if (type == NMR::MODELPROPERTYTYPE_COLOR) {
            NMR::MODELMESH_TRIANGLECOLOR_SRGB colors{};
            check(NMR::lib3mf_propertyhandler_getcolor(m_ofTriangles.get(), triangle, &colors));
            return toColor(colors.m_Colors[0]);
        }
        if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
            DWORD group = 0;
            DWORD index = 0;
            check(NMR::lib3mf_propertyhandler_getbasematerial(m_ofTriangles.get(), triangle, &group, &index));
            return materialColor(group, index);
        }
        return m_default;
    }

private:
    std::optional<Color> materialColor(DWORD group, DWORD index) const
    {
        Handle materials;
        if (NMR::lib3mf_model_getbasematerialbyid(m_model, group, materials.out()) != LIB3MF_OK)
            return std::nullopt;
        NMR::MODELMESHCOLOR_SRGB color{};
        if (NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &color.m_Red, &color.m_Green,
                                                     &color.m_Blue, &color.m_Alpha) != LIB3MF_OK)
            return std::nullopt;
        return toColor(color);
    }

    Object m_model;
    Handle m_ofTriangles;
    std::optional<Color> m_default;
};

class ThreeMfReader {
public:
    ThreeMfReader(const std::string& path, const ImportOptions& options, TaskControl& control)
        : m_path(path)
        , m_control(control)
        , m_selection(options.parts)
    {
    }

    Model run()
    {
        load();
        DWORD unit = 0;
        check(NMR::lib3mf_model_getunit(m_library.get(), &unit));
        m_model.format = formatOf(FormatKind::ThreeMf).name;
        m_model.unit = unitName(unit);
        m_metres = findLengthUnit(m_model.unit)->metres;
        const std::string stem = readableName(std::string_view(std::filesystem::path(m_path).stem().string()));
        m_model.tree.name = stem.empty() ? "part" : stem;
        addBuildItems();
        m_selection.finish(m_path, m_model);
        return std::move(m_model);
    }

private:
    void load()
    {
        check(NMR::lib3mf_createmodel(m_library.out()));
        Handle reader;
        check(NMR::lib3mf_model_queryreader(m_library.get(), "3mf", reader.out()));
        check(NMR::lib3mf_reader_setprogresscallback(reader.get(), &ThreeMfReader::onProgress, this));
        std::ifstream file(m_path, std::ios::binary); // the library opens no file whose name is not UTF-8
        std::string bytes{std::istreambuf_iterator<char>(file), {}};
        const LIB3MFRESULT result =
            NMR::lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(bytes.data()), bytes.size());
        m_control.throwIfCancelled();
        check(result);
        DWORD errors = 0;
        check(NMR::lib3mf_reader_getwarningcount(reader.get(), &errors));
        if (errors > 0)
            m_model.warnings.push_back(errors == 1
                                           ? Message("Import", "%1: the 3MF does not keep to the format in 1 place; "
                                                               "compare the parts with the program that wrote it.")
                                                 .with(shortName(m_path))
                                           : Message("Import", "%1: the 3MF does not keep to the format in %2 places; "
                                                               "compare the parts with the program that wrote it.")
                                                 .with(shortName(m_path), errors));
    }

    static bool onProgress(int percent, NMR::ProgressIdentifier, void* reader)
    {
        TaskControl& control = static_cast<ThreeMfReader*>(reader)->m_control;
        control.report(percent / 200.0, "reading the file");
        return !control.isCancelled();
    }

    void addBuildItems()
    {
        Handle items;
        check(NMR::lib3mf_model_getbuilditems(m_library.get(), items.out()));
        bool any = false;
        for (BOOL more = 0; check(NMR::lib3mf_builditemiterator_movenext(items.get(), &more)), more != 0; any = true) {
            Handle item;
            Handle object;
            check(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.out()));
            check(NMR::lib3mf_builditem_getobjectresource(item.get(), object.out()));
            BOOL isPlaced = 0;
            NMR::MODELTRANSFORM transform{};
            check(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &isPlaced));
            if (isPlaced != 0)
                check(NMR::lib3mf_builditem_getobjecttransform(item.get(), &transform));
            addObject(object.get(), isPlaced != 0 ? toPlacement(transform) : Placement::Identity(), m_model.tree, {},
                      0);
        }
        if (!any)
            failReading(m_path,
                        Message("Import", "the 3MF builds no object; export it again with the parts in its build."));
    }

    void addObject(Object object, const Placement& placement, PartNode& parent, const std::string& parentPath,
                   int depth)
    {
        m_control.throwIfCancelled();
        if (++m_objects > mostObjects || depth > deepestNesting)
            failReading(m_path, Message("Import", "the 3MF unfolds to more than %1 objects, or nests them more than %2 "
                                                  "deep; export the parts you need.")
                                    .with(mostObjects, deepestNesting));
        const std::string own = textFrom(NMR::lib3mf_object_getnameutf8, object);
        const std::string name = isGeneratedName(own) ? parent.name : own;
        BOOL isMesh = 0;
        check(NMR::lib3mf_object_ismeshobject(object, &isMesh));
        if (isMesh != 0)
            return addMesh(object, placement, name, parent, parentPath);
        PartNode node;
        node.name = name;
        const std::string path = parentPath.empty() ? name : parentPath + "/" + name;
        DWORD count = 0;
        check(NMR::lib3mf_componentsobject_getcomponentcount(object, &count));
        for (DWORD i = 0; i < count; ++i) {
            Handle component;
            Handle part;
            check(NMR::lib3mf_componentsobject_getcomponent(object, i, component.out()));
            check(NMR::lib3mf_component_getobjectresource(component.get(), part.out()));
            NMR::MODELTRANSFORM transform{};
            BOOL isPlaced = 0;
            check(NMR::lib3mf_component_hastransform(component.get(), &isPlaced));
            if (isPlaced != 0)
                check(NMR::lib3mf_component_gettransform(component.get(), &transform));
            addObject(part.get(), isPlaced != 0 ? Placement(placement * toPlacement(transform)) : placement, node, path,
                      depth + 1);
        }
        parent.children.push_back(std::move(node));
    }

    void addMesh(Object object, const Placement& placement, const std::string& name, PartNode& parent,
                 const std::string& parentPath)
    {
        if (!m_selection.wants(parentPath, name))
            return;
        Part part;
        part.name = name;
        part.path = parentPath.empty() ? name : parentPath + "/" + name;
        copyMesh(object, placement, part);
        if (part.mesh.empty()) {
            m_model.missing.push_back(Message("Import", "\"%1\" has no triangles.").with(part.path));
            return;
        }
        DWORD type = 0;
        check(NMR::lib3mf_object_gettype(object, &type));
        if (type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT) {
            part.visible = false;
            part.layer = "support";
        }
        parent.children.push_back({name, m_model.parts.size(), {}});
        m_model.parts.push_back(std::move(part));
    }

    void copyMesh(Object object, const Placement& placement, Part& part)
    {
        DWORD vertexCount = 0;
        DWORD triangleCount = 0;
        check(NMR::lib3mf_meshobject_getvertexcount(object, &vertexCount));
        check(NMR::lib3mf_meshobject_gettrianglecount(object, &triangleCount));
        m_triangles += triangleCount;
        if (m_triangles > mostTriangles)
            failReading(
                m_path,
                Message("Import", "the 3MF unfolds to more than 200 million triangles; export the parts you need."));
        std::vector<NMR::MODELMESHVERTEX> vertices(vertexCount);
        std::vector<NMR::MODELMESHTRIANGLE> triangles(triangleCount);
        if (triangleCount == 0 || vertexCount == 0)
            return;
        check(NMR::lib3mf_meshobject_getvertices(object, vertices.data(), vertexCount, nullptr));
        check(NMR::lib3mf_meshobject_gettriangleindices(object, triangles.data(), triangleCount, nullptr));
        for (const NMR::MODELMESHVERTEX& vertex : vertices)
            part.mesh.vertices.push_back(
                m_metres * (placement * Vec3(vertex.m_fPosition[0], vertex.m_fPosition[1], vertex.m_fPosition[2])));
        const bool isMirrored = placement.linear().determinant() < 0;
        const TriangleColors colorOf(m_library.get(), object);
        std::vector<std::optional<Color>> colors;
        for (DWORD t = 0; t < triangleCount; ++t) {
            const auto& [a, b, c] = triangles[t].m_nIndices;
            part.mesh.triangles.push_back(isMirrored ? TriangleMesh::Triangle{a, c, b}
                                                     : TriangleMesh::Triangle{a, b, c});
            colors.push_back(colorOf.of(t));
        }
        paintTriangles(part, colors);
    }

    const std::string& m_path;
    TaskControl& m_control;
    PartSelection m_selection;
    Handle m_library;
    Model m_model;
    double m_metres = 1e-3; // in one unit of the file
    int m_objects = 0;
    std::size_t m_triangles = 0;
};

} // namespace

Model readThreeMf(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    try {
        Model model = ThreeMfReader(path, options, control).run();
        measureMeshes(path, options, model, control);
        return model;
    } catch (const LibraryFailure&) {
        failReading(path, Message("Import", "the %1 file is damaged and cannot be read; export it again.").with("3MF"));
    }
}

} // namespace knead
