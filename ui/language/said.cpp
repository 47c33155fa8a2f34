#include "ui/language/said.h"

#include <QCoreApplication>

#include <string>
#include <vector>

namespace knead {

QString said(const Message& message)
{
    const QString text = message.subject().empty()
                             ? QString::fromStdString(message.text())
                             : QCoreApplication::translate(message.subject().c_str(), message.text().c_str());
    if (message.arguments().empty())
        return text;
    std::vector<std::string> values;
    values.reserve(message.arguments().size());
    for (const Message& argument : message.arguments())
        values.push_back(said(argument).toStdString());
    return QString::fromStdString(withPlacesFilled(text.toStdString(), values));
}

} // namespace knead
