#include "ui/document/face_memory.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace knead {

std::string faceMemory(const std::vector<FaceFixture>& known)
{
    QJsonArray all;
    for (const FaceFixture& fixture : known) {
        QJsonArray faces;
        for (const std::uint32_t face : fixture.faces)
            faces.append(static_cast<qint64>(face));
        all.append(QJsonObject{{"name", QString::fromStdString(fixture.name)},
                               {"key", static_cast<qint64>(fixture.key)},
                               {"body", static_cast<qint64>(fixture.body)},
                               {"faces", faces}});
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<FaceFixture> facesRemembered(const std::string& memory)
{
    std::vector<FaceFixture> known;
    const QJsonArray all = QJsonDocument::fromJson(QByteArray::fromStdString(memory)).array();
    for (const QJsonValue& value : all) {
        FaceFixture& fixture = known.emplace_back();
        fixture.key = static_cast<std::uint32_t>(value["key"].toInteger());
        fixture.name = value["name"].toString().toStdString();
        fixture.body = static_cast<BodyId>(value["body"].toInteger());
        const QJsonArray faces = value["faces"].toArray();
        for (const QJsonValue& face : faces)
            fixture.faces.push_back(static_cast<std::uint32_t>(face.toInteger()));
    }
    return known;
}

} // namespace knead
