#include "io/recipe/recipe_names.h"

#include <algorithm>

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

std::string RecipeNames::unique(const std::string& name, const std::string& other, std::set<std::string>& taken)
{
    const std::string base = name.empty() ? other : name;
    std::string candidate = base;
    for (int i = 2; !taken.insert(candidate).second; ++i)
        candidate = base + ' ' + std::to_string(i);
    return candidate;
}

std::string RecipeNames::addTool(const std::string& name)
{
    m_tools.push_back(unique(name, "tool", m_takenTools));
    return m_tools.back();
}

std::string RecipeNames::addFixture(const std::string& name)
{
    m_fixtures.push_back(unique(name, "fixture", m_takenFixtures));
    return m_fixtures.back();
}

std::string RecipeNames::addLoad(const std::string& name)
{
    m_loads.push_back(unique(name, "load", m_takenLoads));
    return m_loads.back();
}

} // namespace knead
