#include "apps/input_files.h"

#include <filesystem>
#include <system_error>

#include "drt/base/atomic_file.h"

namespace drt {

namespace fs = std::filesystem;

namespace {

fs::path end_of_links(const fs::path& p) {
    try {
        return follow_links(p.string());
    } catch (const std::system_error&) {
        return p;
    }
}

std::string canonical_name(const fs::path& p) {
    std::error_code ignored;  // a name that leads nowhere is its own
    const fs::path found = fs::weakly_canonical(fs::absolute(end_of_links(p), ignored), ignored);
    return found.empty() ? p.string() : found.string();
}

}  // namespace

std::string FileNames::operator()(const std::string& path) {
    const fs::path p(path);
    std::error_code ignored;
    if (fs::is_symlink(p, ignored)) return canonical_name(p);
    const auto [folder, fresh] = folders_.try_emplace(p.parent_path().string());
    if (fresh) folder->second = canonical_name(p.has_parent_path() ? p.parent_path() : fs::path("."));
    return (fs::path(folder->second) / p.filename()).string();
}

void check_inputs_kept(const FileSet& outputs, const SceneRead& read) {
    FileNames name_of;
    const auto check = [&](const std::string& path, const char* what) {
        if (outputs.count(name_of(path)) > 0)
            throw Error(ErrorKind::usage, {{Severity::error, {}, std::string("the output is ") + what, path, {}, {}}});
    };
    for (const std::string& file : read.files) check(file, "a file that the scene is read from");
    for (const Texture& t : read.scene.textures) check(t.file, "a texture of the scene");
    for (const Body& b : read.scene.bodies)
        if (const auto* balls = std::get_if<SphereSet>(&b.shape)) check(balls->file, "a sphere_set of the scene");
}

}  // namespace drt
