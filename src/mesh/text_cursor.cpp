#include "mesh/text_cursor.hpp"

#include <cfloat>
#include <cmath>

#include "mesh/number.hpp"

namespace weft::mesh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

TextCursor::TextCursor(std::span<const std::byte> bytes, Rules rules)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), rules_(rules) {}

std::size_t TextCursor::line_end_size(std::size_t at) const {
  if (at >= text_.size() || !is_line_end(text_[at])) return 0;
  return text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1;
}

bool TextCursor::skip_blank() {
  if (at_end()) return false;
  if (is_blank(text_[at_])) {
    ++at_;
    return true;
  }
  if (!rules_.continuations || text_[at_] != '\\') return false;
  const std::size_t size = line_end_size(at_ + 1);
  if (size == 0) return false;
  at_ += 1 + size;
  ++line_;
  return true;
}

std::string_view TextCursor::next_in_line() {
  while (skip_blank()) {
  }
  if (at_end()) return {};
  if (rules_.comments && text_[at_] == '#') {
    while (!at_end() && !is_line_end(text_[at_])) ++at_;
    return {};
  }
  const std::size_t begin = at_;
  while (!at_end() && !is_blank(text_[at_]) && !is_line_end(text_[at_])) {
    if (rules_.continuations && text_[at_] == '\\' && line_end_size(at_ + 1) != 0) break;
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

std::string_view TextCursor::next() {
  while (true) {
    const std::string_view word = next_in_line();
    if (!word.empty() || !next_line()) return word;
  }
}

bool TextCursor::next_line() {
  while (!at_end() && !is_line_end(text_[at_])) {
    if (!skip_blank()) ++at_;  // a continued line is one line
  }
  at_ += line_end_size(at_);
  if (at_end()) return false;
  ++line_;
  return true;
}

bool TextCursor::next_filled_line() {
  while (next_line()) {
    TextCursor probe = *this;
    if (!probe.next_in_line().empty()) return true;
  }
  return false;
}

Result<Vec3f> read_point(TextCursor& cursor) {
  Vec3f point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = cursor.next_in_line();
    if (word.empty()) return input_error("Line %zu has %d coordinates, fewer than 3.", cursor.line(), axis);
    const auto value = parse_float(word);
    if (!value)
      return input_error("Line %zu has the coordinate \"%s\", which is not a finite number.", cursor.line(),
                         quoted(word).c_str());
    if (!std::isfinite(*value))
      return input_error("Line %zu has the coordinate %s, beyond the largest of single precision, %.8e.",
                         cursor.line(), quoted(word).c_str(), static_cast<double>(FLT_MAX));
    point[axis] = *value;
  }
  return point;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kMaxSize = 40;
  std::string text(word.substr(0, kMaxSize));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  if (word.size() > kMaxSize) text += "...";
  return text;
}

bool same_word(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (lower(a[i]) != lower(b[i])) return false;
  return true;
}

}  // namespace weft::mesh
