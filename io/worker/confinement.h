#pragma once

#include <string>
#include <vector>

namespace knead {

/// What keeps a process in that reads files of strangers.
struct Confinement {
    int landlock = 0;          ///< version, see landlockVersion(); 0: other files can be read
    bool filtersCalls = false; ///< else sockets can be opened and programs be started
};

/// What the running kernel has for confineOwnProcess().
Confinement confinementHere();

/// Called by a child that works on the file of a stranger, before it looks at that and while it has one thread: locks it in for
/// good, as far as the kernel can. From then on it
/// - reads the files that it was told, libraries of the system and the folders that its own came from, those that OpenCASCADE's variables (CSF_..., CASROOT)
///   name, and what the C library and TBB ask of the machine (processors, memory, itself); nothing else;
/// - opens no file to write. What comes of its work goes through the descriptors that it was handed, see child_descriptors;
/// - has no other open files, opens no sockets, starts no programs and processes, and sees and signals no other ones;
/// - gets no privileges by what it starts, and no other process of the same person may look into it.
/// Threads go on being made.
/// @param readable files, and folders with all below them
void confineOwnProcess(const std::vector<std::string>& readable);

/// What a process that reads a file may read.
/// @param namesOthers whether files of its kind name others, which lie in its folder or below: then it is all of that
std::vector<std::string> readableFor(const std::string& path, bool namesOthers);

/// Of the environment of this process what a confined one may know: where libraries and resources of OpenCASCADE are, and how
/// TBB and sanitizers are set. No home, no tokens, no addresses of displays and buses. As "NAME=value".
std::vector<std::string> environmentForConfined();

} // namespace knead
