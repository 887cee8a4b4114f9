// Tests what the corpus does not: main.js as a process, and checker.js as a plain script that needs neither node nor a
// page.
// Usage: program.js ACCEPT_DIRECTORY
'use strict';
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const vm = require('vm');
const {spawnSync} = require('child_process');

const here = name => path.join(__dirname, '..', name);
const mask = '[-1,0,9,16,9,0,-1]/16@-3', file = path.join(process.argv[2], 'four-point-by-hand.cert');
const claim = (lower, certificate) => ['--mask', mask, '--arity', '2', '--lower', lower, certificate];
const verified = `VERIFIED 2 <= Hoelder exponent of ${mask} with arity 2`;

const run = (...words) => {
  const {status, stdout, stderr} = spawnSync(process.execPath, [here('main.js'), ...words], {encoding: 'utf8'});
  return [status, stdout, stderr];
};
assert.deepStrictEqual(run(...claim('2', file)), [0, `${verified}\n`, '']);
assert.deepStrictEqual(run(...claim('3', file)), [1, 'REJECTED the bound does not prove the claim, line 11\n', '']);
assert.deepStrictEqual(run(...claim('2', 'none')), [66, '', 'subcert-check: cannot read none\n']);
assert.strictEqual(run('--unknown')[0], 64);
const full = fs.openSync('/dev/full', 'w');
assert.strictEqual(spawnSync(process.execPath, [here('main.js'), ...claim('2', file)], {stdio: ['ignore', full, 'ignore']}).status, 1);

const page = vm.createContext({});
vm.runInContext(fs.readFileSync(here('checker.js'), 'utf8'), page);
assert.deepStrictEqual(Object.keys(page), ['check_certificate']);
const {exit, line} = page.check_certificate(claim('2', 'a name'), name => {
  assert.strictEqual(name, 'a name');
  return fs.readFileSync(file, 'latin1');
});
assert.deepStrictEqual([exit, line], [0, verified]);

// Texts that are no certificates: an answer, in little time and memory, whatever they are
const start = 'subcert-certificate 3\nexponent [1,2,1]/2 2\nbounds - -\nsum-rules 1\n';
const {check_certificate} = require(here('checker.js'));
const is_rejected = (text, ...claim) => {
  const answer = check_certificate([...claim, '--lower', '1/2', 'x'], () => text);
  assert.strictEqual(answer.exit, 1);
  assert.match(answer.line, /^REJECTED .*, line \d+$/);
};
for (const text of ['', '\n', '\0', start, `${start}block 0 polytope 268435456 4096 4096\n${'vertex 0\n'.repeat(9)}`,
                    `${start}block 0 norm 64\n`, `${start}product 0 1 0${' 0'.repeat(4096)}\n`, ' '.repeat(2 ** 24 + 2),
                    `${start}block 0 quadratic 1 1${'0'.repeat(1999)}\nform 1\nword${' 0'.repeat(1000)}\n`,
                    `${start.replace('rules 1', 'rules 2')}block 0 single 1 4096\nsquare 1\nfactor${' 0'.repeat(1000)}\n` +
                      `recurrence${` 1${'0'.repeat(1999)}`.repeat(1000)}\n`])
  is_rejected(text, '--mask', '[1,2,1]/2', '--arity', '2');
// differences of points that are far apart
is_rejected('subcert-certificate 3\nsurface [1,2,1]/2@-1000000000 [2]\nbounds 1 -\nsum-rules 1\ndigits -1000000000 999999999\n' +
            'space 1\nvector 0:1 1:-2 2:1\nblock 0 norm 1\nend\n', '--surface', '[1,2,1]/2@-1000000000', '--dilation', '[2]');
// what a search with going back over the text would take days for; points that are too many with their mirror images
const curve = ['--mask', '[1,2,1]/2', '--arity', '2'];
is_rejected(start.replace('sum-rules 1', `reduced ${'[]/'.padEnd(2 ** 21, ']/')}@@ [1]`), ...curve);
is_rejected(start.replace('sum-rules 1', `reduced ${'['.repeat(2 ** 22)} [1]`), ...curve);
const points = Array.from({length: 600000}, (_, i) => `${i}:1`).join(' ');
is_rejected('subcert-certificate 3\nsurface [1,2,1]/2@-1 [2]\nbounds 1 1\nsum-rules 2\ndigits 0 1\nspace 1\nvector -1:1 0:-2 1:1\n' +
            `gram ${points}\nproduct 0 1/2 0 0\nblock 0 norm 1\nend\n`, '--surface', '[1,2,1]/2@-1', '--dilation', '[2]');
console.log('passed');
