<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Knead</source>
        <translation>Über Knead</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Versionen kopieren</translation>
    </message>
    <message>
        <source>For a report of something that went wrong</source>
        <translation>Für einen Bericht über etwas, das schiefging</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;A CAD workbench in which a part is a lump of real material.</source>
        <translation>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;Eine CAD-Werkbank, in der ein Teil ein Klumpen echtes Material ist.</translation>
    </message>
    <message>
        <source>After Jansson, Horváth and Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</source>
        <translation>Nach Jansson, Horváth und Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</translation>
    </message>
    <message>
        <source>Made with</source>
        <translation>Gemacht mit</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>License</source>
        <translation>Lizenz</translation>
    </message>
</context>
<context>
    <name>Actions</name>
    <message>
        <source>Put one above the part to push it with</source>
        <translation>Setzt eines über das Teil, um es damit zu drücken</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a part, a project or a recipe</source>
        <translation>Ein Teil, ein Projekt oder ein Rezept öffnen</translation>
    </message>
    <message>
        <source>Open with &amp;choices...</source>
        <translation>Mit A&amp;uswahl öffnen...</translation>
    </message>
    <message>
        <source>Look into files and choose parts, detail and units before they are opened</source>
        <translation>Erst in die Dateien sehen und Teile, Feinheit und Einheiten wählen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Keep part, history and view in a project file</source>
        <translation>Teil, Verlauf und Ansicht in einer Projektdatei aufbewahren</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Keep the project in another file and go on with that</source>
        <translation>Das Projekt in einer anderen Datei aufbewahren und damit weiterarbeiten</translation>
    </message>
    <message>
        <source>Recover &amp;unsaved work...</source>
        <translation>&amp;Nicht Gespeichertes wiederherstellen...</translation>
    </message>
    <message>
        <source>Look for work that was not saved when Knead ended</source>
        <translation>Nach Arbeit suchen, die nicht gespeichert war, als Knead endete</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>Write the deformed part to a file</source>
        <translation>Das verformte Teil in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Export as &amp;recipe...</source>
        <translation>Als &amp;Rezept exportieren...</translation>
    </message>
    <message>
        <source>Write what was done as a recipe, to be read, changed and carried out again</source>
        <translation>Was getan wurde, als Rezept schreiben, das man lesen, ändern und wieder ausführen kann</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>Die Simulation laufen lassen oder anhalten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>One time step</source>
        <translation>Ein Zeitschritt</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Zurück zum Anfang</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Let everything weigh something</source>
        <translation>Allem Gewicht geben</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Put a floor under the part</source>
        <translation>Einen Boden unter das Teil legen</translation>
    </message>
    <message>
        <source>Record &amp;video...</source>
        <translation>&amp;Video aufnehmen...</translation>
    </message>
    <message>
        <source>Make a video of what was simulated, as the view shows it</source>
        <translation>Ein Video von dem machen, was simuliert wurde, wie die Ansicht es zeigt</translation>
    </message>
    <message>
        <source>Record p&amp;ictures...</source>
        <translation>&amp;Bilder aufnehmen...</translation>
    </message>
    <message>
        <source>Write what was simulated as a sequence of pictures</source>
        <translation>Was simuliert wurde, als Folge von Bildern schreiben</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormieren</translation>
    </message>
    <message>
        <source>The selected body, or every one, takes its present shape for its own: stress is gone, the shape stays</source>
        <translation>Der gewählte Körper, oder jeder, nimmt seine jetzige Form als eigene an: die Spannung ist fort, die Form bleibt</translation>
    </message>
    <message>
        <source>Fix faces</source>
        <translation>Flächen fixieren</translation>
    </message>
    <message>
        <source>Click faces of the part to hold them in place</source>
        <translation>Flächen des Teils anklicken, um sie festzuhalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected tool or fixture</source>
        <translation>Das gewählte Werkzeug oder die gewählte Einspannung entfernen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop what is being done</source>
        <translation>Beenden, was gerade getan wird</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Show the objects the material is made of</source>
        <translation>Die Objekte zeigen, aus denen das Material besteht</translation>
    </message>
    <message>
        <source>Inner objects too</source>
        <translation>Auch innere Objekte</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Open edges</source>
        <translation>Offene Kanten</translation>
    </message>
    <message>
        <source>Show where surfaces that are not closed end</source>
        <translation>Zeigen, wo nicht geschlossene Flächen enden</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Hide or show body</source>
        <translation>Körper verbergen oder zeigen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Find a command...</source>
        <translation>Befehl suchen...</translation>
    </message>
    <message>
        <source>Find any command by a few of its letters and do it</source>
        <translation>Jeden Befehl an ein paar Buchstaben finden und ausführen</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Theme, language, units, memory, files, view</source>
        <translation>Erscheinung, Sprache, Einheiten, Speicher, Dateien, Ansicht</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts...</source>
        <translation>&amp;Tastenkürzel...</translation>
    </message>
    <message>
        <source>Give commands other keys</source>
        <translation>Befehlen andere Tasten geben</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back where they came</source>
        <translation>Alle Bereiche dorthin zurück, wo sie anfangs waren</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>What is where, in a minute</source>
        <translation>Was wo ist, in einer Minute</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>About Knead</source>
        <translation>Über Knead</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>One view</source>
        <translation>Eine Ansicht</translation>
    </message>
    <message>
        <source>One view of the part</source>
        <translation>Eine Ansicht des Teils</translation>
    </message>
    <message>
        <source>Two views</source>
        <translation>Zwei Ansichten</translation>
    </message>
    <message>
        <source>Two views of the part, side by side</source>
        <translation>Zwei Ansichten des Teils nebeneinander</translation>
    </message>
    <message>
        <source>Four views</source>
        <translation>Vier Ansichten</translation>
    </message>
    <message>
        <source>Front, top, right and the free view of the part</source>
        <translation>Das Teil von vorne, von oben, von rechts und frei</translation>
    </message>
    <message>
        <source>Active view alone</source>
        <translation>Nur die aktive Ansicht</translation>
    </message>
    <message>
        <source>Show the active view alone, and all of them again</source>
        <translation>Nur die aktive Ansicht zeigen, und wieder alle</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>Make the next of several views the active one</source>
        <translation>Die nächste von mehreren Ansichten zur aktiven machen</translation>
    </message>
    <message>
        <source>Linked cameras</source>
        <translation>Verbundene Kameras</translation>
    </message>
    <message>
        <source>What is panned or zoomed in one view is in all of them</source>
        <translation>Was in einer Ansicht geschoben oder gezoomt wird, wird es in allen</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Gleichgewicht suchen</translation>
    </message>
    <message>
        <source>Put the part where forces balance now, without waiting until it is at rest</source>
        <translation>Das Teil dorthin bringen, wo die Kräfte jetzt im Gleichgewicht sind, ohne zu warten, bis es ruht</translation>
    </message>
    <message>
        <source>Keep up with real time</source>
        <translation>Mit der Echtzeit mithalten</translation>
    </message>
    <message>
        <source>Where implicit steps are slower than real time, solve them more roughly (forces within 3 % of the largest), then take one per 1/30 s. Without this, time runs slower</source>
        <translation>Wo implizite Schritte langsamer als Echtzeit sind, werden sie gröber gelöst (Kräfte auf 3 % der größten genau), dann gibt es einen je 1/30 s. Ohne das läuft die Zeit langsamer</translation>
    </message>
    <message>
        <source>Refill as it is</source>
        <translation>In seiner Form neu füllen</translation>
    </message>
    <message>
        <source>The selected body, or every one that yields, gets new objects in the shape that it has, and goes on with its stress and motion. Where its lattice is no good any more this happens by itself</source>
        <translation>Der gewählte Körper, oder jeder, der fließt, bekommt in der Form, die er hat, neue Objekte und behält Spannung und Bewegung. Wo sein Gitter nicht mehr taugt, geschieht das von selbst</translation>
    </message>
    <message>
        <source>Put one above the part to cut it with: the force is the toughness of its material times the width of the cut</source>
        <translation>Eins über das Teil setzen, um es zu schneiden: Die Kraft ist die Zähigkeit seines Materials mal der Breite des Schnitts</translation>
    </message>
    <message>
        <source>Cut at section plane</source>
        <translation>An der Schnittebene schneiden</translation>
    </message>
    <message>
        <source>The selected body, or every one that deforms, is cut in two where the section plane is now, without force</source>
        <translation>Der gewählte Körper, oder jeder, der sich verformt, wird ohne Kraft dort zerschnitten, wo die Schnittebene jetzt ist</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Draht</translation>
    </message>
    <message>
        <source>Put one above the part to roll it out with: it turns as it is moved</source>
        <translation>Setzt eine über das Teil, mit der es ausgerollt wird: sie dreht sich, während sie bewegt wird</translation>
    </message>
    <message>
        <source>Roller</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Hold one end of the new part and let a block press it, to see what it does</source>
        <translation>Hält das neue Teil an einem Ende und drückt es mit einem Block, um zu sehen, was es tut</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>At the page of what one does</source>
        <translation>Auf der Seite zu dem, was man tut</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ColorLegend</name>
    <message>
        <source>Looking back does not keep this of material that has flowed or is pressed: return to the present, or choose displacement or strain.</source>
        <translation>Der Rückblick bewahrt dies nicht für Material, das geflossen ist oder gedrückt wird: kehren Sie zur Gegenwart zurück, oder wählen Sie Verschiebung oder Dehnung.</translation>
    </message>
    <message>
        <source>This moment does not tell it yet: it comes with the next step.</source>
        <translation>Für diesen Moment liegt dies noch nicht vor: es kommt mit dem nächsten Schritt.</translation>
    </message>
</context>
<context>
    <name>ColorMap</name>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>ColorScale</name>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Plastic strain</source>
        <translation>Plastische Dehnung</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>Distance to the original</source>
        <translation>Abstand zum Original</translation>
    </message>
    <message>
        <source>%1, about ±%2 %</source>
        <translation>%1, etwa ±%2 %</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Nothing is called like that: try fewer letters.</source>
        <translation>Nichts heißt so: versuchen Sie es mit weniger Buchstaben.</translation>
    </message>
</context>
<context>
    <name>ComparisonDialog</name>
    <message>
        <source>Compare with original</source>
        <translation>Mit Original vergleichen</translation>
    </message>
    <message>
        <source>How far the skin is from the nearest point of the original surface, at %1 of simulated time. The mean is by area.</source>
        <translation>Wie weit die Haut vom nächsten Punkt der ursprünglichen Oberfläche entfernt ist, bei %1 simulierter Zeit. Das Mittel ist nach Fläche gewichtet.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Größte Verschiebung</translation>
    </message>
    <message>
        <source>Volume at rest</source>
        <translation>Volumen in Ruhe</translation>
    </message>
    <message>
        <source>Volume now</source>
        <translation>Volumen jetzt</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Write report...</source>
        <translation>Bericht schreiben...</translation>
    </message>
    <message>
        <source>A page with these numbers, what was measured and a picture of the view, as PDF or HTML</source>
        <translation>Eine Seite mit diesen Zahlen, den Messungen und einem Bild der Ansicht, als PDF oder HTML</translation>
    </message>
</context>
<context>
    <name>ComparisonFeature</name>
    <message>
        <source>Comparing with the original</source>
        <translation>Vergleich mit dem Original</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Einen Bericht schreiben</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html *.htm)</source>
        <translation>Webseite (*.html *.htm)</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Größte Verschiebung</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Center of mass moved</source>
        <translation>Verschiebung des Schwerpunkts</translation>
    </message>
    <message>
        <source>%1 beside its original</source>
        <translation>%1 im Vergleich zum Original</translation>
    </message>
    <message>
        <source>At %1 of simulated time. Written by Knead on %2.</source>
        <translation>Bei %1 simulierter Zeit. Von Knead geschrieben am %2.</translation>
    </message>
    <message>
        <source>Distances are those of the deformed skin from the nearest point of the original surface; the mean is by area. A displacement is the way of a point of the skin since rest.</source>
        <translation>Abstände sind die der verformten Haut vom nächsten Punkt der ursprünglichen Oberfläche; das Mittel ist nach Fläche gewichtet. Eine Verschiebung ist der Weg eines Punkts der Haut seit der Ruhe.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Show the surface of the part; as through glass when what is inside is shown too</source>
        <translation>Die Oberfläche des Teils zeigen; wie durch Glas, wenn auch das Innere gezeigt wird</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Show the connections between objects as lines</source>
        <translation>Die Verbindungen zwischen Objekten als Linien zeigen</translation>
    </message>
    <message>
        <source>Original shape</source>
        <translation>Ursprüngliche Form</translation>
    </message>
    <message>
        <source>Show the shape at rest, translucent, around what became of it</source>
        <translation>Die Form in Ruhe zeigen, durchscheinend um das, was aus ihr wurde</translation>
    </message>
    <message>
        <source>Broken connections</source>
        <translation>Gebrochene Verbindungen</translation>
    </message>
    <message>
        <source>Mark where connections broke</source>
        <translation>Kennzeichnen, wo Verbindungen brachen</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>Cut the part open to look inside; drag the knob to move the plane</source>
        <translation>Das Teil aufschneiden, um hineinzusehen; Ziehen am Knopf verschiebt die Ebene</translation>
    </message>
    <message>
        <source>Flip section</source>
        <translation>Schnitt umkehren</translation>
    </message>
    <message>
        <source>Cut off the other side</source>
        <translation>Die andere Seite abschneiden</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>Divide the view: the original on the left, the part as it is on the right</source>
        <translation>Die Ansicht teilen: links das Original, rechts das Teil, wie es ist</translation>
    </message>
    <message>
        <source>Part colors</source>
        <translation>Farben des Teils</translation>
    </message>
    <message>
        <source>Faces have the colors of the part</source>
        <translation>Flächen haben die Farben des Teils</translation>
    </message>
    <message>
        <source>Color the skin by: %1</source>
        <translation>Haut einfärben nach: %1</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>What is shown of the material, and how</source>
        <translation>Was vom Material gezeigt wird, und wie</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>From which colors to which numbers are shown</source>
        <translation>Mit welchen Farben Zahlen gezeigt werden</translation>
    </message>
    <message>
        <source>Range as needed</source>
        <translation>Bereich nach Bedarf</translation>
    </message>
    <message>
        <source>The colors reach as far as the numbers do</source>
        <translation>Die Farben reichen so weit wie die Zahlen</translation>
    </message>
    <message>
        <source>This quantity has colors of its own, since it has two signs.</source>
        <translation>Diese Größe hat eigene Farben, da sie zwei Vorzeichen hat.</translation>
    </message>
    <message>
        <source>Color the skin by a quantity first.</source>
        <translation>Färben Sie zuerst die Haut nach einer Größe.</translation>
    </message>
    <message>
        <source>Section across X</source>
        <translation>Schnitt quer zu X</translation>
    </message>
    <message>
        <source>Section across Y</source>
        <translation>Schnitt quer zu Y</translation>
    </message>
    <message>
        <source>Section across Z</source>
        <translation>Schnitt quer zu Z</translation>
    </message>
    <message>
        <source>Section towards the eye</source>
        <translation>Schnitt zum Auge hin</translation>
    </message>
    <message>
        <source>Cut the part open through its middle</source>
        <translation>Das Teil durch seine Mitte aufschneiden</translation>
    </message>
    <message>
        <source>Hatched</source>
        <translation>Schraffiert</translation>
    </message>
    <message>
        <source>Draw lines across what is cut</source>
        <translation>Linien über das Geschnittene zeichnen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Color map: %1</source>
        <translation>Farbskala: %1</translation>
    </message>
</context>
<context>
    <name>DisplayPanel</name>
    <message>
        <source>Map</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Colors of the skin</source>
        <translation>Farben der Haut</translation>
    </message>
    <message>
        <source>All have even lightness; cividis looks nearly alike to people who see few colors</source>
        <translation>Alle haben gleichmäßige Helligkeit; Cividis sieht für Menschen, die wenige Farben sehen, fast gleich aus</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Towards the eye</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Drag the line in the view: the original on the left, now on the right.</source>
        <translation>Ziehen Sie die Linie in der Ansicht: links das Original, rechts der jetzige Stand.</translation>
    </message>
</context>
<context>
    <name>DividerHandle</name>
    <message>
        <source>Drag: the original on the left, the part as it is on the right</source>
        <translation>Ziehen: links das Original, rechts das Teil, wie es ist</translation>
    </message>
    <message>
        <source>Divider between before and after</source>
        <translation>Trennlinie zwischen vorher und nachher</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>The recipe belongs to the filling before and does not go on in this one. Undo goes back to it.</source>
        <translation>Das Rezept gehört zur Füllung davor und geht in dieser nicht weiter. Rückgängig führt dorthin zurück.</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>%1 neu füllen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.</source>
        <translation>„%1“ ist ein Netz ohne CAD-Flächen: öffnen Sie es als STEP, IGES oder BREP, um Flächen zu fixieren.</translation>
    </message>
    <message>
        <source>Fix face</source>
        <translation>Fläche fixieren</translation>
    </message>
    <message>
        <source>Free face</source>
        <translation>Fläche freigeben</translation>
    </message>
    <message>
        <source>%1 holds no objects: its faces are smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>%1 hält keine Objekte: die Flächen sind kleiner als der Abstand. Wählen Sie einen feineren Abstand und füllen Sie neu.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Going to %1</source>
        <translation>Auf dem Weg zu %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then go to %2.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab, und gehen Sie dann zu %2.</translation>
    </message>
    <message>
        <source>Branching from %1</source>
        <translation>Abzweigen von %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then branch again.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab, und zweigen Sie dann ab.</translation>
    </message>
    <message>
        <source>Branch at %1</source>
        <translation>Abzweig bei %1</translation>
    </message>
    <message>
        <source>The recipe has come to its end. Play goes on without it.</source>
        <translation>Das Rezept ist zu Ende. Starten geht ohne es weiter.</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>In %1 umbenennen</translation>
    </message>
    <message>
        <source>Color of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Something is called &quot;%1&quot; already: choose another name.</source>
        <translation>Etwas heißt schon „%1“: wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked in the model tree: unlock it there to change it.</source>
        <translation>„%1“ ist im Modellbaum gesperrt: entsperren Sie es dort, um es zu ändern.</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Auswahl fixieren</translation>
    </message>
    <message>
        <source>The selection holds no objects: it is smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>Die Auswahl hält keine Objekte: sie ist kleiner als der Abstand. Wählen Sie einen feineren Abstand und füllen Sie neu.</translation>
    </message>
    <message>
        <source>Material of selection</source>
        <translation>Material der Auswahl</translation>
    </message>
    <message>
        <source>Material of selection → %1</source>
        <translation>Material der Auswahl → %1</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Auswahl renormieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names edges or connections of another filling: undo to go back to that, or select them again and save them under this name.</source>
        <translation>„%1“ benennt Kanten oder Verbindungen einer anderen Füllung: gehen Sie mit Rückgängig dorthin zurück, oder wählen Sie sie noch einmal und speichern Sie sie unter diesem Namen.</translation>
    </message>
    <message>
        <source>There is not enough memory to go to %1. Close other programs and try again.</source>
        <translation>Der Speicher reicht nicht, um zu %1 zu gehen. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then find the balance.</source>
        <translation>%1 läuft noch: warten oder mit Esc abbrechen, dann das Gleichgewicht suchen.</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Gleichgewicht suchen</translation>
    </message>
    <message>
        <source>Finding the balance</source>
        <translation>Gleichgewicht wird gesucht</translation>
    </message>
    <message>
        <source>In balance: no force acts on the part.</source>
        <translation>Im Gleichgewicht: keine Kraft wirkt auf das Teil.</translation>
    </message>
    <message>
        <source>In balance: the forces that are left are %1 of those that act.</source>
        <translation>Im Gleichgewicht: die übrigen Kräfte sind %1 derer, die wirken.</translation>
    </message>
    <message>
        <source>No body is of material that yields: elastic ones keep their shape at rest, and are not filled anew.</source>
        <translation>Kein Körper ist aus Material, das fließt: elastische behalten ihre Ruheform und werden nicht neu gefüllt.</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
</context>
<context>
    <name>EntryNames</name>
    <message>
        <source>Material of %1</source>
        <translation>Material von %1</translation>
    </message>
    <message>
        <source>%1 becomes rigid</source>
        <translation>%1 wird starr</translation>
    </message>
    <message>
        <source>%1 becomes glue</source>
        <translation>%1 wird Klebstoff</translation>
    </message>
    <message>
        <source>%1 becomes deformable</source>
        <translation>%1 wird verformbar</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormieren</translation>
    </message>
    <message>
        <source>Gravity off</source>
        <translation>Schwerkraft aus</translation>
    </message>
    <message>
        <source>Gravity on</source>
        <translation>Schwerkraft an</translation>
    </message>
    <message>
        <source>Floor on</source>
        <translation>Boden an</translation>
    </message>
    <message>
        <source>Floor off</source>
        <translation>Boden aus</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 anhalten</translation>
    </message>
    <message>
        <source>Push with %1</source>
        <translation>Mit %1 drücken</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Fix %1</source>
        <translation>%1 fixieren</translation>
    </message>
    <message>
        <source>Semi-implicit steps</source>
        <translation>Semi-implizite Schritte</translation>
    </message>
    <message>
        <source>Forward steps</source>
        <translation>Vorwärtsschritte</translation>
    </message>
    <message>
        <source>Implicit steps</source>
        <translation>Implizite Schritte</translation>
    </message>
    <message>
        <source>Automatic steps</source>
        <translation>Automatische Schritte</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>der Körper</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>das Werkzeug</translation>
    </message>
    <message>
        <source>the fixture</source>
        <translation>die Einspannung</translation>
    </message>
    <message>
        <source>the load</source>
        <translation>die Last</translation>
    </message>
    <message>
        <source>Simulate %1</source>
        <translation>%1 simulieren</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Look of a part</source>
        <translation>Aussehen eines Teils</translation>
    </message>
    <message>
        <source>Look of %1</source>
        <translation>Aussehen von %1</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>In %1 umbenennen</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Gleichgewicht suchen</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>%1 neu füllen</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 schneiden</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Smooth trimmed faces, one for each face of the part as it was opened, at the places where the material has them now. The file is read back and compared.</source>
        <translation>Glatte begrenzte Flächen, eine für jede Fläche des Teils, wie es geöffnet wurde, dort, wo das Material sie jetzt hat. Die Datei wird zurückgelesen und verglichen.</translation>
    </message>
    <message>
        <source>Triangles, as fine as the surface that is drawn.</source>
        <translation>Dreiecke, so fein wie die gezeichnete Oberfläche.</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>Verformte Teile exportieren</translation>
    </message>
    <message>
        <source>%1 (.%2)</source>
        <translation>%1 (.%2)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle Teile</translation>
    </message>
    <message>
        <source>Visible parts</source>
        <translation>Sichtbare Teile</translation>
    </message>
    <message>
        <source>Only &quot;%1&quot;</source>
        <translation>Nur „%1“</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>As in the file that was opened</source>
        <translation>Wie in der geöffneten Datei</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Automatic: 0.01 % of the size</source>
        <translation>Automatisch: 0,01 % der Größe</translation>
    </message>
    <message>
        <source>How far faces in the file may lie beside the surface of the material. A larger one gives smaller files.</source>
        <translation>Wie weit Flächen der Datei neben der Oberfläche des Materials liegen dürfen. Mehr ergibt kleinere Dateien.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>For older programs: AP214 instead of AP242</source>
        <translation>Für ältere Programme: AP214 statt AP242</translation>
    </message>
    <message>
        <source>As text, which is larger and can be read</source>
        <translation>Als Text, der größer und lesbar ist</translation>
    </message>
    <message>
        <source>A file for each part</source>
        <translation>Eine Datei für jedes Teil</translation>
    </message>
    <message>
        <source>Keep the report as a JSON file beside it</source>
        <translation>Den Bericht als JSON-Datei daneben aufbewahren</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Ort wählen...</translation>
    </message>
</context>
<context>
    <name>ExportFeature</name>
    <message>
        <source>Export report</source>
        <translation>Exportbericht</translation>
    </message>
    <message>
        <source>Export a file for each part</source>
        <translation>Eine Datei für jedes Teil exportieren</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>Verformte Teile exportieren</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Exported 1 part to %1.</source>
        <translation>1 Teil nach %1 exportiert.</translation>
    </message>
    <message>
        <source>Exported %2 parts to %1.</source>
        <translation>%2 Teile nach %1 exportiert.</translation>
    </message>
    <message>
        <source>Not everything in %1 is sound; the export report says what is not.</source>
        <translation>Nicht alles in %1 ist einwandfrei; der Exportbericht sagt, was nicht.</translation>
    </message>
</context>
<context>
    <name>ExportPanel</name>
    <message>
        <source>smooth faces</source>
        <translation>glatte Flächen</translation>
    </message>
    <message>
        <source>flat triangles</source>
        <translation>ebene Dreiecke</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>does not pass the geometry checks</source>
        <translation>besteht die Geometrieprüfung nicht</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>nicht geschlossen</translation>
    </message>
    <message>
        <source>its volume is off</source>
        <translation>sein Volumen stimmt nicht</translation>
    </message>
    <message>
        <source>further from the material than asked for</source>
        <translation>weiter vom Material als verlangt</translation>
    </message>
    <message>
        <source>passes through itself</source>
        <translation>geht durch sich selbst hindurch</translation>
    </message>
    <message>
        <source>not smooth where it was</source>
        <translation>nicht glatt, wo es glatt war</translation>
    </message>
    <message>
        <source>closed and valid</source>
        <translation>geschlossen und gültig</translation>
    </message>
    <message>
        <source>valid, open as it was</source>
        <translation>gültig, offen wie zuvor</translation>
    </message>
    <message>
        <source>%1, mean %2</source>
        <translation>%1, im Mittel %2</translation>
    </message>
    <message>
        <source>Not as smooth faces: %1</source>
        <translation>Nicht als glatte Flächen: %1</translation>
    </message>
    <message>
        <source>Its name was not found again.</source>
        <translation>Sein Name wurde nicht wiedergefunden.</translation>
    </message>
    <message>
        <source>Not all of its colors were found again.</source>
        <translation>Nicht alle seine Farben wurden wiedergefunden.</translation>
    </message>
    <message>
        <source>Nothing was exported yet.</source>
        <translation>Noch wurde nichts exportiert.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Zurückgelesen</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Als</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Volumenkörper</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Distance to the material</source>
        <translation>Abstand zum Material</translation>
    </message>
    <message>
        <source>Volume (since opened)</source>
        <translation>Volumen (seit dem Öffnen)</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>%1: %2, %3 MB in %4 s. %5</source>
        <translation>%1: %2, %3 MB in %4 s. %5</translation>
    </message>
    <message>
        <source>All parts are sound.</source>
        <translation>Alle Teile sind einwandfrei.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are not sound.</source>
        <translation>%1 von %2 Teilen sind nicht einwandfrei.</translation>
    </message>
    <message>
        <source>smooth faces, %1 flat</source>
        <translation>glatte Flächen, %1 flach</translation>
    </message>
</context>
<context>
    <name>FileWords</name>
    <message>
        <source>was inside out and has been turned.</source>
        <translation>war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>is not a closed surface: %1. It is shown and cannot be filled.</source>
        <translation>ist keine geschlossene Fläche: %1. Es wird gezeigt und kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>is an open surface: %1. It is shown and cannot be filled.</source>
        <translation>ist eine offene Fläche: %1. Es wird gezeigt und kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>is not closed: %1. It is shown and cannot be filled.</source>
        <translation>ist nicht geschlossen: %1. Es wird gezeigt und kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>is a closed surface but no solid; it is shown and cannot be filled.</source>
        <translation>ist eine geschlossene Fläche, aber kein Körper; es wird gezeigt und kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>could not be covered with a closed net of triangles; it cannot be filled.</source>
        <translation>konnte nicht mit einem geschlossenen Netz aus Dreiecken überzogen werden; es kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>has no volume; it cannot be filled.</source>
        <translation>hat kein Volumen; es kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>does not pass the geometry checks; look at it closely before you trust it.</source>
        <translation>besteht die Prüfungen der Geometrie nicht; sehen Sie genau hin, bevor Sie ihm trauen.</translation>
    </message>
    <message>
        <source>has gaps of up to %1, a hundredth of its size or more.</source>
        <translation>hat Spalte bis zu %1, ein Hundertstel seiner Größe oder mehr.</translation>
    </message>
    <message>
        <source>has faces that do not meet well: its volume is uncertain by %1.</source>
        <translation>hat Flächen, die nicht gut zusammentreffen: sein Volumen ist um %1 unsicher.</translation>
    </message>
    <message>
        <source>has 1 face that no triangles could be found for; it is not shown there.</source>
        <translation>hat 1 Fläche, für die sich keine Dreiecke fanden; dort wird nichts gezeigt.</translation>
    </message>
    <message>
        <source>has %1 faces that no triangles could be found for; it is not shown there.</source>
        <translation>hat %1 Flächen, für die sich keine Dreiecke fanden; dort wird nichts gezeigt.</translation>
    </message>
    <message>
        <source>is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file.</source>
        <translation>ist unvollständig: %1 von %2 Flächen einer Schale konnten gelesen werden; die anderen sind in der Datei beschädigt.</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across</source>
        <translation>%1 in %2, zusammen %3 lang; die größte Öffnung misst %4</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across and flat</source>
        <translation>%1 in %2, zusammen %3 lang; die größte Öffnung misst %4 und ist eben</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 offene Kante</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1 offene Kanten</translation>
    </message>
    <message>
        <source>1 border</source>
        <translation>1 Rand</translation>
    </message>
    <message>
        <source>%1 borders</source>
        <translation>%1 Rändern</translation>
    </message>
    <message>
        <source>1 triangle was there twice and removed.</source>
        <translation>1 Dreieck war doppelt da und wurde entfernt.</translation>
    </message>
    <message>
        <source>%1 triangles were there twice and removed.</source>
        <translation>%1 Dreiecke waren doppelt da und wurden entfernt.</translation>
    </message>
    <message>
        <source>The surface was given with both its sides; one of them was removed.</source>
        <translation>Die Fläche war mit beiden Seiten gegeben; eine davon wurde entfernt.</translation>
    </message>
    <message>
        <source>1 pair of triangles back to back was removed.</source>
        <translation>1 Paar von Dreiecken Rücken an Rücken wurde entfernt.</translation>
    </message>
    <message>
        <source>%1 pairs of triangles back to back were removed.</source>
        <translation>%1 Paare von Dreiecken Rücken an Rücken wurden entfernt.</translation>
    </message>
    <message>
        <source>1 triangle faced the wrong way and was turned.</source>
        <translation>1 Dreieck sah in die falsche Richtung und wurde gewendet.</translation>
    </message>
    <message>
        <source>%1 triangles faced the wrong way and were turned.</source>
        <translation>%1 Dreiecke sahen in die falsche Richtung und wurden gewendet.</translation>
    </message>
    <message>
        <source>1 small hole was closed, which added %1 to the area.</source>
        <translation>1 kleines Loch wurde geschlossen, was die Oberfläche um %1 vergrößerte.</translation>
    </message>
    <message>
        <source>%1 small holes were closed, which added %2 to the area.</source>
        <translation>%1 kleine Löcher wurden geschlossen, was die Oberfläche um %2 vergrößerte.</translation>
    </message>
    <message>
        <source>The surface was inside out and has been turned.</source>
        <translation>Die Fläche war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>The solid was inside out and has been turned.</source>
        <translation>Der Körper war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>1 shell was inside out and turned.</source>
        <translation>1 Schale war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>%1 shells were inside out and turned.</source>
        <translation>%1 Schalen waren umgestülpt und wurden gewendet.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid.</source>
        <translation>Die geschlossene Fläche wurde zum Körper gemacht.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with 1 void in it.</source>
        <translation>Die geschlossene Fläche wurde zum Körper gemacht, mit 1 Hohlraum darin.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with %1 voids in it.</source>
        <translation>Die geschlossene Fläche wurde zum Körper gemacht, mit %1 Hohlräumen darin.</translation>
    </message>
    <message>
        <source>1 flat opening was closed with a plane face, %1 % of the area.</source>
        <translation>1 ebene Öffnung wurde mit einer ebenen Fläche geschlossen, %1 % der Oberfläche.</translation>
    </message>
    <message>
        <source>%1 flat openings were closed with plane faces, %2 % of the area.</source>
        <translation>%1 ebene Öffnungen wurden mit ebenen Flächen geschlossen, %2 % der Oberfläche.</translation>
    </message>
    <message>
        <source>Edges that failed the geometry checks were rebuilt.</source>
        <translation>Kanten, die die Prüfungen der Geometrie nicht bestanden, wurden neu gebaut.</translation>
    </message>
    <message>
        <source>1 face that failed the geometry checks was rebuilt.</source>
        <translation>1 Fläche, die die Prüfungen der Geometrie nicht bestand, wurde neu gebaut.</translation>
    </message>
    <message>
        <source>%1 faces that failed the geometry checks were rebuilt.</source>
        <translation>%1 Flächen, die die Prüfungen der Geometrie nicht bestanden, wurden neu gebaut.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1.</source>
        <translation>1 einzelne Fläche wurde mit einer Toleranz von %1 vernäht.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2.</source>
        <translation>%1 einzelne Flächen wurden mit einer Toleranz von %2 vernäht.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1; the widest gap between two of them is %2.</source>
        <translation>1 einzelne Fläche wurde mit einer Toleranz von %1 vernäht; der weiteste Spalt zwischen zweien ist %2.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2; the widest gap between two of them is %3.</source>
        <translation>%1 einzelne Flächen wurden mit einer Toleranz von %2 vernäht; der weiteste Spalt zwischen zweien ist %3.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that wrote it.</source>
        <translation>%1: die 3MF-Datei hält sich an 1 Stelle nicht an das Format; vergleichen Sie die Teile mit dem Programm, das sie schrieb.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that wrote it.</source>
        <translation>%1: die 3MF-Datei hält sich an %2 Stellen nicht an das Format; vergleichen Sie die Teile mit dem Programm, das sie schrieb.</translation>
    </message>
    <message>
        <source>%1: the file states no length unit; millimetres were taken.</source>
        <translation>%1: die Datei nennt keine Längeneinheit; Millimeter wurden genommen.</translation>
    </message>
    <message>
        <source>%1: the entity %2 refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: %3).</source>
        <translation>%1: das Element %2 verweist auf etwas Falsches oder auf nichts; was es braucht, konnte nicht gelesen werden (Flächen: %3).</translation>
    </message>
    <message>
        <source>%1: the entity %2 refers to something of the wrong kind or nothing at all; what needs it could not be read (shapes: %3).</source>
        <translation>%1: das Element %2 verweist auf etwas Falsches oder auf nichts; was es braucht, konnte nicht gelesen werden (Formen: %3).</translation>
    </message>
    <message>
        <source>%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at all; what needs them could not be read (faces: %4).</source>
        <translation>%1: das Element %2 und %3 weitere verweisen auf etwas Falsches oder auf nichts; was sie braucht, konnte nicht gelesen werden (Flächen: %4).</translation>
    </message>
    <message>
        <source>%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at all; what needs them could not be read (shapes: %4).</source>
        <translation>%1: das Element %2 und %3 weitere verweisen auf etwas Falsches oder auf nichts; was sie braucht, konnte nicht gelesen werden (Formen: %4).</translation>
    </message>
    <message>
        <source>the assembly refers to the file %1, which is not there: its parts are missing. Put it beside the assembly and open that again.</source>
        <translation>die Baugruppe verweist auf die Datei %1, die es dort nicht gibt: ihre Teile fehlen. Legen Sie sie neben die Baugruppe und öffnen Sie diese noch einmal.</translation>
    </message>
    <message>
        <source>the assembly refers to %1 files that are not there: %2. Their parts are missing; put them beside the assembly and open that again.</source>
        <translation>die Baugruppe verweist auf %1 Dateien, die es dort nicht gibt: %2. Ihre Teile fehlen; legen Sie sie neben die Baugruppe und öffnen Sie diese noch einmal.</translation>
    </message>
    <message>
        <source>%1: the reader crashed on what the file says beside its shapes; these were read without names, colors and assemblies, and without other files that it refers to.</source>
        <translation>%1: der Leser stürzte über das ab, was die Datei neben ihren Formen sagt; diese wurden ohne Namen, Farben und Baugruppen gelesen, und ohne andere Dateien, auf die sie verweist.</translation>
    </message>
    <message>
        <source>%1: the file mixes the length units %2 and %3; check the sizes of the parts.</source>
        <translation>%1: die Datei mischt die Längeneinheiten %2 und %3; prüfen Sie die Größen der Teile.</translation>
    </message>
    <message>
        <source>%1: its schema &quot;%2&quot; is none for CAD parts; check that nothing is missing.</source>
        <translation>%1: sein Schema &quot;%2&quot; ist keines für CAD-Teile; prüfen Sie, dass nichts fehlt.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4.</source>
        <translation>%1: das Teil ist %2 lang; wenn seine Längen %3 sind, ist es %4.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4.</source>
        <translation>%1: die Teile sind zusammen %2 lang; wenn ihre Längen %3 sind, sind sie %4.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4. Open that file alone to correct it.</source>
        <translation>%1: das Teil ist %2 lang; wenn seine Längen %3 sind, ist es %4. Öffnen Sie diese Datei allein, um es zu berichtigen.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4. Open that file alone to correct it.</source>
        <translation>%1: die Teile sind zusammen %2 lang; wenn ihre Längen %3 sind, sind sie %4. Öffnen Sie diese Datei allein, um es zu berichtigen.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>Kilometer</translation>
    </message>
    <message>
        <source>miles</source>
        <translation>Meilen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no triangles.</source>
        <translation>&quot;%1&quot; hat keine Dreiecke.</translation>
    </message>
    <message>
        <source>1 shape of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>1 Form der STEP-Datei konnte nicht gelesen werden: ihre Flächen sind beschädigt oder von unbekannter Art.</translation>
    </message>
    <message>
        <source>%1 shapes of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>%1 Formen der STEP-Datei konnten nicht gelesen werden: ihre Flächen sind beschädigt oder von unbekannter Art.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was left out: %2.</source>
        <translation>&quot;%1&quot; wurde weggelassen: %2.</translation>
    </message>
    <message>
        <source>it has no finite size: numbers in it are damaged, or its edges are smaller than 0.1 um and lost; check the length unit</source>
        <translation>es hat keine endliche Größe: Zahlen darin sind beschädigt, oder seine Kanten sind kleiner als 0.1 um und verloren; prüfen Sie die Längeneinheit</translation>
    </message>
    <message>
        <source>it reaches farther than 100 km from the origin; check the length unit and the position</source>
        <translation>es reicht weiter als 100 km vom Ursprung; prüfen Sie Längeneinheit und Lage</translation>
    </message>
    <message>
        <source>its faces lead far away from their edges: numbers in it are damaged</source>
        <translation>seine Flächen führen weit von ihren Kanten weg: Zahlen darin sind beschädigt</translation>
    </message>
    <message>
        <source>it is smaller than a micrometre; check the length unit</source>
        <translation>es ist kleiner als ein Mikrometer; prüfen Sie die Längeneinheit</translation>
    </message>
    <message>
        <source>its faces and edges are up to %1 apart, at a size of %2</source>
        <translation>seine Flächen und Kanten liegen bis zu %1 auseinander, bei einer Größe von %2</translation>
    </message>
    <message>
        <source>the solid has no volume</source>
        <translation>der Körper hat kein Volumen</translation>
    </message>
    <message>
        <source>it could not be measured (%1)</source>
        <translation>es konnte nicht gemessen werden (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>&quot;%1&quot; wird nicht simuliert: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface, so it is not shown.</source>
        <translation>&quot;%1&quot; hat keine Oberfläche und wird deshalb nicht gezeigt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a closed solid: it is shown, and not simulated. Close its surfaces and import it again.</source>
        <translation>&quot;%1&quot; ist kein geschlossener Körper: es wird gezeigt und nicht simuliert. Schließen Sie seine Flächen und importieren Sie es erneut.</translation>
    </message>
    <message>
        <source>A spacing of %1 needs more than %2 objects. Choose a larger spacing.</source>
        <translation>Ein Abstand von %1 braucht mehr als %2 Objekte. Wählen Sie einen größeren Abstand.</translation>
    </message>
    <message>
        <source>The part has no triangles, so there is nothing to fill. Import a part with a surface.</source>
        <translation>Das Teil hat keine Dreiecke, also ist nichts zu füllen. Importieren Sie ein Teil mit einer Oberfläche.</translation>
    </message>
    <message>
        <source>A vertex of the surface is not at a finite place. Repair the file and import again.</source>
        <translation>Ein Eckpunkt der Oberfläche liegt an keinem endlichen Ort. Reparieren Sie die Datei und importieren Sie erneut.</translation>
    </message>
    <message>
        <source>The surface is not closed: %1 edges of triangles have no partner. Close the gaps and import again.</source>
        <translation>Die Oberfläche ist nicht geschlossen: %1 Kanten von Dreiecken haben keinen Partner. Schließen Sie die Lücken und importieren Sie erneut.</translation>
    </message>
    <message>
        <source>The surface does not bound a volume: its holes are too large to tell inside from outside. Close them and import again.</source>
        <translation>Die Oberfläche begrenzt kein Volumen: ihre Löcher sind zu groß, um innen von außen zu unterscheiden. Schließen Sie sie und importieren Sie erneut.</translation>
    </message>
    <message>
        <source>The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing.</source>
        <translation>Das Teil ist zu dünn für einen Abstand von %1: keine Zelle enthält genug Material. Wählen Sie einen kleineren Abstand.</translation>
    </message>
    <message>
        <source>its surface passes through itself near %1; other programs may refuse that.</source>
        <translation>seine Oberfläche durchdringt sich selbst bei %1; andere Programme lehnen das vielleicht ab.</translation>
    </message>
    <message>
        <source>%1 of its faces could not be carried along: %2.</source>
        <translation>%1 seiner Flächen konnten nicht mitgeführt werden: %2.</translation>
    </message>
    <message>
        <source>an edge has no curve on its face</source>
        <translation>eine Kante hat keine Kurve auf ihrer Fläche</translation>
    </message>
    <message>
        <source>an edge has a curve on its face that does not match it</source>
        <translation>die Kurve einer Kante auf ihrer Fläche passt nicht zu ihr</translation>
    </message>
    <message>
        <source>a face has no surface</source>
        <translation>eine Fläche hat keine Geometrie</translation>
    </message>
    <message>
        <source>a face has no border</source>
        <translation>eine Fläche hat keinen Rand</translation>
    </message>
    <message>
        <source>a face is degenerate</source>
        <translation>eine Fläche ist entartet</translation>
    </message>
    <message>
        <source>its faces do not fit together any more as they are bent now.</source>
        <translation>so gebogen passen seine Flächen nicht mehr aneinander.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off.</source>
        <translation>„%1“: Fläche %2 kommt der Haut nicht so nahe wie angestrebt, %3 mm; Fläche %4 liegt %5 mm daneben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off.</source>
        <translation>„%1“: %2 Flächen, %3, kommen der Haut nicht so nahe wie angestrebt, %4 mm; Fläche %5 liegt %6 mm daneben.</translation>
    </message>
    <message>
        <source>it came as a mesh, which has no smooth faces.</source>
        <translation>es kam als Netz, das keine glatten Flächen hat.</translation>
    </message>
    <message>
        <source>faces that met smoothly now meet at an angle near %1; a smaller tolerance may help.</source>
        <translation>Flächen, die glatt ineinander übergingen, treffen sich bei %1 nun in einem Winkel; eine kleinere Toleranz kann helfen.</translation>
    </message>
    <message>
        <source>The file holds %1 parts where %2 were written.</source>
        <translation>Die Datei enthält %1 Teile, geschrieben wurden %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: 1 of its connections is broken, and its skin spans the crack, stretched to %2 times its length there near %3.</source>
        <translation>„%1“ hat Risse, ist aber noch ein Stück: 1 Verbindung ist gerissen, und die Haut überspannt den Riss, bei %3 auf das %2-Fache ihrer Länge gedehnt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: %2 of its connections are broken, and its skin spans the crack, stretched to %3 times its length there near %4.</source>
        <translation>„%1“ hat Risse, ist aber noch ein Stück: %2 Verbindungen sind gerissen, und die Haut überspannt den Riss, bei %4 auf das %3-Fache ihrer Länge gedehnt.</translation>
    </message>
    <message>
        <source>too few of its objects hang together to say how it is deformed: it is written in its shape at rest, moved as they have.</source>
        <translation>zu wenige seiner Objekte hängen zusammen, um zu sagen, wie es verformt ist: es wird in seiner Ruheform geschrieben, bewegt wie sie.</translation>
    </message>
    <message>
        <source>its cracks could not be made into surfaces: other pieces of it are written as one with it; objects in them: %1.</source>
        <translation>aus seinen Rissen ließen sich keine Flächen machen: andere Stücke davon werden mit ihm als eines geschrieben; Objekte darin: %1.</translation>
    </message>
    <message>
        <source>pieces too small for a shape of their own are written as part of it; objects in them: %1.</source>
        <translation>Stücke, die zu klein für eine eigene Form sind, werden als Teil davon geschrieben; Objekte darin: %1.</translation>
    </message>
    <message>
        <source>its bent faces were not found again in the file when that was read back.</source>
        <translation>seine gebogenen Flächen fanden sich in der zurückgelesenen Datei nicht wieder.</translation>
    </message>
    <message>
        <source>The simulation was stopped at %1 s: %2 It went back to %3 s.</source>
        <translation>Die Simulation wurde bei %1 s angehalten: %2 Sie ging auf %3 s zurück.</translation>
    </message>
    <message>
        <source>a position is no longer a number. %1 or make the material softer, then reset.</source>
        <translation>eine Lage ist keine Zahl mehr. %1 oder das Material weicher machen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>objects moved at %1 m/s. %2 or raise the damping ratio, then reset.</source>
        <translation>Objekte bewegten sich mit %1 m/s. %2 oder den Dämpfungsgrad erhöhen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>Make the tools slower</source>
        <translation>Die Werkzeuge verlangsamen</translation>
    </message>
    <message>
        <source>Lower gravity</source>
        <translation>Die Schwerkraft verringern</translation>
    </message>
    <message>
        <source>Move bodies and fixtures slower</source>
        <translation>Körper und Einspannungen langsamer bewegen</translation>
    </message>
    <message>
        <source>material of %1 was squashed flat or turned inside out. Press less far, raise Poisson&apos;s ratio or the yield stress, or fill the part with a smaller spacing, then reset.</source>
        <translation>Material von %1 wurde flach gedrückt oder umgestülpt. Weniger weit drücken, die Querkontraktionszahl oder die Fließgrenze erhöhen oder das Teil mit kleinerem Abstand füllen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>der Körper</translation>
    </message>
    <message>
        <source>objects of %1 moved at %2 m/s, and nothing in the scene makes them faster than %3 m/s. %4 or raise the damping ratio, then reset.</source>
        <translation>Objekte von %1 bewegten sich mit %2 m/s, und nichts in der Szene macht sie schneller als %3 m/s. %4 oder den Dämpfungsgrad erhöhen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the material. %3 or raise the damping ratio, then reset.</source>
        <translation>%1 J kamen aus dem Nichts, von %2 J in der Szene: Die Schritte folgen dem Material nicht mehr. %3 oder den Dämpfungsgrad erhöhen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>the equations of %1 steps in a row could not be solved, though the last was only %2 s long. %3 or raise the damping ratio, then reset.</source>
        <translation>die Gleichungen von %1 Schritten nacheinander ließen sich nicht lösen, obwohl der letzte nur %2 s lang war. %3 oder den Dämpfungsgrad erhöhen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is %2 mm deep in %3: let it begin outside and press less far, make it slower</source>
        <translation>Das Werkzeug &quot;%1&quot; steckt %2 mm tief in %3: es außerhalb beginnen lassen, weniger weit drücken, es verlangsamen</translation>
    </message>
    <message>
        <source>Choose a shorter time step for mass scaling, which added %1 % to the mass</source>
        <translation>Einen kürzeren Zeitschritt für die Massenskalierung wählen, die %1 % zur Masse hinzufügte</translation>
    </message>
    <message>
        <source>there is not enough memory to go on. Close other programs or fill the part with a larger spacing, then reset.</source>
        <translation>es ist nicht genug Speicher da, um fortzufahren. Andere Programme schließen oder das Teil mit größerem Abstand füllen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>%1 Reset, or go to an earlier moment.</source>
        <translation>%1 Zurücksetzen oder zu einem früheren Augenblick gehen.</translation>
    </message>
    <message>
        <source>The simulation was stopped: %1</source>
        <translation>Die Simulation wurde angehalten: %1</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; begins %2 mm inside %3, which is pushed away with great force, in very short steps. Let it begin outside.</source>
        <translation>Das Werkzeug &quot;%1&quot; beginnt %2 mm tief in %3, was mit großer Kraft und in sehr kurzen Schritten weggedrückt wird. Es außerhalb beginnen lassen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; broke into %2 pieces, and a rigid body would weld them together where they are. Keep it deformable, or reset before it becomes rigid.</source>
        <translation>&quot;%1&quot; zerbrach in %2 Stücke, und ein starrer Körper würde sie dort verschweißen, wo sie sind. Ihn verformbar lassen oder zurücksetzen, bevor er starr wird.</translation>
    </message>
    <message>
        <source>The equations of the step at %1 s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter time step.</source>
        <translation>Die Gleichungen des Schrittes bei %1 s ließen sich nicht lösen: Kräfte und Lagen sind von dort an ungenau. Werkzeuge verlangsamen oder einen kürzeren Zeitschritt wählen.</translation>
    </message>
    <message>
        <source>the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, or a softer or more damped material.</source>
        <translation>der gewählte Zeitschritt von %1 s ist länger als der stabile von %2 s. Einen kürzeren wählen oder ein weicheres oder stärker gedämpftes Material.</translation>
    </message>
    <message>
        <source>the part is torn; this is one of %1 pieces.</source>
        <translation>das Teil ist zerrissen; dies ist eines von %1 Stücken.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces do not pass the geometry checks.</source>
        <translation>aus der Datei zurückgelesen bestehen seine gebogenen Flächen die Geometrieprüfung nicht.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces leave gaps.</source>
        <translation>aus der Datei zurückgelesen lassen seine gebogenen Flächen Lücken.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>aus der Datei zurückgelesen liegen seine gebogenen Flächen bis zu %1 mm neben der Haut, erlaubt sind %2 mm.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces enclose a volume %1 % off that of the skin.</source>
        <translation>aus der Datei zurückgelesen umschließen seine gebogenen Flächen ein Volumen, das um %1 % von dem der Haut abweicht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would need %2 flat faces, more than CAD programs can work with; export it as a mesh.</source>
        <translation>„%1“ bräuchte %2 ebene Flächen, mehr als CAD-Programme verarbeiten; exportieren Sie es als Netz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an open mesh, which CAD files cannot hold; hide it, or export as a mesh.</source>
        <translation>„%1“ ist ein offenes Netz, das CAD-Dateien nicht aufnehmen; blenden Sie es aus oder exportieren Sie als Netz.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. Fill with a spacing of %4 for %5 cells, about %6 objects.</source>
        <translation>Dünnste Wände: %1 Zellen auf %2; solche Wände biegen sich bis zu %3 % zu steif. Ein Abstand von %4 gibt %5 Zellen, etwa %6 Objekte.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out many times too stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.</source>
        <translation>Dünnste Wände: %1 Zellen auf %2; solche Wände biegen sich um ein Vielfaches zu steif. Ein Abstand von %3 gibt %4 Zellen, etwa %5 Objekte.</translation>
    </message>
    <message>
        <source>Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools slower.</source>
        <translation>Die Energie stimmt um %1 % aller umgesetzten nicht. Einen kürzeren Zeitschritt wählen oder Werkzeuge langsamer machen.</translation>
    </message>
    <message>
        <source>Tools or the floor went %1 spacings into material: shapes and forces there are rough. Press less far, or choose a smaller spacing.</source>
        <translation>Werkzeuge oder der Boden drangen %1 Abstände ins Material ein: Formen und Kräfte dort sind ungenau. Weniger weit drücken oder einen kleineren Abstand wählen.</translation>
    </message>
    <message>
        <source>Mass scaling made %1 % of the mass: what swings and what is thrown is slower than it would be. Choose a shorter time step for it.</source>
        <translation>Massenskalierung machte %1 % der Masse: was schwingt und was geworfen wird, ist langsamer, als es wäre. Einen kürzeren Zeitschritt dafür wählen.</translation>
    </message>
    <message>
        <source>A body is free to move: hold it, or let time run (dynamic) until it rests on something.</source>
        <translation>Ein Körper kann sich frei bewegen: festhalten oder die Zeit laufen lassen (dynamic), bis er auf etwas ruht.</translation>
    </message>
    <message>
        <source>%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).</source>
        <translation>%1 ist starr und kann sich frei bewegen: festhalten, verformbar machen oder die Zeit laufen lassen (dynamic).</translation>
    </message>
    <message>
        <source>No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps or a smaller load, hold what is free to slide or turn, or let time run (dynamic).</source>
        <translation>Bei %1 s fand sich kein Gleichgewicht: Kräfte von %2 derer, die wirken, sind übrig. Mehr Lastschritte oder eine kleinere Last nehmen, festhalten, was gleiten oder sich drehen kann, oder die Zeit laufen lassen (dynamic).</translation>
    </message>
    <message>
        <source>%1: a turned face is bounded across its seam, and the file does not tell on which side of its border it lies; check the volume of its part.</source>
        <translation>%1: Eine gedrehte Fläche ist über ihre Naht hinweg begrenzt, und die Datei sagt nicht, auf welcher Seite ihres Randes sie liegt; das Volumen ihres Teils ist zu prüfen.</translation>
    </message>
    <message>
        <source>1 face was added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>1 Fläche kam hinzu: In sich geschlossene kamen zweigeteilt, was andere Programme sicherer lesen.</translation>
    </message>
    <message>
        <source>%1 faces were added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>%1 Flächen kamen hinzu: In sich geschlossene kamen zweigeteilt, was andere Programme sicherer lesen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 is made of flat triangles; its other faces are smooth.</source>
        <translation>„%1“: Fläche %2 besteht aus flachen Dreiecken; die anderen Flächen sind glatt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: faces %2 are made of flat triangles; its other faces are smooth.</source>
        <translation>„%1“: Flächen %2 bestehen aus flachen Dreiecken; die anderen Flächen sind glatt.</translation>
    </message>
    <message>
        <source>its faces were not found again as they were written.</source>
        <translation>seine Flächen wurden nicht so wiedergefunden, wie sie geschrieben wurden.</translation>
    </message>
    <message>
        <source>read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>aus der Datei zurückgelesen liegen seine flachen Flächen bis zu %1 mm neben der Haut, erlaubt sind %2 mm.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are inside out.</source>
        <translation>aus der Datei zurückgelesen, sind seine gebogenen Flächen von innen nach außen gekehrt.</translation>
    </message>
    <message>
        <source>other programs may read it inside out, as it came back here.</source>
        <translation>andere Programme lesen es vielleicht von innen nach außen gekehrt, wie es hier zurückkam.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>In %1 ist kein Platz mehr. Schaffen Sie welchen, oder nehmen Sie weniger oder kleinere Bilder auf.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 gibt es schon. Wählen Sie einen anderen Namen für den Ordner der Bilder.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>In %1 kann kein Ordner angelegt werden: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2). Choose another name for the folder of pictures.</source>
        <translation>%1 kann nicht angelegt werden (%2). Wählen Sie einen anderen Namen für den Ordner der Bilder.</translation>
    </message>
</context>
<context>
    <name>FixturePanel</name>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Objects held</source>
        <translation>Gehaltene Objekte</translation>
    </message>
    <message>
        <source>With &quot;Fix faces&quot; on, a click on a face adds it to this fixture, or frees it.</source>
        <translation>Mit „Flächen fixieren“ fügt ein Klick auf eine Fläche sie dieser Einspannung hinzu oder gibt sie frei.</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Einspannung entfernen</translation>
    </message>
</context>
<context>
    <name>FoldWatch</name>
    <message>
        <source>%1 is folded over itself near (%2): material was pushed over material, and its faces cross there in files, too. Undo the stroke, or press the place smooth with a larger tool.</source>
        <translation>%1 ist bei (%2) über sich selbst gefaltet: Material wurde über Material geschoben, und auch in Dateien kreuzen sich seine Flächen dort. Den Strich rückgängig machen oder die Stelle mit einem größeren Werkzeug glatt drücken.</translation>
    </message>
</context>
<context>
    <name>ForcePanel</name>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>What of the force is plotted</source>
        <translation>Was von der Kraft aufgetragen wird</translation>
    </message>
    <message>
        <source>Add a tool and press Space: forces over time appear here.</source>
        <translation>Fügen Sie ein Werkzeug hinzu und drücken Sie die Leertaste: hier erscheinen Kräfte über der Zeit.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
</context>
<context>
    <name>Graphics</name>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>The window needs OpenGL 3.2 or later to draw, and here is %1. Install or update the driver of the graphics card, or Mesa (libgl1-mesa-dri), which draws without such a card. The commands that knead --help lists need no window.</source>
        <translation>Das Fenster braucht OpenGL 3.2 oder neuer zum Zeichnen, und hier gibt es %1. Installieren oder erneuern Sie den Treiber der Grafikkarte, oder Mesa (libgl1-mesa-dri), das ohne solche Karte zeichnet. Die Befehle, die knead --help aufzählt, brauchen kein Fenster.</translation>
    </message>
</context>
<context>
    <name>HandPanel</name>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Entlang der eigenen Achsen des Werkzeugs</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Schiebeschritt</translation>
    </message>
    <message>
        <source>Handles move in steps of this length while Ctrl is held</source>
        <translation>Griffe bewegen in Schritten dieser Länge, solange Strg gehalten wird</translation>
    </message>
    <message>
        <source>Turn step</source>
        <translation>Drehschritt</translation>
    </message>
    <message>
        <source>Handles turn in steps of this angle while Ctrl is held</source>
        <translation>Griffe drehen in Schritten dieses Winkels, solange Strg gehalten wird</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>Key step</source>
        <translation>Tastenschritt</translation>
    </message>
    <message>
        <source>A key press moves a tool by this length</source>
        <translation>Ein Tastendruck bewegt ein Werkzeug um diese Länge</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Schritte je Sekunde</translation>
    </message>
    <message>
        <source>While a key is held; a tool never goes faster than its speed limit</source>
        <translation>Solange eine Taste gehalten wird; ein Werkzeug ist nie schneller als seine Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>Pulling</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Spring stiffness</source>
        <translation>Federsteifigkeit</translation>
    </message>
    <message>
        <source>Of the spring between the mouse and the material</source>
        <translation>Die der Feder zwischen der Maus und dem Material</translation>
    </message>
    <message>
        <source>Largest pull</source>
        <translation>Größte Zugkraft</translation>
    </message>
    <message>
        <source>The hand does not pull harder than this</source>
        <translation>Die Hand zieht nicht stärker als dies</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D-Maus</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Selected tool</source>
        <translation>Gewähltes Werkzeug</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Steuert</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Of its speeds; 1 is usual</source>
        <translation>Als Vielfaches ihrer Geschwindigkeiten; üblich ist 1</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>nach dem Material</translation>
    </message>
    <message>
        <source>Connected. First button: fit; second: camera or tool.</source>
        <translation>Verbunden. Erste Taste: einpassen; zweite: Kamera oder Werkzeug.</translation>
    </message>
    <message>
        <source>None: it works as soon as spacenavd runs.</source>
        <translation>Keine: sie arbeitet, sobald spacenavd läuft.</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Drücken</translation>
    </message>
</context>
<context>
    <name>HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Keine Seite hat diese Wörter.</translation>
    </message>
</context>
<context>
    <name>Hands</name>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Show handles on the selected tool to move and turn it; Ctrl: in steps; type numbers</source>
        <translation>Am gewählten Werkzeug Griffe zeigen, um es zu bewegen und zu drehen; Strg: in Schritten; Zahlen tippen</translation>
    </message>
    <message>
        <source>Drive by keys</source>
        <translation>Mit Tasten fahren</translation>
    </message>
    <message>
        <source>Drive up to three tools with the keyboard, each with keys of its own</source>
        <translation>Bis zu drei Werkzeuge mit der Tastatur fahren, jedes mit eigenen Tasten</translation>
    </message>
    <message>
        <source>Pull material</source>
        <translation>Material ziehen</translation>
    </message>
    <message>
        <source>Press on the part and pull its material with a spring</source>
        <translation>Auf das Teil drücken und sein Material mit einer Feder ziehen</translation>
    </message>
    <message>
        <source>3D mouse drives tool</source>
        <translation>3D-Maus fährt Werkzeug</translation>
    </message>
    <message>
        <source>The 3D mouse moves the selected tool, not the camera</source>
        <translation>Die 3D-Maus bewegt das gewählte Werkzeug, nicht die Kamera</translation>
    </message>
    <message>
        <source>Forces on tools</source>
        <translation>Kräfte an Werkzeugen</translation>
    </message>
    <message>
        <source>Show the force of the material on each tool as an arrow with its number</source>
        <translation>Die Kraft des Materials auf jedes Werkzeug als Pfeil mit ihrer Zahl zeigen</translation>
    </message>
    <message>
        <source>Plot of forces</source>
        <translation>Diagramm der Kräfte</translation>
    </message>
    <message>
        <source>Show forces over time</source>
        <translation>Kräfte über der Zeit zeigen</translation>
    </message>
    <message>
        <source>Forces as table...</source>
        <translation>Kräfte als Tabelle...</translation>
    </message>
    <message>
        <source>Write the forces over time as a CSV file</source>
        <translation>Die Kräfte über der Zeit als CSV-Datei schreiben</translation>
    </message>
    <message>
        <source>Press on the part and pull   Esc: done</source>
        <translation>Auf das Teil drücken und ziehen   Esc: fertig</translation>
    </message>
    <message>
        <source>Keys drive tools   Shift: slower   Esc: done</source>
        <translation>Tasten fahren Werkzeuge   Umschalt: langsamer   Esc: fertig</translation>
    </message>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Entlang der Achsen des Werkzeugs</translation>
    </message>
    <message>
        <source>Handles lie along the axes of the tool, not of the world</source>
        <translation>Griffe liegen entlang der Achsen des Werkzeugs, nicht der Welt</translation>
    </message>
    <message>
        <source>Press material</source>
        <translation>Material drücken</translation>
    </message>
    <message>
        <source>Press on the part: the selected tool, or a thumb, comes straight onto it and goes in until its force limit holds it</source>
        <translation>Auf das Teil drücken: Das ausgewählte Werkzeug, sonst ein Daumen, kommt gerade darauf und dringt ein, bis seine Kraftgrenze es hält</translation>
    </message>
    <message>
        <source>Press and hold: the tool goes in until its force limit holds it   Esc: done</source>
        <translation>Drücken und halten: Das Werkzeug dringt ein, bis seine Kraftgrenze es hält   Esc: fertig</translation>
    </message>
</context>
<context>
    <name>HandsFeature</name>
    <message>
        <source>Hands</source>
        <translation>Hände</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Export forces over time</source>
        <translation>Kräfte über der Zeit exportieren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>There are no forces to write yet: press Play and let something happen first.</source>
        <translation>Noch gibt es keine Kräfte zu schreiben: drücken Sie Starten und lassen Sie etwas geschehen.</translation>
    </message>
</context>
<context>
    <name>HelpFeature</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middle button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit; with Shift or Ctrl pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;7, 0, numeric pad 1, 3&lt;/b&gt;&lt;/td&gt;&lt;td&gt;top, isometric, front, right; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;clicks select parts, faces, edges, objects; Ctrl adds&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;one, two, four views; V: the active view alone&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linke Taste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;wählen; ein Werkzeug ziehen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Mittlere Taste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drehen; mit Umschalt oder Strg schieben&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Rad&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zum Zeiger zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pfeile, Bild auf, Bild ab&lt;/b&gt;&lt;/td&gt;&lt;td&gt;das gewählte Werkzeug fahren; mit Umschalt langsamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Leertaste, . , Rücktaste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;starten oder anhalten, ein Schritt, zurücksetzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Entf&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Block hinzufügen, Flächen fixieren, entfernen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Schwerkraft, renormieren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Objekte, Körper verbergen, Kanten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;7, 0, Ziffernblock 1, 3&lt;/b&gt;&lt;/td&gt;&lt;td&gt;oben, isometrisch, vorne, rechts; Strg: von der anderen Seite&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Klicks wählen Teile, Flächen, Kanten, Objekte; Strg fügt hinzu&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspektivisch oder parallel, einpassen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Projekt speichern; Strg+Umschalt+S unter anderem Namen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Umschalt+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;eine, zwei, vier Ansichten; V: nur die aktive&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;jeden Befehl finden; F11: Vollbild&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;abbrechen&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>%1 kB</source>
        <translation>%1 kB</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Made at</source>
        <translation>Entstanden um</translation>
    </message>
    <message>
        <source>Simulated time at its end</source>
        <translation>Simulierte Zeit am Ende</translation>
    </message>
    <message>
        <source>Key moments: memory is kept for them longest</source>
        <translation>Wichtige Momente: für sie wird Speicher am längsten behalten</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>What moments may take. The oldest ones are dropped, and found again by repeating</source>
        <translation>Was Momente einnehmen dürfen. Die ältesten werden fallen gelassen und durch Wiederholen wiedergefunden</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>A key moment; click: no longer one</source>
        <translation>Ein wichtiger Moment; Klick: nicht mehr</translation>
    </message>
    <message>
        <source>Mark as a key moment</source>
        <translation>Als wichtigen Moment merken</translation>
    </message>
    <message>
        <source>Kept, %1</source>
        <translation>Behalten, %1</translation>
    </message>
    <message>
        <source>Found again by repeating what leads to it</source>
        <translation>Wird durch Wiederholen dessen wiedergefunden, was dahin führt</translation>
    </message>
    <message>
        <source>%1
Simulated: %2, step %3
%4</source>
        <translation>%1
Simuliert: %2, Schritt %3
%4</translation>
    </message>
    <message>
        <source>Go here, and branch from here with what is done next</source>
        <translation>Dorthin gehen und mit dem Nächsten von dort abzweigen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>No longer a key moment</source>
        <translation>Kein wichtiger Moment mehr</translation>
    </message>
    <message>
        <source>Mark as key moment</source>
        <translation>Als wichtigen Moment merken</translation>
    </message>
</context>
<context>
    <name>HomePage</name>
    <message>
        <source>Go on with</source>
        <translation>Weitermachen mit</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Datei öffnen...</translation>
    </message>
    <message>
        <source>Drop STEP, IGES, mesh or project files here</source>
        <translation>STEP-, IGES-, Netz- oder Projektdateien hier ablegen</translation>
    </message>
    <message>
        <source>It becomes a lump of real material to push, bend and squeeze.</source>
        <translation>Es wird ein Klumpen echtes Material zum Drücken, Biegen und Quetschen.</translation>
    </message>
    <message>
        <source>Unsaved work is waiting</source>
        <translation>Nicht gespeicherte Arbeit wartet</translation>
    </message>
    <message>
        <source>Recover...</source>
        <translation>Wiederherstellen...</translation>
    </message>
    <message>
        <source>Begin with an example</source>
        <translation>Mit einem Beispiel beginnen</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grob (0,2 % der Größe)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normal (0,05 % der Größe)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fein (0,0125 % der Größe)</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 Teil</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>1 solid</source>
        <translation>1 Volumenkörper</translation>
    </message>
    <message>
        <source>%1 solids</source>
        <translation>%1 Volumenkörper</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open %1 files</source>
        <translation>%1 Dateien öffnen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of the file</source>
        <translation>Wie weit die gezeichneten und gefüllten Dreiecke neben den Flächen der Datei liegen dürfen</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie die Datei sagt</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in</source>
        <translation>Die Einheit, in der die Zahlen der Datei gelesen werden</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Stay separate</source>
        <translation>Bleiben getrennt</translation>
    </message>
    <message>
        <source>Are glued together</source>
        <translation>Werden verklebt</translation>
    </message>
    <message>
        <source>What solids do that touch each other at rest</source>
        <translation>Was Volumenkörper tun, die sich in Ruhe berühren</translation>
    </message>
    <message>
        <source>Touching solids</source>
        <translation>Sich berührende Körper</translation>
    </message>
    <message>
        <source>Repair shapes: sew surfaces, close gaps</source>
        <translation>Formen reparieren: Flächen vernähen, Lücken schließen</translation>
    </message>
    <message>
        <source>Close flat openings, fill in spite of small holes</source>
        <translation>Ebene Öffnungen schließen, trotz kleiner Löcher füllen</translation>
    </message>
    <message>
        <source>Flat openings of any size get a plane face; other surfaces are filled where they wind around. What is open too wide is only shown.</source>
        <translation>Ebene Öffnungen jeder Größe bekommen eine ebene Fläche; andere Flächen werden gefüllt, wo sie umschließen. Was zu weit offen ist, wird nur gezeigt.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Reading is given up after this processor time; automatic: by the size of the file</source>
        <translation>Das Lesen wird nach dieser Rechenzeit aufgegeben; automatisch: nach der Größe der Datei</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>Reading is given up when it wants more memory; automatic: by the size of the file</source>
        <translation>Das Lesen wird aufgegeben, wenn es mehr Speicher will; automatisch: nach der Größe der Datei</translation>
    </message>
    <message>
        <source>Give up after</source>
        <translation>Aufgeben nach</translation>
    </message>
    <message>
        <source>For real time</source>
        <translation>Für Echtzeit</translation>
    </message>
    <message>
        <source>About so many objects</source>
        <translation>Etwa so viele Objekte</translation>
    </message>
    <message>
        <source>Cells across the thinnest wall</source>
        <translation>Zellen quer zur dünnsten Wand</translation>
    </message>
    <message>
        <source>Spacing of the objects</source>
        <translation>Abstand der Objekte</translation>
    </message>
    <message>
        <source>How finely to fill with objects; finer is slower</source>
        <translation>Wie fein mit Objekten gefüllt wird; feiner ist langsamer</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>All %1 parts</source>
        <translation>Alle %1 Teile</translation>
    </message>
    <message>
        <source>%1 of %2 parts</source>
        <translation>%1 von %2 Teilen</translation>
    </message>
</context>
<context>
    <name>ImportFeature</name>
    <message>
        <source>Import report</source>
        <translation>Importbericht</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>Opening %1 and %n more</source>
        <translation>
            <numerusform>%1 und eine weitere Datei werden geöffnet</numerusform>
            <numerusform>%1 und %n weitere Dateien werden geöffnet</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking into %1</source>
        <translation>%1 wird angesehen</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Teile (%1)</translation>
    </message>
    <message>
        <source>Projects, recipes and parts (%1)</source>
        <translation>Projekte, Rezepte und Teile (%1)</translation>
    </message>
    <message>
        <source>Recipes (%1)</source>
        <translation>Rezepte (%1)</translation>
    </message>
    <message>
        <source>Open parts</source>
        <translation>Teile öffnen</translation>
    </message>
    <message>
        <source>Open a project, a recipe or parts</source>
        <translation>Ein Projekt, ein Rezept oder Teile öffnen</translation>
    </message>
    <message>
        <source>Filling with a spacing of %1</source>
        <translation>Füllen mit einem Abstand von %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>&quot;%1&quot; wird nicht simuliert: %2</translation>
    </message>
    <message>
        <source>%1: %2, %3 surfaces to look at, nothing to simulate.</source>
        <translation>%1: %2, %3 Flächen zum Ansehen, nichts zu simulieren.</translation>
    </message>
    <message>
        <source>%1: %2, %3 objects of spacing %4, %5 connections, time step %6.</source>
        <translation>%1: %2, %3 Objekte im Abstand %4, %5 Verbindungen, Zeitschritt %6.</translation>
    </message>
    <message>
        <source>Take as %1</source>
        <translation>Als %1 nehmen</translation>
    </message>
    <message>
        <source>%1 parts of the file are missing; the import report says which and why.</source>
        <translation>%1 Teile der Datei fehlen; der Importbericht sagt, welche und warum.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>Nothing in this file is closed, so nothing can be filled and simulated; the import report says why. Open edges are drawn in color.</source>
        <translation>Nichts in dieser Datei ist geschlossen, also kann nichts gefüllt und simuliert werden; der Importbericht sagt, warum. Offene Kanten sind farbig gezeichnet.</translation>
    </message>
    <message>
        <source>Taking lengths in %1</source>
        <translation>Längen werden in %1 genommen</translation>
    </message>
</context>
<context>
    <name>ImportPanel</name>
    <message>
        <source>As the file says</source>
        <translation>Wie die Datei sagt</translation>
    </message>
    <message>
        <source>Close and fill</source>
        <translation>Schließen und füllen</translation>
    </message>
    <message>
        <source>Opens the file again: flat openings get a plane face, other surfaces are filled where they wind around</source>
        <translation>Öffnet die Datei noch einmal: ebene Öffnungen bekommen eine ebene Fläche, andere Flächen werden gefüllt, wo sie umschließen</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in. Another one opens the part anew in it.</source>
        <translation>Die Einheit, in der die Zahlen der Datei gelesen werden. Eine andere öffnet das Teil neu darin.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Längen in</translation>
    </message>
    <message>
        <source>%1, %2, %3 filled</source>
        <translation>%1, %2, %3 gefüllt</translation>
    </message>
    <message>
        <source>several formats</source>
        <translation>mehrere Formate</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 Teil</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>Take without repairs</source>
        <translation>Ohne Reparaturen nehmen</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>was not filled: %1</source>
        <translation>wurde nicht gefüllt: %1</translation>
    </message>
    <message>
        <source>Repaired: %1</source>
        <translation>Repariert: %1</translation>
    </message>
    <message>
        <source>Nothing was wrong with this file.</source>
        <translation>An dieser Datei war nichts falsch.</translation>
    </message>
</context>
<context>
    <name>KeyCards</name>
    <message>
        <source>Tool %1: add one</source>
        <translation>Werkzeug %1: hinzufügen</translation>
    </message>
</context>
<context>
    <name>KeyHand</name>
    <message>
        <source>%1 per step, %2 steps per second, Shift: slower</source>
        <translation>%1 je Schritt, %2 Schritte je Sekunde, Umschalt: langsamer</translation>
    </message>
</context>
<context>
    <name>LogPanel</name>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fehler: %1</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Knead</source>
        <translation>Knead</translation>
    </message>
    <message>
        <source>Ready. Open a part with Ctrl+O, or drop a file on the window.</source>
        <translation>Bereit. Öffnen Sie ein Teil mit Strg+O oder legen Sie eine Datei auf das Fenster.</translation>
    </message>
    <message>
        <source>%1: cancelled, nothing has changed.</source>
        <translation>%1: abgebrochen, nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Click faces to hold or free them   Esc: done</source>
        <translation>Flächen anklicken hält sie oder gibt sie frei   Esc: fertig</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: drive   Shift: slower   Middle: orbit</source>
        <translation>Pfeile, Bild auf, Bild ab: fahren   Umschalt: langsamer   Mitte: drehen</translation>
    </message>
    <message>
        <source>Middle: orbit   Shift+middle: pan   Wheel: zoom</source>
        <translation>Mitte: drehen   Umschalt+Mitte: schieben   Rad: zoomen</translation>
    </message>
    <message>
        <source>Nothing selected.</source>
        <translation>Nichts ausgewählt.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>Put a tool above the part to push it with</source>
        <translation>Ein Werkzeug über das Teil setzen, um es damit zu drücken</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>Öffnen Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>Nothing in this part is closed, so nothing can be simulated.</source>
        <translation>Nichts in diesem Teil ist geschlossen, also kann nichts simuliert werden.</translation>
    </message>
    <message>
        <source>Only a part to which nothing was done yet is pressed like this.</source>
        <translation>Nur ein Teil, mit dem noch nichts getan wurde, wird so gedrückt.</translation>
    </message>
    <message>
        <source>Pause first.</source>
        <translation>Halten Sie zuerst an.</translation>
    </message>
    <message>
        <source>Select a tool or a fixture first.</source>
        <translation>Wählen Sie zuerst ein Werkzeug oder eine Einspannung.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Jetzt nicht möglich.</translation>
    </message>
    <message>
        <source>Drag to move the timeline</source>
        <translation>Ziehen verschiebt die Zeitleiste</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Wählen Sie zuerst etwas aus.</translation>
    </message>
</context>
<context>
    <name>MaterialComparisonDialog</name>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Compare materials</source>
        <translation>Materialien vergleichen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Right by left</source>
        <translation>Rechts durch links</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>Schubmodul</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Schallgeschwindigkeit</translation>
    </message>
    <message>
        <source>1/%1 of it</source>
        <translation>1/%1 davon</translation>
    </message>
</context>
<context>
    <name>MaterialName</name>
    <message>
        <source>Soft jelly</source>
        <translation>Weiche Gelatine</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Gelatine</translation>
    </message>
    <message>
        <source>Soft foam</source>
        <translation>Weichschaum</translation>
    </message>
    <message>
        <source>Sponge rubber</source>
        <translation>Zellgummi</translation>
    </message>
    <message>
        <source>Silicone rubber</source>
        <translation>Silikonkautschuk</translation>
    </message>
    <message>
        <source>Modeling clay</source>
        <translation>Modellierton</translation>
    </message>
    <message>
        <source>Natural rubber</source>
        <translation>Naturkautschuk</translation>
    </message>
    <message>
        <source>Plasticine</source>
        <translation>Knetmasse</translation>
    </message>
    <message>
        <source>Rigid foam</source>
        <translation>Hartschaum</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Wood along the grain</source>
        <translation>Holz längs der Faser</translation>
    </message>
    <message>
        <source>Aluminum</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Silicone, Shore A 10</source>
        <translation>Silikon, Shore A 10</translation>
    </message>
    <message>
        <source>Silicone, Shore A 20</source>
        <translation>Silikon, Shore A 20</translation>
    </message>
    <message>
        <source>Silicone, Shore A 30</source>
        <translation>Silikon, Shore A 30</translation>
    </message>
    <message>
        <source>Silicone, Shore A 40</source>
        <translation>Silikon, Shore A 40</translation>
    </message>
    <message>
        <source>Silicone, Shore A 50</source>
        <translation>Silikon, Shore A 50</translation>
    </message>
    <message>
        <source>Silicone, Shore A 60</source>
        <translation>Silikon, Shore A 60</translation>
    </message>
    <message>
        <source>Water clay</source>
        <translation>Wasserhaltiger Ton</translation>
    </message>
    <message>
        <source>Oil clay</source>
        <translation>Plastilin auf Ölbasis</translation>
    </message>
    <message>
        <source>TPU 85A</source>
        <translation>TPU 85A</translation>
    </message>
    <message>
        <source>TPU 95A</source>
        <translation>TPU 95A</translation>
    </message>
    <message>
        <source>PLA</source>
        <translation>PLA</translation>
    </message>
    <message>
        <source>PETG</source>
        <translation>PETG</translation>
    </message>
    <message>
        <source>Nylon PA12</source>
        <translation>Nylon PA12</translation>
    </message>
    <message>
        <source>Putty</source>
        <translation>Kitt</translation>
    </message>
    <message>
        <source>Warm wax</source>
        <translation>Warmes Wachs</translation>
    </message>
</context>
<context>
    <name>MaterialPanel</name>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fließen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>Shape damping</source>
        <translation>Formdämpfung</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>Fließgrenze</translation>
    </message>
    <message>
        <source>never yields</source>
        <translation>fließt nie</translation>
    </message>
    <message>
        <source>Hardening</source>
        <translation>Verfestigung</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>Relaxationszeit</translation>
    </message>
    <message>
        <source>flows at once</source>
        <translation>fließt sofort</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Zugfestigkeit</translation>
    </message>
    <message>
        <source>never breaks</source>
        <translation>bricht nie</translation>
    </message>
    <message>
        <source>Elongation at break</source>
        <translation>Bruchdehnung</translation>
    </message>
    <message>
        <source>flows without end</source>
        <translation>fließt ohne Ende</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>does not stick</source>
        <translation>haftet nicht</translation>
    </message>
    <message>
        <source>Healing time</source>
        <translation>Heilungszeit</translation>
    </message>
    <message>
        <source>does not heal</source>
        <translation>heilt nicht</translation>
    </message>
    <message>
        <source>Rubber</source>
        <translation>Gummi</translation>
    </message>
    <message>
        <source>Rubberlike</source>
        <translation>Gummiartig</translation>
    </message>
    <message>
        <source>for small strains</source>
        <translation>für kleine Dehnungen</translation>
    </message>
    <message>
        <source>Second-invariant share</source>
        <translation>Anteil der zweiten Invariante</translation>
    </message>
    <message>
        <source>Locking elongation</source>
        <translation>Dehnung beim Versteifen</translation>
    </message>
    <message>
        <source>never locks</source>
        <translation>versteift nie</translation>
    </message>
    <message>
        <source>Deformable</source>
        <translation>Verformbar</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Starr</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Klebstoff</translation>
    </message>
    <message>
        <source>Keeps its shape and moves as a whole</source>
        <translation>Behält seine Form und bewegt sich als Ganzes</translation>
    </message>
    <message>
        <source>Keeps shape and place; its adhesion holds what touches it</source>
        <translation>Behält Form und Ort; seine Haftung hält, was es berührt</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Eigene Zahlen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Distance between neighboring objects</source>
        <translation>Abstand benachbarter Objekte</translation>
    </message>
    <message>
        <source>Objects along the longest side of the part</source>
        <translation>Objekte entlang der längsten Seite des Teils</translation>
    </message>
    <message>
        <source>Refill</source>
        <translation>Neu füllen</translation>
    </message>
    <message>
        <source>Fill all bodies again with this spacing; the simulation starts anew</source>
        <translation>Alle Körper mit diesem Abstand neu füllen; die Simulation beginnt von vorn</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Cells across</source>
        <translation>Zellen quer</translation>
    </message>
    <message>
        <source>%1 objects, %2 connections
%3 of material</source>
        <translation>%1 Objekte, %2 Verbindungen
%3 Material</translation>
    </message>
    <message>
        <source>Material of %1 → %2</source>
        <translation>Material von %1 → %2</translation>
    </message>
    <message>
        <source>%1 of %2 → %3</source>
        <translation>%1 von %2 → %3</translation>
    </message>
    <message>
        <source>What follows</source>
        <translation>Was daraus folgt</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Schallgeschwindigkeit</translation>
    </message>
    <message>
        <source>Of a thin bar: the root of stiffness by density</source>
        <translation>In einem dünnen Stab: die Wurzel aus Steifigkeit durch Dichte</translation>
    </message>
    <message>
        <source>Stable time step</source>
        <translation>Stabiler Zeitschritt</translation>
    </message>
    <message>
        <source>Longest step of an explicit scheme, for all bodies together; shorter for stiff, light and finely filled ones</source>
        <translation>Längster Schritt eines expliziten Verfahrens, für alle Körper zusammen; kürzer für steife, leichte und fein gefüllte</translation>
    </message>
    <message>
        <source>Expected speed</source>
        <translation>Erwartetes Tempo</translation>
    </message>
    <message>
        <source>Simulated by wall time on this machine: measured while time ran, else by a rule</source>
        <translation>Simulierte je echter Zeit auf diesem Rechner: gemessen, während die Zeit lief, sonst nach einer Faustregel</translation>
    </message>
    <message>
        <source>Cells across walls</source>
        <translation>Zellen quer zur Wand</translation>
    </message>
    <message>
        <source>%1 to %2, with any unit; 1.2e6 and 1,2 are taken too</source>
        <translation>%1 bis %2, in jeder Einheit; auch 1.2e6 und 1,2 werden angenommen</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>keeps up with real time</source>
        <translation>hält mit der Echtzeit Schritt</translation>
    </message>
    <message>
        <source>%1 of real time</source>
        <translation>%1 der Echtzeit</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Save these numbers as a material of your own</source>
        <translation>Diese Zahlen als eigenes Material speichern</translation>
    </message>
    <message>
        <source>Rename this material of your own</source>
        <translation>Dieses eigene Material umbenennen</translation>
    </message>
    <message>
        <source>Delete this material of your own; bodies keep its numbers</source>
        <translation>Dieses eigene Material löschen; Körper behalten seine Zahlen</translation>
    </message>
    <message>
        <source>Compare with another material, side by side</source>
        <translation>Mit einem anderen Material vergleichen, nebeneinander</translation>
    </message>
    <message>
        <source>Save material</source>
        <translation>Material speichern</translation>
    </message>
    <message>
        <source>Rename material</source>
        <translation>Material umbenennen</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Name des Materials</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 jetzt</translation>
    </message>
    <message>
        <source>Across the thinnest wall: with fewer than %1 its bending comes out too stiff</source>
        <translation>Quer zur dünnsten Wand: mit weniger als %1 biegt sie sich zu steif</translation>
    </message>
    <message>
        <source>%1: many times too stiff</source>
        <translation>%1: um ein Vielfaches zu steif</translation>
    </message>
    <message>
        <source>%1: up to %2 % too stiff</source>
        <translation>%1: bis zu %2 % zu steif</translation>
    </message>
    <message>
        <source>Toughness</source>
        <translation>Zähigkeit</translation>
    </message>
    <message>
        <source>knives do not cut it</source>
        <translation>Messer schneiden es nicht</translation>
    </message>
    <message>
        <source>Softer to the left, as warm or wet clay; firmer to the right, as cold or dry clay</source>
        <translation>Nach links weicher, wie warmer oder nasser Ton; nach rechts fester, wie kalter oder trockener Ton</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Softer / firmer</source>
        <translation>Weicher / fester</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie es ist</translation>
    </message>
    <message>
        <source>Firmness of %1 as it was</source>
        <translation>Festigkeit von %1 wie zuvor</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 weicher</translation>
    </message>
    <message>
        <source>%1 firmer</source>
        <translation>%1 fester</translation>
    </message>
</context>
<context>
    <name>MaterialStore</name>
    <message>
        <source>Your own materials cannot be read: %1 Mend or remove the file; until then none can be saved.</source>
        <translation>Ihre eigenen Materialien lassen sich nicht lesen: %1 Reparieren oder entfernen Sie die Datei; bis dahin kann keines gespeichert werden.</translation>
    </message>
    <message>
        <source>A material needs a name: type one.</source>
        <translation>Ein Material braucht einen Namen: tippen Sie einen.</translation>
    </message>
    <message>
        <source>There is a material named &quot;%1&quot; already: choose another name.</source>
        <translation>Ein Material namens „%1“ gibt es schon: wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Saved by you</source>
        <translation>Von Ihnen gespeichert</translation>
    </message>
    <message>
        <source>The material was not saved: %1</source>
        <translation>Das Material wurde nicht gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Nothing is measured yet. Choose what to measure above, then click on the part; corners attract. Numbers follow the material while time runs.</source>
        <translation>Noch wird nichts gemessen. Wählen Sie oben, was zu messen ist, und klicken Sie dann auf das Teil; Ecken ziehen den Zeiger an. Die Zahlen folgen dem Material, während die Zeit läuft.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Vergleichen...</translation>
    </message>
    <message>
        <source>Compare the parts with their original shape, and write a report</source>
        <translation>Die Teile mit ihrer ursprünglichen Form vergleichen und einen Bericht schreiben</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table (Ctrl+C)</source>
        <translation>Die Tabelle kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write the table to a file, units in its columns</source>
        <translation>Die Tabelle in eine Datei schreiben, Einheiten in ihren Spalten</translation>
    </message>
    <message>
        <source>Delete the selected measurements, or all (Del)</source>
        <translation>Die gewählten Messungen löschen, oder alle (Entf)</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messgröße</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>The face is not flat: it is up to %1 away from its mean plane.</source>
        <translation>Die Fläche ist nicht eben: sie liegt bis zu %1 neben ihrer mittleren Ebene.</translation>
    </message>
    <message>
        <source>The three places lie on a line: pick others, further around.</source>
        <translation>Die drei Stellen liegen auf einer Geraden: wählen Sie andere, weiter um den Kreis verteilt.</translation>
    </message>
    <message>
        <source>The face is flat and has no radius: click a round one, or measure with three places.</source>
        <translation>Die Fläche ist eben und hat keinen Radius: klicken Sie eine runde an, oder messen Sie mit drei Stellen.</translation>
    </message>
    <message>
        <source>The face is not quite round: it is up to %1 away from this radius.</source>
        <translation>Die Fläche ist nicht ganz rund: sie liegt bis zu %1 neben diesem Radius.</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Bewegt um</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>entlang X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>entlang Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>entlang Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Size X</source>
        <translation>Größe X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Größe Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Größe Z</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Center of mass X</source>
        <translation>Schwerpunkt X</translation>
    </message>
    <message>
        <source>Center of mass Y</source>
        <translation>Schwerpunkt Y</translation>
    </message>
    <message>
        <source>Center of mass Z</source>
        <translation>Schwerpunkt Z</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Coordinates of a place, and how far it has moved</source>
        <translation>Koordinaten einer Stelle, und wie weit sie sich bewegt hat</translation>
    </message>
    <message>
        <source>Distance between two places</source>
        <translation>Abstand zwischen zwei Stellen</translation>
    </message>
    <message>
        <source>Distance to face</source>
        <translation>Abstand zur Fläche</translation>
    </message>
    <message>
        <source>Distance of a place from the nearest point of a face</source>
        <translation>Abstand einer Stelle vom nächsten Punkt einer Fläche</translation>
    </message>
    <message>
        <source>Angle at the second of three places</source>
        <translation>Winkel an der zweiten von drei Stellen</translation>
    </message>
    <message>
        <source>Angle of faces</source>
        <translation>Winkel von Flächen</translation>
    </message>
    <message>
        <source>Angle between the normals of two faces</source>
        <translation>Winkel zwischen den Normalen zweier Flächen</translation>
    </message>
    <message>
        <source>Radius of the circle through three places</source>
        <translation>Radius des Kreises durch drei Stellen</translation>
    </message>
    <message>
        <source>Radius of face</source>
        <translation>Radius der Fläche</translation>
    </message>
    <message>
        <source>Radius of a hole, a cylinder or a ball</source>
        <translation>Radius eines Lochs, eines Zylinders oder einer Kugel</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Hüllquader</translation>
    </message>
    <message>
        <source>Sizes of a part along the axes</source>
        <translation>Maße eines Teils entlang der Achsen</translation>
    </message>
    <message>
        <source>Volume and mass</source>
        <translation>Volumen und Masse</translation>
    </message>
    <message>
        <source>Volume, mass and center of mass of a part</source>
        <translation>Volumen, Masse und Schwerpunkt eines Teils</translation>
    </message>
</context>
<context>
    <name>MeasurementList</name>
    <message>
        <source>Measurement,Reading,Unit,Now,At rest,Change</source>
        <translation>Messung,Messgröße,Einheit,Jetzt,In Ruhe,Änderung</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>Compare with original...</source>
        <translation>Mit Original vergleichen...</translation>
    </message>
    <message>
        <source>Largest and mean distance, volume and mass beside the original, and a report (Shift+M)</source>
        <translation>Größter und mittlerer Abstand, Volumen und Masse neben dem Original, und ein Bericht (Umschalt+M)</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
</context>
<context>
    <name>MeasuringFeature</name>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Write what was measured</source>
        <translation>Messungen schreiben</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>ModelNotes</name>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
</context>
<context>
    <name>ModelPanel</name>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
</context>
<context>
    <name>ModelTree</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Einspannungen</translation>
    </message>
    <message>
        <source>Assembly</source>
        <translation>Baugruppe</translation>
    </message>
    <message>
        <source>Not a closed solid: it is not simulated.</source>
        <translation>Kein geschlossener Körper: er wird nicht simuliert.</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 Fläche</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>Selections</source>
        <translation>Auswahlsätze</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporte</translation>
    </message>
    <message>
        <source>In the file: %1</source>
        <translation>In der Datei: %1</translation>
    </message>
    <message>
        <source>%1 selected things; a click selects them again</source>
        <translation>%1 ausgewählte Elemente; ein Klick wählt sie wieder aus</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Keep the present selection here</source>
        <translation>Jetzige Auswahl hier aufbewahren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>The folder %1 cannot be shown: look for it with your file manager.</source>
        <translation>Der Ordner %1 lässt sich nicht zeigen: suchen Sie ihn mit Ihrer Dateiverwaltung.</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>There is a selection called &quot;%1&quot; already: choose another name.</source>
        <translation>Einen Auswahlsatz namens „%1“ gibt es schon: wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Color of the part</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>Color of %1 parts</source>
        <translation>Farbe von %1 Teilen</translation>
    </message>
</context>
<context>
    <name>ModelTreeDelegate</name>
    <message>
        <source>Show (H)</source>
        <translation>Zeigen (H)</translation>
    </message>
    <message>
        <source>Hide (H)</source>
        <translation>Verbergen (H)</translation>
    </message>
    <message>
        <source>Unlock (L)</source>
        <translation>Entsperren (L)</translation>
    </message>
    <message>
        <source>Lock: keep it from being changed (L)</source>
        <translation>Sperren: vor Änderungen bewahren (L)</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>The graphics card draws no pictures of this size. Choose a smaller one.</source>
        <translation>Die Grafikkarte zeichnet keine Bilder dieser Größe. Wählen Sie eine kleinere.</translation>
    </message>
    <message>
        <source>The graphics card takes no more pictures. Close other programs and try again.</source>
        <translation>Die Grafikkarte nimmt keine Bilder mehr auf. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The graphics driver draws for the window only, so that nothing can be recorded. Start Knead with LIBGL_ALWAYS_SOFTWARE=1 in its environment to record without the driver.</source>
        <translation>Der Grafiktreiber zeichnet nur für das Fenster, deshalb kann nichts aufgezeichnet werden. Starten Sie Knead mit LIBGL_ALWAYS_SOFTWARE=1 in seiner Umgebung, um ohne den Treiber aufzuzeichnen.</translation>
    </message>
</context>
<context>
    <name>PerformancePanel</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Commands and the motion of tools</source>
        <translation>Befehle und die Bewegung der Werkzeuge</translation>
    </message>
    <message>
        <source>Vicinity</source>
        <translation>Nachbarschaft</translation>
    </message>
    <message>
        <source>Finding what may touch</source>
        <translation>Finden, was sich berühren kann</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Plastic flow, breaking and annealing</source>
        <translation>Plastisches Fließen, Brechen und Glühen</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Forces of structural connections, or the equations of an implicit step</source>
        <translation>Kräfte struktureller Verbindungen oder die Gleichungen eines impliziten Schritts</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Forces of contacts, joints and fixtures</source>
        <translation>Kräfte von Kontakten, Gelenken und Einspannungen</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Integration of velocities and positions</source>
        <translation>Integration von Geschwindigkeiten und Orten</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Health, the stable step, and states to go back to</source>
        <translation>Gesundheit, stabiler Schritt und Zustände zum Zurückgehen</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Momentaufnahme</translation>
    </message>
    <message>
        <source>Handing the state to the window</source>
        <translation>Den Zustand an das Fenster übergeben</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs/step</source>
        <translation>%1 µs/Schritt</translation>
    </message>
    <message>
        <source>%1 ms/step</source>
        <translation>%1 ms/Schritt</translation>
    </message>
    <message>
        <source>Time of a frame; its whole length is a sixtieth of a second</source>
        <translation>Zeit eines Bildes; die ganze Länge ist eine sechzigstel Sekunde</translation>
    </message>
    <message>
        <source>Open a part and press play to see where the time goes.</source>
        <translation>Öffnen Sie ein Teil und drücken Sie Starten, um zu sehen, wohin die Zeit geht.</translation>
    </message>
    <message>
        <source>%1, %2 step of %3 per frame</source>
        <translation>%1, %2 Schritt von %3 je Bild</translation>
    </message>
    <message>
        <source>%1, %2 steps of %3 per frame</source>
        <translation>%1, %2 Schritte von %3 je Bild</translation>
    </message>
    <message>
        <source>%1 iterations of the solver in the last step, %2 objects</source>
        <translation>%1 Iterationen des Lösers im letzten Schritt, %2 Objekte</translation>
    </message>
    <message>
        <source>%1 million connections per second, %2 objects</source>
        <translation>%1 Millionen Verbindungen je Sekunde, %2 Objekte</translation>
    </message>
</context>
<context>
    <name>PickTool</name>
    <message>
        <source>click a place</source>
        <translation>Stelle anklicken</translation>
    </message>
    <message>
        <source>click place %1 of %2</source>
        <translation>Stelle %1 von %2 anklicken</translation>
    </message>
    <message>
        <source>click a face</source>
        <translation>Fläche anklicken</translation>
    </message>
    <message>
        <source>click face %1 of %2</source>
        <translation>Fläche %1 von %2 anklicken</translation>
    </message>
    <message>
        <source>click a part</source>
        <translation>Teil anklicken</translation>
    </message>
    <message>
        <source>%1: %2   Esc: done</source>
        <translation>%1: %2   Esc: fertig</translation>
    </message>
    <message>
        <source>There is nothing at that place: click on a part.</source>
        <translation>An dieser Stelle ist nichts: klicken Sie auf ein Teil.</translation>
    </message>
    <message>
        <source>This part is a mesh without CAD faces: measure it with places instead.</source>
        <translation>Dieses Teil ist ein Netz ohne CAD-Flächen: messen Sie es stattdessen mit Stellen.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Erscheinung</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Names that you gave, and what the command line says, stay as they are.</source>
        <translation>Namen, die Sie vergeben haben, und was die Befehlszeile sagt, bleiben wie sie sind.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Längen in</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Zentimeter (cm)</translation>
    </message>
    <message>
        <source>Metres (m)</source>
        <translation>Meter (m)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Zoll (in)</translation>
    </message>
    <message>
        <source>Speeds and volumes follow. Every field takes numbers in any unit, such as 12.5 mm, 12,5 mm or 0.5 in.</source>
        <translation>Geschwindigkeiten und Volumen folgen. Jedes Feld nimmt Zahlen in jeder Einheit, etwa 12.5 mm, 12,5 mm oder 0.5 in.</translation>
    </message>
    <message>
        <source>Memory and safety</source>
        <translation>Speicher und Sicherheit</translation>
    </message>
    <message>
        <source>For undo</source>
        <translation>Für Rückgängig</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>The oldest moments are dropped, and found again by repeating what was done.</source>
        <translation>Die ältesten Momente werden fallen gelassen und wiedergefunden, indem wiederholt wird, was getan wurde.</translation>
    </message>
    <message>
        <source>For looking back</source>
        <translation>Für den Rückblick</translation>
    </message>
    <message>
        <source>When it is full, every second picture of the older half goes.</source>
        <translation>Ist er voll, geht jedes zweite Bild der älteren Hälfte.</translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation>Nicht Gespeichertes aufbewahren alle</translation>
    </message>
    <message>
        <source>After a crash, no more than this and two seconds are lost.</source>
        <translation>Nach einem Absturz geht nicht mehr verloren als dies und zwei Sekunden.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>All (%1)</source>
        <translation>Alle (%1)</translation>
    </message>
    <message>
        <source>That compute. The results are the same for any number.</source>
        <translation>Die rechnen. Die Ergebnisse sind für jede Zahl dieselben.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grob (0,2 % der Größe)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normal (0,05 % der Größe)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fein (0,0125 % der Größe)</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of a file. Open with choices asks for each file.</source>
        <translation>Wie weit die gezeichneten und gefüllten Dreiecke neben den Flächen einer Datei liegen dürfen. „Mit Auswahl öffnen“ fragt bei jeder Datei.</translation>
    </message>
    <message>
        <source>Give up reading after</source>
        <translation>Lesen aufgeben nach</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>or with more memory than</source>
        <translation>oder mit mehr Speicher als</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>Automatic: by the size of the file.</source>
        <translation>Automatisch: nach der Größe der Datei.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Smooth edges</source>
        <translation>Glatte Kanten</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>2 samples</source>
        <translation>2 Abtastungen</translation>
    </message>
    <message>
        <source>4 samples</source>
        <translation>4 Abtastungen</translation>
    </message>
    <message>
        <source>8 samples</source>
        <translation>8 Abtastungen</translation>
    </message>
    <message>
        <source>More is slower without a graphics card.</source>
        <translation>Mehr ist ohne Grafikkarte langsamer.</translation>
    </message>
    <message>
        <source>Turn smoothly from one view to another</source>
        <translation>Von einer Ansicht sanft zur anderen drehen</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Vorgaben wiederherstellen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>PressHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties to press into it.</source>
        <translation>%1 verformt sich nicht: In den Eigenschaften verformbar machen, um es einzudrücken.</translation>
    </message>
    <message>
        <source>Press on %1</source>
        <translation>Auf %1 drücken</translation>
    </message>
    <message>
        <source>%1 (limit)</source>
        <translation>%1 (Grenze)</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it in the model tree to press with it.</source>
        <translation>%1 ist gesperrt: Im Modellbaum entsperren, um damit zu drücken.</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Equivalent strain</source>
        <translation>Vergleichsdehnung</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Force on tools</source>
        <translation>Kraft an Werkzeugen</translation>
    </message>
    <message>
        <source>Force on all tools</source>
        <translation>Kraft an allen Werkzeugen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>No probes yet. Place one on the part: it goes along with the material and plots what it reads, also of what was simulated before.</source>
        <translation>Noch keine Sonden. Setzen Sie eine auf das Teil: sie geht mit dem Material mit und trägt auf, was sie misst, auch aus dem, was davor simuliert wurde.</translation>
    </message>
    <message>
        <source>What is plotted over time</source>
        <translation>Was über der Zeit aufgetragen wird</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write all readings over time to a file, units in its header</source>
        <translation>Alle Messwerte über der Zeit in eine Datei schreiben, Einheiten in ihrer Kopfzeile</translation>
    </message>
    <message>
        <source>Delete the selected probes, or all</source>
        <translation>Die gewählten Sonden löschen, oder alle</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>Sonde %1</translation>
    </message>
    <message>
        <source>All tools</source>
        <translation>Alle Werkzeuge</translation>
    </message>
</context>
<context>
    <name>ProbeSet</name>
    <message>
        <source>Probe %1</source>
        <translation>Sonde %1</translation>
    </message>
</context>
<context>
    <name>ProbesFeature</name>
    <message>
        <source>Probes</source>
        <translation>Sonden</translation>
    </message>
    <message>
        <source>Write what the probes read</source>
        <translation>Messwerte der Sonden schreiben</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Place probe</source>
        <translation>Sonde setzen</translation>
    </message>
    <message>
        <source>Click places of the part to plot what happens there over time (P)</source>
        <translation>Stellen des Teils anklicken, um aufzutragen, was dort über der Zeit geschieht (P)</translation>
    </message>
</context>
<context>
    <name>ProjectKeeper</name>
    <message>
        <source>The work is kept for recovery again.</source>
        <translation>Die Arbeit wird wieder für die Wiederherstellung aufbewahrt.</translation>
    </message>
    <message>
        <source>Knead projects (*.%1)</source>
        <translation>Knead-Projekte (*.%1)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Rescuing %1</source>
        <translation>%1 wird gerettet</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Rescue what is whole</source>
        <translation>Retten, was heil ist</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Speichern unter...</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Not whole: %1</source>
        <translation>Nicht heil: %1</translation>
    </message>
    <message>
        <source>Not everything is whole</source>
        <translation>Nicht alles ist heil</translation>
    </message>
    <message>
        <source>This could not be brought back:</source>
        <translation>Dies ließ sich nicht zurückholen:</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover.</source>
        <translation>Es gibt keine nicht gespeicherte Arbeit wiederherzustellen.</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name, or choose that file.</source>
        <translation>%1 gibt es schon: wählen Sie einen anderen Namen oder diese Datei.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, and save again.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab, und speichern Sie dann.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the work on &quot;%1&quot; as a project?</source>
        <translation>Die Arbeit an „%1“ als Projekt speichern?</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>Die Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>It has never been saved.</source>
        <translation>Es wurde noch nie gespeichert.</translation>
    </message>
    <message>
        <source>What was done since it was saved is lost otherwise.</source>
        <translation>Was seit dem Speichern getan wurde, geht sonst verloren.</translation>
    </message>
</context>
<context>
    <name>ProjectsFeature</name>
    <message>
        <source>Knead</source>
        <translation>Knead</translation>
    </message>
    <message>
        <source>%1[*] - Knead</source>
        <translation>%1[*] - Knead</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>%1 is not there any more. It may have been moved: look for it with Ctrl+O.</source>
        <translation>%1 ist nicht mehr da. Vielleicht wurde es verschoben: suchen Sie es mit Strg+O.</translation>
    </message>
    <message>
        <source>A project is opened alone: choose one file, or only parts.</source>
        <translation>Ein Projekt wird allein geöffnet: wählen Sie eine Datei oder nur Teile.</translation>
    </message>
</context>
<context>
    <name>PullHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties, or push it with a tool.</source>
        <translation>%1 verformt sich nicht: machen Sie es in den Eigenschaften verformbar, oder drücken Sie es mit einem Werkzeug.</translation>
    </message>
    <message>
        <source>%1 is held at this place: free it with Fix faces, or pull at another place.</source>
        <translation>%1 wird an dieser Stelle gehalten: geben Sie sie mit „Flächen fixieren“ frei, oder ziehen Sie an einer anderen.</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>An %1 ziehen</translation>
    </message>
    <message>
        <source>%1 (limit)</source>
        <translation>%1 (Grenze)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>%1x real time</source>
        <translation>%1x Echtzeit</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>&quot;%1&quot; is not a number here; the value is still %2. Esc restores it.</source>
        <translation>„%1“ ist hier keine Zahl; der Wert ist weiter %2. Esc stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>Allowed is %1 to %2; the value is still %3. Esc restores it.</source>
        <translation>Erlaubt ist %1 bis %2; der Wert ist weiter %3. Esc stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>Allowed: %1 to %2</source>
        <translation>Erlaubt: %1 bis %2</translation>
    </message>
    <message>
        <source>Allowed: %1 or more</source>
        <translation>Erlaubt: %1 oder mehr</translation>
    </message>
    <message>
        <source>A number, such as 0.5, 0,5 or 5e-1</source>
        <translation>Eine Zahl, etwa 0.5, 0,5 oder 5e-1</translation>
    </message>
    <message>
        <source>Units: %1</source>
        <translation>Einheiten: %1</translation>
    </message>
</context>
<context>
    <name>ReadProject</name>
    <message>
        <source>%1 was written after this work was cut off, and stays as it is: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 wurde geschrieben, nachdem diese Arbeit abgebrochen war, und bleibt, wie es ist: speichern Sie die Arbeit unter einem eigenen Namen oder anstelle jener Datei.</translation>
    </message>
    <message>
        <source>%1 stays as it is, since the recovered work is not whole: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 bleibt, wie es ist, denn die wiederhergestellte Arbeit ist nicht vollständig: speichern Sie die Arbeit unter einem eigenen Namen oder anstelle jener Datei.</translation>
    </message>
    <message>
        <source>The parts of this project are lost, so that nothing of it can be shown. Open the part that it was made from.</source>
        <translation>Die Teile dieses Projekts sind verloren, sodass nichts davon gezeigt werden kann. Öffnen Sie das Teil, aus dem es gemacht wurde.</translation>
    </message>
    <message>
        <source>%1: what was seen last cannot be shown. %2 What is whole can be rescued.</source>
        <translation>%1: was zuletzt zu sehen war, kann nicht gezeigt werden. %2 Was heil ist, kann gerettet werden.</translation>
    </message>
</context>
<context>
    <name>RecipesFeature</name>
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Ein Rezept wird allein geöffnet: wählen Sie eine Datei oder nur Teile.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Play carries out %1; what is done by hand comes on top of it.</source>
        <translation>Starten führt %1 aus; was von Hand getan wird, kommt dazu.</translation>
    </message>
    <message>
        <source>Export as a recipe</source>
        <translation>Als Rezept exportieren</translation>
    </message>
    <message>
        <source>Recipes (*.%1)</source>
        <translation>Rezepte (*.%1)</translation>
    </message>
    <message>
        <source>Exported the session as a recipe to %1.</source>
        <translation>Die Sitzung als Rezept nach %1 exportiert.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
</context>
<context>
    <name>RecordDialog</name>
    <message>
        <source>Record a video</source>
        <translation>Video aufnehmen</translation>
    </message>
    <message>
        <source>Record pictures</source>
        <translation>Bilder aufnehmen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>Wie simuliert</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>With the time, and forces on tools</source>
        <translation>Mit Zeit und Kräften an Werkzeugen</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, wie die Ansicht</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Ort wählen...</translation>
    </message>
    <message>
        <source>1 picture</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1: a video of %2 (Ogg Theora)</source>
        <translation>%1: ein Video von %2 (Ogg Theora)</translation>
    </message>
    <message>
        <source>%1: PNG files in a folder of their own</source>
        <translation>%1: PNG-Dateien in einem eigenen Ordner</translation>
    </message>
    <message>
        <source>What the active view shows: %1</source>
        <translation>Was die aktive Ansicht zeigt: %1</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>picture %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>RecordingFeature</name>
    <message>
        <source>There is nothing to record yet: press Play and let something happen first.</source>
        <translation>Noch ist nichts aufzunehmen: drücken Sie Starten und lassen Sie etwas geschehen.</translation>
    </message>
    <message>
        <source>Save the video</source>
        <translation>Video speichern</translation>
    </message>
    <message>
        <source>Make a folder for the pictures</source>
        <translation>Ordner für die Bilder anlegen</translation>
    </message>
    <message>
        <source>Video (*.ogv)</source>
        <translation>Video (*.ogv)</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>Ordner (*)</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>%1 wird aufgenommen</translation>
    </message>
    <message>
        <source>%1: 1 picture recorded.</source>
        <translation>%1: 1 Bild aufgenommen.</translation>
    </message>
    <message>
        <source>%1: %2 pictures recorded.</source>
        <translation>%1: %2 Bilder aufgenommen.</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>nobody knows when</source>
        <translation>niemand weiß, wann</translation>
    </message>
    <message>
        <source>today, %1</source>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gestern, %1</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>just begun</source>
        <translation>eben begonnen</translation>
    </message>
    <message>
        <source>1 change</source>
        <translation>1 Änderung</translation>
    </message>
    <message>
        <source>%1 changes</source>
        <translation>%1 Änderungen</translation>
    </message>
    <message>
        <source>Work without a name</source>
        <translation>Arbeit ohne Namen</translation>
    </message>
    <message>
        <source>%1, never saved</source>
        <translation>%1, nie gespeichert</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Nicht Gespeichertes wiederherstellen</translation>
    </message>
    <message>
        <source>Knead ended before this was saved</source>
        <translation>Knead endete, bevor dies gespeichert war</translation>
    </message>
    <message>
        <source>What is recovered opens unsaved, and stays here until you save or discard it.</source>
        <translation>Wiederhergestelltes öffnet sich ungespeichert und bleibt hier, bis Sie es speichern oder verwerfen.</translation>
    </message>
    <message>
        <source>%1  ·  %2</source>
        <translation>%1  ·  %2</translation>
    </message>
    <message>
        <source>Discard...</source>
        <translation>Verwerfen...</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard unsaved work</source>
        <translation>Nicht Gespeichertes verwerfen</translation>
    </message>
    <message>
        <source>Discard the unsaved work on &quot;%1&quot;? It cannot be brought back.</source>
        <translation>Die nicht gespeicherte Arbeit an „%1“ verwerfen? Sie lässt sich nicht zurückholen.</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>1 part, %2</source>
        <translation>1 Teil, %2</translation>
    </message>
    <message>
        <source>%1 parts, %2</source>
        <translation>%1 Teile, %2</translation>
    </message>
    <message>
        <source>1 face, %2</source>
        <translation>1 Fläche, %2</translation>
    </message>
    <message>
        <source>%1 faces, %2</source>
        <translation>%1 Flächen, %2</translation>
    </message>
    <message>
        <source>1 edge, %2</source>
        <translation>1 Kante, %2</translation>
    </message>
    <message>
        <source>%1 edges, %2</source>
        <translation>%1 Kanten, %2</translation>
    </message>
    <message>
        <source>1 object, %2</source>
        <translation>1 Objekt, %2</translation>
    </message>
    <message>
        <source>%1 objects, %2</source>
        <translation>%1 Objekte, %2</translation>
    </message>
    <message>
        <source>1 connection, %2</source>
        <translation>1 Verbindung, %2</translation>
    </message>
    <message>
        <source>%1 connections, %2</source>
        <translation>%1 Verbindungen, %2</translation>
    </message>
</context>
<context>
    <name>RunRemarks</name>
    <message>
        <source>Time hardly goes on: %1 were simulated in %2, in steps of %3. A larger spacing, a softer material, slower tools or ones that begin outside the material make it faster.</source>
        <translation>Die Zeit geht kaum voran: %1 wurden in %2 simuliert, in Schritten von %3. Ein größerer Abstand, ein weicheres Material, langsamere Werkzeuge oder solche, die außerhalb des Materials beginnen, machen es schneller.</translation>
    </message>
</context>
<context>
    <name>SectionKnob</name>
    <message>
        <source>Drag to move the section plane; arrow keys move it by a hundredth of the part</source>
        <translation>Ziehen verschiebt die Schnittebene; Pfeiltasten bewegen sie um ein Hundertstel des Teils</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
</context>
<context>
    <name>SelectionActions</name>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Clicks select parts</source>
        <translation>Klicks wählen Teile aus</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Clicks select faces</source>
        <translation>Klicks wählen Flächen aus</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Clicks select edges</source>
        <translation>Klicks wählen Kanten aus</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Clicks select the objects the material is made of</source>
        <translation>Klicks wählen die Objekte aus, aus denen das Material besteht</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Clicks select connections between objects</source>
        <translation>Klicks wählen Verbindungen zwischen Objekten aus</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Drag a box: to the right for what lies in it, to the left also for what it touches</source>
        <translation>Ein Rechteck ziehen: nach rechts für das, was darin liegt, nach links auch für das, was es berührt</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw a line around what is wanted</source>
        <translation>Eine Linie um das Gewünschte zeichnen</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Paint over what is wanted</source>
        <translation>Über das Gewünschte malen</translation>
    </message>
    <message>
        <source>Through the part</source>
        <translation>Durch das Teil hindurch</translation>
    </message>
    <message>
        <source>Boxes, lassos and brushes select what is hidden behind the skin too</source>
        <translation>Rechteck, Lasso und Pinsel wählen auch aus, was hinter der Haut verborgen ist</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>A smaller brush</source>
        <translation>Ein kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Größerer Pinsel</translation>
    </message>
    <message>
        <source>A larger brush</source>
        <translation>Ein größerer Pinsel</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Everything of the kind that clicks select</source>
        <translation>Alles von der Art, die Klicks auswählen</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Die Auswahl aufheben</translation>
    </message>
    <message>
        <source>All within a distance...</source>
        <translation>Alles innerhalb eines Abstands...</translation>
    </message>
    <message>
        <source>The objects that lie no farther from the selection than a distance</source>
        <translation>Die Objekte, die nicht weiter als ein Abstand von der Auswahl entfernt liegen</translation>
    </message>
    <message>
        <source>Save selection...</source>
        <translation>Auswahl speichern...</translation>
    </message>
    <message>
        <source>Keep the selection under a name in the model tree</source>
        <translation>Die Auswahl unter einem Namen im Modellbaum behalten</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Auswahl fixieren</translation>
    </message>
    <message>
        <source>Hold the selected faces or objects in place</source>
        <translation>Die ausgewählten Flächen oder Objekte festhalten</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Auswahl renormieren</translation>
    </message>
    <message>
        <source>The selection takes its present shape for its own</source>
        <translation>Die Auswahl nimmt ihre jetzige Form als eigene an</translation>
    </message>
    <message>
        <source>Make it glue</source>
        <translation>Zu Klebstoff machen</translation>
    </message>
    <message>
        <source>The selected parts keep shape and place and hold what touches them</source>
        <translation>Die ausgewählten Teile behalten Form und Ort und halten, was sie berührt</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Another name for the selected part, group or selection</source>
        <translation>Ein anderer Name für das ausgewählte Teil, die Gruppe oder die Auswahl</translation>
    </message>
    <message>
        <source>Color...</source>
        <translation>Farbe...</translation>
    </message>
    <message>
        <source>Another color for the selected parts</source>
        <translation>Eine andere Farbe für die ausgewählten Teile</translation>
    </message>
    <message>
        <source>Color of the file</source>
        <translation>Farbe der Datei</translation>
    </message>
    <message>
        <source>The color that the part has in its file</source>
        <translation>Die Farbe, die das Teil in seiner Datei hat</translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation>Sperren oder entsperren</translation>
    </message>
    <message>
        <source>Keep what is selected from being changed</source>
        <translation>Das Ausgewählte vor Änderungen schützen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Put the selected parts into a group</source>
        <translation>Die ausgewählten Teile in eine Gruppe legen</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message>
        <source>Take the selected parts out of their group, or all out of the selected one</source>
        <translation>Die ausgewählten Teile aus ihrer Gruppe nehmen, oder alle aus der ausgewählten</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Show nothing but the selected parts; again: what was shown before</source>
        <translation>Nur die ausgewählten Teile zeigen; noch einmal: was vorher zu sehen war</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Hide no part</source>
        <translation>Kein Teil verbergen</translation>
    </message>
    <message>
        <source>Search the model</source>
        <translation>Im Modell suchen</translation>
    </message>
    <message>
        <source>Look for parts, tools, fixtures and selections by their names</source>
        <translation>Teile, Werkzeuge, Einspannungen und Auswahlen nach Namen suchen</translation>
    </message>
</context>
<context>
    <name>SelectionFeature</name>
    <message>
        <source>Se&amp;lect</source>
        <translation>Auswah&amp;l</translation>
    </message>
    <message>
        <source>Selecting</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Selecting within %1</source>
        <translation>Auswählen im Umkreis von %1</translation>
    </message>
</context>
<context>
    <name>SelectionPanel</name>
    <message>
        <source>Fix</source>
        <translation>Fixieren</translation>
    </message>
    <message>
        <source>Hold it in place (Shift+F)</source>
        <translation>An Ort und Stelle halten (Umschalt+F)</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormieren</translation>
    </message>
    <message>
        <source>It takes its present shape for its own (Shift+N)</source>
        <translation>Sie nimmt ihre jetzige Form als eigene an (Umschalt+N)</translation>
    </message>
    <message>
        <source>Enter keeps the selection under this name in the model tree</source>
        <translation>Die Eingabetaste bewahrt die Auswahl unter diesem Namen im Modellbaum auf</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Keep the selection under this name</source>
        <translation>Die Auswahl unter diesem Namen aufbewahren</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern als</translation>
    </message>
    <message>
        <source>Enter selects the objects that lie no farther from the selection than this</source>
        <translation>Die Eingabetaste wählt die Objekte aus, die nicht weiter als dies von der Auswahl entfernt liegen</translation>
    </message>
    <message>
        <source>All within</source>
        <translation>Alles im Umkreis</translation>
    </message>
    <message>
        <source>Material of its own</source>
        <translation>Eigenes Material</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Takes effect at once, also while time runs. The rest of the part stays what it is.</source>
        <translation>Wirkt sofort, auch während die Zeit läuft. Der Rest des Teils bleibt, was er ist.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>A selection needs a name: type one, then save it.</source>
        <translation>Eine Auswahl braucht einen Namen: tippen Sie einen, und speichern Sie sie dann.</translation>
    </message>
</context>
<context>
    <name>Shortcuts</name>
    <message>
        <source>drives the selected tool</source>
        <translation>fährt das gewählte Werkzeug</translation>
    </message>
</context>
<context>
    <name>ShortcutsPage</name>
    <message>
        <source>No key</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>As it came</source>
        <translation>Wie anfangs</translation>
    </message>
    <message>
        <source>Search an action or a key</source>
        <translation>Befehl oder Taste suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Press the new key:</source>
        <translation>Neue Taste drücken:</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation>Anderswo</translation>
    </message>
    <message>
        <source>%1 %2: choose another key.</source>
        <translation>%1 %2: wählen Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>%1 already does &quot;%2&quot;.</source>
        <translation>%1 tut schon „%2“.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Von dort nehmen</translation>
    </message>
</context>
<context>
    <name>SimulationFeature</name>
    <message>
        <source>Slower tools</source>
        <translation>Langsamere Werkzeuge</translation>
    </message>
    <message>
        <source>More damping</source>
        <translation>Mehr Dämpfung</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Turn the section plane on (Shift+S) and put it where the cut shall be.</source>
        <translation>Schalten Sie die Schnittebene ein (Umschalt+S) und setzen Sie sie dorthin, wo geschnitten werden soll.</translation>
    </message>
    <message>
        <source>Fill finer</source>
        <translation>Feiner füllen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
</context>
<context>
    <name>SimulationPanel</name>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Earth</source>
        <translation>Erde</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Mond</translation>
    </message>
    <message>
        <source>Mars</source>
        <translation>Mars</translation>
    </message>
    <message>
        <source>Jupiter</source>
        <translation>Jupiter</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>1/%1 of real time</source>
        <translation>1/%1 der Echtzeit</translation>
    </message>
    <message>
        <source>%1 times real time</source>
        <translation>%1-fache Echtzeit</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>How fast simulated time runs when the machine keeps up: slow motion shows what is quick</source>
        <translation>Wie schnell simulierte Zeit läuft, wenn der Rechner mitkommt: Zeitlupe zeigt, was schnell geht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Simulated time of one step; the largest stable one with a margin</source>
        <translation>Simulierte Zeit eines Schritts; der größte stabile mit einem Spielraum</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Eigene Zahlen</translation>
    </message>
    <message>
        <source>As on</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>Entlang %1</translation>
    </message>
    <message>
        <source>Damping of all bodies</source>
        <translation>Dämpfung aller Körper</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Vorwärts-Euler</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Implizites Euler</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Keeps vibrations; stiff materials take small steps</source>
        <translation>Behält Schwingungen; steife Materialien brauchen kleine Schritte</translation>
    </message>
    <message>
        <source>As published; needs damping</source>
        <translation>Wie veröffentlicht; braucht Dämpfung</translation>
    </message>
    <message>
        <source>A step per frame for any stiffness; fast vibrations die out</source>
        <translation>Ein Schritt je Bild für jede Steifigkeit; schnelle Schwingungen klingen ab</translation>
    </message>
    <message>
        <source>Implicit where the semi-implicit scheme would be slower than real time</source>
        <translation>Implizit, wo das semi-implizite Verfahren langsamer als Echtzeit wäre</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Zeitschrittverfahren</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>How many threads compute; the results are the same bits with any number</source>
        <translation>Wie viele Threads rechnen; die Ergebnisse sind bei jeder Zahl bitgleich</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>different</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>%1 of all bodies</source>
        <translation>%1 aller Körper</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>In a contact it is the geometric mean with that of the material</source>
        <translation>In einem Kontakt gilt das geometrische Mittel mit der des Materials</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Tension that holds down what has touched the table; 0: nothing sticks to it</source>
        <translation>Zugspannung, mit der festgehalten wird, was den Tisch berührt hat; 0: nichts klebt daran</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>Gravity as on</source>
        <translation>Schwerkraft wie auf</translation>
    </message>
</context>
<context>
    <name>StatusReadings</name>
    <message>
        <source>Simulated time per wall time</source>
        <translation>Simulierte Zeit je echter Zeit</translation>
    </message>
    <message>
        <source>Frames the simulation delivers per second</source>
        <translation>Bilder, die die Simulation je Sekunde liefert</translation>
    </message>
    <message>
        <source>Time steps per frame</source>
        <translation>Zeitschritte je Bild</translation>
    </message>
    <message>
        <source>Spheres the bodies are made of</source>
        <translation>Kugeln, aus denen die Körper bestehen</translation>
    </message>
    <message>
        <source>Structural connections between objects</source>
        <translation>Strukturelle Verbindungen zwischen Objekten</translation>
    </message>
    <message>
        <source>Contact connections now</source>
        <translation>Kontaktverbindungen jetzt</translation>
    </message>
    <message>
        <source>Structural connections that broke so far</source>
        <translation>Strukturelle Verbindungen, die bisher brachen</translation>
    </message>
    <message>
        <source>Connected pieces of material</source>
        <translation>Zusammenhängende Stücke Material</translation>
    </message>
    <message>
        <source>Units of what is shown</source>
        <translation>Einheiten des Gezeigten</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>1 step/frame</source>
        <translation>1 Schritt/Bild</translation>
    </message>
    <message>
        <source>%1 steps/frame</source>
        <translation>%1 Schritte/Bild</translation>
    </message>
    <message>
        <source>Implicit</source>
        <translation>Implizit</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Explicit</source>
        <translation>Explizit</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 Objekte</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 Kontakte</translation>
    </message>
    <message>
        <source>%1 broken</source>
        <translation>%1 gebrochen</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 Stück</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 Stücke</translation>
    </message>
    <message>
        <source>%1x of %2x as chosen</source>
        <translation>%1x von gewählten %2x</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>30 steps a second to keep up</source>
        <translation>30 Schritte je Sekunde, um mitzuhalten</translation>
    </message>
    <message>
        <source>Rough steps to keep up</source>
        <translation>Grobe Schritte, um mitzuhalten</translation>
    </message>
    <message>
        <source>Forces are within 3 % of the largest. The Simulation panel says whether to keep up with real time or to be exact</source>
        <translation>Kräfte sind auf 3 % der größten genau. Im Bereich Simulation steht, ob mit der Echtzeit mitgehalten oder genau gerechnet wird</translation>
    </message>
</context>
<context>
    <name>TableKinds</name>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Parts slide on it, as on glass</source>
        <translation>Teile gleiten darauf, wie auf Glas</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Rau</translation>
    </message>
    <message>
        <source>Parts hardly slide, and are lifted off freely</source>
        <translation>Teile gleiten kaum und lassen sich frei abheben</translation>
    </message>
    <message>
        <source>Sticky</source>
        <translation>Klebrig</translation>
    </message>
    <message>
        <source>Parts stay where they are: it takes 20 kPa to lift them off</source>
        <translation>Teile bleiben, wo sie sind: Erst 20 kPa heben sie ab</translation>
    </message>
</context>
<context>
    <name>TaskReading</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>TaskRunner</name>
    <message>
        <source>%1: there is not enough memory. Close other programs, or choose a larger spacing.</source>
        <translation>%1: der Speicher reicht nicht. Schließen Sie andere Programme, oder wählen Sie einen größeren Abstand.</translation>
    </message>
</context>
<context>
    <name>TextFiles</name>
    <message>
        <source>%1 cannot be written (%2). Choose another folder, or make room on the disk.</source>
        <translation>%1 kann nicht geschrieben werden (%2). Wählen Sie einen anderen Ordner, oder schaffen Sie Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
</context>
<context>
    <name>TimelineAxis</name>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>... and %1 before</source>
        <translation>... und %1 davor</translation>
    </message>
    <message>
        <source>Filled anew</source>
        <translation>Neu gefüllt</translation>
    </message>
</context>
<context>
    <name>TimelinePanel</name>
    <message>
        <source>Look at the start</source>
        <translation>Zum Anfang sehen</translation>
    </message>
    <message>
        <source>One picture back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>Play what was simulated, from where you look</source>
        <translation>Abspielen, was simuliert wurde, von dort, wo Sie hinsehen</translation>
    </message>
    <message>
        <source>One picture on</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Look at the end</source>
        <translation>Zum Ende sehen</translation>
    </message>
    <message>
        <source>%1x</source>
        <translation>%1x</translation>
    </message>
    <message>
        <source>How fast it is played, in simulated per real time</source>
        <translation>Wie schnell abgespielt wird, simulierte je echter Zeit</translation>
    </message>
    <message>
        <source>Go on from what you see: a new branch of the history</source>
        <translation>Von dem aus weitermachen, was Sie sehen: ein neuer Zweig des Verlaufs</translation>
    </message>
    <message>
        <source>Branch here</source>
        <translation>Hier abzweigen</translation>
    </message>
    <message>
        <source>Back to the present (Esc)</source>
        <translation>Zurück zur Gegenwart (Esc)</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Looking back at %1   Esc: return</source>
        <translation>Rückblick auf %1   Esc: zurück</translation>
    </message>
    <message>
        <source>Play the film</source>
        <translation>Film abspielen</translation>
    </message>
    <message>
        <source>Simulate something first, and look back at it.</source>
        <translation>Simulieren Sie zuerst etwas, und sehen Sie darauf zurück.</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Geschwindigkeit des Films</translation>
    </message>
</context>
<context>
    <name>ToolPanel</name>
    <message>
        <source>Size X</source>
        <translation>Größe X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Größe Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Größe Z</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Schneide</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Largest so far</source>
        <translation>Größte bisher</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Ort %1</translation>
    </message>
    <message>
        <source>Size %1</source>
        <translation>Größe %1</translation>
    </message>
    <message>
        <source>Arrow keys and PgUp/PgDn drive at this speed; dragging is never faster</source>
        <translation>Pfeiltasten und Bild auf/ab fahren mit dieser Geschwindigkeit; Ziehen ist nie schneller</translation>
    </message>
    <message>
        <source>The tool stalls rather than push harder</source>
        <translation>Das Werkzeug bleibt stehen, statt stärker zu drücken</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Höchstkraft</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Remove tool</source>
        <translation>Werkzeug entfernen</translation>
    </message>
    <message>
        <source>Tension that holds what has touched the tool; 0: nothing sticks to it</source>
        <translation>Zugspannung, die festhält, was das Werkzeug berührt hat; 0: nichts klebt daran</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>Rolls freely</source>
        <translation>Rollt frei</translation>
    </message>
    <message>
        <source>The tool turns as it is moved over material, so that it does not rub it</source>
        <translation>Das Werkzeug dreht sich, wenn es über Material bewegt wird, und reibt so nicht daran</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Tour of the window</source>
        <translation>Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Open a part</source>
        <translation>Ein Teil öffnen</translation>
    </message>
    <message>
        <source>Drop a STEP, IGES or mesh file here, press Ctrl+O, or begin with an example. It is filled with material at once.</source>
        <translation>Legen Sie eine STEP-, IGES- oder Netzdatei hier ab, drücken Sie Strg+O, oder beginnen Sie mit einem Beispiel. Es wird sofort mit Material gefüllt.</translation>
    </message>
    <message>
        <source>What there is</source>
        <translation>Was es gibt</translation>
    </message>
    <message>
        <source>Parts, tools and fixtures are listed here. A click selects; the selected one shows in the view, too.</source>
        <translation>Teile, Werkzeuge und Einspannungen stehen hier. Ein Klick wählt; das Gewählte zeigt sich auch in der Ansicht.</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>Woraus es besteht</translation>
    </message>
    <message>
        <source>Choose a material or type its numbers, with any unit: 2 MPa, 0,5 mm, 1.2e3 kg/m³. It takes effect while time runs.</source>
        <translation>Wählen Sie ein Material oder tippen Sie seine Zahlen, in jeder Einheit: 2 MPa, 0,5 mm, 1.2e3 kg/m³. Es wirkt, während die Zeit läuft.</translation>
    </message>
    <message>
        <source>Hold, push, run</source>
        <translation>Halten, drücken, laufen lassen</translation>
    </message>
    <message>
        <source>X fixes faces that you click, B adds a block, Space runs time. Drag the block with the left button or drive it with the arrow keys; the middle button turns the view.</source>
        <translation>X fixiert Flächen, die Sie anklicken, B fügt einen Block hinzu, die Leertaste lässt die Zeit laufen. Ziehen Sie den Block mit der linken Taste oder fahren Sie ihn mit den Pfeiltasten; die mittlere Taste dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Back and forth in time</source>
        <translation>Vor und zurück in der Zeit</translation>
    </message>
    <message>
        <source>Drag along the timeline to look back. Ctrl+Z undoes whatever you did, what was simulated included.</source>
        <translation>Ziehen Sie entlang der Zeitleiste, um zurückzublicken. Strg+Z macht rückgängig, was immer Sie taten, auch was simuliert wurde.</translation>
    </message>
    <message>
        <source>Everything else</source>
        <translation>Alles Weitere</translation>
    </message>
    <message>
        <source>Ctrl+E exports the part as CAD again. Ctrl+K finds any command by a few letters, F1 opens the handbook, and the menu Help repeats this tour.</source>
        <translation>Strg+E exportiert das Teil wieder als CAD. Strg+K findet jeden Befehl an ein paar Buchstaben, F1 öffnet das Handbuch, und das Menü Hilfe wiederholt diesen Rundgang.</translation>
    </message>
</context>
<context>
    <name>ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>VORNE</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>RECHTS</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>HINTEN</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>LINKS</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>OBEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>UNTEN</translation>
    </message>
</context>
<context>
    <name>ViewName</name>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Double click: this view alone, and all of them again</source>
        <translation>Doppelklick: nur diese Ansicht, und wieder alle</translation>
    </message>
</context>
<context>
    <name>ViewsFeature</name>
    <message>
        <source>Open a part first.</source>
        <translation>Öffnen Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>Show two or four views first.</source>
        <translation>Zeigen Sie zuerst zwei oder vier Ansichten.</translation>
    </message>
</context>
<context>
    <name>WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Viewports</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Erscheinung</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Measure the part</source>
        <translation>Das Teil messen</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab.</translation>
    </message>
</context>
</TS>
