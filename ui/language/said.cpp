#include "ui/language/said.h"

#include "ui/language/retranslation.h"
#include "ui/units.h"

#include <QCoreApplication>

#include <string>
#include <vector>

namespace knead {

namespace {

constexpr const char* numberSubject = "Number";

QString inWords(const Message& message)
{
    if (message.subject() == numberSubject && message.arguments().empty())
        return localNumber(QString::fromStdString(message.text()));
    const QString text = message.subject().empty()
                             ? QString::fromStdString(message.text())
                             : QCoreApplication::translate(message.subject().c_str(), message.text().c_str());
    if (message.arguments().empty())
        return text;
    std::vector<std::string> values;
    values.reserve(message.arguments().size());
    for (const Message& argument : message.arguments())
        values.push_back(inWords(argument).toStdString());
    return QString::fromStdString(withPlacesFilled(text.toStdString(), values));
}

} // namespace

QString said(const Message& message)
{
    const QString text = inWords(message);
    return message.arguments().empty() ? text : noted(text, [message] { return said(message); });
}

Message numberMessage(double value, char format, int digits)
{
    return {numberSubject, QString::number(value, format, digits).toStdString()};
}

} // namespace knead
