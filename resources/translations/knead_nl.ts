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
        <source>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;A CAD workbench in which a part is a lump of real material.</source>
        <translation>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;Een CAD-werkbank waarin een onderdeel een klomp echt materiaal is.</translation>
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
    <message>
        <source>One view</source>
        <translation>Eén aanzicht</translation>
    </message>
    <message>
        <source>One view of the part</source>
        <translation>Eén aanzicht van het onderdeel</translation>
    </message>
    <message>
        <source>Two views</source>
        <translation>Twee aanzichten</translation>
    </message>
    <message>
        <source>Two views of the part, side by side</source>
        <translation>Twee aanzichten van het onderdeel naast elkaar</translation>
    </message>
    <message>
        <source>Four views</source>
        <translation>Vier aanzichten</translation>
    </message>
    <message>
        <source>Front, top, right and the free view of the part</source>
        <translation>Het onderdeel van voren, van boven, van rechts en vrij</translation>
    </message>
    <message>
        <source>Active view alone</source>
        <translation>Alleen het actieve aanzicht</translation>
    </message>
    <message>
        <source>Show the active view alone, and all of them again</source>
        <translation>Alleen het actieve aanzicht tonen, en weer alle</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Volgend aanzicht</translation>
    </message>
    <message>
        <source>Make the next of several views the active one</source>
        <translation>Het volgende van meer aanzichten actief maken</translation>
    </message>
    <message>
        <source>Linked cameras</source>
        <translation>Gekoppelde camera&apos;s</translation>
    </message>
    <message>
        <source>What is panned or zoomed in one view is in all of them</source>
        <translation>Wat in één aanzicht wordt verschoven of gezoomd, wordt dat in alle</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Evenwicht zoeken</translation>
    </message>
    <message>
        <source>Put the part where forces balance now, without waiting until it is at rest</source>
        <translation>Het onderdeel neerzetten waar de krachten nu in evenwicht zijn, zonder te wachten tot het in rust is</translation>
    </message>
    <message>
        <source>Keep up with real time</source>
        <translation>Echte tijd bijhouden</translation>
    </message>
    <message>
        <source>Where implicit steps are slower than real time, solve them more roughly (forces within 3 % of the largest), then take one per 1/30 s. Without this, time runs slower</source>
        <translation>Waar impliciete stappen langzamer zijn dan echte tijd, worden ze grover opgelost (krachten binnen 3 % van de grootste), daarna is er één per 1/30 s. Zonder dit loopt de tijd langzamer</translation>
    </message>
    <message>
        <source>Refill as it is</source>
        <translation>In zijn vorm opnieuw vullen</translation>
    </message>
    <message>
        <source>The selected body, or every one that yields, gets new objects in the shape that it has, and goes on with its stress and motion. Where its lattice is no good any more this happens by itself</source>
        <translation>Het gekozen lichaam, of elk dat vloeit, krijgt nieuwe objecten in de vorm die het heeft, en houdt spanning en beweging. Waar zijn rooster niet meer deugt, gebeurt dat vanzelf</translation>
    </message>
    <message>
        <source>Put one above the part to cut it with: the force is the toughness of its material times the width of the cut</source>
        <translation>Er een boven het onderdeel zetten om het te snijden: de kracht is de taaiheid van het materiaal maal de breedte van de snede</translation>
    </message>
    <message>
        <source>Cut at section plane</source>
        <translation>Snijden op het doorsnedevlak</translation>
    </message>
    <message>
        <source>The selected body, or every one that deforms, is cut in two where the section plane is now, without force</source>
        <translation>Het gekozen lichaam, of elk dat vervormt, wordt zonder kracht doorgesneden waar het doorsnedevlak nu is</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Mes</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Draad</translation>
    </message>
    <message>
        <source>Put one above the part to roll it out with: it turns as it is moved</source>
        <translation>Zet er een boven het onderdeel om het uit te rollen: hij draait terwijl hij wordt verplaatst</translation>
    </message>
    <message>
        <source>Roller</source>
        <translation>Rol</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Indrukken</translation>
    </message>
    <message>
        <source>Hold one end of the new part and let a block press it, to see what it does</source>
        <translation>Houdt het nieuwe onderdeel aan één eind vast en drukt het met een blok, om te zien wat het doet</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Handboek</translation>
    </message>
    <message>
        <source>At the page of what one does</source>
        <translation>Op de pagina van wat men doet</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>Nieuw &amp;venster</translation>
    </message>
    <message>
        <source>Begin something else; what is open here stays</source>
        <translation>Iets anders beginnen; wat hier open is, blijft</translation>
    </message>
    <message>
        <source>First pa&amp;ge</source>
        <translation>Eerste pa&amp;gina</translation>
    </message>
    <message>
        <source>Examples and files of late; the part that is open stays, and Esc comes back</source>
        <translation>Voorbeelden en recente bestanden; het open onderdeel blijft, en Esc keert terug</translation>
    </message>
    <message>
        <source>Add &amp;part...</source>
        <translation>Onderdeel &amp;toevoegen...</translation>
    </message>
    <message>
        <source>Save &amp;picture...</source>
        <translation>Af&amp;beelding opslaan...</translation>
    </message>
    <message>
        <source>Write what the view shows as a picture of any size</source>
        <translation>Wat het aanzicht toont als afbeelding van elke grootte schrijven</translation>
    </message>
    <message>
        <source>Warnings in the view</source>
        <translation>Waarschuwingen in het beeld</translation>
    </message>
    <message>
        <source>Mark where the part is folded over itself, got thin or is about to break</source>
        <translation>Markeren waar het onderdeel over zichzelf gevouwen is, dun werd of bijna breekt</translation>
    </message>
    <message>
        <source>&amp;Tour on a block of clay</source>
        <translation>&amp;Rondleiding met een blok klei</translation>
    </message>
    <message>
        <source>Press it, pull it, export it: in two minutes</source>
        <translation>Drukken, trekken, exporteren: in twee minuten</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>S&amp;luiten</translation>
    </message>
    <message>
        <source>Back to the first page with nothing open; what is not saved is asked about</source>
        <translation>Terug naar de eerste pagina met niets open; naar wat niet is opgeslagen wordt gevraagd</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Vervormen met getallen</translation>
    </message>
    <message>
        <source>Bend, twist, taper, stretch, shear or scale the part by numbers between two planes</source>
        <translation>Het onderdeel tussen twee vlakken met getallen buigen, verdraaien, taps maken, rekken, schuiven of schalen</translation>
    </message>
    <message>
        <source>&amp;Deform by a field...</source>
        <translation>&amp;Vervormen met een veld...</translation>
    </message>
    <message>
        <source>Move the part by displacements that another program computed, or against them</source>
        <translation>Het onderdeel verplaatsen volgens verplaatsingen die een ander programma heeft berekend, of er tegenin</translation>
    </message>
    <message>
        <source>Bend...</source>
        <translation>Buigen...</translation>
    </message>
    <message>
        <source>Bend the part into an arc by an angle or a radius</source>
        <translation>Het onderdeel met een hoek of straal tot een boog buigen</translation>
    </message>
    <message>
        <source>Twist...</source>
        <translation>Verdraaien...</translation>
    </message>
    <message>
        <source>Twist the part about an axis by an angle</source>
        <translation>Het onderdeel met een hoek om een as verdraaien</translation>
    </message>
    <message>
        <source>Taper...</source>
        <translation>Taps maken...</translation>
    </message>
    <message>
        <source>Make the part thicker or thinner toward one end</source>
        <translation>Het onderdeel naar één einde toe dikker of dunner maken</translation>
    </message>
    <message>
        <source>Stretch...</source>
        <translation>Rekken...</translation>
    </message>
    <message>
        <source>Make the part longer or shorter between two planes</source>
        <translation>Het onderdeel tussen twee vlakken langer of korter maken</translation>
    </message>
    <message>
        <source>Shear...</source>
        <translation>Schuiven...</translation>
    </message>
    <message>
        <source>Move one end of the part sideways</source>
        <translation>Eén einde van het onderdeel zijwaarts bewegen</translation>
    </message>
    <message>
        <source>Scale between planes...</source>
        <translation>Schalen tussen vlakken...</translation>
    </message>
    <message>
        <source>Make one end of the part larger or smaller in all directions</source>
        <translation>Eén einde van het onderdeel in alle richtingen groter of kleiner maken</translation>
    </message>
    <message>
        <source>Appl&amp;y to another part...</source>
        <translation>Op een ander onderdeel &amp;toepassen...</translation>
    </message>
    <message>
        <source>Do what was done here to another part, such as the next revision of this one</source>
        <translation>Met een ander onderdeel, zoals de volgende revisie van dit, doen wat hier is gedaan</translation>
    </message>
    <message>
        <source>&amp;Python trace</source>
        <translation>&amp;Python-verslag</translation>
    </message>
    <message>
        <source>Show what you do as a script for Python, as you do it</source>
        <translation>Tonen wat u doet als script voor Python, terwijl u het doet</translation>
    </message>
    <message>
        <source>Put the parts of other files beside those that are open, in the shape that these have now</source>
        <translation>Onderdelen van andere bestanden naast de geopende leggen, in de vorm die deze nu hebben</translation>
    </message>
</context>
<context>
    <name>Availability</name>
    <message>
        <source>Open a part first.</source>
        <translation>Open eerst een onderdeel.</translation>
    </message>
    <message>
        <source>Nothing in this part is closed, so nothing can be simulated.</source>
        <translation>Niets in dit onderdeel is gesloten, dus er kan niets gesimuleerd worden.</translation>
    </message>
</context>
<context>
    <name>Balance</name>
    <message>
        <source>Load step %1: %2</source>
        <translation>Belastingstap %1: %2</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Het lichaam</translation>
    </message>
    <message>
        <source>A body is free to move: hold it, or let time run (dynamic) until it rests on something.</source>
        <translation>Een lichaam kan vrij bewegen: houd het vast, of laat de tijd lopen tot het ergens op rust.</translation>
    </message>
    <message>
        <source>A load step takes more than 0 and up to 3600 s.</source>
        <translation>Een belastingstap duurt meer dan 0 en hoogstens 3600 s.</translation>
    </message>
    <message>
        <source>%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).</source>
        <translation>%1 is star en kan vrij bewegen: houd het vast, maak het vervormbaar, of laat de tijd lopen.</translation>
    </message>
    <message>
        <source>No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps or a smaller load, hold what is free to slide or turn, or let time run (dynamic).</source>
        <translation>Bij %1 s is geen evenwicht gevonden: krachten van %2 van die welke werken zijn over. Neem meer belastingstappen of een kleinere belasting, houd vast wat kan glijden of draaien, of laat de tijd lopen.</translation>
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
    <name>ColorLegend</name>
    <message>
        <source>Looking back does not keep this of material that has flowed or is pressed: return to the present, or choose displacement or strain.</source>
        <translation>Terugblikken bewaart dit niet voor materiaal dat gevloeid heeft of ingedrukt is: ga terug naar het heden, of kies verplaatsing of rek.</translation>
    </message>
    <message>
        <source>This moment does not tell it yet: it comes with the next step.</source>
        <translation>Dit moment geeft het nog niet aan: het komt met de volgende stap.</translation>
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
        <translation>Grijs</translation>
    </message>
</context>
<context>
    <name>ColorScale</name>
    <message>
        <source>Displacement</source>
        <translation>Verplaatsing</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Rek</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von Mises-spanning</translation>
    </message>
    <message>
        <source>Plastic strain</source>
        <translation>Plastische rek</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Contactkracht</translation>
    </message>
    <message>
        <source>Distance to the original</source>
        <translation>Afstand tot het origineel</translation>
    </message>
    <message>
        <source>%1, about ±%2 %</source>
        <translation>%1, ongeveer ±%2 %</translation>
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
    <message>
        <source>Not possible now.</source>
        <translation>Nu niet mogelijk.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>One of the files has no closed part: there is nothing to compare.</source>
        <translation>Een van de bestanden heeft geen gesloten onderdeel: er is niets te vergelijken.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of the original belongs to no closed part of the other file.</source>
        <translation>Bij &quot;%1&quot; van het origineel hoort geen gesloten onderdeel van het andere bestand.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to no closed part of the original.</source>
        <translation>&quot;%1&quot; hoort bij geen gesloten onderdeel van het origineel.</translation>
    </message>
</context>
<context>
    <name>ComparisonDialog</name>
    <message>
        <source>Compare with original</source>
        <translation>Met origineel vergelijken</translation>
    </message>
    <message>
        <source>How far the skin is from the nearest point of the original surface, at %1 of simulated time. The mean is by area.</source>
        <translation>Hoe ver de huid van het dichtstbijzijnde punt van het oorspronkelijke oppervlak ligt, bij %1 gesimuleerde tijd. Het gemiddelde is gewogen naar oppervlakte.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Grootste afstand</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Gemiddelde afstand</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Grootste verplaatsing</translation>
    </message>
    <message>
        <source>Volume at rest</source>
        <translation>Volume in rust</translation>
    </message>
    <message>
        <source>Volume now</source>
        <translation>Volume nu</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Verandering</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Write report...</source>
        <translation>Verslag schrijven...</translation>
    </message>
    <message>
        <source>A page with these numbers, what was measured and a picture of the view, as PDF or HTML</source>
        <translation>Een pagina met deze getallen, wat er gemeten is en een beeld van het aanzicht, als PDF of HTML</translation>
    </message>
</context>
<context>
    <name>ComparisonFeature</name>
    <message>
        <source>Comparing with the original</source>
        <translation>Met het origineel vergelijken</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Een verslag schrijven</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html *.htm)</source>
        <translation>Webpagina (*.html *.htm)</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Grootste afstand</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Gemiddelde afstand</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Grootste verplaatsing</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Center of mass moved</source>
        <translation>Verplaatsing massamiddelpunt</translation>
    </message>
    <message>
        <source>%1 beside its original</source>
        <translation>%1 naast het origineel</translation>
    </message>
    <message>
        <source>At %1 of simulated time. Written by Knead on %2.</source>
        <translation>Bij %1 gesimuleerde tijd. Geschreven door Knead op %2.</translation>
    </message>
    <message>
        <source>Distances are those of the deformed skin from the nearest point of the original surface; the mean is by area. A displacement is the way of a point of the skin since rest.</source>
        <translation>Afstanden zijn die van de vervormde huid tot het dichtstbijzijnde punt van het oorspronkelijke oppervlak; het gemiddelde is gewogen naar oppervlakte. Een verplaatsing is de weg van een punt van de huid sinds de rusttoestand.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Metingen</translation>
    </message>
    <message>
        <source>%1 beside %2</source>
        <translation>%1 naast %2</translation>
    </message>
    <message>
        <source>Written by Knead on %1.</source>
        <translation>Geschreven door Knead op %1.</translation>
    </message>
    <message>
        <source>Distances are those of each surface from the nearest point of the other, the larger of both; the mean is by area.</source>
        <translation>Afstanden zijn die van elk oppervlak tot het dichtstbijzijnde punt van het andere, de grootste van beide; het gemiddelde is naar oppervlakte.</translation>
    </message>
</context>
<context>
    <name>Compensation</name>
    <message>
        <source>&quot;faces&quot; names face %1 of %2, which has %3; they are numbered from 0.</source>
        <translation>&quot;faces&quot; noemt vlak %1 van %2, dat er %3 heeft; ze zijn vanaf 0 genummerd.</translation>
    </message>
    <message>
        <source>&quot;faces&quot; names %1, which is no part of the target; knead info shows their names.</source>
        <translation>&quot;faces&quot; noemt %1, dat geen onderdeel van het doel is; knead info toont hun namen.</translation>
    </message>
    <message>
        <source>Points every %1 would be more than %2; choose a larger &quot;spacing_mm&quot;.</source>
        <translation>Punten om de %1 zouden er meer dan %2 zijn; kies een grotere &quot;spacing_mm&quot;.</translation>
    </message>
    <message>
        <source>The target has no surface; name another part.</source>
        <translation>Het doel heeft geen oppervlak; noem een ander onderdeel.</translation>
    </message>
    <message>
        <source>What came out of round %1 has places that are no numbers; look at what its command wrote.</source>
        <translation>Wat uit ronde %1 kwam heeft plaatsen die geen getallen zijn; bekijk wat haar opdracht schreef.</translation>
    </message>
</context>
<context>
    <name>Curvature</name>
    <message>
        <source>Curvature</source>
        <translation>Kromming</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>hol</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>vlak</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>bol</translation>
    </message>
</context>
<context>
    <name>Cut</name>
    <message>
        <source>A cut needs a plane: a point, and a normal that is not zero.</source>
        <translation>Een snede vraagt een vlak: een punt, en een normaal die niet nul is.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is rigid, and is not cut. Make it deformable first.</source>
        <translation>&quot;%1&quot; is star en wordt niet gesneden. Maak het eerst vervormbaar.</translation>
    </message>
    <message>
        <source>The plane meets nothing of &quot;%1&quot; that could be cut.</source>
        <translation>Het vlak raakt niets van &quot;%1&quot; dat gesneden kan worden.</translation>
    </message>
</context>
<context>
    <name>DeformFeature</name>
    <message>
        <source>Fields (%1)</source>
        <translation>Velden (%1)</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Vervormen</translation>
    </message>
    <message>
        <source>Come back to the present first: Esc.</source>
        <translation>Kom eerst terug naar het heden: Esc.</translation>
    </message>
    <message>
        <source>No part is selected: click one in the tree, or choose all parts.</source>
        <translation>Geen onderdeel is geselecteerd: klik er een aan in de boom, of kies alle onderdelen.</translation>
    </message>
    <message>
        <source>Deform by a field</source>
        <translation>Vervormen met een veld</translation>
    </message>
    <message>
        <source>Projects of Knead</source>
        <translation>Projecten van Knead</translation>
    </message>
    <message>
        <source>Scans of the part</source>
        <translation>Scans van het onderdeel</translation>
    </message>
</context>
<context>
    <name>DeformPanel</name>
    <message>
        <source>Apply</source>
        <translation>Toepassen</translation>
    </message>
    <message>
        <source>Parts are bent, twisted, tapered, stretched, sheared or scaled by numbers here, or by the displacements of another program: File &gt; Deform by a field.</source>
        <translation>Hier worden onderdelen met getallen gebogen, verdraaid, taps gemaakt, gerekt, verschoven of geschaald, of met de verplaatsingen van een ander programma: Bestand &gt; Vervormen met een veld.</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Vervormen met getallen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Esc: everything stays as it is</source>
        <translation>Esc: alles blijft zoals het is</translation>
    </message>
    <message>
        <source>Enter in the view: the parts become what is shown</source>
        <translation>Enter in het beeld: de onderdelen worden wat getoond is</translation>
    </message>
</context>
<context>
    <name>DeformStage</name>
    <message>
        <source>Something else was done while the parts were deformed, so they stay as they are. Apply the deformation again.</source>
        <translation>Terwijl de onderdelen werden vervormd gebeurde er iets anders, dus ze blijven zoals ze zijn. Pas de vervorming opnieuw toe.</translation>
    </message>
</context>
<context>
    <name>Deformation</name>
    <message>
        <source>The field has %1 nodes, but %2 displacements.</source>
        <translation>Het veld heeft %1 knopen, maar %2 verplaatsingen.</translation>
    </message>
    <message>
        <source>Node %1 of the field has a number that is not finite, or far too large; leave that node out, or write the file again.</source>
        <translation>Knoop %1 van het veld heeft een getal dat niet eindig is, of veel te groot; laat die knoop weg, of schrijf het bestand opnieuw.</translation>
    </message>
    <message>
        <source>A bend of %1 mm radius would fold the material on its inner side, which reaches %2 mm from the neutral plane. The radius must be larger than that: take a smaller angle, planes farther apart, or a neutral plane nearer to the inner side.</source>
        <translation>Een buiging met een straal van %1 mm zou het materiaal aan de binnenkant vouwen, dat tot %2 mm van het neutrale vlak reikt. De straal moet groter zijn: neem een kleinere hoek, grensvlakken verder uit elkaar of een neutraal vlak dichter bij de binnenkant.</translation>
    </message>
    <message>
        <source>A direction of no length is none; give x, y, z, or three numbers.</source>
        <translation>Een richting zonder lengte is er geen; geef x, y, z of drie getallen.</translation>
    </message>
    <message>
        <source>The side runs along the axis, but must lie across it; choose another one.</source>
        <translation>De zijde loopt langs de as, maar moet er dwars op liggen; kies een andere.</translation>
    </message>
    <message>
        <source>Only a bend has a radius and a plane that keeps its length; leave them out.</source>
        <translation>Alleen een buiging heeft een straal en een vlak dat zijn lengte houdt; laat ze weg.</translation>
    </message>
    <message>
        <source>The plane that keeps its length is given twice, by its place and by a k factor; leave one of them out.</source>
        <translation>Het vlak dat zijn lengte houdt is twee keer opgegeven, door zijn plaats en door een k-factor; laat er een weg.</translation>
    </message>
    <message>
        <source>A k factor is between 0, inside, and 1, outside.</source>
        <translation>Een k-factor ligt tussen 0, binnen, en 1, buiten.</translation>
    </message>
    <message>
        <source>Angle and radius say where the bend ends; leave out the second plane.</source>
        <translation>Hoek en straal zeggen waar de buiging eindigt; laat het tweede vlak weg.</translation>
    </message>
    <message>
        <source>The radius of a bend must be larger than 0.</source>
        <translation>De straal van een buiging moet groter zijn dan 0.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Neutral plane</source>
        <translation>Neutraal vlak</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschuiving</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Buigen</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torderen</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Versmallen</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Rekken</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Afschuiven</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schalen</translation>
    </message>
    <message>
        <source>%1 of %2 parts came back from being deformed; nothing was changed.</source>
        <translation>%1 van %2 onderdelen kwamen vervormd terug; er is niets veranderd.</translation>
    </message>
    <message>
        <source>%1 takes %2; this is &quot;%3&quot;.</source>
        <translation>%1 verwacht %2; dit is &quot;%3&quot;.</translation>
    </message>
    <message>
        <source>%1 says nothing about what stands before it; put it behind the deformation that it is for.</source>
        <translation>%1 zegt niets over wat ervoor staat; zet het achter de vervorming waarvoor het geldt.</translation>
    </message>
    <message>
        <source>No folder could be made in %1; make room there and try again.</source>
        <translation>In %1 kon geen map worden gemaakt; maak daar ruimte en probeer het opnieuw.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3, numbered from 0, and meshes have none.</source>
        <translation>&quot;%1&quot; heeft geen vlak %2; het heeft er %3, genummerd vanaf 0, en netten hebben er geen.</translation>
    </message>
    <message>
        <source>Which part the faces %1 are of is not clear; put its name before them, as Lid:%1.</source>
        <translation>Van welk onderdeel de vlakken %1 zijn is niet duidelijk; zet de naam ervoor, zoals Deksel:%1.</translation>
    </message>
    <message>
        <source>%1 parts that are deformed are called &quot;%2&quot;, not one; knead info --json lists the names and paths of all.</source>
        <translation>%1 onderdelen die vervormd worden heten &quot;%2&quot;, niet één; knead info --json noemt de namen en paden van alle.</translation>
    </message>
    <message>
        <source>it has no surface to be deformed.</source>
        <translation>het heeft geen oppervlak om te vervormen.</translation>
    </message>
    <message>
        <source>There is no part or assembly &quot;%1&quot; in %2; knead info --json lists the names and paths of all.</source>
        <translation>Er is geen onderdeel of samenstelling &quot;%1&quot; in %2; knead info --json noemt de namen en paden van alle.</translation>
    </message>
    <message>
        <source>The field has no nodes.</source>
        <translation>Het veld heeft geen knopen.</translation>
    </message>
    <message>
        <source>The factor of a deformation is no number.</source>
        <translation>De factor van een vervorming is geen getal.</translation>
    </message>
    <message>
        <source>Faces that stay where they are need a distance over which the deformation fades.</source>
        <translation>Vlakken die blijven waar ze zijn, hebben een afstand nodig waarover de vervorming uitloopt.</translation>
    </message>
    <message>
        <source>A face that stays where it is has a corner that is no place.</source>
        <translation>Een vlak dat blijft waar het is, heeft een hoek die geen plaats is.</translation>
    </message>
    <message>
        <source>The axis of a deformation has a coordinate that is no number.</source>
        <translation>De as van een vervorming heeft een coördinaat die geen getal is.</translation>
    </message>
    <message>
        <source>A deformation by number has a value that is no number.</source>
        <translation>Een vervorming met getallen heeft een waarde die geen getal is.</translation>
    </message>
    <message>
        <source>The second plane of a deformation must lie behind the first one, along its axis.</source>
        <translation>Het tweede vlak van een vervorming moet langs haar as achter het eerste liggen.</translation>
    </message>
    <message>
        <source>The side of a deformation must point across its axis.</source>
        <translation>De zijde van een vervorming moet dwars op haar as wijzen.</translation>
    </message>
    <message>
        <source>A bend or a twist goes around ten times at most: take a smaller angle, or a larger radius.</source>
        <translation>Een buiging of verdraaiing gaat hoogstens tien keer rond: neem een kleinere hoek of een grotere straal.</translation>
    </message>
    <message>
        <source>What stays of a deformation lies between its planes: from 0 at the first one to 1 at the second one.</source>
        <translation>Wat bij een vervorming blijft ligt tussen haar vlakken: van 0 bij het eerste tot 1 bij het tweede.</translation>
    </message>
    <message>
        <source>The factor of a deformation must be larger than 0.</source>
        <translation>De factor van een vervorming moet groter dan 0 zijn.</translation>
    </message>
    <message>
        <source>A gentle stretch cannot shorten to less than 0.47: the middle would fold. Take a larger factor, or do not ease it.</source>
        <translation>Een zachte rek kan niet tot minder dan 0,47 verkorten: het midden zou vouwen. Neem een grotere factor, of laat haar niet zacht beginnen.</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Het lichaam</translation>
    </message>
    <message>
        <source>Deforming by physics takes 0.01 to 3600 s.</source>
        <translation>Vervormen door fysica duurt 0,01 tot 3600 s.</translation>
    </message>
    <message>
        <source>%1 lies wholly beyond one of the planes, so that it would only be carried along. Put the planes where it is to be deformed.</source>
        <translation>%1 ligt geheel voorbij een van de grensvlakken en zou alleen worden meegenomen. Zet de grensvlakken waar het vervormd moet worden.</translation>
    </message>
    <message>
        <source>Nothing of %1 is free between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Niets van %1 is vrij tussen de grensvlakken: zet ze verder uit elkaar, of vul met een kleinere afstand.</translation>
    </message>
    <message>
        <source>%1 does not reach both planes, so that grips cannot hold it on both sides. Put the planes where it is, or at its ends.</source>
        <translation>%1 reikt niet tot beide grensvlakken, zodat grepen het niet aan beide kanten kunnen vasthouden. Zet de grensvlakken waar het is, of aan zijn uiteinden.</translation>
    </message>
    <message>
        <source>Physics bends, twists, stretches and shears, which grips at the ends can do. &quot;%1&quot; changes the ends themselves: do it exactly.</source>
        <translation>De fysica buigt, verdraait, rekt en schuift, wat grepen aan de uiteinden kunnen. &quot;%1&quot; verandert de uiteinden zelf: doe het exact.</translation>
    </message>
    <message>
        <source>There is no part that could be deformed.</source>
        <translation>Er is geen onderdeel dat vervormd kan worden.</translation>
    </message>
    <message>
        <source>%1 is rigid: physics deforms what can be deformed. Make it deformable first.</source>
        <translation>%1 is star: de fysica vervormt wat vervormbaar is. Maak het eerst vervormbaar.</translation>
    </message>
    <message>
        <source>Less than two spacings of %1 lie between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Minder dan twee afstanden van %1 liggen tussen de grensvlakken: zet ze verder uit elkaar, of vul met een kleinere afstand.</translation>
    </message>
    <message>
        <source>--physics does one bend, twist, stretch or shear at a time; give one of them, and for more write a recipe.</source>
        <translation>--physics doet één buiging, verdraaiing, rek of afschuiving tegelijk; geef er een van op, en schrijf voor meer een recept.</translation>
    </message>
    <message>
        <source>--physics deforms one part or all of them; for some write a recipe.</source>
        <translation>--physics vervormt één onderdeel of allemaal; schrijf voor enkele een recept.</translation>
    </message>
    <message>
        <source>--physics needs to know what the part is made of: give --material, one of %1.</source>
        <translation>--physics moet weten waar het onderdeel van gemaakt is: geef --material, een van %1.</translation>
    </message>
    <message>
        <source>There is no material &quot;%1&quot;; --material is one of %2.</source>
        <translation>Er is geen materiaal &quot;%1&quot;; --material is een van %2.</translation>
    </message>
    <message>
        <source>%1: the ending is none of %2; name the file after its format.</source>
        <translation>%1: de extensie is geen van %2; noem het bestand naar zijn formaat.</translation>
    </message>
    <message>
        <source>A part is filled with %1 objects at least.</source>
        <translation>Een onderdeel wordt met minstens %1 objecten gevuld.</translation>
    </message>
</context>
<context>
    <name>Deforming</name>
    <message>
        <source>Preview: %1</source>
        <translation>Voorbeeld: %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 lezen</translation>
    </message>
    <message>
        <source>Preview: deformed by %1</source>
        <translation>Voorbeeld: vervormd met %1</translation>
    </message>
    <message>
        <source>The field turns material inside out near %1, %2, %3 mm. Take a smaller factor.</source>
        <translation>Het veld keert materiaal binnenstebuiten bij %1, %2, %3 mm. Neem een kleinere factor.</translation>
    </message>
    <message>
        <source>Deformed by %1</source>
        <translation>Vervormd met %1</translation>
    </message>
    <message>
        <source>Deformed by %1, times %2</source>
        <translation>Vervormd met %1, maal %2</translation>
    </message>
    <message>
        <source>Deforming by %1</source>
        <translation>Vervormen met %1</translation>
    </message>
    <message>
        <source>The second plane must lie behind the first one, along the axis.</source>
        <translation>Het tweede vlak moet langs de as achter het eerste liggen.</translation>
    </message>
    <message>
        <source>Select a flat face first, whose normal is to be the axis.</source>
        <translation>Selecteer eerst een plat vlak waarvan de normaal de as wordt.</translation>
    </message>
    <message>
        <source>The bend is tighter than the material allows, which would fold: at least a radius of %1, or at most %2 between these planes.</source>
        <translation>De bocht is krapper dan het materiaal toelaat, dat zou vouwen: een straal van minstens %1, of hoogstens %2 tussen deze vlakken.</translation>
    </message>
    <message>
        <source>Bent by %1</source>
        <translation>%1 gebogen</translation>
    </message>
    <message>
        <source>Twisted by %1</source>
        <translation>%1 verdraaid</translation>
    </message>
    <message>
        <source>Tapered to %1</source>
        <translation>Taps tot %1</translation>
    </message>
    <message>
        <source>Stretched to %1</source>
        <translation>Gerekt tot %1</translation>
    </message>
    <message>
        <source>Sheared by %1</source>
        <translation>%1 verschoven</translation>
    </message>
    <message>
        <source>Scaled to %1</source>
        <translation>Geschaald tot %1</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Buigen</translation>
    </message>
    <message>
        <source>Twisting</source>
        <translation>Verdraaien</translation>
    </message>
    <message>
        <source>Tapering</source>
        <translation>Taps maken</translation>
    </message>
    <message>
        <source>Stretching</source>
        <translation>Rekken</translation>
    </message>
    <message>
        <source>Shearing</source>
        <translation>Schuiven</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Schalen</translation>
    </message>
    <message>
        <source>%1 by physics</source>
        <translation>%1 door fysica</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>Skin</source>
        <translation>Huid</translation>
    </message>
    <message>
        <source>Show the surface of the part; as through glass when what is inside is shown too</source>
        <translation>Het oppervlak van het onderdeel tonen; als door glas wanneer ook de binnenkant getoond wordt</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindingen</translation>
    </message>
    <message>
        <source>Show the connections between objects as lines</source>
        <translation>De verbindingen tussen objecten als lijnen tonen</translation>
    </message>
    <message>
        <source>Original shape</source>
        <translation>Oorspronkelijke vorm</translation>
    </message>
    <message>
        <source>Show the shape at rest, translucent, around what became of it</source>
        <translation>De vorm in rust doorschijnend tonen, rond wat ervan geworden is</translation>
    </message>
    <message>
        <source>Broken connections</source>
        <translation>Gebroken verbindingen</translation>
    </message>
    <message>
        <source>Mark where connections broke</source>
        <translation>Aangeven waar verbindingen braken</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Doorsnedevlak</translation>
    </message>
    <message>
        <source>Cut the part open to look inside; drag the knob to move the plane</source>
        <translation>Het onderdeel opensnijden om erin te kijken; sleep de knop om het vlak te verplaatsen</translation>
    </message>
    <message>
        <source>Flip section</source>
        <translation>Doorsnede omkeren</translation>
    </message>
    <message>
        <source>Cut off the other side</source>
        <translation>De andere kant wegsnijden</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Voor en na</translation>
    </message>
    <message>
        <source>Divide the view: the original on the left, the part as it is on the right</source>
        <translation>Het aanzicht delen: links het origineel, rechts het onderdeel zoals het is</translation>
    </message>
    <message>
        <source>Part colors</source>
        <translation>Onderdeelkleuren</translation>
    </message>
    <message>
        <source>Faces have the colors of the part</source>
        <translation>Vlakken hebben de kleuren van het onderdeel</translation>
    </message>
    <message>
        <source>Color the skin by: %1</source>
        <translation>Huid kleuren naar: %1</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Weergave</translation>
    </message>
    <message>
        <source>What is shown of the material, and how</source>
        <translation>Wat van het materiaal getoond wordt, en hoe</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>From which colors to which numbers are shown</source>
        <translation>Met welke kleuren getallen worden getoond</translation>
    </message>
    <message>
        <source>Range as needed</source>
        <translation>Bereik naar behoefte</translation>
    </message>
    <message>
        <source>The colors reach as far as the numbers do</source>
        <translation>De kleuren reiken zo ver als de getallen</translation>
    </message>
    <message>
        <source>This quantity has colors of its own, since it has two signs.</source>
        <translation>Deze grootheid heeft eigen kleuren, omdat ze twee tekens heeft.</translation>
    </message>
    <message>
        <source>Color the skin by a quantity first.</source>
        <translation>Kleur eerst de huid naar een grootheid.</translation>
    </message>
    <message>
        <source>Section across X</source>
        <translation>Doorsnede dwars op X</translation>
    </message>
    <message>
        <source>Section across Y</source>
        <translation>Doorsnede dwars op Y</translation>
    </message>
    <message>
        <source>Section across Z</source>
        <translation>Doorsnede dwars op Z</translation>
    </message>
    <message>
        <source>Section towards the eye</source>
        <translation>Doorsnede naar het oog toe</translation>
    </message>
    <message>
        <source>Cut the part open through its middle</source>
        <translation>Het onderdeel door het midden opensnijden</translation>
    </message>
    <message>
        <source>Hatched</source>
        <translation>Gearceerd</translation>
    </message>
    <message>
        <source>Draw lines across what is cut</source>
        <translation>Lijnen over het gesnedene tekenen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Doorsnede</translation>
    </message>
    <message>
        <source>Color map: %1</source>
        <translation>Kleurschaal: %1</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Gewoon</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Klei</translation>
    </message>
    <message>
        <source>Polished</source>
        <translation>Gepolijst</translation>
    </message>
    <message>
        <source>Zebra</source>
        <translation>Zebra</translation>
    </message>
    <message>
        <source>Faces have the colors of the part, in soft light</source>
        <translation>Vlakken hebben de kleuren van het onderdeel, in zacht licht</translation>
    </message>
    <message>
        <source>All parts in one matt color: nothing but their shape is seen</source>
        <translation>Alle onderdelen in één matte kleur: alleen hun vorm is te zien</translation>
    </message>
    <message>
        <source>Parts shine as polished metal does</source>
        <translation>Onderdelen glanzen als gepolijst metaal</translation>
    </message>
    <message>
        <source>Parts mirror stripes, which break where faces do not join smoothly</source>
        <translation>Onderdelen spiegelen strepen, die breken waar vlakken niet vloeiend op elkaar aansluiten</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schaduwering</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Kromming</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>Chroom</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porselein</translation>
    </message>
    <message>
        <source>Blue where parts are hollow, white where they are flat, orange where they bulge</source>
        <translation>Blauw waar onderdelen hol zijn, wit waar ze vlak zijn, oranje waar ze bol zijn</translation>
    </message>
    <message>
        <source>Parts are soft and shine through at their rims</source>
        <translation>Onderdelen ogen zacht en schijnen aan hun randen door</translation>
    </message>
    <message>
        <source>All parts mirror a sky and the ground, which shows every dent</source>
        <translation>Alle onderdelen spiegelen een lucht en de grond, wat elke deuk laat zien</translation>
    </message>
    <message>
        <source>All parts are white and glazed</source>
        <translation>Alle onderdelen zijn wit en geglazuurd</translation>
    </message>
</context>
<context>
    <name>DisplayPanel</name>
    <message>
        <source>Map</source>
        <translation>Kleurschaal</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Van, tot</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Colors of the skin</source>
        <translation>Kleuren van de huid</translation>
    </message>
    <message>
        <source>All have even lightness; cividis looks nearly alike to people who see few colors</source>
        <translation>Alle hebben een gelijkmatige helderheid; cividis ziet er bijna hetzelfde uit voor mensen die weinig kleuren zien</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grootheid</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Naar binnen kijken</translation>
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
        <translation>Kijkrichting</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Dwars op</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergelijken</translation>
    </message>
    <message>
        <source>Drag the line in the view: the original on the left, now on the right.</source>
        <translation>Sleep de lijn in het aanzicht: links het origineel, rechts nu.</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schaduwering</translation>
    </message>
    <message>
        <source>Place of the section plane</source>
        <translation>Plaats van het doorsnedevlak</translation>
    </message>
</context>
<context>
    <name>DividerHandle</name>
    <message>
        <source>Drag: the original on the left, the part as it is on the right</source>
        <translation>Slepen: links het origineel, rechts het onderdeel zoals het is</translation>
    </message>
    <message>
        <source>Divider between before and after</source>
        <translation>Scheiding tussen voor en na</translation>
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
        <source>&quot;%1&quot; is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.</source>
        <translation>&quot;%1&quot; is een net zonder CAD-vlakken: open het als STEP, IGES of BREP om vlakken vast te zetten.</translation>
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
    <message>
        <source>Rename to %1</source>
        <translation>Hernoemen naar %1</translation>
    </message>
    <message>
        <source>Color of %1</source>
        <translation>Kleur van %1</translation>
    </message>
    <message>
        <source>Something is called &quot;%1&quot; already: choose another name.</source>
        <translation>Er heet al iets &quot;%1&quot;: kies een andere naam.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked in the model tree: unlock it there to change it.</source>
        <translation>&quot;%1&quot; is vergrendeld in de modelboom: ontgrendel het daar om het te wijzigen.</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Selectie vastzetten</translation>
    </message>
    <message>
        <source>The selection holds no objects: it is smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>De selectie bevat geen objecten: ze is kleiner dan de afstand. Kies een fijnere afstand en vul opnieuw.</translation>
    </message>
    <message>
        <source>Material of selection</source>
        <translation>Materiaal van selectie</translation>
    </message>
    <message>
        <source>Material of selection → %1</source>
        <translation>Materiaal van selectie → %1</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Selectie hernormaliseren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names edges or connections of another filling: undo to go back to that, or select them again and save them under this name.</source>
        <translation>&quot;%1&quot; benoemt randen of verbindingen van een andere vulling: ga daar met Ongedaan maken naar terug, of kies ze opnieuw en sla ze onder deze naam op.</translation>
    </message>
    <message>
        <source>There is not enough memory to go to %1. Close other programs and try again.</source>
        <translation>Er is niet genoeg geheugen om naar %1 te gaan. Sluit andere programma&apos;s en probeer het opnieuw.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then find the balance.</source>
        <translation>%1 is nog bezig: wacht, of breek af met Esc, en zoek dan het evenwicht.</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Evenwicht zoeken</translation>
    </message>
    <message>
        <source>Finding the balance</source>
        <translation>Evenwicht zoeken</translation>
    </message>
    <message>
        <source>In balance: no force acts on the part.</source>
        <translation>In evenwicht: op het onderdeel werkt geen kracht.</translation>
    </message>
    <message>
        <source>In balance: the forces that are left are %1 of those that act.</source>
        <translation>In evenwicht: de krachten die overblijven zijn %1 van die welke werken.</translation>
    </message>
    <message>
        <source>No body is of material that yields: elastic ones keep their shape at rest, and are not filled anew.</source>
        <translation>Geen lichaam is van materiaal dat vloeit: elastische houden hun rustvorm en worden niet opnieuw gevuld.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Indrukken</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then deform again.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc, en vervorm dan opnieuw.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>Add %1 and others</source>
        <translation>%1 en andere toevoegen</translation>
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
        <source>the load</source>
        <translation>de belasting</translation>
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
    <message>
        <source>Look of a part</source>
        <translation>Uiterlijk van een onderdeel</translation>
    </message>
    <message>
        <source>Look of %1</source>
        <translation>Uiterlijk van %1</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>Hernoemen naar %1</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Evenwicht zoeken</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>%1 opnieuw vullen</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 snijden</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>&quot;%1&quot; is cut into or cracked, but in one piece: it gapes by %2 mm.</source>
        <translation>&quot;%1&quot; is ingesneden of gescheurd, maar nog één stuk: de spleet is %2 mm wijd.</translation>
    </message>
    <message>
        <source>a cut or crack ends in it, whose sides are no faces of the part.</source>
        <translation>er eindigt een snede of scheur in, waarvan de zijden geen vlakken van het onderdeel zijn.</translation>
    </message>
    <message>
        <source>it was filled anew before: its fields are left out.</source>
        <translation>het is eerder opnieuw gevuld: de velden ervan zijn weggelaten.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: 1 of its connections is broken, and its skin spans the crack, stretched to %2 times its length there near %3.</source>
        <translation>&quot;%1&quot; is gescheurd maar nog één stuk: 1 van de verbindingen is gebroken, en de huid overspant de scheur, bij %3 tot %2 keer de lengte gerekt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: %2 of its connections are broken, and its skin spans the crack, stretched to %3 times its length there near %4.</source>
        <translation>&quot;%1&quot; is gescheurd maar nog één stuk: %2 van de verbindingen zijn gebroken, en de huid overspant de scheur, bij %4 tot %3 keer de lengte gerekt.</translation>
    </message>
    <message>
        <source>its cracks could not be made into surfaces: other pieces of it are written as one with it; objects in them: %1.</source>
        <translation>van de scheuren konden geen vlakken worden gemaakt: andere stukken ervan worden er als één geheel mee geschreven; objecten erin: %1.</translation>
    </message>
    <message>
        <source>pieces too small for a shape of their own are written as part of it; objects in them: %1.</source>
        <translation>stukken die te klein zijn voor een eigen vorm worden als deel ervan geschreven; objecten erin: %1.</translation>
    </message>
    <message>
        <source>cracks end in it, and its skin spans them; connections broken there: %1.</source>
        <translation>er eindigen scheuren in, en de huid overspant ze; daar gebroken verbindingen: %1.</translation>
    </message>
    <message>
        <source>the part is torn; this is one of %1 pieces.</source>
        <translation>het onderdeel is gescheurd; dit is een van %1 stukken.</translation>
    </message>
    <message>
        <source>too few of its objects hang together to say how it is deformed: it is written in its shape at rest, moved as they have.</source>
        <translation>te weinig objecten hangen samen om te zeggen hoe het vervormd is: het wordt in zijn rustvorm geschreven, verplaatst zoals zij.</translation>
    </message>
    <message>
        <source>%1 of its faces could not be carried along: %2.</source>
        <translation>%1 van de vlakken konden niet worden meegevoerd: %2.</translation>
    </message>
    <message>
        <source>its faces do not fit together any more as they are bent now.</source>
        <translation>zo gebogen passen de vlakken niet meer op elkaar.</translation>
    </message>
    <message>
        <source>1 face was added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>Er kwam 1 vlak bij: vlakken die in zichzelf sluiten kwamen in tweeën, wat andere programma’s zekerder lezen.</translation>
    </message>
    <message>
        <source>%1 faces were added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>Er kwamen %1 vlakken bij: vlakken die in zichzelf sluiten kwamen in tweeën, wat andere programma’s zekerder lezen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 is made of flat triangles; its other faces are smooth.</source>
        <translation>&quot;%1&quot;: vlak %2 bestaat uit platte driehoeken; de andere vlakken zijn glad.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: faces %2 are made of flat triangles; its other faces are smooth.</source>
        <translation>&quot;%1&quot;: vlakken %2 bestaan uit platte driehoeken; de andere vlakken zijn glad.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off.</source>
        <translation>&quot;%1&quot;: vlak %2 komt niet zo dicht bij de huid als beoogd, %3 mm; vlak %4 ligt er %5 mm naast.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off.</source>
        <translation>&quot;%1&quot;: %2 vlakken, %3, komen niet zo dicht bij de huid als beoogd, %4 mm; vlak %5 ligt er %6 mm naast.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would need %2 flat faces, more than CAD programs can work with; export it as a mesh.</source>
        <translation>&quot;%1&quot; zou %2 platte vlakken nodig hebben, meer dan CAD-programma&apos;s aankunnen; exporteer het als net.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an open mesh, which CAD files cannot hold; hide it, or export as a mesh.</source>
        <translation>&quot;%1&quot; is een open net, dat CAD-bestanden niet kunnen bevatten; verberg het, of exporteer als net.</translation>
    </message>
    <message>
        <source>it came as a mesh, which has no smooth faces.</source>
        <translation>het kwam als net, dat geen gladde vlakken heeft.</translation>
    </message>
    <message>
        <source>its faces could not be cut where the knife went.</source>
        <translation>de vlakken konden niet worden gesneden waar het mes ging.</translation>
    </message>
    <message>
        <source>other programs may read it inside out, as it came back here.</source>
        <translation>andere programma’s lezen het misschien binnenstebuiten, zoals het hier terugkwam.</translation>
    </message>
    <message>
        <source>its faces were not found again as they were written.</source>
        <translation>de vlakken zijn niet teruggevonden zoals ze geschreven zijn.</translation>
    </message>
    <message>
        <source>faces that met smoothly now meet at an angle near %1; a smaller tolerance may help.</source>
        <translation>vlakken die vloeiend aansloten, maken nu een hoek bij %1; een kleinere tolerantie kan helpen.</translation>
    </message>
    <message>
        <source>The file holds %1 parts where %2 were written.</source>
        <translation>Het bestand bevat %1 onderdelen waar er %2 zijn geschreven.</translation>
    </message>
    <message>
        <source>The exact shapes of the parts are not complete; import the file again.</source>
        <translation>De exacte vormen van de onderdelen zijn niet volledig; importeer het bestand opnieuw.</translation>
    </message>
    <message>
        <source>its bent faces were not found again in the file when that was read back.</source>
        <translation>de gebogen vlakken ervan zijn in het teruggelezen bestand niet teruggevonden.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are inside out.</source>
        <translation>teruggelezen uit het bestand zijn de gebogen vlakken binnenstebuiten.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces do not pass the geometry checks.</source>
        <translation>teruggelezen uit het bestand doorstaan de gebogen vlakken de geometriecontrole niet.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces leave gaps.</source>
        <translation>teruggelezen uit het bestand laten de gebogen vlakken kieren.</translation>
    </message>
    <message>
        <source>read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>teruggelezen uit het bestand liggen de platte vlakken tot %1 mm naast de huid, waar %2 mm is toegestaan.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>teruggelezen uit het bestand liggen de gebogen vlakken tot %1 mm naast de huid waar %2 mm is toegestaan.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces enclose a volume %1 % off that of the skin.</source>
        <translation>teruggelezen uit het bestand omsluiten de gebogen vlakken een volume dat %1 % afwijkt van dat van de huid.</translation>
    </message>
    <message>
        <source>There is nothing to export.</source>
        <translation>Er valt niets te exporteren.</translation>
    </message>
    <message>
        <source>The surface bounds no volume.</source>
        <translation>Het oppervlak omsluit geen volume.</translation>
    </message>
    <message>
        <source>its surface passes through itself near %1; other programs may refuse that.</source>
        <translation>het oppervlak gaat door zichzelf heen bij %1; andere programma&apos;s kunnen dat weigeren.</translation>
    </message>
    <message>
        <source>its material is folded over itself near %1</source>
        <translation>het materiaal is bij %1 over zichzelf gevouwen</translation>
    </message>
    <message>
        <source>%1, and so are its faces.</source>
        <translation>%1, en daarmee ook de vlakken ervan.</translation>
    </message>
    <message>
        <source>A CAD file cannot be written in %1; choose mm, cm, m, inch or ft.</source>
        <translation>Een CAD-bestand kan niet in %1 worden geschreven; kies mm, cm, m, inch of ft.</translation>
    </message>
    <message>
        <source>The parts could not be put into STEP.</source>
        <translation>De onderdelen konden niet naar STEP worden omgezet.</translation>
    </message>
    <message>
        <source>The STEP text could not be written.</source>
        <translation>De STEP-tekst kon niet worden geschreven.</translation>
    </message>
    <message>
        <source>The parts could not be put into IGES.</source>
        <translation>De onderdelen konden niet naar IGES worden omgezet.</translation>
    </message>
    <message>
        <source>The IGES text could not be written.</source>
        <translation>De IGES-tekst kon niet worden geschreven.</translation>
    </message>
    <message>
        <source>The BREP text could not be written.</source>
        <translation>De BREP-tekst kon niet worden geschreven.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a GLB can hold; export fewer bodies, or .gltf.</source>
        <translation>het oppervlak heeft meer nodig dan de 4 GB die een GLB kan bevatten; exporteer minder lichamen, of als .gltf.</translation>
    </message>
    <message>
        <source>the ending is none of %1; name the file after its format.</source>
        <translation>de extensie is geen van %1; noem het bestand naar zijn formaat.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; is not known; known are %2.</source>
        <translation>de lengte-eenheid &quot;%1&quot; is niet bekend; bekend zijn %2.</translation>
    </message>
    <message>
        <source>the surface of &quot;%1&quot; leads to infinity; go back to where it was whole and export again.</source>
        <translation>het oppervlak van &quot;%1&quot; leidt naar het oneindige; ga terug naar waar het heel was en exporteer opnieuw.</translation>
    </message>
    <message>
        <source>there is no surface to write.</source>
        <translation>er is geen oppervlak om te schrijven.</translation>
    </message>
    <message>
        <source>the surface has more than 2147483647 points or triangles, which the formats cannot count; export fewer bodies.</source>
        <translation>het oppervlak heeft meer dan 2147483647 punten of driehoeken, die de formaten niet kunnen tellen; exporteer minder lichamen.</translation>
    </message>
    <message>
        <source>3MF does not know the length unit %1; choose one of um, mm, cm, inch, ft and m.</source>
        <translation>3MF kent de lengte-eenheid %1 niet; kies um, mm, cm, inch, ft of m.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a 3MF can hold; export fewer bodies.</source>
        <translation>het oppervlak heeft meer nodig dan de 4 GB die een 3MF kan bevatten; exporteer minder lichamen.</translation>
    </message>
    <message>
        <source>its border cannot be drawn in its parameters</source>
        <translation>de begrenzing kan niet in de parameters worden getekend</translation>
    </message>
    <message>
        <source>its border does not close in its parameters</source>
        <translation>de begrenzing sluit niet in de parameters</translation>
    </message>
    <message>
        <source>its border is too short to be divided</source>
        <translation>de begrenzing is te kort om te worden gedeeld</translation>
    </message>
    <message>
        <source>a face cannot be drawn: %1</source>
        <translation>een vlak kan niet worden getekend: %1</translation>
    </message>
    <message>
        <source>an edge does not end</source>
        <translation>een rand eindigt niet</translation>
    </message>
    <message>
        <source>two of its edges are too short to be told apart</source>
        <translation>twee randen ervan zijn te kort om te worden onderscheiden</translation>
    </message>
    <message>
        <source>two of its points lie on each other</source>
        <translation>twee punten ervan vallen samen</translation>
    </message>
    <message>
        <source>a triangle in its place has no width</source>
        <translation>een driehoek op die plaats heeft geen breedte</translation>
    </message>
    <message>
        <source>too many triangles would be needed</source>
        <translation>er zouden te veel driehoeken nodig zijn</translation>
    </message>
    <message>
        <source>an edge has no curve on its face</source>
        <translation>een rand heeft geen kromme op het vlak</translation>
    </message>
    <message>
        <source>an edge has a curve on its face that does not match it</source>
        <translation>de kromme van een rand op het vlak past er niet bij</translation>
    </message>
    <message>
        <source>a face has no surface</source>
        <translation>een vlak heeft geen geometrie</translation>
    </message>
    <message>
        <source>a face has no border</source>
        <translation>een vlak heeft geen begrenzing</translation>
    </message>
    <message>
        <source>a face is degenerate</source>
        <translation>een vlak is ontaard</translation>
    </message>
    <message>
        <source>The picture cannot be compressed: %1.</source>
        <translation>De afbeelding kan niet worden gecomprimeerd: %1.</translation>
    </message>
    <message>
        <source>there is no surface to draw.</source>
        <translation>er is geen oppervlak om te tekenen.</translation>
    </message>
    <message>
        <source>the picture must have from 1 to %1 pixels on each side.</source>
        <translation>de afbeelding moet aan elke zijde 1 tot %1 pixels hebben.</translation>
    </message>
    <message>
        <source>the directions of view and of up must not be zero.</source>
        <translation>de kijkrichting en de richting omhoog mogen niet nul zijn.</translation>
    </message>
    <message>
        <source>the export asks for more memory than there is; export fewer parts at a time.</source>
        <translation>de export vraagt meer geheugen dan er is; exporteer minder onderdelen tegelijk.</translation>
    </message>
    <message>
        <source>smooth faces go into .step, .iges and .brep files only.</source>
        <translation>gladde vlakken gaan alleen in .step-, .iges- en .brep-bestanden.</translation>
    </message>
    <message>
        <source>Nothing was written; export fewer parts at a time, or with a larger tolerance.</source>
        <translation>Er is niets geschreven; exporteer minder onderdelen tegelijk, of met een grotere tolerantie.</translation>
    </message>
    <message>
        <source>Nothing was written; export the parts one by one to see which one it is, or as a mesh.</source>
        <translation>Er is niets geschreven; exporteer de onderdelen een voor een om te zien welk het is, of als net.</translation>
    </message>
    <message>
        <source>What to write could not be handed over; try again.</source>
        <translation>Wat geschreven moest worden, kon niet worden overgedragen; probeer het opnieuw.</translation>
    </message>
    <message>
        <source>there is nothing to export.</source>
        <translation>er valt niets te exporteren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at the planes of the deformation; each is one surface across them.</source>
        <translation>&quot;%1&quot;: de vlakken konden niet worden gedeeld bij de grensvlakken van de vervorming; elk is één oppervlak daaroverheen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at one of the planes of the deformation; each is one surface across it.</source>
        <translation>&quot;%1&quot;: de vlakken konden niet worden gedeeld bij een van de grensvlakken van de vervorming; elk is daar één oppervlak overheen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: 1 face was divided at the planes of the deformation.</source>
        <translation>&quot;%1&quot;: 1 vlak is gedeeld bij de grensvlakken van de vervorming.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces were divided at the planes of the deformation.</source>
        <translation>&quot;%1&quot;: %2 vlakken zijn gedeeld bij de grensvlakken van de vervorming.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: it was carried by all deformations in one step, across the planes of single ones.</source>
        <translation>&quot;%1&quot;: alle vervormingen zijn in één stap uitgevoerd, over de grensvlakken van afzonderlijke heen.</translation>
    </message>
    <message>
        <source>not all names of its faces were found again.</source>
        <translation>niet alle namen van zijn vlakken zijn teruggevonden.</translation>
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
        <source>Only &quot;%1&quot;</source>
        <translation>Alleen &quot;%1&quot;</translation>
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
        <translation>Voor oudere programma&apos;s: AP214 in plaats van AP242</translation>
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
        <source>Choose a place...</source>
        <translation>Een plaats kiezen...</translation>
    </message>
</context>
<context>
    <name>ExportFeature</name>
    <message>
        <source>Export report</source>
        <translation>Exportverslag</translation>
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
        <source>The shape that the parts have now is not sound everywhere; the export report says where. Undo goes back to the parts as they were.</source>
        <translation>De vorm die de onderdelen nu hebben is niet overal in orde; het exportverslag zegt waar. Ongedaan maken leidt terug naar de onderdelen zoals ze waren.</translation>
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
        <source>passes through itself</source>
        <translation>gaat door zichzelf heen</translation>
    </message>
    <message>
        <source>not smooth where it was</source>
        <translation>niet glad waar het dat was</translation>
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
    <message>
        <source>smooth faces, %1 flat</source>
        <translation>gladde vlakken, %1 vlak</translation>
    </message>
    <message>
        <source>The part is sound.</source>
        <translation>Het onderdeel is in orde.</translation>
    </message>
    <message>
        <source>The part is not sound.</source>
        <translation>Het onderdeel is niet in orde.</translation>
    </message>
    <message>
        <source>One of %1 parts is not sound.</source>
        <translation>Een van de %1 onderdelen is niet in orde.</translation>
    </message>
    <message>
        <source>Exported parts</source>
        <translation>Geëxporteerde onderdelen</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>at %1</source>
        <translation>bij %1</translation>
    </message>
    <message>
        <source>on face %1, at %2</source>
        <translation>op vlak %1, bij %2</translation>
    </message>
    <message>
        <source>The nodes of the field span %1 mm, the parts %2 mm: the numbers seem to be %3. Choose &quot;%4&quot; as the unit of the field.</source>
        <translation>De knopen van het veld beslaan %1 mm, de delen %2 mm: de getallen lijken %3 te zijn. Kies &quot;%4&quot; als eenheid van het veld.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but lies elsewhere: its middle is at %1, theirs at %2. Move the parts there, or write the field where they are.</source>
        <translation>Het veld heeft de grootte van de delen, maar ligt ergens anders: zijn midden is bij %1, dat van hen bij %2. Verplaats de delen daarheen, of schrijf het veld waar zij zijn.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but is turned: it spans %1 mm, they span %2 mm. Turn the parts, or write the field with the axes that they have.</source>
        <translation>Het veld heeft de grootte van de delen, maar is gedraaid: het beslaat %1 mm, zij beslaan %2 mm. Draai de delen, of schrijf het veld met hun assen.</translation>
    </message>
    <message>
        <source>The field is not of these parts: %1 % of their surface lies far from all of its nodes, at most %2 mm (%3). The field spans %4 mm, the parts %5 mm.</source>
        <translation>Het veld hoort niet bij deze delen: %1 % van hun oppervlak ligt ver van al zijn knopen, hoogstens %2 mm (%3). Het veld beslaat %4 mm, de delen %5 mm.</translation>
    </message>
    <message>
        <source>%1 % of the surface has no nodes of the field near it; there the field is continued. The farthest place lies %2 mm from a node, %3.</source>
        <translation>%1 % van het oppervlak heeft geen knopen van het veld in de buurt; daar wordt het veld voortgezet. De verste plaats ligt %2 mm van een knoop, %3.</translation>
    </message>
    <message>
        <source>The field folds the material %1: its volume there would be %2 times what it was. Take a smaller factor, or keep faces there as they are.</source>
        <translation>Het veld vouwt het materiaal %1: zijn volume zou daar %2 keer zijn wat het was. Neem een kleinere factor, of laat vlakken daar zoals ze zijn.</translation>
    </message>
    <message>
        <source>%1 % of the nodes move otherwise than those beside them, most at %2, by %3 mm: two sides of a slit, or noise. A smooth field passes between them.</source>
        <translation>%1 % van de knopen bewegen anders dan die ernaast, het meest bij %2, met %3 mm: twee kanten van een spleet, of ruis. Een glad veld gaat ertussendoor.</translation>
    </message>
    <message>
        <source>The scan was moved by (%1, %2, %3) mm and turned by %4 degrees, so that it lies on the part.</source>
        <translation>De scan is met (%1, %2, %3) mm verplaatst en %4 graden gedraaid, zodat hij op het deel ligt.</translation>
    </message>
    <message>
        <source>At %1 of %2 points of the part the scan says nothing to go by, as where it has a hole; the field is continued there. The farthest lies %3 mm from the scan, at %4.</source>
        <translation>Op %1 van %2 punten van het deel zegt de scan niets bruikbaars, zoals waar hij een gat heeft; daar wordt het veld voortgezet. Het verste ligt %3 mm van de scan, bij %4.</translation>
    </message>
    <message>
        <source>The scan or the part has no triangles.</source>
        <translation>De scan of het deel heeft geen driehoeken.</translation>
    </message>
    <message>
        <source>The scan has a corner that is no place.</source>
        <translation>De scan heeft een hoek die geen plaats is.</translation>
    </message>
    <message>
        <source>The triangles of the scan have no area.</source>
        <translation>De driehoeken van de scan hebben geen oppervlakte.</translation>
    </message>
    <message>
        <source>The scan does not lie on the part: only %1 % of it does, however it is turned. Look at its unit, or lay it on the part and say that it stays in place.</source>
        <translation>De scan ligt niet op het deel: slechts %1 % ervan, hoe hij ook gedraaid wordt. Kijk naar zijn eenheid, of leg hem op het deel en zeg dat hij daar blijft.</translation>
    </message>
    <message>
        <source>CalculiX results</source>
        <translation>CalculiX-resultaten</translation>
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
        <translation>Tabel</translation>
    </message>
    <message>
        <source>Abaqus report</source>
        <translation>Abaqus-rapport</translation>
    </message>
    <message>
        <source>Abaqus or CalculiX input</source>
        <translation>Invoer van Abaqus of CalculiX</translation>
    </message>
    <message>
        <source>The cracks of &quot;%1&quot; could not be made into surfaces: values at nodes beside them may be those of the other side.</source>
        <translation>Van de scheuren van “%1” konden geen vlakken worden gemaakt: waarden bij knopen ernaast kunnen die van de andere kant zijn.</translation>
    </message>
    <message>
        <source>%1 of %2 nodes lie outside of all bodies and have no values; the farthest is %3 away, at (%4, %5, %6). Check the unit of the mesh, and whether its nodes lie in the parts as they were opened or as they are now.</source>
        <translation>%1 van %2 knopen liggen buiten alle lichamen en hebben geen waarden; de verste is %3 verwijderd, bij (%4, %5, %6). Controleer de eenheid van het net, en of de knopen in de delen liggen zoals ze werden geopend of zoals ze nu zijn.</translation>
    </message>
    <message>
        <source>it has %1 time steps, there is no number %2; choose another one.</source>
        <translation>het heeft %1 tijdstappen, een nummer %2 is er niet; kies een andere.</translation>
    </message>
    <message>
        <source>it has no vectors at nodes; write the displacements of the nodes into it, too.</source>
        <translation>het heeft geen vectoren op knopen; schrijf er ook de verplaatsingen van de knopen in.</translation>
    </message>
    <message>
        <source>it has no vectors called %1 at its nodes; it has %2.</source>
        <translation>het heeft geen vectoren met de naam %1 op zijn knopen; het heeft %2.</translation>
    </message>
    <message>
        <source>several vectors could be the displacements: %1; say which.</source>
        <translation>meerdere vectoren kunnen de verplaatsingen zijn: %1; zeg welke.</translation>
    </message>
    <message>
        <source>%1 has %2 values for %3 nodes; write the file again with the program it comes from.</source>
        <translation>%1 heeft %2 waarden voor %3 knopen; schrijf het bestand opnieuw met het programma waar het vandaan komt.</translation>
    </message>
    <message>
        <source>an element has node %1, which is missing; write the file again.</source>
        <translation>een element heeft knoop %1, die ontbreekt; schrijf het bestand opnieuw.</translation>
    </message>
    <message>
        <source>the file is damaged; write it again with the program it comes from.</source>
        <translation>het bestand is beschadigd; schrijf het opnieuw met het programma waar het vandaan komt.</translation>
    </message>
    <message>
        <source>this is no file of displacements; they are read from %1 files.</source>
        <translation>dit is geen bestand met verplaatsingen; die worden gelezen uit %1-bestanden.</translation>
    </message>
    <message>
        <source>it has no nodes; write the results with the mesh.</source>
        <translation>het heeft geen knopen; schrijf de resultaten met het net.</translation>
    </message>
    <message>
        <source>The file has %1 time steps; the last one was read (%2).</source>
        <translation>Het bestand heeft %1 tijdstappen; de laatste is gelezen (%2).</translation>
    </message>
    <message>
        <source>no node in it has a displacement; write the displacements into it, too.</source>
        <translation>geen knoop erin heeft een verplaatsing; schrijf er ook de verplaatsingen in.</translation>
    </message>
    <message>
        <source>%1 has another number of values than there are nodes; nothing was written.</source>
        <translation>%1 heeft een ander aantal waarden dan er knopen zijn; er is niets geschreven.</translation>
    </message>
    <message>
        <source>fields at nodes are written to .vtu and .csv files.</source>
        <translation>velden op knopen worden naar .vtu- en .csv-bestanden geschreven.</translation>
    </message>
    <message>
        <source>it is a Gmsh file of version %1, which is not read; save it in version 4.1 or 2.2.</source>
        <translation>het is een Gmsh-bestand van versie %1, die niet gelezen wordt; sla het op in versie 4.1 of 2.2.</translation>
    </message>
    <message>
        <source>its bytes are in the order of another kind of computer; save it as text (ASCII).</source>
        <translation>de bytes staan in de volgorde van een ander soort computer; sla het op als tekst (ASCII).</translation>
    </message>
    <message>
        <source>it has elements of Gmsh&apos;s type %1, which is not known; leave them out.</source>
        <translation>het heeft elementen van Gmsh-type %1, dat niet bekend is; laat ze weg.</translation>
    </message>
    <message>
        <source>its nodes stand in other files that it includes; give the file with *NODE.</source>
        <translation>de knopen staan in andere bestanden die het insluit; geef het bestand met *NODE.</translation>
    </message>
    <message>
        <source>it has no nodes; a mesh has them behind *NODE.</source>
        <translation>het heeft geen knopen; een net heeft ze achter *NODE.</translation>
    </message>
    <message>
        <source>%1 elements are of kinds that are not read and were left out.</source>
        <translation>%1 elementen zijn van soorten die niet gelezen worden en zijn weggelaten.</translation>
    </message>
    <message>
        <source>this is an input of Abaqus or CalculiX, without displacements; give the results (.frd).</source>
        <translation>dit is invoer van Abaqus of CalculiX, zonder verplaatsingen; geef de resultaten (.frd).</translation>
    </message>
    <message>
        <source>%1 of %2 nodes have no displacement and were left out.</source>
        <translation>%1 van %2 knopen hebben geen verplaatsing en zijn weggelaten.</translation>
    </message>
    <message>
        <source>%1 nodes lie where another one does; each such place has the mean of their displacements.</source>
        <translation>%1 knopen liggen waar al een andere ligt; elke zulke plek heeft het gemiddelde van hun verplaatsingen.</translation>
    </message>
    <message>
        <source>the collection names no files.</source>
        <translation>de verzameling noemt geen bestanden.</translation>
    </message>
    <message>
        <source>the report has no coordinates; write COORD of the nodes into it beside U.</source>
        <translation>het rapport heeft geen coördinaten; schrijf er COORD van de knopen naast U in.</translation>
    </message>
    <message>
        <source>the report has no table with values of nodes.</source>
        <translation>het rapport heeft geen tabel met waarden van knopen.</translation>
    </message>
    <message>
        <source>%1 lines hold no numbers where they should and were left out.</source>
        <translation>%1 regels hebben geen getallen waar die horen en zijn weggelaten.</translation>
    </message>
    <message>
        <source>there are no lines of numbers in it; a table has a line per node with X, Y, Z, DX, DY, DZ.</source>
        <translation>er staan geen regels met getallen in; een tabel heeft een regel per knoop met X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>it cannot be told what its %1 columns are; name them in the first line: X, Y, Z, DX, DY, DZ.</source>
        <translation>wat de %1 kolommen zijn is niet te zien; noem ze in de eerste regel: X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at line %1; write it again with the program it comes from.</source>
        <translation>het bestand is op regel %1 beschadigd of afgebroken; schrijf het opnieuw met het programma waar het vandaan komt.</translation>
    </message>
    <message>
        <source>it holds texts as bytes, which are not read; save it as text (ASCII).</source>
        <translation>het bevat teksten als bytes, die niet gelezen worden; sla het op als tekst (ASCII).</translation>
    </message>
    <message>
        <source>this VTK file is of the kind %1, which is not read; save it as an unstructured grid (.vtu).</source>
        <translation>dit VTK-bestand is van de soort %1, die niet gelezen wordt; sla het op als ongestructureerd rooster (.vtu).</translation>
    </message>
    <message>
        <source>its numbers are compressed by %1, which is not read; save it with zlib or without compression.</source>
        <translation>de getallen zijn ingepakt met %1, wat niet gelezen wordt; sla het op met zlib of zonder compressie.</translation>
    </message>
    <message>
        <source>the file asks for more memory than there is; write fewer steps and values into it.</source>
        <translation>het bestand vraagt meer geheugen dan er is; schrijf er minder stappen en waarden in.</translation>
    </message>
    <message>
        <source>Nothing was read; the file is damaged or far too large.</source>
        <translation>Er is niets gelezen; het bestand is beschadigd of veel te groot.</translation>
    </message>
    <message>
        <source>Nothing was read; write the file again, best as .vtu.</source>
        <translation>Er is niets gelezen; schrijf het bestand opnieuw, het liefst als .vtu.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was read; try again.</source>
        <translation>het resultaat van de lezer is beschadigd (%1). Er is niets gelezen; probeer het opnieuw.</translation>
    </message>
    <message>
        <source>Values at nodes need a mesh and a file to write: give --nodes and the output.</source>
        <translation>Waarden bij knopen hebben een net nodig en een bestand om te schrijven: geef --nodes en de uitvoer op.</translation>
    </message>
    <message>
        <source>There is no field &quot;%1&quot;; known are %2.</source>
        <translation>Er is geen veld “%1”; bekend zijn %2.</translation>
    </message>
    <message>
        <source>values at nodes are written to .vtu, .csv and .inp files.</source>
        <translation>waarden bij knopen worden naar bestanden .vtu, .csv en .inp geschreven.</translation>
    </message>
    <message>
        <source>no node lies in the bodies.</source>
        <translation>geen knoop ligt in de lichamen.</translation>
    </message>
    <message>
        <source>there is nothing to write: the mesh has no solid elements for stress, and no displaced nodes were asked for.</source>
        <translation>er is niets te schrijven: het net heeft geen volume-elementen voor spanning, en verplaatste knopen zijn niet gevraagd.</translation>
    </message>
    <message>
        <source>The coordinates are those in the report; where Abaqus computed with large displacements they are the moved ones: take those of the first frame then.</source>
        <translation>De coördinaten zijn die van het rapport; heeft Abaqus met grote verplaatsingen gerekend, dan zijn het de verplaatste: neem dan die van het eerste frame.</translation>
    </message>
    <message>
        <source>a node has a coordinate that is no number, or far too large; write the file again.</source>
        <translation>een knoop heeft een coördinaat die geen getal is of veel te groot; schrijf het bestand opnieuw.</translation>
    </message>
    <message>
        <source>the collection names %1, which is no ordinary file in its folder; put the file beside the collection and open that again.</source>
        <translation>de verzameling noemt %1, dat geen gewoon bestand in haar map is; zet het bestand naast de verzameling en open die opnieuw.</translation>
    </message>
</context>
<context>
    <name>FieldPage</name>
    <message>
        <source>Choose faces</source>
        <translation>Vlakken kiezen</translation>
    </message>
    <message>
        <source>Keep none</source>
        <translation>Geen behouden</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pijlen</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Veld</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Eenheid</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Nothing moves along this axis</source>
        <translation>Langs deze as beweegt niets</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vergrendeld</translation>
    </message>
    <message>
        <source>Faces that stay</source>
        <translation>Vlakken die blijven</translation>
    </message>
    <message>
        <source>Fades within</source>
        <translation>Vervaagt over</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>Om te bekijken</translation>
    </message>
    <message>
        <source>Exaggerated</source>
        <translation>Overdreven</translation>
    </message>
    <message>
        <source>Largest way</source>
        <translation>Grootste weg</translation>
    </message>
    <message>
        <source>Click faces in the view that are to stay exactly where they are, then press this again</source>
        <translation>Klik in het beeld op vlakken die precies moeten blijven waar ze zijn, en druk hier dan nogmaals op</translation>
    </message>
    <message>
        <source>Of the displacements; -1 goes the other way, as one compensates</source>
        <translation>Van de verplaatsingen; -1 gaat de andere kant op, zoals men compenseert</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>naar het onderdeel</translation>
    </message>
    <message>
        <source>From the faces that stay to where the whole field holds</source>
        <translation>Van de vlakken die blijven tot waar het hele veld geldt</translation>
    </message>
    <message>
        <source>Only of what is seen before it is applied</source>
        <translation>Alleen van wat men ziet voordat het wordt toegepast</translation>
    </message>
    <message>
        <source>Of lengths in the file</source>
        <translation>Van lengten in het bestand</translation>
    </message>
    <message>
        <source>%1: %2, %3 nodes</source>
        <translation>%1: %2, %3 knopen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Opmerkingen</translation>
    </message>
    <message>
        <source>Lies where the part does</source>
        <translation>Ligt waar het onderdeel ligt</translation>
    </message>
    <message>
        <source>Else the scan is laid over the part as a rigid thing first</source>
        <translation>Anders wordt de scan eerst als star ding op het onderdeel gelegd</translation>
    </message>
</context>
<context>
    <name>File</name>
    <message>
        <source>the file cannot be written (%1); choose another place or make room.</source>
        <translation>het bestand kan niet worden geschreven (%1); kies een andere plaats of maak ruimte.</translation>
    </message>
    <message>
        <source>%1: no such file.</source>
        <translation>%1: zo&apos;n bestand is er niet.</translation>
    </message>
    <message>
        <source>%1: this is a folder; name a file.</source>
        <translation>%1: dit is een map; noem een bestand.</translation>
    </message>
    <message>
        <source>%1: the file cannot be read; check its permissions.</source>
        <translation>%1: het bestand kan niet worden gelezen; controleer de rechten ervan.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files; set TMPDIR to one you may write to.</source>
        <translation>Er is geen map voor tijdelijke bestanden; zet TMPDIR op een map waarin u mag schrijven.</translation>
    </message>
    <message>
        <source>%1: no temporary file can be made there (%2).</source>
        <translation>%1: daar kan geen tijdelijk bestand worden gemaakt (%2).</translation>
    </message>
    <message>
        <source>The folder for temporary files takes no more; make room there, or set TMPDIR to another folder (%1).</source>
        <translation>De map voor tijdelijke bestanden neemt niets meer op; maak daar ruimte of zet TMPDIR op een andere map (%1).</translation>
    </message>
    <message>
        <source>%1: the folder for temporary files takes no more (%2); make room there, or set TMPDIR to another folder.</source>
        <translation>%1: de map voor tijdelijke bestanden neemt niets meer op (%2); maak daar ruimte of zet TMPDIR op een andere map.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Name another one with --csv.</source>
        <translation>Noem een ander met --csv.</translation>
    </message>
    <message>
        <source>Name another one with --probes.</source>
        <translation>Noem een ander met --probes.</translation>
    </message>
    <message>
        <source>No file can be made in memory (%1).</source>
        <translation>In het geheugen kan geen bestand worden gemaakt (%1).</translation>
    </message>
    <message>
        <source>the standard output takes no more; write into a file with --output.</source>
        <translation>de standaarduitvoer neemt niets meer aan; schrijf met --output in een bestand.</translation>
    </message>
</context>
<context>
    <name>Filling</name>
    <message>
        <source>A spacing of %1 needs more than %2 objects. Choose a larger spacing.</source>
        <translation>Een afstand van %1 vraagt meer dan %2 objecten. Kies een grotere afstand.</translation>
    </message>
    <message>
        <source>The part has no triangles, so there is nothing to fill. Import a part with a surface.</source>
        <translation>Het onderdeel heeft geen driehoeken, dus er is niets te vullen. Importeer een onderdeel met een oppervlak.</translation>
    </message>
    <message>
        <source>A vertex of the surface is not at a finite place. Repair the file and import again.</source>
        <translation>Een hoekpunt van het oppervlak ligt niet op een eindige plaats. Herstel het bestand en importeer opnieuw.</translation>
    </message>
    <message>
        <source>The surface is not closed: %1 edges of triangles have no partner. Close the gaps and import again.</source>
        <translation>Het oppervlak is niet gesloten: %1 randen van driehoeken hebben geen partner. Sluit de gaten en importeer opnieuw.</translation>
    </message>
    <message>
        <source>A spacing of %1 cannot be used. Enter a length above 0.</source>
        <translation>Een afstand van %1 is niet bruikbaar. Voer een lengte boven 0 in.</translation>
    </message>
    <message>
        <source>The surface does not bound a volume: its holes are too large to tell inside from outside. Close them and import again.</source>
        <translation>Het oppervlak begrenst geen volume: de gaten zijn te groot om binnen van buiten te onderscheiden. Sluit ze en importeer opnieuw.</translation>
    </message>
    <message>
        <source>The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing.</source>
        <translation>Het onderdeel is te dun voor een afstand van %1: geen cel bevat genoeg materiaal. Kies een kleinere afstand.</translation>
    </message>
    <message>
        <source>The surface is not closed. Close it and try again.</source>
        <translation>Het oppervlak is niet gesloten. Sluit het en probeer het opnieuw.</translation>
    </message>
    <message>
        <source>The spacing must be greater than 0.</source>
        <translation>De afstand moet groter dan 0 zijn.</translation>
    </message>
    <message>
        <source>The spacing is too small for a part of this size. Choose a larger one.</source>
        <translation>De afstand is te klein voor een onderdeel van deze grootte. Kies een grotere.</translation>
    </message>
    <message>
        <source>No sphere has its center inside the part. Choose a smaller spacing.</source>
        <translation>Geen bol heeft zijn middelpunt in het onderdeel. Kies een kleinere afstand.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out many times too stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.</source>
        <translation>Dunste wanden: %1 cellen over %2; zulke wanden buigen vele malen te stijf. Vul met een afstand van %3 voor %4 cellen, ongeveer %5 objecten.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. Fill with a spacing of %4 for %5 cells, about %6 objects.</source>
        <translation>Dunste wanden: %1 cellen over %2; zulke wanden buigen tot %3 % te stijf. Vul met een afstand van %4 voor %5 cellen, ongeveer %6 objecten.</translation>
    </message>
    <message>
        <source>A point of the surface is nowhere.</source>
        <translation>Een punt van het oppervlak ligt nergens.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface, so it is not shown.</source>
        <translation>&quot;%1&quot; heeft geen oppervlak en wordt dus niet getoond.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a closed solid: it is shown, and not simulated. Close its surfaces and import it again.</source>
        <translation>&quot;%1&quot; is geen gesloten lichaam: het wordt getoond, en niet gesimuleerd. Sluit de oppervlakken en importeer het opnieuw.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>&quot;%1&quot; wordt niet gesimuleerd: %2</translation>
    </message>
    <message>
        <source>%1: the file holds no solid and no surface; export the part as a solid.</source>
        <translation>%1: het bestand bevat geen lichaam en geen oppervlak; exporteer het onderdeel als lichaam.</translation>
    </message>
    <message>
        <source>%1: no closed body found. Close the surfaces in the CAD program and export again.</source>
        <translation>%1: geen gesloten lichaam gevonden. Sluit de oppervlakken in het CAD-programma en exporteer opnieuw.</translation>
    </message>
    <message>
        <source>The spacing of another filling must be more than 0.</source>
        <translation>De afstand van een andere vulling moet groter dan 0 zijn.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface that it could be filled from.</source>
        <translation>&quot;%1&quot; heeft geen oppervlak waaruit het gevuld kan worden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is arranged as published, which filling anew does not know.</source>
        <translation>&quot;%1&quot; is gerangschikt zoals gepubliceerd, wat opnieuw vullen niet kent.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deformable, and keeps its shape.</source>
        <translation>&quot;%1&quot; is niet vervormbaar en houdt zijn vorm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is elastic: it keeps its shape at rest, and is not filled anew. Let it yield, or re-normalize it.</source>
        <translation>&quot;%1&quot; is elastisch: het houdt zijn rustvorm en wordt niet opnieuw gevuld. Laat het vloeien, of hernormaliseer het.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks, which another filling would blur: only what heals is filled anew with them.</source>
        <translation>&quot;%1&quot; heeft scheuren, die een andere vulling zou vervagen: alleen wat heelt wordt ermee opnieuw gevuld.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; came apart after its skin was drawn out far: pieces of such a body are not filled anew.</source>
        <translation>&quot;%1&quot; viel uiteen nadat de huid ver was uitgetrokken: stukken van zo&apos;n lichaam worden niet opnieuw gevuld.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks that gape, which another filling would close.</source>
        <translation>&quot;%1&quot; heeft gapende scheuren, die een andere vulling zou sluiten.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a load on a box, which says nothing of its present shape. Put it on faces.</source>
        <translation>&quot;%1&quot; heeft een belasting op een blok, dat niets zegt over de huidige vorm. Zet ze op vlakken.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moves out of all bounds.</source>
        <translation>&quot;%1&quot; beweegt buiten alle grenzen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is still being pushed out of a tool that was put into it.</source>
        <translation>&quot;%1&quot; wordt nog uit een gereedschap geduwd dat erin is gezet.</translation>
    </message>
    <message>
        <source>its cracks gape, and would be filled.</source>
        <translation>de scheuren gapen en zouden gevuld worden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be filled anew: %2</source>
        <translation>&quot;%1&quot; kon niet opnieuw gevuld worden: %2</translation>
    </message>
    <message>
        <source>cracks touch the surface without crossing it</source>
        <translation>scheuren raken het oppervlak zonder het te kruisen</translation>
    </message>
    <message>
        <source>what of it has grown together could not be followed back to what was opened.</source>
        <translation>wat ervan is samengegroeid kon niet worden teruggevolgd naar wat geopend werd.</translation>
    </message>
    <message>
        <source>its cracks could not be made surfaces.</source>
        <translation>de scheuren konden geen oppervlakken worden.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>Er is geen ruimte meer in %1. Maak ruimte, of neem minder of kleinere beelden op.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 bestaat al. Kies een andere naam voor de map met beelden.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>In %1 kan geen map gemaakt worden: %2. Kies een andere plaats.</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2). Choose another name for the folder of pictures.</source>
        <translation>%1 kan niet worden gemaakt (%2). Kies een andere naam voor de map met beelden.</translation>
    </message>
</context>
<context>
    <name>Fixture</name>
    <message>
        <source>Fixture &quot;%1&quot; names a body that does not exist.</source>
        <translation>De inklemming &quot;%1&quot; noemt een lichaam dat niet bestaat.</translation>
    </message>
    <message>
        <source>There is no fixture number %1.</source>
        <translation>Er is geen inklemming nummer %1.</translation>
    </message>
    <message>
        <source>A fixture must not move faster than 100 m/s.</source>
        <translation>Een inklemming mag niet sneller dan 100 m/s bewegen.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must turn about a place, by more than 0, and no faster than 10000 rad/s.</source>
        <translation>De inklemming &quot;%1&quot; moet om een plaats draaien, over meer dan 0, en niet sneller dan 10000 rad/s.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must not move faster than 100 m/s.</source>
        <translation>De inklemming &quot;%1&quot; mag niet sneller dan 100 m/s bewegen.</translation>
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
        <source>With &quot;Fix faces&quot; on, a click on a face adds it to this fixture, or frees it.</source>
        <translation>Met „Vlakken vastzetten” voegt een klik op een vlak het toe aan deze inklemming, of geeft het vrij.</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Inklemming verwijderen</translation>
    </message>
</context>
<context>
    <name>FoldWatch</name>
    <message>
        <source>%1 is folded over itself near (%2): material was pushed over material, and its faces cross there in files, too. Undo the stroke, or press the place smooth with a larger tool.</source>
        <translation>%1 is bij (%2) over zichzelf gevouwen: materiaal is over materiaal geschoven, en ook in bestanden kruisen zijn vlakken elkaar daar. Maak de streek ongedaan, of druk de plek glad met een groter gereedschap.</translation>
    </message>
</context>
<context>
    <name>ForcePanel</name>
    <message>
        <source>Magnitude</source>
        <translation>Grootte</translation>
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
        <translation>Wat van de kracht uitgezet wordt</translation>
    </message>
    <message>
        <source>Add a tool and press Space: forces over time appear here.</source>
        <translation>Voeg gereedschap toe en druk op Spatie: krachten over de tijd verschijnen hier.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kracht</translation>
    </message>
</context>
<context>
    <name>Graphics</name>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>The window needs OpenGL 3.2 or later to draw, and here is %1. Install or update the driver of the graphics card, or Mesa (libgl1-mesa-dri), which draws without such a card. The commands that knead --help lists need no window.</source>
        <translation>Het venster heeft OpenGL 3.2 of nieuwer nodig om te tekenen, en hier is %1. Installeer of vernieuw het stuurprogramma van de grafische kaart, of Mesa (libgl1-mesa-dri), dat zonder zo&apos;n kaart tekent. De opdrachten die knead --help noemt hebben geen venster nodig.</translation>
    </message>
</context>
<context>
    <name>HandPanel</name>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Langs de eigen assen van het gereedschap</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Grepen</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Verplaatsstap</translation>
    </message>
    <message>
        <source>Handles move in steps of this length while Ctrl is held</source>
        <translation>Grepen verplaatsen in stappen van deze lengte zolang Ctrl ingedrukt is</translation>
    </message>
    <message>
        <source>Turn step</source>
        <translation>Draaistap</translation>
    </message>
    <message>
        <source>Handles turn in steps of this angle while Ctrl is held</source>
        <translation>Grepen draaien in stappen van deze hoek zolang Ctrl ingedrukt is</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Toetsenbord</translation>
    </message>
    <message>
        <source>Key step</source>
        <translation>Toetsstap</translation>
    </message>
    <message>
        <source>A key press moves a tool by this length</source>
        <translation>Een toetsdruk verplaatst gereedschap over deze lengte</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Stappen per seconde</translation>
    </message>
    <message>
        <source>While a key is held; a tool never goes faster than its speed limit</source>
        <translation>Zolang een toets ingedrukt is; gereedschap gaat nooit sneller dan zijn snelheidsgrens</translation>
    </message>
    <message>
        <source>Pulling</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Spring stiffness</source>
        <translation>Veerstijfheid</translation>
    </message>
    <message>
        <source>Of the spring between the mouse and the material</source>
        <translation>Van de veer tussen de muis en het materiaal</translation>
    </message>
    <message>
        <source>Largest pull</source>
        <translation>Grootste trekkracht</translation>
    </message>
    <message>
        <source>The hand does not pull harder than this</source>
        <translation>De hand trekt niet harder dan dit</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D-muis</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Camera</translation>
    </message>
    <message>
        <source>Selected tool</source>
        <translation>Gekozen gereedschap</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Bestuurt</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Of its speeds; 1 is usual</source>
        <translation>Factor op zijn snelheden; 1 is gebruikelijk</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>naar het materiaal</translation>
    </message>
    <message>
        <source>Connected. First button: fit; second: camera or tool.</source>
        <translation>Aangesloten. Eerste knop: passend; tweede: camera of gereedschap.</translation>
    </message>
    <message>
        <source>None: it works as soon as spacenavd runs.</source>
        <translation>Geen: werkt zodra spacenavd draait.</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Drukken</translation>
    </message>
    <message>
        <source>Hold the rest</source>
        <translation>De rest vasthouden</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Penselen</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Straal</translation>
    </message>
    <message>
        <source>Of what a brush takes or presses; also with [ and ]</source>
        <translation>Van wat een penseel pakt of indrukt; ook met [ en ]</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>Of the force that suits the material; also with Shift and the mouse wheel</source>
        <translation>Factor op de kracht die bij het materiaal past; ook met Shift en het muiswiel</translation>
    </message>
    <message>
        <source>What is far from the brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Wat ver van het penseel ligt, wordt als met de andere hand vastgehouden, waar niets anders het onderdeel vasthoudt</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>naar het onderdeel</translation>
    </message>
</context>
<context>
    <name>HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation>Handboek</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Geen pagina heeft deze woorden.</translation>
    </message>
</context>
<context>
    <name>Hands</name>
    <message>
        <source>Handles</source>
        <translation>Grepen</translation>
    </message>
    <message>
        <source>Show handles on the selected tool to move and turn it; Ctrl: in steps; type numbers</source>
        <translation>Grepen op het gekozen gereedschap tonen om het te verplaatsen en te draaien; Ctrl: in stappen; typ getallen</translation>
    </message>
    <message>
        <source>Drive by keys</source>
        <translation>Rijden met toetsen</translation>
    </message>
    <message>
        <source>Drive up to three tools with the keyboard, each with keys of its own</source>
        <translation>Tot drie stuks gereedschap met het toetsenbord rijden, elk met eigen toetsen</translation>
    </message>
    <message>
        <source>Pull material</source>
        <translation>Aan materiaal trekken</translation>
    </message>
    <message>
        <source>Press on the part and pull its material with a spring</source>
        <translation>Op het onderdeel drukken en met een veer aan zijn materiaal trekken</translation>
    </message>
    <message>
        <source>3D mouse drives tool</source>
        <translation>3D-muis bestuurt gereedschap</translation>
    </message>
    <message>
        <source>The 3D mouse moves the selected tool, not the camera</source>
        <translation>De 3D-muis beweegt het gekozen gereedschap, niet de camera</translation>
    </message>
    <message>
        <source>Forces on tools</source>
        <translation>Krachten op gereedschap</translation>
    </message>
    <message>
        <source>Show the force of the material on each tool as an arrow with its number</source>
        <translation>De kracht van het materiaal op elk gereedschap tonen als pijl met getal</translation>
    </message>
    <message>
        <source>Plot of forces</source>
        <translation>Krachtgrafiek</translation>
    </message>
    <message>
        <source>Show forces over time</source>
        <translation>Krachten over de tijd tonen</translation>
    </message>
    <message>
        <source>Forces as table...</source>
        <translation>Krachten als tabel...</translation>
    </message>
    <message>
        <source>Write the forces over time as a CSV file</source>
        <translation>De krachten over de tijd als CSV-bestand schrijven</translation>
    </message>
    <message>
        <source>Keys drive tools   Shift: slower   Esc: done</source>
        <translation>Toetsen besturen gereedschap   Shift: langzamer   Esc: klaar</translation>
    </message>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Langs de eigen assen van het gereedschap</translation>
    </message>
    <message>
        <source>Handles lie along the axes of the tool, not of the world</source>
        <translation>Grepen liggen langs de assen van het gereedschap, niet van de wereld</translation>
    </message>
    <message>
        <source>Press material</source>
        <translation>Materiaal indrukken</translation>
    </message>
    <message>
        <source>Press on the part: the selected tool, or a thumb, comes straight onto it and goes in until its force limit holds it</source>
        <translation>Op het onderdeel drukken: het gekozen gereedschap, anders een duim, komt er recht op en gaat erin tot zijn krachtgrens het tegenhoudt</translation>
    </message>
    <message>
        <source>Press and hold: the tool goes in until its force limit holds it   Esc: done</source>
        <translation>Drukken en vasthouden: het gereedschap gaat erin tot zijn krachtgrens het tegenhoudt   Esc: klaar</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Duim</translation>
    </message>
    <message>
        <source>Press and hold: a ball goes in until its force limit holds it; draw it along for a groove</source>
        <translation>Drukken en vasthouden: een kogel gaat erin tot zijn krachtgrens hem tegenhoudt; trek hem verder voor een groef</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladmaken</translation>
    </message>
    <message>
        <source>Roll a large ball over the surface, which levels what stands out</source>
        <translation>Een grote kogel over het oppervlak rollen, die wat uitsteekt vlak maakt</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Afvlakken</translation>
    </message>
    <message>
        <source>Press a disc down to the plane that the surface has where you begin</source>
        <translation>Een schijf aandrukken tot op het vlak dat het oppervlak bij het beginpunt heeft</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Samenknijpen</translation>
    </message>
    <message>
        <source>Draw material together with four fingers, as for a ridge</source>
        <translation>Materiaal met vier vingers bijeentrekken, als voor een ribbel</translation>
    </message>
    <message>
        <source>Smear</source>
        <translation>Uitsmeren</translation>
    </message>
    <message>
        <source>Take the surface along with a ball that grips it</source>
        <translation>Het oppervlak meenemen met een kogel die erop grip heeft</translation>
    </message>
    <message>
        <source>Bend here</source>
        <translation>Hier buigen</translation>
    </message>
    <message>
        <source>Tilt the material at the cursor towards where you draw</source>
        <translation>Het materiaal bij de muisaanwijzer kantelen naar waar getrokken wordt</translation>
    </message>
    <message>
        <source>Twist here</source>
        <translation>Hier verdraaien</translation>
    </message>
    <message>
        <source>Turn the material at the cursor about its normal: draw to the right or left</source>
        <translation>Het materiaal bij de muisaanwijzer om zijn normaal draaien: naar rechts of links trekken</translation>
    </message>
    <message>
        <source>Symmetric in X</source>
        <translation>Symmetrisch in X</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along X</source>
        <translation>Penselen doen hetzelfde aan de andere kant van het midden, langs X</translation>
    </message>
    <message>
        <source>Symmetric in Y</source>
        <translation>Symmetrisch in Y</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Y</source>
        <translation>Penselen doen hetzelfde aan de andere kant van het midden, langs Y</translation>
    </message>
    <message>
        <source>Symmetric in Z</source>
        <translation>Symmetrisch in Z</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Z</source>
        <translation>Penselen doen hetzelfde aan de andere kant van het midden, langs Z</translation>
    </message>
    <message>
        <source>Weaker brush</source>
        <translation>Zwakker penseel</translation>
    </message>
    <message>
        <source>Also with Shift and the mouse wheel</source>
        <translation>Ook met Shift en het muiswiel</translation>
    </message>
    <message>
        <source>Stronger brush</source>
        <translation>Sterker penseel</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Boetseren</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Boetseren</translation>
    </message>
    <message>
        <source>Press on the part and draw   [ ]: radius   Shift+wheel: force   Esc: done</source>
        <translation>Op het onderdeel drukken en trekken   [ ]: straal   Shift+wiel: kracht   Esc: klaar</translation>
    </message>
    <message>
        <source>Hold the rest</source>
        <translation>De rest vasthouden</translation>
    </message>
    <message>
        <source>What is far from a brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Wat ver van het penseel ligt, wordt als met de andere hand vastgehouden, waar niets anders het onderdeel vasthoudt</translation>
    </message>
    <message>
        <source>Forces of brushes, too</source>
        <translation>Ook krachten van penselen</translation>
    </message>
    <message>
        <source>Fingers and grips of brushes have lines in the plot and columns in the table, too</source>
        <translation>Ook vingers en grepen van penselen hebben lijnen in de grafiek en kolommen in de tabel</translation>
    </message>
</context>
<context>
    <name>HandsFeature</name>
    <message>
        <source>Hands</source>
        <translation>Handbediening</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Krachten</translation>
    </message>
    <message>
        <source>Export forces over time</source>
        <translation>Krachten over de tijd exporteren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabel (*.csv)</translation>
    </message>
    <message>
        <source>There are no forces to write yet: press Play and let something happen first.</source>
        <translation>Er zijn nog geen krachten te schrijven: druk op Afspelen en laat eerst iets gebeuren.</translation>
    </message>
    <message>
        <source>Select a tool or a fixture first.</source>
        <translation>Kies eerst gereedschap of een inklemming.</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Gereedschap toevoegen</translation>
    </message>
    <message>
        <source>Put a tool above the part to push it with</source>
        <translation>Gereedschap boven het onderdeel zetten om ermee te duwen</translation>
    </message>
</context>
<context>
    <name>HelpFeature</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Muis en toetsen</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isometric, top, front, right; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;clicks select parts, faces, edges, objects; Ctrl adds&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;one, two, four views; V: the active view alone&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linkerknop&lt;/b&gt;&lt;/td&gt;&lt;td&gt;kiezen; gereedschap slepen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;draaien&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;schuiven&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wiel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;naar de aanwijzer zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pijlen, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het gekozen gereedschap rijden; Shift is langzamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Spatie, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;afspelen of pauzeren, één stap, terugzetten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;blok toevoegen, vlakken vastzetten, verwijderen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zwaartekracht, hernormaliseren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objecten, lichaam verbergen, randen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isometrisch, boven, voor, rechts; Ctrl: van de andere kant&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;klikken kiest onderdelen, vlakken, randen, objecten; Ctrl voegt toe&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspectief of parallel, passend&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het project opslaan; Ctrl+Shift+S onder een andere naam&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;één, twee, vier aanzichten; V: alleen het actieve&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;elke opdracht vinden; F11: volledig scherm&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;annuleren&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
</context>
<context>
    <name>History</name>
    <message>
        <source>a number of an object is none</source>
        <translation>een getal van een object is er geen</translation>
    </message>
    <message>
        <source>a filling has no lattice</source>
        <translation>een vulling heeft geen rooster</translation>
    </message>
    <message>
        <source>a connection of a filling leads nowhere</source>
        <translation>een verbinding van een vulling leidt nergens heen</translation>
    </message>
    <message>
        <source>a filling is not as it can be</source>
        <translation>een vulling is zoals ze niet kan zijn</translation>
    </message>
    <message>
        <source>a former shape has too many before it</source>
        <translation>een eerdere vorm heeft er te veel vóór zich</translation>
    </message>
    <message>
        <source>a former shape has no carriers</source>
        <translation>een eerdere vorm heeft geen dragers</translation>
    </message>
    <message>
        <source>a former shape is none</source>
        <translation>een eerdere vorm is er geen</translation>
    </message>
    <message>
        <source>a former shape was parted where it could not be</source>
        <translation>een eerdere vorm is gescheiden waar dat niet kan</translation>
    </message>
    <message>
        <source>it ends early</source>
        <translation>de gegevens eindigen te vroeg</translation>
    </message>
    <message>
        <source>a yes or no is neither</source>
        <translation>een ja of nee is geen van beide</translation>
    </message>
    <message>
        <source>a choice is none of those there are</source>
        <translation>een keuze is geen van de bestaande</translation>
    </message>
    <message>
        <source>The history has no entries.</source>
        <translation>De geschiedenis heeft geen invoeren.</translation>
    </message>
    <message>
        <source>The history is damaged: its entry %1 follows one that comes later.</source>
        <translation>De geschiedenis is beschadigd: invoer %1 volgt op een die later komt.</translation>
    </message>
    <message>
        <source>The history is damaged: it is at an entry that it does not have.</source>
        <translation>De geschiedenis is beschadigd: ze staat bij een invoer die ze niet heeft.</translation>
    </message>
    <message>
        <source>Repeating what was done came to another state than it did then, as it does with another version of Knead. Go to an entry that is kept.</source>
        <translation>Herhalen wat gedaan is leidde tot een andere toestand dan toen, zoals met een andere versie van Knead gebeurt. Ga naar een invoer die bewaard is.</translation>
    </message>
    <message>
        <source>The project has no history: nothing was done in it yet that could be repeated.</source>
        <translation>Het project heeft geen geschiedenis: er is nog niets in gedaan dat herhaald kan worden.</translation>
    </message>
    <message>
        <source>The history is damaged: an entry begins with a start that is not there.</source>
        <translation>De geschiedenis is beschadigd: een invoer begint met een begin dat er niet is.</translation>
    </message>
    <message>
        <source>The entry before it was not reached.</source>
        <translation>De invoer ervoor werd niet bereikt.</translation>
    </message>
    <message>
        <source>it does not begin as one</source>
        <translation>het begint niet als een moment</translation>
    </message>
    <message>
        <source>it was written by another version of Knead</source>
        <translation>een andere versie van Knead heeft het geschreven</translation>
    </message>
    <message>
        <source>its bytes are not those that were written</source>
        <translation>de bytes zijn niet die welke geschreven zijn</translation>
    </message>
    <message>
        <source>This moment of the history cannot be read: %1. Go to an earlier one and repeat from there.</source>
        <translation>Dit moment van de geschiedenis kan niet gelezen worden: %1. Ga naar een eerder en herhaal vandaar.</translation>
    </message>
    <message>
        <source>it has another number of bodies than the scene</source>
        <translation>het heeft een ander aantal lichamen dan de scène</translation>
    </message>
    <message>
        <source>a tool cannot be simulated</source>
        <translation>een gereedschap kan niet gesimuleerd worden</translation>
    </message>
    <message>
        <source>a fixture cannot be simulated</source>
        <translation>een inklemming kan niet gesimuleerd worden</translation>
    </message>
    <message>
        <source>a load cannot be simulated</source>
        <translation>een belasting kan niet gesimuleerd worden</translation>
    </message>
    <message>
        <source>a re-normalization under way is out of range</source>
        <translation>een lopende hernormalisering valt buiten de grenzen</translation>
    </message>
    <message>
        <source>a contact or joint is out of range</source>
        <translation>een contact of verlijming valt buiten de grenzen</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>een getal valt buiten de grenzen</translation>
    </message>
    <message>
        <source>a material is out of range</source>
        <translation>een materiaal valt buiten de grenzen</translation>
    </message>
    <message>
        <source>objects are not where they can be</source>
        <translation>objecten zijn waar ze niet kunnen zijn</translation>
    </message>
    <message>
        <source>a mass is out of range</source>
        <translation>een massa valt buiten de grenzen</translation>
    </message>
    <message>
        <source>connections are not as they can be</source>
        <translation>verbindingen zijn zoals ze niet kunnen zijn</translation>
    </message>
    <message>
        <source>it goes on after its end</source>
        <translation>de gegevens gaan na hun einde door</translation>
    </message>
    <message>
        <source>a tool is made of a part that the document does not have</source>
        <translation>een gereedschap is gemaakt van een onderdeel dat het document niet heeft</translation>
    </message>
    <message>
        <source>a motion is none of those there are</source>
        <translation>een beweging is geen van de bestaande</translation>
    </message>
    <message>
        <source>The recording does not belong to this scene: it goes on at step %1, and the run is at step %2. Start from the scene it was made with.</source>
        <translation>De opname hoort niet bij deze scène: ze gaat verder bij stap %1, en de simulatie is bij stap %2. Begin met de scène waarmee ze gemaakt is.</translation>
    </message>
    <message>
        <source>The moment belongs to other bodies than these. Nothing was changed.</source>
        <translation>Het moment hoort bij andere lichamen dan deze. Er is niets veranderd.</translation>
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
    <message>
        <source>Memory of the history</source>
        <translation>Geheugen van de geschiedenis</translation>
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
    <message>
        <source>Try it</source>
        <translation>Probeer het</translation>
    </message>
    <message>
        <source>Try it: press a thumb into clay</source>
        <translation>Probeer het: druk een duim in klei</translation>
    </message>
    <message>
        <source>A block of clay opens. Hold the left button on it; then pull it, and export it. Two minutes.</source>
        <translation>Er opent een blok klei. Houd de linkerknop erop ingedrukt; trek er dan aan en exporteer het. Twee minuten.</translation>
    </message>
</context>
<context>
    <name>Iges</name>
    <message>
        <source>line %1 of the IGES file is not in 80 columns; the file is damaged, get it again.</source>
        <translation>regel %1 van het IGES-bestand staat niet in 80 kolommen; het bestand is beschadigd, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the IGES file ends before its last line (T); it is cut off, get it again.</source>
        <translation>het IGES-bestand eindigt vóór zijn laatste regel (T); het is afgekapt, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the IGES file lacks lines of its section %1; it is damaged, get it again.</source>
        <translation>in het IGES-bestand ontbreken regels van sectie %1; het is beschadigd, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>a text in the IGES file claims to be %1 letters long, more than there are; the file is damaged.</source>
        <translation>een tekst in het IGES-bestand zou %1 letters lang zijn, meer dan er zijn; het bestand is beschadigd.</translation>
    </message>
    <message>
        <source>the IGES file has &quot;%1&quot; in place of a number; it is damaged, export it again.</source>
        <translation>in het IGES-bestand staat &quot;%1&quot; in plaats van een getal; het is beschadigd, exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>an entity of type %1 in the IGES file claims %2 values and has %3; the file is damaged.</source>
        <translation>een element van type %1 in het IGES-bestand noemt %2 waarden en heeft er %3; het bestand is beschadigd.</translation>
    </message>
    <message>
        <source>line %1 of section D of the IGES file has another number; lines are lost, get the file again.</source>
        <translation>regel %1 van sectie D van het IGES-bestand heeft een ander nummer; er zijn regels verloren, haal het bestand opnieuw op.</translation>
    </message>
    <message>
        <source>has its values twice</source>
        <translation>heeft zijn waarden twee keer</translation>
    </message>
    <message>
        <source>is of another type where its values are</source>
        <translation>is van een ander type waar zijn waarden staan</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file holds itself, or the entities are nested more than %2 deep; export it again.</source>
        <translation>element %1 van het IGES-bestand bevat zichzelf, of de elementen zijn meer dan %2 diep genest; exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>refers to one without values</source>
        <translation>verwijst naar een element zonder waarden</translation>
    </message>
    <message>
        <source>refers to a vertex or edge that is not there</source>
        <translation>verwijst naar een hoekpunt of rand die er niet is</translation>
    </message>
    <message>
        <source>has %1 values where %2 are needed</source>
        <translation>heeft %1 waarden waar er %2 nodig zijn</translation>
    </message>
    <message>
        <source>states an impossible count</source>
        <translation>noemt een onmogelijk aantal</translation>
    </message>
    <message>
        <source>refers to something of the wrong kind or nothing at all</source>
        <translation>verwijst naar iets verkeerds of naar niets</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file (type %2) %3; the file is damaged, export it again.</source>
        <translation>element %1 van het IGES-bestand (type %2) %3; het bestand is beschadigd, exporteer het opnieuw.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>the file asks for more memory than there is; it is damaged or far too detailed.</source>
        <translation>het bestand vraagt meer geheugen dan er is; het is beschadigd of veel te gedetailleerd.</translation>
    </message>
    <message>
        <source>the CAD reader gave up (%1); the file is damaged, export it again.</source>
        <translation>de CAD-lezer gaf het op (%1); het bestand is beschadigd, exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>the assembly is nested more than %1 levels deep; export a part of it.</source>
        <translation>de samenstelling is meer dan %1 niveaus diep genest; exporteer een deel ervan.</translation>
    </message>
    <message>
        <source>the assembly has more than %1 parts; export the parts you need.</source>
        <translation>de samenstelling heeft meer dan %1 onderdelen; exporteer de onderdelen die u nodig hebt.</translation>
    </message>
    <message>
        <source>%1: the file mixes the length units %2 and %3; check the sizes of the parts.</source>
        <translation>%1: het bestand mengt de lengte-eenheden %2 en %3; controleer de maten van de onderdelen.</translation>
    </message>
    <message>
        <source>%1: its schema &quot;%2&quot; is none for CAD parts; check that nothing is missing.</source>
        <translation>%1: zijn schema &quot;%2&quot; is er geen voor CAD-onderdelen; controleer of er niets ontbreekt.</translation>
    </message>
    <message>
        <source>the STEP text has errors that the reader cannot get over; export the file again.</source>
        <translation>de STEP-tekst heeft fouten waar de lezer niet overheen komt; exporteer het bestand opnieuw.</translation>
    </message>
    <message>
        <source>an assembly in the file holds itself; export the file again, or its parts one by one.</source>
        <translation>een samenstelling in het bestand bevat zichzelf; exporteer het bestand opnieuw, of de onderdelen een voor een.</translation>
    </message>
    <message>
        <source>the assembly unfolds to more than %1 parts; export the parts you need.</source>
        <translation>de samenstelling ontvouwt zich tot meer dan %1 onderdelen; exporteer de onderdelen die u nodig hebt.</translation>
    </message>
    <message>
        <source>no shape of the STEP file could be made; export the file again.</source>
        <translation>van het STEP-bestand kon geen vorm worden gemaakt; exporteer het bestand opnieuw.</translation>
    </message>
    <message>
        <source>the IGES text has errors that the reader cannot get over; export the file again, best as STEP.</source>
        <translation>de IGES-tekst heeft fouten waar de lezer niet overheen komt; exporteer het bestand opnieuw, het liefst als STEP.</translation>
    </message>
    <message>
        <source>no shape of the IGES file could be made; export the file again, best as STEP.</source>
        <translation>van het IGES-bestand kon geen vorm worden gemaakt; exporteer het bestand opnieuw, het liefst als STEP.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged; get it again.</source>
        <translation>het BREP-bestand is afgekapt of beschadigd; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the BREP file is damaged, or newer than the reader; save it again in an older version.</source>
        <translation>het BREP-bestand is beschadigd, of nieuwer dan de lezer; sla het opnieuw op in een oudere versie.</translation>
    </message>
    <message>
        <source>The solid was inside out and has been turned.</source>
        <translation>Het lichaam was binnenstebuiten en is gekeerd.</translation>
    </message>
    <message>
        <source>was inside out and has been turned.</source>
        <translation>was binnenstebuiten en is gekeerd.</translation>
    </message>
    <message>
        <source>has faces that do not meet well: its volume is uncertain by %1.</source>
        <translation>heeft vlakken die niet goed aansluiten: zijn volume is %1 onzeker.</translation>
    </message>
    <message>
        <source>is an open surface: %1. It is shown and cannot be filled.</source>
        <translation>is een open oppervlak: %1. Het wordt getoond en kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>is not closed: %1. It is shown and cannot be filled.</source>
        <translation>is niet gesloten: %1. Het wordt getoond en kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>is a closed surface but no solid; it is shown and cannot be filled.</source>
        <translation>is een gesloten oppervlak maar geen lichaam; het wordt getoond en kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>could not be covered with a closed net of triangles; it cannot be filled.</source>
        <translation>kon niet met een gesloten net van driehoeken worden bedekt; het kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>does not pass the geometry checks; look at it closely before you trust it.</source>
        <translation>doorstaat de controles van de geometrie niet; bekijk het goed voordat u erop vertrouwt.</translation>
    </message>
    <message>
        <source>has gaps of up to %1, a hundredth of its size or more.</source>
        <translation>heeft spleten tot %1, een honderdste van zijn grootte of meer.</translation>
    </message>
    <message>
        <source>has 1 face that no triangles could be found for; it is not shown there.</source>
        <translation>heeft 1 vlak waarvoor geen driehoeken zijn gevonden; daar wordt niets getoond.</translation>
    </message>
    <message>
        <source>has %1 faces that no triangles could be found for; it is not shown there.</source>
        <translation>heeft %1 vlakken waarvoor geen driehoeken zijn gevonden; daar wordt niets getoond.</translation>
    </message>
    <message>
        <source>there is no part or assembly &quot;%1&quot; in it; knead info --json lists the paths of all parts.</source>
        <translation>er is geen onderdeel of samenstelling &quot;%1&quot; in; knead info --json noemt de paden van alle onderdelen.</translation>
    </message>
    <message>
        <source>it has no finite size: numbers in it are damaged, or its edges are smaller than 0.1 um and lost; check the length unit</source>
        <translation>het heeft geen eindige grootte: getallen erin zijn beschadigd, of de randen zijn kleiner dan 0.1 um en verloren; controleer de lengte-eenheid</translation>
    </message>
    <message>
        <source>it reaches farther than 100 km from the origin; check the length unit and the position</source>
        <translation>het reikt verder dan 100 km van de oorsprong; controleer de lengte-eenheid en de plaats</translation>
    </message>
    <message>
        <source>its faces lead far away from their edges: numbers in it are damaged</source>
        <translation>de vlakken lopen ver van hun randen weg: getallen erin zijn beschadigd</translation>
    </message>
    <message>
        <source>it is smaller than a micrometre; check the length unit</source>
        <translation>het is kleiner dan een micrometer; controleer de lengte-eenheid</translation>
    </message>
    <message>
        <source>its faces and edges are up to %1 apart, at a size of %2</source>
        <translation>de vlakken en randen liggen tot %1 uit elkaar, bij een grootte van %2</translation>
    </message>
    <message>
        <source>the solid has no volume</source>
        <translation>het lichaam heeft geen volume</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was left out: %2.</source>
        <translation>&quot;%1&quot; is weggelaten: %2.</translation>
    </message>
    <message>
        <source>the file holds no solid and no surface; export the part as a solid.</source>
        <translation>het bestand bevat geen lichaam en geen oppervlak; exporteer het onderdeel als lichaam.</translation>
    </message>
    <message>
        <source>%1 Of %2 parts like that none is left.</source>
        <translation>%1 Van %2 zulke onderdelen is er geen over.</translation>
    </message>
    <message>
        <source>this version of BREP is unknown (&quot;%1&quot;); save the file in an older version.</source>
        <translation>deze versie van BREP is onbekend (&quot;%1&quot;); sla het bestand op in een oudere versie.</translation>
    </message>
    <message>
        <source>the BREP file states an impossible number of %1; it is damaged, get it again.</source>
        <translation>het BREP-bestand noemt een onmogelijk aantal %1; het is beschadigd, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged: sections are missing; get it again.</source>
        <translation>het BREP-bestand is afgekapt of beschadigd: er ontbreken secties; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the file cannot be opened; check that you may read it.</source>
        <translation>het bestand kan niet worden geopend; controleer of u het mag lezen.</translation>
    </message>
    <message>
        <source>the file cannot be read; the disk or the connection to it failed.</source>
        <translation>het bestand kan niet worden gelezen; de schijf of de verbinding ermee faalde.</translation>
    </message>
    <message>
        <source>the file does not exist.</source>
        <translation>het bestand bestaat niet.</translation>
    </message>
    <message>
        <source>the file cannot be opened (%1).</source>
        <translation>het bestand kan niet worden geopend (%1).</translation>
    </message>
    <message>
        <source>this is a folder, not a file.</source>
        <translation>dit is een map, geen bestand.</translation>
    </message>
    <message>
        <source>this is not an ordinary file.</source>
        <translation>dit is geen gewoon bestand.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>het bestand is leeg.</translation>
    </message>
    <message>
        <source>this is a JSON text, but no glTF (&quot;asset&quot; is missing in it); export the part as STEP.</source>
        <translation>dit is een JSON-tekst, maar geen glTF (&quot;asset&quot; ontbreekt erin); exporteer het onderdeel als STEP.</translation>
    </message>
    <message>
        <source>this is a text, but none of %1; export the part as STEP.</source>
        <translation>dit is een tekst, maar geen van %1; exporteer het onderdeel als STEP.</translation>
    </message>
    <message>
        <source>the content is none of %1; export the part as STEP.</source>
        <translation>de inhoud is geen van %1; exporteer het onderdeel als STEP.</translation>
    </message>
    <message>
        <source>is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file.</source>
        <translation>is onvolledig: %1 van %2 vlakken van een schaal konden worden gelezen; de andere zijn in het bestand beschadigd.</translation>
    </message>
    <message>
        <source>it could not be measured (%1)</source>
        <translation>het kon niet worden gemeten (%1)</translation>
    </message>
    <message>
        <source>this is a gzip archive; unpack it and open the file inside.</source>
        <translation>dit is een gzip-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is a bzip2 archive; unpack it and open the file inside.</source>
        <translation>dit is een bzip2-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is a 7z archive; unpack it and open the file inside.</source>
        <translation>dit is een 7z-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is an xz archive; unpack it and open the file inside.</source>
        <translation>dit is een xz-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is a zstd archive; unpack it and open the file inside.</source>
        <translation>dit is een zstd-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is a rar archive; unpack it and open the file inside.</source>
        <translation>dit is een rar-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>this is a tar archive; unpack it and open the file inside.</source>
        <translation>dit is een tar-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again.</source>
        <translation>de tekst is UTF-16; sla hem op als gewone tekst (ASCII of UTF-8) en open hem opnieuw.</translation>
    </message>
    <message>
        <source>this is a PDF document; ask for the STEP file of the part.</source>
        <translation>dit is een PDF-document; vraag om het STEP-bestand van het onderdeel.</translation>
    </message>
    <message>
        <source>this is a picture; ask for the STEP file of the part.</source>
        <translation>dit is een afbeelding; vraag om het STEP-bestand van het onderdeel.</translation>
    </message>
    <message>
        <source>this is a database, not a CAD or mesh file.</source>
        <translation>dit is een database, geen CAD- of netbestand.</translation>
    </message>
    <message>
        <source>this is a native file of another program; export it as STEP there.</source>
        <translation>dit is een eigen bestand van een ander programma; exporteer het daar als STEP.</translation>
    </message>
    <message>
        <source>this is an AutoCAD drawing (DWG); export the part as STEP there.</source>
        <translation>dit is een AutoCAD-tekening (DWG); exporteer het onderdeel daar als STEP.</translation>
    </message>
    <message>
        <source>this is a program, not a CAD or mesh file.</source>
        <translation>dit is een programma, geen CAD- of netbestand.</translation>
    </message>
    <message>
        <source>this is a web page, not a CAD file; the download may have failed.</source>
        <translation>dit is een webpagina, geen CAD-bestand; het downloaden is misschien mislukt.</translation>
    </message>
    <message>
        <source>this is STEP as XML (part 28, stpx), which is not read here; export the part as STEP text (stp).</source>
        <translation>dit is STEP als XML (deel 28, stpx), dat hier niet wordt gelezen; exporteer het onderdeel als STEP-tekst (stp).</translation>
    </message>
    <message>
        <source>this is an XML text and not one of the files that are read here; export the part as STEP.</source>
        <translation>dit is een XML-tekst en geen van de bestanden die hier worden gelezen; exporteer het onderdeel als STEP.</translation>
    </message>
    <message>
        <source>this is a zip archive that is cut off or damaged; get it again.</source>
        <translation>dit is een zip-archief dat is afgekapt of beschadigd; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>this is a Word document; ask for the STEP file of the part.</source>
        <translation>dit is een Word-document; vraag om het STEP-bestand van het onderdeel.</translation>
    </message>
    <message>
        <source>this is an Excel workbook; ask for the STEP file of the part.</source>
        <translation>dit is een Excel-werkmap; vraag om het STEP-bestand van het onderdeel.</translation>
    </message>
    <message>
        <source>this is a PowerPoint presentation; ask for the STEP file of the part.</source>
        <translation>dit is een PowerPoint-presentatie; vraag om het STEP-bestand van het onderdeel.</translation>
    </message>
    <message>
        <source>this is a FreeCAD document; export the part as STEP there.</source>
        <translation>dit is een FreeCAD-document; exporteer het onderdeel daar als STEP.</translation>
    </message>
    <message>
        <source>this is a zip archive that holds &quot;%1&quot; (compressed STEP, stpz); unpack it and open that file.</source>
        <translation>dit is een zip-archief dat &quot;%1&quot; bevat (gecomprimeerd STEP, stpz); pak het uit en open dat bestand.</translation>
    </message>
    <message>
        <source>this is a zip archive; unpack it and open the file inside.</source>
        <translation>dit is een zip-archief; pak het uit en open het bestand erin.</translation>
    </message>
    <message>
        <source>the %1 file is damaged and cannot be read; export it again.</source>
        <translation>het %1-bestand is beschadigd en kan niet worden gelezen; exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>the GLB is damaged, or of another version than 2; export it again as glTF 2.0.</source>
        <translation>het GLB-bestand is beschadigd, of van een andere versie dan 2; exporteer het opnieuw als glTF 2.0.</translation>
    </message>
    <message>
        <source>the GLB is cut off or damaged; get it again.</source>
        <translation>het GLB-bestand is afgekapt of beschadigd; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>this is a glTF of version unknown, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>dit is een glTF van onbekende versie, maar alleen 2 kan worden gelezen; exporteer het opnieuw als glTF 2.0.</translation>
    </message>
    <message>
        <source>this is a glTF of version %1, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>dit is een glTF van versie %1, maar alleen 2 kan worden gelezen; exporteer het opnieuw als glTF 2.0.</translation>
    </message>
    <message>
        <source>the glTF is compressed (%1), which is not read here; export it without compression.</source>
        <translation>het glTF-bestand is gecomprimeerd (%1), wat hier niet wordt gelezen; exporteer het zonder compressie.</translation>
    </message>
    <message>
        <source>the glTF keeps its numbers in &quot;%1&quot;, which is not beside it; put it there.</source>
        <translation>het glTF-bestand bewaart zijn getallen in &quot;%1&quot;, dat er niet naast staat; zet het daar.</translation>
    </message>
    <message>
        <source>a node of the glTF is in two others; the file is damaged, export it again.</source>
        <translation>een knoop van het glTF-bestand zit in twee andere; het bestand is beschadigd, exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>nodes of the glTF hold themselves or are nested more than %1 deep; export it again.</source>
        <translation>knopen van het glTF-bestand bevatten zichzelf of zijn meer dan %1 diep genest; exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>the glTF file is cut off or damaged; get it again.</source>
        <translation>het glTF-bestand is afgekapt of beschadigd; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the %1 file has triangles with corners that are not there; it is damaged, get it again.</source>
        <translation>het %1-bestand heeft driehoeken met hoeken die er niet zijn; het is beschadigd, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>is not a closed surface: %1. It is shown and cannot be filled.</source>
        <translation>is geen gesloten oppervlak: %1. Het wordt getoond en kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>has no volume; it cannot be filled.</source>
        <translation>heeft geen volume; het kan niet worden gevuld.</translation>
    </message>
    <message>
        <source>the line &quot;%1&quot; in the header of the PLY file is damaged; get it again.</source>
        <translation>de regel &quot;%1&quot; in de kop van het PLY-bestand is beschadigd; haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the header of the PLY file has no end; it is cut off or damaged, get it again.</source>
        <translation>de kop van het PLY-bestand heeft geen einde; het is afgekapt of beschadigd, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the PLY file holds fewer numbers than its header promises; it is cut off, get it again.</source>
        <translation>het PLY-bestand bevat minder getallen dan zijn kop belooft; het is afgekapt, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that wrote it.</source>
        <translation>%1: het 3MF-bestand houdt zich op 1 plaats niet aan het formaat; vergelijk de onderdelen met het programma dat het schreef.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that wrote it.</source>
        <translation>%1: het 3MF-bestand houdt zich op %2 plaatsen niet aan het formaat; vergelijk de onderdelen met het programma dat het schreef.</translation>
    </message>
    <message>
        <source>the 3MF builds no object; export it again with the parts in its build.</source>
        <translation>het 3MF-bestand bouwt geen object; exporteer het opnieuw met de onderdelen in de opbouw.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than %1 objects, or nests them more than %2 deep; export the parts you need.</source>
        <translation>het 3MF-bestand ontvouwt zich tot meer dan %1 objecten, of nest ze meer dan %2 diep; exporteer de onderdelen die u nodig hebt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no triangles.</source>
        <translation>&quot;%1&quot; heeft geen driehoeken.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than 200 million triangles; export the parts you need.</source>
        <translation>het 3MF-bestand ontvouwt zich tot meer dan 200 miljoen driehoeken; exporteer de onderdelen die u nodig hebt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length unit; choose one of %2.</source>
        <translation>&quot;%1&quot; is geen lengte-eenheid; kies er een van %2.</translation>
    </message>
    <message>
        <source>Nothing was imported; the file is damaged, or needs a longer time limit.</source>
        <translation>Er is niets geïmporteerd; het bestand is beschadigd, of heeft een langere tijdslimiet nodig.</translation>
    </message>
    <message>
        <source>Nothing was imported; export the file again, best as STEP.</source>
        <translation>Er is niets geïmporteerd; exporteer het bestand opnieuw, het liefst als STEP.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was imported; try again.</source>
        <translation>het resultaat van de lezer is beschadigd (%1). Er is niets geïmporteerd; probeer het opnieuw.</translation>
    </message>
    <message>
        <source>%1: the reader crashed on what the file says beside its shapes; these were read without names, colors and assemblies, and without other files that it refers to.</source>
        <translation>%1: de lezer liep vast op wat het bestand naast zijn vormen zegt; die zijn gelezen zonder namen, kleuren en samenstellingen, en zonder andere bestanden waarnaar het verwijst.</translation>
    </message>
    <message>
        <source>There is no file to open.</source>
        <translation>Er is geen bestand om te openen.</translation>
    </message>
    <message>
        <source>%1: the 3MF requires what is not read here (%2), and parts may be stand-ins; compare them with the program that wrote it.</source>
        <translation>%1: de 3MF vereist wat hier niet wordt gelezen (%2), en onderdelen kunnen plaatsvervangers zijn; vergelijk ze met het programma dat het schreef.</translation>
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
    <message>
        <source>Time: automatic</source>
        <translation>Tijd: automatisch</translation>
    </message>
    <message>
        <source>Memory: automatic</source>
        <translation>Geheugen: automatisch</translation>
    </message>
    <message>
        <source>Reading may take</source>
        <translation>Lezen mag kosten</translation>
    </message>
</context>
<context>
    <name>ImportFeature</name>
    <message>
        <source>Import report</source>
        <translation>Importverslag</translation>
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
        <source>Looking into %1</source>
        <translation>%1 bekijken</translation>
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
        <source>Filling with a spacing of %1</source>
        <translation>Vullen met een afstand van %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>&quot;%1&quot; wordt niet gesimuleerd: %2</translation>
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
        <source>Add parts</source>
        <translation>Onderdelen toevoegen</translation>
    </message>
    <message>
        <source>Something else was done while parts were read, so none were added. Add them again.</source>
        <translation>Terwijl onderdelen gelezen werden, is er iets anders gedaan; daarom kwam er geen bij. Voeg ze opnieuw toe.</translation>
    </message>
    <message>
        <source>Add again</source>
        <translation>Opnieuw toevoegen</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>%1 wordt toegevoegd</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 en nog een</numerusform>
            <numerusform>%1 en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Put beside other things or on the floor, where there is room: %1.</source>
        <translation>Naast iets anders of op de vloer gelegd, waar plaats is: %1.</translation>
    </message>
    <message>
        <source>What these fixtures held was kneaded and has other objects now; they are gone: %1.</source>
        <translation>Wat deze inklemmingen vasthielden is gekneed en heeft nu andere objecten; ze zijn weg: %1.</translation>
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
    <message>
        <source>Remarks</source>
        <translation>Opmerkingen</translation>
    </message>
</context>
<context>
    <name>KeyCards</name>
    <message>
        <source>Tool %1: add one</source>
        <translation>Gereedschap %1: toevoegen</translation>
    </message>
</context>
<context>
    <name>KeyHand</name>
    <message>
        <source>%1 per step, %2 steps per second, Shift: slower</source>
        <translation>%1 per stap, %2 stappen per seconde, Shift: langzamer</translation>
    </message>
</context>
<context>
    <name>Load</name>
    <message>
        <source>A load must not be larger than 1e12 N, N m or Pa.</source>
        <translation>Een belasting mag niet groter dan 1e12 N, N m of Pa zijn.</translation>
    </message>
    <message>
        <source>A load must rise within 0 to 3600 s.</source>
        <translation>Een belasting moet binnen 0 tot 3600 s toenemen.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; acts on nothing.</source>
        <translation>De belasting &quot;%1&quot; werkt op niets.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names an object that does not exist.</source>
        <translation>De belasting &quot;%1&quot; noemt een object dat niet bestaat.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; has an area that is no number.</source>
        <translation>De belasting &quot;%1&quot; heeft een oppervlakte die geen getal is.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names a body that does not exist.</source>
        <translation>De belasting &quot;%1&quot; noemt een lichaam dat niet bestaat.</translation>
    </message>
    <message>
        <source>There is no load number %1.</source>
        <translation>Er is geen belasting nummer %1.</translation>
    </message>
</context>
<context>
    <name>LogPanel</name>
    <message>
        <source>Warning: %1</source>
        <translation>Waarschuwing: %1</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fout: %1</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Logboek</translation>
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
        <source>Click faces to hold or free them   Esc: done</source>
        <translation>Vlakken aanklikken om ze vast te houden of vrij te geven   Esc: klaar</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: drive   Shift: slower   %1: orbit</source>
        <translation>Pijlen, PgUp, PgDn: rijden   Shift: langzamer   %1: draaien</translation>
    </message>
    <message>
        <source>%1: orbit   %2: pan   Wheel: zoom</source>
        <translation>%1: draaien   %2: schuiven   Wiel: zoomen</translation>
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
        <source>Drag to move the timeline</source>
        <translation>Sleep om de tijdlijn te verplaatsen</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Weergave</translation>
    </message>
    <message>
        <source>Click into the view: arrows then drive the tool   %1: orbit</source>
        <translation>Klik in de weergave: dan rijden pijlen het gereedschap   %1: draaien</translation>
    </message>
    <message>
        <source>Another window could not be opened.</source>
        <translation>Er kon geen ander venster worden geopend.</translation>
    </message>
    <message>
        <source>Go back to the part first: Esc.</source>
        <translation>Ga eerst terug naar het onderdeel: Esc.</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: place   Space: play, and it presses   %1: orbit</source>
        <translation>Pijlen, PgUp, PgDn: neerzetten   Spatie: afspelen, dan drukt het   %1: draaien</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>%1 is %2; it must lie between %3 and %4.</source>
        <translation>%1: %2 kan niet, toegestaan is %3 tot %4.</translation>
    </message>
    <message>
        <source>The region names the object %1; the body has %2.</source>
        <translation>Het gebied noemt het object %1; het lichaam heeft er %2.</translation>
    </message>
    <message>
        <source>A body can be made of at most 255 different materials.</source>
        <translation>Een lichaam kan uit hoogstens 255 verschillende materialen bestaan.</translation>
    </message>
    <message>
        <source>A rigid body has no stress to lose. Make it deformable first.</source>
        <translation>Een star lichaam heeft geen spanning te verliezen. Maak het eerst vervormbaar.</translation>
    </message>
    <message>
        <source>Re-normalization takes 0 to 3600 s.</source>
        <translation>Hernormaliseren duurt 0 tot 3600 s.</translation>
    </message>
    <message>
        <source>There is no object number %1.</source>
        <translation>Er is geen object nummer %1.</translation>
    </message>
</context>
<context>
    <name>MaterialComparisonDialog</name>
    <message>
        <source>same</source>
        <translation>gelijk</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 maal</translation>
    </message>
    <message>
        <source>Compare materials</source>
        <translation>Materialen vergelijken</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Kengetal</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>Glijdingsmodulus</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Geluidssnelheid</translation>
    </message>
    <message>
        <source>1/%1 of it</source>
        <translation>1/%1 daarvan</translation>
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
        <translation>Zachte gelei</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Gelei</translation>
    </message>
    <message>
        <source>Soft foam</source>
        <translation>Zacht schuim</translation>
    </message>
    <message>
        <source>Sponge rubber</source>
        <translation>Sponsrubber</translation>
    </message>
    <message>
        <source>Silicone rubber</source>
        <translation>Siliconenrubber</translation>
    </message>
    <message>
        <source>Modeling clay</source>
        <translation>Boetseerklei</translation>
    </message>
    <message>
        <source>Natural rubber</source>
        <translation>Natuurrubber</translation>
    </message>
    <message>
        <source>Plasticine</source>
        <translation>Plasticine</translation>
    </message>
    <message>
        <source>Rigid foam</source>
        <translation>Hard schuim</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Wood along the grain</source>
        <translation>Hout langs de nerf</translation>
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
        <translation>Staal</translation>
    </message>
    <message>
        <source>Silicone, Shore A 10</source>
        <translation>Siliconen, Shore A 10</translation>
    </message>
    <message>
        <source>Silicone, Shore A 20</source>
        <translation>Siliconen, Shore A 20</translation>
    </message>
    <message>
        <source>Silicone, Shore A 30</source>
        <translation>Siliconen, Shore A 30</translation>
    </message>
    <message>
        <source>Silicone, Shore A 40</source>
        <translation>Siliconen, Shore A 40</translation>
    </message>
    <message>
        <source>Silicone, Shore A 50</source>
        <translation>Siliconen, Shore A 50</translation>
    </message>
    <message>
        <source>Silicone, Shore A 60</source>
        <translation>Siliconen, Shore A 60</translation>
    </message>
    <message>
        <source>Water clay</source>
        <translation>Waterhoudende klei</translation>
    </message>
    <message>
        <source>Oil clay</source>
        <translation>Plastiline</translation>
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
        <translation>Stopverf</translation>
    </message>
    <message>
        <source>Warm wax</source>
        <translation>Warme was</translation>
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
        <source>Young&apos;s modulus</source>
        <translation>Elasticiteitsmodulus</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
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
        <source>Rubber</source>
        <translation>Rubber</translation>
    </message>
    <message>
        <source>Rubberlike</source>
        <translation>Rubberachtig</translation>
    </message>
    <message>
        <source>for small strains</source>
        <translation>voor kleine rekken</translation>
    </message>
    <message>
        <source>Second-invariant share</source>
        <translation>Aandeel tweede invariant</translation>
    </message>
    <message>
        <source>Locking elongation</source>
        <translation>Rek bij verstijving</translation>
    </message>
    <message>
        <source>never locks</source>
        <translation>verstijft nooit</translation>
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
    <message>
        <source>What follows</source>
        <translation>Wat daaruit volgt</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Geluidssnelheid</translation>
    </message>
    <message>
        <source>Of a thin bar: the root of stiffness by density</source>
        <translation>Van een dunne staaf: de wortel uit stijfheid gedeeld door dichtheid</translation>
    </message>
    <message>
        <source>Stable time step</source>
        <translation>Stabiele tijdstap</translation>
    </message>
    <message>
        <source>Longest step of an explicit scheme, for all bodies together; shorter for stiff, light and finely filled ones</source>
        <translation>Langste stap van een expliciet schema, voor alle lichamen samen; korter voor stijve, lichte en fijn gevulde lichamen</translation>
    </message>
    <message>
        <source>Expected speed</source>
        <translation>Verwachte snelheid</translation>
    </message>
    <message>
        <source>Simulated by wall time on this machine: measured while time ran, else by a rule</source>
        <translation>Gesimuleerde per ware tijd op deze computer: gemeten terwijl de tijd liep, anders volgens een vuistregel</translation>
    </message>
    <message>
        <source>Cells across walls</source>
        <translation>Cellen dwars op wanden</translation>
    </message>
    <message>
        <source>%1 to %2, with any unit; 1.2e6 and 1,2 are taken too</source>
        <translation>%1 tot %2, in elke eenheid; ook 1.2e6 en 1,2 mogen</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>ongeveer %1</translation>
    </message>
    <message>
        <source>keeps up with real time</source>
        <translation>houdt ware tijd bij</translation>
    </message>
    <message>
        <source>%1 of real time</source>
        <translation>%1 maal ware tijd</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>niet gemeten</translation>
    </message>
    <message>
        <source>Save these numbers as a material of your own</source>
        <translation>Deze getallen als eigen materiaal opslaan</translation>
    </message>
    <message>
        <source>Rename this material of your own</source>
        <translation>Dit eigen materiaal hernoemen</translation>
    </message>
    <message>
        <source>Delete this material of your own; bodies keep its numbers</source>
        <translation>Dit eigen materiaal verwijderen; lichamen behouden de getallen</translation>
    </message>
    <message>
        <source>Compare with another material, side by side</source>
        <translation>Met een ander materiaal vergelijken, naast elkaar</translation>
    </message>
    <message>
        <source>Save material</source>
        <translation>Materiaal opslaan</translation>
    </message>
    <message>
        <source>Rename material</source>
        <translation>Materiaal hernoemen</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Naam van het materiaal</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 nu</translation>
    </message>
    <message>
        <source>Across the thinnest wall: with fewer than %1 its bending comes out too stiff</source>
        <translation>Dwars op de dunste wand: met minder dan %1 buigt die te stijf</translation>
    </message>
    <message>
        <source>%1: many times too stiff</source>
        <translation>%1: vele malen te stijf</translation>
    </message>
    <message>
        <source>%1: up to %2 % too stiff</source>
        <translation>%1: tot %2 % te stijf</translation>
    </message>
    <message>
        <source>Toughness</source>
        <translation>Taaiheid</translation>
    </message>
    <message>
        <source>knives do not cut it</source>
        <translation>messen snijden het niet</translation>
    </message>
    <message>
        <source>Softer to the left, as warm or wet clay; firmer to the right, as cold or dry clay</source>
        <translation>Naar links zachter, zoals warme of natte klei; naar rechts steviger, zoals koude of droge klei</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 maal</translation>
    </message>
    <message>
        <source>Softer / firmer</source>
        <translation>Zachter / steviger</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>zoals het is</translation>
    </message>
    <message>
        <source>Firmness of %1 as it was</source>
        <translation>Stevigheid van %1 zoals het was</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 zachter</translation>
    </message>
    <message>
        <source>%1 firmer</source>
        <translation>%1 steviger</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>geen grens</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>minder dan %1</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>Waar de getallen vandaan komen</translation>
    </message>
</context>
<context>
    <name>MaterialStore</name>
    <message>
        <source>Your own materials cannot be read: %1 Mend or remove the file; until then none can be saved.</source>
        <translation>Uw eigen materialen kunnen niet gelezen worden: %1 Herstel of verwijder het bestand; tot dan kan er geen opgeslagen worden.</translation>
    </message>
    <message>
        <source>A material needs a name: type one.</source>
        <translation>Een materiaal heeft een naam nodig: typ er een.</translation>
    </message>
    <message>
        <source>There is a material named &quot;%1&quot; already: choose another name.</source>
        <translation>Er is al een materiaal met de naam &quot;%1&quot;: kies een andere naam.</translation>
    </message>
    <message>
        <source>Saved by you</source>
        <translation>Door u opgeslagen</translation>
    </message>
    <message>
        <source>The material was not saved: %1</source>
        <translation>Het materiaal werd niet opgeslagen: %1</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Nothing is measured yet. Choose what to measure above, then click on the part; corners attract. Numbers follow the material while time runs.</source>
        <translation>Er is nog niets gemeten. Kies hierboven wat u wilt meten en klik dan op het onderdeel; hoekpunten trekken aan. De getallen volgen het materiaal terwijl de tijd loopt.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Vergelijken...</translation>
    </message>
    <message>
        <source>Compare the parts with their original shape, and write a report</source>
        <translation>De onderdelen met hun oorspronkelijke vorm vergelijken, en een verslag schrijven</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>Copy the table (Ctrl+C)</source>
        <translation>De tabel kopiëren (Ctrl+C)</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write the table to a file, units in its columns</source>
        <translation>De tabel naar een bestand schrijven, met eenheden in de kolommen</translation>
    </message>
    <message>
        <source>Delete the selected measurements, or all (Del)</source>
        <translation>De gekozen metingen verwijderen, of alle (Del)</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Meting</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nu</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In rust</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Verandering</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Meetwaarde</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Metingen</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>The face is not flat: it is up to %1 away from its mean plane.</source>
        <translation>Het vlak is niet plat: het wijkt tot %1 af van zijn gemiddelde vlak.</translation>
    </message>
    <message>
        <source>The three places lie on a line: pick others, further around.</source>
        <translation>De drie punten liggen op één lijn: kies andere, verder rondom.</translation>
    </message>
    <message>
        <source>The face is flat and has no radius: click a round one, or measure with three places.</source>
        <translation>Het vlak is plat en heeft geen straal: klik een rond vlak aan, of meet met drie punten.</translation>
    </message>
    <message>
        <source>The face is not quite round: it is up to %1 away from this radius.</source>
        <translation>Het vlak is niet helemaal rond: het wijkt tot %1 af van deze straal.</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Verplaatst</translation>
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
        <translation>Afstand</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>langs X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>langs Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>langs Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Straal</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
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
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Center of mass X</source>
        <translation>Massamiddelpunt X</translation>
    </message>
    <message>
        <source>Center of mass Y</source>
        <translation>Massamiddelpunt Y</translation>
    </message>
    <message>
        <source>Center of mass Z</source>
        <translation>Massamiddelpunt Z</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punt</translation>
    </message>
    <message>
        <source>Coordinates of a place, and how far it has moved</source>
        <translation>Coördinaten van een punt, en hoe ver het verplaatst is</translation>
    </message>
    <message>
        <source>Distance between two places</source>
        <translation>Afstand tussen twee punten</translation>
    </message>
    <message>
        <source>Distance to face</source>
        <translation>Afstand tot vlak</translation>
    </message>
    <message>
        <source>Distance of a place from the nearest point of a face</source>
        <translation>Afstand van een punt tot het dichtstbijzijnde punt van een vlak</translation>
    </message>
    <message>
        <source>Angle at the second of three places</source>
        <translation>Hoek bij het tweede van drie punten</translation>
    </message>
    <message>
        <source>Angle of faces</source>
        <translation>Hoek tussen vlakken</translation>
    </message>
    <message>
        <source>Angle between the normals of two faces</source>
        <translation>Hoek tussen de normalen van twee vlakken</translation>
    </message>
    <message>
        <source>Radius of the circle through three places</source>
        <translation>Straal van de cirkel door drie punten</translation>
    </message>
    <message>
        <source>Radius of face</source>
        <translation>Straal van vlak</translation>
    </message>
    <message>
        <source>Radius of a hole, a cylinder or a ball</source>
        <translation>Straal van een gat, een cilinder of een bol</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Begrenzingskader</translation>
    </message>
    <message>
        <source>Sizes of a part along the axes</source>
        <translation>Afmetingen van een onderdeel langs de assen</translation>
    </message>
    <message>
        <source>Volume and mass</source>
        <translation>Volume en massa</translation>
    </message>
    <message>
        <source>Volume, mass and center of mass of a part</source>
        <translation>Volume, massa en massamiddelpunt van een onderdeel</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be measured: %2</source>
        <translation>&quot;%1&quot; kan niet worden gemeten: %2</translation>
    </message>
    <message>
        <source>a place is three coordinates in mm, as 10,0,2.5; this is %1.</source>
        <translation>een plaats is drie coördinaten in mm, zoals 10,0,2.5; dit is %1.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; coordinates are in mm.</source>
        <translation>%1 ligt ver van alle lichamen; coördinaten zijn in mm.</translation>
    </message>
    <message>
        <source>there is no body &quot;%1&quot;; there are: %2.</source>
        <translation>er is geen lichaam &quot;%1&quot;; er zijn: %2.</translation>
    </message>
    <message>
        <source>which body the face %1 is of is not clear; put its name before it, as &quot;lid&quot;:%1, or its number from 0, as #0:%1.</source>
        <translation>het is niet duidelijk van welk lichaam vlak %1 is; zet de naam ervoor, zoals &quot;lid&quot;:%1, of het nummer vanaf 0, zoals #0:%1.</translation>
    </message>
    <message>
        <source>there is no face %1; faces are numbered from 0, and meshes have none.</source>
        <translation>er is geen vlak %1; vlakken worden geteld vanaf 0, en netten hebben er geen.</translation>
    </message>
    <message>
        <source>it begins with none of %1.</source>
        <translation>het begint met geen van %1.</translation>
    </message>
    <message>
        <source>%1 takes %2 places or faces.</source>
        <translation>%1 vraagt %2 plaatsen of vlakken.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>het project heeft geen onderdelen.</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>het project heeft geen stap %1; de laatste is %2.</translation>
    </message>
    <message>
        <source>this is no project: it has no entries.</source>
        <translation>dit is geen project: het heeft geen stappen.</translation>
    </message>
    <message>
        <source>no part of it is closed, so there is nothing to measure.</source>
        <translation>geen onderdeel ervan is gesloten, dus er is niets te meten.</translation>
    </message>
</context>
<context>
    <name>MeasurementList</name>
    <message>
        <source>Measurement,Reading,Unit,Now,At rest,Change</source>
        <translation>Meting,Meetwaarde,Eenheid,Nu,In rust,Verandering</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>Compare with original...</source>
        <translation>Met origineel vergelijken...</translation>
    </message>
    <message>
        <source>Largest and mean distance, volume and mass beside the original, and a report</source>
        <translation>Grootste en gemiddelde afstand, volume en massa naast het origineel, en een verslag</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Hoekpunt</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Meting</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Meetwaarde</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nu</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In rust</translation>
    </message>
</context>
<context>
    <name>MeasuringFeature</name>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Meten</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Metingen</translation>
    </message>
    <message>
        <source>Write what was measured</source>
        <translation>Metingen schrijven</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabel (*.csv)</translation>
    </message>
</context>
<context>
    <name>ModelNotes</name>
    <message>
        <source>Group</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selectie</translation>
    </message>
</context>
<context>
    <name>ModelPanel</name>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Zoeken (Ctrl+F)</translation>
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
    <message>
        <source>Selections</source>
        <translation>Selecties</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exportbestanden</translation>
    </message>
    <message>
        <source>In the file: %1</source>
        <translation>In het bestand: %1</translation>
    </message>
    <message>
        <source>%1 selected things; a click selects them again</source>
        <translation>%1 gekozen elementen; een klik kiest ze opnieuw</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Kiezen</translation>
    </message>
    <message>
        <source>Keep the present selection here</source>
        <translation>De huidige selectie hier bewaren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>In de map tonen</translation>
    </message>
    <message>
        <source>The folder %1 cannot be shown: look for it with your file manager.</source>
        <translation>De map %1 kan niet getoond worden: zoek hem met uw bestandsbeheerder.</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>Van de lijst halen</translation>
    </message>
    <message>
        <source>There is a selection called &quot;%1&quot; already: choose another name.</source>
        <translation>Er is al een selectie met de naam &quot;%1&quot;: kies een andere naam.</translation>
    </message>
    <message>
        <source>Color of the part</source>
        <translation>Kleur van het onderdeel</translation>
    </message>
    <message>
        <source>Color of %1 parts</source>
        <translation>Kleur van %1 onderdelen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
</context>
<context>
    <name>ModelTreeDelegate</name>
    <message>
        <source>Show (H)</source>
        <translation>Tonen (H)</translation>
    </message>
    <message>
        <source>Hide (H)</source>
        <translation>Verbergen (H)</translation>
    </message>
    <message>
        <source>Unlock (L)</source>
        <translation>Ontgrendelen (L)</translation>
    </message>
    <message>
        <source>Lock: keep it from being changed (L)</source>
        <translation>Vergrendelen: tegen wijzigen beschermen (L)</translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>middle+left</source>
        <translation>midden+links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>midden</translation>
    </message>
    <message>
        <source>Shift+</source>
        <translation>Shift+</translation>
    </message>
    <message>
        <source>Ctrl+</source>
        <translation>Ctrl+</translation>
    </message>
    <message>
        <source>Two buttons / touchpad</source>
        <translation>Twee knoppen / touchpad</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 billion</source>
        <translation>%1 miljard</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 miljoen</translation>
    </message>
    <message>
        <source>%1 thousand</source>
        <translation>%1 duizend</translation>
    </message>
</context>
<context>
    <name>NumberPage</name>
    <message>
        <source>Begins and ends gently</source>
        <translation>Begint en eindigt geleidelijk</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>The selected ones</source>
        <translation>De geselecteerde</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Onderdelen</translation>
    </message>
    <message>
        <source>The longest side</source>
        <translation>De langste zijde</translation>
    </message>
    <message>
        <source>Normal of the selected face</source>
        <translation>Normaal van het geselecteerde vlak</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>As</translation>
    </message>
    <message>
        <source>First plane</source>
        <translation>Eerste vlak</translation>
    </message>
    <message>
        <source>Where it begins, along the axis from the origin</source>
        <translation>Waar het begint, langs de as vanaf de oorsprong</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Tweede vlak</translation>
    </message>
    <message>
        <source>Where it ends, along the axis from the origin</source>
        <translation>Waar het eindigt, langs de as vanaf de oorsprong</translation>
    </message>
    <message>
        <source>Toward</source>
        <translation>Naar</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Of the second plane against the first one; below 0 the other way</source>
        <translation>Van het tweede vlak ten opzichte van het eerste; onder 0 de andere kant op</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Straal</translation>
    </message>
    <message>
        <source>Of the line that keeps its length; the angle follows</source>
        <translation>Van de lijn die haar lengte houdt; de hoek volgt</translation>
    </message>
    <message>
        <source>Neutral line</source>
        <translation>Neutrale lijn</translation>
    </message>
    <message>
        <source>What keeps its length: 0 at the inner side, 1 at the outer one. Sheet metal has some 0.33 to 0.5, its k-factor</source>
        <translation>Wat zijn lengte houdt: 0 aan de binnenzijde, 1 aan de buitenzijde. Plaatwerk heeft zo&apos;n 0,33 tot 0,5, zijn k-factor</translation>
    </message>
    <message>
        <source>Neutral place</source>
        <translation>Neutrale plaats</translation>
    </message>
    <message>
        <source>The same as a place along the side that it bends toward</source>
        <translation>Hetzelfde als plaats langs de zijde waarheen het buigt</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Of the second plane; 1 changes nothing</source>
        <translation>Van het tweede vlak; 1 verandert niets</translation>
    </message>
    <message>
        <source>New length</source>
        <translation>Nieuwe lengte</translation>
    </message>
    <message>
        <source>Between the planes afterwards; the factor follows</source>
        <translation>Daarna tussen de vlakken; de factor volgt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschuiving</translation>
    </message>
    <message>
        <source>Of the second plane, sideways</source>
        <translation>Van het tweede vlak, zijwaarts</translation>
    </message>
    <message>
        <source>The first plane</source>
        <translation>Het eerste vlak</translation>
    </message>
    <message>
        <source>The middle</source>
        <translation>Het midden</translation>
    </message>
    <message>
        <source>The second plane</source>
        <translation>Het tweede vlak</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Blijft op zijn plaats</translation>
    </message>
    <message>
        <source>Without a crease at the planes; in the middle there is then more of it</source>
        <translation>Zonder knik bij de vlakken; in het midden is het dan meer</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>recht</translation>
    </message>
    <message>
        <source>Let go at the end</source>
        <translation>Aan het eind loslaten</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Exact</translation>
    </message>
    <message>
        <source>By physics</source>
        <translation>Door fysica</translation>
    </message>
    <message>
        <source>Exactly: all goes as the formula says. By physics: what lies beyond the planes is held by grips that go as the formula says, and the material between them finds its own shape</source>
        <translation>Exact: alles gaat zoals de formule zegt. Door fysica: wat voorbij de grensvlakken ligt wordt vastgehouden door grepen die gaan zoals de formule zegt, en het materiaal ertussen vindt zijn eigen vorm</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Hoe</translation>
    </message>
    <message>
        <source>Time it takes</source>
        <translation>Duur</translation>
    </message>
    <message>
        <source>Of the way of the grips; material that flows resists less when it is slow</source>
        <translation>Van de weg van de grepen; materiaal dat vloeit biedt minder weerstand als het langzaam gaat</translation>
    </message>
    <message>
        <source>The grip that has moved most opens, so that elastic material springs back</source>
        <translation>De greep die het meest bewogen heeft gaat open, zodat elastisch materiaal terugveert</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>The graphics card draws no pictures of this size. Choose a smaller one.</source>
        <translation>De grafische kaart tekent geen beelden van deze grootte. Kies een kleinere.</translation>
    </message>
    <message>
        <source>The graphics card takes no more pictures. Close other programs and try again.</source>
        <translation>De grafische kaart neemt geen beelden meer op. Sluit andere programma&apos;s en probeer het opnieuw.</translation>
    </message>
    <message>
        <source>The graphics driver draws for the window only, so that nothing can be recorded. Start Knead with LIBGL_ALWAYS_SOFTWARE=1 in its environment to record without the driver.</source>
        <translation>Het grafische stuurprogramma tekent alleen voor het venster, dus er kan niets worden opgenomen. Start Knead met LIBGL_ALWAYS_SOFTWARE=1 in zijn omgeving om zonder het stuurprogramma op te nemen.</translation>
    </message>
</context>
<context>
    <name>OtherPartDialog</name>
    <message>
        <source>Apply to another part</source>
        <translation>Op een ander onderdeel toepassen</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nee</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Dwars op %1</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>Dezelfde</translation>
    </message>
    <message>
        <source>Another one, as its box says</source>
        <translation>Een andere, zoals de omhullende zegt</translation>
    </message>
    <message>
        <source>So many times as large</source>
        <translation>Zo veel keer zo groot</translation>
    </message>
    <message>
        <source>%1, as compared with the part that is open:</source>
        <translation>%1, vergeleken met het onderdeel dat open is:</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegeld</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Keer</translation>
    </message>
    <message>
        <source>Find the faces again</source>
        <translation>Vlakken terugvinden</translation>
    </message>
</context>
<context>
    <name>OtherPartFeature</name>
    <message>
        <source>%1 of %2 faces were found again.</source>
        <translation>%1 van %2 vlakken zijn teruggevonden.</translation>
    </message>
    <message>
        <source>Moved: %1 by %2 mm</source>
        <translation>Verplaatst: %1 met %2 mm</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>en nog %1</translation>
    </message>
    <message>
        <source>Apply to another part</source>
        <translation>Op een ander onderdeel toepassen</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Onderdelen (%1)</translation>
    </message>
    <message>
        <source>Finding the faces again on %1</source>
        <translation>De vlakken worden op %1 teruggezocht</translation>
    </message>
    <message>
        <source>This is what was found again on %1:</source>
        <translation>Dit is op %1 teruggevonden:</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Apply to %1</source>
        <translation>Toepassen op %1</translation>
    </message>
    <message>
        <source>Play carries out on %1 what was done before.</source>
        <translation>Afspelen voert op %1 uit wat eerder is gedaan.</translation>
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
    <message>
        <source>Time of a frame</source>
        <translation>Tijd van een beeld</translation>
    </message>
</context>
<context>
    <name>PickTool</name>
    <message>
        <source>click a place</source>
        <translation>klik een punt aan</translation>
    </message>
    <message>
        <source>click place %1 of %2</source>
        <translation>klik punt %1 van %2 aan</translation>
    </message>
    <message>
        <source>click a face</source>
        <translation>klik een vlak aan</translation>
    </message>
    <message>
        <source>click face %1 of %2</source>
        <translation>klik vlak %1 van %2 aan</translation>
    </message>
    <message>
        <source>click a part</source>
        <translation>klik een onderdeel aan</translation>
    </message>
    <message>
        <source>%1: %2   Esc: done</source>
        <translation>%1: %2   Esc: klaar</translation>
    </message>
    <message>
        <source>There is nothing at that place: click on a part.</source>
        <translation>Op die plaats is niets: klik op een onderdeel.</translation>
    </message>
    <message>
        <source>This part is a mesh without CAD faces: measure it with places instead.</source>
        <translation>Dit onderdeel is een net zonder CAD-vlakken: meet het in plaats daarvan met punten.</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>The picture cannot be written in this format (%1). Choose another one.</source>
        <translation>De afbeelding kan niet in dit formaat worden geschreven (%1). Kies een ander.</translation>
    </message>
    <message>
        <source>The picture cannot be written in %1 (%2). Free some room, or choose another place.</source>
        <translation>De afbeelding kan niet in %1 worden geschreven (%2). Maak ruimte vrij of kies een andere plaats.</translation>
    </message>
</context>
<context>
    <name>PictureDialog</name>
    <message>
        <source>Save a picture</source>
        <translation>Afbeelding opslaan</translation>
    </message>
    <message>
        <source>PNG, exact</source>
        <translation>PNG, exact</translation>
    </message>
    <message>
        <source>JPEG, small</source>
        <translation>JPEG, klein</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Doorzichtige achtergrond</translation>
    </message>
    <message>
        <source>With grid and shadow</source>
        <translation>Met raster en schaduw</translation>
    </message>
    <message>
        <source>With the view cube</source>
        <translation>Met de aanzichtkubus</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formaat</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Een plaats kiezen...</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, zoals het aanzicht</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Only PNG files can have a transparent background.</source>
        <translation>Alleen PNG-bestanden kunnen een doorzichtige achtergrond hebben.</translation>
    </message>
</context>
<context>
    <name>PictureFeature</name>
    <message>
        <source>Save the picture</source>
        <translation>Afbeelding opslaan</translation>
    </message>
    <message>
        <source>writing the picture</source>
        <translation>afbeelding wordt geschreven</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wordt getekend</translation>
    </message>
    <message>
        <source>%1: picture saved.</source>
        <translation>%1: afbeelding opgeslagen.</translation>
    </message>
</context>
<context>
    <name>PlaceRows</name>
    <message>
        <source>Show me</source>
        <translation>Toon</translation>
    </message>
    <message>
        <source>Look there in the view (Enter)</source>
        <translation>In het beeld daarheen kijken (Enter)</translation>
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
    <message>
        <source>Mouse as in</source>
        <translation>Muis zoals in</translation>
    </message>
    <message>
        <source>Which buttons orbit, pan and zoom; the status bar tells. The wheel zooms to the cursor.</source>
        <translation>Welke knoppen draaien, schuiven en zoomen; de statusbalk zegt het. Het wiel zoomt naar de aanwijzer.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Tekstgrootte</translation>
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
        <translation>%1 vervormt niet: maak het vervormbaar in de eigenschappen om erin te drukken.</translation>
    </message>
    <message>
        <source>Press on %1</source>
        <translation>Op %1 drukken</translation>
    </message>
    <message>
        <source>%1 (limit)</source>
        <translation>%1 (grens)</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it in the model tree to press with it.</source>
        <translation>%1 is vergrendeld: ontgrendel het in de modelboom om ermee te drukken.</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>Displacement</source>
        <translation>Verplaatsing</translation>
    </message>
    <message>
        <source>Equivalent strain</source>
        <translation>Equivalente rek</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von Mises-spanning</translation>
    </message>
    <message>
        <source>Force on tools</source>
        <translation>Kracht op gereedschap</translation>
    </message>
    <message>
        <source>Force on all tools</source>
        <translation>Kracht op al het gereedschap</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Meetpunt</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Rek</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spanning</translation>
    </message>
    <message>
        <source>No probes yet. Place one on the part: it goes along with the material and plots what it reads, also of what was simulated before.</source>
        <translation>Nog geen meetpunten. Plaats er een op het onderdeel: het gaat met het materiaal mee en zet uit wat het meet, ook van wat eerder gesimuleerd werd.</translation>
    </message>
    <message>
        <source>What is plotted over time</source>
        <translation>Wat over de tijd uitgezet wordt</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write all readings over time to a file, units in its header</source>
        <translation>Alle meetwaarden over de tijd naar een bestand schrijven, met eenheden in de kop</translation>
    </message>
    <message>
        <source>Delete the selected probes, or all</source>
        <translation>De gekozen meetpunten verwijderen, of alle</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>Meetpunt %1</translation>
    </message>
    <message>
        <source>All tools</source>
        <translation>Al het gereedschap</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Meetpunten</translation>
    </message>
</context>
<context>
    <name>ProbeSet</name>
    <message>
        <source>Probe %1</source>
        <translation>Meetpunt %1</translation>
    </message>
</context>
<context>
    <name>ProbesFeature</name>
    <message>
        <source>Probes</source>
        <translation>Meetpunten</translation>
    </message>
    <message>
        <source>Write what the probes read</source>
        <translation>Meetwaarden van de meetpunten schrijven</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabel (*.csv)</translation>
    </message>
    <message>
        <source>Place probe</source>
        <translation>Meetpunt plaatsen</translation>
    </message>
    <message>
        <source>Click places of the part to plot what happens there over time</source>
        <translation>Plaatsen van het onderdeel aanklikken om uit te zetten wat daar in de tijd gebeurt</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>what was done last</source>
        <translation>wat het laatst is gedaan</translation>
    </message>
    <message>
        <source>the state after &quot;%1&quot;</source>
        <translation>de toestand na &quot;%1&quot;</translation>
    </message>
    <message>
        <source>a number in the table blobs is out of range</source>
        <translation>een getal in de tabel blobs valt buiten het bereik</translation>
    </message>
    <message>
        <source>a row of the table blobs cannot be unpacked</source>
        <translation>een rij van de tabel blobs kan niet worden uitgepakt</translation>
    </message>
    <message>
        <source>pieces of the table blobs are mixed up</source>
        <translation>stukken van de tabel blobs zijn door elkaar geraakt</translation>
    </message>
    <message>
        <source>Another window works on this: discard it there.</source>
        <translation>Een ander venster werkt hieraan: verwerp het daar.</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>het kan niet worden uitgepakt</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>zo&apos;n bestand is er niet.</translation>
    </message>
    <message>
        <source>this is a folder, not a project.</source>
        <translation>dit is een map, geen project.</translation>
    </message>
    <message>
        <source>this is no file, and no project either.</source>
        <translation>dit is geen bestand, en ook geen project.</translation>
    </message>
    <message>
        <source>the file cannot be read; check its permissions.</source>
        <translation>het bestand kan niet worden gelezen; controleer de rechten ervan.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>het bestand is leeg.</translation>
    </message>
    <message>
        <source>this is not a Knead project.</source>
        <translation>dit is geen Knead-project.</translation>
    </message>
    <message>
        <source>this is a database of another program, not a Knead project.</source>
        <translation>dit is een database van een ander programma, geen Knead-project.</translation>
    </message>
    <message>
        <source>%1: the project is damaged: %2. What is whole can be rescued.</source>
        <translation>%1: het project is beschadigd: %2. Wat heel is, kan worden gered.</translation>
    </message>
    <message>
        <source>there is a folder of this name; choose another name.</source>
        <translation>er is een map met deze naam; kies een andere naam.</translation>
    </message>
    <message>
        <source>the file is read-only; save the project under another name.</source>
        <translation>het bestand is alleen-lezen; sla het project op onder een andere naam.</translation>
    </message>
    <message>
        <source>its tables are not those of a project</source>
        <translation>de tabellen ervan zijn niet die van een project</translation>
    </message>
    <message>
        <source>a newer Knead saved this project (version %1 of the file; this program reads up to %2). Update Knead to open it.</source>
        <translation>een nieuwere Knead heeft dit project opgeslagen (versie %1 van het bestand; dit programma leest tot en met %2). Werk Knead bij om het te openen.</translation>
    </message>
    <message>
        <source>what was written cannot be read back: %1</source>
        <translation>wat is geschreven, kan niet worden teruggelezen: %1</translation>
    </message>
    <message>
        <source>nothing of this project can be read any more; open a copy of it, or the part that it was made from.</source>
        <translation>van dit project kan niets meer worden gelezen; open een kopie ervan, of het onderdeel waarvan het is gemaakt.</translation>
    </message>
    <message>
        <source>another window works on it. Close it there, or open a copy.</source>
        <translation>een ander venster werkt eraan. Sluit het daar, of open een kopie.</translation>
    </message>
    <message>
        <source>another window of this program works on it. Close it there, or open a copy.</source>
        <translation>een ander venster van dit programma werkt eraan. Sluit het daar, of open een kopie.</translation>
    </message>
    <message>
        <source>another window works on it (process %1 on %2, since %3). Close it there, or open a copy.</source>
        <translation>een ander venster werkt eraan (proces %1 op %2, sinds %3). Sluit het daar, of open een kopie.</translation>
    </message>
    <message>
        <source>a fixture is of a body that is not there</source>
        <translation>een inklemming is van een lichaam dat er niet is</translation>
    </message>
    <message>
        <source>a fixture has objects that are not there</source>
        <translation>een inklemming heeft objecten die er niet zijn</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>een aantal is negatief</translation>
    </message>
    <message>
        <source>rows of the table contents are mixed up</source>
        <translation>rijen van de tabel contents zijn door elkaar geraakt</translation>
    </message>
    <message>
        <source>the number of rows of the table %1</source>
        <translation>het aantal rijen van de tabel %1</translation>
    </message>
    <message>
        <source>the table %1</source>
        <translation>de tabel %1</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>het model</translation>
    </message>
    <message>
        <source>tool part %1</source>
        <translation>gereedschapsonderdeel %1</translation>
    </message>
    <message>
        <source>start state %1</source>
        <translation>begintoestand %1</translation>
    </message>
    <message>
        <source>rows of the table bodies are mixed up</source>
        <translation>rijen van de tabel bodies zijn door elkaar geraakt</translation>
    </message>
    <message>
        <source>a body is of a part that is not there</source>
        <translation>een lichaam is van een onderdeel dat er niet is</translation>
    </message>
    <message>
        <source>a region has objects that are not there</source>
        <translation>een gebied heeft objecten die er niet zijn</translation>
    </message>
    <message>
        <source>entry %1</source>
        <translation>regel %1</translation>
    </message>
    <message>
        <source>which entry was shown</source>
        <translation>welke regel werd getoond</translation>
    </message>
    <message>
        <source>that entry is missing</source>
        <translation>die regel ontbreekt</translation>
    </message>
    <message>
        <source>it follows a later one</source>
        <translation>hij volgt op een latere</translation>
    </message>
    <message>
        <source>the entry that it follows is missing</source>
        <translation>de regel waarop hij volgt, ontbreekt</translation>
    </message>
    <message>
        <source>its start state is missing</source>
        <translation>de begintoestand ervan ontbreekt</translation>
    </message>
    <message>
        <source>the state of entry %1</source>
        <translation>de toestand van regel %1</translation>
    </message>
    <message>
        <source>it is of another length</source>
        <translation>hij heeft een andere lengte</translation>
    </message>
    <message>
        <source>the view</source>
        <translation>het beeld</translation>
    </message>
    <message>
        <source>mark %1</source>
        <translation>markering %1</translation>
    </message>
    <message>
        <source>its entry is missing</source>
        <translation>de regel ervan ontbreekt</translation>
    </message>
    <message>
        <source>what panel %1 kept</source>
        <translation>wat paneel %1 bewaarde</translation>
    </message>
    <message>
        <source>The work cannot be kept for recovery (%1). Save the project, and make room in %2.</source>
        <translation>Het werk kan niet voor herstel worden bewaard (%1). Sla het project op, en maak ruimte in %2.</translation>
    </message>
    <message>
        <source>Nothing of the work that was kept in %1 can be read any more. Discard it, and open what was saved last.</source>
        <translation>Van het werk dat in %1 was bewaard, kan niets meer worden gelezen. Verwerp het, en open wat het laatst is opgeslagen.</translation>
    </message>
    <message>
        <source>its folder cannot be locked</source>
        <translation>de map ervan kan niet worden vergrendeld</translation>
    </message>
    <message>
        <source>Another window works on this already, or it was discarded: look for it there.</source>
        <translation>Een ander venster werkt hier al aan, of het is verworpen: zoek het daar.</translation>
    </message>
    <message>
        <source>row %1 of the table %2</source>
        <translation>rij %1 van de tabel %2</translation>
    </message>
    <message>
        <source>a value in the table %1 is of the wrong kind</source>
        <translation>een waarde in de tabel %1 is van de verkeerde soort</translation>
    </message>
    <message>
        <source>a number in the table %1 is out of range</source>
        <translation>een getal in de tabel %1 valt buiten het bereik</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 ontbreekt</translation>
    </message>
    <message>
        <source>%1 is not as it was written</source>
        <translation>%1 is niet zoals die is geschreven</translation>
    </message>
    <message>
        <source>what was done to the parts</source>
        <translation>wat met de onderdelen is gedaan</translation>
    </message>
    <message>
        <source>%1: what was seen last cannot be shown. %2 What is whole can be rescued.</source>
        <translation>%1: wat het laatst te zien was, kan niet worden getoond. %2 Wat heel is, kan worden gered.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Hersteld</translation>
    </message>
    <message>
        <source>what entries are called</source>
        <translation>hoe regels heten</translation>
    </message>
    <message>
        <source>what entry %1 is called</source>
        <translation>hoe regel %1 heet</translation>
    </message>
    <message>
        <source>it is no sentence</source>
        <translation>het is geen zin</translation>
    </message>
    <message>
        <source>the file holds triggers, views or virtual tables, which no Knead writes: somebody else put them there. Nothing of it was opened.</source>
        <translation>het bestand bevat triggers, views of virtuele tabellen, die geen enkele Knead schrijft: iemand anders heeft ze erin gezet. Er is niets van geopend.</translation>
    </message>
    <message>
        <source>how the parts of start state %1 were deformed</source>
        <translation>hoe de onderdelen van begintoestand %1 zijn vervormd</translation>
    </message>
    <message>
        <source>Nothing was opened; the file is damaged or far too large.</source>
        <translation>Er is niets geopend; het bestand is beschadigd of veel te groot.</translation>
    </message>
    <message>
        <source>Nothing was opened; open a copy of the project, or the part that it was made from.</source>
        <translation>Er is niets geopend; open een kopie van het project, of het onderdeel waaruit het is gemaakt.</translation>
    </message>
    <message>
        <source>the project asks for more memory than there is.</source>
        <translation>het project vraagt meer geheugen dan er is.</translation>
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
        <source>Save the work on &quot;%1&quot; as a project?</source>
        <translation>Het werk aan &quot;%1&quot; als project opslaan?</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>De wijzigingen aan &quot;%1&quot; opslaan?</translation>
    </message>
    <message>
        <source>It has never been saved.</source>
        <translation>Het is nog nooit opgeslagen.</translation>
    </message>
    <message>
        <source>What was done since it was saved is lost otherwise.</source>
        <translation>Wat sinds het opslaan gedaan is, gaat anders verloren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Opslaan</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerpen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuleren</translation>
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
        <source>Open &amp;recent</source>
        <translation>&amp;Recent geopend</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>Voor&amp;beelden</translation>
    </message>
    <message>
        <source>Closed %1.</source>
        <translation>%1 gesloten.</translation>
    </message>
</context>
<context>
    <name>PropertyPages</name>
    <message>
        <source>Nothing selected.</source>
        <translation>Niets gekozen.</translation>
    </message>
</context>
<context>
    <name>Python</name>
    <message>
        <source>There is no material &quot;%1&quot;; knead.Material.presets() lists their names.</source>
        <translation>Er is geen materiaal &quot;%1&quot;; knead.Material.presets() noemt de namen.</translation>
    </message>
    <message>
        <source>%1 has no parts.</source>
        <translation>%1 heeft geen onderdelen.</translation>
    </message>
    <message>
        <source>This tool is no longer in the simulation.</source>
        <translation>Dit gereedschap is niet meer in de simulatie.</translation>
    </message>
    <message>
        <source>This simulation is in the midst of computing; ask for it when that is done.</source>
        <translation>Deze simulatie is aan het rekenen; vraag haar als dat klaar is.</translation>
    </message>
    <message>
        <source>A simulation needs a body; make one of a part with knead.fill().</source>
        <translation>Een simulatie heeft een lichaam nodig; maak er een van een onderdeel met knead.fill().</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3.</source>
        <translation>&quot;%1&quot; heeft geen vlak %2; het heeft er %3.</translation>
    </message>
    <message>
        <source>The fixture of &quot;%1&quot; holds nothing: no object lies there.</source>
        <translation>De bevestiging van &quot;%1&quot; houdt niets vast: daar ligt geen object.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no object %2; it has %3.</source>
        <translation>&quot;%1&quot; heeft geen object %2; het heeft er %3.</translation>
    </message>
    <message>
        <source>Step %1 cannot be gone on to: the simulation is at step %2.</source>
        <translation>Er kan niet naar stap %1 worden doorgegaan: de simulatie is bij stap %2.</translation>
    </message>
    <message>
        <source>A rotation is a quaternion (w, x, y, z) of length 1; knead.rotation(axis, angle) makes one.</source>
        <translation>Een draaiing is een quaternion (w, x, y, z) met lengte 1; knead.rotation(axis, angle) maakt er een.</translation>
    </message>
    <message>
        <source>A key frame is (time, position) or (time, position, rotation).</source>
        <translation>Een sleutelbeeld is (time, position) of (time, position, rotation).</translation>
    </message>
    <message>
        <source>There is no tool &quot;%1&quot;; there are box, ball, cylinder, wedge and plate.</source>
        <translation>Er is geen gereedschap &quot;%1&quot;; er zijn box, ball, cylinder, wedge en plate.</translation>
    </message>
    <message>
        <source>The size of a tool is the diameter of a ball, (diameter, length) of a cylinder, and three lengths of all others, in metres.</source>
        <translation>De grootte van een gereedschap is de diameter van een kogel, (diameter, lengte) van een cilinder en drie lengten van alle andere, in meters.</translation>
    </message>
    <message>
        <source>There is no choice &quot;%1&quot; here; there are: %2.</source>
        <translation>Er is hier geen keuze &quot;%1&quot;; er zijn: %2.</translation>
    </message>
    <message>
        <source>This moment is of another simulation; go to one that this one has kept.</source>
        <translation>Dit moment is van een andere simulatie; ga naar een moment dat deze heeft bewaard.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1x real time</source>
        <translation>%1x ware tijd</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>&quot;%1&quot; is not a number here; the value is still %2. Esc restores it.</source>
        <translation>&quot;%1&quot; is hier geen getal; de waarde is nog %2. Esc herstelt die.</translation>
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
    <name>ReadProject</name>
    <message>
        <source>%1 was written after this work was cut off, and stays as it is: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 is geschreven nadat dit werk werd afgebroken, en blijft zoals het is: bewaar het werk onder een eigen naam, of in plaats van dat bestand.</translation>
    </message>
    <message>
        <source>%1 stays as it is, since the recovered work is not whole: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 blijft zoals het is, want het herstelde werk is niet heel: bewaar het werk onder een eigen naam, of in plaats van dat bestand.</translation>
    </message>
    <message>
        <source>The parts of this project are lost, so that nothing of it can be shown. Open the part that it was made from.</source>
        <translation>De onderdelen van dit project zijn verloren, zodat er niets van kan worden getoond. Open het onderdeel waarvan het is gemaakt.</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>de sonde &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it was filled anew with %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 noemt objecten van een lichaam dat opnieuw met %2 is gevuld, en hier is het opnieuw met %3 gevuld. Noem liever een blok, of behoud de afstand en wat ervoor wordt gedaan.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it is filled with the first %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 noemt objecten van een lichaam dat opnieuw met %2 is gevuld, en hier is het met de eerste %3 gevuld. Noem liever een blok, of behoud de afstand en wat ervoor wordt gedaan.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not closed and is left out.</source>
        <translation>&quot;%1&quot; is niet gesloten en wordt weggelaten.</translation>
    </message>
    <message>
        <source>%1 has no tool part %2; it has %3 of them, counted from 0.</source>
        <translation>%1 heeft geen gereedschapsonderdeel %2; het heeft er %3, geteld vanaf 0.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>het project heeft geen onderdelen.</translation>
    </message>
    <message>
        <source>%1 names faces, but &quot;%2&quot; is a mesh without CAD faces; use box_mm.</source>
        <translation>%1 noemt vlakken, maar &quot;%2&quot; is een net zonder CAD-vlakken; gebruik box_mm.</translation>
    </message>
    <message>
        <source>%1 names the face %2, but &quot;%3&quot; has faces 0 to %4.</source>
        <translation>%1 noemt vlak %2, maar &quot;%3&quot; heeft de vlakken 0 tot en met %4.</translation>
    </message>
    <message>
        <source>%1 names faces of one body among several; add the key body.</source>
        <translation>%1 noemt vlakken van één lichaam van meerdere; voeg de sleutel body toe.</translation>
    </message>
    <message>
        <source>%1 holds nothing: no object lies there.</source>
        <translation>%1 houdt niets vast: daar ligt geen object.</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>het gebied &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 names the body &quot;%2&quot;; the part has: %3.</source>
        <translation>%1 noemt het lichaam &quot;%2&quot;; het onderdeel heeft: %3.</translation>
    </message>
    <message>
        <source>%1 names objects of one body among several; add the key body.</source>
        <translation>%1 noemt objecten van één lichaam van meerdere; voeg de sleutel body toe.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that is filled with %2, and here it is filled with %3. Name a box instead, or keep the spacing.</source>
        <translation>%1 noemt objecten van een lichaam dat met %2 is gevuld, en hier is het met %3 gevuld. Noem liever een blok, of behoud de afstand.</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>de inklemming &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>de belasting &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 is on one body among several; add the key body.</source>
        <translation>%1 werkt op één lichaam van meerdere; voeg de sleutel body toe.</translation>
    </message>
    <message>
        <source>%1 acts on nothing: no surface lies there.</source>
        <translation>%1 werkt op niets: daar ligt geen oppervlak.</translation>
    </message>
    <message>
        <source>This recipe asks for balance without inertia, which &quot;knead run&quot; finds. Play carries it out as motion in time.</source>
        <translation>Dit recept vraagt een evenwicht zonder traagheid, dat &quot;knead run&quot; vindt. Afspelen voert het uit als beweging in de tijd.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>het bestand</translation>
    </message>
    <message>
        <source>%1, line %2: %3 %4</source>
        <translation>%1, regel %2: %3 %4</translation>
    </message>
    <message>
        <source>%1, got %2.</source>
        <translation>%1; er staat %2.</translation>
    </message>
    <message>
        <source>must be an object in { }</source>
        <translation>moet een object in { } zijn</translation>
    </message>
    <message>
        <source>must have the key &quot;%1&quot;.</source>
        <translation>moet de sleutel &quot;%1&quot; hebben.</translation>
    </message>
    <message>
        <source>is not a known key; allowed here: %1.</source>
        <translation>is geen bekende sleutel; hier toegestaan: %1.</translation>
    </message>
    <message>
        <source>must be a list in [ ]</source>
        <translation>moet een lijst in [ ] zijn</translation>
    </message>
    <message>
        <source>must be a text in quotes that is not empty</source>
        <translation>moet een niet-lege tekst tussen aanhalingstekens zijn</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>moet een tekst tussen aanhalingstekens zijn</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>moet true of false zijn</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>moet een getal zijn</translation>
    </message>
    <message>
        <source>must be a number between %1 and %2</source>
        <translation>moet een getal tussen %1 en %2 zijn</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>moet een positief getal zijn</translation>
    </message>
    <message>
        <source>must be a whole number between %1 and %2</source>
        <translation>moet een geheel getal tussen %1 en %2 zijn</translation>
    </message>
    <message>
        <source>must be a whole number between 0 and %1</source>
        <translation>moet een geheel getal tussen 0 en %1 zijn</translation>
    </message>
    <message>
        <source>must hold %1 numbers</source>
        <translation>moet %1 getallen bevatten</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>regel %1, kolom %2</translation>
    </message>
    <message>
        <source>%1: the key &quot;%2&quot; is given twice in the same object.</source>
        <translation>%1: de sleutel &quot;%2&quot; staat twee keer in hetzelfde object.</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1: lijsten en objecten zijn meer dan %2 diep genest.</translation>
    </message>
    <message>
        <source>is used twice: &quot;%1&quot;.</source>
        <translation>is twee keer gebruikt: &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>must hold the first and the last number of a stretch</source>
        <translation>moet het eerste en het laatste nummer van een reeks bevatten</translation>
    </message>
    <message>
        <source>makes a list longer than any that this program writes</source>
        <translation>geeft een langere lijst dan dit programma ooit schrijft</translation>
    </message>
    <message>
        <source>must be the number of a tool part of the project</source>
        <translation>moet het nummer van een gereedschapsonderdeel van het project zijn</translation>
    </message>
    <message>
        <source>must be one of those that this program knows</source>
        <translation>moet een van degene zijn die dit programma kent</translation>
    </message>
    <message>
        <source>must be the number of a part</source>
        <translation>moet het nummer van een onderdeel zijn</translation>
    </message>
    <message>
        <source>must have only one of the keys box_mm and objects.</source>
        <translation>mag maar een van de sleutels box_mm en objects hebben.</translation>
    </message>
    <message>
        <source>must have at least one of the keys velocity_mm_s and turn.</source>
        <translation>moet minstens een van de sleutels velocity_mm_s en turn hebben.</translation>
    </message>
    <message>
        <source>must not be 0: it says which way the plane faces.</source>
        <translation>mag niet 0 zijn: het zegt waar het vlak heen wijst.</translation>
    </message>
    <message>
        <source>must be true.</source>
        <translation>moet true zijn.</translation>
    </message>
    <message>
        <source>must have only one of the keys %1 and %2.</source>
        <translation>mag maar een van de sleutels %1 en %2 hebben.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys %1.</source>
        <translation>moet precies een van de sleutels %1 hebben.</translation>
    </message>
    <message>
        <source>must have either time_s or step.</source>
        <translation>moet time_s of step hebben.</translation>
    </message>
    <message>
        <source>needs an event with a step; say keyframes for times.</source>
        <translation>heeft een gebeurtenis met een stap (step) nodig; gebruik keyframes voor tijden.</translation>
    </message>
    <message>
        <source>must have only one of the keys path and %1.</source>
        <translation>mag maar een van de sleutels path en %1 hebben.</translation>
    </message>
    <message>
        <source>belongs to a change of material only.</source>
        <translation>hoort alleen bij een wijziging van materiaal.</translation>
    </message>
    <message>
        <source>must be one of %1 or a direction of 3 numbers</source>
        <translation>moet een van %1 zijn, of een richting van 3 getallen</translation>
    </message>
    <message>
        <source>must be a direction of 3 numbers that are not all 0</source>
        <translation>moet een richting van 3 getallen zijn die niet alle 0 zijn</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>moet een van %1 zijn</translation>
    </message>
    <message>
        <source>must be a path inside the output folder</source>
        <translation>moet een pad binnen de uitvoermap zijn</translation>
    </message>
    <message>
        <source>must end in one of %1</source>
        <translation>moet eindigen op een van %1</translation>
    </message>
    <message>
        <source>must have either axis and speed_deg_s, or angular_velocity_rad_s.</source>
        <translation>moet axis en speed_deg_s hebben, of angular_velocity_rad_s.</translation>
    </message>
    <message>
        <source>must have only one of the keys angle_deg and angle_rad.</source>
        <translation>mag maar een van de sleutels angle_deg en angle_rad hebben.</translation>
    </message>
    <message>
        <source>belongs to manipulators of the kind part only.</source>
        <translation>hoort alleen bij gereedschappen van de soort part.</translation>
    </message>
    <message>
        <source>does not belong to the kind part; its file says how large it is.</source>
        <translation>hoort niet bij de soort part; het bestand ervan zegt hoe groot het is.</translation>
    </message>
    <message>
        <source>must be later than the frame before it</source>
        <translation>moet later zijn dan het beeld ervoor</translation>
    </message>
    <message>
        <source>asks for a speed of %1 mm/s; speed_limit_mm_s allows %2.</source>
        <translation>vraagt een snelheid van %1 mm/s; speed_limit_mm_s staat %2 toe.</translation>
    </message>
    <message>
        <source>must be false where the tool is neither a ball nor a cylinder</source>
        <translation>moet false zijn waar het gereedschap bol noch cilinder is</translation>
    </message>
    <message>
        <source>must have only one of the keys keyframes and motion.</source>
        <translation>mag maar een van de sleutels keyframes en motion hebben.</translation>
    </message>
    <message>
        <source>must hold at least one frame.</source>
        <translation>moet minstens één beeld bevatten.</translation>
    </message>
    <message>
        <source>belongs to velocity_mm_s.</source>
        <translation>hoort bij velocity_mm_s.</translation>
    </message>
    <message>
        <source>must be true; leave it out to say another motion.</source>
        <translation>moet true zijn; laat het weg om een andere beweging op te geven.</translation>
    </message>
    <message>
        <source>must hold a step and x, y, z, perhaps with w, x, y, z of a rotation</source>
        <translation>moet een stap en x, y, z bevatten, eventueel met w, x, y, z van een draaiing</translation>
    </message>
    <message>
        <source>must not be less than in the row before it</source>
        <translation>mag niet kleiner zijn dan in de rij ervoor</translation>
    </message>
    <message>
        <source>lies further than a kilometer away.</source>
        <translation>ligt verder dan een kilometer weg.</translation>
    </message>
    <message>
        <source>must end with a quaternion of length 1</source>
        <translation>moet eindigen met een quaternion van lengte 1</translation>
    </message>
    <message>
        <source>must hold at least one row.</source>
        <translation>moet minstens één rij bevatten.</translation>
    </message>
    <message>
        <source>the project has no bodies.</source>
        <translation>het project heeft geen lichamen.</translation>
    </message>
    <message>
        <source>some of its parts could not be filled with objects, which a recipe takes for an error.</source>
        <translation>sommige onderdelen konden niet met objecten worden gevuld, wat een recept voor een fout houdt.</translation>
    </message>
    <message>
        <source>its bodies differ in their spacing or structural friction.</source>
        <translation>de lichamen ervan verschillen in afstand of structurele wrijving.</translation>
    </message>
    <message>
        <source>the files of its parts are not there any more; save the project first.</source>
        <translation>de bestanden van de onderdelen zijn er niet meer; sla eerst het project op.</translation>
    </message>
    <message>
        <source>The files that the parts were read from are not there any more: the recipe takes the parts from the project.</source>
        <translation>De bestanden waaruit de onderdelen zijn gelezen, zijn er niet meer: het recept neemt de onderdelen uit het project.</translation>
    </message>
    <message>
        <source>The recipe begins where the part was filled last; what was done before left nothing behind but tools, materials and fixtures.</source>
        <translation>Het recept begint waar het onderdeel het laatst is gevuld; wat daarvoor is gedaan, liet alleen gereedschappen, materialen en inklemmingen achter.</translation>
    </message>
    <message>
        <source>The project has nothing in it yet that a recipe could say.</source>
        <translation>Er is nog niets in het project wat een recept zou kunnen zeggen.</translation>
    </message>
    <message>
        <source>A recipe cannot say what was done here: %1</source>
        <translation>Een recept kan niet zeggen wat hier is gedaan: %1</translation>
    </message>
    <message>
        <source>%1 is %2, which has nothing in it to set.</source>
        <translation>%1 is %2, waarin niets te zetten is.</translation>
    </message>
    <message>
        <source>%1 has no item &quot;%2&quot;; allowed here: %3.</source>
        <translation>%1 heeft geen item &quot;%2&quot;; hier toegestaan: %3.</translation>
    </message>
    <message>
        <source>a whole list, since this one is empty</source>
        <translation>een hele lijst, omdat deze leeg is</translation>
    </message>
    <message>
        <source>the number 0</source>
        <translation>het nummer 0</translation>
    </message>
    <message>
        <source>the numbers 0 to %1</source>
        <translation>de nummers 0 tot en met %1</translation>
    </message>
    <message>
        <source>%1 and the names %2</source>
        <translation>%1 en de namen %2</translation>
    </message>
    <message>
        <source>the path has an empty step; between two dots there must be a key, a name or a number.</source>
        <translation>het pad heeft een lege stap; tussen twee punten moet een sleutel, een naam of een nummer staan.</translation>
    </message>
    <message>
        <source>the path ends with a dot; name what is to be set after it.</source>
        <translation>het pad eindigt met een punt; noem daarna wat moet worden gezet.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be set: %3</source>
        <translation>%1: %2 kan niet worden gezet: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sets nothing; write PATH=VALUE, for example spacing_mm=3.</source>
        <translation>&quot;%1&quot; zet niets; schrijf PAD=WAARDE, bijvoorbeeld spacing_mm=3.</translation>
    </message>
    <message>
        <source>must have either file or files.</source>
        <translation>moet file of files hebben.</translation>
    </message>
    <message>
        <source>must hold at least one file.</source>
        <translation>moet minstens één bestand bevatten.</translation>
    </message>
    <message>
        <source>a fixture holds no object of its body.</source>
        <translation>een inklemming houdt geen object van haar lichaam vast.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects.</source>
        <translation>moet precies een van de sleutels spacing_mm, cells_across, cells_across_wall en objects hebben.</translation>
    </message>
    <message>
        <source>belongs to events: at the start nothing has been filled anew.</source>
        <translation>hoort bij gebeurtenissen: aan het begin is er niets opnieuw gevuld.</translation>
    </message>
    <message>
        <source>is written twice: &quot;%1&quot;.</source>
        <translation>wordt twee keer geschreven: &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>is &quot;published&quot;, which needs spacing_mm.</source>
        <translation>is &quot;published&quot;, wat spacing_mm nodig heeft.</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is not in the recipe.</source>
        <translation>noemt &quot;%1&quot;, dat niet in het recept staat.</translation>
    </message>
    <message>
        <source>must not be earlier than that of the event before it</source>
        <translation>mag niet eerder zijn dan bij de gebeurtenis ervoor</translation>
    </message>
    <message>
        <source>must not be less than that of the event before it</source>
        <translation>mag niet kleiner zijn dan bij de gebeurtenis ervoor</translation>
    </message>
    <message>
        <source>must have only one of the keys duration_s and duration_steps.</source>
        <translation>mag maar een van de sleutels duration_s en duration_steps hebben.</translation>
    </message>
    <message>
        <source>must be at most 3600 s</source>
        <translation>mag ten hoogste 3600 s zijn</translation>
    </message>
    <message>
        <source>belongs to a dynamic analysis only.</source>
        <translation>hoort alleen bij een dynamische analyse.</translation>
    </message>
    <message>
        <source>belongs to a static analysis only.</source>
        <translation>hoort alleen bij een statische analyse.</translation>
    </message>
    <message>
        <source>names the unknown material &quot;%1&quot;; known are: %2.</source>
        <translation>noemt het onbekende materiaal &quot;%1&quot;; bekend zijn: %2.</translation>
    </message>
    <message>
        <source>must hold at least one face.</source>
        <translation>moet minstens één vlak bevatten.</translation>
    </message>
    <message>
        <source>must be the name of a material or an object in { }</source>
        <translation>moet de naam van een materiaal of een object in { } zijn</translation>
    </message>
    <message>
        <source>must have both of the keys objects and objects_in_body, or none.</source>
        <translation>moet beide sleutels objects en objects_in_body hebben, of geen.</translation>
    </message>
    <message>
        <source>belongs to objects.</source>
        <translation>hoort bij objects.</translation>
    </message>
    <message>
        <source>must go on upwards, below objects_in_body</source>
        <translation>moet verder oplopen, onder objects_in_body</translation>
    </message>
    <message>
        <source>must hold at least one object.</source>
        <translation>moet minstens één object bevatten.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys faces, box_mm and objects.</source>
        <translation>moet precies een van de sleutels faces, box_mm en objects hebben.</translation>
    </message>
    <message>
        <source>must have only one of the keys angular_velocity_deg_s and angular_velocity_rad_s.</source>
        <translation>mag maar een van de sleutels angular_velocity_deg_s en angular_velocity_rad_s hebben.</translation>
    </message>
    <message>
        <source>must hold 3 numbers no larger than %1</source>
        <translation>moet 3 getallen niet groter dan %1 bevatten</translation>
    </message>
    <message>
        <source>must hold the lowest x, y, z and then the highest x, y, z</source>
        <translation>moet de laagste x, y, z en dan de hoogste x, y, z bevatten</translation>
    </message>
    <message>
        <source>must hold w, x, y, z of a quaternion of length 1</source>
        <translation>moet w, x, y, z van een quaternion van lengte 1 bevatten</translation>
    </message>
    <message>
        <source>must have only one of the keys rotation_deg and rotation_wxyz.</source>
        <translation>mag maar een van de sleutels rotation_deg en rotation_wxyz hebben.</translation>
    </message>
    <message>
        <source>must hold %1 positive numbers</source>
        <translation>moet %1 positieve getallen bevatten</translation>
    </message>
    <message>
        <source>names a file that does not exist: %1. The path is taken from the folder of the recipe.</source>
        <translation>noemt een bestand dat niet bestaat: %1. Het pad geldt vanaf de map van het recept.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot; is an imported part, which only a saved project keeps.</source>
        <translation>het gereedschap &quot;%1&quot; is een geïmporteerd onderdeel, dat alleen een opgeslagen project bewaart.</translation>
    </message>
    <message>
        <source>The output folder %1 cannot be made; choose another one with --out.</source>
        <translation>De uitvoermap %1 kan niet worden gemaakt; kies een andere met --out.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; its place is in mm.</source>
        <translation>%1 ligt ver van alle lichamen; de plaats is in mm.</translation>
    </message>
    <message>
        <source>it has no probes whose readings could be written; add the key probes.</source>
        <translation>het heeft geen sondes waarvan waarden geschreven kunnen worden; voeg de sleutel probes toe.</translation>
    </message>
    <message>
        <source>The probes of this recipe are read by &quot;knead run&quot;. Put probes on the part to read them here.</source>
        <translation>De sondes van dit recept worden door &quot;knead run&quot; gelezen. Zet sondes op het onderdeel om ze hier te lezen.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; names the body &quot;%1&quot;, which the part does not have.</source>
        <translation>&quot;deform&quot; noemt het lichaam &quot;%1&quot;, dat het onderdeel niet heeft.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces; name the body that they are of.</source>
        <translation>&quot;deform&quot; laat vlakken op hun plaats; noem het lichaam waar ze bij horen.</translation>
    </message>
    <message>
        <source>Fields in files cannot be read here; deform by numbers, or use &quot;knead morph&quot;.</source>
        <translation>Velden in bestanden kunnen hier niet worden gelezen; vervorm met getallen, of gebruik &quot;knead morph&quot;.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not come out sound when it was deformed; look at it closely.</source>
        <translation>&quot;%1&quot; kwam niet gaaf uit de vervorming; bekijk het goed.</translation>
    </message>
    <message>
        <source>does not belong to the kind %1.</source>
        <translation>hoort niet bij de soort %1.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg, angle_rad and radius_mm.</source>
        <translation>moet precies één van de sleutels angle_deg, angle_rad en radius_mm hebben.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg and angle_rad.</source>
        <translation>moet precies één van de sleutels angle_deg en angle_rad hebben.</translation>
    </message>
    <message>
        <source>must point across the axis.</source>
        <translation>moet dwars op de as wijzen.</translation>
    </message>
    <message>
        <source>must be larger than from_mm.</source>
        <translation>moet groter zijn dan from_mm.</translation>
    </message>
    <message>
        <source>cannot be: %1</source>
        <translation>kan niet: %1</translation>
    </message>
    <message>
        <source>must have both of the keys kept_faces and fade_mm, or none.</source>
        <translation>moet beide sleutels kept_faces en fade_mm hebben, of geen van beide.</translation>
    </message>
    <message>
        <source>parts beside the first that were placed cannot be written.</source>
        <translation>onderdelen die naast het eerste zijn geplaatst kunnen niet worden geschreven.</translation>
    </message>
    <message>
        <source>pictures to write cannot be written into a recipe.</source>
        <translation>te schrijven afbeeldingen kunnen niet in een recept worden gezet.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps face %1 of &quot;%2&quot;, which has %3; they are numbered from 0.</source>
        <translation>„deform” houdt vlak %1 van „%2” vast, dat er %3 heeft; ze zijn vanaf 0 genummerd.</translation>
    </message>
    <message>
        <source>is so small that the bend goes around more than ten times; take a larger one.</source>
        <translation>is zo klein dat de buiging meer dan tien keer rondgaat; neem een grotere.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces of the body &quot;%1&quot;, which it does not deform.</source>
        <translation>‘deform’ houdt vlakken van het lichaam ‘%1’ op hun plaats, dat het niet vervormt.</translation>
    </message>
    <message>
        <source>must have one of the keys neutral_mm and k_factor, or none.</source>
        <translation>moet een van de sleutels neutral_mm en k_factor hebben, of geen.</translation>
    </message>
    <message>
        <source>must name at least one body.</source>
        <translation>moet minstens één lichaam noemen.</translation>
    </message>
    <message>
        <source>must have one item for each object</source>
        <translation>moet voor elk object één onderdeel hebben</translation>
    </message>
    <message>
        <source>cannot be done by physics, since grips do not change the ends; say it in &quot;deform&quot;.</source>
        <translation>kan niet door fysica, omdat grepen de uiteinden niet veranderen; zeg het in &quot;deform&quot;.</translation>
    </message>
    <message>
        <source>its parts were deformed after they were kneaded, or by a field whose file is not there any more, or others were added, and only a project keeps them so; save the project first.</source>
        <translation>zijn onderdelen zijn vervormd nadat ze gekneed zijn, of door een veld waarvan het bestand er niet meer is, of er kwamen andere bij, en alleen een project bewaart ze zo; sla eerst het project op.</translation>
    </message>
    <message>
        <source>The parts were deformed by numbers or by a field, or others were added: the recipe takes them from the project, as they were then.</source>
        <translation>De onderdelen zijn vervormd door getallen of door een veld, of er kwamen andere bij: het recept neemt ze uit het project, zoals ze toen waren.</translation>
    </message>
</context>
<context>
    <name>RecipesFeature</name>
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Een recept wordt alleen geopend: kies één bestand, of alleen onderdelen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wordt geopend</translation>
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
        <source>Exporting %1</source>
        <translation>%1 wordt geëxporteerd</translation>
    </message>
    <message>
        <source>The recipe names files to export: %1.</source>
        <translation>Het recept noemt bestanden om te exporteren: %1.</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exporteren...</translation>
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
        <source>Choose a place...</source>
        <translation>Een plaats kiezen...</translation>
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
    <message>
        <source>What the active view shows: %1</source>
        <translation>Wat het actieve aanzicht toont: %1</translation>
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
    <name>RecordingFeature</name>
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
        <source>Discard the unsaved work on &quot;%1&quot;? It cannot be brought back.</source>
        <translation>Het niet-opgeslagen werk aan &quot;%1&quot; weggooien? Het kan niet worden teruggehaald.</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>1 part, %2</source>
        <translation>1 onderdeel, %2</translation>
    </message>
    <message>
        <source>%1 parts, %2</source>
        <translation>%1 onderdelen, %2</translation>
    </message>
    <message>
        <source>1 face, %2</source>
        <translation>1 vlak, %2</translation>
    </message>
    <message>
        <source>%1 faces, %2</source>
        <translation>%1 vlakken, %2</translation>
    </message>
    <message>
        <source>1 edge, %2</source>
        <translation>1 rand, %2</translation>
    </message>
    <message>
        <source>%1 edges, %2</source>
        <translation>%1 randen, %2</translation>
    </message>
    <message>
        <source>1 object, %2</source>
        <translation>1 object, %2</translation>
    </message>
    <message>
        <source>%1 objects, %2</source>
        <translation>%1 objecten, %2</translation>
    </message>
    <message>
        <source>1 connection, %2</source>
        <translation>1 verbinding, %2</translation>
    </message>
    <message>
        <source>%1 connections, %2</source>
        <translation>%1 verbindingen, %2</translation>
    </message>
    <message>
        <source>Face &quot;%1&quot;, %2</source>
        <translation>Vlak &quot;%1&quot;, %2</translation>
    </message>
</context>
<context>
    <name>Repair</name>
    <message>
        <source>The exact shapes of the parts cannot be understood; import the file again.</source>
        <translation>De exacte vormen van de onderdelen zijn niet te begrijpen; importeer het bestand opnieuw.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1.</source>
        <translation>1 los vlak is met een tolerantie van %1 genaaid.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2.</source>
        <translation>%1 losse vlakken zijn met een tolerantie van %2 genaaid.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1; the widest gap between two of them is %2.</source>
        <translation>1 los vlak is met een tolerantie van %1 genaaid; de breedste spleet tussen twee ervan is %2.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2; the widest gap between two of them is %3.</source>
        <translation>%1 losse vlakken zijn met een tolerantie van %2 genaaid; de breedste spleet tussen twee ervan is %3.</translation>
    </message>
    <message>
        <source>1 flat opening was closed with a plane face, %1 % of the area.</source>
        <translation>1 vlakke opening is met een plat vlak gesloten, %1 % van het oppervlak.</translation>
    </message>
    <message>
        <source>%1 flat openings were closed with plane faces, %2 % of the area.</source>
        <translation>%1 vlakke openingen zijn met platte vlakken gesloten, %2 % van het oppervlak.</translation>
    </message>
    <message>
        <source>Edges that failed the geometry checks were rebuilt.</source>
        <translation>Randen die de controles van de geometrie niet doorstonden zijn opnieuw gemaakt.</translation>
    </message>
    <message>
        <source>1 face that failed the geometry checks was rebuilt.</source>
        <translation>1 vlak dat de controles van de geometrie niet doorstond is opnieuw gemaakt.</translation>
    </message>
    <message>
        <source>%1 faces that failed the geometry checks were rebuilt.</source>
        <translation>%1 vlakken die de controles van de geometrie niet doorstonden zijn opnieuw gemaakt.</translation>
    </message>
    <message>
        <source>1 shell was inside out and turned.</source>
        <translation>1 schaal was binnenstebuiten en is gekeerd.</translation>
    </message>
    <message>
        <source>%1 shells were inside out and turned.</source>
        <translation>%1 schalen waren binnenstebuiten en zijn gekeerd.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid.</source>
        <translation>Het gesloten oppervlak is een lichaam geworden.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with 1 void in it.</source>
        <translation>Het gesloten oppervlak is een lichaam geworden, met 1 holte erin.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with %1 voids in it.</source>
        <translation>Het gesloten oppervlak is een lichaam geworden, met %1 holten erin.</translation>
    </message>
    <message>
        <source>1 triangle was there twice and removed.</source>
        <translation>1 driehoek was er dubbel en is verwijderd.</translation>
    </message>
    <message>
        <source>%1 triangles were there twice and removed.</source>
        <translation>%1 driehoeken waren er dubbel en zijn verwijderd.</translation>
    </message>
    <message>
        <source>The surface was given with both its sides; one of them was removed.</source>
        <translation>Het oppervlak was met beide zijden gegeven; een ervan is verwijderd.</translation>
    </message>
    <message>
        <source>1 pair of triangles back to back was removed.</source>
        <translation>1 paar driehoeken rug aan rug is verwijderd.</translation>
    </message>
    <message>
        <source>%1 pairs of triangles back to back were removed.</source>
        <translation>%1 paren driehoeken rug aan rug zijn verwijderd.</translation>
    </message>
    <message>
        <source>1 triangle faced the wrong way and was turned.</source>
        <translation>1 driehoek lag verkeerd om en is gekeerd.</translation>
    </message>
    <message>
        <source>%1 triangles faced the wrong way and were turned.</source>
        <translation>%1 driehoeken lagen verkeerd om en zijn gekeerd.</translation>
    </message>
    <message>
        <source>1 small hole was closed, which added %1 to the area.</source>
        <translation>1 klein gat is gesloten, wat %1 aan het oppervlak toevoegde.</translation>
    </message>
    <message>
        <source>%1 small holes were closed, which added %2 to the area.</source>
        <translation>%1 kleine gaten zijn gesloten, wat %2 aan het oppervlak toevoegde.</translation>
    </message>
    <message>
        <source>The surface was inside out and has been turned.</source>
        <translation>Het oppervlak was binnenstebuiten en is gekeerd.</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 open rand</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1 open randen</translation>
    </message>
    <message>
        <source>1 border</source>
        <translation>1 omtrek</translation>
    </message>
    <message>
        <source>%1 borders</source>
        <translation>%1 omtrekken</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across and flat</source>
        <translation>%1 in %2, samen %3 lang; de grootste opening is %4 breed en vlak</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across</source>
        <translation>%1 in %2, samen %3 lang; de grootste opening is %4 breed</translation>
    </message>
</context>
<context>
    <name>Run</name>
    <message>
        <source>The equations of %1 of %2 steps could not be solved: forces and places are not to be trusted there. Make tools slower, or choose a shorter time step.</source>
        <translation>De vergelijkingen van %1 van de %2 stappen waren niet op te lossen: krachten en posities zijn daar niet te vertrouwen. Maak gereedschappen langzamer, of kies een kortere tijdstap.</translation>
    </message>
    <message>
        <source>Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools slower.</source>
        <translation>De energie klopt niet: %1 % van alles wat rondging. Kies een kortere tijdstap, of maak gereedschap langzamer.</translation>
    </message>
    <message>
        <source>Tools or the floor went %1 spacings into material: shapes and forces there are rough. Press less far, or choose a smaller spacing.</source>
        <translation>Gereedschap of de vloer drong %1 afstanden in materiaal: vormen en krachten zijn daar ruw. Druk minder ver, of kies een kleinere afstand.</translation>
    </message>
    <message>
        <source>Mass scaling made %1 % of the mass: what swings and what is thrown is slower than it would be. Choose a shorter time step for it.</source>
        <translation>Massaschaling maakte %1 % van de massa: wat slingert en wat geworpen wordt is langzamer dan het zou zijn. Kies er een kortere tijdstap voor.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; broke into %2 pieces, and a rigid body would weld them together where they are. Keep it deformable, or reset before it becomes rigid.</source>
        <translation>&quot;%1&quot; is in %2 stukken gebroken, en een star lichaam zou ze vastlassen waar ze zijn. Houd het vervormbaar, of zet terug voordat het star wordt.</translation>
    </message>
    <message>
        <source>The simulation was stopped at %1 s: %2 It went back to %3 s.</source>
        <translation>De simulatie is bij %1 s gestopt: %2 Ze ging terug naar %3 s.</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>het lichaam</translation>
    </message>
    <message>
        <source>material of %1 was squashed flat or turned inside out. Press less far, raise Poisson&apos;s ratio or the yield stress, or fill the part with a smaller spacing, then reset.</source>
        <translation>materiaal van %1 is platgedrukt of binnenstebuiten gekeerd. Minder ver drukken, de dwarscontractiecoëfficiënt of de vloeigrens verhogen, of het onderdeel met een kleinere afstand vullen, dan terugzetten.</translation>
    </message>
    <message>
        <source>a position is no longer a number. %1 or make the material softer, then reset.</source>
        <translation>een positie is geen getal meer. %1 of het materiaal zachter maken, dan terugzetten.</translation>
    </message>
    <message>
        <source>the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, or a softer or more damped material.</source>
        <translation>de gekozen tijdstap van %1 s is langer dan de stabiele van %2 s. Kies een kortere, of een zachter of sterker gedempt materiaal.</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Impliciete Euler</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Voorwaartse Euler</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-impliciete Euler</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1: gekozen; expliciete integratie vraagt %2 stappen per seconde, wat realtime bijhoudt.</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1: gekozen; expliciete integratie vraagt %2 stappen per seconde, meer dan realtime toelaat.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1: expliciete integratie vraagt %2 stappen per seconde, wat realtime bijhoudt.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1: expliciete integratie vraagt %2 stappen per seconde, meer dan realtime toelaat.</translation>
    </message>
    <message>
        <source>The equations of the step at %1 s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter time step.</source>
        <translation>De vergelijkingen van de stap bij %1 s waren niet op te lossen: krachten en posities zijn vanaf daar ruw. Maak gereedschappen langzamer, of kies een kortere tijdstap.</translation>
    </message>
    <message>
        <source>there is not enough memory to go on. Close other programs or fill the part with a larger spacing, then reset.</source>
        <translation>er is niet genoeg geheugen om door te gaan. Sluit andere programma&apos;s of vul het onderdeel met een grotere afstand, dan terugzetten.</translation>
    </message>
    <message>
        <source>%1 Reset, or go to an earlier moment.</source>
        <translation>%1 Zet terug, of ga naar een eerder moment.</translation>
    </message>
    <message>
        <source>The simulation was stopped: %1</source>
        <translation>De simulatie is gestopt: %1</translation>
    </message>
    <message>
        <source>objects of %1 moved at %2 m/s, and nothing in the scene makes them faster than %3 m/s. %4 or raise the damping ratio, then reset.</source>
        <translation>objecten van %1 bewogen met %2 m/s, en niets in de scène maakt ze sneller dan %3 m/s. %4 of de dempingsgraad verhogen, dan terugzetten.</translation>
    </message>
    <message>
        <source>%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the material. %3 or raise the damping ratio, then reset.</source>
        <translation>%1 J kwamen uit het niets, van %2 J in de scène: de stappen volgen het materiaal niet meer. %3 of de dempingsgraad verhogen, dan terugzetten.</translation>
    </message>
    <message>
        <source>the equations of %1 steps in a row could not be solved, though the last was only %2 s long. %3 or raise the damping ratio, then reset.</source>
        <translation>de vergelijkingen van %1 stappen achter elkaar waren niet op te lossen, hoewel de laatste maar %2 s duurde. %3 of de dempingsgraad verhogen, dan terugzetten.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is %2 mm deep in %3: let it begin outside and press less far, make it slower</source>
        <translation>Het gereedschap &quot;%1&quot; zit %2 mm diep in %3: het erbuiten laten beginnen, minder ver drukken, het langzamer maken</translation>
    </message>
    <message>
        <source>Choose a shorter time step for mass scaling, which added %1 % to the mass</source>
        <translation>Een kortere tijdstap voor de massaschaling kiezen, die %1 % aan de massa toevoegde</translation>
    </message>
    <message>
        <source>Make the tools slower</source>
        <translation>De gereedschappen langzamer maken</translation>
    </message>
    <message>
        <source>Lower gravity</source>
        <translation>De zwaartekracht verlagen</translation>
    </message>
    <message>
        <source>Move bodies and fixtures slower</source>
        <translation>Lichamen en inklemmingen langzamer bewegen</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; begins %2 mm inside %3, which is pushed away with great force, in very short steps. Let it begin outside.</source>
        <translation>Het gereedschap &quot;%1&quot; begint %2 mm binnen in %3, dat met grote kracht en in zeer korte stappen wordt weggeduwd. Laat het erbuiten beginnen.</translation>
    </message>
</context>
<context>
    <name>RunRemarks</name>
    <message>
        <source>Time hardly goes on: %1 were simulated in %2, in steps of %3. A larger spacing, a softer material, slower tools or ones that begin outside the material make it faster.</source>
        <translation>De tijd gaat nauwelijks vooruit: %1 werd in %2 gesimuleerd, in stappen van %3. Een grotere afstand, een zachter materiaal, langzamer gereedschap of gereedschap dat buiten het materiaal begint maken het sneller.</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>Gravity must not be stronger than 10000 m/s^2.</source>
        <translation>De zwaartekracht mag niet sterker dan 10000 m/s^2 zijn.</translation>
    </message>
    <message>
        <source>The height of the floor must lie between -10 and 10 km.</source>
        <translation>De hoogte van de vloer moet tussen -10 en 10 km liggen.</translation>
    </message>
    <message>
        <source>The friction of the floor must lie between 0 and 2.</source>
        <translation>De wrijving van de vloer moet tussen 0 en 2 liggen.</translation>
    </message>
    <message>
        <source>The adhesion of the floor must lie between 0 and 1e9 Pa.</source>
        <translation>De hechting van de vloer moet tussen 0 en 1e9 Pa liggen.</translation>
    </message>
    <message>
        <source>There is no body number %1.</source>
        <translation>Er is geen lichaam nummer %1.</translation>
    </message>
    <message>
        <source>It holds no objects. Fill it with a smaller spacing.</source>
        <translation>Het bevat geen objecten. Vul het met een kleinere afstand.</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot;: %2</source>
        <translation>Gebied &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot; names an object that does not exist.</source>
        <translation>Het gebied &quot;%1&quot; noemt een object dat niet bestaat.</translation>
    </message>
    <message>
        <source>It must not start faster than 1000 m/s or 100000 rad/s.</source>
        <translation>Het mag niet sneller dan 1000 m/s of 100000 rad/s beginnen.</translation>
    </message>
    <message>
        <source>Its structural friction must lie between 0 and 2.</source>
        <translation>De inwendige wrijving moet tussen 0 en 2 liggen.</translation>
    </message>
    <message>
        <source>Body &quot;%1&quot;: %2</source>
        <translation>Lichaam &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>The time step must lie between 1e-9 and 1 s.</source>
        <translation>De tijdstap moet tussen 1e-9 en 1 s liggen.</translation>
    </message>
    <message>
        <source>The time step of mass scaling must lie between 1e-9 and 1 s.</source>
        <translation>De tijdstap van de massaschaling moet tussen 1e-9 en 1 s liggen.</translation>
    </message>
    <message>
        <source>Forward Euler is not stable without damping: raise the damping ratio, or use semi-implicit Euler.</source>
        <translation>Voorwaartse Euler is zonder demping niet stabiel: verhoog de dempingsgraad, of neem semi-impliciete Euler.</translation>
    </message>
</context>
<context>
    <name>SculptHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties, or push it with a tool.</source>
        <translation>%1 vervormt niet: maak het vervormbaar in de eigenschappen, of duw ertegen met gereedschap.</translation>
    </message>
    <message>
        <source>%1 is held at this place: free it with Fix faces, or take another place.</source>
        <translation>%1 wordt op deze plaats vastgehouden: maak het vrij met &quot;Vlakken vastzetten&quot;, of neem een andere plaats.</translation>
    </message>
    <message>
        <source>%1, force %2 %</source>
        <translation>%1, kracht %2 %</translation>
    </message>
    <message>
        <source>%1 (limit; + for more)</source>
        <translation>%1 (grens; + voor meer)</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>Trekken aan %1</translation>
    </message>
    <message>
        <source>Thumb on %1</source>
        <translation>Duim op %1</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 gladmaken</translation>
    </message>
    <message>
        <source>Flatten %1</source>
        <translation>%1 afvlakken</translation>
    </message>
    <message>
        <source>Pinch %1</source>
        <translation>%1 samenknijpen</translation>
    </message>
    <message>
        <source>Smear %1</source>
        <translation>%1 uitsmeren</translation>
    </message>
    <message>
        <source>Bend %1</source>
        <translation>%1 buigen</translation>
    </message>
    <message>
        <source>Twist %1</source>
        <translation>%1 verdraaien</translation>
    </message>
</context>
<context>
    <name>SectionKnob</name>
    <message>
        <source>Drag to move the section plane; arrow keys move it by a hundredth of the part</source>
        <translation>Sleep om het doorsnedevlak te verplaatsen; pijltoetsen verplaatsen het met een honderdste van het onderdeel</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Doorsnedevlak</translation>
    </message>
</context>
<context>
    <name>SelectionActions</name>
    <message>
        <source>Parts</source>
        <translation>Onderdelen</translation>
    </message>
    <message>
        <source>Clicks select parts</source>
        <translation>Klikken selecteert onderdelen</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Vlakken</translation>
    </message>
    <message>
        <source>Clicks select faces</source>
        <translation>Klikken selecteert vlakken</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Randen</translation>
    </message>
    <message>
        <source>Clicks select edges</source>
        <translation>Klikken selecteert randen</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objecten</translation>
    </message>
    <message>
        <source>Clicks select the objects the material is made of</source>
        <translation>Klikken selecteert de objecten waaruit het materiaal bestaat</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindingen</translation>
    </message>
    <message>
        <source>Clicks select connections between objects</source>
        <translation>Klikken selecteert verbindingen tussen objecten</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Drag a box: to the right for what lies in it, to the left also for what it touches</source>
        <translation>Een rechthoek slepen: naar rechts voor wat erin ligt, naar links ook voor wat hij raakt</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw a line around what is wanted</source>
        <translation>Een lijn trekken om wat gewenst is</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Penseel</translation>
    </message>
    <message>
        <source>Paint over what is wanted</source>
        <translation>Over het gewenste schilderen</translation>
    </message>
    <message>
        <source>Through the part</source>
        <translation>Door het onderdeel heen</translation>
    </message>
    <message>
        <source>Boxes, lassos and brushes select what is hidden behind the skin too</source>
        <translation>Rechthoek, lasso en penseel selecteren ook wat achter de huid verborgen is</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Kleiner penseel</translation>
    </message>
    <message>
        <source>A smaller brush</source>
        <translation>Een kleiner penseel</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Groter penseel</translation>
    </message>
    <message>
        <source>A larger brush</source>
        <translation>Een groter penseel</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles selecteren</translation>
    </message>
    <message>
        <source>Everything of the kind that clicks select</source>
        <translation>Alles van de soort die klikken selecteert</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Niets selecteren</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>De selectie opheffen</translation>
    </message>
    <message>
        <source>All within a distance...</source>
        <translation>Alles binnen een afstand...</translation>
    </message>
    <message>
        <source>The objects that lie no farther from the selection than a distance</source>
        <translation>De objecten die niet verder dan een afstand van de selectie liggen</translation>
    </message>
    <message>
        <source>Save selection...</source>
        <translation>Selectie opslaan...</translation>
    </message>
    <message>
        <source>Keep the selection under a name in the model tree</source>
        <translation>De selectie onder een naam in de modelboom bewaren</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Selectie vastzetten</translation>
    </message>
    <message>
        <source>Hold the selected faces or objects in place</source>
        <translation>De geselecteerde vlakken of objecten op hun plaats houden</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Selectie hernormaliseren</translation>
    </message>
    <message>
        <source>The selection takes its present shape for its own</source>
        <translation>De selectie neemt haar huidige vorm als eigen vorm aan</translation>
    </message>
    <message>
        <source>Make it glue</source>
        <translation>Tot lijm maken</translation>
    </message>
    <message>
        <source>The selected parts keep shape and place and hold what touches them</source>
        <translation>De geselecteerde onderdelen behouden vorm en plaats en houden vast wat ze raakt</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>Another name for the selected part, group or selection</source>
        <translation>Een andere naam voor het geselecteerde onderdeel, de groep of de selectie</translation>
    </message>
    <message>
        <source>Color...</source>
        <translation>Kleur...</translation>
    </message>
    <message>
        <source>Another color for the selected parts</source>
        <translation>Een andere kleur voor de geselecteerde onderdelen</translation>
    </message>
    <message>
        <source>Color of the file</source>
        <translation>Kleur van het bestand</translation>
    </message>
    <message>
        <source>The color that the part has in its file</source>
        <translation>De kleur die het onderdeel in zijn bestand heeft</translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation>Vergrendelen of ontgrendelen</translation>
    </message>
    <message>
        <source>Keep what is selected from being changed</source>
        <translation>Het geselecteerde tegen wijzigingen beschermen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>Put the selected parts into a group</source>
        <translation>De geselecteerde onderdelen in een groep zetten</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Groep opheffen</translation>
    </message>
    <message>
        <source>Take the selected parts out of their group, or all out of the selected one</source>
        <translation>De geselecteerde onderdelen uit hun groep halen, of alle uit de geselecteerde</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoleren</translation>
    </message>
    <message>
        <source>Show nothing but the selected parts; again: what was shown before</source>
        <translation>Alleen de geselecteerde onderdelen tonen; nogmaals: wat eerder te zien was</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Hide no part</source>
        <translation>Geen onderdeel verbergen</translation>
    </message>
    <message>
        <source>Search the model</source>
        <translation>In het model zoeken</translation>
    </message>
    <message>
        <source>Look for parts, tools, fixtures and selections by their names</source>
        <translation>Onderdelen, gereedschappen, inklemmingen en selecties op naam zoeken</translation>
    </message>
</context>
<context>
    <name>SelectionFeature</name>
    <message>
        <source>Se&amp;lect</source>
        <translation>Se&amp;lectie</translation>
    </message>
    <message>
        <source>Selecting</source>
        <translation>Selectie</translation>
    </message>
    <message>
        <source>Selecting within %1</source>
        <translation>Objecten binnen %1 worden gekozen</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Selecteer eerst iets.</translation>
    </message>
</context>
<context>
    <name>SelectionPanel</name>
    <message>
        <source>Fix</source>
        <translation>Vastzetten</translation>
    </message>
    <message>
        <source>Hold it in place (Shift+F)</source>
        <translation>Op zijn plaats houden (Shift+F)</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Hernormaliseren</translation>
    </message>
    <message>
        <source>It takes its present shape for its own (Shift+N)</source>
        <translation>De selectie neemt haar huidige vorm aan als eigen vorm (Shift+N)</translation>
    </message>
    <message>
        <source>Enter keeps the selection under this name in the model tree</source>
        <translation>Enter bewaart de selectie onder deze naam in de modelboom</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Keep the selection under this name</source>
        <translation>De selectie onder deze naam bewaren</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Opslaan als</translation>
    </message>
    <message>
        <source>Enter selects the objects that lie no farther from the selection than this</source>
        <translation>Enter kiest de objecten die niet verder dan dit van de selectie liggen</translation>
    </message>
    <message>
        <source>All within</source>
        <translation>Alles binnen</translation>
    </message>
    <message>
        <source>Material of its own</source>
        <translation>Eigen materiaal</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Kiezen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Takes effect at once, also while time runs. The rest of the part stays what it is.</source>
        <translation>Werkt meteen, ook terwijl de tijd loopt. De rest van het onderdeel blijft wat het is.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>van %1</translation>
    </message>
    <message>
        <source>A selection needs a name: type one, then save it.</source>
        <translation>Een selectie heeft een naam nodig: typ er een en sla haar dan op.</translation>
    </message>
    <message>
        <source>Name of the selection</source>
        <translation>Naam van de selectie</translation>
    </message>
</context>
<context>
    <name>Session field</name>
    <message>
        <source>&quot;%1&quot; is cracked, cut or in pieces there, and a field cannot tear: it says what became of the largest piece, as if it were whole.</source>
        <translation>&quot;%1&quot; is daar gescheurd, gesneden of in stukken, en een veld kan niet scheuren: het zegt wat er van het grootste stuk is geworden, alsof het heel was.</translation>
    </message>
    <message>
        <source>this is no project of Knead.</source>
        <translation>dit is geen project van Knead.</translation>
    </message>
    <message>
        <source>nothing has moved at its entry %1: there is no field.</source>
        <translation>bij stap %1 is niets bewogen: er is geen veld.</translation>
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
        <source>%1 already does &quot;%2&quot;.</source>
        <translation>%1 doet al &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Daar weghalen</translation>
    </message>
</context>
<context>
    <name>SimulationFeature</name>
    <message>
        <source>Slower tools</source>
        <translation>Langzamer gereedschap</translation>
    </message>
    <message>
        <source>More damping</source>
        <translation>Meer demping</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulatie</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Prestaties</translation>
    </message>
    <message>
        <source>Turn the section plane on (Shift+S) and put it where the cut shall be.</source>
        <translation>Zet het doorsnedevlak aan (Shift+S) en plaats het waar gesneden moet worden.</translation>
    </message>
    <message>
        <source>Fill finer</source>
        <translation>Fijner vullen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Pause first.</source>
        <translation>Pauzeer eerst.</translation>
    </message>
    <message>
        <source>Only a part to which nothing was done yet is pressed like this.</source>
        <translation>Alleen een onderdeel waaraan nog niets is gedaan, wordt zo ingedrukt.</translation>
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
        <source>%1 &quot;%2&quot;</source>
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
        <source>Come back to the present first: Esc.</source>
        <translation>Kom eerst terug naar het heden: Esc.</translation>
    </message>
</context>
<context>
    <name>SimulationPanel</name>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>Earth</source>
        <translation>Aarde</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Maan</translation>
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
        <translation>Ware tijd</translation>
    </message>
    <message>
        <source>1/%1 of real time</source>
        <translation>1/%1 van ware tijd</translation>
    </message>
    <message>
        <source>%1 times real time</source>
        <translation>%1 maal ware tijd</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>How fast simulated time runs when the machine keeps up: slow motion shows what is quick</source>
        <translation>Hoe snel de gesimuleerde tijd loopt als de computer het bijhoudt: vertraagde weergave toont wat snel gaat</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Simulated time of one step; the largest stable one with a margin</source>
        <translation>Gesimuleerde tijd van één stap; de grootste stabiele met een marge</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Gesimuleerd</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Tijdstap</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Zwaartekracht</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Eigen getallen</translation>
    </message>
    <message>
        <source>As on</source>
        <translation>Zoals op</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>Langs %1</translation>
    </message>
    <message>
        <source>Damping of all bodies</source>
        <translation>Demping van alle lichamen</translation>
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
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>How many threads compute; the results are the same bits with any number</source>
        <translation>Hoeveel threads rekenen; de resultaten zijn met elk aantal tot op de bit gelijk</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>different</source>
        <translation>verschillend</translation>
    </message>
    <message>
        <source>%1 of all bodies</source>
        <translation>%1 van alle lichamen</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oppervlak</translation>
    </message>
    <message>
        <source>In a contact it is the geometric mean with that of the material</source>
        <translation>In een contact geldt het meetkundig gemiddelde met die van het materiaal</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Wrijving</translation>
    </message>
    <message>
        <source>Tension that holds down what has touched the table; 0: nothing sticks to it</source>
        <translation>Trekspanning die vasthoudt wat de tafel heeft geraakt; 0: niets plakt eraan</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Hechting</translation>
    </message>
    <message>
        <source>Gravity as on</source>
        <translation>Zwaartekracht zoals op</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>checking the surface</source>
        <translation>oppervlak controleren</translation>
    </message>
    <message>
        <source>preparing the surface</source>
        <translation>oppervlak voorbereiden</translation>
    </message>
    <message>
        <source>preparing the simulation</source>
        <translation>simulatie voorbereiden</translation>
    </message>
    <message>
        <source>placing objects</source>
        <translation>objecten plaatsen</translation>
    </message>
    <message>
        <source>cutting cells</source>
        <translation>cellen snijden</translation>
    </message>
    <message>
        <source>measuring depth</source>
        <translation>diepte meten</translation>
    </message>
    <message>
        <source>measuring walls</source>
        <translation>wanden meten</translation>
    </message>
    <message>
        <source>fitting walls</source>
        <translation>wanden passend maken</translation>
    </message>
    <message>
        <source>looking for crossings</source>
        <translation>doorsnijdingen zoeken</translation>
    </message>
    <message>
        <source>attaching the surface</source>
        <translation>oppervlak vasthechten</translation>
    </message>
    <message>
        <source>cutting the surface</source>
        <translation>oppervlak snijden</translation>
    </message>
    <message>
        <source>finding the cracks</source>
        <translation>scheuren zoeken</translation>
    </message>
    <message>
        <source>smoothing the cracks</source>
        <translation>scheuren gladmaken</translation>
    </message>
    <message>
        <source>repeating</source>
        <translation>herhalen</translation>
    </message>
    <message>
        <source>finding the balance</source>
        <translation>evenwicht zoeken</translation>
    </message>
    <message>
        <source>reading the file</source>
        <translation>bestand lezen</translation>
    </message>
    <message>
        <source>looking into the file</source>
        <translation>bestand bekijken</translation>
    </message>
    <message>
        <source>making shapes</source>
        <translation>vormen maken</translation>
    </message>
    <message>
        <source>making triangles</source>
        <translation>driehoeken maken</translation>
    </message>
    <message>
        <source>healing parts</source>
        <translation>onderdelen herstellen</translation>
    </message>
    <message>
        <source>checking parts</source>
        <translation>onderdelen controleren</translation>
    </message>
    <message>
        <source>measuring parts</source>
        <translation>onderdelen meten</translation>
    </message>
    <message>
        <source>keeping the exact shapes</source>
        <translation>exacte vormen bewaren</translation>
    </message>
    <message>
        <source>handing the parts over</source>
        <translation>onderdelen overdragen</translation>
    </message>
    <message>
        <source>handing over</source>
        <translation>overdragen</translation>
    </message>
    <message>
        <source>bending the surface</source>
        <translation>oppervlak buigen</translation>
    </message>
    <message>
        <source>bending edges</source>
        <translation>randen buigen</translation>
    </message>
    <message>
        <source>bending faces</source>
        <translation>vlakken buigen</translation>
    </message>
    <message>
        <source>measuring tolerances</source>
        <translation>toleranties meten</translation>
    </message>
    <message>
        <source>measuring distances</source>
        <translation>afstanden meten</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>controleren</translation>
    </message>
    <message>
        <source>comparing with the skin</source>
        <translation>vergelijken met de huid</translation>
    </message>
    <message>
        <source>writing faces</source>
        <translation>vlakken schrijven</translation>
    </message>
    <message>
        <source>writing triangles</source>
        <translation>driehoeken schrijven</translation>
    </message>
    <message>
        <source>writing the file</source>
        <translation>bestand schrijven</translation>
    </message>
    <message>
        <source>opening the project</source>
        <translation>project openen</translation>
    </message>
    <message>
        <source>opening the history</source>
        <translation>geschiedenis openen</translation>
    </message>
    <message>
        <source>saving the parts</source>
        <translation>onderdelen opslaan</translation>
    </message>
    <message>
        <source>saving the history</source>
        <translation>geschiedenis opslaan</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klaar</translation>
    </message>
    <message>
        <source>dividing faces</source>
        <translation>vlakken worden gedeeld</translation>
    </message>
    <message>
        <source>fitting the field</source>
        <translation>het veld aanpassen</translation>
    </message>
    <message>
        <source>comparing the field with the parts</source>
        <translation>het veld met de delen vergelijken</translation>
    </message>
    <message>
        <source>placing the scan</source>
        <translation>de scan plaatsen</translation>
    </message>
    <message>
        <source>comparing the scan with the part</source>
        <translation>de scan met het deel vergelijken</translation>
    </message>
    <message>
        <source>finding the faces again</source>
        <translation>vlakken worden teruggevonden</translation>
    </message>
    <message>
        <source>moving the grips</source>
        <translation>de grepen bewegen</translation>
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
    <message>
        <source>%1x of %2x as chosen</source>
        <translation>%1x van de gekozen %2x</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In rust</translation>
    </message>
    <message>
        <source>30 steps a second to keep up</source>
        <translation>30 stappen per seconde om bij te blijven</translation>
    </message>
    <message>
        <source>Rough steps to keep up</source>
        <translation>Grove stappen om bij te blijven</translation>
    </message>
    <message>
        <source>Forces are within 3 % of the largest. The Simulation panel says whether to keep up with real time or to be exact</source>
        <translation>Krachten zijn binnen 3 % van de grootste. Het paneel Simulatie zegt of de tijd wordt bijgehouden of exact wordt gerekend</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>the STEP file ends inside a text; it is cut off, get it again.</source>
        <translation>het STEP-bestand eindigt midden in een tekst; het is afgekapt, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the STEP file ends before its last line (END-ISO-10303-21); it is cut off, get it again.</source>
        <translation>het STEP-bestand eindigt vóór zijn laatste regel (END-ISO-10303-21); het is afgekapt, haal het opnieuw op.</translation>
    </message>
    <message>
        <source>the STEP file has no DATA section, so it holds no shapes.</source>
        <translation>het STEP-bestand heeft geen DATA-sectie, dus bevat het geen vormen.</translation>
    </message>
    <message>
        <source>a name in the STEP file is longer than 65 thousand letters; the file is damaged.</source>
        <translation>een naam in het STEP-bestand is langer dan 65 duizend letters; het bestand is beschadigd.</translation>
    </message>
    <message>
        <source>lists in the STEP file are nested more than 500 deep; the file is damaged.</source>
        <translation>lijsten in het STEP-bestand zijn meer dan 500 diep genest; het bestand is beschadigd.</translation>
    </message>
    <message>
        <source>the STEP file has &quot;%1&quot; in place of a number; export it again.</source>
        <translation>in het STEP-bestand staat &quot;%1&quot; in plaats van een getal; exporteer het opnieuw.</translation>
    </message>
    <message>
        <source>%1: a turned face is bounded across its seam, and the file does not tell on which side of its border it lies; check the volume of its part.</source>
        <translation>%1: een gedraaid vlak is over zijn naad heen begrensd, en het bestand zegt niet aan welke kant van zijn rand het ligt; controleer het volume van zijn onderdeel.</translation>
    </message>
    <message>
        <source>1 shape of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>1 vorm van het STEP-bestand kon niet worden gelezen: de vlakken zijn beschadigd of van een onbekende soort.</translation>
    </message>
    <message>
        <source>%1 shapes of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>%1 vormen van het STEP-bestand konden niet worden gelezen: de vlakken zijn beschadigd of van een onbekende soort.</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; export the file again.</source>
        <translation>het element %1 verwijst naar iets verkeerds of naar niets; exporteer het bestand opnieuw.</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: %2).</source>
        <translation>het element %1 verwijst naar iets verkeerds of naar niets; wat het nodig heeft kon niet worden gelezen (vlakken: %2).</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (shapes: %2).</source>
        <translation>het element %1 verwijst naar iets verkeerds of naar niets; wat het nodig heeft kon niet worden gelezen (vormen: %2).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (faces: %3).</source>
        <translation>het element %1 en %2 andere verwijzen naar iets verkeerds of naar niets; wat ze nodig heeft kon niet worden gelezen (vlakken: %3).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (shapes: %3).</source>
        <translation>het element %1 en %2 andere verwijzen naar iets verkeerds of naar niets; wat ze nodig heeft kon niet worden gelezen (vormen: %3).</translation>
    </message>
    <message>
        <source>the assembly refers to the file %1, which is not there: its parts are missing. Put it beside the assembly and open that again.</source>
        <translation>de samenstelling verwijst naar het bestand %1, dat er niet is: de onderdelen ervan ontbreken. Zet het naast de samenstelling en open die opnieuw.</translation>
    </message>
    <message>
        <source>the assembly refers to %1 files that are not there: %2. Their parts are missing; put them beside the assembly and open that again.</source>
        <translation>de samenstelling verwijst naar %1 bestanden die er niet zijn: %2. Hun onderdelen ontbreken; zet ze naast de samenstelling en open die opnieuw.</translation>
    </message>
    <message>
        <source>the file holds triangles only (tessellated geometry of AP242), which are not read from STEP; export exact solids, or a mesh as 3MF or STL.</source>
        <translation>het bestand bevat alleen driehoeken (betegelde geometrie van AP242), die niet uit STEP worden gelezen; exporteer exacte lichamen, of een net als 3MF of STL.</translation>
    </message>
    <message>
        <source>the file holds curves and points only, no solid and no surface; export the part as a solid.</source>
        <translation>het bestand bevat alleen krommen en punten, geen lichaam en geen oppervlak; exporteer het onderdeel als lichaam.</translation>
    </message>
    <message>
        <source>the assembly refers to %1, which is no ordinary file in its folder; put the file beside the assembly and open that again.</source>
        <translation>de samenstelling verwijst naar %1, dat geen gewoon bestand in haar map is; zet het bestand naast de samenstelling en open die opnieuw.</translation>
    </message>
</context>
<context>
    <name>Study</name>
    <message>
        <source>must name a face; leave the part out where none counts.</source>
        <translation>moet een vlak noemen; laat het onderdeel weg waar er geen telt.</translation>
    </message>
    <message>
        <source>must name a part; leave the key out where all faces count.</source>
        <translation>moet een onderdeel noemen; laat de sleutel weg waar alle vlakken tellen.</translation>
    </message>
    <message>
        <source>must be the name of a file in the folder of the round, without folders</source>
        <translation>moet de naam van een bestand in de map van de ronde zijn, zonder mappen</translation>
    </message>
    <message>
        <source>has the name of another one; all of them go into one folder.</source>
        <translation>heet als een ander; ze gaan allemaal in één map.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys recipe and command.</source>
        <translation>moet precies één van de sleutels recipe en command hebben.</translation>
    </message>
    <message>
        <source>must have the key &quot;field&quot;: the file that the command writes.</source>
        <translation>moet de sleutel &quot;field&quot; hebben: het bestand dat de opdracht schrijft.</translation>
    </message>
    <message>
        <source>belongs to a command; a recipe needs none.</source>
        <translation>hoort bij een opdracht; een recept heeft dat niet nodig.</translation>
    </message>
</context>
<context>
    <name>Synonyms</name>
    <message>
        <source>revert, back, take back, mistake</source>
        <translation>terug, terugdraaien, fout</translation>
    </message>
    <message>
        <source>again, forward, repeat</source>
        <translation>nogmaals, vooruit, herhalen</translation>
    </message>
    <message>
        <source>load, import, file, read</source>
        <translation>laden, importeren, bestand, lezen</translation>
    </message>
    <message>
        <source>write, store, keep, project</source>
        <translation>bewaren, schrijven, project</translation>
    </message>
    <message>
        <source>write as, copy, duplicate</source>
        <translation>bewaren als, kopie</translation>
    </message>
    <message>
        <source>STEP, IGES, STL, mesh, 3D print, print, write, convert, CAD</source>
        <translation>STEP, IGES, STL, net, 3D-print, afdrukken, schrijven, omzetten, CAD</translation>
    </message>
    <message>
        <source>script, macro, batch, automate</source>
        <translation>script, macro, automatiseren</translation>
    </message>
    <message>
        <source>screenshot, image, photo, snapshot, PNG, JPEG, render</source>
        <translation>schermafbeelding, schermafdruk, foto, PNG, JPEG</translation>
    </message>
    <message>
        <source>movie, film, animation, screencast, clip</source>
        <translation>film, animatie, schermopname</translation>
    </message>
    <message>
        <source>frames, image sequence</source>
        <translation>beeldjes, reeks beelden</translation>
    </message>
    <message>
        <source>demo, show me</source>
        <translation>demonstratie, laat zien</translation>
    </message>
    <message>
        <source>push, squeeze, poke</source>
        <translation>duwen, persen</translation>
    </message>
    <message>
        <source>drag, tug, stretch, grab</source>
        <translation>slepen, rekken, grijpen</translation>
    </message>
    <message>
        <source>sculpt, mold, mould, clay, knead, dent, finger, groove</source>
        <translation>boetseren, vormen, klei, kneden, deuk, vinger, groef</translation>
    </message>
    <message>
        <source>polish, even out, relax</source>
        <translation>polijsten, effenen</translation>
    </message>
    <message>
        <source>flat, plane, iron</source>
        <translation>vlak, plat, strijken</translation>
    </message>
    <message>
        <source>crease, ridge, gather</source>
        <translation>knijpen, richel, plooi</translation>
    </message>
    <message>
        <source>smudge, spread</source>
        <translation>uitsmeren, vegen</translation>
    </message>
    <message>
        <source>fold, curve</source>
        <translation>vouwen, krommen</translation>
    </message>
    <message>
        <source>wring, turn, screw</source>
        <translation>wringen, draaien</translation>
    </message>
    <message>
        <source>mirror, both sides</source>
        <translation>spiegelen, beide kanten</translation>
    </message>
    <message>
        <source>orbit, rotate view, turn view, pan, navigate, gestures</source>
        <translation>orbit, beeld draaien, verschuiven, navigeren</translation>
    </message>
    <message>
        <source>zoom, zoom to fit, center, frame, whole part</source>
        <translation>zoom, inzoomen, centreren, hele onderdeel</translation>
    </message>
    <message>
        <source>3D view, default view</source>
        <translation>3D-beeld, standaardbeeld</translation>
    </message>
    <message>
        <source>orthographic, parallel, projection</source>
        <translation>orthografisch, parallel, projectie</translation>
    </message>
    <message>
        <source>join, bond, stick, weld, attach, fuse</source>
        <translation>verbinden, plakken, lassen, vastmaken</translation>
    </message>
    <message>
        <source>cut, slice, blade, split, saw</source>
        <translation>snijden, mes, lemmet, zagen</translation>
    </message>
    <message>
        <source>cheese wire, cut</source>
        <translation>snijdraad, snijden</translation>
    </message>
    <message>
        <source>slice, split, saw, divide, halve</source>
        <translation>snijden, splitsen, zagen, delen</translation>
    </message>
    <message>
        <source>cross section, clip, cutaway, look inside</source>
        <translation>doorsnede, binnenin kijken</translation>
    </message>
    <message>
        <source>box, cube, punch, stamp</source>
        <translation>kubus, stempel</translation>
    </message>
    <message>
        <source>sphere, bead</source>
        <translation>bol, knikker</translation>
    </message>
    <message>
        <source>rolling pin, roll out</source>
        <translation>deegroller, uitrollen</translation>
    </message>
    <message>
        <source>clamp, hold, anchor, pin, constrain, support, vise</source>
        <translation>inklemmen, vasthouden, verankeren, bankschroef</translation>
    </message>
    <message>
        <source>measure, ruler, length, gap, dimension, caliper</source>
        <translation>meten, liniaal, lengte, spleet, maat</translation>
    </message>
    <message>
        <source>weight, mass, how heavy</source>
        <translation>gewicht, massa, hoe zwaar</translation>
    </message>
    <message>
        <source>size, extent, width, height</source>
        <translation>grootte, afmeting, breedte, hoogte</translation>
    </message>
    <message>
        <source>difference, deviation, report</source>
        <translation>verschil, afwijking, rapport</translation>
    </message>
    <message>
        <source>sensor, strain gauge</source>
        <translation>sensor, rekstrookje</translation>
    </message>
    <message>
        <source>graph, chart, curve</source>
        <translation>grafiek, kromme</translation>
    </message>
    <message>
        <source>CSV, spreadsheet, data</source>
        <translation>CSV, rekenblad, gegevens</translation>
    </message>
    <message>
        <source>fall, drop, heavy</source>
        <translation>vallen, zwaar</translation>
    </message>
    <message>
        <source>ground, table</source>
        <translation>grond, tafel</translation>
    </message>
    <message>
        <source>run, start, simulate, pause, stop</source>
        <translation>starten, simuleren, pauze, stoppen</translation>
    </message>
    <message>
        <source>start over, rewind, restart</source>
        <translation>opnieuw beginnen, terugspoelen</translation>
    </message>
    <message>
        <source>equilibrium, settle, static</source>
        <translation>evenwicht, statisch</translation>
    </message>
    <message>
        <source>forget shape, accept shape</source>
        <translation>vorm vergeten, vorm aanvaarden</translation>
    </message>
    <message>
        <source>remesh, resolution</source>
        <translation>opnieuw vernetten, resolutie</translation>
    </message>
    <message>
        <source>real time, slow, faster</source>
        <translation>langzaam, sneller</translation>
    </message>
    <message>
        <source>help, manual, documentation, guide, how to</source>
        <translation>hulp, handleiding, documentatie, gids</translation>
    </message>
    <message>
        <source>tutorial, learn, getting started, introduction, first steps</source>
        <translation>tutorial, leren, inleiding, eerste stappen</translation>
    </message>
    <message>
        <source>hotkeys, key bindings, keymap</source>
        <translation>sneltoetsen, toetsen</translation>
    </message>
    <message>
        <source>settings, options, language, units, translation</source>
        <translation>instellingen, opties, taal, eenheden, vertaling</translation>
    </message>
    <message>
        <source>dark mode, night mode, black</source>
        <translation>donkere modus, nachtmodus, zwart</translation>
    </message>
    <message>
        <source>light mode, day mode, white</source>
        <translation>lichte modus, dagmodus, wit</translation>
    </message>
    <message>
        <source>new document, second window</source>
        <translation>nieuw document, tweede venster</translation>
    </message>
    <message>
        <source>home, start page, welcome, examples</source>
        <translation>startpagina, welkom, voorbeelden</translation>
    </message>
    <message>
        <source>crash, restore, lost work, autosave</source>
        <translation>crash, terughalen, verloren werk</translation>
    </message>
    <message>
        <source>delete, erase</source>
        <translation>wissen, weghalen</translation>
    </message>
    <message>
        <source>invisible, conceal</source>
        <translation>onzichtbaar, verbergen</translation>
    </message>
    <message>
        <source>unhide, visible</source>
        <translation>zichtbaar</translation>
    </message>
    <message>
        <source>only this, solo</source>
        <translation>alleen dit</translation>
    </message>
    <message>
        <source>spheres, particles</source>
        <translation>bollen, deeltjes</translation>
    </message>
    <message>
        <source>lines, outline</source>
        <translation>lijnen, omtrek</translation>
    </message>
    <message>
        <source>maximize, presentation</source>
        <translation>maximaliseren, presentatie</translation>
    </message>
    <message>
        <source>version, license, credits</source>
        <translation>versie, licentie</translation>
    </message>
    <message>
        <source>search, find action</source>
        <translation>zoeken, actie vinden</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>sluiten, verlaten</translation>
    </message>
    <message>
        <source>name, call</source>
        <translation>noemen, naam</translation>
    </message>
    <message>
        <source>paint, colour, tint</source>
        <translation>verven, kleuren</translation>
    </message>
    <message>
        <source>protect, freeze</source>
        <translation>beschermen, bevriezen</translation>
    </message>
    <message>
        <source>undeformed, ghost</source>
        <translation>onvervormd</translation>
    </message>
    <message>
        <source>move, rotate, arrows, transform</source>
        <translation>bewegen, draaien, pijlen</translation>
    </message>
    <message>
        <source>WASD, keyboard control</source>
        <translation>WASD, toetsenbord</translation>
    </message>
    <message>
        <source>3Dconnexion, SpaceMouse, joystick</source>
        <translation>3Dconnexion, SpaceMouse, joystick</translation>
    </message>
    <message>
        <source>assembly, insert, merge</source>
        <translation>samenstelling, invoegen</translation>
    </message>
    <message>
        <source>threads, slow motion, speed</source>
        <translation>threads, slow motion, snelheid</translation>
    </message>
    <message>
        <source>fps, frame rate, profiler</source>
        <translation>fps, beeldsnelheid</translation>
    </message>
    <message>
        <source>material, stiffness, rubber, steel</source>
        <translation>materiaal, stijfheid, rubber, staal</translation>
    </message>
    <message>
        <source>revision, version, transfer, repeat, other part</source>
        <translation>revisie, versie, overbrengen, herhalen, ander onderdeel</translation>
    </message>
    <message>
        <source>flex, morph, warp, deformer, free form, global modeling</source>
        <translation>flexen, morphen, kromtrekken, vrije vorm</translation>
    </message>
    <message>
        <source>flex, curl, arc, curve, sheet metal, k-factor, tube, roll</source>
        <translation>krommen, boog, bocht, plaatwerk, k-factor, buis, zetten</translation>
    </message>
    <message>
        <source>wring, flex, screw, turn, helix, torsion</source>
        <translation>wringen, schroef, draaien, helix, torsie</translation>
    </message>
    <message>
        <source>flex, cone, draft, narrow, widen</source>
        <translation>kegel, conus, lossing, versmallen, verbreden</translation>
    </message>
    <message>
        <source>flex, lengthen, shorten, elongate, compress</source>
        <translation>verlengen, verkorten, samendrukken</translation>
    </message>
    <message>
        <source>offset, skew, slant, joggle, sideways</source>
        <translation>verspringing, schuin, scheef, zijwaarts</translation>
    </message>
    <message>
        <source>enlarge, shrink, size, grow</source>
        <translation>vergroten, verkleinen, grootte, groeien</translation>
    </message>
    <message>
        <source>displacements, FEM, FEA, CalculiX, Abaqus, warpage, springback, compensation, morph, field, vtu, frd</source>
        <translation>verplaatsingen, EEM, CalculiX, Abaqus, kromtrekken, terugvering, compensatie, veld, vtu, frd</translation>
    </message>
    <message>
        <source>script, macro, code, program, automate, journal</source>
        <translation>script, macro, code, programma, automatiseren, logboek</translation>
    </message>
</context>
<context>
    <name>TableKinds</name>
    <message>
        <source>Smooth</source>
        <translation>Glad</translation>
    </message>
    <message>
        <source>Parts slide on it, as on glass</source>
        <translation>Onderdelen glijden erop, zoals op glas</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Ruw</translation>
    </message>
    <message>
        <source>Parts hardly slide, and are lifted off freely</source>
        <translation>Onderdelen glijden nauwelijks en laten zich vrij optillen</translation>
    </message>
    <message>
        <source>Sticky</source>
        <translation>Plakkerig</translation>
    </message>
    <message>
        <source>Parts stay where they are: it takes 20 kPa to lift them off</source>
        <translation>Onderdelen blijven waar ze zijn: er is 20 kPa nodig om ze op te tillen</translation>
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
    <name>TaskRunner</name>
    <message>
        <source>%1: there is not enough memory. Close other programs, or choose a larger spacing.</source>
        <translation>%1: er is niet genoeg geheugen. Sluit andere programma&apos;s, of kies een grotere afstand.</translation>
    </message>
</context>
<context>
    <name>TextFiles</name>
    <message>
        <source>%1 cannot be written (%2). Choose another folder, or make room on the disk.</source>
        <translation>%1 kan niet worden geschreven (%2). Kies een andere map of maak ruimte vrij op de schijf.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wordt geschreven</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschreven: %1.</translation>
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
    <message>
        <source>Filled anew</source>
        <translation>Opnieuw gevuld</translation>
    </message>
    <message>
        <source>no film kept</source>
        <translation>geen film bewaard</translation>
    </message>
    <message>
        <source>Double-click: go there</source>
        <translation>Dubbelklik: daarheen gaan</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Tijdlijn</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1, stap %2</translation>
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
    <message>
        <source>Play the film</source>
        <translation>Film afspelen</translation>
    </message>
    <message>
        <source>Simulate something first, and look back at it.</source>
        <translation>Simuleer eerst iets, en kijk daarop terug.</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Snelheid van de film</translation>
    </message>
    <message>
        <source>Projects keep entries and no film: go to one with a double click, or simulate on.</source>
        <translation>Projecten bewaren stappen en geen film: ga er met een dubbelklik naartoe, of simuleer verder.</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Tool &quot;%1&quot;: %2</source>
        <translation>Gereedschap &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>each edge must be between 0.001 mm and 1000 m long.</source>
        <translation>elke rand moet tussen 0.001 mm en 1000 m lang zijn.</translation>
    </message>
    <message>
        <source>it is to be a part, but has none.</source>
        <translation>het moet een onderdeel zijn, maar heeft er geen.</translation>
    </message>
    <message>
        <source>its measures do not fit together: a ball has one, a cylinder a diameter and a length.</source>
        <translation>de maten passen niet bij elkaar: een bol heeft er één, een cilinder een diameter en een lengte.</translation>
    </message>
    <message>
        <source>its place must be numbers, within 10 km.</source>
        <translation>de plaats moet uit getallen bestaan, binnen 10 km.</translation>
    </message>
    <message>
        <source>friction must lie between 0 and 2.</source>
        <translation>de wrijving moet tussen 0 en 2 liggen.</translation>
    </message>
    <message>
        <source>the speed limit must lie between 0.001 mm/s and 100 m/s.</source>
        <translation>de snelheidsgrens moet tussen 0.001 mm/s en 100 m/s liggen.</translation>
    </message>
    <message>
        <source>the adhesion must lie between 0 and 1e9 Pa.</source>
        <translation>de hechting moet tussen 0 en 1e9 Pa liggen.</translation>
    </message>
    <message>
        <source>the force limit must be greater than 0 N.</source>
        <translation>de krachtgrens moet groter dan 0 N zijn.</translation>
    </message>
    <message>
        <source>a key-framed motion needs at least one frame.</source>
        <translation>een beweging met sleutelbeelden vraagt minstens één beeld.</translation>
    </message>
    <message>
        <source>the times of key frames must ascend.</source>
        <translation>de tijden van sleutelbeelden moeten oplopen.</translation>
    </message>
    <message>
        <source>key frames must be numbers, within 10 km.</source>
        <translation>sleutelbeelden moeten uit getallen bestaan, binnen 10 km.</translation>
    </message>
    <message>
        <source>it must not go faster than 10000 m/s or 100000 rad/s.</source>
        <translation>het mag niet sneller dan 10000 m/s of 100000 rad/s gaan.</translation>
    </message>
    <message>
        <source>its target must be numbers, within 10 km.</source>
        <translation>het doel moet uit getallen bestaan, binnen 10 km.</translation>
    </message>
    <message>
        <source>The tool&apos;s part has no surface. Choose another file.</source>
        <translation>Het onderdeel van het gereedschap heeft geen oppervlak. Kies een ander bestand.</translation>
    </message>
    <message>
        <source>There is no tool number %1.</source>
        <translation>Er is geen gereedschap nummer %1.</translation>
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
    <message>
        <source>Tension that holds what has touched the tool; 0: nothing sticks to it</source>
        <translation>Trekspanning die vasthoudt wat het gereedschap heeft geraakt; 0: niets plakt eraan</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Hechting</translation>
    </message>
    <message>
        <source>Rolls freely</source>
        <translation>Rolt vrij</translation>
    </message>
    <message>
        <source>The tool turns as it is moved over material, so that it does not rub it</source>
        <translation>Het gereedschap draait terwijl het over materiaal beweegt en wrijft er zo niet over</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Overslaan</translation>
    </message>
    <message>
        <source>Go on without doing this</source>
        <translation>Doorgaan zonder dit te doen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beëindigen</translation>
    </message>
    <message>
        <source>End the tour; the part stays open</source>
        <translation>De rondleiding beëindigen; het onderdeel blijft open</translation>
    </message>
    <message>
        <source>Tour: %1</source>
        <translation>Rondleiding: %1</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Drukken</translation>
    </message>
    <message>
        <source>Hold the left button on the clay: a thumb goes in for as long as you hold it.</source>
        <translation>Houd de linkerknop op de klei ingedrukt: een duim gaat erin zolang u hem vasthoudt.</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Choose Pull material at the right of the view (%1). Then drag a corner of the clay outwards.</source>
        <translation>Kies Aan materiaal trekken rechts van het beeld (%1). Sleep dan een hoek van de klei naar buiten.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>Press %1 and write the clay as STEP or as a mesh, into a folder of your choice. Or skip this.</source>
        <translation>Druk op %1 en schrijf de klei als STEP of als net, in een map naar keuze. Of sla dit over.</translation>
    </message>
    <message>
        <source>That was all</source>
        <translation>Dat was alles</translation>
    </message>
    <message>
        <source>Ctrl+Z takes back whatever you did. Ctrl+K finds any command, F1 opens the handbook, and this tour is in the menu Help.</source>
        <translation>Ctrl+Z neemt terug wat u ook deed. Ctrl+K vindt elke opdracht, F1 opent het handboek, en deze rondleiding staat in het menu Help.</translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>The project has no bodies that a script could fill.</source>
        <translation>Het project heeft geen lichamen die een script zou kunnen vullen.</translation>
    </message>
    <message>
        <source>Nothing was done in the project yet that a script could say.</source>
        <translation>In het project is nog niets gedaan wat een script zou kunnen zeggen.</translation>
    </message>
    <message>
        <source>A tool is an imported part, which only a saved project keeps: save the project first.</source>
        <translation>Een gereedschap is een geïmporteerd onderdeel, dat alleen een opgeslagen project bewaart: sla eerst het project op.</translation>
    </message>
    <message>
        <source>The parts are in no file as they are here: save the project first, from which the script then takes them.</source>
        <translation>De onderdelen staan in geen bestand zoals ze hier zijn: sla eerst het project op, waaruit het script ze dan neemt.</translation>
    </message>
    <message>
        <source>%1 has no entry %2; its last one is %3.</source>
        <translation>%1 heeft geen regel %2; de laatste is %3.</translation>
    </message>
</context>
<context>
    <name>TraceFeature</name>
    <message>
        <source>Python trace</source>
        <translation>Python-verslag</translation>
    </message>
    <message>
        <source>Save the Python trace</source>
        <translation>Python-verslag opslaan</translation>
    </message>
    <message>
        <source>Python scripts (*%1)</source>
        <translation>Python-scripts (*%1)</translation>
    </message>
</context>
<context>
    <name>TracePanel</name>
    <message>
        <source>Python trace</source>
        <translation>Python-verslag</translation>
    </message>
    <message>
        <source>Open a part: what you do is then written here as Python.</source>
        <translation>Open een onderdeel: wat u doet, staat hier dan als Python.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>Copy the whole script</source>
        <translation>Het hele script kopiëren</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Opslaan als...</translation>
    </message>
    <message>
        <source>Write the script to a file; run, it comes to the same bits</source>
        <translation>Het script naar een bestand schrijven; uitgevoerd komt het op dezelfde bits uit</translation>
    </message>
</context>
<context>
    <name>Transfer</name>
    <message>
        <source>The recipe</source>
        <translation>Het recept</translation>
    </message>
    <message>
        <source>Left out: %1. %2</source>
        <translation>Weggelaten: %1. %2</translation>
    </message>
    <message>
        <source>what is said of the body &quot;%1&quot;</source>
        <translation>wat van het lichaam &quot;%1&quot; wordt gezegd</translation>
    </message>
    <message>
        <source>The other part has no such body.</source>
        <translation>Het andere onderdeel heeft zo&apos;n lichaam niet.</translation>
    </message>
    <message>
        <source>None of its faces was found again.</source>
        <translation>Geen van de vlakken is teruggevonden.</translation>
    </message>
    <message>
        <source>Of the faces of %1, %2 were not found again.</source>
        <translation>Niet teruggevonden vlakken, %1: %2</translation>
    </message>
    <message>
        <source>It names objects of a body that had been filled anew by then, which another part does not have.</source>
        <translation>Het noemt objecten van een lichaam dat intussen opnieuw was gevuld; een ander onderdeel heeft die niet.</translation>
    </message>
    <message>
        <source>There is no material in its place.</source>
        <translation>Op die plaats is geen materiaal.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot;</source>
        <translation>het gereedschap &quot;%1&quot;</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is left out: it is an imported part, which has no mirror image.</source>
        <translation>Het gereedschap &quot;%1&quot; vervalt: het is een geïmporteerd onderdeel, dat geen spiegelbeeld heeft.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; keeps its size: it is an imported part.</source>
        <translation>Het gereedschap &quot;%1&quot; houdt zijn grootte: het is een geïmporteerd onderdeel.</translation>
    </message>
    <message>
        <source>One of the parts is not closed: there is nothing to carry over.</source>
        <translation>Een van de onderdelen is niet gesloten: er is niets over te brengen.</translation>
    </message>
    <message>
        <source>none of the faces was found again on it. Is it another part, or a mirrored one?</source>
        <translation>geen van de vlakken is erop teruggevonden. Is het een ander onderdeel, of een gespiegeld?</translation>
    </message>
    <message>
        <source>a change of material</source>
        <translation>een wijziging van het materiaal</translation>
    </message>
    <message>
        <source>a relaxation</source>
        <translation>een ontspanning</translation>
    </message>
    <message>
        <source>a cut</source>
        <translation>een snede</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>de inklemming &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>de belasting &quot;%1&quot;</translation>
    </message>
    <message>
        <source>The floor is left out: its mirror image would be no floor.</source>
        <translation>De vloer vervalt: het spiegelbeeld ervan zou geen vloer zijn.</translation>
    </message>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>de sonde &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>het gebied &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--mirror &quot;%1&quot; is no mirror; say x, y or z, across which it is mirrored, or the normal of a plane as 1,1,0.</source>
        <translation>--mirror &quot;%1&quot; is geen spiegel; geef x, y of z, of de normaal van een vlak zoals 1,1,0.</translation>
    </message>
    <message>
        <source>--scale &quot;%1&quot; is no scale; say auto or a number from 0.001 to 1000.</source>
        <translation>--scale &quot;%1&quot; is geen schaal; geef auto of een getal van 0.001 tot 1000.</translation>
    </message>
    <message>
        <source>this is no project of Knead. A recipe goes to another part with knead run --set part.file=...</source>
        <translation>dit is geen project van Knead. Naar een ander onderdeel gaat een recept met knead run --set part.file=...</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>het project heeft geen stap %1; de laatste is %2.</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>Open that file alone to correct it.</source>
        <translation>Open dat bestand alleen om het te corrigeren.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimeters</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>meters</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>inch</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimeters</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>voeten</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrometers</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>decimeters</translation>
    </message>
    <message>
        <source>thousandths of an inch</source>
        <translation>duizendsten van een inch</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>nanometers</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilometers</translation>
    </message>
    <message>
        <source>miles</source>
        <translation>mijlen</translation>
    </message>
    <message>
        <source>millionths of an inch</source>
        <translation>miljoensten van een inch</translation>
    </message>
    <message>
        <source>%1: the file states no length unit; millimetres were taken.</source>
        <translation>%1: het bestand noemt geen lengte-eenheid; millimeters zijn genomen.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; that was asked for is not known; known are %2.</source>
        <translation>de gevraagde lengte-eenheid &quot;%1&quot; is niet bekend; bekend zijn %2.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; of the file is not known; known are %2.</source>
        <translation>de lengte-eenheid &quot;%1&quot; van het bestand is niet bekend; bekend zijn %2.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4.</source>
        <translation>%1: het onderdeel is %2 lang; als zijn lengten %3 zijn, is het %4.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4.</source>
        <translation>%1: de onderdelen zijn samen %2 lang; als hun lengten %3 zijn, zijn ze %4.</translation>
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
<context>
    <name>ViewHand</name>
    <message>
        <source>What is seen here is not the present: Esc returns to it. To go on from an earlier moment, press Branch here beside the timeline.</source>
        <translation>Wat hier te zien is, is niet het heden: Esc keert ernaar terug. Druk op Hier vertakken naast de tijdlijn om vanaf een eerder moment verder te gaan.</translation>
    </message>
</context>
<context>
    <name>ViewName</name>
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
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Double click: this view alone, and all of them again</source>
        <translation>Dubbelklik: alleen dit aanzicht, en weer alle</translation>
    </message>
</context>
<context>
    <name>ViewReading</name>
    <message>
        <source>Nothing is open</source>
        <translation>Er is niets geopend</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Er is niets geselecteerd</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Geselecteerd: %1</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-weergave</translation>
    </message>
</context>
<context>
    <name>ViewsFeature</name>
    <message>
        <source>Show two or four views first.</source>
        <translation>Toon eerst twee of vier aanzichten.</translation>
    </message>
</context>
<context>
    <name>WarningWatch</name>
    <message>
        <source>Fold</source>
        <translation>Vouw</translation>
    </message>
    <message>
        <source>Wall %1, was %2</source>
        <translation>Wand %1, was %2</translation>
    </message>
    <message>
        <source>Stretched to %1 % of breaking</source>
        <translation>Gerekt tot %1 % van breuk</translation>
    </message>
</context>
<context>
    <name>WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
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
        <source>Timeline</source>
        <translation>Tijdlijn</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Gereedschap</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Aan&amp;zicht</translation>
    </message>
    <message>
        <source>Viewports</source>
        <translation>Aanzichten</translation>
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
        <source>Tool bar</source>
        <translation>Werkbalk</translation>
    </message>
    <message>
        <source>Measure the part</source>
        <translation>Het onderdeel meten</translation>
    </message>
</context>
<context>
    <name>Work</name>
    <message>
        <source>A pipe to another process cannot be made (%1).</source>
        <translation>Een pijp naar een ander proces kan niet worden gemaakt (%1).</translation>
    </message>
    <message>
        <source>The process of %1 cannot be started (%2).</source>
        <translation>Het proces van %1 kan niet worden gestart (%2).</translation>
    </message>
    <message>
        <source>What was read cannot be fetched (%1).</source>
        <translation>Wat is gelezen, kan niet worden opgehaald (%1).</translation>
    </message>
    <message>
        <source>memory access</source>
        <translation>geheugentoegang</translation>
    </message>
    <message>
        <source>arithmetic</source>
        <translation>rekenfout</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>interne fout</translation>
    </message>
    <message>
        <source>illegal instruction</source>
        <translation>ongeldige instructie</translation>
    </message>
    <message>
        <source>ended from outside, perhaps because the machine ran out of memory</source>
        <translation>van buitenaf beëindigd, misschien omdat de machine geen geheugen meer had</translation>
    </message>
    <message>
        <source>signal %1</source>
        <translation>signaal %1</translation>
    </message>
    <message>
        <source>the writer</source>
        <translation>het schrijfprogramma</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>het schrijven</translation>
    </message>
    <message>
        <source>the reader</source>
        <translation>het leesprogramma</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>het lezen</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 minuten</translation>
    </message>
    <message>
        <source> while %1</source>
        <translation> (tijdens &quot;%1&quot;)</translation>
    </message>
    <message>
        <source>%1 took longer than %2%3 and was ended. %4</source>
        <translation>%1 duurde langer dan %2%3 en is beëindigd. %4</translation>
    </message>
    <message>
        <source>%1 crashed%2 (%3). %4</source>
        <translation>%1 liep vast%2 (%3). %4</translation>
    </message>
    <message>
        <source>%1 ended without a result%2. %3</source>
        <translation>%1 eindigde zonder resultaat%2. %3</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc.</translation>
    </message>
</context>
</TS>
