#pragma once
// Words and braces of a legacy scene, each with its place. The format is blank-separated words; braces may touch the
// word before or after them; there are no comments and no quoting (thesis, appendix 1, "Nastavení scény").

#include <string_view>

#include "drt/base/diagnostic.h"

namespace drt {

struct LegacyToken {
    enum class Kind { word, open, close, end };
    Kind kind = Kind::end;
    std::string_view text;     ///< into the text that was given to the stream
    int line = 1, column = 1;  ///< from 1; columns count characters (UTF-8 code points), a tab is one
};

/// A forward stream with one token of look-ahead. The text must outlive it. Costs nothing but the pass over the text.
class LegacyTokens {
public:
    explicit LegacyTokens(std::string_view text);
    const LegacyToken& peek() const { return ahead_; }
    LegacyToken next();
    /// Drops all that is left.
    void stop();
    /// Drops what is left of the line that `peek()` is on, if it is still on `line`.
    void skip_line(int line);

private:
    struct Cursor {
        size_t offset = 0;
        int line = 1, column = 1;
        void step(std::string_view text);
    };
    LegacyToken scan();

    std::string_view text_;
    Cursor at_;
    LegacyToken ahead_;
};

}  // namespace drt
