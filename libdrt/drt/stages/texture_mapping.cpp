#include "drt/stages/texture_mapping.h"

#include "drt/texture/lookup.h"

namespace drt {

namespace {

/// Texture coordinates and their change along the two axes of the footprint.
template <class F>
struct SurfaceUv {
    Vec2<F> uv, du, dv;  // du along the first axis, dv along the second
};

template <class R>
Vec2<Rebind<R, float>> to_float(const R& x, const R& y) {
    using F = Rebind<R, float>;
    return {num_cast<F>(x), num_cast<F>(y)};
}

// u, v and gradients from two linear functions of the position: gradients gu, gv.
template <class R>
SurfaceUv<Rebind<R, float>> linear_uv(const R& u, const R& v, const Vec3<R>& gu, const Vec3<R>& gv, const Vec3<R>& a,
                                      const Vec3<R>& b) {
    return {to_float(u, v), to_float(dot(gu, a), dot(gv, a)), to_float(dot(gu, b), dot(gv, b))};
}

template <class Real, class R>
SurfaceUv<Rebind<R, float>> planar_uv(const Mapping<Real>& m, const Vec3<R>& p, const Vec3<R>& a, const Vec3<R>& b) {
    const Vec3<R> gu(m.ax), gv(m.ay);
    const Vec3<R> q = p - Vec3<R>(m.origin);
    return linear_uv(dot(q, gu), dot(q, gv), gu, gv, a, b);
}

// Longitude in turns around z from x towards y, and its gradient, for a point (x, y) off the axis.
template <class R>
struct Longitude {
    R turns;
    R gx, gy;
};

template <class R>
Longitude<R> longitude(const R& x, const R& y) {
    using F = Rebind<R, float>;
    using Real = ScalarOf<R>;
    constexpr Real per_turn = 1 / (2 * pi<Real>);
    const R turns = num_cast<R>(fast_atan2(num_cast<F>(y), num_cast<F>(x))) * R(per_turn);
    const R scale = R(per_turn) / max(x * x + y * y, R(Real(1e-30)));
    return {select(turns < R(0), turns + R(1), turns), -y * scale, x * scale};
}

template <class Real, class R>
SurfaceUv<Rebind<R, float>> spherical_uv(const Mapping<Real>& m, const Vec3<R>& p, const Vec3<R>& n, const Vec3<R>& a,
                                         const Vec3<R>& b) {
    using F = Rebind<R, float>;
    using std::sqrt;
    const Vec3<R> ax(m.ax), ay(m.ay), az(m.az);
    const R x = dot(n, ax), y = dot(n, ay), z = clamp(dot(n, az), R(-1), R(1));
    const R inv_radius = R(1) / sqrt(dot(p, p));
    const Longitude<R> l = longitude(x, y);
    const R v = num_cast<R>(fast_acos(num_cast<F>(z))) * R(1 / pi<Real>);
    // acos' = -1 / sqrt(1 - z^2): infinite at the pole, where the footprint covers every longitude anyway
    const R slope = R(-1 / pi<Real>) / sqrt(max(R(1) - z * z, R(Real(1e-6))));
    const Vec3<R> gu = (ax * l.gx + ay * l.gy) * inv_radius, gv = az * (slope * inv_radius);
    return linear_uv(l.turns, v, gu, gv, a, b);
}

template <class Real, class R>
SurfaceUv<Rebind<R, float>> box_uv(const Mapping<Real>& m, const Vec3<R>& p, const Rebind<R, int>& part,
                                   const Vec3<R>& a, const Vec3<R>& b) {
    using I = Rebind<R, int>;
    const Vec3<R> ax(m.ax), ay(m.ay), az(m.az);
    const I axis = part >> 1;
    // faces +-x use (z, y), +-y use (x, z), +-z use (x, y)
    const auto on_x = mask_cast<R>(axis == I(0)), on_y = mask_cast<R>(axis == I(1));
    const Vec3<R> first = select(on_x, az, ax), second = select(on_y, az, ay);
    const R half_first = select(on_x, R(m.origin.z), R(m.origin.x));
    const R half_second = select(on_y, R(m.origin.z), R(m.origin.y));
    return linear_uv(dot(p, first) + half_first, half_second - dot(p, second), first, -second, a, b);
}

template <class Real, class R>
SurfaceUv<Rebind<R, float>> cylindrical_uv(const Mapping<Real>& m, const Vec3<R>& p, const Rebind<R, int>& part,
                                           const Vec3<R>& a, const Vec3<R>& b) {
    using I = Rebind<R, int>;
    const Vec3<R> ax(m.ax), ay(m.ay), az(m.az);
    const R radius(m.origin.x), half(m.origin.y);
    const R x = dot(p, ax), y = dot(p, ay), z = dot(p, az);
    const auto side = mask_cast<R>(part == I(part_side));
    const Longitude<R> l = longitude(x, y);
    const R across = R(1) / (radius + radius), along = R(1) / (half + half);
    const R u = select(side, l.turns, R(Real(0.5)) + x * across);
    const R v = select(side, (half - z) * along, R(Real(0.5)) - y * across);
    const Vec3<R> gu = select(side, ax * l.gx + ay * l.gy, ax * across);
    const Vec3<R> gv = select(side, az * -along, ay * -across);
    return linear_uv(u, v, gu, gv, a, b);
}

// Point `p` and unit outward normal `n` relative to the body's centre, in its described orientation; axes a, b.
template <class Real, class R>
SurfaceUv<typename Pack<Real>::F> surface_uv(const Mapping<Real>& m, const Vec3<R>& p, const Vec3<R>& n,
                                             const typename Pack<Real>::I& part, const Vec3<R>& a, const Vec3<R>& b) {
    switch (m.kind) {
        case MappingKind::planar:
            return planar_uv(m, p, a, b);
        case MappingKind::spherical:
            return spherical_uv(m, p, n, a, b);
        case MappingKind::box:
            return box_uv(m, p, part, a, b);
        case MappingKind::cylindrical:
            break;
    }
    return cylindrical_uv(m, p, part, a, b);
}

// The ray's cone cuts the surface in an ellipse: its width across the ray's plane, stretched by 1 / cos along it.
template <class R>
struct Footprint {
    Vec3<R> major, minor;  // full axes, in the surface
};

template <class R>
Footprint<R> footprint(const Vec3<R>& d, const Vec3<R>& n, const R& width) {
    using Real = ScalarOf<R>;
    const R c = dot(d, n);
    const Vec3<R> in_surface = d - n * c;
    const R length2 = dot(in_surface, in_surface);
    using std::abs;
    using std::sqrt;
    const auto oblique = length2 > R(Real(1e-8));
    const Vec3<R> along = select(oblique, in_surface / sqrt(max(length2, R(Real(1e-8)))), frame_around(n).x);
    return {along * (width / max(abs(c), R(Real(1e-3)))), cross(n, along) * width};
}

template <class Real>
Color3<typename Pack<Real>::F> body_texture(const World<Real>& w, const RayBatch<Real>& b, int i, int body) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    Vec3<R> p = load3<R>(b.p, i), n = load3<R>(b.n, i), d = load3<R>(b.d, i);
    n = select(mask_cast<R>(load<I>(b.outward.at(i)) == I(1)), n, -n);
    if (const auto path = w.bodies.path(body); path.empty()) {
        p -= Vec3<R>(w.bodies.centers[size_t(body)]);
    } else {  // into the body's described pose: a turning ball turns its texture
        const Pose<R> pose = pose_at(path, num_cast<R>(load<F>(b.time.at(i))));
        p = rotate_back(pose.orientation, p - pose.center);
        n = rotate_back(pose.orientation, n);
        d = rotate_back(pose.orientation, d);
    }
    const Footprint<R> f = footprint(d, n, num_cast<R>(load<F>(b.footprint.at(i))));
    const Mapping<Real>& mapping = w.mappings[size_t(w.body_mapping[size_t(body)])];
    const SurfaceUv<F> s = surface_uv<Real>(mapping, p, n, load<I>(b.part.at(i)), f.major, f.minor);
    const size_t material = size_t(w.body_material[size_t(body)]);
    const F su(w.materials.inv_scale_u[material]), sv(w.materials.inv_scale_v[material]);
    const TextureMap& texture = w.textures[size_t(w.materials.texture[material])];
    return lookup<F>(texture, {s.uv.x * su, s.uv.y * sv}, {s.du.x * su, s.du.y * sv}, {s.dv.x * su, s.dv.y * sv});
}

}  // namespace

template <class Real>
Color3<typename Pack<Real>::F> texture_color(const World<Real>& w, const RayBatch<Real>& batch, int i,
                                             const typename Pack<Real>::I& material,
                                             const Color3<typename Pack<Real>::F>& albedo) {
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    const auto textured =
        material >= I(0) && gather_coherent<I>(w.materials.texture.data(), max(material, I(0))) != I(no_texture);
    Color3<F> out = albedo;
    const I body = load<I>(batch.body.at(i));
    auto todo = textured;
    for (int l = 0; l < Pack<Real>::width; ++l) {
        if (!lane_bit(todo, l)) continue;
        const auto same = todo && body == I(batch.body[i + l]);
        out = select(mask_cast<F>(same), body_texture(w, batch, i, batch.body[i + l]), out);
        todo = todo && !same;
    }
    return out;
}

template Color3<Pack<float>::F> texture_color(const World<float>&, const RayBatch<float>&, int, const Pack<float>::I&,
                                              const Color3<Pack<float>::F>&);
template Color3<Pack<double>::F> texture_color(const World<double>&, const RayBatch<double>&, int,
                                               const Pack<double>::I&, const Color3<Pack<double>::F>&);

}  // namespace drt
