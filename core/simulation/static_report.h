#pragma once

#include "core/message/message.h"

namespace knead {

/// How a load step without inertia went.
struct StaticReport {
    bool converged = false;
    double residual = 0; ///< forces that are left, by those that act (2-norms); 1e-7 is converged
    int iterations = 0;  ///< linear systems solved
    int parts = 0;       ///< that the load step was gone in
    Message message;     ///< a sentence with a remedy; empty when converged
};

} // namespace knead
