#pragma once

#include "core/message/message.h"
#include "core/simulation/scene.h"
#include "io/recipe/scene_words.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace knead::python {

/// What a word of recipes and projects means. @throws Problem for another one, with those that there are
template <class Choice>
Choice choiceCalled(const std::string& wanted, const Choices<Choice>& words)
{
    for (const auto& [word, choice] : words)
        if (word == wanted)
            return choice;
    throw Problem(Message("Python", "There is no choice \"%1\" here; there are: %2.")
                      .with(wanted, listed(words, [](const auto& known) { return known.first; })));
}

/// Objects in the order in which commands name them, each once.
inline std::vector<ObjectIndex> ascending(std::vector<ObjectIndex> objects)
{
    std::ranges::sort(objects);
    objects.erase(std::ranges::unique(objects).begin(), objects.end());
    return objects;
}

} // namespace knead::python
