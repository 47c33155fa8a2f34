#pragma once

#include <QString>

#include <stdexcept>

namespace knead {

/// Ends a task with a sentence for the person who began it.
[[noreturn]] inline void failWith(const QString& sentence)
{
    throw std::runtime_error(sentence.toStdString());
}

} // namespace knead
