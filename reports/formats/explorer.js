// A parameter that is moved: everything was computed before; here it is only shown.
'use strict';

(() => {
  const {letter, values, curve} = JSON.parse(document.getElementById('explorer').textContent);
  const form = document.querySelector('form.explorer'), slider = form.querySelector('input');
  const place = name => document.querySelector(`[data-shows=${name}]`);
  const LEFT = 44, RIGHT = 400, TOP = 10, BOTTOM = 230;

  const element = (name, attributes, text = '') => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    made.textContent = text;
    return made;
  };
  const ends = numbers => numbers.reduce(([low, high], one) => [Math.min(low, one), Math.max(high, one)], [0, 0]);

  // Multiples of 1, 2 or 5 times a power of ten, and how they are written, as in the pictures of other pages.
  function* ticks(low, high) {
    const rough = (high - low) / 5 || 1, unit = 10 ** Math.floor(Math.log10(rough)), share = rough / unit;
    const step = unit * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    for (let k = Math.ceil(low / step); k * step <= high; ++k) yield [k * step, withMinus((k * step + 0).toFixed(places))];
  }

  // One frame for all values, so that what moves is the curve.
  class Picture {
    constructor(name, [left, right], [low, high]) {
      const margin = (high - low || 1) / 20;
      Object.assign(this, {svg: place(name), left, right, low: low < 0 ? low - margin : low, high: high + margin});
    }
    x(value) { return (LEFT + (value - this.left) / (this.right - this.left || 1) * (RIGHT - LEFT)).toFixed(1); }
    y(value) { return (BOTTOM - (value - this.low) / (this.high - this.low) * (BOTTOM - TOP)).toFixed(1); }
    clear() {
      this.svg.replaceChildren();
      const axes = element('g', {class: 'axes'}), labels = element('g', {class: 'ticks'});
      let grid = '';
      for (const [x, text] of ticks(this.left, this.right)) {
        grid += `M${this.x(x)},${TOP}V${BOTTOM}`;
        labels.append(element('text', {x: this.x(x), y: BOTTOM + 18}, text));
      }
      for (const [y, text] of ticks(this.low, this.high)) {
        grid += `M${LEFT},${this.y(y)}H${RIGHT}`;
        labels.append(element('text', {class: 'y', x: LEFT - 5, y: +this.y(y) + 4}, text));
      }
      axes.append(element('path', {class: 'grid', d: grid}), labels);
      this.svg.append(axes);
    }
    line(points, colour, dashes = '') {
      const d = points.map(([x, y], i) => `${i ? 'L' : 'M'}${this.x(x)},${this.y(y)}`).join('');
      this.svg.append(element('path', {d, fill: 'none', stroke: `var(--curve-${colour})`, 'stroke-width': 2,
                                       'stroke-dasharray': dashes}));
    }
  }

  const drawn = values.filter(one => one.limit);
  const last = one => one.limit.from + one.limit.step * (one.limit.values.length - 1);
  const width = ends(drawn.flatMap(one => [one.limit.from, last(one)]));
  const pictures = {
    curve: new Picture('curve', [values[0].at, values.at(-1).at], ends(curve.flatMap(piece => piece.slice(2)))),
    limit: new Picture('limit', width, ends(drawn.flatMap(one => one.limit.values))),
    variance: new Picture('variance', [0, 1], ends(drawn.flatMap(one => one.variance || []))),
  };

  function show() {
    const one = values[slider.value];
    form.querySelector('output').textContent = withMinus(one.text);
    place('mask').textContent = one.mask.replaceAll(',', ',\u200b');
    place('value').textContent = withMinus(one.exponent || one.note);
    for (const name in pictures) pictures[name].clear();
    for (const [from, to, lower, upper] of curve) {
      if (lower !== null) pictures.curve.line([[from, lower], [to, lower]], 1);
      if (upper !== null) pictures.curve.line([[from, upper], [to, upper]], 2);
    }
    pictures.curve.line([[one.at, pictures.curve.low], [one.at, pictures.curve.high]], 3, '4 3');
    if (one.limit)
      pictures.limit.line(one.limit.values.map((y, i) => [one.limit.from + i * one.limit.step, y]), 1);
    if (one.variance) pictures.variance.line(one.variance.map((y, i) => [i / (one.variance.length - 1), y]), 1);
    for (const name in pictures)
      pictures[name].svg.setAttribute('aria-label', `${name} for ${letter} = ${one.text}`);
  }
  slider.addEventListener('input', show);
  form.addEventListener('submit', event => event.preventDefault());
  show();
})();
