#include "bare_scene.h"

#include <cmath>
#include <limits>
#include <span>

namespace drt {

namespace {

using F = Pack<float>::F;
using I = Pack<float>::I;
using U = Pack<float>::U;

struct Lanes {
    Vec3<F> o, d;
    F tnear, tfar, time;
    Pack<float>::Mask valid;
};

Lanes load_lanes(RTCRayN* r, unsigned n, const int* valid) {
    return {{load<F>(&RTCRayN_org_x(r, n, 0)), load<F>(&RTCRayN_org_y(r, n, 0)), load<F>(&RTCRayN_org_z(r, n, 0))},
            {load<F>(&RTCRayN_dir_x(r, n, 0)), load<F>(&RTCRayN_dir_y(r, n, 0)), load<F>(&RTCRayN_dir_z(r, n, 0))},
            load<F>(&RTCRayN_tnear(r, n, 0)),
            load<F>(&RTCRayN_tfar(r, n, 0)),
            load<F>(&RTCRayN_time(r, n, 0)),
            mask_cast<F>(load<I>(valid) != I(0))};
}

struct Found {
    Pack<float>::Mask valid;
    F t;
};

Found find(const BareBodies::Sphere& s, const Lanes& r, bool moving) {
    Vec3<F> c(s.center);
    if (moving) c += Vec3<F>(s.velocity) * r.time;
    const Vec3<F> l = r.o - c;
    const F b = dot(l, r.d);
    const Vec3<F> p = l - r.d * b;
    const F disc = F(s.radius * s.radius) - dot(p, p);
    const F root = sqrt(max(disc, F(0)));
    const F t0 = -b - root, t1 = -b + root;
    const F t = select(t0 > r.tnear, t0, t1);
    return {r.valid && disc >= F(0) && t > r.tnear && t < r.tfar, t};
}

Found find(const BareBodies::BoxBody& b, const Lanes& r, bool) {
    const Vec3<F> o = r.o - Vec3<F>(b.center);
    F lo(-std::numeric_limits<float>::infinity()), hi(std::numeric_limits<float>::infinity());
    const auto clip = [&](const F& x, const F& d, float half) {
        const F inv = F(1) / d;
        const F a = (F(-half) - x) * inv, c = (F(half) - x) * inv;
        lo = max(lo, min(a, c));
        hi = min(hi, max(a, c));
    };
    clip(o.x, r.d.x, b.half.x);
    clip(o.y, r.d.y, b.half.y);
    clip(o.z, r.d.z, b.half.z);
    const F t = select(lo > r.tnear, lo, hi);
    return {r.valid && lo <= hi && t > r.tnear && t < r.tfar, t};
}

template <class Body>
struct Geometry {
    std::vector<Body> bodies;
    bool moving = false;
};

// Single rays out of a packet: the same arithmetic on a packet with one live lane.
template <class Body>
Found find_n(const Geometry<Body>& g, unsigned prim, RTCRayN* ray, unsigned n, const int* valid) {
    if (n == unsigned(packet_width)) return find(g.bodies[prim], load_lanes(ray, n, valid), g.moving);
    alignas(64) float columns[9][packet_width] = {};
    alignas(64) int live[packet_width] = {};
    for (unsigned i = 0; i < n; ++i) {
        const float values[9] = {RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i),
                                 RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i),
                                 RTCRayN_tnear(ray, n, i), RTCRayN_tfar(ray, n, i),  RTCRayN_time(ray, n, i)};
        for (int k = 0; k < 9; ++k) columns[k][i] = values[k];
        live[i] = valid[i];
    }
    const auto c = [&](int k) { return load<F>(columns[k]); };
    const Lanes lanes{{c(0), c(1), c(2)}, {c(3), c(4), c(5)}, c(6), c(7), c(8), mask_cast<F>(load<I>(live) != I(0))};
    return find(g.bodies[prim], lanes, g.moving);
}

template <class Body>
void intersect(const RTCIntersectFunctionNArguments* args) {
    const auto& g = *static_cast<const Geometry<Body>*>(args->geometryUserPtr);
    RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, args->N);
    const Found f = find_n(g, args->primID, ray, args->N, args->valid);
    if (!any(f.valid)) return;
    for (unsigned i = 0; args->N != unsigned(packet_width) && i < args->N; ++i)
        if (lane_bit(f.valid, int(i))) {
            RTCRayN_tfar(ray, args->N, i) = lane(f.t, int(i));
            RTCHitN_primID(hit, args->N, i) = args->primID;
            RTCHitN_geomID(hit, args->N, i) = args->geomID;
        }
    if (args->N != unsigned(packet_width)) return;
    float* tfar = &RTCRayN_tfar(ray, args->N, 0);
    store(select(f.valid, f.t, load<F>(tfar)), tfar);
    unsigned *prim = &RTCHitN_primID(hit, args->N, 0), *geom = &RTCHitN_geomID(hit, args->N, 0);
    store(select(mask_cast<U>(f.valid), U(args->primID), load<U>(prim)), prim);
    store(select(mask_cast<U>(f.valid), U(args->geomID), load<U>(geom)), geom);
}

template <class Body>
void occluded(const RTCOccludedFunctionNArguments* args) {
    const auto& g = *static_cast<const Geometry<Body>*>(args->geometryUserPtr);
    const Found f = find_n(g, args->primID, args->ray, args->N, args->valid);
    for (unsigned i = 0; args->N != unsigned(packet_width) && i < args->N; ++i)
        if (lane_bit(f.valid, int(i))) RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
    if (args->N != unsigned(packet_width)) return;
    float* tfar = &RTCRayN_tfar(args->ray, args->N, 0);
    store(select(f.valid, F(-std::numeric_limits<float>::infinity()), load<F>(tfar)), tfar);
}

RTCBounds around(const Vec3f& c, const Vec3f& h) {
    RTCBounds b{};
    b.lower_x = c.x - h.x, b.lower_y = c.y - h.y, b.lower_z = c.z - h.z;
    b.upper_x = c.x + h.x, b.upper_y = c.y + h.y, b.upper_z = c.z + h.z;
    return b;
}

RTCBounds bounds_of(const BareBodies::Sphere& s, float time) {
    return around(s.center + s.velocity * time, {s.radius, s.radius, s.radius});
}
RTCBounds bounds_of(const BareBodies::BoxBody& b, float) { return around(b.center, b.half); }

template <class Body>
void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& g = *static_cast<const Geometry<Body>*>(args->geometryUserPtr);
    *args->bounds_o = bounds_of(g.bodies[args->primID], float(args->timeStep));
}

template <class Body>
void attach(BareScene& s, const std::vector<Body>& bodies, bool moving) {
    if (bodies.empty()) return;
    auto data = std::make_shared<Geometry<Body>>(Geometry<Body>{bodies, moving});
    s.data.push_back(data);
    RTCGeometry g = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, unsigned(bodies.size()));
    rtcSetGeometryUserData(g, data.get());
    rtcSetGeometryTimeStepCount(g, moving ? 2 : 1);
    rtcSetGeometryBoundsFunction(g, bounds<Body>, nullptr);
    rtcSetGeometryIntersectFunction(g, intersect<Body>);
    rtcSetGeometryOccludedFunction(g, occluded<Body>);
    rtcCommitGeometry(g);
    rtcAttachGeometry(s.scene, g);
    rtcReleaseGeometry(g);
}

void open_scene(BareScene& s) {
    s.device = rtcNewDevice(nullptr);
    s.scene = rtcNewScene(s.device);
    rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
}

void attach_points(BareScene& s, const std::vector<BareBodies::Sphere>& spheres, int steps) {
    if (spheres.empty()) return;
    RTCGeometry g = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    rtcSetGeometryTimeStepCount(g, unsigned(steps));
    for (int step = 0; step < steps; ++step) {
        auto* v = static_cast<float*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, unsigned(step), RTC_FORMAT_FLOAT4, 16, spheres.size()));
        for (const auto& sphere : spheres) {
            const Vec3f c = sphere.center + sphere.velocity * float(step);
            *v++ = c.x, *v++ = c.y, *v++ = c.z, *v++ = sphere.radius;
        }
    }
    rtcCommitGeometry(g);
    rtcAttachGeometry(s.scene, g);
    rtcReleaseGeometry(g);
}

// The six faces of each box.
void attach_quads(BareScene& s, const std::vector<BareBodies::BoxBody>& boxes) {
    RTCGeometry g = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_QUAD);
    auto* v = static_cast<float*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, boxes.size() * 8));
    auto* q = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 16, boxes.size() * 6));
    constexpr unsigned faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                      {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    for (size_t i = 0; i < boxes.size(); ++i) {
        for (unsigned k = 0; k < 8; ++k) {
            *v++ = boxes[i].center.x + (k & 1 ? 1.0f : -1.0f) * boxes[i].half.x;
            *v++ = boxes[i].center.y + (k & 2 ? 1.0f : -1.0f) * boxes[i].half.y;
            *v++ = boxes[i].center.z + (k & 4 ? 1.0f : -1.0f) * boxes[i].half.z;
        }
        for (const auto& face : faces)
            for (const unsigned k : face) *q++ = unsigned(i) * 8 + k;
    }
    rtcCommitGeometry(g);
    rtcAttachGeometry(s.scene, g);
    rtcReleaseGeometry(g);
}

}  // namespace

BareScene::~BareScene() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
}

BareBodies bare_bodies(const SceneDesc& scene, const Vec3d& origin) {
    BareBodies out;
    out.origin = origin;
    for (const Body& b : scene.bodies) {
        if (const auto* s = std::get_if<Sphere>(&b.shape)) {
            if (b.motion) {
                const Vec3d p0 = b.motion->keys.front().position, p1 = b.motion->keys.back().position;
                out.moving.push_back({Vec3f(p0 - origin), Vec3f(p1 - p0), float(s->radius)});
            } else {
                out.still.push_back({Vec3f(s->center - origin), {}, float(s->radius)});
            }
        } else if (const auto* box = std::get_if<Box>(&b.shape)) {
            out.boxes.push_back({Vec3f(box->center - origin), Vec3f(box->size * 0.5)});
        }
    }
    return out;
}

std::unique_ptr<BareScene> build_packet_scene(const BareBodies& b) {
    auto s = std::make_unique<BareScene>();
    open_scene(*s);
    attach(*s, b.still, false);
    attach(*s, b.moving, true);
    attach(*s, b.boxes, false);
    rtcCommitScene(s->scene);
    return s;
}

std::unique_ptr<BareScene> build_point_scene(const BareBodies& b) {
    auto s = std::make_unique<BareScene>();
    open_scene(*s);
    attach_points(*s, b.still, 1);
    attach_points(*s, b.moving, 2);
    attach_quads(*s, b.boxes);
    rtcCommitScene(s->scene);
    return s;
}

}  // namespace drt
