#pragma once
// Radiance along a ray, one random sample of it.

#include <vector>

#include "reference/random.h"
#include "reference/world.h"

namespace drt::reference {

/// The transparent bodies that a ray is inside of, entered last at the back.
using MediaStack = std::vector<const WorldBody*>;

/// `depth` counts the reflections and refractions behind the ray: 0 for camera rays.
Rgb radiance(const Instant&, const Ray&, int depth, const MediaStack&, Random&);

/// Angle between a glossy direction and its sharp one: density exp(-theta^2 / 2 sigma^2) cos(theta) on [0, pi/2).
double sample_deviation(double sigma, Random&);

}  // namespace drt::reference
