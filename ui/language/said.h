#pragma once

#include "core/message/message.h"

#include <QString>

namespace knead {

/// A sentence in the language of the window. Who shows it shows it in whatever language is spoken later, too. Any thread.
QString said(const Message& message);

/// A number in a sentence, with the decimal sign of whatever language it is said in.
/// @param format of QString::number()
Message numberMessage(double value, char format = 'g', int digits = 6);

} // namespace knead
