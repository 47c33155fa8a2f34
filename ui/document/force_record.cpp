#include "ui/document/force_record.h"

#include "core/session/sculpting.h"

#include <QStringList>

#include <algorithm>
#include <map>
#include <utility>

namespace knead {

namespace {

using Key = std::pair<bool, std::uint32_t>; ///< false for tools, which come first

/// Quoted where a comma or quote would end the field.
QString field(const QString& text)
{
    if (!text.contains(',') && !text.contains('"') && !text.contains('\n'))
        return text;
    return '"' + QString(text).replace("\"", "\"\"") + '"';
}

QString number(double value)
{
    return QString::number(value, 'g', 7);
}

} // namespace

ForceRecord forceRecordOf(const Timeline& timeline, bool withStrokes)
{
    ForceRecord record{.times = {}, .curves = {}, .present = timeline.present, .end = timeline.end};
    std::map<Key, ForceRecord::Curve> curves;
    const std::size_t count = timeline.pictures.size();
    const auto put = [&](const Key& key, const std::string& name, const Vec3& force, std::size_t at) {
        if (!withStrokes && isNameOfStroke(name))
            return;
        ForceRecord::Curve& curve = curves[key];
        curve.name = name;
        curve.forces.resize(count);
        curve.forces[at] = force;
    };
    for (std::size_t i = 0; i < count; ++i) {
        record.times.push_back(timeline.pictures[i].at);
        for (const ToolState& tool : timeline.pictures[i].frame->tools)
            put({false, tool.id}, tool.name, tool.force, i);
        for (const PlaybackFrame::Held& held : timeline.pictures[i].frame->fixtures)
            put({true, held.id}, held.name, held.force, i);
    }
    for (auto& [key, curve] : curves) {
        curve.isTool = !key.first;
        curve.id = key.second;
        record.curves.push_back(std::move(curve));
    }
    return record;
}

double valueOf(const Vec3& force, ForceComponent component)
{
    return component == ForceComponent::magnitude ? force.norm() : force[static_cast<int>(component) - 1];
}

QString csvOf(const ForceRecord& record)
{
    QStringList header("time [s]");
    for (const ForceRecord::Curve& curve : record.curves)
        for (const char* part : {"Fx", "Fy", "Fz", "F"})
            header << field(QStringLiteral("%1 %2 [N]").arg(QString::fromStdString(curve.name), part));
    QStringList lines(header.join(','));
    for (std::size_t i = 0; i < record.times.size(); ++i) {
        QStringList line(number(record.times[i]));
        for (const ForceRecord::Curve& curve : record.curves)
            for (const ForceComponent part :
                 {ForceComponent::x, ForceComponent::y, ForceComponent::z, ForceComponent::magnitude})
                line << (curve.forces[i] ? number(valueOf(*curve.forces[i], part)) : QString());
        lines << line.join(',');
    }
    return lines.join('\n') + '\n';
}

} // namespace knead
