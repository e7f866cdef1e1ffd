// How a vertex leaves the bodies that it is inside of. The including kernel binds step and contacts.
// Source: docs/contact.md, equation (7d).
#include "state/contact.wgsl"
#include "contact/proximity/links.wgsl"

// Sums of integers over a vertex's pairs with the bodies that it is inside of.
struct OutOfBody {
  way : vec3i,      // 2^-16
  surface : vec3i,  // the bodies' velocity, 2^-16 m/s
  parts : u32,      // 2^-16
}
const kPartUnits = 65536.0;

fn bodies_around(first : u32) -> OutOfBody {
  var body = OutOfBody(vec3i(0), vec3i(0), 0u);
  for (var link = first; link != 0u; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    if (contact.solid != kUntangles || contact.urgency == 0.0 || is_self_pair(contact.ids)) { continue; }
    let weight = weights_of(contact.ids, contact.place.x, contact.place.y)[role_of(link)];
    let part = kPartUnits * weight * -contact.normal.w;
    body.way += vec3i(round(part * contact.normal.xyz));
    body.surface -= vec3i(round(clamp(part * contact.surface.xyz, vec3f(-kMostUnits), vec3f(kMostUnits))));
    body.parts += u32(round(abs(part)));
  }
  return body;
}

// A body gives no way, and its facets do not agree on where outside is. The vertex goes where most of them say.
fn out_of_body(body : OutOfBody, v : vec3f) -> vec3f {
  if (body.parts == 0u) { return vec3f(0.0); }
  let way = vec3f(body.way) / f32(body.parts);
  let agreement = length(way);
  if (agreement <= 0.0) { return vec3f(0.0); }
  let n = way / agreement;
  let wanted = step.contact.thickness * min(kUntanglePart / step.time.dt, kUntangleRate);
  return max(0.0, wanted - dot(n, v - vec3f(body.surface) / f32(body.parts))) * n;
}
