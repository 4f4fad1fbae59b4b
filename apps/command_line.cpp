#include "apps/command_line.h"

#include <sstream>
#include <string>

#include "apps/standard_streams.h"
#include "drt/base/diagnostic.h"

namespace drt {

void let_last_option_win(CLI::App& app) {
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

bool parse_command_line(CLI::App& app, int argc, char** argv) {
    app.failure_message(CLI::FailureMessage::simple);
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::Success& e) {  // --help, --version
        std::ostringstream text;
        app.exit(e, text, text);
        write_stdout(text.str());
        return false;
    } catch (const CLI::ParseError& e) {
        throw Error(ErrorKind::usage, e.what() + std::string("; --help lists the options"));
    }
}

}  // namespace drt
