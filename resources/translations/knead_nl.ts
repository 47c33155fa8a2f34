<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Knead</source>
        <translation>Over Knead</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Versies kopiëren</translation>
    </message>
    <message>
        <source>For a report of something that went wrong</source>
        <translation>Voor een melding van iets dat misging</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>&lt;b style='font-size:16pt'&gt;Knead %1&lt;/b&gt;&lt;br&gt;A CAD workbench in which a part is a lump of real material.</source>
        <translation>&lt;b style='font-size:16pt'&gt;Knead %1&lt;/b&gt;&lt;br&gt;Een CAD-werkbank waarin een onderdeel een klomp echt materiaal is.</translation>
    </message>
    <message>
        <source>After Jansson, Horváth and Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</source>
        <translation>Naar Jansson, Horváth en Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</translation>
    </message>
    <message>
        <source>Made with</source>
        <translation>Gemaakt met</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versie</translation>
    </message>
    <message>
        <source>License</source>
        <translation>Licentie</translation>
    </message>
</context>
<context>
    <name>Actions</name>
    <message>
        <source>Put one above the part to push it with</source>
        <translation>Zet er een boven het onderdeel om ermee te duwen</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Openen...</translation>
    </message>
    <message>
        <source>Open a part, a project or a recipe</source>
        <translation>Een onderdeel, project of recept openen</translation>
    </message>
    <message>
        <source>Open with &amp;choices...</source>
        <translation>Openen met &amp;keuzes...</translation>
    </message>
    <message>
        <source>Look into files and choose parts, detail and units before they are opened</source>
        <translation>Bestanden eerst bekijken en onderdelen, fijnheid en eenheden kiezen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Keep part, history and view in a project file</source>
        <translation>Onderdeel, geschiedenis en aanzicht in een projectbestand bewaren</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Opslaan &amp;als...</translation>
    </message>
    <message>
        <source>Keep the project in another file and go on with that</source>
        <translation>Het project in een ander bestand bewaren en daarmee verdergaan</translation>
    </message>
    <message>
        <source>Recover &amp;unsaved work...</source>
        <translation>&amp;Niet-opgeslagen werk herstellen...</translation>
    </message>
    <message>
        <source>Look for work that was not saved when Knead ended</source>
        <translation>Werk zoeken dat niet was opgeslagen toen Knead stopte</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exporteren...</translation>
    </message>
    <message>
        <source>Write the deformed part to a file</source>
        <translation>Het vervormde onderdeel naar een bestand schrijven</translation>
    </message>
    <message>
        <source>Export as &amp;recipe...</source>
        <translation>Als &amp;recept exporteren...</translation>
    </message>
    <message>
        <source>Write what was done as a recipe, to be read, changed and carried out again</source>
        <translation>Schrijven wat er gedaan is als recept, om te lezen, te wijzigen en opnieuw uit te voeren</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afsluiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>De simulatie laten lopen of pauzeren</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>One time step</source>
        <translation>Eén tijdstap</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Terug naar het begin</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Zwaartekracht</translation>
    </message>
    <message>
        <source>Let everything weigh something</source>
        <translation>Alles iets laten wegen</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Vloer</translation>
    </message>
    <message>
        <source>Put a floor under the part</source>
        <translation>Een vloer onder het onderdeel leggen</translation>
    </message>
    <message>
        <source>Record &amp;video...</source>
        <translation>&amp;Video opnemen...</translation>
    </message>
    <message>
        <source>Make a video of what was simulated, as the view shows it</source>
        <translation>Een video maken van wat gesimuleerd is, zoals het aanzicht het toont</translation>
    </message>
    <message>
        <source>Record p&amp;ictures...</source>
        <translation>&amp;Beelden opnemen...</translation>
    </message>
    <message>
        <source>Write what was simulated as a sequence of pictures</source>
        <translation>Schrijven wat gesimuleerd is als een reeks beelden</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Hernormaliseren</translation>
    </message>
    <message>
        <source>The selected body, or every one, takes its present shape for its own: stress is gone, the shape stays</source>
        <translation>Het gekozen lichaam, of elk, neemt zijn huidige vorm aan als eigen vorm: de spanning is weg, de vorm blijft</translation>
    </message>
    <message>
        <source>Fix faces</source>
        <translation>Vlakken vastzetten</translation>
    </message>
    <message>
        <source>Click faces of the part to hold them in place</source>
        <translation>Vlakken van het onderdeel aanklikken om ze vast te houden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Remove the selected tool or fixture</source>
        <translation>Het gekozen gereedschap of de gekozen inklemming verwijderen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Stop what is being done</source>
        <translation>Stoppen met wat er gedaan wordt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Passend</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Achter</translation>
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
        <translation>Boven</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Onder</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspectief</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objecten</translation>
    </message>
    <message>
        <source>Show the objects the material is made of</source>
        <translation>De objecten tonen waaruit het materiaal bestaat</translation>
    </message>
    <message>
        <source>Inner objects too</source>
        <translation>Ook inwendige objecten</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Randen</translation>
    </message>
    <message>
        <source>Open edges</source>
        <translation>Open randen</translation>
    </message>
    <message>
        <source>Show where surfaces that are not closed end</source>
        <translation>Tonen waar niet-gesloten oppervlakken eindigen</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Hide or show body</source>
        <translation>Lichaam verbergen of tonen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Zoals het systeem</translation>
    </message>
    <message>
        <source>Find a command...</source>
        <translation>Opdracht zoeken...</translation>
    </message>
    <message>
        <source>Find any command by a few of its letters and do it</source>
        <translation>Elke opdracht met een paar letters vinden en uitvoeren</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Voorkeuren...</translation>
    </message>
    <message>
        <source>Theme, language, units, memory, files, view</source>
        <translation>Thema, taal, eenheden, geheugen, bestanden, aanzicht</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts...</source>
        <translation>&amp;Sneltoetsen...</translation>
    </message>
    <message>
        <source>Give commands other keys</source>
        <translation>Opdrachten andere toetsen geven</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Indeling herstellen</translation>
    </message>
    <message>
        <source>Put all panels back where they came</source>
        <translation>Alle panelen terug naar hun oorspronkelijke plaats</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Volledig scherm</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rondleiding door het venster</translation>
    </message>
    <message>
        <source>What is where, in a minute</source>
        <translation>Wat waar zit, in een minuut</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Muis en toetsen</translation>
    </message>
    <message>
        <source>About Knead</source>
        <translation>Over Knead</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bol</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cilinder</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Wig</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Wat wilt u doen?</translation>
    </message>
    <message>
        <source>Nothing is called like that: try fewer letters.</source>
        <translation>Niets heet zo: probeer minder letters.</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importeren</translation>
    </message>
    <message>
        <source>The recipe belongs to the filling before and does not go on in this one. Undo goes back to it.</source>
        <translation>Het recept hoort bij de vorige vulling en gaat in deze niet verder. Ongedaan maken gaat ernaar terug.</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>%1 opnieuw vullen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>"%1" is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.</source>
        <translation>„%1” is een net zonder CAD-vlakken: open het als STEP, IGES of BREP om vlakken vast te zetten.</translation>
    </message>
    <message>
        <source>Fix face</source>
        <translation>Vlak vastzetten</translation>
    </message>
    <message>
        <source>Free face</source>
        <translation>Vlak vrijgeven</translation>
    </message>
    <message>
        <source>%1 holds no objects: its faces are smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>%1 houdt geen objecten vast: de vlakken zijn kleiner dan de afstand. Kies een fijnere afstand en vul opnieuw.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simuleren</translation>
    </message>
    <message>
        <source>Going to %1</source>
        <translation>Op weg naar %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then go to %2.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc, en ga dan naar %2.</translation>
    </message>
    <message>
        <source>There is not enough memory for this moment. Close other programs and try again.</source>
        <translation>Er is niet genoeg geheugen voor dit moment. Sluit andere programma's en probeer het opnieuw.</translation>
    </message>
    <message>
        <source>Branching from %1</source>
        <translation>Vertakken vanaf %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then branch again.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc, en vertak dan opnieuw.</translation>
    </message>
    <message>
        <source>Branch at %1</source>
        <translation>Tak bij %1</translation>
    </message>
    <message>
        <source>The recipe has come to its end. Play goes on without it.</source>
        <translation>Het recept is afgelopen. Afspelen gaat zonder verder.</translation>
    </message>
</context>
<context>
    <name>EntryNames</name>
    <message>
        <source>Material of %1</source>
        <translation>Materiaal van %1</translation>
    </message>
    <message>
        <source>%1 becomes rigid</source>
        <translation>%1 wordt star</translation>
    </message>
    <message>
        <source>%1 becomes glue</source>
        <translation>%1 wordt lijm</translation>
    </message>
    <message>
        <source>%1 becomes deformable</source>
        <translation>%1 wordt vervormbaar</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Hernormaliseren</translation>
    </message>
    <message>
        <source>Gravity off</source>
        <translation>Zwaartekracht uit</translation>
    </message>
    <message>
        <source>Gravity on</source>
        <translation>Zwaartekracht aan</translation>
    </message>
    <message>
        <source>Floor on</source>
        <translation>Vloer aan</translation>
    </message>
    <message>
        <source>Floor off</source>
        <translation>Vloer uit</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 stoppen</translation>
    </message>
    <message>
        <source>Push with %1</source>
        <translation>Duwen met %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 wijzigen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verplaatsen</translation>
    </message>
    <message>
        <source>Fix %1</source>
        <translation>%1 vastzetten</translation>
    </message>
    <message>
        <source>Semi-implicit steps</source>
        <translation>Semi-impliciete stappen</translation>
    </message>
    <message>
        <source>Forward steps</source>
        <translation>Voorwaartse stappen</translation>
    </message>
    <message>
        <source>Implicit steps</source>
        <translation>Impliciete stappen</translation>
    </message>
    <message>
        <source>Automatic steps</source>
        <translation>Automatische stappen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>het lichaam</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>het gereedschap</translation>
    </message>
    <message>
        <source>the fixture</source>
        <translation>de inklemming</translation>
    </message>
    <message>
        <source>Simulate %1</source>
        <translation>%1 simuleren</translation>
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
        <translation>Gladde begrensde vlakken, één voor elk vlak van het onderdeel zoals het geopend werd, waar het materiaal ze nu heeft. Het bestand wordt teruggelezen en vergeleken.</translation>
    </message>
    <message>
        <source>Triangles, as fine as the surface that is drawn.</source>
        <translation>Driehoeken, zo fijn als het getekende oppervlak.</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>De vervormde onderdelen exporteren</translation>
    </message>
    <message>
        <source>%1 (.%2)</source>
        <translation>%1 (.%2)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Indeling</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle onderdelen</translation>
    </message>
    <message>
        <source>Visible parts</source>
        <translation>Zichtbare onderdelen</translation>
    </message>
    <message>
        <source>Only "%1"</source>
        <translation>Alleen „%1”</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Onderdelen</translation>
    </message>
    <message>
        <source>As in the file that was opened</source>
        <translation>Zoals in het geopende bestand</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Lengtes</translation>
    </message>
    <message>
        <source>Automatic: 0.01 % of the size</source>
        <translation>Automatisch: 0,01 % van de grootte</translation>
    </message>
    <message>
        <source>How far faces in the file may lie beside the surface of the material. A larger one gives smaller files.</source>
        <translation>Hoe ver vlakken in het bestand naast het oppervlak van het materiaal mogen liggen. Groter geeft kleinere bestanden.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerantie</translation>
    </message>
    <message>
        <source>For older programs: AP214 instead of AP242</source>
        <translation>Voor oudere programma's: AP214 in plaats van AP242</translation>
    </message>
    <message>
        <source>As text, which is larger and can be read</source>
        <translation>Als tekst, die groter en leesbaar is</translation>
    </message>
    <message>
        <source>A file for each part</source>
        <translation>Een bestand voor elk onderdeel</translation>
    </message>
    <message>
        <source>Keep the report as a JSON file beside it</source>
        <translation>Het verslag ernaast bewaren als JSON-bestand</translation>
    </message>
    <message>
        <source>Choose a place…</source>
        <translation>Een plaats kiezen…</translation>
    </message>
</context>
<context>
    <name>ExportPanel</name>
    <message>
        <source>smooth faces</source>
        <translation>gladde vlakken</translation>
    </message>
    <message>
        <source>flat triangles</source>
        <translation>platte driehoeken</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>net</translation>
    </message>
    <message>
        <source>does not pass the geometry checks</source>
        <translation>doorstaat de meetkundige controles niet</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>niet gesloten</translation>
    </message>
    <message>
        <source>its volume is off</source>
        <translation>zijn volume klopt niet</translation>
    </message>
    <message>
        <source>further from the material than asked for</source>
        <translation>verder van het materiaal dan gevraagd</translation>
    </message>
    <message>
        <source>closed and valid</source>
        <translation>gesloten en geldig</translation>
    </message>
    <message>
        <source>valid, open as it was</source>
        <translation>geldig, open zoals het was</translation>
    </message>
    <message>
        <source>%1, mean %2</source>
        <translation>%1, gemiddeld %2</translation>
    </message>
    <message>
        <source>Not as smooth faces: %1</source>
        <translation>Niet als gladde vlakken: %1</translation>
    </message>
    <message>
        <source>Its name was not found again.</source>
        <translation>Zijn naam werd niet teruggevonden.</translation>
    </message>
    <message>
        <source>Not all of its colors were found again.</source>
        <translation>Niet al zijn kleuren werden teruggevonden.</translation>
    </message>
    <message>
        <source>Nothing was exported yet.</source>
        <translation>Er is nog niets geëxporteerd.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Teruggelezen</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Als</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Massieven</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Vlakken</translation>
    </message>
    <message>
        <source>Distance to the material</source>
        <translation>Afstand tot het materiaal</translation>
    </message>
    <message>
        <source>Volume (since opened)</source>
        <translation>Volume (sinds openen)</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 bestanden</translation>
    </message>
    <message>
        <source>%1: %2, %3 MB in %4 s. %5</source>
        <translation>%1: %2, %3 MB in %4 s. %5</translation>
    </message>
    <message>
        <source>All parts are sound.</source>
        <translation>Alle onderdelen zijn in orde.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are not sound.</source>
        <translation>%1 van %2 onderdelen zijn niet in orde.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>Er is geen ruimte meer in %1. Maak ruimte, of neem minder of kleinere beelden op.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another place.</source>
        <translation>%1 kan niet geschreven worden. Kies een andere plaats.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 bestaat al. Kies een andere naam voor de map met beelden.</translation>
    </message>
    <message>
        <source>%1 cannot be written: is there room on the disk?</source>
        <translation>%1 kan niet geschreven worden: is er ruimte op de schijf?</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2.</source>
        <translation>%1 kan niet gemaakt worden: %2.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>In %1 kan geen map gemaakt worden: %2. Kies een andere plaats.</translation>
    </message>
</context>
<context>
    <name>FixturePanel</name>
    <message>
        <source>Body</source>
        <translation>Lichaam</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Vlakken</translation>
    </message>
    <message>
        <source>Objects held</source>
        <translation>Vastgehouden objecten</translation>
    </message>
    <message>
        <source>With "Fix faces" on, a click on a face adds it to this fixture, or frees it.</source>
        <translation>Met „Vlakken vastzetten” voegt een klik op een vlak het toe aan deze inklemming, of geeft het vrij.</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Inklemming verwijderen</translation>
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
        <translation>Wat er gedaan is</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Made at</source>
        <translation>Gemaakt om</translation>
    </message>
    <message>
        <source>Simulated time at its end</source>
        <translation>Gesimuleerde tijd aan het eind</translation>
    </message>
    <message>
        <source>Key moments: memory is kept for them longest</source>
        <translation>Sleutelmomenten: geheugen wordt daarvoor het langst bewaard</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>What moments may take. The oldest ones are dropped, and found again by repeating</source>
        <translation>Wat momenten mogen innemen. De oudste vervallen, en worden door herhalen teruggevonden</translation>
    </message>
    <message>
        <source>of</source>
        <translation>van</translation>
    </message>
    <message>
        <source>A key moment; click: no longer one</source>
        <translation>Een sleutelmoment; klik: niet meer</translation>
    </message>
    <message>
        <source>Mark as a key moment</source>
        <translation>Als sleutelmoment merken</translation>
    </message>
    <message>
        <source>Kept, %1</source>
        <translation>Bewaard, %1</translation>
    </message>
    <message>
        <source>Found again by repeating what leads to it</source>
        <translation>Teruggevonden door te herhalen wat ernaartoe leidt</translation>
    </message>
    <message>
        <source>%1
Simulated: %2, step %3
%4</source>
        <translation>%1
Gesimuleerd: %2, stap %3
%4</translation>
    </message>
    <message>
        <source>Go here, and branch from here with what is done next</source>
        <translation>Hierheen gaan, en van hier vertakken met wat daarna gedaan wordt</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>No longer a key moment</source>
        <translation>Geen sleutelmoment meer</translation>
    </message>
    <message>
        <source>Mark as key moment</source>
        <translation>Als sleutelmoment merken</translation>
    </message>
</context>
<context>
    <name>HomePage</name>
    <message>
        <source>Go on with</source>
        <translation>Verdergaan met</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Bestand openen...</translation>
    </message>
    <message>
        <source>Drop STEP, IGES, mesh or project files here</source>
        <translation>Laat STEP-, IGES-, net- of projectbestanden hier vallen</translation>
    </message>
    <message>
        <source>It becomes a lump of real material to push, bend and squeeze.</source>
        <translation>Het wordt een klomp echt materiaal om te duwen, buigen en knijpen.</translation>
    </message>
    <message>
        <source>Unsaved work is waiting</source>
        <translation>Er wacht niet-opgeslagen werk</translation>
    </message>
    <message>
        <source>Recover...</source>
        <translation>Herstellen...</translation>
    </message>
    <message>
        <source>Begin with an example</source>
        <translation>Met een voorbeeld beginnen</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grof (0,2 % van de grootte)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normaal (0,05 % van de grootte)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fijn (0,0125 % van de grootte)</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 onderdeel</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 onderdelen</translation>
    </message>
    <message>
        <source>1 solid</source>
        <translation>1 massief</translation>
    </message>
    <message>
        <source>%1 solids</source>
        <translation>%1 massieven</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 vlakken</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 openen</translation>
    </message>
    <message>
        <source>Open %1 files</source>
        <translation>%1 bestanden openen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of the file</source>
        <translation>Hoe ver de getekende en gevulde driehoeken naast de oppervlakken van het bestand mogen liggen</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Driehoeken</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Zoals het bestand zegt</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in</source>
        <translation>De eenheid waarin de getallen van het bestand worden gelezen</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Lengtes</translation>
    </message>
    <message>
        <source>Stay separate</source>
        <translation>Blijven gescheiden</translation>
    </message>
    <message>
        <source>Are glued together</source>
        <translation>Worden verlijmd</translation>
    </message>
    <message>
        <source>What solids do that touch each other at rest</source>
        <translation>Wat massieven doen die elkaar in rust raken</translation>
    </message>
    <message>
        <source>Touching solids</source>
        <translation>Rakende massieven</translation>
    </message>
    <message>
        <source>Repair shapes: sew surfaces, close gaps</source>
        <translation>Vormen repareren: oppervlakken naaien, kieren sluiten</translation>
    </message>
    <message>
        <source>Close flat openings, fill in spite of small holes</source>
        <translation>Vlakke openingen sluiten, vullen ondanks kleine gaten</translation>
    </message>
    <message>
        <source>Flat openings of any size get a plane face; other surfaces are filled where they wind around. What is open too wide is only shown.</source>
        <translation>Vlakke openingen van elke grootte krijgen een plat vlak; andere oppervlakken worden gevuld waar ze omsluiten. Wat te ver open is, wordt alleen getoond.</translation>
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
        <translation>Het lezen wordt na deze rekentijd opgegeven; automatisch: naar de grootte van het bestand</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>Reading is given up when it wants more memory; automatic: by the size of the file</source>
        <translation>Het lezen wordt opgegeven als het meer geheugen wil; automatisch: naar de grootte van het bestand</translation>
    </message>
    <message>
        <source>Give up after</source>
        <translation>Opgeven na</translation>
    </message>
    <message>
        <source>For real time</source>
        <translation>Voor ware tijd</translation>
    </message>
    <message>
        <source>About so many objects</source>
        <translation>Ongeveer zoveel objecten</translation>
    </message>
    <message>
        <source>Cells across the thinnest wall</source>
        <translation>Cellen dwars op de dunste wand</translation>
    </message>
    <message>
        <source>Spacing of the objects</source>
        <translation>Afstand van de objecten</translation>
    </message>
    <message>
        <source>How finely to fill with objects; finer is slower</source>
        <translation>Hoe fijn met objecten gevuld wordt; fijner is langzamer</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>All %1 parts</source>
        <translation>Alle %1 onderdelen</translation>
    </message>
    <message>
        <source>%1 of %2 parts</source>
        <translation>%1 van %2 onderdelen</translation>
    </message>
</context>
<context>
    <name>ImportPanel</name>
    <message>
        <source>As the file says</source>
        <translation>Zoals het bestand zegt</translation>
    </message>
    <message>
        <source>Close and fill</source>
        <translation>Sluiten en vullen</translation>
    </message>
    <message>
        <source>Opens the file again: flat openings get a plane face, other surfaces are filled where they wind around</source>
        <translation>Opent het bestand opnieuw: vlakke openingen krijgen een plat vlak, andere oppervlakken worden gevuld waar ze omsluiten</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in. Another one opens the part anew in it.</source>
        <translation>De eenheid waarin de getallen van het bestand worden gelezen. Een andere opent het onderdeel daarin opnieuw.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Lengtes in</translation>
    </message>
    <message>
        <source>%1, %2, %3 filled</source>
        <translation>%1, %2, %3 gevuld</translation>
    </message>
    <message>
        <source>several formats</source>
        <translation>verscheidene indelingen</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 onderdeel</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 onderdelen</translation>
    </message>
    <message>
        <source>Take without repairs</source>
        <translation>Zonder reparaties nemen</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Repareren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Ontbrekend</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>was not filled: %1</source>
        <translation>werd niet gevuld: %1</translation>
    </message>
    <message>
        <source>Repaired: %1</source>
        <translation>Gerepareerd: %1</translation>
    </message>
    <message>
        <source>Nothing was wrong with this file.</source>
        <translation>Er was niets mis met dit bestand.</translation>
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
        <translation>Klaar. Open een onderdeel met Ctrl+O, of laat een bestand op het venster vallen.</translation>
    </message>
    <message>
        <source>%1: cancelled, nothing has changed.</source>
        <translation>%1: geannuleerd, er is niets veranderd.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc.</translation>
    </message>
    <message>
        <source>%1: %2, %3 surfaces to look at, nothing to simulate.</source>
        <translation>%1: %2, %3 oppervlakken om te bekijken, niets te simuleren.</translation>
    </message>
    <message>
        <source>%1: %2, %3 objects of spacing %4, %5 connections, time step %6.</source>
        <translation>%1: %2, %3 objecten met afstand %4, %5 verbindingen, tijdstap %6.</translation>
    </message>
    <message>
        <source>%1 "%2"</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Click faces to hold or free them   Esc: done</source>
        <translation>Vlakken aanklikken om ze vast te houden of vrij te geven   Esc: klaar</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: drive   Shift: slower   Middle: orbit</source>
        <translation>Pijlen, PgUp, PgDn: rijden   Shift: langzamer   Midden: draaien</translation>
    </message>
    <message>
        <source>Middle: orbit   Shift+middle: pan   Wheel: zoom</source>
        <translation>Midden: draaien   Shift+midden: schuiven   Wiel: zoomen</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Onderdelen (%1)</translation>
    </message>
    <message>
        <source>Projects, recipes and parts (%1)</source>
        <translation>Projecten, recepten en onderdelen (%1)</translation>
    </message>
    <message>
        <source>Recipes (%1)</source>
        <translation>Recepten (%1)</translation>
    </message>
    <message>
        <source>Open parts</source>
        <translation>Onderdelen openen</translation>
    </message>
    <message>
        <source>Open a project, a recipe or parts</source>
        <translation>Een project, een recept of onderdelen openen</translation>
    </message>
    <message>
        <source>Export a file for each part</source>
        <translation>Een bestand voor elk onderdeel exporteren</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>De vervormde onderdelen exporteren</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Muis en toetsen</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middle button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit; with Shift or Ctrl pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 3, 7, 0&lt;/b&gt;&lt;/td&gt;&lt;td&gt;front, right, top, isometric; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linkerknop&lt;/b&gt;&lt;/td&gt;&lt;td&gt;kiezen; gereedschap slepen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middelste knop&lt;/b&gt;&lt;/td&gt;&lt;td&gt;draaien; met Shift of Ctrl schuiven&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wiel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;naar de aanwijzer zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pijlen, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het gekozen gereedschap rijden; Shift is langzamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Spatie, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;afspelen of pauzeren, één stap, terugzetten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;blok toevoegen, vlakken vastzetten, verwijderen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zwaartekracht, hernormaliseren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objecten, lichaam verbergen, randen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 3, 7, 0&lt;/b&gt;&lt;/td&gt;&lt;td&gt;voor, rechts, boven, isometrisch; Ctrl: van de andere kant&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspectief of parallel, passend&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het project opslaan; Ctrl+Shift+S onder een andere naam&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;elke opdracht vinden; F11: volledig scherm&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;annuleren&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
    <message>
        <source>Looking into %1</source>
        <translation>%1 bekijken</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wordt geopend</translation>
    </message>
    <message numerus="yes">
        <source>Opening %1 and %n more</source>
        <translation>
            <numerusform>%1 en nog één bestand worden geopend</numerusform>
            <numerusform>%1 en nog %n bestanden worden geopend</numerusform>
        </translation>
    </message>
    <message>
        <source>Filling with a spacing of %1</source>
        <translation>Vullen met een afstand van %1</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wordt geëxporteerd</translation>
    </message>
    <message>
        <source>Exported 1 part to %1.</source>
        <translation>1 onderdeel geëxporteerd naar %1.</translation>
    </message>
    <message>
        <source>Exported %2 parts to %1.</source>
        <translation>%2 onderdelen geëxporteerd naar %1.</translation>
    </message>
    <message>
        <source>Not everything in %1 is sound; the export report says what is not.</source>
        <translation>Niet alles in %1 is in orde; het exportverslag zegt wat niet.</translation>
    </message>
    <message>
        <source>Take as %1</source>
        <translation>Als %1 nemen</translation>
    </message>
    <message>
        <source>%1 parts of the file are missing; the import report says which and why.</source>
        <translation>%1 onderdelen van het bestand ontbreken; het importverslag zegt welke en waarom.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Verslag tonen</translation>
    </message>
    <message>
        <source>Nothing in this file is closed, so nothing can be filled and simulated; the import report says why. Open edges are drawn in color.</source>
        <translation>Niets in dit bestand is gesloten, dus er kan niets gevuld en gesimuleerd worden; het importverslag zegt waarom. Open randen zijn gekleurd getekend.</translation>
    </message>
    <message>
        <source>Taking lengths in %1</source>
        <translation>Lengtes worden in %1 genomen</translation>
    </message>
    <message>
        <source>Nothing selected.</source>
        <translation>Niets gekozen.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geschiedenis</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschappen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Logboek</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Tijdlijn</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Prestaties</translation>
    </message>
    <message>
        <source>Import report</source>
        <translation>Importverslag</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Exportverslag</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Recent geopend</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Be&amp;werken</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulatie</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Gereedschap</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Gereedschap toevoegen</translation>
    </message>
    <message>
        <source>Put a tool above the part to push it with</source>
        <translation>Gereedschap boven het onderdeel zetten om ermee te duwen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Aan&amp;zicht</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panelen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>%1[*] - Knead</source>
        <translation>%1[*] - Knead</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>De lijst wissen</translation>
    </message>
    <message>
        <source>%1 is not there any more. It may have been moved: look for it with Ctrl+O.</source>
        <translation>%1 is er niet meer. Misschien is het verplaatst: zoek het met Ctrl+O.</translation>
    </message>
    <message>
        <source>A project is opened alone: choose one file, or only parts.</source>
        <translation>Een project wordt alleen geopend: kies één bestand, of alleen onderdelen.</translation>
    </message>
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Een recept wordt alleen geopend: kies één bestand, of alleen onderdelen.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 openen</translation>
    </message>
    <message>
        <source>Play carries out %1; what is done by hand comes on top of it.</source>
        <translation>Afspelen voert %1 uit; wat met de hand gedaan wordt komt daarbij.</translation>
    </message>
    <message>
        <source>Export as a recipe</source>
        <translation>Als recept exporteren</translation>
    </message>
    <message>
        <source>Recipes (*.%1)</source>
        <translation>Recepten (*.%1)</translation>
    </message>
    <message>
        <source>Exported the session as a recipe to %1.</source>
        <translation>De sessie als recept geëxporteerd naar %1.</translation>
    </message>
    <message>
        <source>There is nothing to record yet: press Play and let something happen first.</source>
        <translation>Er is nog niets op te nemen: druk op Afspelen en laat eerst iets gebeuren.</translation>
    </message>
    <message>
        <source>Save the video</source>
        <translation>De video opslaan</translation>
    </message>
    <message>
        <source>Make a folder for the pictures</source>
        <translation>Een map voor de beelden maken</translation>
    </message>
    <message>
        <source>Video (*.ogv)</source>
        <translation>Video (*.ogv)</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>Map (*)</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>%1 wordt opgenomen</translation>
    </message>
    <message>
        <source>%1: 1 picture recorded.</source>
        <translation>%1: 1 beeld opgenomen.</translation>
    </message>
    <message>
        <source>%1: %2 pictures recorded.</source>
        <translation>%1: %2 beelden opgenomen.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Er is niets ongedaan te maken.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Er is niets opnieuw te doen.</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>Open eerst een onderdeel.</translation>
    </message>
    <message>
        <source>Nothing in this part is closed, so nothing can be simulated.</source>
        <translation>Niets in dit onderdeel is gesloten, dus er kan niets gesimuleerd worden.</translation>
    </message>
    <message>
        <source>Pause first.</source>
        <translation>Pauzeer eerst.</translation>
    </message>
    <message>
        <source>Select a tool or a fixture first.</source>
        <translation>Kies eerst gereedschap of een inklemming.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Nu niet mogelijk.</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkbalk</translation>
    </message>
    <message>
        <source>Drag to move the timeline</source>
        <translation>Sleep om de tijdlijn te verplaatsen</translation>
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
        <translation>Vloeien</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oppervlak</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichtheid</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elasticiteitsmodulus</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Dwarscontractiecoëfficiënt</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dempingsgraad</translation>
    </message>
    <message>
        <source>Shape damping</source>
        <translation>Vormdemping</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>Vloeigrens</translation>
    </message>
    <message>
        <source>never yields</source>
        <translation>vloeit nooit</translation>
    </message>
    <message>
        <source>Hardening</source>
        <translation>Versteviging</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>Relaxatietijd</translation>
    </message>
    <message>
        <source>flows at once</source>
        <translation>vloeit meteen</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Treksterkte</translation>
    </message>
    <message>
        <source>never breaks</source>
        <translation>breekt nooit</translation>
    </message>
    <message>
        <source>Elongation at break</source>
        <translation>Breukrek</translation>
    </message>
    <message>
        <source>flows without end</source>
        <translation>vloeit zonder einde</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Hechting</translation>
    </message>
    <message>
        <source>does not stick</source>
        <translation>hecht niet</translation>
    </message>
    <message>
        <source>Healing time</source>
        <translation>Heeltijd</translation>
    </message>
    <message>
        <source>does not heal</source>
        <translation>heelt niet</translation>
    </message>
    <message>
        <source>Deformable</source>
        <translation>Vervormbaar</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Star</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Lijm</translation>
    </message>
    <message>
        <source>Keeps its shape and moves as a whole</source>
        <translation>Houdt zijn vorm en beweegt als geheel</translation>
    </message>
    <message>
        <source>Keeps shape and place; its adhesion holds what touches it</source>
        <translation>Houdt vorm en plaats; zijn hechting houdt vast wat het raakt</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Lichaam</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Eigen getallen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Distance between neighboring objects</source>
        <translation>Afstand tussen naburige objecten</translation>
    </message>
    <message>
        <source>Objects along the longest side of the part</source>
        <translation>Objecten langs de langste zijde van het onderdeel</translation>
    </message>
    <message>
        <source>Refill</source>
        <translation>Opnieuw vullen</translation>
    </message>
    <message>
        <source>Fill all bodies again with this spacing; the simulation starts anew</source>
        <translation>Alle lichamen opnieuw vullen met deze afstand; de simulatie begint opnieuw</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Afstand</translation>
    </message>
    <message>
        <source>Cells across</source>
        <translation>Cellen dwars</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stappen</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-impliciete Euler</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Voorwaartse Euler</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Impliciete Euler</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Keeps vibrations; stiff materials take small steps</source>
        <translation>Behoudt trillingen; stijve materialen nemen kleine stappen</translation>
    </message>
    <message>
        <source>As published; needs damping</source>
        <translation>Zoals gepubliceerd; heeft demping nodig</translation>
    </message>
    <message>
        <source>A step per frame for any stiffness; fast vibrations die out</source>
        <translation>Een stap per beeld voor elke stijfheid; snelle trillingen sterven uit</translation>
    </message>
    <message>
        <source>Implicit where the semi-implicit scheme would be slower than real time</source>
        <translation>Impliciet waar het semi-impliciete schema langzamer dan ware tijd zou zijn</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrator</translation>
    </message>
    <message>
        <source>%1 objects, %2 connections
%3 of material</source>
        <translation>%1 objecten, %2 verbindingen
%3 materiaal</translation>
    </message>
    <message>
        <source>Material of %1 → %2</source>
        <translation>Materiaal van %1 → %2</translation>
    </message>
    <message>
        <source>%1 of %2 → %3</source>
        <translation>%1 van %2 → %3</translation>
    </message>
</context>
<context>
    <name>ModelTree</name>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Inklemmingen</translation>
    </message>
    <message>
        <source>Assembly</source>
        <translation>Samenstelling</translation>
    </message>
    <message>
        <source>Not a closed solid: it is not simulated.</source>
        <translation>Geen gesloten massief: het wordt niet gesimuleerd.</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>objecten</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 vlak</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 vlakken</translation>
    </message>
</context>
<context>
    <name>PerformancePanel</name>
    <message>
        <source>Tools</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Commands and the motion of tools</source>
        <translation>Opdrachten en de beweging van gereedschap</translation>
    </message>
    <message>
        <source>Vicinity</source>
        <translation>Nabijheid</translation>
    </message>
    <message>
        <source>Finding what may touch</source>
        <translation>Vinden wat elkaar kan raken</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Plastic flow, breaking and annealing</source>
        <translation>Plastisch vloeien, breken en gloeien</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindingen</translation>
    </message>
    <message>
        <source>Forces of structural connections, or the equations of an implicit step</source>
        <translation>Krachten van structurele verbindingen, of de vergelijkingen van een impliciete stap</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacten</translation>
    </message>
    <message>
        <source>Forces of contacts, joints and fixtures</source>
        <translation>Krachten van contacten, scharnieren en inklemmingen</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Beweging</translation>
    </message>
    <message>
        <source>Integration of velocities and positions</source>
        <translation>Integratie van snelheden en posities</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controles</translation>
    </message>
    <message>
        <source>Health, the stable step, and states to go back to</source>
        <translation>Gezondheid, de stabiele stap, en toestanden om naar terug te gaan</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Momentopname</translation>
    </message>
    <message>
        <source>Handing the state to the window</source>
        <translation>De toestand aan het venster geven</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs/step</source>
        <translation>%1 µs/stap</translation>
    </message>
    <message>
        <source>%1 ms/step</source>
        <translation>%1 ms/stap</translation>
    </message>
    <message>
        <source>Time of a frame; its whole length is a sixtieth of a second</source>
        <translation>Tijd van een beeld; de hele lengte is een zestigste seconde</translation>
    </message>
    <message>
        <source>Open a part and press play to see where the time goes.</source>
        <translation>Open een onderdeel en druk op Afspelen om te zien waar de tijd blijft.</translation>
    </message>
    <message>
        <source>%1, %2 step of %3 per frame</source>
        <translation>%1, %2 stap van %3 per beeld</translation>
    </message>
    <message>
        <source>%1, %2 steps of %3 per frame</source>
        <translation>%1, %2 stappen van %3 per beeld</translation>
    </message>
    <message>
        <source>%1 iterations of the solver in the last step, %2 objects</source>
        <translation>%1 iteraties van de oplosser in de laatste stap, %2 objecten</translation>
    </message>
    <message>
        <source>%1 million connections per second, %2 objects</source>
        <translation>%1 miljoen verbindingen per seconde, %2 objecten</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Voorkeuren</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Algemeen</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Zoals het systeem</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>Names that you gave, and what the command line says, stay as they are.</source>
        <translation>Namen die u gaf, en wat de opdrachtregel zegt, blijven zoals ze zijn.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Lengtes in</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimeters (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centimeters (cm)</translation>
    </message>
    <message>
        <source>Metres (m)</source>
        <translation>Meters (m)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Inches (in)</translation>
    </message>
    <message>
        <source>Speeds and volumes follow. Every field takes numbers in any unit, such as 12.5 mm, 12,5 mm or 0.5 in.</source>
        <translation>Snelheden en volumes volgen. Elk veld neemt getallen in elke eenheid, zoals 12.5 mm, 12,5 mm of 0.5 in.</translation>
    </message>
    <message>
        <source>Memory and safety</source>
        <translation>Geheugen en veiligheid</translation>
    </message>
    <message>
        <source>For undo</source>
        <translation>Voor ongedaan maken</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>The oldest moments are dropped, and found again by repeating what was done.</source>
        <translation>De oudste momenten vervallen, en worden teruggevonden door te herhalen wat er gedaan is.</translation>
    </message>
    <message>
        <source>For looking back</source>
        <translation>Voor terugblikken</translation>
    </message>
    <message>
        <source>When it is full, every second picture of the older half goes.</source>
        <translation>Als het vol is, gaat elk tweede beeld van de oudere helft weg.</translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation>Niet-opgeslagen werk bewaren elke</translation>
    </message>
    <message>
        <source>After a crash, no more than this and two seconds are lost.</source>
        <translation>Na een crash gaat niet meer dan dit en twee seconden verloren.</translation>
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
        <translation>Die rekenen. De resultaten zijn voor elk aantal gelijk.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Driehoeken</translation>
    </message>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grof (0,2 % van de grootte)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normaal (0,05 % van de grootte)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fijn (0,0125 % van de grootte)</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of a file. Open with choices asks for each file.</source>
        <translation>Hoe ver de getekende en gevulde driehoeken naast de oppervlakken van een bestand mogen liggen. „Openen met keuzes” vraagt het per bestand.</translation>
    </message>
    <message>
        <source>Give up reading after</source>
        <translation>Lezen opgeven na</translation>
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
        <translation>of met meer geheugen dan</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>Automatic: by the size of the file.</source>
        <translation>Automatisch: naar de grootte van het bestand.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-aanzicht</translation>
    </message>
    <message>
        <source>Smooth edges</source>
        <translation>Gladde randen</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Uit</translation>
    </message>
    <message>
        <source>2 samples</source>
        <translation>2 monsters</translation>
    </message>
    <message>
        <source>4 samples</source>
        <translation>4 monsters</translation>
    </message>
    <message>
        <source>8 samples</source>
        <translation>8 monsters</translation>
    </message>
    <message>
        <source>More is slower without a graphics card.</source>
        <translation>Meer is langzamer zonder grafische kaart.</translation>
    </message>
    <message>
        <source>Turn smoothly from one view to another</source>
        <translation>Vloeiend van het ene naar het andere aanzicht draaien</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Standaardwaarden herstellen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>ProjectKeeper</name>
    <message>
        <source>The work is kept for recovery again.</source>
        <translation>Het werk wordt weer voor herstel bewaard.</translation>
    </message>
    <message>
        <source>Knead projects (*.%1)</source>
        <translation>Knead-projecten (*.%1)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wordt hersteld</translation>
    </message>
    <message>
        <source>Rescuing %1</source>
        <translation>%1 wordt gered</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wordt geopend</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Een kopie openen</translation>
    </message>
    <message>
        <source>Rescue what is whole</source>
        <translation>Redden wat heel is</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Opslaan als...</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>en nog %1</translation>
    </message>
    <message>
        <source>Not whole: %1</source>
        <translation>Niet heel: %1</translation>
    </message>
    <message>
        <source>Not everything is whole</source>
        <translation>Niet alles is heel</translation>
    </message>
    <message>
        <source>This could not be brought back:</source>
        <translation>Dit kon niet worden teruggehaald:</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover.</source>
        <translation>Er is geen niet-opgeslagen werk te herstellen.</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Het project opslaan</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name, or choose that file.</source>
        <translation>%1 bestaat al: kies een andere naam, of kies dat bestand.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, and save again.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc, en sla dan opnieuw op.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wordt opgeslagen</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 opgeslagen.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Niet-opgeslagen wijzigingen</translation>
    </message>
    <message>
        <source>Save the work on "%1" as a project?</source>
        <translation>Het werk aan „%1” als project opslaan?</translation>
    </message>
    <message>
        <source>Save the changes to "%1"?</source>
        <translation>De wijzigingen aan „%1” opslaan?</translation>
    </message>
    <message>
        <source>It has never been saved.</source>
        <translation>Het is nog nooit opgeslagen.</translation>
    </message>
    <message>
        <source>What was done since it was saved is lost otherwise.</source>
        <translation>Wat sinds het opslaan gedaan is, gaat anders verloren.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bol</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cilinder</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Wig</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>%1 slower than real time</source>
        <translation>%1 langzamer dan ware tijd</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>"%1" is not a number here; the value is still %2. Esc restores it.</source>
        <translation>„%1” is hier geen getal; de waarde is nog %2. Esc herstelt die.</translation>
    </message>
    <message>
        <source>Allowed is %1 to %2; the value is still %3. Esc restores it.</source>
        <translation>Toegestaan is %1 tot %2; de waarde is nog %3. Esc herstelt die.</translation>
    </message>
    <message>
        <source>Allowed: %1 to %2</source>
        <translation>Toegestaan: %1 tot %2</translation>
    </message>
    <message>
        <source>Allowed: %1 or more</source>
        <translation>Toegestaan: %1 of meer</translation>
    </message>
    <message>
        <source>A number, such as 0.5, 0,5 or 5e-1</source>
        <translation>Een getal, zoals 0.5, 0,5 of 5e-1</translation>
    </message>
    <message>
        <source>Units: %1</source>
        <translation>Eenheden: %1</translation>
    </message>
</context>
<context>
    <name>RecordDialog</name>
    <message>
        <source>Record a video</source>
        <translation>Een video opnemen</translation>
    </message>
    <message>
        <source>Record pictures</source>
        <translation>Beelden opnemen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Tot</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Beelden per seconde</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>Zoals gesimuleerd</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 maal</translation>
    </message>
    <message>
        <source>With the time, and forces on tools</source>
        <translation>Met tijd en krachten op gereedschap</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, zoals het aanzicht</translation>
    </message>
    <message>
        <source>Choose a place…</source>
        <translation>Een plaats kiezen…</translation>
    </message>
    <message>
        <source>1 picture</source>
        <translation>1 beeld</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 beelden</translation>
    </message>
    <message>
        <source>%1: a video of %2 (Ogg Theora)</source>
        <translation>%1: een video van %2 (Ogg Theora)</translation>
    </message>
    <message>
        <source>%1: PNG files in a folder of their own</source>
        <translation>%1: PNG-bestanden in een eigen map</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>picture %1 of %2</source>
        <translation>beeld %1 van %2</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>nobody knows when</source>
        <translation>niemand weet wanneer</translation>
    </message>
    <message>
        <source>today, %1</source>
        <translation>vandaag, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gisteren, %1</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschadigd</translation>
    </message>
    <message>
        <source>just begun</source>
        <translation>net begonnen</translation>
    </message>
    <message>
        <source>1 change</source>
        <translation>1 wijziging</translation>
    </message>
    <message>
        <source>%1 changes</source>
        <translation>%1 wijzigingen</translation>
    </message>
    <message>
        <source>Work without a name</source>
        <translation>Werk zonder naam</translation>
    </message>
    <message>
        <source>%1, never saved</source>
        <translation>%1, nooit opgeslagen</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Niet-opgeslagen werk herstellen</translation>
    </message>
    <message>
        <source>Knead ended before this was saved</source>
        <translation>Knead stopte voordat dit was opgeslagen</translation>
    </message>
    <message>
        <source>What is recovered opens unsaved, and stays here until you save or discard it.</source>
        <translation>Wat hersteld wordt opent niet-opgeslagen, en blijft hier tot u het opslaat of weggooit.</translation>
    </message>
    <message>
        <source>%1  ·  %2</source>
        <translation>%1  ·  %2</translation>
    </message>
    <message>
        <source>Discard...</source>
        <translation>Weggooien...</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Later</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Discard unsaved work</source>
        <translation>Niet-opgeslagen werk weggooien</translation>
    </message>
    <message>
        <source>Discard the unsaved work on "%1"? It cannot be brought back.</source>
        <translation>Het niet-opgeslagen werk aan „%1” weggooien? Het kan niet worden teruggehaald.</translation>
    </message>
</context>
<context>
    <name>Shortcuts</name>
    <message>
        <source>drives the selected tool</source>
        <translation>rijdt het gekozen gereedschap</translation>
    </message>
</context>
<context>
    <name>ShortcutsPage</name>
    <message>
        <source>No key</source>
        <translation>Geen toets</translation>
    </message>
    <message>
        <source>As it came</source>
        <translation>Zoals het was</translation>
    </message>
    <message>
        <source>Search an action or a key</source>
        <translation>Een opdracht of toets zoeken</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Opdracht</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
    <message>
        <source>Press the new key:</source>
        <translation>Druk op de nieuwe toets:</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation>Elders</translation>
    </message>
    <message>
        <source>%1 %2: choose another key.</source>
        <translation>%1 %2: kies een andere toets.</translation>
    </message>
    <message>
        <source>%1 already does "%2".</source>
        <translation>%1 doet al „%2”.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Daar weghalen</translation>
    </message>
</context>
<context>
    <name>StatusReadings</name>
    <message>
        <source>Simulated time per wall time</source>
        <translation>Gesimuleerde tijd per ware tijd</translation>
    </message>
    <message>
        <source>Frames the simulation delivers per second</source>
        <translation>Beelden die de simulatie per seconde levert</translation>
    </message>
    <message>
        <source>Time steps per frame</source>
        <translation>Tijdstappen per beeld</translation>
    </message>
    <message>
        <source>Spheres the bodies are made of</source>
        <translation>Bollen waaruit de lichamen bestaan</translation>
    </message>
    <message>
        <source>Structural connections between objects</source>
        <translation>Structurele verbindingen tussen objecten</translation>
    </message>
    <message>
        <source>Contact connections now</source>
        <translation>Contactverbindingen nu</translation>
    </message>
    <message>
        <source>Structural connections that broke so far</source>
        <translation>Structurele verbindingen die tot nu toe braken</translation>
    </message>
    <message>
        <source>Connected pieces of material</source>
        <translation>Samenhangende stukken materiaal</translation>
    </message>
    <message>
        <source>Units of what is shown</source>
        <translation>Eenheden van wat getoond wordt</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Gepauzeerd</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>1 step/frame</source>
        <translation>1 stap/beeld</translation>
    </message>
    <message>
        <source>%1 steps/frame</source>
        <translation>%1 stappen/beeld</translation>
    </message>
    <message>
        <source>Implicit</source>
        <translation>Impliciet</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Voorwaarts</translation>
    </message>
    <message>
        <source>Explicit</source>
        <translation>Expliciet</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 objecten</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 verbindingen</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 contacten</translation>
    </message>
    <message>
        <source>%1 broken</source>
        <translation>%1 gebroken</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 stuk</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 stukken</translation>
    </message>
</context>
<context>
    <name>TaskReading</name>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
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
        <translation>... en %1 ervoor</translation>
    </message>
</context>
<context>
    <name>TimelinePanel</name>
    <message>
        <source>Look at the start</source>
        <translation>Naar het begin kijken</translation>
    </message>
    <message>
        <source>One picture back</source>
        <translation>Eén beeld terug</translation>
    </message>
    <message>
        <source>Play what was simulated, from where you look</source>
        <translation>Afspelen wat gesimuleerd is, vanaf waar u kijkt</translation>
    </message>
    <message>
        <source>One picture on</source>
        <translation>Eén beeld verder</translation>
    </message>
    <message>
        <source>Look at the end</source>
        <translation>Naar het einde kijken</translation>
    </message>
    <message>
        <source>%1x</source>
        <translation>%1x</translation>
    </message>
    <message>
        <source>How fast it is played, in simulated per real time</source>
        <translation>Hoe snel wordt afgespeeld, gesimuleerde per ware tijd</translation>
    </message>
    <message>
        <source>Go on from what you see: a new branch of the history</source>
        <translation>Verdergaan vanaf wat u ziet: een nieuwe tak van de geschiedenis</translation>
    </message>
    <message>
        <source>Branch here</source>
        <translation>Hier vertakken</translation>
    </message>
    <message>
        <source>Back to the present (Esc)</source>
        <translation>Terug naar het heden (Esc)</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>Looking back at %1   Esc: return</source>
        <translation>Terugblik op %1   Esc: terug</translation>
    </message>
</context>
<context>
    <name>ToolPanel</name>
    <message>
        <source>Size X</source>
        <translation>Grootte X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Grootte Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Grootte Z</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Snede</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rug</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kracht</translation>
    </message>
    <message>
        <source>Largest so far</source>
        <translation>Grootste tot nu toe</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Positie %1</translation>
    </message>
    <message>
        <source>Size %1</source>
        <translation>Grootte %1</translation>
    </message>
    <message>
        <source>Arrow keys and PgUp/PgDn drive at this speed; dragging is never faster</source>
        <translation>Pijltoetsen en PgUp/PgDn rijden met deze snelheid; slepen is nooit sneller</translation>
    </message>
    <message>
        <source>The tool stalls rather than push harder</source>
        <translation>Het gereedschap staat stil in plaats van harder te duwen</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Snelheidsgrens</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Krachtgrens</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>Remove tool</source>
        <translation>Gereedschap verwijderen</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Tour of the window</source>
        <translation>Rondleiding door het venster</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Rondleiding stoppen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Volgende</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Open a part</source>
        <translation>Een onderdeel openen</translation>
    </message>
    <message>
        <source>Drop a STEP, IGES or mesh file here, press Ctrl+O, or begin with an example. It is filled with material at once.</source>
        <translation>Laat hier een STEP-, IGES- of netbestand vallen, druk op Ctrl+O, of begin met een voorbeeld. Het wordt meteen met materiaal gevuld.</translation>
    </message>
    <message>
        <source>What there is</source>
        <translation>Wat er is</translation>
    </message>
    <message>
        <source>Parts, tools and fixtures are listed here. A click selects; the selected one shows in the view, too.</source>
        <translation>Onderdelen, gereedschap en inklemmingen staan hier. Een klik kiest; het gekozene is ook in het aanzicht te zien.</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>Waarvan het gemaakt is</translation>
    </message>
    <message>
        <source>Choose a material or type its numbers, with any unit: 2 MPa, 0,5 mm, 1.2e3 kg/m³. It takes effect while time runs.</source>
        <translation>Kies een materiaal of typ de getallen, in elke eenheid: 2 MPa, 0,5 mm, 1.2e3 kg/m³. Het werkt terwijl de tijd loopt.</translation>
    </message>
    <message>
        <source>Hold, push, run</source>
        <translation>Vasthouden, duwen, laten lopen</translation>
    </message>
    <message>
        <source>X fixes faces that you click, B adds a block, Space runs time. Drag the block with the left button or drive it with the arrow keys; the middle button turns the view.</source>
        <translation>X zet vlakken vast die u aanklikt, B voegt een blok toe, Spatie laat de tijd lopen. Sleep het blok met de linkerknop of rijd het met de pijltoetsen; de middelste knop draait het aanzicht.</translation>
    </message>
    <message>
        <source>Back and forth in time</source>
        <translation>Heen en terug in de tijd</translation>
    </message>
    <message>
        <source>Drag along the timeline to look back. Ctrl+Z undoes whatever you did, what was simulated included.</source>
        <translation>Sleep langs de tijdlijn om terug te blikken. Ctrl+Z maakt ongedaan wat u ook deed, ook wat gesimuleerd werd.</translation>
    </message>
    <message>
        <source>Everything else</source>
        <translation>Al het andere</translation>
    </message>
    <message>
        <source>Ctrl+E exports the part as CAD again. Ctrl+K finds any command by a few letters, F1 lists mouse and keys, and the menu Help repeats this tour.</source>
        <translation>Ctrl+E exporteert het onderdeel weer als CAD. Ctrl+K vindt elke opdracht met een paar letters, F1 toont muis en toetsen, en het menu Help herhaalt deze rondleiding.</translation>
    </message>
</context>
<context>
    <name>ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>VOOR</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>RECHTS</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ACHTER</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>LINKS</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>BOVEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>ONDER</translation>
    </message>
</context>
</TS>
