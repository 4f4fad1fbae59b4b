#include "drt/formats/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <unordered_map>

#include "drt/formats/text_file.h"
#include "drt/formats/yaml_text.h"

namespace drt {
namespace {

constexpr int deepest = 64;
constexpr std::uint64_t most_nodes = 10'000'000;

struct Stop {};  // thrown out of the parser after a fault that makes going on useless; the fault is reported

// yaml-cpp's events instead of its YAML::Node: those know neither the place of every key nor duplicate keys, take ten
// times the memory, and follow aliases into themselves.
class TreeBuilder : public YAML::EventHandler {
public:
    TreeBuilder(YamlTree& tree, std::string_view text, Diagnostics& out) : tree_(tree), text_(text), out_(out) {}

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ == 0) return;
        error(mark, "a second document starts here", snippet(text_, offset(mark)),
              "one document; are lines indented as those above?");
        throw Stop{};
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        YamlNode& node = add(mark, YamlNode::Kind::null);
        // the mark of an absent value is that of whatever comes next
        if (awaits_value()) place_at(node, *open_.back().node->items.back());
        attach(node, {1, 0}, anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        YamlNode& node = add(mark, YamlNode::Kind::scalar);
        node.text = value;
        node.quoted = tag == "!";
        if (node.quoted)
            check_quotes(mark);
        else
            check_tag(mark, tag);
        attach(node, {1, 0}, anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchored_.find(anchor);
        if (found == anchored_.end()) {  // yaml-cpp knows the anchor, so its node is still open: &a [*a]
            error(mark, "an alias of the very list or mapping that it stands in", word_at(text_, offset(mark)),
                  "an alias of something complete");
            throw Stop{};
        }
        if (int(open_.size()) + found->second.size.height > deepest) too_deep(mark);
        attach(*found->second.node, found->second.size, 0, &mark);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        begin(mark, tag, anchor, YamlNode::Kind::list);
    }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        begin(mark, tag, anchor, YamlNode::Kind::mapping);
    }
    void OnSequenceEnd() override { end(); }
    void OnMapEnd() override {
        check_keys(*open_.back().node);
        end();
    }

    void syntax_error(const YAML::ParserException& e);

private:
    struct Size {
        std::uint64_t nodes = 1;  // with aliases counted as what they stand for
        int height = 0;
    };
    struct Open {
        YamlNode* node;
        YAML::anchor_t anchor;
        Size size;
    };
    struct Anchored {
        const YamlNode* node;
        Size size;
    };

    void error(const YAML::Mark& mark, std::string message, std::string text, std::string expected) {
        out_.push_back({Severity::error, place(mark), std::move(message), std::move(text), std::move(expected), {}});
    }
    void error_at(const YamlNode& node, std::string message, std::string text, std::string expected) {
        out_.push_back(
            {Severity::error, tree_.place(node), std::move(message), std::move(text), std::move(expected), {}});
    }
    void too_deep(const YAML::Mark& mark) {
        error(mark, "nesting too deep", snippet(text_, offset(mark)), "at most 64 levels");
        throw Stop{};
    }

    std::size_t offset(const YAML::Mark& mark) const {
        return std::min(std::size_t(std::max(mark.pos, 0)), text_.size());
    }

    // yaml-cpp counts columns in bytes; people count characters.
    Location place(const YAML::Mark& mark) const {
        int column = mark.column + 1;
        if (mark.column < 10000)  // do not walk a line of megabytes once for each of its values
            for (std::size_t i = offset(mark) - std::min(offset(mark), std::size_t(std::max(mark.column, 0)));
                 i < offset(mark); ++i)
                column -= (static_cast<unsigned char>(text_[i]) & 0xc0) == 0x80;
        return {tree_.file, mark.line + 1, column};
    }

    static void place_at(YamlNode& node, const YamlNode& other) {
        node.line = other.line;
        node.column = other.column;
    }

    bool awaits_value() const {
        return !open_.empty() && open_.back().node->kind == YamlNode::Kind::mapping &&
               open_.back().node->items.size() % 2 == 1;
    }

    YamlNode& add(const YAML::Mark& mark, YamlNode::Kind kind) {
        YamlNode& node = tree_.nodes.emplace_back();
        node.kind = kind;
        const Location at = place(mark);
        node.line = at.line;
        node.column = at.column;
        return node;
    }

    // Makes a finished node the next item of the innermost open one.
    void attach(const YamlNode& node, Size size, YAML::anchor_t anchor, const YAML::Mark* alias = nullptr) {
        if (anchor) anchored_[anchor] = {&node, size};
        if (open_.empty()) {
            tree_.root = &node;
            return;
        }
        Open& parent = open_.back();
        parent.node->items.push_back(&node);
        parent.size.nodes += size.nodes;
        parent.size.height = std::max(parent.size.height, size.height + 1);
        if (parent.size.nodes <= most_nodes) return;
        const std::string expected = "at most 1e7 values, those of aliases counted each time";
        if (alias)
            error(*alias, "too many values", word_at(text_, offset(*alias)), expected);
        else
            error_at(node, "too many values", {}, expected);
        throw Stop{};
    }

    void begin(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
        if (int(open_.size()) >= deepest) too_deep(mark);
        check_tag(mark, tag);
        open_.push_back({&add(mark, kind), anchor, {1, 0}});
    }

    void end() {
        const Open done = open_.back();
        open_.pop_back();
        attach(*done.node, done.size, done.anchor);
    }

    void check_tag(const YAML::Mark& mark, const std::string& tag) {
        if (tag != "?" && tag != "!" && !tag.empty())
            error(mark, "tags are not supported", word_at(text_, offset(mark)), "a value without a tag");
    }

    void check_keys(const YamlNode& mapping);
    void check_quotes(const YAML::Mark& mark);

    YamlTree& tree_;
    std::string_view text_;
    Diagnostics& out_;
    int documents_ = 0;
    std::vector<Open> open_;
    std::unordered_map<YAML::anchor_t, Anchored> anchored_;
    Location long_quote_;  // the last text in quotes that goes over several lines
};

void TreeBuilder::check_keys(const YamlNode& mapping) {
    std::unordered_map<std::string_view, const YamlNode*> seen;
    for (std::size_t i = 0; i + 1 < mapping.items.size(); i += 2) {
        const YamlNode& key = *mapping.items[i];
        if (key.kind != YamlNode::Kind::scalar) {
            error_at(key, "a key that is not a word", {}, "a word");
        } else if (key.text == "<<" && !key.quoted) {
            error_at(key, "merge keys are not supported", "<<", "the keys themselves");
        } else if (const auto [it, is_new] = seen.try_emplace(key.text, &key); !is_new) {
            error_at(key, "duplicate key", printable(key.text),
                     "it once; it was first used in line " + std::to_string(it->second->line));
        }
    }
}

// yaml-cpp takes the end of the file for a closing quote.
void TreeBuilder::check_quotes(const YAML::Mark& mark) {
    std::size_t begin = offset(mark);
    while (begin < text_.size() && (text_[begin] == '&' || text_[begin] == '!'))  // over anchor and tag
        begin = std::min(text_.find_first_not_of(" \r\n", text_.find_first_of(" \r\n", begin)), text_.size());
    if (begin >= text_.size() || (text_[begin] != '"' && text_[begin] != '\'')) return;  // a block scalar
    const char quote = text_[begin];
    for (std::size_t i = begin + 1; i < text_.size(); ++i) {
        if (text_[i] == '\n') long_quote_ = place(mark);
        if (quote == '"' && text_[i] == '\\') {
            ++i;
        } else if (text_[i] == quote) {
            if (quote == '"' || i + 1 >= text_.size() || text_[i + 1] != quote) return;
            ++i;  // '' within single quotes
        }
    }
    error(mark, "a quote that is never closed", snippet(text_, offset(mark)), std::string("a closing ") + quote);
    throw Stop{};
}

struct SyntaxHelp {
    std::string_view yaml_cpp;  // what yaml-cpp says
    const char* message;
    const char* expected;
};

constexpr const char* one_pair = "`key: value`, each on its own line, indented as its neighbours";
const SyntaxHelp syntax_help[] = {
    {YAML::ErrorMsg::END_OF_MAP, "a mapping does not go on like this", one_pair},
    {YAML::ErrorMsg::MAP_VALUE, "a value cannot begin here", one_pair},
    {YAML::ErrorMsg::MAP_KEY, "a key cannot begin here", one_pair},
    {YAML::ErrorMsg::END_OF_SEQ, "a list does not go on like this", "`- item`, indented as the items above"},
    {YAML::ErrorMsg::BLOCK_ENTRY, "a list item cannot begin here", "`- item` on a line of its own"},
    {YAML::ErrorMsg::END_OF_SEQ_FLOW, "a list in brackets does not go on like this", "',' or ']'"},
    {YAML::ErrorMsg::END_OF_MAP_FLOW, "a mapping in braces does not go on like this", "',' or '}'"},
    {YAML::ErrorMsg::FLOW_END, "a closing bracket without an opening one", "a value"},
    {YAML::ErrorMsg::EOF_IN_SCALAR, "a quote that is never closed", "a closing quote"},
    {YAML::ErrorMsg::UNKNOWN_TOKEN, "no value can begin with this character", "the value in quotes"},
    {YAML::ErrorMsg::INVALID_ESCAPE, "an unknown escape in double quotes before this",
     "\\\\ for a backslash, or single quotes"},
    {YAML::ErrorMsg::UNKNOWN_ANCHOR, "an alias of nothing", "the name of an anchor above"},
};

void TreeBuilder::syntax_error(const YAML::ParserException& e) {
    const auto help = std::find_if(std::begin(syntax_help), std::end(syntax_help), [&](const SyntaxHelp& h) {
        return std::string_view(e.msg).starts_with(h.yaml_cpp);
    });
    if (help != std::end(syntax_help))
        error(e.mark, help->message, snippet(text_, offset(e.mark)), help->expected);
    else
        error(e.mark, "not YAML: " + e.msg, snippet(text_, offset(e.mark)), "YAML 1.2");
    if (long_quote_.line > 0)
        out_.push_back({Severity::note,
                        long_quote_,
                        "a text in quotes that starts here ends on a later line",
                        {},
                        "its closing quote on this line",
                        {}});
}

}  // namespace

const YamlNode* find_value(const YamlNode& mapping, std::string_view key) {
    for (std::size_t i = 0; i + 1 < mapping.items.size(); i += 2)
        if (mapping.items[i]->text == key) return mapping.items[i + 1];
    return nullptr;
}

YamlTree parse_yaml(const std::string& file, const std::string& raw, Diagnostics& out) {
    YamlTree tree{file, {}, nullptr};
    const std::string_view text = without_bom(raw);
    if (Diagnostics faults = check_yaml_text(file, text); !faults.empty()) {
        out.insert(out.end(), faults.begin(), faults.end());
        return tree;
    }
    TreeBuilder builder(tree, text, out);
    try {
        std::istringstream in{std::string(text)};
        YAML::Parser parser(in);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const Stop&) {
        tree.root = nullptr;
    } catch (const YAML::ParserException& e) {
        builder.syntax_error(e);
        tree.root = nullptr;
    }
    return tree;
}

}  // namespace drt
