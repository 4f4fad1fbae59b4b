#include "output.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <filesystem>
#include <unordered_set>

#include "drt/base/version.h"
#include "frames.h"

namespace drt {

namespace fs = std::filesystem;

std::vector<std::string> output_paths(const RenderArguments& a, int frame) {
    std::vector<std::string> paths;
    for (const std::string& pattern : a.outputs) paths.push_back(frame_path(pattern, frame, a.frames.size() > 1));
    return paths;
}

std::optional<Snapshot> frame_snapshot(const RenderArguments& a, int frame) {
    if (!a.snapshot) return {};
    // Without a token all frames share the snapshot: it shows what is being rendered.
    return Snapshot{frame_path(a.snapshot->path, frame, false), a.snapshot->interval};
}

namespace {

[[noreturn]] void path_error(const std::string& what, const std::string& path) {
    throw Error(ErrorKind::usage, {{Severity::error, {}, what, path, "", ""}});
}

// Frames may share a snapshot, but nothing else is written twice: a snapshot in a picture's place would look like the
// picture after a crash, and cost the old one.
FileSet output_files(const RenderArguments& a) {
    FileSet files, snapshots;
    FileNames name_of;
    for (const int frame : a.frames)
        for (const std::string& path : output_paths(a, frame))
            if (!files.insert(name_of(path)).second) path_error("two outputs have the same path", path);
    for (const int frame : a.frames)
        if (const auto snapshot = frame_snapshot(a, frame)) {
            const std::string file = name_of(snapshot->path);
            if (files.count(file) > 0) path_error("the snapshot is also an output", snapshot->path);
            snapshots.insert(file);
        }
    files.merge(snapshots);
    return files;
}

// The whole check costs an fsync; a thousand frames in one folder need one, the rest is seen from the file alone.
// Before each frame its own outputs are checked again.
class WritableCheck {
public:
    void operator()(const std::string& path) {
        const fs::path p(path);
        std::error_code ignored;
        const fs::file_status status = fs::status(p, ignored);
        const bool ordinary = !fs::exists(status) || fs::is_regular_file(status);
        if (!ordinary || seen_.insert(p.parent_path().string() + '\n' + p.extension().string()).second)
            check_writable(path);
    }

private:
    std::unordered_set<std::string> seen_;
};

}  // namespace

FileSet check_outputs(const RenderArguments& a) {
    FileSet files = output_files(a);
    if (files.count(FileNames()(a.scene)) > 0) path_error("the output is the scene file", a.scene);
    WritableCheck check;
    for (const int frame : a.frames) {
        for (const std::string& path : output_paths(a, frame)) check(path);
        if (const auto snapshot = frame_snapshot(a, frame)) check(snapshot->path);
    }
    return files;
}

std::string scene_hash(const SceneDesc& scene) {
    const std::string text = write_yaml_scene(scene, "/");
    const XXH128_hash_t h = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", h.high64, h.low64);
}

namespace {

Metadata common_metadata(const OutputInfo& info, int spp, double seconds) {
    const Exposure& e = info.plan->exposure;
    return {{"drt:version", version()},
            {"drt:isa", build_isa()},
            {"drt:precision", info.plan->features.double_precision ? "double" : "single"},
            {"drt:sceneHash", info.scene_hash},
            {"drt:frame", info.frame},
            {"drt:videoTime", e.video_time},
            {"drt:sceneTime", e.time0},
            {"drt:sceneTimeClose", e.time1},
            {"drt:seed", double(info.seed)},
            {"drt:spp", spp},
            {"drt:renderSeconds", float(seconds)}};
}

}  // namespace

Metadata metadata(const OutputInfo& info, const RenderResult& r) {
    Metadata m = common_metadata(info, r.spp_done, r.seconds);
    const PictureKnown known = r.known_of();
    if (known == PictureKnown::error || known == PictureKnown::error_at_least) {
        m.emplace_back("drt:rmse", float(r.error.rmse));
        m.emplace_back("drt:relativeError", float(r.error.relative));
    }
    m.emplace_back("drt:errorEstimate", std::string(describe(known)));
    return m;
}

SnapshotWriter::SnapshotWriter(Snapshot snapshot, DisplayTransform display)
    : snapshot_(std::move(snapshot)), display_(display) {}

void SnapshotWriter::pass_done(const Film& film, const Progress& p, const OutputInfo& info) {
    if (!first_ && p.seconds - last_ < snapshot_.interval) return;
    first_ = false;
    last_ = p.seconds;
    write_image(snapshot_.path, resolve(film), common_metadata(info, p.spp_done, p.seconds), display_);
}

}  // namespace drt
