#pragma once
// Single values of a scene out of YAML nodes. Internal to the formats room.

#include <filesystem>
#include <optional>
#include <string>

#include "drt/formats/yaml_tree.h"
#include "drt/scene/scene_fields.h"
#include "drt/scene/scene_path.h"

namespace drt {

/// More than that many faults are counted, not shown; and no time is spent on suggestions for them.
inline constexpr std::size_t most_messages = 100;

/// Where a value is read from and what is to be noted about it.
struct YamlContext {
    const YamlTree& tree;
    std::filesystem::path directory;  ///< of the file, for the files it names
    SourceMap& sources;
    Diagnostics& out;

    void error(const YamlNode& at, std::string message, std::string text = {}, std::string expected = {},
               std::string suggestion = {});
    /// "radius is a list" for a node whose kind is wrong.
    void wrong_kind(const YamlNode& at, const FieldInfo&, std::string expected);
    /// The candidate that was probably meant by a word that is none of them.
    std::string suggest(const std::string& word, const std::vector<std::string_view>& candidates) const;
    /// Notes the place of something that is made of several values.
    void note_place(const ScenePath&, const YamlNode&);
    /// Notes the place of a single value. False, and an error, when another file has set it already.
    bool note_value(const ScenePath&, const YamlNode&);
};

// Each sets `value` and returns true, or reports what is wrong. Ranges are validate()'s business: the places of the
// values are noted, so it can point at them.
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, double& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, int& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, std::uint32_t& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, bool& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, std::string& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, Vec3d& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, Color& value);
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, Quatd& value);

/// The word of a closed set that a node holds, by number.
std::optional<std::size_t> read_word(YamlContext&, const YamlNode&, const FieldInfo&,
                                     const std::vector<std::string_view>& words);

/// "a, b, c"
std::string join(const std::vector<std::string_view>& words);

}  // namespace drt
