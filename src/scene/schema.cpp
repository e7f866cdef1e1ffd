#include "scene/schema.hpp"

#include <nlohmann/json.hpp>

#include "scene/format.hpp"

namespace weft::scene {
namespace {

using Schema = nlohmann::ordered_json;

class Writer {
 public:
  /// The schema of a type: a reference if the type has a name, else the thing itself.
  Schema reference(const Type& type) {
    if (!type.name) return body(type);
    if (!definitions_.contains(type.name)) {
      definitions_[type.name] = nullptr;  // keeps the place, before the types inside
      Schema inner = body(type);
      definitions_[type.name] = std::move(inner);
    }
    return {{"$ref", std::string("#/$defs/") + type.name}};
  }

  Schema document() {
    Schema schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "weft-scene/1"}};
    schema.update(reference(scene_type()));
    schema["$defs"] = std::move(definitions_);
    return schema;
  }

 private:
  static Schema limit(double number) {
    const auto whole = static_cast<std::int64_t>(number);
    return static_cast<double>(whole) == number ? Schema(whole) : Schema(number);
  }
  static Schema words(std::span<const char* const> choices) {
    Schema list = Schema::array();
    for (const char* choice : choices) list.push_back(choice);
    return list;
  }

  Schema body(const Type& type) {
    switch (type.kind) {
      case Type::Kind::Truth:
        return {{"type", "boolean"}};
      case Type::Kind::Text:
        return {{"type", "string"}, {"minLength", type.count_least}, {"maxLength", type.count_most}};
      case Type::Kind::Choice:
        return {{"enum", words(type.choices)}};
      case Type::Kind::Number:
        return number(type);
      case Type::Kind::Numbers: {
        Schema schema = list(type.count_least, type.count_least);
        schema["items"] = number(type);
        if (type.rule == Type::Rule::NonZero) schema["not"] = {{"const", Schema::array({0, 0, 0})}};
        return schema;
      }
      case Type::Kind::List: {
        Schema schema = list(type.count_least, type.count_most);
        schema["items"] = reference(*type.types[0]);
        return schema;
      }
      case Type::Kind::Tuple: {
        Schema schema = list(type.types.size(), type.types.size());
        schema["prefixItems"] = all(type.types);
        return schema;
      }
      case Type::Kind::Either:
        return {{"anyOf", all(type.types)}};
      case Type::Kind::Object:
        break;
    }
    return object(type);
  }

  static Schema number(const Type& type) {
    return {{"type", type.whole ? "integer" : "number"},
            {"minimum", limit(type.least)},
            {"maximum", limit(type.most)}};
  }
  static Schema list(std::size_t least, std::size_t most) {
    return {{"type", "array"}, {"minItems", least}, {"maxItems", most}};
  }
  Schema all(std::span<const Type* const> types) {
    Schema list = Schema::array();
    for (const Type* type : types) list.push_back(reference(*type));
    return list;
  }

  Schema object(const Type& type) {
    if (type.variants.empty()) return closed(type, nullptr);
    Schema kinds = Schema::array();
    for (const Variant& variant : type.variants) kinds.push_back(closed(type, &variant));
    return {{"oneOf", std::move(kinds)}};
  }

  /// An object with the common keys, those of one variant, and no others.
  Schema closed(const Type& type, const Variant* variant) {
    Schema properties = Schema::object(), required = Schema::array(), unnamed = Schema::array();
    const char* named = nullptr;
    const auto add = [&](const Key& key) {
      properties[key.name] = property(key);
      if (!key.required) return;
      (key.named ? unnamed : required).push_back(key.name);
      if (key.named) named = key.named;
    };
    for (const Key& key : type.keys) add(key);
    if (variant) {
      for (const Key& key : variant->keys) add(key);
      properties["kind"].erase("enum");
      properties["kind"]["const"] = variant->value;
      // Without "kind" the object is of the variant that is its default, and of no other.
      const Schema fallback = properties["kind"].value("default", Schema());
      if (fallback != Schema() && fallback != variant->value) required.push_back("kind");
    }
    Schema schema = {
        {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) schema["required"] = std::move(required);
    if (named)
      schema["allOf"].push_back(
          {{"anyOf", Schema::array({{{"required", Schema::array({named})}}, {{"required", unnamed}}})}});
    for (const OneOf& rule : type.one_of) schema["allOf"].push_back(one_of(rule));
    if (variant)
      for (const OneOf& rule : variant->one_of) schema["allOf"].push_back(one_of(rule));
    for (const Needs& rule : type.needs) schema["dependentRequired"][rule.key].push_back(rule.needed);
    return schema;
  }

  static Schema one_of(const OneOf& rule) {
    Schema ways = Schema::array();
    for (const char* key : rule.keys) ways.push_back({{"required", Schema::array({key})}});
    if (rule.named) {  // "required" of what is in it does not touch a text
      const Schema any = {{"anyOf", ways}}, inner = {{"required", Schema::array({"name"})}};
      ways.push_back(
          {{"required", Schema::array({rule.named})}, {"properties", {{rule.named, inner}}}, {"not", any}});
    }
    return {{"oneOf", std::move(ways)}};
  }

  Schema property(const Key& key) {
    Schema schema = reference(*key.type);
    std::string doc = key.doc;
    if (*key.type->unit) doc += std::string(" [") + key.type->unit + "]";
    schema["description"] = doc + ".";
    if (key.fallback) schema["default"] = Schema::parse(key.fallback, nullptr, false);
    return schema;
  }

  Schema definitions_ = Schema::object();
};

}  // namespace

std::string schema_json() { return Writer().document().dump(2) + "\n"; }

}  // namespace weft::scene
