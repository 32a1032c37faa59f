// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the equations of a page. One that KaTeX cannot read stays as text, in red; a test looks for these.
document.addEventListener('DOMContentLoaded', () => {
    for (const place of document.querySelectorAll('.equation'))
        katex.render(place.textContent, place, { displayMode: place.tagName === 'DIV', throwOnError: false });
});
