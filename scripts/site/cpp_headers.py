# SPDX-License-Identifier: GPL-3.0-or-later
"""The public headers of the framework, as Doxygen reads them: what each declares, and what it says of it."""

import dataclasses
import pathlib
import re
import subprocess
import xml.etree.ElementTree as xml

DOXYFILE = """
INPUT = {headers}
STRIP_FROM_PATH = {root}
OUTPUT_DIRECTORY = {out}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = YES
AUTOLINK_SUPPORT = NO
EXTRACT_ALL = YES
WARNINGS = NO
WARN_IF_DOC_ERROR = NO
WARN_IF_INCOMPLETE_DOC = NO
QUIET = YES
"""


def public_headers(framework):
    """The files of each stage that are installed: the HEADERS of its CMakeLists.txt. A list for each stage, in the order of the build."""
    order = re.search(r"foreach\(stage ([\w ]+)\)", (framework / "CMakeLists.txt").read_text())[1].split()
    stages = {}
    for stage in order:
        text = re.sub(r"#.*", "", (framework / stage / "CMakeLists.txt").read_text())
        found = []
        for call in re.findall(r"fretwork_add_stage\((.*?)\)", text, re.S):
            is_header = False
            for word in call.split():
                if word.isupper() and not word.endswith(".hpp"):
                    is_header = word == "HEADERS"
                elif is_header:
                    found.append(framework / stage / word)
        stages[stage] = found
    return stages


@dataclasses.dataclass
class Symbol:
    """One declaration: its kind in Doxygen's words, its full name, its text as in the header, and its comment."""

    kind: str
    name: str
    text: str
    brief: str
    detail: str
    file: str
    line: int
    members: list = dataclasses.field(default_factory=list)
    is_exempt: bool = False

    @property
    def says_something(self):
        return bool(self.brief or self.detail)


def inline(node):
    """The text of a node as Markdown, without its tail."""
    text = node.text or ""
    for child in node:
        text += block(child) + (child.tail or "")
    return text


def block(node):
    if node.tag == "computeroutput":
        return f"`{''.join(node.itertext())}`"
    if node.tag in ("itemizedlist", "orderedlist"):
        return "\n\n" + "\n".join("- " + inline(item).strip().replace("\n", "\n  ") for item in node) + "\n\n"
    if node.tag in ("programlisting", "verbatim", "preformatted"):
        return "\n\n```text\n" + "".join(node.itertext()).strip("\n") + "\n```\n\n"
    if node.tag in ("para", "simplesect"):
        return inline(node) + "\n\n"
    if node.tag in ("ndash", "mdash", "sp", "nonbreakablespace"):
        return {"ndash": "-", "mdash": "-", "sp": " ", "nonbreakablespace": " "}[node.tag]
    return inline(node)


def words(node):
    """A description as Markdown."""
    return "" if node is None else re.sub(r"\n{3,}", "\n\n", inline(node)).strip()


def plain(node):
    """The text of a declaration's part."""
    return "" if node is None else re.sub(r"\s+", " ", "".join(node.itertext())).strip()


def tidy(text):
    """A declaration as the headers write it: `const Frame& frame`, `std::span<const double>`."""
    text = re.sub(r"\s+", " ", text).strip().replace("< ", "<").replace(" >", ">")
    text = re.sub(r"(\w) \{\}", r"\1{}", text)
    return re.sub(r" ([&*]+) ?(?=[\w,)=]|$)", r"\1 ", text).replace(" ,", ",").replace(" )", ")").strip()


def declaration(member):
    """A member's declaration as text."""
    kind = member.get("kind")
    name = member.findtext("name")
    if kind == "enum":
        values = ", ".join(value.findtext("name") + plain(value.find("initializer")).rjust(0) for value in member.findall("enumvalue"))
        return f"enum class {name} {{ {values} }};"
    template = member.find("templateparamlist")
    prefix = ""
    if template is not None:
        parameters = [" ".join(filter(None, (plain(p.find("type")), plain(p.find("declname"))))) for p in template]
        prefix = f"template <{', '.join(parameters)}>\n"
    if kind == "typedef":
        return f"{prefix}using {name} = {tidy(plain(member.find('type')).removeprefix('typedef '))};"
    if member.get("static") == "yes":
        prefix += "static "
    if kind == "variable":
        text = f"{plain(member.find('type'))} {name}{plain(member.find('argsstring'))} {plain(member.find('initializer'))}"
    else:
        text = f"{plain(member.find('type'))} {name}{plain(member.find('argsstring'))}"
    return prefix + tidy(text) + ";"


def is_exempt(member):
    """Moves, destructors and what is defaulted, deleted or overridden say nothing of their own."""
    arguments = plain(member.find("argsstring"))
    name = member.findtext("name")
    type_text = plain(member.find("type"))
    return (arguments.endswith(("=default", "= default", "=delete", "= delete")) or name.startswith("~")
            or member.find("reimplements") is not None or " override" in arguments or type_text.startswith("friend")
            or member.get("kind") == "friend" or re.fullmatch(r"\(\w+ ?&& ?\w*\) ?noexcept", arguments) is not None)


def read_member(member):
    place = member.find("location")
    symbol = Symbol(member.get("kind"), member.findtext("name"), declaration(member), words(member.find("briefdescription")),
                    words(member.find("detaileddescription")), place.get("declfile") or place.get("file"),
                    int(place.get("declline") or place.get("line")), is_exempt=is_exempt(member))
    if symbol.kind == "enum":
        symbol.members = [Symbol("enumvalue", value.findtext("name"), value.findtext("name"), words(value.find("briefdescription")),
                                 words(value.find("detaileddescription")), symbol.file, symbol.line)
                          for value in member.findall("enumvalue")]
    return symbol


def read_compound(compound):
    place = compound.find("location")
    full = compound.findtext("compoundname")
    members = [read_member(member) for section in compound.findall("sectiondef") for member in section.findall("memberdef")
               if member.get("prot") == "public"]
    template = compound.find("templateparamlist")
    prefix = ""
    if template is not None:
        prefix = "template <" + ", ".join(plain(p.find("type")) for p in template) + "> "
    bases = ", ".join(plain(base) for base in compound.findall("basecompoundref"))
    text = f"{prefix}{compound.get('kind')} {full.rpartition('::')[2]}" + (f" : {bases}" if bases else "")
    return Symbol(compound.get("kind"), full, text, words(compound.find("briefdescription")), words(compound.find("detaileddescription")),
                  place.get("file"), int(place.get("line")), sorted(members, key=lambda symbol: symbol.line))


def read_headers(framework, out):
    """All public symbols outside of namespaces `detail`, by the header (`stage/file.hpp`) that declares them."""
    stages = public_headers(framework)
    out.mkdir(parents=True, exist_ok=True)
    headers = [str(header) for stage in stages.values() for header in stage]
    settings = DOXYFILE.format(headers=" ".join(headers), root=framework, out=out)
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, stdout=subprocess.DEVNULL)
    symbols = {str(header.relative_to(framework)): [] for stage in stages.values() for header in stage}
    for file in sorted((out / "xml").glob("*.xml")):
        if file.name in ("index.xml", "Doxyfile.xml"):
            continue
        for compound in xml.parse(file).getroot():
            keep_compound(compound, symbols)
    return {header: sorted(found, key=lambda symbol: symbol.line) for header, found in symbols.items()}


def keep_compound(compound, symbols):
    name = compound.findtext("compoundname") or ""
    if "detail" in name.split("::") or compound.get("prot") not in (None, "public") or not name.startswith("fretwork"):
        return
    if compound.get("kind") in ("struct", "class"):
        found = [read_compound(compound)]
    elif compound.get("kind") == "namespace":
        found = [read_member(member) for section in compound.findall("sectiondef") for member in section.findall("memberdef")]
        for symbol in found:
            symbol.name = f"{name}::{symbol.name}"
    else:
        return
    for symbol in found:
        header = symbol.file.rpartition("/framework/fretwork/")[2]
        if header in symbols:
            symbols[header].append(symbol)


def undocumented(symbols):
    """`header:line: name` of each symbol that says nothing, in order."""
    silent = []
    for header, found in symbols.items():
        for symbol in found:
            for part in [symbol, *symbol.members]:
                if not part.is_exempt and not part.says_something:
                    name = part.name if part is symbol else f"{symbol.name}::{part.name}"
                    silent.append(f"{header}:{part.line}: {part.kind} {name}")
    return silent


def main():
    import sys
    import tempfile
    root = pathlib.Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory() as folder:
        silent = undocumented(read_headers(root / "framework/fretwork", pathlib.Path(folder)))
    print(*silent, sep="\n")
    print(f"{len(silent)} public symbols without a comment", file=sys.stderr)
    return 1 if silent else 0


if __name__ == "__main__":
    raise SystemExit(main())
