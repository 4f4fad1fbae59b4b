#include "support/transform_scene.h"

#include <stdexcept>

namespace drt {
namespace {

/// Applies `point` to every position, `vector` to every edge and `length` to every length of a scene's geometry.
template <class Point, class Vector, class Length>
struct Transform {
    Point point;
    Vector vector;
    Length length;

    void operator()(Plane& s) const { point(s.position); }
    void operator()(Sphere& s) const { point(s.center), length(s.radius); }
    void operator()(Triangle& s) const { point(s.vertex0), point(s.vertex1), point(s.vertex2); }
    void operator()(Rectangle& s) const { point(s.vertex0), point(s.vertex1), point(s.vertex2); }
    void operator()(Parallelogram& s) const { point(s.corner), vector(s.edge0), vector(s.edge1); }
    void operator()(Box& s) const { point(s.center), vector(s.size); }
    void operator()(Cylinder& s) const { point(s.from), point(s.to), length(s.radius); }
    void operator()(Disc& s) const { point(s.center), length(s.radius); }
    void operator()(SphereSet&) const { throw std::invalid_argument("a sphere set is a file"); }
    void operator()(PointLight& s) const { point(s.position); }
    void operator()(RectLight& s) const { point(s.corner), vector(s.edge_x), vector(s.edge_y); }
    void operator()(SphereLight& s) const { point(s.center), length(s.radius); }
    void operator()(Motion& motion) const {
        for (MotionKey& k : motion.keys) point(k.position);
    }
    void operator()(Camera& camera) const {
        for (Vec3d& p : camera.positions) point(p);
        for (Vec3d& p : camera.targets) point(p);
        if (camera.motion) (*this)(*camera.motion);
        length(camera.lens.aperture_radius);
        if (camera.lens.focus_start) length(*camera.lens.focus_start);
        if (camera.lens.focus_end) length(*camera.lens.focus_end);
    }
    void operator()(SceneDesc& scene) const {
        for (Body& b : scene.bodies) {
            std::visit(*this, b.shape);
            if (b.motion) (*this)(*b.motion);
        }
        for (Light& l : scene.lights) std::visit(*this, l.shape);
        for (Camera& c : scene.cameras) (*this)(c);
    }
};

bool has_spatial_texture_scale(const Shape& shape) {
    return !std::holds_alternative<Sphere>(shape) && !std::holds_alternative<Cylinder>(shape);
}

}  // namespace

SceneDesc translated(SceneDesc scene, const Vec3d& by) {
    const auto keep = [](auto&) {};
    Transform{[&](Vec3d& p) { p += by; }, keep, keep}(scene);
    return scene;
}

SceneDesc scaled(SceneDesc scene, double by) {
    Transform{[&](Vec3d& p) { p *= by; }, [&](Vec3d& v) { v *= by; }, [&](double& l) { l *= by; }}(scene);
    for (Light& l : scene.lights)
        if (std::holds_alternative<PointLight>(l.shape) && l.falloff == Light::Falloff::inverse_square)
            l.color *= float(by * by);
    for (const Body& b : scene.bodies)
        for (Material& m : scene.materials)
            if (m.name == b.material && !m.texture.empty() && has_spatial_texture_scale(b.shape)) {
                m.scale_u *= by;
                m.scale_v *= by;
            }
    return scene;
}

}  // namespace drt
