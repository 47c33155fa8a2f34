#pragma once

#include "core/model/part.h"
#include "io/formats/cad_writer.h"

#include <TDocStd_Document.hxx>

#include <string>
#include <utility>
#include <vector>

namespace knead {

using NamedShapes = std::vector<std::pair<TopoDS_Shape, std::string>>;

/// The parts and their assembly as the document that OpenCASCADE's writers take. Instances are named as the nodes of the
/// tree, products as these say; two that are not the same shape any more are never one name. In STEP, bodies of a product that
/// are solids become one product.
/// @param tree as in writeCad()
/// @param isStep whose part numbers are in the names of products, as takePartNumbersApart() wants them
/// @return the shapes of the parts in it, with their names
NamedShapes fillDocument(const std::vector<CadPartToWrite>& parts, const PartNode& tree, bool isStep,
                         const Handle(TDocStd_Document) & document);

} // namespace knead
