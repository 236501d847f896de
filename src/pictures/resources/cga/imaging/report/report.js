'use strict';

// What a page cannot do by itself: show a picture a second time, lay two upon each other, subtract them, hide rows.
// Pictures are embedded once, as the <img> with the id that everything else names.

const all = (selector, within = document) => [...within.querySelectorAll(selector)];

function make(name, properties, ...children) {
    const element = Object.assign(document.createElement(name), properties);
    element.append(...children);
    return element;
}

function copyOf(id, alt) {
    const { src, width, height } = document.getElementById(id);
    return make('img', { src, width, height, alt });
}

// ---------------------------------------------------------------- Slider

function buildSlider(slider) {
    const { left, right, leftName, rightName } = slider.dataset;
    const divider = make('input', { type: 'range', min: 0, max: 100, step: 'any', value: 50 });
    divider.setAttribute('aria-label', `Divider between ${leftName} on the left and ${rightName} on the right`);
    const flip = make('button', { type: 'button', textContent: 'Flip' });
    const blink = make('button', { type: 'button', textContent: 'Blink' });
    const leftTag = make('span', { className: 'tag left', textContent: leftName });
    const rightTag = make('span', { className: 'tag right', textContent: rightName });
    let blinking = 0;

    function show() {
        const cut = Number(divider.value);
        slider.style.setProperty('--cut', `${cut}%`);
        leftTag.hidden = cut <= 0;
        rightTag.hidden = cut >= 100;
        divider.setAttribute('aria-valuetext', `${leftName} ${Math.round(cut)} %, ${rightName} ${Math.round(100 - cut)} %`);
    }
    function flipOver() {
        divider.value = divider.value > 50 ? 0 : 100;
        show();
    }
    function setBlinking(on) {
        clearInterval(blinking);
        // Slower than the three flashes a second that can harm.
        blinking = on ? setInterval(flipOver, 600) : 0;
        blink.setAttribute('aria-pressed', on);
    }
    divider.addEventListener('input', () => { setBlinking(false); show(); });
    flip.addEventListener('click', () => { setBlinking(false); flipOver(); });
    blink.addEventListener('click', () => setBlinking(!blinking));
    setBlinking(false);
    show();

    const line = make('span', { className: 'line' });
    const stage = make('div', { className: 'stage' }, copyOf(right, ''), copyOf(left, ''), divider, line, leftTag, rightTag);
    slider.append(stage, make('div', { className: 'tools' }, flip, blink));
}

// ---------------------------------------------------------------- Difference

async function paintDifference(canvas) {
    const pictures = [canvas.dataset.one, canvas.dataset.other].map((id) => document.getElementById(id));
    await Promise.all(pictures.map((picture) => picture.decode()));
    // As many pixels as the pictures have, which may be fewer than they stand for.
    canvas.width = pictures[0].naturalWidth;
    canvas.height = pictures[0].naturalHeight;
    const context = canvas.getContext('2d');
    context.drawImage(pictures[0], 0, 0);
    context.globalCompositeOperation = 'difference';
    context.drawImage(pictures[1], 0, 0);
    amplify(canvas, canvas.dataset.gain);
}

function amplify(canvas, gain) {
    canvas.style.filter = `brightness(${gain})`;
}

// ---------------------------------------------------------------- Page

// A case is drawn when it is first unfolded: most never are.
function draw(details) {
    if (!details.open || details.dataset.drawn) return;
    details.dataset.drawn = 'yes';
    all('.slider', details).forEach(buildSlider);
    all('canvas.difference', details).forEach(paintDifference);
    all('.gain select', details).forEach((choice) => {
        choice.addEventListener('change', () => all('canvas.difference', details).forEach((canvas) => amplify(canvas, choice.value)));
    });
}

function unfoldTarget() {
    const target = location.hash && document.getElementById(location.hash.slice(1));
    all('details', target || make('div')).forEach((details) => { details.open = true; });
}

function showOnly(severity) {
    all('[data-severity]').forEach((part) => { part.hidden = severity !== 'all' && part.dataset.severity !== severity; });
}

all('details').forEach((details) => {
    details.addEventListener('toggle', () => draw(details));
    draw(details);
});
all('[data-picture]').forEach((place) => place.append(copyOf(place.dataset.picture, '')));
all('input[name=severity]').forEach((choice) => {
    choice.addEventListener('change', () => showOnly(choice.value));
    // A browser that comes back to the page may remember the choice.
    if (choice.checked) showOnly(choice.value);
});
window.addEventListener('hashchange', unfoldTarget);
unfoldTarget();
