#pragma once
// Elements of a legacy scene -> SceneDesc. What each means and every assumption: docs/legacy-format.md, model.md 3-7.

#include <optional>
#include <string>
#include <vector>

#include "drt/formats/formats.h"
#include "drt/formats/legacy_element.h"
#include "drt/formats/legacy_names.h"

namespace drt {

/// A sample count of 0 turns an effect off for the whole scene.
struct LegacyEffects {
    bool blur = false, lens = false, soft_shadows = false, glossy_reflection = false, glossy_refraction = false;
};

struct LegacyMapping {
    const std::vector<LegacyElement>& elements;
    const LegacyOptions& options;
    LegacyReport& report;
    std::string directory;  ///< of the scene file, "" for the working directory
    LegacyNames names;      ///< of the elements in SceneDesc, by index
    LegacyEffects effects;
    SceneDesc scene;

    /// Records where `path` of the SceneDesc was written.
    void mark(const std::string& path, LegacyPlace place) { scene.sources.places[path] = report.location(place); }
    /// Of what an attribute says, and its name. One that was not given is at its element, which SourceMap finds by
    /// itself.
    void mark(const std::string& path, const LegacyElement& e, std::string_view attribute) {
        if (!path.ends_with('.' + std::string(attribute))) scene.sources.set_name(path, attribute);
        if (e.given(attribute)) mark(path, e.value(attribute).place);
        if (e.value(attribute).unread) scene.sources.unread.insert(path);
    }
};

// Each maps its elements in the order of the file and reports what it assumed. Settings come first: the others obey
// its effects.
void map_legacy_settings(LegacyMapping&);
void map_legacy_cameras(LegacyMapping&);
void map_legacy_materials(LegacyMapping&);
void map_legacy_bodies(LegacyMapping&);
void map_legacy_lights(LegacyMapping&);

/// The box over a base rectangle: vertex0-vertex1 is one edge, the opposite one passes through vertex2, and `height`
/// goes along (vertex2 - vertex0) x (vertex1 - vertex0), a negative one the other way. The box's local axes are the
/// edge, the height and the other edge. Empty when the base has no area or is larger than a scene may be.
std::optional<Box> box_from_base(const Vec3d& vertex0, const Vec3d& vertex1, const Vec3d& vertex2, double height);

}  // namespace drt
