#include "drt/formats/legacy_tokens.h"

namespace drt {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }
bool is_brace(char c) { return c == '{' || c == '}'; }

}  // namespace

void LegacyTokens::Cursor::step(std::string_view text) {
    const char c = text[offset++];
    // A line ends at LF, CR LF or a lone CR (old Macintosh files).
    if (c == '\n' || (c == '\r' && (offset == text.size() || text[offset] != '\n'))) {
        ++line;
        column = 1;
    } else {
        column += (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // not a UTF-8 continuation byte
    }
}

LegacyTokens::LegacyTokens(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_.offset = 3;
    ahead_ = scan();
}

LegacyToken LegacyTokens::next() {
    const LegacyToken token = ahead_;
    ahead_ = scan();
    return token;
}

void LegacyTokens::stop() {
    at_.offset = text_.size();
    ahead_ = {LegacyToken::Kind::end, {}, ahead_.line, ahead_.column};
}

void LegacyTokens::skip_line(int line) {
    while (ahead_.kind != LegacyToken::Kind::end && ahead_.line == line) ahead_ = scan();
}

LegacyToken LegacyTokens::scan() {
    Cursor c = at_;  // a local copy stays in registers: files may have 64 MB
    while (c.offset < text_.size() && is_blank(text_[c.offset])) c.step(text_);
    LegacyToken token{LegacyToken::Kind::end, {}, c.line, c.column};
    const size_t begin = c.offset;
    if (begin < text_.size() && is_brace(text_[begin])) {
        token.kind = text_[begin] == '{' ? LegacyToken::Kind::open : LegacyToken::Kind::close;
        c.step(text_);
    } else if (begin < text_.size()) {
        token.kind = LegacyToken::Kind::word;
        while (c.offset < text_.size() && !is_blank(text_[c.offset]) && !is_brace(text_[c.offset])) c.step(text_);
    }
    token.text = text_.substr(begin, c.offset - begin);
    at_ = c;
    return token;
}

}  // namespace drt
