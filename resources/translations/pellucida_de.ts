<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Pellucida</name>
    <message>
        <source>
Choose another folder: Cells (E), Change.</source>
        <translation>
Wählen Sie einen anderen Ordner: Zellen (E), Ändern.</translation>
    </message>
    <message>
        <source>
No force: </source>
        <translation>
Keine Kraft: </translation>
    </message>
    <message>
        <source>
Other models of the same push, no part of the interval:</source>
        <translation>
Andere Modelle desselben Stoßes, kein Teil des Intervalls:</translation>
    </message>
    <message>
        <source>
The bar goes from a quarter of the kind's stiffness (profile </source>
        <translation>
Der Balken reicht von einem Viertel der Steifigkeit der Zellart (Profil </translation>
    </message>
    <message>
        <source>
The file states </source>
        <translation>
Die Datei gibt </translation>
    </message>
    <message>
        <source>
Warning: </source>
        <translation>
Warnung: </translation>
    </message>
    <message>
        <source>
and </source>
        <translation>
und </translation>
    </message>
    <message>
        <source> % OF LIMIT</source>
        <translation> % DER GRENZE</translation>
    </message>
    <message>
        <source> %). The formula takes the zona for a flat, clamped membrane: tens of per cent are usual.</source>
        <translation> %). Die Formel hält die Zona für eine ebene, eingespannte Membran: Dutzende Prozent sind üblich.</translation>
    </message>
    <message>
        <source> (Esc: no more)</source>
        <translation> (Esc: beenden)</translation>
    </message>
    <message>
        <source> (spread </source>
        <translation> (Streuung </translation>
    </message>
    <message>
        <source> (standard deviation): so much single cells of this kind differ in stiffness. Scale, in the top row, measures this one: a push of known force, a fibre, or a tongue in the holding pipette.</source>
        <translation> (Standardabweichung): so verschieden steif sind einzelne Zellen dieser Art. „Skala“ in der obersten Zeile misst diese: mit einem Stoß bekannter Kraft, einer Faser oder einer Zunge in der Haltepipette.</translation>
    </message>
    <message>
        <source> (standard deviation); measured on it.</source>
        <translation> (Standardabweichung); an ihr gemessen.</translation>
    </message>
    <message>
        <source> - give a video, a folder of images, or the folder of a session</source>
        <translation> – wählen Sie ein Video, einen Ordner mit Bildern oder den Ordner einer Sitzung</translation>
    </message>
    <message>
        <source> N of </source>
        <translation> N von </translation>
    </message>
    <message>
        <source> The window measures with the usual cell's profile and does not know: Scale finds it out.</source>
        <translation> Das Fenster misst mit dem Profil der üblichen Zelle und weiß davon nichts: „Skala“ findet es heraus.</translation>
    </message>
    <message>
        <source> and offered here. Any other session can be dropped on this window.</source>
        <translation> und hier angeboten. Jede andere Sitzung lässt sich auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source> at </source>
        <translation> bei </translation>
    </message>
    <message>
        <source> can't be read and are left out; pellucida check names them</source>
        <translation> sind nicht lesbar und fehlen; pellucida check nennt sie</translation>
    </message>
    <message>
        <source> cell</source>
        <translation> Zelle</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> Zellen</translation>
    </message>
    <message>
        <source> drawn</source>
        <translation> gezeichnet</translation>
    </message>
    <message>
        <source> finite-element table </source>
        <translation> Finite-Elemente-Tabelle </translation>
    </message>
    <message>
        <source> for the next recording</source>
        <translation> auf die nächste Aufnahme</translation>
    </message>
    <message>
        <source> frame</source>
        <translation> Bild</translation>
    </message>
    <message>
        <source> frame </source>
        <translation> Bild </translation>
    </message>
    <message>
        <source> frames</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source> frames </source>
        <translation> Bilder </translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source> hint</source>
        <translation> Hinweis</translation>
    </message>
    <message>
        <source> hints</source>
        <translation> Hinweise</translation>
    </message>
    <message>
        <source> in </source>
        <translation> in </translation>
    </message>
    <message>
        <source> is out of range: give a </source>
        <translation> liegt außerhalb des Bereichs; erlaubt für </translation>
    </message>
    <message>
        <source> measured, </source>
        <translation> gemessen, </translation>
    </message>
    <message>
        <source> missed, 99 % late by at most </source>
        <translation> versäumt, 99 % höchstens verspätet um </translation>
    </message>
    <message>
        <source> more</source>
        <translation> weitere</translation>
    </message>
    <message>
        <source> nodes</source>
        <translation> Knoten</translation>
    </message>
    <message>
        <source> note waits</source>
        <translation> Notiz wartet</translation>
    </message>
    <message>
        <source> notes wait</source>
        <translation> Notizen warten</translation>
    </message>
    <message>
        <source> of </source>
        <translation> von </translation>
    </message>
    <message>
        <source> old</source>
        <translation> alt</translation>
    </message>
    <message>
        <source> or push more slowly, then start again (Home).</source>
        <translation> oder stoßen Sie langsamer, dann beginnen Sie neu (Pos1).</translation>
    </message>
    <message>
        <source> pJ, the needle put in </source>
        <translation> pJ, zugeführt hat die Nadel </translation>
    </message>
    <message>
        <source> point-load formula </source>
        <translation> Punktlastformel </translation>
    </message>
    <message>
        <source> recorded but not measured</source>
        <translation> aufgezeichnet, aber nicht gemessen</translation>
    </message>
    <message>
        <source> recordings in this folder; choose one of them</source>
        <translation> Aufzeichnungen in diesem Ordner; wählen Sie eine davon</translation>
    </message>
    <message>
        <source> row</source>
        <translation> Zeile</translation>
    </message>
    <message>
        <source> rows</source>
        <translation> Zeilen</translation>
    </message>
    <message>
        <source> ticks, </source>
        <translation> Takte, </translation>
    </message>
    <message>
        <source> times as stiff as its kind, </source>
        <translation> mal so steif wie ihre Art, </translation>
    </message>
    <message>
        <source> to </source>
        <translation> bis </translation>
    </message>
    <message>
        <source> µm a pixel; the typed </source>
        <translation> µm je Pixel an; die eingegebenen </translation>
    </message>
    <message>
        <source> µm beyond the edge</source>
        <translation> µm jenseits des Randes</translation>
    </message>
    <message>
        <source> µm beyond the entry</source>
        <translation> µm hinter dem Eintritt</translation>
    </message>
    <message>
        <source> µm per px</source>
        <translation> µm je px</translation>
    </message>
    <message>
        <source> µm per px, which no microscope has: check the length and its unit.</source>
        <translation> µm je px, was kein Mikroskop hat: Länge und Einheit prüfen.</translation>
    </message>
    <message>
        <source> µm replaces it.</source>
        <translation> µm ersetzen sie.</translation>
    </message>
    <message>
        <source> µs; energy margin </source>
        <translation> µs; Energiereserve </translation>
    </message>
    <message>
        <source> · 5 to 95 %: </source>
        <translation> · 5 bis 95 %: </translation>
    </message>
    <message>
        <source> · frame rate not in the file</source>
        <translation> · Bildrate nicht in der Datei</translation>
    </message>
    <message>
        <source> · median </source>
        <translation> · Median </translation>
    </message>
    <message>
        <source> · pixel size not in the file</source>
        <translation> · Pixelgröße nicht in der Datei</translation>
    </message>
    <message>
        <source> · quartiles </source>
        <translation> · Quartile </translation>
    </message>
    <message>
        <source>" is no number: give the </source>
        <translation>“ ist keine Zahl: nötig ist </translation>
    </message>
    <message>
        <source>%1  ·  frame %2  ·  %3 of %4</source>
        <translation>%1  ·  Bild %2  ·  %3 von %4</translation>
    </message>
    <message>
        <source>%1 blocks, longest %2</source>
        <translation>%1 Stockungen, längste %2</translation>
    </message>
    <message>
        <source>%1 frames changed; written to %2</source>
        <translation>%1 Bilder geändert; geschrieben nach %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 frames read</source>
        <translation>%1 von %2 Bildern gelesen</translation>
    </message>
    <message>
        <source>%1 tables written to %2</source>
        <translation>%1 Tabellen geschrieben nach %2</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>(1) &amp;nbsp;&lt;b&gt;f&lt;sub&gt;ij&lt;/sub&gt;&lt;/b&gt; = k (L/|p| − 1) p − b (v·p)/(p·p) p&lt;br&gt;(2) &amp;nbsp;&lt;b&gt;m a&lt;/b&gt; = Σ &lt;b&gt;f&lt;/b&gt;</source>
        <translation>(1) &amp;nbsp;&lt;b&gt;f&lt;sub&gt;ij&lt;/sub&gt;&lt;/b&gt; = k (L/|p| − 1) p − b (v·p)/(p·p) p&lt;br&gt;(2) &amp;nbsp;&lt;b&gt;m a&lt;/b&gt; = Σ &lt;b&gt;f&lt;/b&gt;</translation>
    </message>
    <message>
        <source>) to four times.</source>
        <translation>) bis zum Vierfachen.</translation>
    </message>
    <message>
        <source>, at </source>
        <translation>, bei </translation>
    </message>
    <message>
        <source>, at its limit</source>
        <translation>, an der Grenze</translation>
    </message>
    <message>
        <source>, guided</source>
        <translation>, geführt</translation>
    </message>
    <message>
        <source>, is above the stability limit of </source>
        <translation>, liegt über der Stabilitätsgrenze von </translation>
    </message>
    <message>
        <source>, is below the limit of linear vibration, </source>
        <translation>, liegt unter der Grenze der linearen Schwingung, </translation>
    </message>
    <message>
        <source>, node </source>
        <translation>, Knoten </translation>
    </message>
    <message>
        <source>, such as </source>
        <translation>, etwa </translation>
    </message>
    <message>
        <source>.
Connect one, then press Search again.</source>
        <translation>.
Schließen Sie eine an und drücken Sie „Erneut suchen“.</translation>
    </message>
    <message>
        <source>. Choose a shorter step or a larger mass, then start again (Home).</source>
        <translation>. Wählen Sie einen kürzeren Schritt oder eine größere Masse, dann beginnen Sie neu (Pos1).</translation>
    </message>
    <message>
        <source>0.00 N of 0.0 N</source>
        <translation>0.00 N von 0.0 N</translation>
    </message>
    <message>
        <source>0.000 pJ</source>
        <translation>0.000 pJ</translation>
    </message>
    <message>
        <source>0000 Pa</source>
        <translation>0000 Pa</translation>
    </message>
    <message>
        <source>00000 frames skipped</source>
        <translation>00000 Bilder ausgelassen</translation>
    </message>
    <message>
        <source>1 block, %1</source>
        <translation>1 Stockung, %1</translation>
    </message>
    <message>
        <source>1 to 4 choose a card, Enter starts it; or drop a file or a folder here</source>
        <translation>1 bis 4: Karte, Eingabe: Start; oder Datei oder Ordner hierher ziehen</translation>
    </message>
    <message>
        <source>1.5 times as stiff</source>
        <translation>1.5-mal so steif</translation>
    </message>
    <message>
        <source>2-D image</source>
        <translation>2-D-Bild</translation>
    </message>
    <message>
        <source>3-D + haptics</source>
        <translation>3-D + Haptik</translation>
    </message>
    <message>
        <source>3-D + haptics + guide</source>
        <translation>3-D + Haptik + Führung</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>3-D view as PNG</source>
        <translation>3-D-Ansicht als PNG</translation>
    </message>
    <message>
        <source>95 % from (µN)</source>
        <translation>95 % von (µN)</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>95 % interval at each arrow</source>
        <translation>95-%-Intervall an jedem Pfeil</translation>
    </message>
    <message>
        <source>95 % interval, picture</source>
        <translation>95-%-Intervall, Bild</translation>
    </message>
    <message>
        <source>95 % interval, the whole</source>
        <translation>95-%-Intervall, gesamt</translation>
    </message>
    <message>
        <source>95 % to (µN)</source>
        <translation>95 % bis (µN)</translation>
    </message>
    <message>
        <source>: all forces are scaled to cells of this kind.
The picture can't tell one kind from another of the same size: choose the profile with --profile.</source>
        <translation>: alle Kräfte sind auf Zellen dieser Art skaliert.
Das Bild kann gleich große Arten nicht unterscheiden: wählen Sie das Profil mit --profile.</translation>
    </message>
    <message>
        <source>: no image, no video and no session in this folder</source>
        <translation>: kein Bild, kein Video und keine Sitzung in diesem Ordner</translation>
    </message>
    <message>
        <source>: not now)</source>
        <translation>: doch nicht)</translation>
    </message>
    <message>
        <source>: nothing recorded</source>
        <translation>: nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>: pixel size and frame rate can't be settled</source>
        <translation>: Pixelgröße und Bildrate lassen sich nicht klären</translation>
    </message>
    <message>
        <source>: the picture can't be written; choose a folder that exists and may be written</source>
        <translation>: das Bild lässt sich nicht schreiben; wählen Sie einen vorhandenen, beschreibbaren Ordner</translation>
    </message>
    <message>
        <source>: the shape left the range where that holds. Push more slowly or take a shorter step, then start again (Home).</source>
        <translation>: die Form hat den Bereich verlassen, in dem sie gilt. Stoßen Sie langsamer oder wählen Sie einen kürzeren Schritt, dann beginnen Sie neu (Pos1).</translation>
    </message>
    <message>
        <source>; 1 kHz: </source>
        <translation>; 1 kHz: </translation>
    </message>
    <message>
        <source>; key 6 shows or hides them, key 7 shows the next force</source>
        <translation>; Taste 6 zeigt oder verbirgt sie, Taste 7 zeigt die nächste Kraft</translation>
    </message>
    <message>
        <source>; waits until a rendering has finished: </source>
        <translation>; wartet das Ende einer Bildausgabe ab: </translation>
    </message>
    <message>
        <source>= %1 µm per px</source>
        <translation>= %1 µm je px</translation>
    </message>
    <message>
        <source>= – µm per px</source>
        <translation>= – µm je px</translation>
    </message>
    <message>
        <source>A bending microfibre or calibrated pipette pushes this cell. Its stiffness times its deflection is the force.</source>
        <translation>Eine biegsame Mikrofaser oder kalibrierte Pipette drückt diese Zelle. Steifigkeit mal Auslenkung ist die Kraft.</translation>
    </message>
    <message>
        <source>A cell to poke on screen, with lessons on how its force comes about.</source>
        <translation>Eine Zelle zum Anstupsen, mit Lektionen darüber, wie ihre Kraft zustande kommt.</translation>
    </message>
    <message>
        <source>A distance: two clicks</source>
        <translation>Ein Abstand: zwei Klicks</translation>
    </message>
    <message>
        <source>A double click opens the session at the touch; a click on a column's title sorts</source>
        <translation>Ein Doppelklick öffnet die Sitzung beim Kontakt; ein Klick auf den Titel einer Spalte sortiert</translation>
    </message>
    <message>
        <source>A profile's geometry and constants</source>
        <translation>Geometrie und Konstanten eines Profils</translation>
    </message>
    <message>
        <source>A push on each point, outwards; inwards below 0</source>
        <translation>Ein Druck auf jeden Punkt, nach außen; unter 0 nach innen</translation>
    </message>
    <message>
        <source>A recorded session …</source>
        <translation>Eine aufgezeichnete Sitzung …</translation>
    </message>
    <message>
        <source>A recorded session: it opens in Review.</source>
        <translation>Eine aufgezeichnete Sitzung: sie öffnet sich in der Auswertung.</translation>
    </message>
    <message>
        <source>A recording doesn't hold the model's mesh</source>
        <translation>Eine Aufnahme enthält das Netz des Modells nicht</translation>
    </message>
    <message>
        <source>A recording is running. Everything recorded so far is kept.</source>
        <translation>Eine Aufnahme läuft. Alles bisher Aufgenommene bleibt erhalten.</translation>
    </message>
    <message>
        <source>A remark for the session's events; Enter writes it</source>
        <translation>Bemerkung zu den Ereignissen der Sitzung; Eingabe schreibt sie</translation>
    </message>
    <message>
        <source>A session, or a folder with sessions in it; they can be dropped here as well</source>
        <translation>Eine Sitzung oder ein Ordner mit Sitzungen; sie lassen sich auch hierher ziehen</translation>
    </message>
    <message>
        <source>A simulated cell to poke</source>
        <translation>Eine simulierte Zelle zum Anstupsen</translation>
    </message>
    <message>
        <source>A simulated cell under a simulated microscope. Nothing has to be connected.</source>
        <translation>Eine simulierte Zelle unter einem simulierten Mikroskop. Nichts muss angeschlossen sein.</translation>
    </message>
    <message>
        <source>A simulated operator injects cell after cell.</source>
        <translation>Ein simulierter Bediener injiziert Zelle um Zelle.</translation>
    </message>
    <message>
        <source>A solid wall (finite elements)</source>
        <translation>Eine feste Wand (finite Elemente)</translation>
    </message>
    <message>
        <source>A video, a folder of images or a stack is measured; a recorded session opens in Review.</source>
        <translation>Video, Bilderordner oder Bildstapel werden gemessen; eine aufgezeichnete Sitzung öffnet sich in der Auswertung.</translation>
    </message>
    <message>
        <source>AT THE LIMIT</source>
        <translation>AN DER GRENZE</translation>
    </message>
    <message>
        <source>Add a remark to the session's events</source>
        <translation>Fügt den Ereignissen der Sitzung eine Bemerkung hinzu</translation>
    </message>
    <message>
        <source>Add sessions</source>
        <translation>Sitzungen hinzufügen</translation>
    </message>
    <message>
        <source>Add sessions, or drop them here: a row for each cell</source>
        <translation>Fügen Sie Sitzungen hinzu, oder ziehen Sie sie hierher: eine Zeile je Zelle</translation>
    </message>
    <message>
        <source>All columns of the report's cells.csv, with the group of each</source>
        <translation>Alle Spalten der cells.csv des Berichts, mit der Gruppe jeder Zelle</translation>
    </message>
    <message>
        <source>All keys of this window</source>
        <translation>Alle Tasten dieses Fensters</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>All of the screen, and back</source>
        <translation>Den ganzen Bildschirm nutzen, und zurück</translation>
    </message>
    <message>
        <source>All tables as CSV</source>
        <translation>Alle Tabellen als CSV</translation>
    </message>
    <message>
        <source>Along x, y, z</source>
        <translation>Längs x, y, z</translation>
    </message>
    <message>
        <source>An active contour on a picture, step by step</source>
        <translation>Eine aktive Kontur auf einem Bild, Schritt für Schritt</translation>
    </message>
    <message>
        <source>An angle: three clicks, the second at its vertex</source>
        <translation>Ein Winkel: drei Klicks, der zweite am Scheitel</translation>
    </message>
    <message>
        <source>Angle </source>
        <translation>Winkel </translation>
    </message>
    <message>
        <source>Angle from the needle (°)</source>
        <translation>Winkel von der Nadel (°)</translation>
    </message>
    <message>
        <source>Approaching</source>
        <translation>Annähern</translation>
    </message>
    <message>
        <source>Area strain</source>
        <translation>Flächendehnung</translation>
    </message>
    <message>
        <source>Area strain (%)</source>
        <translation>Flächendehnung (%)</translation>
    </message>
    <message>
        <source>Arrows head to tail: a balance closes</source>
        <translation>Pfeile aneinandergereiht</translation>
    </message>
    <message>
        <source>Arrows on and off</source>
        <translation>Pfeile ein und aus</translation>
    </message>
    <message>
        <source>Arrows show the next force</source>
        <translation>Pfeile zeigen die nächste Kraft</translation>
    </message>
    <message>
        <source>Arrows ▾</source>
        <translation>Pfeile ▾</translation>
    </message>
    <message>
        <source>Arrows: the next force</source>
        <translation>Pfeile: die nächste Kraft</translation>
    </message>
    <message>
        <source>As at the start</source>
        <translation>Wie am Anfang</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie üblich</translation>
    </message>
    <message>
        <source>Aspiration</source>
        <translation>Aspiration</translation>
    </message>
    <message>
        <source>At a place in the image</source>
        <translation>An einer Stelle im Bild</translation>
    </message>
    <message>
        <source>At equal distances, as a snake's points</source>
        <translation>In gleichen Abständen, wie die Punkte einer Snake</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>At the nearest place</source>
        <translation>An der nächsten Stelle</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>At this time, on the node picked</source>
        <translation>Zu diesem Zeitpunkt, am gewählten Knoten</translation>
    </message>
    <message>
        <source>Axis of the node's chart</source>
        <translation>Achse des Diagramms des Knotens</translation>
    </message>
    <message>
        <source>BALLOON</source>
        <translation>BALLON</translation>
    </message>
    <message>
        <source>BENDING</source>
        <translation>BIEGUNG</translation>
    </message>
    <message>
        <source>Back to its kind</source>
        <translation>Zurück zur Zellart</translation>
    </message>
    <message>
        <source>Back to the first point of view</source>
        <translation>Zurück zum ersten Blickpunkt</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Ballon</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Bending, β</source>
        <translation>Biegung, β</translation>
    </message>
    <message>
        <source>Beside the measured one, from the specimen's own finite elements; never recorded</source>
        <translation>Neben der gemessenen, aus den Finiten Elementen des Präparats; wird nie aufgezeichnet</translation>
    </message>
    <message>
        <source>Black and white follow the image</source>
        <translation>Schwarz und Weiß folgen dem Bild</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>Instabil</translation>
    </message>
    <message>
        <source>Blown up after </source>
        <translation>Instabil geworden nach </translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>Both read the same contour with the same springs. In equilibrium the contour says how deep the needle is, and the shape is the network's own; prescribed, every node is laid on the contour, and the connectors under the tip are read.</source>
        <translation>Beide lesen dieselbe Kontur mit denselben Federn. Im Gleichgewicht sagt die Kontur, wie tief die Nadel ist, und die Form ist die des Netzes selbst; vorgeschrieben liegt jeder Knoten auf der Kontur, und die Verbinder unter der Spitze werden abgelesen.</translation>
    </message>
    <message>
        <source>Both views, and the cell's force on the hand</source>
        <translation>Beide Ansichten, und die Kraft der Zelle an der Hand</translation>
    </message>
    <message>
        <source>Both views, the force, and the guide along the planned line</source>
        <translation>Beide Ansichten, die Kraft und die Führung entlang der geplanten Linie</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Bringing the needle back into view</source>
        <translation>Nadel kommt ins Bild zurück</translation>
    </message>
    <message>
        <source>By a scale bar, or a needle of known diameter</source>
        <translation>An einem Maßstabsbalken oder einer Nadel bekannten Durchmessers</translation>
    </message>
    <message>
        <source>CELL LOST</source>
        <translation>ZELLE VERLOREN</translation>
    </message>
    <message>
        <source>CELL PROFILE</source>
        <translation>ZELLPROFIL</translation>
    </message>
    <message>
        <source>CONFIDENCE</source>
        <translation>SICHERHEIT</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera's own pixel</source>
        <translation>Pixel der Kamera</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled; no video was written</source>
        <translation>Abgebrochen; kein Video geschrieben</translation>
    </message>
    <message>
        <source>Cancelled; what was measured so far is in </source>
        <translation>Abgebrochen; das bisher Gemessene liegt in </translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Cell at rest</source>
        <translation>Zelle in Ruhe</translation>
    </message>
    <message>
        <source>Cell with a deep dimple</source>
        <translation>Zelle mit tiefer Delle</translation>
    </message>
    <message>
        <source>Cell with a dimple</source>
        <translation>Zelle mit Delle</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells of several sessions in one table</source>
        <translation>Zellen mehrerer Sitzungen in einer Tabelle</translation>
    </message>
    <message>
        <source>Cells of this run</source>
        <translation>Zellen dieses Laufs</translation>
    </message>
    <message>
        <source>Cells of this run with their outcome, and the recordings' folder</source>
        <translation>Zellen dieses Laufs mit ihrem Ausgang, und der Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Cells read: %1, from sessions: %2</source>
        <translation>Gelesene Zellen: %1, aus Sitzungen: %2</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change of the membrane's area from rest, from the model: red is larger, blue smaller, grey zero.</source>
        <translation>Änderung der Membranfläche gegenüber der Ruhe, nach dem Modell: Rot ist größer, Blau kleiner, Grau null.</translation>
    </message>
    <message>
        <source>Chart of the node as SVG, PDF, PNG or CSV</source>
        <translation>Diagramm des Knotens als SVG, PDF, PNG oder CSV</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose a file or a folder first, or drop one on this window.</source>
        <translation>Wählen Sie zuerst eine Datei oder einen Ordner, oder ziehen Sie sie auf dieses Fenster.</translation>
    </message>
    <message>
        <source>Choose a file or a folder of images first.</source>
        <translation>Zuerst eine Datei oder einen Ordner mit Bildern wählen.</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Choose a session</source>
        <translation>Sitzung wählen</translation>
    </message>
    <message>
        <source>Choose card %1</source>
        <translation>Karte %1 wählen</translation>
    </message>
    <message>
        <source>Choose the folder for recordings, pictures and tables</source>
        <translation>Ordner für Aufnahmen, Bilder und Tabellen wählen</translation>
    </message>
    <message>
        <source>Choose the folder of a session, or drop it on this window.</source>
        <translation>Wählen Sie den Ordner einer Sitzung, oder ziehen Sie ihn auf dieses Fenster.</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klicken</translation>
    </message>
    <message>
        <source>Click a node of the cell: each term of the equations becomes an arrow.</source>
        <translation>Klicken Sie auf einen Knoten der Zelle: jeder Term der Gleichungen wird zum Pfeil.</translation>
    </message>
    <message>
        <source>Click inside the cell</source>
        <translation>Klicken Sie in die Zelle</translation>
    </message>
    <message>
        <source>Click one end of the distance</source>
        <translation>Klicken Sie ein Ende des Abstands an</translation>
    </message>
    <message>
        <source>Click the angle's vertex</source>
        <translation>Klicken Sie den Scheitel des Winkels an</translation>
    </message>
    <message>
        <source>Click the end of one leg</source>
        <translation>Klicken Sie das Ende eines Schenkels an</translation>
    </message>
    <message>
        <source>Click the end of the other leg</source>
        <translation>Klicken Sie das Ende des anderen Schenkels an</translation>
    </message>
    <message>
        <source>Click the holding pipette, near the cell</source>
        <translation>Klicken Sie auf die Haltepipette, nahe der Zelle</translation>
    </message>
    <message>
        <source>Click the needle's tip</source>
        <translation>Klicken Sie auf die Nadelspitze</translation>
    </message>
    <message>
        <source>Click the other end</source>
        <translation>Klicken Sie das andere Ende an</translation>
    </message>
    <message>
        <source>Click the place of the note (Shift+A: not now)</source>
        <translation>Klicken Sie auf die Stelle der Notiz (Umschalt+A: doch nicht)</translation>
    </message>
    <message>
        <source>Click what is no cell</source>
        <translation>Klicken Sie auf das, was keine Zelle ist</translation>
    </message>
    <message>
        <source>Click: forces on a node</source>
        <translation>Klick: Kräfte an einem Knoten</translation>
    </message>
    <message>
        <source>Cliff's delta against the first</source>
        <translation>Cliffs Delta gegen die erste</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the list</source>
        <translation>Liste schließen</translation>
    </message>
    <message>
        <source>Close the sheet</source>
        <translation>Blatt schließen</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Fenster schließen</translation>
    </message>
    <message>
        <source>Close: nothing typed is kept</source>
        <translation>Schließen: Getipptes wird nicht behalten</translation>
    </message>
    <message>
        <source>Coarse 100:1</source>
        <translation>Grob 100:1</translation>
    </message>
    <message>
        <source>Collapsed</source>
        <translation>Zusammengefallen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare no more</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>Compare with a session</source>
        <translation>Mit einer Sitzung vergleichen</translation>
    </message>
    <message>
        <source>Compare with another session</source>
        <translation>Mit einer anderen Sitzung vergleichen</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Confidence (%)</source>
        <translation>Sicherheit (%)</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Connect a camera</source>
        <translation>Kamera anschließen</translation>
    </message>
    <message>
        <source>Connectors, coloured by their pull</source>
        <translation>Verbindungen, nach ihrem Zug gefärbt</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Contact, </source>
        <translation>Kontakt, </translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Controls and forces</source>
        <translation>Bedienung und Kräfte</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>DEPTH</source>
        <translation>TIEFE</translation>
    </message>
    <message>
        <source>DEPTH SEEN</source>
        <translation>GESEHENE TIEFE</translation>
    </message>
    <message>
        <source>DO</source>
        <translation>AUFGABE</translation>
    </message>
    <message>
        <source>Dampers</source>
        <translation>Dämpfer</translation>
    </message>
    <message>
        <source>Dampers along the connectors; 1 damps the stiffest one critically</source>
        <translation>Dämpfer längs der Verbindungen; 1 dämpft die steifste kritisch</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>Dark lines</source>
        <translation>Dunkle Linien</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>Deposit</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Deposit while held down</source>
        <translation>Gibt ab, solange gedrückt</translation>
    </message>
    <message>
        <source>Depositing</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth at peak (µm)</source>
        <translation>Tiefe beim Höchstwert (µm)</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>Tiefenanschlag</translation>
    </message>
    <message>
        <source>Depth stop </source>
        <translation>Tiefenanschlag </translation>
    </message>
    <message>
        <source>Depth stop set</source>
        <translation>Tiefenanschlag gesetzt</translation>
    </message>
    <message>
        <source>Device lost, pipette held: plug it in or choose another hand</source>
        <translation>Gerät verloren, Pipette gehalten: stecken Sie es ein oder wählen Sie eine andere Hand</translation>
    </message>
    <message>
        <source>Diagonals (X)</source>
        <translation>Diagonalen (X)</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Difference (µN)</source>
        <translation>Differenz (µN)</translation>
    </message>
    <message>
        <source>Difference of the forces</source>
        <translation>Differenz der Kräfte</translation>
    </message>
    <message>
        <source>Disengaged</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Displacement (µm)</source>
        <translation>Verschiebung (µm)</translation>
    </message>
    <message>
        <source>Displacement of a node (µm)</source>
        <translation>Verschiebung eines Knotens (µm)</translation>
    </message>
    <message>
        <source>Displacement of the nodes</source>
        <translation>Verschiebung der Knoten</translation>
    </message>
    <message>
        <source>Display ▾</source>
        <translation>Darstellung ▾</translation>
    </message>
    <message>
        <source>Distance </source>
        <translation>Abstand </translation>
    </message>
    <message>
        <source>Distances and angles</source>
        <translation>Abstände und Winkel</translation>
    </message>
    <message>
        <source>Distances and angles on the image, kept with the session's notes</source>
        <translation>Abstände und Winkel im Bild, aufbewahrt bei den Notizen der Sitzung</translation>
    </message>
    <message>
        <source>Done; a new cell follows</source>
        <translation>Fertig; eine neue Zelle folgt</translation>
    </message>
    <message>
        <source>Doubt, low confidence</source>
        <translation>Zweifel, geringe Sicherheit</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Drag a line along a scale bar, or across a needle whose diameter you know; the longer, the more exact. The wheel zooms, Shift keeps the line level or upright, arrow keys move the end marked by a circle.</source>
        <translation>Eine Linie entlang eines Maßstabsbalkens ziehen oder quer über eine Nadel bekannten Durchmessers; je länger, desto genauer. Das Mausrad vergrößert, mit der Umschalttaste bleibt die Linie waagerecht oder senkrecht, Pfeiltasten bewegen das eingekreiste Ende.</translation>
    </message>
    <message>
        <source>Drag a ring</source>
        <translation>Ring ziehen</translation>
    </message>
    <message>
        <source>Drag once round the cell</source>
        <translation>Ziehen Sie einmal um die Zelle</translation>
    </message>
    <message>
        <source>Drag, wheel</source>
        <translation>Ziehen, Rad</translation>
    </message>
    <message>
        <source>Drag: needle</source>
        <translation>Ziehen: Nadel</translation>
    </message>
    <message>
        <source>Drag: turn</source>
        <translation>Ziehen: drehen</translation>
    </message>
    <message>
        <source>Draw a line of at least 20 px; the longer, the more exact.</source>
        <translation>Ziehen Sie eine Linie von mindestens 20 px; je länger, desto genauer.</translation>
    </message>
    <message>
        <source>Drawing (*.svg);;Page (*.pdf);;Picture (*.png);;Table (*.csv)</source>
        <translation>Zeichnung (*.svg);;Seite (*.pdf);;Bild (*.png);;Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Drawn anew at this size: lines and letters stay sharp.</source>
        <translation>In dieser Größe neu gezeichnet: Linien und Schrift bleiben scharf.</translation>
    </message>
    <message>
        <source>Drawn to</source>
        <translation>Angezogen von</translation>
    </message>
    <message>
        <source>Draws the contour's errors anew</source>
        <translation>Zieht die Fehler der Kontur neu</translation>
    </message>
    <message>
        <source>Draws the snake together and spreads its points evenly</source>
        <translation>Zieht die Snake zusammen und verteilt ihre Punkte gleichmäßig</translation>
    </message>
    <message>
        <source>Drop one file or one folder of this computer.</source>
        <translation>Ziehen Sie eine Datei oder einen Ordner dieses Rechners hierher.</translation>
    </message>
    <message>
        <source>Drop the hints</source>
        <translation>Hinweise verwerfen</translation>
    </message>
    <message>
        <source>ENERGY</source>
        <translation>ENERGIE</translation>
    </message>
    <message>
        <source>EQUILIBRIUM</source>
        <translation>GLEICHGEWICHT</translation>
    </message>
    <message>
        <source>Edge of a pixel</source>
        <translation>Kantenlänge eines Pixels</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Emergency stop: pipette held</source>
        <translation>Nothalt: Pipette gehalten</translation>
    </message>
    <message>
        <source>End it and close</source>
        <translation>Beenden und schließen</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energy over steps</source>
        <translation>Energie über den Schritten</translation>
    </message>
    <message>
        <source>Engaged</source>
        <translation>Gekuppelt</translation>
    </message>
    <message>
        <source>Event before</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Events and doubts</source>
        <translation>Ereignisse und Zweifel</translation>
    </message>
    <message>
        <source>Every node prescribed</source>
        <translation>Jeder Knoten vorgeschrieben</translation>
    </message>
    <message>
        <source>Every push needs four times the force.</source>
        <translation>Jeder Stoß braucht die vierfache Kraft.</translation>
    </message>
    <message>
        <source>Every push needs half the force.</source>
        <translation>Jeder Stoß braucht die halbe Kraft.</translation>
    </message>
    <message>
        <source>Every push needs one and a half times the force.</source>
        <translation>Jeder Stoß braucht die anderthalbfache Kraft.</translation>
    </message>
    <message>
        <source>Every push needs twice the force.</source>
        <translation>Jeder Stoß braucht die doppelte Kraft.</translation>
    </message>
    <message>
        <source>Excess pressure inside the cell, by the model: the push raises it, since the volume stays.</source>
        <translation>Überdruck in der Zelle nach dem Modell: der Stoß erhöht ihn, weil das Volumen bleibt.</translation>
    </message>
    <message>
        <source>Export ▾</source>
        <translation>Export ▾</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Exposure time of the camera</source>
        <translation>Belichtungszeit der Kamera</translation>
    </message>
    <message>
        <source>F1 closes the sheet. Esc does too, and stops the needle.</source>
        <translation>F1 schließt das Blatt. Esc auch, und hält die Nadel an.</translation>
    </message>
    <message>
        <source>F1 or Esc closes the sheet.</source>
        <translation>F1 oder Esc schließt das Blatt.</translation>
    </message>
    <message>
        <source>FARTHEST MOVE</source>
        <translation>WEITESTER WEG</translation>
    </message>
    <message>
        <source>FASTEST NODE</source>
        <translation>SCHNELLSTER KNOTEN</translation>
    </message>
    <message>
        <source>FORCE</source>
        <translation>KRAFT</translation>
    </message>
    <message>
        <source>FORCE OF THE NEEDLE</source>
        <translation>KRAFT DER NADEL</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Faser</translation>
    </message>
    <message>
        <source>File ...</source>
        <translation>Datei ...</translation>
    </message>
    <message>
        <source>File or folder</source>
        <translation>Datei oder Ordner</translation>
    </message>
    <message>
        <source>Finds no rest</source>
        <translation>Kommt nicht zur Ruhe</translation>
    </message>
    <message>
        <source>Fine 500:1</source>
        <translation>Fein 500:1</translation>
    </message>
    <message>
        <source>Finest 2000:1</source>
        <translation>Feinst 2000:1</translation>
    </message>
    <message>
        <source>Finite elements of the aspirated zona …</source>
        <translation>Finite Elemente der angesaugten Zona …</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Folder ...</source>
        <translation>Ordner ...</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufnahmen</translation>
    </message>
    <message>
        <source>Folder for the tables</source>
        <translation>Ordner für die Tabellen</translation>
    </message>
    <message>
        <source>For the last row</source>
        <translation>Für die letzte Reihe</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force (µN)</source>
        <translation>Kraft (µN)</translation>
    </message>
    <message>
        <source>Force at the puncture; without one, the largest</source>
        <translation>Kraft beim Durchstich; ohne ihn die größte</translation>
    </message>
    <message>
        <source>Force in doubt: </source>
        <translation>Kraft zweifelhaft: </translation>
    </message>
    <message>
        <source>Force of a node (µN)</source>
        <translation>Kraft eines Knotens (µN)</translation>
    </message>
    <message>
        <source>Force of the needle on the cell against that at which a cell of this kind and these sizes is expected to give way. Light band: the whole 95 % interval; dark band: what the picture leaves open.</source>
        <translation>Kraft der Nadel auf die Zelle, gemessen an jener, bei der eine Zelle dieser Art und dieser Maße voraussichtlich nachgibt. Helles Band: das ganze 95-%-Intervall; dunkles Band: was das Bild offen lässt.</translation>
    </message>
    <message>
        <source>Force of the needle on the cell against the largest that the hand is let exert. Light band: the whole 95 % interval; dark band: what the picture leaves open. Fine mark: where a cell of this kind and these sizes is expected to give way.</source>
        <translation>Kraft der Nadel auf die Zelle, gemessen an der größten, die der Hand erlaubt ist. Helles Band: das ganze 95-%-Intervall; dunkles Band: was das Bild offen lässt. Feine Marke: wo eine Zelle dieser Art und dieser Maße voraussichtlich nachgibt.</translation>
    </message>
    <message>
        <source>Force of the needle on the cell, along the needle, with its 95 % interval: the whole.
Picture: what depth, sizes and model leave open (standard deviation); it is all there is between two forces on one cell.
</source>
        <translation>Kraft der Nadel auf die Zelle, längs der Nadel, mit ihrem ganzen 95-%-Intervall.
Bild: was Tiefe, Maße und Modell offen lassen (Standardabweichung); zwischen zwei Kräften an derselben Zelle zählt nur dies.
</translation>
    </message>
    <message>
        <source>Force of the nodes</source>
        <translation>Kraft der Knoten</translation>
    </message>
    <message>
        <source>Force on the hand; full: the largest force of the device</source>
        <translation>Kraft auf die Hand; voll: die größte Kraft des Geräts</translation>
    </message>
    <message>
        <source>Force over depth</source>
        <translation>Kraft über der Tiefe</translation>
    </message>
    <message>
        <source>Force over indentation</source>
        <translation>Kraft über der Eindellung</translation>
    </message>
    <message>
        <source>Force over time</source>
        <translation>Kraft über der Zeit</translation>
    </message>
    <message>
        <source>Force over time as SVG, PDF, PNG or CSV</source>
        <translation>Kraft über der Zeit als SVG, PDF, PNG oder CSV</translation>
    </message>
    <message>
        <source>Force too old: released</source>
        <translation>Kraft zu alt: freigegeben</translation>
    </message>
    <message>
        <source>Force, µN</source>
        <translation>Kraft, µN</translation>
    </message>
    <message>
        <source>Forces in 3-D</source>
        <translation>Kräfte in 3-D</translation>
    </message>
    <message>
        <source>Forces on a node</source>
        <translation>Kräfte an einem Knoten</translation>
    </message>
    <message>
        <source>Forget this cell's own scale: for another cell</source>
        <translation>Vergisst die eigene Skala dieser Zelle: für eine andere Zelle</translation>
    </message>
    <message>
        <source>Four times as stiff</source>
        <translation>Viermal so steif</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame age </source>
        <translation>Bildalter </translation>
    </message>
    <message>
        <source>Frame age 0000 ms</source>
        <translation>Bildalter 0000 ms</translation>
    </message>
    <message>
        <source>Frame age –</source>
        <translation>Bildalter –</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Frames a second that were measured, and that this window has drawn</source>
        <translation>Bilder je Sekunde, die gemessen und von diesem Fenster gezeichnet wurden</translation>
    </message>
    <message>
        <source>Frames that were not measured, that the source lost, or that are recorded in part</source>
        <translation>Bilder, die nicht gemessen, von der Quelle verloren oder nur zum Teil aufgezeichnet wurden</translation>
    </message>
    <message>
        <source>Frames/s: </source>
        <translation>Bilder/s: </translation>
    </message>
    <message>
        <source>Frames/s: 000.0 measured, 000.0 drawn</source>
        <translation>Bilder/s: 000.0 gemessen, 000.0 gezeichnet</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Free, </source>
        <translation>Frei, </translation>
    </message>
    <message>
        <source>From a frame's arrival to its force on screen</source>
        <translation>Von der Ankunft eines Bildes bis zu seiner Kraft auf dem Schirm</translation>
    </message>
    <message>
        <source>From the end on from the beginning</source>
        <translation>Vom Ende wieder an den Anfang</translation>
    </message>
    <message>
        <source>From the lesson's beginning</source>
        <translation>Vom Anfang der Lektion an</translation>
    </message>
    <message>
        <source>From the tip to the plan's target, along the planned way, with the 95 % interval of the tip. The mark is the target, the fine one beyond it the depth stop.</source>
        <translation>Von der Spitze zum Ziel des Plans, längs des geplanten Wegs, mit dem 95-%-Intervall der Spitze. Die Marke ist das Ziel, die feine dahinter der Tiefenanschlag.</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Give of the hand</source>
        <translation>Nachgiebigkeit der Hand</translation>
    </message>
    <message>
        <source>Go on recording</source>
        <translation>Weiter aufnehmen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Groups by </source>
        <translation>Gruppen nach </translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Guided</source>
        <translation>Geführt</translation>
    </message>
    <message>
        <source>HAND</source>
        <translation>HAND</translation>
    </message>
    <message>
        <source>Half as stiff</source>
        <translation>Halb so steif</translation>
    </message>
    <message>
        <source>Half the 95 % interval (µN)</source>
        <translation>Halbes 95-%-Intervall (µN)</translation>
    </message>
    <message>
        <source>Half-width of the force's interval</source>
        <translation>Halbe Breite des Intervalls der Kraft</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Hedges' g against the first</source>
        <translation>Hedges’ g gegen die erste</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Here is the holding pipette</source>
        <translation>Hier ist die Haltepipette</translation>
    </message>
    <message>
        <source>Here is the tip</source>
        <translation>Hier ist die Spitze</translation>
    </message>
    <message>
        <source>Hide below</source>
        <translation>Ausblenden unter</translation>
    </message>
    <message>
        <source>Hinges</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Hint ▾</source>
        <translation>Hinweis ▾</translation>
    </message>
    <message>
        <source>Hint: </source>
        <translation>Hinweis: </translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Histogram: </source>
        <translation>Histogramm: </translation>
    </message>
    <message>
        <source>Hold for a second to release the emergency stop</source>
        <translation>Eine Sekunde halten, um den Nothalt zu lösen</translation>
    </message>
    <message>
        <source>Hold the left button to move the needle</source>
        <translation>Linke Taste halten, um die Nadel zu bewegen</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Haltepipette</translation>
    </message>
    <message>
        <source>Holder on membrane (µN)</source>
        <translation>Haltepipette auf Membran (µN)</translation>
    </message>
    <message>
        <source>Holding pipette</source>
        <translation>Haltepipette</translation>
    </message>
    <message>
        <source>How eq. (2) is stepped through time</source>
        <translation>Wie Gl. (2) durch die Zeit geführt wird</translation>
    </message>
    <message>
        <source>How far each place of the tracked surface is from where it was at rest.</source>
        <translation>Wie weit jede Stelle der verfolgten Oberfläche von ihrem Ort in Ruhe entfernt ist.</translation>
    </message>
    <message>
        <source>How far the needle has pushed the outer membrane in, along the needle, from where it was at rest.</source>
        <translation>Wie weit die Nadel die äußere Membran eingedrückt hat, längs der Nadel, von ihrer Ruhelage aus.</translation>
    </message>
    <message>
        <source>How far the tip is out of the image plane, as the manipulator reports it: above 0 behind it, away from you; below 0 before it</source>
        <translation>Wie weit die Spitze außerhalb der Bildebene liegt, wie der Manipulator meldet: über 0 dahinter, von Ihnen weg; unter 0 davor</translation>
    </message>
    <message>
        <source>How far the tip stays behind the hand for each µN</source>
        <translation>Wie weit die Spitze je µN hinter der Hand bleibt</translation>
    </message>
    <message>
        <source>How much of the image is shown, and how bright: the measurement stays the same</source>
        <translation>Wie viel vom Bild gezeigt wird und wie hell: die Messung bleibt gleich</translation>
    </message>
    <message>
        <source>How often this window was busy for more than %1 ms, in the last %2 s; the longest ended after %3 s.
Meanwhile keys and clicks wait. The emergency stop, the hand and the recording do not.</source>
        <translation>Wie oft dieses Fenster länger als %1 ms beschäftigt war, in den letzten %2 s; das längste Mal endete nach %3 s.
Solange warten Tasten und Klicks. Not-Halt, Hand und Aufzeichnung warten nicht.</translation>
    </message>
    <message>
        <source>How sure the tracking is of cell and needle in this frame. Below 50 % look at the image before you use a number.</source>
        <translation>Wie sicher die Bildverfolgung in diesem Bild bei Zelle und Nadel ist. Unter 50 % sehen Sie sich das Bild an, bevor Sie eine Zahl verwenden.</translation>
    </message>
    <message>
        <source>How the contact with the cell ended</source>
        <translation>Wie der Kontakt mit der Zelle endete</translation>
    </message>
    <message>
        <source>How the liquid inside pushes outwards on each node's share of the membrane. All together the arrows add up to zero.</source>
        <translation>Wie die Flüssigkeit im Inneren den Membrananteil jedes Knotens nach außen drückt. Alle Pfeile zusammen ergeben null.</translation>
    </message>
    <message>
        <source>How the stretched membrane pulls on its own points. It balances pressure and tools, so on a taut cell it points inwards although nothing pushes from outside. At rest it is zero: this is also its change from rest.</source>
        <translation>Wie die gespannte Membran an ihren eigenen Punkten zieht. Sie hält Druck und Werkzeugen das Gleichgewicht und zeigt bei einer prallen Zelle nach innen, obwohl nichts von außen drückt. In Ruhe ist sie null: Dies ist auch ihre Änderung gegenüber der Ruhe.</translation>
    </message>
    <message>
        <source>Hysteresis (pJ)</source>
        <translation>Hysterese (pJ)</translation>
    </message>
    <message>
        <source>IMAGE</source>
        <translation>BILD</translation>
    </message>
    <message>
        <source>IN DOUBT</source>
        <translation>ZWEIFELHAFT</translation>
    </message>
    <message>
        <source>INDENTATION</source>
        <translation>EINDELLUNG</translation>
    </message>
    <message>
        <source>Image with a line</source>
        <translation>Bild mit einer Linie</translation>
    </message>
    <message>
        <source>Image ▾</source>
        <translation>Bild ▾</translation>
    </message>
    <message>
        <source>Images along the session's time</source>
        <translation>Bilder längs der Zeit der Sitzung</translation>
    </message>
    <message>
        <source>Implicit Euler</source>
        <translation>Implizites Euler-Verfahren</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>In Kontakt</translation>
    </message>
    <message>
        <source>In equilibrium</source>
        <translation>Im Gleichgewicht</translation>
    </message>
    <message>
        <source>In the virtual microscope: scenario %1</source>
        <translation>Im virtuellen Mikroskop: Szenario %1</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Eindellung</translation>
    </message>
    <message>
        <source>Indentation (µm)</source>
        <translation>Eindellung (µm)</translation>
    </message>
    <message>
        <source>Indentation at that force</source>
        <translation>Eindellung bei dieser Kraft</translation>
    </message>
    <message>
        <source>Indentation of the cell</source>
        <translation>Eindellung der Zelle</translation>
    </message>
    <message>
        <source>Indentation of the cell with its 95 % interval; once the membrane gave way, how far the tip is beyond the entry. The mark is the nearer of the hand's limit and the plan's depth stop.</source>
        <translation>Eindellung der Zelle mit ihrem 95-%-Intervall; sobald die Membran nachgab: wie weit die Spitze hinter dem Eintritt ist. Die Marke ist die nähere von Grenze der Hand und Tiefenanschlag des Plans.</translation>
    </message>
    <message>
        <source>Inertia, −m a</source>
        <translation>Trägheit, −m a</translation>
    </message>
    <message>
        <source>Inner membrane</source>
        <translation>Innere Membran</translation>
    </message>
    <message>
        <source>Inner radius of the mouth</source>
        <translation>Innenradius der Mündung</translation>
    </message>
    <message>
        <source>Inserting</source>
        <translation>Einführen</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrator</translation>
    </message>
    <message>
        <source>Invalid readings from the device: pipette held</source>
        <translation>Ungültige Messwerte des Geräts: Pipette gehalten</translation>
    </message>
    <message>
        <source>Its length</source>
        <translation>Ihre Länge</translation>
    </message>
    <message>
        <source>Keep the newest frame on screen</source>
        <translation>Hält das neueste Bild fest</translation>
    </message>
    <message>
        <source>Keep the tip on the planned line, in and out</source>
        <translation>Hält die Spitze auf der geplanten Linie, hinein und hinaus</translation>
    </message>
    <message>
        <source>Keeps the snake smooth; too much cuts across the dimple</source>
        <translation>Hält die Snake glatt; zu viel schneidet die Delle ab</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys of this window</source>
        <translation>Tasten dieses Fensters</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Kind of cell </source>
        <translation>Zellart </translation>
    </message>
    <message>
        <source>Kind of cell: how single cells of this kind differ in stiffness, one factor on all forces of this cell. Measuring its scale reduces it.</source>
        <translation>Zellart: wie verschieden steif einzelne Zellen dieser Art sind, ein gemeinsamer Faktor aller Kräfte dieser Zelle. Das Messen ihrer Skala verringert es.</translation>
    </message>
    <message>
        <source>Language of the system</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>Large letters</source>
        <translation>Große Schrift</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Left chart as SVG, PDF, PNG or CSV</source>
        <translation>Linkes Diagramm als SVG, PDF, PNG oder CSV</translation>
    </message>
    <message>
        <source>Left the picture</source>
        <translation>Bild verlassen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Lengths by the logarithm</source>
        <translation>Längen logarithmisch</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Lesson before</source>
        <translation>Vorige Lektion</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Lessons about cells, contours and forces</source>
        <translation>Lektionen über Zellen, Konturen und Kräfte</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Helles Farbschema</translation>
    </message>
    <message>
        <source>Limit: </source>
        <translation>Grenze: </translation>
    </message>
    <message>
        <source>Linear acceleration (Newmark)</source>
        <translation>Lineare Beschleunigung (Newmark)</translation>
    </message>
    <message>
        <source>Liquid keeps its volume</source>
        <translation>Flüssigkeit behält ihr Volumen</translation>
    </message>
    <message>
        <source>List of cells saved: </source>
        <translation>Liste der Zellen gespeichert: </translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Belastung</translation>
    </message>
    <message>
        <source>Look ▾</source>
        <translation>Ansicht ▾</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Hinsehen</translation>
    </message>
    <message>
        <source>Looking at it ...</source>
        <translation>Wird angesehen ...</translation>
    </message>
    <message>
        <source>Looking for sessions ...</source>
        <translation>Sitzungen werden gesucht ...</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Magnification from the specimen to the camera, the adapter's included</source>
        <translation>Vergrößerung vom Präparat zur Kamera, die des Adapters eingeschlossen</translation>
    </message>
    <message>
        <source>Manipulator lost: check its cable and power</source>
        <translation>Manipulator verloren: prüfen Sie Kabel und Stromversorgung</translation>
    </message>
    <message>
        <source>Mass of a node</source>
        <translation>Masse eines Knotens</translation>
    </message>
    <message>
        <source>Mean tension of the membrane, from the model: red is stretched, blue compressed, grey zero.</source>
        <translation>Mittlere Spannung der Membran, nach dem Modell: Rot ist gedehnt, Blau gestaucht, Grau null.</translation>
    </message>
    <message>
        <source>Measure a pixel</source>
        <translation>Pixel ausmessen</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measure how stiff this cell is, so that the forces are its own</source>
        <translation>Misst, wie steif diese Zelle ist, sodass die Kräfte ihre eigenen sind</translation>
    </message>
    <message>
        <source>Measure on the image ...</source>
        <translation>Im Bild messen ...</translation>
    </message>
    <message>
        <source>Measure ▾</source>
        <translation>Messen ▾</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Measured: %1</source>
        <translation>Gemessen: %1</translation>
    </message>
    <message>
        <source>Measures the session once more with these hints, into a new session, and opens it</source>
        <translation>Misst die Sitzung mit diesen Hinweisen noch einmal, in eine neue Sitzung, und öffnet diese</translation>
    </message>
    <message>
        <source>Measuring again</source>
        <translation>Wird neu gemessen</translation>
    </message>
    <message>
        <source>Median (quartiles), number</source>
        <translation>Median (Quartile), Anzahl</translation>
    </message>
    <message>
        <source>Membrane resultant</source>
        <translation>Resultierende der Membran</translation>
    </message>
    <message>
        <source>Membrane resultant (µN)</source>
        <translation>Resultierende der Membran (µN)</translation>
    </message>
    <message>
        <source>Membranes found in the image</source>
        <translation>Im Bild gefundene Membranen</translation>
    </message>
    <message>
        <source>Meridian springs</source>
        <translation>Meridianfedern</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Microscope</source>
        <translation>Mikroskop</translation>
    </message>
    <message>
        <source>Microscope image as PNG</source>
        <translation>Mikroskopbild als PNG</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Model section</source>
        <translation>Modellschnitt</translation>
    </message>
    <message>
        <source>Model, profile's cell</source>
        <translation>Modell, Zelle des Profils</translation>
    </message>
    <message>
        <source>Model, this cell's sizes</source>
        <translation>Modell, Maße dieser Zelle</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>Most arrows</source>
        <translation>Höchstens Pfeile</translation>
    </message>
    <message>
        <source>Motion of the tip: 100:1 is 100 µm for 10 mm of the hand</source>
        <translation>Bewegung der Spitze: 100:1 heißt 100 µm je 10 mm der Hand</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Move target, entry or depth stop of the plan</source>
        <translation>Ziel, Eintritt oder Tiefenanschlag des Plans verschieben</translation>
    </message>
    <message>
        <source>Move the circle, or its rim; elsewhere place it</source>
        <translation>Den Kreis oder seinen Rand bewegen; anderswo ihn setzen</translation>
    </message>
    <message>
        <source>Move the image, zoom</source>
        <translation>Bild verschieben, vergrößern</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>NEEDLE NOT SEEN</source>
        <translation>NADEL NICHT ZU SEHEN</translation>
    </message>
    <message>
        <source>NO FORCE</source>
        <translation>KEINE KRAFT</translation>
    </message>
    <message>
        <source>Name of the cell in view</source>
        <translation>Name der Zelle im Bild</translation>
    </message>
    <message>
        <source>Name the cell in view</source>
        <translation>Die Zelle im Bild benennen</translation>
    </message>
    <message>
        <source>Name, or number in this run</source>
        <translation>Name, oder Nummer in diesem Lauf</translation>
    </message>
    <message>
        <source>Name; Enter takes it</source>
        <translation>Name; Eingabe übernimmt ihn</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Needle </source>
        <translation>Nadel </translation>
    </message>
    <message>
        <source>Needle and holding pipette</source>
        <translation>Nadel und Haltepipette</translation>
    </message>
    <message>
        <source>Needle on membrane (µN)</source>
        <translation>Nadel auf Membran (µN)</translation>
    </message>
    <message>
        <source>Needle or circle down by 1 µm</source>
        <translation>Nadel oder Kreis um 1 µm nach unten</translation>
    </message>
    <message>
        <source>Needle or circle to the left by 1 µm</source>
        <translation>Nadel oder Kreis um 1 µm nach links</translation>
    </message>
    <message>
        <source>Needle or circle to the right by 1 µm</source>
        <translation>Nadel oder Kreis um 1 µm nach rechts</translation>
    </message>
    <message>
        <source>Needle or circle up by 1 µm</source>
        <translation>Nadel oder Kreis um 1 µm nach oben</translation>
    </message>
    <message>
        <source>New cell</source>
        <translation>Neue Zelle</translation>
    </message>
    <message>
        <source>New note at </source>
        <translation>Neue Notiz: </translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>Nächste Lektion</translation>
    </message>
    <message>
        <source>Next note of this frame</source>
        <translation>Nächste Notiz dieses Bildes</translation>
    </message>
    <message>
        <source>No camera</source>
        <translation>Keine Kamera</translation>
    </message>
    <message>
        <source>No camera can be used: </source>
        <translation>Keine Kamera verwendbar: </translation>
    </message>
    <message>
        <source>No cell</source>
        <translation>Keine Zelle</translation>
    </message>
    <message>
        <source>No cell in sight</source>
        <translation>Keine Zelle in Sicht</translation>
    </message>
    <message>
        <source>No force at the same place in both</source>
        <translation>Keine Kraft an gleicher Stelle in beiden</translation>
    </message>
    <message>
        <source>No force feedback</source>
        <translation>Keine Kraftrückgabe</translation>
    </message>
    <message>
        <source>No force in this session</source>
        <translation>Keine Kraft in dieser Sitzung</translation>
    </message>
    <message>
        <source>No force measured yet</source>
        <translation>Noch keine Kraft gemessen</translation>
    </message>
    <message>
        <source>No force measured: released</source>
        <translation>Keine Kraft gemessen: freigegeben</translation>
    </message>
    <message>
        <source>No force: </source>
        <translation>Keine Kraft: </translation>
    </message>
    <message>
        <source>No frame at the same place</source>
        <translation>Kein Bild an gleicher Stelle</translation>
    </message>
    <message>
        <source>No frame has this number</source>
        <translation>Kein Bild hat diese Zahl</translation>
    </message>
    <message>
        <source>No frame of this session has such a number</source>
        <translation>Kein Bild dieser Sitzung hat eine solche Zahl</translation>
    </message>
    <message>
        <source>No frame yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>No image of this frame</source>
        <translation>Kein Mikroskopbild zu diesem Bild</translation>
    </message>
    <message>
        <source>No meridian: this frame has no surface with its rest directions</source>
        <translation>Kein Meridian: diesem Bild fehlt die Oberfläche mit ihren Ruherichtungen</translation>
    </message>
    <message>
        <source>No node</source>
        <translation>Kein Knoten</translation>
    </message>
    <message>
        <source>No node has this number</source>
        <translation>Kein Knoten hat diese Zahl</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>No surface at the same place</source>
        <translation>Keine Oberfläche an gleicher Stelle</translation>
    </message>
    <message>
        <source>No surface of this frame</source>
        <translation>Keine Oberfläche zu diesem Bild</translation>
    </message>
    <message>
        <source>No surface: the contour can't be revolved</source>
        <translation>Keine Oberfläche: die Kontur lässt sich nicht rotieren</translation>
    </message>
    <message>
        <source>No. </source>
        <translation>Nein. </translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>Knoten %1</translation>
    </message>
    <message>
        <source>Node %1. z: the needle's axis, outwards. The residual is the error of the time step.</source>
        <translation>Knoten %1. z: die Achse der Nadel, nach außen. Der Rest ist der Fehler des Zeitschritts.</translation>
    </message>
    <message>
        <source>Node force (µN)</source>
        <translation>Knotenkraft (µN)</translation>
    </message>
    <message>
        <source>Node forces</source>
        <translation>Knotenkräfte</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Nodes of the network; the profile's constants hold for its own mesh of 812</source>
        <translation>Knoten des Netzes; die Konstanten des Profils gelten für sein eigenes Netz mit 812</translation>
    </message>
    <message>
        <source>Noise of the contour</source>
        <translation>Rauschen der Kontur</translation>
    </message>
    <message>
        <source>None yet: what you record is kept in </source>
        <translation>Noch keine: was Sie aufnehmen, wird abgelegt in </translation>
    </message>
    <message>
        <source>None: I type the pixel size</source>
        <translation>Keines: ich gebe die Pixelgröße ein</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Keine Aufnahme</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Note at </source>
        <translation>Notiz: </translation>
    </message>
    <message>
        <source>Note changed</source>
        <translation>Notiz geändert</translation>
    </message>
    <message>
        <source>Note deleted; Ctrl+Z brings it back</source>
        <translation>Notiz gelöscht; Strg+Z holt sie zurück</translation>
    </message>
    <message>
        <source>Note kept</source>
        <translation>Notiz behalten</translation>
    </message>
    <message>
        <source>Note written into the recording</source>
        <translation>Notiz in die Aufnahme geschrieben</translation>
    </message>
    <message>
        <source>Note ▾</source>
        <translation>Notiz ▾</translation>
    </message>
    <message>
        <source>Nothing is recording: the note goes into the next recording</source>
        <translation>Es läuft keine Aufnahme: die Notiz kommt in die nächste</translation>
    </message>
    <message>
        <source>OBSERVE</source>
        <translation>BEOBACHTUNG</translation>
    </message>
    <message>
        <source>OLD: </source>
        <translation>ALT: </translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Of each of its points, along its normal</source>
        <translation>Jedes ihrer Punkte, längs der Normalen</translation>
    </message>
    <message>
        <source>Of the circle that the snake begins on</source>
        <translation>Des Kreises, auf dem die Snake beginnt</translation>
    </message>
    <message>
        <source>Of the image: more is felt from farther away, and less sharply</source>
        <translation>Des Bildes: mehr wirkt von weiter her und weniger scharf</translation>
    </message>
    <message>
        <source>Of the integrator</source>
        <translation>Des Integrators</translation>
    </message>
    <message>
        <source>Of the needle</source>
        <translation>Der Nadel</translation>
    </message>
    <message>
        <source>Of the virtual microscope, or recorded</source>
        <translation>Des virtuellen Mikroskops oder aufgezeichnet</translation>
    </message>
    <message>
        <source>Of the zona; scales every force and no shape</source>
        <translation>Der Zona; skaliert jede Kraft und keine Form</translation>
    </message>
    <message>
        <source>On the screen alone: the measurement stays the same.</source>
        <translation>Nur auf dem Schirm: die Messung bleibt gleich.</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>One step</source>
        <translation>Ein Schritt</translation>
    </message>
    <message>
        <source>Oolemma</source>
        <translation>Oolemm</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Open a recording or a video</source>
        <translation>Aufzeichnung oder Video öffnen</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open another session</source>
        <translation>Eine andere Sitzung öffnen</translation>
    </message>
    <message>
        <source>Opening </source>
        <translation>Wird geöffnet: </translation>
    </message>
    <message>
        <source>Other noise</source>
        <translation>Anderes Rauschen</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Outer membrane</source>
        <translation>Äußere Membran</translation>
    </message>
    <message>
        <source>Over the session's time, or along the node's meridian in this frame</source>
        <translation>Über der Zeit der Sitzung oder längs des Meridians des Knotens in diesem Bild</translation>
    </message>
    <message>
        <source>PAST THE DEPTH STOP</source>
        <translation>HINTER DEM TIEFENANSCHLAG</translation>
    </message>
    <message>
        <source>PRESCRIBED</source>
        <translation>VORGESCHRIEBEN</translation>
    </message>
    <message>
        <source>PRESSURE</source>
        <translation>DRUCK</translation>
    </message>
    <message>
        <source>PUNCTURE</source>
        <translation>DURCHSTICH</translation>
    </message>
    <message>
        <source>PUNCTURE LIKELY</source>
        <translation>DURCHSTICH WAHRSCHEINLICH</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Seite (*.html)</translation>
    </message>
    <message>
        <source>Parallel springs</source>
        <translation>Parallelkreisfedern</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Peak force (µN)</source>
        <translation>Höchste Kraft (µN)</translation>
    </message>
    <message>
        <source>Pellucida - </source>
        <translation>Pellucida - </translation>
    </message>
    <message>
        <source>Pellucida - Cells of several sessions</source>
        <translation>Pellucida - Zellen mehrerer Sitzungen</translation>
    </message>
    <message>
        <source>Pellucida - Review</source>
        <translation>Pellucida - Auswertung</translation>
    </message>
    <message>
        <source>Pellucida - Review of </source>
        <translation>Pellucida - Auswertung von </translation>
    </message>
    <message>
        <source>Pellucida - Start</source>
        <translation>Pellucida - Start</translation>
    </message>
    <message>
        <source>Pellucida, teach</source>
        <translation>Pellucida, Lehre</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>Pictures, charts, tables and the report of this session</source>
        <translation>Bilder, Diagramme, Tabellen und der Bericht dieser Sitzung</translation>
    </message>
    <message>
        <source>Pixel in the specimen</source>
        <translation>Pixel im Präparat</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Plan ▾</source>
        <translation>Plan ▾</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>Rückwärts abspielen</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Point at what the tracking took for something else: it goes on from there</source>
        <translation>Zeigen Sie, was die Bildverfolgung verwechselt hat: sie macht von dort weiter</translation>
    </message>
    <message>
        <source>Poor camera, a dimple</source>
        <translation>Schlechte Kamera, Delle</translation>
    </message>
    <message>
        <source>Preparing the picture</source>
        <translation>Das Bild wird vorbereitet</translation>
    </message>
    <message>
        <source>Prescribed: close</source>
        <translation>Vorgeschrieben: nahe</translation>
    </message>
    <message>
        <source>Prescribed: wrong</source>
        <translation>Vorgeschrieben: falsch</translation>
    </message>
    <message>
        <source>Press %1 to choose this card</source>
        <translation>Drücken Sie %1, um diese Karte zu wählen</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Pressure (Pa)</source>
        <translation>Druck (Pa)</translation>
    </message>
    <message>
        <source>Pressure on membrane (µN)</source>
        <translation>Druck auf Membran (µN)</translation>
    </message>
    <message>
        <source>Profile of the cell</source>
        <translation>Profil der Zelle</translation>
    </message>
    <message>
        <source>Pull of a connector (µN)</source>
        <translation>Zug einer Verbindung (µN)</translation>
    </message>
    <message>
        <source>Puncture depth (µm)</source>
        <translation>Tiefe beim Durchstich (µm)</translation>
    </message>
    <message>
        <source>Puncture force (µN)</source>
        <translation>Kraft beim Durchstich (µN)</translation>
    </message>
    <message>
        <source>Puncture work (pJ)</source>
        <translation>Arbeit bis zum Durchstich (pJ)</translation>
    </message>
    <message>
        <source>Punctured</source>
        <translation>Durchstochen</translation>
    </message>
    <message>
        <source>Punctured, </source>
        <translation>Durchstochen, </translation>
    </message>
    <message>
        <source>Punctured, 000 ms old</source>
        <translation>Durchstochen, 000 ms alt</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Stoß</translation>
    </message>
    <message>
        <source>QUESTION</source>
        <translation>FRAGE</translation>
    </message>
    <message>
        <source>Quantity of the node</source>
        <translation>Größe des Knotens</translation>
    </message>
    <message>
        <source>Radius at the start</source>
        <translation>Radius am Anfang</translation>
    </message>
    <message>
        <source>Reading </source>
        <translation>Liest </translation>
    </message>
    <message>
        <source>Reading an image ...</source>
        <translation>Bild wird gelesen ...</translation>
    </message>
    <message>
        <source>Reading the session</source>
        <translation>Die Sitzung wird gelesen</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Recorded in </source>
        <translation>Aufgezeichnet in </translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording paused, </source>
        <translation>Aufnahme angehalten, </translation>
    </message>
    <message>
        <source>Recording to </source>
        <translation>Aufnahme nach </translation>
    </message>
    <message>
        <source>Recordings in</source>
        <translation>Aufnahmen in</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the plan's change</source>
        <translation>Änderung des Plans wiederholen</translation>
    </message>
    <message>
        <source>Release
(hold)</source>
        <translation>Lösen
(halten)</translation>
    </message>
    <message>
        <source>Replace?</source>
        <translation>Ersetzen?</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Report written: </source>
        <translation>Bericht geschrieben: </translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Review a recorded session</source>
        <translation>Aufgezeichnete Sitzung auswerten</translation>
    </message>
    <message>
        <source>Review the session of </source>
        <translation>Auswertung der Sitzung vom </translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Rechts ziehen, Rad</translation>
    </message>
    <message>
        <source>Right drag: turn</source>
        <translation>Rechts ziehen: drehen</translation>
    </message>
    <message>
        <source>Right. </source>
        <translation>Richtig. </translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Laufen</translation>
    </message>
    <message>
        <source>S: one step. R: run.</source>
        <translation>S: ein Schritt. R: laufen.</translation>
    </message>
    <message>
        <source>SCALE</source>
        <translation>SKALA</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>TEMPO</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>SCHRITT</translation>
    </message>
    <message>
        <source>STEPS, PACE</source>
        <translation>SCHRITTE, TEMPO</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>GESTOPPT</translation>
    </message>
    <message>
        <source>STRETCHING</source>
        <translation>DEHNUNG</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>Als CSV speichern</translation>
    </message>
    <message>
        <source>Save the difference as SVG, PDF or PNG</source>
        <translation>Die Differenz als SVG, PDF oder PNG speichern</translation>
    </message>
    <message>
        <source>Save the difference as a table</source>
        <translation>Die Differenz als Tabelle speichern</translation>
    </message>
    <message>
        <source>Save the window as a picture</source>
        <translation>Speichert das Fenster als Bild</translation>
    </message>
    <message>
        <source>Saved </source>
        <translation>Gespeichert: </translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Scale grew, was </source>
        <translation>Skala gewachsen, war </translation>
    </message>
    <message>
        <source>Scale of this cell</source>
        <translation>Skala dieser Zelle</translation>
    </message>
    <message>
        <source>Scale: </source>
        <translation>Skala: </translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Screenshot</source>
        <translation>Bildschirmfoto</translation>
    </message>
    <message>
        <source>Screenshot saved: </source>
        <translation>Bildschirmfoto gespeichert: </translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Section through the mechanical model</source>
        <translation>Schnitt durch das mechanische Modell</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Set the target</source>
        <translation>Ziel setzen</translation>
    </message>
    <message>
        <source>Set up again</source>
        <translation>Neu aufbauen</translation>
    </message>
    <message>
        <source>Show node forces</source>
        <translation>Knotenkräfte zeigen</translation>
    </message>
    <message>
        <source>Show or hide the arrows</source>
        <translation>Pfeile zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Show the events and doubts beside the views</source>
        <translation>Zeigt Ereignisse und Zweifel neben den Ansichten</translation>
    </message>
    <message>
        <source>Show the plan</source>
        <translation>Plan zeigen</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>Sigma of a node's force (µN)</source>
        <translation>Sigma der Kraft eines Knotens (µN)</translation>
    </message>
    <message>
        <source>Sigma of the nodes' forces</source>
        <translation>Sigma der Kräfte der Knoten</translation>
    </message>
    <message>
        <source>Simulated seconds a second, at most: slow motion</source>
        <translation>Simulierte Sekunden je Sekunde, höchstens: Zeitlupe</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>Größe des Bildes</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Snake</translation>
    </message>
    <message>
        <source>Sounds at contact, puncture and alarms</source>
        <translation>Töne bei Kontakt, Durchstich und Alarmen</translation>
    </message>
    <message>
        <source>Space plays, arrow keys step, a press on the timeline or on force over time seeks, a click on the membrane picks a node</source>
        <translation>Leertaste spielt ab, Pfeiltasten gehen Bild für Bild, ein Druck auf die Zeitleiste oder auf die Kraft über der Zeit springt dorthin, ein Klick auf die Membran wählt einen Knoten</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of the tip, as its manipulator reports it, else as it is seen. The mark is the largest speed of the hand: in contact, that of the push.</source>
        <translation>Geschwindigkeit der Spitze, wie ihr Manipulator sie meldet, sonst wie sie zu sehen ist. Die Marke ist die größte Geschwindigkeit der Hand: in Kontakt die des Stoßes.</translation>
    </message>
    <message>
        <source>Speed: times the session's own</source>
        <translation>Tempo: Vielfaches der Aufzeichnung</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Start page: choose another source, session or lesson</source>
        <translation>Startseite: andere Quelle, Sitzung oder Lektion wählen</translation>
    </message>
    <message>
        <source>Start the chosen card, or press the button that has the focus</source>
        <translation>Gewählte Karte starten, oder die Schaltfläche mit dem Fokus drücken</translation>
    </message>
    <message>
        <source>Start the source again from its first frame</source>
        <translation>Beginnt die Quelle wieder bei ihrem ersten Bild</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Steps a second while it runs</source>
        <translation>Schritte je Sekunde, während sie läuft</translation>
    </message>
    <message>
        <source>Steps until it rests, or until it is stopped</source>
        <translation>Schritte, bis sie ruht oder angehalten wird</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Stiffness (µN/µm)</source>
        <translation>Steifigkeit (µN/µm)</translation>
    </message>
    <message>
        <source>Stiffness at 10 µm (µN/µm)</source>
        <translation>Steifigkeit bei 10 µm (µN/µm)</translation>
    </message>
    <message>
        <source>Stiffness at 20 µm (µN/µm)</source>
        <translation>Steifigkeit bei 20 µm (µN/µm)</translation>
    </message>
    <message>
        <source>Stiffness at 30 µm (µN/µm)</source>
        <translation>Steifigkeit bei 30 µm (µN/µm)</translation>
    </message>
    <message>
        <source>Stiffness of the cell</source>
        <translation>Steifigkeit der Zelle</translation>
    </message>
    <message>
        <source>Stiffness of the fibre</source>
        <translation>Steifigkeit der Faser</translation>
    </message>
    <message>
        <source>Stop the pipette and release the force on the hand at once</source>
        <translation>Hält die Pipette sofort an und nimmt die Kraft von der Hand</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stretching, α</source>
        <translation>Dehnung, α</translation>
    </message>
    <message>
        <source>Suction</source>
        <translation>Sog</translation>
    </message>
    <message>
        <source>Suggested: Enter takes it</source>
        <translation>Vorschlag: Eingabe übernimmt ihn</translation>
    </message>
    <message>
        <source>Sum: residual</source>
        <translation>Summe: Rest</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Surface: %1 ▾</source>
        <translation>Oberfläche: %1 ▾</translation>
    </message>
    <message>
        <source>Surface: the next quantity</source>
        <translation>Oberfläche: die nächste Größe</translation>
    </message>
    <message>
        <source>Symplectic Euler, eq. (4)</source>
        <translation>Symplektisches Euler-Verfahren, Gl. (4)</translation>
    </message>
    <message>
        <source>TO TARGET</source>
        <translation>ZUM ZIEL</translation>
    </message>
    <message>
        <source>TRUE FORCE</source>
        <translation>WAHRE KRAFT</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Table as CSV</source>
        <translation>Tabelle als CSV</translation>
    </message>
    <message>
        <source>Take a shorter step than </source>
        <translation>Wählen Sie einen kürzeren Schritt als </translation>
    </message>
    <message>
        <source>Take back the last hint</source>
        <translation>Letzten Hinweis zurücknehmen</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>Take the needle out, then replace the cell by an intact one</source>
        <translation>Nimmt die Nadel heraus und ersetzt die Zelle durch eine unversehrte</translation>
    </message>
    <message>
        <source>Take the pipette out along its axis while held down</source>
        <translation>Zieht die Pipette längs ihrer Achse heraus, solange gedrückt</translation>
    </message>
    <message>
        <source>Takes the rows chosen out of the table</source>
        <translation>Nimmt die gewählten Zeilen aus der Tabelle</translation>
    </message>
    <message>
        <source>Taking the needle out</source>
        <translation>Herausziehen der Nadel</translation>
    </message>
    <message>
        <source>Taking the needle out for a new cell</source>
        <translation>Nadel wird für eine neue Zelle herausgezogen</translation>
    </message>
    <message>
        <source>Target </source>
        <translation>Ziel </translation>
    </message>
    <message>
        <source>Target set</source>
        <translation>Ziel gesetzt</translation>
    </message>
    <message>
        <source>Target: </source>
        <translation>Ziel: </translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Lehre</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Zehn Bilder zurück</translation>
    </message>
    <message>
        <source>Ten frames forward</source>
        <translation>Zehn Bilder weiter</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Tension (µN/µm)</source>
        <translation>Spannung (µN/µm)</translation>
    </message>
    <message>
        <source>Tension at a node (µN/µm)</source>
        <translation>Spannung an einem Knoten (µN/µm)</translation>
    </message>
    <message>
        <source>Tension of the nodes</source>
        <translation>Spannung der Knoten</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>That was no outline: press the mouse on the cell's edge, and drag once round it</source>
        <translation>Das war kein Umriss: drücken Sie die Maustaste am Rand der Zelle, und ziehen Sie einmal um sie herum</translation>
    </message>
    <message>
        <source>That would be </source>
        <translation>Das wären </translation>
    </message>
    <message>
        <source>The camera chooses the time</source>
        <translation>Die Kamera wählt die Zeit</translation>
    </message>
    <message>
        <source>The camera's own: it changes what is measured.</source>
        <translation>Der Kamera selbst: ändert, was gemessen wird.</translation>
    </message>
    <message>
        <source>The cell is as stiff as its profile says.</source>
        <translation>Die Zelle ist so steif, wie ihr Profil sagt.</translation>
    </message>
    <message>
        <source>The cell's own mass would be 10⁻¹² kg a node</source>
        <translation>Die eigene Masse der Zelle wären 10⁻¹² kg je Knoten</translation>
    </message>
    <message>
        <source>The file does not state its frame rate: type it, such as 30.</source>
        <translation>Die Datei gibt ihre Bildrate nicht an: geben Sie sie ein, etwa 30.</translation>
    </message>
    <message>
        <source>The file does not state the size of a pixel: type it in µm, such as 0.825.</source>
        <translation>Die Datei gibt die Größe eines Pixels nicht an: geben Sie sie in µm ein, etwa 0.825.</translation>
    </message>
    <message>
        <source>The force could not be computed: no force on the hand</source>
        <translation>Die Kraft ließ sich nicht berechnen: keine Kraft auf die Hand</translation>
    </message>
    <message>
        <source>The force read from a contour in two ways</source>
        <translation>Die Kraft, aus einer Kontur auf zwei Arten gelesen</translation>
    </message>
    <message>
        <source>The holding pipette draws a tongue of the zona into its mouth under a known suction. Finite elements of the aspirated shell give its modulus; that takes some seconds.</source>
        <translation>Die Haltepipette saugt mit bekanntem Sog eine Zunge der Zona in ihre Mündung. Finite Elemente der angesaugten Schale geben den Modul; das dauert einige Sekunden.</translation>
    </message>
    <message>
        <source>The image shows where the membrane is, not which piece of it is where</source>
        <translation>Das Bild zeigt, wo die Membran ist, nicht welches Stück von ihr wo ist</translation>
    </message>
    <message>
        <source>The image, and the membranes in 3-D</source>
        <translation>Das Bild, und die Membranen in 3-D</translation>
    </message>
    <message>
        <source>The kind's scale again</source>
        <translation>Wieder die Skala der Zellart</translation>
    </message>
    <message>
        <source>The last puncture: largest force before it, depth and work of the needle up to it. Stays until the next cell.</source>
        <translation>Der letzte Durchstich: größte Kraft davor, Tiefe und Arbeit der Nadel bis dahin. Bleibt bis zur nächsten Zelle.</translation>
    </message>
    <message>
        <source>The lesson's page</source>
        <translation>Die Seite der Lektion</translation>
    </message>
    <message>
        <source>The lesson's parameters, and the cell at rest</source>
        <translation>Die Parameter der Lektion, und die Zelle in Ruhe</translation>
    </message>
    <message>
        <source>The live image of your microscope's camera, measured as it comes.</source>
        <translation>Das Bild Ihrer Mikroskopkamera, gemessen, wie es kommt.</translation>
    </message>
    <message>
        <source>The membrane</source>
        <translation>Die Membran</translation>
    </message>
    <message>
        <source>The membrane is clear, and shows what is behind it.</source>
        <translation>Die Membran ist durchsichtig und zeigt, was hinter ihr liegt.</translation>
    </message>
    <message>
        <source>The mesh that the forces are computed on, as a wire: where it leaves the seen surface, model and image disagree</source>
        <translation>Das Netz, auf dem die Kräfte berechnet werden, als Draht: Wo es von der gesehenen Oberfläche abweicht, widersprechen sich Modell und Bild</translation>
    </message>
    <message>
        <source>The microscope's image alone</source>
        <translation>Das Bild des Mikroskops allein</translation>
    </message>
    <message>
        <source>The model's curves: with this cell's sizes as seen, and of the profile's own cell</source>
        <translation>Die Kurven des Modells: mit den gesehenen Maßen dieser Zelle und für die Zelle des Profils</translation>
    </message>
    <message>
        <source>The model's own surface</source>
        <translation>Die Oberfläche des Modells</translation>
    </message>
    <message>
        <source>The needle moves as the scenario describes, again and again.</source>
        <translation>Die Nadel bewegt sich, wie es das Szenario beschreibt, immer wieder.</translation>
    </message>
    <message>
        <source>The needle out of the cell</source>
        <translation>Die Nadel aus der Zelle</translation>
    </message>
    <message>
        <source>The needle pushes this cell, and another instrument gives the force (or leave it 0 and give the stiffness, the rise of the force with depth).</source>
        <translation>Die Nadel drückt diese Zelle, und ein anderes Instrument gibt die Kraft (oder lassen Sie sie 0 und geben Sie die Steifigkeit an, den Anstieg der Kraft mit der Tiefe).</translation>
    </message>
    <message>
        <source>The next colouring of the surface</source>
        <translation>Nächste Färbung der Oberfläche</translation>
    </message>
    <message>
        <source>The next recording goes into </source>
        <translation>Die nächste Aufnahme kommt in </translation>
    </message>
    <message>
        <source>The next window has it</source>
        <translation>Gilt ab dem nächsten Fenster</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>Die andere</translation>
    </message>
    <message>
        <source>The picture shows shapes, not how stiff this cell is. One measurement makes all forces its own. Several add up.</source>
        <translation>Das Bild zeigt Formen, nicht wie steif diese Zelle ist. Eine Messung macht alle Kräfte zu ihren eigenen. Mehrere ergänzen sich.</translation>
    </message>
    <message>
        <source>The planned way: drag its rings while the cell is untouched</source>
        <translation>Der geplante Weg: ziehen Sie seine Ringe, solange die Zelle unberührt ist</translation>
    </message>
    <message>
        <source>The recording was interrupted, or is still being written</source>
        <translation>Die Aufnahme wurde unterbrochen oder läuft noch</translation>
    </message>
    <message>
        <source>The same, on the number pad</source>
        <translation>Dasselbe, auf dem Ziffernblock</translation>
    </message>
    <message>
        <source>The scenario's own motion</source>
        <translation>Eigene Bewegung des Szenarios</translation>
    </message>
    <message>
        <source>The screenshot can't be written: </source>
        <translation>Das Bildschirmfoto lässt sich nicht schreiben: </translation>
    </message>
    <message>
        <source>The session does not hold this profile</source>
        <translation>Die Sitzung enthält dieses Profil nicht</translation>
    </message>
    <message>
        <source>The session holds no such array of this node</source>
        <translation>Die Sitzung enthält diese Größe für den Knoten nicht</translation>
    </message>
    <message>
        <source>The session's images along its time; a press seeks</source>
        <translation>Die Bilder der Sitzung längs ihrer Zeit; ein Druck springt dorthin</translation>
    </message>
    <message>
        <source>The smaller, the longer a step; too small overshoots</source>
        <translation>Je kleiner, desto länger ein Schritt; zu klein schießt über</translation>
    </message>
    <message>
        <source>The source has ended</source>
        <translation>Die Quelle ist zu Ende</translation>
    </message>
    <message>
        <source>The spring network itself</source>
        <translation>Das Federnetz selbst</translation>
    </message>
    <message>
        <source>The time step, </source>
        <translation>Der Zeitschritt, </translation>
    </message>
    <message>
        <source>The tip goes no deeper than this beyond the entry</source>
        <translation>Die Spitze geht nicht tiefer als so weit hinter den Eintritt</translation>
    </message>
    <message>
        <source>Theme and language</source>
        <translation>Farbschema und Sprache</translation>
    </message>
    <message>
        <source>There is no camera to start: connect one, then press Search again.</source>
        <translation>Keine Kamera zum Starten: schließen Sie eine an und drücken Sie „Erneut suchen“.</translation>
    </message>
    <message>
        <source>There is no hint to take back</source>
        <translation>Es gibt keinen Hinweis zurückzunehmen</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>These files exist. Replace them?

</source>
        <translation>Diese Dateien gibt es schon. Ersetzen?

</translation>
    </message>
    <message>
        <source>Thickness of the zona</source>
        <translation>Dicke der Zona</translation>
    </message>
    <message>
        <source>This cell is </source>
        <translation>Diese Zelle ist </translation>
    </message>
    <message>
        <source>This cell: what is left of its unknown stiffness after its scale was measured.</source>
        <translation>Diese Zelle: was nach dem Messen ihrer Skala von ihrer unbekannten Steifigkeit bleibt.</translation>
    </message>
    <message>
        <source>This frame and its charts as CSV</source>
        <translation>Dieses Bild und seine Diagramme als CSV</translation>
    </message>
    <message>
        <source>This frame has several notes: the next one</source>
        <translation>Dieses Bild hat mehrere Notizen: die nächste</translation>
    </message>
    <message>
        <source>This frame's surface holds no such numbers</source>
        <translation>Die Oberfläche dieses Bildes enthält keine solchen Zahlen</translation>
    </message>
    <message>
        <source>This is no cell</source>
        <translation>Das ist keine Zelle</translation>
    </message>
    <message>
        <source>This is the cell</source>
        <translation>Das ist die Zelle</translation>
    </message>
    <message>
        <source>This is the cell's outline</source>
        <translation>Das ist der Umriss der Zelle</translation>
    </message>
    <message>
        <source>This needs OpenGL 3.2: install a driver of the graphics card, or Mesa</source>
        <translation>Das braucht OpenGL 3.2: einen Treiber der Grafikkarte oder Mesa installieren</translation>
    </message>
    <message>
        <source>This session</source>
        <translation>Diese Sitzung</translation>
    </message>
    <message>
        <source>This session has no images: choose the forces in 3-D</source>
        <translation>Diese Sitzung hat keine Bilder: Wählen Sie die Kräfte in 3-D</translation>
    </message>
    <message>
        <source>This session's annotations can't be read: mend or remove annotations.csv first</source>
        <translation>Die Anmerkungen dieser Sitzung sind nicht lesbar: berichtigen oder entfernen Sie zuerst annotations.csv</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Time in contact (s)</source>
        <translation>Zeit in Kontakt (s)</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Tongue, mouth to apex</source>
        <translation>Zunge, Mündung bis Scheitel</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tools on membrane (µN)</source>
        <translation>Werkzeuge auf Membran (µN)</translation>
    </message>
    <message>
        <source>True force of the virtual cell</source>
        <translation>Wahre Kraft der virtuellen Zelle</translation>
    </message>
    <message>
        <source>Try the virtual microscope</source>
        <translation>Virtuelles Mikroskop ausprobieren</translation>
    </message>
    <message>
        <source>Turn both cells, zoom</source>
        <translation>Beide Zellen drehen, vergrößern</translation>
    </message>
    <message>
        <source>Turn the view, zoom</source>
        <translation>Ansicht drehen, vergrößern</translation>
    </message>
    <message>
        <source>Twice as stiff</source>
        <translation>Doppelt so steif</translation>
    </message>
    <message>
        <source>Two read-outs</source>
        <translation>Zwei Ablesungen</translation>
    </message>
    <message>
        <source>Type the edge of the camera's own pixel in µm; its data sheet states it.</source>
        <translation>Geben Sie die Kantenlänge eines Kamerapixels in µm ein; sie steht im Datenblatt.</translation>
    </message>
    <message>
        <source>Type the length of the line in µm.</source>
        <translation>Die Länge der Linie in µm eingeben.</translation>
    </message>
    <message>
        <source>Type the size of a pixel in µm, or choose the objective.</source>
        <translation>Geben Sie die Größe eines Pixels in µm ein, oder wählen Sie das Objektiv.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo panning and zooming</source>
        <translation>Macht Verschieben und Vergrößern rückgängig</translation>
    </message>
    <message>
        <source>Undo the plan's change</source>
        <translation>Änderung des Plans zurücknehmen</translation>
    </message>
    <message>
        <source>Unloading</source>
        <translation>Entlastung</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Use this measurement</source>
        <translation>Diese Messung verwenden</translation>
    </message>
    <message>
        <source>VOLUME</source>
        <translation>VOLUMEN</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>Video (*.mp4);;Lossless video (*.avi)</source>
        <translation>Video (*.mp4);;Verlustfreies Video (*.avi)</translation>
    </message>
    <message>
        <source>Video of the views</source>
        <translation>Video der Ansichten</translation>
    </message>
    <message>
        <source>View as PNG</source>
        <translation>Ansicht als PNG</translation>
    </message>
    <message>
        <source>Viscosity, γ</source>
        <translation>Zähigkeit, γ</translation>
    </message>
    <message>
        <source>Wait for the export that is running, or cancel it</source>
        <translation>Warten Sie auf den laufenden Export, oder brechen Sie ihn ab</translation>
    </message>
    <message>
        <source>Wait: a session is being opened</source>
        <translation>Warten Sie: eine Sitzung wird geöffnet</translation>
    </message>
    <message>
        <source>Wait: the session is being measured again</source>
        <translation>Warten Sie: die Sitzung wird neu gemessen</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Waiting for a cell</source>
        <translation>Warten auf eine Zelle</translation>
    </message>
    <message>
        <source>Waiting for an untouched cell</source>
        <translation>Wartet auf eine unberührte Zelle</translation>
    </message>
    <message>
        <source>Waiting for the first frame</source>
        <translation>Warten auf das erste Bild</translation>
    </message>
    <message>
        <source>What both tools do to the membrane: the needle pushes, the holding pipette holds against it.</source>
        <translation>Was beide Werkzeuge mit der Membran tun: Die Nadel drückt, die Haltepipette hält dagegen.</translation>
    </message>
    <message>
        <source>What has the least energy in the image</source>
        <translation>Was im Bild die geringste Energie hat</translation>
    </message>
    <message>
        <source>What is drawn of the node</source>
        <translation>Was vom Knoten gezeichnet wird</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>What is shown of the other session</source>
        <translation>Was von der anderen Sitzung gezeigt wird</translation>
    </message>
    <message>
        <source>What is shown, felt and heard</source>
        <translation>Was man sieht, fühlt und hört</translation>
    </message>
    <message>
        <source>What moves the needle</source>
        <translation>Was die Nadel bewegt</translation>
    </message>
    <message>
        <source>What moves the pipette</source>
        <translation>Was die Pipette bewegt</translation>
    </message>
    <message>
        <source>What the colour of the outer membrane shows; key 8 shows the next quantity</source>
        <translation>Was die Farbe der äußeren Membran zeigt; Taste 8 zeigt die nächste Größe</translation>
    </message>
    <message>
        <source>What the holding pipette does to the membrane around its mouth. The bold arrow is the sum.</source>
        <translation>Was die Haltepipette rund um ihre Öffnung mit der Membran tut. Der dicke Pfeil ist die Summe.</translation>
    </message>
    <message>
        <source>What the image shows</source>
        <translation>Was das Bild zeigt</translation>
    </message>
    <message>
        <source>What the left chart shows</source>
        <translation>Was das linke Diagramm zeigt</translation>
    </message>
    <message>
        <source>What the left chart shows (H: histogram and back)</source>
        <translation>Was das linke Diagramm zeigt (H: Histogramm und zurück)</translation>
    </message>
    <message>
        <source>What the needle does to the membrane under its tip. The bold arrow is the sum.</source>
        <translation>Was die Nadel unter ihrer Spitze mit der Membran tut. Der dicke Pfeil ist die Summe.</translation>
    </message>
    <message>
        <source>What the picture shows of the cell: whether it is seen, touched, punctured or lost</source>
        <translation>Was das Bild von der Zelle zeigt: ob sie zu sehen, berührt, durchstochen oder verloren ist</translation>
    </message>
    <message>
        <source>What was measured as CSV…</source>
        <translation>Gemessenes als CSV …</translation>
    </message>
    <message>
        <source>When it was, since the source began</source>
        <translation>Wann das war, seit Beginn der Quelle</translation>
    </message>
    <message>
        <source>Where a node is laid on it</source>
        <translation>Wo ein Knoten auf ihr liegt</translation>
    </message>
    <message>
        <source>Where each piece really is</source>
        <translation>Wo jedes Stück wirklich ist</translation>
    </message>
    <message>
        <source>Where it began</source>
        <translation>Wo sie begann</translation>
    </message>
    <message>
        <source>Which forces on the membrane the arrows show, and how. Now: </source>
        <translation>Welche Kräfte auf die Membran die Pfeile zeigen, und wie. Jetzt: </translation>
    </message>
    <message>
        <source>Which frame of the film or the recording is seen</source>
        <translation>Welches Bild des Films oder der Aufnahme zu sehen ist</translation>
    </message>
    <message>
        <source>Which frames of both sessions belong together</source>
        <translation>Welche Bilder beider Sitzungen zusammengehören</translation>
    </message>
    <message>
        <source>Which kinds are listed</source>
        <translation>Welche Arten aufgeführt sind</translation>
    </message>
    <message>
        <source>Whole frame</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Whose contour</source>
        <translation>Wessen Kontur</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width and height</source>
        <translation>Breite und Höhe</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window as PNG</source>
        <translation>Fenster als PNG</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>Without it the liquid leaves freely, and there is no pressure</source>
        <translation>Ohne dies entweicht die Flüssigkeit ungehindert, und es gibt keinen Druck</translation>
    </message>
    <message>
        <source>Work of the needle up to it</source>
        <translation>Arbeit der Nadel bis dahin</translation>
    </message>
    <message>
        <source>Work to the largest depth (pJ)</source>
        <translation>Arbeit bis zur größten Tiefe (pJ)</translation>
    </message>
    <message>
        <source>Write a note into the session: at this time, on a node or at a place in the image</source>
        <translation>Schreibt eine Notiz in die Sitzung: zu diesem Zeitpunkt, an einem Knoten oder an einer Stelle im Bild</translation>
    </message>
    <message>
        <source>Write frames, shapes and forces to a session folder</source>
        <translation>Schreibt Bilder, Formen und Kräfte in einen Sitzungsordner</translation>
    </message>
    <message>
        <source>Write the list as a table, with the columns of a report's cells.csv</source>
        <translation>Liste als Tabelle schreiben, mit den Spalten der cells.csv eines Berichts</translation>
    </message>
    <message>
        <source>Writing tables</source>
        <translation>Tabellen werden geschrieben</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Der Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>You move the needle yourself.</source>
        <translation>Sie bewegen die Nadel selbst.</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Your note; Enter keeps it</source>
        <translation>Ihre Notiz; die Eingabetaste behält sie</translation>
    </message>
    <message>
        <source>a number grew beyond all bounds</source>
        <translation>eine Zahl wuchs über alle Grenzen</translation>
    </message>
    <message>
        <source>a size of your own</source>
        <translation>eine eigene Größe</translation>
    </message>
    <message>
        <source>along the meridian</source>
        <translation>längs des Meridians</translation>
    </message>
    <message>
        <source>annotation</source>
        <translation>Anmerkung</translation>
    </message>
    <message>
        <source>as on screen</source>
        <translation>wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>at rest: </source>
        <translation>in Ruhe: </translation>
    </message>
    <message>
        <source>at rest: 00.00 µN</source>
        <translation>in Ruhe: 00.00 µN</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>beyond the target</source>
        <translation>hinter dem Ziel</translation>
    </message>
    <message>
        <source>by the manipulator</source>
        <translation>laut Manipulator</translation>
    </message>
    <message>
        <source>camera pixel</source>
        <translation>Kamerapixel</translation>
    </message>
    <message>
        <source>can't be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>cell's outline</source>
        <translation>Umriss der Zelle</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>confidence below 50 % in </source>
        <translation>Sicherheit unter 50 % in </translation>
    </message>
    <message>
        <source>contact without a force in </source>
        <translation>Kontakt ohne Kraft in </translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>damped for stability</source>
        <translation>gedämpft, damit es stabil bleibt</translation>
    </message>
    <message>
        <source>depth limit</source>
        <translation>Tiefengrenze</translation>
    </message>
    <message>
        <source>depth stop</source>
        <translation>Tiefenanschlag</translation>
    </message>
    <message>
        <source>depth stop </source>
        <translation>Tiefenanschlag </translation>
    </message>
    <message>
        <source>doubt</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>drop one on this window</source>
        <translation>hierher ziehen</translation>
    </message>
    <message>
        <source>each alone may be zero (95 %)</source>
        <translation>jeder allein evtl. null (95 %)</translation>
    </message>
    <message>
        <source>end of travel</source>
        <translation>Ende des Wegs</translation>
    </message>
    <message>
        <source>external</source>
        <translation>äußere</translation>
    </message>
    <message>
        <source>force on the cell at its limit</source>
        <translation>Kraft auf die Zelle an der Grenze</translation>
    </message>
    <message>
        <source>forces in 3-D</source>
        <translation>Kräfte in 3-D</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>aus der Datei</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>holding pipette</source>
        <translation>Haltepipette</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>in equilibrium</source>
        <translation>im Gleichgewicht</translation>
    </message>
    <message>
        <source>indentation ±</source>
        <translation>Eindellung ±</translation>
    </message>
    <message>
        <source>inner membrane</source>
        <translation>innere Membran</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>innere</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>kind of cell </source>
        <translation>Zellart </translation>
    </message>
    <message>
        <source>largest force of the device</source>
        <translation>größte Kraft des Geräts</translation>
    </message>
    <message>
        <source>left out: </source>
        <translation>ausgelassen: </translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>lessons</source>
        <translation>lessons/de</translation>
    </message>
    <message>
        <source>limit </source>
        <translation>Grenze </translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>lost by the source</source>
        <translation>von der Quelle verloren</translation>
    </message>
    <message>
        <source>lost in contact</source>
        <translation>im Kontakt verloren</translation>
    </message>
    <message>
        <source>magnification</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>may be zero (95 %)</source>
        <translation>evtl. null (95 %)</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>no cell</source>
        <translation>keine Zelle</translation>
    </message>
    <message>
        <source>no deeper while the force is unknown</source>
        <translation>nicht tiefer, solange die Kraft unbekannt ist</translation>
    </message>
    <message>
        <source>no force, see below</source>
        <translation>keine Kraft, siehe unten</translation>
    </message>
    <message>
        <source>no hand, no limit</source>
        <translation>keine Hand, keine Grenze</translation>
    </message>
    <message>
        <source>no holder seen: taken to be opposite the needle</source>
        <translation>keine Haltepipette gesehen: der Nadel gegenüber angenommen</translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>kein Intervall</translation>
    </message>
    <message>
        <source>no needle in sight</source>
        <translation>keine Nadel in Sicht</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>no plan without a hand</source>
        <translation>kein Plan ohne Hand</translation>
    </message>
    <message>
        <source>no plan yet</source>
        <translation>noch kein Plan</translation>
    </message>
    <message>
        <source>no surface with this node</source>
        <translation>keine Oberfläche mit diesem Knoten</translation>
    </message>
    <message>
        <source>not in this recording: measure it again,</source>
        <translation>nicht in dieser Aufnahme: neu messen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>not measured in this frame</source>
        <translation>in diesem Bild nicht gemessen</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>nicht berührt</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>oolemma</source>
        <translation>Oolemm</translation>
    </message>
    <message>
        <source>or choose the membrane resultant</source>
        <translation>oder Resultierende der Membran wählen</translation>
    </message>
    <message>
        <source>or stiffness</source>
        <translation>oder Steifigkeit</translation>
    </message>
    <message>
        <source>other touches</source>
        <translation>andere Berührungen</translation>
    </message>
    <message>
        <source>outer membrane</source>
        <translation>äußere Membran</translation>
    </message>
    <message>
        <source>over time</source>
        <translation>über der Zeit</translation>
    </message>
    <message>
        <source>picture </source>
        <translation>Bild </translation>
    </message>
    <message>
        <source>picture ±00 %, kind of cell ±00 %</source>
        <translation>Bild ±00 %, diese Zelle ±00 %</translation>
    </message>
    <message>
        <source>pixel size</source>
        <translation>Pixelgröße</translation>
    </message>
    <message>
        <source>prescribed</source>
        <translation>vorgeschrieben</translation>
    </message>
    <message>
        <source>puncture </source>
        <translation>Durchstich </translation>
    </message>
    <message>
        <source>punctured</source>
        <translation>durchstochen</translation>
    </message>
    <message>
        <source>quasi-static</source>
        <translation>quasistatisch</translation>
    </message>
    <message>
        <source>quasi-static: </source>
        <translation>quasistatisch: </translation>
    </message>
    <message>
        <source>quasi-static: is computed</source>
        <translation>quasistatisch: wird berechnet</translation>
    </message>
    <message>
        <source>recorded without their image</source>
        <translation>ohne Bild aufgezeichnet</translation>
    </message>
    <message>
        <source>recorded without their surface</source>
        <translation>ohne Oberfläche aufgezeichnet</translation>
    </message>
    <message>
        <source>retracted</source>
        <translation>zurückgezogen</translation>
    </message>
    <message>
        <source>same indentation</source>
        <translation>gleiche Eindellung</translation>
    </message>
    <message>
        <source>same time</source>
        <translation>gleiche Zeit</translation>
    </message>
    <message>
        <source>session.json was changed after it was written: don't trust calibration and profile</source>
        <translation>session.json wurde nach dem Schreiben geändert: trauen Sie Kalibrierung und Profil nicht</translation>
    </message>
    <message>
        <source>speed limit of the pipette</source>
        <translation>Geschwindigkeitsgrenze der Pipette</translation>
    </message>
    <message>
        <source>stable above </source>
        <translation>stabil über </translation>
    </message>
    <message>
        <source>stable at any step</source>
        <translation>stabil bei jedem Schritt</translation>
    </message>
    <message>
        <source>stable below </source>
        <translation>stabil unter </translation>
    </message>
    <message>
        <source>stiffer than the device can render</source>
        <translation>steifer, als das Gerät darstellen kann</translation>
    </message>
    <message>
        <source>still in contact</source>
        <translation>noch in Kontakt</translation>
    </message>
    <message>
        <source>such as 0.825</source>
        <translation>etwa 0.825</translation>
    </message>
    <message>
        <source>such as 100</source>
        <translation>etwa 100</translation>
    </message>
    <message>
        <source>such as 3.45</source>
        <translation>etwa 3.45</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>zurückgenommen</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>the computer was late</source>
        <translation>der Rechner war zu spät</translation>
    </message>
    <message>
        <source>the equations of an implicit step were not solved</source>
        <translation>die Gleichungen eines impliziten Schritts wurden nicht gelöst</translation>
    </message>
    <message>
        <source>the frame rate</source>
        <translation>die Bildrate</translation>
    </message>
    <message>
        <source>the hand</source>
        <translation>die Hand</translation>
    </message>
    <message>
        <source>the hand's reading jumped</source>
        <translation>der Messwert der Hand sprang</translation>
    </message>
    <message>
        <source>the nodes move with </source>
        <translation>die Knoten bewegen sich mit </translation>
    </message>
    <message>
        <source>the pipette lags behind the hand</source>
        <translation>die Pipette hinkt der Hand nach</translation>
    </message>
    <message>
        <source>the pipette's report jumped</source>
        <translation>die Meldung der Pipette sprang</translation>
    </message>
    <message>
        <source>the pixel size</source>
        <translation>die Pixelgröße</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>das Profil</translation>
    </message>
    <message>
        <source>the window is not drawn by an X server</source>
        <translation>das Fenster wird nicht von einem X-Server gezeichnet</translation>
    </message>
    <message>
        <source>the zona's inner edge was not seen</source>
        <translation>der innere Rand der Zona war nicht zu sehen</translation>
    </message>
    <message>
        <source>this cell </source>
        <translation>diese Zelle </translation>
    </message>
    <message>
        <source>time since contact</source>
        <translation>Zeit seit dem Kontakt</translation>
    </message>
    <message>
        <source>times</source>
        <translation>fach</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tip beyond the entry</source>
        <translation>ab Eintritt</translation>
    </message>
    <message>
        <source>true</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>true </source>
        <translation>wahr </translation>
    </message>
    <message>
        <source>true force</source>
        <translation>wahre Kraft</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>unbeendet</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>unknown membrane</source>
        <translation>unbekannte Membran</translation>
    </message>
    <message>
        <source>untouched</source>
        <translation>unberührt</translation>
    </message>
    <message>
        <source>σ of that</source>
        <translation>σ davon</translation>
    </message>
</context>
</TS>
