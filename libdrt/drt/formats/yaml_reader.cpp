// A scene from its YAML files: versions, includes, and everything wrong in all of them at once.

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "drt/formats/formats.h"
#include "drt/formats/yaml_fields.h"

namespace drt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = 64 << 20;
constexpr std::size_t deepest_include = 32;

class SceneFiles {
public:
    SceneRead read(const std::string& path);

private:
    void read_file_at(const std::string& path, const Location& named_at);
    void read_root(const YamlTree& tree, const fs::path& directory);
    void read_includes(YamlContext& context, const YamlNode& include);
    void include(YamlContext& context, const YamlNode& name);
    bool check_version(YamlContext& context, const YamlNode& root);
    void report_unreadable(const std::string& path, const Location& named_at, const FileText& file);
    void check_values();
    [[noreturn]] void fail();

    SceneDesc scene_;
    Diagnostics errors_, notes_;
    std::vector<std::string> files_;
    std::vector<fs::path> including_;  // the chain of files being read
    std::set<fs::path> seen_;
    bool has_whole_scene_ = true;  // no file and no section is missing: what refers to nothing is an error
    bool has_unreadable_file_ = false;
};

SceneRead SceneFiles::read(const std::string& path) {
    scene_.sources.places[""] = {path, 0, 0};
    read_file_at(path, {path, 0, 0});
    if (has_whole_scene_) check_values();
    if (!errors_.empty()) fail();
    return {std::move(scene_), std::move(notes_), std::move(files_)};
}

fs::path identity_of(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    return error ? fs::path(path).lexically_normal() : canonical;
}

void SceneFiles::read_file_at(const std::string& path, const Location& named_at) {
    const FileText file = read_file(path, largest_file);
    if (!file.problem.empty()) return report_unreadable(path, named_at, file);
    files_.push_back(path);
    const fs::path identity = identity_of(path);
    seen_.insert(identity);
    including_.push_back(identity);
    const std::size_t before = errors_.size();
    const YamlTree tree = parse_yaml(path, file.text, errors_);
    if (tree.root) {
        read_root(tree, fs::path(path).parent_path());
    } else {
        has_whole_scene_ = false;
        if (errors_.size() == before)
            errors_.push_back({Severity::error, {path, 0, 0}, "the file is empty", {}, "`drt: 1` and a scene", {}});
    }
    including_.pop_back();
}

void SceneFiles::report_unreadable(const std::string& path, const Location& named_at, const FileText& file) {
    has_whole_scene_ = false;
    const std::string shown = named_at.line > 0 ? path : std::string{};  // the scene's own name is the place already
    if (file.too_large) {
        errors_.push_back({Severity::error,
                           named_at,
                           "the file is too large",
                           shown,
                           "at most 64 MB; put very many balls into a sphere_set",
                           {}});
    } else {
        has_unreadable_file_ = true;
        errors_.push_back({Severity::error, named_at, "cannot read the file (" + file.problem + ")", shown, {}, {}});
    }
}

bool SceneFiles::check_version(YamlContext& context, const YamlNode& root) {
    const YamlNode* version = find_value(root, "drt");
    if (version && version->kind == YamlNode::Kind::scalar && version->text == "1") return true;
    const std::string expected = "`drt: 1`, the version of this format";
    if (!version)
        context.error(root, "missing key", "drt", expected);
    else
        context.error(*version, "a version of the format that this program does not know", printable(version->text),
                      expected);
    return false;
}

void SceneFiles::read_root(const YamlTree& tree, const fs::path& directory) {
    YamlContext context{tree, directory, scene_.sources, errors_};
    const YamlNode& root = *tree.root;
    if (root.kind != YamlNode::Kind::mapping) {
        has_whole_scene_ = false;
        context.error(root, "the file is not a mapping", printable(root.text), "`drt: 1` and a scene");
        return;
    }
    if (!check_version(context, root)) {
        has_whole_scene_ = false;
        if (find_value(root, "drt")) return;  // who knows what the keys mean there
    }
    if (const YamlNode* names = find_value(root, "include")) read_includes(context, *names);
    read_fields(context, root, ScenePath{}, scene_, {"drt", "include"});
    for (std::size_t i = 0; i + 1 < root.items.size(); i += 2) {
        const bool is_list = root.items[i + 1]->kind == YamlNode::Kind::list;
        const std::string& key = root.items[i]->text;
        if (!is_list && (key == "textures" || key == "materials")) has_whole_scene_ = false;
    }
}

void SceneFiles::read_includes(YamlContext& context, const YamlNode& names) {
    if (names.kind == YamlNode::Kind::list)
        for (const YamlNode* name : names.items) include(context, *name);
    else
        include(context, names);
}

void SceneFiles::include(YamlContext& context, const YamlNode& name) {
    if (name.kind != YamlNode::Kind::scalar || name.text.empty()) {
        context.wrong_kind(name, FieldInfo{"include", "", {}, ""}, "names of files");
        has_whole_scene_ = false;
        return;
    }
    const std::string path = (context.directory / name.text).lexically_normal().string();
    const fs::path identity = identity_of(path);
    if (std::find(including_.begin(), including_.end(), identity) != including_.end())
        context.error(name, "the file includes itself, directly or through others", printable(name.text),
                      "a file that does not include this one");
    else if (including_.size() >= deepest_include)
        context.error(name, "includes too deep", printable(name.text), "at most 32 files that include each other");
    else if (!seen_.contains(identity))  // what two files include is there once
        read_file_at(path, context.tree.place(name));
}

void SceneFiles::check_values() {
    // a value that could not be read has its default: what is said of that would only confuse
    std::set<std::tuple<std::string, int, int>> unread;
    for (const Diagnostic& e : errors_) unread.emplace(e.where.file, e.where.line, e.where.column);
    for (Diagnostic& d : validate(scene_)) {
        if (d.severity != Severity::error)
            notes_.push_back(std::move(d));
        else if (!unread.contains({d.where.file, d.where.line, d.where.column}))
            errors_.push_back(std::move(d));
    }
}

void SceneFiles::fail() {
    std::vector<std::string> files;  // in the order in which they first went wrong
    const auto rank = [&](const Diagnostic& d) {
        const auto it = std::find(files.begin(), files.end(), d.where.file);
        if (it == files.end()) files.push_back(d.where.file);
        return std::find(files.begin(), files.end(), d.where.file) - files.begin();
    };
    for (const Diagnostic& d : errors_) rank(d);
    std::stable_sort(errors_.begin(), errors_.end(), [&](const Diagnostic& a, const Diagnostic& b) {
        return std::tuple(rank(a), a.where.line, a.where.column) < std::tuple(rank(b), b.where.line, b.where.column);
    });
    if (errors_.size() > most_messages) {
        const std::size_t more = errors_.size() - most_messages;
        errors_.resize(most_messages);
        errors_.push_back({Severity::note, {}, std::to_string(more) + " more errors", {}, {}, {}});
    }
    throw Error(has_unreadable_file_ ? ErrorKind::asset : ErrorKind::scene, std::move(errors_));
}

}  // namespace

SceneRead read_yaml_scene(const std::string& path) { return SceneFiles{}.read(path); }

}  // namespace drt
