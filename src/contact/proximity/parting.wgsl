// How fast features may part, or must close, to be more than moved by their load, m/s: equations (3) and (3a) of
// docs/contact.md. The including kernel binds `step`.
#include "state/step.wgsl"
const kPartingSteps = 2.0;  // mirror: contact/rules/contact_law.hpp
fn speed_of_load() -> f32 { return kPartingSteps * step.time.dt * length(step.air.acceleration.xyz); }
