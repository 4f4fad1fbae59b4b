#include "formats/random_scene.h"

#include <cmath>
#include <random>

#include "drt/scene/scene_fields.h"

namespace drt {
namespace {

// Walks the tables of fields, so that a field that is added is filled without a change here.
class Filler {
public:
    explicit Filler(std::uint32_t seed) : random_(seed) {}

    bool chance(double p) { return unit() < p; }
    int below(int n) { return int(random_() % unsigned(n)); }
    double unit() { return double(random_()) / 4294967296.0; }

    template <HasFields T>
    void fill(const FieldInfo&, T& object) {
        for_each_field<T>([&](const auto& entry) { entry_of(object, entry); });
    }

    void fill(const FieldInfo& info, double& v) {
        const Range& r = info.range;
        const double low = std::isfinite(r.low) ? r.low : -1e3;
        const double high = std::isfinite(r.high) ? r.high : low + std::pow(10.0, 6 * unit());
        do v = chance(0.3) ? std::round(low + (high - low) * unit()) : low + (high - low) * unit();
        while (!r.contains(v));
    }
    void fill(const FieldInfo& info, int& v) {
        const double high = std::min(info.range.high, 1e4);
        v = int(info.range.low + std::floor((high - info.range.low) * unit()));
    }
    void fill(const FieldInfo&, std::uint32_t& v) { v = std::uint32_t(random_()); }
    void fill(const FieldInfo&, bool& v) { v = chance(0.5); }
    void fill(const FieldInfo& info, Vec3d& v) {
        fill(info, v.x);
        fill(info, v.y);
        fill(info, v.z);
    }
    void fill(const FieldInfo&, Color& c) {
        const auto channel = [&] { return chance(0.2) ? 0.0f : float(unit()); };
        c = chance(0.3) ? Color{channel()} : Color{channel(), channel(), channel()};
    }
    void fill(const FieldInfo&, Quatd& q) { q = {unit() + 0.1, unit(), -unit(), unit()}; }
    void fill(const FieldInfo& info, std::string& text) {
        // references and names are set by the caller; files are relative and normal
        if (info.role == Role::file)
            text = chance(0.5) ? "textures/wood.png" : "other place/\xc5\x99\xc3\xa1m \"1\".tga";
    }
    template <IsEnum E>
    void fill(const FieldInfo&, E& e) {
        e = E(below(int(EnumNames<E>::names.size())));
    }
    template <class V>
    void fill(const FieldInfo& info, std::optional<V>& v) {
        fill(info, v.emplace());
    }
    template <class V>
    void fill(const FieldInfo& info, std::vector<V>& list) {
        list.resize(std::size_t(below(4)));
        for (V& item : list) fill(info, item);
    }

private:
    template <class T, class M>
    void entry_of(T& object, const Field<T, M>& f) {
        if (f.info.presence != Presence::optional || !chance(0.35)) fill(f.info, object.*f.member);
    }
    template <class T, class Start, class End>
    void entry_of(T& object, const StartEnd<T, Start, End>& f) {
        if (chance(0.6)) fill(f.info, object.*f.start);
        if (chance(0.4)) fill(f.info, object.*f.end);
        if (chance(0.1)) object.*f.end = object.*f.start;  // not the same as an absent end
    }
    template <class T, class V>
    void entry_of(T& object, const OneOrMore<T, V>& f) {
        if (chance(0.3)) return;
        (object.*f.member).resize(std::size_t(1 + below(3)));
        for (V& item : object.*f.member) fill(f.info, item);
    }
    template <class T, class Variant>
    void entry_of(T& object, const Alternatives<T, Variant>& f) {
        int skip = below(int(std::variant_size_v<Variant>));
        for_each_alternative<Variant>([&]<class A>() {
            if (skip-- == 0) fill(f.info, (object.*f.member).template emplace<A>());
        });
    }

    std::mt19937 random_;
};

std::string name_of(Filler& filler, const char* kind, std::size_t i) {
    static const char* const odd[] = {"null",
                                      "true",
                                      "1",
                                      "-",
                                      "a: b",
                                      "#red",
                                      "\"quoted\" \\",
                                      "it's",
                                      " blank ",
                                      "line\nbreak\ttab",
                                      "\x01",
                                      "m\xc3\xad\xc4\x8d",
                                      "~",
                                      "[x]",
                                      "&a",
                                      "*a",
                                      "<<",
                                      "\xe2\x80\xa8",
                                      "\xc2\x85",
                                      "\xf0\x9f\x98\x80",
                                      "1e5",
                                      "no",
                                      "%",
                                      "@",
                                      "`"};
    const std::string number = std::to_string(i);
    if (filler.chance(0.5)) return kind + number;
    return odd[filler.below(int(std::size(odd)))] + std::string(i, '.') + kind;
}

void fill_motion(Motion& motion) {
    if (motion.keys.empty()) motion.keys.resize(1);
    for (std::size_t i = 0; i < motion.keys.size(); ++i) motion.keys[i].time = -3 + 0.7 * double(i);
    motion.keys[0].turn.reset();
    for (MotionKey& key : motion.keys)
        if (key.turn) key.orientation.reset();
}

void make_valid(Filler& filler, Body& body) {
    PhysicsDesc& physics = *body.physics;
    using Kind = PhysicsDesc::Kind;
    const bool is_solid = std::holds_alternative<Sphere>(body.shape) || std::holds_alternative<Box>(body.shape) ||
                          std::holds_alternative<Cylinder>(body.shape);
    if (physics.kind == Kind::dynamic && !is_solid) physics.kind = Kind::kinematic;
    if (std::holds_alternative<Plane>(body.shape)) physics.kind = Kind::fixed;
    if (physics.kind != Kind::kinematic) body.motion.reset();
    if (physics.mass && physics.density) (filler.chance(0.5) ? physics.mass : physics.density).reset();
    for (ForceEvent& force : physics.forces) force.until = force.from + 0.1 + 10 * filler.unit();
}

void make_valid(Filler& filler, SceneDesc& scene) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i) scene.textures[i].name = name_of(filler, "t", i);
    if (scene.materials.empty()) scene.materials.resize(1);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) scene.materials[i].name = name_of(filler, "m", i);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        Body& body = scene.bodies[i];
        if (filler.chance(0.7)) body.name = name_of(filler, "b", i);
        const auto material = std::size_t(filler.below(int(scene.materials.size())));
        body.material = scene.materials[material].name;
        const bool is_set = std::holds_alternative<SphereSet>(body.shape);
        const bool can_carry =
            !is_set && !std::holds_alternative<Triangle>(body.shape) && !std::holds_alternative<Disc>(body.shape);
        if (!scene.textures.empty() && can_carry && scene.bodies.size() == 1)
            scene.materials[material].texture = scene.textures.back().name;
        if (is_set) body.motion.reset(), body.physics.reset();
        if (body.motion) fill_motion(*body.motion);
        if (body.physics) make_valid(filler, body);
    }
    if (scene.simulation.end) scene.simulation.end = scene.simulation.start + 0.1 + 10 * filler.unit();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        Light& light = scene.lights[i];
        if (filler.chance(0.7)) light.name = name_of(filler, "l", i);
        if (light.falloff == Light::Falloff::none || std::holds_alternative<PointLight>(light.shape))
            light.visible = false;
    }
    if (scene.cameras.empty()) scene.cameras.resize(1);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        Camera& camera = scene.cameras[i];
        if (filler.chance(0.7)) camera.name = name_of(filler, "c", i);
        if (camera.video_end || camera.positions.size() + camera.targets.size() > 2)
            camera.video_end = camera.video_start + 1 + 10 * filler.unit();
        if (camera.motion) fill_motion(*camera.motion);
    }
}

}  // namespace

SceneDesc random_scene(std::uint32_t seed) {
    Filler filler(seed);
    SceneDesc scene;
    filler.fill({}, scene);
    make_valid(filler, scene);
    return scene;
}

}  // namespace drt
