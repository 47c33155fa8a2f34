#pragma once

#include <memory>
#include <string>

class QImage;

namespace knead {

/// Takes pictures of one size, one after the other. Any thread, one at a time.
/// All functions throw std::runtime_error with a sentence when the disk refuses.
class FilmWriter {
public:
    virtual ~FilmWriter() = default;
    virtual void add(const QImage& picture) = 0;
    virtual void finish() = 0; ///< after the last picture
};

/// An Ogg Theora video. @param path of a file that may be written over; it is whole after finish()
/// @param rate [pictures per second]
std::unique_ptr<FilmWriter> makeVideoWriter(const std::string& path, int rate);

/// A folder of PNG files, named after it: bend/bend-0001.png. It appears with finish(); without, nothing is left behind.
/// @param folder that does not exist, or is empty
std::unique_ptr<FilmWriter> makePictureWriter(const std::string& folder);

} // namespace knead
