// Scenes that must be refused, each with what the message must say. Two tests read the table: the loader's
// and the schema's.
#pragma once

#include <string>
#include <vector>

namespace weft::scene {

struct Hostile {
  std::string text;
  std::string message;         // a part of it
  bool schema_refuses = true;  // false: JSON Schema cannot say it
};

std::vector<Hostile> hostile_scenes();

}  // namespace weft::scene
