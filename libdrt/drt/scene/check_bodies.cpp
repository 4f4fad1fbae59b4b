#include "drt/scene/check_fields.h"

namespace drt {
namespace {

// ---- degenerate shapes: what remains wrong when every single value is fine -----------------------------------------

void check_shape(Report&, const ScenePath&, const FineFields&, const Plane&) {}
void check_shape(Report&, const ScenePath&, const FineFields&, const Box&) {}
void check_shape(Report&, const ScenePath&, const FineFields&, const Disc&) {}
void check_shape(Report&, const ScenePath&, const FineFields&, const SphereSet&) {}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Sphere& s) {
    if (fine(at / "pole", at / "meridian") && nearly_parallel(s.pole, s.meridian))
        report.error(at / "meridian",
                     report.name(at / "meridian", "meridian") + " is parallel to " + report.name(at / "pole", "pole"),
                     to_text(s.meridian), "a direction away from the axis " + to_text(s.pole));
}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Triangle& t) {
    if (fine(at / "vertex0", at / "vertex1", at / "vertex2") &&
        nearly_parallel(t.vertex1 - t.vertex0, t.vertex2 - t.vertex0))
        report.error(at, "triangle without area", {}, "three points that are not on one line");
}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Rectangle& r) {
    if (fine(at / "vertex0", at / "vertex1", at / "vertex2") &&
        nearly_parallel(r.vertex1 - r.vertex0, r.vertex2 - r.vertex0))
        report.error(at, "rectangle without area", {}, "three points that are not on one line");
}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Parallelogram& p) {
    if (fine(at / "edge0", at / "edge1") && nearly_parallel(p.edge0, p.edge1))
        report.error(at / "edge1", "parallelogram without area", to_text(p.edge1),
                     "an edge that is not parallel to edge0 " + to_text(p.edge0));
}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Cylinder& c) {
    if (!fine(at / "from", at / "to")) return;
    // relative to the coordinates: closer than their rounding is the same point
    const double scale = std::max(length(c.from), length(c.to));
    const double axis = length(c.to - c.from);
    if (axis < 1e-30 || axis < 1e-14 * scale)
        report.error(at / "to", "cylinder without length", to_text(c.to), "a point away from its other end");
}

// ---- what goes with which shape ------------------------------------------------------------------------------------

template <class T>
constexpr bool can_carry_texture =
    !std::is_same_v<T, Triangle> && !std::is_same_v<T, Disc> && !std::is_same_v<T, SphereSet>;

bool is_textured_badly(const Shape& shape) {
    return std::visit([](const auto& s) { return !can_carry_texture<std::remove_cvref_t<decltype(s)>>; }, shape);
}

void check_material_of(Report& report, const ScenePath& at, const NameIndex<Material>& materials, const Body& body) {
    if (body.material.empty())
        return report.error(at / "material", "body without a material", {}, "the name of a material");
    const Material* material = materials.find(report, at / "material", body.material);
    if (material && !material->texture.empty() && is_textured_badly(body.shape))
        report.error(at / "material", "a " + shape_name(body.shape) + " cannot carry the texture of its material",
                     body.material,
                     "a material without texture; textures go on plane, rectangle, parallelogram, box, sphere and "
                     "cylinder");
}

}  // namespace

std::string shape_name(const Shape& shape) {
    return std::visit([](const auto& s) { return std::string(Fields<std::remove_cvref_t<decltype(s)>>::name); }, shape);
}

void check_bodies(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "bodies";
    check_unique_names(report, list, scene.bodies);
    const NameIndex materials(scene.materials);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        const ScenePath at = list[i];
        const FineFields fine = check_fields(report, at, body);
        std::visit([&](const auto& shape) { check_shape(report, at, fine, shape); }, body.shape);
        check_material_of(report, at, materials, body);
        if (body.motion) check_motion(report, at / "motion", *body.motion, fine);
        if (body.motion && std::holds_alternative<SphereSet>(body.shape))
            report.error(at / "motion", "a sphere_set cannot move", {}, "single spheres");
        if (body.physics) check_physics(report, at, scene, body, fine);
    }
    check_masses(report, scene);
    if (scene.bodies.empty()) report.warning(list, "the scene has no bodies: every pixel shows the background");
}

}  // namespace drt
