#pragma once

#include "core/message/message.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace knead {

/// A message as it is kept and handed on: a text without arguments that is the same in every language as a string, any other as
/// {"subject": ..., "text": ..., "arguments": [...]}.
nlohmann::json toJson(const Message& message);
nlohmann::json toJson(const std::vector<Message>& messages);

/// The other way. Files of earlier versions hold strings. @throws nlohmann::json::exception
Message messageFrom(const nlohmann::json& json);
std::vector<Message> messagesFrom(const nlohmann::json& json);

} // namespace knead
