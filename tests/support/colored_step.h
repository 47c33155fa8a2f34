#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <stdexcept>
#include <string>

namespace knead {

/// Writes a solid as STEP with a name, green, its first face red. @throws std::runtime_error
inline void writeColoredStep(const std::string& path, const std::string& name, const TopoDS_Shape& shape)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TDF_Label part = shapes->AddShape(shape, false);
    TDataStd_Name::Set(part, TCollection_ExtendedString(name.c_str(), true));
    colors->SetColor(part, Quantity_Color(0.2, 0.7, 0.3, Quantity_TOC_sRGB), XCAFDoc_ColorGen);
    colors->SetColor(shapes->AddSubShape(part, TopExp_Explorer(shape, TopAbs_FACE).Current()),
                     Quantity_Color(0.9, 0.1, 0.1, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    ::Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); // it tells of every step
    STEPCAFControl_Writer writer;
    if (!writer.Transfer(document) || writer.Write(path.c_str()) != IFSelect_RetDone)
        throw std::runtime_error(path + " cannot be written.");
}

} // namespace knead
