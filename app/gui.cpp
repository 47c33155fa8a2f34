#include "app/gui.h"

#include "app/cad_process.h"
#include "app/resources.h"
#include "io/importer.h"
#include "io/material_library.h"
#include "io/mesh_writer.h"
#include "ui/run_window.h"

namespace knead {

namespace {

std::vector<Services::Format> formats(const std::vector<FileFormat>& source)
{
    std::vector<Services::Format> result;
    for (const FileFormat& format : source)
        result.push_back({format.name, format.endings});
    return result;
}

} // namespace

Services fileServices()
{
    Services services;
    services.import = importInChildren;
    services.preview = previewInChild;
    services.exportMeshes = [](const std::string& path, const std::vector<ExportBody>& bodies) {
        std::vector<MeshBody> meshes;
        for (const ExportBody& body : bodies)
            meshes.push_back({body.name, body.color, body.mesh});
        writeMeshes(path, meshes);
    };
    services.importFormats = formats(importFormats());
    services.exportFormats = formats(exportFormats());
    services.materials = readMaterials(resourcesFolder() + "/materials/materials.json");
    services.examplesFolder = resourcesFolder() + "/examples";
    return services;
}

int runWindow(int argc, char** argv, const std::vector<std::string>& files)
{
    return showMainWindow(argc, argv, fileServices(), files);
}

} // namespace knead
