#include "drt/render/unseen_light.h"

#include <algorithm>

namespace drt {

double unseen_brightness(const Sights& sights, const SourceHits& hits, int spp) {
    double brightest = sights.glow;
    for (const VisibleSource& s : sights.sources) {
        const size_t bin = SourceHits::bin(s.radiance);
        const bool direct_known = s.pixels * spp >= double(enough_hits) || hits.direct[bin] >= enough_hits;
        const bool scattered_known = !sights.by_scattering || hits.scattered[bin] >= enough_hits;
        if (!direct_known || !scattered_known) brightest = std::max(brightest, s.radiance * sights.gain);
    }
    return brightest;
}

}  // namespace drt
