# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench offers in FreeCAD's window."""

import os

import FreeCAD
import FreeCADGui
import knead_exchange as exchange
from PySide import QtGui

_ICON = os.path.join(os.path.dirname(__file__), "knead.svg")
_ORIGINAL = {"Hide the original": exchange.ORIGINAL_HIDDEN, "Keep it beside": exchange.ORIGINAL_KEPT,
             "Remove it": exchange.ORIGINAL_REMOVED}


def _say(error):
    FreeCAD.Console.PrintError(f"Knead: {error}\n")
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Knead", str(error))


def choose_program():
    """Asks where knead is. Returns whether a person said so."""
    path = QtGui.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), "Where is the program knead?")[0]
    if path:
        exchange.preferences().SetString("Program", path)
    return bool(path)


class Send:
    def GetResources(self):
        return {"MenuText": "Send to Knead", "Pixmap": _ICON,
                "ToolTip": "Opens the selected bodies in Knead, as lumps of material"}

    def IsActive(self):
        return bool(FreeCADGui.Selection.getSelection())

    def Activated(self):
        try:
            try:
                exchange.find_program()
            except exchange.KneadError as error:
                _say(error)
                if not choose_program():
                    return
            exchange.start(exchange.send(FreeCADGui.Selection.getSelection()))
        except exchange.KneadError as error:
            _say(error)


class TakeBack:
    def GetResources(self):
        return {"MenuText": "Take back from Knead", "Pixmap": _ICON,
                "ToolTip": "Brings what Knead exported as STEP beside the part that was sent"}

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        document = FreeCAD.ActiveDocument
        try:
            files = exchange.results(document)
            path = self._choice("Which file?", {os.path.basename(one): one for one in files}) if len(files) > 1 else None
            if len(files) > 1 and path is None:
                return
            original = self._choice("What becomes of the original?", _ORIGINAL) if files else exchange.ORIGINAL_KEPT
            if original is not None:
                exchange.take_back(document, path, original)
        except exchange.KneadError as error:
            _say(error)

    @staticmethod
    def _choice(question, answers):
        word, is_chosen = QtGui.QInputDialog.getItem(FreeCADGui.getMainWindow(), "Knead", question, list(answers), 0, False)
        return answers[word] if is_chosen else None


class Program:
    def GetResources(self):
        return {"MenuText": "Where Knead is...", "ToolTip": "Chooses the program knead"}

    def IsActive(self):
        return True

    def Activated(self):
        choose_program()


COMMANDS = {"Knead_Send": Send, "Knead_TakeBack": TakeBack, "Knead_Program": Program}
for name, command in COMMANDS.items():
    FreeCADGui.addCommand(name, command())
