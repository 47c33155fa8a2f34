#include "step_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <stdexcept>

namespace {

Handle(TDocStd_Document) makeDocument(const std::string& name, const std::vector<ExampleBody>& bodies)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const bool isAssembly = bodies.size() > 1;
    const TDF_Label assembly = isAssembly ? shapes->NewShape() : TDF_Label();
    for (const ExampleBody& body : bodies) {
        const TDF_Label part = shapes->AddShape(body.shape, false);
        TDataStd_Name::Set(part, body.name.c_str());
        colors->SetColor(part, Quantity_Color(body.red, body.green, body.blue, Quantity_TOC_sRGB), XCAFDoc_ColorGen);
        if (isAssembly)
            TDataStd_Name::Set(shapes->AddComponent(assembly, part, TopLoc_Location()), body.name.c_str());
    }
    if (isAssembly)
        TDataStd_Name::Set(assembly, name.c_str());
    shapes->UpdateAssemblies();
    return document;
}

Handle(TCollection_HAsciiString) text(const char* characters)
{
    return new TCollection_HAsciiString(characters);
}

} // namespace

void writeStepFile(const std::string& path, const std::string& name, const std::vector<ExampleBody>& bodies)
{
    STEPCAFControl_Writer writer;
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.product.name", name.c_str());
    if (!writer.Transfer(makeDocument(name, bodies)))
        throw std::runtime_error(path + ": the shapes cannot be translated.");

    APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
    header.SetName(text((name + ".step").c_str()));
    header.SetTimeStamp(text("2000-01-01T00:00:00"));
    header.SetAuthorValue(1, text("Knead"));
    header.SetOrganizationValue(1, text("Knead"));
    header.SetOriginatingSystem(text("knead_make_examples"));
    if (writer.Write(path.c_str()) != IFSelect_RetDone)
        throw std::runtime_error(path + ": the file cannot be written.");
}
