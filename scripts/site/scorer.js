// SPDX-License-Identifier: GPL-3.0-or-later
// The order of what a search finds: pages that explain come before the lists of names.
var Scorer = {
    score: ([page, , , , score]) => /^docs\/(?!reference)/.test(page) ? score + 20 : /^(docs\/reference\/(cpp|python)|CHANGELOG)/.test(page) ? score - 5 : score,
    objNameMatch: 11,
    objPartialMatch: 6,
    objPrio: { 0: 15, 1: 5, 2: -5 },
    objPrioDefault: 0,
    title: 15,
    partialTitle: 7,
    term: 5,
    partialTerm: 2,
};
