// Makes the book of verification: all cases at their default and two finer spacings, beside CalculiX.
#include "verify/calculix.h"
#include "verify/page.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <stdexcept>

using namespace knead::book;

namespace {

struct Options {
    std::filesystem::path out = "out/verify";
    std::string only = ".*"; ///< regular expression for ids
    bool quick = false;      ///< quick cases at their default spacing, without CalculiX
    bool calculix = true;
    bool finer = true; ///< the finer spacings as well
    bool list = false;
};

Options optionsOf(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] {
            if (i + 1 >= count)
                throw std::runtime_error(word + " needs a value.");
            return std::string(arguments[++i]);
        };
        if (word == "--out")
            options.out = value();
        else if (word == "--only")
            options.only = value();
        else if (word == "--quick")
            options.quick = true;
        else if (word == "--without-calculix")
            options.calculix = false;
        else if (word == "--default-spacing")
            options.finer = false;
        else if (word == "--list")
            options.list = true;
        else
            throw std::runtime_error(
                "Unknown option " + word +
                ". Known: --only PATTERN, --quick, --default-spacing, --without-calculix, --list, --out FOLDER.");
    }
    return options;
}

void write(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream stream(file);
    stream << text;
    if (!stream.flush())
        throw std::runtime_error(file.string() + " could not be written.");
}

} // namespace

int main(int count, char** arguments)
{
    try {
        const Options options = optionsOf(count, arguments);
        const std::regex pattern(options.only);
        calculixFolder() = options.out / "calculix";
        std::filesystem::create_directories(calculixFolder());
        calculixFolder() = std::filesystem::absolute(calculixFolder());
        std::vector<Record> records;
        std::string unexpected; // ids
        std::printf("%s\n", tableHead().c_str());
        for (const Case& one : allCases()) {
            if (!std::regex_search(one.id, pattern) || (options.quick && !one.quick))
                continue;
            if (options.list) {
                std::printf("%-30s %s\n", one.id.c_str(), one.title.c_str());
                continue;
            }
            records.push_back(record(
                one, {.calculix = options.calculix && !options.quick, .finer = options.finer && !options.quick}));
            if (!isAsExpected(records.back()))
                unexpected += " " + one.id;
            std::printf("%s", tableOf(records.back()).c_str());
            std::fflush(stdout);
            // After each case, so that a book that takes long can be read meanwhile.
            write(options.out / "index.html", htmlOf(records));
            write(options.out / "verify.json", jsonOf(records));
        }
        if (options.list)
            return EXIT_SUCCESS;
        if (records.empty())
            throw std::runtime_error("No case has such a name; --list shows them.");
        std::printf("\n%s\n", (options.out / "index.html").c_str());
        if (unexpected.empty())
            return EXIT_SUCCESS;
        std::cerr << "Not as expected:" << unexpected << "\n";
        return EXIT_FAILURE;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return EXIT_FAILURE;
    }
}
