#include "ui/recording/recording.h"

#include <QCoreApplication>

#include <algorithm>

namespace knead {

std::size_t Recording::pictures() const
{
    constexpr double rounding = 1e-9;
    return 1 + static_cast<std::size_t>(std::max(0.0, to - from) / speed * rate + rounding);
}

double Recording::placeOf(std::size_t picture) const
{
    return from + static_cast<double>(picture) * speed / rate;
}

void record(const Recording& recording, const Timeline& line, const FilledModel& content, const Drawing& draw,
            FilmWriter& writer, TaskControl& control)
{
    const std::size_t count = recording.pictures();
    for (std::size_t i = 0; i < count; ++i) {
        control.throwIfCancelled();
        const QString stage = QCoreApplication::translate("Recording", "picture %1 of %2").arg(i + 1).arg(count);
        control.report(static_cast<double>(i) / static_cast<double>(count), stage.toStdString());
        const double at = recording.placeOf(i);
        writer.add(draw(drawable(*line.frameAt(at), content.bodies), at));
    }
    writer.finish();
}

} // namespace knead
