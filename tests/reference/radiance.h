#pragma once
// Radiance along a ray, one random sample of it.

#include "reference/media.h"
#include "reference/random.h"

namespace drt::reference {

/// `depth` counts the reflections and refractions behind the ray: 0 for camera rays.
Rgb radiance(const Instant&, const Ray&, int depth, const Media&, Random&);

/// Angle between a glossy direction and its sharp one: density exp(-theta^2 / 2 sigma^2) cos(theta) on [0, pi/2).
double sample_deviation(double sigma, Random&);

}  // namespace drt::reference
