#include <dlfcn.h>
#include <link.h>

#include <cstring>
#include <string>
#include <vector>

#include "drt/base/diagnostic.h"
#include "drt/dynamics/contact_world.h"

// Defined by the room `bullet`: null unless the program links it.
extern "C" {
[[gnu::weak]] drt::ContactWorld* drt_make_contact_world(const drt::RigidScene*);
}

namespace drt {

namespace {

using Make = ContactWorld* (*)(const RigidScene*);
using Version = const char* (*)();

constexpr const char* file_name = "libdrt-bullet.so";

// What the dynamic linker searches for whatever holds this code: its rpath, LD_LIBRARY_PATH, the system's folders. A
// plain dlopen would search the same, but for the sanitizers' own dlopen, on whose behalf it then searches; and it does
// not say where.
std::vector<std::string> search_folders() {
    Dl_info info;
    void* self = nullptr;
    if (!dladdr1(reinterpret_cast<const void*>(&load_contact_world), &info, &self, RTLD_DL_LINKMAP)) return {};
    Dl_serinfo size;
    if (dlinfo(self, RTLD_DI_SERINFOSIZE, &size) != 0) return {};
    const std::unique_ptr<char[]> buffer(new char[size.dls_size]);
    auto* found = reinterpret_cast<Dl_serinfo*>(buffer.get());
    if (dlinfo(self, RTLD_DI_SERINFOSIZE, found) != 0 || dlinfo(self, RTLD_DI_SERINFO, found) != 0) return {};
    std::vector<std::string> out;
    for (unsigned i = 0; i < found->dls_cnt; ++i) out.push_back(found->dls_serpath[i].dls_name);
    return out;
}

[[noreturn]] void refuse(const std::string& why) {
    throw Error(ErrorKind::asset, "bodies with physics need the library " + std::string(file_name) + ": " + why);
}

// Never closed: what it made may outlive any scope here.
void* open_library() {
    std::string reasons;
    for (const std::string& folder : search_folders()) {
        const std::string file = folder + "/" + file_name;
        if (void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
        reasons += std::string("\n  ") + dlerror();
    }
    refuse("it cannot be loaded from any of the places where it may be:" + reasons);
}

Make load() {
    if (drt_make_contact_world) return drt_make_contact_world;
    void* library = open_library();
    const auto version = reinterpret_cast<Version>(dlsym(library, "drt_contact_world_version"));
    const auto make = reinterpret_cast<Make>(dlsym(library, "drt_make_contact_world"));
    if (!version || !make) refuse("the file that was found is another library");
    if (std::strcmp(version(), contact_world_version) != 0)
        refuse(std::string("the file that was found is \"") + version() + "\" instead of \"" + contact_world_version +
               "\"; drt was not installed as a whole");
    return make;
}

}  // namespace

std::unique_ptr<ContactWorld> load_contact_world(const RigidScene& scene) {
    static const Make make = load();
    return std::unique_ptr<ContactWorld>(make(&scene));
}

}  // namespace drt
