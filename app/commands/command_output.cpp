#include "app/commands/command_output.h"

#include "io/export/job_file.h"
#include "io/files/safe_file.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace knead {

void printAsJson(const nlohmann::ordered_json& json)
{
    std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void putOut(const std::string& path, const std::string& text)
{
    if (!path.empty())
        return writeFileSafely(path, text);
    if (!(std::cout << text << std::flush))
        throw Problem(Message("File", "the standard output takes no more; write into a file with --output."));
}

void printWarnings(const std::vector<Message>& warnings)
{
    for (const Message& warning : warnings)
        std::cerr << "knead: warning: " << warning.english() << '\n';
}

void printWritten(const std::vector<std::string>& files, const std::vector<ExportReport>& exports)
{
    for (const std::string& file : files)
        std::printf("wrote %s\n", file.c_str());
    for (const ExportReport& report : exports)
        for (const std::string& line : linesOf(report))
            std::printf("%s\n", line.c_str());
}

} // namespace knead
