<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AboutCard</name>
    <message>
        <source>A simulator and trainer for needle procedures: forces, images and training. For training, not for treatment.</source>
        <translation>Ein Simulator und Trainer für Eingriffe mit der Nadel: Kräfte, Bilder und Übung. Zum Üben, nicht zum Behandeln.</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0, without any warranty.</source>
        <translation>Freie Software unter der Apache-Lizenz 2.0, ohne jede Gewähr.</translation>
    </message>
    <message>
        <source>Compiler</source>
        <translation>Übersetzer</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Betriebssystem</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the versions as text, for a bug report</source>
        <translation>Die Versionen als Text, für die Meldung eines Fehlers</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translation>Zurück (Esc)</translation>
    </message>
</context>
<context>
    <name>AtlasPage</name>
    <message>
        <source>Touch with the needle</source>
        <translation>Mit der Nadel berühren</translation>
    </message>
    <message>
        <source>The needle of your device shows points on the body, without force (T)</source>
        <translation>Die Nadel Ihres Geräts zeigt Punkte am Körper, ohne Kraft (T)</translation>
    </message>
    <message>
        <source>The mouse points by itself. Choose a device under Devices to touch with its needle.</source>
        <translation>Die Maus zeigt von selbst. Wählen Sie unter Geräte ein Gerät, um mit seiner Nadel zu berühren.</translation>
    </message>
    <message>
        <source>Touch a point with the needle. Wheel to come nearer, drag to turn.</source>
        <translation>Berühren Sie einen Punkt mit der Nadel. Rad: näher, Ziehen: drehen.</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Luo-connecting point&lt;/b&gt; Its collateral %1.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Luo-Verbindungspunkt&lt;/b&gt; Sein Nebengefäß %1.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Luo-connecting point&lt;/b&gt; Its collateral goes to the %1 meridian; the dashed line to the source point %2 is a scheme, no course is published.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Luo-Verbindungspunkt&lt;/b&gt; Sein Nebengefäß führt zum Meridian %1; die gestrichelte Linie zum Ursprungspunkt %2 ist ein Schema, kein Verlauf ist veröffentlicht.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>And needle it</source>
        <translation>Und nadeln</translation>
    </message>
    <message>
        <source>Where you show the point, the needle goes in; the true point is shown afterwards</source>
        <translation>Wo Sie den Punkt zeigen, geht die Nadel hinein; der wahre Punkt wird danach gezeigt</translation>
    </message>
    <message>
        <source>Code, name or meridian</source>
        <translation>Code, Name oder Meridian</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Practise this point</source>
        <translation>Diesen Punkt üben</translation>
    </message>
    <message>
        <source>Needle it in a block of the body around it</source>
        <translation>Nadeln in einem Block des Körpers um ihn herum</translation>
    </message>
    <message>
        <source>Find points</source>
        <translation>Punkte finden</translation>
    </message>
    <message>
        <source>Show on the body where a named point is (N)</source>
        <translation>Ein Punkt wird genannt, Sie zeigen ihn am Körper (N)</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>Noch einmal derselbe</translation>
    </message>
    <message>
        <source>Show the same point once more (A)</source>
        <translation>Denselben Punkt noch einmal zeigen (A)</translation>
    </message>
    <message>
        <source>Back to the atlas</source>
        <translation>Zurück zum Atlas</translation>
    </message>
    <message>
        <source>Stop finding points (Esc)</source>
        <translation>Nicht weiter gefragt werden (Esc)</translation>
    </message>
    <message>
        <source>For training scenes, not for treatment.</source>
        <translation>Zum Üben, nicht zur Behandlung.</translation>
    </message>
    <message>
        <source>Preparing the body: %1 %</source>
        <translation>Der Körper wird vorbereitet: %1 %</translation>
    </message>
    <message>
        <source>Preparing %1: %2 %</source>
        <translation>%1 wird vorbereitet: %2 %</translation>
    </message>
    <message>
        <source>No point of that name.</source>
        <translation>Kein Punkt mit diesem Namen.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Touch a point on the body, or search for one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Berühren Sie einen Punkt am Körper, oder suchen Sie einen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p style='font-size:18px'&gt;&lt;b&gt;%1&lt;/b&gt; %2 %3&lt;/p&gt;&lt;p&gt;%4 meridian, %5&lt;/p&gt;</source>
        <translation>&lt;p style='font-size:18px'&gt;&lt;b&gt;%1&lt;/b&gt; %2 %3&lt;/p&gt;&lt;p&gt;Meridian: %4, %5&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Depth&lt;/b&gt; %1 to %2 mm&lt;br&gt;&lt;b&gt;Angle&lt;/b&gt; %3 degrees to the skin%4&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Tiefe&lt;/b&gt; %1 bis %2 mm&lt;br&gt;&lt;b&gt;Winkel&lt;/b&gt; %3 Grad zur Haut%4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p style='color:#F2A33C'&gt;&lt;b&gt;Caution&lt;/b&gt; %1&lt;/p&gt;</source>
        <translation>&lt;p style='color:#F2A33C'&gt;&lt;b&gt;Vorsicht&lt;/b&gt; %1&lt;/p&gt;</translation>
    </message>
    <message>
        <source>bone at %1 mm</source>
        <translation>Knochen bei %1 mm</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 bei %2 mm</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Straight under it&lt;/b&gt; %1&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Senkrecht darunter&lt;/b&gt; %1&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Depth derived from this body, not published.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Die Tiefe ist aus diesem Körper abgeleitet, nicht veröffentlicht.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1&lt;/p&gt;</translation>
    </message>
    <message>
        <source>%1 %2: you are %3 mm off</source>
        <translation>%1 %2: %3 mm daneben</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Nächster Punkt</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click on the body where the point is. Drag to turn, wheel to come nearer.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Klicken Sie am Körper dorthin, wo der Punkt liegt. Ziehen dreht, das Mausrad holt näher heran.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Where is %1, %2?</source>
        <translation>Wo liegt %1, %2?</translation>
    </message>
    <message>
        <source>%1 of %2 found within %3 mm; %4 mm off on average</source>
        <translation>%1 von %2 auf %3 mm genau gefunden; im Mittel %4 mm daneben</translation>
    </message>
</context>
<context>
    <name>BandGauge</name>
    <message>
        <source>The band holds nine of ten experts</source>
        <translation>Das Band umfasst neun von zehn Experten</translation>
    </message>
    <message>
        <source>No experts to compare with</source>
        <translation>Keine Experten zum Vergleich</translation>
    </message>
    <message>
        <source>experts %1 to %2</source>
        <translation>Experten %1 bis %2</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Click when you have read it</source>
        <translation>Klicken, wenn Sie es gelesen haben</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
</context>
<context>
    <name>Bullseye</name>
    <message>
        <source>Needle seen along the planned path</source>
        <translation>Die Nadel entlang des geplanten Wegs gesehen</translation>
    </message>
    <message>
        <source>cranial</source>
        <translation>kranial</translation>
    </message>
    <message>
        <source>caudal</source>
        <translation>kaudal</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>%1 mm off path</source>
        <translation>%1 mm neben dem Weg</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1° off plan</source>
        <translation>%1° neben dem Plan</translation>
    </message>
    <message>
        <source>No needle yet</source>
        <translation>Noch keine Nadel</translation>
    </message>
    <message>
        <source>No planned path</source>
        <translation>Kein geplanter Weg</translation>
    </message>
    <message>
        <source>The planned path is not shown</source>
        <translation>Der geplante Weg wird nicht gezeigt</translation>
    </message>
</context>
<context>
    <name>ClearanceLegend</name>
    <message>
        <source>Colours of the skin: clearance of a path that begins there</source>
        <translation>Farben der Haut: Abstand eines Wegs von dort</translation>
    </message>
    <message>
        <source>blocked</source>
        <translation>versperrt</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>DepthLadder</name>
    <message>
        <source>Depth ladder</source>
        <translation>Tiefenleiter</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>CameraPage</name>
    <message>
        <source>CT where the probe points</source>
        <translation>CT, wohin die Sonde zeigt</translation>
    </message>
    <message>
        <source>The patient's CT in the plane of the tracked probe, as the probe presses it</source>
        <translation>Das CT des Patienten in der Ebene der verfolgten Sonde, so wie sie drückt</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Record a session with the tracked needle, which is judged and kept; press again to end it (R)</source>
        <translation>Eine Sitzung mit der verfolgten Nadel: aufgezeichnet, beurteilt und aufbewahrt; noch einmal: sie endet (R)</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>See the session again, moment by moment</source>
        <translation>Die Sitzung noch einmal sehen, Augenblick für Augenblick</translation>
    </message>
    <message>
        <source>The camera's picture</source>
        <translation>Das Bild der Kamera</translation>
    </message>
    <message>
        <source>The patient drawn into the mannequin, the needle, the planned path</source>
        <translation>Der Patient in der Puppe, die Nadel, der geplante Weg</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>The ultrasound of where the tracked probe points</source>
        <translation>Der Ultraschall dort, wohin der verfolgte Schallkopf zeigt</translation>
    </message>
    <message>
        <source>CT at the tip</source>
        <translation>CT an der Spitze</translation>
    </message>
    <message>
        <source>The patient's CT with a crosshair at the tip of the tracked needle</source>
        <translation>Das CT des Patienten mit einem Fadenkreuz an der Spitze der verfolgten Nadel</translation>
    </message>
    <message>
        <source>as in the folder</source>
        <translation>wie im Ordner</translation>
    </message>
    <message>
        <source>as in rendered footage</source>
        <translation>wie in gerechneten Bildern</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>A camera (/dev/video0), a video, or a folder</source>
        <translation>Eine Kamera (/dev/video0), ein Video oder ein Ordner</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>camera.json of 'bodkin camera calibrate'</source>
        <translation>camera.json von 'bodkin camera calibrate'</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>bodies.json of 'bodkin markers'</source>
        <translation>bodies.json von 'bodkin markers'</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>registration.json of 'bodkin register'; empty: the entry of the path lies on the back</source>
        <translation>registration.json von 'bodkin register'; leer: der Einstich liegt auf dem Rücken</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
    <message>
        <source>A folder of pictures, or a video</source>
        <translation>Ein Ordner mit Bildern oder ein Video</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Show the pictures (Space)</source>
        <translation>Die Bilder zeigen (Leertaste)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Hold this picture, or continue (Space)</source>
        <translation>Dieses Bild behalten, weiter (Leertaste)</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>Needs no camera: its pictures are rendered once</source>
        <translation>Ohne Kamera: Bilder, die einmal gerechnet werden</translation>
    </message>
    <message>
        <source>How well each body is seen</source>
        <translation>Wie gut jeder Körper zu sehen ist</translation>
    </message>
    <message>
        <source>mm: standard deviation of its tip. Misfit: the part of the markers' contrast that is left over. Edges: misfit at the markers' edges divided by that on flat parts, large when motion, lens or folding do not fit</source>
        <translation>mm: Standardabweichung der Spitze. Rest: was vom Kontrast der Marken bleibt; Kanten: dieser an den Kanten gegen den auf Flächen, groß, wenn Bewegung, Linse oder Faltung nicht passen</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Misfit</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Was zu sehen ist</translation>
    </message>
    <message>
        <source>What is seen within the mannequin (P: next)</source>
        <translation>Was in der Puppe zu sehen ist (P: nächstes)</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Oval</source>
        <translation>Oval</translation>
    </message>
    <message>
        <source>Size of the view into the mannequin (+, -)</source>
        <translation>Größe des Blicks in die Puppe (+, -)</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>How much of the oval is opaque, up to its soft rim</source>
        <translation>Wie viel des Ovals deckt, bis zum weichen Rand</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Draw the planned path and its target</source>
        <translation>Den geplanten Weg und sein Ziel zeichnen</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Draw the needle in the patient, in the colours of the tissues that it lies in</source>
        <translation>Die Nadel im Patienten zeichnen, in den Farben der Gewebe, in denen sie liegt</translation>
    </message>
    <message>
        <source>A folder of pictures</source>
        <translation>Ein Ordner mit Bildern</translation>
    </message>
    <message>
        <source>A video</source>
        <translation>Ein Video</translation>
    </message>
    <message>
        <source>Videos (*.avi *.mp4 *.mkv *.mov *.webm);;All files (*)</source>
        <translation>Videos (*.avi *.mp4 *.mkv *.mov *.webm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Files of Bodkin (*.json);;All files (*)</source>
        <translation>Dateien von Bodkin (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Rendering a mannequin, a needle and a probe in front of a camera: %1 %</source>
        <translation>Eine Puppe, eine Nadel und ein Schallkopf vor einer Kamera werden gerechnet: %1 %</translation>
    </message>
    <message>
        <source>Choose a camera (/dev/video0), a video or a folder of pictures, or press Demonstration.</source>
        <translation>Wählen Sie eine Kamera (/dev/video0), ein Video oder einen Ordner mit Bildern; oder lassen Sie eine Vorführung rechnen.</translation>
    </message>
    <message>
        <source>Opening the pictures and preparing the patient.</source>
        <translation>Die Bilder werden geöffnet, der Patient wird vorbereitet.</translation>
    </message>
    <message>
        <source>%1 pictures/s, each shown %2 ms after it arrived.</source>
        <translation>%1 Bilder/s, jedes %2 ms nach seiner Ankunft.</translation>
    </message>
    <message>
        <source>Large oval: drawn at half the resolution.</source>
        <translation>Großes Oval: mit halber Auflösung gezeichnet.</translation>
    </message>
    <message>
        <source>Without ultrasound: %1</source>
        <translation>Ohne Ultraschall: %1</translation>
    </message>
    <message>
        <source>Tip on bone: %1.</source>
        <translation>Spitze auf Knochen: %1.</translation>
    </message>
    <message>
        <source>Tip in: %1.</source>
        <translation>Spitze in: %1.</translation>
    </message>
</context>
<context>
    <name>DevicesPage</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Devices that can hold the needle; a filled lamp means that one is connected</source>
        <translation>Was die Nadel halten kann; leuchtet die Lampe, ist es da</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Ask every driver what is connected</source>
        <translation>Jeden Treiber fragen, was angeschlossen ist</translation>
    </message>
    <message>
        <source>Use for practising</source>
        <translation>Damit üben</translation>
    </message>
    <message>
        <source>Use this device for the following attempts</source>
        <translation>Die folgenden Versuche werden damit gemacht</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Ten seconds without force: how well does it answer?</source>
        <translation>Zehn Sekunden ohne Kraft: wie gut antwortet es?</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Up to five steps, one after the other</source>
        <translation>Bis zu fünf Schritte nacheinander</translation>
    </message>
    <message>
        <source>Begin this step</source>
        <translation>Diesen Schritt beginnen</translation>
    </message>
    <message>
        <source>Begin the step, or end its motions early</source>
        <translation>Den Schritt beginnen, oder seine Bewegungen früher beenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Release the device; nothing is saved</source>
        <translation>Das Gerät loslassen; nichts davon wird behalten</translation>
    </message>
    <message>
        <source>, used for practising</source>
        <translation>, wird zum Üben benutzt</translation>
    </message>
    <message>
        <source>Asking %1...</source>
        <translation>%1 wird gefragt ...</translation>
    </message>
    <message>
        <source>It needs no setup: the wheel pushes the needle, and the resistance is shown as the distance by which the hand is ahead of the needle.</source>
        <translation>Sie braucht nichts: das Mausrad schiebt die Nadel, und was die Nadel trifft, sieht man daran, wie weit die Hand ihr voraus ist.</translation>
    </message>
    <message>
        <source>Used for practising</source>
        <translation>Wird zum Üben benutzt</translation>
    </message>
    <message>
        <source>Not calibrated: the middle of its workspace is a guess.</source>
        <translation>Nicht kalibriert: die Mitte des Arbeitsraums ist geschätzt.</translation>
    </message>
    <message>
        <source>Enough</source>
        <translation>Genug</translation>
    </message>
    <message>
        <source> (done)</source>
        <translation> (fertig)</translation>
    </message>
    <message>
        <source>Step %1 of %2: </source>
        <translation>Schritt %1 von %2: </translation>
    </message>
</context>
<context>
    <name>DiagnosticsDock</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Times of the force loop, numbers of the force model, energy, and what the guard did</source>
        <translation>Zeiten der Kraftschleife, Zahlen des Kraftmodells, Energie, und was der Wächter tat</translation>
    </message>
    <message>
        <source>Force loop</source>
        <translation>Kraftschleife</translation>
    </message>
    <message>
        <source>It is not running</source>
        <translation>Sie läuft nicht</translation>
    </message>
    <message>
        <source>a tick takes %1, 99 %: %2, most %3</source>
        <translation>Takt: %1, 99 %: %2, max. %3</translation>
    </message>
    <message>
        <source>begins late by %1, 99 %: %2</source>
        <translation>beginnt um %1 zu spät, 99 %: %2</translation>
    </message>
    <message>
        <source>%1 of %2 overran</source>
        <translation>%1 von %2 überzogen</translation>
    </message>
    <message>
        <source>Force model</source>
        <translation>Kraftmodell</translation>
    </message>
    <message>
        <source>It has no values to show</source>
        <translation>Es hat keine eigenen Zahlen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>wall %1 mm ahead of the tip</source>
        <translation>Wand %1 mm vor der Spitze</translation>
    </message>
    <message>
        <source>tip %1 mm beyond the wall</source>
        <translation>Spitze %1 mm hinter der Wand</translation>
    </message>
    <message>
        <source>Energy given to the tissue</source>
        <translation>Energie ins Gewebe</translation>
    </message>
    <message>
        <source>%1 N mm</source>
        <translation>%1 N mm</translation>
    </message>
    <message>
        <source>the device renders no force</source>
        <translation>das Gerät gibt keine Kraft</translation>
    </message>
    <message>
        <source>the device: at most %1 N, %2 N for long, %3 N/mm</source>
        <translation>das Gerät: höchstens %1 N, dauernd %2 N, %3 N/mm</translation>
    </message>
    <message>
        <source>Messages of the guard and the station</source>
        <translation>Was Wächter und Station sagen</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source> (%1 times)</source>
        <translation> (%1-mal)</translation>
    </message>
</context>
<context>
    <name>ForceChart</name>
    <message>
        <source>Force chart</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Force on the needle. Drag to zoom in, double click to see all, right click for more.</source>
        <translation>Kraft auf die Nadel. Ziehen vergrößert, Doppelklick zeigt alles, Rechtsklick mehr.</translation>
    </message>
    <message>
        <source>give</source>
        <translation>gibt nach</translation>
    </message>
    <message>
        <source>loss of resistance</source>
        <translation>Widerstandsverlust</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>fluid</source>
        <translation>Liquor</translation>
    </message>
    <message>
        <source>%1 cm of fluid</source>
        <translation>%1 cm Liquor</translation>
    </message>
    <message>
        <source>plunger gives way</source>
        <translation>Stempel gibt nach</translation>
    </message>
    <message>
        <source>hub on the skin</source>
        <translation>Ansatz an der Haut</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>along the needle</source>
        <translation>entlang der Nadel</translation>
    </message>
    <message>
        <source>across it</source>
        <translation>quer dazu</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1: %2 N</source>
        <translation>%1: %2 N</translation>
    </message>
    <message>
        <source>Against depth</source>
        <translation>Über der Tiefe</translation>
    </message>
    <message>
        <source>Against time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>Parts along and across the needle</source>
        <translation>Anteile entlang und quer zur Nadel</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>start, pause, continue</source>
        <translation>beginnen, anhalten, weiter</translation>
    </message>
    <message>
        <source>record a session with the tracked needle, end it</source>
        <translation>eine Sitzung mit der verfolgten Nadel aufnehmen, sie beenden</translation>
    </message>
    <message>
        <source>a larger view into the mannequin</source>
        <translation>ein größerer Blick in die Puppe</translation>
    </message>
    <message>
        <source>a smaller one</source>
        <translation>ein kleinerer</translation>
    </message>
    <message>
        <source>Augmented reality</source>
        <translation>Erweiterte Wirklichkeit</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Patient in 3-D</source>
        <translation>Patient in 3-D</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Kraftverlauf</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>Model settings</source>
        <translation>Modelleinstellungen</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Training plan</source>
        <translation>Übungsplan</translation>
    </message>
</context>
<context>
    <name>KeysCard</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>LearningCurve</name>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>The learning curve appears here after the first attempt.</source>
        <translation>Die Lernkurve erscheint hier nach dem ersten Versuch.</translation>
    </message>
</context>
<context>
    <name>LookPanel</name>
    <message>
        <source>Parts of the patient</source>
        <translation>Teile des Patienten</translation>
    </message>
    <message>
        <source>Tick the parts to show; opacity and colour below belong to the chosen row</source>
        <translation>Angekreuzt ist, was gezeigt wird; Deckkraft und Farbe darunter gelten für die gewählte Zeile</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the part that is chosen</source>
        <translation>Deckkraft des gewählten Teils</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>Any other colour</source>
        <translation>Eine beliebige andere Farbe</translation>
    </message>
    <message>
        <source>Looks saved with this patient</source>
        <translation>Mit diesem Patienten gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>Choose a look that was saved with this patient</source>
        <translation>Eine Ansicht wählen, die mit diesem Patienten gespeichert wurde</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete this look from the patient</source>
        <translation>Diese Ansicht beim Patienten löschen</translation>
    </message>
    <message>
        <source>Name of the look</source>
        <translation>Name der Ansicht</translation>
    </message>
    <message>
        <source>Name of this look; a look that already has this name is replaced</source>
        <translation>Wie diese Ansicht heißen soll; ein Name, den es schon gibt, wird ersetzt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save this look with the patient, under this name</source>
        <translation>Diese Ansicht unter diesem Namen beim Patienten speichern</translation>
    </message>
    <message>
        <source>with this direction of view</source>
        <translation>mit dieser Blickrichtung</translation>
    </message>
    <message>
        <source>The look also keeps the direction of view</source>
        <translation>Die Ansicht sagt auch, von wo der Patient gesehen wird</translation>
    </message>
    <message>
        <source>the patient opens with it</source>
        <translation>der Patient öffnet sich damit</translation>
    </message>
    <message>
        <source>The patient is shown like this when opened again</source>
        <translation>Wenn dieser Patient das nächste Mal geöffnet wird, sieht er so aus</translation>
    </message>
    <message>
        <source>%1 (opens with it)</source>
        <translation>%1 (öffnet sich damit)</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Augmented reality</source>
        <translation>Erweiterte Wirklichkeit</translation>
    </message>
    <message>
        <source>A camera sees a mannequin: shows the patient in it and the ultrasound at the probe</source>
        <translation>Eine Kamera sieht eine Puppe: der Patient in ihr, der Ultraschall, wohin der Schallkopf zeigt</translation>
    </message>
    <message>
        <source>The ring is at the planned entry. Esc brings the results back.</source>
        <translation>Der Ring zeigt, wo es geplant war. Esc bringt die Ergebnisse zurück.</translation>
    </message>
    <message>
        <source>The needle is where you found the point. Push; the true point is shown when you end.</source>
        <translation>Die Nadel ist dort, wo Sie den Punkt gefunden haben. Stechen Sie; der wahre Punkt wird am Ende gezeigt.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Choose where to go in, and the target</source>
        <translation>Wählen, wo es hineingeht und wohin</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>See a session again, moment by moment</source>
        <translation>Einen Versuch noch einmal ansehen, Augenblick für Augenblick</translation>
    </message>
    <message>
        <source>CT scanner</source>
        <translation>CT-Scanner</translation>
    </message>
    <message>
        <source>Scan the patient again, with the needle in place</source>
        <translation>Den Patienten noch einmal aufnehmen, mit liegender Nadel</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>The inside of the patient: bone, soft tissue, X-ray</source>
        <translation>Das Innere des Patienten: Knochen, Weichteile, Röntgenbild</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Correct the structures of the segmentation, or make new ones</source>
        <translation>Die Strukturen der Segmentierung verbessern, oder neue machen</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Devices that hold the needle: find, check, calibrate</source>
        <translation>Was die Nadel hält: finden, prüfen, kalibrieren</translation>
    </message>
    <message>
        <source>Acupuncture</source>
        <translation>Akupunktur</translation>
    </message>
    <message>
        <source>Points and meridians on a whole body</source>
        <translation>Punkte und Meridiane am ganzen Körper</translation>
    </message>
    <message>
        <source>Model settings</source>
        <translation>Modelleinstellungen</translation>
    </message>
    <message>
        <source>The values of the force model, one per step, and what they do</source>
        <translation>Die Zahlen des Kraftmodells, eine je Schritt, und was sie bewirken</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>The probe in your hand, with the CT of the same plane</source>
        <translation>Der Schallkopf in Ihrer Hand, daneben das CT derselben Ebene</translation>
    </message>
    <message>
        <source>preparing the session</source>
        <translation>die Station wird aufgebaut</translation>
    </message>
    <message>
        <source>%1, met at %2 mm after %3 s</source>
        <translation>%1, getroffen bei %2 mm nach %3 s</translation>
    </message>
    <message>
        <source>Sound is off.</source>
        <translation>Der Ton ist aus.</translation>
    </message>
    <message>
        <source>Sound is on.</source>
        <translation>Der Ton ist an.</translation>
    </message>
    <message>
        <source>Sound is on, but there is no pw-play, paplay or aplay to play it with.</source>
        <translation>Der Ton ist an, aber es gibt kein pw-play, paplay oder aplay, das ihn spielt.</translation>
    </message>
    <message>
        <source>A folder: a case, or DICOM images</source>
        <translation>Ein Ordner: ein Fall, oder DICOM-Bilder</translation>
    </message>
    <message>
        <source>A file: NIfTI, NRRD, MetaImage, or one DICOM image</source>
        <translation>Eine Datei: NIfTI, NRRD, MetaImage, oder ein DICOM-Bild</translation>
    </message>
    <message>
        <source>Images (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)</source>
        <translation>Bilder (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>go to: %1</source>
        <translation>gehe zu: %1</translation>
    </message>
    <message>
        <source>go to: Practise</source>
        <translation>gehe zu: Üben</translation>
    </message>
    <message>
        <source>Follow a plan</source>
        <translation>Einem Plan folgen</translation>
    </message>
    <message>
        <source>Stages that a teacher has laid out, and how far you are</source>
        <translation>Stufen, die ein Lehrer festgelegt hat, und wie weit Sie sind</translation>
    </message>
    <message>
        <source>This stage of the plan is done without ultrasound.</source>
        <translation>Diese Stufe des Plans geht ohne Ultraschall.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The plan that you follow does not allow this now.</source>
        <translation>Der Plan, dem Sie folgen, erlaubt das jetzt nicht.</translation>
    </message>
    <message>
        <source>The plan   A</source>
        <translation>Der Plan   A</translation>
    </message>
    <message>
        <source>Next stage   A</source>
        <translation>Nächste Stufe   A</translation>
    </message>
    <message>
        <source>Draw the needle out of the body first, then move the body.</source>
        <translation>Ziehen Sie die Nadel zuerst aus dem Körper, dann bewegen Sie ihn.</translation>
    </message>
    <message>
        <source>Drag to turn the body, right drag to move it. G ends.</source>
        <translation>Ziehen dreht den Körper, mit der rechten Taste verschiebt es ihn. G beendet es.</translation>
    </message>
    <message>
        <source>This stage of the plan is done without the volume.</source>
        <translation>Diese Stufe des Plans wird ohne das Volumen geübt.</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>%1 cannot be written; is there room, and may you write there?</source>
        <translation>%1 kann nicht geschrieben werden; ist Platz da, und dürfen Sie dort schreiben?</translation>
    </message>
</context>
<context>
    <name>ModelsPage</name>
    <message>
        <source>Your changes of the last time are restored; Ctrl+Z undoes them.</source>
        <translation>Was beim letzten Mal geändert wurde, ist wieder da; Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Force against depth</source>
        <translation>Kraft über der Tiefe</translation>
    </message>
    <message>
        <source>Force model</source>
        <translation>Kraftmodell</translation>
    </message>
    <message>
        <source>Choose another model of the force along the needle, with its own steps</source>
        <translation>Ein anderes Modell der Kraft entlang der Nadel, mit eigenen Schritten</translation>
    </message>
    <message>
        <source>All values, not only the eleven main ones</source>
        <translation>Alle Zahlen, nicht nur die elf</translation>
    </message>
    <message>
        <source>Every value of every tissue on the planned path</source>
        <translation>Jede Zahl jedes Gewebes auf dem geplanten Weg</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Click to go to a step</source>
        <translation>Klicken, um zu einem Schritt zu gehen</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>The tissues of a library file</source>
        <translation>Die Gewebe einer Bibliotheksdatei</translation>
    </message>
    <message>
        <source>Tissue library</source>
        <translation>Gewebebibliothek</translation>
    </message>
    <message>
        <source>Tissues (*.xml)</source>
        <translation>Gewebe (*.xml)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern als</translation>
    </message>
    <message>
        <source>All tissues as a library file, for 'case new --tissues' too</source>
        <translation>Alle Gewebe als Bibliotheksdatei, auch für 'case new --tissues'</translation>
    </message>
    <message>
        <source>tissues.xml</source>
        <translation>gewebe.xml</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Type a value, which may be outside the slider's range</source>
        <translation>Eine Zahl eingeben, auch jenseits des Reglers</translation>
    </message>
    <message>
        <source>Drag: the solid line follows at once</source>
        <translation>Ziehen: die durchgezogene Linie folgt sofort</translation>
    </message>
    <message>
        <source>Undo   Ctrl+Z</source>
        <translation>Rückgängig   Strg+Z</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone change (Ctrl+Shift+Z)</source>
        <translation>Was rückgängig gemacht wurde, noch einmal (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Reset this step</source>
        <translation>Diesen Schritt zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the value that the patient came with</source>
        <translation>Der Wert, mit dem der Patient kam</translation>
    </message>
    <message>
        <source>Back   ←</source>
        <translation>Zurück   ←</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Der Schritt davor</translation>
    </message>
    <message>
        <source>Next step   →</source>
        <translation>Nächster Schritt   →</translation>
    </message>
    <message>
        <source>The next number</source>
        <translation>Die nächste Zahl</translation>
    </message>
    <message>
        <source>Practise with this</source>
        <translation>Damit üben</translation>
    </message>
    <message>
        <source>This takes effect from the next attempt on.</source>
        <translation>Das ist vom nächsten Versuch an zu spüren.</translation>
    </message>
    <message>
        <source>This takes effect at once: now %1 N along the needle, %2 mm deep.</source>
        <translation>Die Nadel spürt es sofort: jetzt %1 N längs, %2 mm tief.</translation>
    </message>
    <message>
        <source>This takes effect at once; the needle is outside the body now.</source>
        <translation>Die Nadel spürt es sofort; sie ist gerade außerhalb.</translation>
    </message>
    <message>
        <source>Begin a new attempt with these values</source>
        <translation>Ein neuer Versuch beginnt, der diese Zahlen spürt</translation>
    </message>
    <message>
        <source>This model has no settings.</source>
        <translation>Dieses Modell hat keine Zahlen.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Change the value and watch the solid line: it follows at once. Dashed is the force as it was.</source>
        <translation>Ändern Sie den Wert und beobachten Sie die durchgezogene Linie: sie folgt sofort. Gestrichelt ist die Kraft, wie sie war.</translation>
    </message>
    <message>
        <source>Slider %1 to %2; allowed is %3</source>
        <translation>Regler %1 bis %2; erlaubt ist %3</translation>
    </message>
    <message>
        <source>lower than it was: %1</source>
        <translation>niedriger als zuvor: %1</translation>
    </message>
    <message>
        <source>higher than it was: %1</source>
        <translation>höher als zuvor: %1</translation>
    </message>
    <message>
        <source>as it was</source>
        <translation>wie zuvor</translation>
    </message>
    <message>
        <source>The default is printed in the model's paper.</source>
        <translation>Die Vorgabe ist in der Veröffentlichung des Modells gedruckt.</translation>
    </message>
    <message>
        <source>The default is from the literature.</source>
        <translation>Die Vorgabe stammt aus der Literatur.</translation>
    </message>
    <message>
        <source>The default is our choice.</source>
        <translation>Die Vorgabe ist unsere Wahl.</translation>
    </message>
    <message>
        <source>first puncture %1 N, </source>
        <translation>gibt zuerst nach bei %1 N, </translation>
    </message>
    <message>
        <source>Preparing the deformable body for the curve: %1 %</source>
        <translation>Der verformbare Körper wird für die Kurve vorbereitet: %1 %</translation>
    </message>
    <message>
        <source>%1strongest %2 N   (was: %3strongest %4 N)</source>
        <translation>%1am stärksten %2 N   (zuvor: %3am stärksten %4 N)</translation>
    </message>
    <message>
        <source>Loaded %1</source>
        <translation>%1 geladen</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Als %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>Force, distance to the target, angle and time</source>
        <translation>Kraft, Abstand zum Ziel, Winkel und Zeit</translation>
    </message>
    <message>
        <source>Force along the needle</source>
        <translation>Kraft entlang der Nadel</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>To the target</source>
        <translation>Bis zum Ziel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Angle to the plan</source>
        <translation>Winkel zum Plan</translation>
    </message>
    <message>
        <source>Time in body</source>
        <translation>Zeit im Körper</translation>
    </message>
</context>
<context>
    <name>OpacityCurve</name>
    <message>
        <source>%1 HU, %2 % of the light a mm</source>
        <translation>%1 HU, %2 % des Lichts je mm</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Type part of its name; arrows choose, Enter runs it, Esc closes</source>
        <translation>Einige Buchstaben davon; Pfeile wählen, Eingabe führt aus, Esc schließt</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Click to run it</source>
        <translation>Klicken führt es aus</translation>
    </message>
</context>
<context>
    <name>PathPicture</name>
    <message>
        <source>Path without anatomy</source>
        <translation>Weg ohne Anatomie</translation>
    </message>
    <message>
        <source>Path of the tip; the patient of this session is not available</source>
        <translation>Der Weg der Spitze; der Patient dieser Sitzung ist nicht da</translation>
    </message>
    <message>
        <source>From the patient's left</source>
        <translation>Von der linken Seite des Patienten</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Von hinten</translation>
    </message>
</context>
<context>
    <name>PauseCard</name>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Continue where you were (Esc)</source>
        <translation>Weitermachen, wo Sie waren (Esc)</translation>
    </message>
    <message>
        <source>With the mouse</source>
        <translation>Mit der Maus</translation>
    </message>
    <message>
        <source>Save this attempt and begin another one with the mouse</source>
        <translation>Diesen Versuch speichern und einen neuen mit der Maus beginnen</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Save this attempt and begin another one</source>
        <translation>Diesen Versuch speichern und einen neuen beginnen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Save this attempt and see the result</source>
        <translation>Diesen Versuch speichern und sehen, wie er war</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Save this attempt and go back to the start</source>
        <translation>Diesen Versuch speichern und zum Start zurückgehen</translation>
    </message>
    <message>
        <source>The guard took the force away</source>
        <translation>Der Wächter hat die Kraft weggenommen</translation>
    </message>
    <message>
        <source>The device was disconnected</source>
        <translation>Das Gerät ist weg</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The needle stays where it is.</source>
        <translation>Die Nadel bleibt, wo sie ist.</translation>
    </message>
    <message>
        <source>%1 What was recorded is safe. Reconnecting begins another attempt.</source>
        <translation>%1 Was aufgezeichnet wurde, ist sicher. Neu verbinden beginnt einen anderen Versuch.</translation>
    </message>
    <message>
        <source>It does not answer any more; the force is zero.</source>
        <translation>Es antwortet nicht mehr; die Kraft ist null.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>Arm again</source>
        <translation>Kraft wieder freigeben</translation>
    </message>
</context>
<context>
    <name>PictureSeries</name>
    <message>
        <source>%1 cannot be made: choose another folder.</source>
        <translation>%1 kann nicht angelegt werden: wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>A video needs ffmpeg, which is not installed: sudo apt-get install ffmpeg. Pictures can be saved without.</source>
        <translation>Ein Video braucht ffmpeg, das nicht installiert ist: sudo apt-get install ffmpeg. Bilder können auch ohne gespeichert werden.</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started: %1.</source>
        <translation>ffmpeg lässt sich nicht starten: %1.</translation>
    </message>
    <message>
        <source>The video could not be written: %1</source>
        <translation>Das Video konnte nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>ffmpeg ended early.</source>
        <translation>ffmpeg endete zu früh.</translation>
    </message>
    <message>
        <source>%1 cannot be written: free space there, or choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden: schaffen Sie dort Platz, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>PlanPage</name>
    <message>
        <source>Paths</source>
        <translation>Wege</translation>
    </message>
    <message>
        <source>Structure to aim at</source>
        <translation>Struktur, auf die gezielt wird</translation>
    </message>
    <message>
        <source>The middle of this structure becomes the target</source>
        <translation>Die Mitte dieser Struktur wird zum Ziel</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>Die letzte Änderung zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone change (Ctrl+Shift+Z)</source>
        <translation>Noch einmal tun (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Practise this</source>
        <translation>Dies üben</translation>
    </message>
    <message>
        <source>Go in along this path (Enter)</source>
        <translation>Auf diesem Weg hineingehen (Eingabe)</translation>
    </message>
    <message>
        <source>Proposed paths, the best first</source>
        <translation>Vorgeschlagene Wege, der beste zuerst</translation>
    </message>
    <message>
        <source>Click a path to take it</source>
        <translation>Einen Weg anklicken, um ihn zu nehmen</translation>
    </message>
    <message>
        <source>Way in</source>
        <translation>Eintritt</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Cranial</source>
        <translation>Kranial</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Nearest to avoid</source>
        <translation>Zu meiden, am nächsten</translation>
    </message>
    <message>
        <source>Crosses</source>
        <translation>Durchquert</translation>
    </message>
    <message>
        <source>Click: the target. Shift and click: the way in. Drag the green points to change them. Wheel: scroll.</source>
        <translation>Klicken: das Ziel. Umschalt und klicken: der Eintritt. Die grünen Punkte ziehen, um sie zu ändern. Mausrad: blättern.</translation>
    </message>
    <message>
        <source>Aim at ...</source>
        <translation>Zielen auf ...</translation>
    </message>
    <message>
        <source>Choose where to go in</source>
        <translation>Wählen Sie, wo es hineingeht</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm lang</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 cranial</source>
        <translation>%1 nach kranial</translation>
    </message>
    <message>
        <source>%1 caudal</source>
        <translation>%1 nach kaudal</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 nach links</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 nach rechts</translation>
    </message>
    <message>
        <source>through %1</source>
        <translation>durch %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>goes into it</source>
        <translation>geht hinein</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>, less than %1</source>
        <translation>, weniger als %1</translation>
    </message>
    <message>
        <source>Click the skin. In a slice: click the target, or Shift and click the way in.</source>
        <translation>Klicken Sie auf die Haut. In einer Schicht: das Ziel anklicken, mit Umschalt den Eintritt.</translation>
    </message>
    <message>
        <source>nothing within 30 mm</source>
        <translation>nichts im Umkreis von 30 mm</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>Choose the target first: click it in a slice.</source>
        <translation>Wählen Sie zuerst das Ziel: klicken Sie es in einer Schicht an.</translation>
    </message>
    <message>
        <source>Looking for paths ...</source>
        <translation>Wege werden gesucht ...</translation>
    </message>
    <message>
        <source>Looking for more ...</source>
        <translation>Weitere werden gesucht ...</translation>
    </message>
    <message>
        <source>Every one of these paths keeps its distance. Tab: next.</source>
        <translation>Jeder dieser Wege hält Abstand. Tab: der nächste.</translation>
    </message>
    <message>
        <source>being computed</source>
        <translation>wird berechnet</translation>
    </message>
</context>
<context>
    <name>OtherHandBar</name>
    <message>
        <source>Feel the skin with a finger, or take the needle again (H)</source>
        <translation>Die Haut mit einem Finger tasten, oder wieder die Nadel nehmen (H)</translation>
    </message>
    <message>
        <source>Take the stylet out of the needle, or put it back (S)</source>
        <translation>Den Mandrin aus der Nadel ziehen, oder zurückstecken (S)</translation>
    </message>
    <message>
        <source>Connect the manometer, or take it off (R)</source>
        <translation>Das Manometer anschließen, oder abnehmen (R)</translation>
    </message>
    <message>
        <source>Press the plunger of the syringe as long as the button or B is held</source>
        <translation>Den Stempel der Spritze drücken, solange der Knopf oder B gehalten wird</translation>
    </message>
    <message>
        <source>Fill the syringe with air, or with saline again; another attempt begins</source>
        <translation>Die Spritze mit Luft füllen, oder wieder mit Kochsalzlösung; ein neuer Versuch beginnt</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Stylet</source>
        <translation>Mandrin</translation>
    </message>
    <message>
        <source>Stylet out</source>
        <translation>Mandrin gezogen</translation>
    </message>
    <message>
        <source>Stylet out, %1 mL</source>
        <translation>Mandrin gezogen, %1 mL</translation>
    </message>
    <message>
        <source>Manometer</source>
        <translation>Manometer</translation>
    </message>
    <message>
        <source>Ask the patient to hold the breath, or to breathe again (Z)</source>
        <translation>Den Patienten bitten, den Atem anzuhalten oder weiterzuatmen (Z)</translation>
    </message>
    <message>
        <source>Breath</source>
        <translation>Atem</translation>
    </message>
    <message>
        <source>Breathes</source>
        <translation>Atmet</translation>
    </message>
    <message>
        <source>Breathes out</source>
        <translation>Atmet aus</translation>
    </message>
    <message>
        <source>Breath held</source>
        <translation>Atem angehalten</translation>
    </message>
    <message>
        <source>Manometer %1 mm</source>
        <translation>Manometer %1 mm</translation>
    </message>
    <message>
        <source>Plunger</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Plunger %1 kPa</source>
        <translation>Stempel %1 kPa</translation>
    </message>
</context>
<context>
    <name>PractisePage</name>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>The needle stays where it is while you look around</source>
        <translation>Die Nadel bleibt, wo sie ist, während Sie sich umsehen</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Save this attempt and begin another one</source>
        <translation>Diesen Versuch speichern und einen neuen beginnen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Save this attempt and see the result</source>
        <translation>Diesen Versuch speichern und sehen, wie er war</translation>
    </message>
    <message>
        <source>Move the body</source>
        <translation>Körper bewegen</translation>
    </message>
    <message>
        <source>Turn and move the body in the workspace of the device, needle outside (G)</source>
        <translation>Den Körper im Arbeitsraum des Geräts drehen und verschieben, die Nadel ist draußen (G)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last move of the body (Ctrl+Z)</source>
        <translation>Die letzte Bewegung des Körpers zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Wie anfangs</translation>
    </message>
    <message>
        <source>Put the body back where it was at first (Ctrl+Home)</source>
        <translation>Der Körper, wie er anfangs lag (Strg+Pos1)</translation>
    </message>
    <message>
        <source>The inside of the patient from the CT, next to the slices (I); M for the mode, P for the preset</source>
        <translation>Das Innere des Patienten aus seinem CT, neben den Schichten (I); M für die Darstellung, P für die Voreinstellung</translation>
    </message>
</context>
<context>
    <name>PreparingCard</name>
    <message>
        <source>The patient is being prepared</source>
        <translation>Der Patient wird vorbereitet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Zurück zum Start</translation>
    </message>
    <message>
        <source>%1 s so far</source>
        <translation>%1 s bisher</translation>
    </message>
    <message>
        <source>%1 s so far, about %2 s more for this step</source>
        <translation>%1 s bisher, noch etwa %2 s für diesen Schritt</translation>
    </message>
</context>
<context>
    <name>ProfileChart</name>
    <message>
        <source>Force against depth</source>
        <translation>Kraft über der Tiefe</translation>
    </message>
    <message>
        <source>The force of a slow, straight insertion along the planned path. Solid: now. Dashed: as it was.</source>
        <translation>Die Kraft eines langsamen, geraden Einstichs auf dem geplanten Weg. Durchgezogen: jetzt. Gestrichelt: wie sie war.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>ResultsCard</name>
    <message>
        <source>See where</source>
        <translation>Ansehen, wo</translation>
    </message>
    <message>
        <source>Hide this card and show the needle and the planned point in the views (Esc brings it back)</source>
        <translation>Die Karte weg: die Nadel und der geplante Punkt in den Ansichten (Esc bringt sie zurück)</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Borderline</source>
        <translation>Grenzwertig</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Dangerous</source>
        <translation>Gefährlich</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Start</translation>
    </message>
    <message>
        <source>Choose another patient</source>
        <translation>Einen anderen Patienten wählen</translation>
    </message>
    <message>
        <source>Review this</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>See the attempt again, moment by moment</source>
        <translation>Den Versuch noch einmal ansehen, Augenblick für Augenblick</translation>
    </message>
    <message>
        <source>Again   A</source>
        <translation>Noch einmal   A</translation>
    </message>
    <message>
        <source>The same patient and plan once more</source>
        <translation>Derselbe Patient und Plan noch einmal</translation>
    </message>
    <message>
        <source>The session is being saved.</source>
        <translation>Die Sitzung wird gespeichert.</translation>
    </message>
    <message>
        <source>The session has ended.</source>
        <translation>Die Sitzung ist beendet.</translation>
    </message>
    <message>
        <source>%1 mm from the target, %2 mm deep, at most %3 N, %4 s in the body</source>
        <translation>%1 mm vom Ziel, %2 mm tief, höchstens %3 N, %4 s im Körper</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>ReviewPage</name>
    <message>
        <source>Compare...</source>
        <translation>Vergleichen ...</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>Nicht mehr vergleichen</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>outside the body</source>
        <translation>außerhalb des Körpers</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>writing, %1 %</source>
        <translation>wird geschrieben, %1 %</translation>
    </message>
    <message>
        <source>The report is written to %1; no program here opens HTML pages.</source>
        <translation>Der Bericht ist nach %1 geschrieben; kein Programm hier öffnet HTML-Seiten.</translation>
    </message>
    <message>
        <source>The report is written to %1.</source>
        <translation>Der Bericht ist nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Video of the session</source>
        <translation>Video der Sitzung</translation>
    </message>
    <message>
        <source>Video (*.mp4 *.mkv *.webm)</source>
        <translation>Video (*.mp4 *.mkv *.webm)</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>Session to compare with</source>
        <translation>Sitzung zum Vergleich</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Sessions (*.bodkin);;All files (*)</source>
        <translation>Sitzungen (*.bodkin);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Back to the list of sessions</source>
        <translation>Zurück zur Liste der Sitzungen</translation>
    </message>
    <message>
        <source>&lt; Event</source>
        <translation>&lt; Ereignis</translation>
    </message>
    <message>
        <source>Go to the previous event (Shift+Left)</source>
        <translation>Zu dem, was davor geschah (Umschalt+Links)</translation>
    </message>
    <message>
        <source>&lt; Step</source>
        <translation>&lt; Schritt</translation>
    </message>
    <message>
        <source>One frame back, 1/25 s (Left)</source>
        <translation>Ein Bild zurück, 1/25 s (Links)</translation>
    </message>
    <message>
        <source>Play, pause (Space)</source>
        <translation>Abspielen, Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Step &gt;</source>
        <translation>Schritt &gt;</translation>
    </message>
    <message>
        <source>One frame forward, 1/25 s (Right)</source>
        <translation>Ein Bild weiter, 1/25 s (Rechts)</translation>
    </message>
    <message>
        <source>Event &gt;</source>
        <translation>Ereignis &gt;</translation>
    </message>
    <message>
        <source>Go to the next event (Shift+Right)</source>
        <translation>Zu dem, was danach geschieht (Umschalt+Rechts)</translation>
    </message>
    <message>
        <source>%1 times as fast (, slower, . faster)</source>
        <translation>%1-mal so schnell (, langsamer, . schneller)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the running task</source>
        <translation>Was gerade getan wird, anhalten</translation>
    </message>
    <message>
        <source>A second session over this one, in a second colour</source>
        <translation>Eine zweite Sitzung über dieser, in einer zweiten Farbe</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Write the report as an HTML page, and show it (G)</source>
        <translation>Die HTML-Seite schreiben und zeigen (G)</translation>
    </message>
    <message>
        <source>Pictures...</source>
        <translation>Bilder ...</translation>
    </message>
    <message>
        <source>25 numbered pictures for each second</source>
        <translation>25 nummerierte Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Video...</source>
        <translation>Video ...</translation>
    </message>
    <message>
        <source>Made with ffmpeg, if it is installed</source>
        <translation>Mit ffmpeg, wo es installiert ist</translation>
    </message>
</context>
<context>
    <name>ScanPage</name>
    <message>
        <source>SCOUT</source>
        <translation>SCOUT</translation>
    </message>
    <message>
        <source>Frontal</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Lateral</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>The overview from the front or the side</source>
        <translation>Die Übersicht von vorn oder von der Seite</translation>
    </message>
    <message>
        <source>Scout</source>
        <translation>Scout</translation>
    </message>
    <message>
        <source>Drag the ends of the box to set the range, its middle to move it</source>
        <translation>Die Enden des Kastens ziehen, um den Bereich zu setzen, seine Mitte, um ihn zu verschieben</translation>
    </message>
    <message>
        <source>THICKNESS mm</source>
        <translation>DICKE mm</translation>
    </message>
    <message>
        <source>SPACING mm</source>
        <translation>ABSTAND mm</translation>
    </message>
    <message>
        <source>How thick a slice is; thick slices blur</source>
        <translation>Wie dick eine Schicht ist; dicke Schichten verwischen</translation>
    </message>
    <message>
        <source>From one slice to the next; more than the thickness leaves gaps</source>
        <translation>Von einer Schicht zur nächsten; mehr als die Dicke lässt Lücken</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Kernel: sharpness of edges against noise</source>
        <translation>Faltungskern: wie Kanten und Rauschen herauskommen</translation>
    </message>
    <message>
        <source>SCAN</source>
        <translation>SCAN</translation>
    </message>
    <message>
        <source>Acquire the slices; press again to stop (S)</source>
        <translation>Nimmt die Schichten auf; noch einmal drücken hält an (S)</translation>
    </message>
    <message>
        <source>Slices of the scan</source>
        <translation>Schichten der Aufnahme</translation>
    </message>
    <message>
        <source>Wheel: next slice; click: mark a lesion; right drag: window</source>
        <translation>Mausrad: nächste Schicht; Klick: Läsion markieren; rechts ziehen: Fenster</translation>
    </message>
    <message>
        <source>Window of grey levels</source>
        <translation>Fenster der Grauwerte</translation>
    </message>
    <message>
        <source>Cine</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Runs through the slices (C)</source>
        <translation>Läuft durch die Schichten (C)</translation>
    </message>
    <message>
        <source>SCANS</source>
        <translation>AUFNAHMEN</translation>
    </message>
    <message>
        <source>Use as target</source>
        <translation>Als Ziel nehmen</translation>
    </message>
    <message>
        <source>The marked lesion becomes the target of this patient's case</source>
        <translation>Die markierte Läsion wird zum Ziel im Fall dieses Patienten</translation>
    </message>
    <message>
        <source>This patient has no CT to scan.</source>
        <translation>Dieser Patient hat kein CT zum Aufnehmen.</translation>
    </message>
    <message>
        <source>%1 mm, %2 slices, %3</source>
        <translation>%1 mm, %2 Schichten, %3</translation>
    </message>
    <message>
        <source>gaps of %1 mm</source>
        <translation>Lücken von %1 mm</translation>
    </message>
    <message>
        <source>overlapping %1 mm</source>
        <translation>%1 mm überlappend</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>keine Lücken</translation>
    </message>
    <message>
        <source>Stopped; the slices acquired so far remain.</source>
        <translation>Angehalten; die gekommenen Schichten bleiben.</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Scanning ...</source>
        <translation>Wird aufgenommen ...</translation>
    </message>
    <message>
        <source>%1 needle in place</source>
        <translation>%1 mit liegender Nadel</translation>
    </message>
    <message>
        <source>Shows this scan</source>
        <translation>Zeigt diese Aufnahme</translation>
    </message>
    <message>
        <source>%1 slices. Click a lesion to mark it.</source>
        <translation>%1 Schichten. Klicken Sie auf eine Läsion, um sie zu markieren.</translation>
    </message>
    <message>
        <source>The mark lies outside the body. Click a place inside it.</source>
        <translation>Die Markierung liegt außerhalb des Körpers. Klicken Sie auf eine Stelle darin.</translation>
    </message>
    <message>
        <source>Saved as the target, %1 mm from the skin. The patient opens again with it.</source>
        <translation>Als Ziel gespeichert, %1 mm von der Haut. Der Patient öffnet sich neu damit.</translation>
    </message>
</context>
<context>
    <name>ScanViewer</name>
    <message>
        <source>No slices yet.
Set the range on the scout, then press Scan.</source>
        <translation>Noch keine Schichten.
Setzen Sie den Bereich im Scout und drücken Sie Scan.</translation>
    </message>
    <message>
        <source>IM %1/%2</source>
        <translation>IM %1/%2</translation>
    </message>
    <message>
        <source>SL %1 mm</source>
        <translation>SL %1 mm</translation>
    </message>
    <message>
        <source>SP %1 mm</source>
        <translation>SP %1 mm</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>NEEDLE IN PLACE</source>
        <translation>NADEL LIEGT</translation>
    </message>
</context>
<context>
    <name>ScoutWidget</name>
    <message>
        <source>The patient has no CT</source>
        <translation>Der Patient hat kein CT</translation>
    </message>
    <message>
        <source>No patient</source>
        <translation>Kein Patient</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
</context>
<context>
    <name>SegmentPage</name>
    <message>
        <source>by its HU</source>
        <translation>nach seinen HU</translation>
    </message>
    <message>
        <source>Changes that were not saved the last time are restored; Ctrl+Z undoes them.</source>
        <translation>Was beim letzten Mal nicht gesichert wurde, ist wieder da; Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Make a structure first: its name, then New.</source>
        <translation>Machen Sie zuerst eine Struktur: ihr Name, dann Neu.</translation>
    </message>
    <message>
        <source>Paint it, grow it from a click, or add a range of HU.</source>
        <translation>Malen Sie sie, lassen Sie sie von einem Klick aus wachsen, oder nehmen Sie einen HU-Bereich.</translation>
    </message>
    <message>
        <source>tissue by its HU</source>
        <translation>Gewebe nach den HU</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Saved. The patient is opened again with its new tissues. %1</source>
        <translation>Gespeichert. Der Patient wird mit seinen neuen Geweben wieder geöffnet. %1</translation>
    </message>
    <message>
        <source>Slice with the structures</source>
        <translation>Schicht mit den Strukturen</translation>
    </message>
    <message>
        <source>Left: the tool. Right drag: window. Wheel: next slice, with Ctrl nearer</source>
        <translation>Links: das Werkzeug. Rechts ziehen: Fenster. Mausrad: nächste Schicht, mit Strg näher</translation>
    </message>
    <message>
        <source>The structure in 3-D</source>
        <translation>Die Struktur in 3-D</translation>
    </message>
    <message>
        <source>Right drag turns. Left: the tool, on the surface</source>
        <translation>Rechts ziehen dreht. Links: das Werkzeug, auf der Oberfläche</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>The structure that is worked on</source>
        <translation>Die Struktur, die bearbeitet wird</translation>
    </message>
    <message>
        <source>Tissue of the new structure</source>
        <translation>Gewebe der neuen Struktur</translation>
    </message>
    <message>
        <source>Tissue that the structure is made of</source>
        <translation>Woraus sie besteht</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Make a structure with this name and tissue</source>
        <translation>Eine Struktur mit diesem Namen und Gewebe</translation>
    </message>
    <message>
        <source>Tool of the left button</source>
        <translation>Werkzeug der linken Taste</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Sehen</translation>
    </message>
    <message>
        <source>Moves the crosshair (L)</source>
        <translation>Verschiebt das Fadenkreuz (L)</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Adds to the structure (P)</source>
        <translation>Fügt zur Struktur hinzu (P)</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Tilgen</translation>
    </message>
    <message>
        <source>Removes from the structure (E)</source>
        <translation>Nimmt von der Struktur weg (E)</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>A click adds the connected voxels in the range of HU (G)</source>
        <translation>Ein Klick nimmt, was im HU-Bereich mit der Stelle zusammenhängt (G)</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Radius des Pinsels ([ und ])</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>3-D</source>
        <translation>3-D</translation>
    </message>
    <message>
        <source>A ball; without it a disc in the slice alone</source>
        <translation>Eine Kugel; ohne dies eine Scheibe nur in der Schicht</translation>
    </message>
    <message>
        <source>keep others</source>
        <translation>andere lassen</translation>
    </message>
    <message>
        <source>Other structures are not painted over</source>
        <translation>Andere Strukturen werden nicht übermalt</translation>
    </message>
    <message>
        <source>Range of HU, and how far from the crosshair</source>
        <translation>HU-Bereich, und wie weit vom Fadenkreuz</translation>
    </message>
    <message>
        <source>Lowest HU</source>
        <translation>Niedrigster HU</translation>
    </message>
    <message>
        <source>Highest HU</source>
        <translation>Höchster HU</translation>
    </message>
    <message>
        <source>mm about the crosshair; 0: no limit</source>
        <translation>mm um das Fadenkreuz; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Adds all voxels of the range</source>
        <translation>Fügt alle Voxel des Bereichs hinzu</translation>
    </message>
    <message>
        <source>Fill between slices</source>
        <translation>Schichten füllen</translation>
    </message>
    <message>
        <source>Interpolate the structure in the axial slices between painted ones</source>
        <translation>Axiale Schichten zwischen bemalten bekommen die Form dazwischen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Removes specks, holes and steps that are smaller</source>
        <translation>Nimmt Flecken, Löcher und Stufen weg, die kleiner sind</translation>
    </message>
    <message>
        <source>Size of what Smooth removes</source>
        <translation>Wie viel Glätten wegnimmt</translation>
    </message>
    <message>
        <source>Structures over the CT (V)</source>
        <translation>Strukturen über dem CT (V)</translation>
    </message>
    <message>
        <source>Off: the CT alone</source>
        <translation>Aus: nur das CT</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops the work; nothing is changed</source>
        <translation>Hält die Arbeit an; nichts wird geändert</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Undo the last step (Ctrl+Z)</source>
        <translation>Den letzten Schritt zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Redo the last undone change (Ctrl+Shift+Z)</source>
        <translation>Noch einmal tun (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save into the case; tissues and path are computed again</source>
        <translation>In den Fall; Gewebe und Weg werden neu gemacht</translation>
    </message>
    <message>
        <source>It has no voxels any more. Saving drops it; Ctrl+Z brings it back.</source>
        <translation>Sie hat keine Voxel mehr. Beim Speichern fällt sie weg; Strg+Z holt sie zurück.</translation>
    </message>
    <message>
        <source>%1; critical</source>
        <translation>%1; kritisch</translation>
    </message>
    <message>
        <source>%1 (critical)</source>
        <translation>%1 (kritisch)</translation>
    </message>
    <message>
        <source>name, of a new one or another</source>
        <translation>Name, für eine neue oder ein anderer</translation>
    </message>
    <message>
        <source>Name of a new structure, or a new name for the chosen one</source>
        <translation>Name einer neuen Struktur, oder ein anderer für die gewählte</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give the chosen structure the name typed above</source>
        <translation>Die gewählte Struktur bekommt den Namen, der darüber steht</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The chosen structure loses all its voxels; saving drops it</source>
        <translation>Die gewählte Struktur verliert alle Voxel; beim Speichern fällt sie weg</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>kritisch</translation>
    </message>
    <message>
        <source>Plans keep away from it, and a needle in it is a danger</source>
        <translation>Pläne halten Abstand von ihr, und eine Nadel in ihr ist eine Gefahr</translation>
    </message>
</context>
<context>
    <name>SegmentRelief</name>
    <message>
        <source>no voxel yet</source>
        <translation>noch kein Voxel</translation>
    </message>
    <message>
        <source>right drag turns</source>
        <translation>rechts ziehen dreht</translation>
    </message>
</context>
<context>
    <name>SegmentSlice</name>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
    </message>
</context>
<context>
    <name>SessionList</name>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Eine Datei öffnen ...</translation>
    </message>
    <message>
        <source>Open a file</source>
        <translation>Eine Datei öffnen</translation>
    </message>
    <message>
        <source>Open a session from another folder; it can also be dropped here</source>
        <translation>Eine Sitzung, die anderswo liegt; man kann sie auch hier ablegen</translation>
    </message>
    <message>
        <source>Every attempt is kept. Choose one to see it again, moment by moment.</source>
        <translation>Jeder Versuch wird behalten. Wählen Sie einen, um ihn noch einmal anzusehen, Augenblick für Augenblick.</translation>
    </message>
    <message>
        <source>Sessions that are kept</source>
        <translation>Behaltene Sitzungen</translation>
    </message>
    <message>
        <source>Newest first; a click opens</source>
        <translation>Neueste zuerst; ein Klick öffnet</translation>
    </message>
    <message>
        <source>%1      %2, %3 MB</source>
        <translation>%1      %2, %3 MB</translation>
    </message>
    <message>
        <source>There is no session in %1 yet: practise once, or open a file that bodkin run or bodkin perform wrote.</source>
        <translation>In %1 ist noch keine: üben Sie einmal, oder öffnen Sie eine Datei, die bodkin run oder bodkin perform schrieb.</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>conus</source>
        <translation>Konus</translation>
    </message>
    <message>
        <source>%1 slice. Left drag: crosshair. Right drag: window. Middle drag: move. Ctrl and wheel: zoom. Alt and wheel: scroll. M measures a distance, Q an angle.</source>
        <translation>Schicht %1. Links ziehen: Fadenkreuz. Rechts ziehen: Fenster. Mitte ziehen: verschieben. Strg und Mausrad: vergrößern. Alt und Mausrad: blättern. M misst einen Abstand, Q einen Winkel.</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Along the needle</source>
        <translation>Entlang der Nadel</translation>
    </message>
    <message>
        <source>outside the CT</source>
        <translation>außerhalb des CT</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
    </message>
    <message>
        <source>No patient is open</source>
        <translation>Kein Patient ist geöffnet</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>W %1  L %2</translation>
    </message>
    <message>
        <source>MIP %1 mm</source>
        <translation>MIP %1 mm</translation>
    </message>
    <message>
        <source>Click the places, right click cancels</source>
        <translation>Klicken Sie die Stellen an, Rechtsklick bricht ab</translation>
    </message>
    <message>
        <source>%1 (W %2, L %3)</source>
        <translation>%1 (W %2, L %3)</translation>
    </message>
    <message>
        <source>Measure a distance (M)</source>
        <translation>Einen Abstand messen (M)</translation>
    </message>
    <message>
        <source>Measure an angle (Q)</source>
        <translation>Einen Winkel messen (Q)</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>Hide tissue colours</source>
        <translation>Gewebefarben ausblenden</translation>
    </message>
    <message>
        <source>Show tissue colours</source>
        <translation>Gewebefarben zeigen</translation>
    </message>
    <message>
        <source>Along the needle (N)</source>
        <translation>Längs der Nadel (N)</translation>
    </message>
    <message>
        <source>Not along the needle (N)</source>
        <translation>Nicht längs der Nadel (N)</translation>
    </message>
    <message>
        <source>Next slab thickness (T)</source>
        <translation>Nächste Schichtdicke (T)</translation>
    </message>
    <message>
        <source>Stop (C)</source>
        <translation>Anhalten (C)</translation>
    </message>
    <message>
        <source>Run through the slices (C)</source>
        <translation>Durch die Schichten laufen (C)</translation>
    </message>
    <message>
        <source>Stay here (F)</source>
        <translation>Hier bleiben (F)</translation>
    </message>
    <message>
        <source>Follow the tip (F)</source>
        <translation>Der Spitze folgen (F)</translation>
    </message>
    <message>
        <source>Whole procedure (Home)</source>
        <translation>Der ganze Eingriff (Pos1)</translation>
    </message>
    <message>
        <source>Enlarge this view (Enter)</source>
        <translation>An den großen Platz (Eingabe)</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>About, version %1</source>
        <translation>Über Bodkin, Version %1</translation>
    </message>
    <message>
        <source>Versions of Bodkin and its libraries, and the licence</source>
        <translation>Versionen von Bodkin und seinen Bibliotheken, und die Lizenz</translation>
    </message>
    <message>
        <source>Show the window in this language, from now on</source>
        <translation>Das Fenster in dieser Sprache, jetzt und beim nächsten Mal</translation>
    </message>
    <message>
        <source>Patients</source>
        <translation>Patienten</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Begin on the built-in patient</source>
        <translation>Am eingebauten Patienten beginnen</translation>
    </message>
    <message>
        <source>Open a patient</source>
        <translation>Einen Patienten öffnen</translation>
    </message>
    <message>
        <source>A case, a DICOM folder or an image (Ctrl+O)</source>
        <translation>Ein Fall, ein DICOM-Ordner oder ein Bild (Strg+O)</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Procedures</source>
        <translation>Eingriffe</translation>
    </message>
    <message>
        <source>Put a needle in.</source>
        <translation>Stechen Sie eine Nadel ein.</translation>
    </message>
    <message>
        <source>Lumbar puncture, L3/L4, on the built-in patient. With the mouse, now.</source>
        <translation>Lumbalpunktion, L3/L4, am eingebauten Patienten. Mit der Maus, jetzt.</translation>
    </message>
    <message>
        <source>Start lumbar puncture     Enter</source>
        <translation>Lumbalpunktion beginnen     Eingabe</translation>
    </message>
    <message>
        <source>The first time, the patient has to be made, which takes some seconds</source>
        <translation>Beim ersten Mal wird der Patient gemacht, das dauert einige Sekunden</translation>
    </message>
    <message>
        <source>Start lumbar puncture</source>
        <translation>Lumbalpunktion beginnen</translation>
    </message>
    <message>
        <source>Two-minute tour     T</source>
        <translation>Rundgang, zwei Minuten     T</translation>
    </message>
    <message>
        <source>Look, aim, push, read: four hints that close once you have followed them</source>
        <translation>Schauen, zielen, schieben, ablesen: vier Sprechblasen, die mit dem Tun vergehen</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Rundgang, zwei Minuten</translation>
    </message>
    <message>
        <source>Point at the back, click, and scroll: the needle goes in. You see the tissue that it is in, and the force that it meets.</source>
        <translation>Zeigen Sie auf den Rücken, klicken und drehen Sie das Mausrad: die Nadel geht hinein. Sie sehen das Gewebe, in dem sie ist, und die Kraft, die sie trifft.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>See the part that was recorded</source>
        <translation>Ansehen, so weit sie aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Do not offer it again; the file stays</source>
        <translation>Nicht mehr anbieten; die Datei bleibt</translation>
    </message>
    <message>
        <source>The last session was cut off. What had been recorded is safe: %1</source>
        <translation>Die letzte Sitzung wurde abgeschnitten. Was aufgezeichnet war, ist sicher: %1</translation>
    </message>
    <message>
        <source>Synthetic lumbar torso</source>
        <translation>Künstlicher Rumpf</translation>
    </message>
    <message>
        <source>45 years, 1.72 m, 72 kg. Built in</source>
        <translation>45 Jahre, 1,72 m, 72 kg. Eingebaut</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Schon geöffnet</translation>
    </message>
    <message>
        <source>Drop a DICOM folder or an image here</source>
        <translation>DICOM-Ordner oder Bild hier ablegen</translation>
    </message>
    <message>
        <source>or click to choose</source>
        <translation>oder klicken, um zu wählen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The next attempt of the plan</source>
        <translation>Der nächste Versuch des Plans</translation>
    </message>
    <message>
        <source>Stop following</source>
        <translation>Nicht mehr folgen</translation>
    </message>
    <message>
        <source>Do not offer it again; results stay in the store</source>
        <translation>Nicht mehr anbieten; die Ergebnisse bleiben</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Course of the session</source>
        <translation>Verlauf der Sitzung</translation>
    </message>
    <message>
        <source>Click or drag to go to a time, click a flag to go to its event</source>
        <translation>Klicken oder ziehen, um zu einem Augenblick zu gehen; ein Fähnchen anklicken, um zu dem zu gehen, was geschah</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
</context>
<context>
    <name>TipLabel</name>
    <message>
        <source>Tissue at the tip</source>
        <translation>Gewebe an der Spitze</translation>
    </message>
    <message>
        <source>TIP ON BONE</source>
        <translation>SPITZE AUF KNOCHEN</translation>
    </message>
    <message>
        <source>TIP IN</source>
        <translation>SPITZE IN</translation>
    </message>
    <message>
        <source>PRESSING ON</source>
        <translation>DRÜCKT AUF</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>TIP ABOVE</source>
        <translation>SPITZE ÜBER</translation>
    </message>
    <message>
        <source>NEEDLE</source>
        <translation>NADEL</translation>
    </message>
    <message>
        <source>not on the patient</source>
        <translation>nicht am Patienten</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Force loop</source>
        <translation>Kraftschleife</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>Ultrasound next to the needle (U); a new attempt begins</source>
        <translation>Ultraschall neben der Nadel (U); ein neuer Versuch beginnt</translation>
    </message>
    <message>
        <source>Keys of this page (F1)</source>
        <translation>Tasten dieser Seite (F1)</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>No device is open</source>
        <translation>Kein Gerät ist geöffnet</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>The force loop is not running</source>
        <translation>Die Kraftschleife läuft nicht</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>The device was disconnected; click to reconnect it</source>
        <translation>Das Gerät ist weg; klicken, um es zu beheben</translation>
    </message>
    <message>
        <source>%1 holds the needle</source>
        <translation>%1 hält die Nadel</translation>
    </message>
    <message>
        <source>No force</source>
        <translation>Keine Kraft</translation>
    </message>
    <message>
        <source>The guard took the force away: %1</source>
        <translation>Der Wächter hat die Kraft weggenommen: %1</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>%1 spät</translation>
    </message>
    <message>
        <source>%1 of 100 ticks were in time lately</source>
        <translation>%1 von 100 Takten kamen zuletzt rechtzeitig</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>The force loop runs in time</source>
        <translation>Die Kraftschleife läuft rechtzeitig</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Skip the tour</source>
        <translation>Rundgang überspringen</translation>
    </message>
    <message>
        <source>Close this and continue to practise</source>
        <translation>Dies schließen und weiterüben</translation>
    </message>
    <message>
        <source>The tour</source>
        <translation>Der Rundgang</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>TrainingPage</name>
    <message>
        <source>planned path</source>
        <translation>geplanten Weg</translation>
    </message>
    <message>
        <source>slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>view of the inside</source>
        <translation>Blick ins Innere</translation>
    </message>
    <message>
        <source>tissues by depth</source>
        <translation>Gewebe nach Tiefe</translation>
    </message>
    <message>
        <source>picture of the needle</source>
        <translation>Bild der Nadel</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>everything is shown</source>
        <translation>alles wird gezeigt</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>; with ultrasound</source>
        <translation>; mit Ultraschall</translation>
    </message>
    <message>
        <source>Follow a plan</source>
        <translation>Einem Plan folgen</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Pläne</translation>
    </message>
    <message>
        <source>Plans that come with Bodkin, and those that were opened before</source>
        <translation>Pläne, die mit Bodkin kommen, und schon geöffnete</translation>
    </message>
    <message>
        <source>Open a plan...</source>
        <translation>Einen Plan öffnen ...</translation>
    </message>
    <message>
        <source>Open a plan</source>
        <translation>Einen Plan öffnen</translation>
    </message>
    <message>
        <source>Open a plan that a teacher has written</source>
        <translation>Eine Datei, die ein Lehrer geschrieben hat</translation>
    </message>
    <message>
        <source>Your label. No name is needed: trainee-07</source>
        <translation>Ihr Kürzel. Kein Name ist nötig: trainee-07</translation>
    </message>
    <message>
        <source>Label of the trainee</source>
        <translation>Kürzel des Übenden</translation>
    </message>
    <message>
        <source>Results are kept under this label; letters, digits, blanks, '_', '-' and '.'</source>
        <translation>Ergebnisse werden unter diesem Kürzel behalten; Buchstaben, Ziffern, Leerzeichen, '_', '-' und '.'</translation>
    </message>
    <message>
        <source>Begin     Enter</source>
        <translation>Beginnen     Eingabe</translation>
    </message>
    <message>
        <source>Begin, or continue</source>
        <translation>Beginnen, oder weitermachen</translation>
    </message>
    <message>
        <source>The next attempt of this plan</source>
        <translation>Der nächste Versuch dieses Plans</translation>
    </message>
    <message>
        <source>A plan</source>
        <translation>Ein Plan</translation>
    </message>
    <message>
        <source>Plans (*.xml);;All files (*)</source>
        <translation>Pläne (*.xml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Looking up how far you are.</source>
        <translation>Es wird nachgesehen, wie weit Sie sind.</translation>
    </message>
    <message>
        <source>Go on     Enter</source>
        <translation>Weiter     Eingabe</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
</context>
<context>
    <name>UltrasoundPage</name>
    <message>
        <source>Drag slides the probe, the wheel presses it. H: all keys, Esc: back</source>
        <translation>Ziehen verschiebt den Schallkopf, das Mausrad drückt ihn an. H: alle Tasten, Esc: zurück</translation>
    </message>
    <message>
        <source>Preparing the patient: %1</source>
        <translation>Der Patient wird vorbereitet: %1</translation>
    </message>
</context>
<context>
    <name>UltrasoundView</name>
    <message>
        <source>This session has no ultrasound</source>
        <translation>Diese Sitzung hat keinen Ultraschall</translation>
    </message>
    <message>
        <source>The first picture is being made</source>
        <translation>Das erste Bild wird gemacht</translation>
    </message>
    <message>
        <source>%1   %2 cm</source>
        <translation>%1   %2 cm</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>CT, the same plane</source>
        <translation>CT, dieselbe Ebene</translation>
    </message>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>H: keys</source>
        <translation>H: Tasten</translation>
    </message>
    <message>
        <source>Calipers: click two places; C again to move the probe</source>
        <translation>Messzirkel: zwei Stellen anklicken; noch einmal C, um den Schallkopf zu bewegen</translation>
    </message>
    <message>
        <source>%1 N of the needle, off the path, are not shown</source>
        <translation>%1 N der Nadel abseits des Wegs werden nicht gezeigt</translation>
    </message>
    <message>
        <source>Ultrasound. Drag slides the probe, the wheel presses it, Shift and wheel set the depth. H shows all keys.</source>
        <translation>Ultraschall. Ziehen verschiebt den Schallkopf, das Mausrad drückt ihn an, mit Umschalt stellt es die Tiefe ein. H zeigt alle Tasten.</translation>
    </message>
</context>
<context>
    <name>VerdictPanel</name>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Borderline</source>
        <translation>Grenzwertig</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Dangerous</source>
        <translation>Gefährlich</translation>
    </message>
    <message>
        <source>This session was cut off; what had been recorded until then is here.</source>
        <translation>Diese Sitzung wurde abgeschnitten; was bis dahin aufgezeichnet war, ist hier.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>Every measure</source>
        <translation>Alle Messgrößen</translation>
    </message>
</context>
<context>
    <name>View3d</name>
    <message>
        <source>Patient in 3-D</source>
        <translation>Patient in 3-D</translation>
    </message>
    <message>
        <source>Drag to turn the patient, Ctrl and the wheel to zoom, 0 to 6 for standard views, P for what is shown</source>
        <translation>Ziehen dreht den Patienten, Strg und Mausrad vergrößern, 0 bis 6 sind feste Ansichten, P wählt, was gezeigt wird</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Cut-away</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>What the patient looks like (P: next)</source>
        <translation>Wie der Patient aussieht (P: nächste)</translation>
    </message>
    <message>
        <source>An opening in the skin over the path (P: next)</source>
        <translation>Eine Öffnung in der Haut über dem Weg (P: nächste)</translation>
    </message>
    <message>
        <source>Bones and what lies between them (P: next)</source>
        <translation>Knochen und was dazwischen liegt (P: nächste)</translation>
    </message>
    <message>
        <source>Everything under a faint skin (P: next)</source>
        <translation>Alles unter einer schwachen Haut (P: nächste)</translation>
    </message>
    <message>
        <source>Preparing the patient in 3-D: %1 %</source>
        <translation>Der Patient wird in 3-D vorbereitet: %1 %</translation>
    </message>
    <message>
        <source>The patient cannot be shown in 3-D: %1</source>
        <translation>Der Patient kann nicht in 3-D gezeigt werden: %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Show or hide each part, its opacity and colour, looks saved with the patient (O)</source>
        <translation>Jeden Teil zeigen oder verbergen, Deckkraft und Farbe, mit dem Patienten gespeicherte Ansichten (O)</translation>
    </message>
    <message>
        <source>Give the look a name first</source>
        <translation>Geben Sie der Ansicht zuerst einen Namen</translation>
    </message>
    <message>
        <source>"%1" is saved with the patient</source>
        <translation>„%1“ ist mit dem Patienten gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) saved in %1</source>
        <translation>
            <numerusform>%n Oberfläche in %1 gespeichert</numerusform>
            <numerusform>%n Oberflächen in %1 gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Bild als %1 gespeichert</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a folder that may be written to, and a name that ends in .png</source>
        <translation>%1 kann nicht geschrieben werden; wählen Sie einen Ordner, in den geschrieben werden darf, und einen Namen, der auf .png endet</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Beside the needle</source>
        <translation>Neben der Nadel</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>From the head</source>
        <translation>Vom Kopf</translation>
    </message>
    <message>
        <source>From the feet</source>
        <translation>Von den Füßen</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Red and cyan glasses</source>
        <translation>Rot-Cyan-Brille</translation>
    </message>
    <message>
        <source>Save surfaces</source>
        <translation>Oberflächen speichern</translation>
    </message>
    <message>
        <source>Folder for the surfaces</source>
        <translation>Ordner für die Oberflächen</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture of the patient</source>
        <translation>Bild des Patienten</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>away</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
</context>
<context>
    <name>VolumePage</name>
    <message>
        <source>Drawn by</source>
        <translation>Gezeichnet von</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>By the graphics card, where there is one</source>
        <translation>Von der Grafikkarte, wo es eine gibt</translation>
    </message>
    <message>
        <source>Graphics card</source>
        <translation>Grafikkarte</translation>
    </message>
    <message>
        <source>By OpenGL, even where the processor computes it</source>
        <translation>Von OpenGL, auch wo der Prozessor es rechnet</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>By the processor alone</source>
        <translation>Vom Prozessor allein</translation>
    </message>
    <message>
        <source>The processor draws.</source>
        <translation>Der Prozessor zeichnet.</translation>
    </message>
    <message>
        <source>%1 draws.</source>
        <translation>%1 zeichnet.</translation>
    </message>
    <message>
        <source>The processor draws: %1.</source>
        <translation>Der Prozessor zeichnet: %1.</translation>
    </message>
    <message>
        <source>What is seen  (M: next)</source>
        <translation>Was man sieht  (M: nächstes)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Coloured, lit tissue</source>
        <translation>Farbiges, beleuchtetes Gewebe</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Lit tissue in the greys of a window</source>
        <translation>Beleuchtetes Gewebe in den Grauwerten eines Fensters</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>The largest HU on each ray (MIP)</source>
        <translation>Der größte HU auf jedem Strahl (MIP)</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenbild</translation>
    </message>
    <message>
        <source>All voxels on each ray summed, as an X-ray does</source>
        <translation>Alle Voxel auf jedem Strahl summiert, wie ein Röntgenbild</translation>
    </message>
    <message>
        <source>Preset  (P: next)</source>
        <translation>Vorgabe  (P: nächste)</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Bone alone</source>
        <translation>Nur Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Muscle and organs, faint, with bone in them</source>
        <translation>Muskeln und Organe, schwach, mit Knochen darin</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>What the patient looks like from outside</source>
        <translation>Wie der Patient von außen aussieht</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Vessels with contrast medium; bone is faint</source>
        <translation>Gefäße mit Kontrastmittel; Knochen ist schwach</translation>
    </message>
    <message>
        <source>Opacity of each HU: drag the points</source>
        <translation>Deckkraft jedes HU: die Punkte ziehen</translation>
    </message>
    <message>
        <source>Opacity curve</source>
        <translation>Deckkraftkurve</translation>
    </message>
    <message>
        <source>Drag a point; double click adds one, right click takes one away</source>
        <translation>Einen Punkt ziehen; Doppelklick setzt einen, Rechtsklick nimmt einen weg</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Moves the curve: to the right, denser tissue only</source>
        <translation>Verschiebt die Kurve: nach rechts nur dichteres Gewebe</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Makes everything more or less opaque</source>
        <translation>Macht alles mehr oder weniger deckend</translation>
    </message>
    <message>
        <source>Light on edges</source>
        <translation>Licht auf Kanten</translation>
    </message>
    <message>
        <source>Surfaces that face you are brighter</source>
        <translation>Oberflächen, die Ihnen zugewandt sind, sind heller</translation>
    </message>
    <message>
        <source>Colours of the tissues</source>
        <translation>Farben der Gewebe</translation>
    </message>
    <message>
        <source>As in slices and chart, instead of colours by HU</source>
        <translation>Wie in Schichten und Kraftverlauf, statt Farben nach HU</translation>
    </message>
</context>
<context>
    <name>VolumeView</name>
    <message>
        <source>Inside of the patient</source>
        <translation>Inneres des Patienten</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, right drag for the window; M for the mode, 0 to 6 for standard views</source>
        <translation>Ziehen dreht, Mausrad vergrößert, rechts ziehen stellt das Fenster; M wechselt die Art, 0 bis 6 sind feste Ansichten</translation>
    </message>
    <message>
        <source>Preparing the volume: %1 %</source>
        <translation>Das Volumen wird vorbereitet: %1 %</translation>
    </message>
    <message>
        <source>The inside of the patient cannot be shown: %1</source>
        <translation>Das Innere des Patienten kann nicht gezeigt werden: %1</translation>
    </message>
    <message>
        <source>Colour by tissue</source>
        <translation>Farbe nach Gewebe</translation>
    </message>
    <message>
        <source>Colour by HU</source>
        <translation>Farbe nach HU</translation>
    </message>
    <message>
        <source>Grey   W %1  L %2</source>
        <translation>Grau   W %1  L %2</translation>
    </message>
    <message>
        <source>Largest HU (MIP)   W %1  L %2</source>
        <translation>Größter HU (MIP)   W %1  L %2</translation>
    </message>
    <message>
        <source>Summed voxels, like an X-ray   brightness %1</source>
        <translation>Summierte Voxel, wie ein Röntgenbild   Helligkeit %1</translation>
    </message>
</context>
<context>
    <name>WorkspacePicture</name>
    <message>
        <source>Workspace of the device</source>
        <translation>Arbeitsraum des Geräts</translation>
    </message>
    <message>
        <source>Position of the tool in the workspace; below, the force sent to the device</source>
        <translation>Wo das Werkzeug ist, in dem Kasten, den es erreichen kann; darunter die Kraft, die abgegeben wird</translation>
    </message>
    <message>
        <source>from above, away from you is up</source>
        <translation>von oben, von Ihnen weg ist oben</translation>
    </message>
    <message>
        <source>from your right</source>
        <translation>von rechts</translation>
    </message>
    <message>
        <source>renders no force</source>
        <translation>gibt keine Kraft</translation>
    </message>
    <message>
        <source>%1 of %2 N</source>
        <translation>%1 von %2 N</translation>
    </message>
    <message>
        <source>not open</source>
        <translation>nicht geöffnet</translation>
    </message>
</context>
<context>
    <name>bodkin::app::Tour</name>
    <message>
        <source>Look</source>
        <translation>Schauen</translation>
    </message>
    <message>
        <source>Turn the patient: drag next to the needle with the left button, or press an arrow key.</source>
        <translation>Drehen Sie den Patienten: ziehen Sie neben der Nadel mit der linken Taste, oder drücken Sie eine Pfeiltaste.</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Zielen</translation>
    </message>
    <message>
        <source>The ring on the skin is where to go in. Point at it and click: the needle goes to the skin.</source>
        <translation>Der Ring auf der Haut ist die Einstichstelle. Zeigen Sie darauf und klicken Sie: die Nadel geht zur Haut.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Scroll towards you. The skin dents, the force rises in the chart, then the skin gives.</source>
        <translation>Drehen Sie das Mausrad zu sich hin. Die Haut dellt sich ein, die Kraft steigt im Verlauf, dann gibt die Haut nach.</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Ablesen</translation>
    </message>
    <message>
        <source>At the upper left is the tissue at the tip, and to the right of it the ladder of the tissues on the needle's line. Push on until the name changes.</source>
        <translation>Oben links steht das Gewebe, in dem die Spitze ist, rechts davon die Leiter dessen, was auf der Linie der Nadel liegt. Schieben Sie weiter, bis der Name wechselt.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>Das ist alles</translation>
    </message>
    <message>
        <source>Continue until you reach the fluid, slowly at the last puncture. Space holds the needle, E ends and shows the result, F1 shows every key.</source>
        <translation>Weiter bis zum Liquor: drehen Sie weiter, langsam beim letzten Nachgeben. Leertaste hält die Nadel, E beendet und zeigt, wie es war, F1 zeigt alle Tasten.</translation>
    </message>
</context>
<context>
    <name>bodkin::views::SliceView</name>
    <message>
        <source>Spine</source>
        <translation>Wirbelsäule</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
</context>
<context>
    <name>bodkin::views::TopBar</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Rückblick</translation>
    </message>
</context>
<context>
    <name>bodkin::views::UltrasoundView</name>
    <message>
        <source>slide the probe over the skin</source>
        <translation>den Schallkopf über die Haut schieben</translation>
    </message>
    <message>
        <source>press it in, lift it off</source>
        <translation>andrücken, abheben</translation>
    </message>
    <message>
        <source>rotate it on the spot</source>
        <translation>auf der Stelle drehen</translation>
    </message>
    <message>
        <source>tilt: the slice fans</source>
        <translation>kippen: die Schicht fächert</translation>
    </message>
    <message>
        <source>rock within the slice</source>
        <translation>in der Schicht wiegen</translation>
    </message>
    <message>
        <source>depth; Shift D less</source>
        <translation>Tiefe; Umschalt D weniger</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>gain by depth (TGC), all to the middle</source>
        <translation>Verstärkung nach Tiefe (TGC), alles in die Mitte</translation>
    </message>
    <message>
        <source>freeze</source>
        <translation>einfrieren</translation>
    </message>
    <message>
        <source>calipers: two clicks each</source>
        <translation>Messzirkel: je zwei Klicks</translation>
    </message>
    <message>
        <source>mark the place under the pointer</source>
        <translation>die Stelle unter dem Zeiger markieren</translation>
    </message>
    <message>
        <source>clear calipers and marks</source>
        <translation>Messzirkel und Marken löschen</translation>
    </message>
    <message>
        <source>keep the picture</source>
        <translation>das Bild behalten</translation>
    </message>
    <message>
        <source>needle in or out; without an attempt</source>
        <translation>Nadel hinein oder heraus; ohne Versuch</translation>
    </message>
    <message>
        <source>needle deeper, shallower; without an attempt</source>
        <translation>Nadel tiefer, flacher; ohne Versuch</translation>
    </message>
    <message>
        <source>these keys</source>
        <translation>diese Tasten</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Bodkin: put needles into patients, and feel it.</source>
        <translation>Bodkin: Nadeln in Patienten stechen und es spüren.</translation>
    </message>
    <message>
        <source>A case, a DICOM folder or an image to begin with</source>
        <translation>Ein Fall, ein DICOM-Ordner oder ein Bild zum Beginnen</translation>
    </message>
    <message>
        <source>Run the commands in FILE, then quit</source>
        <translation>Tun, was DATEI sagt, und beenden</translation>
    </message>
    <message>
        <source>Folder for the script's screenshots</source>
        <translation>Ordner für die Bilder des Skripts</translation>
    </message>
    <message>
        <source>Size of the window, 1280x720</source>
        <translation>Größe des Fensters, 1280x720</translation>
    </message>
    <message>
        <source>Measure the window's speed, print it, then quit</source>
        <translation>Die Geschwindigkeit des Fensters messen, ausgeben, und beenden</translation>
    </message>
    <message>
        <source>Options of the attempt, as bodkin perform passes them</source>
        <translation>Wie geübt wird, wie bodkin perform es sagt</translation>
    </message>
    <message>
        <source>Show the session of the bodkin serve at HOST or HOST:PORT</source>
        <translation>Die Sitzung von bodkin serve auf diesem Rechner zeigen, HOST oder HOST:PORT</translation>
    </message>
    <message>
        <source>Settings of the live probe, as bodkin ultrasound --live passes them</source>
        <translation>Der Schallkopf in der Hand, wie bodkin ultrasound --live es sagt</translation>
    </message>
    <message>
        <source>Beginning of the names of saved images</source>
        <translation>Anfang der Bildnamen</translation>
    </message>
    <message>
        <source>Allow the full force, although the system may delay the servo</source>
        <translation>Die ganze Kraft geben, auch wenn das System die Regelung aufhalten kann</translation>
    </message>
    <message>
        <source>Language of the window, such as de</source>
        <translation>Sprache des Fensters, etwa de</translation>
    </message>
</context>
</TS>
