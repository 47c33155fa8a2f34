#include "app/whole_file.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace knead {

namespace fs = std::filesystem;

void writeWhole(const std::string& path, const std::string& text, const std::string& remedy)
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
        throw std::runtime_error(path + ": the file cannot be written; " + remedy);
    }
}

} // namespace knead
