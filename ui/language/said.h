#pragma once

#include "core/message/message.h"

#include <QString>

namespace knead {

/// A sentence in the language of the window. Who shows it shows it in whatever language is spoken later, too. Any thread.
QString said(const Message& message);

} // namespace knead
