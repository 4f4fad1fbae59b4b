#pragma once
// The Phong materials of a frame, one array per parameter, so that lanes gather by material id.

#include <array>
#include <vector>

#include "drt/base/color.h"
#include "drt/sampling/lobe.h"

namespace drt {

struct ColorColumn {
    std::vector<float> r, g, b;
    void push_back(const Color& c) {
        r.push_back(c.r);
        g.push_back(c.g);
        b.push_back(c.b);
    }
};

inline constexpr int sharp = -1;  ///< lobe id of a perfectly sharp reflection or refraction
inline constexpr int no_texture = -1;

struct MaterialTable {
    ColorColumn ambient;  ///< already scaled by the scene's ambient light
    ColorColumn diffuse, specular;
    std::vector<float> shininess;
    std::vector<float> reflectance, refraction, refraction_index;
    std::vector<int> reflection_lobe, refraction_lobe;  ///< index in `lobes`, or `sharp`
    std::vector<int> texture;                           ///< or no_texture
    std::vector<float> inv_scale_u, inv_scale_v;
    LobeTables lobes;
    Color ambient_light;  ///< what a texture's colour is scaled by, for the ambient term
};

template <class F, class I>
[[gnu::always_inline]] inline Color3<F> gather_color(const ColorColumn& c, const I& id) {
    return {gather_coherent<F>(c.r.data(), id), gather_coherent<F>(c.g.data(), id), gather_coherent<F>(c.b.data(), id)};
}

}  // namespace drt
