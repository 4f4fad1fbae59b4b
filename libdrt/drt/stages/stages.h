#pragma once
// The stages. What a scene does not use inside a stage is skipped by branches on World::features, the same for every
// packet of a frame.

#include "drt/stages/stage.h"

namespace drt {

/// Camera rays for every pixel and sample of the batch.
template <class Real>
void generate_stage(StageContext<Real>&);

/// The media in which camera rays begin: of scenes whose eye may be inside a body that refracts.
template <class Real>
void eye_media_stage(StageContext<Real>&);

/// Nearest hits, through the surfaces that do not exist because another medium owns the place.
template <class Real>
void intersect_stage(StageContext<Real>&);

/// Surface points: position, facing normal, material, texture colour.
template <class Real>
void surface_stage(StageContext<Real>&);

/// Light that the hit itself sends back: background, visible lights, the ambient term.
template <class Real>
void emit_stage(StageContext<Real>&);

/// Light from the light sources: sample, test visibility, shade.
template <class Real>
void light_stage(StageContext<Real>&);

/// Reflected and refracted rays; compacts the batch to the paths that go on.
template <class Real>
void scatter_stage(StageContext<Real>&);

/// Ends every path: takes scatter's place when nothing reflects or refracts.
template <class Real>
void end_stage(StageContext<Real>&);

/// Adds the finished samples to the film.
template <class Real>
void splat_stage(StageContext<Real>&);

}  // namespace drt
