// Surfaces that readers turn: by dragging, by arrow keys, nearer and farther by + and -. Facets are shaded and painted
// from the back to the front on a plain canvas.
'use strict';

(() => {
  const HOLE = 65535, LOW = [11, 85, 159], MIDDLE = [228, 231, 235], HIGH = [192, 57, 43], LIGHT = [0.35, -0.45, 0.82];
  const MIDDLE_LIGHT = 0.45;  // of a facet that light does not reach

  function points_of(data) {
    const bytes = Uint8Array.from(atob(data.points), c => c.charCodeAt(0)), steps = new DataView(bytes.buffer);
    const sizes = data.high.map((high, c) => high - data.low[c]), points = [];
    // Functions fill a box; surfaces keep their shape.
    const most = Math.max(...sizes), scale = data.heights ? [1, 1, 0.6].map((share, c) => share / (sizes[c] || 1))
                                                          : [1, 1, 1].map(() => 1.2 / most);
    for (let i = 0; i < data.columns * data.rows; ++i) {
      const read = c => steps.getUint16((3 * i + c) * 2, true);
      points.push(read(0) === HOLE ? null
        : [0, 1, 2].map(c => (read(c) / (HOLE - 1) - 0.5) * sizes[c] * scale[c]));
    }
    return points;
  }

  function facets_of(data, points) {
    const facets = [], {columns, rows, closed: [x, y], values} = data;
    for (let j = 0; j + (y ? 0 : 1) < rows; ++j)
      for (let i = 0; i + (x ? 0 : 1) < columns; ++i) {
        const places = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]
          .map(([a, b]) => (b % rows) * columns + a % columns);
        const corners = places.map(place => points[place]);
        if (corners.includes(null)) continue;
        const [a, b, c, d] = corners, p = [0, 1, 2].map(k => c[k] - a[k]), q = [0, 1, 2].map(k => d[k] - b[k]);
        const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        const length = Math.hypot(...normal) || 1;
        // From 0 to 1, where values and not heights have colours.
        const share = values && places.reduce((sum, place) => sum + values[place], 0) / 800 + 0.5;
        facets.push({corners, share, normal: normal.map(part => part / length),
                     middle: [0, 1, 2].map(k => (a[k] + b[k] + c[k] + d[k]) / 4)});
      }
    return facets;
  }

  class View {
    constructor(data) {
      this.data = data;
      this.facets = facets_of(data, points_of(data));
      const heights = this.facets.map(facet => facet.middle[2]);
      this.floor = Math.min(...heights);
      this.height = Math.max(...heights) - this.floor || 1;
      this.turn = -0.6;
      this.tilt = 0.55;
      this.near = 1;
      this.canvas = document.createElement('canvas');
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute('role', 'img');
      this.canvas.setAttribute('aria-label', (data.title || 'surface') + '; arrow keys turn it');
      this.element = document.createElement('div');
      this.element.className = 'surface';
      const title = document.createElement('h4');
      title.textContent = data.title;
      this.element.append(title, this.canvas);
      this.listen();
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    listen() {
      const {canvas} = this;
      let last = null;
      canvas.addEventListener('pointerdown', event => {
        last = [event.clientX, event.clientY];
        canvas.setPointerCapture(event.pointerId);
      });
      canvas.addEventListener('pointermove', event => {
        if (!last) return;
        this.by((event.clientX - last[0]) / 120, (event.clientY - last[1]) / 120);
        last = [event.clientX, event.clientY];
      });
      for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { last = null; });
      canvas.addEventListener('wheel', event => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;
        event.preventDefault();
        this.closer(Math.exp(-event.deltaY / 500));
      }, {passive: false});
      canvas.addEventListener('keydown', event => {
        const actions = {ArrowLeft: () => this.by(-0.1, 0), ArrowRight: () => this.by(0.1, 0),
                         ArrowUp: () => this.by(0, -0.1), ArrowDown: () => this.by(0, 0.1),
                         '+': () => this.closer(1.2), '=': () => this.closer(1.2), '-': () => this.closer(1 / 1.2)};
        if (!actions[event.key] || event.ctrlKey || event.metaKey) return;
        event.preventDefault();
        actions[event.key]();
      });
    }
    by(turn, tilt) {
      this.turn += turn;
      this.tilt = Math.min(1.57, Math.max(-1.57, this.tilt + tilt));
      this.draw();
    }
    closer(factor) {
      this.near = Math.min(8, Math.max(0.5, this.near * factor));
      this.draw();
    }
    draw() {
      if (this.drawing) return;
      this.drawing = requestAnimationFrame(() => {
        this.drawing = 0;
        this.paint();
      });
    }

    paint() {
      const {canvas, turn, tilt} = this, ratio = devicePixelRatio || 1;
      const width = canvas.clientWidth * ratio, height = canvas.clientHeight * ratio;
      if (!width) return;
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
      const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
      const unit = Math.min(width / 1.55, height / 1.25) * this.near;
      const turned = ([x, y, z]) => {
        const across = c * x - s * y, away = s * x + c * y;
        return [across, ct * z + st * away, ct * away - st * z];
      };
      const context = canvas.getContext('2d');
      context.clearRect(0, 0, width, height);
      context.lineWidth = 0.7 * ratio;
      context.lineJoin = 'round';
      const seen = this.facets.map(facet => [turned(facet.middle)[2], facet]).sort((a, b) => b[0] - a[0]);
      for (const [, facet] of seen) {
        const light = MIDDLE_LIGHT + (1 - MIDDLE_LIGHT) *
          Math.abs(facet.normal[0] * LIGHT[0] + facet.normal[1] * LIGHT[1] + facet.normal[2] * LIGHT[2]);
        const share = facet.share ?? (facet.middle[2] - this.floor) / this.height;
        const [from, to, part] = share < 0.5 ? [LOW, MIDDLE, 2 * share] : [MIDDLE, HIGH, 2 * share - 1];
        const colour = `rgb(${from.map((value, k) => Math.round((value + part * (to[k] - value)) * light)).join(' ')})`;
        context.beginPath();
        for (const corner of facet.corners) {
          const [x, y] = turned(corner);
          context.lineTo(width / 2 + x * unit, height / 2 - y * unit);
        }
        context.closePath();
        context.fillStyle = context.strokeStyle = colour;
        context.fill();
        context.stroke();
      }
    }
  }

  for (const button of document.querySelectorAll('button.turn')) {
    button.onclick = async () => {
      const place = button.parentElement;
      try {
        const surfaces = await load_file(button.dataset.surfaces);
        place.replaceChildren(...surfaces.map(data => new View(data).element));
        place.querySelector('canvas').focus();
      } catch (error) {
        button.textContent = error.message;
      }
    };
  }
  for (const place of document.querySelectorAll('[data-surface]'))
    place.append(new View(JSON.parse(place.dataset.surface)).element);
})();
