#pragma once

namespace CLI {
class App;
}

namespace knead {

/// "knead thumbnail FILE PICTURE": what file managers show in place of an icon.
void addThumbnailCommand(CLI::App& program, int& exitStatus);

} // namespace knead
