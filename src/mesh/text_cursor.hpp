// Words and lines of a text in memory, for the readers of mesh files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "base/vec.hpp"

namespace weft::mesh {

/// Walks over a text word by word. Lines end with LF, CR LF or CR; words are separated by white space.
class TextCursor {
 public:
  struct Rules {
    bool comments = false;       // a word that begins with # ends the line
    bool continuations = false;  // a backslash at its end joins a line to the next
  };
  TextCursor(std::span<const std::byte> bytes, Rules rules);

  /// The next word of this line; empty at its end.
  std::string_view next_in_line();
  /// The next word of the text; empty at its end.
  std::string_view next();
  /// Goes to the begin of the next line; false at the end of the text.
  bool next_line();
  /// Goes to the begin of the next line that has a word; false at the end of the text.
  bool next_filled_line();

  bool at_end() const { return at_ == text_.size(); }
  std::size_t remaining() const { return text_.size() - at_; }  // bytes
  std::size_t position() const { return at_; }                  // bytes
  std::size_t line() const { return line_; }                    // from 1

 private:
  std::size_t line_end_size(std::size_t at) const;
  bool skip_blank();

  std::string_view text_;
  Rules rules_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// The first three numbers of the rest of a line.
/// Errors  Input: fewer than three, no numbers, or beyond the range of float.
Result<Vec3f> read_point(TextCursor& cursor);

/// A word for a message: at most 40 characters, and only printable ones.
std::string quoted(std::string_view word);

/// Whether two words are equal, capitals apart.
bool same_word(std::string_view a, std::string_view b);

}  // namespace weft::mesh
