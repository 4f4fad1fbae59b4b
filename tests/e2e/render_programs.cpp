#include "render_programs.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace drt {

const std::string small_scene = R"(drt: 1
render: {width: 24, height: 16, fps: 10, spp: 4}
background: [0.1, 0.2, 0.3]
ambient_light: 1
materials:
  - {name: red, ambient: 0.02, diffuse: [0.7, 0.1, 0.08]}
bodies:
  - {name: ball, type: sphere, center: [0, 1, 0], radius: 1, material: red}
  - {name: floor, type: plane, material: red}
lights:
  - {name: lamp, type: rectangle, corner: [-1, 4, -1], edge_x: [2, 0, 0], edge_y: [0, 0, 2], color: 12}
cameras:
  - {name: main, video_start: 0, video_end: 1, position: [0, 2, 6], target: [0, 1, 0], fov_degrees: 40}
)";

namespace {

// Tests leave nothing in the user's cache, and find nothing there.
void forbid_default_cache() {
    static const int done = setenv("XDG_CACHE_HOME", "/dev/null", 1);
    ASSERT_EQ(done, 0);
}

}  // namespace

ProcessResult render(const std::vector<std::string>& arguments, const ProcessOptions& options) {
    forbid_default_cache();
    return test::run_process(DRT_RENDER, arguments, options);
}

ProcessResult render_in_shell(const std::string& command, const std::vector<std::string>& arguments,
                              const ProcessOptions& options) {
    forbid_default_cache();
    std::vector<std::string> all{"-c", command, DRT_RENDER};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return test::run_process("/bin/sh", all, options);
}

Image render_exr(const TempFolder& folder, const std::string& name, std::vector<std::string> arguments) {
    const std::string path = folder.file(name + ".exr");
    arguments.insert(arguments.end(), {"-o", path});
    const ProcessResult r = render(arguments);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return r.exit_code == 0 ? read_image_raw(path) : Image();
}

std::map<std::string, MetadataValue> exr_attributes(const std::string& path) {
    const Imf::InputFile file(path.c_str());
    std::map<std::string, MetadataValue> out;
    const auto take = [&out]<class T>(const std::string& name, const Imf::Attribute& attribute, T) {
        if (const auto* typed = dynamic_cast<const Imf::TypedAttribute<T>*>(&attribute)) out[name] = typed->value();
    };
    for (auto i = file.header().begin(); i != file.header().end(); ++i) {
        take(i.name(), i.attribute(), std::string());
        take(i.name(), i.attribute(), int());
        take(i.name(), i.attribute(), float());
        take(i.name(), i.attribute(), double());
    }
    return out;
}

bool wait_until(const std::function<bool()>& condition) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(30);
    while (Clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

std::vector<std::string> files_in(const TempFolder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace drt
