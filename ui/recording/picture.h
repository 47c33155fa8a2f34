#pragma once

#include <QSize>
#include <QString>

#include <string>

class QImage;

namespace knead {

/// A picture of what a view shows.
struct Picture {
    enum class Kind { png, jpeg };
    static constexpr int largestSide = 8192; ///< [pixels]

    Kind kind = Kind::png;
    QSize size{1920, 1080}; ///< [pixels]
    bool isClear = false;   ///< without the background, which PNG alone can keep
    bool hasGround = true;  ///< grid and shadow
    bool hasCube = false;   ///< that shows how the view is turned
};

/// Writes a picture into a file that may be written over, whatever it is called.
/// @throws std::runtime_error with a sentence when the disk refuses
void writePicture(const QImage& image, Picture::Kind kind, const std::string& path);

/// By the ending of a name, if it says which. @param otherwise where it does not
Picture::Kind kindOfPicture(const QString& path, Picture::Kind otherwise);

} // namespace knead
