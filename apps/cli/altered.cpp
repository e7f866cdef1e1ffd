#include "altered.hpp"

#include <algorithm>
#include <cstdio>

#include "base/words.hpp"

namespace weft::cli {
namespace {

constexpr double kPart = 0.001;

}  // namespace

void Altered::add(const sim::World& world, std::uint32_t frame, std::uint64_t truncated) {
  const double ways =
      static_cast<double>(world.model().host.vertex_count()) * world.plan().substeps_of(frame);
  const double part = static_cast<double>(truncated) / ways;
  if (part <= kPart) return;
  if (frames_++ == 0) first_ = frame;
  most_ = std::max(most_, part);
}

std::vector<std::string> Altered::sentences(const sim::World& world) const {
  std::vector<std::string> all;
  const auto say = [&](const char* format, auto... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    all.emplace_back(text);
  };
  if (frames_ > 0)
    say("In %s, from frame %u on, contact shortened more than 0.1 %% of the vertices' ways, at most "
        "%.2g %% in a frame, since cloth or an obstacle would have been passed: more substeps help.",
        counted(frames_, "frame", "frames").c_str(), first_, 100 * most_);
  if (world.totals().driven > 0)
    say("Obstacles have come past cloth %s, since the cloth behind it did not give way.",
        counted(world.totals().driven, "time", "times").c_str());
  const sim::Totals& totals = world.totals();
  if (totals.flattened > 0)
    say("Up to %u of %llu tetrahedra had less than a twentieth of their volume, or were inside out: the body "
        "is pressed harder than its material bears, or the steps are too long.",
        totals.flattened, static_cast<unsigned long long>(world.model().host.count(ElementKind::Tet)));
  if (totals.slowed > 0)
    say("Cloth was slowed down in %s, by %.3g ms in all, since it would have "
        "passed through cloth: more substeps help.",
        counted(totals.slowed, "substep", "substeps").c_str(), 1e3 * totals.delay_s);
  if (totals.unsolved > 0)
    say("Substeps were solved less far than solver.residual, %g, asks %s, and left %.2g of a residual at "
        "most, "
        "after up to %s: more substeps help.",
        world.scene().solver.residual, counted(totals.unsolved, "time", "times").c_str(),
        static_cast<double>(totals.residual), counted(totals.iterations, "iteration", "iterations").c_str());
  return all;
}

}  // namespace weft::cli
