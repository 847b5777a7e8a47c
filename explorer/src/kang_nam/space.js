// The equilibrium surface over the plane of theta0 and mu0, its height the direction of the spring, with the state and its path on it.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Line, LineBasicMaterial,
  Mesh, MeshLambertMaterial, PerspectiveCamera, Plane, Scene, Sprite, SpriteMaterial, SRGBColorSpace, CanvasTexture, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { colours } from "../colours.js";
import { createOverlay } from "../overlay.js";

const [WIDTH, HEIGHT, DEPTH] = [2.6, 1.7, 1.8];
/** Friction is drawn up to this many times its range in the drawing. */
const FAR = 30;
/** Pixels of the drawing for one of the page, and the smallest share of them while it turns; the time after which a picture is late, milliseconds. */
const FULL = Math.min(2, devicePixelRatio);
const [COARSEST, LATE] = [0.25, 34];

/** Direction of the spring, from the mass to its anchor. */
const directionOf = ({ theta0 }, [x, y]) => Math.atan2(Math.sin(theta0) - y, Math.cos(theta0) - x);

/** Null where the browser has no WebGL. */
export function createSpace(box, store) {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true });
  if (!context) {
    box.querySelector(".missing").hidden = false;
    return null;
  }
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.setPixelRatio(FULL);
  renderer.localClippingEnabled = true;
  box.append(renderer.domElement);
  const glass = createOverlay(box);
  const [scene, camera] = [new Scene(), new PerspectiveCamera(35, 1, 0.1, 50)];
  camera.position.set(-2.7, 2.1, 5.0);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.target.set(0, -0.08, 0);
  controls.enablePan = false;
  controls.minDistance = 2.5;
  controls.maxDistance = 9;
  controls.addEventListener("change", draw_soon);
  scene.add(new AmbientLight(0xffffff, 1.5));
  const light = new DirectionalLight(0xffffff, 2.2);
  light.position.set(-1, 3, 2);
  scene.add(light);
  const clip = [new Plane(new Vector3(0, 0, -1), DEPTH / 2 + 1e-3), new Plane(new Vector3(0, 0, 1), DEPTH / 2 + 1e-3)];

  let [top, colour, surface, sets, pending] = [1, colours(), null, null, false];
  let [turning, last_turn, share] = [false, 0, 1];
  const put = (theta0, mu0, theta) => new Vector3(
    WIDTH * (theta0 / Math.PI - 0.5), HEIGHT * (theta / Math.PI - 0.5), DEPTH * (0.5 - mu0 / top),
  );

  const groups = { surface: [], curves: [], frame: [] };

  function replace(name, objects) {
    for (const old of groups[name]) {
      scene.remove(old);
      old.geometry?.dispose();
      old.material.map?.dispose();
      old.material.dispose();
    }
    groups[name] = objects;
    objects.forEach((object) => scene.add(object));
    draw_soon();
  }

  function line(points, material) {
    const object = new Line(new BufferGeometry().setFromPoints(points), material);
    object.computeLineDistances();
    return object;
  }

  function sheet() {
    if (!surface) {
      return;
    }
    const { nodes, mu0, coarse } = surface;
    const faces = [];
    for (let at = nodes + 1; at < mu0.length; at++) {
      if (at % nodes && coarse[at]) {
        triangles(at - nodes - 1, at - nodes, at - 1, at, mu0, faces);
      }
    }
    const geometries = [painted(surface), painted(surface.fine)];
    geometries[0].setIndex(faces);
    geometries.forEach((geometry) => geometry.computeVertexNormals());
    const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }; // lines on the surface stay whole
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, clippingPlanes: clip, ...offset });
    const ruled = () => new LineBasicMaterial({ color: colour.ink, transparent: true, opacity: 0.4, clippingPlanes: clip });
    const lines = surface.rulings.filter((run) => run.length > 1);
    replace("surface", [...geometries.map((geometry) => new Mesh(geometry, material.clone())), ...lines.map((run) => line(run.map((at) => put(...at)), ruled()))]);
  }

  /** The geometry of nodes with their places and colours, still without triangles. */
  function painted({ theta0, theta, mu0, kind }) {
    const [places, paint] = [new Float32Array(3 * mu0.length), new Float32Array(3 * mu0.length)];
    const hues = [colour.stable, colour.divergent, colour.flutter].map((hue) => new Color(hue));
    for (let at = 0; at < mu0.length; at++) {
      const value = Number.isNaN(mu0[at]) ? 0 : mu0[at]; // no triangle has a corner without a state
      put(theta0[at], Math.max(-FAR * top, Math.min(FAR * top, value)), theta[at]).toArray(places, 3 * at);
      hues[kind[at]].toArray(paint, 3 * at);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setAttribute("color", new BufferAttribute(paint, 3));
    return geometry;
  }

  /** Appends the two triangles of a cell, each if all of its corners are on the surface and it reaches into the drawing. */
  function triangles(a, b, c, d, mu0, faces) {
    for (const corners of [[a, b, c], [b, d, c]]) {
      const values = corners.map((corner) => mu0[corner]);
      if (!values.some(Number.isNaN) && Math.max(...values) > 0 && Math.min(...values) < top) {
        faces.push(...corners);
      }
    }
  }

  function folds() {
    if (!sets) {
      replace("curves", []);
      return;
    }
    const ink = () => new LineBasicMaterial({ color: colour.ink, clippingPlanes: clip });
    const faint = () => new LineBasicMaterial({ color: colour.faint, clippingPlanes: clip });
    const onset = () => new LineBasicMaterial({ color: colour.flutter, clippingPlanes: clip });
    const onsets = sets.flutter.map(({ theta0, mu0, theta }) => line(theta0.map((value, i) => put(value, mu0[i], theta[i])), onset()));
    replace("curves", onsets.concat(sets.curves.flatMap(({ theta0, mu0, theta }) => [
      line(theta0.map((value, i) => put(value, mu0[i], theta[i])), ink()),
      line(theta0.map((value, i) => put(value, mu0[i], 0)), faint()),
    ])));
  }

  /** The floor with the axes, their ticks, and names and numbers beside them. */
  function frame() {
    const faint = () => new LineBasicMaterial({ color: colour.faint });
    const corners = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]].map(([u, v]) => put(u * Math.PI, v * top, 0));
    const [out, left] = [new Vector3(0, 0, 0.07), new Vector3(-0.07, 0, 0)];
    const ticks = [30, 60, 90, 120, 150].map((angle) => [put((angle * Math.PI) / 180, 0, 0), out])
      .concat([0.25, 0.5, 0.75].map((share) => [put(0, share * top, 0), left]), [45, 90, 135].map((angle) => [put(0, 0, (angle * Math.PI) / 180), left]));
    const beside = (place, x, y, z) => place.add(new Vector3(x, y, z));
    replace("frame", [
      line(corners, faint()), line([put(0, 0, 0), put(0, 0, Math.PI)], faint()),
      ...ticks.map(([from, way]) => line([from, from.clone().add(way)], faint())),
      label("0°", beside(put(0, 0, 0), 0.03, -0.12, 0.14)), label("θ₀ = 90°", beside(put(Math.PI / 2, 0, 0), 0, -0.12, 0.2)),
      label("180°", beside(put(Math.PI, 0, 0), 0, -0.12, 0.14)),
      label(`μ₀ = ${top}`, beside(put(0, top, 0), -0.22, -0.1, 0)), label(String(top / 2), beside(put(0, top / 2, 0), -0.22, -0.06, 0)),
      label("θ = 180°", beside(put(0, 0, Math.PI), -0.1, 0.13, 0)), label("90°", beside(put(0, 0, Math.PI / 2), -0.2, 0, 0)),
    ]);
  }

  function label(text, place) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [256, 64];
    const ctx = canvas.getContext("2d");
    ctx.font = "600 44px system-ui, sans-serif";
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    ctx.strokeStyle = colour.panel;
    ctx.lineWidth = 8;
    ctx.lineJoin = "round";
    ctx.strokeText(text, 128, 32); // a rim: read on the surface too
    ctx.fillStyle = colour.ink;
    ctx.fillText(text, 128, 32);
    const sprite = new Sprite(new SpriteMaterial({ map: Object.assign(new CanvasTexture(canvas), { colorSpace: SRGBColorSpace }), depthTest: false }));
    sprite.scale.set(0.72, 0.18, 1);
    sprite.position.copy(place);
    sprite.renderOrder = 1;
    return sprite;
  }

  /** Draws the surface and its overlay anew with the next picture. */
  function draw_soon() {
    if (!pending) {
      pending = true;
      requestAnimationFrame((now) => { pending = false; pace(now); picture(); });
    }
  }

  function picture() {
    renderer.render(scene, camera);
    draw();
  }

  /** Halves the number of pixels a side while the surface turns and pictures come late, as without a graphics card. */
  function pace(now) {
    const late = turning && last_turn && now - last_turn > LATE;
    last_turn = turning ? now : 0;
    if (late && share > COARSEST) {
      sharp(share / 2);
    }
  }

  function sharp(wanted) {
    if (wanted !== share) {
      share = wanted;
      renderer.setPixelRatio(share * FULL);
    }
  }

  controls.addEventListener("start", () => { turning = true; });
  controls.addEventListener("end", () => { [turning, last_turn] = [false, 0]; sharp(1); draw_soon(); });

  /**
   * Draws the path, solid where the state followed and dashed where it jumped, and the state, on the overlay: while the point is dragged nothing is
   * drawn in 3D.
   */
  function draw() {
    const { path, point, state } = store.get() ?? { path: [], state: null };
    const theta = state && directionOf(point, state.q);
    glass((ctx, width, height) => {
      const seen = (theta0, mu0, height_of) => {
        const { x, y } = put(theta0, Math.min(mu0, FAR * top), height_of).project(camera);
        return [(0.5 + 0.5 * x) * width, (0.5 - 0.5 * y) * height];
      };
      const [solid, jumps] = [new Path2D(), new Path2D()];
      let last = null;
      path.forEach(({ point: at, q, jump }) => {
        const place = seen(at.theta0, at.mu0, directionOf(at, q));
        if (jump && last) {
          jumps.moveTo(...last);
          jumps.lineTo(...place);
        }
        solid[last && !jump ? "lineTo" : "moveTo"](...place);
        last = place;
      });
      ctx.lineWidth = 2;
      ctx.strokeStyle = colour.path;
      ctx.stroke(solid);
      ctx.setLineDash([7, 5]);
      ctx.strokeStyle = colour.jump;
      ctx.stroke(jumps);
      ctx.setLineDash([]);
      if (theta !== null) { // in two colours: seen on every colour of the surface
        ctx.beginPath();
        ctx.arc(...seen(point.theta0, Math.min(point.mu0, top), theta), 6, 0, 7);
        ctx.fillStyle = colour.panel;
        ctx.fill();
        ctx.lineWidth = 3.5;
        ctx.strokeStyle = colour.path;
        ctx.stroke();
      }
    });
  }

  function resize() {
    const [width, height] = [Math.max(200, box.clientWidth), Math.max(200, box.clientHeight)];
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.fov = width < 1.25 * height ? 42 : 30;
    camera.updateProjectionMatrix();
    picture(); // at once: the next picture may be that of a printer
  }

  renderer.domElement.tabIndex = 0;
  renderer.domElement.setAttribute("role", "img");
  renderer.domElement.setAttribute("aria-label", "The equilibrium surface; arrow keys turn it, plus and minus come closer and go away");
  renderer.domElement.addEventListener("keydown", (event) => {
    const turns = { ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, -0.1, 1], ArrowDown: [0, 0.1, 1], "+": [0, 0, 0.9], "-": [0, 0, 1.1] };
    const turn = turns[event.key];
    if (turn) {
      event.preventDefault();
      camera.position.applyAxisAngle(new Vector3(0, 1, 0), turn[0]);
      camera.position.y = Math.max(-4, Math.min(6, camera.position.y - 4 * turn[1]));
      camera.position.multiplyScalar(turn[2]);
      controls.update();
      draw_soon();
    }
  });

  function all() {
    frame();
    sheet();
    folds();
    draw();
  }
  resize();
  frame();
  return {
    draw,
    show: (found) => { surface = found; sheet(); },
    hide: () => { [surface, sets] = [null, null]; replace("surface", []); folds(); },
    curves: (found) => { sets = found; folds(); },
    reach: (value) => { top = value; all(); },
    resize,
    recolour: () => { colour = colours(); all(); },
  };
}
