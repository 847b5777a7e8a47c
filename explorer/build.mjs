// Bundles the explorer: `make explorer`. Same sources and lock file, same bytes.
import { build } from "esbuild";
import { readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const HERE = dirname(fileURLToPath(import.meta.url));
const OUT = process.argv[2] ?? join(HERE, "..", "spragsym", "explorer", "assets");

/** Bundles: that of any model, and what closed forms add. The last part of a name is what its exports are called on a page. */
const BUNDLES = { explorer: "src/main.js", style: "src/style.css", "kang_nam/closed_forms": "src/kang_nam/closed_forms.js", "kang_nam/worker": "src/kang_nam/worker.js" };
const inputs = new Set();
for (const [name, source] of Object.entries(BUNDLES)) {
  const { metafile } = await build({
    absWorkingDir: HERE,
    entryPoints: { [name]: source },
    outdir: OUT,
    bundle: true,
    minify: true,
    format: "iife",
    globalName: name.split("/").at(-1),
    target: "es2022",
    charset: "utf8",
    legalComments: "none", // the licences are in the page in full
    logLevel: "warning",
    metafile: true,
  });
  Object.keys(metafile.inputs).forEach((path) => inputs.add(path));
}

/** The licence of a library that is bundled, with its name and version. */
async function licence(name) {
  const folder = join(HERE, "node_modules", name);
  const { version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  const file = (await readdir(folder)).sort().find((entry) => /^licen[cs]e/i.test(entry));
  const text = file ? await readFile(join(folder, file), "utf8") : fromReadme(await readFile(join(folder, "README.md"), "utf8"));
  return `${name} ${version}, ${license}\n\n${text.trim()}\n`;
}

/** The section on the licence, where it has no file of its own. */
function fromReadme(text) {
  return text.slice(text.search(/^#+\s*licen[cs]e/im)).split("\n").slice(1).join("\n");
}

const bundled = [...inputs].map((path) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1]).filter(Boolean);
const licences = await Promise.all([...new Set(bundled)].sort().map(licence));
await writeFile(join(OUT, "licences.txt"), licences.join("\n" + "-".repeat(80) + "\n\n"));
