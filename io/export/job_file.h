#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "io/export/exporter.h"

#include <string>
#include <string_view>

namespace knead {

/// A job as bytes, to be handed from one process of a machine to another; of the objects only what carries the skin.
std::string jobToBytes(const ExportJob& job);

/// The other way. @throws Problem, naming what is wrong, for the developer
ExportJob jobFromBytes(std::string_view bytes);

/// What came of a job as bytes, and the other way. @throws as jobFromBytes()
std::string exportedToBytes(const ExportedFile& file);
ExportedFile exportedFromBytes(std::string_view bytes);

/// A report as a JSON document in English, as it is kept beside a file on wish, and the other way.
std::string reportToJson(const ExportReport& report);
ExportReport reportFromJson(std::string_view json); ///< @throws Problem, for the developer

} // namespace knead
