// What rendering allocates: as much as estimated, and nothing while rays are traced. Every allocation of this program
// by C++'s operator is counted.

#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace {

std::atomic<std::size_t> allocations{0}, live{0}, peak{0};

void* counted(void* p) {
    if (!p) throw std::bad_alloc();
    ++allocations;
    const std::size_t now = live += malloc_usable_size(p);
    std::size_t before = peak;
    while (before < now && !peak.compare_exchange_weak(before, now)) {
    }
    return p;
}

void release(void* p) {
    if (p) live -= malloc_usable_size(p);
    std::free(p);
}

}  // namespace

void* operator new(std::size_t n) { return counted(std::malloc(n)); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return counted(std::malloc(n)); }
void* operator new[](std::size_t n) { return counted(std::malloc(n)); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return counted(std::malloc(n)); }
void* operator new(std::size_t n, std::align_val_t a) {
    const auto align = std::size_t(a);
    return counted(std::aligned_alloc(align, (n + align - 1) / align * align));
}
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

namespace drt {
namespace {

/// Everything that a ray may need: lens, motion, area lights, glossy reflection and refraction.
SceneDesc rich_scene() {
    SceneDesc scene = simple_scene({0, 2, 6}, {0, 0.5, 0});
    scene.cameras[0].lens.aperture_radius = 0.1;
    scene.cameras[0].shutter.duration = 0.04;
    add(scene, "floor", Plane{}, mirror(0.5, 3));
    add_moving(scene, "ball", sphere({-0.8, 0.8, 0}, 0.7), shiny({0.8f, 0.5f, 0.3f}, 0.4f, 30),
               {Motion::Interpolation::linear, {key(-1, {-1.8, 0.8, 0}), key(1, {0.2, 0.8, 0})}});
    add(scene, "lens", sphere({0.8, 0.8, 0}, 0.7), glass(1.5, 0.9, 2));
    scene.lights = {light("lamp", lamp({0, 3, 0}, 1), Color(0.8f), Light::Falloff::none)};
    return scene;
}

std::size_t allocations_of(const RenderPlan& plan, int spp) {
    RenderOptions options;
    options.spp = spp;
    options.threads = 1;
    const std::size_t before = allocations;
    render(plan, options);
    return allocations - before;
}

TEST(Memory, NothingIsAllocatedForRays) {
    SceneDesc scene = rich_scene();
    const RenderPlan plan = compile(scene, {});
    allocations_of(plan, 1);  // what libraries set up once
    const std::size_t few = allocations_of(plan, 1), many = allocations_of(plan, 64);
    EXPECT_GT(few, 0u);  // it counts
    EXPECT_EQ(few, many);
}

TEST(Memory, IsEstimatedToTenPercent) {
    for (const auto& [width, height] : {std::pair(16384, 16), std::pair(1000, 700)})
        for (const int threads : {1, 2}) {
            SceneDesc scene = rich_scene();
            scene.render.width = width;
            scene.render.height = height;
            const RenderPlan plan = compile(scene, {});
            RenderOptions options;
            options.spp = 1;
            options.threads = threads;
            const std::size_t before = live;
            peak = before;
            const RenderResult result = render(plan, options);
            const Image picture = resolve(result.film);
            const double used = double(peak - before), estimated = double(result.memory.to_allocate());
            EXPECT_NEAR(used / estimated, 1, 0.1) << width << " x " << height << ", " << threads << " threads";
        }
}

TEST(Memory, TooLargeAPictureIsRefusedBeforeItIsAllocated) {
    SceneDesc scene = rich_scene();
    scene.render.width = scene.render.height = 16384;
    const RenderPlan plan = compile(scene, {});
    RenderOptions options;
    options.memory_limit = std::size_t(8e9);
    const std::size_t before = live;
    peak = before;
    try {
        render(plan, options);
        FAIL() << "rendered";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::memory);
        EXPECT_NE(std::string(e.what()).find("16384 x 16384 pixels takes 23.8 GB"), std::string::npos) << e.what();
    }
    EXPECT_LT(peak - before, std::size_t(1e6));
}

}  // namespace
}  // namespace drt
