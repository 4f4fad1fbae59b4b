// The scene of full.yaml and diffuse.yaml, for POV-Ray 3.7. Parameters, given as Declare=NAME=VALUE:
//   Full       1: lens, highlights and reflection (full.yaml); 0: pinhole, diffuse bodies (diffuse.yaml)
//   Grid       each area light is sampled at Grid x Grid jittered places per shaded point; a power of 2
//   Adaptive   level of the lights' adaptive sampling; -1: off, all of the grid is always sampled
//   Samples    camera rays per pixel, each through its own place of pixel and lens
//   Variance   a pixel ends before Samples rays when its estimated variance is below; 0: never
#version 3.7;
#ifndef (Full) #declare Full = 1; #end
#ifndef (Grid) #declare Grid = 2; #end
#ifndef (Adaptive) #declare Adaptive = -1; #end
#ifndef (Samples) #declare Samples = 16; #end
#ifndef (Variance) #declare Variance = 0; #end

global_settings {
  assumed_gamma 1.0  // colours are linear, as in drt
  max_trace_level 5  // the camera ray and 4 reflections: max_depth 4
}
#default { finish { ambient 0 diffuse 1 } }
background { rgb <0.12, 0.14, 0.18> }

// POV's lens has a radius of aperture / 4: the places of its rays lie in a disc of radius 1/2, times aperture / 2. A
// lens of next to no size keeps the sampling of the pixel the same: one uniform place in its square per ray.
camera {
  right -x * image_width / image_height  // right-handed
  location <0, 2.6, 9>
  look_at <0, 0.9, 0>
  angle 40
  aperture #if (Full) 4 * 0.12 #else 1e-6 #end
  focal_point <0, 0.9, 0>
  blur_samples Samples
  variance Variance
  confidence 0.9
}

// With jitter, each of the grid's Grid points is spread over a cell of its own and the outer cells' halves lie outside
// of the given axes. Axes that are shorter by one cell make the cells together as large as drt's light.
#macro AreaLight(Corner, EdgeX, EdgeY, Color)
  light_source {
    Corner + (EdgeX + EdgeY) / 2, rgb Color
    area_light EdgeX * (Grid - 1) / Grid, EdgeY * (Grid - 1) / Grid, Grid, Grid
    #if (Adaptive >= 0) adaptive Adaptive #end
    jitter
    area_illumination on  // cosine and highlight too are those of the area, not of its centre
  }
#end
AreaLight(<-5, 6, 1>, <2, 0, 0>, <0, 0, 2>, <0.62, 0.58, 0.5>)
AreaLight(<3.5, 5, 3>, <1.2, 0, -0.9>, <0.5, 1, 0.7>, <0.26, 0.3, 0.36>)

#macro Look(Pigment, Phong, Size, Reflection)
  pigment { rgb Pigment }
  #if (Full) finish { phong Phong phong_size Size reflection Reflection } #end
#end
#declare Floor = texture { Look(<0.62, 0.6, 0.56>, 0, 1, 0.12) }
#declare Wall = texture { Look(<0.5, 0.55, 0.6>, 0, 1, 0) }
#declare Red = texture { Look(<0.7, 0.16, 0.1>, 0.5, 60, 0.2) }
#declare Yellow = texture { Look(<0.75, 0.58, 0.12>, 0.5, 60, 0.2) }
#declare Blue = texture { Look(<0.12, 0.25, 0.6>, 0.5, 60, 0.2) }
#declare Steel = texture { Look(<0.25, 0.25, 0.25>, 0.8, 120, 0.55) }
#declare Clay = texture { Look(<0.66, 0.5, 0.38>, 0, 1, 0) }

plane { y, 0 texture { Floor } }
plane { z, -6 texture { Wall } }
sphere { <-2.1, 1, 0.2>, 1 texture { Red } }
sphere { <0.1, 0.8, -1.4>, 0.8 texture { Steel } }
sphere { <1.0, 0.5, 1.6>, 0.5 texture { Yellow } }
sphere { <-0.6, 0.35, 2.4>, 0.35 texture { Blue } }
sphere { <2.0, 1.9, -2>, 0.7 texture { Blue } }
box { <-0.9, -0.6, -0.9>, <0.9, 0.6, 0.9> rotate 25 * y translate <2, 0.6, -2> texture { Clay } }
cylinder { <-3.4, 0, -2.5>, <-3.4, 3.2, -2.5>, 0.45 texture { Clay } }
cylinder { <3.7, 0, -0.5>, <3.7, 2.4, -0.5>, 0.3 texture { Red } }
