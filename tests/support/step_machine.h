#pragma once

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <QDir>
#include <QString>

namespace knead {

/// Writes machine.stp, of a plate and two pins that are in files beside it, part_plate.stp and part_pin.stp.
/// @return whether it could
inline bool writeMachine(const QString& folder)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label machine = shapes->NewShape();
    const TDF_Label plate = shapes->AddShape(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), false);
    const TDF_Label pin = shapes->AddShape(BRepPrimAPI_MakeCylinder(5, 40).Shape(), false);
    TDataStd_Name::Set(machine, "machine");
    TDataStd_Name::Set(plate, "plate");
    TDataStd_Name::Set(pin, "pin");
    gp_Trsf up;
    up.SetTranslation(gp_Vec(0, 0, 50));
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(40, 0, 0));
    shapes->AddComponent(machine, plate, TopLoc_Location());
    shapes->AddComponent(machine, pin, TopLoc_Location(up));
    shapes->AddComponent(machine, pin, TopLoc_Location(aside));
    shapes->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    writer.SetNameMode(true);
    const QString before = QDir::currentPath();
    QDir::setCurrent(folder); // the other files go to where one is
    const bool isWritten =
        writer.Transfer(document, STEPControl_AsIs, "part_") && writer.Write("machine.stp") == IFSelect_RetDone;
    QDir::setCurrent(before);
    return isWritten;
}

} // namespace knead
