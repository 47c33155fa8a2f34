#include "app/project_services.h"

#include "app/cad_process.h"
#include "io/project/project_file.h"
#include "io/project/project_lock.h"
#include "io/project/recovery.h"

namespace knead {

ProjectServices projectServices()
{
    ProjectServices services;
    services.ending = "knead";
    services.write = writeProject;
    services.read = readProjectAfterTrial;
    services.rescue = rescueProjectAfterTrial;
    services.lock = [](const std::string& path) { return std::make_shared<ProjectLock>(path); };
    services.keepWork = [] { return std::make_unique<RecoveryFile>(); };
    services.takeOver = [](const Recovery& recovery) { return std::make_unique<RecoveryFile>(recovery); };
    services.findRecoveries = [] { return findRecoveries(); };
    services.dropRecovery = dropRecovery;
    return services;
}

} // namespace knead
