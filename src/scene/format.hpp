// The format weft-scene/1 as a table: every key, its type, range, unit, default and meaning. The checks, the
// schema and the nearest-key messages all read this table, so they cannot disagree.
#pragma once

#include <cstddef>
#include <span>

namespace weft::scene {

struct Type;

/// A key of an object.
struct Key {
  const char* name;
  const Type* type;
  const char* doc;
  const char* fallback = nullptr;  // JSON of the default; null: none
  bool required = false;
  // A key of the same object: where it names a fabric, this one comes with it. It is then neither required nor filled
  // in.
  const char* named = nullptr;
};

/// An object has exactly one of these keys.
struct OneOf {
  std::span<const char* const> keys;
  const char* named = nullptr;  // as of a Key: where it names a fabric, the object may have none of them
};

/// The keys that an object has beside the common ones when its "kind" is `value`.
struct Variant {
  const char* value;
  std::span<const Key> keys;
  std::span<const OneOf> one_of = {};
};

/// An object that has `key` has `needed` too.
struct Needs {
  const char* key;
  const char* needed;
};

struct Type {
  enum class Kind {
    Truth,    ///< true or false
    Text,     ///< count_least to count_most characters
    Choice,   ///< one of `choices`
    Number,   ///< from `least` to `most`; `whole`: an integer
    Numbers,  ///< a list of `count_least` such numbers; `rule` may ask for more
    List,     ///< count_least to count_most values of type `types[0]`
    Tuple,    ///< one value of each of `types`
    Either,   ///< a value of one of `types`, which differ in their JSON type
    Object,   ///< `keys`, those of the variant that "kind" names, and the rules between them
  };
  enum class Rule { None, NonZero, Unit };

  Kind kind = Kind::Object;
  const char* name = nullptr;  // a definition of its own in the schema
  double least = 0, most = 0;
  bool whole = false;
  const char* unit = "";
  std::size_t count_least = 0, count_most = 0;
  Rule rule = Rule::None;
  std::span<const char* const> choices = {};
  std::span<const Type* const> types = {};
  std::span<const Key> keys = {};
  std::span<const Variant> variants = {};
  std::span<const OneOf> one_of = {};
  std::span<const Needs> needs = {};
};

inline constexpr double kMaxCoordinate = 1e6;   // m; f32 positions are 6 cm apart there
inline constexpr double kUnitTolerance = 1e-3;  // of a quaternion's length: what three written decimals leave

/// The type of a whole scene.
const Type& scene_type();

}  // namespace weft::scene
