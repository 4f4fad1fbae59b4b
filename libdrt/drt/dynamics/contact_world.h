#pragma once
// Where bodies are nearest, and what impulses act between bodies that touch: the facade of Bullet, which only the room
// `bullet` behind it sees. Time is not its business: Bullet's own time stepping is what makes its bounces wrong
// (docs/dynamics.md).

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "drt/dynamics/nearest.h"
#include "drt/dynamics/polytope.h"
#include "drt/dynamics/rigid_body.h"

namespace drt {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Where two bodies touch or nearly do.
struct ContactPoint {
    double gap = 0;       ///< negative: how deep they overlap
    double approach = 0;  ///< of the two surfaces along the normal, length / s; negative: they part
    Vec3d normal;         ///< unit, from b towards a
    Vec3d on_a, on_b;
    Vec3d force;  ///< on a, in lasting contact (hold.h)
};

/// A pair of bodies that are near each other, a < b.
struct Contact {
    static constexpr int most_points = most_surface_points;
    int a = 0, b = 0;
    int count = 0;
    std::array<ContactPoint, most_points> all{};

    std::span<ContactPoint> points() { return {all.data(), std::size_t(count)}; }
    std::span<const ContactPoint> points() const { return {all.data(), std::size_t(count)}; }
    /// Of its fastest point.
    double approach() const {
        double fastest = -never;
        for (const ContactPoint& p : points()) fastest = std::max(fastest, p.approach);
        return fastest;
    }
};

/// How fast the surfaces of a contact approach each other at a point, with these velocities.
inline double approach_at(const Contact& c, const ContactPoint& p, const std::vector<RigidState>& states) {
    const RigidState &a = states[std::size_t(c.a)], &b = states[std::size_t(c.b)];
    const Vec3d va = a.velocity + cross(a.spin, p.on_a - a.position);
    const Vec3d vb = b.velocity + cross(b.spin, p.on_b - b.position);
    return -dot(va - vb, p.normal);
}

/// From where on contacts are seen: Bullet's default, which is a global variable of the process.
inline constexpr double farthest_contact = 0.02;

class ContactWorld {
public:
    virtual ~ContactWorld() = default;

    /// By iteration, for pairs of convex bodies; see nearest_bodies() (contacts.h).
    virtual Nearest nearest(int a, const RigidState&, int b, const RigidState&) const = 0;

    /// Pairs of bodies near each other, in order, with Bullet's points nearer than `reach`, at most farthest_contact:
    /// perhaps none. Without their approach. See find_contacts() (contacts.h).
    virtual std::vector<Contact> contacts(const std::vector<RigidState>&, double reach) = 0;

    /// An impact at all points of these contacts at once: with restitution and friction, in no time.
    virtual void collide(std::vector<RigidState>&, std::span<const Contact>) = 0;
};

/// Keeps a reference to the scene. Bullet is loaded on the first call: the room `bullet` is a library of its own,
/// libdrt-bullet.so, sought wherever the dynamic linker would seek it for this program. Throws Error (asset) if it is
/// not there or belongs to another version of drt. A program that links the room itself needs no file.
std::unique_ptr<ContactWorld> load_contact_world(const RigidScene&);

/// What both sides of this interface must have been compiled with. Raise it with every change of the structs and
/// functions above or of rigid_body.h.
inline constexpr const char* contact_world_version = "contacts 6";

}  // namespace drt
