#include "io/fields/vtk_cells.h"

#include "io/fields/field_content.h"

#include <vector>

namespace knead {

void appendCells(NodalCells& cells, std::int64_t firstNode, std::span<const std::int64_t> connectivity,
                 std::span<const std::int64_t> ends, std::span<const std::int64_t> types)
{
    if (ends.size() == types.size() + 1 && ends.front() == 0)
        ends = ends.subspan(1);
    if (ends.size() != types.size())
        failAsDamaged();
    const auto size = static_cast<std::int64_t>(connectivity.size());
    std::int64_t begin = 0;
    for (std::size_t cell = 0; cell < types.size(); begin = ends[cell++]) {
        if (ends[cell] < begin || ends[cell] > size || types[cell] < 0 || types[cell] > 255)
            failAsDamaged();
        for (std::int64_t i = begin; i < ends[cell]; ++i) {
            if (connectivity[static_cast<std::size_t>(i)] < 0)
                failAsDamaged();
            cells.connectivity.push_back(firstNode + connectivity[static_cast<std::size_t>(i)]);
        }
        cells.endCell(static_cast<std::uint8_t>(types[cell]));
    }
}

std::uint8_t typeOfSurfaceCell(std::string_view kind, std::size_t nodes)
{
    if (kind == "Verts")
        return nodes == 1 ? 1 : 2;
    if (kind == "Lines")
        return nodes == 2 ? 3 : 4;
    return nodes == 3 ? 5 : nodes == 4 ? 9 : 7;
}

void appendSurfaceCells(NodalCells& cells, std::string_view kind, std::int64_t firstNode,
                        std::span<const std::int64_t> connectivity, std::span<const std::int64_t> ends)
{
    std::vector<std::int64_t> types;
    std::int64_t begin = 0;
    for (const std::int64_t end : ends) {
        types.push_back(typeOfSurfaceCell(kind, static_cast<std::size_t>(std::max<std::int64_t>(end - begin, 0))));
        begin = end;
    }
    appendCells(cells, firstNode, connectivity, ends, types);
}

} // namespace knead
