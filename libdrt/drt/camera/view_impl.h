#pragma once
// The view at a time, for scalars and lanes alike (included by camera_model.h).

#include <limits>

#include "drt/base/frame.h"
#include "drt/camera/camera_model.h"

namespace drt {

/// `up` shows where up is in a picture whose view goes along `forward` (a unit vector): it is not nearly parallel to
/// it, nor zero.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> shows_up(const Vec3<T>& forward, const Vec3<T>& up) {
    constexpr auto rounding = 16 * std::numeric_limits<ScalarOf<T>>::epsilon();
    return length_squared(cross(forward, up)) > length_squared(up) * T(rounding * rounding);
}

template <class T>
View<T> view_at(const CameraModel<ScalarOf<T>>& c, const T& u) {
    using Real = ScalarOf<T>;
    const T x = clamp((u - T(Real(c.begin))) * T(Real(2 * c.inv_length)) - T(1), T(-1), T(1));
    View<T> v;
    v.eye = value_at<Vec3<T>>(c.eye, x);
    Vec3<T> view = value_at<Vec3<T>>(c.view, x), up = value_at<Vec3<T>>(c.up, x);
    const T target_distance = length(view);
    if (!c.path.empty()) {
        const Pose<T> pose = pose_at(std::span<const MotionPiece<Real>>(c.path), u);
        v.eye = pose.center;
        view = rotate(pose.orientation, view);
        up = rotate(pose.orientation, up);
    }
    // An eye that passes through its target, or right above it, has no direction or no up for an instant: any will do.
    v.forward = select(target_distance > T(0), view / target_distance, Vec3<T>(T(0), T(0), T(-1)));
    v.right = normalize(cross(v.forward, up));
    const MaskOf<T> has_up = shows_up(v.forward, up);
    if (any(!has_up)) [[unlikely]]
        v.right = select(has_up, v.right, frame_around(v.forward).x);
    v.up = cross(v.right, v.forward);
    // Rounding must not turn the picture over where the angle of view comes near to 0 or 180 degrees.
    constexpr Real least = std::numeric_limits<Real>::epsilon();
    v.pixel_size = max(value_at<T>(c.pixel_width, x), T(0)) / max(value_at<T>(c.image_distance, x), T(least));
    const T focus = value_at<T>(c.focus, x);
    v.focus = select(focus > T(0), focus, target_distance);
    return v;
}

}  // namespace drt
