/** Files of a request: the document, and the files that it names. */
import { FileType, type TextDocument, Uri, workspace } from "vscode";
import type { Kind } from "./kind";
import { foldersIn, namesIn, plain } from "./references";

/** Files of a request, by names relative to the folder of the document. */
export interface Gathered {
  /** Name of the document. */
  name: string;
  contents: Record<string, string | Uint8Array>;
  /** Address of each file. */
  addresses: Map<string, Uri>;
  /** Remarks on files that are not read, although they exist. */
  left: string[];
}

/** Largest total size of the named files, and of their number. */
const MOST_BYTES = 64 << 20;
const MOST_FILES = 2000;

/** Files that name further files. */
const NAMING = /\.(xml|urdf|sdf|world|mjcf|config|gltf)$/i;

/** Collects the files of a document. Open documents count with their unsaved text. */
export async function gather(document: TextDocument, kind: Kind): Promise<Gathered> {
  const folder = Uri.joinPath(document.uri, "..");
  const workspaceFolder = workspace.getWorkspaceFolder(document.uri)?.uri;
  const policy = workspaceFolder && Uri.joinPath(workspaceFolder, "polhode.toml");
  const config = kind === "robot" && policy && (await read(policy));
  // Policies name files from the folder of the workspace.
  const base = config ? plain(folder.path.slice(workspaceFolder!.path.length)) : "";
  const name = plain(`${base}/${document.uri.path.split("/").at(-1)}`);
  const gathered: Gathered = { name, contents: { [name]: document.getText() }, addresses: new Map([[name, document.uri]]), left: [] };
  if (config) {
    gathered.contents["polhode.toml"] = config;
    gathered.addresses.set("polhode.toml", policy);
  }
  const packages = new Map<string, Promise<Uri[]>>();
  const known = (name: string, where: keyof typeof FOLDERS): Promise<Uri[]> => {
    const key = `${where} ${name}`;
    const found = packages.get(key) ?? FOLDERS[where](name, document.uri).catch((problem) => (gathered.left.push(`packages are not searched: ${String(problem)}`), []));
    packages.set(key, found);
    return found;
  };
  let size = 0;

  const add = async (file: string, address: Uri): Promise<boolean> => {
    const other = gathered.addresses.get(file);
    if (other) {
      if (other.toString() !== address.toString() && (await sizeOf(address)) !== null) gathered.left.push(`${address.fsPath} is not read: another file has its name, ${file}`);
      return true;
    }
    const bytes = await sizeOf(address);
    if (bytes === null) return false;
    if (size + bytes > MOST_BYTES || gathered.addresses.size >= MOST_FILES) {
      gathered.left.push(`${file} is not read: the files of this document have more than ${MOST_BYTES >> 20} MiB, or are more than ${MOST_FILES}`);
      return true;
    }
    const content = await read(address);
    if (content === null) return false;
    size += bytes;
    gathered.contents[file] = content;
    gathered.addresses.set(file, address);
    if (NAMING.test(file)) await follow(typeof content === "string" ? content : new TextDecoder().decode(content), file, address);
    return true;
  };

  const follow = async (text: string, from: string, address: Uri): Promise<void> => {
    const inner = foldersIn(text);
    const starts: [string, Uri][] = [[base, folder], [`${from}/..`, Uri.joinPath(address, "..")]];
    for (const reference of namesIn(text)) {
      const [, inPackage, rest = ""] = /^(?:package|model):\/\/\/?([^/]+)\/?(.*)$/.exec(reference) ?? [];
      if (inPackage !== undefined) {
        const isIn = (root: Uri) => (rest === "" ? addModel(inPackage, root) : add(plain(`${inPackage}/${rest}`), Uri.joinPath(root, rest)));
        const isInOne = async (roots: Uri[]): Promise<boolean> => roots.length > 0 && ((await isIn(roots[0]!)) || isInOne(roots.slice(1)));
        if (!(await isInOne(await known(inPackage, "near")))) await isInOne(await known(inPackage, "far"));
      } else if (!reference.includes("://") && !reference.startsWith("/")) {
        for (const within of ["", ...inner]) {
          for (const [start, at] of starts) await add(plain(`${start}/${within}/${reference}`), Uri.joinPath(at, within, reference));
        }
      }
    }
  };

  const addModel = async (name: string, root: Uri): Promise<boolean> => {
    const entries = await Promise.resolve(workspace.fs.readDirectory(root)).catch(() => []);
    const files = entries.filter(([file, type]) => type === FileType.File && /\.(sdf|config)$/.test(file));
    for (const [file] of files) await add(`${name}/${file}`, Uri.joinPath(root, file));
    return files.length > 0;
  };

  await follow(document.getText(), name, document.uri);
  return gathered;
}

/** Returns the folders that may be a package: in the roots of the settings, and around the document. */
async function near(name: string, from: Uri): Promise<Uri[]> {
  const here = workspace.getWorkspaceFolder(from)?.uri ?? Uri.joinPath(from, "..");
  const roots = workspace.getConfiguration("polhode", from).get<string[]>("roots", []);
  const given = roots.map((root) => (/^(\/|[A-Za-z]:)/.test(root) ? here.with({ path: Uri.file(root).path }) : Uri.joinPath(here, root)));
  const around: Uri[] = [];
  for (let at = Uri.joinPath(from, ".."); at.path.length > 1; at = Uri.joinPath(at, "..")) {
    const manifest = await read(Uri.joinPath(at, "package.xml"));
    const stated = /<name>\s*([^<\s]+)\s*<\/name>/.exec(typeof manifest === "string" ? manifest : new TextDecoder().decode(manifest ?? undefined))?.[1];
    if (stated === name || at.path.split("/").at(-1) === name) around.push(at);
  }
  return [...given.flatMap((root) => [Uri.joinPath(root, name), root]), ...around];
}

/** Returns the packages of that name in the workspace. */
async function far(name: string): Promise<Uri[]> {
  const manifests = await workspace.findFiles(`**/${name.replace(/[^\w.-]/g, "?")}/{package.xml,model.config,model.sdf}`, "**/node_modules/**", 8);
  return manifests.map((file) => Uri.joinPath(file, "..")).sort((a, b) => a.path.localeCompare(b.path));
}

const FOLDERS = { near, far };

async function sizeOf(address: Uri): Promise<number | null> {
  try {
    const { size, type } = await workspace.fs.stat(address);
    return type & FileType.File ? size : null;
  } catch {
    return null;
  }
}

/** Returns the content of a file, or the text of an open document; null if it cannot be read. */
async function read(address: Uri): Promise<string | Uint8Array | null> {
  const open = workspace.textDocuments.find(({ uri }) => uri.toString() === address.toString());
  if (open) return open.getText();
  try {
    return await workspace.fs.readFile(address);
  } catch {
    return null;
  }
}
