#include "ui/document/table_kinds.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace knead {

namespace {

// Friction of a contact is the geometric mean with that of the material. What sticks comes off at twice the yield stress of modeling
// clay: it is the clay that gives way.
constexpr std::array<TableKind, 3> kinds{
    {{QT_TRANSLATE_NOOP("TableKinds", "Smooth"), QT_TRANSLATE_NOOP("TableKinds", "Parts slide on it, as on glass"),
      0.1},
     {QT_TRANSLATE_NOOP("TableKinds", "Rough"),
      QT_TRANSLATE_NOOP("TableKinds", "Parts hardly slide, and are lifted off freely"), 1},
     {QT_TRANSLATE_NOOP("TableKinds", "Sticky"),
      QT_TRANSLATE_NOOP("TableKinds", "Parts stay where they are: it takes 20 kPa to lift them off"), 1, 2e4}}};

} // namespace

std::span<const TableKind> tableKinds()
{
    return kinds;
}

int tableKindOf(double friction, double adhesion)
{
    const auto found = std::ranges::find_if(
        kinds, [&](const TableKind& kind) { return kind.friction == friction && kind.adhesion == adhesion; });
    return found == kinds.end() ? -1 : static_cast<int>(found - kinds.begin());
}

bool isKneaded(const Material& material)
{
    return material.yields() && material.heals();
}

} // namespace knead
