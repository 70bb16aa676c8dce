/** Files of a request: the document, and the files that it names. */
import { type FileStat, FileType, type TextDocument, Uri, workspace } from "vscode";
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
  let size = 0;

  const add = async (file: string, address: Uri): Promise<boolean> => {
    const other = gathered.addresses.get(file);
    if (other) {
      if (other.toString() !== address.toString() && (await look(address)) !== null) gathered.left.push(`${address.fsPath} is not read: another file has its name, ${file}`);
      return true;
    }
    const stat = await look(address);
    if (stat === null || !(stat.type & FileType.File)) return false;
    if (size + stat.size > MOST_BYTES || gathered.addresses.size >= MOST_FILES) {
      gathered.left.push(`${file} is not read: the files of this document have more than ${MOST_BYTES >> 20} MiB, or are more than ${MOST_FILES}`);
      return true;
    }
    const content = await read(address);
    if (content === null) return false;
    size += stat.size;
    gathered.contents[file] = content;
    gathered.addresses.set(file, address);
    if (NAMING.test(file)) await follow(await textOf(address), file, address);
    return true;
  };

  const follow = async (text: string, from: string, address: Uri): Promise<void> => {
    const inner = foldersIn(text);
    const starts: [string, Uri][] = [[base, folder], [`${from}/..`, Uri.joinPath(address, "..")]];
    for (const reference of namesIn(text)) {
      const [, inPackage, rest = ""] = /^(?:package|model):\/\/\/?([^/]+)\/?(.*)$/.exec(reference) ?? [];
      if (inPackage !== undefined) {
        const roots = packages.get(inPackage) ?? packagesOf(inPackage, document.uri, gathered.left);
        packages.set(inPackage, roots);
        for (const root of await roots) {
          if (rest === "" ? await addModel(inPackage, root) : await add(plain(`${inPackage}/${rest}`), Uri.joinPath(root, rest))) break;
        }
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

/** Returns the folders of a package: in the roots of the settings and around the document; otherwise in the workspace. */
async function packagesOf(name: string, from: Uri, left: string[]): Promise<Uri[]> {
  const isNamed = ({ path }: Uri) => path.split("/").at(-1) === name;
  const here = workspace.getWorkspaceFolder(from)?.uri ?? Uri.joinPath(from, "..");
  const roots = workspace.getConfiguration("polhode", from).get<string[]>("roots", []);
  const given = roots.map((root) => (/^(\/|[A-Za-z]:)/.test(root) ? here.with({ path: Uri.file(root).path }) : Uri.joinPath(here, root)));
  const near = [];
  for (const folder of [...given.map((root) => Uri.joinPath(root, name)), ...given.filter(isNamed)]) if ((await look(folder)) !== null) near.push(folder);
  for (let at = Uri.joinPath(from, ".."); at.path.length > 1; at = Uri.joinPath(at, "..")) {
    const stated = /<name>\s*([^<\s]+)\s*<\/name>/.exec(await textOf(Uri.joinPath(at, "package.xml")))?.[1];
    if (stated === name || isNamed(at)) near.push(at);
  }
  if (near.length > 0) return near;
  const pattern = `**/${name.replace(/[^\w.-]/g, "?")}/{package.xml,model.config,model.sdf}`;
  const search = Promise.resolve(workspace.findFiles(pattern, "**/node_modules/**", 8));
  const found = await search.catch((problem) => (left.push(`the workspace is not searched for the package ${name}: ${String(problem)}`), []));
  return found.map((file) => Uri.joinPath(file, "..")).sort((a, b) => a.path.localeCompare(b.path));
}

async function look(address: Uri): Promise<FileStat | null> {
  return Promise.resolve(workspace.fs.stat(address)).catch(() => null);
}

/** Returns the text of a file; empty if it cannot be read. */
export async function textOf(address: Uri): Promise<string> {
  const content = (await read(address)) ?? "";
  return typeof content === "string" ? content : new TextDecoder().decode(content);
}

/** Returns the content of a file, or the text of an open document; null if it cannot be read. */
async function read(address: Uri): Promise<string | Uint8Array | null> {
  const open = workspace.textDocuments.find(({ uri }) => uri.toString() === address.toString());
  return open?.getText() ?? Promise.resolve(workspace.fs.readFile(address)).catch(() => null);
}
