#include "reference/reference.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "reference/camera.h"
#include "reference/pixel_filter.h"
#include "reference/radiance.h"

namespace drt {
namespace {

using namespace reference;

struct Job {
    const World& world;
    const Camera& camera;
    PixelFilter filter;
    double opening;  ///< video time at which the shutter opens
    int frame, spp;
    std::uint64_t seed;
};

Rgb sample_pixel(const Job& job, int x, int y, int width, int height, Random& random) {
    const double video_time = sample_video_time(job.camera.shutter, job.opening, job.world.scene.render.fps, random);
    const PixelFilter::Sample filter = job.filter.sample(random);
    const Ray ray =
        camera_ray(job.camera, video_time, x + 0.5 + filter.offset.x, y + 0.5 + filter.offset.y, width, height, random);
    const Instant instant(job.world, scene_time(job.camera, video_time));
    return radiance(instant, ray, 0, media_at(instant, ray.origin), random) * filter.weight;
}

void render_pixel(const Job& job, int x, int y, ReferencePicture& picture) {
    Random random(job.seed, job.frame, x, y);
    Rgb mean, squares;  // Welford's running mean and sum of squared deviations
    for (int i = 0; i < job.spp; ++i) {
        const Rgb value = sample_pixel(job, x, y, picture.width, picture.height, random);
        const Rgb before = value - mean;
        mean += before * (1.0 / (i + 1));
        squares += before * (value - mean);
    }
    picture.mean[picture.index(x, y)] = mean;
    picture.variance[picture.index(x, y)] = squares * (1.0 / (double(job.spp) * (job.spp - 1)));
}

}  // namespace

ReferencePicture render_reference(const SceneDesc& scene, int frame, int width, int height, int spp,
                                  std::uint64_t seed) {
    if (spp < 2) throw std::invalid_argument("at least 2 samples are needed for a variance");
    const World world(scene);
    const double opening = frame / scene.render.fps;
    const Job job{world, camera_at(scene, opening), PixelFilter(scene.render.filter), opening, frame, spp, seed};
    ReferencePicture picture(width, height);
    // Variances of normal values rest on spp - 1 degrees of freedom, those of samples that are mostly dark and now
    // and then bright on far fewer: 2 n / (kurtosis - 1). A sixteenth allows for a kurtosis of 33.
    picture.freedom = std::max(1.0, spp / 16.0);
    std::atomic<int> next_row = 0;
    const auto work = [&] {
        for (int y = next_row++; y < height; y = next_row++)
            for (int x = 0; x < width; ++x) render_pixel(job, x, y, picture);
    };
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
    work();
    helpers.clear();  // joins
    return picture;
}

}  // namespace drt
