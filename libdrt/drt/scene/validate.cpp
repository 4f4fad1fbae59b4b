#include "drt/scene/check_fields.h"

namespace drt {
namespace {

void check_globals(Report& report, const SceneDesc& scene) {
    const ScenePath root;
    for_each_field<SceneDesc>([&](const auto& entry) {
        using Member = std::remove_cvref_t<decltype(scene.*entry.member)>;
        if constexpr (std::is_same_v<Member, Color> || std::is_same_v<Member, double> ||
                      std::is_same_v<Member, std::optional<Vec3d>>)
            check_entry(report, root, scene, entry);
    });
}

}  // namespace

void check_render(Report& report, const SceneDesc& scene) {
    const ScenePath root, at = root / "render";
    const RenderSettings& r = scene.render;
    const FineFields fine = check_fields(report, at, r);
    if (fine(at / "width", at / "height") && std::int64_t(r.width) * r.height > largest_image_pixels)
        report.error(at / "width", "too many pixels", to_text(r.width) + " x " + to_text(r.height),
                     "at most 2^28 = 268435456 in all");
}

void check_textures(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "textures";
    check_unique_names(report, list, scene.textures);
    for (std::size_t i = 0; i < scene.textures.size(); ++i) check_fields(report, list[i], scene.textures[i]);
}

void check_motion(Report& report, const ScenePath& at, const Motion& motion, const FineFields& fine) {
    const ScenePath keys = at / "keys";
    if (motion.keys.empty()) report.error(keys, "motion without keys", {}, "at least one");
    for (std::size_t i = 0; i < motion.keys.size(); ++i) {
        const MotionKey& key = motion.keys[i];
        if (i > 0 && fine(keys[i] / "time", keys[i - 1] / "time") && !(key.time > motion.keys[i - 1].time))
            report.error(keys[i] / "time", "key times do not ascend", to_text(key.time),
                         "more than the previous key's " + to_text(motion.keys[i - 1].time));
        if (key.turn && key.orientation)
            report.error(keys[i] / "turn", "turn beside orientation", {}, "one of the two");
        else if (key.turn && i == 0)
            report.error(keys[i] / "turn", "the first key has no previous one to turn from", {},
                         "orientation in place of turn");
    }
}

Diagnostics validate(const SceneDesc& scene) {
    Report report{scene.sources};
    check_globals(report, scene);
    check_render(report, scene);
    check_simulation(report, scene);
    check_textures(report, scene);
    check_materials(report, scene);
    check_bodies(report, scene);
    check_lights(report, scene);
    check_cameras(report, scene);
    return report.diagnostics;
}

}  // namespace drt
