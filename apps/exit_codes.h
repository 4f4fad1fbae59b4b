#pragma once
// What the programs return to the shell. Part of the command line's contract: scripts and farms decide by it whether
// to try again.

#include "drt/base/diagnostic.h"

namespace drt {

enum ExitCode : int {
    exit_ok = 0,
    exit_internal = 1,     ///< a bug, or out of memory
    exit_usage = 2,        ///< the command line is wrong
    exit_scene = 3,        ///< the scene is invalid; every message has been printed
    exit_input = 4,        ///< an input file is missing or unreadable
    exit_output = 5,       ///< the output cannot be written
    exit_terminated = 75,  ///< stopped by SIGTERM, with the picture so far if any (EX_TEMPFAIL: try again)
};

ExitCode exit_code(ErrorKind);

}  // namespace drt
