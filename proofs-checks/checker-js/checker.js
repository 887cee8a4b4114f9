// Checks certificates about subdivision schemes, written from ../certificates/SPEC.md alone; sections, theorems and lemmas
// are those of SPEC.md. All numbers that decide are BigInts, or Numbers that are small integers. A plain script: one
// global function, no module, no node, no DOM.
'use strict';

var check_certificate = (() => {
  // ---- Refusals and work ---------------------------------------------------------------------------------------------
  class Rejection extends Error {}
  const demand = (condition, why) => { if (!condition) throw new Rejection(why); };

  // Section 2: the work is counted in products of 64-bit limbs; an operation costs 40 of them besides.
  const max_work = 8e9, max_bits = 2 ** 32, too_much_work = 'more work than the checker allows';
  let work = 0;
  const spend = (operations, bits_a = 64, bits_b = 64) => {
    const a = Math.ceil(bits_a / 64), b = Math.ceil(bits_b / 64);
    work += operations * (40 + Math.max(a, b) * Math.min(a, b, 64));
    demand(work <= max_work, too_much_work);
  };
  const allow_bits = bits => demand(bits <= max_bits, too_much_work);

  // ---- Integers and fractions ----------------------------------------------------------------------------------------
  const abs = x => x < 0n ? -x : x;
  const max = (x, y) => x < y ? y : x;
  const sum = numbers => numbers.reduce((x, y) => x + y, 0n);
  const norm = numbers => numbers.reduce((total, x) => x < 0n ? total - x : total + x, 0n);  // |x|_1
  const largest = numbers => numbers.reduce((most, x) => x > most ? x : -x > most ? -x : most, 0n);
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

  // A fraction {n, d} has d > 0; it is not reduced, but where it is read.
  const fraction = (n, d = 1n) => ({n, d});
  const reduced = x => { const g = gcd(x.n, x.d); return fraction(x.n / g, x.d / g); };
  const plus = (x, y) => fraction(x.n * y.d + y.n * x.d, x.d * y.d);
  const minus = (x, y) => fraction(x.n * y.d - y.n * x.d, x.d * y.d);
  const times = (x, y) => fraction(x.n * y.n, x.d * y.d);
  const over = (x, y) => y.n < 0n ? fraction(-x.n * y.d, -x.d * y.n) : fraction(x.n * y.d, x.d * y.n);
  const sign = x => x.n < 0n ? -1 : x.n > 0n ? 1 : 0;
  const less = (x, y) => x.n * y.d < y.n * x.d;
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

  // 4.2: at most base^e
  function power_below(base, e) {
    const whole = floor_div(e.n, e.d);
    demand(abs(whole) <= 10000n, 'an exponent is too large');
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

  // ---- Vectors, packed: x_0, x_1, ... as the integer x_0 + x_1 2^width + ..., all |x_i| < 2^(width - 1). Sums and
  // multiples of packed vectors are those of the integers as long as the results keep that bound. -----------------------
  const pack = (numbers, width, from = 0, to = numbers.length) => {
    if (to - from === 1) return numbers[from];
    const middle = (from + to) >> 1;
    return pack(numbers, width, from, middle) + (pack(numbers, width, middle, to) << BigInt(width * (middle - from)));
  };
  const drop = (packed, n) => (packed >> BigInt(n)) + (BigInt.asIntN(n, packed) < 0n ? 1n : 0n);
  const unpack = (packed, width, count, out = []) => {
    if (count === 1) {
      out.push(packed);
      return out;
    }
    const half = count >> 1;
    unpack(BigInt.asIntN(width * half, packed), width, half, out);
    return unpack(drop(packed, width * half), width, count - half, out);
  };
  const combine = (factors, packed) => {
    let total = 0n;
    for (let k = 0; k < factors.length; ++k)
      if (factors[k]) total += factors[k] === 1n ? packed[k] : factors[k] * packed[k];
    return total;
  };

  // ---- Matrices: arrays of rows of integers. A family: {size, den, matrices}, each matrix divided by den. --------------
  const range_of = n => Array.from({length: n}, (_, i) => i);
  const largest_of = matrix => matrix.reduce((most, row) => max(most, largest(row)), 0n);
  const transpose = matrix => matrix[0].map((_, j) => matrix.map(row => row[j]));
  const identity = n => range_of(n).map(i => range_of(n).map(j => i === j ? 1n : 0n));
  const equal = (x, y) => x.every((row, i) => row.every((value, j) => value === y[i][j]));
  const scaled = (matrix, factor) => matrix.map(row => row.map(x => x * factor));
  const column_norm = matrix => transpose(matrix).reduce((most, column) => max(most, norm(column)), 0n);  // |.|_1
  const multiply = (x, y) => {  // the rows of y are packed, those with the larger numbers if one may choose
    const columns = y[0].length, left = bits(largest_of(x)), right = bits(largest_of(y));
    if (left > right) return transpose(multiply(transpose(y), transpose(x)));
    const width = left + right + bits(BigInt(y.length)) + 2;
    spend(x.length * y.length, left, width * columns);
    spend(4 * (x.length + y.length) * columns, width);
    allow_bits((x.length + y.length) * columns * width);
    const packed = y.map(row => pack(row, width));
    return x.map(row => unpack(combine(row, packed), width, columns));
  };
  // The determinant by elimination without fractions [Bareiss 1968]
  function determinant(matrix, entry_bits) {
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

  // ---- Section 2: tokens and lines -----------------------------------------------------------------------------------
  function integer(token) {
    demand(token.length <= 2001, 'number too long');
    demand(/^(0|-?[1-9][0-9]*)$/.test(token), 'not an integer');
    demand(token.length <= 2000 || token[0] === '-', 'number too long');
    return BigInt(token);
  }
  function small(token, low, high) {
    const value = integer(token);
    demand(value >= BigInt(low) && value <= BigInt(high), `number outside ${low}..${high}`);
    return Number(value);
  }
  function rational(token) {
    const parts = token.split('/');
    demand(parts.length <= 2, 'not a rational');
    const [n, d = 1n] = parts.map(integer);
    demand(d > 0n, 'a denominator must be positive');
    return reduced(fraction(n, d));
  }
  // Fractions as integers over one denominator
  function common(fractions) {
    let den = 1n;
    for (const x of fractions) {
      if (den % x.d) den = lcm(den, x.d);
      demand(bits(den) <= 10000, 'common denominator too large');
    }
    allow_bits(fractions.length * bits(den) * 8);
    return {den, numbers: fractions.map(x => x.n * (den / x.d))};
  }

  class Reader {
    constructor(text) {
      [this.text, this.at, this.line, this.fields] = [text, 0, 0, null];
      demand(text.length <= 2 ** 28, 'file too long');
    }
    load() {  // the next line, unless there is one that was looked at only
      if (this.fields) return this.fields;
      ++this.line;
      if (this.at >= this.text.length) return this.fields = [''];
      const end = this.text.indexOf('\n', this.at);
      demand(end >= 0, 'last line without line feed');
      demand(end - this.at <= 2 ** 24, 'line too long');
      this.fields = this.text.slice(this.at, end).split(' ');
      this.at = end + 1;
      return this.fields;
    }
    peek() { return this.load()[0]; }
    // The fields after `words`, which must begin the line
    read(words, fewest = 0, most = fewest) {
      const fields = this.load(), expected = words.split(' ');
      demand(expected.every((word, i) => word === fields[i]), `expected '${words}'`);
      demand(fields.length - expected.length >= fewest && fields.length - expected.length <= most,
             'wrong number of fields');
      this.fields = null;
      return fields.slice(expected.length);
    }
    rows(words, count, size, token) { return range_of(count).map(() => this.read(words, size).map(token)); }
    finish() {
      this.read('end');
      this.line += this.at < this.text.length ? 1 : 0;
      demand(this.at >= this.text.length, "text after 'end'");
    }
  }

  // ---- Section 1: masks. Nested lists to the lists inside, all of one length, the first variable innermost. -----------
  const mask_form = 'a mask is [c0,c1,...]/D@first, of two variables [[c00,c10,...],...]/D@first,first';
  function mask_parts(text) {
    const [, lists, den, first] = /^(\[.*\])(?:\/([^@]*))?(?:@([^@]*))?$/.exec(text) || [];
    demand(lists, mask_form);
    const depth = /^\[*/.exec(lists)[0].length;
    demand(depth <= 3 && lists.endsWith(']'.repeat(depth)), mask_form);
    const sizes = [];
    const split = (body, d) => {
      const pieces = body.split(']'.repeat(d - 1) + ',' + '['.repeat(d - 1));
      demand((sizes[d - 1] = sizes[d - 1] || pieces.length) === pieces.length, 'lists of different lengths in a mask');
      return d === 1 ? pieces : pieces.flatMap(piece => split(piece, d - 1));
    };
    const coefficients = split(lists.slice(depth, -depth), depth);
    demand(coefficients.every(c => c), 'a coefficient is empty');
    return {depth, sizes, coefficients, den, first: first === undefined ? null : first.split(',').map(integer)};
  }
  // A sum of terms c*w^k as its coefficients, by powers of w
  function polynomial(text, letter) {
    const powers = Array(13).fill(fraction(0n));
    for (const [, signs, term] of text.replace(/^-?/, s => s || '+').matchAll(/([+-])([^+-]*)/g)) {
      const [, c, star, w, k] = /^([0-9/]*)(\*?)([a-zA-Z]?)(?:\^(.*))?$/.exec(term) || [];
      demand(w !== undefined && (w ? w === letter : !star) && (c !== '') === (star !== '' || !w) &&
             (w || k === undefined), 'not a term c*w^k');
      const value = c ? rational(c) : fraction(1n), at = k === undefined ? (w ? 1 : 0) : small(k, 1, 12);
      powers[at] = (signs === '-' ? minus : plus)(powers[at], value);
    }
    return powers.map(reduced);
  }
  // A scheme of one variable, with or without a parameter (section 6): the mask a_i(w) / q(w), all polynomials given by
  // their coefficients, integers, of powers of w.
  function read_curve(text, arity, letter) {
    const parts = mask_parts(text), count = parts.coefficients.length;
    const outside = 'a mask has 1 to 1000 coefficients, the first and the last not zero';
    demand(parts.depth === 1 && (!parts.first || parts.first.length === 1), outside);
    demand(count <= 1000, outside);
    const read = c => letter ? polynomial(c, letter) : [rational(c)];
    const by = parts.den === undefined ? '1' : parts.den, quotient = letter && /^\((.*)\)$/.exec(by);
    const q = quotient ? read(quotient[1]) : read('1').map((one, k) => k ? one : fraction(integer(by)));
    demand(quotient || q[0].n > 0n, 'a denominator must be positive');
    const polynomials = [q, ...parts.coefficients.map(read)];
    const degree = Math.max(...polynomials.map(p => p.findLastIndex(sign)), 0);
    const {den, numbers} = common(polynomials.flatMap(p => p.slice(0, degree + 1)));
    const cleared = polynomials.map((_, i) => numbers.slice(i * (degree + 1), (i + 1) * (degree + 1)));
    demand(letter || (numbers[1] && numbers[numbers.length - 1]), outside);
    // The mask is cleared/den over q/den; without a parameter q becomes the one common denominator of the mask.
    const g = numbers.reduce(gcd, 0n) || 1n;
    return {arity, degree, q: cleared[0].map(x => x / g), a: cleared.slice(1).map(p => p.map(x => x / g)), den};
  }

  // ---- 4.1 and 6: the symbol b = A^M a / sigma^M, times q ------------------------------------------------------------
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
    const scale = BigInt(arity) ** BigInt(order);
    const b = transpose(by_power).map(p => p.map(x => x * scale));
    return {arity, degree, q, b, size: Math.max(1, Math.ceil((b.length - 1) / (arity - 1)))};
  }
  function check_sum({arity, degree, q, a}) {
    const rule = k => sum(a.map(p => p[k])) === BigInt(arity) * q[k];
    demand(range_of(degree + 1).every(rule), 'the coefficients of the mask do not sum to the arity');
  }
  // 6.1: the coefficients f_j of (u + v)^degree p(w) = sum f_j u^j v^(degree - j), w = (low v + high u)/(u + v), times a
  // positive number that depends on the interval and the degree only; without an interval p is a number.
  function form_of(p, interval, degree) {
    if (!interval) return [p[0]];
    const {den, numbers: [low, high]} = common([interval.low, interval.high]);
    const by = (f, v, u) => [...f, 0n].map((x, j) => x * v + (j ? f[j - 1] * u : 0n));
    let power_of_w = [1n], form = [0n];  // Horner's rule with forms: p_k w^k (u + v)^(degree - k)
    const all = Array(degree + 1).fill(0n);
    for (let k = 0; k < p.length; ++k, power_of_w = by(power_of_w, low, high)) {
      if (!p[k]) continue;
      form = power_of_w;
      for (let i = k; i < degree; ++i) form = by(form, den, den);
      form.forEach((x, j) => { all[j] += x * p[k]; });
    }
    return all;
  }
  const transition_matrices = (arity, size, entry) => range_of(arity).map(t =>
    range_of(size).map(j => range_of(size).map(k => entry(arity * j + t - k))));
  // 6.1: the family of control matrices on an interval, t = 0: j = 0, ..., n; t = 1: ...; the T_t where there is none
  function control_family({arity, degree, q, b, size}, interval) {
    demand(size <= 256, 'transition matrices larger than 256');
    let weights = form_of(q, interval, degree);
    const turn = weights[0] < 0n ? -1n : 1n;
    weights = weights.map(x => x * turn);
    demand(weights.every(x => x > 0n), 'the denominator of the mask changes its sign, or may do so');
    const den = weights.reduce(lcm, 1n);
    demand(bits(den) <= 10000, 'common denominator too large');
    const entries = b.map(p => form_of(p, interval, degree).map((x, j) => x * turn * (den / weights[j])));
    allow_bits(arity * size * size * weights.length * (bits(largest_of(entries)) + 64));
    const at = weights.map((_, j) => transition_matrices(arity, size, i => i in entries ? entries[i][j] : 0n));
    return {size, den, weights, matrices: range_of(arity).flatMap(t => at.map(matrices => matrices[t]))};
  }

  // ---- 5.5: a polynomial sum of form[j] u^j (1 - u)^(degree - j), of one or more variables, is positive for u in [0, 1].
  // `form` is flat, the first variable innermost. ----------------------------------------------------------------------
  function half(line, right) {  // u = u'/2, or u = (1 + u')/2
    const d = right ? line.slice() : line.slice().reverse(), k = d.length - 1;
    for (let i = 0; i < k; ++i)
      for (let j = k - 1; j >= i; --j) d[j] += d[j + 1];
    const result = d.map((x, i) => x << BigInt(i));
    return right ? result : result.reverse();
  }
  function show_positive(form, what, degrees = [form.length - 1]) {
    const strides = degrees.map((_, v) => degrees.slice(0, v).reduce((n, d) => n * (d + 1), 1));
    const corners = degrees.reduce((at, d, v) => at.flatMap(i => [i, i + d * strides[v]]), [0]);
    const halved = (cell, v, right) => {
      const result = cell.slice(), n = degrees[v] + 1;
      spend(cell.length * n, 512);
      for (let i = 0; i < cell.length; ++i) {
        if (Math.floor(i / strides[v]) % n) continue;
        half(range_of(n).map(j => cell[i + j * strides[v]]), right).forEach((x, j) => {
          result[i + j * strides[v]] = x;
        });
      }
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
  const squares_of = polynomials => {  // sum of p(w)^2
    const total = Array(2 * polynomials[0].length - 1).fill(0n);
    for (const p of polynomials) p.forEach((x, i) => p.forEach((y, j) => { total[i + j] += x * y; }));
    return total;
  };
  // 6.2: the determinant of a matrix of forms in u and v, given as functions of u at v = 1, as a form of that degree;
  // `bound` bounds the sum of the moduli of its coefficients.
  function determinant_form(matrix_at, size, degree, bound) {
    const width = bits(bound) + 2, entry_bits = width * (degree / Math.max(size, 1) + 1);
    spend(0, entry_bits * size);
    allow_bits(entry_bits * size * size);
    return unpack(determinant(matrix_at(1n << BigInt(width)), entry_bits), width, degree + 1);
  }
  const evaluate = (form, u) => form.reduceRight((value, x) => value * u + x, 0n);

  // ---- 4.3, 6.3, section 7: stability --------------------------------------------------------------------------------
  // The numbers n = k A, k >= 2 coprime to A, with phi(n) <= deg a < 1000, each with its prime divisors
  function cyclotomic_orders(arity, degree) {
    const orders = [];
    const divides = (x, y) => y % x === 0;
    for (let n = 2 * arity; n < 6 * (degree + 1); n += arity) {
      const primes = [];
      let rest = n, phi = n;
      for (let p = 2; rest > 1; p = p * p > rest ? rest : p + 1) {
        if (!divides(p, rest)) continue;
        primes.push(p);
        phi = phi / p * (p - 1);
        while (divides(p, rest)) rest /= p;
      }
      const coprime = range_of(arity - 1).every(i => !(divides(i + 2, arity) && divides(i + 2, n / arity)));
      if (coprime && phi <= degree) orders.push({n, primes});
    }
    return orders;
  }
  // a(z) prod_q (1 - z^(n/q)) modulo z^n - 1, for numbers a_i packed
  function cyclotomic_remainder(packed, {n, primes}, width) {
    const size = n * width;
    const fold = x => {
      for (let more; (more = drop(x, size)); ) x = BigInt.asIntN(size, x) + more;
      return x;
    };
    spend(4 * (primes.length + 1), Math.max(size, bits(packed)));
    return primes.reduce((x, q) => fold(x - (x << BigInt(size / q))), fold(packed));
  }
  function check_stability(curve, interval, rounding) {
    const {arity, degree, q, a} = curve;
    if ((interval && degree) || rounding) check_resultant(curve, interval, rounding);
    else check_common_divisor(curve);
    if (interval) show_one_sign(form_of(q, interval, degree), 'the denominator of the mask');
    const top = a.length - 1, width = bits(largest_of(a)) + bits(BigInt(a.length)) + 10;
    const packed = range_of(degree + 1).map(k => pack(a.map(p => p[k]), width));
    for (const order of cyclotomic_orders(arity, top)) {
      const what = `stability: the remainder modulo Phi_${order.n}`;
      const parts = packed.map(x => cyclotomic_remainder(x, order, width));
      if (!interval && !rounding) {
        demand(parts[0], `${what} is not positive`);
        continue;
      }
      const rows = transpose(parts.map(x => unpack(x, width, order.n)));  // a polynomial in w for each power of z
      spend(rows.length * (degree + 1) ** 2, 2 * width);
      const squares = squares_of_all(rows);
      if (interval) show_positive(form_of(squares, interval, 2 * degree), what);
      if (rounding) {
        const change = times(rounding.eps, fraction(BigInt(top + 1) * q[0] << BigInt(order.primes.length)));
        demand(less(times(fraction(BigInt(order.n)), power(change, 2)), fraction(squares[0])), `${what} is not positive`);
      }
    }
  }
  const squares_of_all = squares_of;
  function check_common_divisor({arity, a}) {  // 4.3 (i)
    const k = bits(largest_of(a)) + 64, numbers = a.map(p => p[0]);
    allow_bits(k * numbers.length * 8);
    const value = r => pack(numbers.filter((_, i) => i % arity === r), k);
    const divisor = range_of(Math.min(arity, numbers.length)).map(value).reduce(gcd, 0n);
    demand(divisor < 1n << BigInt(k - 1) && (arity <= numbers.length),
           'stability: the polyphase parts may have a common zero');
  }
  function check_resultant({arity, degree, q, a}, interval, rounding) {  // 6.3 (i), section 7
    const parts = range_of(arity).map(r => a.filter((_, i) => i % arity === r)).map(part => {
      const used = p => rounding || p.some(x => x);
      const first = part.findIndex(used);
      demand(first >= 0, 'stability: a polyphase part is zero');
      return {first, coefficients: part.slice(first, part.findLastIndex(used) + 1)};
    }).sort((x, y) => x.coefficients.length - y.coefficients.length);
    const zero = Array(degree + 1).fill(0n), [p, ...others] = parts.map(part => part.coefficients);
    const length = Math.max(...others.map(part => part.length));
    const mixed = range_of(length).map(i => others.reduce((total, part, j) =>
      i < part.length ? total.map((x, k) => x + BigInt((j + 1) ** 2) * part[i][k]) : total, zero));
    const size = p.length + length - 2;
    const sylvester = convert => {
      const shifted = (part, by) => range_of(size).map(k => k >= by && k - by < part.length ? convert(part[k - by]) : 0n);
      return [...range_of(length - 1).map(i => shifted(p, i)), ...range_of(p.length - 1).map(i => shifted(mixed, i))];
    };
    const what = 'stability: the resultant of the polyphase parts';
    if (interval) {
      const forms = new Map([...p, ...mixed].map(f => [f, form_of(f, interval, degree)]));
      const bound = sylvester(f => norm(forms.get(f))).reduce((product, row) => product * sum(row), 1n);
      const at = u => sylvester(f => evaluate(forms.get(f), u));
      return show_one_sign(determinant_form(at, size, size * degree, bound), what);
    }
    const exact = sylvester(f => f[0]), cut = Math.max(0, bits(largest_of(exact)) - 256 - 16 * size);
    const matrix = exact.map(row => row.map(x => x >> BigInt(cut)));
    const squares = sum(others.map((_, j) => BigInt((j + 1) ** 2)));
    const unit = fraction(q[0], 1n << BigInt(cut));  // mask coefficients in units of the cut entries
    const change = plus(times(times(rounding.eps, unit), fraction(BigInt(size) * (1n + squares))),
                        fraction(cut ? BigInt(size) : 0n));
    const value = fraction(abs(determinant(matrix, bits(largest_of(matrix)) + 8)));
    demand(less(size ? delta(size, fraction(column_norm(matrix)), change) : fraction(0n), value), `${what} is not positive`);
  }
  // 6.4: sigma divides b for no value of the parameter
  function check_full({arity, degree, b}, interval) {
    const sums = range_of(arity).map(r => range_of(degree + 1).map(k =>
      sum(b.filter((_, i) => i % arity === r).map(p => p[k]))));
    const differences = sums.slice(1).map(s => s.map((x, k) => x - sums[0][k]));
    show_positive(form_of(squares_of(differences), interval, 2 * degree),
                  'sum-rules full: what one more sum rule would make 0,');
  }

  // ---- Section 7: rounded coefficients -------------------------------------------------------------------------------
  const delta = (k, x, y) => k ? round_up(times(times(fraction(BigInt(k)), y), power(plus(x, y), k - 1))) : fraction(0n);
  function rounding_of(curve, {eps, order}, size) {
    const {arity, a} = curve, count = a.length;
    let series = Array(count).fill(1n);
    for (let m = 0; m < order; ++m) {  // times (1 + z) / (1 - z^A)
      series = series.map((x, i) => x + (i ? series[i - 1] : 0n));
      for (let i = arity; i < count; ++i) series[i] += series[i - arity];
      spend(count, order);
    }
    const eta = times(eps, fraction(BigInt(arity) ** BigInt(order) * largest(series)));
    return {eps, e: times(eta, fraction(BigInt(size)))};
  }
  const norm_of_family = ({den, matrices}) =>
    fraction(matrices.reduce((most, matrix) => max(most, column_norm(matrix)), 0n), den);

  // ---- 4.4: blocks ---------------------------------------------------------------------------------------------------
  function read_blocks(reader, {size, den, weights, matrices}) {
    const sizes = reader.read('blocks', 1, size).map(token => small(token, 1, size));
    demand(sizes.reduce((x, y) => x + y) === size, 'the block sizes do not sum to n');
    const square = words => {
      const {den: by, numbers} = common(reader.rows(words, size, size, rational).flat());
      return {by, rows: range_of(size).map(i => numbers.slice(i * size, (i + 1) * size))};
    };
    const basis = square('basis'), inverse = square('inverse'), by = basis.by * inverse.by;
    demand(equal(multiply(basis.rows, inverse.rows), scaled(identity(size), by)),
           'basis times inverse is not the unit matrix');
    const all = matrices.map(matrix => multiply(multiply(inverse.rows, matrix), basis.rows));
    return sizes.map((n, block) => {
      const first = sizes.slice(0, block).reduce((x, y) => x + y, 0), within = row => row.slice(first, first + n);
      demand(all.every(matrix => matrix.slice(first + n).every(row => within(row).every(x => !x))),
             'not block upper triangular');
      return {size: n, den: den * by, weights, matrices: all.map(matrix => matrix.slice(first, first + n).map(within))};
    });
  }

  // ---- 4.5: lower bounds by a product --------------------------------------------------------------------------------
  function word_product(matrices, word) {  // integer matrices, from left to right; kept by columns, packed
    const size = matrices[0].length, factors = matrices.map(transpose);
    const growth = bits(matrices.reduce((most, m) => max(most, column_norm(transpose(m))), 1n));
    const width = growth * word.length + 2;
    allow_bits(size * size * width);
    spend(word.length * size * size, growth, width * size);
    const columns = word.reduceRight((vectors, t) => vectors.map(x => x), identity(size));
    let packed = columns.map(column => pack(column, width));
    for (const t of word) packed = factors[t].map(column => combine(column, packed));
    return transpose(packed.map(column => unpack(column, width, size)));
  }
  function read_word(reader, blocks, letters) {
    const [number, re, im, ...word] = reader.read('product', 4, 4099);
    const block = small(number, 0, blocks.length - 1), c = [re, im].map(rational);
    return {block: blocks[block], c, word: word.map(t => small(t, 0, letters - 1))};
  }
  // A lower bound of the radius to the power of the length of the word
  function read_product(reader, blocks, rounding) {
    const {block, c, word} = read_word(reader, blocks, blocks[0].matrices.length);
    const n = block.size, matrix = word_product(block.matrices, word);
    const error = rounding ? delta(word.length, norm_of_family(block), rounding.e) : fraction(0n);
    const with_inverse = reader.peek() === 'inverse';
    // P = unit N, c = unit y / h, and P is known up to an error of norm `wrong` units
    let unit = fraction(1n, block.den ** BigInt(word.length)), {den: h, numbers: y} = common(c), N = matrix, wrong = 0n;
    [y, h] = [y.map(x => x * unit.d), h];
    if (with_inverse || rounding) {
      const cut = bits(largest_of(matrix)) - 256 - 40 * n;
      N = matrix.map(row => row.map(x => shift(x, -cut)));
      y = y.map(x => floor_div(cut > 0 ? x : shift(x, -cut), cut > 0 ? shift(h, cut) : h));
      unit = cut > 0 ? fraction(1n << BigInt(cut), unit.d) : fraction(1n, unit.d << BigInt(-cut));
      [h, wrong] = [1n, cut > 0 ? BigInt(n) : 0n];
    }
    const errors = plus(over(error, unit), fraction(wrong));
    const radius = with_inverse ? by_inverse(reader, N, y, unit, errors) : by_polynomial(N, y, h, errors, rounding);
    demand(sign(radius) > 0, 'the product proves no positive spectral radius');
    return {radius: times(radius, over(unit, fraction(h))), length: word.length};
  }
  // In units of P and c over h: |c| - n (|p(c)| + Delta_n) / (|p'(c)| - n Delta_(n-1))
  function by_polynomial(N, y, h, errors, rounding) {
    const n = N.length, p = characteristic_polynomial(N);
    const c = modulus_above(...y), x = plus(fraction(column_norm(N) * h), c), by = times(errors, fraction(h));
    let value = [0n, 0n], slope = [0n, 0n], scale = 1n;
    const step = ([re, im], add) => [re * y[0] - im * y[1] + add[0], re * y[1] + im * y[0] + add[1]];
    for (let k = n; k >= 0; --k) {  // Horner's rule for p and p', p_k times h^(n - k)
      slope = k < n ? step(slope, value) : slope;
      value = step(value, [p[k] * scale, 0n]);
      scale *= h;
      spend(8, bits(scale) + bits(value[0]), bits(y[0]) + bits(p[k]));
    }
    const count = fraction(BigInt(n));
    const above = plus(modulus_above(...value), delta(n, x, by));
    const below = minus(modulus_below(...slope), times(count, delta(n - 1, x, by)));
    demand(sign(below) > 0, rounding ? 'the product proves nothing of rounded masks'
                                     : 'the characteristic polynomial has derivative 0 at the given eigenvalue');
    return minus(modulus_below(...y), over(times(count, above), below));
  }
  // The coefficients p_0, ..., p_n = 1 of det(x - N), by Faddeev and LeVerrier
  function characteristic_polynomial(N) {
    const n = N.length, p = Array(n + 1).fill(1n);
    for (let k = 1, m = identity(n); k <= n; ++k) {
      const next = multiply(N, m);
      p[n - k] = -sum(next.map((row, i) => row[i])) / BigInt(k);
      m = next.map((row, i) => row.map((x, j) => i === j ? x + p[n - k] : x));
    }
    return p;
  }
  function by_inverse(reader, N, y, unit, errors) {  // Theorem 25, in units of P and c
    const n = N.length, complex = y[1] !== 0n;
    const scale = 1n << BigInt(small(reader.read('inverse', 1)[0], 0, 4096));
    const columns = range_of(n).map(k => reader.read(`column ${k}`, complex ? 2 * n : n).map(integer));
    const parts = [0, 1].map(part => transpose(columns.map(column =>
      complex || !part ? column.slice(part * n, part * n + n) : column.map(() => 0n))));
    const [re, im] = parts, [Nre, Nim] = parts.map(part => complex || part === re ? multiply(N, part) : part);
    const distance = (i, k) => {  // of (c - P) X from 1, times scale and the denominator of the unit
      const product_re = y[0] * re[i][k] - y[1] * im[i][k] - Nre[i][k];
      const product_im = y[0] * im[i][k] + y[1] * re[i][k] - Nim[i][k];
      return abs((i === k ? scale * unit.d : 0n) - unit.n * product_re) + abs(unit.n * product_im);
    };
    const column_sum = term => range_of(n).reduce((most, k) => max(most, sum(range_of(n).map(i => term(i, k)))), 0n);
    const size = fraction(column_sum((i, k) => abs(re[i][k]) + abs(im[i][k])), scale);
    const e = plus(fraction(column_sum(distance), scale * unit.d), times(times(errors, unit), size));
    demand(less(e, fraction(1n)), 'the inverse is none of the product less the given eigenvalue');
    const count = fraction(BigInt(n)), trace = parts.map(part => sum(part.map((row, i) => row[i])));
    const t = minus(over(modulus_below(...trace), fraction(scale)),
                    times(times(count, size), over(e, minus(fraction(1n), e))));
    demand(sign(t) > 0, 'the inverse proves no eigenvalue near the given one');
    return minus(modulus_below(...y), over(count, times(t, unit)));
  }
  // 6.2: a lower bound for all w of an interval; `blocks` are those of the control matrices
  function read_range_product(reader, blocks, arity) {
    const {block: {size, den, weights, matrices}, c: [re, im], word} = read_word(reader, blocks, arity);
    demand(!sign(re) !== !sign(im), 'over a range either the real or the imaginary part of the eigenvalue is 0');
    const pair = sign(im) !== 0, n = weights.length - 1, e = word.length * (pair ? 2 : 1);
    demand(!pair || size >= 2, 'a pair of eigenvalues needs matrices of size 2');
    const g = pair ? times(im, im) : re.n < 0n ? fraction(-re.n, re.d) : re;
    const pairs = range_of(size).flatMap(i => range_of(i).map(j => [j, i]));
    const compound = (m, op) => pairs.map(([i, j]) => pairs.map(([k, l]) => op(m[i][k] * m[j][l], m[i][l] * m[j][k])));
    const order = pair ? pairs.length : size, degree = n * e * order;
    demand(order <= 256, too_much_work);
    // the matrices den q T_t as forms, and the same with moduli at u = v = 1
    const forms = range_of(arity).map(t => range_of(size).map(i => range_of(size).map(k =>
      weights.map((weight, j) => weight * matrices[t * (n + 1) + j][i][k]))));
    const values = convert => forms.map(matrix => matrix.map(row => row.map(convert)));
    const moduli = word_product(values(norm), word), all = pair ? compound(moduli, (x, y) => x + y) : moduli;
    const diagonal = g.n * (den * sum(weights)) ** BigInt(e);
    const bound = all.reduce((product, row) => product * (diagonal + g.d * sum(row)), 1n);
    spend(0, e * (bits(den) + bits(sum(weights))) * order, 64);
    const matrix_at = u => {
      const product = word_product(values(form => evaluate(form, u)), word);
      const at = g.n * (den * evaluate(weights, u)) ** BigInt(e), flip = sign(re) < 0 ? -g.d : g.d;
      return (pair ? compound(product, (x, y) => x - y) : product).map((row, i) =>
        row.map((x, k) => (i === k ? at : 0n) - flip * x));
    };
    show_positive(determinant_form(matrix_at, order, degree, bound).map(x => -x),
                  'the characteristic polynomial of the product, with the other sign,');
    return {radius: pair ? fraction(abs(im.n), im.d) : g, length: word.length};
  }

  // ---- 4.6: norms ----------------------------------------------------------------------------------------------------
  function check_norm({size, den, matrices}, level, first_column, rounding) {
    const columns = first_column ? 1 : size;
    const products = matrices.length ** level * columns, entry = bits(matrices.reduce((x, m) => max(x, largest_of(m)), 0n));
    spend(products * size * size, (entry + bits(BigInt(size))) * level, entry);
    const sparse = matrices.map(matrix => matrix.map(row => row.flatMap((x, k) => x ? [[x, k]] : [])));
    let most = 0n;
    const extend = (vector, letters) => {
      if (!letters) most = max(most, norm(vector));
      else for (const matrix of sparse)
        extend(matrix.map(row => row.reduce((total, [x, k]) => total + x * vector[k], 0n)), letters - 1);
    };
    identity(size).slice(0, columns).forEach(column => extend(column, level));
    const value = fraction(most, den ** BigInt(level));
    return {value: rounding ? plus(value, delta(level, rounding.nu, rounding.e)) : value, level};
  }

  // ---- 4.7, 4.8: groups of maps g with T_t g = g T_s. `elements` are the products of the generators up to their signs;
  // `table[i][k]` is [number, sign] of element i times generator k. ------------------------------------------------------
  function read_group(reader, count, {size, matrices}) {
    const generators = range_of(count).map(() => {
      const numbers = reader.read('generator', matrices.length).map(token => small(token, 0, matrices.length - 1));
      const map = reader.rows('map', size, size, integer);
      numbers.forEach((s, t) => demand(equal(multiply(matrices[t], map), multiply(map, matrices[s])),
                                       'a generator does not permute the matrices as it says'));
      demand(determinant(map, bits(largest_of(map)) + 8), 'a generator is singular');
      return {numbers, map};
    });
    return close_group(generators, size, matrices.length);
  }
  function close_group(generators, size, letters) {
    const elements = [{map: identity(size), numbers: range_of(letters)}], table = [], known = new Map();
    const key = map => map.flat().join();
    known.set(key(elements[0].map), [0, 1n]).set(key(scaled(elements[0].map, -1n)), [0, -1n]);
    for (let i = 0; i < elements.length; ++i)
      table.push(generators.map(g => {
        const map = multiply(elements[i].map, g.map), text = key(map);
        if (!known.has(text)) {
          known.set(text, [elements.length, 1n]).set(key(scaled(map, -1n)), [elements.length, -1n]);
          elements.push({map, numbers: elements[i].numbers.map(t => g.numbers[t])});
          demand(elements.length <= 96, 'the generators span a group of more than 96 elements');
        }
        return known.get(text);
      }));
    return {elements, table};
  }
  const no_group = {elements: [{}], table: [[]]};

  // ---- 4.7: polytopes ------------------------------------------------------------------------------------------------
  function read_polytope(reader, family, fields, rounding) {
    demand(fields.length >= 3, 'wrong number of fields');
    const count = small(fields[0], 1, 2 ** 28), [v_bits, c_bits] = fields.slice(1, 3).map(x => small(x, 0, 4096));
    const properties = fields.slice(3), has = name => properties.includes(name);
    const groups = properties.filter(name => name.startsWith('group:'));
    const names = properties.map(name => name.replace(/^group:.*/, 'group'));
    const plain = ['complex', 'nonnegative', 'symmetric', 'transposed', 'group'];
    demand(names.every(name => plain.includes(name)), 'unknown polytope property');
    demand(new Set(names).size === names.length, 'a polytope property twice');
    demand(!(has('complex') && has('nonnegative')), "unknown polytope property: 'nonnegative' and 'complex'");
    demand(!groups.length || !(has('symmetric') || has('nonnegative')), 'a group with symmetric or nonnegative');
    demand(!groups.length || !rounding, 'a group proves nothing of rounded masks');
    const generators = groups.length ? small(groups[0].slice(6), 1, 8) : 0;
    const {size, den} = family, matrices = has('transposed') ? family.matrices.map(transpose) : family.matrices;
    const nonnegative = has('nonnegative');
    demand(!nonnegative || matrices.every(m => m.every(row => row.every(x => x >= 0n))), 'a matrix is not non-negative');
    let group = no_group;
    if (has('symmetric')) {
      const turned = m => m.map(row => row.slice().reverse()).reverse(), last = matrices.length - 1;
      demand(matrices.every((m, t) => equal(turned(m), matrices[last - t])), 'the family is not symmetric');
      group = {elements: [{}, {map: identity(size).reverse()}], table: [[[1, 1n]], [[0, 1n]]]};
    } else if (generators) {
      group = read_group(reader, generators, {size, matrices});
    }
    const body = new Body(reader, {size, count, complex: has('complex'), nonnegative, symmetric: has('symmetric')},
                          c_bits, group);
    // Theorem 6
    const last_unit = has('symmetric') ? Math.ceil(size / 2) : size, scale = v_bits + c_bits;
    let R = 0n, S = 0n;
    for (let k = 0; k < last_unit; ++k) {
      const unit = range_of(size).map(i => i === k ? 1n << BigInt(scale) : 0n);
      const {residual, weight} = body.read_combination(`unit ${k}`, [unit, unit.map(() => 0n)], 1n);
      [R, S] = [max(R, residual), max(S, weight)];
    }
    demand(R < 1n << BigInt(scale), "the vertices do not span: a unit's residual is 1 or more");
    // E = (S / 2^CBITS) / (1 - R / 2^(VBITS + CBITS)), to the least integer above
    const E = (S << BigInt(v_bits)) / ((1n << BigInt(scale)) - R) + 1n;
    let g = fraction(0n);
    for (let j = 0; j < count; ++j) {
      const more = rounding ? sum(body.coordinates(j).map(norm)) : 0n, images = body.images(matrices, j);
      images.forEach((image, t) => {
        const target = image.map(x => x.map(value => value << BigInt(c_bits)));
        const {residual, weight} = body.read_combination(`image ${j} ${t}`, target, den);
        // w + |r|_1 E, over den 2^(VBITS + CBITS)
        const value = fraction((weight << BigInt(v_bits)) * den + residual * E, den << BigInt(scale));
        const total = rounding ? plus(value, times(rounding.e, fraction(more * E, 1n << BigInt(v_bits)))) : value;
        if (less(g, total)) g = total;
      });
    }
    return {value: g, level: 1};
  }
  // The vertices, and their images under the group, packed
  class Body {
    constructor(reader, options, c_bits, group) {
      Object.assign(this, options, {reader, group, width: 0});
      const parts = this.complex ? 2 : 1, {size, count} = this;
      this.most = 1n;
      this.vertices = [];
      let largest_so_far = 0n;
      for (let j = 0; j < count; ++j) {
        const x = reader.read('vertex', parts * size).map(integer);
        demand(!this.nonnegative || x.every(value => value >= 0n), 'negative coordinate');
        const top = largest(x);
        if (top > largest_so_far) {
          this.set_width(Math.max(this.width, bits(top) + 64));
          largest_so_far = top;
        }
        spend(x.length, this.width);
        allow_bits(j * x.length * this.width);
        this.vertices.push(range_of(parts).map(part => pack(x.slice(part * size, part * size + size), this.width)));
      }
      // coordinates of images under the group
      const growth = group.elements.reduce((most, {map}) =>
        map ? max(most, column_norm(transpose(map))) : most, 1n);
      this.most = largest_so_far * growth;
      this.set_width(bits(this.most) + c_bits + 24);
    }
    set_width(width) {
      const {size, complex} = this, old = this.width;
      if (width <= old) return;
      allow_bits((this.vertices.length + 1) * size * width * (complex ? 2 : 1));
      spend(4 * this.vertices.length * size, width);
      const wider = x => pack(unpack(x, old, size), width);
      this.vertices = this.vertices.map(vertex => vertex.map(wider));
      this.width = width;
      this.turned = new Map();  // images under the group, by number of the element and of the vertex
      this.may_keep = max_bits / (size * width * (complex ? 2 : 1)) / 2;
    }
    coordinates(j) {
      spend(3 * this.size, this.width);
      return this.vertices[j].map(x => unpack(x, this.width, this.size));
    }
    images(matrices, j) {  // for each matrix the parts of the image of vertex j; a number of vertices are done together
      const many = 64, parts = this.complex ? 2 : 1;
      if (j % many === 0) {
        const block = range_of(Math.min(many, this.count - j)).flatMap(i => this.coordinates(j + i));
        this.block = matrices.map(matrix => transpose(multiply(matrix, transpose(block))));
      }
      return this.block.map(rows => rows.slice(j % many * parts, (j % many + 1) * parts));
    }
    // The image of vertex j under an element of the group
    under(element, j) {
      if (!element) return this.vertices[j];
      const key = element * this.count + j;
      if (!this.turned.has(key)) {
        const {map} = this.group.elements[element];
        const image = this.coordinates(j).map(x => pack(map.map(row => combine(row, x)), this.width));
        spend(this.size ** 2 / 4, this.width);
        if (this.turned.size >= this.may_keep) return image;
        this.turned.set(key, image);
      }
      return this.turned.get(key);
    }
    read_term(term) {
      const [head, ...weight] = term.split(':');
      demand(weight.length === (this.complex ? 2 : 1), 'a term is INDEX:WEIGHT');
      const [, index, letters, conjugate] = /^(-?[0-9]*)([^0-9c]*)(c?)$/.exec(head) || [];
      demand(index !== undefined, 'unknown generator');
      demand(!conjugate || this.complex, 'unknown generator');
      demand(letters.length <= 16, 'a word of more than 16 generators');
      let element = 0, turn = 1n;
      for (const letter of letters) {
        const number = this.symmetric ? (letters === 'f' ? 0 : -1) : letter.charCodeAt(0) - 65;
        demand(this.group.table[element][number], 'unknown generator');
        const [next, flip] = this.group.table[element][number];
        [element, turn] = [next, turn * flip];
      }
      const lambda = weight.map(integer);
      demand(!this.nonnegative || lambda[0] >= 0n, 'negative weight');
      return {vertex: [small(index, 0, this.count - 1), element], conjugate: conjugate ? -1n : 1n, lambda: turn < 0n ? lambda.map(x => -x) : lambda};
    }
    // A line: the residual |target - factor * sum of weighted vertices|_1 and the sum of the moduli of the weights
    read_combination(words, target, factor) {
      const terms = this.reader.read(words, 0, 2 ** 24).map(term => this.read_term(term));
      const {size, complex, nonnegative} = this;
      let weight = 0n;
      for (const {lambda} of terms) {
        if (complex) {
          const square = lambda[0] * lambda[0] + lambda[1] * lambda[1], r = root(square);
          weight += r * r < square ? r + 1n : r;
        } else {
          weight += abs(lambda[0]);
        }
      }
      const width = bits(weight * this.most) + 2;
      if (width > this.width) this.set_width(Math.max(width, 2 * this.width));
      spend(terms.length * (complex ? 4 : 1) + 8, bits(weight), this.width * size);
      let re = 0n, im = 0n;
      for (const {vertex: [j, element], conjugate, lambda: [x, y]} of terms) {
        const [real, imaginary] = this.under(element, j);
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

  // ---- 4.8: quadratic forms ------------------------------------------------------------------------------------------
  // Lemma 17. The rows U_k and R_l are packed from the last column to the first, as far as the diagonal. Where some R_kj is
  // 2^128 or more x_jj will not be positive, as U_jj < 2^256: so all R_kj that are used are smaller.
  function positive_definite(S, most) {
    const d = S.length, by = 256 - bits(most), width = 272, limit = 1n << 128n, minus_limit = -limit, R = [];
    const margin = BigInt(d) * (limit + 1n);
    spend(d * d / 2, 128, width * d / 2);
    spend(4 * d * d, width);
    for (let k = 0; k < d; ++k) {
      let packed = pack(S[k].slice(k).reverse().map(x => shift(x, by)), width);
      for (const {row, values} of R) packed -= values[d - 1 - k] * row;
      const size = d - k, values = unpack(BigInt.asIntN(width * size, packed), width, size), x = values[size - 1] - margin;
      if (x <= 0n) return false;
      const diagonal = root(x);
      values[size - 1] = diagonal;
      for (let i = 0; i < size - 1; ++i) {
        const value = values[i] = floor_div(values[i], diagonal);
        if (value >= limit || value <= minus_limit) return false;
      }
      R.push({values, row: pack(values, width)});
    }
    return true;
  }
  function read_quadratic(reader, family, fields, rounding) {
    const form = "expected 'norm', 'polytope' or 'quadratic' and its numbers";
    demand(!rounding && fields.length >= 2 && fields.length <= 3, form);
    demand(fields.length < 3 || fields[2].startsWith('group:'), form);
    const {size, den, matrices} = family;
    const count = small(fields[0], 1, 2 ** 28), bound = rational(fields[1]);
    demand(bound.n >= 0n, 'the bound of a quadratic form is negative');
    const generators = fields.length === 3 ? small(fields[2].slice(6), 1, 8) : 0;
    const group = generators ? read_group(reader, generators, family) : {elements: [{numbers: range_of(matrices.length)}]};
    const P = range_of(size).map(() => Array(size));
    for (let i = 0; i < size; ++i)
      reader.read('form', i + 1).map(integer).forEach((x, j) => { P[i][j] = P[j][i] = x; });
    demand(largest_of(P) && positive_definite(P, largest_of(P)), 'the form is not positive definite');
    for (const {map} of group.elements)
      demand(!map || equal(multiply(multiply(transpose(map), P), map), P), 'a generator does not keep the form');
    // letters of equal matrices count as one letter, the first of them
    const texts = matrices.map(matrix => matrix.flat().join()), letter = texts.map(text => texts.indexOf(text));
    const congruence = new Congruence(P, matrices), words = new Set();
    for (let i = 0; i < count; ++i) {
      const word = reader.read('word', 1, 1000).map(token => letter[small(token, 0, matrices.length - 1)]);
      demand(!words.has(word.join()), 'a word occurs twice');
      words.add(word.join());
      const k = BigInt(2 * word.length);
      const top = ((bound.n * den) ** k << 64n) / bound.d ** k, Q = congruence.of(word);
      const S = P.map((row, a) => row.map((x, b) => top * x - (Q[a][b] << 64n)));
      const most = largest_of(S);
      demand(!most || positive_definite(S, most), 'a product is not below the bound in the quadratic form');
    }
    check_tree(words, group.elements.map(({numbers}) => numbers.map(t => letter[t])), new Set(letter).size);
    return {value: bound, level: 1};
  }
  // Q_w = A_w^T P A_w for the integer matrices of a family, kept for the last word and its beginnings. For T_t of a scheme
  // most rows of the A_t^T are those of others: letters share X Q_w X^T, X the different rows of all, if these are few.
  class Congruence {
    constructor(P, matrices) {
      const factors = matrices.map(transpose), unique = rows => [...new Map(rows.map(row => [row.join(), row])).values()];
      const all = unique(factors.flat()), shared = all.length < 2 * P.length && {rows: all};
      this.letters = factors.map(factor => {
        const set = shared || {rows: unique(factor)}, texts = set.rows.map(String);
        return {set, at: factor.map(row => texts.indexOf(row.join()))};
      });
      this.growth = bits(factors.reduce((most, factor) => max(most, column_norm(transpose(factor))), 1n));
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
        const {set, at} = this.letters[word[k]], images = this.nodes[k].images;
        if (!images.has(set)) images.set(set, this.image(set.rows, this.nodes[k].Q, this.width(k), this.width(k + 1)));
        const image = images.get(set);
        this.nodes.push({Q: at.map(i => at.map(j => image[i][j])), images: new Map()});
      }
      return this.nodes[word.length].Q;
    }
    image(rows, Q, width, next) {  // X Q X^T for the rows of X
      const size = rows[0].length;
      allow_bits(rows.length * size * next * (this.nodes.length + 1));
      spend(rows.length * (rows.length + size), this.growth, next * rows.length);
      spend(6 * rows.length * rows.length, next);
      const packed = Q.map(row => pack(row, width));
      let columns = transpose(rows.map(row => unpack(combine(row, packed), width, size))).map(row => pack(row, next));
      const image = rows.map(() => []);
      for (let i = rows.length - 1, slots = rows.length; i >= 0; --i) {  // symmetric: of row i the columns up to i, or some more
        if ((i + 1) % 12 === 0) columns = columns.map(x => BigInt.asIntN(next * (slots = i + 1), x));
        unpack(combine(rows[i], columns), next, slots).forEach((x, j) => { image[i][j] = image[j][i] = x; });
      }
      return image;
    }
  }
  // The words and their images under the group are a complete tree
  function check_tree(words, permutations, letters) {
    const images = new Set(), tree = 'the words are not those of a complete tree';
    let longest = 0;
    for (const word of words) {
      const numbers = word.split(',');
      longest = Math.max(longest, numbers.length);
      spend(permutations.length * numbers.length);
      for (const p of new Set(permutations.map(String))) {
        const to = p.split(',');
        images.add(numbers.map(t => to[t] + ',').join(''));
      }
    }
    let total = 0n;
    for (const image of images) {
      const length = image.split(',').length - 1;
      total += BigInt(letters) ** BigInt(longest - length);
      spend(length, longest * 5);
      for (let at = image.indexOf(',') + 1; at < image.length; at = image.indexOf(',', at) + 1)
        demand(!images.has(image.slice(0, at)), tree);
    }
    demand(total === BigInt(letters) ** BigInt(longest), tree);
  }

  // ---- Sections: the blocks, a product, upper bounds of all blocks ---------------------------------------------------
  function read_section(reader, number, family, options) {
    const [kind, ...fields] = reader.read(`block ${number}`, 1, 20);
    const {first_column, rounding} = options;
    if (kind === 'norm') {
      demand(fields.length === 1, "wrong number of fields after 'norm'");
      return check_norm(family, small(fields[0], 1, 64), first_column, rounding);
    }
    if (kind === 'polytope') return read_polytope(reader, family, fields, rounding);
    demand(kind === 'quadratic', "expected 'norm', 'polytope' or 'quadratic' and its numbers");
    return read_quadratic(reader, family, fields, rounding);
  }
  // goal.above(radius, length) and goal.below(value, level) demand what the claim needs; either may be absent
  function prove(reader, family, goal, {first_column = false, rounding = null, product = null} = {}) {
    let blocks = [family], first = first_column;
    if (reader.peek() === 'blocks') {
      demand(!rounding, 'blocks prove nothing of rounded masks');
      blocks = read_blocks(reader, family);
      first = false;
    }
    if (goal.above || (reader.peek() === 'product' && !goal.no_product)) {
      const {radius, length} = (product || read_product)(reader, blocks, rounding);
      if (goal.above) goal.above(radius, length);
    }
    if (goal.below || reader.peek() === 'block')
      blocks.forEach((block, i) => {
        const {value, level} = read_section(reader, i, block, {first_column: first, rounding});
        if (goal.below) goal.below(value, level);
      });
  }
  const unproved = 'the bound does not prove the claim';
  const unproved_product = "the product's spectral radius does not prove the claim";
  const at_most = (limit, strict) => (value, level) => {
    const allowed = power(limit, level);
    demand(sign(limit) >= 0, unproved);
    demand(strict ? less(value, allowed) : !less(allowed, value), unproved);
  };

  // ---- Radius claims -------------------------------------------------------------------------------------------------
  function check_radius(reader, {family, lower, upper}) {
    prove(reader, family, {
      below: upper && at_most(upper, false),
      above: lower && ((radius, length) => demand(sign(lower) <= 0 || !less(radius, power(lower, length)), unproved_product)),
    });
  }

  // ---- Exponent, range, roughness and rounded claims -------------------------------------------------------------------
  function check_curve(reader, claim) {
    const {lower, upper, rough, interval} = claim;
    let curve = claim.curve;
    const again = !interval && !claim.within && reader.peek() === 'reduced';
    if (again) {
      demand(lower, 'a reduced mask tells the exponent of one mask, with a lower end');
      curve = read_reduced(reader, curve);
    }
    const [order_token, full_token] = reader.read('sum-rules', 1, 2), order = small(order_token, 1, 500);
    demand(!lower || (interval ? sign(lower) >= 0 : sign(lower) > 0), 'the lower end of an exponent must be positive');
    demand(!upper || sign(upper) >= 0, 'an exponent is negative or too large');
    const goal = {}, base = BigInt(curve.arity), to_order = x => minus(fraction(BigInt(order)), x);
    if (lower) goal.below = at_most(power_below(base, to_order(lower)), Boolean(interval));
    const limit = upper && over(fraction(1n), power_below(base, minus(upper, fraction(BigInt(order)))));
    check_sum(curve);
    const stability = reader.peek() === 'stability', full = full_token === 'full';
    demand(full_token === undefined || (full && !claim.within), "expected 'sum-rules M', or 'sum-rules M full' of one mask");
    demand(!claim.within || claim.within.order === order, 'the claim is about masks with another number of sum rules');
    const symbol = divided_symbol(curve, order);
    if (full) check_full(symbol, interval);
    demand(!rough || (full && order <= rough),
           'less smoothness than that needs the full number of sum rules, and no more of them');
    const no_sections = !lower && !(upper && interval);
    if (stability || rough || (upper && !(interval && !sign(upper))) || (no_sections && !upper)) {
      reader.read('stability');
      check_stability(curve, interval, claim.within);
    }
    const enough = full && upper && (interval ? less(fraction(BigInt(order)), upper) : !less(upper, fraction(BigInt(order))));
    if (upper && !enough)
      goal.above = (radius, length) => {
        const grown = less(fraction(1n), radius), least = interval ? !less(radius, fraction(1n)) : grown;
        demand(least, 'the product proves no exponent below the number of sum rules');
        demand(!less(radius, power(limit, length)), unproved_product);
      };
    if (interval) return no_sections || (!lower && enough) ? undefined : check_intervals(reader, symbol, goal, interval);
    const family = control_family(symbol, null);
    const rounding = claim.within && rounding_of(curve, claim.within, family.size);
    if (rounding) rounding.nu = norm_of_family(family);
    prove(reader, family, goal, {first_column: true, rounding});
    if (again) check_convergence(reader, claim.curve);
  }
  function check_intervals(reader, symbol, goal, {low, high}) {
    for (let from = low; less(from, high);) {
      const to = rational(reader.read('to', 1)[0]);
      demand(less(from, to) && !less(high, to), 'an interval ends outside of the rest of the range');
      const family = control_family(symbol, {low: from, high: to});
      prove(reader, family, goal, {product: (lines, blocks) => read_range_product(lines, blocks, symbol.arity)});
      from = to;
    }
  }
  // 4.9: the mask b of OTHER, where a(z) p(z) = p(z^A) b(z) up to a power of z
  function read_reduced(reader, curve) {
    const [p, b] = reader.read('reduced', 2).map(text => read_curve(text, curve.arity, null));
    const numbers = ({a}) => a.map(x => x[0]), product = (x, y) => {
      const width = bits(largest(x)) + bits(largest(y)) + 12;
      return unpack(pack(x, width) * pack(y, width), width, x.length + y.length - 1);
    };
    const spread = range_of((p.a.length - 1) * curve.arity + 1).map(i => i % curve.arity ? 0n : p.a[i / curve.arity][0]);
    demand(sum(numbers(p)), 'the factor of the reduced mask is 0 at 1');
    const left = product(numbers(curve), numbers(p)), right = product(spread, numbers(b));
    demand(left.length === right.length && left.every((x, i) => x * b.q[0] === right[i] * curve.q[0]),
           'the reduced mask is not that of the mask and the factor');
    return b;
  }
  function check_convergence(reader, curve) {  // 4.9: JSR < A^M for the mask of the claim
    const order = small(reader.read('sum-rules', 1)[0], 1, 500);
    check_sum(curve);
    const family = control_family(divided_symbol(curve, order), null);
    prove(reader, family, {below: at_most(fraction(BigInt(curve.arity) ** BigInt(order)), true)}, {first_column: true});
  }

  // ---- Section 5: several variables. Points are arrays of small integers; a sequence is a Map of the text of a point to
  // [point, value], without zeros. ---------------------------------------------------------------------------------------
  const minor = (m, i, j) => m.filter((_, r) => r !== i).map(row => row.filter((_, c) => c !== j));
  const small_determinant = m =>
    m.length ? m[0].reduce((total, x, j) => total + (j % 2 ? -x : x) * small_determinant(minor(m, 0, j)), 0) : 1;
  const adjugate = m => m.map((row, i) => row.map((_, j) => ((i + j) % 2 ? -1 : 1) * small_determinant(minor(m, j, i))));
  const times_point = (m, p) => m.map(row => row.reduce((total, x, k) => total + x * p[k], 0));
  const times_small = (x, y) => x.map(row => y[0].map((_, j) => row.reduce((total, a, k) => total + a * y[k][j], 0)));
  const add_points = (p, q, by = 1) => p.map((x, v) => x + by * q[v]);
  function add(sequence, point, value) {
    const key = point.join(), entry = sequence.get(key), total = entry ? entry[1] + value : value;
    if (total) sequence.set(key, [point, total]);
    else sequence.delete(key);
  }
  const sequence_of = entries => {
    const result = new Map();
    for (const [point, value] of entries) add(result, point, value);
    return result;
  };
  const values_of = sequence => [...sequence.values()].map(entry => entry[1]);
  // factor x - by y, divided by its content, or modulo a prime
  function eliminate(x, factor, y, by, prime) {
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
  function read_point(text, dimension) {
    const parts = text.split(',');
    demand(parts.length === dimension, 'a point with another number of coordinates');
    return parts.map(integer).map(coordinate);
  }
  function coordinate(value) {
    demand(abs(value) <= 10n ** 9n, 'a coordinate is too large');
    return Number(value);
  }
  function read_sequence(fields, dimension) {
    const entries = fields.map(field => {
      const [point, value, more] = field.split(':');
      demand(value !== undefined && more === undefined, 'a term is POINT:INTEGER');
      return [read_point(point, dimension), integer(value)];
    });
    demand(entries.every(([, value]) => value), 'a coefficient is 0');
    const result = sequence_of(entries);
    demand(new Set(entries.map(([point]) => point.join())).size === entries.length, 'a point occurs twice');
    return result;
  }
  function read_surface(text) {
    const {depth, sizes, coefficients, den: by, first} = mask_parts(text);
    demand(coefficients.length <= 10000, 'a mask with too many coefficients');
    demand(!first || first.length === depth, mask_form);
    const divisor = by === undefined ? 1n : integer(by);
    demand(divisor > 0n, 'a denominator must be positive');
    const {den, numbers} = common(coefficients.map(rational).map(x => times(x, fraction(1n, divisor))).map(reduced));
    return {depth, sizes, den, numbers, first: first || Array(depth).fill(0n)};
  }
  const mask_sequence = ({sizes, numbers, first}) => sequence_of(numbers.map((value, i) => {
    let rest = i;  // the first variable innermost
    return [sizes.map((size, v) => {
      const x = rest % size;
      rest = (rest - x) / size;
      return x + coordinate(first[v]);
    }), value];
  }));
  function read_dilation(text) {
    const [, rows] = /^\[(.*)\]$/.exec(text) || [];
    demand(rows !== undefined, 'a dilation is [1,2;-2,-1]');
    const lines = rows.split(';');
    const matrix = lines.map(row => read_point(row, lines.length));
    demand(lines.length <= 3, 'a dilation has up to three rows');
    demand(matrix.every(row => row.every(x => Math.abs(x) <= 64)), 'an entry of a dilation is too large');
    return matrix;
  }
  function check_isotropic(M) {  // 5.1, Lemma 7
    const s = M.length, d = small_determinant(M), t = M.reduce((total, row, i) => total + row[i], 0);
    const square = times_small(M, M);
    const c = s < 3 ? 0 : M.reduce((total, _, i) => total + small_determinant(minor(M, i, i)), 0);
    const is_multiple = (factor, of) => square.every((row, i) => row.every((x, j) => factor * x === (i === j ? of : 0)));
    const isotropic = s === 1 || (s === 2 && (t * t < 4 * d || is_multiple(1, Math.abs(d)))) ||
      (s === 3 && c ** 3 === d * t ** 3 &&
       (t === 0 || Math.abs(t * t - c) < 2 * Math.abs(c) || is_multiple(t * t, c * c)));
    demand(isotropic && Math.abs(d) > 1, 'the dilation is not isotropic and expanding');
  }
  function check_turned(N, M, mask) {  // 5.7
    const inverse = adjugate(M), d = small_determinant(M), wrong = 'the dilation is not turned by symmetries';
    demand(N.length === M.length, 'the turned dilation has another number of variables');
    check_isotropic(N);
    const divide = m => m.map(row => row.map(x => x / d));
    const first = divide(times_small(N, inverse));
    demand(first.flat().every(Number.isInteger), 'the turned dilation is no integer multiple of the dilation');
    demand(Math.abs(small_determinant(first)) === 1, wrong);
    for (let g = first, steps = 0; steps === 0 || String(g) !== String(first); ++steps) {
      spend(40 * mask.size);
      demand(is_symmetry(g, mask), wrong);
      g = divide(times_small(times_small(M, g), inverse));
      demand(g.flat().every(x => Number.isInteger(x) && Math.abs(x) <= 2 ** 20), wrong);
    }
  }
  function is_symmetry(g, mask) {
    const entries = [...mask.values()], origin = entries[0][0], zero = origin.map(() => 0);
    const points = entries.map(([p]) => add_points(p, origin, -1)), images = points.map(p => times_point(g, p));
    const total = list => list.reduce((x, y) => add_points(x, y), zero);
    const move = add_points(total(points), total(images), -1).map(x => x / entries.length);
    return move.every(Number.isInteger) && entries.every(([, value], i) => {
      const image = mask.get(add_points(add_points(images[i], move), origin).join());
      return image !== undefined && image[1] === value;
    });
  }
  // The operators T_t of section 5, times den
  class Transition {
    constructor(mask, M, digits) {
      [this.mask, this.M, this.digits, this.det, this.adjugate] = [mask, M, digits, small_determinant(M), adjugate(M)];
      this.classes = new Map();
      for (const entry of mask.values()) {
        const key = this.class_of(entry[0]);
        this.classes.set(key, [...(this.classes.get(key) || []), entry]);
      }
      this.size = bits(largest(values_of(mask)));
    }
    class_of(point) {
      const D = Math.abs(this.det);
      return times_point(this.adjugate, point).map(x => (x % D + D) % D).join();
    }
    apply(t, v) {
      const result = new Map();
      for (const [k, value] of v.values()) {
        const from = this.classes.get(this.class_of(add_points(t, k, -1))) || [];
        spend(4 * from.length + 4, this.size, bits(value));
        for (const [i, c] of from)
          add(result, times_point(this.adjugate, add_points(add_points(i, k), t, -1)).map(x => x / this.det), c * value);
      }
      return result;
    }
  }
  // The nu with |nu| < order, or with |nu| = order
  const exponents = (dimension, order, exact) => dimension === 0 ? (!exact || order === 0 ? [[]] : []) :
    range_of(order + (exact ? 1 : 0)).flatMap(k => exponents(dimension - 1, order - k, exact).map(nu => [k, ...nu]));
  function moment(entries, nu) {
    spend(entries.length * nu.length, 32 * (sum_of(nu) + 1));
    return entries.reduce((total, [p, value]) =>
      total + p.reduce((product, x, v) => product * BigInt(x) ** BigInt(nu[v]), value), 0n);
  }
  const sum_of = numbers => numbers.reduce((x, y) => x + y, 0);
  function check_sum_rules(transition, order, den) {
    const classes = [...transition.classes.values()], enough = classes.length === Math.abs(transition.det);
    demand(enough && classes.every(entries => moment(entries, [0, 0, 0].slice(3 - transition.M.length)) === den),
           'a class of coefficients does not sum to 1');
    for (const nu of exponents(transition.M.length, order, false)) {
      const first = moment(classes[0], nu);
      demand(classes.every(entries => moment(entries, nu) === first), 'the mask has no sum rules of this order');
    }
  }
  // Sequences modulo a space, over the rationals or modulo a prime: each row has a key that no later row has
  class Span {
    constructor(rows, prime) { [this.rows, this.prime] = [rows.slice(), prime]; }
    extend(sequence) {  // the part outside of the span, or undefined
      let x = eliminate(sequence, 1n, new Map(), 0n, this.prime);
      for (const {key, row} of this.rows)
        if (x.has(key)) x = eliminate(x, row.get(key)[1], row, x.get(key)[1], this.prime);
      if (!x.size) return undefined;
      this.rows.push({key: x.keys().next().value, row: x});
      allow_bits(this.rows.length * x.size * 1024);
      return x;
    }
  }
  // Bases, modulo the space of `rows`, of the span of the T_w x with words w of at least i letters, x in `start`:
  // i = 0, 1, ... until it is 0 or stays the same, or for a number of steps
  function long_words(start, rows, transition, steps = Infinity, prime = 0n) {
    const images = x => transition.digits.map(t => transition.apply(t, x));
    const all = new Span(rows, prime), basis = [];
    for (let queue = start; queue.length; queue = queue.map(x => all.extend(x)).filter(x => x && basis.push(x)).flatMap(images));
    for (let i = 0, last = basis; ; ++i) {
      if (!last.length || i === steps) return {steps: i, basis: last};
      const span = new Span(rows, prime), next = last.flatMap(images).map(x => span.extend(x)).filter(x => x);
      demand(steps < Infinity || next.length < last.length, 'differences are not led into the space');
      last = next;
    }
  }
  const differences = (sequence, order, dimension) => exponents(dimension, order, true).map(mu =>
    mu.reduce((x, times_v, v) => range_of(times_v).reduce(y => {
      spend(2 * y.size, 64);
      const result = new Map(y);
      for (const [p, value] of y.values()) add(result, p.map((c, i) => i === v ? c + 1 : c), -value);
      return result;
    }, x), sequence));
  // The matrices of the operators on the space of the vectors
  function space_family(vectors, transition, den) {
    const pivots = vectors.map(v => v.keys().next().value), pivot = vectors[0].get(pivots[0])[1];
    const columns = transition.digits.map(t => vectors.map(v => {
      const image = transition.apply(t, v), at = pivots.map(key => image.has(key) ? image.get(key)[1] : 0n);
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
    return {size: vectors.length, den: pivot * den, matrices: columns.map(transpose)};
  }
  function read_space(reader, dimension) {
    const count = small(reader.read('space', 1)[0], 1, 256);
    const vectors = [], holders = new Map();
    let pivot = null;
    for (let n = 0; n < count; ++n) {
      const v = read_sequence(reader.read('vector', 1, 2 ** 24), dimension), [key, [, value]] = v.entries().next().value;
      demand(value > 0n, 'the first coefficient of a vector must be positive');
      demand(pivot === null || pivot === value, 'the first coefficients of two vectors differ');
      pivot = value;
      vectors.push(v);
      for (const point of v.keys()) holders.set(point, (holders.get(point) || 0) + 1);
    }
    demand(vectors.every(v => holders.get(v.keys().next().value) === 1), 'the first point of a vector occurs in another');
    return vectors;
  }
  // 5.5: g_k, k and -k, is a fixed point of the transfer operator, and the sum over it is positive on the torus
  function check_gram(reader, {mask, M, det, adjugate: inverse}, den) {
    const fields = reader.read('gram', 1, 2 ** 24), half_g = read_sequence(fields, M.length), g = new Map(half_g);
    for (const [p, value] of half_g.values()) {
      const mirror = p.map(x => -x || 0);
      demand(p.every(x => !x) || !half_g.has(mirror.join()), 'a point occurs twice');
      g.set(mirror.join(), [mirror, value]);
    }
    demand(sum(values_of(g)) > 0n, 'the numbers of the gram line have no positive sum');
    const correlation = new Map(), image = new Map(), entries = [...mask.values()];
    spend(4 * entries.length ** 2, bits(largest(values_of(mask))));
    for (const [i, x] of entries) for (const [j, y] of entries) add(correlation, add_points(i, j, -1), x * y);
    for (const [l, value] of g.values()) {
      spend(4 * correlation.size, bits(value));
      for (const [x, c] of correlation.values()) {
        const k = times_point(inverse, add_points(x, l)).map(y => y / det || 0);
        if (k.every(Number.isInteger)) add(image, k, c * value);
      }
    }
    const scale = BigInt(Math.abs(det)) * den * den;
    demand(image.size === g.size && [...g].every(([key, [, value]]) => image.has(key) && image.get(key)[1] === scale * value),
           'the gram line is not a fixed point of the transfer operator');
    check_torus([...half_g.values()], M.length);
  }
  function check_torus(terms, dimension) {
    const n = range_of(dimension).map(v => terms.reduce((most, [k]) => Math.max(most, Math.abs(k[v])), 0));
    const degrees = n.map(x => 2 * x), size = degrees.reduce((x, d) => x * (d + 1), 1);
    demand(size <= 2 ** 20, too_much_work);
    const factors = [[1n, -1n], [1n, 1n]];  // 1 + i t = (1 - i)(1 - u) + (1 + i) u, and 1 - i t
    const linear = minus_i => factors.map(([re, im]) => minus_i ? [re, -im] : [re, im]);
    const convolve = (f, [low, high]) => range_of(f.length + 1).map(j => {
      const [a, b] = [f[j] || [0n, 0n], (j && f[j - 1]) || [0n, 0n]];
      return [a[0] * low[0] - a[1] * low[1] + b[0] * high[0] - b[1] * high[1],
              a[0] * low[1] + a[1] * low[0] + b[0] * high[1] + b[1] * high[0]];
    });
    const known = new Map();
    const line = (v, k) => {  // (1 + i t)^(n + k) (1 - i t)^(n - k)
      const key = `${v} ${k}`;
      if (known.has(key)) return known.get(key);
      spend(4 * degrees[v] ** 2, degrees[v]);
      const of = range_of(degrees[v]).reduce((f, j) => convolve(f, linear(j >= n[v] + k)), [[1n, 0n]]);
      known.set(key, of);
      return of;
    };
    for (let chart = 0; chart < 2 ** dimension; ++chart) {
      const form = Array(size).fill(0n);
      for (const [k, value] of terms) {
        spend(4 * size, 2 * sum_of(degrees), 2 * sum_of(degrees));
        const odd = k.some(x => x) ? 2n : 1n;  // k and -k together
        const turn = k.reduce((total, x, v) => chart >> v & 1 && x % 2 ? -total : total, odd * value);
        const tensor = k.reduce((all, x, v) => line(v, x).flatMap(([c, d]) =>
          all.map(([a, b]) => [a * c - b * d, a * d + b * c])), [[1n, 0n]]);
        tensor.forEach(([re], j) => { form[j] += turn * re; });
      }
      show_positive(form, 'stability: the sum over the gram line', degrees);
    }
  }
  function check_surface(reader, claim) {
    const {lower, upper, surface, dilation} = claim, dimension = surface.depth, s = dimension;
    const by_values = reader.peek() === 'differences';
    const order = small(reader.read(by_values ? 'differences' : 'sum-rules', 1)[0], 1, 500);
    demand(order <= 64, 'a higher order than the checker allows in several variables');
    demand(sign(lower) > 0, 'the lower end of an exponent must be positive');
    demand(!by_values || !less(fraction(BigInt(order)), lower), 'the lower end is above the order of the differences');
    demand(!upper || sign(upper) >= 0, 'an exponent is negative or too large');
    check_isotropic(dilation);
    const turned = reader.peek() === 'turned', mask = mask_sequence(surface);
    const M = turned ? read_dilation(reader.read('turned', 1)[0]) : dilation;
    if (turned) check_turned(M, dilation, mask);
    const D = Math.abs(small_determinant(M));
    demand(D <= 64, 'a dilation with too large a determinant');
    const digits = reader.read('digits', D).map(token => read_point(token, dimension));
    const transition = new Transition(mask, M, digits);
    demand(new Set(digits.map(t => transition.class_of(t))).size === D, 'two digits of one class');
    check_sum_rules(transition, by_values ? 1 : order, surface.den);
    let start = sequence_of([[Array(dimension).fill(0), 1n]]);
    if (by_values) {
      start = read_sequence(reader.read('values', 1, 2 ** 24), dimension);
      const fixed = transition.apply(digits[0], start);
      demand(sum(values_of(start)), 'the numbers of the values line have the sum 0');
      demand(fixed.size === start.size && [...start].every(([key, [, value]]) =>
        fixed.has(key) && fixed.get(key)[1] === value * surface.den),
             'the values line is not fixed by the operator of the first digit');
    }
    const vectors = read_space(reader, dimension);
    if (!by_values)
      for (const nu of exponents(dimension, order, false))
        demand(vectors.every(v => !moment([...v.values()], nu)),
               'a vector does not annihilate the polynomials of degree below the order of the sum rules');
    const family = space_family(vectors, transition, surface.den);
    const rows = vectors.map(row => ({key: row.keys().next().value, row})), from = differences(start, order, dimension);
    const {steps} = long_words(from, rows, transition);
    if (by_values && upper)
      demand(long_words(from, [], transition, steps, 2n ** 32n - 5n).basis.length === vectors.length,
             'the differences do not span the space');
    if (!by_values && (upper || reader.peek() === 'gram')) check_gram(reader, transition, surface.den);
    const base = BigInt(D), limit = upper && over(fraction(1n), power_below(base, upper));
    const to_s = (prove_it => (x, k) => prove_it(power(x, s), k));
    prove(reader, family, {
      below: to_s(at_most(power_below(base, fraction(-lower.n, lower.d)), false)),
      above: upper && to_s((radius, length) => {
        demand(less(power(fraction(1n, base), order * length), radius),
               'the product proves no exponent below the number of sum rules');
        demand(!less(radius, power(limit, length)), unproved_product);
      }),
    });
  }


  // ---- The claim and the command line --------------------------------------------------------------------------------
  const usage = `usage: subcert-check --mask '[c0,c1,...]/D@first' --arity A [--lower P/Q [--upper P/Q]] FILE
       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --for 'w=LOW..HIGH'
                     [--lower P/Q] [--upper P/Q] FILE    (for all these w; <, not <=)
       subcert-check --mask MASK --arity A [--for RANGE] --upper CK FILE    (no C^K limits, K = 1, 2, ...)
       subcert-check --mask MASK --arity A --within EPS,M [--lower P/Q [--upper P/Q]] FILE    (for all masks
                     within EPS of MASK that have M sum rules)
       subcert-check --surface '[[c00,c10,...],...]/D@first,first' --dilation '[2,0;0,2]'
                     --lower P/Q [--upper P/Q] FILE
       subcert-check --matrices MATRICES [--lower P/Q] [--upper P/Q] FILE    (at least one bound)
a mask and no bounds: its integer shifts are stable
prints VERIFIED <claim> (exit 0) or REJECTED <why, line n> (exit 1)
exit 64: wrong usage, 65: malformed MATRICES, 66: missing file`;
  function read_options(words) {
    const names = ['mask', 'arity', 'for', 'within', 'surface', 'dilation', 'matrices', 'lower', 'upper'], options = {};
    for (let i = 0; i < words.length; ++i) {
      const option = words[i].startsWith('--') ? words[i].slice(2) : 'FILE';
      demand(option === 'FILE' || names.includes(option), `unknown option ${words[i]}`);
      if (option !== 'FILE') ++i;
      demand(i < words.length && !(option in options), `${words[i - 1]} needs a value, and only one`);
      options[option] = words[i];
    }
    const has = (...all) => all.every(name => name in options), none = (...all) => !all.some(name => name in options);
    const rough = has('upper') && options.upper.startsWith('C');
    const curve = has('mask', 'arity') && none('surface', 'dilation', 'matrices') && !(has('for') && has('within')) &&
      (!has('upper') || has('lower') || has('for') || (rough && none('within'))) && !(rough && has('within'));
    const surface = has('surface', 'dilation', 'lower') && none('mask', 'arity', 'for', 'within', 'matrices') && !rough;
    const radius = has('matrices') && (has('lower') || has('upper')) && !rough &&
      none('mask', 'arity', 'for', 'within', 'surface', 'dilation');
    demand(has('FILE') && (curve || surface || radius), usage);
    return {options, rough, kind: curve ? check_curve : surface ? check_surface : check_radius};
  }
  // The claim: what the checks need, the second line of its certificate, and the text of what is proved
  function read_claim(words) {
    const {options, rough, kind} = read_options(words);
    const claim = {options, kind, lower: options.lower === undefined ? null : rational(options.lower), upper: null};
    if (rough) claim.rough = small(options.upper.slice(1), 1, 500);
    else if (options.upper !== undefined) claim.upper = rational(options.upper);
    if (kind === check_surface) {
      [claim.surface, claim.dilation] = [read_surface(options.surface), read_dilation(options.dilation)];
      demand(claim.surface.depth === claim.dilation.length, 'mask and dilation have different numbers of variables');
      claim.head = `surface ${options.surface} ${options.dilation}`;
    } else if (kind === check_curve) {
      const arity = small(options.arity, 2, 16), letter = options.for === undefined ? null : read_range(options.for, claim);
      if (options.within !== undefined) claim.within = read_rounding(options.within);
      claim.curve = read_curve(options.mask, arity, letter);
      claim.head = `exponent ${options.mask} ${options.arity}` + (letter ? ` ${options.for}` : '') +
        (claim.within ? ` within=${options.within}` : '');
    }
    return claim;
  }
  function read_range(text, claim) {
    const [, letter, low, high] = /^([a-zA-Z])=(.*?)\.\.(.*)$/.exec(text) || [];
    const form = 'a range is w=LOW..HIGH with rationals LOW < HIGH';
    demand(letter, form);
    claim.interval = {low: rational(low), high: rational(high)};
    demand(less(claim.interval.low, claim.interval.high), form);
    return letter;
  }
  function read_rounding(text) {
    const [eps, order, more] = text.split(',');
    const form = 'a rounding is EPS,M with EPS > 0 and the number M of sum rules';
    demand(order !== undefined && more === undefined, form);
    const rounding = {eps: rational(eps), order: small(order, 1, 500)};
    demand(sign(rounding.eps) > 0, form);
    return rounding;
  }
  function text_of({options, kind, lower, upper, rough, interval}) {
    const relation = interval ? ' < ' : ' <= ', number = x => x.d === 1n ? `${x.n}` : `${x.n}/${x.d}`;
    let what = kind === check_radius ? 'joint spectral radius' : 'Hoelder exponent';
    if (rough) what = `${lower ? `${what} and ` : ''}no C^${rough} limits`;
    else if (!lower && !upper) what = 'stable integer shifts';
    const ends = !lower && interval && upper && !sign(upper) ? 'no convergence'
      : `${lower ? number(lower) + relation : ''}${what}${upper ? relation + number(upper) : ''}`;
    const subject = kind === check_radius ? options.matrices : kind === check_surface
      ? `${options.surface} with dilation ${options.dilation}` : `${options.mask} with arity ${options.arity}`;
    return `${ends} of ${subject}` + (interval ? ` for all ${options.for}` : '') +
      (options.within ? ` for all masks within=${options.within}` : '');
  }
  function read_matrices(reader) {
    const [count, size] = reader.read('matrices', 2).map((token, i) => small(token, 1, i ? 256 : 4096));
    demand(count * size * size <= 2 ** 22, 'more entries than 2^22');
    const rows = reader.rows('row', count * size, size, rational), {den, numbers} = common(rows.flat());
    ++reader.line;
    demand(reader.at >= reader.text.length, 'text after the last row');
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
    read_bounds(reader);
    claim.kind(reader, claim);
    reader.finish();
  }

  // What went wrong, in words; anything but a refusal of ours and the limits of the engine is a fault of this program.
  function reason(error) {
    if (error instanceof Rejection) return error.message;
    if (error instanceof RangeError) return too_much_work;
    throw error;
  }
  // words: the command line; read_text(path): the bytes of a file as a text of characters 0 to 255, or null where there is
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
    const {matrices, FILE} = claim.options, text = matrices === undefined ? '' : read_text(matrices);
    if (text === null) return wrong(66, `cannot read ${matrices}`);
    try {
      if (matrices !== undefined) {
        reader = new Reader(text);
        claim.family = read_matrices(reader);
        claim.head = `radius ${claim.family.matrices.length} ${claim.family.size}`;
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
    return {exit: 0, line: `VERIFIED ${text_of(claim)}`};
  };
})();

if (typeof module === 'object') module.exports = {check_certificate};
