#pragma once
// The values of attributes: words of a legacy file -> numbers, vectors, names; and the way back onto firm ground where
// they are not what they should be.

#include <optional>
#include <string>
#include <string_view>

#include "drt/base/vec.h"
#include "drt/formats/legacy_report.h"
#include "drt/formats/legacy_table.h"
#include "drt/formats/legacy_tokens.h"

namespace drt {

/// A file that is being parsed.
struct LegacyInput {
    LegacyTokens tokens;
    LegacyReport& report;
    size_t skipped = 0;  ///< tokens, over the whole file
};

inline LegacyPlace place_of(const LegacyToken& t) { return {t.line, t.column}; }

/// The next token, of no use. Recovery from errors gives up on files that are nothing but nonsense.
LegacyToken skip_token(LegacyInput&);
/// All up to the brace that closes the one just read.
void skip_block(LegacyInput&);

/// The word ahead is an attribute of the element, or another element.
bool begins_something(const LegacyInput&, const LegacyElementType&);

/// The value of attribute `a` of an element, which the file calls `name`. Nothing, and an error in the report, where it
/// is missing, of another kind or out of range; -1 passes where it stands for the fallback.
std::optional<double> read_legacy_number(LegacyInput&, const LegacyElementType&, const LegacyAttribute& a,
                                         const LegacyToken& name);
std::optional<Vec3d> read_legacy_vector(LegacyInput&, const LegacyElementType&, const LegacyAttribute& a,
                                        const LegacyToken& name);
std::optional<std::string_view> read_legacy_word(LegacyInput&, const LegacyElementType&, const LegacyAttribute& a,
                                                 const LegacyToken& name);

/// `radius 4 5`, `position { 1 2 3 } 4`: a number is never the name of an attribute.
void refuse_more_numbers(LegacyInput&, const LegacyAttribute&);

}  // namespace drt
