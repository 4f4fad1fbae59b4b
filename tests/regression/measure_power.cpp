// Measures, with other seeds in every trial, how often the comparison with the references calls unchanged scenes
// different and how often it catches each planted fault (docs/regression.md):
//
//   regression_power TRIALS [NAME...]    (only the shots and faults of these names)

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <exception>
#include <string_view>
#include <vector>

#include "regression/faults.h"
#include "regression/regression.h"

namespace drt {
namespace {

/// How many of `trials` comparisons, of `seeds` seeds each, call the scene different.
int count_different(const Shot& shot, const SceneDesc& scene, int seeds, int trials) {
    int different = 0;
    for (int i = 0; i < trials; ++i)
        if (!compare_with_reference(shot, scene, seeds, std::uint32_t(1000 + 3 * seeds * i)).same) ++different;
    return different;
}

class Report {
public:
    Report(int trials, std::vector<std::string_view> names) : trials_(trials), names_(std::move(names)) {}

    void unchanged(const Shot& shot) const {
        if (wanted(shot.name)) print(shot, "unchanged", read_shot(shot), 1);
    }
    void planted(const PlantedFault& fault) const {
        if (!wanted(fault.name)) return;
        const Shot& shot = find_shot(fault.shot);
        SceneDesc scene = read_shot(shot);
        fault.plant(scene);
        print(shot, fault.name, scene, fault.seeds);
    }

private:
    bool wanted(std::string_view name) const {
        return names_.empty() || std::find(names_.begin(), names_.end(), name) != names_.end();
    }
    void print(const Shot& shot, const std::string& what, const SceneDesc& scene, int seeds) const {
        fmt::print("{:<26} {:<38} {:>5} spp: different in {} of {}\n", shot.name, what, seeds * spp_per_seed,
                   count_different(shot, scene, seeds, trials_), trials_);
        std::fflush(stdout);
    }
    int trials_;
    std::vector<std::string_view> names_;
};

void measure(int trials, const std::vector<std::string_view>& names) {
    const Report report(trials, names);
    for (const Shot& shot : shots()) report.unchanged(shot);
    for (const PlantedFault& fault : plain_faults()) report.planted(fault);
    for (const PlantedFault& fault : subtle_faults()) report.planted(fault);
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    int trials = 0;
    if (argc < 2 || std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), trials).ec != std::errc() || trials < 1) {
        fmt::print(stderr, "usage: regression_power TRIALS [NAME...]\n");
        return 2;
    }
    try {
        drt::measure(trials, {argv + 2, argv + argc});
    } catch (const std::exception& e) {
        fmt::print(stderr, "regression_power: {}\n", e.what());
        return 1;
    }
}
