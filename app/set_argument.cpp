#include "app/set_argument.h"

#include <CLI/CLI.hpp>

namespace knead {

void addSetArgument(CLI::App& command, std::vector<std::string>& settings)
{
    command
        .add_option(
            "--set", settings,
            "Change the recipe before it is checked, for example spacing_mm=3, material.youngs_modulus_pa=2e6 or "
            "manipulators.press.size_mm.0=12: keys, names and numbers of list items with dots between them, then "
            "JSON or a text; null takes a key away. May be given several times")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

} // namespace knead
