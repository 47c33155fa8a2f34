#pragma once

#include "core/document/project.h"
#include "core/simulation/command.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace knead {

/// Names of one sort of things, each used once, by their numbers in the session.
class UniqueNames {
public:
    /// The next one gets the name, or one like it. @param other for what has no name
    const std::string& add(const std::string& name, const std::string& other);
    const std::string& at(std::size_t number) const { return m_names.at(number); }

private:
    std::vector<std::string> m_names;
    std::set<std::string> m_taken;
};

/// What a recipe calls the bodies, tools, fixtures and loads of a session.
class RecipeNames {
public:
    RecipeNames(const Model& model, const ProjectStart& start);

    /// Name, path in the assembly or number, "#2": whatever means this body alone.
    const std::string& body(BodyId body) const { return m_bodies.at(body); }
    bool hasManyBodies() const { return m_bodies.size() > 1; }

    UniqueNames tools;
    UniqueNames fixtures;
    UniqueNames loads;

private:
    std::vector<std::string> m_bodies;
};

} // namespace knead
