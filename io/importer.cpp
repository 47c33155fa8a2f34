#include "io/importer.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/brep/moved_parts.h"
#include "io/brep/occt_session.h"
#include "io/document/size_limits.h"
#include "io/document/unit_remark.h"
#include "io/formats/cad_format.h"
#include "io/formats/cad_reader.h"
#include "io/formats/mesh_reader.h"
#include "io/formats/threemf/three_mf_reader.h"

#include <stdexcept>
#include <utility>

namespace knead {

namespace {

/// Takes the lengths in the unit that was asked for, or says what can be said about the one that was taken.
void settleUnit(const std::string& path, const std::string& wanted, Model& model)
{
    if (wanted.empty()) {
        if (model.unit.empty())
            model.warnings.push_back(noUnitStated(shortName(path)));
        model.unitRemark = unitRemark(model);
        return;
    }
    try {
        model = takenIn(std::move(model), wanted);
    } catch (const std::runtime_error& error) {
        failReading(path, messageOf(error));
    }
    leaveOutSickParts(model);
    checkAnyPart(path, model);
}

Model readAs(FormatKind kind, const std::string& path, const ImportOptions& options, TaskControl& control)
{
    if (formatOf(kind).isSmooth)
        return readCad(path, kind, options, control);
    return kind == FormatKind::ThreeMf ? readThreeMf(path, options, control) : readMesh(path, kind, options, control);
}

} // namespace

Model importFile(const std::string& path, const ImportOptions& options, TaskControl& control)
{
    control.throwIfCancelled();
    if (!options.unit.empty() && findLengthUnit(options.unit) == nullptr)
        failReading(
            path,
            Message("Import", "\"%1\" is no length unit; choose one of %2.").with(options.unit, lengthUnitNames()));
    const FormatKind kind = recognizeFormat(path);
    Model model = readAs(kind, path, options, control);
    model.file = path;
    settleUnit(path, options.unit, model);
    if (!options.shift.isZero(0))
        guardOcct(path, [&] { moveParts(model, options.shift); });
    control.throwIfCancelled();
    control.report(1, "done");
    return model;
}

} // namespace knead
