#pragma once

#include "app/deformation_plan.h"

#include <memory>
#include <vector>

namespace CLI {
class App;
}

namespace knead {

/// The options of a sub-command that say how parts are deformed. --field, --bend, --twist, --taper, --stretch, --shear and --scale each
/// begin a deformation, in the order given; what follows one of them is for it, and what stands before the first is for all that it
/// can be for.
class DeformationArguments {
public:
    /// @param command must live as long
    explicit DeformationArguments(CLI::App& command);
    ~DeformationArguments();

    /// Once the command line is parsed. @throws Problem about what is none, or stands where it says nothing
    std::vector<DeformationWish> wishes() const;

private:
    struct Words;
    std::unique_ptr<const Words> m_words;
};

} // namespace knead
