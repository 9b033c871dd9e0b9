#!/usr/bin/env python3
"""Every sentence of the window stands in the files of gui/translations, and the German one is complete.

translations.py SOURCE_DIR LUPDATE [--write]
With --write the files take in new sentences and lose old ones, as a person does before translating.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

source = pathlib.Path(sys.argv[1])
lupdate = sys.argv[2]
files = sorted((source / "gui/translations").glob("*.ts"))
complete = {"de", "en"}  # English needs its plurals only


def messages(file):
    """(context, source, comment) -> translation element"""
    found = {}
    for context in ET.parse(file).getroot().findall("context"):
        for message in context.findall("message"):
            key = (context.findtext("name"), message.findtext("source"), message.findtext("comment"))
            found[key] = message.find("translation")
    return found


def updated(file, folder):
    target = file
    if "--write" not in sys.argv:
        target = folder / file.name
        shutil.copy(file, target)
    plurals = ["-pluralonly"] if file.stem.endswith("_en") else []
    subprocess.run([lupdate, "-I", ".", "-silent", "-locations", "none", "-no-obsolete", *plurals, "gui", "-ts",
                    str(target)], cwd=source, check=True, capture_output=True)
    return messages(target)


trouble = []
with tempfile.TemporaryDirectory() as name:
    for file in files:
        kept = messages(file)
        now = updated(file, pathlib.Path(name))
        language = ET.parse(file).getroot().get("language").split("_")[0]
        for key in now.keys() - kept.keys():
            trouble.append(f"{file.name}: not in it: {key[1]!r} of {key[0]}")
        for key in kept.keys() - now.keys():
            trouble.append(f"{file.name}: nobody says any more: {key[1]!r} of {key[0]}")
        for key, translation in kept.items():
            forms = [form.text or "" for form in translation.findall("numerusform")]
            text = translation.text or "" if not forms else forms[0] if all(forms) else ""
            if not text or translation.get("type"):
                if language in complete:
                    trouble.append(f"{file.name}: not translated: {key[1]!r} of {key[0]}")
                continue
            places = lambda sentence: sorted(set(re.findall(r"%[\dn]", sentence)))
            if places(text) != places(key[1]):
                trouble.append(f"{file.name}: other places for numbers: {key[1]!r}: {text!r}")
if len(files) < 4:
    trouble.append("gui/translations: files of en, de, it and fr expected")
if "--write" not in sys.argv:
    if trouble:
        trouble.append("python3 tests/gui/translations.py . /usr/lib/qt6/bin/lupdate --write takes new sentences in")
    print("\n".join(trouble) or f"{len(files)} languages, German complete")
    sys.exit(1 if trouble else 0)
