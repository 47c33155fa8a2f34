#include "io/fields/vtk_xml_arrays.h"

#include "core/message/message.h"
#include "io/fields/byte_numbers.h"
#include "io/fields/encoded_bytes.h"
#include "io/fields/field_content.h"
#include "io/fields/text_scanner.h"

#include <zlib.h>

#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::uint64_t mostDeflated = 1100; // zlib makes at most 1032 bytes of one

std::uint64_t headerNumber(const std::string& bytes, std::size_t index, const VtkXmlCoding& coding)
{
    return coding.hasLongHeaders ? numberAt<std::uint64_t>(bytes, 8 * index, coding.order)
                                 : numberAt<std::uint32_t>(bytes, 4 * index, coding.order);
}

std::string inflated(const std::string& block, std::uint64_t size)
{
    if (size > mostDeflated * (block.size() + 1))
        failAsDamaged();
    std::string bytes(static_cast<std::size_t>(size), '\0');
    uLongf length = bytes.size();
    const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                  reinterpret_cast<const Bytef*>(block.data()), block.size());
    if (result != Z_OK || length != bytes.size())
        failAsDamaged();
    return bytes;
}

/// The header says how many blocks there are, how long each but the last is, how long the last is when it is shorter, and
/// then of each how long it is in the file.
std::string decompressed(EncodedBytes& bytes, const VtkXmlCoding& coding)
{
    const std::size_t width = coding.hasLongHeaders ? 8 : 4;
    const std::string head = bytes.take(3 * width);
    const std::uint64_t blocks = headerNumber(head, 0, coding);
    const std::uint64_t blockSize = headerNumber(head, 1, coding);
    const std::uint64_t lastSize = headerNumber(head, 2, coding);
    if (blocks > std::numeric_limits<std::uint32_t>::max())
        failAsDamaged();
    const std::string sizes = bytes.take(blocks * width);
    std::string result;
    for (std::size_t i = 0; i < blocks; ++i) {
        const bool isShort = i + 1 == blocks && lastSize != 0;
        result += inflated(bytes.take(headerNumber(sizes, i, coding)), isShort ? lastSize : blockSize);
    }
    return result;
}

std::string bytesOf(const VtkXmlArray& array, const VtkXmlCoding& coding)
{
    const bool isAppended = array.format == "appended";
    if (isAppended && array.offset > coding.appended.size())
        failAsDamaged();
    EncodedBytes bytes(isAppended ? coding.appended.substr(static_cast<std::size_t>(array.offset)) : array.text,
                       !isAppended || coding.isAppendedBase64);
    if (coding.isCompressed)
        return decompressed(bytes, coding);
    return bytes.take(headerNumber(bytes.take(coding.hasLongHeaders ? 8 : 4), 0, coding));
}

/// Fractions and what is too large for whole numbers become -1, which no node is.
template <typename Result, typename Number>
Result resultOf(Number number)
{
    if constexpr (std::is_floating_point_v<Number> && std::is_integral_v<Result>)
        return std::abs(number) < static_cast<Number>(1LL << 53U) ? static_cast<Result>(number) : Result{-1};
    else
        return static_cast<Result>(number);
}

template <typename Result, typename Number>
std::vector<Result> convertedBytes(const std::string& bytes, std::endian order)
{
    if (bytes.size() % sizeof(Number) != 0)
        failAsDamaged();
    std::vector<Result> numbers(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = resultOf<Result>(numberAt<Number>(bytes, i * sizeof(Number), order));
    return numbers;
}

template <typename Result>
std::vector<Result> numbersInText(std::string_view text)
{
    TextScanner words(text, TaskControl::none());
    std::vector<Result> numbers;
    for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
        const auto number = numberIn(word);
        if (!number)
            failAsDamaged();
        numbers.push_back(resultOf<Result>(*number));
    }
    return numbers;
}

template <typename Result>
std::vector<Result> numbersOf(const VtkXmlArray& array, const VtkXmlCoding& coding)
{
    if (array.format == "ascii")
        return numbersInText<Result>(array.text);
    const std::string bytes = bytesOf(array, coding);
    const std::endian order = coding.order;
    if (array.type == "Float64")
        return convertedBytes<Result, double>(bytes, order);
    if (array.type == "Float32")
        return convertedBytes<Result, float>(bytes, order);
    if (array.type == "Int64" || array.type == "UInt64")
        return convertedBytes<Result, std::int64_t>(bytes, order);
    if (array.type == "Int32")
        return convertedBytes<Result, std::int32_t>(bytes, order);
    if (array.type == "UInt32")
        return convertedBytes<Result, std::uint32_t>(bytes, order);
    if (array.type == "Int16")
        return convertedBytes<Result, std::int16_t>(bytes, order);
    if (array.type == "UInt16")
        return convertedBytes<Result, std::uint16_t>(bytes, order);
    if (array.type == "Int8")
        return convertedBytes<Result, std::int8_t>(bytes, order);
    if (array.type == "UInt8" || array.type == "String")
        return convertedBytes<Result, std::uint8_t>(bytes, order);
    failAsDamaged();
}

} // namespace

std::vector<double> vtkXmlNumbers(const VtkXmlArray& array, const VtkXmlCoding& coding)
{
    return numbersOf<double>(array, coding);
}

std::vector<std::int64_t> vtkXmlWholeNumbers(const VtkXmlArray& array, const VtkXmlCoding& coding)
{
    return numbersOf<std::int64_t>(array, coding);
}

} // namespace knead
