#pragma once
// Every single value of a struct against the table of its fields. Internal to the scene room.

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "drt/scene/report.h"
#include "drt/scene/scene_fields.h"
#include "drt/scene/utf8.h"
#include "drt/scene/value_text.h"

namespace drt {

void check_value(Report&, const ScenePath&, const FieldInfo&, double);
void check_value(Report&, const ScenePath&, const FieldInfo&, int);
void check_value(Report&, const ScenePath&, const FieldInfo&, const Vec3d&);
void check_value(Report&, const ScenePath&, const FieldInfo&, const Color&);
void check_value(Report&, const ScenePath&, const FieldInfo&, const Quatd&);
void check_value(Report&, const ScenePath&, const FieldInfo&, const std::string&);

inline void check_value(Report&, const ScenePath&, const FieldInfo&, bool) {}
inline void check_value(Report&, const ScenePath&, const FieldInfo&, std::uint32_t) {}
template <IsEnum E>
void check_value(Report&, const ScenePath&, const FieldInfo&, E) {}

template <HasFields T>
void check_value(Report&, const ScenePath&, const FieldInfo&, const T&);

template <class V>
void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const std::optional<V>& value) {
    if (value) check_value(report, at, info, *value);
}

template <class V>
void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const std::vector<V>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) check_value(report, at[i], info, list[i]);
}

template <class T, class M>
void check_entry(Report& report, const ScenePath& at, const T& object, const Field<T, M>& f) {
    check_value(report, at / f.info.name, f.info, object.*f.member);
}

template <class T, class Start, class End>
void check_entry(Report& report, const ScenePath& at, const T& object, const StartEnd<T, Start, End>& f) {
    check_value(report, at / f.info.name / "start", f.info, object.*f.start);
    check_value(report, at / f.info.name / "end", f.info, object.*f.end);
}

template <class T, class V>
void check_entry(Report& report, const ScenePath& at, const T& object, const OneOrMore<T, V>& f) {
    check_value(report, at / f.info.name, f.info, object.*f.member);
    if ((object.*f.member).empty() && !report.sources.is_unread((at / f.info.name).str()))
        report.error(at / f.info.name, "no " + report.name(at / f.info.name, f.info.name), {}, "at least one");
}

template <class T, class Variant>
void check_entry(Report& report, const ScenePath& at, const T& object, const Alternatives<T, Variant>& f) {
    std::visit([&](const auto& alternative) { check_value(report, at, f.info, alternative); }, object.*f.member);
}

template <HasFields T>
void check_value(Report& report, const ScenePath& at, const FieldInfo&, const T& object) {
    for_each_field<T>([&](const auto& entry) { check_entry(report, at, object, entry); });
}

/// Which values of an object are fine: read, and without an error. Checks of how values go together ask for those that
/// they look at: told of a wrong one, they would only repeat that it is wrong; silent for any other, they would hide
/// what they find.
class FineFields {
public:
    /// By the errors from the first one given to the last one so far.
    FineFields(const Report& report, std::size_t first)
        : report_(report), first_(first), end_(report.error_paths.size()) {}

    /// No error at these paths, inside of them, or of a list or struct that they are part of.
    template <class... Path>
    bool operator()(const Path&... at) const {
        const bool all_are = first_ == end_ && report_.sources.unread.empty();
        return all_are || (is_fine(at.str()) && ...);
    }

private:
    bool is_fine(const std::string& path) const;

    const Report& report_;
    std::size_t first_, end_;
};

/// Checks every single value of the object.
template <HasFields T>
FineFields check_fields(Report& report, const ScenePath& at, const T& object) {
    const std::size_t before = report.error_paths.size();
    check_value(report, at, FieldInfo{}, object);
    return {report, before};
}

/// The elements of a list by name, for references to them.
template <class T>
class NameIndex {
public:
    explicit NameIndex(const std::vector<T>& list) {
        for (const T& element : list) elements_.try_emplace(element.name, &element);
    }

    /// The element of that name; or null, and an error.
    const T* find(Report& report, const ScenePath& at, const std::string& name) const {
        if (const auto it = elements_.find(name); it != elements_.end()) return it->second;
        const std::string kind(Fields<T>::name);
        report.error(at, "unknown " + kind, name,
                     elements_.empty() ? "a " + kind + " of this scene, which has none" : "the name of a " + kind,
                     report.error_paths.size() < most_suggestions ? nearest_word(name, names()) : std::string{});
        return nullptr;
    }

private:
    static constexpr std::size_t most_suggestions = 100;  // they take time, and nobody reads more

    std::vector<std::string_view> names() const {
        std::vector<std::string_view> out;
        for (const auto& [name, element] : elements_) out.push_back(name);
        std::sort(out.begin(), out.end());  // of equally near ones the same in every run
        return out;
    }

    std::unordered_map<std::string_view, const T*> elements_;
};

/// Names must not occur twice in a list. Elements without a name are fine.
template <class T>
void check_unique_names(Report& report, const ScenePath& at, const std::vector<T>& list) {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i].name.empty()) continue;
        const auto [it, is_new] = first.try_emplace(list[i].name, i);
        if (is_new) continue;
        const std::string place = to_string(report.sources.find((at[it->second] / "name").str()));
        report.error(at[i] / "name", "duplicate name of a " + std::string(Fields<T>::name), list[i].name,
                     "another name" + (place.empty() ? "" : "; it was first used at " + place));
    }
}

}  // namespace drt
