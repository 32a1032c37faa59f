// SPDX-License-Identifier: GPL-3.0-or-later
// Which page of the studio an address names.

const PAGE = 'page';
const LAYOUTS = 'layout';
/** The layout to begin with, beside the page. */
const BEGIN = 'layout';

/** The address of the page of layouts, or of surfaces: with the token and the other keys of this one. */
export function pageAddress(page: 'layout' | null, search = location.search): string {
  const query = new URLSearchParams(search);
  query.delete(PAGE);
  query.delete(BEGIN);
  if (page) query.set(PAGE, LAYOUTS);
  return `/?${query}`;
}

export const drawsLayouts = (search = location.search): boolean => new URLSearchParams(search).get(PAGE) === LAYOUTS;
/** The name or path of the layout to begin with. */
export const firstLayout = (search = location.search): string => new URLSearchParams(search).get(BEGIN) || 'paper7';
