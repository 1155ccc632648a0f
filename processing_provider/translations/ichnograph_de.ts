<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Ichnograph</name>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>shift %1</source>
        <translation>Verschiebung %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>rotation %1</source>
        <translation>Drehung %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>levelled scale</source>
        <translation>horizontiert mit Maßstab</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>shift, the scanner&#x27;s position</source>
        <translation>Verschiebung, Position des Scanners</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>unknown scale</source>
        <translation>unbekannter Maßstab</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>The folder %1 holds no point cloud; choose another, or single files.</source>
        <translation>Der Ordner %1 enthält keine Punktwolke; einen anderen oder einzelne Dateien wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>No point cloud was given; choose at least one file.</source>
        <translation>Es wurde keine Punktwolke angegeben; mindestens eine Datei wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is listed twice; remove one entry.</source>
        <translation>%1 ist doppelt aufgeführt; einen Eintrag entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 has an unknown extension; convert it to %2.</source>
        <translation>%1 hat eine unbekannte Endung; in %2 umwandeln.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 does not exist or is not a file; check the name and the folder.</source>
        <translation>%1 gibt es nicht oder ist keine Datei; Namen und Ordner prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is empty; copy or export it again.</source>
        <translation>%1 ist leer; erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>the cloud in the chosen coordinate reference system</source>
        <translation>die Punktwolke im gewählten Koordinatenbezugssystem</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>There is no coordinate reference system in %1 and none was chosen, so the results have none either.</source>
        <translation>In %1 steht kein Koordinatenbezugssystem, und es wurde keines gewählt; daher haben auch die Ergebnisse keines.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is in %2, but %3 in %4; reproject them to the same coordinate reference system.</source>
        <translation>%1 liegt in %2 vor, %3 aber in %4; in dasselbe Koordinatenbezugssystem umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>There is no coordinate reference system in %1, so %2 of the other files is used for them.</source>
        <translation>In %1 steht kein Koordinatenbezugssystem; daher wird dafür %2 der anderen Dateien verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is in %2, so the chosen %3 is not used.</source>
        <translation>%1 liegt in %2 vor; das gewählte %3 wird nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 and %2 more files</source>
        <translation>%1 und %2 weitere Dateien</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: workers were lost one after another at the same work; give them more memory, and see their logs for the reason.</source>
        <translation>SCHEDULER %1: Worker sind nacheinander bei derselben Arbeit verloren gegangen; ihnen mehr Arbeitsspeicher geben und in ihren Protokollen nach dem Grund sehen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the connection was lost; check that the scheduler runs, and start again.</source>
        <translation>SCHEDULER %1: Die Verbindung ist abgebrochen; prüfen, ob der Scheduler läuft, und neu starten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the cluster has no worker any more; start some, and start again.</source>
        <translation>SCHEDULER %1: Der Cluster hat keinen Worker mehr; welche starten und neu beginnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER needs distributed %1 or newer on all computers, because older ones do not bear the loss of a worker; this computer has %2.</source>
        <translation>SCHEDULER braucht distributed %1 oder neuer auf allen Rechnern, weil ältere Versionen den Verlust eines Workers nicht vertragen; dieser Rechner hat %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: Dask has no certificates; state them in its configuration (distributed.comm.tls).</source>
        <translation>SCHEDULER %1: Dask hat keine Zertifikate; sie in seiner Konfiguration angeben (distributed.comm.tls).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: no scheduler answers there within %2 s; check the address, the network, and that it runs (`dask scheduler`).</source>
        <translation>SCHEDULER %1: Dort antwortet binnen %2 s kein Scheduler; die Adresse und das Netz prüfen und ob er läuft (`dask scheduler`).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1 is not an address; write it like tcp://192.168.0.10:8786.</source>
        <translation>SCHEDULER %1 ist keine Adresse; sie wie tcp://192.168.0.10:8786 schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>the scheduler</source>
        <translation>der Scheduler</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the cluster has no workers; start some (`dask worker`).</source>
        <translation>SCHEDULER %1: Der Cluster hat keine Worker; welche starten (`dask worker`).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>the worker %1</source>
        <translation>der Worker %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: workers cannot import %2 (%3); put the folder that holds the plugin&#x27;s folder on their PYTHONPATH.</source>
        <translation>SCHEDULER %1: Worker können %2 nicht importieren (%3); den Ordner, in dem der Ordner der Erweiterung liegt, in ihren PYTHONPATH aufnehmen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: %2 has %3 %4, this computer %5; install the same version on all.</source>
        <translation>SCHEDULER %1: %2 hat %3 %4, dieser Rechner %5; auf allen dieselbe Version installieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/sorting.py"/>
        <source>Connecting to %1</source>
        <translation>Verbindung zu %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/sorting.py"/>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <location filename="../../algorithms/clouds/formats/text.py"/>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/tasks.py"/>
        <source>SCHEDULER: a worker does not find %1; keep the clouds where all workers find them by the same path.</source>
        <translation>SCHEDULER: Ein Worker findet %1 nicht; die Punktwolken dort ablegen, wo alle Worker sie unter demselben Pfad finden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/tasks.py"/>
        <source>SCHEDULER: a worker finds another file than this computer as %1; keep the clouds where all workers find them by the same path.</source>
        <translation>SCHEDULER: Ein Worker findet unter %1 eine andere Datei als dieser Rechner; die Punktwolken dort ablegen, wo alle Worker sie unter demselben Pfad finden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/__init__.py"/>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/__init__.py"/>
        <source>%1 or text (%2)</source>
        <translation>%1 oder Text (%2)</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>%1 m in %2</source>
        <translation>%1 m in %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 have single precision, so they lie in steps of %2; export it with double precision, or with coordinates near 0.</source>
        <translation>Die Koordinaten von %1 haben einfache Genauigkeit und liegen daher in Stufen von %2; mit doppelter Genauigkeit oder mit Koordinaten nahe 0 exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 are whole numbers, which were read as metres; if they are millimetres, convert them, or write the unit into the names of the columns.</source>
        <translation>Die Koordinaten von %1 sind ganze Zahlen und wurden als Meter gelesen; sind es Millimeter, sie umrechnen oder die Einheit in die Namen der Spalten schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 are multiples of %2; if they were rounded, and do not form a grid, export it with three decimals or more.</source>
        <translation>Die Koordinaten von %1 sind Vielfache von %2; wenn sie gerundet wurden und kein Raster bilden, mit drei oder mehr Nachkommastellen exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>%1 of the points of %2 are at 0, 0, 0, where programs put what was not measured; remove them.</source>
        <translation>%1 der Punkte von %2 liegen bei 0, 0, 0, wohin Programme legen, was nicht gemessen wurde; diese Punkte entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The points of %1 reach over %2 m in height; if their coordinates are millimetres, convert them to metres.</source>
        <translation>Die Punkte von %1 reichen über %2 m in der Höhe; sind ihre Koordinaten Millimeter, sie in Meter umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/facade/output/orthoimage.py"/>
        <location filename="../../algorithms/facade/points.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>%1 is not an E57 file; give it the extension of its format.</source>
        <translation>%1 ist keine E57-Datei; die Endung ihres Formats verwenden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>its parts contradict each other</source>
        <translation>ihre Teile widersprechen sich</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>%1 is truncated or damaged (%2); copy or export it again.</source>
        <translation>%1 ist abgeschnitten oder beschädigt (%2); erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <location filename="../../algorithms/facade/points.py"/>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>Some scans of %1 have no %2, which counts as 0 there; export all scans alike.</source>
        <translation>Einigen Scans von %1 fehlt: %2; dort zählt es als 0. Alle Scans gleich exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>Scan %1 of %2 has no pose, though others have, and was not moved; check that it is registered.</source>
        <translation>Scan %1 von %2 hat keine Pose, andere dagegen schon, und wurde nicht bewegt; prüfen, ob er registriert ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>%1 has angles of up to %2, though E57 prescribes radians; export it again with Cartesian coordinates.</source>
        <translation>%1 hat Winkel bis %2, obwohl E57 Bogenmaß vorschreibt; mit kartesischen Koordinaten erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>%1 has a scan without coordinates; export it again.</source>
        <translation>%1 enthält einen Scan ohne Koordinaten; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>The pose of scan %1 of %2 %3; export the scan again with its pose.</source>
        <translation>Die Orientierung des Scans %1 von %2 %3; den Scan mit seiner Orientierung erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>The rotation of scan %1 of %2 %3; check how it was exported.</source>
        <translation>Die Drehung des Scans %1 von %2 %3; prüfen, wie er exportiert wurde.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>is all zero, so the scan is not turned</source>
        <translation>ist durchgehend null; der Scan wird daher nicht gedreht</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>has the length %1 instead of 1</source>
        <translation>hat die Länge %1 statt 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1: %2 withheld points and points of noise were left out.</source>
        <translation>%1: %2 zurückgehaltene und als Rauschen klassifizierte Punkte wurden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 of the points of %2 are flagged as withheld or classified as noise, and are left out; change their class where they are wanted.</source>
        <translation>%1 der Punkte von %2 sind als zurückgehalten markiert oder als Rauschen klassifiziert und werden ausgelassen; werden sie gebraucht, ihre Klasse ändern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>The coordinates of %1 lie in steps of %2 m, the scale in its header; export it with a scale of 0.001 m or finer.</source>
        <translation>Die Koordinaten von %1 liegen in Stufen von %2 m, dem Maßstab im Dateikopf; mit einem Maßstab von 0.001 m oder feiner exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 has coordinates that are not numbers because the scale or offset in its header is not valid; export it again.</source>
        <translation>%1 hat Koordinaten, die keine Zahlen sind, weil Maßstab oder Versatz im Dateikopf ungültig ist; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 is mirrored by a negative scale in its header; export it again.</source>
        <translation>%1 ist durch einen negativen Maßstab im Dateikopf gespiegelt; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>a record after its points announces more than there is</source>
        <translation>ein Datensatz nach den Punkten kündigt mehr an, als vorhanden ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>The header of %1 announces no points; the %2 that follow it were read, so check that the file is complete.</source>
        <translation>Der Dateikopf von %1 kündigt keine Punkte an; die %2 folgenden wurden gelesen. Prüfen, ob die Datei vollständig ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>The header of %1 announces %2 points, but %3 more follow, which were left out; export it again.</source>
        <translation>Der Kopf von %1 kündigt %2 Punkte an, aber %3 weitere folgen, die weggelassen wurden; die Datei neu exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>%1 is not a LAS or LAZ file; give it the extension of its format.</source>
        <translation>%1 ist keine LAS- oder LAZ-Datei; die Endung ihres Formats verwenden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>it ends within the header</source>
        <translation>sie endet im Dateikopf</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>there is no version %1.%2 of LAS</source>
        <translation>eine Version %1.%2 von LAS gibt es nicht</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces more records than it has room for</source>
        <translation>der Dateikopf kündigt mehr Datensätze an, als Platz haben</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces %1 bytes a point</source>
        <translation>der Dateikopf kündigt %1 Bytes je Punkt an</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces %1 points, but it ends before the last</source>
        <translation>der Dateikopf kündigt %1 Punkte an, aber die Datei endet vor dem letzten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it lacks the record of its compression</source>
        <translation>der Datensatz der Komprimierung fehlt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it cannot be decoded: %1</source>
        <translation>sie kann nicht dekodiert werden: %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it ends before its last point</source>
        <translation>sie endet vor dem letzten Punkt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its record of the compression is cut off</source>
        <translation>der Datensatz der Komprimierung ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its record of the compression does not fit its points</source>
        <translation>der Datensatz der Komprimierung passt nicht zu den Punkten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its compression %1 is not known</source>
        <translation>die Komprimierung %1 ist nicht bekannt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its compressed chunks are larger than any program writes</source>
        <translation>die komprimierten Blöcke sind größer, als irgendein Programm sie schreibt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>the table of its compressed chunks is missing</source>
        <translation>die Tabelle der komprimierten Blöcke fehlt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>the table of its compressed chunks announces more than there is</source>
        <translation>die Tabelle der komprimierten Blöcke kündigt mehr an, als vorhanden ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>one of its compressed chunks announces more than it holds</source>
        <translation>einer der komprimierten Blöcke kündigt mehr an, als er enthält</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its header announces %1 points, but its chunks hold %2 at most</source>
        <translation>der Dateikopf kündigt %1 Punkte an, die Blöcke enthalten aber höchstens %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its header announces %1 points, more than it has room for</source>
        <translation>der Dateikopf kündigt %1 Punkte an, mehr als Platz haben</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>it ends within its compressed points</source>
        <translation>sie endet in den komprimierten Punkten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/normals.py"/>
        <source>%1 of %2 seem to be normals; they are not turned if the cloud is, unless they are called nx, ny and nz.</source>
        <translation>%1 von %2 scheinen Normalen zu sein; sie werden nicht mitgedreht, wenn die Punktwolke gedreht wird, es sei denn, sie heißen nx, ny und nz.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>the number at the end of its last line %1 is cut off</source>
        <translation>die Zahl am Ende der letzten Zeile %1 ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>%1 holds a character 0 among its numbers, so it is damaged; copy or export it again.</source>
        <translation>%1 enthält zwischen den Zahlen ein Zeichen 0 und ist daher beschädigt; erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>holds something that is not a number</source>
        <translation>enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>has %1 numbers instead of %2</source>
        <translation>hat %1 Zahlen statt %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>Line %1 of %2 %3; copy or export the file again.</source>
        <translation>Zeile %1 von %2 %3; die Datei erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 gives coordinates in %2; they were converted to metres.</source>
        <translation>%1 enthält Koordinaten in %2; sie wurden in Meter umgerechnet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>The header of %1 announces %2 points, but more follow, which were left out; export it again.</source>
        <translation>Der Kopf von %1 kündigt %2 Punkte an, aber weitere folgen, die weggelassen wurden; die Datei neu exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>it announces %1 points and has %2</source>
        <translation>sie kündigt %1 Punkte an und hat %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>%1 has a property %2 with decimals where its header announces whole numbers; export it again.</source>
        <translation>%1 hat eine Eigenschaft %2 mit Nachkommastellen, wo der Dateikopf ganze Zahlen ankündigt; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>%1 has a property %2 beyond the range of its type; export it again.</source>
        <translation>%1 hat eine Eigenschaft %2 außerhalb des Bereichs ihres Typs; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 is a PLY of an unknown encoding; export it again.</source>
        <translation>%1 ist eine PLY-Datei mit unbekannter Kodierung; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 is not a PLY file; give it the extension of its format.</source>
        <translation>%1 ist keine PLY-Datei; die Endung ihres Formats verwenden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has a header that cannot be read; export it again.</source>
        <translation>Der Dateikopf von %1 ist nicht lesbar; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has vertices without x, y and z; export it again as a point cloud.</source>
        <translation>%1 hat Punkte ohne x, y und z; als Punktwolke erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has the property %2 with its vertices or before them, which cannot be read; export it again as a point cloud.</source>
        <translation>%1 hat bei den Punkten oder davor die Eigenschaft %2, die nicht gelesen werden kann; als Punktwolke erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>is all zero, so that every point would lie in one position</source>
        <translation>ist durchgehend null, sodass alle Punkte an einer Stelle lägen</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>moves the points by %1 m</source>
        <translation>verschiebt die Punkte um %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>presses or blows up the points beyond any unit of length</source>
        <translation>staucht oder streckt die Punkte über jede Längeneinheit hinaus</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>mirrors the points</source>
        <translation>spiegelt die Punkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>distorts the points because its rotation is not orthogonal</source>
        <translation>verzerrt die Punkte, weil die Drehung nicht orthogonal ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>scales the points by %1</source>
        <translation>skaliert die Punkte um %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>intensity or colour</source>
        <translation>Intensität oder Farbe</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>is 0 there</source>
        <translation>dort 0</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>is left out there</source>
        <translation>dort ausgelassen</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>Scans of %1 have unlike columns, %2 in the first and %3 in others, so %4 %5; export all scans alike.</source>
        <translation>Scans von %1 haben ungleiche Spalten, %2 im ersten und %3 in anderen; daher ist %4 %5. Alle Scans gleich exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>a scan announces %1 cells and has %2</source>
        <translation>ein Scan kündigt %1 Zellen an und hat %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>%1 has no header of a PTX scan from line %2 on; give it the extension of its format, or export it again.</source>
        <translation>%1 hat ab Zeile %2 keinen Dateikopf eines PTX-Scans; die Endung des Formats verwenden oder erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>does not end in the column 0 0 0 1</source>
        <translation>endet nicht mit der Spalte 0 0 0 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>The pose of the scan in line %1 of %2 %3; export the scan again with its pose.</source>
        <translation>Die Orientierung des Scans in Zeile %1 von %2 %3; den Scan mit seiner Orientierung erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>The pose of the scan in line %1 of %2 %3; check how it was exported.</source>
        <translation>Die Orientierung des Scans in Zeile %1 von %2 %3; prüfen, wie er exportiert wurde.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>differs from the position and axes of the scanner above it, by %1 m in position</source>
        <translation>weicht von Position und Achsen des Scanners darüber ab, in der Position um %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>differs from the axes of the scanner above it, by up to %1 degrees</source>
        <translation>weicht von den Achsen des Scanners darüber ab, um bis zu %1 Grad</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>Line %1 of %2 has %3 numbers instead of 4 (x y z intensity) or 7 (and colour); export it again as PTX.</source>
        <translation>Zeile %1 von %2 hat %3 Zahlen statt 4 (x y z Intensität) oder 7 (und Farbe); erneut als PTX exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>The coordinate reference system in %1 cannot be understood.</source>
        <translation>Das Koordinatenbezugssystem in %1 ist nicht verständlich.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>%1 states a system of heights only (%2), which is ignored.</source>
        <translation>%1 nennt nur ein Höhensystem (%2); es wird nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>%1 states a local system (%2), which ties it to no position on the earth, so it counts as none.</source>
        <translation>%1 nennt ein lokales System (%2), das nicht mit der Erde verknüpft ist; es gilt als keines.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text.py"/>
        <source>it announces %1 points and holds %2</source>
        <translation>sie kündigt %1 Punkte an und enthält %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The first column of %1 can be x, or the number or time of a point; name the columns in a first line, as &#x27;x y z intensity&#x27; or &#x27;time x y z&#x27;.</source>
        <translation>Die erste Spalte von %1 kann x oder die Nummer oder Zeit eines Punktes sein; die Spalten in einer ersten Zeile benennen: &#x27;x y z intensity&#x27; oder &#x27;time x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The first two columns of %1 can be x and y, or the row and the column in the scan; name the columns in a first line, as &#x27;row column x y z&#x27;.</source>
        <translation>Die ersten beiden Spalten von %1 können x und y sein, oder Zeile und Spalte im Scan; die Spalten in einer ersten Zeile benennen, etwa &#x27;row column x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>%1 has fewer than three columns of numbers; export it as x y z.</source>
        <translation>%1 hat weniger als drei Spalten mit Zahlen; als x y z exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>Column %1 of %2 has no name and counts the points or states a time, so it was left out; name the columns in a first line, as &#x27;x y z intensity&#x27;.</source>
        <translation>Spalte %1 von %2 hat keinen Namen und zählt die Punkte oder nennt eine Zeit; sie wurde weggelassen. Die Spalten in einer ersten Zeile benennen, wie &#x27;x y z intensity&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The last four columns of %1 can be intensity and colour or colour and intensity, so both were left out; name the columns in a first line, as &#x27;x y z intensity red green blue&#x27;.</source>
        <translation>Die letzten vier Spalten von %1 können Intensität und Farbe oder Farbe und Intensität sein; beides wurde ausgelassen. Die Spalten in einer ersten Zeile benennen: &#x27;x y z intensity red green blue&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The columns of %1 after x y z have no names and were left out.</source>
        <translation>Die Spalten von %1 nach x y z haben keine Namen und wurden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 is a model of surfaces, not a point cloud; export its points as x y z.</source>
        <translation>%1 ist ein Modell aus Flächen, keine Punktwolke; seine Punkte als x y z exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 of the first rows of %2, the first in line %3, begin as remarks do and were read as points, because their first field is a name.</source>
        <translation>%1 der ersten Zeilen von %2, die erste in Zeile %3, beginnen wie Kommentare und wurden als Punkte gelesen, weil ihr erstes Feld ein Name ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>Column %1 of %2 has no name and was read as intensity; if it is something else, name the columns in a first line.</source>
        <translation>Spalte %1 von %2 hat keinen Namen und wurde als Intensität gelesen; ist sie etwas anderes, die Spalten in einer ersten Zeile benennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 is a raster grid, not a point cloud; choose the cloud itself.</source>
        <translation>%1 ist ein Rastergitter und keine Punktwolke; die Punktwolke selbst wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 has coordinates that are not numbers; export it again.</source>
        <translation>%1 hat Koordinaten, die keine Zahlen sind; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>%1 cannot be read between the lines %2 and %3; look for unusual characters there.</source>
        <translation>%1 kann zwischen den Zeilen %2 und %3 nicht gelesen werden; dort nach ungewöhnlichen Zeichen suchen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>Line %1 of %2 holds a character 0, so the file is damaged; copy or export it again.</source>
        <translation>Zeile %1 von %2 enthält ein Zeichen 0, die Datei ist also beschädigt; erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>its last line %1 is cut off</source>
        <translation>ihre letzte Zeile %1 ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2 %3; correct or remove that line.</source>
        <translation>Zeile %1 von %2 %3; diese Zeile berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has %1 columns instead of %2</source>
        <translation>hat %1 Spalten statt %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has &#x27;%1&#x27; where a number is expected</source>
        <translation>enthält &#x27;%1&#x27;, wo eine Zahl erwartet wird</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/value_ranges.py"/>
        <source>%1 has colours above %2, though points from all over the file have none; export it again with colours of one range, or without colour.</source>
        <translation>%1 hat Farben über %2, obwohl Punkte aus der ganzen Datei keine solchen haben; mit Farben eines einzigen Wertebereichs oder ohne Farbe erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 cannot be read (%2); check that it exists and that you may read it.</source>
        <translation>%1 kann nicht gelesen werden (%2); prüfen, ob die Datei vorhanden ist und gelesen werden darf.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <source>%1 is truncated (%2); copy or export it again.</source>
        <translation>%1 ist abgeschnitten (%2); erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <source>%1 holds no points; leave it out or export it again.</source>
        <translation>%1 enthält keine Punkte; weglassen oder erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/thinning/thinning.py"/>
        <location filename="../../algorithms/site_plan/density/windows.py"/>
        <source>Thinning</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>The temporary folder %1 has %2 GB free, but %3 points take up to %4 GB; free some space, or set TMPDIR to a folder on a larger disk.</source>
        <translation>Im temporären Ordner %1 sind %2 GB frei, aber %3 Punkte brauchen bis zu %4 GB; Platz schaffen oder TMPDIR auf einen Ordner eines größeren Laufwerks setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>it ends early</source>
        <translation>sie endet vorzeitig</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>The temporary file of the points cannot be written or read (%1); free some space in the temporary folder, or set TMPDIR to a folder on a larger disk.</source>
        <translation>Die temporäre Datei der Punkte kann nicht geschrieben oder gelesen werden (%1); im temporären Ordner Platz schaffen oder TMPDIR auf einen Ordner eines größeren Laufwerks setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>%1: %2 of %3 points lie more than %4 km high or deep; transform geocentric coordinates to a projected coordinate reference system in metres first.</source>
        <translation>%1: %2 von %3 Punkten liegen mehr als %4 km hoch oder tief; geozentrische Koordinaten zuerst in ein projiziertes Koordinatenbezugssystem in Metern umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>%1: %2 of %3 points lie far away from the site and are left out.</source>
        <translation>%1: %2 von %3 Punkten liegen weit vom Objekt entfernt und werden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: %2 seems to be up, because floors and ceilings lie across it; turn the cloud so that z is up, for instance by 90 degrees about x, because walls are looked for along z.</source>
        <translation>%1: %2 scheint nach oben zu zeigen, denn Fußböden und Decken liegen quer dazu; die Punktwolke so drehen, dass z nach oben zeigt, zum Beispiel um 90 Grad um x, denn Wände werden entlang z gesucht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: %2 seems to be up, because floors and ceilings lie across it; turn the cloud so that z is up, for instance by 90 degrees about y, because walls are looked for along z.</source>
        <translation>%1: %2 scheint nach oben zu zeigen, denn Fußböden und Decken liegen quer dazu; die Punktwolke so drehen, dass z nach oben zeigt, zum Beispiel um 90 Grad um y, denn Wände werden entlang z gesucht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: the cloud seems to stand on its head, because its ground lies above its walls; change the sign of z and of one of x and y, which turns it over without mirroring it.</source>
        <translation>%1: Die Punktwolke scheint auf dem Kopf zu stehen, denn ihr Boden liegt über den Wänden; das Vorzeichen von z und von einem der beiden x und y ändern, das dreht sie um, ohne sie zu spiegeln.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: floors and walls are tilted by %2 degrees towards the azimuth %3 degrees, which costs walls; level the cloud first, for instance by registering it with MODEL rigid.</source>
        <translation>%1: Fußböden und Wände sind um %2 Grad in Richtung des Azimuts %3 Grad geneigt; dadurch gehen Wände verloren. Die Punktwolke zuerst horizontieren, zum Beispiel durch eine Registrierung mit MODEL starr.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/las_files.py"/>
        <source>%1 cannot hold points that lie so far apart; remove the points far away, or choose a text file.</source>
        <translation>%1 kann keine Punkte aufnehmen, die so weit auseinanderliegen; die weit entfernten Punkte entfernen oder eine Textdatei wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>Left out of %1: %2. Write LAS or LAZ from LAS or LAZ files of one point format to keep everything.</source>
        <translation>Nicht in %1 enthalten: %2. LAS oder LAZ aus LAS- oder LAZ-Dateien eines Punktformats schreiben, um alles zu behalten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>There is no colour in %1, so the points from there are black in %2.</source>
        <translation>In %1 gibt es keine Farbe, daher sind die Punkte von dort in %2 schwarz.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>There is no intensity in %1, so it is 0 in %2 for the points from there.</source>
        <translation>In %1 gibt es keine Intensität, daher ist sie in %2 für die Punkte von dort 0.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>Some inputs have the seconds of a week as GPS times and others those since 1980. %1 holds them unchanged, and states the kind of %2.</source>
        <translation>Einige Eingaben haben als GPS-Zeiten die Sekunden der Woche, andere die seit 1980. %1 enthält sie unverändert und nennt die Art von %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/point_selection.py"/>
        <source>No point is left to write to %1.</source>
        <translation>Es bleibt kein Punkt, der in %1 geschrieben werden kann.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/target.py"/>
        <source>%1 has an extension that cannot be written; choose %2.</source>
        <translation>%1 hat eine Endung, die nicht geschrieben werden kann; %2 wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/target.py"/>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 is an input as well; choose another name for the output.</source>
        <translation>%1 ist zugleich Eingabe; einen anderen Namen für die Ausgabe wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 and %2 would both become %3; transform one of them later, into another folder.</source>
        <translation>Aus %1 und %2 würde beide Male %3; eine davon später in einen anderen Ordner transformieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1, which transformations in metres cannot move,</source>
        <translation>%1, das Transformationen in Metern nicht verschieben können,</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>The matrix for %1 is rounded, which moves its points by up to %2 m, because they lie far from 0; write the matrix with more decimals.</source>
        <translation>Die Matrix für %1 ist gerundet; das verschiebt die Punkte um bis zu %2 m, weil sie weit von 0 entfernt liegen. Die Matrix mit mehr Nachkommastellen schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 holds waveforms, which are left out.</source>
        <translation>%1 enthält Wellenformen; sie werden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/drawing.py"/>
        <location filename="../../algorithms/facade/output/annotations.py"/>
        <location filename="../../algorithms/facade/output/drawing.py"/>
        <source>layer</source>
        <translation>Layer</translation>
    </message>
    <message>
        <location filename="../../algorithms/drawing.py"/>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/facade/output/schedule.py"/>
        <location filename="../../algorithms/raster.py"/>
        <location filename="../../algorithms/site_plan/output/layers.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <location filename="../../algorithms/drawing.py"/>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <location filename="../../algorithms/errors.py"/>
        <source>read</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <location filename="../../algorithms/errors.py"/>
        <source>%1 cannot be %2 without %3; install what is missing.</source>
        <translation>%1 kann ohne %3 nicht %2 werden; das Fehlende installieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/boundary.py"/>
        <source>The outlines are %1 km long, more than %2 km; choose the walls of one site, and check that their coordinates are metres.</source>
        <translation>Die Umrisse sind %1 km lang, mehr als %2 km; die Wände eines einzigen Objekts wählen und prüfen, ob die Koordinaten in Metern sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/site_plan/output/layers.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../algorithms/site_plan/storeys/walls/walls.py"/>
        <location filename="../../processing_provider/styles/plan.qml"/>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/site_plan/storeys/joining.py"/>
        <location filename="../../algorithms/site_plan/storeys/walls/walls.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>column</source>
        <translation>Stütze</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>glazing</source>
        <translation>Verglasung</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>%1 cannot be read as a layer of a drawn plan: %2.</source>
        <translation>%1 kann nicht als Layer eines gezeichneten Plans gelesen werden: %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>%1 has no feature of the kind judged; draw the region that is to be judged.</source>
        <translation>%1 hat kein Objekt der Art judged; den Bereich zeichnen, der beurteilt werden soll.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/facade/output/schedule.py"/>
        <location filename="../../algorithms/raster.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/facade/output/schedule.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>sill</source>
        <translation>Brüstungshöhe</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <location filename="../../algorithms/evaluation/plan_layer.py"/>
        <location filename="../../algorithms/site_plan/output/layers.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 of %4 is listed twice; remove one entry.</source>
        <translation>Zeile %1 von %2: Das Maß „%3“ von %4 ist doppelt aufgeführt; einen Eintrag entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 gives lengths in %2; they were converted to metres.</source>
        <translation>%1 enthält Längen in %2; sie wurden in Meter umgerechnet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the dimension must be width, height or sill, not %3.</source>
        <translation>Zeile %1 von %2: Das Maß muss width, height oder sill sein, nicht %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 has no lengths; name its columns id, width, height and sill, or id, dimension and length.</source>
        <translation>%1 enthält keine Längen; die Spalten id, width, height und sill oder id, dimension und length nennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2 has no id; add the one of its detail.</source>
        <translation>Zeile %1 von %2 hat keine Kennung; die ihres Details ergänzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 of facade %2</source>
        <translation>%1 der Fassade %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 %4 is not a length in metres.</source>
        <translation>Zeile %1 von %2: %3 %4 ist keine Länge in Metern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 %4 is not a standard deviation.</source>
        <translation>Zeile %1 von %2: %3 %4 ist keine Standardabweichung.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 has no length of %2; use the ids of the schedule in both, and its column facade if it has one.</source>
        <translation>%1 hat keine Länge von %2; in beiden Dateien die Nummern (id) der Maßliste verwenden und ihre Spalte facade, wenn sie eine hat.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 has no %2.</source>
        <translation>In %1 fehlt: %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>The lengths of %1 are about %2 times those of %3, as if they were in %4; write metres, or the unit in the header, as &#x27;width [mm]&#x27;.</source>
        <translation>Die Längen von %1 sind etwa %2-mal so groß wie die von %3, als wären sie in %4 angegeben; Meter schreiben oder die Einheit in der Kopfzeile nennen, etwa &#x27;width [mm]&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths_report.py"/>
        <source>automatic minus manual</source>
        <translation>automatisch minus manuell</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>Feature %1 of %2 has a coordinate that is not a number; remove it.</source>
        <translation>Objekt %1 von %2 hat eine Koordinate, die keine Zahl ist; das Objekt entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 holds no outlines; choose a layer of polygons.</source>
        <translation>%1 enthält keine Umrisse; einen Polygonlayer wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>Outlines of %1 that cross themselves were repaired: %2.</source>
        <translation>Umrisse von %1, die sich selbst schneiden, wurden repariert: %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 holds lines; choose a layer of polygons, as siteplan writes it.</source>
        <translation>%1 enthält Linien; einen Polygonlayer wählen, wie siteplan ihn schreibt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 has no coordinate reference system; that of %2 is assumed.</source>
        <translation>%1 hat kein Koordinatenbezugssystem; das von %2 wird angenommen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 and %2 have nothing in common: they are %3 m apart; check that both show the same site in the same coordinate reference system.</source>
        <translation>%1 und %2 haben nichts gemeinsam: Sie liegen %3 m auseinander. Prüfen, ob beide dasselbe Objekt im selben Koordinatenbezugssystem zeigen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 is in %2, but %3 in %4; reproject one of them with Reproject layer.</source>
        <translation>%1 liegt in %2 vor, %3 aber in %4; einen der beiden mit „Layer reprojizieren“ umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <source>agrees</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/registration/simulation/trials.py"/>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <source>distance (cm)</source>
        <translation>Abstand (cm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>%1 lengths: mean difference %2 mm, standard deviation %3 mm, largest %4 mm. Aitelkadi and others (2014) report 4 mm and 6 mm for 19 lengths.</source>
        <translation>%1 Längen: mittlere Differenz %2 mm, Standardabweichung %3 mm, größte %4 mm. Aitelkadi und andere (2014) geben für 19 Längen 4 mm und 6 mm an.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Differences</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic and manual lengths</source>
        <translation>Automatische und manuelle Längen</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic minus manual length.</source>
        <translation>Automatische minus manuelle Länge.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic (m)</source>
        <translation>Automatisch (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Manual (m)</source>
        <translation>Manuell (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Difference (mm)</source>
        <translation>Differenz (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Difference / std</source>
        <translation>Differenz / Standardabweichung</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1% of the reference is in the plan (completeness at %2).</source>
        <translation>%1 % der Referenz sind im Plan (Vollständigkeit bei %2).</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1% of the plan is in the reference (correctness at %2).</source>
        <translation>%1 % des Plans sind in der Referenz (Richtigkeit bei %2).</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Where the reference is in the plan, half of it is within %1 cm, 95 % within %2 cm.</source>
        <translation>Wo die Referenz im Plan ist, liegt die Hälfte davon innerhalb von %1 cm, 95 % innerhalb von %2 cm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Intersection over union of the areas: %1.</source>
        <translation>Schnitt durch Vereinigung (IoU) der Flächen: %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Rooms of the reference: %1 found, %2 missed, %3 invented; median error of the area %4 %.</source>
        <translation>Räume der Referenz: %1 gefunden, %2 nicht gefunden, %3 erfunden; Median des Flächenfehlers %4 %.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Rooms of the reference: %1 found, %2 missed, %3 invented.</source>
        <translation>Räume der Referenz: %1 gefunden, %2 nicht gefunden, %3 erfunden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Where they agree</source>
        <translation>Wo sie übereinstimmen</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>How far apart they are</source>
        <translation>Wie weit sie auseinanderliegen</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Longest errors</source>
        <translation>Längste Fehler</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1 m are wrong, %2 m missing.</source>
        <translation>%1 m sind falsch, %2 m fehlen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>There are no errors.</source>
        <translation>Es gibt keine Fehler.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>What the numbers mean</source>
        <translation>Was die Zahlen bedeuten</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Plan and reference</source>
        <translation>Plan und Referenz</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Green: the plan, where it agrees with the reference (grey). Red: the plan, where the reference has nothing within the tolerance. Blue: the reference, where the plan has nothing.</source>
        <translation>Grün: der Plan, wo er mit der Referenz (grau) übereinstimmt. Rot: der Plan, wo die Referenz innerhalb der Toleranz nichts hat. Blau: die Referenz, wo der Plan nichts hat.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of each boundary that is within a distance of the other one. The dashed line is the tolerance.</source>
        <translation>Anteil jeder Begrenzung, der innerhalb eines Abstands von der anderen liegt. Die gestrichelte Linie ist die Toleranz.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>within</source>
        <translation>innerhalb von</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>of the reference: completeness (%)</source>
        <translation>der Referenz: Vollständigkeit (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>of the plan: correctness (%)</source>
        <translation>des Plans: Richtigkeit (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>length (m)</source>
        <translation>Länge (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>median offset (m)</source>
        <translation>Median des Versatzes (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>largest offset (m)</source>
        <translation>größter Versatz (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>x of its middle</source>
        <translation>x der Mitte</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>The longest %1 of %2.</source>
        <translation>Die längsten %1 von %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Completeness</source>
        <translation>Vollständigkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of the reference&#x27;s boundary with a boundary of the plan within the tolerance, %1.</source>
        <translation>Anteil der Begrenzung der Referenz, bei dem eine Begrenzung des Plans innerhalb der Toleranz von %1 liegt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Correctness</source>
        <translation>Richtigkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of the plan&#x27;s boundary with a boundary of the reference within the tolerance.</source>
        <translation>Anteil der Begrenzung des Plans, bei dem eine Begrenzung der Referenz innerhalb der Toleranz liegt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Median and 95 % offset</source>
        <translation>Versatz, Median und 95 %</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Of the distances from the reference&#x27;s boundary to the plan&#x27;s, where the plan has it within the tolerance.</source>
        <translation>Der Abstände von der Begrenzung der Referenz zu der des Plans, wo dieser sie innerhalb der Toleranz hat.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Intersection over union</source>
        <translation>Schnitt durch Vereinigung (IoU)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Area that is wall in both, divided by the area that is wall in either. Not known if the reference consists of lines.</source>
        <translation>Fläche, die in beiden Wand ist, geteilt durch die Fläche, die in einem von beiden Wand ist. Nicht bekannt, wenn die Referenz aus Linien besteht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>No facade was found, so leave FACADE 0, and FACADE_NEAR and FACADE_ALONG empty.</source>
        <translation>Es wurde keine Fassade gefunden; FACADE auf 0 und FACADE_NEAR und FACADE_ALONG leer lassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE_NEAR is %1 m from the nearest facade; give it in the coordinates of the site.</source>
        <translation>FACADE_NEAR liegt %1 m von der nächsten Fassade entfernt; den Punkt in den Koordinaten des Objekts angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE is %1, but the cloud has %2 facades; choose one from 1 to %3 in the report, or 0.</source>
        <translation>FACADE ist %1, aber die Punktwolke hat %2 Fassaden; eine von 1 bis %3 aus dem Bericht wählen, oder 0.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE_ALONG has a line or a polygon without a facade within %1 m; give it in the coordinates of the site, along the outside of the walls.</source>
        <translation>FACADE_ALONG enthält eine Linie oder ein Polygon ohne Fassade innerhalb von %1 m; in den Koordinaten des Objekts angeben, entlang der Außenseite der Wände.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>as narrow as a joint</source>
        <translation>so schmal wie eine Fuge</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>its colour changes gradually, as that of a stain or of lamplight does</source>
        <translation>die Farbe ändert sich allmählich, wie bei einem Fleck oder Lampenlicht</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>its colour differs no more than the wall&#x27;s own colours do</source>
        <translation>die Farbe weicht nicht stärker ab als die Farben der Wand untereinander</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>the intensity shows no edge, as that of a shadow does not</source>
        <translation>die Intensität zeigt keine Kante, wie bei einem Schatten</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/curves.py"/>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <location filename="../../algorithms/facade/outlines/edges.py"/>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <location filename="../../algorithms/registration/matching/matching_matrix.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <location filename="../../algorithms/site_plan/faces/face_points.py"/>
        <location filename="../../algorithms/site_plan/rooms/doors.py"/>
        <location filename="../../algorithms/targets/checkerboards/extent.py"/>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>A round wall with a radius of %1 m is rolled out.</source>
        <translation>Eine runde Wand mit einem Radius von %1 m wird abgewickelt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>%1 sides are rolled out: %2 m long.</source>
        <translation>%1 Seiten werden abgewickelt: %2 m lang.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>No round wall with a radius of %1 to %2 m was found of which %3 degrees are seen; cut the cloud to the tower, or choose another UNROLL.</source>
        <translation>Es wurde keine runde Wand mit einem Radius von %1 bis %2 m gefunden, von der %3 Grad zu sehen sind; die Punktwolke auf den Turm zuschneiden oder für UNROLL etwas anderes wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>No sides were found that meet at the facade and turn by %1 to %2 degrees; choose another UNROLL.</source>
        <translation>Es wurden keine Seiten gefunden, die an der Fassade aneinanderstoßen und um %1 bis %2 Grad abknicken; für UNROLL etwas anderes wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>recess</source>
        <translation>Rücksprung</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>coloured detail</source>
        <translation>farbiges Detail</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>projection</source>
        <translation>Vorsprung</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>trapezium</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>arch</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <location filename="../../algorithms/facade/openings/niches.py"/>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <location filename="../../algorithms/site_plan/density/bands.py"/>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1:</source>
        <translation>Fassade %1:</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1 is not drawn: %2</source>
        <translation>Fassade %1 wird nicht gezeichnet: %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1: %2</source>
        <translation>Fassade %1: %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>no straight sides, as of a stain</source>
        <translation>keine geraden Seiten, wie bei einem Fleck</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>parallel to the wall, but not a part of it</source>
        <translation>parallel zur Wand, aber kein Teil von ihr</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Tracing borders</source>
        <translation>Ränder werden verfolgt</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Triangulating the wall</source>
        <translation>Die Wand wird trianguliert</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The wall has points %1 mm apart; alpha is %2 m.</source>
        <translation>Die Punkte der Wand haben %1 mm Abstand; Alpha ist %2 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Making outlines</source>
        <translation>Umrisse werden gebildet</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The facade faces azimuth %1 degrees, SIDE %2, with a certainty of %3 %, because %4.</source>
        <translation>Die Fassade zeigt zum Azimut %1 Grad, SIDE %2, mit einer Sicherheit von %3 %, denn %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>%1 regions of one colour (SEED_VARIANCE %2) are %3 surfaces.</source>
        <translation>%1 Regionen einer Farbe (SEED_VARIANCE %2) sind %3 Flächen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The intensities of the %1 scans have different levels (%2 to %3), so each scan is scaled by its own.</source>
        <translation>Die Intensitäten der %1 Scans haben verschiedene Niveaus (%2 bis %3); daher wird jeder Scan mit seinem eigenen skaliert.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Intensities that differ by less than %1 of the wall&#x27;s are one surface.</source>
        <translation>Intensitäten, die sich um weniger als %1 derjenigen der Wand unterscheiden, gehören zu einer Fläche.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>No part of the wall is as large as %1 m²; decrease MIN_AREA, or increase ALPHA.</source>
        <translation>Kein Teil der Wand ist so groß wie %1 m²; MIN_AREA verringern oder ALPHA erhöhen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>It is uncertain from which side the facade is seen: azimuth %1 degrees was taken, because %2. If the elevation is mirrored, set SIDE to %3.</source>
        <translation>Es ist unsicher, von welcher Seite die Fassade gesehen wird: Azimut %1 Grad wurde angenommen, denn %2. Ist die Ansicht gespiegelt, SIDE auf %3 setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The points have no colour, so only openings, recesses and projections are found.</source>
        <translation>Die Punkte haben keine Farbe; daher werden nur Öffnungen, Rücksprünge und Vorsprünge gefunden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The points have no intensity, so a cast shadow can appear as a coloured detail; check the coloured details.</source>
        <translation>Die Punkte haben keine Intensität; daher kann ein Schlagschatten als farbiges Detail erscheinen. Die farbigen Details prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>passage</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/niches.py"/>
        <source>niche</source>
        <translation>Nische</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>fewer than three straight sides were seen, as of damage or a shadow</source>
        <translation>weniger als drei gerade Seiten wurden gesehen, wie bei einem Schaden oder Schatten</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>shallow and small, as of damage of the stone</source>
        <translation>flach und klein, wie bei einem Schaden am Stein</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>nothing was seen behind it, so that the wall may not have been scanned there</source>
        <translation>dahinter wurde nichts gesehen, sodass die Wand dort vielleicht nicht gescannt wurde</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>low, and without head and sill, as of a gap between things on the ground</source>
        <translation>niedrig und ohne Sturz und Brüstung, wie eine Lücke zwischen Dingen am Boden</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>not bounded by the wall all around</source>
        <translation>nicht ringsum von der Wand begrenzt</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>narrow, at the end of the wall or of what was scanned of it</source>
        <translation>schmal, am Ende der Wand oder dessen, was von ihr gescannt wurde</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>a part of the wall that bends or is a little set back, without an edge around it</source>
        <translation>ein Teil der Wand, der gebogen ist oder etwas zurückliegt, ohne Kante ringsum</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>ragged, as of damage or a shadow</source>
        <translation>ausgefranst, wie bei einem Schaden oder Schatten</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>flat</source>
        <translation>waagrecht</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>sloped</source>
        <translation>schräg</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>segmental</source>
        <translation>Segmentbogen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>round</source>
        <translation>Rundbogen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>pointed</source>
        <translation>Spitzbogen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <source>unseen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/orthoimage.py"/>
        <source>The orthoimage would have %1 x %2 pixels, more than %3; raise PIXEL_SIZE, or cut the cloud to the facade.</source>
        <translation>Das Orthobild hätte %1 x %2 Pixel, mehr als %3; PIXEL_SIZE erhöhen oder die Punktwolke auf die Fassade zuschneiden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/report.py"/>
        <source>Its sides are rolled out beside each other: u runs along the wall.</source>
        <translation>Ihre Seiten sind nebeneinander abgewickelt: u verläuft entlang der Wand.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/report.py"/>
        <source>It is round and rolled out: u runs along the arc, on a radius of %1 m.</source>
        <translation>Sie ist rund und abgewickelt: u verläuft entlang des Bogens, auf einem Radius von %1 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facade %1 of %2. It faces azimuth %3 degrees (certainty %4 %), because %5. Its wall has %6 m² without openings, and points %7 mm apart; %8 m² were not seen.</source>
        <translation>Fassade %1 von %2. Sie zeigt zum Azimut %3 Grad (Sicherheit %4 %), denn %5. Ihre Wand hat ohne Öffnungen %6 m², und ihre Punkte haben %7 mm Abstand; %8 m² wurden nicht gesehen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facade %1 of %2. It faces azimuth %3 degrees. Its wall has %4 m² without openings, and points %5 mm apart; %6 m² were not seen.</source>
        <translation>Fassade %1 von %2. Sie zeigt zum Azimut %3 Grad. Ihre Wand hat ohne Öffnungen %4 m², und ihre Punkte haben %5 mm Abstand; %6 m² wurden nicht gesehen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>It faces azimuth %1 degrees (certainty %2 %), because %3. Its wall has %4 m² without openings, and points %5 mm apart; %6 m² were not seen.</source>
        <translation>Sie zeigt zum Azimut %1 Grad (Sicherheit %2 %), denn %3. Ihre Wand hat ohne Öffnungen %4 m², und ihre Punkte haben %5 mm Abstand; %6 m² wurden nicht gesehen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>It faces azimuth %1 degrees. Its wall has %2 m² without openings, and points %3 mm apart; %4 m² were not seen.</source>
        <translation>Sie zeigt zum Azimut %1 Grad. Ihre Wand hat ohne Öffnungen %2 m², und ihre Punkte haben %3 mm Abstand; %4 m² wurden nicht gesehen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facades of the cloud</source>
        <translation>Fassaden der Punktwolke</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>FACADE takes a number of this table, FACADE_NEAR a point near a facade, FACADE_ALONG a line along it; ALL draws every one.</source>
        <translation>FACADE ist eine Nummer dieser Tabelle, FACADE_NEAR ein Punkt nahe einer Fassade, FACADE_ALONG eine Linie entlang einer Fassade; ALL zeichnet alle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Parts of the wall</source>
        <translation>Teile der Wand</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Sizes in brackets have an edge that was not seen. Completed edges are where the openings of the same row have theirs.</source>
        <translation>Maße in Klammern haben eine Kante, die nicht gesehen wurde. Ergänzte Kanten liegen dort, wo die Öffnungen derselben Reihe ihre haben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>LEFT_OUT is a layer of them.</source>
        <translation>LEFT_OUT ist ein Layer davon.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Elevation of a facade</source>
        <translation>Ansicht einer Fassade</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Key plan. The facade that is drawn is red; arrows show where facades face.</source>
        <translation>Übersichtsplan. Die gezeichnete Fassade ist rot; Pfeile zeigen, wohin die Fassaden weisen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Facade</source>
        <translation>Fassade</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Azimuth (degrees)</source>
        <translation>Azimut (Grad)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Length (m)</source>
        <translation>Länge (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Height (m)</source>
        <translation>Höhe (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Area (m²)</source>
        <translation>Fläche (m²)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Seen by scanners before it</source>
        <translation>Von Scannern davor gesehen</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>In front of the main wall (m)</source>
        <translation>Vor der Hauptwand (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Use</source>
        <translation>Nutzung</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Width (m)</source>
        <translation>Breite (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Sill (m)</source>
        <translation>Brüstungshöhe (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Depth (m)</source>
        <translation>Tiefe (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Edges measured</source>
        <translation>Gemessene Kanten</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Completed</source>
        <translation>Ergänzt</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>the scanners that measured %1 % of the wall stood on that side</source>
        <translation>die Scanner, die %1 % der Wand gemessen haben, standen auf dieser Seite</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>SIDE says so</source>
        <translation>SIDE gibt es so vor</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>%1 m behind it a parallel surface, its inner face, covers %2 % of the wall, and one in front %3 %</source>
        <translation>%1 m dahinter bedeckt eine parallele Fläche, ihre Innenseite, %2 % der Wand, und eine davor %3 %</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>%1 % of the pixels with points close behind the wall lie in its holes, and %2 % of those close in front</source>
        <translation>%1 % der Pixel mit Punkten nahe hinter der Wand liegen in ihren Löchern, und %2 % derer nahe davor</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>most points far from the wall are on that side (%1 of %2), and its holes do not show which side is the front</source>
        <translation>die meisten Punkte weit von der Wand liegen auf dieser Seite (%1 von %2), und ihre Löcher zeigen nicht, wo vorne ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>ceilings, or the area seen on each side, show where the open air is; the points close to the wall do not show its front</source>
        <translation>Decken oder die auf jeder Seite gesehene Fläche zeigen, wo draußen ist; die Punkte nahe der Wand zeigen nicht, wo vorne ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>The chosen facade has no plane with DISTANCE %1 m; increase DISTANCE, or choose another FACADE.</source>
        <translation>Die gewählte Fassade hat mit DISTANCE %1 m keine Ebene; DISTANCE erhöhen oder für FACADE eine andere Nummer wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>%1 points are in %2 cubes of %3 m.</source>
        <translation>%1 Punkte liegen in %2 Würfeln von %3 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>The main plane covers %1 m².</source>
        <translation>Die Hauptebene bedeckt %1 m².</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>No upright plane was found in a cloud of %1 m; if the coordinates are in millimetres or feet, convert them to metres.</source>
        <translation>In einer Punktwolke von %1 m wurde keine lotrechte Ebene gefunden; Koordinaten in Millimetern oder Fuß in Meter umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>No upright plane of %1 m² or more was found with DISTANCE %2 m; increase DISTANCE, and check that z points up and that the coordinates are in metres.</source>
        <translation>Mit DISTANCE %2 m wurde keine lotrechte Ebene von %1 m² oder mehr gefunden; DISTANCE erhöhen und prüfen, ob z nach oben zeigt und die Koordinaten in Metern sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>Planes of fewer than %1 points are left out.</source>
        <translation>Ebenen mit weniger als %1 Punkten werden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>The points of %1 reach over %2 m, more than the %3 m of any facade; cut the cloud to the facade, or check that its coordinates are metres.</source>
        <translation>Die Punkte von %1 reichen über %2 m, mehr als die %3 m einer Fassade; die Punktwolke auf die Fassade zuschneiden oder prüfen, ob die Koordinaten in Metern sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>The %1 points were thinned to %2, %3 mm apart; clip the cloud to the facade to keep more.</source>
        <translation>Die %1 Punkte wurden auf %2 mit %3 mm Abstand ausgedünnt; um mehr zu behalten, die Punktwolke auf die Fassade zuschneiden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>%1 has no %2, so the %3 of the other files is ignored.</source>
        <translation>In %1 fehlt: %2; daher wird %3 der anderen Dateien nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/selection.py"/>
        <source>%1 facades were found; number %2 is measured: %3 m long, %4 m high, azimuth %5 degrees. FACADE takes another one.</source>
        <translation>%1 Fassaden wurden gefunden; Nummer %2 wird gemessen: %3 m lang, %4 m hoch, Azimut %5 Grad. FACADE wählt eine andere.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written because its folder does not exist; create it first.</source>
        <translation>%1 kann nicht geschrieben werden, weil es den Ordner nicht gibt; ihn zuerst anlegen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written because the disk is full; free some space or choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden, weil das Laufwerk voll ist; Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written; close it where it is open, or choose a folder that may be written to.</source>
        <translation>%1 kann nicht geschrieben werden; die Datei schließen, wo sie geöffnet ist, oder einen beschreibbaren Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written (%2); choose another name or folder.</source>
        <translation>%1 kann nicht geschrieben werden (%2); einen anderen Namen oder Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/geometry/polygons.py"/>
        <location filename="../../algorithms/raster.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <location filename="../../algorithms/progress.py"/>
        <location filename="../../processing_provider/interruption.py"/>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/raster.py"/>
        <source>%1 was not written completely; free some space or choose another folder.</source>
        <translation>%1 wurde nicht vollständig geschrieben; Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The coordinate reference system of %1 is not understood; assign it again.</source>
        <translation>Das Koordinatenbezugssystem von %1 ist nicht verständlich; es neu zuweisen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>%1: this coordinate reference system is not understood; choose one with an EPSG code.</source>
        <translation>%1: Dieses Koordinatenbezugssystem ist nicht verständlich; eines mit einem EPSG-Code wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The heights of %1 are in %2; convert them to metres.</source>
        <translation>Die Höhen von %1 sind in %2 angegeben; in Meter umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The points of %1 lie outside the area of %2; choose the system that their coordinates have, or none if they are local.</source>
        <translation>Die Punkte von %1 liegen außerhalb des Gebiets von %2; das Bezugssystem ihrer Koordinaten wählen, oder keines, wenn sie lokal sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>x and y of %1 seem to be swapped, because they lie in the area of %2 only the other way round; the plan would be mirrored, so write easting before northing.</source>
        <translation>x und y von %1 scheinen vertauscht zu sein, denn nur vertauscht liegen sie im Gebiet von %2; der Plan wäre gespiegelt. Den Rechtswert vor den Hochwert schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The axes of %1, the system of %2, point %3 and %4, but plans show them to the right and up; reproject the points to a system of easting and northing.</source>
        <translation>Die Achsen von %1, dem System von %2, zeigen nach %3 und %4 (englisch), Pläne zeigen sie aber nach rechts und oben; die Punkte in ein System mit Rechts- und Hochwert umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>Lengths in %1, the system of %2, are %3 times those on the ground; reproject the points to a system such as UTM.</source>
        <translation>Längen in %1, dem System von %2, sind %3-mal so lang wie in der Natur; die Punkte in ein System wie UTM umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>x and y of %1 seem to be swapped, because, if they are metres, x is a northing of %2 km and y an easting of %3 km; the plan would be mirrored, so write easting before northing.</source>
        <translation>x und y von %1 scheinen vertauscht zu sein, weil, wenn sie in Metern sind, x ein Hochwert von %2 km und y ein Rechtswert von %3 km ist; der Plan wäre gespiegelt, deshalb den Rechtswert vor den Hochwert schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The coordinates of %1 are %2 (%3); reproject to a projected coordinate reference system in metres.</source>
        <translation>Die Koordinaten von %1 sind %2 (%3); in ein projiziertes Koordinatenbezugssystem in Metern umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>in degrees</source>
        <translation>in Grad</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>earth-centred</source>
        <translation>geozentrisch</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>heights only</source>
        <translation>nur Höhen</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>not those of a map</source>
        <translation>nicht die einer Karte</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/block_adjustment.py"/>
        <source>%1 has too few points left</source>
        <translation>In %1 bleiben zu wenige Punkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/registration/results.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>surveyed</source>
        <translation>eingemessen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The residuals of %1 are %2 times as large as the standard deviations of its targets and of the control points suggest (chi-square probability %3); look for wrong targets, or set CONTROL_SIGMA to how accurately the points were surveyed.</source>
        <translation>Die Restklaffungen von %1 sind %2-mal so groß, wie die Standardabweichungen seiner Zielmarken und der Passpunkte erwarten lassen (Chi-Quadrat-Wahrscheinlichkeit %3); nach falschen Zielmarken suchen oder CONTROL_SIGMA auf die Genauigkeit setzen, mit der die Punkte eingemessen wurden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The residuals of %1 are %2 times as large as SIGMA suggests (chi-square probability %3); look for wrong targets, or set SIGMA to %4.</source>
        <translation>Die Restklaffungen von %1 sind %2-mal so groß, wie SIGMA erwarten lässt (Chi-Quadrat-Wahrscheinlichkeit %3); nach falschen Zielmarken suchen oder SIGMA auf %4 setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The targets of %1 have standard deviations of up to %2 mm, more than the limit of %3 mm; survey control points in it, or connect it to more scans.</source>
        <translation>Die Zielmarken von %1 haben Standardabweichungen bis %2 mm, mehr als die Grenze von %3 mm; darin Passpunkte einmessen oder den Scan mit weiteren Scans verknüpfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/least_squares.py"/>
        <source>a scan is held by nothing</source>
        <translation>ein Scan wird durch nichts gehalten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>One unit of the scan is %1 m.</source>
        <translation>Eine Einheit des Scans ist %1 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale does not differ significantly from 1; a model without scale suffices.</source>
        <translation>Der Maßstab weicht nicht signifikant von 1 ab; ein Modell ohne Maßstab genügt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale does not differ significantly from 1.</source>
        <translation>Der Maßstab weicht nicht signifikant von 1 ab.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale differs from 1 by %1 ppm, %2 mm over the %3 m of the targets, which suggests</source>
        <translation>Der Maßstab weicht um %1 ppm von 1 ab, %2 mm über die %3 m der Zielmarken. Mögliche Ursache:</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 a wrong target, a SIGMA that is too small, or a scanner that needs calibration; if other scans have the same scale, keep the model with scale.</source>
        <translation>%1 eine falsche Zielmarke, ein zu kleiner Wert von SIGMA oder ein Scanner, der kalibriert werden muss; haben andere Scans denselben Maßstab, das Modell mit Maßstab beibehalten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 a wrong target, a SIGMA that is too small, or a scanner that needs calibration; if other scans have the same scale, choose a model with scale.</source>
        <translation>%1 eine falsche Zielmarke, ein zu kleiner Wert von SIGMA oder ein Scanner, der kalibriert werden muss; haben andere Scans denselben Maßstab, ein Modell mit Maßstab wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>keep the model with scale</source>
        <translation>das Modell mit Maßstab beibehalten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>choose a model with scale, or reduce the distances</source>
        <translation>ein Modell mit Maßstab wählen oder die Strecken reduzieren</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 grid coordinates that are not reduced for the projection; %2.</source>
        <translation>%1 nicht wegen der Abbildung reduzierte Gitterkoordinaten; %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/covariances.py"/>
        <source>%1 of the %2 points in %3 count like points without standard deviations, because one of these is missing or not positive, or the correlations contradict each other.</source>
        <translation>%1 der %2 Punkte in %3 zählen wie Punkte ohne Standardabweichungen, weil eine davon fehlt oder nicht positiv ist oder die Korrelationen einander widersprechen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/covariances.py"/>
        <source>The standard deviations in %1 are %2 m in the median; check their unit.</source>
        <translation>Die Standardabweichungen in %1 betragen im Median %2 m; ihre Einheit prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no table (.dbf) beside it, so its points have no names; copy all its parts.</source>
        <translation>Neben %1 fehlt die Tabelle (.dbf), daher haben die Punkte keine Namen; alle Teile kopieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 is not a single point; remove it or split it up.</source>
        <translation>Objekt %1 von %2 ist kein Einzelpunkt; entfernen oder aufteilen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has more than %2 points, too many for a list; choose the list, not a cloud.</source>
        <translation>%1 hat mehr als %2 Punkte, zu viele für eine Liste; die Liste wählen, keine Punktwolke.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 holds no points; choose another layer.</source>
        <translation>%1 enthält keine Punkte; einen anderen Layer wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 has a coordinate that is not a number; correct or remove it.</source>
        <translation>Objekt %1 von %2 hat eine Koordinate, die keine Zahl ist; berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>feature %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no layer %2 of points; choose among: %3.</source>
        <translation>%1 hat keinen Punktlayer %2; einen von diesen wählen: %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no layer of points; choose another file.</source>
        <translation>%1 hat keinen Punktlayer; eine andere Datei wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has several layers of points (%2); write %3|layername=%4.</source>
        <translation>%1 hat mehrere Punktlayer (%2); %3|layername=%4 schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 cannot be read as a layer (%2); save it again.</source>
        <translation>%1 kann nicht als Layer gelesen werden (%2); erneut speichern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>The points of %1 have no heights; give them Z values, or a field of numbers called z.</source>
        <translation>Die Punkte von %1 haben keine Höhen; ihnen Z-Werte oder ein Zahlenfeld namens z geben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Z is %1 everywhere in %2, so the heights are those of its field %3.</source>
        <translation>Z ist in %2 überall %1; daher gelten die Höhen des Feldes %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Z is %1 at %2 points of %3, though its field %4 holds heights of some of them; correct Z, or fill in the field.</source>
        <translation>Z ist bei %2 Punkten von %3 %1, obwohl das Feld %4 für einige davon Höhen enthält; Z berichtigen oder das Feld ausfüllen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>0 or no height</source>
        <translation>0 oder ohne Höhe</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 has no name; give it one.</source>
        <translation>Objekt %1 von %2 hat keinen Namen; ihm einen geben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>The height of %1 in %2 is below %3 m, as of a point whose height is not known; correct it, or leave the point out.</source>
        <translation>Die Höhe von %1 in %2 liegt unter %3 m, wie bei einem Punkt, dessen Höhe nicht bekannt ist; sie berichtigen oder den Punkt weglassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>Two points of %1 are called %2, in %3 and %4; rename or remove one of them.</source>
        <translation>Zwei Punkte von %1 heißen %2, in %3 und %4; einen umbenennen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>Points of %1 that are listed repeatedly count once: %2.</source>
        <translation>Mehrfach aufgeführte Punkte von %1 zählen einmal: %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>name the columns in a first line, as &#x27;name x y z&#x27; or &#x27;x y z intensity&#x27;.</source>
        <translation>die Spalten in einer ersten Zeile benennen: &#x27;name x y z&#x27; oder &#x27;x y z intensity&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>a list of points</source>
        <translation>eine Punktliste</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2, the last, is cut off; copy or export the list again.</source>
        <translation>Zeile %1 von %2, die letzte, ist abgeschnitten; die Liste erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>standard deviations</source>
        <translation>Standardabweichungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 gives %2 in %3; they were converted to metres.</source>
        <translation>%1 enthält %2 in %3; sie wurden in Meter umgerechnet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2 is neither a point like those below nor a header; correct it, or put # before it.</source>
        <translation>Zeile %1 von %2 ist weder ein Punkt wie die folgenden noch eine Kopfzeile; berichtigen oder # davorsetzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 has fewer than three columns of numbers; export it as name x y z.</source>
        <translation>%1 hat weniger als drei Spalten mit Zahlen; als name x y z exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>It is not clear which column of %1 holds the names; %2</source>
        <translation>Es ist nicht klar, welche Spalte von %1 die Namen enthält; %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>The first column of %1 can be names or coordinates; %2</source>
        <translation>Die erste Spalte von %1 kann Namen oder Koordinaten enthalten; %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 seems to hold numbers of points with x and y but no z; add the heights, or name the columns in a first line, as &#x27;x y z&#x27;.</source>
        <translation>%1 scheint Punktnummern mit x und y, aber ohne z zu enthalten; die Höhen ergänzen oder die Spalten in einer ersten Zeile benennen: &#x27;x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has no name</source>
        <translation>hat keinen Namen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>name, x, y and z</source>
        <translation>name, x, y und z</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>x, y and z</source>
        <translation>x, y und z</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>, and their standard deviations,</source>
        <translation>, und ihre Standardabweichungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Only %1 of %2 were read; its further columns were left out.</source>
        <translation>Nur %1 von %2 wurden gelesen; die weiteren Spalten wurden ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>All heights in %1 are 0; if they are not known, add them.</source>
        <translation>Alle Höhen in %1 sind 0; sind sie unbekannt, sie ergänzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 rows of %2, the first in line %3, begin as remarks do and were left out; remove the sign before them if they are points.</source>
        <translation>%1 Zeilen von %2, die erste in Zeile %3, beginnen wie Kommentare und wurden ausgelassen; sind es Punkte, das Zeichen davor entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>kilometres</source>
        <translation>Kilometer</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>the control list</source>
        <translation>die Passpunktliste</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <source>units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit if the coordinates of %4 are in %5; convert them to metres.</source>
        <translation>%1 von %2 Zielmarken von %3 passen, wenn die Koordinaten von %4 in %5 angegeben sind; in Meter umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>tilted</source>
        <translation>geneigt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit if the scan is tilted by %4 degrees; choose a model that is not levelled, or correct the order of the axes (z is up).</source>
        <translation>%1 von %2 Zielmarken von %3 passen, wenn der Scan um %4 Grad geneigt ist; ein nicht horizontiertes Modell wählen oder die Reihenfolge der Achsen berichtigen (z zeigt nach oben).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit with a scale error of %4 ppm, which suggests grid coordinates that are not reduced for the projection; choose a model with scale (MODEL=%5).</source>
        <translation>%1 von %2 Zielmarken von %3 passen bei einem Maßstabsfehler von %4 ppm, was auf nicht wegen der Abbildung reduzierte Gitterkoordinaten hindeutet; ein Modell mit Maßstab wählen (MODEL=%5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>By their names, %1 of %2 targets of %3 fit with a scale of %4; if the scan may have another scale than the control points, choose a model with scale (MODEL=%5), else check units and control list.</source>
        <translation>Nach ihren Namen passen %1 von %2 Zielmarken von %3 bei einem Maßstab von %4; darf der Scan einen anderen Maßstab als die Passpunkte haben, ein Modell mit Maßstab wählen (MODEL=%5), sonst Einheiten und Passpunktliste prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>misfit</source>
        <translation>passt nicht</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>By their names, the targets of %1 do not fit the control points, but by their distances %2 of %3 do; correct the names, or match by distances.</source>
        <translation>Nach ihren Namen passen die Zielmarken von %1 nicht zu den Passpunkten, nach ihren Strecken aber %2 von %3; die Namen berichtigen oder nach Strecken zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>The targets of %1 do not fit the control points of their names: fewer than %2 of them agree within %3 in their distances; correct the names, or raise SIGMA or TOLERANCE.</source>
        <translation>Die Zielmarken von %1 passen nicht zu den gleichnamigen Passpunkten: Weniger als %2 davon stimmen in ihren Strecken innerhalb von %3 überein. Die Namen berichtigen oder SIGMA oder TOLERANCE erhöhen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/matching/scan_matching.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/adjustment.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>no overlap</source>
        <translation>keine Überlappung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>Fewer than %1 of %2 targets of %3 have the distances of control points within %4, and so few may match by accident; check that the list belongs to this site, pick more targets, or raise SIGMA or TOLERANCE.</source>
        <translation>Weniger als %1 von %2 Zielmarken von %3 haben innerhalb von %4 Strecken von Passpunkten, und so wenige können zufällig passen; prüfen, ob die Liste zu diesem Objekt gehört, mehr Zielmarken messen oder SIGMA oder TOLERANCE erhöhen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>chance</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 match, but %4 accidental matches of as many are expected; pick more targets, or match by names.</source>
        <translation>%1 von %2 Zielmarken von %3 passen, aber %4 zufällige Zuordnungen von ebenso vielen sind zu erwarten; mehr Zielmarken messen oder nach Namen zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1 is tilted by %2 degrees; if the scanner stood upright, the axes of a list are in another order (z is up).</source>
        <translation>%1 ist um %2 Grad geneigt; stand der Scanner aufrecht, haben die Achsen einer Liste eine andere Reihenfolge (z zeigt nach oben).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>The matched targets of %1 lie in one plane or symmetrically, so that a mirrored list would fit as well (%2); check the position of the scanner in the report, or add a target.</source>
        <translation>Die zugeordneten Zielmarken von %1 liegen in einer Ebene oder symmetrisch, sodass eine gespiegelte Liste ebenso gut passen würde (%2); die Position des Scanners im Bericht prüfen oder eine Zielmarke hinzufügen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>The search for the targets of %1 was ended before all triangles were tried, because there are too many; a solution with more targets may exist. Shorten the lists to make sure.</source>
        <translation>Die Suche nach den Zielmarken von %1 wurde beendet, bevor alle Dreiecke geprüft waren, weil es zu viele sind; es kann eine Lösung mit mehr Zielmarken geben. Um sicherzugehen, die Listen kürzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>Target %1 of %2 lies %3 m from the control point of its name</source>
        <translation>Die Zielmarke %1 von %2 liegt %3 m vom gleichnamigen Passpunkt entfernt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>, but %1 m from %2: its name is wrong</source>
        <translation>, aber %1 m von %2: Ihr Name ist falsch</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1; it was left out.</source>
        <translation>%1; sie wurde ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>According to the distances, these names in %1 are wrong: %2.</source>
        <translation>Nach den Strecken sind diese Namen in %1 falsch: %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>x and y are swapped, or an axis is reversed</source>
        <translation>sind x und y vertauscht oder ist eine Achse umgekehrt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>x and y are swapped, or one of them is reversed</source>
        <translation>sind x und y vertauscht oder ist eine von beiden umgekehrt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>z is reversed</source>
        <translation>ist z umgekehrt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>%1 of %2 targets of %3 fit the mirror image of the control points: in one of the two lists %4; correct it.</source>
        <translation>%1 von %2 Zielmarken von %3 passen zum Spiegelbild der Passpunkte: In einer der beiden Listen %4; das berichtigen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>too few</source>
        <translation>zu wenige</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 has %2 target, but %3 needs at least %4; pick more targets.</source>
        <translation>%1 hat %2 Zielmarke, aber %3 braucht mindestens %4; mehr Zielmarken messen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 has %2 targets, but %3 needs at least %4; pick more targets.</source>
        <translation>%1 hat %2 Zielmarken, aber %3 braucht mindestens %4; mehr Zielmarken messen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>coincident</source>
        <translation>identisch</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets %1 and %2 of %3 have the same position; remove one of them.</source>
        <translation>Die Zielmarken %1 und %2 von %3 haben dieselbe Position; eine davon entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>above each other</source>
        <translation>übereinander</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>on a line</source>
        <translation>auf einer Geraden</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>collinear</source>
        <translation>auf einer Geraden</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets of %1 lie %2, which leaves the rotation about it unknown; add a target beside it.</source>
        <translation>Die Zielmarken von %1 liegen %2; die Drehung darum bleibt unbekannt. Eine Zielmarke daneben hinzufügen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>Of the targets of %1, %2 have the name of a control point, but %3 needs at least %4; correct the names, or match by distances.</source>
        <translation>Von den Zielmarken von %1 haben %2 den Namen eines Passpunkts, aber %3 braucht mindestens %4; die Namen berichtigen oder nach Strecken zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>too many</source>
        <translation>zu viele</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>With an unknown scale at most %1 control points can be searched, and there are %2; shorten the list to the surroundings of %3, or match by names.</source>
        <translation>Mit unbekanntem Maßstab können höchstens %1 Passpunkte durchsucht werden, und es sind %2; die Liste auf die Umgebung von %3 kürzen oder nach Namen zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>a levelled scan</source>
        <translation>ein horizontierter Scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>a scan</source>
        <translation>ein Scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 matches of %2 leave no redundancy to check the solution; pick more targets, or match by names.</source>
        <translation>%1 Zuordnungen von %2 lassen keine Redundanz, um die Lösung zu prüfen; mehr Zielmarken messen oder nach Namen zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 targets of %2 are too few for %3 control points: %4 accidental matches are expected; pick more targets, shorten the control list to the surroundings, or match by names.</source>
        <translation>%1 Zielmarken von %2 sind zu wenige für %3 Passpunkte: %4 zufällige Zuordnungen sind zu erwarten. Mehr Zielmarken messen, die Passpunktliste auf die Umgebung kürzen oder nach Namen zuordnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>, or match by names</source>
        <translation>, oder nach Namen zuordnen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The search for the %1 targets of %2 among %3 control points was ended, because too many triangles are similar; remove targets that are not control points, or shorten the control list%4.</source>
        <translation>Die Suche nach den %1 Zielmarken von %2 unter %3 Passpunkten wurde beendet, weil zu viele Dreiecke ähnlich sind; Zielmarken entfernen, die keine Passpunkte sind, oder die Passpunktliste kürzen%4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>nearly above each other</source>
        <translation>fast übereinander</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>nearly on a line</source>
        <translation>fast auf einer Geraden</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The matched targets of %1 lie %2, which leaves the rotation about it uncertain by %3 degrees; add a target beside it.</source>
        <translation>Die zugeordneten Zielmarken von %1 liegen %2; die Drehung darum ist um %3 Grad unsicher. Eine Zielmarke daneben hinzufügen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>; and %1 more</source>
        <translation>; und %1 weitere</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets of %1 fit the control points in %2 equally good ways (%3%4); add a target that breaks the symmetry%5.</source>
        <translation>Die Zielmarken von %1 passen auf %2 gleich gute Weisen zu den Passpunkten (%3%4); eine Zielmarke hinzufügen, die die Symmetrie bricht%5.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <location filename="../../algorithms/targets/output/layer.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>target</source>
        <translation>Zielmarke</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>with a scale near 1</source>
        <translation>mit einem Maßstab nahe 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>levelled</source>
        <translation>horizontiert</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>levelled with a scale near 1</source>
        <translation>horizontiert, mit einem Maßstab nahe 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>95 % ellipse, ellipsoid</source>
        <translation>95-%-Ellipse, Ellipsoid</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Accidental matches</source>
        <translation>Zufällige Zuordnungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Round</source>
        <translation>Runde</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Shared surfaces</source>
        <translation>Gemeinsame Flächen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Residual: the transformed target minus its control point, along x, y and z of the control points, and its length.</source>
        <translation>Restklaffung: transformierte Zielmarke minus Passpunkt, entlang x, y und z der Passpunkte, und ihr Betrag.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Standard deviation of unit weight a posteriori over a priori: 1 if the residuals are as large as SIGMA says.</source>
        <translation>Standardabweichung der Gewichtseinheit a posteriori durch a priori: 1, wenn die Restklaffungen so groß sind, wie SIGMA angibt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Of the chi-square test: how often v&#x27;Pv is as large or larger if the a priori standard deviations hold. The verdict is on a level of %1 %, both sides together.</source>
        <translation>Des Chi-Quadrat-Tests: wie oft v&#x27;Pv ebenso groß oder größer ist, wenn die Standardabweichungen a priori zutreffen. Beurteilt wird auf einem Niveau von %1 %, beide Seiten zusammen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Redundancy number, 0 to 1: the part of an error of a coordinate that its residual shows.</source>
        <translation>Redundanzanteil, 0 bis 1: der Teil eines Fehlers einer Koordinate, der sich in ihrer Restklaffung zeigt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Baarda&#x27;s normalized residual, by the a priori standard deviation; suspected beyond %1 (%2 = %3).</source>
        <translation>Normierte Verbesserung nach Baarda, mit der Standardabweichung a priori; verdächtig über %1 (%2 = %3).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Pope&#x27;s studentized residual, by the a posteriori standard deviation of the scan; its limit (%1 = %2) depends on the redundancy.</source>
        <translation>Studentisierte Verbesserung nach Pope, mit der Standardabweichung a posteriori des Scans; ihr Grenzwert (%1 = %2) hängt von der Redundanz ab.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Minimal detectable bias: the smallest error of a coordinate that the w-test finds with a power of %1 % (%2 = %3).</source>
        <translation>Kleinster aufdeckbarer Fehler: der kleinste Fehler einer Koordinate, den der w-Test mit einer Güte von %1 % findet (%2 = %3).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Semi-axes are %1 (plane) and %2 (space) standard deviations.</source>
        <translation>Die Halbachsen sind %1 (Ebene) und %2 (Raum) Standardabweichungen lang.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>How many are expected of as many targets, if the scan had nothing to do with the control points.</source>
        <translation>Wie viele bei ebenso vielen Zielmarken zu erwarten sind, wenn der Scan nichts mit den Passpunkten zu tun hätte.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>1 if surveyed points sufficed to register the scan, 2 if it needed points appended in round 1, and so on.</source>
        <translation>1, wenn eingemessene Punkte für die Registrierung des Scans genügten, 2, wenn er Neupunkte aus Runde 1 brauchte, und so weiter.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Patches of about a metre that two scans share; overlap: the part of the surface of the scan with less that the other has too; distance: how far the patches of both lie apart after the adjustment, root mean square; slides: whether they leave a direction free, which only targets or other scans hold.</source>
        <translation>Flächenstücke von etwa einem Meter, die zwei Scans gemeinsam haben; Überlappung: der Teil der Flächen des Scans mit weniger Flächen, den auch der andere hat; Abstand: wie weit die Stücke beider nach der Ausgleichung auseinanderliegen, als quadratisches Mittel; gleitet: ob sie eine Richtung frei lassen, die nur Zielmarken oder andere Scans halten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>What the targets say about the scale, in parts per million from 1, whether or not it was estimated.</source>
        <translation>Was die Zielmarken über den Maßstab sagen, in Millionsteln Abweichung von 1, unabhängig davon, ob er geschätzt wurde.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans are registered, by their surfaces alone.</source>
        <translation>%1 von %2 Scans sind registriert, allein durch ihre Flächen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans is registered; the longest residual is %3 mm. Global test of all scans together: %4</source>
        <translation>%1 von %2 Scans ist registriert; die größte Restklaffung beträgt %3 mm. Globaltest aller Scans zusammen: %4</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans are registered; the longest residual is %3 mm. Global test of all scans together: %4</source>
        <translation>%1 von %2 Scans sind registriert; die größte Restklaffung beträgt %3 mm. Globaltest aller Scans zusammen: %4</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>matching</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>by names</source>
        <translation>nach Namen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>by distances</source>
        <translation>nach Strecken</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>transformation</source>
        <translation>Transformation</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1, %2 parameters</source>
        <translation>%1, %2 Parameter</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>standard deviation of a target without its own</source>
        <translation>Standardabweichung einer Zielmarke ohne eigene</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>standard deviation of a control point</source>
        <translation>Standardabweichung eines Passpunkts</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>tolerance of distances</source>
        <translation>Streckentoleranz</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>coordinate reference system</source>
        <translation>Koordinatenbezugssystem</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>0, held fixed</source>
        <translation>0, festgehalten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>derived</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>, with 95 % ellipses drawn %1 times too large</source>
        <translation>, mit %1-fach vergrößerten 95-%-Ellipsen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Plan (figure 6 of the paper). Triangles: stations, with lines to the points that they use. Blue: surveyed points. Violet: points appended from scans%1. Where there is no room, names are left out.</source>
        <translation>Plan (Abbildung 6 des Artikels). Dreiecke: Standpunkte mit Linien zu den Punkten, die sie verwenden. Blau: eingemessene Punkte. Violett: Neupunkte aus Scans%1. Wo kein Platz ist, fehlen Namen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Crosses: rejected targets.</source>
        <translation>Kreuze: verworfene Zielmarken.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Plan (figure 6). Arrows: horizontal residuals, drawn %1 times too large, from control point to target. Blue: surveyed, violet: appended, grey: points that %2 does not use.%3</source>
        <translation>Plan (Abbildung 6). Pfeile: horizontale Restklaffungen, %1-fach vergrößert, vom Passpunkt zur Zielmarke. Blau: eingemessen, violett: Neupunkte, grau: Punkte, die %2 nicht verwendet.%3</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Its frame is that of all scans, because there are no control points.</source>
        <translation>Sein System ist das aller Scans, weil es keine Passpunkte gibt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>nothing is redundant, so nothing is checked.</source>
        <translation>Nichts ist redundant, daher wird nichts geprüft.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>(sigma0 %1, redundancy %2, v&#x27;Pv %3, chi-square probability %4)</source>
        <translation>(sigma0 %1, Redundanz %2, v&#x27;Pv %3, Chi-Quadrat-Wahrscheinlichkeit %4)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals are larger than the a priori standard deviations allow %1.</source>
        <translation>Die Restklaffungen sind größer, als die Standardabweichungen a priori erlauben %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals are smaller than the a priori standard deviations suggest %1.</source>
        <translation>Die Restklaffungen sind kleiner, als die Standardabweichungen a priori erwarten lassen %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals agree with the a priori standard deviations %1.</source>
        <translation>Die Restklaffungen stimmen mit den Standardabweichungen a priori überein %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Registered in round %1 with %2 of %3 targets, of which %4 are surveyed points.</source>
        <translation>In Runde %1 mit %2 von %3 Zielmarken registriert, davon %4 eingemessene Punkte.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Expected accidental matches of so many targets: %1.</source>
        <translation>Zu erwartende zufällige Zuordnungen von so vielen Zielmarken: %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Standard deviation of the scanner: %1 mm.</source>
        <translation>Standardabweichung des Scanners: %1 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Largest standard deviation at a target: %1 mm.</source>
        <translation>Größte Standardabweichung an einer Zielmarke: %1 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Appended to the control points: %1.</source>
        <translation>Als Neupunkte zu den Passpunkten hinzugefügt: %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Placed by surfaces: %1 patches agree with %2, and %3 contradict them.</source>
        <translation>Durch Flächen gesetzt: %1 Flächenstücke stimmen mit %2 überein, und %3 widersprechen ihnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>%1 of its targets lie on known points.</source>
        <translation>%1 seiner Zielmarken liegen auf bekannten Punkten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>No other pose was found.</source>
        <translation>Eine andere Lage wurde nicht gefunden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>At the next best pose, the scanner %1 m away and turned by %2 degrees, %3 agree and %4 contradict.</source>
        <translation>In der nächstbesten Lage, mit dem Scanner %1 m entfernt und um %2 Grad gedreht, stimmen %3 überein und widersprechen %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Surfaces would move its targets by up to %1 mm, %2 standard deviations, and are not used; by the targets alone, the largest standard deviation is %3 mm.</source>
        <translation>Flächen würden seine Zielmarken um bis zu %1 mm verschieben, %2 Standardabweichungen, und werden nicht verwendet; allein nach den Zielmarken ist die größte Standardabweichung %3 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Surfaces moved its targets by up to %1 mm, %2 standard deviations; by the targets alone, the largest standard deviation is %3 mm.</source>
        <translation>Flächen haben seine Zielmarken um bis zu %1 mm verschoben, %2 Standardabweichungen; allein nach den Zielmarken ist die größte Standardabweichung %3 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>appended</source>
        <translation>neu</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>%1 = %2 was rejected: it is %3 m off, |w| %4.</source>
        <translation>%1 = %2 wurde verworfen: Abweichung %3 m, |w| %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Solutions that are as good as each other, target = control point:</source>
        <translation>Gleich gute Lösungen, Zielmarke = Passpunkt:</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Parameters, scan to control points</source>
        <translation>Parameter, vom Scan zu den Passpunkten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Residuals</source>
        <translation>Restklaffungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Reliability</source>
        <translation>Zuverlässigkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Control points</source>
        <translation>Passpunkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Registration of scans</source>
        <translation>Registrierung von Scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Global test: %1</source>
        <translation>Globaltest: %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Components of the residuals, target minus control point (figure 7). The value is written at a bar that is cut. The name of a rejected target is red.</source>
        <translation>Komponenten der Restklaffungen, Zielmarke minus Passpunkt (Abbildung 7). An einem gekürzten Balken steht der Wert. Der Name einer verworfenen Zielmarke ist rot.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Components of the residuals, target minus control point (figure 7).</source>
        <translation>Komponenten der Restklaffungen, Zielmarke minus Passpunkt (Abbildung 7).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Lengths of the residuals (figure 8).</source>
        <translation>Beträge der Restklaffungen (Abbildung 8).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Correlations</source>
        <translation>Korrelationen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>control point</source>
        <translation>Passpunkt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Millimetres; a, b, c: semi-axes of the 95 % ellipsoid of the transformed target. Red: rejected.</source>
        <translation>Millimeter; a, b, c: Halbachsen des 95-%-Ellipsoids der transformierten Zielmarke. Rot: verworfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Red: redundancy number below %1, |w| above %2, |τ| above %3, or rejected. MDB in millimetres.</source>
        <translation>Rot: Redundanzanteil unter %1, |w| über %2, |τ| über %3 oder verworfen. MDB in Millimetern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>targets</source>
        <translation>Zielmarken</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>matched</source>
        <translation>zugeordnet</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>in round</source>
        <translation>Runde</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>probability</source>
        <translation>Wahrschein­lichkeit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>longest v (mm)</source>
        <translation>größte v (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>scale (ppm)</source>
        <translation>Maßstab (ppm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>accidental matches</source>
        <translation>zufällige Zuordnungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>other scan</source>
        <translation>anderer Scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>patches</source>
        <translation>Flächenstücke</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>overlap (%)</source>
        <translation>Überlappung (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>distance (mm)</source>
        <translation>Abstand (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>slides</source>
        <translation>gleitet</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Surfaces that tie the scans to each other.</source>
        <translation>Flächen, die die Scans miteinander verknüpfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Coordinates in metres, their standard deviations in millimetres; how many scans use the point.</source>
        <translation>Koordinaten in Metern, ihre Standardabweichungen in Millimetern; wie viele Scans den Punkt verwenden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is too large; choose the TRANSFORMS of registerscans.</source>
        <translation>%1 ist zu groß; die Datei TRANSFORMS von registerscans wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 cannot be read (%2); check that it exists and may be read.</source>
        <translation>%1 kann nicht gelesen werden (%2); prüfen, ob die Datei vorhanden ist und gelesen werden darf.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is not json (%2); choose the TRANSFORMS of registerscans.</source>
        <translation>%1 ist kein JSON (%2); die Datei TRANSFORMS von registerscans wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 lists no scans; choose the TRANSFORMS of registerscans.</source>
        <translation>%1 enthält keine Scans; die Datei TRANSFORMS von registerscans wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 lists the scan %2 twice; remove one entry.</source>
        <translation>%1 führt den Scan %2 doppelt auf; einen Eintrag entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 gives matrices in %2; write shifts in metres.</source>
        <translation>%1 enthält Matrizen in %2; Verschiebungen in Metern schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>Scan number %1 in %2 has no name; give it the name of its cloud.</source>
        <translation>Scan Nummer %1 in %2 hat keinen Namen; ihm den Namen seiner Punktwolke geben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The matrix of the scan %1 in %2 %3; register the scan again.</source>
        <translation>Die Matrix des Scans %1 in %2 %3; den Scan erneut registrieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>is not four rows of four numbers</source>
        <translation>besteht nicht aus vier Zeilen zu vier Zahlen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>does not end in the row 0 0 0 1</source>
        <translation>endet nicht mit der Zeile 0 0 0 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>moves the scan by %1 m</source>
        <translation>verschiebt den Scan um %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>mirrors the scan</source>
        <translation>spiegelt den Scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>has a scale of %1</source>
        <translation>hat einen Maßstab von %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>distorts the scan because its rotation is not orthogonal</source>
        <translation>verzerrt den Scan, weil die Drehung nicht orthogonal ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The coordinate reference system in %1 cannot be understood; write it as WKT or like EPSG:25832.</source>
        <translation>Das Koordinatenbezugssystem in %1 ist nicht verständlich; als WKT oder wie EPSG:25832 schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>the control points in %1</source>
        <translation>die Passpunkte in %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The only scan in %1, %2, is used for %3.</source>
        <translation>Der einzige Scan in %1, %2, wird für %3 verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>There is no scan for %1 in %2, only %3; name the cloud after its scan.</source>
        <translation>Für %1 gibt es in %2 keinen Scan, nur %3; die Punktwolke nach ihrem Scan benennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is left out because its scan %2 is not registered in %3 (%4: %5).</source>
        <translation>%1 wird ausgelassen, weil der Scan %2 in %3 nicht registriert ist (%4: %5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is left out because its scan %2 is not registered in %3 (%4%5).</source>
        <translation>%1 wird ausgelassen, weil der Scan %2 in %3 nicht registriert ist (%4%5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>Register at least one of them.</source>
        <translation>Mindestens einen davon registrieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Adjusting all scans in one block</source>
        <translation>Alle Scans werden in einem Block ausgeglichen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Two lists of targets are called %1; rename one, because their names identify the scans.</source>
        <translation>Zwei Listen von Zielmarken heißen %1; eine umbenennen, denn ihre Namen bezeichnen die Scans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>No list of targets was given; choose at least one.</source>
        <translation>Es wurde keine Liste von Zielmarken angegeben; mindestens eine wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>%1 has %2 control points, but at least %3 are needed; add some.</source>
        <translation>%1 hat %2 Passpunkte, aber mindestens %3 sind nötig; weitere hinzufügen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Targets have standard deviations of their own, so control points are not held fixed but count with SIGMA, %1 mm; set CONTROL_SIGMA to the standard deviation of the survey.</source>
        <translation>Zielmarken haben eigene Standardabweichungen; daher werden die Passpunkte nicht festgehalten, sondern gehen mit SIGMA, %1 mm, ein. CONTROL_SIGMA auf die Standardabweichung der Einmessung setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>%1 control points were appended by an earlier registration (%2); they count with their standard deviations, as if these were independent.</source>
        <translation>%1 Passpunkte sind Neupunkte einer früheren Registrierung (%2); sie gehen mit ihren Standardabweichungen ein, als wären diese unabhängig.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>The control points %1 and %2 are %3 mm apart, too close to distinguish them; only one is used.</source>
        <translation>Die Passpunkte %1 und %2 liegen %3 mm auseinander, zu nah, um sie zu unterscheiden; nur einer wird verwendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/results.py"/>
        <source>registered</source>
        <translation>registriert</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>Matching %1</source>
        <translation>%1 wird zugeordnet</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>Searching why %1 does not match</source>
        <translation>Es wird gesucht, warum %1 nicht passt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>%1 has no targets.</source>
        <translation>%1 hat keine Zielmarken.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <location filename="../../algorithms/registration/simulation/trials.py"/>
        <source>success</source>
        <translation>Erfolg</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>wrong labels</source>
        <translation>falsche Namen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>Registering %1 simulated scans</source>
        <translation>%1 simulierte Scans werden registriert</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>TARGETS_PER_SCAN is %1, but MODEL needs at least %2; raise it.</source>
        <translation>TARGETS_PER_SCAN ist %1, aber MODEL braucht mindestens %2; den Wert erhöhen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>%1 has %2 points, but TARGETS_PER_SCAN is %3; lower it, or survey more control points.</source>
        <translation>%1 hat %2 Punkte, aber TARGETS_PER_SCAN ist %3; den Wert verringern oder mehr Passpunkte einmessen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>No control point of %1 has %2 others within REACH, %3 m; raise it, or lower TARGETS_PER_SCAN.</source>
        <translation>Kein Passpunkt von %1 hat %2 andere innerhalb von REACH, %3 m; den Wert erhöhen oder TARGETS_PER_SCAN verringern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>These control points are in no trial because too few others are within REACH: %1.</source>
        <translation>Diese Passpunkte kommen in keinem Versuch vor, weil zu wenige andere innerhalb von REACH liegen: %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets fit the control points in several ways that are equally good.</source>
        <translation>Die Zielmarken passen auf mehrere gleich gute Weisen zu den Passpunkten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>So few targets agree with some control points by accident too.</source>
        <translation>So wenige Zielmarken stimmen auch zufällig mit irgendwelchen Passpunkten überein.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets lie on a line, or above each other in a levelled model.</source>
        <translation>Die Zielmarken liegen auf einer Geraden oder, bei einem horizontierten Modell, übereinander.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Two targets have the same position.</source>
        <translation>Zwei Zielmarken haben dieselbe Position.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets lie in one plane and fit other control points as in a mirror.</source>
        <translation>Die Zielmarken liegen in einer Ebene und passen gespiegelt zu anderen Passpunkten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets leave no redundancy to check their match.</source>
        <translation>Die Zielmarken lassen keine Redundanz, um ihre Zuordnung zu prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The noise hid which targets are which.</source>
        <translation>Das Rauschen verdeckte, welche Zielmarke welche ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The pose is right, but a target was given no control point.</source>
        <translation>Die Orientierung stimmt, aber eine Zielmarke erhielt keinen Passpunkt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>A target was given another control point than its own.</source>
        <translation>Eine Zielmarke erhielt einen anderen als ihren eigenen Passpunkt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some control points can be confused with each other, because the distances among them repeat: move targets that are listed below, or add one that breaks the symmetry.</source>
        <translation>Einige Passpunkte können miteinander verwechselt werden, weil sich die Strecken zwischen ihnen wiederholen: die unten aufgeführten Zielmarken versetzen oder eine hinzufügen, die die Symmetrie bricht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some scans had too few targets to be sure: pick one or two more in each scan.</source>
        <translation>Einige Scans hatten zu wenige Zielmarken, um sicher zu sein: in jedem Scan eine oder zwei mehr messen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some scans had all targets in a row: put targets at different heights and sides.</source>
        <translation>Bei einigen Scans lagen alle Zielmarken in einer Reihe: Zielmarken in verschiedenen Höhen und auf verschiedenen Seiten anbringen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>shift, the scanner&#x27;s position (mm)</source>
        <translation>Verschiebung, Position des Scanners (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>rotation (0.001 degrees)</source>
        <translation>Drehung (0.001 Grad)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>In %1 of %2 trials (%3%) all %4 targets were given their control points; in %5, a wrong one.</source>
        <translation>In %1 von %2 Versuchen (%3 %) wurden alle %4 Zielmarken ihren Passpunkten zugeordnet; in %5 einem falschen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Failures</source>
        <translation>Fehlschläge</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Points confused with each other</source>
        <translation>Miteinander verwechselte Punkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>%1 of %2 control points are concerned, most often these, with the number of trials: %3.</source>
        <translation>%1 von %2 Passpunkten sind betroffen, am häufigsten diese, mit der Anzahl der Versuche: %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>No control points were confused with each other.</source>
        <translation>Keine Passpunkte wurden miteinander verwechselt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Errors of the transformations</source>
        <translation>Fehler der Transformationen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Estimated against true, in the trials that succeeded.</source>
        <translation>Geschätzt gegen wahr, in den gelungenen Versuchen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>What was simulated</source>
        <translation>Was simuliert wurde</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Each trial is a scan of %1 random control points from the whole list, of %2 in all.</source>
        <translation>Jeder Versuch ist ein Scan von %1 zufälligen Passpunkten aus der ganzen Liste, von insgesamt %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Each trial is a scan of %1 random control points within %2 m of one of them, of %3 in all.</source>
        <translation>Jeder Versuch ist ein Scan von %1 zufälligen Passpunkten im Umkreis von %2 m um einen von ihnen, von insgesamt %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about the vertical, at a scale from 0.1 to 10.</source>
        <translation>Der Scanner steht zwischen ihnen, zufällig um die Lotrechte gedreht, in einem Maßstab von 0.1 bis 10.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about the vertical.</source>
        <translation>Der Scanner steht zwischen ihnen, zufällig um die Lotrechte gedreht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about any axis, at a scale from 0.1 to 10.</source>
        <translation>Der Scanner steht zwischen ihnen, zufällig um eine beliebige Achse gedreht, in einem Maßstab von 0.1 bis 10.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about any axis.</source>
        <translation>Der Scanner steht zwischen ihnen, zufällig um eine beliebige Achse gedreht.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Every coordinate has normal noise of %1 mm, and distances from the centroid of the targets are %2 ppm too long.</source>
        <translation>Jede Koordinate hat ein normalverteiltes Rauschen von %1 mm, und die Strecken vom Schwerpunkt der Zielmarken sind %2 ppm zu lang.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>MODEL is %1, SEED %2.</source>
        <translation>MODEL ist %1, SEED %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Simulated registration with %1</source>
        <translation>Simulierte Registrierung mit %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>confused with</source>
        <translation>verwechselt mit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>distance (m)</source>
        <translation>Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The first %1 of %2 pairs.</source>
        <translation>Die ersten %1 von %2 Paaren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The control points from above. Red ones are confused with others, lines join the pairs of the table.</source>
        <translation>Die Passpunkte von oben. Rote werden mit anderen verwechselt, Linien verbinden die Paare der Tabelle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Distribution of %1.</source>
        <translation>Verteilung: %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>from the whole list</source>
        <translation>aus der ganzen Liste</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>within %1 m of one of them</source>
        <translation>im Umkreis von %1 m um einen von ihnen</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>about the vertical</source>
        <translation>um die Lotrechte</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>about any axis</source>
        <translation>um eine beliebige Achse</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>, at a scale from 0.1 to 10</source>
        <translation>, in einem Maßstab von 0.1 bis 10</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>References</source>
        <translation>Literatur</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Herbig, Mayer, Mortada and Rasztovits 2013, chapter 5: results and simulation.</source>
        <translation>Herbig, Mayer, Mortada und Rasztovits 2013, Kapitel 5: Ergebnisse und Simulation.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/adjustment.py"/>
        <source>No other scan could be placed beside %1, whose frame would be that of all; see why not, or choose another scan as the first.</source>
        <translation>Neben %1, dessen System das aller Scans wäre, konnte kein anderer Scan gesetzt werden; die Gründe dafür ansehen oder einen anderen Scan als ersten wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>%1 cannot be placed by surfaces, because its cloud does not show where the scanner stood; give it in the frame of the scanner, or as an E57 or PTX file with its pose, or pick targets.</source>
        <translation>%1 kann nicht durch Flächen gesetzt werden, weil seine Punktwolke nicht zeigt, wo der Scanner stand; sie im System des Scanners angeben oder als E57- oder PTX-Datei mit ihrer Pose, oder Zielmarken abgreifen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 fit better as in a mirror; correct its cloud if two columns are swapped or an axis points the other way, or else pick targets.</source>
        <translation>Die Flächen von %1 passen gespiegelt besser; seine Punktwolke berichtigen, wenn zwei Spalten vertauscht sind oder eine Achse in die andere Richtung zeigt, sonst Zielmarken abgreifen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 do not place it: at best, %2 patches agree with other scans and %3 contradict them; at least %4 must agree, and hardly any contradict; scan with more overlap, or pick targets.</source>
        <translation>Die Flächen von %1 legen seine Lage nicht fest: bestenfalls stimmen %2 Flächenstücke mit anderen Scans überein und widersprechen %3; mindestens %4 müssen übereinstimmen und kaum welche widersprechen; mit mehr Überlappung scannen oder Zielmarken abgreifen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>sliding</source>
        <translation>gleitend</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>%1 slides along the surfaces that it shares with other scans, %2; scan it from where a wall across is seen too, or pick a target.</source>
        <translation>%1 gleitet entlang der Flächen, die er mit anderen Scans gemeinsam hat, %2; von einem Standpunkt scannen, von dem auch eine Querwand zu sehen ist, oder eine Zielmarke abgreifen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 agree with other scans at two poses about as well: %2 patches agree and %3 do not, or %4 and %5 with the scanner %6 m away and turned by %7 degrees; pick a target, or choose a levelled model if the scanner was levelled.</source>
        <translation>Die Flächen von %1 stimmen in zwei Lagen etwa gleich gut mit anderen Scans überein: %2 Flächenstücke stimmen überein und %3 nicht, oder %4 und %5 mit dem Scanner %6 m entfernt und um %7 Grad gedreht; eine Zielmarke abgreifen, oder ein horizontiertes Modell wählen, wenn der Scanner horizontiert war.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 is held by nothing</source>
        <translation>%1 wird durch nichts gehalten</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>Tying scans by their surfaces</source>
        <translation>Scans werden durch ihre Flächen verknüpft</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 shares too few plane surfaces with other scans to be tied to them; scan with more overlap, or pick targets.</source>
        <translation>%1 hat zu wenige ebene Flächen mit anderen Scans gemeinsam, um mit ihnen verknüpft zu werden; mit mehr Überlappung scannen oder Zielmarken abgreifen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>The surfaces that %1 shares with other scans would move it by %2 mm, %3 standard deviations, which the targets, also those that scans share, rule out; they are not used. Look, also in the scans beside it, for things that were moved between the scans, or for a cloud that is not the one of the targets.</source>
        <translation>Die Flächen, die %1 mit anderen Scans gemeinsam hat, würden ihn um %2 mm verschieben, %3 Standardabweichungen, was die Zielmarken, auch die gemeinsamen der Scans, ausschließen; sie werden nicht verwendet. Auch in den benachbarten Scans nach Dingen suchen, die zwischen den Scans bewegt wurden, oder nach einer Punktwolke, die nicht die der Zielmarken ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 is not tied by surfaces, because its cloud does not show where the scanner stood, and both sides of a wall would be taken for one; give the cloud in the frame of the scanner, or an E57 or PTX file of one scan with its pose.</source>
        <translation>%1 wird nicht durch Flächen verknüpft, weil seine Punktwolke nicht zeigt, wo der Scanner stand, und beide Seiten einer Wand für eine gehalten würden; die Punktwolke im System des Scanners angeben, oder eine E57- oder PTX-Datei mit einem Scan und seiner Pose.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 shares too few plane surfaces with another scan to be tied by them; its targets alone hold it.</source>
        <translation>%1 hat mit einem anderen Scan zu wenige ebene Flächen gemeinsam, um durch sie verknüpft zu werden; allein seine Zielmarken halten ihn.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 and %2 slide along the surfaces that they share, %3; in that direction, only targets or other scans hold them.</source>
        <translation>%1 und %2 gleiten entlang der Flächen, die sie gemeinsam haben, %3; in dieser Richtung halten sie nur Zielmarken oder andere Scans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 and %2 share only surfaces that face one way, and slide in all directions along them; there, only targets or other scans hold them.</source>
        <translation>%1 und %2 haben nur Flächen einer Richtung gemeinsam und gleiten in alle Richtungen an ihnen entlang; dort halten sie nur Zielmarken oder andere Scans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/tie.py"/>
        <source>up and down</source>
        <translation>auf und ab</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/tie.py"/>
        <source>at an azimuth of %1 degrees</source>
        <translation>in einem Azimut von %1 Grad</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it cannot be read: %1</source>
        <translation>sie kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it is cut off</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>its table is cut off</source>
        <translation>ihre Tabelle ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it has %1 shapes, and its table %2 rows</source>
        <translation>sie hat %1 Objekte und ihre Tabelle %2 Zeilen</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>%1 is damaged (%2); copy or export it again, with all its parts.</source>
        <translation>%1 ist beschädigt (%2); mit allen Teilen erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/axes/axes.py"/>
        <source>Finding axes</source>
        <translation>Achsen werden gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/bands.py"/>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <location filename="../../algorithms/site_plan/output/layers.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>%1: %2 of %3 points lie far from each other; check that the coordinates are metres, or remove what is not the site.</source>
        <translation>%1: %2 von %3 Punkten liegen weit voneinander entfernt; prüfen, ob die Koordinaten in Metern sind, oder entfernen, was nicht zum Objekt gehört.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>%1: all points have the same position; is it a scan?</source>
        <translation>%1: Alle Punkte haben dieselbe Position; ist das ein Scan?</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>The points lie within a metre; check that the coordinates are metres, not degrees.</source>
        <translation>Die Punkte liegen innerhalb eines Meters; prüfen, ob die Koordinaten in Metern und nicht in Grad sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>SPACING %1 m is wider than PIXEL_SIZE %2 m, so walls have gaps.</source>
        <translation>SPACING %1 m ist größer als PIXEL_SIZE %2 m; daher haben Wände Lücken.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>Finding the ground</source>
        <translation>Das Gelände wird gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>occupied height</source>
        <translation>belegte Höhe</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>hanging height</source>
        <translation>hängende Höhe</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>The raster has no coordinate reference system, so the results have none either.</source>
        <translation>Das Raster hat kein Koordinatenbezugssystem; daher haben auch die Ergebnisse keines.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: there is no such file; check the path.</source>
        <translation>INPUT %1: Diese Datei gibt es nicht; den Pfad prüfen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: cannot be read as a raster; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: kann nicht als Raster gelesen werden; die Ausgabe von &#x27;densityimage&#x27; angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds infinite values; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: enthält unendliche Werte; die Ausgabe von &#x27;densityimage&#x27; angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds values below 0, which no density has; state which value stands for none, or give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: enthält Werte unter 0, die keine Dichte hat; angeben, welcher Wert für keinen steht, oder die Ausgabe von &#x27;densityimage&#x27; wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds no density above 0; is it the right raster?</source>
        <translation>INPUT %1: enthält keine Dichte über 0; ist es das richtige Raster?</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: has %2 x %3 pixels, more than %4; cut it to the site, or make it with a larger PIXEL_SIZE.</source>
        <translation>INPUT %1: hat %2 x %3 Pixel, mehr als %4; auf das Objekt zuschneiden oder mit einem größeren Wert von PIXEL_SIZE erzeugen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: is not georeferenced; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: ist nicht georeferenziert; die Ausgabe von &#x27;densityimage&#x27; angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: pixels must be square and north up; resample it with the Warp tool.</source>
        <translation>INPUT %1: Pixel müssen quadratisch und eingenordet sein; mit „Transformieren (Reprojizieren)“ neu abtasten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: has pixels of %2 m; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: hat Pixel von %2 m; die Ausgabe von &#x27;densityimage&#x27; angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds a picture, not densities; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1: enthält ein Bild und keine Dichten; die Ausgabe von &#x27;densityimage&#x27; angeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/grid.py"/>
        <source>The raster would be %1 x %2 pixels (%3 x %4 m at %5 m), more than %6: raise PIXEL_SIZE, cut the cloud to the site, or check that its coordinates are metres.</source>
        <translation>Das Raster hätte %1 x %2 Pixel (%3 x %4 m zu %5 m), mehr als %6: PIXEL_SIZE erhöhen, die Punktwolke auf das Objekt zuschneiden oder prüfen, ob ihre Koordinaten in Metern sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>ZMIN %1 m is not below ZMAX %2 m; correct one of them.</source>
        <translation>ZMIN %1 m liegt nicht unter ZMAX %2 m; eines davon berichtigen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>Cutting by height</source>
        <translation>Nach Höhe wird geschnitten</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>above the ground</source>
        <translation>über dem Gelände</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>%1: no point lies from ZMIN %2 to ZMAX %3 m%4; the heights reach from %5 to %6 m%7.</source>
        <translation>%1: Kein Punkt liegt von ZMIN %2 bis ZMAX %3 m%4; die Höhen reichen von %5 bis %6 m%7.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/face_points.py"/>
        <source>Gathering the points of the faces</source>
        <translation>Die Punkte der Wandflächen werden gesammelt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <source>Fitting faces</source>
        <translation>Wandflächen werden eingepasst</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <source>No wall found: no wall face could be fitted; switch REFINE off to keep the outlines of pixels.</source>
        <translation>Keine Wand gefunden: Es konnte keine Wandfläche eingepasst werden; REFINE ausschalten, um die Umrisse der Pixel zu behalten.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <location filename="../../algorithms/site_plan/walls/regions.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_drawing.py"/>
        <source>Room %1</source>
        <translation>Raum %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1: %2 of %3 regions kept</source>
        <translation>%1: %2 von %3 Regionen behalten</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>THRESHOLD up, MIN_AREA up or MAX_FILL down where there is no wall</source>
        <translation>THRESHOLD höher, MIN_AREA höher oder MAX_FILL niedriger, wo keine Wand ist</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>added by CLOSING %1 m</source>
        <translation>durch CLOSING %1 m hinzugekommen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>CLOSING down if it fills niches or passages, up if the two faces of a wall remain apart</source>
        <translation>CLOSING niedriger, wenn es Nischen oder Durchgänge füllt, höher, wenn die beiden Seiten einer Wand getrennt bleiben</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>neither straight nor curved: %1 of %2 regions</source>
        <translation>weder gerade noch gekrümmt: %1 von %2 Regionen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_ELONGATION %1 down for short straight walls, MAX_FILL %2 up for curved or angled ones</source>
        <translation>MIN_ELONGATION %1 niedriger für kurze gerade Wände, MAX_FILL %2 höher für gekrümmte oder abgewinkelte</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>smaller than MIN_AREA %1 m²: %2 of %3 regions</source>
        <translation>kleiner als MIN_AREA %1 m²: %2 von %3 Regionen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_AREA down if walls are among it</source>
        <translation>MIN_AREA niedriger, wenn Wände darunter sind</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>fainter than THRESHOLD %1</source>
        <translation>schwächer als THRESHOLD %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>THRESHOLD down if walls are among it</source>
        <translation>THRESHOLD niedriger, wenn Wände darunter sind</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>foliage: points spread over the plan, not along a face</source>
        <translation>Bewuchs: Punkte über die Fläche verstreut, nicht entlang einer Wandfläche</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_HEIGHT 0 keeps it, and all else</source>
        <translation>MIN_HEIGHT 0 behält ihn und alles Übrige</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>furniture: ends below a ceiling that walls reach</source>
        <translation>Möbel: enden unter einer Decke, die Wände erreichen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>ZMAX below the ceiling if low walls are among it</source>
        <translation>ZMAX unter die Decke, wenn niedrige Wände darunter sind</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>above the ground, but less occupied than MIN_HEIGHT %1 m</source>
        <translation>über dem Gelände, aber weniger belegt als MIN_HEIGHT %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_HEIGHT down if walls are among it, low or sparsely scanned ones</source>
        <translation>MIN_HEIGHT niedriger, wenn Wände darunter sind, niedrige oder dünn gescannte</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>floor, ground and the like</source>
        <translation>Fußboden, Gelände und dergleichen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>density of pixels that may be wall</source>
        <translation>Dichte der Pixel, die Wand sein können</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1 standard deviations = %2 points per pixel</source>
        <translation>%1 Standardabweichungen = %2 Punkte je Pixel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>given</source>
        <translation>vorgegeben</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>derived: %1</source>
        <translation>abgeleitet: %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>heights show where the ground was seen</source>
        <translation>die Höhen zeigen, wo das Gelände gesehen wurde</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>no heights are used</source>
        <translation>es werden keine Höhen verwendet</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>the median density of the pixels above THRESHOLD that may be wall</source>
        <translation>der Median der Dichte der Pixel über THRESHOLD, die Wand sein können</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>a metre of wall one pixel thick</source>
        <translation>ein Meter Wand von einem Pixel Dicke</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>not applied</source>
        <translation>nicht angewendet</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>of the files, or given</source>
        <translation>der Dateien oder vorgegeben</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>above the local ground</source>
        <translation>über dem örtlichen Gelände</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>Under the ceiling, walls and rooms come from the faces and the floor of the storey; elsewhere from the density image.</source>
        <translation>Unter der Decke stammen Wände und Räume aus den Wandflächen und dem Fußboden des Geschosses, anderswo aus dem Dichtebild.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>REFINE is no: all walls come from the density image, with the outlines of pixels.</source>
        <translation>REFINE ist nein: Alle Wände stammen aus dem Dichtebild, mit den Umrissen der Pixel.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>STOREY is no: all walls come from the density image.</source>
        <translation>STOREY ist nein: Alle Wände stammen aus dem Dichtebild.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>No room under a ceiling was seen: all walls come from the density image.</source>
        <translation>Kein Raum unter einer Decke wurde gesehen: Alle Wände stammen aus dem Dichtebild.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>floor</source>
        <translation>Fußboden</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>distance of points</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>noise of upright surfaces</source>
        <translation>Rauschen lotrechter Flächen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>outlines of rooms</source>
        <translation>Umrisse der Räume</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>of them limits, without a wall</source>
        <translation>davon Grenzen ohne Wand</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>pieces of the kind %1</source>
        <translation>Stücke der Art %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls: %1, %2 m² in plan, %3 m long. Rooms: %4, %5 m².</source>
        <translation>Wände: %1, %2 m² im Grundriss, %3 m lang. Räume: %4, %5 m².</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls: %1, %2 m² in plan, %3 m long.</source>
        <translation>Wände: %1, %2 m² im Grundriss, %3 m lang.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Storey</source>
        <translation>Geschoss</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Nothing was left out.</source>
        <translation>Nichts wurde ausgelassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>What became of the pixels</source>
        <translation>Was aus den Pixeln wurde</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Regions are counted anew at each threshold.</source>
        <translation>Regionen werden bei jeder Schwelle neu gezählt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Thresholds</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>The regions above each threshold, in the colours of the picture above. If floors or clutter are kept in the first pictures, raise THRESHOLD; if faint walls show in none, lower it. If the last pictures find nothing more, THRESHOLD_MAX may be lower.</source>
        <translation>Die Regionen über jeder Schwelle, in den Farben des Bildes darüber. Bleiben in den ersten Bildern Fußböden oder Störobjekte erhalten, THRESHOLD erhöhen; erscheinen schwache Wände in keinem, ihn verringern. Finden die letzten Bilder nichts mehr, kann THRESHOLD_MAX niedriger sein.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Density image</source>
        <translation>Dichtebild</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/help.py"/>
        <location filename="../../processing_provider/model.py"/>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms</source>
        <translation>Räume</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Site plan</source>
        <translation>Grundriss</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>The walls over the density image. A wall of the image without a colour is missing: see below which criterion removed it. A colour where there is no wall: see below which criterion let it pass.</source>
        <translation>Die Wände über dem Dichtebild. Eine Wand des Bildes ohne Farbe fehlt: siehe unten, welches Kriterium sie entfernt hat. Eine Farbe, wo keine Wand ist: siehe unten, welches Kriterium sie durchgelassen hat.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls (red), rooms (green), limits of the scan (blue), and what was left out (yellow). Look for a wall among the yellow lines; the layer LEFT_OUT gives the reason of each.</source>
        <translation>Wände (rot), Räume (grün), Grenzen des Scans (blau) und Ausgelassenes (gelb). Eine fehlende Wand unter den gelben Linien suchen; der Layer LEFT_OUT nennt zu jeder den Grund.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>left out, because it</source>
        <translation>ausgelassen, weil</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Each pixel by the last criterion that it met. Look for a missing wall, read its colour, and change the parameter beside that colour.</source>
        <translation>Jedes Pixel nach dem letzten Kriterium, das es erfüllt hat. Eine fehlende Wand suchen, ihre Farbe ablesen und den Parameter neben dieser Farbe ändern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>pixels that are</source>
        <translation>Pixel, die sind:</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>In standard deviations of the density image; the last bar holds all that is denser. Lines mark the lowest and the highest threshold, as far as they lie in between.</source>
        <translation>In Standardabweichungen des Dichtebilds; der letzte Balken enthält alles Dichtere. Linien markieren die niedrigste und die höchste Schwelle, soweit sie dazwischen liegen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>too small</source>
        <translation>zu klein</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>misshapen</source>
        <translation>unpassende Form</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Points per pixel, of the %1 of %2 points that thinning kept; black is two standard deviations above the mean. Walls should stand out as lines. If they are dotted, raise PIXEL_SIZE; if neighbouring faces run into each other, lower it, and SPACING with it.</source>
        <translation>Punkte je Pixel, von den %1 der %2 Punkte, die nach dem Ausdünnen bleiben; Schwarz liegt zwei Standardabweichungen über dem Mittel. Wände sollen als Linien hervortreten. Sind sie gepunktet, PIXEL_SIZE erhöhen; fließen benachbarte Wandflächen ineinander, PIXEL_SIZE und damit SPACING verringern.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Defaults count as given.</source>
        <translation>Vorgabewerte zählen als vorgegeben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>base z</source>
        <translation>z Unterkante</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>top z</source>
        <translation>z Oberkante</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>votes</source>
        <translation>Stimmen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Metres, degrees from grid north, square metres; votes are thresholds. The first %1 of %2.</source>
        <translation>Meter, Grad von Gitternord, Quadratmeter; Stimmen sind Schwellen. Die ersten %1 von %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Metres, degrees from grid north, square metres; votes are thresholds.</source>
        <translation>Meter, Grad von Gitternord, Quadratmeter; Stimmen sind Schwellen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>perimeter</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>openings</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>seen (%)</source>
        <translation>gesehen (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Square metres and metres. If a room in the open is missing, a gap in its walls is wider than DOOR_WIDTH. The first %1 of %2.</source>
        <translation>Quadratmeter und Meter. Fehlt ein Raum im Freien, ist eine Lücke in seinen Wänden breiter als DOOR_WIDTH. Die ersten %1 von %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Square metres and metres. If a room in the open is missing, a gap in its walls is wider than DOOR_WIDTH.</source>
        <translation>Quadratmeter und Meter. Fehlt ein Raum im Freien, ist eine Lücke in seinen Wänden breiter als DOOR_WIDTH.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/rooms/rooms.py"/>
        <source>Triangulating the space between walls</source>
        <translation>Der Raum zwischen den Wänden wird trianguliert</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/rooms/rooms.py"/>
        <source>Outlining rooms</source>
        <translation>Räume werden umrissen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/site_plan.py"/>
        <source>No room is closed: raise DOOR_WIDTH above the widest gap in its walls.</source>
        <translation>Kein Raum ist geschlossen: DOOR_WIDTH über die breiteste Lücke in seinen Wänden erhöhen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/site_plan.py"/>
        <source>Tracing outlines</source>
        <translation>Umrisse werden verfolgt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/doubts.py"/>
        <source>%1 m² of %2 m² of upright surface rise as high as walls, but are left out as furniture, curtains and door leaves: look through LEFT_OUT, and set STOREY to no if walls are among them.</source>
        <translation>%1 m² von %2 m² lotrechter Flächen sind so hoch wie Wände, werden aber als Möbel, Vorhänge und Türblätter ausgelassen: LEFT_OUT durchsehen und STOREY auf nein setzen, wenn Wände darunter sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/doubts.py"/>
        <source>Rooms end without a wall over %1 m of %2 m: the scan ends there, or the wall is glass or hidden by furniture; see LIMITS.</source>
        <translation>Räume enden auf %1 m von %2 m ohne Wand: Der Scan endet dort, oder die Wand ist aus Glas oder von Möbeln verdeckt; siehe LIMITS.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/evidence/levels.py"/>
        <source>The storey would be %1 x %2 m, too large for a plan of rooms: cut the cloud to a building, or check that its coordinates are metres.</source>
        <translation>Das Geschoss wäre %1 x %2 m groß, zu groß für einen Plan von Räumen: die Punktwolke auf ein Gebäude zuschneiden oder prüfen, ob ihre Koordinaten in Metern sind.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/joining.py"/>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Reducing points to voxels</source>
        <translation>Punkte werden zu Voxeln zusammengefasst</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding the storey</source>
        <translation>Das Geschoss wird gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding faces</source>
        <translation>Wandflächen werden gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding floor and ceiling</source>
        <translation>Fußboden und Decke werden gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Dividing rooms from solid</source>
        <translation>Räume werden von Mauerwerk getrennt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding rooms and walls</source>
        <translation>Räume und Wände werden gesucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <location filename="../../algorithms/site_plan/storeys/walls/walls.py"/>
        <source>parapet</source>
        <translation>Brüstung</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>nothing stands at the cut: a beam, a lamp, or what hangs</source>
        <translation>in der Schnitthöhe nichts steht: ein Balken, eine Lampe oder etwas Hängendes</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>ends below the heads of people: furniture</source>
        <translation>es unter Kopfhöhe endet: Möbel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>stands close before a wall: furniture, a curtain or a door leaf</source>
        <translation>es dicht vor einer Wand steht: Möbel, ein Vorhang oder ein Türblatt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>fills less than half of the height: a curtain or clutter</source>
        <translation>es weniger als die halbe Höhe füllt: ein Vorhang oder Störobjekte</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>too short for a wall that stands free: a door leaf or furniture</source>
        <translation>es für eine freistehende Wand zu kurz ist: ein Türblatt oder Möbel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>Threshold %1</source>
        <translation>Schwelle %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>Closing gaps</source>
        <translation>Lücken werden geschlossen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>No wall found: no pixel of the %1 that MIN_HEIGHT %2 m left is as dense as THRESHOLD %3 standard deviations; lower it, or leave it empty.</source>
        <translation>Keine Wand gefunden: Von den %1 Pixeln, die MIN_HEIGHT %2 m übrig ließ, ist keines so dicht wie THRESHOLD %3 Standardabweichungen; den Wert verringern oder leer lassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>No wall found: MIN_HEIGHT %1 m left %2 of %3 pixels; over %4 thresholds from %5 to %6 standard deviations they formed %7 regions, of which MIN_AREA %8 m² removed %9, and MAX_FILL %10 with MIN_ELONGATION %11 removed %12; relax the one that removed most.</source>
        <translation>Keine Wand gefunden: MIN_HEIGHT %1 m ließ %2 von %3 Pixeln übrig; bei %4 Schwellen von %5 bis %6 Standardabweichungen bildeten sie %7 Regionen, von denen MIN_AREA %8 m² %9 entfernte und MAX_FILL %10 mit MIN_ELONGATION %11 %12; das Kriterium lockern, das die meisten entfernte.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/height_gate.py"/>
        <source>The raster does not have the bands of heights: MIN_HEIGHT is not applied.</source>
        <translation>Das Raster hat die Bänder der Höhen nicht: MIN_HEIGHT wird nicht angewendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/height_gate.py"/>
        <source>The points reach less than %1 m above their ground, as in a horizontal slice: MIN_HEIGHT is not applied.</source>
        <translation>Die Punkte reichen weniger als %1 m über ihr Gelände, wie in einem waagrechten Schnitt: MIN_HEIGHT wird nicht angewendet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/regions.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>curved</source>
        <translation>gekrümmt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the lower quartile of the density, as nothing is known to be flat</source>
        <translation>das untere Quartil der Dichte, weil keine waagrechten Flächen bekannt sind</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the usual density of the pixels that show horizontal surfaces only</source>
        <translation>die übliche Dichte der Pixel, die nur waagrechte Flächen zeigen</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>Otsu&#x27;s threshold of the logarithm of the density</source>
        <translation>Schwellenwert nach Otsu des Logarithmus der Dichte</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the density that best separates horizontal surfaces from the rest</source>
        <translation>die Dichte, die waagrechte Flächen am besten vom Rest trennt</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>THRESHOLD_MAX %1 is below THRESHOLD %2; raise it, or leave it empty.</source>
        <translation>THRESHOLD_MAX %1 liegt unter THRESHOLD %2; den Wert erhöhen oder leer lassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/staging.py"/>
        <source>%1 is a folder</source>
        <translation>%1 ist ein Ordner</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/degrees.py"/>
        <source>x and y of %1 seem to be degrees, because they have many more decimals than z; reproject them to a projected coordinate reference system in metres.</source>
        <translation>x und y von %1 scheinen Grad zu sein, denn sie haben viel mehr Nachkommastellen als z; in ein projiziertes Koordinatenbezugssystem in Metern umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 holds no points because all lines with numbers begin with #, // or ;, as remarks do; remove these signs.</source>
        <translation>%1 enthält keine Punkte, weil alle Zeilen mit Zahlen wie Kommentare mit #, // oder ; beginnen; diese Zeichen entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 is XML, not a table of numbers; export it again as x y z.</source>
        <translation>%1 ist XML und keine Zahlentabelle; erneut als x y z exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 holds no points because no line has three numbers separated by comma, semicolon, blank or tab; export it again as x y z.</source>
        <translation>%1 enthält keine Punkte, weil keine Zeile drei durch Komma, Semikolon, Leerzeichen oder Tabulator getrennte Zahlen hat; erneut als x y z exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>The commas in %1 can be decimal signs or separators; write decimal points, or separate the columns by semicolons.</source>
        <translation>Die Kommas in %1 können Dezimal- oder Trennzeichen sein; Dezimalpunkte schreiben oder die Spalten durch Semikolons trennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>The numbers in %1 separate thousands in several ways; write them without such separators.</source>
        <translation>Die Zahlen in %1 trennen Tausender auf verschiedene Weisen; sie ohne solche Trennzeichen schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is not a text file; give it the extension of its format.</source>
        <translation>%1 ist keine Textdatei; die Endung ihres Formats verwenden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is too large for %2; choose the list, not a cloud.</source>
        <translation>%1 ist für %2 zu groß; die Liste wählen, keine Punktwolke.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is not a text file; export %2 as text.</source>
        <translation>%1 ist keine Textdatei; %2 als Text exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 has %2 lines, too many for %3, of which %4 are read at most; choose the list, not a cloud.</source>
        <translation>%1 hat %2 Zeilen, zu viele für %3; gelesen werden davon höchstens %4. Die Liste wählen, keine Punktwolke.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 cannot be read as text in %2 because it is cut off or damaged; export it again.</source>
        <translation>%1 kann nicht als Text in %2 gelesen werden, weil die Datei abgeschnitten oder beschädigt ist; erneut exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header of %1 gives lengths in %2; convert them to metres.</source>
        <translation>Die Kopfzeile von %1 gibt Längen in %2 an; in Meter umrechnen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has %2 columns in line %3 where most lines have %4; correct or remove that line.</source>
        <translation>%1 hat %2 Spalten in Zeile %3, während die meisten Zeilen %4 haben; diese Zeile berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>Line %1 of %2, below the names of the columns, is not a row of numbers; correct or remove that line.</source>
        <translation>Zeile %1 von %2, unter den Namen der Spalten, besteht nicht aus Zahlen; diese Zeile berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The remarks in %1 state several units, %2; correct them.</source>
        <translation>Die Kommentare in %1 nennen mehrere Einheiten, %2; sie berichtigen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header of %1 states the unit of some columns only; write it into the name of each column.</source>
        <translation>Die Kopfzeile von %1 nennt nur bei einigen Spalten die Einheit; sie in den Namen jeder Spalte schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has several columns called %2; rename those that are not wanted.</source>
        <translation>%1 hat mehrere Spalten namens %2; die nicht gewünschten umbenennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has %2 and %3 for one coordinate; rename what is not wanted.</source>
        <translation>%1 hat %2 und %3 für eine Koordinate; umbenennen, was nicht gewünscht ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has geographic coordinates in degrees; reproject it to a projected coordinate reference system in metres.</source>
        <translation>%1 hat geographische Koordinaten in Grad; in ein projiziertes Koordinatenbezugssystem in Metern umprojizieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header in line %1 of %2 does not name the %3 columns of the lines below; name them, with x, y and z or easting, northing and height among them.</source>
        <translation>Die Kopfzeile in Zeile %1 von %2 benennt nicht die %3 Spalten der Zeilen darunter; sie benennen, darunter x, y und z oder Rechtswert, Hochwert und Höhe (easting, northing, height).</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>a table of lengths</source>
        <translation>eine Längentabelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>The number at the end of %1 is cut off; copy or export it again.</source>
        <translation>Die Zahl am Ende von %1 ist abgeschnitten; erneut kopieren oder exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>The commas in %1 can be decimal signs or separators; separate the columns by semicolons, or write decimal points.</source>
        <translation>Die Kommas in %1 können Dezimal- oder Trennzeichen sein; die Spalten durch Semikolons trennen oder Dezimalpunkte schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 has %2 and %3 for one length; rename what is not wanted.</source>
        <translation>%1 hat %2 und %3 für eine Länge; umbenennen, was nicht gewünscht ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 rows of %2, the first in line %3, begin as remarks do and were left out; remove the sign before them if they are wanted.</source>
        <translation>%1 Zeilen von %2, die erste in Zeile %3, beginnen wie Kommentare und wurden ausgelassen; werden sie gebraucht, das Zeichen davor entfernen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 has no column %2; add or rename it.</source>
        <translation>In %1 fehlt die Spalte %2; sie ergänzen oder umbenennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>Line %1 of %2 has %3 fields where the header names %4 columns; correct that line, or write decimal points if the separator is a comma.</source>
        <translation>Zeile %1 von %2 hat %3 Felder, die Kopfzeile aber benennt %4 Spalten; diese Zeile berichtigen oder, wenn das Trennzeichen ein Komma ist, Dezimalpunkte schreiben.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says &#x27;%2&#x27;, which is not applied; apply it to the coordinates of the list where they need it.</source>
        <translation>Der Kopf von %1 sagt &#x27;%2&#x27;, was nicht angewendet wird; auf die Koordinaten der Liste anwenden, wenn es nötig ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says &#x27;%2&#x27;, which is not applied; move the points by it with transformcloud where they need it.</source>
        <translation>Der Kopf von %1 sagt &#x27;%2&#x27;, was nicht angewendet wird; die Punkte mit transformcloud so bewegen, wenn es nötig ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says that %2 is up, which is not applied; rotate the points so that z is.</source>
        <translation>Der Kopf von %1 sagt, dass %2 nach oben zeigt, was nicht angewendet wird; die Punkte drehen, bis z nach oben zeigt.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>A remark in %1 names EPSG:%2, which is not read; choose that reference system if it is right.</source>
        <translation>Ein Kommentar in %1 nennt EPSG:%2, was nicht gelesen wird; dieses Bezugssystem wählen, wenn es richtig ist.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/units.py"/>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/units.py"/>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>likeness of tiles around it</source>
        <translation>Ähnlichkeit der Kacheln ringsum</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>width of the pattern</source>
        <translation>Breite des Musters</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>points around the centre</source>
        <translation>Punkte um das Zentrum</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>planar surface</source>
        <translation>ebene Fläche</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>share of the points on a plane</source>
        <translation>Anteil der Punkte auf einer Ebene</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>angle of incidence</source>
        <translation>Auftreffwinkel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>likeness of two edges</source>
        <translation>Ähnlichkeit zweier Kanten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>shift of the centre</source>
        <translation>Verschiebung des Zentrums</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>planar target</source>
        <translation>ebene Zielmarke</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points on the target</source>
        <translation>Punkte auf der Zielmarke</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points in the poorest quadrant</source>
        <translation>Punkte im schwächsten Quadranten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points of the colour of their quadrant</source>
        <translation>Punkte in der Farbe ihres Quadranten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>difference between quadrants of one colour</source>
        <translation>Unterschied zwischen Quadranten einer Farbe</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>contrast of black and white</source>
        <translation>Kontrast von Schwarz und Weiß</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>share of the intensities explained by two edges</source>
        <translation>Anteil der durch zwei Kanten erklärten Intensitäten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>difference of the edges from a right angle</source>
        <translation>Abweichung der Kanten vom rechten Winkel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>two edges explain only %1 of the intensities</source>
        <translation>zwei Kanten erklären nur %1 der Intensitäten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>only %1 points in a quadrant</source>
        <translation>nur %1 Punkte in einem Quadranten</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>its quadrants of one colour differ in tone</source>
        <translation>ihre Quadranten einer Farbe unterscheiden sich im Ton</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>its quadrants end at different distances</source>
        <translation>ihre Quadranten enden in verschiedenen Abständen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>the standard deviation of the centre is %1 mm</source>
        <translation>die Standardabweichung des Zentrums beträgt %1 mm</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>With a step of %1 mm at 10 m, a target of %2 mm has four points a quadrant up to %3 m; scan with %4 mm to find it up to %5 m.</source>
        <translation>Bei einer Schrittweite von %1 mm auf 10 m hat eine Zielmarke von %2 mm bis %3 m vier Punkte je Quadrant; mit %4 mm scannen, um sie bis %5 m zu finden.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>black and white target</source>
        <translation>Schwarz-Weiß-Zielmarke</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <location filename="../../algorithms/targets/results.py"/>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>Nothing in %1 looks like a %2.</source>
        <translation>Nichts in %1 sieht aus wie eine %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>%1 by the %2</source>
        <translation>%1 am Kriterium „%2“</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>%1 places in %2 look like a %3 and failed: %4. The nearest miss, at %5, failed by the %6: %7, where %8 is the limit.</source>
        <translation>%1 Stellen in %2 sehen aus wie eine %3 und scheiterten: %4. Am knappsten scheiterte die bei %5, am Kriterium „%6“: %7 bei einem Grenzwert von %8.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>without end</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/lists.py"/>
        <location filename="../../algorithms/targets/search.py"/>
        <source>Two scans are called %1, so that their lists would be one file; rename a scan.</source>
        <translation>Zwei Scans heißen %1, sodass ihre Listen dieselbe Datei wären; einen Scan umbenennen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>size (mm)</source>
        <translation>Größe (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>std (mm)</source>
        <translation>Standardabw. (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>incidence (degrees)</source>
        <translation>Auftreffwinkel (Grad)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>, %1 doubtful</source>
        <translation>, %1 zweifelhafte</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>%1 targets%2, in %3 points with a step of %4 mm at 10 m.</source>
        <translation>%1 Zielmarken%2, in %3 Punkten mit einer Schrittweite von %4 mm auf 10 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>Doubtful: %1</source>
        <translation>Zweifelhaft: %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>%1. %2, %3 mm, %4 m away, centre to %5 mm. The picture is %6 mm high.</source>
        <translation>%1. %2, %3 mm, in %4 m Entfernung, Zentrum auf %5 mm. Das Bild ist %6 mm hoch.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>What the pictures show</source>
        <translation>Was die Bilder zeigen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>A black and white target is drawn by the intensities that the scanner measured, a sphere by its distances, near ones bright. The cross marks the fitted centre and leaves it free. Where the arms do not lie between the quadrants, or not around the middle of the sphere, the target is wrong: delete its row from the list.</source>
        <translation>Eine Schwarz-Weiß-Zielmarke ist mit den vom Scanner gemessenen Intensitäten gezeichnet, eine Kugel mit ihren Entfernungen, nahe hell. Das Kreuz bezeichnet das eingepasste Zentrum und lässt es frei. Wo die Arme nicht zwischen den Quadranten oder nicht um die Mitte der Kugel liegen, ist die Zielmarke falsch: ihre Zeile aus der Liste löschen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>Targets in scans</source>
        <translation>Zielmarken in Scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>Coordinates of the scan in metres; std: standard deviation of the centre in space. Red: doubtful, not in the list.</source>
        <translation>Koordinaten des Scans in Metern; Standardabweichung des Zentrums im Raum. Rot: zweifelhaft, nicht in der Liste.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>its %1 points fill too few directions</source>
        <translation>ihre %1 Punkte füllen zu wenige Richtungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>ranges jump between %1 of its neighbours</source>
        <translation>die Entfernungen springen zwischen %1 der Nachbarn</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>%1 has too few points in which to search for targets; choose a denser scan.</source>
        <translation>%1 hat zu wenige Punkte, um darin nach Zielmarken zu suchen; einen dichteren Scan wählen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>%1 is not the scan of one station at %2: %3. Choose the scans of single stations, in the scanner&#x27;s own frame or with STATION, the position of the scanner.</source>
        <translation>%1 ist nicht der Scan eines einzigen Standpunkts bei %2: %3. Scans einzelner Standpunkte wählen, im System des Scanners oder mit STATION, der Position des Scanners.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/station.py"/>
        <source>%1 states where its scanner stood; leave STATION empty.</source>
        <translation>%1 nennt den Standpunkt seines Scanners; STATION leer lassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/results.py"/>
        <source>black and white</source>
        <translation>schwarz-weiß</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/search.py"/>
        <source>%1 has no intensity, so that only spheres can be found; export it with intensity to find black and white targets.</source>
        <translation>%1 hat keine Intensität, sodass nur Kugeln gefunden werden können; für Schwarz-Weiß-Zielmarken mit Intensität exportieren.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/search.py"/>
        <source>%1 has no intensity, without which no black and white target can be seen; export it with intensity, or set KIND to spheres.</source>
        <translation>%1 hat keine Intensität, ohne die keine Schwarz-Weiß-Zielmarke zu sehen ist; mit Intensität exportieren oder KIND auf Kugeln setzen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>round surface</source>
        <translation>runde Fläche</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>points on the sphere</source>
        <translation>Punkte auf der Kugel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>scatter of the ranges</source>
        <translation>Streuung der Entfernungen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>difference from a usual diameter</source>
        <translation>Abweichung von einem üblichen Durchmesser</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>round surface of this diameter</source>
        <translation>runde Fläche dieses Durchmessers</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the sphere that was seen</source>
        <translation>gesehener Teil der Kugel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the rays that pass through it</source>
        <translation>Teil der Strahlen, die hindurchgehen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the surroundings at its depth</source>
        <translation>Teil der Umgebung in ihrer Tiefe</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>its diameter may be %1 mm; set SIZE</source>
        <translation>ihr Durchmesser kann %1 mm sein; SIZE setzen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>only %1 points</source>
        <translation>nur %1 Punkte</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>only %1 of it was seen</source>
        <translation>nur %1 davon wurden gesehen</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>Searching %1 for black and white targets</source>
        <translation>%1 wird nach Schwarz-Weiß-Zielmarken durchsucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>Searching %1 for spheres</source>
        <translation>%1 wird nach Kugeln durchsucht</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>crossings nearby</source>
        <translation>Kreuzungen in der Nähe</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>%1: cannot write this kind of layer; end the name in .shp or .gpkg.</source>
        <translation>%1: Diese Art von Layer kann nicht geschrieben werden; den Namen auf .shp oder .gpkg enden lassen.</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>the disk is full</source>
        <translation>das Laufwerk ist voll</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>%1 cannot be written (%2); free some space or choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden (%2); Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1 cannot be %2: %3</source>
        <translation>%1 kann nicht %2 werden: %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>There is not enough memory; cut or thin the input, or close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht aus; die Eingabe zuschneiden oder ausdünnen oder andere Programme schließen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1 has no parameter %2; it is ignored.</source>
        <translation>%1 hat keinen Parameter %2; er wird nicht beachtet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1: %2 is an input as well; choose another folder.</source>
        <translation>%1: %2 ist zugleich Eingabe; einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Compare lengths of a facade</source>
        <translation>Längen einer Fassade vergleichen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Compares the lengths of a schedule with tape measurements.</source>
        <translation>Vergleicht die Längen einer Maßliste mit Messungen mit dem Maßband.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Widths, heights and sills are paired by the id of the detail. The table and the report give automatic minus manual length, its mean and its standard deviation, as table 1 of Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal (2014).</source>
        <translation>Breiten, Höhen und Brüstungshöhen werden über die Nummer (id) des Details gepaart. Tabelle und Bericht geben automatische minus manuelle Länge, deren Mittel und Standardabweichung an, wie Tabelle 1 von Aitelkadi, Tahiri, Simonetto, Sebari und Boulaassal (2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Schedule</source>
        <translation>Maßliste</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>The csv file that facadedetails writes.</source>
        <translation>Die CSV-Datei, die facadedetails schreibt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Manual lengths</source>
        <translation>Manuelle Längen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>A csv file with the columns id and any of width, height and sill, empty where not measured, or with the columns id, dimension and length. Lengths in metres, separated by commas or semicolons, with the ids of the schedule.</source>
        <translation>Eine CSV-Datei mit den Spalten id und beliebigen von width, height und sill, leer, wo nicht gemessen wurde, oder mit den Spalten id, dimension und length. Längen in Metern, durch Kommas oder Semikolons getrennt, mit den Nummern der Maßliste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>CSV file with a row for each length that both files have.</source>
        <translation>CSV-Datei mit einer Zeile für jede Länge, die beide Dateien haben.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Report of the lengths</source>
        <translation>Bericht über die Längen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>HTML page with the table and a plot.</source>
        <translation>HTML-Seite mit der Tabelle und einem Diagramm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Mean of automatic minus manual length (m)</source>
        <translation>Mittel von automatischer minus manueller Länge (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Standard deviation of the differences (m)</source>
        <translation>Standardabweichung der Differenzen (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Largest absolute difference (m)</source>
        <translation>Größte absolute Differenz (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Number of lengths compared</source>
        <translation>Anzahl der verglichenen Längen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>%1 lengths: mean difference %2 mm, standard deviation %3 mm.</source>
        <translation>%1 Längen: mittlere Differenz %2 mm, Standardabweichung %3 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Compare a plan with a reference</source>
        <translation>Plan mit einer Referenz vergleichen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Measures how complete, correct and accurate a plan is, compared with a reference.</source>
        <translation>Misst, wie vollständig, richtig und genau ein Plan im Vergleich zu einer Referenz ist.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The boundaries of both layers are compared every 2 cm. Completeness is the share of the reference&#x27;s boundary with a boundary of the plan within the tolerance. Correctness is the share of the plan&#x27;s boundary with one of the reference within the tolerance. The offsets are the distances of the two, where the reference was found.</source>
        <translation>Die Begrenzungen beider Layer werden alle 2 cm verglichen. Die Vollständigkeit ist der Anteil der Begrenzung der Referenz, bei dem eine Begrenzung des Plans innerhalb der Toleranz liegt. Die Richtigkeit ist der Anteil der Begrenzung des Plans, bei dem eine der Referenz innerhalb der Toleranz liegt. Der Versatz ist der Abstand der beiden, wo die Referenz gefunden wurde.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Walls of the plan</source>
        <translation>Wände des Plans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Polygons, as siteplan writes them. Polygons that touch are joined.</source>
        <translation>Polygone, wie siteplan sie schreibt. Polygone, die sich berühren, werden verbunden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The true walls as polygons, or their faces as lines, in metres. In the coordinate reference system of the walls. A layer with a polygon whose field kind is judged is a plan drawn by hand: its kinds say what a plan must have, what it may have, and where nothing is judged.</source>
        <translation>Die wahren Wände als Polygone oder ihre Wandflächen als Linien, in Metern, im Koordinatenbezugssystem der Wände. Ein Layer mit einem Polygon, dessen Feld kind den Wert judged hat, ist ein von Hand gezeichneter Plan: Seine Arten sagen, was ein Plan haben muss, was er haben darf und wo nichts beurteilt wird.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Rooms of the plan</source>
        <translation>Räume des Plans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Polygons, as siteplan writes them: they are compared with the rooms of a plan drawn by hand.</source>
        <translation>Polygone, wie siteplan sie schreibt: Sie werden mit den Räumen eines von Hand gezeichneten Plans verglichen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Up to this distance a boundary counts as found. Choose it from the accuracy the plan needs.</source>
        <translation>Bis zu diesem Abstand gilt eine Begrenzung als gefunden. Nach der Genauigkeit wählen, die der Plan braucht.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Lines with side (plan or reference), state (agrees, wrong, missing), median and largest offset, length. GeoPackage or shapefile, by extension.</source>
        <translation>Linien mit side (plan oder reference), state (agrees, wrong, missing), Median und Größtwert des Versatzes, Länge. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Report of the comparison</source>
        <translation>Bericht über den Vergleich</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>HTML page with a map, curves and tables.</source>
        <translation>HTML-Seite mit Karte, Kurven und Tabellen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Share of the reference that is in the plan (0 to 1)</source>
        <translation>Anteil der Referenz, der im Plan ist (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Share of the plan that is in the reference (0 to 1)</source>
        <translation>Anteil des Plans, der in der Referenz ist (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Intersection over union of the areas (0 to 1)</source>
        <translation>Schnitt durch Vereinigung der Flächen (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Median offset of the reference that was found (m)</source>
        <translation>Median des Versatzes der gefundenen Referenz (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Offset that 95 % of the reference that was found does not exceed (m)</source>
        <translation>Versatz, den 95 % der gefundenen Referenz nicht überschreiten (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of drawn rooms that the plan has</source>
        <translation>Anzahl gezeichneter Räume, die der Plan hat</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of drawn rooms that it lacks</source>
        <translation>Anzahl gezeichneter Räume, die ihm fehlen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of its rooms that are not drawn</source>
        <translation>Anzahl seiner Räume, die nicht gezeichnet sind</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Completeness %1, correctness %2.</source>
        <translation>Vollständigkeit %1, Richtigkeit %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The reference is a plan drawn by hand: only its judged region is compared.</source>
        <translation>Die Referenz ist ein von Hand gezeichneter Plan: Nur ihr beurteilter Bereich wird verglichen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>ROOMS are not compared, because REFERENCE has no rooms drawn by hand.</source>
        <translation>ROOMS werden nicht verglichen, weil REFERENCE keine von Hand gezeichneten Räume hat.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Rooms: %1 found, %2 missed, %3 invented.</source>
        <translation>Räume: %1 gefunden, %2 nicht gefunden, %3 erfunden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Offset: median %1 m, 95 % %2 m.</source>
        <translation>Versatz: Median %1 m, 95 % %2 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>Density image from laser scans</source>
        <translation>Dichtebild aus Laserscans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>Counts the points above each pixel of the ground plan, after thinning.</source>
        <translation>Zählt nach dem Ausdünnen die Punkte über jedem Pixel des Grundrisses.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>The clouds are thinned, and the points above each pixel are counted: walls stand out because many points lie above each other there. Further bands hold the height that points fill above the local ground, the lowest and highest point, the ground, and two measures that separate foliage and furniture from walls (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Die Punktwolken werden ausgedünnt, und die Punkte über jedem Pixel werden gezählt: Wände treten hervor, weil dort viele Punkte übereinanderliegen. Weitere Bänder enthalten die Höhe, die Punkte über dem örtlichen Gelände füllen, den tiefsten und höchsten Punkt, das Gelände und zwei Maße, die Bewuchs und Möbel von Wänden trennen (Mueller, Kohoutek und Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Example data</source>
        <translation>Beispieldaten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Copies simulated scans of a house and of a facade into a folder, to try the toolbox.</source>
        <translation>Kopiert simulierte Scans eines Hauses und einer Fassade in einen Ordner, um die Werkzeuge auszuprobieren.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Eight scans of a house (house_01.laz to house_08.laz), each in the frame of its scanner and with the list of its targets (house_01.txt to house_08.txt); the surveyed control points (control.txt, EPSG:25833); and a scan of a facade (facade.laz). The manual says what to do with them.</source>
        <translation>Acht Scans eines Hauses (house_01.laz bis house_08.laz), jeder im System seines Scanners und mit der Liste seiner Zielmarken (house_01.txt bis house_08.txt), die eingemessenen Passpunkte (control.txt, EPSG:25833) und ein Scan einer Fassade (facade.laz). Das Handbuch sagt, was damit zu tun ist.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Folder for 18 files, 3.5 MB.</source>
        <translation>Ordner für 18 Dateien, 3.5 MB.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Files: %1.</source>
        <translation>Dateien: %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Walls from a density image</source>
        <translation>Wände aus einem Dichtebild</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Extracts the walls from a density image, as raster and polygons.</source>
        <translation>Extrahiert die Wände aus einem Dichtebild, als Raster und Polygone.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Pixels above several thresholds form regions. Large ones that are shaped like straight or curved walls are kept and combined, gaps are closed and outlines traced (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Pixel über mehreren Schwellen bilden Regionen. Große, die wie gerade oder gekrümmte Wände geformt sind, werden behalten und vereinigt, Lücken geschlossen und Umrisse verfolgt (Mueller, Kohoutek und Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>The output of &#x27;Density image from laser scans&#x27;.</source>
        <translation>Die Ausgabe von „Dichtebild aus Laserscans“.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Details of a facade</source>
        <translation>Details einer Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Measures openings, recesses, projections and coloured details of a scanned facade.</source>
        <translation>Misst Öffnungen, Rücksprünge, Vorsprünge und farbige Details einer gescannten Fassade.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Finds the main plane of the facade; coplanar details by colour and intensity; openings and recesses by the points behind the wall; projections by the planes in front of it. An outline is the mean of both sides of a border, with standard deviations. The clouds are enough; without colour, only openings, recesses and projections are found (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014).</source>
        <translation>Findet die Hauptebene der Fassade, Details in der Ebene über Farbe und Intensität, Öffnungen und Rücksprünge über die Punkte hinter der Wand, Vorsprünge über die Ebenen davor. Ein Umriss ist das Mittel beider Seiten eines Randes, mit Standardabweichungen. Die Punktwolken genügen; ohne Farbe werden nur Öffnungen, Rücksprünge und Vorsprünge gefunden (Aitelkadi, Tahiri, Simonetto, Sebari und Boulaassal 2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Orthoimage</source>
        <translation>Orthobild</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>GeoTIFF in u, v: the colours of the facade projected onto its plane, or its intensity.</source>
        <translation>GeoTIFF in u, v: die auf die Ebene der Fassade projizierten Farben oder deren Intensität.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Details in space</source>
        <translation>Details im Raum</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>The polygons of the elevation in x, y, z of the site, with the same ids and areas.</source>
        <translation>Die Polygone der Ansicht in x, y, z des Objekts, mit denselben Nummern und Flächen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Elevation</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Polygons in u (right) and v (up), in metres: the wall, its details, and areas that were not seen.</source>
        <translation>Polygone in u (rechts) und v (oben), in Metern: die Wand, ihre Details und nicht gesehene Flächen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>CSV file with a row for each detail: kind, width, height, sill, area, standard deviations.</source>
        <translation>CSV-Datei mit einer Zeile für jedes Detail: Art, Breite, Höhe, Brüstungshöhe, Fläche, Standardabweichungen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>DXF file in metres, with a layer for each kind; needs the package ezdxf.</source>
        <translation>DXF-Datei in Metern, mit einem Layer für jede Art; benötigt das Paket ezdxf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Polygons in u, v, with reason and area: holes of the wall, regions of another colour and surfaces that are not drawn.</source>
        <translation>Polygone in u, v mit Grund und Fläche: Löcher der Wand, Regionen einer anderen Farbe und Flächen, die nicht gezeichnet sind.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Report of the facade</source>
        <translation>Bericht über die Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>HTML page with a key plan of all facades of the cloud, and the details of the one drawn.</source>
        <translation>HTML-Seite mit einem Übersichtsplan aller Fassaden der Punktwolke und den Details der gezeichneten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Number of details</source>
        <translation>Anzahl der Details</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Number of facades in the cloud</source>
        <translation>Anzahl der Fassaden in der Punktwolke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Area of the wall without openings and recesses (m²)</source>
        <translation>Fläche der Wand ohne Öffnungen und Rücksprünge (m²)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Facades drawn into the folder: %1.</source>
        <translation>In den Ordner gezeichnete Fassaden: %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Left out: %1 of kind %2, %3 m² in all: %4.</source>
        <translation>Ausgelassen: %1 der Art %2, insgesamt %3 m²: %4.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>A part of %1 m² lies %2 m from the main wall.</source>
        <translation>Ein Teil von %1 m² liegt %2 m von der Hauptwand entfernt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Details: %1.</source>
        <translation>Details: %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Planes of a facade</source>
        <translation>Ebenen einer Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Finds the main plane of a facade and the secondary planes on it.</source>
        <translation>Findet die Hauptebene einer Fassade und die Nebenebenen auf ihr.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>RANSAC finds the largest upright plane of the scan, the facade without street, trees and side walls, and then the planes on it: recessed doors and windows, cornices, bays. Each plane is fitted by total least squares. Every point belongs to the nearest plane within DISTANCE (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014).</source>
        <translation>RANSAC findet die größte lotrechte Ebene des Scans, die Fassade ohne Straße, Bäume und Seitenwände, und dann die Ebenen auf ihr: zurückgesetzte Türen und Fenster, Gesimse, Erker. Jede Ebene wird durch Ausgleichung mit orthogonalen Abständen eingepasst. Jeder Punkt gehört zur nächsten Ebene innerhalb von DISTANCE (Aitelkadi, Tahiri, Simonetto, Sebari und Boulaassal 2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Polygons in space with normal, distance from the origin, azimuth, tilt, rms, number of points and true area, because GIS computes an area of 0 for an upright polygon.</source>
        <translation>Polygone im Raum mit Normale, Abstand vom Ursprung, Azimut, Neigung, RMS, Anzahl der Punkte und wahrer Fläche, denn GIS berechnet für ein lotrechtes Polygon die Fläche 0.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Points with the number of their plane</source>
        <translation>Punkte mit der Nummer ihrer Ebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>The cloud with all its attributes and the attribute plane, 0 for points outside all planes. LAZ, LAS or text.</source>
        <translation>Die Punktwolke mit allen Attributen und dem Attribut plane, 0 für Punkte außerhalb aller Ebenen. LAZ, LAS oder Text.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Number of planes</source>
        <translation>Anzahl der Ebenen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Plane %1: %2 points, rms %3 mm.</source>
        <translation>Ebene %1: %2 Punkte, RMS %3 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Find targets in scans</source>
        <translation>Zielmarken in Scans finden</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Finds black and white targets and spheres in scans, and measures their centres.</source>
        <translation>Findet Schwarz-Weiß-Zielmarken und Kugeln in Scans und misst ihre Zentren.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Each scan becomes the image that the scanner saw. The centre of a black and white target is the crossing of its two edges on the fitted plane, that of a sphere the centre of the fitted sphere without its far rim. Each centre has a standard deviation. Targets that are doubtful are in the layer and in the report, but not in the lists.</source>
        <translation>Jeder Scan wird zu dem Bild, das der Scanner sah. Das Zentrum einer Schwarz-Weiß-Zielmarke ist der Schnittpunkt ihrer beiden Kanten auf der eingepassten Ebene, das einer Kugel der Mittelpunkt der ohne ihren fernen Rand eingepassten Kugel. Jedes Zentrum hat eine Standardabweichung. Zweifelhafte Zielmarken stehen im Layer und im Bericht, aber nicht in den Listen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Lists of targets</source>
        <translation>Listen der Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Folder for one text file per scan with x y z of its targets, for TARGETS of &#x27;Register scans to control points&#x27;.</source>
        <translation>Ordner für eine Textdatei je Scan mit x y z seiner Zielmarken, für TARGETS von „Scans auf Passpunkte registrieren“.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Targets</source>
        <translation>Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Points with kind, size, standard deviation of the centre, number of points, angle of incidence and quality; doubtful ones too, with the reason. GeoPackage or shapefile, by extension.</source>
        <translation>Punkte mit Art, Größe, Standardabweichung des Zentrums, Anzahl der Punkte, Auftreffwinkel und Qualität; auch zweifelhafte, mit dem Grund. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>HTML page with a picture of each target as the scanner saw it, the fitted centre drawn in.</source>
        <translation>HTML-Seite mit einem Bild jeder Zielmarke, wie der Scanner sie sah, mit eingezeichnetem Zentrum.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Number of targets without doubt</source>
        <translation>Anzahl der nicht zweifelhaften Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>No target was found; the log says which tests failed, and how near.</source>
        <translation>Es wurde keine Zielmarke gefunden; das Protokoll sagt, welche Kriterien nicht erfüllt waren und wie knapp.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Sheet of a plan or an elevation</source>
        <translation>Planblatt eines Grundrisses oder einer Ansicht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Makes a print layout that is true to scale, with legend, grid and title block, and its PDF.</source>
        <translation>Erstellt ein maßstäbliches Drucklayout mit Legende, Gitter und Plankopf sowie dessen PDF.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>The layers are drawn in their styles at the scale of the sheet, with a grid of coordinates, scale bar, north, legend and title block. Author and title come from the properties of the project. The layout joins the project, where it can be changed; nothing else in the project changes.</source>
        <translation>Die Layer werden mit ihrer Darstellung im Maßstab des Blattes gezeichnet, mit Koordinatengitter, Maßstabsleiste, Nordpfeil, Legende und Plankopf. Verfasser und Titel stammen aus den Eigenschaften des Projekts. Das Layout kommt zum Projekt hinzu, wo es geändert werden kann; sonst ändert sich im Projekt nichts.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Walls, or elevation</source>
        <translation>Wände oder Ansicht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Polygons of the walls, or of a facade.</source>
        <translation>Polygone der Wände oder einer Fassade.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn below the walls.</source>
        <translation>Unter den Wänden gezeichnet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn above the walls.</source>
        <translation>Über den Wänden gezeichnet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn below all else: a density image or an orthoimage.</source>
        <translation>Unter allem anderen gezeichnet: ein Dichtebild oder ein Orthobild.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>A plan has a north arrow, an elevation has none.</source>
        <translation>Ein Grundriss hat einen Nordpfeil, eine Ansicht keinen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>50 for rooms, 100 for houses. A metre is 20 mm on paper at 1:50.</source>
        <translation>50 für Räume, 100 für Häuser. Ein Meter ist bei 1:50 auf dem Papier 20 mm lang.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>denominator</source>
        <translation>Nenner</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>The paper; upright if the drawing fits only so.</source>
        <translation>Das Papier; hochkant, wenn die Zeichnung nur so passt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>If not set, the title of the project, or the name of the walls layer.</source>
        <translation>Wenn leer, der Titel des Projekts oder der Name des Layers der Wände.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Sheet as PDF</source>
        <translation>Blatt als PDF</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>PDF file; print it at 100 %, not fitted to the page.</source>
        <translation>PDF-Datei; mit 100 % drucken, nicht an die Seite anpassen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Sheet as SVG</source>
        <translation>Blatt als SVG</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>SVG file, for drawing programs.</source>
        <translation>SVG-Datei, für Zeichenprogramme.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>1:%1 on %2</source>
        <translation>1:%1 auf %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>local, metres</source>
        <translation>lokal, Meter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>The control points have no coordinate reference system, so the results have none; set CRS.</source>
        <translation>Die Passpunkte haben kein Koordinatenbezugssystem, daher haben die Ergebnisse keines; CRS setzen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Register scans to control points</source>
        <translation>Scans auf Passpunkte registrieren</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Identifies the control point behind each target, without names, and georeferences the scans.</source>
        <translation>Findet zu jeder Zielmarke den Passpunkt, ohne Namen, und georeferenziert die Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Targets picked or found in each scan are matched with surveyed control points by their distances, and the transformations of all scans are adjusted together. Targets that are not control points tie the scans to each other. A scan without an unambiguous solution is refused, with the reason (Herbig, Mayer, Mortada and Rasztovits 2013).</source>
        <translation>In jedem Scan gemessene oder gefundene Zielmarken werden über ihre Strecken eingemessenen Passpunkten zugeordnet, und die Transformationen aller Scans werden gemeinsam ausgeglichen. Zielmarken, die keine Passpunkte sind, verknüpfen die Scans untereinander. Ein Scan ohne eindeutige Lösung wird mit Angabe des Grundes abgelehnt (Herbig, Mayer, Mortada und Rasztovits 2013).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Transformations</source>
        <translation>Transformationen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>JSON file with the status and the matrix of each scan, for &#x27;Transform laser scans&#x27;.</source>
        <translation>JSON-Datei mit Status und Matrix jedes Scans, für „Laserscans transformieren“.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Control points, surveyed and appended</source>
        <translation>Passpunkte, eingemessene und neue</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Points with their standard deviations and the scans that use them. GeoPackage or shapefile, by extension.</source>
        <translation>Punkte mit ihren Standardabweichungen und den Scans, die sie verwenden. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Points with the difference between target and control point, drawn as arrows, and their tests. GeoPackage or shapefile, by extension.</source>
        <translation>Punkte mit der Differenz zwischen Zielmarke und Passpunkt, als Pfeile gezeichnet, und ihren Tests. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Report of the registration</source>
        <translation>Bericht über die Registrierung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>HTML page with plan, residuals and statistics of every scan; see the results viewer.</source>
        <translation>HTML-Seite mit Plan, Restklaffungen und Statistik jedes Scans; siehe Ergebnisanzeige.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Number of registered scans</source>
        <translation>Anzahl der registrierten Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Standard deviation of unit weight, a posteriori over a priori</source>
        <translation>Standardabweichung der Gewichtseinheit, a posteriori durch a priori</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Longest residual of the targets that were used (m)</source>
        <translation>Größte Restklaffung der verwendeten Zielmarken (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>TARGETS is empty; choose at least one list of points, or scan.</source>
        <translation>TARGETS ist leer; mindestens eine Punktliste oder einen Scan wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>No scan has targets, so that CONTROL cannot be used; choose TARGETS, or leave CONTROL empty to join the scans in the frame of the first.</source>
        <translation>Kein Scan hat Zielmarken, daher ist CONTROL nicht verwendbar; TARGETS wählen oder CONTROL leer lassen, um die Scans im System des ersten zu verbinden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>No scan could be registered. %1</source>
        <translation>Kein Scan konnte registriert werden. %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Tolerance of distances: %1 mm.</source>
        <translation>Streckentoleranz: %1 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1 is not registered (%2): %3</source>
        <translation>%1 ist nicht registriert (%2): %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1 and %2 share %3 patches of surface, an overlap of %4 %; after the adjustment they lie %5 mm apart (rms).</source>
        <translation>%1 und %2 haben %3 Flächenstücke gemeinsam, eine Überlappung von %4 %; nach der Ausgleichung liegen sie %5 mm auseinander (rms).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>, %1 accidental matches expected</source>
        <translation>, %1 zufällige Zuordnungen zu erwarten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1: %2 of %3 targets matched, sigma0 %4, longest residual %5 mm, standard deviation up to %6 mm%7.</source>
        <translation>%1: %2 von %3 Zielmarken zugeordnet, sigma0 %4, größte Restklaffung %5 mm, Standardabweichung bis %6 mm%7.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Targets seen in each scan</source>
        <translation>In jedem Scan gesehene Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Number of control points that a scan sees. Fewer than 5 rarely give an unambiguous match.</source>
        <translation>Anzahl der Passpunkte, die ein Scan sieht. Weniger als 5 ergeben selten eine eindeutige Zuordnung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Scale error</source>
        <translation>Maßstabsfehler</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Relative excess of all distances from the centroid of the targets of a scan.</source>
        <translation>Relativer Überschuss aller Strecken vom Schwerpunkt der Zielmarken eines Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Number of simulated scans</source>
        <translation>Anzahl der simulierten Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>1000 determine the success rate to about one per cent, in a minute.</source>
        <translation>1000 bestimmen die Erfolgsquote auf etwa ein Prozent, in einer Minute.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Seed of the random numbers</source>
        <translation>Startwert der Zufallszahlen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>The same seed gives the same result; change it to see how much results vary.</source>
        <translation>Derselbe Startwert gibt dasselbe Ergebnis; ihn ändern, um zu sehen, wie stark Ergebnisse schwanken.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>any number</source>
        <translation>beliebige Zahl</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Reach of a scan</source>
        <translation>Reichweite eines Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>All targets of a scan lie within this distance of one control point, because a scanner sees only what is near. If not set, they come from the whole list.</source>
        <translation>Alle Zielmarken eines Scans liegen innerhalb dieser Entfernung von einem Passpunkt, denn ein Scanner sieht nur die Umgebung. Wenn leer, kommen sie aus der ganzen Liste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Simulate the registration of scans</source>
        <translation>Registrierung von Scans simulieren</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Checks before fieldwork whether the control points can be identified unambiguously.</source>
        <translation>Prüft vor dem Außendienst, ob die Passpunkte eindeutig erkannt werden können.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Random parts of the control list are seen from random stations, with noise and a scale error, and are registered as scans. The report states how many were identified, which control points are confused, and how accurate the transformations are (Herbig, Mayer, Mortada and Rasztovits 2013).</source>
        <translation>Zufällige Teile der Passpunktliste werden von zufälligen Standpunkten gesehen, mit Rauschen und Maßstabsfehler, und als Scans registriert. Der Bericht sagt, wie viele erkannt wurden, welche Passpunkte verwechselt werden und wie genau die Transformationen sind (Herbig, Mayer, Mortada und Rasztovits 2013).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>CSV file with a row for each simulated scan: its points, its result, and its errors.</source>
        <translation>CSV-Datei mit einer Zeile für jeden simulierten Scan: seine Punkte, sein Ergebnis und seine Fehler.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Report of the simulation</source>
        <translation>Bericht über die Simulation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>HTML page with failures, ambiguous points and errors; see the results viewer.</source>
        <translation>HTML-Seite mit Fehlschlägen, mehrdeutigen Punkten und Fehlern; siehe Ergebnisanzeige.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Share of scans that were registered with all targets right (0 to 1)</source>
        <translation>Anteil der Scans, die mit allen Zielmarken richtig registriert wurden (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>All targets right in %1 of %2 scans.</source>
        <translation>Alle Zielmarken richtig in %1 von %2 Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Control points that are confused, the most frequent first: %1.</source>
        <translation>Verwechselte Passpunkte, die häufigsten zuerst: %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Outlines on the wall faces</source>
        <translation>Umrisse auf den Wandflächen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Moves the outlines from the edges of pixels to the points of the faces, straight or curved, and measures thickness, radius and coverage. If off, outlines follow pixels, as in the paper.</source>
        <translation>Verschiebt die Umrisse von den Rändern der Pixel auf die Punkte der Wandflächen, gerade oder gekrümmt, und misst Dicke, Radius und Bedeckung. Ausgeschaltet folgen die Umrisse den Pixeln, wie im Artikel.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Site plan from laser scans</source>
        <translation>Grundriss aus Laserscans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Turns terrestrial laser scans into a site plan: the walls as polygons.</source>
        <translation>Macht aus terrestrischen Laserscans einen Grundriss: die Wände als Polygone.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>The clouds are thinned, a density image is computed, and the walls are extracted from it. Only the clouds are needed: defaults that depend on the data are derived and written to the log (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Die Punktwolken werden ausgedünnt, ein Dichtebild wird berechnet und die Wände werden daraus extrahiert. Nur die Punktwolken sind nötig: Vorgabewerte, die von den Daten abhängen, werden abgeleitet und ins Protokoll geschrieben (Mueller, Kohoutek und Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Left out as foliage because their points lie on no face: %1.</source>
        <translation>Als Bewuchs ausgelassen, weil ihre Punkte auf keiner Wandfläche liegen: %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Outlines on the faces: %1 of their length has points on it.</source>
        <translation>Umrisse auf den Wandflächen: %1 ihrer Länge sind mit Punkten belegt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Thin laser scans</source>
        <translation>Laserscans ausdünnen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Clouds</source>
        <translation>Punktwolken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Leaves out points so that no two are closer than a minimum distance.</source>
        <translation>Lässt Punkte aus, sodass keine zwei näher als ein Mindestabstand liegen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Points are left out until no two are closer than the point spacing. The distance is exact, in space, and holds across files. Several files become one. LAS and LAZ files of one point format keep every attribute if the output is LAS or LAZ.</source>
        <translation>Punkte werden ausgelassen, bis keine zwei näher als der Punktabstand liegen. Der Abstand ist exakt, räumlich und gilt über Dateien hinweg. Aus mehreren Dateien wird eine. LAS- und LAZ-Dateien eines Punktformats behalten alle Attribute, wenn die Ausgabe LAS oder LAZ ist.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Thinned cloud</source>
        <translation>Ausgedünnte Punktwolke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>%1, by extension.</source>
        <translation>%1, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Number of points in the clouds</source>
        <translation>Anzahl der Punkte in den Punktwolken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Number of points after thinning</source>
        <translation>Anzahl der Punkte nach dem Ausdünnen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points: %1 read, %2 kept.</source>
        <translation>Punkte: %1 gelesen, %2 behalten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Transform laser scans</source>
        <translation>Laserscans transformieren</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Moves each scan to the control points by the transformation that registerscans found for it.</source>
        <translation>Bringt jeden Scan mit der Transformation, die registerscans dafür gefunden hat, auf die Passpunkte.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Each cloud is moved by the transformation of the scan with the same name, and written to the folder under that name, to a tenth of a millimetre. It keeps all attributes, its normals are rotated, and it gets the coordinate reference system of the control points.</source>
        <translation>Jede Punktwolke wird mit der Transformation des gleichnamigen Scans bewegt und unter diesem Namen in den Ordner geschrieben, auf ein Zehntel Millimeter genau. Sie behält alle Attribute, ihre Normalen werden gedreht, und sie erhält das Koordinatenbezugssystem der Passpunkte.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>The json file that registerscans writes, or your own with the name and matrix of each scan.</source>
        <translation>Die JSON-Datei, die registerscans schreibt, oder eine eigene mit Name und Matrix jedes Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Transformed clouds</source>
        <translation>Transformierte Punktwolken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Folder for one cloud per scan. LAS, LAZ and text keep their format; all others become LAZ.</source>
        <translation>Ordner für eine Punktwolke je Scan. LAS, LAZ und Text behalten ihr Format; alle anderen werden LAZ.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Number of scans that were transformed</source>
        <translation>Anzahl der transformierten Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>%1 states no coordinate reference system, so the results have none either.</source>
        <translation>%1 nennt kein Koordinatenbezugssystem, daher haben auch die Ergebnisse keines.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>%1: %2 points, moved as the scan %3.</source>
        <translation>%1: %2 Punkte, bewegt wie der Scan %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>The Python %1 of QGIS lacks %2; %3, then start QGIS again.</source>
        <translation>Dem Python %1 von QGIS fehlt %2; %3, dann QGIS neu starten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>A package of the Python %1 of QGIS cannot be loaded (%2); install a version of it that fits the others.</source>
        <translation>Ein Paket des Python %1 von QGIS kann nicht geladen werden (%2); eine Version davon installieren, die zu den anderen passt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>run `%1`</source>
        <translation>`%1` ausführen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>in the OSGeo4W Shell</source>
        <translation>in der OSGeo4W-Shell</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>run `%1 -m pip install --user %2`%3</source>
        <translation>`%1 -m pip install --user %2`%3 ausführen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>add %1 with the OSGeo4W installer</source>
        <translation>%1 mit dem OSGeo4W-Installer hinzufügen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>install %1 from the source of QGIS, not by pip</source>
        <translation>%1 aus der Quelle von QGIS installieren, nicht mit pip</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Thickness (m)</source>
        <translation>Dicke (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the thickness (m)</source>
        <translation>Standardabweichung der Dicke (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Base (m)</source>
        <translation>Unterkante (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Top (m)</source>
        <translation>Oberkante (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Azimuth (°)</source>
        <translation>Azimut (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Radius (m)</source>
        <translation>Radius (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Density (standard deviations)</source>
        <translation>Dichte (Standardabweichungen)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Share of the outline with points</source>
        <translation>Anteil des Umrisses mit Punkten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Distance of the points, rms (m)</source>
        <translation>Abstand der Punkte, RMS (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number of thresholds</source>
        <translation>Anzahl der Schwellen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Connected body</source>
        <translation>Zusammenhängender Körper</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Perimeter (m)</source>
        <translation>Umfang (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Openings</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Floor (m)</source>
        <translation>Fußboden (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Ceiling (m)</source>
        <translation>Decke (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Share of the border that was seen</source>
        <translation>Gesehener Anteil des Randes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Boundary of</source>
        <translation>Begrenzung von</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Median offset (m)</source>
        <translation>Median des Versatzes (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Largest offset (m)</source>
        <translation>Größter Versatz (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Head</source>
        <translation>Sturzform</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Measured sides</source>
        <translation>Gemessene Seiten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Completed sides</source>
        <translation>Ergänzte Seiten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Open sides</source>
        <translation>Offene Seiten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Depth of the wall (m)</source>
        <translation>Wandtiefe (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the width (m)</source>
        <translation>Standardabweichung der Breite (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the height (m)</source>
        <translation>Standardabweichung der Höhe (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, left (m)</source>
        <translation>Standardabweichung links (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, right (m)</source>
        <translation>Standardabweichung rechts (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, bottom (m)</source>
        <translation>Standardabweichung unten (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, top (m)</source>
        <translation>Standardabweichung oben (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Depth behind the wall (m)</source>
        <translation>Tiefe hinter der Wand (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Red (0 to 255)</source>
        <translation>Rot (0 bis 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Green (0 to 255)</source>
        <translation>Grün (0 bis 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Blue (0 to 255)</source>
        <translation>Blau (0 bis 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, x (m)</source>
        <translation>Ursprung, x (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, y (m)</source>
        <translation>Ursprung, y (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, z (m)</source>
        <translation>Ursprung, z (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Tilt (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Normal, x</source>
        <translation>Normale, x</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Normal, y</source>
        <translation>Normale, y</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Normal, z</source>
        <translation>Normale, z</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Distance from the origin (m)</source>
        <translation>Abstand vom Ursprung (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/styles/targets.qml"/>
        <source>Target</source>
        <translation>Zielmarke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Control point</source>
        <translation>Passpunkt</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Surveyed (1 yes)</source>
        <translation>Eingemessen (1 ja)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Used (1 yes)</source>
        <translation>Verwendet (1 ja)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Residual (m)</source>
        <translation>Restklaffung (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Residual, %1 (m)</source>
        <translation>Restklaffung, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Redundancy, %1</source>
        <translation>Redundanzanteil, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Baarda&#x27;s w, %1</source>
        <translation>w nach Baarda, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Pope&#x27;s t, %1</source>
        <translation>t nach Pope, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Minimal detectable bias, %1 (m)</source>
        <translation>Kleinster aufdeckbarer Fehler, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Confidence ellipsoid, semi-axis %1 (m)</source>
        <translation>Konfidenzellipsoid, Halbachse %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Size (m)</source>
        <translation>Größe (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation in space (m)</source>
        <translation>Standardabweichung im Raum (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Distance from the scanner (m)</source>
        <translation>Entfernung vom Scanner (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Angle of incidence (°)</source>
        <translation>Auftreffwinkel (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Quality (0 to 1)</source>
        <translation>Qualität (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Doubtful (1 yes)</source>
        <translation>Zweifelhaft (1 ja)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Reason of the doubt</source>
        <translation>Grund des Zweifels</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, %1 (m)</source>
        <translation>Standardabweichung, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Correlation, %1 and %2</source>
        <translation>Korrelation, %1 und %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number of scans</source>
        <translation>Anzahl der Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Seen by</source>
        <translation>Gesehen von</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>Targets found in %1 have no names; set MATCHING to distances, or choose a list.</source>
        <translation>In %1 gefundene Zielmarken haben keine Namen; MATCHING auf Strecken setzen oder eine Liste wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>Searching %1 scans for targets, because they have no lists.</source>
        <translation>%1 Scans werden nach Zielmarken durchsucht, weil sie keine Listen haben.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>No target was found in the scans; the log says which tests failed, and how near. Pick the targets, or try &#x27;Find targets in scans&#x27; with the size of the targets.</source>
        <translation>In den Scans wurde keine Zielmarke gefunden; das Protokoll sagt, welche Kriterien nicht erfüllt waren und wie knapp. Die Zielmarken von Hand messen oder „Zielmarken in Scans finden“ mit der Größe der Zielmarken versuchen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>TARGETS has a list and a scan called %1; remove one of them.</source>
        <translation>TARGETS enthält eine Liste und einen Scan namens %1; eines davon entfernen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>%1: %2 targets, %3 doubtful.</source>
        <translation>%1: %2 Zielmarken, %3 zweifelhaft.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>The %1 target at %2 in %3</source>
        <translation>Die Zielmarke (%1) bei %2 in %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>%1 is doubtful: %2.</source>
        <translation>%1 ist zweifelhaft: %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/help.py"/>
        <source>Advanced parameters</source>
        <translation>Erweiterte Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/help.py"/>
        <location filename="../../processing_provider/model.py"/>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
    <message>
        <location filename="../../processing_provider/interruption.py"/>
        <source>The first run on this computer compiles its kernels, which takes up to a minute.</source>
        <translation>Der erste Lauf auf diesem Rechner kompiliert die Rechenkerne; das dauert bis zu einer Minute.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/composition.py"/>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/export.py"/>
        <source>%1 cannot be written; choose another name or folder.</source>
        <translation>%1 kann nicht geschrieben werden; einen anderen Namen oder Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/sheet.py"/>
        <source>At 1:%1 the drawing needs %2 x %3 mm, and %4 has %5 x %6 mm for it; choose a larger SHEET or SCALE.</source>
        <translation>Bei 1:%1 braucht die Zeichnung %2 x %3 mm, und auf %4 stehen dafür %5 x %6 mm zur Verfügung; SHEET oder SCALE größer wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Register scans to control points…</source>
        <translation>Scans auf Passpunkte registrieren…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Site plan from laser scans…</source>
        <translation>Grundriss aus Laserscans…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Details of a facade…</source>
        <translation>Details einer Fassade…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Example data…</source>
        <translation>Beispieldaten…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Report of the site plan</source>
        <translation>Bericht über den Grundriss</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets are found in the scans, or read from lists. Scans are registered by them, transformed to the control points, and drawn as a site plan.</source>
        <translation>Zielmarken werden in den Scans gefunden oder aus Listen gelesen. Damit werden die Scans registriert, auf die Passpunkte transformiert und als Grundriss gezeichnet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z.</source>
        <translation>Eingemessene Punkte in Metern: eine Textdatei mit x y z oder Name x y z.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>One point cloud for each scan, in the scanner&#x27;s own frame.</source>
        <translation>Eine Punktwolke je Scan, im eigenen System des Scanners.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Such as EPSG:25833. Without it, the plan has no reference system.</source>
        <translation>Zum Beispiel EPSG:25833. Ohne diese Angabe hat der Plan kein Bezugssystem.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets picked in the scans: text files with the names of the scans. In a scan without a list, black and white targets and spheres are found.</source>
        <translation>In den Scans gemessene Zielmarken: Textdateien mit den Namen der Scans. In einem Scan ohne Liste werden Schwarz-Weiß-Zielmarken und Kugeln gefunden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Control points and scans to site plan</source>
        <translation>Von Passpunkten und Scans zum Grundriss</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Scans; a scan has the name of its list</source>
        <translation>Scans; ein Scan heißt wie seine Liste</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Reference system of the control points</source>
        <translation>Bezugssystem der Passpunkte</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets, one list for each scan; found in scans without a list</source>
        <translation>Zielmarken, eine Liste je Scan; in Scans ohne Liste werden sie gesucht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>The details of a facade are measured, drawn, listed, and laid out on a sheet at 1:50.</source>
        <translation>Die Details einer Fassade werden gemessen, gezeichnet, aufgelistet und auf einem Blatt im Maßstab 1:50 dargestellt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>One or more point clouds of one facade, with colours or intensities.</source>
        <translation>Eine oder mehrere Punktwolken einer Fassade, mit Farben oder Intensitäten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Facade to drawing</source>
        <translation>Von der Fassade zur Zeichnung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Scans of the facade</source>
        <translation>Scans der Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Rooms of the lower storey</source>
        <translation>Räume des unteren Geschosses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Walls of the lower storey</source>
        <translation>Wände des unteren Geschosses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Rooms of the upper storey</source>
        <translation>Räume des oberen Geschosses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Walls of the upper storey</source>
        <translation>Wände des oberen Geschosses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Two storeys of a building are drawn from the same scans, each between the slabs around it.</source>
        <translation>Zwei Geschosse eines Gebäudes werden aus denselben Scans gezeichnet, jedes zwischen den Geschossdecken darunter und darüber.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>One or more point clouds of one building, in one reference system.</source>
        <translation>Eine oder mehrere Punktwolken eines Gebäudes, in einem Bezugssystem.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>In the coordinates of the scans: between the ceiling below the slab and the floor above it.</source>
        <translation>In den Koordinaten der Scans: zwischen der Raumdecke unter der Geschossdecke und dem Fußboden darüber.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Storeys one by one</source>
        <translation>Geschoss für Geschoss</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab below the lower storey (m)</source>
        <translation>Höhe in der Geschossdecke unter dem unteren Geschoss (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab between the storeys (m)</source>
        <translation>Höhe in der Geschossdecke zwischen den Geschossen (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab above the upper storey (m)</source>
        <translation>Höhe in der Geschossdecke über dem oberen Geschoss (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Point clouds</source>
        <translation>Punktwolken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>One or more scans of one site: %1; or a folder of them. On the command line, repeat INPUT=file or separate the files by semicolons.</source>
        <translation>Ein oder mehrere Scans eines Objekts: %1; oder ein Ordner davon. Auf der Kommandozeile INPUT=Datei wiederholen oder die Dateien durch Semikolons trennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Point spacing</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Points closer than this to a point that is kept are left out, so that a surface counts the same near the scanner and far from it. 0.05 m suits most sites; a finer spacing needs denser scans.</source>
        <translation>Punkte, die näher an einem behaltenen Punkt liegen, werden ausgelassen, sodass eine Fläche nahe am Scanner ebenso zählt wie weit davon. 0.05 m passt für die meisten Objekte; ein kleinerer Abstand braucht dichtere Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Pixel size</source>
        <translation>Pixelgröße</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Edge of a pixel of the rasters. 0.10 m suits most sites; it should be about twice the point spacing.</source>
        <translation>Kantenlänge eines Pixels der Raster. 0.10 m passt für die meisten Objekte; sie soll etwa das Doppelte des Punktabstands sein.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Coordinate reference system, if the clouds name none</source>
        <translation>Koordinatenbezugssystem, wenn die Punktwolken keines nennen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Projected, in metres. Used only for files without a reference system.</source>
        <translation>Projiziert, in Metern. Nur für Dateien ohne Bezugssystem verwendet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Dask scheduler</source>
        <translation>Dask-Scheduler</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Address of the scheduler of a Dask cluster, like tcp://192.168.0.10:8786. Its workers read the clouds and work on them instead of this computer, with the same result; they must find the files by the same paths. Leave it empty to work on this computer.</source>
        <translation>Adresse des Schedulers eines Dask-Clusters, wie tcp://192.168.0.10:8786. Dessen Worker lesen und bearbeiten die Punktwolken anstelle dieses Rechners, mit demselben Ergebnis; sie müssen die Dateien unter denselben Pfaden finden. Leer lassen, um auf diesem Rechner zu arbeiten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Neighbourhood</source>
        <translation>Nachbarschaft</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>A point spreads over the pixels up to this far from its own, by inverse distance. 0 counts points per pixel; more than 1 blurs.</source>
        <translation>Ein Punkt verteilt sich auf die Pixel bis zu dieser Entfernung von seinem eigenen, nach inversem Abstand. 0 zählt Punkte je Pixel; mehr als 1 macht unscharf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/definitions.py"/>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Lowest height</source>
        <translation>Niedrigste Höhe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points below are left out. For a storey, a height within the slab below its floor.</source>
        <translation>Punkte darunter werden ausgelassen. Für ein Geschoss eine Höhe in der Geschossdecke unter seinem Fußboden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Highest height</source>
        <translation>Höchste Höhe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points from this height on are left out. For a storey, a height within the slab above it.</source>
        <translation>Punkte ab dieser Höhe werden ausgelassen. Für ein Geschoss eine Höhe in der Geschossdecke darüber.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Heights are counted from</source>
        <translation>Höhen zählen ab</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>What ZMIN and ZMAX are counted from. Choose the local ground on a slope.</source>
        <translation>Ab wo ZMIN und ZMAX zählen. An einem Hang das örtliche Gelände wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>zero of the coordinates</source>
        <translation>Nullpunkt der Koordinaten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>local ground</source>
        <translation>örtliches Gelände</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>GeoTIFF with the bands density, occupied height, base, top, ground, spread and hanging height.</source>
        <translation>GeoTIFF mit den Bändern Dichte, belegte Höhe, Unterkante, Oberkante, Gelände, Streuung und hängende Höhe.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Density image: %1 x %2 pixels of %3 m.</source>
        <translation>Dichtebild: %1 x %2 Pixel von %3 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>, in lower case</source>
        <translation>, in Kleinbuchstaben</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written; end the name in %3%4.</source>
        <translation>%1 %2 kann nicht geschrieben werden; den Namen auf %3 enden lassen%4.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written; choose another name or folder.</source>
        <translation>%1 %2 kann nicht geschrieben werden; einen anderen Namen oder Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written because the folder %3 does not exist; create it first.</source>
        <translation>%1 %2 kann nicht geschrieben werden, weil es den Ordner %3 nicht gibt; ihn zuerst anlegen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 is empty; choose a file to write.</source>
        <translation>%1 ist leer; eine zu schreibende Datei wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 files (*%2)</source>
        <translation>%1-Dateien (*%2)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>JSON files (*.json)</source>
        <translation>JSON-Dateien (*.json)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>DXF files (*.dxf)</source>
        <translation>DXF-Dateien (*.dxf)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>SVG files (*.svg)</source>
        <translation>SVG-Dateien (*.svg)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>HTML files (*.html *.htm)</source>
        <translation>HTML-Dateien (*.html *.htm)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>an input</source>
        <translation>eine Eingabe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 is %3 as well; choose another name.</source>
        <translation>%1 %2 ist zugleich %3; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <location filename="../../processing_provider/parameters/map_layers.py"/>
        <source>%1 %2 cannot be read; choose another layer.</source>
        <translation>%1 %2 kann nicht gelesen werden; einen anderen Layer wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has a shape that cannot be read (%2); correct or remove it.</source>
        <translation>%1 enthält ein Objekt, das nicht gelesen werden kann (%2); es berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has a shape whose coordinates are not numbers; correct or remove it.</source>
        <translation>%1 hat eine Form, deren Koordinaten keine Zahlen sind; sie berichtigen oder entfernen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has no lines or polygons; draw one, or leave it empty.</source>
        <translation>%1 enthält keine Linien oder Polygone; eines zeichnen oder das Feld leer lassen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Distance from a plane</source>
        <translation>Abstand von einer Ebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of a point from its plane (ds of the paper). Points further behind the wall belong to an opening or a recess, points further in front of it to a projection. Decrease it for shallow recesses, increase it for rough or bulging walls.</source>
        <translation>Größter Abstand eines Punktes von seiner Ebene (ds des Artikels). Punkte weiter hinter der Wand gehören zu einer Öffnung oder einem Rücksprung, Punkte weiter davor zu einem Vorsprung. Für flache Rücksprünge verringern, für raue oder ausbauchende Wände erhöhen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Number of the facade</source>
        <translation>Nummer der Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Which facade of a building or a street is measured. 0 takes the one that most points see from the stations, or that most points lie on if no position of a scanner is known. The report lists all with their numbers.</source>
        <translation>Welche Fassade eines Gebäudes oder einer Straße gemessen wird. 0 nimmt die, deren meiste Punkte von den Standpunkten gesehen werden, oder die mit den meisten Punkten, wenn kein Standpunkt bekannt ist. Der Bericht führt alle mit ihren Nummern auf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0: the one most seen</source>
        <translation>0: die am meisten gesehene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Point near the facade</source>
        <translation>Punkt nahe der Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Measures the facade nearest to this point, in the coordinates of the cloud; FACADE is then ignored.</source>
        <translation>Misst die diesem Punkt nächste Fassade, in den Koordinaten der Punktwolke; FACADE wird dann nicht beachtet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Lines or walls along the facade</source>
        <translation>Linien oder Wände entlang der Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Measures the facade along a line that is drawn near to it, or along a wall of a plan, for example of siteplan, in the coordinates of the cloud. Of several, selected features only if you choose so, the facade that the most runs along. A folder of every facade then has those along the lines: a polygon of a building chooses its facades among those of a street. FACADE and FACADE_NEAR choose among all.</source>
        <translation>Misst die Fassade entlang einer nahe davor gezeichneten Linie oder entlang einer Wand eines Plans, zum Beispiel von siteplan, in den Koordinaten der Punktwolke. Bei mehreren, auf Wunsch nur gewählten Objekten die Fassade, an der die größte Länge verläuft. Ein Ordner aller Fassaden enthält dann die entlang der Linien: Das Polygon eines Gebäudes wählt dessen Fassaden unter denen einer Straße. FACADE und FACADE_NEAR wählen unter allen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Side of the facade</source>
        <translation>Seite der Fassade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>The side from which the facade is seen; seen from the other side, an elevation is mirrored. Automatic uses the position of the scanner where the files state it, otherwise what is seen through the openings. The log says which side was taken, why, and how certain that is. In a folder of every facade, it applies to the chosen one; the side of the others is found.</source>
        <translation>Die Seite, von der die Fassade gesehen wird; von der anderen Seite ist eine Ansicht gespiegelt. Automatisch verwendet die Position des Scanners, wo die Dateien sie nennen, sonst das, was durch die Öffnungen zu sehen ist. Das Protokoll sagt, welche Seite genommen wurde, warum und wie sicher das ist. In einem Ordner aller Fassaden gilt sie für die gewählte; die Seite der übrigen wird gefunden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facing east (azimuth 0 to 180)</source>
        <translation>Nach Osten (Azimut 0 bis 180)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facing west (azimuth 180 to 360)</source>
        <translation>Nach Westen (Azimut 180 bis 360)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Points of the smallest plane</source>
        <translation>Punkte der kleinsten Ebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Planes with fewer points are left out. If not set: 1 % of the points of the main plane, at least 100.</source>
        <translation>Ebenen mit weniger Punkten werden ausgelassen. Wenn leer: 1 % der Punkte der Hauptebene, mindestens 100.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest number of planes</source>
        <translation>Größte Anzahl von Ebenen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Includes the main plane. Of the others, the largest are kept.</source>
        <translation>Einschließlich der Hauptebene. Von den übrigen werden die größten behalten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Radius of a seed surface</source>
        <translation>Radius einer Keimfläche</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A region of one colour starts from a surface of this radius (td of the paper), or of half or a quarter of it on small details.</source>
        <translation>Eine Region einer Farbe beginnt mit einer Fläche dieses Radius (td des Artikels), bei kleinen Details mit der Hälfte oder einem Viertel davon.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour distance of a seed</source>
        <translation>Farbabstand eines Keims</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of the colour of a seed from the mean of its surface (tr of the paper).</source>
        <translation>Größter Abstand der Farbe eines Keims vom Mittel seiner Fläche (tr des Artikels).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0 to 255</source>
        <translation>0 bis 255</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour variance of a seed surface</source>
        <translation>Farbvarianz einer Keimfläche</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest sum of the variances of red, green and blue in a seed surface (Vr of the paper). If not set: 200 as in the paper, or twice the measured colour noise, if larger.</source>
        <translation>Größte Summe der Varianzen von Rot, Grün und Blau in einer Keimfläche (Vr des Artikels). Wenn leer: 200 wie im Artikel oder das Doppelte des gemessenen Farbrauschens, wenn es größer ist.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0 to 255, squared</source>
        <translation>0 bis 255, quadriert</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour distance of a region</source>
        <translation>Farbabstand einer Region</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of the colour of a point from the mean of the region that it joins (tr2 of the paper). Decrease it to separate similar colours.</source>
        <translation>Größter Abstand der Farbe eines Punktes vom Mittel der Region, der er zugeschlagen wird (tr2 des Artikels). Verringern, um ähnliche Farben zu trennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Intensity difference of surfaces</source>
        <translation>Intensitätsunterschied von Flächen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Regions whose mean intensities differ by less are one surface (f of the paper), so that shadows do not become details. A share of the intensity of the wall. If not set: twice the measured intensity noise.</source>
        <translation>Regionen, deren mittlere Intensitäten sich um weniger unterscheiden, sind eine Fläche (f des Artikels), sodass Schatten nicht zu Details werden. Ein Anteil der Intensität der Wand. Wenn leer: das Doppelte des gemessenen Intensitätsrauschens.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Large triangles</source>
        <translation>Große Dreiecke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A triangle between points of a plane is large if its area exceeds the mean by this factor (delta of the paper).</source>
        <translation>Ein Dreieck zwischen Punkten einer Ebene ist groß, wenn seine Fläche das Mittel um diesen Faktor übersteigt (Delta des Artikels).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>mean areas</source>
        <translation>mittlere Flächen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Large triangles of a point</source>
        <translation>Große Dreiecke eines Punktes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A point that belongs to more large triangles is noise (eta of the paper).</source>
        <translation>Ein Punkt, der zu mehr großen Dreiecken gehört, ist Rauschen (Eta des Artikels).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Rounds of noise removal</source>
        <translation>Durchgänge der Rauschentfernung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest number of rounds; they end when no noise is left. 0 keeps all points.</source>
        <translation>Größte Anzahl von Durchgängen; sie enden, wenn kein Rauschen mehr da ist. 0 behält alle Punkte.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>rounds</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Alpha of the outline</source>
        <translation>Alpha des Umrisses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Alpha-shape radius. Smaller keeps finer gaps, larger closes frayed outlines. If not set, it follows the spacing of the points.</source>
        <translation>Radius der Alpha-Form. Kleiner behält feinere Lücken, größer schließt ausgefranste Umrisse. Wenn leer, folgt er dem Punktabstand.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Area of the smallest detail</source>
        <translation>Fläche des kleinsten Details</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Smaller details are left out. If not set: the square of SEED_RADIUS.</source>
        <translation>Kleinere Details werden ausgelassen. Wenn leer: das Quadrat von SEED_RADIUS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Rectangles and arches</source>
        <translation>Rechtecke und Bögen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Outlines become level and plumb rectangles, arches or circles where the points agree with such a shape. All other outlines follow the points. If off, all outlines follow the points.</source>
        <translation>Umrisse werden zu waagrechten und lotrechten Rechtecken, Bögen oder Kreisen, wo die Punkte zu einer solchen Form passen. Alle anderen Umrisse folgen den Punkten. Ausgeschaltet folgen alle Umrisse den Punkten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facades that turn</source>
        <translation>Abgewinkelte und runde Fassaden</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A flat facade has one plane. Sides: the sides of a canted bay or a polygonal tower that meet at the facade are drawn beside each other, each in its own plane. Round: a round tower is rolled out, so that u runs along the arc of its outer face; the log states the radius. In a folder of every facade, those that do not turn are drawn flat.</source>
        <translation>Eine ebene Fassade hat eine Ebene. Seiten: Die Seiten eines abgeschrägten Erkers oder eines polygonalen Turms, die an der Fassade aneinanderstoßen, werden nebeneinander gezeichnet, jede in ihrer eigenen Ebene. Rund: Ein runder Turm wird abgewickelt, sodass u entlang des Bogens seiner Außenfläche verläuft; das Protokoll nennt den Radius. In einem Ordner mit allen Fassaden werden Fassaden ohne Knick und Rundung eben gezeichnet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Flat</source>
        <translation>Eben</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Sides of a bay or a tower</source>
        <translation>Seiten eines Erkers oder Turms</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Round tower</source>
        <translation>Runder Turm</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Coloured details</source>
        <translation>Farbige Details</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Which regions of another colour become details. Those with a clear step: they are regular, and their colour changes sharply along the border, which the intensity confirms if there is one; stains, joints, shadows and lamplight are left out, and LEFT_OUT shows them. All regions: the chain of the paper, together with REGULARISE off. None: faster.</source>
        <translation>Welche Regionen einer anderen Farbe zu Details werden. Die mit klarem Sprung: Sie sind regelmäßig, und ihre Farbe ändert sich am Rand scharf, was die Intensität bestätigt, wenn es eine gibt; Flecken, Fugen, Schatten und Lampenlicht werden ausgelassen, und LEFT_OUT zeigt sie. Alle Regionen: die Kette des Artikels, zusammen mit ausgeschaltetem REGULARISE. Keine: schneller.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Those with a clear step</source>
        <translation>Die mit klarem Sprung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>All regions</source>
        <translation>Alle Regionen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Pixel size of the orthoimage</source>
        <translation>Pixelgröße des Orthobilds</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>If not set: the spacing of the points, rounded up to 1, 2 or 5 times a power of ten.</source>
        <translation>Wenn leer: der Punktabstand, aufgerundet auf das 1-, 2- oder 5-Fache einer Zehnerpotenz.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Fill holes of the orthoimage</source>
        <translation>Löcher des Orthobilds füllen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Pixels without points take the colour of the nearest pixel with points. If off, they are transparent.</source>
        <translation>Pixel ohne Punkte nehmen die Farbe des nächsten Pixels mit Punkten an. Ausgeschaltet sind sie durchsichtig.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade_files.py"/>
        <source>Folder of every facade</source>
        <translation>Ordner aller Fassaden</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade_files.py"/>
        <source>Draws every facade of the cloud, or those along FACADE_ALONG, each into a folder of its own by its number: elevation, orthoimage, details in space, what is left out, report, and drawing if ezdxf is installed. One schedule lists the details of all. Takes as long for each facade as for one.</source>
        <translation>Zeichnet jede Fassade der Punktwolke, oder die entlang FACADE_ALONG, in einen eigenen, nach ihrer Nummer benannten Ordner: Ansicht, Orthobild, Details im Raum, Ausgelassenes, Bericht und, wenn ezdxf installiert ist, Zeichnung. Eine Maßliste führt die Details aller auf. Braucht für jede Fassade so lange wie für eine.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>Point clouds (%1)</source>
        <translation>Punktwolken (%1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose at least one point cloud file.</source>
        <translation>%1 ist leer; mindestens eine Punktwolkendatei wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose a raster.</source>
        <translation>%1 ist leer; ein Raster wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 files (*.%2);;All files (*)</source>
        <translation>%1-Dateien (*.%2);;Alle Dateien (*)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose a %2 file.</source>
        <translation>%1 ist leer; eine %2-Datei wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1, one by one</source>
        <translation>%1, einzeln</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1 %2 still holds %3 of an earlier run; this one did not write it. Remove it, or choose a new folder.</source>
        <translation>%1 %2 enthält noch %3 aus einem früheren Lauf; dieser hat das nicht geschrieben. Entfernen oder einen neuen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1 %2 cannot be written to; choose another folder.</source>
        <translation>In %1 %2 kann nicht geschrieben werden; einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/map_layers.py"/>
        <source>%1 is empty; choose a layer.</source>
        <translation>%1 ist leer; einen Layer wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1 %2 cannot be read</source>
        <translation>%1 %2 kann nicht gelesen werden</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1 is empty</source>
        <translation>%1 ist leer</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1; choose a layer of polygons.</source>
        <translation>%1; einen Polygonlayer wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default %2; %3.</source>
        <translation>%1 Vorgabe %2; %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be a %2, %3 (%4), not %5.</source>
        <translation>%1 muss eine %2 sein, %3 (%4), nicht %5.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 %2. Default 0.</source>
        <translation>%1 %2. Vorgabe 0.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be %2, not %3.</source>
        <translation>%1 muss %2 sein, nicht %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default yes.</source>
        <translation>%1 Vorgabe ja.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default no.</source>
        <translation>%1 Vorgabe nein.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 muss true oder false sein, nicht %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be a point like 412345.6,5812345.7, not %2.</source>
        <translation>%1 muss ein Punkt wie 412345.6,5812345.7 sein, nicht %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be three numbers, x y z in metres, not %2.</source>
        <translation>%1 muss aus drei Zahlen bestehen, x y z in Metern, nicht %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 %2 is not known; write it like EPSG:25832.</source>
        <translation>%1 %2 ist nicht bekannt; in der Form EPSG:25832 schreiben.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>Lists of points (*.txt *.csv *.xyz *.asc *.pts *.gpkg *.shp *.geojson)</source>
        <translation>Punktlisten (*.txt *.csv *.xyz *.asc *.pts *.gpkg *.shp *.geojson)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 is empty; choose a text file or a layer of points.</source>
        <translation>%1 ist leer; eine Textdatei oder einen Punktlayer wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 takes one list of points, not %2; choose one.</source>
        <translation>%1 nimmt eine Punktliste, nicht %2; eine wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 has two lists called %2; remove or rename one of them.</source>
        <translation>%1 hat zwei Listen namens %2; eine davon entfernen oder umbenennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 is not a layer of points; choose another.</source>
        <translation>%1 ist kein Punktlayer; einen anderen wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>The file of the layer %1 is missing; repair the layer or choose another.</source>
        <translation>Die Datei des Layers %1 fehlt; den Layer reparieren oder einen anderen wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>the layer %1</source>
        <translation>der Layer %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights.</source>
        <translation>Eingemessene Punkte in Metern: eine Textdatei mit x y z oder Name x y z, oder ein Punktlayer mit Höhen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights. May be empty if REFINE is set and no scan has targets: surfaces then place the scans beside the first one.</source>
        <translation>Eingemessene Punkte in Metern: eine Textdatei mit x y z oder name x y z, oder ein Punktlayer mit Höhen. Kann leer bleiben, wenn REFINE gesetzt ist und kein Scan Zielmarken hat: dann setzen Flächen die Scans neben den ersten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Targets, one list for each scan, or the scans</source>
        <translation>Zielmarken, eine Liste je Scan, oder die Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Targets picked in the scans, in the scanner&#x27;s own frame: text files or layers as for control points. The name of the file is the name of the scan; give the cloud the same name. Scans themselves may be given instead, or a folder of them: their targets are found on the way, unless there is a list of the same name. On the command line, repeat TARGETS=file or separate the files by semicolons.</source>
        <translation>In den Scans gemessene Zielmarken im System des Scanners: Textdateien oder Layer wie für Passpunkte. Der Name der Datei ist der Name des Scans; der Punktwolke denselben Namen geben. Stattdessen können die Scans selbst angegeben werden oder ein Ordner davon: Ihre Zielmarken werden unterwegs gefunden, wenn es keine gleichnamige Liste gibt. Auf der Kommandozeile TARGETS=Datei wiederholen oder die Dateien durch Semikolons trennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Matching</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>How targets are matched with control points. By distances, no names are needed. By names, the distances reveal wrong names.</source>
        <translation>Wie Zielmarken den Passpunkten zugeordnet werden. Nach Strecken sind keine Namen nötig. Nach Namen zeigen die Strecken falsche Namen auf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>By distances</source>
        <translation>Nach Strecken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>By names</source>
        <translation>Nach Namen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Standard deviation of a target</source>
        <translation>Standardabweichung einer Zielmarke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Of each coordinate of a picked target, before the adjustment. The statistics test whether it is right. Targets with standard deviations of their own, as &#x27;Find targets in scans&#x27; writes them, are adjusted with these; SIGMA then says only how exactly distances match.</source>
        <translation>Jeder Koordinate einer gemessenen Zielmarke, vor der Ausgleichung. Die Statistik prüft, ob sie stimmt. Zielmarken mit eigenen Standardabweichungen, wie „Zielmarken in Scans finden“ sie schreibt, werden mit diesen ausgeglichen; SIGMA sagt dann nur, wie genau Strecken übereinstimmen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Standard deviation of a control point</source>
        <translation>Standardabweichung eines Passpunkts</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Of each coordinate of a surveyed point. 0 holds the surveyed points fixed; if targets have standard deviations of their own, 0 takes the one of targets without.</source>
        <translation>Jeder Koordinate eines eingemessenen Punktes. 0 hält die eingemessenen Punkte fest; haben Zielmarken eigene Standardabweichungen, nimmt 0 die der Zielmarken ohne eigene.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Tolerance of distances</source>
        <translation>Streckentoleranz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Largest difference between a distance of targets and the matching distance of control points. If not set, it is derived from the standard deviations and written to the log.</source>
        <translation>Größter Unterschied zwischen einer Strecke von Zielmarken und der passenden Strecke von Passpunkten. Wenn leer, wird er aus den Standardabweichungen abgeleitet und ins Protokoll geschrieben.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Largest standard deviation of a scan without a warning</source>
        <translation>Größte Standardabweichung eines Scans ohne Warnung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>A scan whose targets are less accurate after the adjustment is registered with a warning, as at the end of a chain of scans. If not set, it is ten times SIGMA.</source>
        <translation>Ein Scan, dessen Zielmarken nach der Ausgleichung ungenauer sind, wird mit einer Warnung registriert, etwa am Ende einer Kette von Scans. Wenn leer, das Zehnfache von SIGMA.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Transformation</source>
        <translation>Transformation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Which parameters are estimated. Choose levelled if the compensator of the scanner was on, and unknown scale for models that have none, for example from photographs.</source>
        <translation>Welche Parameter geschätzt werden. Horizontiert wählen, wenn der Kompensator des Scanners eingeschaltet war, und unbekannter Maßstab für Modelle ohne Maßstab, zum Beispiel aus Fotografien.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Rigid, 6 parameters</source>
        <translation>Starr, 6 Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>With a scale near 1, 7 parameters</source>
        <translation>Mit einem Maßstab nahe 1, 7 Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Levelled, 4 parameters</source>
        <translation>Horizontiert, 4 Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Levelled with a scale near 1, 5 parameters</source>
        <translation>Horizontiert, mit einem Maßstab nahe 1, 5 Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Unknown scale, 7 parameters</source>
        <translation>Unbekannter Maßstab, 7 Parameter</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Tie scans by the surfaces that they share</source>
        <translation>Scans durch gemeinsame Flächen verknüpfen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Walls, floors and other plane surfaces that two scans see tie the scans to each other, together with the targets and never against them. Scans with too few targets, or none, are placed by their surfaces if these show one pose only. Needs the clouds: in TARGETS or in SCANS.</source>
        <translation>Wände, Böden und andere ebene Flächen, die zwei Scans sehen, verknüpfen die Scans, zusammen mit den Zielmarken und nie gegen sie. Scans mit zu wenigen oder ohne Zielmarken werden durch ihre Flächen gesetzt, wenn diese nur eine Lage zeigen. Braucht die Punktwolken: in TARGETS oder in SCANS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Clouds of the scans, to tie them by surfaces</source>
        <translation>Punktwolken der Scans, um sie durch Flächen zu verknüpfen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>The clouds of scans whose targets are given as lists; each is named after its list. A cloud without a list is placed by its surfaces. Not needed for scans that are in TARGETS. Used only if scans are tied by surfaces.</source>
        <translation>Die Punktwolken von Scans, deren Zielmarken als Listen angegeben sind; jede heißt wie ihre Liste. Eine Punktwolke ohne Liste wird durch ihre Flächen gesetzt. Nicht nötig für Scans, die in TARGETS stehen. Nur verwendet, wenn Scans durch Flächen verknüpft werden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Coordinate reference system, if the control points have none</source>
        <translation>Koordinatenbezugssystem, wenn die Passpunkte keines haben</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Projected, in metres. Used only for control points without a reference system.</source>
        <translation>Projiziert, in Metern. Nur für Passpunkte ohne Bezugssystem verwendet.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>CONTROL is empty; choose a text file or a layer of points, or set REFINE to place clouds without targets by their surfaces.</source>
        <translation>CONTROL ist leer; eine Textdatei oder einen Punktlayer wählen, oder REFINE setzen, um Punktwolken ohne Zielmarken durch ihre Flächen zu setzen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>CONTROL is empty, but TARGETS has lists; choose the control points, or the list of one of the scans in their place.</source>
        <translation>CONTROL ist leer, aber TARGETS hat Listen; die Passpunkte wählen oder an ihrer Stelle die Liste eines der Scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Widest door of a room</source>
        <translation>Breiteste Tür eines Raumes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Gaps in walls up to this width are bridged for ROOMS. Leaves of doors are up to 1.25 m wide, and corridors seldom narrower than 1.3 m. Raise it for gates and broken walls.</source>
        <translation>Lücken in Wänden bis zu dieser Breite werden für ROOMS überbrückt. Türblätter sind bis 1.25 m breit und Flure selten schmaler als 1.3 m. Für Tore und unterbrochene Wände erhöhen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Plan of the storey under a ceiling</source>
        <translation>Plan des Geschosses unter einer Decke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Where a ceiling was seen, walls and rooms come from the faces and the floor of the storey, also behind furniture and across glazing. No uses the density image everywhere. Needs REFINE.</source>
        <translation>Wo eine Decke gesehen wurde, stammen Wände und Räume aus den Wandflächen und dem Fußboden des Geschosses, auch hinter Möbeln und durch Verglasung. Nein verwendet überall das Dichtebild. Braucht REFINE.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Height of the cut above the floor</source>
        <translation>Höhe des Schnitts über dem Fußboden</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Where a ceiling was seen, the plan shows what stands at this height above the floor. Faces are recognised over the full height of the storey.</source>
        <translation>Wo eine Decke gesehen wurde, zeigt der Plan, was in dieser Höhe über dem Fußboden steht. Wandflächen werden über die ganze Geschosshöhe erkannt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Centrelines of the walls that meet at junctions, with thickness, azimuth or radius. GeoPackage or shapefile, by extension.</source>
        <translation>Achsen der Wände, die sich an Knoten treffen, mit Dicke, Azimut oder Radius. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms between the faces of the walls, with area, perimeter, heights of floor and ceiling. GeoPackage or shapefile, by extension.</source>
        <translation>Räume zwischen den Wandflächen, mit Fläche, Umfang, Höhen von Fußboden und Decke. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Limits of the scan</source>
        <translation>Grenzen des Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Lines where a room ends without a wall, because the scan ends there. GeoPackage or shapefile, by extension.</source>
        <translation>Linien, an denen ein Raum ohne Wand endet, weil dort der Scan endet. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Surfaces left out</source>
        <translation>Ausgelassene Flächen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Upright surfaces in rooms that are not walls, with the reason: furniture, curtains, door leaves. GeoPackage or shapefile, by extension.</source>
        <translation>Lotrechte Flächen in Räumen, die keine Wände sind, mit dem Grund: Möbel, Vorhänge, Türblätter. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>HTML page that shows what each parameter did, and which to change; see the results viewer.</source>
        <translation>HTML-Seite, die zeigt, was jeder Parameter bewirkt hat und welcher zu ändern ist; siehe Ergebnisanzeige.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>DXF file in metres: walls, faces, axes, and rooms with names and areas, on layers; needs the package ezdxf.</source>
        <translation>DXF-Datei in Metern: Wände, Wandflächen, Achsen und Räume mit Namen und Flächen, auf Layern; benötigt das Paket ezdxf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Number of rooms, if ROOMS are made</source>
        <translation>Anzahl der Räume, wenn ROOMS erzeugt wird</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Area of the rooms (m²), if ROOMS are made</source>
        <translation>Fläche der Räume (m²), wenn ROOMS erzeugt wird</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>No ceiling was seen: the walls are those of the density image.</source>
        <translation>Keine Decke wurde gesehen: Die Wände sind die des Dichtebilds.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Axes: %1, %2 m long.</source>
        <translation>Achsen: %1, %2 m lang.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms: %1, %2 m².</source>
        <translation>Räume: %1, %2 m².</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Storey: floor at %1 m, ceiling at %2 m; points %3 cm apart, noise %4 mm. Borders of rooms without a wall: %5 m. Left out as furniture and the like: %6 m.</source>
        <translation>Geschoss: Fußboden bei %1 m, Decke bei %2 m; Punkte im Abstand von %3 cm, Rauschen %4 mm. Ränder von Räumen ohne Wand: %5 m. Als Möbel und dergleichen ausgelassen: %6 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Laser scans</source>
        <translation>Laserscans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>One or more scans, each of one station: %1; or a folder of them. E57 and PTX files may hold several. On the command line, repeat INPUT=file or separate the files by semicolons.</source>
        <translation>Ein oder mehrere Scans, jeder von einem Standpunkt: %1; oder ein Ordner davon. E57- und PTX-Dateien dürfen mehrere enthalten. Auf der Kommandozeile INPUT=Datei wiederholen oder die Dateien durch Semikolons trennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Kind of targets</source>
        <translation>Art der Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>What is searched for. Black and white targets need intensities.</source>
        <translation>Wonach gesucht wird. Schwarz-Weiß-Zielmarken brauchen Intensitäten.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Both</source>
        <translation>Beides</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Black and white</source>
        <translation>Schwarz-weiß</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Spheres</source>
        <translation>Kugeln</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Size of the targets</source>
        <translation>Größe der Zielmarken</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Width of the black and white pattern, or diameter of the spheres. If not set, patterns of 75 to 300 mm and spheres of 76, 100, 139, 145, 150 and 200 mm are found. Set it for other spheres, or where a diameter is doubtful.</source>
        <translation>Breite des Schwarz-Weiß-Musters oder Durchmesser der Kugeln. Wenn leer, werden Muster von 75 bis 300 mm und Kugeln von 76, 100, 139, 145, 150 und 200 mm gefunden. Für andere Kugeln setzen, oder wo ein Durchmesser zweifelhaft ist.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Position of the scanner</source>
        <translation>Position des Scanners</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Where the scanner stood, x y z in the coordinates of the scan. If not set, the position that E57 and PTX files state is used; other files are in the scanner&#x27;s own frame, with the scanner at the origin.</source>
        <translation>Wo der Scanner stand, x y z in den Koordinaten des Scans. Wenn leer, wird die Position verwendet, die E57- und PTX-Dateien nennen; andere Dateien sind im System des Scanners mit dem Scanner im Ursprung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>STATION belongs to one scan, and there are several; choose one, or leave it empty.</source>
        <translation>STATION gehört zu einem Scan, und es sind mehrere; einen wählen oder das Feld leer lassen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Lowest density threshold</source>
        <translation>Niedrigste Dichteschwelle</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Density from which a pixel may be wall. If not set, it is derived from the density of the horizontal surfaces and written to the log. Raise it if clutter is taken for walls.</source>
        <translation>Dichte, ab der ein Pixel Wand sein kann. Wenn leer, wird sie aus der Dichte der waagrechten Flächen abgeleitet und ins Protokoll geschrieben. Erhöhen, wenn Störobjekte für Wände gehalten werden.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Smallest region</source>
        <translation>Kleinste Region</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Regions with less area are dropped. If not set, it is the area of a metre of wall one pixel thick.</source>
        <translation>Regionen mit weniger Fläche entfallen. Wenn leer, die Fläche eines Meters Wand von einem Pixel Dicke.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Largest fill of connected or curved walls</source>
        <translation>Größte Füllung verbundener oder gekrümmter Wände</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>A region consists of connected or curved walls if its area divided by the area of its bounding box is not above this.</source>
        <translation>Eine Region besteht aus verbundenen oder gekrümmten Wänden, wenn ihre Fläche geteilt durch die ihres umschließenden Rechtecks nicht darüber liegt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Least elongation of a straight wall</source>
        <translation>Geringste Streckung einer geraden Wand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>A region is a straight wall if the major axis of its best-fit ellipse divided by the minor axis is not below this.</source>
        <translation>Eine Region ist eine gerade Wand, wenn die große Achse ihrer bestpassenden Ellipse geteilt durch die kleine nicht darunter liegt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Widest gap to close</source>
        <translation>Breiteste zu schließende Lücke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Joins the two faces of a wall and bridges interruptions. If not set, it is 0.8 m where the heights show the ground between walls, so that doors are kept open, and 0.4 m where they do not.</source>
        <translation>Verbindet die beiden Seiten einer Wand und überbrückt Unterbrechungen. Wenn leer, 0.8 m, wo die Höhen das Gelände zwischen Wänden zeigen, sodass Türen offen bleiben, und 0.4 m, wo nicht.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Least occupied height of a wall</source>
        <translation>Geringste belegte Höhe einer Wand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Height that the points of a pixel must fill between 0.3 and 2.3 m above the local ground. Removes floors and beams; also separates vegetation and furniture from walls. Lower it for low ruins; 0 uses density alone.</source>
        <translation>Höhe, die die Punkte eines Pixels zwischen 0.3 und 2.3 m über dem örtlichen Gelände füllen müssen. Entfernt Fußböden und Balken; trennt auch Bewuchs und Möbel von Wänden. Für niedrige Ruinen verringern; 0 verwendet nur die Dichte.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Number of density thresholds</source>
        <translation>Anzahl der Dichteschwellen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls are looked for at this many thresholds from the lowest to the highest, and combined.</source>
        <translation>Wände werden bei so vielen Schwellen von der niedrigsten bis zur höchsten gesucht und vereinigt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Highest density threshold</source>
        <translation>Höchste Dichteschwelle</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>If not set, it is the median density of the pixels that may be wall.</source>
        <translation>Wenn leer, der Median der Dichte der Pixel, die Wand sein können.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Number of walls</source>
        <translation>Anzahl der Wände</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Area of the walls (m²)</source>
        <translation>Grundfläche der Wände (m²)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Length of the walls (m)</source>
        <translation>Länge der Wände (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Polygons with kind, length, thickness, base and top height. GeoPackage or shapefile, by extension.</source>
        <translation>Polygone mit Art, Länge, Dicke, Unter- und Oberkante. GeoPackage oder Shapefile, je nach Endung.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Wall pixels as a GeoTIFF: 1 wall, 0 none.</source>
        <translation>Wandpixel als GeoTIFF: 1 Wand, 0 keine.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Plan raster</source>
        <translation>Plan als Raster</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Thresholds: %1 from %2 to %3 standard deviations.</source>
        <translation>Schwellen: %1 von %2 bis %3 Standardabweichungen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Smallest region: %1 m². Widest gap to close: %2 m.</source>
        <translation>Kleinste Region: %1 m². Breiteste zu schließende Lücke: %2 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls: %1, %2 m², %3 m long.</source>
        <translation>Wände: %1, %2 m², %3 m lang.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>No files chosen</source>
        <translation>Keine Dateien gewählt</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>1 file</source>
        <translation>1 Datei</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <location filename="../../processing_provider/provider.py"/>
        <source>Ichnograph: laser scans to site plans and elevations</source>
        <translation>Ichnograph: von Laserscans zu Grundrissen und Ansichten</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 and %2 have the same name; rename one of them.</source>
        <translation>%1 und %2 haben denselben Namen; eine davon umbenennen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs the clouds of the scans; choose them in SCANS.</source>
        <translation>REFINE braucht die Punktwolken der Scans; sie in SCANS wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs scans in metres, but with MODEL and MATCHING as chosen, their scale may be any; choose a MODEL without scale, or leave REFINE out.</source>
        <translation>REFINE braucht Scans in Metern, aber mit MODEL und MATCHING wie gewählt darf ihr Maßstab beliebig sein; ein MODEL ohne Maßstab wählen oder REFINE weglassen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>Finding the surfaces of %1</source>
        <translation>Flächen von %1 werden gesucht</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1: %2 plane cells.</source>
        <translation>%1: %2 ebene Zellen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 is not used to tie scans, because no list of targets has its name.</source>
        <translation>%1 wird nicht verwendet, um Scans zu verknüpfen, weil keine Liste von Zielmarken so heißt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 and %2 are both named after the list %3; choose one of them as its cloud.</source>
        <translation>%1 und %2 heißen beide wie die Liste %3; eine davon als ihre Punktwolke wählen.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 is not tied by surfaces, because no cloud has its name; its targets alone hold it.</source>
        <translation>%1 wird nicht durch Flächen verknüpft, weil keine Punktwolke so heißt; allein seine Zielmarken halten ihn.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs the clouds of at least two scans; choose them in SCANS, each named after its list.</source>
        <translation>REFINE braucht die Punktwolken von mindestens zwei Scans; sie in SCANS wählen, jede wie ihre Liste benannt.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/control_points.qml"/>
        <source>Surveyed</source>
        <translation>Eingemessen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/control_points.qml"/>
        <source>Appended from scans</source>
        <translation>Neupunkt aus Scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Recess</source>
        <translation>Rücksprung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Coloured detail</source>
        <translation>Farbiges Detail</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Projection</source>
        <translation>Vorsprung</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Not seen</source>
        <translation>Nicht gesehen</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Other</source>
        <translation>Sonstiges</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/facade_planes.qml"/>
        <source>Main plane</source>
        <translation>Hauptebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/facade_planes.qml"/>
        <source>Secondary plane</source>
        <translation>Nebenebene</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Reference, where the plan agrees</source>
        <translation>Referenz, wo der Plan übereinstimmt</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within a quarter of the tolerance of %1 m</source>
        <translation>Plan innerhalb eines Viertels der Toleranz von %1 m</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within half of the tolerance</source>
        <translation>Plan innerhalb der halben Toleranz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within the tolerance</source>
        <translation>Plan innerhalb der Toleranz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Missing: only in the reference</source>
        <translation>Fehlend: nur in der Referenz</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Wrong: only in the plan</source>
        <translation>Falsch: nur im Plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/residuals.qml"/>
        <source>Residual, %1 times: horizontal blue, height orange</source>
        <translation>Restklaffung, %1-fach: horizontal blau, Höhe orange</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/residuals.qml"/>
        <source>Rejected target</source>
        <translation>Verworfene Zielmarke</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/targets.qml"/>
        <source>Doubtful</source>
        <translation>Zweifelhaft</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Straight wall</source>
        <translation>Gerade Wand</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Connected or curved walls</source>
        <translation>Verbundene oder gekrümmte Wände</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Column</source>
        <translation>Stütze</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Wall of a room</source>
        <translation>Wand eines Raumes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Parapet, window above</source>
        <translation>Brüstung, darüber Fenster</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Other wall</source>
        <translation>Andere Wand</translation>
    </message>
</context>
</TS>
