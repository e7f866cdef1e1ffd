#include "run_results.hpp"

#include "base/file.hpp"
#include "base/words.hpp"
#include "checkpoint.hpp"
#include "common.hpp"
#include "export/run_meshes.hpp"
#include "model/mesh_file.hpp"

namespace weft::cli {
namespace {

Result<void> write_shape(const sim::World& world, const sim::NodeState& nodes, const std::string& format,
                         const std::string& path) {
  WEFT_TRY(bytes,
           mesh_file(drawn_mesh(world.model().host, nodes.position, world.scene().render.subdivide), format));
  return write_file(path, bytes);
}

/// What the meshes are, for who reads them.
Result<void> write_parts(const sim::World& world, const std::string& folder) {
  MeshParts made{world.scene().time.frame, drawn_parts(world.model().host, world.scene().render.subdivide)};
  for (std::size_t c = 0; c < made.parts.size(); ++c) made.parts[c].name = world.scene().cloths[c].name;
  name_apart(made.parts);
  return write_file(folder + "/" + kPartsFile, parts_json(made));
}

}  // namespace

Result<std::unique_ptr<RunResults>> RunResults::create(sim::World& world, const RunOptions& options) {
  std::unique_ptr<Pictures> pictures;
  if (options.pictures) WEFT_SET(pictures, Pictures::create(world));
  WEFT_TRY(folder, OutFolder::take(options.out, world.frame(), options.resume));
  auto made = std::unique_ptr<RunResults>(new RunResults(std::move(folder), options, std::move(pictures)));
  WEFT_TRY(rows, FrameRows::create(options.out, world, options.measures));
  made->rows_.emplace(std::move(rows));
  if (options.meshes_every > 0) WEFT_CHECK(write_parts(world, options.out));
  if (!made->pictures_) return made;
  WEFT_CHECK(made->pictures_->begin(options.out, world.frame()));
  if (!made->pictures_->can_video()) say("There is no ffmpeg on PATH, so there will be no run.mp4.");
  return made;
}

Result<void> RunResults::add_frame(sim::World& world) {
  const std::uint32_t frame = world.frame() - 1;
  if (pictures_) WEFT_CHECK(pictures_->draw(world));
  WEFT_CHECK(rows_->add(world));
  if (meshes_every_ == 0 || frame % meshes_every_ != 0) return {};
  WEFT_TRY(nodes, world.node_state());
  ++meshes_;
  return write_shape(world, nodes, mesh_format_, folder_.path() + "/" + mesh_name(frame, mesh_format_));
}

Result<void> RunResults::write_checkpoint(const sim::SavedState& state) {
  if (pictures_) WEFT_CHECK(pictures_->settle());  // who goes on from it draws no frame before it
  ++checkpoints_;
  return write_file(folder_.path() + "/" + checkpoint_name(state.snapshot.time.frame),
                    sim::write_saved_state(state));
}

Result<void> RunResults::settle() {
  if (pictures_) WEFT_CHECK(pictures_->settle());
  let_go();
  return {};
}

void RunResults::let_go() {
  if (pictures_) pictures_->let_go();
}

Result<void> RunResults::go_on(sim::World& world) {
  WEFT_CHECK(rows_->go_on(world));
  return pictures_ ? pictures_->go_on(world) : Result<void>();
}

Result<void> RunResults::finish_pictures() { return pictures_ ? pictures_->finish() : Result<void>(); }

Result<void> RunResults::write_end(sim::World& world, const sim::Snapshot& snapshot, const Summary& summary) {
  WEFT_CHECK(write_shape(world, snapshot, "obj", folder_.path() + "/final.obj"));
  return write_file(folder_.path() + "/summary.json", summary_json(summary, world));
}

std::string RunResults::listed() const {
  std::string text;
  if (pictures_) text += counted(pictures_->count(), "picture", "pictures") + ", ";
  if (pictures_ && pictures_->has_video()) text += "run.mp4, ";
  if (meshes_ > 0) text += counted(meshes_, "mesh", "meshes") + ", ";
  if (checkpoints_ > 0) text += counted(checkpoints_, "checkpoint", "checkpoints") + ", ";
  return text + "frames.csv, final.obj, summary.json";
}

}  // namespace weft::cli
