#include "apps/exit_codes.h"

namespace drt {

ExitCode exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return exit_usage;
        case ErrorKind::scene:
            return exit_scene;
        case ErrorKind::asset:
            return exit_input;
        case ErrorKind::output:
            return exit_output;
        case ErrorKind::memory:
        case ErrorKind::internal:
            return exit_internal;
    }
    return exit_internal;
}

}  // namespace drt
