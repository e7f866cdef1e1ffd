#include "mesh/mixed_reader.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>

#include "mesh/number.hpp"

namespace weft::mesh {

void MixedReader::go_to(std::size_t position) {
  lines_ += text_.line() - 1;
  begin_ = position;
  text_ = TextCursor(file_.subspan(position), {});
}

bool MixedReader::pass(std::string_view text) {
  const std::string_view rest(reinterpret_cast<const char*>(file_.data()) + position(),
                              file_.size() - position());
  const std::size_t found = rest.find(text);
  if (found == std::string_view::npos) return false;
  const std::size_t end = position() + found + text.size();
  if (form_ != NumberForm::Text) {
    go_to(end);
    return true;
  }
  while (position() < end && text_.next_line()) {
  }  // line by line, to count them
  return true;
}

std::string MixedReader::place() const {
  if (form_ == NumberForm::Text) return "line " + std::to_string(lines_ + text_.line());
  return "byte " + std::to_string(last_);
}

Result<std::uint64_t> MixedReader::bits(std::size_t size) {
  const std::size_t at = position();
  if (file_.size() - at < size)
    return input_error("The file ends at byte %zu, before its data are complete.", file_.size());
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t shift = 8 * (form_ == NumberForm::BigEndian ? size - 1 - i : i);
    value |= std::to_integer<std::uint64_t>(file_[at + i]) << shift;
  }
  last_ = at;
  go_to(at + size);
  return value;
}

Result<std::int64_t> MixedReader::integer(std::size_t size) {
  if (form_ != NumberForm::Text) {
    WEFT_TRY(value, bits(size));
    if (size == 4) return std::int64_t{static_cast<std::int32_t>(static_cast<std::uint32_t>(value))};
    return static_cast<std::int64_t>(value);
  }
  const std::string_view word = text_.next();
  if (word.empty()) return input_error("The file ends on %s, before its data are complete.", place().c_str());
  if (const auto value = parse_integer(word)) return *value;
  return input_error("The value \"%s\" on %s is not an integer.", quoted(word).c_str(), place().c_str());
}

Result<float> MixedReader::coordinate(std::size_t size) {
  float value = 0;
  if (form_ == NumberForm::Text) {
    const std::string_view word = text_.next();
    if (word.empty())
      return input_error("The file ends on %s, before its data are complete.", place().c_str());
    const auto parsed = parse_float(word);
    if (!parsed)
      return input_error("The coordinate \"%s\" on %s is not a finite number.", quoted(word).c_str(),
                         place().c_str());
    value = *parsed;
  } else {
    WEFT_TRY(loaded, bits(size));
    const auto low = static_cast<std::uint32_t>(loaded);
    double wide = 0;
    std::memcpy(&value, &low, sizeof value);
    std::memcpy(&wide, &loaded, sizeof wide);
    if (size == 8)  // a double beyond float's range is undefined to convert
      value = std::abs(wide) <= static_cast<double>(FLT_MAX) ? static_cast<float>(wide) : INFINITY;
  }
  if (!std::isfinite(value))
    return input_error("The coordinate at %s is not finite in single precision, where the largest is %.8e.",
                       place().c_str(), static_cast<double>(FLT_MAX));
  return value;
}

Result<Vec3f> MixedReader::point(std::size_t size) {
  Vec3f point;
  for (int axis = 0; axis < 3; ++axis) {
    WEFT_TRY(value, coordinate(size));
    point[axis] = value;
  }
  return point;
}

Result<std::uint64_t> MixedReader::count_in_line(const char* what) {
  const std::string_view word = text_.next_in_line();
  const auto number = parse_integer(word);
  if (!number || *number < 0)
    return input_error("Line %zu has \"%s\" where the number of %s is due.", lines_ + text_.line(),
                       quoted(word).c_str(), what);
  return static_cast<std::uint64_t>(*number);
}

Result<void> MixedReader::skip(std::uint64_t count, std::size_t size) {
  if (form_ != NumberForm::Text) {
    if (count > (file_.size() - position()) / size)
      return input_error("The file ends at byte %zu, before its data are complete.", file_.size());
    go_to(position() + static_cast<std::size_t>(count) * size);
    return {};
  }
  for (; count > 0; --count)
    if (text_.next().empty())
      return input_error("The file ends on %s, before its data are complete.", place().c_str());
  return {};
}

Result<void> MixedReader::check_count(std::int64_t rows, std::uint64_t values, std::uint64_t bytes,
                                      const char* what) const {
  const std::uint64_t left = file_.size() - position();
  // A number of text takes a digit and a space, which the last lacks.
  const std::uint64_t most = form_ == NumberForm::Text ? (left + 1) / (2 * values) : left / bytes;
  if (rows >= 0 && static_cast<std::uint64_t>(rows) <= most) return {};
  return input_error("The file announces %lld %s at %s, but the %llu bytes after it hold from 0 to %llu.",
                     static_cast<long long>(rows), what, place().c_str(),
                     static_cast<unsigned long long>(left), static_cast<unsigned long long>(most));
}

}  // namespace weft::mesh
