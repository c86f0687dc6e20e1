// The shaders of ambient occlusion: what the eye sees, how much of the sky each place of it has, the grain taken out of
// that, and where the materials of the room look it up.
//
// What is kept for each pixel is four bytes: how open it is, and its depth, by which who looks it up finds its own surface.

/** Metres: nothing farther away takes light from a place. */
const REACH = 0.9;
/** By how much what is found is deepened, as the other lights of the page come through walls and would wash it out. */
const DEEPER = 2.2;
/** What the narrowest gap is left with: some light comes off its sides. */
const LEAST = 0.3;

/** Flat normals, from the change of place over the screen: those of smooth meshes do not fit their own triangles. */
export const SEEN = {
  vertex: /* glsl */ `
    varying vec3 place;
    void main() {
      vec4 at = modelViewMatrix * vec4(position, 1.0);
      place = at.xyz;
      gl_Position = projectionMatrix * at;
    }
  `,
  fragment: /* glsl */ `
    varying vec3 place;
    void main() {
      gl_FragColor = vec4(normalize(cross(dFdx(place), dFdy(place))) * 0.5 + 0.5, 1.0);
    }
  `,
};

export const SCREEN = /* glsl */ `
  void main() {
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }
`;

/** Of a place: the two textures that `SEEN` has left, and where a pixel of them is before the eye. */
const PLACES = /* glsl */ `
  uniform highp sampler2D normals;
  uniform highp sampler2D depths;
  uniform mat4 projection;
  uniform mat4 unprojection;

  vec3 before(ivec2 pixel, float depth) {
    vec2 at = (vec2(pixel) + 0.5) / vec2(textureSize(depths, 0));
    vec4 clip = unprojection * vec4(vec3(at, depth) * 2.0 - 1.0, 1.0);
    return clip.xyz / clip.w;
  }

  vec3 normalAt(ivec2 pixel) {
    return normalize(texelFetch(normals, pixel, 0).xyz * 2.0 - 1.0);
  }
`;

const PACKING = /* glsl */ `
  vec3 pack(float depth) {
    vec3 parts = fract(depth * vec3(1.0, 255.0, 65025.0));
    return parts - vec3(parts.yz / 255.0, 0.0);
  }
`;

const UNPACKING = /* glsl */ `
  float depthIn(vec4 kept) {
    return dot(kept.yzw, vec3(1.0, 1.0 / 255.0, 1.0 / 65025.0));
  }
`;

/**
 * How open a place is: in a few slices through the direction of view, how far up its surroundings rise on either side, and
 * the share of the light of an even sky that comes between them (Jimenez et al., Practical Realtime Strategies for Accurate
 * Indirect Occlusion, 2016).
 */
export const OPENNESS = /* glsl */ `
  #include <common>
  ${PLACES}
  ${PACKING}
  const int SLICES = 3;
  const int STEPS = 4;
  const float REACH = ${REACH.toFixed(2)};

  void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(depths, 0);
    float depth = texelFetch(depths, here, 0).x;
    if (depth == 1.0) {
      gl_FragColor = vec4(1.0);
      return;
    }
    vec3 place = before(here, depth);
    vec3 normal = normalAt(here);
    bool perspective = projection[2][3] != 0.0;
    vec3 toEye = perspective ? normalize(-place) : vec3(0.0, 0.0, 1.0);
    // Pixels that a metre spans here.
    float scale = projection[1][1] * 0.5 * float(size.y) / (perspective ? -place.z : 1.0);
    // Sixteen neighbours look sixteen ways; their mean has all of them.
    float turn = float((((here.x + here.y) & 3) << 2) + (here.x & 3)) / 16.0;
    float shift = float((here.y - here.x) & 3) / 4.0 + 0.125;

    float open = 0.0;
    for (int slice = 0; slice < SLICES; slice++) {
      float angle = (float(slice) + turn) * PI / float(SLICES);
      vec2 way = vec2(cos(angle), sin(angle));
      vec3 along = vec3(way, 0.0);
      along -= toEye * dot(along, toEye);
      vec3 axis = normalize(cross(along, toEye));
      vec3 within = normal - axis * dot(normal, axis);
      float share = length(within);
      float cosine = clamp(dot(within, toEye) / max(share, 1e-4), -1.0, 1.0);
      float tilt = sign(dot(along, within)) * acos(cosine);
      // Cosines to the direction of view: of the two horizons, and of the surface itself, which they are with nothing around.
      vec2 level = vec2(cos(tilt + PI_HALF), cos(tilt - PI_HALF));
      vec2 horizon = level;
      for (int i = 0; i < STEPS; i++) {
        float t = (float(i) + shift) / float(STEPS);
        // Nearer places count more.
        vec2 offset = way * max(t * t * REACH * scale, float(i) + 1.0);
        for (int k = 0; k < 2; k++) {
          ivec2 there = ivec2(floor(gl_FragCoord.xy + (k == 0 ? offset : -offset)));
          if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) continue;
          vec3 to = before(there, texelFetch(depths, there, 0).x) - place;
          float far = length(to);
          // What is far in front is another thing, with light between.
          float counts = clamp(2.0 - 2.0 * far / REACH, 0.0, 1.0);
          horizon[k] = max(horizon[k], mix(level[k], dot(to, toEye) / max(far, 1e-5), counts));
        }
      }
      vec2 rise = vec2(acos(clamp(horizon.x, -1.0, 1.0)), -acos(clamp(horizon.y, -1.0, 1.0)));
      vec2 arc = cosine + 2.0 * rise * sin(tilt) - cos(2.0 * rise - tilt);
      open += share * (arc.x + arc.y) * 0.25;
    }
    open = pow(clamp(open / float(SLICES), 0.0, 1.0), ${DEEPER.toFixed(2)});
    gl_FragColor = vec4(mix(${LEAST.toFixed(2)}, 1.0, open), pack(depth));
  }
`;

/** The mean of sixteen neighbours, of those that are in one plane. */
export const SMOOTH = /* glsl */ `
  ${PLACES}
  ${UNPACKING}
  uniform sampler2D raw;

  void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 kept = texelFetch(raw, here, 0);
    float depth = texelFetch(depths, here, 0).x;
    if (depth == 1.0) {
      gl_FragColor = kept;
      return;
    }
    vec3 place = before(here, depth);
    vec3 normal = normalAt(here);
    ivec2 last = textureSize(raw, 0) - 1;
    float sum = 0.0;
    float weights = 0.0;
    for (int i = 0; i < 16; i++) {
      ivec2 there = clamp(here + ivec2(i & 3, i >> 2) - 2, ivec2(0), last);
      float off = abs(dot(normal, before(there, texelFetch(depths, there, 0).x) - place));
      float weight = max(1e-4, 1.0 - off / 0.03);
      sum += texelFetch(raw, there, 0).x * weight;
      weights += weight;
    }
    gl_FragColor = vec4(sum / weights, kept.yzw);
  }
`;

/** For the head of a material's fragment shader. */
export const LOOKUP = /* glsl */ `
  uniform highp sampler2D openness;
  uniform vec2 picture;
  uniform float occlusion;
  ${UNPACKING}

  // Of the four nearest pixels that are kept, those count that are on this surface: where its plane would have them.
  float openHere() {
    ivec2 size = textureSize(openness, 0);
    vec2 scale = picture / vec2(size);
    vec2 at = gl_FragCoord.xy / scale - 0.5;
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
    float sum = 0.0;
    float weights = 0.0;
    for (int i = 0; i < 4; i++) {
      vec2 corner = floor(at) + vec2(i & 1, i >> 1);
      vec4 kept = texelFetch(openness, clamp(ivec2(corner), ivec2(0), size - 1), 0);
      vec2 near = 1.0 - abs(at - corner);
      float off = abs(gl_FragCoord.z + dot(slope, (corner - at) * scale) - depthIn(kept));
      float weight = (near.x * near.y + 1e-3) / (off + 4e-6);
      sum += kept.x * weight;
      weights += weight;
    }
    return mix(1.0, sum / weights, occlusion);
  }
`;

/** In its body, once all light is in: the sun finds its own way, or has a shadow. */
export const APPLY = /* glsl */ `
  if (occlusion > 0.0) reflectedLight.indirectDiffuse *= openHere();
`;
