#include "io/worker/cad_worker.h"

#include "io/worker/export_worker.h"
#include "io/worker/field_worker.h"
#include "io/worker/import_worker.h"
#include "io/worker/project_worker.h"

#include <iostream>

#include <sys/prctl.h>

namespace knead {

int workForParent(int argc, char** argv)
{
    prctl(PR_SET_NAME, "knead-cad-worke"); // which it has no name for where it was started by a descriptor
    if (isImportWorker(argc, argv))
        runImportWorker(argc, argv);
    if (isExportWorker(argc, argv))
        runExportWorker(argc, argv);
    if (isFieldWorker(argc, argv))
        runFieldWorker(argc, argv);
    if (isProjectWorker(argc, argv))
        runProjectWorker(argc, argv);
    std::cerr << "knead-cad-worker: knead starts this program to read and write CAD files; start knead instead.\n";
    return 2;
}

} // namespace knead
