#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common.hpp"

namespace weft::cli {

struct RunOptions {
  SceneOptions scene;
  std::optional<std::uint32_t> frames;  // none: the scene's
  std::string out;                      // folder; empty: nothing is written
  bool pictures = true;                 // of each frame, and a video of them
  bool measures = true;                 // energies and stretch of each frame, in frames.csv
  std::uint32_t meshes_every = 0;       // frames from one that is written as a mesh to the next; 0: none is
  std::string mesh_format = "obj";      // of these
  std::string adapter;
  bool json = false;
  bool quiet = false;                  // no progress, and nothing on stdout but JSON
  std::uint32_t checkpoint_every = 0;  // frames from one checkpoint to the next; 0: there is none
  std::string resume;                  // a checkpoint to go on from; empty: from the start
  std::vector<std::string> faults;     // "nan@FRAME" or "lost@FRAME": what the tests of failures bring about
};

/// Simulates a scene, draws it where there is a folder for the pictures, and says how it went. The exit code.
int run(const RunOptions& options);

}  // namespace weft::cli
