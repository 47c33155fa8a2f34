#include "import/bare_import.h"

#include "core/model/import_options.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace knead {

namespace {

class Stopwatch {
public:
    /// Since the last lap [s].
    double lap()
    {
        const auto before = m_since;
        m_since = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(m_since - before).count();
    }

private:
    std::chrono::steady_clock::time_point m_since = std::chrono::steady_clock::now();
};

template <typename Reader>
std::vector<TopoDS_Shape> readDocument(Reader& reader, const std::string& path, Stopwatch& watch, BareTimes& times)
{
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw std::runtime_error(path + " could not be read.");
    times.reading = watch.lap();
    const Handle(XCAFApp_Application) application = XCAFApp_Application::GetApplication();
    Handle(TDocStd_Document) document;
    application->NewDocument("BinXCAF", document);
    reader.Transfer(document);
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
    std::vector<TopoDS_Shape> shapes;
    for (const TDF_Label& root : roots)
        shapes.push_back(XCAFDoc_ShapeTool::GetShape(root));
    application->Close(document);
    times.transfer = watch.lap();
    return shapes;
}

std::vector<TopoDS_Shape> readShapes(const std::string& path, Stopwatch& watch, BareTimes& times)
{
    if (path.ends_with(".step") || path.ends_with(".stp")) {
        STEPCAFControl_Reader reader;
        reader.SetGDTMode(false); // importFile() leaves these out too
        reader.SetPropsMode(false);
        reader.SetMatMode(false);
        return readDocument(reader, path, watch, times);
    }
    if (path.ends_with(".iges") || path.ends_with(".igs")) {
        IGESCAFControl_Reader reader;
        return readDocument(reader, path, watch, times);
    }
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, path.c_str(), BRep_Builder()))
        throw std::runtime_error(path + " could not be read.");
    BRepTools::Clean(shape); // else there is nothing left to do for files that hold triangles
    times.reading = watch.lap();
    return {shape};
}

void mesh(const TopoDS_Shape& shape, bool parallel)
{
    const ImportOptions options;
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    const double deflection = options.relativeDeflection * std::sqrt(box.SquareExtent());
    const BRepMesh_IncrementalMesh triangulated(shape, deflection, false, options.angularDeflection, parallel);
}

} // namespace

BareTimes bareImport(const std::string& path, bool parallel)
{
    ::Message::DefaultMessenger()->ChangePrinters().Clear(); // else they write into the table
    BareTimes times;
    Stopwatch watch;
    TopoDS_Compound loose;
    const BRep_Builder builder;
    builder.MakeCompound(loose);
    for (const TopoDS_Shape& shape : readShapes(path, watch, times)) {
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
            mesh(solids.Current(), parallel);
        for (TopExp_Explorer shells(shape, TopAbs_SHELL, TopAbs_SOLID); shells.More(); shells.Next())
            builder.Add(loose, shells.Current());
        for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
            builder.Add(loose, faces.Current());
    }
    if (loose.NbChildren() > 0)
        mesh(loose, parallel);
    times.meshing = watch.lap();
    return times;
}

} // namespace knead
