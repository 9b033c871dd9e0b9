<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurückgehen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vorwärtsgehen</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Zum übergeordneten Ordner</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Einen neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Als Liste zeigen</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Mit Einzelheiten zeigen</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateien des Typs:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Versteckte Dateien zeigen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neuer Ordner</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 gibt es schon.
Ersetzen?</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Diese Datei gibt es nicht.
Bitte den Namen prüfen.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Diesen Ordner gibt es nicht.
Bitte den Namen prüfen.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert am</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
</context>
<context>
    <name>QPrintPreviewDialog</name>
    <message>
        <source>Print Preview</source>
        <translation>Druckvorschau</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Erste Seite</translation>
    </message>
    <message>
        <source>Last page</source>
        <translation>Letzte Seite</translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation>Seitenbreite</translation>
    </message>
    <message>
        <source>Fit page</source>
        <translation>Ganze Seite</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Show single page</source>
        <translation>Einzelne Seite zeigen</translation>
    </message>
    <message>
        <source>Show facing pages</source>
        <translation>Gegenüberliegende Seiten zeigen</translation>
    </message>
    <message>
        <source>Show overview of all pages</source>
        <translation>Übersicht aller Seiten zeigen</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Seite einrichten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export to PDF</source>
        <translation>Als PDF ausgeben</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>&amp;Adresse kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>card</name>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Fundplatz</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Formation</source>
        <translation>Entstehung</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Preservation</source>
        <translation>Erhaltung</translation>
    </message>
    <message>
        <source>Masonry</source>
        <translation>Mauerwerk</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>Excavation</source>
        <translation>Ausgrabung</translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Unterschriften</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Short definition</source>
        <translation>Kurzansprache</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Interpretation</source>
        <translation>Deutung</translation>
    </message>
    <message>
        <source>Trench</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Dug away on</source>
        <translation>Abgegraben am</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Aufgenommen von</translation>
    </message>
    <message>
        <source>Recorded on</source>
        <translation>Aufgenommen am</translation>
    </message>
    <message>
        <source>Digging began on</source>
        <translation>Begonnen am</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Part of feature</source>
        <translation>Teil des Komplexes</translation>
    </message>
    <message>
        <source>Dates and phases</source>
        <translation>Datierung und Phasen</translation>
    </message>
    <message>
        <source>Site code</source>
        <translation>Kürzel der Grabung</translation>
    </message>
    <message>
        <source>Sector</source>
        <translation>Sektor</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrant</translation>
    </message>
    <message>
        <source>Room or functional unit</source>
        <translation>Raum oder Funktionseinheit</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Formation (natural, artificial)</source>
        <translation>Entstehung (natürlich, künstlich)</translation>
    </message>
    <message>
        <source>Criteria of distinction</source>
        <translation>Unterscheidungsmerkmale</translation>
    </message>
    <message>
        <source>Mode of formation</source>
        <translation>Art der Entstehung</translation>
    </message>
    <message>
        <source>Compaction or consistency</source>
        <translation>Festigkeit, Konsistenz</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Munsell colour</source>
        <translation>Munsell-Farbe</translation>
    </message>
    <message>
        <source>Composition</source>
        <translation>Zusammensetzung</translation>
    </message>
    <message>
        <source>Inclusions</source>
        <translation>Einschlüsse</translation>
    </message>
    <message>
        <source>Organic components</source>
        <translation>organische Bestandteile</translation>
    </message>
    <message>
        <source>Inorganic components</source>
        <translation>anorganische Bestandteile</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Mächtigkeit</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Shape in plan</source>
        <translation>Form im Planum</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Form im Profil</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Break of slope, top and base</source>
        <translation>Kanten oben und unten</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Wandung</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Sohle</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Borders</source>
        <translation>Begrenzung</translation>
    </message>
    <message>
        <source>Truncation</source>
        <translation>Kappung</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Störungen</translation>
    </message>
    <message>
        <source>Masonry: materials, size, finish</source>
        <translation>Mauerwerk: Material, Maße, Bearbeitung</translation>
    </message>
    <message>
        <source>Masonry: coursing and bond</source>
        <translation>Mauerwerk: Lagen und Verband</translation>
    </message>
    <message>
        <source>Masonry: form and faces</source>
        <translation>Mauerwerk: Form und Ansichten</translation>
    </message>
    <message>
        <source>Masonry: bonding material</source>
        <translation>Mauerwerk: Bindemittel</translation>
    </message>
    <message>
        <source>Timber: type and setting</source>
        <translation>Holz: Art und Einbau</translation>
    </message>
    <message>
        <source>Timber: cross-section, conversion</source>
        <translation>Holz: Querschnitt, Zurichtung</translation>
    </message>
    <message>
        <source>Timber: tool marks, joints</source>
        <translation>Holz: Bearbeitungsspuren, Verbindungen</translation>
    </message>
    <message>
        <source>Skeleton: position</source>
        <translation>Skelett: Lage</translation>
    </message>
    <message>
        <source>Skeleton: completeness, truncation</source>
        <translation>Skelett: Vollständigkeit, Störung</translation>
    </message>
    <message>
        <source>Excavation method</source>
        <translation>Grabungsmethode</translation>
    </message>
    <message>
        <source>Per cent excavated</source>
        <translation>Anteil ausgegraben [%]</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Sieving</source>
        <translation>Siebung</translation>
    </message>
    <message>
        <source>Flotation</source>
        <translation>Flotation</translation>
    </message>
    <message>
        <source>Reliability of the stratigraphy</source>
        <translation>Sicherheit der Stratigraphie</translation>
    </message>
    <message>
        <source>Activity</source>
        <translation>Tätigkeit</translation>
    </message>
    <message>
        <source>Dating evidence</source>
        <translation>Datierungshinweise</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>Scientific director</source>
        <translation>wissenschaftliche Leitung</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>geprüft von</translation>
    </message>
    <message>
        <source>Checked on</source>
        <translation>geprüft am</translation>
    </message>
    <message>
        <source>Revised by</source>
        <translation>überarbeitet von</translation>
    </message>
    <message>
        <source>Revised on</source>
        <translation>überarbeitet am</translation>
    </message>
    <message>
        <source>Free fields (name=value lines)</source>
        <translation>freie Felder (Zeilen Name=Wert)</translation>
    </message>
    <message>
        <source>Kind, more closely</source>
        <translation>Art, genauer</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
</context>
<context>
    <name>changes</name>
    <message>
        <source>Accept a relation from surfaces</source>
        <translation>Eine Beziehung aus Flächen annehmen</translation>
    </message>
    <message>
        <source>Accept problem %1</source>
        <translation>Problem %1 hinnehmen</translation>
    </message>
    <message>
        <source>Accept registration run %1</source>
        <translation>Registrierung %1 annehmen</translation>
    </message>
    <message>
        <source>Accept relations from surfaces</source>
        <translation>Beziehungen aus Flächen annehmen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 anlegen</translation>
    </message>
    <message>
        <source>Add %1 scans</source>
        <translation>%1 Scans aufnehmen</translation>
    </message>
    <message>
        <source>Assign %1 finds</source>
        <translation>%1 Funde zuweisen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Correct to %1, instead of %2: %3</source>
        <translation>Berichtigen zu %1 statt %2: %3</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Discard registration run %1</source>
        <translation>Registrierung %1 verwerfen</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
    <message>
        <source>Draw an outline of %1</source>
        <translation>Umriss von %1 zeichnen</translation>
    </message>
    <message>
        <source>Find %1 scans again</source>
        <translation>%1 Scans wiederfinden</translation>
    </message>
    <message>
        <source>Find a scan again</source>
        <translation>Einen Scan wiederfinden</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 einlesen</translation>
    </message>
    <message>
        <source>Import %1 and %2 more</source>
        <translation>%1 und %2 weitere einlesen</translation>
    </message>
    <message>
        <source>Import %1 markers</source>
        <translation>%1 Passmarken einlesen</translation>
    </message>
    <message>
        <source>Import %1 outline</source>
        <translation>%1 Umriss einlesen</translation>
    </message>
    <message>
        <source>Import %1 outlines</source>
        <translation>%1 Umrisse einlesen</translation>
    </message>
    <message>
        <source>Make interpretation %1</source>
        <translation>Lesart %1 anlegen</translation>
    </message>
    <message>
        <source>Mark %1 uncertain: %2</source>
        <translation>%1 als unsicher kennzeichnen: %2</translation>
    </message>
    <message>
        <source>Outline changed ground</source>
        <translation>Geänderten Boden umreißen</translation>
    </message>
    <message>
        <source>Outline changed ground as %1</source>
        <translation>Geänderten Boden als %1 umreißen</translation>
    </message>
    <message>
        <source>Redraw region %1</source>
        <translation>Umriss %1 ändern</translation>
    </message>
    <message>
        <source>Register %1 scans</source>
        <translation>%1 Scans einpassen</translation>
    </message>
    <message>
        <source>Reject a suggestion</source>
        <translation>Einen Vorschlag ablehnen</translation>
    </message>
    <message>
        <source>Reject suggestions</source>
        <translation>Vorschläge ablehnen</translation>
    </message>
    <message>
        <source>Split unit %1, new %2: %3</source>
        <translation>Befund %1 teilen, neu %2: %3</translation>
    </message>
    <message>
        <source>Take over %1 scans</source>
        <translation>%1 Scans übernehmen</translation>
    </message>
    <message>
        <source>Withdraw %1: %2</source>
        <translation>%1 zurücknehmen: %2</translation>
    </message>
    <message>
        <source>area %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>dating %1</source>
        <translation>Datierung %1</translation>
    </message>
    <message>
        <source>document %1</source>
        <translation>Unterlage %1</translation>
    </message>
    <message>
        <source>find %1</source>
        <translation>Fund %1</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>interpretation %1</source>
        <translation>Lesart %1</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Nivellement %1</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>Periode %1</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>Phase %1</translation>
    </message>
    <message>
        <source>region %1</source>
        <translation>Umriss %1</translation>
    </message>
    <message>
        <source>relation %1</source>
        <translation>Beziehung %1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>Probe %1</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>Scan %1</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>Befund %1</translation>
    </message>
    <message>
        <source>Accept problem %1 of %2</source>
        <translation>Problem %1 von %2 hinnehmen</translation>
    </message>
    <message>
        <source>Added %1 row of %2 with another program</source>
        <translation>%2: %1 Eintrag mit einem anderen Programm angelegt</translation>
    </message>
    <message>
        <source>Added %1 rows of %2 with another program</source>
        <translation>%2: %1 Einträge mit einem anderen Programm angelegt</translation>
    </message>
    <message>
        <source>Changed %1 row of %2 with another program</source>
        <translation>%2: %1 Eintrag mit einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>Changed %1 rows of %2 with another program</source>
        <translation>%2: %1 Einträge mit einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>Deleted %1 row of %2 with another program</source>
        <translation>%2: %1 Eintrag mit einem anderen Programm gelöscht</translation>
    </message>
    <message>
        <source>Deleted %1 rows of %2 with another program</source>
        <translation>%2: %1 Einträge mit einem anderen Programm gelöscht</translation>
    </message>
    <message>
        <source>Import measured points of %1</source>
        <translation>Messpunkte aus %1 einlesen</translation>
    </message>
    <message>
        <source>Restored %1 row of %2 with another program</source>
        <translation>%2: %1 Eintrag mit einem anderen Programm zurückgeholt</translation>
    </message>
    <message>
        <source>Restored %1 rows of %2 with another program</source>
        <translation>%2: %1 Einträge mit einem anderen Programm zurückgeholt</translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation>Tag abzeichnen</translation>
    </message>
    <message>
        <source>Accept a problem</source>
        <translation>Ein Problem hinnehmen</translation>
    </message>
    <message>
        <source>Accept problem “%1”</source>
        <translation>Problem „%1“ hinnehmen</translation>
    </message>
    <message>
        <source>Accept problem “%1” (%2)</source>
        <translation>Problem „%1“ (%2) hinnehmen</translation>
    </message>
</context>
<context>
    <name>evidence</name>
    <message>
        <source>upper one dug</source>
        <translation>oben ausgegraben</translation>
    </message>
    <message>
        <source>area [m²]</source>
        <translation>Fläche [m²]</translation>
    </message>
    <message>
        <source>base [m]</source>
        <translation>Unterkante [m]</translation>
    </message>
    <message>
        <source>lower one dug</source>
        <translation>unten ausgegraben</translation>
    </message>
    <message>
        <source>by years</source>
        <translation>nach Jahren</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>nicht zu sagen</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>difference [m]</source>
        <translation>Unterschied [m]</translation>
    </message>
    <message>
        <source>direct</source>
        <translation>unmittelbar</translation>
    </message>
    <message>
        <source>earlier one not before</source>
        <translation>älterer nicht vor</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>later one not after</source>
        <translation>jüngerer nicht nach</translation>
    </message>
    <message>
        <source>length [m]</source>
        <translation>Länge [m]</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>close together</source>
        <translation>nah beieinander</translation>
    </message>
    <message>
        <source>not after</source>
        <translation>nicht nach</translation>
    </message>
    <message>
        <source>not before</source>
        <translation>nicht vor</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>orders</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>other unit [m]</source>
        <translation>der andere [m]</translation>
    </message>
    <message>
        <source>to be removed</source>
        <translation>zu streichen</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>σ of the place [m]</source>
        <translation>σ der Lage [m]</translation>
    </message>
    <message>
        <source>σ of the turn [°]</source>
        <translation>σ der Drehung [°]</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>thickness [m]</source>
        <translation>Dicke [m]</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Male</translation>
    </message>
    <message>
        <source>tolerance [m]</source>
        <translation>Toleranz [m]</translation>
    </message>
    <message>
        <source>top [m]</source>
        <translation>Oberkante [m]</translation>
    </message>
    <message>
        <source>unit [m]</source>
        <translation>der eine [m]</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>years</source>
        <translation>Jahre</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
</context>
<context>
    <name>export</name>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>not carried: %1</source>
        <translation>nicht übernommen: %1</translation>
    </message>
</context>
<context>
    <name>log</name>
    <message>
        <source>recorded</source>
        <translation>angelegt</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>deleted</source>
        <translation>gelöscht</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>zurückgenommen</translation>
    </message>
    <message>
        <source>done again</source>
        <translation>wiederholt</translation>
    </message>
    <message>
        <source>brought back</source>
        <translation>zurückgeholt</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>anderes Programm</translation>
    </message>
</context>
<context>
    <name>papers</name>
    <message>
        <source>no file is named</source>
        <translation>keine Datei genannt</translation>
    </message>
    <message>
        <source>%1 is not shown: it is not in the project&apos;s folder</source>
        <translation>%1 wird nicht gezeigt: liegt nicht im Ordner des Projekts</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 ist nicht da</translation>
    </message>
    <message>
        <source>%1 is no file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>%1 may not be read by this user</source>
        <translation>%1 darf dieser Benutzer nicht lesen</translation>
    </message>
    <message>
        <source>%1 is too large to be shown: %2 MB, up to %3 MB are</source>
        <translation>%1 ist zu groß: %2 MB, gezeigt werden bis %3 MB</translation>
    </message>
    <message>
        <source>%1 is too large to be shown: %2 × %3 pixels, up to %4 million are</source>
        <translation>%1 ist zu groß: %2 × %3 Bildpunkte, gezeigt werden bis %4 Millionen</translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 lässt sich nicht als Bild lesen: %2</translation>
    </message>
    <message>
        <source>%1 is no picture of a kind that can be shown here</source>
        <translation>%1 ist kein Bild einer Art, die hier gezeigt werden kann</translation>
    </message>
</context>
<context>
    <name>planum::gui::BackupRotation</name>
    <message>
        <source>Keeping a copy</source>
        <translation>Kopie anlegen</translation>
    </message>
    <message>
        <source>No copy of the project could be kept: %1</source>
        <translation>Vom Projekt ließ sich keine Kopie anlegen: %1</translation>
    </message>
</context>
<context>
    <name>planum::gui::BoxPanel</name>
    <message>
        <source>West to east</source>
        <translation>West nach Ost</translation>
    </message>
    <message>
        <source>South to north</source>
        <translation>Süd nach Nord</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Cut nothing away</source>
        <translation>Nichts wegschneiden</translation>
    </message>
</context>
<context>
    <name>planum::gui::CardPanel</name>
    <message>
        <source>Full record</source>
        <translation>Ganzer Bogen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select a unit in the list, the matrix or a problem, or add a new one.</source>
        <translation>Einen Befund in der Liste, der Matrix oder einem Problem wählen oder einen neuen anlegen.</translation>
    </message>
    <message>
        <source>Number of a new unit</source>
        <translation>Nummer eines neuen Befunds</translation>
    </message>
    <message>
        <source>Add unit</source>
        <translation>Befund anlegen</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Relation: number, kind, number, Enter</source>
        <translation>Beziehung: Nummer, Art, Nummer, Eingabe</translation>
    </message>
    <message>
        <source>First fields</source>
        <translation>Erste Felder</translation>
    </message>
    <message>
        <source>new unit: %1</source>
        <translation>neuer Befund: %1</translation>
    </message>
    <message>
        <source>Unit %1</source>
        <translation>Befund %1</translation>
    </message>
    <message>
        <source>Relations</source>
        <translation>Beziehungen</translation>
    </message>
    <message>
        <source>none recorded</source>
        <translation>keine aufgenommen</translation>
    </message>
    <message>
        <source>Levels, finds, papers</source>
        <translation>Nivellements, Funde, Unterlagen</translation>
    </message>
    <message>
        <source>%1: not saved yet</source>
        <translation>%1: noch nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>planum::gui::ContentsPanel</name>
    <message>
        <source>What is shown in 3D</source>
        <translation>Was in 3D zu sehen ist</translation>
    </message>
    <message>
        <source>As the time line</source>
        <translation>Wie die Zeitleiste</translation>
    </message>
    <message>
        <source>Show what the time line stands on, and forget what was checked and cleared here</source>
        <translation>Zeigt, worauf die Zeitleiste steht, und vergisst, was hier an- und abgewählt wurde</translation>
    </message>
</context>
<context>
    <name>planum::gui::DayJobs</name>
    <message>
        <source>%1: read as %2</source>
        <translation>%1: gelesen als %2</translation>
    </message>
    <message>
        <source>%1 new units</source>
        <translation>%1 neue Befunde</translation>
    </message>
    <message>
        <source>%1 of them only mentioned</source>
        <translation>davon %1 nur erwähnt</translation>
    </message>
    <message>
        <source>%1 units with fields filled</source>
        <translation>%1 Befunde mit ergänzten Feldern</translation>
    </message>
    <message>
        <source>%1 new relations</source>
        <translation>%1 neue Beziehungen</translation>
    </message>
    <message>
        <source>%1 new statements</source>
        <translation>%1 neue Angaben</translation>
    </message>
    <message>
        <source>%1 new levels, finds, phases and others</source>
        <translation>%1 neue Nivellements, Funde, Phasen und anderes</translation>
    </message>
    <message>
        <source>%1, %2: “%3” stands, the file says “%4”</source>
        <translation>%1, %2: „%3“ steht da, die Datei sagt „%4“</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: not placed. %2</source>
        <translation>%1: nicht eingepasst. %2</translation>
    </message>
    <message>
        <source>Reading what would be imported</source>
        <translation>Lesen, was importiert würde</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>imported: %1 new units, %2 new relations</source>
        <translation>importiert: %1 neue Befunde, %2 neue Beziehungen</translation>
    </message>
    <message>
        <source>nothing in the files is new</source>
        <translation>in den Dateien ist nichts neu</translation>
    </message>
    <message>
        <source>Adding scans</source>
        <translation>Scans aufnehmen</translation>
    </message>
    <message>
        <source>%1 scans added, %2 there already</source>
        <translation>%1 Scans aufgenommen, %2 schon vorhanden</translation>
    </message>
    <message>
        <source>Taking outlines in</source>
        <translation>Umrisse aufnehmen</translation>
    </message>
    <message>
        <source>%1 new outlines, %2 refused</source>
        <translation>%1 neue Umrisse, %2 abgelehnt</translation>
    </message>
    <message>
        <source>Taking measured points in</source>
        <translation>Messpunkte aufnehmen</translation>
    </message>
    <message>
        <source>%1 points: %2 new levels, %3 new finds</source>
        <translation>%1 Punkte: %2 neue Nivellements, %3 neue Funde</translation>
    </message>
    <message>
        <source>Taking markers in</source>
        <translation>Passmarken aufnehmen</translation>
    </message>
    <message>
        <source>%1 markers added, %2 as they were</source>
        <translation>%1 Passmarken aufgenommen, %2 unverändert</translation>
    </message>
    <message>
        <source>Nothing was changed: %1.</source>
        <translation>Nichts wurde geändert: %1.</translation>
    </message>
    <message>
        <source>Registering scans</source>
        <translation>Scans einpassen</translation>
    </message>
    <message>
        <source>Keeping the places of the scans</source>
        <translation>Lage der Scans festhalten</translation>
    </message>
    <message>
        <source>Making a backup</source>
        <translation>Sicherung anlegen</translation>
    </message>
    <message>
        <source>backup written to %1</source>
        <translation>Sicherung geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 of %2 scans placed on the site grid</source>
        <translation>%1 von %2 Scans ins Grabungsnetz eingepasst</translation>
    </message>
    <message>
        <source>%1: placed with doubt. %2</source>
        <translation>%1: mit Zweifel eingepasst. %2</translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceBar</name>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceModel</name>
    <message>
        <source>There is no other surface of this area to compare with.</source>
        <translation>Es gibt keine andere Fläche dieses Schnitts zum Vergleichen.</translation>
    </message>
    <message>
        <source>comparing the surfaces …</source>
        <translation>die Flächen werden verglichen …</translation>
    </message>
    <message>
        <source>Comparing surfaces</source>
        <translation>Flächen werden verglichen</translation>
    </message>
    <message>
        <source>lower than %1</source>
        <translation>tiefer als %1</translation>
    </message>
    <message>
        <source>higher than %1</source>
        <translation>höher als %1</translation>
    </message>
    <message>
        <source>of %1 m² compared, %2 m² lower, %3 m² higher</source>
        <translation>von %1 m² verglichenen %2 m² tiefer, %3 m² höher</translation>
    </message>
    <message>
        <source>%1 and %2 saw no ground in common.</source>
        <translation>%1 und %2 zeigen keinen gemeinsamen Boden.</translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceScale</name>
    <message>
        <source>%1 %2, grey within %3, %1 %4</source>
        <translation>%1 %2, grau innerhalb von %3, %1 %4</translation>
    </message>
    <message>
        <source>Grey: closer than what can be told from none (95 %), %1 in the middle of all cells</source>
        <translation>Grau: weniger als nachweisbar (95 %), im Median aller Zellen %1</translation>
    </message>
</context>
<context>
    <name>planum::gui::FlatPage</name>
    <message>
        <source>Fit</source>
        <translation>Ganz zeigen</translation>
    </message>
    <message>
        <source>Shows the whole (F)</source>
        <translation>Zeigt das Ganze (F)</translation>
    </message>
</context>
<context>
    <name>planum::gui::FlightCameras</name>
    <message>
        <source>Reading the cameras of the flight</source>
        <translation>Die Kameras des Fluges werden gelesen</translation>
    </message>
    <message>
        <source>placing a camera</source>
        <translation>Kamera setzen</translation>
    </message>
    <message>
        <source>forgetting the cameras</source>
        <translation>Kameras vergessen</translation>
    </message>
    <message>
        <source>The cameras stay in this window only: %1</source>
        <translation>Die Kameras bleiben nur in diesem Fenster: %1</translation>
    </message>
    <message>
        <source>Keeping the cameras of the flight</source>
        <translation>Die Kameras des Fluges werden gespeichert</translation>
    </message>
    <message>
        <source>Another window changed the cameras meanwhile; nothing was taken back.</source>
        <translation>Ein anderes Fenster hat die Kameras inzwischen geändert; nichts wurde zurückgenommen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::FlightWriter</name>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
</context>
<context>
    <name>planum::gui::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>%1 (taken back)</source>
        <translation>%1 (zurückgenommen)</translation>
    </message>
</context>
<context>
    <name>planum::gui::ImportDialog</name>
    <message>
        <source>what the files say replaces what differs</source>
        <translation>was die Dateien sagen, ersetzt Abweichendes</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>lesen …</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>This is what would change; nothing is written yet.</source>
        <translation>Das würde sich ändern; noch ist nichts geschrieben.</translation>
    </message>
    <message>
        <source>Nothing in the files is new.</source>
        <translation>In den Dateien ist nichts neu.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Differs; the project&apos;s is kept unless you say otherwise</source>
        <translation>Weicht ab; es bleibt beim Stand des Projekts, wenn Sie nichts anderes wählen</translation>
    </message>
    <message>
        <source>Not understood, or worth a look</source>
        <translation>Nicht verstanden oder einen Blick wert</translation>
    </message>
    <message>
        <source>The files cannot be read; nothing was changed.</source>
        <translation>Die Dateien können nicht gelesen werden; geändert wurde nichts.</translation>
    </message>
</context>
<context>
    <name>planum::gui::Inquiry</name>
    <message>
        <source>only in %1: %2 %3 %4; the other orders them the other way round</source>
        <translation>nur in %1: %2 %3 %4; die andere ordnet sie umgekehrt</translation>
    </message>
    <message>
        <source>only in %1: %2 %3 %4</source>
        <translation>nur in %1: %2 %3 %4</translation>
    </message>
    <message>
        <source>order of %1: %2 later than %3; the other says the opposite</source>
        <translation>Reihenfolge in %1: %2 jünger als %3; die andere sagt das Gegenteil</translation>
    </message>
    <message>
        <source>order of %1: %2 later than %3; the other does not order them</source>
        <translation>Reihenfolge in %1: %2 jünger als %3; die andere ordnet sie nicht</translation>
    </message>
    <message>
        <source>contradicted in %1 only: %2</source>
        <translation>Widerspruch nur in %1: %2</translation>
    </message>
    <message>
        <source>%1 and %2 say the same</source>
        <translation>%1 und %2 sagen dasselbe</translation>
    </message>
    <message>
        <source>%1: only in run %2</source>
        <translation>%1: nur in Registrierung %2</translation>
    </message>
    <message>
        <source>%1: moves %2 mm, turns %3° (known within %4 and %5 mm)</source>
        <translation>%1: rückt um %2 mm, dreht um %3° (bekannt auf %4 und %5 mm)</translation>
    </message>
    <message>
        <source>neither run placed a scan</source>
        <translation>keine der beiden hat einen Scan eingepasst</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>Befund nicht bekannt</translation>
    </message>
    <message>
        <source>%1: %2 m², %3 m since the surface before; %4: %5</source>
        <translation>%1: %2 m², %3 m seit der Fläche davor; %4: %5</translation>
    </message>
    <message>
        <source>all ground that changed is outlined</source>
        <translation>aller veränderte Boden ist umrissen</translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) outside all outlines left out</source>
        <translation>
            <numerusform>%n Stück außerhalb aller Umrisse weggelassen</numerusform>
            <numerusform>%n Stücke außerhalb aller Umrisse weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Verifying the project</source>
        <translation>Projekt prüfen</translation>
    </message>
    <message>
        <source>no problem found in the file, its scans and their points</source>
        <translation>kein Fehler in der Datei, ihren Scans und deren Punkten gefunden</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Registration %1 and %2</source>
        <translation>Registrierung %1 und %2</translation>
    </message>
    <message>
        <source>Ground not outlined yet</source>
        <translation>Noch nicht umrissener Boden</translation>
    </message>
    <message>
        <source>Outlines (*.geojson)</source>
        <translation>Umrisse (*.geojson)</translation>
    </message>
    <message>
        <source>Accept registration %1</source>
        <translation>Registrierung %1 annehmen</translation>
    </message>
    <message>
        <source>Discard registration %1</source>
        <translation>Registrierung %1 verwerfen</translation>
    </message>
    <message>
        <source>Cleaning the project</source>
        <translation>Projekt aufräumen</translation>
    </message>
    <message>
        <source>nothing was removed: the project file itself is not sound</source>
        <translation>nichts wurde entfernt: die Projektdatei selbst ist nicht heil</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) removed, %1 MB</source>
        <translation>
            <numerusform>%n Datei entfernt, %1 MB</numerusform>
            <numerusform>%n Dateien entfernt, %1 MB</numerusform>
        </translation>
    </message>
    <message>
        <source>the project file is %1 MB shorter</source>
        <translation>die Projektdatei ist %1 MB kürzer</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>Punkte von %1</translation>
    </message>
    <message>
        <source>wrote %1: %2 points</source>
        <translation>%1 geschrieben: %2 Punkte</translation>
    </message>
</context>
<context>
    <name>planum::gui::JobSign</name>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>stopping …</source>
        <translation>hält an …</translation>
    </message>
</context>
<context>
    <name>planum::gui::MainWindow</name>
    <message>
        <source>recorded: %1</source>
        <translation>aufgenommen: %1</translation>
    </message>
    <message>
        <source>New project …</source>
        <translation>Neues Projekt …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open for reading only …</source>
        <translation>Nur zum Lesen öffnen …</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
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
        <source>Find a unit</source>
        <translation>Befund suchen</translation>
    </message>
    <message>
        <source>Add a relation</source>
        <translation>Beziehung eintragen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Aussehen</translation>
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
        <source>Sunlight</source>
        <translation>Sonnenlicht</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>no project open</source>
        <translation>kein Projekt geöffnet</translation>
    </message>
    <message>
        <source>%1: %2 units, %3 relations</source>
        <translation>%1: %2 Befunde, %3 Beziehungen</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg);;All files (*)</source>
        <translation>Planum-Projekte (*.gpkg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg)</source>
        <translation>Planum-Projekte (*.gpkg)</translation>
    </message>
    <message>
        <source>%1 from the next start on</source>
        <translation>%1 ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>saving …</source>
        <translation>wird gespeichert …</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>View alone</source>
        <translation>Nur die Ansicht</translation>
    </message>
    <message>
        <source>These fields could not be saved, and are lost when the project closes:
%1</source>
        <translation>Diese Felder konnten nicht gesichert werden und gehen verloren, wenn das Projekt geschlossen wird:
%1</translation>
    </message>
    <message>
        <source>Keep the project open</source>
        <translation>Projekt offen lassen</translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixCanvas</name>
    <message>
        <source>Drawing of the matrix</source>
        <translation>Zeichnung der Matrix</translation>
    </message>
    <message>
        <source>No drawing yet.</source>
        <translation>Noch keine Zeichnung.</translation>
    </message>
    <message>
        <source>No units to draw. Import lists of units and relations, or add a unit in the record card.</source>
        <translation>Keine Befunde zu zeichnen. Listen von Befunden und Beziehungen importieren oder im Befundbogen einen Befund anlegen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixModel</name>
    <message>
        <source>Drawing the matrix</source>
        <translation>Matrix zeichnen</translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixView</name>
    <message>
        <source>%1 boxes, %2 lines</source>
        <translation>%1 Kästen, %2 Linien</translation>
    </message>
    <message>
        <source>Part of the matrix</source>
        <translation>Ausschnitt der Matrix</translation>
    </message>
    <message>
        <source>whole site</source>
        <translation>ganze Grabung</translation>
    </message>
    <message>
        <source>around the selected unit</source>
        <translation>um den gewählten Befund</translation>
    </message>
    <message>
        <source>only what problems are about</source>
        <translation>nur was Probleme betrifft</translation>
    </message>
    <message>
        <source>what changed since yesterday</source>
        <translation>was sich seit gestern geändert hat</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Zusammengefasst</translation>
    </message>
    <message>
        <source>not folded</source>
        <translation>nicht zusammengefasst</translation>
    </message>
    <message>
        <source>phases folded</source>
        <translation>nach Phasen</translation>
    </message>
    <message>
        <source>periods folded</source>
        <translation>nach Perioden</translation>
    </message>
    <message>
        <source>groups folded</source>
        <translation>nach Gruppen</translation>
    </message>
    <message>
        <source>Titles</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Short definitions below the numbers</source>
        <translation>Kurzansprachen unter den Nummern</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ganz zeigen</translation>
    </message>
    <message>
        <source>The whole drawing (F)</source>
        <translation>Die ganze Zeichnung (F)</translation>
    </message>
    <message>
        <source>   – closes a circle</source>
        <translation>   – schließt einen Kreis</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>contradicted</source>
        <translation>widersprochen</translation>
    </message>
    <message>
        <source>not testable</source>
        <translation>nicht prüfbar</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Belege</translation>
    </message>
    <message>
        <source>Which lines surfaces, sections and levels confirm or contradict</source>
        <translation>Welche Linien Flächen, Profile und Nivellements bestätigen oder widerlegen</translation>
    </message>
</context>
<context>
    <name>planum::gui::NoticeBar</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineBar</name>
    <message>
        <source>Draw an outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Unit of the outline</source>
        <translation>Befund des Umrisses</translation>
    </message>
    <message>
        <source>What the outline encloses</source>
        <translation>Was der Umriss umschließt</translation>
    </message>
    <message>
        <source>What the outline shows of it</source>
        <translation>Was der Umriss davon zeigt</translation>
    </message>
    <message>
        <source>shows: by kind</source>
        <translation>zeigt: nach Art</translation>
    </message>
    <message>
        <source>Corner back</source>
        <translation>Ecke zurück</translation>
    </message>
    <message>
        <source>Takes the last corner back (Backspace, Ctrl+Z); brings a cancelled outline back</source>
        <translation>Nimmt die letzte Ecke zurück (Rücktaste, Strg+Z); holt einen abgebrochenen Umriss wieder</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Closes the outline (Enter, or a click on the first corner)</source>
        <translation>Schließt den Umriss (Eingabe oder Klick auf die erste Ecke)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Esc; can be taken back</source>
        <translation>Esc; kann zurückgenommen werden</translation>
    </message>
    <message>
        <source>Change an outline</source>
        <translation>Umriss ändern</translation>
    </message>
    <message>
        <source>Moves, sets and takes away corners of an outline that is there</source>
        <translation>Verschiebt, setzt und entfernt Ecken eines vorhandenen Umrisses</translation>
    </message>
    <message>
        <source>Corner away</source>
        <translation>Ecke weg</translation>
    </message>
    <message>
        <source>Takes the chosen corner away (Delete, or the right button on it)</source>
        <translation>Nimmt die gewählte Ecke weg (Entf, oder die rechte Taste darauf)</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>Schritt zurück</translation>
    </message>
    <message>
        <source>Takes the last change of this outline back (Ctrl+Z)</source>
        <translation>Nimmt die letzte Änderung dieses Umrisses zurück (Strg+Z)</translation>
    </message>
    <message>
        <source>Keeps the outline as it is now (Enter)</source>
        <translation>Behält den Umriss, wie er jetzt ist (Eingabe)</translation>
    </message>
    <message>
        <source>Name what changed</source>
        <translation>Verändertes benennen</translation>
    </message>
    <message>
        <source>Offers ground that changed since the surface before and has no outline yet</source>
        <translation>Bietet an, was sich seit der Fläche davor geändert und noch keinen Umriss hat</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Makes an outline of the patch, of the unit beside it (Enter)</source>
        <translation>Macht aus der Stelle einen Umriss des nebenstehenden Befunds (Eingabe)</translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineEdit</name>
    <message>
        <source>Change an outline</source>
        <translation>Umriss ändern</translation>
    </message>
    <message>
        <source>Choose the outline that shall be changed: click into it.</source>
        <translation>Den Umriss wählen, der geändert werden soll: hineinklicken.</translation>
    </message>
    <message>
        <source>This outline cannot be seen here.</source>
        <translation>Dieser Umriss ist hier nicht zu sehen.</translation>
    </message>
    <message>
        <source>Drag a corner, or the middle of a line for a new one; Delete takes a corner away.</source>
        <translation>Eine Ecke ziehen, oder die Mitte einer Linie für eine neue; Entf nimmt eine Ecke weg.</translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineTool</name>
    <message>
        <source>Near it: %1.</source>
        <translation>Ähnlich: %1.</translation>
    </message>
    <message>
        <source>No unit %1 yet; it will be made.</source>
        <translation>Befund %1 gibt es noch nicht; er wird angelegt.</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaCanvas</name>
    <message>
        <source>Panorama</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>unrolling the scan …</source>
        <translation>Scan wird abgerollt …</translation>
    </message>
    <message>
        <source>No scan of this surface yet. Add scans from the project menu, or drop files on the window.</source>
        <translation>Noch kein Scan dieser Fläche. Scans über das Menü Projekt aufnehmen oder Dateien auf das Fenster ziehen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaModel</name>
    <message>
        <source>Unrolling %1</source>
        <translation>%1 abrollen</translation>
    </message>
    <message>
        <source>nothing was measured here</source>
        <translation>hier wurde nichts gemessen</translation>
    </message>
    <message>
        <source>%1 m from the scanner</source>
        <translation>%1 m vom Scanner</translation>
    </message>
    <message>
        <source>x %1  y %2  height %3 m</source>
        <translation>x %1  y %2  Höhe %3 m</translation>
    </message>
    <message>
        <source>This scan is not on the site grid yet: register it, then outlines can be drawn.</source>
        <translation>Dieser Scan liegt noch nicht im Grabungsnetz: erst einpassen, dann lassen sich Umrisse zeichnen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaView</name>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>as scanned</source>
        <translation>wie aufgenommen</translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation>Reflektanz</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>schattiert</translation>
    </message>
    <message>
        <source>equirectangular</source>
        <translation>äquirektangular</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>zylindrisch</translation>
    </message>
    <message>
        <source>Mercator</source>
        <translation>Mercator</translation>
    </message>
    <message>
        <source>Miller</source>
        <translation>Miller</translation>
    </message>
    <message>
        <source>equal-area</source>
        <translation>flächentreu</translation>
    </message>
    <message>
        <source>rectilinear</source>
        <translation>geradentreu</translation>
    </message>
    <message>
        <source>Pannini</source>
        <translation>Pannini</translation>
    </message>
    <message>
        <source>stereographic</source>
        <translation>stereografisch</translation>
    </message>
</context>
<context>
    <name>planum::gui::PaperMenu</name>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>On paper (*.pdf);;Picture (*.png)</source>
        <translation>Auf Papier (*.pdf);;Bild (*.png)</translation>
    </message>
    <message>
        <source>Report, plan, section</source>
        <translation>Bericht, Plan, Profil</translation>
    </message>
    <message>
        <source>Report …</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Plan to scale …</source>
        <translation>Plan im Maßstab …</translation>
    </message>
    <message>
        <source>Section to scale …</source>
        <translation>Profil im Maßstab …</translation>
    </message>
    <message>
        <source>the whole record</source>
        <translation>die ganze Grabung</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Report (*.pdf *.html *.xml)</source>
        <translation>Bericht (*.pdf *.html *.xml)</translation>
    </message>
    <message>
        <source>There is no surface to draw yet.</source>
        <translation>Es gibt noch keine Fläche zu zeichnen.</translation>
    </message>
    <message>
        <source>Plan to scale</source>
        <translation>Plan im Maßstab</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>There is no section yet.</source>
        <translation>Es gibt noch kein Profil.</translation>
    </message>
    <message>
        <source>Section to scale</source>
        <translation>Profil im Maßstab</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Section between two points …</source>
        <translation>Profil zwischen zwei Punkten …</translation>
    </message>
    <message>
        <source>Section between two points</source>
        <translation>Profil zwischen zwei Punkten</translation>
    </message>
    <message>
        <source>From x y [m]</source>
        <translation>Von x y [m]</translation>
    </message>
    <message>
        <source>To x y [m]</source>
        <translation>Bis x y [m]</translation>
    </message>
    <message>
        <source>A place is two numbers: x and y in metres.</source>
        <translation>Ein Ort sind zwei Zahlen: x und y in Metern.</translation>
    </message>
</context>
<context>
    <name>planum::gui::PatchModel</name>
    <message>
        <source>Looking for ground without outlines</source>
        <translation>Suche nach Boden ohne Umriss</translation>
    </message>
    <message>
        <source>Name changed ground</source>
        <translation>Geänderten Boden benennen</translation>
    </message>
    <message>
        <source>comparing with the surface before …</source>
        <translation>Vergleich mit der Fläche davor …</translation>
    </message>
    <message>
        <source>All ground that changed is outlined.</source>
        <translation>Alles, was sich geändert hat, ist umrissen.</translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) changed and have no outline: click into one.</source>
        <translation>
            <numerusform>%n Stelle hat sich geändert und keinen Umriss: hineinklicken.</numerusform>
            <numerusform>%n Stellen haben sich geändert und keinen Umriss: in eine hineinklicken.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m², %2 m</source>
        <translation>%1 m², %2 m</translation>
    </message>
</context>
<context>
    <name>planum::gui::PhotoStrip</name>
    <message>
        <source>Photos and drawings</source>
        <translation>Fotos und Zeichnungen</translation>
    </message>
    <message>
        <source>Reading photos</source>
        <translation>Fotos werden gelesen</translation>
    </message>
</context>
<context>
    <name>planum::gui::PhotoWindow</name>
    <message>
        <source>Previous</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>reading the picture …</source>
        <translation>das Bild wird gelesen …</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Bildpunkte</translation>
    </message>
    <message>
        <source>Reading photos</source>
        <translation>Fotos werden gelesen</translation>
    </message>
</context>
<context>
    <name>planum::gui::PlanCanvas</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>No outlines, finds or stations yet. Add scans, draw outlines on a panorama, or import outlines and measured points.</source>
        <translation>Noch keine Umrisse, Funde oder Standpunkte. Scans aufnehmen, Umrisse auf einem Panorama zeichnen oder Umrisse und Messpunkte importieren.</translation>
    </message>
</context>
<context>
    <name>planum::gui::PlanView</name>
    <message>
        <source>There is no surface to draw on yet.</source>
        <translation>Es gibt noch keine Fläche, auf der man zeichnen könnte.</translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemListModel</name>
    <message>
        <source>number %1 in “%2”, probably %3</source>
        <translation>Nummer %1 in „%2“, wohl %3</translation>
    </message>
    <message>
        <source>unit %1, probably two</source>
        <translation>Befund %1, wohl zwei</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>Mark uncertain</source>
        <translation>Als unsicher kennzeichnen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>Nummer berichtigen</translation>
    </message>
    <message>
        <source>Split the unit</source>
        <translation>Befund teilen</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>nothing contradicts anything</source>
        <translation>nichts widerspricht sich</translation>
    </message>
    <message>
        <source>%1 relations state an order</source>
        <translation>%1 Beziehungen geben eine Reihenfolge an</translation>
    </message>
    <message>
        <source>%1 confirmed</source>
        <translation>%1 bestätigt</translation>
    </message>
    <message>
        <source>%1 contradicted</source>
        <translation>%1 widersprochen</translation>
    </message>
    <message>
        <source>%1 not testable: %2</source>
        <translation>%1 nicht prüfbar: %2</translation>
    </message>
    <message>
        <source>Keep a problem silent</source>
        <translation>Problem stillstellen</translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation>Tag abzeichnen</translation>
    </message>
    <message>
        <source>  · new</source>
        <translation>  · neu</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n Warnung</numerusform>
            <numerusform>%n Warnungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n remark(s)</source>
        <translation>
            <numerusform>%n Hinweis</numerusform>
            <numerusform>%n Hinweise</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Comparing the surfaces</source>
        <translation>Die Flächen werden verglichen</translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemPanel</name>
    <message>
        <source>Number of the new unit</source>
        <translation>Nummer des neuen Befunds</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>remarks too</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation>Tag abzeichnen</translation>
    </message>
    <message>
        <source>What stands now is not new tomorrow; it is signed with your name.</source>
        <translation>Was jetzt dasteht, ist morgen nicht neu; es ist mit Ihrem Namen abgezeichnet.</translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>prüft …</translation>
    </message>
    <message>
        <source>; signed off %1 by %2</source>
        <translation>; abgezeichnet am %1 von %2</translation>
    </message>
    <message>
        <source>%1   (%2 %)</source>
        <translation>%1   (%2 %)</translation>
    </message>
    <message>
        <source>Choose a problem: its proof shows in the matrix and in every other view.</source>
        <translation>Ein Problem wählen: sein Beleg erscheint in der Matrix und in allen anderen Ansichten.</translation>
    </message>
    <message>
        <source>Known because …</source>
        <translation>Bekannt, weil …</translation>
    </message>
    <message>
        <source>What to doubt</source>
        <translation>Woran zu zweifeln ist</translation>
    </message>
    <message>
        <source>Rests on</source>
        <translation>Beruht auf</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Keep it silent</source>
        <translation>Stillstellen</translation>
    </message>
    <message numerus="yes">
        <source>; %n change(s) since</source>
        <translation>
            <numerusform>; %n Änderung seither</numerusform>
            <numerusform>; %n Änderungen seither</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed after the day was signed off</source>
        <translation>Geändert, nachdem der Tag abgezeichnet war</translation>
    </message>
    <message>
        <source>; the surfaces are still being compared</source>
        <translation>; die Flächen werden noch verglichen</translation>
    </message>
</context>
<context>
    <name>planum::gui::ProjectMenu</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Import lists …</source>
        <translation>Listen importieren …</translation>
    </message>
    <message>
        <source>Lists of units, relations, finds</source>
        <translation>Listen von Befunden, Beziehungen, Funden</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add scans …</source>
        <translation>Scans aufnehmen …</translation>
    </message>
    <message>
        <source>Folder of a day&apos;s scans</source>
        <translation>Ordner mit den Scans eines Tages</translation>
    </message>
    <message>
        <source>Import outlines …</source>
        <translation>Umrisse importieren …</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Outlines (*.geojson *.json)</source>
        <translation>Umrisse (*.geojson *.json)</translation>
    </message>
    <message>
        <source>Import measured points …</source>
        <translation>Messpunkte importieren …</translation>
    </message>
    <message>
        <source>Points of the total station</source>
        <translation>Punkte der Totalstation</translation>
    </message>
    <message>
        <source>Points (*.csv *.txt *.dxf);;All files (*)</source>
        <translation>Punkte (*.csv *.txt *.dxf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export or print …</source>
        <translation>Ausgeben oder drucken …</translation>
    </message>
    <message>
        <source>Backup …</source>
        <translation>Sicherung …</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg)</source>
        <translation>Planum-Projekte (*.gpkg)</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>Open a project first, then drop the files on it.</source>
        <translation>Erst ein Projekt öffnen, dann die Dateien daraufziehen.</translation>
    </message>
    <message>
        <source>Export or print</source>
        <translation>Ausgeben oder drucken</translation>
    </message>
    <message>
        <source>Matrix (*.pdf *.svg *.png);;Report (*.xml *.html);;For other programs (*.csv *.json *.lst *.hmcx *.graphml *.dot *.geojson *.ttl *.xlsx *.dxf *.oxcal)</source>
        <translation>Matrix (*.pdf *.svg *.png);;Bericht (*.xml *.html);;Für andere Programme (*.csv *.json *.lst *.hmcx *.graphml *.dot *.geojson *.ttl *.xlsx *.dxf *.oxcal)</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>larger, smaller, the whole drawing</source>
        <translation>größer, kleiner, die ganze Zeichnung</translation>
    </message>
    <message>
        <source>along the orders of the matrix, or move the picture</source>
        <translation>entlang der Reihenfolge in der Matrix, oder das Bild verschieben</translation>
    </message>
    <message>
        <source>while drawing: last corner back</source>
        <translation>beim Zeichnen: letzte Ecke zurück</translation>
    </message>
    <message>
        <source>while drawing: cancel (can be taken back)</source>
        <translation>beim Zeichnen: abbrechen (kann zurückgenommen werden)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Make a sample dig …</source>
        <translation>Beispielgrabung anlegen …</translation>
    </message>
    <message>
        <source>Print the matrix …</source>
        <translation>Matrix drucken …</translation>
    </message>
    <message>
        <source>No matrix is drawn that could be printed.</source>
        <translation>Es ist keine Matrix gezeichnet, die gedruckt werden könnte.</translation>
    </message>
    <message>
        <source>small: 12 units, half a minute</source>
        <translation>klein: 12 Befunde, eine halbe Minute</translation>
    </message>
    <message>
        <source>medium: 40 units, minutes, 600 MB</source>
        <translation>mittel: 40 Befunde, Minuten, 600 MB</translation>
    </message>
    <message>
        <source>Make a sample dig</source>
        <translation>Beispielgrabung anlegen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>New folder for the sample dig</source>
        <translation>Neuer Ordner für die Beispielgrabung</translation>
    </message>
    <message>
        <source>Making a sample dig</source>
        <translation>Beispielgrabung wird angelegt</translation>
    </message>
</context>
<context>
    <name>planum::gui::ProofPicture</name>
    <message>
        <source>Both faces in plan and cross-section</source>
        <translation>Beide Flächen im Plan und im Querschnitt</translation>
    </message>
    <message>
        <source>drawing both faces …</source>
        <translation>beide Flächen werden gezeichnet …</translation>
    </message>
    <message>
        <source>Drawing the proof</source>
        <translation>Der Beleg wird gezeichnet</translation>
    </message>
    <message>
        <source>Click to see it large</source>
        <translation>Klicken, um es groß zu sehen</translation>
    </message>
</context>
<context>
    <name>planum::gui::RecordsModel</name>
    <message>
        <source>Listing</source>
        <translation>Auflisten</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Add %1 %2</source>
        <translation>%1 %2 anlegen</translation>
    </message>
    <message>
        <source>Change %1 %2</source>
        <translation>%1 %2 ändern</translation>
    </message>
    <message>
        <source>Delete %1 %2</source>
        <translation>%1 %2 löschen</translation>
    </message>
</context>
<context>
    <name>planum::gui::RecordsView</name>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Find in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Name of a new one</source>
        <translation>Name eines neuen Eintrags</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>new: %1</source>
        <translation>neu: %1</translation>
    </message>
    <message>
        <source>Choose one of the list, or add one.</source>
        <translation>Einen Eintrag der Liste wählen oder einen anlegen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::RelationEntryBar</name>
    <message>
        <source>Show the circle</source>
        <translation>Kreis zeigen</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>covers, cut by, …</source>
        <translation>über, geschnitten von, …</translation>
    </message>
    <message>
        <source>Relation: first unit</source>
        <translation>Beziehung: erster Befund</translation>
    </message>
    <message>
        <source>Relation: kind</source>
        <translation>Beziehung: Art</translation>
    </message>
    <message>
        <source>Relation: second unit</source>
        <translation>Beziehung: zweiter Befund</translation>
    </message>
</context>
<context>
    <name>planum::gui::RelationEntryModel</name>
    <message>
        <source>Number of a unit</source>
        <translation>Nummer eines Befunds</translation>
    </message>
    <message>
        <source>Relation: covers, cut by, fills, …</source>
        <translation>Beziehung: über, geschnitten von, verfüllt, …</translation>
    </message>
    <message>
        <source>“%1” is no relation</source>
        <translation>„%1“ ist keine Beziehung</translation>
    </message>
    <message>
        <source>Number of the other unit</source>
        <translation>Nummer des anderen Befunds</translation>
    </message>
    <message>
        <source>%1 is used in several areas; write AREA::%1</source>
        <translation>%1 gibt es in mehreren Schnitten; SCHNITT::%1 schreiben</translation>
    </message>
    <message>
        <source>There is no unit %1 yet; Enter adds it as one only mentioned.</source>
        <translation>Befund %1 gibt es noch nicht; Eingabe legt ihn als nur erwähnten an.</translation>
    </message>
    <message>
        <source>Near it: %1.</source>
        <translation>Ähnlich: %1.</translation>
    </message>
    <message>
        <source>That puts %1 above itself. Enter records it all the same.</source>
        <translation>Damit läge %1 über sich selbst. Eingabe nimmt es trotzdem auf.</translation>
    </message>
    <message>
        <source>That closes a circle: %1. Enter records it all the same.</source>
        <translation>Das schließt einen Kreis: %1. Eingabe nimmt es trotzdem auf.</translation>
    </message>
    <message>
        <source>Add relation %1</source>
        <translation>Beziehung %1 eintragen</translation>
    </message>
</context>
<context>
    <name>planum::gui::ScansView</name>
    <message>
        <source>on the site grid</source>
        <translation>im Grabungsnetz</translation>
    </message>
    <message>
        <source>not placed yet</source>
        <translation>noch nicht eingepasst</translation>
    </message>
    <message>
        <source>the original file is not where it was</source>
        <translation>die Originaldatei liegt nicht mehr an ihrem Platz</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>rms [mm]</source>
        <translation>rms [mm]</translation>
    </message>
    <message>
        <source>within [mm]</source>
        <translation>auf [mm]</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Puts the scans on the site grid that are not there yet</source>
        <translation>Passt die Scans ins Grabungsnetz ein, die noch nicht darin liegen</translation>
    </message>
    <message>
        <source>Add scans …</source>
        <translation>Scans aufnehmen …</translation>
    </message>
    <message>
        <source>Markers …</source>
        <translation>Passmarken …</translation>
    </message>
    <message>
        <source>Folder of a day&apos;s scans</source>
        <translation>Ordner mit den Scans eines Tages</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Passmarken</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Listing scans</source>
        <translation>Scans auflisten</translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionCanvas</name>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>looking along the section …</source>
        <translation>Blick entlang des Profils …</translation>
    </message>
    <message>
        <source>No section yet. Draw outlines or put scans on the site grid, and a cut through them shows here; a section of the record is a line between two surveyed points, which outlines name when they are imported.</source>
        <translation>Noch kein Profil. Umrisse zeichnen oder Scans ins Grabungsnetz einpassen, dann zeigt sich hier ein Schnitt hindurch; ein Profil der Aufnahme ist eine Linie zwischen zwei eingemessenen Punkten, die eingelesene Umrisse nennen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionLine</name>
    <message>
        <source>Too near the first one.</source>
        <translation>Zu nahe beim ersten.</translation>
    </message>
    <message>
        <source>Click where the line begins.</source>
        <translation>Klicken, wo die Linie beginnt.</translation>
    </message>
    <message>
        <source>Click where it ends.</source>
        <translation>Klicken, wo sie endet.</translation>
    </message>
    <message>
        <source>%1 m long</source>
        <translation>%1 m lang</translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionLineBar</name>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Look straight at it</source>
        <translation>Gerade darauf sehen</translation>
    </message>
    <message>
        <source>Show as a section</source>
        <translation>Als Profil zeigen</translation>
    </message>
    <message>
        <source>In the section view, rectified</source>
        <translation>In der Ansicht Profil, entzerrt</translation>
    </message>
    <message>
        <source>Another line</source>
        <translation>Neue Linie</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Cut nothing away (Esc)</source>
        <translation>Nichts wegschneiden (Esc)</translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionModel</name>
    <message>
        <source>Cut, west to east</source>
        <translation>Schnitt, West nach Ost</translation>
    </message>
    <message>
        <source>Cut, south to north</source>
        <translation>Schnitt, Süd nach Nord</translation>
    </message>
    <message>
        <source>Looking along the section</source>
        <translation>Blick entlang des Profils</translation>
    </message>
    <message>
        <source>Cut, laid in 3D</source>
        <translation>Schnitt, in 3D gelegt</translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionView</name>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>%1 m along, height %2 m</source>
        <translation>bei %1 m, Höhe %2 m</translation>
    </message>
    <message>
        <source>A cut to look at; outlines are drawn on recorded sections.</source>
        <translation>Ein Schnitt zum Ansehen; Umrisse werden auf aufgenommene Profile gezeichnet.</translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceCanvas</name>
    <message>
        <source>The 3D view needs OpenGL 3.3, which this display does not offer. All other views work.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.3, das diese Anzeige nicht bietet. Alle anderen Ansichten arbeiten.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.3; there is %1.%2 here. All other views work.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.3; hier gibt es %1.%2. Alle anderen Ansichten arbeiten.</translation>
    </message>
    <message>
        <source>The site in 3D</source>
        <translation>Die Grabung in 3D</translation>
    </message>
    <message>
        <source>Choosing points</source>
        <translation>Punkte auswählen</translation>
    </message>
    <message>
        <source>Looking up a point</source>
        <translation>Punkt nachsehen</translation>
    </message>
    <message>
        <source>The 3D view needs a display; the program runs without one (%1). All other views work.</source>
        <translation>Die 3D-Ansicht braucht einen Bildschirm; das Programm läuft ohne (%1). Alle anderen Ansichten arbeiten.</translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceContents</name>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>it is not on the site grid yet</source>
        <translation>steht noch nicht im Grabungsnetz</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>it has no heights</source>
        <translation>hat keine Höhen</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Profil %1</translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceModel</name>
    <message>
        <source>Opening the points</source>
        <translation>Punkte öffnen</translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceView</name>
    <message>
        <source>x %1  y %2  height %3 m</source>
        <translation>x %1  y %2  Höhe %3 m</translation>
    </message>
    <message>
        <source>%1 m apart, %2 m up</source>
        <translation>%1 m entfernt, %2 m höher</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>colour as scanned</source>
        <translation>Farbe wie aufgenommen</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>shaded by depth</source>
        <translation>Tiefenschatten</translation>
    </message>
    <message>
        <source>all surfaces</source>
        <translation>alle Flächen</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Plan, north up (T)</source>
        <translation>Plan, Norden oben (T)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ganz zeigen</translation>
    </message>
    <message>
        <source>The trench (F)</source>
        <translation>Der Schnitt (F)</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) written</source>
        <translation>
            <numerusform>%n Bild geschrieben</numerusform>
            <numerusform>%n Bilder geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Wegschneiden</translation>
    </message>
    <message>
        <source>Cut away what lies in front, above or behind</source>
        <translation>Wegschneiden, was davor, darüber oder dahinter liegt</translation>
    </message>
    <message>
        <source>Place a camera here</source>
        <translation>Kamera hier aufstellen</translation>
    </message>
    <message>
        <source>Write the flight …</source>
        <translation>Flug schreiben …</translation>
    </message>
    <message>
        <source>Forget the cameras</source>
        <translation>Kameras vergessen</translation>
    </message>
    <message>
        <source>A flight along placed cameras, as numbered pictures</source>
        <translation>Ein Flug entlang aufgestellter Kameras, als nummerierte Bilder</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Flug</translation>
    </message>
    <message>
        <source>Flight (%1)</source>
        <translation>Flug (%1)</translation>
    </message>
    <message>
        <source>Write the flight</source>
        <translation>Flug schreiben</translation>
    </message>
    <message>
        <source>Frames from camera to camera</source>
        <translation>Bilder von Kamera zu Kamera</translation>
    </message>
    <message>
        <source>Folder for the frames</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take back: %1</source>
        <translation>Zurücknehmen: %1</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Surfaces, scans and outlines on and off, one by one</source>
        <translation>Flächen, Scans und Umrisse einzeln ein- und ausblenden</translation>
    </message>
    <message>
        <source>difference to another surface</source>
        <translation>Unterschied zu einer anderen Fläche</translation>
    </message>
    <message>
        <source>Section line</source>
        <translation>Profillinie</translation>
    </message>
    <message>
        <source>Two clicks lay a line; what lies beside it is cut away</source>
        <translation>Zwei Klicks legen eine Linie; was daneben liegt, wird weggeschnitten</translation>
    </message>
    <message>
        <source>Drag to turn, right button to move, wheel to come nearer; a click says the place.</source>
        <translation>Ziehen dreht, rechte Taste schiebt, das Rad holt näher; ein Klick nennt die Stelle.</translation>
    </message>
    <message>
        <source>No point is there; come nearer, or click where points are drawn.</source>
        <translation>Dort ist kein Punkt; näher herangehen oder dorthin klicken, wo Punkte stehen.</translation>
    </message>
</context>
<context>
    <name>planum::gui::StartPage</name>
    <message>
        <source>No project is open</source>
        <translation>Kein Projekt offen</translation>
    </message>
    <message>
        <source>New project …</source>
        <translation>Neues Projekt …</translation>
    </message>
    <message>
        <source>One file for the whole dig; lists, scans and outlines come into it.</source>
        <translation>Eine Datei für die ganze Grabung; Listen, Scans und Umrisse kommen hinein.</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Or drop a project on the window.</source>
        <translation>Oder ein Projekt auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>Make a sample dig …</source>
        <translation>Beispielgrabung anlegen …</translation>
    </message>
    <message>
        <source>To try everything out: sheets, scans and a few mistakes to find.</source>
        <translation>Zum Ausprobieren: Bögen, Scans und einige Fehler, die zu finden sind.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>planum::gui::SuggestionListModel</name>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>recorded already</source>
        <translation>schon aufgenommen</translation>
    </message>
    <message>
        <source>Asking the surfaces</source>
        <translation>Flächen befragen</translation>
    </message>
    <message>
        <source>nothing proposed</source>
        <translation>nichts vorgeschlagen</translation>
    </message>
    <message numerus="yes">
        <source>%n relation(s) proposed</source>
        <translation>
            <numerusform>%n Beziehung vorgeschlagen</numerusform>
            <numerusform>%n Beziehungen vorgeschlagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s)</source>
        <translation>
            <numerusform>%n Frage</numerusform>
            <numerusform>%n Fragen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2: which is later?</source>
        <translation>%1 und %2: was ist jünger?</translation>
    </message>
    <message>
        <source>area %1 m²</source>
        <translation>Fläche %1 m²</translation>
    </message>
    <message>
        <source>thickness %1 m</source>
        <translation>Mächtigkeit %1 m</translation>
    </message>
    <message>
        <source>sure to %1 %</source>
        <translation>zu %1 % sicher</translation>
    </message>
    <message>
        <source>seen on %1</source>
        <translation>gesehen auf %1</translation>
    </message>
    <message>
        <source>not known to have touched</source>
        <translation>Berührung nicht nachgewiesen</translation>
    </message>
    <message>
        <source>Accepting a suggestion</source>
        <translation>Vorschlag annehmen</translation>
    </message>
    <message>
        <source>recorded from surfaces: %1</source>
        <translation>aus Flächen aufgenommen: %1</translation>
    </message>
    <message>
        <source>Rejecting a suggestion</source>
        <translation>Vorschlag ablehnen</translation>
    </message>
    <message>
        <source>cannot tell from the surfaces</source>
        <translation>aus den Flächen nicht zu sagen</translation>
    </message>
    <message>
        <source>Compiling a reading</source>
        <translation>Lesart zusammenstellen</translation>
    </message>
    <message>
        <source>reading %1: %2 relations from surfaces</source>
        <translation>Lesart %1: %2 Beziehungen aus Flächen</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::SuggestionPanel</name>
    <message>
        <source>All as a reading …</source>
        <translation>Alle als Lesart …</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>decided ones too</source>
        <translation>auch entschiedene</translation>
    </message>
    <message>
        <source>All proposed relations as a reading of their own beside the record</source>
        <translation>Alle vorgeschlagenen Beziehungen als eigene Lesart neben der Aufnahme</translation>
    </message>
    <message>
        <source>asking the surfaces …</source>
        <translation>befragt die Flächen …</translation>
    </message>
    <message>
        <source>State the relation</source>
        <translation>Beziehung angeben</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Reject …</source>
        <translation>Ablehnen …</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Cannot tell</source>
        <translation>Nicht zu sagen</translation>
    </message>
    <message>
        <source>Choose a suggestion: its units show in every view.</source>
        <translation>Einen Vorschlag wählen: seine Befunde erscheinen in allen Ansichten.</translation>
    </message>
    <message>
        <source>Said nothing, or less than all</source>
        <translation>Sagten nichts oder nicht alles</translation>
    </message>
    <message>
        <source>Compile a reading</source>
        <translation>Lesart zusammenstellen</translation>
    </message>
    <message>
        <source>Name of the reading, beside the record</source>
        <translation>Name der Lesart, neben der Aufnahme</translation>
    </message>
</context>
<context>
    <name>planum::gui::TimeLine</name>
    <message>
        <source>Surfaces in time</source>
        <translation>Flächen in der Zeit</translation>
    </message>
</context>
<context>
    <name>planum::gui::TimeModel</name>
    <message>
        <source>%1 scans, %2 outlines</source>
        <translation>%1 Scans, %2 Umrisse</translation>
    </message>
</context>
<context>
    <name>planum::gui::TodayModel</name>
    <message>
        <source>Looking what is next</source>
        <translation>Nachsehen, was ansteht</translation>
    </message>
    <message>
        <source>%1 lacks %2</source>
        <translation>%1: es fehlt %2</translation>
    </message>
</context>
<context>
    <name>planum::gui::TodayPanel</name>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>May be dug next</source>
        <translation>Kann als Nächstes gegraben werden</translation>
    </message>
    <message>
        <source>Sheets that lack something</source>
        <translation>Unvollständige Bögen</translation>
    </message>
</context>
<context>
    <name>planum::gui::ToolsMenu</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Verify the project</source>
        <translation>Projekt prüfen</translation>
    </message>
    <message>
        <source>Compare readings …</source>
        <translation>Lesarten vergleichen …</translation>
    </message>
    <message>
        <source>Ground not outlined yet</source>
        <translation>Noch nicht umrissener Boden</translation>
    </message>
    <message>
        <source>Compare registrations …</source>
        <translation>Registrierungen vergleichen …</translation>
    </message>
    <message>
        <source>Accept a registration …</source>
        <translation>Registrierung annehmen …</translation>
    </message>
    <message>
        <source>Accept a registration</source>
        <translation>Registrierung annehmen</translation>
    </message>
    <message>
        <source>Discard a registration …</source>
        <translation>Registrierung verwerfen …</translation>
    </message>
    <message>
        <source>Discard a registration</source>
        <translation>Registrierung verwerfen</translation>
    </message>
    <message>
        <source>There is no reading beside the record to compare it with.</source>
        <translation>Neben der Aufnahme gibt es keine Lesart zum Vergleichen.</translation>
    </message>
    <message>
        <source>Compare readings</source>
        <translation>Lesarten vergleichen</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesart</translation>
    </message>
    <message>
        <source>with</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>There are no two registrations to compare.</source>
        <translation>Es gibt keine zwei Registrierungen zum Vergleichen.</translation>
    </message>
    <message>
        <source>Compare registrations</source>
        <translation>Registrierungen vergleichen</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>There is no registration yet.</source>
        <translation>Es gibt noch keine Registrierung.</translation>
    </message>
    <message>
        <source>Save as outlines …</source>
        <translation>Als Umrisse sichern …</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Verify and clean up …</source>
        <translation>Prüfen und aufräumen …</translation>
    </message>
    <message>
        <source>Points of a region …</source>
        <translation>Punkte eines Umrisses …</translation>
    </message>
    <message>
        <source>Verify and clean up</source>
        <translation>Prüfen und aufräumen</translation>
    </message>
    <message>
        <source>Kept points, pictures and heights that nothing uses any more are removed. The record, the scans themselves and all that can be taken back stay as they are.</source>
        <translation>Aufbewahrte Punkte, Bilder und Höhen, die nichts mehr braucht, werden entfernt. Die Aufnahme, die Scans selbst und alles, was rückgängig gemacht werden kann, bleiben wie sie sind.</translation>
    </message>
    <message>
        <source>Clean up</source>
        <translation>Aufräumen</translation>
    </message>
    <message>
        <source>There is no outline yet.</source>
        <translation>Es gibt noch keinen Umriss.</translation>
    </message>
    <message>
        <source>Points of a region</source>
        <translation>Punkte eines Umrisses</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>Punkte von %1</translation>
    </message>
    <message>
        <source>Points (*.ply)</source>
        <translation>Punkte (*.ply)</translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitCardModel</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datierung</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Unterlage</translation>
    </message>
    <message>
        <source>Change unit %1</source>
        <translation>Befund %1 ändern</translation>
    </message>
    <message>
        <source>Add unit %1</source>
        <translation>Befund %1 anlegen</translation>
    </message>
    <message>
        <source>Delete unit %1</source>
        <translation>Befund %1 löschen</translation>
    </message>
    <message>
        <source>Reading what was changed</source>
        <translation>Lesen, was geändert wurde</translation>
    </message>
    <message>
        <source>“%1”  %2</source>
        <translation>„%1“  %2</translation>
    </message>
    <message>
        <source>%1: “%2” → “%3”</source>
        <translation>%1: „%2“ → „%3“</translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitListModel</name>
    <message>
        <source>unit %1, %2, %3</source>
        <translation>Befund %1, %2, %3</translation>
    </message>
    <message>
        <source>(no sheet yet)</source>
        <translation>(noch kein Bogen)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Short definition</source>
        <translation>Ansprache</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Stand</translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitPanel</name>
    <message>
        <source>with problems</source>
        <translation>mit Problemen</translation>
    </message>
    <message>
        <source>Find a number or a word</source>
        <translation>Nummer oder Wort suchen</translation>
    </message>
    <message>
        <source>Find a unit</source>
        <translation>Befund suchen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Trench</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>any kind</source>
        <translation>jede Art</translation>
    </message>
    <message>
        <source>kind not known</source>
        <translation>Art unbekannt</translation>
    </message>
    <message>
        <source>any status</source>
        <translation>jeder Stand</translation>
    </message>
    <message>
        <source>all trenches</source>
        <translation>alle Schnitte</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 Befunde</translation>
    </message>
    <message>
        <source>%1 of %2 units</source>
        <translation>%1 von %2 Befunden</translation>
    </message>
</context>
<context>
    <name>planum::gui::Workspace</name>
    <message>
        <source>opened for reading only</source>
        <translation>nur zum Lesen geöffnet</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>%1 anlegen</translation>
    </message>
    <message>
        <source>this file may only be read: %1</source>
        <translation>diese Datei darf nur gelesen werden: %1</translation>
    </message>
    <message>
        <source>Nothing was changed: %1.</source>
        <translation>Nichts wurde geändert: %1.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>%1 is gone. What you see was read before; put the file back, or save a copy elsewhere.</source>
        <translation>%1 ist verschwunden. Was Sie sehen, wurde vorher gelesen; die Datei zurücklegen oder eine Kopie anderswo sichern.</translation>
    </message>
    <message>
        <source>Another program changed the project; it was read again.</source>
        <translation>Ein anderes Programm hat das Projekt geändert; es wurde neu gelesen.</translation>
    </message>
    <message>
        <source>Reading the project again</source>
        <translation>Projekt neu lesen</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Zurückgenommen: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>Another window has this project open, too. What either saves, the other shows at once.</source>
        <translation>Ein anderes Fenster hat dieses Projekt auch geöffnet. Was das eine sichert, zeigt das andere sofort.</translation>
    </message>
</context>
<context>
    <name>print</name>
    <message>
        <source>Print the matrix</source>
        <translation>Matrix drucken</translation>
    </message>
</context>
<context>
    <name>reason</name>
    <message>
        <source>Reason, for those who read it in ten years</source>
        <translation>Begründung, für die, die es in zehn Jahren lesen</translation>
    </message>
</context>
<context>
    <name>records</name>
    <message>
        <source>Trenches</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Datierungen</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Unterlagen</translation>
    </message>
    <message>
        <source>Finds</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lesarten</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Nivellements</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Adds</source>
        <translation>Fügt hinzu</translation>
    </message>
    <message>
        <source>Trench</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Association</source>
        <translation>Zusammenhang</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Box or bag</source>
        <translation>Kiste oder Tüte</translation>
    </message>
    <message>
        <source>Radiocarbon age [BP]</source>
        <translation>Radiokohlenstoffalter [BP]</translation>
    </message>
    <message>
        <source>σ of the age [years]</source>
        <translation>σ des Alters [Jahre]</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Kategorie</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Leaves out</source>
        <translation>Lässt weg</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>First unit number</source>
        <translation>Erste Befundnummer</translation>
    </message>
    <message>
        <source>Found on</source>
        <translation>Gefunden am</translation>
    </message>
    <message>
        <source>From [year]</source>
        <translation>Von [Jahr]</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <source>Laboratory number</source>
        <translation>Labornummer</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Letzter Tag</translation>
    </message>
    <message>
        <source>Last unit number</source>
        <translation>Letzte Befundnummer</translation>
    </message>
    <message>
        <source>Made on</source>
        <translation>Gemacht am</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Place in time</source>
        <translation>Platz in der Zeit</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Part of</source>
        <translation>Teil von</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Rank (1 = earliest)</source>
        <translation>Rang (1 = frühester)</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Seen in the side of</source>
        <translation>Zu sehen in der Wand von</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Zeigt</translation>
    </message>
    <message>
        <source>σ [m]</source>
        <translation>σ [m]</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>To [year]</source>
        <translation>Bis [Jahr]</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Volume [l]</source>
        <translation>Volumen [l]</translation>
    </message>
    <message>
        <source>Weight [g]</source>
        <translation>Gewicht [g]</translation>
    </message>
    <message>
        <source>Height [m]</source>
        <translation>Höhe [m]</translation>
    </message>
    <message>
        <source>trench</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datierung</translation>
    </message>
    <message>
        <source>document</source>
        <translation>Unterlage</translation>
    </message>
    <message>
        <source>find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesart</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Nivellement</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>name of the trench</source>
        <translation>Name des Schnitts</translation>
    </message>
    <message>
        <source>label of the date</source>
        <translation>Bezeichnung der Datierung</translation>
    </message>
    <message>
        <source>number of the document</source>
        <translation>Nummer der Unterlage</translation>
    </message>
    <message>
        <source>number of the find</source>
        <translation>Nummer des Funds</translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation>Nummer der Gruppe</translation>
    </message>
    <message>
        <source>name of the reading</source>
        <translation>Name der Lesart</translation>
    </message>
    <message>
        <source>unit that was levelled</source>
        <translation>nivellierter Befund</translation>
    </message>
    <message>
        <source>number of the period</source>
        <translation>Nummer der Periode</translation>
    </message>
    <message>
        <source>number of the phase</source>
        <translation>Nummer der Phase</translation>
    </message>
    <message>
        <source>surface/unit</source>
        <translation>Fläche/Befund</translation>
    </message>
    <message>
        <source>number of the sample</source>
        <translation>Nummer der Probe</translation>
    </message>
    <message>
        <source>name of the surface</source>
        <translation>Name der Fläche</translation>
    </message>
    <message>
        <source>analysed</source>
        <translation>ausgewertet</translation>
    </message>
    <message>
        <source>terminus ante quem</source>
        <translation>Terminus ante quem</translation>
    </message>
    <message>
        <source>backfill</source>
        <translation>Wiederverfüllung</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Unterkante</translation>
    </message>
    <message>
        <source>baulk</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>charcoal</source>
        <translation>Holzkohle</translation>
    </message>
    <message>
        <source>coin</source>
        <translation>Münze</translation>
    </message>
    <message>
        <source>bare cut</source>
        <translation>leerer Eingriff</translation>
    </message>
    <message>
        <source>discarded</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>equipment</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>level inside it</source>
        <translation>Planum in ihm</translation>
    </message>
    <message>
        <source>dug by machine</source>
        <translation>mit dem Bagger gegraben</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>nothing of it</source>
        <translation>nichts davon</translation>
    </message>
    <message>
        <source>other</source>
        <translation>sonstige</translation>
    </message>
    <message>
        <source>dug too deep</source>
        <translation>zu tief gegraben</translation>
    </message>
    <message>
        <source>photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>in plana</source>
        <translation>nach Plana</translation>
    </message>
    <message>
        <source>pollen</source>
        <translation>Pollen</translation>
    </message>
    <message>
        <source>terminus post quem</source>
        <translation>Terminus post quem</translation>
    </message>
    <message>
        <source>radiocarbon</source>
        <translation>Radiokohlenstoff</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>slump</source>
        <translation>Nachsturz</translation>
    </message>
    <message>
        <source>soil</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>spoil</source>
        <translation>Abraum</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>eingelagert</translation>
    </message>
    <message>
        <source>by stratigraphic units</source>
        <translation>nach Schichten</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>eingereicht</translation>
    </message>
    <message>
        <source>top</source>
        <translation>Oberkante</translation>
    </message>
    <message>
        <source>date of the unit itself</source>
        <translation>Datierung des Befunds selbst</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>not excavated yet</source>
        <translation>noch nicht gegraben</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>bottom of the cut</source>
        <translation>Sohle des Eingriffs</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>%1 covers %2</source>
        <translation>%1 überlagert %2</translation>
    </message>
    <message>
        <source>%1 cuts %2</source>
        <translation>%1 schneidet %2</translation>
    </message>
    <message>
        <source>%1 fills %2</source>
        <translation>%1 verfüllt %2</translation>
    </message>
    <message>
        <source>%1 abuts %2</source>
        <translation>%1 zieht gegen %2</translation>
    </message>
    <message>
        <source>%1 bonds with %2</source>
        <translation>%1 ist im Verband mit %2</translation>
    </message>
    <message>
        <source>%1 is the same as %2</source>
        <translation>%1 ist identisch mit %2</translation>
    </message>
    <message>
        <source>%1 borders %2</source>
        <translation>%1 grenzt an %2</translation>
    </message>
    <message>
        <source>%1 is later than %2</source>
        <translation>%1 ist jünger als %2</translation>
    </message>
    <message>
        <source>%1 is contemporary with %2</source>
        <translation>%1 ist gleichzeitig mit %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 and %2 steps more</source>
        <translation>%1 und %2 weitere Schritte</translation>
    </message>
    <message>
        <source>%1 BCE</source>
        <translation>%1 v. Chr.</translation>
    </message>
    <message>
        <source>%1 CE</source>
        <translation>%1 n. Chr.</translation>
    </message>
    <message>
        <source>terminus post quem</source>
        <translation>Terminus post quem</translation>
    </message>
    <message>
        <source>terminus ante quem</source>
        <translation>Terminus ante quem</translation>
    </message>
    <message>
        <source>terminus post quem %1</source>
        <translation>Terminus post quem %1</translation>
    </message>
    <message>
        <source>terminus ante quem %1</source>
        <translation>Terminus ante quem %1</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>Phase %1</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>Periode %1</translation>
    </message>
    <message>
        <source>phase %1 of period %2</source>
        <translation>Phase %1 der Periode %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1 (ab %2)</translation>
    </message>
    <message>
        <source>%1 (until %2)</source>
        <translation>%1 (bis %2)</translation>
    </message>
    <message>
        <source>%1 (%2 for %3?)</source>
        <translation>%1 (%2 statt %3?)</translation>
    </message>
    <message>
        <source>%1 (two units under one number?)</source>
        <translation>%1 (zwei Befunde unter einer Nummer?)</translation>
    </message>
    <message>
        <source>%1 units lie above one another in a circle: %2</source>
        <translation>%1 Befunde liegen im Kreis übereinander: %2</translation>
    </message>
    <message>
        <source>%1 units lie above one another in a circle once same-as is applied: %2</source>
        <translation>%1 Befunde liegen im Kreis übereinander, sobald die Gleichsetzungen gelten: %2</translation>
    </message>
    <message>
        <source>%1; nothing in the record tells which of these is wrong</source>
        <translation>%1; nichts in der Aufnahme sagt, was davon falsch ist</translation>
    </message>
    <message>
        <source>%1; most suspect: %2</source>
        <translation>%1; am verdächtigsten: %2</translation>
    </message>
    <message>
        <source>%1, yet same-as makes the two one unit</source>
        <translation>%1, doch die Gleichsetzung macht beide zu einem Befund</translation>
    </message>
    <message>
        <source>without it the two are two units</source>
        <translation>ohne sie sind es zwei Befunde</translation>
    </message>
    <message>
        <source>a unit cannot lie above itself</source>
        <translation>ein Befund kann nicht über sich selbst liegen</translation>
    </message>
    <message>
        <source>in its favour: %1</source>
        <translation>dafür spricht: %1</translation>
    </message>
    <message>
        <source>every circle passes through %1, and no single relation breaks them all: probably two units under one number, to be split</source>
        <translation>jeder Kreis geht durch %1, und keine einzelne Beziehung bricht sie alle: wohl zwei Befunde unter einer Nummer, zu teilen</translation>
    </message>
    <message>
        <source>no circle is left when %1 and %2 are two units</source>
        <translation>kein Kreis bleibt, wenn %1 und %2 zwei Befunde sind</translation>
    </message>
    <message>
        <source>without it some circles are gone, but not all</source>
        <translation>ohne sie sind einige Kreise fort, aber nicht alle</translation>
    </message>
    <message>
        <source>without it no circle is left</source>
        <translation>ohne sie bleibt kein Kreis</translation>
    </message>
    <message>
        <source>it is one of %1 relations without which no circle is left</source>
        <translation>sie ist eine von %1 Beziehungen, ohne die kein Kreis bleibt</translation>
    </message>
    <message>
        <source>doubting it instead would do as well</source>
        <translation>an ihr statt dessen zu zweifeln täte es ebenso</translation>
    </message>
    <message>
        <source>doubting it instead would also break a circle</source>
        <translation>an ihr statt dessen zu zweifeln bräche auch einen Kreis</translation>
    </message>
    <message>
        <source>%1 is probably meant instead of %2: %3</source>
        <translation>gemeint ist wohl %1 statt %2: %3</translation>
    </message>
    <message>
        <source>the sheet of %1 states this relation with %2, whose own sheet names %3 instead</source>
        <translation>der Bogen von %1 nennt diese Beziehung zu %2, dessen eigener Bogen dafür %3 nennt</translation>
    </message>
    <message>
        <source>%1, one slip of the pen away, lies nearer to %2 and would close no circle</source>
        <translation>%1, nur einen Schreibfehler entfernt, liegt näher an %2 und schlösse keinen Kreis</translation>
    </message>
    <message>
        <source>both sheets state it</source>
        <translation>beide Bögen nennen sie</translation>
    </message>
    <message>
        <source>only one of the two sheets states it, where most relations stand on both</source>
        <translation>nur einer der beiden Bögen nennt sie, wo die meisten auf beiden stehen</translation>
    </message>
    <message>
        <source>only one of the two sheets states it</source>
        <translation>nur einer der beiden Bögen nennt sie</translation>
    </message>
    <message>
        <source>the upper unit was dug first</source>
        <translation>der obere Befund wurde zuerst ausgegraben</translation>
    </message>
    <message>
        <source>the lower unit was dug before the upper one</source>
        <translation>der untere Befund wurde vor dem oberen ausgegraben</translation>
    </message>
    <message>
        <source>numbers of this site grow downwards as a rule, here it is the other way round</source>
        <translation>die Nummern wachsen auf diesem Platz in der Regel nach unten, hier umgekehrt</translation>
    </message>
    <message>
        <source>the numbers follow each other as on the rest of the site</source>
        <translation>die Nummern folgen einander wie sonst auf dem Platz</translation>
    </message>
    <message>
        <source>the levels lie the other way round than between such units as a rule</source>
        <translation>die Nivellements liegen umgekehrt als sonst zwischen solchen Befunden</translation>
    </message>
    <message>
        <source>the levels lie as they should</source>
        <translation>die Nivellements liegen, wie sie sollen</translation>
    </message>
    <message>
        <source>the two units lie far apart in plan</source>
        <translation>die beiden Befunde liegen im Plan weit auseinander</translation>
    </message>
    <message>
        <source>the two units lie close together in plan</source>
        <translation>die beiden Befunde liegen im Plan nah beieinander</translation>
    </message>
    <message>
        <source>the two numbers are further apart than those of units that touch as a rule</source>
        <translation>die beiden Nummern liegen weiter auseinander als sonst bei Befunden, die sich berühren</translation>
    </message>
    <message>
        <source>the two numbers are close together</source>
        <translation>die beiden Nummern liegen nah beieinander</translation>
    </message>
    <message>
        <source>a cut or fill is hard to see the wrong way round</source>
        <translation>ein Eingriff oder eine Verfüllung ist schwer verkehrt herum zu sehen</translation>
    </message>
    <message>
        <source>which of two deposits leans on the other is easily mistaken</source>
        <translation>welche von zwei Schichten an die andere zieht, ist leicht verwechselt</translation>
    </message>
    <message>
        <source>leaning and age alone are weaker observations than covering</source>
        <translation>Anziehen und bloßes Alter sind schwächere Beobachtungen als Überlagern</translation>
    </message>
    <message>
        <source>it is marked as uncertain</source>
        <translation>sie ist als unsicher bezeichnet</translation>
    </message>
    <message>
        <source>the kinds of the two units do not fit it</source>
        <translation>die Arten der beiden Befunde passen nicht dazu</translation>
    </message>
    <message>
        <source>the levels of the two units exclude it</source>
        <translation>die Nivellements der beiden Befunde schließen sie aus</translation>
    </message>
    <message>
        <source>the levels of the two units confirm it</source>
        <translation>die Nivellements der beiden Befunde bestätigen sie</translation>
    </message>
    <message>
        <source>the dates of the two units exclude it</source>
        <translation>die Datierungen der beiden Befunde schließen sie aus</translation>
    </message>
    <message>
        <source>the dates of the two units agree with it</source>
        <translation>die Datierungen der beiden Befunde stimmen damit überein</translation>
    </message>
    <message>
        <source>the phases of the two units exclude it</source>
        <translation>die Phasen der beiden Befunde schließen sie aus</translation>
    </message>
    <message>
        <source>the phases of the two units agree with it</source>
        <translation>die Phasen der beiden Befunde stimmen damit überein</translation>
    </message>
    <message>
        <source>the recorded surfaces show it</source>
        <translation>die aufgenommenen Flächen zeigen es so</translation>
    </message>
    <message>
        <source>the recorded surfaces show the opposite</source>
        <translation>die aufgenommenen Flächen zeigen das Gegenteil</translation>
    </message>
    <message>
        <source>another sheet, one slip of the pen away, states what this one seems to mean</source>
        <translation>ein anderer Bogen, nur einen Schreibfehler entfernt, nennt, was dieser zu meinen scheint</translation>
    </message>
    <message>
        <source>it is a correlation across a gap, not one unit seen twice</source>
        <translation>sie ist eine Gleichsetzung über eine Lücke hinweg, kein zweimal gesehener Befund</translation>
    </message>
    <message>
        <source>the two units lie in different areas</source>
        <translation>die beiden Befunde liegen in verschiedenen Schnitten</translation>
    </message>
    <message>
        <source>the two units are of different kinds</source>
        <translation>die beiden Befunde sind von verschiedener Art</translation>
    </message>
    <message>
        <source>the dates of the two units exclude each other</source>
        <translation>die Datierungen der beiden Befunde schließen einander aus</translation>
    </message>
    <message>
        <source>%1: a unit cannot lie above itself; probably another number was meant</source>
        <translation>%1: ein Befund kann nicht über sich selbst liegen; gemeint war wohl eine andere Nummer</translation>
    </message>
    <message>
        <source>%1, and %2: one of the two is wrong</source>
        <translation>%1, und %2: eines von beiden ist falsch</translation>
    </message>
    <message>
        <source>%1, yet %2 puts one after the other</source>
        <translation>%1, doch %2 setzt den einen nach dem anderen</translation>
    </message>
    <message>
        <source>%1: one contact stated as two kinds; the order is the same</source>
        <translation>%1: ein Kontakt in zwei Arten genannt; die Folge ist dieselbe</translation>
    </message>
    <message>
        <source>%1 is written twice on one sheet (lines %2 and %3)</source>
        <translation>%1 steht zweimal auf einem Bogen (Zeilen %2 und %3)</translation>
    </message>
    <message>
        <source>%1 follows from other relations; it is kept as evidence and left out of the drawing</source>
        <translation>%1 folgt aus anderen Beziehungen; es bleibt als Beleg erhalten und fehlt nur in der Zeichnung</translation>
    </message>
    <message>
        <source>%1 relations follow from others; they are kept as evidence and left out of the drawing</source>
        <translation>%1 Beziehungen folgen aus anderen; sie bleiben als Beleg erhalten und fehlen nur in der Zeichnung</translation>
    </message>
    <message>
        <source>%1: its base at %2 lies %3 above its top at %4</source>
        <translation>%1: seine Unterkante bei %2 liegt %3 über seiner Oberkante bei %4</translation>
    </message>
    <message>
        <source>%1, measured at the same place</source>
        <translation>%1, an derselben Stelle gemessen</translation>
    </message>
    <message>
        <source>%1, but the %2 of %3 (%4) is %5 higher than the %6 of %7 (%8)</source>
        <translation>%1, aber %2 von %3 (%4) liegt %5 höher als %6 von %7 (%8)</translation>
    </message>
    <message>
        <source>%1, but the %2 of %3 (%4) is %5 lower than the %6 of %7 (%8)</source>
        <translation>%1, aber %2 von %3 (%4) liegt %5 tiefer als %6 von %7 (%8)</translation>
    </message>
    <message>
        <source>highest level on top</source>
        <translation>der höchste Punkt der Oberkante</translation>
    </message>
    <message>
        <source>lowest level at the base</source>
        <translation>der tiefste Punkt der Unterkante</translation>
    </message>
    <message>
        <source>deepest level</source>
        <translation>der tiefste Punkt</translation>
    </message>
    <message>
        <source>find %1 is recorded in %2, which is a cut and can hold nothing; it belongs to a fill</source>
        <translation>Fund %1 ist unter %2 aufgenommen, einem Eingriff, der nichts enthalten kann; er gehört in eine Verfüllung</translation>
    </message>
    <message>
        <source>find %1 at %2 lies %3 above the top of %4 (%5)</source>
        <translation>Fund %1 bei %2 liegt %3 über der Oberkante von %4 (%5)</translation>
    </message>
    <message>
        <source>find %1 at %2 lies %3 below the base of %4 (%5)</source>
        <translation>Fund %1 bei %2 liegt %3 unter der Unterkante von %4 (%5)</translation>
    </message>
    <message>
        <source>%1, but in the section %2 lies on %3 along %4 m: the relation is the wrong way round, or an outline carries the wrong number</source>
        <translation>%1, aber im Profil liegt %2 auf %4 m Länge auf %3: die Beziehung ist verkehrt herum, oder ein Umriss trägt die falsche Nummer</translation>
    </message>
    <message>
        <source>%1, but over %2 m² %3 lay above %4, which came out %5 m lower: the relation is the wrong way round, or an outline carries the wrong number, or %6 was dug before %7</source>
        <translation>%1, aber auf %2 m² lag %3 über %4, das %5 m tiefer zutage kam: die Beziehung ist verkehrt herum, oder ein Umriss trägt die falsche Nummer, oder %6 wurde vor %7 ausgegraben</translation>
    </message>
    <message>
        <source>levels do not decide it</source>
        <translation>die Nivellements entscheiden es nicht</translation>
    </message>
    <message>
        <source>levels agree, which proves nothing for a cut or a fill</source>
        <translation>die Nivellements stimmen, was bei Eingriff oder Verfüllung nichts beweist</translation>
    </message>
    <message>
        <source>no levels of one of the units</source>
        <translation>kein Nivellement von einem der Befunde</translation>
    </message>
    <message>
        <source>no levels of either unit</source>
        <translation>kein Nivellement von beiden Befunden</translation>
    </message>
    <message>
        <source>abutting says nothing about heights</source>
        <translation>Anziehen sagt nichts über Höhen</translation>
    </message>
    <message>
        <source>stated in time only</source>
        <translation>nur der Zeit nach genannt</translation>
    </message>
    <message>
        <source>the levels of one unit contradict themselves</source>
        <translation>die Nivellements eines Befundes widersprechen sich</translation>
    </message>
    <message>
        <source>the find may be intrusive, or the relation wrong</source>
        <translation>der Fund kann verlagert sein, oder die Beziehung ist falsch</translation>
    </message>
    <message>
        <source>the sample may be intrusive, or the relation wrong</source>
        <translation>die Probe kann verlagert sein, oder die Beziehung ist falsch</translation>
    </message>
    <message>
        <source>one of the dates or the relation is wrong</source>
        <translation>eine der Datierungen oder die Beziehung ist falsch</translation>
    </message>
    <message>
        <source>%1, but %2 is not later than %3 (%4) and %5 not earlier than %6 (%7): %8</source>
        <translation>%1, aber %2 ist nicht jünger als %3 (%4) und %5 nicht älter als %6 (%7): %8</translation>
    </message>
    <message>
        <source>%1 holds dates that exclude each other: not earlier than %2 (%3), not later than %4 (%5); %6</source>
        <translation>%1 hat Datierungen, die einander ausschließen: nicht älter als %2 (%3), nicht jünger als %4 (%5); %6</translation>
    </message>
    <message>
        <source>%1, but %2 belongs to %3 and %4 to %5, which is later</source>
        <translation>%1, aber %2 gehört zu %3 und %4 zu %5, das jünger ist</translation>
    </message>
    <message>
        <source>%1, but %2 was dug out on %3, before %4 was dug on %5: the relation, a date or the sequence of digging is wrong</source>
        <translation>%1, aber %2 wurde am %3 ausgegraben, bevor %4 am %5 an die Reihe kam: die Beziehung, ein Datum oder die Reihenfolge des Grabens ist falsch</translation>
    </message>
    <message>
        <source>%1, but %2</source>
        <translation>%1, aber %2</translation>
    </message>
    <message>
        <source>%1 is recorded as %2</source>
        <translation>%1 ist aufgenommen als %2</translation>
    </message>
    <message>
        <source>%1 is recorded as %2 and %3 as %4</source>
        <translation>%1 ist aufgenommen als %2 und %3 als %4</translation>
    </message>
    <message>
        <source>%1; only a cut or a feature cuts</source>
        <translation>%1; nur ein Eingriff oder ein Komplex schneidet</translation>
    </message>
    <message>
        <source>%1; a cut fills nothing</source>
        <translation>%1; ein Eingriff verfüllt nichts</translation>
    </message>
    <message>
        <source>%1; only cuts, features and structures are filled</source>
        <translation>%1; verfüllt werden nur Eingriffe, Komplexe und Strukturen</translation>
    </message>
    <message>
        <source>%1; only what was built bonds</source>
        <translation>%1; im Verband steht nur Gebautes</translation>
    </message>
    <message>
        <source>%1; a cut has no body that could lie or lean on anything</source>
        <translation>%1; ein Eingriff hat keinen Körper, der auf etwas liegen oder daran ziehen könnte</translation>
    </message>
    <message>
        <source>deposit</source>
        <translation>Ablagerung</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>Komplex</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>interface</source>
        <translation>Grenzfläche</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>Anstehendes</translation>
    </message>
    <message>
        <source>void</source>
        <translation>Leerraum</translation>
    </message>
    <message>
        <source>%1 is a fill, but no cut is named that it fills</source>
        <translation>%1 ist eine Verfüllung, aber kein Eingriff ist genannt, den sie verfüllt</translation>
    </message>
    <message>
        <source>%1 is a cut, but nothing is recorded that fills it</source>
        <translation>%1 ist ein Eingriff, aber nichts ist aufgenommen, das ihn verfüllt</translation>
    </message>
    <message>
        <source>%1 is a cut, but nothing is recorded that it cuts</source>
        <translation>%1 ist ein Eingriff, aber nichts ist aufgenommen, das er schneidet</translation>
    </message>
    <message>
        <source>%1, but %2 is natural ground; nothing made by people lies below it unless it was moved</source>
        <translation>%1, aber %2 ist Anstehendes; darunter liegt nichts von Menschen Gemachtes, wenn es nicht verlagert ist</translation>
    </message>
    <message>
        <source>number %1 is given to %2 units (%3), though numbers are unique on this site</source>
        <translation>Nummer %1 ist an %2 Befunde vergeben (%3), obwohl Nummern auf diesem Platz einmalig sind</translation>
    </message>
    <message>
        <source>%1 stands in area %2, whose numbers run from %3 to %4</source>
        <translation>%1 liegt in Schnitt %2, dessen Nummern von %3 bis %4 gehen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 relations stand on one of the two sheets only, among them: %4</source>
        <translation>%1: %2 von %3 Beziehungen stehen nur auf einem der beiden Bögen, darunter: %4</translation>
    </message>
    <message>
        <source>%1 is named in a relation (%2) but has no sheet of its own</source>
        <translation>%1 ist in einer Beziehung genannt (%2), hat aber keinen eigenen Bogen</translation>
    </message>
    <message>
        <source>%1: the %2 of %3 is %4 here and was %5 before; the first is kept</source>
        <translation>%1: %2 von %3 ist hier %4 und war vorher %5; das erste bleibt</translation>
    </message>
    <message>
        <source>%1 stands in no order to any other unit</source>
        <translation>%1 steht in keiner Folge zu einem anderen Befund</translation>
    </message>
    <message>
        <source>%1 units stand in no order to any other unit, among them %2</source>
        <translation>%1 Befunde stehen in keiner Folge zu einem anderen Befund, darunter %2</translation>
    </message>
    <message>
        <source>%1 scans are placed poorly, among them %2</source>
        <translation>%1 Scans liegen nur ungenau, darunter %2</translation>
    </message>
    <message>
        <source>%1 units are named in relations but have no sheet of their own, among them %2</source>
        <translation>%1 Befunde sind in Beziehungen genannt, haben aber keinen eigenen Bogen, darunter %2</translation>
    </message>
    <message>
        <source>%1 stands where it does only to %2 mm and %3 degrees: %4</source>
        <translation>%1 liegt nur auf %2 mm und %3 Grad genau: %4</translation>
    </message>
    <message>
        <source>the run says no more</source>
        <translation>der Lauf sagt nicht mehr</translation>
    </message>
    <message>
        <source>%1 patches of ground on which scans of one surface disagree, among them %2</source>
        <translation>%1 Stellen, an denen Scans einer Fläche einander widersprechen, darunter %2</translation>
    </message>
    <message>
        <source>%1, but over %2 m² the bare cut %3 came out where %4 had been, %5 m lower: %6, or %7 cuts %8 from beside</source>
        <translation>%1, doch auf %2 m² lag der Eingriff %3 frei, wo %4 gewesen war, %5 m tiefer: %6, oder %7 schneidet %8 von der Seite</translation>
    </message>
    <message>
        <source>%1 patches of ground rose, among them %2</source>
        <translation>%1 Stellen, an denen der Boden höher liegt als zuvor, darunter %2</translation>
    </message>
    <message>
        <source>ground without a unit</source>
        <translation>Boden ohne Befund</translation>
    </message>
    <message>
        <source>on %1 scans disagree over %2 m² of %3 near %4 at %5 to %6 m: %7 shows it %8 m higher than %9; it changed between the two, or one of them is misplaced</source>
        <translation>Am %1 widersprechen sich Scans auf %2 m² von %3 bei %4 in %5 bis %6 m Höhe: %7 zeigt den Boden %8 m höher als %9; er hat sich dazwischen geändert, oder einer der beiden liegt falsch</translation>
    </message>
    <message>
        <source>on %1 %2 m² of %3 near %4 at %5 to %6 m lay %7 m higher than on %8: heaped up, filled in, or a scan is misplaced; nothing is concluded there until it is below its former height</source>
        <translation>Am %1 lagen %2 m² von %3 bei %4 in %5 bis %6 m Höhe %7 m höher als am %8: aufgeschüttet, verfüllt, oder ein Scan liegt falsch; dort wird nichts geschlossen, bis der Boden unter seiner früheren Höhe liegt</translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation>am %1 lagen %2 von %3 frei, wo am %5 %4 gewesen war, %6 tiefer</translation>
    </message>
    <message>
        <source>on %1 %2 of the cut %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation>am %1 lagen %2 des Eingriffs %3 frei, wo am %5 %4 gewesen war, %6 tiefer</translation>
    </message>
    <message>
        <source>the cut %1 was empty on %2; on %3 %4 of %5 lay %6 below its bottom</source>
        <translation>der Eingriff %1 war am %2 leer; am %3 lagen %4 von %5 %6 unter seiner Sohle</translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay bare where %4 had been on %5, too little lower for the heights to tell</source>
        <translation>am %1 lagen %2 von %3 frei, wo am %5 %4 gewesen war, zu wenig tiefer, als dass die Höhen es sagten</translation>
    </message>
    <message>
        <source>from %1 to %2 the line between %3 and %4 moved into %5 over %6 while the ground went down %7: %8 dips flat under %9</source>
        <translation>vom %1 zum %2 rückte die Grenze zwischen %3 und %4 um %6 in %5 vor, während der Boden um %7 tiefer kam: %8 fällt flach unter %9 ein</translation>
    </message>
    <message>
        <source>where %1 was on %2, %3 of %4 came out on %5, %6 lower</source>
        <translation>wo am %2 %1 war, kamen am %5 %3 von %4 zutage, %6 tiefer</translation>
    </message>
    <message>
        <source>%1 lies inside %2 and became smaller by %3 from %4 to %5, %6 lower</source>
        <translation>%1 liegt in %2 und wurde vom %4 zum %5 um %3 kleiner, %6 tiefer</translation>
    </message>
    <message>
        <source>on %1 %2 of the natural ground %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation>am %1 lagen %2 des Anstehenden %3 frei, wo am %5 %4 gewesen war, %6 tiefer</translation>
    </message>
    <message>
        <source>%1 first showed on %2, in %3 where %4 had been on %5: was it covered by %6, or was it there already and seen too late? Look at the section</source>
        <translation>%1 zeigte sich zuerst am %2, auf %3, wo am %5 %4 gewesen war: lag %6 darüber, oder war es schon da und wurde zu spät gesehen? Ein Blick ins Profil hilft</translation>
    </message>
    <message>
        <source>%1 grew into %2 by %3 from %4 to %5: is it covered by %6, or undercut into it? Look at the section</source>
        <translation>%1 wuchs vom %4 zum %5 um %3 in %2 hinein: liegt %6 darüber, oder ist es hineinunterschnitten? Ein Blick ins Profil hilft</translation>
    </message>
    <message>
        <source>on %1 %2 of %3 came out where %4 had been on %5, and one of the two is built: which was there first?</source>
        <translation>am %1 kamen %2 von %3 zutage, wo am %5 %4 gewesen war, und eines von beiden ist gebaut: was war zuerst da?</translation>
    </message>
    <message>
        <source>on %1 %2 of the cut %3 lay below where %4 had been on %5: did %6 lie in or over it, or was it the roof of a hollow that reaches under it?</source>
        <translation>am %1 lagen %2 des Eingriffs %3 unter der Stelle, wo am %5 %4 gewesen war: lag %6 darin oder darüber, oder war es die Decke eines Hohlraums, der darunter reicht?</translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay where %4 had been on %5, but only along the outlines: did they touch there?</source>
        <translation>am %1 lagen %2 von %3, wo am %5 %4 gewesen war, aber nur entlang der Umrisse: berührten sie sich dort?</translation>
    </message>
    <message>
        <source>%1; the record puts %2 above %3: one of the two is wrong</source>
        <translation>%1; die Aufnahme setzt %2 über %3: eines von beiden ist falsch</translation>
    </message>
    <message>
        <source>%1 January %2</source>
        <translation>%1. Januar %2</translation>
    </message>
    <message>
        <source>%1 February %2</source>
        <translation>%1. Februar %2</translation>
    </message>
    <message>
        <source>%1 March %2</source>
        <translation>%1. März %2</translation>
    </message>
    <message>
        <source>%1 April %2</source>
        <translation>%1. April %2</translation>
    </message>
    <message>
        <source>%1 May %2</source>
        <translation>%1. Mai %2</translation>
    </message>
    <message>
        <source>%1 June %2</source>
        <translation>%1. Juni %2</translation>
    </message>
    <message>
        <source>%1 July %2</source>
        <translation>%1. Juli %2</translation>
    </message>
    <message>
        <source>%1 August %2</source>
        <translation>%1. August %2</translation>
    </message>
    <message>
        <source>%1 September %2</source>
        <translation>%1. September %2</translation>
    </message>
    <message>
        <source>%1 October %2</source>
        <translation>%1. Oktober %2</translation>
    </message>
    <message>
        <source>%1 November %2</source>
        <translation>%1. November %2</translation>
    </message>
    <message>
        <source>%1 December %2</source>
        <translation>%1. Dezember %2</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>the ground came up by %1 m: spoil, backfill, a slump or something put down</source>
        <translation>der Boden kam um %1 m höher: Aushub, Verfüllung, Rutschung oder etwas Abgestelltes</translation>
    </message>
    <message>
        <source>no unit was outlined here before, so the record says nothing of what lies below</source>
        <translation>hier war vorher kein Befund umrissen, so sagt die Aufnahme nicht, was darunter liegt</translation>
    </message>
    <message>
        <source>%1 is outlined beside it and goes on without a step along %2 % of its edge</source>
        <translation>%1 ist daneben umrissen und geht an %2 % des Randes ohne Stufe weiter</translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it that goes on beside it without a step</source>
        <translation>%1 wurde hier abgegraben, und %2 ist der einzige darunter aufgenommene Befund, der daneben ohne Stufe weitergeht</translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it that was not outlined yet</source>
        <translation>%1 wurde hier abgegraben, und %2 ist der einzige darunter aufgenommene Befund, der noch nicht umrissen war</translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it</source>
        <translation>%1 wurde hier abgegraben, und %2 ist der einzige darunter aufgenommene Befund</translation>
    </message>
    <message>
        <source>%1 was dug away here; the record has no unit below it</source>
        <translation>%1 wurde hier abgegraben; die Aufnahme hat keinen Befund darunter</translation>
    </message>
    <message>
        <source>%1 was dug away here; recorded below it are %2</source>
        <translation>%1 wurde hier abgegraben; darunter aufgenommen sind %2</translation>
    </message>
    <message>
        <source>%1 scans are not on the site grid, among them %2</source>
        <translation>%1 Scans liegen nicht im Grabungsnetz, darunter %2</translation>
    </message>
    <message>
        <source>%1 is not on the site grid, so nothing can be concluded from it; Register in the list of scans says why</source>
        <translation>%1 liegt nicht im Grabungsnetz, also folgt nichts daraus; Einpassen in der Liste der Scans sagt, warum</translation>
    </message>
    <message>
        <source>%1; the record has %2 above %3 and %4 above %5: one of the two is wrong</source>
        <translation>%1; die Aufnahme hat %2 über %3 und %4 über %5: eines von beiden ist falsch</translation>
    </message>
    <message>
        <source>the outline of %1 on %2 near %3 %4 reaches %5 away from all set-ups of the scanner: plans leave it out and nothing is concluded from it; is it in other coordinates than the site?</source>
        <translation>der Umriss von %1 am %2 bei %3 %4 reicht %5 weg von allen Standpunkten des Scanners: Pläne lassen ihn aus, und aus ihm wird nichts geschlossen; liegt er in anderen Koordinaten als die Grabung?</translation>
    </message>
    <message>
        <source>%1 and %2 both claim %3 m² near %4 %5: neither gets that ground, and nothing is concluded from it until one of the outlines is redrawn</source>
        <translation>%1 und %2 beanspruchen beide %3 m² bei %4 %5: keiner bekommt diesen Boden, und aus ihm wird nichts geschlossen, bis einer der Umrisse neu gezeichnet ist</translation>
    </message>
    <message>
        <source>surface %1 of %2 stands before %3 of %4 in the order of surfaces, though its day is later: nothing is concluded from either until they are put in their order (Finds and lists › Surfaces › Place in time)</source>
        <translation>die Fläche %1 vom %2 steht in der Folge der Flächen vor %3 vom %4, obwohl ihr Tag später ist: aus beiden wird nichts geschlossen, bis sie in ihrer Folge stehen (Funde und Listen › Flächen › Platz in der Zeit)</translation>
    </message>
    <message>
        <source>%1: one of %2 relations stands on one of the two sheets only: %3</source>
        <translation>%1: eine von %2 Beziehungen steht nur auf einem der beiden Bögen: %3</translation>
    </message>
</context>
<context>
    <name>services</name>
    <message>
        <source>no such file; Project › New project makes one</source>
        <translation>die Datei gibt es nicht; Projekt › Neues Projekt legt eine an</translation>
    </message>
    <message>
        <source>not a Planum project</source>
        <translation>kein Planum-Projekt</translation>
    </message>
    <message>
        <source>no area %1</source>
        <translation>Schnitt %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no scan %1</source>
        <translation>Scan %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no surface %1</source>
        <translation>Fläche %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no region %1</source>
        <translation>Umriss %1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 has no field %2</source>
        <translation>%1 hat kein Feld %2</translation>
    </message>
    <message>
        <source>%1 %2 exists already; choose it in the list to change it</source>
        <translation>%1 %2 gibt es schon; zum Ändern in der Liste wählen</translation>
    </message>
    <message>
        <source>an outline is drawn: on the panorama, in plan or on a section</source>
        <translation>ein Umriss wird gezeichnet: auf dem Panorama, im Plan oder auf einem Profil</translation>
    </message>
    <message>
        <source>a problem is kept silent with a reason only</source>
        <translation>ein Problem wird nur mit Begründung stillgestellt</translation>
    </message>
    <message>
        <source>this problem is not open any more; the list was checked again meanwhile</source>
        <translation>dieses Problem ist nicht mehr offen; die Liste wurde inzwischen neu geprüft</translation>
    </message>
    <message>
        <source>this problem is not in the list any more</source>
        <translation>dieses Problem steht nicht mehr in der Liste</translation>
    </message>
    <message>
        <source>this suggestion is not open any more</source>
        <translation>dieser Vorschlag ist nicht mehr offen</translation>
    </message>
    <message>
        <source>%1 is a question; state the relation that you saw, or reject it</source>
        <translation>%1 ist eine Frage; die gesehene Beziehung angeben oder ablehnen</translation>
    </message>
    <message>
        <source>a suggestion is rejected with a reason only</source>
        <translation>ein Vorschlag wird nur mit Begründung abgelehnt</translation>
    </message>
    <message>
        <source>there is a reading %1 already; choose another name, or delete it in Finds and lists</source>
        <translation>die Lesart %1 gibt es schon; einen anderen Namen wählen oder sie unter Funde und Listen löschen</translation>
    </message>
    <message>
        <source>of which day? Put it into a folder named by its date (2025-06-01) and add that</source>
        <translation>von welchem Tag? In einen Ordner legen, der nach dem Tag heißt (2025-06-01), und diesen aufnehmen</translation>
    </message>
    <message>
        <source>the project has another scan %1 with other content; rename the file or put it into the folder of another day</source>
        <translation>das Projekt hat schon einen anderen Scan %1 mit anderem Inhalt; die Datei umbenennen oder in den Ordner eines anderen Tages legen</translation>
    </message>
    <message>
        <source>scan %1 has no %2; range and shading can always be drawn</source>
        <translation>Scan %1 hat keine Werte für %2; Entfernung und Schattierung gehen immer</translation>
    </message>
    <message>
        <source>scan %1: %2 is no longer the file that was added; put that back</source>
        <translation>Scan %1: %2 ist nicht mehr die Datei, die aufgenommen wurde; diese zurücklegen</translation>
    </message>
    <message>
        <source>%1 is no longer the file that was added; put that back</source>
        <translation>%1 ist nicht mehr die Datei, die aufgenommen wurde; diese zurücklegen</translation>
    </message>
    <message>
        <source>block %1 with %2 points is damaged; Tools › Verify the project makes it again from the original scan</source>
        <translation>Block %1 mit %2 Punkten ist beschädigt; Werkzeuge › Projekt prüfen erzeugt ihn aus der Originaldatei neu</translation>
    </message>
    <message>
        <source>this is LAZ, compressed LAS, which is not read here; unpack it to LAS first</source>
        <translation>das ist LAZ, gepacktes LAS, das hier nicht gelesen wird; erst zu LAS entpacken</translation>
    </message>
    <message>
        <source>marker %1 of %2 is %3 mm from where the file has it; it was kept</source>
        <translation>Passmarke %1 von %2 liegt %3 mm neben der der Datei; sie blieb</translation>
    </message>
    <message>
        <source>the project&apos;s markers cannot be read: take the change back that spoilt them (Edit › Undo)</source>
        <translation>die Passmarken des Projekts lassen sich nicht lesen: die Änderung zurücknehmen, die sie verdorben hat (Bearbeiten › Rückgängig)</translation>
    </message>
    <message>
        <source>the project has no scans yet: Add scans takes the folder of a day</source>
        <translation>das Projekt hat noch keine Scans: Scans aufnehmen nimmt den Ordner eines Tages</translation>
    </message>
    <message>
        <source>every scan is on the site grid already</source>
        <translation>alle Scans liegen schon im Grabungsnetz</translation>
    </message>
    <message>
        <source>nothing says where the site grid is: import the markers of one scan at least (Markers)</source>
        <translation>nichts sagt, wo das Grabungsnetz liegt: wenigstens die Passmarken eines Scans einlesen (Passmarken)</translation>
    </message>
    <message>
        <source>there is no registration yet: Register places the scans</source>
        <translation>es gibt noch keine Registrierung: Einpassen passt die Scans ein</translation>
    </message>
    <message>
        <source>the registration %2 is not in force: %1; Tools › Accept a registration puts it in force, Discard a registration drops it</source>
        <translation>die Registrierung %2 gilt noch nicht: %1; Werkzeuge › Registrierung annehmen setzt sie in Kraft, Registrierung verwerfen lässt sie fallen</translation>
    </message>
    <message>
        <source>surface %1: none of its scans stands on the site grid; Register in the list of scans places them</source>
        <translation>Fläche %1: keiner ihrer Scans liegt im Grabungsnetz; Einpassen in der Liste der Scans holt das nach</translation>
    </message>
    <message>
        <source>the project has no surface yet; scans or outlines of a day make them</source>
        <translation>das Projekt hat noch keine Fläche; Scans oder Umrisse eines Tages legen sie an</translation>
    </message>
    <message>
        <source>neither outlines nor registered scans say where the trench is</source>
        <translation>weder Umrisse noch eingepasste Scans sagen, wo der Schnitt liegt</translation>
    </message>
    <message>
        <source>it names neither a surface nor a day</source>
        <translation>es nennt weder Fläche noch Tag</translation>
    </message>
    <message>
        <source>no scan is on the site grid: register the scans first</source>
        <translation>kein Scan liegt im Grabungsnetz: erst die Scans einpassen</translation>
    </message>
    <message>
        <source>no scan of this surface is on the site grid: register its scans first</source>
        <translation>kein Scan dieser Fläche liegt im Grabungsnetz: erst ihre Scans einpassen</translation>
    </message>
    <message>
        <source>not recognised: none of the lists that Planum reads (%1)</source>
        <translation>nicht erkannt: keine der Listen, die Planum liest (%1)</translation>
    </message>
    <message>
        <source>read as %1 (%2)%3</source>
        <translation>gelesen als %1 (%2)%3</translation>
    </message>
    <message>
        <source>left out: too large for a list; scans are added with Add scans</source>
        <translation>ausgelassen: zu groß für eine Liste; Scans kommen über Scans aufnehmen dazu</translation>
    </message>
    <message>
        <source>number %1 is used in area %2 and in area %3 and was taken for one unit</source>
        <translation>Nummer %1 kommt in Schnitt %2 und in Schnitt %3 vor und gilt als ein Befund</translation>
    </message>
    <message>
        <source>site %1 with %2 units was read; left out: %3</source>
        <translation>Fundplatz %1 mit %2 Befunden wurde gelesen; ausgelassen: %3</translation>
    </message>
    <message>
        <source>none of its rows holds coordinates; its first line must name the columns (name, x, y, z, code, …)</source>
        <translation>keine ihrer Zeilen enthält Koordinaten; die erste Zeile muss die Spalten nennen (name, x, y, z, code, …)</translation>
    </message>
    <message>
        <source>%1 trenches have a unit %2; the file must say which (TRENCH::NUMBER)</source>
        <translation>%1 Schnitte haben einen Befund %2; die Datei muss angeben, welchen (SCHNITT::NUMMER)</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>not an ordinary file</source>
        <translation>keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>empty; a marker file begins with scan,marker,x,y,z</source>
        <translation>leer; eine Datei mit Passmarken beginnt mit scan,marker,x,y,z</translation>
    </message>
    <message>
        <source>a database, but not a GeoPackage and so not a Planum project</source>
        <translation>eine Datenbank, aber kein GeoPackage und so kein Planum-Projekt</translation>
    </message>
    <message>
        <source>a GeoPackage, but not a Planum project</source>
        <translation>ein GeoPackage, aber kein Planum-Projekt</translation>
    </message>
    <message>
        <source>made with schema version %1, this program knows up to %2: install a newer Planum</source>
        <translation>mit einem neueren Planum angelegt (Schema %1, dieses Programm kennt bis %2): ein neueres Planum installieren</translation>
    </message>
    <message>
        <source>the table %1 is missing: not a whole Planum project</source>
        <translation>die Tabelle %1 fehlt: kein vollständiges Planum-Projekt</translation>
    </message>
    <message>
        <source>the table %1 has no column %2: another program rebuilt it; restore a backup</source>
        <translation>der Tabelle %1 fehlt die Spalte %2: ein anderes Programm hat sie umgebaut; eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the table %1 was rebuilt by another program</source>
        <translation>die Tabelle %1 hat ein anderes Programm umgebaut</translation>
    </message>
    <message>
        <source>the project has no schema version</source>
        <translation>dem Projekt fehlt die Angabe seiner Version</translation>
    </message>
    <message>
        <source>the project has no settings: restore a backup</source>
        <translation>dem Projekt fehlen seine Einstellungen: eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is damaged (%1): restore a backup</source>
        <translation>die Datei ist beschädigt (%1): eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is damaged: restore a backup</source>
        <translation>die Datei ist beschädigt: eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is damaged or cut short: restore a backup</source>
        <translation>die Datei ist beschädigt oder abgeschnitten: eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is cut short: restore a backup</source>
        <translation>die Datei ist abgeschnitten: eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is cut short (%1 of %2 bytes): restore a backup</source>
        <translation>die Datei ist abgeschnitten (%1 von %2 Byte): eine Sicherung zurückholen</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation>die Datei oder ihr Ordner ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the file or its folder cannot be written: check the permissions</source>
        <translation>die Datei oder ihr Ordner lässt sich nicht schreiben: die Rechte prüfen</translation>
    </message>
    <message>
        <source>the disk is full: nothing was changed; free some space and try again</source>
        <translation>die Platte ist voll: nichts wurde geändert; Platz schaffen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>in use by another program: close it there and try again</source>
        <translation>von einem anderen Programm belegt: dort schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>an interrupted change has to be taken back first, and the file or its folder cannot be written: copy it with the files beside it to a place that can</source>
        <translation>erst muss eine unterbrochene Änderung zurückgenommen werden, und die Datei oder ihr Ordner lässt sich nicht schreiben: mit den Dateien daneben an einen beschreibbaren Ort kopieren</translation>
    </message>
    <message>
        <source>cannot be opened: check the name, the folder and the permissions</source>
        <translation>lässt sich nicht öffnen: Namen, Ordner und Rechte prüfen</translation>
    </message>
    <message>
        <source>cannot be opened: check the permissions</source>
        <translation>lässt sich nicht öffnen: die Rechte prüfen</translation>
    </message>
    <message>
        <source>cannot be opened for reading</source>
        <translation>lässt sich nicht zum Lesen öffnen</translation>
    </message>
    <message>
        <source>access denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>a value is larger than 64 MB</source>
        <translation>ein Wert ist größer als 64 MB</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>zu wenig Arbeitsspeicher</translation>
    </message>
    <message>
        <source>another program changed the tables meanwhile: try again</source>
        <translation>ein anderes Programm hat die Tabellen inzwischen geändert: noch einmal versuchen</translation>
    </message>
    <message>
        <source>the record of this change is damaged</source>
        <translation>das Protokoll dieser Änderung ist beschädigt</translation>
    </message>
    <message>
        <source>the record of this change is missing</source>
        <translation>das Protokoll dieser Änderung fehlt</translation>
    </message>
    <message>
        <source>the record of this change names a table it may not</source>
        <translation>das Protokoll dieser Änderung nennt eine Tabelle, die es nicht nennen darf</translation>
    </message>
    <message>
        <source>the name of a project must end in .gpkg</source>
        <translation>der Name eines Projekts muss auf .gpkg enden</translation>
    </message>
    <message>
        <source>a file of this name is there already</source>
        <translation>eine Datei dieses Namens gibt es schon</translation>
    </message>
    <message>
        <source>opened for reading only</source>
        <translation>nur zum Lesen geöffnet</translation>
    </message>
    <message>
        <source>may be read but not written, because %1: import it into a new project</source>
        <translation>darf gelesen, aber nicht geschrieben werden, denn %1: in ein neues Projekt importieren</translation>
    </message>
    <message>
        <source>the %1 %2 was not made by Planum</source>
        <translation>%1 %2 stammt nicht von Planum</translation>
    </message>
    <message>
        <source>the index %1 was not made by Planum</source>
        <translation>der Index %1 stammt nicht von Planum</translation>
    </message>
    <message>
        <source>a change that had been interrupted was taken back</source>
        <translation>eine unterbrochene Änderung wurde zurückgenommen</translation>
    </message>
    <message>
        <source>another program left the file in write-ahead mode (is it open in QGIS?)</source>
        <translation>ein anderes Programm hat die Datei im Write-Ahead-Modus gelassen (ist sie in QGIS offen?)</translation>
    </message>
    <message>
        <source>the file had been left in write-ahead mode; it was set back</source>
        <translation>die Datei war im Write-Ahead-Modus geblieben; das wurde zurückgestellt</translation>
    </message>
    <message>
        <source>the file stays in write-ahead mode while another program uses it (is it open in QGIS?)</source>
        <translation>die Datei bleibt im Write-Ahead-Modus, solange ein anderes Programm sie benutzt (ist sie in QGIS offen?)</translation>
    </message>
    <message>
        <source>brought from schema version %1 to %2</source>
        <translation>von Schema %1 auf %2 gebracht</translation>
    </message>
    <message>
        <source>the spatial index of the layer %1 was dropped: its triggers cannot run safely; QGIS works without it</source>
        <translation>der räumliche Index der Ebene %1 wurde entfernt, weil er nicht sicher laufen kann; QGIS arbeitet auch ohne ihn</translation>
    </message>
    <message>
        <source>%1 had been dropped by another program; it was put back</source>
        <translation>%1 hatte ein anderes Programm entfernt; es wurde wieder angelegt</translation>
    </message>
    <message>
        <source>rows of the table %1 that were added since refer to the %2 it would take away: delete them first</source>
        <translation>seither angelegte Einträge der Tabelle %1 hängen an %2, was damit fortfiele: diese erst löschen</translation>
    </message>
    <message>
        <source>%1 was changed since by another program; nothing was done</source>
        <translation>%1 wurde seither von einem anderen Programm geändert; nichts ist geschehen</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; of %3 is no longer possible: undo steps up to then were forgotten</source>
        <translation>%1 „%2“ von %3 geht nicht mehr: die Schritte bis dahin sind vergessen</translation>
    </message>
    <message>
        <source>there is nothing to take back</source>
        <translation>es gibt nichts zurückzunehmen</translation>
    </message>
    <message>
        <source>there is nothing to make again</source>
        <translation>es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>number already used</source>
        <translation>die Nummer ist schon vergeben</translation>
    </message>
    <message>
        <source>number already used in area %1</source>
        <translation>die Nummer ist in Schnitt %1 schon vergeben</translation>
    </message>
    <message>
        <source>it refers to a record that does not exist</source>
        <translation>es verweist auf etwas, das es nicht gibt</translation>
    </message>
    <message>
        <source>a value is not allowed (%1)</source>
        <translation>ein Wert ist nicht erlaubt (%1)</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 darf nicht leer sein</translation>
    </message>
    <message>
        <source>a record with this id is there already</source>
        <translation>einen Eintrag mit dieser Kennung gibt es schon</translation>
    </message>
    <message>
        <source>one of this name is there already</source>
        <translation>eins dieses Namens gibt es schon</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>no field of a unit is called %1</source>
        <translation>kein Feld eines Befunds heißt %1</translation>
    </message>
    <message>
        <source>no coordinate system EPSG:%1 is known; use -1 for a local grid</source>
        <translation>kein Koordinatensystem EPSG:%1 bekannt; -1 steht für ein örtliches Netz</translation>
    </message>
    <message>
        <source>%1 is no EPSG code; use -1 for a local grid</source>
        <translation>%1 ist kein EPSG-Code; -1 steht für ein örtliches Netz</translation>
    </message>
    <message>
        <source>%1 MB, more than the %2 MB that such a file may have</source>
        <translation>%1 MB, mehr als die %2 MB, die eine solche Datei haben darf</translation>
    </message>
    <message>
        <source>is a project or another database; name another file to write</source>
        <translation>ist ein Projekt oder eine andere Datenbank; eine andere Datei nennen</translation>
    </message>
    <message>
        <source>a backup must be another file than the project</source>
        <translation>eine Sicherung muss eine andere Datei sein als das Projekt</translation>
    </message>
    <message>
        <source>cannot be opened to be written to the disk</source>
        <translation>lässt sich nicht öffnen, um es auf die Platte zu schreiben</translation>
    </message>
    <message>
        <source>writing to the disk failed</source>
        <translation>Schreiben auf die Platte schlug fehl</translation>
    </message>
    <message>
        <source>the copy is damaged: check the disk</source>
        <translation>die Kopie ist beschädigt: die Platte prüfen</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot be removed</source>
        <translation>lässt sich nicht entfernen</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>reading failed half-way</source>
        <translation>Lesen brach mittendrin ab</translation>
    </message>
    <message>
        <source>reading failed</source>
        <translation>Lesen schlug fehl</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>writing to disk</source>
        <translation>Schreiben auf die Platte</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf der Platte</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>schreibgeschützter Datenträger</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>kein Ordner</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei gibt es schon</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent erschöpft</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>vom Benutzer angehalten</translation>
    </message>
    <message>
        <source>is between units of which one was deleted</source>
        <translation>verbindet Befunde, von denen einer gelöscht ist</translation>
    </message>
    <message>
        <source>belongs to a relation that was deleted</source>
        <translation>gehört zu einer gelöschten Beziehung</translation>
    </message>
    <message>
        <source>belongs to a unit that was deleted</source>
        <translation>gehört zu einem gelöschten Befund</translation>
    </message>
    <message>
        <source>is a number that several units have</source>
        <translation>ist eine Nummer, die mehrere Befunde tragen</translation>
    </message>
    <message>
        <source>drops a relation that does not exist</source>
        <translation>lässt eine Beziehung weg, die es nicht gibt</translation>
    </message>
    <message>
        <source>is listed but does not exist</source>
        <translation>ist genannt, aber nicht vorhanden</translation>
    </message>
    <message>
        <source>refers to a %1 that does not exist</source>
        <translation>verweist auf %1, das es nicht gibt</translation>
    </message>
    <message>
        <source>has no valid uuid</source>
        <translation>hat keine gültige Kennung</translation>
    </message>
    <message>
        <source>cannot be taken back: %1</source>
        <translation>lässt sich nicht zurücknehmen: %1</translation>
    </message>
    <message>
        <source>no file to import</source>
        <translation>keine Datei zum Importieren</translation>
    </message>
    <message>
        <source>could also be read as %1 (%2)</source>
        <translation>ließe sich auch lesen als %1 (%2)</translation>
    </message>
    <message>
        <source>left out: no record that Planum knows</source>
        <translation>ausgelassen: keine Aufnahme, die Planum kennt</translation>
    </message>
    <message>
        <source>%1 of %2 relations stand on both sheets, the rest on one; the other side is derived</source>
        <translation>%1 von %2 Beziehungen stehen auf beiden Bögen, der Rest auf einem; die andere Seite wird abgeleitet</translation>
    </message>
    <message>
        <source>nothing in it but headings</source>
        <translation>nur Überschriften darin</translation>
    </message>
    <message>
        <source>%1 of the project stay behind: only its record is imported</source>
        <translation>%1 des Projekts bleiben zurück: importiert wird nur seine Aufnahme</translation>
    </message>
    <message>
        <source>Tables of units, relations, levels, finds, … (.csv)</source>
        <translation>Tabellen von Befunden, Beziehungen, Nivellements, Funden, … (.csv)</translation>
    </message>
    <message>
        <source>The whole record (.json)</source>
        <translation>die ganze Aufnahme (.json)</translation>
    </message>
    <message>
        <source>Harris Matrix Composer project (.hmcx, matrix.xml)</source>
        <translation>Projekt des Harris Matrix Composer (.hmcx, matrix.xml)</translation>
    </message>
    <message>
        <source>Harris Matrix Composer table (.csv)</source>
        <translation>Tabelle des Harris Matrix Composer (.csv)</translation>
    </message>
    <message>
        <source>ArkMatrix table, simple or tagged (.csv)</source>
        <translation>Tabelle von ArkMatrix, einfach oder mit Kennwörtern (.csv)</translation>
    </message>
    <message>
        <source>BASP, ArchEd, Stratify dataset (.lst)</source>
        <translation>Datensatz von BASP, ArchEd, Stratify (.lst)</translation>
    </message>
    <message>
        <source>GraphML of yEd or the Extended Matrix (.graphml)</source>
        <translation>GraphML von yEd oder der Extended Matrix (.graphml)</translation>
    </message>
    <message>
        <source>iDAI.field / Field Desktop export (.jsonl)</source>
        <translation>Ausgabe von iDAI.field / Field Desktop (.jsonl)</translation>
    </message>
    <message>
        <source>hm and HMDP tables (contexts, observations, …)</source>
        <translation>Tabellen von hm und HMDP (contexts, observations, …)</translation>
    </message>
    <message>
        <source>Transcription of excavation books (book, feature, relations)</source>
        <translation>Abschrift von Grabungstagebüchern (book, feature, relations)</translation>
    </message>
    <message>
        <source>PHASER tables (.csv)</source>
        <translation>Tabellen von PHASER (.csv)</translation>
    </message>
    <message>
        <source>PHASER graph (.json)</source>
        <translation>Graph von PHASER (.json)</translation>
    </message>
    <message>
        <source>PolyChron tables (.csv)</source>
        <translation>Tabellen von PolyChron (.csv)</translation>
    </message>
    <message>
        <source>Stratify table (.csv)</source>
        <translation>Tabelle von Stratify (.csv)</translation>
    </message>
    <message>
        <source>StratiGraph matrix (.hmatrix.json)</source>
        <translation>Matrix von StratiGraph (.hmatrix.json)</translation>
    </message>
    <message>
        <source>stratigraphr table (context, above, below, equal)</source>
        <translation>Tabelle von stratigraphr (context, above, below, equal)</translation>
    </message>
    <message>
        <source>pyArchInit database or CSV tables</source>
        <translation>Datenbank oder CSV-Tabellen von pyArchInit</translation>
    </message>
    <message>
        <source>columns unit, kind, title, … or unit, relation, other</source>
        <translation>Spalten unit, kind, title, … oder unit, relation, other</translation>
    </message>
    <message>
        <source>two columns of numbers without a header</source>
        <translation>zwei Spalten mit Nummern ohne Kopfzeile</translation>
    </message>
    <message>
        <source>rows of unit, value, tag</source>
        <translation>Zeilen aus unit, value, tag</translation>
    </message>
    <message>
        <source>columns above, below</source>
        <translation>Spalten above, below</translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation>%1; ausgelassen</translation>
    </message>
    <message>
        <source>%1; the line was left out</source>
        <translation>%1; die Zeile wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1 is %2 here and was %3 before; the first is kept</source>
        <translation>%1 ist hier %2 und war vorher %3; das erste bleibt</translation>
    </message>
    <message>
        <source>the title of %1</source>
        <translation>die Kurzansprache von %1</translation>
    </message>
    <message>
        <source>the description of %1</source>
        <translation>die Beschreibung von %1</translation>
    </message>
    <message>
        <source>the interpretation of %1</source>
        <translation>die Deutung von %1</translation>
    </message>
    <message>
        <source>the label of %1</source>
        <translation>die Bezeichnung von %1</translation>
    </message>
    <message>
        <source>the name of %1</source>
        <translation>der Name von %1</translation>
    </message>
    <message>
        <source>the phase of %1</source>
        <translation>die Phase von %1</translation>
    </message>
    <message>
        <source>the period of %1</source>
        <translation>die Periode von %1</translation>
    </message>
    <message>
        <source>the first day of %1</source>
        <translation>der erste Tag von %1</translation>
    </message>
    <message>
        <source>the last day of %1</source>
        <translation>der letzte Tag von %1</translation>
    </message>
    <message>
        <source>the recorder of %1</source>
        <translation>der Bearbeiter von %1</translation>
    </message>
    <message>
        <source>the recording day of %1</source>
        <translation>der Tag der Aufnahme von %1</translation>
    </message>
    <message>
        <source>%1 of %2 names no other unit; the relation was left out</source>
        <translation>%1 von %2 nennt keinen anderen Befund; die Beziehung wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1 further notes are not listed</source>
        <translation>%1 weitere Bemerkungen sind nicht aufgeführt</translation>
    </message>
    <message>
        <source>more than two cells; only two were read</source>
        <translation>mehr als zwei Zellen; nur zwei wurden gelesen</translation>
    </message>
    <message>
        <source>not three cells: unit, value, tag</source>
        <translation>keine drei Zellen: unit, value, tag</translation>
    </message>
    <message>
        <source>a line without a unit was left out</source>
        <translation>eine Zeile ohne Befund wurde ausgelassen</translation>
    </message>
    <message>
        <source>a line without a unit number was left out</source>
        <translation>eine Zeile ohne Befundnummer wurde ausgelassen</translation>
    </message>
    <message>
        <source>a line without a group was left out</source>
        <translation>eine Zeile ohne Gruppe wurde ausgelassen</translation>
    </message>
    <message>
        <source>a unit without a number was left out</source>
        <translation>ein Befund ohne Nummer wurde ausgelassen</translation>
    </message>
    <message>
        <source>a level without a height z was left out</source>
        <translation>ein Nivellement ohne Höhe z wurde ausgelassen</translation>
    </message>
    <message>
        <source>the tag %1 is not known</source>
        <translation>das Kennwort %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the class %1 is not known</source>
        <translation>die Klasse %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the class %1 is not known; taken as context</source>
        <translation>die Klasse %1 ist unbekannt; als Befund genommen</translation>
    </message>
    <message>
        <source>the status %1 is not known</source>
        <translation>der Stand %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the status %1 is not known; there are %2</source>
        <translation>der Stand %1 ist unbekannt; es gibt %2</translation>
    </message>
    <message>
        <source>the kind %1 is not known; kept as a free field</source>
        <translation>die Art %1 ist unbekannt; als freies Feld behalten</translation>
    </message>
    <message>
        <source>the form %1 is not known</source>
        <translation>die Form %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the role %1 is not known; taken as other</source>
        <translation>die Bedeutung %1 der Höhe ist unbekannt; als sonstige genommen</translation>
    </message>
    <message>
        <source>the method %1 is not known</source>
        <translation>das Verfahren %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the kind of dating %1 is not known</source>
        <translation>die Art der Datierung %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the key %1 is not known</source>
        <translation>das Stichwort %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the type %1 of %2 is not known</source>
        <translation>der Typ %1 von %2 ist unbekannt</translation>
    </message>
    <message>
        <source>the unit type %1 of %2 is not known</source>
        <translation>die Befundart %1 von %2 ist unbekannt</translation>
    </message>
    <message>
        <source>the edge type %1 is not known</source>
        <translation>die Art der Verbindung %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the relation %1 is not known</source>
        <translation>die Beziehung %1 ist unbekannt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no relation word known here</source>
        <translation>„%1“ ist hier kein bekanntes Wort für eine Beziehung</translation>
    </message>
    <message>
        <source>the field %1 is not known; kept among the free fields</source>
        <translation>das Feld %1 ist unbekannt; bei den freien Feldern behalten</translation>
    </message>
    <message>
        <source>the column %1 is not known; kept among the free fields</source>
        <translation>die Spalte %1 ist unbekannt; bei den freien Feldern behalten</translation>
    </message>
    <message>
        <source>the column %1 is not known</source>
        <translation>die Spalte %1 ist unbekannt</translation>
    </message>
    <message>
        <source>certainty is certain or uncertain, not %1; taken as certain</source>
        <translation>certainty ist certain oder uncertain, nicht %1; als sicher genommen</translation>
    </message>
    <message>
        <source>a level needs a unit and a height z</source>
        <translation>ein Nivellement braucht einen Befund und eine Höhe z</translation>
    </message>
    <message>
        <source>%1 is not a number in the column %2</source>
        <translation>%1 ist keine Zahl (Spalte %2)</translation>
    </message>
    <message>
        <source>%1 is not a whole number in the column %2</source>
        <translation>%1 ist keine ganze Zahl (Spalte %2)</translation>
    </message>
    <message>
        <source>%1 is not a date in the column %2 (2025-06-01)</source>
        <translation>%1 ist kein Tag (Spalte %2, geschrieben wie 2025-06-01)</translation>
    </message>
    <message>
        <source>no table of ours; looked in the first line for the columns %1</source>
        <translation>keine Tabelle von Planum; in der ersten Zeile gesucht: die Spalten %1</translation>
    </message>
    <message>
        <source>%1 characters are no text in %2 and were replaced</source>
        <translation>%1 Zeichen sind kein Text in %2 und wurden ersetzt</translation>
    </message>
    <message>
        <source>the table has more than %1 cells; what follows was not read</source>
        <translation>die Tabelle hat mehr als %1 Zellen; was folgt, wurde nicht gelesen</translation>
    </message>
    <message>
        <source>a quotation mark is opened and never closed; taken as a character</source>
        <translation>ein Anführungszeichen wird geöffnet und nie geschlossen; als Zeichen genommen</translation>
    </message>
    <message>
        <source>a node without label; named by its id, %1</source>
        <translation>ein Knoten ohne Beschriftung; nach seiner Kennung %1 benannt</translation>
    </message>
    <message>
        <source>two nodes are called %1; they are taken for one</source>
        <translation>zwei Knoten heißen %1; sie gelten als einer</translation>
    </message>
    <message>
        <source>an edge ends at a node that is not in the file</source>
        <translation>eine Verbindung endet an einem Knoten, der nicht in der Datei ist</translation>
    </message>
    <message>
        <source>an edge of a group was left out; only units have relations</source>
        <translation>die Verbindung einer Gruppe wurde ausgelassen; nur Befunde haben Beziehungen</translation>
    </message>
    <message>
        <source>a relation of a group was left out; only units have relations</source>
        <translation>die Beziehung einer Gruppe wurde ausgelassen; nur Befunde haben Beziehungen</translation>
    </message>
    <message>
        <source>a relation of a group of units was left out; only units have relations</source>
        <translation>die Beziehung einer Gruppe wurde ausgelassen; nur Befunde haben Beziehungen</translation>
    </message>
    <message>
        <source>a row without number of a unit</source>
        <translation>eine Zeile ohne Befundnummer</translation>
    </message>
    <message>
        <source>more than %1 units</source>
        <translation>mehr als %1 Befunde</translation>
    </message>
    <message>
        <source>more than %1 relations</source>
        <translation>mehr als %1 Beziehungen</translation>
    </message>
    <message>
        <source>binary, not %1</source>
        <translation>binär, nicht %1</translation>
    </message>
    <message>
        <source>unit %1: %2 is no number</source>
        <translation>Befund %1: %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>it holds no points</source>
        <translation>darin sind keine Punkte</translation>
    </message>
    <message>
        <source>columns %1: there is no x and y</source>
        <translation>Spalten %1: x und y fehlen</translation>
    </message>
    <message>
        <source>no coordinates; the row was left out</source>
        <translation>keine Koordinaten; die Zeile wurde ausgelassen</translation>
    </message>
    <message>
        <source>it is a binary drawing; save it as ASCII DXF</source>
        <translation>es ist eine binäre Zeichnung; als ASCII-DXF sichern</translation>
    </message>
    <message>
        <source>it holds no POINT, INSERT or TEXT</source>
        <translation>darin ist kein POINT, INSERT oder TEXT</translation>
    </message>
    <message>
        <source>a level without a height was left out</source>
        <translation>ein Nivellement ohne Höhe wurde ausgelassen</translation>
    </message>
    <message>
        <source>from here on, %1 levels without a height were left out</source>
        <translation>ab hier wurden %1 Nivellements ohne Höhe ausgelassen</translation>
    </message>
    <message>
        <source>%1: no unit %2; near it: %3</source>
        <translation>%1: Befund %2 gibt es nicht; ähnlich: %3</translation>
    </message>
    <message>
        <source>%1: no unit %2</source>
        <translation>%1: Befund %2 gibt es nicht</translation>
    </message>
    <message>
        <source>a level without a unit was left out</source>
        <translation>ein Nivellement ohne Befund wurde ausgelassen</translation>
    </message>
    <message>
        <source>a find without a number was left out</source>
        <translation>ein Fund ohne Nummer wurde ausgelassen</translation>
    </message>
    <message>
        <source>building the matrix</source>
        <translation>Matrix wird aufgebaut</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>looking for circles</source>
        <translation>Kreise suchen</translation>
    </message>
    <message>
        <source>comparing relations</source>
        <translation>Beziehungen vergleichen</translation>
    </message>
    <message>
        <source>comparing levels</source>
        <translation>Nivellements vergleichen</translation>
    </message>
    <message>
        <source>comparing dates</source>
        <translation>Datierungen vergleichen</translation>
    </message>
    <message>
        <source>comparing phases</source>
        <translation>Phasen vergleichen</translation>
    </message>
    <message>
        <source>following the digging</source>
        <translation>Dem Graben nachgehen</translation>
    </message>
    <message>
        <source>looking at kinds</source>
        <translation>Arten ansehen</translation>
    </message>
    <message>
        <source>looking at numbers</source>
        <translation>Nummern ansehen</translation>
    </message>
    <message>
        <source>looking at sources</source>
        <translation>Quellen ansehen</translation>
    </message>
    <message>
        <source>looking at scans</source>
        <translation>Scans ansehen</translation>
    </message>
    <message>
        <source>looking at outlines</source>
        <translation>Umrisse ansehen</translation>
    </message>
    <message>
        <source>looking at ground that changed</source>
        <translation>Geänderten Boden ansehen</translation>
    </message>
    <message>
        <source>counting redundant relations</source>
        <translation>Ableitbare Beziehungen zählen</translation>
    </message>
    <message>
        <source>checking pages</source>
        <translation>Seiten prüfen</translation>
    </message>
    <message>
        <source>checking references</source>
        <translation>Verweise prüfen</translation>
    </message>
    <message>
        <source>checking rules</source>
        <translation>Regeln prüfen</translation>
    </message>
    <message>
        <source>checking changes</source>
        <translation>Änderungen prüfen</translation>
    </message>
    <message>
        <source>checking %1 scans and their points</source>
        <translation>%1 Scans und ihre Punkte prüfen</translation>
    </message>
    <message>
        <source>reading the record</source>
        <translation>Aufnahme lesen</translation>
    </message>
    <message>
        <source>copying the project</source>
        <translation>Projekt kopieren</translation>
    </message>
    <message>
        <source>looking for features</source>
        <translation>Merkmale suchen</translation>
    </message>
    <message>
        <source>thinning %1</source>
        <translation>%1 ausdünnen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>writing the PDF</source>
        <translation>PDF schreiben</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>looking into %1</source>
        <translation>Blick in %1</translation>
    </message>
    <message>
        <source>looking at what %1 shows</source>
        <translation>Ansehen, was %1 zeigt</translation>
    </message>
    <message>
        <source>making the point store of %1 again</source>
        <translation>Punkte von %1 neu anlegen</translation>
    </message>
    <message>
        <source>unrolling %1</source>
        <translation>%1 abrollen</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>drawing the matrix</source>
        <translation>Matrix zeichnen</translation>
    </message>
    <message>
        <source>cleaning</source>
        <translation>Aufräumen</translation>
    </message>
    <message>
        <source>reading colours</source>
        <translation>Farben lesen</translation>
    </message>
    <message>
        <source>comparing %1</source>
        <translation>%1 vergleichen</translation>
    </message>
    <message>
        <source>comparing surfaces</source>
        <translation>Flächen vergleichen</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>%1 lesen</translation>
    </message>
    <message>
        <source>merging</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>importing the sheets</source>
        <translation>Bögen importieren</translation>
    </message>
    <message>
        <source>taking the outlines in</source>
        <translation>Umrisse aufnehmen</translation>
    </message>
    <message>
        <source>drawing and reporting</source>
        <translation>Zeichnen und berichten</translation>
    </message>
    <message>
        <source>letting a site come to be</source>
        <translation>Fundplatz entstehen lassen</translation>
    </message>
    <message>
        <source>looking at what touches what</source>
        <translation>Ansehen, was was berührt</translation>
    </message>
    <message>
        <source>digging it</source>
        <translation>Graben</translation>
    </message>
    <message>
        <source>drawing and writing sheets</source>
        <translation>Bögen zeichnen und schreiben</translation>
    </message>
    <message>
        <source>scanning %1</source>
        <translation>%1 scannen</translation>
    </message>
    <message>
        <source>looking for ground that changed</source>
        <translation>Geänderten Boden suchen</translation>
    </message>
    <message>
        <source>fine alignment</source>
        <translation>Feinausrichtung</translation>
    </message>
    <message>
        <source>relaxing all poses</source>
        <translation>Alle Lagen ausgleichen</translation>
    </message>
    <message>
        <source>global relaxation</source>
        <translation>Gesamtausgleich</translation>
    </message>
    <message>
        <source>sorting the points of %1</source>
        <translation>Punkte von %1 sortieren</translation>
    </message>
    <message>
        <source>reading points into cells</source>
        <translation>Punkte in Zellen lesen</translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation>Fläche berechnen</translation>
    </message>
    <message>
        <source>aligning %1 pairs of scans</source>
        <translation>%1 Paare von Scans ausrichten</translation>
    </message>
    <message>
        <source>registering %1 scans</source>
        <translation>%1 Scans einpassen</translation>
    </message>
    <message>
        <source>adding %1 scan files</source>
        <translation>%1 Scandateien aufnehmen</translation>
    </message>
    <message>
        <source>laying the matrix out with graphviz</source>
        <translation>Matrix mit Graphviz anordnen</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>dating</source>
        <translation>Datierung</translation>
    </message>
    <message>
        <source>document</source>
        <translation>Unterlage</translation>
    </message>
    <message>
        <source>find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>interpretation</source>
        <translation>Lesart</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Nivellement</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>relation</source>
        <translation>Beziehung</translation>
    </message>
    <message>
        <source>relation below</source>
        <translation>Beziehung nach unten</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1 is no day; write YYYY-MM-DD</source>
        <translation>%1 ist kein Tag; JJJJ-MM-TT schreiben</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <translation>%1 ist keins von %2</translation>
    </message>
    <message>
        <source>there is no %1; add it first</source>
        <translation>%1 gibt es nicht; erst anlegen</translation>
    </message>
    <message>
        <source>no area %1; add it first</source>
        <translation>Schnitt %1 gibt es nicht; erst anlegen</translation>
    </message>
    <message>
        <source>no dating %1</source>
        <translation>Datierung %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no document %1</source>
        <translation>Unterlage %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no find %1</source>
        <translation>Fund %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no group %1</source>
        <translation>Gruppe %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no interpretation %1</source>
        <translation>Lesart %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no level %1</source>
        <translation>Nivellement %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no period %1</source>
        <translation>Periode %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no phase %1</source>
        <translation>Phase %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no relation %1</source>
        <translation>Beziehung %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no sample %1</source>
        <translation>Probe %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no unit %1</source>
        <translation>Befund %1 gibt es nicht</translation>
    </message>
    <message>
        <source>no unit %1; near it: %2</source>
        <translation>Befund %1 gibt es nicht; ähnlich: %2</translation>
    </message>
    <message>
        <source>a %1 needs a name</source>
        <translation>%1: der Name fehlt</translation>
    </message>
    <message>
        <source>a unit needs a number</source>
        <translation>ein Befund braucht eine Nummer</translation>
    </message>
    <message>
        <source>a level needs a height</source>
        <translation>ein Nivellement braucht eine Höhe</translation>
    </message>
    <message>
        <source>unit %1 is used in %2 areas; say which: %3</source>
        <translation>Befund %1 gibt es in %2 Schnitten; angeben, welcher: %3</translation>
    </message>
    <message>
        <source>a relation is UNIT RELATION UNIT, as in 1042 cuts 1017, not %1</source>
        <translation>eine Beziehung ist BEFUND BEZIEHUNG BEFUND wie in 1042 schneidet 1017, nicht %1</translation>
    </message>
    <message>
        <source>%1 is no relation; known are %2</source>
        <translation>%1 ist keine Beziehung; bekannt sind %2</translation>
    </message>
    <message>
        <source>nothing in the record is called %1</source>
        <translation>nichts in der Aufnahme heißt %1</translation>
    </message>
    <message>
        <source>a correction needs a reason</source>
        <translation>eine Berichtigung braucht eine Begründung</translation>
    </message>
    <message>
        <source>that is the relation as it stands</source>
        <translation>so steht die Beziehung schon da</translation>
    </message>
    <message>
        <source>the relation is not in the record any more</source>
        <translation>die Beziehung steht nicht mehr in der Aufnahme</translation>
    </message>
    <message>
        <source>the unit is not in the record any more</source>
        <translation>den Befund gibt es in der Aufnahme nicht mehr</translation>
    </message>
    <message>
        <source>the new unit needs a number</source>
        <translation>der neue Befund braucht eine Nummer</translation>
    </message>
    <message>
        <source>%1 is no kind of unit</source>
        <translation>%1 ist keine Art von Befund</translation>
    </message>
    <message>
        <source>no relation %1 %2 %3 in what the interpretation is of</source>
        <translation>die Beziehung %1 %2 %3 gibt es nicht in dem, was die Lesart liest</translation>
    </message>
    <message>
        <source>there is no interpretation %1; add it first</source>
        <translation>die Lesart %1 gibt es nicht; erst anlegen</translation>
    </message>
    <message>
        <source>%1 is read from %2 itself</source>
        <translation>%1 geht selbst von %2 aus</translation>
    </message>
    <message>
        <source>interpretation %1: %2 starts from it; give that another parent or delete it first</source>
        <translation>Lesart %1: %2 geht von ihr aus; dieser erst einen anderen Ausgang geben oder sie löschen</translation>
    </message>
    <message>
        <source>metres, not below 0</source>
        <translation>in Metern, nicht unter 0</translation>
    </message>
    <message>
        <source>cannot read “%1”; write x y z, x y z, … or POLYGON((…))</source>
        <translation>„%1“ lässt sich nicht lesen; x y z, x y z, … oder POLYGON((…)) schreiben</translation>
    </message>
    <message>
        <source>name a new region SURFACE/UNIT</source>
        <translation>einen neuen Umriss FLÄCHE/BEFUND nennen</translation>
    </message>
    <message>
        <source>the region is no longer there</source>
        <translation>den Umriss gibt es nicht mehr</translation>
    </message>
    <message>
        <source>its outline was changed meanwhile; nothing was done</source>
        <translation>sein Umriss wurde inzwischen geändert; nichts ist geschehen</translation>
    </message>
    <message>
        <source>outline mended: %1</source>
        <translation>Umriss ausgebessert: %1</translation>
    </message>
    <message>
        <source>scans and outlines do not show this contradiction any more; check again</source>
        <translation>Scans und Umrisse zeigen diesen Widerspruch nicht mehr</translation>
    </message>
    <message>
        <source>no section shows this contradiction any more; check again</source>
        <translation>kein Profil zeigt diesen Widerspruch mehr</translation>
    </message>
    <message>
        <source>the surfaces propose nothing; outlines on two surfaces of an area with registered scans are needed</source>
        <translation>die Flächen schlagen nichts vor; es braucht Umrisse auf zwei Flächen eines Schnitts mit eingepassten Scans</translation>
    </message>
    <message>
        <source>name in full</source>
        <translation>ausgeschriebener Name</translation>
    </message>
    <message>
        <source>first year, negative = BCE</source>
        <translation>erstes Jahr, negativ = v. Chr.</translation>
    </message>
    <message>
        <source>last year, negative = BCE</source>
        <translation>letztes Jahr, negativ = v. Chr.</translation>
    </message>
    <message>
        <source>order in time, 1 = earliest</source>
        <translation>Folge in der Zeit, 1 = frühester</translation>
    </message>
    <message>
        <source>its period</source>
        <translation>seine Periode</translation>
    </message>
    <message>
        <source>group, subgroup, landuse, activity, …</source>
        <translation>Gruppe, Untergruppe, Nutzung, Tätigkeit, …</translation>
    </message>
    <message>
        <source>group it is part of</source>
        <translation>Gruppe, zu der sie gehört</translation>
    </message>
    <message>
        <source>its units, separated by commas</source>
        <translation>ihre Befunde, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>unit it dates</source>
        <translation>Befund, den sie datiert</translation>
    </message>
    <message>
        <source>kind of evidence</source>
        <translation>Art des Hinweises</translation>
    </message>
    <message>
        <source>earliest year, negative = BCE</source>
        <translation>frühestes Jahr, negativ = v. Chr.</translation>
    </message>
    <message>
        <source>latest year, negative = BCE</source>
        <translation>spätestes Jahr, negativ = v. Chr.</translation>
    </message>
    <message>
        <source>uncalibrated radiocarbon age [years BP]</source>
        <translation>unkalibriertes Radiokohlenstoffalter [Jahre BP]</translation>
    </message>
    <message>
        <source>its sigma [years]</source>
        <translation>sein Sigma [Jahre]</translation>
    </message>
    <message>
        <source>find it rests on</source>
        <translation>Fund, auf dem sie beruht</translation>
    </message>
    <message>
        <source>direct, disjunct, disparate</source>
        <translation>direct (unmittelbar), disjunct, disparate</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>the interpretation it starts from (default: the field record)</source>
        <translation>die Lesart, von der sie ausgeht (leer: die Aufnahme)</translation>
    </message>
    <message>
        <source>relations it adds, as in &quot;1 covers 2; 3 cuts 4&quot;; set adds to those there</source>
        <translation>Beziehungen, die sie hinzufügt, wie „1 über 2; 3 schneidet 4“; neue kommen zu den vorhandenen</translation>
    </message>
    <message>
        <source>relations it leaves out; set adds to those there; &quot;adds&quot; brings one back</source>
        <translation>Beziehungen, die sie weglässt; neue kommen zu den vorhandenen; „Fügt hinzu“ holt eine zurück</translation>
    </message>
    <message>
        <source>who reads it so (default: you)</source>
        <translation>wer es so liest (leer: Sie)</translation>
    </message>
    <message>
        <source>unit it was found in</source>
        <translation>Befund, in dem er lag</translation>
    </message>
    <message>
        <source>site grid [m]</source>
        <translation>Grabungsnetz [m]</translation>
    </message>
    <message>
        <source>height [m]</source>
        <translation>Höhe [m]</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>was es ist</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>how many</source>
        <translation>wie viele</translation>
    </message>
    <message>
        <source>weight [g]</source>
        <translation>Gewicht [g]</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>box or bag</source>
        <translation>Kiste oder Tüte</translation>
    </message>
    <message>
        <source>day it was found</source>
        <translation>Tag, an dem er gefunden wurde</translation>
    </message>
    <message>
        <source>description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>unit it was taken from</source>
        <translation>Befund, aus dem sie stammt</translation>
    </message>
    <message>
        <source>soil, C14, charcoal, pollen, …</source>
        <translation>Boden, C14, Holzkohle, Pollen, …</translation>
    </message>
    <message>
        <source>volume [l]</source>
        <translation>Volumen [l]</translation>
    </message>
    <message>
        <source>number the laboratory gave</source>
        <translation>Nummer des Labors</translation>
    </message>
    <message>
        <source>stored, submitted, analysed, discarded</source>
        <translation>eingelagert, eingereicht, ausgewertet, verworfen</translation>
    </message>
    <message>
        <source>unit it shows</source>
        <translation>Befund, den sie zeigt</translation>
    </message>
    <message>
        <source>photo, drawing, sheet, …</source>
        <translation>Foto, Zeichnung, Bogen, …</translation>
    </message>
    <message>
        <source>title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>file, relative to the project</source>
        <translation>Datei, vom Ordner des Projekts aus</translation>
    </message>
    <message>
        <source>day it was made</source>
        <translation>Tag, an dem sie entstand</translation>
    </message>
    <message>
        <source>author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>what the height stands for</source>
        <translation>wofür die Höhe steht</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <source>how it is dug</source>
        <translation>wie er gegraben wird</translation>
    </message>
    <message>
        <source>first unit number issued to it</source>
        <translation>erste Befundnummer, die ihm zugeteilt ist</translation>
    </message>
    <message>
        <source>last unit number issued to it</source>
        <translation>letzte Befundnummer, die ihm zugeteilt ist</translation>
    </message>
    <message>
        <source>trench</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>how it was made</source>
        <translation>wie sie entstand</translation>
    </message>
    <message>
        <source>first day</source>
        <translation>erster Tag</translation>
    </message>
    <message>
        <source>last day</source>
        <translation>letzter Tag</translation>
    </message>
    <message>
        <source>place in time among the surfaces of its area</source>
        <translation>Platz in der Zeit unter den Flächen ihres Schnitts</translation>
    </message>
    <message>
        <source>unit it shows; empty: none</source>
        <translation>Befund, den er zeigt; leer: keiner</translation>
    </message>
    <message>
        <source>what it encloses</source>
        <translation>was er umschließt</translation>
    </message>
    <message>
        <source>what of the unit it shows</source>
        <translation>was vom Befund er zeigt</translation>
    </message>
    <message>
        <source>corners in site coordinates: &quot;x y z, x y z, …&quot; or without heights, or WKT</source>
        <translation>Ecken im Grabungsnetz: „x y z, x y z, …“ oder ohne Höhen, oder WKT</translation>
    </message>
    <message>
        <source>uncertainty of the outline [m]</source>
        <translation>Unsicherheit des Umrisses [m]</translation>
    </message>
    <message>
        <source>cut whose side shows it</source>
        <translation>Eingriff, dessen Wand ihn zeigt</translation>
    </message>
    <message>
        <source>no scan file there (%1)</source>
        <translation>keine Scandatei darin (%1)</translation>
    </message>
    <message>
        <source>not the ending of a scan</source>
        <translation>nicht die Endung eines Scans</translation>
    </message>
    <message>
        <source>has no scan in it</source>
        <translation>enthält keinen Scan</translation>
    </message>
    <message>
        <source>the project has another scan %1 with other content</source>
        <translation>das Projekt hat schon einen anderen Scan %1 mit anderem Inhalt</translation>
    </message>
    <message>
        <source>has no valid point</source>
        <translation>hat keinen gültigen Punkt</translation>
    </message>
    <message>
        <source>%1 points over 131 km away were left out</source>
        <translation>%1 Punkte in über 131 km Entfernung wurden weggelassen</translation>
    </message>
    <message>
        <source>columns read as %1</source>
        <translation>Spalten gelesen als %1</translation>
    </message>
    <message>
        <source>the day is the one written in the file</source>
        <translation>der Tag ist der, der in der Datei steht</translation>
    </message>
    <message>
        <source>surface %1 exists in several areas; say which area</source>
        <translation>Fläche %1 gibt es in mehreren Schnitten; angeben, in welchem</translation>
    </message>
    <message>
        <source>%1 %2: not a day of the calendar as 2025-06-01</source>
        <translation>%1 %2: kein Tag des Kalenders wie 2025-06-01</translation>
    </message>
    <message>
        <source>scan %1: the original %2 is not there</source>
        <translation>Scan %1: die Originaldatei %2 ist nicht da</translation>
    </message>
    <message>
        <source>scan %1 has no points: there is nothing to unroll</source>
        <translation>Scan %1 hat keine Punkte: es gibt nichts abzurollen</translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation>Reflektanz</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>scan %1: its points are not in %2 and the original %3 is not there either; put it back or add the scan again from where it is now</source>
        <translation>Scan %1: seine Punkte liegen nicht in %2, und die Originaldatei %3 ist auch nicht da; sie zurücklegen oder den Scan von seinem jetzigen Ort neu aufnehmen</translation>
    </message>
    <message>
        <source>its original is not there: %1</source>
        <translation>die Originaldatei ist nicht da: %1</translation>
    </message>
    <message>
        <source>put it back, its points could not be made again</source>
        <translation>sie zurücklegen, ihre Punkte ließen sich sonst nicht wieder erzeugen</translation>
    </message>
    <message>
        <source>%1 of %2 blocks of its point store are damaged, the first at byte %3 with %4 points</source>
        <translation>%1 von %2 Blöcken der Punktdatei sind beschädigt, der erste bei Byte %3 mit %4 Punkten</translation>
    </message>
    <message>
        <source>its point store is damaged: %1</source>
        <translation>die Punktdatei ist beschädigt: %1</translation>
    </message>
    <message>
        <source>made again from the original</source>
        <translation>aus der Originaldatei neu erzeugt</translation>
    </message>
    <message>
        <source>it could not be made again: %1</source>
        <translation>sie ließ sich nicht neu erzeugen: %1</translation>
    </message>
    <message>
        <source>no column %1; a marker file begins with scan,marker,x,y,z</source>
        <translation>keine Spalte %1; eine Datei mit Passmarken beginnt mit scan,marker,x,y,z</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>nothing under %1</source>
        <translation>nichts unter %1</translation>
    </message>
    <message>
        <source>a marker without a name</source>
        <translation>eine Passmarke ohne Namen</translation>
    </message>
    <message>
        <source>“%1” is no %2 coordinate</source>
        <translation>„%1“ ist keine Koordinate %2</translation>
    </message>
    <message>
        <source>nothing under scan; rows of the survey say site there</source>
        <translation>nichts unter scan; bei eingemessenen Passmarken steht dort site</translation>
    </message>
    <message>
        <source>the marker %1 of %2 a second time</source>
        <translation>die Passmarke %1 von %2 ein zweites Mal</translation>
    </message>
    <message>
        <source>the project has no scan %1 (yet)</source>
        <translation>das Projekt hat (noch) keinen Scan %1</translation>
    </message>
    <message>
        <source>marker %1 of %2 was not surveyed</source>
        <translation>Passmarke %1 von %2 wurde nicht eingemessen</translation>
    </message>
    <message>
        <source>no scan was made on %1</source>
        <translation>am %1 wurde nicht gescannt</translation>
    </message>
    <message>
        <source>placed by %1</source>
        <translation>eingepasst über %1</translation>
    </message>
    <message>
        <source>poorly placed by %1: %2</source>
        <translation>unsicher eingepasst über %1: %2</translation>
    </message>
    <message>
        <source>its own frame, which is taken for the site grid</source>
        <translation>sein eigenes Netz, das als Grabungsnetz gilt</translation>
    </message>
    <message>
        <source>%1 markers</source>
        <translation>%1 Passmarken</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verknüpfung</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 Verknüpfungen</translation>
    </message>
    <message>
        <source>%1 markers and 1 link</source>
        <translation>%1 Passmarken und 1 Verknüpfung</translation>
    </message>
    <message>
        <source>%1 markers and %2 links</source>
        <translation>%1 Passmarken und %2 Verknüpfungen</translation>
    </message>
    <message>
        <source>its position is only known to %1 mm</source>
        <translation>seine Lage ist nur auf %1 mm bekannt</translation>
    </message>
    <message>
        <source>its direction is only known to %1 degrees</source>
        <translation>seine Richtung ist nur auf %1 Grad bekannt</translation>
    </message>
    <message>
        <source>it was placed by features alone, which are good to centimetres</source>
        <translation>er wurde nur über Merkmale eingepasst, die auf Zentimeter genau sind</translation>
    </message>
    <message>
        <source>marker %1 left out: %2</source>
        <translation>Passmarke %1 weggelassen: %2</translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation>%1 weggelassen: %2</translation>
    </message>
    <message>
        <source>its markers were left out: %1</source>
        <translation>seine Passmarken wurden weggelassen: %1</translation>
    </message>
    <message>
        <source>relaxation took the links&apos; errors from %1 to %2 standard deviations (root mean square); of %3 links %4 gave way to others, none is off by more than %5</source>
        <translation>der Ausgleich brachte die Fehler der Verknüpfungen von %1 auf %2 Standardabweichungen (quadratisches Mittel); von %3 Verknüpfungen gaben %4 anderen nach, keine liegt um mehr als %5 daneben</translation>
    </message>
    <message>
        <source>not placed: the scan has no points</source>
        <translation>nicht eingepasst: der Scan hat keine Punkte</translation>
    </message>
    <message>
        <source>not placed: %1</source>
        <translation>nicht eingepasst: %1</translation>
    </message>
    <message>
        <source>its markers: %1</source>
        <translation>seine Passmarken: %1</translation>
    </message>
    <message>
        <source>no markers were measured in it</source>
        <translation>in ihm wurden keine Passmarken gemessen</translation>
    </message>
    <message>
        <source>it hangs together with %1, but nothing says where these are on the site grid</source>
        <translation>er hängt mit %1 zusammen, aber nichts sagt, wo diese im Grabungsnetz liegen</translation>
    </message>
    <message>
        <source>no start value near that of another scan</source>
        <translation>kein Startwert nahe dem eines anderen Scans</translation>
    </message>
    <message>
        <source>it shares too little with the other scans: at best %1 places look alike and lie the same way to each other</source>
        <translation>er hat zu wenig mit den anderen Scans gemeinsam: höchstens %1 Stellen sehen gleich aus und liegen gleich zueinander</translation>
    </message>
    <message>
        <source>the report of a registration run cannot be read; discard the run</source>
        <translation>der Bericht einer Registrierung lässt sich nicht lesen; sie verwerfen</translation>
    </message>
    <message>
        <source>no registration run %1; there are %2</source>
        <translation>Registrierung %1 gibt es nicht; es gibt %2</translation>
    </message>
    <message>
        <source>registration run %1 is accepted already</source>
        <translation>Registrierung %1 ist schon angenommen</translation>
    </message>
    <message>
        <source>registration run %1 is discarded already</source>
        <translation>Registrierung %1 ist schon verworfen</translation>
    </message>
    <message>
        <source>nothing was placed</source>
        <translation>nichts wurde eingepasst</translation>
    </message>
    <message>
        <source>proposed only, as asked</source>
        <translation>nur vorgeschlagen, wie gewünscht</translation>
    </message>
    <message>
        <source>%1 of %2 scans are placed poorly (%3)</source>
        <translation>%1 von %2 Scans liegen unsicher (%3)</translation>
    </message>
    <message>
        <source>scan %1 was removed while it was registered; nothing was kept</source>
        <translation>Scan %1 wurde während des Einpassens entfernt; nichts wurde behalten</translation>
    </message>
    <message>
        <source>aligned on %1 of %2 pieces of ground, %3 mm rms, σ %4 mm and %5°</source>
        <translation>auf %1 von %2 Bodenstücken ausgerichtet, %3 mm rms, σ %4 mm und %5°</translation>
    </message>
    <message>
        <source>not in the survey</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>surveyed %1 times: keep one</source>
        <translation>%1-mal eingemessen: eine behalten</translation>
    </message>
    <message>
        <source>measured more than once in this scan: keep one</source>
        <translation>in diesem Scan mehrfach gemessen: eine behalten</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>eine Koordinate ist keine Zahl</translation>
    </message>
    <message>
        <source>the markers lie almost on one line, which leaves the turn about it open: add one beside it</source>
        <translation>die Passmarken liegen fast auf einer Linie, so bleibt die Drehung um sie offen: eine daneben hinzunehmen</translation>
    </message>
    <message>
        <source>the three markers do not fit the survey, distances differ by up to %1, and with three nobody can say which is wrong: measure a fourth</source>
        <translation>die drei Passmarken passen nicht zur Einmessung, Abstände weichen bis %1 ab, und bei dreien kann niemand sagen, welche falsch ist: eine vierte messen</translation>
    </message>
    <message>
        <source>no three of the %1 markers fit the survey, distances differ by up to %2: is it the survey of this site?</source>
        <translation>keine drei der %1 Passmarken passen zur Einmessung, Abstände weichen bis %2 ab: ist es die Einmessung dieser Grabung?</translation>
    </message>
    <message>
        <source>the markers %1 and the markers %2 say different poses and neither set is larger: measure them again</source>
        <translation>die Passmarken %1 und die Passmarken %2 sagen Verschiedenes, und keine der Gruppen ist größer: neu messen</translation>
    </message>
    <message>
        <source>%1 mm off its place</source>
        <translation>%1 mm neben ihrem Platz</translation>
    </message>
    <message>
        <source>swapped with %1</source>
        <translation>mit %1 vertauscht</translation>
    </message>
    <message>
        <source>lies where %1 was surveyed: wrong name?</source>
        <translation>liegt, wo %1 eingemessen ist: falscher Name?</translation>
    </message>
    <message>
        <source>%1 of %2 markers fit with %3 mm rms</source>
        <translation>%1 von %2 Passmarken passen auf %3 mm (rms)</translation>
    </message>
    <message>
        <source>%1 of the scan&apos;s %2 markers can be paired with the survey, three are needed</source>
        <translation>%1 der %2 Passmarken des Scans sind eingemessen, drei braucht es</translation>
    </message>
    <message>
        <source>contradicts the other links and markers by %1 standard deviations (%2 mm, %3 degrees)</source>
        <translation>widerspricht den anderen Verknüpfungen und Passmarken um %1 Standardabweichungen (%2 mm, %3 Grad)</translation>
    </message>
    <message>
        <source>the surface is no longer in the record</source>
        <translation>die Fläche steht nicht mehr in der Aufnahme</translation>
    </message>
    <message>
        <source>surfaces %1 and %2 belong to two areas; only those of one can be compared</source>
        <translation>die Flächen %1 und %2 gehören zu zwei Schnitten; vergleichen lassen sich nur die eines Schnitts</translation>
    </message>
    <message>
        <source>%1: there are neither outlines nor registered scans to show</source>
        <translation>%1: es gibt weder Umrisse noch eingepasste Scans zu zeigen</translation>
    </message>
    <message>
        <source>unit %1 has no outline on any surface</source>
        <translation>Befund %1 hat auf keiner Fläche einen Umriss</translation>
    </message>
    <message>
        <source>%1: no registered scan shows it; the plan has outlines only</source>
        <translation>%1: kein eingepasster Scan zeigt sie; der Plan hat nur Umrisse</translation>
    </message>
    <message>
        <source>%1 is not registered and was left out</source>
        <translation>%1 ist nicht eingepasst und wurde weggelassen</translation>
    </message>
    <message>
        <source>both ends of the section are one place</source>
        <translation>beide Enden des Profils sind derselbe Ort</translation>
    </message>
    <message>
        <source>neither registered scans nor outlines lie in this plane</source>
        <translation>in dieser Ebene liegen weder eingepasste Scans noch Umrisse</translation>
    </message>
    <message>
        <source>no registered scan of %1 shows region %2; add scans of that day and register them</source>
        <translation>kein eingepasster Scan vom %1 zeigt den Umriss %2; Scans dieses Tages aufnehmen und einpassen</translation>
    </message>
    <message>
        <source>region %1 lies outside all scans of its day</source>
        <translation>der Umriss %1 liegt außerhalb aller Scans seines Tages</translation>
    </message>
    <message>
        <source>%1 has several parts; say which: %2</source>
        <translation>%1 hat mehrere Teile; angeben, welcher: %2</translation>
    </message>
    <message>
        <source>surface %1 is not of area %2</source>
        <translation>Fläche %1 gehört nicht zu Schnitt %2</translation>
    </message>
    <message>
        <source>surface %1 is new and has no day</source>
        <translation>Fläche %1 ist neu und hat keinen Tag</translation>
    </message>
    <message>
        <source>section %1 is new: say its two ends, from and to [x, y]</source>
        <translation>Profil %1 ist neu: seine beiden Enden angeben, from und to [x, y]</translation>
    </message>
    <message>
        <source>unit %1 may be %2; say which, or the area of the outlines</source>
        <translation>Befund %1 kann %2 sein; angeben, welcher, oder den Schnitt der Umrisse</translation>
    </message>
    <message>
        <source>%1: no registered surface before it</source>
        <translation>%1: davor keine Fläche mit eingepassten Scans</translation>
    </message>
    <message>
        <source>this is no GeoJSON: its type is none of %1</source>
        <translation>das ist kein GeoJSON: sein type ist keins von %1</translation>
    </message>
    <message>
        <source>it holds no outline</source>
        <translation>es enthält keinen Umriss</translation>
    </message>
    <message>
        <source>its coordinates are degrees (%1); export it in the coordinate system of the site grid</source>
        <translation>seine Koordinaten sind Grad (%1); im Koordinatensystem des Grabungsnetzes ausgeben</translation>
    </message>
    <message>
        <source>%1 outlined units in one area; %2 can be compared</source>
        <translation>%1 umrissene Befunde in einem Schnitt; verglichen werden können %2</translation>
    </message>
    <message>
        <source>phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>no problem to draw: no error or warning names a relation</source>
        <translation>kein Problem zu zeichnen: kein Fehler und keine Warnung nennt eine Beziehung</translation>
    </message>
    <message>
        <source>nothing was added, removed or changed since %1</source>
        <translation>seit %1 wurde nichts angelegt, entfernt oder geändert</translation>
    </message>
    <message>
        <source>no format ends in %1; known are %2</source>
        <translation>kein Format endet auf %1; bekannt sind %2</translation>
    </message>
    <message>
        <source>plans and sections are written as .pdf or .png</source>
        <translation>Pläne und Profile werden als .pdf oder .png geschrieben</translation>
    </message>
    <message>
        <source>a report is .xml, .html or .pdf</source>
        <translation>ein Bericht ist .xml, .html oder .pdf</translation>
    </message>
    <message>
        <source>day %1: nothing was dug, recorded or scanned on it; %2</source>
        <translation>am %1 wurde nichts gegraben, aufgenommen oder gescannt; %2</translation>
    </message>
    <message>
        <source>the record holds no dates at all</source>
        <translation>die Aufnahme nennt gar keine Tage</translation>
    </message>
    <message>
        <source>the last day before it with something is %1</source>
        <translation>der letzte Tag davor mit etwas ist %1</translation>
    </message>
    <message>
        <source>the first day with something is %1</source>
        <translation>der erste Tag mit etwas ist %1</translation>
    </message>
    <message>
        <source>%1 is not empty; name a new folder for the sample dig, or remove this one if a stopped run left it</source>
        <translation>%1 ist nicht leer; einen neuen Ordner für die Beispielgrabung nennen, oder diesen löschen, wenn ihn ein abgebrochener Lauf hinterließ</translation>
    </message>
    <message>
        <source>the site has no %1 yet</source>
        <translation>die Grabung hat noch keine %1</translation>
    </message>
    <message>
        <source>surface %1: no scan of its days is in the project; Add scans brings them</source>
        <translation>Fläche %1: kein Scan ihrer Tage ist im Projekt; Scans aufnehmen bringt sie</translation>
    </message>
    <message>
        <source>its days and its place in the order of surfaces disagree</source>
        <translation>ihre Tage und ihr Platz in der Folge der Flächen widersprechen sich</translation>
    </message>
    <message>
        <source>an outline is left out, more than %1 m from all scans</source>
        <translation>ein Umriss ist ausgelassen, mehr als %1 m von allen Scans</translation>
    </message>
    <message>
        <source>%1 outlines are left out, more than %2 m from all scans</source>
        <translation>%1 Umrisse sind ausgelassen, mehr als %2 m von allen Scans</translation>
    </message>
    <message>
        <source>none of its scans stands on the site grid; Register in the list of scans places them</source>
        <translation>keiner ihrer Scans liegt im Grabungsnetz; Einpassen in der Liste der Scans holt das nach</translation>
    </message>
    <message>
        <source>no scan of its days is in the project; Add scans brings them</source>
        <translation>kein Scan ihrer Tage ist im Projekt; Scans aufnehmen bringt sie</translation>
    </message>
    <message>
        <source>%1 lies more than %2 m from all scans and was left out</source>
        <translation>%1 liegt mehr als %2 m von allen Scans und ist ausgelassen</translation>
    </message>
    <message>
        <source>it reaches %1 away from all set-ups of the scanner: plans leave it out and nothing is concluded from it; is it in other coordinates than the site?</source>
        <translation>er reicht %1 weg von allen Standpunkten des Scanners: Pläne lassen ihn aus, und aus ihm wird nichts geschlossen; liegt er in anderen Koordinaten als die Grabung?</translation>
    </message>
    <message>
        <source>it overlaps %1 by %2 m²; neither gets that ground</source>
        <translation>er überschneidet %1 um %2 m²; keiner bekommt diesen Boden</translation>
    </message>
    <message>
        <source>it lies %1 m off the plane of section %2, which runs from %3 %4 to %5 %6; outlines on a section lie within %7 m of it</source>
        <translation>er liegt %1 m neben der Ebene des Profils %2, die von %3 %4 nach %5 %6 läuft; Umrisse auf einem Profil liegen höchstens %7 m daneben</translation>
    </message>
    <message>
        <source>%1 ends on %2, before it begins on %3</source>
        <translation>%1 endet am %2, bevor sie am %3 beginnt</translation>
    </message>
    <message>
        <source>surface %1 stands before %2, though its day is later: nothing is concluded from either until their places in time or their days are put right</source>
        <translation>die Fläche %1 steht vor %2, obwohl ihr Tag später ist: aus beiden wird nichts geschlossen, bis ihr Platz in der Zeit oder ihre Tage stimmen</translation>
    </message>
    <message>
        <source>line %1 is not UTF-8: save the file as UTF-8</source>
        <translation>Zeile %1 ist kein UTF-8: die Datei als UTF-8 speichern</translation>
    </message>
    <message>
        <source>not valid JSON at line %1, column %2</source>
        <translation>kein gültiges JSON in Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>line %1, column %2: JSON has no number %3; leave it out or write null</source>
        <translation>Zeile %1, Spalte %2: JSON kennt keine Zahl %3; weglassen oder null schreiben</translation>
    </message>
    <message>
        <source>line %1, column %2: the number %3 is too large</source>
        <translation>Zeile %1, Spalte %2: die Zahl %3 ist zu groß</translation>
    </message>
    <message>
        <source>reading or writing the disk failed (%1): nothing was changed; see that the disk has space, is still there and allows files of this size, and try again</source>
        <translation>Lesen oder Schreiben der Platte schlug fehl (%1): nichts wurde geändert; nachsehen, ob die Platte Platz hat, noch da ist und Dateien dieser Größe erlaubt, und noch einmal versuchen</translation>
    </message>
    <message>
        <source>%1 is a list and not one word or number</source>
        <translation>%1 ist eine Liste und nicht ein Wort oder eine Zahl</translation>
    </message>
    <message>
        <source>%1 is an object and not one word or number</source>
        <translation>%1 ist ein Objekt und nicht ein Wort oder eine Zahl</translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Units</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Panorama</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Finds and lists</source>
        <translation>Funde und Listen</translation>
    </message>
    <message>
        <source>Record card</source>
        <translation>Befundbogen</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>Verfüllung</translation>
    </message>
    <message>
        <source>masonry</source>
        <translation>Mauerwerk</translation>
    </message>
    <message>
        <source>timber</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>burial</source>
        <translation>Bestattung</translation>
    </message>
    <message>
        <source>deposit</source>
        <translation>Ablagerung</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>Komplex</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>interface</source>
        <translation>Grenzfläche</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>Anstehendes</translation>
    </message>
    <message>
        <source>void number</source>
        <translation>leere Nummer</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>partly excavated</source>
        <translation>teilweise gegraben</translation>
    </message>
    <message>
        <source>excavated</source>
        <translation>gegraben</translation>
    </message>
    <message>
        <source>not excavated</source>
        <translation>nicht gegraben</translation>
    </message>
    <message>
        <source>void</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>covered by</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>covers</source>
        <translation>über</translation>
    </message>
    <message>
        <source>cut by</source>
        <translation>geschnitten von</translation>
    </message>
    <message>
        <source>cuts</source>
        <translation>schneidet</translation>
    </message>
    <message>
        <source>filled by</source>
        <translation>verfüllt von</translation>
    </message>
    <message>
        <source>fills</source>
        <translation>verfüllt</translation>
    </message>
    <message>
        <source>abutted by</source>
        <translation>angebaut von</translation>
    </message>
    <message>
        <source>abuts</source>
        <translation>stößt an</translation>
    </message>
    <message>
        <source>bonds with</source>
        <translation>im Verband mit</translation>
    </message>
    <message>
        <source>same as</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>borders</source>
        <translation>grenzt an</translation>
    </message>
    <message>
        <source>earlier than</source>
        <translation>älter als</translation>
    </message>
    <message>
        <source>later than</source>
        <translation>jünger als</translation>
    </message>
    <message>
        <source>contemporary with</source>
        <translation>gleichzeitig mit</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>top</source>
        <translation>Oberkante</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Unterkante</translation>
    </message>
    <message>
        <source>bottom of the cut</source>
        <translation>Sohle des Eingriffs</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Nivellement</translation>
    </message>
    <message>
        <source>a unit</source>
        <translation>ein Befund</translation>
    </message>
    <message>
        <source>spoil</source>
        <translation>Abraum</translation>
    </message>
    <message>
        <source>slump</source>
        <translation>Nachsturz</translation>
    </message>
    <message>
        <source>backfill</source>
        <translation>Wiederverfüllung</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>equipment</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>baulk</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>not excavated yet</source>
        <translation>noch nicht gegraben</translation>
    </message>
    <message>
        <source>shows: its top</source>
        <translation>zeigt: seine Oberfläche</translation>
    </message>
    <message>
        <source>shows: a level inside it</source>
        <translation>zeigt: ein Planum in ihm</translation>
    </message>
    <message>
        <source>shows: the bare cut</source>
        <translation>zeigt: den leeren Eingriff</translation>
    </message>
    <message>
        <source>shows: dug too deep</source>
        <translation>zeigt: zu tief gegraben</translation>
    </message>
    <message>
        <source>shows: dug by machine</source>
        <translation>zeigt: mit dem Bagger gegraben</translation>
    </message>
    <message>
        <source>shows: a face</source>
        <translation>zeigt: eine Wand</translation>
    </message>
    <message>
        <source>shows: nothing of it</source>
        <translation>zeigt: nichts davon</translation>
    </message>
    <message>
        <source>Units above one another in a circle</source>
        <translation>Befunde im Kreis übereinander</translation>
    </message>
    <message>
        <source>Circle made by “same as”</source>
        <translation>Kreis durch „gleich“</translation>
    </message>
    <message>
        <source>Unit above itself</source>
        <translation>Befund über sich selbst</translation>
    </message>
    <message>
        <source>Stated both ways</source>
        <translation>In beide Richtungen angegeben</translation>
    </message>
    <message>
        <source>Contemporary, yet ordered</source>
        <translation>Gleichzeitig und doch nacheinander</translation>
    </message>
    <message>
        <source>Surfaces contradict the relation</source>
        <translation>Flächen widersprechen der Beziehung</translation>
    </message>
    <message>
        <source>Levels contradict the relation</source>
        <translation>Nivellements widersprechen der Beziehung</translation>
    </message>
    <message>
        <source>Dates contradict the order</source>
        <translation>Datierungen widersprechen der Reihenfolge</translation>
    </message>
    <message>
        <source>Phases contradict the order</source>
        <translation>Phasen widersprechen der Reihenfolge</translation>
    </message>
    <message>
        <source>Dug before what lay above it</source>
        <translation>Vor dem gegraben, was darüber lag</translation>
    </message>
    <message>
        <source>Find outside its unit</source>
        <translation>Fund außerhalb seines Befunds</translation>
    </message>
    <message>
        <source>Relation does not fit the kinds</source>
        <translation>Beziehung passt nicht zu den Arten</translation>
    </message>
    <message>
        <source>Fill without a cut</source>
        <translation>Verfüllung ohne Eingriff</translation>
    </message>
    <message>
        <source>Cut without a fill</source>
        <translation>Eingriff ohne Verfüllung</translation>
    </message>
    <message>
        <source>Cut that cuts nothing</source>
        <translation>Eingriff, der nichts schneidet</translation>
    </message>
    <message>
        <source>Something lies below the natural</source>
        <translation>Etwas liegt unter dem Anstehenden</translation>
    </message>
    <message>
        <source>Number used twice</source>
        <translation>Nummer doppelt vergeben</translation>
    </message>
    <message>
        <source>Number outside its block</source>
        <translation>Nummer außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>Relation stated twice on one sheet</source>
        <translation>Beziehung auf einem Bogen doppelt</translation>
    </message>
    <message>
        <source>Stated on one sheet only</source>
        <translation>Nur auf einem Bogen angegeben</translation>
    </message>
    <message>
        <source>Unit without a sheet</source>
        <translation>Befund ohne Bogen</translation>
    </message>
    <message>
        <source>Not understood on import</source>
        <translation>Beim Import nicht verstanden</translation>
    </message>
    <message>
        <source>Unit without relations</source>
        <translation>Befund ohne Beziehungen</translation>
    </message>
    <message>
        <source>Unit without an outline</source>
        <translation>Befund ohne Umriss</translation>
    </message>
    <message>
        <source>Outline without a unit</source>
        <translation>Umriss ohne Befund</translation>
    </message>
    <message>
        <source>Scan not on the site grid</source>
        <translation>Scan nicht im Grabungsnetz</translation>
    </message>
    <message>
        <source>Scan placed with doubt</source>
        <translation>Scan unsicher eingepasst</translation>
    </message>
    <message>
        <source>Surface changed while it was scanned</source>
        <translation>Fläche änderte sich beim Scannen</translation>
    </message>
    <message>
        <source>Ground rose</source>
        <translation>Boden stieg an</translation>
    </message>
    <message>
        <source>Relation that others imply</source>
        <translation>Beziehung, die aus anderen folgt</translation>
    </message>
    <message>
        <source>Surfaces in the wrong order</source>
        <translation>Flächen in falscher Folge</translation>
    </message>
    <message>
        <source>Outline far from all scans</source>
        <translation>Umriss fern von allen Scans</translation>
    </message>
    <message>
        <source>Outlines on the same ground</source>
        <translation>Umrisse auf demselben Boden</translation>
    </message>
</context>
</TS>
