#include "io/json/message_json.h"

#include <string>
#include <utility>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostArguments = 9;
constexpr int deepest = 8; // of messages in messages

Message nestedMessage(const Json& json, int depth)
{
    if (json.is_string())
        return Message::verbatim(json.get<std::string>());
    const Json& arguments = json.at("arguments");
    if (!arguments.is_array() || arguments.size() > mostArguments || depth == deepest)
        throw Json::other_error::create(501, "the arguments of a message are none", &json);
    std::vector<Message> values;
    for (const Json& argument : arguments)
        values.push_back(nestedMessage(argument, depth + 1));
    return Message(json.at("subject").get<std::string>(), json.at("text").get<std::string>())
        .withAll(std::move(values));
}

} // namespace

Json toJson(const Message& message)
{
    if (message.isVerbatim())
        return message.text();
    return {{"subject", message.subject()}, {"text", message.text()}, {"arguments", toJson(message.arguments())}};
}

Json toJson(const std::vector<Message>& messages)
{
    Json json = Json::array();
    for (const Message& message : messages)
        json.push_back(toJson(message));
    return json;
}

Message messageFrom(const Json& json)
{
    return nestedMessage(json, 0);
}

std::vector<Message> messagesFrom(const Json& json)
{
    if (!json.is_array())
        throw Json::type_error::create(302, "messages are no list", &json);
    std::vector<Message> messages;
    for (const Json& message : json)
        messages.push_back(messageFrom(message));
    return messages;
}

} // namespace knead
