#pragma once
// Where a ray crosses a shape's surface, from the textbook formulas in 113-bit arithmetic: the truth that the fast
// single and double precision code is held against. Shares no code with it but the shapes' data.

#include <vector>

#include "drt/geometry/shapes.h"

namespace drt::test {

__extension__ typedef __float128 Quad;

struct Ray {
    Vec3<Quad> o, d;  // relative to the shape's centre
};

/// One crossing of the surface, whatever its sign.
struct Crossing {
    Quad t;
    int part;
    double cosine;  // |d . n|: how squarely the surface is met
    Vec3d normal;   // unit, outward
};

/// In ascending order. `grow` changes each dimension by a little: what rounding might do to the surface. Its components
/// are added to the half extents of a box; x to the radius and z to the half height of a cylinder; x to the radius of a
/// sphere; x to every side of a flat shape's outline.
template <class Real>
std::vector<Crossing> crossings(const SphereShape<Real>&, const Ray&, const Vec3d& grow);
template <class Real>
std::vector<Crossing> crossings(const FlatShape<Real>&, const Ray&, const Vec3d& grow);
template <class Real>
std::vector<Crossing> crossings(const BoxShape<Real>&, const Ray&, const Vec3d& grow);
template <class Real>
std::vector<Crossing> crossings(const CylinderShape<Real>&, const Ray&, const Vec3d& grow);
template <class Real>
std::vector<Crossing> crossings(const PlaneShape<Real>&, const Ray&, const Vec3d& grow);

}  // namespace drt::test
