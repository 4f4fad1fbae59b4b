// A program outside drt's tree: describe a scene, compile it, render it, look at a pixel; and let a ball fall.
#include <cstdio>

#include "drt/bake/bake.h"
#include "drt/plan/plan.h"
#include "drt/render/render.h"

int main() {
    drt::SceneDesc scene;
    scene.render.width = scene.render.height = 32;
    scene.materials.push_back({.name = "matte", .diffuse = drt::Color(0.5f)});
    scene.bodies.push_back({.name = "ball", .shape = drt::Sphere{}, .material = "matte", .motion = {}, .physics = {}});
    scene.lights.push_back({.name = "lamp", .shape = drt::PointLight{{0, 0, 5}}, .falloff = drt::Light::Falloff::none});
    scene.cameras.push_back({.name = "camera"});
    const drt::RenderPlan plan = drt::compile(scene, {});
    const drt::RenderResult result = drt::render(plan, {.spp = 16});
    std::printf("middle %.3f\n", double(resolve(result.film).pixel(16, 16)[0]));

    scene.bodies[0].physics.emplace();
    const drt::Baked baked = drt::bake(scene, 1);
    std::printf("falls to %.3f\n", baked.scene.bodies[0].motion->keys.back().position.y);
}
