// Numbers from and to text, the same under every locale. (libc++ has no from_chars or to_chars for float.)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::mesh {

/// The number nearest to a decimal such as "-1.5e-3"; infinite if it is too large for the type, nothing if
/// the word is no decimal number ("nan", "inf" and hexadecimal are none).
std::optional<float> parse_float(std::string_view word);
std::optional<double> parse_double(std::string_view word);

/// An integer with an optional sign; nothing if the word is none or does not fit.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// Appends the shortest decimal that parse_float reads back to the same bits. The value must be finite.
void append_float(std::string& text, float value);

void append_integer(std::string& text, std::uint64_t value);

}  // namespace weft::mesh
