#include "drt/light/light_choice.h"

#include "drt/light/light_tree_build.h"

namespace drt {
namespace {

// `visit(id, light)`, kind by kind.
template <class Visit>
void for_each_light(const LightTable<double>& t, Visit visit) {
    const auto all = [&](LightKind kind, const auto& lights) {
        for (size_t i = 0; i < lights.size(); ++i) visit(light_id::pack(kind, i), lights[i]);
    };
    all(LightKind::point, t.points);
    all(LightKind::rect, t.rects);
    all(LightKind::sphere, t.spheres);
}

}  // namespace

void plan_light_choice(LightTable<double>& t) {
    int physical = 0;
    for_each_light(t, [&](LightId, const auto& l) { physical += l.inverse_square ? 1 : 0; });
    const bool few_physical = physical <= few_lights, few_plain = t.count() - physical <= few_lights;
    std::vector<BoundedLight> bounded;
    std::vector<double> power;
    for_each_light(t, [&](LightId id, const auto& l) {
        if (l.inverse_square ? few_physical : few_plain) {
            t.asked.push_back(id);
        } else if (l.inverse_square) {
            bounded.push_back({bounds_of(l), id});
        } else {
            t.plain.lights.push_back(id);
            power.push_back(strength(l));
        }
    });
    t.tree = build_light_tree(bounded);
    if (!power.empty()) t.plain.by_power = make_distribution(power);
}

}  // namespace drt
