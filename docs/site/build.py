#!/usr/bin/env python3
"""Builds the site of the documents: build.py --program PROGRAM --work FOLDER --out FOLDER

The pages of docs/, README.md and what results/ says are taken as they stand; links out of the site's pages become links to copies
of the files. What is generated: the commands from their --help, the C++ faces by Doxygen, the C interface from the comments of its
header, the gallery from results/. Nothing is loaded from a network. WORK is emptied; OUT appears whole, or stays as it was.
"""

import argparse
import html
import json
import os
import posixpath
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folders of the sources stay as they are
sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_links

ROOT = Path(__file__).resolve().parents[2]
# Pages from elsewhere, and what they are called in the site.
PAGES = {
    "README.md": "overview.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "REFERENCES.md": "references.md",
    "results/README.md": "verdicts.md",
    "results/errata.md": "errata.md",
}
# Pages that are generated, as the others link to them.
GENERATED = ["gallery.md", "reference/options.md", "reference/c.md", "reference/cpp/index.rst"]
MATHJAX = Path("/usr/share/javascript/mathjax")
# The modules in their dependency order, and the headers that a user includes in addition to the umbrella headers.
MODULES = {
    "scalar": ["number/exact.hpp", "scalar/precision_scope.hpp", "scalar/error.hpp", "scalar/decimal.hpp"],
    "digits": [],
    "series": [],
    "algebra": [],
    "approximant": ["approximant/asymptotic.hpp"],
    "convergence": [],
    "ode": [
        "expansion/ball_expansion.hpp",
        "expansion/tail_bound.hpp",
        "query/states.hpp",
        "query/condition_numbers.hpp",
        "integration/proved_march.hpp",
        "query/proved_events.hpp",
        "event/zero_search.hpp",
        "algebra/krawczyk.hpp",
        "query/shooting/proved_unknowns.hpp",
        "query/shooting/periodic_orbit.hpp",
        "query/shooting/solution_branch.hpp",
        "plane/radius_bound.hpp",
        "plane/proved_singularity.hpp",
    ],
    "elliptic": [
        "elliptic/digits_enclosure.hpp",
        "elliptic/function_condition.hpp",
        "elliptic/named_function.hpp",
        "elliptic/proved_functions.hpp",
        "elliptic/theta_values.hpp",
    ],
    "pendulum": [
        "pendulum/digits_enclosure.hpp",
        "pendulum/proved_norm.hpp",
        "pendulum/condition.hpp",
        "pendulum/proved_motion.hpp",
        "pendulum/proved_states.hpp",
        "pendulum/proved_theta.hpp",
    ],
    "problem": ["problem/catalogue.hpp"],
}


def fail(message):
    sys.exit(f"build.py: {message}")


class Stage:
    """The sources of the site, and the files that its pages link to."""

    def __init__(self, work):
        self.source = work / "source"
        self.extra = work / "extra"
        self.pages = PAGES | {f"docs/{page}": page for page in GENERATED}
        for page in sorted((ROOT / "docs").rglob("*.md")):
            path = page.relative_to(ROOT)
            self.pages[str(path)] = str(path.relative_to("docs"))
        for notebook in sorted((ROOT / "docs").rglob("*.ipynb")):
            path = notebook.relative_to(ROOT)
            self.pages[str(path)] = str(path.relative_to("docs").with_suffix(".md"))

    def take_pages(self):
        for path, name in self.pages.items():
            if name in GENERATED:
                continue
            target = self.source / name
            target.parent.mkdir(parents=True, exist_ok=True)
            text = markdown_of_notebook(ROOT / path, target) if path.endswith(".ipynb") else (ROOT / path).read_text()
            target.write_text(self.linked(text, path, name))
            if path.endswith(".ipynb"):
                (self.extra / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / path, (self.extra / name).with_suffix(".ipynb"))

    def linked(self, text, path, name):
        """The text with the links of the repository made those of the site, outside of code."""
        parts = re.split(r"(^ *```.*?^ *```$|`[^`\n]*`)", text, flags=re.M | re.S)
        # A link's text may hold code, so links are searched in the whole text, and code is put aside.
        codes = parts[1::2]
        hidden = "".join(part if i % 2 == 0 else f"\x00{i // 2}\x00" for i, part in enumerate(parts))
        folder, here = posixpath.dirname(path), posixpath.dirname(name)

        def image(match):
            target = match[2]
            if "://" in target or path.endswith(".ipynb"):
                return match[0]
            file = posixpath.normpath(posixpath.join(folder, target))
            if not (ROOT / file).is_file():
                fail(f"{path} shows '{target}', which does not exist")
            copy = self.source / "images" / file.replace("/", "-")
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(ROOT / file, copy)
            return f"![{match[1]}]({posixpath.relpath('images/' + copy.name, here or '.')})"

        def link(match):
            words, target = match[1], match[2]
            if "://" in target or target.startswith(("#", "mailto:")):
                return match[0]
            target, _, anchor = target.partition("#")
            file = posixpath.normpath(posixpath.join(folder, target))
            anchor = f"#{anchor}" if anchor else ""
            if file in self.pages:
                return f"[{words}]({posixpath.relpath(self.pages[file], here or '.')}{anchor})"
            address = posixpath.relpath(self.copied(file, path, target), here or ".")
            return f'<a href="{address}">{words}</a>'

        hidden = re.sub(r"!\[([^\]]*)\]\(([^)\s]+)\)", image, hidden)
        hidden = re.sub(r"(?<!!)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))+)\]\(([^)\s]+)\)", link, hidden)
        return re.sub(r"\x00(\d+)\x00", lambda match: codes[int(match[1])], hidden)

    def copied(self, file, path, target):
        """The place in the site of a file or folder of the repository; sources get the ending .txt, which browsers show."""
        if file == "results" or file.startswith("results/"):
            if not (ROOT / file).exists():
                fail(f"{path} links to '{target}', which does not exist")
            return file
        if (ROOT / file).is_dir():
            return self.listed(file, path, target)
        if not (ROOT / file).is_file():
            fail(f"{path} links to '{target}', which does not exist")
        copy = self.extra / "files" / (file + ("" if file.endswith((".svg", ".png", ".html")) else ".txt"))
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / file, copy)
        return f"files/{copy.relative_to(self.extra / 'files')}"

    def listed(self, folder, path, target):
        """A page with the files of a folder, and its place."""
        page = ["<!DOCTYPE html>", '<html lang="en"><meta charset="utf-8">']
        page += ['<meta name="viewport" content="width=device-width, initial-scale=1">', f"<title>{folder}</title>"]
        page += [f"<h1>{folder}</h1>", "<ul>"]
        for each in sorted((ROOT / folder).iterdir()):
            if each.is_dir():
                page.append(f"<li>{each.name}/")
            else:
                address = posixpath.relpath(self.copied(f"{folder}/{each.name}", path, target), "folders")
                page.append(f'<li><a href="{address}">{each.name}</a>')
        name = f"folders/{folder.replace('/', '-')}.html"
        (self.extra / "folders").mkdir(parents=True, exist_ok=True)
        (self.extra / name).write_text("\n".join([*page, "</ul></html>", ""]))
        return name


def markdown_of_notebook(notebook, target):
    """The notebook with its last outputs; its pictures are next to the page."""
    done = subprocess.run(
        [sys.executable, "-m", "nbconvert", "--to", "markdown", "--output", target.stem, "--output-dir", target.parent, notebook],
        capture_output=True,
        text=True,
    )
    if done.returncode:
        fail(f"{notebook} is not converted: {done.stderr}")
    # Output is an indented block there.
    parts = re.split(r"(^```.*?^```$)", target.read_text(), flags=re.M | re.S)
    parts[::2] = [re.sub(r"(?:^    .*\n|^\n(?=    ))+", lambda match: fenced(match[0]), each, flags=re.M) for each in parts[::2]]
    text = "".join(parts)
    words = f'\n\nThis page is <a href="{notebook.name}">the notebook</a>, as it was executed.\n'
    return text.replace("\n", words, 1)


def fenced(text):
    lines = [line[4:] for line in text.strip("\n").split("\n")]
    if not "".join(lines).strip():
        return "\n"
    return "\n```text\n" + "\n".join(lines) + "\n```\n\n"


def printed(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def command_pages(program, source):
    """The reference of the commands, from --help."""
    whole = printed(program, "--help")
    names = re.findall(r"^  ([a-z]+)(?:  |$)", whole[whole.index("ubcommands") :], flags=re.M)
    if len(names) < 15:
        fail(f"--help of the program names {len(names)} commands: has its form changed?")
    page = ["# All options of all commands", "", "What `libration --help` and `libration COMMAND --help` print.", "By example: [the commands](../commands.md).", ""]
    page += ["", "## libration", "", "```text", whole.rstrip(), "```", ""]
    for name in names:
        page += [f"## {name}", "", "```text", printed(program, name, "--help").rstrip(), "```", ""]
    (source / "reference" / "options.md").write_text("\n".join(page))


def c_page(source):
    """The C interface, from the comments of its header: words, then what they are about."""
    text = (ROOT / "include/libration.h").read_text()
    text = text[: text.rindex("#ifdef __cplusplus")]
    page = ["# The C interface", "", "From the comments of `libration.h`; compile with"]
    page += ["`cc program.c $(pkg-config --cflags --libs libration)`. `libration.f90` has the same names for Fortran.", ""]
    declarations = []

    def flush():
        code = "\n".join(declarations).strip("\n")
        code = re.sub(r"#(?:ifn?def|define LIBRATION_H|include|endif).*\n?|extern \"C\" \{\n?", "", code).strip("\n")
        if code:
            page.extend(["```c", code, "```", ""])
        declarations.clear()

    for part in re.split(r"(^/\*.*?\*/)", text, flags=re.M | re.S):
        if not part.startswith("/*"):
            declarations.append(part)
            continue
        flush()
        words = re.sub(r"^ \* ?|^ {5,}", "", part[2:-2], flags=re.M).strip()
        if match := re.fullmatch(r"---- (.*?):? ?(?:(?<=[:.] )(.*?))?\s*----", words, flags=re.S):
            title, _, rest = " ".join(words.strip("- ").split()).partition(": " if ": " in words[:40] else ". ")
            page += [f"## {title.rstrip('.')}", "", *([rest[0].upper() + rest[1:]] if rest else []), ""]
        else:
            page += [re.sub(r"([<>*_|])", r"\\\1", words), ""]
    flush()
    (source / "reference" / "c.md").write_text("\n".join(page))


def headers_of(module):
    """The headers of a module's page: those that its umbrella header includes, and those named above."""
    umbrella = f"{module}/{module}.hpp"
    of_module = f"{module}/"
    if not (ROOT / "include/libration" / umbrella).exists():  # of several directories
        umbrella, of_module = f"{module}.hpp", ""
    included = re.findall(r'#include "libration/([^"]+)"', (ROOT / "include/libration" / umbrella).read_text())
    found = [each for each in included if each.startswith(of_module)]
    for each in MODULES[module]:
        text = (ROOT / "include/libration" / each).read_text()
        if each.rpartition("/")[2] == "asymptotic.hpp" and "#include" in text:
            found += [each for each in re.findall(r'#include "libration/([^"]+)"', text) if each.startswith(f"{module}/")]
        if re.search(r"^(?:template|class|struct|inline|std|[a-z_:<>]+ [a-z_]+\()", text, flags=re.M):
            found.append(each)
    if re.search(r"^(?:struct|class|template|concept)", (ROOT / "include/libration" / umbrella).read_text(), flags=re.M):
        found.insert(0, umbrella)
    return list(dict.fromkeys(found))


def opening_comment(header):
    lines = []
    for line in (ROOT / "include/libration" / header).read_text().split("\n"):
        if not line.startswith("//"):
            break
        lines.append(line[3:])
    return lines


def cpp_pages(work, source):
    """The public C++ headers: Doxygen reads them, Breathe shows its output."""
    modules = {module: headers_of(module) for module in MODULES}
    inputs = " ".join(f'"{ROOT}/include/libration/{each}"' for headers in modules.values() for each in headers)
    settings = (ROOT / "docs/site/Doxyfile").read_text()
    settings += f'INPUT = {inputs}\nOUTPUT_DIRECTORY = "{work}/doxygen"\nSTRIP_FROM_PATH = "{ROOT}/include"\n'
    (work / "doxygen").mkdir()
    (work / "doxygen" / "Doxyfile").write_text(settings)
    with open(work / "doxygen" / "log", "w") as log:
        subprocess.run(["doxygen", work / "doxygen" / "Doxyfile"], stdout=log, stderr=log, check=True)
    # Private members are not documented, but Doxygen writes them.
    for description in (work / "doxygen" / "xml").glob("*.xml"):
        whole = description.read_text()
        description.write_text(re.sub(r'<sectiondef kind="private-.*?</sectiondef>', "", whole, flags=re.S))
    folder = source / "reference" / "cpp"
    folder.mkdir(parents=True)
    index = ["C++", "===", "", "The public headers by module; :doc:`../../headers` lists them by task."]
    index += ["", ".. toctree::", ""]
    for module, headers in modules.items():
        index.append(f"   {module}")
        title = f"libration/{module}"
        page = [title, "=" * len(title), ""]
        for header in headers:
            name = header.removeprefix(f"{module}/")
            page += [name, "-" * len(name), "", f"``#include <libration/{header}>``", ""]
            page += [".. code-block:: text", "", *[f"   {line}" for line in opening_comment(header)], ""]
            page += [f".. doxygenfile:: libration/{header}", "   :project: libration", ""]
        (folder / f"{module}.rst").write_text("\n".join(page))
    (folder / "index.rst").write_text("\n".join([*index, ""]))


def gallery_page(source):
    page = ["# The report and its figures", ""]
    page += ["`./run reproduce` reproduces the paper, tests its statements and draws these figures."]
    page += ['<a href="results/index.html">The whole report</a> is one page with a short explanation of each figure;']
    page += ["[the verdicts](verdicts.md) and [the corrections](errata.md) are also pages here. Each figure below links to its SVG,"]
    page += ["and its directory contains the numbers.", ""]
    for description in sorted((ROOT / "results").glob("*/*.json")):
        name = description.parent.name
        picture = description.parent / f"{name}.png"
        if not picture.is_file():
            continue
        facts = json.loads(description.read_text())
        page += [f"## {name}", "", f"{facts['question']}", ""]
        page += [f'<a href="results/{name}/{name}.svg"><img src="results/{name}/{name}.png" alt="{name}" loading="lazy"></a>', ""]
        page += [f"`{facts['command'].replace('libration ', './run ', 1)} --out out`", ""]
    (source / "gallery.md").write_text("\n".join(page))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    work = options.work.resolve()
    shutil.rmtree(work, ignore_errors=True)
    stage = Stage(work)
    (work / "source" / "reference").mkdir(parents=True)
    stage.take_pages()
    command_pages(options.program.resolve(), stage.source)
    c_page(stage.source)
    cpp_pages(work, stage.source)
    gallery_page(stage.source)

    # What Debian's MathJax needs for formulas as drawings, without fonts, which browsers do not load from disk.
    for part in ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/input/TeX", "jax/output/SVG", "jax/element"):
        origin, target = MATHJAX / part, work / "static" / "mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(origin, target, dirs_exist_ok=True) if origin.is_dir() else shutil.copyfile(origin, target)
    shutil.copyfile(ROOT / "docs/site/site.css", work / "static" / "site.css")
    version = re.search(r"project\(libration\s+VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    environment = dict(os.environ, LIBRATION_WORK=str(work), LIBRATION_ROOT=str(ROOT), LIBRATION_VERSION=version)
    environment["PYTHONDONTWRITEBYTECODE"] = "1"
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-c", ROOT / "docs/site",
         "-d", work / "doctrees", stage.source, work / "html"],
        env=environment,
    )
    if done.returncode:
        fail("Sphinx reported warnings, above; the site is built only without warnings")
    if stage.extra.is_dir():
        shutil.copytree(stage.extra, work / "html", dirs_exist_ok=True)
    shutil.copytree(ROOT / "results", work / "html" / "results")
    broken = check_links.broken_links(work / "html")
    if broken:
        fail("links that lead nowhere:\n  " + "\n  ".join(broken))

    # Whole: the old site goes when the new one is there.
    options.out.parent.mkdir(parents=True, exist_ok=True)
    old = options.out.with_name(options.out.name + ".old")
    shutil.rmtree(old, ignore_errors=True)
    if options.out.exists():
        options.out.rename(old)
    (work / "html").rename(options.out)
    shutil.rmtree(old, ignore_errors=True)


if __name__ == "__main__":
    main()
