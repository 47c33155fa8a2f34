#include "ui/recording/film_writer.h"

#include "ui/recording/sentence.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QStorageInfo>

#include <algorithm>
#include <filesystem>

namespace knead {

namespace {

constexpr int quality = 2; // the best of 0..2
constexpr qint64 leastRoom =
    qint64{32} << 20;     // that is left on the disk [bytes]; else it could be full before one knows
constexpr int digits = 4; // of the number in the name of a picture

struct FilmWords {
    Q_DECLARE_TR_FUNCTIONS(FilmWriter)
};

/// Of a disk that is full, or a file that may not be larger.
[[noreturn]] void failForRoom(const QString& folder)
{
    failWith(FilmWords::tr("There is no room left in %1. Free some, or record fewer or smaller pictures.").arg(folder));
}

QString folderOf(const std::string& path)
{
    return QFileInfo(QFile::decodeName(path.c_str())).absolutePath();
}

void requireRoom(const std::string& path)
{
    const QStorageInfo disk(folderOf(path));
    if (disk.isValid() && disk.bytesAvailable() < leastRoom)
        failForRoom(folderOf(path));
}

/// Whether an Ogg file has come to its end: its last page is whole and says that it is the last one. VTK does not tell when
/// the disk took no more. From RFC 3533, section 6.
bool isWholeVideo(const std::string& path)
{
    constexpr qint64 longestPage = 65'307;
    constexpr qsizetype headLength = 27;
    constexpr qsizetype flagsAt = 5;
    constexpr int isLast = 4;
    QFile file(QFile::decodeName(path.c_str()));
    if (!file.open(QIODevice::ReadOnly) || !file.seek(std::max(qint64{0}, file.size() - longestPage)))
        return false;
    const QByteArray end = file.readAll();
    const qsizetype page = end.lastIndexOf("OggS");
    if (page < 0 || end.size() < page + headLength)
        return false;
    const auto at = [&](qsizetype place) { return static_cast<uchar>(end[page + place]); };
    const qsizetype segments = at(headLength - 1);
    qsizetype length = headLength + segments;
    if (end.size() < page + length)
        return false;
    for (qsizetype i = 0; i < segments; ++i)
        length += at(headLength + i);
    return (at(flagsAt) & isLast) != 0 && end.size() == page + length;
}

class VideoWriter final : public FilmWriter {
public:
    VideoWriter(const std::string& path, int rate)
        : m_path(path)
    {
        m_writer->SetFileName(path.c_str());
        m_writer->SetQuality(quality);
        m_writer->SetRate(rate);
        m_writer->SetSubsampling(true);
    }

    ~VideoWriter() override
    {
        if (m_isOpen)
            m_writer->End();
    }

    void add(const QImage& picture) override
    {
        requireRoom(m_path);
        fill(picture.convertToFormat(QImage::Format_RGB888));
        m_writer->SetInputData(m_image);
        if (!m_isOpen)
            m_writer->Start();
        m_isOpen = true;
        m_writer->Write();
    }

    void finish() override
    {
        requireRoom(m_path);
        m_writer->End();
        m_isOpen = false;
        if (!isWholeVideo(m_path))
            failForRoom(folderOf(m_path));
    }

private:
    /// VTK's rows go upwards.
    void fill(const QImage& picture)
    {
        m_image->SetDimensions(picture.width(), picture.height(), 1);
        m_image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        const auto bytes = static_cast<std::size_t>(3 * picture.width());
        for (int y = 0; y < picture.height(); ++y)
            std::copy_n(picture.constScanLine(picture.height() - 1 - y), bytes,
                        static_cast<uchar*>(m_image->GetScalarPointer(0, y, 0)));
    }

    std::string m_path;
    vtkNew<vtkOggTheoraWriter> m_writer;
    vtkNew<vtkImageData> m_image;
    bool m_isOpen = false;
};

class PictureWriter final : public FilmWriter {
public:
    explicit PictureWriter(std::filesystem::path folder)
        : m_folder(std::move(folder))
    {
        if (std::filesystem::exists(m_folder) &&
            !(std::filesystem::is_directory(m_folder) && std::filesystem::is_empty(m_folder)))
            failWith(FilmWords::tr("%1 is there already. Choose another name for the folder of pictures.")
                         .arg(name(m_folder)));
        makeFolder();
    }

    ~PictureWriter() override
    {
        std::error_code ignored;
        if (!m_path.empty())
            std::filesystem::remove_all(m_path, ignored);
    }

    void add(const QImage& picture) override
    {
        const QString number = QString::number(++m_count).rightJustified(digits, '0');
        const QString file = QStringLiteral("%1/%2-%3.png").arg(name(m_path), name(m_folder.filename()), number);
        if (!picture.save(file))
            failForRoom(name(m_folder.parent_path()));
    }

    void finish() override
    {
        std::error_code error;
        std::filesystem::rename(m_path, m_folder, error);
        if (error)
            failWith(FilmWords::tr("%1 cannot be made (%2). Choose another name for the folder of pictures.")
                         .arg(name(m_folder), QString::fromStdString(error.message())));
        m_path.clear();
    }

private:
    static QString name(const std::filesystem::path& path) { return QFile::decodeName(path.c_str()); }

    /// Beside the one that is wanted, with a name that nobody has.
    void makeFolder()
    {
        std::error_code error;
        for (int i = 0; m_path.empty(); ++i) {
            std::filesystem::path path = m_folder;
            path += ".part" + (i == 0 ? std::string() : std::to_string(i));
            if (std::filesystem::create_directory(path, error))
                m_path = path;
            else if (error)
                failWith(FilmWords::tr("No folder can be made in %1: %2. Choose another place.")
                             .arg(name(m_folder.parent_path()), QString::fromStdString(error.message())));
        }
    }

    std::filesystem::path m_folder;
    std::filesystem::path m_path; ///< for now; empty when finished
    int m_count = 0;
};

} // namespace

std::unique_ptr<FilmWriter> makeVideoWriter(const std::string& path, int rate)
{
    return std::make_unique<VideoWriter>(path, rate);
}

std::unique_ptr<FilmWriter> makePictureWriter(const std::string& folder)
{
    return std::make_unique<PictureWriter>(std::filesystem::path(folder));
}

} // namespace knead
