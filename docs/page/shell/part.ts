// SPDX-License-Identifier: MIT
// Scripts that are loaded when they are needed, from a server or from a file.
const scope = globalThis as unknown as { nakawariParts?: Record<string, unknown> };
const loaded = new Map<string, Promise<unknown>>();

/** The exports of the script NAME.js beside the page (build.mjs). */
export function part<T>(name: string): Promise<T> {
  if (!loaded.has(name))
    loaded.set(name, new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = `${name}.js`;
      script.onload = () => resolve(scope.nakawariParts![name]);
      script.onerror = () => {
        loaded.delete(name); // the next call tries again
        reject(new Error(`${name}.js does not load`));
      };
      document.head.append(script);
    }));
  return loaded.get(name) as Promise<T>;
}

/** A module of the second script (build.mjs), when the library of that script is ready. */
export async function later(name: string): Promise<unknown> {
  const all = await part<Record<string, unknown>>('exhibits');
  await all.ready;
  return all[name];
}
