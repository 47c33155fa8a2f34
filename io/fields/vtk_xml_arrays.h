#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// How the binary arrays of a VTK XML file are written.
struct VtkXmlCoding {
    std::endian order = std::endian::little;
    bool hasLongHeaders = false; ///< lengths before arrays have 8 bytes, not 4
    bool isCompressed = false;   ///< by zlib
    std::string_view appended;   ///< what follows the "_" of AppendedData
    bool isAppendedBase64 = false;
};

/// An array as its tag tells.
struct VtkXmlArray {
    std::string section; ///< "PointData"
    std::string name;
    std::string type; ///< "Float32"
    std::string format;
    std::size_t components = 1;
    std::uint64_t offset = 0; ///< of appended ones
    std::string_view text;    ///< of others
};

/// The numbers of an array, of any type. @throws Problem, when it is damaged
std::vector<double> vtkXmlNumbers(const VtkXmlArray& array, const VtkXmlCoding& coding);
std::vector<std::int64_t> vtkXmlWholeNumbers(const VtkXmlArray& array, const VtkXmlCoding& coding);

} // namespace knead
