#pragma once

#include "core/session/timeline.h"
#include "core/task/task_control.h"
#include "ui/recording/film_writer.h"

#include <QImage>
#include <QSize>

#include <functional>

namespace knead {

/// What of the timeline becomes a video or pictures.
struct Recording {
    enum class Kind { video, pictures };
    Kind kind = Kind::video;
    double from = 0;         ///< place on the timeline [s]
    double to = 0;           ///< the same, not before [s]
    double speed = 1;        ///< simulated per shown second, positive
    int rate = 30;           ///< pictures per shown second, positive
    QSize size{1920, 1080};  ///< [pixels], even
    bool hasReadings = true; ///< time and forces are written into the pictures

    std::size_t pictures() const; ///< at least one
    double placeOf(std::size_t picture) const;
};

/// Draws a frame. @param at its place on the timeline [s]
using Drawing = std::function<QImage(const FramePointer& frame, double at)>;

/// Draws the pictures one after the other, and writes them. Runs on a task thread.
/// @throws what drawing and writer throw; Cancelled
void record(const Recording& recording, const Timeline& line, const FilledModel& content, const Drawing& draw,
            FilmWriter& writer, TaskControl& control);

} // namespace knead
