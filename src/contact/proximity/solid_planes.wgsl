// The planes of a vertex's pairs with what contact cannot move. The including kernel binds step and contacts.
// Source: docs/contact.md, equation (6).
#include "state/contact.wgsl"
#include "contact/proximity/links.wgsl"
#include "contact/proximity/planes.wgsl"

fn has_plane(contact : Contact) -> bool {
  return (contact.solid == 1u || contact.solid == 2u) && contact.normal.w > 0.0;
}

// How much of the way from a place before the planes to another passes none of them.
fn part_before_solids(start : vec3f, end : vec3f, first : u32) -> f32 {
  var part = 1.0;
  for (var link = first; link != 0u; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    if (has_plane(contact)) {
      part = min(part, part_before(beyond(contact, role_of(link), start), beyond(contact, role_of(link), end)));
    }
  }
  return part;
}
