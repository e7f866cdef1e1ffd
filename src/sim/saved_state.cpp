#include "sim/saved_state.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "base/state_hash.hpp"
#include "state/contact_pairs.hpp"

namespace weft::sim {
namespace {

static_assert(std::endian::native == std::endian::little);  // lists are copied as they lie

constexpr char kMagic[] = "weftsave";
constexpr std::size_t kMagicBytes = 8, kSizeAt = 16, kHashAt = 24, kHeaderBytes = 32, kMostText = 1024;
constexpr std::size_t kGrabBytes = sizeof(std::uint32_t) + 3 * sizeof(double);
/// Of all but the lists of nodes, pairs and bodies.
constexpr std::size_t kMostOtherBytes = 16384 + kGrabBytes * scene::kMaxGrabs;
constexpr std::uint32_t kVersion = 5;
/// Pairs that act, for each node and besides; far more than can be near it.
constexpr std::uint64_t kMostPairsOfNode = 256, kMorePairs = 4096;

/// Of a thousand rigid bodies, or colliders that a program moves.
constexpr std::uint64_t kMostRigidBytes = 131072;
static_assert(sizeof(Placement) == 7 * sizeof(double) && 1024 * sizeof(Placement) <= kMostRigidBytes);

class StateWriter {
 public:
  /// Room for so many bytes, so that a large state is not copied as it grows.
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    append(&value, sizeof value);
  }
  void text(const std::string& text) {
    const auto size = static_cast<std::uint32_t>(std::min(text.size(), kMostText));
    number(size);
    append(text.data(), size);
  }
  template <class Element>
  void list(const std::vector<Element>& list) {
    number(static_cast<std::uint64_t>(list.size()));
    append(list.data(), sizeof(Element) * list.size());
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
  }

  std::vector<std::byte> bytes_;
};

/// Reads what StateWriter has written. After the first thing that is not there, all else is 0 and empty.
class StateReader {
 public:
  explicit StateReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class Number>
  Number number() {
    Number value{};
    take(&value, sizeof value, "a number");
    return value;
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    if (size > kMostText || size > left_.size()) return fail("a text", size), std::string();
    std::string text(size, ' ');
    take(text.data(), size, "a text");
    return text;
  }
  template <class Element>
  std::vector<Element> list(const char* what) {
    const auto size = number<std::uint64_t>();
    if (size > left_.size() / sizeof(Element)) return fail(what, size), std::vector<Element>();
    std::vector<Element> list(size);
    take(list.data(), sizeof(Element) * size, what);
    return list;
  }
  Result<void> end() const {
    if (!missing_.empty()) return input_error("%s", missing_.c_str());
    if (!left_.empty()) return input_error("The saved state has %zu bytes behind its end.", left_.size());
    return {};
  }

 private:
  void fail(const char* what, std::uint64_t size) {
    if (missing_.empty())
      missing_ = make_error(ErrorKind::Input, "The saved state ends within %s of %llu, with %zu bytes left.",
                            what, static_cast<unsigned long long>(size), left_.size())
                     .message;
    left_ = {};
  }
  void take(void* to, std::size_t size, const char* what) {
    if (size > left_.size()) return fail(what, size);
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_ = left_.subspan(size);
  }

  std::span<const std::byte> left_;
  std::string missing_;
};

template <class Value>
Value at(std::span<const std::byte> bytes, std::size_t place) {
  Value value{};
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

/// Whether a file of this length and beginning is whole.
Result<void> check_header(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes)
    return input_error("A saved state begins with %zu bytes; here there are %zu.", kHeaderBytes,
                       bytes.size());
  if (std::memcmp(bytes.data(), kMagic, kMagicBytes) != 0)
    return input_error("This is no saved state of weft: it does not begin with \"%s\".", kMagic);
  const auto version = at<std::uint32_t>(bytes, 8);
  if (version != kVersion)
    return input_error("The saved state is of version %u; this weft reads version %u.", version, kVersion);
  if (const auto size = at<std::uint64_t>(bytes, kSizeAt); size != bytes.size())
    return input_error("The saved state should have %llu bytes; it has %zu.",
                       static_cast<unsigned long long>(size), bytes.size());
  const std::uint64_t wanted = at<std::uint64_t>(bytes, kHashAt),
                      found = bytes_hash(bytes.subspan(kHeaderBytes));
  if (wanted != found || at<std::uint32_t>(bytes, 12) != 0)
    return input_error("The saved state is damaged: its checksum is %s instead of %s.",
                       hash_text(found).c_str(), hash_text(wanted).c_str());
  return {};
}

bool finite(const std::vector<Vec4f>& list) {
  return std::all_of(list.begin(), list.end(), [](const Vec4f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
  });
}

Result<void> check_finite(const SavedState& state) {
  const Snapshot& s = state.snapshot;
  bool all = finite(s.position) && finite(s.velocity) && finite(s.position_before) &&
             finite(s.velocity_before) && finite(s.creases);
  for (const double number : {s.time.origin, s.time.length, s.step, s.gusts.since, s.gusts.turns[0],
                              s.gusts.turns[1], s.gusts.rates[0], s.gusts.rates[1]})
    all = all && std::isfinite(number);
  for (std::size_t word = 0; word < s.contact_forces.size(); ++word)
    if (word % kKeptWords >= 4 && word % kKeptWords < 7) {  // after the pair's numbers
      float force = 0;
      std::memcpy(&force, &s.contact_forces[word], sizeof force);  // libc++ 14 has no bit_cast
      all = all && std::isfinite(force);
    }
  for (const std::uint32_t word : s.rigid) all = all && (word & 0x7f800000U) != 0x7f800000U;
  if (!all) return input_error("The saved state has a number that is not finite.");
  if (s.contact_forces.size() % kKeptWords != 0)
    return input_error("The saved state has %zu words of contact forces, which come in %u.",
                       s.contact_forces.size(), kKeptWords);
  return {};
}

std::size_t list_bytes(const Snapshot& s) {
  return sizeof(Vec4f) * (s.position.size() + s.velocity.size() + s.position_before.size() +
                          s.velocity_before.size() + s.creases.size()) +
         sizeof(std::uint32_t) * (s.contact_forces.size() + s.hold_forces.size());
}

}  // namespace

std::vector<std::byte> write_saved_state(const SavedState& state) {
  const Snapshot& snapshot = state.snapshot;
  StateWriter writer;
  writer.reserve(kHeaderBytes + list_bytes(snapshot) + kMostOtherBytes);
  for (const char c : std::string_view(kMagic, kMagicBytes)) writer.number(c);
  writer.number(kVersion);
  writer.number(std::uint32_t{0});
  writer.number(std::uint64_t{0});  // these two are known at the end
  writer.number(std::uint64_t{0});
  writer.text(state.build);
  writer.text(state.adapter);
  writer.number(state.scene);
  writer.list(snapshot.position);
  writer.list(snapshot.velocity);
  writer.number(snapshot.time.origin);
  writer.number(snapshot.time.length);
  writer.number(snapshot.time.frame);
  writer.number(snapshot.gusts.since);
  for (const double turns : snapshot.gusts.turns) writer.number(turns);
  for (const double rate : snapshot.gusts.rates) writer.number(rate);
  writer.list(snapshot.contact_forces);
  writer.list(snapshot.hold_forces);
  writer.list(snapshot.rigid);
  writer.list(snapshot.given);
  writer.list(snapshot.creases);
  writer.list(snapshot.position_before);
  writer.list(snapshot.velocity_before);
  writer.number(snapshot.step);
  writer.number(static_cast<std::uint64_t>(state.grabs.size()));
  for (const Grabbed& grabbed : state.grabs) {
    writer.number(grabbed.node);
    for (const double coordinate : {grabbed.target.x, grabbed.target.y, grabbed.target.z})
      writer.number(coordinate);
  }
  for_each(state.totals, [&](const char*, auto value) { writer.number(value); });
  writer.number(static_cast<std::uint64_t>(state.tears.cloths.size()));
  for (const Tears::OfCloth& cloth : state.tears.cloths) {
    writer.list(cloth.origin);
    writer.list(cloth.triangles);
  }
  writer.number(static_cast<std::uint64_t>(state.sewing.cloths.size()));
  for (const Sewing::OfCloth& cloth : state.sewing.cloths) writer.list(cloth.pairs);
  writer.number(state.sewing.work);
  std::vector<std::byte> bytes = writer.take();
  const std::uint64_t size = bytes.size(), hash = bytes_hash(std::span(bytes).subspan(kHeaderBytes));
  std::memcpy(bytes.data() + kSizeAt, &size, sizeof size);
  std::memcpy(bytes.data() + kHashAt, &hash, sizeof hash);
  return bytes;
}

Result<SavedState> read_saved_state(std::span<const std::byte> bytes) {
  WEFT_CHECK(check_header(bytes));
  StateReader reader(bytes.subspan(kHeaderBytes));
  SavedState state;
  Snapshot& snapshot = state.snapshot;
  state.build = reader.text();
  state.adapter = reader.text();
  state.scene = reader.number<std::uint64_t>();
  snapshot.position = reader.list<Vec4f>("a list of positions");
  snapshot.velocity = reader.list<Vec4f>("a list of velocities");
  snapshot.time.origin = reader.number<double>();
  snapshot.time.length = reader.number<double>();
  snapshot.time.frame = reader.number<std::uint32_t>();
  snapshot.gusts.since = reader.number<double>();
  for (double& turns : snapshot.gusts.turns) turns = reader.number<double>();
  for (double& rate : snapshot.gusts.rates) rate = reader.number<double>();
  snapshot.contact_forces = reader.list<std::uint32_t>("a list of contact forces");
  snapshot.hold_forces = reader.list<std::int32_t>("a list of forces at obstacles");
  snapshot.rigid = reader.list<std::uint32_t>("a list of rigid bodies");
  snapshot.given = reader.list<Placement>("a list of colliders that a program moves");
  snapshot.creases = reader.list<Vec4f>("a list of creases");
  snapshot.position_before = reader.list<Vec4f>("a list of positions before");
  snapshot.velocity_before = reader.list<Vec4f>("a list of velocities before");
  snapshot.step = reader.number<double>();
  const auto grabs = reader.number<std::uint64_t>();
  if (grabs > scene::kMaxGrabs)
    return input_error("The saved state has %llu grabbed nodes; the limit is %zu.",
                       static_cast<unsigned long long>(grabs), scene::kMaxGrabs);
  for (std::uint64_t grab = 0; grab < grabs; ++grab) {
    Grabbed grabbed;
    grabbed.node = reader.number<std::uint32_t>();
    for (double* coordinate : {&grabbed.target.x, &grabbed.target.y, &grabbed.target.z})
      *coordinate = reader.number<double>();
    state.grabs.push_back(grabbed);
  }
  for_each(state.totals,
           [&](const char*, auto& value) { value = reader.number<std::decay_t<decltype(value)>>(); });
  const auto cloths = reader.number<std::uint64_t>();
  if (cloths > bytes.size() / (2 * sizeof(std::uint64_t)))  // the lengths of a cloth's two lists
    return input_error("The saved state has tears of %llu cloths in %zu bytes.",
                       static_cast<unsigned long long>(cloths), bytes.size());
  for (std::uint64_t cloth = 0; cloth < cloths; ++cloth) {
    std::vector<std::uint32_t> origin = reader.list<std::uint32_t>("a list of parted nodes");
    state.tears.cloths.push_back(
        {std::move(origin), reader.list<mesh::Triangle>("a list of torn triangles")});
  }
  const auto sewn = reader.number<std::uint64_t>();
  if (sewn > bytes.size() / sizeof(std::uint64_t))  // the length of a cloth's list
    return input_error("The saved state has sewing of %llu cloths in %zu bytes.",
                       static_cast<unsigned long long>(sewn), bytes.size());
  for (std::uint64_t cloth = 0; cloth < sewn; ++cloth)
    state.sewing.cloths.push_back({reader.list<std::int32_t>("a list of sewn pairs")});
  state.sewing.work = reader.number<double>();
  WEFT_CHECK(reader.end());
  WEFT_CHECK(check_finite(state));
  return state;
}

std::string other_origin(const SavedState& state, const std::string& build, const std::string& adapter) {
  std::string other;
  if (state.build != build) other = "by " + state.build;
  if (state.adapter != adapter) other += (other.empty() ? "on " : " on ") + state.adapter;
  return other;
}

std::uint64_t most_saved_bytes(std::uint64_t nodes, std::uint64_t facets, std::uint64_t tearing_triangles) {
  nodes += 3 * tearing_triangles;
  const std::uint64_t pairs = kMostPairsOfNode * nodes + kMorePairs;
  return (4 * sizeof(Vec4f) + sizeof(std::int32_t) * kHoldWords) * nodes + sizeof(Vec4f) * facets +
         sizeof(std::uint32_t) * kKeptWords * pairs + kMostRigidBytes + kMostOtherBytes;
}

}  // namespace weft::sim
