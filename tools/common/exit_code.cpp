#include "common/exit_code.h"

namespace splitsum::tools {

ExitCode exit_code_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::bad_argument: return ExitCode::bad_arguments;
        case ErrorKind::unreadable_input: return ExitCode::unreadable_input;
        case ErrorKind::unwritable_output: return ExitCode::unwritable_output;
        case ErrorKind::unusable_input: return ExitCode::unusable_input;
        case ErrorKind::interrupted: return ExitCode::interrupted;
        case ErrorKind::internal: return ExitCode::internal;
    }
    return ExitCode::internal;
}

const char* exit_code_help() {
    return "Exit codes: 0 done; 1 a comparison over its limit; 2 bad arguments; 3 an unreadable "
           "or\n"
           "corrupt input; 4 an output that cannot be written; 5 an input that is readable but "
           "not\n"
           "usable (not 2:1, NaN texels, ...); 70 a fault of the program; 130 interrupted.";
}

}  // namespace splitsum::tools
