#pragma once
// The media that a ray is inside of. Where they overlap, one owns the place, and the surfaces of the others are not
// there.

#include "reference/world.h"

namespace drt::reference {

/// The transparent bodies that a ray is inside of, in any order.
using Media = std::vector<const WorldBody*>;

/// Null: vacuum.
const WorldBody* owner_of(const Media&);

/// Does the surface of this body exist for a ray in these media that enters (or leaves) it?
bool exists(const Media&, const WorldBody&, bool entering);

/// Past the body's surface.
Media beyond(const Media&, const WorldBody&, bool entering);

/// All media at a point.
Media media_at(const Instant&, const Vec3d&);

}  // namespace drt::reference
