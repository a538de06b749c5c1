// SPDX-License-Identifier: MIT
// A view of three.js: a camera about a point, lights, a floor. Where the camera is, is in the state.
import type { Room } from '../shell/exhibit';
import { number } from '../shell/state';
import { say, type Text } from '../shell/text';
import { colour } from './colours';
import { element } from './html';
import type * as Three from './three';
import { clamp } from './values';

export type Library = typeof Three;
export interface Camera {
  /** Degrees about the vertical axis, and above the floor. */
  azimuth: number;
  elevation: number;
  distance: number;
}

export const cameraFields = (azimuth: number, elevation: number, distance: number) => ({
  azimuth: number(azimuth, -180, 180), elevation: number(elevation, -89, 89), distance: number(distance, 1e-3, 1e5),
});

export interface View {
  readonly scene: Three.Scene;
  readonly camera: Three.PerspectiveCamera;
  readonly canvas: HTMLCanvasElement;
  /** The point that the camera looks at. */
  aim(x: number, y: number, z: number): void;
  render(): void;
}

const noView = { en: 'This browser shows no WebGL.', ja: 'このブラウザでは WebGL を使えません。' };
const words = {
  turn: { en: 'turns the view', ja: '視点を回します' },
  zoom: { en: 'moves the view nearer or farther', ja: '視点を近づけます・遠ざけます' },
};

function light(three: Library, scene: Three.Scene) {
  const sun = new three.DirectionalLight(0xffffff, 2);
  sun.position.set(2, 4, 3);
  scene.add(new three.HemisphereLight(0xffffff, 0x777788, 1.6), sun);
}

// The controls follow the state, and the state the controls.
function connect<S extends Camera>(room: Room<S>, three: Library, controls: Three.OrbitControls) {
  const camera = controls.object as Three.PerspectiveCamera, degrees = 180 / Math.PI, place = new three.Spherical();
  controls.addEventListener('change', () => {
    const azimuth = controls.getAzimuthalAngle() * degrees, elevation = 90 - controls.getPolarAngle() * degrees;
    const distance = controls.getDistance(), now = room.state;
    if (Math.hypot(azimuth - now.azimuth, elevation - now.elevation, distance / now.distance - 1) > 1e-4)
      room.set({ azimuth, elevation, distance } as Partial<S>);
  });
  return () => {
    const { azimuth, elevation, distance } = room.state;
    place.set(distance, (90 - elevation) / degrees, azimuth / degrees);
    camera.position.setFromSpherical(place).add(controls.target);
    camera.near = distance / 100;
    camera.far = distance * 100;
    controls.update();
  };
}

function keys<S extends Camera>(room: Room<S>) {
  const turn = (azimuth: number, elevation: number) => room.set({
    azimuth: (room.state.azimuth + azimuth + 540) % 360 - 180,
    elevation: clamp(room.state.elevation + elevation, -89, 89),
  } as Partial<S>);
  const zoom = (factor: number) => room.set({ distance: room.state.distance * factor } as Partial<S>);
  room.shortcuts([
    { key: 'ArrowLeft', does: words.turn, run: () => turn(-10, 0) },
    { key: 'ArrowRight', does: words.turn, run: () => turn(10, 0) },
    { key: 'ArrowUp', does: words.turn, run: () => turn(0, 10) },
    { key: 'ArrowDown', does: words.turn, run: () => turn(0, -10) },
    { key: '+', does: words.zoom, run: () => zoom(0.8) },
    { key: '-', does: words.zoom, run: () => zoom(1.25) },
  ]);
}

/** A view at the top of the stage; null, with a message, where there is no WebGL. */
export function openView<S extends Camera>(room: Room<S>, three: Library, label: Text): View | null {
  let renderer: Three.WebGLRenderer;
  try {
    renderer = new three.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  } catch {
    room.stage.prepend(element('p', { role: 'alert' }, say(noView)));
    return null;
  }
  const canvas = renderer.domElement, scene = new three.Scene(), camera = new three.PerspectiveCamera(40, 1, 0.01, 1e3);
  for (const [name, value] of [['role', 'img'], ['aria-label', say(label)], ['tabindex', '0'], ['class', 'view3']])
    canvas.setAttribute(name, value);
  room.stage.prepend(canvas);
  light(three, scene);
  const controls = new three.OrbitControls(camera, canvas), follow = connect(room, three, controls);
  keys(room);
  room.closed(() => {
    controls.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
  });
  const fit = () => {
    const { clientWidth: width, clientHeight: height } = canvas, ratio = Math.min(devicePixelRatio, 2);
    if (canvas.width !== Math.floor(width * ratio) || canvas.height !== Math.floor(height * ratio)) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      camera.aspect = width / Math.max(height, 1);
      camera.updateProjectionMatrix();
    }
  };
  return {
    scene, camera, canvas,
    aim: (x, y, z) => { controls.target.set(x, y, z); },
    render() {
      fit();
      follow();
      scene.background = new three.Color(colour('paper'));
      renderer.render(scene, camera);
    },
  };
}
