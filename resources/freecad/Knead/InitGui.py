# SPDX-License-Identifier: LGPL-2.1-or-later
import FreeCADGui


class KneadWorkbench(FreeCADGui.Workbench):
    MenuText = "Knead"
    ToolTip = "Press, bend and cut a body as a lump of material"

    def __init__(self):
        import os

        import knead_exchange
        self.__class__.Icon = os.path.join(os.path.dirname(knead_exchange.__file__), "knead.svg")

    def Initialize(self):
        import knead_commands
        names = list(knead_commands.COMMANDS)
        self.appendToolbar("Knead", names[:2])
        self.appendMenu("Knead", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(KneadWorkbench())
