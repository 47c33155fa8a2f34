<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Knead</source>
        <translation>À propos de Knead</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copier les versions</translation>
    </message>
    <message>
        <source>For a report of something that went wrong</source>
        <translation>Pour signaler quelque chose qui n&apos;a pas marché</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;A CAD workbench in which a part is a lump of real material.</source>
        <translation>&lt;b style=&apos;font-size:16pt&apos;&gt;Knead %1&lt;/b&gt;&lt;br&gt;Un atelier de CAO où une pièce est un morceau de vrai matériau.</translation>
    </message>
    <message>
        <source>After Jansson, Horváth and Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</source>
        <translation>D&apos;après Jansson, Horváth et Vergeest, &lt;i&gt;Implementation and analysis of a mechanics simulation module for use in a conceptual design system&lt;/i&gt;, 2000.</translation>
    </message>
    <message>
        <source>Made with</source>
        <translation>Fait avec</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>License</source>
        <translation>Licence</translation>
    </message>
</context>
<context>
    <name>Actions</name>
    <message>
        <source>Put one above the part to push it with</source>
        <translation>En place un au-dessus de la pièce pour la pousser</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Open a part, a project or a recipe</source>
        <translation>Ouvrir une pièce, un projet ou une recette</translation>
    </message>
    <message>
        <source>Open with &amp;choices...</source>
        <translation>Ouvrir avec des &amp;choix...</translation>
    </message>
    <message>
        <source>Look into files and choose parts, detail and units before they are opened</source>
        <translation>Examiner les fichiers et choisir pièces, finesse et unités avant de les ouvrir</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Keep part, history and view in a project file</source>
        <translation>Conserver pièce, historique et vue dans un fichier de projet</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
    <message>
        <source>Keep the project in another file and go on with that</source>
        <translation>Conserver le projet dans un autre fichier et continuer avec celui-ci</translation>
    </message>
    <message>
        <source>Recover &amp;unsaved work...</source>
        <translation>Récupérer le travail &amp;non enregistré...</translation>
    </message>
    <message>
        <source>Look for work that was not saved when Knead ended</source>
        <translation>Chercher le travail qui n&apos;était pas enregistré quand Knead s&apos;est arrêté</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xporter...</translation>
    </message>
    <message>
        <source>Write the deformed part to a file</source>
        <translation>Écrire la pièce déformée dans un fichier</translation>
    </message>
    <message>
        <source>Export as &amp;recipe...</source>
        <translation>Exporter comme &amp;recette...</translation>
    </message>
    <message>
        <source>Write what was done as a recipe, to be read, changed and carried out again</source>
        <translation>Écrire ce qui a été fait comme une recette à lire, à modifier et à exécuter de nouveau</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>Lancer la simulation ou la mettre en pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>One time step</source>
        <translation>Un pas de temps</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Retour au début</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>Let everything weigh something</source>
        <translation>Donner du poids à tout</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Put a floor under the part</source>
        <translation>Mettre un sol sous la pièce</translation>
    </message>
    <message>
        <source>Record &amp;video...</source>
        <translation>Enregistrer une &amp;vidéo...</translation>
    </message>
    <message>
        <source>Make a video of what was simulated, as the view shows it</source>
        <translation>Faire une vidéo de ce qui a été simulé, comme la vue le montre</translation>
    </message>
    <message>
        <source>Record p&amp;ictures...</source>
        <translation>Enregistrer des &amp;images...</translation>
    </message>
    <message>
        <source>Write what was simulated as a sequence of pictures</source>
        <translation>Écrire ce qui a été simulé comme une suite d&apos;images</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormaliser</translation>
    </message>
    <message>
        <source>The selected body, or every one, takes its present shape for its own: stress is gone, the shape stays</source>
        <translation>Le corps choisi, ou chacun, prend sa forme présente pour sienne&#xa0;: la contrainte disparaît, la forme reste</translation>
    </message>
    <message>
        <source>Fix faces</source>
        <translation>Fixer des faces</translation>
    </message>
    <message>
        <source>Click faces of the part to hold them in place</source>
        <translation>Cliquer des faces de la pièce pour les tenir en place</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove the selected tool or fixture</source>
        <translation>Supprimer l&apos;outil ou la fixation choisis</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop what is being done</source>
        <translation>Arrêter ce qui est en cours</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Show the objects the material is made of</source>
        <translation>Montrer les objets dont le matériau est fait</translation>
    </message>
    <message>
        <source>Inner objects too</source>
        <translation>Objets intérieurs aussi</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Open edges</source>
        <translation>Arêtes ouvertes</translation>
    </message>
    <message>
        <source>Show where surfaces that are not closed end</source>
        <translation>Montrer où finissent les surfaces qui ne sont pas fermées</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Hide or show body</source>
        <translation>Cacher ou montrer le corps</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Find a command...</source>
        <translation>Chercher une commande...</translation>
    </message>
    <message>
        <source>Find any command by a few of its letters and do it</source>
        <translation>Trouver toute commande par quelques lettres et l&apos;exécuter</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Préférences...</translation>
    </message>
    <message>
        <source>Theme, language, units, memory, files, view</source>
        <translation>Thème, langue, unités, mémoire, fichiers, vue</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts...</source>
        <translation>Raccourcis &amp;clavier...</translation>
    </message>
    <message>
        <source>Give commands other keys</source>
        <translation>Donner d&apos;autres touches aux commandes</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Put all panels back where they came</source>
        <translation>Remettre tous les panneaux à leur place d&apos;origine</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Souris et touches</translation>
    </message>
    <message>
        <source>About Knead</source>
        <translation>À propos de Knead</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloc</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Boule</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>One view</source>
        <translation>Une vue</translation>
    </message>
    <message>
        <source>One view of the part</source>
        <translation>Une vue de la pièce</translation>
    </message>
    <message>
        <source>Two views</source>
        <translation>Deux vues</translation>
    </message>
    <message>
        <source>Two views of the part, side by side</source>
        <translation>Deux vues de la pièce, côte à côte</translation>
    </message>
    <message>
        <source>Four views</source>
        <translation>Quatre vues</translation>
    </message>
    <message>
        <source>Front, top, right and the free view of the part</source>
        <translation>La pièce de face, de dessus, de droite et en vue libre</translation>
    </message>
    <message>
        <source>Active view alone</source>
        <translation>Vue active seule</translation>
    </message>
    <message>
        <source>Show the active view alone, and all of them again</source>
        <translation>Montrer la vue active seule, puis de nouveau toutes</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Vue suivante</translation>
    </message>
    <message>
        <source>Make the next of several views the active one</source>
        <translation>Rendre active la vue suivante parmi plusieurs</translation>
    </message>
    <message>
        <source>Linked cameras</source>
        <translation>Caméras liées</translation>
    </message>
    <message>
        <source>What is panned or zoomed in one view is in all of them</source>
        <translation>Ce qui est déplacé ou zoomé dans une vue l&apos;est dans toutes</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Chercher l&apos;équilibre</translation>
    </message>
    <message>
        <source>Put the part where forces balance now, without waiting until it is at rest</source>
        <translation>Mettre la pièce là où les forces s&apos;équilibrent maintenant, sans attendre qu&apos;elle soit au repos</translation>
    </message>
    <message>
        <source>Keep up with real time</source>
        <translation>Suivre le temps réel</translation>
    </message>
    <message>
        <source>Where implicit steps are slower than real time, solve them more roughly (forces within 3 % of the largest), then take one per 1/30 s. Without this, time runs slower</source>
        <translation>Quand les pas implicites sont plus lents que le temps réel, ils sont résolus plus grossièrement (forces à 3 % de la plus grande), puis il y en a un par 1/30 s. Sinon, le temps ralentit</translation>
    </message>
    <message>
        <source>Refill as it is</source>
        <translation>Remplir dans sa forme</translation>
    </message>
    <message>
        <source>The selected body, or every one that yields, gets new objects in the shape that it has, and goes on with its stress and motion. Where its lattice is no good any more this happens by itself</source>
        <translation>Le corps choisi, ou chaque corps plastique, reçoit de nouveaux objets dans la forme qu&apos;il a, et garde contraintes et mouvement. Là où son réseau ne vaut plus rien, cela se fait tout seul</translation>
    </message>
    <message>
        <source>Put one above the part to cut it with: the force is the toughness of its material times the width of the cut</source>
        <translation>En placer un au-dessus de la pièce pour la couper : la force est la ténacité de sa matière multipliée par la largeur de la coupe</translation>
    </message>
    <message>
        <source>Cut at section plane</source>
        <translation>Couper au plan de coupe</translation>
    </message>
    <message>
        <source>The selected body, or every one that deforms, is cut in two where the section plane is now, without force</source>
        <translation>Le corps choisi, ou tous ceux qui se déforment, est coupé en deux là où se trouve le plan de coupe, sans force</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Couteau</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Put one above the part to roll it out with: it turns as it is moved</source>
        <translation>En placer un au-dessus de la pièce pour l&apos;étaler : il tourne quand on le déplace</translation>
    </message>
    <message>
        <source>Roller</source>
        <translation>Rouleau</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Presser</translation>
    </message>
    <message>
        <source>Hold one end of the new part and let a block press it, to see what it does</source>
        <translation>Tient la nouvelle pièce par un bout et la presse avec un bloc, pour voir ce qu&apos;elle fait</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>At the page of what one does</source>
        <translation>À la page de ce que l&apos;on fait</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>Nouvelle fenê&amp;tre</translation>
    </message>
    <message>
        <source>Begin something else; what is open here stays</source>
        <translation>Commencer autre chose&#xa0;; ce qui est ouvert ici reste</translation>
    </message>
    <message>
        <source>First pa&amp;ge</source>
        <translation>Première pa&amp;ge</translation>
    </message>
    <message>
        <source>Examples and files of late; the part that is open stays, and Esc comes back</source>
        <translation>Exemples et fichiers récents&#xa0;; la pièce ouverte reste, et Échap y revient</translation>
    </message>
    <message>
        <source>Add &amp;part...</source>
        <translation>Ajouter une &amp;pièce...</translation>
    </message>
    <message>
        <source>Save &amp;picture...</source>
        <translation>Enregistrer une &amp;image...</translation>
    </message>
    <message>
        <source>Write what the view shows as a picture of any size</source>
        <translation>Écrire ce que la vue montre comme image de n&apos;importe quelle taille</translation>
    </message>
    <message>
        <source>Warnings in the view</source>
        <translation>Avertissements dans la vue</translation>
    </message>
    <message>
        <source>Mark where the part is folded over itself, got thin or is about to break</source>
        <translation>Marquer où la pièce est repliée sur elle-même, s&apos;est amincie ou va rompre</translation>
    </message>
    <message>
        <source>&amp;Tour on a block of clay</source>
        <translation>&amp;Visite sur un bloc d&apos;argile</translation>
    </message>
    <message>
        <source>Press it, pull it, export it: in two minutes</source>
        <translation>Presser, tirer, exporter : en deux minutes</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Back to the first page with nothing open; what is not saved is asked about</source>
        <translation>Retour à la première page, sans rien d&apos;ouvert ; ce qui n&apos;est pas enregistré fait l&apos;objet d&apos;une question</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Déformer par des nombres</translation>
    </message>
    <message>
        <source>Bend, twist, taper, stretch, shear or scale the part by numbers between two planes</source>
        <translation>Courber, vriller, effiler, étirer, cisailler ou mettre à l&apos;échelle la pièce par des nombres entre deux plans</translation>
    </message>
    <message>
        <source>&amp;Deform by a field...</source>
        <translation>&amp;Déformer par un champ...</translation>
    </message>
    <message>
        <source>Move the part by displacements that another program computed, or against them</source>
        <translation>Déplacer la pièce selon des déplacements calculés par un autre programme, ou à leur encontre</translation>
    </message>
    <message>
        <source>Bend...</source>
        <translation>Courber...</translation>
    </message>
    <message>
        <source>Bend the part into an arc by an angle or a radius</source>
        <translation>Courber la pièce en arc selon un angle ou un rayon</translation>
    </message>
    <message>
        <source>Twist...</source>
        <translation>Vriller...</translation>
    </message>
    <message>
        <source>Twist the part about an axis by an angle</source>
        <translation>Vriller la pièce autour d&apos;un axe selon un angle</translation>
    </message>
    <message>
        <source>Taper...</source>
        <translation>Effiler...</translation>
    </message>
    <message>
        <source>Make the part thicker or thinner toward one end</source>
        <translation>Épaissir ou amincir la pièce vers une extrémité</translation>
    </message>
    <message>
        <source>Stretch...</source>
        <translation>Étirer...</translation>
    </message>
    <message>
        <source>Make the part longer or shorter between two planes</source>
        <translation>Allonger ou raccourcir la pièce entre deux plans</translation>
    </message>
    <message>
        <source>Shear...</source>
        <translation>Cisailler...</translation>
    </message>
    <message>
        <source>Move one end of the part sideways</source>
        <translation>Déplacer une extrémité de la pièce de côté</translation>
    </message>
    <message>
        <source>Scale between planes...</source>
        <translation>Mettre à l&apos;échelle entre des plans...</translation>
    </message>
    <message>
        <source>Make one end of the part larger or smaller in all directions</source>
        <translation>Agrandir ou réduire une extrémité de la pièce dans toutes les directions</translation>
    </message>
    <message>
        <source>Appl&amp;y to another part...</source>
        <translation>Appli&amp;quer à une autre pièce...</translation>
    </message>
    <message>
        <source>Do what was done here to another part, such as the next revision of this one</source>
        <translation>Faire à une autre pièce, comme la prochaine révision de celle-ci, ce qui a été fait ici</translation>
    </message>
    <message>
        <source>&amp;Python trace</source>
        <translation>Trace &amp;Python</translation>
    </message>
    <message>
        <source>Show what you do as a script for Python, as you do it</source>
        <translation>Montrer ce que vous faites comme script Python, au fur et à mesure</translation>
    </message>
    <message>
        <source>Put the parts of other files beside those that are open, in the shape that these have now</source>
        <translation>Mettre les pièces d&apos;autres fichiers à côté de celles qui sont ouvertes, dans la forme qu&apos;elles ont maintenant</translation>
    </message>
</context>
<context>
    <name>Availability</name>
    <message>
        <source>Open a part first.</source>
        <translation>Ouvrez d&apos;abord une pièce.</translation>
    </message>
    <message>
        <source>Nothing in this part is closed, so nothing can be simulated.</source>
        <translation>Rien dans cette pièce n&apos;est fermé, rien ne peut donc être simulé.</translation>
    </message>
</context>
<context>
    <name>Balance</name>
    <message>
        <source>Load step %1: %2</source>
        <translation>Pas de charge %1 : %2</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Le corps</translation>
    </message>
    <message>
        <source>A body is free to move: hold it, or let time run (dynamic) until it rests on something.</source>
        <translation>Un corps est libre de bouger : tenez-le, ou laissez courir le temps jusqu&apos;à ce qu&apos;il repose sur quelque chose.</translation>
    </message>
    <message>
        <source>A load step takes more than 0 and up to 3600 s.</source>
        <translation>Un pas de charge dure plus de 0 et au plus 3600 s.</translation>
    </message>
    <message>
        <source>%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).</source>
        <translation>%1 est rigide et libre de bouger : tenez-le, rendez-le déformable, ou laissez courir le temps.</translation>
    </message>
    <message>
        <source>No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps or a smaller load, hold what is free to slide or turn, or let time run (dynamic).</source>
        <translation>Aucun équilibre trouvé à %1 s : il reste %2 des forces qui agissent. Prenez plus de pas de charge ou une charge plus petite, tenez ce qui peut glisser ou tourner, ou laissez courir le temps.</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>ColorLegend</name>
    <message>
        <source>Looking back does not keep this of material that has flowed or is pressed: return to the present, or choose displacement or strain.</source>
        <translation>Le regard en arrière ne garde pas cette grandeur là où le matériau s&apos;est écoulé ou est pressé&#xa0;: revenez au présent, ou choisissez déplacement ou déformation.</translation>
    </message>
    <message>
        <source>This moment does not tell it yet: it comes with the next step.</source>
        <translation>Ce moment ne donne pas encore cette grandeur&#xa0;: elle vient avec le prochain pas.</translation>
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
        <translation>Gris</translation>
    </message>
</context>
<context>
    <name>ColorScale</name>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Déformation</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Contrainte de von Mises</translation>
    </message>
    <message>
        <source>Plastic strain</source>
        <translation>Déformation plastique</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Force de contact</translation>
    </message>
    <message>
        <source>Distance to the original</source>
        <translation>Distance à l&apos;original</translation>
    </message>
    <message>
        <source>%1, about ±%2 %</source>
        <translation>%1, environ ±%2 %</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Que voulez-vous faire&#xa0;?</translation>
    </message>
    <message>
        <source>Nothing is called like that: try fewer letters.</source>
        <translation>Rien ne s&apos;appelle ainsi&#xa0;: essayez moins de lettres.</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>Impossible pour l&apos;instant.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>One of the files has no closed part: there is nothing to compare.</source>
        <translation>L&apos;un des fichiers n&apos;a aucune pièce fermée : il n&apos;y a rien à comparer.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of the original belongs to no closed part of the other file.</source>
        <translation>À « %1 » de l&apos;original ne correspond aucune pièce fermée de l&apos;autre fichier.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to no closed part of the original.</source>
        <translation>« %1 » ne correspond à aucune pièce fermée de l&apos;original.</translation>
    </message>
</context>
<context>
    <name>ComparisonDialog</name>
    <message>
        <source>Compare with original</source>
        <translation>Comparer à l&apos;original</translation>
    </message>
    <message>
        <source>How far the skin is from the nearest point of the original surface, at %1 of simulated time. The mean is by area.</source>
        <translation>Distance de la peau au point le plus proche de la surface d&apos;origine, à %1 de temps simulé. La moyenne est pondérée par l&apos;aire.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distance maximale</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Distance moyenne</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Déplacement maximal</translation>
    </message>
    <message>
        <source>Volume at rest</source>
        <translation>Volume au repos</translation>
    </message>
    <message>
        <source>Volume now</source>
        <translation>Volume actuel</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Write report...</source>
        <translation>Écrire un rapport...</translation>
    </message>
    <message>
        <source>A page with these numbers, what was measured and a picture of the view, as PDF or HTML</source>
        <translation>Une page avec ces nombres, ce qui a été mesuré et une image de la vue, en PDF ou HTML</translation>
    </message>
</context>
<context>
    <name>ComparisonFeature</name>
    <message>
        <source>Comparing with the original</source>
        <translation>Comparaison à l&apos;original</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Écrire un rapport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html *.htm)</source>
        <translation>Page web (*.html *.htm)</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distance maximale</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Distance moyenne</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Déplacement maximal</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Center of mass moved</source>
        <translation>Déplacement du centre de masse</translation>
    </message>
    <message>
        <source>%1 beside its original</source>
        <translation>%1 à côté de son original</translation>
    </message>
    <message>
        <source>At %1 of simulated time. Written by Knead on %2.</source>
        <translation>À %1 de temps simulé. Écrit par Knead le %2.</translation>
    </message>
    <message>
        <source>Distances are those of the deformed skin from the nearest point of the original surface; the mean is by area. A displacement is the way of a point of the skin since rest.</source>
        <translation>Les distances sont celles de la peau déformée au point le plus proche de la surface d&apos;origine&#xa0;; la moyenne est pondérée par l&apos;aire. Un déplacement est le chemin d&apos;un point de la peau depuis le repos.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>%1 beside %2</source>
        <translation>%1 à côté de %2</translation>
    </message>
    <message>
        <source>Written by Knead on %1.</source>
        <translation>Écrit par Knead le %1.</translation>
    </message>
    <message>
        <source>Distances are those of each surface from the nearest point of the other, the larger of both; the mean is by area.</source>
        <translation>Les distances sont celles de chaque surface au point le plus proche de l&apos;autre, la plus grande des deux ; la moyenne est pondérée par l&apos;aire.</translation>
    </message>
</context>
<context>
    <name>Compensation</name>
    <message>
        <source>&quot;faces&quot; names face %1 of %2, which has %3; they are numbered from 0.</source>
        <translation>« faces » nomme la face %1 de %2, qui en a %3 ; elles sont numérotées à partir de 0.</translation>
    </message>
    <message>
        <source>&quot;faces&quot; names %1, which is no part of the target; knead info shows their names.</source>
        <translation>« faces » nomme %1, qui n&apos;est pas une pièce de la cible ; knead info montre leurs noms.</translation>
    </message>
    <message>
        <source>Points every %1 would be more than %2; choose a larger &quot;spacing_mm&quot;.</source>
        <translation>Des points tous les %1 seraient plus de %2 ; choisissez un « spacing_mm » plus grand.</translation>
    </message>
    <message>
        <source>The target has no surface; name another part.</source>
        <translation>La cible n&apos;a pas de surface ; nommez une autre pièce.</translation>
    </message>
    <message>
        <source>What came out of round %1 has places that are no numbers; look at what its command wrote.</source>
        <translation>Le résultat de la passe %1 comporte des points qui ne sont pas des nombres ; regardez ce que sa commande a écrit.</translation>
    </message>
</context>
<context>
    <name>Curvature</name>
    <message>
        <source>Curvature</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>concave</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>convexe</translation>
    </message>
</context>
<context>
    <name>Cut</name>
    <message>
        <source>A cut needs a plane: a point, and a normal that is not zero.</source>
        <translation>Une coupe demande un plan : un point, et une normale qui n&apos;est pas nulle.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is rigid, and is not cut. Make it deformable first.</source>
        <translation>« %1 » est rigide et ne se coupe pas. Rendez-le d&apos;abord déformable.</translation>
    </message>
    <message>
        <source>The plane meets nothing of &quot;%1&quot; that could be cut.</source>
        <translation>Le plan ne rencontre rien de « %1 » qui puisse être coupé.</translation>
    </message>
</context>
<context>
    <name>DeformFeature</name>
    <message>
        <source>Fields (%1)</source>
        <translation>Champs (%1)</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Déformer</translation>
    </message>
    <message>
        <source>Come back to the present first: Esc.</source>
        <translation>Revenez d&apos;abord au présent : Échap.</translation>
    </message>
    <message>
        <source>No part is selected: click one in the tree, or choose all parts.</source>
        <translation>Aucune pièce n&apos;est sélectionnée : cliquez-en une dans l&apos;arbre, ou choisissez toutes les pièces.</translation>
    </message>
    <message>
        <source>Deform by a field</source>
        <translation>Déformer par un champ</translation>
    </message>
    <message>
        <source>Projects of Knead</source>
        <translation>Projets de Knead</translation>
    </message>
    <message>
        <source>Scans of the part</source>
        <translation>Scans de la pièce</translation>
    </message>
</context>
<context>
    <name>DeformPanel</name>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Parts are bent, twisted, tapered, stretched, sheared or scaled by numbers here, or by the displacements of another program: File &gt; Deform by a field.</source>
        <translation>Ici, des pièces sont courbées, vrillées, effilées, étirées, cisaillées ou mises à l&apos;échelle par des nombres, ou par les déplacements d&apos;un autre programme : Fichier &gt; Déformer par un champ.</translation>
    </message>
    <message>
        <source>Deform by numbers</source>
        <translation>Déformer par des nombres</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Esc: everything stays as it is</source>
        <translation>Échap : tout reste en l&apos;état</translation>
    </message>
    <message>
        <source>Enter in the view: the parts become what is shown</source>
        <translation>Entrée dans la vue : les pièces deviennent ce qui est montré</translation>
    </message>
</context>
<context>
    <name>DeformStage</name>
    <message>
        <source>Something else was done while the parts were deformed, so they stay as they are. Apply the deformation again.</source>
        <translation>Autre chose a été fait pendant que les pièces étaient déformées, elles restent donc en l&apos;état. Appliquez la déformation de nouveau.</translation>
    </message>
</context>
<context>
    <name>Deformation</name>
    <message>
        <source>The field has %1 nodes, but %2 displacements.</source>
        <translation>Le champ a %1 nœuds, mais %2 déplacements.</translation>
    </message>
    <message>
        <source>Node %1 of the field has a number that is not finite, or far too large; leave that node out, or write the file again.</source>
        <translation>Le nœud %1 du champ a un nombre qui n’est pas fini, ou bien trop grand ; omettez ce nœud, ou écrivez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>A bend of %1 mm radius would fold the material on its inner side, which reaches %2 mm from the neutral plane. The radius must be larger than that: take a smaller angle, planes farther apart, or a neutral plane nearer to the inner side.</source>
        <translation>Une courbure de %1 mm de rayon replierait la matière du côté intérieur, qui s’étend jusqu’à %2 mm du plan neutre. Le rayon doit être plus grand : prenez un angle plus petit, des plans plus éloignés ou un plan neutre plus proche du côté intérieur.</translation>
    </message>
    <message>
        <source>A direction of no length is none; give x, y, z, or three numbers.</source>
        <translation>Une direction sans longueur n&apos;en est pas une ; donnez x, y, z ou trois nombres.</translation>
    </message>
    <message>
        <source>The side runs along the axis, but must lie across it; choose another one.</source>
        <translation>Le côté suit l&apos;axe, mais doit lui être transversal ; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Only a bend has a radius and a plane that keeps its length; leave them out.</source>
        <translation>Seule une flexion a un rayon et un plan qui garde sa longueur ; omettez-les.</translation>
    </message>
    <message>
        <source>The plane that keeps its length is given twice, by its place and by a k factor; leave one of them out.</source>
        <translation>Le plan qui garde sa longueur est donné deux fois, par son lieu et par un facteur k ; omettez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>A k factor is between 0, inside, and 1, outside.</source>
        <translation>Un facteur k est compris entre 0, à l&apos;intérieur, et 1, à l&apos;extérieur.</translation>
    </message>
    <message>
        <source>Angle and radius say where the bend ends; leave out the second plane.</source>
        <translation>L&apos;angle et le rayon disent où la flexion se termine ; omettez le second plan.</translation>
    </message>
    <message>
        <source>The radius of a bend must be larger than 0.</source>
        <translation>Le rayon d&apos;une flexion doit être supérieur à 0.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Neutral plane</source>
        <translation>Plan neutre</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Courber</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Tordre</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Effiler</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirer</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisailler</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Mettre à l’échelle</translation>
    </message>
    <message>
        <source>%1 of %2 parts came back from being deformed; nothing was changed.</source>
        <translation>%1 pièces sur %2 sont revenues déformées ; rien n&apos;a été changé.</translation>
    </message>
    <message>
        <source>%1 takes %2; this is &quot;%3&quot;.</source>
        <translation>%1 attend %2 ; ceci est « %3 ».</translation>
    </message>
    <message>
        <source>%1 says nothing about what stands before it; put it behind the deformation that it is for.</source>
        <translation>%1 ne dit rien de ce qui le précède ; mettez-le derrière la déformation qu&apos;il concerne.</translation>
    </message>
    <message>
        <source>No folder could be made in %1; make room there and try again.</source>
        <translation>Aucun dossier n&apos;a pu être créé dans %1 ; faites-y de la place et réessayez.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3, numbered from 0, and meshes have none.</source>
        <translation>« %1 » n&apos;a pas de face %2 ; il en a %3, numérotées à partir de 0, et les maillages n&apos;en ont pas.</translation>
    </message>
    <message>
        <source>Which part the faces %1 are of is not clear; put its name before them, as Lid:%1.</source>
        <translation>On ne sait pas de quelle pièce sont les faces %1 ; mettez son nom devant, comme Couvercle:%1.</translation>
    </message>
    <message>
        <source>%1 parts that are deformed are called &quot;%2&quot;, not one; knead info --json lists the names and paths of all.</source>
        <translation>%1 pièces à déformer s&apos;appellent « %2 », et non une ; knead info --json donne les noms et chemins de toutes.</translation>
    </message>
    <message>
        <source>it has no surface to be deformed.</source>
        <translation>il n&apos;a pas de surface à déformer.</translation>
    </message>
    <message>
        <source>There is no part or assembly &quot;%1&quot; in %2; knead info --json lists the names and paths of all.</source>
        <translation>Il n&apos;y a ni pièce ni assemblage « %1 » dans %2 ; knead info --json donne les noms et chemins de tous.</translation>
    </message>
    <message>
        <source>The field has no nodes.</source>
        <translation>Le champ n’a pas de nœuds.</translation>
    </message>
    <message>
        <source>The factor of a deformation is no number.</source>
        <translation>Le facteur d’une déformation n’est pas un nombre.</translation>
    </message>
    <message>
        <source>Faces that stay where they are need a distance over which the deformation fades.</source>
        <translation>Les faces qui restent en place demandent une distance sur laquelle la déformation s’estompe.</translation>
    </message>
    <message>
        <source>A face that stays where it is has a corner that is no place.</source>
        <translation>Une face qui reste en place a un sommet qui n’est pas un lieu.</translation>
    </message>
    <message>
        <source>The axis of a deformation has a coordinate that is no number.</source>
        <translation>L&apos;axe d&apos;une déformation a une coordonnée qui n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>A deformation by number has a value that is no number.</source>
        <translation>Une déformation par nombres a une valeur qui n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>The second plane of a deformation must lie behind the first one, along its axis.</source>
        <translation>Le second plan d&apos;une déformation doit se trouver derrière le premier, le long de son axe.</translation>
    </message>
    <message>
        <source>The side of a deformation must point across its axis.</source>
        <translation>Le côté d&apos;une déformation doit être transversal à son axe.</translation>
    </message>
    <message>
        <source>A bend or a twist goes around ten times at most: take a smaller angle, or a larger radius.</source>
        <translation>Une flexion ou une torsion fait au plus dix tours : prenez un angle plus petit ou un rayon plus grand.</translation>
    </message>
    <message>
        <source>What stays of a deformation lies between its planes: from 0 at the first one to 1 at the second one.</source>
        <translation>Ce qui reste en place lors d&apos;une déformation est entre ses plans : de 0 au premier à 1 au second.</translation>
    </message>
    <message>
        <source>The factor of a deformation must be larger than 0.</source>
        <translation>Le facteur d&apos;une déformation doit être supérieur à 0.</translation>
    </message>
    <message>
        <source>A gentle stretch cannot shorten to less than 0.47: the middle would fold. Take a larger factor, or do not ease it.</source>
        <translation>Un étirement doux ne peut pas raccourcir à moins de 0,47 : le milieu se replierait. Prenez un facteur plus grand, ou ne l&apos;adoucissez pas.</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Le corps</translation>
    </message>
    <message>
        <source>Deforming by physics takes 0.01 to 3600 s.</source>
        <translation>Déformer par la physique prend de 0,01 à 3600 s.</translation>
    </message>
    <message>
        <source>%1 lies wholly beyond one of the planes, so that it would only be carried along. Put the planes where it is to be deformed.</source>
        <translation>%1 se trouve entièrement au-delà d’un des plans et serait seulement emporté. Placez les plans là où il doit être déformé.</translation>
    </message>
    <message>
        <source>Nothing of %1 is free between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Rien de %1 n’est libre entre les plans : écartez-les, ou remplissez avec un espacement plus petit.</translation>
    </message>
    <message>
        <source>%1 does not reach both planes, so that grips cannot hold it on both sides. Put the planes where it is, or at its ends.</source>
        <translation>%1 n’atteint pas les deux plans, si bien que les prises ne peuvent pas le tenir des deux côtés. Placez les plans là où il est, ou à ses extrémités.</translation>
    </message>
    <message>
        <source>Physics bends, twists, stretches and shears, which grips at the ends can do. &quot;%1&quot; changes the ends themselves: do it exactly.</source>
        <translation>La physique courbe, tord, étire et cisaille, ce que des prises aux extrémités savent faire. « %1 » change les extrémités elles-mêmes : faites-le exactement.</translation>
    </message>
    <message>
        <source>There is no part that could be deformed.</source>
        <translation>Il n’y a aucune pièce qui puisse être déformée.</translation>
    </message>
    <message>
        <source>%1 is rigid: physics deforms what can be deformed. Make it deformable first.</source>
        <translation>%1 est rigide : la physique déforme ce qui est déformable. Rendez-le d’abord déformable.</translation>
    </message>
    <message>
        <source>Less than two spacings of %1 lie between the planes: move them apart, or fill it with a smaller spacing.</source>
        <translation>Moins de deux espacements de %1 se trouvent entre les plans : écartez-les, ou remplissez avec un espacement plus petit.</translation>
    </message>
    <message>
        <source>--physics does one bend, twist, stretch or shear at a time; give one of them, and for more write a recipe.</source>
        <translation>--physics fait une courbure, une torsion, un étirement ou un cisaillement à la fois ; donnez-en un, et écrivez une recette pour plus.</translation>
    </message>
    <message>
        <source>--physics deforms one part or all of them; for some write a recipe.</source>
        <translation>--physics déforme une pièce ou toutes ; pour quelques-unes, écrivez une recette.</translation>
    </message>
    <message>
        <source>--physics needs to know what the part is made of: give --material, one of %1.</source>
        <translation>--physics doit savoir de quoi la pièce est faite : donnez --material, un de %1.</translation>
    </message>
    <message>
        <source>There is no material &quot;%1&quot;; --material is one of %2.</source>
        <translation>Il n’y a pas de matériau « %1 » ; --material est un de %2.</translation>
    </message>
    <message>
        <source>%1: the ending is none of %2; name the file after its format.</source>
        <translation>%1 : l’extension n’est aucune de %2 ; nommez le fichier d’après son format.</translation>
    </message>
    <message>
        <source>A part is filled with %1 objects at least.</source>
        <translation>Une pièce est remplie d’au moins %1 objets.</translation>
    </message>
</context>
<context>
    <name>Deforming</name>
    <message>
        <source>Preview: %1</source>
        <translation>Aperçu : %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Preview: deformed by %1</source>
        <translation>Aperçu : déformé par %1</translation>
    </message>
    <message>
        <source>The field turns material inside out near %1, %2, %3 mm. Take a smaller factor.</source>
        <translation>Le champ retourne la matière près de %1, %2, %3 mm. Prenez un facteur plus petit.</translation>
    </message>
    <message>
        <source>Deformed by %1</source>
        <translation>Déformé par %1</translation>
    </message>
    <message>
        <source>Deformed by %1, times %2</source>
        <translation>Déformé par %1, fois %2</translation>
    </message>
    <message>
        <source>Deforming by %1</source>
        <translation>Déformation par %1</translation>
    </message>
    <message>
        <source>The second plane must lie behind the first one, along the axis.</source>
        <translation>Le second plan doit se trouver derrière le premier, le long de l&apos;axe.</translation>
    </message>
    <message>
        <source>Select a flat face first, whose normal is to be the axis.</source>
        <translation>Sélectionnez d&apos;abord une face plane dont la normale sera l&apos;axe.</translation>
    </message>
    <message>
        <source>The bend is tighter than the material allows, which would fold: at least a radius of %1, or at most %2 between these planes.</source>
        <translation>La courbure est plus serrée que la matière ne le permet, qui se replierait : un rayon d&apos;au moins %1, ou au plus %2 entre ces plans.</translation>
    </message>
    <message>
        <source>Bent by %1</source>
        <translation>Courbé de %1</translation>
    </message>
    <message>
        <source>Twisted by %1</source>
        <translation>Vrillé de %1</translation>
    </message>
    <message>
        <source>Tapered to %1</source>
        <translation>Effilé à %1</translation>
    </message>
    <message>
        <source>Stretched to %1</source>
        <translation>Étiré à %1</translation>
    </message>
    <message>
        <source>Sheared by %1</source>
        <translation>Cisaillé de %1</translation>
    </message>
    <message>
        <source>Scaled to %1</source>
        <translation>Mis à l&apos;échelle %1</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Twisting</source>
        <translation>Vrillage</translation>
    </message>
    <message>
        <source>Tapering</source>
        <translation>Effilage</translation>
    </message>
    <message>
        <source>Stretching</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>Shearing</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Mise à l&apos;échelle</translation>
    </message>
    <message>
        <source>%1 by physics</source>
        <translation>%1 par la physique</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Show the surface of the part; as through glass when what is inside is shown too</source>
        <translation>Montrer la surface de la pièce&#xa0;; comme à travers du verre quand l&apos;intérieur est montré aussi</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Show the connections between objects as lines</source>
        <translation>Montrer les liaisons entre objets par des lignes</translation>
    </message>
    <message>
        <source>Original shape</source>
        <translation>Forme d&apos;origine</translation>
    </message>
    <message>
        <source>Show the shape at rest, translucent, around what became of it</source>
        <translation>Montrer la forme au repos, translucide, autour de ce qu&apos;elle est devenue</translation>
    </message>
    <message>
        <source>Broken connections</source>
        <translation>Liaisons rompues</translation>
    </message>
    <message>
        <source>Mark where connections broke</source>
        <translation>Marquer où des liaisons ont rompu</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Plan de coupe</translation>
    </message>
    <message>
        <source>Cut the part open to look inside; drag the knob to move the plane</source>
        <translation>Couper la pièce pour regarder à l&apos;intérieur&#xa0;; tirez la poignée pour déplacer le plan</translation>
    </message>
    <message>
        <source>Flip section</source>
        <translation>Inverser la coupe</translation>
    </message>
    <message>
        <source>Cut off the other side</source>
        <translation>Couper l&apos;autre côté</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Avant et après</translation>
    </message>
    <message>
        <source>Divide the view: the original on the left, the part as it is on the right</source>
        <translation>Diviser la vue&#xa0;: l&apos;original à gauche, la pièce telle qu&apos;elle est à droite</translation>
    </message>
    <message>
        <source>Part colors</source>
        <translation>Couleurs de la pièce</translation>
    </message>
    <message>
        <source>Faces have the colors of the part</source>
        <translation>Les faces ont les couleurs de la pièce</translation>
    </message>
    <message>
        <source>Color the skin by: %1</source>
        <translation>Colorer la peau selon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>What is shown of the material, and how</source>
        <translation>Ce qui est montré du matériau, et comment</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>From which colors to which numbers are shown</source>
        <translation>Avec quelles couleurs les nombres sont montrés</translation>
    </message>
    <message>
        <source>Range as needed</source>
        <translation>Plage selon les besoins</translation>
    </message>
    <message>
        <source>The colors reach as far as the numbers do</source>
        <translation>Les couleurs vont aussi loin que les nombres</translation>
    </message>
    <message>
        <source>This quantity has colors of its own, since it has two signs.</source>
        <translation>Cette grandeur a ses propres couleurs, puisqu&apos;elle a deux signes.</translation>
    </message>
    <message>
        <source>Color the skin by a quantity first.</source>
        <translation>Colorez d&apos;abord la peau selon une grandeur.</translation>
    </message>
    <message>
        <source>Section across X</source>
        <translation>Coupe perpendiculaire à X</translation>
    </message>
    <message>
        <source>Section across Y</source>
        <translation>Coupe perpendiculaire à Y</translation>
    </message>
    <message>
        <source>Section across Z</source>
        <translation>Coupe perpendiculaire à Z</translation>
    </message>
    <message>
        <source>Section towards the eye</source>
        <translation>Coupe face à l&apos;œil</translation>
    </message>
    <message>
        <source>Cut the part open through its middle</source>
        <translation>Couper la pièce par son milieu</translation>
    </message>
    <message>
        <source>Hatched</source>
        <translation>Hachuré</translation>
    </message>
    <message>
        <source>Draw lines across what is cut</source>
        <translation>Tracer des lignes sur ce qui est coupé</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Color map: %1</source>
        <translation>Échelle de couleurs : %1</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Habituel</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Argile</translation>
    </message>
    <message>
        <source>Polished</source>
        <translation>Poli</translation>
    </message>
    <message>
        <source>Zebra</source>
        <translation>Zèbre</translation>
    </message>
    <message>
        <source>Faces have the colors of the part, in soft light</source>
        <translation>Les faces ont les couleurs de la pièce, en lumière douce</translation>
    </message>
    <message>
        <source>All parts in one matt color: nothing but their shape is seen</source>
        <translation>Toutes les pièces en une couleur mate : on ne voit que leur forme</translation>
    </message>
    <message>
        <source>Parts shine as polished metal does</source>
        <translation>Les pièces brillent comme du métal poli</translation>
    </message>
    <message>
        <source>Parts mirror stripes, which break where faces do not join smoothly</source>
        <translation>Les pièces reflètent des bandes, qui se brisent là où les faces ne se raccordent pas en douceur</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Ombrage</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Cire</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>Chrome</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porcelaine</translation>
    </message>
    <message>
        <source>Blue where parts are hollow, white where they are flat, orange where they bulge</source>
        <translation>Bleu où les pièces sont creuses, blanc où elles sont planes, orange où elles sont bombées</translation>
    </message>
    <message>
        <source>Parts are soft and shine through at their rims</source>
        <translation>Les pièces paraissent douces et translucides sur leurs bords</translation>
    </message>
    <message>
        <source>All parts mirror a sky and the ground, which shows every dent</source>
        <translation>Toutes les pièces reflètent un ciel et le sol, ce qui montre chaque creux</translation>
    </message>
    <message>
        <source>All parts are white and glazed</source>
        <translation>Toutes les pièces sont blanches et émaillées</translation>
    </message>
</context>
<context>
    <name>DisplayPanel</name>
    <message>
        <source>Map</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>De, à</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Colors of the skin</source>
        <translation>Couleurs de la peau</translation>
    </message>
    <message>
        <source>All have even lightness; cividis looks nearly alike to people who see few colors</source>
        <translation>Toutes ont une clarté régulière&#xa0;; cividis paraît presque pareille à qui distingue peu de couleurs</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Voir l&apos;intérieur</translation>
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
        <translation>Vers l&apos;œil</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Drag the line in the view: the original on the left, now on the right.</source>
        <translation>Tirez la ligne dans la vue&#xa0;: l&apos;original à gauche, l&apos;état actuel à droite.</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Ombrage</translation>
    </message>
    <message>
        <source>Place of the section plane</source>
        <translation>Position du plan de coupe</translation>
    </message>
</context>
<context>
    <name>DividerHandle</name>
    <message>
        <source>Drag: the original on the left, the part as it is on the right</source>
        <translation>Tirez&#xa0;: l&apos;original à gauche, la pièce telle qu&apos;elle est à droite</translation>
    </message>
    <message>
        <source>Divider between before and after</source>
        <translation>Séparation entre avant et après</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>The recipe belongs to the filling before and does not go on in this one. Undo goes back to it.</source>
        <translation>La recette appartient au remplissage précédent et ne continue pas dans celui-ci. Annuler y ramène.</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>Remplir %1 de nouveau</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.</source>
        <translation>«&#xa0;%1&#xa0;» est un maillage sans faces de CAO&#xa0;: ouvrez-le en STEP, IGES ou BREP pour fixer des faces.</translation>
    </message>
    <message>
        <source>Fix face</source>
        <translation>Fixer la face</translation>
    </message>
    <message>
        <source>Free face</source>
        <translation>Libérer la face</translation>
    </message>
    <message>
        <source>%1 holds no objects: its faces are smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>%1 ne tient aucun objet&#xa0;: ses faces sont plus petites que l&apos;espacement. Choisissez un espacement plus fin et remplissez de nouveau.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simuler</translation>
    </message>
    <message>
        <source>Going to %1</source>
        <translation>En route vers %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then go to %2.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap, puis allez à %2.</translation>
    </message>
    <message>
        <source>Branching from %1</source>
        <translation>Bifurcation depuis %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then branch again.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap, puis bifurquez de nouveau.</translation>
    </message>
    <message>
        <source>Branch at %1</source>
        <translation>Branche à %1</translation>
    </message>
    <message>
        <source>The recipe has come to its end. Play goes on without it.</source>
        <translation>La recette est finie. Lecture continue sans elle.</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>Renommer en %1</translation>
    </message>
    <message>
        <source>Color of %1</source>
        <translation>Couleur de %1</translation>
    </message>
    <message>
        <source>Something is called &quot;%1&quot; already: choose another name.</source>
        <translation>Quelque chose s&apos;appelle déjà «&#xa0;%1&#xa0;»&#xa0;: choisissez un autre nom.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked in the model tree: unlock it there to change it.</source>
        <translation>«&#xa0;%1&#xa0;» est verrouillé dans l&apos;arbre du modèle&#xa0;: déverrouillez-le là pour le modifier.</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Fixer la sélection</translation>
    </message>
    <message>
        <source>The selection holds no objects: it is smaller than the spacing. Choose a finer spacing and refill.</source>
        <translation>La sélection ne tient aucun objet&#xa0;: elle est plus petite que l&apos;espacement. Choisissez un espacement plus fin et remplissez de nouveau.</translation>
    </message>
    <message>
        <source>Material of selection</source>
        <translation>Matériau de la sélection</translation>
    </message>
    <message>
        <source>Material of selection → %1</source>
        <translation>Matériau de la sélection → %1</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Renormaliser la sélection</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names edges or connections of another filling: undo to go back to that, or select them again and save them under this name.</source>
        <translation>«&#xa0;%1&#xa0;» désigne des arêtes ou des liaisons d&apos;un autre remplissage&#xa0;: annulez pour y revenir, ou sélectionnez-les de nouveau et enregistrez-les sous ce nom.</translation>
    </message>
    <message>
        <source>There is not enough memory to go to %1. Close other programs and try again.</source>
        <translation>La mémoire ne suffit pas pour aller à %1. Fermez d&apos;autres programmes et réessayez.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then find the balance.</source>
        <translation>%1 est encore en cours : attendez, ou annulez avec Échap, puis cherchez l&apos;équilibre.</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Chercher l&apos;équilibre</translation>
    </message>
    <message>
        <source>Finding the balance</source>
        <translation>Recherche de l&apos;équilibre</translation>
    </message>
    <message>
        <source>In balance: no force acts on the part.</source>
        <translation>En équilibre : aucune force n&apos;agit sur la pièce.</translation>
    </message>
    <message>
        <source>In balance: the forces that are left are %1 of those that act.</source>
        <translation>En équilibre : les forces qui restent sont %1 de celles qui agissent.</translation>
    </message>
    <message>
        <source>No body is of material that yields: elastic ones keep their shape at rest, and are not filled anew.</source>
        <translation>Aucun corps n&apos;est d&apos;un matériau plastique : les corps élastiques gardent leur forme au repos et ne sont pas remplis de nouveau.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloc</translation>
    </message>
    <message>
        <source>Press it</source>
        <translation>Presser</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, then deform again.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap, puis déformez de nouveau.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Add %1 and others</source>
        <translation>Ajouter %1 et d&apos;autres</translation>
    </message>
</context>
<context>
    <name>EntryNames</name>
    <message>
        <source>Material of %1</source>
        <translation>Matériau de %1</translation>
    </message>
    <message>
        <source>%1 becomes rigid</source>
        <translation>%1 devient rigide</translation>
    </message>
    <message>
        <source>%1 becomes glue</source>
        <translation>%1 devient colle</translation>
    </message>
    <message>
        <source>%1 becomes deformable</source>
        <translation>%1 devient déformable</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormaliser</translation>
    </message>
    <message>
        <source>Gravity off</source>
        <translation>Pesanteur désactivée</translation>
    </message>
    <message>
        <source>Gravity on</source>
        <translation>Pesanteur activée</translation>
    </message>
    <message>
        <source>Floor on</source>
        <translation>Sol activé</translation>
    </message>
    <message>
        <source>Floor off</source>
        <translation>Sol désactivé</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Arrêter %1</translation>
    </message>
    <message>
        <source>Push with %1</source>
        <translation>Pousser avec %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Fix %1</source>
        <translation>Fixer %1</translation>
    </message>
    <message>
        <source>Semi-implicit steps</source>
        <translation>Pas semi-implicites</translation>
    </message>
    <message>
        <source>Forward steps</source>
        <translation>Pas explicites avant</translation>
    </message>
    <message>
        <source>Implicit steps</source>
        <translation>Pas implicites</translation>
    </message>
    <message>
        <source>Automatic steps</source>
        <translation>Pas automatiques</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>le corps</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>l&apos;outil</translation>
    </message>
    <message>
        <source>the fixture</source>
        <translation>la fixation</translation>
    </message>
    <message>
        <source>the load</source>
        <translation>la charge</translation>
    </message>
    <message>
        <source>Simulate %1</source>
        <translation>Simuler %1</translation>
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
        <translation>Aspect d&apos;une pièce</translation>
    </message>
    <message>
        <source>Look of %1</source>
        <translation>Aspect de %1</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>Renommer en %1</translation>
    </message>
    <message>
        <source>Find balance</source>
        <translation>Chercher l&apos;équilibre</translation>
    </message>
    <message>
        <source>Refill %1</source>
        <translation>Remplir %1 de nouveau</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Couper %1</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>&quot;%1&quot; is cut into or cracked, but in one piece: it gapes by %2 mm.</source>
        <translation>«&#xa0;%1&#xa0;» est entaillée ou fissurée mais d&apos;un seul tenant&#xa0;: elle bâille de %2 mm.</translation>
    </message>
    <message>
        <source>a cut or crack ends in it, whose sides are no faces of the part.</source>
        <translation>une coupe ou une fissure s&apos;y termine, dont les côtés ne sont pas des faces de la pièce.</translation>
    </message>
    <message>
        <source>it was filled anew before: its fields are left out.</source>
        <translation>elle a été remplie de nouveau auparavant&#xa0;: ses champs sont omis.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: 1 of its connections is broken, and its skin spans the crack, stretched to %2 times its length there near %3.</source>
        <translation>« %1 » est fissurée mais d&apos;un seul tenant : 1 de ses liaisons est rompue, et la peau enjambe la fissure, étirée à %2 fois sa longueur près de %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is cracked but in one piece: %2 of its connections are broken, and its skin spans the crack, stretched to %3 times its length there near %4.</source>
        <translation>« %1 » est fissurée mais d&apos;un seul tenant : %2 de ses liaisons sont rompues, et la peau enjambe la fissure, étirée à %3 fois sa longueur près de %4.</translation>
    </message>
    <message>
        <source>its cracks could not be made into surfaces: other pieces of it are written as one with it; objects in them: %1.</source>
        <translation>ses fissures n&apos;ont pas pu devenir des surfaces : d&apos;autres morceaux sont écrits avec lui comme un seul ; objets qu&apos;ils contiennent : %1.</translation>
    </message>
    <message>
        <source>pieces too small for a shape of their own are written as part of it; objects in them: %1.</source>
        <translation>des morceaux trop petits pour une forme propre sont écrits comme en faisant partie ; objets qu&apos;ils contiennent : %1.</translation>
    </message>
    <message>
        <source>cracks end in it, and its skin spans them; connections broken there: %1.</source>
        <translation>des fissures s&apos;y terminent, et la peau les enjambe&#xa0;; liaisons rompues à cet endroit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>the part is torn; this is one of %1 pieces.</source>
        <translation>la pièce est déchirée ; ceci est l&apos;un de ses %1 morceaux.</translation>
    </message>
    <message>
        <source>too few of its objects hang together to say how it is deformed: it is written in its shape at rest, moved as they have.</source>
        <translation>trop peu de ses objets tiennent ensemble pour dire comment elle est déformée : elle est écrite dans sa forme au repos, déplacée comme eux.</translation>
    </message>
    <message>
        <source>%1 of its faces could not be carried along: %2.</source>
        <translation>%1 de ses faces n&apos;ont pas pu être entraînées : %2.</translation>
    </message>
    <message>
        <source>its faces do not fit together any more as they are bent now.</source>
        <translation>ainsi courbées, ses faces ne s&apos;ajustent plus entre elles.</translation>
    </message>
    <message>
        <source>1 face was added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>1 face a été ajoutée : celles qui se referment sur elles-mêmes sont venues en deux, ce que d&apos;autres programmes lisent plus sûrement.</translation>
    </message>
    <message>
        <source>%1 faces were added: those that close in themselves came in two, which other programs read more surely.</source>
        <translation>%1 faces ont été ajoutées : celles qui se referment sur elles-mêmes sont venues en deux, ce que d&apos;autres programmes lisent plus sûrement.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 is made of flat triangles; its other faces are smooth.</source>
        <translation>« %1 » : la face %2 est faite de triangles plans ; ses autres faces sont lisses.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: faces %2 are made of flat triangles; its other faces are smooth.</source>
        <translation>« %1 » : les faces %2 sont faites de triangles plans ; ses autres faces sont lisses.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off.</source>
        <translation>« %1 » : la face %2 n&apos;approche pas la peau d&apos;aussi près que visé, %3 mm ; la face %4 en est à %5 mm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off.</source>
        <translation>« %1 » : %2 faces, %3, n&apos;approchent pas la peau d&apos;aussi près que visé, %4 mm ; la face %5 en est à %6 mm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would need %2 flat faces, more than CAD programs can work with; export it as a mesh.</source>
        <translation>« %1 » demanderait %2 faces planes, plus que n&apos;en traitent les programmes de CAO ; exportez-la comme maillage.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an open mesh, which CAD files cannot hold; hide it, or export as a mesh.</source>
        <translation>« %1 » est un maillage ouvert, que les fichiers de CAO ne peuvent contenir ; masquez-la ou exportez comme maillage.</translation>
    </message>
    <message>
        <source>it came as a mesh, which has no smooth faces.</source>
        <translation>elle est venue comme maillage, qui n&apos;a pas de faces lisses.</translation>
    </message>
    <message>
        <source>its faces could not be cut where the knife went.</source>
        <translation>ses faces n&apos;ont pas pu être coupées là où le couteau est passé.</translation>
    </message>
    <message>
        <source>other programs may read it inside out, as it came back here.</source>
        <translation>d&apos;autres programmes peuvent la lire retournée, comme elle est revenue ici.</translation>
    </message>
    <message>
        <source>its faces were not found again as they were written.</source>
        <translation>ses faces n&apos;ont pas été retrouvées telles qu&apos;elles ont été écrites.</translation>
    </message>
    <message>
        <source>faces that met smoothly now meet at an angle near %1; a smaller tolerance may help.</source>
        <translation>des faces qui se rejoignaient en douceur forment maintenant un angle près de %1 ; une tolérance plus petite peut aider.</translation>
    </message>
    <message>
        <source>The file holds %1 parts where %2 were written.</source>
        <translation>Le fichier contient %1 pièces alors que %2 ont été écrites.</translation>
    </message>
    <message>
        <source>The exact shapes of the parts are not complete; import the file again.</source>
        <translation>Les formes exactes des pièces ne sont pas complètes&#xa0;; importez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>its bent faces were not found again in the file when that was read back.</source>
        <translation>ses faces déformées n&apos;ont pas été retrouvées dans le fichier relu.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are inside out.</source>
        <translation>relues du fichier, ses faces courbées sont retournées.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces do not pass the geometry checks.</source>
        <translation>relues dans le fichier, ses faces courbées ne passent pas les contrôles de géométrie.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces leave gaps.</source>
        <translation>relues dans le fichier, ses faces courbées laissent des jours.</translation>
    </message>
    <message>
        <source>read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>relues depuis le fichier, ses faces à facettes s&apos;écartent de la peau de %1 mm au plus, alors que %2 mm sont permis.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed.</source>
        <translation>relues dans le fichier, ses faces courbées s&apos;écartent de la peau jusqu&apos;à %1 mm alors que %2 mm sont permis.</translation>
    </message>
    <message>
        <source>read back from the file, its bent faces enclose a volume %1 % off that of the skin.</source>
        <translation>relues dans le fichier, ses faces courbées enferment un volume qui diffère de %1 % de celui de la peau.</translation>
    </message>
    <message>
        <source>There is nothing to export.</source>
        <translation>Il n&apos;y a rien à exporter.</translation>
    </message>
    <message>
        <source>The surface bounds no volume.</source>
        <translation>La surface ne délimite aucun volume.</translation>
    </message>
    <message>
        <source>its surface passes through itself near %1; other programs may refuse that.</source>
        <translation>sa surface se traverse elle-même près de %1 ; d&apos;autres programmes peuvent le refuser.</translation>
    </message>
    <message>
        <source>its material is folded over itself near %1</source>
        <translation>sa matière est repliée sur elle-même près de %1</translation>
    </message>
    <message>
        <source>%1, and so are its faces.</source>
        <translation>%1, et ses faces aussi.</translation>
    </message>
    <message>
        <source>A CAD file cannot be written in %1; choose mm, cm, m, inch or ft.</source>
        <translation>Un fichier de CAO ne peut pas être écrit en %1&#xa0;; choisissez mm, cm, m, inch ou ft.</translation>
    </message>
    <message>
        <source>The parts could not be put into STEP.</source>
        <translation>Les pièces n&apos;ont pas pu être converties en STEP.</translation>
    </message>
    <message>
        <source>The STEP text could not be written.</source>
        <translation>Le texte STEP n&apos;a pas pu être écrit.</translation>
    </message>
    <message>
        <source>The parts could not be put into IGES.</source>
        <translation>Les pièces n&apos;ont pas pu être converties en IGES.</translation>
    </message>
    <message>
        <source>The IGES text could not be written.</source>
        <translation>Le texte IGES n&apos;a pas pu être écrit.</translation>
    </message>
    <message>
        <source>The BREP text could not be written.</source>
        <translation>Le texte BREP n&apos;a pas pu être écrit.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a GLB can hold; export fewer bodies, or .gltf.</source>
        <translation>la surface demande plus que les 4 Go qu&apos;un GLB peut contenir&#xa0;; exportez moins de corps, ou en .gltf.</translation>
    </message>
    <message>
        <source>the ending is none of %1; name the file after its format.</source>
        <translation>l&apos;extension n&apos;est aucune de %1 ; nommez le fichier d&apos;après son format.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; is not known; known are %2.</source>
        <translation>l&apos;unité de longueur «&#xa0;%1&#xa0;» n&apos;est pas connue&#xa0;; sont connues %2.</translation>
    </message>
    <message>
        <source>the surface of &quot;%1&quot; leads to infinity; go back to where it was whole and export again.</source>
        <translation>la surface de «&#xa0;%1&#xa0;» mène à l&apos;infini&#xa0;; revenez là où elle était entière et exportez de nouveau.</translation>
    </message>
    <message>
        <source>there is no surface to write.</source>
        <translation>il n&apos;y a pas de surface à écrire.</translation>
    </message>
    <message>
        <source>the surface has more than 2147483647 points or triangles, which the formats cannot count; export fewer bodies.</source>
        <translation>la surface a plus de 2147483647 points ou triangles, que les formats ne peuvent compter&#xa0;; exportez moins de corps.</translation>
    </message>
    <message>
        <source>3MF does not know the length unit %1; choose one of um, mm, cm, inch, ft and m.</source>
        <translation>le 3MF ne connaît pas l&apos;unité de longueur %1&#xa0;; choisissez um, mm, cm, inch, ft ou m.</translation>
    </message>
    <message>
        <source>the surface needs more than the 4 GB that a 3MF can hold; export fewer bodies.</source>
        <translation>la surface demande plus que les 4 Go qu&apos;un 3MF peut contenir&#xa0;; exportez moins de corps.</translation>
    </message>
    <message>
        <source>its border cannot be drawn in its parameters</source>
        <translation>son bord ne peut pas être tracé dans ses paramètres</translation>
    </message>
    <message>
        <source>its border does not close in its parameters</source>
        <translation>son bord ne se referme pas dans ses paramètres</translation>
    </message>
    <message>
        <source>its border is too short to be divided</source>
        <translation>son bord est trop court pour être divisé</translation>
    </message>
    <message>
        <source>a face cannot be drawn: %1</source>
        <translation>une face ne peut pas être tracée&#xa0;: %1</translation>
    </message>
    <message>
        <source>an edge does not end</source>
        <translation>une arête ne se termine pas</translation>
    </message>
    <message>
        <source>two of its edges are too short to be told apart</source>
        <translation>deux de ses arêtes sont trop courtes pour être distinguées</translation>
    </message>
    <message>
        <source>two of its points lie on each other</source>
        <translation>deux de ses points coïncident</translation>
    </message>
    <message>
        <source>a triangle in its place has no width</source>
        <translation>un triangle à sa place n&apos;a pas de largeur</translation>
    </message>
    <message>
        <source>too many triangles would be needed</source>
        <translation>il faudrait trop de triangles</translation>
    </message>
    <message>
        <source>an edge has no curve on its face</source>
        <translation>une arête n&apos;a pas de courbe sur sa face</translation>
    </message>
    <message>
        <source>an edge has a curve on its face that does not match it</source>
        <translation>la courbe d&apos;une arête sur sa face ne lui correspond pas</translation>
    </message>
    <message>
        <source>a face has no surface</source>
        <translation>une face n&apos;a pas de géométrie</translation>
    </message>
    <message>
        <source>a face has no border</source>
        <translation>une face n&apos;a pas de bord</translation>
    </message>
    <message>
        <source>a face is degenerate</source>
        <translation>une face est dégénérée</translation>
    </message>
    <message>
        <source>The picture cannot be compressed: %1.</source>
        <translation>L&apos;image ne peut pas être comprimée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>there is no surface to draw.</source>
        <translation>il n&apos;y a pas de surface à dessiner.</translation>
    </message>
    <message>
        <source>the picture must have from 1 to %1 pixels on each side.</source>
        <translation>l&apos;image doit avoir de 1 à %1 pixels de chaque côté.</translation>
    </message>
    <message>
        <source>the directions of view and of up must not be zero.</source>
        <translation>les directions du regard et du haut ne doivent pas être nulles.</translation>
    </message>
    <message>
        <source>the export asks for more memory than there is; export fewer parts at a time.</source>
        <translation>l&apos;export demande plus de mémoire qu&apos;il n&apos;y en a&#xa0;; exportez moins de pièces à la fois.</translation>
    </message>
    <message>
        <source>smooth faces go into .step, .iges and .brep files only.</source>
        <translation>les faces lisses ne vont que dans des fichiers .step, .iges et .brep.</translation>
    </message>
    <message>
        <source>Nothing was written; export fewer parts at a time, or with a larger tolerance.</source>
        <translation>Rien n&apos;a été écrit&#xa0;; exportez moins de pièces à la fois, ou avec une tolérance plus grande.</translation>
    </message>
    <message>
        <source>Nothing was written; export the parts one by one to see which one it is, or as a mesh.</source>
        <translation>Rien n&apos;a été écrit&#xa0;; exportez les pièces une à une pour voir laquelle est en cause, ou comme maillage.</translation>
    </message>
    <message>
        <source>What to write could not be handed over; try again.</source>
        <translation>Ce qu&apos;il fallait écrire n&apos;a pas pu être transmis&#xa0;; réessayez.</translation>
    </message>
    <message>
        <source>there is nothing to export.</source>
        <translation>il n&apos;y a rien à exporter.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at the planes of the deformation; each is one surface across them.</source>
        <translation>« %1 » : ses faces n’ont pas pu être divisées aux plans de la déformation ; chacune est une seule surface qui les traverse.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its faces could not be divided at one of the planes of the deformation; each is one surface across it.</source>
        <translation>« %1 » : ses faces n’ont pas pu être divisées à l’un des plans de la déformation ; chacune est une seule surface qui le traverse.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: 1 face was divided at the planes of the deformation.</source>
        <translation>« %1 » : 1 face a été divisée aux plans de la déformation.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 faces were divided at the planes of the deformation.</source>
        <translation>« %1 » : %2 faces ont été divisées aux plans de la déformation.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: it was carried by all deformations in one step, across the planes of single ones.</source>
        <translation>« %1 » : toutes les déformations ont été appliquées en une étape, à travers les plans de certaines d’entre elles.</translation>
    </message>
    <message>
        <source>not all names of its faces were found again.</source>
        <translation>tous les noms de ses faces n’ont pas été retrouvés.</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Smooth trimmed faces, one for each face of the part as it was opened, at the places where the material has them now. The file is read back and compared.</source>
        <translation>Faces lisses délimitées, une pour chaque face de la pièce telle qu&apos;elle a été ouverte, là où le matériau les a maintenant. Le fichier est relu et comparé.</translation>
    </message>
    <message>
        <source>Triangles, as fine as the surface that is drawn.</source>
        <translation>Des triangles, aussi fins que la surface dessinée.</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>Exporter les pièces déformées</translation>
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
        <translation>Toutes les pièces</translation>
    </message>
    <message>
        <source>Visible parts</source>
        <translation>Pièces visibles</translation>
    </message>
    <message>
        <source>Only &quot;%1&quot;</source>
        <translation>Seulement «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>As in the file that was opened</source>
        <translation>Comme dans le fichier ouvert</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Automatic: 0.01 % of the size</source>
        <translation>Automatique&#xa0;: 0,01 % de la taille</translation>
    </message>
    <message>
        <source>How far faces in the file may lie beside the surface of the material. A larger one gives smaller files.</source>
        <translation>De combien les faces du fichier peuvent s&apos;écarter de la surface du matériau. Plus grand donne des fichiers plus petits.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>For older programs: AP214 instead of AP242</source>
        <translation>Pour les programmes plus anciens&#xa0;: AP214 au lieu d&apos;AP242</translation>
    </message>
    <message>
        <source>As text, which is larger and can be read</source>
        <translation>En texte, plus gros et lisible</translation>
    </message>
    <message>
        <source>A file for each part</source>
        <translation>Un fichier pour chaque pièce</translation>
    </message>
    <message>
        <source>Keep the report as a JSON file beside it</source>
        <translation>Garder le rapport à côté, en fichier JSON</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Choisir un endroit...</translation>
    </message>
</context>
<context>
    <name>ExportFeature</name>
    <message>
        <source>Export report</source>
        <translation>Rapport d&apos;exportation</translation>
    </message>
    <message>
        <source>Export a file for each part</source>
        <translation>Exporter un fichier pour chaque pièce</translation>
    </message>
    <message>
        <source>Export the deformed parts</source>
        <translation>Exporter les pièces déformées</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportation de %1</translation>
    </message>
    <message>
        <source>Exported 1 part to %1.</source>
        <translation>1 pièce exportée vers %1.</translation>
    </message>
    <message>
        <source>Exported %2 parts to %1.</source>
        <translation>%2 pièces exportées vers %1.</translation>
    </message>
    <message>
        <source>Not everything in %1 is sound; the export report says what is not.</source>
        <translation>Tout n&apos;est pas sain dans %1&#xa0;; le rapport d&apos;exportation dit quoi.</translation>
    </message>
    <message>
        <source>The shape that the parts have now is not sound everywhere; the export report says where. Undo goes back to the parts as they were.</source>
        <translation>La forme que les pièces ont maintenant n&apos;est pas saine partout ; le rapport d&apos;exportation dit où. Annuler ramène aux pièces telles qu&apos;elles étaient.</translation>
    </message>
</context>
<context>
    <name>ExportPanel</name>
    <message>
        <source>smooth faces</source>
        <translation>faces lisses</translation>
    </message>
    <message>
        <source>flat triangles</source>
        <translation>triangles plans</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>maillage</translation>
    </message>
    <message>
        <source>does not pass the geometry checks</source>
        <translation>ne passe pas les contrôles géométriques</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>non fermé</translation>
    </message>
    <message>
        <source>its volume is off</source>
        <translation>son volume est faux</translation>
    </message>
    <message>
        <source>further from the material than asked for</source>
        <translation>plus loin du matériau que demandé</translation>
    </message>
    <message>
        <source>passes through itself</source>
        <translation>se traverse</translation>
    </message>
    <message>
        <source>not smooth where it was</source>
        <translation>plus lisse là où il l&apos;était</translation>
    </message>
    <message>
        <source>closed and valid</source>
        <translation>fermé et valide</translation>
    </message>
    <message>
        <source>valid, open as it was</source>
        <translation>valide, ouvert comme avant</translation>
    </message>
    <message>
        <source>%1, mean %2</source>
        <translation>%1, moyenne %2</translation>
    </message>
    <message>
        <source>Not as smooth faces: %1</source>
        <translation>Pas en faces lisses&#xa0;: %1</translation>
    </message>
    <message>
        <source>Its name was not found again.</source>
        <translation>Son nom n&apos;a pas été retrouvé.</translation>
    </message>
    <message>
        <source>Not all of its colors were found again.</source>
        <translation>Ses couleurs n&apos;ont pas toutes été retrouvées.</translation>
    </message>
    <message>
        <source>Nothing was exported yet.</source>
        <translation>Rien n&apos;a encore été exporté.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Relu</translation>
    </message>
    <message>
        <source>As</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Solides</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Distance to the material</source>
        <translation>Distance au matériau</translation>
    </message>
    <message>
        <source>Volume (since opened)</source>
        <translation>Volume (depuis l&apos;ouverture)</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>%1: %2, %3 MB in %4 s. %5</source>
        <translation>%1&#xa0;: %2, %3 Mo en %4 s. %5</translation>
    </message>
    <message>
        <source>All parts are sound.</source>
        <translation>Toutes les pièces sont saines.</translation>
    </message>
    <message>
        <source>%1 of %2 parts are not sound.</source>
        <translation>%1 pièces sur %2 ne sont pas saines.</translation>
    </message>
    <message>
        <source>smooth faces, %1 flat</source>
        <translation>faces lisses, dont %1 à facettes</translation>
    </message>
    <message>
        <source>The part is sound.</source>
        <translation>La pièce est saine.</translation>
    </message>
    <message>
        <source>The part is not sound.</source>
        <translation>La pièce n&apos;est pas saine.</translation>
    </message>
    <message>
        <source>One of %1 parts is not sound.</source>
        <translation>Une pièce sur %1 n&apos;est pas saine.</translation>
    </message>
    <message>
        <source>Exported parts</source>
        <translation>Pièces exportées</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>at %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>on face %1, at %2</source>
        <translation>sur la face %1, en %2</translation>
    </message>
    <message>
        <source>The nodes of the field span %1 mm, the parts %2 mm: the numbers seem to be %3. Choose &quot;%4&quot; as the unit of the field.</source>
        <translation>Les nœuds du champ s’étendent sur %1 mm, les pièces sur %2 mm : les nombres semblent être des %3. Choisissez « %4 » comme unité du champ.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but lies elsewhere: its middle is at %1, theirs at %2. Move the parts there, or write the field where they are.</source>
        <translation>Le champ a la taille des pièces, mais se trouve ailleurs : son milieu est en %1, le leur en %2. Déplacez-y les pièces, ou écrivez le champ là où elles sont.</translation>
    </message>
    <message>
        <source>The field has the size of the parts, but is turned: it spans %1 mm, they span %2 mm. Turn the parts, or write the field with the axes that they have.</source>
        <translation>Le champ a la taille des pièces, mais est tourné : il s’étend sur %1 mm, elles sur %2 mm. Tournez les pièces, ou écrivez le champ avec leurs axes.</translation>
    </message>
    <message>
        <source>The field is not of these parts: %1 % of their surface lies far from all of its nodes, at most %2 mm (%3). The field spans %4 mm, the parts %5 mm.</source>
        <translation>Le champ n’est pas celui de ces pièces : %1 % de leur surface est loin de tous ses nœuds, au plus %2 mm (%3). Le champ s’étend sur %4 mm, les pièces sur %5 mm.</translation>
    </message>
    <message>
        <source>%1 % of the surface has no nodes of the field near it; there the field is continued. The farthest place lies %2 mm from a node, %3.</source>
        <translation>%1 % de la surface n’a pas de nœuds du champ à proximité ; le champ y est prolongé. L’endroit le plus éloigné est à %2 mm d’un nœud, %3.</translation>
    </message>
    <message>
        <source>The field folds the material %1: its volume there would be %2 times what it was. Take a smaller factor, or keep faces there as they are.</source>
        <translation>Le champ replie la matière %1 : son volume y serait %2 fois ce qu’il était. Prenez un facteur plus petit, ou gardez-y des faces telles quelles.</translation>
    </message>
    <message>
        <source>%1 % of the nodes move otherwise than those beside them, most at %2, by %3 mm: two sides of a slit, or noise. A smooth field passes between them.</source>
        <translation>%1 % des nœuds se déplacent autrement que leurs voisins, le plus en %2, de %3 mm : deux côtés d’une fente, ou du bruit. Un champ lisse passe entre eux.</translation>
    </message>
    <message>
        <source>The scan was moved by (%1, %2, %3) mm and turned by %4 degrees, so that it lies on the part.</source>
        <translation>Le scan a été déplacé de (%1, %2, %3) mm et tourné de %4 degrés, de sorte qu’il repose sur la pièce.</translation>
    </message>
    <message>
        <source>At %1 of %2 points of the part the scan says nothing to go by, as where it has a hole; the field is continued there. The farthest lies %3 mm from the scan, at %4.</source>
        <translation>En %1 des %2 points de la pièce, le scan ne dit rien d’utilisable, comme là où il a un trou ; le champ y est prolongé. Le plus éloigné est à %3 mm du scan, en %4.</translation>
    </message>
    <message>
        <source>The scan or the part has no triangles.</source>
        <translation>Le scan ou la pièce n’a pas de triangles.</translation>
    </message>
    <message>
        <source>The scan has a corner that is no place.</source>
        <translation>Le scan a un sommet qui n’est pas un lieu.</translation>
    </message>
    <message>
        <source>The triangles of the scan have no area.</source>
        <translation>Les triangles du scan n’ont pas d’aire.</translation>
    </message>
    <message>
        <source>The scan does not lie on the part: only %1 % of it does, however it is turned. Look at its unit, or lay it on the part and say that it stays in place.</source>
        <translation>Le scan ne repose pas sur la pièce : seulement %1 %, quelle que soit son orientation. Vérifiez son unité, ou posez-le sur la pièce et dites qu’il reste en place.</translation>
    </message>
    <message>
        <source>CalculiX results</source>
        <translation>Résultats de CalculiX</translation>
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
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Abaqus report</source>
        <translation>Rapport d&apos;Abaqus</translation>
    </message>
    <message>
        <source>Abaqus or CalculiX input</source>
        <translation>Données d&apos;entrée d&apos;Abaqus ou de CalculiX</translation>
    </message>
    <message>
        <source>The cracks of &quot;%1&quot; could not be made into surfaces: values at nodes beside them may be those of the other side.</source>
        <translation>Les fissures de « %1 » n’ont pas pu devenir des surfaces : les valeurs aux nœuds voisins peuvent être celles de l’autre côté.</translation>
    </message>
    <message>
        <source>%1 of %2 nodes lie outside of all bodies and have no values; the farthest is %3 away, at (%4, %5, %6). Check the unit of the mesh, and whether its nodes lie in the parts as they were opened or as they are now.</source>
        <translation>%1 nœuds sur %2 sont hors de tous les corps et n’ont pas de valeurs ; le plus éloigné est à %3, en (%4, %5, %6). Vérifiez l’unité du maillage, et si ses nœuds se trouvent dans les pièces telles qu’elles ont été ouvertes ou telles qu’elles sont maintenant.</translation>
    </message>
    <message>
        <source>it has %1 time steps, there is no number %2; choose another one.</source>
        <translation>il a %1 pas de temps, pas de numéro %2&#xa0;; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>it has no vectors at nodes; write the displacements of the nodes into it, too.</source>
        <translation>il n&apos;a pas de vecteurs aux nœuds&#xa0;; écrivez-y aussi les déplacements des nœuds.</translation>
    </message>
    <message>
        <source>it has no vectors called %1 at its nodes; it has %2.</source>
        <translation>il n&apos;a pas de vecteurs appelés %1 à ses nœuds&#xa0;; il a %2.</translation>
    </message>
    <message>
        <source>several vectors could be the displacements: %1; say which.</source>
        <translation>plusieurs vecteurs pourraient être les déplacements&#xa0;: %1&#xa0;; dites lequel.</translation>
    </message>
    <message>
        <source>%1 has %2 values for %3 nodes; write the file again with the program it comes from.</source>
        <translation>%1 a %2 valeurs pour %3 nœuds&#xa0;; réécrivez le fichier avec le programme dont il vient.</translation>
    </message>
    <message>
        <source>an element has node %1, which is missing; write the file again.</source>
        <translation>un élément a le nœud %1, qui manque&#xa0;; réécrivez le fichier.</translation>
    </message>
    <message>
        <source>the file is damaged; write it again with the program it comes from.</source>
        <translation>le fichier est endommagé&#xa0;; réécrivez-le avec le programme dont il vient.</translation>
    </message>
    <message>
        <source>this is no file of displacements; they are read from %1 files.</source>
        <translation>ce n&apos;est pas un fichier de déplacements&#xa0;; on les lit dans des fichiers %1.</translation>
    </message>
    <message>
        <source>it has no nodes; write the results with the mesh.</source>
        <translation>il n&apos;a pas de nœuds&#xa0;; écrivez les résultats avec le maillage.</translation>
    </message>
    <message>
        <source>The file has %1 time steps; the last one was read (%2).</source>
        <translation>Le fichier a %1 pas de temps&#xa0;; le dernier a été lu (%2).</translation>
    </message>
    <message>
        <source>no node in it has a displacement; write the displacements into it, too.</source>
        <translation>aucun nœud n&apos;y a de déplacement&#xa0;; écrivez-y aussi les déplacements.</translation>
    </message>
    <message>
        <source>%1 has another number of values than there are nodes; nothing was written.</source>
        <translation>%1 n&apos;a pas autant de valeurs qu&apos;il y a de nœuds&#xa0;; rien n&apos;a été écrit.</translation>
    </message>
    <message>
        <source>fields at nodes are written to .vtu and .csv files.</source>
        <translation>les champs aux nœuds s&apos;écrivent dans des fichiers .vtu et .csv.</translation>
    </message>
    <message>
        <source>it is a Gmsh file of version %1, which is not read; save it in version 4.1 or 2.2.</source>
        <translation>c&apos;est un fichier Gmsh de la version %1, qui n&apos;est pas lue&#xa0;; enregistrez-le en version 4.1 ou 2.2.</translation>
    </message>
    <message>
        <source>its bytes are in the order of another kind of computer; save it as text (ASCII).</source>
        <translation>ses octets sont dans l&apos;ordre d&apos;un autre genre d&apos;ordinateur&#xa0;; enregistrez-le en texte (ASCII).</translation>
    </message>
    <message>
        <source>it has elements of Gmsh&apos;s type %1, which is not known; leave them out.</source>
        <translation>il a des éléments du type %1 de Gmsh, qui n&apos;est pas connu&#xa0;; laissez-les de côté.</translation>
    </message>
    <message>
        <source>its nodes stand in other files that it includes; give the file with *NODE.</source>
        <translation>ses nœuds sont dans d&apos;autres fichiers qu&apos;il inclut&#xa0;; donnez le fichier avec *NODE.</translation>
    </message>
    <message>
        <source>it has no nodes; a mesh has them behind *NODE.</source>
        <translation>il n&apos;a pas de nœuds&#xa0;; un maillage les a après *NODE.</translation>
    </message>
    <message>
        <source>%1 elements are of kinds that are not read and were left out.</source>
        <translation>%1 éléments sont de types qui ne sont pas lus et ont été laissés de côté.</translation>
    </message>
    <message>
        <source>this is an input of Abaqus or CalculiX, without displacements; give the results (.frd).</source>
        <translation>ce sont des données d&apos;entrée d&apos;Abaqus ou de CalculiX, sans déplacements&#xa0;; donnez les résultats (.frd).</translation>
    </message>
    <message>
        <source>%1 of %2 nodes have no displacement and were left out.</source>
        <translation>%1 nœuds sur %2 n&apos;ont pas de déplacement et ont été laissés de côté.</translation>
    </message>
    <message>
        <source>%1 nodes lie where another one does; each such place has the mean of their displacements.</source>
        <translation>%1 nœuds se trouvent là où il y en a déjà un&#xa0;; chacun de ces endroits a la moyenne de leurs déplacements.</translation>
    </message>
    <message>
        <source>the collection names no files.</source>
        <translation>la collection ne nomme aucun fichier.</translation>
    </message>
    <message>
        <source>the report has no coordinates; write COORD of the nodes into it beside U.</source>
        <translation>le rapport n&apos;a pas de coordonnées&#xa0;; écrivez-y COORD des nœuds à côté de U.</translation>
    </message>
    <message>
        <source>the report has no table with values of nodes.</source>
        <translation>le rapport n&apos;a pas de tableau avec des valeurs de nœuds.</translation>
    </message>
    <message>
        <source>%1 lines hold no numbers where they should and were left out.</source>
        <translation>%1 lignes n&apos;ont pas de nombres là où il en faudrait et ont été laissées de côté.</translation>
    </message>
    <message>
        <source>there are no lines of numbers in it; a table has a line per node with X, Y, Z, DX, DY, DZ.</source>
        <translation>il n&apos;y a pas de lignes de nombres&#xa0;; un tableau a une ligne par nœud avec X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>it cannot be told what its %1 columns are; name them in the first line: X, Y, Z, DX, DY, DZ.</source>
        <translation>on ne peut pas savoir ce que sont ses %1 colonnes&#xa0;; nommez-les dans la première ligne&#xa0;: X, Y, Z, DX, DY, DZ.</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at line %1; write it again with the program it comes from.</source>
        <translation>le fichier est endommagé ou coupé à la ligne %1&#xa0;; réécrivez-le avec le programme dont il vient.</translation>
    </message>
    <message>
        <source>it holds texts as bytes, which are not read; save it as text (ASCII).</source>
        <translation>il contient des textes en binaire, qui ne sont pas lus&#xa0;; enregistrez-le en texte (ASCII).</translation>
    </message>
    <message>
        <source>this VTK file is of the kind %1, which is not read; save it as an unstructured grid (.vtu).</source>
        <translation>ce fichier VTK est du type %1, qui n&apos;est pas lu&#xa0;; enregistrez-le comme grille non structurée (.vtu).</translation>
    </message>
    <message>
        <source>its numbers are compressed by %1, which is not read; save it with zlib or without compression.</source>
        <translation>ses nombres sont compressés par %1, qui n&apos;est pas lu&#xa0;; enregistrez-le avec zlib ou sans compression.</translation>
    </message>
    <message>
        <source>the file asks for more memory than there is; write fewer steps and values into it.</source>
        <translation>le fichier demande plus de mémoire qu&apos;il n&apos;y en a&#xa0;; écrivez-y moins de pas et de valeurs.</translation>
    </message>
    <message>
        <source>Nothing was read; the file is damaged or far too large.</source>
        <translation>Rien n&apos;a été lu&#xa0;; le fichier est endommagé ou bien trop gros.</translation>
    </message>
    <message>
        <source>Nothing was read; write the file again, best as .vtu.</source>
        <translation>Rien n&apos;a été lu&#xa0;; réécrivez le fichier, de préférence en .vtu.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was read; try again.</source>
        <translation>le résultat du lecteur est endommagé (%1). Rien n&apos;a été lu&#xa0;; réessayez.</translation>
    </message>
    <message>
        <source>Values at nodes need a mesh and a file to write: give --nodes and the output.</source>
        <translation>Les valeurs aux nœuds demandent un maillage et un fichier à écrire : indiquez --nodes et la sortie.</translation>
    </message>
    <message>
        <source>There is no field &quot;%1&quot;; known are %2.</source>
        <translation>Il n’y a pas de champ « %1 » ; sont connus %2.</translation>
    </message>
    <message>
        <source>values at nodes are written to .vtu, .csv and .inp files.</source>
        <translation>les valeurs aux nœuds s’écrivent dans des fichiers .vtu, .csv et .inp.</translation>
    </message>
    <message>
        <source>no node lies in the bodies.</source>
        <translation>aucun nœud ne se trouve dans les corps.</translation>
    </message>
    <message>
        <source>there is nothing to write: the mesh has no solid elements for stress, and no displaced nodes were asked for.</source>
        <translation>il n’y a rien à écrire : le maillage n’a pas d’éléments solides pour les contraintes, et les nœuds déplacés n’ont pas été demandés.</translation>
    </message>
    <message>
        <source>The coordinates are those in the report; where Abaqus computed with large displacements they are the moved ones: take those of the first frame then.</source>
        <translation>Les coordonnées sont celles du rapport&#xa0;; si Abaqus a calculé en grands déplacements, ce sont celles d&apos;après&#xa0;: prenez alors celles de la première image.</translation>
    </message>
    <message>
        <source>a node has a coordinate that is no number, or far too large; write the file again.</source>
        <translation>un nœud a une coordonnée qui n&apos;est pas un nombre ou qui est bien trop grande ; réécrivez le fichier.</translation>
    </message>
    <message>
        <source>the collection names %1, which is no ordinary file in its folder; put the file beside the collection and open that again.</source>
        <translation>la collection nomme %1, qui n’est pas un fichier ordinaire de son dossier ; placez le fichier à côté de la collection et rouvrez celle-ci.</translation>
    </message>
</context>
<context>
    <name>FieldPage</name>
    <message>
        <source>Choose faces</source>
        <translation>Choisir des faces</translation>
    </message>
    <message>
        <source>Keep none</source>
        <translation>N&apos;en garder aucune</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Nothing moves along this axis</source>
        <translation>Rien ne bouge le long de cet axe</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Faces that stay</source>
        <translation>Faces qui restent</translation>
    </message>
    <message>
        <source>Fades within</source>
        <translation>S&apos;estompe sur</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>Pour regarder</translation>
    </message>
    <message>
        <source>Exaggerated</source>
        <translation>Exagéré</translation>
    </message>
    <message>
        <source>Largest way</source>
        <translation>Plus grand trajet</translation>
    </message>
    <message>
        <source>Click faces in the view that are to stay exactly where they are, then press this again</source>
        <translation>Cliquez dans la vue les faces qui doivent rester exactement où elles sont, puis appuyez de nouveau ici</translation>
    </message>
    <message>
        <source>Of the displacements; -1 goes the other way, as one compensates</source>
        <translation>Des déplacements ; -1 va dans l&apos;autre sens, comme on compense</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>selon la pièce</translation>
    </message>
    <message>
        <source>From the faces that stay to where the whole field holds</source>
        <translation>Des faces qui restent jusqu&apos;où le champ entier vaut</translation>
    </message>
    <message>
        <source>Only of what is seen before it is applied</source>
        <translation>Seulement de ce qui est vu avant d&apos;être appliqué</translation>
    </message>
    <message>
        <source>Of lengths in the file</source>
        <translation>Des longueurs dans le fichier</translation>
    </message>
    <message>
        <source>%1: %2, %3 nodes</source>
        <translation>%1 : %2, %3 nœuds</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Lies where the part does</source>
        <translation>Est là où est la pièce</translation>
    </message>
    <message>
        <source>Else the scan is laid over the part as a rigid thing first</source>
        <translation>Sinon le scan est d’abord posé sur la pièce comme un objet rigide</translation>
    </message>
</context>
<context>
    <name>File</name>
    <message>
        <source>the file cannot be written (%1); choose another place or make room.</source>
        <translation>le fichier ne peut pas être écrit (%1)&#xa0;; choisissez un autre endroit ou faites de la place.</translation>
    </message>
    <message>
        <source>%1: no such file.</source>
        <translation>%1&#xa0;: ce fichier n&apos;existe pas.</translation>
    </message>
    <message>
        <source>%1: this is a folder; name a file.</source>
        <translation>%1&#xa0;: c&apos;est un dossier&#xa0;; indiquez un fichier.</translation>
    </message>
    <message>
        <source>%1: the file cannot be read; check its permissions.</source>
        <translation>%1&#xa0;: le fichier ne peut pas être lu&#xa0;; vérifiez ses droits.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files; set TMPDIR to one you may write to.</source>
        <translation>Il n&apos;y a pas de dossier pour les fichiers temporaires&#xa0;; mettez dans TMPDIR un dossier où vous pouvez écrire.</translation>
    </message>
    <message>
        <source>%1: no temporary file can be made there (%2).</source>
        <translation>%1&#xa0;: aucun fichier temporaire ne peut y être créé (%2).</translation>
    </message>
    <message>
        <source>The folder for temporary files takes no more; make room there, or set TMPDIR to another folder (%1).</source>
        <translation>Le dossier des fichiers temporaires n&apos;accepte plus rien&#xa0;; faites-y de la place ou mettez un autre dossier dans TMPDIR (%1).</translation>
    </message>
    <message>
        <source>%1: the folder for temporary files takes no more (%2); make room there, or set TMPDIR to another folder.</source>
        <translation>%1&#xa0;: le dossier des fichiers temporaires n&apos;accepte plus rien (%2)&#xa0;; faites-y de la place ou mettez un autre dossier dans TMPDIR.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Name another one with --csv.</source>
        <translation>Nommez-en un autre avec --csv.</translation>
    </message>
    <message>
        <source>Name another one with --probes.</source>
        <translation>Nommez-en un autre avec --probes.</translation>
    </message>
    <message>
        <source>No file can be made in memory (%1).</source>
        <translation>Aucun fichier ne peut être créé en mémoire (%1).</translation>
    </message>
    <message>
        <source>the standard output takes no more; write into a file with --output.</source>
        <translation>la sortie standard n&apos;accepte plus rien ; écrivez dans un fichier avec --output.</translation>
    </message>
</context>
<context>
    <name>Filling</name>
    <message>
        <source>A spacing of %1 needs more than %2 objects. Choose a larger spacing.</source>
        <translation>Un espacement de %1 demande plus de %2 objets. Choisissez un espacement plus grand.</translation>
    </message>
    <message>
        <source>The part has no triangles, so there is nothing to fill. Import a part with a surface.</source>
        <translation>La pièce n&apos;a pas de triangles, il n&apos;y a donc rien à remplir. Importez une pièce avec une surface.</translation>
    </message>
    <message>
        <source>A vertex of the surface is not at a finite place. Repair the file and import again.</source>
        <translation>Un sommet de la surface n&apos;est pas en un lieu fini. Réparez le fichier et importez de nouveau.</translation>
    </message>
    <message>
        <source>The surface is not closed: %1 edges of triangles have no partner. Close the gaps and import again.</source>
        <translation>La surface n&apos;est pas fermée : %1 arêtes de triangles n&apos;ont pas de partenaire. Fermez les lacunes et importez de nouveau.</translation>
    </message>
    <message>
        <source>A spacing of %1 cannot be used. Enter a length above 0.</source>
        <translation>Un espacement de %1 n&apos;est pas utilisable. Saisissez une longueur supérieure à 0.</translation>
    </message>
    <message>
        <source>The surface does not bound a volume: its holes are too large to tell inside from outside. Close them and import again.</source>
        <translation>La surface ne borne pas de volume : ses trous sont trop grands pour distinguer l&apos;intérieur de l&apos;extérieur. Fermez-les et importez de nouveau.</translation>
    </message>
    <message>
        <source>The part is too thin for a spacing of %1: no cell holds enough material. Choose a smaller spacing.</source>
        <translation>La pièce est trop mince pour un espacement de %1 : aucune cellule ne contient assez de matériau. Choisissez un espacement plus petit.</translation>
    </message>
    <message>
        <source>The surface is not closed. Close it and try again.</source>
        <translation>La surface n&apos;est pas fermée. Fermez-la et réessayez.</translation>
    </message>
    <message>
        <source>The spacing must be greater than 0.</source>
        <translation>L&apos;espacement doit être supérieur à 0.</translation>
    </message>
    <message>
        <source>The spacing is too small for a part of this size. Choose a larger one.</source>
        <translation>L&apos;espacement est trop petit pour une pièce de cette taille. Choisissez-en un plus grand.</translation>
    </message>
    <message>
        <source>No sphere has its center inside the part. Choose a smaller spacing.</source>
        <translation>Aucune sphère n&apos;a son centre dans la pièce. Choisissez un espacement plus petit.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out many times too stiff. Fill with a spacing of %3 for %4 cells, about %5 objects.</source>
        <translation>Parois les plus minces : %1 cellules sur %2 ; la flexion de telles parois est beaucoup trop raide. Remplissez avec un espacement de %3 pour %4 cellules ; nombre d&apos;objets : environ %5.</translation>
    </message>
    <message>
        <source>Thinnest walls: %1 cells across %2; bending of such walls comes out up to %3 % too stiff. Fill with a spacing of %4 for %5 cells, about %6 objects.</source>
        <translation>Parois les plus minces : %1 cellules sur %2 ; la flexion de telles parois est jusqu&apos;à %3 % trop raide. Remplissez avec un espacement de %4 pour %5 cellules ; nombre d&apos;objets : environ %6.</translation>
    </message>
    <message>
        <source>A point of the surface is nowhere.</source>
        <translation>Un point de la surface n&apos;est nulle part.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface, so it is not shown.</source>
        <translation>« %1 » n&apos;a pas de surface et n&apos;est donc pas montré.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a closed solid: it is shown, and not simulated. Close its surfaces and import it again.</source>
        <translation>« %1 » n&apos;est pas un solide fermé : il est montré, et non simulé. Fermez ses surfaces et importez-le de nouveau.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>« %1 » n&apos;est pas simulé : %2</translation>
    </message>
    <message>
        <source>%1: the file holds no solid and no surface; export the part as a solid.</source>
        <translation>%1 : le fichier ne contient ni solide ni surface ; exportez la pièce comme solide.</translation>
    </message>
    <message>
        <source>%1: no closed body found. Close the surfaces in the CAD program and export again.</source>
        <translation>%1 : aucun corps fermé trouvé. Fermez les surfaces dans le programme de CAO et exportez de nouveau.</translation>
    </message>
    <message>
        <source>The spacing of another filling must be more than 0.</source>
        <translation>L&apos;espacement d&apos;un autre remplissage doit être supérieur à 0.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no surface that it could be filled from.</source>
        <translation>« %1 » n&apos;a pas de surface à partir de laquelle il pourrait être rempli.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is arranged as published, which filling anew does not know.</source>
        <translation>« %1 » est disposé comme publié, ce que le nouveau remplissage ne connaît pas.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deformable, and keeps its shape.</source>
        <translation>« %1 » n&apos;est pas déformable et garde sa forme.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is elastic: it keeps its shape at rest, and is not filled anew. Let it yield, or re-normalize it.</source>
        <translation>« %1 » est élastique : il garde sa forme au repos et n&apos;est pas rempli de nouveau. Rendez-le plastique, ou renormalisez-le.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks, which another filling would blur: only what heals is filled anew with them.</source>
        <translation>« %1 » a des fissures, qu&apos;un autre remplissage estomperait : seul ce qui cicatrise est rempli de nouveau avec elles.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; came apart after its skin was drawn out far: pieces of such a body are not filled anew.</source>
        <translation>« %1 » s&apos;est séparé après que sa peau a été très étirée : les morceaux d&apos;un tel corps ne sont pas remplis de nouveau.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has cracks that gape, which another filling would close.</source>
        <translation>« %1 » a des fissures béantes, qu&apos;un autre remplissage fermerait.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a load on a box, which says nothing of its present shape. Put it on faces.</source>
        <translation>« %1 » a une charge sur un pavé, qui ne dit rien de sa forme actuelle. Mettez-la sur des faces.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moves out of all bounds.</source>
        <translation>« %1 » se déplace au-delà de toute limite.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is still being pushed out of a tool that was put into it.</source>
        <translation>« %1 » est encore repoussé hors d&apos;un outil qui a été placé dedans.</translation>
    </message>
    <message>
        <source>its cracks gape, and would be filled.</source>
        <translation>ses fissures sont béantes et seraient remplies.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be filled anew: %2</source>
        <translation>« %1 » n&apos;a pas pu être rempli de nouveau : %2</translation>
    </message>
    <message>
        <source>cracks touch the surface without crossing it</source>
        <translation>des fissures touchent la surface sans la traverser</translation>
    </message>
    <message>
        <source>what of it has grown together could not be followed back to what was opened.</source>
        <translation>ce qui s&apos;est ressoudé n&apos;a pas pu être suivi jusqu&apos;à ce qui a été ouvert.</translation>
    </message>
    <message>
        <source>its cracks could not be made surfaces.</source>
        <translation>ses fissures n&apos;ont pas pu devenir des surfaces.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>There is no room left in %1. Free some, or record fewer or smaller pictures.</source>
        <translation>Il n&apos;y a plus de place dans %1. Libérez-en, ou enregistrez moins d&apos;images ou de plus petites.</translation>
    </message>
    <message>
        <source>%1 is there already. Choose another name for the folder of pictures.</source>
        <translation>%1 existe déjà. Choisissez un autre nom pour le dossier des images.</translation>
    </message>
    <message>
        <source>No folder can be made in %1: %2. Choose another place.</source>
        <translation>Aucun dossier ne peut être créé dans %1&#xa0;: %2. Choisissez un autre endroit.</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2). Choose another name for the folder of pictures.</source>
        <translation>%1 ne peut pas être créé (%2). Choisissez un autre nom pour le dossier des images.</translation>
    </message>
</context>
<context>
    <name>Fixture</name>
    <message>
        <source>Fixture &quot;%1&quot; names a body that does not exist.</source>
        <translation>La fixation « %1 » nomme un corps qui n&apos;existe pas.</translation>
    </message>
    <message>
        <source>There is no fixture number %1.</source>
        <translation>Il n&apos;y a pas de fixation numéro %1.</translation>
    </message>
    <message>
        <source>A fixture must not move faster than 100 m/s.</source>
        <translation>Une fixation ne doit pas se déplacer à plus de 100 m/s.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must turn about a place, by more than 0, and no faster than 10000 rad/s.</source>
        <translation>La fixation « %1 » doit tourner autour d&apos;un lieu, de plus de 0, et pas plus vite que 10000 rad/s.</translation>
    </message>
    <message>
        <source>Fixture &quot;%1&quot; must not move faster than 100 m/s.</source>
        <translation>La fixation « %1 » ne doit pas se déplacer à plus de 100 m/s.</translation>
    </message>
</context>
<context>
    <name>FixturePanel</name>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Objects held</source>
        <translation>Objets tenus</translation>
    </message>
    <message>
        <source>With &quot;Fix faces&quot; on, a click on a face adds it to this fixture, or frees it.</source>
        <translation>Avec «&#xa0;Fixer des faces&#xa0;», un clic sur une face l&apos;ajoute à cette fixation ou la libère.</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Supprimer la fixation</translation>
    </message>
</context>
<context>
    <name>FoldWatch</name>
    <message>
        <source>%1 is folded over itself near (%2): material was pushed over material, and its faces cross there in files, too. Undo the stroke, or press the place smooth with a larger tool.</source>
        <translation>%1 est replié sur lui-même près de (%2) : de la matière a été poussée par-dessus la matière, et ses faces s&apos;y croisent aussi dans les fichiers. Annuler le geste, ou lisser l&apos;endroit avec un outil plus grand.</translation>
    </message>
</context>
<context>
    <name>ForcePanel</name>
    <message>
        <source>Magnitude</source>
        <translation>Norme</translation>
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
        <translation>Ce qui est tracé de la force</translation>
    </message>
    <message>
        <source>Add a tool and press Space: forces over time appear here.</source>
        <translation>Ajoutez un outil et appuyez sur Espace&#xa0;: les forces au cours du temps apparaissent ici.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
</context>
<context>
    <name>Graphics</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>The window needs OpenGL 3.2 or later to draw, and here is %1. Install or update the driver of the graphics card, or Mesa (libgl1-mesa-dri), which draws without such a card. The commands that knead --help lists need no window.</source>
        <translation>La fenêtre a besoin d&apos;OpenGL 3.2 ou plus récent pour dessiner, et il y a ici %1. Installez ou mettez à jour le pilote de la carte graphique, ou Mesa (libgl1-mesa-dri), qui dessine sans une telle carte. Les commandes que liste knead --help n&apos;ont pas besoin de fenêtre.</translation>
    </message>
</context>
<context>
    <name>HandPanel</name>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Selon les axes propres de l&apos;outil</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Pas de déplacement</translation>
    </message>
    <message>
        <source>Handles move in steps of this length while Ctrl is held</source>
        <translation>Avec Ctrl, les poignées avancent par pas de cette longueur</translation>
    </message>
    <message>
        <source>Turn step</source>
        <translation>Pas de rotation</translation>
    </message>
    <message>
        <source>Handles turn in steps of this angle while Ctrl is held</source>
        <translation>Avec Ctrl, les poignées tournent par pas de cet angle</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>Key step</source>
        <translation>Pas par appui</translation>
    </message>
    <message>
        <source>A key press moves a tool by this length</source>
        <translation>Un appui sur une touche déplace un outil de cette longueur</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Pas par seconde</translation>
    </message>
    <message>
        <source>While a key is held; a tool never goes faster than its speed limit</source>
        <translation>Tant qu&apos;une touche est tenue&#xa0;; un outil ne dépasse jamais sa limite de vitesse</translation>
    </message>
    <message>
        <source>Pulling</source>
        <translation>Tirer</translation>
    </message>
    <message>
        <source>Spring stiffness</source>
        <translation>Raideur du ressort</translation>
    </message>
    <message>
        <source>Of the spring between the mouse and the material</source>
        <translation>Du ressort entre la souris et le matériau</translation>
    </message>
    <message>
        <source>Largest pull</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>The hand does not pull harder than this</source>
        <translation>La main ne tire pas plus fort que cela</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>Souris 3D</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Selected tool</source>
        <translation>Outil choisi</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Conduit</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Of its speeds; 1 is usual</source>
        <translation>De ses vitesses&#xa0;; 1 est l&apos;usage</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>selon le matériau</translation>
    </message>
    <message>
        <source>Connected. First button: fit; second: camera or tool.</source>
        <translation>Connectée. Premier bouton&#xa0;: ajuster&#xa0;; deuxième&#xa0;: caméra ou outil.</translation>
    </message>
    <message>
        <source>None: it works as soon as spacenavd runs.</source>
        <translation>Aucune&#xa0;: elle marche dès que spacenavd est lancé.</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Hold the rest</source>
        <translation>Tenir le reste</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinceaux</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Of what a brush takes or presses; also with [ and ]</source>
        <translation>De ce qu&apos;un pinceau saisit ou presse&#xa0;; aussi avec [ et ]</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Of the force that suits the material; also with Shift and the mouse wheel</source>
        <translation>Multiple de la force qui convient à la matière&#xa0;; aussi avec Maj et la molette</translation>
    </message>
    <message>
        <source>What is far from the brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Ce qui est loin du pinceau est tenu comme par l&apos;autre main, là où rien d&apos;autre ne tient la pièce</translation>
    </message>
    <message>
        <source>by the part</source>
        <translation>selon la pièce</translation>
    </message>
</context>
<context>
    <name>HandbookWindow</name>
    <message>
        <source>Handbook</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Aucune page ne contient ces mots.</translation>
    </message>
</context>
<context>
    <name>Hands</name>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Show handles on the selected tool to move and turn it; Ctrl: in steps; type numbers</source>
        <translation>Montrer des poignées sur l&apos;outil choisi pour le déplacer et le tourner&#xa0;; Ctrl&#xa0;: par pas&#xa0;; tapez des nombres</translation>
    </message>
    <message>
        <source>Drive by keys</source>
        <translation>Conduire au clavier</translation>
    </message>
    <message>
        <source>Drive up to three tools with the keyboard, each with keys of its own</source>
        <translation>Conduire jusqu&apos;à trois outils au clavier, chacun avec ses propres touches</translation>
    </message>
    <message>
        <source>Pull material</source>
        <translation>Tirer le matériau</translation>
    </message>
    <message>
        <source>Press on the part and pull its material with a spring</source>
        <translation>Appuyer sur la pièce et tirer son matériau avec un ressort</translation>
    </message>
    <message>
        <source>3D mouse drives tool</source>
        <translation>Outil à la souris 3D</translation>
    </message>
    <message>
        <source>The 3D mouse moves the selected tool, not the camera</source>
        <translation>La souris 3D déplace l&apos;outil choisi, pas la caméra</translation>
    </message>
    <message>
        <source>Forces on tools</source>
        <translation>Forces sur les outils</translation>
    </message>
    <message>
        <source>Show the force of the material on each tool as an arrow with its number</source>
        <translation>Montrer la force du matériau sur chaque outil par une flèche avec son nombre</translation>
    </message>
    <message>
        <source>Plot of forces</source>
        <translation>Courbes des forces</translation>
    </message>
    <message>
        <source>Show forces over time</source>
        <translation>Montrer les forces au cours du temps</translation>
    </message>
    <message>
        <source>Forces as table...</source>
        <translation>Tableau des forces...</translation>
    </message>
    <message>
        <source>Write the forces over time as a CSV file</source>
        <translation>Écrire les forces au cours du temps dans un fichier CSV</translation>
    </message>
    <message>
        <source>Keys drive tools   Shift: slower   Esc: done</source>
        <translation>Les touches conduisent les outils   Maj&#xa0;: plus lent   Échap&#xa0;: fini</translation>
    </message>
    <message>
        <source>Along the tool&apos;s own axes</source>
        <translation>Selon les axes de l&apos;outil</translation>
    </message>
    <message>
        <source>Handles lie along the axes of the tool, not of the world</source>
        <translation>Les poignées suivent les axes de l&apos;outil, non ceux du monde</translation>
    </message>
    <message>
        <source>Press material</source>
        <translation>Presser la matière</translation>
    </message>
    <message>
        <source>Press on the part: the selected tool, or a thumb, comes straight onto it and goes in until its force limit holds it</source>
        <translation>Appuyer sur la pièce : l&apos;outil sélectionné, sinon un pouce, vient droit dessus et s&apos;enfonce jusqu&apos;à ce que sa limite de force le retienne</translation>
    </message>
    <message>
        <source>Press and hold: the tool goes in until its force limit holds it   Esc: done</source>
        <translation>Appuyer et maintenir : l&apos;outil s&apos;enfonce jusqu&apos;à ce que sa limite de force le retienne   Échap : terminé</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Pouce</translation>
    </message>
    <message>
        <source>Press and hold: a ball goes in until its force limit holds it; draw it along for a groove</source>
        <translation>Appuyer et maintenir&#xa0;: une bille s&apos;enfonce jusqu&apos;à ce que sa limite de force la retienne&#xa0;; la tirer pour faire une rainure</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Roll a large ball over the surface, which levels what stands out</source>
        <translation>Rouler une grande bille sur la surface, qui aplanit ce qui dépasse</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Aplatir</translation>
    </message>
    <message>
        <source>Press a disc down to the plane that the surface has where you begin</source>
        <translation>Presser un disque jusqu&apos;au plan de la surface au point de départ</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Pincer</translation>
    </message>
    <message>
        <source>Draw material together with four fingers, as for a ridge</source>
        <translation>Rassembler la matière avec quatre doigts, comme pour une arête</translation>
    </message>
    <message>
        <source>Smear</source>
        <translation>Étaler</translation>
    </message>
    <message>
        <source>Take the surface along with a ball that grips it</source>
        <translation>Entraîner la surface avec une bille qui y adhère</translation>
    </message>
    <message>
        <source>Bend here</source>
        <translation>Courber ici</translation>
    </message>
    <message>
        <source>Tilt the material at the cursor towards where you draw</source>
        <translation>Incliner la matière sous le curseur vers où l&apos;on tire</translation>
    </message>
    <message>
        <source>Twist here</source>
        <translation>Tordre ici</translation>
    </message>
    <message>
        <source>Turn the material at the cursor about its normal: draw to the right or left</source>
        <translation>Tourner la matière sous le curseur autour de sa normale&#xa0;: tirer à droite ou à gauche</translation>
    </message>
    <message>
        <source>Symmetric in X</source>
        <translation>Symétrique en X</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along X</source>
        <translation>Les pinceaux font de même de l&apos;autre côté du milieu, selon X</translation>
    </message>
    <message>
        <source>Symmetric in Y</source>
        <translation>Symétrique en Y</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Y</source>
        <translation>Les pinceaux font de même de l&apos;autre côté du milieu, selon Y</translation>
    </message>
    <message>
        <source>Symmetric in Z</source>
        <translation>Symétrique en Z</translation>
    </message>
    <message>
        <source>Brushes do the same on the other side of the middle, along Z</source>
        <translation>Les pinceaux font de même de l&apos;autre côté du milieu, selon Z</translation>
    </message>
    <message>
        <source>Weaker brush</source>
        <translation>Pinceau plus faible</translation>
    </message>
    <message>
        <source>Also with Shift and the mouse wheel</source>
        <translation>Aussi avec Maj et la molette</translation>
    </message>
    <message>
        <source>Stronger brush</source>
        <translation>Pinceau plus fort</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Modelage</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Modeler</translation>
    </message>
    <message>
        <source>Press on the part and draw   [ ]: radius   Shift+wheel: force   Esc: done</source>
        <translation>Appuyer sur la pièce et tirer   [ ]&#xa0;: rayon   Maj+molette&#xa0;: force   Échap&#xa0;: terminé</translation>
    </message>
    <message>
        <source>Hold the rest</source>
        <translation>Tenir le reste</translation>
    </message>
    <message>
        <source>What is far from a brush is held as by the other hand, where nothing else holds the part</source>
        <translation>Ce qui est loin du pinceau est tenu comme par l&apos;autre main, là où rien d&apos;autre ne tient la pièce</translation>
    </message>
    <message>
        <source>Forces of brushes, too</source>
        <translation>Aussi les forces des pinceaux</translation>
    </message>
    <message>
        <source>Fingers and grips of brushes have lines in the plot and columns in the table, too</source>
        <translation>Les doigts et prises des pinceaux ont aussi des courbes dans le graphique et des colonnes dans le tableau</translation>
    </message>
</context>
<context>
    <name>HandsFeature</name>
    <message>
        <source>Hands</source>
        <translation>Manipulation</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forces</translation>
    </message>
    <message>
        <source>Export forces over time</source>
        <translation>Exporter les forces au cours du temps</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>There are no forces to write yet: press Play and let something happen first.</source>
        <translation>Il n&apos;y a encore aucune force à écrire&#xa0;: appuyez sur Lecture et laissez quelque chose se passer.</translation>
    </message>
    <message>
        <source>Select a tool or a fixture first.</source>
        <translation>Choisissez d&apos;abord un outil ou une fixation.</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Ajouter un outil</translation>
    </message>
    <message>
        <source>Put a tool above the part to push it with</source>
        <translation>Mettre un outil au-dessus de la pièce pour la pousser</translation>
    </message>
</context>
<context>
    <name>HelpFeature</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Souris et touches</translation>
    </message>
    <message>
        <source>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;select; drag a tool&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;orbit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom to the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn&lt;/b&gt;&lt;/td&gt;&lt;td&gt;drive the selected tool; Shift is slower&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space, . , Backspace&lt;/b&gt;&lt;/td&gt;&lt;td&gt;play or pause, one step, reset&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Del&lt;/b&gt;&lt;/td&gt;&lt;td&gt;add a block, fix faces, remove&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gravity, re-normalize&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objects, hide body, edges&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isometric, top, front, right; Ctrl: from the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;clicks select parts, faces, edges, objects; Ctrl adds&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective or parallel, fit&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;save the project; Ctrl+Shift+S under another name&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;one, two, four views; V: the active view alone&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;find any command; F11: full screen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;cancel&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellpadding=3&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Bouton gauche&lt;/b&gt;&lt;/td&gt;&lt;td&gt;choisir&#xa0;; tirer un outil&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%1&lt;/b&gt;&lt;/td&gt;&lt;td&gt;tourner&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/td&gt;&lt;td&gt;glisser&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Molette&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoomer vers le curseur&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Flèches, Pg préc, Pg suiv&lt;/b&gt;&lt;/td&gt;&lt;td&gt;conduire l&apos;outil choisi&#xa0;; Maj est plus lent&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Espace, . , Retour arrière&lt;/b&gt;&lt;/td&gt;&lt;td&gt;lecture ou pause, un pas, réinitialiser&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, X, Suppr&lt;/b&gt;&lt;/td&gt;&lt;td&gt;ajouter un bloc, fixer des faces, supprimer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;G, N&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pesanteur, renormaliser&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;O, H, E&lt;/b&gt;&lt;/td&gt;&lt;td&gt;objets, cacher le corps, arêtes&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;0, 7, 8, 9&lt;/b&gt;&lt;/td&gt;&lt;td&gt;isométrique, dessus, face, droite&#xa0;; Ctrl&#xa0;: de l&apos;autre côté&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;1, 2, 3, 4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;les clics choisissent pièces, faces, arêtes, objets&#xa0;; Ctrl ajoute&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;5, F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;perspective ou parallèle, ajuster&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+S&lt;/b&gt;&lt;/td&gt;&lt;td&gt;enregistrer le projet&#xa0;; Ctrl+Maj+S sous un autre nom&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Maj+F1, F2, F4&lt;/b&gt;&lt;/td&gt;&lt;td&gt;une, deux, quatre vues&#xa0;; V&#xa0;: la vue active seule&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl+K&lt;/b&gt;&lt;/td&gt;&lt;td&gt;trouver toute commande&#xa0;; F11&#xa0;: plein écran&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Échap&lt;/b&gt;&lt;/td&gt;&lt;td&gt;annuler&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
</context>
<context>
    <name>History</name>
    <message>
        <source>a number of an object is none</source>
        <translation>un nombre d&apos;un objet n&apos;en est pas un</translation>
    </message>
    <message>
        <source>a filling has no lattice</source>
        <translation>un remplissage n&apos;a pas de réseau</translation>
    </message>
    <message>
        <source>a connection of a filling leads nowhere</source>
        <translation>une liaison d&apos;un remplissage ne mène nulle part</translation>
    </message>
    <message>
        <source>a filling is not as it can be</source>
        <translation>un remplissage est tel qu&apos;il ne peut pas être</translation>
    </message>
    <message>
        <source>a former shape has too many before it</source>
        <translation>trop de formes précèdent une forme antérieure</translation>
    </message>
    <message>
        <source>a former shape has no carriers</source>
        <translation>une forme antérieure n&apos;a pas de porteurs</translation>
    </message>
    <message>
        <source>a former shape is none</source>
        <translation>une forme antérieure n&apos;en est pas une</translation>
    </message>
    <message>
        <source>a former shape was parted where it could not be</source>
        <translation>une forme antérieure a été séparée où elle ne pouvait pas l&apos;être</translation>
    </message>
    <message>
        <source>it ends early</source>
        <translation>les données s&apos;arrêtent trop tôt</translation>
    </message>
    <message>
        <source>a yes or no is neither</source>
        <translation>un oui ou non n&apos;est ni l&apos;un ni l&apos;autre</translation>
    </message>
    <message>
        <source>a choice is none of those there are</source>
        <translation>un choix n&apos;est aucun de ceux qui existent</translation>
    </message>
    <message>
        <source>The history has no entries.</source>
        <translation>L&apos;historique n&apos;a pas d&apos;entrées.</translation>
    </message>
    <message>
        <source>The history is damaged: its entry %1 follows one that comes later.</source>
        <translation>L&apos;historique est endommagé : son entrée %1 suit une entrée qui vient plus tard.</translation>
    </message>
    <message>
        <source>The history is damaged: it is at an entry that it does not have.</source>
        <translation>L&apos;historique est endommagé : il est à une entrée qu&apos;il n&apos;a pas.</translation>
    </message>
    <message>
        <source>Repeating what was done came to another state than it did then, as it does with another version of Knead. Go to an entry that is kept.</source>
        <translation>Répéter ce qui a été fait a conduit à un autre état qu&apos;alors, comme cela arrive avec une autre version de Knead. Allez à une entrée qui est conservée.</translation>
    </message>
    <message>
        <source>The project has no history: nothing was done in it yet that could be repeated.</source>
        <translation>Le projet n&apos;a pas d&apos;historique : rien n&apos;y a encore été fait qui puisse être répété.</translation>
    </message>
    <message>
        <source>The history is damaged: an entry begins with a start that is not there.</source>
        <translation>L&apos;historique est endommagé : une entrée commence par un départ qui n&apos;est pas là.</translation>
    </message>
    <message>
        <source>The entry before it was not reached.</source>
        <translation>L&apos;entrée précédente n&apos;a pas été atteinte.</translation>
    </message>
    <message>
        <source>it does not begin as one</source>
        <translation>il ne commence pas comme un moment</translation>
    </message>
    <message>
        <source>it was written by another version of Knead</source>
        <translation>une autre version de Knead l&apos;a écrit</translation>
    </message>
    <message>
        <source>its bytes are not those that were written</source>
        <translation>ses octets ne sont pas ceux qui ont été écrits</translation>
    </message>
    <message>
        <source>This moment of the history cannot be read: %1. Go to an earlier one and repeat from there.</source>
        <translation>Ce moment de l&apos;historique ne peut pas être lu : %1. Allez à un moment antérieur et répétez à partir de là.</translation>
    </message>
    <message>
        <source>it has another number of bodies than the scene</source>
        <translation>il a un autre nombre de corps que la scène</translation>
    </message>
    <message>
        <source>a tool cannot be simulated</source>
        <translation>un outil ne peut pas être simulé</translation>
    </message>
    <message>
        <source>a fixture cannot be simulated</source>
        <translation>une fixation ne peut pas être simulée</translation>
    </message>
    <message>
        <source>a load cannot be simulated</source>
        <translation>une charge ne peut pas être simulée</translation>
    </message>
    <message>
        <source>a re-normalization under way is out of range</source>
        <translation>une renormalisation en cours est hors limites</translation>
    </message>
    <message>
        <source>a contact or joint is out of range</source>
        <translation>un contact ou un collage est hors limites</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>un nombre est hors limites</translation>
    </message>
    <message>
        <source>a material is out of range</source>
        <translation>un matériau est hors limites</translation>
    </message>
    <message>
        <source>objects are not where they can be</source>
        <translation>des objets sont où ils ne peuvent pas être</translation>
    </message>
    <message>
        <source>a mass is out of range</source>
        <translation>une masse est hors limites</translation>
    </message>
    <message>
        <source>connections are not as they can be</source>
        <translation>des liaisons sont telles qu&apos;elles ne peuvent pas être</translation>
    </message>
    <message>
        <source>it goes on after its end</source>
        <translation>les données continuent après leur fin</translation>
    </message>
    <message>
        <source>a tool is made of a part that the document does not have</source>
        <translation>un outil est fait d&apos;une pièce que le document n&apos;a pas</translation>
    </message>
    <message>
        <source>a motion is none of those there are</source>
        <translation>un mouvement n&apos;est aucun de ceux qui existent</translation>
    </message>
    <message>
        <source>The recording does not belong to this scene: it goes on at step %1, and the run is at step %2. Start from the scene it was made with.</source>
        <translation>L&apos;enregistrement n&apos;appartient pas à cette scène : il continue au pas %1, et la simulation est au pas %2. Partez de la scène avec laquelle il a été fait.</translation>
    </message>
    <message>
        <source>The moment belongs to other bodies than these. Nothing was changed.</source>
        <translation>Le moment appartient à d&apos;autres corps que ceux-ci. Rien n&apos;a été changé.</translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>%1 kB</source>
        <translation>%1 ko</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 Mo</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Made at</source>
        <translation>Fait à</translation>
    </message>
    <message>
        <source>Simulated time at its end</source>
        <translation>Temps simulé à la fin</translation>
    </message>
    <message>
        <source>Key moments: memory is kept for them longest</source>
        <translation>Moments clés&#xa0;: la mémoire leur est gardée le plus longtemps</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>What moments may take. The oldest ones are dropped, and found again by repeating</source>
        <translation>Ce que les moments peuvent prendre. Les plus anciens sont abandonnés, et retrouvés en répétant</translation>
    </message>
    <message>
        <source>of</source>
        <translation>sur</translation>
    </message>
    <message>
        <source>A key moment; click: no longer one</source>
        <translation>Un moment clé&#xa0;; clic&#xa0;: ne l&apos;est plus</translation>
    </message>
    <message>
        <source>Mark as a key moment</source>
        <translation>Marquer comme moment clé</translation>
    </message>
    <message>
        <source>Kept, %1</source>
        <translation>Gardé, %1</translation>
    </message>
    <message>
        <source>Found again by repeating what leads to it</source>
        <translation>Retrouvé en répétant ce qui y mène</translation>
    </message>
    <message>
        <source>%1
Simulated: %2, step %3
%4</source>
        <translation>%1
Simulé&#xa0;: %2, pas %3
%4</translation>
    </message>
    <message>
        <source>Go here, and branch from here with what is done next</source>
        <translation>Aller ici, et bifurquer d&apos;ici avec ce qui est fait ensuite</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>No longer a key moment</source>
        <translation>N&apos;est plus un moment clé</translation>
    </message>
    <message>
        <source>Mark as key moment</source>
        <translation>Marquer comme moment clé</translation>
    </message>
    <message>
        <source>Memory of the history</source>
        <translation>Mémoire de l&apos;historique</translation>
    </message>
</context>
<context>
    <name>HomePage</name>
    <message>
        <source>Go on with</source>
        <translation>Continuer avec</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Ouvrir un fichier...</translation>
    </message>
    <message>
        <source>Drop STEP, IGES, mesh or project files here</source>
        <translation>Déposez ici des fichiers STEP, IGES, maillage ou projet</translation>
    </message>
    <message>
        <source>It becomes a lump of real material to push, bend and squeeze.</source>
        <translation>Cela devient un morceau de vrai matériau à pousser, plier et presser.</translation>
    </message>
    <message>
        <source>Unsaved work is waiting</source>
        <translation>Du travail non enregistré attend</translation>
    </message>
    <message>
        <source>Recover...</source>
        <translation>Récupérer...</translation>
    </message>
    <message>
        <source>Begin with an example</source>
        <translation>Commencer par un exemple</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Try it: press a thumb into clay</source>
        <translation>Essayez : enfoncez un pouce dans l&apos;argile</translation>
    </message>
    <message>
        <source>A block of clay opens. Hold the left button on it; then pull it, and export it. Two minutes.</source>
        <translation>Un bloc d&apos;argile s&apos;ouvre. Maintenez le bouton gauche dessus ; puis tirez-le et exportez-le. Deux minutes.</translation>
    </message>
</context>
<context>
    <name>Iges</name>
    <message>
        <source>line %1 of the IGES file is not in 80 columns; the file is damaged, get it again.</source>
        <translation>la ligne %1 du fichier IGES n&apos;est pas sur 80 colonnes&#xa0;; le fichier est abîmé, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the IGES file ends before its last line (T); it is cut off, get it again.</source>
        <translation>le fichier IGES s&apos;arrête avant sa dernière ligne (T)&#xa0;; il est tronqué, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the IGES file lacks lines of its section %1; it is damaged, get it again.</source>
        <translation>il manque au fichier IGES des lignes de sa section %1&#xa0;; il est abîmé, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>a text in the IGES file claims to be %1 letters long, more than there are; the file is damaged.</source>
        <translation>un texte du fichier IGES se dit long de %1 lettres, plus qu&apos;il n&apos;y en a&#xa0;; le fichier est abîmé.</translation>
    </message>
    <message>
        <source>the IGES file has &quot;%1&quot; in place of a number; it is damaged, export it again.</source>
        <translation>le fichier IGES contient «&#xa0;%1&#xa0;» à la place d&apos;un nombre&#xa0;; il est abîmé, exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>an entity of type %1 in the IGES file claims %2 values and has %3; the file is damaged.</source>
        <translation>une entité de type %1 du fichier IGES annonce %2 valeurs et en a %3&#xa0;; le fichier est abîmé.</translation>
    </message>
    <message>
        <source>line %1 of section D of the IGES file has another number; lines are lost, get the file again.</source>
        <translation>la ligne %1 de la section D du fichier IGES a un autre numéro&#xa0;; des lignes sont perdues, procurez-vous le fichier de nouveau.</translation>
    </message>
    <message>
        <source>has its values twice</source>
        <translation>a deux fois ses valeurs</translation>
    </message>
    <message>
        <source>is of another type where its values are</source>
        <translation>est d&apos;un autre type là où sont ses valeurs</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file holds itself, or the entities are nested more than %2 deep; export it again.</source>
        <translation>l&apos;entité %1 du fichier IGES se contient elle-même, ou les entités sont imbriquées sur plus de %2 niveaux&#xa0;; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>refers to one without values</source>
        <translation>renvoie à une entité sans valeurs</translation>
    </message>
    <message>
        <source>refers to a vertex or edge that is not there</source>
        <translation>renvoie à un sommet ou une arête qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>has %1 values where %2 are needed</source>
        <translation>a %1 valeurs là où il en faut %2</translation>
    </message>
    <message>
        <source>states an impossible count</source>
        <translation>indique un nombre impossible</translation>
    </message>
    <message>
        <source>refers to something of the wrong kind or nothing at all</source>
        <translation>renvoie à quelque chose de faux ou à rien</translation>
    </message>
    <message>
        <source>entity %1 of the IGES file (type %2) %3; the file is damaged, export it again.</source>
        <translation>l&apos;entité %1 du fichier IGES (type %2) %3&#xa0;; le fichier est abîmé, exportez-le de nouveau.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>the file asks for more memory than there is; it is damaged or far too detailed.</source>
        <translation>le fichier demande plus de mémoire qu&apos;il n&apos;y en a&#xa0;; il est abîmé ou bien trop détaillé.</translation>
    </message>
    <message>
        <source>the CAD reader gave up (%1); the file is damaged, export it again.</source>
        <translation>le lecteur de CAO a abandonné (%1)&#xa0;; le fichier est abîmé, exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>the assembly is nested more than %1 levels deep; export a part of it.</source>
        <translation>l&apos;assemblage est imbriqué sur plus de %1 niveaux&#xa0;; exportez-en une partie.</translation>
    </message>
    <message>
        <source>the assembly has more than %1 parts; export the parts you need.</source>
        <translation>l&apos;assemblage a plus de %1 pièces&#xa0;; exportez celles qu&apos;il vous faut.</translation>
    </message>
    <message>
        <source>%1: the file mixes the length units %2 and %3; check the sizes of the parts.</source>
        <translation>%1 : le fichier mêle les unités de longueur %2 et %3 ; vérifiez les tailles des pièces.</translation>
    </message>
    <message>
        <source>%1: its schema &quot;%2&quot; is none for CAD parts; check that nothing is missing.</source>
        <translation>%1 : son schéma « %2 » n&apos;est pas fait pour des pièces CAO ; vérifiez que rien ne manque.</translation>
    </message>
    <message>
        <source>the STEP text has errors that the reader cannot get over; export the file again.</source>
        <translation>le texte STEP a des erreurs que le lecteur ne peut surmonter&#xa0;; exportez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>an assembly in the file holds itself; export the file again, or its parts one by one.</source>
        <translation>un assemblage du fichier se contient lui-même&#xa0;; exportez le fichier de nouveau, ou ses pièces une à une.</translation>
    </message>
    <message>
        <source>the assembly unfolds to more than %1 parts; export the parts you need.</source>
        <translation>l&apos;assemblage se déploie en plus de %1 pièces&#xa0;; exportez celles qu&apos;il vous faut.</translation>
    </message>
    <message>
        <source>no shape of the STEP file could be made; export the file again.</source>
        <translation>aucune forme du fichier STEP n&apos;a pu être faite&#xa0;; exportez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>the IGES text has errors that the reader cannot get over; export the file again, best as STEP.</source>
        <translation>le texte IGES a des erreurs que le lecteur ne peut surmonter&#xa0;; exportez le fichier de nouveau, de préférence en STEP.</translation>
    </message>
    <message>
        <source>no shape of the IGES file could be made; export the file again, best as STEP.</source>
        <translation>aucune forme du fichier IGES n&apos;a pu être faite&#xa0;; exportez le fichier de nouveau, de préférence en STEP.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged; get it again.</source>
        <translation>le fichier BREP est tronqué ou abîmé&#xa0;; procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the BREP file is damaged, or newer than the reader; save it again in an older version.</source>
        <translation>le fichier BREP est abîmé, ou plus récent que le lecteur&#xa0;; enregistrez-le de nouveau dans une version plus ancienne.</translation>
    </message>
    <message>
        <source>The solid was inside out and has been turned.</source>
        <translation>Le solide était à l&apos;envers et a été retourné.</translation>
    </message>
    <message>
        <source>was inside out and has been turned.</source>
        <translation>était à l&apos;envers et a été retournée.</translation>
    </message>
    <message>
        <source>has faces that do not meet well: its volume is uncertain by %1.</source>
        <translation>a des faces qui se joignent mal : son volume est incertain de %1.</translation>
    </message>
    <message>
        <source>is an open surface: %1. It is shown and cannot be filled.</source>
        <translation>est une surface ouverte : %1. Elle est montrée et ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>is not closed: %1. It is shown and cannot be filled.</source>
        <translation>n&apos;est pas fermée : %1. Elle est montrée et ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>is a closed surface but no solid; it is shown and cannot be filled.</source>
        <translation>est une surface fermée mais pas un solide ; elle est montrée et ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>could not be covered with a closed net of triangles; it cannot be filled.</source>
        <translation>n&apos;a pas pu être couverte d&apos;un réseau fermé de triangles ; elle ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>does not pass the geometry checks; look at it closely before you trust it.</source>
        <translation>ne passe pas les contrôles de géométrie ; regardez-la de près avant de vous y fier.</translation>
    </message>
    <message>
        <source>has gaps of up to %1, a hundredth of its size or more.</source>
        <translation>a des fentes allant jusqu&apos;à %1, un centième de sa taille ou plus.</translation>
    </message>
    <message>
        <source>has 1 face that no triangles could be found for; it is not shown there.</source>
        <translation>a 1 face pour laquelle aucun triangle n&apos;a été trouvé ; rien n&apos;y est montré.</translation>
    </message>
    <message>
        <source>has %1 faces that no triangles could be found for; it is not shown there.</source>
        <translation>a %1 faces pour lesquelles aucun triangle n&apos;a été trouvé ; rien n&apos;y est montré.</translation>
    </message>
    <message>
        <source>there is no part or assembly &quot;%1&quot; in it; knead info --json lists the paths of all parts.</source>
        <translation>il n&apos;y a ni pièce ni assemblage «&#xa0;%1&#xa0;» dedans&#xa0;; knead info --json donne les chemins de toutes les pièces.</translation>
    </message>
    <message>
        <source>it has no finite size: numbers in it are damaged, or its edges are smaller than 0.1 um and lost; check the length unit</source>
        <translation>sa taille n&apos;est pas finie : des nombres y sont abîmés, ou ses arêtes sont plus petites que 0.1 um et perdues ; vérifiez l&apos;unité de longueur</translation>
    </message>
    <message>
        <source>it reaches farther than 100 km from the origin; check the length unit and the position</source>
        <translation>il s&apos;étend à plus de 100 km de l&apos;origine ; vérifiez l&apos;unité de longueur et la position</translation>
    </message>
    <message>
        <source>its faces lead far away from their edges: numbers in it are damaged</source>
        <translation>ses faces s&apos;éloignent beaucoup de leurs arêtes : des nombres y sont abîmés</translation>
    </message>
    <message>
        <source>it is smaller than a micrometre; check the length unit</source>
        <translation>il est plus petit qu&apos;un micromètre ; vérifiez l&apos;unité de longueur</translation>
    </message>
    <message>
        <source>its faces and edges are up to %1 apart, at a size of %2</source>
        <translation>ses faces et arêtes sont écartées de %1 au plus, pour une taille de %2</translation>
    </message>
    <message>
        <source>the solid has no volume</source>
        <translation>le solide n&apos;a pas de volume</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was left out: %2.</source>
        <translation>« %1 » a été laissé de côté : %2.</translation>
    </message>
    <message>
        <source>the file holds no solid and no surface; export the part as a solid.</source>
        <translation>le fichier ne contient ni solide ni surface&#xa0;; exportez la pièce comme solide.</translation>
    </message>
    <message>
        <source>%1 Of %2 parts like that none is left.</source>
        <translation>%1 De %2 pièces comme celle-ci, il n&apos;en reste aucune.</translation>
    </message>
    <message>
        <source>this version of BREP is unknown (&quot;%1&quot;); save the file in an older version.</source>
        <translation>cette version de BREP est inconnue («&#xa0;%1&#xa0;»)&#xa0;; enregistrez le fichier dans une version plus ancienne.</translation>
    </message>
    <message>
        <source>the BREP file states an impossible number of %1; it is damaged, get it again.</source>
        <translation>le fichier BREP indique un nombre impossible de %1&#xa0;; il est abîmé, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the BREP file is cut off or damaged: sections are missing; get it again.</source>
        <translation>le fichier BREP est tronqué ou abîmé&#xa0;: il manque des sections&#xa0;; procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the file cannot be opened; check that you may read it.</source>
        <translation>le fichier ne peut pas être ouvert&#xa0;; vérifiez que vous pouvez le lire.</translation>
    </message>
    <message>
        <source>the file cannot be read; the disk or the connection to it failed.</source>
        <translation>le fichier ne peut pas être lu&#xa0;; le disque ou la connexion a fait défaut.</translation>
    </message>
    <message>
        <source>the file does not exist.</source>
        <translation>le fichier n&apos;existe pas.</translation>
    </message>
    <message>
        <source>the file cannot be opened (%1).</source>
        <translation>le fichier ne peut pas être ouvert (%1).</translation>
    </message>
    <message>
        <source>this is a folder, not a file.</source>
        <translation>c&apos;est un dossier, pas un fichier.</translation>
    </message>
    <message>
        <source>this is not an ordinary file.</source>
        <translation>ce n&apos;est pas un fichier ordinaire.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>le fichier est vide.</translation>
    </message>
    <message>
        <source>this is a JSON text, but no glTF (&quot;asset&quot; is missing in it); export the part as STEP.</source>
        <translation>c&apos;est un texte JSON, mais pas un glTF («&#xa0;asset&#xa0;» y manque)&#xa0;; exportez la pièce en STEP.</translation>
    </message>
    <message>
        <source>this is a text, but none of %1; export the part as STEP.</source>
        <translation>c&apos;est un texte, mais d&apos;aucun de ces formats : %1 ; exportez la pièce en STEP.</translation>
    </message>
    <message>
        <source>the content is none of %1; export the part as STEP.</source>
        <translation>le contenu n&apos;est d&apos;aucun de ces formats : %1 ; exportez la pièce en STEP.</translation>
    </message>
    <message>
        <source>is incomplete: %1 of %2 faces of a shell could be read; the others are damaged in the file.</source>
        <translation>est incomplète : %1 faces sur %2 d&apos;une coque ont pu être lues ; les autres sont abîmées dans le fichier.</translation>
    </message>
    <message>
        <source>it could not be measured (%1)</source>
        <translation>il n&apos;a pas pu être mesuré (%1)</translation>
    </message>
    <message>
        <source>this is a gzip archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive gzip&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is a bzip2 archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive bzip2&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is a 7z archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive 7z&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is an xz archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive xz&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is a zstd archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive zstd&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is a rar archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive rar&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>this is a tar archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive tar&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as plain text (ASCII or UTF-8) and open it again.</source>
        <translation>le texte est en UTF-16&#xa0;; enregistrez-le comme texte simple (ASCII ou UTF-8) et rouvrez-le.</translation>
    </message>
    <message>
        <source>this is a PDF document; ask for the STEP file of the part.</source>
        <translation>c&apos;est un document PDF&#xa0;; demandez le fichier STEP de la pièce.</translation>
    </message>
    <message>
        <source>this is a picture; ask for the STEP file of the part.</source>
        <translation>c&apos;est une image&#xa0;; demandez le fichier STEP de la pièce.</translation>
    </message>
    <message>
        <source>this is a database, not a CAD or mesh file.</source>
        <translation>c&apos;est une base de données, pas un fichier de CAO ou de maillage.</translation>
    </message>
    <message>
        <source>this is a native file of another program; export it as STEP there.</source>
        <translation>c&apos;est un fichier propre à un autre programme&#xa0;; exportez-le en STEP là-bas.</translation>
    </message>
    <message>
        <source>this is an AutoCAD drawing (DWG); export the part as STEP there.</source>
        <translation>c&apos;est un dessin AutoCAD (DWG)&#xa0;; exportez-y la pièce en STEP.</translation>
    </message>
    <message>
        <source>this is a program, not a CAD or mesh file.</source>
        <translation>c&apos;est un programme, pas un fichier de CAO ou de maillage.</translation>
    </message>
    <message>
        <source>this is a web page, not a CAD file; the download may have failed.</source>
        <translation>c&apos;est une page web, pas un fichier de CAO&#xa0;; le téléchargement a peut-être échoué.</translation>
    </message>
    <message>
        <source>this is STEP as XML (part 28, stpx), which is not read here; export the part as STEP text (stp).</source>
        <translation>c&apos;est du STEP en XML (partie 28, stpx), qui n&apos;est pas lu ici&#xa0;; exportez la pièce comme texte STEP (stp).</translation>
    </message>
    <message>
        <source>this is an XML text and not one of the files that are read here; export the part as STEP.</source>
        <translation>c&apos;est un texte XML et pas l&apos;un des fichiers lus ici&#xa0;; exportez la pièce en STEP.</translation>
    </message>
    <message>
        <source>this is a zip archive that is cut off or damaged; get it again.</source>
        <translation>c&apos;est une archive zip tronquée ou abîmée&#xa0;; procurez-la-vous de nouveau.</translation>
    </message>
    <message>
        <source>this is a Word document; ask for the STEP file of the part.</source>
        <translation>c&apos;est un document Word&#xa0;; demandez le fichier STEP de la pièce.</translation>
    </message>
    <message>
        <source>this is an Excel workbook; ask for the STEP file of the part.</source>
        <translation>c&apos;est un classeur Excel&#xa0;; demandez le fichier STEP de la pièce.</translation>
    </message>
    <message>
        <source>this is a PowerPoint presentation; ask for the STEP file of the part.</source>
        <translation>c&apos;est une présentation PowerPoint&#xa0;; demandez le fichier STEP de la pièce.</translation>
    </message>
    <message>
        <source>this is a FreeCAD document; export the part as STEP there.</source>
        <translation>c&apos;est un document FreeCAD&#xa0;; exportez-y la pièce en STEP.</translation>
    </message>
    <message>
        <source>this is a zip archive that holds &quot;%1&quot; (compressed STEP, stpz); unpack it and open that file.</source>
        <translation>c&apos;est une archive zip qui contient «&#xa0;%1&#xa0;» (STEP comprimé, stpz)&#xa0;; décompressez-la et ouvrez ce fichier.</translation>
    </message>
    <message>
        <source>this is a zip archive; unpack it and open the file inside.</source>
        <translation>c&apos;est une archive zip&#xa0;; décompressez-la et ouvrez le fichier qu&apos;elle contient.</translation>
    </message>
    <message>
        <source>the %1 file is damaged and cannot be read; export it again.</source>
        <translation>le fichier %1 est abîmé et ne peut pas être lu&#xa0;; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>the GLB is damaged, or of another version than 2; export it again as glTF 2.0.</source>
        <translation>le GLB est abîmé, ou d&apos;une autre version que 2&#xa0;; exportez-le de nouveau en glTF 2.0.</translation>
    </message>
    <message>
        <source>the GLB is cut off or damaged; get it again.</source>
        <translation>le GLB est tronqué ou abîmé&#xa0;; procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>this is a glTF of version unknown, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>c&apos;est un glTF de version inconnue, mais seule la 2 peut être lue&#xa0;; exportez-le de nouveau en glTF 2.0.</translation>
    </message>
    <message>
        <source>this is a glTF of version %1, but only 2 can be read; export it again as glTF 2.0.</source>
        <translation>c&apos;est un glTF de version %1, mais seule la 2 peut être lue&#xa0;; exportez-le de nouveau en glTF 2.0.</translation>
    </message>
    <message>
        <source>the glTF is compressed (%1), which is not read here; export it without compression.</source>
        <translation>le glTF est comprimé (%1), ce qui n&apos;est pas lu ici&#xa0;; exportez-le sans compression.</translation>
    </message>
    <message>
        <source>the glTF keeps its numbers in &quot;%1&quot;, which is not beside it; put it there.</source>
        <translation>le glTF garde ses nombres dans «&#xa0;%1&#xa0;», qui n&apos;est pas à côté&#xa0;; placez-le là.</translation>
    </message>
    <message>
        <source>a node of the glTF is in two others; the file is damaged, export it again.</source>
        <translation>un nœud du glTF est dans deux autres&#xa0;; le fichier est abîmé, exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>nodes of the glTF hold themselves or are nested more than %1 deep; export it again.</source>
        <translation>des nœuds du glTF se contiennent eux-mêmes ou sont imbriqués sur plus de %1 niveaux&#xa0;; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>the glTF file is cut off or damaged; get it again.</source>
        <translation>le fichier glTF est tronqué ou abîmé&#xa0;; procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the %1 file has triangles with corners that are not there; it is damaged, get it again.</source>
        <translation>le fichier %1 a des triangles dont des sommets n&apos;existent pas&#xa0;; il est abîmé, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>is not a closed surface: %1. It is shown and cannot be filled.</source>
        <translation>n&apos;est pas une surface fermée : %1. Elle est montrée et ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>has no volume; it cannot be filled.</source>
        <translation>n&apos;a pas de volume ; elle ne peut pas être remplie.</translation>
    </message>
    <message>
        <source>the line &quot;%1&quot; in the header of the PLY file is damaged; get it again.</source>
        <translation>la ligne «&#xa0;%1&#xa0;» de l&apos;en-tête du fichier PLY est abîmée&#xa0;; procurez-vous le fichier de nouveau.</translation>
    </message>
    <message>
        <source>the header of the PLY file has no end; it is cut off or damaged, get it again.</source>
        <translation>l&apos;en-tête du fichier PLY n&apos;a pas de fin&#xa0;; il est tronqué ou abîmé, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the PLY file holds fewer numbers than its header promises; it is cut off, get it again.</source>
        <translation>le fichier PLY contient moins de nombres que son en-tête n&apos;en promet&#xa0;; il est tronqué, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in 1 place; compare the parts with the program that wrote it.</source>
        <translation>%1 : le 3MF ne suit pas le format à 1 endroit ; comparez les pièces avec le programme qui l&apos;a écrit.</translation>
    </message>
    <message>
        <source>%1: the 3MF does not keep to the format in %2 places; compare the parts with the program that wrote it.</source>
        <translation>%1 : le 3MF ne suit pas le format à %2 endroits ; comparez les pièces avec le programme qui l&apos;a écrit.</translation>
    </message>
    <message>
        <source>the 3MF builds no object; export it again with the parts in its build.</source>
        <translation>le 3MF ne construit aucun objet&#xa0;; exportez-le de nouveau avec les pièces dans sa construction.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than %1 objects, or nests them more than %2 deep; export the parts you need.</source>
        <translation>le 3MF se déploie en plus de %1 objets, ou les imbrique sur plus de %2 niveaux&#xa0;; exportez les pièces qu&apos;il vous faut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no triangles.</source>
        <translation>« %1 » n&apos;a pas de triangles.</translation>
    </message>
    <message>
        <source>the 3MF unfolds to more than 200 million triangles; export the parts you need.</source>
        <translation>le 3MF se déploie en plus de 200 millions de triangles&#xa0;; exportez les pièces qu&apos;il vous faut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length unit; choose one of %2.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une unité de longueur&#xa0;; choisissez-en une parmi %2.</translation>
    </message>
    <message>
        <source>Nothing was imported; the file is damaged, or needs a longer time limit.</source>
        <translation>Rien n&apos;a été importé&#xa0;; le fichier est abîmé, ou demande une limite de temps plus longue.</translation>
    </message>
    <message>
        <source>Nothing was imported; export the file again, best as STEP.</source>
        <translation>Rien n&apos;a été importé&#xa0;; exportez le fichier de nouveau, de préférence en STEP.</translation>
    </message>
    <message>
        <source>the reader&apos;s result is damaged (%1). Nothing was imported; try again.</source>
        <translation>le résultat du lecteur est abîmé (%1). Rien n&apos;a été importé&#xa0;; réessayez.</translation>
    </message>
    <message>
        <source>%1: the reader crashed on what the file says beside its shapes; these were read without names, colors and assemblies, and without other files that it refers to.</source>
        <translation>%1 : le lecteur a échoué sur ce que le fichier dit à côté de ses formes ; celles-ci ont été lues sans noms, couleurs ni assemblages, et sans les autres fichiers auxquels il renvoie.</translation>
    </message>
    <message>
        <source>There is no file to open.</source>
        <translation>Il n&apos;y a pas de fichier à ouvrir.</translation>
    </message>
    <message>
        <source>%1: the 3MF requires what is not read here (%2), and parts may be stand-ins; compare them with the program that wrote it.</source>
        <translation>%1 : le 3MF exige ce qui n&apos;est pas lu ici (%2), et des pièces peuvent être des substituts ; comparez-les avec le programme qui l&apos;a écrit.</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grossier (0,2 % de la taille)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normal (0,05 % de la taille)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fin (0,0125 % de la taille)</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 pièce</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 pièces</translation>
    </message>
    <message>
        <source>1 solid</source>
        <translation>1 solide</translation>
    </message>
    <message>
        <source>%1 solids</source>
        <translation>%1 solides</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 faces</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Open %1 files</source>
        <translation>Ouvrir %1 fichiers</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of the file</source>
        <translation>De combien les triangles dessinés et remplis peuvent s&apos;écarter des surfaces du fichier</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Comme le dit le fichier</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in</source>
        <translation>L&apos;unité dans laquelle sont pris les nombres du fichier</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Stay separate</source>
        <translation>Restent séparés</translation>
    </message>
    <message>
        <source>Are glued together</source>
        <translation>Sont collés</translation>
    </message>
    <message>
        <source>What solids do that touch each other at rest</source>
        <translation>Ce que font les solides qui se touchent au repos</translation>
    </message>
    <message>
        <source>Touching solids</source>
        <translation>Solides en contact</translation>
    </message>
    <message>
        <source>Repair shapes: sew surfaces, close gaps</source>
        <translation>Réparer les formes&#xa0;: coudre les surfaces, fermer les jours</translation>
    </message>
    <message>
        <source>Close flat openings, fill in spite of small holes</source>
        <translation>Fermer les ouvertures planes, remplir malgré de petits trous</translation>
    </message>
    <message>
        <source>Flat openings of any size get a plane face; other surfaces are filled where they wind around. What is open too wide is only shown.</source>
        <translation>Les ouvertures planes de toute taille reçoivent une face plane&#xa0;; les autres surfaces sont remplies là où elles entourent. Ce qui est trop ouvert est seulement montré.</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Reading is given up after this processor time; automatic: by the size of the file</source>
        <translation>La lecture est abandonnée après ce temps de calcul&#xa0;; automatique&#xa0;: selon la taille du fichier</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> Gio</translation>
    </message>
    <message>
        <source>Reading is given up when it wants more memory; automatic: by the size of the file</source>
        <translation>La lecture est abandonnée si elle veut plus de mémoire&#xa0;; automatique&#xa0;: selon la taille du fichier</translation>
    </message>
    <message>
        <source>For real time</source>
        <translation>Pour le temps réel</translation>
    </message>
    <message>
        <source>About so many objects</source>
        <translation>À peu près tant d&apos;objets</translation>
    </message>
    <message>
        <source>Cells across the thinnest wall</source>
        <translation>Cellules à travers la paroi la plus mince</translation>
    </message>
    <message>
        <source>Spacing of the objects</source>
        <translation>Espacement des objets</translation>
    </message>
    <message>
        <source>How finely to fill with objects; finer is slower</source>
        <translation>La finesse du remplissage en objets&#xa0;; plus fin est plus lent</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>All %1 parts</source>
        <translation>Les %1 pièces</translation>
    </message>
    <message>
        <source>%1 of %2 parts</source>
        <translation>%1 pièces sur %2</translation>
    </message>
    <message>
        <source>Time: automatic</source>
        <translation>Temps&#xa0;: automatique</translation>
    </message>
    <message>
        <source>Memory: automatic</source>
        <translation>Mémoire&#xa0;: automatique</translation>
    </message>
    <message>
        <source>Reading may take</source>
        <translation>La lecture peut prendre</translation>
    </message>
</context>
<context>
    <name>ImportFeature</name>
    <message>
        <source>Import report</source>
        <translation>Rapport d&apos;importation</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message numerus="yes">
        <source>Opening %1 and %n more</source>
        <translation>
            <numerusform>Ouverture de %1 et d&apos;un autre fichier</numerusform>
            <numerusform>Ouverture de %1 et de %n autres fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking into %1</source>
        <translation>Examen de %1</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Pièces (%1)</translation>
    </message>
    <message>
        <source>Projects, recipes and parts (%1)</source>
        <translation>Projets, recettes et pièces (%1)</translation>
    </message>
    <message>
        <source>Recipes (%1)</source>
        <translation>Recettes (%1)</translation>
    </message>
    <message>
        <source>Open parts</source>
        <translation>Ouvrir des pièces</translation>
    </message>
    <message>
        <source>Open a project, a recipe or parts</source>
        <translation>Ouvrir un projet, une recette ou des pièces</translation>
    </message>
    <message>
        <source>Filling with a spacing of %1</source>
        <translation>Remplissage avec un espacement de %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not simulated: %2</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas simulé&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2, %3 surfaces to look at, nothing to simulate.</source>
        <translation>%1&#xa0;: %2, %3 surfaces à regarder, rien à simuler.</translation>
    </message>
    <message>
        <source>%1: %2, %3 objects of spacing %4, %5 connections, time step %6.</source>
        <translation>%1&#xa0;: %2, %3 objets d&apos;espacement %4, %5 liaisons, pas de temps %6.</translation>
    </message>
    <message>
        <source>Take as %1</source>
        <translation>Prendre en %1</translation>
    </message>
    <message>
        <source>%1 parts of the file are missing; the import report says which and why.</source>
        <translation>%1 pièces du fichier manquent&#xa0;; le rapport d&apos;importation dit lesquelles et pourquoi.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Montrer le rapport</translation>
    </message>
    <message>
        <source>Nothing in this file is closed, so nothing can be filled and simulated; the import report says why. Open edges are drawn in color.</source>
        <translation>Rien dans ce fichier n&apos;est fermé, rien ne peut donc être rempli et simulé&#xa0;; le rapport d&apos;importation dit pourquoi. Les arêtes ouvertes sont dessinées en couleur.</translation>
    </message>
    <message>
        <source>Taking lengths in %1</source>
        <translation>Prise des longueurs en %1</translation>
    </message>
    <message>
        <source>Add parts</source>
        <translation>Ajouter des pièces</translation>
    </message>
    <message>
        <source>Something else was done while parts were read, so none were added. Add them again.</source>
        <translation>Autre chose a été fait pendant la lecture des pièces, si bien qu&apos;aucune n&apos;a été ajoutée. Ajoutez-les de nouveau.</translation>
    </message>
    <message>
        <source>Add again</source>
        <translation>Ajouter de nouveau</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>Ajout de %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Put beside other things or on the floor, where there is room: %1.</source>
        <translation>Placé à côté d&apos;autre chose ou sur le sol, là où il y a de la place : %1.</translation>
    </message>
    <message>
        <source>What these fixtures held was kneaded and has other objects now; they are gone: %1.</source>
        <translation>Ce que ces fixations tenaient a été pétri et a maintenant d&apos;autres objets ; elles ont disparu : %1.</translation>
    </message>
</context>
<context>
    <name>ImportPanel</name>
    <message>
        <source>As the file says</source>
        <translation>Comme le dit le fichier</translation>
    </message>
    <message>
        <source>Close and fill</source>
        <translation>Fermer et remplir</translation>
    </message>
    <message>
        <source>Opens the file again: flat openings get a plane face, other surfaces are filled where they wind around</source>
        <translation>Ouvre de nouveau le fichier&#xa0;: les ouvertures planes reçoivent une face plane, les autres surfaces sont remplies là où elles entourent</translation>
    </message>
    <message>
        <source>The unit that the numbers in the file are taken in. Another one opens the part anew in it.</source>
        <translation>L&apos;unité dans laquelle sont pris les nombres du fichier. Une autre ouvre la pièce de nouveau dans celle-ci.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Longueurs en</translation>
    </message>
    <message>
        <source>%1, %2, %3 filled</source>
        <translation>%1, %2, %3 remplis</translation>
    </message>
    <message>
        <source>several formats</source>
        <translation>plusieurs formats</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 pièce</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 pièces</translation>
    </message>
    <message>
        <source>Take without repairs</source>
        <translation>Prendre sans réparations</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Réparer</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Manquant</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>was not filled: %1</source>
        <translation>n&apos;a pas été rempli&#xa0;: %1</translation>
    </message>
    <message>
        <source>Repaired: %1</source>
        <translation>Réparé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Nothing was wrong with this file.</source>
        <translation>Ce fichier n&apos;avait aucun défaut.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
</context>
<context>
    <name>KeyCards</name>
    <message>
        <source>Tool %1: add one</source>
        <translation>Outil %1&#xa0;: ajoutez-en un</translation>
    </message>
</context>
<context>
    <name>KeyHand</name>
    <message>
        <source>%1 per step, %2 steps per second, Shift: slower</source>
        <translation>%1 par pas, %2 pas par seconde, Maj&#xa0;: plus lent</translation>
    </message>
</context>
<context>
    <name>Load</name>
    <message>
        <source>A load must not be larger than 1e12 N, N m or Pa.</source>
        <translation>Une charge ne doit pas dépasser 1e12 N, N m ou Pa.</translation>
    </message>
    <message>
        <source>A load must rise within 0 to 3600 s.</source>
        <translation>Une charge doit monter en 0 à 3600 s.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; acts on nothing.</source>
        <translation>La charge « %1 » n&apos;agit sur rien.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names an object that does not exist.</source>
        <translation>La charge « %1 » nomme un objet qui n&apos;existe pas.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; has an area that is no number.</source>
        <translation>La charge « %1 » a une aire qui n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>Load &quot;%1&quot; names a body that does not exist.</source>
        <translation>La charge « %1 » nomme un corps qui n&apos;existe pas.</translation>
    </message>
    <message>
        <source>There is no load number %1.</source>
        <translation>Il n&apos;y a pas de charge numéro %1.</translation>
    </message>
</context>
<context>
    <name>LogPanel</name>
    <message>
        <source>Warning: %1</source>
        <translation>Avertissement : %1</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Erreur : %1</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
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
        <translation>Prêt. Ouvrez une pièce avec Ctrl+O, ou déposez un fichier sur la fenêtre.</translation>
    </message>
    <message>
        <source>%1: cancelled, nothing has changed.</source>
        <translation>%1&#xa0;: annulé, rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>Click faces to hold or free them   Esc: done</source>
        <translation>Cliquer des faces pour les tenir ou les libérer   Échap&#xa0;: fini</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: drive   Shift: slower   %1: orbit</source>
        <translation>Flèches, Pg préc, Pg suiv&#xa0;: conduire   Maj&#xa0;: plus lent   %1&#xa0;: tourner</translation>
    </message>
    <message>
        <source>%1: orbit   %2: pan   Wheel: zoom</source>
        <translation>%1&#xa0;: tourner   %2&#xa0;: glisser   Molette&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Drag to move the timeline</source>
        <translation>Tirer pour déplacer la chronologie</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Click into the view: arrows then drive the tool   %1: orbit</source>
        <translation>Cliquer dans la vue&#xa0;: les flèches conduisent alors l&apos;outil   %1&#xa0;: tourner</translation>
    </message>
    <message>
        <source>Another window could not be opened.</source>
        <translation>Une autre fenêtre n&apos;a pas pu être ouverte.</translation>
    </message>
    <message>
        <source>Go back to the part first: Esc.</source>
        <translation>Revenez d&apos;abord à la pièce : Échap.</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDn: place   Space: play, and it presses   %1: orbit</source>
        <translation>Flèches, Pg préc, Pg suiv&#xa0;: placer   Espace&#xa0;: lancer, et il appuie   %1&#xa0;: tourner</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>%1 is %2; it must lie between %3 and %4.</source>
        <translation>%1 : %2 n&apos;est pas possible, il faut une valeur entre %3 et %4.</translation>
    </message>
    <message>
        <source>The region names the object %1; the body has %2.</source>
        <translation>La région nomme l&apos;objet %1 ; le corps en a %2.</translation>
    </message>
    <message>
        <source>A body can be made of at most 255 different materials.</source>
        <translation>Un corps peut être fait d&apos;au plus 255 matériaux différents.</translation>
    </message>
    <message>
        <source>A rigid body has no stress to lose. Make it deformable first.</source>
        <translation>Un corps rigide n&apos;a pas de contrainte à perdre. Rendez-le d&apos;abord déformable.</translation>
    </message>
    <message>
        <source>Re-normalization takes 0 to 3600 s.</source>
        <translation>La renormalisation prend de 0 à 3600 s.</translation>
    </message>
    <message>
        <source>There is no object number %1.</source>
        <translation>Il n&apos;y a pas d&apos;objet numéro %1.</translation>
    </message>
</context>
<context>
    <name>MaterialComparisonDialog</name>
    <message>
        <source>same</source>
        <translation>identique</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 fois</translation>
    </message>
    <message>
        <source>Compare materials</source>
        <translation>Comparer des matériaux</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>Module de cisaillement</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Vitesse du son</translation>
    </message>
    <message>
        <source>1/%1 of it</source>
        <translation>1/%1 de cela</translation>
    </message>
    <message>
        <source>Right / left</source>
        <translation>Droite / gauche</translation>
    </message>
</context>
<context>
    <name>MaterialName</name>
    <message>
        <source>Soft jelly</source>
        <translation>Gelée molle</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Gelée</translation>
    </message>
    <message>
        <source>Soft foam</source>
        <translation>Mousse souple</translation>
    </message>
    <message>
        <source>Sponge rubber</source>
        <translation>Caoutchouc cellulaire</translation>
    </message>
    <message>
        <source>Silicone rubber</source>
        <translation>Caoutchouc silicone</translation>
    </message>
    <message>
        <source>Modeling clay</source>
        <translation>Argile à modeler</translation>
    </message>
    <message>
        <source>Natural rubber</source>
        <translation>Caoutchouc naturel</translation>
    </message>
    <message>
        <source>Plasticine</source>
        <translation>Pâte à modeler</translation>
    </message>
    <message>
        <source>Rigid foam</source>
        <translation>Mousse rigide</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Cire</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Wood along the grain</source>
        <translation>Bois dans le sens du fil</translation>
    </message>
    <message>
        <source>Aluminum</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Verre</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Acier</translation>
    </message>
    <message>
        <source>Silicone, Shore A 10</source>
        <translation>Silicone, Shore A 10</translation>
    </message>
    <message>
        <source>Silicone, Shore A 20</source>
        <translation>Silicone, Shore A 20</translation>
    </message>
    <message>
        <source>Silicone, Shore A 30</source>
        <translation>Silicone, Shore A 30</translation>
    </message>
    <message>
        <source>Silicone, Shore A 40</source>
        <translation>Silicone, Shore A 40</translation>
    </message>
    <message>
        <source>Silicone, Shore A 50</source>
        <translation>Silicone, Shore A 50</translation>
    </message>
    <message>
        <source>Silicone, Shore A 60</source>
        <translation>Silicone, Shore A 60</translation>
    </message>
    <message>
        <source>Water clay</source>
        <translation>Argile à l&apos;eau</translation>
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
        <translation>Mastic</translation>
    </message>
    <message>
        <source>Warm wax</source>
        <translation>Cire tiède</translation>
    </message>
</context>
<context>
    <name>MaterialPanel</name>
    <message>
        <source>Elastic</source>
        <translation>Élastique</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Écoulement</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Résistance</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse volumique</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module d&apos;Young</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Coefficient de Poisson</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Taux d&apos;amortissement</translation>
    </message>
    <message>
        <source>Shape damping</source>
        <translation>Amortissement de forme</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>Limite d&apos;élasticité</translation>
    </message>
    <message>
        <source>never yields</source>
        <translation>ne s&apos;écoule jamais</translation>
    </message>
    <message>
        <source>Hardening</source>
        <translation>Écrouissage</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>Temps de relaxation</translation>
    </message>
    <message>
        <source>flows at once</source>
        <translation>s&apos;écoule aussitôt</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Résistance à la traction</translation>
    </message>
    <message>
        <source>never breaks</source>
        <translation>ne rompt jamais</translation>
    </message>
    <message>
        <source>Elongation at break</source>
        <translation>Allongement à la rupture</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Adhérence</translation>
    </message>
    <message>
        <source>does not stick</source>
        <translation>ne colle pas</translation>
    </message>
    <message>
        <source>Healing time</source>
        <translation>Temps de cicatrisation</translation>
    </message>
    <message>
        <source>does not heal</source>
        <translation>ne cicatrise pas</translation>
    </message>
    <message>
        <source>Rubber</source>
        <translation>Caoutchouc</translation>
    </message>
    <message>
        <source>Rubberlike</source>
        <translation>Caoutchouteux</translation>
    </message>
    <message>
        <source>for small strains</source>
        <translation>pour petites déformations</translation>
    </message>
    <message>
        <source>Second-invariant share</source>
        <translation>Part du second invariant</translation>
    </message>
    <message>
        <source>Locking elongation</source>
        <translation>Allongement de blocage</translation>
    </message>
    <message>
        <source>never locks</source>
        <translation>ne bloque jamais</translation>
    </message>
    <message>
        <source>Deformable</source>
        <translation>Déformable</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rigide</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>Colle</translation>
    </message>
    <message>
        <source>Keeps its shape and moves as a whole</source>
        <translation>Garde sa forme et se meut d&apos;un bloc</translation>
    </message>
    <message>
        <source>Keeps shape and place; its adhesion holds what touches it</source>
        <translation>Garde forme et place&#xa0;; son adhérence tient ce qui le touche</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Nombres propres</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Distance between neighboring objects</source>
        <translation>Distance entre objets voisins</translation>
    </message>
    <message>
        <source>Objects along the longest side of the part</source>
        <translation>Objets le long du plus grand côté de la pièce</translation>
    </message>
    <message>
        <source>Refill</source>
        <translation>Remplir de nouveau</translation>
    </message>
    <message>
        <source>Fill all bodies again with this spacing; the simulation starts anew</source>
        <translation>Remplir de nouveau tous les corps avec cet espacement&#xa0;; la simulation recommence</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Cells across</source>
        <translation>Cellules en travers</translation>
    </message>
    <message>
        <source>%1 objects, %2 connections
%3 of material</source>
        <translation>%1 objets, %2 liaisons
%3 de matériau</translation>
    </message>
    <message>
        <source>Material of %1 → %2</source>
        <translation>Matériau de %1 → %2</translation>
    </message>
    <message>
        <source>%1 of %2 → %3</source>
        <translation>%1 de %2 → %3</translation>
    </message>
    <message>
        <source>What follows</source>
        <translation>Ce qui en découle</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Vitesse du son</translation>
    </message>
    <message>
        <source>Of a thin bar: the root of stiffness by density</source>
        <translation>Dans une barre mince&#xa0;: racine de la raideur divisée par la masse volumique</translation>
    </message>
    <message>
        <source>Stable time step</source>
        <translation>Pas de temps stable</translation>
    </message>
    <message>
        <source>Longest step of an explicit scheme, for all bodies together; shorter for stiff, light and finely filled ones</source>
        <translation>Le plus long pas d&apos;un schéma explicite, pour tous les corps ensemble&#xa0;; plus court pour ceux qui sont raides, légers ou finement remplis</translation>
    </message>
    <message>
        <source>Expected speed</source>
        <translation>Vitesse attendue</translation>
    </message>
    <message>
        <source>Simulated by wall time on this machine: measured while time ran, else by a rule</source>
        <translation>Temps simulé par temps réel sur cette machine&#xa0;: mesuré en marche, sinon estimé par une règle</translation>
    </message>
    <message>
        <source>Cells across walls</source>
        <translation>Cellules par paroi</translation>
    </message>
    <message>
        <source>%1 to %2, with any unit; 1.2e6 and 1,2 are taken too</source>
        <translation>De %1 à %2, en toute unité&#xa0;; 1.2e6 et 1,2 sont acceptés aussi</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>keeps up with real time</source>
        <translation>suit le temps réel</translation>
    </message>
    <message>
        <source>%1 of real time</source>
        <translation>%1 fois le temps réel</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>Save these numbers as a material of your own</source>
        <translation>Enregistrer ces nombres comme matériau personnel</translation>
    </message>
    <message>
        <source>Rename this material of your own</source>
        <translation>Renommer ce matériau personnel</translation>
    </message>
    <message>
        <source>Delete this material of your own; bodies keep its numbers</source>
        <translation>Supprimer ce matériau personnel&#xa0;; les corps gardent ses nombres</translation>
    </message>
    <message>
        <source>Compare with another material, side by side</source>
        <translation>Comparer à un autre matériau, côte à côte</translation>
    </message>
    <message>
        <source>Save material</source>
        <translation>Enregistrer le matériau</translation>
    </message>
    <message>
        <source>Rename material</source>
        <translation>Renommer le matériau</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Nom du matériau</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 (actuel)</translation>
    </message>
    <message>
        <source>Across the thinnest wall: with fewer than %1 its bending comes out too stiff</source>
        <translation>À travers la paroi la plus mince : avec moins de %1, sa flexion est trop raide</translation>
    </message>
    <message>
        <source>%1: many times too stiff</source>
        <translation>%1 : beaucoup trop raide</translation>
    </message>
    <message>
        <source>%1: up to %2 % too stiff</source>
        <translation>%1 : jusqu&apos;à %2 % trop raide</translation>
    </message>
    <message>
        <source>Toughness</source>
        <translation>Ténacité</translation>
    </message>
    <message>
        <source>knives do not cut it</source>
        <translation>les couteaux ne la coupent pas</translation>
    </message>
    <message>
        <source>Softer to the left, as warm or wet clay; firmer to the right, as cold or dry clay</source>
        <translation>À gauche plus mou, comme une argile chaude ou humide ; à droite plus ferme, comme une argile froide ou sèche</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 fois</translation>
    </message>
    <message>
        <source>Softer / firmer</source>
        <translation>Plus mou / plus ferme</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>Firmness of %1 as it was</source>
        <translation>Fermeté de %1 comme avant</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 plus mou</translation>
    </message>
    <message>
        <source>%1 firmer</source>
        <translation>%1 plus ferme</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>moins de %1</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>D&apos;où viennent les nombres</translation>
    </message>
</context>
<context>
    <name>MaterialStore</name>
    <message>
        <source>Your own materials cannot be read: %1 Mend or remove the file; until then none can be saved.</source>
        <translation>Vos matériaux personnels ne peuvent pas être lus&#xa0;: %1 Réparez ou supprimez le fichier&#xa0;; d&apos;ici là, aucun ne peut être enregistré.</translation>
    </message>
    <message>
        <source>A material needs a name: type one.</source>
        <translation>Un matériau a besoin d&apos;un nom&#xa0;: tapez-en un.</translation>
    </message>
    <message>
        <source>There is a material named &quot;%1&quot; already: choose another name.</source>
        <translation>Il y a déjà un matériau nommé «&#xa0;%1&#xa0;»&#xa0;: choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Saved by you</source>
        <translation>Enregistré par vous</translation>
    </message>
    <message>
        <source>The material was not saved: %1</source>
        <translation>Le matériau n&apos;a pas été enregistré&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Nothing is measured yet. Choose what to measure above, then click on the part; corners attract. Numbers follow the material while time runs.</source>
        <translation>Rien n&apos;est encore mesuré. Choisissez ci-dessus quoi mesurer, puis cliquez sur la pièce&#xa0;; les sommets attirent. Les nombres suivent le matériau en marche.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Comparer...</translation>
    </message>
    <message>
        <source>Compare the parts with their original shape, and write a report</source>
        <translation>Comparer les pièces à leur forme d&apos;origine, et écrire un rapport</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the table (Ctrl+C)</source>
        <translation>Copier le tableau (Ctrl+C)</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write the table to a file, units in its columns</source>
        <translation>Écrire le tableau dans un fichier, unités dans ses colonnes</translation>
    </message>
    <message>
        <source>Delete the selected measurements, or all (Del)</source>
        <translation>Supprimer les mesures choisies, ou toutes (Suppr)</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>The face is not flat: it is up to %1 away from its mean plane.</source>
        <translation>La face n&apos;est pas plane&#xa0;: elle s&apos;écarte jusqu&apos;à %1 de son plan moyen.</translation>
    </message>
    <message>
        <source>The three places lie on a line: pick others, further around.</source>
        <translation>Les trois points sont alignés&#xa0;: prenez-en d&apos;autres, plus loin sur le tour.</translation>
    </message>
    <message>
        <source>The face is flat and has no radius: click a round one, or measure with three places.</source>
        <translation>La face est plane et n&apos;a pas de rayon&#xa0;: cliquez-en une ronde, ou mesurez avec trois points.</translation>
    </message>
    <message>
        <source>The face is not quite round: it is up to %1 away from this radius.</source>
        <translation>La face n&apos;est pas tout à fait ronde&#xa0;: elle s&apos;écarte jusqu&apos;à %1 de ce rayon.</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Déplacement</translation>
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
        <translation>Distance</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>selon X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>selon Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>selon Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Size X</source>
        <translation>Taille X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Taille Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Taille Z</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Center of mass X</source>
        <translation>Centre de masse X</translation>
    </message>
    <message>
        <source>Center of mass Y</source>
        <translation>Centre de masse Y</translation>
    </message>
    <message>
        <source>Center of mass Z</source>
        <translation>Centre de masse Z</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Coordinates of a place, and how far it has moved</source>
        <translation>Coordonnées d&apos;un point, et de combien il s&apos;est déplacé</translation>
    </message>
    <message>
        <source>Distance between two places</source>
        <translation>Distance entre deux points</translation>
    </message>
    <message>
        <source>Distance to face</source>
        <translation>Distance à une face</translation>
    </message>
    <message>
        <source>Distance of a place from the nearest point of a face</source>
        <translation>Distance d&apos;un point au point le plus proche d&apos;une face</translation>
    </message>
    <message>
        <source>Angle at the second of three places</source>
        <translation>Angle au deuxième de trois points</translation>
    </message>
    <message>
        <source>Angle of faces</source>
        <translation>Angle de deux faces</translation>
    </message>
    <message>
        <source>Angle between the normals of two faces</source>
        <translation>Angle entre les normales de deux faces</translation>
    </message>
    <message>
        <source>Radius of the circle through three places</source>
        <translation>Rayon du cercle passant par trois points</translation>
    </message>
    <message>
        <source>Radius of face</source>
        <translation>Rayon d&apos;une face</translation>
    </message>
    <message>
        <source>Radius of a hole, a cylinder or a ball</source>
        <translation>Rayon d&apos;un trou, d&apos;un cylindre ou d&apos;une boule</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message>
        <source>Sizes of a part along the axes</source>
        <translation>Tailles d&apos;une pièce le long des axes</translation>
    </message>
    <message>
        <source>Volume and mass</source>
        <translation>Volume et masse</translation>
    </message>
    <message>
        <source>Volume, mass and center of mass of a part</source>
        <translation>Volume, masse et centre de masse d&apos;une pièce</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be measured: %2</source>
        <translation>« %1 » ne peut pas être mesuré : %2</translation>
    </message>
    <message>
        <source>a place is three coordinates in mm, as 10,0,2.5; this is %1.</source>
        <translation>un endroit se donne par trois coordonnées en mm, comme 10,0,2.5 ; ceci est %1.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; coordinates are in mm.</source>
        <translation>%1 est loin de tous les corps ; les coordonnées sont en mm.</translation>
    </message>
    <message>
        <source>there is no body &quot;%1&quot;; there are: %2.</source>
        <translation>il n&apos;y a pas de corps « %1 » ; il y a : %2.</translation>
    </message>
    <message>
        <source>which body the face %1 is of is not clear; put its name before it, as &quot;lid&quot;:%1, or its number from 0, as #0:%1.</source>
        <translation>on ne sait pas à quel corps appartient la face %1 ; mettez son nom devant, comme &quot;lid&quot;:%1, ou son numéro à partir de 0, comme #0:%1.</translation>
    </message>
    <message>
        <source>there is no face %1; faces are numbered from 0, and meshes have none.</source>
        <translation>il n&apos;y a pas de face %1 ; les faces sont numérotées à partir de 0, et les maillages n&apos;en ont pas.</translation>
    </message>
    <message>
        <source>it begins with none of %1.</source>
        <translation>cela ne commence par aucun de %1.</translation>
    </message>
    <message>
        <source>%1 takes %2 places or faces.</source>
        <translation>%1 demande %2 endroits ou faces.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>le projet n&apos;a pas de pièces.</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>le projet n&apos;a pas d&apos;entrée %1 ; la dernière est %2.</translation>
    </message>
    <message>
        <source>this is no project: it has no entries.</source>
        <translation>ce n&apos;est pas un projet : il n&apos;a pas d&apos;entrées.</translation>
    </message>
    <message>
        <source>no part of it is closed, so there is nothing to measure.</source>
        <translation>aucune de ses pièces n&apos;est fermée : il n&apos;y a rien à mesurer.</translation>
    </message>
</context>
<context>
    <name>MeasurementList</name>
    <message>
        <source>Measurement,Reading,Unit,Now,At rest,Change</source>
        <translation>Mesure,Grandeur,Unité,Actuel,Au repos,Variation</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>Compare with original...</source>
        <translation>Comparer à l&apos;original...</translation>
    </message>
    <message>
        <source>Largest and mean distance, volume and mass beside the original, and a report</source>
        <translation>Distances maximale et moyenne, volume et masse à côté de l&apos;original, et un rapport</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Sommet</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>Au repos</translation>
    </message>
</context>
<context>
    <name>MeasuringFeature</name>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesure</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Write what was measured</source>
        <translation>Écrire les mesures</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
</context>
<context>
    <name>ModelNotes</name>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
</context>
<context>
    <name>ModelPanel</name>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Chercher (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>ModelTree</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Fixations</translation>
    </message>
    <message>
        <source>Assembly</source>
        <translation>Assemblage</translation>
    </message>
    <message>
        <source>Not a closed solid: it is not simulated.</source>
        <translation>Pas un solide fermé&#xa0;: il n&apos;est pas simulé.</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>objets</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 face</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 faces</translation>
    </message>
    <message>
        <source>Selections</source>
        <translation>Sélections</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exportations</translation>
    </message>
    <message>
        <source>In the file: %1</source>
        <translation>Dans le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 selected things; a click selects them again</source>
        <translation>%1 éléments choisis&#xa0;; un clic les choisit de nouveau</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Keep the present selection here</source>
        <translation>Garder ici la sélection présente</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Montrer dans son dossier</translation>
    </message>
    <message>
        <source>The folder %1 cannot be shown: look for it with your file manager.</source>
        <translation>Le dossier %1 ne peut pas être montré&#xa0;: cherchez-le avec votre gestionnaire de fichiers.</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>Retirer de la liste</translation>
    </message>
    <message>
        <source>There is a selection called &quot;%1&quot; already: choose another name.</source>
        <translation>Il y a déjà une sélection nommée «&#xa0;%1&#xa0;»&#xa0;: choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Color of the part</source>
        <translation>Couleur de la pièce</translation>
    </message>
    <message>
        <source>Color of %1 parts</source>
        <translation>Couleur de %1 pièces</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
</context>
<context>
    <name>ModelTreeDelegate</name>
    <message>
        <source>Show (H)</source>
        <translation>Montrer (H)</translation>
    </message>
    <message>
        <source>Hide (H)</source>
        <translation>Cacher (H)</translation>
    </message>
    <message>
        <source>Unlock (L)</source>
        <translation>Déverrouiller (L)</translation>
    </message>
    <message>
        <source>Lock: keep it from being changed (L)</source>
        <translation>Verrouiller&#xa0;: empêcher toute modification (L)</translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>middle+left</source>
        <translation>milieu+gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>Shift+</source>
        <translation>Maj+</translation>
    </message>
    <message>
        <source>Ctrl+</source>
        <translation>Ctrl+</translation>
    </message>
    <message>
        <source>Two buttons / touchpad</source>
        <translation>Deux boutons / pavé tactile</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 billion</source>
        <translation>%1 milliards</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 millions</translation>
    </message>
    <message>
        <source>%1 thousand</source>
        <translation>%1 mille</translation>
    </message>
</context>
<context>
    <name>NumberPage</name>
    <message>
        <source>Begins and ends gently</source>
        <translation>Commence et finit en douceur</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>The selected ones</source>
        <translation>Celles qui sont sélectionnées</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>The longest side</source>
        <translation>Le plus long côté</translation>
    </message>
    <message>
        <source>Normal of the selected face</source>
        <translation>Normale de la face sélectionnée</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>First plane</source>
        <translation>Premier plan</translation>
    </message>
    <message>
        <source>Where it begins, along the axis from the origin</source>
        <translation>Où cela commence, le long de l&apos;axe depuis l&apos;origine</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Second plan</translation>
    </message>
    <message>
        <source>Where it ends, along the axis from the origin</source>
        <translation>Où cela finit, le long de l&apos;axe depuis l&apos;origine</translation>
    </message>
    <message>
        <source>Toward</source>
        <translation>Vers</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Of the second plane against the first one; below 0 the other way</source>
        <translation>Du second plan par rapport au premier ; sous 0 dans l&apos;autre sens</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Of the line that keeps its length; the angle follows</source>
        <translation>De la ligne qui garde sa longueur ; l&apos;angle suit</translation>
    </message>
    <message>
        <source>Neutral line</source>
        <translation>Fibre neutre</translation>
    </message>
    <message>
        <source>What keeps its length: 0 at the inner side, 1 at the outer one. Sheet metal has some 0.33 to 0.5, its k-factor</source>
        <translation>Ce qui garde sa longueur : 0 du côté intérieur, 1 du côté extérieur. La tôle a environ 0,33 à 0,5, son facteur k</translation>
    </message>
    <message>
        <source>Neutral place</source>
        <translation>Place neutre</translation>
    </message>
    <message>
        <source>The same as a place along the side that it bends toward</source>
        <translation>La même chose comme place le long du côté vers lequel elle se courbe</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Of the second plane; 1 changes nothing</source>
        <translation>Du second plan ; 1 ne change rien</translation>
    </message>
    <message>
        <source>New length</source>
        <translation>Nouvelle longueur</translation>
    </message>
    <message>
        <source>Between the planes afterwards; the factor follows</source>
        <translation>Entre les plans ensuite ; le facteur suit</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Of the second plane, sideways</source>
        <translation>Du second plan, de côté</translation>
    </message>
    <message>
        <source>The first plane</source>
        <translation>Le premier plan</translation>
    </message>
    <message>
        <source>The middle</source>
        <translation>Le milieu</translation>
    </message>
    <message>
        <source>The second plane</source>
        <translation>Le second plan</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Reste en place</translation>
    </message>
    <message>
        <source>Without a crease at the planes; in the middle there is then more of it</source>
        <translation>Sans pli aux plans ; au milieu, il y en a alors plus</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>Let go at the end</source>
        <translation>Lâcher à la fin</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Exactement</translation>
    </message>
    <message>
        <source>By physics</source>
        <translation>Par la physique</translation>
    </message>
    <message>
        <source>Exactly: all goes as the formula says. By physics: what lies beyond the planes is held by grips that go as the formula says, and the material between them finds its own shape</source>
        <translation>Exactement : tout suit la formule. Par la physique : ce qui se trouve au-delà des plans est tenu par des prises qui suivent la formule, et la matière entre elles trouve sa propre forme</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Comment</translation>
    </message>
    <message>
        <source>Time it takes</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Of the way of the grips; material that flows resists less when it is slow</source>
        <translation>Du trajet des prises ; la matière qui s’écoule résiste moins quand c’est lent</translation>
    </message>
    <message>
        <source>The grip that has moved most opens, so that elastic material springs back</source>
        <translation>La prise qui a le plus bougé s’ouvre, si bien que la matière élastique revient</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>The graphics card draws no pictures of this size. Choose a smaller one.</source>
        <translation>La carte graphique ne dessine pas d&apos;images de cette taille. Choisissez-en une plus petite.</translation>
    </message>
    <message>
        <source>The graphics card takes no more pictures. Close other programs and try again.</source>
        <translation>La carte graphique ne prend plus d&apos;images. Fermez d&apos;autres programmes et réessayez.</translation>
    </message>
    <message>
        <source>The graphics driver draws for the window only, so that nothing can be recorded. Start Knead with LIBGL_ALWAYS_SOFTWARE=1 in its environment to record without the driver.</source>
        <translation>Le pilote graphique ne dessine que pour la fenêtre, rien ne peut donc être enregistré. Démarrez Knead avec LIBGL_ALWAYS_SOFTWARE=1 dans son environnement pour enregistrer sans le pilote.</translation>
    </message>
</context>
<context>
    <name>OtherPartDialog</name>
    <message>
        <source>Apply to another part</source>
        <translation>Appliquer à une autre pièce</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>À travers %1</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>La même</translation>
    </message>
    <message>
        <source>Another one, as its box says</source>
        <translation>Une autre, selon sa boîte</translation>
    </message>
    <message>
        <source>So many times as large</source>
        <translation>Tant de fois plus grande</translation>
    </message>
    <message>
        <source>%1, as compared with the part that is open:</source>
        <translation>%1, par rapport à la pièce ouverte :</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>En miroir</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
    <message>
        <source>Find the faces again</source>
        <translation>Retrouver les faces</translation>
    </message>
</context>
<context>
    <name>OtherPartFeature</name>
    <message>
        <source>%1 of %2 faces were found again.</source>
        <translation>%1 faces sur %2 ont été retrouvées.</translation>
    </message>
    <message>
        <source>Moved: %1 by %2 mm</source>
        <translation>Déplacé : %1 de %2 mm</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message>
        <source>Apply to another part</source>
        <translation>Appliquer à une autre pièce</translation>
    </message>
    <message>
        <source>Parts (%1)</source>
        <translation>Pièces (%1)</translation>
    </message>
    <message>
        <source>Finding the faces again on %1</source>
        <translation>Recherche des faces sur %1</translation>
    </message>
    <message>
        <source>This is what was found again on %1:</source>
        <translation>Voici ce qui a été retrouvé sur %1 :</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Apply to %1</source>
        <translation>Appliquer à %1</translation>
    </message>
    <message>
        <source>Play carries out on %1 what was done before.</source>
        <translation>Lecture exécute sur %1 ce qui a été fait auparavant.</translation>
    </message>
</context>
<context>
    <name>PerformancePanel</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Commands and the motion of tools</source>
        <translation>Commandes et mouvement des outils</translation>
    </message>
    <message>
        <source>Vicinity</source>
        <translation>Voisinage</translation>
    </message>
    <message>
        <source>Finding what may touch</source>
        <translation>Trouver ce qui peut se toucher</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Plastic flow, breaking and annealing</source>
        <translation>Écoulement plastique, rupture et recuit</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Forces of structural connections, or the equations of an implicit step</source>
        <translation>Forces des liaisons structurelles, ou les équations d&apos;un pas implicite</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Forces of contacts, joints and fixtures</source>
        <translation>Forces des contacts, articulations et fixations</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Integration of velocities and positions</source>
        <translation>Intégration des vitesses et des positions</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>Health, the stable step, and states to go back to</source>
        <translation>Santé, pas stable et états de retour</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Instantané</translation>
    </message>
    <message>
        <source>Handing the state to the window</source>
        <translation>Remise de l&apos;état à la fenêtre</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs/step</source>
        <translation>%1 µs/pas</translation>
    </message>
    <message>
        <source>%1 ms/step</source>
        <translation>%1 ms/pas</translation>
    </message>
    <message>
        <source>Time of a frame; its whole length is a sixtieth of a second</source>
        <translation>Temps d&apos;une image&#xa0;; toute la longueur est un soixantième de seconde</translation>
    </message>
    <message>
        <source>Open a part and press play to see where the time goes.</source>
        <translation>Ouvrez une pièce et appuyez sur Lecture pour voir où passe le temps.</translation>
    </message>
    <message>
        <source>%1, %2 step of %3 per frame</source>
        <translation>%1, %2 pas de %3 par image</translation>
    </message>
    <message>
        <source>%1, %2 steps of %3 per frame</source>
        <translation>%1, %2 pas de %3 par image</translation>
    </message>
    <message>
        <source>%1 iterations of the solver in the last step, %2 objects</source>
        <translation>%1 itérations du solveur au dernier pas, %2 objets</translation>
    </message>
    <message>
        <source>%1 million connections per second, %2 objects</source>
        <translation>%1 millions de liaisons par seconde, %2 objets</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>Temps d&apos;une image</translation>
    </message>
</context>
<context>
    <name>PickTool</name>
    <message>
        <source>click a place</source>
        <translation>cliquer un point</translation>
    </message>
    <message>
        <source>click place %1 of %2</source>
        <translation>cliquer le point %1 sur %2</translation>
    </message>
    <message>
        <source>click a face</source>
        <translation>cliquer une face</translation>
    </message>
    <message>
        <source>click face %1 of %2</source>
        <translation>cliquer la face %1 sur %2</translation>
    </message>
    <message>
        <source>click a part</source>
        <translation>cliquer une pièce</translation>
    </message>
    <message>
        <source>%1: %2   Esc: done</source>
        <translation>%1&#xa0;: %2   Échap&#xa0;: fini</translation>
    </message>
    <message>
        <source>There is nothing at that place: click on a part.</source>
        <translation>Il n&apos;y a rien à cet endroit&#xa0;: cliquez sur une pièce.</translation>
    </message>
    <message>
        <source>This part is a mesh without CAD faces: measure it with places instead.</source>
        <translation>Cette pièce est un maillage sans faces de CAO&#xa0;: mesurez-la plutôt avec des points.</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>The picture cannot be written in this format (%1). Choose another one.</source>
        <translation>L&apos;image ne peut pas être écrite dans ce format (%1). Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>The picture cannot be written in %1 (%2). Free some room, or choose another place.</source>
        <translation>L&apos;image ne peut pas être écrite dans %1 (%2). Libérez de la place ou choisissez un autre endroit.</translation>
    </message>
</context>
<context>
    <name>PictureDialog</name>
    <message>
        <source>Save a picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>PNG, exact</source>
        <translation>PNG, exacte</translation>
    </message>
    <message>
        <source>JPEG, small</source>
        <translation>JPEG, petite</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fond transparent</translation>
    </message>
    <message>
        <source>With grid and shadow</source>
        <translation>Avec grille et ombre</translation>
    </message>
    <message>
        <source>With the view cube</source>
        <translation>Avec le cube de vue</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Choisir un endroit...</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, comme la vue</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Only PNG files can have a transparent background.</source>
        <translation>Seuls les fichiers PNG peuvent avoir un fond transparent.</translation>
    </message>
</context>
<context>
    <name>PictureFeature</name>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>writing the picture</source>
        <translation>écriture de l&apos;image</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Dessin de %1</translation>
    </message>
    <message>
        <source>%1: picture saved.</source>
        <translation>%1 : image enregistrée.</translation>
    </message>
</context>
<context>
    <name>PlaceRows</name>
    <message>
        <source>Show me</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Look there in the view (Enter)</source>
        <translation>Regarder là dans la vue (Entrée)</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Names that you gave, and what the command line says, stay as they are.</source>
        <translation>Les noms que vous avez donnés, et ce que dit la ligne de commande, restent tels quels.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Longueurs en</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimètres (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centimètres (cm)</translation>
    </message>
    <message>
        <source>Metres (m)</source>
        <translation>Mètres (m)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Pouces (in)</translation>
    </message>
    <message>
        <source>Speeds and volumes follow. Every field takes numbers in any unit, such as 12.5 mm, 12,5 mm or 0.5 in.</source>
        <translation>Vitesses et volumes suivent. Chaque champ prend des nombres en toute unité, comme 12.5 mm, 12,5 mm ou 0.5 in.</translation>
    </message>
    <message>
        <source>Memory and safety</source>
        <translation>Mémoire et sûreté</translation>
    </message>
    <message>
        <source>For undo</source>
        <translation>Pour l&apos;annulation</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>The oldest moments are dropped, and found again by repeating what was done.</source>
        <translation>Les moments les plus anciens sont abandonnés, et retrouvés en répétant ce qui a été fait.</translation>
    </message>
    <message>
        <source>For looking back</source>
        <translation>Pour regarder en arrière</translation>
    </message>
    <message>
        <source>When it is full, every second picture of the older half goes.</source>
        <translation>Quand elle est pleine, une image sur deux de la moitié la plus ancienne s&apos;en va.</translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation>Garder le travail non enregistré toutes les</translation>
    </message>
    <message>
        <source>After a crash, no more than this and two seconds are lost.</source>
        <translation>Après un plantage, pas plus que cela et deux secondes ne sont perdus.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Fils de calcul</translation>
    </message>
    <message>
        <source>All (%1)</source>
        <translation>Tous (%1)</translation>
    </message>
    <message>
        <source>That compute. The results are the same for any number.</source>
        <translation>Qui calculent. Les résultats sont les mêmes pour tout nombre.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Coarse (0.2 % of the size)</source>
        <translation>Grossier (0,2 % de la taille)</translation>
    </message>
    <message>
        <source>Normal (0.05 % of the size)</source>
        <translation>Normal (0,05 % de la taille)</translation>
    </message>
    <message>
        <source>Fine (0.0125 % of the size)</source>
        <translation>Fin (0,0125 % de la taille)</translation>
    </message>
    <message>
        <source>How far the triangles that are drawn and filled may lie beside the surfaces of a file. Open with choices asks for each file.</source>
        <translation>De combien les triangles dessinés et remplis peuvent s&apos;écarter des surfaces d&apos;un fichier. «&#xa0;Ouvrir avec des choix&#xa0;» le demande pour chaque fichier.</translation>
    </message>
    <message>
        <source>Give up reading after</source>
        <translation>Abandonner la lecture après</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>or with more memory than</source>
        <translation>ou avec plus de mémoire que</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> Gio</translation>
    </message>
    <message>
        <source>Automatic: by the size of the file.</source>
        <translation>Automatique&#xa0;: selon la taille du fichier.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Smooth edges</source>
        <translation>Bords lisses</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>2 samples</source>
        <translation>2 échantillons</translation>
    </message>
    <message>
        <source>4 samples</source>
        <translation>4 échantillons</translation>
    </message>
    <message>
        <source>8 samples</source>
        <translation>8 échantillons</translation>
    </message>
    <message>
        <source>More is slower without a graphics card.</source>
        <translation>Plus est plus lent sans carte graphique.</translation>
    </message>
    <message>
        <source>Turn smoothly from one view to another</source>
        <translation>Tourner en douceur d&apos;une vue à l&apos;autre</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Rétablir les valeurs d&apos;origine</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Mouse as in</source>
        <translation>Souris comme dans</translation>
    </message>
    <message>
        <source>Which buttons orbit, pan and zoom; the status bar tells. The wheel zooms to the cursor.</source>
        <translation>Les boutons qui tournent, glissent et zooment&#xa0;; la barre d&apos;état le dit. La molette zoome vers le curseur.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Taille du texte</translation>
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
        <translation>%1 ne se déforme pas : le rendre déformable dans les propriétés pour l&apos;enfoncer.</translation>
    </message>
    <message>
        <source>Press on %1</source>
        <translation>Presser %1</translation>
    </message>
    <message>
        <source>%1 (limit)</source>
        <translation>%1 (limite)</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it in the model tree to press with it.</source>
        <translation>%1 est verrouillé : le déverrouiller dans l&apos;arbre du modèle pour presser avec.</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Equivalent strain</source>
        <translation>Déformation équivalente</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Contrainte de von Mises</translation>
    </message>
    <message>
        <source>Force on tools</source>
        <translation>Force sur les outils</translation>
    </message>
    <message>
        <source>Force on all tools</source>
        <translation>Force sur tous les outils</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Déformation</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Contrainte</translation>
    </message>
    <message>
        <source>No probes yet. Place one on the part: it goes along with the material and plots what it reads, also of what was simulated before.</source>
        <translation>Pas encore de sonde. Placez-en une sur la pièce&#xa0;: elle suit le matériau et trace ce qu&apos;elle lit, même de ce qui a été simulé avant.</translation>
    </message>
    <message>
        <source>What is plotted over time</source>
        <translation>Ce qui est tracé au cours du temps</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Write all readings over time to a file, units in its header</source>
        <translation>Écrire toutes les valeurs au cours du temps dans un fichier, unités dans son en-tête</translation>
    </message>
    <message>
        <source>Delete the selected probes, or all</source>
        <translation>Supprimer les sondes choisies, ou toutes</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>Sonde %1</translation>
    </message>
    <message>
        <source>All tools</source>
        <translation>Tous les outils</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sondes</translation>
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
        <translation>Sondes</translation>
    </message>
    <message>
        <source>Write what the probes read</source>
        <translation>Écrire les valeurs des sondes</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Place probe</source>
        <translation>Placer une sonde</translation>
    </message>
    <message>
        <source>Click places of the part to plot what happens there over time</source>
        <translation>Cliquer des points de la pièce pour tracer ce qui s&apos;y passe au cours du temps</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>what was done last</source>
        <translation>ce qui a été fait en dernier</translation>
    </message>
    <message>
        <source>the state after &quot;%1&quot;</source>
        <translation>l&apos;état après «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a number in the table blobs is out of range</source>
        <translation>un nombre de la table blobs est hors limites</translation>
    </message>
    <message>
        <source>a row of the table blobs cannot be unpacked</source>
        <translation>une ligne de la table blobs ne peut pas être décomprimée</translation>
    </message>
    <message>
        <source>pieces of the table blobs are mixed up</source>
        <translation>des morceaux de la table blobs sont mélangés</translation>
    </message>
    <message>
        <source>Another window works on this: discard it there.</source>
        <translation>Une autre fenêtre y travaille&#xa0;: abandonnez-le là-bas.</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>cela ne peut pas être décomprimé</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>ce fichier n&apos;existe pas.</translation>
    </message>
    <message>
        <source>this is a folder, not a project.</source>
        <translation>c&apos;est un dossier, pas un projet.</translation>
    </message>
    <message>
        <source>this is no file, and no project either.</source>
        <translation>ce n&apos;est pas un fichier, ni un projet.</translation>
    </message>
    <message>
        <source>the file cannot be read; check its permissions.</source>
        <translation>le fichier ne peut pas être lu&#xa0;; vérifiez ses droits.</translation>
    </message>
    <message>
        <source>the file is empty.</source>
        <translation>le fichier est vide.</translation>
    </message>
    <message>
        <source>this is not a Knead project.</source>
        <translation>ce n&apos;est pas un projet Knead.</translation>
    </message>
    <message>
        <source>this is a database of another program, not a Knead project.</source>
        <translation>c&apos;est une base de données d&apos;un autre programme, pas un projet Knead.</translation>
    </message>
    <message>
        <source>%1: the project is damaged: %2. What is whole can be rescued.</source>
        <translation>%1&#xa0;: le projet est abîmé&#xa0;: %2. Ce qui est intact peut être sauvé.</translation>
    </message>
    <message>
        <source>there is a folder of this name; choose another name.</source>
        <translation>il y a un dossier de ce nom&#xa0;; choisissez un autre nom.</translation>
    </message>
    <message>
        <source>the file is read-only; save the project under another name.</source>
        <translation>le fichier est en lecture seule&#xa0;; enregistrez le projet sous un autre nom.</translation>
    </message>
    <message>
        <source>its tables are not those of a project</source>
        <translation>ses tables ne sont pas celles d&apos;un projet</translation>
    </message>
    <message>
        <source>a newer Knead saved this project (version %1 of the file; this program reads up to %2). Update Knead to open it.</source>
        <translation>un Knead plus récent a enregistré ce projet (version %1 du fichier&#xa0;; ce programme lit jusqu&apos;à la %2). Mettez Knead à jour pour l&apos;ouvrir.</translation>
    </message>
    <message>
        <source>what was written cannot be read back: %1</source>
        <translation>ce qui a été écrit ne peut pas être relu&#xa0;: %1</translation>
    </message>
    <message>
        <source>nothing of this project can be read any more; open a copy of it, or the part that it was made from.</source>
        <translation>plus rien de ce projet ne peut être lu&#xa0;; ouvrez-en une copie, ou la pièce dont il est issu.</translation>
    </message>
    <message>
        <source>another window works on it. Close it there, or open a copy.</source>
        <translation>une autre fenêtre y travaille. Fermez-le là-bas, ou ouvrez une copie.</translation>
    </message>
    <message>
        <source>another window of this program works on it. Close it there, or open a copy.</source>
        <translation>une autre fenêtre de ce programme y travaille. Fermez-le là-bas, ou ouvrez une copie.</translation>
    </message>
    <message>
        <source>another window works on it (process %1 on %2, since %3). Close it there, or open a copy.</source>
        <translation>une autre fenêtre y travaille (processus %1 sur %2, depuis %3). Fermez-le là-bas, ou ouvrez une copie.</translation>
    </message>
    <message>
        <source>a fixture is of a body that is not there</source>
        <translation>une fixation est d&apos;un corps qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>a fixture has objects that are not there</source>
        <translation>une fixation a des objets qui n&apos;existent pas</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>un nombre d&apos;éléments est négatif</translation>
    </message>
    <message>
        <source>rows of the table contents are mixed up</source>
        <translation>des lignes de la table contents sont mélangées</translation>
    </message>
    <message>
        <source>the number of rows of the table %1</source>
        <translation>le nombre de lignes de la table %1</translation>
    </message>
    <message>
        <source>the table %1</source>
        <translation>la table %1</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>le modèle</translation>
    </message>
    <message>
        <source>tool part %1</source>
        <translation>pièce outil %1</translation>
    </message>
    <message>
        <source>start state %1</source>
        <translation>état de départ %1</translation>
    </message>
    <message>
        <source>rows of the table bodies are mixed up</source>
        <translation>des lignes de la table bodies sont mélangées</translation>
    </message>
    <message>
        <source>a body is of a part that is not there</source>
        <translation>un corps est d&apos;une pièce qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>a region has objects that are not there</source>
        <translation>une région a des objets qui n&apos;existent pas</translation>
    </message>
    <message>
        <source>entry %1</source>
        <translation>entrée %1</translation>
    </message>
    <message>
        <source>which entry was shown</source>
        <translation>quelle entrée était montrée</translation>
    </message>
    <message>
        <source>that entry is missing</source>
        <translation>cette entrée manque</translation>
    </message>
    <message>
        <source>it follows a later one</source>
        <translation>elle suit une entrée postérieure</translation>
    </message>
    <message>
        <source>the entry that it follows is missing</source>
        <translation>l&apos;entrée qu&apos;elle suit manque</translation>
    </message>
    <message>
        <source>its start state is missing</source>
        <translation>son état de départ manque</translation>
    </message>
    <message>
        <source>the state of entry %1</source>
        <translation>l&apos;état de l&apos;entrée %1</translation>
    </message>
    <message>
        <source>it is of another length</source>
        <translation>il est d&apos;une autre longueur</translation>
    </message>
    <message>
        <source>the view</source>
        <translation>la vue</translation>
    </message>
    <message>
        <source>mark %1</source>
        <translation>repère %1</translation>
    </message>
    <message>
        <source>its entry is missing</source>
        <translation>son entrée manque</translation>
    </message>
    <message>
        <source>what panel %1 kept</source>
        <translation>ce que le panneau %1 gardait</translation>
    </message>
    <message>
        <source>The work cannot be kept for recovery (%1). Save the project, and make room in %2.</source>
        <translation>Le travail ne peut pas être gardé pour la récupération (%1). Enregistrez le projet, et faites de la place dans %2.</translation>
    </message>
    <message>
        <source>Nothing of the work that was kept in %1 can be read any more. Discard it, and open what was saved last.</source>
        <translation>Plus rien du travail gardé dans %1 ne peut être lu. Abandonnez-le, et ouvrez ce qui a été enregistré en dernier.</translation>
    </message>
    <message>
        <source>its folder cannot be locked</source>
        <translation>son dossier ne peut pas être verrouillé</translation>
    </message>
    <message>
        <source>Another window works on this already, or it was discarded: look for it there.</source>
        <translation>Une autre fenêtre y travaille déjà, ou il a été abandonné&#xa0;: cherchez-le là-bas.</translation>
    </message>
    <message>
        <source>row %1 of the table %2</source>
        <translation>la ligne %1 de la table %2</translation>
    </message>
    <message>
        <source>a value in the table %1 is of the wrong kind</source>
        <translation>une valeur de la table %1 est du mauvais genre</translation>
    </message>
    <message>
        <source>a number in the table %1 is out of range</source>
        <translation>un nombre de la table %1 est hors limites</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manque</translation>
    </message>
    <message>
        <source>%1 is not as it was written</source>
        <translation>%1 n&apos;est pas comme elle a été écrite</translation>
    </message>
    <message>
        <source>what was done to the parts</source>
        <translation>ce qui a été fait aux pièces</translation>
    </message>
    <message>
        <source>%1: what was seen last cannot be shown. %2 What is whole can be rescued.</source>
        <translation>%1&#xa0;: ce qui a été vu en dernier ne peut pas être montré. %2 Ce qui est intact peut être sauvé.</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Récupéré</translation>
    </message>
    <message>
        <source>what entries are called</source>
        <translation>le nom des entrées</translation>
    </message>
    <message>
        <source>what entry %1 is called</source>
        <translation>le nom de l&apos;entrée %1</translation>
    </message>
    <message>
        <source>it is no sentence</source>
        <translation>ce n&apos;est pas une phrase</translation>
    </message>
    <message>
        <source>the file holds triggers, views or virtual tables, which no Knead writes: somebody else put them there. Nothing of it was opened.</source>
        <translation>le fichier contient des déclencheurs, des vues ou des tables virtuelles, qu’aucun Knead n’écrit : quelqu’un d’autre les y a mis. Rien n’en a été ouvert.</translation>
    </message>
    <message>
        <source>how the parts of start state %1 were deformed</source>
        <translation>comment les pièces de l’état de départ %1 ont été déformées</translation>
    </message>
    <message>
        <source>Nothing was opened; the file is damaged or far too large.</source>
        <translation>Rien n&apos;a été ouvert ; le fichier est endommagé ou beaucoup trop gros.</translation>
    </message>
    <message>
        <source>Nothing was opened; open a copy of the project, or the part that it was made from.</source>
        <translation>Rien n&apos;a été ouvert ; ouvrez une copie du projet, ou la pièce dont il est issu.</translation>
    </message>
    <message>
        <source>the project asks for more memory than there is.</source>
        <translation>le projet demande plus de mémoire qu&apos;il n&apos;y en a.</translation>
    </message>
</context>
<context>
    <name>ProjectKeeper</name>
    <message>
        <source>The work is kept for recovery again.</source>
        <translation>Le travail est de nouveau gardé pour la récupération.</translation>
    </message>
    <message>
        <source>Knead projects (*.%1)</source>
        <translation>Projets Knead (*.%1)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>Récupération de %1</translation>
    </message>
    <message>
        <source>Rescuing %1</source>
        <translation>Sauvetage de %1</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Rescue what is whole</source>
        <translation>Sauver ce qui est intact</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Enregistrer sous...</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message>
        <source>Not whole: %1</source>
        <translation>Pas intact&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not everything is whole</source>
        <translation>Tout n&apos;est pas intact</translation>
    </message>
    <message>
        <source>This could not be brought back:</source>
        <translation>Ceci n&apos;a pas pu être retrouvé&#xa0;:</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover.</source>
        <translation>Il n&apos;y a pas de travail non enregistré à récupérer.</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name, or choose that file.</source>
        <translation>%1 existe déjà&#xa0;: choisissez un autre nom, ou choisissez ce fichier.</translation>
    </message>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc, and save again.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap, puis enregistrez de nouveau.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistré.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>Save the work on &quot;%1&quot; as a project?</source>
        <translation>Enregistrer le travail sur «&#xa0;%1&#xa0;» comme projet&#xa0;?</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>Enregistrer les changements de «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>It has never been saved.</source>
        <translation>Il n&apos;a jamais été enregistré.</translation>
    </message>
    <message>
        <source>What was done since it was saved is lost otherwise.</source>
        <translation>Sinon, ce qui a été fait depuis l&apos;enregistrement est perdu.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Ignorer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
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
        <translation>Vider la liste</translation>
    </message>
    <message>
        <source>%1 is not there any more. It may have been moved: look for it with Ctrl+O.</source>
        <translation>%1 n&apos;est plus là. Il a peut-être été déplacé&#xa0;: cherchez-le avec Ctrl+O.</translation>
    </message>
    <message>
        <source>A project is opened alone: choose one file, or only parts.</source>
        <translation>Un projet s&apos;ouvre seul&#xa0;: choisissez un fichier, ou seulement des pièces.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouvrir &amp;récent</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>Exe&amp;mples</translation>
    </message>
    <message>
        <source>Closed %1.</source>
        <translation>%1 fermé.</translation>
    </message>
</context>
<context>
    <name>PropertyPages</name>
    <message>
        <source>Nothing selected.</source>
        <translation>Rien de choisi.</translation>
    </message>
</context>
<context>
    <name>Python</name>
    <message>
        <source>There is no material &quot;%1&quot;; knead.Material.presets() lists their names.</source>
        <translation>Il n&apos;y a pas de matériau « %1 » ; knead.Material.presets() donne leurs noms.</translation>
    </message>
    <message>
        <source>%1 has no parts.</source>
        <translation>%1 n&apos;a pas de pièces.</translation>
    </message>
    <message>
        <source>This tool is no longer in the simulation.</source>
        <translation>Cet outil n&apos;est plus dans la simulation.</translation>
    </message>
    <message>
        <source>This simulation is in the midst of computing; ask for it when that is done.</source>
        <translation>Cette simulation est en plein calcul ; interrogez-la quand il sera terminé.</translation>
    </message>
    <message>
        <source>A simulation needs a body; make one of a part with knead.fill().</source>
        <translation>Une simulation a besoin d&apos;un corps ; faites-en un d&apos;une pièce avec knead.fill().</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no face %2; it has %3.</source>
        <translation>« %1 » n&apos;a pas de face %2 ; elle en a %3.</translation>
    </message>
    <message>
        <source>The fixture of &quot;%1&quot; holds nothing: no object lies there.</source>
        <translation>La fixation de « %1 » ne tient rien : aucun objet ne s&apos;y trouve.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no object %2; it has %3.</source>
        <translation>« %1 » n&apos;a pas d&apos;objet %2 ; elle en a %3.</translation>
    </message>
    <message>
        <source>Step %1 cannot be gone on to: the simulation is at step %2.</source>
        <translation>On ne peut pas avancer jusqu&apos;au pas %1 : la simulation en est au pas %2.</translation>
    </message>
    <message>
        <source>A rotation is a quaternion (w, x, y, z) of length 1; knead.rotation(axis, angle) makes one.</source>
        <translation>Une rotation est un quaternion (w, x, y, z) de longueur 1 ; knead.rotation(axis, angle) en fait un.</translation>
    </message>
    <message>
        <source>A key frame is (time, position) or (time, position, rotation).</source>
        <translation>Une image clé est (time, position) ou (time, position, rotation).</translation>
    </message>
    <message>
        <source>There is no tool &quot;%1&quot;; there are box, ball, cylinder, wedge and plate.</source>
        <translation>Il n&apos;y a pas d&apos;outil « %1 » ; il y a box, ball, cylinder, wedge et plate.</translation>
    </message>
    <message>
        <source>The size of a tool is the diameter of a ball, (diameter, length) of a cylinder, and three lengths of all others, in metres.</source>
        <translation>La taille d&apos;un outil est le diamètre d&apos;une bille, (diamètre, longueur) d&apos;un cylindre et trois longueurs pour tous les autres, en mètres.</translation>
    </message>
    <message>
        <source>There is no choice &quot;%1&quot; here; there are: %2.</source>
        <translation>Il n&apos;y a pas de choix « %1 » ici ; il y a : %2.</translation>
    </message>
    <message>
        <source>This moment is of another simulation; go to one that this one has kept.</source>
        <translation>Ce moment est d&apos;une autre simulation ; allez à un moment que celle-ci a gardé.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1x real time</source>
        <translation>%1x le temps réel</translation>
    </message>
</context>
<context>
    <name>QuantityField</name>
    <message>
        <source>&quot;%1&quot; is not a number here; the value is still %2. Esc restores it.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre ici&#xa0;; la valeur reste %2. Échap la rétablit.</translation>
    </message>
    <message>
        <source>Allowed is %1 to %2; the value is still %3. Esc restores it.</source>
        <translation>De %1 à %2 est permis&#xa0;; la valeur reste %3. Échap la rétablit.</translation>
    </message>
    <message>
        <source>Allowed: %1 to %2</source>
        <translation>Permis&#xa0;: de %1 à %2</translation>
    </message>
    <message>
        <source>Allowed: %1 or more</source>
        <translation>Permis&#xa0;: %1 ou plus</translation>
    </message>
    <message>
        <source>A number, such as 0.5, 0,5 or 5e-1</source>
        <translation>Un nombre, comme 0.5, 0,5 ou 5e-1</translation>
    </message>
    <message>
        <source>Units: %1</source>
        <translation>Unités&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>ReadProject</name>
    <message>
        <source>%1 was written after this work was cut off, and stays as it is: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 a été écrit après l&apos;interruption de ce travail et reste tel quel&#xa0;: enregistrez le travail sous un nom à lui, ou à la place de ce fichier.</translation>
    </message>
    <message>
        <source>%1 stays as it is, since the recovered work is not whole: save the work under a name of its own, or in place of that file.</source>
        <translation>%1 reste tel quel, car le travail récupéré n&apos;est pas entier&#xa0;: enregistrez le travail sous un nom à lui, ou à la place de ce fichier.</translation>
    </message>
    <message>
        <source>The parts of this project are lost, so that nothing of it can be shown. Open the part that it was made from.</source>
        <translation>Les pièces de ce projet sont perdues, si bien que rien ne peut en être montré. Ouvrez la pièce dont il a été fait.</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>la sonde « %1 »</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it was filled anew with %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 nomme des objets d&apos;un corps qui a été rempli de nouveau avec %2, et ici il l&apos;a été avec %3. Nommez plutôt une boîte, ou gardez l&apos;espacement et ce qui est fait avant.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that was filled anew with %2, and here it is filled with the first %3. Name a box instead, or keep the spacing and what is done before.</source>
        <translation>%1 nomme des objets d&apos;un corps qui a été rempli de nouveau avec %2, et ici il est rempli des %3 premiers. Nommez plutôt une boîte, ou gardez l&apos;espacement et ce qui est fait avant.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not closed and is left out.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas fermée et est omise.</translation>
    </message>
    <message>
        <source>%1 has no tool part %2; it has %3 of them, counted from 0.</source>
        <translation>%1 n&apos;a pas de pièce outil %2&#xa0;; il en a %3, comptées à partir de 0.</translation>
    </message>
    <message>
        <source>the project has no parts.</source>
        <translation>le projet n&apos;a pas de pièces.</translation>
    </message>
    <message>
        <source>%1 names faces, but &quot;%2&quot; is a mesh without CAD faces; use box_mm.</source>
        <translation>%1 nomme des faces, mais «&#xa0;%2&#xa0;» est un maillage sans faces de CAO&#xa0;; utilisez box_mm.</translation>
    </message>
    <message>
        <source>%1 names the face %2, but &quot;%3&quot; has faces 0 to %4.</source>
        <translation>%1 nomme la face %2, mais «&#xa0;%3&#xa0;» a les faces 0 à %4.</translation>
    </message>
    <message>
        <source>%1 names faces of one body among several; add the key body.</source>
        <translation>%1 nomme des faces d&apos;un corps parmi plusieurs&#xa0;; ajoutez la clé body.</translation>
    </message>
    <message>
        <source>%1 holds nothing: no object lies there.</source>
        <translation>%1 ne tient rien&#xa0;: aucun objet ne s&apos;y trouve.</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>la région «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 names the body &quot;%2&quot;; the part has: %3.</source>
        <translation>%1 nomme le corps «&#xa0;%2&#xa0;»&#xa0;; la pièce a&#xa0;: %3.</translation>
    </message>
    <message>
        <source>%1 names objects of one body among several; add the key body.</source>
        <translation>%1 nomme des objets d&apos;un corps parmi plusieurs&#xa0;; ajoutez la clé body.</translation>
    </message>
    <message>
        <source>%1 names objects of a body that is filled with %2, and here it is filled with %3. Name a box instead, or keep the spacing.</source>
        <translation>%1 nomme des objets d&apos;un corps rempli de %2, et ici il est rempli de %3. Nommez plutôt une boîte, ou gardez l&apos;espacement.</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>la fixation «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>la charge «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 is on one body among several; add the key body.</source>
        <translation>%1 est sur un corps parmi plusieurs&#xa0;; ajoutez la clé body.</translation>
    </message>
    <message>
        <source>%1 acts on nothing: no surface lies there.</source>
        <translation>%1 n&apos;agit sur rien&#xa0;: aucune surface ne s&apos;y trouve.</translation>
    </message>
    <message>
        <source>This recipe asks for balance without inertia, which &quot;knead run&quot; finds. Play carries it out as motion in time.</source>
        <translation>Cette recette demande un équilibre sans inertie, que «&#xa0;knead run&#xa0;» trouve. La lecture l&apos;exécute comme un mouvement dans le temps.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>%1, line %2: %3 %4</source>
        <translation>%1, ligne %2&#xa0;: %3 %4</translation>
    </message>
    <message>
        <source>%1, got %2.</source>
        <translation>%1&#xa0;; il y a %2.</translation>
    </message>
    <message>
        <source>must be an object in { }</source>
        <translation>doit être un objet entre { }</translation>
    </message>
    <message>
        <source>must have the key &quot;%1&quot;.</source>
        <translation>doit avoir la clé «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>is not a known key; allowed here: %1.</source>
        <translation>n&apos;est pas une clé connue&#xa0;; permises ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>must be a list in [ ]</source>
        <translation>doit être une liste entre [ ]</translation>
    </message>
    <message>
        <source>must be a text in quotes that is not empty</source>
        <translation>doit être un texte non vide entre guillemets</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>doit être true ou false</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>doit être un nombre</translation>
    </message>
    <message>
        <source>must be a number between %1 and %2</source>
        <translation>doit être un nombre entre %1 et %2</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>doit être un nombre positif</translation>
    </message>
    <message>
        <source>must be a whole number between %1 and %2</source>
        <translation>doit être un nombre entier entre %1 et %2</translation>
    </message>
    <message>
        <source>must be a whole number between 0 and %1</source>
        <translation>doit être un nombre entier entre 0 et %1</translation>
    </message>
    <message>
        <source>must hold %1 numbers</source>
        <translation>doit contenir %1 nombres</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>%1: the key &quot;%2&quot; is given twice in the same object.</source>
        <translation>%1&#xa0;: la clé «&#xa0;%2&#xa0;» est donnée deux fois dans le même objet.</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1&#xa0;: des listes et objets sont imbriqués sur plus de %2 niveaux.</translation>
    </message>
    <message>
        <source>is used twice: &quot;%1&quot;.</source>
        <translation>est utilisé deux fois&#xa0;: «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>must hold the first and the last number of a stretch</source>
        <translation>doit contenir le premier et le dernier numéro d&apos;une suite</translation>
    </message>
    <message>
        <source>makes a list longer than any that this program writes</source>
        <translation>donne une liste plus longue que toutes celles que ce programme écrit</translation>
    </message>
    <message>
        <source>must be the number of a tool part of the project</source>
        <translation>doit être le numéro d&apos;une pièce outil du projet</translation>
    </message>
    <message>
        <source>must be one of those that this program knows</source>
        <translation>doit être l&apos;un de ceux que ce programme connaît</translation>
    </message>
    <message>
        <source>must be the number of a part</source>
        <translation>doit être le numéro d&apos;une pièce</translation>
    </message>
    <message>
        <source>must have only one of the keys box_mm and objects.</source>
        <translation>ne doit avoir qu&apos;une des clés box_mm et objects.</translation>
    </message>
    <message>
        <source>must have at least one of the keys velocity_mm_s and turn.</source>
        <translation>doit avoir au moins une des clés velocity_mm_s et turn.</translation>
    </message>
    <message>
        <source>must not be 0: it says which way the plane faces.</source>
        <translation>ne doit pas être 0&#xa0;: cela dit de quel côté le plan est tourné.</translation>
    </message>
    <message>
        <source>must be true.</source>
        <translation>doit être true.</translation>
    </message>
    <message>
        <source>must have only one of the keys %1 and %2.</source>
        <translation>ne doit avoir qu&apos;une des clés %1 et %2.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys %1.</source>
        <translation>doit avoir exactement une des clés %1.</translation>
    </message>
    <message>
        <source>must have either time_s or step.</source>
        <translation>doit avoir soit time_s, soit step.</translation>
    </message>
    <message>
        <source>needs an event with a step; say keyframes for times.</source>
        <translation>demande un événement avec un pas (step)&#xa0;; pour des temps, dites keyframes.</translation>
    </message>
    <message>
        <source>must have only one of the keys path and %1.</source>
        <translation>ne doit avoir qu&apos;une des clés path et %1.</translation>
    </message>
    <message>
        <source>belongs to a change of material only.</source>
        <translation>n&apos;appartient qu&apos;à un changement de matériau.</translation>
    </message>
    <message>
        <source>must be one of %1 or a direction of 3 numbers</source>
        <translation>doit être l&apos;un de %1 ou une direction de 3 nombres</translation>
    </message>
    <message>
        <source>must be a direction of 3 numbers that are not all 0</source>
        <translation>doit être une direction de 3 nombres qui ne sont pas tous 0</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>doit être l&apos;un de %1</translation>
    </message>
    <message>
        <source>must be a path inside the output folder</source>
        <translation>doit être un chemin à l&apos;intérieur du dossier de sortie</translation>
    </message>
    <message>
        <source>must end in one of %1</source>
        <translation>doit se terminer par l&apos;un de %1</translation>
    </message>
    <message>
        <source>must have either axis and speed_deg_s, or angular_velocity_rad_s.</source>
        <translation>doit avoir soit axis et speed_deg_s, soit angular_velocity_rad_s.</translation>
    </message>
    <message>
        <source>must have only one of the keys angle_deg and angle_rad.</source>
        <translation>ne doit avoir qu&apos;une des clés angle_deg et angle_rad.</translation>
    </message>
    <message>
        <source>belongs to manipulators of the kind part only.</source>
        <translation>n&apos;appartient qu&apos;aux outils du genre part.</translation>
    </message>
    <message>
        <source>does not belong to the kind part; its file says how large it is.</source>
        <translation>n&apos;appartient pas au genre part&#xa0;; son fichier en dit la taille.</translation>
    </message>
    <message>
        <source>must be later than the frame before it</source>
        <translation>doit être après l&apos;image clé précédente</translation>
    </message>
    <message>
        <source>asks for a speed of %1 mm/s; speed_limit_mm_s allows %2.</source>
        <translation>demande une vitesse de %1 mm/s&#xa0;; speed_limit_mm_s permet %2.</translation>
    </message>
    <message>
        <source>must be false where the tool is neither a ball nor a cylinder</source>
        <translation>doit être false quand l&apos;outil n&apos;est ni une boule ni un cylindre</translation>
    </message>
    <message>
        <source>must have only one of the keys keyframes and motion.</source>
        <translation>ne doit avoir qu&apos;une des clés keyframes et motion.</translation>
    </message>
    <message>
        <source>must hold at least one frame.</source>
        <translation>doit contenir au moins une image clé.</translation>
    </message>
    <message>
        <source>belongs to velocity_mm_s.</source>
        <translation>appartient à velocity_mm_s.</translation>
    </message>
    <message>
        <source>must be true; leave it out to say another motion.</source>
        <translation>doit être true&#xa0;; omettez-le pour dire un autre mouvement.</translation>
    </message>
    <message>
        <source>must hold a step and x, y, z, perhaps with w, x, y, z of a rotation</source>
        <translation>doit contenir un pas et x, y, z, peut-être avec w, x, y, z d&apos;une rotation</translation>
    </message>
    <message>
        <source>must not be less than in the row before it</source>
        <translation>ne doit pas être moindre que dans la ligne précédente</translation>
    </message>
    <message>
        <source>lies further than a kilometer away.</source>
        <translation>est à plus d&apos;un kilomètre.</translation>
    </message>
    <message>
        <source>must end with a quaternion of length 1</source>
        <translation>doit se terminer par un quaternion de longueur 1</translation>
    </message>
    <message>
        <source>must hold at least one row.</source>
        <translation>doit contenir au moins une ligne.</translation>
    </message>
    <message>
        <source>the project has no bodies.</source>
        <translation>le projet n&apos;a pas de corps.</translation>
    </message>
    <message>
        <source>some of its parts could not be filled with objects, which a recipe takes for an error.</source>
        <translation>certaines de ses pièces n&apos;ont pas pu être remplies d&apos;objets, ce qu&apos;une recette prend pour une erreur.</translation>
    </message>
    <message>
        <source>its bodies differ in their spacing or structural friction.</source>
        <translation>ses corps diffèrent par leur espacement ou leur frottement structurel.</translation>
    </message>
    <message>
        <source>the files of its parts are not there any more; save the project first.</source>
        <translation>les fichiers de ses pièces ne sont plus là&#xa0;; enregistrez d&apos;abord le projet.</translation>
    </message>
    <message>
        <source>The files that the parts were read from are not there any more: the recipe takes the parts from the project.</source>
        <translation>Les fichiers dont les pièces ont été lues ne sont plus là&#xa0;: la recette prend les pièces du projet.</translation>
    </message>
    <message>
        <source>The recipe begins where the part was filled last; what was done before left nothing behind but tools, materials and fixtures.</source>
        <translation>La recette commence là où la pièce a été remplie en dernier&#xa0;; ce qui a été fait avant n&apos;a laissé que des outils, des matériaux et des fixations.</translation>
    </message>
    <message>
        <source>The project has nothing in it yet that a recipe could say.</source>
        <translation>Il n&apos;y a encore rien dans le projet qu&apos;une recette puisse dire.</translation>
    </message>
    <message>
        <source>A recipe cannot say what was done here: %1</source>
        <translation>Une recette ne peut pas dire ce qui a été fait ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is %2, which has nothing in it to set.</source>
        <translation>%1 est %2, où il n&apos;y a rien à fixer.</translation>
    </message>
    <message>
        <source>%1 has no item &quot;%2&quot;; allowed here: %3.</source>
        <translation>%1 n&apos;a pas d&apos;élément «&#xa0;%2&#xa0;»&#xa0;; permis ici&#xa0;: %3.</translation>
    </message>
    <message>
        <source>a whole list, since this one is empty</source>
        <translation>une liste entière, puisque celle-ci est vide</translation>
    </message>
    <message>
        <source>the number 0</source>
        <translation>le numéro 0</translation>
    </message>
    <message>
        <source>the numbers 0 to %1</source>
        <translation>les numéros 0 à %1</translation>
    </message>
    <message>
        <source>%1 and the names %2</source>
        <translation>%1 et les noms %2</translation>
    </message>
    <message>
        <source>the path has an empty step; between two dots there must be a key, a name or a number.</source>
        <translation>le chemin a une étape vide&#xa0;; entre deux points, il faut une clé, un nom ou un numéro.</translation>
    </message>
    <message>
        <source>the path ends with a dot; name what is to be set after it.</source>
        <translation>le chemin se termine par un point&#xa0;; nommez ensuite ce qui doit être fixé.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be set: %3</source>
        <translation>%1&#xa0;: %2 ne peut pas être fixé&#xa0;: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sets nothing; write PATH=VALUE, for example spacing_mm=3.</source>
        <translation>«&#xa0;%1&#xa0;» ne fixe rien&#xa0;; écrivez CHEMIN=VALEUR, par exemple spacing_mm=3.</translation>
    </message>
    <message>
        <source>must have either file or files.</source>
        <translation>doit avoir soit file, soit files.</translation>
    </message>
    <message>
        <source>must hold at least one file.</source>
        <translation>doit contenir au moins un fichier.</translation>
    </message>
    <message>
        <source>a fixture holds no object of its body.</source>
        <translation>une fixation ne tient aucun objet de son corps.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects.</source>
        <translation>doit avoir exactement une des clés spacing_mm, cells_across, cells_across_wall et objects.</translation>
    </message>
    <message>
        <source>belongs to events: at the start nothing has been filled anew.</source>
        <translation>appartient aux événements&#xa0;: au début, rien n&apos;a été rempli de nouveau.</translation>
    </message>
    <message>
        <source>is written twice: &quot;%1&quot;.</source>
        <translation>est écrit deux fois&#xa0;: «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>is &quot;published&quot;, which needs spacing_mm.</source>
        <translation>est «&#xa0;published&#xa0;», qui demande spacing_mm.</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is not in the recipe.</source>
        <translation>nomme «&#xa0;%1&#xa0;», qui n&apos;est pas dans la recette.</translation>
    </message>
    <message>
        <source>must not be earlier than that of the event before it</source>
        <translation>ne doit pas être avant celui de l&apos;événement précédent</translation>
    </message>
    <message>
        <source>must not be less than that of the event before it</source>
        <translation>ne doit pas être moindre que celui de l&apos;événement précédent</translation>
    </message>
    <message>
        <source>must have only one of the keys duration_s and duration_steps.</source>
        <translation>ne doit avoir qu&apos;une des clés duration_s et duration_steps.</translation>
    </message>
    <message>
        <source>must be at most 3600 s</source>
        <translation>doit être d&apos;au plus 3600 s</translation>
    </message>
    <message>
        <source>belongs to a dynamic analysis only.</source>
        <translation>n&apos;appartient qu&apos;à une analyse dynamique.</translation>
    </message>
    <message>
        <source>belongs to a static analysis only.</source>
        <translation>n&apos;appartient qu&apos;à une analyse statique.</translation>
    </message>
    <message>
        <source>names the unknown material &quot;%1&quot;; known are: %2.</source>
        <translation>nomme le matériau inconnu «&#xa0;%1&#xa0;»&#xa0;; sont connus&#xa0;: %2.</translation>
    </message>
    <message>
        <source>must hold at least one face.</source>
        <translation>doit contenir au moins une face.</translation>
    </message>
    <message>
        <source>must be the name of a material or an object in { }</source>
        <translation>doit être le nom d&apos;un matériau ou un objet entre { }</translation>
    </message>
    <message>
        <source>must have both of the keys objects and objects_in_body, or none.</source>
        <translation>doit avoir les deux clés objects et objects_in_body, ou aucune.</translation>
    </message>
    <message>
        <source>belongs to objects.</source>
        <translation>appartient à objects.</translation>
    </message>
    <message>
        <source>must go on upwards, below objects_in_body</source>
        <translation>doit continuer en montant, sous objects_in_body</translation>
    </message>
    <message>
        <source>must hold at least one object.</source>
        <translation>doit contenir au moins un objet.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys faces, box_mm and objects.</source>
        <translation>doit avoir exactement une des clés faces, box_mm et objects.</translation>
    </message>
    <message>
        <source>must have only one of the keys angular_velocity_deg_s and angular_velocity_rad_s.</source>
        <translation>ne doit avoir qu&apos;une des clés angular_velocity_deg_s et angular_velocity_rad_s.</translation>
    </message>
    <message>
        <source>must hold 3 numbers no larger than %1</source>
        <translation>doit contenir 3 nombres d&apos;au plus %1</translation>
    </message>
    <message>
        <source>must hold the lowest x, y, z and then the highest x, y, z</source>
        <translation>doit contenir les x, y, z les plus bas puis les x, y, z les plus hauts</translation>
    </message>
    <message>
        <source>must hold w, x, y, z of a quaternion of length 1</source>
        <translation>doit contenir w, x, y, z d&apos;un quaternion de longueur 1</translation>
    </message>
    <message>
        <source>must have only one of the keys rotation_deg and rotation_wxyz.</source>
        <translation>ne doit avoir qu&apos;une des clés rotation_deg et rotation_wxyz.</translation>
    </message>
    <message>
        <source>must hold %1 positive numbers</source>
        <translation>doit contenir %1 nombres positifs</translation>
    </message>
    <message>
        <source>names a file that does not exist: %1. The path is taken from the folder of the recipe.</source>
        <translation>nomme un fichier qui n&apos;existe pas&#xa0;: %1. Le chemin part du dossier de la recette.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot; is an imported part, which only a saved project keeps.</source>
        <translation>l&apos;outil «&#xa0;%1&#xa0;» est une pièce importée, que seul un projet enregistré garde.</translation>
    </message>
    <message>
        <source>The output folder %1 cannot be made; choose another one with --out.</source>
        <translation>Le dossier de sortie %1 ne peut pas être créé&#xa0;; choisissez-en un autre avec --out.</translation>
    </message>
    <message>
        <source>%1 lies far away from all bodies; its place is in mm.</source>
        <translation>%1 est loin de tous les corps ; sa place est en mm.</translation>
    </message>
    <message>
        <source>it has no probes whose readings could be written; add the key probes.</source>
        <translation>elle n&apos;a pas de sondes dont on pourrait écrire les mesures ; ajoutez la clé probes.</translation>
    </message>
    <message>
        <source>The probes of this recipe are read by &quot;knead run&quot;. Put probes on the part to read them here.</source>
        <translation>Les sondes de cette recette sont lues par « knead run ». Posez des sondes sur la pièce pour les lire ici.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; names the body &quot;%1&quot;, which the part does not have.</source>
        <translation>« deform » nomme le corps « %1 », que la pièce n’a pas.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces; name the body that they are of.</source>
        <translation>« deform » garde des faces en place ; nommez le corps auquel elles appartiennent.</translation>
    </message>
    <message>
        <source>Fields in files cannot be read here; deform by numbers, or use &quot;knead morph&quot;.</source>
        <translation>Les champs dans des fichiers ne peuvent pas être lus ici ; déformez par des nombres, ou utilisez « knead morph ».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not come out sound when it was deformed; look at it closely.</source>
        <translation>« %1 » n’est pas ressorti sain de sa déformation ; examinez-le de près.</translation>
    </message>
    <message>
        <source>does not belong to the kind %1.</source>
        <translation>n’appartient pas au genre %1.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg, angle_rad and radius_mm.</source>
        <translation>doit avoir exactement une des clés angle_deg, angle_rad et radius_mm.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys angle_deg and angle_rad.</source>
        <translation>doit avoir exactement une des clés angle_deg et angle_rad.</translation>
    </message>
    <message>
        <source>must point across the axis.</source>
        <translation>doit pointer en travers de l’axe.</translation>
    </message>
    <message>
        <source>must be larger than from_mm.</source>
        <translation>doit être plus grand que from_mm.</translation>
    </message>
    <message>
        <source>cannot be: %1</source>
        <translation>est impossible : %1</translation>
    </message>
    <message>
        <source>must have both of the keys kept_faces and fade_mm, or none.</source>
        <translation>doit avoir les deux clés kept_faces et fade_mm, ou aucune.</translation>
    </message>
    <message>
        <source>parts beside the first that were placed cannot be written.</source>
        <translation>des pièces placées à côté de la première ne peuvent pas être écrites.</translation>
    </message>
    <message>
        <source>pictures to write cannot be written into a recipe.</source>
        <translation>des images à écrire ne peuvent pas être mises dans une recette.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps face %1 of &quot;%2&quot;, which has %3; they are numbered from 0.</source>
        <translation>« deform » garde la face %1 de « %2 », qui en a %3 ; elles sont numérotées à partir de 0.</translation>
    </message>
    <message>
        <source>is so small that the bend goes around more than ten times; take a larger one.</source>
        <translation>est si petit que la flexion fait plus de dix tours ; prenez-en un plus grand.</translation>
    </message>
    <message>
        <source>&quot;deform&quot; keeps faces of the body &quot;%1&quot;, which it does not deform.</source>
        <translation>« deform » garde en place des faces du corps « %1 », qu’il ne déforme pas.</translation>
    </message>
    <message>
        <source>must have one of the keys neutral_mm and k_factor, or none.</source>
        <translation>doit avoir l’une des clés neutral_mm et k_factor, ou aucune.</translation>
    </message>
    <message>
        <source>must name at least one body.</source>
        <translation>doit nommer au moins un corps.</translation>
    </message>
    <message>
        <source>must have one item for each object</source>
        <translation>doit avoir un élément pour chaque objet</translation>
    </message>
    <message>
        <source>cannot be done by physics, since grips do not change the ends; say it in &quot;deform&quot;.</source>
        <translation>ne peut pas se faire par la physique, car les prises ne changent pas les extrémités ; dites-le dans « deform ».</translation>
    </message>
    <message>
        <source>its parts were deformed after they were kneaded, or by a field whose file is not there any more, or others were added, and only a project keeps them so; save the project first.</source>
        <translation>ses pièces ont été déformées après avoir été pétries, ou par un champ dont le fichier n&apos;est plus là, ou d&apos;autres ont été ajoutées, et seul un projet les garde ainsi ; enregistrez d&apos;abord le projet.</translation>
    </message>
    <message>
        <source>The parts were deformed by numbers or by a field, or others were added: the recipe takes them from the project, as they were then.</source>
        <translation>Les pièces ont été déformées par des nombres ou par un champ, ou d&apos;autres ont été ajoutées : la recette les prend dans le projet, telles qu&apos;elles étaient alors.</translation>
    </message>
</context>
<context>
    <name>RecipesFeature</name>
    <message>
        <source>A recipe is opened alone: choose one file, or only parts.</source>
        <translation>Une recette s&apos;ouvre seule&#xa0;: choisissez un fichier, ou seulement des pièces.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Play carries out %1; what is done by hand comes on top of it.</source>
        <translation>Lecture exécute %1&#xa0;; ce qui est fait à la main s&apos;y ajoute.</translation>
    </message>
    <message>
        <source>Export as a recipe</source>
        <translation>Exporter comme recette</translation>
    </message>
    <message>
        <source>Recipes (*.%1)</source>
        <translation>Recettes (*.%1)</translation>
    </message>
    <message>
        <source>Exported the session as a recipe to %1.</source>
        <translation>Session exportée comme recette vers %1.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportation de %1</translation>
    </message>
    <message>
        <source>The recipe names files to export: %1.</source>
        <translation>La recette nomme des fichiers à exporter&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exporter...</translation>
    </message>
</context>
<context>
    <name>RecordDialog</name>
    <message>
        <source>Record a video</source>
        <translation>Enregistrer une vidéo</translation>
    </message>
    <message>
        <source>Record pictures</source>
        <translation>Enregistrer des images</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>Comme simulé</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 fois</translation>
    </message>
    <message>
        <source>With the time, and forces on tools</source>
        <translation>Avec le temps et les forces sur les outils</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, comme la vue</translation>
    </message>
    <message>
        <source>Choose a place...</source>
        <translation>Choisir un endroit...</translation>
    </message>
    <message>
        <source>1 picture</source>
        <translation>1 image</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1: a video of %2 (Ogg Theora)</source>
        <translation>%1&#xa0;: une vidéo de %2 (Ogg Theora)</translation>
    </message>
    <message>
        <source>%1: PNG files in a folder of their own</source>
        <translation>%1&#xa0;: des fichiers PNG dans un dossier à part</translation>
    </message>
    <message>
        <source>What the active view shows: %1</source>
        <translation>Ce que montre la vue active&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>picture %1 of %2</source>
        <translation>image %1 sur %2</translation>
    </message>
</context>
<context>
    <name>RecordingFeature</name>
    <message>
        <source>There is nothing to record yet: press Play and let something happen first.</source>
        <translation>Il n&apos;y a encore rien à enregistrer&#xa0;: appuyez sur Lecture et laissez quelque chose se passer.</translation>
    </message>
    <message>
        <source>Save the video</source>
        <translation>Enregistrer la vidéo</translation>
    </message>
    <message>
        <source>Make a folder for the pictures</source>
        <translation>Créer un dossier pour les images</translation>
    </message>
    <message>
        <source>Video (*.ogv)</source>
        <translation>Vidéo (*.ogv)</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>Dossier (*)</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>%1: 1 picture recorded.</source>
        <translation>%1&#xa0;: 1 image enregistrée.</translation>
    </message>
    <message>
        <source>%1: %2 pictures recorded.</source>
        <translation>%1&#xa0;: %2 images enregistrées.</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>nobody knows when</source>
        <translation>nul ne sait quand</translation>
    </message>
    <message>
        <source>today, %1</source>
        <translation>aujourd&apos;hui, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>hier, %1</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>endommagé</translation>
    </message>
    <message>
        <source>just begun</source>
        <translation>à peine commencé</translation>
    </message>
    <message>
        <source>1 change</source>
        <translation>1 changement</translation>
    </message>
    <message>
        <source>%1 changes</source>
        <translation>%1 changements</translation>
    </message>
    <message>
        <source>Work without a name</source>
        <translation>Travail sans nom</translation>
    </message>
    <message>
        <source>%1, never saved</source>
        <translation>%1, jamais enregistré</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Récupérer le travail non enregistré</translation>
    </message>
    <message>
        <source>Knead ended before this was saved</source>
        <translation>Knead s&apos;est arrêté avant que ceci soit enregistré</translation>
    </message>
    <message>
        <source>What is recovered opens unsaved, and stays here until you save or discard it.</source>
        <translation>Ce qui est récupéré s&apos;ouvre non enregistré et reste ici jusqu&apos;à ce que vous l&apos;enregistriez ou l&apos;abandonniez.</translation>
    </message>
    <message>
        <source>%1  ·  %2</source>
        <translation>%1  ·  %2</translation>
    </message>
    <message>
        <source>Discard...</source>
        <translation>Abandonner...</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard unsaved work</source>
        <translation>Abandonner le travail non enregistré</translation>
    </message>
    <message>
        <source>Discard the unsaved work on &quot;%1&quot;? It cannot be brought back.</source>
        <translation>Abandonner le travail non enregistré sur «&#xa0;%1&#xa0;»&#xa0;? On ne pourra pas le retrouver.</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>1 part, %2</source>
        <translation>1 pièce, %2</translation>
    </message>
    <message>
        <source>%1 parts, %2</source>
        <translation>%1 pièces, %2</translation>
    </message>
    <message>
        <source>1 face, %2</source>
        <translation>1 face, %2</translation>
    </message>
    <message>
        <source>%1 faces, %2</source>
        <translation>%1 faces, %2</translation>
    </message>
    <message>
        <source>1 edge, %2</source>
        <translation>1 arête, %2</translation>
    </message>
    <message>
        <source>%1 edges, %2</source>
        <translation>%1 arêtes, %2</translation>
    </message>
    <message>
        <source>1 object, %2</source>
        <translation>1 objet, %2</translation>
    </message>
    <message>
        <source>%1 objects, %2</source>
        <translation>%1 objets, %2</translation>
    </message>
    <message>
        <source>1 connection, %2</source>
        <translation>1 liaison, %2</translation>
    </message>
    <message>
        <source>%1 connections, %2</source>
        <translation>%1 liaisons, %2</translation>
    </message>
    <message>
        <source>Face &quot;%1&quot;, %2</source>
        <translation>Face « %1 », %2</translation>
    </message>
</context>
<context>
    <name>Repair</name>
    <message>
        <source>The exact shapes of the parts cannot be understood; import the file again.</source>
        <translation>Les formes exactes des pièces ne peuvent pas être comprises&#xa0;; importez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1.</source>
        <translation>1 face séparée a été cousue avec une tolérance de %1.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2.</source>
        <translation>%1 faces séparées ont été cousues avec une tolérance de %2.</translation>
    </message>
    <message>
        <source>1 separate face was sewn with a tolerance of %1; the widest gap between two of them is %2.</source>
        <translation>1 face séparée a été cousue avec une tolérance de %1 ; la plus large fente entre deux est de %2.</translation>
    </message>
    <message>
        <source>%1 separate faces were sewn with a tolerance of %2; the widest gap between two of them is %3.</source>
        <translation>%1 faces séparées ont été cousues avec une tolérance de %2 ; la plus large fente entre deux est de %3.</translation>
    </message>
    <message>
        <source>1 flat opening was closed with a plane face, %1 % of the area.</source>
        <translation>1 ouverture plane a été fermée par une face plane, %1 % de l&apos;aire.</translation>
    </message>
    <message>
        <source>%1 flat openings were closed with plane faces, %2 % of the area.</source>
        <translation>%1 ouvertures planes ont été fermées par des faces planes, %2 % de l&apos;aire.</translation>
    </message>
    <message>
        <source>Edges that failed the geometry checks were rebuilt.</source>
        <translation>Des arêtes qui ne passaient pas les contrôles de géométrie ont été refaites.</translation>
    </message>
    <message>
        <source>1 face that failed the geometry checks was rebuilt.</source>
        <translation>1 face qui ne passait pas les contrôles de géométrie a été refaite.</translation>
    </message>
    <message>
        <source>%1 faces that failed the geometry checks were rebuilt.</source>
        <translation>%1 faces qui ne passaient pas les contrôles de géométrie ont été refaites.</translation>
    </message>
    <message>
        <source>1 shell was inside out and turned.</source>
        <translation>1 coque était à l&apos;envers et a été retournée.</translation>
    </message>
    <message>
        <source>%1 shells were inside out and turned.</source>
        <translation>%1 coques étaient à l&apos;envers et ont été retournées.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid.</source>
        <translation>La surface fermée a été changée en solide.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with 1 void in it.</source>
        <translation>La surface fermée a été changée en solide, avec 1 vide dedans.</translation>
    </message>
    <message>
        <source>The closed surface was made a solid, with %1 voids in it.</source>
        <translation>La surface fermée a été changée en solide, avec %1 vides dedans.</translation>
    </message>
    <message>
        <source>1 triangle was there twice and removed.</source>
        <translation>1 triangle était là deux fois et a été enlevé.</translation>
    </message>
    <message>
        <source>%1 triangles were there twice and removed.</source>
        <translation>%1 triangles étaient là deux fois et ont été enlevés.</translation>
    </message>
    <message>
        <source>The surface was given with both its sides; one of them was removed.</source>
        <translation>La surface était donnée avec ses deux côtés ; l&apos;un d&apos;eux a été enlevé.</translation>
    </message>
    <message>
        <source>1 pair of triangles back to back was removed.</source>
        <translation>1 paire de triangles dos à dos a été enlevée.</translation>
    </message>
    <message>
        <source>%1 pairs of triangles back to back were removed.</source>
        <translation>%1 paires de triangles dos à dos ont été enlevées.</translation>
    </message>
    <message>
        <source>1 triangle faced the wrong way and was turned.</source>
        <translation>1 triangle était tourné du mauvais côté et a été retourné.</translation>
    </message>
    <message>
        <source>%1 triangles faced the wrong way and were turned.</source>
        <translation>%1 triangles étaient tournés du mauvais côté et ont été retournés.</translation>
    </message>
    <message>
        <source>1 small hole was closed, which added %1 to the area.</source>
        <translation>1 petit trou a été fermé, ce qui a ajouté %1 à l&apos;aire.</translation>
    </message>
    <message>
        <source>%1 small holes were closed, which added %2 to the area.</source>
        <translation>%1 petits trous ont été fermés, ce qui a ajouté %2 à l&apos;aire.</translation>
    </message>
    <message>
        <source>The surface was inside out and has been turned.</source>
        <translation>La surface était à l&apos;envers et a été retournée.</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 arête ouverte</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1 arêtes ouvertes</translation>
    </message>
    <message>
        <source>1 border</source>
        <translation>1 bord</translation>
    </message>
    <message>
        <source>%1 borders</source>
        <translation>%1 bords</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across and flat</source>
        <translation>%1 dans %2, %3 de long en tout ; la plus grande ouverture mesure %4 et est plane</translation>
    </message>
    <message>
        <source>%1 in %2, %3 long in all; the largest opening is %4 across</source>
        <translation>%1 dans %2, %3 de long en tout ; la plus grande ouverture mesure %4</translation>
    </message>
</context>
<context>
    <name>Run</name>
    <message>
        <source>The equations of %1 of %2 steps could not be solved: forces and places are not to be trusted there. Make tools slower, or choose a shorter time step.</source>
        <translation>Les équations de %1 des %2 pas n&apos;ont pas pu être résolues : forces et positions n&apos;y sont pas fiables. Ralentir les outils, ou choisir un pas de temps plus court.</translation>
    </message>
    <message>
        <source>Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools slower.</source>
        <translation>L&apos;énergie est fausse de %1 % de tout ce qui a circulé. Choisissez un pas de temps plus court, ou ralentissez les outils.</translation>
    </message>
    <message>
        <source>Tools or the floor went %1 spacings into material: shapes and forces there are rough. Press less far, or choose a smaller spacing.</source>
        <translation>Des outils ou le sol sont entrés de %1 espacements dans la matière : formes et forces y sont approximatives. Pressez moins loin, ou choisissez un espacement plus petit.</translation>
    </message>
    <message>
        <source>Mass scaling made %1 % of the mass: what swings and what is thrown is slower than it would be. Choose a shorter time step for it.</source>
        <translation>La mise à l&apos;échelle a fait %1 % de la masse : ce qui oscille et ce qui est lancé est plus lent qu&apos;il ne le serait. Choisissez pour elle un pas de temps plus court.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; broke into %2 pieces, and a rigid body would weld them together where they are. Keep it deformable, or reset before it becomes rigid.</source>
        <translation>« %1 » s&apos;est brisé en %2 morceaux, et un corps rigide les souderait là où ils sont. Le garder déformable, ou réinitialiser avant de le rendre rigide.</translation>
    </message>
    <message>
        <source>The simulation was stopped at %1 s: %2 It went back to %3 s.</source>
        <translation>La simulation a été arrêtée à %1 s : %2 Elle est revenue à %3 s.</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>le corps</translation>
    </message>
    <message>
        <source>material of %1 was squashed flat or turned inside out. Press less far, raise Poisson&apos;s ratio or the yield stress, or fill the part with a smaller spacing, then reset.</source>
        <translation>la matière de %1 a été écrasée ou retournée. Presser moins loin, augmenter le coefficient de Poisson ou la limite d&apos;élasticité, ou remplir la pièce avec un espacement plus petit, puis réinitialiser.</translation>
    </message>
    <message>
        <source>a position is no longer a number. %1 or make the material softer, then reset.</source>
        <translation>une position n&apos;est plus un nombre. %1 ou assouplir la matière, puis réinitialiser.</translation>
    </message>
    <message>
        <source>the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, or a softer or more damped material.</source>
        <translation>le pas de temps choisi de %1 s est plus long que le pas stable de %2 s. En choisir un plus court, ou une matière plus souple ou plus amortie.</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Euler implicite</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Euler explicite</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semi-implicite</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1 : choisi ; pas par seconde que demande l&apos;intégration explicite : %2, ce qui suit le temps réel.</translation>
    </message>
    <message>
        <source>%1: chosen; explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1 : choisi ; pas par seconde que demande l&apos;intégration explicite : %2, plus que le temps réel ne permet.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, which keeps up with real time.</source>
        <translation>%1 : pas par seconde que demande l&apos;intégration explicite : %2, ce qui suit le temps réel.</translation>
    </message>
    <message>
        <source>%1: explicit integration needs %2 steps per second, more than real time allows.</source>
        <translation>%1 : pas par seconde que demande l&apos;intégration explicite : %2, plus que le temps réel ne permet.</translation>
    </message>
    <message>
        <source>The equations of the step at %1 s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter time step.</source>
        <translation>Les équations du pas à %1 s n&apos;ont pas pu être résolues : forces et positions sont approximatives à partir de là. Ralentir les outils, ou choisir un pas de temps plus court.</translation>
    </message>
    <message>
        <source>there is not enough memory to go on. Close other programs or fill the part with a larger spacing, then reset.</source>
        <translation>il n&apos;y a pas assez de mémoire pour continuer. Fermer d&apos;autres programmes ou remplir la pièce avec un espacement plus grand, puis réinitialiser.</translation>
    </message>
    <message>
        <source>%1 Reset, or go to an earlier moment.</source>
        <translation>%1 Réinitialiser, ou aller à un instant antérieur.</translation>
    </message>
    <message>
        <source>The simulation was stopped: %1</source>
        <translation>La simulation a été arrêtée : %1</translation>
    </message>
    <message>
        <source>objects of %1 moved at %2 m/s, and nothing in the scene makes them faster than %3 m/s. %4 or raise the damping ratio, then reset.</source>
        <translation>des objets de %1 se déplaçaient à %2 m/s, et rien dans la scène ne les rend plus rapides que %3 m/s. %4 ou augmenter le taux d&apos;amortissement, puis réinitialiser.</translation>
    </message>
    <message>
        <source>%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the material. %3 or raise the damping ratio, then reset.</source>
        <translation>%1 J sont venus de nulle part, sur %2 J dans la scène : les pas ne suivent plus la matière. %3 ou augmenter le taux d&apos;amortissement, puis réinitialiser.</translation>
    </message>
    <message>
        <source>the equations of %1 steps in a row could not be solved, though the last was only %2 s long. %3 or raise the damping ratio, then reset.</source>
        <translation>les équations de %1 pas de suite n&apos;ont pas pu être résolues, bien que le dernier n&apos;ait duré que %2 s. %3 ou augmenter le taux d&apos;amortissement, puis réinitialiser.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is %2 mm deep in %3: let it begin outside and press less far, make it slower</source>
        <translation>L&apos;outil « %1 » est à %2 mm de profondeur dans %3 : le faire commencer dehors, presser moins loin, le ralentir</translation>
    </message>
    <message>
        <source>Choose a shorter time step for mass scaling, which added %1 % to the mass</source>
        <translation>Choisir un pas de temps plus court pour la mise à l&apos;échelle des masses, qui a ajouté %1 % à la masse</translation>
    </message>
    <message>
        <source>Make the tools slower</source>
        <translation>Ralentir les outils</translation>
    </message>
    <message>
        <source>Lower gravity</source>
        <translation>Réduire la gravité</translation>
    </message>
    <message>
        <source>Move bodies and fixtures slower</source>
        <translation>Déplacer plus lentement les corps et les fixations</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; begins %2 mm inside %3, which is pushed away with great force, in very short steps. Let it begin outside.</source>
        <translation>L&apos;outil « %1 » commence à %2 mm à l&apos;intérieur de %3, qui est repoussé avec une grande force, par pas très courts. Le faire commencer dehors.</translation>
    </message>
</context>
<context>
    <name>RunRemarks</name>
    <message>
        <source>Time hardly goes on: %1 were simulated in %2, in steps of %3. A larger spacing, a softer material, slower tools or ones that begin outside the material make it faster.</source>
        <translation>Le temps n&apos;avance guère : %1 ont été simulés en %2, par pas de %3. Un plus grand espacement, un matériau plus souple, des outils plus lents ou qui commencent hors de la matière accélèrent.</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>Gravity must not be stronger than 10000 m/s^2.</source>
        <translation>La pesanteur ne doit pas dépasser 10000 m/s^2.</translation>
    </message>
    <message>
        <source>The height of the floor must lie between -10 and 10 km.</source>
        <translation>La hauteur du sol doit être comprise entre -10 et 10 km.</translation>
    </message>
    <message>
        <source>The friction of the floor must lie between 0 and 2.</source>
        <translation>Le frottement du sol doit être compris entre 0 et 2.</translation>
    </message>
    <message>
        <source>The adhesion of the floor must lie between 0 and 1e9 Pa.</source>
        <translation>L&apos;adhérence du sol doit être comprise entre 0 et 1e9 Pa.</translation>
    </message>
    <message>
        <source>There is no body number %1.</source>
        <translation>Il n&apos;y a pas de corps numéro %1.</translation>
    </message>
    <message>
        <source>It holds no objects. Fill it with a smaller spacing.</source>
        <translation>Il ne contient pas d&apos;objets. Remplissez-le avec un espacement plus petit.</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot;: %2</source>
        <translation>Région « %1 » : %2</translation>
    </message>
    <message>
        <source>Region &quot;%1&quot; names an object that does not exist.</source>
        <translation>La région « %1 » nomme un objet qui n&apos;existe pas.</translation>
    </message>
    <message>
        <source>It must not start faster than 1000 m/s or 100000 rad/s.</source>
        <translation>Il ne doit pas partir plus vite que 1000 m/s ou 100000 rad/s.</translation>
    </message>
    <message>
        <source>Its structural friction must lie between 0 and 2.</source>
        <translation>Son frottement interne doit être compris entre 0 et 2.</translation>
    </message>
    <message>
        <source>Body &quot;%1&quot;: %2</source>
        <translation>Corps « %1 » : %2</translation>
    </message>
    <message>
        <source>The time step must lie between 1e-9 and 1 s.</source>
        <translation>Le pas de temps doit être compris entre 1e-9 et 1 s.</translation>
    </message>
    <message>
        <source>The time step of mass scaling must lie between 1e-9 and 1 s.</source>
        <translation>Le pas de temps de la mise à l&apos;échelle des masses doit être compris entre 1e-9 et 1 s.</translation>
    </message>
    <message>
        <source>Forward Euler is not stable without damping: raise the damping ratio, or use semi-implicit Euler.</source>
        <translation>Euler explicite n&apos;est pas stable sans amortissement : augmentez le taux d&apos;amortissement, ou prenez Euler semi-implicite.</translation>
    </message>
</context>
<context>
    <name>SculptHand</name>
    <message>
        <source>%1 does not deform: make it deformable in the properties, or push it with a tool.</source>
        <translation>%1 ne se déforme pas&#xa0;: rendez-le déformable dans les propriétés, ou poussez-le avec un outil.</translation>
    </message>
    <message>
        <source>%1 is held at this place: free it with Fix faces, or take another place.</source>
        <translation>%1 est tenu à cet endroit&#xa0;: libérez-le avec «&#xa0;Fixer des faces&#xa0;», ou prenez un autre endroit.</translation>
    </message>
    <message>
        <source>%1, force %2 %</source>
        <translation>%1, force %2 %</translation>
    </message>
    <message>
        <source>%1 (limit; + for more)</source>
        <translation>%1 (limite&#xa0;; + pour plus)</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>Tirer %1</translation>
    </message>
    <message>
        <source>Thumb on %1</source>
        <translation>Pouce sur %1</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Lisser %1</translation>
    </message>
    <message>
        <source>Flatten %1</source>
        <translation>Aplatir %1</translation>
    </message>
    <message>
        <source>Pinch %1</source>
        <translation>Pincer %1</translation>
    </message>
    <message>
        <source>Smear %1</source>
        <translation>Étaler %1</translation>
    </message>
    <message>
        <source>Bend %1</source>
        <translation>Courber %1</translation>
    </message>
    <message>
        <source>Twist %1</source>
        <translation>Tordre %1</translation>
    </message>
</context>
<context>
    <name>SectionKnob</name>
    <message>
        <source>Drag to move the section plane; arrow keys move it by a hundredth of the part</source>
        <translation>Tirez pour déplacer le plan de coupe&#xa0;; les flèches le déplacent d&apos;un centième de la pièce</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Plan de coupe</translation>
    </message>
</context>
<context>
    <name>SelectionActions</name>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Clicks select parts</source>
        <translation>Les clics sélectionnent des pièces</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Clicks select faces</source>
        <translation>Les clics sélectionnent des faces</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Clicks select edges</source>
        <translation>Les clics sélectionnent des arêtes</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Clicks select the objects the material is made of</source>
        <translation>Les clics sélectionnent les objets dont est fait le matériau</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Clicks select connections between objects</source>
        <translation>Les clics sélectionnent des liaisons entre objets</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Drag a box: to the right for what lies in it, to the left also for what it touches</source>
        <translation>Tracer un rectangle&#xa0;: vers la droite pour ce qui s&apos;y trouve, vers la gauche aussi pour ce qu&apos;il touche</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw a line around what is wanted</source>
        <translation>Tracer une ligne autour de ce qui est voulu</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Paint over what is wanted</source>
        <translation>Peindre sur ce qui est voulu</translation>
    </message>
    <message>
        <source>Through the part</source>
        <translation>À travers la pièce</translation>
    </message>
    <message>
        <source>Boxes, lassos and brushes select what is hidden behind the skin too</source>
        <translation>Rectangle, lasso et pinceau sélectionnent aussi ce qui est caché derrière la peau</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Pinceau plus petit</translation>
    </message>
    <message>
        <source>A smaller brush</source>
        <translation>Un pinceau plus petit</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Pinceau plus grand</translation>
    </message>
    <message>
        <source>A larger brush</source>
        <translation>Un pinceau plus grand</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Everything of the kind that clicks select</source>
        <translation>Tout ce qui est du genre que les clics sélectionnent</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Ne rien sélectionner</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Effacer la sélection</translation>
    </message>
    <message>
        <source>All within a distance...</source>
        <translation>Tout à moins d&apos;une distance...</translation>
    </message>
    <message>
        <source>The objects that lie no farther from the selection than a distance</source>
        <translation>Les objets qui ne sont pas plus loin de la sélection qu&apos;une distance</translation>
    </message>
    <message>
        <source>Save selection...</source>
        <translation>Enregistrer la sélection...</translation>
    </message>
    <message>
        <source>Keep the selection under a name in the model tree</source>
        <translation>Garder la sélection sous un nom dans l&apos;arbre du modèle</translation>
    </message>
    <message>
        <source>Fix selection</source>
        <translation>Fixer la sélection</translation>
    </message>
    <message>
        <source>Hold the selected faces or objects in place</source>
        <translation>Maintenir en place les faces ou objets sélectionnés</translation>
    </message>
    <message>
        <source>Re-normalize selection</source>
        <translation>Renormaliser la sélection</translation>
    </message>
    <message>
        <source>The selection takes its present shape for its own</source>
        <translation>La sélection prend sa forme actuelle pour sienne</translation>
    </message>
    <message>
        <source>Make it glue</source>
        <translation>Changer en colle</translation>
    </message>
    <message>
        <source>The selected parts keep shape and place and hold what touches them</source>
        <translation>Les pièces sélectionnées gardent forme et place et retiennent ce qui les touche</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Another name for the selected part, group or selection</source>
        <translation>Un autre nom pour la pièce, le groupe ou la sélection choisis</translation>
    </message>
    <message>
        <source>Color...</source>
        <translation>Couleur...</translation>
    </message>
    <message>
        <source>Another color for the selected parts</source>
        <translation>Une autre couleur pour les pièces sélectionnées</translation>
    </message>
    <message>
        <source>Color of the file</source>
        <translation>Couleur du fichier</translation>
    </message>
    <message>
        <source>The color that the part has in its file</source>
        <translation>La couleur que la pièce a dans son fichier</translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation>Verrouiller ou déverrouiller</translation>
    </message>
    <message>
        <source>Keep what is selected from being changed</source>
        <translation>Protéger ce qui est sélectionné des modifications</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Put the selected parts into a group</source>
        <translation>Mettre les pièces sélectionnées dans un groupe</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Dégrouper</translation>
    </message>
    <message>
        <source>Take the selected parts out of their group, or all out of the selected one</source>
        <translation>Retirer les pièces sélectionnées de leur groupe, ou toutes du groupe sélectionné</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
    <message>
        <source>Show nothing but the selected parts; again: what was shown before</source>
        <translation>Ne montrer que les pièces sélectionnées&#xa0;; encore une fois&#xa0;: ce qui était montré avant</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Hide no part</source>
        <translation>Ne cacher aucune pièce</translation>
    </message>
    <message>
        <source>Search the model</source>
        <translation>Chercher dans le modèle</translation>
    </message>
    <message>
        <source>Look for parts, tools, fixtures and selections by their names</source>
        <translation>Chercher pièces, outils, fixations et sélections par leur nom</translation>
    </message>
</context>
<context>
    <name>SelectionFeature</name>
    <message>
        <source>Se&amp;lect</source>
        <translation>Sé&amp;lection</translation>
    </message>
    <message>
        <source>Selecting</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Selecting within %1</source>
        <translation>Sélection à moins de %1</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Sélectionnez d&apos;abord quelque chose.</translation>
    </message>
</context>
<context>
    <name>SelectionPanel</name>
    <message>
        <source>Fix</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Hold it in place (Shift+F)</source>
        <translation>Le maintenir en place (Maj+F)</translation>
    </message>
    <message>
        <source>Re-normalize</source>
        <translation>Renormaliser</translation>
    </message>
    <message>
        <source>It takes its present shape for its own (Shift+N)</source>
        <translation>Elle prend sa forme présente pour sienne (Maj+N)</translation>
    </message>
    <message>
        <source>Enter keeps the selection under this name in the model tree</source>
        <translation>Entrée garde la sélection sous ce nom dans l&apos;arbre du modèle</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Keep the selection under this name</source>
        <translation>Garder la sélection sous ce nom</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Enter selects the objects that lie no farther from the selection than this</source>
        <translation>Entrée sélectionne les objets qui ne sont pas plus loin de la sélection que cela</translation>
    </message>
    <message>
        <source>All within</source>
        <translation>Tout à moins de</translation>
    </message>
    <message>
        <source>Material of its own</source>
        <translation>Matériau propre</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Takes effect at once, also while time runs. The rest of the part stays what it is.</source>
        <translation>L&apos;effet est immédiat, même en marche. Le reste de la pièce reste ce qu&apos;il est.</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>A selection needs a name: type one, then save it.</source>
        <translation>Une sélection a besoin d&apos;un nom&#xa0;: tapez-en un, puis enregistrez-la.</translation>
    </message>
    <message>
        <source>Name of the selection</source>
        <translation>Nom de la sélection</translation>
    </message>
</context>
<context>
    <name>Session field</name>
    <message>
        <source>&quot;%1&quot; is cracked, cut or in pieces there, and a field cannot tear: it says what became of the largest piece, as if it were whole.</source>
        <translation>« %1 » y est fissuré, coupé ou en morceaux, et un champ ne peut pas se déchirer : il dit ce qu&apos;est devenu le plus grand morceau, comme s&apos;il était entier.</translation>
    </message>
    <message>
        <source>this is no project of Knead.</source>
        <translation>ce n&apos;est pas un projet de Knead.</translation>
    </message>
    <message>
        <source>nothing has moved at its entry %1: there is no field.</source>
        <translation>rien n&apos;a bougé à son entrée %1 : il n&apos;y a pas de champ.</translation>
    </message>
</context>
<context>
    <name>Shortcuts</name>
    <message>
        <source>drives the selected tool</source>
        <translation>conduit l&apos;outil choisi</translation>
    </message>
</context>
<context>
    <name>ShortcutsPage</name>
    <message>
        <source>No key</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>As it came</source>
        <translation>Comme à l&apos;origine</translation>
    </message>
    <message>
        <source>Search an action or a key</source>
        <translation>Chercher une action ou une touche</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Press the new key:</source>
        <translation>Appuyez sur la nouvelle touche&#xa0;:</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation>Ailleurs</translation>
    </message>
    <message>
        <source>%1 %2: choose another key.</source>
        <translation>%1 %2&#xa0;: choisissez une autre touche.</translation>
    </message>
    <message>
        <source>%1 already does &quot;%2&quot;.</source>
        <translation>%1 fait déjà «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>La prendre de là</translation>
    </message>
</context>
<context>
    <name>SimulationFeature</name>
    <message>
        <source>Slower tools</source>
        <translation>Outils plus lents</translation>
    </message>
    <message>
        <source>More damping</source>
        <translation>Plus d&apos;amortissement</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Performances</translation>
    </message>
    <message>
        <source>Turn the section plane on (Shift+S) and put it where the cut shall be.</source>
        <translation>Activez le plan de coupe (Maj+S) et placez-le là où il faut couper.</translation>
    </message>
    <message>
        <source>Fill finer</source>
        <translation>Remplir plus fin</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Pause first.</source>
        <translation>Mettez d&apos;abord en pause.</translation>
    </message>
    <message>
        <source>Only a part to which nothing was done yet is pressed like this.</source>
        <translation>Seule une pièce à laquelle rien n&apos;a encore été fait est pressée ainsi.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Il n&apos;y a rien à annuler.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Il n&apos;y a rien à rétablir.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Come back to the present first: Esc.</source>
        <translation>Revenez d&apos;abord au présent : Échap.</translation>
    </message>
</context>
<context>
    <name>SimulationPanel</name>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Earth</source>
        <translation>Terre</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Lune</translation>
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
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>1/%1 of real time</source>
        <translation>1/%1 du temps réel</translation>
    </message>
    <message>
        <source>%1 times real time</source>
        <translation>%1 fois le temps réel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>How fast simulated time runs when the machine keeps up: slow motion shows what is quick</source>
        <translation>La vitesse à laquelle court le temps simulé quand la machine suit&#xa0;: le ralenti montre ce qui est rapide</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Simulated time of one step; the largest stable one with a margin</source>
        <translation>Temps simulé d&apos;un pas&#xa0;; le plus grand stable, avec une marge</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>Own numbers</source>
        <translation>Nombres propres</translation>
    </message>
    <message>
        <source>As on</source>
        <translation>Comme sur</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>Selon %1</translation>
    </message>
    <message>
        <source>Damping of all bodies</source>
        <translation>Amortissement de tous les corps</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semi-implicite</translation>
    </message>
    <message>
        <source>Forward Euler</source>
        <translation>Euler explicite</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Euler implicite</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Keeps vibrations; stiff materials take small steps</source>
        <translation>Garde les vibrations&#xa0;; les matériaux raides demandent de petits pas</translation>
    </message>
    <message>
        <source>As published; needs damping</source>
        <translation>Comme publié&#xa0;; demande de l&apos;amortissement</translation>
    </message>
    <message>
        <source>A step per frame for any stiffness; fast vibrations die out</source>
        <translation>Un pas par image pour toute raideur&#xa0;; les vibrations rapides s&apos;éteignent</translation>
    </message>
    <message>
        <source>Implicit where the semi-implicit scheme would be slower than real time</source>
        <translation>Implicite là où le schéma semi-implicite serait plus lent que le temps réel</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Intégrateur</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Tous (%1)</translation>
    </message>
    <message>
        <source>How many threads compute; the results are the same bits with any number</source>
        <translation>Combien de fils calculent&#xa0;; les résultats sont identiques au bit près pour tout nombre</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Fils de calcul</translation>
    </message>
    <message>
        <source>different</source>
        <translation>divers</translation>
    </message>
    <message>
        <source>%1 of all bodies</source>
        <translation>%1 de tous les corps</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>In a contact it is the geometric mean with that of the material</source>
        <translation>Dans un contact, c&apos;est la moyenne géométrique avec celle du matériau</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Tension that holds down what has touched the table; 0: nothing sticks to it</source>
        <translation>Traction qui retient ce qui a touché la table ; 0 : rien n&apos;y colle</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Adhérence</translation>
    </message>
    <message>
        <source>Gravity as on</source>
        <translation>Pesanteur comme sur</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>checking the surface</source>
        <translation>vérification de la surface</translation>
    </message>
    <message>
        <source>preparing the surface</source>
        <translation>préparation de la surface</translation>
    </message>
    <message>
        <source>preparing the simulation</source>
        <translation>préparation de la simulation</translation>
    </message>
    <message>
        <source>placing objects</source>
        <translation>placement des objets</translation>
    </message>
    <message>
        <source>cutting cells</source>
        <translation>découpe des cellules</translation>
    </message>
    <message>
        <source>measuring depth</source>
        <translation>mesure de la profondeur</translation>
    </message>
    <message>
        <source>measuring walls</source>
        <translation>mesure des parois</translation>
    </message>
    <message>
        <source>fitting walls</source>
        <translation>ajustement des parois</translation>
    </message>
    <message>
        <source>looking for crossings</source>
        <translation>recherche des intersections</translation>
    </message>
    <message>
        <source>attaching the surface</source>
        <translation>rattachement de la surface</translation>
    </message>
    <message>
        <source>cutting the surface</source>
        <translation>découpe de la surface</translation>
    </message>
    <message>
        <source>finding the cracks</source>
        <translation>recherche des fissures</translation>
    </message>
    <message>
        <source>smoothing the cracks</source>
        <translation>lissage des fissures</translation>
    </message>
    <message>
        <source>repeating</source>
        <translation>répétition</translation>
    </message>
    <message>
        <source>finding the balance</source>
        <translation>recherche de l&apos;équilibre</translation>
    </message>
    <message>
        <source>reading the file</source>
        <translation>lecture du fichier</translation>
    </message>
    <message>
        <source>looking into the file</source>
        <translation>examen du fichier</translation>
    </message>
    <message>
        <source>making shapes</source>
        <translation>construction des formes</translation>
    </message>
    <message>
        <source>making triangles</source>
        <translation>triangulation</translation>
    </message>
    <message>
        <source>healing parts</source>
        <translation>réparation des pièces</translation>
    </message>
    <message>
        <source>checking parts</source>
        <translation>vérification des pièces</translation>
    </message>
    <message>
        <source>measuring parts</source>
        <translation>mesure des pièces</translation>
    </message>
    <message>
        <source>keeping the exact shapes</source>
        <translation>conservation des formes exactes</translation>
    </message>
    <message>
        <source>handing the parts over</source>
        <translation>transmission des pièces</translation>
    </message>
    <message>
        <source>handing over</source>
        <translation>transmission</translation>
    </message>
    <message>
        <source>bending the surface</source>
        <translation>courbure de la surface</translation>
    </message>
    <message>
        <source>bending edges</source>
        <translation>courbure des arêtes</translation>
    </message>
    <message>
        <source>bending faces</source>
        <translation>courbure des faces</translation>
    </message>
    <message>
        <source>measuring tolerances</source>
        <translation>mesure des tolérances</translation>
    </message>
    <message>
        <source>measuring distances</source>
        <translation>mesure des distances</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>comparing with the skin</source>
        <translation>comparaison avec la peau</translation>
    </message>
    <message>
        <source>writing faces</source>
        <translation>écriture des faces</translation>
    </message>
    <message>
        <source>writing triangles</source>
        <translation>écriture des triangles</translation>
    </message>
    <message>
        <source>writing the file</source>
        <translation>écriture du fichier</translation>
    </message>
    <message>
        <source>opening the project</source>
        <translation>ouverture du projet</translation>
    </message>
    <message>
        <source>opening the history</source>
        <translation>ouverture de l&apos;historique</translation>
    </message>
    <message>
        <source>saving the parts</source>
        <translation>enregistrement des pièces</translation>
    </message>
    <message>
        <source>saving the history</source>
        <translation>enregistrement de l&apos;historique</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>dividing faces</source>
        <translation>division des faces</translation>
    </message>
    <message>
        <source>fitting the field</source>
        <translation>ajustement du champ</translation>
    </message>
    <message>
        <source>comparing the field with the parts</source>
        <translation>comparaison du champ avec les pièces</translation>
    </message>
    <message>
        <source>placing the scan</source>
        <translation>placement du scan</translation>
    </message>
    <message>
        <source>comparing the scan with the part</source>
        <translation>comparaison du scan avec la pièce</translation>
    </message>
    <message>
        <source>finding the faces again</source>
        <translation>recherche des faces</translation>
    </message>
    <message>
        <source>moving the grips</source>
        <translation>déplacement des prises</translation>
    </message>
</context>
<context>
    <name>StatusReadings</name>
    <message>
        <source>Simulated time per wall time</source>
        <translation>Temps simulé par temps réel</translation>
    </message>
    <message>
        <source>Frames the simulation delivers per second</source>
        <translation>Images que la simulation livre par seconde</translation>
    </message>
    <message>
        <source>Time steps per frame</source>
        <translation>Pas de temps par image</translation>
    </message>
    <message>
        <source>Spheres the bodies are made of</source>
        <translation>Sphères dont les corps sont faits</translation>
    </message>
    <message>
        <source>Structural connections between objects</source>
        <translation>Liaisons structurelles entre objets</translation>
    </message>
    <message>
        <source>Contact connections now</source>
        <translation>Liaisons de contact à présent</translation>
    </message>
    <message>
        <source>Structural connections that broke so far</source>
        <translation>Liaisons structurelles rompues jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Connected pieces of material</source>
        <translation>Morceaux de matériau d&apos;un seul tenant</translation>
    </message>
    <message>
        <source>Units of what is shown</source>
        <translation>Unités de ce qui est montré</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>1 step/frame</source>
        <translation>1 pas/image</translation>
    </message>
    <message>
        <source>%1 steps/frame</source>
        <translation>%1 pas/image</translation>
    </message>
    <message>
        <source>Implicit</source>
        <translation>Implicite</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Euler avant</translation>
    </message>
    <message>
        <source>Explicit</source>
        <translation>Explicite</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 objets</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 liaisons</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 contacts</translation>
    </message>
    <message>
        <source>%1 broken</source>
        <translation>%1 rompues</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 morceau</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 morceaux</translation>
    </message>
    <message>
        <source>%1x of %2x as chosen</source>
        <translation>%1x sur %2x choisis</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>30 steps a second to keep up</source>
        <translation>30 pas par seconde pour suivre</translation>
    </message>
    <message>
        <source>Rough steps to keep up</source>
        <translation>Pas grossiers pour suivre</translation>
    </message>
    <message>
        <source>Forces are within 3 % of the largest. The Simulation panel says whether to keep up with real time or to be exact</source>
        <translation>Les forces sont à 3 % de la plus grande. Le panneau Simulation dit s&apos;il faut suivre le temps réel ou être exact</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>the STEP file ends inside a text; it is cut off, get it again.</source>
        <translation>le fichier STEP s&apos;arrête au milieu d&apos;un texte&#xa0;; il est tronqué, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the STEP file ends before its last line (END-ISO-10303-21); it is cut off, get it again.</source>
        <translation>le fichier STEP s&apos;arrête avant sa dernière ligne (END-ISO-10303-21)&#xa0;; il est tronqué, procurez-le-vous de nouveau.</translation>
    </message>
    <message>
        <source>the STEP file has no DATA section, so it holds no shapes.</source>
        <translation>le fichier STEP n&apos;a pas de section DATA, donc il ne contient aucune forme.</translation>
    </message>
    <message>
        <source>a name in the STEP file is longer than 65 thousand letters; the file is damaged.</source>
        <translation>un nom du fichier STEP dépasse 65 mille lettres&#xa0;; le fichier est abîmé.</translation>
    </message>
    <message>
        <source>lists in the STEP file are nested more than 500 deep; the file is damaged.</source>
        <translation>des listes du fichier STEP sont imbriquées sur plus de 500 niveaux&#xa0;; le fichier est abîmé.</translation>
    </message>
    <message>
        <source>the STEP file has &quot;%1&quot; in place of a number; export it again.</source>
        <translation>le fichier STEP contient «&#xa0;%1&#xa0;» à la place d&apos;un nombre&#xa0;; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>%1: a turned face is bounded across its seam, and the file does not tell on which side of its border it lies; check the volume of its part.</source>
        <translation>%1 : une face de révolution est bordée à travers sa couture, et le fichier ne dit pas de quel côté de son bord elle se trouve ; vérifiez le volume de sa pièce.</translation>
    </message>
    <message>
        <source>1 shape of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>1 forme du fichier STEP n&apos;a pas pu être lue : ses faces sont abîmées ou d&apos;un genre inconnu.</translation>
    </message>
    <message>
        <source>%1 shapes of the STEP file could not be read: its faces are damaged or of an unknown kind.</source>
        <translation>%1 formes du fichier STEP n&apos;ont pas pu être lues : leurs faces sont abîmées ou d&apos;un genre inconnu.</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; export the file again.</source>
        <translation>l&apos;entité %1 renvoie à quelque chose de faux ou à rien&#xa0;; exportez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: %2).</source>
        <translation>l&apos;entité %1 renvoie à quelque chose de faux ou à rien ; ce qui en a besoin n&apos;a pu être lu (faces : %2).</translation>
    </message>
    <message>
        <source>the entity %1 refers to something of the wrong kind or nothing at all; what needs it could not be read (shapes: %2).</source>
        <translation>l&apos;entité %1 renvoie à quelque chose de faux ou à rien ; ce qui en a besoin n&apos;a pu être lu (formes : %2).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (faces: %3).</source>
        <translation>l&apos;entité %1 et %2 autres renvoient à quelque chose de faux ou à rien ; ce qui en a besoin n&apos;a pu être lu (faces : %3).</translation>
    </message>
    <message>
        <source>the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what needs them could not be read (shapes: %3).</source>
        <translation>l&apos;entité %1 et %2 autres renvoient à quelque chose de faux ou à rien ; ce qui en a besoin n&apos;a pu être lu (formes : %3).</translation>
    </message>
    <message>
        <source>the assembly refers to the file %1, which is not there: its parts are missing. Put it beside the assembly and open that again.</source>
        <translation>l&apos;assemblage renvoie au fichier %1, qui n&apos;est pas là : ses pièces manquent. Placez-le à côté de l&apos;assemblage et rouvrez celui-ci.</translation>
    </message>
    <message>
        <source>the assembly refers to %1 files that are not there: %2. Their parts are missing; put them beside the assembly and open that again.</source>
        <translation>l&apos;assemblage renvoie à %1 fichiers qui ne sont pas là : %2. Leurs pièces manquent ; placez-les à côté de l&apos;assemblage et rouvrez celui-ci.</translation>
    </message>
    <message>
        <source>the file holds triangles only (tessellated geometry of AP242), which are not read from STEP; export exact solids, or a mesh as 3MF or STL.</source>
        <translation>le fichier ne contient que des triangles (géométrie tessellée d&apos;AP242), qui ne sont pas lus en STEP&#xa0;; exportez des solides exacts, ou un maillage en 3MF ou STL.</translation>
    </message>
    <message>
        <source>the file holds curves and points only, no solid and no surface; export the part as a solid.</source>
        <translation>le fichier ne contient que des courbes et des points, ni solide ni surface&#xa0;; exportez la pièce comme solide.</translation>
    </message>
    <message>
        <source>the assembly refers to %1, which is no ordinary file in its folder; put the file beside the assembly and open that again.</source>
        <translation>l’assemblage renvoie à %1, qui n’est pas un fichier ordinaire de son dossier ; placez le fichier à côté de l’assemblage et rouvrez celui-ci.</translation>
    </message>
</context>
<context>
    <name>Study</name>
    <message>
        <source>must name a face; leave the part out where none counts.</source>
        <translation>doit nommer une face ; omettez la pièce dont aucune ne compte.</translation>
    </message>
    <message>
        <source>must name a part; leave the key out where all faces count.</source>
        <translation>doit nommer une pièce ; omettez la clé si toutes les faces comptent.</translation>
    </message>
    <message>
        <source>must be the name of a file in the folder of the round, without folders</source>
        <translation>doit être le nom d&apos;un fichier dans le dossier du tour, sans dossiers</translation>
    </message>
    <message>
        <source>has the name of another one; all of them go into one folder.</source>
        <translation>a le nom d&apos;un autre ; tous vont dans un seul dossier.</translation>
    </message>
    <message>
        <source>must have exactly one of the keys recipe and command.</source>
        <translation>doit avoir exactement une des clés recipe et command.</translation>
    </message>
    <message>
        <source>must have the key &quot;field&quot;: the file that the command writes.</source>
        <translation>doit avoir la clé « field » : le fichier que la commande écrit.</translation>
    </message>
    <message>
        <source>belongs to a command; a recipe needs none.</source>
        <translation>va avec une commande ; une recette n&apos;en a pas besoin.</translation>
    </message>
</context>
<context>
    <name>Synonyms</name>
    <message>
        <source>revert, back, take back, mistake</source>
        <translation>revenir, retour, défaire, erreur</translation>
    </message>
    <message>
        <source>again, forward, repeat</source>
        <translation>encore, répéter</translation>
    </message>
    <message>
        <source>load, import, file, read</source>
        <translation>charger, importer, fichier, lire</translation>
    </message>
    <message>
        <source>write, store, keep, project</source>
        <translation>sauvegarder, écrire, garder, projet</translation>
    </message>
    <message>
        <source>write as, copy, duplicate</source>
        <translation>sauvegarder sous, copie</translation>
    </message>
    <message>
        <source>STEP, IGES, STL, mesh, 3D print, print, write, convert, CAD</source>
        <translation>STEP, IGES, STL, maillage, impression 3D, imprimer, écrire, convertir, CAO</translation>
    </message>
    <message>
        <source>script, macro, batch, automate</source>
        <translation>script, macro, automatiser</translation>
    </message>
    <message>
        <source>screenshot, image, photo, snapshot, PNG, JPEG, render</source>
        <translation>capture d&apos;écran, photo, PNG, JPEG</translation>
    </message>
    <message>
        <source>movie, film, animation, screencast, clip</source>
        <translation>film, animation, clip</translation>
    </message>
    <message>
        <source>frames, image sequence</source>
        <translation>images, suite d&apos;images</translation>
    </message>
    <message>
        <source>demo, show me</source>
        <translation>démonstration, montrer</translation>
    </message>
    <message>
        <source>push, squeeze, poke</source>
        <translation>pousser, presser, écraser</translation>
    </message>
    <message>
        <source>drag, tug, stretch, grab</source>
        <translation>traîner, étirer, saisir</translation>
    </message>
    <message>
        <source>sculpt, mold, mould, clay, knead, dent, finger, groove</source>
        <translation>sculpter, modeler, argile, pétrir, creux, doigt, rainure</translation>
    </message>
    <message>
        <source>polish, even out, relax</source>
        <translation>polir, égaliser</translation>
    </message>
    <message>
        <source>flat, plane, iron</source>
        <translation>plat, plan, repasser</translation>
    </message>
    <message>
        <source>crease, ridge, gather</source>
        <translation>pli, arête, rassembler</translation>
    </message>
    <message>
        <source>smudge, spread</source>
        <translation>étaler, traîner</translation>
    </message>
    <message>
        <source>fold, curve</source>
        <translation>plier, courber</translation>
    </message>
    <message>
        <source>wring, turn, screw</source>
        <translation>tordre, tourner, visser</translation>
    </message>
    <message>
        <source>mirror, both sides</source>
        <translation>miroir, deux côtés</translation>
    </message>
    <message>
        <source>orbit, rotate view, turn view, pan, navigate, gestures</source>
        <translation>orbite, tourner la vue, déplacer la vue, naviguer</translation>
    </message>
    <message>
        <source>zoom, zoom to fit, center, frame, whole part</source>
        <translation>zoom, centrer, cadrer, pièce entière</translation>
    </message>
    <message>
        <source>3D view, default view</source>
        <translation>vue 3D, vue par défaut</translation>
    </message>
    <message>
        <source>orthographic, parallel, projection</source>
        <translation>orthographique, parallèle, projection</translation>
    </message>
    <message>
        <source>join, bond, stick, weld, attach, fuse</source>
        <translation>joindre, coller, souder, attacher</translation>
    </message>
    <message>
        <source>cut, slice, blade, split, saw</source>
        <translation>couper, trancher, lame, scier</translation>
    </message>
    <message>
        <source>cheese wire, cut</source>
        <translation>fil à couper, couper</translation>
    </message>
    <message>
        <source>slice, split, saw, divide, halve</source>
        <translation>trancher, scier, diviser, partager</translation>
    </message>
    <message>
        <source>cross section, clip, cutaway, look inside</source>
        <translation>coupe, section, voir dedans</translation>
    </message>
    <message>
        <source>box, cube, punch, stamp</source>
        <translation>cube, pavé, poinçon</translation>
    </message>
    <message>
        <source>sphere, bead</source>
        <translation>sphère, bille</translation>
    </message>
    <message>
        <source>rolling pin, roll out</source>
        <translation>rouleau à pâtisserie, étaler</translation>
    </message>
    <message>
        <source>clamp, hold, anchor, pin, constrain, support, vise</source>
        <translation>serrer, tenir, ancrer, bloquer, étau</translation>
    </message>
    <message>
        <source>measure, ruler, length, gap, dimension, caliper</source>
        <translation>mesurer, règle, longueur, écart, cote</translation>
    </message>
    <message>
        <source>weight, mass, how heavy</source>
        <translation>poids, masse, combien lourd</translation>
    </message>
    <message>
        <source>size, extent, width, height</source>
        <translation>taille, encombrement, largeur, hauteur</translation>
    </message>
    <message>
        <source>difference, deviation, report</source>
        <translation>différence, écart, rapport</translation>
    </message>
    <message>
        <source>sensor, strain gauge</source>
        <translation>capteur, jauge</translation>
    </message>
    <message>
        <source>graph, chart, curve</source>
        <translation>graphique, courbe</translation>
    </message>
    <message>
        <source>CSV, spreadsheet, data</source>
        <translation>CSV, tableur, données</translation>
    </message>
    <message>
        <source>fall, drop, heavy</source>
        <translation>tomber, chute, lourd</translation>
    </message>
    <message>
        <source>ground, table</source>
        <translation>sol, table</translation>
    </message>
    <message>
        <source>run, start, simulate, pause, stop</source>
        <translation>lancer, démarrer, simuler, pause, arrêter</translation>
    </message>
    <message>
        <source>start over, rewind, restart</source>
        <translation>recommencer, rembobiner</translation>
    </message>
    <message>
        <source>equilibrium, settle, static</source>
        <translation>repos, statique</translation>
    </message>
    <message>
        <source>forget shape, accept shape</source>
        <translation>oublier la forme, garder la forme</translation>
    </message>
    <message>
        <source>remesh, resolution</source>
        <translation>remailler, résolution</translation>
    </message>
    <message>
        <source>real time, slow, faster</source>
        <translation>temps réel, lent, plus vite</translation>
    </message>
    <message>
        <source>help, manual, documentation, guide, how to</source>
        <translation>aide, manuel, documentation, guide</translation>
    </message>
    <message>
        <source>tutorial, learn, getting started, introduction, first steps</source>
        <translation>tutoriel, apprendre, introduction, premiers pas</translation>
    </message>
    <message>
        <source>hotkeys, key bindings, keymap</source>
        <translation>touches, raccourcis, affectation des touches</translation>
    </message>
    <message>
        <source>settings, options, language, units, translation</source>
        <translation>options, réglages, langue, unités, traduction</translation>
    </message>
    <message>
        <source>dark mode, night mode, black</source>
        <translation>mode sombre, mode nuit, noir</translation>
    </message>
    <message>
        <source>light mode, day mode, white</source>
        <translation>mode clair, mode jour, blanc</translation>
    </message>
    <message>
        <source>new document, second window</source>
        <translation>nouveau document, seconde fenêtre</translation>
    </message>
    <message>
        <source>home, start page, welcome, examples</source>
        <translation>accueil, page de départ, exemples</translation>
    </message>
    <message>
        <source>crash, restore, lost work, autosave</source>
        <translation>plantage, récupérer, travail perdu</translation>
    </message>
    <message>
        <source>delete, erase</source>
        <translation>supprimer, effacer</translation>
    </message>
    <message>
        <source>invisible, conceal</source>
        <translation>invisible, masquer</translation>
    </message>
    <message>
        <source>unhide, visible</source>
        <translation>démasquer, visible</translation>
    </message>
    <message>
        <source>only this, solo</source>
        <translation>seul, uniquement</translation>
    </message>
    <message>
        <source>spheres, particles</source>
        <translation>sphères, particules</translation>
    </message>
    <message>
        <source>lines, outline</source>
        <translation>lignes, contour</translation>
    </message>
    <message>
        <source>maximize, presentation</source>
        <translation>agrandir, présentation</translation>
    </message>
    <message>
        <source>version, license, credits</source>
        <translation>version, licence, crédits</translation>
    </message>
    <message>
        <source>search, find action</source>
        <translation>chercher, trouver une action</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>fermer, sortir</translation>
    </message>
    <message>
        <source>name, call</source>
        <translation>nommer, nom</translation>
    </message>
    <message>
        <source>paint, colour, tint</source>
        <translation>peindre, teindre, couleur</translation>
    </message>
    <message>
        <source>protect, freeze</source>
        <translation>protéger, figer</translation>
    </message>
    <message>
        <source>undeformed, ghost</source>
        <translation>non déformée</translation>
    </message>
    <message>
        <source>move, rotate, arrows, transform</source>
        <translation>bouger, tourner, flèches</translation>
    </message>
    <message>
        <source>WASD, keyboard control</source>
        <translation>ZQSD, clavier</translation>
    </message>
    <message>
        <source>3Dconnexion, SpaceMouse, joystick</source>
        <translation>3Dconnexion, SpaceMouse, manette</translation>
    </message>
    <message>
        <source>assembly, insert, merge</source>
        <translation>assemblage, insérer</translation>
    </message>
    <message>
        <source>threads, slow motion, speed</source>
        <translation>threads, ralenti, vitesse</translation>
    </message>
    <message>
        <source>fps, frame rate, profiler</source>
        <translation>fps, images par seconde</translation>
    </message>
    <message>
        <source>material, stiffness, rubber, steel</source>
        <translation>matériau, rigidité, caoutchouc, acier</translation>
    </message>
    <message>
        <source>revision, version, transfer, repeat, other part</source>
        <translation>révision, version, transférer, répéter, autre pièce</translation>
    </message>
    <message>
        <source>flex, morph, warp, deformer, free form, global modeling</source>
        <translation>flexion, morphing, gauchir, forme libre</translation>
    </message>
    <message>
        <source>flex, curl, arc, curve, sheet metal, k-factor, tube, roll</source>
        <translation>plier, cintrer, arc, courbe, tôle, facteur k, tube, rouler</translation>
    </message>
    <message>
        <source>wring, flex, screw, turn, helix, torsion</source>
        <translation>tordre, vis, tourner, hélice, torsion</translation>
    </message>
    <message>
        <source>flex, cone, draft, narrow, widen</source>
        <translation>cône, dépouille, rétrécir, élargir</translation>
    </message>
    <message>
        <source>flex, lengthen, shorten, elongate, compress</source>
        <translation>allonger, raccourcir, comprimer</translation>
    </message>
    <message>
        <source>offset, skew, slant, joggle, sideways</source>
        <translation>décalage, incliner, biais, de côté</translation>
    </message>
    <message>
        <source>enlarge, shrink, size, grow</source>
        <translation>agrandir, rétrécir, taille</translation>
    </message>
    <message>
        <source>displacements, FEM, FEA, CalculiX, Abaqus, warpage, springback, compensation, morph, field, vtu, frd</source>
        <translation>déplacements, éléments finis, CalculiX, Abaqus, gauchissement, retour élastique, compensation, champ, vtu, frd</translation>
    </message>
    <message>
        <source>script, macro, code, program, automate, journal</source>
        <translation>script, macro, code, programme, automatiser, journal</translation>
    </message>
</context>
<context>
    <name>TableKinds</name>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Parts slide on it, as on glass</source>
        <translation>Les pièces y glissent, comme sur du verre</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Rugueuse</translation>
    </message>
    <message>
        <source>Parts hardly slide, and are lifted off freely</source>
        <translation>Les pièces glissent à peine et se soulèvent librement</translation>
    </message>
    <message>
        <source>Sticky</source>
        <translation>Collante</translation>
    </message>
    <message>
        <source>Parts stay where they are: it takes 20 kPa to lift them off</source>
        <translation>Les pièces restent en place : il faut 20 kPa pour les soulever</translation>
    </message>
</context>
<context>
    <name>TaskReading</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>TaskRunner</name>
    <message>
        <source>%1: there is not enough memory. Close other programs, or choose a larger spacing.</source>
        <translation>%1&#xa0;: la mémoire ne suffit pas. Fermez d&apos;autres programmes, ou choisissez un espacement plus grand.</translation>
    </message>
</context>
<context>
    <name>TextFiles</name>
    <message>
        <source>%1 cannot be written (%2). Choose another folder, or make room on the disk.</source>
        <translation>%1 ne peut pas être écrit (%2). Choisissez un autre dossier ou libérez de la place sur le disque.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Écrit&#xa0;: %1.</translation>
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
        <translation>... et %1 avant</translation>
    </message>
    <message>
        <source>Filled anew</source>
        <translation>Rempli à nouveau</translation>
    </message>
    <message>
        <source>no film kept</source>
        <translation>aucun film conservé</translation>
    </message>
    <message>
        <source>Double-click: go there</source>
        <translation>Double-clic&#xa0;: y aller</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1, étape %2</translation>
    </message>
</context>
<context>
    <name>TimelinePanel</name>
    <message>
        <source>Look at the start</source>
        <translation>Regarder le début</translation>
    </message>
    <message>
        <source>One picture back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>Play what was simulated, from where you look</source>
        <translation>Jouer ce qui a été simulé, d&apos;où vous regardez</translation>
    </message>
    <message>
        <source>One picture on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>Look at the end</source>
        <translation>Regarder la fin</translation>
    </message>
    <message>
        <source>%1x</source>
        <translation>%1x</translation>
    </message>
    <message>
        <source>How fast it is played, in simulated per real time</source>
        <translation>La vitesse de lecture, temps simulé par temps réel</translation>
    </message>
    <message>
        <source>Go on from what you see: a new branch of the history</source>
        <translation>Continuer depuis ce que vous voyez&#xa0;: une nouvelle branche de l&apos;historique</translation>
    </message>
    <message>
        <source>Branch here</source>
        <translation>Bifurquer ici</translation>
    </message>
    <message>
        <source>Back to the present (Esc)</source>
        <translation>Retour au présent (Échap)</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Looking back at %1   Esc: return</source>
        <translation>Regard en arrière sur %1   Échap&#xa0;: revenir</translation>
    </message>
    <message>
        <source>Play the film</source>
        <translation>Jouer le film</translation>
    </message>
    <message>
        <source>Simulate something first, and look back at it.</source>
        <translation>Simulez d&apos;abord quelque chose, puis revenez-y.</translation>
    </message>
    <message>
        <source>Speed of the film</source>
        <translation>Vitesse du film</translation>
    </message>
    <message>
        <source>Projects keep entries and no film: go to one with a double click, or simulate on.</source>
        <translation>Les projets gardent les entrées, pas le film&#xa0;: allez à l&apos;une d&apos;elles par un double-clic, ou continuez la simulation.</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Tool &quot;%1&quot;: %2</source>
        <translation>Outil « %1 » : %2</translation>
    </message>
    <message>
        <source>each edge must be between 0.001 mm and 1000 m long.</source>
        <translation>chaque arête doit mesurer entre 0.001 mm et 1000 m.</translation>
    </message>
    <message>
        <source>it is to be a part, but has none.</source>
        <translation>il doit être une pièce, mais n&apos;en a pas.</translation>
    </message>
    <message>
        <source>its measures do not fit together: a ball has one, a cylinder a diameter and a length.</source>
        <translation>ses mesures ne vont pas ensemble : une boule en a une, un cylindre un diamètre et une longueur.</translation>
    </message>
    <message>
        <source>its place must be numbers, within 10 km.</source>
        <translation>sa position doit être faite de nombres, à moins de 10 km.</translation>
    </message>
    <message>
        <source>friction must lie between 0 and 2.</source>
        <translation>le frottement doit être compris entre 0 et 2.</translation>
    </message>
    <message>
        <source>the speed limit must lie between 0.001 mm/s and 100 m/s.</source>
        <translation>la limite de vitesse doit être comprise entre 0.001 mm/s et 100 m/s.</translation>
    </message>
    <message>
        <source>the adhesion must lie between 0 and 1e9 Pa.</source>
        <translation>l&apos;adhérence doit être comprise entre 0 et 1e9 Pa.</translation>
    </message>
    <message>
        <source>the force limit must be greater than 0 N.</source>
        <translation>la limite de force doit être supérieure à 0 N.</translation>
    </message>
    <message>
        <source>a key-framed motion needs at least one frame.</source>
        <translation>un mouvement par images clés demande au moins une image.</translation>
    </message>
    <message>
        <source>the times of key frames must ascend.</source>
        <translation>les instants des images clés doivent croître.</translation>
    </message>
    <message>
        <source>key frames must be numbers, within 10 km.</source>
        <translation>les images clés doivent être faites de nombres, à moins de 10 km.</translation>
    </message>
    <message>
        <source>it must not go faster than 10000 m/s or 100000 rad/s.</source>
        <translation>il ne doit pas aller plus vite que 10000 m/s ou 100000 rad/s.</translation>
    </message>
    <message>
        <source>its target must be numbers, within 10 km.</source>
        <translation>sa cible doit être faite de nombres, à moins de 10 km.</translation>
    </message>
    <message>
        <source>The tool&apos;s part has no surface. Choose another file.</source>
        <translation>La pièce de l&apos;outil n&apos;a pas de surface. Choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>There is no tool number %1.</source>
        <translation>Il n&apos;y a pas d&apos;outil numéro %1.</translation>
    </message>
</context>
<context>
    <name>ToolPanel</name>
    <message>
        <source>Size X</source>
        <translation>Taille X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Taille Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Taille Z</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Tranchant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dos</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Largest so far</source>
        <translation>La plus grande jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Size %1</source>
        <translation>Taille %1</translation>
    </message>
    <message>
        <source>Arrow keys and PgUp/PgDn drive at this speed; dragging is never faster</source>
        <translation>Les flèches et Pg préc/suiv conduisent à cette vitesse&#xa0;; tirer n&apos;est jamais plus rapide</translation>
    </message>
    <message>
        <source>The tool stalls rather than push harder</source>
        <translation>L&apos;outil cale plutôt que de pousser plus fort</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Limite de vitesse</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Limite de force</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Remove tool</source>
        <translation>Supprimer l&apos;outil</translation>
    </message>
    <message>
        <source>Tension that holds what has touched the tool; 0: nothing sticks to it</source>
        <translation>Traction qui retient ce qui a touché l&apos;outil ; 0 : rien n&apos;y colle</translation>
    </message>
    <message>
        <source>Adhesion</source>
        <translation>Adhérence</translation>
    </message>
    <message>
        <source>Rolls freely</source>
        <translation>Roule librement</translation>
    </message>
    <message>
        <source>The tool turns as it is moved over material, so that it does not rub it</source>
        <translation>L&apos;outil tourne quand il se déplace sur la matière et ne la frotte donc pas</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Go on without doing this</source>
        <translation>Continuer sans le faire</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>End the tour; the part stays open</source>
        <translation>Terminer la visite ; la pièce reste ouverte</translation>
    </message>
    <message>
        <source>Tour: %1</source>
        <translation>Visite : %1</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Presser</translation>
    </message>
    <message>
        <source>Hold the left button on the clay: a thumb goes in for as long as you hold it.</source>
        <translation>Maintenez le bouton gauche sur l&apos;argile : un pouce s&apos;enfonce tant que vous le tenez.</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tirer</translation>
    </message>
    <message>
        <source>Choose Pull material at the right of the view (%1). Then drag a corner of the clay outwards.</source>
        <translation>Choisissez Tirer le matériau à droite de la vue (%1). Puis tirez un coin de l&apos;argile vers l&apos;extérieur.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Press %1 and write the clay as STEP or as a mesh, into a folder of your choice. Or skip this.</source>
        <translation>Appuyez sur %1 et écrivez l&apos;argile en STEP ou en maillage, dans un dossier de votre choix. Ou passez.</translation>
    </message>
    <message>
        <source>That was all</source>
        <translation>C&apos;est tout</translation>
    </message>
    <message>
        <source>Ctrl+Z takes back whatever you did. Ctrl+K finds any command, F1 opens the handbook, and this tour is in the menu Help.</source>
        <translation>Ctrl+Z annule tout ce que vous avez fait. Ctrl+K trouve toute commande, F1 ouvre le manuel, et cette visite est dans le menu Aide.</translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>The project has no bodies that a script could fill.</source>
        <translation>Le projet n&apos;a pas de corps qu&apos;un script pourrait remplir.</translation>
    </message>
    <message>
        <source>Nothing was done in the project yet that a script could say.</source>
        <translation>Rien n&apos;a encore été fait dans le projet qu&apos;un script pourrait dire.</translation>
    </message>
    <message>
        <source>A tool is an imported part, which only a saved project keeps: save the project first.</source>
        <translation>Un outil est une pièce importée, que seul un projet enregistré garde : enregistrez d&apos;abord le projet.</translation>
    </message>
    <message>
        <source>The parts are in no file as they are here: save the project first, from which the script then takes them.</source>
        <translation>Les pièces ne sont dans aucun fichier telles qu&apos;elles sont ici : enregistrez d&apos;abord le projet, d&apos;où le script les prend ensuite.</translation>
    </message>
    <message>
        <source>%1 has no entry %2; its last one is %3.</source>
        <translation>%1 n&apos;a pas d&apos;entrée %2 ; la dernière est %3.</translation>
    </message>
</context>
<context>
    <name>TraceFeature</name>
    <message>
        <source>Python trace</source>
        <translation>Trace Python</translation>
    </message>
    <message>
        <source>Save the Python trace</source>
        <translation>Enregistrer la trace Python</translation>
    </message>
    <message>
        <source>Python scripts (*%1)</source>
        <translation>Scripts Python (*%1)</translation>
    </message>
</context>
<context>
    <name>TracePanel</name>
    <message>
        <source>Python trace</source>
        <translation>Trace Python</translation>
    </message>
    <message>
        <source>Open a part: what you do is then written here as Python.</source>
        <translation>Ouvrez une pièce : ce que vous faites s&apos;écrit alors ici en Python.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the whole script</source>
        <translation>Copier tout le script</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Enregistrer sous...</translation>
    </message>
    <message>
        <source>Write the script to a file; run, it comes to the same bits</source>
        <translation>Écrire le script dans un fichier ; exécuté, il arrive aux mêmes bits</translation>
    </message>
</context>
<context>
    <name>Transfer</name>
    <message>
        <source>The recipe</source>
        <translation>La recette</translation>
    </message>
    <message>
        <source>Left out: %1. %2</source>
        <translation>Laissé de côté : %1. %2</translation>
    </message>
    <message>
        <source>what is said of the body &quot;%1&quot;</source>
        <translation>ce qui est dit du corps « %1 »</translation>
    </message>
    <message>
        <source>The other part has no such body.</source>
        <translation>L&apos;autre pièce n&apos;a pas de tel corps.</translation>
    </message>
    <message>
        <source>None of its faces was found again.</source>
        <translation>Aucune de ses faces n&apos;a été retrouvée.</translation>
    </message>
    <message>
        <source>Of the faces of %1, %2 were not found again.</source>
        <translation>Faces non retrouvées, %1 : %2</translation>
    </message>
    <message>
        <source>It names objects of a body that had been filled anew by then, which another part does not have.</source>
        <translation>Il nomme des objets d&apos;un corps qui avait été rempli à nouveau, qu&apos;une autre pièce n&apos;a pas.</translation>
    </message>
    <message>
        <source>There is no material in its place.</source>
        <translation>Il n&apos;y a pas de matière à sa place.</translation>
    </message>
    <message>
        <source>the tool &quot;%1&quot;</source>
        <translation>l&apos;outil « %1 »</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; is left out: it is an imported part, which has no mirror image.</source>
        <translation>L&apos;outil « %1 » est laissé de côté : c&apos;est une pièce importée, qui n&apos;a pas d&apos;image dans le miroir.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; keeps its size: it is an imported part.</source>
        <translation>L&apos;outil « %1 » garde sa taille : c&apos;est une pièce importée.</translation>
    </message>
    <message>
        <source>One of the parts is not closed: there is nothing to carry over.</source>
        <translation>L&apos;une des pièces n&apos;est pas fermée : il n&apos;y a rien à reporter.</translation>
    </message>
    <message>
        <source>none of the faces was found again on it. Is it another part, or a mirrored one?</source>
        <translation>aucune des faces n&apos;y a été retrouvée. Est-ce une autre pièce, ou une pièce en miroir ?</translation>
    </message>
    <message>
        <source>a change of material</source>
        <translation>un changement de matériau</translation>
    </message>
    <message>
        <source>a relaxation</source>
        <translation>une relaxation</translation>
    </message>
    <message>
        <source>a cut</source>
        <translation>une coupe</translation>
    </message>
    <message>
        <source>the fixture &quot;%1&quot;</source>
        <translation>la fixation « %1 »</translation>
    </message>
    <message>
        <source>the load &quot;%1&quot;</source>
        <translation>la charge « %1 »</translation>
    </message>
    <message>
        <source>The floor is left out: its mirror image would be no floor.</source>
        <translation>Le sol est laissé de côté : son image dans le miroir n&apos;en serait pas un.</translation>
    </message>
    <message>
        <source>the probe &quot;%1&quot;</source>
        <translation>la sonde « %1 »</translation>
    </message>
    <message>
        <source>the region &quot;%1&quot;</source>
        <translation>la région « %1 »</translation>
    </message>
    <message>
        <source>--mirror &quot;%1&quot; is no mirror; say x, y or z, across which it is mirrored, or the normal of a plane as 1,1,0.</source>
        <translation>--mirror « %1 » n&apos;est pas un miroir ; dire x, y ou z, ou la normale d&apos;un plan comme 1,1,0.</translation>
    </message>
    <message>
        <source>--scale &quot;%1&quot; is no scale; say auto or a number from 0.001 to 1000.</source>
        <translation>--scale « %1 » n&apos;est pas une échelle ; dire auto ou un nombre de 0.001 à 1000.</translation>
    </message>
    <message>
        <source>this is no project of Knead. A recipe goes to another part with knead run --set part.file=...</source>
        <translation>ce n&apos;est pas un projet de Knead. Une recette passe à une autre pièce avec knead run --set part.file=...</translation>
    </message>
    <message>
        <source>the project has no entry %1; its last is %2.</source>
        <translation>le projet n&apos;a pas d&apos;entrée %1 ; la dernière est %2.</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>Open that file alone to correct it.</source>
        <translation>Ouvrez ce fichier seul pour corriger cela.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micromètres</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>décimètres</translation>
    </message>
    <message>
        <source>thousandths of an inch</source>
        <translation>millièmes de pouce</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>nanomètres</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <source>miles</source>
        <translation>milles</translation>
    </message>
    <message>
        <source>millionths of an inch</source>
        <translation>millionièmes de pouce</translation>
    </message>
    <message>
        <source>%1: the file states no length unit; millimetres were taken.</source>
        <translation>%1 : le fichier n&apos;indique pas d&apos;unité de longueur ; des millimètres ont été pris.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; that was asked for is not known; known are %2.</source>
        <translation>l&apos;unité de longueur demandée «&#xa0;%1&#xa0;» n&apos;est pas connue&#xa0;; sont connues %2.</translation>
    </message>
    <message>
        <source>the length unit &quot;%1&quot; of the file is not known; known are %2.</source>
        <translation>l&apos;unité de longueur «&#xa0;%1&#xa0;» du fichier n&apos;est pas connue&#xa0;; sont connues %2.</translation>
    </message>
    <message>
        <source>%1: the part is %2 long; if its lengths are %3, it is %4.</source>
        <translation>%1 : la pièce fait %2 de long ; si ses longueurs sont en %3, elle fait %4.</translation>
    </message>
    <message>
        <source>%1: the parts together are %2 long; if their lengths are %3, they are %4.</source>
        <translation>%1 : les pièces font ensemble %2 de long ; si leurs longueurs sont en %3, elles font %4.</translation>
    </message>
</context>
<context>
    <name>ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>FACE</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DROITE</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ARRIÈRE</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>GAUCHE</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>DESSUS</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>DESSOUS</translation>
    </message>
</context>
<context>
    <name>ViewHand</name>
    <message>
        <source>What is seen here is not the present: Esc returns to it. To go on from an earlier moment, press Branch here beside the timeline.</source>
        <translation>Ce que vous voyez n&apos;est pas le présent : Échap y revient. Pour continuer depuis un moment antérieur, appuyez sur « Bifurquer ici » à côté de la ligne du temps.</translation>
    </message>
</context>
<context>
    <name>ViewName</name>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallèle</translation>
    </message>
    <message>
        <source>Double click: this view alone, and all of them again</source>
        <translation>Double clic&#xa0;: cette vue seule, puis de nouveau toutes</translation>
    </message>
</context>
<context>
    <name>ViewReading</name>
    <message>
        <source>Nothing is open</source>
        <translation>Rien n&apos;est ouvert</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n&apos;est sélectionné</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Sélection : %1</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
</context>
<context>
    <name>ViewsFeature</name>
    <message>
        <source>Show two or four views first.</source>
        <translation>Montrez d&apos;abord deux ou quatre vues.</translation>
    </message>
</context>
<context>
    <name>WarningWatch</name>
    <message>
        <source>Fold</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>Wall %1, was %2</source>
        <translation>Paroi %1, était %2</translation>
    </message>
    <message>
        <source>Stretched to %1 % of breaking</source>
        <translation>Étiré à %1 % de la rupture</translation>
    </message>
</context>
<context>
    <name>WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>Viewports</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Barre d&apos;outils</translation>
    </message>
    <message>
        <source>Measure the part</source>
        <translation>Mesurer la pièce</translation>
    </message>
</context>
<context>
    <name>Work</name>
    <message>
        <source>A pipe to another process cannot be made (%1).</source>
        <translation>Un tube vers un autre processus ne peut pas être créé (%1).</translation>
    </message>
    <message>
        <source>The process of %1 cannot be started (%2).</source>
        <translation>Le processus de %1 ne peut pas être démarré (%2).</translation>
    </message>
    <message>
        <source>What was read cannot be fetched (%1).</source>
        <translation>Ce qui a été lu ne peut pas être récupéré (%1).</translation>
    </message>
    <message>
        <source>memory access</source>
        <translation>accès à la mémoire</translation>
    </message>
    <message>
        <source>arithmetic</source>
        <translation>arithmétique</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>erreur interne</translation>
    </message>
    <message>
        <source>illegal instruction</source>
        <translation>instruction illégale</translation>
    </message>
    <message>
        <source>ended from outside, perhaps because the machine ran out of memory</source>
        <translation>arrêté de l&apos;extérieur, peut-être parce que la machine a manqué de mémoire</translation>
    </message>
    <message>
        <source>signal %1</source>
        <translation>le signal %1</translation>
    </message>
    <message>
        <source>the writer</source>
        <translation>le programme d&apos;écriture</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>l&apos;écriture</translation>
    </message>
    <message>
        <source>the reader</source>
        <translation>le programme de lecture</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>la lecture</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source> while %1</source>
        <translation> (pendant «&#xa0;%1&#xa0;»)</translation>
    </message>
    <message>
        <source>%1 took longer than %2%3 and was ended. %4</source>
        <translation>%1 a duré plus de %2%3 et a été interrompue. %4</translation>
    </message>
    <message>
        <source>%1 crashed%2 (%3). %4</source>
        <translation>%1 a planté%2 (%3). %4</translation>
    </message>
    <message>
        <source>%1 ended without a result%2. %3</source>
        <translation>%1 s&apos;est terminé sans résultat%2. %3</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>%1 is still going on: wait for it, or cancel it with Esc.</source>
        <translation>%1 est encore en cours&#xa0;: attendez ou annulez avec Échap.</translation>
    </message>
</context>
</TS>
