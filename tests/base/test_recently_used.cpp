#include <doctest/doctest.h>

#include "base/recently_used.hpp"

using weft::RecentlyUsed;

TEST_CASE("of one key too many, the least recently used gives way and all others keep their values") {
  RecentlyUsed<int, int, 3> kept;
  for (const int key : {1, 2, 3}) kept[key] = 10 * key;
  const int& first = kept[1];  // used again, so 2 is now the oldest
  kept[4] = 40;
  CHECK(&kept[1] == &first);
  CHECK(kept[1] == 10);
  CHECK(kept[3] == 30);
  CHECK(kept[4] == 40);
  CHECK(kept[2] == 0);  // made anew, in the place of 1
  CHECK(kept[3] == 30);
  CHECK(kept[1] == 0);
}

TEST_CASE("clear leaves no value of any key") {
  RecentlyUsed<int, int, 2> kept;
  kept[1] = kept[2] = 5;
  kept.clear();
  CHECK(kept[1] == 0);
  CHECK(kept[2] == 0);
}
