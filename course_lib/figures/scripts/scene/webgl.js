// Bodies in space, drawn by WebGL 2. One context draws for every figure of a page, one after the
// other, and each figure keeps a copy on its own canvas, because a browser has some 16 contexts.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const S = globalThis.course.scene;
  const MAX_BODIES = 24; // of a mesh, and colours of its palette: uniforms of fixed size
  const FLOATS_PER_CORNER = 8; // position, normal, colour and body

  const BODY_VERTEX = `#version 300 es
    in vec3 at, normal;
    in vec2 index; // colour, body
    uniform mat4 view, poses[${MAX_BODIES}];
    uniform vec3 palette[${MAX_BODIES}], lamp;
    uniform float ground;
    uniform bool shadow;
    out vec3 n, c, p;
    void main() {
      mat4 pose = poses[int(index.y)];
      vec4 w = pose * vec4(at, 1.);
      vec3 x = pose[0].xyz, y = pose[1].xyz, z = pose[2].xyz;
      c = palette[int(index.x)];
      n = mat3(cross(y, z), cross(z, x), cross(x, y)) * normal; // right for stretched bodies too
      if (shadow) w.xyz -= lamp * (w.z - ground) / lamp.z; // along the light, onto the floor
      p = w.xyz;
      gl_Position = view * w;
    }`;
  // Light from the sky and from the lamp, and a highlight (Blinn and Phong).
  const BODY_FRAGMENT = `#version 300 es
    precision highp float;
    in vec3 n, c, p;
    uniform vec3 lamp, eye;
    uniform float opacity, least;
    uniform bool shadow;
    out vec4 rgba;
    void main() {
      if (shadow) { rgba = vec4(c, 1.) * opacity; return; }
      vec3 N = normalize(n), L = normalize(lamp), V = normalize(eye - p);
      if (dot(N, V) < 0.) N = -N;
      float light = max(least, .42 + .18 * (.5 + .5 * N.z) + .48 * max(dot(N, L), 0.));
      float highlight = .12 * (1. - least) * pow(max(dot(N, normalize(L + V)), 0.), 40.);
      rgba = vec4(min(c * light + highlight, 1.), 1.) * opacity;
    }`;
  // Lines are ribbons, in pixels: x, y, depth, and the length so far, for dashes.
  const LINE_VERTEX = `#version 300 es
    in vec4 at;
    uniform vec2 size;
    out float far;
    void main() {
      gl_Position = vec4(2. * at.x / size.x - 1., 1. - 2. * at.y / size.y, at.z, 1.);
      far = at.w;
    }`;
  const LINE_FRAGMENT = `#version 300 es
    precision highp float;
    in float far;
    uniform vec4 colour;
    uniform vec2 dash; // its length, and that with the gap
    out vec4 rgba;
    void main() {
      if (dash.y > 0. && mod(far, dash.y) > dash.x) discard;
      rgba = colour;
    }`;
  const LAMP = [0.4, -0.5, 1.2];

  /** "#rrggbb" as three numbers from 0 to 1. */
  const rgb = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255);

  // Faces around a corner that lean less than 51 degrees to each other (the cosine is 0.63) look
  // like one round surface.
  const SMOOTH = 0.63;

  /**
   * The corners of a mesh's triangles, 8 numbers each. A corner's normal is the mean of those faces
   * around it that lean little to its own, weighted by area: edges stay sharp and the rest is
   * smooth.
   */
  function corners({ vertices, faces, colours, bodies }) {
    const areas = faces.map(([a, b, c]) =>
      M.cross(M.subtract(vertices[b], vertices[a]), M.subtract(vertices[c], vertices[a])),
    );
    const normals = areas.map(M.unit);
    const keys = vertices.map(placeKey);
    const around = facesAround(faces, keys);
    const data = new Float32Array(3 * FLOATS_PER_CORNER * faces.length);
    faces.forEach((face, k) => {
      face.forEach((i, j) => {
        const offset = FLOATS_PER_CORNER * (3 * k + j);
        const normal = smoothNormal(normals[k], around.get(keys[i]), normals, areas);
        data.set(vertices[i], offset);
        data.set(normal, offset + 3);
        data[offset + 6] = colours[k];
        data[offset + 7] = bodies[i];
      });
    });
    return data;
  }
  /** One number for all vertices within 0.1 mm: those of neighbouring parts count as one. */
  const placeKey = ([x, y, z]) =>
    Math.round(x * 1e4) * 1e10 + Math.round(y * 1e4) * 1e5 + Math.round(z * 1e4);

  /** {the key of a place: the faces with a corner there} */
  function facesAround(faces, keys) {
    const around = new Map();
    faces.forEach((face, k) => {
      for (const i of face) {
        if (!around.has(keys[i])) around.set(keys[i], []);
        around.get(keys[i]).push(k);
      }
    });
    return around;
  }
  /** Written out without M, because robots have twenty thousand corners. */
  function smoothNormal([ux, uy, uz], neighbours, normals, areas) {
    const sum = [0, 0, 0];
    for (const k of neighbours) {
      const [vx, vy, vz] = normals[k];
      if (ux * vx + uy * vy + uz * vz <= SMOOTH) continue;
      for (let axis = 0; axis < 3; axis++) sum[axis] += areas[k][axis];
    }
    return M.unit(sum);
  }

  // ---- the one context ----

  const canvas = document.createElement("canvas");
  const redraws = new Set(); // of the figures, for when a lost context is restored
  let gl = null;
  let programs = null; // {body, line}
  let streams = null; // buffers that are filled anew in every picture: {mesh, ribbon}
  let kept = new WeakMap(); // {mesh: its buffer}

  /** Start WebGL if that has not happened yet; returns whether it draws. */
  function start() {
    gl ??= canvas.getContext("webgl2", { stencil: true, antialias: false });
    if (!gl) return false;
    if (!programs) {
      programs = {
        body: linkProgram(BODY_VERTEX, BODY_FRAGMENT),
        line: linkProgram(LINE_VERTEX, LINE_FRAGMENT),
      };
      streams = { mesh: newBuffer(), ribbon: newBuffer() };
      // Colours are multiplied by their opacity already.
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthFunc(gl.LEQUAL);
    }
    return !gl.isContextLost();
  }
  function linkProgram(vertexSource, fragmentSource) {
    const program = gl.createProgram();
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertexSource],
      [gl.FRAGMENT_SHADER, fragmentSource],
    ]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const locations = {};
    /** The location of a uniform, which is asked for once. */
    function at(name) {
      locations[name] ??= gl.getUniformLocation(program, name);
      return locations[name];
    }
    return { program, at };
  }
  const newBuffer = () => ({ array: gl.createVertexArray(), buffer: gl.createBuffer() });

  // Figures keep their last picture until a lost context is restored.
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => {
    programs = null;
    kept = new WeakMap();
    for (const redraw of redraws) redraw();
  });

  /**
   * Fill a buffer with vertices of `stride` numbers; attributes are [name, how many numbers, the
   * first one].
   */
  function fillBuffer({ array, buffer }, { program }, data, stride, attributes) {
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    for (const [name, size, first] of attributes) {
      const location = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, 4 * stride, 4 * first); // bytes
    }
  }
  const BODY_ATTRIBUTES = [
    ["at", 3, 0],
    ["normal", 3, 3],
    ["index", 2, 6],
  ];
  const LINE_ATTRIBUTES = [["at", 4, 0]];

  /**
   * Bind a mesh and return how many corners it has. A fleeting one, new in every picture, is not
   * kept.
   */
  function bindMesh(mesh) {
    if (kept.has(mesh)) {
      const { array, count } = kept.get(mesh);
      gl.bindVertexArray(array);
      return count;
    }
    const data = corners(mesh);
    const count = data.length / FLOATS_PER_CORNER;
    const target = mesh.fleeting ? streams.mesh : newBuffer();
    fillBuffer(target, programs.body, data, FLOATS_PER_CORNER, BODY_ATTRIBUTES);
    if (!mesh.fleeting) kept.set(mesh, { ...target, count });
    return count;
  }

  // ---- a picture ----

  // For smooth edges a picture is drawn at twice its width and height. Without a graphics card that
  // takes too long while something moves: then only the last picture of a movement is drawn so.
  const REST = 160; // milliseconds without another picture, after which a movement has ended
  const SLOW = 12; // milliseconds for a picture, of the 16 between two frames
  const TIMED_PICTURE = 3; // the first one compiles the programs
  // {the context of a figure: when it was drawn last, and the timer of the finer picture}.
  const rests = new WeakMap();
  let isSlow = false;
  let pictures = 0;

  /**
   * Draw what a figure has listed, and copy it into the figure's canvas.
   * @param {CanvasRenderingContext2D} context of the figure
   * @param {object} picture width, height, dense, view (4 x 4), eye, floor, meshes, lines
   * @param {() => void} redraw the figure
   */
  function draw(context, picture, redraw) {
    if (!start()) return;
    const before = rests.get(context) ?? { last: -Infinity };
    const now = performance.now();
    const isMoving = isSlow && now - before.last < REST;
    clearTimeout(before.timer);
    drawScaled(context, picture, isMoving ? 1 : 2);
    pictures += 1;
    if (pictures === TIMED_PICTURE) {
      // Reading a pixel waits until it is drawn.
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      isSlow = performance.now() - now > SLOW;
    }
    const timer = isMoving ? setTimeout(redraw, REST + 20) : 0;
    rests.set(context, { last: performance.now(), timer });
  }

  function drawScaled(context, picture, scale) {
    const width = scale * Math.round(picture.width * picture.dense);
    const height = scale * Math.round(picture.height * picture.dense);
    // Setting the size clears the canvas; all of the picture is copied below, so an equal one is
    // left as it is.
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.STENCIL_TEST);
    gl.enable(gl.BLEND);
    const isFloorSeen = picture.floor && picture.eye[2] > picture.floor.height;
    if (isFloorSeen) drawFloor(picture);
    drawLayer(picture, "space");
    gl.clear(gl.DEPTH_BUFFER_BIT); // what comes now is in front of all
    drawLayer(picture, "above");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    context.drawImage(canvas, 0, 0, width / scale, height / scale);
  }

  function useBodies({ view, eye }) {
    const { program, at } = programs.body;
    gl.useProgram(program);
    gl.uniformMatrix4fv(at("view"), true, view.flat());
    gl.uniform3fv(at("eye"), eye);
    gl.uniform3fv(at("lamp"), LAMP);
    gl.uniform1i(at("shadow"), 0);
  }
  function drawBody({ mesh, poses, palette, opacity, least = 0 }) {
    const { at } = programs.body;
    const count = bindMesh(mesh);
    gl.uniformMatrix4fv(at("poses"), true, poses.slice(0, MAX_BODIES).flat(2));
    gl.uniform3fv(at("palette"), palette.slice(0, MAX_BODIES).flatMap(rgb));
    gl.uniform1f(at("opacity"), opacity);
    gl.uniform1f(at("least"), least);
    gl.drawArrays(gl.TRIANGLES, 0, count);
  }
  function drawDepthOf(body) {
    gl.colorMask(false, false, false, false);
    drawBody(body);
    gl.colorMask(true, true, true, true);
  }
  function drawLine({ ribbon, colour, dash }, { width, height }) {
    const { program, at } = programs.line;
    const [length, gap] = dash.length ? dash : [0, 0];
    gl.useProgram(program);
    fillBuffer(streams.ribbon, programs.line, new Float32Array(ribbon), 4, LINE_ATTRIBUTES);
    gl.uniform2f(at("size"), width, height);
    gl.uniform4f(at("colour"), ...rgb(colour), 1);
    gl.uniform2f(at("dash"), length, length + gap);
    gl.drawArrays(gl.TRIANGLES, 0, ribbon.length / 4);
  }
  function drawLines(picture, layer) {
    for (const line of picture.lines) {
      if (line.layer === layer) drawLine(line, picture);
    }
  }

  /** The floor, the lines on it and the shadows, which darken each of its pixels once. */
  function drawFloor(picture) {
    const { floor, meshes } = picture;
    useBodies(picture);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.ALWAYS, 1, 3); // the floor writes 1
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
    drawBody(floor);
    gl.disable(gl.STENCIL_TEST);
    drawLines(picture, "floor");

    useBodies(picture);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 1, 3); // a shadow is drawn where there is 1, and makes it 2
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    const { at } = programs.body;
    gl.uniform1i(at("shadow"), 1);
    gl.uniform1f(at("ground"), floor.height);
    for (const body of meshes) {
      if (!body.shadow) continue;
      const palette = body.palette.map(() => floor.shade);
      drawBody({ ...body, palette, opacity: floor.darkness });
    }
    gl.uniform1i(at("shadow"), 0);
    gl.disable(gl.STENCIL_TEST);

    gl.enable(gl.DEPTH_TEST);
    drawDepthOf(floor); // which hides what is below it
  }

  /**
   * Bodies and lines of a layer: those that hide others first, then lines, then translucent bodies.
   */
  function drawLayer(picture, layer) {
    const bodies = picture.meshes.filter((body) => body.layer === layer);
    const translucent = bodies.filter(({ opacity }) => opacity < 1);
    translucent.sort((a, b) => b.distanceFromEye - a.distanceFromEye); // farther ones first
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    useBodies(picture);
    for (const body of bodies) {
      if (body.opacity === 1) drawBody(body);
    }
    gl.disable(gl.CULL_FACE);
    drawLines(picture, layer);
    gl.enable(gl.CULL_FACE);
    useBodies(picture);
    // Of a translucent body only the nearest surface is drawn: its depth first, then its colour.
    for (const body of translucent) {
      drawDepthOf(body);
      drawBody(body);
    }
  }

  Object.assign(S, { start, draw, redraws });
})();
