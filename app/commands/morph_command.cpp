#include "app/commands/morph_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/commands/deformation_arguments.h"
#include "app/commands/morph_report.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_arguments.h"
#include "app/export_file.h"
#include "app/import_arguments.h"
#include "app/opened_shape.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/session/export_jobs.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace {

struct MorphOptions {
    explicit MorphOptions(CLI::App& command)
        : deformations(command)
    {
    }

    std::string input;
    std::string output;
    DeformationArguments deformations;
    std::vector<std::string> parts; ///< that are deformed; empty: all
    ImportOptions import;
    ExportOptions write;
    bool report = false;
    bool json = false;
};

ExportReport writeDeformed(const MorphOptions& options, const Model& model, const DeformationPlan& plan,
                           TaskControl& control)
{
    ExportJob job = exportJobOf(model, {}, {});
    job.options = asWished(options.write, job.options);
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (plan.moves[p])
            job.parts[p].deformations = plan.deformations;
    const ExportReport report = exportFile(options.output, std::move(job), control);
    if (options.report)
        writeReportBeside(report);
    return report;
}

int carryOutMorph(const MorphOptions& options, const std::vector<DeformationWish>& wishes)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        TaskPortion reading(control, 0, 0.2);
        const Model model = importInChild(options.input, options.import, reading);
        TaskPortion planning(control, 0.2, 0.5);
        const DeformationPlan plan = planOf(wishes, model, partsNamed(model, options.parts), planning);
        failure = exit_status::failed;
        TaskPortion writing(control, 0.5, 1);
        const ExportReport written = writeDeformed(options, model, plan, writing);
        control.clear();
        printWarnings(remarksOnImport(model));
        printWarnings(plan.remarks);
        const MorphReport report{.model = model, .wishes = wishes, .plan = plan, .written = written};
        options.json ? printMorphJson(report) : printMorph(report);
        return exit_status::done;
    });
}

int morph(const MorphOptions& options)
{
    if (formatToWrite(options.output) == nullptr)
        return complain(options.output + ": the ending is none of " + formatEndings(" and ") +
                            "; name the file after its format.",
                        exit_status::wrongUse);
    std::vector<DeformationWish> wishes;
    try {
        wishes = options.deformations.wishes();
    } catch (const Problem& problem) {
        return complain(problem.what(), exit_status::wrongUse);
    }
    if (wishes.empty())
        return complain("nothing is said to deform the parts; give --field FILE, or a number such as --bend 90.",
                        exit_status::wrongUse);
    return carryOutMorph(options, wishes);
}

} // namespace

void addMorphCommand(CLI::App& program, int& exitStatus)
{
    CLI::App* command = program.add_subcommand(
        "morph", "Deform the parts of a CAD or mesh file by a field or by numbers; smooth faces stay smooth faces");
    auto options = std::make_shared<MorphOptions>(*command);
    command->add_option("PART", options->input, formatNames(" or ") + " file")->required();
    command->add_option("--output", options->output, "File to write: " + formatEndings(" and "))
        ->required()
        ->type_name("FILE");
    addRepeatedOption(
        *command, "--part", options->parts,
        "Name of a part, or path of a part or assembly, that is deformed; may be given several times. All "
        "others are written as they are")
        ->type_name("NAME");
    command->add_flag("--report", options->report,
                      "Write what was found when the file was read back as JSON beside it");
    command->add_flag("--json", options->json, "Print it all as JSON");
    addExportArguments(*command, options->write);
    addReadingArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = morph(*options); });
}

} // namespace knead
