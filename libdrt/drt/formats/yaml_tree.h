#pragma once
// YAML text as a tree whose every node knows its place. Internal to the formats room; only yaml_tree.cpp knows the
// YAML library. The tree is safe to walk recursively whatever the text was: at most 64 levels deep, without cycles,
// at most 1e7 nodes with every alias counted as often as it is used.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "drt/base/diagnostic.h"

namespace drt {

struct YamlNode {
    enum class Kind : std::uint8_t { null, scalar, list, mapping };
    Kind kind = Kind::null;
    bool quoted = false;  ///< a scalar in quotes is a text, never a number
    int line = 0, column = 0;
    std::string text;                    ///< of a scalar
    std::vector<const YamlNode*> items;  ///< of a list; of a mapping: key, value, key, value, ... (keys are scalars)
};

struct YamlTree {
    std::string file;
    std::deque<YamlNode> nodes;
    const YamlNode* root = nullptr;  ///< null: there were errors, or nothing but comments
    Location place(const YamlNode& n) const { return {file, n.line, n.column}; }
};

/// The value of a mapping's key, or null.
const YamlNode* find_value(const YamlNode& mapping, std::string_view key);

/// Parses one file. What is wrong is added to `out`: encoding, syntax (the first fault only, as all behind it is
/// guesswork), duplicate keys, aliases without end, tags, merge keys, a second document.
YamlTree parse_yaml(const std::string& file, const std::string& text, Diagnostics& out);

}  // namespace drt
