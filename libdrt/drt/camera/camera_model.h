#pragma once
// The camera of one frame over one exposure, ready to make rays. Coordinates are relative to the plan's origin.

#include <vector>

#include "drt/base/constants.h"
#include "drt/base/math.h"
#include "drt/camera/curve.h"
#include "drt/geometry/motion_path.h"
#include "drt/sampling/warps.h"

namespace drt {

/// Where the film's plane lies: the ray through (x, y) pixels has the direction
/// forward + right * (x - width/2) * pixel_size + up * (height/2 - y) * pixel_size, with pixel_size = 2
/// tan(fov/2)/width.
struct FilmPlane {
    int width = 0, height = 0;
};

struct LensModel {
    double radius = 0;
    bool radial = false;        ///< radius uniform (legacy) instead of uniform over the disc
    bool focus_sphere = false;  ///< focus distance along the ray (legacy) instead of to a plane
};

template <class Real>
struct CameraModel {
    FilmPlane film;
    LensModel lens;
    // Curves go over ray time u in [begin, begin + 1 / inv_length], the part of the exposure that lies within the
    // camera's video; before and after it they stand still.
    double begin = 0, inv_length = 1;
    Curve<Vec3<Real>> eye{{}};
    Curve<Vec3<Real>> view{{0, 0, -1}};   ///< from the eye to the target
    Curve<Vec3<Real>> up{{0, 1, 0}};      ///< of any length
    Curve<Real> pixel_width{1};           ///< width of a pixel on an image plane ...
    Curve<Real> image_distance{1};        ///< ... at this distance
    Curve<Real> focus{0};                 ///< distance; 0 = from eye to target
    std::vector<MotionPiece<Real>> path;  ///< if not empty: the eye instead of the curve, and turns of view and up
    float switch_ratio = 0;               ///< of the shutter: share of the exposure spent opening and closing
    bool moving = false;                  ///< anything above changes during the exposure
};

/// Eye and scaled axes: everything of the camera that a ray needs at one time.
template <class T>
struct View {
    Vec3<T> eye;
    Vec3<T> right, up, forward;  ///< orthonormal
    T pixel_size;                ///< at distance 1
    T focus;
};

template <class T>
struct CameraRay {
    Vec3<T> o, d;  ///< d is a unit vector
};

/// Position on the film in pixels from the upper left corner; `lens_uv` in [0, 1)^2 is not read by a pinhole.
template <bool has_lens, class T>
[[gnu::always_inline]] inline CameraRay<T> camera_ray(const View<T>& v, const FilmPlane& film, const LensModel& lens,
                                                      const Vec2<T>& position, const Vec2<T>& lens_uv) {
    using Real = ScalarOf<T>;
    const T x = (position.x - T(Real(film.width) / 2)) * v.pixel_size;
    const T y = (T(Real(film.height) / 2) - position.y) * v.pixel_size;
    const Vec3<T> direction = v.forward + v.right * x + v.up * y;
    if constexpr (!has_lens) return {v.eye, normalize(direction)};
    const Vec2<T> disc = lens.radial ? radial_disc(lens_uv) : uniform_disc(lens_uv);
    const Vec3<T> offset = (v.right * disc.x + v.up * disc.y) * T(Real(lens.radius));
    // On the plane of focus the forward component is the focus distance; on the sphere the length is.
    const Vec3<T> aim = lens.focus_sphere ? normalize(direction) * v.focus : direction * v.focus;
    return {v.eye + offset, normalize(aim - offset)};
}

/// The view at ray time u, per lane.
template <class T>
View<T> view_at(const CameraModel<ScalarOf<T>>& c, const T& u);

template <class To, class From>
View<To> cast(const View<From>& v) {
    return {Vec3<To>(v.eye),     Vec3<To>(v.right),          Vec3<To>(v.up),
            Vec3<To>(v.forward), num_cast<To>(v.pixel_size), num_cast<To>(v.focus)};
}

template <class To, class From>
CameraModel<To> cast(const CameraModel<From>& c) {
    using V = Vec3<To>;
    CameraModel<To> out{c.film,
                        c.lens,
                        c.begin,
                        c.inv_length,
                        cast<V>(c.eye),
                        cast<V>(c.view),
                        cast<V>(c.up),
                        cast<To>(c.pixel_width),
                        cast<To>(c.image_distance),
                        cast<To>(c.focus),
                        {},
                        c.switch_ratio,
                        c.moving};
    for (const auto& p : c.path) out.path.push_back(cast<To>(p));
    return out;
}

}  // namespace drt

#include "drt/camera/view_impl.h"
