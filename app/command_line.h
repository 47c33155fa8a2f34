#pragma once

namespace knead {

/// The whole program: reads the command line, then opens the window or carries out a sub-command.
/// Sub-commands need no display. Errors go to stderr as one sentence that starts with "knead: ".
/// @return the exit status, see app/exit_status.h
int runProgram(int argc, char** argv);

} // namespace knead
