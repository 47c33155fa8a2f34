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
        <source>&lt;b style='font-size:16pt'&gt;Knead %1&lt;/b&gt;&lt;br&gt;A CAD workbench in which a part is a lump of real material.</source>
        <translation>&lt;b style='font-size:16pt'&gt;Knead %1&lt;/b&gt;&lt;br&gt;Eine CAD-Werkbank, in der ein Teil ein Klumpen echtes Material ist.</translation>
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
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
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
        <source>"%1" is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.</source>
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
        <source>There is not enough memory for this moment. Close other programs and try again.</source>
        <translation>Für diesen Moment reicht der Speicher nicht. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
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
        <source>Only "%1"</source>
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
        <source>Choose a place…</source>
        <translation>Ort wählen…</translation>
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
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>In %1 ist kein Platz mehr. Schaffen Sie welchen, oder nehmen Sie weniger oder kleinere Bilder auf.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another place.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 gibt es schon. Wählen Sie einen anderen Namen für den Ordner der Bilder.</translation>
    </message>
    <message>
        <source>%1 cannot be written: is there room on the disk?</source>
        <translation>%1 kann nicht geschrieben werden: ist auf der Platte Platz?</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2.</source>
        <translation>%1 kann nicht angelegt werden: %2.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>In %1 kann kein Ordner angelegt werden: %2. Wählen Sie einen anderen Ort.</translation>
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
        <source>With "Fix faces" on, a click on a face adds it to this fixture, or frees it.</source>
        <translation>Mit „Flächen fixieren“ fügt ein Klick auf eine Fläche sie dieser Einspannung hinzu oder gibt sie frei.</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Einspannung entfernen</translation>
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
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 läuft noch: warten Sie, oder brechen Sie mit Esc ab.</translation>
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
        <source>%1 "%2"</source>
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
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
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
        <source>Export a file for each part</source>
        <translation>Eine Datei für jedes Teil exportieren</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>Verformte Teile exportieren</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middle button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit; with Shift or Ctrl pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 3, 7, 0&lt;/b&gt;&lt;/td&gt;&lt;td&gt;front, right, top, isometric; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linke Taste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;wählen; ein Werkzeug ziehen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Mittlere Taste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drehen; mit Umschalt oder Strg schieben&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Rad&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zum Zeiger zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pfeile, Bild auf, Bild ab&lt;/b&gt;&lt;/td&gt;&lt;td&gt;das gewählte Werkzeug fahren; mit Umschalt langsamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Leertaste, . , Rücktaste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;starten oder anhalten, ein Schritt, zurücksetzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Entf&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Block hinzufügen, Flächen fixieren, entfernen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Schwerkraft, renormieren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Objekte, Körper verbergen, Kanten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 3, 7, 0&lt;/b&gt;&lt;/td&gt;&lt;td&gt;vorne, rechts, oben, isometrisch; Strg: von der anderen Seite&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspektivisch oder parallel, einpassen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Projekt speichern; Strg+Umschalt+S unter anderem Namen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;jeden Befehl finden; F11: Vollbild&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;abbrechen&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
    <message>
        <source>Looking into %1</source>
        <translation>%1 wird angesehen</translation>
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
        <source>Filling with a spacing of %1</source>
        <translation>Füllen mit einem Abstand von %1</translation>
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
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Import report</source>
        <translation>Importbericht</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Exportbericht</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
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
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
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
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
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
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Ein Rezept wird allein geöffnet: wählen Sie eine Datei oder nur Teile.</translation>
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
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Drag to move the timeline</source>
        <translation>Ziehen verschiebt die Zeitleiste</translation>
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
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
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
        <source>Save the work on "%1" as a project?</source>
        <translation>Die Arbeit an „%1“ als Projekt speichern?</translation>
    </message>
    <message>
        <source>Save the changes to "%1"?</source>
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
        <source>%1 slower than real time</source>
        <translation>%1 langsamer als Echtzeit</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>"%1" is not a number here; the value is still %2. Esc restores it.</source>
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
        <source>Choose a place…</source>
        <translation>Ort wählen…</translation>
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
</context>
<context>
    <name>Recording</name>
    <message>
        <source>picture %1 of %2</source>
        <translation>Bild %1 von %2</translation>
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
        <source>Discard the unsaved work on "%1"? It cannot be brought back.</source>
        <translation>Die nicht gespeicherte Arbeit an „%1“ verwerfen? Sie lässt sich nicht zurückholen.</translation>
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
        <source>%1 already does "%2".</source>
        <translation>%1 tut schon „%2“.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Von dort nehmen</translation>
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
</context>
<context>
    <name>TaskReading</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
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
        <source>Ctrl+E exports the part as CAD again. Ctrl+K finds any command by a few letters, F1 lists mouse and keys, and the menu Help repeats this tour.</source>
        <translation>Strg+E exportiert das Teil wieder als CAD. Strg+K findet jeden Befehl an ein paar Buchstaben, F1 listet Maus und Tasten, und das Menü Hilfe wiederholt diesen Rundgang.</translation>
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
</TS>
