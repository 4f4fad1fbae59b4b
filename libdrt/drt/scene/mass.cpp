#include "drt/scene/mass.h"

#include "drt/base/constants.h"

namespace drt {
namespace {

// Of mass 1.
struct UnitMass {
    double volume;
    Vec3d inertia;
};

UnitMass of_unit_mass(const Sphere& s) {
    const double r2 = s.radius * s.radius, i = 0.4 * r2;
    return {4 * pi<double> / 3 * r2 * s.radius, {i, i, i}};
}

UnitMass of_unit_mass(const Box& b) {
    const double x2 = b.size.x * b.size.x, y2 = b.size.y * b.size.y, z2 = b.size.z * b.size.z;
    return {b.size.x * b.size.y * b.size.z, {(y2 + z2) / 12, (z2 + x2) / 12, (x2 + y2) / 12}};
}

UnitMass of_unit_mass(const Cylinder& c) {
    const Vec3d axis = c.to - c.from;
    const double r2 = c.radius * c.radius, across = r2 / 4 + dot(axis, axis) / 12;
    return {pi<double> * r2 * length(axis), {across, across, r2 / 2}};
}

}  // namespace

std::optional<MassProperties> mass_properties(const Shape& shape, const PhysicsDesc& physics) {
    return std::visit(
        [&](const auto& s) -> std::optional<MassProperties> {
            if constexpr (requires { of_unit_mass(s); }) {
                const UnitMass unit = of_unit_mass(s);
                const double mass = physics.mass ? *physics.mass : physics.density.value_or(1) * unit.volume;
                return MassProperties{mass, unit.inertia * mass};
            }
            return {};
        },
        shape);
}

}  // namespace drt
