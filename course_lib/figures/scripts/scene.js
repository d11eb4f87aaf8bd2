// Bodies in space, drawn by WebGL2. One context draws for every figure of a page, one after the other, and each figure
// keeps a copy on its own canvas: a browser has some 16 contexts. A mesh is {vertices, faces,
// colours (an index of the palette for each face), bodies (of each vertex)}; its bodies move by their poses.
globalThis.course.scene = (() => {
  "use strict";
  const M = globalThis.course.motion;
  const BODY = `#version 300 es
in vec3 at, normal; in vec2 index; uniform mat4 view, poses[24]; uniform vec3 palette[24], lamp;
uniform float ground; uniform bool shadow; out vec3 n, c, p;
void main() {
  mat4 pose = poses[int(index.y)]; vec4 w = pose * vec4(at, 1.);
  vec3 x = pose[0].xyz, y = pose[1].xyz, z = pose[2].xyz; c = palette[int(index.x)];
  n = mat3(cross(y, z), cross(z, x), cross(x, y)) * normal; // right for stretched bodies too
  if (shadow) w.xyz -= lamp * (w.z - ground) / lamp.z;
  p = w.xyz; gl_Position = view * w;
}`;
  const LIT = `#version 300 es
precision highp float; in vec3 n, c, p; uniform vec3 lamp, eye; uniform float opacity, least; uniform bool shadow;
out vec4 rgba;
void main() {
  if (shadow) { rgba = vec4(c, 1.) * opacity; return; }
  vec3 N = normalize(n), L = normalize(lamp), V = normalize(eye - p);
  if (dot(N, V) < 0.) N = -N;
  float light = max(least, .42 + .18 * (.5 + .5 * N.z) + .48 * max(dot(N, L), 0.));
  rgba = vec4(min(c * light + .12 * (1. - least) * pow(max(dot(N, normalize(L + V)), 0.), 40.), 1.), 1.) * opacity;
}`;
  // Lines are ribbons, in pixels: x, y, depth, and the length so far, for dashes.
  const LINE = `#version 300 es
in vec4 at; uniform vec2 size; out float far;
void main() { gl_Position = vec4(2. * at.x / size.x - 1., 1. - 2. * at.y / size.y, at.z, 1.); far = at.w; }`;
  const DASHED = `#version 300 es
precision highp float; in float far; uniform vec4 colour; uniform vec2 dash; out vec4 rgba;
void main() { if (dash.y > 0. && mod(far, dash.y) > dash.x) discard; rgba = colour; }`;
  const LAMP = [0.4, -0.5, 1.2],
    MOST = 24;

  const rgb = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255);

  // Corners of a mesh's triangles: position, normal, colour and body, 8 numbers each. A corner's normal is the mean of
  // the faces around it that lean less than 50 degrees to its own, so that edges stay sharp and the rest is smooth.
  function corners({ vertices, faces, colours, bodies }) {
    const key = (v) =>
      Math.round(v[0] * 1e4) * 1e10 + Math.round(v[1] * 1e4) * 1e5 + Math.round(v[2] * 1e4);
    const keys = vertices.map(key),
      around = new Map(),
      areas = faces.map(([a, b, c]) =>
        M.cross(M.add(vertices[b], vertices[a], -1), M.add(vertices[c], vertices[a], -1)),
      );
    const units = areas.map(M.unit),
      out = new Float32Array(24 * faces.length);
    faces.forEach((face, k) =>
      face.forEach((i) => {
        if (!around.has(keys[i])) around.set(keys[i], []);
        around.get(keys[i]).push(k);
      }),
    );
    faces.forEach((face, k) =>
      face.forEach((i, j) => {
        const [ux, uy, uz] = units[k],
          sum = [0, 0, 0],
          at = 8 * (3 * k + j);
        for (const other of around.get(keys[i])) {
          // written out: robots have twenty thousand of these
          const [vx, vy, vz] = units[other],
            area = areas[other];
          if (ux * vx + uy * vy + uz * vz > 0.63) for (let c = 0; c < 3; c++) sum[c] += area[c];
        }
        out.set(vertices[i], at);
        out.set(M.unit(sum), at + 3);
        out[at + 6] = colours[k];
        out[at + 7] = bodies[i];
      }),
    );
    return out;
  }

  // ---- the one context ----

  const canvas = document.createElement("canvas"),
    redraws = new Set();
  let gl = null,
    programs = null,
    made = new WeakMap();
  function start() {
    gl = gl || canvas.getContext("webgl2", { stencil: true, antialias: false });
    if (!gl) return false;
    if (programs) return !gl.isContextLost();
    const link = (vertex, fragment) => {
      const program = gl.createProgram();
      [
        [gl.VERTEX_SHADER, vertex],
        [gl.FRAGMENT_SHADER, fragment],
      ].forEach(([kind, source]) => {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
      });
      gl.linkProgram(program);
      const places = {};
      return {
        program,
        at: (name) => (places[name] = places[name] || gl.getUniformLocation(program, name)),
      };
    };
    programs = { body: link(BODY, LIT), line: link(LINE, DASHED) };
    ["stream", "ribbon"].forEach(
      (name) => (programs[name] = { array: gl.createVertexArray(), buffer: gl.createBuffer() }),
    );
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthFunc(gl.LEQUAL);
    return !gl.isContextLost();
  }
  // Figures keep their last picture until a lost context is restored.
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => {
    [programs, made] = [null, new WeakMap()];
    redraws.forEach((redraw) => redraw());
  });

  function fill({ array, buffer }, program, data, stride, parts) {
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    parts.forEach(([name, size, from]) => {
      const place = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * stride, 4 * from);
    });
  }
  const CORNER = [
    ["at", 3, 0],
    ["normal", 3, 3],
    ["index", 2, 6],
  ];
  function bind(mesh) {
    // returns how many corners it has; a mesh that is new in every frame is not kept
    if (!mesh.fleeting && made.has(mesh)) {
      gl.bindVertexArray(made.get(mesh).array);
      return made.get(mesh).count;
    }
    const data = corners(mesh),
      count = data.length / 8;
    const own = mesh.fleeting
      ? programs.stream
      : { array: gl.createVertexArray(), buffer: gl.createBuffer(), count };
    fill(own, programs.body.program, data, 8, CORNER);
    if (!mesh.fleeting) made.set(mesh, own);
    return count;
  }

  // For smooth edges a picture is drawn at twice its width and height. Without a graphics card that takes too long while
  // something moves: then only the last picture of a movement is drawn so.
  const rests = new WeakMap(),
    REST = 160; // milliseconds without another picture
  let isSlow = false,
    drawn = 0;
  function draw(context, what, redraw) {
    if (!start()) return;
    const rest = rests.get(context) || { last: -Infinity },
      now = performance.now();
    const moves = isSlow && now - rest.last < REST;
    clearTimeout(rest.timer);
    drawAt(context, what, moves ? 1 : 2);
    if (++drawn === 3) {
      // the first one compiles; reading a pixel waits until it is drawn
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      isSlow = performance.now() - now > 12;
    }
    rests.set(context, {
      last: performance.now(),
      timer: moves ? setTimeout(redraw, REST + 20) : 0,
    });
  }
  // Draw what a figure has listed, `fine` times as large, and copy it into the figure's canvas.
  function drawAt(context, { width, height, dense, view, eye, floor, meshes, lines }, fine) {
    const { body, line } = programs,
      [w, h] = [width, height].map((x) => fine * Math.round(x * dense));
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h]; // all of it is copied below
    gl.viewport(0, 0, w, h);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    const paint = ({ mesh, poses, palette, opacity, least = 0 }) => {
      const count = bind(mesh);
      gl.uniformMatrix4fv(body.at("poses"), true, poses.slice(0, MOST).flat(2));
      gl.uniform3fv(body.at("palette"), palette.slice(0, MOST).flatMap(rgb));
      gl.uniform1f(body.at("opacity"), opacity);
      gl.uniform1f(body.at("least"), least);
      gl.drawArrays(gl.TRIANGLES, 0, count);
    };
    const useBodies = () => {
      gl.useProgram(body.program);
      gl.uniformMatrix4fv(body.at("view"), true, view.flat());
      gl.uniform3fv(body.at("eye"), eye);
      gl.uniform3fv(body.at("lamp"), LAMP);
      gl.uniform1i(body.at("shadow"), 0);
    };
    const stroke = ({ ribbon, colour, dash }) => {
      gl.useProgram(line.program);
      fill(programs.ribbon, line.program, new Float32Array(ribbon), 4, [["at", 4, 0]]);
      gl.uniform2f(line.at("size"), width, height);
      gl.uniform4f(line.at("colour"), ...rgb(colour), 1);
      gl.uniform2fv(line.at("dash"), dash.length ? [dash[0], dash[0] + dash[1]] : [0, 0]);
      gl.drawArrays(gl.TRIANGLES, 0, ribbon.length / 4);
    };
    const on = (...what) => what.forEach((each) => gl.enable(each));
    const off = (...what) => what.forEach((each) => gl.disable(each));
    off(gl.DEPTH_TEST, gl.CULL_FACE, gl.STENCIL_TEST);
    on(gl.BLEND);
    useBodies();
    if (floor && eye[2] > floor.height) {
      on(gl.STENCIL_TEST); // the floor writes 1; there a shadow darkens each pixel once
      gl.stencilFunc(gl.ALWAYS, 1, 3);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
      paint(floor);
      off(gl.STENCIL_TEST);
      lines.filter(({ layer }) => layer === "floor").forEach(stroke);
      on(gl.STENCIL_TEST);
      useBodies();
      gl.stencilFunc(gl.EQUAL, 1, 3);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
      gl.uniform1i(body.at("shadow"), 1);
      gl.uniform1f(body.at("ground"), floor.height);
      meshes
        .filter(({ shadow }) => shadow)
        .forEach((each) =>
          paint({ ...each, palette: each.palette.map(() => floor.shade), opacity: floor.darkness }),
        );
      off(gl.STENCIL_TEST);
      gl.uniform1i(body.at("shadow"), 0);
      on(gl.DEPTH_TEST); // what is below the floor is hidden by it
      gl.colorMask(false, false, false, false);
      paint(floor);
      gl.colorMask(true, true, true, true);
    }
    ["space", "above"].forEach((layer) => {
      if (layer === "above") gl.clear(gl.DEPTH_BUFFER_BIT);
      on(gl.DEPTH_TEST, gl.CULL_FACE);
      useBodies();
      const here = meshes.filter((each) => each.layer === layer);
      here.filter(({ opacity }) => opacity === 1).forEach(paint);
      off(gl.CULL_FACE);
      lines.filter((each) => each.layer === layer).forEach(stroke);
      on(gl.CULL_FACE);
      useBodies();
      // Of a translucent body only the nearest surface is drawn: its depth first, then its colour; farther bodies first.
      here
        .filter(({ opacity }) => opacity < 1)
        .sort((a, b) => b.far - a.far)
        .forEach((each) => {
          gl.colorMask(false, false, false, false);
          paint(each);
          gl.colorMask(true, true, true, true);
          paint(each);
        });
    });
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, w, h);
    context.drawImage(canvas, 0, 0, w / fine, h / fine);
  }

  // ---- simple bodies ----

  const mesh = (vertices, faces, colour, body = 0) => ({
    vertices,
    faces,
    colours: faces.map(() => colour),
    bodies: vertices.map(() => body),
  });
  // Revolve a profile of (radius, height) about the z axis of a pose; a torus if the profile is closed.
  function lathe(T, profile, colour, { body = 0, n = 24, closed = false } = {}) {
    const faces = [],
      m = profile.length,
      at = (i, k) => (i % m) * n + (k % n);
    const vertices = profile.flatMap(([r, h]) =>
      Array.from({ length: n }, (_, k) =>
        M.move(T, [r * Math.cos((2 * Math.PI * k) / n), r * Math.sin((2 * Math.PI * k) / n), h]),
      ),
    );
    for (let i = 0; i < m - (closed ? 0 : 1); i++)
      for (let k = 0; k < n; k++) {
        faces.push(
          [at(i, k), at(i, k + 1), at(i + 1, k + 1)],
          [at(i, k), at(i + 1, k + 1), at(i + 1, k)],
        );
      }
    return mesh(vertices, faces, colour, body);
  }
  function box([lx, ly, lz], [hx, hy, hz], colour) {
    const vertices = [lz, hz].flatMap((z) => [
      [lx, ly, z],
      [hx, ly, z],
      [hx, hy, z],
      [lx, hy, z],
    ]);
    const sides = [
      [0, 3, 2, 1],
      [4, 5, 6, 7],
      [0, 1, 5, 4],
      [1, 2, 6, 5],
      [2, 3, 7, 6],
      [3, 0, 4, 7],
    ];
    return mesh(
      vertices,
      sides.flatMap(([a, b, c, d]) => [
        [a, b, c],
        [a, c, d],
      ]),
      colour,
    );
  }
  const ring = (T, radius, width, colour) => {
    const section = [
      [radius - width, -width],
      [radius, -width],
      [radius, width],
      [radius - width, width],
    ];
    return lathe(T, section, colour, { n: 64, closed: true });
  };
  const ball = (n = 24) =>
    lathe(
      M.eye(4),
      Array.from({ length: n / 2 + 1 }, (_, i) => [
        Math.sin((2 * Math.PI * i) / n),
        -Math.cos((2 * Math.PI * i) / n),
      ]),
      0,
      { n },
    );
  function join(meshes) {
    let first = 0;
    const faces = meshes.flatMap((each) => {
      const moved = each.faces.map((face) => face.map((i) => i + first));
      first += each.vertices.length;
      return moved;
    });
    const all = (name) => meshes.flatMap((each) => each[name]);
    return { vertices: all("vertices"), faces, colours: all("colours"), bodies: all("bodies") };
  }
  // Along z from 0 to 1: the shaft is body 0, the head body 1, each to be scaled by its pose.
  const arrow = join([
    lathe(
      M.eye(4),
      [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ],
      0,
      { n: 14 },
    ),
    lathe(
      M.eye(4),
      [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
      0,
      { body: 1, n: 18 },
    ),
  ]);
  const disc = lathe(
    M.eye(4),
    [
      [1, 0],
      [0, 0],
    ],
    0,
    { n: 64 },
  );
  // A small aircraft, nose along x, wings along y: every orientation of it looks different.
  const PALETTE = ["#e8eaed", "#8d959e", "#0072b2", "#009e73", "#d55e00", "#e69f00"];
  const FUSELAGE = [
    [0, -0.8],
    [0.07, -0.75],
    [0.13, -0.5],
    [0.16, -0.2],
    [0.17, 0.2],
    [0.14, 0.5],
    [0.08, 0.75],
    [0, 0.85],
  ];
  const aircraft = join([
    lathe(M.pose(M.rotation([0, 1, 0], Math.PI / 2), [0, 0, 0]), FUSELAGE, 0, { n: 28 }),
    box([-0.2, -0.85, -0.03], [0.2, 0.85, 0.03], 2),
    box([-0.78, -0.3, -0.02], [-0.55, 0.3, 0.02], 2),
    box([-0.78, -0.02, 0.04], [-0.55, 0.02, 0.38], 4),
  ]);
  // A model as Python packs it (course_lib.figures.toys.toy.solid): whole numbers in base64.
  function unpack({ vertices, faces, colours, bodies, palette }) {
    const read = (text, Kind) =>
      Array.from(new Kind(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer));
    const triples = (flat) =>
      Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3));
    return {
      vertices: triples(read(vertices, Int16Array).map((x) => x / 1e4)),
      faces: triples(read(faces, Uint16Array)),
      colours: read(colours, Uint8Array),
      bodies: read(bodies, Uint8Array),
      palette,
    };
  }

  return {
    start,
    draw,
    redraws,
    mesh,
    lathe,
    box,
    ring,
    ball,
    join,
    arrow,
    disc,
    aircraft,
    PALETTE,
    unpack,
  };
})();
