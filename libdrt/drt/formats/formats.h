#pragma once
// Scene files. Both formats are sources of the same SceneDesc.

#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"

namespace drt {

/// Assumptions about what the legacy format leaves open (model.md sections 4, 6, 7). drt-convert and drt-render
/// offer each as an option; the defaults here are the documented ones.
struct LegacyOptions {
    enum class Fov { half_width, distance };  ///< angle = 2 atan(FOV / 2) or 2 atan(1 / FOV)
    Fov fov = Fov::half_width;
    Vec3d gravity{0, -9.81, 0};
    double density = 1;
    double legacy_step = 0.05;  ///< seconds; impulse = force * legacy_step
    float ambient_light = 0.12f;
    bool add_lights = false;  ///< add a default light when the scene has none
};

struct SceneRead {
    SceneDesc scene;
    Diagnostics notes;               ///< warnings and notes: defaults used, assumptions made
    std::vector<std::string> files;  ///< that were read: the scene's own and then those that it includes
};

/// Reads a scene of either format: YAML when the name ends in .yaml or .yml, legacy text otherwise. The result has
/// passed validate(). Throws Error (scene, asset) holding every diagnostic.
SceneRead read_scene(const std::string& path, const LegacyOptions& = {});

SceneRead read_yaml_scene(const std::string& path);
SceneRead read_legacy_scene(const std::string& path, const LegacyOptions& = {});

/// YAML text that reads back to an equal valid SceneDesc. `header` lines are put on top as comments. Keys at their
/// default are left out. File references are written relative to `directory`, the folder the text is going to be saved
/// in, where they lie below it or where both are relative to the working directory; else absolute.
std::string write_yaml_scene(const SceneDesc&, const std::string& directory, const std::string& header = {});

/// The balls of a SphereSet file: x, y, z, radius each. Throws Error (asset, or scene with file:line:column).
struct SphereRecord {
    Vec3d center;
    double radius = 0;
};
std::vector<SphereRecord> read_sphere_set(const std::string& path);

}  // namespace drt
