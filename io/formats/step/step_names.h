#pragma once

#include "io/document/cad_document.h"
#include "io/document/document_of_parts.h"

#include <string>
#include <string_view>

class STEPControl_Reader;
class STEPControl_Writer;

namespace knead {

/// The names of a product and of an instance in a STEP file that have a meaning for persons.
struct StepName {
    std::string name;
    std::string partNumber; ///< the id of a product; empty when it is the name
};

/// OpenCASCADE's documents have one name for a product, its id gets lost; and the reader takes the name of an instance for
/// empty when no letter of it is ASCII. Writes both into such names, before shapes are made of the file.
void markNames(const STEPControl_Reader& reader);

/// Takes apart what markNames() put together, and makes it readable.
StepName withoutMark(std::u16string_view name);

/// A product's name for the writer's document.
std::string withPartNumber(const std::string& name, const std::string& partNumber);

/// Gives the products that the writer made of such names their ids.
void takePartNumbersApart(STEPControl_Writer& writer);

/// Names that a file has for its solids and faces and that a person would know: bodies of one product, what a face is for.
/// @pre shapes were made of it
ShapeNotes<std::string> namesOfStepShapes(const STEPControl_Reader& reader);

/// Gives faces that were written their names, and the solids of other shapes the names of these.
void nameShapes(const NamedShapes& shapes, STEPControl_Writer& writer);

} // namespace knead
