// error_study [seeds [samples [width height]]]: the table of docs/sampling.md.

#include <fmt/format.h>

#include <cstdlib>

#include "regression/error_study.h"

namespace drt {
namespace {

/// For every number of samples: how many pictures in a hundred mislead, would without "at least", and say "at least".
void print_row(const StudyScene& scene, const StudyOptions& options) {
    const std::vector<ErrorTrial> trials = study_errors(scene, options);
    fmt::print("| {} |", scene.name);
    for (int spp = 2; spp <= options.most_spp; spp *= 2) {
        int pictures = 0, misleading = 0, too_small = 0, at_least = 0;
        for (const ErrorTrial& t : trials) {
            if (t.spp != spp) continue;
            ++pictures;
            misleading += t.misleads();
            too_small += t.stated.rmse < t.rmse / 2;
            at_least += t.stated.at_least;
        }
        const auto percent = [&](int n) { return 100.0 * n / pictures; };
        fmt::print(" {:.3g} / {:.3g} / {:.3g} |", percent(misleading), percent(too_small), percent(at_least));
    }
    fmt::print("\n");
    std::fflush(stdout);
}

}  // namespace

int print_table(int argc, char** argv) {
    StudyOptions options;
    int* const values[] = {&options.seeds, &options.most_spp, &options.width, &options.height};
    for (int i = 1; i < argc && i <= 4; ++i) *values[i - 1] = std::atoi(argv[i]);
    for (const StudyScene& scene : fireflies_to_study()) print_row(scene, options);
    for (const StudyScene& scene : shipped_scenes_to_study()) print_row(scene, options);
    return 0;
}

}  // namespace drt

int main(int argc, char** argv) { return drt::print_table(argc, argv); }
