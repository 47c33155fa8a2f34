# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes from FreeCAD to Knead and back; without a window, so that scripts and tests use it, too.

Lengths are FreeCAD's [mm]. Parts go as STEP, with the names and colors that FreeCAD writes, into a folder beside the document; what Knead
exports into that folder is taken back. Errors are KneadError, a sentence for a person."""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import FreeCAD

ORIGINAL_KEPT, ORIGINAL_HIDDEN, ORIGINAL_REMOVED = "keep", "hide", "remove"
_SENT = ".sent.json"  # file -> what it was made of, and when
_LONGEST_NAME = 80  # [bytes]


class KneadError(Exception):
    pass


def preferences():
    """Program: path of knead; Original: what becomes of it."""
    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Knead")


def find_program():
    """The path of the program knead: the preference, else in PATH, else where this add-on was installed with it."""
    chosen = preferences().GetString("Program")
    if chosen:
        if os.access(chosen, os.X_OK) and not os.path.isdir(chosen):
            return chosen
        raise KneadError(f"{chosen} is not there or is no program; choose the program knead again.")
    # PREFIX/share/knead/freecad/Knead is where this lies, also behind a link in FreeCAD's folder Mod.
    found = shutil.which("knead") or shutil.which(str(Path(__file__).resolve().parent / "../../../../bin/knead"))
    if not found:
        raise KneadError("The program knead is not found; install Knead, or choose where it is.")
    return found


def folder_of(document):
    """Where files of a document are exchanged: beside it, or, as long as it is not saved, in FreeCAD's folder for it."""
    if document.FileName:
        path = Path(document.FileName)
        folder = path.with_name(path.stem + "-knead")
    else:
        folder = Path(document.TransientDir) / "knead"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise KneadError(f"{folder} cannot be made: {error.strerror}; save the document where you may write.") from None
    return folder


def bodies_of(objects):
    """What of a selection is sent: each once; of a step of a PartDesign body that whole body."""
    bodies = []
    for chosen in objects:
        group = chosen.getParentGeoFeatureGroup()  # what a body is based on is not in it
        body = group if group is not None and group.isDerivedFrom("PartDesign::Body") else chosen
        shape = getattr(body, "Shape", None)
        if shape is not None and shape.Solids and body not in bodies:
            bodies.append(body)
    if not bodies:
        raise KneadError("Nothing solid is selected; select a body, then send it.")
    return bodies


def send(objects):
    """Writes the bodies of a selection as one STEP file. Returns its path."""
    bodies = bodies_of(objects)
    document = bodies[0].Document
    folder = folder_of(document)
    path = folder / (_file_name(bodies[0].Label) + ".step")
    try:
        _step().export(bodies, str(path))
        sent = _sent(folder)
        sent[path.name] = {"objects": [body.Name for body in bodies], "time": path.stat().st_mtime_ns}
        (folder / _SENT).write_text(json.dumps(sent), encoding="utf-8")
    except Exception as error:
        raise KneadError(f"FreeCAD could not write {path}: {error}; look into its report view.") from error
    return str(path)


def _file_name(label):
    """As a file may be called, with room for what is added; names of files are limited by their bytes."""
    name = re.sub(r"[^\w .-]+", "_", label).strip(" .")
    return name.encode()[:_LONGEST_NAME].decode(errors="ignore").strip(" .") or "part"


def start(path):
    """Opens a file in Knead, which goes on by itself."""
    program = find_program()
    # What an AppImage of FreeCAD sets for its own libraries is not for others.
    own = {"LD_LIBRARY_PATH", "PYTHONHOME", "PYTHONPATH", "QT_PLUGIN_PATH", "QT_QPA_PLATFORM_PLUGIN_PATH"}
    environment = {key: value for key, value in os.environ.items() if key not in own}
    try:
        subprocess.Popen([program, path], cwd=os.path.dirname(path), env=environment, start_new_session=True,
                         stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except OSError as error:
        raise KneadError(f"{program} cannot be started: {error.strerror}; choose the program knead again.") from None


def results(document):
    """STEP files that came into the folder of a document, or were changed there, since they were sent; the newest first."""
    folder = folder_of(document)
    sent = _sent(folder)
    found = []
    for path in folder.iterdir():
        if path.suffix.lower() in (".step", ".stp") and path.is_file():
            time = path.stat().st_mtime_ns
            if time != sent.get(path.name, {}).get("time"):
                found.append((time, str(path)))
    return [path for _, path in sorted(found, reverse=True)]


def take_back(document, path=None, original=ORIGINAL_HIDDEN):
    """Imports what Knead exported, the newest without a path, as new objects with their names, where the original is.
    One step to be undone. Returns the objects."""
    if path is None:
        path = next(iter(results(document)), None)
        if path is None:
            raise KneadError(f"Nothing has come back; export the part in Knead as STEP into {folder_of(document)}.")
    originals = _originals(document, path)
    before = set(document.Objects)
    document.openTransaction("Take back from Knead")
    try:
        _step().insert(str(path), document.Name)
        new = [one for one in document.Objects if one not in before]
        solid = [one for one in new if getattr(one, "Shape", None) is not None and one.Shape.Solids]
        if not solid:
            raise KneadError(f"{path} holds no solid; export the part in Knead as STEP again.")
        group = originals[0].getParentGeoFeatureGroup() if originals else None
        if group is not None and not group.isDerivedFrom("PartDesign::Body"):
            for one in new:
                if not one.getParentGeoFeatureGroup():
                    group.addObject(one)
        for one in originals:
            _put_away(document, one, original)
        document.recompute()
        document.commitTransaction()
    except KneadError:
        document.abortTransaction()
        raise
    except Exception as error:
        document.abortTransaction()
        raise KneadError(f"{path} could not be taken back: {error}.") from error
    return solid


def _put_away(document, body, original):
    if original == ORIGINAL_HIDDEN:
        body.Visibility = False
    elif original == ORIGINAL_REMOVED:
        if body.isDerivedFrom("PartDesign::Body"):
            body.removeObjectsFromDocument()
        document.removeObject(body.Name)


def _originals(document, path):
    """What a result came of: by its name, which begins with that of what was sent, else the last that was sent."""
    sent = _sent(Path(path).parent)
    stem = Path(path).stem
    likely = [name for name in sent if stem.startswith(Path(name).stem)]
    name = max(likely, key=len) if likely else max(sent, key=lambda one: sent[one]["time"], default=None)
    objects = [document.getObject(one) for one in sent[name]["objects"]] if name else []
    return [one for one in objects if one is not None]


def _sent(folder):
    try:
        return json.loads((Path(folder) / _SENT).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def _step():
    """FreeCAD's module for STEP; that of the window knows colors, too."""
    if FreeCAD.GuiUp:
        import ImportGui
        return ImportGui
    import Import
    return Import
