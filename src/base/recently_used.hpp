#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace weft {

/// Values by key, at most kMost of them: a further key takes the place of the least recently used one. A reference
/// stays valid until its key gives way or clear(). Keys are compared one by one, so kMost should be small.
template <class Key, class Value, std::size_t kCapacity>
class RecentlyUsed {
 public:
  static constexpr std::size_t kMost = kCapacity;

  /// The key's value; null: it has none.
  Value* find(const Key& key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->first != key) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return &entry->second;
    }
    return nullptr;
  }
  /// The key's value; a new key's is made by default.
  Value& operator[](const Key& key) {
    if (Value* value = find(key)) return *value;
    if (entries_.size() == kMost) entries_.pop_back();
    entries_.emplace_front(key, Value());
    return entries_.front().second;
  }
  std::size_t size() const { return entries_.size(); }
  void clear() { entries_.clear(); }

 private:
  std::list<std::pair<Key, Value>> entries_;  // the most recently used first
};

}  // namespace weft
