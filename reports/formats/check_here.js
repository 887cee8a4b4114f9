// The buttons that check a proof in the page. The checker is the text of #checker; a certificate is a script beside the
// page: file names, and their texts, compressed by gzip, in base64. Each check runs in a worker of its own.
'use strict';

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
}

function verdict_of(words, files) {
  const source = document.getElementById('checker').textContent + `
    onmessage = ({data}) => {
      const start = performance.now();
      const verdict = check_certificate(data.words, name => name in data.files ? data.files[name] : null);
      postMessage({...verdict, seconds: (performance.now() - start) / 1000});
    };`;
  const address = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));
  return new Promise((resolve, reject) => {
    const worker = new Worker(address);
    worker.onmessage = ({data}) => resolve(data);
    worker.onerror = event => reject(new Error(event.message || 'the worker did not start'));
    worker.postMessage({words, files});
  }).finally(() => URL.revokeObjectURL(address));
}

async function check_here(button) {
  const answer = button.nextElementSibling;
  button.disabled = true;
  answer.className = '';
  answer.textContent = 'checking ...';
  try {
    const packed = await load_file(button.dataset.certificate), files = {};
    for (const name in packed) files[name] = await unpacked(packed[name]);
    const {exit, line, seconds} = await verdict_of(JSON.parse(button.dataset.words), files);
    answer.className = exit === 0 ? 'proved' : 'refused';
    answer.textContent = `${line} (${seconds.toFixed(2)} s)`;
  } catch (error) {
    answer.className = 'refused';
    answer.textContent = 'not checked: ' + error.message;
  }
  button.disabled = false;
}

for (const button of document.querySelectorAll('button.check')) button.onclick = () => check_here(button);
