#include "drt/bake/cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>

#include "drt/bake/cache_folder.h"
#include "drt/base/atomic_file.h"

namespace drt {

namespace {

namespace fs = std::filesystem;

// ---- bytes ---------------------------------------------------------------------------------------------------------
// Numbers as they are in memory: a cache belongs to one machine, and input_text() names its instruction set.

class ByteWriter {
public:
    template <class T>
    void number(const T& v) requires std::is_arithmetic_v<T> {
        const auto* p = reinterpret_cast<const char*>(&v);
        bytes.append(p, sizeof v);
    }
    void text(const std::string& s) {
        number(std::uint64_t(s.size()));
        bytes += s;
    }
    std::string bytes;
};

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}
    template <class T>
    void number(T& v) requires std::is_arithmetic_v<T> {
        std::memcpy(&v, take(sizeof v).data(), sizeof v);
    }
    void text(std::string& s) {
        std::uint64_t size = 0;
        number(size);
        s = take(size);
    }
    bool is_at_end() const { return rest_.empty(); }

private:
    std::string_view take(std::uint64_t size) {
        if (size > rest_.size()) throw std::runtime_error("it is cut short");
        const std::string_view out = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return out;
    }
    std::string_view rest_;
};

// The same walk reads and writes.
template <class Bytes, class Value>
void walk(Bytes& b, Value& v) requires std::is_arithmetic_v<Value> {
    b.number(v);
}
template <class Bytes, class Value>
void walk(Bytes& b, Value& v) requires std::is_enum_v<Value> {
    int number = int(v);
    b.number(number);
    v = Value(number);
}
template <class Bytes>
void walk(Bytes& b, std::string& s) {
    b.text(s);
}
template <class Bytes>
void walk(Bytes& b, Vec3d& v) {
    b.number(v.x), b.number(v.y), b.number(v.z);
}
template <class Bytes>
void walk(Bytes& b, Quatd& q) {
    b.number(q.w), b.number(q.x), b.number(q.y), b.number(q.z);
}
template <class Bytes>
void walk(Bytes& b, Turn& t) {
    walk(b, t.axis), walk(b, t.degrees);
}
template <class Bytes, class Value>
void walk(Bytes& b, std::optional<Value>& v) {
    bool is_set = v.has_value();
    walk(b, is_set);
    if (!is_set) return;
    if (!v) v.emplace();
    walk(b, *v);
}
template <class Bytes>
void walk(Bytes& b, MotionKey& k) {
    walk(b, k.time), walk(b, k.position), walk(b, k.orientation), walk(b, k.turn);
}
template <class Bytes>
void walk(Bytes& b, BakeNote& n) {
    walk(b, n.severity), walk(b, n.body), walk(b, n.message);
}
template <class Bytes, class Item>
void walk(Bytes& b, std::vector<Item>& list) {
    std::uint64_t size = list.size();
    walk(b, size);
    list.resize(size);
    for (Item& item : list) walk(b, item);
}
template <class Bytes>
void walk(Bytes& b, Motion& m) {
    walk(b, m.interpolation), walk(b, m.keys);
}
template <class Bytes>
void walk(Bytes& b, BakeReport& r) {
    walk(b, r.begin), walk(b, r.end), walk(b, r.trusted_until), walk(b, r.is_chaotic), walk(b, r.tolerance),
        walk(b, r.error);
    walk(b, r.step), walk(b, r.runs), walk(b, r.dynamic_bodies), walk(b, r.impacts), walk(b, r.contact_steps);
    walk(b, r.keys), walk(b, r.notes);
}
template <class Bytes>
void walk(Bytes& b, BakedMotion& m) {
    walk(b, m.motions), walk(b, m.report);
}

// ---- files ---------------------------------------------------------------------------------------------------------

std::uint64_t checksum(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

// Magic, key, motion, checksum of all before.
std::string to_bytes(const std::string& key, BakedMotion motion) {
    ByteWriter w;
    w.bytes = bake_file_magic;
    w.text(key);
    walk(w, motion);
    w.number(checksum(w.bytes));
    return w.bytes;
}

// Nothing is believed before the checksum agrees.
BakedMotion from_bytes(const std::string& key, std::string_view bytes) {
    if (!bytes.starts_with(bake_file_magic)) throw std::runtime_error("it is something else");
    if (bytes.size() < bake_file_magic.size() + sizeof(std::uint64_t)) throw std::runtime_error("it is cut short");
    const std::string_view body = bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
    std::uint64_t sum = 0;
    std::memcpy(&sum, bytes.data() + body.size(), sizeof sum);
    if (sum != checksum(body)) throw std::runtime_error("it is damaged");
    ByteReader r(body.substr(bake_file_magic.size()));
    std::string found_key;
    r.text(found_key);
    if (found_key != key) throw std::runtime_error("it belongs to another scene");
    BakedMotion motion;
    walk(r, motion);
    if (!r.is_at_end()) throw std::runtime_error("it is damaged");
    return motion;
}

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error("it cannot be read");
    std::string bytes(fs::file_size(path), '\0');
    if (!in.read(bytes.data(), std::streamsize(bytes.size()))) throw std::runtime_error("it cannot be read");
    return bytes;
}

BakedMotion find(const std::string& path, const std::string& key) {
    if (!is_bake_file_there(path)) throw std::runtime_error("there is none");
    if (fs::file_size(path) > largest_bake_file) throw std::runtime_error("it is too large");
    BakedMotion motion = from_bytes(key, read_file(path));
    note_use(path);
    return motion;
}

void keep(const std::string& path, const std::string& bytes) {
    if (bytes.size() > largest_bake_file) throw std::runtime_error("it is too large");
    is_bake_file_there(path);  // what is no file is not replaced
    replace_file(
        path,
        [&](const std::string& temporary) {
            write_bytes(temporary, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
        },
        [&](const std::string& temporary) {
            if (read_file(temporary) != bytes) throw std::runtime_error("the file was cut short");
        });
}

std::string hex_hash(const std::string& text) {
    const XXH128_hash_t h = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", h.high64, h.low64);
}

}  // namespace

std::string default_bake_cache() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        return value && value[0] == '/' ? std::string(value) : std::string();  // others are to be ignored (XDG)
    };
    if (const std::string cache = folder("XDG_CACHE_HOME"); !cache.empty()) return cache + "/drt";
    if (const std::string home = folder("HOME"); !home.empty()) return home + "/.cache/drt";
    return {};
}

CachedMotion cached_motion(const BakeInput& in, const std::string& folder) {
    CachedMotion out;
    if (folder.empty()) {
        out.motion = compute_motion(in);
        return out;
    }
    const std::string key = hex_hash(input_text(in));
    out.file = bake_file_path(folder, key);
    try {
        out.motion = find(out.file, key);
        out.found = true;
        return out;
    } catch (const std::exception& e) {
        out.found_not_because = e.what();
    }
    out.motion = compute_motion(in);
    try {
        fs::create_directories(folder);
        keep(out.file, to_bytes(key, out.motion));
        prune_cache(folder);
    } catch (const std::exception& e) {
        out.kept_not_because = e.what();
    }
    return out;
}

}  // namespace drt
