#include "output.h"

#include <fmt/format.h>
#include <xxhash.h>

#include "drt/base/version.h"

namespace drt {

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
            {"drt:frame", fmt::format("{}", info.frame)},
            {"drt:videoTime", fmt::format("{}", e.video_time)},
            {"drt:sceneTimeOpen", fmt::format("{}", e.time0)},
            {"drt:sceneTimeClose", fmt::format("{}", e.time1)},
            {"drt:seed", fmt::format("{}", info.seed)},
            {"drt:spp", fmt::format("{}", spp)},
            {"drt:renderSeconds", fmt::format("{:.3f}", seconds)}};
}

}  // namespace

Metadata metadata(const OutputInfo& info, const RenderResult& r) {
    Metadata m = common_metadata(info, r.spp_done, r.seconds);
    if (r.error.valid) {
        m.emplace_back("drt:rmse", fmt::format("{:.6g}", r.error.rmse));
        m.emplace_back("drt:relativeError", fmt::format("{:.6g}", r.error.relative));
    }
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
