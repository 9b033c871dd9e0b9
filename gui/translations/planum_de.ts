<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
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
</context>
<context>
    <name>changes</name>
    <message>
        <source>Accept a relation from surfaces</source>
        <translation>Eine Beziehung aus Oberflächen annehmen</translation>
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
        <translation>Beziehungen aus Oberflächen annehmen</translation>
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
        <translation>Deutung %1 anlegen</translation>
    </message>
    <message>
        <source>Mark %1 uncertain: %2</source>
        <translation>%1 als unsicher kennzeichnen: %2</translation>
    </message>
    <message>
        <source>Outline changed ground</source>
        <translation>Geändertes umreißen</translation>
    </message>
    <message>
        <source>Outline changed ground as %1</source>
        <translation>Geändertes als %1 umreißen</translation>
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
        <translation>Dokument %1</translation>
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
        <translation>Deutung %1</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Höhe %1</translation>
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
        <translation>Oberfläche %1</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>Befund %1</translation>
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
        <translation>Höhen, Funde, Unterlagen</translation>
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
        <translation>%1 neue Höhen, Funde, Phasen und anderes</translation>
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
        <translation>%1 Punkte: %2 neue Höhen, %3 neue Funde</translation>
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
        <translation>Einpassen</translation>
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
        <translation>%1: %2 m², %3 m seit der Oberfläche davor; %4: %5</translation>
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
        <source>These fields could not be saved, and are lost when the window closes:
%1</source>
        <translation>Diese Felder ließen sich nicht speichern und gehen verloren, wenn das Fenster schließt:
%1</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>Keep the window open</source>
        <translation>Fenster offen lassen</translation>
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
        <translation>Einpassen</translation>
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
        <translation>Welche Linien Oberflächen, Profile und Höhen bestätigen oder widerlegen</translation>
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
        <translation>Geändertes benennen</translation>
    </message>
    <message>
        <source>Offers ground that changed since the surface before and has no outline yet</source>
        <translation>Bietet an, was sich seit der Oberfläche davor geändert und noch keinen Umriss hat</translation>
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
        <translation>Noch kein Scan dieser Oberfläche. Scans über das Menü Projekt aufnehmen oder Dateien auf das Fenster ziehen.</translation>
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
        <translation>die ganze Aufzeichnung</translation>
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
        <translation>Es gibt noch keine Oberfläche zu zeichnen.</translation>
    </message>
    <message>
        <source>Plan to scale</source>
        <translation>Plan im Maßstab</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
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
        <translation>Suche nach Flächen ohne Umriss</translation>
    </message>
    <message>
        <source>Name changed ground</source>
        <translation>Geänderte Fläche benennen</translation>
    </message>
    <message>
        <source>comparing with the surface before …</source>
        <translation>Vergleich mit der Oberfläche davor …</translation>
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
        <translation>Die Oberflächen werden verglichen</translation>
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
        <translation>auch Hinweise</translation>
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
        <translation>; die Oberflächen werden noch verglichen</translation>
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
        <translation>Ort</translation>
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
        <translation>nach Tiefe schattiert</translation>
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
        <translation>Einpassen</translation>
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
        <translation>Schneiden</translation>
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
        <translation>Zu sehen</translation>
    </message>
    <message>
        <source>Surfaces, scans and outlines on and off, one by one</source>
        <translation>Oberflächen, Scans und Umrisse einzeln ein- und ausblenden</translation>
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
        <translation>Neben der Aufzeichnung gibt es keine Lesart zum Vergleichen.</translation>
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
        <translation>Punkte einer Region …</translation>
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
        <translation>Punkte einer Region</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
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
        <translation>Kurzansprache</translation>
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
        <translation>die aufgenommenen Oberflächen zeigen es so</translation>
    </message>
    <message>
        <source>the recorded surfaces show the opposite</source>
        <translation>die aufgenommenen Oberflächen zeigen das Gegenteil</translation>
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
        <translation>die beiden Befunde liegen in verschiedenen Flächen</translation>
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
        <translation>%1 liegt in Fläche %2, deren Nummern von %3 bis %4 gehen</translation>
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
        <source>%1 scans are not on the site grid (planum register), among them %2</source>
        <translation>%1 Scans liegen nicht im Grabungsnetz (planum register), darunter %2</translation>
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
        <source>%1 is not on the site grid, so nothing can be concluded from it; planum register SITE says why</source>
        <translation>%1 liegt nicht im Grabungsnetz, also folgt nichts daraus; planum register SITE sagt warum</translation>
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
        <source>on %1 %2 m² of %3 near %4 at %5 to %6 m lay %7 m higher than on %8, which is the later day but stands first in the order of surfaces: put them in their order (planum surface set --order)</source>
        <translation>Am %1 lagen %2 m² von %3 bei %4 in %5 bis %6 m Höhe %7 m höher als am %8; das ist der spätere Tag, steht in der Folge der Flächen aber zuerst: die Flächen in ihre Folge bringen (planum surface set --order)</translation>
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
        <translation>Höhe</translation>
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
        <translation>Höhen widersprechen der Beziehung</translation>
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
</context>
</TS>
