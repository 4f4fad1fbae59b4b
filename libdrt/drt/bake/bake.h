#pragma once
// The motion of dynamic bodies becomes keyframes like those that a user writes by hand; rendering knows of no physics.
//
// Accuracy: positions and, at the bodies' rims, turns are within simulation.tolerance of the exact motion, as far as
// the controller can tell (dynamics/control.h), and the keyframes' interpolation within as much of that again.
// Implicitly the tolerance is simulation.tolerance_pixels times the smallest pixel that the body is ever seen in
// (pixel_tolerance.h); always between 1e-6 and 0.1 of the size of the smallest dynamic body.

#include "drt/bake/bake_input.h"

namespace drt {

/// About the whole, or about a body.
struct BakeNote {
    Severity severity = Severity::warning;
    int body = -1;  ///< of the input, or -1
    std::string message;
    friend bool operator==(const BakeNote&, const BakeNote&) = default;
};

struct BakeReport {
    double begin = 0, end = 0;  ///< scene time
    double trusted_until = 0;   ///< from then on other, equally exact computations of the motion differ
    bool is_chaotic = false;    ///< because of the last digits of the description, not of the steps
    double tolerance = 0;       ///< of positions, scene units, where it is smallest
    double error = 0;           ///< as far as the controller can tell, scene units
    double step = 0;            ///< of bodies in contact, seconds
    int runs = 0;               ///< of the simulation
    int dynamic_bodies = 0, impacts = 0, contact_steps = 0, keys = 0;
    std::vector<BakeNote> notes;
    friend bool operator==(const BakeReport&, const BakeReport&) = default;
};

/// A few lines: bodies, times, keys, tolerance and error, until when the motion can be trusted.
std::string to_text(const BakeReport&);

/// What is computed, and can be kept.
struct BakedMotion {
    std::vector<Motion> motions;  ///< of the input's dynamic bodies, in their order
    BakeReport report;
    friend bool operator==(const BakedMotion&, const BakedMotion&) = default;
};

/// Loads Bullet if there is a dynamic body. Throws Error (asset) if it cannot be loaded.
BakedMotion compute_motion(const BakeInput&);

struct Baked {
    SceneDesc scene;  ///< without physics: what was dynamic has a motion
    BakeReport report;
    Diagnostics notes;  ///< of the report, with the bodies' places
};

/// Motion of this input given to the scene that it was made of.
Baked with_motion(const SceneDesc&, const BakeInput&, BakedMotion);

/// The scene must have passed validate(). `until`: see bake_input().
Baked bake(const SceneDesc&, double until);

}  // namespace drt
