#include "app/recipe_files.h"

#include "app/cad_process.h"
#include "app/deform_in_child.h"
#include "app/field_source.h"
#include "app/recipe_exports.h"
#include "io/files/safe_file.h"
#include "io/project/project_file.h"

namespace knead {

RecipeFiles recipeFiles()
{
    return {.import = importInChildren,
            .isProject = isProjectFile,
            .readProject = readProjectAfterTrial,
            .prepareFolders = prepareFolders,
            .writeExports = writeExports,
            .writeTable = writeFileSafely,
            .writeAndRead = writeAndReadInChildren,
            .readField = readFieldSource};
}

} // namespace knead
