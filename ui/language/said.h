#pragma once

#include "core/message/message.h"

#include <QString>

namespace knead {

/// A sentence in the language of the window. Any thread.
QString said(const Message& message);

} // namespace knead
