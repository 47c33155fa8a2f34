#pragma once

#include "io/formats/cad_format.h"

#include <functional>
#include <mutex>
#include <string>

namespace knead {

/// Owns OpenCASCADE while it lives: one at a time per process, since its readers share global state. Keeps it from
/// printing.
class OcctSession {
public:
    OcctSession();

private:
    std::lock_guard<std::mutex> m_lock;
};

/// Runs work that uses OpenCASCADE and turns its exceptions, which are no std::exception, into sentences about the
/// file.
/// @throws Problem, and whatever else the work throws
void guardOcct(const std::string& path, const std::function<void()>& work);

} // namespace knead
