// Two lights: by day from sky and sun, by lamp from the lamps next to the viewer.
import {
  BackSide, CircleGeometry, Color, DirectionalLight, Float32BufferAttribute, HemisphereLight, Mesh, MeshBasicMaterial, MeshStandardMaterial,
  PMREMGenerator, PointLight, Scene, SphereGeometry,
} from 'three';

/** More lights cost time in every pixel, however many lamps a floor has. */
const MOST_LAMPS = 8;
/** Lumens of a lamp to the unit of the picture: a lamp of 1,500 lumens lights a room of 20 square metres well at exposure 1. */
const UNITS_PER_LUMEN = 1 / 260;
/** Metres at which a lamp's light ends, so that it does not shine through a whole floor. */
const REACH = 9;

/** Eyes adapt to the colour of lamps: so much of it is left, of 1. */
const COLOUR_LEFT = 0.4;

/** Metres between the ground and a floor at height 0, so that the two do not flicker. */
const FLOOR_THICKNESS = 0.06;

const DAY = { background: 0xdbe4ec, ground: 0xb9c2b4, hemisphere: 1.3, sun: 1.8, fill: 0.5, environment: 0.45, exposure: 1 };
const NIGHT = { background: 0x0c1017, ground: 0x39424d, hemisphere: 0.22, sun: 0, fill: 0, environment: 0.1, exposure: 1.1 };

/** Pixels of each side of the sky's cube: it is smooth. */
const SKY_SIZE = 32;

/** What the sky adds to diffuse light, in units of the hemisphere, until it is there itself: π times its mean brightness. */
const SKY_IRRADIANCE = 2.8;

export class Light {
  constructor(stage) {
    this.stage = stage;
    const { scene } = stage;
    this.hemisphere = new HemisphereLight(0xf3f7ff, 0xd9d0c6);
    this.sun = new DirectionalLight(0xfff1dc);
    this.sun.position.set(0.7, 1, 0.3);
    // From behind: without it, all walls that face away from the sun would look alike, and their corners be lost.
    this.fill = new DirectionalLight(0xdfe9ff);
    this.fill.position.set(-0.45, 0.3, -1);
    this.lamps = Array.from({ length: MOST_LAMPS }, () => new PointLight(0xffffff, 0, REACH));
    this.ground = groundPlate();
    scene.add(this.hemisphere, this.sun, this.fill, ...this.lamps, this.ground);
    this.hasSky = false;
    this.set('day');
  }

  set(mode) {
    this.mode = mode;
    const look = mode === 'day' ? DAY : NIGHT;
    const { scene, renderer } = this.stage;
    scene.background.set(look.background);
    scene.environmentIntensity = look.environment;
    renderer.toneMappingExposure = look.exposure;
    this.hemisphere.intensity = look.hemisphere + (this.hasSky ? 0 : look.environment * SKY_IRRADIANCE);
    this.sun.intensity = look.sun;
    this.fill.intensity = look.fill;
    this.ground.material.color.set(look.ground);
    // All of them or none: materials are compiled anew when the number of lights changes.
    for (const lamp of this.lamps) lamp.visible = mode === 'lamp';
    this.stage.invalidate();
  }

  /** Lets metal and glass reflect the sky. Its shaders take software renderers seconds: not before the rooms are there. */
  raiseSky() {
    if (this.hasSky) return;
    this.hasSky = true;
    this.stage.scene.environment = skyOf(this.stage.renderer);
    this.set(this.mode);
  }

  /** Lights the lamps nearest to a place of the scene. */
  follow([x, y, z], lamps) {
    if (this.mode !== 'lamp') return;
    const square = ({ position }) => (position[0] - x) ** 2 + (position[1] - y) ** 2 + (position[2] - z) ** 2;
    const nearest = [...lamps].sort((a, b) => square(a) - square(b)).slice(0, MOST_LAMPS);
    this.lamps.forEach((light, index) => {
      const lamp = nearest[index];
      light.intensity = lamp ? lamp.lumens * UNITS_PER_LUMEN : 0;
      if (!lamp) return;
      // A little below the shade, which would otherwise be lit from inside only.
      light.position.set(lamp.position[0], lamp.position[1] - 0.05, lamp.position[2]);
      light.color.set(0xffffff).lerp(colourOf(lamp.kelvin), COLOUR_LEFT);
    });
  }

  /** Puts the ground below a level. */
  lowerGround(level) {
    this.ground.position.y = -this.heightAbove(level);
  }

  /** Metres from the ground up to the floor of a level. */
  heightAbove({ elevation }) {
    return elevation + FLOOR_THICKNESS;
  }
}

/** The colour of a black body between 1,500 and 10,000 kelvins, by T. Helland's fit of 2012, at most a few per cent off. */
export function colourOf(kelvin) {
  const hundreds = Math.min(100, Math.max(15, kelvin / 100));
  const red = hundreds <= 66 ? 255 : 329.7 * (hundreds - 60) ** -0.1332;
  const green = hundreds <= 66 ? 99.47 * Math.log(hundreds) - 161.12 : 288.12 * (hundreds - 60) ** -0.0755;
  const blue = hundreds >= 66 ? 255 : hundreds <= 19 ? 0 : 138.52 * Math.log(hundreds - 10) - 305.04;
  return new Color().setRGB(...[red, green, blue].map((value) => Math.min(1, Math.max(0, value / 255))), 'srgb');
}

function groundPlate() {
  const plate = new Mesh(new CircleGeometry(2000, 64), new MeshStandardMaterial({ roughness: 1 }));
  plate.rotation.x = -Math.PI / 2;
  return plate;
}

/** What metal and glass reflect: bright above, dim below. */
function skyOf(renderer) {
  const sphere = new SphereGeometry(10, 32, 16);
  const heights = sphere.attributes.position;
  const colours = [];
  for (let index = 0; index < heights.count; index += 1) {
    const share = heights.getY(index) / 20 + 0.5;
    const brightness = 0.35 + 1.1 * share * share;
    colours.push(brightness, brightness * 1.01, brightness * 1.04);
  }
  sphere.setAttribute('color', new Float32BufferAttribute(colours, 3));
  const sky = new Scene();
  sky.add(new Mesh(sphere, new MeshBasicMaterial({ vertexColors: true, side: BackSide })));
  const generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromScene(sky, 0, 0.1, 100, { size: SKY_SIZE });
  generator.dispose();
  sphere.dispose();
  return texture;
}
