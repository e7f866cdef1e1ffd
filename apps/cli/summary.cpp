#include "summary.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/words.hpp"
#include "bench_rows.hpp"
#include "cloths.hpp"
#include "common.hpp"
#include "session/describe.hpp"

namespace weft::cli {
namespace {

/// Simulated seconds per second of simulation; 0 without frames. Nor has a run that diverged a pace: its
/// frames were not computed, only gone through.
double real_time_factor(const Summary& summary, double frame_s) {
  if (summary.end == "diverged") return 0;
  const double spent = std::accumulate(summary.frame_ms.begin(), summary.frame_ms.end(), 0.0);  // ms
  return spent > 0 ? static_cast<double>(summary.frame_ms.size()) * frame_s / (spent / 1000) : 0;
}

std::string solver_name(const Description& about) {
  std::string name = about.solver;
  if (!about.solver_settings.empty()) name += " (" + about.solver_settings + ")";
  return about.solver_reason.empty() ? name : name + ", chosen since " + about.solver_reason;
}

template <class... Values>
void line(std::string& text, const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, values...);
  text += buffer;
  text += '\n';
}

}  // namespace

std::string summary_json(const Summary& summary, const sim::World& world) {
  const bench::Timing frame = bench::timing_of(summary.frame_ms);
  const sim::Totals& totals = world.totals();
  const double simulated = totals.frames * world.scene().time.frame;
  nlohmann::ordered_json json;
  json["scene"] = summary.scene;
  json["end"] = summary.end;
  if (summary.resumed_frames) json["resumed_frames"] = *summary.resumed_frames;
  const Description about = describe(world);
  json["solver"] = about.solver;
  if (!about.solver_reason.empty()) json["solver_reason"] = about.solver_reason;
  if (!about.solver_settings.empty()) json["forces"] = about.solver_settings;
  json["contact_method"] = about.contact_method;
  json["adapter"] = world.device().adapter().name;
  json["nodes"] = about.nodes;
  json["triangles"] = about.triangles;
  json["springs"] = about.springs;
  json["membranes"] = about.membranes;
  json["slivers"] = about.slivers;
  json["hinges"] = about.hinges;
  json["tetrahedra"] = about.tetrahedra;
  json["cloths"] = cloths_json(world.scene(), world.model().host);
  json["substeps"] = about.substeps;
  json["step_s"] = about.step_seconds;
  json["stable_step_s"] = about.stable_step_seconds;
  json["simulated_s"] = simulated;
  json["wall_s"] = summary.wall_s;
  json["ms_per_frame"] = json_of(frame);
  json["real_time_factor"] = real_time_factor(summary, world.scene().time.frame);
  json["state_hash"] = summary.state_hash;
  for_each(totals, [&](const char* name, auto value) { json[name] = value; });
  if (can_tear(world.scene())) json["splits"] = world.tears().splits();
  if (is_sewn(world.scene())) json["sewn"] = world.sewing().sewn();
  json["gpu_bytes"] = world.device().allocated_bytes();
  return json.dump(2) + "\n";
}

std::string summary_text(const Summary& summary, const sim::World& world) {
  const bench::Timing frame = bench::timing_of(summary.frame_ms);
  const sim::Totals& totals = world.totals();
  const double simulated = totals.frames * world.scene().time.frame;
  std::string text;
  line(text, "%s: %s", summary.scene.c_str(), summary.end.c_str());
  if (summary.resumed_frames) line(text, "  resumed     after %u frames", *summary.resumed_frames);
  line(text, "  adapter     %s", world.device().adapter().name.c_str());
  const Description about = describe(world);
  line(text, "  cloth       %zu nodes, %zu triangles, %zu springs", about.nodes, about.triangles,
       about.springs);
  if (about.membranes > 0)
    line(text, "  fabric      %zu membranes, %zu hinges", about.membranes, about.hinges);
  if (about.tetrahedra > 0) line(text, "  bodies      %zu tetrahedra", about.tetrahedra);
  if (about.slivers > 0)
    line(text, "  slivers     %zu membranes, far thinner than a neighbour, bend freely", about.slivers);
  line(text, "  solver      %s; %s a frame", solver_name(about).c_str(),
       counted(about.substeps, "substep", "substeps").c_str());
  if (about.stable_step_seconds == 0) {
    line(text, "  step        %.4g ms; stable at any length", 1e3 * about.step_seconds);
  } else {
    line(text, "  step        %.4g ms; stable up to %.4g ms (highest frequency %.4g rad/s)",
         1e3 * about.step_seconds, 1e3 * about.stable_step_seconds, world.plan().limit().highest_frequency);
  }
  line(text, "  simulated   %s, %.3f s, in %.1f s", counted(totals.frames, "frame", "frames").c_str(),
       simulated, summary.wall_s);
  char pace[64] = "";
  if (const double factor = real_time_factor(summary, world.scene().time.frame); factor > 0)
    std::snprintf(pace, sizeof pace, ": %.3g x real time", factor);
  line(text, "  time        %.3f ms a frame (median), %.3f ms (least)%s", frame.median, frame.least, pace);
  line(text, "  contact     %s: %llu hits, overflow %llu", about.contact_method.c_str(),
       static_cast<unsigned long long>(totals.contacts),
       static_cast<unsigned long long>(totals.contact_overflow));
  if (totals.iterations > 0)
    line(text, "  residual    at most %.2g of a linear system's, after at most %s",
         static_cast<double>(totals.residual), counted(totals.iterations, "iteration", "iterations").c_str());
  if (totals.flattened > 0) line(text, "  flattened   %u tetrahedra at most in a frame", totals.flattened);
  line(text, "  stretch     at most %.4f of the rest length", static_cast<double>(totals.max_stretch));
  if (can_tear(world.scene())) line(text, "  torn        %zu nodes have parted", world.tears().splits());
  if (is_sewn(world.scene())) line(text, "  sewn        %zu pairs of nodes are one", world.sewing().sewn());
  line(text, "  memory      %.1f MiB on the GPU",
       static_cast<double>(world.device().allocated_bytes()) / 1048576);
  line(text, "  state hash  %s", summary.state_hash.c_str());
  return text;
}

}  // namespace weft::cli
