// Numbers as pages show them: with minus signs where texts of the program have hyphens. The same for a text that a reader
// searches, with neither these nor spaces that do not part words.
'use strict';

const withMinus = text => String(text).replace(/(^|[\s([{=<>≤≥,/|^…]|\de)-(?=\.?\d)/g, '$1\u2212');
const asTyped = text => text.replaceAll('\u2212', '-').replaceAll('\u00a0', ' ').replaceAll('\u2026', '...')
  .replaceAll('\u2264', '<=').replaceAll('\u2265', '>=').replaceAll('\u03c8', 'psi').replaceAll('\u03c6', 'phi')
  .replaceAll('\u00f6', 'oe');
