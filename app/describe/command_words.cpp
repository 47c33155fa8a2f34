#include "app/describe/command_words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace knead {

namespace {

/// Names of values that are files. All arguments are, that are no folders.
constexpr std::array<std::string_view, 3> fileNames{"FILE", "MESH", "RECIPE"};

/// What may be chosen, which the parser says as "TEXT:{local,slurm}"; empty for any value.
std::vector<std::string> choicesOf(const std::string& type)
{
    const std::size_t begin = type.find('{');
    const std::size_t end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        return {};
    return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

ValueWords valueOf(const CLI::Option& option)
{
    if (option.get_items_expected_min() == 0)
        return {}; // a flag
    const std::string type = option.get_type_name();
    ValueWords value{.kind = ValueWords::Kind::text, .name = type.substr(0, type.find_first_of(":{ "))};
    if (option.get_positional())
        value.name = option.get_name(true);
    value.choices = choicesOf(type);
    if (!value.choices.empty())
        value.kind = ValueWords::Kind::choice;
    else if (value.name == "FOLDER")
        value.kind = ValueWords::Kind::folder;
    else if (option.get_positional() || std::ranges::find(fileNames, value.name) != fileNames.end())
        value.kind = ValueWords::Kind::file;
    return value;
}

OptionWords wordsOf(const CLI::Option& option)
{
    OptionWords words{.value = valueOf(option), .group = option.get_group(), .help = option.get_description()};
    for (const std::string& name : option.get_snames())
        words.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        words.names.push_back("--" + name);
    words.preset = option.get_default_str();
    words.isRequired = option.get_required();
    words.isRepeated = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll ||
                       option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    return words;
}

} // namespace

CommandWords wordsOf(const CLI::App& command)
{
    CommandWords words{.name = command.get_name(), .help = command.get_description(), .footer = command.get_footer()};
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            words.options.push_back(wordsOf(*option));
    for (const CLI::App* one : command.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); }))
        words.commands.push_back(wordsOf(*one));
    return words;
}

} // namespace knead
