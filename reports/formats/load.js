// Files beside the page, or inside it as #file:NAME. A page that was opened from a file may not read other files, but it
// may run scripts: each is a call of subcert_file with its own name and what it has to give.
'use strict';

const loaded_files = new Map();  // of a name what the script of that name will give, and what is to be done then

function subcert_file(name, content) {
  loaded_files.get(name).resolve(content);
}

function load_file(script) {
  const inside = document.getElementById('file:' + script);
  if (inside) return Promise.resolve(JSON.parse(inside.textContent));
  if (!loaded_files.has(script)) {
    const entry = {};
    entry.content = new Promise((resolve, reject) => Object.assign(entry, {resolve, reject}));
    loaded_files.set(script, entry);
    const element = document.createElement('script');
    element.onerror = () => {
      loaded_files.delete(script);
      entry.reject(new Error(script + ' is not beside this page'));
    };
    element.src = script;
    document.head.append(element);
  }
  return loaded_files.get(script).content;
}
