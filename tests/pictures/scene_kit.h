#pragma once
// What the picture scenes have in common.

#include "pictures/scenes.h"
#include "support/scene_parts.h"

namespace drt {

/// A pinhole camera with an instantaneous shutter and a box filter of one pixel, 64 x 48.
SceneDesc simple_scene(const Vec3d& eye, const Vec3d& target, double fov_degrees = 45);

/// Adds a body with its own material, which is called as the body.
void add(SceneDesc&, const std::string& name, const Shape&, Material);

/// As `add`, for a body that moves.
void add_moving(SceneDesc&, const std::string& name, const Shape&, Material, const Motion&);

/// Diffuse and a little ambient of the same colour, and a highlight.
Material shiny(const Color& color, float specular = 0.3f, double shininess = 15);
Material mirror(double reflectance, double spread_degrees = 0);
Material glass(double index, double refraction = 0.9, double spread_degrees = 0);

/// A square rectangle light about `center` that shines down.
RectLight lamp(const Vec3d& center, double side);

/// Writes a smooth 16 x 8 colour pattern, different in every quarter, as a PPM file and returns its path. Its texels
/// are meant to be larger than pixels, so that filtering by footprint leaves them alone.
std::string write_test_texture(const std::string& folder);

}  // namespace drt
