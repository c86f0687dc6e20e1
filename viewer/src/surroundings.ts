// What is around a room: light, and a ground to stand on, both to its size.

import { type Box3, Color, DirectionalLight, Group, HemisphereLight, Mesh, PlaneGeometry, ShaderMaterial, Sphere, Vector3 } from "three";

export class Surroundings {
  readonly group = new Group();
  private readonly sun = new DirectionalLight(0xfff1dd, 2.3);
  private readonly ground = groundGrid();

  constructor() {
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 5;
    this.sun.shadow.normalBias = 0.02;
    this.sun.shadow.bias = -0.0004;
    const fill = new DirectionalLight(0xe6eeff, 0.7);
    fill.position.set(-2, 3, -5);
    this.group.add(new HemisphereLight(0xffffff, 0xd8cfc4, 1.7), fill, this.sun, this.sun.target, this.ground);
  }

  /** Sun, shadow and ground to the size of the room. */
  aim(all: Box3): void {
    const { center, radius } = all.getBoundingSphere(new Sphere());
    this.sun.target.position.copy(center);
    this.sun.position.copy(center).addScaledVector(new Vector3(-0.35, 0.95, -0.4).normalize(), radius * 2);
    const { camera } = this.sun.shadow;
    Object.assign(camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: radius * 0.2, far: radius * 4 });
    camera.updateProjectionMatrix();
    this.ground.position.set(center.x, all.min.y - 0.02, center.z);
    this.ground.scale.setScalar(radius * 6);
    this.uniforms.radius.value = radius;
  }

  /** Of the ground's lines: a CSS colour, written to the screen as it is. */
  setColour(grid: string): void {
    this.uniforms.colour.value.set(grid).convertLinearToSRGB();
  }

  private get uniforms(): GridUniforms {
    return this.ground.material.uniforms as unknown as GridUniforms;
  }
}

interface GridUniforms {
  readonly colour: { value: Color };
  readonly radius: { value: number };
}

/** Lines one metre apart that fade with the distance from the room: a scale, not a floor. */
function groundGrid(): Mesh<PlaneGeometry, ShaderMaterial> {
  const uniforms: GridUniforms = { colour: { value: new Color() }, radius: { value: 1 } };
  const material = new ShaderMaterial({
    uniforms: { ...uniforms },
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    vertexShader: /* glsl */ `
      varying vec3 world;
      varying vec2 from;
      void main() {
        vec4 at = modelMatrix * vec4(position, 1.0);
        world = at.xyz;
        from = at.xz - modelMatrix[3].xz;
        gl_Position = projectionMatrix * viewMatrix * at;
      }
    `,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      uniform float radius;
      varying vec3 world;
      varying vec2 from;
      void main() {
        vec2 width = fwidth(world.xz);
        vec2 line = 1.0 - smoothstep(width * 0.2, width * 1.0, abs(fract(world.xz - 0.5) - 0.5));
        float fade = 1.0 - smoothstep(radius * 0.7, radius * 2.4, length(from));
        gl_FragColor = vec4(colour, max(line.x, line.y) * fade * 0.22);
      }
    `,
  });
  const ground = new Mesh(new PlaneGeometry(1, 1).rotateX(-Math.PI / 2), material);
  ground.renderOrder = -1;
  return ground;
}
