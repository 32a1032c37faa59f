// SPDX-License-Identifier: GPL-3.0-or-later

function askRenderer(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const renderer = names ? String(context?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(renderer);
}

/** No graphics card: shadows and smooth edges would make every picture late. The address may ask for them all the same (draw=fine). */
export const drawsInSoftware = askRenderer() && !new URLSearchParams(location.search).has('draw', 'fine');
