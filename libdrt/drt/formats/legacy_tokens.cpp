#include "drt/formats/legacy_tokens.h"

namespace drt {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }
bool is_brace(char c) { return c == '{' || c == '}'; }

}  // namespace

LegacyTokens::LegacyTokens(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    ahead_ = scan();
}

LegacyToken LegacyTokens::next() {
    const LegacyToken token = ahead_;
    ahead_ = scan();
    return token;
}

void LegacyTokens::skip_line(int line) {
    while (ahead_.kind != LegacyToken::Kind::end && ahead_.line == line) ahead_ = scan();
}

void LegacyTokens::step() {
    const char c = text_[at_++];
    // A line ends at LF, CR LF or a lone CR (old Macintosh files).
    if (c == '\n' || (c == '\r' && (at_ == text_.size() || text_[at_] != '\n'))) {
        ++line_;
        column_ = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {  // not a UTF-8 continuation byte
        ++column_;
    }
}

LegacyToken LegacyTokens::scan() {
    while (at_ < text_.size() && is_blank(text_[at_])) step();
    LegacyToken token{LegacyToken::Kind::end, {}, line_, column_};
    if (at_ == text_.size()) return token;
    const size_t begin = at_;
    if (is_brace(text_[at_])) {
        token.kind = text_[at_] == '{' ? LegacyToken::Kind::open : LegacyToken::Kind::close;
        step();
    } else {
        token.kind = LegacyToken::Kind::word;
        while (at_ < text_.size() && !is_blank(text_[at_]) && !is_brace(text_[at_])) step();
    }
    token.text = text_.substr(begin, at_ - begin);
    return token;
}

}  // namespace drt
