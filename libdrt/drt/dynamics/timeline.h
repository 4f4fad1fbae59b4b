#pragma once
// What a scene asks for at given times: blows, begins and ends of pushes, kinks of the courses of kinematic bodies.

#include "drt/dynamics/rigid_body.h"

namespace drt {

class Timeline {
public:
    /// Of events after `begin` and before `end`.
    Timeline(const RigidScene&, double begin, double end);

    double next() const;  ///< infinite: nothing is left
    double next_of(int body, double if_none) const;
    std::vector<int> take_until(double time);  ///< bodies whose events, not taken yet, are not after this time

private:
    struct Event {
        double time = 0;
        int body = 0;
    };
    std::vector<Event> events_;
    size_t next_ = 0;
};

/// Of gravity and the pushes that act on a dynamic body from this time on.
Vec3d acceleration_from(const RigidScene&, int body, double time);

}  // namespace drt
