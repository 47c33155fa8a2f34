#include "app/deform_in_child.h"

#include "app/cad_process.h"
#include "app/export_file.h"
#include "core/message/message.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace knead {

namespace {

/// A folder for as long as this lives.
class PassingFolder {
public:
    PassingFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "knead-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw Problem(Message("Deformation", "No folder could be made in %1; make room there and try again.")
                              .with(std::filesystem::temp_directory_path().string()));
        m_path = name;
    }
    ~PassingFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;

    std::string file(const char* name) const { return (m_path / name).string(); }

private:
    std::filesystem::path m_path;
};

} // namespace

WrittenModel writeAndReadInChildren(ExportJob job, TaskControl& control)
{
    const PassingFolder folder;
    const std::string path = folder.file("deformed.step");
    job.options.unit = "mm";
    WrittenModel written;
    TaskPortion writing(control, 0, 0.7);
    written.report = exportFile(path, std::move(job), writing);
    TaskPortion reading(control, 0.7, 1);
    written.model = importInChild(path, {}, reading);
    return written;
}

} // namespace knead
