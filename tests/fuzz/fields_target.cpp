#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "io/fields/field_bytes.h"
#include "io/fields/field_reader.h"
#include "support/sample_fields.h"

namespace knead::fuzz {

namespace {

std::vector<std::string> fieldFiles()
{
    using samples::sample;
    const auto line = [](std::size_t i, const Vec3& X, const Vec3& u) {
        return std::to_string(i) + ";" + samples::triple(X, ";") + ";" + samples::triple(u, ";");
    };
    return {samples::frd({sample(1), sample(2)}, 0),
            samples::frd({sample(1), sample(2)}, 1),
            samples::frd({sample()}, 2),
            samples::frd({sample()}, 3),
            samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", false, true),
            samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", true, false),
            samples::legacyVtk(sample(), "POLYDATA", true, true),
            samples::legacyVtk(sample(), "STRUCTURED_GRID", false, false),
            samples::xmlVtk(sample(), {.format = "ascii"}),
            samples::xmlVtk(sample(), {.format = "binary", .isCompressed = true}),
            samples::xmlVtk(sample(), {.isBase64 = true, .hasLongHeaders = false}),
            samples::xmlVtk(sample(), {.isCompressed = true, .order = std::endian::big}),
            samples::gmsh({sample(1), sample(2)}, false, false),
            samples::gmsh({sample()}, false, true),
            samples::gmsh({sample()}, true, false),
            samples::gmsh({sample()}, true, true),
            samples::table(sample(), "Node;X [cm];Y [cm];Z [cm];dx;dy;dz\n", line),
            samples::table(sample(), "", line),
            samples::report({sample(1), sample(2)}),
            samples::input(sample())};
}

bool readFieldFile(std::string_view bytes)
{
    static const ScratchFile file("field");
    const std::string path = file.with(bytes);
    const bool isMesh =
        isTaken([&] { requireSameBack(readNodes(path, {}, TaskControl::none()), meshToBytes, meshFromBytes); });
    return isTaken([&] { requireSameBack(readField(path, {}, TaskControl::none()), fieldToBytes, fieldFromBytes); }) ||
           isMesh;
}

} // namespace

Target fieldsTarget()
{
    return {fieldFiles, readFieldFile};
}

} // namespace knead::fuzz
