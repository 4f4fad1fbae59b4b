#pragma once
// The table of every key of a scene: key, member, unit, range, meaning. See fields.h for who walks it.

#include <array>

#include "drt/scene/fields.h"
#include "drt/scene/scene_desc.h"

namespace drt {

// ---- names of enum values ------------------------------------------------------------------------------------------

template <>
struct EnumNames<Motion::Interpolation> {
    static constexpr std::array<std::string_view, 2> names{"linear", "cubic"};
};
template <>
struct EnumNames<PhysicsDesc::Kind> {
    static constexpr std::array<std::string_view, 3> names{"dynamic", "static", "kinematic"};
};
template <>
struct EnumNames<Texture::ColorSpace> {
    static constexpr std::array<std::string_view, 3> names{"automatic", "srgb", "linear"};
};
template <>
struct EnumNames<SphereLight::Distribution> {
    static constexpr std::array<std::string_view, 2> names{"uniform", "radial"};
};
template <>
struct EnumNames<Light::Falloff> {
    static constexpr std::array<std::string_view, 2> names{"none", "inverse_square"};
};
template <>
struct EnumNames<Lens::Distribution> {
    static constexpr std::array<std::string_view, 2> names{"uniform", "radial"};
};
template <>
struct EnumNames<Lens::FocusSurface> {
    static constexpr std::array<std::string_view, 2> names{"plane", "sphere"};
};
template <>
struct EnumNames<Camera::Zoom> {
    static constexpr std::array<std::string_view, 3> names{"angle", "image_width", "focal_length"};
};
template <>
struct EnumNames<Filter::Kind> {
    static constexpr std::array<std::string_view, 6> names{"point",           "box",     "triangle", "gaussian",
                                                           "blackman_harris", "mitchell"};
};

// ---- motion --------------------------------------------------------------------------------------------------------

template <>
struct Fields<Turn> {
    static constexpr std::string_view name = "turn";
    static constexpr std::string_view doc = "A turn of any size about a world axis: 350 or 720 degrees mean just that.";
    static constexpr auto table = std::tuple{
        field("axis", &Turn::axis, "", ranges::any, "world axis", Role::direction),
        field("degrees", &Turn::degrees, "degrees", ranges::any, "right-handed about the axis; any size"),
    };
};

template <>
struct Fields<MotionKey> {
    static constexpr std::string_view name = "motion key";
    static constexpr std::string_view doc = "Where the body or camera is at one time.";
    static constexpr auto table = std::tuple{
        required(field("time", &MotionKey::time, "s", ranges::any, "scene time; ascending from key to key")),
        required_in_first(field("position", &MotionKey::position, "length", ranges::any,
                                "where the body's centre (the camera's eye) is")),
        implicit("`[1, 0, 0, 0]`",
                 field("orientation", &MotionKey::orientation, "", ranges::any,
                       "turn from the described pose about the centre; absolute; between keys the short way")),
        implicit("none", field("turn", &MotionKey::turn, "", ranges::any,
                               "in place of orientation, not in the first key: the previous key's orientation followed "
                               "by this turn, uniform in between")),
    };
};

template <>
struct Fields<Motion> {
    static constexpr std::string_view name = "motion";
    static constexpr std::string_view doc =
        "A path through keys. Before the first and after the last key the pose is constant.";
    static constexpr auto table = std::tuple{
        field("interpolation", &Motion::interpolation, "", ranges::any,
              "of positions: straight, or a C1 cubic (Catmull-Rom with non-uniform times)"),
        required(field("keys", &Motion::keys, "", ranges::any, "at least one")),
    };
};

// ---- shapes --------------------------------------------------------------------------------------------------------

template <>
struct Fields<Plane> {
    static constexpr std::string_view name = "plane";
    static constexpr std::string_view doc = "An infinite plane. Centre: `position`.";
    static constexpr auto table = std::tuple{
        field("position", &Plane::position, "length", ranges::any, "a point of the plane; origin of its texture"),
        field("normal", &Plane::normal, "", ranges::any, "any length", Role::direction),
    };
};

template <>
struct Fields<Sphere> {
    static constexpr std::string_view name = "sphere";
    static constexpr std::string_view doc = "A ball. Centre: `center`.";
    static constexpr auto table = std::tuple{
        field("center", &Sphere::center, "length", ranges::any, "centre"),
        field("radius", &Sphere::radius, "length", ranges::positive, "radius"),
        field("pole", &Sphere::pole, "", ranges::any, "texture axis: where the texture's top row is", Role::direction),
        field("meridian", &Sphere::meridian, "", ranges::any,
              "the texture's column u = 0 faces this way; not parallel to the pole", Role::direction),
    };
};

template <>
struct Fields<Triangle> {
    static constexpr std::string_view name = "triangle";
    static constexpr std::string_view doc = "A triangle, seen from both sides. Centre: its centroid.";
    static constexpr auto table = std::tuple{
        field("vertex0", &Triangle::vertex0, "length", ranges::any, "corner"),
        field("vertex1", &Triangle::vertex1, "length", ranges::any, "corner"),
        field("vertex2", &Triangle::vertex2, "length", ranges::any, "corner"),
    };
};

template <>
struct Fields<Rectangle> {
    static constexpr std::string_view name = "rectangle";
    static constexpr std::string_view doc =
        "A rectangle by one edge and a point that the opposite edge passes through. Centre: its midpoint.";
    static constexpr auto table = std::tuple{
        field("vertex0", &Rectangle::vertex0, "length", ranges::any, "corner; origin of the texture"),
        field("vertex1", &Rectangle::vertex1, "length", ranges::any, "vertex0 to vertex1 is one edge"),
        field("vertex2", &Rectangle::vertex2, "length", ranges::any,
              "a point of the opposite edge's line: the other edge is the part of vertex2 - vertex0 that is "
              "perpendicular to the first"),
    };
};

template <>
struct Fields<Parallelogram> {
    static constexpr std::string_view name = "parallelogram";
    static constexpr std::string_view doc = "A parallelogram by a corner and two edges. Centre: its midpoint.";
    static constexpr auto table = std::tuple{
        field("corner", &Parallelogram::corner, "length", ranges::any, "corner; origin of the texture"),
        field("edge0", &Parallelogram::edge0, "length", ranges::any, "edge from the corner", Role::direction),
        field("edge1", &Parallelogram::edge1, "length", ranges::any, "other edge from the corner", Role::direction),
    };
};

template <>
struct Fields<Box> {
    static constexpr std::string_view name = "box";
    static constexpr std::string_view doc = "A box in any orientation. Centre: `center`.";
    static constexpr auto table = std::tuple{
        field("center", &Box::center, "length", ranges::any, "centre"),
        field("size", &Box::size, "length", ranges::positive, "full size along the box's own axes"),
        field("orientation", &Box::orientation, "", ranges::any, "turn about the centre"),
    };
};

template <>
struct Fields<Cylinder> {
    static constexpr std::string_view name = "cylinder";
    static constexpr std::string_view doc = "A round cylinder. Centre: the midpoint of its axis.";
    static constexpr auto table = std::tuple{
        field("from", &Cylinder::from, "length", ranges::any, "one end of the axis"),
        field("to", &Cylinder::to, "length", ranges::any, "the other end"),
        field("radius", &Cylinder::radius, "length", ranges::positive, "radius"),
        field("capped", &Cylinder::capped, "", ranges::any, "closed by discs at both ends, or an open tube"),
    };
};

template <>
struct Fields<Disc> {
    static constexpr std::string_view name = "disc";
    static constexpr std::string_view doc = "A flat disc, seen from both sides. Centre: `center`.";
    static constexpr auto table = std::tuple{
        field("center", &Disc::center, "length", ranges::any, "centre"),
        field("normal", &Disc::normal, "", ranges::any, "any length", Role::direction),
        field("radius", &Disc::radius, "length", ranges::positive, "radius"),
    };
};

template <>
struct Fields<SphereSet> {
    static constexpr std::string_view name = "sphere_set";
    static constexpr std::string_view doc =
        "Very many balls of one material, from a text file. Cannot move, fall or carry a texture.";
    static constexpr auto table = std::tuple{
        required(
            field("file", &SphereSet::file, "", ranges::any, "text file, `x y z radius` on each line", Role::file)),
    };
};

// ---- physics and bodies --------------------------------------------------------------------------------------------

template <>
struct Fields<ImpulseEvent> {
    static constexpr std::string_view name = "impulse";
    static constexpr std::string_view doc = "A blow: changes a dynamic body's momentum at once.";
    static constexpr auto table = std::tuple{
        required(field("time", &ImpulseEvent::time, "s", ranges::any, "scene time")),
        required(field("impulse", &ImpulseEvent::impulse, "mass length / s", ranges::any, "direction and size")),
        implicit("the centre", field("at", &ImpulseEvent::at, "length", ranges::any,
                                     "point that is struck, from the body's centre along the world's axes; off the "
                                     "centre, the blow also turns the body")),
    };
};

template <>
struct Fields<ForceEvent> {
    static constexpr std::string_view name = "force";
    static constexpr std::string_view doc = "A constant force at a dynamic body's centre for a while.";
    static constexpr auto table = std::tuple{
        required(field("from", &ForceEvent::from, "s", ranges::any, "scene time")),
        required(field("until", &ForceEvent::until, "s", ranges::any, "scene time; after `from`")),
        required(field("force", &ForceEvent::force, "mass length / s^2", ranges::any, "direction and size")),
    };
};

template <>
struct Fields<PhysicsDesc> {
    static constexpr std::string_view name = "physics";
    static constexpr std::string_view doc = "The body takes part in the simulation.";
    static constexpr auto table = std::tuple{
        field("kind", &PhysicsDesc::kind, "", ranges::any,
              "dynamic: falls and collides; static: only stands in the way; kinematic: follows its motion and pushes "
              "others"),
        implicit("by the density", field("mass", &PhysicsDesc::mass, "mass", ranges::positive, "of a dynamic body")),
        implicit("1, unless there is a mass", field("density", &PhysicsDesc::density, "mass / length^3",
                                                    ranges::positive, "of a dynamic body, in place of a mass")),
        field("friction", &PhysicsDesc::friction, "", ranges::not_negative,
              "Coulomb's coefficient; of two bodies in contact the geometric mean counts"),
        field("rolling_friction", &PhysicsDesc::rolling_friction, "", ranges::not_negative,
              "rolling resistance: torque / (normal force * radius); of two bodies the larger counts"),
        field("restitution", &PhysicsDesc::restitution, "", ranges::unit,
              "speed after an impact / speed before; of two bodies the larger counts"),
        field("velocity", &PhysicsDesc::velocity, "length / s", ranges::any, "of the centre at the simulation's start"),
        field("angular_velocity_degrees", &PhysicsDesc::angular_velocity_degrees, "degrees / s", ranges::any,
              "at the simulation's start: world axis times speed, right-handed"),
        field("impulses", &PhysicsDesc::impulses, "", ranges::any, "blows"),
        field("forces", &PhysicsDesc::forces, "", ranges::any, "forces for a while"),
    };
};

/// Seconds, in size: twelve days. Beyond, time has too few digits left for the moments of impacts.
inline constexpr double latest_simulated = 1e6;

template <>
struct Fields<SimulationSettings> {
    static constexpr std::string_view name = "simulation";
    static constexpr std::string_view doc = "How the motion of dynamic bodies is computed.";
    static constexpr auto table = std::tuple{
        field("start", &SimulationSettings::start, "s", Range{.low = -latest_simulated, .high = latest_simulated},
              "scene time at which the bodies are as described; before it they do not move"),
        implicit("the latest that is shown",
                 field("end", &SimulationSettings::end, "s", Range{.low = -latest_simulated, .high = latest_simulated},
                       "scene time; after `start`")),
        implicit("as `tolerance_pixels`", field("tolerance", &SimulationSettings::tolerance, "length", ranges::positive,
                                                "error that positions may have")),
        field("tolerance_pixels", &SimulationSettings::tolerance_pixels, "pixels", ranges::positive,
              "the same as seen in the picture; without effect beside `tolerance`"),
    };
};

template <>
struct Fields<Body> {
    static constexpr std::string_view name = "body";
    static constexpr std::string_view doc = "A thing to be seen. The keys of its shape stand beside these.";
    static constexpr auto table = std::tuple{
        field("name", &Body::name, "", ranges::any, "for messages and tools; unique among the bodies", Role::name),
        alternatives("type", &Body::shape, "the shape"),
        required(field("material", &Body::material, "", ranges::any, "what it is made of", Role::material)),
        field("priority", &Body::priority, "", Range{.low = -1000, .high = 1000},
              "where bodies overlap or touch, the higher one owns the place; of equal ones the smaller (planes last)"),
        implicit("at rest", field("motion", &Body::motion, "", ranges::any, "path of its centre, and its turning")),
        implicit("none", field("physics", &Body::physics, "", ranges::any, "part in the simulation")),
    };
};

// ---- materials and textures ----------------------------------------------------------------------------------------

template <>
struct Fields<Texture> {
    static constexpr std::string_view name = "texture";
    static constexpr std::string_view doc = "An image file.";
    static constexpr auto table = std::tuple{
        required(field("name", &Texture::name, "", ranges::any, "materials refer to it", Role::name)),
        required(field("file", &Texture::file, "", ranges::any, "any type that OpenImageIO reads", Role::file)),
        field("color_space", &Texture::color_space, "", ranges::any,
              "automatic: files of 8- and 16-bit integers are sRGB, of floats linear"),
    };
};

template <>
struct Fields<Material> {
    static constexpr std::string_view name = "material";
    static constexpr std::string_view doc = "Phong's model with glossy reflection and refraction.";
    static constexpr auto table = std::tuple{
        required(field("name", &Material::name, "", ranges::any, "bodies refer to it", Role::name)),
        field("ambient", &Material::ambient, "", ranges::not_negative, "factor of the scene's ambient_light"),
        field("diffuse", &Material::diffuse, "", ranges::not_negative, "factor of diffusely scattered light"),
        field("specular", &Material::specular, "", ranges::not_negative, "factor of Phong's highlight"),
        field("shininess", &Material::shininess, "", ranges::not_negative, "exponent of the highlight"),
        field("reflectance", &Material::reflectance, "", ranges::not_negative, "share of reflected light"),
        field("reflection_spread_degrees", &Material::reflection_spread_degrees, "degrees", ranges::not_negative,
              "standard deviation of the glossy lobe; 0 = perfectly sharp"),
        field("refraction", &Material::refraction, "", ranges::not_negative, "share of light that passes through"),
        field("refraction_spread_degrees", &Material::refraction_spread_degrees, "degrees", ranges::not_negative,
              "standard deviation of the glossy lobe; 0 = perfectly sharp"),
        field("refraction_index", &Material::refraction_index, "", ranges::positive, "of the inside; outside is 1"),
        implicit("none", field("texture", &Material::texture, "", ranges::any,
                               "replaces the diffuse and the ambient colour", Role::texture)),
        field("scale_u", &Material::scale_u, "length, or turns", ranges::positive,
              "planar mappings: length that one repeat covers; spheres and cylinders: part of the full turn"),
        field("scale_v", &Material::scale_v, "length, or heights", ranges::positive,
              "planar mappings: length that one repeat covers; spheres and cylinders: part of the height"),
    };
};

// ---- lights --------------------------------------------------------------------------------------------------------

template <>
struct Fields<PointLight> {
    static constexpr std::string_view name = "point";
    static constexpr std::string_view doc = "Light from a point: hard shadows.";
    static constexpr auto table = std::tuple{
        field("position", &PointLight::position, "length", ranges::any, "where it is"),
    };
};

template <>
struct Fields<RectLight> {
    static constexpr std::string_view name = "rectangle";
    static constexpr std::string_view doc = "Light from a rectangle or parallelogram.";
    static constexpr auto table = std::tuple{
        field("corner", &RectLight::corner, "length", ranges::any, "corner"),
        field("edge_x", &RectLight::edge_x, "length", ranges::any, "edge from the corner", Role::direction),
        field("edge_y", &RectLight::edge_y, "length", ranges::any, "other edge from the corner", Role::direction),
        field("two_sided", &RectLight::two_sided, "", ranges::any,
              "shines to both sides, else along cross(edge_x, edge_y); only with falloff inverse_square"),
    };
};

template <>
struct Fields<SphereLight> {
    static constexpr std::string_view name = "sphere";
    static constexpr std::string_view doc = "Light from a ball.";
    static constexpr auto table = std::tuple{
        field("center", &SphereLight::center, "length", ranges::any, "centre"),
        field("radius", &SphereLight::radius, "length", ranges::positive, "radius"),
        field("distribution", &SphereLight::distribution, "", ranges::any,
              "of the light over the ball: uniform, or denser in the middle of the disc that faces the lit point"),
    };
};

template <>
struct Fields<Light> {
    static constexpr std::string_view name = "light";
    static constexpr std::string_view doc = "A source of light. The keys of its shape stand beside these.";
    static constexpr auto table = std::tuple{
        field("name", &Light::name, "", ranges::any, "for messages and tools; unique among the lights", Role::name),
        alternatives("type", &Light::shape, "the shape"),
        field("color", &Light::color, "see falloff", ranges::not_negative, "colour and strength"),
        field("falloff", &Light::falloff, "", ranges::any,
              "inverse_square: physical, color is the radiance of an area, the radiant intensity of a point; none: the "
              "same strength at any distance"),
        field("visible", &Light::visible, "", ranges::any,
              "seen by rays, and in their way; not for points, only with falloff inverse_square"),
    };
};

// ---- cameras -------------------------------------------------------------------------------------------------------

template <>
struct Fields<Shutter> {
    static constexpr std::string_view name = "shutter";
    static constexpr std::string_view doc = "Exposure of one frame; opens at the frame's time.";
    static constexpr auto table = std::tuple{
        implicit("one frame, 1 / fps", field("duration", &Shutter::duration, "s of video", ranges::not_negative,
                                             "from opening to closed; 0 = one instant, no motion blur")),
        field("switch_ratio", &Shutter::switch_ratio, "", ranges::unit,
              "share of the duration spent opening and closing: 0 = a box, 1 = a triangle"),
    };
};

template <>
struct Fields<Lens> {
    static constexpr std::string_view name = "lens";
    static constexpr std::string_view doc = "Depth of field.";
    static constexpr auto table = std::tuple{
        field("aperture_radius", &Lens::aperture_radius, "length", ranges::not_negative, "0 = pinhole, all is sharp"),
        implicit("from eye to target", start_end("focus_distance", &Lens::focus_start, &Lens::focus_end, "length",
                                                 ranges::positive, "distance at which the picture is sharp")),
        field("distribution", &Lens::distribution, "", ranges::any,
              "of rays over the lens: uniform, or denser in the middle (radial)"),
        field("focus_surface", &Lens::focus_surface, "", ranges::any,
              "distance measured along the view axis (plane) or along each ray (sphere)"),
    };
};

template <>
struct Fields<Camera> {
    static constexpr std::string_view name = "camera";
    static constexpr std::string_view doc =
        "Records the frames whose video time lies in its interval; the first such camera of the scene does.";
    static constexpr auto table = std::tuple{
        field("name", &Camera::name, "", ranges::any, "for the command line; unique among the cameras", Role::name),
        one_or_more("position", "positions", &Camera::positions, "length",
                    "where the eye is; several: control points of a Bezier curve over the video interval"),
        one_or_more("target", "targets", &Camera::targets, "length",
                    "what it looks at; several: control points of a Bezier curve over the video interval"),
        start_end("up", &Camera::up_start, &Camera::up_end, "", ranges::any,
                  "what is up in the picture; need not be perpendicular to the view, only not parallel",
                  Role::direction),
        start_end("fov_degrees", &Camera::fov_degrees_start, &Camera::fov_degrees_end, "degrees",
                  Range{.low = 0, .high = 180, .low_open = true, .high_open = true},
                  "angle of view across the picture's width"),
        field("zoom", &Camera::zoom, "", ranges::any,
              "what goes linearly from fov_degrees' start to its end: the angle; image_width: 2 tan(angle / 2), what "
              "the picture's width spans at distance 1; focal_length: the inverse of that"),
        field("lens", &Camera::lens, "", ranges::any, "depth of field"),
        field("shutter", &Camera::shutter, "", ranges::any, "motion blur"),
        field("video_start", &Camera::video_start, "s of video", ranges::any, "records from here"),
        implicit("for ever", field("video_end", &Camera::video_end, "s of video", ranges::any,
                                   "to here: the frame at this very time is not recorded any more")),
        field("video_end_inclusive", &Camera::video_end_inclusive, "", ranges::any,
              "the frame at video_end is recorded, too, if no other camera does (as in legacy scenes)"),
        implicit("video_start",
                 field("time_start", &Camera::time_start, "s", ranges::any, "scene time shown at video_start")),
        implicit("time_start + length of the video",
                 field("time_end", &Camera::time_end, "s", ranges::any,
                       "scene time at video_end: slow, fast or (before time_start) reversed motion")),
        implicit("at rest", field("motion", &Camera::motion, "", ranges::any,
                                  "path of the eye over scene time, and turn of the view from position to target; "
                                  "replaces position")),
    };
};

// ---- the whole -----------------------------------------------------------------------------------------------------

template <>
struct Fields<Filter> {
    static constexpr std::string_view name = "filter";
    static constexpr std::string_view doc = "How a pixel gathers the light around it.";
    static constexpr auto table = std::tuple{
        field("kind", &Filter::kind, "", ranges::any, "shape; point: every ray goes through the pixel's centre"),
        field("radius", &Filter::radius, "pixels", Range{.low = 0, .high = 32, .low_open = true},
              "where it is cut off; point ignores it"),
        field("sigma", &Filter::sigma, "pixels", Range{.low = 0, .high = 32, .low_open = true},
              "standard deviation; gaussian only"),
    };
};

inline constexpr int largest_image_side = 65536;
inline constexpr int largest_depth = 10000;
inline constexpr int largest_spp = 1 << 24;
inline constexpr std::int64_t largest_image_pixels = std::int64_t(1) << 28;

template <>
struct Fields<RenderSettings> {
    static constexpr std::string_view name = "render";
    static constexpr std::string_view doc = "The picture; drt-render's options override these.";
    static constexpr auto table = std::tuple{
        field("width", &RenderSettings::width, "pixels", Range{.low = 1, .high = largest_image_side},
              "at most 2^28 pixels in all"),
        field("height", &RenderSettings::height, "pixels", Range{.low = 1, .high = largest_image_side},
              "at most 2^28 pixels in all"),
        field("fps", &RenderSettings::fps, "1 / s", ranges::positive, "frame k shows video time k / fps"),
        field("spp", &RenderSettings::spp, "", Range{.low = 1, .high = largest_spp}, "samples per pixel"),
        field("seed", &RenderSettings::seed, "", ranges::any, "another seed, other noise"),
        field("max_depth", &RenderSettings::max_depth, "", Range{.low = 0, .high = largest_depth},
              "reflections and refractions in a row; 0 = none"),
        field("filter", &RenderSettings::filter, "", ranges::any, "pixel filter"),
        field("transparent_background", &RenderSettings::transparent_background, "", ranges::any,
              "the camera does not see the background: colour and alpha are 0 there; mirrors and glass show it"),
    };
};

template <>
struct Fields<SceneDesc> {
    static constexpr std::string_view name = "scene";
    static constexpr std::string_view doc = "The file.";
    static constexpr auto table = std::tuple{
        field("render", &SceneDesc::render, "", ranges::any, "the picture"),
        field("ambient_light", &SceneDesc::ambient_light, "", ranges::not_negative,
              "light that is everywhere, scaled by the materials' ambient"),
        field("background", &SceneDesc::background, "radiance", ranges::not_negative, "where a ray hits nothing"),
        field("units", &SceneDesc::units, "length / m", ranges::positive, "scene units in a metre, for physics"),
        implicit("`[0, -9.81 units, 0]`",
                 field("gravity", &SceneDesc::gravity, "length / s^2", ranges::any, "acceleration, for physics")),
        field("simulation", &SceneDesc::simulation, "", ranges::any, "how physics is computed"),
        field("textures", &SceneDesc::textures, "", ranges::any, "image files"),
        field("materials", &SceneDesc::materials, "", ranges::any, "materials"),
        field("bodies", &SceneDesc::bodies, "", ranges::any, "what there is to see"),
        field("lights", &SceneDesc::lights, "", ranges::any, "what lights it"),
        field("cameras", &SceneDesc::cameras, "", ranges::any, "at least one"),
    };
};

}  // namespace drt
