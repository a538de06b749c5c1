// SPDX-License-Identifier: MIT
// Scripts that are loaded when they are needed, from a server or from a file.
const loaded = new Map<string, Promise<unknown>>();

/** The exports of the script NAME.js beside the page (build.mjs). */
export function part<T>(name: string): Promise<T> {
  if (!loaded.has(name))
    loaded.set(name, new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = `${name}.js`;
      script.onload = () => resolve((globalThis as unknown as { nakawariParts: Record<string, T> }).nakawariParts[name]);
      script.onerror = () => reject(new Error(`${name}.js does not load`));
      document.head.append(script);
    }));
  return loaded.get(name) as Promise<T>;
}
