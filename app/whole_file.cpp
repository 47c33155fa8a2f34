#include "app/whole_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace knead {

namespace fs = std::filesystem;

void writeWhole(const std::string& path, const std::string& text, const Message& refused)
{
    const std::string unfinished = path + ".part";
    std::ofstream file(unfinished);
    file << text;
    file.close();
    std::error_code error;
    if (file)
        fs::rename(unfinished, path, error);
    if (!file || error) {
        fs::remove(unfinished, error);
        throw Problem(refused.with(path));
    }
}

} // namespace knead
