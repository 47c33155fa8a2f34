#include "io/brep/body_check.h"

#include "core/task/parallel.h"

#include <BRepCheck_Analyzer.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <unordered_map>

namespace knead {

namespace {

constexpr std::size_t checkedTogether = 16; // between two looks at whether to stop

void check(CadBody& body)
{
    try {
        auto analyzer = std::make_shared<const BRepCheck_Analyzer>(body.shape, true, true); // faces in parallel
        body.isValid = analyzer->IsValid();
        if (!*body.isValid)
            body.failure = std::move(analyzer);
    } catch (const Standard_Failure&) { // stays unknown
        return;
    }
}

} // namespace

void checkBodies(const std::vector<CadBody*>& bodies, TaskControl& control)
{
    std::unordered_map<const void*, CadBody*> firstOfShape;
    std::vector<CadBody*> different;
    for (CadBody* body : bodies)
        if (firstOfShape.emplace(body->shape.TShape().get(), body).second)
            different.push_back(body);
    for (std::size_t begin = 0; begin < different.size(); begin += checkedTogether) {
        control.throwIfCancelled();
        control.report(static_cast<double>(begin) / static_cast<double>(different.size()), "checking parts");
        forEachBlock(std::min(checkedTogether, different.size() - begin), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                check(*different[begin + i]);
        });
    }
    // What failed is known by its faces where they are: those of another place are checked when it comes to that.
    for (CadBody* body : bodies)
        if (const CadBody& first = *firstOfShape.at(body->shape.TShape().get()); first.isValid && *first.isValid)
            body->isValid = true;
}

} // namespace knead
