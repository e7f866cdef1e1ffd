#include "scene/check.hpp"

#include <algorithm>
#include <cmath>

#include "scene/nearest.hpp"

namespace weft::scene {
namespace {

/// How a message names what a type accepts.
std::string expected(const Type& type) {
  std::string text;
  switch (type.kind) {
    case Type::Kind::Truth:
      return "true or false";
    case Type::Kind::Text:
      return "a text";
    case Type::Kind::Number:
      return type.whole ? "a whole number" : "a number";
    case Type::Kind::Numbers:
      return "a list of " + std::to_string(type.count_least) + " numbers";
    case Type::Kind::List:
      return "a list";
    case Type::Kind::Tuple:
      return "a list of " + std::to_string(type.types.size());
    case Type::Kind::Object:
      return "an object";
    case Type::Kind::Choice:
      for (const char* choice : type.choices) text += (text.empty() ? "" : ", ") + in_quotes(choice);
      return (type.choices.size() == 1 ? "" : "one of ") + text;
    case Type::Kind::Either:
      for (const Type* one : type.types) text += (text.empty() ? "" : ", or ") + expected(*one);
      return text;
  }
  return text;
}

class Checker {
 public:
  explicit Checker(const std::string& file) : file_(file) {}

  Result<void> value(Json& json, const Type& type, const std::string& path) const {
    if (type.kind == Type::Kind::Either) {
      for (const Type* one : type.types)
        if (json_kind(*one) == json.kind) return value(json, *one, path);
      return mismatch(json, type, path);
    }
    if (json_kind(type) != json.kind) return mismatch(json, type, path);
    switch (type.kind) {
      case Type::Kind::Text:
        return text(json, type, path);
      case Type::Kind::Choice:
        return choice(json, type, path);
      case Type::Kind::Number:
        return number(json.number, type, path);
      case Type::Kind::Numbers:
        return numbers(json, type, path);
      case Type::Kind::List:
        return list(json, type, path);
      case Type::Kind::Tuple:
        return tuple(json, type, path);
      case Type::Kind::Object:
        return object(json, type, path);
      case Type::Kind::Truth:
      case Type::Kind::Either:
        break;
    }
    return {};
  }

 private:
  Error wrong(const std::string& path, const std::string& what) const {
    return input_error("%s: %s %s%s", file_.c_str(), path.empty() ? "the scene" : path.c_str(), what.c_str(),
                       what.back() == '?' ? "" : ".");
  }
  Error mismatch(const Json& json, const Type& type, const std::string& path) const {
    return wrong(path, "is " + describe(json) + ", not " + expected(type));
  }

  Result<void> text(const Json& json, const Type& type, const std::string& path) const {
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };  // of UTF-8
    const auto count = static_cast<std::size_t>(std::count_if(json.text.begin(), json.text.end(), starts));
    if (count < type.count_least || count > type.count_most)
      return wrong(path, "has " + std::to_string(count) + " characters; it must have from " +
                             std::to_string(type.count_least) + " to " + std::to_string(type.count_most));
    return {};
  }

  Result<void> choice(const Json& json, const Type& type, const std::string& path) const {
    const std::vector<std::string_view> words(type.choices.begin(), type.choices.end());
    if (std::find(words.begin(), words.end(), json.text) != words.end()) return {};
    const std::string_view near = nearest(json.text, words);
    return wrong(path, "is " + in_quotes(json.text) + ", not " + expected(type) +
                           (near.empty() ? "" : "; did you mean " + in_quotes(near) + "?"));
  }

  Result<void> number(double number, const Type& type, const std::string& path) const {
    if (type.whole && number != std::floor(number))
      return wrong(path, "is " + number_text(number) + ", not a whole number");
    if (!(number >= type.least && number <= type.most))
      return wrong(path, "is " + number_text(number) + "; it must be from " + number_text(type.least) +
                             " to " + number_text(type.most) + (*type.unit ? " " : "") + type.unit);
    return {};
  }

  Result<void> numbers(const Json& json, const Type& type, const std::string& path) const {
    if (json.values.size() != type.count_least) return mismatch(json, type, path);
    double sum = 0;  // of squares
    bool all_zero = true;
    for (std::size_t k = 0; k < json.values.size(); ++k) {
      const Json& part = json.values[k];
      if (part.kind != Json::Kind::Number)
        return wrong(path_of_index(path, k),
                     "is " + describe(part) + ", not " + (type.whole ? "a whole number" : "a number"));
      WEFT_CHECK(number(part.number, type, path_of_index(path, k)));
      sum += part.number * part.number;
      all_zero = all_zero && part.number == 0;
    }
    if (type.rule == Type::Rule::NonZero && all_zero) return wrong(path, "is zero, and so has no direction");
    if (type.rule == Type::Rule::Unit && std::abs(std::sqrt(sum) - 1) > kUnitTolerance)
      return wrong(path, "has length " + number_text(std::sqrt(sum)) + "; a unit quaternion's is within " +
                             number_text(kUnitTolerance) + " of 1");
    return {};
  }

  Result<void> list(Json& json, const Type& type, const std::string& path) const {
    const std::size_t count = json.values.size();
    if (count < type.count_least || count > type.count_most)
      return wrong(path, "has " + std::to_string(count) + " entries; it must have from " +
                             std::to_string(type.count_least) + " to " + std::to_string(type.count_most));
    for (std::size_t k = 0; k < count; ++k)
      WEFT_CHECK(value(json.values[k], *type.types[0], path_of_index(path, k)));
    return {};
  }

  Result<void> tuple(Json& json, const Type& type, const std::string& path) const {
    if (json.values.size() != type.types.size()) return mismatch(json, type, path);
    for (std::size_t k = 0; k < type.types.size(); ++k)
      WEFT_CHECK(value(json.values[k], *type.types[k], path_of_index(path, k)));
    return {};
  }

  Result<void> object(Json& json, const Type& type, const std::string& path) const {
    const std::vector<const Key*> keys = keys_of(type, json);
    for (const std::string& name : json.names) WEFT_CHECK(known(name, keys, path));
    for (const OneOf& rule : type.one_of) WEFT_CHECK(exactly_one(json, rule, path));
    const Json* kind = json.find("kind");
    for (const Variant& variant : type.variants)
      if (kind && kind->kind == Json::Kind::Text && kind->text == variant.value)
        for (const OneOf& rule : variant.one_of) WEFT_CHECK(exactly_one(json, rule, path));
    for (const Needs& rule : type.needs)
      if (json.find(rule.key) && !json.find(rule.needed))
        return wrong(path_of_key(path, rule.key), "needs " + in_quotes(rule.needed) + " beside it");
    for (const Key* key : keys) {
      if (!json.find(key->name)) {
        if (names_fabric(json, key->named)) continue;
        if (key->required)
          return wrong(path_of_key(path, key->name), "is missing; it must be " + expected(*key->type));
        if (!key->fallback) continue;
        WEFT_TRY(fallback, parse_json(key->fallback, file_));
        json.add(key->name, std::move(fallback));
      }
      WEFT_CHECK(value(*json.find(key->name), *key->type, path_of_key(path, key->name)));
    }
    return {};
  }

  Result<void> known(const std::string& name, const std::vector<const Key*>& keys,
                     const std::string& path) const {
    std::vector<std::string_view> names;
    for (const Key* key : keys) names.push_back(key->name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return {};
    const std::string_view near = nearest(name, names);
    if (!near.empty())
      return wrong(path_of_key(path, name), "is not known; did you mean " + in_quotes(near) + "?");
    std::string all;
    for (const std::string_view one : names) all += (all.empty() ? "" : ", ") + in_quotes(one);
    return wrong(path_of_key(path, name), "is not known; the keys here are " + all);
  }

  Result<void> exactly_one(const Json& json, const OneOf& rule, const std::string& path) const {
    std::vector<std::string> present;
    std::string all;
    for (const char* key : rule.keys) {
      if (json.find(key)) present.push_back(in_quotes(key));
      all += (all.empty() ? "" : " nor ") + in_quotes(key);
    }
    if (present.size() == 1 || (present.empty() && names_fabric(json, rule.named))) return {};
    if (present.empty()) return wrong(path, "has neither " + all + "; it must have one of them");
    return wrong(path, "has both " + present[0] + " and " + present[1] + "; it must have one of them");
  }

  const std::string& file_;
};

}  // namespace

Json::Kind json_kind(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Truth:
      return Json::Kind::Boolean;
    case Type::Kind::Text:
    case Type::Kind::Choice:
      return Json::Kind::Text;
    case Type::Kind::Number:
      return Json::Kind::Number;
    case Type::Kind::Numbers:
    case Type::Kind::List:
    case Type::Kind::Tuple:
      return Json::Kind::List;
    case Type::Kind::Object:
    case Type::Kind::Either:
      break;
  }
  return Json::Kind::Object;
}

bool names_fabric(const Json& object, const char* key) {
  const Json* value = key ? object.find(key) : nullptr;
  return value && (value->kind == Json::Kind::Text || value->find("name"));
}

std::vector<const Key*> keys_of(const Type& type, const Json& json) {
  std::vector<const Key*> keys;
  for (const Key& key : type.keys) keys.push_back(&key);
  if (type.variants.empty()) return keys;
  const Json* given = json.find("kind");
  std::string kind = given && given->kind == Json::Kind::Text ? in_quotes(given->text) : "";
  for (const Key* key : keys)
    if (!given && key->name == std::string_view("kind") && key->fallback) kind = key->fallback;
  const auto named = [&](const Variant& variant) { return kind == in_quotes(variant.value); };
  const bool any = std::none_of(type.variants.begin(), type.variants.end(), named);
  for (const Variant& variant : type.variants)
    if (any || named(variant))
      for (const Key& key : variant.keys) keys.push_back(&key);
  return keys;
}

Result<void> check(Json& json, const Type& type, const std::string& file, const std::string& path) {
  return Checker(file).value(json, type, path);
}

}  // namespace weft::scene
