#include "formats/legacy_fixture.h"

#include "drt/formats/legacy_reader.h"

namespace drt::legacy_test {
namespace {

std::string lines(const Diagnostics& ds, bool errors_only) {
    std::string out;
    for (const Diagnostic& d : ds) {
        if (errors_only && d.severity != Severity::error) continue;
        out += to_string(d) + '\n';
    }
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
        return lines(e.diagnostics(), true);
    }
    return "";
}

std::string notes_of(const SceneRead& read) { return lines(read.notes, false); }

bool says(const SceneRead& read, const std::string& words) { return notes_of(read).find(words) != std::string::npos; }

}  // namespace drt::legacy_test
