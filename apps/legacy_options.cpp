#include "apps/legacy_options.h"

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

namespace drt {
namespace {

/// "0,-9.81,0"; locale-free. False when it is not three finite numbers.
bool parse_vector(std::string_view text, Vec3d& out) {
    double* const parts[] = {&out.x, &out.y, &out.z};
    for (int i = 0; i < 3; ++i) {
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), *parts[i]);
        if (code != std::errc{} || !std::isfinite(*parts[i])) return false;
        text.remove_prefix(size_t(end - text.data()));
        if (i == 2) return text.empty();
        if (!text.starts_with(',')) return false;
        text.remove_prefix(1);
    }
    return false;
}

template <class T>
CLI::Validator number_where(bool (*good)(T), const std::string& expected) {
    return CLI::Validator(
        [good, expected](std::string& text) {
            T v{};
            const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), v);
            const bool read = code == std::errc{} && end == text.data() + text.size() && std::isfinite(v);
            return read && good(v) ? std::string() : "expected " + expected + ", not \"" + text + '"';
        },
        std::string());
}

}  // namespace

void add_legacy_options(CLI::App& app, LegacyOptions& options) {
    const std::string group = "Legacy scenes (what the format leaves open)";
    const std::map<std::string, LegacyOptions::Fov> readings{{"half-width", LegacyOptions::Fov::half_width},
                                                             {"distance", LegacyOptions::Fov::distance}};
    app.add_option("--fov", options.fov,
                   "FOV is the image's width at distance 1 (half-width: angle = 2 atan(FOV/2), the "
                   "default) or the distance of an image of width 2 (distance: 2 atan(1/FOV))")
        ->transform(CLI::CheckedTransformer(readings).description(""))
        ->option_text("half-width|distance")
        ->group(group);
    app.add_option_function<std::string>(
           "--gravity",
           [&options](const std::string& text) {
               if (!parse_vector(text, options.gravity))
                   throw CLI::ValidationError("--gravity", "expected x,y,z, not \"" + text + '"');
           },
           "acceleration, scene units / s^2 (0,-9.81,0)")
        ->option_text("X,Y,Z")
        ->group(group);
    app.add_option("--density", options.density, "of bodies that move, mass / unit^3 (1)")
        ->check(number_where<double>([](double v) { return v > 0; }, "a number > 0"))
        ->option_text("N")
        ->group(group);
    app.add_option("--legacy-step", options.legacy_step, "seconds that a force event acts for (0.05)")
        ->check(number_where<double>([](double v) { return v > 0; }, "a number > 0"))
        ->option_text("SECONDS")
        ->group(group);
    app.add_option("--ambient-light", options.ambient_light, "the scene's ambient light (0.12)")
        ->check(number_where<float>([](float v) { return v >= 0; }, "a number >= 0"))
        ->option_text("N")
        ->group(group);
    app.add_flag("--add-lights", options.add_lights, "add a light to a scene that has none")->group(group);
}

}  // namespace drt
