#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages: what a reader types from them, and where their links lead.

    pages.py ROOT [PROGRAMS]     PROGRAMS: folder of the built pcl_* programs

1. Every block of commands is valid bash.
2. Every option in a page, in a block or in the text, is one of the programs or scripts;
   in a block, of the program that is called.
3. Every link leads to a file, and to a heading in it.
"""
import glob
import os
import re
import shlex
import subprocess
import sys

OTHERS = {"cmake", "mpirun", "xvfb-run"}  # whose options are not ours
OF_PCL = {"pcl_viewer", "pcl_ply2vtk", "pcl_icp", "pcl_convert_pcd_ascii_binary", "pcl_passthrough_filter"}


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def pages(root):
    for pattern in ("README.md", "CHANGES.md", "doc/*.md", "doc/tutorials/*.rst"):
        yield from sorted(glob.glob(os.path.join(root, pattern)))


def blocks(path, text):
    """Fenced blocks without a language or of bash; blocks and included scripts of rst."""
    if path.endswith(".md"):
        return re.findall(r"^```(?:bash)?\n((?:(?!```).*\n)*?)```$", text, re.M)
    found = [re.sub(r"^   ", "", b, flags=re.M) for b in re.findall(
        r"^\.\. code-block:: bash\n\n((?:   .*\n|\n)+)", text, re.M)]
    folder = os.path.dirname(path)
    for script in sorted(set(re.findall(r"literalinclude:: (\S+\.sh)", text))):
        found.append(read(os.path.join(folder, script)))
    return found


def commands(block):
    """The words of every command of a block."""
    for line in block.replace("\\\n", " ").split("\n"):
        words = shlex.split(line, comments=True)
        start = 0
        for i, word in enumerate(words + [";"]):
            if word in ("&&", "||", "|", ";"):
                if words[start:i]:
                    yield words[start:i]
                start = i + 1


def our_programs(root):
    names = [os.path.basename(p) for p in glob.glob(os.path.join(root, "tools/*.cpp"))]
    return {"pcl_" + name[:-4] for name in names} | {"pcl_simulate_indoor_scan"}


def known_options(root, programs):
    """The options of every program and script, by its name."""
    known = {}
    for path in glob.glob(os.path.join(programs, "pcl_*")) if programs else []:
        told = subprocess.run([path, "-h"], capture_output=True, text=True, check=False)
        known[os.path.basename(path)] = set(re.findall(r"--[a-z][a-z-]*", told.stdout)) | {"-h"}
    for path in glob.glob(os.path.join(root, "test/*/*.py")):
        folder = os.path.dirname(path)
        text = read(path)
        for package, module in re.findall(r"^from (\w+) import (\w+)$", text, re.M):
            imported = os.path.join(folder, package, module + ".py")
            text += read(imported) if os.path.exists(imported) else ""
        known[os.path.basename(path)] = set(re.findall(r'"(--[a-z][a-z-]*)"', text))
    for path in glob.glob(os.path.join(root, "*/*.sh")):
        known[os.path.basename(path)] = set(re.findall(r"--[a-z][a-z-]*", read(path)))
    return known


def wrong_commands(path, text, known, ours):
    for block in blocks(path, text):
        valid = subprocess.run(["bash", "-n"], input=block, capture_output=True, text=True, check=False)
        if valid.returncode:
            yield "no bash: " + valid.stderr.strip()
            continue
        for words in commands(block):
            names = [os.path.basename(w) for w in words]
            called = next((n for n in names if n in known), None)
            yield from ("no such program: " + n for n in names
                        if n.startswith("pcl_") and n not in ours | OF_PCL)
            for word in words[names.index(called):] if called else []:
                option = word.split("=")[0]
                if option.startswith("--") and option not in known[called]:
                    yield called + " has no option " + option


def unknown_options(text, known):
    every = set().union(*known.values())
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    for code in re.findall(r"`+([^`]+)`+", prose):
        if code.split()[0].split("/")[-1] in OTHERS:
            continue
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", code):
            if option not in every:
                yield "no program has " + option


def anchors(path):
    titles = re.findall(r"^#+ (.*)$", read(path), re.M)
    return {re.sub(r"[^\w\- ]", "", t.lower()).replace(" ", "-") for t in titles}


def wrong_links(path, text):
    for link in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
        if link.startswith("http"):
            continue
        file, _, anchor = link.partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
        if not os.path.exists(target):
            yield "no such file: " + link
        elif anchor and anchor not in anchors(target):
            yield "no such heading: " + link


def problems(root, programs):
    known = known_options(root, programs)
    ours = our_programs(root)
    for path in pages(root):
        text = read(path)
        found = list(wrong_links(path, text)) + list(wrong_commands(path, text, known, ours))
        if ours <= set(known) and not path.endswith("CHANGES.md"):  # which names what is gone
            found += list(unknown_options(text, known))
        yield from (os.path.relpath(path, root) + ": " + problem for problem in found)


if __name__ == "__main__":
    FOUND = list(problems(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None))
    print("\n".join(FOUND) or "%d pages" % len(list(pages(sys.argv[1]))))
    sys.exit(1 if FOUND else 0)
