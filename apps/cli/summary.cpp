#include "summary.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bench_rows.hpp"

namespace weft::cli {
namespace {

/// Simulated seconds per second of simulation; 0 without frames. Nor has a run that diverged a pace: its
/// frames were not computed, only gone through.
double real_time_factor(const Summary& summary, double simulated) {
  if (summary.end == "diverged") return 0;
  const double spent = std::accumulate(summary.frame_ms.begin(), summary.frame_ms.end(), 0.0);  // ms
  return spent > 0 ? simulated / (spent / 1000) : 0;
}

std::string solver_name(const sim::World& world) {
  const Method& method = world.plan().method();
  const std::string settings = method.settings_word(world.scene().solver), reason = world.plan().reason();
  std::string name = scene::name_of(method.kind);
  if (!settings.empty()) name += " (" + settings + ")";
  return reason.empty() ? name : name + ", chosen since " + reason;
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
  const Method& method = world.plan().method();
  json["solver"] = scene::name_of(method.kind);
  if (!world.plan().reason().empty()) json["solver_reason"] = world.plan().reason();
  if (const std::string settings = method.settings_word(world.scene().solver); !settings.empty())
    json["forces"] = settings;
  json["contact_method"] = scene::name_of(world.scene().contact.method);
  json["adapter"] = world.device().adapter().name;
  json["nodes"] = world.model().vertex_count();
  json["triangles"] = world.model().triangle_count();
  json["springs"] = world.spring_count();
  json["frames"] = totals.frames;
  json["substeps"] = world.substeps();
  json["step_s"] = world.step();
  json["stable_step_s"] = world.plan().limit().largest_step;
  json["simulated_s"] = simulated;
  json["wall_s"] = summary.wall_s;
  json["ms_per_frame"] = json_of(frame);
  json["real_time_factor"] = real_time_factor(summary, simulated);
  json["state_hash"] = summary.state_hash;
  json["max_stretch"] = totals.max_stretch;
  json["nonfinite"] = totals.nonfinite;
  json["contacts"] = totals.contacts;
  json["contact_hash"] = totals.contact_hash;
  json["contact_overflow"] = totals.contact_overflow;
  if (world.scene().contact.method == scene::ContactMethod::Proximity) {
    json["detections"] = totals.detections;
    json["pairs"] = totals.pairs;
    json["candidates"] = totals.candidates;
    json["crossings"] = totals.crossings;
    json["crossings_left"] = totals.crossings_left;
    json["truncated"] = totals.truncated;
    json["repeated_frames"] = totals.repeated_frames;
  }
  json["gpu_bytes"] = world.device().allocated_bytes();
  return json.dump(2) + "\n";
}

std::string summary_text(const Summary& summary, const sim::World& world) {
  const bench::Timing frame = bench::timing_of(summary.frame_ms);
  const sim::Totals& totals = world.totals();
  const double simulated = totals.frames * world.scene().time.frame;
  std::string text;
  line(text, "%s: %s", summary.scene.c_str(), summary.end.c_str());
  line(text, "  adapter     %s", world.device().adapter().name.c_str());
  line(text, "  cloth       %u nodes, %u triangles, %zu springs", world.model().vertex_count(),
       world.model().triangle_count(), world.spring_count());
  line(text, "  solver      %s; %u substeps a frame", solver_name(world).c_str(), world.substeps());
  if (world.plan().limit().largest_step == 0) {
    line(text, "  step        %.4g ms; stable at any length", 1e3 * world.step());
  } else {
    line(text, "  step        %.4g ms; stable up to %.4g ms (highest frequency %.4g rad/s)",
         1e3 * world.step(), 1e3 * world.plan().limit().largest_step, world.plan().limit().highest_frequency);
  }
  line(text, "  simulated   %u frames, %.3f s, in %.1f s", totals.frames, simulated, summary.wall_s);
  char pace[64] = "";
  if (const double factor = real_time_factor(summary, simulated); factor > 0)
    std::snprintf(pace, sizeof pace, ": %.3g x real time", factor);
  line(text, "  time        %.3f ms a frame (median), %.3f ms (least)%s", frame.median, frame.least, pace);
  line(text, "  contact     %s: %llu hits, overflow %llu", scene::name_of(world.scene().contact.method),
       static_cast<unsigned long long>(totals.contacts),
       static_cast<unsigned long long>(totals.contact_overflow));
  line(text, "  stretch     at most %.4f of the rest length", static_cast<double>(totals.max_stretch));
  line(text, "  memory      %.1f MiB on the GPU",
       static_cast<double>(world.device().allocated_bytes()) / 1048576);
  line(text, "  state hash  %s", summary.state_hash.c_str());
  return text;
}

}  // namespace weft::cli
