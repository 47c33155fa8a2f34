#include "app/gui.h"

#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/deform_in_child.h"
#include "app/export_file.h"
#include "app/field_source.h"
#include "app/project_services.h"
#include "app/recipe_services.h"
#include "app/resources.h"
#include "app/space_mouse.h"
#include "app/thread_limit.h"
#include "app/trace_services.h"
#include "io/files/safe_file.h"
#include "io/library_versions.h"
#include "io/material_library.h"
#include "io/project/packing.h"
#include "ui/run_window.h"

#include <memory>

namespace knead {

Services fileServices()
{
    ownCadProgram(); // a window runs for days, in which an update may replace files
    Services services;
    services.import = importInChildren;
    services.preview = previewInChild;
    services.exportParts = [](const std::string& path, const ExportJob& job, bool keepsReport, TaskControl& control) {
        ExportReport report = exportFile(path, job, control);
        if (keepsReport)
            writeReportBeside(report);
        return report;
    };
    services.writeAndRead = writeAndReadInChildren;
    services.readField = readFieldSource;
    services.writeSafely = [](const std::string& path, const std::function<void(const std::string&)>& write) {
        SafeFile file(path);
        write(file.pathForNow());
        file.keep();
    };
    services.limitThreads = [limit = std::make_shared<std::unique_ptr<ThreadLimit>>()](unsigned threads) {
        limit->reset(); // the least of several would hold
        *limit = std::make_unique<ThreadLimit>(threads);
    };
    services.readOwnMaterials = [] { return readOwnMaterials(ownMaterialsFile()); };
    services.writeOwnMaterials = [](const std::vector<MaterialPreset>& materials) {
        writeMaterials(ownMaterialsFile(), materials);
    };
    services.packing = zstandardPacking();
    services.materials = readMaterials(materialsFile());
    for (const LibraryVersion& library : libraryVersions())
        services.libraries.push_back({library.name, library.version, library.license});
    services.examplesFolder = resourcesFolder() + "/examples";
    services.spaceMouse = listenToSpaceMouse;
    services.projects = projectServices();
    services.recipes = recipeServices();
    services.traces = traceServices();
    return services;
}

int runWindow(int argc, char** argv, const std::vector<std::string>& files)
{
    return showMainWindow(argc, argv, fileServices(), files);
}

} // namespace knead
