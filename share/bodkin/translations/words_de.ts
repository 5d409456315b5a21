<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Texts that reach the window from other modules. %1 to %9 stand for what varies. -->
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Keys</name>
    <message>
        <source>turn and move the body, or let it be</source>
        <translation>den Körper drehen und verschieben, oder ihn lassen</translation>
    </message>
    <message>
        <source>the last move of the body back</source>
        <translation>die letzte Bewegung des Körpers zurücknehmen</translation>
    </message>
    <message>
        <source>the body as it lay at first</source>
        <translation>der Körper, wie er anfangs lag</translation>
    </message>
    <message>
        <source>a click grows a region</source>
        <translation>ein Klick lässt einen Bereich wachsen</translation>
    </message>
    <message>
        <source>a larger brush</source>
        <translation>größerer Pinsel</translation>
    </message>
    <message>
        <source>a picture back, on</source>
        <translation>ein Bild zurück, vor</translation>
    </message>
    <message>
        <source>a smaller brush</source>
        <translation>kleinerer Pinsel</translation>
    </message>
    <message>
        <source>all of this in the picture</source>
        <translation>alles davon ins Bild</translation>
    </message>
    <message>
        <source>arm again after a fault</source>
        <translation>nach einer Störung wieder freigeben</translation>
    </message>
    <message>
        <source>back, or pause</source>
        <translation>zurück, oder Pause</translation>
    </message>
    <message>
        <source>bone, soft tissue, skin, vessels</source>
        <translation>Knochen, Weichteile, Haut, Gefäße</translation>
    </message>
    <message>
        <source>calipers: two clicks each</source>
        <translation>Messzirkel: je zwei Klicks</translation>
    </message>
    <message>
        <source>clear calipers and marks</source>
        <translation>Messzirkel und Marken löschen</translation>
    </message>
    <message>
        <source>colour, grey, maximum, X-ray</source>
        <translation>Farbe, Grau, Maximum, Röntgenbild</translation>
    </message>
    <message>
        <source>delete the measure under the pointer</source>
        <translation>die Messung unter dem Zeiger löschen</translation>
    </message>
    <message>
        <source>depth ladder on, off</source>
        <translation>Tiefenleiter an, aus</translation>
    </message>
    <message>
        <source>depth; with Shift less</source>
        <translation>Tiefe; mit Umschalt weniger</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>noch einmal tun</translation>
    </message>
    <message>
        <source>draw back slowly</source>
        <translation>langsam zurückziehen</translation>
    </message>
    <message>
        <source>draw back</source>
        <translation>zurückziehen</translation>
    </message>
    <message>
        <source>dynamic range; with Shift less</source>
        <translation>Dynamikbereich; mit Umschalt weniger</translation>
    </message>
    <message>
        <source>end, and see how it went</source>
        <translation>beenden und sehen, wie es war</translation>
    </message>
    <message>
        <source>event before, next event</source>
        <translation>Ereignis davor, nächstes</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>weiter weg</translation>
    </message>
    <message>
        <source>find a command by its name</source>
        <translation>einen Befehl nach Namen finden</translation>
    </message>
    <message>
        <source>first slice</source>
        <translation>erste Schicht</translation>
    </message>
    <message>
        <source>focus; with Shift nearer</source>
        <translation>Fokus; mit Umschalt näher</translation>
    </message>
    <message>
        <source>follow the tip, or stay</source>
        <translation>der Spitze folgen oder bleiben</translation>
    </message>
    <message>
        <source>freeze</source>
        <translation>einfrieren</translation>
    </message>
    <message>
        <source>frequency; with Shift lower</source>
        <translation>Frequenz; mit Umschalt niedriger</translation>
    </message>
    <message>
        <source>from behind</source>
        <translation>von hinten</translation>
    </message>
    <message>
        <source>from the feet</source>
        <translation>von den Füßen</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from the head</source>
        <translation>vom Kopf</translation>
    </message>
    <message>
        <source>from the left</source>
        <translation>von links</translation>
    </message>
    <message>
        <source>from the right</source>
        <translation>von rechts</translation>
    </message>
    <message>
        <source>full screen</source>
        <translation>ganzer Bildschirm</translation>
    </message>
    <message>
        <source>gain; with Shift less</source>
        <translation>Verstärkung; mit Umschalt weniger</translation>
    </message>
    <message>
        <source>hold the needle, take it up again</source>
        <translation>die Nadel halten, wieder aufnehmen</translation>
    </message>
    <message>
        <source>last slice</source>
        <translation>letzte Schicht</translation>
    </message>
    <message>
        <source>leave Bodkin</source>
        <translation>Bodkin beenden</translation>
    </message>
    <message>
        <source>leave the needle in the body, and take another</source>
        <translation>die Nadel im Körper lassen und eine andere nehmen</translation>
    </message>
    <message>
        <source>light or dark</source>
        <translation>hell oder dunkel</translation>
    </message>
    <message>
        <source>mark the place under the pointer</source>
        <translation>die Stelle unter dem Zeiger markieren</translation>
    </message>
    <message>
        <source>measure a distance</source>
        <translation>einen Abstand messen</translation>
    </message>
    <message>
        <source>measure an angle</source>
        <translation>einen Winkel messen</translation>
    </message>
    <message>
        <source>name a point to find</source>
        <translation>einen zu findenden Punkt nennen</translation>
    </message>
    <message>
        <source>touch with the device's needle, or not</source>
        <translation>mit der Nadel des Geräts berühren, oder nicht</translation>
    </message>
    <message>
        <source>nearer</source>
        <translation>näher</translation>
    </message>
    <message>
        <source>needle deeper</source>
        <translation>Nadel tiefer</translation>
    </message>
    <message>
        <source>needle in or out of the patient</source>
        <translation>Nadel in den Patienten oder heraus</translation>
    </message>
    <message>
        <source>needle shallower</source>
        <translation>Nadel flacher</translation>
    </message>
    <message>
        <source>next slice</source>
        <translation>nächste Schicht</translation>
    </message>
    <message>
        <source>next step</source>
        <translation>nächster Schritt</translation>
    </message>
    <message>
        <source>next view</source>
        <translation>nächste Ansicht</translation>
    </message>
    <message>
        <source>next window</source>
        <translation>nächstes Fenster</translation>
    </message>
    <message>
        <source>numbers on, off</source>
        <translation>Zahlen an, aus</translation>
    </message>
    <message>
        <source>one unit less</source>
        <translation>eine Einheit weniger</translation>
    </message>
    <message>
        <source>one unit of the last digit more</source>
        <translation>eine Einheit der letzten Stelle mehr</translation>
    </message>
    <message>
        <source>open a patient</source>
        <translation>einen Patienten öffnen</translation>
    </message>
    <message>
        <source>organs and other parts: what is shown, opacity, colour</source>
        <translation>Organe und andere Teile: was gezeigt wird, Deckkraft, Farbe</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>abspielen, Pause</translation>
    </message>
    <message>
        <source>practise this path</source>
        <translation>diesen Weg üben</translation>
    </message>
    <message>
        <source>feel the skin with a finger, take the needle again</source>
        <translation>die Haut mit einem Finger tasten, die Nadel wieder nehmen</translation>
    </message>
    <message>
        <source>stylet out, in</source>
        <translation>Mandrin heraus, hinein</translation>
    </message>
    <message>
        <source>manometer on, off</source>
        <translation>Manometer an, ab</translation>
    </message>
    <message>
        <source>press the plunger of the syringe, while held</source>
        <translation>den Stempel der Spritze drücken, solange gehalten</translation>
    </message>
    <message>
        <source>push in slowly</source>
        <translation>langsam vorschieben</translation>
    </message>
    <message>
        <source>push in</source>
        <translation>vorschieben</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>remove the path</source>
        <translation>den Weg entfernen</translation>
    </message>
    <message>
        <source>researchers' numbers on, off</source>
        <translation>Zahlen für Forscher an, aus</translation>
    </message>
    <message>
        <source>rock the probe</source>
        <translation>den Schallkopf wiegen</translation>
    </message>
    <message>
        <source>rotate the probe</source>
        <translation>den Schallkopf drehen</translation>
    </message>
    <message>
        <source>run through the slices</source>
        <translation>durch die Schichten laufen</translation>
    </message>
    <message>
        <source>save a picture of the window</source>
        <translation>ein Bild des Fensters speichern</translation>
    </message>
    <message>
        <source>save and try again</source>
        <translation>speichern und noch einmal versuchen</translation>
    </message>
    <message>
        <source>save the picture</source>
        <translation>das Bild speichern</translation>
    </message>
    <message>
        <source>scan, stop</source>
        <translation>aufnehmen, anhalten</translation>
    </message>
    <message>
        <source>skin, cut-away, bones, see-through</source>
        <translation>Haut, Ausschnitt, Knochen, durchsichtig</translation>
    </message>
    <message>
        <source>slice before</source>
        <translation>Schicht davor</translation>
    </message>
    <message>
        <source>slide the probe, away</source>
        <translation>den Schallkopf wegschieben</translation>
    </message>
    <message>
        <source>slide the probe, left</source>
        <translation>den Schallkopf nach links schieben</translation>
    </message>
    <message>
        <source>slide the probe, near</source>
        <translation>den Schallkopf heranschieben</translation>
    </message>
    <message>
        <source>slide the probe, right</source>
        <translation>den Schallkopf nach rechts schieben</translation>
    </message>
    <message>
        <source>sliders of the time-gain compensation; 1 to 8 move them, 0 sets all to the middle</source>
        <translation>Regler der Verstärkung nach Tiefe; 1 bis 8 verschieben sie, 0 stellt alle in die Mitte</translation>
    </message>
    <message>
        <source>slower, faster</source>
        <translation>langsamer, schneller</translation>
    </message>
    <message>
        <source>sound on, off</source>
        <translation>Ton an, aus</translation>
    </message>
    <message>
        <source>start</source>
        <translation>beginnen</translation>
    </message>
    <message>
        <source>step before</source>
        <translation>Schritt davor</translation>
    </message>
    <message>
        <source>stereo: off, side by side, coloured glasses</source>
        <translation>Stereo: aus, nebeneinander, farbige Brille</translation>
    </message>
    <message>
        <source>structures over the CT, or the CT alone</source>
        <translation>Strukturen über dem CT, oder nur das CT</translation>
    </message>
    <message>
        <source>take out the needle that was left last</source>
        <translation>die zuletzt gelassene Nadel herausnehmen</translation>
    </message>
    <message>
        <source>take the last change back</source>
        <translation>die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>take the last step back</source>
        <translation>den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>take the next proposal</source>
        <translation>den nächsten Vorschlag nehmen</translation>
    </message>
    <message>
        <source>ten units less</source>
        <translation>zehn Einheiten weniger</translation>
    </message>
    <message>
        <source>ten units more</source>
        <translation>zehn Einheiten mehr</translation>
    </message>
    <message>
        <source>the keys of this screen</source>
        <translation>die Tasten dieser Seite</translation>
    </message>
    <message>
        <source>the left button erases</source>
        <translation>die linke Taste radiert</translation>
    </message>
    <message>
        <source>the left button moves the crosshair</source>
        <translation>die linke Taste verschiebt das Fadenkreuz</translation>
    </message>
    <message>
        <source>the left button paints</source>
        <translation>die linke Taste malt</translation>
    </message>
    <message>
        <source>the same point again</source>
        <translation>noch einmal derselbe Punkt</translation>
    </message>
    <message>
        <source>the view of the procedure</source>
        <translation>die Ansicht des Eingriffs</translation>
    </message>
    <message>
        <source>the whole body</source>
        <translation>der ganze Körper</translation>
    </message>
    <message>
        <source>thickness of the slab</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>this view large, small</source>
        <translation>diese Ansicht groß, klein</translation>
    </message>
    <message>
        <source>tilt the probe</source>
        <translation>den Schallkopf kippen</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>two-minute tour</source>
        <translation>Rundgang, zwei Minuten</translation>
    </message>
    <message>
        <source>ultrasound on, off</source>
        <translation>Ultraschall an, aus</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>rückgängig</translation>
    </message>
    <message>
        <source>view before</source>
        <translation>Ansicht davor</translation>
    </message>
    <message>
        <source>window before</source>
        <translation>Fenster davor</translation>
    </message>
    <message>
        <source>withdraw to above the skin</source>
        <translation>bis über die Haut zurückziehen</translation>
    </message>
    <message>
        <source>write the report</source>
        <translation>den Bericht schreiben</translation>
    </message>
    <message>
        <source>begin, or go on</source>
        <translation>beginnen, oder weitermachen</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>spreads over the abdomen</source>
        <translation>breitet sich über den Bauch aus</translation>
    </message>
    <message>
        <source>runs up beside the spine and spreads over the head</source>
        <translation>steigt neben der Wirbelsäule auf und breitet sich über den Kopf aus</translation>
    </message>
    <message>
        <source>spreads over chest and flanks</source>
        <translation>breitet sich über Brust und Flanken aus</translation>
    </message>
    <message>
        <source>another force model is felt from the next attempt on</source>
        <translation>ein anderes Kraftmodell spürt man vom nächsten Versuch an</translation>
    </message>
    <message>
        <source>another rate holds from the next attempt on</source>
        <translation>eine andere Rate gilt vom nächsten Versuch an</translation>
    </message>
    <message>
        <source>a deformable body has other numbers from the next attempt on, for it is prepared with them</source>
        <translation>ein verformbarer Körper hat andere Zahlen vom nächsten Versuch an, denn er wird mit ihnen vorbereitet</translation>
    </message>
    <message>
        <source>the needle has been in for more than ten minutes, or the disk was too slow; draw it out before you change a number</source>
        <translation>die Nadel ist länger als zehn Minuten im Körper, oder die Platte war zu langsam; ziehen Sie sie heraus, bevor Sie eine Zahl ändern</translation>
    </message>
    <message>
        <source>The body stays where it is: a needle touches it, or a second hand takes part.</source>
        <translation>Der Körper bleibt, wo er ist: eine Nadel berührt ihn, oder eine zweite Hand nimmt teil.</translation>
    </message>
    <message>
        <source>The body lies where it lay at first.</source>
        <translation>Der Körper liegt, wo er anfangs lag.</translation>
    </message>
    <message>
        <source>Draw the needle out of the body first, then move the body.</source>
        <translation>Ziehen Sie die Nadel zuerst aus dem Körper, dann bewegen Sie ihn.</translation>
    </message>
    <message>
        <source>Give the structure a name.</source>
        <translation>Geben Sie der Struktur einen Namen.</translation>
    </message>
    <message>
        <source>air outside the body</source>
        <translation>Luft außerhalb des Körpers</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>other soft tissue</source>
        <translation>anderes Weichgewebe</translation>
    </message>
    <message>
        <source>cortical bone</source>
        <translation>kompakter Knochen</translation>
    </message>
    <message>
        <source>cancellous bone</source>
        <translation>Spongiosa</translation>
    </message>
    <message>
        <source>intervertebral disc</source>
        <translation>Bandscheibe</translation>
    </message>
    <message>
        <source>supraspinous ligament</source>
        <translation>Lig. supraspinale</translation>
    </message>
    <message>
        <source>interspinous ligament</source>
        <translation>Lig. interspinale</translation>
    </message>
    <message>
        <source>ligamentum flavum</source>
        <translation>Lig. flavum</translation>
    </message>
    <message>
        <source>epidural space</source>
        <translation>Epiduralraum</translation>
    </message>
    <message>
        <source>dura</source>
        <translation>Dura</translation>
    </message>
    <message>
        <source>cerebrospinal fluid</source>
        <translation>Liquor</translation>
    </message>
    <message>
        <source>nerve roots</source>
        <translation>Nervenwurzeln</translation>
    </message>
    <message>
        <source>blood vessel</source>
        <translation>Blutgefäß</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>gas inside the body</source>
        <translation>Gas im Körper</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>lesion</source>
        <translation>Läsion</translation>
    </message>
    <message>
        <source>cartilage</source>
        <translation>Knorpel</translation>
    </message>
    <message>
        <source>spinal cord</source>
        <translation>Rückenmark</translation>
    </message>
    <message>
        <source>flavum</source>
        <translation>Flavum</translation>
    </message>
    <message>
        <source>interspinous</source>
        <translation>interspinal</translation>
    </message>
    <message>
        <source>supraspinous</source>
        <translation>supraspinal</translation>
    </message>
    <message>
        <source>CSF</source>
        <translation>Liquor</translation>
    </message>
    <message>
        <source>cord</source>
        <translation>Rückenmark</translation>
    </message>
    <message>
        <source>epidural</source>
        <translation>epidural</translation>
    </message>
    <message>
        <source>disc</source>
        <translation>Bandscheibe</translation>
    </message>
    <message>
        <source>soft tissue</source>
        <translation>Weichgewebe</translation>
    </message>
    <message>
        <source>inner bone</source>
        <translation>Spongiosa</translation>
    </message>
    <message>
        <source>Connecting to %1</source>
        <translation>Verbindung zu %1 wird aufgebaut</translation>
    </message>
    <message>
        <source>Not connected: %1. Trying again</source>
        <translation>Nicht verbunden: %1. Neuer Versuch</translation>
    </message>
    <message>
        <source>%1 waits: a session has to be started there</source>
        <translation>%1 wartet: dort muss eine Sitzung begonnen werden</translation>
    </message>
    <message>
        <source>%1 prepares</source>
        <translation>%1 bereitet vor</translation>
    </message>
    <message>
        <source>That is decided at the station, %1.</source>
        <translation>Das wird an der Station %1 entschieden.</translation>
    </message>
    <message>
        <source>the station at %1 has another patient ('%2') than %3; open the case that it has, a copy of its folder</source>
        <translation>die Station %1 hat einen anderen Patienten („%2“) als %3; öffnen Sie den Fall, den sie hat, eine Kopie seines Ordners</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>there is no machine '%1'</source>
        <translation>es gibt keinen Rechner „%1“</translation>
    </message>
    <message>
        <source>nobody answers at %1 (%2); is the server started?</source>
        <translation>niemand antwortet bei %1 (%2); läuft der Server?</translation>
    </message>
    <message>
        <source>vertebra %1</source>
        <translation>Wirbel %1</translation>
    </message>
    <message>
        <source>tissue %1</source>
        <translation>Gewebe %1</translation>
    </message>
    <message>
        <source>aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>inferior vena cava</source>
        <translation>untere Hohlvene</translation>
    </message>
    <message>
        <source>kidney left</source>
        <translation>linke Niere</translation>
    </message>
    <message>
        <source>kidney right</source>
        <translation>rechte Niere</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>colon</source>
        <translation>Dickdarm</translation>
    </message>
    <message>
        <source>small bowel</source>
        <translation>Dünndarm</translation>
    </message>
    <message>
        <source>duodenum</source>
        <translation>Zwölffingerdarm</translation>
    </message>
    <message>
        <source>stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>sacrum</source>
        <translation>Kreuzbein</translation>
    </message>
    <message>
        <source>Acupuncture</source>
        <translation>Akupunktur</translation>
    </message>
    <message>
        <source>A thin needle is brought to the depth of a point, moved there by lifting, thrusting and twirling, and drawn out.</source>
        <translation>Eine dünne Nadel wird in die Tiefe eines Punktes gebracht, dort gehoben, gesenkt und gedreht, und herausgezogen.</translation>
    </message>
    <message>
        <source>Find the point</source>
        <translation>Den Punkt finden</translation>
    </message>
    <message>
        <source>By its landmarks, measured in the patient's own body inches.</source>
        <translation>Nach seinen Landmarken, gemessen in den eigenen Körperzoll des Patienten.</translation>
    </message>
    <message>
        <source>Touch the skin</source>
        <translation>Die Haut berühren</translation>
    </message>
    <message>
        <source>At the point, with the angle that it asks for.</source>
        <translation>Am Punkt, mit dem Winkel, den er verlangt.</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einstechen</translation>
    </message>
    <message>
        <source>Quickly through the skin, then slowly to the depth of the point.</source>
        <translation>Schnell durch die Haut, dann langsam bis in die Tiefe des Punktes.</translation>
    </message>
    <message>
        <source>Lift and thrust</source>
        <translation>Heben und senken</translation>
    </message>
    <message>
        <source>Evenly, by 2 to 10 mm, once in one to four seconds.</source>
        <translation>Gleichmäßig, um 2 bis 10 mm, einmal in ein bis vier Sekunden.</translation>
    </message>
    <message>
        <source>Twirl</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Between thumb and finger, a quarter turn to a whole one and back, once in a third of a second to two seconds.</source>
        <translation>Zwischen Daumen und Finger, eine viertel bis eine ganze Umdrehung hin und zurück, einmal in einer drittel bis zwei Sekunden.</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>Draw the needle out along its own line.</source>
        <translation>Ziehen Sie die Nadel entlang ihrer eigenen Linie heraus.</translation>
    </message>
    <message>
        <source>the spinal cord</source>
        <translation>das Rückenmark</translation>
    </message>
    <message>
        <source>paralysis</source>
        <translation>Lähmung</translation>
    </message>
    <message>
        <source>a nerve</source>
        <translation>ein Nerv</translation>
    </message>
    <message>
        <source>pain, and lasting damage to the nerve</source>
        <translation>Schmerz und bleibender Schaden am Nerv</translation>
    </message>
    <message>
        <source>a large vessel</source>
        <translation>ein großes Gefäß</translation>
    </message>
    <message>
        <source>bleeding</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>the lung</source>
        <translation>die Lunge</translation>
    </message>
    <message>
        <source>pneumothorax</source>
        <translation>Pneumothorax</translation>
    </message>
    <message>
        <source>an organ</source>
        <translation>ein Organ</translation>
    </message>
    <message>
        <source>Measure from the landmarks again: the point is missed at the skin.</source>
        <translation>Messen Sie noch einmal von den Landmarken aus: der Punkt wurde an der Haut verfehlt.</translation>
    </message>
    <message>
        <source>Thrust no deeper than the point allows.</source>
        <translation>Stechen Sie nicht tiefer, als der Punkt erlaubt.</translation>
    </message>
    <message>
        <source>Keep an even rhythm.</source>
        <translation>Halten Sie einen gleichmäßigen Rhythmus.</translation>
    </message>
    <message>
        <source>Hold the needle at the angle of the point before it goes in.</source>
        <translation>Halten Sie die Nadel im Winkel des Punktes, bevor sie hineingeht.</translation>
    </message>
    <message>
        <source>Twirl as far one way as the other, or the tissue winds about the needle.</source>
        <translation>Drehen Sie so weit hin wie zurück, sonst wickelt sich das Gewebe um die Nadel.</translation>
    </message>
    <message>
        <source>CT-guided biopsy</source>
        <translation>CT-gesteuerte Biopsie</translation>
    </message>
    <message>
        <source>A sample is taken from a lesion along a path that was planned in the CT. The organ that the target lies in is meant to be entered; every other one is not.</source>
        <translation>Aus einer Läsion wird auf einem im CT geplanten Weg eine Probe genommen. In das Organ, in dem das Ziel liegt, soll gestochen werden; in kein anderes.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Choose a straight path from the skin to the lesion that keeps clear of vessels, bowel, pleura and nerves.</source>
        <translation>Wählen Sie einen geraden Weg von der Haut zur Läsion, der Gefäße, Darm, Pleura und Nerven meidet.</translation>
    </message>
    <message>
        <source>At the planned entry, with the planned angle.</source>
        <translation>Am geplanten Eintritt, im geplanten Winkel.</translation>
    </message>
    <message>
        <source>Advance to the lesion</source>
        <translation>Zur Läsion vorschieben</translation>
    </message>
    <message>
        <source>Go on in steps, with a scan between them. Correct the angle early: deep in the body the needle only bends.</source>
        <translation>Gehen Sie in Schritten vor, mit einer Aufnahme dazwischen. Verbessern Sie den Winkel früh: tief im Körper biegt sich die Nadel nur.</translation>
    </message>
    <message>
        <source>Reach the lesion</source>
        <translation>Die Läsion erreichen</translation>
    </message>
    <message>
        <source>The attempt is complete when the tip touches the lesion.</source>
        <translation>Der Versuch ist vollständig, wenn die Spitze die Läsion berührt.</translation>
    </message>
    <message>
        <source>gas-filled bowel</source>
        <translation>gasgefüllter Darm</translation>
    </message>
    <message>
        <source>leakage into the abdomen</source>
        <translation>Austritt in den Bauchraum</translation>
    </message>
    <message>
        <source>the colon</source>
        <translation>der Dickdarm</translation>
    </message>
    <message>
        <source>the small bowel</source>
        <translation>der Dünndarm</translation>
    </message>
    <message>
        <source>the duodenum</source>
        <translation>der Zwölffingerdarm</translation>
    </message>
    <message>
        <source>the stomach</source>
        <translation>der Magen</translation>
    </message>
    <message>
        <source>An error to the side misses the lesion; correct the angle while the needle is shallow.</source>
        <translation>Ein Fehler zur Seite verfehlt die Läsion; verbessern Sie den Winkel, solange die Nadel flach steckt.</translation>
    </message>
    <message>
        <source>Read the needle's marks: stop at the planned depth.</source>
        <translation>Lesen Sie die Marken der Nadel: halten Sie in der geplanten Tiefe an.</translation>
    </message>
    <message>
        <source>Check the angle against the plan before each step.</source>
        <translation>Prüfen Sie vor jedem Schritt den Winkel gegen den Plan.</translation>
    </message>
    <message>
        <source>Set the angle at the skin: every degree is 1 mm to the side at 60 mm.</source>
        <translation>Stellen Sie den Winkel an der Haut ein: jedes Grad macht in 60 mm Tiefe 1 mm zur Seite.</translation>
    </message>
    <message>
        <source>Every new puncture of an organ's capsule bleeds.</source>
        <translation>Jeder neue Stich durch die Kapsel eines Organs blutet.</translation>
    </message>
    <message>
        <source>Lumbar epidural</source>
        <translation>Lumbale Epiduralanästhesie</translation>
    </message>
    <message>
        <source>A catheter or a drug is brought into the epidural space, in front of the ligamentum flavum and behind the dura.</source>
        <translation>Ein Katheter oder ein Mittel wird in den Epiduralraum gebracht, vor das Ligamentum flavum und hinter die Dura.</translation>
    </message>
    <message>
        <source>Find the interspace</source>
        <translation>Den Zwischenraum finden</translation>
    </message>
    <message>
        <source>Feel the iliac crests and count upwards from L4.</source>
        <translation>Tasten Sie die Beckenkämme und zählen Sie von L4 aufwärts.</translation>
    </message>
    <message>
        <source>Midline, the bevel towards the head.</source>
        <translation>Mittellinie, der Schliff zum Kopf.</translation>
    </message>
    <message>
        <source>Seat the needle</source>
        <translation>Die Nadel setzen</translation>
    </message>
    <message>
        <source>In the interspinous ligament the needle stands by itself: attach the syringe of saline or air now.</source>
        <translation>Im Ligamentum interspinale steht die Nadel von selbst: setzen Sie jetzt die Spritze mit Kochsalz oder Luft auf.</translation>
    </message>
    <message>
        <source>Enter the ligamentum flavum</source>
        <translation>In das Ligamentum flavum</translation>
    </message>
    <message>
        <source>Press on the plunger: it does not move. Advance by a millimetre at a time.</source>
        <translation>Drücken Sie auf den Stempel: er bewegt sich nicht. Gehen Sie Millimeter für Millimeter vor.</translation>
    </message>
    <message>
        <source>Lose the resistance</source>
        <translation>Den Widerstand verlieren</translation>
    </message>
    <message>
        <source>The plunger gives way. Do not move the needle any more.</source>
        <translation>Der Stempel gibt nach. Bewegen Sie die Nadel nicht mehr.</translation>
    </message>
    <message>
        <source>Rest in the epidural space</source>
        <translation>Im Epiduralraum ruhen</translation>
    </message>
    <message>
        <source>Nothing may return through the needle: fluid means that the dura is open.</source>
        <translation>Durch die Nadel darf nichts zurückkommen: Flüssigkeit heißt, dass die Dura offen ist.</translation>
    </message>
    <message>
        <source>Draw the needle out over the catheter.</source>
        <translation>Ziehen Sie die Nadel über dem Katheter heraus.</translation>
    </message>
    <message>
        <source>the dural sac</source>
        <translation>der Durasack</translation>
    </message>
    <message>
        <source>a wet tap: headache in most patients, and a total spinal block if the dose is given</source>
        <translation>eine Duraperforation: Kopfschmerz bei den meisten Patienten, und eine totale Spinalanästhesie, wenn die Dosis gegeben wird</translation>
    </message>
    <message>
        <source>a nerve root</source>
        <translation>eine Nervenwurzel</translation>
    </message>
    <message>
        <source>bleeding into the retroperitoneum</source>
        <translation>Blutung in das Retroperitoneum</translation>
    </message>
    <message>
        <source>bleeding, or leakage into the abdomen</source>
        <translation>Blutung, oder Austritt in den Bauchraum</translation>
    </message>
    <message>
        <source>an intervertebral disc</source>
        <translation>eine Bandscheibe</translation>
    </message>
    <message>
        <source>the needle went through the whole canal; a disc can be infected</source>
        <translation>die Nadel ging durch den ganzen Kanal; eine Bandscheibe kann sich entzünden</translation>
    </message>
    <message>
        <source>Brace your hand against the back and advance by a millimetre at a time: the space is 4 to 6 mm deep.</source>
        <translation>Stützen Sie die Hand am Rücken ab und gehen Sie Millimeter für Millimeter vor: der Raum ist 4 bis 6 mm tief.</translation>
    </message>
    <message>
        <source>Slow down as soon as you feel the ligamentum flavum.</source>
        <translation>Werden Sie langsamer, sobald Sie das Ligamentum flavum spüren.</translation>
    </message>
    <message>
        <source>Feel for the midline again before you change the angle.</source>
        <translation>Tasten Sie noch einmal nach der Mittellinie, bevor Sie den Winkel ändern.</translation>
    </message>
    <message>
        <source>Feel the spinous processes above and below, and enter in the middle between them.</source>
        <translation>Tasten Sie die Dornfortsätze darüber und darunter, und stechen Sie mitten dazwischen ein.</translation>
    </message>
    <message>
        <source>Feel for the softest place between two spinous processes.</source>
        <translation>Tasten Sie nach der weichsten Stelle zwischen zwei Dornfortsätzen.</translation>
    </message>
    <message>
        <source>Feel for the interspace with a finger before you take the needle.</source>
        <translation>Tasten Sie den Zwischenraum mit einem Finger, bevor Sie die Nadel nehmen.</translation>
    </message>
    <message>
        <source>Read the opening pressure before fluid is lost.</source>
        <translation>Lesen Sie den Eröffnungsdruck ab, bevor Liquor verloren geht.</translation>
    </message>
    <message>
        <source>The laboratory needs a millilitre in each tube, and the patient the rest.</source>
        <translation>Das Labor braucht einen Milliliter in jedem Röhrchen, der Patient den Rest.</translation>
    </message>
    <message>
        <source>Put the stylet back before you draw the needle out.</source>
        <translation>Stecken Sie den Mandrin zurück, bevor Sie die Nadel herausziehen.</translation>
    </message>
    <message>
        <source>Choose the interspace with care before you pierce the skin.</source>
        <translation>Wählen Sie den Zwischenraum mit Bedacht, bevor Sie die Haut durchstechen.</translation>
    </message>
    <message>
        <source>Bone in the depth is a lamina: draw back to the fat, then aim more towards the head.</source>
        <translation>Knochen in der Tiefe ist ein Wirbelbogen: ziehen Sie bis ins Fett zurück und zielen Sie dann mehr zum Kopf.</translation>
    </message>
    <message>
        <source>Joint injection</source>
        <translation>Gelenkinjektion</translation>
    </message>
    <message>
        <source>A drug is injected into the space of a joint, whose place in it is the target of the case.</source>
        <translation>Ein Mittel wird in einen Gelenkspalt gespritzt; die Stelle darin ist das Ziel des Falls.</translation>
    </message>
    <message>
        <source>Find the joint line</source>
        <translation>Den Gelenkspalt finden</translation>
    </message>
    <message>
        <source>Feel the bones on both sides of it; with ultrasound, bring the space into the slice.</source>
        <translation>Tasten Sie die Knochen zu beiden Seiten; mit Ultraschall bringen Sie den Spalt in die Schicht.</translation>
    </message>
    <message>
        <source>At the planned entry, away from vessels and nerves.</source>
        <translation>Am geplanten Eintritt, abseits von Gefäßen und Nerven.</translation>
    </message>
    <message>
        <source>Advance to the capsule</source>
        <translation>Bis zur Kapsel vorschieben</translation>
    </message>
    <message>
        <source>Slowly; resistance rises at the capsule and falls behind it.</source>
        <translation>Langsam; der Widerstand steigt an der Kapsel und fällt dahinter.</translation>
    </message>
    <message>
        <source>Rest in the joint</source>
        <translation>Im Gelenk ruhen</translation>
    </message>
    <message>
        <source>The drug must flow without pressure. If it does not, the tip is in cartilage or in the capsule: draw back by a millimetre.</source>
        <translation>Das Mittel muss ohne Druck fließen. Tut es das nicht, steckt die Spitze in Knorpel oder Kapsel: ziehen Sie einen Millimeter zurück.</translation>
    </message>
    <message>
        <source>bleeding, or injection into the circulation</source>
        <translation>Blutung, oder Injektion in den Kreislauf</translation>
    </message>
    <message>
        <source>the joint's cartilage</source>
        <translation>der Gelenkknorpel</translation>
    </message>
    <message>
        <source>cartilage does not heal</source>
        <translation>Knorpel heilt nicht</translation>
    </message>
    <message>
        <source>Stop when the resistance of the capsule falls.</source>
        <translation>Halten Sie an, wenn der Widerstand der Kapsel fällt.</translation>
    </message>
    <message>
        <source>Aim along the joint line, not at the bone beside it.</source>
        <translation>Zielen Sie entlang des Gelenkspalts, nicht auf den Knochen daneben.</translation>
    </message>
    <message>
        <source>Do not press on bone: its periosteum hurts.</source>
        <translation>Drücken Sie nicht auf Knochen: die Knochenhaut schmerzt.</translation>
    </message>
    <message>
        <source>Lumbar puncture</source>
        <translation>Lumbalpunktion</translation>
    </message>
    <message>
        <source>Cerebrospinal fluid is drawn from the lumbar sac, below the end of the cord.</source>
        <translation>Aus dem lumbalen Durasack, unterhalb des Rückenmarks, wird Liquor entnommen.</translation>
    </message>
    <message>
        <source>Feel the iliac crests: the line between them crosses the spine at L4 or L4/L5. Choose L3/L4 or L4/L5.</source>
        <translation>Tasten Sie die Beckenkämme: die Linie zwischen ihnen kreuzt die Wirbelsäule bei L4 oder L4/L5. Wählen Sie L3/L4 oder L4/L5.</translation>
    </message>
    <message>
        <source>Place the tip in the middle between two spinous processes and aim slightly towards the head.</source>
        <translation>Setzen Sie die Spitze mitten zwischen zwei Dornfortsätze und zielen Sie etwas zum Kopf.</translation>
    </message>
    <message>
        <source>Cross the interspinous ligament</source>
        <translation>Durch das Ligamentum interspinale</translation>
    </message>
    <message>
        <source>Advance a few millimetres at a time and keep to the midline. Bone means: draw back to the fat and change the angle.</source>
        <translation>Gehen Sie wenige Millimeter auf einmal vor und bleiben Sie in der Mittellinie. Knochen heißt: bis ins Fett zurückziehen und den Winkel ändern.</translation>
    </message>
    <message>
        <source>Cross the ligamentum flavum</source>
        <translation>Durch das Ligamentum flavum</translation>
    </message>
    <message>
        <source>The resistance rises. Slow down: it is lost in a moment.</source>
        <translation>Der Widerstand steigt. Werden Sie langsamer: er schwindet in einem Augenblick.</translation>
    </message>
    <message>
        <source>Stop at once. The tip is in the epidural space.</source>
        <translation>Halten Sie sofort an. Die Spitze ist im Epiduralraum.</translation>
    </message>
    <message>
        <source>Pierce the dura</source>
        <translation>Die Dura durchstechen</translation>
    </message>
    <message>
        <source>Go on by a millimetre at a time until the dura gives way with a slight pop.</source>
        <translation>Gehen Sie Millimeter für Millimeter weiter, bis die Dura mit einem leichten Ruck nachgibt.</translation>
    </message>
    <message>
        <source>Read the opening pressure</source>
        <translation>Den Eröffnungsdruck ablesen</translation>
    </message>
    <message>
        <source>Connect the manometer and wait until the column stands still.</source>
        <translation>Schließen Sie das Manometer an und warten Sie, bis die Säule stillsteht.</translation>
    </message>
    <message>
        <source>Collect fluid</source>
        <translation>Liquor sammeln</translation>
    </message>
    <message>
        <source>Take the manometer off and let the fluid drip into the tubes. 20 drops are about a millilitre.</source>
        <translation>Nehmen Sie das Manometer ab und lassen Sie den Liquor in die Röhrchen tropfen. 20 Tropfen sind etwa ein Milliliter.</translation>
    </message>
    <message>
        <source>Read the closing pressure</source>
        <translation>Den Schlussdruck ablesen</translation>
    </message>
    <message>
        <source>Connect the manometer once more.</source>
        <translation>Schließen Sie das Manometer noch einmal an.</translation>
    </message>
    <message>
        <source>Put the stylet back</source>
        <translation>Den Mandrin zurückstecken</translation>
    </message>
    <message>
        <source>A nerve root or a strand of the arachnoid can slip into an open needle.</source>
        <translation>In eine offene Nadel kann eine Nervenwurzel oder ein Strang der Arachnoidea geraten.</translation>
    </message>
    <message>
        <source>Let fluid return</source>
        <translation>Liquor kommen lassen</translation>
    </message>
    <message>
        <source>Hold the needle still, take the stylet out and wait for fluid.</source>
        <translation>Halten Sie die Nadel still, ziehen Sie den Mandrin und warten Sie auf Liquor.</translation>
    </message>
    <message>
        <source>Put the stylet back and draw the needle out along its own line.</source>
        <translation>Setzen Sie den Mandrin wieder ein und ziehen Sie die Nadel entlang ihrer eigenen Linie heraus.</translation>
    </message>
    <message>
        <source>Brace your hand against the back and stop as soon as the resistance falls.</source>
        <translation>Stützen Sie die Hand am Rücken ab und halten Sie an, sobald der Widerstand fällt.</translation>
    </message>
    <message>
        <source>The sac is about 15 mm deep; the roots lie at its front.</source>
        <translation>Der Sack ist etwa 15 mm tief; die Wurzeln liegen vorn darin.</translation>
    </message>
    <message>
        <source>Do not press on bone: it bends the tip and hurts.</source>
        <translation>Drücken Sie nicht auf Knochen: das verbiegt die Spitze und schmerzt.</translation>
    </message>
    <message>
        <source>Needle insertion</source>
        <translation>Nadelstich</translation>
    </message>
    <message>
        <source>The tip is brought to the planned target and harms nothing on its way.</source>
        <translation>Die Spitze wird zum geplanten Ziel gebracht und verletzt unterwegs nichts.</translation>
    </message>
    <message>
        <source>Advance to the target</source>
        <translation>Zum Ziel vorschieben</translation>
    </message>
    <message>
        <source>Slowly, in steps.</source>
        <translation>Langsam, in Schritten.</translation>
    </message>
    <message>
        <source>Stop at the planned depth.</source>
        <translation>Halten Sie in der geplanten Tiefe an.</translation>
    </message>
    <message>
        <source>Spinal anaesthesia</source>
        <translation>Spinalanästhesie</translation>
    </message>
    <message>
        <source>A local anaesthetic is injected into the cerebrospinal fluid below the end of the cord, through a thin needle.</source>
        <translation>Ein Lokalanästhetikum wird unterhalb des Rückenmarks durch eine dünne Nadel in den Liquor gespritzt.</translation>
    </message>
    <message>
        <source>Feel the iliac crests and choose L3/L4 or L4/L5: above L3 the cord may still be there.</source>
        <translation>Tasten Sie die Beckenkämme und wählen Sie L3/L4 oder L4/L5: über L3 kann noch Rückenmark liegen.</translation>
    </message>
    <message>
        <source>Midline, a little towards the head; a needle of 25G or thinner needs an introducer.</source>
        <translation>Mittellinie, etwas zum Kopf; eine Nadel von 25G oder dünner braucht eine Führungskanüle.</translation>
    </message>
    <message>
        <source>A thin needle bends and feels little: go slowly.</source>
        <translation>Eine dünne Nadel biegt sich und lässt wenig spüren: gehen Sie langsam.</translation>
    </message>
    <message>
        <source>Stop.</source>
        <translation>Halten Sie an.</translation>
    </message>
    <message>
        <source>A pop may be all that you feel.</source>
        <translation>Ein Ruck ist vielleicht alles, was Sie spüren.</translation>
    </message>
    <message>
        <source>Inject</source>
        <translation>Spritzen</translation>
    </message>
    <message>
        <source>Fluid must return before anything is injected, and the needle must not move while you inject.</source>
        <translation>Liquor muss kommen, bevor etwas gespritzt wird, und die Nadel darf sich dabei nicht bewegen.</translation>
    </message>
    <message>
        <source>Stop as soon as the dura has given way.</source>
        <translation>Halten Sie an, sobald die Dura nachgegeben hat.</translation>
    </message>
    <message>
        <source>Each redirection of a thin needle bends it a little more; use the introducer to change the angle.</source>
        <translation>Jede Richtungsänderung biegt eine dünne Nadel etwas mehr; ändern Sie den Winkel mit der Führungskanüle.</translation>
    </message>
    <message>
        <source>Bone in the depth is a lamina: draw back into the introducer, then aim more towards the head.</source>
        <translation>Knochen in der Tiefe ist ein Wirbelbogen: ziehen Sie in die Führungskanüle zurück und zielen Sie dann mehr zum Kopf.</translation>
    </message>
    <message>
        <source>A thin needle buckles on bone.</source>
        <translation>Eine dünne Nadel knickt auf Knochen.</translation>
    </message>
    <message>
        <source>length of the tip's path in the body</source>
        <translation>Länge des Wegs der Spitze im Körper</translation>
    </message>
    <message>
        <source>detour to the final position</source>
        <translation>Umweg zur Endlage</translation>
    </message>
    <message>
        <source>travel along the shaft</source>
        <translation>Weg entlang des Schafts</translation>
    </message>
    <message>
        <source>mean speed in the body</source>
        <translation>mittlere Geschwindigkeit im Körper</translation>
    </message>
    <message>
        <source>area swept by the needle</source>
        <translation>von der Nadel überstrichene Fläche</translation>
    </message>
    <message>
        <source>smoothness</source>
        <translation>Flüssigkeit der Bewegung</translation>
    </message>
    <message>
        <source>tremor of the tip</source>
        <translation>Zittern der Spitze</translation>
    </message>
    <message>
        <source>frequency of the tremor</source>
        <translation>Frequenz des Zitterns</translation>
    </message>
    <message>
        <source>turning of the shaft in the body</source>
        <translation>Schwenken des Schafts im Körper</translation>
    </message>
    <message>
        <source>distance of the final position from the target</source>
        <translation>Abstand der Endlage vom Ziel</translation>
    </message>
    <message>
        <source>depth of the final position beyond the target</source>
        <translation>Tiefe der Endlage hinter dem Ziel</translation>
    </message>
    <message>
        <source>lateral distance of the final position from the target</source>
        <translation>seitlicher Abstand der Endlage vom Ziel</translation>
    </message>
    <message>
        <source>closest approach to the target</source>
        <translation>größte Annäherung an das Ziel</translation>
    </message>
    <message>
        <source>greatest depth beyond the target</source>
        <translation>größte Tiefe hinter dem Ziel</translation>
    </message>
    <message>
        <source>greatest depth</source>
        <translation>größte Tiefe</translation>
    </message>
    <message>
        <source>distance of the entry from the planned entry</source>
        <translation>Abstand des Eintritts vom geplanten Eintritt</translation>
    </message>
    <message>
        <source>places felt with a finger before the first insertion</source>
        <translation>vor dem ersten Einstich mit einem Finger getastete Stellen</translation>
    </message>
    <message>
        <source>time with a finger on the skin before the first insertion</source>
        <translation>Zeit mit einem Finger auf der Haut vor dem ersten Einstich</translation>
    </message>
    <message>
        <source>distance of the first entry from the nearest place that was felt</source>
        <translation>Abstand des ersten Einstichs von der nächsten getasteten Stelle</translation>
    </message>
    <message>
        <source>distance of the entry from the middle of the back</source>
        <translation>Abstand des Einstichs von der Mitte des Rückens</translation>
    </message>
    <message>
        <source>distance of the entry from the middle of the interspace</source>
        <translation>Abstand des Einstichs von der Mitte des Zwischenraums</translation>
    </message>
    <message>
        <source>pressures read</source>
        <translation>abgelesene Drücke</translation>
    </message>
    <message>
        <source>opening pressure</source>
        <translation>Eröffnungsdruck</translation>
    </message>
    <message>
        <source>time until the opening pressure was read</source>
        <translation>Zeit bis zum Ablesen des Eröffnungsdrucks</translation>
    </message>
    <message>
        <source>fluid collected</source>
        <translation>gesammelter Liquor</translation>
    </message>
    <message>
        <source>closing pressure</source>
        <translation>Schlussdruck</translation>
    </message>
    <message>
        <source>withdrawals without the stylet</source>
        <translation>Herausziehen ohne Mandrin</translation>
    </message>
    <message>
        <source>greatest distance from the planned path</source>
        <translation>größter Abstand vom geplanten Weg</translation>
    </message>
    <message>
        <source>distance from the planned path, root mean square</source>
        <translation>Abstand vom geplanten Weg, quadratisches Mittel</translation>
    </message>
    <message>
        <source>angle to the planned path at the skin</source>
        <translation>Winkel zum geplanten Weg an der Haut</translation>
    </message>
    <message>
        <source>angle to the planned path at the final position</source>
        <translation>Winkel zum geplanten Weg in der Endlage</translation>
    </message>
    <message>
        <source>amplitude of lifting and thrusting</source>
        <translation>Amplitude von Heben und Senken</translation>
    </message>
    <message>
        <source>frequency of lifting and thrusting</source>
        <translation>Frequenz von Heben und Senken</translation>
    </message>
    <message>
        <source>amplitude of twirling</source>
        <translation>Amplitude des Drehens</translation>
    </message>
    <message>
        <source>frequency of twirling</source>
        <translation>Frequenz des Drehens</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>time in the body</source>
        <translation>Zeit im Körper</translation>
    </message>
    <message>
        <source>time to the final position</source>
        <translation>Zeit bis zur Endlage</translation>
    </message>
    <message>
        <source>insertions</source>
        <translation>Einstiche</translation>
    </message>
    <message>
        <source>redirections</source>
        <translation>Richtungsänderungen</translation>
    </message>
    <message>
        <source>tissues that gave way</source>
        <translation>Gewebe, die nachgaben</translation>
    </message>
    <message>
        <source>depth at the loss of resistance</source>
        <translation>Tiefe beim Widerstandsverlust</translation>
    </message>
    <message>
        <source>fall of the force at the loss of resistance</source>
        <translation>Abfall der Kraft beim Widerstandsverlust</translation>
    </message>
    <message>
        <source>overshoot after the loss of resistance</source>
        <translation>Weg nach dem Widerstandsverlust</translation>
    </message>
    <message>
        <source>speed after the loss of resistance</source>
        <translation>Geschwindigkeit nach dem Widerstandsverlust</translation>
    </message>
    <message>
        <source>reaction to the loss of resistance</source>
        <translation>Reaktion auf den Widerstandsverlust</translation>
    </message>
    <message>
        <source>greatest overshoot after a puncture</source>
        <translation>größter Weg nach einem Durchstich</translation>
    </message>
    <message>
        <source>contacts with bone</source>
        <translation>Knochenkontakte</translation>
    </message>
    <message>
        <source>greatest force on bone</source>
        <translation>größte Kraft auf Knochen</translation>
    </message>
    <message>
        <source>largest resistance</source>
        <translation>größter Widerstand</translation>
    </message>
    <message>
        <source>mean resistance</source>
        <translation>mittlerer Widerstand</translation>
    </message>
    <message>
        <source>work done by the hand</source>
        <translation>Arbeit der Hand</translation>
    </message>
    <message>
        <source>distance of the tip from the ultrasound slice, mean</source>
        <translation>Abstand der Spitze von der Ultraschallschicht, im Mittel</translation>
    </message>
    <message>
        <source>distance of the tip from the ultrasound slice, greatest</source>
        <translation>Abstand der Spitze von der Ultraschallschicht, größter</translation>
    </message>
    <message>
        <source>time with the tip in the ultrasound slice</source>
        <translation>Zeit mit der Spitze in der Ultraschallschicht</translation>
    </message>
    <message>
        <source>angle between needle and ultrasound slice</source>
        <translation>Winkel zwischen Nadel und Ultraschallschicht</translation>
    </message>
    <message>
        <source>felt a place on the skin</source>
        <translation>eine Stelle der Haut getastet</translation>
    </message>
    <message>
        <source>feel a place on the skin</source>
        <translation>eine Stelle der Haut tasten</translation>
    </message>
    <message>
        <source>let the pressure be read</source>
        <translation>den Druck ablesen lassen</translation>
    </message>
    <message>
        <source>let cerebrospinal fluid return</source>
        <translation>Liquor kommen lassen</translation>
    </message>
    <message>
        <source>lost the resistance of the ligamentum flavum</source>
        <translation>den Widerstand des Ligamentum flavum verloren</translation>
    </message>
    <message>
        <source>lose the resistance of the ligamentum flavum</source>
        <translation>den Widerstand des Ligamentum flavum verlieren</translation>
    </message>
    <message>
        <source>let the syringe's plunger give way</source>
        <translation>den Stempel der Spritze nachgeben lassen</translation>
    </message>
    <message>
        <source>met bone</source>
        <translation>Knochen getroffen</translation>
    </message>
    <message>
        <source>meet bone</source>
        <translation>Knochen treffen</translation>
    </message>
    <message>
        <source>pushed the needle in up to its hub</source>
        <translation>die Nadel bis zum Ansatz eingestochen</translation>
    </message>
    <message>
        <source>push the needle in up to its hub</source>
        <translation>die Nadel bis zum Ansatz einstechen</translation>
    </message>
    <message>
        <source>pushed harder than the needle bears</source>
        <translation>stärker gedrückt, als die Nadel aushält</translation>
    </message>
    <message>
        <source>push less, so that the needle stays straight</source>
        <translation>weniger drücken, damit die Nadel gerade bleibt</translation>
    </message>
    <message>
        <source>touched the body</source>
        <translation>den Körper berührt</translation>
    </message>
    <message>
        <source>touch the body</source>
        <translation>den Körper berühren</translation>
    </message>
    <message>
        <source>come to rest in the %1</source>
        <translation>zur Ruhe kommen in: %1</translation>
    </message>
    <message>
        <source>came to rest in the %1</source>
        <translation>zur Ruhe gekommen in: %1</translation>
    </message>
    <message>
        <source>touch the %1</source>
        <translation>berühren: %1</translation>
    </message>
    <message>
        <source>touched the %1</source>
        <translation>berührt: %1</translation>
    </message>
    <message>
        <source>end within %1 mm of the target</source>
        <translation>höchstens %1 mm vom Ziel enden</translation>
    </message>
    <message>
        <source>ended within %1 mm of the target</source>
        <translation>höchstens %1 mm vom Ziel geendet</translation>
    </message>
    <message>
        <source>The tip came within %1 mm of %2 at %3 s, %4 mm deep.</source>
        <translation>Die Spitze kam auf %1 mm heran an: %2, nach %3 s, in %4 mm Tiefe.</translation>
    </message>
    <message>
        <source>The tip entered %1 at %2 s, %3 mm deep.</source>
        <translation>Die Spitze drang ein: %1, nach %2 s, in %3 mm Tiefe.</translation>
    </message>
    <message>
        <source>The tip entered %1 at %2 s, %3 mm deep, and %4 in all.</source>
        <translation>Die Spitze drang ein: %1, nach %2 s, in %3 mm Tiefe, insgesamt %4.</translation>
    </message>
    <message>
        <source>The tip entered %1 at %2 s, %3 mm deep: %4.</source>
        <translation>Die Spitze drang ein: %1, nach %2 s, in %3 mm Tiefe. Folge: %4.</translation>
    </message>
    <message>
        <source>The tip entered %1 at %2 s, %3 mm deep, and %4 in all: %5.</source>
        <translation>Die Spitze drang ein: %1, nach %2 s, in %3 mm Tiefe, insgesamt %4. Folge: %5.</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>zweimal</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>%1: %2; at least %3 passes.</source>
        <translation>%1: %2; bestanden ab %3.</translation>
    </message>
    <message>
        <source>%1: %2; at most %3 passes.</source>
        <translation>%1: %2; bestanden bis %3.</translation>
    </message>
    <message>
        <source>%1: %2; %3 to %4 passes.</source>
        <translation>%1: %2; bestanden von %3 bis %4.</translation>
    </message>
    <message>
        <source>%1: %2; %3 passes.</source>
        <translation>%1: %2; bestanden bei %3.</translation>
    </message>
    <message>
        <source>You crossed the ligamentum flavum at %1 mm and stopped %2 mm further, after %3 s.</source>
        <translation>Sie gingen bei %1 mm durch das Ligamentum flavum und hielten nach weiteren %2 mm an, nach %3 s.</translation>
    </message>
    <message>
        <source>The plunger gave way at %1 mm and stopped %2 mm further, after %3 s.</source>
        <translation>Der Stempel gab bei %1 mm nach, und Sie hielten nach weiteren %2 mm an, nach %3 s.</translation>
    </message>
    <message>
        <source>You crossed the ligamentum flavum at %1 mm and went %2 mm further before you stopped, at up to %3 mm/s; below %4 mm/s after %5 mm you can stop in time.</source>
        <translation>Sie gingen bei %1 mm durch das Ligamentum flavum und kamen noch %2 mm weiter, bevor Sie anhielten, mit bis zu %3 mm/s; unter %4 mm/s ab %5 mm können Sie rechtzeitig anhalten.</translation>
    </message>
    <message>
        <source>The plunger gave way at %1 mm and went %2 mm further before you stopped, at up to %3 mm/s; below %4 mm/s after %5 mm you can stop in time.</source>
        <translation>Der Stempel gab bei %1 mm nach, und Sie kamen noch %2 mm weiter, bevor Sie anhielten, mit bis zu %3 mm/s; unter %4 mm/s ab %5 mm können Sie rechtzeitig anhalten.</translation>
    </message>
    <message>
        <source>The tip came to rest</source>
        <translation>Die Spitze kam zur Ruhe</translation>
    </message>
    <message>
        <source>The tip came to rest in the %1</source>
        <translation>Die Spitze kam zur Ruhe (%1)</translation>
    </message>
    <message>
        <source>The tip never came to rest; its deepest point lies</source>
        <translation>Die Spitze kam nie zur Ruhe; ihr tiefster Punkt liegt</translation>
    </message>
    <message>
        <source>The tip never came to rest; its deepest point lies in the %1</source>
        <translation>Die Spitze kam nie zur Ruhe (ihr tiefster Punkt: %1)</translation>
    </message>
    <message>
        <source>%1, on the planned target.</source>
        <translation>%1, auf dem geplanten Ziel.</translation>
    </message>
    <message>
        <source>%1, %2 mm from the planned target: %3 mm too deep and %4 mm to the side.</source>
        <translation>%1, %2 mm vom geplanten Ziel: %3 mm zu tief und %4 mm zur Seite.</translation>
    </message>
    <message>
        <source>%1, %2 mm from the planned target: %3 mm short of it and %4 mm to the side.</source>
        <translation>%1, %2 mm vom geplanten Ziel: %3 mm davor und %4 mm zur Seite.</translation>
    </message>
    <message>
        <source>The needle never touched the body.</source>
        <translation>Die Nadel berührte den Körper nie.</translation>
    </message>
    <message>
        <source>The patient's segmentation is not at hand, so that it could not be seen whether the tip entered %1; name the case with --case.</source>
        <translation>Die Segmentierung des Patienten ist nicht zur Hand; es war nicht zu sehen, ob die Spitze eindrang in: %1. Nennen Sie den Fall mit --case.</translation>
    </message>
    <message>
        <source>The aim was not reached: the tip must %1.</source>
        <translation>Das Ziel wurde nicht erreicht. Verlangt ist: %1.</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1, oder %2</translation>
    </message>
    <message>
        <source>You felt %1 before you entered.</source>
        <translation>Sie tasteten %1, bevor Sie einstachen.</translation>
    </message>
    <message>
        <source>You felt %1 last, but entered at %2.</source>
        <translation>Sie tasteten zuletzt %1, stachen aber bei %2 ein.</translation>
    </message>
    <message>
        <source>You entered at %1.</source>
        <translation>Sie stachen bei %1 ein.</translation>
    </message>
    <message>
        <source>You entered at %1, expected %2.</source>
        <translation>Sie stachen bei %1 ein, erwartet: %2.</translation>
    </message>
    <message>
        <source>The ultrasound showed nothing that the procedure names.</source>
        <translation>Der Ultraschall zeigte nichts von dem, was der Eingriff nennt.</translation>
    </message>
    <message>
        <source>The ultrasound showed %1.</source>
        <translation>Der Ultraschall zeigte: %1.</translation>
    </message>
    <message>
        <source>A needle of %1G is unusual here: %2G to %3G is.</source>
        <translation>Eine Nadel von %1G ist hier unüblich; üblich sind %2G bis %3G.</translation>
    </message>
    <message>
        <source>Feeling for the interspace, pressure, fluid and stylet were not judged: this patient has neither the part fingertip nor csf_flow.</source>
        <translation>Tasten nach dem Zwischenwirbelraum, Druck, Liquor und Mandrin wurden nicht bewertet: dieser Patient hat weder den Teil fingertip noch csf_flow.</translation>
    </message>
    <message>
        <source>Feeling for the interspace was not judged: this patient lacks the part fingertip.</source>
        <translation>Tasten nach dem Zwischenwirbelraum wurde nicht bewertet: dieser Patient hat nicht den Teil fingertip.</translation>
    </message>
    <message>
        <source>Pressure, fluid and stylet were not judged: this patient lacks the part csf_flow.</source>
        <translation>Druck, Liquor und Mandrin wurden nicht bewertet: dieser Patient hat nicht den Teil csf_flow.</translation>
    </message>
    <message>
        <source>The recording broke off before its end; this is what was saved.</source>
        <translation>Die Aufzeichnung brach vor dem Ende ab; dies wurde gesichert.</translation>
    </message>
    <message>
        <source>%1 s of the recording are missing while the needle was in the body.</source>
        <translation>%1 s der Aufzeichnung fehlen, während die Nadel im Körper war.</translation>
    </message>
    <message>
        <source>A fault took the force away, so that you did not feel the tissue.</source>
        <translation>Eine Störung nahm die Kraft weg, sodass Sie das Gewebe nicht spürten.</translation>
    </message>
    <message>
        <source>Failed: the needle never touched the body</source>
        <translation>Nicht bestanden: die Nadel berührte den Körper nie</translation>
    </message>
    <message>
        <source>the aim was not reached</source>
        <translation>das Ziel wurde nicht erreicht</translation>
    </message>
    <message>
        <source>the tip %1</source>
        <translation>die Spitze: %1</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>Bestanden: %1</translation>
    </message>
    <message>
        <source>Borderline: %1, but not without fault</source>
        <translation>Grenzwertig: %1, aber nicht ohne Fehler</translation>
    </message>
    <message>
        <source>Dangerous: the tip entered %1</source>
        <translation>Gefährlich: die Spitze drang ein: %1</translation>
    </message>
    <message>
        <source>Failed: the tip entered %1</source>
        <translation>Nicht bestanden: die Spitze drang ein: %1</translation>
    </message>
    <message>
        <source>Dangerous: the aim was not reached</source>
        <translation>Gefährlich: das Ziel wurde nicht erreicht</translation>
    </message>
    <message>
        <source>Failed: the aim was not reached</source>
        <translation>Nicht bestanden: das Ziel wurde nicht erreicht</translation>
    </message>
    <message>
        <source>Dangerous: %1, but with a fault of %2</source>
        <translation>Gefährlich: %1, aber mit einem Fehler bei: %2</translation>
    </message>
    <message>
        <source>Failed: %1, but with a fault of %2</source>
        <translation>Nicht bestanden: %1, aber mit einem Fehler bei: %2</translation>
    </message>
    <message>
        <source>The session is saved</source>
        <translation>Die Sitzung ist gespeichert</translation>
    </message>
    <message>
        <source>The session is saved, but cannot be judged</source>
        <translation>Die Sitzung ist gespeichert, kann aber nicht beurteilt werden</translation>
    </message>
    <message>
        <source>This patient has no planned path, so there is nothing to judge by.</source>
        <translation>Dieser Patient hat keinen geplanten Weg; es gibt nichts, wonach geurteilt werden könnte.</translation>
    </message>
    <message>
        <source>This patient had no planned path, so there is nothing to judge by.</source>
        <translation>Dieser Patient hatte keinen geplanten Weg; es gibt nichts, wonach geurteilt werden könnte.</translation>
    </message>
    <message>
        <source>Spinal cord</source>
        <translation>Rückenmark</translation>
    </message>
    <message>
        <source>Stop and draw back at once, and go in two levels lower.</source>
        <translation>Halten Sie an, ziehen Sie sofort zurück und stechen Sie zwei Höhen tiefer ein.</translation>
    </message>
    <message>
        <source>Nerve</source>
        <translation>Nerv</translation>
    </message>
    <message>
        <source>Stop and draw back at once: the patient feels a shock down the leg.</source>
        <translation>Halten Sie an und ziehen Sie sofort zurück: der Patient spürt einen Schlag das Bein hinab.</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Draw back to the skin and press on the place before you go in again.</source>
        <translation>Ziehen Sie bis zur Haut zurück und drücken Sie auf die Stelle, bevor Sie wieder einstechen.</translation>
    </message>
    <message>
        <source>Draw back to the skin and choose another way in.</source>
        <translation>Ziehen Sie bis zur Haut zurück und wählen Sie einen anderen Weg.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Draw back to just under the skin, change the angle, go in again.</source>
        <translation>Ziehen Sie bis knapp unter die Haut zurück, ändern Sie den Winkel, stechen Sie wieder ein.</translation>
    </message>
    <message>
        <source>Draw back to just under the skin, then change the angle.</source>
        <translation>Ziehen Sie bis knapp unter die Haut zurück, ändern Sie dann den Winkel.</translation>
    </message>
    <message>
        <source>This patient has no skin to feel with a finger.</source>
        <translation>Bei diesem Patienten ist mit einem Finger nichts zu tasten.</translation>
    </message>
    <message>
        <source>Press with the finger. W, then H: the needle.</source>
        <translation>Drücken Sie mit dem Finger. W, dann H: die Nadel.</translation>
    </message>
    <message>
        <source>This patient has no fluid to measure.</source>
        <translation>Bei diesem Patienten ist kein Liquor zu messen.</translation>
    </message>
    <message>
        <source>Lift the finger first (W), then take the needle.</source>
        <translation>Heben Sie erst den Finger (W), nehmen Sie dann die Nadel.</translation>
    </message>
    <message>
        <source>Withdraw the needle before you fill the syringe anew.</source>
        <translation>Ziehen Sie die Nadel heraus, bevor Sie die Spritze neu füllen.</translation>
    </message>
    <message>
        <source>Target reached at %1 mm. S: stylet out.</source>
        <translation>Ziel erreicht in %1 mm. S: Mandrin ziehen.</translation>
    </message>
    <message>
        <source>mannequin</source>
        <translation>Puppe</translation>
    </message>
    <message>
        <source>needle</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Schallkopf</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>This camera is not calibrated: its picture is shown alone. Calibrate it with 'bodkin camera calibrate'.</source>
        <translation>Diese Kamera ist nicht kalibriert: ihr Bild wird allein gezeigt. Kalibrieren Sie sie mit 'bodkin camera calibrate'.</translation>
    </message>
    <message>
        <source>Withdraw the needle before you feel the skin.</source>
        <translation>Ziehen Sie die Nadel heraus, bevor Sie die Haut tasten.</translation>
    </message>
    <message>
        <source>S: stylet out. R: manometer. E ends. F1 keys</source>
        <translation>S: Mandrin. R: Manometer. E beendet. F1 Tasten</translation>
    </message>
    <message>
        <source>Push the needle through the skin before you leave it there.</source>
        <translation>Schieben Sie die Nadel durch die Haut, bevor Sie sie dort lassen.</translation>
    </message>
    <message>
        <source>No needle was left in the body.</source>
        <translation>Im Körper wurde keine Nadel gelassen.</translation>
    </message>
    <message>
        <source>%1; or choose the mouse on the page Devices</source>
        <translation>%1; oder wählen Sie die Maus auf der Seite Geräte</translation>
    </message>
    <message>
        <source>The tip touched the lesion %1 mm below the skin: the attempt is complete.</source>
        <translation>Die Spitze berührte die Läsion %1 mm unter der Haut: der Versuch ist vollständig.</translation>
    </message>
    <message>
        <source>The tip reached the target %1 mm below the skin: the attempt is complete.</source>
        <translation>Die Spitze erreichte das Ziel %1 mm unter der Haut: der Versuch ist vollständig.</translation>
    </message>
    <message>
        <source>The patient is being prepared.</source>
        <translation>Der Patient wird vorbereitet.</translation>
    </message>
    <message>
        <source>Bring the needle to the ring on the skin, and push.</source>
        <translation>Bringen Sie die Nadel zum Ring auf der Haut und schieben Sie.</translation>
    </message>
    <message>
        <source>Point at the ring on the skin and click, or just scroll.</source>
        <translation>Zeigen Sie auf den Ring auf der Haut und klicken Sie, oder drehen Sie einfach das Mausrad.</translation>
    </message>
    <message>
        <source>The needle goes to the skin.</source>
        <translation>Die Nadel geht zur Haut.</translation>
    </message>
    <message>
        <source>Click to put the needle on the skin. Drag the hub to tilt.</source>
        <translation>Klicken setzt die Nadel auf die Haut. Den Ansatz ziehen neigt sie.</translation>
    </message>
    <message>
        <source>Pressing on skin. Push until it gives.</source>
        <translation>Drückt auf die Haut. Schieben Sie, bis sie nachgibt.</translation>
    </message>
    <message>
        <source>Pressing on skin. Scroll to push until it gives.</source>
        <translation>Drückt auf die Haut. Schieben Sie mit dem Mausrad, bis sie nachgibt.</translation>
    </message>
    <message>
        <source>Hold B: press the plunger. E ends. F1 keys</source>
        <translation>B halten: Stempel drücken. E beendet. F1 Tasten</translation>
    </message>
    <message>
        <source>Push or draw back. E ends. F1 keys</source>
        <translation>Schieben oder zurückziehen. E beendet. F1 Tasten</translation>
    </message>
    <message>
        <source>Scroll to push or draw back. Space holds. F1 keys</source>
        <translation>Mausrad schiebt oder zieht zurück. Leertaste hält. F1 Tasten</translation>
    </message>
    <message>
        <source>Target reached at %1 mm. E ends.</source>
        <translation>Ziel erreicht bei %1 mm. E beendet.</translation>
    </message>
    <message>
        <source>Held. Space takes the needle up again.</source>
        <translation>Gehalten. Leertaste nimmt die Nadel wieder auf.</translation>
    </message>
    <message>
        <source>The guard took the force away. V arms again.</source>
        <translation>Der Wächter nahm die Kraft weg. V gibt sie wieder frei.</translation>
    </message>
    <message>
        <source>The device does not answer.</source>
        <translation>Das Gerät antwortet nicht.</translation>
    </message>
    <message>
        <source>touches the skin</source>
        <translation>berührt die Haut</translation>
    </message>
    <message>
        <source>%1 gives</source>
        <translation>%1 gibt nach</translation>
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
        <source>plunger gives way</source>
        <translation>Stempel gibt nach</translation>
    </message>
    <message>
        <source>a place is felt</source>
        <translation>eine Stelle getastet</translation>
    </message>
    <message>
        <source>stylet out</source>
        <translation>Mandrin heraus</translation>
    </message>
    <message>
        <source>pressure read</source>
        <translation>Druck abgelesen</translation>
    </message>
    <message>
        <source>out of the body</source>
        <translation>aus dem Körper</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>die Sitzung wird gelesen</translation>
    </message>
    <message>
        <source>reading the patient</source>
        <translation>der Patient wird gelesen</translation>
    </message>
    <message>
        <source>comparing the patient with the session's</source>
        <translation>der Patient wird mit dem der Sitzung verglichen</translation>
    </message>
    <message>
        <source>judging the session</source>
        <translation>die Sitzung wird beurteilt</translation>
    </message>
    <message>
        <source>preparing the ultrasound</source>
        <translation>der Ultraschall wird vorbereitet</translation>
    </message>
    <message>
        <source>The ultrasound of this session cannot be shown (%1).</source>
        <translation>Der Ultraschall dieser Sitzung kann nicht gezeigt werden (%1).</translation>
    </message>
    <message>
        <source>The patient in %1 has changed since this session: slices and 3-D show how it is now.</source>
        <translation>Der Patient in %1 hat sich seit dieser Sitzung geändert: Schichten und 3-D zeigen, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>The patient of this session is not there, so its path is shown without anatomy (%1).</source>
        <translation>Der Patient dieser Sitzung ist nicht da; der Weg wird ohne Anatomie gezeigt (%1).</translation>
    </message>
    <message>
        <source>%1, in the midline</source>
        <translation>%1, in der Mittellinie</translation>
    </message>
    <message>
        <source>%1, left of the midline</source>
        <translation>%1, links der Mittellinie</translation>
    </message>
    <message>
        <source>%1, right of the midline</source>
        <translation>%1, rechts der Mittellinie</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>von unten</translation>
    </message>
    <message>
        <source>from behind</source>
        <translation>von hinten</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from the left</source>
        <translation>von links</translation>
    </message>
    <message>
        <source>from the right</source>
        <translation>von rechts</translation>
    </message>
    <message>
        <source>%1 on the left</source>
        <translation>%1 links</translation>
    </message>
    <message>
        <source>%1 on the right</source>
        <translation>%1 rechts</translation>
    </message>
    <message>
        <source>Nothing is proposed here: %1.</source>
        <translation>Hier wird nichts vorgeschlagen: %1.</translation>
    </message>
    <message>
        <source>opening the device</source>
        <translation>das Gerät wird geöffnet</translation>
    </message>
    <message>
        <source>checking: move the device to every corner, press its buttons</source>
        <translation>Prüfung: bewegen Sie das Gerät in alle Ecken, drücken Sie seine Knöpfe</translation>
    </message>
    <message>
        <source>Ready: %1 rounds a second, %2 of %3 too late, moved within %4.</source>
        <translation>Bereit: %1 Runden je Sekunde, %2 von %3 zu spät, bewegt innerhalb von %4.</translation>
    </message>
    <message>
        <source>no space at all</source>
        <translation>gar keinem Raum</translation>
    </message>
    <message>
        <source>Not ready: %1.</source>
        <translation>Nicht bereit: %1.</translation>
    </message>
    <message>
        <source>Calibrated, and kept in %1.</source>
        <translation>Kalibriert und in %1 behalten.</translation>
    </message>
    <message>
        <source>The device did not let itself be stopped; switch it off and on again.</source>
        <translation>Das Gerät ließ sich nicht anhalten; schalten Sie es aus und wieder ein.</translation>
    </message>
    <message>
        <source>%1, serial number %2, calibrated %3</source>
        <translation>%1, Seriennummer %2, kalibriert %3</translation>
    </message>
    <message>
        <source>%1, calibrated %2</source>
        <translation>%1, kalibriert %2</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>Arbeitsraum %1</translation>
    </message>
    <message>
        <source>stands turned by %1 degrees</source>
        <translation>steht um %1 Grad gedreht</translation>
    </message>
    <message>
        <source>tip %1 mm from the device's point, within %2 mm</source>
        <translation>Spitze %1 mm vom Punkt des Geräts, auf %2 mm genau</translation>
    </message>
    <message>
        <source>needle's axis %1 of the tool's</source>
        <translation>Achse der Nadel %1 im Werkzeug</translation>
    </message>
    <message>
        <source>weight %1 N, friction %2 N</source>
        <translation>Gewicht %1 N, Reibung %2 N</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht angeschlossen</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>No device answers to %1: switch it on, plug it in, and look again.</source>
        <translation>Auf %1 antwortet kein Gerät: schalten Sie es ein, stecken Sie es an und suchen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Mouse of this window</source>
        <translation>Maus dieses Fensters</translation>
    </message>
    <message>
        <source>Other devices</source>
        <translation>Andere Geräte</translation>
    </message>
    <message>
        <source>This patient has no CT, so there is nothing to find structures in.</source>
        <translation>Dieser Patient hat kein CT, in dem Strukturen zu finden wären.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed.</source>
        <translation>Abgebrochen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>There is a structure '%1' already; choose another name.</source>
        <translation>Es gibt schon eine Struktur „%1“; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>looking at the voxels</source>
        <translation>die Voxel werden betrachtet</translation>
    </message>
    <message>
        <source>saving</source>
        <translation>wird gespeichert</translation>
    </message>
    <message>
        <source>Synthetic torso</source>
        <translation>Künstlicher Rumpf</translation>
    </message>
    <message>
        <source>This patient has no planned path to try the needle on.</source>
        <translation>Dieser Patient hat keinen geplanten Weg, an dem die Nadel zu erproben wäre.</translation>
    </message>
    <message>
        <source>How heavy is the stylus, of which the hand shall feel nothing?</source>
        <translation>Wie schwer ist der Griff, von dem die Hand nichts spüren soll?</translation>
    </message>
    <message>
        <source>How stiff is the skin before it gives way?</source>
        <translation>Wie steif ist die Haut, bevor sie nachgibt?</translation>
    </message>
    <message>
        <source>How hard must one push before the skin gives way?</source>
        <translation>Wie stark muss man drücken, bis die Haut nachgibt?</translation>
    </message>
    <message>
        <source>How firmly does the skin grip the shaft?</source>
        <translation>Wie fest hält die Haut den Schaft?</translation>
    </message>
    <message>
        <source>How viscous is the fat?</source>
        <translation>Wie zäh ist das Fett?</translation>
    </message>
    <message>
        <source>How stiff is the muscle before it gives way?</source>
        <translation>Wie steif ist der Muskel, bevor er nachgibt?</translation>
    </message>
    <message>
        <source>How firmly does the muscle grip a needle at rest?</source>
        <translation>Wie fest hält der Muskel eine ruhende Nadel?</translation>
    </message>
    <message>
        <source>How much does the muscle resist a needle that slides?</source>
        <translation>Wie sehr widersteht der Muskel einer gleitenden Nadel?</translation>
    </message>
    <message>
        <source>How rough does the needle feel as it slides?</source>
        <translation>Wie rau fühlt sich die gleitende Nadel an?</translation>
    </message>
    <message>
        <source>How hard is bone?</source>
        <translation>Wie hart ist Knochen?</translation>
    </message>
    <message>
        <source>How firmly does the body hold the needle on its path?</source>
        <translation>Wie fest hält der Körper die Nadel auf ihrem Weg?</translation>
    </message>
    <message>
        <source>no force: %1</source>
        <translation>keine Kraft: %1</translation>
    </message>
    <message>
        <source>the force has been brought in</source>
        <translation>die Kraft ist da</translation>
    </message>
    <message>
        <source>could not be armed</source>
        <translation>konnte nicht freigegeben werden</translation>
    </message>
    <message>
        <source>the dead-man's switch was released</source>
        <translation>der Totmannschalter wurde losgelassen</translation>
    </message>
    <message>
        <source>there was no tick for too long</source>
        <translation>zu lange kam kein Takt</translation>
    </message>
    <message>
        <source>the simulation is late</source>
        <translation>die Simulation ist zu spät</translation>
    </message>
    <message>
        <source>the simulation is back</source>
        <translation>die Simulation ist zurück</translation>
    </message>
    <message>
        <source>a force was asked for that is no number</source>
        <translation>verlangt wurde eine Kraft, die keine Zahl ist</translation>
    </message>
    <message>
        <source>the simulation has stopped answering</source>
        <translation>die Simulation antwortet nicht mehr</translation>
    </message>
    <message>
        <source>the simulation failed</source>
        <translation>die Simulation ist gescheitert</translation>
    </message>
    <message>
        <source>the device reports a fault</source>
        <translation>das Gerät meldet eine Störung</translation>
    </message>
    <message>
        <source>the device reports a pose that is no number</source>
        <translation>das Gerät meldet eine Lage, die keine Zahl ist</translation>
    </message>
    <message>
        <source>the device's position jumped</source>
        <translation>die Lage des Geräts sprang</translation>
    </message>
    <message>
        <source>the hand moves too fast</source>
        <translation>die Hand bewegt sich zu schnell</translation>
    </message>
    <message>
        <source>the device's readings stand still under force</source>
        <translation>die Messwerte des Geräts stehen unter Kraft still</translation>
    </message>
    <message>
        <source>the hand shakes again</source>
        <translation>die Hand schwingt wieder</translation>
    </message>
    <message>
        <source>an axis gave more energy than it took</source>
        <translation>eine Achse gab mehr Energie ab, als sie nahm</translation>
    </message>
    <message>
        <source>the force rose too fast</source>
        <translation>die Kraft stieg zu schnell</translation>
    </message>
    <message>
        <source>the force is more than the device's peak</source>
        <translation>die Kraft übersteigt die Spitze des Geräts</translation>
    </message>
    <message>
        <source>the torque is more than the device's peak</source>
        <translation>das Drehmoment übersteigt die Spitze des Geräts</translation>
    </message>
    <message>
        <source>the motors have had their mean load</source>
        <translation>die Motoren hatten ihre mittlere Last</translation>
    </message>
    <message>
        <source>the motors are hot</source>
        <translation>die Motoren sind heiß</translation>
    </message>
    <message>
        <source>the hand is outside the workspace</source>
        <translation>die Hand ist außerhalb des Arbeitsraums</translation>
    </message>
    <message>
        <source>the hand shakes, the force is halved</source>
        <translation>die Hand schwingt, die Kraft ist halbiert</translation>
    </message>
    <message>
        <source>the hand goes on shaking, a quarter of the force is left and the hand is damped</source>
        <translation>die Hand schwingt weiter, ein Viertel der Kraft bleibt und die Hand wird gedämpft</translation>
    </message>
    <message>
        <source>the simulation is late, the force fades</source>
        <translation>die Simulation ist zu spät, die Kraft klingt ab</translation>
    </message>
    <message>
        <source>the hand is not at rest</source>
        <translation>die Hand ist nicht in Ruhe</translation>
    </message>
    <message>
        <source>a force is waiting</source>
        <translation>eine Kraft wartet</translation>
    </message>
    <message>
        <source>not installed</source>
        <translation>nicht installiert</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>keine Erlaubnis</translation>
    </message>
    <message>
        <source>wrong version</source>
        <translation>falsche Version</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>velocity limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>Not-Aus</translation>
    </message>
    <message>
        <source>overheated</source>
        <translation>überhitzt</translation>
    </message>
    <message>
        <source>bad data</source>
        <translation>fehlerhafte Daten</translation>
    </message>
    <message>
        <source>vendor error</source>
        <translation>Fehler des Herstellers</translation>
    </message>
    <message>
        <source>Workspace: move the handle to every corner that you want to use, near and far, left and right, up and down.</source>
        <translation>Arbeitsraum: bewegen Sie den Griff in jede Ecke, die Sie benutzen möchten, nah und fern, links und rechts, oben und unten.</translation>
    </message>
    <message>
        <source>Mounting: hold the handle near you. Then push it straight away from you, 5 cm or more, and leave it there.</source>
        <translation>Aufstellung: halten Sie den Griff nah bei sich. Schieben Sie ihn dann gerade von sich weg, 5 cm oder mehr, und lassen Sie ihn dort.</translation>
    </message>
    <message>
        <source>Axis: hold the tool so that it points straight down, and keep it still.</source>
        <translation>Achse: halten Sie das Werkzeug so, dass es gerade nach unten zeigt, und halten Sie es still.</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>das Netz wird gelesen</translation>
    </message>
    <message>
        <source>resampling</source>
        <translation>Umrechnung auf neue Schichten</translation>
    </message>
    <message>
        <source>reading the labels</source>
        <translation>die Strukturen werden gelesen</translation>
    </message>
    <message>
        <source>reading the CT</source>
        <translation>das CT wird gelesen</translation>
    </message>
    <message>
        <source>looking for slices</source>
        <translation>Schichten werden gesucht</translation>
    </message>
    <message>
        <source>anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>tissues</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Hounsfield units</source>
        <translation>Hounsfield-Werte</translation>
    </message>
    <message>
        <source>Lumbar torso. Fluid from the sac below the cord.</source>
        <translation>Lendenbereich. Liquor aus dem Sack unterhalb des Rückenmarks.</translation>
    </message>
    <message>
        <source>Lumbar torso. Stop behind the flavum, before the dura.</source>
        <translation>Lendenbereich. Halt hinter dem Flavum, vor der Dura.</translation>
    </message>
    <message>
        <source>Lumbar torso. A thin needle, 25G, into the fluid.</source>
        <translation>Lendenbereich. Eine dünne Nadel, 25G, in den Liquor.</translation>
    </message>
    <message>
        <source>Lumbar torso. A lesion of 20 mm beside the psoas.</source>
        <translation>Lendenbereich. Ein Herd von 20 mm neben dem Psoas.</translation>
    </message>
    <message>
        <source>Shoulder. From behind, into the space of the joint.</source>
        <translation>Schulter. Von hinten in den Spalt des Gelenks.</translation>
    </message>
    <message>
        <source>Shoulder. The tip in the picture all the way.</source>
        <translation>Schulter. Die Spitze bleibt stets im Bild.</translation>
    </message>
    <message>
        <source>Leg. Needle ST36; lift, thrust and twirl.</source>
        <translation>Bein. ST36 nadeln; heben, senken und drehen.</translation>
    </message>
    <message>
        <source>Nine layers of a half ball, no anatomy.</source>
        <translation>Neun Schichten einer Halbkugel, ohne Anatomie.</translation>
    </message>
    <message>
        <source>writing the case</source>
        <translation>der Fall wird geschrieben</translation>
    </message>
    <message>
        <source>Telling tissues apart</source>
        <translation>Gewebe werden unterschieden</translation>
    </message>
    <message>
        <source>looking at the planned path</source>
        <translation>der geplante Weg wird betrachtet</translation>
    </message>
    <message>
        <source>replaying</source>
        <translation>die Sitzung wird nachgerechnet</translation>
    </message>
    <message>
        <source>drawing surfaces</source>
        <translation>Oberflächen werden gezeichnet</translation>
    </message>
    <message>
        <source>Put the pointer into the picture to mark a place.</source>
        <translation>Bringen Sie den Zeiger ins Bild, um eine Stelle zu markieren.</translation>
    </message>
    <message>
        <source>The case has no planned path for a needle.</source>
        <translation>Der Fall hat keinen geplanten Weg für eine Nadel.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The plan is finished</source>
        <translation>Der Plan ist abgeschlossen</translation>
    </message>
    <message>
        <source>Stage %1 of %2: %3.</source>
        <translation>Stufe %1 von %2: %3.</translation>
    </message>
    <message>
        <source>%1 of %2 passed in a row</source>
        <translation>%1 von %2 nacheinander bestanden</translation>
    </message>
    <message>
        <source>%1 of %2 passed in a row, attempt %3 of %4</source>
        <translation>%1 von %2 nacheinander bestanden, Versuch %3 von %4</translation>
    </message>
    <message>
        <source>attempt %1, mastery not shown yet</source>
        <translation>Versuch %1, Können noch nicht gezeigt</translation>
    </message>
    <message>
        <source>attempt %1 of %2</source>
        <translation>Versuch %1 von %2</translation>
    </message>
    <message>
        <source>Lumbar puncture, first steps</source>
        <translation>Lumbalpunktion, erste Schritte</translation>
    </message>
    <message>
        <source>Everything shown</source>
        <translation>Alles wird gezeigt</translation>
    </message>
    <message>
        <source>Without the planned path</source>
        <translation>Ohne den geplanten Weg</translation>
    </message>
    <message>
        <source>By feel and by the skin</source>
        <translation>Nach Gefühl und an der Haut</translation>
    </message>
    <message>
        <source>Lumbar puncture to mastery</source>
        <translation>Lumbalpunktion bis zum Können</translation>
    </message>
    <message>
        <source>With ultrasound</source>
        <translation>Mit Ultraschall</translation>
    </message>
    <message>
        <source>Without help, until mastery</source>
        <translation>Ohne Hilfe, bis zum Können</translation>
    </message>
    <message>
        <source>There was no loss of resistance: the needle may lie in the epidural space, but neither hand nor syringe told you so.</source>
        <translation>Es gab keinen Widerstandsverlust: die Nadel liegt vielleicht im Epiduralraum, aber weder Hand noch Spritze haben es Ihnen gesagt.</translation>
    </message>
    <message>
        <source>Hold the needle between both hands that rest on the back: the ligament gives way suddenly.</source>
        <translation>Halten Sie die Nadel mit beiden Händen, die am Rücken aufliegen: das Band gibt plötzlich nach.</translation>
    </message>
    <message>
        <source>Ultrasound-guided nerve block</source>
        <translation>Ultraschallgeführte Nervenblockade</translation>
    </message>
    <message>
        <source>A local anaesthetic is injected beside a nerve, with the needle's tip in the ultrasound slice all the way.</source>
        <translation>Ein Lokalanästhetikum wird neben einen Nerv gespritzt, die Nadelspitze auf dem ganzen Weg in der Ultraschallebene.</translation>
    </message>
    <message>
        <source>Show the nerve</source>
        <translation>Den Nerv zeigen</translation>
    </message>
    <message>
        <source>Turn the probe until the nerve and the way to it lie in one slice.</source>
        <translation>Drehen Sie den Schallkopf, bis der Nerv und der Weg zu ihm in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>Advance beside the nerve</source>
        <translation>Neben dem Nerv vorschieben</translation>
    </message>
    <message>
        <source>Aim at the side of the nerve, not at its middle. Advance only while you see the tip.</source>
        <translation>Zielen Sie auf die Seite des Nervs, nicht auf seine Mitte. Schieben Sie nur vor, solange Sie die Spitze sehen.</translation>
    </message>
    <message>
        <source>Rest beside the nerve</source>
        <translation>Neben dem Nerv ruhen</translation>
    </message>
    <message>
        <source>Look for blood in the syringe, then inject slowly. Stop at once if it hurts or resists: the tip is in the nerve.</source>
        <translation>Achten Sie auf Blut in der Spritze, dann spritzen Sie langsam. Hören Sie sofort auf, wenn es schmerzt oder Widerstand leistet: die Spitze ist im Nerv.</translation>
    </message>
    <message>
        <source>bleeding, or convulsions when the drug enters the circulation</source>
        <translation>Blutung, oder Krämpfe, wenn das Mittel in den Kreislauf gelangt</translation>
    </message>
    <message>
        <source>Stop as soon as the tip shows beside the nerve.</source>
        <translation>Halten Sie an, sobald die Spitze neben dem Nerv erscheint.</translation>
    </message>
    <message>
        <source>Shoulder. Beside the nerve, never into it.</source>
        <translation>Schulter. Neben den Nerv, nie hinein.</translation>
    </message>
    <message>
        <source>distance from the planned path, mean</source>
        <translation>Abstand vom geplanten Weg, Mittel</translation>
    </message>
    <message>
        <source>Fréchet distance of the way from the planned path</source>
        <translation>Fréchet-Abstand des Wegs vom geplanten</translation>
    </message>
    <message>
        <source>mean distance of the way from the planned path, best aligned</source>
        <translation>mittlerer Abstand des Wegs vom geplanten, bestmöglich ausgerichtet</translation>
    </message>
    <message>
        <source>time to the target</source>
        <translation>Zeit bis zum Ziel</translation>
    </message>
    <message>
        <source>time of the closest approach to the target</source>
        <translation>Zeitpunkt der größten Annäherung an das Ziel</translation>
    </message>
    <message>
        <source>spread of the tip in the body</source>
        <translation>Streuung der Spitze im Körper</translation>
    </message>
    <message>
        <source>volume that the tip moved in</source>
        <translation>Raum, in dem sich die Spitze bewegte</translation>
    </message>
    <message>
        <source>quick movements of the tip</source>
        <translation>schnelle Bewegungen der Spitze</translation>
    </message>
    <message>
        <source>quick turns of the needle</source>
        <translation>schnelle Drehungen der Nadel</translation>
    </message>
    <message>
        <source>turning about the shaft in the body</source>
        <translation>Drehung um die Nadelachse im Körper</translation>
    </message>
    <message>
        <source>travel along the shaft over the greatest depth</source>
        <translation>Weg entlang der Nadel im Verhältnis zur größten Tiefe</translation>
    </message>
    <message>
        <source>how the two hands move together</source>
        <translation>wie sich beide Hände gemeinsam bewegen</translation>
    </message>
    <message>
        <source>unevenness of lifting and thrusting</source>
        <translation>Ungleichmäßigkeit von Heben und Senken</translation>
    </message>
    <message>
        <source>depth of the thrusts beyond the target</source>
        <translation>Tiefe der Stöße über das Ziel hinaus</translation>
    </message>
    <message>
        <source>distance of the moving tip from the ultrasound slice, mean</source>
        <translation>Abstand der bewegten Spitze von der Ultraschallebene, Mittel</translation>
    </message>
    <message>
        <source>distance of the moving tip from the ultrasound slice, greatest</source>
        <translation>Abstand der bewegten Spitze von der Ultraschallebene, größter</translation>
    </message>
    <message>
        <source>structures of the procedure that the ultrasound showed</source>
        <translation>Strukturen des Eingriffs, die der Ultraschall zeigte</translation>
    </message>
    <message>
        <source>time with the target in the ultrasound slice</source>
        <translation>Zeit mit dem Ziel in der Ultraschallebene</translation>
    </message>
    <message>
        <source>greatest angle between needle and ultrasound slice</source>
        <translation>größter Winkel zwischen Nadel und Ultraschallebene</translation>
    </message>
    <message>
        <source>angle between moving needle and ultrasound slice</source>
        <translation>Winkel zwischen bewegter Nadel und Ultraschallebene</translation>
    </message>
    <message>
        <source>angle between needle and the way to the target in the ultrasound picture</source>
        <translation>Winkel zwischen Nadel und Weg zum Ziel im Ultraschallbild</translation>
    </message>
    <message>
        <source>Ultrasound-guided injection</source>
        <translation>Ultraschallgeführte Injektion</translation>
    </message>
    <message>
        <source>A drug is injected into the space of a joint, or beside a nerve, with the needle's tip in the ultrasound slice all the way.</source>
        <translation>Ein Medikament wird in den Gelenkspalt oder neben einen Nerv gespritzt, die Nadelspitze auf dem ganzen Weg in der Ultraschallebene.</translation>
    </message>
    <message>
        <source>Show the target</source>
        <translation>Ziel zeigen</translation>
    </message>
    <message>
        <source>Turn the probe until the target and the way to it lie in one slice.</source>
        <translation>Drehen Sie den Schallkopf, bis das Ziel und der Weg dorthin in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>Beside the probe, in line with its slice.</source>
        <translation>Neben dem Schallkopf, in der Richtung seiner Ebene.</translation>
    </message>
    <message>
        <source>Advance in the slice</source>
        <translation>In der Ebene vorschieben</translation>
    </message>
    <message>
        <source>Slowly, and only while you see the tip. If it is lost, stop the needle and move the probe.</source>
        <translation>Langsam, und nur solange Sie die Spitze sehen. Ist sie verloren, halten Sie die Nadel an und bewegen Sie den Schallkopf.</translation>
    </message>
    <message>
        <source>Rest at the target</source>
        <translation>Am Ziel ruhen</translation>
    </message>
    <message>
        <source>See the tip there before you inject. The drug must flow without pressure.</source>
        <translation>Sehen Sie die Spitze dort, bevor Sie spritzen. Das Medikament muss ohne Druck fließen.</translation>
    </message>
    <message>
        <source>Move the probe, not the needle, until you see the tip again.</source>
        <translation>Bewegen Sie den Schallkopf, nicht die Nadel, bis Sie die Spitze wieder sehen.</translation>
    </message>
    <message>
        <source>There was no probe: nobody saw where the tip was.</source>
        <translation>Es gab keinen Schallkopf: niemand sah, wo die Spitze war.</translation>
    </message>
    <message>
        <source>Enter in line with the slice, so that the whole needle shows.</source>
        <translation>Stechen Sie in der Richtung der Ebene ein, damit die ganze Nadel zu sehen ist.</translation>
    </message>
    <message>
        <source>Stop as soon as the tip shows at the target.</source>
        <translation>Halten Sie an, sobald die Spitze am Ziel zu sehen ist.</translation>
    </message>
    <message>
        <source>Bone is the brightest line in the picture: keep the tip above it.</source>
        <translation>Knochen ist die hellste Linie im Bild: halten Sie die Spitze darüber.</translation>
    </message>
    <message>
        <source>speed before the loss of resistance</source>
        <translation>Geschwindigkeit vor dem Widerstandsverlust</translation>
    </message>
    <message>
        <source>joint capsule</source>
        <translation>Gelenkkapsel</translation>
    </message>
    <message>
        <source>tendon of the rotator cuff</source>
        <translation>Sehne der Rotatorenmanschette</translation>
    </message>
    <message>
        <source>joint space</source>
        <translation>Gelenkspalt</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>break force</source>
        <translation>Durchstichkraft</translation>
    </message>
    <message>
        <source>static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>dynamic friction</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>Zähigkeit</translation>
    </message>
    <message>
        <source>roughness</source>
        <translation>Rauigkeit</translation>
    </message>
    <message>
        <source>contact stiffness</source>
        <translation>Kontaktsteifigkeit</translation>
    </message>
    <message>
        <source>puncture force</source>
        <translation>Durchstichkraft</translation>
    </message>
    <message>
        <source>softening</source>
        <translation>Erweichung</translation>
    </message>
    <message>
        <source>a hand of mass and spring that goes in and comes out again</source>
        <translation>eine Hand aus Masse und Feder, die hineingeht und wieder herauskommt</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>die Kraft ist nicht freigegeben</translation>
    </message>
    <message>
        <source>D, while it slides</source>
        <translation>D, während sie gleitet</translation>
    </message>
    <message>
        <source>D_v: slower than half of it is at rest</source>
        <translation>D_v: langsamer als die Hälfte davon gilt als Ruhe</translation>
    </message>
    <message>
        <source>E, of stainless steel AISI 304</source>
        <translation>E, von Edelstahl AISI 304</translation>
    </message>
    <message>
        <source>F_c, while the shaft slides</source>
        <translation>F_c, während der Schaft gleitet</translation>
    </message>
    <message>
        <source>F_s, at rest; equal to F_c: Dahl, more: LuGre</source>
        <translation>F_s, in Ruhe; gleich F_c: Dahl, größer: LuGre</translation>
    </message>
    <message>
        <source>H, at which the tissue gives way</source>
        <translation>H, bei der das Gewebe nachgibt</translation>
    </message>
    <message>
        <source>J, of the membrane</source>
        <translation>J, der Membran</translation>
    </message>
    <message>
        <source>J, of the tissue behind the membrane</source>
        <translation>J, des Gewebes hinter der Membran</translation>
    </message>
    <message>
        <source>K; the paper's tuned K_t</source>
        <translation>K; das abgestimmte K_t der Arbeit</translation>
    </message>
    <message>
        <source>K_b; the device's limit bounds it</source>
        <translation>K_b; begrenzt durch die Grenze des Geräts</translation>
    </message>
    <message>
        <source>K_t, spring of the wall</source>
        <translation>K_t, Feder der Wand</translation>
    </message>
    <message>
        <source>L, by which a fast needle lowers it; 0: speed has no effect</source>
        <translation>L, um das eine schnelle Nadel sie senkt; 0: Geschwindigkeit wirkt nicht</translation>
    </message>
    <message>
        <source>R_d, of the variant drag</source>
        <translation>R_d, der Variante drag</translation>
    </message>
    <message>
        <source>R_v, of the variant viscous</source>
        <translation>R_v, der Variante viscous</translation>
    </message>
    <message>
        <source>S, at which the shaft slides</source>
        <translation>S, bei der der Schaft gleitet</translation>
    </message>
    <message>
        <source>T_N, to go up the gradient</source>
        <translation>T_N, um den Gradienten hinaufzugehen</translation>
    </message>
    <message>
        <source>T_T, to slide across the gradient</source>
        <translation>T_T, um quer zum Gradienten zu gleiten</translation>
    </message>
    <message>
        <source>V_label: the harder a tissue feels, the higher</source>
        <translation>V_label: je härter sich ein Gewebe anfühlt, desto höher</translation>
    </message>
    <message>
        <source>X_d, at which the skin gives way</source>
        <translation>X_d, bei der die Haut nachgibt</translation>
    </message>
    <message>
        <source>X_d2, length of the trailing spring; at most puncture_depth_mm</source>
        <translation>X_d2, Länge der nachgezogenen Feder; höchstens puncture_depth_mm</translation>
    </message>
    <message>
        <source>a1, of the capsule</source>
        <translation>a1, der Kapsel</translation>
    </message>
    <message>
        <source>a2, of the capsule; not both zero</source>
        <translation>a2, der Kapsel; nicht beide null</translation>
    </message>
    <message>
        <source>about the planned path</source>
        <translation>um den geplanten Weg</translation>
    </message>
    <message>
        <source>above it no more is added; at least 1 HU above the lowest</source>
        <translation>darüber kommt nichts mehr hinzu; mindestens 1 HU über dem untersten</translation>
    </message>
    <message>
        <source>along the planned path behind the entry: deeper nodes do not move</source>
        <translation>entlang des geplanten Wegs hinter dem Eintritt: tiefere Knoten bewegen sich nicht</translation>
    </message>
    <message>
        <source>at most, those nearest to the path</source>
        <translation>höchstens, die dem Weg nächsten</translation>
    </message>
    <message>
        <source>at rest after which mu_s holds again</source>
        <translation>in Ruhe, nach der wieder mu_s gilt</translation>
    </message>
    <message>
        <source>at which the capsule gives way</source>
        <translation>bei der die Kapsel nachgibt</translation>
    </message>
    <message>
        <source>b, against sliding</source>
        <translation>b, gegen das Gleiten</translation>
    </message>
    <message>
        <source>below it the CT adds nothing</source>
        <translation>darunter trägt das CT nichts bei</translation>
    </message>
    <message>
        <source>between points of one tissue</source>
        <translation>zwischen Punkten eines Gewebes</translation>
    </message>
    <message>
        <source>between the places where the tissue beside the shaft is looked up</source>
        <translation>zwischen den Stellen, an denen das Gewebe neben dem Schaft nachgesehen wird</translation>
    </message>
    <message>
        <source>between tissue samples along the path</source>
        <translation>zwischen Gewebeproben entlang des Wegs</translation>
    </message>
    <message>
        <source>bone stiffness</source>
        <translation>Steifigkeit des Knochens</translation>
    </message>
    <message>
        <source>break force rate</source>
        <translation>Abnahme der Durchstichkraft</translation>
    </message>
    <message>
        <source>by which friction grows before the shaft slides</source>
        <translation>um den die Reibung wächst, bevor der Schaft gleitet</translation>
    </message>
    <message>
        <source>capture radius</source>
        <translation>Fangradius</translation>
    </message>
    <message>
        <source>catch up</source>
        <translation>Aufholen</translation>
    </message>
    <message>
        <source>centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>centre z</source>
        <translation>Mitte z</translation>
    </message>
    <message>
        <source>change of the weight with position; 0: a constant force</source>
        <translation>Änderung des Gewichts mit der Lage; 0: eine gleichbleibende Kraft</translation>
    </message>
    <message>
        <source>channel radius</source>
        <translation>Radius des Kanals</translation>
    </message>
    <message>
        <source>channel tilt</source>
        <translation>Neigung des Kanals</translation>
    </message>
    <message>
        <source>constant after the puncture; at most puncture_force_N</source>
        <translation>gleichbleibend nach dem Durchstich; höchstens puncture_force_N</translation>
    </message>
    <message>
        <source>corridor beyond</source>
        <translation>Korridor hinter dem Ziel</translation>
    </message>
    <message>
        <source>corridor nodes</source>
        <translation>Knoten des Korridors</translation>
    </message>
    <message>
        <source>corridor radius</source>
        <translation>Radius des Korridors</translation>
    </message>
    <message>
        <source>coulomb</source>
        <translation>Coulomb-Reibung</translation>
    </message>
    <message>
        <source>cut offset</source>
        <translation>Versatz des Schnitts</translation>
    </message>
    <message>
        <source>cutting force</source>
        <translation>Schneidkraft</translation>
    </message>
    <message>
        <source>cutting stiffness</source>
        <translation>Schneidsteifigkeit</translation>
    </message>
    <message>
        <source>cutting toughness</source>
        <translation>Schneidzähigkeit</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>dead band</source>
        <translation>Totbereich</translation>
    </message>
    <message>
        <source>delta, variation of the friction</source>
        <translation>delta, Schwankung der Reibung</translation>
    </message>
    <message>
        <source>depth_ref, where the torque is fully grown</source>
        <translation>depth_ref, wo das Drehmoment voll ausgebildet ist</translation>
    </message>
    <message>
        <source>direction against gravity, of any length</source>
        <translation>Richtung gegen die Schwerkraft, beliebig lang</translation>
    </message>
    <message>
        <source>directions closer than this share a channel</source>
        <translation>Richtungen, die näher beisammen liegen, teilen einen Kanal</translation>
    </message>
    <message>
        <source>directions closer than this share a puncture</source>
        <translation>Richtungen, die näher beisammen liegen, teilen einen Durchstich</translation>
    </message>
    <message>
        <source>distance from its axis at which a bevel cuts, towards its point; 0: it cuts straight</source>
        <translation>Abstand von der Achse, in dem ein Schliff schneidet, zu seiner Spitze hin; 0: er schneidet gerade</translation>
    </message>
    <message>
        <source>dk/dd, change of k with depth; k stays within 0 and 10 N/mm</source>
        <translation>dk/dd, Änderung von k mit der Tiefe; k bleibt zwischen 0 und 10 N/mm</translation>
    </message>
    <message>
        <source>dx, between elements</source>
        <translation>dx, zwischen Elementen</translation>
    </message>
    <message>
        <source>dx, of the cubic law</source>
        <translation>dx, des kubischen Gesetzes</translation>
    </message>
    <message>
        <source>dx_s, between places of grip</source>
        <translation>dx_s, zwischen Haftstellen</translation>
    </message>
    <message>
        <source>element spacing</source>
        <translation>Abstand der Elemente</translation>
    </message>
    <message>
        <source>entries closer than this share a channel</source>
        <translation>Einstiche, die näher beisammen liegen, teilen einen Kanal</translation>
    </message>
    <message>
        <source>entries closer than this share a puncture</source>
        <translation>Einstiche, die näher beisammen liegen, teilen einen Durchstich</translation>
    </message>
    <message>
        <source>f_R, at which the wall begins to follow</source>
        <translation>f_R, bei der die Wand zu folgen beginnt</translation>
    </message>
    <message>
        <source>factor on Young's modulus of every tissue</source>
        <translation>Faktor auf den Elastizitätsmodul jedes Gewebes</translation>
    </message>
    <message>
        <source>fastest rise of k</source>
        <translation>schnellster Anstieg von k</translation>
    </message>
    <message>
        <source>field ct range</source>
        <translation>Feld: Anteil des CT</translation>
    </message>
    <message>
        <source>field highest</source>
        <translation>Feld: oberster HU-Wert</translation>
    </message>
    <message>
        <source>field lowest</source>
        <translation>Feld: unterster HU-Wert</translation>
    </message>
    <message>
        <source>field smoothing</source>
        <translation>Feld: Glättung</translation>
    </message>
    <message>
        <source>field value</source>
        <translation>Feldwert</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>fix beyond</source>
        <translation>fest jenseits von</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>from a stop to no force; INF: the wall holds where it is</source>
        <translation>vom Halt bis zu keiner Kraft; INF: die Wand bleibt, wo sie ist</translation>
    </message>
    <message>
        <source>full depth</source>
        <translation>volle Tiefe</translation>
    </message>
    <message>
        <source>g_min: flatter is homogeneous; at most gradient_reference_per_mm</source>
        <translation>g_min: flacher gilt als homogen; höchstens gradient_reference_per_mm</translation>
    </message>
    <message>
        <source>g_ref, from which on T_N is complete</source>
        <translation>g_ref, von dem an T_N vollständig ist</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>gradient least per mm</source>
        <translation>kleinster Gradient je mm</translation>
    </message>
    <message>
        <source>gradient reference per mm</source>
        <translation>Bezugsgradient je mm</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>in which a punctured node goes back to its place</source>
        <translation>in der ein durchstochener Knoten an seinen Platz zurückgeht</translation>
    </message>
    <message>
        <source>in which the force of a puncture goes</source>
        <translation>in der die Kraft eines Durchstichs schwindet</translation>
    </message>
    <message>
        <source>k at the skin</source>
        <translation>k an der Haut</translation>
    </message>
    <message>
        <source>k, across the line</source>
        <translation>k, quer zur Linie</translation>
    </message>
    <message>
        <source>k, from the tip to the proxy</source>
        <translation>k, von der Spitze zum Proxy</translation>
    </message>
    <message>
        <source>k, of one element</source>
        <translation>k, eines Elements</translation>
    </message>
    <message>
        <source>k, of the cubic law before rupture</source>
        <translation>k, des kubischen Gesetzes vor dem Riss</translation>
    </message>
    <message>
        <source>k, of the skin</source>
        <translation>k, der Haut</translation>
    </message>
    <message>
        <source>k_bone; the device's limit at most</source>
        <translation>k_bone; höchstens die Grenze des Geräts</translation>
    </message>
    <message>
        <source>k_s, of the grip on 1 mm of shaft</source>
        <translation>k_s, der Haftung auf 1 mm Schaft</translation>
    </message>
    <message>
        <source>k_skin</source>
        <translation>k_Haut</translation>
    </message>
    <message>
        <source>kappa_0, at full depth</source>
        <translation>kappa_0, in voller Tiefe</translation>
    </message>
    <message>
        <source>l_2 is never taken smaller</source>
        <translation>l_2 wird nie kleiner angenommen</translation>
    </message>
    <message>
        <source>largest angle</source>
        <translation>größter Winkel</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>largest force across the line</source>
        <translation>größte Kraft quer zur Linie</translation>
    </message>
    <message>
        <source>largest force; as Kwon et al. 2001 use for the same role</source>
        <translation>größte Kraft; wie bei Kwon et al. 2001 in derselben Rolle</translation>
    </message>
    <message>
        <source>largest force; the peak of a Phantom Premium 1.5</source>
        <translation>größte Kraft; die Spitzenkraft eines Phantom Premium 1.5</translation>
    </message>
    <message>
        <source>largest force; the peak of the Phantom Premium 1.5</source>
        <translation>größte Kraft; die Spitzenkraft des Phantom Premium 1.5</translation>
    </message>
    <message>
        <source>largest stiffness</source>
        <translation>größte Steifigkeit</translation>
    </message>
    <message>
        <source>largest torque; continuous yaw and pitch torque of the Phantom Premium 1.5</source>
        <translation>größtes Drehmoment; Dauerdrehmoment um Hoch- und Querachse des Phantom Premium 1.5</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>length of the corridor behind the target</source>
        <translation>Länge des Korridors hinter dem Ziel</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linearer Anteil</translation>
    </message>
    <message>
        <source>longest</source>
        <translation>Höchstdauer</translation>
    </message>
    <message>
        <source>low pass on k</source>
        <translation>Tiefpass auf k</translation>
    </message>
    <message>
        <source>low pass on the length outside</source>
        <translation>Tiefpass auf die Länge außerhalb</translation>
    </message>
    <message>
        <source>m_eff g, at the centre</source>
        <translation>m_eff g, in der Mitte</translation>
    </message>
    <message>
        <source>modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>mu_s; at least mu_d</source>
        <translation>mu_s; mindestens mu_d</translation>
    </message>
    <message>
        <source>of mesh nodes, of earlier versions; changes nothing</source>
        <translation>von Netzknoten, aus früheren Versionen; ändert nichts</translation>
    </message>
    <message>
        <source>of shaft in tissue</source>
        <translation>des Schafts im Gewebe</translation>
    </message>
    <message>
        <source>of the device</source>
        <translation>des Geräts</translation>
    </message>
    <message>
        <source>of the disk over which the tip pushes</source>
        <translation>der Scheibe, über die die Spitze drückt</translation>
    </message>
    <message>
        <source>of the line past a point, at most, within which it takes full hold of the shaft</source>
        <translation>der Linie an einem Punkt vorbei, höchstens, in dem er den Schaft ganz ergreift</translation>
    </message>
    <message>
        <source>of the onset of cutting</source>
        <translation>des Schneidbeginns</translation>
    </message>
    <message>
        <source>of the workspace</source>
        <translation>des Arbeitsraums</translation>
    </message>
    <message>
        <source>penetrability</source>
        <translation>Durchdringbarkeit</translation>
    </message>
    <message>
        <source>point spacing</source>
        <translation>Abstand der Punkte</translation>
    </message>
    <message>
        <source>presliding</source>
        <translation>Vorgleitweg</translation>
    </message>
    <message>
        <source>puncture depth</source>
        <translation>Tiefe des Durchstichs</translation>
    </message>
    <message>
        <source>puncture time</source>
        <translation>Dauer des Durchstichs</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratischer Anteil</translation>
    </message>
    <message>
        <source>r_cap; half the edge of an element</source>
        <translation>r_cap; halbe Kante eines Elements</translation>
    </message>
    <message>
        <source>relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>release</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>rho, of one element</source>
        <translation>rho, eines Elements</translation>
    </message>
    <message>
        <source>rho_f, on 1 mm of shaft</source>
        <translation>rho_f, auf 1 mm Schaft</translation>
    </message>
    <message>
        <source>rho_s, of the grip on 1 mm of shaft</source>
        <translation>rho_s, der Haftung auf 1 mm Schaft</translation>
    </message>
    <message>
        <source>shaft spacing</source>
        <translation>Abstand am Schaft</translation>
    </message>
    <message>
        <source>shaft stiffness</source>
        <translation>Steifigkeit am Schaft</translation>
    </message>
    <message>
        <source>shaft viscosity</source>
        <translation>Zähigkeit am Schaft</translation>
    </message>
    <message>
        <source>shortest outside</source>
        <translation>kürzeste Länge außerhalb</translation>
    </message>
    <message>
        <source>sigma, spring of the friction at rest, per mm of shaft</source>
        <translation>sigma, Feder der Reibung in Ruhe, je mm Schaft</translation>
    </message>
    <message>
        <source>sigma_0, of the bristles</source>
        <translation>sigma_0, der Borsten</translation>
    </message>
    <message>
        <source>skin stiffness</source>
        <translation>Steifigkeit der Haut</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>slope x</source>
        <translation>Anstieg x</translation>
    </message>
    <message>
        <source>slope y</source>
        <translation>Anstieg y</translation>
    </message>
    <message>
        <source>slope z</source>
        <translation>Anstieg z</translation>
    </message>
    <message>
        <source>smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>standard deviation of the Gaussian on V_label</source>
        <translation>Standardabweichung der Gaußglocke auf V_label</translation>
    </message>
    <message>
        <source>static</source>
        <translation>Haften</translation>
    </message>
    <message>
        <source>stick after</source>
        <translation>Haften nach</translation>
    </message>
    <message>
        <source>stiffening</source>
        <translation>Versteifung</translation>
    </message>
    <message>
        <source>stiffness scale</source>
        <translation>Faktor der Steifigkeit</translation>
    </message>
    <message>
        <source>stribeck velocity</source>
        <translation>Stribeck-Geschwindigkeit</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>t_m, of the membrane</source>
        <translation>t_m, der Membran</translation>
    </message>
    <message>
        <source>the deflection grows no further; the paper wants much less than 1 rad</source>
        <translation>die Auslenkung wächst nicht weiter; die Arbeit verlangt weit weniger als 1 rad</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>tip radius</source>
        <translation>Radius der Spitze</translation>
    </message>
    <message>
        <source>torque limit</source>
        <translation>Grenze des Drehmoments</translation>
    </message>
    <message>
        <source>torsion</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>toughness</source>
        <translation>Bruchzähigkeit</translation>
    </message>
    <message>
        <source>trailing</source>
        <translation>Nachziehen</translation>
    </message>
    <message>
        <source>until the force is zero on withdrawal</source>
        <translation>bis die Kraft beim Zurückziehen null ist</translation>
    </message>
    <message>
        <source>up x</source>
        <translation>oben x</translation>
    </message>
    <message>
        <source>up y</source>
        <translation>oben y</translation>
    </message>
    <message>
        <source>up z</source>
        <translation>oben z</translation>
    </message>
    <message>
        <source>v_s, at which static has become Coulomb friction</source>
        <translation>v_s, bei der Haftreibung zur Coulomb-Reibung geworden ist</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>Zähigkeit</translation>
    </message>
    <message>
        <source>viscous</source>
        <translation>viskoser Anteil</translation>
    </message>
    <message>
        <source>w, of the crack: about the needle's diameter</source>
        <translation>w, des Risses: etwa der Durchmesser der Nadel</translation>
    </message>
    <message>
        <source>w0, the surface of the patient</source>
        <translation>w0, die Oberfläche des Patienten</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>way before a change of tissue is taken back; a voxel</source>
        <translation>Weg, bevor ein Wechsel des Gewebes zurückgenommen wird; ein Voxel</translation>
    </message>
    <message>
        <source>what the CT adds from lowest to highest HU, on the scale of the labels</source>
        <translation>was das CT vom untersten bis zum obersten HU-Wert hinzufügt, auf der Skala der Strukturen</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>x_w, where the wall stands</source>
        <translation>x_w, wo die Wand steht</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Bodkin default, no published value</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert</translation>
    </message>
    <message>
        <source>Bodkin default, no published value.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert.</translation>
    </message>
    <message>
        <source>%1; all else Bodkin default.</source>
        <translation>%1; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>all else Bodkin default</source>
        <translation>alles andere Vorgabe von Bodkin</translation>
    </message>
    <message>
        <source>All else: Bodkin default, no published value.</source>
        <translation>Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert.</translation>
    </message>
    <message>
        <source>All else, HU included: Bodkin default, no published value.</source>
        <translation>Alles andere, auch HU: Vorgabe von Bodkin, kein veröffentlichter Wert.</translation>
    </message>
    <message>
        <source>HU and all else: Bodkin default, no published value.</source>
        <translation>HU und alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert.</translation>
    </message>
    <message>
        <source>As cortical bone. HU: Bodkin default, no published value; beyond the scale of most scanners. Sound: impedance and attenuation of titanium alloy, Sensors 2023, PMC10346919; steel has 46; all else Bodkin default.</source>
        <translation>Wie kompakter Knochen. HU: Vorgabe von Bodkin, kein veröffentlichter Wert; jenseits der Skala der meisten Scanner. Schall: Impedanz und Dämpfung einer Titanlegierung, Sensors 2023, PMC10346919; Stahl hat 46; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>As fat; the fall of force on entering it is the loss of resistance. Pressure: 4.5 mmHg, within the -0.3 to 10 mmHg measured in the epidural space. HU and all else: Bodkin default, no published value. Sound: impedance and attenuation as fat; brighter than the fat under the skin, as sonographers see it; all else Bodkin default.</source>
        <translation>Wie Fett; der Abfall der Kraft beim Eintritt ist der Widerstandsverlust. Druck: 4.5 mmHg, innerhalb der im Epiduralraum gemessenen -0.3 bis 10 mmHg. HU und alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz und Dämpfung wie Fett; heller als das Fett unter der Haut, wie man es im Ultraschall sieht; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>As muscle. HU: Bodkin default, no published value. Sound: impedance and attenuation of soft tissue in LOTUS and ct2us; all else Bodkin default.</source>
        <translation>Wie Muskel. HU: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz und Dämpfung von Weichgewebe in LOTUS und ct2us; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value. Sound: between muscle and ligament, no published value was found; all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: zwischen Muskel und Band, kein veröffentlichter Wert gefunden; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value. Sound: impedance of air, standard data, recalled; attenuation 7.5 dB/cm at 1 MHz (Diagnostics 2023, PMC10001275); all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz von Luft, Standardwert, aus dem Gedächtnis; Dämpfung 7.5 dB/cm bei 1 MHz (Diagnostics 2023, PMC10001275); alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value. Sound: no published value was found; all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: kein veröffentlichter Wert gefunden; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value; chosen so that it is felt between skin and interspinous ligament. Sound: impedance of ligament measured (Bioengineering 2025, 12(9) 946); attenuation of connective tissue, Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert; so gewählt, dass man es zwischen Haut und Lig. interspinale spürt. Schall: gemessene Impedanz von Bändern (Bioengineering 2025, 12(9) 946); Dämpfung von Bindegewebe, Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value; firmer than muscle. Sound: darker than what is around it, no published value was found; all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert; fester als Muskel. Schall: dunkler als die Umgebung, kein veröffentlichter Wert gefunden; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value; stiffer than disc. Sound: nearly black, as hyaline cartilage is seen; attenuation of connective tissue, Diagnostics 2023, PMC10001275; impedance without a published value; all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert; steifer als die Bandscheibe. Schall: fast schwarz, wie hyaliner Knorpel erscheint; Dämpfung von Bindegewebe, Diagnostics 2023, PMC10001275; Impedanz ohne veröffentlichten Wert; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value; the grip is chosen so that the 25 to 30 mm along the needle (Lawrence et al.) add about 1.3 N. Sound: impedance and attenuation between those of ligament (1.83, and 1.57 of connective tissue) and of the fat in it (1.38 and 0.63); all else Bodkin default.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert; die Haftung ist so gewählt, dass die 25 bis 30 mm entlang der Nadel (Lawrence et al.) etwa 1.3 N beitragen. Schall: Impedanz und Dämpfung zwischen denen von Bändern (1.83, und 1.57 von Bindegewebe) und des Fetts darin (1.38 und 0.63); alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Break force at the lower end of the axial force in soft tissue, 0.5 to 1.5 N (Sutherland et al. 2013, III.A). HU: 10 to 80 in Hounsfield tables (ecgcourse.com; Grainger and Allison). tracking_wall: 1 N and 0.5 N/mm, printed for a soft layer that no tissue is named for (Alamilla, Moreau and Redarce 2018). All else: Bodkin default, no published value. Sound: impedance Sensors 2023, PMC10346919 (measured 1.65 across and 1.69 along its fibres: Bioengineering 2025, 12(9) 946); attenuation across fibres, Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>Durchstichkraft am unteren Ende der axialen Kraft in Weichgewebe, 0.5 bis 1.5 N (Sutherland et al. 2013, III.A). HU: 10 bis 80 in Hounsfield-Tabellen (ecgcourse.com; Grainger und Allison). tracking_wall: 1 N und 0.5 N/mm, gedruckt für eine weiche Schicht, für die kein Gewebe genannt ist (Alamilla, Moreau und Redarce 2018). Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz Sensors 2023, PMC10346919 (gemessen 1.65 quer und 1.69 längs der Fasern: Bioengineering 2025, 12(9) 946); Dämpfung quer zu den Fasern, Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Break force between the median of 24 studies, 1.22 N (van Gerwen, Dankelman and van den Dobbelsteen 2012), and 1.5 N of a 24G virtual needle (Sutherland et al. 2013, III.A). All else, HU included: Bodkin default, no published value. Sound: impedance 1.131 g/cm3 x 1655 m/s measured (Bioengineering 2025, 12(9) 946); attenuation Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>Durchstichkraft zwischen dem Median von 24 Studien, 1.22 N (van Gerwen, Dankelman und van den Dobbelsteen 2012), und 1.5 N einer virtuellen Nadel von 24G (Sutherland et al. 2013, III.A). Alles andere, auch HU: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: gemessene Impedanz 1.131 g/cm3 x 1655 m/s (Bioengineering 2025, 12(9) 946); Dämpfung Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Breaks after 2 mm of tenting, the lower end of 2 to 6 mm seen in living people (Zarzur and Goncalves 1992). All else: Bodkin default, no published value. Sound: as ligament, no published value was found; all else Bodkin default.</source>
        <translation>Reißt nach 2 mm Vorwölbung, am unteren Ende der 2 bis 6 mm, die man an Lebenden sah (Zarzur und Goncalves 1992). Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: wie Bänder, kein veröffentlichter Wert gefunden; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Contact stiffness and HU: Bodkin default, no published value; tables give 300 to 400 HU (radiologystar.com), vertebral bodies of living adults measure lower. Sound: impedance near the upper end of 0.6 to 3.8, the density times the speed of Mech. Mater. 2012, PMC3233242 (cleaned bone measures 1.33); attenuation of bone, Diagnostics 2023, PMC10001275; echo none; all else Bodkin default.</source>
        <translation>Kontaktsteifigkeit und HU: Vorgabe von Bodkin, kein veröffentlichter Wert; Tabellen geben 300 bis 400 HU an (radiologystar.com), an Wirbelkörpern lebender Erwachsener misst man weniger. Schall: Impedanz nahe dem oberen Ende von 0.6 bis 3.8, Dichte mal Schallgeschwindigkeit aus Mech. Mater. 2012, PMC3233242 (gereinigter Knochen: 1.33); Dämpfung von Knochen, Diagnostics 2023, PMC10001275; kein Echo; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Friction of layered and shaft_friction: bovine liver, 1.27 mm needle, 0.0106 to 0.0120 N/mm and 0.00021 N s/mm^2 (Okamura, Simone and O'Leary 2004, recalled). HU: kidney, spleen and liver 20 to 65 (radclass.mudr.org Hounsfield table). All else: Bodkin default, no published value. Sound: impedance of liver and kidney (measured 1.67 and 1.64: Bioengineering 2025, 12(9) 946); attenuation between liver and kidney, 0.5 and 1.0 (Diagnostics 2023, PMC10001275); all else Bodkin default.</source>
        <translation>Reibung von layered und shaft_friction: Rinderleber, Nadel von 1.27 mm, 0.0106 bis 0.0120 N/mm und 0.00021 N s/mm^2 (Okamura, Simone und O'Leary 2004, aus dem Gedächtnis). HU: Niere, Milz und Leber 20 bis 65 (Hounsfield-Tabelle von radclass.mudr.org). Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz von Leber und Niere (gemessen 1.67 und 1.64: Bioengineering 2025, 12(9) 946); Dämpfung zwischen Leber und Niere, 0.5 und 1.0 (Diagnostics 2023, PMC10001275); alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>HU by definition. Sound: impedance of air, standard data, recalled; attenuation 7.5 dB/cm at 1 MHz (Diagnostics 2023, PMC10001275); all else Bodkin default.</source>
        <translation>HU nach Definition. Schall: Impedanz von Luft, Standardwert, aus dem Gedächtnis; Dämpfung 7.5 dB/cm bei 1 MHz (Diagnostics 2023, PMC10001275); alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>HU of blood: 45 to 65 (radclass.mudr.org Hounsfield table). All else: Bodkin default, no published value. Sound: impedance of blood in raysim and burgercpp; attenuation of blood, Diagnostics 2023, PMC10001275; its power recalled; all else Bodkin default.</source>
        <translation>HU von Blut: 45 bis 65 (Hounsfield-Tabelle von radclass.mudr.org). Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz von Blut in raysim und burgercpp; Dämpfung von Blut, Diagnostics 2023, PMC10001275; ihr Exponent aus dem Gedächtnis; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>HU: -910 to -850 (radclass.mudr.org Hounsfield table). All else: Bodkin default, no published value. Sound: impedance of air as in LOTUS, so that all comes back from the pleura; attenuation Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>HU: -910 bis -850 (Hounsfield-Tabelle von radclass.mudr.org). Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz von Luft wie in LOTUS, sodass alles von der Pleura zurückkommt; Dämpfung Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>HU: 0 to 15, commonly quoted. Pressure: 14.5 cm of saline lying (Gilland et al. 1974). No force, and all else: Bodkin default, no published value. Sound: impedance 1.007 g/cm3 x 1505 m/s, near saline, recalled; attenuation of water, Diagnostics 2023, PMC10001275; it grows with the square of frequency; all else Bodkin default.</source>
        <translation>HU: 0 bis 15, häufig genannt. Druck: 14.5 cm Kochsalzlösung im Liegen (Gilland et al. 1974). Keine Kraft, und alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz 1.007 g/cm3 x 1505 m/s, nahe Kochsalzlösung, aus dem Gedächtnis; Dämpfung von Wasser, Diagnostics 2023, PMC10001275; sie wächst mit dem Quadrat der Frequenz; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value: gives way at 2 N, less than half of the ligamentum flavum. All else as the interspinous ligament.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert: gibt bei 2 N nach, weniger als der Hälfte des Lig. flavum. Alles andere wie das Lig. interspinale.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value: as the supraspinous ligament.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert: wie das Lig. supraspinale.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value: fluid that a needle does not feel, as cerebrospinal fluid.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert: Flüssigkeit, die eine Nadel nicht spürt, wie Liquor.</translation>
    </message>
    <message>
        <source>Bodkin default, no published value: twice the puncture force of the ligamentum flavum (4.7 N, Sutherland et al. 2013, III.A), ten times the modulus of the ligament; HU as cancellous bone. All else as the interspinous ligament.</source>
        <translation>Vorgabe von Bodkin, kein veröffentlichter Wert: das Doppelte der Durchstichkraft des Lig. flavum (4.7 N, Sutherland et al. 2013, III.A), das Zehnfache des Moduls des Bandes; HU wie Spongiosa. Alles andere wie das Lig. interspinale.</translation>
    </message>
    <message>
        <source>calcified ligament</source>
        <translation>verkalktes Band</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>#1 to #2</source>
        <translation>#1 bis #2</translation>
    </message>
    <message>
        <source>#1 to #2 %3</source>
        <translation>#1 bis #2 %3</translation>
    </message>
    <message>
        <source>#1 to infinity</source>
        <translation>#1 bis unendlich</translation>
    </message>
    <message>
        <source>#1 %2 to infinity</source>
        <translation>#1 %2 bis unendlich</translation>
    </message>
    <message>
        <source>#1 or more</source>
        <translation>#1 oder mehr</translation>
    </message>
    <message>
        <source>#1 %2 or more</source>
        <translation>#1 %2 oder mehr</translation>
    </message>
    <message>
        <source>more than #1</source>
        <translation>mehr als #1</translation>
    </message>
    <message>
        <source>more than #1 %2</source>
        <translation>mehr als #1 %2</translation>
    </message>
    <message>
        <source>at least #1 and less than #2</source>
        <translation>mindestens #1 und weniger als #2</translation>
    </message>
    <message>
        <source>at least #1 and less than #2 %3</source>
        <translation>mindestens #1 und weniger als #2 %3</translation>
    </message>
    <message>
        <source>more than #1 and at most #2</source>
        <translation>mehr als #1 und höchstens #2</translation>
    </message>
    <message>
        <source>more than #1 and at most #2 %3</source>
        <translation>mehr als #1 und höchstens #2 %3</translation>
    </message>
    <message>
        <source>more than #1 and less than #2</source>
        <translation>mehr als #1 und weniger als #2</translation>
    </message>
    <message>
        <source>more than #1 and less than #2 %3</source>
        <translation>mehr als #1 und weniger als #2 %3</translation>
    </message>
    <message>
        <source>sigma_2</source>
        <translation>sigma_2</translation>
    </message>
    <message>
        <source>HU: -120 to -50 in Hounsfield tables (radclass.mudr.org; radiologystar.com). Drag: Bodkin default, no published value. Sound: impedance of simulators (1.38; measured 1.36 in Bioengineering 2025, 12(9) 946, and 1.39 in Sensors 2023, PMC10346919); attenuation Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>HU: -120 bis -50 in Hounsfield-Tabellen (radclass.mudr.org; radiologystar.com). Zähigkeit: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: Impedanz aus Simulatoren (1.38; gemessen 1.36 in Bioengineering 2025, 12(9) 946, und 1.39 in Sensors 2023, PMC10346919); Dämpfung Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Contact stiffness: what a Phantom Desktop renders (Heng et al. 2004, section 5.4); the device's limit bounds it. HU: 400 to 1000 (Grainger and Allison, by stethoprep.com). Sound: impedance of every simulator that was read (measured: 5.9 in Bioengineering 2025, 12(9) 946, 6.5 in Sensors 2023, PMC10346919); attenuation Diagnostics 2023, PMC10001275; echo none, so that it throws a clean shadow; all else Bodkin default.</source>
        <translation>Kontaktsteifigkeit: was ein Phantom Desktop darstellt (Heng et al. 2004, Abschnitt 5.4); begrenzt durch die Grenze des Geräts. HU: 400 bis 1000 (Grainger und Allison, nach stethoprep.com). Schall: Impedanz aus allen gelesenen Simulatoren (gemessen: 5.9 in Bioengineering 2025, 12(9) 946, 6.5 in Sensors 2023, PMC10346919); Dämpfung Diagnostics 2023, PMC10001275; kein Echo, sodass er einen klaren Schatten wirft; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>Break force chosen so that, with the grip of the tissues behind it, the force peaks at about 4.7 N as in Sutherland et al. 2013, III.A (Naemura et al., 18G, porcine: 5.0, SD 1.0 N). Stiffness: Bodkin default, as stiff as a device of 1 N/mm renders, so that it breaks within about 4 mm. Forces of tracking_wall and volume_proxy: that mean of 4.7 N itself. All else: Bodkin default, no published value. Sound: impedance of ligament measured (Bioengineering 2025, 12(9) 946); attenuation of connective tissue, Diagnostics 2023, PMC10001275; all else Bodkin default.</source>
        <translation>Durchstichkraft so gewählt, dass die Kraft mit der Haftung der Gewebe dahinter bei etwa 4.7 N gipfelt wie bei Sutherland et al. 2013, III.A (Naemura et al., 18G, Schwein: 5.0, SD 1.0 N). Steifigkeit: Vorgabe von Bodkin, so steif, wie ein Gerät von 1 N/mm darstellt, sodass es innerhalb von etwa 4 mm reißt. Kräfte von tracking_wall und volume_proxy: dieses Mittel von 4.7 N selbst. Alles andere: Vorgabe von Bodkin, kein veröffentlichter Wert. Schall: gemessene Impedanz von Bändern (Bioengineering 2025, 12(9) 946); Dämpfung von Bindegewebe, Diagnostics 2023, PMC10001275; alles andere Vorgabe von Bodkin.</translation>
    </message>
    <message>
        <source>%1 is %2, expected %3</source>
        <translation>%1 ist %2, erwartet: %3</translation>
    </message>
    <message>
        <source>%1 is '%2', expected %3</source>
        <translation>%1 ist „%2“, erwartet: %3</translation>
    </message>
    <message>
        <source>%1 is %2, expected at most the %3 of %4</source>
        <translation>%1 ist %2, erwartet: höchstens %3, also %4</translation>
    </message>
    <message>
        <source>%1 is '%2'; expected %3</source>
        <translation>%1 ist „%2“; erwartet: %3</translation>
    </message>
    <message>
        <source>%1 is %2; expected %3</source>
        <translation>%1 ist %2; erwartet: %3</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
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
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rück</translation>
    </message>
</context>
</TS>
