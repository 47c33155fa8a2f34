#include "io/project/project_thumbnail.h"

#include "io/project/project_database.h"
#include "io/project/rows.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace knead {

std::vector<std::byte> projectThumbnail(const std::string& path)
{
    constexpr std::size_t column = 3; // of the table "view"
    try {
        const OpenProject project = openProject(path, TaskControl::none());
        return rowAt(*project.database, "view", 0).bytes(column);
    } catch (const DamagedData&) {
        return {};
    } catch (const SQLite::Exception&) {
        return {};
    }
}

} // namespace knead
