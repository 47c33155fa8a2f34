#pragma once

#include "io/document/cad_document.h"

#include <string>

class TDocStd_Document;

namespace knead {

/// The assembly tree of a document that a CAD reader filled, with names, colors, layers and what is hidden;
/// leaves are placed in the world.
struct CadAssembly {
    std::vector<CadNode> roots;
    ShapeColors colors;
    ShapeDisplays displays;
};

/// @param fallbackName for shapes that have no name a person would know
/// @throws Problem about `path`, when there are more parts than any program could show.
CadAssembly readAssembly(const TDocStd_Document& document, const std::string& path, const std::string& fallbackName);

} // namespace knead
