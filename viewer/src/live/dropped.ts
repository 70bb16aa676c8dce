/** Dropped or chosen files, each with its path in the dropped folder. */

export interface DroppedFile {
  /** Path, such as "arm/meshes/link.stl". */
  path: string;
  file: File;
}

/** Extensions of files that refer to others of a set. */
const MAIN = ["toml", "urdf", "sdf", "xml", "world", "mjcf", "usda", "osim"];
/** Extensions of files that are shown by themselves, and of files that are only parts of these. */
const OTHERS = ["stl", "obj", "ply", "off", "gltf", "glb", "3mf", "dae", "xyz", "mol", "pdb", "ent"];
/** Extensions of tables. They are shown if no other file names them. */
const TABLES = ["csv", "tsv", "xlsx", "xls", "jsonl", "ndjson", "parquet"];
const PARTS = ["mtl", "bin"];

const ending = (path: string): string => path.toLowerCase().split(".").at(-1) ?? "";

/**
 * Returns dropped files and the contents of dropped folders. The entries must be read before the
 * first await.
 */
export async function dropped(data: DataTransfer): Promise<DroppedFile[]> {
  const entries = [...data.items].flatMap((item) => (item.kind === "file" ? (item.webkitGetAsEntry() ?? []) : []));
  // A file that was made by a program has no entry.
  if (entries.length === 0) return [...data.files].map((file) => ({ path: file.name, file }));
  const all = await Promise.all(entries.map((entry) => below(entry)));
  return all.flat();
}

/** Returns chosen files: those of a folder, or single ones. */
export function chosen(files: FileList | null): DroppedFile[] {
  return [...(files ?? [])].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
}

/**
 * Selects the files to open, the first one first, and the files to give to the engine. From a
 * folder, only files that a page can show or a model can refer to are given, because packages
 * contain many others.
 */
export async function sorted(files: DroppedFile[]): Promise<{ sent: DroppedFile[]; opened: DroppedFile[] }> {
  const isWanted = await Promise.all(files.map(async ({ path, file }) => !path.includes("/") || (!isHidden(path) && (await isKnown(path, file)))));
  const rank = ({ path }: DroppedFile): number => {
    const found = MAIN.indexOf(ending(path));
    return found < 0 ? MAIN.length : found;
  };
  const sent = files.filter((_, k) => isWanted[k]).sort((a, b) => rank(a) - rank(b) || (a.path < b.path ? -1 : 1));
  const main = sent.filter((file) => rank(file) < MAIN.length);
  if (main.length > 0) {
    const texts = await Promise.all(main.map(({ file }) => file.text()));
    const isNamed = ({ path }: DroppedFile): boolean => texts.some((text) => text.includes(path.split("/").at(-1) ?? path));
    main.push(...sent.filter((file) => TABLES.includes(ending(file.path)) && !isNamed(file)));
  }
  // Files that refer to no others are each shown.
  const alone = sent.filter(({ path }) => !PARTS.includes(ending(path)));
  return { sent, opened: [main, alone, sent].find(({ length }) => length > 0) ?? [] };
}

// Many XML files are not models, and many TOML files are not scenarios or plans.
async function isKnown(path: string, file: File): Promise<boolean> {
  const has = async (pattern: RegExp): Promise<boolean> => pattern.test(await file.slice(0, 8192).text());
  if (ending(path) === "xml") return has(/<(mujoco|robot|sdf)\b/);
  if (ending(path) === "toml") return has(/^\s*(\[+\s*(body|start|run|tumble|swing|payload)\b|parts\s*=)/m);
  return [...MAIN, ...OTHERS, ...TABLES, ...PARTS].includes(ending(path));
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
  // A reader returns some entries at a time, and none at the end.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, fail) => reader.readEntries(done, fail));
    if (some.length === 0) return found;
    for (const one of some) found.push(...(await below(one)));
  }
}
