#include "apps/command_line.h"

#include <sstream>
#include <string>
#include <vector>

#include "apps/standard_streams.h"
#include "drt/base/diagnostic.h"

namespace drt {
namespace {

// The word on the command line that nothing is known of: an option if there is one, for what follows an unknown option
// may only be its value. "" when there is none.
std::string unknown_word(const CLI::App& app) {
    const std::vector<std::string> words = app.remaining();
    for (const std::string& word : words)
        if (word.starts_with('-')) return word.substr(0, word.find('='));
    return words.empty() ? "" : words.front();
}

[[noreturn]] void report_unknown(const CLI::App& app, const std::string& word) {
    if (!word.starts_with('-'))
        throw Error(ErrorKind::usage, {{Severity::error, {}, "one word too many", word, "what --help lists", {}}});
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const std::string suggestion = nearest_word(word, {names.begin(), names.end()});
    const std::string expected = suggestion.empty() ? "one that --help lists" : "";
    throw Error(ErrorKind::usage, {{Severity::error, {}, "unknown option", word, expected, suggestion}});
}

}  // namespace

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
        // a misspelled option also shows as a required one that is missing
        if (const std::string word = unknown_word(app); !word.empty()) report_unknown(app, word);
        throw Error(ErrorKind::usage, e.what() + std::string("; --help lists the options"));
    }
}

}  // namespace drt
