#pragma once

#include <QString>

#include <chrono>

namespace knead {

/// What a person chose for the program, beside what dialogs and panels remember by themselves. As it comes where nothing was
/// chosen. Kept in the settings, read and written in the window thread.
struct Preferences {
    enum class Look { Light, Dark, System };
    Look look = Look::Light;
    QString language;                        ///< code; empty: that of the system
    QString lengthUnit = "mm";               ///< that lengths, speeds and volumes are shown in: mm, cm, m or in
    int historyMegabytes = 512;              ///< that the moments of the history may take, 16 to 65536
    int filmMegabytes = 256;                 ///< that pictures for looking back may take, 16 to 65536
    std::chrono::seconds keepingInterval{3}; ///< between keepings of unsaved work, 1 to 60
    double detail = 5e-4;         ///< how far triangles may lie beside the surfaces of files, of the size of a part
    int importMinutes = 0;        ///< that reading a file may take; 0: by its size
    int importGibibytes = 0;      ///< the same in memory
    int threads = 0;              ///< that compute; 0: all that the machine has
    int smoothing = 4;            ///< samples of a pixel in the view: 1, 2, 4 or 8
    bool turnsSmoothly = true;    ///< the view glides from one direction to another
    int textPercent = 100;        ///< size of texts, of what the system asks for [%], 100 to 150
    QString navigation = "knead"; ///< name of the NavigationPreset: which drags of the mouse orbit, pan and zoom
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// What the machine computes at once with all its threads, at least 1.
int mostThreads();

/// Numbers out of range, as another program may have written them, come back as they would without.
Preferences readPreferences();
/// What is as it comes is not written, so that a later version may come with something better.
void writePreferences(const Preferences& preferences);

} // namespace knead
