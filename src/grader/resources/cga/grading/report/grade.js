'use strict';

// What the pages of the grader add to report.js, whose helpers it uses: the words of the reader's language, and sorting.

const words = document.querySelector('main').dataset;

function translate(slider) {
    const [flip, blink] = all('.tools button', slider);
    const divider = slider.querySelector('input');
    if (!divider) return;
    flip.textContent = words.flip;
    blink.textContent = words.blink;
    divider.setAttribute('aria-label', words.divider.replace('{0}', slider.dataset.leftName).replace('{1}', slider.dataset.rightName));
}

// ---------------------------------------------------------------- Sorting

const collator = new Intl.Collator(document.documentElement.lang, { numeric: true });

// Cells without a value stay at the end, whichever way the rest is sorted.
function compare(one, other, sign) {
    if (one === undefined || other === undefined) return (one === undefined) - (other === undefined);
    const difference = Number(one) - Number(other);
    return sign * (Number.isNaN(difference) ? collator.compare(one, other) : difference);
}

function sortBy(head) {
    const column = [...head.parentNode.children].indexOf(head);
    const descending = head.hasAttribute('aria-sort') ? head.getAttribute('aria-sort') === 'ascending' : head.dataset.first === 'descending';
    all('[aria-sort]', head.parentNode).forEach((other) => other.removeAttribute('aria-sort'));
    head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
    const body = head.closest('table').tBodies[0];
    const value = (row) => row.children[column].dataset.sort;
    body.append(...[...body.rows].sort((one, other) => compare(value(one), value(other), descending ? -1 : 1)));
}

all('.slider').forEach(translate);
all('details').forEach((details) => details.addEventListener('toggle', () => all('.slider', details).forEach(translate)));
all('.sheet th button').forEach((button) => button.addEventListener('click', () => sortBy(button.closest('th'))));
