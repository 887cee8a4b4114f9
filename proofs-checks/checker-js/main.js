#!/usr/bin/env node
// The command line of checker.js under node: the same options, lines and exit codes as those of subcert-check. With
// --many each line of standard input is a command line, a JSON list of words, and each line of output its JSON result.
'use strict';
const fs = require('fs');
const {check_certificate} = require('./checker.js');

const max_size = 2 ** 28;  // of a file: longer ones are refused unread
function read_text(path) {
  try {
    const stat = fs.statSync(path), {size} = stat;
    if (!stat.isFile()) return null;
    return size > max_size ? ' '.repeat(max_size + 1) : fs.readFileSync(path, 'latin1');
  } catch (error) {
    return null;
  }
}

const words = process.argv.slice(2);
if (words.length === 1 && words[0] === '--many') {
  const lines = require('readline').createInterface({input: process.stdin});
  lines.on('line', line => console.log(JSON.stringify(check_certificate(JSON.parse(line), read_text))));
} else {
  const {exit, line} = check_certificate(words, read_text);
  process.exitCode = exit;
  try {
    fs.writeSync(exit > 1 ? 2 : 1, line + '\n');
  } catch (error) {  // 0 is left with only where the claim was printed
    process.exitCode = exit || 1;
  }
}
