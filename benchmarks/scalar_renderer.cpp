#include "scalar_renderer.h"

#include <cmath>

#include "drt/base/constants.h"
#include "drt/sampling/filter.h"
#include "drt/sampling/sampler.h"

namespace drt {

namespace {

struct Eye {
    Vec3f position, right, up, forward;
    float pixel_size;
};

Eye make_eye(const SceneDesc& s, const Vec3d& origin) {
    const Camera& c = s.cameras[0];
    const Vec3d forward = normalize(c.targets[0] - c.positions[0]);
    const Vec3d right = normalize(cross(forward, c.up_start));
    return {Vec3f(c.positions[0] - origin), Vec3f(right), Vec3f(cross(right, forward)), Vec3f(forward),
            float(2 * std::tan(radians(c.fov_degrees_start) / 2) / s.render.width)};
}

const Material& material_of(const SceneDesc& s, const std::string& name) {
    for (const Material& m : s.materials)
        if (m.name == name) return m;
    return s.materials.front();
}

// Embree's ids -> materials: spheres first, then the quads of the boxes, as build_point_scene attaches them.
struct Materials {
    std::vector<const Material*> spheres, boxes;
    explicit Materials(const SceneDesc& s) {
        for (const Body& b : s.bodies)
            (std::holds_alternative<Sphere>(b.shape) ? spheres : boxes).push_back(&material_of(s, b.material));
    }
    const Material& at(unsigned geom, unsigned prim) const { return geom == 0 ? *spheres[prim] : *boxes[prim / 6]; }
};

bool visible(const BareScene& bare, Traversal& traversal, const Vec3f& p, const Vec3f& wi, float distance) {
    RTCRay r{};
    r.org_x = p.x, r.org_y = p.y, r.org_z = p.z;
    r.dir_x = wi.x, r.dir_y = wi.y, r.dir_z = wi.z;
    r.tnear = 1e-3f, r.tfar = distance * 0.9999f, r.mask = ~0u;
    traversal.any(bare.scene, r);
    return r.tfar >= 0;
}

}  // namespace

Color render_one_ray_at_a_time(const SceneDesc& s, const BareBodies& bodies, const BareScene& bare, int spp) {
    const Eye eye = make_eye(s, bodies.origin);
    const Materials materials(s);
    const FilterTable filter =
        make_filter({FilterKind::blackman_harris, s.render.filter.radius, s.render.filter.sigma});
    Traversal traversal(true);
    std::vector<Color> film(size_t(s.render.width) * size_t(s.render.height));
    for (int y = 0; y < s.render.height; ++y)
        for (int x = 0; x < s.render.width; ++x)
            for (int sample = 0; sample < spp; ++sample) {
                const SampleSet<float> set =
                    pixel_sample<float>(s.render.seed, 0, std::uint32_t(sample % 2), std::uint32_t(x), std::uint32_t(y),
                                        std::uint32_t(sample / 2));
                const FilterSample<float> f =
                    sample_filter(filter, sample_2d(SamplerKind::sobol, set, dim(PathDim::filter)));
                const float px = (float(x) + 0.5f + f.offset.x - float(s.render.width) / 2) * eye.pixel_size;
                const float py = (float(s.render.height) / 2 - float(y) - 0.5f - f.offset.y) * eye.pixel_size;
                const Vec3f d = normalize(eye.forward + eye.right * px + eye.up * py);
                RTCRayHit r{};
                r.ray.org_x = eye.position.x, r.ray.org_y = eye.position.y, r.ray.org_z = eye.position.z;
                r.ray.dir_x = d.x, r.ray.dir_y = d.y, r.ray.dir_z = d.z;
                r.ray.tfar = std::numeric_limits<float>::infinity(), r.ray.mask = ~0u;
                r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                traversal.nearest(bare.scene, r);
                Color& out = film[size_t(y) * size_t(s.render.width) + size_t(x)];
                if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                    out += s.background;
                    continue;
                }
                const Material& m = materials.at(r.hit.geomID, r.hit.primID);
                const Vec3f p = eye.position + d * r.ray.tfar;
                Vec3f n = normalize(Vec3f{r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z});
                if (dot(n, d) > 0) n = -n;
                Color sum = m.ambient * s.ambient_light;
                int number = 0;
                for (const Light& l : s.lights) {
                    const RectLight& rect = std::get<RectLight>(l.shape);
                    const Vec2<float> u = sample_2d(SamplerKind::sobol, set, dim(HitDim::light, 0, number++));
                    const Vec3f edge_x(rect.edge_x), edge_y(rect.edge_y);
                    const Vec3f to = Vec3f(rect.corner - bodies.origin) + edge_x * u.x + edge_y * u.y - p;
                    const float distance = length(to);
                    const Vec3f wi = to / distance, area = cross(edge_x, edge_y);
                    const float cosine = dot(n, wi);
                    const float facing = -dot(wi, area);  // cos times area
                    if (cosine <= 0 || facing <= 0 || !visible(bare, traversal, p, wi, distance)) continue;
                    const Vec3f mirror = n * (2 * cosine) - wi;
                    const float highlight = std::pow(std::max(0.0f, -dot(mirror, d)), float(m.shininess));
                    sum += (m.diffuse * cosine + m.specular * highlight) * l.color *
                           (facing / (pi<float> * distance * distance));
                }
                out += sum;
            }
    Color total;
    for (const Color& c : film) total += c;
    return total * (1.0f / (float(film.size()) * float(spp)));
}

}  // namespace drt
