// Checks certificates about subdivision schemes, written from ../certificates/SPEC.md alone, whose sections, theorems
// and lemmas are cited. What decides is computed with BigInts, and with Numbers that are small integers. A plain script
// with one global function: no module, no node, no DOM.
'use strict';

var check_certificate = (() => {
  class Rejection extends Error {}
  const demand = (condition, why) => { if (!condition) throw new Rejection(why); };

  // Section 2: work is counted in products of 64-bit limbs; every operation costs 40 of them besides.
  const max_work = 8e9, max_bits = 2 ** 32, too_much_work = 'more work than the checker allows';
  let work = 0;
  const spend = (operations, bits_a = 64, bits_b = 64) => {
    const a = Math.ceil(bits_a / 64), b = Math.ceil(bits_b / 64);
    work += operations * (40 + Math.max(a, b) * Math.min(a, b, 64));
    demand(work <= max_work, too_much_work);
  };
  const allow_bits = bits => demand(bits <= max_bits, too_much_work);  // of memory, before it is taken

  // ---- Integers -----------------------------------------------------------------------------------------------------
  const abs = x => x < 0n ? -x : x;
  const max = (x, y) => x < y ? y : x;
  const sum = numbers => numbers.reduce((x, y) => x + y, 0n);
  const norm = numbers => numbers.reduce((total, x) => x < 0n ? total - x : total + x, 0n);  // |x|_1
  const largest = numbers => numbers.reduce((most, x) => x > most ? x : -x > most ? -x : most, 0n);
  const largest_by = (list, size) => list.reduce((most, x) => max(most, size(x)), 0n);
  const bits = x => {
    const digits = abs(x).toString(16);
    return x === 0n ? 0 : 4 * digits.length + 28 - Math.clz32(parseInt(digits[0], 16));
  };
  const floor_div = (x, y) => {  // y > 0
    const quotient = x / y;
    return x < 0n && quotient * y !== x ? quotient - 1n : quotient;
  };
  const ceil_div = (x, y) => -floor_div(-x, y);
  const shift = (x, by) => by < 0 ? x >> BigInt(-by) : x << BigInt(by);  // rounded down
  const different = (list, key) => [...new Map(list.map(x => [key(x), x])).values()];
  const gcd = (x, y) => {
    spend(1 + Math.min(bits(x), bits(y)), 64, Math.max(bits(x), bits(y)));
    while (y) [x, y] = [y, x % y];
    return abs(x);
  };
  const lcm = (x, y) => x / gcd(x, y) * y;
  const root = x => {  // floor of the square root
    if (x < 2n) return x;
    for (let r = 1n << BigInt((bits(x) + 1) >> 1);;) {
      const next = (r + x / r) >> 1n;
      if (next >= r) return r;
      r = next;
    }
  };

  // ---- Fractions {n, d}, d > 0, not reduced unless they were read; integers stand for fractions ---------------------
  const fraction = (x, d = 1n) => typeof x === 'object' ? x : {n: BigInt(x), d};
  const operation = result => (x, y) => result(fraction(x), fraction(y));
  const reduced = x => { const g = gcd(x.n, x.d); return fraction(x.n / g, x.d / g); };
  const plus = operation((x, y) => fraction(x.n * y.d + y.n * x.d, x.d * y.d));
  const minus = operation((x, y) => fraction(x.n * y.d - y.n * x.d, x.d * y.d));
  const times = operation((x, y) => fraction(x.n * y.n, x.d * y.d));
  const over = operation((x, y) => y.n < 0n ? fraction(-x.n * y.d, -x.d * y.n) : fraction(x.n * y.d, x.d * y.n));
  const less = operation((x, y) => x.n * y.d < y.n * x.d);
  const abs_of = x => fraction(abs(x.n), x.d);
  const horner = (p, x) => p.reduceRight((total, c) => {
    const result = plus(times(total, x), c);
    spend(4, bits(result.n), bits(x.d));
    return result;
  }, fraction(0n));
  const sign = x => x.n < 0n ? -1 : x.n > 0n ? 1 : 0;
  const power = (x, k) => {
    allow_bits((bits(x.n) + bits(x.d)) * k * 64);
    return fraction(x.n ** BigInt(k), x.d ** BigInt(k));
  };
  const round_up = x => {  // to 128 bits, section 7
    const by = bits(x.n) - bits(x.d) - 128;
    return by > 0 ? fraction(ceil_div(x.n, x.d << BigInt(by)) << BigInt(by))
                  : fraction(ceil_div(x.n << BigInt(-by), x.d), 1n << BigInt(-by));
  };
  // |re + i im| of integers, rounded down or up at 320 bits (4.5)
  const modulus_below = (re, im) => im ? fraction(root((re * re + im * im) << 640n), 1n << 320n) : fraction(abs(re));
  const modulus_above = (re, im) => re || im ? plus(modulus_below(re, im), fraction(1n, 1n << 320n)) : fraction(0n);
  function power_below(base, e) {  // 4.2: at most base^e
    const whole = floor_div(e.n, e.d);
    let rest = e.n - whole * e.d, result = 1n << 320n, factor = base << 320n;
    for (let digit = 0; digit < 128 && rest; ++digit) {
      factor = root(factor << 320n);
      rest *= 2n;
      if (rest < e.d) continue;
      rest -= e.d;
      result = (result * factor) >> 320n;
    }
    return whole < 0n ? fraction(result, base ** -whole << 320n) : fraction(result * base ** whole, 1n << 320n);
  }

  // ---- Packed vectors: x_0 + x_1 2^width + ..., all |x_i| < 2^(width - 1) -------------------------------------------
  // Sums and multiples of vectors are those of the integers as long as the results keep that bound. Many small products
  // become few long ones, which is faster.
  const pack = (numbers, width, from = 0, to = numbers.length) => {
    if (to - from === 1) return numbers[from];
    const middle = (from + to) >> 1;
    return pack(numbers, width, from, middle) + (pack(numbers, width, middle, to) << BigInt(width * (middle - from)));
  };
  const drop = (packed, n) => (packed >> BigInt(n)) + (BigInt.asIntN(n, packed) < 0n ? 1n : 0n);  // the n lowest bits
  const unpack = (packed, width, count, out = []) => {
    if (count === 1) {
      out.push(packed);
      return out;
    }
    const half = count >> 1;
    unpack(BigInt.asIntN(width * half, packed), width, half, out);
    return unpack(drop(packed, width * half), width, count - half, out);
  };
  const combine = (factors, vectors) => {
    let total = 0n;
    for (let k = 0; k < factors.length; ++k) if (factors[k]) total += factors[k] * vectors[k];
    return total;
  };
  // Polynomials with integer coefficients, from that of z^0 on
  function product_of(x, y) {
    const width = bits(largest(x)) + bits(largest(y)) + bits(BigInt(x.length)) + 2;
    allow_bits(4 * width * (x.length + y.length));
    spend(1, width * x.length, width * y.length);
    spend(4 * (x.length + y.length), width);
    return unpack(pack(x, width) * pack(y, width), width, x.length + y.length - 1);
  }
  function quotient_of(x, y) {  // without remainder, null where there is none; the last coefficient of y is not 0
    const rest = x.slice(), n = y.length - 1, size = bits(largest(y)), quotient = [];
    for (let i = x.length - 1 - n; i >= 0; --i) {
      const c = rest[i + n] / y[n];
      spend(y.length + 1, bits(c), size);
      y.forEach((value, k) => { rest[i + k] -= c * value; });
      if (rest[i + n]) return null;
      quotient[i] = c;
    }
    return rest.every(value => !value) ? quotient : null;
  }
  function shifted_signs(p, {n, d}) {  // of the coefficients of p(x + n/d)
    const top = p.length - 1, size = top * (bits(n) + bits(d)) + bits(largest(p)) + top;
    allow_bits(size * p.length);
    spend(top * top / 2, size, bits(n));
    spend(2 * top, size, size);
    const c = p.map((x, i) => x * d ** BigInt(top - i));
    for (let i = 0; i < top; ++i) for (let k = top - 1; k >= i; --k) c[k] += c[k + 1] * n;
    return c.map(x => x < 0n ? -1 : x > 0n ? 1 : 0);
  }
  const sign_changes = signs => signs.filter(x => x).filter((x, i, all) => i && x !== all[i - 1]).length;

  // ---- Matrices: arrays of rows of integers. A family: {size, den, matrices}, each matrix divided by den. -----------
  const range_of = n => Array.from({length: n}, (_, i) => i);
  const largest_of = matrix => largest_by(matrix, largest);
  const transpose = matrix => matrix[0].map((_, j) => matrix.map(row => row[j]));
  const identity = n => range_of(n).map(i => range_of(n).map(j => i === j ? 1n : 0n));
  const equal = (x, y) => x.every((row, i) => row.every((value, j) => value === y[i][j]));
  const scaled = (matrix, factor) => matrix.map(row => row.map(x => x * factor));
  const row_norm = matrix => largest_by(matrix, norm);
  const column_norm = matrix => row_norm(transpose(matrix));  // |.|_1
  function multiply(x, y) {  // the rows of y are packed, those with the larger numbers if one may choose
    const columns = y[0].length, left = bits(largest_of(x)), right = bits(largest_of(y));
    if (left > right) return transpose(multiply(transpose(y), transpose(x)));
    const width = left + right + bits(BigInt(y.length)) + 2;
    spend(x.length * y.length, left, width * columns);
    spend(x.length * y.length, 64, width * columns);  // for sums
    spend(4 * (x.length + y.length) * columns, width);
    allow_bits((x.length + y.length) * columns * width);
    const packed = y.map(row => pack(row, width));
    return x.map(row => unpack(combine(row, packed), width, columns));
  }
  function determinant(matrix, entry_bits) {  // by elimination without fractions [Bareiss 1968]
    const m = matrix.map(row => row.slice()), n = m.length;
    spend(n * n * n / 3, entry_bits * n / 2, entry_bits * n / 2);
    allow_bits(n * n * n * entry_bits);
    let last = 1n, flips = 1n;
    for (let k = 0; k + 1 < n; ++k) {
      const row = m.findIndex((candidate, i) => i >= k && candidate[k]);
      if (row < 0) return 0n;
      if (row !== k) [m[k], m[row], flips] = [m[row], m[k], -flips];
      for (let i = k + 1; i < n; ++i)
        for (let j = k + 1; j < n; ++j) m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / last;
      last = m[k][k];
    }
    return n ? flips * m[n - 1][n - 1] : 1n;
  }

  // ---- Section 2: tokens and lines ----------------------------------------------------------------------------------
  function integer(token) {
    demand(token.length <= (token[0] === '-' ? 5001 : 5000), 'number too long');
    demand(/^(0|-?[1-9][0-9]*)$/.test(token), 'not an integer');
    return BigInt(token);
  }
  function small(token, low, high) {
    const value = integer(token);
    demand(value >= BigInt(low) && value <= BigInt(high), `number outside ${low}..${high}`);
    return Number(value);
  }
  function rational(token) {
    const parts = token.split('/'), [n, d = 1n] = parts.slice(0, 2).map(integer);
    demand(parts.length <= 2, 'not a rational');
    demand(d > 0n, 'a denominator must be positive');
    return reduced(fraction(n, d));
  }
  const allow_denominator = den => demand(bits(den) <= 10000, 'common denominator too large');
  function common(fractions) {  // as integers over one denominator
    let den = 1n;
    for (const x of fractions) {
      if (den % x.d) den = lcm(den, x.d);
      allow_denominator(den);
    }
    allow_bits(fractions.length * bits(den) * 8);
    return {den, numbers: fractions.map(x => x.n * (den / x.d))};
  }
  function common_factor(den, numbers) {  // the largest one of all, if what it leaves of a denominator is not too large
    spend(numbers.length, bits(largest(numbers)), bits(den));
    const factor = numbers.reduce((g, x) => x % g ? gcd(g, x) : g, den);
    allow_denominator(den / factor);
    return factor;
  }
  class Reader {
    constructor(text) {
      [this.text, this.at, this.line, this.fields] = [text, 0, 0, null];
      demand(text.length <= 2 ** 28, 'file too long');
    }
    load() {  // the next line, unless one was looked at and not read
      if (this.fields) return this.fields;
      ++this.line;
      spend(20);
      if (this.at >= this.text.length) return this.fields = [''];
      const end = this.text.indexOf('\n', this.at);
      demand(end >= 0, 'last line without line feed');
      demand(end - this.at <= 2 ** 24, 'line too long');
      this.fields = this.text.slice(this.at, end).split(' ');
      this.at = end + 1;
      return this.fields;
    }
    peek() { return this.load()[0]; }
    read(words, fewest = 0, most = fewest) {  // the fields after these words, which must begin the line
      const fields = this.load(), expected = words.split(' '), count = fields.length - expected.length;
      demand(expected.every((word, i) => word === fields[i]), `expected '${words}'`);
      demand(count >= fewest && count <= most, 'wrong number of fields');
      this.fields = null;
      return fields.slice(expected.length);
    }
    rows(words, count, size, token) { return range_of(count).map(() => this.read(words, size).map(token)); }
    finish(words, why) {  // nothing follows
      if (words) this.read(words);
      if (this.at < this.text.length) ++this.line;
      demand(this.at >= this.text.length, why);
    }
  }

  // ---- Section 1: masks ---------------------------------------------------------------------------------------------
  const mask_form = 'a mask is [c0,c1,...]/D@first, of two variables [[c00,c10,...],...]/D@first,first';
  // The numbers of nested lists, the first variable innermost, but for the `inner` lists of a coefficient
  function mask_parts(text, inner = 0) {
    const end = text.lastIndexOf(']') + 1, lists = text.slice(0, end), at = (text + '@').indexOf('@', end);
    const by = text.slice(end, at), sizes = [], first = at < text.length ? text.slice(at + 1) : undefined;
    let depth = 0;
    while (text[depth] === '[') ++depth;
    demand(!by || by[0] === '/', mask_form);
    demand(depth > inner && depth <= 3 + inner && lists.endsWith(']'.repeat(depth)), mask_form);
    const split = (body, d) => {
      const pieces = body.split(']'.repeat(d - 1) + ',' + '['.repeat(d - 1));
      demand((sizes[d - 1] = sizes[d - 1] || pieces.length) === pieces.length, 'lists of different lengths in a mask');
      return d === 1 ? pieces : pieces.flatMap(piece => split(piece, d - 1));
    };
    return {depth, sizes, coefficients: split(lists.slice(depth, -depth), depth), den: by ? by.slice(1) : undefined,
            first: first === undefined ? null : first.split(',').map(integer)};
  }
  function polynomial(text, letter) {  // a sum of terms c*w^k, by powers of w
    const powers = Array(13).fill(fraction(0n));
    for (const [, signs, term] of text.replace(/^-?/, s => s || '+').matchAll(/([+-])([^+-]*)/g)) {
      const [, c, star, w, k] = /^([0-9/]*)(\*?)([a-zA-Z]?)(?:\^(.*))?$/.exec(term) || [];
      demand(w !== undefined && (w ? w === letter : !star) && (c !== '') === (star !== '' || !w) &&
             (w || k === undefined), 'not a term c*w^k');
      const at = k === undefined ? (w ? 1 : 0) : small(k, 1, 12);
      powers[at] = (signs === '-' ? minus : plus)(powers[at], c ? rational(c) : 1n);
    }
    return powers.map(reduced);
  }
  // A scheme of one variable, with or without a parameter (section 6): the mask a_i(w) / q(w), polynomials given by
  // their integer coefficients; without a parameter q is the denominator of the mask.
  function read_curve(text, arity, letter, inner = 0) {  // `inner`: 2 where the coefficients are matrices
    const parts = mask_parts(text, inner), outside = 'a mask has 1 to 1000 coefficients, the first and the last not zero';
    demand(parts.depth === 1 + inner && (!parts.first || parts.first.length === 1), outside);
    demand(!inner || parts.sizes[0] === parts.sizes[1], 'a coefficient of a mask is no square matrix');
    demand(parts.coefficients.length <= 1000, outside);
    const read = c => letter ? polynomial(c, letter) : [rational(c)], by = parts.den === undefined ? '1' : parts.den;
    const quotient = letter && /^\((.*)\)$/.exec(by), q = read(quotient ? quotient[1] : '1');
    const D = quotient ? 1n : integer(by), polynomials = parts.coefficients.map(read);
    demand(D > 0n, 'a denominator must be positive');
    const degree = Math.max(...[q, ...polynomials].map(p => p.findLastIndex(sign)), 0);
    const divisor = common(q.slice(0, degree + 1)), scale = fraction(divisor.den, D);
    const {den, numbers} = common(polynomials.flatMap(p => p.slice(0, degree + 1)).map(c => reduced(times(c, scale))));
    demand(letter || inner || (numbers[0] && numbers[numbers.length - 1]), outside);
    const all = [...divisor.numbers.map(x => x * den), ...numbers], g = all.reduce(gcd, 0n) || 1n;
    const row = i => all.slice(i * (degree + 1), (i + 1) * (degree + 1)).map(x => x / g);
    const matrices = inner ? {components: parts.sizes[0], first: parts.first ? parts.first[0] : 0n} : {};
    return {arity, degree, q: row(0), a: parts.coefficients.map((_, i) => row(i + 1)), ...matrices};
  }

  // ---- 4.1 and section 6: b = A^M a / sigma^M, times q, and the families --------------------------------------------
  function check_sum({arity, degree, q, a}) {
    const rule = k => sum(a.map(p => p[k])) === BigInt(arity) * q[k];
    demand(range_of(degree + 1).every(rule), 'the coefficients of the mask do not sum to the arity');
  }
  function divided_symbol({arity, degree, q, a}, order) {
    const by_power = range_of(degree + 1).map(k => {
      let c = a.map(p => p[k]);
      for (let m = 0; m < order; ++m) {  // times (1 - z) / (1 - z^A)
        demand(c.length >= arity, 'the mask has no sum rules of this order');
        spend(c.length);
        const d = [...c.map((x, i) => x - (i ? c[i - 1] : 0n)), -c[c.length - 1]];
        for (let i = arity; i < d.length; ++i) d[i] += d[i - arity];
        demand(d.slice(-arity).every(x => !x), 'the mask has no sum rules of this order');
        c = d.slice(0, -arity);
      }
      return c;
    });
    const b = scaled(transpose(by_power), BigInt(arity) ** BigInt(order));
    return {arity, degree, q, b, size: Math.max(1, Math.ceil((b.length - 1) / (arity - 1)))};
  }
  // 6.1: the f_j of (u + v)^degree p(w) = sum f_j u^j v^(degree - j), w = (low v + high u)/(u + v), times a positive
  // number that depends on the interval and the degree only; without an interval p is a number. From `low` on, without
  // an upper end: w = (low v + u)/v.
  function form_of(p, interval, degree) {
    if (!interval) return [p[0]];
    const {den, numbers: [low, end]} = common([interval.low, interval.high || interval.low]);
    const all = Array(degree + 1).fill(0n), [high, last] = interval.high ? [end, den] : [den, 0n];
    const by = (f, v, u) => [...f, 0n].map((x, j) => x * v + (j ? f[j - 1] * u : 0n));
    for (let k = 0, power_of_w = [1n]; k < p.length; ++k, power_of_w = by(power_of_w, low, high)) {
      const form = range_of(p[k] ? degree - k : 0).reduce(f => by(f, den, last), power_of_w);
      form.forEach((x, j) => { all[j] += x * p[k]; });
    }
    return all;
  }
  function weights_of(q, interval, degree) {  // and the sign that was turned
    const weights = form_of(q, interval, degree), turn = weights[0] < 0n ? -1n : 1n;
    demand(weights.every(x => x * turn > 0n), 'the denominator of the mask changes its sign, or may do so');
    return {turn, weights: weights.map(x => x * turn)};
  }
  // 6.7: the same of matrices of polynomials over `den` q, one for each digit
  function controls_of({den, degree, q, matrices}, interval) {
    const {turn, weights} = weights_of(q, interval, degree), all = weights.reduce(lcm, 1n), size = matrices[0].length;
    spend(matrices.length * size * size * (degree + 1) ** 3);
    const forms = matrices.map(m => m.map(row => row.map(p =>
      form_of(p, interval, degree).map((x, j) => x * turn * (all / weights[j])))));
    const factor = common_factor(all * den, forms.flat(3));
    const controls = forms.flatMap(m => weights.map((_, l) => m.map(row => row.map(form => form[l] / factor))));
    return {size, den: all * den / factor, weights, matrices: controls, symbol: null};
  }
  // The family of control matrices on an interval, in the order of 6.1; that of the T_t where there is no interval
  function control_family(symbol, interval) {
    const {arity, degree, q, b, size} = symbol;
    if (symbol.matrices) return controls_of(symbol, interval);
    demand(size <= 256, 'transition matrices larger than 256');
    const {turn, weights} = weights_of(q, interval, degree), all = weights.reduce(lcm, 1n);
    const numbers = b.map(p => form_of(p, interval, degree).map((x, j) => x * turn * (all / weights[j])));
    const factor = common_factor(all, numbers.flat()), den = all / factor;
    const entries = numbers.map(row => row.map(x => x / factor));
    allow_bits(arity * size * size * weights.length * (bits(largest_of(entries)) + 64));
    spend(arity * size * size * weights.length + b.length * (degree + 1) ** 3);
    const entry = (i, j) => i >= 0 && i < entries.length ? entries[i][j] : 0n;
    const matrices = range_of(arity).flatMap(t => weights.map((_, l) =>
      range_of(size).map(j => range_of(size).map(k => entry(arity * j + t - k, l)))));
    return {size, den, weights, matrices, symbol: interval ? null : symbol};
  }

  // ---- 5.5, 6.2: positive polynomials -------------------------------------------------------------------------------
  // Sums of form[j] u^j (1 - u)^(degree - j) for u in [0, 1], in one or more variables, the first innermost
  function half(line, right) {  // u = u'/2, or u = (1 + u')/2
    const d = right ? line.slice() : line.slice().reverse(), k = d.length - 1;
    for (let i = 0; i < k; ++i) for (let j = k - 1; j >= i; --j) d[j] += d[j + 1];
    const result = d.map((x, i) => x << BigInt(i));
    return right ? result : result.reverse();
  }
  function show_positive(form, what, degrees = [form.length - 1]) {
    const strides = degrees.map((_, v) => degrees.slice(0, v).reduce((n, d) => n * (d + 1), 1));
    const corners = degrees.reduce((at, d, v) => at.flatMap(i => [i, i + d * strides[v]]), [0]);
    const halved = (cell, v, right) => {
      const result = cell.slice(), n = degrees[v] + 1, place = (i, j) => i + j * strides[v];
      spend(cell.length * n, 512);
      for (let i = 0; i < cell.length; ++i)
        if (Math.floor(i / strides[v]) % n === 0)
          half(range_of(n).map(j => cell[place(i, j)]), right).forEach((x, j) => { result[place(i, j)] = x; });
      return result;
    };
    for (const cells = [[form, 0]]; cells.length;) {
      let [cell, depth] = cells.pop();
      const cut = Math.max(0, bits(largest(cell)) - 256);
      spend(cell.length, cut + 256);
      cell = cell.map(x => x >> BigInt(cut));
      if (cell.every(x => x > 0n)) continue;
      demand(corners.every(i => cell[i] > 0n), `${what} is not positive`);
      demand(depth < 60, `${what} is not shown to be positive`);
      for (const right of [true, false]) cells.push([halved(cell, depth % degrees.length, right), depth + 1]);
    }
  }
  const show_one_sign = (form, what) => show_positive(form[0] < 0n ? form.map(x => -x) : form, what);
  const squares_of = polynomials => {  // the sum of p(w)^2
    const total = Array(2 * polynomials[0].length - 1).fill(0n);
    spend(polynomials.length * polynomials[0].length ** 2, 1024);
    for (const p of polynomials) p.forEach((x, i) => p.forEach((y, j) => { total[i + j] += x * y; }));
    return total;
  };
  const evaluate = (form, u) => form.reduceRight((value, x) => value * u + x, 0n);
  // 6.2: the determinant of a matrix of forms, given by its values for v = 1 and u, as a form of this degree; `bound`
  // bounds the sum of the moduli of the coefficients
  function determinant_form(matrix_at, size, degree, bound) {
    const width = bits(bound) + 2, entry_bits = width * (degree / Math.max(size, 1) + 1);
    allow_bits(entry_bits * size * size);
    return unpack(determinant(matrix_at(1n << BigInt(width)), entry_bits), width, degree + 1);
  }

  // ---- Points of the unit circle (4.17): integers over W = 2^bits, angles as multiples of pi -------------------------
  class Circle {
    constructor(bits) {
      this.W = 1n << BigInt(bits);
      const guarded = this.W << 32n, arctangent = n => {  // of 1/n
        let total = 0n;
        for (let k = 1n, x = guarded / n, plus_sign = true; x; k += 2n, x /= n * n, plus_sign = !plus_sign)
          total += plus_sign ? x / k : -x / k;
        return total;
      };
      this.pi = (16n * arctangent(5n) - 4n * arctangent(239n)) >> 32n;
    }
    half_angle({n, d}) { return this.pi * n / (2n * d); }
    point(y) {  // e^(i pi y), within 2^18, not outside of the circle
      const turned = !less(y, 1n), {n, d} = turned ? minus(y, 1n) : y, x = this.pi * n / d, parts = [this.W, 0n];
      for (let k = 1, term = this.W; term; ++k) {
        term = term * x / (this.W * BigInt(k));
        parts[k % 2] += k % 4 < 2 ? term : -term;
      }
      const factor = turned ? 2n ** 16n - this.W : this.W - 2n ** 16n;
      return parts.map(part => part * factor / this.W);
    }
    powers(y, count) {  // e^(i pi k y), k < count, within 2^19 k: the real parts, and the imaginary ones
      const {W} = this, [u, v] = this.point(y), words = bits(W) + 128, re = [W], im = [0n];
      spend(4 * count, words, words);
      for (let k = 1; k < count; ++k) {
        const x = re[k - 1], y_k = im[k - 1];
        re.push((x * u - y_k * v) / W);
        im.push((x * v + y_k * u) / W);
      }
      return [re, im];
    }
  }

  // ---- 4.3, 6.3, section 7: stability -------------------------------------------------------------------------------
  const divides = (x, y) => y % x === 0;
  function with_primes(n) {
    const primes = [];
    let rest = n, phi = n;
    for (let p = 2; rest > 1; p = p * p > rest ? rest : p + 1) {
      if (!divides(p, rest)) continue;
      primes.push(p);
      phi = phi / p * (p - 1);
      while (divides(p, rest)) rest /= p;
    }
    return {n, primes, phi};
  }
  function cyclotomic_orders(arity, degree) {  // for each k >= 2 coprime to A with phi(kA) <= degree < 1000: the kd, d | A
    const divisors = range_of(arity + 1).filter(d => d > 1 && divides(d, arity));
    const orders = range_of(6 * (degree + 1)).filter(n => n >= 2 * arity && divides(arity, n)).map(with_primes);
    return orders.filter(({n, primes, phi}) =>
      phi <= degree && primes.every(p => !(divides(p, arity) && divides(p, n / arity)))
    ).map(({n}) => divisors.map(d => with_primes(n / arity * d)));
  }
  function cyclotomic_remainder(packed, {n, primes}, width) {  // a(z) prod_q (1 - z^(n/q)) modulo z^n - 1, packed
    const size = n * width;
    const fold = x => {
      for (let more; (more = drop(x, size));) x = BigInt.asIntN(size, x) + more;
      return x;
    };
    spend(4 * (primes.length + 1), Math.max(size, bits(packed)));
    return primes.reduce((x, q) => fold(x - (x << BigInt(size / q))), fold(packed));
  }
  const on_cycle = 'stability: the symbol on a cycle of roots of unity of order';
  function check_stability(curve, order, interval, rounding) {
    const {arity, degree, q, a} = curve, top = a.length - 1;
    if (interval) show_one_sign(form_of(q, interval, degree), 'the denominator of the mask');
    if (degree || rounding) {
      check_resultant(curve, interval, rounding);
      check_cycles(curve, top - order * (arity - 1), interval, rounding);
      return;
    }
    check_common_divisor(curve);
    const width = bits(largest_of(a)) + bits(BigInt(a.length)) + 10, packed = pack(a.map(p => p[0]), width);
    for (const orders of cyclotomic_orders(arity, top))
      demand(orders.some(n => cyclotomic_remainder(packed, n, width)), `${on_cycle} ${orders.at(-1).n / arity} is 0`);
  }
  function check_cycles({arity, degree, q, a}, zeros, interval, rounding) {  // 6.3 (ii), section 7
    const circle = new Circle(256), {W} = circle;
    const rows = transpose(rounding ? a : a.map(p => form_of(p, interval, degree))), top = a.length - 1;
    const errors = rows.map(row => norm(row) * BigInt(top) << 19n), size = bits(largest_of(rows));
    const off = rounding && times(rounding.eps, q[0] * BigInt(a.length) * W);
    const least = rounding && errors[0] + ceil_div(off.n, off.d);
    const values_at = y => {
      const waves = circle.powers(y, a.length);
      spend(2 * rows.length * a.length, size, 320);
      return rows.map(row => waves.map(wave => sum(row.map((c, i) => c * wave[i]))));
    };
    const dot = ([x, y], [u, v]) => x * u + y * v;
    const check = (half, n) => {
      const squares = Array(2 * degree + 1).fill(0n);
      for (const x of half)
        for (let r = 1; r < arity; ++r) {
          const turns = (x * arity + r * n) % (n * arity), values = values_at(fraction(BigInt(2 * turns), BigInt(n * arity)));
          if (rounding && dot(values[0], values[0]) > least * least) return;
          const above = values.map((value, k) => norm(value) + errors[k]);
          values.forEach((P, k) => values.forEach((Q, l) => {
            squares[k + l] += dot(P, Q) - above[k] * errors[l] - above[l] * errors[k];
          }));
          if (!rounding && squares.every(x => x > 0n)) return;
        }
      demand(!rounding, `${on_cycle} ${n} may be 0`);
      show_positive(squares, `${on_cycle} ${n}`);
    };
    // x, A x, A^2 x, ... modulo n, up to their signs, if x is the least of these and their negatives
    const half_cycle = (x, n) => {
      const found = [];
      for (let y = x; !found.length || (y !== x && y !== n - x); y = y * arity % n) {
        spend(1);
        if (y < x || n - y < x) return [];
        found.push(y);
      }
      return found;
    };
    for (let j = 1, power_of = arity; (j === 1 ? 1 : 2 * j) * (arity - 1) <= zeros; ++j, power_of *= arity) {
      demand(power_of <= 2 ** 20, too_much_work);
      for (const n of [power_of - 1, power_of + 1])
        for (let x = 1; 2 * x <= n; ++x) {
          const half = half_cycle(x, n);
          if (half.length === j && (2 * x === n ? 1 : 2 * j) * (arity - 1) <= zeros) check(half, n);
        }
    }
  }
  function check_common_divisor({arity, a}) {  // 4.3 (i)
    const k = bits(largest_of(a)) + 64, numbers = a.map(p => p[0]);
    allow_bits(k * numbers.length * 8);
    const parts = range_of(arity).map(r => numbers.filter((_, i) => i % arity === r)).filter(part => part.length);
    demand(parts.map(part => pack(part, k)).reduce(gcd, 0n) < 1n << BigInt(k - 1),
           'stability: the polyphase parts may have a common zero');
  }
  function check_resultant({arity, degree, q, a}, interval, rounding) {  // 6.3 (i), section 7
    const used = p => rounding || p.some(x => x), what = 'stability: the resultant of the polyphase parts';
    const [p, ...others] = range_of(arity).map(r => a.filter((_, i) => i % arity === r)).map(part =>
      part.slice(Math.max(0, part.findIndex(used)), part.findLastIndex(used) + 1)).sort((x, y) => x.length - y.length);
    demand(p.length, 'stability: a polyphase part is zero');
    const zero = Array(degree + 1).fill(0n), length = Math.max(...others.map(part => part.length));
    const mixed = range_of(length).map(i => others.reduce((total, part, j) =>  // sum of j^2 p_j
      i < part.length ? total.map((x, k) => x + BigInt((j + 1) ** 2) * part[i][k]) : total, zero));
    const size = p.length + length - 2;
    const sylvester = value => {
      const shifted = (part, by) => range_of(size).map(k => k >= by && k - by < part.length ? value(part[k - by]) : 0n);
      return [...range_of(length - 1).map(i => shifted(p, i)), ...range_of(p.length - 1).map(i => shifted(mixed, i))];
    };
    if (interval) {
      const forms = new Map([...p, ...mixed].map(f => [f, form_of(f, interval, degree)]));
      const bound = sylvester(f => norm(forms.get(f))).reduce((product, row) => product * sum(row), 1n);
      const at = u => sylvester(f => evaluate(forms.get(f), u));
      return show_one_sign(determinant_form(at, size, size * degree, bound), what);
    }
    const exact = sylvester(f => f[0]), cut = Math.max(0, bits(largest_of(exact)) - 256 - 16 * size);
    const matrix = exact.map(row => row.map(x => x >> BigInt(cut)));
    const changes = BigInt(size) * (1n + sum(others.map((_, j) => BigInt((j + 1) ** 2))));
    const change = plus(times(times(rounding.eps, fraction(q[0], 1n << BigInt(cut))), changes), cut ? size : 0);
    const value = abs(determinant(matrix, bits(largest_of(matrix)) + 8));
    demand(less(size ? delta(size, column_norm(matrix), change) : 0n, value), `${what} is not positive`);
  }
  function check_full({arity, degree, b}, interval) {  // 6.4: sigma divides b for no value of the parameter
    const sums = range_of(arity).map(r => b.filter((_, i) => i % arity === r)).map(part =>
      range_of(degree + 1).map(k => sum(part.map(p => p[k]))));
    const differences = sums.slice(1).map(s => s.map((x, k) => x - sums[0][k]));
    show_positive(form_of(squares_of(differences), interval, 2 * degree),
                  'sum-rules full: what one more sum rule would make 0,');
  }

  // ---- Section 7: rounded coefficients ------------------------------------------------------------------------------
  const delta = (k, x, y) => k ? round_up(times(times(k, y), power(plus(x, y), k - 1))) : fraction(0n);
  const norm_of_family = ({den, matrices}) => fraction(largest_by(matrices, column_norm), den);
  function rounding_of({arity, a}, {eps, order, symmetric}, family) {
    let series = Array(a.length).fill(1n);
    for (let m = 0; m < order; ++m) {  // times (1 + z) / (1 - z^A)
      spend(a.length, order);
      series = series.map((x, i) => x + (i ? series[i - 1] : 0n));
      for (let i = arity; i < a.length; ++i) series[i] += series[i - arity];
    }
    const eta = times(eps, BigInt(arity) ** BigInt(order) * largest(series));
    return {eps, e: times(eta, family.size), nu: norm_of_family(family), symmetric};
  }

  // ---- 4.4: blocks --------------------------------------------------------------------------------------------------
  function read_block_sizes(reader, size, part) {  // and how many blocks, the first ones, are of what is unobservable
    const sizes = reader.read('blocks', 1, size).map(token => small(token, 1, size));
    demand(sum_of(sizes) === size, 'the block sizes do not sum to n');
    const ends = sizes.map((_, i) => sum_of(sizes.slice(0, i))), hidden = part ? ends.indexOf(part.unobservable) : 0;
    demand(hidden >= 0, 'what is unobservable consists of no blocks');
    return {sizes, ends, hidden};
  }
  function read_blocks(reader, {size, den, weights, matrices}, part = null) {
    const {sizes, ends, hidden} = read_block_sizes(reader, size, part);
    const square = words => {
      const {den: by, numbers} = common(reader.rows(words, size, size, rational).flat());
      return {by, rows: range_of(size).map(i => numbers.slice(i * size, (i + 1) * size))};
    };
    const basis = square('basis');
    if (part) check_unobservable(part, basis.rows);
    const inverse = square('inverse'), by = basis.by * inverse.by;
    demand(equal(multiply(basis.rows, inverse.rows), scaled(identity(size), by)),
           'basis times inverse is not the unit matrix');
    const all = matrices.map(matrix => multiply(multiply(inverse.rows, matrix), basis.rows));
    return sizes.map((n, block) => {
      const first = ends[block], within = row => row.slice(first, first + n);
      demand(all.every(m => m.slice(first + n).every(row => within(row).every(x => !x))), 'not block upper triangular');
      const entries = all.map(m => m.slice(first, first + n).map(within));
      const factor = common_factor(den * by, entries.flat(2));
      const matrices = entries.map(m => m.map(row => row.map(x => x / factor)));
      return {size: n, den: den * by / factor, weights, matrices, hidden: block < hidden};
    });
  }

  // 5.9: the first columns of the basis are 0 under the readings of a component, and no larger invariant space is
  function check_unobservable({readings, unobservable}, basis) {
    const zero = unobservable ? multiply(readings, basis.map(row => row.slice(0, unobservable))) : [];
    demand(zero.flat().every(x => !x), 'the component shows what is said to be unobservable');
  }
  function check_observable({readings, unobservable, degree}, {size, matrices}) {
    const p = 2n ** 32n - 5n, rest = x => (x % p + p) % p, rows = [];  // each with its pivot, where it is 1
    const extend = row => {
      spend(size * (rows.length + 2), 64);
      const x = row.map(rest);
      for (const {at, row: y} of rows) {
        const factor = x[at];
        if (factor) y.forEach((value, k) => { x[k] = rest(x[k] - factor * value); });
      }
      const at = x.findIndex(value => value);
      if (at < 0) return;
      let by = 1n;
      for (let e = p - 2n, square = x[at]; e; e /= 2n, square = square * square % p) if (e % 2n) by = by * square % p;
      rows.push({at, row: x.map(value => value * by % p)});
    };
    readings.forEach(extend);
    for (let i = 0; i < rows.length; ++i)
      for (const matrix of matrices) extend(multiply([rows[i].row], matrix)[0]);
    demand(rows.length + degree * unobservable >= size, 'more than what is said to be unobservable may be so');
  }

  // ---- 4.5: lower bounds by a product -------------------------------------------------------------------------------
  function word_product(matrices, word) {  // of integer matrices, from left to right; by columns, packed
    const size = matrices[0].length, growth = bits(largest_by(matrices, row_norm) || 1n);
    const width = growth * word.length + 2;
    allow_bits(size * size * width);
    spend(word.length * size * size, growth, width * size);
    const factors = matrices.map(transpose);
    let columns = identity(size).map(column => pack(column, width));
    for (const t of word) columns = factors[t].map(column => combine(column, columns));
    return transpose(columns.map(column => unpack(column, width, size)));
  }
  function read_word(reader, blocks, letters) {
    const [number, re, im, ...word] = reader.read('product', 4, 4099);
    const block = blocks[small(number, blocks.filter(({hidden}) => hidden).length, blocks.length - 1)];
    return {block, c: [re, im].map(rational), word: word.map(t => small(t, 0, letters - 1))};
  }
  // A lower bound of the spectral radius of a product P, and its length. P = N unit, up to errors of norm `errors`
  // units, and c = y unit / h.
  function read_product(reader, blocks, of_mask) {
    const {block, c, word} = read_word(reader, blocks, blocks[0].matrices.length), n = block.size;
    const rounding = block.rounding || of_mask;
    let unit = fraction(1n, block.den ** BigInt(word.length)), N = word_product(block.matrices, word);
    let {den: h, numbers: y} = common(c), errors = fraction(0n);
    y = y.map(x => x * unit.d);
    const with_inverse = reader.peek() === 'inverse';
    if (with_inverse || rounding) {
      const cut = bits(largest_of(N)) - 256 - 40 * n;
      N = N.map(row => row.map(x => shift(x, -cut)));
      y = y.map(x => cut > 0 ? floor_div(x, shift(h, cut)) : floor_div(shift(x, -cut), h));
      unit = cut > 0 ? fraction(1n << BigInt(cut), unit.d) : fraction(1n, unit.d << BigInt(-cut));
      [h, errors] = [1n, fraction(cut > 0 ? n : 0)];
    }
    if (rounding) errors = plus(errors, over(delta(word.length, norm_of_family(block), rounding.e), unit));
    const radius = with_inverse ? by_inverse(reader, N, y, unit, errors) : by_polynomial(N, y, h, errors, rounding);
    demand(sign(radius) > 0, 'the product proves no positive spectral radius');
    return {radius: times(radius, over(unit, h)), length: word.length, letters: word};
  }
  function value_and_slope(p, y, h) {  // h^n p(c) and h^(n-1) p'(c) for c = (y_0 + i y_1) / h, by Horner's rule
    const step = ([re, im], add) => [re * y[0] - im * y[1] + add[0], re * y[1] + im * y[0] + add[1]], n = p.length - 1;
    let value = [0n, 0n], slope = [0n, 0n];
    for (let k = n, scale = 1n; k >= 0; --k, scale *= h) {
      if (k < n) slope = step(slope, value);
      value = step(value, [p[k] * scale, 0n]);
      spend(8, bits(scale) + bits(value[0]), bits(y[0]) + bits(p[k]));
    }
    return [value, slope];
  }
  // |c| - n (|p(c)| + Delta_n) / (|p'(c)| - n Delta_(n-1)) in units / h
  function by_polynomial(N, y, h, errors, rounding) {
    const n = N.length, [value, slope] = value_and_slope(characteristic_polynomial(N), y, h);
    const x = plus(column_norm(N) * h, modulus_above(...y)), change = times(errors, h);
    const below = minus(modulus_below(...slope), times(n, delta(n - 1, x, change)));
    demand(sign(below) > 0, rounding ? 'the product proves nothing of rounded masks'
                                     : 'the characteristic polynomial has derivative 0 at the given eigenvalue');
    return minus(modulus_below(...y), over(times(n, plus(modulus_above(...value), delta(n, x, change))), below));
  }
  function characteristic_polynomial(N) {  // p_0, ..., p_n = 1 of det(x - N), by Faddeev and LeVerrier
    const n = N.length, p = Array(n + 1).fill(1n);
    for (let k = 1, m = identity(n); k <= n; ++k) {
      const next = multiply(N, m);
      p[n - k] = -sum(next.map((row, i) => row[i])) / BigInt(k);
      m = next.map((row, i) => row.map((x, j) => i === j ? x + p[n - k] : x));
    }
    return p;
  }
  function by_inverse(reader, N, y, unit, errors) {  // Theorem 25; |c| - n / t in units
    const n = N.length, complex = y[1] !== 0n, scale = 1n << BigInt(small(reader.read('inverse', 1)[0], 0, 4096));
    const columns = range_of(n).map(k => reader.read(`column ${k}`, complex ? 2 * n : n).map(integer));
    const re = transpose(columns.map(x => x.slice(0, n)));
    const im = transpose(columns.map(x => complex ? x.slice(n) : x.map(() => 0n)));
    const [Nre, Nim] = [multiply(N, re), complex ? multiply(N, im) : im], one = scale * unit.d;
    const distance = (i, k) =>  // of (c - P) X from 1, times `one`
      abs((i === k ? one : 0n) - unit.n * (y[0] * re[i][k] - y[1] * im[i][k] - Nre[i][k])) +
      abs(unit.n * (y[0] * im[i][k] + y[1] * re[i][k] - Nim[i][k]));
    const column_sum = term => largest_by(range_of(n), k => sum(range_of(n).map(i => term(i, k))));
    const size = fraction(column_sum((i, k) => abs(re[i][k]) + abs(im[i][k])), scale);
    const e = plus(fraction(column_sum(distance), one), times(times(errors, unit), size));
    demand(less(e, 1n), 'the inverse is none of the product less the given eigenvalue');
    const trace = [re, im].map(part => sum(part.map((row, i) => row[i])));
    const t = minus(over(modulus_below(...trace), scale), times(times(n, size), over(e, minus(1n, e))));
    demand(sign(t) > 0, 'the inverse proves no eigenvalue near the given one');
    return minus(modulus_below(...y), over(n, times(t, unit)));
  }
  // 6.2: a lower bound for all w of an interval; `blocks` are those of the control matrices, T_t = N_t / (den q)
  function read_range_product(reader, blocks, arity) {
    const {block: {size, den, weights, matrices}, c: [re, im], word} = read_word(reader, blocks, arity);
    demand(!sign(re) !== !sign(im), 'over a range either the real or the imaginary part of the eigenvalue is 0');
    const pair = sign(im) !== 0, n = weights.length - 1, e = word.length * (pair ? 2 : 1);
    demand(!pair || size >= 2, 'a pair of eigenvalues needs matrices of size 2');
    const pairs = range_of(size).flatMap(i => range_of(i).map(j => [j, i]));
    const compound = (m, op) => pairs.map(([i, j]) => pairs.map(([k, l]) => op(m[i][k] * m[j][l], m[i][l] * m[j][k])));
    const order = pair ? pairs.length : size, degree = n * e * order;
    demand(order <= 256, too_much_work);
    const forms = range_of(arity).map(t => range_of(size).map(i => range_of(size).map(k =>
      weights.map((weight, j) => weight * matrices[t * (n + 1) + j][i][k]))));
    const product = value => word_product(forms.map(matrix => matrix.map(row => row.map(value))), word);
    const flip = sign(re) < 0 ? -1n : 1n, c = fraction(abs((pair ? im : re).n), (pair ? im : re).d);
    const g = pair ? times(c, c) : c;
    const moduli = pair ? compound(product(norm), (x, y) => x + y) : product(norm);
    const diagonal = g.n * (den * sum(weights)) ** BigInt(e);
    const bound = moduli.reduce((all, row) => all * (diagonal + g.d * sum(row)), 1n);
    const matrix_at = u => {  // g - Q
      const P = product(form => evaluate(form, u)), at = g.n * (den * evaluate(weights, u)) ** BigInt(e);
      return (pair ? compound(P, (x, y) => x - y) : P).map((row, i) =>
        row.map((x, k) => (i === k ? at : 0n) - flip * g.d * x));
    };
    show_positive(determinant_form(matrix_at, order, degree, bound).map(x => -x),
                  'the characteristic polynomial of the product, with the other sign,');
    return {radius: c, length: word.length};
  }

  // ---- 4.6: norms ---------------------------------------------------------------------------------------------------
  function check_norm({size, den, matrices}, level, first_column, rounding) {
    const columns = identity(size).slice(0, first_column ? 1 : size), entry = bits(largest_by(matrices, largest_of));
    spend(matrices.length ** level * columns.length * size * size, (entry + bits(BigInt(size))) * level, entry);
    const sparse = matrices.map(matrix => matrix.map(row => row.flatMap((x, k) => x ? [[x, k]] : [])));
    const longest = (vector, letters) => !letters ? norm(vector) : largest_by(sparse, matrix =>
      longest(matrix.map(row => row.reduce((total, [x, k]) => total + x * vector[k], 0n)), letters - 1));
    const value = fraction(largest_by(columns, column => longest(column, level)), den ** BigInt(level));
    return {value: rounding ? plus(value, delta(level, rounding.nu, rounding.e)) : value, level};
  }

  // ---- 4.7, 4.8: groups of maps g with T_t g = g T_s, s = numbers[t] ------------------------------------------------
  // `elements` are the products of the generators up to their signs; table[i][k] is [number, sign] of element i times
  // generator k.
  const trivial_group = letters => ({elements: [{numbers: range_of(letters)}], table: [[]]});
  function read_group(reader, count, size, matrices) {
    const generators = range_of(count).map(() => {
      const numbers = reader.read('generator', matrices.length).map(token => small(token, 0, matrices.length - 1));
      const map = reader.rows('map', size, size, integer);
      demand(numbers.every((s, t) => equal(multiply(matrices[t], map), multiply(map, matrices[s]))),
             'a generator does not permute the matrices as it says');
      demand(determinant(map, bits(largest_of(map)) + 8), 'a generator is singular');
      return {numbers, map};
    });
    const elements = [], table = [], known = new Map();
    const enter = (map, numbers) => {
      const text = String(map);
      if (!known.has(text)) {
        known.set(text, [elements.length, 1n]).set(String(scaled(map, -1n)), [elements.length, -1n]);
        elements.push({map, numbers});
        demand(elements.length <= 96, 'the generators span a group of more than 96 elements');
      }
      return known.get(text);
    };
    enter(identity(size), range_of(matrices.length));
    for (const {map, numbers} of elements)
      table.push(generators.map(g => enter(multiply(map, g.map), numbers.map(t => g.numbers[t]))));
    return {elements, table};
  }
  function split_index(token) {  // an index and the letters after it
    const [index] = /^[0-9]*/.exec(token);
    return [index, token.slice(index.length)];
  }
  function spell({table, first = 'A'}, letters) {  // a word: the number of the element of the group, and its sign
    demand(letters.length <= 16, 'a word of more than 16 generators');
    let element = 0, turn = 1n;
    for (const letter of letters) {
      const entry = table[element][letter.charCodeAt(0) - first.charCodeAt(0)];
      demand(entry, 'unknown generator');
      [element, turn] = [entry[0], turn * entry[1]];
    }
    return [element, turn];
  }

  // ---- 4.7: polytopes -----------------------------------------------------------------------------------------------
  function read_properties(names) {
    const plain = names.map(name => name.replace(/^group:.*/, 'group')), has = name => plain.includes(name);
    const known = ['complex', 'nonnegative', 'symmetric', 'transposed', 'group'];
    const real = !(has('complex') && has('nonnegative')), alone = !has('symmetric') && !has('nonnegative');
    demand(plain.every(name => known.includes(name)) && real, 'unknown polytope property');
    demand(new Set(plain).size === plain.length, 'a polytope property twice');
    demand(!has('group') || alone, "a group goes with neither 'symmetric' nor 'nonnegative'");
    const group = has('group') ? small(names[plain.indexOf('group')].slice(6), 1, 8) : 0;
    return {...Object.fromEntries(plain.map(name => [name, true])), group};
  }
  function read_sizes(fields) {  // COUNT, VBITS and CBITS
    demand(fields.length >= 3, 'wrong number of fields');
    const [v_bits, c_bits] = fields.slice(1, 3).map(x => small(x, 0, 4096));
    return {count: small(fields[0], 1, 2 ** 28), v_bits, c_bits};
  }
  function read_polytope(reader, family, fields, rounding, exact) {
    const {count, v_bits, c_bits} = read_sizes(fields), scale = BigInt(v_bits + c_bits);
    const has = read_properties(fields.slice(3)), {size, den} = family;
    const matrices = has.transposed ? family.matrices.map(transpose) : family.matrices, last = matrices.length - 1;
    demand(!has.group || !rounding, 'a group proves nothing of rounded masks');
    demand(!has.nonnegative || matrices.flat(2).every(x => x >= 0n), 'a matrix is not non-negative');
    const turned = m => m.map(row => row.slice().reverse()).reverse();
    const mirrored = all => all.every((m, t) => equal(turned(m), all[last - t])), field = rounding && rounding.field;
    const parts_of_all = i => field.halves.map(m => quarters(m, size)[i]);
    const symmetric = () => field ? mirrored(parts_of_all(0)) && mirrored(parts_of_all(1)) : mirrored(matrices);
    demand(!has.symmetric || symmetric(), 'the family is not symmetric');
    const flips = {elements: [{}, {map: identity(size).reverse()}], table: [[[1, 1n]], []], first: 'f'};
    const group = has.symmetric ? flips : has.group ? read_group(reader, has.group, size, matrices) : trivial_group(0);
    const body = new Body(reader, {size, count, c_bits, has, group});
    // Theorem 6: R and S times 2^(VBITS + CBITS) and 2^CBITS; E is the least integer above S/(1 - R)
    let R = 0n, S = 0n, g = fraction(0n);
    for (let k = 0; k < (has.symmetric ? Math.ceil(size / 2) : size); ++k) {
      const unit = range_of(size).map(i => i === k ? 1n << scale : 0n);
      const {residual, weight} = body.read_combination(`unit ${k}`, [unit, unit.map(() => 0n)], 1n);
      [R, S] = [max(R, residual), max(S, weight)];
    }
    demand(R < 1n << scale, "the vertices do not span: a unit's residual is 1 or more");
    const E = (S << BigInt(v_bits)) / ((1n << scale) - R) + 1n;
    const values = [];
    for (let j = 0, memory = 0; j < count; ++j) {
      const size_of = () => fraction(sum(body.coordinates(j).map(norm)), 1n << BigInt(v_bits));  // |v_J|_1
      const more = rounding ? times(rounding.e, times(size_of(), E)) : 0n;
      body.images(matrices, j).forEach((image, t) => {
        const target = image.map(x => x.map(value => value << BigInt(c_bits)));
        const {residual, weight} = body.read_combination(`image ${j} ${t}`, target, den);
        const value = plus(fraction((weight << BigInt(v_bits)) * den + residual * E, den << scale), more);
        if (less(g, value)) g = value;  // w + |r|_1 E
        if (!exact) return;
        allow_bits(memory += bits(value.n) + 256);
        values.push(rounding ? ceil_div(value.n * (den << scale), value.d) : value.n);
      });
    }
    const attained = Boolean(exact) && reader.peek() === 'cycle';
    if (attained)
      new TrueVertices(reader, body, exact, {matrices, den, v_bits, E, g, rounding}).check(values, den << scale);
    return {value: g, level: 1, attained};
  }
  // The vertices and their images under the group, packed; a complex vector is its real and its imaginary part.
  class Body {
    constructor(reader, options) {
      Object.assign(this, options, {reader, width: 0, most: 0n, vertices: []});
      const {size, count, has: {complex, nonnegative, nonzero}, group} = this;
      this.parts = complex ? 2 : 1;
      for (let j = 0; j < count; ++j) {
        const x = reader.read('vertex', this.parts * size).map(integer), top = largest(x);
        demand(!nonnegative || x.every(value => value >= 0n), 'negative coordinate');
        demand(!nonzero || top, 'a vertex is 0');
        if (top > this.most) this.set_width(bits(top) + 64);
        this.most = max(this.most, top);
        spend(x.length, this.width);
        allow_bits(j * x.length * Math.max(this.width, 1024));
        this.vertices.push(range_of(this.parts).map(part => pack(x.slice(part * size, (part + 1) * size), this.width)));
      }
      this.most *= largest_by(group.elements, ({map}) => map ? row_norm(map) : 1n);  // of images as well
      this.set_width(bits(this.most) + this.c_bits + 24);
    }
    set_width(width) {  // at least
      if (width > this.width) {
        allow_bits((this.vertices.length + 1) * this.size * width * this.parts);
        spend(4 * this.vertices.length * this.size, width);
        this.vertices = this.vertices.map(vertex => vertex.map(x => pack(unpack(x, this.width, this.size), width)));
        this.width = width;
      }
      this.images_under = new Map();
      this.may_keep = max_bits / 4 / (this.size * this.width * this.parts);
      this.max_weight = (1n << BigInt(this.width - 2)) / (this.most + 1n);  // sums with smaller weights fit
    }
    coordinates(j) {
      spend(3 * this.size, this.width);
      return this.vertices[j].map(x => unpack(x, this.width, this.size));
    }
    images(matrices, j) {  // the image of vertex j under each matrix; those of 64 vertices are computed together
      const at = j % 64 * this.parts;
      if (!at) {
        const block = range_of(Math.min(64, this.count - j)).flatMap(i => this.coordinates(j + i));
        this.block = matrices.map(matrix => transpose(multiply(matrix, transpose(block))));
      }
      return this.block.map(rows => rows.slice(at, at + this.parts));
    }
    under(element, j) {  // the image of vertex j under an element of the group
      const key = element * this.count + j, known = element ? this.images_under.get(key) : this.vertices[j];
      if (known) return known;
      const {map} = this.group.elements[element];
      spend(this.size ** 2 / 4, this.width);
      const image = this.coordinates(j).map(x => pack(map.map(row => combine(row, x)), this.width));
      if (this.images_under.size < this.may_keep) this.images_under.set(key, image);
      return image;
    }
    turned(element, columns) {
      const {map} = this.group.elements[element];
      return map ? multiply(map, columns) : columns;
    }
    read_term(term) {  // the number of the vertex, that of the element of the group, -1 for a conjugate, the weight
      const [head, ...weight] = term.split(':'), {has: {complex, nonnegative}} = this;
      demand(weight.length === this.parts, 'a term is INDEX:WEIGHT');
      const [, index, letters, conjugate] = /^([0-9]*)([^0-9c]*)(c?)$/.exec(head) || [];
      demand(index, 'not an integer');
      demand(complex || !conjugate, 'unknown generator');
      const [element, turn] = spell(this.group, letters), lambda = weight.map(integer);
      demand(!nonnegative || lambda[0] >= 0n, 'negative weight');
      return [small(index, 0, this.count - 1), element, conjugate ? -1n : 1n, turn < 0n ? lambda.map(x => -x) : lambda];
    }
    // A line: the residual |target - factor * sum of weighted vertices|_1 and the sum of the moduli of the weights
    read_combination(words, target, factor) {
      const {size, has: {complex, nonnegative}} = this;
      let weight = 0n, re = 0n, im = 0n;
      for (const term of this.reader.read(words, 0, 2 ** 24)) {
        const [j, element, conjugate, [x, y]] = this.read_term(term), square = complex && x * x + y * y;
        const modulus = complex ? root(square) : abs(x);
        weight += complex && modulus * modulus < square ? modulus + 1n : modulus;
        if (weight > this.max_weight) {
          const sums = [re, im].map(part => unpack(part, this.width, size));
          this.set_width(Math.max(bits(weight) + bits(this.most) + 8, 2 * this.width));
          [re, im] = sums.map(part => pack(part, this.width));
        }
        const [real, imaginary] = this.under(element, j);
        spend(complex ? 4 : 1, bits(x), this.width * size);
        re += x * real;
        if (!complex) continue;
        re -= conjugate * y * imaginary;
        im += conjugate * x * imaginary + y * real;
      }
      spend(4 * size, this.width);
      const rest = (packed, x) => unpack(packed, this.width, size).map((value, i) => x[i] - factor * value);
      const real = rest(re, target[0]), residual = nonnegative ? sum(real.filter(x => x > 0n)) : norm(real);
      return {residual: complex ? residual + norm(rest(im, target[1])) : residual, weight};
    }
  }

  // ---- 4.10: what the radius is -------------------------------------------------------------------------------------
  function read_exact(text, with_order) {  // the zero of p within eps of the point, and perhaps M
    const form = 'an exact exponent is M-log|[p0,p1,...]@RE,IM,EPS|^1/L, an exact radius the same without M-log';
    const [, M, list, disc, L] = /^(?:([^|]*)-log)?\|\[([^\]]*)\]@([^|]*)\|\^1\/(.*)$/.exec(text) || [];
    demand(list !== undefined && (M !== undefined) === with_order, form);
    const p = list.split(',').map(integer), [re, im, eps, ...more] = disc.split(',').map(rational);
    demand(p.length >= 2 && p.length <= 257 && p[p.length - 1], 'a polynomial has the degree 1 to 256');
    demand(eps && !more.length && sign(eps) > 0, form);
    return {order: with_order ? small(M, 0, 500) : null, p, re, im, eps, L: small(L, 1, 1000)};
  }
  const moduli_between = (re, im, eps, least, most) => {  // of all numbers within eps of re + i im
    const square = x => times(x, x), [low, high] = [plus(least, eps), minus(most, eps)];
    const modulus = plus(square(re), square(im));
    return sign(high) >= 0 && !less(modulus, square(low)) && !less(square(high), modulus);
  };
  const wrong_bounds = 'the bounds of the exact radius are wrong';
  const read_letters = text => {
    const letters = text.split(',').map(token => small(token, 0, 15));
    demand(letters.length <= 1000, 'a product of more than 1000 letters');
    return letters;
  };
  function read_attains(reader, {options, within}) {  // section 7.1: the line `attains`, if it is there or needed
    if (options.attains === undefined && reader.peek() !== 'attains') return null;
    const [text, ...bounds] = reader.read('attains', 3), [low, high] = bounds.map(rational);
    demand(options.attains === undefined || text === options.attains, 'the claim is about another product');
    demand(sign(low) > 0 && sign(high) > 0, 'the bounds of the radius are not positive');
    return {order: within.order, product: String(read_letters(text)), low, high};
  }
  // The lines `exact` and `root`, if they are there or the claim needs them: the exact number, with c = y / h near z
  function read_root(reader, {options, of_family}) {
    if (options.exact === undefined && reader.peek() !== 'exact') return null;
    const text = options.exact === undefined ? reader.read('exact', 1)[0] : options.exact;
    if (options.exact !== undefined) reader.read(`exact ${text}`);
    const exact = read_exact(text, !of_family), {p, L} = exact, n = p.length - 1;
    const [re, im, eps, low, high] = reader.read('root', 5).map(rational);
    demand(sign(eps) >= 0 && sign(low) > 0 && sign(high) > 0,
           'the error of a root is negative, or its modulus not positive');
    const square = x => times(x, x), squares = ([x, y]) => plus(square(x), square(y));
    const integral = (x, y) => ({h: x.d * y.d, y: [x.n * y.d, y.n * x.d]});
    const gap = minus(exact.eps, eps), apart = squares([minus(re, exact.re), minus(im, exact.im)]);
    demand(sign(gap) >= 0 && !less(square(gap), apart), 'the zero is not the one of the claim');
    const {h, y} = integral(re, im), [value, slope] = value_and_slope(p, y, h).map(squares);
    demand(slope.n && !less(times(square(times(eps, h)), slope), times(n * n, value)), 'no zero is proved so near');
    const centre = integral(exact.re, exact.im), slope_0 = squares(value_and_slope(p, centre.y, centre.h)[1]);
    const m = plus(plus(abs_of(exact.re), abs_of(exact.im)), exact.eps);
    const bend = horner(p.map((x, k) => abs(x) * BigInt(k * (k - 1))).slice(2), m);
    demand(less(square(times(times(exact.eps, bend), centre.h ** BigInt(n - 1))), slope_0),
           'there may be more than one zero');
    demand(moduli_between(re, im, eps, power(low, L), power(high, L)), wrong_bounds);
    return {...exact, real: !sign(im) && !sign(exact.im), h, y, m: plus(plus(abs_of(re), abs_of(im)), eps),
            eps, low, high};
  }
  // The line `seed`: columns[k] is D^(n - 1 - k) y_k, D = den^L. prepare() is called when the line was read and gives
  // next: x -> D N x.
  function read_seed(reader, {p}, size, D, prepare, memory) {
    const seed = reader.read('seed', size).map(integer), n = p.length - 1, columns = [];
    const next = prepare();
    let y = seed.map(x => [x * p[n]]);
    for (let k = n - 1, scale = D; k >= 0; --k, scale *= D) {
      columns[k] = y.map(row => row[0]);
      allow_bits(memory += size * (bits(largest(columns[k])) + 128));
      spend(4 * size, bits(scale), bits(p[k]) + 64);
      y = next(y).map(([x], i) => [x + p[k] * scale * seed[i]]);
    }
    demand(y.every(([x]) => !x), 'the polynomial of the cycle does not vanish on the seed');
    return {next, columns, memory};
  }
  // U at c in place of z, pairs of real and imaginary parts, and the bound of its error, both times (h D)^(n - 1)
  function eigenvector_of({h, y: [re, im], eps, m}, columns, D) {
    const U = columns[0].map(() => [0n, 0n]), n = columns.length;
    for (let k = n - 1, scale = 1n; k >= 0; --k, scale *= h) {
      spend((im ? 6 : 3) * U.length, bits(largest_by(U, largest)) + bits(scale), bits(re) + bits(im) + bits(D));
      U.forEach(([a, b], i) => { U[i] = [(a * re - b * im) * D + columns[k][i] * scale, (a * im + b * re) * D]; });
    }
    const sums = horner(columns.map((x, k) => norm(x) * BigInt(k)).slice(1), times(m, D));
    return {U, error: times(times(times(2n, eps), sums), h ** BigInt(n - 1) * D)};
  }
  function joined({U, error}, of_root) {  // 5.13: p + sqrt(R) q, times 2^512
    const near = scaled_root(of_root), n = U.length / 2, q = U.slice(n), whole = fraction(of_root << 512n);
    return {U: q.map((y, i) => U[i].map((x, part) => (x << 512n) + y[part] * near)), error: plus(times(whole, error), sum(q.map(norm)))};
  }
  // The lines `origin` of a body, or of a body for a subradius; children[key(K, T)] is the last J with `origin J K T`.
  class Origins {
    constructor(reader, body, matrices) {
      Object.assign(this, {reader, body, matrices, origins: new Map(), children: new Map()});
    }
    key(j, t) { return j * this.matrices.length + t; }
    vertex(token) { return small(token, 0, this.body.count - 1); }
    letter(token) { return small(token, 0, this.matrices.length - 1); }
    link(J, [vertex, letter]) {  // of the line of J
      const K = small(vertex, 0, J - 1), T = this.letter(letter);
      this.origins.set(J, {K, T});
      this.children.set(this.key(K, T), J);
      return {K, T};
    }
    follow(word, columns) { return word.reduce((x, t) => multiply(this.matrices[t], x), columns); }
    way(j) {  // the first vertex that j stems from, and the letters
      const letters = [];
      for (let at; (at = this.origins.get(j)); j = at.K) letters.push(at.T);
      spend(letters.length);
      return {source: j, letters: letters.reverse()};
    }
    last_of(word, J) {  // the vertex to which the word without its last letter leads from J
      const last = word.slice(0, -1).reduce((j, t) => this.children.get(this.key(j, t)), J);
      demand(last !== undefined, 'a vertex of a cycle is missing');
      return last;
    }
    settle(j, t) {  // an image that is no child, but as good as one
      this.settled.add(this.key(j, t));
      allow_bits(this.settled.size * 1024);
    }
  }
  // The vertices V_J near those of a body. `known` are E, g, the matrices, their denominator, VBITS; e_J is errors[J] /
  // 2^512, of cycles and origins.
  class TrueVertices extends Origins {
    constructor(reader, body, exact, known) {
      super(reader, body, known.matrices);
      Object.assign(this, known, {exact, cycles: new Map(), errors: new Map(), memory: 0});
      this.field = this.rounding && this.rounding.field;
      if (this.field) this.use_field();
      if (this.rounding && !this.field) this.read_near_cycles();
      else while (reader.peek() === 'cycle') this.read_cycle();
      while (this.last_origin !== body.count - 1 && reader.peek() === 'origin') this.read_origin();
      this.e = fraction([...this.errors.values()].reduce(max, 0n), 1n << 512n);
      demand(less(this.e, 1n), 'a vertex is too far from the true one');
      this.settled = new Set(this.children.keys());
      for (const [J, {word}] of this.cycles) this.settle(this.last_of(word, J), word[word.length - 1]);
      while (reader.peek() === 'same') this.read_same();
    }
    use_field() {  // 5.13: seeds and equations are over the field, on halves
      const {body: {has, size}, field: {root: of_root, halves}} = this;
      demand(!has.complex && !has.nonnegative, 'over a field complex polytopes and cones name no radius');
      this.halves = has.transposed ? halves.map(m => on_halves(...quarters(m, size).map(transpose), of_root)) : halves;
    }
    lead(word, columns) { return this.field ? word.reduce((x, t) => multiply(this.halves[t], x), columns) : this.follow(word, columns); }
    turned(element, columns) {
      const {body} = this, parts = this.field ? [columns.slice(0, body.size), columns.slice(body.size)] : [columns];
      return parts.flatMap(x => body.turned(element, x));
    }
    enter(J, error) {
      spend(8, bits(error.n) + 512, bits(error.d));
      const far = !less(error, 1n);  // as good as any number that is too large
      this.errors.set(J, far ? 1n << 512n : ceil_div(error.n << 512n, error.d));
      allow_bits(this.errors.size * 2048);
    }
    read_cycle() {  // column k of Y is den^(L (n - 1 - k)) y_k
      const {body, exact: {L}, v_bits} = this;
      const [first, letters, ...rest] = this.reader.read('cycle', 2 + L), J = this.vertex(first);
      const word = rest.map(t => this.letter(t));
      demand(!this.cycles.has(J), 'a vertex is the first one of two cycles');
      demand(letters, "a cycle has a word, or '-'");
      demand(letters.length <= 16, 'a word of more than 16 generators');
      const prepare = () => {
        const [element, turn] = spell(body.group, letters === '-' ? '' : letters);
        demand(this.exact.real || body.parts === 2, 'a real polytope, but no real eigenvalue');
        return x => scaled(this.turned(element, this.lead(word, x)), turn);
      };
      const {field} = this, D = (field ? field.den : this.den) ** BigInt(L);
      const seed = read_seed(this.reader, this.exact, field ? 2 * body.size : body.size, D, prepare, this.memory);
      const {next, columns, memory} = seed, parts = eigenvector_of(this.exact, columns, D);
      const {U, error: u} = field ? joined(parts, field.root) : parts;
      this.memory = memory;
      this.cycles.set(J, {word, next, Y: transpose(columns)});
      const [v, v_im = v.map(() => 0n)] = body.coordinates(J), size = v.map((x, i) => abs(x) + abs(v_im[i]));
      const i = size.indexOf(largest(size)), [a, b] = U[i], [c, d] = [v[i], v_im[i]];
      const distance = sum(U.map(([x, z], k) => abs(c * x - d * z - a * v[k] + b * v_im[k]) +
                                                abs(c * z + d * x - a * v_im[k] - b * v[k])));
      const below = minus(max(abs(a), abs(b)), u);
      demand(sign(below) > 0, 'the eigenvector of a cycle may be zero where the vertex is large');
      const bound = over(plus(distance, times(u, size[i] + sum(size))), below);  // times 2^VBITS
      demand(!body.has.nonnegative || v.every((x, k) => less(bound, x) || columns.every(column => !column[k])),
             'an eigenvector of a cycle may be negative');
      this.enter(J, times(bound, fraction(this.E, 1n << BigInt(v_bits))));
    }
    read_near_cycles() {  // section 7.1: one, or two whose products have the same eigenvalue for all masks
      const {reader, body: {has}, exact: {product}, den, matrices, rounding: {e, symmetric}} = this;
      demand(!has.complex && !has.nonnegative && (!has.symmetric || symmetric),
             'of all masks near by a complex polytope, a cone, and a symmetric polytope where they are not prove nothing');
      const {letters, c, distance} = this.read_near_cycle();
      demand(String(has.transposed ? letters : letters.slice().reverse()) === product,
             'the product of the cycle is not the one of the claim');
      if (reader.peek() !== 'cycle') return;
      const second = this.read_near_cycle(), last = matrices.length - 1, ends = [letters, second.letters].sort();
      demand(!has.symmetric && !less(c, second.c) && !less(second.c, c) && String(ends) === `0,${last}`,
             'nothing says that two products have the same radius for all masks near by');
      const error = plus(less(distance, second.distance) ? second.distance : distance, e);
      for (const corner of [matrices[0][0][0], matrices[last].at(-1).at(-1)])
        demand(less(error, abs_of(minus(fraction(corner, den), c))), 'a corner of a matrix may be the eigenvalue');
    }
    read_near_cycle() {
      const {reader, body, exact: {low, high}, den, v_bits, matrices, rounding: {e}} = this;
      const {size: n, has} = body, last = matrices.length - 1;
      const [first, turn, ...rest] = reader.read('cycle', 4, 1003), J = this.vertex(first);
      demand(turn === '-' || (turn === 'f' && has.symmetric), "the word of a cycle is '-' or 'f'");
      demand(!this.cycles.has(J), 'a vertex is the first one of two cycles');
      const c = rational(rest[0]), word = rest.slice(1).map(t => this.letter(t));
      const letters = turn === 'f' ? [...word, ...word.map(t => last - t)] : word;
      const N = this.follow(word, identity(n)), D = den ** BigInt(word.length);
      if (turn === 'f') N.reverse();
      const [v] = body.coordinates(J), size = v.map(abs), kept = size.indexOf(largest(size)), shift_by = BigInt(v_bits);
      const whole = D * c.d, one = whole << shift_by;
      const less_c = N.map((row, i) => row.map((x, k) => x * c.d - (i === k ? c.n * D : 0n)));
      const B = less_c.map((row, i) => [...row.map(x => x << shift_by), -v[i] * whole]);
      B.push(range_of(n + 1).map(k => k === kept ? one : 0n));
      const unit = 1n << BigInt(small(reader.read('inverse', 1)[0], 0, 4096));
      const X = transpose(range_of(n + 1).map(k => reader.read(`column ${k}`, n + 1).map(integer)));
      const F = [...multiply(less_c, v.map(x => [x])), [0n]];
      const unity = difference(multiply(X, B), scaled(identity(n + 1), one * unit));
      const X_size = fraction(column_norm(X), unit);
      const moved = times(X_size, delta(word.length, norm_of_family({den, matrices}), e));
      const contraction = round_up(plus(fraction(column_norm(unity), one * unit), moved));
      const off = plus(fraction(column_norm(multiply(X, F)), whole * unit), times(moved, sum(size)));
      const step = round_up(times(off, fraction(1n, 1n << shift_by))), left = minus(1n, contraction);
      demand(sign(left) > 0 && less(times(6n, times(X_size, step)), times(left, left)),
             'no eigenvector is proved near the first vertex of the cycle');
      const distance = over(times(2n, step), left), zero = fraction(0n);
      demand(moduli_between(c, zero, distance, power(low, word.length), power(high, word.length)), wrong_bounds);
      this.cycles.set(J, {word});
      this.enter(J, times(distance, this.E));
      return {letters, c, distance};
    }
    read_origin() {
      const {body, exact: {low, high}, den, v_bits, E, g, rounding} = this;
      const [first, ...rest] = this.reader.read('origin', 3);
      const J = this.vertex(first);
      demand(!this.cycles.has(J), 'the first vertex of a cycle is no image');
      demand(!(J <= this.last_origin), 'the vertices of origins are not in order');
      const {K, T} = this.link(J, rest);
      this.last_origin = J;
      const v = transpose(body.coordinates(J)), image = multiply(this.matrices[T], transpose(body.coordinates(K)));
      const away = s => sum(v.map((row, i) => sum(row.map((x, part) => abs(low.d * image[i][part] - s * x)))));
      const [plain, turned] = [low.n * den, -low.n * den].map(away);
      const near = fraction(turned < plain ? turned : plain, low.d * den);
      const off = rounding ? times(rounding.e, sum(body.coordinates(K).map(norm))) : 0n;
      const drift = plus(times(minus(high, low), sum(v.map(norm))), off);
      const own = times(plus(near, drift), fraction(E, 1n << BigInt(v_bits)));
      this.enter(J, over(plus(times(g, fraction(this.errors.get(K) || 0n, 1n << 512n)), own), low));
    }
    read_same() {
      const [first, second, third] = this.reader.read('same', 3), {body, exact: {low, L}, den, v_bits, e} = this;
      const wrong = 'an image is not the vertex that it is said to be';
      const [index, word] = split_index(third), [element] = spell(body.group, word);
      const j = this.vertex(first), T = this.letter(second), K = this.vertex(index), A = this.way(j), B = this.way(K);
      A.letters.push(T);
      if (this.rounding && !this.field) {
        demand(this.is_mirrored(A, B, word), 'nothing says of all masks near by that an image is a vertex');
        return this.settle(j, T);
      }
      const cycle = this.cycles.get(A.source), more = (A.letters.length - B.letters.length) / (cycle ? L : 1);
      const related = cycle ? B.source === A.source && Number.isInteger(more) : !this.cycles.has(B.source) && !more;
      demand(related || body.has.nonnegative, wrong);
      const points = i => transpose(body.coordinates(i)), lifted = x => this.field ? [...x, ...x.map(() => [0n])] : x;
      const lead = ({source, letters}, rounds) => this.lead(letters,
        range_of(Math.max(0, rounds)).reduce(x => cycle.next(x), cycle ? cycle.Y : lifted(points(source))));
      const left = related ? lead(A, -more) : [], right = related ? this.turned(element, lead(B, more)) : [];
      const same_row = i => related && left[i].every((x, k) => x === right[i][k]);
      const below = () => {  // with `nonnegative`; coordinates are times 2^VBITS
        const image = this.follow([T], points(j)), v = body.turned(element, points(K)), eX = times(e, body.most);
        const above = i => over(plus(image[i][0], times(eX, sum(this.matrices[T][i]))), den);
        return v.every((row, i) => same_row(i) || !less(times(low, minus(row[0], eX)), above(i)));
      };
      const opposite = () => related && equal(scaled(left, -1n), right);
      demand(body.has.nonnegative ? opposite() || below() : left.every((row, i) => same_row(i)) || opposite(), wrong);
      this.settle(j, T);
    }
    is_mirrored(A, B, word) {  // both stem from one vertex that is its own flip, up to its sign, by mirrored letters
      const {body, matrices} = this, cycle = this.cycles.get(A.source);
      const flipped = letters => letters.map(t => matrices.length - 1 - t);
      if (word !== 'f' || A.source !== B.source) return false;  // of a symmetric body alone
      if (String(A.letters) !== String(flipped(B.letters))) return false;
      if (cycle) return String(cycle.word) === String(flipped(cycle.word));
      const [x] = body.coordinates(A.source), reversed = x.slice().reverse();
      return equal([x], [reversed]) || equal([x], scaled([reversed], -1n));
    }
    check(values, den) {  // the values w + |r|_1 E of all images, times den: below LOW (1 - e) - g e, or settled
      const {exact: {low}, e, g, matrices} = this, limit = minus(times(low, minus(1n, e)), times(g, e));
      const most = floor_div(limit.n * den, limit.d), at = values.findIndex((x, i) => x > most && !this.settled.has(i));
      demand(at < 0, `image ${Math.floor(at / matrices.length)} ${at % matrices.length} may lie outside`);
    }
  }

  // ---- 4.8: quadratic forms -----------------------------------------------------------------------------------------
  // Lemma 17 of U, h and m. The rows of U and R are packed from the last column to the diagonal. Where some |R_kj| is
  // 2^h or more, x_jj will not be positive, as U_jj <= 4^h; so all R_kj that are used are smaller.
  function decomposes(U, h, m) {
    const d = U.length, width = 2 * h + 16, limit = 1n << BigInt(h), minus_limit = -limit, R = [];
    spend(d * d / 2, h, width * d / 2);
    spend(4 * d * d, width);
    for (let k = 0; k < d; ++k) {
      let packed = pack(U[k].slice(k).reverse(), width);
      for (const {row, values} of R) packed -= values[d - 1 - k] * row;
      const size = d - k, values = unpack(BigInt.asIntN(width * size, packed), width, size);
      const x = values[size - 1] - BigInt(d) * limit - BigInt(m);
      if (x <= 0n) return false;
      const diagonal = values[size - 1] = root(x);
      for (let i = 0; i < size - 1; ++i) {
        const value = values[i] = floor_div(values[i], diagonal);
        if (value >= limit || value <= minus_limit) return false;
      }
      R.push({values, row: pack(values, width)});
    }
    return true;
  }
  function positive_definite(S, most) {
    const by = 256 - bits(most);
    return decomposes(S.map(row => row.map(x => shift(x, by))), 128, S.length);
  }
  const nonnegative_form = S => { const most = largest_of(S); return !most || positive_definite(S, most); };
  const section_form = "expected 'norm', 'polytope', 'quadratic', 'graph' or 'single' and its numbers";
  function read_quadratic(reader, {size, den, matrices}, fields, rounding, exact) {
    demand(!rounding, section_form);
    demand(fields.length === 2 || (fields.length === 3 && fields[2].startsWith('group:')),
           "expected 'quadratic', a number of words, a bound and perhaps a group");
    const count = small(fields[0], 1, 2 ** 28), bound = rational(fields[1]);
    demand(bound.n >= 0n, 'the bound of a quadratic form is negative');
    const generators = fields.length === 3 ? small(fields[2].slice(6), 1, 8) : 0;
    const group = generators ? read_group(reader, generators, size, matrices) : trivial_group(matrices.length);
    const P = range_of(size).map(() => Array(size));
    for (let i = 0; i < size; ++i)
      reader.read('form', i + 1).map(integer).forEach((x, j) => { P[i][j] = P[j][i] = x; });
    demand(positive_definite(P, largest_of(P)), 'the form is not positive definite');
    for (const {map} of group.elements)
      demand(!map || equal(multiply(multiply(transpose(map), P), map), P), 'a generator does not keep the form');
    const texts = matrices.map(String), letter = texts.map(text => texts.indexOf(text));  // the first of equal matrices
    const congruence = new Congruence(P, matrices), words = new Set();
    let kept = false;  // the form, by a word, times a power of the bound
    for (let i = 0; i < count; ++i) {
      const word = reader.read('word', 1, 1000).map(token => letter[small(token, 0, matrices.length - 1)]);
      demand(!words.has(String(word)), 'a word occurs twice');
      words.add(String(word));
      allow_bits(words.size * 1024);
      spend(100);
      const k = BigInt(2 * word.length), whole = (bound.n * den) ** k << 64n, by = bound.d ** k, top = whole / by;
      const Q = congruence.of(word);
      const S = P.map((row, a) => row.map((x, b) => top * x - (Q[a][b] << 64n)));
      demand(nonnegative_form(S), 'a product is not below the bound in the quadratic form');
      kept = kept || (top * by === whole && S.every(row => row.every(x => !x)));
    }
    check_tree(words, group.elements.map(({numbers}) => numbers.map(t => letter[t])), new Set(letter).size);
    const same = (x, y) => !less(x, y) && !less(y, x);
    const attained = Boolean(exact) && kept && same(exact.low, exact.high) && same(bound, exact.low);
    return {value: bound, level: 1, attained};
  }
  // Q_w = A_w^T P A_w for the integer matrices of a family, kept for the last word and its beginnings. Most rows of the
  // A_t^T of a scheme are those of others: letters share X Q_w X^T, X the different rows of all, where these are few.
  class Congruence {
    constructor(P, matrices) {
      const factors = matrices.map(transpose), unique = rows => different(rows, String);
      const all = unique(factors.flat()), shared = all.length < 2 * P.length && {rows: all};
      this.letters = factors.map(factor => {
        const set = shared || {rows: unique(factor)}, texts = set.rows.map(String);
        return {set, at: factor.map(row => texts.indexOf(String(row)))};
      });
      this.growth = bits(largest_by(factors, row_norm) || 1n);
      this.base = bits(largest_of(P)) + 4;
      [this.word, this.nodes] = [[], [{Q: P, images: new Map()}]];
    }
    width(k) { return this.base + (2 * k + 1) * this.growth; }  // for Q_w of k letters, and for A^T Q_w
    of(word) {
      let same = 0;
      while (same < word.length && word[same] === this.word[same]) ++same;
      this.nodes.length = same + 1;
      this.word = word;
      for (let k = same; k < word.length; ++k) {
        const {set, at} = this.letters[word[k]], {Q, images} = this.nodes[k];
        if (!images.has(set)) images.set(set, this.image(set.rows, Q, this.width(k), this.width(k + 1)));
        const image = images.get(set);
        this.nodes.push({Q: at.map(i => at.map(j => image[i][j])), images: new Map()});
      }
      return this.nodes[word.length].Q;
    }
    image(rows, Q, width, next) {  // X Q X^T for the rows of X
      const size = rows[0].length, image = rows.map(() => []), packed = Q.map(row => pack(row, width));
      allow_bits(rows.length * size * next * (this.nodes.length + 1));
      spend(rows.length * (rows.length + size), this.growth, next * rows.length);
      spend(6 * rows.length * rows.length, next);
      let columns = transpose(rows.map(row => unpack(combine(row, packed), width, size))).map(row => pack(row, next));
      for (let i = rows.length - 1, slots = rows.length; i >= 0; --i) {  // of row i the columns up to i, or some more
        if ((i + 1) % 12 === 0) columns = columns.map(x => BigInt.asIntN(next * (slots = i + 1), x));
        unpack(combine(rows[i], columns), next, slots).forEach((x, j) => { image[i][j] = image[j][i] = x; });
      }
      return image;
    }
  }
  function check_tree(words, permutations, letters) {  // the words and their images under the group are a complete tree
    const images = new Set(), maps = different(permutations, String);
    const length_of = image => image.split(',').length - 1, tree = 'the words are not those of a complete tree';
    let longest = 0, memory = 0, total = 0n;
    for (const word of words) {
      const numbers = word.split(',');
      longest = Math.max(longest, numbers.length);
      allow_bits(memory += maps.length * (numbers.length + 8) * 64);
      for (const p of maps) images.add(numbers.map(t => p[t] + ',').join(''));
    }
    for (const image of images) {
      total += BigInt(letters) ** BigInt(longest - length_of(image));
      spend(length_of(image), 64, longest * 64);
      for (let at = image.indexOf(',') + 1; at < image.length; at = image.indexOf(',', at) + 1)
        demand(!images.has(image.slice(0, at)), tree);
    }
    demand(total === BigInt(letters) ** BigInt(longest), tree);
  }

  // ---- 4.13: graphs -------------------------------------------------------------------------------------------------
  const gram = m => multiply(transpose(m), m);
  const difference = (x, y) => x.map((row, i) => row.map((value, j) => value - y[i][j]));
  // Products of words in integers: matrices are arrays of rows
  const integer_words = h => ({
    matrix: rows => rows,
    rows: matrix => matrix,
    product: (M, B) => multiply(M, B).map(row => row.map(x => x >> BigInt(h))),
    is_at_most: (M, c) => {
      const U = difference(scaled(identity(M.length), c * c), gram(M));
      return U.every((row, i) => row[i] > 0n) && decomposes(U, h, 0);
    },
  });
  // The same in Numbers, which with h <= 24 are integers below 2^53. |B| <= NORM <= 7 U, and where a word goes on
  // |M| <= p + e <= 4 U, as p' + e' is at least |M| NORM / U + d. By Cauchy and Schwarz the partial sums of M B are at
  // most 28 U^2 in modulus. So are those of M'^T M' where its diagonal is below c^2; where it is not, sums are exact
  // or, rounded, at least 2^53, and refused. In Lemma 17 |U_kj| <= U^2, and no column of R that is used is longer than
  // U: |x_kj| <= 2^49, divisors and roots are at most 2^24, and what is not an integer is farther from one than
  // rounding leads. R_kj^2 may be rounded where it is above 2^53, and x_jj is negative then.
  function add_rows(sum, at, factors, f, by, rows, r, count, n, d) {  // f, f + by, ... times rows r, r + d, ...
    for (let k = 0; k < count;) {
      const some = count - k < 4 ? 1 : 4, a = factors[f];
      if (some === 1) {
        for (let j = 0; j < n; ++j) sum[at + j] += a * rows[r + j];
      } else {
        const b = factors[f + by], c = factors[f + 2 * by], e = factors[f + 3 * by];
        for (let j = 0, i = r; j < n; ++j, ++i)
          sum[at + j] += a * rows[i] + b * rows[i + d] + c * rows[i + 2 * d] + e * rows[i + 3 * d];
      }
      k += some;
      f += some * by;
      r += some * d;
    }
  }
  const number_words = (h, d) => {
    const part = 2 ** -h, G = new Float64Array(d * d), price = () => spend(d * d * (d / 160 + 0.04) + 1);
    return {
      matrix: rows => Float64Array.from(rows.flat(), Number),
      rows: matrix => range_of(d).map(i => Array.from(matrix.subarray(i * d, i * d + d), BigInt)),
      product: (M, B, out = new Float64Array(d * d)) => {
        price();
        out.fill(0);
        for (let i = 0; i < d * d; i += d) add_rows(out, i, M, i, 1, B, 0, d, d, d);
        for (let i = 0; i < d * d; ++i) out[i] = Math.floor(out[i] * part);
        return out;
      },
      is_at_most: (M, bound) => {  // G is M'^T M' - c^2 1, and then d 2^h 1 - U
        price();
        const c = Number(bound);
        G.fill(0);
        for (let i = 0; i < d; ++i) {
          const ii = i * d + i;
          G[ii] = -c * c;
          add_rows(G, ii, M, i, d, M, i, d, d - i, d);
          if (G[ii] >= 0) return false;
          G[ii] += d * 2 ** h;
        }
        for (let k = 0; k < d; ++k) {
          const kk = k * d + k;
          add_rows(G, kk + 1, G, k, d, G, k + 1, k, d - k - 1, d);
          if (G[kk] >= 0) return false;
          const diagonal = Math.floor(Math.sqrt(-G[kk]));
          for (let j = k + 1; j < d; ++j) {
            const value = G[k * d + j] = Math.floor(-G[k * d + j] / diagonal);
            if ((G[j * d + j] += value * value) >= 0) return false;
          }
        }
        return true;
      },
    };
  };
  // 4.14. Of a state L, the number of the state to which its kept word leads, and A of it; without such a word `to` is
  // undefined. A row is a multiple of u_i: its real and its imaginary part, and the bound of its error.
  class KeptWords {
    constructor(reader, exact, options) { Object.assign(this, options, {reader, exact, used: new Set()}); }
    read() {
      while (this.reader.peek() === 'cycle') this.read_cycle();
      demand(this.states.every(({to}, j) => to === undefined || this.used.has(j)), 'a kept word is on no cycle');
    }
    read_cycle() {
      const {reader, exact, size, den, states, used} = this, [first, ...fields] = reader.read('cycle', 4);
      demand(!less(exact.low, this.bound), 'the bound of a graph with cycles is above the exact radius');
      const J = small(first, 0, states.length - 1), K = small(fields[0], 0, size - 1);
      const [kept, scale] = fields.slice(1).map(rational), way = [];
      demand(sign(kept) >= 0 && less(kept, 1n), 'the kept part of a norm is not from 0 to 1');
      demand(sign(scale) > 0, 'the scale of a cycle is not positive');
      for (let j = J; !way.length || j !== J; j = states[j].to) {
        demand(states[j].to !== undefined, 'a cycle leads to a state without a kept word');
        demand(!used.has(j) && way.length < exact.L, 'a cycle is too long, or meets one that came before');
        used.add(j);
        way.push(states[j]);
      }
      demand(way.length === exact.L, 'a cycle is too short');
      const next = x => transpose(way.reduce((row, {A}) => multiply(row, A), transpose(x))), D = den ** BigInt(exact.L);
      this.check(way, D, read_seed(reader, exact, size, D, () => next, 0).columns, K, kept, scale);
    }
    row(columns, D) {  // with no more than 1024 bits; and how many were dropped
      const {U, error} = eigenvector_of(this.exact, columns, D), numbers = transpose(U);
      const cut = Math.max(0, bits(largest_of(numbers)) - 1024), by = BigInt(cut);
      spend(2 * this.size, cut + 1024);
      spend(2, bits(error.n) + 512, bits(error.d));
      const away = fraction(ceil_div(error.n << 512n, error.d << by), 1n << 512n);
      return {numbers: numbers.map(x => x.map(value => value >> by)), by, error: cut ? plus(away, 2 * this.size) : away};
    }
    // `below` is the factor of |u_i|^2 in the second matrix, `above` the reciprocal of that in the first one, but for
    // 1 - KEPT; rounded up, both make it harder.
    check(way, D, columns, K, kept, scale) {
      const {exact, den} = this, square = x => times(x, x), low = square(exact.low), high = square(exact.high);
      let row = this.row(columns, D);
      const [re, im] = row.numbers.map(x => x[K]), modulus = re * re + im * im;
      const off = times(2n * norm([re, im]), row.error), least = minus(modulus, off);
      demand(sign(least) > 0, 'the eigenvector of a cycle may be zero at its coordinate');
      const room = over(low, square(this.bound)), rest = minus(1n, kept);
      const change = ({numbers, error}) => times(2n * sum(numbers.map(norm)), error);
      let below = round_up(over(square(scale), least));
      let above = over(plus(plus(modulus, off), square(row.error)), square(scale));
      way.forEach(({L, A}, i) => {
        const error = plus(change(row), square(row.error)), {by} = row;
        demand(this.is_positive([[room, gram(L)], [minus(0n, below), gram(row.numbers)]], times(below, error)),
               'the norm of a state does not bound the eigenvector');
        columns = multiply(columns, A);
        row = this.row(columns, D);
        const factor = fraction(den * den << 2n * by, 1n << 2n * row.by);
        above = round_up(times(above, factor));
        const image = gram(multiply(L, A)), target = gram(way[(i + 1) % way.length].L);
        demand(this.is_positive([[times(above, times(kept, low)), target], [rest, gram(row.numbers)],
                                 [over(minus(0n, above), den * den), image]], times(rest, change(row))),
               'the norm of a kept word is not that of the radius');
        below = round_up(over(below, times(factor, low)));
        above = times(above, high);
      });
    }
    is_positive(terms, less_diagonal) {  // the sum of the terms, factors and matrices, less a multiple of 1
      const all = [...terms, [minus(0n, less_diagonal), identity(this.size)]];
      const common = all.reduce((d, [factor]) => d * factor.d, 1n);
      const parts = all.map(([{n, d}, matrix]) => {
        const multiple = n * (common / d);
        spend(2 * this.size ** 2, bits(multiple), bits(largest_of(matrix)));
        return scaled(matrix, multiple);
      });
      return nonnegative_form(parts.reduce((x, y) => x.map((row, i) => row.map((value, j) => value + y[i][j]))));
    }
  }
  function read_graph(reader, {size, den, matrices}, fields, rounding, exact) {
    demand(!rounding, section_form);
    demand(fields.length === 3 || (fields.length === 4 && fields[3].startsWith('group:')),
           "expected 'graph', a number of states, a bound, a number of bits and perhaps a group");
    const count = small(fields[0], 1, 4096), bound = rational(fields[1]), h = small(fields[2], 8, 1000);
    demand(bound.n > 0n, 'the bound of a graph is not positive');
    const generators = fields.length === 4 ? small(fields[3].slice(6), 1, 8) : 0;
    const group = generators ? read_group(reader, generators, size, matrices) : trivial_group(0);
    const graph = new Graph(reader, {size, den, count, bound, h, group, may_keep: Boolean(exact)});
    const texts = matrices.map(String), letters = range_of(texts.length).filter(t => texts.indexOf(texts[t]) === t);
    for (let j = 0; j < count; ++j) graph.read_state(letters);
    for (const {L, steps} of graph.states)
      steps.forEach((list, i) => list.forEach(step => graph.check_step(L, matrices[letters[i]], step)));
    for (const state of graph.states) graph.check_tree(state);
    const kept = graph.states.map(({L, kept: [place, to] = []}) => ({L, to, A: matrices[letters[place]]}));
    const attained = Boolean(exact) && reader.peek() === 'cycle';
    if (exact) new KeptWords(reader, exact, {size, den, bound, states: kept}).read();
    return {value: attained ? exact.high : bound, level: 1, attained};
  }
  class Graph {
    constructor(reader, {h, ...options}) {
      Object.assign(this, options, {reader, h, U: 1n << BigInt(h), states: [], memory: 0});
      this.words = h <= 24 ? number_words(h, this.size) : integer_words(h);
    }
    read_state(letters) {
      const {reader, size} = this;
      const L = range_of(size).map(i => {
        const row = reader.read('coordinates', i + 1).map(integer);
        demand(row[i], 'the coordinates of a state have a 0 on the diagonal');
        return [...row, ...Array(size - 1 - i).fill(0n)];
      });
      allow_bits(this.memory += size * size * (bits(largest_of(L)) + 256) + 2048);
      const steps = letters.map(T => {
        const list = [];
        do list.push(this.read_step(T)); while (reader.load()[0] === 'step' && reader.load()[1] === String(T));
        return list;
      });
      const [tree] = reader.read('tree', 1);
      this.states.push({L, steps, tree});
    }
    read_step(T) {
      const {reader, size, U} = this, larger = 'the norm of a step is larger than it says';
      const [to, text, ...entries] = reader.read(`step ${T}`, 2 + size * size), [index, letters] = split_index(to);
      const step = {to: small(index, 0, this.count - 1), letters, turned: spell(this.group, letters),
                    norm: integer(text)};
      demand(step.norm >= 1n && step.norm <= 7n * U, 'the norm of a step is not from 1 to 7 2^BITS');
      const B = range_of(size).map(i => entries.slice(i * size, (i + 1) * size).map(integer));
      demand(largest_of(B) <= step.norm, larger);
      demand(nonnegative_form(difference(scaled(identity(size), step.norm * step.norm), gram(B))), larger);
      allow_bits(this.memory += size * size * (this.h + 256) + 2048);
      return {...step, B: this.words.matrix(B)};
    }
    check_step(L, A, {to, turned: [element, turn], B}) {  // W and S of 4.13
      const {size, den, bound, U, group, states} = this, {map} = group.elements[element], right = den * bound.n;
      const target = map ? scaled(multiply(states[to].L, map), turn) : states[to].L;
      const W = difference(scaled(multiply(L, A), U * bound.d), scaled(multiply(this.words.rows(B), target), right));
      const S = difference(scaled(gram(target), (BigInt(size) * right) ** 2n), gram(W));
      demand(nonnegative_form(S), 'the matrix of a step is not near the one that it stands for');
    }
    check_tree(state) {
      const {words, size, U} = this;
      [this.tree, this.at] = [state.tree, 0];
      this.products = [words.matrix(scaled(identity(size), U))];  // of the beginnings of a word
      this.follow(state, 1, U, 0n);
      demand(this.at === state.tree.length, 'a tree has more characters than its words');
    }
    follow(state, length, p, e) {  // the words of so many letters or more that came to this state
      const {words, h, U, products} = this, d = BigInt(this.size), up = x => -(-x >> BigInt(h));
      for (const [place, steps] of state.steps.entries()) {
        demand(this.at < this.tree.length, 'a tree has fewer characters than its words');
        const end = this.tree[this.at++], goes_on = end === '+';
        if (this.may_keep && end === '*') {
          demand(length === 1, 'a kept word has more than one letter');
          demand(!steps[0].letters, 'the step of a kept word has a word of the group');
          demand(!state.kept, 'a state has two kept words');
          state.kept = [place, steps[0].to];
          continue;
        }
        demand(!goes_on || length < 1000, 'a word of more than 1000 letters');
        const {to, norm, B} = steps[goes_on ? 0 : this.number_of(end, steps.length)];
        spend(3, h, h);
        allow_bits(this.memory + (length + 1) * this.size * this.size * (h + 256));
        const M = products[length] = words.product(products[length - 1], B, products[length]);
        const next_p = up(p * (norm + d)), next_e = up(e * norm + p * d) + d;
        demand(!goes_on || next_p + next_e <= 4n * U, 'the product of a word that goes on is too large');
        if (goes_on) this.follow(this.states[to], length + 1, next_p, next_e);
        else demand(next_e < U && words.is_at_most(M, U - next_e), 'the product of a word is not below the bound');
      }
    }
    number_of(end, count) {
      const number = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz'.indexOf(end);
      demand(number >= 0, 'a word ends with none of 0-9, A-Z, a-z');
      demand(number < count, 'a word ends by a step that is not there');
      return number;
    }
  }

  // ---- 4.11: one spectral radius ------------------------------------------------------------------------------------
  const half_of = x => x.slice((x.length - 1) / 2);  // a symmetric polynomial from its middle on
  const with_mirror = x => product_of(x, x.slice().reverse());  // x(z) x(1/z)
  function lowest_terms({arity, q, b}) {  // b(z) = sum b_i z^i / D with the least D
    const numbers = b.map(p => p[0]), D = numbers.reduce(gcd, q[0]);
    return {arity, D: q[0] / D, b: numbers.map(x => x / D)};
  }
  function read_single(reader, {symbol}, fields, rounding, exact) {
    demand(symbol && !rounding, section_form);
    demand(fields.length === 2, "expected 'single', a bound and the digits of a factor");
    const bound = rational(fields[0]), q_bits = small(fields[1], 0, 4096);
    const centred = lowest_terms(symbol), {b} = centred;
    demand(bound.n >= 0n, 'the bound of a radius is negative');
    demand(b.length % 2 && b.every((x, i) => x === b[b.length - 1 - i]),
           'one spectral radius needs a symmetric mask with an odd number of coefficients');
    const s = reader.read('square', 1, 1000).map(integer);
    demand(s[0] && s[s.length - 1], 'a polynomial of squares begins or ends with 0');
    const quotient = quotient_of(b, with_mirror(s));
    demand(quotient, 'the square does not divide the mask');
    const [h, q] = [half_of(quotient), half_of(with_mirror(reader.read('factor', 1, 1000).map(integer)))];
    const e = range_of(Math.max(h.length, q.length)).map(i => ((h[i] || 0n) << BigInt(2 * q_bits)) - (q[i] || 0n));
    demand(e[0] >= 2n * norm(e.slice(1)), 'the cosine polynomial is not shown to be a sum of squares');
    const {P, r} = read_recurrence(reader, centred);
    demand(!sign_changes(shifted_signs(P, bound)), 'the recurrence may have a zero above the bound');
    demand(!exact || (exact.L === 1 && exact.real && exact.y[0] > 0n), 'one spectral radius is a positive zero');
    return {value: bound, level: 1, attained: Boolean(exact), order: exact && order_of_pole(P, r(), exact)};
  }
  function read_recurrence(reader, {arity, D, b}) {  // P, and a function for r times D^(d - 1)
    const P = reader.read('recurrence', 2, 1000).map(integer), d = P.length - 1, m = [];
    demand(P[d], 'the last coefficient of a recurrence is 0');
    const c = (b.length - 1) / 2, size = Math.floor(c / (arity - 1)) + 1, at = i => b[c + i] || 0n;
    const C = range_of(size).map(j => range_of(size).map(k => at(arity * j - k) + (k ? at(arity * j + k) : 0n)));
    const entries = C.flat().filter(y => y).length, growth = bits(largest_of(C));
    let x = identity(size)[0], total = x.map(() => 0n);  // x is D^n x_n
    for (const p of P) {
      const length = bits(largest(x)), memory = bits(largest(total)) + bits(p) + bits(D) + length;
      m.push(x[0]);
      spend(2 * entries, length, growth);
      spend(size, bits(p), length);
      spend(size, bits(D), memory);
      allow_bits(memory * (size + P.length) * 2);
      total = total.map((y, j) => y * D + p * x[j]);
      x = C.map(row => combine(row, x));
    }
    demand(total.every(y => !y), 'the recurrence is wrong');
    const r = () => {
      spend(d, d * bits(D), d * bits(D));
      return product_of(P, m.slice(0, d).map((x, n) => x * D ** BigInt(d - 1 - n)).reverse()).slice(d);
    };
    return {P, r};
  }
  function order_of_pole(P, r, {p, h, y, m, eps, low}) {  // of F at z, the only pole at LOW or above
    const divide = (x, times_p = 0) => {
      const quotient = quotient_of(x, p);
      return quotient ? divide(quotient, times_p + 1) : [times_p, x];
    };
    const [k] = divide(P), [j, rest] = divide(r), signs = shifted_signs(P, low);
    const zeros = sign_changes(signs) + signs.findIndex(x => x);
    demand(j < k && zeros === k, 'the exact radius may not be the largest zero of the recurrence');
    const slope = horner(rest.map((x, i) => abs(x) * BigInt(i)).slice(1), m), value = horner(rest, fraction(y[0], h));
    demand(less(times(eps, slope), abs_of(value)), 'the exact radius may be no pole');
    return k - j;
  }

  // ---- Frequencies (4.17) ---------------------------------------------------------------------------------------------
  class Arcs {  // bounds of |D b| W on arcs
    constructor({D, b}, L, precision) {
      Object.assign(this, {D, L, circle: new Circle(precision), words: Math.ceil(precision / 64) + 2});
      const N = b.length - 1;
      this.rows = range_of(L + 1).map(l => b.map((x, k) => x * BigInt(2 * k - N) ** BigInt(l)));
      this.sums = this.rows.map(norm);
      this.errors = this.sums.map(total => total * BigInt(N) << 19n);
    }
    at_reach(x, from) {  // the sum of x_(l + from) R^l/l!
      const {W} = this.circle;
      return x.slice(from, this.L).reduceRight(
        (total, value, l) => value + ceil_div(total * this.R, W * BigInt(l + 1)), 0n);
    }
    expand(middle, radius) {
      const {circle, L, rows} = this, {W} = circle, size = rows[0].length, waves = circle.powers(middle, size);
      this.R = circle.half_angle(radius) + 3n;
      spend(2 * L * size, bits(largest(rows[L - 1])), 64 * this.words);
      this.P = rows.slice(0, L).map(row => waves.map(wave => sum(row.map((c, k) => c * wave[k]))));
      const sizes = this.P.map(([re, im], l) => root(re * re + im * im) + 1n + this.errors[l]);
      this.bend = this.at_reach(sizes, 2);
      this.rounding = [0, 1].map(from => this.at_reach(this.errors, from) + BigInt(2 * L));
      this.rest = this.sums[L] * W;
      for (let l = L; l; --l) this.rest = ceil_div(this.rest * this.R, W * BigInt(l));
    }
    value(from, t) {
      const {W} = this.circle;
      let re = 0n, im = 0n;
      for (let l = this.L - 1; l >= from; --l) {
        const scale = W * BigInt(l - from + 1), [x, y] = this.P[l];
        [re, im] = [x - im * t / scale, y + re * t / scale];
      }
      return root(re * re + im * im) + 1n + this.rounding[from];
    }
    largest(offset, half) {
      const {circle, bend, rest} = this, {W} = circle, t = circle.half_angle(offset), h = circle.half_angle(half) + 6n;
      return this.value(0, t) + ceil_div(h * this.value(1, t), W) + ceil_div(h * h * bend, 2n * W * W) + rest;
    }
  }
  function read_frequency(reader, {symbol}, fields, rounding, exact) {
    demand(symbol && !rounding, section_form);
    demand(fields.length === 7, "expected 'frequency', a bound and six numbers");
    const bound = rational(fields[0]), limits = [[1, 4096], [1, 1000], [1, 2 ** 20], [1, 2 ** 20], [2, 64], [64, 1024]];
    const [m, J, steps, group, L, precision] = limits.map(([low, high], i) => small(fields[i + 1], low, high));
    const {arity} = symbol, A = BigInt(arity), arcs = new Arcs(lowest_terms(symbol), L, precision);
    demand(A ** BigInt(J) >= BigInt(m), 'too few shells for so many cells');
    demand(bound.n > 0n, 'the bound of a radius is not positive');
    const size = (arity - 1) * m, weights = reader.read('weights', size).map(integer);
    demand(weights.every(weight => weight > 0n), 'a weight is not positive');
    const unit = A * arcs.D * arcs.circle.W, factor = bound.n * unit;
    const aliases = (bounds, beyond) => bounds.slice(1).reduce((total, x, r) => {
      const place = 2 * (r + 1) * m + beyond, cell = place < arity * m ? place : 2 * arity * m - 1 - place;
      return total + x * weights[cell - m];
    }, 0n);
    const branches = range_of(arity), start = r => fraction(BigInt(2 * r), A);
    const end = fraction(1n, 2n * A ** BigInt(J + 1)), inner = branches.map(r => {
      arcs.expand(plus(start(r), end), end);
      return arcs.largest(fraction(0n), end);
    });
    const rest = factor - inner[0] * bound.d;
    demand(rest > 0n, 'the bound is not above the symbol near 0');
    let values = weights.map(() => bound.d * aliases(inner, 0) / rest + 1n);
    for (let j = J; j--;) {
      const a = A ** BigInt(j), parts = Number(ceil_div(BigInt(steps), a)), count = size * parts;
      const wide = BigInt(group) * a * BigInt(parts) / BigInt(steps);
      const together = wide < BigInt(count) ? Math.max(1, Number(wide)) : count;
      const part = fraction(1n, a * A * A * BigInt(m * parts)), times_part = x => times(part, fraction(BigInt(x), 2n));
      spend(arity * count * (8 * L + 100), 64 * arcs.words, 64 * arcs.words);
      const images = branches.map(r => {
        const most = weights.map(() => 0n);
        for (let first = 0; first < count; first += together) {
          const last = Math.min(count, first + together);
          arcs.expand(plus(start(r), times_part(2 * m * parts + first + last)), times_part(last - first));
          for (let s = first; s < last; ++s) {
            const cell = Math.floor(s / parts);
            most[cell] = max(most[cell], arcs.largest(times_part(2 * s + 1 - first - last), times_part(1)));
          }
        }
        return most;
      });
      values = values.map((value, i) => {
        const bounds = images.map(most => most[i]), beyond = Number(BigInt(m + i) / (a * A));
        return bound.d * (bounds[0] * value + aliases(bounds, beyond)) / factor + 1n;
      });
    }
    demand(values.every((value, i) => value <= weights[i]), 'the bound is not proved by the weights');
    return {value: bound, level: 1, attained: false};
  }

  // ---- Blocks, product and sections: goal.above(radius, length) and goal.below(value, level) demand what the claim ne
  function read_section(reader, number, family, first_column, rounding, exact) {
    const [kind, ...fields] = reader.read(`block ${number}`, 1, 20);
    demand(kind !== 'norm' || fields.length === 1, "wrong number of fields after 'norm'");
    if (kind === 'norm') return check_norm(family, small(fields[0], 1, 64), first_column, rounding);
    const kinds = [['polytope', read_polytope], ['quadratic', read_quadratic], ['graph', read_graph],
      ['single', read_single], ['frequency', read_frequency]];
    const read = new Map(kinds).get(kind);
    demand(read, section_form);
    return read(reader, family, fields, rounding, exact);
  }
  function prove(reader, family, goal, options = {}) {
    const {first_column = false, rounding = null, product = read_product, exact = null, part = null} = options;
    const in_blocks = reader.peek() === 'blocks';
    demand(!in_blocks || !rounding, 'blocks prove nothing of rounded masks');
    demand(in_blocks || !part || !part.unobservable, "expected 'blocks', those of what is unobservable first");
    const blocks = !in_blocks ? [family] : family.field ? read_field_blocks(reader, family, part) : read_blocks(reader, family, part);
    if (goal.above || reader.peek() === 'product') {
      const {radius, length, letters} = product(reader, blocks, rounding);
      if (goal.above) goal.above(radius, length, letters);
    }
    const sections = [];
    if (goal.below || exact || reader.peek() === 'block')
      blocks.forEach((block, i) => {
        if (block.hidden) {  // phi is continuous: their radius is below 1
          const {value, level} = read_section(reader, i, block, false, block.rounding || null, null);
          at_most(fraction(1n), true)(value, level);
          return;
        }
        const section = read_section(reader, i, block, first_column && !in_blocks, block.rounding || rounding, exact);
        const {value, level, attained} = section;
        demand(!exact || attained || !less(power(exact.low, level), value),
               'the bound of a block is above the exact radius');
        if (goal.below) goal.below(value, level);
        sections.push(section);
      });
    demand(!exact || sections.some(section => section.attained), 'no block attains the exact radius');
    return sections;
  }
  const unproved_product = "the product's spectral radius does not prove the claim";
  const no_exponent = 'the product proves no exponent below the number of sum rules';
  const at_most = (limit, strict) => (value, level) => {
    const allowed = power(limit, level), proved = strict ? less(value, allowed) : !less(allowed, value);
    demand(sign(limit) >= 0 && proved, 'the bound does not prove the claim');
  };
  const at_least = limit => (radius, length) => demand(!less(radius, power(limit, length)), unproved_product);

  // ---- Radius claims ------------------------------------------------------------------------------------------------
  function check_radius(reader, {family, lower, upper, exact}) {
    const least = lower && at_least(sign(lower) > 0 ? lower : fraction(0n));
    prove(reader, family, {below: upper && at_most(upper, false), above: least}, {exact});
  }

  // ---- 4.15: subradius claims ---------------------------------------------------------------------------------------
  function read_upper_end(reader, family, upper) {
    const {size, den, matrices} = family, {c: [re, im], word} = read_word(reader, [family], matrices.length);
    demand(sign(re) >= 0 && !sign(im), 'the product of a subradius needs a real number that is not negative');
    const weights = reader.read('weights', size).map(integer);
    demand(weights.every(x => x > 0n), 'a weight is not positive');
    const image = word.reduceRight((x, t) => multiply(matrices[t], x), weights.map(x => [x]));
    const all = power(fraction(den), word.length).n * re.n;
    spend(2 * size, bits(all), bits(largest(weights)) + bits(re.d));
    demand(image.every(([x], i) => x * re.d <= all * weights[i]),
           'the product takes a weight to more than the given multiple');
    demand(!upper || (sign(upper) >= 0 && !less(power(upper, word.length), re)),
           'the product does not prove the upper end');
  }
  function read_lower_end(reader, {size, den, matrices}, lower, exact) {
    const [kind, ...fields] = reader.read('block 0', 4, 5), transposed = fields.length > 3;
    demand(kind === 'polytope', section_form);
    demand(!transposed || fields[3] === 'transposed', 'unknown property of the polytope of a subradius');
    const {count, c_bits} = read_sizes(fields), all = transposed ? matrices.map(transpose) : matrices;
    const has = {nonnegative: true, nonzero: true};
    const body = new Body(reader, {size, count, c_bits, has, group: trivial_group(0)});
    const one = 1n << BigInt(c_bits);
    const least = lower ? ceil_div(lower.n * one, lower.d) : 0n, weights = [];
    let reached = true, memory = 0;  // least <= g one, which is an integer
    for (let j = 0; j < count; ++j)
      body.images(all, j).forEach((image, t) => {
        const below = image.map(x => x.map(value => -value * one));
        const {residual, weight} = body.read_combination(`image ${j} ${t}`, below, -den);
        demand(!residual, 'an image is not above the sum of its terms');
        if (weight < least) reached = false;
        if (exact) weights.push(weight);
        allow_bits(memory += bits(weight) + 256);
      });
    demand(reached, 'the weights of an image do not prove the lower end');
    if (exact) new SlowVertices(reader, body, exact, {matrices: all, den}).check(weights, c_bits);
  }
  // The vertices V_J above those of a body: factors[J] / 2^512 is D_J.
  class SlowVertices extends Origins {
    constructor(reader, body, exact, {matrices, den}) {
      super(reader, body, matrices);
      Object.assign(this, {exact, den, factors: [], cut: [], settled: new Set(), memory: 0});
      this.read_cycle();
      for (let J = 1; J < body.count; ++J) this.read_origin(J);
      const last = this.last_of(this.word, 0);
      demand(!this.cut[last], 'a vertex of the cycle is cut');
      this.settle(last, this.word[this.word.length - 1]);
      this.needed = times(exact.high, fraction(largest(this.factors), 1n << 512n));  // HIGH D
      while (reader.peek() === 'same') this.read_same();
    }
    enter(factor) {
      spend(8, bits(factor.n) + 512, bits(factor.d));
      const up = ceil_div(factor.n << 512n, factor.d);
      allow_bits(this.memory += bits(up) + 2048);
      this.factors.push(up);
    }
    quotient(x, y) {  // the largest x_i / y_i where y_i > 0
      spend(3 * x.length, bits(largest(x)), bits(largest(y)));
      return x.reduce((most, value, i) => {
        const next = y[i] > 0n ? fraction(value, y[i]) : most;
        return less(most, next) ? next : most;
      }, fraction(0n));
    }
    read_cycle() {
      const {reader, body, exact, den} = this, {L} = exact, {size} = body, D = den ** BigInt(L);
      const [v] = body.coordinates(0);
      const word = this.word = reader.read('cycle 0 -', L).map(t => this.letter(t));
      this.next = x => this.follow(word, x);
      const {columns, memory} = read_seed(reader, exact, size, D, () => this.next, 0);
      [this.Y, this.memory] = [transpose(columns), memory];
      const {U, error: u} = eigenvector_of(exact, columns, D), turn = U[v.findIndex(x => x)][0] < 0n ? -u.d : u.d;
      spend(4 * size, bits(largest_of(U)), bits(u.d));
      const least = U.map(([x]) => turn * x - u.n), most = U.map(([x]) => turn * x + u.n);
      demand(v.every((x, i) => x ? least[i] > 0n : columns.every(y => !y[i])),
             'a coordinate of the eigenvector may not be positive, or not be 0, as that of the vertex is');
      this.enter(times(this.quotient(v, least), this.quotient(most, v)));
      if (v.every(x => x)) return;
      const weights = reader.read('rest', size).map(integer), low = power(exact.low, L);
      demand(weights.every(x => x > 0n), 'a weight is not positive');
      const rest = weights.map((x, i) => v[i] ? 0n : x), image = this.next(rest.map(x => [x]));
      spend(4 * size, bits(low.n) + bits(D), bits(largest(rest)) + bits(low.d));
      demand(image.every(([x], i) => v[i] || x * low.d <= low.n * D * rest[i]),
             'the cycle takes a weight of the rest to too much');
    }
    read_origin(J) {
      const {K, T} = this.link(J, this.reader.read(`origin ${J}`, 2)), {exact: {low, high}, den, body} = this;
      const [v] = body.coordinates(J), image = this.follow([T], body.coordinates(K)[0].map(x => [x])).map(([x]) => x);
      spend(4 * v.length, bits(largest(v)) + bits(high.d), bits(high.n) + bits(den));
      const below = v.every((x, i) => x * high.n * den <= image[i] * high.d);
      demand(below, 'a vertex is above the image from which it stems');
      this.cut[J] = this.cut[K] || v.some((x, i) => !x && image[i]);
      this.enter(over(times(fraction(this.factors[K], 1n << 512n), this.quotient(image, v)), times(low, den)));
    }
    read_same() {
      const [first, second, third] = this.reader.read('same', 3), {body, exact: {L}, den, needed, cut} = this;
      const j = this.vertex(first), T = this.letter(second), K = this.vertex(third), A = this.way(j), B = this.way(K);
      A.letters.push(T);
      const more = (A.letters.length - B.letters.length) / L, related = !cut[j] && !cut[K] && Number.isInteger(more);
      const lead = ({letters}, rounds) => this.follow(letters,
        range_of(Math.max(0, rounds)).reduce(x => this.next(x), this.Y));
      const left = related ? lead(A, -more) : [], right = related ? lead(B, more) : [];
      const [v] = body.coordinates(K), image = this.follow([T], body.coordinates(j)[0].map(x => [x]));
      spend(4 * v.length, bits(largest(v)) + bits(needed.n), bits(needed.d) + bits(den));
      const same_row = i => related && equal([left[i]], [right[i]]);
      demand(v.every((x, i) => same_row(i) || image[i][0] * needed.d >= needed.n * den * x),
             'an image is not above the vertex that it is said to be');
      this.settle(j, T);
    }
    check(weights, c_bits) {  // the sums of the weights of all images, times 2^CBITS: HIGH D or more, or settled
      const least = ceil_div(this.needed.n << BigInt(c_bits), this.needed.d), count = this.matrices.length;
      const at = weights.findIndex((x, i) => x < least && !this.settled.has(i) && !this.children.has(i));
      demand(at < 0, `image ${Math.floor(at / count)} ${at % count} may lie below`);
    }
  }
  function check_subradius(reader, {family, lower, upper, exact}) {
    demand(!exact || exact.real, 'a subradius needs a real zero');
    if (upper || reader.peek() === 'product') read_upper_end(reader, family, upper);
    if (lower || exact || reader.peek() === 'block') read_lower_end(reader, family, lower, exact);
  }

  // ---- Exponent, range, roughness and rounded claims: 4.2, 4.3, 4.9, 6.1, 6.2, 6.4 ----------------------------------
  function check_ends(lower, upper, least) {  // 2, the limits
    demand(!lower || sign(lower) >= least, 'the lower end of an exponent must be positive');
    demand([lower, upper].every(end => !end || (sign(end) >= 0 && !less(10000, end))), 'an exponent is negative or too large');
  }
  function check_exponent(exact, order, most, dimension = 1, least = 1n) {  // 4.10, the last but one paragraph
    demand(!exact || exact.order === order, 'the exact exponent has another number before its logarithm');
    demand(!exact || (less(power(exact.high, dimension), most) && less(least, power(exact.low, dimension))),
           'the exact radius proves no exponent between 0 and the number of sum rules');
  }
  function check_curve(reader, claim) {
    const {lower, upper, rough, interval, within, exact, recurrence, list, tending} = claim;
    if (recurrence) check_following(reader, recurrence, interval);
    const exponentials = tending && read_limit(reader, tending);
    if (list) check_constants(list);
    const again = !interval && !within && !tending && reader.peek() === 'reduced';
    demand(!again || lower || (exact && (rough || claim.options.exact !== undefined)),
           'a reduced mask tells the exponent of one mask, with a lower end');
    const curve = again ? read_reduced(reader, claim.curve) : claim.curve, base = BigInt(curve.arity);
    const [order_token, full_token] = reader.read('sum-rules', 1, 2), order = small(order_token, 1, 500);
    check_exponent(exact, order, power(fraction(base), order));
    check_ends(lower, upper, interval ? 0 : 1);
    const goal = {below: lower && at_most(power_below(base, minus(order, lower)), Boolean(interval))};
    const reached = upper && at_least(over(1n, power_below(base, minus(upper, order))));
    check_sum(curve);
    if (tending) check_factors(tending.curve, order, exponentials);
    const stability = reader.peek() === 'stability', full = full_token === 'full';
    demand(full_token === undefined || (full && !within && !tending), "expected 'sum-rules M', or 'sum-rules M full' of one mask");
    demand(!within || within.order === order, 'the claim is about masks with another number of sum rules');
    demand(!rough || (full && order <= rough),
           'less smoothness than that needs the full number of sum rules, and no more of them');
    if (stability || rough || exact || (!lower && !upper) || (upper && !(interval && !sign(upper)))) {
      reader.read('stability');
      check_stability(curve, order, interval, within);
    }
    const symbol = divided_symbol(curve, order);
    if (full) check_full(symbol, interval);
    const enough = upper && full && (interval ? less(order, upper) : !less(upper, order));  // 6.4
    if (upper && !enough)
      goal.above = (radius, length) => {
        demand(interval ? !less(radius, 1n) : less(1n, radius), no_exponent);
        reached(radius, length);
      };
    if (interval) return goal.below || goal.above ? check_intervals(reader, symbol, goal, claim) : undefined;
    const family = control_family(symbol, null), rounding = within && rounding_of(curve, within, family);
    const sections = prove(reader, family, goal, {first_column: true, rounding, exact});
    const with_log = exact && !tending && reader.peek() === 'logarithm';
    const P = with_log ? read_logarithm(reader, exact, curve, order, sections) : undefined;
    demand(claim.logarithm === undefined || P === claim.logarithm, 'the logarithm of the claim is not proved');
    if (again) check_convergence(reader, claim.curve);
  }
  const other_power = 'products grow with another power';
  // 4.12: the P of the line
  function read_logarithm(reader, {low, high}, curve, order, sections) {
    const [first, ...norm_fields] = reader.read('logarithm', 1, 3), P = small(first, 0, 256);
    const base = BigInt(curve.arity), [{order: pole}] = sections;
    let e = 0;  // base^e is the largest power up to HIGH
    while (!less(high, base ** BigInt(e + 1))) ++e;
    if (less(base ** BigInt(e), low)) {  // the exponent is no integer
      const highest = sections.filter(({value, level}) => !less(value, power(low, level)));
      demand(!norm_fields.length, "expected 'logarithm' and a number, as the exponent is no integer");
      demand(highest.length === 1, 'more than one block has the exact radius');
      demand(P === (pole ? pole - 1 : 0), other_power);
      return P;
    }
    demand(!less(low, high), 'the exponent may be an integer');
    const family = control_family(divided_symbol(curve, order - e), null);  // of a_s
    if (norm_fields.length) {
      demand(norm_fields.length === 2 && norm_fields[0] === 'norm' && !P, "expected 'logarithm 0 norm LEVEL'");
      const {value} = check_norm(family, small(norm_fields[1], 1, 64), true, null);
      demand(!less(1n, value), 'the norm of products is above 1');
      return P;
    }
    demand(pole && e % 2 === 0, 'the differences of this order need a norm');
    const {P: Q, r} = read_recurrence(reader, lowest_terms(family.symbol)), one = fraction(1n);
    const number = {p: [-1n, 1n], h: 1n, y: [1n, 0n], m: one, eps: fraction(0n), low: one};
    demand(P === order_of_pole(Q, r(), number) - 1, other_power);
    return P;
  }
  function check_intervals(reader, symbol, goal, {levels, interval: {low, high}}) {
    for (let from = low; less(from, high);) {
      const to = rational(reader.read('to', 1)[0]);
      demand(less(from, to) && !less(high, to), 'an interval ends outside of the rest of the range');
      demand(!levels || !less(to, high), 'a claim about sequences of values has one interval');
      const product = (lines, blocks) => read_range_product(lines, blocks, symbol.arity);
      prove(reader, control_family(symbol, {low: from, high: to}), goal, {product});
      from = to;
    }
  }
  function read_reduced(reader, curve) {  // 4.9: the mask b of OTHER, a(z) p(z) = p(z^A) b(z) up to a power of z
    const [p, b] = reader.read('reduced', 2).map(text => read_curve(text, curve.arity, null)), by = curve.arity;
    const [a_i, p_i, b_i] = [curve, p, b].map(({a}) => a.map(x => x[0]));
    demand(sum(p_i), 'the factor of the reduced mask is 0 at 1');
    const left = product_of(a_i, p_i), right = product_of(spread(p_i, by), b_i);
    demand(left.length === right.length && left.every((x, i) => x * b.q[0] === right[i] * curve.q[0]),
           'the reduced mask is not that of the mask and the factor');
    return b;
  }
  // ---- 6.5: masks that change from level to level --------------------------------------------------------------------
  const expected_order = 'an order is any, period=0,1,... or follows=0-1,1-0,...';
  function read_list(text, arity, order, inner = 0) {  // `inner`: 2 where the coefficients are matrices
    const masks = text.split(';').map(mask => read_curve(mask, arity, null, inner));
    demand(masks.length <= 64, 'more masks than the checker allows');
    const [, kind, numbers] = /^(period|follows)=(.*)$/s.exec(order) || [], number_of = token => small(token, 0, masks.length - 1);
    demand(kind || order === 'any', expected_order);
    const fields = kind ? numbers.split(',') : [];
    if (kind !== 'follows') {
      demand(arity ** fields.length <= 64, 'a longer period than the checker allows');
      return {masks, arity, period: fields.map(number_of), follows: []};
    }
    demand(fields.length <= 4096, expected_order);
    const follows = fields.map(token => {
      const pair = token.split('-');
      demand(pair.length === 2, expected_order);
      return pair.map(number_of);
    });
    return {masks, arity, period: [], follows};
  }
  // Masks of matrices in a period: each as often in the list as in the period, and each is followed by the next one
  function read_list_of_matrices(text, arity, order) {
    const list = read_list(text, arity, order, 2), {masks, period} = list;
    demand(masks.every(({components}) => components === masks[0].components), 'the matrices of two masks have different sizes');
    return period.length ? {masks: period.map(k => masks[k]), arity, period: [], follows: period.map((_, k) => [k, (k + 1) % period.length])} : list;
  }
  // All of them on the same points, the numbers of the masks in place of the powers of a parameter
  function masks_as_powers({masks, arity}) {
    const {components: r} = masks[0], end = ({first, a}) => first + BigInt(a.length / (r * r));
    const first = masks.map(mask => mask.first).reduce((x, y) => y < x ? y : x), last = masks.map(end).reduce(max);
    demand((last - first) * BigInt(r * r) <= 1000n, 'the masks of a list have more than 1000 entries together');
    const skipped = mask => Number(mask.first - first) * r * r;
    const value = (mask, i) => fraction((mask.a[i - skipped(mask)] || [0n])[0], mask.q[0]);
    const {den, numbers} = common(range_of(Number(last - first) * r * r).flatMap(i => masks.map(mask => reduced(value(mask, i)))));
    const count = masks.length, a = range_of(numbers.length / count).map(i => numbers.slice(i * count, (i + 1) * count));
    return {arity, degree: count - 1, q: masks.map(() => den), a, components: r, first};
  }
  const spread = (p, step) => range_of((p.length - 1) * step + 1).map(i => i % step ? 0n : p[i / step]);
  function masks_in_one({masks, arity}, sequence) {
    demand(arity ** sequence.length <= 64, 'a longer period than the checker allows');
    const [first, ...others] = sequence.map(k => masks[k]), points = sequence.reduce((length, k) => arity * (length - 1) + masks[k].a.length, 1);
    demand(points <= 1000, 'the masks of a period have more than 1000 coefficients together');
    return others.reduce((one, next) => ({
      arity: one.arity * arity, degree: 0, q: [one.q[0] * next.q[0]],
      a: product_of(next.a.map(x => x[0]), spread(one.a.map(x => x[0]), arity)).map(x => [x]),
    }), first);
  }
  function check_constants({masks, arity}) {
    for (const {a, q} of masks)
      demand(range_of(arity).every(r => sum(a.filter((_, i) => i % arity === r).map(x => x[0])) === q[0]),
             'a mask of the list does not keep constant data');
  }
  function list_family({masks, arity, follows}, order) {
    const symbols = masks.map(mask => divided_symbol(mask, order)), width = Math.max(...symbols.map(({size}) => size));
    const families = symbols.map(symbol => control_family({...symbol, size: width}, null));
    const den = families.reduce((all, family) => lcm(all, family.den), 1n);
    const wide = families.map(family => family.matrices.map(m => scaled(m, den / family.den)));
    return along({arity, follows}, wide, width, den);
  }
  // The matrices of the pairs, or those of all masks one after another
  function along({arity, follows}, families, width, den) {
    const one = {den, weights: [1n], symbol: null};
    if (!follows.length) return {...one, size: width, matrices: families.flat()};
    const size = (Math.max(...follows.flat()) + 1) * width;
    demand(size <= 256, 'transition matrices larger than 256');
    demand(follows.length * arity * size * size <= 2 ** 22, too_much_work);
    const inside = (node, i) => i >= node * width && i < (node + 1) * width;
    const matrices = follows.flatMap(([before, after]) => families[after].map(m => range_of(size).map(i => range_of(size).map(k =>
      inside(before, i) && inside(after, k) ? m[i - before * width][k - after * width] : 0n))));
    return {...one, size, matrices};
  }
  // T_t of a value for each new point: an end of the range for each of the points t - back that depend on it
  function each_point_family({arity, q, a}, {low, high}, order) {
    demand(q[0] && [q.slice(1), ...a.map(p => p.slice(2))].flat().every(x => !x),
           'a value for each new point needs coefficients of degree 1 in it, over a number');
    const {den, numbers: [from, wide]} = common([low, minus(high, low)]), turn = q[0] < 0n ? -1n : 1n, whole = q[0] * den * turn;
    const at_low = a.map(p => turn * (p[0] * den + (p[1] || 0n) * from)), added = a.map(p => turn * (p[1] || 0n) * wide);
    const first = at_low.map((x, i) => [x, BigInt(i)]).filter((_, i) => i % arity === 0), place = sum(first.map(([x, i]) => x * i));
    let terms = first.map(([x]) => x), right = whole;
    for (let d = 0; d < order; ++d) {  // the sums of a_i i^d are the powers of one number
      spend(first.length, (64 + bits(whole)) * (d + 1), 64 + bits(whole));
      demand(sum(terms) === right, 'the rules do not keep polynomials, or at places that depend on the parameter');
      terms = terms.map((x, k) => x * first[k][1] * whole);
      right *= place;
    }
    const family = control_family(divided_symbol({arity, degree: 0, q: [whole], a: at_low.map(x => [x])}, order), null);
    let e = added, differences = [1n];
    for (let round = 0; round < order; ++round) {  // divided by 1 - z^A
      e = [...e];
      for (let i = arity; i < e.length; ++i) e[i] += e[i - arity];
      demand(e.slice(-arity).every(x => !x), 'the rules do not keep polynomials for all values');
      [e, differences] = [e.slice(0, -arity), product_of(differences, [1n, -1n])];
    }
    e = e.map(x => x * BigInt(arity) ** BigInt(order));
    const {size} = family, matrices = [];
    family.matrices.forEach((m, t) => {
      const free = range_of(size + order).filter(back => e.some((x, i) => x && (i + back - t + arity) % arity === 0));
      demand(matrices.length + 2 ** free.length <= 1024, 'more choices of ends than the checker allows');
      demand((matrices.length + 2 ** free.length) * size * size <= 2 ** 22, too_much_work);
      for (let choice = 0; choice < 2 ** free.length; ++choice) {
        const matrix = scaled(m, whole / family.den);
        free.filter((_, f) => choice >> f & 1).forEach(back => differences.forEach((by, j) => {
          const k = back - j;
          spend(size);
          if (k >= 0 && k < size) range_of(size).forEach(i => { matrix[i][k] += by * (e[arity * i + t - back] || 0n); });
        }));
        matrices.push(matrix);
      }
    });
    return {size, den: whole, weights: [1n], symbol: null, matrices};
  }
  function check_choices(reader, {list, curve, interval, lower, upper, exact}) {
    if (list) check_constants(list);
    demand(!exact, 'an exact number is that of one mask or family');
    const [order_token, transposed] = reader.read('sum-rules', 1, list ? 1 : 2), order = small(order_token, 1, 500);
    demand(transposed === undefined || transposed === 'transposed', "expected 'transposed' or nothing");
    check_ends(lower, upper, 1);
    const by_sequence = Boolean(upper) || (list && reader.peek() === 'stability');
    if (by_sequence) reader.read('stability');
    const family = list ? list_family(list, order) : each_point_family(curve, interval, order), {arity} = list || curve;
    if (transposed) family.matrices = family.matrices.map(m => m.map((row, k) => row.map((_, j) => m.at(-1 - j).at(-1 - k))));
    const goal = {below: at_most(power_below(BigInt(arity), minus(order, lower)), false)};
    const reached = upper && at_least(over(1n, power_below(BigInt(arity), minus(upper, order))));
    if (by_sequence)
      goal.above = (radius, length, letters) => {
        check_sequence(list, letters, order);
        if (!upper) return;
        demand(less(1n, radius), no_exponent);
        reached(radius, length);
      };
    prove(reader, family, goal);
  }
  // Stable shifts of the limits of the sequence with the masks of a product again and again
  function check_sequence(list, letters, order) {
    const {arity, follows} = list, masks = letters.map(T => follows.length ? follows[Math.floor(T / arity)][1] : Math.floor(T / arity));
    const period = range_of(masks.length).map(i => i + 1).find(n => masks.length % n === 0 && masks.every((k, i) => k === masks[i % n]));
    check_stability(masks_in_one(list, masks.slice(0, period)), order, null, null);
  }
  // w -> STEP or the root of it: the numerator and the denominator, and the first values
  function read_following(step, start, from, letter) {
    const root = step.startsWith('sqrt'), {a, q} = read_curve(step.slice(root ? 4 : 0), 2, letter);
    demand(a.length === 1, 'a recurrence is [P]/D, [P]/(Q) or sqrt[P]/(Q)');
    const ends = start.split('..'), form = 'the first values are LOW..HIGH or LOW..inf';
    demand(ends.length === 2, form);
    const low = rational(ends[0]), unbounded = ends[1] === 'inf', high = unbounded ? null : rational(ends[1]);
    demand(unbounded || !less(high, low), form);
    demand(unbounded === (from === 'some'), "a start has a level if it is bounded, else 'some'");
    return {root, numerator: a[0], denominator: q, low, high, from: unbounded ? null : small(from, 0, 1000)};
  }
  // What is shown of a recurrence on intervals
  function steps_of({root, numerator, denominator}) {
    const end = p => p.findLastIndex(x => x), squared = x => root ? times(x, x) : x;
    const show = (form, what) => {  // where it may be 0 at the ends
      const last = end(form);
      if (last >= 0) show_positive(form.slice(form.findIndex(x => x), last + 1), what);
    };
    const polynomial_on = (p, interval) => {
      spend(p.length ** 2, 1000);
      return form_of(p, interval, p.length - 1);
    };
    const sign_of = interval => {
      const q = polynomial_on(denominator, interval), inner = interval.high ? q : q.slice(0, Math.max(1, end(q) + 1));
      const turn = inner[0] < 0n ? -1n : 1n;
      show_positive(inner.map(x => x * turn), 'the denominator of the recurrence');
      return turn;
    };
    // sign (bound * denominator - numerator), the bound a polynomial
    const compare = (interval, turn, bound, side, which) => {
      const {den, numbers} = common(bound), p = Array(numerator.length + bound.length - 1).fill(0n);
      numerator.forEach((x, k) => {
        p[k] -= side * turn * x * den;
        numbers.forEach((c, j) => { p[k + j] += side * turn * denominator[k] * c; });
      });
      show(polynomial_on(p, interval), `what keeps the recurrence from being ${which} the next values`);
    };
    const at_least_low = (interval, turn, least) =>
      compare(interval, turn, [root && sign(least) <= 0 ? fraction(0n) : squared(least)], -1n, 'below');
    const leads = (interval, to) => {
      const turn = sign_of(interval);
      at_least_low(interval, turn, to.low);
      demand(!root || sign(to.high) >= 0, 'a root may be above the values of the next level');
      compare(interval, turn, [squared(to.high)], 1n, 'above');
    };
    const descends = range => {  // what is above comes down
      demand(sign(range.high) > 0, 'an unbounded start needs a range with a positive upper end');
      const beyond = {low: range.high}, turn = sign_of(beyond), zero = fraction(0n);
      at_least_low(beyond, turn, range.low);
      compare(beyond, turn, root ? [zero, zero, fraction(81n, 100n)] : [zero, fraction(9n, 10n)], 1n, 'above nine tenths of');
    };
    const tends = (interval, limit) => {
      leads(interval, interval);
      demand(!less(limit, interval.low) && !less(interval.high, limit), 'the limit is not among the values that come near to it');
      const p = numerator, q = denominator, image = times(horner(q, limit), squared(limit)), at = horner(p, limit);
      demand(!(root && sign(limit) < 0) && at.n * image.d === image.n * at.d, 'the recurrence moves the limit');
      const slope = [product_of(derivative_of(p), q), product_of(p, derivative_of(q))].reduce(difference_of), square = product_of(q, q);
      const most = root ? product_of(product_of(p, q).map(x => 4n * x), square) : square;  // the steepness is below 1
      for (const other of root ? [product_of(slope, slope)] : [slope, slope.map(x => -x)])
        show_positive(polynomial_on(difference_of(most, other), interval), '1 less the steepness of the recurrence');
    };
    const halves = root && difference_of(numerator.map(x => 2n * x), product_of(denominator, [1n, 1n])).every(x => !x);
    return {leads, descends, tends, halves};
  }
  const difference_of = (p, q) => range_of(Math.max(p.length, q.length)).map(k => (p[k] || 0n) - (q[k] || 0n));
  const derivative_of = p => p.length > 1 ? p.slice(1).map((x, k) => x * BigInt(k + 1)) : [0n];
  function check_following(reader, {low, high, from, ...recurrence}, range) {
    const {leads, descends} = steps_of(recurrence);
    leads(range, range);
    let values = {low, high};
    if (!high) {
      demand(!less(range.high, low), 'an unbounded start begins above the range');
      values = {low, high: range.high};
      descends(range);
    }
    let level = 0;
    for (; reader.peek() === 'level'; ++level) values = read_step(reader, 'level', level, values, leads);
    demand(from === null || level <= from, 'the values come into the range at a later level');
    demand(!less(values.low, range.low) && !less(range.high, values.high), 'the values do not come into the range');
  }
  function read_step(reader, word, level, values, leads) {
    demand(level < 1000, 'more levels than the checker allows');
    const [low, high] = reader.read(word, 2).map(rational);
    demand(!less(high, low), 'the values of a level are an interval');
    leads(values, {low, high});
    return {low, high};
  }
  // 6.10: masks that tend to the one of the claim; the numbers of the line `exponentials`
  function read_limit(reader, {curve, range, recurrence, limit}) {
    check_following(reader, recurrence, range);
    const {leads, tends, halves} = steps_of(recurrence);
    show_one_sign(form_of(curve.q, range, curve.degree), 'the denominator of the masks');
    let values = range;
    for (let level = 0; reader.peek() === 'towards'; ++level) values = read_step(reader, 'towards', level, values, leads);
    tends(values, limit);
    if (reader.peek() !== 'exponentials') return [];
    demand(curve.arity === 2 && halves, 'exponentials need arity 2 and w -> sqrt((1+w)/2)');
    return reader.read('exponentials', 1, 8).map(token => small(token, 0, 500));
  }
  const no_factor = 'the masks have no such exponential factor';
  function divided_by_exponential({a, degree, ...curve}, chebyshev) {  // by 1 + 2 T z + z^2, T of the degree j
    const j = chebyshev.length - 1, quotient = [];
    a.forEach((p, i) => {
      const [one, two] = [quotient[i - 1] || [0n], quotient[i - 2] || [0n]];
      spend(degree * j + 1, 1000);
      const next = [product_of(one, chebyshev.map(x => 2n * x)), two].reduce(difference_of, p);
      demand(next.slice(Math.max(0, degree + 1 - j)).every(x => !x), no_factor);
      quotient.push(range_of(degree + 1).map(k => next[k] || 0n));
    });
    demand(quotient.slice(-2).flat().every(x => !x), no_factor);
    return {...curve, degree, a: quotient.slice(0, -2)};
  }
  function check_factors(curve, order, exponentials) {
    check_sum(curve);
    const p = order - 2 * exponentials.reduce((total, x) => total + x, 0);
    demand(p > 0, 'a sum rule is needed beside the exponentials');
    let rest = curve, [before, chebyshev] = [[1n], [0n, 1n]];
    for (const power of exponentials) {
      rest = range_of(power).reduce(one => divided_by_exponential(one, chebyshev), rest);
      [before, chebyshev] = [chebyshev, difference_of(product_of([0n, 2n], chebyshev), before)];
    }
    divided_symbol(rest, p);
  }
  function curve_at({arity, q, a}, w) {  // without zeros at its ends
    const below = horner(q, w), zero = fraction(0n);
    demand(sign(below), 'there is no mask in the limit');
    const {den, numbers} = common([zero, ...a.map(p => reduced(over(horner(p, w), below)))]), all = numbers.slice(1);
    const first = all.findIndex(x => x);
    demand(first >= 0, 'the mask in the limit is 0');
    return {arity, degree: 0, q: [den], a: all.slice(first, all.findLastIndex(x => x) + 1).map(x => [x])};
  }
  function check_convergence(reader, curve) {  // 4.9: JSR < A^M for the mask of the claim; a(1) = b(1) = A
    const order = small(reader.read('sum-rules', 1)[0], 1, 500), limit = fraction(BigInt(curve.arity) ** BigInt(order));
    const family = control_family(divided_symbol(curve, order), null);
    prove(reader, family, {below: at_most(limit, true)}, {first_column: true});
  }

  // ---- Section 5: several variables ---------------------------------------------------------------------------------
  // Points are arrays of small integers; a sequence is a Map of the text of a point to [point, value], without zeros. Of
  // sequences of vectors (5.9) the component is one more coordinate, of masks of matrices the row and the column are two.
  const point_bits = 4096;  // of memory, for a point and its value
  const minor = (m, i, j) => m.filter((_, r) => r !== i).map(row => row.filter((_, c) => c !== j));
  const small_determinant = m =>
    m.length ? m[0].reduce((total, x, j) => total + (j % 2 ? -x : x) * small_determinant(minor(m, 0, j)), 0) : 1;
  const adjugate = m =>
    m.map((row, i) => row.map((_, j) => ((i + j) % 2 ? -1 : 1) * small_determinant(minor(m, j, i))));
  const times_point = (m, p) => m.map(row => row.reduce((total, x, k) => total + x * p[k], 0));
  const times_small = (x, y) => transpose(transpose(y).map(column => times_point(x, column)));
  const add_points = (p, q, by = 1) => p.map((x, v) => x + by * q[v]);
  const sum_of = numbers => numbers.reduce((x, y) => x + y, 0);
  function add(sequence, point, value) {
    spend(16);
    const key = String(point), entry = sequence.get(key), total = entry ? entry[1] + value : value;
    if (total) sequence.set(key, [point, total]);
    else sequence.delete(key);
    allow_bits(sequence.size * point_bits);
  }
  const values_of = sequence => [...sequence.values()].map(entry => entry[1]);
  const is_multiple = (x, y, factor) =>  // x = factor y
    x.size === y.size && [...x].every(([key, [, value]]) => y.has(key) && value === factor * y.get(key)[1]);
  const first_key = sequence => sequence.keys().next().value;
  function coordinate(value) {
    demand(abs(value) <= 10n ** 9n, 'a coordinate is too large');
    return Number(value);
  }
  function read_point(text, dimension) {
    const parts = text.split(',');
    demand(parts.length === dimension, 'a point with another number of coordinates');
    return parts.map(integer).map(coordinate);
  }
  function read_place(text, dimension, components) {
    if (!components) return read_point(text, dimension);
    const parts = text.split('.');
    demand(parts.length === 2, 'a point of a sequence of vectors is POINT.COMPONENT');
    return [...read_point(parts[0], dimension), small(parts[1], 0, components - 1)];
  }
  function read_sequence(fields, dimension, components) {
    const result = new Map();
    for (const field of fields) {
      const [point, token, more] = field.split(':');
      demand(token !== undefined && more === undefined, 'a term is POINT:INTEGER');
      const p = read_place(point, dimension, components), value = integer(token);
      demand(value, 'a coefficient is 0');
      demand(!result.has(String(p)), 'a point occurs twice');
      add(result, p, value);
    }
    return result;
  }
  function read_surface(text, of_matrices, number = rational) {
    const inner = of_matrices ? 2 : 0, {depth, sizes, coefficients, den: by, first} = mask_parts(text, inner);
    const divisor = by === undefined ? 1n : integer(by), dimension = depth - inner, components = of_matrices ? sizes[0] : 0;
    demand(coefficients.length <= 10000, 'a mask with too many coefficients');
    demand(!of_matrices || sizes[1] === components, 'a coefficient of a mask is no square matrix');
    demand(!first || first.length === dimension, mask_form);
    demand(divisor > 0n, 'a denominator must be positive');
    const {den, numbers} = common(coefficients.map(c => reduced(over(number(c), divisor))));
    return {dimension, sizes: sizes.slice(inner), components, den, numbers, divisor, first: first || Array(dimension).fill(0n)};
  }
  // 5.13: matrices P + sqrt(R) Q as [P, R Q; Q, P]
  const root_form = 'square roots in a mask are sqrt(R) with one number R, 2 <= R <= 10^9, no square';
  function read_root_in(text) {
    const [, token] = /sqrt\(([^()]*)\)/.exec(text) || [];
    demand(token !== undefined, root_form);
    const of_root = integer(token);
    demand(of_root >= 2n && of_root <= 10n ** 9n && root(of_root) ** 2n !== of_root, root_form);
    return of_root;
  }
  function number_over_field(of_root) {  // p and q of a sum of terms
    const name = `sqrt(${of_root})`;
    return c => {
      const value = [fraction(0n), fraction(0n)];
      for (const [, signs, term] of c.replace(/^-?/, s => s || '+').matchAll(/([+-])([^+-]*)/g)) {
        const at = term.endsWith(name) ? 1 : 0, factor = at ? term.slice(0, -name.length) : term;
        demand(!at || !factor || factor.endsWith('*'), root_form);
        const x = at ? (factor ? rational(factor.slice(0, -1)) : 1n) : rational(factor);
        value[at] = reduced((signs === '-' ? minus : plus)(value[at], x));
      }
      return value;
    };
  }
  function read_over_field(text, of_root) {
    const pairs = [], parts = number_over_field(of_root), one = c => {
      pairs.push(parts(c));
      return 0n;
    };
    const surface = read_surface(text, true, one), r = surface.components, half = pairs.length;
    demand(half <= 2500, 'a mask with too many coefficients');
    const {den, numbers} = common(pairs.flat().map(x => reduced(over(x, surface.divisor))));
    const entry = (m, i, k) => {
      const at = 2 * ((m * r + i % r) * r + k % r);
      return i < r === k < r ? numbers[at] : numbers[at + 1] * (i < r ? of_root : 1n);
    };
    const two_r = range_of(2 * r), all = range_of(half / (r * r)).flatMap(m => two_r.flatMap(i => two_r.map(k => entry(m, i, k))));
    return {...surface, components: 2 * r, den, numbers: all, root: of_root};
  }
  function read_field_curve(text, arity) {
    const {sizes, den, numbers, components, first, root: of_root} = read_over_field(text, read_root_in(text));
    demand(sizes.length === 1 && numbers.length <= 4000, 'a mask has 1 to 1000 coefficients, the first and the last not zero');
    return {arity, degree: 0, q: [den], a: numbers.map(x => [x]), components, first: first[0], root: of_root};
  }
  function mask_sequence({sizes, components, numbers, first}) {
    const result = new Map(), entries = components ** 2 || 1;
    numbers.forEach((value, i) => {
      const entry = i % entries, column = entry % components;
      let rest = (i - entry) / entries;
      add(result, [...sizes.map((size, v) => {
        const x = rest % size;
        rest = (rest - x) / size;
        return x + coordinate(first[v]);
      }), ...(components ? [(entry - column) / components, column] : [])], value);
    });
    return result;
  }
  function read_dilation(text) {
    const [, rows] = /^\[(.*)\]$/.exec(text) || [];
    demand(rows !== undefined && rows.split(';').length <= 3, 'a dilation is [1,2;-2,-1]');
    const matrix = rows.split(';').map((row, _, all) => read_point(row, all.length));
    demand(matrix.every(row => row.every(x => Math.abs(x) <= 64)), 'an entry of a dilation is too large');
    return matrix;
  }
  function check_isotropic(M) {  // 5.1, Lemma 7
    const s = M.length, d = small_determinant(M), t = sum_of(M.map((row, i) => row[i])), square = times_small(M, M);
    const c = s < 3 ? 0 : sum_of(M.map((_, i) => small_determinant(minor(M, i, i))));
    const square_is = (factor, of) => square.every((row, i) => row.every((x, j) => factor * x === (i === j ? of : 0)));
    const isotropic = s === 1 || (s === 2 && (t * t < 4 * d || square_is(1, Math.abs(d)))) ||
      (s === 3 && c ** 3 === d * t ** 3 &&
       (t === 0 || Math.abs(t * t - c) < 2 * Math.abs(c) || square_is(t * t, c * c)));
    demand(isotropic && Math.abs(d) > 1, 'the dilation is not isotropic and expanding');
  }
  function check_turned(N, M, mask) {  // 5.7
    demand(N.length === M.length, 'the turned dilation has another number of variables');
    check_isotropic(N);
    const inverse = adjugate(M), d = small_determinant(M), wrong = 'the dilation is not turned by symmetries';
    const over_M = m => times_small(m, inverse).map(row => row.map(x => x / d)), first = over_M(N);
    demand(first.flat().every(Number.isInteger), 'the turned dilation is no integer multiple of the dilation');
    demand(Math.abs(small_determinant(first)) === 1, wrong);
    for (let g = first, steps = 0; steps === 0 || String(g) !== String(first); ++steps) {
      spend(40 * mask.size);
      demand(g.flat().every(x => Number.isInteger(x) && Math.abs(x) <= 2 ** 20) && is_symmetry(g, mask), wrong);
      g = over_M(times_small(M, g));
    }
  }
  function is_symmetry(g, mask) {  // up to a shift
    const entries = [...mask.values()], origin = entries[0][0];
    const points = entries.map(([p]) => add_points(p, origin, -1));
    const images = points.map(p => times_point(g, p)), total = list => list.reduce((x, y) => add_points(x, y));
    const move = add_points(total(points), total(images), -1).map(x => x / entries.length);
    return move.every(Number.isInteger) && entries.every(([, value], i) => {
      const image = mask.get(String(add_points(add_points(images[i], move), origin)));
      return image !== undefined && image[1] === value;
    });
  }
  class Transition {  // the operators T_t, times the denominator of the mask
    constructor(mask, M, digits) {
      [this.mask, this.M, this.digits, this.det, this.adjugate] = [mask, M, digits, small_determinant(M), adjugate(M)];
      [this.classes, this.size] = [new Map(), bits(largest(values_of(mask)))];
      for (const entry of mask.values()) {
        const key = this.key_of(entry[0], entry[0].slice(M.length + 1));
        if (!this.classes.has(key)) this.classes.set(key, []);
        this.classes.get(key).push(entry);
      }
    }
    key_of(point, column) { return `${this.class_of(point)}.${column}`; }  // of coefficients: their class, and a column
    class_of(point) {
      const D = Math.abs(this.det);
      return String(times_point(this.adjugate, point).map(x => (x % D + D) % D));
    }
    divide(point) { return times_point(this.adjugate, point).map(x => x / this.det || 0); }  // M^(-1) point
    images(v) { return this.digits.map(t => this.apply(t, v)); }
    apply(t, v) {
      const result = new Map(), n = t.length;
      for (const [k, value] of v.values()) {
        const from = this.classes.get(this.key_of(add_points(t, k, -1), k.slice(n))) || [];
        spend(4 * from.length + 4, this.size, bits(value));
        for (const [i, c] of from)
          add(result, [...this.divide(add_points(add_points(t, i, -1), k, -1).map(x => -x)), ...i.slice(n, -1)], c * value);
      }
      return result;
    }
  }
  const exponents = (dimension, order, exact) =>  // the nu with |nu| < order, or with |nu| = order
    dimension === 0 ? (!exact || order === 0 ? [[]] : []) : range_of(order + (exact ? 1 : 0)).flatMap(k =>
      exponents(dimension - 1, order - k, exact).map(nu => [k, ...nu]));
  function moment(entries, nu) {
    spend(entries.length * nu.length, 32 * (sum_of(nu) + 1));
    return sum(entries.map(([p, value]) => p.reduce((product, x, v) => product * BigInt(x) ** BigInt(nu[v]), value)));
  }
  function check_sum_rules(transition, order, den) {
    const classes = [...transition.classes.values()], dimension = transition.M.length;
    const ones = classes.every(entries => moment(entries, Array(dimension).fill(0)) === den);
    demand(ones && classes.length === Math.abs(transition.det), 'a class of coefficients does not sum to 1');
    for (const nu of exponents(dimension, order, false)) {
      const first = moment(classes[0], nu);
      demand(classes.every(entries => moment(entries, nu) === first), 'the mask has no sum rules of this order');
    }
  }
  function eliminate(x, factor, y, by, prime) {  // factor x - by y, divided by its content, or modulo a prime
    spend(x.size + y.size, 256, bits(factor) + bits(by));
    const result = new Map(), rest = value => prime ? (value % prime + prime) % prime : value;
    const put = (key, p, value) => value ? result.set(key, [p, value]) : result.delete(key);
    for (const [key, [p, value]] of x) put(key, p, rest(factor * value));
    for (const [key, [p, value]] of y) put(key, p, rest((result.has(key) ? result.get(key)[1] : 0n) - by * value));
    let content = prime ? 1n : 0n;
    for (const [, value] of result.values()) if ((content = content === 1n ? 1n : gcd(content, value)) === 1n) break;
    if (content > 1n) for (const entry of result.values()) entry[1] /= content;
    return result;
  }
  // Sequences modulo a space, over the rationals or modulo a prime: each row has a key that no later row has
  class Span {
    constructor(rows, prime) { [this.rows, this.prime] = [rows.slice(), prime]; }
    extend(sequence) {  // the part outside of the span, or undefined
      spend(this.rows.length);
      let x = eliminate(sequence, 1n, new Map(), 0n, this.prime);
      for (const {key, row} of this.rows)
        if (x.has(key)) x = eliminate(x, row.get(key)[1], row, x.get(key)[1], this.prime);
      if (!x.size) return undefined;
      this.rows.push({key: first_key(x), row: x});
      allow_bits(this.rows.length * x.size * point_bits);
      return x;
    }
  }
  // (iii): bases, modulo the space of `rows`, of the span of the T_w x with x in `start` and words w of at least i
  // letters, i = 0, 1, ..., until it is 0 or stays the same, or for a number of steps
  function long_words(start, rows, transition, steps = Infinity, prime = 0n) {
    const images = x => transition.images(x), all = new Span(rows, prime);
    let last = [];
    for (let queue = start; queue.length;) {
      const found = queue.map(x => all.extend(x)).filter(x => x);
      [last, queue] = [[...last, ...found], found.flatMap(images)];
    }
    for (let i = 0; last.length && i < steps; ++i) {
      const span = new Span(rows, prime), next = last.flatMap(x => images(x).map(y => span.extend(y)).filter(y => y));
      demand(steps < Infinity || next.length < last.length, 'differences are not led into the space');
      last = next;
      if (!last.length) return {steps: i + 1, basis: last};
    }
    return {steps: last.length ? steps : 0, basis: last};
  }
  function differences(sequence, order, dimension) {  // nabla^mu of the sequence, |mu| = order
    const step = (x, v) => {
      const result = new Map(x);
      spend(2 * x.size);
      for (const [p, value] of x.values()) add(result, p.map((c, i) => i === v ? c + 1 : c), -value);
      return result;
    };
    let memory = 0;
    return exponents(dimension, order, true).map(mu => {
      const result = mu.reduce((x, many, v) => range_of(many).reduce(y => step(y, v), x), sequence);
      allow_bits(memory += result.size * point_bits);
      return result;
    });
  }
  function read_space(reader, dimension, components, of_root) {
    const count = small(reader.read('space', 1)[0], 1, of_root ? 128 : 256), vectors = [], holders = new Map();
    let memory = 0;
    for (let n = 0; n < count; ++n) {
      const v = read_sequence(reader.read('vector', 1, 2 ** 24), dimension, components), pivot = v.values().next().value[1];
      demand(pivot > 0n, 'the first coefficient of a vector must be positive');
      demand(!n || vectors[0].values().next().value[1] === pivot, 'the first coefficients of two vectors differ');
      allow_bits(memory += v.size * point_bits);
      vectors.push(v);
    }
    if (of_root) {
      const rational_part = ([p]) => p[dimension] < components / 2;
      demand(vectors.every(v => rational_part(v.values().next().value)), 'the first point of a vector is of a multiple of the root');
      vectors.push(...vectors.map(v => times_root(v, of_root, components)));
    }
    for (const v of vectors) for (const key of v.keys()) holders.set(key, (holders.get(key) || 0) + 1);
    demand(vectors.every(v => holders.get(first_key(v)) === 1), 'the first point of a vector occurs in another');
    return vectors;
  }
  function times_root(x, of_root, components) {  // 5.13: (p, q) -> (R q, p); the first point stays first
    const result = new Map(), half = components / 2;
    for (const [p, value] of x.values()) {
      const c = p[p.length - 1], first = c < half;
      add(result, [...p.slice(0, -1), first ? c + half : c - half], first ? value : value * of_root);
    }
    return result;
  }
  // (ii): the matrices of the T_t in the basis; the images of `count` vectors
  function space_family(vectors, transition, den, count = vectors.length) {
    const keys = vectors.map(first_key), pivot = vectors[0].get(keys[0])[1];
    const columns = transition.digits.map(t => vectors.slice(0, count).map(v => {
      const image = transition.apply(t, v), at = keys.map(key => image.has(key) ? image.get(key)[1] : 0n);
      const rest = new Map();
      for (const [p, value] of image.values()) add(rest, p, pivot * value);
      at.forEach((value, k) => {
        if (!value) return;
        spend(vectors[k].size * 4, bits(value));
        for (const [p, x] of vectors[k].values()) add(rest, p, -value * x);
      });
      demand(!rest.size, 'a transition operator leads out of the space');
      return at;
    }));
    return {size: vectors.length, den: pivot * den, matrices: columns.map(transpose), vectors};
  }
  // 5.5: the g_k, each for k and -k, are a fixed point of the transfer operator, and the sum over them is positive
  function check_gram(reader, transition, den) {
    const {mask, M, det} = transition, half_g = read_sequence(reader.read('gram', 1, 2 ** 24), M.length);
    const g = new Map(half_g);
    for (const [p, value] of half_g.values()) {
      const mirror = p.map(x => -x || 0);
      demand(p.every(x => !x) || !half_g.has(String(mirror)), 'a point occurs twice');
      if (p.some(x => x)) add(g, mirror, value);
    }
    demand(sum(values_of(g)) > 0n, 'the numbers of the gram line have no positive sum');
    const correlation = new Map(), image = new Map(), entries = [...mask.values()];
    spend(4 * entries.length ** 2, bits(largest(values_of(mask))));
    for (const [i, x] of entries) for (const [j, y] of entries) add(correlation, add_points(i, j, -1), x * y);
    for (const [l, value] of g.values()) {
      spend(8 * correlation.size, bits(value));
      for (const [x, c] of correlation.values()) {
        const k = transition.divide(add_points(x, l));
        if (k.every(Number.isInteger)) add(image, k, c * value);
      }
    }
    demand(is_multiple(image, g, BigInt(Math.abs(det)) * den * den),
           'the gram line is not a fixed point of the transfer operator');
    check_torus([...half_g.values()], M.length);
  }
  const complex_times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
  function check_torus(terms, dimension) {  // the positivity of G on the charts of 5.5
    const degrees = range_of(dimension).map(v => 2 * Math.max(...terms.map(([k]) => Math.abs(k[v]))));
    const size = degrees.reduce((x, d) => x * (d + 1), 1), known = new Map();
    demand(size <= 2 ** 20, too_much_work);
    const linear = [[[1n, -1n], [1n, 1n]], [[1n, 1n], [1n, -1n]]];  // 1 + i t = (1 - i)(1 - u) + (1 + i) u, and 1 - i t
    const convolve = (f, [low, high]) => range_of(f.length + 1).map(j => {
      const [x, y] = [complex_times(f[j] || [0n, 0n], low), complex_times(f[j - 1] || [0n, 0n], high)];
      return [x[0] + y[0], x[1] + y[1]];
    });
    const line = (v, k) => {  // (1 + i t)^(n + k) (1 - i t)^(n - k)
      const key = `${v} ${k}`, more = degrees[v] / 2 + k;
      spend(known.has(key) ? 0 : 4 * degrees[v] ** 2, degrees[v]);
      if (!known.has(key))
        known.set(key, range_of(degrees[v]).reduce((f, j) => convolve(f, linear[j < more ? 0 : 1]), [[1n, 0n]]));
      return known.get(key);
    };
    for (let chart = 0; chart < 2 ** dimension; ++chart) {
      const form = Array(size).fill(0n);
      for (const [k, value] of terms) {
        spend(4 * size, 2 * sum_of(degrees), 2 * sum_of(degrees));
        const both = k.some(x => x) ? 2n * value : value;  // k and -k
        const turned = k.reduce((total, x, v) => chart >> v & 1 && x % 2 ? -total : total, both);
        const tensor = k.reduce((all, x, v) => line(v, x).flatMap(c => all.map(a => complex_times(a, c))), [[1n, 0n]]);
        tensor.forEach(([re], j) => { form[j] += turned * re; });
      }
      show_positive(form, 'stability: the sum over the gram line', degrees);
    }
  }
  const order_in_space = token => {
    const order = small(token, 1, 500);
    demand(order <= 64, 'a higher order than the checker allows in several variables');
    return order;
  };
  // 5.2, 5.3: the space of the differences of the scheme; its vectors annihilate polynomials of degree < order
  function read_differences(reader, transition, order, den) {
    const dimension = transition.M.length, delta = new Map();
    check_sum_rules(transition, order, den);
    add(delta, Array(dimension).fill(0), 1n);
    const vectors = read_space(reader, dimension);
    for (const nu of exponents(dimension, order, false))
      demand(vectors.every(v => !moment([...v.values()], nu)),
             'a vector does not annihilate the polynomials of degree below the order of the sum rules');
    const family = space_family(vectors, transition, den);
    lead_into(vectors, differences(delta, order, dimension), transition);
    return family;
  }
  const lead_into = (vectors, start, transition) =>  // (iii): the number of letters that words need
    long_words(start, vectors.map(row => ({key: first_key(row), row})), transition).steps;
  // 5.6: the space of the differences of phi; 5.9 where phi has components
  function read_values(reader, transition, order, den, spanned, components, integral) {
    const dimension = transition.M.length;
    if (!components) check_sum_rules(transition, 1, den);
    const values = read_sequence(reader.read('values', 1, 2 ** 24), dimension, components);
    demand(components || sum(values_of(values)), 'the numbers of the values line have the sum 0');
    demand(is_multiple(transition.apply(transition.digits[0], values), values, den),
           'the values line is not fixed by the operator of the first digit');
    const functionals = integral ? read_functionals(reader, transition, den, components, values, integral) : [];
    if (components) check_unique(transition, den, components, functionals);
    const vectors = read_space(reader, dimension, components), family = space_family(vectors, transition, den);
    const start = differences(values, order, dimension), steps = lead_into(vectors, start, transition);
    const rank = () => long_words(start, [], transition, steps, 2n ** 32n - 5n).basis.length;
    demand(!spanned || rank() === vectors.length, 'the differences do not span the space');
    return family;
  }
  // 5.13: the same of matrices with a square root, in a basis over the field; matrices on halves are [X, R Y; Y, X]
  function read_values_over_field(reader, transition, order, den, spanned, components, of_root, integral) {
    const dimension = transition.M.length, values = read_sequence(reader.read('values', 1, 2 ** 24), dimension, components);
    demand(is_multiple(transition.apply(transition.digits[0], values), values, den),
           'the values line is not fixed by the operator of the first digit');
    const functionals = integral ? read_functionals(reader, transition, den, components, values, integral, of_root) : [];
    check_unique(transition, den, components, functionals, 2);
    const vectors = read_space(reader, dimension, components, of_root), size = vectors.length / 2;
    const {den: by, matrices} = space_family(vectors, transition, den, size);
    const both = [values, times_root(values, of_root, components)];
    const start = both.flatMap(x => differences(x, order, dimension)), steps = lead_into(vectors, start, transition);
    const rank = () => long_words(start, [], transition, steps, 2n ** 32n - 5n).basis.length;
    demand(!spanned || rank() === vectors.length, 'the differences do not span the space');
    const halves = matrices.map(m => on_halves(m.slice(0, size), m.slice(size), of_root));
    return {...near_family({root: of_root, size, den: by, halves}), vectors};
  }
  const on_halves = (x, y, of_root) => [...x.map((row, i) => [...row, ...y[i].map(value => value * of_root)]),
                                        ...x.map((row, i) => [...y[i], ...row])];
  const quarters = (m, n) => [m.slice(0, n).map(row => row.slice(0, n)), m.slice(n).map(row => row.slice(0, n))];  // X, Y
  // Rational matrices near, with 2^-512 floor(2^512 sqrt(R)) in place of the root, and what is known of their errors
  function near_family({root: of_root, size, den, halves}) {
    const parts = halves.map(m => quarters(m, size)), farthest = largest_by(parts, ([, y]) => largest_of(y));
    if (!farthest) return {size, den, matrices: parts.map(([x]) => x), field: {root: of_root, size, den, halves}, rounding: null};
    const near = scaled_root(of_root), matrices = parts.map(([x, y]) => x.map((row, i) => row.map((value, k) => (value << 512n) + y[i][k] * near)));
    const family = {size, den: den << 512n, matrices}, e = fraction(farthest * BigInt(size), family.den);
    const field = {root: of_root, size, den, halves};
    return {...family, field, rounding: {e, nu: norm_of_family(family), field}};
  }
  const scaled_root = of_root => root(of_root << 1024n);
  function read_field_blocks(reader, {field: {root: of_root, size, den, halves}}, part) {  // 4.4
    const {sizes, hidden} = read_block_sizes(reader, size, part);
    const matrix = words => {
      const {den: by, numbers} = common(reader.rows(words, size, 2 * size, rational).flat());
      const rows = range_of(size).map(i => numbers.slice(2 * i * size, 2 * (i + 1) * size));
      return {by, rows: on_halves(rows.map(row => row.slice(0, size)), rows.map(row => row.slice(size)), of_root)};
    };
    const basis = matrix('basis');
    if (part) check_unobservable(part, basis.rows);
    const inverse = matrix('inverse'), by = basis.by * inverse.by;
    demand(equal(multiply(basis.rows, inverse.rows), scaled(identity(2 * size), by)), 'basis times inverse is not the unit matrix');
    const all = halves.map(m => quarters(multiply(multiply(inverse.rows, m), basis.rows), size));
    return sizes.map((n, i) => {
      const first = sum_of(sizes.slice(0, i)), inside = row => row.slice(first, first + n);
      demand(all.flat().every(m => m.slice(first + n).every(row => inside(row).every(x => !x))), 'not block upper triangular');
      const parts = all.map(pair => pair.map(m => m.slice(first, first + n).map(inside)));
      const factor = common_factor(den * by, parts.flat(3));
      const own = parts.map(pair => pair.map(m => m.map(row => row.map(x => x / factor))));
      const near = near_family({root: of_root, size: n, den: den * by / factor, halves: own.map(([x, y]) => on_halves(x, y, of_root))});
      return {...near, hidden: i < hidden};
    });
  }
  // 5.9: no coordinate of a point j is larger in modulus if a solution of compact support does not vanish at x' + j
  function reach({mask, M, adjugate: of_inverse, det, digits}, components) {
    const farthest = Math.max(...[...mask.values()].flatMap(([k]) => add_points(digits[0], k, -1).map(Math.abs)));
    const inverse = of_inverse.map(row => row.map(BigInt)), D = abs(BigInt(det));
    let power_of = identity(M.length), scale = 1n, size = fraction(1n), total = fraction(0n);
    while (less(fraction(1n, 2n), size)) {
      [power_of, scale] = [multiply(inverse, power_of), scale * D];
      size = fraction(row_norm(power_of), scale);
      total = plus(total, size);
    }
    const R = 2n * BigInt(farthest) * total.n / total.d;  // rounded down, as coordinates are integers
    demand((2n * R + 1n) ** BigInt(M.length) * BigInt(components) <= 2n ** 20n, too_much_work);
    return Number(R);
  }
  // The places [j, component] that may not vanish in v(x' + M^(-n) e) for all large n, for each e
  function inner_places(transition, components) {
    const {mask, M, digits} = transition, dimension = M.length, ones = x => new Map([...x].map(([key, [p]]) => [key, [p, 1n]]));
    const pattern = new Transition(ones(mask), M, digits), back = x => ones(pattern.apply(digits[0], x));
    const same = (x, y) => is_multiple(x, y, 1n), radius = reach(transition, components), most = 1000;
    const line = range_of(2 * radius + 1).map(x => x - radius);
    const box = range_of(dimension).reduce(points => points.flatMap(p => line.map(x => [...p, x])), [[]]);
    let all = new Map();
    for (const p of box) for (const component of range_of(components)) add(all, [...p, component], 1n);
    for (let steps = 0, next; !same(next = back(all), all); ++steps, all = next) demand(steps < most, too_much_work);
    let inner = all;
    for (let v = 0; v < 2 * dimension; ++v) {
      const moved = new Map(), seen = [moved];
      for (const [p] of all.values()) add(moved, p.map((x, i) => i === v >> 1 ? x + (v % 2 ? 1 : -1) : x), 1n);
      let again = -1;
      for (let next; again < 0;) {
        next = back(seen[seen.length - 1]);
        again = seen.findIndex(x => same(x, next));
        if (again < 0) seen.push(next);
        demand(seen.length <= most, too_much_work);
      }
      inner = new Map([...inner].filter(([key]) => seen.slice(again).every(x => x.has(key))));
    }
    return inner;
  }
  // 5.9: what tells the integral of a solution from the sums of its values; that of these values is a multiple of `integral`
  // of_root: of a doubled mask, 5.13, whose functionals come with their multiples by the root
  function read_functionals(reader, {mask, det}, den, size, values, integral, of_root) {
    const numbers = common(integral).numbers, goal = numbers.map(x => [x]);
    const rest = scaled(identity(size), -den * abs(BigInt(det)));  // q |det M| (B - 1), q the denominator of the mask
    for (const [p, value] of mask.values()) rest[p[p.length - 2]][p[p.length - 1]] += value;
    demand(multiply(rest, goal).every(([x]) => !x), 'the integral is none of a solution');
    const sums = range_of(size).map(() => [0n]);
    for (const [p, value] of values.values()) sums[p[p.length - 1]][0] += value;
    const span = new Span([], 2n ** 32n - 5n), add_row = row => {
      const one = new Map();
      row.forEach((x, c) => x && add(one, [c], x));
      span.extend(one);
    };
    rest.forEach(add_row);
    const functionals = [];
    let of_sums = 0n, of_goal = 0n;  // under the first functional that is not 0 at the integral
    const take = row => {
      add_row(row);
      let image = [row];
      for (let n = 0; n < size; ++n) image = multiply(image, rest);
      demand(image[0].every(x => !x), 'a functional does not tell integrals');
      const [[total]] = multiply([row], sums), [[value]] = multiply([row], goal);
      if (!of_goal) [of_sums, of_goal] = [total, value];
      demand(of_goal ? total * of_goal === value * of_sums : !total, 'the values are not those of this integral');
      functionals.push(row);
    };
    do {
      const row = reader.read('functional', size).map(integer), half = size / 2;
      take(row);
      if (of_root) take([...row.slice(half), ...row.slice(0, half).map(x => x * of_root)]);
    } while (reader.peek() === 'functional');
    demand(of_sums, 'the values are of the integral 0');
    demand(span.rows.length >= size, 'the functionals do not tell all of an integral');
    return functionals;
  }
  // All continuous solutions are multiples of one, or with functionals only one has their values
  function check_unique(transition, den, components, functionals, solutions = 1) {
    const inner = inner_places(transition, components), span = new Span([], 2n ** 32n - 5n);
    const images = [...inner].map(([key, entry]) => {
      const image = transition.apply(transition.digits[0], new Map([[key, entry]]));
      add(image, entry[0], -den);
      functionals.forEach((row, i) => {  // at places that no sequence has
        const c = entry[0][entry[0].length - 1];
        if (row[c]) add(image, [...entry[0].slice(0, -1).fill(0), components + i], row[c]);
      });
      return span.extend(image);
    });
    demand(images.filter(x => !x).length <= (functionals.length ? 0 : solutions), 'the refinement equation may have several continuous solutions');
  }
  // What reads it on the space, by points; with `degree` 2 by both of its parts, 5.13
  function read_component(reader, {vectors}, component, functions, degree = 1) {
    const readings = new Map(), size = vectors.length;
    vectors.forEach((v, k) => {
      for (const [key, [p, value]] of v)
        if (p[p.length - 1] % functions === component) {
          spend(readings.has(key) ? 1 : size);
          if (!readings.has(key)) readings.set(key, Array(size).fill(0n));
          readings.get(key)[k] = value;
        }
    });
    const unobservable = small(reader.read('unobservable', 1)[0], 0, size / degree - 1);
    return {readings: [...readings.values()], unobservable, degree};
  }
  // 6.7: vector schemes. sum_k x_k . e_l(-k) is 0 for all l
  function annihilates(x, data) {
    const moments = data.map(y => y.map(() => fraction(0n)));  // of (-k)^t / t!
    for (const [[k, c], value] of x.values()) {
      let term = fraction(value);
      for (let t = 0; t < data.length; ++t, term = times(term, fraction(BigInt(-k), BigInt(t)))) {
        spend(8, bits(term.n), 64);
        moments[t][c] = reduced(plus(moments[t][c], term));
      }
    }
    return data.every((_, l) => !sign(range_of(l + 1).reduce((total, s) =>
      data[s].reduce((inner, y, c) => reduced(plus(inner, times(y, moments[l - s][c]))), total), fraction(0n))));
  }
  // Shifts of these are all that annihilates the data; components are told by their number modulo that of the functions
  function read_generators(reader, data, functions) {
    const found = data[0].findIndex(sign), first = found % functions, delta = new Map();
    demand(found >= 0, 'the constant data are 0');
    add(delta, [0, first], 1n);
    const others = range_of(functions).filter(c => c !== first).map(c => {
      const x = read_sequence(reader.read('reading', 1, 2 ** 24), 1, data[0].length), places = [...x.values()].map(([p]) => p[1] % functions);
      demand(places.every(at => at === c || at === first), "a line 'reading' has a component too many");
      demand(places.filter(at => at === c).length === 1, "a line 'reading' has not one number of its component");
      return x;
    });
    return [...differences(delta, data.length, 1), ...others];
  }
  function check_interpolation({arity, degree, q, a, components: r, first}, functions) {
    const wrong = 'the scheme does not interpolate';
    a.forEach((p, i) => {
      const inside = i % (r * r), k = first + BigInt((i - inside) / (r * r)), column = inside % r, row = (inside - column) / r;
      if (k % BigInt(arity)) return;
      range_of(degree + 1).forEach(j =>
        demand(p[j] * BigInt(arity) ** BigInt(row % functions) === (!k && row === column ? q[j] : 0n), wrong));
    });
  }
  function check_vectors(reader, claim) {
    const {lower, upper, hermite, curve, interval, levels, recurrence, list} = claim, {arity, degree, q, a, components: r, first} = curve, base = BigInt(arity);
    const strict = !list || hermite;
    if (recurrence) check_following(reader, recurrence, interval);
    const order = small(reader.read('sum-rules', 1)[0], 1, 64);
    check_ends(lower, upper, strict ? 0 : 1);
    const end = lower || upper;
    demand(less(end, order) || (!strict && !less(order, end)), 'the end is not below the number of sum rules');
    const {root: of_root} = curve, functions = of_root ? r / 2 : r;
    demand(!hermite || !less(end, functions - 1), 'a Hermite scheme is asked for fewer derivatives than its data are');
    if (hermite && upper) check_interpolation(curve, functions);
    const zeros = range_of(r - functions).map(() => fraction(0n));
    const unit = s => [...range_of(functions).map(c => fraction(c === s ? 1n : 0n)), ...zeros];
    // 6.9: (q, p) for p + sqrt(R) q, and its multiple by the root
    const turned = y => [...y.slice(functions), ...y.slice(0, functions)];
    const data = range_of(order).map(s => turned(hermite ? unit(s) : reader.read('data', r).map(rational)));
    const conditions = [data];
    if (of_root) conditions.push(data.map(y => turned(y).map((x, c) => c < functions ? x : times(x, fraction(of_root)))));
    const is_zero = x => conditions.every(one => annihilates(x, one));
    const surface = {sizes: [a.length / (r * r)], components: r, first: [first]};
    const powers = range_of(degree + 1).map(k => mask_sequence({...surface, numbers: a.map(p => p[k])}));
    const digits = reader.read('digits', arity).map(token => read_point(token, 1));
    const transitions = powers.map(mask => new Transition(mask, [[arity]], digits));
    demand(new Set(digits.map(t => transitions[0].class_of(t))).size === arity, 'two digits of one class');
    powers.forEach((mask, k) => {
      const sums = digits.map(() => unit(-1)), index = new Map(digits.map((t, i) => [transitions[0].class_of(t), i]));
      for (const [[i, row, column], value] of mask.values()) {
        const of = sums[index.get(transitions[0].class_of([i]))];
        of[column] = plus(of[column], times(data[0][row], fraction(value)));
      }
      demand(sums.every(y => y.every((x, c) => !sign(minus(x, times(data[0][c], fraction(q[k])))))),
             'the scheme does not keep the constant data');
    });
    const all = {digits, images: x => digits.flatMap(t => transitions.map(one => one.apply(t, x)))};
    const start = read_generators(reader, data, functions);
    for (const x of start) {
      demand(is_zero(x), "a line 'reading' does not annihilate the data");
      demand(all.images(x).every(is_zero), 'the scheme does not keep the data');
    }
    const vectors = read_space(reader, 1, r, of_root), count = of_root ? vectors.length / 2 : vectors.length;
    demand(vectors.every(is_zero), 'a vector does not annihilate the data');
    const by_power = transitions.map(one => space_family(vectors, one, of_root ? q[0] : 1n, count));
    const multiples_of_start = of_root ? start.map(x => times_root(x, of_root, r)) : [];
    long_words([...start, ...multiples_of_start], vectors.map(row => ({key: first_key(row), row})), all);
    const scale = base ** BigInt(order);
    const goal = {below: lower && at_most(power_below(base, minus(order, lower)), strict)};
    if (upper) goal.above = at_least(over(1n, power_below(base, minus(upper, order))));  // above 1
    if (of_root) {
      const halves = by_power[0].matrices.map(m => scaled(m, scale)).map(m => on_halves(m.slice(0, count), m.slice(count), of_root));
      prove(reader, near_family({root: of_root, size: count, den: by_power[0].den, halves}), goal);
      return;
    }
    if (list) {
      prove(reader, along(list, by_power.map(({matrices: m}) => m.map(one => scaled(one, scale))), count, by_power[0].den * q[0]), goal);
      return;
    }
    const matrices = digits.map((_, t) => vectors.map((_row, i) => vectors.map((_column, k) =>
      by_power.map(({matrices: m}) => scale * m[t][i][k]))));
    const symbol = {arity, degree, q, den: by_power[0].den, matrices};
    if (interval) check_intervals(reader, symbol, goal, {levels, interval});
    else prove(reader, control_family(symbol, null), goal);
  }
  // 6.11: of any number of variables, by the constant data that the scheme keeps and what annihilates them
  function check_vectors_of_dilation(reader, {lower, upper, surface, dilation}) {
    const {den, dimension, components: r, root: of_root} = surface, functions = of_root ? r / 2 : r;
    check_isotropic(dilation);
    const D = Math.abs(small_determinant(dilation));
    demand(D <= 64, 'a dilation with too large a determinant');
    const digits = reader.read('digits', D).map(token => read_point(token, dimension));
    const transition = new Transition(mask_sequence(surface), dilation, digits);
    const index = new Map(digits.map((t, i) => [transition.class_of(t), i]));
    demand(index.size === D, 'two digits of one class');
    const turned = y => [...y.slice(functions), ...y.slice(0, functions)], kept = [];
    while (reader.peek() === 'fixed') {
      demand(kept.length < r, "more lines 'fixed' than components");
      const {numbers: y} = common(reader.read('fixed', r).map(rational));
      kept.push(of_root ? turned(y) : y);
      if (of_root) kept.push(y.map((x, c) => c < functions ? x : x * of_root));
    }
    check_all_kept(transition, den, kept, index, r);
    if (!kept.length) {
      demand(upper, 'a scheme that keeps no constant data does not converge');
      return;
    }
    const start = range_of(functions).flatMap(c => {
      const place = [...Array(dimension).fill(0), c], one = new Map();
      add(one, place, 1n);
      return [...differences(one, 1, dimension), ...digits.map(t => {
        const image = transition.apply(t, one);
        add(image, place, -den);
        return image;
      })];
    });
    const vectors = read_space(reader, dimension, r, of_root), count = of_root ? vectors.length / 2 : vectors.length;
    for (const v of vectors) {
      const sums = range_of(r).map(() => 0n);
      for (const [p, value] of v.values()) sums[p[dimension]] += value;
      demand(kept.every(y => !sum(y.map((x, c) => x * sums[c]))), 'a vector does not annihilate the data');
    }
    const family = space_family(vectors, transition, den, count);
    lead_into(vectors, of_root ? [...start, ...start.map(x => times_root(x, of_root, r))] : start, transition);
    const goal = {below: lower && at_most(fraction(1n), true), above: upper && at_least(fraction(1n))};
    const halves = of_root && family.matrices.map(m => on_halves(m.slice(0, count), m.slice(count), of_root));
    prove(reader, of_root ? near_family({root: of_root, size: count, den: family.den, halves}) : family, goal);
  }
  function check_all_kept(transition, den, kept, index, r) {  // these are a basis of all that the sums of the classes keep
    const rank = rows => {
      const span = new Span([], 2n ** 32n - 5n);
      for (const row of rows) {
        const one = new Map();
        row.forEach((x, c) => x && add(one, [c], x));
        span.extend(one);
      }
      return span.rows.length;
    };
    const equations = range_of(index.size * r).map(i => range_of(r).map(c => c === i % r ? -den : 0n));
    for (const [p, value] of transition.mask.values()) {
      const [row, column] = p.slice(-2);
      equations[index.get(transition.class_of(p.slice(0, -2))) * r + column][row] += value;
    }
    demand(kept.every(y => equations.every(row => !sum(row.map((x, c) => x * y[c])))), "the scheme does not keep a line 'fixed'");
    demand(rank(kept) === kept.length, "the lines 'fixed' are not independent");
    demand(rank(equations) + kept.length >= r, 'the scheme may keep more constant data');
  }
  function check_surface(reader, {lower, upper, surface, dilation, integral, component, exact}) {
    const {den, dimension, components} = surface, by_values = components > 0 || reader.peek() === 'differences';
    const order = order_in_space(reader.read(by_values ? 'differences' : 'sum-rules', 1)[0]);
    check_ends(lower, upper, 1);
    demand(!by_values || !lower || !less(order, lower), 'the lower end is above the order of the differences');
    check_isotropic(dilation);
    const least = fraction(1n, BigInt(Math.abs(small_determinant(dilation))) ** BigInt(order));
    check_exponent(exact, 0, 1n, dimension, least);
    const mask = mask_sequence(surface);
    demand(mask.size, 'all coefficients of the mask are 0');
    const turned = !components && reader.peek() === 'turned', M = turned ? read_dilation(reader.read('turned', 1)[0]) : dilation;
    if (turned) check_turned(M, dilation, mask);
    const D = Math.abs(small_determinant(M)), base = BigInt(D);
    demand(D <= 64, 'a dilation with too large a determinant');
    const digits = reader.read('digits', D).map(token => read_point(token, dimension));
    const transition = new Transition(mask, M, digits), both = upper || exact;
    demand(new Set(digits.map(t => transition.class_of(t))).size === D, 'two digits of one class');
    const family = surface.root ? read_values_over_field(reader, transition, order, den, both, components, surface.root, integral)
      : by_values ? read_values(reader, transition, order, den, both, components, integral)
      : read_differences(reader, transition, order, den);
    const degree = surface.root ? 2 : 1, on_rationals = family.field ? {size: 2 * family.size, matrices: family.field.halves} : family;
    const part = component === undefined ? null : read_component(reader, family, component, components / degree, degree);
    if (part && both) check_observable(part, on_rationals);
    if (!by_values && (both || reader.peek() === 'gram')) check_gram(reader, transition, den);
    const within = lower && at_most(power_below(base, minus(0n, lower)), false);
    const reached = upper && at_least(over(1n, power_below(base, upper)));
    prove(reader, family, {  // about the power JSR^s
      below: lower && ((value, level) => within(power(value, dimension), level)),
      above: upper && ((radius, length) => {
        demand(less(power(fraction(1n, base), order * length), power(radius, dimension)), no_exponent);
        reached(power(radius, dimension), length);
      }),
    }, {exact, part});
    if (!by_values || components) return;
    const rules = order_in_space(reader.read('sum-rules', 1)[0]);  // 5.6: the scheme converges
    prove(reader, read_differences(reader, transition, rules, den), {below: at_most(fraction(1n), true)});
  }

  // ---- 5.11: smoothness around a vertex -----------------------------------------------------------------------------
  // Intervals [low, high] of integers over W = 2^bits, rounded outwards
  class Intervals {
    constructor(bits, n) {
      [this.bits, this.shift, this.W, this.n, this.circle] = [bits, BigInt(bits), 1n << BigInt(bits), n, new Circle(bits)];
      [this.zero, this.one] = [[0n, 0n], [this.W, this.W]];
    }
    of({n, d}) { return [floor_div(n * this.W, d), ceil_div(n * this.W, d)]; }
    plus(x, y) { return [x[0] + y[0], x[1] + y[1]]; }
    minus(x, y) { return [x[0] - y[1], x[1] - y[0]]; }
    opposite(x) { return [-x[1], -x[0]]; }
    times(x, y) {
      spend(4, this.bits, this.bits);
      const products = [x[0] * y[0], x[0] * y[1], x[1] * y[0], x[1] * y[1]];
      const low = products.reduce((a, b) => a < b ? a : b), high = products.reduce(max);
      return [low >> this.shift, -(-high >> this.shift)];
    }
    over(x, [low, high]) {  // by what is positive
      spend(4, 2 * this.bits, this.bits);
      const ends = [floor_div(x[0] * this.W, low), floor_div(x[0] * this.W, high)];
      const tops = [ceil_div(x[1] * this.W, low), ceil_div(x[1] * this.W, high)];
      return [ends[0] < ends[1] ? ends[0] : ends[1], max(...tops)];
    }
    cosine(k) {  // of 2 pi k/n
      if (k === 0) return this.one;
      if (2 * k === this.n) return this.opposite(this.one);
      return this.cosine_at(fraction(BigInt(k), BigInt(this.n)));
    }
    cosine_at(x) {  // of 2 pi x, 0 < x < 1
      const near = this.circle.powers(times(2n, x), 2)[0][1], off = 1n << 19n;
      return [near - off, near + off];
    }
    quotient(x, y) {  // null where y may be 0
      return y[0] > 0n ? this.over(x, y) : y[1] < 0n ? this.over(this.opposite(x), this.opposite(y)) : null;
    }
    most([low, high]) { return max(-low, high); }
  }
  // Numbers a + b w, w = exp(2 pi i k/n), as [a, b]; matrices of them are lists of rows
  class Turns {
    constructor(intervals, k, cosine = intervals.cosine(k)) {
      [this.real, this.k, this.n] = [intervals, k, intervals.n];
      this.twice = intervals.plus(cosine, cosine);
    }
    plus(x, y) { return [this.real.plus(x[0], y[0]), this.real.plus(x[1], y[1])]; }
    minus(x, y) { return [this.real.minus(x[0], y[0]), this.real.minus(x[1], y[1])]; }
    times([a, b], [c, d]) {
      const {real} = this, bd = real.times(b, d), mixed = real.plus(real.times(a, d), real.times(b, c));
      return [real.minus(real.times(a, c), bd), real.plus(mixed, real.times(this.twice, bd))];
    }
    scaled(factor, [a, b]) { return [this.real.times(factor, a), this.real.times(factor, b)]; }
    get is_real() { return !this.k || 2 * this.k === this.n; }
    inner([a, b], [c, d]) {  // twice the real part of one times the conjugate of the other
      const {real} = this, parts = real.plus(real.times(a, c), real.times(b, d));
      return real.plus(real.plus(parts, parts), real.times(this.twice, real.plus(real.times(a, d), real.times(b, c))));
    }
    inverse(x) {
      const {real} = this, conjugate = [real.plus(x[0], real.times(this.twice, x[1])), real.opposite(x[1])];
      const square = this.times(x, conjugate)[0];
      demand(square[0] > 0n, 'a number that is divided by may be 0');
      return conjugate.map(part => real.over(part, square));
    }
    turned(x, turns) {
      const {real, twice, k, n} = this;
      if (!k) return x;
      if (2 * k === n) return turns % 2 ? x.map(part => real.opposite(part)) : x;
      const back = 2 * turns > n ? n - turns : -turns;
      let [a, b] = x;
      for (let t = back; t < 0; ++t) [a, b] = [real.opposite(b), real.plus(a, real.times(twice, b))];
      for (let t = back; t > 0; --t) [a, b] = [real.plus(b, real.times(twice, a)), real.opposite(a)];
      return [a, b];
    }
    turned_near_one([rho, s], turns, delta) {  // of 1 + delta rho + s (w - 1), delta = 2 - 2 cos
      const {real} = this;
      for (let t = turns; t > 0; --t) {
        rho = real.minus(rho, s);
        s = real.plus(real.plus(s, real.one), real.times(delta, rho));
      }
      for (let t = turns; t < 0; ++t) {
        s = real.minus(real.minus(s, real.one), real.times(delta, rho));
        rho = real.plus(rho, s);
      }
      return [rho, s];
    }
    most([a, b]) { return this.real.most(a) + this.real.most(b); }
    norm(matrix) { return largest_by(matrix, row => sum(row.map(x => this.most(x)))); }
    product(x, y) {
      const zero = [this.real.zero, this.real.zero];
      return x.map(row => y[0].map((_, j) => row.reduce((total, value, k) => this.plus(total, this.times(value, y[k][j])), zero)));
    }
  }
  function read_sectors(text) {
    const [head, ...parts] = text.split(';'), [lattice, valence, more] = head.split(':');
    demand(['triangles', 'quads', 'dual'].includes(lattice) && valence !== undefined && more === undefined,
           'rules around a vertex are triangles:N;..., quads:N;... or dual:N;...');
    const above = valence.endsWith('+');  // all valences from N on
    const sectors = {lattice, above, n: above ? small(valence.slice(0, -1), 7, 1000) : small(valence, 3, 1000), rules: new Map()};
    demand(parts.length <= 64, 'more rules than the checker allows');
    const place = token => {
      const point = read_point(token, 2);
      demand(point.every(x => Math.abs(x) <= 16), 'a coordinate is too large');
      demand(is_vertex(sectors, point) || in_first(sectors, point), 'a point of a rule is not one of sector 0');
      return point;
    };
    for (const part of parts) {
      const [at, text_of_terms, rest] = part.split('=');
      demand(text_of_terms !== undefined && rest === undefined, 'a rule is X,Y=TERM|TERM|...');
      const point = place(at), terms = text_of_terms.split('|');
      demand(!sectors.rules.has(String(point)), 'two rules for one point');
      demand(terms.length <= 1000, 'more data than the checker allows');
      sectors.rules.set(String(point), {point, terms: terms.map(term => {
        const [weight, datum, end] = term.split('@'), form = 'a term of a rule is WEIGHT@X,Y,TURN or WEIGHT@X,Y~FREQUENCY';
        demand(weight && datum !== undefined && end === undefined, form);
        const by_n = above && weight.endsWith('/n'), [ring, frequency, after] = datum.split('~');
        const result = {weight: polynomial(by_n ? weight.slice(0, -2) : weight, 'c'), by_n, turn: 0, ring: null};
        demand(after === undefined, form);
        if (frequency !== undefined) {
          result.at = place(ring);
          demand(!is_vertex(sectors, result.at), 'the vertex is no ring of data');
          result.ring = small(frequency, 0, sectors.n >> 1);
          return result;
        }
        const coordinates = datum.split(',');
        demand(coordinates.length === 3, form);
        result.at = place(coordinates.slice(0, 2).join(','));
        const back = above && coordinates[2].startsWith('-');
        result.turn = back ? -small(coordinates[2].slice(1), 1, 3) : small(coordinates[2], 0, above ? 3 : sectors.n - 1);
        demand(!result.turn || !is_vertex(sectors, result.at), 'the vertex is in no sector');
        return result;
      })});
    }
    return sectors;
  }
  const is_vertex = ({lattice}, [x, y]) => lattice !== 'dual' && x === 0 && y === 0;
  const in_first = ({lattice}, [x, y]) => x >= (lattice === 'dual' ? 0 : 1) && y >= 0;
  // The points of sector 0, and perhaps the vertex; then those that are not the vertex.
  function read_points(reader, sectors, most) {
    const points = reader.read('points', 1, most).map(token => read_point(token, 2));
    demand(new Set(points.map(String)).size === points.length, 'a point occurs twice');
    demand(points.every(p => is_vertex(sectors, p) || in_first(sectors, p)), 'a point is not one of sector 0');
    const turning = points.filter(p => !is_vertex(sectors, p));
    demand(turning.length, 'no point of a sector is given');
    return [points, turning];
  }
  function in_sector(sectors, point) {  // the sector, -2, ..., 3, and the point of sector 0 that is turned there
    const {lattice, n} = sectors, all = lattice === 'triangles' ? 6 : 4;
    if (is_vertex(sectors, point)) return {at: point, turn: 0};
    let [x, y] = point, turns = 0;
    for (; !in_first(sectors, [x, y]); ++turns)
      [x, y] = lattice === 'triangles' ? [x + y, -x] : [y, (lattice === 'dual' ? -1 : 0) - x || 0];
    demand(2 * turns !== all || n === all, 'a rule needs data opposite of its sector');
    return {at: [x, y || 0], turn: 2 * turns > all ? turns - all : turns};
  }
  function lattice_mask(surface, dilation) {
    const [m] = dilation[0];
    demand(dilation.length === 2 && m > 1 && String(dilation) === `${m},0,0,${m}`,
           'the dilation around a vertex is no multiple of the unit matrix of two variables');
    const mask = mask_sequence(surface);
    demand([...mask.values()].every(([k]) => k.every(x => Math.abs(x) <= 64)), 'an index of the mask is too large');
    return {m, den: surface.den, mask};
  }
  function check_turns({lattice}, {m, mask}) {
    const image = ([x, y]) => lattice === 'triangles' ? [-y, x + y] : [(lattice === 'dual' ? m - 1 : 0) - y, x];
    for (const [k, value] of mask.values()) {
      const other = mask.get(String(image(k).map(x => x || 0)));
      demand(other && other[1] === value, 'the mask does not turn with the sectors');
    }
  }
  function check_own_rules(sectors) {
    for (const {point, terms} of sectors.rules.values()) {
      const turns = ({at, ring}) => ring === 0 || (ring === null && is_vertex(sectors, at));
      demand(!is_vertex(sectors, point) || terms.every(turns), 'the rule of the vertex does not turn');
      for (const by_n of [false, true]) {
        const total = terms.filter(term => !term.ring && Boolean(term.by_n) === by_n).reduce(
          (all, {weight}) => all.map((x, k) => plus(x, weight[k])), range_of(13).map(k => fraction(k || by_n ? 0n : -1n)));
        demand(total.every(x => !x.n), 'the weights of a rule do not sum to 1');
      }
    }
  }
  function of_differences({m, den, mask}, axis) {  // m a / (1 + z^e + ... + z^((m-1)e))
    const end = Math.max(...[...mask.values()].map(([k]) => k[axis])), step = axis ? [0, 1] : [1, 0], result = new Map();
    const places = different([...mask.values()].flatMap(([k]) => range_of(end - k[axis] + 1).map(j => add_points(k, step, j))), String);
    const sums = new Map(), at = (map, p) => map.has(String(p)) ? map.get(String(p))[1] : 0n;
    places.sort((p, q) => p[axis] - q[axis]);
    for (const p of places) {
      const before = range_of(m - 1).map(j => at(result, add_points(p, step, -1 - j)));
      const value = BigInt(m) * at(mask, p) - sum(before);
      if (!value) continue;
      demand(p[axis] <= end - (m - 1), 'the mask does not refine differences along an axis');
      demand(value > 0n, 'a coefficient of the scheme of the differences is negative');
      add(result, p, value);
      add(sums, p.map(x => (x % m + m) % m), value);
    }
    demand(sums.size === m * m && values_of(sums).every(x => x === den), 'the scheme of the differences does not keep constants');
    return {m, mask: result};
  }
  function window_of({m, mask}) {
    const indices = [...mask.values()].map(([k]) => k);
    const along = v => {
      const all = indices.map(k => k[v]), low = Math.min(...all), high = Math.max(...all);
      return range_of(131).map(i => i - 65).filter(k => k * (m - 1) > -high && (k - 1) * (m - 1) < -low);
    };
    let points = along(0).flatMap(x => along(1).map(y => [x, y]));
    for (;;) {
      spend(points.length * indices.length);
      const next = different(points.flatMap(p => indices.map(k => p.map((x, v) => Math.ceil((x - k[v]) / m) || 0))), String);
      if (next.length === points.length) return points;
      points = next;
    }
  }
  function rule_at(sectors, {m, den, mask}, point) {
    const own = sectors.rules.get(String(point)), terms = [];
    if (own) return own.terms;
    for (const [k, value] of mask.values()) {
      const datum = add_points(point, k, -1);
      if (datum.every(x => x % m === 0))
        terms.push({...in_sector(sectors, datum.map(x => x / m || 0)), ring: null, weight: [fraction(value, den)]});
    }
    demand(!is_vertex(sectors, point) || terms.every(({at}) => is_vertex(sectors, at)), 'the rule of the vertex does not turn');
    return terms;
  }
  function weight_at({weight, by_n}, real, {cosine, share}) {
    const value = weight.reduceRight((total, x) => real.plus(real.times(total, cosine), real.of(x)), real.zero);
    return by_n ? real.times(value, share) : value;
  }
  // Lemma 65: Gamma_0, Gamma_1 and Gamma_2, by words w with g_w <= rate, and the shift of affine functions
  const affine_at = ([x, y]) => [BigInt(1 - x - y), BigInt(x), BigInt(y)];  // by the data at 0, (1,0) and (0,1)
  class Fits {
    constructor(lattice, rate) {
      demand(0n < rate.n && less(rate, 1n), 'the rate of the fits is not between 0 and 1');
      const corners = [[0, 0], [1, 0], [0, 1]], window = different([...window_of(lattice), ...corners], String);
      Object.assign(this, {lattice, rate, window, shift: shift_of(lattice), gammas: [0, 1, 2].map(() => fraction(0n)), first: 0});
      spend(window.length ** 3);
      this.corners = corners.map(corner => window.findIndex(l => String(l) === String(corner)));
      this.free = range_of(window.length).filter(i => !this.corners.includes(i));
      this.weights = window.map(([x, y]) => BigInt(3 * (x * x + x * y + y * y - x - y) + 1));
      const {m, mask} = lattice, digits = range_of(m).flatMap(x => range_of(m).map(y => [x, y]));
      this.letters = digits.map(d => window.map(l => window.flatMap((p, i) => {
        const entry = mask.get(String(p.map((x, v) => d[v] + x - m * l[v] || 0)));
        return entry ? [[i, entry[1]]] : [];
      })));
      const rows = this.free.map(l => window.map((_, i) => i === l ? 1n : 0n));
      this.visit(rows, 1n, 1n, 0);
    }
    norm(rows, affine, l = null) {  // N of B_w times u_l, or times an affine function of the corners
      const {corners, weights, free} = this, [a, b, c] = corners, [x, y, z] = affine;
      spend(3 * rows.length);
      return rows.reduce((total, row, i) => {
        const value = row[a] * x + row[b] * y + row[c] * z - (l === null ? 0n : row[l]);
        return total + weights[free[i]] * abs(value);
      }, 0n);
    }
    contraction(rows, grown, scale) {  // g_w, null where it is above the rate
      const {free, window, weights, rate} = this;
      let most = fraction(0n);
      for (let i = 0; i < free.length; ++i) {
        const place = (this.first + i) % free.length, l = free[place];
        const g = fraction(grown * this.norm(rows, affine_at(window[l]), l), scale * weights[l]);
        if (less(rate, g)) {
          this.first = place;  // likely the next one to fail
          return null;
        }
        if (less(most, g)) most = g;
      }
      return most;
    }
    visit(rows, grown, scale, letters) {
      const g = this.contraction(rows, grown, scale), {lattice: {m, den}, window} = this;
      if (g) return this.use(rows, grown, scale, g);
      demand(letters < 16, 'words do not contract by the rate');
      for (const letter of this.letters) {
        const next = rows.map(row => {
          const image = window.map(() => 0n);
          row.forEach((x, k) => {
            if (!x) return;
            spend(letter[k].length);
            for (const [p, value] of letter[k]) image[p] += x * value;
          });
          return image;
        });
        this.visit(next, grown * BigInt(m), scale * den, letters + 1);
      }
    }
    use(rows, grown, scale, g) {
      const raise = (k, value, factor) => {
        const gamma = over(value, minus(1n, factor));
        if (less(this.gammas[k], gamma)) this.gammas[k] = reduced(gamma);
      };
      raise(1, fraction(grown * this.norm(rows, [-1n, 1n, 0n]), scale), g);
      raise(2, fraction(grown * this.norm(rows, [-1n, 0n, 1n]), scale), g);
      const {shift: [s, t]} = this, parts = s.d * t.d, of = (x, {n, d}) => (x * d + n) * (parts / d);
      for (const x of [0n, 1n])
        for (const y of [0n, 1n]) {
          const at = [of(x, s), of(y, t)];
          raise(0, fraction(this.norm(rows, [parts - at[0] - at[1], ...at]), scale * parts), fraction(g.n, g.d * grown));
        }
    }
    within(real, data) {  // of real data at the window: the derivatives along both axes, and the least value
      const {corners, weights, window, free, gammas, shift} = this, [o, ...ends] = corners.map(i => data[i]);
      const times = (k, x) => k < 0n ? [k * x[1], k * x[0]] : [k * x[0], k * x[1]];
      const rest = largest_by(free, i => {
        const left = affine_at(window[i]).reduce((all, k, v) => real.minus(all, times(k, data[corners[v]])), data[i]);
        return ceil_div(real.most(left), weights[i]);
      });
      const [off, ...offs] = gammas.map(gamma => real.times(real.of(gamma), [rest, rest])[1]), steps = ends.map(x => real.minus(x, o));
      const slopes = steps.map((step, v) => real.plus(step, [-offs[v], offs[v]]));
      const least = steps.map((step, v) => {
        const [a, b] = [0n, 1n].map(x => real.times(real.of(plus(shift[v], x)), step)[0]);
        return a < b ? a : b;
      });
      return {slopes, least: o[0] - off + sum(least)};
    }
  }
  function shift_of({m, den, mask}) {  // -mu/(m-1), mu the sum of k a_k over each class
    const sums = new Map();
    for (const [k, value] of mask.values()) {
      const key = String(k.map(x => (x % m + m) % m)), before = sums.get(key) || [0n, 0n, 0n];
      sums.set(key, [1n, ...k.map(BigInt)].map((x, i) => before[i] + x * value));
    }
    const all = [...sums.values()], [first] = all;
    demand(first[0] === den && all.length === m * m && all.every(other => String(other) === String(first)),
           'the mask does not keep affine functions');
    return first.slice(1).map(x => reduced(fraction(-x, BigInt(m - 1) * den)));
  }
  function ring_of(sectors, lattice, fits) {  // the windows, and r of Theorem 55
    const window = fits ? fits.window : window_of(lattice), differences = fits ? [] : [0, 1].map(axis => window_of(of_differences(lattice, axis)));
    const most = points => Math.max(0, ...points.flat().map(Math.abs));
    const behind = differences.flatMap((points, axis) => points.map(k => add_points(k, axis ? [0, 1] : [1, 0], -1)));
    const h = most([...window, ...differences.flat(), ...behind]), reach = most([...lattice.mask.values()].map(([k]) => k));
    return {fits, window, differences, first: 2 * (h + reach) + most([...sectors.rules.values()].map(({point}) => point)) + 1};
  }
  class SectorMap {  // z outwards from the known values; near_one: as rho and s of 1 + delta rho + s (w - 1), 5.12
    constructor(sectors, lattice, ring, {turns, letters, lambda, of_lambda, known, near_one}) {
      Object.assign(this, {sectors, lattice, ring, turns, letters, lambda, of_lambda, known, near_one});
    }
    turned(x, turn) {
      const {turns, near_one} = this;
      return near_one ? turns.turned_near_one(x, turn, near_one.delta) : turns.turned(x, turn);
    }
    value_at(point) {
      const {turns, known, near_one} = this, {real} = turns, {at, turn} = in_sector(this.sectors, point), key = String(at);
      if (!known.has(key)) {
        known.set(key, null);
        const total = rule_at(this.sectors, this.lattice, at).reduce((all, term) => {
          const value = turns.scaled(weight_at(term, real, this.letters), this.turned(this.value_at(term.at), term.turn));
          return term.ring === null || term.ring === turns.k ? turns.plus(all, value) : all;
        }, [near_one ? near_one.decay : real.zero, real.zero]);
        known.set(key, turns.times(this.of_lambda, total));
      }
      demand(known.get(key), 'a point depends on itself');
      return this.turned(known.get(key), turn);
    }
    ahead(z, level) {  // what is positive in a half plane
      const {turns, near_one} = this, {real} = turns;
      if (near_one) return real.plus(real.one, real.times(near_one.delta, z[0]));
      return real.plus(...turns.times(this.powers[level], z));
    }
    is_ahead_on(corner, level) {
      return this.is_positive(this.ring.window.map(k => this.ahead(this.value_at(add_points(corner, k)), level)));
    }
    is_positive(data) {  // limits of data on a window, on its square
      const {fits} = this.ring;
      return fits ? fits.within(this.turns.real, data).least > 0n : data.every(([low]) => low > 0n);
    }
    has_no_zero_at(radius) {  // on squares with this largest coordinate
      const has_none_on = corner => {
        const at = this.value_at(corner);
        spend(20);
        return this.is_positive(this.ring.window.map(k => this.turns.inner(at, this.value_at(add_points(corner, k)))));
      };
      return range_of(radius + 1).every(i => has_none_on([radius, radius - i]) && has_none_on([radius - i, radius]));
    }
    has_jacobian(corner, positive = true) {
      const has_sign = ([low, high]) => positive ? low > 0n : high < 0n;
      const {turns} = this, {real} = turns, {fits, window} = this.ring, at = k => this.value_at(add_points(corner, k));
      if (fits) {  // Theorem 66
        const data = window.map(at), [a, b] = [0, 1].map(part => fits.within(real, data.map(z => z[part])).slopes);
        return has_sign(real.minus(real.times(a[0], b[1]), real.times(b[0], a[1])));
      }
      const [us, vs] = this.ring.differences.map((window, axis) =>
        window.map(k => turns.minus(at(k), at(add_points(k, axis ? [0, 1] : [1, 0], -1)))));
      return us.every(([a, b]) => vs.every(([c, d]) => has_sign(real.minus(real.times(a, d), real.times(b, c)))));
    }
    shows(corner, level, cuts, known = false) {  // the parts of a square that is ahead are so
      const {m} = this.lattice, parts = range_of(m * m).map(i => [m * corner[0] + Math.floor(i / m), m * corner[1] + i % m]);
      spend(20);
      const ahead = known || this.is_ahead_on(corner, level);
      return (ahead && this.has_jacobian(corner)) || (level < cuts && parts.every(part => this.shows(part, level + 1, cuts, ahead)));
    }
    is_regular(cuts) {  // Theorem 55
      const {turns} = this, {first} = this.ring, end = this.lattice.m * first;
      this.powers = [[turns.real.one, turns.real.zero]];
      for (let l = 0; l < cuts; ++l) this.powers.push(turns.times(this.powers[l], this.lambda));
      for (let x = end - 1; x >= 0; --x)
        for (let y = end - 1; y >= 0; --y)
          if (Math.max(x, y) < first) this.value_at([x, y]);
          else if (!this.shows([x, y], 0, cuts)) return false;
      return true;
    }
  }
  class Vertex {
    constructor(sectors, lattice, reader, k, [bits, xbits, ...places]) {
      Object.assign(this, {sectors, lattice, reader, k});
      this.real = new Intervals(small(bits, 64, 1024), sectors.n);
      [this.W, this.scale] = [this.real.W, 1n << BigInt(small(xbits, 0, 4096))];
      [this.lambda, this.radius] = places.map(integer);  // over the scale
      [this.first, this.cosine] = [new Turns(this.real, k), this.real.cosine(1)];
      demand(this.radius >= 0n, 'the radius is below 0');
    }
    static check_c1(sectors, lattice, reader) {  // Theorem 55
      const [bits, xbits, cuts, ...places] = reader.read('vertex', 5), vertex = new Vertex(sectors, lattice, reader, 1, [bits, xbits, ...places]);
      const levels = small(cuts, 0, 8);
      vertex.find_leader();
      demand(vertex.map().is_regular(levels), 'the characteristic map is not shown to be regular and in a half plane');
    }
    static check_not_c1(sectors, lattice, reader) {  // Theorems 67 and 68
      const [frequency, ...fields] = reader.read('not-c1', 5), k = small(frequency, 0, sectors.n >> 1);
      const vertex = new Vertex(sectors, lattice, reader, k, fields), {lambda, radius, scale, first} = vertex;
      if ((lambda < 0n ? -lambda : lambda) - radius > scale) {
        vertex.read_lines();
        return vertex.show_eigenvector();
      }
      demand(!k || !first.is_real, 'the frequency is n/2');
      vertex.find_leader();
      const place = text => small(text, 0, 4096), in_ring = (ring, far) => demand(far >= ring.first, 'a square is too near to the vertex');
      if (k !== 1 && reader.peek() === 'around') {
        const far = place(reader.read('around', 1)[0]), map = vertex.map();
        in_ring(map.ring, far);
        return demand(map.has_no_zero_at(far), 'the map may be 0 on these squares');
      }
      demand(k, 'a real map has no Jacobian');
      const corners = reader.read('folds', 2).map(text => text.split(',').map(place)), map = vertex.map();
      corners.forEach((corner, i) => {
        demand(corner.length === 2, 'a square is told by two coordinates');
        in_ring(map.ring, Math.max(...corner));
        demand(map.has_jacobian(corner, !i), 'the Jacobian is not shown to have both signs');
      });
    }
    find_leader() {
      demand(this.lambda > this.radius && this.lambda + this.radius < this.scale, 'the subdominant eigenvalue is not between 0 and 1');
      this.read_lines();
      this.show_eigenvector();
      this.widen();
      for (let k = 0; 2 * k <= this.sectors.n; ++k) this.show_gap(k);
    }
    read_lines() {
      const {reader, sectors, first} = this;
      [this.points, this.turning] = read_points(reader, sectors, 64);
      this.own = this.k ? this.turning : this.points;
      const n = this.own.length;
      const pairs = (tokens, scale) => {
        const read = tokens.map(integer), numbers = read.map(x => this.real.of(fraction(x, scale)));
        demand(!first.is_real || read.every((x, i) => i % 2 === 0 || x === 0n), 'a number of a real frequency is not real');
        return range_of(n).map(i => numbers.slice(2 * i, 2 * i + 2));
      };
      this.values = pairs(reader.read('values', 2 * n), this.scale);
      const scale = 1n << BigInt(small(reader.read('inverse', 1)[0], 0, 4096));
      this.inverse = range_of(n).map(i => pairs(reader.read(`row ${i}`, 2 * n), scale));
    }
    block(k, turns, points) {
      const zero = [this.real.zero, this.real.zero];
      return points.map(point => {
        const row = points.map(() => zero);
        for (const term of rule_at(this.sectors, this.lattice, point)) {
          if ((term.ring !== null && term.ring !== k) || (k && is_vertex(this.sectors, term.at))) continue;
          const j = points.findIndex(p => String(p) === String(term.at));
          demand(j >= 0, 'a rule of the points has data elsewhere');
          row[j] = turns.plus(row[j], turns.turned([weight_at(term, this.real, {cosine: this.cosine}), this.real.zero], term.turn));
        }
        return row;
      });
    }
    show_eigenvector() {  // Lemma 52
      const {first, real, W} = this, matrix = this.block(this.k, first, this.own), lambda = real.of(fraction(this.lambda, this.scale));
      matrix.forEach((row, i) => { row[i] = first.minus(row[i], [lambda, real.zero]); });
      const off = first.norm(first.product(this.inverse, first.product(matrix, this.values.map(z => [z]))));
      matrix.forEach((row, i) => { row[0] = first.minus([real.zero, real.zero], this.values[i]); });
      const rest = first.product(this.inverse, matrix);
      rest.forEach((row, i) => { row[i] = first.minus(row[i], [real.one, real.zero]); });
      const slope = first.norm(rest), size = first.norm(this.inverse), {radius, scale} = this;
      demand(slope < W && off * scale * scale + radius * scale * slope + radius * radius * size <= radius * scale * W,
             'no eigenvector is shown near the values');
    }
    widen() {
      const {first} = this, both = this.error();
      this.values = this.values.map((z, i) => i ? first.plus(z, both) : z);
      const {real} = this;
      this.eigenvalue = first.plus([real.of(fraction(this.lambda, this.scale)), real.zero], both);
      this.known = new Map([...this.points.map(p => [String(p), [real.zero, real.zero]]),
                            ...this.own.map((p, i) => [String(p), this.values[i]])]);
    }
    error() {  // holds all numbers of modulus at most the radius
      const {real, first} = this, radius = real.of(fraction(this.radius, this.scale));
      if (first.is_real) return [[-radius[1], radius[1]], real.zero];
      const cosine = real.cosine(this.k), sine = real.minus(real.one, real.times(cosine, cosine));
      demand(sine[0] > 0n, 'too few bits for the angle');
      const by = real.over(radius, sine)[1];
      return [[-by, by], [-by, by]];
    }
    show_gap(k) {  // Lemma 53
      const {real, values} = this, turns = new Turns(real, k), one = [real.one, real.zero];
      const quotient = (matrix, vector) => {  // in the coordinates that vanish at the first place
        const by = turns.inverse(vector[0]), parts = vector.map(x => turns.times(x, by));
        return matrix.map((row, i) => row.map((x, j) => turns.minus(x, turns.times(parts[i], matrix[0][j]))).slice(1)).slice(1);
      };
      let matrix = this.block(k, turns, k ? this.turning : this.points);
      if (!k) matrix = quotient(matrix, matrix.map(() => one));
      if (k === this.k && matrix.length) matrix = quotient(matrix, k ? values : values.slice(1).map(z => turns.minus(z, values[0])));
      if (!matrix.length) return;
      const [, scale] = real.of(fraction(this.scale, this.lambda - this.radius));
      matrix = matrix.map(row => row.map(x => turns.scaled([scale, scale], x)));
      for (let squarings = 0, norm = turns.norm(matrix); norm >= this.W; norm = turns.norm(matrix)) {
        demand(++squarings <= 24 && norm < this.W * this.W, `eigenvalues of frequency ${k} may not be below lambda`);
        matrix = turns.product(matrix, matrix);
      }
    }
    map() {  // outwards
      const {sectors, lattice, reader, first, real, cosine, eigenvalue, known} = this;
      const fits = reader.peek() === 'fits' ? new Fits(lattice, rational(reader.read('fits', 1)[0])) : null;
      return new SectorMap(sectors, lattice, ring_of(sectors, lattice, fits), {
        turns: first, letters: {cosine, share: real.zero}, lambda: eigenvalue, of_lambda: first.inverse(eigenvalue), known, near_one: null});
    }
  }
  // ---- 5.12: vertices of all valences from one on -------------------------------------------------------------------
  // Polynomials in c = cos(2 pi/n), C = cos(2 pi k/n) and 1/n: the factors by the three powers. With w: pairs a + b w
  const letter_sum = (...all) => {
    const total = new Map();
    for (const [key, factor] of all.flatMap(p => [...p])) {
      const value = total.has(key) ? reduced(plus(total.get(key), factor)) : factor;
      if (value.n) total.set(key, value); else total.delete(key);
    }
    return total;
  };
  const letter_product = (x, y) => letter_sum(...[...x].map(([p, factor]) => new Map([...y].map(([q, other]) => {
    const value = reduced(times(factor, other)), by = q.split(',');
    spend(8, bits(value.n), bits(value.d));
    return [String(p.split(',').map((k, v) => Number(k) + Number(by[v]))), value];
  }))));
  const letter_number = (x, key = '0,0,0') => new Map([[key, fraction(x)]]), [by_c, by_C, by_share] = [0, 1, 2];
  const pair_sum = (x, y) => x.map((part, i) => letter_sum(part, y[i]));
  function pair_product([a, b], [c, d], cosine) {
    const bd = letter_product(b, d), minus_bd = letter_product(letter_number(-1n), bd), twice = letter_product(letter_number(2n), cosine);
    return [letter_sum(letter_product(a, c), minus_bd),
            letter_sum(letter_product(a, d), letter_product(b, c), letter_product(twice, bd))];
  }
  function pair_turned([a, b], turns, cosine) {
    const twice = letter_product(letter_number(2n), cosine), opposite = x => letter_product(letter_number(-1n), x);
    for (let t = turns; t > 0; --t) [a, b] = [opposite(b), letter_sum(a, letter_product(twice, b))];
    for (let t = turns; t < 0; ++t) [a, b] = [letter_sum(b, letter_product(twice, a)), opposite(a)];
    return [a, b];
  }
  function letter_characteristic(matrix, cosine) {  // as for numbers, by Faddeev and LeVerrier
    const n = matrix.length, result = [];
    result[n] = letter_number(1n);
    let product = matrix;
    for (let j = 1; j <= n; ++j) {
      const [trace, rest] = range_of(n).reduce((all, i) => pair_sum(all, product[i][i]), [new Map(), new Map()]);
      demand(!rest.size, 'the eigenvalues of a frequency and of its opposite are not the same');
      result[n - j] = letter_product(letter_number(fraction(-1n, BigInt(j))), trace);
      if (j === n) break;
      const shifted = product.map((row, i) => row.map((x, k) => i === k ? [letter_sum(x[0], result[n - j]), x[1]] : x));
      product = matrix.map(row => range_of(n).map(k =>
        row.reduce((all, x, i) => pair_sum(all, pair_product(x, shifted[i][k], cosine)), [new Map(), new Map()])));
    }
    return result;
  }
  function cosine_of(k) {  // cos(k t) in cos t = c
    const c = letter_number(1n, '1,0,0');
    let [before, cosine] = [letter_number(1n), c];
    if (!k) return before;
    for (let i = 1; i < k; ++i)
      [before, cosine] = [cosine, letter_sum(letter_product(letter_product(letter_number(2n), c), cosine), letter_product(letter_number(-1n), before))];
    return cosine;
  }
  const letter_slope = (p, letter) => new Map([...p].map(([key, factor]) => [key.split(',').map(Number), factor])
    .filter(([powers]) => powers[letter]).map(([powers, factor]) => [
      String(powers.map((k, v) => v === letter ? k - 1 : k)), times(factor, BigInt(powers[letter]))]));
  // Polynomials in x with intervals as coefficients, the lowest first
  class IntervalPolynomials {
    constructor(real) { this.real = real; }
    values(p, at) {  // of letters in intervals
      const {real} = this, raised = (x, power, start) => range_of(Number(power)).reduce(total => real.times(total, x), start);
      return p.map(coefficient => [...coefficient].reduce((total, [key, factor]) =>
        real.plus(total, key.split(',').reduce((product, power, v) => raised(at[v], power, product), real.of(factor))), real.zero));
    }
    value(p, x) { return p.reduceRight((total, c) => this.real.plus(this.real.times(total, x), c), this.real.zero); }
    slope(p, x) { return this.value(p.slice(1).map((c, i) => c.map(end => end * BigInt(i + 1))), x); }
    approach(p, start) {  // nothing is proved
      let at = start;
      for (let step = 0; step < 40; ++step) {
        const change = this.real.quotient(this.value(p, [at, at]), this.slope(p, [at, at]));
        if (!change) break;
        at -= (change[0] + change[1]) / 2n;
      }
      return at;
    }
    zero(p, start) {  // the one zero of an interval, which is simple
      const {real} = this, middle = [start, start], value = this.value(p, middle), step = real.quotient(value, this.slope(p, middle));
      if (!step) return null;
      let radius = real.most(step) + 1n;
      for (let attempt = 0; attempt < 4; ++attempt) {
        radius *= 2n;
        const around = [start - radius, start + radius], change = real.quotient(value, this.slope(p, around));
        if (!change) return null;
        const next = real.minus(middle, change);
        if (around[0] <= next[0] && next[1] <= around[1]) return next;
      }
      return null;
    }
    deflated(p, zero) {
      const result = [];
      let carry = this.real.zero;
      for (let i = p.length - 1; i > 0; --i) result[i - 1] = carry = this.real.plus(this.real.times(carry, zero), p[i]);
      return result;
    }
    has_zeros_below(p, radius) {  // Schur's test
      const {real} = this;
      let scale = real.one, rest = p.map(c => {
        const result = real.times(c, scale);
        scale = real.times(scale, [radius, radius]);
        return result;
      });
      while (rest.length > 1) {
        const last = rest.length - 1, share = real.quotient(rest[0], rest[last]);
        if (!share || real.most(share) >= real.W) return false;
        rest = range_of(last).map(i => real.minus(rest[i + 1], real.times(share, rest[last - 1 - i])));
      }
      return true;
    }
  }
  class Vertices {
    constructor(sectors, lattice, reader) {
      Object.assign(this, {sectors, lattice, reader});
      const fields = reader.read('vertices', 3);
      this.real = new Intervals(small(fields[0], 64, 1024), Infinity);
      this.halvings = small(fields[1], 0, 16);
      [this.near] = this.real.of(rational(fields[2]));
      this.p = new IntervalPolynomials(this.real);
      this.ring = ring_of(sectors, lattice, null);
    }
    check() {
      [this.points, this.turning] = read_points(this.reader, this.sectors, 16);
      this.make_polynomials();
      this.show_between(0, 0);
    }
    polynomial(k) {  // of frequency k, null: of all that no rule names
      const {sectors} = this, points = k === 0 ? this.points : this.turning;
      const cosine = k === null ? letter_number(1n, '0,1,0') : cosine_of(k);
      const matrix = points.map(point => {
        const row = points.map(() => [new Map(), new Map()]);
        for (const term of rule_at(sectors, this.lattice, point)) {
          if ((term.ring !== null && term.ring !== k) || (k !== 0 && is_vertex(sectors, term.at))) continue;
          const j = points.findIndex(p => String(p) === String(term.at));
          demand(j >= 0, 'a rule of the points has data elsewhere');
          const weight = new Map(term.weight.flatMap((x, i) => x.n ? [[`${i},0,${term.by_n ? 1 : 0}`, x]] : []));
          row[j] = pair_sum(row[j], pair_turned([weight, new Map()], term.turn, cosine));
        }
        return k === 0 ? row.map(([a, b]) => [letter_sum(a, b), new Map()]) : row;
      });
      return letter_characteristic(matrix, cosine);
    }
    make_polynomials() {
      const {sectors} = this, rules = [...sectors.rules.values()], terms = rules.flatMap(rule => rule.terms);
      const named = new Set(terms.filter(({ring}) => ring !== null).map(({ring}) => ring));
      demand([...named].every(k => k <= 8), 'a frequency of a rule is too large');
      this.meets = this.points.some(point => is_vertex(sectors, point)) && rules.every(({point, terms: own}) => own.every(
        ({at, ring, by_n}) => is_vertex(sectors, point) ? by_n || is_vertex(sectors, at) : ring === null || ring > 1));
      this.may_be_one = sectors.lattice === 'dual' && !named.size && !terms.some(({by_n}) => by_n);
      [this.growth, this.grows_from_first] = [null, !named.has(1)];
      [this.first, this.general] = [this.polynomial(1), this.polynomial(null)];
      const constants = this.polynomial(0);
      for (let i = constants.length - 2; i >= 0; --i) constants[i] = letter_sum(constants[i], constants[i + 1]);
      this.constants = constants.slice(1);
      this.named = [...named].filter(k => k > 1).sort((x, y) => x - y).map(k => this.polynomial(k));
    }
    show_between(k, depth) {  // k and k + 1 over 2^depth N
      if (this.holds_on(this.box_of(k, depth))) return;
      demand(depth < this.halvings, 'smoothness is not shown for all valences');
      this.show_between(2 * k, depth + 1);
      this.show_between(2 * k + 1, depth + 1);
    }
    box_of(k, depth) {
      const {real} = this, parts = BigInt(this.sectors.n) << BigInt(depth), low = fraction(BigInt(k), parts), high = fraction(BigInt(k + 1), parts);
      const letters = (from, to) => {
        const cosine = [real.cosine_at(to)[0], from.n ? real.cosine_at(from)[1] : real.W];
        return [cosine, cosine, [real.of(from)[0], real.of(to)[1]]];
      };
      const middle = fraction(BigInt(2 * k + 1), 2n * parts);
      return {all: letters(low, high), middle: letters(middle, middle), from_zero: k === 0};
    }
    start_of(p, middle, near) { return this.p.approach(this.p.values(p, middle), near); }
    change(p, letter, at, zero) {  // of a zero that was found, where the slope is not 0
      const by = this.p.value(this.p.values(p.map(c => letter_slope(c, letter)), at), zero);
      return this.real.opposite(this.real.quotient(by, this.p.slope(this.p.values(p, at), zero)));
    }
    slope(p, at, zero) {  // by 1/n; c changes by between -40/n and 0
      const of_c = this.change(p, by_c, at, zero), of_share = this.change(p, by_share, at, zero);
      return this.real.plus(of_share, this.real.times(of_c, [-40n * at[by_share][1], 0n]));
    }
    constants_are_behind({all, middle}, leader) {  // null, or whether it still meets
      const p = this.p.values(this.constants, all);
      if (this.p.has_zeros_below(p, leader[0])) return {meets: false};
      if (!this.meets) return null;
      const zero = this.p.zero(p, this.start_of(this.constants, middle, (leader[0] + leader[1]) / 2n));
      if (!zero || zero[0] <= -leader[0] || !this.p.has_zeros_below(this.p.deflated(p, zero), leader[0])) return null;
      return this.slope(this.first, all, leader)[0] > this.slope(this.constants, all, zero)[1] ? {meets: true} : null;
    }
    grows_on(at, middle, leader, near) {  // null, or near the zero
      const start = this.start_of(this.general, middle, near), p = this.p.values(this.general, at), zero = this.p.zero(p, start);
      if (!zero || zero[0] <= 0n || !this.p.has_zeros_below(this.p.deflated(p, zero), leader[0])) return null;
      return this.change(this.general, by_C, at, zero)[0] > 0n ? start : null;
    }
    general_is_behind({all, middle}, leader) {
      const {W} = this.real, last = 2n * this.real.times(all[by_c], all[by_c])[1] - W, open = [[-W, this.grows_from_first ? all[by_c][1] : last]];
      let grows = this.grows_from_first, near = (leader[0] + leader[1]) / 2n;
      while (open.length) {
        const [low, high] = open.pop(), centre = (low + high) / 2n;
        const at = [all[by_c], [low, high], all[by_share]], start = grows ? this.grows_on(at, [middle[by_c], [centre, centre], middle[by_share]], leader, near) : null;
        if (start !== null) {
          near = start;
        } else if (low >= last || this.p.has_zeros_below(this.p.values(this.general, at), leader[0])) {
          grows = false;
        } else {
          if (512n * (high - low) < W) return false;
          open.push([low, centre], [centre, high]);
        }
      }
      return true;
    }
    holds_on(box) {
      const start = this.start_of(this.first, box.middle, this.near), p = this.p.values(this.first, box.all), leader = this.p.zero(p, start);
      if (!leader || leader[0] <= 0n || !this.p.has_zeros_below(this.p.deflated(p, leader), leader[0])) return false;
      let {growth} = this;
      if (leader[1] >= this.real.W || growth) {
        const here = this.may_be_one && (growth || box.from_zero) && this.change(this.first, by_c, box.all, leader);
        if (!here || here[0] <= 0n) return false;
        growth = growth ? [here[0] < growth[0] ? here[0] : growth[0], max(growth[1], here[1])] : here;
      }
      const behind = this.general_is_behind(box, leader) && this.constants_are_behind(box, leader);
      if (!behind || !this.named.every(q => this.p.has_zeros_below(this.p.values(q, box.all), leader[0]))) return false;
      if (!this.is_regular(box, leader, growth)) return false;
      Object.assign(this, {growth, near: start}, behind);
      return true;
    }
    is_regular({all}, leader, growth) {
      const {real, sectors, lattice} = this, letters = {cosine: all[by_c], share: all[by_share]}, turns = new Turns(real, 1, letters.cosine);
      const two = [2n * real.W, 2n * real.W], delta = real.minus(two, real.plus(letters.cosine, letters.cosine));
      const near_one = growth && {delta, decay: real.over(growth, two)}, known = this.on_points(turns, letters, leader, near_one);
      return known !== null && new SectorMap(sectors, lattice, this.ring, {
        turns, letters, lambda: [leader, real.zero], of_lambda: [real.over(real.one, leader), real.zero], known, near_one}).is_regular(0);
    }
    on_points(turns, letters, leader, near_one) {  // all equations A z = lambda z but the first one
      const {real, turning, sectors} = this, {zero, one} = real, n = turning.length, dual = sectors.lattice === 'dual';
      const first = near_one ? [zero, [real.W / 2n, real.W / 2n]] : [one, dual ? one : zero];
      const turned = (x, turn) => near_one ? turns.turned_near_one(x, turn, near_one.delta) : turns.turned(x, turn);
      const rows = range_of(2 * n - 2).map(() => range_of(2 * n - 1).map(() => zero)), last = 2 * n - 2;
      turning.slice(1).forEach((point, i) => {
        let fixed = [near_one ? near_one.decay : zero, zero];
        for (const term of rule_at(sectors, this.lattice, point)) {
          if ((term.ring !== null && term.ring !== 1) || is_vertex(sectors, term.at)) continue;
          const j = turning.findIndex(p => String(p) === String(term.at)) - 1, weight = weight_at(term, real, letters);
          const start = turned(j < 0 ? first : [zero, zero], term.turn);
          fixed = turns.plus(fixed, turns.scaled(weight, start));
          if (j < 0) continue;
          [[one, zero], [zero, one]].forEach((unit, part) => {
            const image = turned(unit, term.turn), linear = turns.scaled(weight, near_one ? turns.minus(image, start) : image);
            for (const k of [0, 1]) rows[2 * i + k][2 * j + part] = real.minus(rows[2 * i + k][2 * j + part], linear[k]);
          });
        }
        for (const k of [0, 1]) {
          rows[2 * i + k][2 * i + k] = real.plus(rows[2 * i + k][2 * i + k], leader);
          rows[2 * i + k][last] = fixed[k];
        }
      });
      const solution = this.solved(rows);
      return solution && new Map([...this.points.map(p => [String(p), [zero, zero]]), [String(turning[0]), first],
                                  ...turning.slice(1).map((p, i) => [String(p), solution.slice(2 * i, 2 * i + 2)])]);
    }
    solved(rows) {  // by elimination, with the pivot furthest from 0
      const {real} = this, from_zero = ([low, high]) => max(low, -high);
      for (let k = 0; k < rows.length; ++k) {
        let pivot = k;
        for (let i = k + 1; i < rows.length; ++i) if (from_zero(rows[i][k]) > from_zero(rows[pivot][k])) pivot = i;
        [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
        const divisor = rows[k][k];
        rows[k] = rows[k].map((x, j) => j < k ? x : real.quotient(x, divisor));
        if (rows[k].includes(null)) return null;
        rows.forEach((row, i) => {
          if (i !== k) rows[i] = row.map((x, j) => j < k ? x : real.minus(x, real.times(row[k], rows[k][j])));
        });
      }
      return rows.map(row => row[rows.length]);
    }
  }
  function check_vertex(reader, {sectors, not_c1, surface, dilation}) {
    const lattice = lattice_mask(surface, dilation);
    check_turns(sectors, lattice);
    check_own_rules(sectors);
    if (sectors.above) new Vertices(sectors, lattice, reader).check();
    else (not_c1 ? Vertex.check_not_c1 : Vertex.check_c1)(sectors, lattice, reader);
  }

  // ---- 4.16: fits of least absolute deviations ----------------------------------------------------------------------
  const choose = (n, k) => range_of(k).reduce((result, i) => result * (n - i) / (i + 1), 1);
  function read_l1(text) {
    const parts = text.split(',');
    demand(parts.length === 2 || parts.length === 3, 'a rule of least absolute deviations is N,DEGREE or N,DEGREE,ARITY');
    const points = small(parts[0], 2, 16), degree = small(parts[1], 0, points - 2);
    demand(choose(points, degree + 1) * 2 ** (points - degree - 1) <= 2 ** 18,
           'a rule with more signs than the checker allows');
    return {points, degree, arity: parts.length === 3 ? small(parts[2], 3, 16) : 2};
  }
  function read_contraction(fields, {degree, arity}) {
    demand(fields.length === 3, 'a contraction is STEPS, ORDER and BOUND');
    const steps = small(fields[0], 1, 8), order = small(fields[1], 1, degree + 1), bound = rational(fields[2]);
    demand(arity ** steps <= 256, 'more steps than the checker allows');
    demand(bound.n >= 0n, 'the bound of a contraction is negative');
    return {steps, order, bound};
  }
  // The vertices of U: each is found from signs of all places but degree + 1, by the Lagrange polynomials of those. All
  // numbers are below 2^53.
  function l1_vertices({points, degree}) {
    const found = new Set(), places = range_of(points);
    spend(choose(points, degree + 1) * 2 ** (points - degree - 1) * 2);
    const visit = (basis, from) => {
      if (basis.length <= degree) {
        for (let r = from; r < points; ++r) visit([...basis, r], r + 1);
        return;
      }
      const others = places.filter(r => !basis.includes(r));
      const lagrange = (b, x) => basis.reduce((product, c) => c === b ? product : product * (x - c), 1);
      const inner = basis.map(b => ({b, at: lagrange(b, b), values: others.map(r => lagrange(b, r))}));
      for (let signs = 0; signs < 2 ** others.length; ++signs) {
        const u = others.map((_, k) => signs >> k & 1 ? 1 : -1);
        const vertex = Array(points);
        others.forEach((r, k) => { vertex[r] = u[k] > 0 ? '+' : '-'; });
        if (inner.every(({b, at, values}) => {
          const ratio = -values.reduce((total, value, k) => total + u[k] * value, 0) * Math.sign(at);
          vertex[b] = ratio === Math.abs(at) ? '+' : ratio === -Math.abs(at) ? '-' : '0';
          return Math.abs(ratio) <= Math.abs(at);
        })) found.add(vertex.join(''));
      }
    };
    visit([], 0);
    return [...found].sort();
  }
  const is_full = (vertex, {degree}) => vertex.split('0').length === degree + 2;
  // Place r of a window and its outputs, from its centre in units of the spacing over twice the arity
  const l1_position = ({points, arity}, r) => BigInt(arity * (2 * r - points + 1));
  const l1_outputs = ({arity}) => range_of(arity).map(e => BigInt(2 * e + 1 - arity));
  // The polynomial through the data where the vertex has 0, and through the data plus 1 at the first other places
  function l1_fit(vertex, data, rule) {
    const {degree} = rule, places = range_of(vertex.length), at = r => l1_position(rule, r);
    const nodes = [...places.filter(r => vertex[r] === '0').map(r => [r, data[r]]),
                   ...places.filter(r => vertex[r] !== '0').map(r => [r, plus(data[r], 1n)])].slice(0, degree + 1);
    return x => nodes.reduce((total, [r, y]) => {
      spend(100 * nodes.length, bits(y.n), bits(y.d));
      return reduced(plus(total, nodes.reduce(
        (term, [c]) => c === r ? term : over(times(term, x - at(c)), at(r) - at(c)), y)));
    }, fraction(0n));
  }
  // The tree of a difference: D^order f at the place `start` of level `steps`
  class CellTree {
    constructor(reader, rule, vertices, contraction, start) {
      const {points, degree, arity} = rule;
      Object.assign(this, {reader, rule, points, degree, arity, vertices, ...contraction, start, leaves: [], kept: 0});
      this.levels = [];  // the windows of each: first, last, and the number of the first one in the order of all
      for (let low = start, high = start + this.order, level = this.steps; level-- > 0; high += points - 1) {
        [low, high] = [Math.floor(low / arity), Math.floor(high / arity)];
        this.levels[level] = {low, high};
      }
      this.level_of = [];
      this.levels.forEach((level, k) => {
        level.number = this.level_of.length;
        for (let i = level.low; i <= level.high; ++i) this.level_of.push(k);
      });
      this.cells = this.level_of.map(() => this.cell_of(vertices));
      this.full = vertex => is_full(vertex, rule);
      this.powers = range_of(points).map(r => range_of(degree + 1).map(k => l1_position(rule, r) ** BigInt(k)));
      this.at_outputs = l1_outputs(rule).map(x => range_of(degree + 1).map(k => x ** BigInt(k)));
    }
    node() {
      const word = this.reader.peek();
      if (word === 'side') this.side();
      else if (word === 'split') this.split();
      else if (word === 'again') this.again();
      else if (word === 'thin') this.thin();
      else this.leaf();
    }
    // The vertices that are possible for a window, and the signs that some of them have at each place
    cell_of(vertices) {
      spend(vertices.length * this.points / 50);
      const some = sign => range_of(this.points).map(r => vertices.some(vertex => vertex[r] === sign));
      return {vertices, plus: some('+'), minus: some('-')};
    }
    parts(w, lists) {
      const all = this.cells[w];
      for (const list of lists) {
        this.cells[w] = this.cell_of(list);
        this.node();
      }
      this.cells[w] = all;
    }
    window_of(token) { return small(token, 0, this.cells.length - 1); }
    side() {
      const fields = this.reader.read('side', 3), w = this.window_of(fields[0]), r = small(fields[1], 0, this.points - 1);
      demand(['+', '-', '0', '+-', '+0', '-0'].includes(fields[2]), 'signs are +, -, 0 or two of these, in this order');
      const has = vertex => fields[2].includes(vertex[r]), all = this.cells[w].vertices;
      const lists = [all.filter(has), all.filter(vertex => !has(vertex))];
      demand(lists.every(list => list.length), 'a side without a vertex');
      this.parts(w, lists);
    }
    split() {
      const w = this.window_of(this.reader.read('split', 1)[0]);
      demand(!this.only_vertex(w), 'a window is split that has one vertex');
      this.parts(w, this.cells[w].vertices.map(vertex => [vertex]));
    }
    only_vertex(w) { return this.cells[w].vertices.length === 1 ? this.cells[w].vertices[0] : null; }
    again() {
      const number = integer(this.reader.read('again', 1)[0]);
      demand(number >= 0n && number < BigInt(this.leaves.length), 'there is no leaf of that number yet');
      this.check_signs(this.leaves[Number(number)]);
    }
    leaf() {
      const [scale_token, ...tokens] = this.reader.read('leaf', this.cells.length * this.points + 1);
      const scale = integer(scale_token);
      demand(scale > 0n, 'a denominator must be positive');
      const multipliers = this.multipliers(tokens);
      demand((this.kept += multipliers.length) <= 2 ** 22, too_much_work);
      this.check_signs(multipliers);
      let form = this.form_on_data(multipliers, scale);
      for (let i = 0; i < this.order; ++i) {
        let total = 0n;
        form = form.map(x => total += x);
      }
      const {n, d} = this.bound;
      demand(norm(form) * d <= n * scale, 'the multipliers of a leaf do not prove the bound');
      this.leaves.push(multipliers);
    }
    thin() {
      const multipliers = this.multipliers(this.reader.read('thin', this.cells.length * this.points));
      this.check_signs(multipliers);
      demand(this.form_on_data(multipliers, 0n).every(x => !x), 'the residuals of a thin cell do not sum to 0');
      demand(this.vertices.every(this.full) || multipliers.every(({w}) => this.level_of[w] < 2),
             'a cell that is thin from level 2 on, and a degenerate vertex');
      const strict = multipliers.filter(({w, r}) => (this.only_vertex(w) || '0'.repeat(this.points))[r] !== '0');
      demand(strict.some(({w}) => this.level_of[w] === 0) || this.is_residual(strict),
             'no inequality of a thin cell is shown to be one');
    }
    multipliers(tokens) {  // those that are not 0
      spend(tokens.length / 2);
      const result = [];
      tokens.forEach((token, k) => {
        if (token === '0') return;
        const value = integer(token), w = Math.floor(k / this.points), r = k % this.points;
        spend(this.degree + 1, bits(value), 64);
        result.push({w, r, value});
      });
      return result;
    }
    check_signs(multipliers) {
      spend(1 + multipliers.length / 2);
      for (const {w, r, value} of multipliers)
        demand(!this.cells[w][value > 0n ? 'minus' : 'plus'][r], 'a multiplier has the wrong sign');
    }
    // What is left of the difference, times the scale, when the fits are replaced from the last level to the first
    form_on_data(multipliers, scale) {
      let value = new Map(), k = multipliers.length;  // coefficients of the data of a level
      for (let i = 0; i <= this.order; ++i)
        value.set(this.start + i, scale * BigInt((this.order - i) % 2 ? -choose(this.order, i) : choose(this.order, i)));
      for (let level = this.steps - 1; level >= 0; --level) {
        const {low, high, number} = this.levels[level], next = new Map();
        const moments = range_of(high - low + 1).map(() => Array(this.degree + 1).fill(0n));
        for (; k && multipliers[k - 1].w >= number; --k) {
          const {w, r, value: multiplier} = multipliers[k - 1], i = w - number;
          next.set(low + i + r, (next.get(low + i + r) || 0n) + multiplier);
          this.powers[r].forEach((x, j) => { moments[i][j] += multiplier * x; });
        }
        spend(moments.length * (this.degree + 1) / 2);
        moments.forEach((all, i) => {
          const outputs = this.at_outputs.map((_, e) => value.get(this.arity * (low + i) + e) || 0n);
          demand(all.every((x, j) => x === outputs.reduce((sum, v, e) => sum + v * this.at_outputs[e][j], 0n)),
                 'the multipliers of a window do not take its fit away');
        });
        value = next;
      }
      const {low, high} = this.levels[0];
      return range_of(high - low + this.points).map(m => value.get(low + m) || 0n);
    }
    // Whether one of these residuals, of windows with full vertices, is not 0 at the point of Theorem 36
    is_residual(strict) {
      const {low} = this.levels[0], known = new Map();  // [level, place] -> value
      const data_of = (level, i) => range_of(this.points).map(r => level ? known.get(`${level} ${i + r}`)
                                                                     : fraction(1009n ** BigInt(i + r - low)));
      return this.levels.some((one, level) => range_of(one.high - one.low + 1).some(k => {
        const vertex = this.only_vertex(one.number + k), i = one.low + k, data = data_of(level, i);
        if (!vertex || data.includes(undefined)) return false;
        const fit = l1_fit(vertex, data, this.rule);
        l1_outputs(this.rule).forEach((x, e) => known.set(`${level + 1} ${this.arity * i + e}`, fit(x)));
        return this.full(vertex) && strict.some(({w, r}) => w === one.number + k && minus(data[r], fit(l1_position(this.rule, r))).n);
      }));
    }
  }
  function refined(reader, l1, vertices, values) {  // the next level of an orbit
    const {points} = l1, count = values.length - points + 1;
    demand(2 * count <= 4096, too_much_work);
    return reader.read('fits', count).flatMap((vertex, i) => {
      demand(vertices.has(vertex) && is_full(vertex, l1), 'a fit is not that of a full vertex');
      const data = values.slice(i, i + points), fit = l1_fit(vertex, data, l1);
      data.forEach((y, r) => {
        const residual = sign(minus(y, fit(l1_position(l1, r))));
        demand(vertex[r] === '0' || residual === 0 || (vertex[r] === '+') === (residual > 0),
               'a residual has not the sign of the vertex');
      });
      return l1_outputs(l1).map(fit);
    });
  }
  function has_run(values, length) {  // of one sign
    let run = 0, last = 0;
    return values.map(sign).some(now => {
      run = now && now === last ? run + 1 : now ? 1 : 0;
      last = now;
      return run === length;
    });
  }
  // Values that are met again, times the factor, after some steps, with a limit that is not 0
  function read_orbit(reader, l1) {
    demand(l1.degree < 2, 'an orbit of fits of a degree above 1 proves nothing');
    demand(l1.arity === 2, 'an orbit of a rule that is not binary proves nothing');
    const length = 2 * l1.points - 1, fields = reader.read('orbit', 3 + length, 3 + 4096);
    const steps = small(fields[0], 1, 8), factor = rational(fields[2]), power_of_2 = /^10*$/;
    let place = small(fields[1], 0, 4096);
    demand(abs(factor.n) !== 1n || !power_of_2.test(factor.d.toString(2)), 'the factor of an orbit is a power of 1/2');
    const levels = [fields.slice(3).map(token => fraction(integer(token)))], vertices = new Set(l1_vertices(l1));
    for (let level = 1; level <= steps || reader.peek() === 'fits'; ++level) {
      const now = refined(reader, l1, vertices, levels[level - 1]);
      levels.push(now);
      if (level < steps) continue;
      const before = levels[level - steps];
      demand(place + before.length <= now.length, 'the values of an orbit are met again outside of what is known');
      spend(before.length);
      demand(before.every((x, i) => !minus(now[place + i], times(factor, x)).n), 'the values of an orbit are not met again');
      place *= 2;
    }
    demand(has_run(levels[levels.length - 1], length), 'an orbit has too few values of one sign next to each other');
    return {steps, factor};
  }
  function check_l1(reader, {l1, lower, upper, contraction}) {
    const proved = read_contraction(reader.read('contraction', 3), l1), vertices = l1_vertices(l1);
    const {steps, order, bound} = proved, {points, arity} = l1, starts = arity ** steps;
    const levels = (starts - 1) / (arity - 1);  // 1 + A + ... + A^(K-1)
    for (let start = 0; start < starts; ++start) {
      const mirror = (arity * (2 - points) - 1) * levels - order - start, rest = (mirror % starts + starts) % starts;
      if (start > rest) continue;
      reader.read(`start ${start}`);
      new CellTree(reader, l1, vertices, proved, start).node();
    }
    demand(!contraction || (contraction.steps === steps && contraction.order === order &&
                            contraction.bound.n === bound.n && contraction.bound.d === bound.d),
           'the claim is about another contraction');
    if (lower) {
      const exponent = times(lower, BigInt(steps));
      check_ends(exponent, null, 1);
      demand(!less(power_below(BigInt(l1.arity), minus(0n, exponent)), bound), 'the contraction does not prove the lower end');
    }
    if (!upper && reader.peek() !== 'orbit') return;
    demand(less(bound, 1n), 'an orbit proves nothing where no limits are proved');
    const orbit = read_orbit(reader, l1), exponent = upper && times(upper, BigInt(orbit.steps));
    check_ends(null, exponent, 0);
    demand(!upper || !less(abs_of(orbit.factor), over(1n, power_below(2n, exponent))), 'the orbit does not prove the upper end');
  }

  // ---- The claim and the command line -------------------------------------------------------------------------------
  const usage = `usage: subcert-check --mask '[c0,c1,...]/D@first' --arity A [--lower P/Q [--upper P/Q]] FILE
       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --for 'w=LOW..HIGH'
                     [--lower P/Q] [--upper P/Q] FILE    (for all these w; <, not <=)
       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --levels 'w=LOW..HIGH' --lower P/Q FILE
                     (for all sequences of these w, one for each level; <, not <=)
       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --each-point 'w=LOW..HIGH' --lower P/Q FILE
                     (for all choices of these w, one for each new point of each level)
       subcert-check ... --levels RANGE --recurrence '[P]/(Q)' --start LOW..HIGH --from K --lower P/Q FILE
                     (for those that follow from each other; sqrt[P]/(Q); LOW..inf --from some)
       subcert-check --mask ... --levels RANGE --recurrence ... --limit V [--lower P/Q [--upper P/Q]] FILE
                     (for those that tend to V; <=; --exact as below)
       subcert-check --masks 'MASK;MASK;...' --arity A --order any --lower P/Q [--upper P/Q] FILE    (for all sequences
                     of these masks, and the upper end for one of them; follows=0-1,1-0,...: for those where each pair is one of these)
       subcert-check --masks ... --arity A --order period=0,1,...    (in turn; the rest as with --mask)
       subcert-check --mask MASK --arity A [--for RANGE] --upper CK FILE    (no C^K limits, K = 1, 2, ...)
       subcert-check --mask MASK --arity A --within EPS,M [--lower P/Q [--upper P/Q]] FILE    (for all masks
                     within EPS of MASK that have M sum rules)
       subcert-check --surface '[[c00,c10,...],...]/D@first,first' --dilation '[2,0;0,2]'
                     --lower P/Q [--upper P/Q] FILE
       subcert-check --surface ... --vertex 'triangles:N;0,0=WEIGHT@0,0,0|WEIGHT@1,0~0' FILE    (and limits of almost
                     all data are C^1 around a vertex of valence N, or with N+ of N and above; quads:N, dual:N;
                     --not-c1 RULES: are not, N alone)
       subcert-check --refinable '[[[a,b],[c,d]],...]/D@first' --dilation '[2]'
                     [--integral X0,X1,...] [--component C] --lower P/Q [--upper P/Q] FILE    (of the continuous
                     phi = sum_k A_k phi(M x - k), one up to a factor; or the one with this integral; of phi_C
                     alone, C = 0, 1, ...)
       subcert-check --vectors '[[[a,b],[c,d]],...]@first' --arity A [--for 'w=LOW..HIGH'] --lower P/Q FILE
                     (the limits of f'_i = sum_j A_(i-aj)^T f_j, for all these w; <, not <=; --upper 0: it diverges;
                     --levels and what belongs to it in place of --for, as above; 'MASK;MASK;...' with --order:
                     for all sequences of these masks, <=)
       subcert-check --vectors MASK --dilation '[2,0;0,2]' --lower 0 FILE    (this scheme converges; --upper 0: it does
                     not)
       subcert-check --hermite MASK --arity A [--for RANGE] --lower K FILE    (it is HC^K; --upper K: it is not)
       subcert-check --matrices MATRICES [--lower P/Q] [--upper P/Q] FILE    (at least one bound)
       subcert-check --subradius MATRICES [--lower P/Q] [--upper P/Q] FILE    (the joint spectral subradius)
       subcert-check --l1 N,D[,A] [--contraction STEPS,ORDER,P/Q] [--lower P/Q [--upper P/Q]] FILE    (fits of degree D
                     to N points by least absolute deviations: |D^ORDER S^STEPS f| <= P/Q |D^ORDER f|; exponents of
                     limits)
       subcert-check ... --exact 'M-log|[p0,p1,...]@RE,IM,EPS|^1/L' FILE    (exponents: M less the logarithm to the
                     base A of |z|^(1/L), z the only zero of p0 + p1 x + ... within EPS of RE + i IM; radii: without
                     M-log; beside bounds, or without)
       subcert-check --mask MASK --arity A --within EPS,M[,symmetric] --attains T1,T2,... FILE    (exponents: M less the
                     logarithm of the spectral radius of the product T1 T2 ... of L matrices to the power 1/L)
       subcert-check --mask ... --exact ... --logarithm P FILE    (the modulus of continuity takes |log h|^P; so with
                     --attains)
a mask and no bounds: its integer shifts are stable
prints VERIFIED <claim> (exit 0) or REJECTED <why, line n> (exit 1)
exit 64: wrong usage, 65: malformed MATRICES, 66: missing file`;
  function read_options(words) {
    const names = ['mask', 'masks', 'order', 'arity', 'for', 'levels', 'each-point', 'recurrence', 'start', 'from', 'limit', 'within', 'surface', 'refinable', 'integral', 'component', 'vertex', 'not-c1', 'dilation', 'vectors',
                   'hermite', 'matrices', 'subradius', 'l1', 'contraction', 'lower', 'upper', 'exact', 'attains', 'logarithm'];
    const options = {};
    for (let i = 0; i < words.length; ++i) {
      const named = words[i].startsWith('--'), option = named ? words[i].slice(2) : 'FILE';
      demand(!named || names.includes(option), `unknown option ${words[i]}`);
      if (named) ++i;
      demand(i < words.length && !(option in options), `${words[i - 1]} needs a value, and only one`);
      options[option] = words[i];
    }
    const has = (...all) => all.every(name => name in options), some = (...all) => all.some(name => name in options);
    const none = (...all) => !some(...all);
    const rough = has('upper') && options.upper.startsWith('C');
    const in_period = has('order') && options.order.startsWith('period'), follow = has('masks') && !in_period;
    const list_of_matrices = none('masks') && has('order');
    const of_levels = ['for', 'levels', 'each-point', 'within'].filter(name => has(name)).length <= 1 && (none('levels', 'each-point') || has('limit') || (has('lower') && none('upper'))) &&
      ['recurrence', 'start', 'from'].every(name => has(name) === has('from')) && (has('levels') || none('from')) &&
      (none('limit') || (has('mask', 'from') && some('lower', 'exact') && !rough && none('logarithm')));
    const curve = of_levels && has('mask') !== has('masks') && has('arity') && none('surface', 'refinable', 'integral', 'component', 'vertex', 'not-c1', 'dilation', 'matrices', 'subradius') &&
      (!follow || (has('lower') && !rough)) && has('masks') === has('order') &&
      (none('masks') || none('for', 'levels', 'each-point', 'within')) && !(follow && has('exact')) &&
      (!has('upper') || some('lower', 'for', 'exact', 'attains') || (rough && none('within'))) && !(rough && has('within')) &&
      !(has('exact') && (some('for', 'each-point', 'within') || (has('levels') && none('limit')))) && !(has('logarithm') && none('exact', 'attains')) &&
      !(has('attains') && none('within'));
    const surface = has('surface') !== has('refinable') && has('dilation') && some('lower', 'exact') && !rough &&
      (has('refinable') || none('integral', 'component')) && (none('vertex', 'not-c1') || has('surface', 'lower')) && !has('vertex', 'not-c1') &&
      none('mask', 'masks', 'order', 'recurrence', 'start', 'from', 'limit', 'arity', 'for', 'levels', 'each-point', 'within', 'matrices', 'subradius', 'attains', 'logarithm');
    const family = has('matrices') !== has('subradius') && some('lower', 'upper', 'exact') && !rough &&
      none('mask', 'masks', 'order', 'recurrence', 'start', 'from', 'limit', 'arity', 'for', 'levels', 'each-point', 'within', 'surface', 'refinable', 'integral', 'component', 'vertex', 'not-c1', 'dilation', 'attains', 'logarithm');
    const in_variables = has('vectors', 'dilation') && some('lower', 'upper') && ['lower', 'upper'].every(end => !has(end) || !sign(rational(options[end])));
    const of_dilation = in_variables && !has('lower', 'upper') && none(...names.filter(name => !['vectors', 'dilation', 'lower', 'upper'].includes(name)));
    const of_vectors = of_levels && has('vectors') !== has('hermite') && has('arity') && has('lower') !== has('upper') &&
      (!has('vectors', 'upper') || !sign(rational(options.upper))) &&
      !(list_of_matrices && (some('for', 'levels') || none('lower'))) &&
      none(...names.filter(name => !['vectors', 'hermite', 'arity', 'order', 'for', 'levels', 'recurrence', 'start', 'from', 'lower', 'upper'].includes(name)));
    const l1 = has('l1') && some('contraction', 'lower') && (has('lower') || none('upper')) && !rough &&
      none(...names.filter(name => !['l1', 'contraction', 'lower', 'upper'].includes(name)));
    const others = none('l1', 'contraction', 'vectors', 'hermite');
    demand(has('FILE') && (l1 || of_vectors || of_dilation || ((curve || surface || family) && others)), usage);
    const of_family = has('subradius') ? check_subradius : check_radius;
    return {options, rough, kind: l1 ? check_l1 : of_dilation ? check_vectors_of_dilation : of_vectors ? check_vectors : curve ? (follow || has('each-point') ? check_choices : check_curve) : surface ? check_surface : of_family};
  }
  // The claim: what the checks need, the second line of its certificate, and the text of what is proved
  function read_claim(words) {
    const {options, rough, kind} = read_options(words);
    if (kind === check_l1) return read_l1_claim(options);
    const claim = {options, kind, lower: options.lower === undefined ? null : rational(options.lower), upper: null};
    if (kind === check_radius) claim.of_family = {what: 'radius', file: options.matrices};
    if (kind === check_subradius) claim.of_family = {what: 'subradius', file: options.subradius};
    if (options.exact !== undefined) read_exact(options.exact, !claim.of_family);
    if (options.logarithm !== undefined) claim.logarithm = small(options.logarithm, 0, 256);
    if (rough) claim.rough = small(options.upper.slice(1), 1, 500);
    else if (options.upper !== undefined) claim.upper = rational(options.upper);
    if (kind === check_surface) {
      const kind_of = options.surface === undefined ? 'refinable' : 'surface', text = options[kind_of];
      const of_matrices = kind_of === 'refinable', of_root = [text, options.integral || ''].find(x => of_matrices && x.includes('sqrt('));
      claim.surface = of_root === undefined ? read_surface(text, of_matrices) : read_over_field(text, read_root_in(of_root));
      claim.dilation = read_dilation(options.dilation);
      demand(claim.surface.dimension === claim.dilation.length, 'mask and dilation have different numbers of variables');
      claim.head = `${kind_of} ${text} ${options.dilation}`;
      for (const kind of ['vertex', 'not-c1']) {
        if (options[kind] === undefined) continue;
        demand(less(1n, claim.lower), 'smoothness around a vertex needs limits with an exponent above 1');
        claim.sectors = read_sectors(options[kind]);
        claim.not_c1 = kind === 'not-c1';
        demand(!claim.not_c1 || !claim.sectors.above, 'what is not C^1 is so around one valence');
        claim.head += ` ${kind}=${options[kind]}`;
      }
      const functions = claim.surface.components / (claim.surface.root ? 2 : 1);
      if (options.integral !== undefined) {
        const numbers = options.integral.split(','), parts = claim.surface.root && numbers.map(number_over_field(claim.surface.root));
        claim.integral = parts ? [0, 1].flatMap(k => parts.map(x => x[k])) : numbers.map(rational);
        demand(numbers.length === functions && claim.integral.some(x => sign(x)),
               'an integral is a list of a number for each component, not all 0');
        claim.head += ` integral=${options.integral}`;
      }
      if (options.component !== undefined) {
        claim.component = small(options.component, 0, functions - 1);
        claim.head += ` component=${options.component}`;
      }
    } else if (kind === check_vectors_of_dilation) {
      claim.surface = options.vectors.includes('sqrt(') ? read_over_field(options.vectors, read_root_in(options.vectors)) : read_surface(options.vectors, true);
      claim.dilation = read_dilation(options.dilation);
      demand(claim.surface.dimension === claim.dilation.length, 'mask and dilation have different numbers of variables');
      claim.head = `vectors ${options.vectors} ${options.dilation}`;
    } else if (kind === check_vectors) {
      claim.hermite = options.hermite !== undefined;
      const kind_of = claim.hermite ? 'hermite' : 'vectors', letter = read_range_of(options, claim);
      if (claim.hermite) small(options.lower === undefined ? options.upper : options.lower, 0, 500);
      const arity = small(options.arity, 2, 16);
      if (options.order !== undefined) {
        claim.list = read_list_of_matrices(options[kind_of], arity, options.order);
        claim.curve = masks_as_powers(claim.list);
        claim.head = `lists ${options[kind_of]} ${options.arity} ${options.order} ${kind_of}`;
        return claim;
      }
      claim.curve = letter || !options[kind_of].includes('sqrt(') ? read_curve(options[kind_of], arity, letter, 2) : read_field_curve(options[kind_of], arity);
      claim.head = `${kind_of} ${options[kind_of]} ${options.arity}${claim.values}${claim.levels ? ' levels' : ''}${claim.following}`;
    } else if (options.masks !== undefined) {
      claim.list = read_list(options.masks, small(options.arity, 2, 16), options.order);
      if (kind === check_curve) claim.curve = masks_in_one(claim.list, claim.list.period);
      claim.head = `lists ${options.masks} ${options.arity} ${options.order}`;
    } else if (kind === check_curve || kind === check_choices) {
      const arity = small(options.arity, 2, 16);
      const letter = read_range_of(options, claim);
      if (options.within !== undefined) claim.within = read_rounding(options.within);
      if (options.attains !== undefined) read_letters(options.attains);
      claim.curve = read_curve(options.mask, arity, letter);
      claim.head = `${claim.levels ? 'levels' : kind === check_choices ? 'each-point' : 'exponent'} ${options.mask} ${options.arity}${claim.values}` +
        (claim.within ? ` within=${options.within}` : '') + claim.following;
      if (options.limit !== undefined) read_limit_of(options, claim);
    }
    return claim;
  }
  function read_limit_of({limit}, claim) {  // what is left is about the mask in the limit
    claim.tending = {curve: claim.curve, range: claim.interval, recurrence: claim.recurrence, limit: rational(limit)};
    claim.curve = curve_at(claim.curve, claim.tending.limit);
    [claim.interval, claim.recurrence] = [undefined, undefined];
    claim.head += ` limit=${limit}`;
  }
  function read_l1_claim(options) {
    const l1 = read_l1(options.l1), lower = options.lower === undefined ? null : rational(options.lower);
    const contraction =
      options.contraction === undefined ? null : read_contraction(options.contraction.split(','), l1);
    const upper = options.upper === undefined ? null : rational(options.upper);
    return {options, kind: check_l1, l1, contraction, lower, upper, head: `l1 ${l1.points} ${l1.degree}${l1.arity === 2 ? '' : ` ${l1.arity}`}`};
  }
  function read_range_of(options, claim) {  // its letter, or null; sets of the claim what is about its values
    const {recurrence: step, start, from} = options, range = [options['each-point'], options.levels, options.for].find(x => x !== undefined);
    const letter = range === undefined ? null : read_range(range, claim), follow = step !== undefined;
    claim.levels = options.levels !== undefined;
    if (follow) claim.recurrence = read_following(step, start, from, letter);
    claim.values = letter ? ` ${range}` : '';
    claim.following = follow ? ` recurrence=${step} start=${start} from=${from}` : '';
    return letter;
  }
  function read_range(text, claim) {
    const [, letter, low, high] = /^([a-zA-Z])=(.*?)\.\.(.*)$/s.exec(text) || [];
    const form = 'a range is w=LOW..HIGH with rationals LOW < HIGH';
    demand(letter, form);
    claim.interval = {low: rational(low), high: rational(high)};
    demand(less(claim.interval.low, claim.interval.high), form);
    return letter;
  }
  function read_rounding(text) {
    const [eps, order, symmetric, more] = text.split(',');
    const form = 'a rounding is EPS,M or EPS,M,symmetric with EPS > 0 and the number M of sum rules';
    demand(order !== undefined && [undefined, 'symmetric'].includes(symmetric) && more === undefined, form);
    const rounding = {eps: rational(eps), order: small(order, 1, 500), symmetric: symmetric !== undefined};
    demand(sign(rounding.eps) > 0, form);
    return rounding;
  }
  const number = x => x.d === 1n ? `${x.n}` : `${x.n}/${x.d}`;
  function text_of_l1({options, contraction, lower, upper}) {
    const {steps, order, bound} = contraction || {};
    return [lower && `${number(lower)} <= Hoelder exponent${upper ? ` <= ${number(upper)}` : ''}`,
            contraction && `|D^${order} S^${steps} f| <= ${number(bound)} |D^${order} f|`].filter(x => x).join(' and ') +
      ` of least absolute deviations ${options.l1}`;
  }
  function text_of_vectors({options, hermite, lower, upper, levels, interval, list}) {
    const what = hermite ? `${upper ? 'no ' : ''}HC^${number(lower || upper)}`
      : upper ? 'no convergence' : `${number(lower)} ${list ? '<=' : '<'} Hoelder exponent`;
    return `${what} of the ${hermite ? 'Hermite' : 'vector'} scheme of ${options.hermite || options.vectors} with ` +
      (options.dilation === undefined ? `arity ${options.arity}` : `dilation ${options.dilation}`) +
      (list ? text_of_order(options) : text_of_values(options, levels, interval));
  }
  const text_of_order = ({order}) => ' for all sequences of levels' + (order === 'any' ? '' : ` with ${order}`);
  function text_of_levels({recurrence, start, from, limit, levels: range}) {
    const letter = range[0], level = from === 'some' ? 'some level' : `level ${from}`;
    return recurrence === undefined ? ` for all sequences of levels with ${range}`
      : ` from ${level} on of ${letter} -> ${recurrence} with ${letter}=${start} at level 0, all in ${range}` + (limit === undefined ? '' : `, tending to ${limit}`);
  }
  const text_of_values = (options, levels, interval) => levels ? text_of_levels(options) : !interval ? ''
    : options.for === undefined ? ` for all choices for each new point of ${options['each-point']}` : ` for all ${options.for}`;
  function text_of({options, of_family, lower, upper, rough, interval, levels, list}) {
    const relation = interval && options['each-point'] === undefined ? ' < ' : ' <= ';
    const least = list && !list.period.length && upper ? 'least ' : '';  // of all sequences
    let what = of_family ? `joint spectral ${of_family.what}` : `${least}Hoelder exponent`;
    const {attains} = options, product = attains === undefined ? []
      : [`${small(options.within.split(',')[1], 1, 500)}-log rho(${attains})^1/${attains.split(',').length}`];
    const [number_text = options.exact] = product, exact = number_text !== undefined, power =
      options.logarithm === undefined ? '' : ` with |log h|^${options.logarithm}`;
    const number_itself = exact ? `${what} = ${number_text}` : what;
    if (rough) what = `${lower || exact ? `${number_itself} and ` : ''}no C^${rough} limits`;
    else what = lower || upper || exact ? number_itself : 'stable integer shifts of the refinable distribution';
    if (!lower && interval && upper) what = `no convergence, or ${what}`;
    const ends = !lower && interval && upper && !sign(upper) ? 'no convergence'
      : `${lower ? number(lower) + relation : ''}${what}${upper ? relation + number(upper) : ''}${power}`;
    const one = options.component === undefined ? '' : `component ${options.component} of `;
    const mask = options.refinable === undefined ? options.surface : `${one}the refinable functions of ${options.refinable}`;
    const subject = of_family ? of_family.file : mask !== undefined ? `${mask} with dilation ${options.dilation}${options.integral === undefined ? '' : ` and integral ${options.integral}`}` +
        (options.vertex === undefined ? '' : `, and C^1 limits of almost all data around ${options.vertex}`) +
        (options['not-c1'] === undefined ? '' : `, and no C^1 limits of almost all data around ${options['not-c1']}`)
      : `${options.mask || options.masks} with arity ${options.arity}`;
    const of_list = list && (list.period.length ? ` for levels with ${options.order}` : text_of_order(options));
    return `${ends} of ${subject}` +
      (list ? of_list : text_of_values(options, levels, interval)) +
      (options.within ? ` for all masks within=${options.within}` : '');
  }
  function read_matrices(reader) {
    const [count, size] = reader.read('matrices', 2).map((token, i) => small(token, 1, i ? 256 : 4096));
    demand(count * size * size <= 2 ** 22, 'more entries than 2^22');
    const rows = reader.rows('row', count * size, size, rational), {den, numbers} = common(rows.flat());
    reader.finish(null, 'text after the last row');
    const row = i => numbers.slice(i * size, (i + 1) * size);
    return {size, den, matrices: range_of(count).map(t => range_of(size).map(i => row(t * size + i)))};
  }
  function read_bounds(reader) {  // read, and not used
    const [lower, upper] = reader.read('bounds', 2);
    if (lower !== '-') rational(lower);
    if (upper.startsWith('C')) small(upper.slice(1), 1, 500);
    else if (upper !== '-') rational(upper);
  }
  function check_file(reader, claim) {
    reader.read('subcert-certificate 3');
    reader.read(claim.head);
    const is_subradius = claim.kind === check_subradius;
    demand(!is_subradius || claim.family.matrices.flat(2).every(x => x >= 0n), 'a matrix is not non-negative');
    read_bounds(reader);
    const one = !claim.interval && !claim.within && ![check_vectors, check_vectors_of_dilation].includes(claim.kind);
    demand(one || reader.peek() !== 'exact', 'exact numbers are those of one mask or family');
    claim.exact = claim.l1 ? null : claim.within ? read_attains(reader, claim) : read_root(reader, claim);
    claim.kind(reader, claim);
    if (claim.sectors) check_vertex(reader, claim);
    reader.finish('end', "text after 'end'");
  }

  // What went wrong, in words. Limits of the engine, on lengths of numbers and texts, are errors of several names in
  // several engines; a fault of this program never proves anything.
  function reason(error) {
    if (error instanceof Rejection) return error.message;
    return error instanceof RangeError ? too_much_work : `internal error (${error})`;
  }
  // words: the command line; read_text(path): the bytes of a file as a text of characters 0 to 255, null where there is
  // none. Returns {exit, line}; the line is meant for standard output for exit 0 and 1, else for standard error.
  return function check_certificate(words, read_text) {
    work = 0;
    if (words.length === 1 && words[0] === '--help') return {exit: 0, line: usage};
    let claim, reader = {line: 0};
    const wrong = (exit, why) => ({exit, line: `subcert-check: ${why}`});
    try {
      claim = read_claim(words);
    } catch (error) {
      return wrong(64, reason(error));
    }
    const {options: {FILE}, of_family} = claim, text = of_family ? read_text(of_family.file) : '';
    if (text === null) return wrong(66, `cannot read ${of_family.file}`);
    try {
      if (of_family) {
        reader = new Reader(text);
        claim.family = read_matrices(reader);
        claim.head = `${of_family.what} ${claim.family.matrices.length} ${claim.family.size}`;
      }
    } catch (error) {
      return wrong(65, `${reason(error)}, line ${reader.line}`);
    }
    const certificate = read_text(FILE);
    if (certificate === null) return wrong(66, `cannot read ${FILE}`);
    reader = {line: 0};
    try {
      reader = new Reader(certificate);
      check_file(reader, claim);
    } catch (error) {
      return {exit: 1, line: `REJECTED ${reason(error)}, line ${reader.line}`};
    }
    const words_of = claim.l1 ? text_of_l1 : [check_vectors, check_vectors_of_dilation].includes(claim.kind) ? text_of_vectors : text_of;
    return {exit: 0, line: `VERIFIED ${words_of(claim)}`};
  };
})();

if (typeof module === 'object') module.exports = {check_certificate};
if (typeof require === 'function' && typeof module === 'object' && require.main === module) {
  console.error('checker.js alone checks nothing: node main.js takes the arguments');  // 0 would look like VERIFIED
  process.exitCode = 64;
}
