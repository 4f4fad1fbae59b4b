#include "formats/legacy_fixture.h"

#include "drt/formats/legacy_reader.h"

namespace drt::legacy_test {
namespace {

std::string lines(const Diagnostics& ds) {
    std::string out;
    for (const Diagnostic& d : ds) out += to_string(d) + '\n';
    return out;
}

}  // namespace

SceneRead read(const std::string& text, const LegacyOptions& options) {
    return read_legacy_bytes(text, "scene.txt", options);
}

std::string errors_of(const std::string& text, const LegacyOptions& options) {
    try {
        read(text, options);
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::scene);
        return lines(e.diagnostics());
    }
    return "";
}

std::string notes_of(const SceneRead& read) { return lines(read.notes); }

bool says(const SceneRead& read, const std::string& words) { return notes_of(read).find(words) != std::string::npos; }

}  // namespace drt::legacy_test
