#include "drt/dynamics/timeline.h"

#include <algorithm>
#include <limits>

namespace drt {

Timeline::Timeline(const RigidScene& scene, double begin, double end) {
    for (int i = 0; i < int(scene.bodies.size()); ++i) {
        const RigidBody& b = scene.bodies[size_t(i)];
        const auto add = [&](double t) {
            if (t > begin && t < end) events_.push_back({t, i});
        };
        if (b.kind == RigidBody::Kind::dynamic) {
            for (const Blow& blow : b.blows) add(blow.time);
            for (const Push& p : b.pushes) add(p.from), add(p.until);
        }
        if (b.kind == RigidBody::Kind::kinematic)
            for (const Path& p : b.course) add(p.begin);
    }
    std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
}

double Timeline::next() const {
    return next_ < events_.size() ? events_[next_].time : std::numeric_limits<double>::infinity();
}

double Timeline::next_of(int body, double if_none) const {
    for (size_t k = next_; k < events_.size(); ++k)
        if (events_[k].body == body) return events_[k].time;
    return if_none;
}

std::vector<int> Timeline::take_until(double time) {
    std::vector<int> out;
    for (; next() <= time; ++next_)
        if (const int i = events_[next_].body; std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
    return out;
}

Vec3d acceleration_from(const RigidScene& scene, int body, double time) {
    const RigidBody& b = scene.bodies[size_t(body)];
    Vec3d out = scene.gravity;
    for (const Push& p : b.pushes)
        if (p.from <= time && time < p.until) out += p.force / b.mass;
    return out;
}

}  // namespace drt
