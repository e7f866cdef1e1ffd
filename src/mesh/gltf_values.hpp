// Values of a glTF document, each checked before it is used.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "base/result.hpp"

namespace weft::mesh {

/// The largest index that a document may name.
inline constexpr std::uint64_t kMostIndex = 0xFFFFFFFF;

/// The whole number `name` of the object at `path`, from 0 to `most`; `otherwise` where it is not given.
/// Errors  Input: its path, what it is and what it must be.
Result<std::uint64_t> whole_number(const Json& object, const std::string& path, const char* name,
                                   std::uint64_t most, std::optional<std::uint64_t> otherwise = {});

/// The `count` numbers of the list `name`; empty where it is not given.
Result<std::vector<double>> numbers(const Json& object, const std::string& path, const char* name,
                                    std::size_t count);

/// The entries of the list `name`; none where it is not given.
Result<const std::vector<Json>*> entries(const Json& object, const std::string& path, const char* name);

/// Entry `index` of the document's list `list`, an object; `who` names it, for the message.
Result<const Json*> entry(const Json& document, const char* list, std::uint64_t index,
                          const std::string& who);

}  // namespace weft::mesh
