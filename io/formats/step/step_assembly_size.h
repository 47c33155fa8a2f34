#pragma once

class STEPControl_Reader;

namespace knead {

/// How many parts the assemblies of a STEP file unfold to, before anything is unfolded: 24 levels of two instances each
/// are 16 million parts in 40 kB, and the reader would make them all. Counts no further than `enough`.
int countUnfoldedParts(const STEPControl_Reader& reader, int enough);

/// Whether an assembly is part of itself.
bool isCyclic(const STEPControl_Reader& reader);

} // namespace knead
