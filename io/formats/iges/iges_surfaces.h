#pragma once

#include "io/document/cad_document.h"

class IGESCAFControl_Reader;
class TDocStd_Document;

namespace knead {

/// Hides in the document what the IGES file blanks; the reader leaves that out.
void hideBlankedEntities(const IGESCAFControl_Reader& reader, const TDocStd_Document& document);

/// Most IGES files hold nothing but single faces of one thing: they become one surface, each face with its color.
/// Hidden ones become a surface of their own.
void joinLooseSurfaces(CadDocument& document);

} // namespace knead
