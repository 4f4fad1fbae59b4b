// read_legacy_scene: file -> text -> elements -> SceneDesc, with every complaint of every stage at once.
#include "drt/formats/legacy_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <utility>

#include "drt/formats/legacy_map.h"
#include "drt/formats/legacy_parse.h"
#include "drt/formats/legacy_text.h"

namespace drt {
namespace {

/// Adds what validate() finds beyond the reader's own errors. What is at the very place of an error, or has no place at
/// all ("no camera") in a file with errors, may well be its consequence.
void append_new(Diagnostics& all, Diagnostics found) {
    std::set<std::pair<int, int>> places;
    for (const Diagnostic& d : all)
        if (d.severity == Severity::error) places.insert({{0, 0}, {d.where.line, d.where.column}});
    for (Diagnostic& d : found)
        if (!places.contains({d.where.line, d.where.column})) all.push_back(std::move(d));
}

}  // namespace

SceneRead read_legacy_bytes(std::string bytes, const std::string& path, const LegacyOptions& options) {
    LegacyReport report(path);
    const std::string text = legacy_text(std::move(bytes), report);
    SceneRead result;
    const bool is_text = !report.has_errors();
    if (is_text) {
        const std::vector<LegacyElement> elements = parse_legacy(text, report);
        LegacyMapping m{
            elements, options, report, std::filesystem::path(path).parent_path().string(), LegacyNames(elements),
            {},       {}};
        m.scene.sources.places.reserve(5 * elements.size() + 64);
        m.mark("", {});
        m.scene.ambient_light = Color(options.ambient_light);
        m.scene.gravity = options.gravity;
        map_legacy_settings(m);
        map_legacy_cameras(m);
        map_legacy_materials(m);
        map_legacy_bodies(m);
        map_legacy_lights(m);
        report.note({}, fmt::format("assumed: ambient light {} (--ambient-light)", options.ambient_light));
        result.scene = std::move(m.scene);
    }
    const bool full = report.full();
    result.notes = report.take();
    if (is_text && !full) append_new(result.notes, validate(result.scene));
    if (has_errors(result.notes)) {
        std::erase_if(result.notes, [](const Diagnostic& d) { return d.severity != Severity::error; });
        throw Error(ErrorKind::scene, std::move(result.notes));
    }
    result.files = {path};
    return result;
}

SceneRead read_legacy_scene(const std::string& path, const LegacyOptions& options) {
    return read_legacy_bytes(read_legacy_file(path), path, options);
}

}  // namespace drt
