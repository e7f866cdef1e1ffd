// Files of simulation programs: headings are text, and the numbers below them text or bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {

enum class NumberForm { Text, LittleEndian, BigEndian };

/// Walks over words of text and numbers of either form. A copy goes on from the same place, on its own.
class MixedReader {
 public:
  explicit MixedReader(std::span<const std::byte> file) : file_(file), text_(file, {}) {}
  void set_form(NumberForm form) { form_ = form; }
  NumberForm form() const { return form_; }

  /// Words, whatever the form of the numbers; empty at the end of the file, or of the line.
  std::string_view word() { return text_.next(); }
  std::string_view word_in_line() { return text_.next_in_line(); }
  /// Goes past the end of the line, after which the bytes of a heading's numbers begin; false at the end of the file.
  bool end_line() { return text_.next_line(); }
  /// Goes past the first place where this text is; false where it is nowhere.
  bool pass(std::string_view text);

  /// The next integer, or the next three coordinates, each rounded once. Where the form is bytes a number has `size` of
  /// them, 4 or 8. Errors  Input: the end of the file, no number, or beyond the range of float.
  Result<std::int64_t> integer(std::size_t size);
  Result<Vec3f> point(std::size_t size);
  /// The next word of a heading, which is a number from 0.
  Result<std::uint64_t> count_in_line(const char* what);
  Result<void> skip(std::uint64_t count, std::size_t size);

  /// Whether the rest of the file can hold so many rows of `values` numbers that take `bytes` where they are bytes.
  /// Errors  Input: it cannot, with both numbers.
  Result<void> check_count(std::int64_t rows, std::uint64_t values, std::uint64_t bytes,
                           const char* what) const;

  bool at_end() const { return text_.at_end(); }
  std::string place() const;  // of the last number: "line 12" or "byte 345"

 private:
  Result<std::uint64_t> bits(std::size_t size);
  Result<float> coordinate(std::size_t size);
  std::size_t position() const { return begin_ + text_.position(); }
  void go_to(std::size_t position);

  std::span<const std::byte> file_;
  std::size_t begin_ = 0;  // of text_ in the file
  std::size_t lines_ = 0;  // before it
  std::size_t last_ = 0;   // begin of the last number that was bytes
  TextCursor text_;
  NumberForm form_ = NumberForm::Text;
};

}  // namespace weft::mesh
