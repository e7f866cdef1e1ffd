#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace weft {

/// Values by key, at most kMost of them: a further key takes the place of the least recently used one. A reference
/// stays valid until its key gives way or clear(). Keys are compared one by one, so kMost should be small.
template <class Key, class Value, std::size_t kMost>
class RecentlyUsed {
 public:
  /// The key's value; a new key's is made by default.
  Value& operator[](const Key& key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->first != key) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return entry->second;
    }
    if (entries_.size() == kMost) entries_.pop_back();
    entries_.emplace_front(key, Value());
    return entries_.front().second;
  }
  void clear() { entries_.clear(); }

 private:
  std::list<std::pair<Key, Value>> entries_;  // the most recently used first
};

}  // namespace weft
