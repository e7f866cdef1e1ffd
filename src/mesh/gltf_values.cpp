#include "mesh/gltf_values.hpp"

#include <cmath>

namespace weft::mesh {

Result<std::uint64_t> whole_number(const Json& object, const std::string& path, const char* name,
                                   std::uint64_t most, std::optional<std::uint64_t> otherwise) {
  const Json* value = object.find(name);
  const std::string key = path_of_key(path, name);
  if (value == nullptr) {
    if (otherwise) return *otherwise;
    return input_error("%s is missing.", key.c_str());
  }
  const double number = value->kind == Json::Kind::Number ? value->number : -1.0;
  if (!(number >= 0.0 && number <= static_cast<double>(most) && number == std::floor(number)))
    return input_error("%s is %s; it must be a whole number from 0 to %llu.", key.c_str(),
                       describe(*value).c_str(), static_cast<unsigned long long>(most));
  return static_cast<std::uint64_t>(number);
}

Result<std::vector<double>> numbers(const Json& object, const std::string& path, const char* name,
                                    std::size_t count) {
  std::vector<double> result;
  const Json* list = object.find(name);
  if (list == nullptr) return result;
  bool good = list->kind == Json::Kind::List && list->values.size() == count;
  for (std::size_t i = 0; good && i < count; ++i) {
    good = list->values[i].kind == Json::Kind::Number;
    result.push_back(list->values[i].number);
  }
  if (!good)
    return input_error("%s is %s; it must be a list of %zu numbers.", path_of_key(path, name).c_str(),
                       describe(*list).c_str(), count);
  return result;
}

Result<const std::vector<Json>*> entries(const Json& object, const std::string& path, const char* name) {
  static const std::vector<Json> kNone;
  const Json* list = object.find(name);
  if (list == nullptr) return &kNone;
  if (list->kind != Json::Kind::List)
    return input_error("%s is %s; it must be a list.", path_of_key(path, name).c_str(),
                       describe(*list).c_str());
  return &list->values;
}

Result<const Json*> entry(const Json& document, const char* list, std::uint64_t index,
                          const std::string& who) {
  WEFT_TRY(all, entries(document, "", list));
  if (index >= all->size())
    return input_error("%s is %llu, but the file has %zu %s.", who.c_str(),
                       static_cast<unsigned long long>(index), all->size(), list);
  const Json& found = (*all)[static_cast<std::size_t>(index)];
  if (found.kind != Json::Kind::Object)
    return input_error("%s is %s; it must be an object.",
                       path_of_index(list, static_cast<std::size_t>(index)).c_str(), describe(found).c_str());
  return &found;
}

}  // namespace weft::mesh
