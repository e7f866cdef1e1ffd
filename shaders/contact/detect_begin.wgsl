// Begins a detection, if one is due: by the step's own will or because a vertex is about to leave its reach. Keeps the
// places that reaches are measured from, finds the largest speed, and clears what the lists will count. One invocation per vertex.
#include "shared/index.wgsl"
#include "shared/step.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
//                                                                                     elements           unit
@group(0) @binding(0) var<uniform>             step            : StepParams;
@group(0) @binding(1) var<storage, read>       position        : array<vec4f>;      // vertex_count       m
@group(0) @binding(2) var<storage, read>       velocity        : array<vec4f>;      // vertex_count       m/s
@group(0) @binding(3) var<storage, read_write> predicted       : array<vec4f>;      // 2 * vertex_count   m/s, then m
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;        // kVertexWords * vertex_count
@group(0) @binding(5) var<storage, read_write> statistics      : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn detect_begin(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  let wanted = step.detect == kDetectAlways || (step.detect == kDetectIfDue && atomicLoad(&statistics[kStatDetect]) != 0u);
  let due = wanted && atomicLoad(&statistics[kStatHeld]) == 0u;
  if (vertex == 0u) {
    atomicStore(&statistics[kStatDue], select(0u, 1u, due));
    if (due) {
      atomicStore(&statistics[kStatFound], 0u);
      atomicStore(&statistics[kStatCandidates], 0u);
      atomicStore(&statistics[kStatPairs], 0u);
      atomicStore(&statistics[kStatEntries], 0u);
    }
  }
  if (!due || vertex >= step.vertex_count) { return; }
  predicted[step.vertex_count + vertex] = position[vertex];
  vertex_contacts[kVertexWords * vertex + 1u] = 0u;
  vertex_contacts[kVertexWords * vertex + kCursorWord] = 0u;
  if (step.detect == kDetectAlways) {  // the first substep of a frame, after whatever was before it
    vertex_contacts[kVertexWords * vertex + 2u] = 0u;
    vertex_contacts[kVertexWords * vertex + 3u] = 0u;
  }
  atomicMax(&statistics[kStatSpeed], bitcast<u32>(length(velocity[vertex].xyz)));
}
