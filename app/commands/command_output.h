#pragma once

#include "core/message/message.h"
#include "core/model/export_report.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace knead {

/// What commands print alike.

/// Paths on Linux are bytes; what is no UTF-8 is shown with replacement characters.
void printAsJson(const nlohmann::ordered_json& json);

/// Into a file, whole or not at all; without a path to the standard output. @throws Problem when it cannot be written
void putOut(const std::string& path, const std::string& text);

/// To the errors, a line each.
void printWarnings(const std::vector<Message>& warnings);

/// What a run has written: the files, and what was found when they were read back.
void printWritten(const std::vector<std::string>& files, const std::vector<ExportReport>& exports);

} // namespace knead
