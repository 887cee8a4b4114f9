// reached.js PLACES: what of checker.js each command line runs. PLACES is a file with a list of JSON of offsets in checker.js,
// in order. Each line of standard input is a list of JSON, a folder and a command line; the line of output that answers it is
// the list of the indices of those places that were run, in functions or when checker.js was loaded. The innermost range of
// V8's report around a place counts.
'use strict';
const fs = require('fs');
const path = require('path');
const {Session} = require('inspector');

const session = new Session(), places = JSON.parse(fs.readFileSync(process.argv[2], 'latin1'));
session.connect();

function take() {
  let functions = [];
  session.post('Profiler.takePreciseCoverage', (error, report) => {
    functions = report.result.filter(({url}) => url.endsWith('/checker.js')).flatMap(script => script.functions);
  });
  const ranges = functions.flatMap(one => one.ranges).sort((a, b) => a.startOffset - b.startOffset || b.endOffset - a.endOffset);
  const counts = new Map();
  let first = 0;
  for (const {startOffset, endOffset, count} of ranges) {
    while (first < places.length && places[first] < startOffset) ++first;
    for (let i = first; i < places.length && places[i] < endOffset; ++i) counts.set(i, count);
  }
  return [...counts.keys()].filter(i => counts.get(i) > 0);
}

session.post('Profiler.enable');
session.post('Profiler.startPreciseCoverage', {callCount: true, detailed: true});
const {check_certificate} = require('../checker.js');
const loaded = take();

function read_text(folder, name) {
  try {
    return fs.readFileSync(path.resolve(folder, name), 'latin1');
  } catch (error) {
    return null;
  }
}

require('readline').createInterface({input: process.stdin}).on('line', line => {
  const [folder, words] = JSON.parse(line);
  check_certificate(words, name => read_text(folder, name));
  console.log(JSON.stringify([...new Set([...loaded, ...take()])]));
});
