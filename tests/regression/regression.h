#pragma once
// The shipped scenes against their reference pictures (docs/regression.md).

#include <cstdint>
#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"
#include "regression/reference_picture.h"
#include "support/compare.h"

namespace drt {

inline constexpr int reference_width = 80, reference_height = 60;

/// Samples per pixel of one seed, in two replicates. A picture takes more samples by more seeds, references and tests
/// alike: so the noise of the one tells that of the other, whatever stratification does within a seed.
inline constexpr int spp_per_seed = 64;
inline constexpr int reference_seeds = 128;
inline constexpr std::uint32_t first_reference_seed = 1u << 20;  ///< far from those of tests
inline constexpr std::uint32_t test_seed = 1;

/// Probability that a look at every shot calls one of them different although nothing has changed, for seeds drawn at
/// random and normal noise; shared evenly among the shots.
inline constexpr double false_alarms = 1e-3;

/// One picture of a scene: of every shipped one, and of lobes.yaml, which shows glossy lobes more clearly than they do.
struct Shot {
    std::string name;  ///< of the reference: references/<name>.exr
    std::string file;  ///< relative to the repository
    int frame = 0;
};

const std::vector<Shot>& shots();
/// Throws std::invalid_argument for a name that none has.
const Shot& find_shot(const std::string& name);

std::string repository();
std::string reference_path(const Shot&);

/// The shot's scene, of the references' size.
SceneDesc read_shot(const Shot&);

/// `scene` (the shot's, changed or not) with the samples of `seeds` seeds, from `first_seed` on.
PictureEstimate render_shot(const Shot&, SceneDesc scene, int seeds, std::uint32_t first_seed);

/// Does `scene` look as the shot's reference does? Renders it with `seeds` seeds. What then looks different is looked
/// at once more, with twice as many other seeds, and that verdict holds: where rare bright samples make the noise it is
/// not normal, and a few of them in one pixel can fool one look, hardly two. Throws std::runtime_error when the
/// reference was made with another number of samples a seed.
CompareResult compare_with_reference(const Shot&, const SceneDesc& scene, int seeds, std::uint32_t first_seed);

}  // namespace drt
