#pragma once

#include "core/aggregate/aggregate.h"
#include "core/document/byte_stream.h"

#include <cstdint>
#include <memory>

namespace knead {

/// A filling that a body got while it was worked on, as bytes of a moment.
void writeRefilled(ByteWriter& bytes, const Aggregate& aggregate);

/// @param first the filling of the opened part, whose objects carry its former shape, or that of the filling which does
/// @param version of the moment
/// @throws Problem for what cannot be one
std::shared_ptr<const Aggregate> readRefilled(ByteReader& bytes, const std::shared_ptr<const Aggregate>& first,
                                              std::uint32_t version);

} // namespace knead
