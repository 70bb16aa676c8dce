/** Names of files in the text of models and scenarios. */

/** Files that have no mass: pictures, materials, programs. */
const UNUSED = /\.(png|jpe?g|tga|bmp|gif|hdr|mtl|material|so|py)$/i;

/** Returns the names in quotes or between tags that look like files, and the models of SDF. */
export function namesIn(text: string): Set<string> {
  const names = new Set<string>();
  for (const [, name] of text.matchAll(/["'>]\s*((?:[a-z]+:\/\/)?[^"'<>\n]{0,400}?\.(?:3mf|[a-z][a-z0-9]{1,7}))\s*["'<]/gi)) if (!UNUSED.test(name!)) names.add(name!);
  for (const [, name] of text.matchAll(/["'>]\s*(model:\/\/[^"'<>\s]+)/g)) names.add(name!);
  return names;
}

/** Returns the folders of meshes that MJCF states. */
export function foldersIn(text: string): string[] {
  return [...text.matchAll(/\b(?:mesh|asset)dir\s*=\s*["']([^"'\n]*)["']/g)].map(([, folder]) => folder!);
}

/** Returns a path without empty parts, "." and "..". As in the module, ".." at the top has no effect. */
export function plain(path: string): string {
  const parts: string[] = [];
  for (const part of path.split("/")) {
    if (part === "..") parts.pop();
    else if (part !== "" && part !== ".") parts.push(part);
  }
  return parts.join("/");
}
