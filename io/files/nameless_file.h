#pragma once

#include <string>
#include <string_view>

namespace knead {

/// A file that has no name and is gone with the last process that holds it: nothing is left behind, whatever happens.
class NamelessFile {
public:
    enum class Place {
        folder, ///< for temporary files
        memory, ///< for processes that may make no files, see confineOwnProcess()
    };

    /// @throws Problem, when the folder for temporary files takes none
    explicit NamelessFile(Place place = Place::folder);
    ~NamelessFile();
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    int descriptor() const { return m_descriptor; }
    /// Under which this process can read it, for libraries that want a name.
    std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

    /// Appends. @throws Problem, when the folder takes no more
    void write(std::string_view bytes);

    /// All that was written, by whomever. @throws Problem
    std::string content() const;

private:
    int m_descriptor = -1;
};

/// The same open file under a number that no descriptor of a child has; the old number is closed.
/// @throws Problem
int aboveThoseOfChildren(int descriptor);

} // namespace knead
