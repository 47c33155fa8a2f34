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
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>Neues Fens&amp;ter</translation>
    </message>
    <message>
        <source>Begin something else; what is open here stays</source>
        <translation>Etwas anderes beginnen; was hier offen ist, bleibt</translation>
    </message>
    <message>
        <source>First pa&amp;ge</source>
        <translation>Erste Se&amp;ite</translation>
    </message>
    <message>
        <source>Examples and files of late; the part that is open stays, and Esc comes back</source>
        <translation>Beispiele und letzte Dateien; das offene Teil bleibt, und Esc kehrt zurück</translation>
    </message>
    <message>
        <source>Add &amp;part...</source>
        <translation>Teil &amp;hinzufügen...</translation>
    </message>
    <message>
        <source>Save &amp;picture...</source>
        <translation>B&amp;ild speichern...</translation>
    </message>
    <message>
        <source>Write what the view shows as a picture of any size</source>
        <translation>Was die Ansicht zeigt, als Bild beliebiger Größe schreiben</translation>
    </message>
    <message>
        <source>Warnings in the view</source>
        <translation>Warnungen in der Ansicht</translation>
    </message>
    <message>
        <source>Mark where the part is folded over itself, got thin or is about to break</source>
        <translation>Markieren, wo das Teil über sich selbst gefaltet ist, dünn wurde oder gleich bricht</translation>
    </message>
    <message>
        <source>&amp;Tour on a block of clay</source>
        <translation>&amp;Rundgang an einem Block Ton</translation>
    </message>
    <message>
        <source>Press it, pull it, export it: in two minutes</source>
        <translation>Drücken, ziehen, exportieren: in zwei Minuten</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Back to the first page with nothing open; what is not saved is asked about</source>
        <translation>Zurück zur ersten Seite, ohne dass etwas offen ist; nach Ungespeichertem wird gefragt</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Mit Zahlen verformen</translation>
    </message>
    <message>
        <source>Bend, twist, taper, stretch, shear or scale the part by numbers between two planes</source>
        <translation>Das Teil zwischen zwei Ebenen mit Zahlen biegen, verdrehen, verjüngen, strecken, scheren oder skalieren</translation>
    </message>
    <message>
        <source>&amp;Deform by a field...</source>
        <translation>Mit einem Feld &amp;verformen...</translation>
    </message>
    <message>
        <source>Move the part by displacements that another program computed, or against them</source>
        <translation>Das Teil um Verschiebungen bewegen, die ein anderes Programm berechnet hat, oder gegen sie</translation>
    </message>
    <message>
        <source>Bend...</source>
        <translation>Biegen...</translation>
    </message>
    <message>
        <source>Bend the part into an arc by an angle or a radius</source>
        <translation>Das Teil um einen Winkel oder Radius zu einem Bogen biegen</translation>
    </message>
    <message>
        <source>Twist...</source>
        <translation>Verdrehen...</translation>
    </message>
    <message>
        <source>Twist the part about an axis by an angle</source>
        <translation>Das Teil um eine Achse um einen Winkel verdrehen</translation>
    </message>
    <message>
        <source>Taper...</source>
        <translation>Verjüngen...</translation>
    </message>
    <message>
        <source>Make the part thicker or thinner toward one end</source>
        <translation>Das Teil zu einem Ende hin dicker oder dünner machen</translation>
    </message>
    <message>
        <source>Stretch...</source>
        <translation>Strecken...</translation>
    </message>
    <message>
        <source>Make the part longer or shorter between two planes</source>
        <translation>Das Teil zwischen zwei Ebenen länger oder kürzer machen</translation>
    </message>
    <message>
        <source>Shear...</source>
        <translation>Scheren...</translation>
    </message>
    <message>
        <source>Move one end of the part sideways</source>
        <translation>Ein Ende des Teils seitwärts bewegen</translation>
    </message>
    <message>
        <source>Scale between planes...</source>
        <translation>Zwischen Ebenen skalieren...</translation>
    </message>
    <message>
        <source>Make one end of the part larger or smaller in all directions</source>
        <translation>Ein Ende des Teils in allen Richtungen größer oder kleiner machen</translation>
    </message>
    <message>
        <source>Appl&amp;y to another part...</source>
        <translation>Auf ein anderes Teil &amp;anwenden...</translation>
    </message>
    <message>
        <source>Do what was done here to another part, such as the next revision of this one</source>
        <translation>Mit einem anderen Teil, etwa der nächsten Revision von diesem, tun, was hier getan wurde</translation>
    </message>
    <message>
        <source>&amp;Python trace</source>
        <translation>&amp;Python-Mitschrift</translation>
    </message>
    <message>
        <source>Show what you do as a script for Python, as you do it</source>
        <translation>Zeigen, was Sie tun, als Skript für Python, während Sie es tun</translation>
    </message>
    <message>
        <source>Put the parts of other files beside those that are open, in the shape that these have now</source>
        <translation>Teile anderer Dateien neben die geöffneten legen, in der Form, die diese jetzt haben</translation>
    </message>
</context>
<context>
    <name>Availability</name>
    <message>
        <source>Open a part first.</source>
        <translation>Zuerst ein Teil öffnen.</translation>
    </message>
    <message>
        <source>Nothing in this part is closed, so nothing can be simulated.</source>
        <translation>Nichts in diesem Teil ist geschlossen, also kann nichts simuliert werden.</translation>
    </message>
</context>
<context>
    <name>Balance</name>
    <message>
        <source>Load step %1: %2</source>
        <translation>Lastschritt %1: %2</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Der Körper</translation>
    </message>
    <message>
        <source>A body is free to move: hold it, or let time run (dynamic) until it rests on something.</source>
        <translation>Ein Körper kann sich frei bewegen: festhalten oder die Zeit laufen lassen, bis er auf etwas ruht.</translation>
    </message>
    <message>
        <source>A load step takes more than 0 and up to 3600 s.</source>
        <translation>Ein Lastschritt dauert mehr als 0 und höchstens 3600 s.</translation>
    </message>
    <message>
        <source>%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).</source>
        <translation>%1 ist starr und kann sich frei bewegen: festhalten, verformbar machen oder die Zeit laufen lassen.</translation>
    </message>
    <message>
        <source>No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps or a smaller load, hold what is free to slide or turn, or let time run (dynamic).</source>
        <translation>Bei %1 s fand sich kein Gleichgewicht: Kräfte von %2 derer, die wirken, sind übrig. Mehr Lastschritte oder eine kleinere Last nehmen, festhalten, was gleiten oder sich drehen kann, oder die Zeit laufen lassen.</translation>
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
        <translation>Der Rückblick bewahrt dies nicht für Material, das geflossen ist oder gedrückt wird: zur Gegenwart zurückkehren, oder Verschiebung oder Dehnung wählen.</translation>
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
        <translation>Was ist zu tun?</translation>
    </message>
    <message>
        <source>Nothing is called like that: try fewer letters.</source>
        <translation>Nichts heißt so: es mit weniger Buchstaben versuchen.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Jetzt nicht möglich.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>One of the files has no closed part: there is nothing to compare.</source>
        <translation>Eine der Dateien hat kein geschlossenes Teil: Es gibt nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of the original belongs to no closed part of the other file.</source>
        <translation>Zu „%1“ des Originals gehört kein geschlossenes Teil der anderen Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to no closed part of the original.</source>
        <translation>„%1“ gehört zu keinem geschlossenen Teil des Originals.</translation>
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
    <message>
        <source>%1 beside %2</source>
        <translation>%1 neben %2</translation>
    </message>
    <message>
        <source>Written by Knead on %1.</source>
        <translation>Geschrieben von Knead am %1.</translation>
    </message>
    <message>
        <source>Distances are those of each surface from the nearest point of the other, the larger of both; the mean is by area.</source>
        <translation>Abstände sind die jeder Oberfläche vom nächsten Punkt der anderen, der größere von beiden; das Mittel ist nach Fläche gewichtet.</translation>
    </message>
</context>
<context>
    <name>Compensation</name>
    <message>
        <source>&quot;faces&quot; names face %1 of %2, which has %3; they are numbered from 0.</source>
        <translation>„faces“ nennt Fläche %1 von %2, das %3 hat; sie sind ab 0 nummeriert.</translation>
    </message>
    <message>
        <source>&quot;faces&quot; names %1, which is no part of the target; knead info shows their names.</source>
        <translation>„faces“ nennt %1, das kein Teil des Ziels ist; knead info zeigt deren Namen.</translation>
    </message>
    <message>
        <source>Points every %1 would be more than %2; choose a larger &quot;spacing_mm&quot;.</source>
        <translation>Punkte alle %1 wären mehr als %2; ein größeres „spacing_mm“ wählen.</translation>
    </message>
    <message>
        <source>The target has no surface; name another part.</source>
        <translation>Das Ziel hat keine Oberfläche; ein anderes Teil nennen.</translation>
    </message>
    <message>
        <source>What came out of round %1 has places that are no numbers; look at what its command wrote.</source>
        <translation>Was aus Runde %1 herauskam, hat Stellen, die keine Zahlen sind; ansehen, was ihr Befehl geschrieben hat.</translation>
    </message>
</context>
<context>
    <name>Curvature</name>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>konkav</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>konvex</translation>
    </message>
</context>
<context>
    <name>Cut</name>
    <message>
        <source>A cut needs a plane: a point, and a normal that is not zero.</source>
        <translation>Ein Schnitt braucht eine Ebene: einen Punkt und eine Normale, die nicht null ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is rigid, and is not cut. Make it deformable first.</source>
        <translation>„%1“ ist starr und wird nicht geschnitten. Zuerst verformbar machen.</translation>
    </message>
    <message>
        <source>The plane meets nothing of &quot;%1&quot; that could be cut.</source>
        <translation>Die Ebene trifft nichts von „%1“, das sich schneiden ließe.</translation>
    </message>
</context>
<context>
    <name>DeformFeature</name>
    <message>
        <source>Fields (%1)</source>
        <translation>Felder (%1)</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Come back to the present first: Esc.</source>
        <translation>Zuerst in die Gegenwart zurückkehren: Esc.</translation>
    </message>
    <message>
        <source>No part is selected: click one in the tree, or choose all parts.</source>
        <translation>Kein Teil ist ausgewählt: eines im Baum anklicken oder alle Teile wählen.</translation>
    </message>
    <message>
        <source>Deform by a field</source>
        <translation>Mit einem Feld verformen</translation>
    </message>
    <message>
        <source>Projects of Knead</source>
        <translation>Projekte von Knead</translation>
    </message>
    <message>
        <source>Scans of the part</source>
        <translation>Scans des Teils</translation>
    </message>
</context>
<context>
    <name>DeformPanel</name>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Parts are bent, twisted, tapered, stretched, sheared or scaled by numbers here, or by the displacements of another program: File &gt; Deform by a field.</source>
        <translation>Hier werden Teile mit Zahlen gebogen, verdreht, verjüngt, gestreckt, geschert oder skaliert, oder mit den Verschiebungen eines anderen Programms: Datei &gt; Mit einem Feld verformen.</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Mit Zahlen verformen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Esc: everything stays as it is</source>
        <translation>Esc: alles bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Enter in the view: the parts become what is shown</source>
        <translation>Enter in der Ansicht: die Teile werden, was gezeigt ist</translation>
    </message>
</context>
<context>
    <name>DeformStage</name>
    <message>
        <source>Something else was done while the parts were deformed, so they stay as they are. Apply the deformation again.</source>
        <translation>Während die Teile verformt wurden, geschah etwas anderes, darum bleiben sie, wie sie sind. Die Verformung nochmals anwenden.</translation>
    </message>
</context>
<context>
    <name>Deformation</name>
    <message>
        <source>The field has %1 nodes, but %2 displacements.</source>
        <translation>Das Feld hat %1 Knoten, aber %2 Verschiebungen.</translation>
    </message>
    <message>
        <source>Node %1 of the field has a number that is not finite, or far too large; leave that node out, or write the file again.</source>
        <translation>Knoten %1 des Feldes hat eine Zahl, die nicht endlich oder viel zu groß ist; lassen Sie den Knoten weg, oder schreiben Sie die Datei neu.</translation>
    </message>
    <message>
        <source>A bend of %1 mm radius would fold the material on its inner side, which reaches %2 mm from the neutral plane. The radius must be larger than that: take a smaller angle, planes farther apart, or a neutral plane nearer to the inner side.</source>
        <translation>Eine Biegung mit %1 mm Radius würde das Material an ihrer Innenseite falten, das bis %2 mm von der neutralen Ebene reicht. Der Radius muss größer sein: Nehmen Sie einen kleineren Winkel, weiter entfernte Ebenen oder eine neutrale Ebene näher an der Innenseite.</translation>
    </message>
    <message>
        <source>A direction of no length is none; give x, y, z, or three numbers.</source>
        <translation>Eine Richtung ohne Länge ist keine; x, y, z oder drei Zahlen angeben.</translation>
    </message>
    <message>
        <source>The side runs along the axis, but must lie across it; choose another one.</source>
        <translation>Die Seite verläuft entlang der Achse, muss aber quer zu ihr liegen; eine andere wählen.</translation>
    </message>
    <message>
        <source>Only a bend has a radius and a plane that keeps its length; leave them out.</source>
        <translation>Nur eine Biegung hat einen Radius und eine Ebene, die ihre Länge behält; beides weglassen.</translation>
    </message>
    <message>
        <source>The plane that keeps its length is given twice, by its place and by a k factor; leave one of them out.</source>
        <translation>Die Ebene, die ihre Länge behält, ist zweimal angegeben, durch ihren Ort und durch einen k-Faktor; eines davon weglassen.</translation>
    </message>
    <message>
        <source>A k factor is between 0, inside, and 1, outside.</source>
        <translation>Ein k-Faktor liegt zwischen 0, innen, und 1, außen.</translation>
    </message>
    <message>
        <source>Angle and radius say where the bend ends; leave out the second plane.</source>
        <translation>Winkel und Radius sagen, wo die Biegung endet; die zweite Ebene weglassen.</translation>
    </message>
    <message>
        <source>The radius of a bend must be larger than 0.</source>
        <translation>Der Radius einer Biegung muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Neutral plane</source>
        <translation>Neutrale Ebene</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngen</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scheren</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>%1 of %2 parts came back from being deformed; nothing was changed.</source>
        <translation>%1 von %2 Teilen kamen verformt zurück; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 takes %2; this is &quot;%3&quot;.</source>
        <translation>%1 erwartet %2; dies ist „%3“.</translation>
    </message>
    <message>
        <source>%1 says nothing about what stands before it; put it behind the deformation that it is for.</source>
        <translation>%1 sagt nichts über das, was davor steht; hinter die Verformung setzen, für die es gilt.</translation>
    </message>
    <message>
        <source>No folder could be made in %1; make room there and try again.</source>
        <translation>In %1 konnte kein Ordner angelegt werden; dort Platz schaffen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3, numbered from 0, and meshes have none.</source>
        <translation>„%1“ hat keine Fläche %2; es hat %3, ab 0 gezählt, und Netze haben keine.</translation>
    </message>
    <message>
        <source>Which part the faces %1 are of is not clear; put its name before them, as Lid:%1.</source>
        <translation>Zu welchem Teil die Flächen %1 gehören, ist nicht klar; seinen Namen davorsetzen, etwa Deckel:%1.</translation>
    </message>
    <message>
        <source>%1 parts that are deformed are called &quot;%2&quot;, not one; knead info --json lists the names and paths of all.</source>
        <translation>%1 Teile, die verformt werden, heißen „%2“, nicht eines; knead info --json nennt Namen und Pfade aller.</translation>
    </message>
    <message>
        <source>it has no surface to be deformed.</source>
        <translation>es hat keine Oberfläche, die sich verformen ließe.</translation>
    </message>
    <message>
        <source>There is no part or assembly &quot;%1&quot; in %2; knead info --json lists the names and paths of all.</source>
        <translation>Es gibt kein Teil und keine Baugruppe „%1“ in %2; knead info --json nennt Namen und Pfade aller.</translation>
    </message>
    <message>
        <source>The field has no nodes.</source>
        <translation>Das Feld hat keine Knoten.</translation>
    </message>
    <message>
        <source>The factor of a deformation is no number.</source>
        <translation>Der Faktor einer Verformung ist keine Zahl.</translation>
    </message>
    <message>
        <source>Faces that stay where they are need a distance over which the deformation fades.</source>
        <translation>Flächen, die bleiben, wo sie sind, brauchen einen Abstand, über den die Verformung ausläuft.</translation>
    </message>
    <message>
        <source>A face that stays where it is has a corner that is no place.</source>
        <translation>Eine Fläche, die bleibt, wo sie ist, hat eine Ecke, die kein Ort ist.</translation>
    </message>
    <message>
        <source>The axis of a deformation has a coordinate that is no number.</source>
        <translation>Die Achse einer Verformung hat eine Koordinate, die keine Zahl ist.</translation>
    </message>
    <message>
        <source>A deformation by number has a value that is no number.</source>
        <translation>Eine Verformung nach Zahlen hat einen Wert, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>The second plane of a deformation must lie behind the first one, along its axis.</source>
        <translation>Die zweite Ebene einer Verformung muss entlang ihrer Achse hinter der ersten liegen.</translation>
    </message>
    <message>
        <source>The side of a deformation must point across its axis.</source>
        <translation>Die Seite einer Verformung muss quer zu ihrer Achse zeigen.</translation>
    </message>
    <message>
        <source>A bend or a twist goes around ten times at most: take a smaller angle, or a larger radius.</source>
        <translation>Eine Biegung oder Verdrehung geht höchstens zehnmal herum: einen kleineren Winkel oder einen größeren Radius nehmen.</translation>
    </message>
    <message>
        <source>What stays of a deformation lies between its planes: from 0 at the first one to 1 at the second one.</source>
        <translation>Was bei einer Verformung bleibt, liegt zwischen ihren Ebenen: von 0 an der ersten bis 1 an der zweiten.</translation>
    </message>
    <message>
        <source>The factor of a deformation must be larger than 0.</source>
        <translation>Der Faktor einer Verformung muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>A gentle stretch cannot shorten to less than 0.47: the middle would fold. Take a larger factor, or do not ease it.</source>
        <translation>Eine sanfte Streckung kann nicht auf weniger als 0,47 verkürzen: die Mitte würde sich falten. Einen größeren Faktor nehmen oder sie nicht sanft beginnen lassen.</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Der Körper</translation>
    </message>
    <message>
        <source>Deforming by physics takes 0.01 to 3600 s.</source>
        <translation>Verformen durch Physik dauert 0,01 bis 3600 s.</translation>
    </message>
    <message>
        <source>%1 lies wholly beyond one of the planes, so that it would only be carried along. Put the planes where it is to be deformed.</source>
        <translation>%1 liegt ganz jenseits einer der Ebenen und würde nur mitgenommen. Die Ebenen dorthin setzen, wo verformt werden soll.</translation>
    </message>
    <message>
        <source>Nothing of %1 is free between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Nichts von %1 ist zwischen den Ebenen frei: Ebenen weiter auseinander setzen oder mit kleinerem Abstand füllen.</translation>
    </message>
    <message>
        <source>%1 does not reach both planes, so that grips cannot hold it on both sides. Put the planes where it is, or at its ends.</source>
        <translation>%1 reicht nicht bis zu beiden Ebenen, sodass Griffe es nicht auf beiden Seiten halten können. Die Ebenen dorthin setzen, wo es ist, oder an seine Enden.</translation>
    </message>
    <message>
        <source>Physics bends, twists, stretches and shears, which grips at the ends can do. &quot;%1&quot; changes the ends themselves: do it exactly.</source>
        <translation>Die Physik biegt, verdreht, streckt und schert, was Griffe an den Enden können. „%1“ ändert die Enden selbst: exakt ausführen.</translation>
    </message>
    <message>
        <source>There is no part that could be deformed.</source>
        <translation>Es gibt kein Teil, das verformt werden könnte.</translation>
    </message>
    <message>
        <source>%1 is rigid: physics deforms what can be deformed. Make it deformable first.</source>
        <translation>%1 ist starr: Die Physik verformt, was verformbar ist. Zuerst verformbar machen.</translation>
    </message>
    <message>
        <source>Less than two spacings of %1 lie between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Weniger als zwei Abstände von %1 liegen zwischen den Ebenen: Ebenen weiter auseinander setzen oder mit kleinerem Abstand füllen.</translation>
    </message>
    <message>
        <source>--physics does one bend, twist, stretch or shear at a time; give one of them, and for more write a recipe.</source>
        <translation>--physics macht eine Biegung, Verdrehung, Streckung oder Scherung auf einmal; eine davon angeben und für mehr ein Rezept schreiben.</translation>
    </message>
    <message>
        <source>--physics deforms one part or all of them; for some write a recipe.</source>
        <translation>--physics verformt ein Teil oder alle; für einige ein Rezept schreiben.</translation>
    </message>
    <message>
        <source>--physics needs to know what the part is made of: give --material, one of %1.</source>
        <translation>--physics muss wissen, woraus das Teil besteht: --material angeben, eines von %1.</translation>
    </message>
    <message>
        <source>There is no material &quot;%1&quot;; --material is one of %2.</source>
        <translation>Es gibt kein Material „%1“; --material ist eines von %2.</translation>
    </message>
    <message>
        <source>%1: the ending is none of %2; name the file after its format.</source>
        <translation>%1: Die Endung ist keine von %2; benennen Sie die Datei nach ihrem Format.</translation>
    </message>
    <message>
        <source>A part is filled with %1 objects at least.</source>
        <translation>Ein Teil wird mit mindestens %1 Objekten gefüllt.</translation>
    </message>
</context>
<context>
    <name>Deforming</name>
    <message>
        <source>Preview: %1</source>
        <translation>Vorschau: %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 lesen</translation>
    </message>
    <message>
        <source>Preview: deformed by %1</source>
        <translation>Vorschau: mit %1 verformt</translation>
    </message>
    <message>
        <source>The field turns material inside out near %1, %2, %3 mm. Take a smaller factor.</source>
        <translation>Das Feld stülpt Material bei %1, %2, %3 mm um. Einen kleineren Faktor nehmen.</translation>
    </message>
    <message>
        <source>Deformed by %1</source>
        <translation>Mit %1 verformt</translation>
    </message>
    <message>
        <source>Deformed by %1, times %2</source>
        <translation>Mit %1 verformt, mal %2</translation>
    </message>
    <message>
        <source>Deforming by %1</source>
        <translation>Mit %1 verformen</translation>
    </message>
    <message>
        <source>The second plane must lie behind the first one, along the axis.</source>
        <translation>Die zweite Ebene muss entlang der Achse hinter der ersten liegen.</translation>
    </message>
    <message>
        <source>Select a flat face first, whose normal is to be the axis.</source>
        <translation>Zuerst eine ebene Fläche auswählen, deren Normale die Achse sein soll.</translation>
    </message>
    <message>
        <source>The bend is tighter than the material allows, which would fold: at least a radius of %1, or at most %2 between these planes.</source>
        <translation>Die Biegung ist enger, als das Material erlaubt, das sich falten würde: mindestens ein Radius von %1, oder höchstens %2 zwischen diesen Ebenen.</translation>
    </message>
    <message>
        <source>Bent by %1</source>
        <translation>Um %1 gebogen</translation>
    </message>
    <message>
        <source>Twisted by %1</source>
        <translation>Um %1 verdreht</translation>
    </message>
    <message>
        <source>Tapered to %1</source>
        <translation>Auf %1 verjüngt</translation>
    </message>
    <message>
        <source>Stretched to %1</source>
        <translation>Auf %1 gestreckt</translation>
    </message>
    <message>
        <source>Sheared by %1</source>
        <translation>Um %1 geschert</translation>
    </message>
    <message>
        <source>Scaled to %1</source>
        <translation>Auf %1 skaliert</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Twisting</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Tapering</source>
        <translation>Verjüngen</translation>
    </message>
    <message>
        <source>Stretching</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Shearing</source>
        <translation>Scheren</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>%1 by physics</source>
        <translation>%1 durch Physik</translation>
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
        <translation>Zuerst die Haut nach einer Größe färben.</translation>
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
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Polished</source>
        <translation>Poliert</translation>
    </message>
    <message>
        <source>Zebra</source>
        <translation>Zebra</translation>
    </message>
    <message>
        <source>Faces have the colors of the part, in soft light</source>
        <translation>Flächen haben die Farben des Teils, in weichem Licht</translation>
    </message>
    <message>
        <source>All parts in one matt color: nothing but their shape is seen</source>
        <translation>Alle Teile in einer matten Farbe: man sieht nichts als ihre Form</translation>
    </message>
    <message>
        <source>Parts shine as polished metal does</source>
        <translation>Teile glänzen wie poliertes Metall</translation>
    </message>
    <message>
        <source>Parts mirror stripes, which break where faces do not join smoothly</source>
        <translation>Teile spiegeln Streifen, die brechen, wo Flächen nicht glatt ineinander übergehen</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>Chrom</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porzellan</translation>
    </message>
    <message>
        <source>Blue where parts are hollow, white where they are flat, orange where they bulge</source>
        <translation>Blau, wo Teile hohl sind, weiß, wo sie flach sind, orange, wo sie sich wölben</translation>
    </message>
    <message>
        <source>Parts are soft and shine through at their rims</source>
        <translation>Teile wirken weich und scheinen an ihren Rändern durch</translation>
    </message>
    <message>
        <source>All parts mirror a sky and the ground, which shows every dent</source>
        <translation>Alle Teile spiegeln Himmel und Boden, was jede Delle zeigt</translation>
    </message>
    <message>
        <source>All parts are white and glazed</source>
        <translation>Alle Teile sind weiß und glasiert</translation>
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
        <translation>Die Linie in der Ansicht ziehen: links das Original, rechts der jetzige Stand.</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Place of the section plane</source>
        <translation>Lage der Schnittebene</translation>
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
        <translation>„%1“ ist ein Netz ohne CAD-Flächen: es als STEP, IGES oder BREP öffnen, um Flächen zu fixieren.</translation>
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
        <translation>%1 hält keine Objekte: die Flächen sind kleiner als der Abstand. Einen feineren Abstand wählen und neu füllen.</translation>
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
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen, und dann zu %2 gehen.</translation>
    </message>
    <message>
        <source>Branching from %1</source>
        <translation>Abzweigen von %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then branch again.</source>
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen, und dann abzweigen.</translation>
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
        <translation>Etwas heißt schon „%1“: einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked in the model tree: unlock it there to change it.</source>
        <translation>„%1“ ist im Modellbaum gesperrt: es dort entsperren, um es zu ändern.</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Auswahl fixieren</translation>
    </message>
    <message>
        <source>The selection holds no objects: it is smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>Die Auswahl hält keine Objekte: sie ist kleiner als der Abstand. Einen feineren Abstand wählen und neu füllen.</translation>
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
        <translation>„%1“ benennt Kanten oder Verbindungen einer anderen Füllung: mit Rückgängig dorthin zurückgehen, oder sie noch einmal wählen und unter diesem Namen speichern.</translation>
    </message>
    <message>
        <source>There is not enough memory to go to %1. Close other programs and try again.</source>
        <translation>Der Speicher reicht nicht, um zu %1 zu gehen. Andere Programme schließen und es noch einmal versuchen.</translation>
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
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then deform again.</source>
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen, und dann noch einmal verformen.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add %1 and others</source>
        <translation>%1 und andere hinzufügen</translation>
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
    <name>Export</name>
    <message>
        <source>&quot;%1&quot; is cut into or cracked, but in one piece: it gapes by %2 mm.</source>
        <translation>„%1“ ist angeschnitten oder hat Risse, ist aber noch ein Stück: der Spalt ist %2 mm weit.</translation>
    </message>
    <message>
        <source>a cut or crack ends in it, whose sides are no faces of the part.</source>
        <translation>ein Schnitt oder Riss endet darin, dessen Seiten keine Flächen des Teils sind.</translation>
    </message>
    <message>
        <source>it was filled anew before: its fields are left out.</source>
        <translation>es wurde zuvor neu gefüllt: seine Felder sind weggelassen.</translation>
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
        <source>its cracks could not be made into surfaces: other pieces of it are written as one with it; objects in them: %1.</source>
        <translation>aus seinen Rissen ließen sich keine Flächen machen: andere Stücke davon werden mit ihm als eines geschrieben; Objekte darin: %1.</translation>
    </message>
    <message>
        <source>pieces too small for a shape of their own are written as part of it; objects in them: %1.</source>
        <translation>Stücke, die zu klein für eine eigene Form sind, werden als Teil davon geschrieben; Objekte darin: %1.</translation>
    </message>
    <message>
        <source>cracks end in it, and its skin spans them; connections broken there: %1.</source>
        <translation>Risse enden darin, und die Haut überspannt sie; dort gerissene Verbindungen: %1.</translation>
    </message>
    <message>
        <source>the part is torn; this is one of %1 pieces.</source>
        <translation>das Teil ist zerrissen; dies ist eines von %1 Stücken.</translation>
    </message>
    <message>
        <source>too few of its objects hang together to say how it is deformed: it is written in its shape at rest, moved as they have.</source>
        <translation>zu wenige seiner Objekte hängen zusammen, um zu sagen, wie es verformt ist: es wird in seiner Ruheform geschrieben, bewegt wie sie.</translation>
    </message>
    <message>
        <source>%1 of its faces could not be carried along: %2.</source>
        <translation>%1 seiner Flächen konnten nicht mitgeführt werden: %2.</translation>
    </message>
    <message>
        <source>its faces do not fit together any more as they are bent now.</source>
        <translation>so gebogen passen seine Flächen nicht mehr aneinander.</translation>
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
        <source>&quot;%1&quot;: face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off.</source>
        <translation>„%1“: Fläche %2 kommt der Haut nicht so nahe wie angestrebt, %3 mm; Fläche %4 liegt %5 mm daneben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off.</source>
        <translation>„%1“: %2 Flächen, %3, kommen der Haut nicht so nahe wie angestrebt, %4 mm; Fläche %5 liegt %6 mm daneben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would need %2 flat faces, more than CAD programs can work with; export it as a mesh.</source>
        <translation>„%1“ bräuchte %2 ebene Flächen, mehr als CAD-Programme verarbeiten; es als Netz exportieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an open mesh, which CAD files cannot hold; hide it, or export as a mesh.</source>
        <translation>„%1“ ist ein offenes Netz, das CAD-Dateien nicht aufnehmen; es ausblenden oder als Netz exportieren.</translation>
    </message>
    <message>
        <source>it came as a mesh, which has no smooth faces.</source>
        <translation>es kam als Netz, das keine glatten Flächen hat.</translation>
    </message>
    <message>
        <source>its faces could not be cut where the knife went.</source>
        <translation>seine Flächen ließen sich nicht dort schneiden, wo das Messer ging.</translation>
    </message>
    <message>
        <source>other programs may read it inside out, as it came back here.</source>
        <translation>andere Programme lesen es vielleicht von innen nach außen gekehrt, wie es hier zurückkam.</translation>
    </message>
    <message>
        <source>its faces were not found again as they were written.</source>
        <translation>seine Flächen wurden nicht so wiedergefunden, wie sie geschrieben wurden.</translation>
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
        <source>The exact shapes of the parts are not complete; import the file again.</source>
        <translation>Die exakten Formen der Teile sind nicht vollständig; die Datei noch einmal importieren.</translation>
    </message>
    <message>
        <source>its bent faces were not found again in the file when that was read back.</source>
        <translation>seine gebogenen Flächen fanden sich in der zurückgelesenen Datei nicht wieder.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are inside out.</source>
        <translation>aus der Datei zurückgelesen, sind seine gebogenen Flächen von innen nach außen gekehrt.</translation>
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
        <source>read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>aus der Datei zurückgelesen liegen seine flachen Flächen bis zu %1 mm neben der Haut, erlaubt sind %2 mm.</translation>
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
        <source>There is nothing to export.</source>
        <translation>Es gibt nichts zu exportieren.</translation>
    </message>
    <message>
        <source>The surface bounds no volume.</source>
        <translation>Die Oberfläche umschließt kein Volumen.</translation>
    </message>
    <message>
        <source>its surface passes through itself near %1; other programs may refuse that.</source>
        <translation>seine Oberfläche durchdringt sich selbst bei %1; andere Programme lehnen das vielleicht ab.</translation>
    </message>
    <message>
        <source>its material is folded over itself near %1</source>
        <translation>sein Material ist bei %1 über sich selbst gefaltet</translation>
    </message>
    <message>
        <source>%1, and so are its faces.</source>
        <translation>%1, und damit auch seine Flächen.</translation>
    </message>
    <message>
        <source>A CAD file cannot be written in %1; choose mm, cm, m, inch or ft.</source>
        <translation>Eine CAD-Datei kann nicht in %1 geschrieben werden; mm, cm, m, inch oder ft wählen.</translation>
    </message>
    <message>
        <source>The parts could not be put into STEP.</source>
        <translation>Die Teile ließen sich nicht nach STEP übertragen.</translation>
    </message>
    <message>
        <source>The STEP text could not be written.</source>
        <translation>Der STEP-Text konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The parts could not be put into IGES.</source>
        <translation>Die Teile ließen sich nicht nach IGES übertragen.</translation>
    </message>
    <message>
        <source>The IGES text could not be written.</source>
        <translation>Der IGES-Text konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The BREP text could not be written.</source>
        <translation>Der BREP-Text konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a GLB can hold; export fewer bodies, or .gltf.</source>
        <translation>die Oberfläche braucht mehr als die 4 GB, die eine GLB-Datei aufnehmen kann; weniger Körper exportieren, oder als .gltf.</translation>
    </message>
    <message>
        <source>the ending is none of %1; name the file after its format.</source>
        <translation>die Endung ist keine von %1; die Datei nach ihrem Format benennen.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; is not known; known are %2.</source>
        <translation>die Längeneinheit „%1“ ist nicht bekannt; bekannt sind %2.</translation>
    </message>
    <message>
        <source>the surface of &quot;%1&quot; leads to infinity; go back to where it was whole and export again.</source>
        <translation>die Oberfläche von „%1“ führt ins Unendliche; dahin zurückgehen, wo sie heil war, und noch einmal exportieren.</translation>
    </message>
    <message>
        <source>there is no surface to write.</source>
        <translation>es gibt keine Oberfläche, die geschrieben werden könnte.</translation>
    </message>
    <message>
        <source>the surface has more than 2147483647 points or triangles, which the formats cannot count; export fewer bodies.</source>
        <translation>die Oberfläche hat mehr als 2147483647 Punkte oder Dreiecke, die die Formate nicht zählen können; weniger Körper exportieren.</translation>
    </message>
    <message>
        <source>3MF does not know the length unit %1; choose one of um, mm, cm, inch, ft and m.</source>
        <translation>3MF kennt die Längeneinheit %1 nicht; um, mm, cm, inch, ft oder m wählen.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a 3MF can hold; export fewer bodies.</source>
        <translation>die Oberfläche braucht mehr als die 4 GB, die eine 3MF-Datei aufnehmen kann; weniger Körper exportieren.</translation>
    </message>
    <message>
        <source>its border cannot be drawn in its parameters</source>
        <translation>ihr Rand lässt sich in ihren Parametern nicht zeichnen</translation>
    </message>
    <message>
        <source>its border does not close in its parameters</source>
        <translation>ihr Rand schließt sich in ihren Parametern nicht</translation>
    </message>
    <message>
        <source>its border is too short to be divided</source>
        <translation>ihr Rand ist zu kurz, um geteilt zu werden</translation>
    </message>
    <message>
        <source>a face cannot be drawn: %1</source>
        <translation>eine Fläche lässt sich nicht zeichnen: %1</translation>
    </message>
    <message>
        <source>an edge does not end</source>
        <translation>eine Kante endet nicht</translation>
    </message>
    <message>
        <source>two of its edges are too short to be told apart</source>
        <translation>zwei ihrer Kanten sind zu kurz, um unterschieden zu werden</translation>
    </message>
    <message>
        <source>two of its points lie on each other</source>
        <translation>zwei ihrer Punkte liegen aufeinander</translation>
    </message>
    <message>
        <source>a triangle in its place has no width</source>
        <translation>ein Dreieck an ihrer Stelle hat keine Breite</translation>
    </message>
    <message>
        <source>too many triangles would be needed</source>
        <translation>es wären zu viele Dreiecke nötig</translation>
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
        <source>The picture cannot be compressed: %1.</source>
        <translation>Das Bild lässt sich nicht komprimieren: %1.</translation>
    </message>
    <message>
        <source>there is no surface to draw.</source>
        <translation>es gibt keine Oberfläche, die gezeichnet werden könnte.</translation>
    </message>
    <message>
        <source>the picture must have from 1 to %1 pixels on each side.</source>
        <translation>das Bild muss auf jeder Seite 1 bis %1 Pixel haben.</translation>
    </message>
    <message>
        <source>the directions of view and of up must not be zero.</source>
        <translation>die Richtungen des Blicks und von oben dürfen nicht null sein.</translation>
    </message>
    <message>
        <source>the export asks for more memory than there is; export fewer parts at a time.</source>
        <translation>der Export verlangt mehr Speicher, als es gibt; weniger Teile auf einmal exportieren.</translation>
    </message>
    <message>
        <source>smooth faces go into .step, .iges and .brep files only.</source>
        <translation>glatte Flächen gehen nur in Dateien .step, .iges und .brep.</translation>
    </message>
    <message>
        <source>Nothing was written; export fewer parts at a time, or with a larger tolerance.</source>
        <translation>Nichts wurde geschrieben; weniger Teile auf einmal exportieren, oder mit einer größeren Toleranz.</translation>
    </message>
    <message>
        <source>Nothing was written; export the parts one by one to see which one it is, or as a mesh.</source>
        <translation>Nichts wurde geschrieben; die Teile einzeln exportieren, um zu sehen, welches es ist, oder als Netz.</translation>
    </message>
    <message>
        <source>What to write could not be handed over; try again.</source>
        <translation>Was zu schreiben war, konnte nicht übergeben werden; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>there is nothing to export.</source>
        <translation>es gibt nichts zu exportieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at the planes of the deformation; each is one surface across them.</source>
        <translation>„%1“: Seine Flächen ließen sich an den Ebenen der Verformung nicht teilen; jede ist dort eine einzige Fläche über sie hinweg.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at one of the planes of the deformation; each is one surface across it.</source>
        <translation>„%1“: Seine Flächen ließen sich an einer der Ebenen der Verformung nicht teilen; jede ist dort eine einzige Fläche über sie hinweg.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: 1 face was divided at the planes of the deformation.</source>
        <translation>„%1“: 1 Fläche wurde an den Ebenen der Verformung geteilt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces were divided at the planes of the deformation.</source>
        <translation>„%1“: %2 Flächen wurden an den Ebenen der Verformung geteilt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: it was carried by all deformations in one step, across the planes of single ones.</source>
        <translation>„%1“: Alle Verformungen wurden in einem Schritt ausgeführt, über die Ebenen einzelner hinweg.</translation>
    </message>
    <message>
        <source>not all names of its faces were found again.</source>
        <translation>nicht alle Namen seiner Flächen wurden wiedergefunden.</translation>
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
    <message>
        <source>The shape that the parts have now is not sound everywhere; the export report says where. Undo goes back to the parts as they were.</source>
        <translation>Die Form, die die Teile jetzt haben, ist nicht überall einwandfrei; der Exportbericht sagt, wo. Rückgängig führt zu den Teilen zurück, wie sie waren.</translation>
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
    <message>
        <source>The part is sound.</source>
        <translation>Das Teil ist einwandfrei.</translation>
    </message>
    <message>
        <source>The part is not sound.</source>
        <translation>Das Teil ist nicht einwandfrei.</translation>
    </message>
    <message>
        <source>One of %1 parts is not sound.</source>
        <translation>Eines von %1 Teilen ist nicht einwandfrei.</translation>
    </message>
    <message>
        <source>Exported parts</source>
        <translation>Exportierte Teile</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>on face %1, at %2</source>
        <translation>auf Fläche %1, bei %2</translation>
    </message>
    <message>
        <source>The nodes of the field span %1 mm, the parts %2 mm: the numbers seem to be %3. Choose &quot;%4&quot; as the unit of the field.</source>
        <translation>Die Knoten des Feldes umspannen %1 mm, die Teile %2 mm: die Zahlen scheinen %3 zu sein. Wählen Sie „%4“ als Einheit des Feldes.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but lies elsewhere: its middle is at %1, theirs at %2. Move the parts there, or write the field where they are.</source>
        <translation>Das Feld hat die Größe der Teile, liegt aber woanders: seine Mitte ist bei %1, ihre bei %2. Bewegen Sie die Teile dorthin, oder schreiben Sie das Feld, wo sie sind.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but is turned: it spans %1 mm, they span %2 mm. Turn the parts, or write the field with the axes that they have.</source>
        <translation>Das Feld hat die Größe der Teile, ist aber gedreht: es umspannt %1 mm, sie umspannen %2 mm. Drehen Sie die Teile, oder schreiben Sie das Feld mit ihren Achsen.</translation>
    </message>
    <message>
        <source>The field is not of these parts: %1 % of their surface lies far from all of its nodes, at most %2 mm (%3). The field spans %4 mm, the parts %5 mm.</source>
        <translation>Das Feld gehört nicht zu diesen Teilen: %1 % ihrer Oberfläche liegt weit von allen seinen Knoten, höchstens %2 mm (%3). Das Feld umspannt %4 mm, die Teile %5 mm.</translation>
    </message>
    <message>
        <source>%1 % of the surface has no nodes of the field near it; there the field is continued. The farthest place lies %2 mm from a node, %3.</source>
        <translation>%1 % der Oberfläche hat keine Knoten des Feldes in der Nähe; dort wird das Feld fortgesetzt. Der fernste Ort liegt %2 mm von einem Knoten, %3.</translation>
    </message>
    <message>
        <source>The field folds the material %1: its volume there would be %2 times what it was. Take a smaller factor, or keep faces there as they are.</source>
        <translation>Das Feld faltet das Material %1: sein Volumen wäre dort das %2-Fache von vorher. Nehmen Sie einen kleineren Faktor, oder lassen Sie Flächen dort, wie sie sind.</translation>
    </message>
    <message>
        <source>%1 % of the nodes move otherwise than those beside them, most at %2, by %3 mm: two sides of a slit, or noise. A smooth field passes between them.</source>
        <translation>%1 % der Knoten bewegen sich anders als die neben ihnen, am meisten bei %2, um %3 mm: zwei Seiten eines Schlitzes, oder Rauschen. Ein glattes Feld geht zwischen ihnen durch.</translation>
    </message>
    <message>
        <source>The scan was moved by (%1, %2, %3) mm and turned by %4 degrees, so that it lies on the part.</source>
        <translation>Der Scan wurde um (%1, %2, %3) mm verschoben und um %4 Grad gedreht, sodass er auf dem Teil liegt.</translation>
    </message>
    <message>
        <source>At %1 of %2 points of the part the scan says nothing to go by, as where it has a hole; the field is continued there. The farthest lies %3 mm from the scan, at %4.</source>
        <translation>An %1 von %2 Punkten des Teils sagt der Scan nichts Brauchbares, etwa wo er ein Loch hat; dort wird das Feld fortgesetzt. Der fernste liegt %3 mm vom Scan, bei %4.</translation>
    </message>
    <message>
        <source>The scan or the part has no triangles.</source>
        <translation>Der Scan oder das Teil hat keine Dreiecke.</translation>
    </message>
    <message>
        <source>The scan has a corner that is no place.</source>
        <translation>Der Scan hat eine Ecke, die kein Ort ist.</translation>
    </message>
    <message>
        <source>The triangles of the scan have no area.</source>
        <translation>Die Dreiecke des Scans haben keinen Flächeninhalt.</translation>
    </message>
    <message>
        <source>The scan does not lie on the part: only %1 % of it does, however it is turned. Look at its unit, or lay it on the part and say that it stays in place.</source>
        <translation>Der Scan liegt nicht auf dem Teil: nur %1 % von ihm, wie man ihn auch dreht. Prüfen Sie seine Einheit, oder legen Sie ihn auf das Teil und sagen Sie, dass er dort bleibt.</translation>
    </message>
    <message>
        <source>CalculiX results</source>
        <translation>CalculiX-Ergebnisse</translation>
    </message>
    <message>
        <source>VTK</source>
        <translation>VTK</translation>
    </message>
    <message>
        <source>Gmsh</source>
        <translation>Gmsh</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Abaqus report</source>
        <translation>Abaqus-Bericht</translation>
    </message>
    <message>
        <source>Abaqus or CalculiX input</source>
        <translation>Eingabe für Abaqus oder CalculiX</translation>
    </message>
    <message>
        <source>The cracks of &quot;%1&quot; could not be made into surfaces: values at nodes beside them may be those of the other side.</source>
        <translation>Aus den Rissen von „%1“ ließen sich keine Flächen machen: Werte an Knoten daneben können die der anderen Seite sein.</translation>
    </message>
    <message>
        <source>%1 of %2 nodes lie outside of all bodies and have no values; the farthest is %3 away, at (%4, %5, %6). Check the unit of the mesh, and whether its nodes lie in the parts as they were opened or as they are now.</source>
        <translation>%1 von %2 Knoten liegen außerhalb aller Körper und haben keine Werte; der fernste ist %3 entfernt, bei (%4, %5, %6). Prüfen Sie die Einheit des Netzes, und ob seine Knoten in den Teilen liegen, wie sie geöffnet wurden oder wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>it has %1 time steps, there is no number %2; choose another one.</source>
        <translation>sie hat %1 Zeitschritte, einen mit der Nummer %2 gibt es nicht; einen anderen wählen.</translation>
    </message>
    <message>
        <source>it has no vectors at nodes; write the displacements of the nodes into it, too.</source>
        <translation>sie hat keine Vektoren an Knoten; die Verschiebungen der Knoten mit hineinschreiben.</translation>
    </message>
    <message>
        <source>it has no vectors called %1 at its nodes; it has %2.</source>
        <translation>sie hat keine Vektoren namens %1 an ihren Knoten; sie hat %2.</translation>
    </message>
    <message>
        <source>several vectors could be the displacements: %1; say which.</source>
        <translation>mehrere Vektoren könnten die Verschiebungen sein: %1; sagen, welche.</translation>
    </message>
    <message>
        <source>%1 has %2 values for %3 nodes; write the file again with the program it comes from.</source>
        <translation>%1 hat %2 Werte für %3 Knoten; die Datei mit dem Programm, von dem sie kommt, noch einmal schreiben.</translation>
    </message>
    <message>
        <source>an element has node %1, which is missing; write the file again.</source>
        <translation>ein Element hat den Knoten %1, der fehlt; die Datei noch einmal schreiben.</translation>
    </message>
    <message>
        <source>the file is damaged; write it again with the program it comes from.</source>
        <translation>die Datei ist beschädigt; sie mit dem Programm, von dem sie kommt, noch einmal schreiben.</translation>
    </message>
    <message>
        <source>this is no file of displacements; they are read from %1 files.</source>
        <translation>das ist keine Datei mit Verschiebungen; sie werden aus %1-Dateien gelesen.</translation>
    </message>
    <message>
        <source>it has no nodes; write the results with the mesh.</source>
        <translation>sie hat keine Knoten; die Ergebnisse mit dem Netz schreiben.</translation>
    </message>
    <message>
        <source>The file has %1 time steps; the last one was read (%2).</source>
        <translation>Die Datei hat %1 Zeitschritte; der letzte wurde gelesen (%2).</translation>
    </message>
    <message>
        <source>no node in it has a displacement; write the displacements into it, too.</source>
        <translation>kein Knoten darin hat eine Verschiebung; die Verschiebungen mit hineinschreiben.</translation>
    </message>
    <message>
        <source>%1 has another number of values than there are nodes; nothing was written.</source>
        <translation>%1 hat eine andere Zahl von Werten, als es Knoten gibt; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>fields at nodes are written to .vtu and .csv files.</source>
        <translation>Felder an Knoten werden in .vtu- und .csv-Dateien geschrieben.</translation>
    </message>
    <message>
        <source>it is a Gmsh file of version %1, which is not read; save it in version 4.1 or 2.2.</source>
        <translation>sie ist eine Gmsh-Datei der Version %1, die nicht gelesen wird; sie in Version 4.1 oder 2.2 speichern.</translation>
    </message>
    <message>
        <source>its bytes are in the order of another kind of computer; save it as text (ASCII).</source>
        <translation>ihre Bytes stehen in der Reihenfolge einer anderen Art von Rechner; sie als Text (ASCII) speichern.</translation>
    </message>
    <message>
        <source>it has elements of Gmsh&apos;s type %1, which is not known; leave them out.</source>
        <translation>sie hat Elemente vom Gmsh-Typ %1, der nicht bekannt ist; sie weglassen.</translation>
    </message>
    <message>
        <source>its nodes stand in other files that it includes; give the file with *NODE.</source>
        <translation>ihre Knoten stehen in anderen Dateien, die sie einbindet; die Datei mit *NODE angeben.</translation>
    </message>
    <message>
        <source>it has no nodes; a mesh has them behind *NODE.</source>
        <translation>sie hat keine Knoten; ein Netz hat sie hinter *NODE.</translation>
    </message>
    <message>
        <source>%1 elements are of kinds that are not read and were left out.</source>
        <translation>%1 Elemente sind von Arten, die nicht gelesen werden, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>this is an input of Abaqus or CalculiX, without displacements; give the results (.frd).</source>
        <translation>das ist eine Eingabe für Abaqus oder CalculiX ohne Verschiebungen; die Ergebnisse (.frd) angeben.</translation>
    </message>
    <message>
        <source>%1 of %2 nodes have no displacement and were left out.</source>
        <translation>%1 von %2 Knoten haben keine Verschiebung und wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 nodes lie where another one does; each such place has the mean of their displacements.</source>
        <translation>%1 Knoten liegen, wo schon ein anderer liegt; jeder solche Ort hat das Mittel ihrer Verschiebungen.</translation>
    </message>
    <message>
        <source>the collection names no files.</source>
        <translation>die Sammlung nennt keine Dateien.</translation>
    </message>
    <message>
        <source>the report has no coordinates; write COORD of the nodes into it beside U.</source>
        <translation>der Bericht hat keine Koordinaten; COORD der Knoten neben U hineinschreiben.</translation>
    </message>
    <message>
        <source>the report has no table with values of nodes.</source>
        <translation>der Bericht hat keine Tabelle mit Werten von Knoten.</translation>
    </message>
    <message>
        <source>%1 lines hold no numbers where they should and were left out.</source>
        <translation>%1 Zeilen haben keine Zahlen, wo welche stehen sollten, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>there are no lines of numbers in it; a table has a line per node with X, Y, Z, DX, DY, DZ.</source>
        <translation>es sind keine Zeilen mit Zahlen darin; eine Tabelle hat eine Zeile je Knoten mit X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>it cannot be told what its %1 columns are; name them in the first line: X, Y, Z, DX, DY, DZ.</source>
        <translation>was ihre %1 Spalten sind, ist nicht zu erkennen; sie in der ersten Zeile nennen: X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at line %1; write it again with the program it comes from.</source>
        <translation>die Datei ist in Zeile %1 beschädigt oder abgeschnitten; sie mit dem Programm, von dem sie kommt, noch einmal schreiben.</translation>
    </message>
    <message>
        <source>it holds texts as bytes, which are not read; save it as text (ASCII).</source>
        <translation>sie enthält Texte als Bytes, die nicht gelesen werden; sie als Text (ASCII) speichern.</translation>
    </message>
    <message>
        <source>this VTK file is of the kind %1, which is not read; save it as an unstructured grid (.vtu).</source>
        <translation>diese VTK-Datei ist von der Art %1, die nicht gelesen wird; sie als unstrukturiertes Gitter (.vtu) speichern.</translation>
    </message>
    <message>
        <source>its numbers are compressed by %1, which is not read; save it with zlib or without compression.</source>
        <translation>ihre Zahlen sind mit %1 gepackt, was nicht gelesen wird; sie mit zlib oder ungepackt speichern.</translation>
    </message>
    <message>
        <source>the file asks for more memory than there is; write fewer steps and values into it.</source>
        <translation>die Datei verlangt mehr Speicher, als da ist; weniger Schritte und Werte hineinschreiben.</translation>
    </message>
    <message>
        <source>Nothing was read; the file is damaged or far too large.</source>
        <translation>Es wurde nichts gelesen; die Datei ist beschädigt oder viel zu groß.</translation>
    </message>
    <message>
        <source>Nothing was read; write the file again, best as .vtu.</source>
        <translation>Es wurde nichts gelesen; die Datei noch einmal schreiben, am besten als .vtu.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was read; try again.</source>
        <translation>das Ergebnis des Lesers ist beschädigt (%1). Es wurde nichts gelesen; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Values at nodes need a mesh and a file to write: give --nodes and the output.</source>
        <translation>Werte an Knoten brauchen ein Netz und eine Datei zum Schreiben: Geben Sie --nodes und die Ausgabe an.</translation>
    </message>
    <message>
        <source>There is no field &quot;%1&quot;; known are %2.</source>
        <translation>Es gibt kein Feld „%1“; bekannt sind %2.</translation>
    </message>
    <message>
        <source>values at nodes are written to .vtu, .csv and .inp files.</source>
        <translation>Werte an Knoten werden in Dateien .vtu, .csv und .inp geschrieben.</translation>
    </message>
    <message>
        <source>no node lies in the bodies.</source>
        <translation>Kein Knoten liegt in den Körpern.</translation>
    </message>
    <message>
        <source>there is nothing to write: the mesh has no solid elements for stress, and no displaced nodes were asked for.</source>
        <translation>Es gibt nichts zu schreiben: Das Netz hat keine Volumenelemente für Spannung, und verschobene Knoten wurden nicht verlangt.</translation>
    </message>
    <message>
        <source>The coordinates are those in the report; where Abaqus computed with large displacements they are the moved ones: take those of the first frame then.</source>
        <translation>Die Koordinaten sind die des Berichts; hat Abaqus mit großen Verschiebungen gerechnet, sind es die verschobenen: dann die des ersten Frames nehmen.</translation>
    </message>
    <message>
        <source>a node has a coordinate that is no number, or far too large; write the file again.</source>
        <translation>ein Knoten hat eine Koordinate, die keine Zahl oder viel zu groß ist; die Datei noch einmal schreiben.</translation>
    </message>
    <message>
        <source>the collection names %1, which is no ordinary file in its folder; put the file beside the collection and open that again.</source>
        <translation>die Sammlung nennt %1, das keine gewöhnliche Datei in ihrem Ordner ist; die Datei neben die Sammlung legen und diese noch einmal öffnen.</translation>
    </message>
</context>
<context>
    <name>FieldPage</name>
    <message>
        <source>Choose faces</source>
        <translation>Flächen wählen</translation>
    </message>
    <message>
        <source>Keep none</source>
        <translation>Keine behalten</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Nothing moves along this axis</source>
        <translation>Entlang dieser Achse bewegt sich nichts</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Faces that stay</source>
        <translation>Flächen, die bleiben</translation>
    </message>
    <message>
        <source>Fades within</source>
        <translation>Klingt ab auf</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>Zum Ansehen</translation>
    </message>
    <message>
        <source>Exaggerated</source>
        <translation>Überhöht</translation>
    </message>
    <message>
        <source>Largest way</source>
        <translation>Größter Weg</translation>
    </message>
    <message>
        <source>Click faces in the view that are to stay exactly where they are, then press this again</source>
        <translation>In der Ansicht Flächen anklicken, die genau bleiben sollen, wo sie sind, dann dies nochmals drücken</translation>
    </message>
    <message>
        <source>Of the displacements; -1 goes the other way, as one compensates</source>
        <translation>Der Verschiebungen; -1 geht in die andere Richtung, wie man kompensiert</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>nach dem Teil</translation>
    </message>
    <message>
        <source>From the faces that stay to where the whole field holds</source>
        <translation>Von den Flächen, die bleiben, bis dorthin, wo das ganze Feld gilt</translation>
    </message>
    <message>
        <source>Only of what is seen before it is applied</source>
        <translation>Nur dessen, was man vor dem Anwenden sieht</translation>
    </message>
    <message>
        <source>Of lengths in the file</source>
        <translation>Der Längen in der Datei</translation>
    </message>
    <message>
        <source>%1: %2, %3 nodes</source>
        <translation>%1: %2, %3 Knoten</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Lies where the part does</source>
        <translation>Liegt, wo das Teil liegt</translation>
    </message>
    <message>
        <source>Else the scan is laid over the part as a rigid thing first</source>
        <translation>Sonst wird der Scan erst als starres Ding auf das Teil gelegt</translation>
    </message>
</context>
<context>
    <name>File</name>
    <message>
        <source>the file cannot be written (%1); choose another place or make room.</source>
        <translation>die Datei kann nicht geschrieben werden (%1); einen anderen Ort wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>%1: no such file.</source>
        <translation>%1: eine solche Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>%1: this is a folder; name a file.</source>
        <translation>%1: das ist ein Ordner; eine Datei nennen.</translation>
    </message>
    <message>
        <source>%1: the file cannot be read; check its permissions.</source>
        <translation>%1: die Datei kann nicht gelesen werden; ihre Rechte prüfen.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files; set TMPDIR to one you may write to.</source>
        <translation>Es gibt keinen Ordner für temporäre Dateien; TMPDIR auf einen setzen, in den geschrieben werden darf.</translation>
    </message>
    <message>
        <source>%1: no temporary file can be made there (%2).</source>
        <translation>%1: dort lässt sich keine temporäre Datei anlegen (%2).</translation>
    </message>
    <message>
        <source>The folder for temporary files takes no more; make room there, or set TMPDIR to another folder (%1).</source>
        <translation>Der Ordner für temporäre Dateien nimmt nichts mehr auf; dort Platz schaffen oder TMPDIR auf einen anderen setzen (%1).</translation>
    </message>
    <message>
        <source>%1: the folder for temporary files takes no more (%2); make room there, or set TMPDIR to another folder.</source>
        <translation>%1: der Ordner für temporäre Dateien nimmt nichts mehr auf (%2); dort Platz schaffen oder TMPDIR auf einen anderen setzen.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Name another one with --csv.</source>
        <translation>Eine andere mit --csv nennen.</translation>
    </message>
    <message>
        <source>Name another one with --probes.</source>
        <translation>Eine andere mit --probes nennen.</translation>
    </message>
    <message>
        <source>No file can be made in memory (%1).</source>
        <translation>Im Speicher lässt sich keine Datei anlegen (%1).</translation>
    </message>
    <message>
        <source>the standard output takes no more; write into a file with --output.</source>
        <translation>die Standardausgabe nimmt nichts mehr an; mit --output in eine Datei schreiben.</translation>
    </message>
</context>
<context>
    <name>Filling</name>
    <message>
        <source>A spacing of %1 needs more than %2 objects. Choose a larger spacing.</source>
        <translation>Ein Abstand von %1 braucht mehr als %2 Objekte. Einen größeren Abstand wählen.</translation>
    </message>
    <message>
        <source>The part has no triangles, so there is nothing to fill. Import a part with a surface.</source>
        <translation>Das Teil hat keine Dreiecke, also ist nichts zu füllen. Ein Teil mit einer Oberfläche importieren.</translation>
    </message>
    <message>
        <source>A vertex of the surface is not at a finite place. Repair the file and import again.</source>
        <translation>Ein Eckpunkt der Oberfläche liegt an keinem endlichen Ort. Die Datei reparieren und erneut importieren.</translation>
    </message>
    <message>
        <source>The surface is not closed: %1 edges of triangles have no partner. Close the gaps and import again.</source>
        <translation>Die Oberfläche ist nicht geschlossen: %1 Kanten von Dreiecken haben keinen Partner. Die Lücken schließen und erneut importieren.</translation>
    </message>
    <message>
        <source>A spacing of %1 cannot be used. Enter a length above 0.</source>
        <translation>Ein Abstand von %1 ist nicht verwendbar. Eine Länge über 0 eingeben.</translation>
    </message>
    <message>
        <source>The surface does not bound a volume: its holes are too large to tell inside from outside. Close them and import again.</source>
        <translation>Die Oberfläche begrenzt kein Volumen: ihre Löcher sind zu groß, um innen von außen zu unterscheiden. Die Löcher schließen und erneut importieren.</translation>
    </message>
    <message>
        <source>The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing.</source>
        <translation>Das Teil ist zu dünn für einen Abstand von %1: keine Zelle enthält genug Material. Einen kleineren Abstand wählen.</translation>
    </message>
    <message>
        <source>The surface is not closed. Close it and try again.</source>
        <translation>Die Oberfläche ist nicht geschlossen. Die Lücken schließen und es erneut versuchen.</translation>
    </message>
    <message>
        <source>The spacing must be greater than 0.</source>
        <translation>Der Abstand muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>The spacing is too small for a part of this size. Choose a larger one.</source>
        <translation>Der Abstand ist zu klein für ein Teil dieser Größe. Einen größeren wählen.</translation>
    </message>
    <message>
        <source>No sphere has its center inside the part. Choose a smaller spacing.</source>
        <translation>Keine Kugel hat ihren Mittelpunkt im Teil. Einen kleineren Abstand wählen.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out many times too stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.</source>
        <translation>Dünnste Wände: %1 Zellen auf %2; solche Wände biegen sich um ein Vielfaches zu steif. Ein Abstand von %3 gibt %4 Zellen, etwa %5 Objekte.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. Fill with a spacing of %4 for %5 cells, about %6 objects.</source>
        <translation>Dünnste Wände: %1 Zellen auf %2; solche Wände biegen sich bis zu %3 % zu steif. Ein Abstand von %4 gibt %5 Zellen, etwa %6 Objekte.</translation>
    </message>
    <message>
        <source>A point of the surface is nowhere.</source>
        <translation>Ein Punkt der Oberfläche liegt nirgends.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface, so it is not shown.</source>
        <translation>„%1“ hat keine Oberfläche und wird deshalb nicht gezeigt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a closed solid: it is shown, and not simulated. Close its surfaces and import it again.</source>
        <translation>„%1“ ist kein geschlossener Körper: es wird gezeigt und nicht simuliert. Seine Flächen schließen und es erneut importieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>„%1“ wird nicht simuliert: %2</translation>
    </message>
    <message>
        <source>%1: the file holds no solid and no surface; export the part as a solid.</source>
        <translation>%1: die Datei enthält keinen Körper und keine Oberfläche; das Teil als Körper exportieren.</translation>
    </message>
    <message>
        <source>%1: no closed body found. Close the surfaces in the CAD program and export again.</source>
        <translation>%1: kein geschlossener Körper gefunden. Die Flächen im CAD-Programm schließen und erneut exportieren.</translation>
    </message>
    <message>
        <source>The spacing of another filling must be more than 0.</source>
        <translation>Der Abstand einer anderen Füllung muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface that it could be filled from.</source>
        <translation>„%1“ hat keine Oberfläche, aus der es gefüllt werden könnte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is arranged as published, which filling anew does not know.</source>
        <translation>„%1“ ist wie veröffentlicht angeordnet, was das Neufüllen nicht kennt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deformable, and keeps its shape.</source>
        <translation>„%1“ ist nicht verformbar und behält seine Form.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is elastic: it keeps its shape at rest, and is not filled anew. Let it yield, or re-normalize it.</source>
        <translation>„%1“ ist elastisch: es behält seine Ruheform und wird nicht neu gefüllt. Es fließen lassen oder renormieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks, which another filling would blur: only what heals is filled anew with them.</source>
        <translation>„%1“ hat Risse, die eine andere Füllung verwischen würde: nur was heilt, wird mit ihnen neu gefüllt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; came apart after its skin was drawn out far: pieces of such a body are not filled anew.</source>
        <translation>„%1“ zerfiel, nachdem seine Haut weit ausgezogen worden war: Stücke eines solchen Körpers werden nicht neu gefüllt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks that gape, which another filling would close.</source>
        <translation>„%1“ hat klaffende Risse, die eine andere Füllung schließen würde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a load on a box, which says nothing of its present shape. Put it on faces.</source>
        <translation>„%1“ hat eine Last auf einem Quader, der nichts über die jetzige Form sagt. Die Last auf Flächen setzen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moves out of all bounds.</source>
        <translation>„%1“ bewegt sich über alle Grenzen hinaus.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is still being pushed out of a tool that was put into it.</source>
        <translation>„%1“ wird noch aus einem Werkzeug hinausgedrückt, das hineingesetzt wurde.</translation>
    </message>
    <message>
        <source>its cracks gape, and would be filled.</source>
        <translation>seine Risse klaffen und würden gefüllt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be filled anew: %2</source>
        <translation>„%1“ konnte nicht neu gefüllt werden: %2</translation>
    </message>
    <message>
        <source>cracks touch the surface without crossing it</source>
        <translation>Risse berühren die Oberfläche, ohne sie zu kreuzen</translation>
    </message>
    <message>
        <source>what of it has grown together could not be followed back to what was opened.</source>
        <translation>was davon zusammengewachsen ist, ließ sich nicht zu dem zurückverfolgen, was geöffnet wurde.</translation>
    </message>
    <message>
        <source>its cracks could not be made surfaces.</source>
        <translation>seine Risse ließen sich nicht zu Flächen machen.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>In %1 ist kein Platz mehr. Platz schaffen, oder weniger oder kleinere Bilder aufnehmen.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 gibt es schon. Einen anderen Namen für den Ordner der Bilder wählen.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>In %1 kann kein Ordner angelegt werden: %2. Einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2). Choose another name for the folder of pictures.</source>
        <translation>%1 kann nicht angelegt werden (%2). Einen anderen Namen für den Ordner der Bilder wählen.</translation>
    </message>
</context>
<context>
    <name>Fixture</name>
    <message>
        <source>Fixture &quot;%1&quot; names a body that does not exist.</source>
        <translation>Die Einspannung „%1“ nennt einen Körper, den es nicht gibt.</translation>
    </message>
    <message>
        <source>There is no fixture number %1.</source>
        <translation>Es gibt keine Einspannung Nummer %1.</translation>
    </message>
    <message>
        <source>A fixture must not move faster than 100 m/s.</source>
        <translation>Eine Einspannung darf sich nicht schneller als 100 m/s bewegen.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must turn about a place, by more than 0, and no faster than 10000 rad/s.</source>
        <translation>Die Einspannung „%1“ muss sich um einen Ort drehen, um mehr als 0 und nicht schneller als 10000 rad/s.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must not move faster than 100 m/s.</source>
        <translation>Die Einspannung „%1“ darf sich nicht schneller als 100 m/s bewegen.</translation>
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
        <translation>Ein Werkzeug hinzufügen und die Leertaste drücken: hier erscheinen Kräfte über der Zeit.</translation>
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
        <translation>Das Fenster braucht OpenGL 3.2 oder neuer zum Zeichnen, und hier gibt es %1. Den Treiber der Grafikkarte installieren oder erneuern, oder Mesa (libgl1-mesa-dri), das ohne solche Karte zeichnet. Die Befehle, die knead --help aufzählt, brauchen kein Fenster.</translation>
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
    <message>
        <source>Hold the rest</source>
        <translation>Den Rest festhalten</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of what a brush takes or presses; also with [ and ]</source>
        <translation>Von dem, was ein Pinsel fasst oder drückt; auch mit [ und ]</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Of the force that suits the material; also with Shift and the mouse wheel</source>
        <translation>Als Vielfaches der Kraft, die zum Material passt; auch mit Umschalt und Mausrad</translation>
    </message>
    <message>
        <source>What is far from the brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Was fern vom Pinsel liegt, wird wie mit der anderen Hand gehalten, wo sonst nichts das Teil hält</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>nach dem Teil</translation>
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
    <message>
        <source>Thumb</source>
        <translation>Daumen</translation>
    </message>
    <message>
        <source>Press and hold: a ball goes in until its force limit holds it; draw it along for a groove</source>
        <translation>Drücken und halten: Eine Kugel dringt ein, bis ihre Kraftgrenze sie hält; für eine Rille weiterziehen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Roll a large ball over the surface, which levels what stands out</source>
        <translation>Eine große Kugel über die Oberfläche rollen, die einebnet, was vorsteht</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Abflachen</translation>
    </message>
    <message>
        <source>Press a disc down to the plane that the surface has where you begin</source>
        <translation>Eine Scheibe bis auf die Ebene drücken, in der die Oberfläche am Anfangspunkt liegt</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Zusammenkneifen</translation>
    </message>
    <message>
        <source>Draw material together with four fingers, as for a ridge</source>
        <translation>Material mit vier Fingern zusammenziehen, wie für einen Grat</translation>
    </message>
    <message>
        <source>Smear</source>
        <translation>Verschmieren</translation>
    </message>
    <message>
        <source>Take the surface along with a ball that grips it</source>
        <translation>Die Oberfläche mit einer Kugel mitnehmen, die an ihr haftet</translation>
    </message>
    <message>
        <source>Bend here</source>
        <translation>Hier biegen</translation>
    </message>
    <message>
        <source>Tilt the material at the cursor towards where you draw</source>
        <translation>Das Material am Mauszeiger dorthin neigen, wohin gezogen wird</translation>
    </message>
    <message>
        <source>Twist here</source>
        <translation>Hier verdrehen</translation>
    </message>
    <message>
        <source>Turn the material at the cursor about its normal: draw to the right or left</source>
        <translation>Das Material am Mauszeiger um seine Normale drehen: nach rechts oder links ziehen</translation>
    </message>
    <message>
        <source>Symmetric in X</source>
        <translation>Symmetrisch in X</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along X</source>
        <translation>Pinsel tun dasselbe auf der anderen Seite der Mitte, entlang X</translation>
    </message>
    <message>
        <source>Symmetric in Y</source>
        <translation>Symmetrisch in Y</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Y</source>
        <translation>Pinsel tun dasselbe auf der anderen Seite der Mitte, entlang Y</translation>
    </message>
    <message>
        <source>Symmetric in Z</source>
        <translation>Symmetrisch in Z</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Z</source>
        <translation>Pinsel tun dasselbe auf der anderen Seite der Mitte, entlang Z</translation>
    </message>
    <message>
        <source>Weaker brush</source>
        <translation>Schwächerer Pinsel</translation>
    </message>
    <message>
        <source>Also with Shift and the mouse wheel</source>
        <translation>Auch mit Umschalt und Mausrad</translation>
    </message>
    <message>
        <source>Stronger brush</source>
        <translation>Stärkerer Pinsel</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Modellieren</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Modellieren</translation>
    </message>
    <message>
        <source>Press on the part and draw   [ ]: radius   Shift+wheel: force   Esc: done</source>
        <translation>Auf das Teil drücken und ziehen   [ ]: Radius   Umschalt+Rad: Kraft   Esc: fertig</translation>
    </message>
    <message>
        <source>Hold the rest</source>
        <translation>Den Rest festhalten</translation>
    </message>
    <message>
        <source>What is far from a brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Was fern vom Pinsel liegt, wird wie mit der anderen Hand gehalten, wo sonst nichts das Teil hält</translation>
    </message>
    <message>
        <source>Forces of brushes, too</source>
        <translation>Auch Kräfte der Pinsel</translation>
    </message>
    <message>
        <source>Fingers and grips of brushes have lines in the plot and columns in the table, too</source>
        <translation>Auch Finger und Griffe der Pinsel haben Linien im Diagramm und Spalten in der Tabelle</translation>
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
        <translation>Noch gibt es keine Kräfte zu schreiben: Starten drücken und etwas geschehen lassen.</translation>
    </message>
    <message>
        <source>Select a tool or a fixture first.</source>
        <translation>Zuerst ein Werkzeug oder eine Einspannung wählen.</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>Put a tool above the part to push it with</source>
        <translation>Ein Werkzeug über das Teil setzen, um es damit zu drücken</translation>
    </message>
</context>
<context>
    <name>HelpFeature</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isometric, top, front, right; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;clicks select parts, faces, edges, objects; Ctrl adds&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;one, two, four views; V: the active view alone&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linke Taste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;wählen; ein Werkzeug ziehen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drehen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;schieben&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Rad&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zum Zeiger zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pfeile, Bild auf, Bild ab&lt;/b&gt;&lt;/td&gt;&lt;td&gt;das gewählte Werkzeug fahren; mit Umschalt langsamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Leertaste, . , Rücktaste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;starten oder anhalten, ein Schritt, zurücksetzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Entf&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Block hinzufügen, Flächen fixieren, entfernen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Schwerkraft, renormieren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Objekte, Körper verbergen, Kanten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isometrisch, oben, vorne, rechts; Strg: von der anderen Seite&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Klicks wählen Teile, Flächen, Kanten, Objekte; Strg fügt hinzu&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspektivisch oder parallel, einpassen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Projekt speichern; Strg+Umschalt+S unter anderem Namen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Umschalt+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;eine, zwei, vier Ansichten; V: nur die aktive&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;jeden Befehl finden; F11: Vollbild&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;abbrechen&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
</context>
<context>
    <name>History</name>
    <message>
        <source>a number of an object is none</source>
        <translation>eine Zahl eines Objekts ist keine</translation>
    </message>
    <message>
        <source>a filling has no lattice</source>
        <translation>eine Füllung hat kein Gitter</translation>
    </message>
    <message>
        <source>a connection of a filling leads nowhere</source>
        <translation>eine Verbindung einer Füllung führt nirgendwohin</translation>
    </message>
    <message>
        <source>a filling is not as it can be</source>
        <translation>eine Füllung ist so, wie sie nicht sein kann</translation>
    </message>
    <message>
        <source>a former shape has too many before it</source>
        <translation>einer früheren Form gehen zu viele voraus</translation>
    </message>
    <message>
        <source>a former shape has no carriers</source>
        <translation>eine frühere Form hat keine Träger</translation>
    </message>
    <message>
        <source>a former shape is none</source>
        <translation>eine frühere Form ist keine</translation>
    </message>
    <message>
        <source>a former shape was parted where it could not be</source>
        <translation>eine frühere Form wurde geteilt, wo es nicht sein kann</translation>
    </message>
    <message>
        <source>it ends early</source>
        <translation>die Daten enden zu früh</translation>
    </message>
    <message>
        <source>a yes or no is neither</source>
        <translation>ein Ja oder Nein ist keins von beiden</translation>
    </message>
    <message>
        <source>a choice is none of those there are</source>
        <translation>eine Auswahl ist keine von denen, die es gibt</translation>
    </message>
    <message>
        <source>The history has no entries.</source>
        <translation>Der Verlauf hat keine Einträge.</translation>
    </message>
    <message>
        <source>The history is damaged: its entry %1 follows one that comes later.</source>
        <translation>Der Verlauf ist beschädigt: sein Eintrag %1 folgt auf einen, der später kommt.</translation>
    </message>
    <message>
        <source>The history is damaged: it is at an entry that it does not have.</source>
        <translation>Der Verlauf ist beschädigt: er steht bei einem Eintrag, den er nicht hat.</translation>
    </message>
    <message>
        <source>Repeating what was done came to another state than it did then, as it does with another version of Knead. Go to an entry that is kept.</source>
        <translation>Zu wiederholen, was getan wurde, führte zu einem anderen Zustand als damals, wie es mit einer anderen Version von Knead geschieht. Zu einem Eintrag gehen, der aufbewahrt ist.</translation>
    </message>
    <message>
        <source>The project has no history: nothing was done in it yet that could be repeated.</source>
        <translation>Das Projekt hat keinen Verlauf: darin wurde noch nichts getan, das sich wiederholen ließe.</translation>
    </message>
    <message>
        <source>The history is damaged: an entry begins with a start that is not there.</source>
        <translation>Der Verlauf ist beschädigt: ein Eintrag beginnt mit einem Anfang, der nicht da ist.</translation>
    </message>
    <message>
        <source>The entry before it was not reached.</source>
        <translation>Der Eintrag davor wurde nicht erreicht.</translation>
    </message>
    <message>
        <source>it does not begin as one</source>
        <translation>er beginnt nicht wie einer</translation>
    </message>
    <message>
        <source>it was written by another version of Knead</source>
        <translation>eine andere Version von Knead hat ihn geschrieben</translation>
    </message>
    <message>
        <source>its bytes are not those that were written</source>
        <translation>seine Bytes sind nicht die, die geschrieben wurden</translation>
    </message>
    <message>
        <source>This moment of the history cannot be read: %1. Go to an earlier one and repeat from there.</source>
        <translation>Dieser Moment des Verlaufs ist nicht lesbar: %1. Zu einem früheren gehen und von dort wiederholen.</translation>
    </message>
    <message>
        <source>it has another number of bodies than the scene</source>
        <translation>er hat eine andere Zahl von Körpern als die Szene</translation>
    </message>
    <message>
        <source>a tool cannot be simulated</source>
        <translation>ein Werkzeug lässt sich nicht simulieren</translation>
    </message>
    <message>
        <source>a fixture cannot be simulated</source>
        <translation>eine Einspannung lässt sich nicht simulieren</translation>
    </message>
    <message>
        <source>a load cannot be simulated</source>
        <translation>eine Last lässt sich nicht simulieren</translation>
    </message>
    <message>
        <source>a re-normalization under way is out of range</source>
        <translation>eine laufende Renormierung liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>a contact or joint is out of range</source>
        <translation>ein Kontakt oder eine Verklebung liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>eine Zahl liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>a material is out of range</source>
        <translation>ein Material liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>objects are not where they can be</source>
        <translation>Objekte sind, wo sie nicht sein können</translation>
    </message>
    <message>
        <source>a mass is out of range</source>
        <translation>eine Masse liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>connections are not as they can be</source>
        <translation>Verbindungen sind so, wie sie nicht sein können</translation>
    </message>
    <message>
        <source>it goes on after its end</source>
        <translation>die Daten gehen nach ihrem Ende weiter</translation>
    </message>
    <message>
        <source>a tool is made of a part that the document does not have</source>
        <translation>ein Werkzeug besteht aus einem Teil, das das Dokument nicht hat</translation>
    </message>
    <message>
        <source>a motion is none of those there are</source>
        <translation>eine Bewegung ist keine von denen, die es gibt</translation>
    </message>
    <message>
        <source>The recording does not belong to this scene: it goes on at step %1, and the run is at step %2. Start from the scene it was made with.</source>
        <translation>Die Aufzeichnung gehört nicht zu dieser Szene: sie geht bei Schritt %1 weiter, und der Lauf ist bei Schritt %2. Mit der Szene beginnen, mit der sie entstand.</translation>
    </message>
    <message>
        <source>The moment belongs to other bodies than these. Nothing was changed.</source>
        <translation>Der Moment gehört zu anderen Körpern als diesen. Nichts wurde geändert.</translation>
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
    <message>
        <source>Memory of the history</source>
        <translation>Speicher des Verlaufs</translation>
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
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Try it: press a thumb into clay</source>
        <translation>Ausprobieren: einen Daumen in Ton drücken</translation>
    </message>
    <message>
        <source>A block of clay opens. Hold the left button on it; then pull it, and export it. Two minutes.</source>
        <translation>Ein Block Ton öffnet sich. Die linke Taste darauf halten; dann ziehen und exportieren. Zwei Minuten.</translation>
    </message>
</context>
<context>
    <name>Iges</name>
    <message>
        <source>line %1 of the IGES file is not in 80 columns; the file is damaged, get it again.</source>
        <translation>Zeile %1 der IGES-Datei steht nicht in 80 Spalten; die Datei ist beschädigt, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the IGES file ends before its last line (T); it is cut off, get it again.</source>
        <translation>die IGES-Datei endet vor ihrer letzten Zeile (T); sie ist abgeschnitten, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the IGES file lacks lines of its section %1; it is damaged, get it again.</source>
        <translation>der IGES-Datei fehlen Zeilen ihres Abschnitts %1; sie ist beschädigt, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>a text in the IGES file claims to be %1 letters long, more than there are; the file is damaged.</source>
        <translation>ein Text in der IGES-Datei will %1 Zeichen lang sein, mehr als es gibt; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>the IGES file has &quot;%1&quot; in place of a number; it is damaged, export it again.</source>
        <translation>in der IGES-Datei steht „%1“ an der Stelle einer Zahl; sie ist beschädigt, noch einmal exportieren.</translation>
    </message>
    <message>
        <source>an entity of type %1 in the IGES file claims %2 values and has %3; the file is damaged.</source>
        <translation>ein Element vom Typ %1 in der IGES-Datei gibt %2 Werte an und hat %3; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>line %1 of section D of the IGES file has another number; lines are lost, get the file again.</source>
        <translation>Zeile %1 im Abschnitt D der IGES-Datei hat eine andere Nummer; Zeilen sind verloren, die Datei noch einmal besorgen.</translation>
    </message>
    <message>
        <source>has its values twice</source>
        <translation>hat seine Werte zweimal</translation>
    </message>
    <message>
        <source>is of another type where its values are</source>
        <translation>ist dort, wo seine Werte stehen, von anderem Typ</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file holds itself, or the entities are nested more than %2 deep; export it again.</source>
        <translation>Element %1 der IGES-Datei enthält sich selbst, oder die Elemente sind mehr als %2-fach verschachtelt; noch einmal exportieren.</translation>
    </message>
    <message>
        <source>refers to one without values</source>
        <translation>verweist auf eines ohne Werte</translation>
    </message>
    <message>
        <source>refers to a vertex or edge that is not there</source>
        <translation>verweist auf einen Eckpunkt oder eine Kante, die es nicht gibt</translation>
    </message>
    <message>
        <source>has %1 values where %2 are needed</source>
        <translation>hat %1 Werte, wo %2 nötig sind</translation>
    </message>
    <message>
        <source>states an impossible count</source>
        <translation>nennt eine unmögliche Anzahl</translation>
    </message>
    <message>
        <source>refers to something of the wrong kind or nothing at all</source>
        <translation>verweist auf etwas Falsches oder auf nichts</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file (type %2) %3; the file is damaged, export it again.</source>
        <translation>Element %1 der IGES-Datei (Typ %2) %3; die Datei ist beschädigt, noch einmal exportieren.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>the file asks for more memory than there is; it is damaged or far too detailed.</source>
        <translation>die Datei verlangt mehr Speicher, als es gibt; sie ist beschädigt oder viel zu ausführlich.</translation>
    </message>
    <message>
        <source>the CAD reader gave up (%1); the file is damaged, export it again.</source>
        <translation>der CAD-Leser gab auf (%1); die Datei ist beschädigt, noch einmal exportieren.</translation>
    </message>
    <message>
        <source>the assembly is nested more than %1 levels deep; export a part of it.</source>
        <translation>die Baugruppe ist mehr als %1 Ebenen tief verschachtelt; einen Teil davon exportieren.</translation>
    </message>
    <message>
        <source>the assembly has more than %1 parts; export the parts you need.</source>
        <translation>die Baugruppe hat mehr als %1 Teile; nur die benötigten Teile exportieren.</translation>
    </message>
    <message>
        <source>%1: the file mixes the length units %2 and %3; check the sizes of the parts.</source>
        <translation>%1: die Datei mischt die Längeneinheiten %2 und %3; die Größen der Teile prüfen.</translation>
    </message>
    <message>
        <source>%1: its schema &quot;%2&quot; is none for CAD parts; check that nothing is missing.</source>
        <translation>%1: sein Schema „%2“ ist keines für CAD-Teile; prüfen, dass nichts fehlt.</translation>
    </message>
    <message>
        <source>the STEP text has errors that the reader cannot get over; export the file again.</source>
        <translation>der STEP-Text hat Fehler, über die der Leser nicht hinwegkommt; die Datei noch einmal exportieren.</translation>
    </message>
    <message>
        <source>an assembly in the file holds itself; export the file again, or its parts one by one.</source>
        <translation>eine Baugruppe in der Datei enthält sich selbst; die Datei noch einmal exportieren, oder ihre Teile einzeln.</translation>
    </message>
    <message>
        <source>the assembly unfolds to more than %1 parts; export the parts you need.</source>
        <translation>die Baugruppe entfaltet sich zu mehr als %1 Teilen; nur die benötigten Teile exportieren.</translation>
    </message>
    <message>
        <source>no shape of the STEP file could be made; export the file again.</source>
        <translation>aus der STEP-Datei ließ sich keine Form machen; die Datei noch einmal exportieren.</translation>
    </message>
    <message>
        <source>the IGES text has errors that the reader cannot get over; export the file again, best as STEP.</source>
        <translation>der IGES-Text hat Fehler, über die der Leser nicht hinwegkommt; die Datei noch einmal exportieren, am besten als STEP.</translation>
    </message>
    <message>
        <source>no shape of the IGES file could be made; export the file again, best as STEP.</source>
        <translation>aus der IGES-Datei ließ sich keine Form machen; die Datei noch einmal exportieren, am besten als STEP.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged; get it again.</source>
        <translation>die BREP-Datei ist abgeschnitten oder beschädigt; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the BREP file is damaged, or newer than the reader; save it again in an older version.</source>
        <translation>die BREP-Datei ist beschädigt oder neuer als der Leser; noch einmal in einer älteren Version speichern.</translation>
    </message>
    <message>
        <source>The solid was inside out and has been turned.</source>
        <translation>Der Körper war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>was inside out and has been turned.</source>
        <translation>war umgestülpt und wurde gewendet.</translation>
    </message>
    <message>
        <source>has faces that do not meet well: its volume is uncertain by %1.</source>
        <translation>hat Flächen, die nicht gut zusammentreffen: sein Volumen ist um %1 unsicher.</translation>
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
        <source>does not pass the geometry checks; look at it closely before you trust it.</source>
        <translation>besteht die Prüfungen der Geometrie nicht; vor dem Gebrauch genau ansehen.</translation>
    </message>
    <message>
        <source>has gaps of up to %1, a hundredth of its size or more.</source>
        <translation>hat Spalte bis zu %1, ein Hundertstel seiner Größe oder mehr.</translation>
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
        <source>there is no part or assembly &quot;%1&quot; in it; knead info --json lists the paths of all parts.</source>
        <translation>darin gibt es kein Teil und keine Baugruppe „%1“; knead info --json nennt die Pfade aller Teile.</translation>
    </message>
    <message>
        <source>it has no finite size: numbers in it are damaged, or its edges are smaller than 0.1 um and lost; check the length unit</source>
        <translation>es hat keine endliche Größe: Zahlen darin sind beschädigt, oder seine Kanten sind kleiner als 0.1 um und verloren; die Längeneinheit prüfen</translation>
    </message>
    <message>
        <source>it reaches farther than 100 km from the origin; check the length unit and the position</source>
        <translation>es reicht weiter als 100 km vom Ursprung; Längeneinheit und Lage prüfen</translation>
    </message>
    <message>
        <source>its faces lead far away from their edges: numbers in it are damaged</source>
        <translation>seine Flächen führen weit von ihren Kanten weg: Zahlen darin sind beschädigt</translation>
    </message>
    <message>
        <source>it is smaller than a micrometre; check the length unit</source>
        <translation>es ist kleiner als ein Mikrometer; die Längeneinheit prüfen</translation>
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
        <source>&quot;%1&quot; was left out: %2.</source>
        <translation>„%1“ wurde weggelassen: %2.</translation>
    </message>
    <message>
        <source>the file holds no solid and no surface; export the part as a solid.</source>
        <translation>die Datei enthält keinen Körper und keine Fläche; das Teil als Körper exportieren.</translation>
    </message>
    <message>
        <source>%1 Of %2 parts like that none is left.</source>
        <translation>%1 Von %2 solchen Teilen ist keines übrig.</translation>
    </message>
    <message>
        <source>this version of BREP is unknown (&quot;%1&quot;); save the file in an older version.</source>
        <translation>diese Version von BREP ist unbekannt („%1“); die Datei in einer älteren Version speichern.</translation>
    </message>
    <message>
        <source>the BREP file states an impossible number of %1; it is damaged, get it again.</source>
        <translation>die BREP-Datei nennt eine unmögliche Anzahl für %1; sie ist beschädigt, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged: sections are missing; get it again.</source>
        <translation>die BREP-Datei ist abgeschnitten oder beschädigt: Abschnitte fehlen; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the file cannot be opened; check that you may read it.</source>
        <translation>die Datei lässt sich nicht öffnen; die Leserechte prüfen.</translation>
    </message>
    <message>
        <source>the file cannot be read; the disk or the connection to it failed.</source>
        <translation>die Datei kann nicht gelesen werden; die Platte oder die Verbindung zu ihr versagte.</translation>
    </message>
    <message>
        <source>the file does not exist.</source>
        <translation>die Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>the file cannot be opened (%1).</source>
        <translation>die Datei lässt sich nicht öffnen (%1).</translation>
    </message>
    <message>
        <source>this is a folder, not a file.</source>
        <translation>das ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>this is not an ordinary file.</source>
        <translation>das ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>die Datei ist leer.</translation>
    </message>
    <message>
        <source>this is a JSON text, but no glTF (&quot;asset&quot; is missing in it); export the part as STEP.</source>
        <translation>das ist ein JSON-Text, aber kein glTF („asset“ fehlt darin); das Teil als STEP exportieren.</translation>
    </message>
    <message>
        <source>this is a text, but none of %1; export the part as STEP.</source>
        <translation>das ist ein Text, aber nichts von %1; das Teil als STEP exportieren.</translation>
    </message>
    <message>
        <source>the content is none of %1; export the part as STEP.</source>
        <translation>der Inhalt ist nichts von %1; das Teil als STEP exportieren.</translation>
    </message>
    <message>
        <source>is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file.</source>
        <translation>ist unvollständig: %1 von %2 Flächen einer Schale konnten gelesen werden; die anderen sind in der Datei beschädigt.</translation>
    </message>
    <message>
        <source>it could not be measured (%1)</source>
        <translation>es konnte nicht gemessen werden (%1)</translation>
    </message>
    <message>
        <source>this is a gzip archive; unpack it and open the file inside.</source>
        <translation>das ist ein gzip-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is a bzip2 archive; unpack it and open the file inside.</source>
        <translation>das ist ein bzip2-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is a 7z archive; unpack it and open the file inside.</source>
        <translation>das ist ein 7z-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is an xz archive; unpack it and open the file inside.</source>
        <translation>das ist ein xz-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is a zstd archive; unpack it and open the file inside.</source>
        <translation>das ist ein zstd-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is a rar archive; unpack it and open the file inside.</source>
        <translation>das ist ein rar-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>this is a tar archive; unpack it and open the file inside.</source>
        <translation>das ist ein tar-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again.</source>
        <translation>der Text ist UTF-16; als einfachen Text (ASCII oder UTF-8) speichern und noch einmal öffnen.</translation>
    </message>
    <message>
        <source>this is a PDF document; ask for the STEP file of the part.</source>
        <translation>das ist ein PDF-Dokument; um die STEP-Datei des Teils bitten.</translation>
    </message>
    <message>
        <source>this is a picture; ask for the STEP file of the part.</source>
        <translation>das ist ein Bild; um die STEP-Datei des Teils bitten.</translation>
    </message>
    <message>
        <source>this is a database, not a CAD or mesh file.</source>
        <translation>das ist eine Datenbank, keine CAD- oder Netzdatei.</translation>
    </message>
    <message>
        <source>this is a native file of another program; export it as STEP there.</source>
        <translation>das ist eine eigene Datei eines anderen Programms; sie dort als STEP exportieren.</translation>
    </message>
    <message>
        <source>this is an AutoCAD drawing (DWG); export the part as STEP there.</source>
        <translation>das ist eine AutoCAD-Zeichnung (DWG); das Teil dort als STEP exportieren.</translation>
    </message>
    <message>
        <source>this is a program, not a CAD or mesh file.</source>
        <translation>das ist ein Programm, keine CAD- oder Netzdatei.</translation>
    </message>
    <message>
        <source>this is a web page, not a CAD file; the download may have failed.</source>
        <translation>das ist eine Webseite, keine CAD-Datei; das Herunterladen ist vielleicht misslungen.</translation>
    </message>
    <message>
        <source>this is STEP as XML (part 28, stpx), which is not read here; export the part as STEP text (stp).</source>
        <translation>das ist STEP als XML (Teil 28, stpx), das hier nicht gelesen wird; das Teil als STEP-Text (stp) exportieren.</translation>
    </message>
    <message>
        <source>this is an XML text and not one of the files that are read here; export the part as STEP.</source>
        <translation>das ist ein XML-Text und keine der Dateien, die hier gelesen werden; das Teil als STEP exportieren.</translation>
    </message>
    <message>
        <source>this is a zip archive that is cut off or damaged; get it again.</source>
        <translation>das ist ein zip-Archiv, das abgeschnitten oder beschädigt ist; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>this is a Word document; ask for the STEP file of the part.</source>
        <translation>das ist ein Word-Dokument; um die STEP-Datei des Teils bitten.</translation>
    </message>
    <message>
        <source>this is an Excel workbook; ask for the STEP file of the part.</source>
        <translation>das ist eine Excel-Arbeitsmappe; um die STEP-Datei des Teils bitten.</translation>
    </message>
    <message>
        <source>this is a PowerPoint presentation; ask for the STEP file of the part.</source>
        <translation>das ist eine PowerPoint-Präsentation; um die STEP-Datei des Teils bitten.</translation>
    </message>
    <message>
        <source>this is a FreeCAD document; export the part as STEP there.</source>
        <translation>das ist ein FreeCAD-Dokument; das Teil dort als STEP exportieren.</translation>
    </message>
    <message>
        <source>this is a zip archive that holds &quot;%1&quot; (compressed STEP, stpz); unpack it and open that file.</source>
        <translation>das ist ein zip-Archiv, das „%1“ enthält (komprimiertes STEP, stpz); entpacken und diese Datei öffnen.</translation>
    </message>
    <message>
        <source>this is a zip archive; unpack it and open the file inside.</source>
        <translation>das ist ein zip-Archiv; entpacken und die Datei darin öffnen.</translation>
    </message>
    <message>
        <source>the %1 file is damaged and cannot be read; export it again.</source>
        <translation>die Datei (%1) ist beschädigt und kann nicht gelesen werden; noch einmal exportieren.</translation>
    </message>
    <message>
        <source>the GLB is damaged, or of another version than 2; export it again as glTF 2.0.</source>
        <translation>die GLB-Datei ist beschädigt oder von einer anderen Version als 2; noch einmal als glTF 2.0 exportieren.</translation>
    </message>
    <message>
        <source>the GLB is cut off or damaged; get it again.</source>
        <translation>die GLB-Datei ist abgeschnitten oder beschädigt; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>this is a glTF of version unknown, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>das ist glTF einer unbekannten Version, lesbar ist nur 2; noch einmal als glTF 2.0 exportieren.</translation>
    </message>
    <message>
        <source>this is a glTF of version %1, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>das ist glTF der Version %1, lesbar ist nur 2; noch einmal als glTF 2.0 exportieren.</translation>
    </message>
    <message>
        <source>the glTF is compressed (%1), which is not read here; export it without compression.</source>
        <translation>die glTF-Datei ist komprimiert (%1), was hier nicht gelesen wird; sie ohne Komprimierung exportieren.</translation>
    </message>
    <message>
        <source>the glTF keeps its numbers in &quot;%1&quot;, which is not beside it; put it there.</source>
        <translation>die glTF-Datei hat ihre Zahlen in „%1“, das nicht neben ihr liegt; es dorthin legen.</translation>
    </message>
    <message>
        <source>a node of the glTF is in two others; the file is damaged, export it again.</source>
        <translation>ein Knoten der glTF-Datei steckt in zwei anderen; die Datei ist beschädigt, noch einmal exportieren.</translation>
    </message>
    <message>
        <source>nodes of the glTF hold themselves or are nested more than %1 deep; export it again.</source>
        <translation>Knoten der glTF-Datei enthalten sich selbst oder sind mehr als %1-fach verschachtelt; noch einmal exportieren.</translation>
    </message>
    <message>
        <source>the glTF file is cut off or damaged; get it again.</source>
        <translation>die glTF-Datei ist abgeschnitten oder beschädigt; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the %1 file has triangles with corners that are not there; it is damaged, get it again.</source>
        <translation>die Datei (%1) hat Dreiecke mit Ecken, die es nicht gibt; sie ist beschädigt, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>is not a closed surface: %1. It is shown and cannot be filled.</source>
        <translation>ist keine geschlossene Fläche: %1. Es wird gezeigt und kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>has no volume; it cannot be filled.</source>
        <translation>hat kein Volumen; es kann nicht gefüllt werden.</translation>
    </message>
    <message>
        <source>the line &quot;%1&quot; in the header of the PLY file is damaged; get it again.</source>
        <translation>die Zeile „%1“ im Kopf der PLY-Datei ist beschädigt; noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the header of the PLY file has no end; it is cut off or damaged, get it again.</source>
        <translation>der Kopf der PLY-Datei hat kein Ende; sie ist abgeschnitten oder beschädigt, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the PLY file holds fewer numbers than its header promises; it is cut off, get it again.</source>
        <translation>die PLY-Datei enthält weniger Zahlen, als ihr Kopf verspricht; sie ist abgeschnitten, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that wrote it.</source>
        <translation>%1: die 3MF-Datei hält sich an 1 Stelle nicht an das Format; die Teile mit dem Programm vergleichen, das sie schrieb.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that wrote it.</source>
        <translation>%1: die 3MF-Datei hält sich an %2 Stellen nicht an das Format; die Teile mit dem Programm vergleichen, das sie schrieb.</translation>
    </message>
    <message>
        <source>the 3MF builds no object; export it again with the parts in its build.</source>
        <translation>die 3MF-Datei baut kein Objekt; noch einmal mit den Teilen in ihrem Bau exportieren.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than %1 objects, or nests them more than %2 deep; export the parts you need.</source>
        <translation>die 3MF-Datei entfaltet sich zu mehr als %1 Objekten oder verschachtelt sie mehr als %2-fach; nur die benötigten Teile exportieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no triangles.</source>
        <translation>„%1“ hat keine Dreiecke.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than 200 million triangles; export the parts you need.</source>
        <translation>die 3MF-Datei entfaltet sich zu mehr als 200 Millionen Dreiecken; nur die benötigten Teile exportieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length unit; choose one of %2.</source>
        <translation>„%1“ ist keine Längeneinheit; eine von %2 wählen.</translation>
    </message>
    <message>
        <source>Nothing was imported; the file is damaged, or needs a longer time limit.</source>
        <translation>Nichts wurde importiert; die Datei ist beschädigt oder braucht ein höheres Zeitlimit.</translation>
    </message>
    <message>
        <source>Nothing was imported; export the file again, best as STEP.</source>
        <translation>Nichts wurde importiert; die Datei noch einmal exportieren, am besten als STEP.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was imported; try again.</source>
        <translation>das Ergebnis des Lesers ist beschädigt (%1). Nichts wurde importiert; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>%1: the reader crashed on what the file says beside its shapes; these were read without names, colors and assemblies, and without other files that it refers to.</source>
        <translation>%1: der Leser stürzte über das ab, was die Datei neben ihren Formen sagt; diese wurden ohne Namen, Farben und Baugruppen gelesen, und ohne andere Dateien, auf die sie verweist.</translation>
    </message>
    <message>
        <source>There is no file to open.</source>
        <translation>Es gibt keine Datei zu öffnen.</translation>
    </message>
    <message>
        <source>%1: the 3MF requires what is not read here (%2), and parts may be stand-ins; compare them with the program that wrote it.</source>
        <translation>%1: die 3MF-Datei setzt voraus, was hier nicht gelesen wird (%2), und Teile können Platzhalter sein; sie mit dem Programm vergleichen, das sie schrieb.</translation>
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
    <message>
        <source>Time: automatic</source>
        <translation>Zeit: automatisch</translation>
    </message>
    <message>
        <source>Memory: automatic</source>
        <translation>Speicher: automatisch</translation>
    </message>
    <message>
        <source>Reading may take</source>
        <translation>Lesen darf brauchen</translation>
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
        <translation>„%1“ wird nicht simuliert: %2</translation>
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
    <message>
        <source>Add parts</source>
        <translation>Teile hinzufügen</translation>
    </message>
    <message>
        <source>Something else was done while parts were read, so none were added. Add them again.</source>
        <translation>Während Teile gelesen wurden, ist etwas anderes geschehen, deshalb kamen keine hinzu. Fügen Sie sie noch einmal hinzu.</translation>
    </message>
    <message>
        <source>Add again</source>
        <translation>Noch einmal hinzufügen</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>%1 wird hinzugefügt</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und eine weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Put beside other things or on the floor, where there is room: %1.</source>
        <translation>Neben anderes oder auf den Boden gelegt, wo Platz ist: %1.</translation>
    </message>
    <message>
        <source>What these fixtures held was kneaded and has other objects now; they are gone: %1.</source>
        <translation>Was diese Einspannungen hielten, wurde geknetet und hat jetzt andere Objekte; sie sind weg: %1.</translation>
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
    <message>
        <source>Remarks</source>
        <translation>Hinweise</translation>
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
    <name>Load</name>
    <message>
        <source>A load must not be larger than 1e12 N, N m or Pa.</source>
        <translation>Eine Last darf nicht größer als 1e12 N, N m oder Pa sein.</translation>
    </message>
    <message>
        <source>A load must rise within 0 to 3600 s.</source>
        <translation>Eine Last muss in 0 bis 3600 s ansteigen.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; acts on nothing.</source>
        <translation>Die Last „%1“ wirkt auf nichts.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names an object that does not exist.</source>
        <translation>Die Last „%1“ nennt ein Objekt, das es nicht gibt.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; has an area that is no number.</source>
        <translation>Die Last „%1“ hat eine Fläche, die keine Zahl ist.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names a body that does not exist.</source>
        <translation>Die Last „%1“ nennt einen Körper, den es nicht gibt.</translation>
    </message>
    <message>
        <source>There is no load number %1.</source>
        <translation>Es gibt keine Last Nummer %1.</translation>
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
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
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
        <translation>Bereit. Ein Teil mit Strg+O öffnen oder eine Datei auf das Fenster legen.</translation>
    </message>
    <message>
        <source>%1: cancelled, nothing has changed.</source>
        <translation>%1: abgebrochen, nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Click faces to hold or free them   Esc: done</source>
        <translation>Flächen anklicken hält sie oder gibt sie frei   Esc: fertig</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: drive   Shift: slower   %1: orbit</source>
        <translation>Pfeile, Bild auf, Bild ab: fahren   Umschalt: langsamer   %1: drehen</translation>
    </message>
    <message>
        <source>%1: orbit   %2: pan   Wheel: zoom</source>
        <translation>%1: drehen   %2: schieben   Rad: zoomen</translation>
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
        <source>Drag to move the timeline</source>
        <translation>Ziehen verschiebt die Zeitleiste</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Click into the view: arrows then drive the tool   %1: orbit</source>
        <translation>In die Ansicht klicken: dann fahren Pfeile das Werkzeug   %1: drehen</translation>
    </message>
    <message>
        <source>Another window could not be opened.</source>
        <translation>Ein weiteres Fenster ließ sich nicht öffnen.</translation>
    </message>
    <message>
        <source>Go back to the part first: Esc.</source>
        <translation>Zuerst zum Teil zurückkehren: Esc.</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: place   Space: play, and it presses   %1: orbit</source>
        <translation>Pfeile, Bild auf, Bild ab: hinstellen   Leertaste: starten, dann drückt es   %1: drehen</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>%1 is %2; it must lie between %3 and %4.</source>
        <translation>%1: %2 ist nicht möglich, erlaubt ist %3 bis %4.</translation>
    </message>
    <message>
        <source>The region names the object %1; the body has %2.</source>
        <translation>Der Bereich nennt das Objekt %1; der Körper hat %2.</translation>
    </message>
    <message>
        <source>A body can be made of at most 255 different materials.</source>
        <translation>Ein Körper kann aus höchstens 255 verschiedenen Materialien bestehen.</translation>
    </message>
    <message>
        <source>A rigid body has no stress to lose. Make it deformable first.</source>
        <translation>Ein starrer Körper hat keine Spannung zu verlieren. Ihn zuerst verformbar machen.</translation>
    </message>
    <message>
        <source>Re-normalization takes 0 to 3600 s.</source>
        <translation>Das Renormieren dauert 0 bis 3600 s.</translation>
    </message>
    <message>
        <source>There is no object number %1.</source>
        <translation>Es gibt kein Objekt Nummer %1.</translation>
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
    <message>
        <source>Right / left</source>
        <translation>Rechts / links</translation>
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
    <message>
        <source>no limit</source>
        <translation>ohne Grenze</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>weniger als %1</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>Woher die Zahlen stammen</translation>
    </message>
</context>
<context>
    <name>MaterialStore</name>
    <message>
        <source>Your own materials cannot be read: %1 Mend or remove the file; until then none can be saved.</source>
        <translation>Die eigenen Materialien lassen sich nicht lesen: %1 Die Datei reparieren oder entfernen; bis dahin kann keines gespeichert werden.</translation>
    </message>
    <message>
        <source>A material needs a name: type one.</source>
        <translation>Ein Material braucht einen Namen: einen tippen.</translation>
    </message>
    <message>
        <source>There is a material named &quot;%1&quot; already: choose another name.</source>
        <translation>Ein Material namens „%1“ gibt es schon: einen anderen Namen wählen.</translation>
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
        <translation>Noch wird nichts gemessen. Oben wählen, was zu messen ist, dann auf das Teil klicken; Ecken ziehen den Zeiger an. Die Zahlen folgen dem Material, während die Zeit läuft.</translation>
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
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
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
        <translation>Die drei Stellen liegen auf einer Geraden: andere wählen, weiter um den Kreis verteilt.</translation>
    </message>
    <message>
        <source>The face is flat and has no radius: click a round one, or measure with three places.</source>
        <translation>Die Fläche ist eben und hat keinen Radius: eine runde anklicken, oder mit drei Stellen messen.</translation>
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
    <message>
        <source>&quot;%1&quot; cannot be measured: %2</source>
        <translation>„%1“ kann nicht gemessen werden: %2</translation>
    </message>
    <message>
        <source>a place is three coordinates in mm, as 10,0,2.5; this is %1.</source>
        <translation>ein Ort sind drei Koordinaten in mm, etwa 10,0,2.5; dies ist %1.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; coordinates are in mm.</source>
        <translation>%1 liegt weit weg von allen Körpern; Koordinaten sind in mm.</translation>
    </message>
    <message>
        <source>there is no body &quot;%1&quot;; there are: %2.</source>
        <translation>es gibt keinen Körper „%1“; es gibt: %2.</translation>
    </message>
    <message>
        <source>which body the face %1 is of is not clear; put its name before it, as &quot;lid&quot;:%1, or its number from 0, as #0:%1.</source>
        <translation>zu welchem Körper die Fläche %1 gehört, ist unklar; seinen Namen davor setzen, etwa &quot;lid&quot;:%1, oder seine Nummer ab 0, etwa #0:%1.</translation>
    </message>
    <message>
        <source>there is no face %1; faces are numbered from 0, and meshes have none.</source>
        <translation>es gibt keine Fläche %1; Flächen werden ab 0 gezählt, und Netze haben keine.</translation>
    </message>
    <message>
        <source>it begins with none of %1.</source>
        <translation>es beginnt mit keinem von %1.</translation>
    </message>
    <message>
        <source>%1 takes %2 places or faces.</source>
        <translation>%1 braucht %2 Orte oder Flächen.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>das Projekt hat keine Teile.</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>das Projekt hat keinen Eintrag %1; der letzte ist %2.</translation>
    </message>
    <message>
        <source>this is no project: it has no entries.</source>
        <translation>das ist kein Projekt: Es hat keine Einträge.</translation>
    </message>
    <message>
        <source>no part of it is closed, so there is nothing to measure.</source>
        <translation>kein Teil davon ist geschlossen, also gibt es nichts zu messen.</translation>
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
        <source>Largest and mean distance, volume and mass beside the original, and a report</source>
        <translation>Größter und mittlerer Abstand, Volumen und Masse neben dem Original, und ein Bericht</translation>
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
        <translation>Der Ordner %1 lässt sich nicht zeigen: in der Dateiverwaltung danach suchen.</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>There is a selection called &quot;%1&quot; already: choose another name.</source>
        <translation>Einen Auswahlsatz namens „%1“ gibt es schon: einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Color of the part</source>
        <translation>Farbe des Teils</translation>
    </message>
    <message>
        <source>Color of %1 parts</source>
        <translation>Farbe von %1 Teilen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
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
    <name>Navigation</name>
    <message>
        <source>middle+left</source>
        <translation>Mitte+links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Shift+</source>
        <translation>Umschalt+</translation>
    </message>
    <message>
        <source>Ctrl+</source>
        <translation>Strg+</translation>
    </message>
    <message>
        <source>Two buttons / touchpad</source>
        <translation>Zwei Tasten / Touchpad</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 billion</source>
        <translation>%1 Milliarden</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 Millionen</translation>
    </message>
    <message>
        <source>%1 thousand</source>
        <translation>%1 Tausend</translation>
    </message>
</context>
<context>
    <name>NumberPage</name>
    <message>
        <source>Begins and ends gently</source>
        <translation>Beginnt und endet sanft</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>The selected ones</source>
        <translation>Die ausgewählten</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>The longest side</source>
        <translation>Die längste Seite</translation>
    </message>
    <message>
        <source>Normal of the selected face</source>
        <translation>Normale der ausgewählten Fläche</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>First plane</source>
        <translation>Erste Ebene</translation>
    </message>
    <message>
        <source>Where it begins, along the axis from the origin</source>
        <translation>Wo es beginnt, entlang der Achse vom Ursprung aus</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Zweite Ebene</translation>
    </message>
    <message>
        <source>Where it ends, along the axis from the origin</source>
        <translation>Wo es endet, entlang der Achse vom Ursprung aus</translation>
    </message>
    <message>
        <source>Toward</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Of the second plane against the first one; below 0 the other way</source>
        <translation>Der zweiten Ebene gegen die erste; unter 0 andersherum</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of the line that keeps its length; the angle follows</source>
        <translation>Der Linie, die ihre Länge behält; der Winkel folgt</translation>
    </message>
    <message>
        <source>Neutral line</source>
        <translation>Neutrale Faser</translation>
    </message>
    <message>
        <source>What keeps its length: 0 at the inner side, 1 at the outer one. Sheet metal has some 0.33 to 0.5, its k-factor</source>
        <translation>Was seine Länge behält: 0 an der Innenseite, 1 an der Außenseite. Blech hat etwa 0,33 bis 0,5, seinen k-Faktor</translation>
    </message>
    <message>
        <source>Neutral place</source>
        <translation>Neutrale Stelle</translation>
    </message>
    <message>
        <source>The same as a place along the side that it bends toward</source>
        <translation>Dasselbe als Stelle entlang der Seite, nach der es sich biegt</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Of the second plane; 1 changes nothing</source>
        <translation>Der zweiten Ebene; 1 ändert nichts</translation>
    </message>
    <message>
        <source>New length</source>
        <translation>Neue Länge</translation>
    </message>
    <message>
        <source>Between the planes afterwards; the factor follows</source>
        <translation>Danach zwischen den Ebenen; der Faktor folgt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Of the second plane, sideways</source>
        <translation>Der zweiten Ebene, seitwärts</translation>
    </message>
    <message>
        <source>The first plane</source>
        <translation>Die erste Ebene</translation>
    </message>
    <message>
        <source>The middle</source>
        <translation>Die Mitte</translation>
    </message>
    <message>
        <source>The second plane</source>
        <translation>Die zweite Ebene</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Bleibt, wo es ist</translation>
    </message>
    <message>
        <source>Without a crease at the planes; in the middle there is then more of it</source>
        <translation>Ohne Knick an den Ebenen; in der Mitte ist es dafür mehr</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>Let go at the end</source>
        <translation>Am Ende loslassen</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>By physics</source>
        <translation>Durch Physik</translation>
    </message>
    <message>
        <source>Exactly: all goes as the formula says. By physics: what lies beyond the planes is held by grips that go as the formula says, and the material between them finds its own shape</source>
        <translation>Exakt: Alles geht, wie die Formel sagt. Durch Physik: Was jenseits der Ebenen liegt, halten Griffe, die gehen, wie die Formel sagt, und das Material dazwischen findet seine eigene Form</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Time it takes</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Of the way of the grips; material that flows resists less when it is slow</source>
        <translation>Des Weges der Griffe; Material, das fließt, widersteht langsam weniger</translation>
    </message>
    <message>
        <source>The grip that has moved most opens, so that elastic material springs back</source>
        <translation>Der Griff, der am weitesten gegangen ist, öffnet sich, sodass elastisches Material zurückfedert</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>The graphics card draws no pictures of this size. Choose a smaller one.</source>
        <translation>Die Grafikkarte zeichnet keine Bilder dieser Größe. Eine kleinere wählen.</translation>
    </message>
    <message>
        <source>The graphics card takes no more pictures. Close other programs and try again.</source>
        <translation>Die Grafikkarte nimmt keine Bilder mehr auf. Andere Programme schließen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The graphics driver draws for the window only, so that nothing can be recorded. Start Knead with LIBGL_ALWAYS_SOFTWARE=1 in its environment to record without the driver.</source>
        <translation>Der Grafiktreiber zeichnet nur für das Fenster, deshalb kann nichts aufgezeichnet werden. Knead mit LIBGL_ALWAYS_SOFTWARE=1 in seiner Umgebung starten, um ohne den Treiber aufzuzeichnen.</translation>
    </message>
</context>
<context>
    <name>OtherPartDialog</name>
    <message>
        <source>Apply to another part</source>
        <translation>Auf ein anderes Teil anwenden</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Quer zu %1</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>Dieselbe</translation>
    </message>
    <message>
        <source>Another one, as its box says</source>
        <translation>Eine andere, wie ihr Quader sagt</translation>
    </message>
    <message>
        <source>So many times as large</source>
        <translation>So viele Male so groß</translation>
    </message>
    <message>
        <source>%1, as compared with the part that is open:</source>
        <translation>%1, verglichen mit dem Teil, das offen ist:</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>Find the faces again</source>
        <translation>Flächen wiederfinden</translation>
    </message>
</context>
<context>
    <name>OtherPartFeature</name>
    <message>
        <source>%1 of %2 faces were found again.</source>
        <translation>%1 von %2 Flächen wurden wiedergefunden.</translation>
    </message>
    <message>
        <source>Moved: %1 by %2 mm</source>
        <translation>Verschoben: %1 um %2 mm</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Apply to another part</source>
        <translation>Auf ein anderes Teil anwenden</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Teile (%1)</translation>
    </message>
    <message>
        <source>Finding the faces again on %1</source>
        <translation>Die Flächen werden auf %1 wiedergefunden</translation>
    </message>
    <message>
        <source>This is what was found again on %1:</source>
        <translation>Das wurde auf %1 wiedergefunden:</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Apply to %1</source>
        <translation>Auf %1 anwenden</translation>
    </message>
    <message>
        <source>Play carries out on %1 what was done before.</source>
        <translation>Abspielen führt auf %1 aus, was zuvor getan wurde.</translation>
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
        <translation>Ein Teil öffnen und Starten drücken, um zu sehen, wohin die Zeit geht.</translation>
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
    <message>
        <source>Time of a frame</source>
        <translation>Zeit eines Bildes</translation>
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
        <translation>An dieser Stelle ist nichts: auf ein Teil klicken.</translation>
    </message>
    <message>
        <source>This part is a mesh without CAD faces: measure it with places instead.</source>
        <translation>Dieses Teil ist ein Netz ohne CAD-Flächen: es stattdessen mit Stellen messen.</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>The picture cannot be written in this format (%1). Choose another one.</source>
        <translation>Das Bild lässt sich in diesem Format nicht schreiben (%1). Ein anderes wählen.</translation>
    </message>
    <message>
        <source>The picture cannot be written in %1 (%2). Free some room, or choose another place.</source>
        <translation>Das Bild lässt sich in %1 nicht schreiben (%2). Platz schaffen oder einen anderen Ort wählen.</translation>
    </message>
</context>
<context>
    <name>PictureDialog</name>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG, exact</source>
        <translation>PNG, genau</translation>
    </message>
    <message>
        <source>JPEG, small</source>
        <translation>JPEG, klein</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>With grid and shadow</source>
        <translation>Mit Raster und Schatten</translation>
    </message>
    <message>
        <source>With the view cube</source>
        <translation>Mit Ansichtswürfel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Ort wählen...</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, wie die Ansicht</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Only PNG files can have a transparent background.</source>
        <translation>Nur PNG-Dateien können einen durchsichtigen Hintergrund haben.</translation>
    </message>
</context>
<context>
    <name>PictureFeature</name>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>writing the picture</source>
        <translation>Bild wird geschrieben</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>%1: picture saved.</source>
        <translation>%1: Bild gespeichert.</translation>
    </message>
</context>
<context>
    <name>PlaceRows</name>
    <message>
        <source>Show me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Look there in the view (Enter)</source>
        <translation>In der Ansicht dorthin sehen (Eingabe)</translation>
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
        <translation>Selbst vergebene Namen, und was die Befehlszeile sagt, bleiben wie sie sind.</translation>
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
    <message>
        <source>Mouse as in</source>
        <translation>Maus wie in</translation>
    </message>
    <message>
        <source>Which buttons orbit, pan and zoom; the status bar tells. The wheel zooms to the cursor.</source>
        <translation>Welche Tasten drehen, schieben und zoomen; die Statusleiste sagt es. Das Rad zoomt zum Zeiger.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Textgröße</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>125 %</source>
        <translation>125 %</translation>
    </message>
    <message>
        <source>150 %</source>
        <translation>150 %</translation>
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
        <translation>Noch keine Sonden. Eine auf das Teil setzen: sie geht mit dem Material mit und trägt auf, was sie misst, auch aus dem, was davor simuliert wurde.</translation>
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
    <message>
        <source>Probes</source>
        <translation>Sonden</translation>
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
        <source>Click places of the part to plot what happens there over time</source>
        <translation>Stellen des Teils anklicken, um aufzutragen, was dort über der Zeit geschieht</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>what was done last</source>
        <translation>was zuletzt getan wurde</translation>
    </message>
    <message>
        <source>the state after &quot;%1&quot;</source>
        <translation>der Zustand nach „%1“</translation>
    </message>
    <message>
        <source>a number in the table blobs is out of range</source>
        <translation>eine Zahl in der Tabelle blobs ist außerhalb des Erlaubten</translation>
    </message>
    <message>
        <source>a row of the table blobs cannot be unpacked</source>
        <translation>eine Zeile der Tabelle blobs lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>pieces of the table blobs are mixed up</source>
        <translation>Stücke der Tabelle blobs sind durcheinander</translation>
    </message>
    <message>
        <source>Another window works on this: discard it there.</source>
        <translation>Ein anderes Fenster arbeitet daran: es dort verwerfen.</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>es lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>eine solche Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>this is a folder, not a project.</source>
        <translation>das ist ein Ordner, kein Projekt.</translation>
    </message>
    <message>
        <source>this is no file, and no project either.</source>
        <translation>das ist keine Datei und auch kein Projekt.</translation>
    </message>
    <message>
        <source>the file cannot be read; check its permissions.</source>
        <translation>die Datei kann nicht gelesen werden; ihre Rechte prüfen.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>die Datei ist leer.</translation>
    </message>
    <message>
        <source>this is not a Knead project.</source>
        <translation>das ist kein Knead-Projekt.</translation>
    </message>
    <message>
        <source>this is a database of another program, not a Knead project.</source>
        <translation>das ist eine Datenbank eines anderen Programms, kein Knead-Projekt.</translation>
    </message>
    <message>
        <source>%1: the project is damaged: %2. What is whole can be rescued.</source>
        <translation>%1: das Projekt ist beschädigt: %2. Was heil ist, kann gerettet werden.</translation>
    </message>
    <message>
        <source>there is a folder of this name; choose another name.</source>
        <translation>es gibt einen Ordner dieses Namens; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>the file is read-only; save the project under another name.</source>
        <translation>die Datei ist schreibgeschützt; das Projekt unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>its tables are not those of a project</source>
        <translation>ihre Tabellen sind nicht die eines Projekts</translation>
    </message>
    <message>
        <source>a newer Knead saved this project (version %1 of the file; this program reads up to %2). Update Knead to open it.</source>
        <translation>ein neueres Knead hat dieses Projekt gespeichert (Version %1 der Datei; dieses Programm liest bis %2). Knead aktualisieren, um es zu öffnen.</translation>
    </message>
    <message>
        <source>what was written cannot be read back: %1</source>
        <translation>was geschrieben wurde, lässt sich nicht zurücklesen: %1</translation>
    </message>
    <message>
        <source>nothing of this project can be read any more; open a copy of it, or the part that it was made from.</source>
        <translation>von diesem Projekt lässt sich nichts mehr lesen; eine Kopie davon öffnen oder das Teil, aus dem es entstand.</translation>
    </message>
    <message>
        <source>another window works on it. Close it there, or open a copy.</source>
        <translation>ein anderes Fenster arbeitet daran. Es dort schließen, oder eine Kopie öffnen.</translation>
    </message>
    <message>
        <source>another window of this program works on it. Close it there, or open a copy.</source>
        <translation>ein anderes Fenster dieses Programms arbeitet daran. Es dort schließen, oder eine Kopie öffnen.</translation>
    </message>
    <message>
        <source>another window works on it (process %1 on %2, since %3). Close it there, or open a copy.</source>
        <translation>ein anderes Fenster arbeitet daran (Prozess %1 auf %2, seit %3). Es dort schließen, oder eine Kopie öffnen.</translation>
    </message>
    <message>
        <source>a fixture is of a body that is not there</source>
        <translation>eine Einspannung gehört zu einem Körper, den es nicht gibt</translation>
    </message>
    <message>
        <source>a fixture has objects that are not there</source>
        <translation>eine Einspannung hat Objekte, die es nicht gibt</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>eine Anzahl ist negativ</translation>
    </message>
    <message>
        <source>rows of the table contents are mixed up</source>
        <translation>Zeilen der Tabelle contents sind durcheinander</translation>
    </message>
    <message>
        <source>the number of rows of the table %1</source>
        <translation>die Zahl der Zeilen der Tabelle %1</translation>
    </message>
    <message>
        <source>the table %1</source>
        <translation>die Tabelle %1</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>tool part %1</source>
        <translation>Werkzeugteil %1</translation>
    </message>
    <message>
        <source>start state %1</source>
        <translation>Anfangszustand %1</translation>
    </message>
    <message>
        <source>rows of the table bodies are mixed up</source>
        <translation>Zeilen der Tabelle bodies sind durcheinander</translation>
    </message>
    <message>
        <source>a body is of a part that is not there</source>
        <translation>ein Körper gehört zu einem Teil, das es nicht gibt</translation>
    </message>
    <message>
        <source>a region has objects that are not there</source>
        <translation>eine Region hat Objekte, die es nicht gibt</translation>
    </message>
    <message>
        <source>entry %1</source>
        <translation>Eintrag %1</translation>
    </message>
    <message>
        <source>which entry was shown</source>
        <translation>welcher Eintrag gezeigt wurde</translation>
    </message>
    <message>
        <source>that entry is missing</source>
        <translation>dieser Eintrag fehlt</translation>
    </message>
    <message>
        <source>it follows a later one</source>
        <translation>er folgt auf einen späteren</translation>
    </message>
    <message>
        <source>the entry that it follows is missing</source>
        <translation>der Eintrag, auf den er folgt, fehlt</translation>
    </message>
    <message>
        <source>its start state is missing</source>
        <translation>sein Anfangszustand fehlt</translation>
    </message>
    <message>
        <source>the state of entry %1</source>
        <translation>der Zustand von Eintrag %1</translation>
    </message>
    <message>
        <source>it is of another length</source>
        <translation>er hat eine andere Länge</translation>
    </message>
    <message>
        <source>the view</source>
        <translation>die Ansicht</translation>
    </message>
    <message>
        <source>mark %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>its entry is missing</source>
        <translation>ihr Eintrag fehlt</translation>
    </message>
    <message>
        <source>what panel %1 kept</source>
        <translation>was der Bereich %1 aufbewahrte</translation>
    </message>
    <message>
        <source>The work cannot be kept for recovery (%1). Save the project, and make room in %2.</source>
        <translation>Die Arbeit kann nicht für die Wiederherstellung aufbewahrt werden (%1). Das Projekt speichern, und Platz in %2 schaffen.</translation>
    </message>
    <message>
        <source>Nothing of the work that was kept in %1 can be read any more. Discard it, and open what was saved last.</source>
        <translation>Von der Arbeit, die in %1 aufbewahrt wurde, lässt sich nichts mehr lesen. Die Arbeit verwerfen, und öffnen, was zuletzt gespeichert wurde.</translation>
    </message>
    <message>
        <source>its folder cannot be locked</source>
        <translation>sein Ordner lässt sich nicht sperren</translation>
    </message>
    <message>
        <source>Another window works on this already, or it was discarded: look for it there.</source>
        <translation>Ein anderes Fenster arbeitet schon daran, oder es wurde verworfen: dort nachsehen.</translation>
    </message>
    <message>
        <source>row %1 of the table %2</source>
        <translation>Zeile %1 der Tabelle %2</translation>
    </message>
    <message>
        <source>a value in the table %1 is of the wrong kind</source>
        <translation>ein Wert in der Tabelle %1 ist von der falschen Art</translation>
    </message>
    <message>
        <source>a number in the table %1 is out of range</source>
        <translation>eine Zahl in der Tabelle %1 ist außerhalb des Erlaubten</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>%1 is not as it was written</source>
        <translation>%1 ist nicht so, wie sie geschrieben wurde</translation>
    </message>
    <message>
        <source>what was done to the parts</source>
        <translation>was mit den Teilen getan wurde</translation>
    </message>
    <message>
        <source>%1: what was seen last cannot be shown. %2 What is whole can be rescued.</source>
        <translation>%1: was zuletzt zu sehen war, kann nicht gezeigt werden. %2 Was heil ist, kann gerettet werden.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Wiederhergestellt</translation>
    </message>
    <message>
        <source>what entries are called</source>
        <translation>wie Einträge heißen</translation>
    </message>
    <message>
        <source>what entry %1 is called</source>
        <translation>wie Eintrag %1 heißt</translation>
    </message>
    <message>
        <source>it is no sentence</source>
        <translation>es ist kein Satz</translation>
    </message>
    <message>
        <source>the file holds triggers, views or virtual tables, which no Knead writes: somebody else put them there. Nothing of it was opened.</source>
        <translation>die Datei enthält Trigger, Sichten oder virtuelle Tabellen, die kein Knead schreibt: jemand anders hat sie hineingesetzt. Nichts davon wurde geöffnet.</translation>
    </message>
    <message>
        <source>how the parts of start state %1 were deformed</source>
        <translation>wie die Teile des Anfangszustands %1 verformt wurden</translation>
    </message>
    <message>
        <source>Nothing was opened; the file is damaged or far too large.</source>
        <translation>Es wurde nichts geöffnet; die Datei ist beschädigt oder viel zu groß.</translation>
    </message>
    <message>
        <source>Nothing was opened; open a copy of the project, or the part that it was made from.</source>
        <translation>Es wurde nichts geöffnet; öffnen Sie eine Kopie des Projekts oder das Teil, aus dem es entstand.</translation>
    </message>
    <message>
        <source>the project asks for more memory than there is.</source>
        <translation>das Projekt verlangt mehr Speicher, als es gibt.</translation>
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
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen.</translation>
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
        <translation>%1 gibt es schon: einen anderen Namen oder diese Datei wählen.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, and save again.</source>
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen, und dann speichern.</translation>
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
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
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
        <translation>%1 ist nicht mehr da. Vielleicht wurde es verschoben: es mit Strg+O suchen.</translation>
    </message>
    <message>
        <source>A project is opened alone: choose one file, or only parts.</source>
        <translation>Ein Projekt wird allein geöffnet: eine Datei oder nur Teile wählen.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>Beis&amp;piele</translation>
    </message>
    <message>
        <source>Closed %1.</source>
        <translation>%1 geschlossen.</translation>
    </message>
</context>
<context>
    <name>PropertyPages</name>
    <message>
        <source>Nothing selected.</source>
        <translation>Nichts ausgewählt.</translation>
    </message>
</context>
<context>
    <name>Python</name>
    <message>
        <source>There is no material &quot;%1&quot;; knead.Material.presets() lists their names.</source>
        <translation>Es gibt kein Material „%1“; knead.Material.presets() nennt die Namen.</translation>
    </message>
    <message>
        <source>%1 has no parts.</source>
        <translation>%1 hat keine Teile.</translation>
    </message>
    <message>
        <source>This tool is no longer in the simulation.</source>
        <translation>Dieses Werkzeug ist nicht mehr in der Simulation.</translation>
    </message>
    <message>
        <source>This simulation is in the midst of computing; ask for it when that is done.</source>
        <translation>Diese Simulation rechnet gerade; fragen Sie sie, wenn das getan ist.</translation>
    </message>
    <message>
        <source>A simulation needs a body; make one of a part with knead.fill().</source>
        <translation>Eine Simulation braucht einen Körper; machen Sie mit knead.fill() einen aus einem Teil.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3.</source>
        <translation>„%1“ hat keine Fläche %2; es hat %3.</translation>
    </message>
    <message>
        <source>The fixture of &quot;%1&quot; holds nothing: no object lies there.</source>
        <translation>Die Halterung von „%1“ hält nichts: dort liegt kein Objekt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no object %2; it has %3.</source>
        <translation>„%1“ hat kein Objekt %2; es hat %3.</translation>
    </message>
    <message>
        <source>Step %1 cannot be gone on to: the simulation is at step %2.</source>
        <translation>Zum Schritt %1 geht es nicht weiter: die Simulation ist beim Schritt %2.</translation>
    </message>
    <message>
        <source>A rotation is a quaternion (w, x, y, z) of length 1; knead.rotation(axis, angle) makes one.</source>
        <translation>Eine Drehung ist ein Quaternion (w, x, y, z) der Länge 1; knead.rotation(axis, angle) macht eines.</translation>
    </message>
    <message>
        <source>A key frame is (time, position) or (time, position, rotation).</source>
        <translation>Ein Schlüsselbild ist (time, position) oder (time, position, rotation).</translation>
    </message>
    <message>
        <source>There is no tool &quot;%1&quot;; there are box, ball, cylinder, wedge and plate.</source>
        <translation>Es gibt kein Werkzeug „%1“; es gibt box, ball, cylinder, wedge und plate.</translation>
    </message>
    <message>
        <source>The size of a tool is the diameter of a ball, (diameter, length) of a cylinder, and three lengths of all others, in metres.</source>
        <translation>Die Größe eines Werkzeugs ist der Durchmesser einer Kugel, (Durchmesser, Länge) eines Zylinders und drei Längen aller anderen, in Metern.</translation>
    </message>
    <message>
        <source>There is no choice &quot;%1&quot; here; there are: %2.</source>
        <translation>Hier gibt es keine Wahl „%1“; es gibt: %2.</translation>
    </message>
    <message>
        <source>This moment is of another simulation; go to one that this one has kept.</source>
        <translation>Dieser Moment ist von einer anderen Simulation; gehen Sie zu einem, den diese behalten hat.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
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
        <translation>%1 wurde geschrieben, nachdem diese Arbeit abgebrochen war, und bleibt, wie es ist: die Arbeit unter einem eigenen Namen oder anstelle jener Datei speichern.</translation>
    </message>
    <message>
        <source>%1 stays as it is, since the recovered work is not whole: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 bleibt, wie es ist, denn die wiederhergestellte Arbeit ist nicht vollständig: die Arbeit unter einem eigenen Namen oder anstelle jener Datei speichern.</translation>
    </message>
    <message>
        <source>The parts of this project are lost, so that nothing of it can be shown. Open the part that it was made from.</source>
        <translation>Die Teile dieses Projekts sind verloren, sodass nichts davon gezeigt werden kann. Das Teil öffnen, aus dem es gemacht wurde.</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>die Sonde „%1“</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it was filled anew with %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 nennt Objekte eines Körpers, der mit %2 neu gefüllt wurde, und hier wurde er mit %3 neu gefüllt. Stattdessen einen Quader nennen, oder den Abstand beibehalten und was davor getan wird.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it is filled with the first %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 nennt Objekte eines Körpers, der mit %2 neu gefüllt wurde, und hier ist er mit den ersten %3 gefüllt. Stattdessen einen Quader nennen, oder den Abstand beibehalten und was davor getan wird.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not closed and is left out.</source>
        <translation>„%1“ ist nicht geschlossen und wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 has no tool part %2; it has %3 of them, counted from 0.</source>
        <translation>%1 hat kein Werkzeugteil %2; es hat %3 davon, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>das Projekt hat keine Teile.</translation>
    </message>
    <message>
        <source>%1 names faces, but &quot;%2&quot; is a mesh without CAD faces; use box_mm.</source>
        <translation>%1 nennt Flächen, aber „%2“ ist ein Netz ohne CAD-Flächen; box_mm verwenden.</translation>
    </message>
    <message>
        <source>%1 names the face %2, but &quot;%3&quot; has faces 0 to %4.</source>
        <translation>%1 nennt die Fläche %2, aber „%3“ hat die Flächen 0 bis %4.</translation>
    </message>
    <message>
        <source>%1 names faces of one body among several; add the key body.</source>
        <translation>%1 nennt Flächen eines Körpers unter mehreren; den Schlüssel body hinzufügen.</translation>
    </message>
    <message>
        <source>%1 holds nothing: no object lies there.</source>
        <translation>%1 hält nichts: dort liegt kein Objekt.</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>die Region „%1“</translation>
    </message>
    <message>
        <source>%1 names the body &quot;%2&quot;; the part has: %3.</source>
        <translation>%1 nennt den Körper „%2“; das Teil hat: %3.</translation>
    </message>
    <message>
        <source>%1 names objects of one body among several; add the key body.</source>
        <translation>%1 nennt Objekte eines Körpers unter mehreren; den Schlüssel body hinzufügen.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that is filled with %2, and here it is filled with %3. Name a box instead, or keep the spacing.</source>
        <translation>%1 nennt Objekte eines Körpers, der mit %2 gefüllt ist, und hier ist er mit %3 gefüllt. Stattdessen einen Quader nennen, oder den Abstand beibehalten.</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>die Einspannung „%1“</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>die Last „%1“</translation>
    </message>
    <message>
        <source>%1 is on one body among several; add the key body.</source>
        <translation>%1 wirkt auf einen Körper unter mehreren; den Schlüssel body hinzufügen.</translation>
    </message>
    <message>
        <source>%1 acts on nothing: no surface lies there.</source>
        <translation>%1 wirkt auf nichts: dort liegt keine Oberfläche.</translation>
    </message>
    <message>
        <source>This recipe asks for balance without inertia, which &quot;knead run&quot; finds. Play carries it out as motion in time.</source>
        <translation>Dieses Rezept verlangt ein Gleichgewicht ohne Trägheit, das „knead run“ findet. Abspielen führt es als Bewegung in der Zeit aus.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>%1, line %2: %3 %4</source>
        <translation>%1, Zeile %2: %3 %4</translation>
    </message>
    <message>
        <source>%1, got %2.</source>
        <translation>%1; da steht %2.</translation>
    </message>
    <message>
        <source>must be an object in { }</source>
        <translation>muss ein Objekt in { } sein</translation>
    </message>
    <message>
        <source>must have the key &quot;%1&quot;.</source>
        <translation>muss den Schlüssel „%1“ haben.</translation>
    </message>
    <message>
        <source>is not a known key; allowed here: %1.</source>
        <translation>ist kein bekannter Schlüssel; hier erlaubt: %1.</translation>
    </message>
    <message>
        <source>must be a list in [ ]</source>
        <translation>muss eine Liste in [ ] sein</translation>
    </message>
    <message>
        <source>must be a text in quotes that is not empty</source>
        <translation>muss ein nicht leerer Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a number between %1 and %2</source>
        <translation>muss eine Zahl zwischen %1 und %2 sein</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number between %1 and %2</source>
        <translation>muss eine ganze Zahl zwischen %1 und %2 sein</translation>
    </message>
    <message>
        <source>must be a whole number between 0 and %1</source>
        <translation>muss eine ganze Zahl zwischen 0 und %1 sein</translation>
    </message>
    <message>
        <source>must hold %1 numbers</source>
        <translation>muss %1 Zahlen enthalten</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>%1: the key &quot;%2&quot; is given twice in the same object.</source>
        <translation>%1: der Schlüssel „%2“ steht zweimal im selben Objekt.</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1: Listen und Objekte sind mehr als %2-fach verschachtelt.</translation>
    </message>
    <message>
        <source>is used twice: &quot;%1&quot;.</source>
        <translation>kommt zweimal vor: „%1“.</translation>
    </message>
    <message>
        <source>must hold the first and the last number of a stretch</source>
        <translation>muss die erste und die letzte Nummer einer Strecke enthalten</translation>
    </message>
    <message>
        <source>makes a list longer than any that this program writes</source>
        <translation>ergibt eine längere Liste, als dieses Programm je schreibt</translation>
    </message>
    <message>
        <source>must be the number of a tool part of the project</source>
        <translation>muss die Nummer eines Werkzeugteils des Projekts sein</translation>
    </message>
    <message>
        <source>must be one of those that this program knows</source>
        <translation>muss eines von denen sein, die dieses Programm kennt</translation>
    </message>
    <message>
        <source>must be the number of a part</source>
        <translation>muss die Nummer eines Teils sein</translation>
    </message>
    <message>
        <source>must have only one of the keys box_mm and objects.</source>
        <translation>darf nur einen der Schlüssel box_mm und objects haben.</translation>
    </message>
    <message>
        <source>must have at least one of the keys velocity_mm_s and turn.</source>
        <translation>muss mindestens einen der Schlüssel velocity_mm_s und turn haben.</translation>
    </message>
    <message>
        <source>must not be 0: it says which way the plane faces.</source>
        <translation>darf nicht 0 sein: es sagt, wohin die Ebene zeigt.</translation>
    </message>
    <message>
        <source>must be true.</source>
        <translation>muss true sein.</translation>
    </message>
    <message>
        <source>must have only one of the keys %1 and %2.</source>
        <translation>darf nur einen der Schlüssel %1 und %2 haben.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys %1.</source>
        <translation>muss genau einen der Schlüssel %1 haben.</translation>
    </message>
    <message>
        <source>must have either time_s or step.</source>
        <translation>muss entweder time_s oder step haben.</translation>
    </message>
    <message>
        <source>needs an event with a step; say keyframes for times.</source>
        <translation>braucht ein Ereignis mit einem Schritt (step); für Zeiten keyframes nehmen.</translation>
    </message>
    <message>
        <source>must have only one of the keys path and %1.</source>
        <translation>darf nur einen der Schlüssel path und %1 haben.</translation>
    </message>
    <message>
        <source>belongs to a change of material only.</source>
        <translation>gehört nur zu einem Wechsel des Materials.</translation>
    </message>
    <message>
        <source>must be one of %1 or a direction of 3 numbers</source>
        <translation>muss eines von %1 oder eine Richtung aus 3 Zahlen sein</translation>
    </message>
    <message>
        <source>must be a direction of 3 numbers that are not all 0</source>
        <translation>muss eine Richtung aus 3 Zahlen sein, die nicht alle 0 sind</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>muss eines von %1 sein</translation>
    </message>
    <message>
        <source>must be a path inside the output folder</source>
        <translation>muss ein Pfad innerhalb des Ausgabeordners sein</translation>
    </message>
    <message>
        <source>must end in one of %1</source>
        <translation>muss auf eines von %1 enden</translation>
    </message>
    <message>
        <source>must have either axis and speed_deg_s, or angular_velocity_rad_s.</source>
        <translation>muss entweder axis und speed_deg_s oder angular_velocity_rad_s haben.</translation>
    </message>
    <message>
        <source>must have only one of the keys angle_deg and angle_rad.</source>
        <translation>darf nur einen der Schlüssel angle_deg und angle_rad haben.</translation>
    </message>
    <message>
        <source>belongs to manipulators of the kind part only.</source>
        <translation>gehört nur zu Werkzeugen der Art part.</translation>
    </message>
    <message>
        <source>does not belong to the kind part; its file says how large it is.</source>
        <translation>gehört nicht zur Art part; deren Datei sagt, wie groß es ist.</translation>
    </message>
    <message>
        <source>must be later than the frame before it</source>
        <translation>muss später sein als das Bild davor</translation>
    </message>
    <message>
        <source>asks for a speed of %1 mm/s; speed_limit_mm_s allows %2.</source>
        <translation>verlangt eine Geschwindigkeit von %1 mm/s; speed_limit_mm_s erlaubt %2.</translation>
    </message>
    <message>
        <source>must be false where the tool is neither a ball nor a cylinder</source>
        <translation>muss false sein, wo das Werkzeug weder Kugel noch Zylinder ist</translation>
    </message>
    <message>
        <source>must have only one of the keys keyframes and motion.</source>
        <translation>darf nur einen der Schlüssel keyframes und motion haben.</translation>
    </message>
    <message>
        <source>must hold at least one frame.</source>
        <translation>muss mindestens ein Bild enthalten.</translation>
    </message>
    <message>
        <source>belongs to velocity_mm_s.</source>
        <translation>gehört zu velocity_mm_s.</translation>
    </message>
    <message>
        <source>must be true; leave it out to say another motion.</source>
        <translation>muss true sein; weglassen, um eine andere Bewegung anzugeben.</translation>
    </message>
    <message>
        <source>must hold a step and x, y, z, perhaps with w, x, y, z of a rotation</source>
        <translation>muss einen Schritt und x, y, z enthalten, dazu vielleicht w, x, y, z einer Drehung</translation>
    </message>
    <message>
        <source>must not be less than in the row before it</source>
        <translation>darf nicht kleiner sein als in der Zeile davor</translation>
    </message>
    <message>
        <source>lies further than a kilometer away.</source>
        <translation>liegt weiter als einen Kilometer entfernt.</translation>
    </message>
    <message>
        <source>must end with a quaternion of length 1</source>
        <translation>muss mit einem Quaternion der Länge 1 enden</translation>
    </message>
    <message>
        <source>must hold at least one row.</source>
        <translation>muss mindestens eine Zeile enthalten.</translation>
    </message>
    <message>
        <source>the project has no bodies.</source>
        <translation>das Projekt hat keine Körper.</translation>
    </message>
    <message>
        <source>some of its parts could not be filled with objects, which a recipe takes for an error.</source>
        <translation>manche seiner Teile ließen sich nicht mit Objekten füllen, was ein Rezept für einen Fehler hält.</translation>
    </message>
    <message>
        <source>its bodies differ in their spacing or structural friction.</source>
        <translation>seine Körper unterscheiden sich im Abstand oder in der strukturellen Reibung.</translation>
    </message>
    <message>
        <source>the files of its parts are not there any more; save the project first.</source>
        <translation>die Dateien seiner Teile sind nicht mehr da; zuerst das Projekt speichern.</translation>
    </message>
    <message>
        <source>The files that the parts were read from are not there any more: the recipe takes the parts from the project.</source>
        <translation>Die Dateien, aus denen die Teile gelesen wurden, sind nicht mehr da: das Rezept nimmt die Teile aus dem Projekt.</translation>
    </message>
    <message>
        <source>The recipe begins where the part was filled last; what was done before left nothing behind but tools, materials and fixtures.</source>
        <translation>Das Rezept beginnt dort, wo das Teil zuletzt gefüllt wurde; was davor getan wurde, ließ nur Werkzeuge, Materialien und Einspannungen zurück.</translation>
    </message>
    <message>
        <source>The project has nothing in it yet that a recipe could say.</source>
        <translation>Im Projekt gibt es noch nichts, was ein Rezept sagen könnte.</translation>
    </message>
    <message>
        <source>A recipe cannot say what was done here: %1</source>
        <translation>Ein Rezept kann nicht sagen, was hier getan wurde: %1</translation>
    </message>
    <message>
        <source>%1 is %2, which has nothing in it to set.</source>
        <translation>%1 ist %2, worin es nichts zu setzen gibt.</translation>
    </message>
    <message>
        <source>%1 has no item &quot;%2&quot;; allowed here: %3.</source>
        <translation>%1 hat keinen Eintrag „%2“; hier erlaubt: %3.</translation>
    </message>
    <message>
        <source>a whole list, since this one is empty</source>
        <translation>eine ganze Liste, da diese leer ist</translation>
    </message>
    <message>
        <source>the number 0</source>
        <translation>die Nummer 0</translation>
    </message>
    <message>
        <source>the numbers 0 to %1</source>
        <translation>die Nummern 0 bis %1</translation>
    </message>
    <message>
        <source>%1 and the names %2</source>
        <translation>%1 und die Namen %2</translation>
    </message>
    <message>
        <source>the path has an empty step; between two dots there must be a key, a name or a number.</source>
        <translation>der Pfad hat einen leeren Schritt; zwischen zwei Punkten muss ein Schlüssel, ein Name oder eine Nummer stehen.</translation>
    </message>
    <message>
        <source>the path ends with a dot; name what is to be set after it.</source>
        <translation>der Pfad endet mit einem Punkt; danach nennen, was gesetzt werden soll.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be set: %3</source>
        <translation>%1: %2 kann nicht gesetzt werden: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sets nothing; write PATH=VALUE, for example spacing_mm=3.</source>
        <translation>„%1“ setzt nichts; PFAD=WERT schreiben, zum Beispiel spacing_mm=3.</translation>
    </message>
    <message>
        <source>must have either file or files.</source>
        <translation>muss entweder file oder files haben.</translation>
    </message>
    <message>
        <source>must hold at least one file.</source>
        <translation>muss mindestens eine Datei enthalten.</translation>
    </message>
    <message>
        <source>a fixture holds no object of its body.</source>
        <translation>eine Einspannung hält kein Objekt ihres Körpers.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects.</source>
        <translation>muss genau einen der Schlüssel spacing_mm, cells_across, cells_across_wall und objects haben.</translation>
    </message>
    <message>
        <source>belongs to events: at the start nothing has been filled anew.</source>
        <translation>gehört zu Ereignissen: am Anfang ist noch nichts neu gefüllt.</translation>
    </message>
    <message>
        <source>is written twice: &quot;%1&quot;.</source>
        <translation>wird zweimal geschrieben: „%1“.</translation>
    </message>
    <message>
        <source>is &quot;published&quot;, which needs spacing_mm.</source>
        <translation>ist „published“, was spacing_mm braucht.</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is not in the recipe.</source>
        <translation>nennt „%1“, das nicht im Rezept steht.</translation>
    </message>
    <message>
        <source>must not be earlier than that of the event before it</source>
        <translation>darf nicht früher sein als beim Ereignis davor</translation>
    </message>
    <message>
        <source>must not be less than that of the event before it</source>
        <translation>darf nicht kleiner sein als beim Ereignis davor</translation>
    </message>
    <message>
        <source>must have only one of the keys duration_s and duration_steps.</source>
        <translation>darf nur einen der Schlüssel duration_s und duration_steps haben.</translation>
    </message>
    <message>
        <source>must be at most 3600 s</source>
        <translation>darf höchstens 3600 s sein</translation>
    </message>
    <message>
        <source>belongs to a dynamic analysis only.</source>
        <translation>gehört nur zu einer dynamischen Analyse.</translation>
    </message>
    <message>
        <source>belongs to a static analysis only.</source>
        <translation>gehört nur zu einer statischen Analyse.</translation>
    </message>
    <message>
        <source>names the unknown material &quot;%1&quot;; known are: %2.</source>
        <translation>nennt das unbekannte Material „%1“; bekannt sind: %2.</translation>
    </message>
    <message>
        <source>must hold at least one face.</source>
        <translation>muss mindestens eine Fläche enthalten.</translation>
    </message>
    <message>
        <source>must be the name of a material or an object in { }</source>
        <translation>muss der Name eines Materials oder ein Objekt in { } sein</translation>
    </message>
    <message>
        <source>must have both of the keys objects and objects_in_body, or none.</source>
        <translation>muss beide Schlüssel objects und objects_in_body haben, oder keinen.</translation>
    </message>
    <message>
        <source>belongs to objects.</source>
        <translation>gehört zu objects.</translation>
    </message>
    <message>
        <source>must go on upwards, below objects_in_body</source>
        <translation>muss weiter aufsteigen, unter objects_in_body</translation>
    </message>
    <message>
        <source>must hold at least one object.</source>
        <translation>muss mindestens ein Objekt enthalten.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys faces, box_mm and objects.</source>
        <translation>muss genau einen der Schlüssel faces, box_mm und objects haben.</translation>
    </message>
    <message>
        <source>must have only one of the keys angular_velocity_deg_s and angular_velocity_rad_s.</source>
        <translation>darf nur einen der Schlüssel angular_velocity_deg_s und angular_velocity_rad_s haben.</translation>
    </message>
    <message>
        <source>must hold 3 numbers no larger than %1</source>
        <translation>muss 3 Zahlen nicht größer als %1 enthalten</translation>
    </message>
    <message>
        <source>must hold the lowest x, y, z and then the highest x, y, z</source>
        <translation>muss die kleinsten x, y, z und dann die größten x, y, z enthalten</translation>
    </message>
    <message>
        <source>must hold w, x, y, z of a quaternion of length 1</source>
        <translation>muss w, x, y, z eines Quaternions der Länge 1 enthalten</translation>
    </message>
    <message>
        <source>must have only one of the keys rotation_deg and rotation_wxyz.</source>
        <translation>darf nur einen der Schlüssel rotation_deg und rotation_wxyz haben.</translation>
    </message>
    <message>
        <source>must hold %1 positive numbers</source>
        <translation>muss %1 positive Zahlen enthalten</translation>
    </message>
    <message>
        <source>names a file that does not exist: %1. The path is taken from the folder of the recipe.</source>
        <translation>nennt eine Datei, die es nicht gibt: %1. Der Pfad gilt vom Ordner des Rezepts aus.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot; is an imported part, which only a saved project keeps.</source>
        <translation>das Werkzeug „%1“ ist ein importiertes Teil, das nur ein gespeichertes Projekt behält.</translation>
    </message>
    <message>
        <source>The output folder %1 cannot be made; choose another one with --out.</source>
        <translation>Der Ausgabeordner %1 lässt sich nicht anlegen; mit --out einen anderen wählen.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; its place is in mm.</source>
        <translation>%1 liegt weit weg von allen Körpern; ihr Ort ist in mm.</translation>
    </message>
    <message>
        <source>it has no probes whose readings could be written; add the key probes.</source>
        <translation>es hat keine Sonden, deren Werte geschrieben werden könnten; den Schlüssel probes hinzufügen.</translation>
    </message>
    <message>
        <source>The probes of this recipe are read by &quot;knead run&quot;. Put probes on the part to read them here.</source>
        <translation>Die Sonden dieses Rezepts liest „knead run“. Sonden auf das Teil setzen, um sie hier abzulesen.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; names the body &quot;%1&quot;, which the part does not have.</source>
        <translation>„deform“ nennt den Körper „%1“, den das Teil nicht hat.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces; name the body that they are of.</source>
        <translation>„deform“ lässt Flächen, wo sie sind; nennen Sie den Körper, zu dem sie gehören.</translation>
    </message>
    <message>
        <source>Fields in files cannot be read here; deform by numbers, or use &quot;knead morph&quot;.</source>
        <translation>Felder in Dateien können hier nicht gelesen werden; verformen Sie mit Zahlen, oder nehmen Sie „knead morph“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not come out sound when it was deformed; look at it closely.</source>
        <translation>„%1“ kam nicht einwandfrei aus der Verformung; sehen Sie es genau an.</translation>
    </message>
    <message>
        <source>does not belong to the kind %1.</source>
        <translation>gehört nicht zur Art %1.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg, angle_rad and radius_mm.</source>
        <translation>muss genau einen der Schlüssel angle_deg, angle_rad und radius_mm haben.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg and angle_rad.</source>
        <translation>muss genau einen der Schlüssel angle_deg und angle_rad haben.</translation>
    </message>
    <message>
        <source>must point across the axis.</source>
        <translation>muss quer zur Achse zeigen.</translation>
    </message>
    <message>
        <source>must be larger than from_mm.</source>
        <translation>muss größer als from_mm sein.</translation>
    </message>
    <message>
        <source>cannot be: %1</source>
        <translation>kann nicht sein: %1</translation>
    </message>
    <message>
        <source>must have both of the keys kept_faces and fade_mm, or none.</source>
        <translation>muss beide Schlüssel kept_faces und fade_mm haben oder keinen.</translation>
    </message>
    <message>
        <source>parts beside the first that were placed cannot be written.</source>
        <translation>Teile neben dem ersten, die platziert wurden, lassen sich nicht schreiben.</translation>
    </message>
    <message>
        <source>pictures to write cannot be written into a recipe.</source>
        <translation>Bilder, die zu schreiben sind, lassen sich nicht in ein Rezept schreiben.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps face %1 of &quot;%2&quot;, which has %3; they are numbered from 0.</source>
        <translation>„deform“ hält Fläche %1 von „%2“ fest, das %3 hat; sie sind von 0 an nummeriert.</translation>
    </message>
    <message>
        <source>is so small that the bend goes around more than ten times; take a larger one.</source>
        <translation>ist so klein, dass die Biegung mehr als zehnmal herumgeht; einen größeren nehmen.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces of the body &quot;%1&quot;, which it does not deform.</source>
        <translation>„deform“ lässt Flächen des Körpers „%1“, wo sie sind, den es nicht verformt.</translation>
    </message>
    <message>
        <source>must have one of the keys neutral_mm and k_factor, or none.</source>
        <translation>muss einen der Schlüssel neutral_mm und k_factor haben oder keinen.</translation>
    </message>
    <message>
        <source>must name at least one body.</source>
        <translation>muss mindestens einen Körper nennen.</translation>
    </message>
    <message>
        <source>must have one item for each object</source>
        <translation>muss für jedes Objekt einen Eintrag haben</translation>
    </message>
    <message>
        <source>cannot be done by physics, since grips do not change the ends; say it in &quot;deform&quot;.</source>
        <translation>kann nicht durch Physik geschehen, da Griffe die Enden nicht ändern; in „deform“ angeben.</translation>
    </message>
    <message>
        <source>its parts were deformed after they were kneaded, or by a field whose file is not there any more, or others were added, and only a project keeps them so; save the project first.</source>
        <translation>ihre Teile wurden verformt, nachdem sie geknetet wurden, oder durch ein Feld, dessen Datei nicht mehr da ist, oder es kamen andere hinzu, und nur ein Projekt bewahrt sie so; speichern Sie zuerst das Projekt.</translation>
    </message>
    <message>
        <source>The parts were deformed by numbers or by a field, or others were added: the recipe takes them from the project, as they were then.</source>
        <translation>Die Teile wurden durch Zahlen oder durch ein Feld verformt, oder es kamen andere hinzu: das Rezept nimmt sie aus dem Projekt, wie sie dann waren.</translation>
    </message>
</context>
<context>
    <name>RecipesFeature</name>
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Ein Rezept wird allein geöffnet: eine Datei oder nur Teile wählen.</translation>
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
    <message>
        <source>The recipe names files to export: %1.</source>
        <translation>Das Rezept nennt Dateien zum Exportieren: %1.</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren...</translation>
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
        <translation>Noch ist nichts aufzunehmen: Starten drücken und etwas geschehen lassen.</translation>
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
        <translation>Wiederhergestelltes öffnet sich ungespeichert und bleibt hier, bis es gespeichert oder verworfen wird.</translation>
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
    <message>
        <source>Face &quot;%1&quot;, %2</source>
        <translation>Fläche „%1“, %2</translation>
    </message>
</context>
<context>
    <name>Repair</name>
    <message>
        <source>The exact shapes of the parts cannot be understood; import the file again.</source>
        <translation>Die exakten Formen der Teile sind nicht zu verstehen; die Datei noch einmal importieren.</translation>
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
        <source>%1 in %2, %3 long in all; the largest opening is %4 across and flat</source>
        <translation>%1 in %2, zusammen %3 lang; die größte Öffnung misst %4 und ist eben</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across</source>
        <translation>%1 in %2, zusammen %3 lang; die größte Öffnung misst %4</translation>
    </message>
</context>
<context>
    <name>Run</name>
    <message>
        <source>The equations of %1 of %2 steps could not be solved: forces and places are not to be trusted there. Make tools slower, or choose a shorter time step.</source>
        <translation>Die Gleichungen von %1 der %2 Schritte ließen sich nicht lösen: Kräften und Lagen ist dort nicht zu trauen. Werkzeuge verlangsamen oder einen kürzeren Zeitschritt wählen.</translation>
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
        <source>&quot;%1&quot; broke into %2 pieces, and a rigid body would weld them together where they are. Keep it deformable, or reset before it becomes rigid.</source>
        <translation>„%1“ zerbrach in %2 Stücke, und ein starrer Körper würde sie dort verschweißen, wo sie sind. Ihn verformbar lassen oder zurücksetzen, bevor er starr wird.</translation>
    </message>
    <message>
        <source>The simulation was stopped at %1 s: %2 It went back to %3 s.</source>
        <translation>Die Simulation wurde bei %1 s angehalten: %2 Sie ging auf %3 s zurück.</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>der Körper</translation>
    </message>
    <message>
        <source>material of %1 was squashed flat or turned inside out. Press less far, raise Poisson&apos;s ratio or the yield stress, or fill the part with a smaller spacing, then reset.</source>
        <translation>Material von %1 wurde flach gedrückt oder umgestülpt. Weniger weit drücken, die Querkontraktionszahl oder die Fließgrenze erhöhen oder das Teil mit kleinerem Abstand füllen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>a position is no longer a number. %1 or make the material softer, then reset.</source>
        <translation>eine Lage ist keine Zahl mehr. %1 oder das Material weicher machen, dann zurücksetzen.</translation>
    </message>
    <message>
        <source>the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, or a softer or more damped material.</source>
        <translation>der gewählte Zeitschritt von %1 s ist länger als der stabile von %2 s. Einen kürzeren wählen oder ein weicheres oder stärker gedämpftes Material.</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Implizites Euler</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Vorwärts-Euler</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1: gewählt; explizite Integration braucht %2 Schritte je Sekunde, was mit der Echtzeit mithält.</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1: gewählt; explizite Integration braucht %2 Schritte je Sekunde, mehr als Echtzeit erlaubt.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1: explizite Integration braucht %2 Schritte je Sekunde, was mit der Echtzeit mithält.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1: explizite Integration braucht %2 Schritte je Sekunde, mehr als Echtzeit erlaubt.</translation>
    </message>
    <message>
        <source>The equations of the step at %1 s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter time step.</source>
        <translation>Die Gleichungen des Schrittes bei %1 s ließen sich nicht lösen: Kräfte und Lagen sind von dort an ungenau. Werkzeuge verlangsamen oder einen kürzeren Zeitschritt wählen.</translation>
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
        <translation>Das Werkzeug „%1“ steckt %2 mm tief in %3: es außerhalb beginnen lassen, weniger weit drücken, es verlangsamen</translation>
    </message>
    <message>
        <source>Choose a shorter time step for mass scaling, which added %1 % to the mass</source>
        <translation>Einen kürzeren Zeitschritt für die Massenskalierung wählen, die %1 % zur Masse hinzufügte</translation>
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
        <source>The tool &quot;%1&quot; begins %2 mm inside %3, which is pushed away with great force, in very short steps. Let it begin outside.</source>
        <translation>Das Werkzeug „%1“ beginnt %2 mm tief in %3, was mit großer Kraft und in sehr kurzen Schritten weggedrückt wird. Es außerhalb beginnen lassen.</translation>
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
    <name>Scene</name>
    <message>
        <source>Gravity must not be stronger than 10000 m/s^2.</source>
        <translation>Die Schwerkraft darf nicht stärker als 10000 m/s^2 sein.</translation>
    </message>
    <message>
        <source>The height of the floor must lie between -10 and 10 km.</source>
        <translation>Die Höhe des Bodens muss zwischen -10 und 10 km liegen.</translation>
    </message>
    <message>
        <source>The friction of the floor must lie between 0 and 2.</source>
        <translation>Die Reibung des Bodens muss zwischen 0 und 2 liegen.</translation>
    </message>
    <message>
        <source>The adhesion of the floor must lie between 0 and 1e9 Pa.</source>
        <translation>Die Haftung des Bodens muss zwischen 0 und 1e9 Pa liegen.</translation>
    </message>
    <message>
        <source>There is no body number %1.</source>
        <translation>Es gibt keinen Körper Nummer %1.</translation>
    </message>
    <message>
        <source>It holds no objects. Fill it with a smaller spacing.</source>
        <translation>Er enthält keine Objekte. Ihn mit einem kleineren Abstand füllen.</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot;: %2</source>
        <translation>Bereich „%1“: %2</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot; names an object that does not exist.</source>
        <translation>Der Bereich „%1“ nennt ein Objekt, das es nicht gibt.</translation>
    </message>
    <message>
        <source>It must not start faster than 1000 m/s or 100000 rad/s.</source>
        <translation>Er darf nicht schneller als 1000 m/s oder 100000 rad/s beginnen.</translation>
    </message>
    <message>
        <source>Its structural friction must lie between 0 and 2.</source>
        <translation>Seine innere Reibung muss zwischen 0 und 2 liegen.</translation>
    </message>
    <message>
        <source>Body &quot;%1&quot;: %2</source>
        <translation>Körper „%1“: %2</translation>
    </message>
    <message>
        <source>The time step must lie between 1e-9 and 1 s.</source>
        <translation>Der Zeitschritt muss zwischen 1e-9 und 1 s liegen.</translation>
    </message>
    <message>
        <source>The time step of mass scaling must lie between 1e-9 and 1 s.</source>
        <translation>Der Zeitschritt der Massenskalierung muss zwischen 1e-9 und 1 s liegen.</translation>
    </message>
    <message>
        <source>Forward Euler is not stable without damping: raise the damping ratio, or use semi-implicit Euler.</source>
        <translation>Vorwärts-Euler ist ohne Dämpfung nicht stabil: den Dämpfungsgrad erhöhen oder semi-implizites Euler nehmen.</translation>
    </message>
</context>
<context>
    <name>SculptHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties, or push it with a tool.</source>
        <translation>%1 verformt sich nicht: es in den Eigenschaften verformbar machen, oder es mit einem Werkzeug drücken.</translation>
    </message>
    <message>
        <source>%1 is held at this place: free it with Fix faces, or take another place.</source>
        <translation>%1 wird an dieser Stelle gehalten: mit „Flächen fixieren“ freigeben, oder eine andere Stelle nehmen.</translation>
    </message>
    <message>
        <source>%1, force %2 %</source>
        <translation>%1, Kraft %2 %</translation>
    </message>
    <message>
        <source>%1 (limit; + for more)</source>
        <translation>%1 (Grenze; + für mehr)</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>An %1 ziehen</translation>
    </message>
    <message>
        <source>Thumb on %1</source>
        <translation>Daumen auf %1</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 glätten</translation>
    </message>
    <message>
        <source>Flatten %1</source>
        <translation>%1 abflachen</translation>
    </message>
    <message>
        <source>Pinch %1</source>
        <translation>%1 zusammenkneifen</translation>
    </message>
    <message>
        <source>Smear %1</source>
        <translation>%1 verschmieren</translation>
    </message>
    <message>
        <source>Bend %1</source>
        <translation>%1 biegen</translation>
    </message>
    <message>
        <source>Twist %1</source>
        <translation>%1 verdrehen</translation>
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
    <message>
        <source>Select something first.</source>
        <translation>Zuerst etwas auswählen.</translation>
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
        <translation>Eine Auswahl braucht einen Namen: einen tippen, dann speichern.</translation>
    </message>
    <message>
        <source>Name of the selection</source>
        <translation>Name der Auswahl</translation>
    </message>
</context>
<context>
    <name>Session field</name>
    <message>
        <source>&quot;%1&quot; is cracked, cut or in pieces there, and a field cannot tear: it says what became of the largest piece, as if it were whole.</source>
        <translation>„%1“ ist dort gerissen, geschnitten oder in Stücken, und ein Feld kann nicht reißen: Es sagt, was aus dem größten Stück wurde, als wäre es ganz.</translation>
    </message>
    <message>
        <source>this is no project of Knead.</source>
        <translation>das ist kein Projekt von Knead.</translation>
    </message>
    <message>
        <source>nothing has moved at its entry %1: there is no field.</source>
        <translation>bei seinem Eintrag %1 hat sich nichts bewegt: Es gibt kein Feld.</translation>
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
        <translation>%1 %2: eine andere Taste wählen.</translation>
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
        <translation>Die Schnittebene einschalten (Umschalt+S) und dorthin setzen, wo geschnitten werden soll.</translation>
    </message>
    <message>
        <source>Fill finer</source>
        <translation>Feiner füllen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Pause first.</source>
        <translation>Zuerst anhalten.</translation>
    </message>
    <message>
        <source>Only a part to which nothing was done yet is pressed like this.</source>
        <translation>Nur ein Teil, mit dem noch nichts getan wurde, wird so gedrückt.</translation>
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
        <source>Come back to the present first: Esc.</source>
        <translation>Zuerst in die Gegenwart zurückkehren: Esc.</translation>
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
    <name>Stage</name>
    <message>
        <source>checking the surface</source>
        <translation>Oberfläche wird geprüft</translation>
    </message>
    <message>
        <source>preparing the surface</source>
        <translation>Oberfläche wird vorbereitet</translation>
    </message>
    <message>
        <source>preparing the simulation</source>
        <translation>Simulation wird vorbereitet</translation>
    </message>
    <message>
        <source>placing objects</source>
        <translation>Objekte werden gesetzt</translation>
    </message>
    <message>
        <source>cutting cells</source>
        <translation>Zellen werden geschnitten</translation>
    </message>
    <message>
        <source>measuring depth</source>
        <translation>Tiefe wird gemessen</translation>
    </message>
    <message>
        <source>measuring walls</source>
        <translation>Wände werden gemessen</translation>
    </message>
    <message>
        <source>fitting walls</source>
        <translation>Wände werden angepasst</translation>
    </message>
    <message>
        <source>looking for crossings</source>
        <translation>Durchdringungen werden gesucht</translation>
    </message>
    <message>
        <source>attaching the surface</source>
        <translation>Oberfläche wird angeheftet</translation>
    </message>
    <message>
        <source>cutting the surface</source>
        <translation>Oberfläche wird geschnitten</translation>
    </message>
    <message>
        <source>finding the cracks</source>
        <translation>Risse werden gesucht</translation>
    </message>
    <message>
        <source>smoothing the cracks</source>
        <translation>Risse werden geglättet</translation>
    </message>
    <message>
        <source>repeating</source>
        <translation>Wiederholung läuft</translation>
    </message>
    <message>
        <source>finding the balance</source>
        <translation>Gleichgewicht wird gesucht</translation>
    </message>
    <message>
        <source>reading the file</source>
        <translation>Datei wird gelesen</translation>
    </message>
    <message>
        <source>looking into the file</source>
        <translation>Datei wird angesehen</translation>
    </message>
    <message>
        <source>making shapes</source>
        <translation>Formen werden gebildet</translation>
    </message>
    <message>
        <source>making triangles</source>
        <translation>Dreiecke werden gebildet</translation>
    </message>
    <message>
        <source>healing parts</source>
        <translation>Teile werden repariert</translation>
    </message>
    <message>
        <source>checking parts</source>
        <translation>Teile werden geprüft</translation>
    </message>
    <message>
        <source>measuring parts</source>
        <translation>Teile werden gemessen</translation>
    </message>
    <message>
        <source>keeping the exact shapes</source>
        <translation>Genaue Formen werden behalten</translation>
    </message>
    <message>
        <source>handing the parts over</source>
        <translation>Teile werden übergeben</translation>
    </message>
    <message>
        <source>handing over</source>
        <translation>Übergabe läuft</translation>
    </message>
    <message>
        <source>bending the surface</source>
        <translation>Oberfläche wird gebogen</translation>
    </message>
    <message>
        <source>bending edges</source>
        <translation>Kanten werden gebogen</translation>
    </message>
    <message>
        <source>bending faces</source>
        <translation>Flächen werden gebogen</translation>
    </message>
    <message>
        <source>measuring tolerances</source>
        <translation>Toleranzen werden gemessen</translation>
    </message>
    <message>
        <source>measuring distances</source>
        <translation>Abstände werden gemessen</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>Prüfung läuft</translation>
    </message>
    <message>
        <source>comparing with the skin</source>
        <translation>Vergleich mit der Haut</translation>
    </message>
    <message>
        <source>writing faces</source>
        <translation>Flächen werden geschrieben</translation>
    </message>
    <message>
        <source>writing triangles</source>
        <translation>Dreiecke werden geschrieben</translation>
    </message>
    <message>
        <source>writing the file</source>
        <translation>Datei wird geschrieben</translation>
    </message>
    <message>
        <source>opening the project</source>
        <translation>Projekt wird geöffnet</translation>
    </message>
    <message>
        <source>opening the history</source>
        <translation>Verlauf wird geöffnet</translation>
    </message>
    <message>
        <source>saving the parts</source>
        <translation>Teile werden gespeichert</translation>
    </message>
    <message>
        <source>saving the history</source>
        <translation>Verlauf wird gespeichert</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>dividing faces</source>
        <translation>Flächen werden geteilt</translation>
    </message>
    <message>
        <source>fitting the field</source>
        <translation>das Feld wird angepasst</translation>
    </message>
    <message>
        <source>comparing the field with the parts</source>
        <translation>das Feld wird mit den Teilen verglichen</translation>
    </message>
    <message>
        <source>placing the scan</source>
        <translation>der Scan wird angelegt</translation>
    </message>
    <message>
        <source>comparing the scan with the part</source>
        <translation>der Scan wird mit dem Teil verglichen</translation>
    </message>
    <message>
        <source>finding the faces again</source>
        <translation>Flächen werden wiedergefunden</translation>
    </message>
    <message>
        <source>moving the grips</source>
        <translation>Griffe bewegen</translation>
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
    <name>Step</name>
    <message>
        <source>the STEP file ends inside a text; it is cut off, get it again.</source>
        <translation>die STEP-Datei endet innerhalb eines Textes; sie ist abgeschnitten, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the STEP file ends before its last line (END-ISO-10303-21); it is cut off, get it again.</source>
        <translation>die STEP-Datei endet vor ihrer letzten Zeile (END-ISO-10303-21); sie ist abgeschnitten, noch einmal besorgen.</translation>
    </message>
    <message>
        <source>the STEP file has no DATA section, so it holds no shapes.</source>
        <translation>die STEP-Datei hat keinen Abschnitt DATA, also enthält sie keine Formen.</translation>
    </message>
    <message>
        <source>a name in the STEP file is longer than 65 thousand letters; the file is damaged.</source>
        <translation>ein Name in der STEP-Datei ist länger als 65 tausend Zeichen; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>lists in the STEP file are nested more than 500 deep; the file is damaged.</source>
        <translation>Listen in der STEP-Datei sind mehr als 500-fach verschachtelt; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>the STEP file has &quot;%1&quot; in place of a number; export it again.</source>
        <translation>in der STEP-Datei steht „%1“ an der Stelle einer Zahl; noch einmal exportieren.</translation>
    </message>
    <message>
        <source>%1: a turned face is bounded across its seam, and the file does not tell on which side of its border it lies; check the volume of its part.</source>
        <translation>%1: Eine gedrehte Fläche ist über ihre Naht hinweg begrenzt, und die Datei sagt nicht, auf welcher Seite ihres Randes sie liegt; das Volumen ihres Teils ist zu prüfen.</translation>
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
        <source>the entity %1 refers to something of the wrong kind or nothing at all; export the file again.</source>
        <translation>das Element %1 verweist auf etwas Falsches oder auf nichts; die Datei noch einmal exportieren.</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: %2).</source>
        <translation>das Element %1 verweist auf etwas Falsches oder auf nichts; was es braucht, konnte nicht gelesen werden (Flächen: %2).</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (shapes: %2).</source>
        <translation>das Element %1 verweist auf etwas Falsches oder auf nichts; was es braucht, konnte nicht gelesen werden (Formen: %2).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (faces: %3).</source>
        <translation>das Element %1 und %2 weitere verweisen auf etwas Falsches oder auf nichts; was sie braucht, konnte nicht gelesen werden (Flächen: %3).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (shapes: %3).</source>
        <translation>das Element %1 und %2 weitere verweisen auf etwas Falsches oder auf nichts; was sie braucht, konnte nicht gelesen werden (Formen: %3).</translation>
    </message>
    <message>
        <source>the assembly refers to the file %1, which is not there: its parts are missing. Put it beside the assembly and open that again.</source>
        <translation>die Baugruppe verweist auf die Datei %1, die es dort nicht gibt: ihre Teile fehlen. Die Datei neben die Baugruppe legen und diese noch einmal öffnen.</translation>
    </message>
    <message>
        <source>the assembly refers to %1 files that are not there: %2. Their parts are missing; put them beside the assembly and open that again.</source>
        <translation>die Baugruppe verweist auf %1 Dateien, die es dort nicht gibt: %2. Ihre Teile fehlen; sie neben die Baugruppe legen und diese noch einmal öffnen.</translation>
    </message>
    <message>
        <source>the file holds triangles only (tessellated geometry of AP242), which are not read from STEP; export exact solids, or a mesh as 3MF or STL.</source>
        <translation>die Datei enthält nur Dreiecke (tessellierte Geometrie von AP242), die aus STEP nicht gelesen werden; exakte Körper exportieren, oder ein Netz als 3MF oder STL.</translation>
    </message>
    <message>
        <source>the file holds curves and points only, no solid and no surface; export the part as a solid.</source>
        <translation>die Datei enthält nur Kurven und Punkte, keinen Körper und keine Fläche; das Teil als Körper exportieren.</translation>
    </message>
    <message>
        <source>the assembly refers to %1, which is no ordinary file in its folder; put the file beside the assembly and open that again.</source>
        <translation>die Baugruppe verweist auf %1, das keine gewöhnliche Datei in ihrem Ordner ist; die Datei neben die Baugruppe legen und diese noch einmal öffnen.</translation>
    </message>
</context>
<context>
    <name>Study</name>
    <message>
        <source>must name a face; leave the part out where none counts.</source>
        <translation>muss eine Fläche nennen; das Teil weglassen, wo keine zählt.</translation>
    </message>
    <message>
        <source>must name a part; leave the key out where all faces count.</source>
        <translation>muss ein Teil nennen; den Schlüssel weglassen, wo alle Flächen zählen.</translation>
    </message>
    <message>
        <source>must be the name of a file in the folder of the round, without folders</source>
        <translation>muss der Name einer Datei im Ordner der Runde sein, ohne Ordner</translation>
    </message>
    <message>
        <source>has the name of another one; all of them go into one folder.</source>
        <translation>heißt wie eine andere; alle kommen in einen Ordner.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys recipe and command.</source>
        <translation>muss genau einen der Schlüssel recipe und command haben.</translation>
    </message>
    <message>
        <source>must have the key &quot;field&quot;: the file that the command writes.</source>
        <translation>muss den Schlüssel „field“ haben: die Datei, die der Befehl schreibt.</translation>
    </message>
    <message>
        <source>belongs to a command; a recipe needs none.</source>
        <translation>gehört zu einem Befehl; ein Rezept braucht das nicht.</translation>
    </message>
</context>
<context>
    <name>Synonyms</name>
    <message>
        <source>revert, back, take back, mistake</source>
        <translation>zurück, widerrufen, Fehler</translation>
    </message>
    <message>
        <source>again, forward, repeat</source>
        <translation>nochmals, vorwärts</translation>
    </message>
    <message>
        <source>load, import, file, read</source>
        <translation>laden, importieren, Datei, lesen</translation>
    </message>
    <message>
        <source>write, store, keep, project</source>
        <translation>sichern, schreiben, behalten, Projekt</translation>
    </message>
    <message>
        <source>write as, copy, duplicate</source>
        <translation>sichern unter, Kopie</translation>
    </message>
    <message>
        <source>STEP, IGES, STL, mesh, 3D print, print, write, convert, CAD</source>
        <translation>STEP, IGES, STL, Netz, 3D-Druck, drucken, schreiben, umwandeln, CAD</translation>
    </message>
    <message>
        <source>script, macro, batch, automate</source>
        <translation>Skript, Makro, automatisieren</translation>
    </message>
    <message>
        <source>screenshot, image, photo, snapshot, PNG, JPEG, render</source>
        <translation>Bildschirmfoto, Foto, Aufnahme, PNG, JPEG</translation>
    </message>
    <message>
        <source>movie, film, animation, screencast, clip</source>
        <translation>Film, Animation, Bildschirmaufnahme</translation>
    </message>
    <message>
        <source>frames, image sequence</source>
        <translation>Einzelbilder, Bildfolge</translation>
    </message>
    <message>
        <source>demo, show me</source>
        <translation>Vorführung, zeig es</translation>
    </message>
    <message>
        <source>push, squeeze, poke</source>
        <translation>schieben, quetschen</translation>
    </message>
    <message>
        <source>drag, tug, stretch, grab</source>
        <translation>zerren, dehnen, greifen</translation>
    </message>
    <message>
        <source>sculpt, mold, mould, clay, knead, dent, finger, groove</source>
        <translation>modellieren, formen, Ton, kneten, Delle, Finger, Rille</translation>
    </message>
    <message>
        <source>polish, even out, relax</source>
        <translation>polieren, ebnen</translation>
    </message>
    <message>
        <source>flat, plane, iron</source>
        <translation>flach, eben, bügeln</translation>
    </message>
    <message>
        <source>crease, ridge, gather</source>
        <translation>kneifen, Grat, Falte</translation>
    </message>
    <message>
        <source>smudge, spread</source>
        <translation>verwischen, streichen</translation>
    </message>
    <message>
        <source>fold, curve</source>
        <translation>falten, krümmen</translation>
    </message>
    <message>
        <source>wring, turn, screw</source>
        <translation>wringen, drehen</translation>
    </message>
    <message>
        <source>mirror, both sides</source>
        <translation>spiegeln, beide Seiten</translation>
    </message>
    <message>
        <source>orbit, rotate view, turn view, pan, navigate, gestures</source>
        <translation>Orbit, Ansicht drehen, umkreisen, verschieben, navigieren</translation>
    </message>
    <message>
        <source>zoom, zoom to fit, center, frame, whole part</source>
        <translation>Zoom, zoomen, zentrieren, ganzes Teil</translation>
    </message>
    <message>
        <source>3D view, default view</source>
        <translation>3D-Ansicht, Standardansicht</translation>
    </message>
    <message>
        <source>orthographic, parallel, projection</source>
        <translation>orthografisch, parallel, Projektion</translation>
    </message>
    <message>
        <source>join, bond, stick, weld, attach, fuse</source>
        <translation>verbinden, kleben, verkleben, schweißen, Leim</translation>
    </message>
    <message>
        <source>cut, slice, blade, split, saw</source>
        <translation>schneiden, Klinge, teilen, sägen</translation>
    </message>
    <message>
        <source>cheese wire, cut</source>
        <translation>Schneidedraht, schneiden</translation>
    </message>
    <message>
        <source>slice, split, saw, divide, halve</source>
        <translation>zerschneiden, teilen, sägen, halbieren</translation>
    </message>
    <message>
        <source>cross section, clip, cutaway, look inside</source>
        <translation>Querschnitt, hineinsehen, aufgeschnitten</translation>
    </message>
    <message>
        <source>box, cube, punch, stamp</source>
        <translation>Quader, Würfel, Stempel</translation>
    </message>
    <message>
        <source>sphere, bead</source>
        <translation>Sphäre, Murmel</translation>
    </message>
    <message>
        <source>rolling pin, roll out</source>
        <translation>Nudelholz, ausrollen, Walze</translation>
    </message>
    <message>
        <source>clamp, hold, anchor, pin, constrain, support, vise</source>
        <translation>einspannen, festhalten, verankern, lagern, Schraubstock</translation>
    </message>
    <message>
        <source>measure, ruler, length, gap, dimension, caliper</source>
        <translation>messen, Lineal, Länge, Lücke, Maß, Messschieber</translation>
    </message>
    <message>
        <source>weight, mass, how heavy</source>
        <translation>Gewicht, Masse, wie schwer</translation>
    </message>
    <message>
        <source>size, extent, width, height</source>
        <translation>Größe, Ausdehnung, Breite, Höhe</translation>
    </message>
    <message>
        <source>difference, deviation, report</source>
        <translation>Unterschied, Abweichung, Bericht</translation>
    </message>
    <message>
        <source>sensor, strain gauge</source>
        <translation>Sensor, Dehnungsmessstreifen</translation>
    </message>
    <message>
        <source>graph, chart, curve</source>
        <translation>Kurve, Graph</translation>
    </message>
    <message>
        <source>CSV, spreadsheet, data</source>
        <translation>CSV, Tabellenkalkulation, Daten</translation>
    </message>
    <message>
        <source>fall, drop, heavy</source>
        <translation>fallen, schwer</translation>
    </message>
    <message>
        <source>ground, table</source>
        <translation>Grund, Tisch</translation>
    </message>
    <message>
        <source>run, start, simulate, pause, stop</source>
        <translation>laufen, simulieren, anhalten, Pause</translation>
    </message>
    <message>
        <source>start over, rewind, restart</source>
        <translation>von vorn, zurückspulen, neu beginnen</translation>
    </message>
    <message>
        <source>equilibrium, settle, static</source>
        <translation>Ruhe, statisch</translation>
    </message>
    <message>
        <source>forget shape, accept shape</source>
        <translation>Form vergessen, Form annehmen</translation>
    </message>
    <message>
        <source>remesh, resolution</source>
        <translation>neu vernetzen, Auflösung</translation>
    </message>
    <message>
        <source>real time, slow, faster</source>
        <translation>langsam, schneller</translation>
    </message>
    <message>
        <source>help, manual, documentation, guide, how to</source>
        <translation>Hilfe, Anleitung, Dokumentation</translation>
    </message>
    <message>
        <source>tutorial, learn, getting started, introduction, first steps</source>
        <translation>Tutorial, lernen, Einführung, erste Schritte</translation>
    </message>
    <message>
        <source>hotkeys, key bindings, keymap</source>
        <translation>Hotkeys, Tastenbelegung, Kurzbefehle</translation>
    </message>
    <message>
        <source>settings, options, language, units, translation</source>
        <translation>Optionen, Sprache, Einheiten, Übersetzung</translation>
    </message>
    <message>
        <source>dark mode, night mode, black</source>
        <translation>dunkler Modus, Nachtmodus, schwarz</translation>
    </message>
    <message>
        <source>light mode, day mode, white</source>
        <translation>heller Modus, Tagmodus, weiß</translation>
    </message>
    <message>
        <source>new document, second window</source>
        <translation>neues Dokument, zweites Fenster</translation>
    </message>
    <message>
        <source>home, start page, welcome, examples</source>
        <translation>Startseite, Willkommen, Beispiele</translation>
    </message>
    <message>
        <source>crash, restore, lost work, autosave</source>
        <translation>Absturz, retten, verlorene Arbeit</translation>
    </message>
    <message>
        <source>delete, erase</source>
        <translation>löschen, tilgen</translation>
    </message>
    <message>
        <source>invisible, conceal</source>
        <translation>unsichtbar, ausblenden</translation>
    </message>
    <message>
        <source>unhide, visible</source>
        <translation>einblenden, sichtbar</translation>
    </message>
    <message>
        <source>only this, solo</source>
        <translation>nur dies, allein</translation>
    </message>
    <message>
        <source>spheres, particles</source>
        <translation>Kugeln, Partikel</translation>
    </message>
    <message>
        <source>lines, outline</source>
        <translation>Linien, Umriss</translation>
    </message>
    <message>
        <source>maximize, presentation</source>
        <translation>maximieren, Präsentation</translation>
    </message>
    <message>
        <source>version, license, credits</source>
        <translation>Version, Lizenz</translation>
    </message>
    <message>
        <source>search, find action</source>
        <translation>suchen, Aktion finden</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>schließen, verlassen</translation>
    </message>
    <message>
        <source>name, call</source>
        <translation>nennen, Name</translation>
    </message>
    <message>
        <source>paint, colour, tint</source>
        <translation>färben, anmalen, Anstrich</translation>
    </message>
    <message>
        <source>protect, freeze</source>
        <translation>schützen, einfrieren</translation>
    </message>
    <message>
        <source>undeformed, ghost</source>
        <translation>unverformt</translation>
    </message>
    <message>
        <source>move, rotate, arrows, transform</source>
        <translation>bewegen, drehen, Pfeile</translation>
    </message>
    <message>
        <source>WASD, keyboard control</source>
        <translation>WASD, Tastatursteuerung</translation>
    </message>
    <message>
        <source>3Dconnexion, SpaceMouse, joystick</source>
        <translation>3Dconnexion, SpaceMouse, Joystick</translation>
    </message>
    <message>
        <source>assembly, insert, merge</source>
        <translation>Baugruppe, einfügen</translation>
    </message>
    <message>
        <source>threads, slow motion, speed</source>
        <translation>Threads, Zeitlupe, Geschwindigkeit</translation>
    </message>
    <message>
        <source>fps, frame rate, profiler</source>
        <translation>fps, Bildrate</translation>
    </message>
    <message>
        <source>material, stiffness, rubber, steel</source>
        <translation>Werkstoff, Material, Steifigkeit, Gummi, Stahl</translation>
    </message>
    <message>
        <source>revision, version, transfer, repeat, other part</source>
        <translation>Revision, Version, übertragen, wiederholen, anderes Teil</translation>
    </message>
    <message>
        <source>flex, morph, warp, deformer, free form, global modeling</source>
        <translation>flexen, morphen, verziehen, Freiform, umformen</translation>
    </message>
    <message>
        <source>flex, curl, arc, curve, sheet metal, k-factor, tube, roll</source>
        <translation>krümmen, Bogen, Kurve, Blech, k-Faktor, Rohr, rollen, abkanten</translation>
    </message>
    <message>
        <source>wring, flex, screw, turn, helix, torsion</source>
        <translation>wringen, Schraube, drehen, Helix, Torsion, tordieren</translation>
    </message>
    <message>
        <source>flex, cone, draft, narrow, widen</source>
        <translation>Kegel, Konus, Formschräge, schmaler, breiter</translation>
    </message>
    <message>
        <source>flex, lengthen, shorten, elongate, compress</source>
        <translation>verlängern, verkürzen, dehnen, stauchen</translation>
    </message>
    <message>
        <source>offset, skew, slant, joggle, sideways</source>
        <translation>Versatz, schräg, kröpfen, seitwärts</translation>
    </message>
    <message>
        <source>enlarge, shrink, size, grow</source>
        <translation>vergrößern, verkleinern, Größe, wachsen</translation>
    </message>
    <message>
        <source>displacements, FEM, FEA, CalculiX, Abaqus, warpage, springback, compensation, morph, field, vtu, frd</source>
        <translation>Verschiebungen, FEM, CalculiX, Abaqus, Verzug, Rückfederung, Kompensation, Morphing, Feld, vtu, frd</translation>
    </message>
    <message>
        <source>script, macro, code, program, automate, journal</source>
        <translation>Skript, Makro, Code, Programm, automatisieren, Protokoll, mitschreiben</translation>
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
        <translation>%1: der Speicher reicht nicht. Andere Programme schließen, oder einen größeren Abstand wählen.</translation>
    </message>
</context>
<context>
    <name>TextFiles</name>
    <message>
        <source>%1 cannot be written (%2). Choose another folder, or make room on the disk.</source>
        <translation>%1 kann nicht geschrieben werden (%2). Einen anderen Ordner wählen, oder Platz auf dem Datenträger schaffen.</translation>
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
    <message>
        <source>no film kept</source>
        <translation>kein Film aufbewahrt</translation>
    </message>
    <message>
        <source>Double-click: go there</source>
        <translation>Doppelklick: dorthin gehen</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1, Eintrag %2</translation>
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
        <translation>Abspielen, was simuliert wurde, vom Ort des Rückblicks an</translation>
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
        <translation>Vom Gezeigten aus weitermachen: ein neuer Zweig des Verlaufs</translation>
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
        <translation>Zuerst etwas simulieren und darauf zurücksehen.</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Geschwindigkeit des Films</translation>
    </message>
    <message>
        <source>Projects keep entries and no film: go to one with a double click, or simulate on.</source>
        <translation>Projekte bewahren Einträge und keinen Film: Mit einem Doppelklick zu einem gehen oder weiter simulieren.</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Tool &quot;%1&quot;: %2</source>
        <translation>Werkzeug „%1“: %2</translation>
    </message>
    <message>
        <source>each edge must be between 0.001 mm and 1000 m long.</source>
        <translation>jede Kante muss zwischen 0.001 mm und 1000 m lang sein.</translation>
    </message>
    <message>
        <source>it is to be a part, but has none.</source>
        <translation>es soll ein Teil sein, hat aber keins.</translation>
    </message>
    <message>
        <source>its measures do not fit together: a ball has one, a cylinder a diameter and a length.</source>
        <translation>seine Maße passen nicht zusammen: eine Kugel hat eines, ein Zylinder einen Durchmesser und eine Länge.</translation>
    </message>
    <message>
        <source>its place must be numbers, within 10 km.</source>
        <translation>sein Ort muss aus Zahlen bestehen, innerhalb von 10 km.</translation>
    </message>
    <message>
        <source>friction must lie between 0 and 2.</source>
        <translation>die Reibung muss zwischen 0 und 2 liegen.</translation>
    </message>
    <message>
        <source>the speed limit must lie between 0.001 mm/s and 100 m/s.</source>
        <translation>die Höchstgeschwindigkeit muss zwischen 0.001 mm/s und 100 m/s liegen.</translation>
    </message>
    <message>
        <source>the adhesion must lie between 0 and 1e9 Pa.</source>
        <translation>die Haftung muss zwischen 0 und 1e9 Pa liegen.</translation>
    </message>
    <message>
        <source>the force limit must be greater than 0 N.</source>
        <translation>die Höchstkraft muss größer als 0 N sein.</translation>
    </message>
    <message>
        <source>a key-framed motion needs at least one frame.</source>
        <translation>eine Bewegung nach Schlüsselbildern braucht mindestens ein Bild.</translation>
    </message>
    <message>
        <source>the times of key frames must ascend.</source>
        <translation>die Zeiten der Schlüsselbilder müssen ansteigen.</translation>
    </message>
    <message>
        <source>key frames must be numbers, within 10 km.</source>
        <translation>Schlüsselbilder müssen aus Zahlen bestehen, innerhalb von 10 km.</translation>
    </message>
    <message>
        <source>it must not go faster than 10000 m/s or 100000 rad/s.</source>
        <translation>es darf nicht schneller als 10000 m/s oder 100000 rad/s sein.</translation>
    </message>
    <message>
        <source>its target must be numbers, within 10 km.</source>
        <translation>sein Ziel muss aus Zahlen bestehen, innerhalb von 10 km.</translation>
    </message>
    <message>
        <source>The tool&apos;s part has no surface. Choose another file.</source>
        <translation>Das Teil des Werkzeugs hat keine Oberfläche. Eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>There is no tool number %1.</source>
        <translation>Es gibt kein Werkzeug Nummer %1.</translation>
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
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Go on without doing this</source>
        <translation>Weiter, ohne das zu tun</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End the tour; the part stays open</source>
        <translation>Den Rundgang beenden; das Teil bleibt offen</translation>
    </message>
    <message>
        <source>Tour: %1</source>
        <translation>Rundgang: %1</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Hold the left button on the clay: a thumb goes in for as long as you hold it.</source>
        <translation>Die linke Taste auf dem Ton halten: Ein Daumen geht hinein, solange sie gehalten wird.</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Choose Pull material at the right of the view (%1). Then drag a corner of the clay outwards.</source>
        <translation>Rechts neben der Ansicht Material ziehen wählen (%1). Dann eine Ecke des Tons nach außen ziehen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Press %1 and write the clay as STEP or as a mesh, into a folder of your choice. Or skip this.</source>
        <translation>%1 drücken und den Ton als STEP oder als Netz in einen Ordner der Wahl schreiben. Oder überspringen.</translation>
    </message>
    <message>
        <source>That was all</source>
        <translation>Das war alles</translation>
    </message>
    <message>
        <source>Ctrl+Z takes back whatever you did. Ctrl+K finds any command, F1 opens the handbook, and this tour is in the menu Help.</source>
        <translation>Strg+Z nimmt zurück, was immer getan wurde. Strg+K findet jeden Befehl, F1 öffnet das Handbuch, und dieser Rundgang steht im Menü Hilfe.</translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>The project has no bodies that a script could fill.</source>
        <translation>Das Projekt hat keine Körper, die ein Skript füllen könnte.</translation>
    </message>
    <message>
        <source>Nothing was done in the project yet that a script could say.</source>
        <translation>In dem Projekt wurde noch nichts getan, was ein Skript sagen könnte.</translation>
    </message>
    <message>
        <source>A tool is an imported part, which only a saved project keeps: save the project first.</source>
        <translation>Ein Werkzeug ist ein importiertes Teil, das nur ein gespeichertes Projekt behält: speichern Sie zuerst das Projekt.</translation>
    </message>
    <message>
        <source>The parts are in no file as they are here: save the project first, from which the script then takes them.</source>
        <translation>Die Teile sind in keiner Datei so, wie sie hier sind: speichern Sie zuerst das Projekt, aus dem das Skript sie dann nimmt.</translation>
    </message>
    <message>
        <source>%1 has no entry %2; its last one is %3.</source>
        <translation>%1 hat keinen Eintrag %2; der letzte ist %3.</translation>
    </message>
</context>
<context>
    <name>TraceFeature</name>
    <message>
        <source>Python trace</source>
        <translation>Python-Mitschrift</translation>
    </message>
    <message>
        <source>Save the Python trace</source>
        <translation>Python-Mitschrift speichern</translation>
    </message>
    <message>
        <source>Python scripts (*%1)</source>
        <translation>Python-Skripte (*%1)</translation>
    </message>
</context>
<context>
    <name>TracePanel</name>
    <message>
        <source>Python trace</source>
        <translation>Python-Mitschrift</translation>
    </message>
    <message>
        <source>Open a part: what you do is then written here as Python.</source>
        <translation>Öffnen Sie ein Teil: was Sie tun, steht dann hier als Python.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the whole script</source>
        <translation>Das ganze Skript kopieren</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Speichern unter...</translation>
    </message>
    <message>
        <source>Write the script to a file; run, it comes to the same bits</source>
        <translation>Das Skript in eine Datei schreiben; ausgeführt kommt es zu denselben Bits</translation>
    </message>
</context>
<context>
    <name>Transfer</name>
    <message>
        <source>The recipe</source>
        <translation>Das Rezept</translation>
    </message>
    <message>
        <source>Left out: %1. %2</source>
        <translation>Weggelassen: %1. %2</translation>
    </message>
    <message>
        <source>what is said of the body &quot;%1&quot;</source>
        <translation>was vom Körper „%1“ gesagt ist</translation>
    </message>
    <message>
        <source>The other part has no such body.</source>
        <translation>Das andere Teil hat keinen solchen Körper.</translation>
    </message>
    <message>
        <source>None of its faces was found again.</source>
        <translation>Keine seiner Flächen wurde wiedergefunden.</translation>
    </message>
    <message>
        <source>Of the faces of %1, %2 were not found again.</source>
        <translation>Nicht wiedergefundene Flächen, %1: %2</translation>
    </message>
    <message>
        <source>It names objects of a body that had been filled anew by then, which another part does not have.</source>
        <translation>Es nennt Objekte eines Körpers, der bis dahin neu gefüllt worden war; ein anderes Teil hat sie nicht.</translation>
    </message>
    <message>
        <source>There is no material in its place.</source>
        <translation>An seiner Stelle ist kein Material.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot;</source>
        <translation>das Werkzeug „%1“</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is left out: it is an imported part, which has no mirror image.</source>
        <translation>Das Werkzeug „%1“ fällt weg: Es ist ein importiertes Teil, das kein Spiegelbild hat.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; keeps its size: it is an imported part.</source>
        <translation>Das Werkzeug „%1“ behält seine Größe: Es ist ein importiertes Teil.</translation>
    </message>
    <message>
        <source>One of the parts is not closed: there is nothing to carry over.</source>
        <translation>Eines der Teile ist nicht geschlossen: Es gibt nichts zu übertragen.</translation>
    </message>
    <message>
        <source>none of the faces was found again on it. Is it another part, or a mirrored one?</source>
        <translation>darauf wurde keine der Flächen wiedergefunden. Ist es ein anderes Teil, oder ein gespiegeltes?</translation>
    </message>
    <message>
        <source>a change of material</source>
        <translation>eine Änderung des Materials</translation>
    </message>
    <message>
        <source>a relaxation</source>
        <translation>eine Entspannung</translation>
    </message>
    <message>
        <source>a cut</source>
        <translation>ein Schnitt</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>die Einspannung „%1“</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>die Last „%1“</translation>
    </message>
    <message>
        <source>The floor is left out: its mirror image would be no floor.</source>
        <translation>Der Boden fällt weg: Sein Spiegelbild wäre keiner.</translation>
    </message>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>die Sonde „%1“</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>der Bereich „%1“</translation>
    </message>
    <message>
        <source>--mirror &quot;%1&quot; is no mirror; say x, y or z, across which it is mirrored, or the normal of a plane as 1,1,0.</source>
        <translation>--mirror „%1“ ist kein Spiegel; x, y oder z nennen, worüber gespiegelt wird, oder die Normale einer Ebene wie 1,1,0.</translation>
    </message>
    <message>
        <source>--scale &quot;%1&quot; is no scale; say auto or a number from 0.001 to 1000.</source>
        <translation>--scale „%1“ ist kein Maßstab; auto oder eine Zahl von 0.001 bis 1000 nennen.</translation>
    </message>
    <message>
        <source>this is no project of Knead. A recipe goes to another part with knead run --set part.file=...</source>
        <translation>das ist kein Projekt von Knead. Auf ein anderes Teil kommt ein Rezept mit knead run --set part.file=...</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>das Projekt hat keinen Eintrag %1; der letzte ist %2.</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>Open that file alone to correct it.</source>
        <translation>Diese Datei allein öffnen, um es zu berichtigen.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
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
        <source>centimetres</source>
        <translation>Zentimeter</translation>
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
        <source>thousandths of an inch</source>
        <translation>Tausendstel Zoll</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>Nanometer</translation>
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
        <source>millionths of an inch</source>
        <translation>Millionstel Zoll</translation>
    </message>
    <message>
        <source>%1: the file states no length unit; millimetres were taken.</source>
        <translation>%1: die Datei nennt keine Längeneinheit; Millimeter wurden genommen.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; that was asked for is not known; known are %2.</source>
        <translation>die verlangte Längeneinheit „%1“ ist nicht bekannt; bekannt sind %2.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; of the file is not known; known are %2.</source>
        <translation>die Längeneinheit „%1“ der Datei ist nicht bekannt; bekannt sind %2.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4.</source>
        <translation>%1: das Teil ist %2 lang; wenn seine Längen %3 sind, ist es %4.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4.</source>
        <translation>%1: die Teile sind zusammen %2 lang; wenn ihre Längen %3 sind, sind sie %4.</translation>
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
    <name>ViewHand</name>
    <message>
        <source>What is seen here is not the present: Esc returns to it. To go on from an earlier moment, press Branch here beside the timeline.</source>
        <translation>Was hier zu sehen ist, ist nicht die Gegenwart: Esc kehrt zu ihr zurück. Um von einem früheren Augenblick aus weiterzumachen, neben der Zeitleiste auf „Hier abzweigen“ drücken.</translation>
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
    <name>ViewReading</name>
    <message>
        <source>Nothing is open</source>
        <translation>Nichts ist geöffnet</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nichts ist ausgewählt</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Ausgewählt: %1</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
</context>
<context>
    <name>ViewsFeature</name>
    <message>
        <source>Show two or four views first.</source>
        <translation>Zuerst zwei oder vier Ansichten zeigen.</translation>
    </message>
</context>
<context>
    <name>WarningWatch</name>
    <message>
        <source>Fold</source>
        <translation>Falte</translation>
    </message>
    <message>
        <source>Wall %1, was %2</source>
        <translation>Wand %1, war %2</translation>
    </message>
    <message>
        <source>Stretched to %1 % of breaking</source>
        <translation>Bis %1 % des Bruchs gedehnt</translation>
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
    <name>Work</name>
    <message>
        <source>A pipe to another process cannot be made (%1).</source>
        <translation>Eine Leitung zu einem anderen Prozess lässt sich nicht anlegen (%1).</translation>
    </message>
    <message>
        <source>The process of %1 cannot be started (%2).</source>
        <translation>Der Prozess von %1 lässt sich nicht starten (%2).</translation>
    </message>
    <message>
        <source>What was read cannot be fetched (%1).</source>
        <translation>Was gelesen wurde, lässt sich nicht abholen (%1).</translation>
    </message>
    <message>
        <source>memory access</source>
        <translation>Speicherzugriff</translation>
    </message>
    <message>
        <source>arithmetic</source>
        <translation>Rechenfehler</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>interner Fehler</translation>
    </message>
    <message>
        <source>illegal instruction</source>
        <translation>unzulässiger Befehl</translation>
    </message>
    <message>
        <source>ended from outside, perhaps because the machine ran out of memory</source>
        <translation>von außen beendet, vielleicht weil dem Rechner der Speicher ausging</translation>
    </message>
    <message>
        <source>signal %1</source>
        <translation>Signal %1</translation>
    </message>
    <message>
        <source>the writer</source>
        <translation>das Schreibprogramm</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>das Schreiben</translation>
    </message>
    <message>
        <source>the reader</source>
        <translation>das Leseprogramm</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>das Lesen</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 Minuten</translation>
    </message>
    <message>
        <source> while %1</source>
        <translation> (beim Schritt „%1“)</translation>
    </message>
    <message>
        <source>%1 took longer than %2%3 and was ended. %4</source>
        <translation>%1 dauerte länger als %2%3 und wurde beendet. %4</translation>
    </message>
    <message>
        <source>%1 crashed%2 (%3). %4</source>
        <translation>%1 stürzte ab%2 (%3). %4</translation>
    </message>
    <message>
        <source>%1 ended without a result%2. %3</source>
        <translation>%1 endete ohne Ergebnis%2. %3</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 läuft noch: warten, oder mit Esc abbrechen.</translation>
    </message>
</context>
</TS>
