// Renders the reference pictures anew and says how far each lies from the one it replaces (docs/regression.md):
//
//   renew_references [NAME...]    (all without names)

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <filesystem>

#include "drt/base/version.h"
#include "regression/regression.h"

namespace drt {
namespace {

double mean_of(const PictureEstimate& picture) {
    double sum = 0;
    for (const Rgb& c : picture.mean) sum += c.r + c.g + c.b;
    return sum / (3 * double(picture.mean.size()));
}

/// Root mean square over pixels and channels.
double rms(const std::vector<Rgb>& colors) {
    double sum = 0;
    for (const Rgb& c : colors) sum += c.r * c.r + c.g * c.g + c.b * c.b;
    return std::sqrt(sum / (3 * double(colors.size())));
}

double rms_difference(const PictureEstimate& a, const PictureEstimate& b) {
    std::vector<Rgb> differences;
    for (size_t i = 0; i < a.mean.size(); ++i) differences.push_back(a.mean[i] - b.mean[i]);
    return rms(differences);
}

/// The noise that two such pictures differ by when nothing has changed.
double expected_difference(const PictureEstimate& a, const PictureEstimate& b) {
    double sum = 0;
    for (size_t i = 0; i < a.mean.size(); ++i) {
        const Rgb v = a.variance[i] + b.variance[i];
        sum += v.r + v.g + v.b;
    }
    return std::sqrt(sum / (3 * double(a.mean.size())));
}

ReferencePicture render_reference_picture(const Shot& shot) {
    const SceneDesc scene = read_shot(shot);
    ReferencePicture reference;
    reference.scene_hash = hash_scene(scene, repository());
    reference.version = version();
    reference.seeds = reference_seeds;
    reference.spp = spp_per_seed;
    reference.picture = render_shot(shot, scene, reference_seeds, first_reference_seed);
    return reference;
}

void print_change(const ReferencePicture& before, const ReferencePicture& after) {
    if (before.picture.width != after.picture.width || before.picture.height != after.picture.height) {
        fmt::print("  another size\n");
        return;
    }
    CompareOptions options;
    options.alpha = false_alarms;
    const CompareResult result = compare_pictures(before.picture, after.picture, options);
    const double mean = mean_of(before.picture);
    fmt::print("  {}: mean {:.6g} -> {:.6g} ({:+.3f} %), pixels differ by {:.3f} % (noise explains {:.3f} %), {}\n",
               result.same ? "same within noise" : "DIFFERENT", mean, mean_of(after.picture),
               100 * (mean_of(after.picture) / mean - 1),
               100 * rms_difference(before.picture, after.picture) / rms(before.picture.mean),
               100 * expected_difference(before.picture, after.picture) / rms(before.picture.mean),
               before.scene_hash == after.scene_hash ? "same scene" : "the scene has changed");
    if (!result.same) fmt::print("{}", result.report);
}

void renew(const Shot& shot) {
    fmt::print("{}\n", shot.name);
    std::fflush(stdout);
    const ReferencePicture reference = render_reference_picture(shot);
    const std::string path = reference_path(shot);
    if (std::filesystem::exists(path))
        print_change(read_reference(path), reference);
    else
        fmt::print("  new\n");
    write_reference(path, reference);
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    try {
        if (argc == 1)
            for (const drt::Shot& shot : drt::shots()) drt::renew(shot);
        for (int i = 1; i < argc; ++i) drt::renew(drt::find_shot(argv[i]));
    } catch (const std::exception& e) {
        fmt::print(stderr, "renew_references: {}\n", e.what());
        return 1;
    }
}
