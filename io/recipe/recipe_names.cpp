#include "io/recipe/recipe_names.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

std::string nameOfBody(const Model& model, const std::vector<std::size_t>& parts, std::size_t body)
{
    const auto isAlone = [&](const std::string& name) {
        const auto means = [&](std::size_t part) {
            return model.parts[part].name == name || model.parts[part].path == name;
        };
        return !name.empty() && std::count_if(parts.begin(), parts.end(), means) == 1;
    };
    const Part& part = model.parts[parts[body]];
    for (const std::string& name : {part.name, part.path})
        if (isAlone(name))
            return name;
    return '#' + std::to_string(body);
}

} // namespace

RecipeNames::RecipeNames(const Model& model, const ProjectStart& start)
{
    for (std::size_t body = 0; body < start.partOfBody.size(); ++body)
        m_bodies.push_back(nameOfBody(model, start.partOfBody, body));
}

const std::string& UniqueNames::add(const std::string& name, const std::string& other)
{
    const std::string base = name.empty() ? other : name;
    std::string candidate = base;
    for (int i = 2; !m_taken.insert(candidate).second; ++i)
        candidate = base + ' ' + std::to_string(i);
    return m_names.emplace_back(std::move(candidate));
}

} // namespace knead
