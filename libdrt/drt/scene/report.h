#pragma once
// Collects what validate() finds. Internal to the scene room.

#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"
#include "drt/scene/scene_path.h"

namespace drt {

struct Report {
    const SourceMap& sources;
    Diagnostics diagnostics{};
    std::vector<std::string> error_paths{};  ///< of each error

    /// What the file calls the key at this path.
    std::string name(const ScenePath& at, std::string_view key) const { return sources.name(at.str(), key); }

    void error(const ScenePath&, std::string message, std::string text = {}, std::string expected = {},
               std::string suggestion = {});
    void warning(const ScenePath&, std::string message, std::string text = {}, std::string expected = {});
};

// The parts of validate().
void check_render(Report&, const SceneDesc&);
void check_simulation(Report&, const SceneDesc&);
void check_textures(Report&, const SceneDesc&);
void check_materials(Report&, const SceneDesc&);
void check_bodies(Report&, const SceneDesc&);
void check_lights(Report&, const SceneDesc&);
void check_cameras(Report&, const SceneDesc&);

class FineFields;  // check_fields.h

/// Of a motion whose single values have been checked: keys there, in ascending time, first without a turn.
void check_motion(Report&, const ScenePath&, const Motion&, const FineFields&);

/// Of a body with physics whose single values have been checked: what goes with its shape, its kind and the
/// simulation's time, and whether its mass can be reckoned with.
void check_physics(Report&, const ScenePath&, const SceneDesc&, const Body&, const FineFields&);

/// Of the masses of all bodies together.
void check_masses(Report&, const SceneDesc&);

/// "box", "sphere_set".
std::string shape_name(const Shape&);

/// Nearly parallel, or one of them null: their cross product would be rounding noise.
bool nearly_parallel(const Vec3d&, const Vec3d&);

/// Too short to be normalised without underflow.
bool nearly_null(const Vec3d&);

}  // namespace drt
