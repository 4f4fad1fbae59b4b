#pragma once
// SceneDesc: what the user wrote, as plain values. Nothing here is derived, resolved or optimised; that is the
// plan's work. Every default is the documented default of docs/scene-format.md.
//
// Units: lengths in scene units, time in seconds, angles in degrees where the name says so, linear RGB colours.
// An empty std::optional means "implicit": the comment beside it says what then holds.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <variant>
#include <vector>

#include "drt/base/color.h"
#include "drt/base/diagnostic.h"
#include "drt/base/quat.h"
#include "drt/base/vec.h"

namespace drt {

// ---- motion ----------------------------------------------------------------------------------------------------

/// A turn of any size about an axis: 350 or 720 degrees mean just that.
struct Turn {
    Vec3d axis{0, 1, 0};  ///< world axis, any length but zero
    double degrees = 0;
    friend bool operator==(const Turn&, const Turn&) = default;
};

struct MotionKey {
    double time = 0;  ///< scene time
    Vec3d position;   ///< where the body's centre (the camera's eye) is
    /// Turn from the described pose, about the centre; absolute, of any length. Slerp from the previous key, the short
    /// way. Implicit, without a turn: none.
    std::optional<Quatd> orientation;
    /// In place of an orientation: that of this key is the previous key's followed by this turn, and the body turns
    /// uniformly about this axis in between, however far.
    std::optional<Turn> turn;
    friend bool operator==(const MotionKey&, const MotionKey&) = default;
};

/// Of a key without a turn; a unit quaternion.
inline Quatd orientation_of(const MotionKey& k) { return normalize(k.orientation.value_or(Quatd{})); }

/// Keys in ascending time, at least one. Before the first and after the last key the pose is constant.
struct Motion {
    /// cubic: C1 Hermite through the positions with finite-difference (Catmull-Rom, non-uniform) tangents, one-sided
    /// at the ends. Orientation is interpolated by slerp either way.
    enum class Interpolation { linear, cubic };
    Interpolation interpolation = Interpolation::linear;
    std::vector<MotionKey> keys;
    friend bool operator==(const Motion&, const Motion&) = default;
};

// ---- bodies ----------------------------------------------------------------------------------------------------
// "Centre" of a body, about which motion turns it: plane: position; sphere, box, disc: centre; triangle: centroid;
// rectangle, parallelogram: midpoint; cylinder: midpoint of the axis.

struct Plane {  ///< infinite
    Vec3d position;
    Vec3d normal{0, 1, 0};  ///< any length but zero
    friend bool operator==(const Plane&, const Plane&) = default;
};

struct Sphere {
    Vec3d center;
    double radius = 1;
    Vec3d pole{0, 1, 0};      ///< texture axis (legacy v_e), where the texture's top row is
    Vec3d meridian{0, 0, 1};  ///< zero meridian (legacy v_n): texture column u = 0 faces this way. Need not be
                              ///< perpendicular to the pole, only not parallel.
    friend bool operator==(const Sphere&, const Sphere&) = default;
};

struct Triangle {
    Vec3d vertex0, vertex1{1, 0, 0}, vertex2{0, 1, 0};
    friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// vertex0-vertex1 is one edge; vertex2 is a point that the opposite edge passes through. The other edge is the part
/// of vertex2 - vertex0 that is perpendicular to the first.
struct Rectangle {
    Vec3d vertex0, vertex1{1, 0, 0}, vertex2{0, 1, 0};
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

struct Parallelogram {
    Vec3d corner, edge0{1, 0, 0}, edge1{0, 1, 0};
    friend bool operator==(const Parallelogram&, const Parallelogram&) = default;
};

/// Axis-aligned box of full size `size` about `center`, turned by `orientation` about its centre.
struct Box {
    Vec3d center;
    Vec3d size{1, 1, 1};
    Quatd orientation;
    friend bool operator==(const Box&, const Box&) = default;
};

struct Cylinder {
    Vec3d from, to{0, 1, 0};  ///< the ends of the axis
    double radius = 1;
    bool capped = true;
    friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

struct Disc {
    Vec3d center;
    Vec3d normal{0, 1, 0};
    double radius = 1;
    friend bool operator==(const Disc&, const Disc&) = default;
};

/// Many spheres of one material from a text file: `x y z radius` on each line ('#' starts a comment). For scenes of
/// 1e5 to 1e7 balls, where one YAML mapping a ball would cost kilobytes each. Cannot move or carry a texture.
struct SphereSet {
    std::string file;  ///< absolute, or relative to the working directory (readers resolve it against their file)
    friend bool operator==(const SphereSet&, const SphereSet&) = default;
};

using Shape = std::variant<Plane, Sphere, Triangle, Rectangle, Parallelogram, Box, Cylinder, Disc, SphereSet>;

// ---- physics, as described (simulated by the dynamics room) --------------------------------------------------------

/// A blow: changes a dynamic body's momentum at once, whatever the steps of the simulation.
struct ImpulseEvent {
    double time = 0;
    Vec3d impulse;            ///< mass * length / time
    std::optional<Vec3d> at;  ///< point that is struck, from the body's centre along the world's axes; implicit: the
                              ///< centre. Off it, the blow also turns the body.
    friend bool operator==(const ImpulseEvent&, const ImpulseEvent&) = default;
};

/// A constant force at a dynamic body's centre for a while.
struct ForceEvent {
    double from = 0, until = 0;  ///< scene time
    Vec3d force;                 ///< mass * length / time^2
    friend bool operator==(const ForceEvent&, const ForceEvent&) = default;
};

struct PhysicsDesc {
    /// dynamic: moved by the simulation; fixed: stands in the way; kinematic: follows its `motion` and pushes others.
    enum class Kind { dynamic, fixed, kinematic };
    Kind kind = Kind::dynamic;
    std::optional<double> density;   ///< mass / length^3; implicit: 1 unless there is a mass
    std::optional<double> mass;      ///< instead of a density
    double friction = 0.5;           ///< Coulomb's coefficient; of two bodies the geometric mean counts
    double rolling_friction = 0;     ///< rolling resistance: torque / (normal force * radius); the larger counts
    double restitution = 0;          ///< speed after / before an impact, 0 to 1; the larger counts
    Vec3d velocity;                  ///< of the centre at the start, length / s
    Vec3d angular_velocity_degrees;  ///< at the start: axis times degrees / s, along the world's axes
    std::vector<ImpulseEvent> impulses;
    std::vector<ForceEvent> forces;
    friend bool operator==(const PhysicsDesc&, const PhysicsDesc&) = default;
};

/// How the motion of dynamic bodies is computed. It starts at scene time `start` with the bodies as described.
struct SimulationSettings {
    double start = 0;
    std::optional<double> end;        ///< scene time; implicit: the latest that a camera or a rendered frame shows
    std::optional<double> tolerance;  ///< of positions, length; implicit: what `tolerance_pixels` are in the picture
    double tolerance_pixels = 0.1;
    friend bool operator==(const SimulationSettings&, const SimulationSettings&) = default;
};

struct Body {
    std::string name;
    Shape shape;
    std::string material;
    std::optional<Motion> motion;
    std::optional<PhysicsDesc> physics;
    int priority = 0;  ///< where bodies overlap or touch, the one of higher priority owns the place
    friend bool operator==(const Body&, const Body&) = default;
};

// ---- materials and textures --------------------------------------------------------------------------------------

struct Texture {
    enum class ColorSpace { automatic, srgb, linear };  ///< automatic: 8- and 16-bit integer files sRGB, float linear
    std::string name;
    std::string file;  ///< absolute, or relative to the working directory (readers resolve it against their file)
    ColorSpace color_space = ColorSpace::automatic;
    friend bool operator==(const Texture&, const Texture&) = default;
};

/// Phong (model.md section 2). Colours scale light, scalars scale the reflected and refracted radiance.
struct Material {
    std::string name;
    Color ambient{1.0f};  ///< scaled by SceneDesc::ambient_light
    Color diffuse{0.5f};
    Color specular{0.0f};
    double shininess = 20;
    double reflectance = 0;
    double reflection_spread_degrees = 0;  ///< sigma of the glossy lobe; 0 = perfectly sharp
    double refraction = 0;                 ///< share of light that passes through
    double refraction_spread_degrees = 0;
    double refraction_index = 1.5;
    std::string texture;  ///< "" = none; else replaces the diffuse and the ambient colour
    double scale_u = 1;   ///< planar mappings: scene units covered by one texture repeat; spheres and cylinders:
    double scale_v = 1;   ///< the fraction of the full turn (of the height) that one repeat covers
    friend bool operator==(const Material&, const Material&) = default;
};

// ---- lights ------------------------------------------------------------------------------------------------------

struct PointLight {
    Vec3d position;
    friend bool operator==(const PointLight&, const PointLight&) = default;
};

struct RectLight {
    Vec3d corner, edge_x{1, 0, 0}, edge_y{0, 0, 1};
    bool two_sided = false;  ///< one-sided lights shine along cross(edge_x, edge_y); only for inverse_square
    friend bool operator==(const RectLight&, const RectLight&) = default;
};

/// The legacy "bulb".
struct SphereLight {
    /// radial: a point on the disc that faces the shaded point, its radius uniform in [0, r) (denser in the middle);
    /// uniform: uniform over the visible cone of the sphere.
    enum class Distribution { uniform, radial };
    Vec3d center;
    double radius = 1;
    Distribution distribution = Distribution::uniform;
    friend bool operator==(const SphereLight&, const SphereLight&) = default;
};

using LightShape = std::variant<PointLight, RectLight, SphereLight>;

struct Light {
    /// none: `color` is I_l of the Phong formula whatever the distance (legacy). inverse_square: physical; `color` is
    /// the radiance of a rectangle or sphere, the radiant intensity of a point, and I_l = E / pi with E the
    /// irradiance on a plane that faces the light.
    enum class Falloff { none, inverse_square };
    std::string name;
    LightShape shape;
    Color color{1.0f};
    Falloff falloff = Falloff::inverse_square;
    bool visible = false;  ///< the light is also a body that rays can hit and that blocks light (not for points,
                           ///< and only with inverse_square)
    friend bool operator==(const Light&, const Light&) = default;
};

// ---- cameras -----------------------------------------------------------------------------------------------------

struct Shutter {
    std::optional<double> duration;  ///< seconds of video time; implicit: one frame (1 / fps). 0 = one instant.
    double switch_ratio = 0;         ///< share of the duration spent opening and closing, 0 (box) to 1 (triangle)
    friend bool operator==(const Shutter&, const Shutter&) = default;
};

struct Lens {
    enum class Distribution { uniform, radial };   ///< radial: radius uniform in [0, r) (legacy)
    enum class FocusSurface { plane, sphere };     ///< sphere: distance measured along the ray (legacy)
    double aperture_radius = 0;                    ///< scene units; 0 = pinhole
    std::optional<double> focus_start, focus_end;  ///< distance; implicit start: from eye to target (1 if equal);
                                                   ///< implicit end: as the start
    Distribution distribution = Distribution::uniform;
    FocusSurface focus_surface = FocusSurface::plane;
    friend bool operator==(const Lens&, const Lens&) = default;
};

/// Start and end values go linearly over the camera's video interval; positions and targets are the control polygons
/// of one Bezier curve each over the same interval. Before and after it all of these stand still.
struct Camera {
    /// What goes linearly between two angles of view: the angle itself, the image's width 2 tan(angle / 2) at distance
    /// 1, or the distance 1 / (2 tan(angle / 2)) of an image of width 1.
    enum class Zoom { angle, image_width, focal_length };
    std::string name;
    std::vector<Vec3d> positions{Vec3d{0, 0, 5}};  ///< at least one
    std::vector<Vec3d> targets{Vec3d{0, 0, 0}};    ///< at least one
    Vec3d up_start{0, 1, 0};
    std::optional<Vec3d> up_end;            ///< implicit: as the start
    double fov_degrees_start = 45;          ///< spans the image's width
    std::optional<double> fov_degrees_end;  ///< implicit: as the start
    Zoom zoom = Zoom::angle;
    Lens lens;
    Shutter shutter;
    double video_start = 0;            ///< records video_start <= video time < video_end
    std::optional<double> video_end;   ///< implicit: for ever (then everything that goes from start to end stays at
                                       ///< its start, and lists of positions and targets must have one entry)
    bool video_end_inclusive = false;  ///< the frame at video_end, too, unless another camera records it (legacy)
    std::optional<double> time_start;  ///< scene time shown at video_start; implicit: video_start
    std::optional<double> time_end;    ///< scene time shown at video_end; implicit: time_start + the video's length
    std::optional<Motion> motion;      ///< over scene time: eye position and turn of the view; replaces `positions`,
                                       ///< and the view direction is that of positions[0] -> targets[0], turned
    friend bool operator==(const Camera&, const Camera&) = default;
};

// ---- the whole ---------------------------------------------------------------------------------------------------

struct Filter {
    enum class Kind { point, box, triangle, gaussian, blackman_harris, mitchell };
    Kind kind = Kind::blackman_harris;
    double radius = 1.5;  ///< pixels; where the filter is cut off. `point` ignores it.
    double sigma = 0.5;   ///< pixels; gaussian only
    friend bool operator==(const Filter&, const Filter&) = default;
};

struct RenderSettings {
    int width = 640, height = 480;  ///< pixels
    double fps = 25;
    int spp = 64;  ///< samples per pixel
    std::uint32_t seed = 0;
    int max_depth = 8;  ///< reflections and refractions in a row (legacy `recursion`); 0 = none
    Filter filter;
    bool transparent_background = false;  ///< colour and alpha are 0 where camera rays meet nothing
    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// Where the parts of a SceneDesc were written, keyed by path: "bodies[3]", "bodies[3].radius",
/// "cameras[0].motion.keys[2].time"; and what the file calls them. Two scenes are equal wherever they were written.
struct SourceMap {
    std::unordered_map<std::string, Location> places;
    /// Values that were written but could not be read: they are at their defaults, from which nothing follows.
    std::unordered_set<std::string> unread;
    /// The file's words for keys, where they are others than SceneDesc's; keyed by path without numbers: "v_e" at
    /// "bodies[].pole" in a legacy scene.
    std::unordered_map<std::string, std::string> names;

    /// The place of `path`, or of the nearest enclosing path that is known, or an empty Location.
    Location find(std::string path) const;
    /// The value at `path`, or something that it is part of, could not be read.
    bool is_unread(std::string path) const;
    void set_name(std::string_view path, std::string_view name);
    /// The file's word for what stands at `path` and is called `key` otherwise. Items of a list, and the start and the
    /// end of a value, go by the name of the whole if they have none of their own.
    std::string name(std::string_view path, std::string_view key) const;
    friend bool operator==(const SourceMap&, const SourceMap&) { return true; }
};

struct SceneDesc {
    RenderSettings render;
    Color ambient_light{0.0f};     ///< i_a (legacy 0.12)
    Color background{0.0f};        ///< radiance where a ray hits nothing
    double units = 1;              ///< scene units in a metre
    std::optional<Vec3d> gravity;  ///< length / s^2; implicit: the Earth's along -y, 9.81 `units`
    SimulationSettings simulation;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Body> bodies;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    SourceMap sources;
    friend bool operator==(const SceneDesc&, const SceneDesc&) = default;
};

/// Length / s^2.
inline Vec3d gravity_of(const SceneDesc& s) { return s.gravity.value_or(Vec3d{0, -9.81 * s.units, 0}); }

/// Everything wrong with a scene's values and references, located through scene.sources: non-finite or out-of-range
/// numbers, unknown references (with a suggestion), duplicate names, degenerate geometry, cameras without a view.
/// Cheap enough to run always; a scene without errors can be compiled. Files are not opened here.
Diagnostics validate(const SceneDesc&);

}  // namespace drt
