#include "fabrics.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/fabrics.hpp"

namespace weft::cli {
namespace {

using scene::Cited;
using scene::NamedFabric;

/// A column of the table: a number of each fabric, its key in scenes, and its unit there and here.
struct Column {
  const char* key;
  const char* heading;
  Cited NamedFabric::*number;
  const char* unit;
  double scale;  // from that unit to the table's
  int width;
};
constexpr Column kColumns[] = {
    {"density", "g/m²", &NamedFabric::density, "kg/m²", 1e3, 6},
    {"warp", "E warp", &NamedFabric::warp, "N/m", 1, 8},
    {"weft", "E weft", &NamedFabric::weft, "N/m", 1, 8},
    {"shear", "G", &NamedFabric::shear, "N/m", 1, 7},
    {"poisson", "ν", &NamedFabric::poisson, "", 1, 8},
    {"bending_warp", "B warp", &NamedFabric::bending_warp, "N·m", 1e6, 7},
    {"bending_weft", "B weft", &NamedFabric::bending_weft, "N·m", 1e6, 7},
    {"bending_twist", "twist", &NamedFabric::bending_twist, "N·m", 1e6, 7},
    {"friction", "friction", &NamedFabric::friction, "", 1, 9},
};

bool guessed(const Cited& number) { return number.source == std::string_view("guess"); }

/// Spaces in front, by characters: printf counts bytes.
void print_right(const char* text, int width) {
  int characters = 0;
  for (const char* c = text; *c != 0; ++c) characters += (static_cast<unsigned char>(*c) & 0xC0U) != 0x80U;
  std::printf("%*s%s", std::max(0, width - characters), "", text);
}

void print_table() {
  std::printf("%-19s", "fabric");
  for (const Column& column : kColumns) print_right(column.heading, column.width + 2);
  std::printf("  what\n");
  for (const NamedFabric& fabric : scene::kFabrics) {
    std::printf("%-19s", fabric.name);
    for (const Column& column : kColumns) {
      const Cited& number = fabric.*column.number;
      std::printf("%*.4g%s", column.width + 1, number.value * column.scale, guessed(number) ? "?" : " ");
    }
    std::printf("  %s [%s]\n", fabric.what, fabric.density.source);
  }
  std::printf(
      "\nE, G in N/m; B, twist in µN·m; a number with ? is a guess, all others are of the source in [].\n");
  for (const scene::FabricSource& source : scene::kFabricSources)
    std::printf("%s: %s\n", source.id, source.citation);
}

nlohmann::ordered_json fabric_json(const NamedFabric& fabric) {
  nlohmann::ordered_json json{
      {"name", fabric.name}, {"what", fabric.what}, {"published_as", fabric.published_as}};
  for (const Column& column : kColumns) {
    const Cited& number = fabric.*column.number;
    json[column.key] = {{"value", number.value},
                        {"unit", column.unit},
                        {"source", number.source},
                        {"guess", guessed(number)}};
  }
  if (fabric.drape.source != nullptr)
    json["drape_coefficient"] = {{"least", fabric.drape.least},
                                 {"most", fabric.drape.most},
                                 {"unit", "%"},
                                 {"source", fabric.drape.source}};
  if (*fabric.note != 0) json["note"] = fabric.note;
  return json;
}

void print_json() {
  nlohmann::ordered_json json;
  json["fabrics"] = nlohmann::ordered_json::array();
  for (const NamedFabric& fabric : scene::kFabrics) json["fabrics"].push_back(fabric_json(fabric));
  for (const scene::FabricSource& source : scene::kFabricSources)
    json["sources"][source.id] = source.citation;
  std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

int list_fabrics(bool json) {
  json ? print_json() : print_table();
  return 0;
}

}  // namespace weft::cli
