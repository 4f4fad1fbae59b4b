#include "pictures/time_average.h"

#include "reference/camera.h"
#include "reference/pixel_filter.h"
#include "reference/radiance.h"

namespace drt {
namespace {

using namespace reference;

constexpr int replicates = 8;  // of a pixel, stratified in time each: their differences tell the variance

/// The scene's first body, placed and turned by its description instead of by a motion.
Sphere posed(Sphere ball, const Pose& pose) {
    ball.center = pose.position;
    ball.pole = rotate(pose.orientation, ball.pole);
    ball.meridian = rotate(pose.orientation, ball.meridian);
    return ball;
}

class Exposure {
public:
    Exposure(const SceneDesc& scene, const Course& course)
        : scene_(scene), camera_(camera_at(scene, 0)), filter_(scene.render.filter), world_(scene), course_(course) {
        world_.bodies.front().motion = nullptr;
    }

    /// The mean over `n` instants, one in each n-th part of the shutter's time.
    Rgb sample(int x, int y, int n, Random& random) {
        const double duration = camera_.shutter.duration.value_or(1 / scene_.render.fps);
        Rgb sum;
        for (int i = 0; i < n; ++i) {
            const double video_time = duration * (i + random.uniform()) / n;
            const double time = scene_time(camera_, video_time);
            std::get<Sphere>(world_.bodies.front().shape) =
                posed(std::get<Sphere>(scene_.bodies.front().shape), course_(time));
            const PixelFilter::Sample at = filter_.sample(random);
            const Ray ray = camera_ray(camera_, video_time, x + 0.5 + at.offset.x, y + 0.5 + at.offset.y,
                                       scene_.render.width, scene_.render.height, random);
            sum += radiance(Instant(world_, time), ray, 0, {}, random) * at.weight;
        }
        return sum * (1.0 / n);
    }

private:
    const SceneDesc& scene_;
    const Camera& camera_;
    PixelFilter filter_;
    World world_;
    const Course& course_;
};

}  // namespace

PictureEstimate time_average(const SceneDesc& scene, const Course& course, int spp, std::uint64_t seed) {
    Exposure exposure(scene, course);
    PictureEstimate picture(scene.render.width, scene.render.height);
    picture.freedom = replicates - 1;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            Random random(seed, 0, x, y);
            Rgb mean, squares;  // Welford's running mean and sum of squared deviations
            for (int i = 0; i < replicates; ++i) {
                const Rgb value = exposure.sample(x, y, spp / replicates, random);
                const Rgb before = value - mean;
                mean += before * (1.0 / (i + 1));
                squares += before * (value - mean);
            }
            picture.mean[picture.index(x, y)] = mean;
            picture.variance[picture.index(x, y)] = squares * (1.0 / (replicates * (replicates - 1)));
        }
    return picture;
}

}  // namespace drt
