<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Ichnograph</name>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>shift %1</source>
        <translation>translation %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>rotation %1</source>
        <translation>rotation %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>levelled scale</source>
        <translation>nivelé avec échelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>rotation</source>
        <translation>rotation</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>shift, the scanner&#x27;s position</source>
        <translation>translation, position du scanner</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>similarity</source>
        <translation>similitude</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>unknown scale</source>
        <translation>échelle inconnue</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>The folder %1 holds no point cloud; choose another, or single files.</source>
        <translation>Le dossier %1 ne contient aucun nuage de points ; choisissez-en un autre, ou des fichiers isolés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>No point cloud was given; choose at least one file.</source>
        <translation>Aucun nuage de points n&#x27;a été donné ; choisissez au moins un fichier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is listed twice; remove one entry.</source>
        <translation>%1 figure deux fois ; supprimez une entrée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 has an unknown extension; convert it to %2.</source>
        <translation>%1 a une extension inconnue ; convertissez-le en %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 does not exist or is not a file; check the name and the folder.</source>
        <translation>%1 n&#x27;existe pas ou n&#x27;est pas un fichier ; vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is empty; copy or export it again.</source>
        <translation>%1 est vide ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>the cloud in the chosen coordinate reference system</source>
        <translation>le nuage dans le système de coordonnées choisi</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>There is no coordinate reference system in %1 and none was chosen, so the results have none either.</source>
        <translation>%1 n&#x27;indique aucun système de coordonnées et aucun n&#x27;a été choisi ; les résultats n&#x27;en ont donc pas non plus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is in %2, but %3 in %4; reproject them to the same coordinate reference system.</source>
        <translation>%1 est en %2, mais %3 en %4 ; reprojetez-les dans le même système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>There is no coordinate reference system in %1, so %2 of the other files is used for them.</source>
        <translation>%1 n&#x27;indique aucun système de coordonnées ; celui des autres fichiers, %2, est utilisé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 is in %2, so the chosen %3 is not used.</source>
        <translation>%1 est en %2 ; le système choisi, %3, n&#x27;est pas utilisé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cloud.py"/>
        <source>%1 and %2 more files</source>
        <translation>%1 et %2 autres fichiers</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: workers were lost one after another at the same work; give them more memory, and see their logs for the reason.</source>
        <translation>SCHEDULER %1 : des workers ont été perdus l’un après l’autre au même travail ; donnez-leur plus de mémoire et cherchez la raison dans leurs journaux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the connection was lost; check that the scheduler runs, and start again.</source>
        <translation>SCHEDULER %1 : la connexion est perdue ; vérifiez que l’ordonnanceur fonctionne et recommencez.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the cluster has no worker any more; start some, and start again.</source>
        <translation>SCHEDULER %1 : le cluster n’a plus de worker ; démarrez-en et recommencez.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER needs distributed %1 or newer on all computers, because older ones do not bear the loss of a worker; this computer has %2.</source>
        <translation>SCHEDULER demande distributed %1 ou plus récent sur tous les ordinateurs, car les versions antérieures ne supportent pas la perte d’un worker ; cet ordinateur a %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: Dask has no certificates; state them in its configuration (distributed.comm.tls).</source>
        <translation>SCHEDULER %1 : Dask n’a pas de certificats ; indiquez-les dans sa configuration (distributed.comm.tls).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: no scheduler answers there within %2 s; check the address, the network, and that it runs (`dask scheduler`).</source>
        <translation>SCHEDULER %1 : aucun ordonnanceur n’y répond en %2 s ; vérifiez l’adresse, le réseau, et qu’il fonctionne (`dask scheduler`).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1 is not an address; write it like tcp://192.168.0.10:8786.</source>
        <translation>SCHEDULER %1 n’est pas une adresse ; écrivez-la comme tcp://192.168.0.10:8786.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>the scheduler</source>
        <translation>l’ordonnanceur</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: the cluster has no workers; start some (`dask worker`).</source>
        <translation>SCHEDULER %1 : le cluster n’a pas de workers ; démarrez-en (`dask worker`).</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>the worker %1</source>
        <translation>le worker %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: workers cannot import %2 (%3); put the folder that holds the plugin&#x27;s folder on their PYTHONPATH.</source>
        <translation>SCHEDULER %1 : des workers ne peuvent pas importer %2 (%3) ; ajoutez à leur PYTHONPATH le dossier qui contient celui de l’extension.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/connection.py"/>
        <source>SCHEDULER %1: %2 has %3 %4, this computer %5; install the same version on all.</source>
        <translation>SCHEDULER %1 : %2 a %3 %4, cet ordinateur %5 ; installez la même version partout.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/sorting.py"/>
        <source>Connecting to %1</source>
        <translation>Connexion à %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/sorting.py"/>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <location filename="../../algorithms/clouds/formats/text.py"/>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/tasks.py"/>
        <source>SCHEDULER: a worker does not find %1; keep the clouds where all workers find them by the same path.</source>
        <translation>SCHEDULER : un worker ne trouve pas %1 ; gardez les nuages là où tous les workers les trouvent par le même chemin.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/cluster/tasks.py"/>
        <source>SCHEDULER: a worker finds another file than this computer as %1; keep the clouds where all workers find them by the same path.</source>
        <translation>SCHEDULER : un worker trouve un autre fichier que cet ordinateur comme %1 ; gardez les nuages là où tous les workers les trouvent par le même chemin.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/__init__.py"/>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/__init__.py"/>
        <source>%1 or text (%2)</source>
        <translation>%1 ou texte (%2)</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>%1 m in %2</source>
        <translation>%1 m dans %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 have single precision, so they lie in steps of %2; export it with double precision, or with coordinates near 0.</source>
        <translation>Les coordonnées de %1 sont en simple précision et varient donc par pas de %2 ; exportez-les en double précision, ou avec des coordonnées proches de 0.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 are whole numbers, which were read as metres; if they are millimetres, convert them, or write the unit into the names of the columns.</source>
        <translation>Les coordonnées de %1 sont des nombres entiers, lus comme des mètres ; si ce sont des millimètres, convertissez-les, ou écrivez l’unité dans les noms des colonnes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The coordinates of %1 are multiples of %2; if they were rounded, and do not form a grid, export it with three decimals or more.</source>
        <translation>Les coordonnées de %1 sont des multiples de %2 ; si elles ont été arrondies et ne forment pas une grille, exportez-les avec trois décimales ou plus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>%1 of the points of %2 are at 0, 0, 0, where programs put what was not measured; remove them.</source>
        <translation>%1 des points de %2 sont en 0, 0, 0, où les programmes mettent ce qui n&#x27;a pas été mesuré ; supprimez-les.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/coordinate_steps.py"/>
        <source>The points of %1 reach over %2 m in height; if their coordinates are millimetres, convert them to metres.</source>
        <translation>Les points de %1 s’étendent sur %2 m en hauteur ; si leurs coordonnées sont des millimètres, convertissez-les en mètres.</translation>
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
        <translation>intensité</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>%1 is not an E57 file; give it the extension of its format.</source>
        <translation>%1 n&#x27;est pas un fichier E57 ; donnez-lui l&#x27;extension de son format.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>its parts contradict each other</source>
        <translation>ses parties se contredisent</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>%1 is truncated or damaged (%2); copy or export it again.</source>
        <translation>%1 est tronqué ou endommagé (%2) ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <location filename="../../algorithms/facade/points.py"/>
        <source>colour</source>
        <translation>couleur</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>Some scans of %1 have no %2, which counts as 0 there; export all scans alike.</source>
        <translation>Il manque à certains scans de %1 : %2 ; cela y compte pour 0. Exportez tous les scans de la même façon.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>Scan %1 of %2 has no pose, though others have, and was not moved; check that it is registered.</source>
        <translation>Le scan %1 de %2 n’a pas de pose, contrairement à d’autres, et n’a pas été déplacé ; vérifiez qu’il est recalé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57.py"/>
        <source>%1 has angles of up to %2, though E57 prescribes radians; export it again with Cartesian coordinates.</source>
        <translation>%1 a des angles allant jusqu&#x27;à %2, alors que E57 prescrit des radians ; exportez-le à nouveau avec des coordonnées cartésiennes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>%1 has a scan without coordinates; export it again.</source>
        <translation>%1 contient un scan sans coordonnées ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>The pose of scan %1 of %2 %3; export the scan again with its pose.</source>
        <translation>L&#x27;orientation du scan %1 de %2 %3 ; exportez à nouveau le scan avec son orientation.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>The rotation of scan %1 of %2 %3; check how it was exported.</source>
        <translation>La rotation du scan %1 de %2 %3 ; vérifiez comment il a été exporté.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>is all zero, so the scan is not turned</source>
        <translation>est entièrement nulle, le scan n&#x27;est donc pas tourné</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/e57_scan.py"/>
        <source>has the length %1 instead of 1</source>
        <translation>a pour longueur %1 au lieu de 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1: %2 withheld points and points of noise were left out.</source>
        <translation>%1 : %2 points retirés ou classés comme bruit ont été écartés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 of the points of %2 are flagged as withheld or classified as noise, and are left out; change their class where they are wanted.</source>
        <translation>%1 des points de %2 sont marqués comme retirés ou classés comme bruit et sont écartés ; changez leur classe s&#x27;ils sont utiles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>The coordinates of %1 lie in steps of %2 m, the scale in its header; export it with a scale of 0.001 m or finer.</source>
        <translation>Les coordonnées de %1 varient par pas de %2 m, l&#x27;échelle de son en-tête ; exportez-le avec une échelle de 0.001 m ou plus fine.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 has coordinates that are not numbers because the scale or offset in its header is not valid; export it again.</source>
        <translation>%1 a des coordonnées qui ne sont pas des nombres, car l&#x27;échelle ou le décalage de son en-tête n&#x27;est pas valide ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las.py"/>
        <source>%1 is mirrored by a negative scale in its header; export it again.</source>
        <translation>%1 est inversé en miroir par une échelle négative dans son en-tête ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>a record after its points announces more than there is</source>
        <translation>un enregistrement placé après les points annonce plus que ce qui s&#x27;y trouve</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>The header of %1 announces no points; the %2 that follow it were read, so check that the file is complete.</source>
        <translation>L&#x27;en-tête de %1 n&#x27;annonce aucun point ; les %2 qui le suivent ont été lus, vérifiez donc que le fichier est complet.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>The header of %1 announces %2 points, but %3 more follow, which were left out; export it again.</source>
        <translation>L’en-tête de %1 annonce %2 points, mais %3 autres suivent, qui ont été omis ; exportez le fichier à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>%1 is not a LAS or LAZ file; give it the extension of its format.</source>
        <translation>%1 n&#x27;est pas un fichier LAS ou LAZ ; donnez-lui l&#x27;extension de son format.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>it ends within the header</source>
        <translation>il se termine dans l&#x27;en-tête</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>there is no version %1.%2 of LAS</source>
        <translation>il n&#x27;existe pas de version %1.%2 de LAS</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces more records than it has room for</source>
        <translation>son en-tête annonce plus d&#x27;enregistrements qu&#x27;il ne peut en contenir</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces %1 bytes a point</source>
        <translation>son en-tête annonce %1 octets par point</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_layout.py"/>
        <source>its header announces %1 points, but it ends before the last</source>
        <translation>son en-tête annonce %1 points, mais il se termine avant le dernier</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it lacks the record of its compression</source>
        <translation>il lui manque l&#x27;enregistrement de sa compression</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it cannot be decoded: %1</source>
        <translation>il ne peut pas être décodé : %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/las_reader.py"/>
        <source>it ends before its last point</source>
        <translation>il se termine avant son dernier point</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its record of the compression is cut off</source>
        <translation>l&#x27;enregistrement de sa compression est coupé</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its record of the compression does not fit its points</source>
        <translation>l&#x27;enregistrement de sa compression ne correspond pas à ses points</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its compression %1 is not known</source>
        <translation>sa compression %1 est inconnue</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its compressed chunks are larger than any program writes</source>
        <translation>ses blocs compressés sont plus grands que n&#x27;en écrit aucun programme</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>the table of its compressed chunks is missing</source>
        <translation>la table de ses blocs compressés manque</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>the table of its compressed chunks announces more than there is</source>
        <translation>la table de ses blocs compressés annonce plus que ce qui s&#x27;y trouve</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>one of its compressed chunks announces more than it holds</source>
        <translation>l&#x27;un de ses blocs compressés annonce plus qu&#x27;il ne contient</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its header announces %1 points, but its chunks hold %2 at most</source>
        <translation>son en-tête annonce %1 points, mais ses blocs en contiennent au plus %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>its header announces %1 points, more than it has room for</source>
        <translation>son en-tête annonce %1 points, plus qu&#x27;il ne peut en contenir</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/laz_chunks.py"/>
        <source>it ends within its compressed points</source>
        <translation>il se termine au milieu de ses points compressés</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/normals.py"/>
        <source>%1 of %2 seem to be normals; they are not turned if the cloud is, unless they are called nx, ny and nz.</source>
        <translation>%1 de %2 semblent être des normales ; elles ne sont pas tournées avec le nuage, sauf si elles s&#x27;appellent nx, ny et nz.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>the number at the end of its last line %1 is cut off</source>
        <translation>le nombre à la fin de sa dernière ligne %1 est coupé</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>%1 holds a character 0 among its numbers, so it is damaged; copy or export it again.</source>
        <translation>%1 contient un caractère 0 parmi ses nombres et est donc endommagé ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>holds something that is not a number</source>
        <translation>contient autre chose que des nombres</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>has %1 numbers instead of %2</source>
        <translation>a %1 nombres au lieu de %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/number_table.py"/>
        <source>Line %1 of %2 %3; copy or export the file again.</source>
        <translation>La ligne %1 de %2 %3 ; copiez ou exportez le fichier à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 gives coordinates in %2; they were converted to metres.</source>
        <translation>%1 donne les coordonnées en %2 ; elles ont été converties en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>The header of %1 announces %2 points, but more follow, which were left out; export it again.</source>
        <translation>L’en-tête de %1 annonce %2 points, mais d’autres suivent, qui ont été omis ; exportez le fichier à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>it announces %1 points and has %2</source>
        <translation>il annonce %1 points et en a %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>%1 has a property %2 with decimals where its header announces whole numbers; export it again.</source>
        <translation>%1 a une propriété %2 avec des décimales là où son en-tête annonce des nombres entiers ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply.py"/>
        <source>%1 has a property %2 beyond the range of its type; export it again.</source>
        <translation>%1 a une propriété %2 hors des limites de son type ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 is a PLY of an unknown encoding; export it again.</source>
        <translation>%1 est un PLY d&#x27;un codage inconnu ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 is not a PLY file; give it the extension of its format.</source>
        <translation>%1 n&#x27;est pas un fichier PLY ; donnez-lui l&#x27;extension de son format.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has a header that cannot be read; export it again.</source>
        <translation>L&#x27;en-tête de %1 est illisible ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has vertices without x, y and z; export it again as a point cloud.</source>
        <translation>%1 a des sommets sans x, y et z ; exportez-le à nouveau comme nuage de points.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ply_header.py"/>
        <source>%1 has the property %2 with its vertices or before them, which cannot be read; export it again as a point cloud.</source>
        <translation>%1 a, dans ses sommets ou avant eux, la propriété %2, qui ne peut pas être lue ; exportez-le à nouveau comme nuage de points.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>is all zero, so that every point would lie in one position</source>
        <translation>est entièrement nulle, de sorte que tous les points seraient confondus</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>moves the points by %1 m</source>
        <translation>déplace les points de %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>presses or blows up the points beyond any unit of length</source>
        <translation>comprime ou dilate les points au-delà de toute unité de longueur</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>mirrors the points</source>
        <translation>inverse les points en miroir</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>distorts the points because its rotation is not orthogonal</source>
        <translation>déforme les points, car sa rotation n&#x27;est pas orthogonale</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/poses.py"/>
        <source>scales the points by %1</source>
        <translation>met les points à l&#x27;échelle %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>intensity or colour</source>
        <translation>intensité ou couleur</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>is 0 there</source>
        <translation>y vaut 0</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>is left out there</source>
        <translation>y est laissée de côté</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>Scans of %1 have unlike columns, %2 in the first and %3 in others, so %4 %5; export all scans alike.</source>
        <translation>Les scans de %1 ont des colonnes différentes, %2 dans le premier et %3 dans d&#x27;autres ; %4 %5 donc. Exportez tous les scans de la même façon.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>a scan announces %1 cells and has %2</source>
        <translation>un scan annonce %1 cellules et en a %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>%1 has no header of a PTX scan from line %2 on; give it the extension of its format, or export it again.</source>
        <translation>%1 n&#x27;a pas d&#x27;en-tête de scan PTX à partir de la ligne %2 ; donnez-lui l&#x27;extension de son format, ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>does not end in the column 0 0 0 1</source>
        <translation>ne se termine pas par la colonne 0 0 0 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>The pose of the scan in line %1 of %2 %3; export the scan again with its pose.</source>
        <translation>L&#x27;orientation du scan à la ligne %1 de %2 %3 ; exportez à nouveau le scan avec son orientation.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>The pose of the scan in line %1 of %2 %3; check how it was exported.</source>
        <translation>L&#x27;orientation du scan à la ligne %1 de %2 %3 ; vérifiez comment il a été exporté.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>differs from the position and axes of the scanner above it, by %1 m in position</source>
        <translation>diffère de la position et des axes du scanner au-dessus, de %1 m en position</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>differs from the axes of the scanner above it, by up to %1 degrees</source>
        <translation>diffère des axes du scanner au-dessus, jusqu&#x27;à %1 degrés</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/ptx.py"/>
        <source>Line %1 of %2 has %3 numbers instead of 4 (x y z intensity) or 7 (and colour); export it again as PTX.</source>
        <translation>La ligne %1 de %2 a %3 nombres au lieu de 4 (x y z intensité) ou 7 (avec la couleur) ; exportez-la à nouveau en PTX.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>The coordinate reference system in %1 cannot be understood.</source>
        <translation>Le système de coordonnées de %1 n&#x27;est pas compréhensible.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>%1 states a system of heights only (%2), which is ignored.</source>
        <translation>%1 n&#x27;indique qu&#x27;un système altimétrique (%2), qui est ignoré.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/stated_crs.py"/>
        <source>%1 states a local system (%2), which ties it to no position on the earth, so it counts as none.</source>
        <translation>%1 indique un système local (%2), qui n&#x27;est rattaché à aucune position sur la Terre ; il ne compte donc pas.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text.py"/>
        <source>it announces %1 points and holds %2</source>
        <translation>il annonce %1 points et en contient %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The first column of %1 can be x, or the number or time of a point; name the columns in a first line, as &#x27;x y z intensity&#x27; or &#x27;time x y z&#x27;.</source>
        <translation>La première colonne de %1 peut être x, ou le numéro ou l&#x27;heure d&#x27;un point ; nommez les colonnes dans une première ligne : &#x27;x y z intensity&#x27; ou &#x27;time x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The first two columns of %1 can be x and y, or the row and the column in the scan; name the columns in a first line, as &#x27;row column x y z&#x27;.</source>
        <translation>Les deux premières colonnes de %1 peuvent être x et y, ou la ligne et la colonne dans le scan ; nommez les colonnes dans une première ligne, par exemple &#x27;row column x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>%1 has fewer than three columns of numbers; export it as x y z.</source>
        <translation>%1 a moins de trois colonnes de nombres ; exportez-le sous la forme x y z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>Column %1 of %2 has no name and counts the points or states a time, so it was left out; name the columns in a first line, as &#x27;x y z intensity&#x27;.</source>
        <translation>La colonne %1 de %2 n&#x27;a pas de nom et compte les points ou donne une heure ; elle a été laissée de côté. Nommez les colonnes dans une première ligne, comme &#x27;x y z intensity&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The last four columns of %1 can be intensity and colour or colour and intensity, so both were left out; name the columns in a first line, as &#x27;x y z intensity red green blue&#x27;.</source>
        <translation>Les quatre dernières colonnes de %1 peuvent être l&#x27;intensité et la couleur ou l&#x27;inverse ; elles ont été écartées. Nommez les colonnes dans une première ligne : &#x27;x y z intensity red green blue&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_columns.py"/>
        <source>The columns of %1 after x y z have no names and were left out.</source>
        <translation>Les colonnes de %1 après x y z n&#x27;ont pas de nom et ont été écartées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 is a model of surfaces, not a point cloud; export its points as x y z.</source>
        <translation>%1 est un modèle de surfaces, pas un nuage de points ; exportez ses points comme x y z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 of the first rows of %2, the first in line %3, begin as remarks do and were read as points, because their first field is a name.</source>
        <translation>%1 des premières lignes de %2, la première à la ligne %3, commencent comme des commentaires et ont été lues comme points, car leur premier champ est un nom.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>Column %1 of %2 has no name and was read as intensity; if it is something else, name the columns in a first line.</source>
        <translation>La colonne %1 de %2 n&#x27;a pas de nom et a été lue comme intensité ; si c&#x27;est autre chose, nommez les colonnes dans une première ligne.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 is a raster grid, not a point cloud; choose the cloud itself.</source>
        <translation>%1 est une grille raster et non un nuage de points ; choisissez le nuage lui-même.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_layout.py"/>
        <source>%1 has coordinates that are not numbers; export it again.</source>
        <translation>%1 a des coordonnées qui ne sont pas des nombres ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>%1 cannot be read between the lines %2 and %3; look for unusual characters there.</source>
        <translation>%1 ne peut pas être lu entre les lignes %2 et %3 ; cherchez-y des caractères inhabituels.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>Line %1 of %2 holds a character 0, so the file is damaged; copy or export it again.</source>
        <translation>La ligne %1 de %2 contient un caractère 0, le fichier est donc endommagé ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <source>its last line %1 is cut off</source>
        <translation>sa dernière ligne %1 est coupée</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2 %3; correct or remove that line.</source>
        <translation>La ligne %1 de %2 %3 ; corrigez ou supprimez cette ligne.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has %1 columns instead of %2</source>
        <translation>a %1 colonnes au lieu de %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/text_rows.py"/>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has &#x27;%1&#x27; where a number is expected</source>
        <translation>contient &#x27;%1&#x27; là où un nombre est attendu</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/formats/value_ranges.py"/>
        <source>%1 has colours above %2, though points from all over the file have none; export it again with colours of one range, or without colour.</source>
        <translation>%1 a des couleurs supérieures à %2, alors que des points de tout le fichier n&#x27;en ont pas ; exportez-le à nouveau avec des couleurs d&#x27;un seul intervalle, ou sans couleur.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 cannot be read (%2); check that it exists and that you may read it.</source>
        <translation>%1 ne peut pas être lu (%2) ; vérifiez qu&#x27;il existe et que vous avez le droit de le lire.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <source>%1 is truncated (%2); copy or export it again.</source>
        <translation>%1 est tronqué (%2) ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/source.py"/>
        <source>%1 holds no points; leave it out or export it again.</source>
        <translation>%1 ne contient aucun point ; retirez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/thinning/thinning.py"/>
        <location filename="../../algorithms/site_plan/density/windows.py"/>
        <source>Thinning</source>
        <translation>Éclaircissage</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>The temporary folder %1 has %2 GB free, but %3 points take up to %4 GB; free some space, or set TMPDIR to a folder on a larger disk.</source>
        <translation>Le dossier temporaire %1 a %2 Go libres, mais %3 points en prennent jusqu&#x27;à %4 ; libérez de la place, ou donnez à TMPDIR un dossier d&#x27;un disque plus grand.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>it ends early</source>
        <translation>il se termine trop tôt</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>The temporary file of the points cannot be written or read (%1); free some space in the temporary folder, or set TMPDIR to a folder on a larger disk.</source>
        <translation>Le fichier temporaire des points ne peut pas être écrit ou lu (%1) ; libérez de la place dans le dossier temporaire, ou donnez à TMPDIR un dossier d&#x27;un disque plus grand.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>%1: %2 of %3 points lie more than %4 km high or deep; transform geocentric coordinates to a projected coordinate reference system in metres first.</source>
        <translation>%1 : %2 points sur %3 sont à plus de %4 km d&#x27;altitude ou de profondeur ; transformez d&#x27;abord les coordonnées géocentriques dans un système projeté en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/tiles/tile_store.py"/>
        <source>%1: %2 of %3 points lie far away from the site and are left out.</source>
        <translation>%1 : %2 points sur %3 sont très éloignés du site et sont écartés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: %2 seems to be up, because floors and ceilings lie across it; turn the cloud so that z is up, for instance by 90 degrees about x, because walls are looked for along z.</source>
        <translation>%1 : %2 semble être la verticale, car sols et plafonds lui sont perpendiculaires ; tournez le nuage pour que z soit vers le haut, par exemple de 90 degrés autour de x, car les murs sont cherchés selon z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: %2 seems to be up, because floors and ceilings lie across it; turn the cloud so that z is up, for instance by 90 degrees about y, because walls are looked for along z.</source>
        <translation>%1 : %2 semble être la verticale, car sols et plafonds lui sont perpendiculaires ; tournez le nuage pour que z soit vers le haut, par exemple de 90 degrés autour de y, car les murs sont cherchés selon z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: the cloud seems to stand on its head, because its ground lies above its walls; change the sign of z and of one of x and y, which turns it over without mirroring it.</source>
        <translation>%1 : le nuage semble être à l&#x27;envers, car son sol est au-dessus de ses murs ; changez le signe de z et de l&#x27;un des deux x et y, ce qui le retourne sans l&#x27;inverser en miroir.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/uprightness.py"/>
        <source>%1: floors and walls are tilted by %2 degrees towards the azimuth %3 degrees, which costs walls; level the cloud first, for instance by registering it with MODEL rigid.</source>
        <translation>%1 : sols et murs sont inclinés de %2 degrés vers l&#x27;azimut %3 degrés, ce qui fait perdre des murs ; mettez d&#x27;abord le nuage à niveau, par exemple en le recalant avec MODEL rigide.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/las_files.py"/>
        <source>%1 cannot hold points that lie so far apart; remove the points far away, or choose a text file.</source>
        <translation>%1 ne peut pas contenir des points aussi éloignés les uns des autres ; supprimez les points lointains, ou choisissez un fichier texte.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>Left out of %1: %2. Write LAS or LAZ from LAS or LAZ files of one point format to keep everything.</source>
        <translation>Absents de %1 : %2. Écrivez du LAS ou du LAZ à partir de fichiers LAS ou LAZ d&#x27;un même format de points pour tout conserver.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>There is no colour in %1, so the points from there are black in %2.</source>
        <translation>Il n’y a pas de couleur dans %1, les points qui en viennent sont donc noirs dans %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>There is no intensity in %1, so it is 0 in %2 for the points from there.</source>
        <translation>Il n’y a pas d’intensité dans %1, elle est donc 0 dans %2 pour les points qui en viennent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/losses.py"/>
        <source>Some inputs have the seconds of a week as GPS times and others those since 1980. %1 holds them unchanged, and states the kind of %2.</source>
        <translation>Certaines entrées ont comme temps GPS les secondes de la semaine, d’autres celles depuis 1980. %1 les contient inchangés et indique le type de %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/point_selection.py"/>
        <source>No point is left to write to %1.</source>
        <translation>Il ne reste aucun point à écrire dans %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/target.py"/>
        <source>%1 has an extension that cannot be written; choose %2.</source>
        <translation>%1 a une extension qui ne peut pas être écrite ; choisissez %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/target.py"/>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 is an input as well; choose another name for the output.</source>
        <translation>%1 est aussi une entrée ; choisissez un autre nom pour la sortie.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 and %2 would both become %3; transform one of them later, into another folder.</source>
        <translation>%1 et %2 deviendraient tous deux %3 ; transformez l&#x27;un d&#x27;eux plus tard, dans un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1, which transformations in metres cannot move,</source>
        <translation>%1, que des transformations en mètres ne peuvent pas déplacer,</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>The matrix for %1 is rounded, which moves its points by up to %2 m, because they lie far from 0; write the matrix with more decimals.</source>
        <translation>La matrice de %1 est arrondie, ce qui déplace ses points jusqu&#x27;à %2 m, car ils sont loin de 0 ; écrivez la matrice avec plus de décimales.</translation>
    </message>
    <message>
        <location filename="../../algorithms/clouds/writing/transformation.py"/>
        <source>%1 holds waveforms, which are left out.</source>
        <translation>%1 contient des formes d&#x27;onde, qui sont écartées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/drawing.py"/>
        <location filename="../../algorithms/facade/output/annotations.py"/>
        <location filename="../../algorithms/facade/output/drawing.py"/>
        <source>layer</source>
        <translation>couche</translation>
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
        <translation>hauteur</translation>
    </message>
    <message>
        <location filename="../../algorithms/drawing.py"/>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>written</source>
        <translation>écrit</translation>
    </message>
    <message>
        <location filename="../../algorithms/errors.py"/>
        <source>read</source>
        <translation>lu</translation>
    </message>
    <message>
        <location filename="../../algorithms/errors.py"/>
        <source>%1 cannot be %2 without %3; install what is missing.</source>
        <translation>%1 ne peut pas être %2 sans %3 ; installez ce qui manque.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/boundary.py"/>
        <source>The outlines are %1 km long, more than %2 km; choose the walls of one site, and check that their coordinates are metres.</source>
        <translation>Les contours mesurent %1 km, plus de %2 km ; choisissez les murs d&#x27;un seul site, et vérifiez que leurs coordonnées sont en mètres.</translation>
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
        <translation>mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/site_plan/storeys/joining.py"/>
        <location filename="../../algorithms/site_plan/storeys/walls/walls.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>column</source>
        <translation>poteau</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>glazing</source>
        <translation>vitrage</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>opening</source>
        <translation>baie</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>low</source>
        <translation>bas</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>%1 cannot be read as a layer of a drawn plan: %2.</source>
        <translation>%1 ne peut pas être lu comme couche d&#x27;un plan dessiné : %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <source>%1 has no feature of the kind judged; draw the region that is to be judged.</source>
        <translation>%1 n&#x27;a pas d&#x27;entité de type judged ; dessinez la zone à évaluer.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/drawn_plan.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>room</source>
        <translation>pièce</translation>
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
        <translation>largeur</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <location filename="../../algorithms/facade/output/schedule.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>sill</source>
        <translation>hauteur d&#x27;allège</translation>
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
        <translation>longueur</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 of %4 is listed twice; remove one entry.</source>
        <translation>Ligne %1 de %2 : la dimension « %3 » de %4 figure deux fois ; supprimez une entrée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 gives lengths in %2; they were converted to metres.</source>
        <translation>%1 donne les longueurs en %2 ; elles ont été converties en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the dimension must be width, height or sill, not %3.</source>
        <translation>Ligne %1 de %2 : la dimension doit être width, height ou sill, et non %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 has no lengths; name its columns id, width, height and sill, or id, dimension and length.</source>
        <translation>%1 n&#x27;a pas de longueurs ; nommez ses colonnes id, width, height et sill, ou id, dimension et length.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2 has no id; add the one of its detail.</source>
        <translation>La ligne %1 de %2 n&#x27;a pas d&#x27;identifiant ; ajoutez celui de son détail.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>%1 of facade %2</source>
        <translation>%1 de la façade %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 %4 is not a length in metres.</source>
        <translation>Ligne %1 de %2 : %3 %4 n&#x27;est pas une longueur en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/length_lists.py"/>
        <source>Line %1 of %2: the %3 %4 is not a standard deviation.</source>
        <translation>Ligne %1 de %2 : %3 %4 n&#x27;est pas un écart-type.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>decimetres</source>
        <translation>décimètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 has no length of %2; use the ids of the schedule in both, and its column facade if it has one.</source>
        <translation>%1 n&#x27;a aucune longueur de %2 ; utilisez dans les deux fichiers les numéros (id) de la nomenclature, et sa colonne facade si elle en a une.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>%1 has no %2.</source>
        <translation>Dans %1, il manque : %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths.py"/>
        <source>The lengths of %1 are about %2 times those of %3, as if they were in %4; write metres, or the unit in the header, as &#x27;width [mm]&#x27;.</source>
        <translation>Les longueurs de %1 sont environ %2 fois celles de %3, comme si elles étaient en %4 ; écrivez des mètres, ou l&#x27;unité dans l&#x27;en-tête, par exemple &#x27;width [mm]&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/lengths_report.py"/>
        <source>automatic minus manual</source>
        <translation>automatique moins manuel</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>Feature %1 of %2 has a coordinate that is not a number; remove it.</source>
        <translation>L&#x27;entité %1 de %2 a une coordonnée qui n&#x27;est pas un nombre ; supprimez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 holds no outlines; choose a layer of polygons.</source>
        <translation>%1 ne contient aucun contour ; choisissez une couche de polygones.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>Outlines of %1 that cross themselves were repaired: %2.</source>
        <translation>Des contours de %1 qui se recoupent ont été réparés : %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 holds lines; choose a layer of polygons, as siteplan writes it.</source>
        <translation>%1 contient des lignes ; choisissez une couche de polygones, telle que l&#x27;écrit siteplan.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 has no coordinate reference system; that of %2 is assumed.</source>
        <translation>%1 n&#x27;a pas de système de coordonnées ; celui de %2 est supposé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 and %2 have nothing in common: they are %3 m apart; check that both show the same site in the same coordinate reference system.</source>
        <translation>%1 et %2 n&#x27;ont rien en commun : ils sont distants de %3 m ; vérifiez que les deux montrent le même site dans le même système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/outlines.py"/>
        <source>%1 is in %2, but %3 in %4; reproject one of them with Reproject layer.</source>
        <translation>%1 est en %2, mais %3 en %4 ; reprojetez l&#x27;un des deux avec « Reprojeter une couche ».</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <source>agrees</source>
        <translation>concordant</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/registration/simulation/trials.py"/>
        <source>wrong</source>
        <translation>faux</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>plan</source>
        <translation>plan</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan.py"/>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/plan_report.py"/>
        <source>distance (cm)</source>
        <translation>distance (cm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>%1 lengths: mean difference %2 mm, standard deviation %3 mm, largest %4 mm. Aitelkadi and others (2014) report 4 mm and 6 mm for 19 lengths.</source>
        <translation>%1 longueurs : différence moyenne %2 mm, écart-type %3 mm, maximum %4 mm. Aitelkadi et al. (2014) indiquent 4 mm et 6 mm pour 19 longueurs.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic and manual lengths</source>
        <translation>Longueurs automatiques et manuelles</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic minus manual length.</source>
        <translation>Longueur automatique moins longueur manuelle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Detail</source>
        <translation>Détail</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Dimension</source>
        <translation>Dimension</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Automatic (m)</source>
        <translation>Automatique (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Manual (m)</source>
        <translation>Manuel (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Difference (mm)</source>
        <translation>Différence (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/lengths.html"/>
        <source>Difference / std</source>
        <translation>Différence / écart-type</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1% of the reference is in the plan (completeness at %2).</source>
        <translation>%1 % de la référence est dans le plan (complétude à %2).</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1% of the plan is in the reference (correctness at %2).</source>
        <translation>%1 % du plan est dans la référence (exactitude à %2).</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Where the reference is in the plan, half of it is within %1 cm, 95 % within %2 cm.</source>
        <translation>Là où la référence est dans le plan, la moitié en est à moins de %1 cm, 95 % à moins de %2 cm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Intersection over union of the areas: %1.</source>
        <translation>Intersection sur union (IoU) des surfaces : %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Rooms of the reference: %1 found, %2 missed, %3 invented; median error of the area %4 %.</source>
        <translation>Pièces de la référence : %1 trouvées, %2 manquées, %3 inventées ; erreur médiane de la surface %4 %.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Rooms of the reference: %1 found, %2 missed, %3 invented.</source>
        <translation>Pièces de la référence : %1 trouvées, %2 manquées, %3 inventées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Where they agree</source>
        <translation>Où ils concordent</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>How far apart they are</source>
        <translation>De combien ils s&#x27;écartent</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Longest errors</source>
        <translation>Plus longues erreurs</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>%1 m are wrong, %2 m missing.</source>
        <translation>%1 m sont faux, %2 m manquent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>There are no errors.</source>
        <translation>Il n&#x27;y a aucune erreur.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>What the numbers mean</source>
        <translation>Ce que signifient les nombres</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Plan and reference</source>
        <translation>Plan et référence</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Green: the plan, where it agrees with the reference (grey). Red: the plan, where the reference has nothing within the tolerance. Blue: the reference, where the plan has nothing.</source>
        <translation>Vert : le plan, là où il concorde avec la référence (gris). Rouge : le plan, là où la référence n&#x27;a rien dans la tolérance. Bleu : la référence, là où le plan n&#x27;a rien.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of each boundary that is within a distance of the other one. The dashed line is the tolerance.</source>
        <translation>Part de chaque limite qui est à moins d&#x27;une distance donnée de l&#x27;autre. La ligne tiretée est la tolérance.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>within</source>
        <translation>à moins de</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>of the reference: completeness (%)</source>
        <translation>de la référence : complétude (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>of the plan: correctness (%)</source>
        <translation>du plan : exactitude (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>length (m)</source>
        <translation>longueur (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>median offset (m)</source>
        <translation>décalage médian (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>largest offset (m)</source>
        <translation>décalage maximal (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>x of its middle</source>
        <translation>x du milieu</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>The longest %1 of %2.</source>
        <translation>Les %1 plus longues sur %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Completeness</source>
        <translation>Complétude</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of the reference&#x27;s boundary with a boundary of the plan within the tolerance, %1.</source>
        <translation>Part de la limite de la référence qui a une limite du plan dans la tolérance de %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Correctness</source>
        <translation>Exactitude</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Share of the plan&#x27;s boundary with a boundary of the reference within the tolerance.</source>
        <translation>Part de la limite du plan qui a une limite de la référence dans la tolérance.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Median and 95 % offset</source>
        <translation>Décalage médian et à 95 %</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Of the distances from the reference&#x27;s boundary to the plan&#x27;s, where the plan has it within the tolerance.</source>
        <translation>Des distances de la limite de la référence à celle du plan, là où le plan l&#x27;a dans la tolérance.</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Intersection over union</source>
        <translation>Intersection sur union (IoU)</translation>
    </message>
    <message>
        <location filename="../../algorithms/evaluation/templates/plan.html"/>
        <source>Area that is wall in both, divided by the area that is wall in either. Not known if the reference consists of lines.</source>
        <translation>Surface qui est mur dans les deux, divisée par la surface qui est mur dans l&#x27;un ou l&#x27;autre. Inconnue si la référence est faite de lignes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>No facade was found, so leave FACADE 0, and FACADE_NEAR and FACADE_ALONG empty.</source>
        <translation>Aucune façade n&#x27;a été trouvée ; laissez FACADE à 0, et FACADE_NEAR et FACADE_ALONG vides.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE_NEAR is %1 m from the nearest facade; give it in the coordinates of the site.</source>
        <translation>FACADE_NEAR est à %1 m de la façade la plus proche ; donnez le point dans les coordonnées du site.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE is %1, but the cloud has %2 facades; choose one from 1 to %3 in the report, or 0.</source>
        <translation>FACADE vaut %1, mais le nuage a %2 façades ; choisissez-en une de 1 à %3 dans le rapport, ou 0.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/buildings/choice.py"/>
        <source>FACADE_ALONG has a line or a polygon without a facade within %1 m; give it in the coordinates of the site, along the outside of the walls.</source>
        <translation>FACADE_ALONG a une ligne ou un polygone sans façade à moins de %1 m ; donnez-le dans les coordonnées du site, le long de l&#x27;extérieur des murs.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>as narrow as a joint</source>
        <translation>aussi étroit qu&#x27;un joint</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>its colour changes gradually, as that of a stain or of lamplight does</source>
        <translation>sa couleur change peu à peu, comme celle d&#x27;une tache ou d&#x27;une lueur de lampe</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>its colour differs no more than the wall&#x27;s own colours do</source>
        <translation>sa couleur ne diffère pas plus que les couleurs du mur entre elles</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/colour/steps.py"/>
        <source>the intensity shows no edge, as that of a shadow does not</source>
        <translation>l&#x27;intensité ne montre aucune arête, comme pour une ombre</translation>
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
        <translation>droite</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>A round wall with a radius of %1 m is rolled out.</source>
        <translation>Un mur rond d&#x27;un rayon de %1 m est développé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>%1 sides are rolled out: %2 m long.</source>
        <translation>%1 pans sont développés : %2 m de long.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>No round wall with a radius of %1 to %2 m was found of which %3 degrees are seen; cut the cloud to the tower, or choose another UNROLL.</source>
        <translation>Aucun mur rond d&#x27;un rayon de %1 à %2 m n&#x27;a été trouvé dont %3 degrés soient vus ; découpez le nuage à la tour, ou choisissez une autre option pour UNROLL.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/development/development.py"/>
        <source>No sides were found that meet at the facade and turn by %1 to %2 degrees; choose another UNROLL.</source>
        <translation>Aucun pan n&#x27;a été trouvé qui se raccorde à la façade et tourne de %1 à %2 degrés ; choisissez une autre option pour UNROLL.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>recess</source>
        <translation>renfoncement</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>coloured detail</source>
        <translation>détail coloré</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>projection</source>
        <translation>saillie</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>trapezium</source>
        <translation>trapèze</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>arch</source>
        <translation>arc</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <location filename="../../algorithms/facade/openings/niches.py"/>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <source>bottom</source>
        <translation>bas</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/elevation.py"/>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <location filename="../../algorithms/reporting/charts.py"/>
        <location filename="../../algorithms/site_plan/density/bands.py"/>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>top</source>
        <translation>haut</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1:</source>
        <translation>Façade %1 :</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1 is not drawn: %2</source>
        <translation>La façade %1 n&#x27;est pas dessinée : %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/every_facade.py"/>
        <source>Facade %1: %2</source>
        <translation>Façade %1 : %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>surface</source>
        <translation>surface</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>no straight sides, as of a stain</source>
        <translation>pas de côtés droits, comme une tache</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/left_out.py"/>
        <source>parallel to the wall, but not a part of it</source>
        <translation>parallèle au mur, mais n&#x27;en fait pas partie</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Tracing borders</source>
        <translation>Suivi des bords</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Triangulating the wall</source>
        <translation>Triangulation du mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The wall has points %1 mm apart; alpha is %2 m.</source>
        <translation>Les points du mur sont espacés de %1 mm ; alpha vaut %2 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Making outlines</source>
        <translation>Construction des contours</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The facade faces azimuth %1 degrees, SIDE %2, with a certainty of %3 %, because %4.</source>
        <translation>La façade est orientée à l&#x27;azimut %1 degrés, SIDE %2, avec une certitude de %3 %, car %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>%1 regions of one colour (SEED_VARIANCE %2) are %3 surfaces.</source>
        <translation>%1 régions d&#x27;une seule couleur (SEED_VARIANCE %2) forment %3 surfaces.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The intensities of the %1 scans have different levels (%2 to %3), so each scan is scaled by its own.</source>
        <translation>Les intensités des %1 scans ont des niveaux différents (%2 à %3) ; chaque scan est donc ramené au sien.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>Intensities that differ by less than %1 of the wall&#x27;s are one surface.</source>
        <translation>Des intensités qui diffèrent de moins de %1 de celle du mur forment une seule surface.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>No part of the wall is as large as %1 m²; decrease MIN_AREA, or increase ALPHA.</source>
        <translation>Aucune partie du mur n&#x27;atteint %1 m² ; diminuez MIN_AREA ou augmentez ALPHA.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>It is uncertain from which side the facade is seen: azimuth %1 degrees was taken, because %2. If the elevation is mirrored, set SIDE to %3.</source>
        <translation>On ne sait pas avec certitude de quel côté la façade est vue : l&#x27;azimut %1 degrés a été retenu, car %2. Si l&#x27;élévation est inversée en miroir, mettez SIDE à %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The points have no colour, so only openings, recesses and projections are found.</source>
        <translation>Les points n&#x27;ont pas de couleur ; seuls les baies, renfoncements et saillies sont donc trouvés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/measurement.py"/>
        <source>The points have no intensity, so a cast shadow can appear as a coloured detail; check the coloured details.</source>
        <translation>Les points n&#x27;ont pas d&#x27;intensité ; une ombre portée peut donc apparaître comme détail coloré. Vérifiez les détails colorés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>door</source>
        <translation>porte</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/content.py"/>
        <source>passage</source>
        <translation>passage</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/openings/niches.py"/>
        <source>niche</source>
        <translation>niche</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>fewer than three straight sides were seen, as of damage or a shadow</source>
        <translation>moins de trois côtés droits ont été vus, comme d&#x27;un dégât ou d&#x27;une ombre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>shallow and small, as of damage of the stone</source>
        <translation>peu profond et petit, comme d&#x27;un dégât de la pierre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>nothing was seen behind it, so that the wall may not have been scanned there</source>
        <translation>rien n&#x27;a été vu derrière, si bien que le mur n&#x27;y a peut-être pas été scanné</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>low, and without head and sill, as of a gap between things on the ground</source>
        <translation>bas, sans linteau ni appui, comme une lacune entre des objets au sol</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>not bounded by the wall all around</source>
        <translation>pas bordé par le mur sur tout le pourtour</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>narrow, at the end of the wall or of what was scanned of it</source>
        <translation>étroit, au bout du mur ou de ce qui en a été scanné</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>a part of the wall that bends or is a little set back, without an edge around it</source>
        <translation>une partie du mur courbée ou un peu en retrait, sans arête tout autour</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/acceptance.py"/>
        <source>ragged, as of damage or a shadow</source>
        <translation>déchiqueté, comme d&#x27;un dégât ou d&#x27;une ombre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>flat</source>
        <translation>droit</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>sloped</source>
        <translation>rampant</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>segmental</source>
        <translation>arc segmentaire</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>round</source>
        <translation>plein cintre</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/outlines/heads.py"/>
        <source>pointed</source>
        <translation>arc brisé</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/elevation_layers.py"/>
        <source>unseen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/orthoimage.py"/>
        <source>The orthoimage would have %1 x %2 pixels, more than %3; raise PIXEL_SIZE, or cut the cloud to the facade.</source>
        <translation>L&#x27;orthoimage aurait %1 x %2 pixels, plus de %3 ; augmentez PIXEL_SIZE, ou découpez le nuage à la façade.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/report.py"/>
        <source>Its sides are rolled out beside each other: u runs along the wall.</source>
        <translation>Ses pans sont développés côte à côte : u court le long du mur.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/report.py"/>
        <source>It is round and rolled out: u runs along the arc, on a radius of %1 m.</source>
        <translation>Elle est ronde et développée : u court le long de l&#x27;arc, sur un rayon de %1 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facade %1 of %2. It faces azimuth %3 degrees (certainty %4 %), because %5. Its wall has %6 m² without openings, and points %7 mm apart; %8 m² were not seen.</source>
        <translation>Façade %1 sur %2. Elle est orientée à l&#x27;azimut %3 degrés (certitude %4 %), car %5. Son mur a %6 m² sans les baies, et des points espacés de %7 mm ; %8 m² n&#x27;ont pas été vus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facade %1 of %2. It faces azimuth %3 degrees. Its wall has %4 m² without openings, and points %5 mm apart; %6 m² were not seen.</source>
        <translation>Façade %1 sur %2. Elle est orientée à l&#x27;azimut %3 degrés. Son mur a %4 m² sans les baies, et des points espacés de %5 mm ; %6 m² n&#x27;ont pas été vus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>It faces azimuth %1 degrees (certainty %2 %), because %3. Its wall has %4 m² without openings, and points %5 mm apart; %6 m² were not seen.</source>
        <translation>Elle est orientée à l&#x27;azimut %1 degrés (certitude %2 %), car %3. Son mur a %4 m² sans les baies, et des points espacés de %5 mm ; %6 m² n&#x27;ont pas été vus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>It faces azimuth %1 degrees. Its wall has %2 m² without openings, and points %3 mm apart; %4 m² were not seen.</source>
        <translation>Elle est orientée à l&#x27;azimut %1 degrés. Son mur a %2 m² sans les baies, et des points espacés de %3 mm ; %4 m² n&#x27;ont pas été vus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Facades of the cloud</source>
        <translation>Façades du nuage</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>FACADE takes a number of this table, FACADE_NEAR a point near a facade, FACADE_ALONG a line along it; ALL draws every one.</source>
        <translation>FACADE prend un numéro de ce tableau, FACADE_NEAR un point proche d&#x27;une façade, FACADE_ALONG une ligne qui la longe ; ALL les dessine toutes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Parts of the wall</source>
        <translation>Parties du mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Sizes in brackets have an edge that was not seen. Completed edges are where the openings of the same row have theirs.</source>
        <translation>Les dimensions entre parenthèses ont une arête qui n&#x27;a pas été vue. Les arêtes complétées sont là où les baies de la même rangée ont les leurs.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Left out</source>
        <translation>Écartés</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>LEFT_OUT is a layer of them.</source>
        <translation>LEFT_OUT en est une couche.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Elevation of a facade</source>
        <translation>Élévation d&#x27;une façade</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Key plan. The facade that is drawn is red; arrows show where facades face.</source>
        <translation>Plan de repérage. La façade dessinée est en rouge ; les flèches montrent l&#x27;orientation des façades.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Facade</source>
        <translation>Façade</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Azimuth (degrees)</source>
        <translation>Azimut (degrés)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Length (m)</source>
        <translation>Longueur (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Height (m)</source>
        <translation>Hauteur (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Area (m²)</source>
        <translation>Surface (m²)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Planes</source>
        <translation>Plans</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Seen by scanners before it</source>
        <translation>Vue par des scanners placés devant</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>In front of the main wall (m)</source>
        <translation>En avant du mur principal (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Use</source>
        <translation>Usage</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Width (m)</source>
        <translation>Largeur (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Sill (m)</source>
        <translation>Hauteur d&#x27;allège (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Depth (m)</source>
        <translation>Profondeur (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Edges measured</source>
        <translation>Arêtes mesurées</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <source>Completed</source>
        <translation>Complétées</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/output/templates/facade.html"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>the scanners that measured %1 % of the wall stood on that side</source>
        <translation>les scanners qui ont mesuré %1 % du mur étaient de ce côté</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>SIDE says so</source>
        <translation>SIDE l&#x27;indique</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>%1 m behind it a parallel surface, its inner face, covers %2 % of the wall, and one in front %3 %</source>
        <translation>à %1 m derrière, une surface parallèle, son parement intérieur, couvre %2 % du mur, et une devant %3 %</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>%1 % of the pixels with points close behind the wall lie in its holes, and %2 % of those close in front</source>
        <translation>%1 % des pixels avec des points juste derrière le mur sont dans ses trous, et %2 % de ceux juste devant</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/front.py"/>
        <source>most points far from the wall are on that side (%1 of %2), and its holes do not show which side is the front</source>
        <translation>la plupart des points loin du mur sont de ce côté (%1 sur %2), et ses trous ne montrent pas où est le devant</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>ceilings, or the area seen on each side, show where the open air is; the points close to the wall do not show its front</source>
        <translation>les plafonds, ou la surface vue de chaque côté, montrent où est l&#x27;extérieur ; les points proches du mur ne montrent pas où est le devant</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>The chosen facade has no plane with DISTANCE %1 m; increase DISTANCE, or choose another FACADE.</source>
        <translation>La façade choisie n&#x27;a pas de plan avec DISTANCE %1 m ; augmentez DISTANCE, ou choisissez un autre numéro pour FACADE.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>%1 points are in %2 cubes of %3 m.</source>
        <translation>%1 points sont dans %2 cubes de %3 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>The main plane covers %1 m².</source>
        <translation>Le plan principal couvre %1 m².</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>No upright plane was found in a cloud of %1 m; if the coordinates are in millimetres or feet, convert them to metres.</source>
        <translation>Aucun plan vertical n&#x27;a été trouvé dans un nuage de %1 m ; si les coordonnées sont en millimètres ou en pieds, convertissez-les en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>No upright plane of %1 m² or more was found with DISTANCE %2 m; increase DISTANCE, and check that z points up and that the coordinates are in metres.</source>
        <translation>Aucun plan vertical de %1 m² ou plus n&#x27;a été trouvé avec DISTANCE %2 m ; augmentez DISTANCE, et vérifiez que z est vers le haut et que les coordonnées sont en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/planes/segmentation.py"/>
        <source>Planes of fewer than %1 points are left out.</source>
        <translation>Les plans de moins de %1 points sont écartés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>The points of %1 reach over %2 m, more than the %3 m of any facade; cut the cloud to the facade, or check that its coordinates are metres.</source>
        <translation>Les points de %1 s&#x27;étendent sur %2 m, plus que les %3 m d&#x27;une façade ; découpez le nuage à la façade, ou vérifiez que ses coordonnées sont en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>The %1 points were thinned to %2, %3 mm apart; clip the cloud to the facade to keep more.</source>
        <translation>Les %1 points ont été éclaircis à %2, espacés de %3 mm ; découpez le nuage à la façade pour en garder plus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/points.py"/>
        <source>%1 has no %2, so the %3 of the other files is ignored.</source>
        <translation>Dans %1, il manque : %2 ; les données de %3 des autres fichiers sont donc ignorées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/facade/selection.py"/>
        <source>%1 facades were found; number %2 is measured: %3 m long, %4 m high, azimuth %5 degrees. FACADE takes another one.</source>
        <translation>%1 façades ont été trouvées ; la numéro %2 est mesurée : %3 m de long, %4 m de haut, azimut %5 degrés. FACADE en choisit une autre.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written because its folder does not exist; create it first.</source>
        <translation>%1 ne peut pas être écrit, car son dossier n&#x27;existe pas ; créez-le d&#x27;abord.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written because the disk is full; free some space or choose another folder.</source>
        <translation>%1 ne peut pas être écrit, car le disque est plein ; libérez de la place ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written; close it where it is open, or choose a folder that may be written to.</source>
        <translation>%1 ne peut pas être écrit ; fermez-le là où il est ouvert, ou choisissez un dossier accessible en écriture.</translation>
    </message>
    <message>
        <location filename="../../algorithms/files.py"/>
        <source>%1 cannot be written (%2); choose another name or folder.</source>
        <translation>%1 ne peut pas être écrit (%2) ; choisissez un autre nom ou dossier.</translation>
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
        <translation>nombre</translation>
    </message>
    <message>
        <location filename="../../algorithms/progress.py"/>
        <location filename="../../processing_provider/interruption.py"/>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/raster.py"/>
        <source>%1 was not written completely; free some space or choose another folder.</source>
        <translation>%1 n&#x27;a pas été écrit en entier ; libérez de la place ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The coordinate reference system of %1 is not understood; assign it again.</source>
        <translation>Le système de coordonnées de %1 n&#x27;est pas compris ; attribuez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>%1: this coordinate reference system is not understood; choose one with an EPSG code.</source>
        <translation>%1 : ce système de coordonnées n&#x27;est pas compris ; choisissez-en un avec un code EPSG.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The heights of %1 are in %2; convert them to metres.</source>
        <translation>Les altitudes de %1 sont en %2 ; convertissez-les en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The points of %1 lie outside the area of %2; choose the system that their coordinates have, or none if they are local.</source>
        <translation>Les points de %1 se trouvent hors de la zone de %2 ; choisissez le système de leurs coordonnées, ou aucun si elles sont locales.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>x and y of %1 seem to be swapped, because they lie in the area of %2 only the other way round; the plan would be mirrored, so write easting before northing.</source>
        <translation>x et y de %1 semblent intervertis, car ils ne tombent dans l&#x27;emprise de %2 qu&#x27;une fois échangés ; le plan serait inversé en miroir. Écrivez la coordonnée est avant la coordonnée nord.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The axes of %1, the system of %2, point %3 and %4, but plans show them to the right and up; reproject the points to a system of easting and northing.</source>
        <translation>Les axes de %1, le système de %2, pointent vers %3 et %4 (en anglais), mais les plans les montrent vers la droite et le haut ; reprojetez les points dans un système d&#x27;abscisses est et d&#x27;ordonnées nord.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>Lengths in %1, the system of %2, are %3 times those on the ground; reproject the points to a system such as UTM.</source>
        <translation>Les longueurs dans %1, le système de %2, sont %3 fois celles sur le terrain ; reprojetez les points dans un système tel que UTM.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>x and y of %1 seem to be swapped, because, if they are metres, x is a northing of %2 km and y an easting of %3 km; the plan would be mirrored, so write easting before northing.</source>
        <translation>x et y de %1 semblent permutés, parce que, s&#x27;ils sont en mètres, x est une ordonnée nord de %2 km et y une abscisse est de %3 km ; le plan serait en miroir, écrivez donc l&#x27;abscisse est avant l&#x27;ordonnée nord.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>The coordinates of %1 are %2 (%3); reproject to a projected coordinate reference system in metres.</source>
        <translation>Les coordonnées de %1 sont %2 (%3) ; reprojetez-les dans un système projeté en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>in degrees</source>
        <translation>en degrés</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>earth-centred</source>
        <translation>géocentriques</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>heights only</source>
        <translation>seulement des altitudes</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>not those of a map</source>
        <translation>pas celles d&#x27;une carte</translation>
    </message>
    <message>
        <location filename="../../algorithms/reference_systems.py"/>
        <source>in %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/block_adjustment.py"/>
        <source>%1 has too few points left</source>
        <translation>%1 n&#x27;a plus assez de points</translation>
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
        <translation>levé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The residuals of %1 are %2 times as large as the standard deviations of its targets and of the control points suggest (chi-square probability %3); look for wrong targets, or set CONTROL_SIGMA to how accurately the points were surveyed.</source>
        <translation>Les résidus de %1 sont %2 fois plus grands que ne le suggèrent les écarts-types de ses cibles et des points d&#x27;appui (probabilité du chi-deux %3) ; cherchez des cibles fausses, ou mettez CONTROL_SIGMA à la précision avec laquelle les points ont été levés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The residuals of %1 are %2 times as large as SIGMA suggests (chi-square probability %3); look for wrong targets, or set SIGMA to %4.</source>
        <translation>Les résidus de %1 sont %2 fois plus grands que ne le suggère SIGMA (probabilité du chi-deux %3) ; cherchez des cibles fausses, ou mettez SIGMA à %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/evaluation.py"/>
        <source>The targets of %1 have standard deviations of up to %2 mm, more than the limit of %3 mm; survey control points in it, or connect it to more scans.</source>
        <translation>Les cibles de %1 ont des écarts-types allant jusqu&#x27;à %2 mm, plus que la limite de %3 mm ; levez-y des points d&#x27;appui, ou reliez-le à d&#x27;autres scans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/least_squares.py"/>
        <source>a scan is held by nothing</source>
        <translation>un scan n&#x27;est tenu par rien</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>One unit of the scan is %1 m.</source>
        <translation>Une unité du scan vaut %1 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale does not differ significantly from 1; a model without scale suffices.</source>
        <translation>L&#x27;échelle ne diffère pas significativement de 1 ; un modèle sans échelle suffit.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale does not differ significantly from 1.</source>
        <translation>L&#x27;échelle ne diffère pas significativement de 1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>The scale differs from 1 by %1 ppm, %2 mm over the %3 m of the targets, which suggests</source>
        <translation>L&#x27;échelle diffère de 1 de %1 ppm, soit %2 mm sur les %3 m des cibles. Cause possible :</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 a wrong target, a SIGMA that is too small, or a scanner that needs calibration; if other scans have the same scale, keep the model with scale.</source>
        <translation>%1 une cible fausse, une valeur trop petite de SIGMA, ou un scanner à étalonner ; si d&#x27;autres scans ont la même échelle, gardez le modèle avec échelle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 a wrong target, a SIGMA that is too small, or a scanner that needs calibration; if other scans have the same scale, choose a model with scale.</source>
        <translation>%1 une cible fausse, une valeur trop petite de SIGMA, ou un scanner à étalonner ; si d&#x27;autres scans ont la même échelle, choisissez un modèle avec échelle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>keep the model with scale</source>
        <translation>gardez le modèle avec échelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>choose a model with scale, or reduce the distances</source>
        <translation>choisissez un modèle avec échelle, ou réduisez les distances</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/adjustment/scale_test.py"/>
        <source>%1 grid coordinates that are not reduced for the projection; %2.</source>
        <translation>%1 des coordonnées planes non corrigées de l&#x27;altération linéaire ; %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/covariances.py"/>
        <source>%1 of the %2 points in %3 count like points without standard deviations, because one of these is missing or not positive, or the correlations contradict each other.</source>
        <translation>%1 des %2 points de %3 comptent comme des points sans écarts-types, car l&#x27;un de ceux-ci manque ou n&#x27;est pas positif, ou les corrélations se contredisent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/covariances.py"/>
        <source>The standard deviations in %1 are %2 m in the median; check their unit.</source>
        <translation>Les écarts-types de %1 sont de %2 m en médiane ; vérifiez leur unité.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no table (.dbf) beside it, so its points have no names; copy all its parts.</source>
        <translation>%1 n&#x27;a pas de table (.dbf) à côté de lui, ses points n&#x27;ont donc pas de nom ; copiez toutes ses parties.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 is not a single point; remove it or split it up.</source>
        <translation>L&#x27;entité %1 de %2 n&#x27;est pas un point unique ; supprimez-la ou divisez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has more than %2 points, too many for a list; choose the list, not a cloud.</source>
        <translation>%1 a plus de %2 points, trop pour une liste ; choisissez la liste, et non un nuage.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 holds no points; choose another layer.</source>
        <translation>%1 ne contient aucun point ; choisissez une autre couche.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 has a coordinate that is not a number; correct or remove it.</source>
        <translation>L&#x27;entité %1 de %2 a une coordonnée qui n&#x27;est pas un nombre ; corrigez-la ou supprimez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>feature %1</source>
        <translation>entité %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no layer %2 of points; choose among: %3.</source>
        <translation>%1 n&#x27;a pas de couche de points %2 ; choisissez parmi : %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has no layer of points; choose another file.</source>
        <translation>%1 n&#x27;a pas de couche de points ; choisissez un autre fichier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 has several layers of points (%2); write %3|layername=%4.</source>
        <translation>%1 a plusieurs couches de points (%2) ; écrivez %3|layername=%4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>%1 cannot be read as a layer (%2); save it again.</source>
        <translation>%1 ne peut pas être lu comme couche (%2) ; enregistrez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>The points of %1 have no heights; give them Z values, or a field of numbers called z.</source>
        <translation>Les points de %1 n&#x27;ont pas d&#x27;altitude ; donnez-leur des valeurs Z, ou un champ numérique appelé z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Z is %1 everywhere in %2, so the heights are those of its field %3.</source>
        <translation>Z vaut partout %1 dans %2 ; les altitudes sont donc celles du champ %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Z is %1 at %2 points of %3, though its field %4 holds heights of some of them; correct Z, or fill in the field.</source>
        <translation>Z vaut %1 en %2 points de %3, alors que le champ %4 contient les altitudes de certains ; corrigez Z, ou remplissez le champ.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>0 or no height</source>
        <translation>0 ou sans altitude</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_layer.py"/>
        <source>Feature %1 of %2 has no name; give it one.</source>
        <translation>L&#x27;entité %1 de %2 n&#x27;a pas de nom ; donnez-lui-en un.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>The height of %1 in %2 is below %3 m, as of a point whose height is not known; correct it, or leave the point out.</source>
        <translation>La hauteur de %1 dans %2 est inférieure à %3 m, comme celle d’un point dont la hauteur n’est pas connue ; corrigez-la, ou retirez le point.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>Two points of %1 are called %2, in %3 and %4; rename or remove one of them.</source>
        <translation>Deux points de %1 s&#x27;appellent %2, en %3 et %4 ; renommez ou supprimez l&#x27;un d&#x27;eux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_list.py"/>
        <source>Points of %1 that are listed repeatedly count once: %2.</source>
        <translation>Les points de %1 listés plusieurs fois ne comptent qu&#x27;une fois : %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>name the columns in a first line, as &#x27;name x y z&#x27; or &#x27;x y z intensity&#x27;.</source>
        <translation>nommez les colonnes dans une première ligne : &#x27;name x y z&#x27; ou &#x27;x y z intensity&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>a list of points</source>
        <translation>une liste de points</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2, the last, is cut off; copy or export the list again.</source>
        <translation>La ligne %1 de %2, la dernière, est coupée ; copiez ou exportez la liste à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>coordinates</source>
        <translation>coordonnées</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>standard deviations</source>
        <translation>écarts-types</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 gives %2 in %3; they were converted to metres.</source>
        <translation>%1 donne %2 en %3 ; elles ont été converties en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Line %1 of %2 is neither a point like those below nor a header; correct it, or put # before it.</source>
        <translation>La ligne %1 de %2 n&#x27;est ni un point comme ceux qui suivent ni un en-tête ; corrigez-la, ou mettez # devant.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 has fewer than three columns of numbers; export it as name x y z.</source>
        <translation>%1 a moins de trois colonnes de nombres ; exportez-le sous la forme name x y z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>It is not clear which column of %1 holds the names; %2</source>
        <translation>On ne sait pas quelle colonne de %1 contient les noms ; %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>The first column of %1 can be names or coordinates; %2</source>
        <translation>La première colonne de %1 peut contenir des noms ou des coordonnées ; %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 seems to hold numbers of points with x and y but no z; add the heights, or name the columns in a first line, as &#x27;x y z&#x27;.</source>
        <translation>%1 semble contenir des numéros de points avec x et y mais sans z ; ajoutez les altitudes, ou nommez les colonnes dans une première ligne : &#x27;x y z&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>has no name</source>
        <translation>n&#x27;a pas de nom</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>name, x, y and z</source>
        <translation>name, x, y et z</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>x, y and z</source>
        <translation>x, y et z</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>, and their standard deviations,</source>
        <translation>, et leurs écarts-types,</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>Only %1 of %2 were read; its further columns were left out.</source>
        <translation>Seuls %1 de %2 ont été lus ; les autres colonnes ont été écartées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>All heights in %1 are 0; if they are not known, add them.</source>
        <translation>Toutes les hauteurs de %1 sont 0 ; si elles ne sont pas connues, ajoutez-les.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/lists/point_text.py"/>
        <source>%1 rows of %2, the first in line %3, begin as remarks do and were left out; remove the sign before them if they are points.</source>
        <translation>%1 lignes de %2, la première à la ligne %3, commencent comme des commentaires et ont été écartées ; retirez le signe qui les précède si ce sont des points.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/tables/units.py"/>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>the control list</source>
        <translation>la liste des points d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/reporting/maps.py"/>
        <source>units</source>
        <translation>unités</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit if the coordinates of %4 are in %5; convert them to metres.</source>
        <translation>%1 cibles sur %2 de %3 concordent si les coordonnées de %4 sont en %5 ; convertissez-les en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>tilted</source>
        <translation>incliné</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit if the scan is tilted by %4 degrees; choose a model that is not levelled, or correct the order of the axes (z is up).</source>
        <translation>%1 cibles sur %2 de %3 concordent si le scan est incliné de %4 degrés ; choisissez un modèle non nivelé, ou corrigez l&#x27;ordre des axes (z est vers le haut).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 fit with a scale error of %4 ppm, which suggests grid coordinates that are not reduced for the projection; choose a model with scale (MODEL=%5).</source>
        <translation>%1 cibles sur %2 de %3 concordent avec une erreur d&#x27;échelle de %4 ppm, ce qui suggère des coordonnées planes non corrigées de l&#x27;altération linéaire ; choisissez un modèle avec échelle (MODEL=%5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>By their names, %1 of %2 targets of %3 fit with a scale of %4; if the scan may have another scale than the control points, choose a model with scale (MODEL=%5), else check units and control list.</source>
        <translation>D&#x27;après leurs noms, %1 cibles sur %2 de %3 concordent avec une échelle de %4 ; si le scan peut avoir une autre échelle que les points d&#x27;appui, choisissez un modèle avec échelle (MODEL=%5), sinon vérifiez les unités et la liste des points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>misfit</source>
        <translation>discordant</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>By their names, the targets of %1 do not fit the control points, but by their distances %2 of %3 do; correct the names, or match by distances.</source>
        <translation>D&#x27;après leurs noms, les cibles de %1 ne concordent pas avec les points d&#x27;appui, mais d&#x27;après leurs distances, %2 sur %3 concordent ; corrigez les noms, ou appariez par les distances.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>The targets of %1 do not fit the control points of their names: fewer than %2 of them agree within %3 in their distances; correct the names, or raise SIGMA or TOLERANCE.</source>
        <translation>Les cibles de %1 ne concordent pas avec les points d&#x27;appui de même nom : moins de %2 d&#x27;entre elles s&#x27;accordent à %3 près dans leurs distances ; corrigez les noms, ou augmentez SIGMA ou TOLERANCE.</translation>
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
        <translation>sans recouvrement</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>Fewer than %1 of %2 targets of %3 have the distances of control points within %4, and so few may match by accident; check that the list belongs to this site, pick more targets, or raise SIGMA or TOLERANCE.</source>
        <translation>Moins de %1 cibles sur %2 de %3 ont, à %4 près, des distances de points d&#x27;appui, et si peu peuvent concorder par hasard ; vérifiez que la liste appartient à ce site, pointez plus de cibles, ou augmentez SIGMA ou TOLERANCE.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>mirrored</source>
        <translation>inversé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>chance</source>
        <translation>hasard</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/diagnosis.py"/>
        <source>%1 of %2 targets of %3 match, but %4 accidental matches of as many are expected; pick more targets, or match by names.</source>
        <translation>%1 cibles sur %2 de %3 concordent, mais %4 appariements fortuits d&#x27;autant de cibles sont à attendre ; pointez plus de cibles, ou appariez par les noms.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1 is tilted by %2 degrees; if the scanner stood upright, the axes of a list are in another order (z is up).</source>
        <translation>%1 est incliné de %2 degrés ; si le scanner était d&#x27;aplomb, les axes d&#x27;une liste sont dans un autre ordre (z est vers le haut).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>The matched targets of %1 lie in one plane or symmetrically, so that a mirrored list would fit as well (%2); check the position of the scanner in the report, or add a target.</source>
        <translation>Les cibles appariées de %1 sont dans un plan ou symétriques, de sorte qu&#x27;une liste inversée en miroir concorderait aussi bien (%2) ; vérifiez la position du scanner dans le rapport, ou ajoutez une cible.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>The search for the targets of %1 was ended before all triangles were tried, because there are too many; a solution with more targets may exist. Shorten the lists to make sure.</source>
        <translation>La recherche des cibles de %1 a été arrêtée avant l&#x27;essai de tous les triangles, car ils sont trop nombreux ; une solution avec plus de cibles peut exister. Raccourcissez les listes pour en être sûr.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>Target %1 of %2 lies %3 m from the control point of its name</source>
        <translation>La cible %1 de %2 est à %3 m du point d&#x27;appui de même nom</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>, but %1 m from %2: its name is wrong</source>
        <translation>, mais à %1 m de %2 : son nom est faux</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1; it was left out.</source>
        <translation>%1 ; elle a été écartée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>%1 is %2</source>
        <translation>%1 est %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/match_warnings.py"/>
        <source>According to the distances, these names in %1 are wrong: %2.</source>
        <translation>D&#x27;après les distances, ces noms de %1 sont faux : %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>x and y are swapped, or an axis is reversed</source>
        <translation>x et y sont intervertis, ou un axe est inversé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>x and y are swapped, or one of them is reversed</source>
        <translation>x et y sont intervertis, ou l&#x27;un des deux est inversé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>z is reversed</source>
        <translation>z est inversé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/mirror_images.py"/>
        <source>%1 of %2 targets of %3 fit the mirror image of the control points: in one of the two lists %4; correct it.</source>
        <translation>%1 cibles sur %2 de %3 concordent avec l&#x27;image en miroir des points d&#x27;appui : dans l&#x27;une des deux listes, %4 ; corrigez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>too few</source>
        <translation>trop peu</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 has %2 target, but %3 needs at least %4; pick more targets.</source>
        <translation>%1 a %2 cible, mais %3 en demande au moins %4 ; pointez plus de cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 has %2 targets, but %3 needs at least %4; pick more targets.</source>
        <translation>%1 a %2 cibles, mais %3 en demande au moins %4 ; pointez plus de cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>coincident</source>
        <translation>confondus</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets %1 and %2 of %3 have the same position; remove one of them.</source>
        <translation>Les cibles %1 et %2 de %3 ont la même position ; supprimez l&#x27;une d&#x27;elles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>above each other</source>
        <translation>l&#x27;une au-dessus de l&#x27;autre</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>on a line</source>
        <translation>sur une droite</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>collinear</source>
        <translation>alignés</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets of %1 lie %2, which leaves the rotation about it unknown; add a target beside it.</source>
        <translation>Les cibles de %1 sont %2, ce qui laisse inconnue la rotation autour d&#x27;elle ; ajoutez une cible à côté.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>Of the targets of %1, %2 have the name of a control point, but %3 needs at least %4; correct the names, or match by distances.</source>
        <translation>Parmi les cibles de %1, %2 ont le nom d&#x27;un point d&#x27;appui, mais %3 en demande au moins %4 ; corrigez les noms, ou appariez par les distances.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>too many</source>
        <translation>trop</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>With an unknown scale at most %1 control points can be searched, and there are %2; shorten the list to the surroundings of %3, or match by names.</source>
        <translation>Avec une échelle inconnue, on peut chercher parmi %1 points d&#x27;appui au plus, et il y en a %2 ; réduisez la liste aux environs de %3, ou appariez par les noms.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>a levelled scan</source>
        <translation>un scan nivelé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>a scan</source>
        <translation>un scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 matches of %2 leave no redundancy to check the solution; pick more targets, or match by names.</source>
        <translation>%1 appariements de %2 ne laissent aucune redondance pour contrôler la solution ; pointez plus de cibles, ou appariez par les noms.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>%1 targets of %2 are too few for %3 control points: %4 accidental matches are expected; pick more targets, shorten the control list to the surroundings, or match by names.</source>
        <translation>%1 cibles de %2 sont trop peu pour %3 points d&#x27;appui : %4 appariements fortuits sont à attendre ; pointez plus de cibles, réduisez la liste des points d&#x27;appui aux environs, ou appariez par les noms.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>, or match by names</source>
        <translation>, ou appariez par les noms</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The search for the %1 targets of %2 among %3 control points was ended, because too many triangles are similar; remove targets that are not control points, or shorten the control list%4.</source>
        <translation>La recherche des %1 cibles de %2 parmi %3 points d&#x27;appui a été arrêtée, car trop de triangles se ressemblent ; supprimez les cibles qui ne sont pas des points d&#x27;appui, ou raccourcissez la liste des points d&#x27;appui%4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>nearly above each other</source>
        <translation>presque l&#x27;une au-dessus de l&#x27;autre</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>nearly on a line</source>
        <translation>presque sur une droite</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The matched targets of %1 lie %2, which leaves the rotation about it uncertain by %3 degrees; add a target beside it.</source>
        <translation>Les cibles appariées de %1 sont %2, ce qui laisse la rotation incertaine de %3 degrés ; ajoutez une cible à côté.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>; and %1 more</source>
        <translation> ; et %1 de plus</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>ambiguous</source>
        <translation>ambigu</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/matching/refusals.py"/>
        <source>The targets of %1 fit the control points in %2 equally good ways (%3%4); add a target that breaks the symmetry%5.</source>
        <translation>Les cibles de %1 concordent avec les points d&#x27;appui de %2 façons aussi bonnes (%3%4) ; ajoutez une cible qui rompt la symétrie%5.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <location filename="../../algorithms/targets/output/layer.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>scan</source>
        <translation>scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/layers.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <source>scans</source>
        <translation>scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>rigid</source>
        <translation>rigide</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>with a scale near 1</source>
        <translation>avec une échelle proche de 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>levelled</source>
        <translation>nivelé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>levelled with a scale near 1</source>
        <translation>nivelé, avec une échelle proche de 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Probability</source>
        <translation>Probabilité</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>95 % ellipse, ellipsoid</source>
        <translation>Ellipse et ellipsoïde à 95 %</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Accidental matches</source>
        <translation>Appariements fortuits</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Round</source>
        <translation>Passe</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Shared surfaces</source>
        <translation>Surfaces communes</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Residual: the transformed target minus its control point, along x, y and z of the control points, and its length.</source>
        <translation>Résidu : la cible transformée moins son point d&#x27;appui, selon x, y et z des points d&#x27;appui, et sa longueur.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Standard deviation of unit weight a posteriori over a priori: 1 if the residuals are as large as SIGMA says.</source>
        <translation>Écart-type de l&#x27;unité de poids a posteriori sur a priori : 1 si les résidus sont aussi grands que l&#x27;indique SIGMA.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Of the chi-square test: how often v&#x27;Pv is as large or larger if the a priori standard deviations hold. The verdict is on a level of %1 %, both sides together.</source>
        <translation>Du test du chi-deux : fréquence à laquelle v&#x27;Pv est aussi grand ou plus grand si les écarts-types a priori sont justes. Le verdict porte sur un niveau de %1 %, les deux côtés ensemble.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Redundancy number, 0 to 1: the part of an error of a coordinate that its residual shows.</source>
        <translation>Part de redondance, de 0 à 1 : la part d&#x27;une erreur d&#x27;une coordonnée que montre son résidu.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Baarda&#x27;s normalized residual, by the a priori standard deviation; suspected beyond %1 (%2 = %3).</source>
        <translation>Résidu normé de Baarda, d&#x27;après l&#x27;écart-type a priori ; suspect au-delà de %1 (%2 = %3).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Pope&#x27;s studentized residual, by the a posteriori standard deviation of the scan; its limit (%1 = %2) depends on the redundancy.</source>
        <translation>Résidu studentisé de Pope, d&#x27;après l&#x27;écart-type a posteriori du scan ; sa limite (%1 = %2) dépend de la redondance.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Minimal detectable bias: the smallest error of a coordinate that the w-test finds with a power of %1 % (%2 = %3).</source>
        <translation>Plus petite erreur détectable : la plus petite erreur d&#x27;une coordonnée que le test w trouve avec une puissance de %1 % (%2 = %3).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Semi-axes are %1 (plane) and %2 (space) standard deviations.</source>
        <translation>Les demi-axes mesurent %1 (plan) et %2 (espace) écarts-types.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>How many are expected of as many targets, if the scan had nothing to do with the control points.</source>
        <translation>Combien on en attend d&#x27;autant de cibles, si le scan n&#x27;avait rien à voir avec les points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>1 if surveyed points sufficed to register the scan, 2 if it needed points appended in round 1, and so on.</source>
        <translation>1 si les points levés ont suffi à recaler le scan, 2 s&#x27;il a fallu des points nouveaux de la passe 1, et ainsi de suite.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>Patches of about a metre that two scans share; overlap: the part of the surface of the scan with less that the other has too; distance: how far the patches of both lie apart after the adjustment, root mean square; slides: whether they leave a direction free, which only targets or other scans hold.</source>
        <translation>Morceaux de surface d&#x27;environ un mètre que deux scans ont en commun ; recouvrement : la part des surfaces du scan qui en a le moins que l&#x27;autre a aussi ; distance : l&#x27;écart des morceaux des deux après la compensation, en moyenne quadratique ; glisse : s&#x27;ils laissent libre une direction que seuls des cibles ou d&#x27;autres scans tiennent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>What the targets say about the scale, in parts per million from 1, whether or not it was estimated.</source>
        <translation>Ce que les cibles disent de l&#x27;échelle, en millionièmes d&#x27;écart à 1, qu&#x27;elle ait été estimée ou non.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans are registered, by their surfaces alone.</source>
        <translation>%1 scans sur %2 sont recalés, par leurs surfaces seules.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans is registered; the longest residual is %3 mm. Global test of all scans together: %4</source>
        <translation>%1 scan sur %2 est recalé ; le plus grand résidu est de %3 mm. Test global de tous les scans ensemble : %4</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1 of %2 scans are registered; the longest residual is %3 mm. Global test of all scans together: %4</source>
        <translation>%1 scans sur %2 sont recalés ; le plus grand résidu est de %3 mm. Test global de tous les scans ensemble : %4</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>matching</source>
        <translation>appariement</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>by names</source>
        <translation>par les noms</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>by distances</source>
        <translation>par les distances</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>transformation</source>
        <translation>transformation</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>%1, %2 parameters</source>
        <translation>%1, %2 paramètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>standard deviation of a target without its own</source>
        <translation>écart-type d&#x27;une cible qui n&#x27;a pas le sien</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>standard deviation of a control point</source>
        <translation>écart-type d&#x27;un point d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>tolerance of distances</source>
        <translation>tolérance sur les distances</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>coordinate reference system</source>
        <translation>système de coordonnées de référence</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>0, held fixed</source>
        <translation>0, tenu fixe</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>derived</source>
        <translation>déduit</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <source>chosen</source>
        <translation>choisi</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report.py"/>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <location filename="../../algorithms/tables/column_names.py"/>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>, with 95 % ellipses drawn %1 times too large</source>
        <translation>, avec les ellipses à 95 % agrandies %1 fois</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Plan (figure 6 of the paper). Triangles: stations, with lines to the points that they use. Blue: surveyed points. Violet: points appended from scans%1. Where there is no room, names are left out.</source>
        <translation>Plan (figure 6 de l&#x27;article). Triangles : stations, avec des traits vers les points qu&#x27;elles utilisent. Bleu : points levés. Violet : points nouveaux issus des scans%1. Faute de place, des noms sont omis.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Crosses: rejected targets.</source>
        <translation>Croix : cibles rejetées.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_figures.py"/>
        <source>Plan (figure 6). Arrows: horizontal residuals, drawn %1 times too large, from control point to target. Blue: surveyed, violet: appended, grey: points that %2 does not use.%3</source>
        <translation>Plan (figure 6). Flèches : résidus horizontaux, agrandis %1 fois, du point d&#x27;appui à la cible. Bleu : levés, violet : nouveaux, gris : points que %2 n&#x27;utilise pas.%3</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Its frame is that of all scans, because there are no control points.</source>
        <translation>Son repère est celui de tous les scans, parce qu&#x27;il n&#x27;y a pas de points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>nothing is redundant, so nothing is checked.</source>
        <translation>rien n&#x27;est redondant, donc rien n&#x27;est contrôlé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>(sigma0 %1, redundancy %2, v&#x27;Pv %3, chi-square probability %4)</source>
        <translation>(sigma0 %1, redondance %2, v&#x27;Pv %3, probabilité du chi-deux %4)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals are larger than the a priori standard deviations allow %1.</source>
        <translation>les résidus sont plus grands que ne le permettent les écarts-types a priori %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals are smaller than the a priori standard deviations suggest %1.</source>
        <translation>les résidus sont plus petits que ne le suggèrent les écarts-types a priori %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>the residuals agree with the a priori standard deviations %1.</source>
        <translation>les résidus s&#x27;accordent avec les écarts-types a priori %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Registered in round %1 with %2 of %3 targets, of which %4 are surveyed points.</source>
        <translation>Recalé à la passe %1 avec %2 cibles sur %3, dont %4 points levés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Expected accidental matches of so many targets: %1.</source>
        <translation>Appariements fortuits attendus d&#x27;autant de cibles : %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Standard deviation of the scanner: %1 mm.</source>
        <translation>Écart-type du scanner : %1 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Largest standard deviation at a target: %1 mm.</source>
        <translation>Plus grand écart-type à une cible : %1 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Appended to the control points: %1.</source>
        <translation>Ajoutés aux points d&#x27;appui comme points nouveaux : %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Placed by surfaces: %1 patches agree with %2, and %3 contradict them.</source>
        <translation>Placé par les surfaces : %1 morceaux concordent avec %2, et %3 les contredisent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>%1 of its targets lie on known points.</source>
        <translation>%1 de ses cibles se trouvent sur des points connus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>No other pose was found.</source>
        <translation>Aucune autre pose n&#x27;a été trouvée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>At the next best pose, the scanner %1 m away and turned by %2 degrees, %3 agree and %4 contradict.</source>
        <translation>À la deuxième meilleure pose, avec le scanner à %1 m et tourné de %2 degrés, %3 concordent et %4 contredisent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Surfaces would move its targets by up to %1 mm, %2 standard deviations, and are not used; by the targets alone, the largest standard deviation is %3 mm.</source>
        <translation>Les surfaces déplaceraient ses cibles de %1 mm au plus, %2 écarts types, et ne sont pas utilisées ; d&#x27;après les seules cibles, le plus grand écart type est de %3 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>Surfaces moved its targets by up to %1 mm, %2 standard deviations; by the targets alone, the largest standard deviation is %3 mm.</source>
        <translation>Les surfaces ont déplacé ses cibles de %1 mm au plus, %2 écarts types ; d&#x27;après les seules cibles, le plus grand écart type est de %3 mm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>appended</source>
        <translation>nouveau</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/report_scan.py"/>
        <source>%1 = %2 was rejected: it is %3 m off, |w| %4.</source>
        <translation>%1 = %2 a été rejetée : écart de %3 m, |w| %4.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Solutions that are as good as each other, target = control point:</source>
        <translation>Solutions aussi bonnes les unes que les autres, cible = point d&#x27;appui :</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Parameters, scan to control points</source>
        <translation>Paramètres, du scan aux points d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Residuals</source>
        <translation>Résidus</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Reliability</source>
        <translation>Fiabilité</translation>
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
        <translation>Réglages</translation>
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
        <translation>Points d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Registration of scans</source>
        <translation>Recalage de scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Global test: %1</source>
        <translation>Test global : %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Components of the residuals, target minus control point (figure 7). The value is written at a bar that is cut. The name of a rejected target is red.</source>
        <translation>Composantes des résidus, cible moins point d&#x27;appui (figure 7). La valeur est écrite au bout d&#x27;une barre coupée. Le nom d&#x27;une cible rejetée est en rouge.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Components of the residuals, target minus control point (figure 7).</source>
        <translation>Composantes des résidus, cible moins point d&#x27;appui (figure 7).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Lengths of the residuals (figure 8).</source>
        <translation>Longueurs des résidus (figure 8).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>standard deviation</source>
        <translation>écart-type</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Correlations</source>
        <translation>Corrélations</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>control point</source>
        <translation>point d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>origin</source>
        <translation>origine</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Millimetres; a, b, c: semi-axes of the 95 % ellipsoid of the transformed target. Red: rejected.</source>
        <translation>Millimètres ; a, b, c : demi-axes de l&#x27;ellipsoïde à 95 % de la cible transformée. Rouge : rejetée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Red: redundancy number below %1, |w| above %2, |τ| above %3, or rejected. MDB in millimetres.</source>
        <translation>Rouge : part de redondance inférieure à %1, |w| supérieur à %2, |τ| supérieur à %3, ou rejetée. MDB en millimètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>status</source>
        <translation>statut</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>targets</source>
        <translation>cibles</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>matched</source>
        <translation>appariées</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>rejected</source>
        <translation>rejetées</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>in round</source>
        <translation>passe</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>probability</source>
        <translation>probabilité</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>longest v (mm)</source>
        <translation>v maximal (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>scale (ppm)</source>
        <translation>échelle (ppm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>accidental matches</source>
        <translation>appariements fortuits</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>setting</source>
        <translation>réglage</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>other scan</source>
        <translation>autre scan</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>patches</source>
        <translation>morceaux</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>overlap (%)</source>
        <translation>recouvrement (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>distance (mm)</source>
        <translation>écart (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>slides</source>
        <translation>glisse</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Surfaces that tie the scans to each other.</source>
        <translation>Surfaces qui relient les scans entre eux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/templates/registration.html"/>
        <source>Coordinates in metres, their standard deviations in millimetres; how many scans use the point.</source>
        <translation>Coordonnées en mètres, leurs écarts-types en millimètres ; nombre de scans qui utilisent le point.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is too large; choose the TRANSFORMS of registerscans.</source>
        <translation>%1 est trop grand ; choisissez le fichier TRANSFORMS de registerscans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 cannot be read (%2); check that it exists and may be read.</source>
        <translation>%1 ne peut pas être lu (%2) ; vérifiez qu&#x27;il existe et qu&#x27;il peut être lu.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is not json (%2); choose the TRANSFORMS of registerscans.</source>
        <translation>%1 n&#x27;est pas du JSON (%2) ; choisissez le fichier TRANSFORMS de registerscans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 lists no scans; choose the TRANSFORMS of registerscans.</source>
        <translation>%1 ne liste aucun scan ; choisissez le fichier TRANSFORMS de registerscans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 lists the scan %2 twice; remove one entry.</source>
        <translation>%1 liste deux fois le scan %2 ; supprimez une entrée.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 gives matrices in %2; write shifts in metres.</source>
        <translation>%1 donne des matrices en %2 ; écrivez les translations en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>Scan number %1 in %2 has no name; give it the name of its cloud.</source>
        <translation>Le scan numéro %1 de %2 n&#x27;a pas de nom ; donnez-lui le nom de son nuage.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The matrix of the scan %1 in %2 %3; register the scan again.</source>
        <translation>La matrice du scan %1 de %2 %3 ; recalez le scan à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>is not four rows of four numbers</source>
        <translation>ne compte pas quatre lignes de quatre nombres</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>does not end in the row 0 0 0 1</source>
        <translation>ne se termine pas par la ligne 0 0 0 1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>moves the scan by %1 m</source>
        <translation>déplace le scan de %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>mirrors the scan</source>
        <translation>inverse le scan en miroir</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>has a scale of %1</source>
        <translation>a une échelle de %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>distorts the scan because its rotation is not orthogonal</source>
        <translation>déforme le scan, car sa rotation n&#x27;est pas orthogonale</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The coordinate reference system in %1 cannot be understood; write it as WKT or like EPSG:25832.</source>
        <translation>Le système de coordonnées de %1 n&#x27;est pas compréhensible ; écrivez-le en WKT ou comme EPSG:25832.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>the control points in %1</source>
        <translation>les points d&#x27;appui de %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>The only scan in %1, %2, is used for %3.</source>
        <translation>Le seul scan de %1, %2, est utilisé pour %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>There is no scan for %1 in %2, only %3; name the cloud after its scan.</source>
        <translation>Il n&#x27;y a pas de scan pour %1 dans %2, seulement %3 ; donnez au nuage le nom de son scan.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is left out because its scan %2 is not registered in %3 (%4: %5).</source>
        <translation>%1 est écarté, car son scan %2 n&#x27;est pas recalé dans %3 (%4 : %5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>%1 is left out because its scan %2 is not registered in %3 (%4%5).</source>
        <translation>%1 est écarté, car son scan %2 n&#x27;est pas recalé dans %3 (%4%5).</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/output/transforms.py"/>
        <source>Register at least one of them.</source>
        <translation>Recalez-en au moins un.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Adjusting all scans in one block</source>
        <translation>Compensation de tous les scans en un bloc</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Two lists of targets are called %1; rename one, because their names identify the scans.</source>
        <translation>Deux listes de cibles s&#x27;appellent %1 ; renommez-en une, car leurs noms identifient les scans.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>No list of targets was given; choose at least one.</source>
        <translation>Aucune liste de cibles n&#x27;a été donnée ; choisissez-en au moins une.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>%1 has %2 control points, but at least %3 are needed; add some.</source>
        <translation>%1 a %2 points d&#x27;appui, mais il en faut au moins %3 ; ajoutez-en.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>Targets have standard deviations of their own, so control points are not held fixed but count with SIGMA, %1 mm; set CONTROL_SIGMA to the standard deviation of the survey.</source>
        <translation>Des cibles ont leurs propres écarts-types ; les points d&#x27;appui ne sont donc pas tenus fixes mais comptent avec SIGMA, %1 mm ; mettez CONTROL_SIGMA à l&#x27;écart-type du levé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>%1 control points were appended by an earlier registration (%2); they count with their standard deviations, as if these were independent.</source>
        <translation>%1 points d&#x27;appui sont des points nouveaux d&#x27;un recalage antérieur (%2) ; ils comptent avec leurs écarts-types, comme si ceux-ci étaient indépendants.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/registration.py"/>
        <source>The control points %1 and %2 are %3 mm apart, too close to distinguish them; only one is used.</source>
        <translation>Les points d&#x27;appui %1 et %2 sont distants de %3 mm, trop proches pour être distingués ; un seul est utilisé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/results.py"/>
        <source>registered</source>
        <translation>recalé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>Matching %1</source>
        <translation>Appariement de %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>Searching why %1 does not match</source>
        <translation>Recherche de la raison pour laquelle %1 ne concorde pas</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/sequential_registration.py"/>
        <source>%1 has no targets.</source>
        <translation>%1 n&#x27;a pas de cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <location filename="../../algorithms/registration/simulation/trials.py"/>
        <source>success</source>
        <translation>succès</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>wrong labels</source>
        <translation>noms faux</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>incomplete</source>
        <translation>incomplet</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>Registering %1 simulated scans</source>
        <translation>Recalage de %1 scans simulés</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>TARGETS_PER_SCAN is %1, but MODEL needs at least %2; raise it.</source>
        <translation>TARGETS_PER_SCAN vaut %1, mais MODEL en demande au moins %2 ; augmentez-le.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>%1 has %2 points, but TARGETS_PER_SCAN is %3; lower it, or survey more control points.</source>
        <translation>%1 a %2 points, mais TARGETS_PER_SCAN vaut %3 ; diminuez-le, ou levez plus de points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>No control point of %1 has %2 others within REACH, %3 m; raise it, or lower TARGETS_PER_SCAN.</source>
        <translation>Aucun point d&#x27;appui de %1 n&#x27;en a %2 autres dans REACH, %3 m ; augmentez-le, ou diminuez TARGETS_PER_SCAN.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation.py"/>
        <source>These control points are in no trial because too few others are within REACH: %1.</source>
        <translation>Ces points d&#x27;appui ne sont dans aucun essai, car trop peu d&#x27;autres sont dans REACH : %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets fit the control points in several ways that are equally good.</source>
        <translation>Les cibles concordent avec les points d&#x27;appui de plusieurs façons aussi bonnes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>So few targets agree with some control points by accident too.</source>
        <translation>Si peu de cibles concordent aussi par hasard avec des points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets lie on a line, or above each other in a levelled model.</source>
        <translation>Les cibles sont sur une droite, ou l&#x27;une au-dessus de l&#x27;autre dans un modèle nivelé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Two targets have the same position.</source>
        <translation>Deux cibles ont la même position.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets lie in one plane and fit other control points as in a mirror.</source>
        <translation>Les cibles sont dans un plan et concordent, en miroir, avec d&#x27;autres points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The targets leave no redundancy to check their match.</source>
        <translation>Les cibles ne laissent aucune redondance pour contrôler leur appariement.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The noise hid which targets are which.</source>
        <translation>Le bruit a masqué l&#x27;identité des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>The pose is right, but a target was given no control point.</source>
        <translation>L&#x27;orientation est juste, mais une cible n&#x27;a reçu aucun point d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>A target was given another control point than its own.</source>
        <translation>Une cible a reçu un autre point d&#x27;appui que le sien.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some control points can be confused with each other, because the distances among them repeat: move targets that are listed below, or add one that breaks the symmetry.</source>
        <translation>Certains points d&#x27;appui peuvent être confondus, car leurs distances mutuelles se répètent : déplacez les cibles listées ci-dessous, ou ajoutez-en une qui rompt la symétrie.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some scans had too few targets to be sure: pick one or two more in each scan.</source>
        <translation>Certains scans avaient trop peu de cibles pour être sûrs : pointez-en une ou deux de plus dans chaque scan.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>Some scans had all targets in a row: put targets at different heights and sides.</source>
        <translation>Certains scans avaient toutes leurs cibles alignées : placez des cibles à des hauteurs et sur des côtés différents.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>shift, the scanner&#x27;s position (mm)</source>
        <translation>translation, position du scanner (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/simulation_report.py"/>
        <source>rotation (0.001 degrees)</source>
        <translation>rotation (0.001 degré)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>In %1 of %2 trials (%3%) all %4 targets were given their control points; in %5, a wrong one.</source>
        <translation>Dans %1 essais sur %2 (%3 %), les %4 cibles ont toutes reçu leur point d&#x27;appui ; dans %5, un point faux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Failures</source>
        <translation>Échecs</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Points confused with each other</source>
        <translation>Points confondus</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>%1 of %2 control points are concerned, most often these, with the number of trials: %3.</source>
        <translation>%1 points d&#x27;appui sur %2 sont concernés, le plus souvent ceux-ci, avec le nombre d&#x27;essais : %3.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>No control points were confused with each other.</source>
        <translation>Aucun point d&#x27;appui n&#x27;a été confondu avec un autre.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Errors of the transformations</source>
        <translation>Erreurs des transformations</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Estimated against true, in the trials that succeeded.</source>
        <translation>Valeurs estimées contre valeurs vraies, dans les essais réussis.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>What was simulated</source>
        <translation>Ce qui a été simulé</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Each trial is a scan of %1 random control points from the whole list, of %2 in all.</source>
        <translation>Chaque essai est un scan de %1 points d&#x27;appui pris au hasard dans toute la liste, sur %2 en tout.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Each trial is a scan of %1 random control points within %2 m of one of them, of %3 in all.</source>
        <translation>Chaque essai est un scan de %1 points d&#x27;appui pris au hasard à moins de %2 m de l&#x27;un d&#x27;eux, sur %3 en tout.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about the vertical, at a scale from 0.1 to 10.</source>
        <translation>Le scanner est placé parmi eux, tourné au hasard autour de la verticale, à une échelle de 0.1 à 10.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about the vertical.</source>
        <translation>Le scanner est placé parmi eux, tourné au hasard autour de la verticale.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about any axis, at a scale from 0.1 to 10.</source>
        <translation>Le scanner est placé parmi eux, tourné au hasard autour d&#x27;un axe quelconque, à une échelle de 0.1 à 10.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The scanner stands among them, turned at random about any axis.</source>
        <translation>Le scanner est placé parmi eux, tourné au hasard autour d&#x27;un axe quelconque.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Every coordinate has normal noise of %1 mm, and distances from the centroid of the targets are %2 ppm too long.</source>
        <translation>Chaque coordonnée a un bruit normal de %1 mm, et les distances au centre de gravité des cibles sont trop longues de %2 ppm.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>MODEL is %1, SEED %2.</source>
        <translation>MODEL est %1, SEED %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Simulated registration with %1</source>
        <translation>Recalage simulé avec %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>outcome</source>
        <translation>résultat</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>trials</source>
        <translation>essais</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>share</source>
        <translation>part</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>meaning</source>
        <translation>signification</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>confused with</source>
        <translation>confondu avec</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>distance (m)</source>
        <translation>distance (m)</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The first %1 of %2 pairs.</source>
        <translation>Les %1 premières paires sur %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>The control points from above. Red ones are confused with others, lines join the pairs of the table.</source>
        <translation>Les points d&#x27;appui vus de dessus. Les rouges sont confondus avec d&#x27;autres, les traits relient les paires du tableau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>median</source>
        <translation>médiane</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>largest</source>
        <translation>maximum</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Distribution of %1.</source>
        <translation>Distribution : %1.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>from the whole list</source>
        <translation>de toute la liste</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>within %1 m of one of them</source>
        <translation>à moins de %1 m de l&#x27;un d&#x27;eux</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>about the vertical</source>
        <translation>autour de la verticale</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>about any axis</source>
        <translation>autour d&#x27;un axe quelconque</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>, at a scale from 0.1 to 10</source>
        <translation>, à une échelle de 0.1 à 10</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>References</source>
        <translation>Références</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/simulation/templates/simulation.html"/>
        <source>Herbig, Mayer, Mortada and Rasztovits 2013, chapter 5: results and simulation.</source>
        <translation>Herbig, Mayer, Mortada et Rasztovits 2013, chapitre 5 : résultats et simulation.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/adjustment.py"/>
        <source>No other scan could be placed beside %1, whose frame would be that of all; see why not, or choose another scan as the first.</source>
        <translation>Aucun autre scan n&#x27;a pu être placé à côté de %1, dont le repère serait celui de tous ; voyez pourquoi, ou choisissez un autre scan comme premier.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>%1 cannot be placed by surfaces, because its cloud does not show where the scanner stood; give it in the frame of the scanner, or as an E57 or PTX file with its pose, or pick targets.</source>
        <translation>%1 ne peut pas être placé par les surfaces, parce que son nuage ne montre pas où se trouvait le scanner ; donnez-le dans le repère du scanner, ou comme fichier E57 ou PTX avec sa pose, ou pointez des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 fit better as in a mirror; correct its cloud if two columns are swapped or an axis points the other way, or else pick targets.</source>
        <translation>Les surfaces de %1 conviennent mieux comme dans un miroir ; corrigez son nuage si deux colonnes sont permutées ou si un axe pointe dans l&#x27;autre sens, sinon pointez des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 do not place it: at best, %2 patches agree with other scans and %3 contradict them; at least %4 must agree, and hardly any contradict; scan with more overlap, or pick targets.</source>
        <translation>Les surfaces de %1 ne fixent pas sa pose : au mieux, %2 morceaux concordent avec d&#x27;autres scans et %3 les contredisent ; il faut qu&#x27;au moins %4 concordent et que presque aucun ne contredise ; scannez avec plus de recouvrement, ou pointez des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>sliding</source>
        <translation>glissant</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>%1 slides along the surfaces that it shares with other scans, %2; scan it from where a wall across is seen too, or pick a target.</source>
        <translation>%1 glisse le long des surfaces qu&#x27;il partage avec d&#x27;autres scans, %2 ; scannez-le d&#x27;où l&#x27;on voit aussi un mur en travers, ou pointez une cible.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/placement.py"/>
        <source>The surfaces of %1 agree with other scans at two poses about as well: %2 patches agree and %3 do not, or %4 and %5 with the scanner %6 m away and turned by %7 degrees; pick a target, or choose a levelled model if the scanner was levelled.</source>
        <translation>Les surfaces de %1 concordent avec d&#x27;autres scans à deux poses à peu près aussi bien : %2 morceaux concordent et %3 non, ou %4 et %5 avec le scanner à %6 m et tourné de %7 degrés ; pointez une cible, ou choisissez un modèle calé si le scanner était calé.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 is held by nothing</source>
        <translation>%1 n&#x27;est tenu par rien</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>Tying scans by their surfaces</source>
        <translation>Liaison des scans par leurs surfaces</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 shares too few plane surfaces with other scans to be tied to them; scan with more overlap, or pick targets.</source>
        <translation>%1 partage trop peu de surfaces planes avec d&#x27;autres scans pour leur être lié ; scannez avec plus de recouvrement, ou pointez des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>The surfaces that %1 shares with other scans would move it by %2 mm, %3 standard deviations, which the targets, also those that scans share, rule out; they are not used. Look, also in the scans beside it, for things that were moved between the scans, or for a cloud that is not the one of the targets.</source>
        <translation>Les surfaces que %1 a en commun avec d&#x27;autres scans le déplaceraient de %2 mm, %3 écarts types, ce que les cibles, y compris celles que les scans ont en commun, excluent ; elles ne sont pas utilisées. Chercher, aussi dans les scans voisins, des objets déplacés entre les scans, ou un nuage qui n&#x27;est pas celui des cibles.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 is not tied by surfaces, because its cloud does not show where the scanner stood, and both sides of a wall would be taken for one; give the cloud in the frame of the scanner, or an E57 or PTX file of one scan with its pose.</source>
        <translation>%1 n&#x27;est pas relié par des surfaces, car son nuage ne montre pas où se trouvait le scanner, et les deux faces d&#x27;un mur seraient prises pour une seule ; donner le nuage dans le repère du scanner, ou un fichier E57 ou PTX d&#x27;un seul scan avec sa pose.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 shares too few plane surfaces with another scan to be tied by them; its targets alone hold it.</source>
        <translation>%1 a trop peu de surfaces planes en commun avec un autre scan pour être relié par elles ; ses cibles seules le tiennent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 and %2 slide along the surfaces that they share, %3; in that direction, only targets or other scans hold them.</source>
        <translation>%1 et %2 glissent le long des surfaces qu&#x27;ils ont en commun, %3 ; dans cette direction, seuls des cibles ou d&#x27;autres scans les tiennent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/refinement.py"/>
        <source>%1 and %2 share only surfaces that face one way, and slide in all directions along them; there, only targets or other scans hold them.</source>
        <translation>%1 et %2 n&#x27;ont en commun que des surfaces d&#x27;une seule orientation et glissent le long de celles-ci dans toutes les directions ; là, seuls des cibles ou d&#x27;autres scans les tiennent.</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/tie.py"/>
        <source>up and down</source>
        <translation>de haut en bas</translation>
    </message>
    <message>
        <location filename="../../algorithms/registration/surfaces/tie.py"/>
        <source>at an azimuth of %1 degrees</source>
        <translation>à un azimut de %1 degrés</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it cannot be read: %1</source>
        <translation>il ne peut pas être lu : %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it is cut off</source>
        <translation>il est coupé</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>its table is cut off</source>
        <translation>sa table est coupée</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>it has %1 shapes, and its table %2 rows</source>
        <translation>il a %1 formes, et sa table %2 lignes</translation>
    </message>
    <message>
        <location filename="../../algorithms/shapefile.py"/>
        <source>%1 is damaged (%2); copy or export it again, with all its parts.</source>
        <translation>%1 est endommagé (%2) ; copiez-le ou exportez-le à nouveau, avec toutes ses parties.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/axes/axes.py"/>
        <source>Finding axes</source>
        <translation>Recherche des axes</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/bands.py"/>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <location filename="../../algorithms/site_plan/output/layers.py"/>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>density</source>
        <translation>densité</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>%1: %2 of %3 points lie far from each other; check that the coordinates are metres, or remove what is not the site.</source>
        <translation>%1 : %2 points sur %3 sont très éloignés les uns des autres ; vérifiez que les coordonnées sont en mètres, ou supprimez ce qui n&#x27;est pas le site.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>%1: all points have the same position; is it a scan?</source>
        <translation>%1 : tous les points ont la même position ; est-ce un scan ?</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>The points lie within a metre; check that the coordinates are metres, not degrees.</source>
        <translation>Les points tiennent dans un mètre ; vérifiez que les coordonnées sont en mètres, et non en degrés.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>SPACING %1 m is wider than PIXEL_SIZE %2 m, so walls have gaps.</source>
        <translation>SPACING %1 m est plus grand que PIXEL_SIZE %2 m ; les murs ont donc des lacunes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_image.py"/>
        <source>Finding the ground</source>
        <translation>Recherche du sol</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>occupied height</source>
        <translation>hauteur occupée</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>hanging height</source>
        <translation>hauteur suspendue</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>The raster has no coordinate reference system, so the results have none either.</source>
        <translation>Le raster n&#x27;a pas de système de coordonnées ; les résultats n&#x27;en ont donc pas non plus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: there is no such file; check the path.</source>
        <translation>INPUT %1 : ce fichier n&#x27;existe pas ; vérifiez le chemin.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: cannot be read as a raster; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : ne peut pas être lu comme raster ; donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds infinite values; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : contient des valeurs infinies ; donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds values below 0, which no density has; state which value stands for none, or give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : contient des valeurs inférieures à 0, qu&#x27;aucune densité n&#x27;a ; indiquez quelle valeur tient lieu d&#x27;absence, ou donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds no density above 0; is it the right raster?</source>
        <translation>INPUT %1 : ne contient aucune densité supérieure à 0 ; est-ce le bon raster ?</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: has %2 x %3 pixels, more than %4; cut it to the site, or make it with a larger PIXEL_SIZE.</source>
        <translation>INPUT %1 : a %2 x %3 pixels, plus de %4 ; découpez-le au site, ou produisez-le avec une plus grande valeur de PIXEL_SIZE.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: is not georeferenced; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : n&#x27;est pas géoréférencé ; donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: pixels must be square and north up; resample it with the Warp tool.</source>
        <translation>INPUT %1 : les pixels doivent être carrés, nord en haut ; rééchantillonnez avec « Projection (warp) ».</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: has pixels of %2 m; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : a des pixels de %2 m ; donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/density_raster.py"/>
        <source>INPUT %1: holds a picture, not densities; give the output of &#x27;densityimage&#x27;.</source>
        <translation>INPUT %1 : contient une image, et non des densités ; donnez la sortie de &#x27;densityimage&#x27;.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/grid.py"/>
        <source>The raster would be %1 x %2 pixels (%3 x %4 m at %5 m), more than %6: raise PIXEL_SIZE, cut the cloud to the site, or check that its coordinates are metres.</source>
        <translation>Le raster aurait %1 x %2 pixels (%3 x %4 m à %5 m), plus de %6 : augmentez PIXEL_SIZE, découpez le nuage au site, ou vérifiez que ses coordonnées sont en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>ZMIN %1 m is not below ZMAX %2 m; correct one of them.</source>
        <translation>ZMIN %1 m n&#x27;est pas inférieur à ZMAX %2 m ; corrigez l&#x27;un des deux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>Cutting by height</source>
        <translation>Découpe selon la hauteur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>above the ground</source>
        <translation>au-dessus du sol</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/density/height_range.py"/>
        <source>%1: no point lies from ZMIN %2 to ZMAX %3 m%4; the heights reach from %5 to %6 m%7.</source>
        <translation>%1 : aucun point entre ZMIN %2 et ZMAX %3 m%4 ; les hauteurs vont de %5 à %6 m%7.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/face_points.py"/>
        <source>Gathering the points of the faces</source>
        <translation>Collecte des points des parements</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <source>Fitting faces</source>
        <translation>Ajustement des parements</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <source>No wall found: no wall face could be fitted; switch REFINE off to keep the outlines of pixels.</source>
        <translation>Aucun mur trouvé : aucun parement n&#x27;a pu être ajusté ; désactivez REFINE pour garder les contours des pixels.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/faces/refinement.py"/>
        <location filename="../../algorithms/site_plan/walls/regions.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_drawing.py"/>
        <source>Room %1</source>
        <translation>Pièce %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1: %2 of %3 regions kept</source>
        <translation>%1 : %2 régions gardées sur %3</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>THRESHOLD up, MIN_AREA up or MAX_FILL down where there is no wall</source>
        <translation>THRESHOLD plus haut, MIN_AREA plus haut ou MAX_FILL plus bas là où il n&#x27;y a pas de mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>added by CLOSING %1 m</source>
        <translation>ajoutés par CLOSING %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>CLOSING down if it fills niches or passages, up if the two faces of a wall remain apart</source>
        <translation>CLOSING plus bas s&#x27;il comble des niches ou des passages, plus haut si les deux parements d&#x27;un mur restent séparés</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>neither straight nor curved: %1 of %2 regions</source>
        <translation>ni droits ni courbes : %1 régions sur %2</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_ELONGATION %1 down for short straight walls, MAX_FILL %2 up for curved or angled ones</source>
        <translation>MIN_ELONGATION %1 plus bas pour les murs droits courts, MAX_FILL %2 plus haut pour les murs courbes ou en angle</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>smaller than MIN_AREA %1 m²: %2 of %3 regions</source>
        <translation>plus petits que MIN_AREA %1 m² : %2 régions sur %3</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_AREA down if walls are among it</source>
        <translation>MIN_AREA plus bas s&#x27;il y a des murs parmi eux</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>fainter than THRESHOLD %1</source>
        <translation>plus faibles que THRESHOLD %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>THRESHOLD down if walls are among it</source>
        <translation>THRESHOLD plus bas s&#x27;il y a des murs parmi eux</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>foliage: points spread over the plan, not along a face</source>
        <translation>feuillage : points répartis sur le plan, et non le long d&#x27;un parement</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_HEIGHT 0 keeps it, and all else</source>
        <translation>MIN_HEIGHT 0 le garde, ainsi que tout le reste</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>furniture: ends below a ceiling that walls reach</source>
        <translation>mobilier : finit sous un plafond que les murs atteignent</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>ZMAX below the ceiling if low walls are among it</source>
        <translation>ZMAX sous le plafond s&#x27;il y a des murs bas parmi eux</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>above the ground, but less occupied than MIN_HEIGHT %1 m</source>
        <translation>au-dessus du sol, mais moins occupés que MIN_HEIGHT %1 m</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>MIN_HEIGHT down if walls are among it, low or sparsely scanned ones</source>
        <translation>MIN_HEIGHT plus bas s&#x27;il y a des murs parmi eux, bas ou peu scannés</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>floor, ground and the like</source>
        <translation>sol, terrain et autres</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>density of pixels that may be wall</source>
        <translation>densité des pixels qui peuvent être mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1 standard deviations = %2 points per pixel</source>
        <translation>%1 écarts-types = %2 points par pixel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>given</source>
        <translation>donné</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>derived: %1</source>
        <translation>déduit : %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>heights show where the ground was seen</source>
        <translation>les hauteurs montrent où le sol a été vu</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>no heights are used</source>
        <translation>aucune hauteur n&#x27;est utilisée</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>the median density of the pixels above THRESHOLD that may be wall</source>
        <translation>la densité médiane des pixels au-dessus de THRESHOLD qui peuvent être mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>a metre of wall one pixel thick</source>
        <translation>un mètre de mur épais d&#x27;un pixel</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>not applied</source>
        <translation>non appliqué</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>of the files, or given</source>
        <translation>des fichiers, ou donné</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>%1 pixels</source>
        <translation>%1 pixels</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/plan_report.py"/>
        <source>above the local ground</source>
        <translation>au-dessus du sol local</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>Under the ceiling, walls and rooms come from the faces and the floor of the storey; elsewhere from the density image.</source>
        <translation>Sous le plafond, murs et pièces viennent des parements et du sol de l&#x27;étage ; ailleurs, de l&#x27;image de densité.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>REFINE is no: all walls come from the density image, with the outlines of pixels.</source>
        <translation>REFINE est non : tous les murs viennent de l&#x27;image de densité, avec les contours des pixels.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>STOREY is no: all walls come from the density image.</source>
        <translation>STOREY est non : tous les murs viennent de l&#x27;image de densité.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>No room under a ceiling was seen: all walls come from the density image.</source>
        <translation>Aucune pièce sous plafond n&#x27;a été vue : tous les murs viennent de l&#x27;image de densité.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>floor</source>
        <translation>sol</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>ceiling</source>
        <translation>plafond</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>not seen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>distance of points</source>
        <translation>espacement des points</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>noise of upright surfaces</source>
        <translation>bruit des surfaces verticales</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>outlines of rooms</source>
        <translation>contours des pièces</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>of them limits, without a wall</source>
        <translation>dont limites sans mur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/storey_report.py"/>
        <source>pieces of the kind %1</source>
        <translation>éléments de type %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls: %1, %2 m² in plan, %3 m long. Rooms: %4, %5 m².</source>
        <translation>Murs : %1, %2 m² en plan, %3 m de long. Pièces : %4, %5 m².</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls: %1, %2 m² in plan, %3 m long.</source>
        <translation>Murs : %1, %2 m² en plan, %3 m de long.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Storey</source>
        <translation>Étage</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Nothing was left out.</source>
        <translation>Rien n&#x27;a été écarté.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>What became of the pixels</source>
        <translation>Ce que sont devenus les pixels</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Regions are counted anew at each threshold.</source>
        <translation>Les régions sont comptées à nouveau à chaque seuil.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Thresholds</source>
        <translation>Seuils</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>The regions above each threshold, in the colours of the picture above. If floors or clutter are kept in the first pictures, raise THRESHOLD; if faint walls show in none, lower it. If the last pictures find nothing more, THRESHOLD_MAX may be lower.</source>
        <translation>Les régions au-dessus de chaque seuil, dans les couleurs de l&#x27;image ci-dessus. Si les premières images gardent des sols ou de l&#x27;encombrement, augmentez THRESHOLD ; si des murs faibles n&#x27;apparaissent dans aucune, diminuez-le. Si les dernières images ne trouvent plus rien, THRESHOLD_MAX peut être plus bas.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Density image</source>
        <translation>Image de densité</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/help.py"/>
        <location filename="../../processing_provider/model.py"/>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls</source>
        <translation>Murs</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Site plan</source>
        <translation>Plan du site</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>area</source>
        <translation>surface</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>The walls over the density image. A wall of the image without a colour is missing: see below which criterion removed it. A colour where there is no wall: see below which criterion let it pass.</source>
        <translation>Les murs sur l&#x27;image de densité. Un mur de l&#x27;image sans couleur manque : voyez plus bas quel critère l&#x27;a supprimé. Une couleur là où il n&#x27;y a pas de mur : voyez plus bas quel critère l&#x27;a laissée passer.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Walls (red), rooms (green), limits of the scan (blue), and what was left out (yellow). Look for a wall among the yellow lines; the layer LEFT_OUT gives the reason of each.</source>
        <translation>Murs (rouge), pièces (vert), limites du scan (bleu), et ce qui a été écarté (jaune). Cherchez un mur parmi les lignes jaunes ; la couche LEFT_OUT donne la raison de chacune.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>left out, because it</source>
        <translation>écarté, car</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>surfaces</source>
        <translation>surfaces</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Each pixel by the last criterion that it met. Look for a missing wall, read its colour, and change the parameter beside that colour.</source>
        <translation>Chaque pixel selon le dernier critère qu&#x27;il a rempli. Cherchez un mur manquant, lisez sa couleur, et changez le paramètre placé à côté de cette couleur.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>pixels that are</source>
        <translation>pixels qui sont</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>change</source>
        <translation>changement</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>In standard deviations of the density image; the last bar holds all that is denser. Lines mark the lowest and the highest threshold, as far as they lie in between.</source>
        <translation>En écarts-types de l&#x27;image de densité ; la dernière barre contient tout ce qui est plus dense. Les traits marquent le seuil le plus bas et le plus haut, s&#x27;ils sont dans l&#x27;intervalle.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>threshold</source>
        <translation>seuil</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>regions</source>
        <translation>régions</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>too small</source>
        <translation>trop petites</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>misshapen</source>
        <translation>mal formées</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Points per pixel, of the %1 of %2 points that thinning kept; black is two standard deviations above the mean. Walls should stand out as lines. If they are dotted, raise PIXEL_SIZE; if neighbouring faces run into each other, lower it, and SPACING with it.</source>
        <translation>Points par pixel, des %1 points sur %2 que l&#x27;éclaircissage a gardés ; le noir est à deux écarts-types au-dessus de la moyenne. Les murs doivent ressortir en lignes. S&#x27;ils sont en pointillé, augmentez PIXEL_SIZE ; si des parements voisins se confondent, diminuez-le, et SPACING avec lui.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Defaults count as given.</source>
        <translation>Les valeurs par défaut comptent comme données.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>kind</source>
        <translation>type</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>thickness</source>
        <translation>épaisseur</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>base z</source>
        <translation>z de la base</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>top z</source>
        <translation>z du sommet</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>azimuth</source>
        <translation>azimut</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>votes</source>
        <translation>voix</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Metres, degrees from grid north, square metres; votes are thresholds. The first %1 of %2.</source>
        <translation>Mètres, degrés depuis le nord de la grille, mètres carrés ; les voix sont des seuils. Les %1 premiers sur %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Metres, degrees from grid north, square metres; votes are thresholds.</source>
        <translation>Mètres, degrés depuis le nord de la grille, mètres carrés ; les voix sont des seuils.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>perimeter</source>
        <translation>périmètre</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>openings</source>
        <translation>ouvertures</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>seen (%)</source>
        <translation>vu (%)</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Square metres and metres. If a room in the open is missing, a gap in its walls is wider than DOOR_WIDTH. The first %1 of %2.</source>
        <translation>Mètres carrés et mètres. S&#x27;il manque une pièce à ciel ouvert, une lacune de ses murs est plus large que DOOR_WIDTH. Les %1 premières sur %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/output/templates/site_plan.html"/>
        <source>Square metres and metres. If a room in the open is missing, a gap in its walls is wider than DOOR_WIDTH.</source>
        <translation>Mètres carrés et mètres. S&#x27;il manque une pièce à ciel ouvert, une lacune de ses murs est plus large que DOOR_WIDTH.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/rooms/rooms.py"/>
        <source>Triangulating the space between walls</source>
        <translation>Triangulation de l&#x27;espace entre les murs</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/rooms/rooms.py"/>
        <source>Outlining rooms</source>
        <translation>Tracé des pièces</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/site_plan.py"/>
        <source>No room is closed: raise DOOR_WIDTH above the widest gap in its walls.</source>
        <translation>Aucune pièce n&#x27;est fermée : augmentez DOOR_WIDTH au-delà de la plus large lacune de ses murs.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/site_plan.py"/>
        <source>Tracing outlines</source>
        <translation>Suivi des contours</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/doubts.py"/>
        <source>%1 m² of %2 m² of upright surface rise as high as walls, but are left out as furniture, curtains and door leaves: look through LEFT_OUT, and set STOREY to no if walls are among them.</source>
        <translation>%1 m² sur %2 m² de surfaces verticales montent aussi haut que des murs, mais sont écartés comme mobilier, rideaux et vantaux : parcourez LEFT_OUT, et mettez STOREY à non s&#x27;il y a des murs parmi eux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/doubts.py"/>
        <source>Rooms end without a wall over %1 m of %2 m: the scan ends there, or the wall is glass or hidden by furniture; see LIMITS.</source>
        <translation>Les pièces finissent sans mur sur %1 m de %2 m : le scan s&#x27;y arrête, ou le mur est en verre ou caché par du mobilier ; voir LIMITS.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/evidence/levels.py"/>
        <source>The storey would be %1 x %2 m, too large for a plan of rooms: cut the cloud to a building, or check that its coordinates are metres.</source>
        <translation>L&#x27;étage aurait %1 x %2 m, trop pour un plan de pièces : découpez le nuage à un bâtiment, ou vérifiez que ses coordonnées sont en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/joining.py"/>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Reducing points to voxels</source>
        <translation>Réduction des points en voxels</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding the storey</source>
        <translation>Recherche de l&#x27;étage</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding faces</source>
        <translation>Recherche des parements</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding floor and ceiling</source>
        <translation>Recherche du sol et du plafond</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Dividing rooms from solid</source>
        <translation>Séparation des pièces et de la maçonnerie</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <source>Finding rooms and walls</source>
        <translation>Recherche des pièces et des murs</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/storey_plan.py"/>
        <location filename="../../algorithms/site_plan/storeys/walls/walls.py"/>
        <source>parapet</source>
        <translation>allège</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>nothing stands at the cut: a beam, a lamp, or what hangs</source>
        <translation>rien n&#x27;est debout à la hauteur de coupe : une poutre, une lampe, ou un objet suspendu</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>ends below the heads of people: furniture</source>
        <translation>finit sous la hauteur de tête : mobilier</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>stands close before a wall: furniture, a curtain or a door leaf</source>
        <translation>se trouve juste devant un mur : mobilier, rideau ou vantail</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>fills less than half of the height: a curtain or clutter</source>
        <translation>remplit moins de la moitié de la hauteur : rideau ou encombrement</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/storeys/walls/left_out.py"/>
        <source>too short for a wall that stands free: a door leaf or furniture</source>
        <translation>trop court pour un mur isolé : vantail ou mobilier</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>Threshold %1</source>
        <translation>Seuil %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>Closing gaps</source>
        <translation>Fermeture des lacunes</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>No wall found: no pixel of the %1 that MIN_HEIGHT %2 m left is as dense as THRESHOLD %3 standard deviations; lower it, or leave it empty.</source>
        <translation>Aucun mur trouvé : aucun des %1 pixels que MIN_HEIGHT %2 m a laissés n&#x27;est aussi dense que THRESHOLD %3 écarts-types ; diminuez-le, ou laissez-le vide.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/extraction.py"/>
        <source>No wall found: MIN_HEIGHT %1 m left %2 of %3 pixels; over %4 thresholds from %5 to %6 standard deviations they formed %7 regions, of which MIN_AREA %8 m² removed %9, and MAX_FILL %10 with MIN_ELONGATION %11 removed %12; relax the one that removed most.</source>
        <translation>Aucun mur trouvé : MIN_HEIGHT %1 m a laissé %2 pixels sur %3 ; à %4 seuils de %5 à %6 écarts-types, ils ont formé %7 régions, dont MIN_AREA %8 m² a supprimé %9, et MAX_FILL %10 avec MIN_ELONGATION %11 %12 ; assouplissez celui qui en a supprimé le plus.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/height_gate.py"/>
        <source>The raster does not have the bands of heights: MIN_HEIGHT is not applied.</source>
        <translation>Le raster n&#x27;a pas les bandes de hauteurs : MIN_HEIGHT n&#x27;est pas appliqué.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/height_gate.py"/>
        <source>The points reach less than %1 m above their ground, as in a horizontal slice: MIN_HEIGHT is not applied.</source>
        <translation>Les points montent à moins de %1 m au-dessus de leur sol, comme dans une tranche horizontale : MIN_HEIGHT n&#x27;est pas appliqué.</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/regions.py"/>
        <location filename="../../algorithms/site_plan/walls/wall.py"/>
        <source>curved</source>
        <translation>courbe</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the lower quartile of the density, as nothing is known to be flat</source>
        <translation>le quartile inférieur de la densité, car rien n&#x27;est connu pour être horizontal</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the usual density of the pixels that show horizontal surfaces only</source>
        <translation>la densité usuelle des pixels qui ne montrent que des surfaces horizontales</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>Otsu&#x27;s threshold of the logarithm of the density</source>
        <translation>seuil d&#x27;Otsu du logarithme de la densité</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>the density that best separates horizontal surfaces from the rest</source>
        <translation>la densité qui sépare le mieux les surfaces horizontales du reste</translation>
    </message>
    <message>
        <location filename="../../algorithms/site_plan/walls/thresholds.py"/>
        <source>THRESHOLD_MAX %1 is below THRESHOLD %2; raise it, or leave it empty.</source>
        <translation>THRESHOLD_MAX %1 est inférieur à THRESHOLD %2 ; augmentez-le, ou laissez-le vide.</translation>
    </message>
    <message>
        <location filename="../../algorithms/staging.py"/>
        <source>%1 is a folder</source>
        <translation>%1 est un dossier</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/column_names.py"/>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/degrees.py"/>
        <source>x and y of %1 seem to be degrees, because they have many more decimals than z; reproject them to a projected coordinate reference system in metres.</source>
        <translation>x et y de %1 semblent être des degrés, car ils ont bien plus de décimales que z ; reprojetez-les dans un système projeté en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 holds no points because all lines with numbers begin with #, // or ;, as remarks do; remove these signs.</source>
        <translation>%1 ne contient aucun point, car toutes les lignes de nombres commencent, comme des commentaires, par #, // ou ; ; retirez ces signes.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 is XML, not a table of numbers; export it again as x y z.</source>
        <translation>%1 est du XML, et non un tableau de nombres ; exportez-le à nouveau sous la forme x y z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>%1 holds no points because no line has three numbers separated by comma, semicolon, blank or tab; export it again as x y z.</source>
        <translation>%1 ne contient aucun point, car aucune ligne n&#x27;a trois nombres séparés par une virgule, un point-virgule, un espace ou une tabulation ; exportez-le à nouveau sous la forme x y z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>The commas in %1 can be decimal signs or separators; write decimal points, or separate the columns by semicolons.</source>
        <translation>Les virgules de %1 peuvent être des signes décimaux ou des séparateurs ; écrivez des points décimaux, ou séparez les colonnes par des points-virgules.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/dialect.py"/>
        <source>The numbers in %1 separate thousands in several ways; write them without such separators.</source>
        <translation>Les nombres de %1 séparent les milliers de plusieurs façons ; écrivez-les sans ces séparateurs.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is not a text file; give it the extension of its format.</source>
        <translation>%1 n&#x27;est pas un fichier texte ; donnez-lui l&#x27;extension de son format.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is too large for %2; choose the list, not a cloud.</source>
        <translation>%1 est trop grand pour %2 ; choisissez la liste, et non un nuage.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 is not a text file; export %2 as text.</source>
        <translation>%1 n&#x27;est pas un fichier texte ; exportez %2 en texte.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 has %2 lines, too many for %3, of which %4 are read at most; choose the list, not a cloud.</source>
        <translation>%1 a %2 lignes, trop pour %3, dont %4 sont lues au plus ; choisissez la liste, et non un nuage.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/encoding.py"/>
        <source>%1 cannot be read as text in %2 because it is cut off or damaged; export it again.</source>
        <translation>%1 ne peut pas être lu comme texte en %2, car il est coupé ou endommagé ; exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header of %1 gives lengths in %2; convert them to metres.</source>
        <translation>L&#x27;en-tête de %1 donne des longueurs en %2 ; convertissez-les en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has %2 columns in line %3 where most lines have %4; correct or remove that line.</source>
        <translation>%1 a %2 colonnes à la ligne %3, alors que la plupart des lignes en ont %4 ; corrigez ou supprimez cette ligne.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>Line %1 of %2, below the names of the columns, is not a row of numbers; correct or remove that line.</source>
        <translation>La ligne %1 de %2, sous les noms des colonnes, n&#x27;est pas une ligne de nombres ; corrigez-la ou supprimez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The remarks in %1 state several units, %2; correct them.</source>
        <translation>Les commentaires de %1 indiquent plusieurs unités, %2 ; corrigez-les.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header of %1 states the unit of some columns only; write it into the name of each column.</source>
        <translation>L&#x27;en-tête de %1 n&#x27;indique l&#x27;unité que de certaines colonnes ; écrivez-la dans le nom de chaque colonne.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has several columns called %2; rename those that are not wanted.</source>
        <translation>%1 a plusieurs colonnes appelées %2 ; renommez celles qui ne sont pas voulues.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has %2 and %3 for one coordinate; rename what is not wanted.</source>
        <translation>%1 a %2 et %3 pour une coordonnée ; renommez ce qui n&#x27;est pas voulu.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>%1 has geographic coordinates in degrees; reproject it to a projected coordinate reference system in metres.</source>
        <translation>%1 a des coordonnées géographiques en degrés ; reprojetez-le dans un système projeté en mètres.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/header.py"/>
        <source>The header in line %1 of %2 does not name the %3 columns of the lines below; name them, with x, y and z or easting, northing and height among them.</source>
        <translation>L&#x27;en-tête à la ligne %1 de %2 ne nomme pas les %3 colonnes des lignes suivantes ; nommez-les, avec parmi elles x, y et z, ou easting, northing et height.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>a table of lengths</source>
        <translation>un tableau de longueurs</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>The number at the end of %1 is cut off; copy or export it again.</source>
        <translation>Le nombre à la fin de %1 est coupé ; copiez-le ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>The commas in %1 can be decimal signs or separators; separate the columns by semicolons, or write decimal points.</source>
        <translation>Les virgules de %1 peuvent être des signes décimaux ou des séparateurs ; séparez les colonnes par des points-virgules, ou écrivez des points décimaux.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 has %2 and %3 for one length; rename what is not wanted.</source>
        <translation>%1 a %2 et %3 pour une longueur ; renommez ce qui n&#x27;est pas voulu.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 rows of %2, the first in line %3, begin as remarks do and were left out; remove the sign before them if they are wanted.</source>
        <translation>%1 lignes de %2, la première à la ligne %3, commencent comme des commentaires et ont été écartées ; retirez le signe qui les précède si elles sont voulues.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>%1 has no column %2; add or rename it.</source>
        <translation>%1 n&#x27;a pas de colonne %2 ; ajoutez-la ou renommez-la.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/named_table.py"/>
        <source>Line %1 of %2 has %3 fields where the header names %4 columns; correct that line, or write decimal points if the separator is a comma.</source>
        <translation>La ligne %1 de %2 a %3 champs, alors que l&#x27;en-tête nomme %4 colonnes ; corrigez cette ligne, ou écrivez des points décimaux si le séparateur est une virgule.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says &#x27;%2&#x27;, which is not applied; apply it to the coordinates of the list where they need it.</source>
        <translation>L&#x27;en-tête de %1 dit &#x27;%2&#x27;, ce qui n&#x27;est pas appliqué ; appliquez-le aux coordonnées de la liste si nécessaire.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says &#x27;%2&#x27;, which is not applied; move the points by it with transformcloud where they need it.</source>
        <translation>L&#x27;en-tête de %1 dit &#x27;%2&#x27;, ce qui n&#x27;est pas appliqué ; déplacez ainsi les points avec transformcloud si nécessaire.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>The header of %1 says that %2 is up, which is not applied; rotate the points so that z is.</source>
        <translation>L&#x27;en-tête de %1 dit que %2 est vers le haut, ce qui n&#x27;est pas appliqué ; tournez les points pour que ce soit z.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/remarks.py"/>
        <source>A remark in %1 names EPSG:%2, which is not read; choose that reference system if it is right.</source>
        <translation>Une remarque dans %1 nomme EPSG:%2, ce qui n&#x27;est pas lu ; choisissez ce système de référence s&#x27;il est juste.</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/units.py"/>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <location filename="../../algorithms/tables/units.py"/>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>likeness of tiles around it</source>
        <translation>ressemblance des carreaux voisins</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>width of the pattern</source>
        <translation>largeur du motif</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>points around the centre</source>
        <translation>points autour du centre</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>planar surface</source>
        <translation>surface plane</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>share of the points on a plane</source>
        <translation>part des points sur un plan</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>angle of incidence</source>
        <translation>angle d&#x27;incidence</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>likeness of two edges</source>
        <translation>ressemblance des deux arêtes</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>shift of the centre</source>
        <translation>déplacement du centre</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>planar target</source>
        <translation>cible plane</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points on the target</source>
        <translation>points sur la cible</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points in the poorest quadrant</source>
        <translation>points dans le quadrant le plus pauvre</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>points of the colour of their quadrant</source>
        <translation>points de la couleur de leur quadrant</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>difference between quadrants of one colour</source>
        <translation>différence entre quadrants d&#x27;une même couleur</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>contrast of black and white</source>
        <translation>contraste du noir et du blanc</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>share of the intensities explained by two edges</source>
        <translation>part des intensités expliquée par deux arêtes</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>difference of the edges from a right angle</source>
        <translation>écart des arêtes à l&#x27;angle droit</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>two edges explain only %1 of the intensities</source>
        <translation>deux arêtes n&#x27;expliquent que %1 des intensités</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>only %1 points in a quadrant</source>
        <translation>seulement %1 points dans un quadrant</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>its quadrants of one colour differ in tone</source>
        <translation>ses quadrants d&#x27;une même couleur diffèrent de ton</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <source>its quadrants end at different distances</source>
        <translation>ses quadrants finissent à des distances différentes</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/checkerboards/checkerboard.py"/>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>the standard deviation of the centre is %1 mm</source>
        <translation>l&#x27;écart-type du centre est de %1 mm</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>With a step of %1 mm at 10 m, a target of %2 mm has four points a quadrant up to %3 m; scan with %4 mm to find it up to %5 m.</source>
        <translation>Avec un pas de %1 mm à 10 m, une cible de %2 mm a quatre points par quadrant jusqu&#x27;à %3 m ; scannez à %4 mm pour la trouver jusqu&#x27;à %5 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>black and white target</source>
        <translation>cible noir et blanc</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <location filename="../../algorithms/targets/results.py"/>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>Nothing in %1 looks like a %2.</source>
        <translation>Rien dans %1 ne ressemble à une %2.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>%1 by the %2</source>
        <translation>%1 par le critère « %2 »</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>%1 places in %2 look like a %3 and failed: %4. The nearest miss, at %5, failed by the %6: %7, where %8 is the limit.</source>
        <translation>%1 endroits de %2 ressemblent à une %3 et ont échoué : %4. Le plus proche de réussir, en %5, a échoué par le critère « %6 » : %7, pour une limite de %8.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/explanation.py"/>
        <source>without end</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/lists.py"/>
        <location filename="../../algorithms/targets/search.py"/>
        <source>Two scans are called %1, so that their lists would be one file; rename a scan.</source>
        <translation>Deux scans s&#x27;appellent %1, de sorte que leurs listes seraient un même fichier ; renommez un scan.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>size (mm)</source>
        <translation>taille (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>std (mm)</source>
        <translation>écart-type (mm)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>incidence (degrees)</source>
        <translation>incidence (degrés)</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>, %1 doubtful</source>
        <translation>, %1 douteuses</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>%1 targets%2, in %3 points with a step of %4 mm at 10 m.</source>
        <translation>%1 cibles%2, dans %3 points avec un pas de %4 mm à 10 m.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>Doubtful: %1</source>
        <translation>Douteuse : %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/report.py"/>
        <source>%1. %2, %3 mm, %4 m away, centre to %5 mm. The picture is %6 mm high.</source>
        <translation>%1. %2, %3 mm, à %4 m, centre à %5 mm près. L&#x27;image fait %6 mm de haut.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>What the pictures show</source>
        <translation>Ce que montrent les images</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>A black and white target is drawn by the intensities that the scanner measured, a sphere by its distances, near ones bright. The cross marks the fitted centre and leaves it free. Where the arms do not lie between the quadrants, or not around the middle of the sphere, the target is wrong: delete its row from the list.</source>
        <translation>Une cible noir et blanc est dessinée d&#x27;après les intensités mesurées par le scanner, une sphère d&#x27;après ses distances, les proches en clair. La croix marque le centre ajusté et le laisse libre. Là où les branches ne sont pas entre les quadrants, ou pas autour du milieu de la sphère, la cible est fausse : supprimez sa ligne de la liste.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>Targets in scans</source>
        <translation>Cibles dans les scans</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/output/templates/targets.html"/>
        <source>Coordinates of the scan in metres; std: standard deviation of the centre in space. Red: doubtful, not in the list.</source>
        <translation>Coordonnées du scan en mètres ; écart-type du centre dans l&#x27;espace. Rouge : douteuse, absente de la liste.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>its %1 points fill too few directions</source>
        <translation>ses %1 points occupent trop peu de directions</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>ranges jump between %1 of its neighbours</source>
        <translation>les distances sautent entre %1 de ses voisins</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>%1 has too few points in which to search for targets; choose a denser scan.</source>
        <translation>%1 a trop peu de points pour y chercher des cibles ; choisissez un scan plus dense.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/range_image.py"/>
        <source>%1 is not the scan of one station at %2: %3. Choose the scans of single stations, in the scanner&#x27;s own frame or with STATION, the position of the scanner.</source>
        <translation>%1 n&#x27;est pas le scan d&#x27;une seule station en %2 : %3. Choisissez des scans de stations isolées, dans le repère du scanner ou avec STATION, la position du scanner.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/range_image/station.py"/>
        <source>%1 states where its scanner stood; leave STATION empty.</source>
        <translation>%1 indique où se trouvait son scanner ; laissez STATION vide.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/results.py"/>
        <source>black and white</source>
        <translation>noir et blanc</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/search.py"/>
        <source>%1 has no intensity, so that only spheres can be found; export it with intensity to find black and white targets.</source>
        <translation>%1 n&#x27;a pas d&#x27;intensité, de sorte que seules des sphères peuvent être trouvées ; exportez-le avec l&#x27;intensité pour trouver des cibles noir et blanc.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/search.py"/>
        <source>%1 has no intensity, without which no black and white target can be seen; export it with intensity, or set KIND to spheres.</source>
        <translation>%1 n&#x27;a pas d&#x27;intensité, sans laquelle aucune cible noir et blanc n&#x27;est visible ; exportez-le avec l&#x27;intensité, ou mettez KIND sur sphères.</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>round surface</source>
        <translation>surface ronde</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>points on the sphere</source>
        <translation>points sur la sphère</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>scatter of the ranges</source>
        <translation>dispersion des distances</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>difference from a usual diameter</source>
        <translation>écart à un diamètre usuel</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>round surface of this diameter</source>
        <translation>surface ronde de ce diamètre</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the sphere that was seen</source>
        <translation>part de la sphère qui a été vue</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the rays that pass through it</source>
        <translation>part des rayons qui la traversent</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>part of the surroundings at its depth</source>
        <translation>part des environs à sa profondeur</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>its diameter may be %1 mm; set SIZE</source>
        <translation>son diamètre peut être de %1 mm ; indiquez SIZE</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>only %1 points</source>
        <translation>seulement %1 points</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/spheres/sphere.py"/>
        <source>only %1 of it was seen</source>
        <translation>seulement %1 en a été vu</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>Searching %1 for black and white targets</source>
        <translation>Recherche de cibles noir et blanc dans %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>Searching %1 for spheres</source>
        <translation>Recherche de sphères dans %1</translation>
    </message>
    <message>
        <location filename="../../algorithms/targets/station_search.py"/>
        <source>crossings nearby</source>
        <translation>croisements proches</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>%1: cannot write this kind of layer; end the name in .shp or .gpkg.</source>
        <translation>%1 : ce type de couche ne peut pas être écrit ; terminez le nom par .shp ou .gpkg.</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <location filename="../../algorithms/vector.py"/>
        <source>%1 cannot be written (%2); free some space or choose another folder.</source>
        <translation>%1 ne peut pas être écrit (%2) ; libérez de la place ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1 cannot be %2: %3</source>
        <translation>%1 ne peut pas être %2 : %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>There is not enough memory; cut or thin the input, or close other programs.</source>
        <translation>La mémoire ne suffit pas ; découpez ou éclaircissez l&#x27;entrée, ou fermez d&#x27;autres programmes.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1 has no parameter %2; it is ignored.</source>
        <translation>%1 n&#x27;a pas de paramètre %2 ; il est ignoré.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>%1: %2 is an input as well; choose another folder.</source>
        <translation>%1 : %2 est aussi une entrée ; choisissez un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithm.py"/>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Compare lengths of a facade</source>
        <translation>Comparer les longueurs d&#x27;une façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Compares the lengths of a schedule with tape measurements.</source>
        <translation>Compare les longueurs d&#x27;une nomenclature à des mesures au ruban.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Widths, heights and sills are paired by the id of the detail. The table and the report give automatic minus manual length, its mean and its standard deviation, as table 1 of Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal (2014).</source>
        <translation>Largeurs, hauteurs et allèges sont appariées par le numéro (id) du détail. Le tableau et le rapport donnent la longueur automatique moins la longueur manuelle, sa moyenne et son écart-type, comme le tableau 1 d&#x27;Aitelkadi, Tahiri, Simonetto, Sebari et Boulaassal (2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Schedule</source>
        <translation>Nomenclature</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>The csv file that facadedetails writes.</source>
        <translation>Le fichier csv qu&#x27;écrit facadedetails.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Manual lengths</source>
        <translation>Longueurs manuelles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>A csv file with the columns id and any of width, height and sill, empty where not measured, or with the columns id, dimension and length. Lengths in metres, separated by commas or semicolons, with the ids of the schedule.</source>
        <translation>Un fichier csv avec les colonnes id et, au choix, width, height et sill, vides là où rien n&#x27;a été mesuré, ou avec les colonnes id, dimension et length. Longueurs en mètres, séparées par des virgules ou des points-virgules, avec les numéros de la nomenclature.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>CSV file with a row for each length that both files have.</source>
        <translation>Fichier CSV avec une ligne par longueur présente dans les deux fichiers.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Report of the lengths</source>
        <translation>Rapport des longueurs</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>HTML page with the table and a plot.</source>
        <translation>Page HTML avec le tableau et un graphique.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Mean of automatic minus manual length (m)</source>
        <translation>Moyenne de longueur automatique moins manuelle (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Standard deviation of the differences (m)</source>
        <translation>Écart-type des différences (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Largest absolute difference (m)</source>
        <translation>Plus grande différence absolue (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>Number of lengths compared</source>
        <translation>Nombre de longueurs comparées</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_lengths.py"/>
        <source>%1 lengths: mean difference %2 mm, standard deviation %3 mm.</source>
        <translation>%1 longueurs : différence moyenne %2 mm, écart-type %3 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Compare a plan with a reference</source>
        <translation>Comparer un plan à une référence</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Measures how complete, correct and accurate a plan is, compared with a reference.</source>
        <translation>Mesure la complétude, l&#x27;exactitude et la précision d&#x27;un plan par rapport à une référence.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The boundaries of both layers are compared every 2 cm. Completeness is the share of the reference&#x27;s boundary with a boundary of the plan within the tolerance. Correctness is the share of the plan&#x27;s boundary with one of the reference within the tolerance. The offsets are the distances of the two, where the reference was found.</source>
        <translation>Les limites des deux couches sont comparées tous les 2 cm. La complétude est la part de la limite de la référence qui a une limite du plan dans la tolérance. L&#x27;exactitude est la part de la limite du plan qui en a une de la référence dans la tolérance. Les décalages sont les distances des deux, là où la référence a été trouvée.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Walls of the plan</source>
        <translation>Murs du plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Polygons, as siteplan writes them. Polygons that touch are joined.</source>
        <translation>Polygones, tels que les écrit siteplan. Les polygones qui se touchent sont réunis.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The true walls as polygons, or their faces as lines, in metres. In the coordinate reference system of the walls. A layer with a polygon whose field kind is judged is a plan drawn by hand: its kinds say what a plan must have, what it may have, and where nothing is judged.</source>
        <translation>Les murs vrais en polygones, ou leurs parements en lignes, en mètres, dans le système de coordonnées des murs. Une couche avec un polygone dont le champ kind vaut judged est un plan dessiné à la main : ses types disent ce qu&#x27;un plan doit avoir, ce qu&#x27;il peut avoir, et où rien n&#x27;est évalué.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Rooms of the plan</source>
        <translation>Pièces du plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Polygons, as siteplan writes them: they are compared with the rooms of a plan drawn by hand.</source>
        <translation>Polygones, tels que les écrit siteplan : ils sont comparés aux pièces d&#x27;un plan dessiné à la main.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Up to this distance a boundary counts as found. Choose it from the accuracy the plan needs.</source>
        <translation>Jusqu&#x27;à cette distance, une limite compte comme trouvée. Choisissez-la d&#x27;après la précision qu&#x27;exige le plan.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Lines with side (plan or reference), state (agrees, wrong, missing), median and largest offset, length. GeoPackage or shapefile, by extension.</source>
        <translation>Lignes avec side (plan ou reference), state (agrees, wrong, missing), décalage médian et maximal, longueur. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Report of the comparison</source>
        <translation>Rapport de la comparaison</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>HTML page with a map, curves and tables.</source>
        <translation>Page HTML avec une carte, des courbes et des tableaux.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Share of the reference that is in the plan (0 to 1)</source>
        <translation>Part de la référence qui est dans le plan (0 à 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Share of the plan that is in the reference (0 to 1)</source>
        <translation>Part du plan qui est dans la référence (0 à 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Intersection over union of the areas (0 to 1)</source>
        <translation>Intersection sur union des surfaces (0 à 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Median offset of the reference that was found (m)</source>
        <translation>Décalage médian de la référence trouvée (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Offset that 95 % of the reference that was found does not exceed (m)</source>
        <translation>Décalage que 95 % de la référence trouvée ne dépasse pas (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of drawn rooms that the plan has</source>
        <translation>Nombre de pièces dessinées que le plan possède</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of drawn rooms that it lacks</source>
        <translation>Nombre de pièces dessinées qui lui manquent</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Number of its rooms that are not drawn</source>
        <translation>Nombre de ses pièces qui ne sont pas dessinées</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Completeness %1, correctness %2.</source>
        <translation>Complétude %1, exactitude %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>The reference is a plan drawn by hand: only its judged region is compared.</source>
        <translation>La référence est un plan dessiné à la main : seule sa zone évaluée est comparée.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>ROOMS are not compared, because REFERENCE has no rooms drawn by hand.</source>
        <translation>ROOMS n&#x27;est pas comparé, parce que REFERENCE n&#x27;a pas de pièces dessinées à la main.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Rooms: %1 found, %2 missed, %3 invented.</source>
        <translation>Pièces : %1 trouvées, %2 manquées, %3 inventées.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/compare_plan.py"/>
        <source>Offset: median %1 m, 95 % %2 m.</source>
        <translation>Décalage : médiane %1 m, 95 % %2 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>Density image from laser scans</source>
        <translation>Image de densité à partir de scans laser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>Counts the points above each pixel of the ground plan, after thinning.</source>
        <translation>Compte les points au-dessus de chaque pixel du plan, après éclaircissage.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/density_image.py"/>
        <source>The clouds are thinned, and the points above each pixel are counted: walls stand out because many points lie above each other there. Further bands hold the height that points fill above the local ground, the lowest and highest point, the ground, and two measures that separate foliage and furniture from walls (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Les nuages sont éclaircis, et les points au-dessus de chaque pixel sont comptés : les murs ressortent, car beaucoup de points s&#x27;y superposent. D&#x27;autres bandes contiennent la hauteur que les points remplissent au-dessus du sol local, le point le plus bas et le plus haut, le sol, et deux mesures qui séparent le feuillage et le mobilier des murs (Mueller, Kohoutek et Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Example data</source>
        <translation>Données d&#x27;exemple</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Example</source>
        <translation>Exemple</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Copies simulated scans of a house and of a facade into a folder, to try the toolbox.</source>
        <translation>Copie dans un dossier des scans simulés d&#x27;une maison et d&#x27;une façade, pour essayer les outils.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Eight scans of a house (house_01.laz to house_08.laz), each in the frame of its scanner and with the list of its targets (house_01.txt to house_08.txt); the surveyed control points (control.txt, EPSG:25833); and a scan of a facade (facade.laz). The manual says what to do with them.</source>
        <translation>Huit scans d&#x27;une maison (house_01.laz à house_08.laz), chacun dans le repère de son scanner et avec la liste de ses cibles (house_01.txt à house_08.txt) ; les points d&#x27;appui levés (control.txt, EPSG:25833) ; et un scan d&#x27;une façade (facade.laz). Le manuel dit qu&#x27;en faire.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Folder for 18 files, 3.5 MB.</source>
        <translation>Dossier pour 18 fichiers, 3.5 Mo.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/example_data.py"/>
        <source>Files: %1.</source>
        <translation>Fichiers : %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Walls from a density image</source>
        <translation>Murs à partir d&#x27;une image de densité</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Extracts the walls from a density image, as raster and polygons.</source>
        <translation>Extrait les murs d&#x27;une image de densité, en raster et en polygones.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>Pixels above several thresholds form regions. Large ones that are shaped like straight or curved walls are kept and combined, gaps are closed and outlines traced (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Les pixels au-dessus de plusieurs seuils forment des régions. Les grandes, qui ont la forme de murs droits ou courbes, sont gardées et réunies, les lacunes sont fermées et les contours suivis (Mueller, Kohoutek et Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/extract_walls.py"/>
        <source>The output of &#x27;Density image from laser scans&#x27;.</source>
        <translation>La sortie de « Image de densité à partir de scans laser ».</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Details of a facade</source>
        <translation>Détails d&#x27;une façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Measures openings, recesses, projections and coloured details of a scanned facade.</source>
        <translation>Mesure les baies, renfoncements, saillies et détails colorés d&#x27;une façade scannée.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Finds the main plane of the facade; coplanar details by colour and intensity; openings and recesses by the points behind the wall; projections by the planes in front of it. An outline is the mean of both sides of a border, with standard deviations. The clouds are enough; without colour, only openings, recesses and projections are found (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014).</source>
        <translation>Trouve le plan principal de la façade ; les détails coplanaires par la couleur et l&#x27;intensité ; les baies et renfoncements par les points derrière le mur ; les saillies par les plans en avant de lui. Un contour est la moyenne des deux côtés d&#x27;un bord, avec des écarts-types. Les nuages suffisent ; sans couleur, seuls les baies, renfoncements et saillies sont trouvés (Aitelkadi, Tahiri, Simonetto, Sebari et Boulaassal 2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Orthoimage</source>
        <translation>Orthoimage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>GeoTIFF in u, v: the colours of the facade projected onto its plane, or its intensity.</source>
        <translation>GeoTIFF en u, v : les couleurs de la façade projetées sur son plan, ou son intensité.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Details in space</source>
        <translation>Détails dans l&#x27;espace</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>The polygons of the elevation in x, y, z of the site, with the same ids and areas.</source>
        <translation>Les polygones de l&#x27;élévation en x, y, z du site, avec les mêmes numéros et surfaces.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Elevation</source>
        <translation>Élévation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Polygons in u (right) and v (up), in metres: the wall, its details, and areas that were not seen.</source>
        <translation>Polygones en u (droite) et v (haut), en mètres : le mur, ses détails, et les zones non vues.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>CSV file with a row for each detail: kind, width, height, sill, area, standard deviations.</source>
        <translation>Fichier CSV avec une ligne par détail : type, largeur, hauteur, allège, surface, écarts-types.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>DXF file in metres, with a layer for each kind; needs the package ezdxf.</source>
        <translation>Fichier DXF en mètres, avec un calque par type ; demande le paquet ezdxf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Polygons in u, v, with reason and area: holes of the wall, regions of another colour and surfaces that are not drawn.</source>
        <translation>Polygones en u, v, avec raison et surface : trous du mur, régions d&#x27;une autre couleur et surfaces qui ne sont pas dessinées.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Report of the facade</source>
        <translation>Rapport de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>HTML page with a key plan of all facades of the cloud, and the details of the one drawn.</source>
        <translation>Page HTML avec un plan de repérage de toutes les façades du nuage, et les détails de celle qui est dessinée.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Number of details</source>
        <translation>Nombre de détails</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Number of facades in the cloud</source>
        <translation>Nombre de façades du nuage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Area of the wall without openings and recesses (m²)</source>
        <translation>Surface du mur sans baies ni renfoncements (m²)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Facades drawn into the folder: %1.</source>
        <translation>Façades dessinées dans le dossier : %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Left out: %1 of kind %2, %3 m² in all: %4.</source>
        <translation>Écartés : %1 de type %2, %3 m² en tout : %4.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>A part of %1 m² lies %2 m from the main wall.</source>
        <translation>Une partie de %1 m² est à %2 m du mur principal.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_details.py"/>
        <source>Details: %1.</source>
        <translation>Détails : %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Planes of a facade</source>
        <translation>Plans d&#x27;une façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Finds the main plane of a facade and the secondary planes on it.</source>
        <translation>Trouve le plan principal d&#x27;une façade et ses plans secondaires.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>RANSAC finds the largest upright plane of the scan, the facade without street, trees and side walls, and then the planes on it: recessed doors and windows, cornices, bays. Each plane is fitted by total least squares. Every point belongs to the nearest plane within DISTANCE (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal 2014).</source>
        <translation>RANSAC trouve le plus grand plan vertical du scan, la façade sans la rue, les arbres ni les murs latéraux, puis les plans qu&#x27;elle porte : portes et fenêtres en retrait, corniches, oriels. Chaque plan est ajusté par moindres carrés totaux. Chaque point appartient au plan le plus proche à moins de DISTANCE (Aitelkadi, Tahiri, Simonetto, Sebari et Boulaassal 2014).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Polygons in space with normal, distance from the origin, azimuth, tilt, rms, number of points and true area, because GIS computes an area of 0 for an upright polygon.</source>
        <translation>Polygones dans l&#x27;espace avec normale, distance à l&#x27;origine, azimut, inclinaison, rms, nombre de points et surface vraie, car un SIG calcule une surface de 0 pour un polygone vertical.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Points with the number of their plane</source>
        <translation>Points avec le numéro de leur plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>The cloud with all its attributes and the attribute plane, 0 for points outside all planes. LAZ, LAS or text.</source>
        <translation>Le nuage avec tous ses attributs et l&#x27;attribut plane, 0 pour les points hors de tout plan. LAZ, LAS ou texte.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Number of planes</source>
        <translation>Nombre de plans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/facade_planes.py"/>
        <source>Plane %1: %2 points, rms %3 mm.</source>
        <translation>Plan %1 : %2 points, rms %3 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Find targets in scans</source>
        <translation>Trouver les cibles dans les scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Registration</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Finds black and white targets and spheres in scans, and measures their centres.</source>
        <translation>Trouve les cibles noir et blanc et les sphères dans les scans, et mesure leurs centres.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Each scan becomes the image that the scanner saw. The centre of a black and white target is the crossing of its two edges on the fitted plane, that of a sphere the centre of the fitted sphere without its far rim. Each centre has a standard deviation. Targets that are doubtful are in the layer and in the report, but not in the lists.</source>
        <translation>Chaque scan devient l&#x27;image qu&#x27;a vue le scanner. Le centre d&#x27;une cible noir et blanc est l&#x27;intersection de ses deux arêtes sur le plan ajusté, celui d&#x27;une sphère le centre de la sphère ajustée sans son bord lointain. Chaque centre a un écart-type. Les cibles douteuses sont dans la couche et dans le rapport, mais pas dans les listes.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Lists of targets</source>
        <translation>Listes de cibles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Folder for one text file per scan with x y z of its targets, for TARGETS of &#x27;Register scans to control points&#x27;.</source>
        <translation>Dossier pour un fichier texte par scan avec x y z de ses cibles, pour TARGETS de « Recaler des scans sur des points d&#x27;appui ».</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Points with kind, size, standard deviation of the centre, number of points, angle of incidence and quality; doubtful ones too, with the reason. GeoPackage or shapefile, by extension.</source>
        <translation>Points avec type, taille, écart-type du centre, nombre de points, angle d&#x27;incidence et qualité ; les douteuses aussi, avec la raison. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>HTML page with a picture of each target as the scanner saw it, the fitted centre drawn in.</source>
        <translation>Page HTML avec une image de chaque cible telle que le scanner l&#x27;a vue, le centre ajusté y étant dessiné.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>Number of targets without doubt</source>
        <translation>Nombre de cibles non douteuses</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/find_targets.py"/>
        <source>No target was found; the log says which tests failed, and how near.</source>
        <translation>Aucune cible n&#x27;a été trouvée ; le journal dit quels critères ont échoué, et de combien.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Sheet of a plan or an elevation</source>
        <translation>Feuille d&#x27;un plan ou d&#x27;une élévation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Makes a print layout that is true to scale, with legend, grid and title block, and its PDF.</source>
        <translation>Crée une mise en page à l&#x27;échelle, avec légende, grille et cartouche, et son PDF.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>The layers are drawn in their styles at the scale of the sheet, with a grid of coordinates, scale bar, north, legend and title block. Author and title come from the properties of the project. The layout joins the project, where it can be changed; nothing else in the project changes.</source>
        <translation>Les couches sont dessinées dans leur style à l&#x27;échelle de la feuille, avec une grille de coordonnées, une barre d&#x27;échelle, le nord, une légende et un cartouche. L&#x27;auteur et le titre viennent des propriétés du projet. La mise en page s&#x27;ajoute au projet, où elle peut être modifiée ; rien d&#x27;autre n&#x27;y change.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Walls, or elevation</source>
        <translation>Murs, ou élévation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Polygons of the walls, or of a facade.</source>
        <translation>Polygones des murs, ou d&#x27;une façade.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn below the walls.</source>
        <translation>Dessinées sous les murs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn above the walls.</source>
        <translation>Dessinés au-dessus des murs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Image</source>
        <translation>Image</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Drawn below all else: a density image or an orthoimage.</source>
        <translation>Dessinée sous tout le reste : une image de densité ou une orthoimage.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>A plan has a north arrow, an elevation has none.</source>
        <translation>Un plan a une flèche du nord, une élévation n&#x27;en a pas.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>50 for rooms, 100 for houses. A metre is 20 mm on paper at 1:50.</source>
        <translation>50 pour des pièces, 100 pour des maisons. Un mètre fait 20 mm sur le papier à 1:50.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>denominator</source>
        <translation>dénominateur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Sheet</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>The paper; upright if the drawing fits only so.</source>
        <translation>Le papier ; en hauteur si le dessin ne tient qu&#x27;ainsi.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>If not set, the title of the project, or the name of the walls layer.</source>
        <translation>Si vide, le titre du projet, ou le nom de la couche des murs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Sheet as PDF</source>
        <translation>Feuille en PDF</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>PDF file; print it at 100 %, not fitted to the page.</source>
        <translation>Fichier PDF ; imprimez-le à 100 %, sans l&#x27;ajuster à la page.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Sheet as SVG</source>
        <translation>Feuille en SVG</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>SVG file, for drawing programs.</source>
        <translation>Fichier SVG, pour les logiciels de dessin.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Author</source>
        <translation>Auteur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>1:%1 on %2</source>
        <translation>1:%1 sur %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/plan_layout.py"/>
        <source>local, metres</source>
        <translation>local, mètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>The control points have no coordinate reference system, so the results have none; set CRS.</source>
        <translation>Les points d&#x27;appui n&#x27;ont pas de système de coordonnées, les résultats n&#x27;en ont donc pas ; indiquez CRS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Register scans to control points</source>
        <translation>Recaler des scans sur des points d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Identifies the control point behind each target, without names, and georeferences the scans.</source>
        <translation>Identifie le point d&#x27;appui de chaque cible, sans noms, et géoréférence les scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Targets picked or found in each scan are matched with surveyed control points by their distances, and the transformations of all scans are adjusted together. Targets that are not control points tie the scans to each other. A scan without an unambiguous solution is refused, with the reason (Herbig, Mayer, Mortada and Rasztovits 2013).</source>
        <translation>Les cibles pointées ou trouvées dans chaque scan sont appariées aux points d&#x27;appui levés par leurs distances, et les transformations de tous les scans sont compensées ensemble. Les cibles qui ne sont pas des points d&#x27;appui relient les scans entre eux. Un scan sans solution univoque est refusé, avec la raison (Herbig, Mayer, Mortada et Rasztovits 2013).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Transformations</source>
        <translation>Transformations</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>JSON file with the status and the matrix of each scan, for &#x27;Transform laser scans&#x27;.</source>
        <translation>Fichier JSON avec le statut et la matrice de chaque scan, pour « Transformer des scans laser ».</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Control points, surveyed and appended</source>
        <translation>Points d&#x27;appui, levés et nouveaux</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Points with their standard deviations and the scans that use them. GeoPackage or shapefile, by extension.</source>
        <translation>Points avec leurs écarts-types et les scans qui les utilisent. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Points with the difference between target and control point, drawn as arrows, and their tests. GeoPackage or shapefile, by extension.</source>
        <translation>Points avec la différence entre cible et point d&#x27;appui, dessinée en flèches, et leurs tests. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Report of the registration</source>
        <translation>Rapport du recalage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>HTML page with plan, residuals and statistics of every scan; see the results viewer.</source>
        <translation>Page HTML avec plan, résidus et statistiques de chaque scan ; voir la visionneuse de résultats.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Number of registered scans</source>
        <translation>Nombre de scans recalés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Standard deviation of unit weight, a posteriori over a priori</source>
        <translation>Écart-type de l&#x27;unité de poids, a posteriori sur a priori</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Longest residual of the targets that were used (m)</source>
        <translation>Plus grand résidu des cibles utilisées (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>TARGETS is empty; choose at least one list of points, or scan.</source>
        <translation>TARGETS est vide ; choisissez au moins une liste de points, ou un scan.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>No scan has targets, so that CONTROL cannot be used; choose TARGETS, or leave CONTROL empty to join the scans in the frame of the first.</source>
        <translation>Aucune station n’a de cibles, si bien que CONTROL est inutilisable ; choisissez TARGETS, ou laissez CONTROL vide pour assembler les stations dans le repère de la première.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>No scan could be registered. %1</source>
        <translation>Aucun scan n&#x27;a pu être recalé. %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>Tolerance of distances: %1 mm.</source>
        <translation>Tolérance sur les distances : %1 mm.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1 is not registered (%2): %3</source>
        <translation>%1 n&#x27;est pas recalé (%2) : %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1 and %2 share %3 patches of surface, an overlap of %4 %; after the adjustment they lie %5 mm apart (rms).</source>
        <translation>%1 et %2 ont %3 morceaux de surface en commun, un recouvrement de %4 % ; après la compensation, leur écart est de %5 mm (rms).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>, %1 accidental matches expected</source>
        <translation>, %1 appariements fortuits attendus</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/register_scans.py"/>
        <source>%1: %2 of %3 targets matched, sigma0 %4, longest residual %5 mm, standard deviation up to %6 mm%7.</source>
        <translation>%1 : %2 cibles sur %3 appariées, sigma0 %4, plus grand résidu %5 mm, écart-type jusqu&#x27;à %6 mm%7.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Targets seen in each scan</source>
        <translation>Cibles vues dans chaque scan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Number of control points that a scan sees. Fewer than 5 rarely give an unambiguous match.</source>
        <translation>Nombre de points d&#x27;appui que voit un scan. Moins de 5 donnent rarement un appariement univoque.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Scale error</source>
        <translation>Erreur d&#x27;échelle</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Relative excess of all distances from the centroid of the targets of a scan.</source>
        <translation>Excès relatif de toutes les distances au centre de gravité des cibles d&#x27;un scan.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Number of simulated scans</source>
        <translation>Nombre de scans simulés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>1000 determine the success rate to about one per cent, in a minute.</source>
        <translation>1000 déterminent le taux de réussite à un pour cent près, en une minute.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Seed of the random numbers</source>
        <translation>Graine des nombres aléatoires</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>The same seed gives the same result; change it to see how much results vary.</source>
        <translation>La même graine donne le même résultat ; changez-la pour voir de combien les résultats varient.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>any number</source>
        <translation>nombre quelconque</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Reach of a scan</source>
        <translation>Portée d&#x27;un scan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>All targets of a scan lie within this distance of one control point, because a scanner sees only what is near. If not set, they come from the whole list.</source>
        <translation>Toutes les cibles d&#x27;un scan sont à cette distance au plus d&#x27;un point d&#x27;appui, car un scanner ne voit que ce qui est proche. Si vide, elles viennent de toute la liste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Simulate the registration of scans</source>
        <translation>Simuler le recalage de scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Checks before fieldwork whether the control points can be identified unambiguously.</source>
        <translation>Vérifie avant le terrain si les points d&#x27;appui peuvent être identifiés sans ambiguïté.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Random parts of the control list are seen from random stations, with noise and a scale error, and are registered as scans. The report states how many were identified, which control points are confused, and how accurate the transformations are (Herbig, Mayer, Mortada and Rasztovits 2013).</source>
        <translation>Des parties aléatoires de la liste des points d&#x27;appui sont vues de stations aléatoires, avec du bruit et une erreur d&#x27;échelle, et sont recalées comme des scans. Le rapport dit combien ont été identifiées, quels points d&#x27;appui sont confondus, et quelle est la précision des transformations (Herbig, Mayer, Mortada et Rasztovits 2013).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>CSV file with a row for each simulated scan: its points, its result, and its errors.</source>
        <translation>Fichier CSV avec une ligne par scan simulé : ses points, son résultat, et ses erreurs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Report of the simulation</source>
        <translation>Rapport de la simulation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>HTML page with failures, ambiguous points and errors; see the results viewer.</source>
        <translation>Page HTML avec les échecs, les points ambigus et les erreurs ; voir la visionneuse de résultats.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Share of scans that were registered with all targets right (0 to 1)</source>
        <translation>Part des scans recalés avec toutes les cibles justes (0 à 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>All targets right in %1 of %2 scans.</source>
        <translation>Toutes les cibles justes dans %1 scans sur %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/simulate_registration.py"/>
        <source>Control points that are confused, the most frequent first: %1.</source>
        <translation>Points d&#x27;appui confondus, les plus fréquents d&#x27;abord : %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Outlines on the wall faces</source>
        <translation>Contours sur les parements</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Moves the outlines from the edges of pixels to the points of the faces, straight or curved, and measures thickness, radius and coverage. If off, outlines follow pixels, as in the paper.</source>
        <translation>Déplace les contours du bord des pixels vers les points des parements, droits ou courbes, et mesure épaisseur, rayon et couverture. Désactivé, les contours suivent les pixels, comme dans l&#x27;article.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Site plan from laser scans</source>
        <translation>Plan du site à partir de scans laser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Turns terrestrial laser scans into a site plan: the walls as polygons.</source>
        <translation>Transforme des scans laser terrestres en plan : les murs en polygones.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>The clouds are thinned, a density image is computed, and the walls are extracted from it. Only the clouds are needed: defaults that depend on the data are derived and written to the log (Mueller, Kohoutek and Theiler 2012).</source>
        <translation>Les nuages sont éclaircis, une image de densité est calculée, et les murs en sont extraits. Seuls les nuages sont nécessaires : les valeurs par défaut qui dépendent des données sont déduites et écrites dans le journal (Mueller, Kohoutek et Theiler 2012).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Left out as foliage because their points lie on no face: %1.</source>
        <translation>Écartés comme feuillage, car leurs points ne sont sur aucun parement : %1.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/site_plan.py"/>
        <source>Outlines on the faces: %1 of their length has points on it.</source>
        <translation>Contours sur les parements : %1 de leur longueur porte des points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Thin laser scans</source>
        <translation>Éclaircir des scans laser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Clouds</source>
        <translation>Nuages</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Leaves out points so that no two are closer than a minimum distance.</source>
        <translation>Écarte des points pour que deux ne soient jamais plus proches qu&#x27;une distance minimale.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Points are left out until no two are closer than the point spacing. The distance is exact, in space, and holds across files. Several files become one. LAS and LAZ files of one point format keep every attribute if the output is LAS or LAZ.</source>
        <translation>Des points sont écartés jusqu&#x27;à ce que deux ne soient jamais plus proches que l&#x27;espacement. La distance est exacte, dans l&#x27;espace, et vaut d&#x27;un fichier à l&#x27;autre. Plusieurs fichiers n&#x27;en font plus qu&#x27;un. Les fichiers LAS et LAZ d&#x27;un même format de points gardent tous leurs attributs si la sortie est en LAS ou LAZ.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>Thinned cloud</source>
        <translation>Nuage éclairci</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <source>%1, by extension.</source>
        <translation>%1, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Number of points in the clouds</source>
        <translation>Nombre de points des nuages</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Number of points after thinning</source>
        <translation>Nombre de points après éclaircissage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/thin_cloud.py"/>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points: %1 read, %2 kept.</source>
        <translation>Points : %1 lus, %2 gardés.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Transform laser scans</source>
        <translation>Transformer des scans laser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Moves each scan to the control points by the transformation that registerscans found for it.</source>
        <translation>Amène chaque scan sur les points d&#x27;appui par la transformation que registerscans a trouvée.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Each cloud is moved by the transformation of the scan with the same name, and written to the folder under that name, to a tenth of a millimetre. It keeps all attributes, its normals are rotated, and it gets the coordinate reference system of the control points.</source>
        <translation>Chaque nuage est déplacé par la transformation du scan de même nom, et écrit sous ce nom dans le dossier, au dixième de millimètre. Il garde tous ses attributs, ses normales sont tournées, et il reçoit le système de coordonnées des points d&#x27;appui.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>The json file that registerscans writes, or your own with the name and matrix of each scan.</source>
        <translation>Le fichier json qu&#x27;écrit registerscans, ou le vôtre avec le nom et la matrice de chaque scan.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Transformed clouds</source>
        <translation>Nuages transformés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Folder for one cloud per scan. LAS, LAZ and text keep their format; all others become LAZ.</source>
        <translation>Dossier pour un nuage par scan. LAS, LAZ et texte gardent leur format ; tous les autres deviennent LAZ.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>Number of scans that were transformed</source>
        <translation>Nombre de scans transformés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>%1 states no coordinate reference system, so the results have none either.</source>
        <translation>%1 n&#x27;indique aucun système de coordonnées, les résultats n&#x27;en ont donc pas non plus.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/algorithms/transform_cloud.py"/>
        <source>%1: %2 points, moved as the scan %3.</source>
        <translation>%1 : %2 points, déplacés comme le scan %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>The Python %1 of QGIS lacks %2; %3, then start QGIS again.</source>
        <translation>Il manque au Python %1 de QGIS : %2 ; %3, puis redémarrez QGIS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>A package of the Python %1 of QGIS cannot be loaded (%2); install a version of it that fits the others.</source>
        <translation>Un paquet du Python %1 de QGIS ne peut pas être chargé (%2) ; installez-en une version compatible avec les autres.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>run `%1`</source>
        <translation>exécutez `%1`</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>in the OSGeo4W Shell</source>
        <translation>dans l&#x27;OSGeo4W Shell</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>run `%1 -m pip install --user %2`%3</source>
        <translation>exécutez `%1 -m pip install --user %2`%3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>add %1 with the OSGeo4W installer</source>
        <translation>ajoutez %1 avec l&#x27;installeur OSGeo4W</translation>
    </message>
    <message>
        <location filename="../../processing_provider/dependencies.py"/>
        <source>install %1 from the source of QGIS, not by pip</source>
        <translation>installez %1 depuis la source de QGIS, et non par pip</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Wall</source>
        <translation>Mur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Thickness (m)</source>
        <translation>Épaisseur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the thickness (m)</source>
        <translation>Écart-type de l&#x27;épaisseur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Base (m)</source>
        <translation>Base (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Top (m)</source>
        <translation>Sommet (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Azimuth (°)</source>
        <translation>Azimut (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Radius (m)</source>
        <translation>Rayon (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Density (standard deviations)</source>
        <translation>Densité (écarts-types)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Share of the outline with points</source>
        <translation>Part du contour portant des points</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Distance of the points, rms (m)</source>
        <translation>Distance des points, rms (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number of thresholds</source>
        <translation>Nombre de seuils</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Connected body</source>
        <translation>Corps connexe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Room</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Perimeter (m)</source>
        <translation>Périmètre (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Openings</source>
        <translation>Ouvertures</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Floor (m)</source>
        <translation>Sol (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Ceiling (m)</source>
        <translation>Plafond (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Share of the border that was seen</source>
        <translation>Part du bord qui a été vue</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Boundary of</source>
        <translation>Limite de</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Median offset (m)</source>
        <translation>Décalage médian (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Largest offset (m)</source>
        <translation>Décalage maximal (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Head</source>
        <translation>Forme du linteau</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Measured sides</source>
        <translation>Côtés mesurés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Completed sides</source>
        <translation>Côtés complétés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Open sides</source>
        <translation>Côtés ouverts</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Depth of the wall (m)</source>
        <translation>Profondeur du mur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the width (m)</source>
        <translation>Écart-type de la largeur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation of the height (m)</source>
        <translation>Écart-type de la hauteur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, left (m)</source>
        <translation>Écart-type, gauche (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, right (m)</source>
        <translation>Écart-type, droite (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, bottom (m)</source>
        <translation>Écart-type, bas (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, top (m)</source>
        <translation>Écart-type, haut (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Depth behind the wall (m)</source>
        <translation>Profondeur derrière le mur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Red (0 to 255)</source>
        <translation>Rouge (0 à 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Green (0 to 255)</source>
        <translation>Vert (0 à 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Blue (0 to 255)</source>
        <translation>Bleu (0 à 255)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Intensity</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, x (m)</source>
        <translation>Origine, x (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, y (m)</source>
        <translation>Origine, y (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin, z (m)</source>
        <translation>Origine, z (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Tilt (°)</source>
        <translation>Inclinaison (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Plane</source>
        <translation>Plan</translation>
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
        <translation>Distance à l&#x27;origine (m)</translation>
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
        <translation>Cible</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Control point</source>
        <translation>Point d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Surveyed (1 yes)</source>
        <translation>Levé (1 oui)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Used (1 yes)</source>
        <translation>Utilisé (1 oui)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Residual (m)</source>
        <translation>Résidu (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Residual, %1 (m)</source>
        <translation>Résidu, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Redundancy, %1</source>
        <translation>Part de redondance, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Baarda&#x27;s w, %1</source>
        <translation>w de Baarda, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Pope&#x27;s t, %1</source>
        <translation>t de Pope, %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Minimal detectable bias, %1 (m)</source>
        <translation>Plus petite erreur détectable, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Confidence ellipsoid, semi-axis %1 (m)</source>
        <translation>Ellipsoïde de confiance, demi-axe %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Size (m)</source>
        <translation>Taille (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation in space (m)</source>
        <translation>Écart-type dans l&#x27;espace (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Distance from the scanner (m)</source>
        <translation>Distance au scanner (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Angle of incidence (°)</source>
        <translation>Angle d&#x27;incidence (°)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Quality (0 to 1)</source>
        <translation>Qualité (0 à 1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Doubtful (1 yes)</source>
        <translation>Douteuse (1 oui)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Reason of the doubt</source>
        <translation>Raison du doute</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Standard deviation, %1 (m)</source>
        <translation>Écart-type, %1 (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Correlation, %1 and %2</source>
        <translation>Corrélation, %1 et %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Number of scans</source>
        <translation>Nombre de scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/fields.py"/>
        <source>Seen by</source>
        <translation>Vu par</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>Targets found in %1 have no names; set MATCHING to distances, or choose a list.</source>
        <translation>Les cibles trouvées dans %1 n&#x27;ont pas de nom ; mettez MATCHING sur les distances, ou choisissez une liste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>Searching %1 scans for targets, because they have no lists.</source>
        <translation>Recherche de cibles dans %1 scans, car ils n&#x27;ont pas de liste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>No target was found in the scans; the log says which tests failed, and how near. Pick the targets, or try &#x27;Find targets in scans&#x27; with the size of the targets.</source>
        <translation>Aucune cible n&#x27;a été trouvée dans les scans ; le journal dit quels critères ont échoué, et de combien. Pointez les cibles, ou essayez « Trouver les cibles dans les scans » avec la taille des cibles.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>TARGETS has a list and a scan called %1; remove one of them.</source>
        <translation>TARGETS a une liste et un scan appelés %1 ; supprimez l&#x27;un des deux.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>%1: %2 targets, %3 doubtful.</source>
        <translation>%1 : %2 cibles, %3 douteuses.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>The %1 target at %2 in %3</source>
        <translation>La cible (%1) en %2 dans %3</translation>
    </message>
    <message>
        <location filename="../../processing_provider/found_targets.py"/>
        <source>%1 is doubtful: %2.</source>
        <translation>%1 est douteuse : %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/help.py"/>
        <source>Advanced parameters</source>
        <translation>Paramètres avancés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/help.py"/>
        <location filename="../../processing_provider/model.py"/>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <location filename="../../processing_provider/interruption.py"/>
        <source>The first run on this computer compiles its kernels, which takes up to a minute.</source>
        <translation>La première exécution sur cet ordinateur compile les noyaux de calcul, ce qui prend jusqu&#x27;à une minute.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/composition.py"/>
        <source>Coordinates</source>
        <translation>Coordonnées</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/export.py"/>
        <source>%1 cannot be written; choose another name or folder.</source>
        <translation>%1 ne peut pas être écrit ; choisissez un autre nom ou dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/layouts/sheet.py"/>
        <source>At 1:%1 the drawing needs %2 x %3 mm, and %4 has %5 x %6 mm for it; choose a larger SHEET or SCALE.</source>
        <translation>À 1:%1, le dessin demande %2 x %3 mm, et %4 lui offre %5 x %6 mm ; choisissez une plus grande valeur de SHEET ou de SCALE.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Register scans to control points…</source>
        <translation>Recaler des scans sur des points d&#x27;appui…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Site plan from laser scans…</source>
        <translation>Plan du site à partir de scans laser…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Details of a facade…</source>
        <translation>Détails d&#x27;une façade…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Example data…</source>
        <translation>Données d&#x27;exemple…</translation>
    </message>
    <message>
        <location filename="../../processing_provider/menu.py"/>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Report of the site plan</source>
        <translation>Rapport du plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets are found in the scans, or read from lists. Scans are registered by them, transformed to the control points, and drawn as a site plan.</source>
        <translation>Les cibles sont trouvées dans les scans, ou lues dans des listes. Les scans sont recalés par elles, transformés sur les points d&#x27;appui, et dessinés en plan.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z.</source>
        <translation>Points levés, en mètres : un fichier texte avec x y z ou nom x y z.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>One point cloud for each scan, in the scanner&#x27;s own frame.</source>
        <translation>Un nuage de points par scan, dans le repère du scanner.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Such as EPSG:25833. Without it, the plan has no reference system.</source>
        <translation>Par exemple EPSG:25833. Sans lui, le plan n&#x27;a pas de système de référence.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets picked in the scans: text files with the names of the scans. In a scan without a list, black and white targets and spheres are found.</source>
        <translation>Cibles pointées dans les scans : fichiers texte aux noms des scans. Dans un scan sans liste, les cibles noir et blanc et les sphères sont détectées.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Models</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Control points and scans to site plan</source>
        <translation>Des points d&#x27;appui et scans au plan du site</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Scans; a scan has the name of its list</source>
        <translation>Scans ; un scan porte le nom de sa liste</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Reference system of the control points</source>
        <translation>Système de coordonnées des points d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/control_points_and_scans_to_site_plan.model3"/>
        <source>Targets, one list for each scan; found in scans without a list</source>
        <translation>Cibles, une liste par scan ; cherchées dans les scans sans liste</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>The details of a facade are measured, drawn, listed, and laid out on a sheet at 1:50.</source>
        <translation>Les détails d&#x27;une façade sont mesurés, dessinés, listés, et mis en page sur une feuille à 1:50.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>One or more point clouds of one facade, with colours or intensities.</source>
        <translation>Un ou plusieurs nuages de points d&#x27;une façade, avec couleurs ou intensités.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Facade to drawing</source>
        <translation>De la façade au dessin</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/facade_to_drawing.model3"/>
        <source>Scans of the facade</source>
        <translation>Scans de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Rooms of the lower storey</source>
        <translation>Pièces de l&#x27;étage inférieur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Walls of the lower storey</source>
        <translation>Murs de l&#x27;étage inférieur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Rooms of the upper storey</source>
        <translation>Pièces de l&#x27;étage supérieur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Walls of the upper storey</source>
        <translation>Murs de l&#x27;étage supérieur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Two storeys of a building are drawn from the same scans, each between the slabs around it.</source>
        <translation>Deux étages d&#x27;un bâtiment sont dessinés à partir des mêmes scans, chacun entre les dalles qui l&#x27;encadrent.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>One or more point clouds of one building, in one reference system.</source>
        <translation>Un ou plusieurs nuages de points d&#x27;un bâtiment, dans un seul système de référence.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>In the coordinates of the scans: between the ceiling below the slab and the floor above it.</source>
        <translation>Dans les coordonnées des scans : entre le plafond sous la dalle et le sol au-dessus.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Storeys one by one</source>
        <translation>Étage par étage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab below the lower storey (m)</source>
        <translation>Hauteur dans la dalle sous l&#x27;étage inférieur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab between the storeys (m)</source>
        <translation>Hauteur dans la dalle entre les étages (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/models/storeys_one_by_one.model3"/>
        <source>Height within the slab above the upper storey (m)</source>
        <translation>Hauteur dans la dalle au-dessus de l&#x27;étage supérieur (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Point clouds</source>
        <translation>Nuages de points</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>One or more scans of one site: %1; or a folder of them. On the command line, repeat INPUT=file or separate the files by semicolons.</source>
        <translation>Un ou plusieurs scans d&#x27;un site : %1 ; ou un dossier qui les contient. En ligne de commande, répétez INPUT=fichier ou séparez les fichiers par des points-virgules.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Point spacing</source>
        <translation>Espacement des points</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Points closer than this to a point that is kept are left out, so that a surface counts the same near the scanner and far from it. 0.05 m suits most sites; a finer spacing needs denser scans.</source>
        <translation>Les points plus proches d&#x27;un point gardé sont écartés, pour qu&#x27;une surface compte autant près du scanner que loin de lui. 0.05 m convient à la plupart des sites ; un espacement plus fin demande des scans plus denses.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Pixel size</source>
        <translation>Taille de pixel</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Edge of a pixel of the rasters. 0.10 m suits most sites; it should be about twice the point spacing.</source>
        <translation>Côté d&#x27;un pixel des rasters. 0.10 m convient à la plupart des sites ; il devrait être environ le double de l&#x27;espacement des points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Coordinate reference system, if the clouds name none</source>
        <translation>Système de coordonnées de référence, si les nuages n&#x27;en indiquent pas</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Projected, in metres. Used only for files without a reference system.</source>
        <translation>Projeté, en mètres. Utilisé seulement pour les fichiers sans système de référence.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Dask scheduler</source>
        <translation>Ordonnanceur Dask</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Address of the scheduler of a Dask cluster, like tcp://192.168.0.10:8786. Its workers read the clouds and work on them instead of this computer, with the same result; they must find the files by the same paths. Leave it empty to work on this computer.</source>
        <translation>Adresse de l’ordonnanceur d’un cluster Dask, comme tcp://192.168.0.10:8786. Ses workers lisent et traitent les nuages à la place de cet ordinateur, avec le même résultat ; ils doivent trouver les fichiers par les mêmes chemins. Laissez vide pour travailler sur cet ordinateur.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>Neighbourhood</source>
        <translation>Voisinage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>A point spreads over the pixels up to this far from its own, by inverse distance. 0 counts points per pixel; more than 1 blurs.</source>
        <translation>Un point se répartit sur les pixels jusqu&#x27;à cette distance du sien, selon l&#x27;inverse de la distance. 0 compte les points par pixel ; plus de 1 rend flou.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/clouds.py"/>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/definitions.py"/>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Lowest height</source>
        <translation>Hauteur la plus basse</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points below are left out. For a storey, a height within the slab below its floor.</source>
        <translation>Les points situés plus bas sont écartés. Pour un étage, une hauteur dans la dalle sous son sol.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Highest height</source>
        <translation>Hauteur la plus haute</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Points from this height on are left out. For a storey, a height within the slab above it.</source>
        <translation>Les points à partir de cette hauteur sont écartés. Pour un étage, une hauteur dans la dalle au-dessus.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Heights are counted from</source>
        <translation>Les hauteurs sont comptées depuis</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>What ZMIN and ZMAX are counted from. Choose the local ground on a slope.</source>
        <translation>D&#x27;où ZMIN et ZMAX sont comptés. Sur une pente, choisissez le sol local.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>zero of the coordinates</source>
        <translation>zéro des coordonnées</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>local ground</source>
        <translation>sol local</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>GeoTIFF with the bands density, occupied height, base, top, ground, spread and hanging height.</source>
        <translation>GeoTIFF avec les bandes densité, hauteur occupée, base, sommet, sol, dispersion et hauteur suspendue.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/density.py"/>
        <source>Density image: %1 x %2 pixels of %3 m.</source>
        <translation>Image de densité : %1 x %2 pixels de %3 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>, in lower case</source>
        <translation>, en minuscules</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written; end the name in %3%4.</source>
        <translation>%1 %2 ne peut pas être écrit ; terminez le nom par %3%4.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written; choose another name or folder.</source>
        <translation>%1 %2 ne peut pas être écrit ; choisissez un autre nom ou dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 cannot be written because the folder %3 does not exist; create it first.</source>
        <translation>%1 %2 ne peut pas être écrit, car le dossier %3 n&#x27;existe pas ; créez-le d&#x27;abord.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 is empty; choose a file to write.</source>
        <translation>%1 est vide ; choisissez un fichier à écrire.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 files (*%2)</source>
        <translation>Fichiers %1 (*%2)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>JSON files (*.json)</source>
        <translation>Fichiers JSON (*.json)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>CSV files (*.csv)</source>
        <translation>Fichiers CSV (*.csv)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>DXF files (*.dxf)</source>
        <translation>Fichiers DXF (*.dxf)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>PDF files (*.pdf)</source>
        <translation>Fichiers PDF (*.pdf)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>SVG files (*.svg)</source>
        <translation>Fichiers SVG (*.svg)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>HTML files (*.html *.htm)</source>
        <translation>Fichiers HTML (*.html *.htm)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>an input</source>
        <translation>une entrée</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/destinations.py"/>
        <source>%1 %2 is %3 as well; choose another name.</source>
        <translation>%1 %2 est aussi %3 ; choisissez un autre nom.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <location filename="../../processing_provider/parameters/map_layers.py"/>
        <source>%1 %2 cannot be read; choose another layer.</source>
        <translation>%1 %2 ne peut pas être lu ; choisissez une autre couche.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has a shape that cannot be read (%2); correct or remove it.</source>
        <translation>%1 contient une forme qui ne peut pas être lue (%2) ; corrigez-la ou supprimez-la.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has a shape whose coordinates are not numbers; correct or remove it.</source>
        <translation>%1 a une forme dont les coordonnées ne sont pas des nombres ; corrigez-la ou supprimez-la.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/drawn_shapes.py"/>
        <source>%1 has no lines or polygons; draw one, or leave it empty.</source>
        <translation>%1 n&#x27;a ni lignes ni polygones ; dessinez-en, ou laissez-le vide.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Distance from a plane</source>
        <translation>Distance à un plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of a point from its plane (ds of the paper). Points further behind the wall belong to an opening or a recess, points further in front of it to a projection. Decrease it for shallow recesses, increase it for rough or bulging walls.</source>
        <translation>Plus grande distance d&#x27;un point à son plan (ds de l&#x27;article). Les points plus loin derrière le mur appartiennent à une baie ou à un renfoncement, les points plus loin devant à une saillie. Diminuez-la pour des renfoncements peu profonds, augmentez-la pour des murs rugueux ou bombés.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Number of the facade</source>
        <translation>Numéro de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Which facade of a building or a street is measured. 0 takes the one that most points see from the stations, or that most points lie on if no position of a scanner is known. The report lists all with their numbers.</source>
        <translation>Quelle façade d&#x27;un bâtiment ou d&#x27;une rue est mesurée. 0 prend celle dont le plus de points sont vus des stations, ou celle qui porte le plus de points si aucune position de scanner n&#x27;est connue. Le rapport les liste toutes avec leurs numéros.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0: the one most seen</source>
        <translation>0 : la plus vue</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Point near the facade</source>
        <translation>Point proche de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Measures the facade nearest to this point, in the coordinates of the cloud; FACADE is then ignored.</source>
        <translation>Mesure la façade la plus proche de ce point, dans les coordonnées du nuage ; FACADE est alors ignoré.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Lines or walls along the facade</source>
        <translation>Lignes ou murs le long de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Measures the facade along a line that is drawn near to it, or along a wall of a plan, for example of siteplan, in the coordinates of the cloud. Of several, selected features only if you choose so, the facade that the most runs along. A folder of every facade then has those along the lines: a polygon of a building chooses its facades among those of a street. FACADE and FACADE_NEAR choose among all.</source>
        <translation>Mesure la façade le long d&#x27;une ligne dessinée près d&#x27;elle, ou le long d&#x27;un mur d&#x27;un plan, par exemple de siteplan, dans les coordonnées du nuage. S&#x27;il y en a plusieurs, ou les seules entités sélectionnées si vous le choisissez, la façade longée sur la plus grande longueur. Un dossier de toutes les façades contient alors celles qui longent les lignes : le polygone d&#x27;un bâtiment choisit ses façades parmi celles d&#x27;une rue. FACADE et FACADE_NEAR choisissent parmi toutes.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Side of the facade</source>
        <translation>Côté de la façade</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>The side from which the facade is seen; seen from the other side, an elevation is mirrored. Automatic uses the position of the scanner where the files state it, otherwise what is seen through the openings. The log says which side was taken, why, and how certain that is. In a folder of every facade, it applies to the chosen one; the side of the others is found.</source>
        <translation>Le côté d&#x27;où la façade est vue ; vue de l&#x27;autre côté, une élévation est inversée en miroir. Automatique utilise la position du scanner si les fichiers l&#x27;indiquent, sinon ce qui est vu à travers les ouvertures. Le journal dit quel côté a été retenu, pourquoi, et avec quelle certitude. Dans un dossier de toutes les façades, il vaut pour celle qui est choisie ; le côté des autres est trouvé.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facing east (azimuth 0 to 180)</source>
        <translation>Vers l&#x27;est (azimut 0 à 180)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facing west (azimuth 180 to 360)</source>
        <translation>Vers l&#x27;ouest (azimut 180 à 360)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Points of the smallest plane</source>
        <translation>Points du plus petit plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Planes with fewer points are left out. If not set: 1 % of the points of the main plane, at least 100.</source>
        <translation>Les plans avec moins de points sont écartés. Si vide : 1 % des points du plan principal, au moins 100.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest number of planes</source>
        <translation>Plus grand nombre de plans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Includes the main plane. Of the others, the largest are kept.</source>
        <translation>Comprend le plan principal. Des autres, les plus grands sont gardés.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Radius of a seed surface</source>
        <translation>Rayon d&#x27;une surface germe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A region of one colour starts from a surface of this radius (td of the paper), or of half or a quarter of it on small details.</source>
        <translation>Une région d&#x27;une couleur part d&#x27;une surface de ce rayon (td de l&#x27;article), ou de la moitié ou du quart sur de petits détails.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour distance of a seed</source>
        <translation>Distance de couleur d&#x27;un germe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of the colour of a seed from the mean of its surface (tr of the paper).</source>
        <translation>Plus grande distance de la couleur d&#x27;un germe à la moyenne de sa surface (tr de l&#x27;article).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0 to 255</source>
        <translation>0 à 255</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour variance of a seed surface</source>
        <translation>Variance de couleur d&#x27;une surface germe</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest sum of the variances of red, green and blue in a seed surface (Vr of the paper). If not set: 200 as in the paper, or twice the measured colour noise, if larger.</source>
        <translation>Plus grande somme des variances du rouge, du vert et du bleu dans une surface germe (Vr de l&#x27;article). Si vide : 200 comme dans l&#x27;article, ou le double du bruit mesuré des couleurs, s&#x27;il est plus grand.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>0 to 255, squared</source>
        <translation>0 à 255, au carré</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Colour distance of a region</source>
        <translation>Distance de couleur d&#x27;une région</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest distance of the colour of a point from the mean of the region that it joins (tr2 of the paper). Decrease it to separate similar colours.</source>
        <translation>Plus grande distance de la couleur d&#x27;un point à la moyenne de la région qu&#x27;il rejoint (tr2 de l&#x27;article). Diminuez-la pour séparer des couleurs proches.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Intensity difference of surfaces</source>
        <translation>Différence d&#x27;intensité des surfaces</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Regions whose mean intensities differ by less are one surface (f of the paper), so that shadows do not become details. A share of the intensity of the wall. If not set: twice the measured intensity noise.</source>
        <translation>Les régions dont les intensités moyennes diffèrent de moins forment une seule surface (f de l&#x27;article), pour que les ombres ne deviennent pas des détails. Une part de l&#x27;intensité du mur. Si vide : le double du bruit mesuré de l&#x27;intensité.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Large triangles</source>
        <translation>Grands triangles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A triangle between points of a plane is large if its area exceeds the mean by this factor (delta of the paper).</source>
        <translation>Un triangle entre des points d&#x27;un plan est grand si sa surface dépasse la moyenne de ce facteur (delta de l&#x27;article).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>mean areas</source>
        <translation>surfaces moyennes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Large triangles of a point</source>
        <translation>Grands triangles d&#x27;un point</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A point that belongs to more large triangles is noise (eta of the paper).</source>
        <translation>Un point qui appartient à plus de grands triangles est du bruit (êta de l&#x27;article).</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Rounds of noise removal</source>
        <translation>Passes de suppression du bruit</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Largest number of rounds; they end when no noise is left. 0 keeps all points.</source>
        <translation>Plus grand nombre de passes ; elles s&#x27;arrêtent quand il ne reste plus de bruit. 0 garde tous les points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>rounds</source>
        <translation>passes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Alpha of the outline</source>
        <translation>Alpha du contour</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Alpha-shape radius. Smaller keeps finer gaps, larger closes frayed outlines. If not set, it follows the spacing of the points.</source>
        <translation>Rayon de la forme alpha. Plus petit, il garde de plus fines lacunes, plus grand, il ferme des contours effilochés. Si vide, il suit l&#x27;espacement des points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Area of the smallest detail</source>
        <translation>Surface du plus petit détail</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Smaller details are left out. If not set: the square of SEED_RADIUS.</source>
        <translation>Les détails plus petits sont écartés. Si vide : le carré de SEED_RADIUS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Rectangles and arches</source>
        <translation>Rectangles et arcs</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Outlines become level and plumb rectangles, arches or circles where the points agree with such a shape. All other outlines follow the points. If off, all outlines follow the points.</source>
        <translation>Les contours deviennent des rectangles d&#x27;aplomb et de niveau, des arcs ou des cercles, là où les points s&#x27;accordent avec une telle forme. Tous les autres suivent les points. Désactivé, tous les contours suivent les points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Facades that turn</source>
        <translation>Façades à pans ou rondes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>A flat facade has one plane. Sides: the sides of a canted bay or a polygonal tower that meet at the facade are drawn beside each other, each in its own plane. Round: a round tower is rolled out, so that u runs along the arc of its outer face; the log states the radius. In a folder of every facade, those that do not turn are drawn flat.</source>
        <translation>Une façade plane a un seul plan. Pans : les pans d&#x27;un oriel à pans coupés ou d&#x27;une tour polygonale qui se touchent à la façade sont dessinés côte à côte, chacun dans son propre plan. Ronde : une tour ronde est développée, de sorte que u court le long de l&#x27;arc de son parement extérieur ; le journal indique le rayon. Dans un dossier de toutes les façades, celles qui ne tournent pas sont dessinées à plat.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Flat</source>
        <translation>Plane</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Sides of a bay or a tower</source>
        <translation>Pans d&#x27;un oriel ou d&#x27;une tour</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Round tower</source>
        <translation>Tour ronde</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Coloured details</source>
        <translation>Détails colorés</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Which regions of another colour become details. Those with a clear step: they are regular, and their colour changes sharply along the border, which the intensity confirms if there is one; stains, joints, shadows and lamplight are left out, and LEFT_OUT shows them. All regions: the chain of the paper, together with REGULARISE off. None: faster.</source>
        <translation>Quelles régions d&#x27;une autre couleur deviennent des détails. Celles au contraste net : elles sont régulières, et leur couleur change brusquement le long du bord, ce que l&#x27;intensité confirme s&#x27;il y en a une ; taches, joints, ombres et lueurs de lampe sont écartés, et LEFT_OUT les montre. Toutes les régions : la chaîne de l&#x27;article, avec REGULARISE désactivé. Aucune : plus rapide.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Those with a clear step</source>
        <translation>Celles au contraste net</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>All regions</source>
        <translation>Toutes les régions</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Pixel size of the orthoimage</source>
        <translation>Taille de pixel de l&#x27;orthoimage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>If not set: the spacing of the points, rounded up to 1, 2 or 5 times a power of ten.</source>
        <translation>Si vide : l&#x27;espacement des points, arrondi au-dessus à 1, 2 ou 5 fois une puissance de dix.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Fill holes of the orthoimage</source>
        <translation>Combler les trous de l&#x27;orthoimage</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade.py"/>
        <source>Pixels without points take the colour of the nearest pixel with points. If off, they are transparent.</source>
        <translation>Les pixels sans points prennent la couleur du plus proche pixel qui en a. Désactivé, ils sont transparents.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade_files.py"/>
        <source>Folder of every facade</source>
        <translation>Dossier de toutes les façades</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/facade_files.py"/>
        <source>Draws every facade of the cloud, or those along FACADE_ALONG, each into a folder of its own by its number: elevation, orthoimage, details in space, what is left out, report, and drawing if ezdxf is installed. One schedule lists the details of all. Takes as long for each facade as for one.</source>
        <translation>Dessine chaque façade du nuage, ou celles le long de FACADE_ALONG, chacune dans un dossier à son numéro : élévation, orthoimage, détails dans l&#x27;espace, ce qui est écarté, rapport, et dessin si ezdxf est installé. Une seule nomenclature liste les détails de toutes. Prend pour chaque façade autant de temps que pour une.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>Point clouds (%1)</source>
        <translation>Nuages de points (%1)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose at least one point cloud file.</source>
        <translation>%1 est vide ; choisissez au moins un fichier de nuage de points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose a raster.</source>
        <translation>%1 est vide ; choisissez un raster.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 files (*.%2);;All files (*)</source>
        <translation>Fichiers %1 (*.%2);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/files.py"/>
        <source>%1 is empty; choose a %2 file.</source>
        <translation>%1 est vide ; choisissez un fichier %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1, one by one</source>
        <translation>%1, un par un</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1 %2 still holds %3 of an earlier run; this one did not write it. Remove it, or choose a new folder.</source>
        <translation>%1 %2 contient encore %3 d&#x27;une exécution antérieure ; celle-ci ne l&#x27;a pas écrit. Supprimez-le, ou choisissez un nouveau dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/folders.py"/>
        <source>%1 %2 cannot be written to; choose another folder.</source>
        <translation>%1 %2 n&#x27;est pas accessible en écriture ; choisissez un autre dossier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/map_layers.py"/>
        <source>%1 is empty; choose a layer.</source>
        <translation>%1 est vide ; choisissez une couche.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1 %2 cannot be read</source>
        <translation>%1 %2 ne peut pas être lu</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1 is empty</source>
        <translation>%1 est vide</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/outlines.py"/>
        <source>%1; choose a layer of polygons.</source>
        <translation>%1 ; choisissez une couche de polygones.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>not set</source>
        <translation>vide</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default %2; %3.</source>
        <translation>%1 Par défaut %2 ; %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>whole number</source>
        <translation>nombre entier</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be a %2, %3 (%4), not %5.</source>
        <translation>%1 doit être un %2, %3 (%4), et non %5.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>from %1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 %2. Default 0.</source>
        <translation>%1 %2. Par défaut 0.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be %2, not %3.</source>
        <translation>%1 doit être %2, et non %3.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default yes.</source>
        <translation>%1 Par défaut oui.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 Default no.</source>
        <translation>%1 Par défaut non.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 doit être true ou false, et non %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be a point like 412345.6,5812345.7, not %2.</source>
        <translation>%1 doit être un point comme 412345.6,5812345.7, et non %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 must be three numbers, x y z in metres, not %2.</source>
        <translation>%1 doit être trois nombres, x y z en mètres, et non %2.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/parameter.py"/>
        <source>%1 %2 is not known; write it like EPSG:25832.</source>
        <translation>%1 %2 est inconnu ; écrivez-le comme EPSG:25832.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>Lists of points (*.txt *.csv *.xyz *.asc *.pts *.gpkg *.shp *.geojson)</source>
        <translation>Listes de points (*.txt *.csv *.xyz *.asc *.pts *.gpkg *.shp *.geojson)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 is empty; choose a text file or a layer of points.</source>
        <translation>%1 est vide ; choisissez un fichier texte ou une couche de points.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 takes one list of points, not %2; choose one.</source>
        <translation>%1 prend une liste de points, et non %2 ; choisissez-en une.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 has two lists called %2; remove or rename one of them.</source>
        <translation>%1 a deux listes appelées %2 ; supprimez ou renommez l&#x27;une d&#x27;elles.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>%1 is not a layer of points; choose another.</source>
        <translation>%1 n&#x27;est pas une couche de points ; choisissez-en une autre.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>The file of the layer %1 is missing; repair the layer or choose another.</source>
        <translation>Le fichier de la couche %1 manque ; réparez la couche ou choisissez-en une autre.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/point_lists.py"/>
        <source>the layer %1</source>
        <translation>la couche %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights.</source>
        <translation>Points levés en mètres : un fichier texte avec x y z ou nom x y z, ou une couche de points avec des altitudes.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights. May be empty if REFINE is set and no scan has targets: surfaces then place the scans beside the first one.</source>
        <translation>Points levés en mètres : un fichier texte avec x y z ou nom x y z, ou une couche de points avec altitudes. Peut rester vide si REFINE est activé et qu&#x27;aucun scan n&#x27;a de cibles : les surfaces placent alors les scans à côté du premier.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Targets, one list for each scan, or the scans</source>
        <translation>Cibles, une liste par scan, ou les scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Targets picked in the scans, in the scanner&#x27;s own frame: text files or layers as for control points. The name of the file is the name of the scan; give the cloud the same name. Scans themselves may be given instead, or a folder of them: their targets are found on the way, unless there is a list of the same name. On the command line, repeat TARGETS=file or separate the files by semicolons.</source>
        <translation>Cibles pointées dans les scans, dans le repère du scanner : fichiers texte ou couches comme pour les points d&#x27;appui. Le nom du fichier est le nom du scan ; donnez le même nom au nuage. Les scans eux-mêmes peuvent être donnés à la place, ou un dossier qui les contient : leurs cibles sont trouvées en chemin, sauf s&#x27;il y a une liste du même nom. En ligne de commande, répétez TARGETS=fichier ou séparez les fichiers par des points-virgules.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Matching</source>
        <translation>Appariement</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>How targets are matched with control points. By distances, no names are needed. By names, the distances reveal wrong names.</source>
        <translation>Comment les cibles sont appariées aux points d&#x27;appui. Par les distances, aucun nom n&#x27;est nécessaire. Par les noms, les distances révèlent les noms faux.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>By distances</source>
        <translation>Par les distances</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>By names</source>
        <translation>Par les noms</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Standard deviation of a target</source>
        <translation>Écart-type d&#x27;une cible</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Of each coordinate of a picked target, before the adjustment. The statistics test whether it is right. Targets with standard deviations of their own, as &#x27;Find targets in scans&#x27; writes them, are adjusted with these; SIGMA then says only how exactly distances match.</source>
        <translation>De chaque coordonnée d&#x27;une cible pointée, avant la compensation. Les statistiques vérifient s&#x27;il est juste. Les cibles qui ont leurs propres écarts-types, tels que les écrit « Trouver les cibles dans les scans », sont compensées avec ceux-ci ; SIGMA dit alors seulement avec quelle précision les distances concordent.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Standard deviation of a control point</source>
        <translation>Écart-type d&#x27;un point d&#x27;appui</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Of each coordinate of a surveyed point. 0 holds the surveyed points fixed; if targets have standard deviations of their own, 0 takes the one of targets without.</source>
        <translation>De chaque coordonnée d&#x27;un point levé. 0 tient fixes les points levés ; si des cibles ont leurs propres écarts-types, 0 prend celui des cibles qui n&#x27;en ont pas.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Tolerance of distances</source>
        <translation>Tolérance sur les distances</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Largest difference between a distance of targets and the matching distance of control points. If not set, it is derived from the standard deviations and written to the log.</source>
        <translation>Plus grande différence entre une distance de cibles et la distance correspondante de points d&#x27;appui. Si vide, elle est déduite des écarts-types et écrite dans le journal.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Largest standard deviation of a scan without a warning</source>
        <translation>Plus grand écart-type d&#x27;un scan sans avertissement</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>A scan whose targets are less accurate after the adjustment is registered with a warning, as at the end of a chain of scans. If not set, it is ten times SIGMA.</source>
        <translation>Un scan dont les cibles sont moins précises après la compensation est recalé avec un avertissement, comme au bout d&#x27;une chaîne de scans. Si vide, dix fois SIGMA.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Transformation</source>
        <translation>Transformation</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Which parameters are estimated. Choose levelled if the compensator of the scanner was on, and unknown scale for models that have none, for example from photographs.</source>
        <translation>Quels paramètres sont estimés. Choisissez nivelé si le compensateur du scanner était en marche, et échelle inconnue pour des modèles qui n&#x27;en ont pas, par exemple issus de photographies.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Rigid, 6 parameters</source>
        <translation>Rigide, 6 paramètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>With a scale near 1, 7 parameters</source>
        <translation>Avec une échelle proche de 1, 7 paramètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Levelled, 4 parameters</source>
        <translation>Nivelé, 4 paramètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Levelled with a scale near 1, 5 parameters</source>
        <translation>Nivelé, avec une échelle proche de 1, 5 paramètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Unknown scale, 7 parameters</source>
        <translation>Échelle inconnue, 7 paramètres</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Tie scans by the surfaces that they share</source>
        <translation>Relier les scans par leurs surfaces communes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Walls, floors and other plane surfaces that two scans see tie the scans to each other, together with the targets and never against them. Scans with too few targets, or none, are placed by their surfaces if these show one pose only. Needs the clouds: in TARGETS or in SCANS.</source>
        <translation>Les murs, les sols et d&#x27;autres surfaces planes que deux scans voient lient les scans entre eux, avec les cibles et jamais contre elles. Les scans qui ont trop peu de cibles, ou aucune, sont placés par leurs surfaces si celles-ci ne montrent qu&#x27;une pose. Nécessite les nuages : dans TARGETS ou dans SCANS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Clouds of the scans, to tie them by surfaces</source>
        <translation>Nuages des scans, pour les relier par des surfaces</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>The clouds of scans whose targets are given as lists; each is named after its list. A cloud without a list is placed by its surfaces. Not needed for scans that are in TARGETS. Used only if scans are tied by surfaces.</source>
        <translation>Les nuages des scans dont les cibles sont données en listes ; chacun porte le nom de sa liste. Un nuage sans liste est placé par ses surfaces. Inutile pour les scans qui sont dans TARGETS. Utilisé seulement si les scans sont liés par des surfaces.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Coordinate reference system, if the control points have none</source>
        <translation>Système de coordonnées de référence, si les points d&#x27;appui n&#x27;en ont pas</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>Projected, in metres. Used only for control points without a reference system.</source>
        <translation>Projeté, en mètres. Utilisé seulement pour les points d&#x27;appui sans système de référence.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>CONTROL is empty; choose a text file or a layer of points, or set REFINE to place clouds without targets by their surfaces.</source>
        <translation>CONTROL est vide ; choisissez un fichier texte ou une couche de points, ou activez REFINE pour placer par leurs surfaces les nuages sans cibles.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/registration.py"/>
        <source>CONTROL is empty, but TARGETS has lists; choose the control points, or the list of one of the scans in their place.</source>
        <translation>CONTROL est vide, mais TARGETS contient des listes ; choisissez les points d&#x27;appui, ou à leur place la liste d&#x27;un des scans.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Widest door of a room</source>
        <translation>Porte la plus large d&#x27;une pièce</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Gaps in walls up to this width are bridged for ROOMS. Leaves of doors are up to 1.25 m wide, and corridors seldom narrower than 1.3 m. Raise it for gates and broken walls.</source>
        <translation>Les lacunes des murs jusqu&#x27;à cette largeur sont franchies pour ROOMS. Les vantaux ont jusqu&#x27;à 1.25 m de large, et les couloirs rarement moins de 1.3 m. Augmentez-la pour des portails et des murs interrompus.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Plan of the storey under a ceiling</source>
        <translation>Plan de l&#x27;étage sous un plafond</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Where a ceiling was seen, walls and rooms come from the faces and the floor of the storey, also behind furniture and across glazing. No uses the density image everywhere. Needs REFINE.</source>
        <translation>Là où un plafond a été vu, murs et pièces viennent des parements et du sol de l&#x27;étage, aussi derrière le mobilier et à travers les vitrages. Non utilise partout l&#x27;image de densité. Demande REFINE.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Height of the cut above the floor</source>
        <translation>Hauteur de coupe au-dessus du sol</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Where a ceiling was seen, the plan shows what stands at this height above the floor. Faces are recognised over the full height of the storey.</source>
        <translation>Là où un plafond a été vu, le plan montre ce qui est debout à cette hauteur au-dessus du sol. Les parements sont reconnus sur toute la hauteur de l&#x27;étage.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Centrelines of the walls that meet at junctions, with thickness, azimuth or radius. GeoPackage or shapefile, by extension.</source>
        <translation>Axes des murs, qui se rejoignent en des nœuds, avec épaisseur, azimut ou rayon. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms between the faces of the walls, with area, perimeter, heights of floor and ceiling. GeoPackage or shapefile, by extension.</source>
        <translation>Pièces entre les parements des murs, avec surface, périmètre, hauteurs du sol et du plafond. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Limits of the scan</source>
        <translation>Limites du scan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Lines where a room ends without a wall, because the scan ends there. GeoPackage or shapefile, by extension.</source>
        <translation>Lignes où une pièce finit sans mur, car le scan s&#x27;y arrête. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Surfaces left out</source>
        <translation>Surfaces écartées</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Upright surfaces in rooms that are not walls, with the reason: furniture, curtains, door leaves. GeoPackage or shapefile, by extension.</source>
        <translation>Surfaces verticales dans les pièces qui ne sont pas des murs, avec la raison : mobilier, rideaux, vantaux. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>HTML page that shows what each parameter did, and which to change; see the results viewer.</source>
        <translation>Page HTML qui montre l&#x27;effet de chaque paramètre, et lequel changer ; voir la visionneuse de résultats.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>DXF file in metres: walls, faces, axes, and rooms with names and areas, on layers; needs the package ezdxf.</source>
        <translation>Fichier DXF en mètres : murs, parements, axes, et pièces avec noms et surfaces, sur des calques ; demande le paquet ezdxf.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Number of rooms, if ROOMS are made</source>
        <translation>Nombre de pièces, si ROOMS est produit</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Area of the rooms (m²), if ROOMS are made</source>
        <translation>Surface des pièces (m²), si ROOMS est produit</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>No ceiling was seen: the walls are those of the density image.</source>
        <translation>Aucun plafond n&#x27;a été vu : les murs sont ceux de l&#x27;image de densité.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Axes: %1, %2 m long.</source>
        <translation>Axes : %1, %2 m de long.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Rooms: %1, %2 m².</source>
        <translation>Pièces : %1, %2 m².</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/rooms.py"/>
        <source>Storey: floor at %1 m, ceiling at %2 m; points %3 cm apart, noise %4 mm. Borders of rooms without a wall: %5 m. Left out as furniture and the like: %6 m.</source>
        <translation>Étage : sol à %1 m, plafond à %2 m ; points espacés de %3 cm, bruit %4 mm. Bords de pièces sans mur : %5 m. Écartés comme mobilier et autres : %6 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Laser scans</source>
        <translation>Scans laser</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>One or more scans, each of one station: %1; or a folder of them. E57 and PTX files may hold several. On the command line, repeat INPUT=file or separate the files by semicolons.</source>
        <translation>Un ou plusieurs scans, chacun d&#x27;une station : %1 ; ou un dossier qui les contient. Les fichiers E57 et PTX peuvent en contenir plusieurs. En ligne de commande, répétez INPUT=fichier ou séparez les fichiers par des points-virgules.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Kind of targets</source>
        <translation>Type de cibles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>What is searched for. Black and white targets need intensities.</source>
        <translation>Ce qui est cherché. Les cibles noir et blanc demandent des intensités.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Black and white</source>
        <translation>Noir et blanc</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Spheres</source>
        <translation>Sphères</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Size of the targets</source>
        <translation>Taille des cibles</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Width of the black and white pattern, or diameter of the spheres. If not set, patterns of 75 to 300 mm and spheres of 76, 100, 139, 145, 150 and 200 mm are found. Set it for other spheres, or where a diameter is doubtful.</source>
        <translation>Largeur du motif noir et blanc, ou diamètre des sphères. Si vide, les motifs de 75 à 300 mm et les sphères de 76, 100, 139, 145, 150 et 200 mm sont trouvés. Indiquez-la pour d&#x27;autres sphères, ou si un diamètre est douteux.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Position of the scanner</source>
        <translation>Position du scanner</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>Where the scanner stood, x y z in the coordinates of the scan. If not set, the position that E57 and PTX files state is used; other files are in the scanner&#x27;s own frame, with the scanner at the origin.</source>
        <translation>Où se trouvait le scanner, x y z dans les coordonnées du scan. Si vide, la position qu&#x27;indiquent les fichiers E57 et PTX est utilisée ; les autres fichiers sont dans le repère du scanner, avec le scanner à l&#x27;origine.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/targets.py"/>
        <source>STATION belongs to one scan, and there are several; choose one, or leave it empty.</source>
        <translation>STATION appartient à un scan, et il y en a plusieurs ; choisissez-en un, ou laissez-le vide.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Lowest density threshold</source>
        <translation>Seuil de densité le plus bas</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Density from which a pixel may be wall. If not set, it is derived from the density of the horizontal surfaces and written to the log. Raise it if clutter is taken for walls.</source>
        <translation>Densité à partir de laquelle un pixel peut être mur. Si vide, elle est déduite de la densité des surfaces horizontales et écrite dans le journal. Augmentez-la si de l&#x27;encombrement est pris pour des murs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Smallest region</source>
        <translation>Plus petite région</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Regions with less area are dropped. If not set, it is the area of a metre of wall one pixel thick.</source>
        <translation>Les régions de surface moindre sont supprimées. Si vide, c&#x27;est la surface d&#x27;un mètre de mur épais d&#x27;un pixel.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Largest fill of connected or curved walls</source>
        <translation>Plus grand remplissage de murs reliés ou courbes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>A region consists of connected or curved walls if its area divided by the area of its bounding box is not above this.</source>
        <translation>Une région est faite de murs reliés ou courbes si sa surface divisée par celle de son rectangle englobant ne dépasse pas cette valeur.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>ratio</source>
        <translation>rapport</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Least elongation of a straight wall</source>
        <translation>Plus petit allongement d&#x27;un mur droit</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>A region is a straight wall if the major axis of its best-fit ellipse divided by the minor axis is not below this.</source>
        <translation>Une région est un mur droit si le grand axe de l&#x27;ellipse la mieux ajustée divisé par le petit axe n&#x27;est pas inférieur à cette valeur.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Widest gap to close</source>
        <translation>Plus large lacune à fermer</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Joins the two faces of a wall and bridges interruptions. If not set, it is 0.8 m where the heights show the ground between walls, so that doors are kept open, and 0.4 m where they do not.</source>
        <translation>Réunit les deux parements d&#x27;un mur et franchit les interruptions. Si vide, 0.8 m là où les hauteurs montrent le sol entre les murs, pour que les portes restent ouvertes, et 0.4 m ailleurs.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Least occupied height of a wall</source>
        <translation>Plus petite hauteur occupée d&#x27;un mur</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Height that the points of a pixel must fill between 0.3 and 2.3 m above the local ground. Removes floors and beams; also separates vegetation and furniture from walls. Lower it for low ruins; 0 uses density alone.</source>
        <translation>Hauteur que les points d&#x27;un pixel doivent remplir entre 0.3 et 2.3 m au-dessus du sol local. Supprime sols et poutres ; sépare aussi végétation et mobilier des murs. Diminuez-la pour des ruines basses ; 0 n&#x27;utilise que la densité.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Number of density thresholds</source>
        <translation>Nombre de seuils de densité</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls are looked for at this many thresholds from the lowest to the highest, and combined.</source>
        <translation>Les murs sont cherchés à autant de seuils, du plus bas au plus haut, et réunis.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Highest density threshold</source>
        <translation>Seuil de densité le plus haut</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>If not set, it is the median density of the pixels that may be wall.</source>
        <translation>Si vide, c&#x27;est la densité médiane des pixels qui peuvent être mur.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Number of walls</source>
        <translation>Nombre de murs</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Area of the walls (m²)</source>
        <translation>Surface des murs (m²)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Length of the walls (m)</source>
        <translation>Longueur des murs (m)</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Polygons with kind, length, thickness, base and top height. GeoPackage or shapefile, by extension.</source>
        <translation>Polygones avec type, longueur, épaisseur, hauteur de base et de sommet. GeoPackage ou shapefile, selon l&#x27;extension.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Wall pixels as a GeoTIFF: 1 wall, 0 none.</source>
        <translation>Pixels de mur en GeoTIFF : 1 mur, 0 rien.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Plan raster</source>
        <translation>Plan en raster</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Thresholds: %1 from %2 to %3 standard deviations.</source>
        <translation>Seuils : %1 de %2 à %3 écarts-types.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Smallest region: %1 m². Widest gap to close: %2 m.</source>
        <translation>Plus petite région : %1 m². Plus large lacune à fermer : %2 m.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/walls.py"/>
        <source>Walls: %1, %2 m², %3 m long.</source>
        <translation>Murs : %1, %2 m², %3 m de long.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>No files chosen</source>
        <translation>Aucun fichier choisi</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>1 file</source>
        <translation>1 fichier</translation>
    </message>
    <message>
        <location filename="../../processing_provider/parameters/widgets.py"/>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <location filename="../../processing_provider/provider.py"/>
        <source>Ichnograph: laser scans to site plans and elevations</source>
        <translation>Ichnograph : des scans laser aux plans et élévations</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 and %2 have the same name; rename one of them.</source>
        <translation>%1 et %2 ont le même nom ; renommez l’un des deux.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs the clouds of the scans; choose them in SCANS.</source>
        <translation>REFINE a besoin des nuages des scans ; les choisir dans SCANS.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs scans in metres, but with MODEL and MATCHING as chosen, their scale may be any; choose a MODEL without scale, or leave REFINE out.</source>
        <translation>REFINE a besoin de scans en mètres, mais avec MODEL et MATCHING tels que choisis, leur échelle peut être quelconque ; choisir un MODEL sans échelle, ou renoncer à REFINE.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>Finding the surfaces of %1</source>
        <translation>Recherche des surfaces de %1</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1: %2 plane cells.</source>
        <translation>%1 : %2 cellules planes.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 is not used to tie scans, because no list of targets has its name.</source>
        <translation>%1 n&#x27;est pas utilisé pour relier les scans, car aucune liste de cibles ne porte son nom.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 and %2 are both named after the list %3; choose one of them as its cloud.</source>
        <translation>%1 et %2 portent tous deux le nom de la liste %3 ; choisir l&#x27;un d&#x27;eux comme son nuage.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>%1 is not tied by surfaces, because no cloud has its name; its targets alone hold it.</source>
        <translation>%1 n&#x27;est pas relié par des surfaces, car aucun nuage ne porte son nom ; ses cibles seules le tiennent.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/scan_surfaces.py"/>
        <source>REFINE needs the clouds of at least two scans; choose them in SCANS, each named after its list.</source>
        <translation>REFINE a besoin des nuages d&#x27;au moins deux scans ; les choisir dans SCANS, chacun portant le nom de sa liste.</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/control_points.qml"/>
        <source>Surveyed</source>
        <translation>Levé</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/control_points.qml"/>
        <source>Appended from scans</source>
        <translation>Point nouveau issu des scans</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Opening</source>
        <translation>Baie</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Recess</source>
        <translation>Renfoncement</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Coloured detail</source>
        <translation>Détail coloré</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Projection</source>
        <translation>Saillie</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Not seen</source>
        <translation>Non vu</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/elevation.qml"/>
        <location filename="../../processing_provider/styles/facade_details.qml"/>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/facade_planes.qml"/>
        <source>Main plane</source>
        <translation>Plan principal</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/facade_planes.qml"/>
        <source>Secondary plane</source>
        <translation>Plan secondaire</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Reference, where the plan agrees</source>
        <translation>Référence, là où le plan concorde</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within a quarter of the tolerance of %1 m</source>
        <translation>Plan à moins d&#x27;un quart de la tolérance de %1 m</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within half of the tolerance</source>
        <translation>Plan à moins de la moitié de la tolérance</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Plan within the tolerance</source>
        <translation>Plan dans la tolérance</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Missing: only in the reference</source>
        <translation>Manquant : seulement dans la référence</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/plan_errors.qml"/>
        <source>Wrong: only in the plan</source>
        <translation>Faux : seulement dans le plan</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/residuals.qml"/>
        <source>Residual, %1 times: horizontal blue, height orange</source>
        <translation>Résidu, %1 fois : horizontal bleu, hauteur orange</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/residuals.qml"/>
        <source>Rejected target</source>
        <translation>Cible rejetée</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/targets.qml"/>
        <source>Doubtful</source>
        <translation>Douteuse</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Straight wall</source>
        <translation>Mur droit</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Connected or curved walls</source>
        <translation>Murs reliés ou courbes</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Column</source>
        <translation>Poteau</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Wall of a room</source>
        <translation>Mur d&#x27;une pièce</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Parapet, window above</source>
        <translation>Allège, fenêtre au-dessus</translation>
    </message>
    <message>
        <location filename="../../processing_provider/styles/walls.qml"/>
        <source>Other wall</source>
        <translation>Autre mur</translation>
    </message>
</context>
</TS>
