#pragma once

#include "core/message/message.h"
#include "core/model/file_preview.h"
#include "core/model/part.h"

#include <string>
#include <string_view>

namespace knead {

/// A model as bytes, to be handed from one process of a machine to another: a header, a JSON document with all that is small,
/// then the arrays of the meshes as they lie in memory.
std::string modelToBytes(const Model& model);

/// The other way. Trusts nothing: sizes, places of arrays, indices, numbers that are not finite, trees and texts are checked,
/// so that bytes from a process that went astray cannot hurt this one.
/// @throws Problem, naming what is wrong, for the developer
Model modelFromBytes(std::string_view bytes);

/// A preview as bytes, and the other way with the same distrust.
std::string previewToBytes(const FilePreview& preview);
FilePreview previewFromBytes(std::string_view bytes);

/// In place of a model: why there is none, a sentence for the person. Both are told apart by failureIn().
std::string failureToBytes(const Message& sentence);

/// @return the sentence; empty when the bytes are those of something else
Message failureIn(std::string_view bytes);

} // namespace knead
