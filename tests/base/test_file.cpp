#include <doctest/doctest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <span>

#include "base/file.hpp"
#include "temporary_folder.hpp"

using namespace weft;

TEST_CASE("a file is read back as it was written, and its temporary name is gone") {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.txt");
  REQUIRE(write_file(path, std::string("weft")));
  const auto bytes = read_file(path, 100);
  REQUIRE(bytes);
  CHECK(std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) == "weft");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path("")), {}) == 1);
}

TEST_CASE("a missing file, a folder and a file over the limit are input errors") {
  const TemporaryFolder folder;
  CHECK(read_file(folder.path("none"), 10).error().kind == ErrorKind::Input);
  CHECK(read_file(folder.path(""), 10).error().kind == ErrorKind::Input);
  REQUIRE(write_file(folder.path("b"), std::string(11, 'x')));
  const auto result = read_file(folder.path("b"), 10);
  CHECK(result.error().message.find("11 bytes, more than the limit of 10") != std::string::npos);
}

TEST_CASE("a file that is written in parts is there once it is finished, and else leaves what was there") {
  const TemporaryFolder folder;
  const auto count = [&] { return std::distance(std::filesystem::directory_iterator(folder.path("")), {}); };
  const auto bytes = [](const char* text) { return std::as_bytes(std::span(text, std::strlen(text))); };
  REQUIRE(write_file(folder.path("a"), std::string("before")));
  {
    auto file = FileWriter::create(folder.path("a"));
    REQUIRE(file);
    REQUIRE(file.value().append(bytes("half")));
    CHECK(count() == 2);
  }
  CHECK(count() == 1);
  CHECK(read_file(folder.path("a"), 10).value().size() == 6);
  auto file = FileWriter::create(folder.path("a"));
  REQUIRE(file);
  REQUIRE(file.value().append(bytes("abc")));
  REQUIRE(file.value().append(bytes("def")));
  CHECK(file.value().size() == 6);
  REQUIRE(file.value().write_at(1, bytes("XY")));
  FileWriter moved = std::move(file.value());
  REQUIRE(moved.append(bytes("g")));
  REQUIRE(moved.finish());
  CHECK(count() == 1);
  const auto back = read_file(folder.path("a"), 10);
  REQUIRE(back);
  CHECK(std::string(reinterpret_cast<const char*>(back.value().data()), back.value().size()) == "aXYdefg");
}

TEST_CASE("a file in a missing folder, or over a folder, cannot be written, and leaves nothing") {
  const TemporaryFolder folder;
  CHECK(write_file(folder.path("none/a"), std::string("x")).error().kind == ErrorKind::Failure);
  REQUIRE(make_folder(folder.path("d/e")));
  CHECK_FALSE(write_file(folder.path("d"), std::string("x")));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path("")), {}) == 1);
  REQUIRE(write_file(folder.path("f"), std::string("x")));
  CHECK_FALSE(make_folder(folder.path("f/g")));
}
