/** What was dropped or chosen: files, each with its path in the folder that was. */

export interface DroppedFile {
  /** "arm/meshes/link.stl" */
  path: string;
  file: File;
}

/** Of a set, the files that name the others. */
const MAIN = ["toml", "urdf", "sdf", "xml", "world", "mjcf", "usda", "osim", "gltf"];
const OTHERS = ["stl", "obj", "mtl", "ply", "off", "glb", "3mf", "dae", "xyz", "mol", "pdb", "ent", "csv", "bin"];

const ending = (path: string): string => path.toLowerCase().split(".").at(-1) ?? "";

/** Files and folders that were dropped, with what is in them. Their entries are to be asked for before anything is waited for. */
export async function dropped(data: DataTransfer): Promise<DroppedFile[]> {
  const entries = [...data.items].flatMap((item) => (item.kind === "file" ? (item.webkitGetAsEntry() ?? []) : []));
  // A file that a program made has no entry.
  if (entries.length === 0) return [...data.files].map((file) => ({ path: file.name, file }));
  const all = await Promise.all(entries.map((entry) => below(entry)));
  return all.flat();
}

/** Files that were chosen: of a folder, or one by one. */
export function chosen(files: FileList | null): DroppedFile[] {
  return [...(files ?? [])].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
}

/**
 * Those to be opened, the first of them first; and those that go to the server. Of a folder only what a page can show, or a model can name:
 * a package has much else.
 */
export async function sorted(files: DroppedFile[]): Promise<{ sent: DroppedFile[]; opened: DroppedFile[] }> {
  const isWanted = await Promise.all(files.map(async ({ path, file }) => !path.includes("/") || (!isHidden(path) && (await isKnown(path, file)))));
  const rank = ({ path }: DroppedFile): number => {
    const found = MAIN.indexOf(ending(path));
    return found < 0 ? MAIN.length : found;
  };
  const sent = files.filter((_, k) => isWanted[k]).sort((a, b) => rank(a) - rank(b) || (a.path < b.path ? -1 : 1));
  // Those that name no others are each shown.
  const opened = sent.filter((file) => rank(sent[0]) === MAIN.length || rank(file) < MAIN.length);
  return { sent, opened };
}

// Much is XML that is no model.
async function isKnown(path: string, file: File): Promise<boolean> {
  if (ending(path) === "xml") return /<(mujoco|robot|sdf)\b/.test(await file.slice(0, 8192).text());
  return [...MAIN, ...OTHERS].includes(ending(path));
}

const isHidden = (path: string): boolean => path.split("/").some((name) => name.startsWith("."));

async function below(entry: FileSystemEntry): Promise<DroppedFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((done, fail) => (entry as FileSystemFileEntry).file(done, fail));
    return [{ path: entry.fullPath.replace(/^\//, ""), file }];
  }
  if (entry.name.startsWith(".")) return [];
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: DroppedFile[] = [];
  // A reader gives some at a time, and none at the end.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, fail) => reader.readEntries(done, fail));
    if (some.length === 0) return found;
    for (const one of some) found.push(...(await below(one)));
  }
}
