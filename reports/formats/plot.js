// Pictures of curves that readers zoom, move and read. Each has a toolbar, and a line that tells the point nearest to
// the pointer; arrow keys go from point to point. Without this script they are plain pictures.
'use strict';

const plots = (() => {
  const SUPERSCRIPT = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹'};
  const MOST_ZOOM = 64, LEAST_ZOOM = 0.5, DRAG = 4, NEAR = 40;

  const element = (name, attributes = {}, ...children) => {
    const made = document.createElementNS(name === 'svg' || 'path circle text g'.split(' ').includes(name)
      ? 'http://www.w3.org/2000/svg' : 'http://www.w3.org/1999/xhtml', name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    made.append(...children);
    return made;
  };

  // An axis: `low` and `high` are what is seen, in powers of ten where it is logarithmic.
  class Axis {
    constructor(text) {
      const [low, high, kind, unit] = text.split(' ');
      Object.assign(this, {low: +low, high: +high, whole: [+low, +high], logarithmic: kind === 'log',
                           dateUnit: kind === 'date' ? +unit : 0});
    }
    get size() { return this.high - this.low; }
    zoom() { return (this.whole[1] - this.whole[0]) / this.size; }
    scaled(value) { return this.logarithmic ? Math.log10(value) : value; }
    value(place) {
      const scaled = this.low + place * this.size;
      return this.logarithmic ? 10 ** scaled : scaled;
    }
    place(value) { return (this.scaled(value) - this.low) / this.size; }
    placed(value) { return (this.scaled(value) - this.whole[0]) / (this.whole[1] - this.whole[0]); }
    fromWhole(place) {
      const scaled = this.whole[0] + place * (this.whole[1] - this.whole[0]);
      return this.logarithmic ? 10 ** scaled : scaled;
    }
    // Round steps of minutes to months, as dates or, where they are finer, with the time of day.
    dateTicks() {
      const result = [], size = this.size * this.dateUnit;
      const steps = [1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600, 7200, 21600, 43200, 86400, 172800, 345600, 604800];
      const month = 2629746, months = [1, 2, 3, 6, 12, 24, 60, 120, 240, 600, 1200, 2400, 12000];
      const date = seconds => new Date(1000 * seconds).toISOString();
      if (size > 3 * month) {
        const step = months.find(n => size <= 6 * n * month) || 12000;
        const first = new Date(1000 * this.low * this.dateUnit);
        for (let n = Math.floor((12 * first.getUTCFullYear() + first.getUTCMonth()) / step) * step; ; n += step) {
          const seconds = Date.UTC(Math.floor(n / 12), n % 12, 1) / 1000;
          if (seconds > this.high * this.dateUnit) return result;
          if (seconds >= this.low * this.dateUnit)
            result.push([seconds / this.dateUnit, date(seconds).slice(0, step % 12 ? 7 : 4)]);
        }
      }
      const step = steps.find(s => size <= 6 * s) || 1209600;
      for (let n = Math.ceil(this.low * this.dateUnit / step); n * step <= this.high * this.dateUnit; ++n)
        result.push([n * step / this.dateUnit, n * step % 86400 === 0 ? date(n * step).slice(0, 10)
          : date(n * step).slice(11, step < 60 ? 19 : 16)]);
      return result;
    }
    ticks() {
      if (this.dateUnit > 0) return this.dateTicks();
      const result = [];
      if (this.logarithmic && this.size >= 2) {
        const step = Math.ceil(this.size / 7);
        for (let power = Math.ceil(this.low / step) * step; power <= this.high; power += step)
          result.push([10 ** power, '10' + [...String(power)].map(c => SUPERSCRIPT[c]).join('')]);
        return result;
      }
      const [low, high] = this.logarithmic ? [10 ** this.low, 10 ** this.high] : [this.low, this.high];
      const rough = (high - low) / 5, unit = 10 ** Math.floor(Math.log10(rough)), share = rough / unit;
      const step = unit * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
      const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
      for (let tick = Math.ceil(low / step); tick * step <= high; ++tick)
        result.push([tick * step, places > 8 ? (tick * step).toPrecision(6) : (tick * step).toFixed(places)]);
      for (const tick of result) tick[1] = withMinus(tick[1]);
      return result;
    }
    // A number as exactly as the picture tells it.
    text(value) {
      if (this.dateUnit > 0) return new Date(1000 * value * this.dateUnit).toISOString().slice(0, 19);
      const digits = Math.min(12, 3 + Math.max(0, Math.ceil(Math.log10(this.zoom()))));
      return withMinus(+value.toPrecision(digits + 1));
    }
  }

  class Plot {
    constructor(svg) {
      this.svg = svg;
      this.across = new Axis(svg.dataset.across);
      this.up = new Axis(svg.dataset.up);
      this.plane = svg.classList.contains('plane');
      const view = svg.querySelector('.window').viewBox.baseVal;
      this.box = {x: view.x, y: view.y, width: view.width, height: view.height};
      this.moving = svg.querySelector('.moving');
      this.series = [...svg.querySelectorAll('.series')];
      this.cursor = element('circle', {class: 'cursor', r: 4, visibility: 'hidden'});
      svg.querySelector('.window').append(this.cursor);
      svg.tabIndex = 0;
      this.addTools();
      this.addPointer();
      svg.addEventListener('keydown', event => this.key(event));
      svg.addEventListener('blur', () => this.forget());
    }

    addTools() {
      this.reading = element('output', {class: 'reading', 'aria-live': 'polite'});
      const tools = element('div', {class: 'tools'});
      for (const [sign, name, act] of [['+', 'closer', () => this.zoom(1.5)],
                                       ['−', 'farther', () => this.zoom(1 / 1.5)],
                                       ['⤢', 'whole picture', () => this.whole()]]) {
        const button = element('button', {type: 'button', title: name, 'aria-label': name}, sign);
        button.onclick = act;
        tools.append(button);
      }
      this.svg.after(element('div', {class: 'below'}, this.reading, tools));
      const keys = [...(this.svg.parentElement.querySelectorAll('.legend .key') || [])];
      const labelled = this.series.filter(one => one.dataset.label);
      keys.forEach((key, i) => key.onclick = () => {
        const shown = key.getAttribute('aria-pressed') !== 'true';
        key.setAttribute('aria-pressed', shown);
        labelled[i].style.display = shown ? '' : 'none';
        this.forget();
      });
    }

    // The place of an event in the box: 0 to 1 from left and from below.
    at(event) {
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      return [(point.x - this.box.x) / this.box.width, 1 - (point.y - this.box.y) / this.box.height];
    }

    addPointer() {
      const pointers = new Map();
      let start = null, moved = false;
      this.svg.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        pointers.set(event.pointerId, this.at(event));
        this.svg.setPointerCapture(event.pointerId);
        start = this.state();
        start.at = [event.clientX, event.clientY];
        start.spread = this.spread(pointers);
        moved = false;
      });
      this.svg.addEventListener('pointermove', event => {
        if (!pointers.has(event.pointerId)) {
          if (event.pointerType === 'mouse') this.read(...this.at(event));
          return;
        }
        if (!moved && Math.hypot(event.clientX - start.at[0], event.clientY - start.at[1]) < DRAG) return;
        if (!moved && event.pointerType !== 'mouse' && pointers.size === 1 && this.across.zoom() === 1) return;
        moved = true;
        const before = pointers.get(event.pointerId), now = this.at(event);
        if (pointers.size === 1) {
          this.move(before[0] - now[0], before[1] - now[1]);
        } else {
          pointers.set(event.pointerId, now);
          const spread = this.spread(pointers);
          this.zoom(spread / start.spread, ...this.middle(pointers));
          start.spread = spread;
        }
        pointers.set(event.pointerId, this.at(event));
      });
      const end = event => {
        if (pointers.delete(event.pointerId) && !moved) this.read(...this.at(event));
        start = start && {...start, spread: this.spread(pointers)};
      };
      this.svg.addEventListener('pointerup', end);
      this.svg.addEventListener('pointercancel', end);
      this.svg.addEventListener('pointerleave', event => event.pointerType === 'mouse' && this.forget());
      this.svg.addEventListener('dblclick', event => {
        event.preventDefault();
        this.zoom(event.shiftKey ? 1 / 2 : 2, ...this.at(event));
      });
      // The wheel belongs to the page until a reader has chosen the picture.
      this.svg.addEventListener('wheel', event => {
        if (!event.ctrlKey && document.activeElement !== this.svg) return;
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY / 400), ...this.at(event));
      }, {passive: false});
    }

    spread(pointers) {
      const [a, b] = [...pointers.values()];
      return b ? Math.max(0.02, Math.hypot(a[0] - b[0], a[1] - b[1])) : 1;
    }
    middle(pointers) {
      const [a, b] = [...pointers.values()];
      return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    }
    state() { return {across: [this.across.low, this.across.high], up: [this.up.low, this.up.high]}; }

    zoom(factor, x = 0.5, y = 0.5) {
      const now = this.across.zoom(), wanted = Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, now * factor));
      for (const [axis, place] of [[this.across, x], [this.up, y]]) {
        const fixed = axis.low + place * axis.size, size = axis.size * now / wanted;
        axis.low = fixed - place * size;
        axis.high = axis.low + size;
      }
      this.draw();
    }
    move(x, y) {
      for (const [axis, share] of [[this.across, x], [this.up, y]]) {
        const shift = share * axis.size;
        axis.low += shift;
        axis.high += shift;
      }
      this.draw();
    }
    whole() {
      for (const axis of [this.across, this.up]) [axis.low, axis.high] = axis.whole;
      this.draw();
    }

    draw() {
      const {x, y, width, height} = this.box;
      const scale = [this.across.zoom(), this.up.zoom()];
      const shift = [(this.across.whole[0] - this.across.low) / this.across.size * width + x,
                     y + height - (this.up.whole[0] - this.up.low) / this.up.size * height];
      this.moving.setAttribute('transform', `translate(${shift[0]} ${shift[1]}) scale(${scale[0]} ${scale[1]}) ` +
                               `translate(${-x} ${-(y + height)})`);
      this.drawAxes();
      this.drawCursor();
    }
    drawAxes() {
      const axes = this.svg.querySelector('.axes');
      if (!axes) return;
      const {x, y, width, height} = this.box, floor = y + height, texts = [];
      let lines = '';
      for (const [value, text] of this.across.ticks()) {
        const place = (x + this.across.place(value) * width).toFixed(1);
        lines += `M${place},${y}V${floor}`;
        texts.push(element('text', {x: place, y: floor + 18}, text));
      }
      for (const [value, text] of this.up.ticks()) {
        const place = floor - this.up.place(value) * height;
        lines += `M${x},${place.toFixed(1)}H${x + width}`;
        texts.push(element('text', {class: 'y', x: x - 7, y: (place + 4).toFixed(1)}, text));
      }
      axes.querySelector('.grid').setAttribute('d', lines);
      const zero = axes.querySelector('.zero'), ground = this.up.place(0);
      const inside = ground >= 0 && ground <= 1;
      if (zero) zero.setAttribute('d', inside ? `M${x},${floor - ground * height}H${x + width}` : '');
      axes.querySelector('.ticks').replaceChildren(...texts);
    }

    // The points of a series, as [x, y] or [x, y, what to tell].
    points(series) {
      if (!series.points) {
        const {x, y, width, height} = this.box, path = series.querySelector('path');
        series.points = series.dataset.points ? JSON.parse(series.dataset.points)
          : [...path.getAttribute('d').matchAll(/(-?[\d.]+),(-?[\d.]+)/g)].map(([, across, up]) =>
              [this.across.fromWhole((across - x) / width), this.up.fromWhole((y + height - up) / height)]);
      }
      return series.points;
    }
    shown() { return this.series.filter(one => one.style.display !== 'none' && !one.matches('.cells')); }

    // Tells the point nearest to a place, or the value of the curve there.
    read(x, y) {
      const {width, height} = this.box;
      let best = null;
      for (const series of this.shown()) {
        const points = this.points(series), told = 'points' in series.dataset;
        points.forEach((point, i) => {
          let [px, py] = [this.across.place(point[0]), this.up.place(point[1])];
          if (!told && i + 1 < points.length) {  // the nearest place of the line to the next point
            const qx = this.across.place(points[i + 1][0]), qy = this.up.place(points[i + 1][1]);
            const dx = (qx - px) * width, dy = (qy - py) * height, length = dx * dx + dy * dy;
            const t = length === 0 ? 0
              : Math.min(1, Math.max(0, ((x - px) * width * dx + (y - py) * height * dy) / length));
            [px, py] = [px + t * (qx - px), py + t * (qy - py)];
          }
          const distance = Math.hypot((px - x) * width, (py - y) * height);
          if (!best || distance < best.distance)
            best = {distance, series, index: i, point: told ? point : [this.across.value(px), this.up.value(py)]};
        });
      }
      if (best && best.distance < NEAR) this.tell(best);
      else this.forget();
    }
    tell(found) {
      this.found = found;
      const [x, y, text] = found.point, label = found.series.dataset.label;
      const told = 'points' in found.series.dataset;
      this.reading.textContent = (label ? label + ': ' : '') + (text ||
        (told ? withMinus(`${+x.toPrecision(12)}, ${+y.toPrecision(12)}`) : `${this.across.text(x)}, ${this.up.text(y)}`));
      this.drawCursor();
    }
    drawCursor() {
      this.cursor.setAttribute('visibility', this.found ? 'visible' : 'hidden');
      if (!this.found) return;
      const {x, y, width, height} = this.box, [px, py] = this.found.point;
      this.cursor.setAttribute('cx', x + this.across.place(px) * width);
      this.cursor.setAttribute('cy', y + height - this.up.place(py) * height);
    }
    forget() {
      this.found = null;
      this.reading.textContent = '';
      this.drawCursor();
    }

    // From point to point, or from series to series.
    step(points, series) {
      const shown = this.shown();
      if (!shown.length) return;
      let at = this.found ? Math.max(0, shown.indexOf(this.found.series)) : 0;
      at = (at + series + shown.length) % shown.length;
      const list = this.points(shown[at]), far = Math.max(1, Math.round(list.length / 50));
      const from = this.found ? this.found.index + points * ('points' in shown[at].dataset ? 1 : far) : 0;
      const index = Math.min(list.length - 1, Math.max(0, from));
      if (list.length) this.tell({series: shown[at], index, point: list[index]});
    }
    key(event) {
      const shifts = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};
      const shift = event.shiftKey && shifts[event.key];
      const actions = {ArrowLeft: () => this.step(-1, 0), ArrowRight: () => this.step(1, 0),
                       ArrowUp: () => this.step(0, -1), ArrowDown: () => this.step(0, 1), '+': () => this.zoom(1.5),
                       '=': () => this.zoom(1.5), '-': () => this.zoom(1 / 1.5), 0: () => this.whole(),
                       Escape: () => this.svg.blur()};
      if (shift) this.move(...shift);
      else if (actions[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) actions[event.key]();
      else return;
      event.preventDefault();
    }
  }

  return [...document.querySelectorAll('svg.picture')].map(svg => new Plot(svg));
})();
