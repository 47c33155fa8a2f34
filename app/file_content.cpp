#include "app/file_content.h"

#include <QCryptographicHash>
#include <QFile>

#include <fstream>
#include <sstream>

namespace knead {

std::optional<std::string> textOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file)
        text << file.rdbuf();
    return file && text ? std::optional(text.str()) : std::nullopt;
}

std::string digestOf(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return "";
    return hash.result().toHex().toStdString();
}

std::string digestOfText(const std::string& text)
{
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex().toStdString();
}

} // namespace knead
