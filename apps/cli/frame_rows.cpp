#include "frame_rows.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "base/json.hpp"
#include "common.hpp"
#include "gpu/readback.hpp"
#include "state/statistics.hpp"

namespace weft::cli {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;
constexpr const char* kMeasured =
    ",kinetic_J,potential_J,springs_J,membranes_J,bending_J,tetrahedra_J,gas_J,stretch_999";

/// Calls visit(name, value) for each statistic that belongs to a single frame.
template <class Visit>
void for_each_of_frame(const Statistics& statistics, Visit&& visit) {
  std::size_t bytes = 0;
  for_each(statistics, [&](const char* name, auto value) {
    if (bytes < kStatisticsPerFrameBytes) visit(name, value);
    bytes += sizeof value;
  });
}

constexpr const char* kOfBody[] = {"x_m",    "y_m",      "z_m",      "vx_m_s",  "vy_m_s",
                                   "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"};

std::string heading_of(const Model& model, const scene::Scene& scene, bool measures) {
  std::string heading = "frame,time_s";
  if (measures) {
    heading += kMeasured;
    for (std::size_t c = 0; c < model.bodies.size(); ++c) {
      if (!model.bodies[c].gas) continue;
      const std::string cloth = ",cloth_" + std::to_string(c);
      heading += cloth + "_volume_m3" + cloth + "_gauge_Pa";
    }
    for (std::size_t c = 0; c < scene.colliders.size(); ++c)
      for (const char* of : kOfBody)
        if (scene::rigid_of(scene.colliders[c]) != nullptr)
          heading += ",collider_" + std::to_string(c) + "_" + of;
  }
  for_each_of_frame({}, [&](const char* name, auto) { heading += std::string(",") + name; });
  if (can_tear(scene)) heading += ",splits";
  if (is_sewn(scene)) heading += ",sewn,thread_work_J";
  return heading + "\n";
}

/// The edge stretch that 999 of 1000 vertices do not exceed.
Result<float> most_of_stretch(const sim::World& world) {
  WEFT_TRY(stretch, gpu::download(world.device(), world.surface().stretch()));
  const std::size_t rank = stretch.size() - 1 - stretch.size() / 1000;
  std::nth_element(stretch.begin(), stretch.begin() + static_cast<std::ptrdiff_t>(rank), stretch.end());
  return stretch[rank];
}

/// How many bytes the heading and the rows of frames before this one take; 0 where the heading is another.
std::size_t length_before(std::string_view text, std::string_view heading, std::uint32_t frame) {
  if (text.substr(0, heading.size()) != heading) return 0;
  std::size_t at = heading.size();
  for (std::size_t end = text.find('\n', at); end != std::string_view::npos; end = text.find('\n', at)) {
    const std::string line(text.substr(at, end - at));
    if (std::strtoul(line.c_str(), nullptr, 10) >= frame) break;
    at = end + 1;
  }
  return at;
}

Error not_written(const std::string& path) {
  return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", path.c_str(), std::strerror(errno));
}

}  // namespace

FrameRows::FrameRows(FrameRows&& other) noexcept
    : path_(std::move(other.path_)),
      heading_(std::move(other.heading_)),
      file_(std::exchange(other.file_, -1)),
      system_(std::move(other.system_)) {}

FrameRows::~FrameRows() {
  if (file_ >= 0) ::close(file_);
}

Result<FrameRows> FrameRows::create(const std::string& folder, const sim::World& world, bool measures) {
  const std::string path = folder + "/frames.csv";
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return not_written(path);
  FrameRows rows(path, file);
  rows.heading_ = heading_of(world.model().host, world.scene(), measures);
  if (measures) rows.system_ = reference::elements_of(world.model().host);
  WEFT_CHECK(rows.go_back_to(world.frame()));
  return rows;
}

Result<void> FrameRows::go_on(const sim::World& world) {
  if (system_) system_ = reference::elements_of(world.model().host);
  return go_back_to(world.frame());
}

Result<void> FrameRows::go_back_to(std::uint32_t frame) {
  WEFT_TRY(bytes, read_file(path_, kMostBytes));
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t length = length_before(text, heading_, frame);
  if (!text.empty() && length == 0)
    say("The rows of %s are of other columns, and are removed.", path_.c_str());
  if (::ftruncate(file_, static_cast<off_t>(length)) != 0) return not_written(path_);
  return length == 0 ? append(heading_) : Result<void>();
}

Result<void> FrameRows::append(const std::string& line) {
  const ssize_t count = ::write(file_, line.data(), line.size());
  if (count == static_cast<ssize_t>(line.size())) return {};
  const Error error = not_written(path_);
  if (count > 0) static_cast<void>(!::ftruncate(file_, ::lseek(file_, 0, SEEK_END) - count));
  return error;
}

Result<void> FrameRows::add(sim::World& world) {
  std::string line = std::to_string(world.frame() - 1) + "," + number_text(world.time());
  if (system_) {
    WEFT_TRY(nodes, world.node_state());
    const reference::EnergySums e =
        reference::energies_at(*system_, nodes.position, nodes.velocity, nodes.creases,
                               world.scene().gravity + world.scene().external_force);
    for (const double joules :
         {e.kinetic, e.potential, e.springs, e.membranes, e.bending, e.tetrahedra, e.gas})
      line += "," + number_text(joules);
    WEFT_TRY(stretch, most_of_stretch(world));
    line += "," + number_text(static_cast<double>(stretch));
    for (const reference::EnclosedGas& gas : system_->gases) {
      const double volume = gas.volume(system_->position);
      line += "," + number_text(volume) + "," + number_text(gas.law.gauge(volume));
    }
    WEFT_TRY(bodies, world.rigid_places());
    for (const sim::RigidPlace& body : bodies)
      for (const Vec3d& of : {body.place, body.velocity, body.spin})
        for (int axis = 0; axis < 3; ++axis) line += "," + number_text(of[axis]);
  }
  for_each_of_frame(world.last_report(),
                    [&](const char*, auto value) { line += "," + number_text(static_cast<double>(value)); });
  if (can_tear(world.scene())) line += "," + std::to_string(world.tears().splits());
  if (is_sewn(world.scene()))
    line += "," + std::to_string(world.sewing().sewn()) + "," + number_text(world.sewing().work);
  return append(line + "\n");
}

}  // namespace weft::cli
