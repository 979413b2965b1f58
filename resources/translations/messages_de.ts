<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Messages</name>
    <message>
        <source> (%1 frames were read</source>
        <translation> (%1 Bilder wurden gelesen</translation>
    </message>
    <message>
        <source> (the file is cut off)</source>
        <translation> (die Datei ist abgeschnitten)</translation>
    </message>
    <message>
        <source> bit</source>
        <translation> Bit</translation>
    </message>
    <message>
        <source> bit float</source>
        <translation> Bit Gleitkomma</translation>
    </message>
    <message>
        <source> bit signed</source>
        <translation> Bit mit Vorzeichen</translation>
    </message>
    <message>
        <source> frame</source>
        <translation> Bild</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source>"%1" in column %2 is not a number</source>
        <translation>„%1“ in Spalte %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>"%1" in column frame is not a whole number</source>
        <translation>„%1“ in Spalte frame ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>"%1" in column time_s is no time of a session</source>
        <translation>„%1“ in Spalte time_s ist keine Zeit einer Sitzung</translation>
    </message>
    <message>
        <source>"%1" is no data file of a session</source>
        <translation>„%1“ ist keine Datendatei einer Sitzung</translation>
    </message>
    <message>
        <source>"%1" is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 %2 %3, the device holds %4 %5: take a force scale of %6 N/uN or less, or a finer motion scale</source>
        <translation>%1 %2 %3, das Gerät hält %4 %5: wählen Sie eine Kraftskala von höchstens %6 N/uN oder eine feinere Bewegungsskala</translation>
    </message>
    <message>
        <source>%1 %2: is the input %3, which would be overwritten; name another file</source>
        <translation>%1 %2: ist die Eingabe %3, die überschrieben würde; nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>%1 %2: out of range; give %3 to %4 %5</source>
        <translation>%1 %2: außerhalb des Bereichs; erlaubt sind %3 bis %4 %5</translation>
    </message>
    <message>
        <source>%1 bytes where at most %2 are expected</source>
        <translation>%1 Bytes, wo höchstens %2 erwartet werden</translation>
    </message>
    <message>
        <source>%1 frames (within %2 to %3)</source>
        <translation>%1 Bilder (zwischen %2 und %3)</translation>
    </message>
    <message>
        <source>%1 frames missing from the source before frame %2</source>
        <translation>%1 Bilder der Quelle fehlen vor Bild %2</translation>
    </message>
    <message>
        <source>%1 frames missing from the source, the first before frame %2, the last before frame %3</source>
        <translation>%1 Bilder der Quelle fehlen, das erste vor Bild %2, das letzte vor Bild %3</translation>
    </message>
    <message>
        <source>%1 frames were not taken during the pause</source>
        <translation>%1 Bilder wurden während der Pause nicht abgeholt</translation>
    </message>
    <message>
        <source>%1 has %2 components</source>
        <translation>%1 hat %2 Komponenten</translation>
    </message>
    <message>
        <source>%1 has a number too large to be one; correct it or use a shipped one</source>
        <translation>%1 enthält eine zu große Zahl; berichtigen Sie sie oder verwenden Sie eine mitgelieferte Datei</translation>
    </message>
    <message>
        <source>%1 has several components</source>
        <translation>%1 hat mehrere Komponenten</translation>
    </message>
    <message>
        <source>%1 is %2, but must be %3</source>
        <translation>%1 ist %2, muss aber %3 sein</translation>
    </message>
    <message>
        <source>%1 is %2; allowed: %3</source>
        <translation>%1 ist %2; erlaubt: %3</translation>
    </message>
    <message>
        <source>%1 is %2; allowed: 0 to %3</source>
        <translation>%1 ist %2; erlaubt: 0 bis %3</translation>
    </message>
    <message>
        <source>%1 is an unknown key; known: %2</source>
        <translation>%1 ist ein unbekannter Schlüssel; bekannt: %2</translation>
    </message>
    <message>
        <source>%1 is empty; write a text</source>
        <translation>%1 ist leer; schreiben Sie einen Text</translation>
    </message>
    <message>
        <source>%1 is missing; add it</source>
        <translation>%1 fehlt; ergänzen Sie es</translation>
    </message>
    <message>
        <source>%1 is no JSON object; write {...}</source>
        <translation>%1 ist kein JSON-Objekt; schreiben Sie {...}</translation>
    </message>
    <message>
        <source>%1 is no JSON: byte %2; correct it or use a shipped one</source>
        <translation>%1 ist kein JSON: Byte %2; berichtigen Sie es oder verwenden Sie eine mitgelieferte Datei</translation>
    </message>
    <message>
        <source>%1 is no group of keys; write "%2": {...}</source>
        <translation>%1 ist keine Gruppe von Schlüsseln; schreiben Sie "%2": {...}</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers</source>
        <translation>%1 besteht nicht aus %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 kept without numbers: they came faster than the processor measures</source>
        <translation>%1 ohne Zahlen aufgezeichnet: sie kamen schneller, als der Prozessor misst</translation>
    </message>
    <message>
        <source>%1 kept without their image: %2</source>
        <translation>%1 ohne Bild aufgezeichnet: %2</translation>
    </message>
    <message>
        <source>%1 kept without their surface: %2</source>
        <translation>%1 ohne Oberfläche aufgezeichnet: %2</translation>
    </message>
    <message>
        <source>%1 must be a group of keys, {...}</source>
        <translation>%1 muss eine Gruppe von Schlüsseln sein, {...}</translation>
    </message>
    <message>
        <source>%1 names %2, which is not a folder; set it to the folder of the %3, or unset it</source>
        <translation>%1 nennt %2, was kein Ordner ist; setzen Sie es auf den Ordner mit %3, oder löschen Sie es</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 x %2 px where session.json says %3 x %4</source>
        <translation>%1 x %2 px, wo session.json %3 x %4 angibt</translation>
    </message>
    <message>
        <source>%1 x %2 px, %3 bit</source>
        <translation>%1 x %2 px, %3 Bit</translation>
    </message>
    <message>
        <source>%1%2 is this cell's</source>
        <translation>%1%2 gehört</translation>
    </message>
    <message>
        <source>%1); copy or record it again</source>
        <translation>%1); kopieren Sie sie erneut oder nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>%1, its tiles</source>
        <translation>%1, seine Kacheln</translation>
    </message>
    <message>
        <source>%1, page %2</source>
        <translation>%1, Seite %2</translation>
    </message>
    <message>
        <source>%1: "%2" is no camera number; give v4l2:0, v4l2:1, ...</source>
        <translation>%1: „%2“ ist keine Kameranummer; nötig ist v4l2:0, v4l2:1, ...</translation>
    </message>
    <message>
        <source>%1: "%2" is no number; mend the line or remove it</source>
        <translation>%1: „%2“ ist keine Zahl; berichtigen oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1: %2 can't be opened (%3); </source>
        <translation>%1: %2 lässt sich nicht öffnen (%3); </translation>
    </message>
    <message>
        <source>%1: %2 cells in place of %3; mend the line or remove it</source>
        <translation>%1: %2 Zellen statt %3; berichtigen oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1: %2 is %3, which can't be</source>
        <translation>%1: %2 ist %3, was nicht sein kann</translation>
    </message>
    <message>
        <source>%1: %2 must be a list</source>
        <translation>%1: %2 muss eine Liste sein</translation>
    </message>
    <message>
        <source>%1: %2 samples a pixel; convert it to grey or plain colour</source>
        <translation>%1: %2 Werte je Pixel; wandeln Sie das Bild in Grau oder einfache Farbe um</translation>
    </message>
    <message>
        <source>%1: %2 unknown; give %3 (%4)</source>
        <translation>%1: %2 unbekannt; geben Sie %3 an (%4)</translation>
    </message>
    <message>
        <source>%1: %2 where the first image is %3; all must be alike</source>
        <translation>%1: %2, wo das erste Bild %3 ist; alle müssen gleich sein</translation>
    </message>
    <message>
        <source>%1: %2 x %3 px, more than %4 megapixels; raise --max-megapixels if that is right</source>
        <translation>%1: %2 x %3 px, mehr als %4 Megapixel; erhöhen Sie --max-megapixels, wenn das stimmt</translation>
    </message>
    <message>
        <source>%1: %2; install the program again</source>
        <translation>%1: %2; installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>%1: %2; use the version of Pellucida that wrote it, or a later one</source>
        <translation>%1: %2; verwenden Sie die Version von Pellucida, die das geschrieben hat, oder eine neuere</translation>
    </message>
    <message>
        <source>%1: 16 bit pixels of a rare layout; convert it to plain 16 bit grey</source>
        <translation>%1: 16-Bit-Pixel in seltener Anordnung; wandeln Sie das Bild in einfaches 16-Bit-Grau um</translation>
    </message>
    <message>
        <source>%1: a JPEG of four colours (CMYK); convert it to grey or plain colour</source>
        <translation>%1: ein JPEG mit vier Farben (CMYK); wandeln Sie es in Grau oder einfache Farbe um</translation>
    </message>
    <message>
        <source>%1: a chart is written as .png, .svg or .pdf; choose one of these endings</source>
        <translation>%1: ein Diagramm wird als .png, .svg oder .pdf geschrieben; wählen Sie eine dieser Endungen</translation>
    </message>
    <message>
        <source>%1: a session has the times of its frames; leave out --fps</source>
        <translation>%1: eine Sitzung hat die Zeiten ihrer Bilder; lassen Sie --fps weg</translation>
    </message>
    <message>
        <source>%1: a session without a frame; nothing to replay</source>
        <translation>%1: eine Sitzung ohne Bild; es gibt nichts wiederzugeben</translation>
    </message>
    <message>
        <source>%1: a text file, not a video or an image; give AVI, MP4, MKV, MOV, PNG, TIFF, JPEG or BMP</source>
        <translation>%1: eine Textdatei, weder Video noch Bild; nötig ist AVI, MP4, MKV, MOV, PNG, TIFF, JPEG oder BMP</translation>
    </message>
    <message>
        <source>%1: a value of a wrong type (%2); run pellucida check --repair on the session</source>
        <translation>%1: ein Wert von falschem Typ (%2); rufen Sie pellucida check --repair für die Sitzung auf</translation>
    </message>
    <message>
        <source>%1: a video without a readable frame%2</source>
        <translation>%1: ein Video ohne lesbares Bild%2</translation>
    </message>
    <message>
        <source>%1: already holds a session (%2), which is never overwritten; choose another folder</source>
        <translation>%1: enthält schon eine Sitzung (%2), die nie überschrieben wird; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1: already there; give another --output, or --replace to replace it</source>
        <translation>%1: schon vorhanden; geben Sie ein anderes --output an, oder --replace, um es zu ersetzen</translation>
    </message>
    <message>
        <source>%1: broken TIFF (it has no size)</source>
        <translation>%1: beschädigtes TIFF (es hat keine Größe)</translation>
    </message>
    <message>
        <source>%1: broken TIFF (its first page can't be found)</source>
        <translation>%1: beschädigtes TIFF (seine erste Seite ist nicht zu finden)</translation>
    </message>
    <message>
        <source>%1: broken TIFF (its tiles have no size)</source>
        <translation>%1: beschädigtes TIFF (seine Kacheln haben keine Größe)</translation>
    </message>
    <message>
        <source>%1: broken TIFF (page %2 can't be found)</source>
        <translation>%1: beschädigtes TIFF (Seite %2 ist nicht zu finden)</translation>
    </message>
    <message>
        <source>%1: broken TIFF (page %2 can't be read)</source>
        <translation>%1: beschädigtes TIFF (Seite %2 ist nicht lesbar)</translation>
    </message>
    <message>
        <source>%1: broken image (%2)</source>
        <translation>%1: beschädigtes Bild (%2)</translation>
    </message>
    <message>
        <source>%1: broken image (%2); copy it again</source>
        <translation>%1: beschädigtes Bild (%2); kopieren Sie es erneut</translation>
    </message>
    <message>
        <source>%1: broken image (cut off before its end); copy it again</source>
        <translation>%1: beschädigtes Bild (vor dem Ende abgeschnitten); kopieren Sie es erneut</translation>
    </message>
    <message>
        <source>%1: broken image (its pixels can't be decoded); copy it again</source>
        <translation>%1: beschädigtes Bild (seine Pixel lassen sich nicht dekodieren); kopieren Sie es erneut</translation>
    </message>
    <message>
        <source>%1: broken off after page %2 (the next one can't be found); copy or record it again</source>
        <translation>%1: nach Seite %2 abgebrochen (die nächste ist nicht zu finden); kopieren Sie die Datei erneut oder nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>%1: can't be read (%2)</source>
        <translation>%1: nicht lesbar (%2)</translation>
    </message>
    <message>
        <source>%1: can't be read (%2); change its permission</source>
        <translation>%1: nicht lesbar (%2); ändern Sie die Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1: can't be read (%2); check path and permission</source>
        <translation>%1: nicht lesbar (%2); prüfen Sie Pfad und Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1: can't be read; check the path and its permissions</source>
        <translation>%1: nicht lesbar; prüfen Sie Pfad und Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1: can't be written (%2); %3</source>
        <translation>%1: lässt sich nicht schreiben (%2); %3</translation>
    </message>
    <message>
        <source>%1: cut off (an MP4 without its index can't be read); copy or record it again</source>
        <translation>%1: abgeschnitten (ein MP4 ohne seinen Index ist nicht lesbar); kopieren Sie die Datei erneut oder nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>%1: empty file (0 bytes); copy it again, or remove it if no frame belongs there</source>
        <translation>%1: leere Datei (0 Bytes); kopieren Sie sie erneut, oder entfernen Sie sie, wenn dort kein Bild hingehört</translation>
    </message>
    <message>
        <source>%1: empty file (0 bytes); copy or record it again</source>
        <translation>%1: leere Datei (0 Bytes); kopieren Sie sie erneut oder nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>%1: errors is missing; add it</source>
        <translation>%1: errors fehlt; ergänzen Sie es</translation>
    </message>
    <message>
        <source>%1: frame %2 after frame %3; frame numbers must rise</source>
        <translation>%1: Bild %2 nach Bild %3; Bildnummern müssen steigen</translation>
    </message>
    <message>
        <source>%1: geometry.inner_radius_um must be mid_radius_um less half of thickness_um</source>
        <translation>%1: geometry.inner_radius_um muss mid_radius_um weniger der Hälfte von thickness_um sein</translation>
    </message>
    <message>
        <source>%1: geometry_pressure_terms needs geometry_terms and geometry_range; add them</source>
        <translation>%1: geometry_pressure_terms braucht geometry_terms und geometry_range; ergänzen Sie diese</translation>
    </message>
    <message>
        <source>%1: geometry_range.%2_from_ratio must be below %3_to_ratio</source>
        <translation>%1: geometry_range.%2_from_ratio muss unter %3_to_ratio liegen</translation>
    </message>
    <message>
        <source>%1: has several pages; give the file itself as the input</source>
        <translation>%1: hat mehrere Seiten; geben Sie die Datei selbst als Eingabe an</translation>
    </message>
    <message>
        <source>%1: holds %2 pixels; convert it to 8 or 16 bit grey</source>
        <translation>%1: enthält Pixel vom Typ %2; wandeln Sie das Bild in 8- oder 16-Bit-Grau um</translation>
    </message>
    <message>
        <source>%1: holds %2%3 pixels; convert it to 8 or 16 bit grey</source>
        <translation>%1: enthält Pixel vom Typ %2%3; wandeln Sie das Bild in 8- oder 16-Bit-Grau um</translation>
    </message>
    <message>
        <source>%1: is a link, which is not followed; name another folder with --output</source>
        <translation>%1: ist eine Verknüpfung, der nicht gefolgt wird; nennen Sie mit --output einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1: is the session itself, whose tables would be overwritten; choose another --output</source>
        <translation>%1: ist die Sitzung selbst, deren Tabellen überschrieben würden; wählen Sie ein anderes --output</translation>
    </message>
    <message>
        <source>%1: its session.json has no pixel size; give --pixel-size-um</source>
        <translation>%1: die zugehörige session.json nennt keine Pixelgröße; geben Sie --pixel-size-um an</translation>
    </message>
    <message>
        <source>%1: its tables don't fit each other; install the program again</source>
        <translation>%1: die Tabellen passen nicht zueinander; installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>%1: line %2</source>
        <translation>%1: Zeile %2</translation>
    </message>
    <message>
        <source>%1: measurements.csv is missing; the session can't be read without it</source>
        <translation>%1: measurements.csv fehlt; ohne sie ist die Sitzung nicht lesbar</translation>
    </message>
    <message>
        <source>%1: more than %2 lines can't be read: no table of a session</source>
        <translation>%1: mehr als %2 Zeilen sind nicht lesbar: keine Tabelle einer Sitzung</translation>
    </message>
    <message>
        <source>%1: needs more memory than there is</source>
        <translation>%1: braucht mehr Speicher, als vorhanden ist</translation>
    </message>
    <message>
        <source>%1: neither a file nor a folder</source>
        <translation>%1: weder eine Datei noch ein Ordner</translation>
    </message>
    <message>
        <source>%1: neither a file nor one of the known %2 (%3)</source>
        <translation>%1: weder eine Datei noch eines der bekannten %2 (%3)</translation>
    </message>
    <message>
        <source>%1: neither a video nor an image this build can read; give AVI, MP4, MKV, MOV, PNG, TIFF, JPEG or BMP</source>
        <translation>%1: weder ein Video noch ein Bild, das dieses Programm lesen kann; nötig ist AVI, MP4, MKV, MOV, PNG, TIFF, JPEG oder BMP</translation>
    </message>
    <message>
        <source>%1: nested too deep for the head of a session%2</source>
        <translation>%1: zu tief geschachtelt für den Kopf einer Sitzung%2</translation>
    </message>
    <message>
        <source>%1: no PNG, TIFF, JPEG or BMP image in this folder</source>
        <translation>%1: kein PNG-, TIFF-, JPEG- oder BMP-Bild in diesem Ordner</translation>
    </message>
    <message>
        <source>%1: no frame between --from and --to; the session lasts from %2 to %3 s</source>
        <translation>%1: kein Bild zwischen --from und --to; die Sitzung dauert von %2 bis %3 s</translation>
    </message>
    <message>
        <source>%1: no head of a session (it has no schema_version)</source>
        <translation>%1: kein Kopf einer Sitzung (schema_version fehlt)</translation>
    </message>
    <message>
        <source>%1: no session here (session.json is missing); name a session's folder</source>
        <translation>%1: hier liegt keine Sitzung (session.json fehlt); nennen Sie den Ordner einer Sitzung</translation>
    </message>
    <message>
        <source>%1: no such file or folder; check the path</source>
        <translation>%1: keine solche Datei und kein solcher Ordner; prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>%1: no such session folder; check the path</source>
        <translation>%1: kein solcher Sitzungsordner; prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>%1: no time; mend the line or remove it</source>
        <translation>%1: keine Zeit; berichtigen oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1: not "%2"</source>
        <translation>%1: nicht „%2“</translation>
    </message>
    <message>
        <source>%1: not JSON%2</source>
        <translation>%1: kein JSON%2</translation>
    </message>
    <message>
        <source>%1: not a PNG, TIFF, JPEG or BMP image</source>
        <translation>%1: kein PNG-, TIFF-, JPEG- oder BMP-Bild</translation>
    </message>
    <message>
        <source>%1: not a network that can be read (%2); install pellucida anew</source>
        <translation>%1: kein lesbares Netz (%2); installieren Sie pellucida neu</translation>
    </message>
    <message>
        <source>%1: not a session; --from, --to, --every, --loop and --backwards are for sessions</source>
        <translation>%1: keine Sitzung; --from, --to, --every, --loop und --backwards gelten für Sitzungen</translation>
    </message>
    <message>
        <source>%1: over</source>
        <translation>%1: vorbei</translation>
    </message>
    <message>
        <source>%1: page %2 has another size or depth than the first; all pages must be alike</source>
        <translation>%1: Seite %2 hat andere Größe oder Bittiefe als die erste; alle Seiten müssen gleich sein</translation>
    </message>
    <message>
        <source>%1: recorded without images, so nothing can be tracked; what was tracked can be measured again with pellucida replay --rerun mechanics</source>
        <translation>%1: ohne Bilder aufgezeichnet, deshalb lässt sich nichts verfolgen; das Verfolgte lässt sich mit pellucida replay --rerun mechanics neu messen</translation>
    </message>
    <message>
        <source>%1: recorded without the numbers that the forces are computed from; give --rerun tracking, which needs its images</source>
        <translation>%1: ohne die Zahlen aufgezeichnet, aus denen die Kräfte berechnet werden; geben Sie --rerun tracking an, das die Bilder braucht</translation>
    </message>
    <message>
        <source>%1: relaxation_arms is wrong: %2</source>
        <translation>%1: relaxation_arms ist falsch: %2</translation>
    </message>
    <message>
        <source>%1: schema must be "pellucida-cell-profile"</source>
        <translation>%1: schema muss "pellucida-cell-profile" sein</translation>
    </message>
    <message>
        <source>%1: schema_version must be 1; update the program or the file</source>
        <translation>%1: schema_version muss 1 sein; erneuern Sie das Programm oder die Datei</translation>
    </message>
    <message>
        <source>%1: sources must be an object of texts</source>
        <translation>%1: sources muss ein Objekt aus Texten sein</translation>
    </message>
    <message>
        <source>%1: sources.%2 must be a text</source>
        <translation>%1: sources.%2 muss ein Text sein</translation>
    </message>
    <message>
        <source>%1: the camera delivers no image; check its cable and other users</source>
        <translation>%1: die Kamera liefert kein Bild; prüfen Sie ihr Kabel und ob ein anderes Programm sie benutzt</translation>
    </message>
    <message>
        <source>%1: the camera delivers no images since frame %2; check its cable</source>
        <translation>%1: die Kamera liefert seit Bild %2 keine Bilder; prüfen Sie ihr Kabel</translation>
    </message>
    <message>
        <source>%1: the camera has no automatic exposure; set a time</source>
        <translation>%1: Die Kamera hat keine automatische Belichtung; stellen Sie eine Zeit ein</translation>
    </message>
    <message>
        <source>%1: the camera refuses its exposure control (%2); check its cable, and close other programs that control it</source>
        <translation>%1: Die Kamera verweigert die Einstellung der Belichtung (%2); prüfen Sie ihr Kabel, und schließen Sie andere Programme, die sie steuern</translation>
    </message>
    <message>
        <source>%1: the chart can't be written; free some space, or choose another folder</source>
        <translation>%1: das Diagramm lässt sich nicht schreiben; schaffen Sie Platz, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1: the device is no camera this build can read; %2</source>
        <translation>%1: das Gerät ist keine Kamera, die dieses Programm lesen kann; %2</translation>
    </message>
    <message>
        <source>%1: the disk did not take what was written (%2); check the disk and its free space</source>
        <translation>%1: der Datenträger nahm das Geschriebene nicht an (%2); prüfen Sie ihn und seinen freien Platz</translation>
    </message>
    <message>
        <source>%1: the driver gives no time for an image</source>
        <translation>%1: der Treiber gibt keine Zeit für ein Bild</translation>
    </message>
    <message>
        <source>%1: the exposure time must be a number, ms</source>
        <translation>%1: Die Belichtungszeit muss eine Zahl sein, ms</translation>
    </message>
    <message>
        <source>%1: the folder can't be read (%2); check its permission</source>
        <translation>%1: der Ordner ist nicht lesbar (%2); prüfen Sie die Zugriffsrechte</translation>
    </message>
    <message>
        <source>%1: the picture changes its size after frame %2; cut the video there</source>
        <translation>%1: das Bild ändert nach Bild %2 seine Größe; schneiden Sie das Video dort</translation>
    </message>
    <message>
        <source>%1: the scenario fixes pixel size and frame rate; leave out --pixel-size-um and --fps</source>
        <translation>%1: das Szenario legt Pixelgröße und Bildrate fest; lassen Sie --pixel-size-um und --fps weg</translation>
    </message>
    <message>
        <source>%1: the session holds no frame; choose another one</source>
        <translation>%1: die Sitzung enthält kein Bild; wählen Sie eine andere</translation>
    </message>
    <message>
        <source>%1: the session is closed; nothing can be added</source>
        <translation>%1: die Sitzung ist geschlossen; es lässt sich nichts hinzufügen</translation>
    </message>
    <message>
        <source>%1: this build has no %2 source; use a camera v4l2:N, or record to a video file</source>
        <translation>%1: dieses Programm ist ohne %2-Quelle gebaut; verwenden Sie eine Kamera v4l2:N, oder nehmen Sie eine Videodatei auf</translation>
    </message>
    <message>
        <source>%1add yourself to the group video and log in again</source>
        <translation>%1nehmen Sie sich in die Gruppe video auf und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>%1close the program that uses it</source>
        <translation>%1schließen Sie das Programm, das sie benutzt</translation>
    </message>
    <message>
        <source>'%1' sets no key; write KEY=VALUE, such as cell.stiffness_ratio=2</source>
        <translation>„%1“ setzt keinen Schlüssel; SCHLÜSSEL=WERT schreiben, etwa cell.stiffness_ratio=2</translation>
    </message>
    <message>
        <source>, about %1 of %2 are missing</source>
        <translation>, etwa %1 von %2 fehlen</translation>
    </message>
    <message>
        <source>, acted %1 times in %2 s</source>
        <translation>, wirkte %1-mal in %2 s</translation>
    </message>
    <message>
        <source>, at most %1 %2</source>
        <translation>, höchstens %1 %2</translation>
    </message>
    <message>
        <source>, memory locked</source>
        <translation>, Speicher festgehalten</translation>
    </message>
    <message>
        <source>, memory not locked</source>
        <translation>, Speicher nicht festgehalten</translation>
    </message>
    <message>
        <source>, which may cost %1 uN</source>
        <translation>, was %1 uN kosten kann</translation>
    </message>
    <message>
        <source>--every %1: give 1 or more</source>
        <translation>--every %1: erlaubt ist 1 oder mehr</translation>
    </message>
    <message>
        <source>--frames "%1": no frame of %2; give first, last, peak or frame numbers (%3)</source>
        <translation>--frames „%1“: kein Bild von %2; erlaubt sind first, last, peak oder Bildnummern (%3)</translation>
    </message>
    <message>
        <source>--loop %1: give 1 or more, or 0 for no end</source>
        <translation>--loop %1: erlaubt ist 1 oder mehr, oder 0 für kein Ende</translation>
    </message>
    <message>
        <source>--max-megapixels must be above 0, up to 1000</source>
        <translation>--max-megapixels muss über 0 liegen, höchstens bei 1000</translation>
    </message>
    <message>
        <source>--output %1: lies in the session, whose files must stay as they are; leave --output out for %2, or name a folder outside</source>
        <translation>--output %1: liegt in der Sitzung, deren Dateien bleiben müssen, wie sie sind; lassen Sie --output weg für %2, oder nennen Sie einen Ordner außerhalb</translation>
    </message>
    <message>
        <source>--pixel-size-um %1: give 0.001 to 100 um</source>
        <translation>--pixel-size-um %1: erlaubt sind 0.001 bis 100 um</translation>
    </message>
    <message>
        <source>--pixel-size-um: contours are in um already; give --rerun tracking</source>
        <translation>--pixel-size-um: die Konturen sind schon in um; geben Sie --rerun tracking an</translation>
    </message>
    <message>
        <source>1 frame (%1)</source>
        <translation>1 Bild (%1)</translation>
    </message>
    <message>
        <source>1 frame missing from the source before frame %1</source>
        <translation>1 Bild der Quelle fehlt vor Bild %1</translation>
    </message>
    <message>
        <source>: %1 %2, limit %3 %4</source>
        <translation>: %1 %2, Grenze %3 %4</translation>
    </message>
    <message>
        <source>: %1 kPa, +- %2 %</source>
        <translation>: %1 kPa, +- %2 %</translation>
    </message>
    <message>
        <source>: broken off after frame %1</source>
        <translation>: nach Bild %1 abgebrochen</translation>
    </message>
    <message>
        <source>: contour %1 um from the model, left and right %2 um apart beyond it</source>
        <translation>: Kontur %1 um vom Modell, links und rechts darüber hinaus %2 um auseinander</translation>
    </message>
    <message>
        <source>: damaged</source>
        <translation>: beschädigt</translation>
    </message>
    <message>
        <source>: give 3 to 32 corners in um, such as 80,60/140,60/110,120, or with @S behind</source>
        <translation>: nötig sind 3 bis 32 Ecken in um, etwa 80,60/140,60/110,120, oder mit @S dahinter</translation>
    </message>
    <message>
        <source>: give X,Y in um, such as 120.5,88, or X,Y@S</source>
        <translation>: nötig ist X,Y in um, etwa 120.5,88, oder X,Y@S</translation>
    </message>
    <message>
        <source>: not of the other images' size</source>
        <translation>: nicht von der Größe der anderen Bilder</translation>
    </message>
    <message>
        <source>: stamped with another time than its row's; run pellucida check on the session</source>
        <translation>: mit einer anderen Zeit als der seiner Zeile gestempelt; rufen Sie pellucida check für die Sitzung auf</translation>
    </message>
    <message>
        <source>; %1 standard deviations from the kind: check the measurement, and that profile </source>
        <translation>; %1 Standardabweichungen von der Art entfernt: prüfen Sie die Messung, und ob diese Zelle zum Profil </translation>
    </message>
    <message>
        <source>; one membrane only, taken as the outer: no second edge was seen beside it</source>
        <translation>; nur eine Membran, als äußere genommen: daneben war kein zweiter Rand zu sehen</translation>
    </message>
    <message>
        <source>; run pellucida check --repair on the session</source>
        <translation>; rufen Sie pellucida check --repair für die Sitzung auf</translation>
    </message>
    <message>
        <source>; seen first as %1</source>
        <translation>; zuerst gesehen im Zustand %1</translation>
    </message>
    <message>
        <source>As default with a poor camera: noise, defocus, drift, debris, uneven light</source>
        <translation>Wie default, mit schlechter Kamera: Rauschen, Unschärfe, Drift, Partikel, ungleichmäßiges Licht</translation>
    </message>
    <message>
        <source>As default, but the membrane gives way at 44 um: the force drops, the needle goes on and is withdrawn</source>
        <translation>Wie default, aber die Membran gibt bei 44 um nach: die Kraft fällt, die Nadel geht weiter und wird herausgezogen</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät belegt</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>For a needle in somebody's hand: far off at first, the cell gives way at up to a fifth less than 7.5 uN</source>
        <translation>Für eine von Hand geführte Nadel: anfangs weit entfernt, die Zelle gibt bei bis zu einem Fünftel weniger als 7.5 uN nach</translation>
    </message>
    <message>
        <source>Hessian not positive definite, and no shift helps</source>
        <translation>Hesse-Matrix nicht positiv definit, und keine Verschiebung hilft</translation>
    </message>
    <message>
        <source>Holder below right, needle from the left above; pushed in, then drawn back</source>
        <translation>Haltepipette rechts unten, Nadel von links oben; eingedrückt, dann zurückgezogen</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Mouse embryo, needle 10 um beside the holder's axis; the membrane gives way at 50 um, the needle is withdrawn</source>
        <translation>Mausembryo, Nadel 10 um neben der Achse der Haltepipette; die Membran gibt bei 50 um nach, die Nadel wird herausgezogen</translation>
    </message>
    <message>
        <source>Mouse embryo, needle 45 degrees off the holder's axis; pushed in, then drawn back</source>
        <translation>Mausembryo, Nadel 45 Grad zur Achse der Haltepipette; eingedrückt, dann zurückgezogen</translation>
    </message>
    <message>
        <source>Mouse embryo, needle at a right angle to the holder's axis, 53 um</source>
        <translation>Mausembryo, Nadel im rechten Winkel zur Achse der Haltepipette, 53 um</translation>
    </message>
    <message>
        <source>Mouse embryo, needle opposite the holder: pushed 53 um, 13 uN, and held</source>
        <translation>Mausembryo, Nadel gegenüber der Haltepipette: 53 um eingedrückt, 13 uN, und gehalten</translation>
    </message>
    <message>
        <source>Mouse embryo, zona pellucida</source>
        <translation>Mausembryo, Zona pellucida</translation>
    </message>
    <message>
        <source>Mouse oocyte on a holding pipette, needle opposite it: pushed 44 um, 7.5 uN, and held</source>
        <translation>Mausoozyte an einer Haltepipette, Nadel gegenüber: 44 um eingedrückt, 7.5 uN, und gehalten</translation>
    </message>
    <message>
        <source>Mouse oocyte, zona pellucida</source>
        <translation>Mausoozyte, Zona pellucida</translation>
    </message>
    <message>
        <source>Needle 45 degrees off the holder's axis</source>
        <translation>Nadel 45 Grad zur Achse der Haltepipette</translation>
    </message>
    <message>
        <source>Needle at a right angle to the holder's axis</source>
        <translation>Nadel im rechten Winkel zur Achse der Haltepipette</translation>
    </message>
    <message>
        <source>Needle at a right angle to the holder's axis, from the other side, holder on the right</source>
        <translation>Nadel im rechten Winkel zur Achse der Haltepipette, von der anderen Seite, Haltepipette rechts</translation>
    </message>
    <message>
        <source>Needle parallel to the holder's axis, 10 um beside it; pushed in, then drawn back</source>
        <translation>Nadel parallel zur Achse der Haltepipette, 10 um daneben; eingedrückt, dann zurückgezogen</translation>
    </message>
    <message>
        <source>No plan: %1</source>
        <translation>Kein Plan: %1</translation>
    </message>
    <message>
        <source>No plan: the cell isn't seen</source>
        <translation>Kein Plan: die Zelle ist nicht zu sehen</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Gerät nicht vorhanden</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht vorhanden</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>kein Ordner</translation>
    </message>
    <message>
        <source>Oocyte of an AFM record, softer, and its force relaxes</source>
        <translation>Oozyte einer AFM-Aufzeichnung, weicher, und ihre Kraft lässt nach</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1</source>
        <translation>SCHED_FIFO %1</translation>
    </message>
    <message>
        <source>SCHED_FIFO: %1; allow it with the line "@users - rtprio 95" in /etc/security/limits.conf</source>
        <translation>SCHED_FIFO: %1; erlauben Sie es mit der Zeile "@users - rtprio 95" in /etc/security/limits.conf</translation>
    </message>
    <message>
        <source>SPNAV_SOCKET names a path that is too long for a socket</source>
        <translation>SPNAV_SOCKET nennt einen Pfad, der für einen Socket zu lang ist</translation>
    </message>
    <message>
        <source>SpaceMouse: %1</source>
        <translation>SpaceMouse: %1</translation>
    </message>
    <message>
        <source>SpaceMouse: already in use by this program</source>
        <translation>SpaceMouse: schon von diesem Programm benutzt</translation>
    </message>
    <message>
        <source>SpaceMouse: reach and full deflection must be above 0</source>
        <translation>SpaceMouse: Reichweite und Vollausschlag müssen über 0 liegen</translation>
    </message>
    <message>
        <source>SpaceMouse: the daemon at %1 does not take a connection</source>
        <translation>SpaceMouse: der Dienst unter %1 nimmt keine Verbindung an</translation>
    </message>
    <message>
        <source>a BMP with run lengths or another compression; convert it to PNG</source>
        <translation>ein BMP mit Lauflängen oder anderer Kompression; wandeln Sie es in PNG um</translation>
    </message>
    <message>
        <source>a cell's scale: its ratio must be above 0, its sigma 0 or above</source>
        <translation>Skala einer Zelle: ihr Verhältnis muss über 0 liegen, ihr Sigma bei 0 oder darüber</translation>
    </message>
    <message>
        <source>a checksum is wrong</source>
        <translation>eine Prüfsumme ist falsch</translation>
    </message>
    <message>
        <source>a data object could not be turned into a VTK file</source>
        <translation>ein Datenobjekt ließ sich nicht in eine VTK-Datei umwandeln</translation>
    </message>
    <message>
        <source>a fibre bent by %1 um: </source>
        <translation>eine um %1 um ausgelenkte Faser: </translation>
    </message>
    <message>
        <source>a fibre needs its stiffness and its deflection</source>
        <translation>eine Faser braucht ihre Steifigkeit und ihre Auslenkung</translation>
    </message>
    <message>
        <source>a folder, pipe or device, not a file</source>
        <translation>ein Ordner, eine Pipe oder ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>a line of %1 bytes</source>
        <translation>eine Zeile von %1 Bytes</translation>
    </message>
    <message>
        <source>a link, which is not followed</source>
        <translation>eine Verknüpfung, der nicht gefolgt wird</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number of the plan isn't finite or out of range; correct the cell's geometry or the plan's options</source>
        <translation>eine Zahl des Plans ist nicht endlich oder außerhalb des Bereichs; berichtigen Sie die Geometrie der Zelle oder die Einstellungen des Plans</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 px can't be drawn: choose 400 x 300 to 8000 x 8000</source>
        <translation>ein Bild von %1 x %2 px lässt sich nicht zeichnen: wählen Sie 400 x 300 bis 8000 x 8000</translation>
    </message>
    <message>
        <source>a piece of another size than the whole</source>
        <translation>ein Teil von anderer Größe als das Ganze</translation>
    </message>
    <message>
        <source>a pixel size of %1 um where session.json says %2</source>
        <translation>eine Pixelgröße von %1 um, wo session.json %2 angibt</translation>
    </message>
    <message>
        <source>a push needs its indentation, and a known force, a known stiffness, or a fibre's stiffness and deflection</source>
        <translation>ein Stoß braucht seine Eindellung und eine bekannte Kraft, eine bekannte Steifigkeit oder Steifigkeit und Auslenkung einer Faser</translation>
    </message>
    <message>
        <source>a push of %1 uN at %2 um, +- %3 %</source>
        <translation>ein Stoß von %1 uN bei %2 um, +- %3 %</translation>
    </message>
    <message>
        <source>a row of %1 cells; 3 are needed</source>
        <translation>eine Zeile von %1 Zellen; 3 sind nötig</translation>
    </message>
    <message>
        <source>a scale, the period or a figure of the cell isn't a finite number above 0; correct it</source>
        <translation>eine Skala, die Periode oder eine Größe der Zelle ist keine endliche Zahl über 0; berichtigen Sie sie</translation>
    </message>
    <message>
        <source>a stiffness of %1 uN/um at %2 um, +- %3 %</source>
        <translation>eine Steifigkeit von %1 uN/um bei %2 um, +- %3 %</translation>
    </message>
    <message>
        <source>a table is empty</source>
        <translation>eine Tabelle ist leer</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a tongue of %1 um under %2 kPa in a mouth of %3 um</source>
        <translation>eine Zunge von %1 um unter %2 kPa in einer Mündung von %3 um</translation>
    </message>
    <message>
        <source>a video picture of a kind not known here; convert it to 8 bit grey or colour</source>
        <translation>ein Videobild unbekannter Art; wandeln Sie es in 8-Bit-Grau oder Farbe um</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a whole number below 1e9</source>
        <translation>eine ganze Zahl unter 1e9</translation>
    </message>
    <message>
        <source>a whole number, 0 or more</source>
        <translation>eine ganze Zahl, 0 oder mehr</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>above %1, up to %2</source>
        <translation>über %1, höchstens %2</translation>
    </message>
    <message>
        <source>an array without a usable name</source>
        <translation>ein Feld ohne brauchbaren Namen</translation>
    </message>
    <message>
        <source>an aspiration is no push</source>
        <translation>eine Aspiration ist kein Stoß</translation>
    </message>
    <message>
        <source>an aspiration needs the suction, the tongue's length and the radius of the pipette's mouth</source>
        <translation>eine Aspiration braucht den Sog, die Länge der Zunge und den Radius der Pipettenmündung</translation>
    </message>
    <message>
        <source>an element "%1" that no file of a session has</source>
        <translation>ein Element „%1“, das keine Datei einer Sitzung hat</translation>
    </message>
    <message>
        <source>an image in layers</source>
        <translation>ein Bild in Schichten</translation>
    </message>
    <message>
        <source>an image is no surface, membrane or tool</source>
        <translation>ein Bild ist weder Oberfläche noch Membran noch Werkzeug</translation>
    </message>
    <message>
        <source>an impossible size</source>
        <translation>eine unmögliche Größe</translation>
    </message>
    <message>
        <source>an impossible spacing</source>
        <translation>ein unmöglicher Abstand</translation>
    </message>
    <message>
        <source>an unknown compression</source>
        <translation>eine unbekannte Kompression</translation>
    </message>
    <message>
        <source>an unknown type of sizes</source>
        <translation>ein unbekannter Typ der Größen</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>jede Zahl</translation>
    </message>
    <message>
        <source>array %1 has %2 bytes where %3 belong</source>
        <translation>das Feld %1 hat %2 Bytes, wo %3 hingehören</translation>
    </message>
    <message>
        <source>array %1 has no component</source>
        <translation>das Feld %1 hat keine Komponente</translation>
    </message>
    <message>
        <source>array %1 is in parts of an impossible size</source>
        <translation>das Feld %1 besteht aus Teilen unmöglicher Größe</translation>
    </message>
    <message>
        <source>array %1 is not appended</source>
        <translation>das Feld %1 ist nicht angehängt</translation>
    </message>
    <message>
        <source>array %1 is of an unknown type</source>
        <translation>das Feld %1 ist von unbekanntem Typ</translation>
    </message>
    <message>
        <source>array %1 reaches beyond the end of the file</source>
        <translation>das Feld %1 reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>aspiration: finite elements find no solid zona at the profile's puncture point; measure the scale by a push instead</source>
        <translation>Aspiration: die Finiten Elemente finden keine feste Zona am Durchstichpunkt des Profils; messen Sie die Skala stattdessen mit einem Stoß</translation>
    </message>
    <message>
        <source>aspiration: no zona of this thickness forms a tongue of %1 um in that mouth; check length, radius and thickness</source>
        <translation>Aspiration: keine Zona dieser Dicke bildet in dieser Mündung eine Zunge von %1 um; prüfen Sie Länge, Radius und Dicke</translation>
    </message>
    <message>
        <source>aspiration: suction, tongue and mouth are missing</source>
        <translation>Aspiration: Sog, Zunge und Mündung fehlen</translation>
    </message>
    <message>
        <source>asymmetry</source>
        <translation>Schiefe</translation>
    </message>
    <message>
        <source>at %1 uN and %2 um, work %3 uN um; membrane back at %4 um</source>
        <translation>bei %1 uN und %2 um, Arbeit %3 uN um; Membran zurück bei %4 um</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>blind</translation>
    </message>
    <message>
        <source>block %1 has other arrays than the first</source>
        <translation>Block %1 hat andere Felder als der erste</translation>
    </message>
    <message>
        <source>by its sizes and the needle's this cell is expected to give way at %1 uN and %2 um, its kind at %3 uN and %4 um</source>
        <translation>nach ihren Maßen und denen der Nadel gibt diese Zelle voraussichtlich bei %1 uN und %2 um nach, ihre Art bei %3 uN und %4 um</translation>
    </message>
    <message>
        <source>by the contours in contact: the zona stiffens with strain, b = %1 (68 %: %2 to %3); the force is %4 times that by the picture alone</source>
        <translation>nach den Konturen im Kontakt: die Zona versteift sich mit der Dehnung, b = %1 (68 %: %2 bis %3); die Kraft ist %4-mal die nach dem Bild allein</translation>
    </message>
    <message>
        <source>by the contours in contact: zona %1 um +- %2 %, tip radius %3 um +- %4 %, holding pipette %5 um +- %6 %; the force is %7 times that by the picture alone</source>
        <translation>nach den Konturen im Kontakt: Zona %1 um +- %2 %, Spitzenradius %3 um +- %4 %, Haltepipette %5 um +- %6 %; die Kraft ist %7-mal die nach dem Bild allein</translation>
    </message>
    <message>
        <source>camera.jpeg_quality is set; JPEG needs a picture of 8 bit</source>
        <translation>camera.jpeg_quality ist gesetzt; JPEG braucht ein Bild mit 8 Bit</translation>
    </message>
    <message>
        <source>can be tried; to check for one: pellucida devices --ask %1</source>
        <translation>lässt sich versuchen; um danach zu suchen: pellucida devices --ask %1</translation>
    </message>
    <message>
        <source>can't write the picture %1: %2; choose a folder that exists and may be written</source>
        <translation>das Bild %1 lässt sich nicht schreiben: %2; wählen Sie einen vorhandenen, beschreibbaren Ordner</translation>
    </message>
    <message>
        <source>carries no stamp</source>
        <translation>trägt keinen Stempel</translation>
    </message>
    <message>
        <source>cell at %1 %2 um</source>
        <translation>Zelle bei %1 %2 um</translation>
    </message>
    <message>
        <source>cell at %1 %2 um, radius %3 um, confidence %4</source>
        <translation>Zelle bei %1 %2 um, Radius %3 um, Sicherheit %4</translation>
    </message>
    <message>
        <source>cell outlined by %1 places</source>
        <translation>Zelle umfahren an %1 Stellen</translation>
    </message>
    <message>
        <source>cell profiles, scenarios, reference curves and devices</source>
        <translation>Zellprofilen, Szenarien, Referenzkurven und Geräten</translation>
    </message>
    <message>
        <source>cells with an unknown array %1</source>
        <translation>Zellen mit einem unbekannten Feld %1</translation>
    </message>
    <message>
        <source>change its permission, or choose another folder</source>
        <translation>ändern Sie die Zugriffsrechte, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>chart: the columns of "%1" differ in length</source>
        <translation>Diagramm: die Spalten von „%1“ sind verschieden lang</translation>
    </message>
    <message>
        <source>charts: there is nothing to draw</source>
        <translation>Diagramme: es gibt nichts zu zeichnen</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>chosen; spacenavd reports about 350 at the end of the cap's way</source>
        <translation>gewählt; spacenavd meldet am Ende des Wegs der Kappe etwa 350</translation>
    </message>
    <message>
        <source>column %1 is not a finite number</source>
        <translation>Spalte %1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>contact invalid</source>
        <translation>Kontakt ungültig</translation>
    </message>
    <message>
        <source>contact stale</source>
        <translation>Kontakt veraltet</translation>
    </message>
    <message>
        <source>contact, but the needle was not seen</source>
        <translation>Kontakt, aber die Nadel war nicht zu sehen</translation>
    </message>
    <message>
        <source>contact, but what was taken for the needle comes from where the cell is held</source>
        <translation>Kontakt, aber was als Nadel gilt, kommt von der Seite, an der die Zelle gehalten wird</translation>
    </message>
    <message>
        <source>cut off before its end</source>
        <translation>vor dem Ende abgeschnitten</translation>
    </message>
    <message>
        <source>cut off in the middle</source>
        <translation>mittendrin abgeschnitten</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>damaged (%1)</source>
        <translation>beschädigt (%1)</translation>
    </message>
    <message>
        <source>damaged (a cell names point %1 of %2)</source>
        <translation>beschädigt (eine Zelle nennt Punkt %1 von %2)</translation>
    </message>
    <message>
        <source>damaged (a cell's points are not in its list)</source>
        <translation>beschädigt (die Punkte einer Zelle stehen nicht in ihrer Liste)</translation>
    </message>
    <message>
        <source>damaged (a list of points is longer than its cells)</source>
        <translation>beschädigt (eine Punktliste ist länger als ihre Zellen)</translation>
    </message>
    <message>
        <source>damaged (array %1 can't be decompressed)</source>
        <translation>beschädigt (das Feld %1 lässt sich nicht entpacken)</translation>
    </message>
    <message>
        <source>damaged (cells without their points)</source>
        <translation>beschädigt (Zellen ohne ihre Punkte)</translation>
    </message>
    <message>
        <source>damaged (its checksum is not the one in checksums.csv)</source>
        <translation>beschädigt (die Prüfsumme ist nicht die in checksums.csv)</translation>
    </message>
    <message>
        <source>damaged (neither contours nor a surface)</source>
        <translation>beschädigt (weder Konturen noch eine Oberfläche)</translation>
    </message>
    <message>
        <source>damaged (no image)</source>
        <translation>beschädigt (kein Bild)</translation>
    </message>
    <message>
        <source>damaged (points without their places)</source>
        <translation>beschädigt (Punkte ohne ihre Orte)</translation>
    </message>
    <message>
        <source>declarations, which no file of a session has</source>
        <translation>Deklarationen, die keine Datei einer Sitzung hat</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>depth stop: %1 um must be above 0</source>
        <translation>Tiefenanschlag: %1 um muss über 0 liegen</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>ohne Bild</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>Nothalt</translation>
    </message>
    <message>
        <source>few cells of profile %1 bear this force: check that the profile is this cell's</source>
        <translation>wenige Zellen des Profils %1 halten diese Kraft aus: prüfen Sie, ob es das Profil dieser Zelle ist</translation>
    </message>
    <message>
        <source>following</source>
        <translation>Nachlauf</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>force not finite</source>
        <translation>Kraft nicht endlich</translation>
    </message>
    <message>
        <source>forgotten: the kind's scale again</source>
        <translation>vergessen: wieder die Skala der Zellart</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>frame number does not rise</source>
        <translation>die Bildnummer steigt nicht</translation>
    </message>
    <message>
        <source>frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>frames a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>free some space, or choose another disk</source>
        <translation>schaffen Sie Platz, oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>frequency of the hand: it must be above 0 Hz</source>
        <translation>Frequenz der Hand: sie muss über 0 Hz liegen</translation>
    </message>
    <message>
        <source>from frame %1 on not decoded as recorded%2</source>
        <translation>ab Bild %1 nicht wie aufgezeichnet dekodiert%2</translation>
    </message>
    <message>
        <source>gamepad: SDL can't search for gamepads (%1)</source>
        <translation>Gamepad: SDL kann nicht nach Gamepads suchen (%1)</translation>
    </message>
    <message>
        <source>gamepad: none has "%1" in its name; there is %2</source>
        <translation>Gamepad: keines hat „%1“ im Namen; vorhanden ist %2</translation>
    </message>
    <message>
        <source>gamepad: none is plugged in</source>
        <translation>Gamepad: keines ist angeschlossen</translation>
    </message>
    <message>
        <source>gamepad: reach, rate and force must be above 0, not %1</source>
        <translation>Gamepad: Reichweite, Rate und Kraft müssen über 0 liegen, nicht bei %1</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>give one measurement: a push or an aspiration</source>
        <translation>geben Sie eine Messung an: einen Stoß oder eine Aspiration</translation>
    </message>
    <message>
        <source>give one of known force, known stiffness and fibre for the push at that indentation</source>
        <translation>geben Sie für den Stoß bei dieser Eindellung entweder bekannte Kraft, bekannte Steifigkeit oder Faser an</translation>
    </message>
    <message>
        <source>hand force</source>
        <translation>Kraft der Hand</translation>
    </message>
    <message>
        <source>hand invalid</source>
        <translation>Hand ungültig</translation>
    </message>
    <message>
        <source>hand jump</source>
        <translation>Sprung der Hand</translation>
    </message>
    <message>
        <source>hand lost</source>
        <translation>Hand verloren</translation>
    </message>
    <message>
        <source>hand slope</source>
        <translation>Anstieg an der Hand</translation>
    </message>
    <message>
        <source>hand stiffness</source>
        <translation>Steifigkeit an der Hand</translation>
    </message>
    <message>
        <source>haptic device</source>
        <translation>haptisches Gerät</translation>
    </message>
    <message>
        <source>haptic device: the driver does not open %1 (%2); check cable and power, and set it up with the driver's own tool</source>
        <translation>haptisches Gerät: der Treiber öffnet %1 nicht (%2); prüfen Sie Kabel und Stromversorgung, und richten Sie es mit dem Werkzeug des Treibers ein</translation>
    </message>
    <message>
        <source>haptic device: the driver does not start (%1)</source>
        <translation>haptisches Gerät: der Treiber startet nicht (%1)</translation>
    </message>
    <message>
        <source>haptic device: the library %1 can't be loaded (%2); install the maker's OpenHaptics and device driver for Linux</source>
        <translation>haptisches Gerät: die Bibliothek %1 lässt sich nicht laden (%2); installieren Sie OpenHaptics und den Gerätetreiber des Herstellers für Linux</translation>
    </message>
    <message>
        <source>haptic device: the library %1 has no entry point %2; it is not OpenHaptics 3</source>
        <translation>haptisches Gerät: die Bibliothek %1 hat keinen Einsprungpunkt %2; sie ist nicht OpenHaptics 3</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>hint: its place or time is not finite; give a point of the image, um</source>
        <translation>Hinweis: Ort oder Zeit ist nicht endlich; geben Sie einen Punkt des Bildes an, um</translation>
    </message>
    <message>
        <source>hint: the cell's outline has %1 corners, or one that is not finite; give 3 to %2</source>
        <translation>Hinweis: der Umriss der Zelle hat %1 Ecken, oder eine, die nicht endlich ist; nötig sind 3 bis %2</translation>
    </message>
    <message>
        <source>hints change the tracking, and only the mechanics would run again; give --rerun tracking</source>
        <translation>Hinweise ändern die Bildverfolgung, und nur die Mechanik liefe erneut; geben Sie --rerun tracking an</translation>
    </message>
    <message>
        <source>holding pipette at %1 %2 um</source>
        <translation>Haltepipette bei %1 %2 um</translation>
    </message>
    <message>
        <source>in the recording of this session</source>
        <translation>in der Aufzeichnung dieser Sitzung</translation>
    </message>
    <message>
        <source>it has a part that no decoder knows</source>
        <translation>ein Teil darin ist keinem Decoder bekannt</translation>
    </message>
    <message>
        <source>it has no pixels</source>
        <translation>es hat keine Pixel</translation>
    </message>
    <message>
        <source>it has no size</source>
        <translation>es hat keine Größe</translation>
    </message>
    <message>
        <source>iteration budget spent</source>
        <translation>Zahl der Schritte erschöpft</translation>
    </message>
    <message>
        <source>its byte order is not little endian</source>
        <translation>die Bytereihenfolge ist nicht Little Endian</translation>
    </message>
    <message>
        <source>its checksum is wrong: it was changed after it was written</source>
        <translation>die Prüfsumme ist falsch: nach dem Schreiben geändert</translation>
    </message>
    <message>
        <source>its data would take more than %1 MiB</source>
        <translation>die Daten bräuchten mehr als %1 MiB</translation>
    </message>
    <message>
        <source>its driver (HDAPI)</source>
        <translation>sein Treiber (HDAPI)</translation>
    </message>
    <message>
        <source>its head is not XML</source>
        <translation>der Kopf ist kein XML</translation>
    </message>
    <message>
        <source>its header is invalid</source>
        <translation>der Kopf ist ungültig</translation>
    </message>
    <message>
        <source>its header is invalid, or it is not of 8 bit</source>
        <translation>der Kopf ist ungültig, oder es hat nicht 8 Bit</translation>
    </message>
    <message>
        <source>its palette is invalid</source>
        <translation>die Palette ist ungültig</translation>
    </message>
    <message>
        <source>its palette is missing</source>
        <translation>die Palette fehlt</translation>
    </message>
    <message>
        <source>its powers are none of six variables to degree 7</source>
        <translation>die Potenzen sind nicht die von sechs Veränderlichen bis zum Grad 7</translation>
    </message>
    <message>
        <source>late tick</source>
        <translation>später Takt</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>gemessen: %1</translation>
    </message>
    <message>
        <source>measurements.csv: "%1" in column %2 is not a number</source>
        <translation>measurements.csv: „%1“ in Spalte %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>measurements.csv: "%1" in column state is not a state</source>
        <translation>measurements.csv: „%1“ in Spalte state ist kein Zustand</translation>
    </message>
    <message>
        <source>measurements.csv: a row of %1 cells; %2 are needed</source>
        <translation>measurements.csv: eine Zeile von %1 Zellen; %2 sind nötig</translation>
    </message>
    <message>
        <source>measuring fell too far behind the camera</source>
        <translation>das Messen fiel zu weit hinter die Kamera zurück</translation>
    </message>
    <message>
        <source>mechanics: the scene has no observation</source>
        <translation>Mechanik: die Szene enthält keine Beobachtung</translation>
    </message>
    <message>
        <source>membrane and tip are together again at %1 um</source>
        <translation>Membran und Spitze sind bei %1 um wieder beisammen</translation>
    </message>
    <message>
        <source>membrane left at %1 um</source>
        <translation>Membran löste sich bei %1 um</translation>
    </message>
    <message>
        <source>memory: %1, limited to %2 kB; allow it with the line "@users - memlock unlimited" in /etc/security/limits.conf</source>
        <translation>Speicher: %1, begrenzt auf %2 kB; erlauben Sie es mit der Zeile "@users - memlock unlimited" in /etc/security/limits.conf</translation>
    </message>
    <message>
        <source>micrometres a pixel</source>
        <translation>Mikrometer je Pixel</translation>
    </message>
    <message>
        <source>minus infinite</source>
        <translation>minus unendlich</translation>
    </message>
    <message>
        <source>mismatch</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>model curve: depth and step must be above 0</source>
        <translation>Modellkurve: Tiefe und Schritt müssen größer als 0 sein</translation>
    </message>
    <message>
        <source>more than %1 arrays</source>
        <translation>mehr als %1 Felder</translation>
    </message>
    <message>
        <source>more than one data set</source>
        <translation>mehr als ein Datensatz</translation>
    </message>
    <message>
        <source>more than one piece</source>
        <translation>mehr als ein Teil</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>mouse and keyboard; no force, the resistance is seen</source>
        <translation>Maus und Tastatur; keine Kraft, der Widerstand ist zu sehen</translation>
    </message>
    <message>
        <source>mouse: every option must be above 0, not %1</source>
        <translation>Maus: jede Einstellung muss über 0 liegen, nicht bei %1</translation>
    </message>
    <message>
        <source>needle tip at %1 %2 um</source>
        <translation>Nadelspitze bei %1 %2 um</translation>
    </message>
    <message>
        <source>neither an image nor contours or surfaces</source>
        <translation>weder ein Bild noch Konturen oder Oberflächen</translation>
    </message>
    <message>
        <source>new cell</source>
        <translation>neue Zelle</translation>
    </message>
    <message>
        <source>no Video4Linux camera is plugged in (no /dev/video*)</source>
        <translation>keine Video4Linux-Kamera ist angeschlossen (kein /dev/video*)</translation>
    </message>
    <message>
        <source>no camera is connected: plug one in</source>
        <translation>keine Kamera ist angeschlossen: schließen Sie eine an</translation>
    </message>
    <message>
        <source>no cell at %1 %2 um</source>
        <translation>keine Zelle bei %1 %2 um</translation>
    </message>
    <message>
        <source>no cell has been seen yet; the target can be set once there is a plan</source>
        <translation>noch war keine Zelle zu sehen; das Ziel lässt sich setzen, sobald es einen Plan gibt</translation>
    </message>
    <message>
        <source>no cell is followed that it could hold</source>
        <translation>keine Zelle wird verfolgt, die sie halten könnte</translation>
    </message>
    <message>
        <source>no cell of profile %1: its radius is %2 um, the profile's %3 um; check the pixel size, or give another profile</source>
        <translation>keine Zelle des Profils %1: ihr Radius ist %2 um, der des Profils %3 um; prüfen Sie die Pixelgröße, oder wählen Sie ein anderes Profil</translation>
    </message>
    <message>
        <source>no cell to measure</source>
        <translation>keine Zelle zu messen</translation>
    </message>
    <message>
        <source>no data in it</source>
        <translation>keine Daten darin</translation>
    </message>
    <message>
        <source>no descent</source>
        <translation>kein Abstieg</translation>
    </message>
    <message>
        <source>no device for the hand is called "%1"; take mouse, gamepad, gamepad:NAME, spacemouse, openhaptics or openhaptics:NAME; pellucida devices lists what is there</source>
        <translation>kein Gerät für die Hand heißt „%1“; möglich sind mouse, gamepad, gamepad:NAME, spacemouse, openhaptics oder openhaptics:NAME; pellucida devices zeigt, was vorhanden ist</translation>
    </message>
    <message>
        <source>no force: %1</source>
        <translation>keine Kraft: %1</translation>
    </message>
    <message>
        <source>no head of a data file</source>
        <translation>kein Kopf einer Datendatei</translation>
    </message>
    <message>
        <source>no manipulator is called "%1"; take simulated or eppendorf:PORT, such as eppendorf:/dev/ttyUSB0; pellucida devices lists the ports</source>
        <translation>kein Manipulator heißt „%1“; möglich sind simulated oder eppendorf:ANSCHLUSS, etwa eppendorf:/dev/ttyUSB0; pellucida devices zeigt die Anschlüsse</translation>
    </message>
    <message>
        <source>no permission to read %1; add yourself to the group input: sudo adduser "$USER" input, and log in again</source>
        <translation>keine Berechtigung, %1 zu lesen; nehmen Sie sich in die Gruppe input auf: sudo adduser "$USER" input, und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>no permission to read and write /dev/%1; add yourself to the group video: sudo adduser "$USER" video, and log in again</source>
        <translation>keine Berechtigung, /dev/%1 zu lesen und zu schreiben; nehmen Sie sich in die Gruppe video auf: sudo adduser "$USER" video, und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>no permission to use %1; let the daemon's configuration allow it</source>
        <translation>keine Berechtigung für %1; erlauben Sie es in der Konfiguration des Dienstes</translation>
    </message>
    <message>
        <source>no plan</source>
        <translation>kein Plan</translation>
    </message>
    <message>
        <source>no serial port; see above</source>
        <translation>kein serieller Anschluss; siehe oben</translation>
    </message>
    <message>
        <source>no size and checksum of a file</source>
        <translation>keine Größe und Prüfsumme einer Datei</translation>
    </message>
    <message>
        <source>no socket to be had (%1)</source>
        <translation>kein Socket zu bekommen (%1)</translation>
    </message>
    <message>
        <source>no straight pipette was found there</source>
        <translation>keine gerade Pipette wurde dort gefunden</translation>
    </message>
    <message>
        <source>no straight shaft was found that ends there</source>
        <translation>kein gerader Schaft wurde gefunden, der dort endet</translation>
    </message>
    <message>
        <source>no surface: %1</source>
        <translation>keine Oberfläche: %1</translation>
    </message>
    <message>
        <source>no words</source>
        <translation>ohne Erklärung</translation>
    </message>
    <message>
        <source>no_cell</source>
        <translation>keine Zelle</translation>
    </message>
    <message>
        <source>none is plugged in</source>
        <translation>nichts ist angeschlossen</translation>
    </message>
    <message>
        <source>none of its own; frames the recorded run had no time for stay without numbers</source>
        <translation>keine eigenen; Bilder, für die der aufgezeichnete Lauf keine Zeit hatte, bleiben ohne Zahlen</translation>
    </message>
    <message>
        <source>normal scheduling</source>
        <translation>normale Zeitplanung</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>not a surface of polygons</source>
        <translation>keine Oberfläche aus Polygonen</translation>
    </message>
    <message>
        <source>not an image of one component of 8 or 16 bit</source>
        <translation>kein Bild mit einer Komponente von 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>nicht endlich</translation>
    </message>
    <message>
        <source>not lines</source>
        <translation>keine Linien</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>nothing like a cell was found there</source>
        <translation>dort wurde nichts gefunden, was einer Zelle gleicht</translation>
    </message>
    <message>
        <source>of schema version %1; this program reads version %2</source>
        <translation>von Schemaversion %1; dieses Programm liest Version %2</translation>
    </message>
    <message>
        <source>over, after %1%2</source>
        <translation>vorbei, nach %1%2</translation>
    </message>
    <message>
        <source>palpation</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>passivity</source>
        <translation>Passivität</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>pipette jump</source>
        <translation>Sprung der Pipette</translation>
    </message>
    <message>
        <source>pipette lost</source>
        <translation>Pipette verloren</translation>
    </message>
    <message>
        <source>pixel size</source>
        <translation>Pixelgröße</translation>
    </message>
    <message>
        <source>point %1 is nowhere</source>
        <translation>Punkt %1 ist nirgends</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>puncture</source>
        <translation>Durchstich</translation>
    </message>
    <message>
        <source>punctured</source>
        <translation>durchstochen</translation>
    </message>
    <message>
        <source>raise the file size limit, or choose another disk</source>
        <translation>erhöhen Sie die Grenze der Dateigröße, oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>recording of %1</source>
        <translation>Aufnahme von %1</translation>
    </message>
    <message>
        <source>release</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>resumed</source>
        <translation>fortgesetzt</translation>
    </message>
    <message>
        <source>revoked</source>
        <translation>widerrufen</translation>
    </message>
    <message>
        <source>risk of puncture: the step must be above 0 um</source>
        <translation>Risiko des Durchstichs: der Schritt muss über 0 um liegen</translation>
    </message>
    <message>
        <source>scale of the cell: %1</source>
        <translation>Skala der Zelle: %1</translation>
    </message>
    <message>
        <source>scale of the cell: %1: allowed: %2</source>
        <translation>Skala der Zelle: %1: erlaubt: %2</translation>
    </message>
    <message>
        <source>scale of the cell: the aspiration's modulus has not been computed</source>
        <translation>Skala der Zelle: der Modul aus der Aspiration wurde nicht berechnet</translation>
    </message>
    <message>
        <source>scenario '%1': %2.indentation_um is %3; the reference of this cell ends at %4 um</source>
        <translation>Szenario '%1': %2.indentation_um ist %3; die Referenz dieser Zelle endet bei %4 um</translation>
    </message>
    <message>
        <source>schema_version is %1; this program reads %2</source>
        <translation>schema_version ist %1; dieses Programm liest %2</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>serieller Anschluss</translation>
    </message>
    <message>
        <source>session.json: %1; name the parameters on the command line, or mend the entry</source>
        <translation>session.json: %1; nennen Sie die Parameter auf der Befehlszeile, oder berichtigen Sie den Eintrag</translation>
    </message>
    <message>
        <source>session.json: provenance.frames_used is damaged (%1); without that key every frame counts as used</source>
        <translation>session.json: provenance.frames_used ist beschädigt (%1); ohne diesen Schlüssel zählt jedes Bild als benutzt</translation>
    </message>
    <message>
        <source>slip</source>
        <translation>Abgleiten</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>stamped as block %1</source>
        <translation>gestempelt als Block %1</translation>
    </message>
    <message>
        <source>stamped as frame %1</source>
        <translation>gestempelt als Bild %1</translation>
    </message>
    <message>
        <source>stamped with an impossible time</source>
        <translation>mit einer unmöglichen Zeit gestempelt</translation>
    </message>
    <message>
        <source>started</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>step %1 of a session of %2</source>
        <translation>Schritt %1 einer Sitzung mit %2</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>zurückgenommen</translation>
    </message>
    <message>
        <source>target and overshoot together reach the far side of the cell; choose a target nearer, or less overshoot</source>
        <translation>Ziel und Überschuss reichen zusammen an die ferne Seite der Zelle; wählen Sie ein näheres Ziel oder weniger Überschuss</translation>
    </message>
    <message>
        <source>the axis through the cell's centre does not cross the contour</source>
        <translation>die Achse durch die Mitte der Zelle schneidet die Kontur nicht</translation>
    </message>
    <message>
        <source>the cell profile's content is not JSON; check the profile's file</source>
        <translation>der Inhalt des Zellprofils ist kein JSON; prüfen Sie die Datei des Profils</translation>
    </message>
    <message>
        <source>the cell's damping at the hand would be</source>
        <translation>die Dämpfung der Zelle an der Hand wäre</translation>
    </message>
    <message>
        <source>the cell's force at the hand would be</source>
        <translation>die Kraft der Zelle an der Hand wäre</translation>
    </message>
    <message>
        <source>the cell's rest shape is not known</source>
        <translation>die Ruheform der Zelle ist nicht bekannt</translation>
    </message>
    <message>
        <source>the cell's stiffness at the hand would be</source>
        <translation>die Steifigkeit der Zelle an der Hand wäre</translation>
    </message>
    <message>
        <source>the contact would need a device damping of</source>
        <translation>der Kontakt bräuchte eine Dämpfung des Geräts von</translation>
    </message>
    <message>
        <source>the contour does not match the model's</source>
        <translation>die Kontur stimmt nicht mit der des Modells überein</translation>
    </message>
    <message>
        <source>the contour has fewer than 8 points</source>
        <translation>die Kontur hat weniger als 8 Punkte</translation>
    </message>
    <message>
        <source>the contour lies wholly to one side of the cell's centre</source>
        <translation>die Kontur liegt ganz auf einer Seite der Zellmitte</translation>
    </message>
    <message>
        <source>the contour or its axis has a number that is not finite</source>
        <translation>die Kontur oder ihre Achse enthält eine nicht endliche Zahl</translation>
    </message>
    <message>
        <source>the contours lack one of the arrays membrane, center_um, axis, rest_radius_um</source>
        <translation>den Konturen fehlt eines der Felder membrane, center_um, axis, rest_radius_um</translation>
    </message>
    <message>
        <source>the daemon answers without naming its device</source>
        <translation>der Dienst antwortet, ohne sein Gerät zu nennen</translation>
    </message>
    <message>
        <source>the daemon spacenavd does not answer at %1 (%2); start it: sudo systemctl restart spacenavd</source>
        <translation>der Dienst spacenavd antwortet nicht unter %1 (%2); starten Sie ihn: sudo systemctl restart spacenavd</translation>
    </message>
    <message>
        <source>the daemon spacenavd is not installed (no %1); sudo apt-get install spacenavd</source>
        <translation>der Dienst spacenavd ist nicht installiert (kein %1); sudo apt-get install spacenavd</translation>
    </message>
    <message>
        <source>the daemon spacenavd is not running (no %1); start it: sudo systemctl start spacenavd</source>
        <translation>der Dienst spacenavd läuft nicht (kein %1); starten Sie ihn: sudo systemctl start spacenavd</translation>
    </message>
    <message>
        <source>the default device</source>
        <translation>das Standardgerät</translation>
    </message>
    <message>
        <source>the device has no force output: nothing to scale; choose a device with force</source>
        <translation>das Gerät gibt keine Kraft aus: es gibt nichts zu skalieren; wählen Sie ein Gerät mit Kraft</translation>
    </message>
    <message>
        <source>the dimple is more lopsided than the model explains</source>
        <translation>die Delle ist schiefer, als das Modell erklärt</translation>
    </message>
    <message>
        <source>the disk is slower than the camera</source>
        <translation>der Datenträger ist langsamer als die Kamera</translation>
    </message>
    <message>
        <source>the driver fell silent; check cable and power</source>
        <translation>der Treiber antwortet nicht mehr; prüfen Sie Kabel und Stromversorgung</translation>
    </message>
    <message>
        <source>the driver gave a position that is not a number</source>
        <translation>der Treiber gab eine Position, die keine Zahl ist</translation>
    </message>
    <message>
        <source>the driver's library is present; a device is opened when chosen</source>
        <translation>die Bibliothek des Treibers ist vorhanden; ein Gerät wird geöffnet, wenn es gewählt wird</translation>
    </message>
    <message>
        <source>the exposure time must be a number, ms</source>
        <translation>die Belichtungszeit muss eine Zahl sein, ms</translation>
    </message>
    <message>
        <source>the indentation is deeper than the model reaches</source>
        <translation>die Eindellung ist tiefer, als das Modell reicht</translation>
    </message>
    <message>
        <source>the model found no equilibrium: %1</source>
        <translation>das Modell fand kein Gleichgewicht: %1</translation>
    </message>
    <message>
        <source>the needle has slipped, or the membrane does not follow its tip</source>
        <translation>die Nadel ist abgeglitten, oder die Membran folgt ihrer Spitze nicht</translation>
    </message>
    <message>
        <source>the needle's direction is unknown; bring the needle into the image first</source>
        <translation>die Richtung der Nadel ist unbekannt; bringen Sie zuerst die Nadel ins Bild</translation>
    </message>
    <message>
        <source>the path leads through the holding pipette; turn the cell, or move the needle to another side</source>
        <translation>der Weg führt durch die Haltepipette; drehen Sie die Zelle, oder führen Sie die Nadel auf eine andere Seite</translation>
    </message>
    <message>
        <source>the port can't be used; see above</source>
        <translation>der Anschluss ist nicht benutzbar; siehe oben</translation>
    </message>
    <message>
        <source>the processor is too busy to write as fast as the camera</source>
        <translation>der Prozessor ist zu beschäftigt, um so schnell zu schreiben, wie die Kamera liefert</translation>
    </message>
    <message>
        <source>the program's %1 are not at %2; install Pellucida again, or set %3 to the folder that holds them</source>
        <translation>der Ordner mit %1 des Programms liegt nicht unter %2; installieren Sie Pellucida neu, oder setzen Sie %3 auf den Ordner, der sie enthält</translation>
    </message>
    <message>
        <source>the program's own path cannot be read from /proc; set %1 to the folder of the %2</source>
        <translation>der eigene Pfad des Programms ist aus /proc nicht lesbar; setzen Sie %1 auf den Ordner mit %2</translation>
    </message>
    <message>
        <source>the replay was stopped before its end</source>
        <translation>die Wiedergabe wurde vor ihrem Ende angehalten</translation>
    </message>
    <message>
        <source>the rows of a table differ in length</source>
        <translation>die Zeilen einer Tabelle sind verschieden lang</translation>
    </message>
    <message>
        <source>the scene has no frame to track</source>
        <translation>die Szene enthält kein Bild zum Verfolgen</translation>
    </message>
    <message>
        <source>the shape is unstable</source>
        <translation>die Form ist instabil</translation>
    </message>
    <message>
        <source>the simulated injector</source>
        <translation>der simulierte Injektor</translation>
    </message>
    <message>
        <source>the target lies outside the cell; choose one within the inner membrane</source>
        <translation>das Ziel liegt außerhalb der Zelle; wählen Sie eines innerhalb der inneren Membran</translation>
    </message>
    <message>
        <source>the video %1 can't be written whole; check the free space of its folder</source>
        <translation>das Video %1 lässt sich nicht ganz schreiben; prüfen Sie den freien Platz in seinem Ordner</translation>
    </message>
    <message>
        <source>the video %1 can't be written; choose a folder that exists and may be written, and .mp4 or .avi</source>
        <translation>das Video %1 lässt sich nicht schreiben; wählen Sie einen vorhandenen, beschreibbaren Ordner und .mp4 oder .avi</translation>
    </message>
    <message>
        <source>the virtual camera has no automatic exposure; set a time</source>
        <translation>die virtuelle Kamera hat keine automatische Belichtung; stellen Sie eine Zeit ein</translation>
    </message>
    <message>
        <source>there are</source>
        <translation>vorhanden sind</translation>
    </message>
    <message>
        <source>thinned</source>
        <translation>ohne Oberfläche</translation>
    </message>
    <message>
        <source>this cell's forces are %1 times the profile's, +- %2 %</source>
        <translation>die Kräfte dieser Zelle sind %1-mal die des Profils, +- %2 %</translation>
    </message>
    <message>
        <source>this machine has none; plug in a USB serial adapter</source>
        <translation>dieser Rechner hat keinen; stecken Sie einen USB-Seriell-Adapter ein</translation>
    </message>
    <message>
        <source>time budget spent</source>
        <translation>Zeitvorrat erschöpft</translation>
    </message>
    <message>
        <source>tip at %1 %2 um, confidence %3</source>
        <translation>Spitze bei %1 %2 um, Sicherheit %3</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>unmeasured</source>
        <translation>ungemessen</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>weight of the contour: it must be 0 or above</source>
        <translation>Gewicht der Kontur: es muss 0 oder mehr sein</translation>
    </message>
    <message>
        <source>what looks like a cell has a radius of %1 um, profile %2 one of %3 um; check the pixel size, give another profile, or click the cell</source>
        <translation>was wie eine Zelle aussieht, hat einen Radius von %1 um, das Profil %2 einen von %3 um; prüfen Sie die Pixelgröße, wählen Sie ein anderes Profil, oder klicken Sie auf die Zelle</translation>
    </message>
    <message>
        <source>with rumble</source>
        <translation>mit Rumpeln</translation>
    </message>
    <message>
        <source>without rumble</source>
        <translation>ohne Rumpeln</translation>
    </message>
</context>
</TS>
