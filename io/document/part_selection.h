#pragma once

#include "core/model/part.h"

#include <string>
#include <vector>

namespace knead {

/// The parts of a file that a person wants, by Part::path or by the path of an assembly above them.
class PartSelection {
public:
    /// @param wanted as ImportOptions::parts; empty: all
    explicit PartSelection(const std::vector<std::string>& wanted);

    /// @param assembly path of what the part is in, empty for the file itself
    bool wants(const std::string& assembly, const std::string& name);

    /// Whether any body of a leaf could be wanted. Bodies are below it, or have its name, numbered
    /// from the second on, as in earlier versions.
    bool mayWant(const std::string& assembly, const std::string& leaf) const;

    /// To be called after all parts of the file have been asked for: takes nodes without parts out of the tree.
    /// @throws Problem about `file`, when a path that was given is none in it
    void finish(const std::string& file, Model& model) const;

private:
    struct Request {
        std::string path;
        bool found = false;
    };
    std::vector<Request> m_requests;
};

} // namespace knead
