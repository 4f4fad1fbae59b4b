#include "drt/base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace drt {

namespace {

// "MemAvailable:   123 kB" and the like.
std::optional<std::size_t> system_memory() {
    std::ifstream file("/proc/meminfo");
    std::size_t kilobytes = 0, sum = 0;
    bool known = false;
    std::string name, rest;
    while (file >> name >> kilobytes && std::getline(file, rest)) {
        if (name != "MemAvailable:" && name != "SwapFree:") continue;
        known = known || name == "MemAvailable:";
        sum += kilobytes * 1024;
    }
    return known ? std::optional(sum) : std::nullopt;
}

std::optional<std::size_t> number_in(const char* path) {
    std::ifstream file(path);
    std::size_t bytes = 0;
    return file >> bytes ? std::optional(bytes) : std::nullopt;  // "max" is no number: no limit
}

std::optional<std::size_t> group_memory() {
    const auto limit = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
    if (!limit || !used) return std::nullopt;
    return *limit - std::min(*limit, *used);
}

}  // namespace

std::optional<std::size_t> available_memory() {
    const auto system = system_memory(), group = group_memory();
    if (!system || !group) return system ? system : group;
    return std::min(*system, *group);
}

}  // namespace drt
