// What is seen behind all, in the textured view. The includer declares `frame` and `light`.
// Given after the tone curve: the studio's, or the sky in the direction of the pixel.
fn backdrop(pixel : vec2f) -> vec3f {
  let at = pixel * frame.viewport.zw;
  let ray = normalize(frame.forward.xyz + (2.0 * at.x - 1.0) * frame.right.xyz + (1.0 - 2.0 * at.y) * frame.up.xyz);
  let sky = mix(light.backdrop_horizon.rgb, light.backdrop_zenith.rgb, smoothstep(-0.25, 0.9, ray.y));
  return mix(background(pixel), sky, light.backdrop_horizon.w);
}
