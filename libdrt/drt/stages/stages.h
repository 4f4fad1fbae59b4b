#pragma once
// The stages. Those that come in variants are chosen by a function of the features.

#include "drt/stages/stage.h"

namespace drt {

template <class Real>
using StageFunction = void (*)(StageContext<Real>&);

/// Camera rays for every pixel and sample of the batch.
template <class Real>
StageFunction<Real> generate_stage(const Features&);

/// Nearest hits.
template <class Real>
void intersect_stage(StageContext<Real>&);

/// Surface points: position, facing normal, material, texture colour.
template <class Real>
StageFunction<Real> surface_stage(const Features&);

/// Light that the hit itself sends back: background, visible lights, the ambient term.
template <class Real>
StageFunction<Real> emit_stage(const Features&);

/// Light from the light sources: sample, test visibility, shade.
template <class Real>
StageFunction<Real> light_stage(const Features&);

/// Reflected and refracted rays; compacts the batch to the paths that go on.
template <class Real>
StageFunction<Real> scatter_stage(const Features&);

/// Ends every path: takes scatter's place when nothing reflects or refracts.
template <class Real>
void end_stage(StageContext<Real>&);

/// Adds the finished samples to the film.
template <class Real>
void splat_stage(StageContext<Real>&);

}  // namespace drt
