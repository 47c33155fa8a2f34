#include "io/importer.h"

#include "io/cad_format.h"
#include "io/cad_reader.h"
#include "io/mesh_reader.h"

namespace knead {

Model importFile(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    control.throwIfCancelled();
    const FormatKind kind = recognizeFormat(path);
    const bool isMesh = kind == FormatKind::Stl || kind == FormatKind::Obj || kind == FormatKind::Ply;
    Model model = isMesh ? readMesh(path, kind, options, control) : readCad(path, kind, options, control);
    model.file = path;
    control.throwIfCancelled();
    control.report(1, "done");
    return model;
}

const std::vector<FileFormat>& importFormats()
{
    static const std::vector<FileFormat> formats{
        {"STEP", {"step", "stp", "p21"}},
        {"IGES", {"iges", "igs"}},
        {"BREP", {"brep", "brp"}},
        {"STL", {"stl"}},
        {"OBJ", {"obj"}},
        {"PLY", {"ply"}},
    };
    return formats;
}

} // namespace knead
