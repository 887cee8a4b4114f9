// Cells that tell where their number comes from. What is told stands in #details, by the names of the links to the
// cells; a link to a cell opens it.
'use strict';

(() => {
  const told = JSON.parse(document.getElementById('details').textContent);
  const panel = document.createElement('aside');
  panel.className = 'details-panel';
  panel.hidden = true;
  panel.tabIndex = -1;
  panel.setAttribute('aria-label', 'About this result');
  document.body.append(panel);
  let opened = null;

  const made = (name, content, className = '') => {
    const element = document.createElement(name);
    element.className = className;
    element.append(...[content].flat());
    return element;
  };

  // A text with a button that copies it.
  function copied(text, label) {
    const button = made('button', 'copy', 'copy');
    button.type = 'button';
    button.setAttribute('aria-label', 'copy ' + label);
    button.onclick = async () => {
      try {
        await navigator.clipboard.writeText(text);
      } catch {  // pages that were opened from a file
        const area = made('textarea', text);
        document.body.append(area);
        area.select();
        document.execCommand('copy');
        area.remove();
      }
      button.textContent = 'copied';
      setTimeout(() => { button.textContent = 'copy'; }, 1500);
    };
    return [made('code', text), ' ', button];
  }

  // A text in which documents of the project are links to what stands beside the page.
  const withDocuments = text => withMinus(text).split(/(docs\/[\w/-]+\.md)/).map((part, i) => {
    if (i % 2 === 0) return part;
    const link = made('a', part);
    link.href = part.replace(/(\/README)?\.md$/, '.html');
    return link;
  });

  function open(key) {
    const {verdict, subject, command, ...rest} = told[key], list = document.createElement('dl');
    const add = (name, content) => content && list.append(
      made('dt', name), made('dd', typeof content === 'string' ? withMinus(content) : content));
    add('verdict', made('span', verdict, 'verdict ' + verdict.replace(' ', '-')));
    add('on record', rest.recorded && 'another verdict: ' + rest.recorded);
    add('scheme', rest.scheme && made('code', rest.scheme));
    add('printed', rest.printed);
    add('computed', rest.computed);
    add('enclosed', rest.lower && rest.upper ? `${rest.lower} … ${rest.upper}`
      : rest.lower ? '≥ ' + rest.lower : rest.upper && '≤ ' + rest.upper);
    add('exactly', rest.exact);
    add('not counted', rest.derived);
    add('why', rest.note && withDocuments(rest.note));
    const proof = document.querySelector(`button.check[data-scheme="${CSS.escape(rest.scheme || '')}"]`);
    if (proof && rest.scheme) {
      const link = made('a', 'certificate of the exponent');
      link.href = '#' + proof.closest('[id]').id;
      add('proof', link);
    }
    add('again by', copied(command, 'the command'));
    add('link', copied(location.href.replace(/#.*/, '') + '#' + key, 'the link'));
    const close = made('button', '×', 'close');
    close.type = 'button';
    close.setAttribute('aria-label', 'close');
    close.onclick = shut;
    panel.replaceChildren(close, made('h2', subject), list);
    panel.hidden = false;
    if (opened) opened.classList.remove('opened');
    opened = document.getElementById(key);
    opened.classList.add('opened');
  }
  function shut() {
    panel.hidden = true;
    if (!opened) return;
    opened.classList.remove('opened');
    opened.focus({preventScroll: true});
    opened = null;
  }

  for (const key in told) {
    const cell = document.getElementById(key);
    if (!cell) continue;
    cell.classList.add('told');
    cell.tabIndex = 0;
    cell.addEventListener('click', event => {
      if (!event.target.closest('a, button') && !String(getSelection())) open(key);
    });
    cell.addEventListener('keydown', event => {
      if (event.target !== cell || (event.key !== 'Enter' && event.key !== ' ')) return;
      event.preventDefault();
      open(key);
      panel.focus();
    });
  }
  document.addEventListener('keydown', event => { if (event.key === 'Escape' && !panel.hidden) shut(); });
  const follow = () => {
    const key = decodeURIComponent(location.hash.slice(1)), target = key && document.getElementById(key);
    for (let part = target; part; part = part.parentElement) if (part.matches('details')) part.open = true;
    if (target) target.scrollIntoView({block: 'center'});
    if (key in told) open(key);
  };
  addEventListener('hashchange', follow);
  follow();
})();
