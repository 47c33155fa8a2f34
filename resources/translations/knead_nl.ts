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
        <translation>Er heet al iets „%1”: kies een andere naam.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked in the model tree: unlock it there to change it.</source>
        <translation>„%1” is vergrendeld in de modelboom: ontgrendel het daar om het te wijzigen.</translation>
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
        <translation>„%1” benoemt randen of verbindingen van een andere vulling: ga daar met Ongedaan maken naar terug, of kies ze opnieuw en sla ze onder deze naam op.</translation>
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
        <source>Press it</source>
        <translation>Indrukken</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
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
</context>
<context>
    <name>FileWords</name>
    <message>
        <source>was inside out and has been turned.</source>
        <translation>was binnenstebuiten en is gekeerd.</translation>
    </message>
    <message>
        <source>is not a closed surface: %1. It is shown and cannot be filled.</source>
        <translation>is geen gesloten oppervlak: %1. Het wordt getoond en kan niet worden gevuld.</translation>
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
        <source>has no volume; it cannot be filled.</source>
        <translation>heeft geen volume; het kan niet worden gevuld.</translation>
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
        <source>has faces that do not meet well: its volume is uncertain by %1.</source>
        <translation>heeft vlakken die niet goed aansluiten: zijn volume is %1 onzeker.</translation>
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
        <source>is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file.</source>
        <translation>is onvolledig: %1 van %2 vlakken van een schaal konden worden gelezen; de andere zijn in het bestand beschadigd.</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across</source>
        <translation>%1 in %2, samen %3 lang; de grootste opening is %4 breed</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across and flat</source>
        <translation>%1 in %2, samen %3 lang; de grootste opening is %4 breed en vlak</translation>
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
        <source>The solid was inside out and has been turned.</source>
        <translation>Het lichaam was binnenstebuiten en is gekeerd.</translation>
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
        <source>%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that wrote it.</source>
        <translation>%1: het 3MF-bestand houdt zich op 1 plaats niet aan het formaat; vergelijk de onderdelen met het programma dat het schreef.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that wrote it.</source>
        <translation>%1: het 3MF-bestand houdt zich op %2 plaatsen niet aan het formaat; vergelijk de onderdelen met het programma dat het schreef.</translation>
    </message>
    <message>
        <source>%1: the file states no length unit; millimetres were taken.</source>
        <translation>%1: het bestand noemt geen lengte-eenheid; millimeters zijn genomen.</translation>
    </message>
    <message>
        <source>%1: the entity %2 refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: %3).</source>
        <translation>%1: het element %2 verwijst naar iets verkeerds of naar niets; wat het nodig heeft kon niet worden gelezen (vlakken: %3).</translation>
    </message>
    <message>
        <source>%1: the entity %2 refers to something of the wrong kind or nothing at all; what needs it could not be read (shapes: %3).</source>
        <translation>%1: het element %2 verwijst naar iets verkeerds of naar niets; wat het nodig heeft kon niet worden gelezen (vormen: %3).</translation>
    </message>
    <message>
        <source>%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at all; what needs them could not be read (faces: %4).</source>
        <translation>%1: het element %2 en %3 andere verwijzen naar iets verkeerds of naar niets; wat ze nodig heeft kon niet worden gelezen (vlakken: %4).</translation>
    </message>
    <message>
        <source>%1: the entity %2 and %3 more refer to something of the wrong kind or nothing at all; what needs them could not be read (shapes: %4).</source>
        <translation>%1: het element %2 en %3 andere verwijzen naar iets verkeerds of naar niets; wat ze nodig heeft kon niet worden gelezen (vormen: %4).</translation>
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
        <source>%1: the reader crashed on what the file says beside its shapes; these were read without names, colors and assemblies, and without other files that it refers to.</source>
        <translation>%1: de lezer liep vast op wat het bestand naast zijn vormen zegt; die zijn gelezen zonder namen, kleuren en samenstellingen, en zonder andere bestanden waarnaar het verwijst.</translation>
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
        <source>%1: the part is %2 long; if its lengths are %3, it is %4.</source>
        <translation>%1: het onderdeel is %2 lang; als zijn lengten %3 zijn, is het %4.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4.</source>
        <translation>%1: de onderdelen zijn samen %2 lang; als hun lengten %3 zijn, zijn ze %4.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4. Open that file alone to correct it.</source>
        <translation>%1: het onderdeel is %2 lang; als zijn lengten %3 zijn, is het %4. Open dat bestand alleen om het te verbeteren.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4. Open that file alone to correct it.</source>
        <translation>%1: de onderdelen zijn samen %2 lang; als hun lengten %3 zijn, zijn ze %4. Open dat bestand alleen om het te verbeteren.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimeters</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimeters</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>meters</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>inches</translation>
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
        <source>kilometres</source>
        <translation>kilometers</translation>
    </message>
    <message>
        <source>miles</source>
        <translation>mijlen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no triangles.</source>
        <translation>&quot;%1&quot; heeft geen driehoeken.</translation>
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
        <source>&quot;%1&quot; was left out: %2.</source>
        <translation>&quot;%1&quot; is weggelaten: %2.</translation>
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
        <source>it could not be measured (%1)</source>
        <translation>het kon niet worden gemeten (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>&quot;%1&quot; wordt niet gesimuleerd: %2</translation>
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
        <source>The surface does not bound a volume: its holes are too large to tell inside from outside. Close them and import again.</source>
        <translation>Het oppervlak begrenst geen volume: de gaten zijn te groot om binnen van buiten te onderscheiden. Sluit ze en importeer opnieuw.</translation>
    </message>
    <message>
        <source>The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing.</source>
        <translation>Het onderdeel is te dun voor een afstand van %1: geen cel bevat genoeg materiaal. Kies een kleinere afstand.</translation>
    </message>
    <message>
        <source>its surface passes through itself near %1; other programs may refuse that.</source>
        <translation>het oppervlak gaat door zichzelf heen bij %1; andere programma&apos;s kunnen dat weigeren.</translation>
    </message>
    <message>
        <source>%1 of its faces could not be carried along: %2.</source>
        <translation>%1 van de vlakken konden niet worden meegevoerd: %2.</translation>
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
        <source>its faces do not fit together any more as they are bent now.</source>
        <translation>zo gebogen passen de vlakken niet meer op elkaar.</translation>
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
        <source>it came as a mesh, which has no smooth faces.</source>
        <translation>het kwam als net, dat geen gladde vlakken heeft.</translation>
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
        <source>&quot;%1&quot; is cracked but in one piece: 1 of its connections is broken, and its skin spans the crack, stretched to %2 times its length there near %3.</source>
        <translation>&quot;%1&quot; is gescheurd maar nog één stuk: 1 van de verbindingen is gebroken, en de huid overspant de scheur, bij %3 tot %2 keer de lengte gerekt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: %2 of its connections are broken, and its skin spans the crack, stretched to %3 times its length there near %4.</source>
        <translation>&quot;%1&quot; is gescheurd maar nog één stuk: %2 van de verbindingen zijn gebroken, en de huid overspant de scheur, bij %4 tot %3 keer de lengte gerekt.</translation>
    </message>
    <message>
        <source>too few of its objects hang together to say how it is deformed: it is written in its shape at rest, moved as they have.</source>
        <translation>te weinig objecten hangen samen om te zeggen hoe het vervormd is: het wordt in zijn rustvorm geschreven, verplaatst zoals zij.</translation>
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
        <source>its bent faces were not found again in the file when that was read back.</source>
        <translation>de gebogen vlakken ervan zijn in het teruggelezen bestand niet teruggevonden.</translation>
    </message>
    <message>
        <source>The simulation was stopped at %1 s: %2 It went back to %3 s.</source>
        <translation>De simulatie is bij %1 s gestopt: %2 Ze ging terug naar %3 s.</translation>
    </message>
    <message>
        <source>a position is no longer a number. %1 or make the material softer, then reset.</source>
        <translation>een positie is geen getal meer. %1 of het materiaal zachter maken, dan terugzetten.</translation>
    </message>
    <message>
        <source>objects moved at %1 m/s. %2 or raise the damping ratio, then reset.</source>
        <translation>objecten bewogen met %1 m/s. %2 of de dempingsgraad verhogen, dan terugzetten.</translation>
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
        <source>material of %1 was squashed flat or turned inside out. Press less far, raise Poisson&apos;s ratio or the yield stress, or fill the part with a smaller spacing, then reset.</source>
        <translation>materiaal van %1 is platgedrukt of binnenstebuiten gekeerd. Minder ver drukken, de dwarscontractiecoëfficiënt of de vloeigrens verhogen, of het onderdeel met een kleinere afstand vullen, dan terugzetten.</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>het lichaam</translation>
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
        <source>The tool &quot;%1&quot; begins %2 mm inside %3, which is pushed away with great force, in very short steps. Let it begin outside.</source>
        <translation>Het gereedschap &quot;%1&quot; begint %2 mm binnen in %3, dat met grote kracht en in zeer korte stappen wordt weggeduwd. Laat het erbuiten beginnen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; broke into %2 pieces, and a rigid body would weld them together where they are. Keep it deformable, or reset before it becomes rigid.</source>
        <translation>&quot;%1&quot; is in %2 stukken gebroken, en een star lichaam zou ze vastlassen waar ze zijn. Houd het vervormbaar, of zet terug voordat het star wordt.</translation>
    </message>
    <message>
        <source>The equations of the step at %1 s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter time step.</source>
        <translation>De vergelijkingen van de stap bij %1 s waren niet op te lossen: krachten en posities zijn vanaf daar ruw. Maak gereedschappen langzamer, of kies een kortere tijdstap.</translation>
    </message>
    <message>
        <source>the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, or a softer or more damped material.</source>
        <translation>de gekozen tijdstap van %1 s is langer dan de stabiele van %2 s. Kies een kortere, of een zachter of sterker gedempt materiaal.</translation>
    </message>
    <message>
        <source>the part is torn; this is one of %1 pieces.</source>
        <translation>het onderdeel is gescheurd; dit is een van %1 stukken.</translation>
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
        <source>read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>teruggelezen uit het bestand liggen de gebogen vlakken tot %1 mm naast de huid waar %2 mm is toegestaan.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces enclose a volume %1 % off that of the skin.</source>
        <translation>teruggelezen uit het bestand omsluiten de gebogen vlakken een volume dat %1 % afwijkt van dat van de huid.</translation>
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
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. Fill with a spacing of %4 for %5 cells, about %6 objects.</source>
        <translation>Dunste wanden: %1 cellen over %2; zulke wanden buigen tot %3 % te stijf. Vul met een afstand van %4 voor %5 cellen, ongeveer %6 objecten.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out many times too stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.</source>
        <translation>Dunste wanden: %1 cellen over %2; zulke wanden buigen vele malen te stijf. Vul met een afstand van %3 voor %4 cellen, ongeveer %5 objecten.</translation>
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
        <source>A body is free to move: hold it, or let time run (dynamic) until it rests on something.</source>
        <translation>Een lichaam kan vrij bewegen: houd het vast, of laat de tijd lopen (dynamic) tot het ergens op rust.</translation>
    </message>
    <message>
        <source>%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).</source>
        <translation>%1 is star en kan vrij bewegen: houd het vast, maak het vervormbaar, of laat de tijd lopen (dynamic).</translation>
    </message>
    <message>
        <source>No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps or a smaller load, hold what is free to slide or turn, or let time run (dynamic).</source>
        <translation>Bij %1 s is geen evenwicht gevonden: krachten van %2 van die welke werken zijn over. Neem meer belastingstappen of een kleinere belasting, houd vast wat kan glijden of draaien, of laat de tijd lopen (dynamic).</translation>
    </message>
    <message>
        <source>%1: a turned face is bounded across its seam, and the file does not tell on which side of its border it lies; check the volume of its part.</source>
        <translation>%1: een gedraaid vlak is over zijn naad heen begrensd, en het bestand zegt niet aan welke kant van zijn rand het ligt; controleer het volume van zijn onderdeel.</translation>
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
        <source>its faces were not found again as they were written.</source>
        <translation>de vlakken zijn niet teruggevonden zoals ze geschreven zijn.</translation>
    </message>
    <message>
        <source>read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>teruggelezen uit het bestand liggen de platte vlakken tot %1 mm naast de huid, waar %2 mm is toegestaan.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are inside out.</source>
        <translation>teruggelezen uit het bestand zijn de gebogen vlakken binnenstebuiten.</translation>
    </message>
    <message>
        <source>other programs may read it inside out, as it came back here.</source>
        <translation>andere programma’s lezen het misschien binnenstebuiten, zoals het hier terugkwam.</translation>
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
        <source>Press on the part and pull   Esc: done</source>
        <translation>Op het onderdeel drukken en trekken   Esc: klaar</translation>
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
</context>
<context>
    <name>HelpFeature</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Muis en toetsen</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middle button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit; with Shift or Ctrl pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;7, 0, numeric pad 1, 3&lt;/b&gt;&lt;/td&gt;&lt;td&gt;top, isometric, front, right; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;clicks select parts, faces, edges, objects; Ctrl adds&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;one, two, four views; V: the active view alone&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Linkerknop&lt;/b&gt;&lt;/td&gt;&lt;td&gt;kiezen; gereedschap slepen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Middelste knop&lt;/b&gt;&lt;/td&gt;&lt;td&gt;draaien; met Shift of Ctrl schuiven&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wiel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;naar de aanwijzer zoomen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pijlen, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het gekozen gereedschap rijden; Shift is langzamer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Spatie, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;afspelen of pauzeren, één stap, terugzetten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;blok toevoegen, vlakken vastzetten, verwijderen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zwaartekracht, hernormaliseren&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objecten, lichaam verbergen, randen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;7, 0, numeriek blok 1, 3&lt;/b&gt;&lt;/td&gt;&lt;td&gt;boven, isometrisch, voor, rechts; Ctrl: van de andere kant&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;klikken kiest onderdelen, vlakken, randen, objecten; Ctrl voegt toe&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspectief of parallel, passend&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;het project opslaan; Ctrl+Shift+S onder een andere naam&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;één, twee, vier aanzichten; V: alleen het actieve&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;elke opdracht vinden; F11: volledig scherm&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;annuleren&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
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
    <name>LogPanel</name>
    <message>
        <source>Warning: %1</source>
        <translation>Waarschuwing: %1</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fout: %1</translation>
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
        <source>Open &amp;recent</source>
        <translation>&amp;Recent geopend</translation>
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
        <source>Only a part to which nothing was done yet is pressed like this.</source>
        <translation>Alleen een onderdeel waaraan nog niets is gedaan, wordt zo ingedrukt.</translation>
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
        <source>Drag to move the timeline</source>
        <translation>Sleep om de tijdlijn te verplaatsen</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Weergave</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Selecteer eerst iets.</translation>
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
        <source>Right by left</source>
        <translation>Rechts / links</translation>
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
        <translation>Er is al een materiaal met de naam „%1”: kies een andere naam.</translation>
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
        <source>Largest and mean distance, volume and mass beside the original, and a report (Shift+M)</source>
        <translation>Grootste en gemiddelde afstand, volume en massa naast het origineel, en een verslag (Shift+M)</translation>
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
        <translation>Er is al een selectie met de naam „%1”: kies een andere naam.</translation>
    </message>
    <message>
        <source>Color of the part</source>
        <translation>Kleur van het onderdeel</translation>
    </message>
    <message>
        <source>Color of %1 parts</source>
        <translation>Kleur van %1 onderdelen</translation>
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
        <source>Click places of the part to plot what happens there over time (P)</source>
        <translation>Plaatsen van het onderdeel aanklikken om uit te zetten wat daar in de tijd gebeurt (P)</translation>
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
        <translation>Het werk aan „%1” als project opslaan?</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
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
</context>
<context>
    <name>PullHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties, or push it with a tool.</source>
        <translation>%1 vervormt niet: maak het vervormbaar in de eigenschappen, of duw ertegen met gereedschap.</translation>
    </message>
    <message>
        <source>%1 is held at this place: free it with Fix faces, or pull at another place.</source>
        <translation>%1 is op deze plaats vastgezet: geef het vrij met „Vlakken vastzetten”, of trek op een andere plaats.</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>Trekken aan %1</translation>
    </message>
    <message>
        <source>%1 (limit)</source>
        <translation>%1 (grens)</translation>
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
        <source>%1x real time</source>
        <translation>%1x ware tijd</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>&quot;%1&quot; is not a number here; the value is still %2. Esc restores it.</source>
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
    <message>
        <source>%1: what was seen last cannot be shown. %2 What is whole can be rescued.</source>
        <translation>%1: wat het laatst te zien was, kan niet worden getoond. %2 Wat heel is, kan worden gered.</translation>
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
        <translation>Het niet-opgeslagen werk aan „%1” weggooien? Het kan niet worden teruggehaald.</translation>
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
</context>
<context>
    <name>RunRemarks</name>
    <message>
        <source>Time hardly goes on: %1 were simulated in %2, in steps of %3. A larger spacing, a softer material, slower tools or ones that begin outside the material make it faster.</source>
        <translation>De tijd gaat nauwelijks vooruit: %1 werd in %2 gesimuleerd, in stappen van %3. Een grotere afstand, een zachter materiaal, langzamer gereedschap of gereedschap dat buiten het materiaal begint maken het sneller.</translation>
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
        <translation>%1 doet al „%2”.</translation>
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
        <source>Ctrl+E exports the part as CAD again. Ctrl+K finds any command by a few letters, F1 opens the handbook, and the menu Help repeats this tour.</source>
        <translation>Ctrl+E exporteert het onderdeel weer als CAD. Ctrl+K vindt elke opdracht met een paar letters, F1 opent het handboek, en het menu Help herhaalt deze rondleiding.</translation>
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
    <name>ViewsFeature</name>
    <message>
        <source>Open a part first.</source>
        <translation>Open eerst een onderdeel.</translation>
    </message>
    <message>
        <source>Show two or four views first.</source>
        <translation>Toon eerst twee of vier aanzichten.</translation>
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
    <name>Workbench</name>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 is nog bezig: wacht erop of annuleer met Esc.</translation>
    </message>
</context>
</TS>
