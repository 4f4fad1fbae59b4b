#pragma once
// Conventions, stated once.
//
// - Right-handed coordinates; lengths in scene units, time in seconds, angles in radians inside the library.
//   SceneDesc keeps what the user wrote: names that end in _degrees hold degrees.
// - Colours are linear Rec. 709 RGB, unbounded.
// - `wo` and `wi` are unit vectors that point AWAY from the surface (to the viewer, to the light or next hit).
//   A ray's direction points along travel, so wo = -ray.d at a hit.
// - `ng` is the geometric normal: outward for closed bodies. The shading side is the one the ray comes from.
// - A pdf is in solid angle unless its name or comment states another measure.
// - Ray time and shutter time are in [0, 1] across the exposure; scene time is in seconds.
// - Image x runs right, y runs down, pixel (0, 0) is the upper left one; pixel centres are at +0.5.
// - A body is a rigid thing; a primitive is what the accelerator tests. Ids are 32-bit indices, -1 is "none".
