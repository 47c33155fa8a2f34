#include "fuzz/targets.h"
#include "io/project/tool_part_bytes.h"
#include "io/worker/model_file.h"
#include "support/sample_project.h"

namespace knead::fuzz {

namespace {

bool readModel(std::string_view bytes)
{
    isTaken([&] { toolPartFromBytes(bytes, {Vec3::Zero(), Vec3::Ones()}); });
    return isTaken([&] { requireSameBack(modelFromBytes(bytes), modelToBytes, modelFromBytes); });
}

} // namespace

Target modelTarget()
{
    return {[] {
                return std::vector<std::string>{modelToBytes(sample::model()),
                                                toolPartMeshToBytes(*sample::toolPart(0.02))};
            },
            readModel};
}

} // namespace knead::fuzz
