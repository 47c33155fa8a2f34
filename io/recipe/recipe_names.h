#pragma once

#include "core/document/project.h"
#include "core/simulation/command.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace knead {

/// What a recipe calls the bodies, tools and fixtures of a session, where each name is used once.
class RecipeNames {
public:
    RecipeNames(const Model& model, const ProjectStart& start);

    /// Name, path in the assembly or number, "#2": whatever means this body alone.
    const std::string& body(BodyId body) const { return m_bodies.at(body); }
    bool hasManyBodies() const { return m_bodies.size() > 1; }

    /// The next tool or fixture gets the name, or one like it.
    std::string addTool(const std::string& name);
    std::string addFixture(const std::string& name);
    std::string addLoad(const std::string& name);
    static std::string unique(const std::string& name, const std::string& other, std::set<std::string>& taken);

    const std::string& tool(ToolId tool) const { return m_tools.at(tool); }
    const std::string& fixture(FixtureId fixture) const { return m_fixtures.at(fixture); }
    const std::string& load(LoadId load) const { return m_loads.at(load); }

private:
    std::vector<std::string> m_bodies;
    std::vector<std::string> m_tools;
    std::vector<std::string> m_fixtures;
    std::set<std::string> m_takenTools;
    std::set<std::string> m_takenFixtures;
    std::vector<std::string> m_loads;
    std::set<std::string> m_takenLoads;
};

} // namespace knead
