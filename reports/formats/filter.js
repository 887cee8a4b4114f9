// A list of results or entries: rows that are not asked for are hidden. What is asked for stands in the link, behind ?
// where a link leads here, behind # where a reader has chosen.
'use strict';

(() => {
  const form = document.querySelector('form.filter'), count = form.querySelector('output');
  const rows = [...document.querySelectorAll('table.results tbody tr, table.entries tbody tr')];
  const texts = rows.map(row => {
    const text = row.textContent.toLowerCase();
    return text + ' ' + asTyped(text);
  });

  const asked_by_link = () => location.hash.slice(1) || location.search.slice(1);

  function show() {
    const asked = new FormData(form), words = asked.get('search').toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach((row, i) => {
      const wanted = words.every(word => texts[i].includes(word)) &&
                     ['verdict', 'paper', 'kind'].every(name => !asked.get(name) ||
                       [row.dataset[name], row.dataset.truth].includes(asked.get(name)));
      row.hidden = !wanted;
      shown += wanted;
    });
    count.textContent = `${shown} of ${rows.length}`;
    const link = new URLSearchParams([...asked].filter(([, value]) => value)).toString();
    if (link !== asked_by_link()) history.replaceState(null, '', '#' + link);
  }
  function follow() {
    const asked = new URLSearchParams(asked_by_link());
    for (const field of form.elements) if (field.name) field.value = asked.get(field.name) || '';
    show();
  }
  form.hidden = false;
  form.addEventListener('input', show);
  form.addEventListener('reset', () => setTimeout(show));
  form.addEventListener('submit', event => event.preventDefault());
  addEventListener('hashchange', follow);
  follow();
})();
