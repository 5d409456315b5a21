<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Texts that reach the window from other modules. %1 to %9 stand for what varies. -->
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Keys</name>
    <message>
        <source>turn and move the body, or stop moving it</source>
        <translation>den Körper drehen und verschieben, oder ihn lassen</translation>
    </message>
    <message>
        <source>undo the last move of the body</source>
        <translation>die letzte Bewegung des Körpers zurücknehmen</translation>
    </message>
    <message>
        <source>put the body back where it was at first</source>
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
        <source>one frame back, forward</source>
        <translation>ein Bild zurück, vor</translation>
    </message>
    <message>
        <source>a smaller brush</source>
        <translation>kleinerer Pinsel</translation>
    </message>
    <message>
        <source>show these keys in the image</source>
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
        <source>turn the needle about its axis, while held</source>
        <translation>die Nadel um ihre Achse drehen, solange gehalten</translation>
    </message>
    <message>
        <source>along the needle, on or off</source>
        <translation>längs der Nadel, oder wie zuvor</translation>
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
        <source>end, and see the result</source>
        <translation>beenden und sehen, wie es war</translation>
    </message>
    <message>
        <source>previous event, next event</source>
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
        <source>quit Bodkin</source>
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
        <source>touch with the device's needle, on or off</source>
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
        <source>decrease by one unit</source>
        <translation>eine Einheit weniger</translation>
    </message>
    <message>
        <source>increase by one unit of the last digit</source>
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
        <source>ask the patient to hold the breath, or to breathe again</source>
        <translation>den Patienten bitten, den Atem anzuhalten oder weiterzuatmen</translation>
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
        <source>previous slice</source>
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
        <source>previous step</source>
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
        <source>undo the last change</source>
        <translation>die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>undo the last step</source>
        <translation>den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>take the next proposal</source>
        <translation>den nächsten Vorschlag nehmen</translation>
    </message>
    <message>
        <source>decrease by ten units</source>
        <translation>zehn Einheiten weniger</translation>
    </message>
    <message>
        <source>increase by ten units</source>
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
        <source>enlarge this view, or restore it</source>
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
        <source>previous view</source>
        <translation>Ansicht davor</translation>
    </message>
    <message>
        <source>previous window</source>
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
        <source>begin, or continue</source>
        <translation>beginnen, oder weitermachen</translation>
    </message>
    <message>
        <source>volume on, off: the inside of the patient</source>
        <translation>Volumen an, aus: das Innere des Patienten</translation>
    </message>
    <message>
        <source>the whole procedure in the slice</source>
        <translation>den ganzen Eingriff in die Schicht</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>%1 has no deformable body, expected embedded_needle or closest_node</source>
        <translation>%1 hat keinen verformbaren Körper, erwartet wird embedded_needle oder closest_node</translation>
    </message>
    <message>
        <source>Shaft friction</source>
        <translation>Schaftreibung</translation>
    </message>
    <message>
        <source>Winding up</source>
        <translation>Aufwickeln</translation>
    </message>
    <message>
        <source>Bevel</source>
        <translation>Anschliff</translation>
    </message>
    <message>
        <source>Fluid</source>
        <translation>Liquor</translation>
    </message>
    <message>
        <source>Syringe</source>
        <translation>Spritze</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>manometer bore</source>
        <translation>Weite des Manometers</translation>
    </message>
    <message>
        <source>pressure volume index</source>
        <translation>Druck-Volumen-Index</translation>
    </message>
    <message>
        <source>times faster</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>bore</source>
        <translation>Innendurchmesser</translation>
    </message>
    <message>
        <source>air volume</source>
        <translation>Luftvolumen</translation>
    </message>
    <message>
        <source>saline compliance</source>
        <translation>Nachgiebigkeit mit Kochsalzlösung</translation>
    </message>
    <message>
        <source>thumb force</source>
        <translation>Daumenkraft</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>in einer Richtung</translation>
    </message>
    <message>
        <source>two way</source>
        <translation>hin und her</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>turns to wind</source>
        <translation>Umdrehungen zum Aufwickeln</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>kappa, of needle and tissue; 0 for a symmetric tip</source>
        <translation>kappa, von Nadel und Gewebe; 0 für eine symmetrische Spitze</translation>
    </message>
    <message>
        <source>of the tissue that pulls the tip to the path that the bevel cuts</source>
        <translation>des Gewebes, das die Spitze auf den Weg zieht, den der Anschliff schneidet</translation>
    </message>
    <message>
        <source>of the soft tissue between skin and bone under a pressing finger</source>
        <translation>des Weichgewebes zwischen Haut und Knochen unter einem drückenden Finger</translation>
    </message>
    <message>
        <source>of the fingertip</source>
        <translation>der Fingerspitze</translation>
    </message>
    <message>
        <source>deeper bone is not felt: the tissue yields as if there were bone just there</source>
        <translation>tieferer Knochen ist nicht zu fühlen: das Gewebe gibt nach, als läge genau dort Knochen</translation>
    </message>
    <message>
        <source>of fluid; 14.5 (SD 3.7) cm lying (Gilland et al. 1974)</source>
        <translation>Flüssigkeitssäule; im Liegen 14.5 (SD 3.7) cm (Gilland et al. 1974)</translation>
    </message>
    <message>
        <source>of the fluid, 0.7 to 1.0 mPa s</source>
        <translation>der Flüssigkeit, 0.7 bis 1.0 mPa s</translation>
    </message>
    <message>
        <source>of the manometer's tube</source>
        <translation>des Rohrs des Manometers</translation>
    </message>
    <message>
        <source>of fluid whose loss lowers the pressure to a tenth, about 25 (Marmarou et al. 1978); 0: it stays</source>
        <translation>Flüssigkeit, deren Verlust den Druck auf ein Zehntel senkt, etwa 25 (Marmarou et al. 1978); 0: er bleibt</translation>
    </message>
    <message>
        <source>so much faster the fluid rises and collects than it would, for a lesson that has no time to wait</source>
        <translation>so viel schneller steigt und sammelt sich die Flüssigkeit, für eine Übung, die keine Zeit zum Warten hat</translation>
    </message>
    <message>
        <source>of the barrel: 11.1 N at 62.7 kPa are 177 mm^2</source>
        <translation>des Zylinders: 11.1 N bei 62.7 kPa sind 177 mm^2</translation>
    </message>
    <message>
        <source>of the gas at rest, with air</source>
        <translation>des Gases in Ruhe, bei Füllung mit Luft</translation>
    </message>
    <message>
        <source>of the chamber with saline</source>
        <translation>der Kammer mit Kochsalzlösung</translation>
    </message>
    <message>
        <source>saline 1e-9, air 1.8e-11</source>
        <translation>Kochsalzlösung 1e-9, Luft 1.8e-11</translation>
    </message>
    <message>
        <source>of the plunger</source>
        <translation>des Kolbens</translation>
    </message>
    <message>
        <source>with which the thumb presses the plunger while the needle is in</source>
        <translation>mit der der Daumen auf den Kolben drückt, während die Nadel im Körper ist</translation>
    </message>
    <message>
        <source>rise of the pull-out force after turning one way (Langevin et al. 2001: +167 %)</source>
        <translation>Anstieg der Kraft beim Ziehen nach Drehen in einer Richtung (Langevin et al. 2001: +167 %)</translation>
    </message>
    <message>
        <source>rise after turning to and fro (+52 %); at most one_way</source>
        <translation>Anstieg nach Hin- und Herdrehen (+52 %); höchstens one_way</translation>
    </message>
    <message>
        <source>factor at an acupuncture point (1.18 compared with control points)</source>
        <translation>Faktor an einem Akupunkturpunkt (1.18 gegenüber Vergleichspunkten)</translation>
    </message>
    <message>
        <source>after which 63 % are reached</source>
        <translation>nach denen 63 % erreicht sind</translation>
    </message>
    <message>
        <source>g_i, of the force; all together 1 at most</source>
        <translation>g_i, der Kraft; alle zusammen höchstens 1</translation>
    </message>
    <message>
        <source>tau_i, in which it decays</source>
        <translation>tau_i, in der er abklingt</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Poisson's ratio; nearer to 1/2 linear tetrahedra lock</source>
        <translation>Querkontraktionszahl; näher an 1/2 sperren lineare Tetraeder</translation>
    </message>
    <message>
        <source>mu_t, Coulomb force per mm of shaft</source>
        <translation>mu_t, Reibungskraft je mm Schaft</translation>
    </message>
    <message>
        <source>F_c, along the needle, at which its tip cuts on inside the tissue</source>
        <translation>F_c, längs der Nadel, bei der ihre Spitze im Gewebe weiterschneidet</translation>
    </message>
    <message>
        <source>of the force that tears the boundary, that cutting on inside takes; 0: the boundary alone resists</source>
        <translation>der Kraft, die die Grenze zerreißt; so viel braucht das Weiterschneiden darin; 0: nur die Grenze widersteht</translation>
    </message>
    <message>
        <source>F_p, along the needle, at which the tissue gives way; 0: at once</source>
        <translation>F_p, längs der Nadel, bei der das Gewebe nachgibt; 0: sofort</translation>
    </message>
    <message>
        <source>k_target, of `closest_node` alone; 0: as the mesh has it</source>
        <translation>k_target, nur für `closest_node`; 0: wie das Netz</translation>
    </message>
    <message>
        <source>young</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>poisson</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>this takes effect from the next attempt on, because the deformable body is prepared with it; its capture radius, times, friction and puncture forces take effect at once</source>
        <translation>solche Zahlen hat der verformbare Körper vom nächsten Versuch an, denn er wird mit ihnen vorbereitet; Fangradius, Zeiten, Reibung und Durchstichkräfte wirken sofort</translation>
    </message>
    <message>
        <source>the session cannot be recomputed: at %1 s its needle met a body that moved on a thread of its own (--body moving), of which only what was felt is kept; 'bodkin report' and 'bodkin export' show that</source>
        <translation>die Sitzung kann nicht nachgerechnet werden: bei %1 s traf ihre Nadel einen Körper, der sich in einem eigenen Faden bewegte (--body moving), von dem nur behalten ist, was gespürt wurde; „bodkin report“ und „bodkin export“ zeigen es</translation>
    </message>
    <message>
        <source>no graphics card can be reached, because there is no X11 display</source>
        <translation>keine Grafikkarte ist erreichbar, denn es gibt keine X11-Anzeige</translation>
    </message>
    <message>
        <source>no graphics card can be reached, because the display has no OpenGL 3.2</source>
        <translation>keine Grafikkarte ist erreichbar, denn die Anzeige hat kein OpenGL 3.2</translation>
    </message>
    <message>
        <source>OpenGL is computed by the processor here (%1)</source>
        <translation>OpenGL rechnet hier der Prozessor (%1)</translation>
    </message>
    <message>
        <source>the volume is %1 voxels long, and the graphics card takes %2</source>
        <translation>das Volumen ist %1 Voxel lang, und die Grafikkarte nimmt %2</translation>
    </message>
    <message>
        <source>VTK's volume mapper does not support this graphics card</source>
        <translation>VTK zeichnet Volumen mit dieser Grafikkarte nicht</translation>
    </message>
    <message>
        <source>the graphics card did not draw the volume: %1</source>
        <translation>die Grafikkarte hat das Volumen nicht gezeichnet: %1</translation>
    </message>
    <message>
        <source>the graphics card draws a different image than the processor</source>
        <translation>die Grafikkarte zeichnet etwas anderes als der Prozessor</translation>
    </message>
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
        <source>another force model takes effect from the next attempt on</source>
        <translation>ein anderes Kraftmodell spürt man vom nächsten Versuch an</translation>
    </message>
    <message>
        <source>another rate takes effect from the next attempt on</source>
        <translation>eine andere Rate gilt vom nächsten Versuch an</translation>
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
        <source>The body is back where it was at first.</source>
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
        <source>Not connected: %1.</source>
        <translation>Nicht verbunden: %1.</translation>
    </message>
    <message>
        <source>Trying again</source>
        <translation>Neuer Versuch</translation>
    </message>
    <message>
        <source>%1 waits for a session to be started there</source>
        <translation>%1 wartet: dort muss eine Sitzung begonnen werden</translation>
    </message>
    <message>
        <source>%1 prepares</source>
        <translation>%1 bereitet vor</translation>
    </message>
    <message>
        <source>This is controlled at the station, %1.</source>
        <translation>Das wird an der Station %1 entschieden.</translation>
    </message>
    <message>
        <source>the station at %1 does not say which patient it has; name the copy of its case: bodkin app CASE --connect %2</source>
        <translation>die Station %1 sagt nicht, welchen Patienten sie hat; nennen Sie die Kopie ihres Falls: bodkin app FALL --connect %2</translation>
    </message>
    <message>
        <source>the station at %1 has the patient '%2', whose case is not on this computer; copy its folder, and name the copy: bodkin app CASE --connect %3</source>
        <translation>die Station %1 hat den Patienten „%2“, von dem es hier keinen Fall gibt; kopieren Sie seinen Ordner und nennen Sie ihn: bodkin app FALL --connect %3</translation>
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
        <source>no server answers at %1 (%2); has it been started?</source>
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
        <source>The patient's segmentation is not available, so it could not be checked whether the tip entered %1; name the case with --case.</source>
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
        <source>Measured with thresholds of the procedure's own: %1.</source>
        <translation>Gemessen mit eigenen Schwellen der Prozedur: %1.</translation>
    </message>
    <message>
        <source>A needle of %1G is unusual here; %2G to %3G is usual.</source>
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
        <source>Stop and draw back at once: the patient feels a shock along the nerve.</source>
        <translation>Halten Sie an und ziehen Sie sofort zurück: der Patient spürt einen Schlag den Nerv entlang.</translation>
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
        <source>This patient does not breathe.</source>
        <translation>Dieser Patient atmet nicht.</translation>
    </message>
    <message>
        <source>The syringe is on the needle: there is no place for stylet or manometer.</source>
        <translation>Die Spritze sitzt auf der Nadel: Für Mandrin und Manometer ist kein Platz.</translation>
    </message>
    <message>
        <source>Fluid comes back through the needle: the dura is open.</source>
        <translation>Liquor fließt durch die Nadel zurück: Die Dura ist eröffnet.</translation>
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
        <source>Withdraw the needle before you fill the syringe again.</source>
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
        <source>The needle is out.</source>
        <translation>Die Nadel ist draußen.</translation>
    </message>
    <message>
        <source>The attempt ends in #1 s, unless it goes in again.</source>
        <translation>Der Versuch endet in #1 s, außer sie geht wieder hinein.</translation>
    </message>
    <message>
        <source>The needle was taken out: the attempt is complete.</source>
        <translation>Die Nadel wurde herausgezogen: der Versuch ist vollständig.</translation>
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
        <source>The patient in %1 has changed since this session: slices and 3-D show its present state.</source>
        <translation>Der Patient in %1 hat sich seit dieser Sitzung geändert: Schichten und 3-D zeigen, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>The patient of this session is not available, so its path is shown without anatomy (%1).</source>
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
        <source>Ready: %1 ticks a second, %2 of %3 too late, moved within %4.</source>
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
        <source>Calibrated, and saved in %1.</source>
        <translation>Kalibriert und in %1 behalten.</translation>
    </message>
    <message>
        <source>The device could not be stopped; switch it off and on again.</source>
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
        <source>How heavy is the stylus, whose weight the hand should not feel?</source>
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
        <source>the full force is on</source>
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
        <source>no tick came for too long</source>
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
        <source>the requested force is not a number</source>
        <translation>die verlangte Kraft ist keine Zahl</translation>
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
        <source>the device reports a pose that is not a number</source>
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
        <source>the device's readings do not change under force</source>
        <translation>die Messwerte des Geräts stehen unter Kraft still</translation>
    </message>
    <message>
        <source>the hand shakes again</source>
        <translation>die Hand schwingt wieder</translation>
    </message>
    <message>
        <source>an axis returned more energy than it received</source>
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
        <source>the motors have reached their permitted mean load</source>
        <translation>die Motoren haben ihre zulässige mittlere Last erreicht</translation>
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
        <source>the hand still shakes: a quarter of the force is left, with damping</source>
        <translation>die Hand zittert weiter: ein Viertel der Kraft bleibt, mit Dämpfung</translation>
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
        <source>a force would act at once</source>
        <translation>eine Kraft würde sofort wirken</translation>
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
        <source>saving the attempt</source>
        <translation>der Versuch wird gesichert</translation>
    </message>
    <message>
        <source>keeping the prepared body</source>
        <translation>der vorbereitete Körper wird aufgehoben</translation>
    </message>
    <message>
        <source>%1 cannot be opened; is it a file, is it there, and may you read it?</source>
        <translation>%1 lässt sich nicht öffnen; ist es eine Datei, ist sie da, und dürfen Sie sie lesen?</translation>
    </message>
    <message>
        <source>%1 cannot be mapped into memory; end other programs</source>
        <translation>%1 passt nicht in den Speicher; beenden Sie andere Programme</translation>
    </message>
    <message>
        <source>assembling the body</source>
        <translation>der Körper wird zusammengesetzt</translation>
    </message>
    <message>
        <source>ordering the body</source>
        <translation>der Körper wird geordnet</translation>
    </message>
    <message>
        <source>factorising the body</source>
        <translation>der Körper wird zerlegt</translation>
    </message>
    <message>
        <source>building the layers</source>
        <translation>die Schichten werden aufgebaut</translation>
    </message>
    <message>
        <source>preparing the picture of the body</source>
        <translation>das Bild des Körpers wird vorbereitet</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>footage</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>filling with tetrahedra</source>
        <translation>mit Tetraedern wird gefüllt</translation>
    </message>
    <message>
        <source>moving nodes of flat tetrahedra</source>
        <translation>Knoten flacher Tetraeder werden verschoben</translation>
    </message>
    <message>
        <source>weighting nodes of flat tetrahedra</source>
        <translation>Knoten flacher Tetraeder werden gewichtet</translation>
    </message>
    <message>
        <source>%1, round %2</source>
        <translation>%1, Durchgang %2</translation>
    </message>
    <message>
        <source>Inserting the needle</source>
        <translation>die Nadel wird eingestochen</translation>
    </message>
    <message>
        <source>following the recorded needle</source>
        <translation>der aufgezeichneten Nadel wird gefolgt</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>es wird geschallt</translation>
    </message>
    <message>
        <source>database or disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>der Datenträger lässt sich nicht lesen oder schreiben</translation>
    </message>
    <message>
        <source>The session was cut off; what was recorded until then is kept</source>
        <translation>Die Sitzung wurde abgebrochen; was bis dahin aufgezeichnet wurde, bleibt</translation>
    </message>
    <message>
        <source>The needle is turned by #1° about its axis.</source>
        <translation>Die Nadel ist um #1° um ihre Achse gedreht.</translation>
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
        <source>Lumbar torso. A lesion of 20 mm next to the psoas.</source>
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
        <source>Shoulder. Next to the nerve, never into it.</source>
        <translation>Schulter. Neben den Nerv, nie hinein.</translation>
    </message>
    <message>
        <source>distance from the planned path, mean</source>
        <translation>Abstand vom geplanten Weg, Mittel</translation>
    </message>
    <message>
        <source>Fréchet distance of the tip's path from the planned path</source>
        <translation>Fréchet-Abstand des Wegs vom geplanten</translation>
    </message>
    <message>
        <source>mean distance of the tip's path from the planned path, best aligned</source>
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
        <source>extent of the tip's motion from side to side</source>
        <translation>Ausdehnung der Bewegung der Spitze von Seite zu Seite</translation>
    </message>
    <message>
        <source>extent of the tip's motion from front to back</source>
        <translation>Ausdehnung der Bewegung der Spitze von vorn nach hinten</translation>
    </message>
    <message>
        <source>extent of the tip's motion along the body</source>
        <translation>Ausdehnung der Bewegung der Spitze längs des Körpers</translation>
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
        <source>distance of the tip of a needle in action from the ultrasound slice, mean</source>
        <translation>Abstand der Spitze einer tätigen Nadel von der Ultraschallebene, Mittel</translation>
    </message>
    <message>
        <source>distance of the tip of a needle in action from the ultrasound slice, greatest</source>
        <translation>Abstand der Spitze einer tätigen Nadel von der Ultraschallebene, größter</translation>
    </message>
    <message>
        <source>length of the tip's path</source>
        <translation>Länge des Wegs der Spitze</translation>
    </message>
    <message>
        <source>time in action</source>
        <translation>Zeit in Tätigkeit</translation>
    </message>
    <message>
        <source>root of the squared jerk</source>
        <translation>Wurzel des quadrierten Rucks</translation>
    </message>
    <message>
        <source>distance of the needle's line at the skin from the target</source>
        <translation>Abstand der Nadelgeraden an der Haut vom Ziel</translation>
    </message>
    <message>
        <source>distance of the tip at the skin from the line of the planned path</source>
        <translation>Abstand der Spitze an der Haut von der Geraden des geplanten Wegs</translation>
    </message>
    <message>
        <source>contacts with bone on the first way in</source>
        <translation>Knochenkontakte auf dem ersten Weg hinein</translation>
    </message>
    <message>
        <source>spinous processes of L5, L4 and L3 that the ultrasound showed</source>
        <translation>Dornfortsätze von L5, L4 und L3, die der Ultraschall zeigte</translation>
    </message>
    <message>
        <source>time until the ultrasound first showed the target</source>
        <translation>Zeit, bis der Ultraschall das Ziel zuerst zeigte</translation>
    </message>
    <message>
        <source>steps of a guided insertion that were kept</source>
        <translation>eingehaltene Schritte eines geführten Einstichs</translation>
    </message>
    <message>
        <source>least distance from what must not be entered</source>
        <translation>kleinster Abstand von dem, was nicht getroffen werden darf</translation>
    </message>
    <message>
        <source>Before you pierce the skin: find the target, and line up the needle with the way to it.</source>
        <translation>Bevor Sie die Haut durchstechen: Suchen Sie das Ziel auf und richten Sie die Nadel auf den Weg dorthin aus.</translation>
    </message>
    <message>
        <source>With a probe: find the spinous processes of L5, L4 and L3 and the space, then line up the needle with it.</source>
        <translation>Mit einem Schallkopf: Suchen Sie die Dornfortsätze von L5, L4 und L3 und den Zwischenraum auf, dann richten Sie die Nadel darauf aus.</translation>
    </message>
    <message>
        <source>You did not lift and thrust the needle.</source>
        <translation>Sie haben die Nadel nicht gehoben und gesenkt.</translation>
    </message>
    <message>
        <source>You did not twirl the needle.</source>
        <translation>Sie haben die Nadel nicht gedreht.</translation>
    </message>
    <message>
        <source>Let each thrust end at the depth of the point.</source>
        <translation>Lassen Sie jeden Stoß in der Tiefe des Punkts enden.</translation>
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
        <source>angle between a needle in action and the ultrasound slice</source>
        <translation>Winkel zwischen tätiger Nadel und Ultraschallebene</translation>
    </message>
    <message>
        <source>greatest angle between a needle in action and the ultrasound slice</source>
        <translation>größter Winkel zwischen tätiger Nadel und Ultraschallebene</translation>
    </message>
    <message>
        <source>angle between needle and the line to the target in the ultrasound picture</source>
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
        <source>gradient least</source>
        <translation>kleinster Gradient je mm</translation>
    </message>
    <message>
        <source>gradient reference</source>
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
        <source>of the needle's line behind the target that has points</source>
        <translation>der Linie der Nadel hinter dem Ziel, die Punkte hat</translation>
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
        <source>points beyond</source>
        <translation>Punkte hinter dem Ziel</translation>
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
    <message>
        <source>surface: vertex %1 is not finite or farther than 1e4 mm from the origin; give vertices in LPS mm</source>
        <translation>Oberfläche: der Eckpunkt %1 ist nicht endlich oder liegt mehr als 1e4 mm vom Ursprung; geben Sie Eckpunkte in LPS mm an</translation>
    </message>
    <message>
        <source>surface: triangle %1 has a corner that is none of the %2 vertices; corners count from 0</source>
        <translation>Oberfläche: das Dreieck %1 hat eine Ecke, die keiner der %2 Eckpunkte ist; Ecken zählen von 0 an</translation>
    </message>
    <message>
        <source>surface: triangles %1 and %2 run along the edge of vertices %3 and %4 in the same direction; turn all triangles the same side out, two to an edge</source>
        <translation>Oberfläche: die Dreiecke %1 und %2 laufen in derselben Richtung an der Kante der Eckpunkte %3 und %4 entlang; drehen Sie alle Dreiecke mit derselben Seite nach außen, zwei je Kante</translation>
    </message>
    <message>
        <source>tissue '%1' has id 255, which is reserved; use 0 to 254</source>
        <translation>das Gewebe „%1“ hat die Nummer 255, die vergeben ist; nehmen Sie 0 bis 254</translation>
    </message>
    <message>
        <source>tissues '%1' and '%2' share id %3; give one of them another</source>
        <translation>die Gewebe „%1“ und „%2“ haben dieselbe Nummer %3; geben Sie einem eine andere</translation>
    </message>
    <message>
        <source>tissue name '%1' is used twice</source>
        <translation>der Gewebename „%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>tissue surface: the tissue map is empty; give that of a patient</source>
        <translation>Gewebeoberfläche: die Gewebekarte ist leer; geben Sie die eines Patienten an</translation>
    </message>
    <message>
        <source>tissue surface: none of the wished tissues is left at this edge and smoothing; choose tissues that the patient has, or take edge and smoothing smaller</source>
        <translation>Gewebeoberfläche: bei dieser Kantenlänge und Glättung bleibt keines der gewünschten Gewebe übrig; wählen Sie Gewebe, die der Patient hat, oder nehmen Sie Kantenlänge und Glättung kleiner</translation>
    </message>
    <message>
        <source>no pipe for the signals: %1</source>
        <translation>keine Leitung für die Signale: %1</translation>
    </message>
    <message>
        <source>there is no driver '%1'</source>
        <translation>es gibt keinen Treiber „%1“</translation>
    </message>
    <message>
        <source>--attempt is not valid JSON that describes an attempt: %1</source>
        <translation>--attempt ist kein JSON, das sagt, wie geübt werden soll: %1</translation>
    </message>
    <message>
        <source>no body is called "mannequin", in which the patient is placed; name one so in the bodies</source>
        <translation>kein Körper heißt „mannequin“, in den der Patient gelegt wird; nennen Sie einen der Körper so</translation>
    </message>
    <message>
        <source>there is no %1; choose a folder or an image file</source>
        <translation>%1 gibt es nicht; wählen Sie einen Ordner oder eine Bilddatei</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2; free space there or set XDG_DATA_HOME</source>
        <translation>%1 kann nicht angelegt werden: %2; schaffen Sie dort Platz oder setzen Sie XDG_DATA_HOME</translation>
    </message>
    <message>
        <source>there is no driver '%1'; choose another device on the page Devices</source>
        <translation>es gibt keinen Treiber „%1“; wählen Sie auf der Seite Geräte ein anderes Gerät</translation>
    </message>
    <message>
        <source>there is no folder for calibrations, because neither XDG_CONFIG_HOME nor HOME is set; set one</source>
        <translation>es gibt keinen Platz für Kalibrierungen, denn weder XDG_CONFIG_HOME noch HOME ist gesetzt; setzen Sie eines davon</translation>
    </message>
    <message>
        <source>there is no force model '%1'</source>
        <translation>es gibt kein Kraftmodell „%1“</translation>
    </message>
    <message>
        <source>the experiment %1 is not installed; install Bodkin's share/bodkin/experiments</source>
        <translation>der Versuchsaufbau %1 ist nicht installiert; installieren Sie share/bodkin/experiments von Bodkin</translation>
    </message>
    <message>
        <source>%1 holds no tick: the session ended before the device had answered; choose another</source>
        <translation>%1 enthält keinen Takt: die Sitzung endete, bevor das Gerät geantwortet hatte; wählen Sie eine andere</translation>
    </message>
    <message>
        <source>Make a structure first, or choose one.</source>
        <translation>Legen Sie erst eine Struktur an, oder wählen Sie eine.</translation>
    </message>
    <message>
        <source>The tissue library has no '%1'.</source>
        <translation>Die Gewebesammlung hat kein „%1“.</translation>
    </message>
    <message>
        <source>All labels are taken.</source>
        <translation>Alle Nummern sind vergeben.</translation>
    </message>
    <message>
        <source>The report needs the patient of the session and a planned path; %1</source>
        <translation>Der Bericht braucht den Patienten der Sitzung und einen geplanten Weg; %1</translation>
    </message>
    <message>
        <source>choose a session whose patient is still there</source>
        <translation>wählen Sie eine Sitzung, deren Patient noch da ist</translation>
    </message>
    <message>
        <source>there is no language %1, expected one of %2</source>
        <translation>es gibt keine Sprache %1, erwartet: eine von %2</translation>
    </message>
    <message>
        <source>The needle is past the tissue that was computed ahead of it: draw it back a little.</source>
        <translation>Die Nadel ist weiter als das Gewebe, das vor ihr berechnet ist: ziehen Sie sie ein wenig zurück.</translation>
    </message>
    <message>
        <source>Choose the target: click it in a slice.</source>
        <translation>Wählen Sie das Ziel: klicken Sie es in einer Schicht an.</translation>
    </message>
    <message>
        <source>Choose where to go in: click the skin, or a proposal.</source>
        <translation>Wählen Sie den Eintritt: klicken Sie auf die Haut oder einen Vorschlag.</translation>
    </message>
    <message>
        <source>This is no place for %1: %2.</source>
        <translation>Dies ist kein Ort für %1: %2.</translation>
    </message>
    <message>
        <source>The path goes into %1.</source>
        <translation>Der Weg führt in: %1.</translation>
    </message>
    <message>
        <source>something to avoid</source>
        <translation>etwas, das zu meiden ist</translation>
    </message>
    <message>
        <source>Not saved: %1.</source>
        <translation>Nicht gespeichert: %1.</translation>
    </message>
    <message>
        <source>Point at the skin where you want to go in, and click.</source>
        <translation>Zeigen Sie auf die Stelle der Haut, an der Sie einstechen möchten, und klicken Sie.</translation>
    </message>
    <message>
        <source>First point at the skin where you want to go in.</source>
        <translation>Zeigen Sie zuerst auf die Stelle der Haut, an der Sie einstechen möchten.</translation>
    </message>
    <message>
        <source>%1 waits, because the last session could not be started: %2</source>
        <translation>%1 wartet: die letzte Sitzung wurde nicht begonnen: %2</translation>
    </message>
    <message>
        <source>opening the camera</source>
        <translation>die Kamera wird geöffnet</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>the mouse of this window</source>
        <translation>die Maus dieses Fensters</translation>
    </message>
    <message>
        <source>no window is open that has the mouse</source>
        <translation>kein Fenster ist offen, das die Maus hat</translation>
    </message>
    <message>
        <source>the trainee</source>
        <translation>der Übende</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>das Ziel</translation>
    </message>
    <message>
        <source>the entry</source>
        <translation>der Eintritt</translation>
    </message>
    <message>
        <source>limited: %1</source>
        <translation>begrenzt: %1</translation>
    </message>
    <message>
        <source>Nine layers</source>
        <translation>Neun Schichten</translation>
    </message>
    <message>
        <source>Synthetic shoulder</source>
        <translation>Künstliche Schulter</translation>
    </message>
    <message>
        <source>%1 cannot be written; is the folder there, writable and not full?</source>
        <translation>%1 kann nicht geschrieben werden; ist der Ordner da, beschreibbar und nicht voll?</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>%1 is '%2'; expected %3 finite numbers with commas between them</source>
        <translation>%1 ist „%2“; erwartet: %3 endliche Zahlen mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>%1 is '%2'; expected three finite numbers in LPS mm such as 4.5,-45,293</source>
        <translation>%1 ist „%2“; erwartet: drei endliche Zahlen in LPS mm wie 4.5,-45,293</translation>
    </message>
    <message>
        <source>%1 is %2, expected at most the %3 of %4, less %5</source>
        <translation>%1 ist %2, erwartet: höchstens %3, also %4, weniger %5</translation>
    </message>
    <message>
        <source>%1 of element %2 is %3, expected %4 for the first one</source>
        <translation>%1 von Element %2 ist %3, erwartet: %4 für das erste</translation>
    </message>
    <message>
        <source>%1 of element %2 is %3, expected more than the %4 of the one before</source>
        <translation>%1 von Element %2 ist %3, erwartet: mehr als die %4 davor</translation>
    </message>
    <message>
        <source>there are %1 elements %2, expected at most %3</source>
        <translation>es gibt %1 Elemente %2, erwartet: höchstens %3</translation>
    </message>
    <message>
        <source>%1; it takes %2</source>
        <translation>%1; möglich: %2</translation>
    </message>
    <message>
        <source>the unknown setting %1; it takes %2</source>
        <translation>die unbekannte Einstellung %1; möglich: %2</translation>
    </message>
    <message>
        <source>the unknown element %1; it takes %2</source>
        <translation>das unbekannte Element %1; möglich: %2</translation>
    </message>
    <message>
        <source>%1 of the %2 components of a vector are given, expected all or none</source>
        <translation>%1 der %2 Komponenten eines Vektors sind angegeben, erwartet: alle oder keine</translation>
    </message>
    <message>
        <source>expected one element inside: %1</source>
        <translation>erwartet: ein Element innen: %1</translation>
    </message>
    <message>
        <source>the element %1 is given %2 times, expected it once at most</source>
        <translation>das Element %1 kommt %2-mal vor, erwartet: höchstens einmal</translation>
    </message>
    <message>
        <source>beam: the bore of the needle is not smaller than its outer diameter; give the inner diameter of the tube</source>
        <translation>Balken: die Bohrung der Nadel ist nicht kleiner als ihr Außendurchmesser; geben Sie den Innendurchmesser des Rohrs an</translation>
    </message>
    <message>
        <source>gravity_compensation: there is no sample to fit; hold the device still at four places or more</source>
        <translation>gravity_compensation: es gibt keine Messung zum Anpassen; halten Sie das Gerät an vier oder mehr Stellen still</translation>
    </message>
    <message>
        <source>gravity_compensation: a sample is not a finite number; measure it again</source>
        <translation>gravity_compensation: eine Messung ist keine endliche Zahl; messen Sie noch einmal</translation>
    </message>
    <message>
        <source>volume_proxy: the case has no CT or no tissues; this model needs both</source>
        <translation>volume_proxy: der Fall hat kein CT oder keine Gewebe; dieses Modell braucht beides</translation>
    </message>
    <message>
        <source>%1 is %2 N/mm, but the device (%3) renders at most %4 N/mm stably; lower it, or give the device its true %5</source>
        <translation>%1 beträgt %2 N/mm, aber das Gerät (%3) stellt höchstens %4 N/mm stabil dar; senken Sie den Wert, oder geben Sie dem Gerät sein wahres %5</translation>
    </message>
    <message>
        <source>%1 is %2 N/mm, but the device (%3) renders at most %4 N/mm stably on its weakest axis; lower it, or give the device its true %5</source>
        <translation>%1 beträgt %2 N/mm, aber das Gerät (%3) stellt auf seiner schwächsten Achse höchstens %4 N/mm stabil dar; senken Sie den Wert, oder geben Sie dem Gerät sein wahres %5</translation>
    </message>
    <message>
        <source>damping is %1 N s/mm, but together with a spring of %2 N/mm the device (%3) renders at most %4 N s/mm stably; lower damping or stiffness, or give the device its true stiffness_N_per_mm</source>
        <translation>die Dämpfung beträgt %1 N s/mm, aber neben einer Feder von %2 N/mm stellt das Gerät (%3) höchstens %4 N s/mm stabil dar; senken Sie Dämpfung oder Steifigkeit, oder geben Sie dem Gerät sein wahres stiffness_N_per_mm</translation>
    </message>
    <message>
        <source>depth Xr where the spring is slack</source>
        <translation>Tiefe Xr, in der die Feder entspannt ist</translation>
    </message>
    <message>
        <source>energy stored in the membrane</source>
        <translation>in der Membran gespeicherte Energie</translation>
    </message>
    <message>
        <source>depth W to which it is cut</source>
        <translation>Tiefe W, bis zu der geschnitten ist</translation>
    </message>
    <message>
        <source>force at the tip</source>
        <translation>Kraft an der Spitze</translation>
    </message>
    <message>
        <source>friction of the shaft</source>
        <translation>Reibung am Schaft</translation>
    </message>
    <message>
        <source>factor on the friction of the shaft</source>
        <translation>Faktor auf die Reibung am Schaft</translation>
    </message>
    <message>
        <source>depth in the tissue at rest</source>
        <translation>Tiefe im ruhenden Gewebe</translation>
    </message>
    <message>
        <source>stretch z of the tissue on the shaft</source>
        <translation>Dehnung z des Gewebes am Schaft</translation>
    </message>
    <message>
        <source>depth behind the wall</source>
        <translation>Tiefe hinter der Wand</translation>
    </message>
    <message>
        <source>proxy, L</source>
        <translation>Proxy, L</translation>
    </message>
    <message>
        <source>proxy, P</source>
        <translation>Proxy, P</translation>
    </message>
    <message>
        <source>proxy, S</source>
        <translation>Proxy, S</translation>
    </message>
    <message>
        <source>faces that hold the proxy</source>
        <translation>Flächen, die den Proxy halten</translation>
    </message>
    <message>
        <source>position W of the wall</source>
        <translation>Lage W der Wand</translation>
    </message>
    <message>
        <source>hand ahead of the needle in the body</source>
        <translation>Hand vor der Nadel im Körper</translation>
    </message>
    <message>
        <source>contact points on the shaft</source>
        <translation>Kontaktpunkte am Schaft</translation>
    </message>
    <message>
        <source>path of the bevel beside the line</source>
        <translation>Weg des Schliffs neben der Linie</translation>
    </message>
    <message>
        <source>pull of the tissue on the bevel</source>
        <translation>Zug des Gewebes am Schliff</translation>
    </message>
    <message>
        <source>flow of cerebrospinal fluid</source>
        <translation>Fluss des Liquors</translation>
    </message>
    <message>
        <source>fluid in the manometer</source>
        <translation>Liquor im Manometer</translation>
    </message>
    <message>
        <source>fluid that has dripped</source>
        <translation>abgetropfter Liquor</translation>
    </message>
    <message>
        <source>pressure in the syringe</source>
        <translation>Druck in der Spritze</translation>
    </message>
    <message>
        <source>travel of the plunger</source>
        <translation>Weg des Stempels</translation>
    </message>
    <message>
        <source>the stiffness at which the membrane tears</source>
        <translation>die Steifigkeit, bei der die Membran reißt</translation>
    </message>
    <message>
        <source>the stiffness at which the capsule gives way</source>
        <translation>die Steifigkeit, bei der die Kapsel nachgibt</translation>
    </message>
    <message>
        <source>the spring of %1</source>
        <translation>die Feder von %1</translation>
    </message>
    <message>
        <source>the spring of a layer</source>
        <translation>die Feder einer Schicht</translation>
    </message>
    <message>
        <source>the device reported no pose; touch the point again</source>
        <translation>das Gerät meldete keine Lage; berühren Sie den Punkt noch einmal</translation>
    </message>
    <message>
        <source>%1 speaks version %2 of the driver interface, Bodkin speaks %3: get the driver that was built for this Bodkin</source>
        <translation>%1 spricht Version %2 der Treiberschnittstelle, Bodkin spricht %3: besorgen Sie den Treiber, der für dieses Bodkin gebaut ist</translation>
    </message>
    <message>
        <source>%1 leaves out its name, its summary or a function of the driver interface: every one but explain is needed</source>
        <translation>%1 fehlt der Name, die Beschreibung oder eine Funktion der Treiberschnittstelle: alle außer explain werden gebraucht</translation>
    </message>
    <message>
        <source>%1 does not speak version %2 of the driver interface: get the driver that was built for this Bodkin</source>
        <translation>%1 spricht nicht Version %2 der Treiberschnittstelle: besorgen Sie den Treiber, der für dieses Bodkin gebaut ist</translation>
    </message>
    <message>
        <source>servo: a function is missing, expected an exchange and a tick</source>
        <translation>Servo: eine Funktion fehlt, erwartet: ein Austausch und ein Takt</translation>
    </message>
    <message>
        <source>servo: the thread was started already</source>
        <translation>Servo: der Faden läuft schon</translation>
    </message>
    <message>
        <source>servo: the controller is empty, expected a function that returns the force</source>
        <translation>Servo: der Regler ist leer, erwartet: eine Funktion, die die Kraft liefert</translation>
    </message>
    <message>
        <source>the device gave %1 readings, expected 20 or more; try again</source>
        <translation>das Gerät gab %1 Messwerte, erwartet: 20 oder mehr; versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the hand covered %1 mm along one axis, expected 20 mm or more; move to every corner of the workspace</source>
        <translation>die Hand legte entlang einer Achse %1 mm zurück, erwartet: 20 mm oder mehr; gehen Sie in jede Ecke des Arbeitsraums</translation>
    </message>
    <message>
        <source>the tool was turned by %1 degrees, expected 20 or more about two axes; swivel it wider while the tip stays in its place</source>
        <translation>das Werkzeug wurde um %1 Grad geschwenkt, erwartet: 20 oder mehr um zwei Achsen; schwenken Sie weiter, während die Spitze an ihrem Platz bleibt</translation>
    </message>
    <message>
        <source>the tip strayed by %1 mm, expected 2 mm or less; put it into a dimple that holds it, and try again</source>
        <translation>die Spitze wich um %1 mm ab, erwartet: höchstens 2 mm; setzen Sie sie in eine Mulde, die sie hält, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the tip moved by %1 mm, expected 1 or less; keep it on the point, and calibrate the tip if it does not stay while the tool turns</source>
        <translation>die Spitze bewegte sich um %1 mm, erwartet: höchstens 1; halten Sie sie auf dem Punkt, und kalibrieren Sie die Spitze, wenn sie beim Drehen des Werkzeugs nicht bleibt</translation>
    </message>
    <message>
        <source>the tool turned by %1 degrees while it was to point straight down, expected 5 or less; hold it still</source>
        <translation>das Werkzeug drehte sich um %1 Grad, während es gerade nach unten zeigen sollte, erwartet: höchstens 5; halten Sie es still</translation>
    </message>
    <message>
        <source>the hand went %1 mm away, expected 40 mm or more; push it straight away from you</source>
        <translation>die Hand ging %1 mm weg, erwartet: 40 mm oder mehr; schieben Sie sie gerade von sich weg</translation>
    </message>
    <message>
        <source>the hand strayed by %1 mm to the side; push it straight away from you, without turning back</source>
        <translation>die Hand wich um %1 mm zur Seite ab; schieben Sie sie gerade von sich weg, ohne umzukehren</translation>
    </message>
    <message>
        <source>the handle seems to weigh %1 N, expected 0 to 5 N; leave it alone while it is weighed, and see that its controller's own gravity compensation is as you use it</source>
        <translation>der Griff scheint %1 N zu wiegen, erwartet: 0 bis 5 N; lassen Sie ihn beim Wiegen los, und sehen Sie nach, ob der Gewichtsausgleich seiner Steuerung so steht, wie Sie ihn benutzen</translation>
    </message>
    <message>
        <source>between lifting and lowering, the handle's weight differs by %1 N; leave it alone while it is weighed</source>
        <translation>gehoben und gesenkt unterscheidet sich der Griff um %1 N; lassen Sie ihn beim Wiegen los</translation>
    </message>
    <message>
        <source>no real-time priority: %1</source>
        <translation>keine Echtzeit-Priorität: %1</translation>
    </message>
    <message>
        <source>memory is not locked: the system limits how much may be</source>
        <translation>der Speicher ist nicht festgehalten: das System begrenzt, wie viel es sein darf</translation>
    </message>
    <message>
        <source>%1; permit it with the line '%2' in /etc/security/limits.d/bodkin.conf, add yourself to the group realtime and log in again</source>
        <translation>%1; erlauben Sie es mit der Zeile „%2“ in /etc/security/limits.d/bodkin.conf, nehmen Sie sich in die Gruppe realtime auf und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>the vendor's software has not returned from %1 for %2 s: unplug the device, plug it in and start Bodkin again</source>
        <translation>die Software des Herstellers ist seit %2 s nicht zurückgekommen von: %1. Ziehen Sie das Gerät ab, stecken Sie es ein und starten Sie Bodkin neu</translation>
    </message>
    <message>
        <source>looking for devices</source>
        <translation>Suche nach Geräten</translation>
    </message>
    <message>
        <source>the library of %1 is not here (looked for %2): %3</source>
        <translation>die Bibliothek von %1 ist nicht hier (gesucht: %2): %3</translation>
    </message>
    <message>
        <source>the library of %1 does not load (%2): %3</source>
        <translation>die Bibliothek von %1 lässt sich nicht laden (%2): %3</translation>
    </message>
    <message>
        <source>%1 has no function %2, which Bodkin needs: %3</source>
        <translation>%1 hat keine Funktion %2, die Bodkin braucht: %3</translation>
    </message>
    <message>
        <source>the setting '%1' is not of the form key=value</source>
        <translation>die Einstellung „%1“ hat nicht die Form Name=Wert</translation>
    </message>
    <message>
        <source>the setting '%1' lacks its second quotation mark</source>
        <translation>der Einstellung „%1“ fehlt das zweite Anführungszeichen</translation>
    </message>
    <message>
        <source>there is no setting '%1', expected %2</source>
        <translation>es gibt keine Einstellung „%1“, erwartet: %2</translation>
    </message>
    <message>
        <source>the setting %1 is '%2', expected a number from %3 to %4</source>
        <translation>die Einstellung %1 ist „%2“, erwartet: eine Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>the setting %1 is '%2', expected yes or no</source>
        <translation>die Einstellung %1 ist „%2“, erwartet: yes oder no</translation>
    </message>
    <message>
        <source>close the other program that uses the device</source>
        <translation>schließen Sie das andere Programm, das das Gerät benutzt</translation>
    </message>
    <message>
        <source>close the other program that uses it</source>
        <translation>schließen Sie das andere Programm, das es benutzt</translation>
    </message>
    <message>
        <source>connect it and switch it on, and see that you may open USB devices (the SDK's udev rules)</source>
        <translation>schließen Sie es an, schalten Sie es ein, und sehen Sie nach, ob Sie USB-Geräte öffnen dürfen (udev-Regeln des SDK)</translation>
    </message>
    <message>
        <source>see whether the vendor's own test program works</source>
        <translation>prüfen Sie, ob das Testprogramm des Herstellers läuft</translation>
    </message>
    <message>
        <source>%1 is version %2, expected 3.14 or newer: install a newer Force Dimension SDK</source>
        <translation>%1 hat Version %2, erwartet: 3.14 oder neuer; installieren Sie ein neueres Force Dimension SDK</translation>
    </message>
    <message>
        <source>no Force Dimension device is found: %1</source>
        <translation>kein Gerät von Force Dimension gefunden: %1</translation>
    </message>
    <message>
        <source>the device does not open</source>
        <translation>das Gerät lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>no free Force Dimension device has the serial number %1: see `bodkin devices list` for those that are connected</source>
        <translation>kein freies Gerät von Force Dimension hat die Seriennummer %1: `bodkin devices list` zeigt die angeschlossenen</translation>
    </message>
    <message>
        <source>forces cannot be enabled</source>
        <translation>Kräfte lassen sich nicht einschalten</translation>
    </message>
    <message>
        <source>the device does not stop</source>
        <translation>das Gerät hält nicht an</translation>
    </message>
    <message>
        <source>forces are off: %1</source>
        <translation>die Kräfte sind aus: %1</translation>
    </message>
    <message>
        <source>forces are off for reason %1</source>
        <translation>die Kräfte sind aus, Grund %1</translation>
    </message>
    <message>
        <source>the force button was pressed</source>
        <translation>der Kraftknopf wurde gedrückt</translation>
    </message>
    <message>
        <source>the device was moved too fast</source>
        <translation>das Gerät wurde zu schnell bewegt</translation>
    </message>
    <message>
        <source>the device got no command for 20 ms</source>
        <translation>das Gerät bekam 20 ms lang keinen Befehl</translation>
    </message>
    <message>
        <source>forces were switched off</source>
        <translation>die Kräfte wurden ausgeschaltet</translation>
    </message>
    <message>
        <source>the USB cable was unplugged</source>
        <translation>das USB-Kabel wurde abgezogen</translation>
    </message>
    <message>
        <source>the hand let go</source>
        <translation>die Hand ließ los</translation>
    </message>
    <message>
        <source>the Force Dimension SDK says error %1</source>
        <translation>das Force Dimension SDK meldet Fehler %1</translation>
    </message>
    <message>
        <source>the device cannot calibrate itself</source>
        <translation>das Gerät kann sich nicht selbst kalibrieren</translation>
    </message>
    <message>
        <source>the device is not calibrated: run the vendor's HapticInit, or keep your hands off the device and say initialise=yes (it then moves by itself)</source>
        <translation>das Gerät ist nicht kalibriert: starten Sie HapticInit des Herstellers, oder lassen Sie das Gerät los und sagen Sie initialise=yes (es bewegt sich dann von selbst)</translation>
    </message>
    <message>
        <source>the Falcon is not calibrated: say initialise=yes, and pull its knob out and push it in while it is opened</source>
        <translation>der Falcon ist nicht kalibriert: sagen Sie initialise=yes, und ziehen Sie beim Öffnen seinen Knopf heraus und schieben ihn hinein</translation>
    </message>
    <message>
        <source>the Falcon does not take a force of zero</source>
        <translation>der Falcon nimmt keine Kraft von null an</translation>
    </message>
    <message>
        <source>the Falcon was not calibrated within %1 s: pull its knob out as far as it goes and push it in, and try again</source>
        <translation>der Falcon wurde nicht innerhalb von %1 s kalibriert: ziehen Sie seinen Knopf ganz heraus, schieben Sie ihn hinein, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>install the Force Dimension SDK 3.14 or newer, or say library=PATH</source>
        <translation>installieren Sie das Force Dimension SDK 3.14 oder neuer, oder sagen Sie library=PFAD</translation>
    </message>
    <message>
        <source>omega, delta, sigma, lambda (Force Dimension SDK)</source>
        <translation>omega, delta, sigma, lambda (Force Dimension SDK)</translation>
    </message>
    <message>
        <source>Inverse3, Inverse3x, Minverse with VerseGrip (Haply's Inverse service)</source>
        <translation>Inverse3, Inverse3x, Minverse mit VerseGrip (Inverse-Dienst von Haply)</translation>
    </message>
    <message>
        <source>Virtuose devices (Haption VirtuoseAPI)</source>
        <translation>Virtuose-Geräte (Haption VirtuoseAPI)</translation>
    </message>
    <message>
        <source>Touch and PHANTOM devices (OpenHaptics)</source>
        <translation>Touch- und PHANTOM-Geräte (OpenHaptics)</translation>
    </message>
    <message>
        <source>the mouse in the window of bodkin-app</source>
        <translation>die Maus im Fenster von bodkin-app</translation>
    </message>
    <message>
        <source>the hand of a session file; no force</source>
        <translation>die Hand einer Sitzungsdatei; keine Kraft</translation>
    </message>
    <message>
        <source>any session that you name</source>
        <translation>jede Sitzung, die Sie nennen</translation>
    </message>
    <message>
        <source>no session is named; expected recorded:FILE.bodkin</source>
        <translation>keine Sitzung ist genannt; erwartet: recorded:DATEI.bodkin</translation>
    </message>
    <message>
        <source>recorded hand</source>
        <translation>aufgezeichnete Hand</translation>
    </message>
    <message>
        <source>Haply's Inverse service finds no Inverse3: connect its USB cable and its power supply, and see whether Haply Hub shows it</source>
        <translation>der Inverse-Dienst von Haply findet keinen Inverse3: schließen Sie USB-Kabel und Netzteil an, und sehen Sie nach, ob Haply Hub ihn zeigt</translation>
    </message>
    <message>
        <source>no Inverse3 has the identity %1: see `bodkin devices list` for those that are connected</source>
        <translation>kein Inverse3 hat die Kennung %1: `bodkin devices list` zeigt die angeschlossenen</translation>
    </message>
    <message>
        <source>no VerseGrip has the identity %1: switch it on, or say grip=none</source>
        <translation>kein VerseGrip hat die Kennung %1: schalten Sie ihn ein, oder sagen Sie grip=none</translation>
    </message>
    <message>
        <source>Haply's Inverse service gives the device %1, and forces would point the wrong way: take it back in Haply Hub</source>
        <translation>der Inverse-Dienst von Haply gibt dem Gerät %1, und Kräfte würden in die falsche Richtung zeigen: nehmen Sie das in Haply Hub zurück</translation>
    </message>
    <message>
        <source>Haply's Inverse service does not answer the stop; its session has been ended: restart haply-inverse-service</source>
        <translation>der Inverse-Dienst von Haply antwortet nicht auf den Halt; seine Sitzung wurde beendet: starten Sie haply-inverse-service neu</translation>
    </message>
    <message>
        <source>there is no VerseGrip whose button could be the dead-man's switch: switch the grip on, or say dead_man=none</source>
        <translation>es gibt keinen VerseGrip, dessen Knopf der Totmannschalter sein könnte: schalten Sie den Griff ein, oder sagen Sie dead_man=none</translation>
    </message>
    <message>
        <source>Haply's Inverse service has stopped answering: see whether haply-inverse-service runs, and start again</source>
        <translation>der Inverse-Dienst von Haply antwortet nicht mehr: sehen Sie nach, ob haply-inverse-service läuft, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>Haply's Inverse service no longer lists the device: plug its USB cable in and start again</source>
        <translation>der Inverse-Dienst von Haply führt das Gerät nicht mehr: stecken Sie das USB-Kabel ein und beginnen Sie neu</translation>
    </message>
    <message>
        <source>Haply's Inverse service no longer reports the device's position: check Haply Hub, and start again</source>
        <translation>der Inverse-Dienst von Haply meldet die Lage des Geräts nicht mehr: sehen Sie in Haply Hub nach, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>Haply's Inverse service sent a message that cannot be read: restart haply-inverse-service</source>
        <translation>der Inverse-Dienst von Haply sandte eine unlesbare Nachricht: starten Sie haply-inverse-service neu</translation>
    </message>
    <message>
        <source>the Inverse3 is not calibrated: put its arm into its rest and follow Haply Hub</source>
        <translation>der Inverse3 ist nicht kalibriert: legen Sie seinen Arm in die Ruhelage und folgen Sie Haply Hub</translation>
    </message>
    <message>
        <source>the Inverse3 has no power for its motors: connect its power supply</source>
        <translation>die Motoren des Inverse3 haben keinen Strom: schließen Sie das Netzteil an</translation>
    </message>
    <message>
        <source>the Inverse3's emergency brake is engaged: release it as Haply Hub says, and start again</source>
        <translation>die Notbremse des Inverse3 ist angezogen: lösen Sie sie, wie Haply Hub es sagt, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>Haply's Inverse service has been given a transform, a basis, a preset or a mount of the device meanwhile, and forces would point the wrong way: take it back in Haply Hub</source>
        <translation>dem Inverse-Dienst von Haply wurde inzwischen eine Umrechnung, eine Achsenfolge, eine Voreinstellung oder eine Aufstellung des Geräts gegeben, und Kräfte würden in die falsche Richtung zeigen: nehmen Sie das in Haply Hub zurück</translation>
    </message>
    <message>
        <source>Haply's Inverse service leaves the device idle although forces are sent: say force_key=vector or force_key=values, whichever was not used</source>
        <translation>der Inverse-Dienst von Haply lässt das Gerät ruhen, obwohl Kräfte gesandt werden: sagen Sie force_key=vector oder force_key=values, je nachdem, was nicht benutzt war</translation>
    </message>
    <message>
        <source>what answers at %1 is not Haply's Inverse service (%2): say port=NUMBER for the port of the service</source>
        <translation>was bei %1 antwortet, ist nicht der Inverse-Dienst von Haply (%2): sagen Sie port=NUMMER für den Port des Dienstes</translation>
    </message>
    <message>
        <source>Haply's Inverse service at %1 is version %2, expected 3.0 or newer: install a newer Haply Hub</source>
        <translation>der Inverse-Dienst von Haply bei %1 hat Version %2, erwartet: 3.0 oder neuer; installieren Sie ein neueres Haply Hub</translation>
    </message>
    <message>
        <source>what listens at %1 does not answer as Haply's Inverse service does (%2): %3</source>
        <translation>was bei %1 lauscht, antwortet nicht wie der Inverse-Dienst von Haply (%2): %3</translation>
    </message>
    <message>
        <source>Haply's Inverse service does not answer at %1: install Haply Hub, start the service (systemctl start haply-inverse-service), or say host=NAME port=NUMBER where it is</source>
        <translation>der Inverse-Dienst von Haply antwortet nicht bei %1: installieren Sie Haply Hub, starten Sie den Dienst (systemctl start haply-inverse-service), oder sagen Sie mit host=NAME port=NUMMER, wo er ist</translation>
    </message>
    <message>
        <source>its first message does not come</source>
        <translation>seine erste Nachricht kommt nicht</translation>
    </message>
    <message>
        <source>see whether Haply Hub shows the device, or restart haply-inverse-service</source>
        <translation>sehen Sie nach, ob Haply Hub das Gerät zeigt, oder starten Sie haply-inverse-service neu</translation>
    </message>
    <message>
        <source>%1 is version %2, expected 4 or newer: install a newer VirtuoseAPI</source>
        <translation>%1 hat Version %2, erwartet: 4 oder neuer; installieren Sie eine neuere VirtuoseAPI</translation>
    </message>
    <message>
        <source>install Haption's VirtuoseAPI 4, or say library=PATH</source>
        <translation>installieren Sie die VirtuoseAPI 4 von Haption, oder sagen Sie library=PFAD</translation>
    </message>
    <message>
        <source>switch it on, start the vendor's daemon, or say address=HOST#PORT</source>
        <translation>schalten Sie es ein, starten Sie den Dienst des Herstellers, oder sagen Sie address=RECHNER#PORT</translation>
    </message>
    <message>
        <source>the motors have no power although the handle is held: press the button of the motors' power</source>
        <translation>die Motoren haben keinen Strom, obwohl der Griff gehalten wird: drücken Sie den Knopf für den Strom der Motoren</translation>
    </message>
    <message>
        <source>the emergency stop is open: close it and start again</source>
        <translation>der Not-Aus ist offen: schließen Sie ihn und beginnen Sie neu</translation>
    </message>
    <message>
        <source>the motors are hot: let the device cool</source>
        <translation>die Motoren sind heiß: lassen Sie das Gerät abkühlen</translation>
    </message>
    <message>
        <source>the device reports an error of its position</source>
        <translation>das Gerät meldet einen Fehler seiner Lage</translation>
    </message>
    <message>
        <source>VirtuoseAPI says %1</source>
        <translation>VirtuoseAPI meldet: %1</translation>
    </message>
    <message>
        <source>close the other program that uses the device, or unplug it and plug it in</source>
        <translation>schließen Sie das andere Programm, das das Gerät benutzt, oder ziehen Sie es ab und stecken es wieder ein</translation>
    </message>
    <message>
        <source>connect it, run the vendor's Touch_Setup, and see that you are in the group dialout</source>
        <translation>schließen Sie es an, starten Sie Touch_Setup des Herstellers, und sehen Sie nach, ob Sie in der Gruppe dialout sind</translation>
    </message>
    <message>
        <source>see whether the vendor's Touch_Diagnostic works</source>
        <translation>prüfen Sie, ob Touch_Diagnostic des Herstellers läuft</translation>
    </message>
    <message>
        <source>%1 is version %2, expected 3.0 or newer: install a newer OpenHaptics</source>
        <translation>%1 hat Version %2, erwartet: 3.0 oder neuer; installieren Sie ein neueres OpenHaptics</translation>
    </message>
    <message>
        <source>the encoders of the device are not reset: hold its arm in the reset position that the vendor's manual shows, and give --settings reset_encoders=yes</source>
        <translation>die Geber des Geräts sind nicht zurückgesetzt: halten Sie seinen Arm in der Rücksetzlage aus dem Handbuch des Herstellers, und geben Sie --settings reset_encoders=yes an</translation>
    </message>
    <message>
        <source>the device is not calibrated: put the stylus into its inkwell, then arm</source>
        <translation>das Gerät ist nicht kalibriert: stecken Sie den Griff in seinen Köcher, dann geben Sie frei</translation>
    </message>
    <message>
        <source>OpenHaptics says %1</source>
        <translation>OpenHaptics meldet: %1</translation>
    </message>
    <message>
        <source>install OpenHaptics 3.4 or newer and the Touch device driver, or say library=PATH</source>
        <translation>installieren Sie OpenHaptics 3.4 oder neuer und den Touch-Treiber, oder sagen Sie library=PFAD</translation>
    </message>
    <message>
        <source>a device is open through %1: close it before another library is used</source>
        <translation>über %1 ist ein Gerät offen: schließen Sie es, bevor eine andere Bibliothek benutzt wird</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>no free device: %1</source>
        <translation>kein freies Gerät: %1</translation>
    </message>
    <message>
        <source>the controller at %1 and %2, version %3, do not speak one version (%4): install the VirtuoseAPI that came with the device, and say library=PATH</source>
        <translation>die Steuerung bei %1 und %2, Version %3, sprechen nicht dieselbe Version (%4): installieren Sie die VirtuoseAPI, die mit dem Gerät kam, und sagen Sie library=PFAD</translation>
    </message>
    <message>
        <source>no Virtuose answers at %1 (%2): %3</source>
        <translation>kein Virtuose antwortet bei %1 (%2): %3</translation>
    </message>
    <message>
        <source>the device refuses %1 (%2): see whether the vendor's own test program works</source>
        <translation>das Gerät verweigert: %1 (%2). Prüfen Sie, ob das Testprogramm des Herstellers läuft</translation>
    </message>
    <message>
        <source>the device did not stop (%1): press its emergency stop before you touch it</source>
        <translation>das Gerät hielt nicht an (%1): drücken Sie seinen Not-Aus, bevor Sie es berühren</translation>
    </message>
    <message>
        <source>the device does not open (%1): %2</source>
        <translation>das Gerät lässt sich nicht öffnen (%1): %2</translation>
    </message>
    <message>
        <source>the scheduler of OpenHaptics does not start (%1): see whether the vendor's Touch_Diagnostic works</source>
        <translation>der Zeitgeber von OpenHaptics startet nicht (%1): prüfen Sie, ob Touch_Diagnostic des Herstellers läuft</translation>
    </message>
    <message>
        <source>a simulated hand, for use without a device</source>
        <translation>eine simulierte Hand, für alle ohne Gerät</translation>
    </message>
    <message>
        <source>simulated hand</source>
        <translation>simulierte Hand</translation>
    </message>
    <message>
        <source>the setting depth_mm lies above the start, expected at least -start_mm</source>
        <translation>die Einstellung depth_mm liegt über dem Anfang, erwartet: mindestens -start_mm</translation>
    </message>
    <message>
        <source>spacenavd does not answer at %1 (%2): install and start spacenavd, or say socket=PATH</source>
        <translation>spacenavd antwortet nicht bei %1 (%2): installieren und starten Sie spacenavd, oder sagen Sie socket=PFAD</translation>
    </message>
    <message>
        <source>SpaceMouse and other pucks (spacenavd); no force</source>
        <translation>SpaceMouse und ähnliche Geräte (spacenavd); keine Kraft</translation>
    </message>
    <message>
        <source>spacenavd has closed %1: start it again, and then the session</source>
        <translation>spacenavd hat %1 geschlossen: starten Sie es neu, und dann die Sitzung</translation>
    </message>
    <message>
        <source>the setting axes is '%1', expected each of x, y and z once with its sign, as in x,-z,y</source>
        <translation>die Einstellung axes ist „%1“, erwartet: jedes von x, y und z einmal mit Vorzeichen, wie in x,-z,y</translation>
    </message>
    <message>
        <source>the driver %1</source>
        <translation>der Treiber %1</translation>
    </message>
    <message>
        <source>give the path of a library that exports bodkin_driver_entry</source>
        <translation>nennen Sie den Pfad einer Bibliothek, die bodkin_driver_entry anbietet</translation>
    </message>
    <message>
        <source>servo: no thread can be made: %1</source>
        <translation>Servo: es kann kein Faden begonnen werden: %1</translation>
    </message>
    <message>
        <source>a side of the workspace is not longer than 0 mm, expected a box, or nothing</source>
        <translation>eine Seite des Arbeitsraums ist nicht länger als 0 mm, erwartet: ein Quader, oder nichts</translation>
    </message>
    <message>
        <source>continuous_force_N is 0 N, expected more than 0 N for a device that renders forces</source>
        <translation>continuous_force_N ist 0 N, erwartet: mehr als 0 N bei einem Gerät, das Kräfte darstellt</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels could not be drawn: %3</source>
        <translation>ein Bild von %1 x %2 Bildpunkten konnte nicht gezeichnet werden: %3</translation>
    </message>
    <message>
        <source>a PDF file could not be drawn: %1</source>
        <translation>eine PDF-Datei konnte nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels could not be made into a PNG: %3</source>
        <translation>ein Bild von %1 x %2 Bildpunkten konnte nicht zu einem PNG werden: %3</translation>
    </message>
    <message>
        <source>%1 is not a usable PNG picture: %2</source>
        <translation>%1 ist kein brauchbares PNG-Bild: %2</translation>
    </message>
    <message>
        <source>the case has no CT, which ultrasound is computed from; import the patient again</source>
        <translation>der Fall hat kein CT, aus dem der Ultraschall berechnet wird; importieren Sie den Patienten noch einmal</translation>
    </message>
    <message>
        <source>the case has no tissues, which ultrasound is computed from; import the patient again</source>
        <translation>der Fall hat keine Gewebe, aus denen der Ultraschall berechnet wird; importieren Sie den Patienten noch einmal</translation>
    </message>
    <message>
        <source>the case holds nothing but air, expected a patient; import one whose skin is in the CT</source>
        <translation>der Fall enthält nur Luft, erwartet: ein Patient; importieren Sie einen, dessen Haut im CT liegt</translation>
    </message>
    <message>
        <source>the CT is not in Hounsfield units: its values go from %1 to %2, as a picture's do; %3</source>
        <translation>das CT ist nicht in Hounsfield-Einheiten: seine Werte gehen von %1 bis %2, wie die eines Bildes; %3</translation>
    </message>
    <message>
        <source>the CT is not in Hounsfield units: no value is below %1, though there is air, expected about -1000; %2</source>
        <translation>das CT ist nicht in Hounsfield-Einheiten: kein Wert liegt unter %1, obwohl es Luft gibt, erwartet: etwa -1000; %2</translation>
    </message>
    <message>
        <source>the CT is not in Hounsfield units: soft tissue misses its usual values by %1 on average, expected less than %2; %3</source>
        <translation>das CT ist nicht in Hounsfield-Einheiten: Weichgewebe verfehlt seine üblichen Werte im Mittel um %1, erwartet: weniger als %2; %3</translation>
    </message>
    <message>
        <source>the probe's %1 is %2, expected a direction of finite length that is not zero; give three numbers such as 0 1 0</source>
        <translation>%1 des Schallkopfs ist %2, erwartet: eine Richtung von endlicher Länge, nicht null; geben Sie drei Zahlen an wie 0 1 0</translation>
    </message>
    <message>
        <source>the middle of the probe's face is %1, expected three finite numbers; give its place in the patient in mm</source>
        <translation>die Mitte der Schallkopffläche ist %1, erwartet: drei endliche Zahlen; geben Sie ihren Ort im Patienten in mm an</translation>
    </message>
    <message>
        <source>the probe's marked side %1 is parallel to its direction of view %2, expected one across the other; turn either of them</source>
        <translation>die markierte Seite %1 des Schallkopfs ist parallel zu seiner Blickrichtung %2, erwartet: quer dazu; drehen Sie eine von beiden</translation>
    </message>
    <message>
        <source>ultrasound frequency is %1 MHz, expected %2 to %3 MHz, the band of the probe %4; choose one in between, or 0 for its centre</source>
        <translation>die Ultraschallfrequenz ist %1 MHz, erwartet: %2 bis %3 MHz, das Band des Schallkopfs %4; wählen Sie eine dazwischen, oder 0 für die Mitte</translation>
    </message>
    <message>
        <source>ultrasound has no patient, expected an acoustic volume; make one of a case</source>
        <translation>der Ultraschall hat keinen Patienten, erwartet: ein akustisches Volumen; machen Sie eines aus einem Fall</translation>
    </message>
    <message>
        <source>the patient has %1 x %2 x %3 voxels, expected at least two along each axis for ultrasound; import more of the CT</source>
        <translation>der Patient hat %1 x %2 x %3 Voxel, für den Ultraschall erwartet: mindestens zwei entlang jeder Achse; importieren Sie mehr vom CT</translation>
    </message>
    <message>
        <source>the patient has %1 voxels, expected less than 2^31 for ultrasound; import less of the CT</source>
        <translation>der Patient hat %1 Voxel, für den Ultraschall erwartet: weniger als 2^31; importieren Sie weniger vom CT</translation>
    </message>
    <message>
        <source>the acoustic volume has %1 voxels, expected %2; make it of a case</source>
        <translation>das akustische Volumen hat %1 Voxel, erwartet: %2; machen Sie es aus einem Fall</translation>
    </message>
    <message>
        <source>the case has no structure kidney_left or kidney_right to look at; say where with --at x,y,z</source>
        <translation>der Fall hat keine Struktur kidney_left oder kidney_right zum Ansehen; sagen Sie mit --at x,y,z, wohin</translation>
    </message>
    <message>
        <source>the point %1 to look at is not in the body, expected one inside it, LPS mm</source>
        <translation>der Punkt %1, der betrachtet werden soll, liegt nicht im Körper, erwartet: einer darin, LPS mm</translation>
    </message>
    <message>
        <source>the CT ends before the skin is reached from %1 towards %2; choose another side with --from</source>
        <translation>das CT endet von %1 nach %2 vor der Haut; wählen Sie mit --from eine andere Seite</translation>
    </message>
    <message>
        <source>the case has no planned path, which the view 'needle' looks at; choose another --view</source>
        <translation>der Fall hat keinen geplanten Weg, auf den die Ansicht „needle“ blickt; wählen Sie eine andere mit --view</translation>
    </message>
    <message>
        <source>the planned path runs along the body, so that no probe can stand next to it</source>
        <translation>der geplante Weg läuft am Körper entlang, sodass kein Schallkopf daneben stehen kann</translation>
    </message>
    <message>
        <source>there is no skin next to the planned entry for the probe to stand on; choose another --view</source>
        <translation>neben dem geplanten Eintritt ist keine Haut, auf der der Schallkopf stehen kann; wählen Sie eine andere mit --view</translation>
    </message>
    <message>
        <source>there is no picture to measure in</source>
        <translation>es gibt kein Bild, in dem zu messen wäre</translation>
    </message>
    <message>
        <source>the place to measure is not finite, expected mm in the probe's frame</source>
        <translation>die Messstelle ist nicht endlich, erwartet: mm im Rahmen des Schallkopfs</translation>
    </message>
    <message>
        <source>memory is short for compressing</source>
        <translation>der Speicher reicht nicht zum Packen</translation>
    </message>
    <message>
        <source>the sequence has no frame to write</source>
        <translation>die Sequenz hat kein Bild zum Schreiben</translation>
    </message>
    <message>
        <source>frame %1 of the sequence has %2 pixels, expected %3 x %4</source>
        <translation>Bild %1 der Sequenz hat %2 Bildpunkte, erwartet: %3 x %4</translation>
    </message>
    <message>
        <source>a sweep of %1 frames at %2 a second is none, expected 1 to %3 frames</source>
        <translation>ein Schwenk von %1 Bildern bei %2 je Sekunde ist keiner, erwartet: 1 bis %3 Bilder</translation>
    </message>
    <message>
        <source>volume view: the patient has neither a CT nor tissues; open one that has</source>
        <translation>Volumenansicht: der Patient hat weder CT noch Gewebe; öffnen Sie einen, der sie hat</translation>
    </message>
    <message>
        <source>There is no skin further on: the CT ends here, or the body does.</source>
        <translation>Weiter ist keine Haut: hier endet das CT oder der Körper.</translation>
    </message>
    <message>
        <source>there is no such case folder; 'bodkin case new' and 'bodkin case synthesize' make one</source>
        <translation>diesen Fallordner gibt es nicht; „bodkin case new“ und „bodkin case synthesize“ machen einen</translation>
    </message>
    <message>
        <source>%1 cannot be written: there is no such folder</source>
        <translation>%1 kann nicht geschrieben werden: diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>%1 has changed since the case was made: its digest is %2, expected %3; restore the file or make the case again</source>
        <translation>%1 hat sich geändert, seit der Fall gemacht wurde: die Prüfsumme ist %2, erwartet: %3; stellen Sie die Datei wieder her oder machen Sie den Fall neu</translation>
    </message>
    <message>
        <source>%1; make the case again</source>
        <translation>%1; machen Sie den Fall neu</translation>
    </message>
    <message>
        <source>no file descriptor: %1</source>
        <translation>kein Dateideskriptor: %1</translation>
    </message>
    <message>
        <source>no pipe: %1</source>
        <translation>keine Leitung: %1</translation>
    </message>
    <message>
        <source>no memory for a request: %1</source>
        <translation>kein Speicher für eine Anfrage: %1</translation>
    </message>
    <message>
        <source>the child process wrote a line of more than 16 MiB; it is broken or of another version</source>
        <translation>der Hilfsprozess schrieb eine Zeile von mehr als 16 MiB; er ist defekt oder von anderer Version</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 kann nicht gestartet werden: %2</translation>
    </message>
    <message>
        <source>%1 cannot be started</source>
        <translation>%1 kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>out of memory while reading CSV</source>
        <translation>der Speicher reicht nicht zum Lesen der CSV-Datei</translation>
    </message>
    <message>
        <source>interrupted; nothing was made</source>
        <translation>unterbrochen; nichts wurde gemacht</translation>
    </message>
    <message>
        <source>the quantity %1 needs the resistance %2, found %3</source>
        <translation>die Größe %1 braucht das Kraftmodell %2, gefunden: %3</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>nicht lesbar: %1</translation>
    </message>
    <message>
        <source>the image has %1 voxels; expected at least one</source>
        <translation>das Bild hat %1 Voxel; erwartet: mindestens einer</translation>
    </message>
    <message>
        <source>the header declares %1 voxels; Bodkin reads at most %2 million, so crop or resample the image</source>
        <translation>der Kopf nennt %1 Voxel; Bodkin liest höchstens %2 Millionen, beschneiden Sie das Bild oder rechnen Sie es um</translation>
    </message>
    <message>
        <source>the header declares %1 voxels, but the file is too short to hold them; it is truncated or damaged, copy it again</source>
        <translation>der Kopf nennt %1 Voxel, aber die Datei ist dafür zu kurz; sie ist abgeschnitten oder beschädigt, kopieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>the voxel spacing is %1 x %2 x %3 mm; expected lengths above zero</source>
        <translation>der Abstand der Voxel ist %1 x %2 x %3 mm; erwartet: Längen über null</translation>
    </message>
    <message>
        <source>the voxel spacing is %1 x %2 x %3 mm; expected 0.001 to 100 mm (is the unit mm?)</source>
        <translation>der Abstand der Voxel ist %1 x %2 x %3 mm; erwartet: 0.001 bis 100 mm (ist die Einheit mm?)</translation>
    </message>
    <message>
        <source>the first voxel lies at (%1, %2, %3) mm; expected finite coordinates within a kilometre</source>
        <translation>der erste Voxel liegt bei (%1, %2, %3) mm; erwartet: endliche Koordinaten innerhalb eines Kilometers</translation>
    </message>
    <message>
        <source>the axes of the image are not orthogonal unit vectors; resample it onto a regular grid</source>
        <translation>die Achsen des Bildes sind keine rechtwinkligen Einheitsvektoren; rechnen Sie es auf ein regelmäßiges Gitter um</translation>
    </message>
    <message>
        <source>this needs more memory than Bodkin gives to reading an image; it is damaged, or so large that it must be cropped first</source>
        <translation>dies braucht mehr Speicher, als Bodkin dem Lesen eines Bildes gibt; es ist beschädigt, oder so groß, dass es erst beschnitten werden muss</translation>
    </message>
    <message>
        <source>the imaging library returned an invalid image; the file is damaged</source>
        <translation>die Bildbibliothek gab ein ungültiges Bild zurück; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the file name is not UTF-8 text; rename it</source>
        <translation>der Dateiname ist kein UTF-8-Text; benennen Sie die Datei um</translation>
    </message>
    <message>
        <source>reading this took too long and was given up; it is damaged or far too large</source>
        <translation>das Lesen dauerte zu lange und wurde abgebrochen; die Datei ist beschädigt oder viel zu groß</translation>
    </message>
    <message>
        <source>the imaging library crashed on %1 (%2); it is damaged, or not what its name says</source>
        <translation>die Bildbibliothek stürzte ab bei %1 (%2); es ist beschädigt, oder nicht, was sein Name sagt</translation>
    </message>
    <message>
        <source>a file in this folder</source>
        <translation>einer Datei in diesem Ordner</translation>
    </message>
    <message>
        <source>this file</source>
        <translation>dieser Datei</translation>
    </message>
    <message>
        <source>the imaging library ended on this without a message (exit code %1); it is damaged</source>
        <translation>die Bildbibliothek gab hierbei wortlos auf (Rückgabewert %1); die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>a contour has %1 coordinates; expected three for each point</source>
        <translation>eine Kontur hat %1 Koordinaten; erwartet: drei je Punkt</translation>
    </message>
    <message>
        <source>a contour goes %1 mm away; it is damaged</source>
        <translation>eine Kontur geht %1 mm weit weg; sie ist beschädigt</translation>
    </message>
    <message>
        <source>this structure set cannot be read; it is truncated or damaged</source>
        <translation>dieser Struktursatz kann nicht gelesen werden; er ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the contours do not lie in slices of the CT; give the CT that they were drawn on</source>
        <translation>die Konturen liegen nicht in Schichten des CT; geben Sie das CT an, auf dem sie gezeichnet wurden</translation>
    </message>
    <message>
        <source>this structure set declares more than the file holds; it is damaged</source>
        <translation>dieser Struktursatz nennt mehr, als die Datei enthält; er ist beschädigt</translation>
    </message>
    <message>
        <source>this structure set has no closed contours; expected structures drawn on the CT</source>
        <translation>dieser Struktursatz hat keine geschlossenen Konturen; erwartet: auf dem CT gezeichnete Strukturen</translation>
    </message>
    <message>
        <source>the pixels are stored as %1; expected whole numbers of 8, 16 or 32 bits</source>
        <translation>die Bildpunkte sind als %1 gespeichert; erwartet: ganze Zahlen von 8, 16 oder 32 Bit</translation>
    </message>
    <message>
        <source>a pixel holds %1 numbers (colours); expected one</source>
        <translation>ein Bildpunkt enthält %1 Zahlen (Farben); erwartet: eine</translation>
    </message>
    <message>
        <source>the pixels of this slice cannot be decoded; the file is truncated or damaged, copy it again</source>
        <translation>die Bildpunkte dieser Schicht sind nicht zu entschlüsseln; die Datei ist abgeschnitten oder beschädigt, kopieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>this folder cannot be read: %1</source>
        <translation>dieser Ordner kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>this folder holds more than %1 files; give the folder of one series</source>
        <translation>dieser Ordner enthält mehr als %1 Dateien; geben Sie den Ordner einer Serie an</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>this DICOM segmentation %1</source>
        <translation>diese DICOM-Segmentierung %1</translation>
    </message>
    <message>
        <source>has fewer pixels than its header declares; it is truncated or damaged</source>
        <translation>hat weniger Bildpunkte, als ihr Kopf nennt; sie ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>cannot be read; it is truncated or damaged, copy it again</source>
        <translation>kann nicht gelesen werden; sie ist abgeschnitten oder beschädigt, kopieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>stores %1 bits a pixel; expected 1, 8 or 16</source>
        <translation>speichert %1 Bit je Bildpunkt; erwartet: 1, 8 oder 16</translation>
    </message>
    <message>
        <source>does not say where its frames lie in the patient</source>
        <translation>sagt nicht, wo ihre Bilder im Patienten liegen</translation>
    </message>
    <message>
        <source>has frames that are not stacked straight on each other</source>
        <translation>hat Bilder, die nicht gerade übereinander liegen</translation>
    </message>
    <message>
        <source>has frames at uneven distances</source>
        <translation>hat Bilder in ungleichen Abständen</translation>
    </message>
    <message>
        <source>has frames %1 mm apart, %2 mm being a step</source>
        <translation>hat Bilder im Abstand von %1 mm, bei einem Schritt von %2 mm</translation>
    </message>
    <message>
        <source>declares more than the file holds; it is truncated or damaged</source>
        <translation>nennt mehr, als die Datei enthält; sie ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>has frames that belong to no segment</source>
        <translation>hat Bilder, die zu keinem Segment gehören</translation>
    </message>
    <message>
        <source>the DICOM header cannot be read (files: %1, %2); it is truncated or damaged, copy it again</source>
        <translation>der DICOM-Kopf kann nicht gelesen werden (Dateien: %1, %2); er ist abgeschnitten oder beschädigt, kopieren Sie die Dateien noch einmal</translation>
    </message>
    <message>
        <source>there is no DICOM image here%1; expected %2</source>
        <translation>hier ist kein DICOM-Bild%1; erwartet: %2</translation>
    </message>
    <message>
        <source>label images, a segmentation or a structure set</source>
        <translation>Bilder von Strukturen, eine Segmentierung oder ein Struktursatz</translation>
    </message>
    <message>
        <source>the slices of a CT series</source>
        <translation>die Schichten einer CT-Serie</translation>
    </message>
    <message>
        <source>there is no series %1; expected 1 to %2:
%3</source>
        <translation>es gibt keine Serie %1; erwartet: 1 bis %2:
%3</translation>
    </message>
    <message>
        <source>this folder holds %1 series; say --series N to pick one:
%2</source>
        <translation>dieser Ordner enthält %1 Serien; wählen Sie eine mit --series N:
%2</translation>
    </message>
    <message>
        <source>this is %1 (modality %2), not CT; Bodkin needs HU, so give a CT series</source>
        <translation>dies ist %1 (Modalität %2), kein CT; Bodkin braucht HU, geben Sie eine CT-Serie an</translation>
    </message>
    <message>
        <source>this is an image with %1 frames in one file that do not all say where they lie, or are not parallel; expected an enhanced CT, or convert it to single-frame DICOM or NIfTI first</source>
        <translation>dies ist ein Bild mit %1 Schichten in einer Datei, die nicht alle sagen, wo sie liegen, oder nicht parallel sind; erwartet: ein Enhanced CT, oder wandeln Sie es erst in einzelne DICOM-Dateien oder NIfTI um</translation>
    </message>
    <message>
        <source>the slices do not say where they lie in the patient; expected Image Position, Image Orientation (Patient) and Pixel Spacing</source>
        <translation>die Schichten sagen nicht, wo sie im Patienten liegen; erwartet: Image Position, Image Orientation (Patient) und Pixel Spacing</translation>
    </message>
    <message>
        <source>two different slices lie at %1 mm (%2 and %3); give a folder with one phase of one acquisition</source>
        <translation>zwei verschiedene Schichten liegen bei %1 mm (%2 und %3); geben Sie einen Ordner mit einer Phase einer Aufnahme an</translation>
    </message>
    <message>
        <source>the slices are shifted against each other by %1 degrees, more than any gantry tilts; the positions in the headers are wrong</source>
        <translation>die Schichten sind um %1 Grad gegeneinander verschoben, mehr als sich eine Gantry neigt; die Lagen in den Köpfen sind falsch</translation>
    </message>
    <message>
        <source>a slice is missing %1, where the step is %2 mm instead of %3 mm; %4, or say --fill-missing to interpolate</source>
        <translation>eine Schicht fehlt %1, wo der Schritt %2 mm statt %3 mm beträgt; %4, oder interpolieren Sie mit --fill-missing</translation>
    </message>
    <message>
        <source>%1; its neighbours alone are no regular stack, so it cannot be left out, but --fill-missing interpolates it</source>
        <translation>%1; die Nachbarn allein sind kein regelmäßiger Stapel, weglassen lässt sie sich also nicht, aber --fill-missing interpoliert sie</translation>
    </message>
    <message>
        <source>between %1 and %2 mm</source>
        <translation>zwischen %1 und %2 mm</translation>
    </message>
    <message>
        <source>find the file</source>
        <translation>suchen Sie die Datei</translation>
    </message>
    <message>
        <source>the header of %1 is damaged, copy it again</source>
        <translation>der Kopf von %1 ist beschädigt, kopieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>a DICOM file was handed to the reader of single-file images</source>
        <translation>eine DICOM-Datei kam zum Leser einzelner Bilddateien</translation>
    </message>
    <message>
        <source>the image has %1 dimensions; expected a volume of 3</source>
        <translation>das Bild hat %1 Dimensionen; erwartet: ein Volumen mit 3</translation>
    </message>
    <message>
        <source>the image has %1 frames or channels along axis %2; expected a volume of 3 dimensions</source>
        <translation>das Bild hat %1 Bilder oder Kanäle entlang Achse %2; erwartet: ein Volumen mit 3 Dimensionen</translation>
    </message>
    <message>
        <source>the voxels cannot be read; the file is truncated or damaged</source>
        <translation>die Voxel können nicht gelesen werden; die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the voxels are of type '%1'; expected one number a voxel</source>
        <translation>die Voxel sind vom Typ „%1“; erwartet: eine Zahl je Voxel</translation>
    </message>
    <message>
        <source>a voxel holds %1 numbers (colours or vectors); expected one</source>
        <translation>ein Voxel enthält %1 Zahlen (Farben oder Vektoren); erwartet: eine</translation>
    </message>
    <message>
        <source>this is a DICOM file; give the folder that holds its series</source>
        <translation>dies ist eine DICOM-Datei; geben Sie den Ordner an, der ihre Serie enthält</translation>
    </message>
    <message>
        <source>this %1 file cannot be read; it is truncated or damaged (%2)</source>
        <translation>diese %1-Datei kann nicht gelesen werden; sie ist abgeschnitten oder beschädigt (%2)</translation>
    </message>
    <message>
        <source>this file cannot be opened; check its permissions</source>
        <translation>diese Datei lässt sich nicht öffnen; prüfen Sie ihre Rechte</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>this is a folder where an image file was expected</source>
        <translation>dies ist ein Ordner, erwartet wurde eine Bilddatei</translation>
    </message>
    <message>
        <source>this is not an ordinary file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>this file is empty</source>
        <translation>diese Datei ist leer</translation>
    </message>
    <message>
        <source>this is not an image that Bodkin reads; expected DICOM, NIfTI (.nii, .nii.gz), NRRD or MetaImage (.mha, .mhd)</source>
        <translation>dies ist kein Bild, das Bodkin liest; erwartet: DICOM, NIfTI (.nii, .nii.gz), NRRD oder MetaImage (.mha, .mhd)</translation>
    </message>
    <message>
        <source>this folder holds %1 segmentations; give the file of one of them:%2</source>
        <translation>dieser Ordner enthält %1 Segmentierungen; geben Sie die Datei einer davon an:%2</translation>
    </message>
    <message>
        <source>a structure set has contours, not voxels; give it as --labels of its CT</source>
        <translation>ein Struktursatz hat Konturen, keine Voxel; geben Sie ihn als --labels zu seinem CT an</translation>
    </message>
    <message>
        <source>--series picks a series of a DICOM folder; this is one file</source>
        <translation>--series wählt eine Serie eines DICOM-Ordners; dies ist eine Datei</translation>
    </message>
    <message>
        <source>a voxel holds %1; expected %2, whole numbers from 0 to %3</source>
        <translation>ein Voxel enthält %1; erwartet: %2, ganze Zahlen von 0 bis %3</translation>
    </message>
    <message>
        <source>the values run from %1 to %2 and are not HU, in which air is -1000 and fat about -100; give the original CT, or say --assume-hu to take them as they are</source>
        <translation>die Werte laufen von %1 bis %2 und sind keine HU, in denen Luft -1000 ist und Fett etwa -100; geben Sie das ursprüngliche CT an, oder nehmen Sie sie mit --assume-hu, wie sie sind</translation>
    </message>
    <message>
        <source>this file cannot be opened</source>
        <translation>diese Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the gzip stream is damaged; copy the file again</source>
        <translation>der gzip-Strom ist beschädigt; kopieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>the file ends after %1 of the 348 bytes of a NIfTI header; copy it again</source>
        <translation>die Datei endet nach %1 der 348 Byte eines NIfTI-Kopfs; kopieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>the NIfTI header declares %1 dimensions; expected 3</source>
        <translation>der NIfTI-Kopf nennt %1 Dimensionen; erwartet: 3</translation>
    </message>
    <message>
        <source>the NIfTI header declares %1 voxels along axis %2; expected at least 1</source>
        <translation>der NIfTI-Kopf nennt %1 Voxel entlang Achse %2; erwartet: mindestens 1</translation>
    </message>
    <message>
        <source>the voxel spacing along axis %1 is %2 mm (pixdim[%3]); expected a length above zero</source>
        <translation>der Abstand der Voxel entlang Achse %1 ist %2 mm (pixdim[%3]); erwartet: eine Länge über null</translation>
    </message>
    <message>
        <source>the affine holds %1 (srow, row %2, column %3); expected finite numbers</source>
        <translation>die Abbildung enthält %1 (srow, Zeile %2, Spalte %3); erwartet: endliche Zahlen</translation>
    </message>
    <message>
        <source>the affine gives axis %1 no length (srow); expected a length above zero</source>
        <translation>die Abbildung gibt der Achse %1 keine Länge (srow); erwartet: eine Länge über null</translation>
    </message>
    <message>
        <source>the affine says %1 mm along axis %2 and pixdim says %3 mm; one of them is wrong, write the file anew with the program that made it</source>
        <translation>die Abbildung sagt %1 mm entlang Achse %2 und pixdim %3 mm; eines davon ist falsch, schreiben Sie die Datei mit dem Programm neu, das sie gemacht hat</translation>
    </message>
    <message>
        <source>the affine is sheared, axes %1 and %2 meet at %3 degrees instead of 90; give the DICOM series, or resample the image onto a regular grid</source>
        <translation>die Abbildung ist geschert, die Achsen %1 und %2 treffen sich unter %3 Grad statt 90; geben Sie die DICOM-Serie an, oder rechnen Sie das Bild auf ein regelmäßiges Gitter um</translation>
    </message>
    <message>
        <source>the affine holds %1 (quatern or qoffset); expected finite numbers</source>
        <translation>die Abbildung enthält %1 (quatern oder qoffset); erwartet: endliche Zahlen</translation>
    </message>
    <message>
        <source>the voxels are %1 (NIfTI datatype %2); expected one number a voxel</source>
        <translation>die Voxel sind %1 (NIfTI-Datentyp %2); erwartet: eine Zahl je Voxel</translation>
    </message>
    <message>
        <source>this is NIfTI-2, which Bodkin does not read; save it as NIfTI-1, NRRD or MetaImage</source>
        <translation>dies ist NIfTI-2, das Bodkin nicht liest; speichern Sie es als NIfTI-1, NRRD oder MetaImage</translation>
    </message>
    <message>
        <source>this is a gzip file without a NIfTI image inside; expected .nii.gz</source>
        <translation>dies ist eine gzip-Datei ohne NIfTI-Bild darin; erwartet: .nii.gz</translation>
    </message>
    <message>
        <source>this is an Analyze image or a .hdr/.img pair; save it as one NIfTI file (.nii or .nii.gz)</source>
        <translation>dies ist ein Analyze-Bild oder ein Paar .hdr/.img; speichern Sie es als eine NIfTI-Datei (.nii oder .nii.gz)</translation>
    </message>
    <message>
        <source>the file does not say where it lies in the patient (sform_code and qform_code are 0); write it anew with its orientation</source>
        <translation>die Datei sagt nicht, wo sie im Patienten liegt (sform_code und qform_code sind 0); schreiben Sie sie mit ihrer Lage neu</translation>
    </message>
    <message>
        <source>the voxels start at byte %1 (vox_offset); expected 352 or more</source>
        <translation>die Voxel beginnen bei Byte %1 (vox_offset); erwartet: 352 oder mehr</translation>
    </message>
    <message>
        <source>the gzip stream is truncated or damaged; copy the file again</source>
        <translation>der gzip-Strom ist abgeschnitten oder beschädigt; kopieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>'%1' is '%2'; expected finite numbers</source>
        <translation>„%1“ ist „%2“; erwartet: endliche Zahlen</translation>
    </message>
    <message>
        <source>the voxel spacing '%1' is '%2'; expected lengths above zero</source>
        <translation>der Abstand der Voxel „%1“ ist „%2“; erwartet: Längen über null</translation>
    </message>
    <message>
        <source>the header has no '%1'; the file is damaged</source>
        <translation>dem Kopf fehlt „%1“; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the header declares '%1: %2'; expected 1 to 1000000 voxels along each axis</source>
        <translation>der Kopf nennt „%1: %2“; erwartet: 1 bis 1000000 Voxel entlang jeder Achse</translation>
    </message>
    <message>
        <source>'ElementType' is '%1'; expected one number a voxel, MET_SHORT for example</source>
        <translation>„ElementType“ ist „%1“; erwartet: eine Zahl je Voxel, etwa MET_SHORT</translation>
    </message>
    <message>
        <source>the voxels are said to be in '%1'; only one file in the same folder is read, so store header and voxels in one file</source>
        <translation>die Voxel sollen in „%1“ sein; gelesen wird nur eine Datei im selben Ordner, speichern Sie also Kopf und Voxel in einer Datei</translation>
    </message>
    <message>
        <source>the voxels are said to be in '%1', which is not there</source>
        <translation>die Voxel sollen in „%1“ sein, das es nicht gibt</translation>
    </message>
    <message>
        <source>the packed voxels are truncated or damaged; copy the file again</source>
        <translation>die gepackten Voxel sind abgeschnitten oder beschädigt; kopieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>the header does not say where the image lies in the patient; expected 'space: left-posterior-superior' (or RAS, LAS) with 'space directions' and 'space origin'</source>
        <translation>der Kopf sagt nicht, wo das Bild im Patienten liegt; erwartet: „space: left-posterior-superior“ (oder RAS, LAS) mit „space directions“ und „space origin“</translation>
    </message>
    <message>
        <source>the encoding is '%1'; expected raw, gzip, ascii or hex</source>
        <translation>die Kodierung ist „%1“; erwartet: raw, gzip, ascii oder hex</translation>
    </message>
    <message>
        <source>the MetaImage header has no 'ElementDataFile'; the file is damaged</source>
        <translation>dem MetaImage-Kopf fehlt „ElementDataFile“; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the header does not say how large a voxel is; expected 'ElementSpacing'</source>
        <translation>der Kopf sagt nicht, wie groß ein Voxel ist; erwartet: „ElementSpacing“</translation>
    </message>
    <message>
        <source>every voxel is 0, so nothing is labelled; give a segmentation of this CT</source>
        <translation>jeder Voxel ist 0, nichts ist also benannt; geben Sie eine Segmentierung dieses CT an</translation>
    </message>
    <message>
        <source>the labels do not lie on the CT's voxels%1: they are %2, the CT is %3; give the labels of this CT, or say --resample-labels to take the nearest label at each CT voxel</source>
        <translation>die Strukturen liegen nicht auf den Voxeln des CT%1: sie sind %2, das CT ist %3; geben Sie die Strukturen dieses CT an, oder nehmen Sie mit --resample-labels an jedem CT-Voxel die nächste</translation>
    </message>
    <message>
        <source>no labelled voxel lies inside the CT: the labels are %1, the CT is %2; give the labels of this CT</source>
        <translation>kein benannter Voxel liegt im CT: die Strukturen sind %1, das CT ist %2; geben Sie die Strukturen dieses CT an</translation>
    </message>
    <message>
        <source>label scheme is %1, expected totalsegmentator, totalsegmentator_v1, tptbox or the path of a CSV file with the columns %2</source>
        <translation>das Schema der Strukturen ist %1, erwartet: totalsegmentator, totalsegmentator_v1, tptbox oder der Pfad einer CSV-Datei mit den Spalten %2</translation>
    </message>
    <message>
        <source>the mesh has the ending '%1', expected .msh (Gmsh) or .vtu (VTK)</source>
        <translation>das Netz hat die Endung „%1“, erwartet: .msh (Gmsh) oder .vtu (VTK)</translation>
    </message>
    <message>
        <source>node %1 has the coordinate %2, expected numbers within %3 mm</source>
        <translation>Knoten %1 hat die Koordinate %2, erwartet: Zahlen innerhalb von %3 mm</translation>
    </message>
    <message>
        <source>%1 has the node at position %2, but there are only %3 nodes</source>
        <translation>%1 hat den Knoten an Stelle %2, aber es gibt nur %3 Knoten</translation>
    </message>
    <message>
        <source>%1 has one node twice, expected four different ones</source>
        <translation>%1 hat einen Knoten zweimal, erwartet: vier verschiedene</translation>
    </message>
    <message>
        <source>there are no tetrahedra in this mesh</source>
        <translation>in diesem Netz sind keine Tetraeder</translation>
    </message>
    <message>
        <source>%1 is not base64</source>
        <translation>%1 ist kein base64</translation>
    </message>
    <message>
        <source>the data ends too early</source>
        <translation>die Daten enden zu früh</translation>
    </message>
    <message>
        <source>a packed block says that it holds %1 bytes, which is impossible</source>
        <translation>ein gepackter Block nennt %1 Byte, was nicht sein kann</translation>
    </message>
    <message>
        <source>a packed block is damaged</source>
        <translation>ein gepackter Block ist beschädigt</translation>
    </message>
    <message>
        <source>the data says that it has %1 bytes, expected at most %2</source>
        <translation>die Daten nennen %1 Byte, erwartet: höchstens %2</translation>
    </message>
    <message>
        <source>the data has %1 bytes, which is not a whole number of %2</source>
        <translation>die Daten haben %1 Byte, was keine ganze Zahl von %2 ist</translation>
    </message>
    <message>
        <source>value %1 is %2, expected a %3number</source>
        <translation>Wert %1 ist %2, erwartet: eine %3Zahl</translation>
    </message>
    <message>
        <source>there are more than %1 values</source>
        <translation>es gibt mehr als %1 Werte</translation>
    </message>
    <message>
        <source>%1 has the type %2, expected one of %3numbers such as %4</source>
        <translation>%1 hat den Typ %2, erwartet: eine %3Zahl wie %4</translation>
    </message>
    <message>
        <source>%1 is stored as big-endian binary, expected little-endian or ascii</source>
        <translation>%1 ist binär mit hohem Byte zuerst gespeichert, erwartet: niedriges Byte zuerst, oder ASCII</translation>
    </message>
    <message>
        <source>%1 begins at %2, behind the end of the appended data</source>
        <translation>%1 beginnt bei %2, hinter dem Ende der angehängten Daten</translation>
    </message>
    <message>
        <source>%1 has the format %2, expected ascii, binary or appended</source>
        <translation>%1 hat das Format %2, erwartet: ascii, binary oder appended</translation>
    </message>
    <message>
        <source>%1 has %2 values, expected %3</source>
        <translation>%1 hat %2 Werte, erwartet: %3</translation>
    </message>
    <message>
        <source>the appended data does not begin with '_', or does not end</source>
        <translation>die angehängten Daten beginnen nicht mit „_“, oder enden nicht</translation>
    </message>
    <message>
        <source>out of memory while reading %1</source>
        <translation>der Speicher reicht nicht zum Lesen von %1</translation>
    </message>
    <message>
        <source>%1 has the offset %2, expected %3 to %4</source>
        <translation>%1 hat den Versatz %2, erwartet: %3 bis %4</translation>
    </message>
    <message>
        <source>%1 has the type %2 and %3 nodes, expected tetrahedra%4 (type 10, 4 nodes)</source>
        <translation>%1 hat den Typ %2 und %3 Knoten, erwartet: Tetraeder%4 (Typ 10, 4 Knoten)</translation>
    </message>
    <message>
        <source>%1 has the node %2, expected 0 to %3</source>
        <translation>%1 hat den Knoten %2, erwartet: 0 bis %3</translation>
    </message>
    <message>
        <source>%1 has the region %2, expected a whole number</source>
        <translation>%1 hat die Region %2, erwartet: eine ganze Zahl</translation>
    </message>
    <message>
        <source>the file is larger than 2 GB</source>
        <translation>die Datei ist größer als 2 GB</translation>
    </message>
    <message>
        <source>the packed voxels %1; restore the file or make the case again</source>
        <translation>die gepackten Voxel %1; stellen Sie die Datei wieder her oder machen Sie den Fall neu</translation>
    </message>
    <message>
        <source>are followed by other bytes</source>
        <translation>sind von anderen Bytes gefolgt</translation>
    </message>
    <message>
        <source>are truncated or damaged</source>
        <translation>sind abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>are not as many as the header declares</source>
        <translation>sind nicht so viele, wie der Kopf nennt</translation>
    </message>
    <message>
        <source>are truncated or damaged, or are not as many as the header declares</source>
        <translation>sind abgeschnitten oder beschädigt, oder nicht so viele, wie der Kopf nennt</translation>
    </message>
    <message>
        <source>the file cannot be read to its end</source>
        <translation>die Datei lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>the folder %1 in which the case should be made does not exist; make it first</source>
        <translation>den Ordner %1, in dem der Fall entstehen soll, gibt es nicht; legen Sie ihn erst an</translation>
    </message>
    <message>
        <source>this is already there; choose another folder, or say --overwrite to replace it</source>
        <translation>das gibt es schon; wählen Sie einen anderen Ordner, oder ersetzen Sie es mit --overwrite</translation>
    </message>
    <message>
        <source>--overwrite replaces only a case folder, and this has no case.xml</source>
        <translation>--overwrite ersetzt nur einen Fallordner, und dieser hat keine case.xml</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>%1 cannot be put in its place: %2</source>
        <translation>%1 kann nicht an seinen Platz gelegt werden: %2</translation>
    </message>
    <message>
        <source>"%1" is %2, expected a number from %3 to %4</source>
        <translation>„%1“ ist %2, erwartet: eine Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>this is not a JSON object, expected a registration that 'bodkin register -o' wrote</source>
        <translation>dies ist kein JSON-Objekt, erwartet: eine Registrierung, die „bodkin register -o“ geschrieben hat</translation>
    </message>
    <message>
        <source>"fixed_from_moving" is not a rigid placement, expected 16 numbers, a 4 x 4 matrix row by row in mm, as 'bodkin register -o' writes it</source>
        <translation>„fixed_from_moving“ ist keine starre Lage, erwartet: 16 Zahlen, eine 4 x 4-Matrix Zeile für Zeile in mm, wie „bodkin register -o“ sie schreibt</translation>
    </message>
    <message>
        <source>its scale is %1, expected 1; %2</source>
        <translation>der Maßstab ist %1, erwartet: 1; %2</translation>
    </message>
    <message>
        <source>register without --scale</source>
        <translation>registrieren Sie ohne --scale</translation>
    </message>
    <message>
        <source>cannot be read, expected a recorder log (.xml) or a sequence (.igs.mha)</source>
        <translation>nicht lesbar, erwartet: ein Protokoll (.xml) oder eine Sequenz (.igs.mha)</translation>
    </message>
    <message>
        <source>the transform is %1, expected 16 numbers, row by row</source>
        <translation>die Abbildung ist %1, erwartet: 16 Zahlen, Zeile für Zeile</translation>
    </message>
    <message>
        <source>the transform %1 is not a rotation and translation; expected one without scale, shear or mirror</source>
        <translation>die Abbildung %1 ist keine Drehung und Verschiebung; erwartet: eine ohne Maßstab, Scherung oder Spiegelung</translation>
    </message>
    <message>
        <source>there is no ultrasound probe %1, expected one of: %2</source>
        <translation>es gibt keinen Schallkopf %1, erwartet: einer von: %2</translation>
    </message>
    <message>
        <source>the time is not finite, expected seconds and nanoseconds</source>
        <translation>die Zeit ist nicht endlich, erwartet: Sekunden und Nanosekunden</translation>
    </message>
    <message>
        <source>'%1' is missing from this installation of Bodkin (looked in %2); install Bodkin again, or let BODKIN_SHARE name the folder share/bodkin</source>
        <translation>„%1“ fehlt in dieser Installation von Bodkin (gesucht in %2); installieren Sie Bodkin neu, oder lassen Sie BODKIN_SHARE den Ordner share/bodkin nennen</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>dies ist keine Datei</translation>
    </message>
    <message>
        <source>the file cannot be opened for reading</source>
        <translation>die Datei lässt sich nicht zum Lesen öffnen</translation>
    </message>
    <message>
        <source>the file is larger than the %1 kB that such a file may have</source>
        <translation>die Datei ist größer als die %1 kB, die eine solche Datei haben darf</translation>
    </message>
    <message>
        <source>%1 is '%2', expected a file name inside the case folder, without '..' or a leading '/'</source>
        <translation>%1 ist „%2“, erwartet: ein Dateiname im Fallordner, ohne „..“ oder führendes „/“</translation>
    </message>
    <message>
        <source>%1 file is %2, expected a file name inside the case folder, without '..' or a leading '/'</source>
        <translation>Datei von %1 ist %2, erwartet: ein Dateiname im Fallordner, ohne „..“ oder führendes „/“</translation>
    </message>
    <message>
        <source>%1 is '%2', but %3 does not exist</source>
        <translation>%1 ist „%2“, aber %3 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is '%2', a link that leads out of the case folder; put the file itself there</source>
        <translation>%1 ist „%2“, eine Verknüpfung aus dem Fallordner heraus; legen Sie die Datei selbst dorthin</translation>
    </message>
    <message>
        <source>%1 is '%2', which is not a file</source>
        <translation>%1 ist „%2“, was keine Datei ist</translation>
    </message>
    <message>
        <source>no file in memory for a child process: %1</source>
        <translation>keine Datei im Speicher für einen Hilfsprozess: %1</translation>
    </message>
    <message>
        <source>memory is short for the input of a child process</source>
        <translation>der Speicher reicht nicht für die Eingabe eines Hilfsprozesses</translation>
    </message>
    <message>
        <source>the program '%1' cannot be started (%2); install it with: apt-get install %3</source>
        <translation>das Programm „%1“ kann nicht gestartet werden (%2); installieren Sie es mit: apt-get install %3</translation>
    </message>
    <message>
        <source>cannot be opened; expected a file that can be read</source>
        <translation>lässt sich nicht öffnen; erwartet: eine lesbare Datei</translation>
    </message>
    <message>
        <source>the time is %1, expected a number of seconds</source>
        <translation>die Zeit ist %1, erwartet: eine Zahl von Sekunden</translation>
    </message>
    <message>
        <source>this is not a sequence of PLUS; expected .igs.mha, .igs.nrrd or a recorder log in XML</source>
        <translation>dies ist keine Sequenz von PLUS; erwartet: .igs.mha, .igs.nrrd oder ein Protokoll in XML</translation>
    </message>
    <message>
        <source>there is no pose for a sequence, expected at least one</source>
        <translation>es gibt keine Lage für eine Sequenz, erwartet: mindestens eine</translation>
    </message>
    <message>
        <source>no shared memory: %1</source>
        <translation>kein gemeinsamer Speicher: %1</translation>
    </message>
    <message>
        <source>shared memory ends too early</source>
        <translation>der gemeinsame Speicher endet zu früh</translation>
    </message>
    <message>
        <source>no temporary folder can be made in %1; set TMPDIR to a folder with room</source>
        <translation>in %1 lässt sich kein Ordner für Zwischenergebnisse anlegen; setzen Sie TMPDIR auf einen Ordner mit Platz</translation>
    </message>
    <message>
        <source>%1 is missing: it is neither next to the program (%2) nor in %3; build Bodkin with %4=ON or name it in %5</source>
        <translation>%1 fehlt: es ist weder neben dem Programm (%2) noch in %3; bauen Sie Bodkin mit %4=ON oder nennen Sie es in %5</translation>
    </message>
    <message>
        <source>out of memory while reading XML</source>
        <translation>der Speicher reicht nicht zum Lesen von XML</translation>
    </message>
    <message>
        <source>out of memory while reading the schema %1</source>
        <translation>der Speicher reicht nicht zum Lesen des Schemas %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>out of memory while checking %1</source>
        <translation>der Speicher reicht nicht zum Prüfen von %1</translation>
    </message>
    <message>
        <source>the schema check failed to run</source>
        <translation>die Prüfung gegen das Schema lief nicht</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2, %3: found '%4', expected a number</source>
        <translation>%1, Zeile %2, %3: gefunden „%4“, erwartet: eine Zahl</translation>
    </message>
    <message>
        <source>%1, line %2: there are %3 fields, expected %4</source>
        <translation>%1, Zeile %2: es gibt %3 Felder, erwartet: %4</translation>
    </message>
    <message>
        <source>out of memory while writing XML</source>
        <translation>der Speicher reicht nicht zum Schreiben von XML</translation>
    </message>
    <message>
        <source>the smallest side of the reach is %1 mm, expected more than 0</source>
        <translation>die kleinste Seite der Reichweite ist %1 mm, erwartet: mehr als 0</translation>
    </message>
    <message>
        <source>the axis has the length %1, expected 1</source>
        <translation>die Achse hat die Länge %1, erwartet: 1</translation>
    </message>
    <message>
        <source>a second calibration of %1 %2 %3, expected one of every device</source>
        <translation>eine zweite Kalibrierung von %1 %2 %3, erwartet: eine je Gerät</translation>
    </message>
    <message>
        <source>%1 has voxels with the label%2 %3, which case.xml does not list as a structure</source>
        <translation>%1 hat Voxel mit der Nummer%2 %3, die case.xml nicht als Struktur nennt</translation>
    </message>
    <message>
        <source>%1 has voxels with the tissue id%2 %3, which the tissue library does not have</source>
        <translation>%1 hat Voxel mit der Gewebenummer%2 %3, die die Gewebesammlung nicht hat</translation>
    </message>
    <message>
        <source>%1 holds nothing but air</source>
        <translation>%1 enthält nur Luft</translation>
    </message>
    <message>
        <source>the planned path lies in air from its entry to its target; it misses the body</source>
        <translation>der geplante Weg liegt vom Eintritt bis zum Ziel in der Luft; er verfehlt den Körper</translation>
    </message>
    <message>
        <source>the entry %1 of the planned path lies %2 mm in front of the skin, expected on it</source>
        <translation>der Eintritt %1 des geplanten Wegs liegt %2 mm vor der Haut, erwartet: auf ihr</translation>
    </message>
    <message>
        <source>the entry %1 of the planned path lies %2 mm under the skin, expected on it</source>
        <translation>der Eintritt %1 des geplanten Wegs liegt %2 mm unter der Haut, erwartet: auf ihr</translation>
    </message>
    <message>
        <source>the planned path goes into the spinal cord %1 mm from its entry; plan it below the conus, at L2/L3 or lower</source>
        <translation>der geplante Weg geht %1 mm hinter dem Eintritt ins Rückenmark; planen Sie ihn unterhalb des Conus, bei L2/L3 oder tiefer</translation>
    </message>
    <message>
        <source>%1 (%2 voxels, axes %3, from %4) does not lie on the lattice of %5 (%6 voxels, axes %7, from %8)</source>
        <translation>%1 (%2 Voxel, Achsen %3, von %4) liegt nicht auf dem Gitter von %5 (%6 Voxel, Achsen %7, von %8)</translation>
    </message>
    <message>
        <source>%1 does not cover the same box as %2: a corner lies %3 mm off</source>
        <translation>%1 deckt nicht denselben Quader wie %2: eine Ecke liegt %3 mm daneben</translation>
    </message>
    <message>
        <source>the planned path is %1 mm long, but the needle length_mm is %2; take a longer needle or a nearer target</source>
        <translation>der geplante Weg ist %1 mm lang, aber length_mm der Nadel ist %2; nehmen Sie eine längere Nadel oder ein näheres Ziel</translation>
    </message>
    <message>
        <source>the %1 %2 of the planned path lies outside the image</source>
        <translation>%1 %2 des geplanten Wegs liegt außerhalb des Bildes</translation>
    </message>
    <message>
        <source>the planned path does not meet the target_tissue '%1' within the target_tolerance_mm of %2 after its target</source>
        <translation>der geplante Weg trifft das target_tissue „%1“ nicht innerhalb der target_tolerance_mm von %2 hinter seinem Ziel</translation>
    </message>
    <message>
        <source>structure label is %1, which line %2 uses already</source>
        <translation>die Nummer der Struktur ist %1, die Zeile %2 schon benutzt</translation>
    </message>
    <message>
        <source>needle has one of outer_diameter_mm and inner_diameter_mm, expected both or neither (a solid needle has an inner_diameter_mm of 0)</source>
        <translation>die Nadel hat eines von outer_diameter_mm und inner_diameter_mm, erwartet: beide oder keines (eine volle Nadel hat inner_diameter_mm 0)</translation>
    </message>
    <message>
        <source>needle gauge is %1, expected 10 to 34, or outer_diameter_mm and inner_diameter_mm beside it</source>
        <translation>die Nadelstärke (gauge) ist %1, erwartet: 10 bis 34, oder daneben outer_diameter_mm und inner_diameter_mm</translation>
    </message>
    <message>
        <source>landmark name is %1, which line %2 uses already</source>
        <translation>der Name der Landmarke ist %1, den Zeile %2 schon benutzt</translation>
    </message>
    <message>
        <source>target is %1 mm from the entry on line %2, expected at least %3 mm</source>
        <translation>das Ziel liegt %1 mm vom Eintritt in Zeile %2, erwartet: mindestens %3 mm</translation>
    </message>
    <message>
        <source>%1 %2 is %3, which the tissue library does not have</source>
        <translation>%1 %2 ist %3, was die Gewebesammlung nicht hat</translation>
    </message>
    <message>
        <source>column %1: a quote (") is not allowed here; put the whole field in quotes and double the quotes in it</source>
        <translation>Spalte %1: ein Anführungszeichen (") steht, wo keines stehen darf; setzen Sie das ganze Feld in Anführungszeichen und verdoppeln Sie die darin</translation>
    </message>
    <message>
        <source>column %1: the byte 0x%2 is not text, expected UTF-8 without control characters</source>
        <translation>Spalte %1: das Byte 0x%2 ist kein Text, erwartet: UTF-8 ohne Steuerzeichen</translation>
    </message>
    <message>
        <source>a field that begins with a quote (") never ends with one</source>
        <translation>ein Feld, das mit einem Anführungszeichen (") beginnt, endet nie mit einem</translation>
    </message>
    <message>
        <source>column %1: %2 is %3, expected %4</source>
        <translation>Spalte %1: %2 ist %3, erwartet: %4</translation>
    </message>
    <message>
        <source>there are %1 columns, expected %2 (%3)</source>
        <translation>es gibt %1 Spalten, erwartet: %2 (%3)</translation>
    </message>
    <message>
        <source>the file is empty, expected the header %1</source>
        <translation>die Datei ist leer, erwartet: der Kopf %1</translation>
    </message>
    <message>
        <source>the header is %1, expected %2</source>
        <translation>der Kopf ist %1, erwartet: %2</translation>
    </message>
    <message>
        <source>a whole number from 1 to 65535</source>
        <translation>eine ganze Zahl von 1 bis 65535</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes oder no</translation>
    </message>
    <message>
        <source>there are no labels under the header</source>
        <translation>unter dem Kopf stehen keine Strukturen</translation>
    </message>
    <message>
        <source>there are no devices under the header</source>
        <translation>unter dem Kopf stehen keine Geräte</translation>
    </message>
    <message>
        <source>compensation up_x, up_y and up_z are %1, %2 and %3, expected a direction, which is longer than %4</source>
        <translation>compensation up_x, up_y und up_z sind %1, %2 und %3, erwartet: eine Richtung, länger als %4</translation>
    </message>
    <message>
        <source>%1 does not begin with a name, expected NAME SETTING=VALUE SETTING=VALUE ...</source>
        <translation>%1 beginnt nicht mit einem Namen, erwartet: NAME EINSTELLUNG=WERT EINSTELLUNG=WERT ...</translation>
    </message>
    <message>
        <source>there is no %1 %2, expected %3</source>
        <translation>es gibt kein %1 %2, erwartet: %3</translation>
    </message>
    <message>
        <source>tissue id is %1, which line %2 uses already</source>
        <translation>die Gewebenummer ist %1, die Zeile %2 schon benutzt</translation>
    </message>
    <message>
        <source>tissue name is '%1', which line %2 uses already</source>
        <translation>der Gewebename ist „%1“, den Zeile %2 schon benutzt</translation>
    </message>
    <message>
        <source>there is no tissue with id %1, expected one for air</source>
        <translation>es gibt kein Gewebe mit der Nummer %1, erwartet: eines für Luft</translation>
    </message>
    <message>
        <source>%1 is not a valid XML schema; install Bodkin again</source>
        <translation>%1 ist kein gültiges XML-Schema; installieren Sie Bodkin neu</translation>
    </message>
    <message>
        <source>a document type (&lt;!DOCTYPE ...&gt;) is not allowed; remove it and any entities it declares</source>
        <translation>ein Dokumenttyp (&lt;!DOCTYPE ...&gt;) ist nicht erlaubt; entfernen Sie ihn und was er erklärt</translation>
    </message>
    <message>
        <source>the file is not XML</source>
        <translation>die Datei ist kein XML</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is nested deeper than %2 levels</source>
        <translation>&lt;%1&gt; ist tiefer als %2 Ebenen geschachtelt</translation>
    </message>
    <message>
        <source>&lt;%1&gt; uses an XML namespace; these files have none, so remove every xmlns and prefix</source>
        <translation>&lt;%1&gt; benutzt einen XML-Namensraum; diese Dateien haben keinen, entfernen Sie jedes xmlns und jeden Vorsatz</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the attribute %2:%3, but attributes with a prefix are not allowed</source>
        <translation>&lt;%1&gt; hat das Attribut %2:%3, aber Attribute mit Vorsatz sind nicht erlaubt</translation>
    </message>
    <message>
        <source>the outermost element is &lt;%1&gt;, which does not belong there</source>
        <translation>das äußerste Element ist &lt;%1&gt;, das nicht dorthin gehört</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the unknown attribute %2; it takes %3</source>
        <translation>&lt;%1&gt; hat das unbekannte Attribut %2; möglich: %3</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the unknown attribute %2; it takes none</source>
        <translation>&lt;%1&gt; hat das unbekannte Attribut %2; es hat keine</translation>
    </message>
    <message>
        <source>&lt;%1&gt; lacks the attribute %2, expected %3</source>
        <translation>&lt;%1&gt; fehlt das Attribut %2, erwartet: %3</translation>
    </message>
    <message>
        <source>&lt;%1&gt; lacks %2</source>
        <translation>&lt;%1&gt; fehlt %2</translation>
    </message>
    <message>
        <source>the element &lt;%1&gt; is not allowed here, expected %2</source>
        <translation>das Element &lt;%1&gt; ist hier nicht erlaubt, erwartet: %2</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the element &lt;%2&gt; once more, expected it once at most</source>
        <translation>&lt;%1&gt; hat das Element &lt;%2&gt; noch einmal, erwartet: höchstens einmal</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the unknown element &lt;%2&gt;; it takes %3</source>
        <translation>&lt;%1&gt; hat das unbekannte Element &lt;%2&gt;; möglich: %3</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the unknown element &lt;%2&gt;; it takes none</source>
        <translation>&lt;%1&gt; hat das unbekannte Element &lt;%2&gt;; es hat keine</translation>
    </message>
    <message>
        <source>&lt;%1&gt; must be empty, but has something inside</source>
        <translation>&lt;%1&gt; muss leer sein, hat aber etwas innen</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has text inside (%2), expected elements only</source>
        <translation>&lt;%1&gt; hat Text innen (%2), erwartet: nur Elemente</translation>
    </message>
    <message>
        <source>&lt;%1&gt; holds %2, expected %3</source>
        <translation>&lt;%1&gt; enthält %2, erwartet: %3</translation>
    </message>
    <message>
        <source>the file is not XML; expected it to begin with '&lt;'</source>
        <translation>die Datei ist kein XML; erwartet: sie beginnt mit „&lt;“</translation>
    </message>
    <message>
        <source>the file ends before its elements are closed; is it cut short?</source>
        <translation>die Datei endet, bevor ihre Elemente geschlossen sind; ist sie abgeschnitten?</translation>
    </message>
    <message>
        <source>there is a character that is not UTF-8 or not allowed in XML</source>
        <translation>ein Zeichen ist kein UTF-8 oder in XML nicht erlaubt</translation>
    </message>
    <message>
        <source>the encoding is unknown, expected UTF-8</source>
        <translation>die Kodierung ist unbekannt, erwartet: UTF-8</translation>
    </message>
    <message>
        <source>the elements are nested too deeply</source>
        <translation>die Elemente sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>das XML ist fehlerhaft: %1</translation>
    </message>
    <message>
        <source>Where structures overlap (voxels: %1) the smaller one was taken.</source>
        <translation>Wo Strukturen überlappen (Voxel: %1), wurde die kleinere genommen.</translation>
    </message>
    <message>
        <source>Where segments overlap (voxels: %1) the smaller one was taken.</source>
        <translation>Wo Segmente überlappen (Voxel: %1), wurde das kleinere genommen.</translation>
    </message>
    <message>
        <source>Points and open lines of the structure set (contours: %1) were left out.</source>
        <translation>Punkte und offene Linien des Struktursatzes (Konturen: %1) wurden weggelassen.</translation>
    </message>
    <message>
        <source>Read the only CT series of the folder (%1) and left %2 other series aside.</source>
        <translation>Die einzige CT-Serie des Ordners (%1) wurde gelesen, %2 andere blieben beiseite.</translation>
    </message>
    <message>
        <source>Slices that were there more than once (files: %1) were read once.</source>
        <translation>Mehrfach vorhandene Schichten (Dateien: %1) wurden einmal gelesen.</translation>
    </message>
    <message>
        <source>A slice is missing %1%2; it was interpolated from its neighbours.</source>
        <translation>Eine Schicht fehlt %1%2; sie wurde aus ihren Nachbarn interpoliert.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2 mm); the CT was resampled to slices every %3 mm.</source>
        <translation>Die Schichten haben ungleiche Abstände (%1 bis %2 mm); das CT wurde auf Schichten alle %3 mm umgerechnet.</translation>
    </message>
    <message>
        <source>The gantry was tilted: the slices are shifted against each other by %1 degrees; the CT was resampled to a regular grid.</source>
        <translation>Die Gantry war geneigt: die Schichten sind um %1 Grad gegeneinander verschoben; das CT wurde auf ein regelmäßiges Gitter umgerechnet.</translation>
    </message>
    <message>
        <source>Slices whose pixels cannot be decoded (files: %1, %2) were left out.</source>
        <translation>Schichten, deren Bildpunkte nicht zu entschlüsseln sind (Dateien: %1, %2), wurden weggelassen.</translation>
    </message>
    <message>
        <source>The series was compressed with loss%1: values are off by about %2 HU (root mean square), by %3 HU at most.</source>
        <translation>Die Serie wurde mit Verlust gepackt%1: Werte weichen um etwa %2 HU ab (quadratisches Mittel), höchstens um %3 HU.</translation>
    </message>
    <message>
        <source>Damaged DICOM files (files: %1, %2) were left out.</source>
        <translation>Beschädigte DICOM-Dateien (Dateien: %1, %2) wurden weggelassen.</translation>
    </message>
    <message>
        <source>The CT's values were rounded to whole HU, by at most %1 HU.</source>
        <translation>Die Werte des CT wurden auf ganze HU gerundet, um höchstens %1 HU.</translation>
    </message>
    <message>
        <source>Values below -1024 HU (padding outside the scanned field; voxels: %1) were set to -1024 HU.</source>
        <translation>Werte unter -1024 HU (Auffüllung außerhalb des Messfelds; Voxel: %1) wurden auf -1024 HU gesetzt.</translation>
    </message>
    <message>
        <source>Values above 32767 HU (voxels: %1) were set to 32767 HU.</source>
        <translation>Werte über 32767 HU (Voxel: %1) wurden auf 32767 HU gesetzt.</translation>
    </message>
    <message>
        <source>Values that were not a number (NaN, voxels: %1) are padding and were set to -1024 HU.</source>
        <translation>Werte, die keine Zahl sind (NaN, Voxel: %1), sind Auffüllung und wurden auf -1024 HU gesetzt.</translation>
    </message>
    <message>
        <source>Labels outside the CT (voxels: %1) were left out.</source>
        <translation>Strukturen außerhalb des CT (Voxel: %1) wurden weggelassen.</translation>
    </message>
    <message>
        <source>The labels lie on another lattice than the CT; each CT voxel took the nearest label.</source>
        <translation>Die Strukturen liegen auf einem anderen Gitter als das CT; jeder CT-Voxel nahm die nächste.</translation>
    </message>
    <message>
        <source>the message ends %1 bytes too early, %2 were expected</source>
        <translation>die Nachricht endet %1 Byte zu früh, erwartet: %2</translation>
    </message>
    <message>
        <source>%1 is '%2', expected HOST or HOST:PORT with a port of 1 to 65535, as localhost:18944</source>
        <translation>%1 ist „%2“, erwartet: RECHNER oder RECHNER:PORT mit einem Port von 1 bis 65535, wie localhost:18944</translation>
    </message>
    <message>
        <source>the command %1 needs %2="a number"</source>
        <translation>der Befehl %1 braucht %2="eine Zahl"</translation>
    </message>
    <message>
        <source>%1 of the command %2 is %3, expected a number</source>
        <translation>%1 des Befehls %2 ist %3, erwartet: eine Zahl</translation>
    </message>
    <message>
        <source>a command has %1 bytes, expected at most %2</source>
        <translation>ein Befehl hat %1 Byte, erwartet: höchstens %2</translation>
    </message>
    <message>
        <source>a transform holds something that is not a finite number</source>
        <translation>eine Abbildung enthält etwas, das keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>%1 numbers, but a SENSOR holds at most %2</source>
        <translation>%1 Zahlen, ein SENSOR enthält %2</translation>
    </message>
    <message>
        <source>%1 numbers are no array with rows of %2, expected whole rows, at most %3 of them</source>
        <translation>%1 Zahlen sind kein Feld mit Zeilen zu %2, erwartet: ganze Zeilen, höchstens %3</translation>
    </message>
    <message>
        <source>an array has numbers of type %1, expected %2, doubles</source>
        <translation>ein Feld hat Zahlen vom Typ %1, erwartet: %2, doubles</translation>
    </message>
    <message>
        <source>an array has more than %1 numbers</source>
        <translation>ein Feld hat mehr als %1 Zahlen</translation>
    </message>
    <message>
        <source>an array of %1 numbers comes with %2 bytes</source>
        <translation>ein Feld von %1 Zahlen kommt mit %2 Byte</translation>
    </message>
    <message>
        <source>a surface of %1 points comes with %2 bytes</source>
        <translation>eine Oberfläche von %1 Punkten kommt mit %2 Byte</translation>
    </message>
    <message>
        <source>a surface has a point that is not a finite number</source>
        <translation>eine Oberfläche hat einen Punkt, der keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>%1 pixels do not make an image of %2 x %3</source>
        <translation>%1 Bildpunkte sind kein Bild von %2 x %3</translation>
    </message>
    <message>
        <source>an image has %1 voxels along an axis, expected 1 to 65,535</source>
        <translation>ein Bild hat %1 Voxel entlang einer Achse, erwartet: 1 bis 65535</translation>
    </message>
    <message>
        <source>an image comes in parts, expected a whole one</source>
        <translation>ein Bild kommt in Teilen, erwartet: ein ganzes</translation>
    </message>
    <message>
        <source>an image of %1 x %2 x %3 pixels has %4 values of type %5 per pixel, expected a slice with one byte per pixel</source>
        <translation>ein Bild von %1 x %2 x %3 hat %4 Zahlen vom Typ %5 je Bildpunkt, erwartet: eine Schicht mit je einem Byte</translation>
    </message>
    <message>
        <source>the pixels of an image have no size, or its position is not finite</source>
        <translation>die Bildpunkte eines Bildes haben keine Größe, oder sein Ort ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the %1 of a message is '%2', %3 bytes; expected at most %4</source>
        <translation>%1 einer Nachricht ist „%2“, %3 Byte; erwartet: höchstens %4</translation>
    </message>
    <message>
        <source>a message has no type, expected one such as TRANSFORM</source>
        <translation>eine Nachricht hat keinen Typ, erwartet: einer wie TRANSFORM</translation>
    </message>
    <message>
        <source>this is not a header of OpenIGTLink; the other side speaks another protocol</source>
        <translation>dies ist kein Kopf von OpenIGTLink; die Gegenseite spricht ein anderes Protokoll</translation>
    </message>
    <message>
        <source>the header of a message has version %1, expected 1 or 2; let the other side speak OpenIGTLink 1 to 3</source>
        <translation>der Kopf einer Nachricht hat Version %1, erwartet: 1 oder 2; lassen Sie die Gegenseite OpenIGTLink 1 bis 3 sprechen</translation>
    </message>
    <message>
        <source>a message %1 of '%2' arrived damaged: its check sum is %3, expected %4</source>
        <translation>eine Nachricht %1 von „%2“ kam beschädigt an: ihre Prüfsumme ist %3, erwartet: %4</translation>
    </message>
    <message>
        <source>the extended header of a message %1 names %2 bytes in a body of %3</source>
        <translation>der erweiterte Kopf einer Nachricht %1 nennt %2 Byte in einem Inhalt von %3</translation>
    </message>
    <message>
        <source>Part is '%1', expected one of %2</source>
        <translation>Part ist „%1“, erwartet: eines von %2</translation>
    </message>
    <message>
        <source>%1 of %2 is '%3', expected %4</source>
        <translation>%1 von %2 ist „%3“, erwartet: %4</translation>
    </message>
    <message>
        <source>%1 has no parameter '%2' for %3, expected %4</source>
        <translation>%1 hat keine Einstellung „%2“ für %3, erwartet: %4</translation>
    </message>
    <message>
        <source>the command %1 needs %2="..."</source>
        <translation>der Befehl %1 braucht %2="..."</translation>
    </message>
    <message>
        <source>NeedleState is not a row of at least %1 numbers; the server runs another version of Bodkin</source>
        <translation>NeedleState ist keine Zeile von mindestens %1 Zahlen; der Server ist ein anderes Bodkin</translation>
    </message>
    <message>
        <source>NeedleState holds something that is not a finite number</source>
        <translation>NeedleState enthält etwas, das keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>'%1' is not an address, expected one of this machine such as 127.0.0.1</source>
        <translation>„%1“ ist keine Adresse, erwartet: eine dieses Rechners wie 127.0.0.1</translation>
    </message>
    <message>
        <source>port %1 of %2 is in use; end the program that has it, or give another --port</source>
        <translation>Port %1 von %2 ist belegt; beenden Sie das Programm, das ihn hat, oder nennen Sie einen anderen --port</translation>
    </message>
    <message>
        <source>no client can connect at %1, port %2: %3</source>
        <translation>bei %1, Port %2, kann niemand eingelassen werden: %3</translation>
    </message>
    <message>
        <source>On of the command %1 is '%2', expected true or false</source>
        <translation>On des Befehls %1 ist „%2“, erwartet: true oder false</translation>
    </message>
    <message>
        <source>a session runs already and is recorded; StopRecording ends it, Reset begins it again</source>
        <translation>eine Sitzung läuft schon und wird aufgezeichnet; StopRecording beendet sie, Reset beginnt sie neu</translation>
    </message>
    <message>
        <source>the command %1 is not known; expected Freeze, Clutch, Plunger, Finger, Stylet, Manometer, HoldBreath, Arm, Disarm, StopRecording, Reset, RequestChannelIds, RequestDeviceIds, GetModelParameters, SetModelParameter, SetUsParameter or GetUsParameter</source>
        <translation>der Befehl %1 ist unbekannt; erwartet: Freeze, Clutch, Plunger, Finger, Stylet, Manometer, HoldBreath, Arm, Disarm, StopRecording, Reset, RequestChannelIds, RequestDeviceIds, GetModelParameters, SetModelParameter, SetUsParameter oder GetUsParameter</translation>
    </message>
    <message>
        <source>this session has no ultrasound; start bodkin serve with --ultrasound PROBE</source>
        <translation>diese Sitzung hat keinen Ultraschall; starten Sie bodkin serve mit --ultrasound SCHALLKOPF</translation>
    </message>
    <message>
        <source>%1 is not a setting of the ultrasound; expected DepthMm, GainDb, GainPercent, FrequencyMhz or FocusMm</source>
        <translation>%1 ist keine Einstellung des Ultraschalls; erwartet: DepthMm, GainDb, GainPercent, FrequencyMhz oder FocusMm</translation>
    </message>
    <message>
        <source>the matrix of %1 is not a rotation; expected one without scale, shear or mirror</source>
        <translation>die Matrix von %1 ist keine Drehung; erwartet: eine ohne Maßstab, Scherung oder Spiegelung</translation>
    </message>
    <message>
        <source>%1 has ended the connection</source>
        <translation>%1 hat die Verbindung beendet</translation>
    </message>
    <message>
        <source>%1 has sent nothing for %2 s</source>
        <translation>%1 hat %2 s lang nichts gesagt</translation>
    </message>
    <message>
        <source>%1 sent a message of %2 bytes, at most %3 are accepted</source>
        <translation>%1 sandte eine Nachricht von %2 Byte, angenommen werden höchstens %3</translation>
    </message>
    <message>
        <source>%1 (it is tried again every second)</source>
        <translation>%1 (jede Sekunde wird es wieder versucht)</translation>
    </message>
    <message>
        <source>the connection is ended: %1</source>
        <translation>die Verbindung wird beendet: %1</translation>
    </message>
    <message>
        <source>the rest of a message did not arrive</source>
        <translation>der Rest einer Nachricht kam nicht</translation>
    </message>
    <message>
        <source>a message of %1 bytes, at most %2 are accepted</source>
        <translation>eine Nachricht von %1 Byte, angenommen werden höchstens %2</translation>
    </message>
    <message>
        <source>more than #1 messages in a second</source>
        <translation>mehr als #1 Nachrichten in einer Sekunde</translation>
    </message>
    <message>
        <source>it does not read what it asked for</source>
        <translation>der Client nimmt nicht ab, was er verlangt hat</translation>
    </message>
    <message>
        <source>it sends more than is accepted</source>
        <translation>der Client sendet mehr, als abgenommen wird</translation>
    </message>
    <message>
        <source>all %1 places of this server are taken; end another client, or start the server with more --clients</source>
        <translation>alle %1 Plätze dieses Servers sind vergeben; beenden Sie einen anderen Client, oder starten Sie den Server mit mehr --clients</translation>
    </message>
    <message>
        <source>no server listens there</source>
        <translation>kein Server hat ihn</translation>
    </message>
    <message>
        <source>a tool of PLUS, 3D Slicer or another tracking server; no force</source>
        <translation>ein Werkzeug von PLUS, 3D Slicer oder einem anderen Tracking-Server; keine Kraft</translation>
    </message>
    <message>
        <source>any tool of a server that you name: localhost:18944/NeedleTipToReference</source>
        <translation>jedes Werkzeug eines Servers, den Sie nennen: localhost:18944/NeedleTipToReference</translation>
    </message>
    <message>
        <source>no tool among the bodies is called "%1"; expected %2</source>
        <translation>unter den Körpern heißt kein Werkzeug „%1“; erwartet: %2</translation>
    </message>
    <message>
        <source>no marker of the %1 is seen; keep its markers in the picture</source>
        <translation>vom Körper „%1“ ist kein Marker zu sehen; halten Sie seine Marker im Bild</translation>
    </message>
    <message>
        <source>the %1 is seen badly, its pose is uncertain; hold it still, in better light</source>
        <translation>der Körper „%1“ ist schlecht zu sehen, seine Lage ist unsicher; halten Sie ihn ruhig und in besserem Licht</translation>
    </message>
    <message>
        <source>no marker of the mannequin's board is seen; keep it in the picture</source>
        <translation>von der Tafel der Puppe ist kein Marker zu sehen; halten Sie sie im Bild</translation>
    </message>
    <message>
        <source>the mannequin's board is seen badly, its pose is uncertain; uncover it</source>
        <translation>die Tafel der Puppe ist schlecht zu sehen, ihre Lage ist unsicher; decken Sie sie auf</translation>
    </message>
    <message>
        <source>the needle is not seen and rests where it was</source>
        <translation>die Nadel ist nicht zu sehen und ruht, wo sie war</translation>
    </message>
    <message>
        <source>the needle was not seen %1 time, %2 s in all; it rested where it was, and 'bodkin report' shows when</source>
        <translation>die Nadel war %1 Mal nicht zu sehen, zusammen %2 s; sie ruhte, wo sie war, und „bodkin report“ zeigt, wann</translation>
    </message>
    <message>
        <source>the needle was not seen %1 times, %2 s in all; it rested where it was, and 'bodkin report' shows when</source>
        <translation>die Nadel war %1 Mal nicht zu sehen, zusammen %2 s; sie ruhte, wo sie war, und „bodkin report“ zeigt, wann</translation>
    </message>
    <message>
        <source>the needle is not seen any more, it rests where it was</source>
        <translation>die Nadel ist nicht mehr zu sehen, sie ruht, wo sie war</translation>
    </message>
    <message>
        <source>the needle is seen again, after %1 s</source>
        <translation>die Nadel ist wieder zu sehen, nach %1 s</translation>
    </message>
    <message>
        <source>a real needle or probe with markers, seen by a camera; no force</source>
        <translation>eine wirkliche Nadel oder Sonde mit Markern, von einer Kamera gesehen; keine Kraft</translation>
    </message>
    <message>
        <source>a camera (/dev/video0), a video or a folder of pictures that you name</source>
        <translation>eine Kamera (/dev/video0), ein Video oder ein Ordner von Bildern, den Sie nennen</translation>
    </message>
    <message>
        <source>no pictures are named; expected a camera, a video or a folder, as tracked:/dev/video0</source>
        <translation>es sind keine Bilder genannt; erwartet: eine Kamera, ein Video oder ein Ordner, wie tracked:/dev/video0</translation>
    </message>
    <message>
        <source>the %1 was not seen in %2 pictures</source>
        <translation>der Körper „%1“ war in %2 Bildern nicht zu sehen</translation>
    </message>
    <message>
        <source>times that the tracked needle was not seen</source>
        <translation>wie oft die verfolgte Nadel nicht zu sehen war</translation>
    </message>
    <message>
        <source>time for which it was not seen</source>
        <translation>wie lange sie nicht zu sehen war</translation>
    </message>
    <message>
        <source>this patient has no planned path by which an attempt is judged; plan one first</source>
        <translation>dieser Patient hat keinen geplanten Pfad, nach dem ein Versuch beurteilt wird; planen Sie zuerst einen</translation>
    </message>
    <message>
        <source>The recording begins as soon as needle and mannequin are seen.</source>
        <translation>Die Aufnahme beginnt, sobald Nadel und Puppe zu sehen sind.</translation>
    </message>
    <message>
        <source>Recording, %1 s: the needle is NOT SEEN and rests where it was, %2 mm deep</source>
        <translation>Aufnahme, %1 s: die Nadel ist NICHT ZU SEHEN und ruht, wo sie war, %2 mm tief</translation>
    </message>
    <message>
        <source>Recording, %1 s: %2 mm deep, %3 N</source>
        <translation>Aufnahme, %1 s: %2 mm tief, %3 N</translation>
    </message>
    <message>
        <source>The session is being saved and judged.</source>
        <translation>Die Sitzung wird gesichert und beurteilt.</translation>
    </message>
    <message>
        <source>the tool is '%1', expected a name of 1 to 20 letters, as in openigtlink:localhost:18944/NeedleTipToReference</source>
        <translation>das Werkzeug ist „%1“, erwartet: ein Name von 1 bis 20 Buchstaben, wie in openigtlink:localhost:18944/NeedleTipToReference</translation>
    </message>
    <message>
        <source>the setting frame is '%1', expected patient (the reference is the patient's CT) or hand (the tracker's own axes)</source>
        <translation>die Einstellung frame ist „%1“, erwartet: patient (Bezug ist das CT des Patienten) oder hand (die Achsen des Trackers)</translation>
    </message>
    <message>
        <source>--point is '%1'; expected the code or name of an acupuncture point, such as ST36 (bodkin points lists them)</source>
        <translation>--point ist „%1“; erwartet: Kürzel oder Name eines Akupunkturpunkts, wie ST36 (bodkin points zeigt sie)</translation>
    </message>
    <message>
        <source>there is no acupuncture point '%1', expected a code such as ST36</source>
        <translation>es gibt keinen Akupunkturpunkt „%1“, erwartet: ein Kürzel wie ST36</translation>
    </message>
    <message>
        <source>acupuncture/points.csv: there is no landmark or point '%1'</source>
        <translation>acupuncture/points.csv: es gibt keine Landmarke und keinen Punkt „%1“</translation>
    </message>
    <message>
        <source>acupuncture/cun.csv: there is no measure '%1'</source>
        <translation>acupuncture/cun.csv: es gibt kein Maß „%1“</translation>
    </message>
    <message>
        <source>acupuncture/points.csv: %1 goes toward '%2', expected a landmark, a point or a direction</source>
        <translation>acupuncture/points.csv: %1 geht in Richtung „%2“, erwartet: eine Landmarke, ein Punkt oder eine Richtung</translation>
    </message>
    <message>
        <source>%1 is empty, expected a row with the names of its columns</source>
        <translation>%1 ist leer, erwartet: eine Zeile mit den Namen der Spalten</translation>
    </message>
    <message>
        <source>%1 has no column %2</source>
        <translation>%1 hat keine Spalte %2</translation>
    </message>
    <message>
        <source>the CT holds no body: its largest solid part (above %1 HU) has %2 mL, at least %3 mL were expected; check that the values are Hounsfield units</source>
        <translation>das CT enthält keinen Körper: sein größter fester Teil (über %1 HU) hat %2 mL, erwartet: mindestens %3 mL; prüfen Sie, ob die Werte Hounsfield-Einheiten sind</translation>
    </message>
    <message>
        <source>--needle-gauge is %1; expected %2 to %3</source>
        <translation>--needle-gauge ist %1; erwartet: %2 bis %3</translation>
    </message>
    <message>
        <source>--entry and --target are %1 mm apart; expected at least 1 mm</source>
        <translation>--entry und --target liegen %1 mm auseinander; erwartet: mindestens 1 mm</translation>
    </message>
    <message>
        <source>%1 is (%2, %3, %4), which lies outside the CT; give a point inside it, LPS mm</source>
        <translation>%1 ist (%2, %3, %4) und liegt außerhalb des CT; geben Sie einen Punkt darin an, LPS mm</translation>
    </message>
    <message>
        <source>there is no tissue with id %1 (%2), expected all of Bodkin's own, 0 to %3; begin with a copy of share/bodkin/tissues.xml</source>
        <translation>es gibt kein Gewebe mit der Nummer %1 (%2), erwartet: alle von Bodkin, 0 bis %3; beginnen Sie mit einer Kopie von share/bodkin/tissues.xml</translation>
    </message>
    <message>
        <source>--conus is '%1'; expected a vertebra, T12 to L4, or an interspace, T12_L1 to L4_L5</source>
        <translation>--conus ist „%1“; erwartet: ein Wirbel, T12 bis L4, oder ein Zwischenraum, T12_L1 bis L4_L5</translation>
    </message>
    <message>
        <source>--level is '%1'; expected an interspace, T12_L1 to L5_S1</source>
        <translation>--level ist „%1“; erwartet: ein Zwischenraum, T12_L1 bis L5_S1</translation>
    </message>
    <message>
        <source>%1 cannot be copied to %2: %3</source>
        <translation>%1 kann nicht nach %2 kopiert werden: %3</translation>
    </message>
    <message>
        <source>structure %1 (%2) names the tissue "%3", which is neither Bodkin's nor in the tissue library; use a name of the library, "bone", "spinal_canal", or nothing for HU</source>
        <translation>Struktur %1 (%2) nennt das Gewebe „%3“, das weder Bodkin noch die Gewebesammlung hat; nehmen Sie einen Namen der Sammlung, „bone“, „spinal_canal“, oder nichts für HU</translation>
    </message>
    <message>
        <source>the range begins at %1 HU and ends at %2 HU; expected the lower one first</source>
        <translation>der Bereich beginnt bei %1 HU und endet bei %2 HU; erwartet: der kleinere Wert zuerst</translation>
    </message>
    <message>
        <source>the place that was chosen lies outside of the image; choose one inside</source>
        <translation>die gewählte Stelle liegt außerhalb des Bildes; wählen Sie eine darin</translation>
    </message>
    <message>
        <source>the place that was clicked has %1 HU, outside of the range from %2 to %3 HU; click inside the structure, or widen the range</source>
        <translation>die angeklickte Stelle hat %1 HU, außerhalb des Bereichs von %2 bis %3 HU; klicken Sie in die Struktur, oder weiten Sie den Bereich</translation>
    </message>
    <message>
        <source>the axis is %1; expected 0 to 2</source>
        <translation>die Achse ist %1; erwartet: 0 bis 2</translation>
    </message>
    <message>
        <source>there are no two slices to fill between; paint the structure in two slices first</source>
        <translation>es gibt keine zwei Schichten, zwischen denen zu füllen wäre; malen Sie die Struktur erst in zwei Schichten</translation>
    </message>
    <message>
        <source>the radius is %1 mm; expected above 0, at most 50</source>
        <translation>der Radius ist %1 mm; erwartet: über 0, höchstens 50</translation>
    </message>
    <message>
        <source>the image is thinner than four voxels and cannot be smoothed</source>
        <translation>das Bild ist dünner als vier Voxel und kann nicht geglättet werden</translation>
    </message>
    <message>
        <source>%1; these look like %2 numbers: use --scheme %3</source>
        <translation>%1; dies sieht nach den Nummern von %2 aus: nehmen Sie --scheme %3</translation>
    </message>
    <message>
        <source>%1; give the labels of this CT, or the --scheme that they are numbered by</source>
        <translation>%1; geben Sie die Strukturen dieses CT an, oder das --scheme, nach dem sie nummeriert sind</translation>
    </message>
    <message>
        <source>the labels are shifted against the CT: moved by (%1, %2, %3) mm (LPS) far more of what they call bone would lie on bone; segment this CT, or mend the position in the header of the labels</source>
        <translation>die Strukturen sind gegen das CT verschoben: um (%1, %2, %3) mm (LPS) versetzt läge weit mehr von dem, was sie Knochen nennen, auf Knochen; segmentieren Sie dieses CT, oder berichtigen Sie die Lage im Kopf der Strukturen</translation>
    </message>
    <message>
        <source>--level is %1, where no path can be planned: %2</source>
        <translation>--level ist %1, wo kein Weg geplant werden kann: %2</translation>
    </message>
    <message>
        <source>--level is %1, but no lumbar interspace was found in this CT</source>
        <translation>--level ist %1, aber in diesem CT wurde kein lumbaler Zwischenraum gefunden</translation>
    </message>
    <message>
        <source>the path from --entry to --target goes into the spinal cord %1 mm from its entry; %2</source>
        <translation>der Weg von --entry nach --target geht %1 mm hinter dem Eintritt ins Rückenmark; %2</translation>
    </message>
    <message>
        <source>choose a target below the conus, or say with --conus where the cord of this patient ends</source>
        <translation>wählen Sie ein Ziel unterhalb des Conus, oder sagen Sie mit --conus, wo das Rückenmark dieses Patienten endet</translation>
    </message>
    <message>
        <source>label %1 has voxels but no name; give it one in the list of structures</source>
        <translation>Nummer %1 hat Voxel, aber keinen Namen; geben Sie ihr einen in der Liste der Strukturen</translation>
    </message>
    <message>
        <source>this case has no CT, so its structures cannot be corrected</source>
        <translation>dieser Fall hat kein CT, seine Strukturen lassen sich also nicht berichtigen</translation>
    </message>
    <message>
        <source>the labels do not lie on the lattice of the CT</source>
        <translation>die Strukturen liegen nicht auf dem Gitter des CT</translation>
    </message>
    <message>
        <source>--lowest-vertebra is '%1'; expected the vertebra above the lowest interspace of the CT, T10 to T12 or L1 to L6</source>
        <translation>--lowest-vertebra ist „%1“; erwartet: der Wirbel über dem untersten Zwischenraum des CT, T10 bis T12 oder L1 bis L6</translation>
    </message>
    <message>
        <source>there is no tissue within %1 mm of the planned path; plan it through the body</source>
        <translation>innerhalb von %1 mm um den geplanten Weg ist kein Gewebe; planen Sie ihn durch den Körper</translation>
    </message>
    <message>
        <source>there is nothing but air in the tissue volume</source>
        <translation>im Gewebevolumen ist nur Luft</translation>
    </message>
    <message>
        <source>%1 is not the id of a tissue of the case; say with --regions what the regions are made of</source>
        <translation>%1 ist die Nummer keines Gewebes des Falls; sagen Sie mit --regions, woraus die Regionen bestehen</translation>
    </message>
    <message>
        <source>the tissue of %1 is '%2', expected the name of one tissue, such as cortical_bone</source>
        <translation>das Gewebe von %1 ist „%2“, erwartet: der Name eines Gewebes, wie cortical_bone</translation>
    </message>
    <message>
        <source>there is no row for %1 of the mesh</source>
        <translation>für %1 des Netzes gibt es keine Zeile</translation>
    </message>
    <message>
        <source>tetrahedron %1 of the mesh, at (%2, %3, %4) mm, has no volume; repair the mesh where it was made</source>
        <translation>Tetraeder %1 des Netzes bei (%2, %3, %4) mm hat kein Volumen; bessern Sie das Netz dort aus, wo es gemacht wurde</translation>
    </message>
    <message>
        <source>the mesh needs more memory than there is; ask for fewer nodes</source>
        <translation>das Netz braucht mehr Speicher, als da ist; verlangen Sie weniger Knoten</translation>
    </message>
    <message>
        <source>bodkin-mesher failed: %1</source>
        <translation>bodkin-mesher ist gescheitert: %1</translation>
    </message>
    <message>
        <source>meshing took more than ten minutes and was given up; ask for fewer nodes</source>
        <translation>das Vernetzen dauerte mehr als zehn Minuten und wurde abgebrochen; verlangen Sie weniger Knoten</translation>
    </message>
    <message>
        <source>bodkin-mesher ended without a message; ask for fewer nodes</source>
        <translation>bodkin-mesher endete wortlos; verlangen Sie weniger Knoten</translation>
    </message>
    <message>
        <source>bodkin-mesher returned an invalid mesh; it is another version than the program that called it</source>
        <translation>bodkin-mesher gab ein ungültiges Netz zurück; es ist von anderer Version als das rufende Programm</translation>
    </message>
    <message>
        <source>bodkin-mesher returned an invalid mesh</source>
        <translation>bodkin-mesher gab ein ungültiges Netz zurück</translation>
    </message>
    <message>
        <source>%1 nodes are too few to hold the layers of the planned path, of which the thinnest are %2; expected at least %3: give --nodes %4</source>
        <translation>%1 Knoten sind zu wenige für die Schichten des geplanten Wegs, deren dünnste sind: %2; erwartet: mindestens %3, also --nodes %4</translation>
    </message>
    <message>
        <source>%1 nodes ask for edges of %2 mm in the corridor, which makes no sense here; ask for another number of nodes, or other --fine and --coarse</source>
        <translation>%1 Knoten verlangen im Korridor Kanten von %2 mm, was hier keinen Sinn hat; verlangen Sie eine andere Zahl von Knoten, oder andere --fine und --coarse</translation>
    </message>
    <message>
        <source>no tissue is thick enough for elements of this size; ask for more nodes</source>
        <translation>kein Gewebe ist dick genug für Elemente dieser Größe; verlangen Sie mehr Knoten</translation>
    </message>
    <message>
        <source>--needle is '%1'; expected %2</source>
        <translation>--needle ist „%1“; erwartet: %2</translation>
    </message>
    <message>
        <source>a plan can keep away from at most 254 tissues and structures</source>
        <translation>ein Plan kann höchstens 254 Gewebe und Strukturen meiden</translation>
    </message>
    <message>
        <source>the procedure forbids the tissue '%1', which the tissue library of the case does not have</source>
        <translation>der Eingriff verbietet das Gewebe „%1“, das die Gewebesammlung des Falls nicht hat</translation>
    </message>
    <message>
        <source>the target is the structure '%1', which this patient does not have; expected %2</source>
        <translation>das Ziel ist die Struktur „%1“, die dieser Patient nicht hat; erwartet: %2</translation>
    </message>
    <message>
        <source>the target is the structure '%1', which has no voxel here; expected one of %2</source>
        <translation>das Ziel ist die Struktur „%1“, die hier keinen Voxel hat; erwartet: eine von %2</translation>
    </message>
    <message>
        <source>a point x,y,z: there is no segmentation</source>
        <translation>ein Punkt x,y,z: es gibt keine Segmentierung</translation>
    </message>
    <message>
        <source>the case has no planned path, about which the deformable body is prepared; give --entry and --target, or make the case with them</source>
        <translation>der Fall hat keinen geplanten Weg, um den der verformbare Körper vorbereitet wird; geben Sie --entry und --target an, oder machen Sie den Fall damit</translation>
    </message>
    <message>
        <source>the case has no mesh, which %1 needs; make one with: bodkin case mesh %2</source>
        <translation>der Fall hat kein Netz, das %1 braucht; machen Sie eines mit: bodkin case mesh %2</translation>
    </message>
    <message>
        <source>the segmentation filter returned another size</source>
        <translation>der Segmentierungsfilter gab eine andere Größe zurück</translation>
    </message>
    <message>
        <source>synthetic shoulder: the voxels are too coarse for the space of the joint, expected a smaller spacing or more fluid</source>
        <translation>künstliche Schulter: die Voxel sind zu grob für den Gelenkspalt, erwartet: ein kleinerer Abstand oder mehr Flüssigkeit</translation>
    </message>
    <message>
        <source>synthetic shoulder: the tissue library has no tissue with id %1, expected it for the %2</source>
        <translation>künstliche Schulter: die Gewebesammlung hat kein Gewebe mit der Nummer %1, erwartet für: %2</translation>
    </message>
    <message>
        <source>synthetic shoulder: there is no needle of %1G</source>
        <translation>künstliche Schulter: es gibt keine Nadel von %1G</translation>
    </message>
    <message>
        <source>synthetic patient: the tissue library has no interspinous ligament, expected one for calcified ligaments; add it to the library</source>
        <translation>künstlicher Patient: die Gewebesammlung hat kein Lig. interspinale, erwartet: eines für verkalkte Bänder; fügen Sie es der Sammlung hinzu</translation>
    </message>
    <message>
        <source>synthetic patient: the tissue library has no tissue with id %1, which the patient is made of; add it to the library</source>
        <translation>künstlicher Patient: die Gewebesammlung hat kein Gewebe mit der Nummer %1, aus dem der Patient besteht; fügen Sie es der Sammlung hinzu</translation>
    </message>
    <message>
        <source>there is no skin of the patient within %1 mm of the entry; give a larger reach</source>
        <translation>innerhalb von %1 mm um den Eintritt ist keine Haut des Patienten; geben Sie eine größere Reichweite an</translation>
    </message>
    <message>
        <source>only %1 places of both skins lie together within %2 mm, expected %3 or more; register the patient to the mannequin first (--registration), or give a larger reach or a smaller spacing</source>
        <translation>nur %1 Stellen beider Häute liegen innerhalb von %2 mm beisammen, erwartet: %3 oder mehr; registrieren Sie den Patienten erst zur Puppe (--registration), oder geben Sie eine größere Reichweite oder einen kleineren Abstand an</translation>
    </message>
    <message>
        <source>Nothing in the CT is thicker than 9 mm; its largest thin-walled part was taken for the body.</source>
        <translation>Nichts im CT ist dicker als 9 mm; sein größter dünnwandiger Teil wurde als Körper genommen.</translation>
    </message>
    <message>
        <source>Solid objects outside the body (couch, arms, other objects; %1 mL) were left out and have no skin.</source>
        <translation>Feste Gegenstände außerhalb des Körpers (Liege, Arme, anderes; %1 mL) wurden weggelassen und haben keine Haut.</translation>
    </message>
    <message>
        <source>The image lies wholly inside the body, so this patient has no skin.</source>
        <translation>Das Bild liegt ganz im Körper, dieser Patient hat also keine Haut.</translation>
    </message>
    <message>
        <source>No path was planned to %1, because %2.</source>
        <translation>Zu %1 wurde kein Weg geplant, denn: %2.</translation>
    </message>
    <message>
        <source>No path was planned to %1 at (%2, %3, %4).</source>
        <translation>Zu %1 bei (%2, %3, %4) wurde kein Weg geplant.</translation>
    </message>
    <message>
        <source>The path to %1 was planned, %2 mm long, %3 degrees %4 and %5 to the %6; nearest: %7.</source>
        <translation>Der Weg zu %1 wurde geplant, %2 mm lang, %3 Grad nach %4 und %5 nach %6; am nächsten: %7.</translation>
    </message>
    <message>
        <source>'bodkin case plan' lists others.</source>
        <translation>„bodkin case plan“ nennt andere.</translation>
    </message>
    <message>
        <source>%1 label%2 (first %3) are not in the scheme; their voxels were decided by HU alone.</source>
        <translation>%1 Nummer(n)%2 (zuerst %3) stehen nicht im Schema; über ihre Voxel entschieden die HU allein.</translation>
    </message>
    <message>
        <source>No path was planned, because %1 has a target of its own; give --target.</source>
        <translation>Es wurde kein Weg geplant, denn %1 hat ein eigenes Ziel; geben Sie --target an.</translation>
    </message>
    <message>
        <source>Specks as dense as bone (pieces: %1, %2 mL in all, each below 0.05 mL) were taken for soft tissue.</source>
        <translation>Flecken so dicht wie Knochen (Stücke: %1, insgesamt %2 mL, jeder unter 0.05 mL) wurden als Weichgewebe genommen.</translation>
    </message>
    <message>
        <source>Stones or calcifications deep in the body, apart from the skeleton (pieces: %1, %2 mL in all), were taken for soft tissue.</source>
        <translation>Steine oder Verkalkungen tief im Körper, abseits vom Skelett (Stücke: %1, insgesamt %2 mL), wurden als Weichgewebe genommen.</translation>
    </message>
    <message>
        <source>Contrast deep in the body, apart from the skeleton and even in HU (pieces: %1, %2 mL in all), was taken for vessels, not bone.</source>
        <translation>Kontrastmittel tief im Körper, abseits vom Skelett und gleichmäßig in HU (Stücke: %1, insgesamt %2 mL), wurde als Gefäß genommen, nicht als Knochen.</translation>
    </message>
    <message>
        <source>The names %1 of the labels name no known tissue, so HU decides there; a --scheme can say what they are.</source>
        <translation>Die Namen %1 der Strukturen sagen kein Gewebe, dort entscheiden die HU; ein --scheme kann sagen, was sie sind.</translation>
    </message>
    <message>
        <source>The label of the spinal cord was taken for the whole spinal canal, as TotalSegmentator draws it; if it is the cord alone, give a --scheme in which its tissue is spinal_cord.</source>
        <translation>Die Struktur des Rückenmarks wurde als der ganze Spinalkanal genommen, wie TotalSegmentator sie zeichnet; ist es das Rückenmark allein, geben Sie ein --scheme an, in dem ihr Gewebe spinal_cord ist.</translation>
    </message>
    <message>
        <source>Label %1 (%2) is unlike its name: median of about %3 HU, expected %4.</source>
        <translation>Nummer %1 (%2) gleicht ihrem Namen nicht: Median etwa %3 HU, erwartet: %4.</translation>
    </message>
    <message>
        <source>Label %1 (%2) holds %3 mL, more than one vertebra has.</source>
        <translation>Nummer %1 (%2) umfasst %3 mL, mehr als ein Wirbel hat.</translation>
    </message>
    <message>
        <source>above 50 for bone</source>
        <translation>über 50 für Knochen</translation>
    </message>
    <message>
        <source>below -250 for lung</source>
        <translation>unter -250 für Lunge</translation>
    </message>
    <message>
        <source>-80 to 300</source>
        <translation>-80 bis 300</translation>
    </message>
    <message>
        <source>only %1 % of what the labels call %2 has HU that %3 can have</source>
        <translation>nur %1 % dessen, was die Strukturen %2 nennen, hat HU, die %3 haben kann</translation>
    </message>
    <message>
        <source>The levels of the vertebrae are not known, so interspaces are numbered from below and the whole canal counts as holding cord: %1.</source>
        <translation>Die Höhen der Wirbel sind nicht bekannt; Zwischenräume zählen daher von unten, und der ganze Kanal gilt als Ort des Rückenmarks: %1.</translation>
    </message>
    <message>
        <source>Confidence: %1.</source>
        <translation>Sicherheit: %1.</translation>
    </message>
    <message>
        <source>The spinal cord is drawn down to the %1.</source>
        <translation>Das Rückenmark ist gezeichnet bis: %1.</translation>
    </message>
    <message>
        <source>The spinal cord ends above the canal seen here, at the %1.</source>
        <translation>Das Rückenmark endet über dem hier sichtbaren Kanal, bei: %1.</translation>
    </message>
    <message>
        <source>The spinal cord runs through the whole canal seen here and ends below it, at the %1.</source>
        <translation>Das Rückenmark läuft durch den ganzen hier sichtbaren Kanal und endet darunter, bei: %1.</translation>
    </message>
    <message>
        <source>Layers, front edge of the flavum and depth of the epidural fat: %1.</source>
        <translation>Schichten, Vorderrand des Flavum und Tiefe des epiduralen Fetts: %1.</translation>
    </message>
    <message>
        <source>The path was planned through %1, %2 degrees cephalad, %3 mm long, with %4 mm to the nearest bone%5.</source>
        <translation>Der Weg wurde durch %1 geplant, %2 Grad nach kranial, %3 mm lang, mit %4 mm zum nächsten Knochen%5.</translation>
    </message>
    <message>
        <source>The path was planned through %1, %2 degrees cephalad, %3 mm long, with %4 mm to the nearest bone.</source>
        <translation>Der Weg wurde durch %1 geplant, %2 Grad nach kranial, %3 mm lang, mit %4 mm zum nächsten Knochen.</translation>
    </message>
    <message>
        <source>A spinal canal was found from %1, but no lumbar interspace: its contents are constructed, ligaments are not.</source>
        <translation>Aus %1 wurde ein Spinalkanal gefunden, aber kein lumbaler Zwischenraum: sein Inhalt ist aufgebaut, Bänder nicht.</translation>
    </message>
    <message>
        <source>Ligaments, epidural space and dura are constructed from %1 with textbook thicknesses where the CT shows none; interspaces found: %2.</source>
        <translation>Bänder, Epiduralraum und Dura sind aus %1 aufgebaut, mit Lehrbuchdicken, wo das CT keine zeigt; gefundene Zwischenräume: %2.</translation>
    </message>
    <message>
        <source>the labels of the spinal canal</source>
        <translation>den Strukturen des Spinalkanals</translation>
    </message>
    <message>
        <source>the labels of the vertebrae</source>
        <translation>den Strukturen der Wirbel</translation>
    </message>
    <message>
        <source>bone and midline of the CT</source>
        <translation>Knochen und Mittellinie des CT</translation>
    </message>
    <message>
        <source>No path was planned, because %1.</source>
        <translation>Es wurde kein Weg geplant, denn: %1.</translation>
    </message>
    <message>
        <source>The procedure is not meant to be done at %1; its score will count that as the wrong level.</source>
        <translation>Der Eingriff ist für %1 nicht gedacht; die Beurteilung wird das als falsche Höhe zählen.</translation>
    </message>
    <message>
        <source>The image border cuts the body (%1); cut faces have no skin.</source>
        <translation>Der Bildrand schneidet den Körper (%1); Schnittflächen haben keine Haut.</translation>
    </message>
    <message>
        <source>Metal in the body (%1 mL above 2500 HU) stops the needle as bone does.</source>
        <translation>Metall im Körper (%1 mL über 2500 HU) hält die Nadel auf wie Knochen.</translation>
    </message>
    <message>
        <source>Contrast that touches bone, long, even in HU and without a shell as bone has (%1 mL), was taken for vessels.</source>
        <translation>Kontrastmittel am Knochen, lang, gleichmäßig in HU und ohne Rinde wie Knochen (%1 mL), wurde als Gefäß genommen.</translation>
    </message>
    <message>
        <source>No %1 was constructed, because %2.</source>
        <translation>Nicht aufgebaut: %1, denn: %2.</translation>
    </message>
    <message>
        <source>ligament and no dura</source>
        <translation>Bänder und Dura</translation>
    </message>
    <message>
        <source>path was planned, and no ligament and no dura</source>
        <translation>Weg, Bänder und Dura</translation>
    </message>
    <message>
        <source>no lumbar spine was found</source>
        <translation>es wurde keine Lendenwirbelsäule gefunden</translation>
    </message>
    <message>
        <source>Finding the body</source>
        <translation>der Körper wird gesucht</translation>
    </message>
    <message>
        <source>Drawing the skin</source>
        <translation>die Haut wird gezeichnet</translation>
    </message>
    <message>
        <source>Building the spine</source>
        <translation>die Wirbelsäule wird aufgebaut</translation>
    </message>
    <message>
        <source>The planned path was taken out, because %1.</source>
        <translation>Der geplante Weg wurde entfernt, denn: %1.</translation>
    </message>
    <message>
        <source>The planned path was replaced, because %1.</source>
        <translation>Der geplante Weg wurde ersetzt, denn: %1.</translation>
    </message>
    <message>
        <source>The new one is %1 mm long; nearest: %2.</source>
        <translation>Der neue ist %1 mm lang; am nächsten: %2.</translation>
    </message>
    <message>
        <source>it is too close to what it must keep away from (nearest: %1)</source>
        <translation>er kommt dem zu nahe, was er meiden muss (am nächsten: %1)</translation>
    </message>
    <message>
        <source>The mesh of this case was made from the previous tissues and is left out; 'bodkin case mesh' makes a new one.</source>
        <translation>Das Netz dieses Falls war aus den Geweben davor und wird weggelassen; „bodkin case mesh“ macht eines.</translation>
    </message>
    <message>
        <source>Levels are named by the labels of the vertebrae%1.</source>
        <translation>Die Höhen sind nach den Strukturen der Wirbel benannt%1.</translation>
    </message>
    <message>
        <source>Levels are named by the labels of the vertebrae.</source>
        <translation>Die Höhen sind nach den Strukturen der Wirbel benannt.</translation>
    </message>
    <message>
        <source>Levels are counted up from the sacrum at z = %1 and down from the lowest ribs, of T12, at z = %2; both agree.</source>
        <translation>Die Höhen sind vom Kreuzbein bei z = %1 aufwärts und von den untersten Rippen, denen von T12, bei z = %2 abwärts gezählt; beides stimmt überein.</translation>
    </message>
    <message>
        <source>Levels are counted %1, assuming five lumbar vertebrae%2.</source>
        <translation>Die Höhen sind %1 gezählt, unter Annahme von fünf Lendenwirbeln%2.</translation>
    </message>
    <message>
        <source>Levels are counted %1, assuming five lumbar vertebrae.</source>
        <translation>Die Höhen sind %1 gezählt, unter Annahme von fünf Lendenwirbeln.</translation>
    </message>
    <message>
        <source>up from the sacrum at z = %1</source>
        <translation>vom Kreuzbein bei z = %1 aufwärts</translation>
    </message>
    <message>
        <source>down from the lowest ribs at z = %1</source>
        <translation>von den untersten Rippen bei z = %1 abwärts</translation>
    </message>
    <message>
        <source>the CT shows neither the sacrum nor the lowest ribs</source>
        <translation>das CT zeigt weder das Kreuzbein noch die untersten Rippen</translation>
    </message>
    <message>
        <source>the interspaces found are %1</source>
        <translation>gefundene Zwischenräume: %1</translation>
    </message>
    <message>
        <source>the image border cuts one of its vertebrae</source>
        <translation>der Bildrand schneidet einen seiner Wirbel</translation>
    </message>
    <message>
        <source>no straight path there stays clear of bone and of the spinal cord, which ends at the %1</source>
        <translation>kein gerader Weg dort meidet Knochen und Rückenmark, das endet bei: %1</translation>
    </message>
    <message>
        <source>no straight path through an interspace that comes into question stays clear of bone</source>
        <translation>kein gerader Weg durch einen in Frage kommenden Zwischenraum meidet Knochen</translation>
    </message>
    <message>
        <source>The target does not lie in the body.</source>
        <translation>Das Ziel liegt nicht im Körper.</translation>
    </message>
    <message>
        <source>The target lies in %1, which the needle must not enter.</source>
        <translation>Das Ziel liegt in %1, wo die Nadel nicht hinein darf.</translation>
    </message>
    <message>
        <source>No straight path leads there: of %1 directions tried, %2.</source>
        <translation>Kein gerader Weg führt dorthin: von %1 versuchten Richtungen %2.</translation>
    </message>
    <message>
        <source>%1 leave the image before the skin</source>
        <translation>verlassen %1 das Bild vor der Haut</translation>
    </message>
    <message>
        <source>%1 are longer than the %2 mm that the needle reaches</source>
        <translation>sind %1 länger als die %2 mm, die die Nadel reicht</translation>
    </message>
    <message>
        <source>%1 are flatter than %2 degrees to the skin</source>
        <translation>sind %1 flacher als %2 Grad zur Haut</translation>
    </message>
    <message>
        <source>%1 go into %2</source>
        <translation>gehen %1 in: %2</translation>
    </message>
    <message>
        <source>%1 come closer than %2 mm to %3</source>
        <translation>kommen %1 näher als %2 mm an: %3</translation>
    </message>
    <message>
        <source>nothing to avoid within %1 mm</source>
        <translation>nichts zu meiden innerhalb von %1 mm</translation>
    </message>
    <message>
        <source>into %1</source>
        <translation>in: %1</translation>
    </message>
    <message>
        <source>the interspace there has no known name</source>
        <translation>der Zwischenraum dort hat keinen bekannten Namen</translation>
    </message>
    <message>
        <source>%1 is not a level of this procedure</source>
        <translation>%1 ist keine Höhe dieses Eingriffs</translation>
    </message>
    <message>
        <source>%1 lies above L2/L3, where the cord may be met</source>
        <translation>%1 liegt über L2/L3, wo das Rückenmark getroffen werden kann</translation>
    </message>
    <message>
        <source>the cord ends %1 mm above %2, which is less than a vertebra</source>
        <translation>das Rückenmark endet %1 mm über %2, weniger als einen Wirbel</translation>
    </message>
    <message>
        <source>the needle meets points of its line in a body of %1 nodes, whose factor takes %2 GB</source>
        <translation>die Nadel trifft Punkte ihrer Linie in einem Körper von %1 Knoten, dessen Faktor %2 GB braucht</translation>
    </message>
    <message>
        <source>the skin is stiffer than fat: 'bodkin case mesh' keeps it within 12 mm of the planned path; a needle that enters farther away dimples what lies below it</source>
        <translation>die Haut ist steifer als Fett: 'bodkin case mesh' behält sie bis 12 mm vom geplanten Weg; eine Nadel, die weiter weg eintritt, drückt das ein, was darunter liegt</translation>
    </message>
    <message>
        <source>planning the mesh</source>
        <translation>das Netz wird geplant</translation>
    </message>
    <message>
        <source>warping the volumes</source>
        <translation>die Volumen werden verformt</translation>
    </message>
    <message>
        <source>export of surfaces: the folder %1 cannot be made (%2); choose another one</source>
        <translation>Ausgabe der Oberflächen: der Ordner %1 kann nicht angelegt werden (%2); wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>export of surfaces: %1 cannot be written; check that the folder may be written to and that the disk has room</source>
        <translation>Ausgabe der Oberflächen: %1 kann nicht geschrieben werden; prüfen Sie, ob der Ordner beschreibbar ist und die Platte Platz hat</translation>
    </message>
    <message>
        <source>the surfaces could not be written; check that the disk has room</source>
        <translation>die Oberflächen konnten nicht geschrieben werden; prüfen Sie, ob die Platte Platz hat</translation>
    </message>
    <message>
        <source>surfaces: cancelled</source>
        <translation>Oberflächen: abgebrochen</translation>
    </message>
    <message>
        <source>surfaces: the tissue map is empty or all air, expected a body; check the case with bodkin case check</source>
        <translation>Oberflächen: die Gewebekarte ist leer oder nur Luft, erwartet: ein Körper; prüfen Sie den Fall mit bodkin case check</translation>
    </message>
    <message>
        <source>volume: cancelled</source>
        <translation>Volumen: abgebrochen</translation>
    </message>
    <message>
        <source>surfaces: a triangle has a corner that is not a point</source>
        <translation>Oberflächen: ein Dreieck hat eine Ecke, die kein Punkt ist</translation>
    </message>
    <message>
        <source>camera: eye and focus must be 1 mm apart at least</source>
        <translation>camera: eye und focus müssen mindestens 1 mm auseinander liegen</translation>
    </message>
    <message>
        <source>camera: up must be a direction across the line of sight, from eye to focus</source>
        <translation>camera: up muss eine Richtung quer zur Blickrichtung von eye nach focus sein</translation>
    </message>
    <message>
        <source>part %1 appears twice in one look; leave one of them out</source>
        <translation>der Teil %1 steht zweimal in einem look; lassen Sie einen weg</translation>
    </message>
    <message>
        <source>there are two looks called %1; give one another name</source>
        <translation>zwei look heißen %1; geben Sie einem einen anderen Namen</translation>
    </message>
    <message>
        <source>looks opens_with is %1, expected the name of a look in this file</source>
        <translation>looks opens_with ist %1, erwartet: der Name eines look in dieser Datei</translation>
    </message>
    <message>
        <source>the change of numbers at tick %1 is damaged; give a session file as it was written</source>
        <translation>die Änderung von Zahlen bei Takt %1 ist beschädigt; geben Sie eine Sitzungsdatei an, wie sie geschrieben wurde</translation>
    </message>
    <message>
        <source>--operator is '%1', expected '%2' or the name of an operator file</source>
        <translation>--operator ist „%1“, erwartet: „%2“ oder der Name einer Datei mit einer Handschrift</translation>
    </message>
    <message>
        <source>the session's needle met contact points of its own line, but the resistance has none here; record it again</source>
        <translation>die Nadel der Sitzung traf Kontaktpunkte ihrer eigenen Linie, aber das Kraftmodell hat hier keine; zeichnen Sie sie neu auf</translation>
    </message>
    <message>
        <source>the session changes its numbers at tick %1 while those before still settle; the recording is damaged</source>
        <translation>die Sitzung ändert ihre Zahlen bei Takt %1, während die davor noch einschwingen; die Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>the session cannot be recomputed: at %1 s its needle took another corridor of mesh nodes, which older versions of Bodkin prepared; 'bodkin report' and 'bodkin export' show what was felt</source>
        <translation>die Sitzung kann nicht nachgerechnet werden: bei %1 s nahm ihre Nadel einen anderen Korridor von Netzknoten, den ältere Versionen von Bodkin vorbereiteten; „bodkin report“ und „bodkin export“ zeigen, was gespürt wurde</translation>
    </message>
    <message>
        <source>the session cannot be recomputed: at %1 s its needle met a moving body (--body moving), of which not every step was kept; 'bodkin report' and 'bodkin export' show what was felt</source>
        <translation>die Sitzung kann nicht nachgerechnet werden: bei %1 s traf ihre Nadel einen Körper, der sich von selbst bewegte (--body moving) und von dem nicht jeder Schritt behalten ist; „bodkin report“ und „bodkin export“ zeigen, was gespürt wurde</translation>
    </message>
    <message>
        <source>%1 needles were left in the body, expected at most %2; take some out</source>
        <translation>%1 Nadeln stecken im Körper, höchstens %2 werden erwartet; ziehen Sie einige heraus</translation>
    </message>
    <message>
        <source>needle %1 that was left in the body is %2 mm long from its entry to its tip, expected %3 to %4 mm and places within %5 mm; give entry and tip in mm as the case has them</source>
        <translation>Nadel %1, die im Körper steckt, ist von ihrem Einstich bis zur Spitze %2 mm lang, erwartet werden %3 bis %4 mm und Orte innerhalb von %5 mm; geben Sie Einstich und Spitze in mm an, wie der Fall sie hat</translation>
    </message>
    <message>
        <source>the session's moving_body is '%1', expected JSON with width_mm, thickness_mm, radius_mm, reach_mm and step_s; record it again</source>
        <translation>moving_body der Sitzung ist „%1“, erwartet wird JSON mit width_mm, thickness_mm, radius_mm, reach_mm und step_s; zeichnen Sie sie neu auf</translation>
    </message>
    <message>
        <source>the session's needle met a moving body, but there is no deformable body here; replay it with its own case</source>
        <translation>die Nadel der Sitzung traf einen Körper, der sich von selbst bewegte, aber hier ist kein verformbarer Körper; rechnen Sie sie mit ihrem eigenen Fall nach</translation>
    </message>
    <message>
        <source>the session's needle met a moving body, which its resistance does not feel here; record it again</source>
        <translation>die Nadel der Sitzung traf einen Körper, der sich von selbst bewegte, was ihr Widerstand hier nicht spürt; zeichnen Sie sie neu auf</translation>
    </message>
    <message>
        <source>the session holds no ticks, there is nothing to replay</source>
        <translation>die Sitzung enthält keine Takte, es gibt nichts nachzurechnen</translation>
    </message>
    <message>
        <source>the session has a tick of %1 s, but its force models ran with one of %2 s; record it again</source>
        <translation>die Sitzung hat einen Takt von %1 s, aber ihre Kraftmodelle liefen mit %2 s; zeichnen Sie sie neu auf</translation>
    </message>
    <message>
        <source>tick %1 is missing from the session, a replay needs every tick from the first</source>
        <translation>Takt %1 fehlt in der Sitzung, zum Nachrechnen braucht es jeden Takt vom ersten an</translation>
    </message>
    <message>
        <source>%1 of the session (digest %2, recorded %3); give the case as it was with --case</source>
        <translation>%1 der Sitzung (Prüfsumme %2, aufgezeichnet %3); geben Sie mit --case den Fall an, wie er war</translation>
    </message>
    <message>
        <source>its case.xml is not the one</source>
        <translation>seine case.xml ist nicht die</translation>
    </message>
    <message>
        <source>its voxels or tissues are not those</source>
        <translation>seine Voxel oder Gewebe sind nicht die</translation>
    </message>
    <message>
        <source>its voxels, tissues or mesh are not those</source>
        <translation>seine Voxel, Gewebe oder sein Netz sind nicht die</translation>
    </message>
    <message>
        <source>the deformable body of the same case has another compliance than in the session (digest %1, recorded %2): it was prepared by another version of Bodkin or METIS</source>
        <translation>der verformbare Körper desselben Falls hat eine andere Nachgiebigkeit als in der Sitzung (Prüfsumme %1, aufgezeichnet %2): er wurde von einer anderen Version von Bodkin oder METIS vorbereitet</translation>
    </message>
    <message>
        <source>cannot write the session %1: %2; what was recorded until then is safe, free space on its disk before you continue</source>
        <translation>die Sitzung %1 kann nicht geschrieben werden: %2; was bis dahin aufgezeichnet wurde, ist sicher, schaffen Sie Platz auf ihrem Datenträger, bevor Sie weitermachen</translation>
    </message>
    <message>
        <source>the tick of a session is %1 s, expected more than 0</source>
        <translation>der Takt einer Sitzung ist %1 s, erwartet: mehr als 0</translation>
    </message>
    <message>
        <source>the session file %1 exists already; give another --output, or --overwrite</source>
        <translation>die Sitzungsdatei %1 gibt es schon; geben Sie einen anderen --output oder --overwrite an</translation>
    </message>
    <message>
        <source>%1 is not a file that a session could replace</source>
        <translation>%1 ist keine Datei, die eine Sitzung ersetzen könnte</translation>
    </message>
    <message>
        <source>cannot create the session file %1: %2; free space on its disk, or write elsewhere</source>
        <translation>die Sitzungsdatei %1 kann nicht angelegt werden: %2; schaffen Sie Platz auf ihrem Datenträger oder schreiben Sie anderswohin</translation>
    </message>
    <message>
        <source>cannot replace the session file %1: %2</source>
        <translation>die Sitzungsdatei %1 kann nicht ersetzt werden: %2</translation>
    </message>
    <message>
        <source>the recording has no %1; it has %2; name the needle with --needle</source>
        <translation>die Aufzeichnung hat kein %1; sie hat %2; nennen Sie die Nadel mit --needle</translation>
    </message>
    <message>
        <source>the recording has one pose of %1, expected two at least</source>
        <translation>die Aufzeichnung hat eine Lage von %1, erwartet: mindestens zwei</translation>
    </message>
    <message>
        <source>the recording of %1 takes %2 s, expected at most %3</source>
        <translation>die Aufzeichnung von %1 dauert %2 s, erwartet: höchstens %3</translation>
    </message>
    <message>
        <source>at %1 s %2 is %3 mm from the entry of the case's path, expected at most %4; the reference must be the patient's CT in RAS mm</source>
        <translation>bei %1 s liegt %2 %3 mm vom Eintritt des geplanten Wegs, erwartet: höchstens %4; Bezug muss das CT des Patienten in RAS mm sein</translation>
    </message>
    <message>
        <source>the session has no tick, expected one in which a needle moved</source>
        <translation>die Sitzung hat keinen Takt, erwartet: eine, in der sich eine Nadel bewegte</translation>
    </message>
    <message>
        <source>%1; give a session file that 'bodkin run' wrote</source>
        <translation>%1; geben Sie eine Sitzungsdatei an, die „bodkin run“ geschrieben hat</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>this is not a session file</source>
        <translation>dies ist keine Sitzungsdatei</translation>
    </message>
    <message>
        <source>this is a database of another program, not a session</source>
        <translation>dies ist die Datenbank eines anderen Programms, keine Sitzung</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>das Ende der Datei fehlt</translation>
    </message>
    <message>
        <source>the session has format version %1, this Bodkin reads versions %2 and %3</source>
        <translation>die Sitzung hat die Formatversion %1, dieses Bodkin liest die Versionen %2 und %3</translation>
    </message>
    <message>
        <source>the tables in the file are not those of a session</source>
        <translation>die Tabellen in der Datei sind nicht die einer Sitzung</translation>
    </message>
    <message>
        <source>the table '%1' is missing</source>
        <translation>die Tabelle „%1“ fehlt</translation>
    </message>
    <message>
        <source>the header lacks '%1'</source>
        <translation>dem Kopf fehlt „%1“</translation>
    </message>
    <message>
        <source>'%1' of the header is not a number</source>
        <translation>„%1“ des Kopfs ist keine Zahl</translation>
    </message>
    <message>
        <source>'%1' of the header is not a point</source>
        <translation>„%1“ des Kopfs ist kein Punkt</translation>
    </message>
    <message>
        <source>the header has too many entries</source>
        <translation>der Kopf hat zu viele Einträge</translation>
    </message>
    <message>
        <source>the list of tissues is damaged</source>
        <translation>die Liste der Gewebe ist beschädigt</translation>
    </message>
    <message>
        <source>the list of the patient's volumes is damaged</source>
        <translation>die Liste der Volumen des Patienten ist beschädigt</translation>
    </message>
    <message>
        <source>the patient's volume '%1' is damaged, its checksum does not fit</source>
        <translation>das Volumen „%1“ des Patienten ist beschädigt, seine Prüfsumme passt nicht</translation>
    </message>
    <message>
        <source>the volume '%1' is not one that a session keeps</source>
        <translation>das Volumen „%1“ ist keines, das eine Sitzung enthält</translation>
    </message>
    <message>
        <source>Young's modulus along the fibres; 0: as across them</source>
        <translation>Elastizitätsmodul entlang der Fasern; 0: wie quer zu ihnen</translation>
    </message>
    <message>
        <source>shear along</source>
        <translation>Schub entlang</translation>
    </message>
    <message>
        <source>shear modulus along the fibres; 0: as across them</source>
        <translation>Schubmodul entlang der Fasern; 0: wie quer zu ihnen</translation>
    </message>
    <message>
        <source>young along</source>
        <translation>Young entlang</translation>
    </message>
    <message>
        <source>the header is damaged, its checksum does not fit</source>
        <translation>der Kopf ist beschädigt, seine Prüfsumme passt nicht</translation>
    </message>
    <message>
        <source>a tick of %1 s is out of range</source>
        <translation>ein Takt von %1 s liegt außerhalb des Erlaubten</translation>
    </message>
    <message>
        <source>the second hand is a '%1', expected plunger or probe</source>
        <translation>die zweite Hand ist „%1“, erwartet: plunger oder probe</translation>
    </message>
    <message>
        <source>the header's list of diagnostics is damaged</source>
        <translation>die Liste der Messgrößen im Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>the diagnostics at tick %1 do not fit the ticks</source>
        <translation>die Messgrößen bei Takt %1 passen nicht zu den Takten</translation>
    </message>
    <message>
        <source>the diagnostics at tick %1 are damaged, their checksum does not fit</source>
        <translation>die Messgrößen bei Takt %1 sind beschädigt, ihre Prüfsumme passt nicht</translation>
    </message>
    <message>
        <source>the diagnostics from tick %1 on are missing</source>
        <translation>die Messgrößen ab Takt %1 fehlen</translation>
    </message>
    <message>
        <source>the chunks are not in order</source>
        <translation>die Blöcke sind nicht in der Reihenfolge</translation>
    </message>
    <message>
        <source>the chunk at tick %1 has the wrong size</source>
        <translation>der Block bei Takt %1 hat die falsche Größe</translation>
    </message>
    <message>
        <source>the chunk at tick %1 is damaged, its checksum does not fit</source>
        <translation>der Block bei Takt %1 ist beschädigt, seine Prüfsumme passt nicht</translation>
    </message>
    <message>
        <source>tick %1 holds an invalid value</source>
        <translation>Takt %1 enthält einen Wert, den kein Takt hat</translation>
    </message>
    <message>
        <source>an event of the chunk at tick %1 is invalid</source>
        <translation>ein Ereignis des Blocks bei Takt %1 ist keines</translation>
    </message>
    <message>
        <source>there are samples of a second hand, but the header names none</source>
        <translation>es gibt Werte einer zweiten Hand, aber der Kopf nennt keine</translation>
    </message>
    <message>
        <source>the second hand has too many samples</source>
        <translation>die zweite Hand hat zu viele Werte</translation>
    </message>
    <message>
        <source>sample %1 of the second hand is damaged</source>
        <translation>Wert %1 der zweiten Hand ist beschädigt</translation>
    </message>
    <message>
        <source>samples of the second hand are missing from a session that was finished</source>
        <translation>Werte der zweiten Hand fehlen in einer abgeschlossenen Sitzung</translation>
    </message>
    <message>
        <source>the timings are damaged</source>
        <translation>die Zeiten sind beschädigt</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>die Datei ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>ticks are missing from a session that was finished</source>
        <translation>Takte fehlen in einer abgeschlossenen Sitzung</translation>
    </message>
    <message>
        <source>there is no constraint '%1', expected one of %2</source>
        <translation>es gibt keine Führung „%1“, erwartet: eine von %2</translation>
    </message>
    <message>
        <source>%1 needs the deformable body of the case, and none was prepared; make a mesh with: bodkin case mesh</source>
        <translation>%1 braucht den verformbaren Körper des Falls, und keiner wurde vorbereitet; machen Sie ein Netz mit: bodkin case mesh</translation>
    </message>
    <message>
        <source>embedded_needle: cut_offset_mm is %1 for a needle that does not bend; give flexible=true as well, or leave it out</source>
        <translation>embedded_needle: cut_offset_mm ist %1 für eine Nadel, die sich nicht biegt; geben Sie auch flexible=true an, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>embedded_needle: cut_offset_mm is %1, but a %2 needle has no bevel and cuts straight; leave it out, or take a quincke, tuohy or chiba needle</source>
        <translation>embedded_needle: cut_offset_mm ist %1, aber eine %2-Nadel hat keinen Schliff und schneidet gerade; lassen Sie es weg, oder nehmen Sie eine Quincke-, Tuohy- oder Chiba-Nadel</translation>
    </message>
    <message>
        <source>the case has no tissues, so there is nothing to feel</source>
        <translation>der Fall hat keine Gewebe, es gibt also nichts zu spüren</translation>
    </message>
    <message>
        <source>the needle's entry and target are the same point, expected a path of some length</source>
        <translation>Eintritt und Ziel der Nadel sind derselbe Punkt, erwartet: ein Weg von einiger Länge</translation>
    </message>
    <message>
        <source>%1 does not go with %2; %3</source>
        <translation>%1 geht nicht mit %2 zusammen; %3</translation>
    </message>
    <message>
        <source>use it with spring_damper_wall, or with tracking_wall without leash</source>
        <translation>nehmen Sie es mit spring_damper_wall, oder mit tracking_wall ohne leash</translation>
    </message>
    <message>
        <source>that model has its own friction of the shaft; leave the part out</source>
        <translation>dieses Modell hat eine eigene Reibung am Schaft; lassen Sie den Teil weg</translation>
    </message>
    <message>
        <source>it acts on the friction of the shaft; add the part shaft_friction</source>
        <translation>er wirkt auf die Reibung am Schaft; fügen Sie den Teil shaft_friction hinzu</translation>
    </message>
    <message>
        <source>there is no resistance '%1' in this program, expected one of %2</source>
        <translation>es gibt kein Kraftmodell „%1“ in diesem Programm, erwartet: eines von %2</translation>
    </message>
    <message>
        <source>a resistance was registered without a name or without a way to make it</source>
        <translation>ein Kraftmodell wurde ohne Namen oder ohne Bauweise angemeldet</translation>
    </message>
    <message>
        <source>there is a resistance '%1' already; register it under another name</source>
        <translation>es gibt schon ein Kraftmodell „%1“; melden Sie es unter anderem Namen an</translation>
    </message>
    <message>
        <source>--steps: '%1' is not a step, expected %2</source>
        <translation>--steps: „%1“ ist kein Schritt, erwartet: %2</translation>
    </message>
    <message>
        <source>the force was taken away: %1; try again</source>
        <translation>die Kraft wurde weggenommen: %1; versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>no force was rendered, because the handle was not at rest; hold it still at the beginning</source>
        <translation>die Kraft kam nicht, denn der Griff war nicht in Ruhe; halten Sie ihn zu Beginn still</translation>
    </message>
    <message>
        <source>the delay was measured already; start again to measure it anew</source>
        <translation>die Verzögerung wurde schon gemessen; beginnen Sie neu, um sie noch einmal zu messen</translation>
    </message>
    <message>
        <source>the handle did not follow the force clearly; hold it loosely, and try again with --steps delay</source>
        <translation>der Griff folgte der Kraft nicht deutlich; halten Sie ihn locker, und versuchen Sie es noch einmal mit --steps delay</translation>
    </message>
    <message>
        <source>the handle went up by %1 mm when it was lifted, expected %2 or more; let it hang freely</source>
        <translation>der Griff ging beim Heben um %1 mm nach oben, erwartet: %2 oder mehr; lassen Sie ihn frei hängen</translation>
    </message>
    <message>
        <source>the simulated hand moves at %1 Hz and the case at %2 Hz; add --settings rate_Hz=%3</source>
        <translation>die simulierte Hand bewegt sich mit %1 Hz und der Fall mit %2 Hz; fügen Sie --settings rate_Hz=%3 hinzu</translation>
    </message>
    <message>
        <source>%1 was recorded at %2 Hz and the case runs at %3 Hz, expected the same rate; set rate_Hz of the case's haptics to the recording's</source>
        <translation>%1 wurde mit %2 Hz aufgezeichnet und der Fall läuft mit %3 Hz, erwartet: dieselbe Rate; setzen Sie rate_Hz in der Haptik des Falls auf die der Aufzeichnung</translation>
    </message>
    <message>
        <source>the device runs at %1 Hz and the case at %2 Hz; set rate_Hz of the case's haptics to the device's</source>
        <translation>das Gerät läuft mit %1 Hz und der Fall mit %2 Hz; setzen Sie rate_Hz in der Haptik des Falls auf die des Geräts</translation>
    </message>
    <message>
        <source>the session lacks %1 ticks in a row, expected at most %2; choose another one</source>
        <translation>der Sitzung fehlen %1 Takte nacheinander, erwartet: höchstens %2; wählen Sie eine andere</translation>
    </message>
    <message>
        <source>--second is the device that holds the needle (serial number %1); expected another</source>
        <translation>--second ist das Gerät, das die Nadel hält (Seriennummer %1); erwartet: ein anderes</translation>
    </message>
    <message>
        <source>the device did not answer once; is it switched on?</source>
        <translation>das Gerät antwortete kein einziges Mal; ist es eingeschaltet?</translation>
    </message>
    <message>
        <source>the case has no planned path, so there is no place to put the hand; make the case with --entry and --target</source>
        <translation>der Fall hat keinen geplanten Weg, es gibt also keinen Ort für die Hand; machen Sie den Fall mit --entry und --target</translation>
    </message>
    <message>
        <source>--body is 'moving', which a probe presses, but no second device holds one; add --second DEVICE --second-as probe</source>
        <translation>--body ist „moving“, worauf ein Schallkopf drückt, aber kein zweites Gerät hält einen; fügen Sie --second GERÄT --second-as probe hinzu</translation>
    </message>
    <message>
        <source>--body is 'moving', which only the resistance embedded_needle feels, but the resistance is %1; add --resistance embedded_needle</source>
        <translation>--body ist „moving“, was nur das Kraftmodell embedded_needle spürt, und dieses ist %1; fügen Sie --resistance embedded_needle hinzu</translation>
    </message>
    <message>
        <source>--ultrasound: %1</source>
        <translation>--ultrasound: %1</translation>
    </message>
    <message>
        <source>--at is '%1', which is not a landmark or structure of the case; expected one of them ('bodkin case show' names them) or x,y,z in LPS mm</source>
        <translation>--at ist „%1“, keine Landmarke oder Struktur des Falls; erwartet: eine davon („bodkin case show“ nennt sie) oder x,y,z in LPS mm</translation>
    </message>
    <message>
        <source>the case has no planned path for --needle; make one with --entry and --target</source>
        <translation>der Fall hat keinen geplanten Weg für --needle; machen Sie einen mit --entry und --target</translation>
    </message>
    <message>
        <source>%1 is not a rigid placement, expected a rotation without scaling or mirroring, with the place in mm in the fourth column</source>
        <translation>%1 ist keine starre Lage, erwartet: eine Drehung ohne Maßstab oder Spiegelung, mit dem Ort in mm in der vierten Spalte</translation>
    </message>
    <message>
        <source>with %1 nodes in the mesh a step of the moving body takes about %2 ms, but 60 steps a second allow only %3 ms: it will move in slow motion; a mesh of %4 nodes keeps up</source>
        <translation>das Netz hat %1 Knoten, für die ein Schritt des bewegten Körpers etwa %2 ms braucht; 60 Schritte je Sekunde lassen %3 ms: er wird sich in Zeitlupe bewegen; ein Netz von %4 Knoten hält Schritt</translation>
    </message>
    <message>
        <source>tissue %1 has fibres, which a moving body does not support; leave the fibres out of its entry in tissues.xml, or let the body lie still (without --body moving)</source>
        <translation>Gewebe %1 hat Fasern, die ein Körper, der sich von selbst bewegt, nicht kennt; die Fasern aus seinem Eintrag in tissues.xml weglassen oder den Körper ruhen lassen (ohne --body moving)</translation>
    </message>
    <message>
        <source>the probe presses the patient layer by layer: tissue %1 has fibres, which a moving body does not support</source>
        <translation>der Schallkopf drückt den Patienten Schicht für Schicht: Gewebe %1 hat Fasern, die ein Körper, der sich von selbst bewegt, nicht kennt</translation>
    </message>
    <message>
        <source>the moving body failed: the probe loses its force, and the needle meets the body at rest from now on</source>
        <translation>der bewegte Körper ist ausgefallen: der Schallkopf verliert seine Kraft, und die Nadel trifft von nun an den ruhenden Körper</translation>
    </message>
    <message>
        <source>contact points of the needle's line could not be computed, so that it continues with those that are there: %1</source>
        <translation>Kontaktpunkte der Linie der Nadel konnten nicht berechnet werden, sodass sie in den vorhandenen weitergeht: %1</translation>
    </message>
    <message>
        <source>the needle's contact points could not be coupled with the nodes that the probe holds now, and stay as they were: %1</source>
        <translation>die Kontaktpunkte der Nadel konnten nicht mit den Knoten gekoppelt werden, die der Schallkopf jetzt hält, und bleiben, wie sie waren: %1</translation>
    </message>
    <message>
        <source>the memory is exhausted; close other programs, or mesh the patient more coarsely</source>
        <translation>der Speicher ist erschöpft; schließen Sie andere Programme, oder vernetzen Sie den Patienten gröber</translation>
    </message>
    <message>
        <source>the probe met no node of the mesh: it was not pressed in, or its face is smaller than the mesh's elements; give --body "moving thickness_mm=30", or make a finer mesh</source>
        <translation>der Schallkopf traf keinen Knoten des Netzes: er wurde nicht eingedrückt, oder seine Fläche ist kleiner, als das Netz fein ist; geben Sie --body "moving thickness_mm=30" an, oder machen Sie ein feineres Netz</translation>
    </message>
    <message>
        <source>Tip: put the tool's tip into a dimple that holds it, and swivel the tool about it, 20 degrees or more to every side.</source>
        <translation>Spitze: setzen Sie die Spitze des Werkzeugs in eine Mulde, die sie hält, und schwenken Sie das Werkzeug darum, 20 Grad oder mehr nach jeder Seite.</translation>
    </message>
    <message>
        <source>Weight: the motors will carry the handle. Hold it in the middle of the workspace; as the force comes, let go and keep clear until this step is over.</source>
        <translation>Gewicht: die Motoren werden den Griff tragen. Halten Sie ihn in der Mitte des Arbeitsraums; wenn die Kraft kommt, lassen Sie los und bleiben Sie weg, bis dieser Schritt vorbei ist.</translation>
    </message>
    <message>
        <source>Delay: hold the handle loosely in the middle of the workspace, and let it tick up and down for five seconds.</source>
        <translation>Verzögerung: halten Sie den Griff locker in der Mitte des Arbeitsraums, und lassen Sie ihn fünf Sekunden lang auf und ab ticken.</translation>
    </message>
    <message>
        <source>the device reported a fault: %1</source>
        <translation>das Gerät meldete eine Störung: %1</translation>
    </message>
    <message>
        <source>weighing: let go of the handle</source>
        <translation>Wiegen: lassen Sie den Griff los</translation>
    </message>
    <message>
        <source>weighing: the handle goes up</source>
        <translation>Wiegen: der Griff geht nach oben</translation>
    </message>
    <message>
        <source>weighing: the handle goes down</source>
        <translation>Wiegen: der Griff geht nach unten</translation>
    </message>
    <message>
        <source>friction: the handle goes right and back</source>
        <translation>Reibung: der Griff geht nach rechts und zurück</translation>
    </message>
    <message>
        <source>friction: the handle goes away and back</source>
        <translation>Reibung: der Griff geht weg und zurück</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 mm</source>
        <translation>%1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>the calibration was given up</source>
        <translation>die Kalibrierung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the device could not be stopped; switch it off and on again</source>
        <translation>das Gerät ließ sich nicht anhalten; schalten Sie es aus und wieder ein</translation>
    </message>
    <message>
        <source>the second device could not be stopped; switch it off and on again</source>
        <translation>das zweite Gerät ließ sich nicht anhalten; schalten Sie es aus und wieder ein</translation>
    </message>
    <message>
        <source>%1 ticks a second instead of %2; close other programs, or use a lower rate</source>
        <translation>%1 Runden je Sekunde statt %2; schließen Sie andere Programme, oder nehmen Sie eine kleinere Rate</translation>
    </message>
    <message>
        <source>%1 % of the ticks were late; close other programs, and permit real-time priority (docs/perform.md)</source>
        <translation>%1 % der Runden waren zu spät; schließen Sie andere Programme, und erlauben Sie Echtzeit-Priorität (docs/perform.md)</translation>
    </message>
    <message>
        <source>reinstall its vendor's software, or remove it</source>
        <translation>installieren Sie die Software des Herstellers neu, oder entfernen Sie sie</translation>
    </message>
    <message>
        <source>remove the file, or ask whoever made it for another one</source>
        <translation>entfernen Sie die Datei, oder bitten Sie ihren Urheber um eine andere</translation>
    </message>
    <message>
        <source>the driver %1 has not answered within %2 s: %3</source>
        <translation>der Treiber %1 hat nicht innerhalb von %2 s geantwortet: %3</translation>
    </message>
    <message>
        <source>the driver %1 crashed (%2): %3</source>
        <translation>der Treiber %1 ist abgestürzt (%2): %3</translation>
    </message>
    <message>
        <source>the driver %1 ended the program that asked it (exit code %2): %3</source>
        <translation>der Treiber %1 beendete das Programm, das ihn fragte (Rückgabewert %2): %3</translation>
    </message>
    <message>
        <source>other programs can hold up the force, which then comes late and can shake the hand%1 (%2)</source>
        <translation>andere Programme können die Kraft aufhalten, die dann zu spät kommt und die Hand erschüttern kann%1 (%2)</translation>
    </message>
    <message>
        <source>calibrated %1</source>
        <translation>kalibriert: %1</translation>
    </message>
    <message>
        <source>second device calibrated %1</source>
        <translation>zweites Gerät kalibriert: %1</translation>
    </message>
    <message>
        <source>second hand: %1</source>
        <translation>zweite Hand: %1</translation>
    </message>
    <message>
        <source>the second hand is disarmed too, because the needle's device is at fault; press a to arm both</source>
        <translation>auch die zweite Hand ist nicht mehr freigegeben, weil das Gerät der Nadel gestört ist; die Taste a gibt beide frei</translation>
    </message>
    <message>
        <source>the device ran at %1 Hz instead of %2; the tissue's time was %3 times the clock's</source>
        <translation>das Gerät lief mit %1 Hz statt %2; die Zeit des Gewebes war das %3-fache der Uhr</translation>
    </message>
    <message>
        <source>%1 ultrasound pictures, %2 a second</source>
        <translation>%1 Ultraschallbilder, %2 je Sekunde</translation>
    </message>
    <message>
        <source>%1 samples of the second hand were lost, because the disk was too slow</source>
        <translation>%1 Werte der zweiten Hand gingen verloren, weil die Platte zu langsam war</translation>
    </message>
    <message>
        <source>the second hand is not used: %1</source>
        <translation>die zweite Hand nimmt nicht teil: %1</translation>
    </message>
    <message>
        <source>marker %1 of body "%2" was seen together with another one in %3 pictures; %4 are needed, so turn it towards the camera more often</source>
        <translation>Marke %1 des Körpers „%2“ wurde in %3 Bildern neben einer anderen gesehen; nötig sind %4, drehen Sie sie öfter zur Kamera</translation>
    </message>
    <message>
        <source>a picture has %1 x %2 pixels, but the first one has %3 x %4; a camera is calibrated at one size</source>
        <translation>ein Bild hat %1 x %2 Bildpunkte, das erste aber %3 x %4; eine Kamera wird in einer Größe kalibriert</translation>
    </message>
    <message>
        <source>%1 pictures show the board at rest; at least %2 are needed, with the board at other places and tilted</source>
        <translation>%1 Bilder zeigen die Tafel in Ruhe; nötig sind mindestens %2, mit der Tafel an anderen Stellen und gekippt</translation>
    </message>
    <message>
        <source>the board faces the camera in nearly all pictures, so focal length and distance are undetermined; tilt it by 20 to 45 degrees in all directions</source>
        <translation>die Tafel steht in fast allen Bildern gerade vor der Kamera, was Brennweite und Abstand offen lässt; kippen Sie sie um 20 bis 45 Grad in alle Richtungen</translation>
    </message>
    <message>
        <source>the corners of the board fit no lens: the residual is %1 pixels, where 0.1 to 0.5 are usual; is the print flat, and the focus fixed?</source>
        <translation>die Ecken der Tafel passen zu keiner Linse: %1 Bildpunkte bleiben, üblich sind 0.1 bis 0.5; ist der Druck eben und der Fokus fest?</translation>
    </message>
    <message>
        <source>camera: "tone_exponent" is %1; it is 0 (sRGB) or 1 to 3</source>
        <translation>camera: „tone_exponent“ ist %1; möglich: 0 (sRGB) oder 1 bis 3</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 muss ein Objekt sein</translation>
    </message>
    <message>
        <source>the folder is not empty; name a new one</source>
        <translation>der Ordner ist nicht leer; nennen Sie einen neuen</translation>
    </message>
    <message>
        <source>no such folder; expected a folder of pictures, such as 'bodkin scene render' makes</source>
        <translation>diesen Ordner gibt es nicht; erwartet: ein Ordner mit Bildern, wie „bodkin scene render“ ihn macht</translation>
    </message>
    <message>
        <source>"frames" must be a list of at least one picture</source>
        <translation>„frames“ muss eine Liste mit mindestens einem Bild sein</translation>
    </message>
    <message>
        <source>"camera_from_body" is missing</source>
        <translation>„camera_from_body“ fehlt</translation>
    </message>
    <message>
        <source>its bodies differ from those of the first frame</source>
        <translation>seine Körper unterscheiden sich von denen des ersten Bildes</translation>
    </message>
    <message>
        <source>no pictures (.png, .jpg) in this folder</source>
        <translation>keine Bilder (.png, .jpg) in diesem Ordner</translation>
    </message>
    <message>
        <source>it has more than 64 million pixels</source>
        <translation>es hat mehr als 64 Millionen Bildpunkte</translation>
    </message>
    <message>
        <source>its data end early or are damaged</source>
        <translation>seine Daten enden zu früh oder sind beschädigt</translation>
    </message>
    <message>
        <source>not a valid JPEG picture: %1</source>
        <translation>kein brauchbares JPEG-Bild: %1</translation>
    </message>
    <message>
        <source>not a JSON object that describes a %1</source>
        <translation>kein JSON-Objekt, das dies beschreibt: %1</translation>
    </message>
    <message>
        <source>"%1" is unknown; there are %2</source>
        <translation>„%1“ ist unbekannt; es gibt %2</translation>
    </message>
    <message>
        <source>"%1" is %2; it must be a number from %3 to %4</source>
        <translation>„%1“ ist %2; es muss eine Zahl von %3 bis %4 sein</translation>
    </message>
    <message>
        <source>"%1" must be a text</source>
        <translation>„%1“ muss ein Text sein</translation>
    </message>
    <message>
        <source>"%1" must be three numbers, mm</source>
        <translation>„%1“ müssen drei Zahlen sein, mm</translation>
    </message>
    <message>
        <source>"%1" must be 16 numbers, a rigid 4 x 4 matrix row by row in mm</source>
        <translation>„%1“ müssen 16 Zahlen sein, eine starre 4 x 4-Matrix Zeile für Zeile in mm</translation>
    </message>
    <message>
        <source>there is no such camera; plug it in, and see 'ls /dev/video*'</source>
        <translation>diese Kamera gibt es nicht; stecken Sie sie ein, und sehen Sie mit 'ls /dev/video*' nach</translation>
    </message>
    <message>
        <source>another program uses this camera; close that program</source>
        <translation>ein anderes Programm benutzt diese Kamera; schließen Sie es</translation>
    </message>
    <message>
        <source>you may not use this camera; join the group video with 'sudo adduser $USER video' and log in again</source>
        <translation>Sie dürfen diese Kamera nicht benutzen; treten Sie mit 'sudo adduser $USER video' der Gruppe video bei und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>the camera refuses: %1</source>
        <translation>die Kamera verweigert: %1</translation>
    </message>
    <message>
        <source>this device gives no pictures; a camera often has two device files, so try the other one</source>
        <translation>dieses Gerät gibt keine Bilder; eine Kamera hat oft zwei Gerätedateien, versuchen Sie die andere</translation>
    </message>
    <message>
        <source>the camera gives neither MJPEG nor YUYV pictures, which are expected</source>
        <translation>die Kamera gibt weder MJPEG- noch YUYV-Bilder, die erwartet werden</translation>
    </message>
    <message>
        <source>the camera has no pictures of %1 x %2, the nearest are %3; ask for that size</source>
        <translation>die Kamera hat keine Bilder von %1 x %2, die nächsten sind %3; verlangen Sie diese Größe</translation>
    </message>
    <message>
        <source>the automatic focus of this camera cannot be switched off, and every focus is another lens; use a camera with fixed focus</source>
        <translation>der Autofokus dieser Kamera lässt sich nicht abschalten, und jeder Fokus ist eine andere Linse; nehmen Sie eine Kamera mit festem Fokus</translation>
    </message>
    <message>
        <source>this camera was calibrated with %1 %2, but %3; use the camera that was calibrated, or calibrate this one with 'bodkin camera calibrate'</source>
        <translation>diese Kamera wurde mit %1 %2 kalibriert, aber sie %3; nehmen Sie die kalibrierte Kamera, oder kalibrieren Sie diese mit „bodkin camera calibrate“</translation>
    </message>
    <message>
        <source>has %1 now</source>
        <translation>hat jetzt %1</translation>
    </message>
    <message>
        <source>has no such control</source>
        <translation>hat keinen solchen Regler</translation>
    </message>
    <message>
        <source>there is no memory for its pictures</source>
        <translation>für ihre Bilder ist kein Speicher da</translation>
    </message>
    <message>
        <source>the camera is gone; plug it in again</source>
        <translation>die Kamera ist weg; stecken Sie sie wieder ein</translation>
    </message>
    <message>
        <source>%1 pictures one after the other were damaged; try another cable or socket</source>
        <translation>%1 Bilder nacheinander waren beschädigt; versuchen Sie ein anderes Kabel oder einen anderen Anschluss</translation>
    </message>
    <message>
        <source>no picture came for two seconds; is the cable intact?</source>
        <translation>zwei Sekunden lang kam kein Bild; ist das Kabel in Ordnung?</translation>
    </message>
    <message>
        <source>the exposure of this camera cannot be fixed; keep the light steady</source>
        <translation>die Belichtung dieser Kamera lässt sich nicht festhalten; halten Sie das Licht gleichmäßig</translation>
    </message>
    <message>
        <source>"bodies" must be a list of at least one body</source>
        <translation>„bodies“ muss eine Liste mit mindestens einem Körper sein</translation>
    </message>
    <message>
        <source>a body must be an object</source>
        <translation>ein Körper muss ein Objekt sein</translation>
    </message>
    <message>
        <source>"axis" has no length</source>
        <translation>„axis“ hat keine Länge</translation>
    </message>
    <message>
        <source>"faces" must be a list of at least one face</source>
        <translation>„faces“ muss eine Liste mit mindestens einer Fläche sein</translation>
    </message>
    <message>
        <source>a face must be an object</source>
        <translation>eine Fläche muss ein Objekt sein</translation>
    </message>
    <message>
        <source>marker %1 stands on "%2" and on "%3"; a marker may be there once</source>
        <translation>Marke %1 steht auf „%2“ und auf „%3“; eine Marke darf es einmal geben</translation>
    </message>
    <message>
        <source>body "%1" has no marker to print</source>
        <translation>der Körper „%1“ hat keine Marke zum Drucken</translation>
    </message>
    <message>
        <source>body "%1" takes %2 x %3 mm on paper; an A4 page holds 210 x 275 mm</source>
        <translation>der Körper „%1“ braucht %2 x %3 mm Papier; eine A4-Seite fasst 210 x 275 mm</translation>
    </message>
    <message>
        <source>there is nothing of that name; expected a folder of pictures, such as 'bodkin scene render' makes, a video file or a camera such as /dev/video0</source>
        <translation>nichts hat diesen Namen; erwartet: ein Ordner mit Bildern, wie „bodkin scene render“ ihn macht, eine Videodatei oder eine Kamera wie /dev/video0</translation>
    </message>
    <message>
        <source>%1 poses are slow enough and %2 are too fast; at least %3 are needed, so turn the body more slowly and for longer</source>
        <translation>%1 Lagen sind langsam genug und %2 zu schnell; nötig sind mindestens %3, drehen Sie den Körper langsamer und länger</translation>
    </message>
    <message>
        <source>the body turned about one axis only, so its tip is undetermined; tilt it in all directions</source>
        <translation>der Körper drehte sich nur um eine Achse, was seine Spitze offen lässt; kippen Sie ihn in alle Richtungen</translation>
    </message>
    <message>
        <source>the body was tilted by %1 degrees in all; at least %2 are needed to find its tip, so tilt it further in all directions</source>
        <translation>der Körper wurde insgesamt um %1 Grad gekippt; um seine Spitze zu finden, braucht es mindestens %2, kippen Sie ihn weiter in alle Richtungen</translation>
    </message>
    <message>
        <source>the body was spun by %1 degrees; at least %2 are needed to find its axis</source>
        <translation>der Körper wurde um %1 Grad gedreht; um seine Achse zu finden, braucht es mindestens %2</translation>
    </message>
    <message>
        <source>there is a point called '%1' already; give each a name of its own</source>
        <translation>es gibt schon einen Punkt namens „%1“; geben Sie jedem einen eigenen Namen</translation>
    </message>
    <message>
        <source>registration: %1 fixed and %2 moving points, which are paired by their order; give both names, or --match to pair them by their distances</source>
        <translation>Registrierung: %1 feste und %2 bewegte Punkte, die nach ihrer Reihenfolge gepaart werden; geben Sie beiden Namen, oder --match, um sie nach ihren Abständen zu paaren</translation>
    </message>
    <message>
        <source>registration: the %1 points lie on a line, so the rotation about it is undetermined; add a point off that line</source>
        <translation>Registrierung: die Punkte (%1) liegen auf einer Geraden, was die Drehung um sie offen lässt; fügen Sie einen Punkt abseits dieser Geraden hinzu</translation>
    </message>
    <message>
        <source>registration: the points that match in both sets are on a line, so the rotation about it is undetermined; check that a point off that line is in both sets</source>
        <translation>Registrierung: die Punkte, die in beiden Mengen gleich liegen, sind auf einer Geraden, was die Drehung um sie offen lässt; prüfen Sie, ob ein Punkt abseits dieser Geraden in beiden Mengen ist</translation>
    </message>
    <message>
        <source>registration: the number of %1 points is %2, expected at least 3 to pair them by their distances</source>
        <translation>Registrierung: die Zahl der Punkte (%1) ist %2, erwartet: mindestens 3, um sie nach ihren Abständen zu paaren</translation>
    </message>
    <message>
        <source>the points can be paired in more than one way that fits; move one of them so that their distances differ, or give them names</source>
        <translation>die Punkte lassen sich auf mehr als eine passende Weise paaren; versetzen Sie einen von ihnen, damit ihre Abstände sich unterscheiden, oder geben Sie ihnen Namen</translation>
    </message>
    <message>
        <source>"covariance" is not valid, expected 49 numbers, a symmetric 7 x 7 matrix row by row, as 'bodkin register -o' writes it</source>
        <translation>„covariance“ ist nicht gültig, erwartet: 49 Zahlen, eine symmetrische 7 x 7-Matrix Zeile für Zeile, wie 'bodkin register -o' sie schreibt</translation>
    </message>
    <message>
        <source>registration: no three points of one set have the same distances as three of the other; check that both show the same fiducials, in mm</source>
        <translation>Registrierung: keine drei Punkte der einen Menge liegen wie drei der anderen; prüfen Sie, ob beide dieselben Marken zeigen, in mm</translation>
    </message>
    <message>
        <source>registration: %1 fixed and %2 moving points; every point needs its partner</source>
        <translation>Registrierung: %1 feste und %2 bewegte Punkte; jeder Punkt braucht seinen Partner</translation>
    </message>
    <message>
        <source>registration: %1 pairs of points; at least %2 are needed%3</source>
        <translation>Registrierung: %1 Punktpaare; nötig sind mindestens %2%3</translation>
    </message>
    <message>
        <source>registration: the points lie on a line, so the rotation about it is undetermined; add a point off that line</source>
        <translation>Registrierung: die Punkte liegen auf einer Linie, was die Drehung darum offen lässt; fügen Sie einen Punkt daneben hinzu</translation>
    </message>
    <message>
        <source>%1, line %2: expected name,x,y,z or x,y,z in mm, with or without three standard deviations above 0, found '%3'</source>
        <translation>%1, Zeile %2: erwartet name,x,y,z oder x,y,z in mm, mit oder ohne drei Standardabweichungen über 0, gefunden „%3“</translation>
    </message>
    <message>
        <source>some points have a name and some have none</source>
        <translation>manche Punkte haben einen Namen und manche keinen</translation>
    </message>
    <message>
        <source>some points have standard deviations and some have none</source>
        <translation>manche Punkte haben Standardabweichungen und manche keine</translation>
    </message>
    <message>
        <source>its camera is not calibrated; calibrate it with 'bodkin camera calibrate' and name the file with --camera</source>
        <translation>seine Kamera ist nicht kalibriert; kalibrieren Sie sie mit „bodkin camera calibrate“ und nennen Sie die Datei mit --camera</translation>
    </message>
    <message>
        <source>the picture has %1 x %2 pixels, but the camera was calibrated at %3 x %4; calibrate it at the size that is used</source>
        <translation>das Bild hat %1 x %2 Bildpunkte, aber die Kamera wurde mit %3 x %4 kalibriert; kalibrieren Sie sie in der benutzten Größe</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>an AVI file holds 2 GB; make a shorter video</source>
        <translation>eine AVI-Datei fasst 2 GB; machen Sie ein kürzeres Video</translation>
    </message>
    <message>
        <source>cannot be written; is the disk full?</source>
        <translation>kann nicht geschrieben werden; ist die Platte voll?</translation>
    </message>
    <message>
        <source>no pipe can be opened; too many files are open</source>
        <translation>es lässt sich keine Leitung öffnen; zu viele Dateien sind offen</translation>
    </message>
    <message>
        <source>the program %1 is missing; install the Debian package ffmpeg</source>
        <translation>das Programm %1 fehlt; installieren Sie das Debian-Paket ffmpeg</translation>
    </message>
    <message>
        <source>no picture of this video can be decoded</source>
        <translation>kein Bild dieses Videos lässt sich entschlüsseln</translation>
    </message>
    <message>
        <source>no body fits the picture although all rest: the lens, its focus or the light changed since the camera was calibrated; calibrate it again</source>
        <translation>kein Körper passt zum Bild, obwohl alle ruhen: Linse, Fokus oder Licht haben sich seit der Kalibrierung der Kamera geändert; kalibrieren Sie sie neu</translation>
    </message>
    <message>
        <source>a board of markers does not fit the picture although it rests: it is bent, or the lens or its focus changed since the camera was calibrated; press it flat, or else calibrate the camera again</source>
        <translation>eine Tafel mit Marken passt nicht zum Bild, obwohl sie ruht: Sie ist verbogen, oder Linse oder Fokus haben sich seit der Kalibrierung der Kamera geändert; drücken Sie sie flach, sonst kalibrieren Sie die Kamera neu</translation>
    </message>
    <message>
        <source>the pictures are mirrored left to right; switch mirroring off in the camera</source>
        <translation>die Bilder sind seitenverkehrt; schalten Sie die Spiegelung in der Kamera ab</translation>
    </message>
    <message>
        <source>no marker of the dictionary 4x4_50 is in these pictures; print the markers with 'bodkin markers --pdf' and keep them in view</source>
        <translation>keine Marke aus dem Verzeichnis 4x4_50 ist in diesen Bildern; drucken Sie die Marken mit „bodkin markers --pdf“ und halten Sie sie im Bild</translation>
    </message>
    <message>
        <source>markers are seen that are on no body (%1); name the file of the bodies that carry them, or keep those of 'bodkin markers --pdf' in view</source>
        <translation>es sind Marken zu sehen, die auf keinem Körper sind (%1); nennen Sie die Datei der Körper, die sie tragen, oder halten Sie die von „bodkin markers --pdf“ im Bild</translation>
    </message>
    <message>
        <source>the time between pictures varies from %1 to %2 ms; every picture keeps its own time</source>
        <translation>die Zeit zwischen Bildern schwankt von %1 bis %2 ms; jedes Bild behält seine eigene Zeit</translation>
    </message>
    <message>
        <source>not a video that ffmpeg reads; expected a folder of pictures, a video file or a camera such as /dev/video0</source>
        <translation>kein Video, das ffmpeg liest; erwartet: ein Ordner mit Bildern, eine Videodatei oder eine Kamera wie /dev/video0</translation>
    </message>
    <message>
        <source>unknown tissue</source>
        <translation>unbekanntes Gewebe</translation>
    </message>
    <message>
        <source>the session holds no tick, so that there is nothing to judge</source>
        <translation>die Sitzung enthält keinen Takt, es gibt also nichts zu beurteilen</translation>
    </message>
    <message>
        <source>there are %1 rows, expected the names of metrics and at least one attempt</source>
        <translation>es gibt %1 Zeilen, erwartet: die Namen der Messgrößen und mindestens ein Versuch</translation>
    </message>
    <message>
        <source>%1, line %2: there are %3 fields, expected %4 as in the first line</source>
        <translation>%1, Zeile %2: es gibt %3 Felder, erwartet: %4 wie in der ersten Zeile</translation>
    </message>
    <message>
        <source>%1, line %2: %3 is '%4', expected a number or nothing</source>
        <translation>%1, Zeile %2: %3 ist „%4“, erwartet: eine Zahl oder nichts</translation>
    </message>
    <message>
        <source>no column is a metric, expected names such as path_length_mm</source>
        <translation>keine Spalte ist eine Messgröße, erwartet: Namen wie path_length_mm</translation>
    </message>
    <message>
        <source>its attempts were measured with the thresholds %1, the new ones with %2; delete the table with 'bodkin experts delete %3' and import all sessions by one procedure</source>
        <translation>seine Versuche wurden mit den Schwellen %1 gemessen, die neuen mit %2; löschen Sie die Tabelle mit „bodkin experts delete %3“ und importieren Sie alle Sitzungen nach einer Prozedur</translation>
    </message>
    <message>
        <source>its columns are not those of this version; delete the table with 'bodkin experts delete %1' and import the sessions again</source>
        <translation>die Spalten sind nicht die dieser Version; löschen Sie die Tabelle mit „bodkin experts delete %1“ und importieren Sie die Sitzungen neu</translation>
    </message>
    <message>
        <source>the procedure %1 names the tissue '%2', which neither the session's patient nor Bodkin knows; correct the name</source>
        <translation>der Eingriff %1 nennt das Gewebe „%2“, das weder der Patient der Sitzung noch Bodkin kennt; berichtigen Sie den Namen</translation>
    </message>
    <message>
        <source>the case %1 is not a folder with a case.xml; make one there with 'bodkin case synthesize', or name %2</source>
        <translation>der Fall %1 ist kein Ordner mit einer case.xml; machen Sie dort einen mit „bodkin case synthesize“, oder nennen Sie %2</translation>
    </message>
    <message>
        <source>the case %1 has no planned path; plan one with 'bodkin case new'</source>
        <translation>der Fall %1 hat keinen geplanten Weg; planen Sie einen mit „bodkin case new“</translation>
    </message>
    <message>
        <source>stage %1 must be passed but does not say by what; give it passes or mastery</source>
        <translation>Stufe %1 muss bestanden werden, sagt aber nicht wodurch; geben Sie ihr passes oder mastery</translation>
    </message>
    <message>
        <source>there is no plan %1, expected one of %2, or the name of a plan file</source>
        <translation>es gibt keinen Plan %1, erwartet: einer von %2, oder der Name einer Plandatei</translation>
    </message>
    <message>
        <source>there is no procedure %1, expected one of %2</source>
        <translation>es gibt keinen Eingriff %1, erwartet: einer von %2</translation>
    </message>
    <message>
        <source>there is no procedure %1, expected one of %2, or the name of a procedure file</source>
        <translation>es gibt keinen Eingriff %1, erwartet: einer von %2, oder der Name einer Eingriffsdatei</translation>
    </message>
    <message>
        <source>%1 is %2, expected a label of 1 to %3 letters, digits, blanks, '_', '-' and '.', such as trainee-07</source>
        <translation>%1 ist %2, erwartet: eine Bezeichnung aus 1 bis %3 Buchstaben, Ziffern, Leerzeichen, „_“, „-“ und „.“, wie trainee-07</translation>
    </message>
    <message>
        <source>a verdict is %1, expected pass, borderline, fail or dangerous</source>
        <translation>ein Urteil ist %1, erwartet: pass, borderline, fail oder dangerous</translation>
    </message>
    <message>
        <source>the metrics of an attempt are no JSON object</source>
        <translation>die Messgrößen eines Versuchs sind kein JSON-Objekt</translation>
    </message>
    <message>
        <source>the findings of an attempt are no JSON array</source>
        <translation>die Befunde eines Versuchs sind kein JSON-Feld</translation>
    </message>
    <message>
        <source>the store %1 has version %2, made by a newer Bodkin, and this one knows up to %3; update Bodkin here</source>
        <translation>die Ablage %1 hat Version %2 von einem neueren Bodkin, und dieses kennt bis %3; erneuern Sie Bodkin hier</translation>
    </message>
    <message>
        <source>the store %1: %2</source>
        <translation>die Ablage %1: %2</translation>
    </message>
    <message>
        <source>the store %1 is locked by another station; nothing was changed: try again</source>
        <translation>die Ablage %1 ist von einer anderen Station gesperrt; nichts wurde geändert: versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the disk of the store %1 is full; nothing was changed: free space there and try again</source>
        <translation>die Platte der Ablage %1 ist voll; nichts wurde geändert: schaffen Sie dort Platz und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the store %1 does not let this user write: %2; its owner can GRANT that</source>
        <translation>die Ablage %1 lässt diesen Benutzer nicht schreiben: %2; ihr Eigentümer kann es mit GRANT erlauben</translation>
    </message>
    <message>
        <source>this Bodkin was built without PostgreSQL; install libpqxx-dev and build it again, or name a file</source>
        <translation>dieses Bodkin ist ohne PostgreSQL gebaut; installieren Sie libpqxx-dev und bauen Sie es neu, oder nennen Sie eine Datei</translation>
    </message>
    <message>
        <source>the store %1 has no trainee %2; 'bodkin results list' names them</source>
        <translation>die Ablage %1 hat keinen Übenden %2; „bodkin results list“ nennt sie</translation>
    </message>
    <message>
        <source>%1 is a database, but not of results; name another file with --store</source>
        <translation>%1 ist eine Datenbank von etwas anderem als Ergebnissen; nennen Sie mit --store eine andere Datei</translation>
    </message>
    <message>
        <source>the store %1 is locked by another program; nothing was changed: try again when that has ended</source>
        <translation>die Ablage %1 ist von einem anderen Programm gesperrt; nichts wurde geändert: versuchen Sie es wieder, wenn es beendet ist</translation>
    </message>
    <message>
        <source>the store %1 cannot be written; nothing was changed: free space on its disk and try again</source>
        <translation>die Ablage %1 ist nicht beschreibbar; nichts wurde geändert: schaffen Sie auf ihrer Platte Platz und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>you may only read the store %1; change the rights of the file and of its folder</source>
        <translation>die Ablage %1 dürfen Sie nur lesen; ändern Sie die Rechte der Datei und ihres Ordners</translation>
    </message>
    <message>
        <source>the store %1 cannot be opened; its folder must exist and be yours to write</source>
        <translation>die Ablage %1 lässt sich nicht öffnen; ihr Ordner muss da und für Sie beschreibbar sein</translation>
    </message>
    <message>
        <source>nothing on this station waits for the store %1; 'bodkin results list' names the stores that something waits for</source>
        <translation>an diesem Arbeitsplatz wartet nichts auf die Ablage %1; „bodkin results list“ nennt die Ablagen, auf die etwas wartet</translation>
    </message>
    <message>
        <source>%1 is not a store of results; name another file with --store</source>
        <translation>%1 ist keine Ablage von Ergebnissen; nennen Sie mit --store eine andere Datei</translation>
    </message>
    <message>
        <source>the store %1 is damaged; put it aside and add the sessions again with 'bodkin results add'</source>
        <translation>die Ablage %1 ist beschädigt; legen Sie sie beiseite und fügen Sie die Sitzungen mit „bodkin results add“ neu hinzu</translation>
    </message>
    <message>
        <source>%1 cannot be opened; is it there, and may you read it?</source>
        <translation>%1 lässt sich nicht öffnen; ist es da, und dürfen Sie es lesen?</translation>
    </message>
    <message>
        <source>the needle's path meets no part of the mesh; lead it through the meshed part of the patient, or mesh the patient again around this path</source>
        <translation>der Weg der Nadel trifft keinen Teil des Netzes; führen Sie ihn durch den vernetzten Teil des Patienten, oder vernetzen Sie den Patienten um diesen Weg neu</translation>
    </message>
    <message>
        <source>the body's %1 free nodes with %2 in the corridor need %3 bytes (%4 GB) to be prepared, but only %5 (%6 GB) may be taken; mesh more coarsely, choose a smaller corridor, or allow more memory</source>
        <translation>die %1 freien Knoten des Körpers mit %2 im Korridor brauchen %3 Byte (%4 GB) zur Vorbereitung, aber nur %5 (%6 GB) sind erlaubt; vernetzen Sie gröber, wählen Sie einen kleineren Korridor, oder erlauben Sie mehr Speicher</translation>
    </message>
    <message>
        <source>element %1 of the mesh at %2 is of %3, which has no material; give the tissue an element &lt;deformable&gt; in the tissue library</source>
        <translation>Element %1 des Netzes bei %2 ist aus %3, das kein Material hat; geben Sie dem Gewebe ein Element &lt;deformable&gt; in der Gewebesammlung</translation>
    </message>
    <message>
        <source>the path about which the deformable body is prepared ends where it begins; give another target</source>
        <translation>der Weg, um den der verformbare Körper vorbereitet wird, endet, wo er beginnt; geben Sie ein anderes Ziel an</translation>
    </message>
    <message>
        <source>no node of the mesh that can move lies within %1 mm of the path; mesh the patient again around this path, or give a larger corridor_radius_mm</source>
        <translation>kein beweglicher Knoten des Netzes liegt innerhalb von %1 mm um den Weg; vernetzen Sie den Patienten um diesen Weg neu, oder geben Sie ein größeres corridor_radius_mm an</translation>
    </message>
    <message>
        <source>the machine refused %1 bytes of memory; end other programs, or take a smaller body</source>
        <translation>der Rechner verweigerte %1 Byte Speicher; beenden Sie andere Programme, oder nehmen Sie einen kleineren Körper</translation>
    </message>
    <message>
        <source>every node of the body is fixed, so that nothing can move; fix fewer of them</source>
        <translation>jeder Knoten des Körpers ist fest, sodass sich nichts bewegen kann; halten Sie weniger fest</translation>
    </message>
    <message>
        <source>none of the %1 nodes of the corridor can move, so that a needle would feel nothing; lead the corridor through soft tissue</source>
        <translation>keiner der %1 Knoten des Korridors kann sich bewegen, eine Nadel würde also nichts spüren; führen Sie den Korridor durch Weichgewebe</translation>
    </message>
    <message>
        <source>no node of the body is fixed, so that any force would carry it away; fix its bone or its far side</source>
        <translation>kein Knoten des Körpers ist fest, jede Kraft trüge ihn also fort; halten Sie seinen Knochen oder seine ferne Seite fest</translation>
    </message>
    <message>
        <source>a body of %1 nodes is too large to be ordered; mesh it more coarsely</source>
        <translation>ein Körper von %1 Knoten ist zu groß zum Ordnen; vernetzen Sie ihn gröber</translation>
    </message>
    <message>
        <source>METIS could not order the %1 nodes of the body (status %2); is there enough memory?</source>
        <translation>METIS konnte die %1 Knoten des Körpers nicht ordnen (Status %2); ist genug Speicher da?</translation>
    </message>
    <message>
        <source>tissue %1 of element %2 at %3 has no material; give the tissue a Young's modulus and a Poisson's ratio, or mesh the body without it</source>
        <translation>Gewebe %1 von Element %2 bei %3 hat kein Material; geben Sie dem Gewebe einen Elastizitätsmodul und eine Querkontraktionszahl, oder vernetzen Sie den Körper ohne es</translation>
    </message>
    <message>
        <source>the motion would take %1 million ticks, expected at most %2 million; give a larger --speed or a shorter path</source>
        <translation>die Bewegung bräuchte %1 Millionen Takte, erwartet: höchstens %2 Millionen; geben Sie eine größere --speed oder einen kürzeren Weg an</translation>
    </message>
    <message>
        <source>the %1 %2 lies outside the volume, which reaches from %3 to %4 (LPS mm)</source>
        <translation>%1 %2 liegt außerhalb des Volumens, das von %3 bis %4 reicht (LPS mm)</translation>
    </message>
    <message>
        <source>the case '%1' has no planned path; give both --entry and --target in LPS mm</source>
        <translation>der Fall „%1“ hat keinen geplanten Weg; geben Sie --entry und --target in LPS mm an</translation>
    </message>
    <message>
        <source>the entry and the target of a path must be finite numbers in LPS mm</source>
        <translation>Eintritt und Ziel eines Wegs müssen endliche Zahlen in LPS mm sein</translation>
    </message>
    <message>
        <source>the entry %1 and the target %2 are %3 mm apart, expected at least %4 mm</source>
        <translation>Eintritt %1 und Ziel %2 liegen %3 mm auseinander, erwartet: mindestens %4 mm</translation>
    </message>
    <message>
        <source>%1 mm beyond the target lies outside the volume; go less deep with --beyond or --motion</source>
        <translation>%1 mm hinter dem Ziel liegt außerhalb des Volumens; gehen Sie mit --beyond oder --motion weniger tief</translation>
    </message>
    <message>
        <source>this file of translations cannot be read; name another language</source>
        <translation>diese Datei mit Übersetzungen kann nicht gelesen werden; nennen Sie eine andere Sprache</translation>
    </message>
    <message>
        <source>expected the element TS of Qt Linguist</source>
        <translation>erwartet: das Element TS von Qt Linguist</translation>
    </message>
    <message>
        <source>Bladder</source>
        <translation>Blase</translation>
    </message>
    <message>
        <source>Conception Vessel</source>
        <translation>Konzeptionsgefäß</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Governor Vessel</source>
        <translation>Lenkergefäß</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>Large Intestine</source>
        <translation>Dickdarm</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Pericardium</source>
        <translation>Perikard</translation>
    </message>
    <message>
        <source>Small Intestine</source>
        <translation>Dünndarm</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>Triple Energizer</source>
        <translation>Dreifacher Erwärmer</translation>
    </message>
    <message>
        <source>abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>ankle</source>
        <translation>Knöchel</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Gesicht</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>hip</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>knee</source>
        <translation>Knie</translation>
    </message>
    <message>
        <source>leg</source>
        <translation>Unterschenkel</translation>
    </message>
    <message>
        <source>lower back</source>
        <translation>unterer Rücken</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>upper back</source>
        <translation>oberer Rücken</translation>
    </message>
    <message>
        <source>wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>oblique upwards</source>
        <translation>schräg nach oben</translation>
    </message>
    <message>
        <source>oblique, towards the spine</source>
        <translation>schräg, zur Wirbelsäule</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>perpendicular or oblique</source>
        <translation>senkrecht oder schräg</translation>
    </message>
    <message>
        <source>perpendicular or slightly upwards</source>
        <translation>senkrecht oder etwas nach oben</translation>
    </message>
    <message>
        <source>perpendicular or towards the back</source>
        <translation>senkrecht oder zum Rücken</translation>
    </message>
    <message>
        <source>perpendicular or towards the spine</source>
        <translation>senkrecht oder zur Wirbelsäule</translation>
    </message>
    <message>
        <source>perpendicular, slightly medial</source>
        <translation>senkrecht, etwas nach medial</translation>
    </message>
    <message>
        <source>perpendicular, slightly upwards</source>
        <translation>senkrecht, etwas nach oben</translation>
    </message>
    <message>
        <source>transverse</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>transverse along the sternum</source>
        <translation>flach entlang des Brustbeins</translation>
    </message>
    <message>
        <source>1.5-2 cun when entering the foramen</source>
        <translation>1.5 bis 2 Cun beim Eintritt in das Foramen</translation>
    </message>
    <message>
        <source>anterior tibial vessels when deep</source>
        <translation>in der Tiefe die vorderen Schienbeingefäße</translation>
    </message>
    <message>
        <source>common fibular nerve</source>
        <translation>N. fibularis communis</translation>
    </message>
    <message>
        <source>full bladder, pregnancy</source>
        <translation>volle Blase, Schwangerschaft</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>kidney; psoas at 32-38 mm (layer_thickness.csv)</source>
        <translation>Niere; Psoas in 32 bis 38 mm (layer_thickness.csv)</translation>
    </message>
    <message>
        <source>median nerve; many textbooks stop at 0.8 cun</source>
        <translation>N. medianus; viele Lehrbücher enden bei 0.8 Cun</translation>
    </message>
    <message>
        <source>peritoneum</source>
        <translation>Bauchfell</translation>
    </message>
    <message>
        <source>peritoneum, liver</source>
        <translation>Bauchfell, Leber</translation>
    </message>
    <message>
        <source>peritoneum, pregnancy</source>
        <translation>Bauchfell, Schwangerschaft</translation>
    </message>
    <message>
        <source>pleura</source>
        <translation>Pleura</translation>
    </message>
    <message>
        <source>pleura at 17.4 mm in men, 14.6 mm in women (Chen et al. 2018)</source>
        <translation>Pleura in 17.4 mm bei Männern, 14.6 mm bei Frauen (Chen et al. 2018)</translation>
    </message>
    <message>
        <source>pleura, kidney</source>
        <translation>Pleura, Niere</translation>
    </message>
    <message>
        <source>pleura; textbook maxima from 0.3 to 1.5 cun, see PMC3804079 Table 3</source>
        <translation>Pleura; Höchsttiefen in Lehrbüchern von 0.3 bis 1.5 Cun, siehe PMC3804079, Tabelle 3</translation>
    </message>
    <message>
        <source>popliteal vessels, tibial nerve</source>
        <translation>Kniekehlengefäße, N. tibialis</translation>
    </message>
    <message>
        <source>posterior tibial artery</source>
        <translation>A. tibialis posterior</translation>
    </message>
    <message>
        <source>pregnancy</source>
        <translation>Schwangerschaft</translation>
    </message>
    <message>
        <source>radial artery, cephalic vein</source>
        <translation>A. radialis, V. cephalica</translation>
    </message>
    <message>
        <source>sciatic nerve</source>
        <translation>N. ischiadicus</translation>
    </message>
    <message>
        <source>spinal canal</source>
        <translation>Spinalkanal</translation>
    </message>
    <message>
        <source>brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>sternal foramen, pericardium</source>
        <translation>Foramen im Brustbein, Perikard</translation>
    </message>
    <message>
        <source>ulnar artery and nerve</source>
        <translation>A. und N. ulnaris</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 in %2 mm</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>ramping</source>
        <translation>Kraft kommt</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>faulted</source>
        <translation>gestört</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>%1 nodes are too few to hold the layers of the planned path, of which the thinnest are %2; expected at least %3: give --nodes %4, or --merge-layers for a mesh without them</source>
        <translation>%1 Knoten sind zu wenige für die Schichten des geplanten Wegs, deren dünnste sind: %2; erwartet: mindestens %3, also --nodes %4, oder --merge-layers für ein Netz ohne sie</translation>
    </message>
    <message>
        <source>no mesh holds %1 on the planned path; expected a path that crosses these layers less obliquely, or --merge-layers for a mesh without them</source>
        <translation>kein Netz hält auf dem geplanten Weg: %1; erwartet: ein Weg, der diese Schichten weniger schräg kreuzt, oder --merge-layers für ein Netz ohne sie</translation>
    </message>
    <message>
        <source>the session has format version %1, this Bodkin reads versions %2 to %3; open it with the version of Bodkin that wrote it</source>
        <translation>die Sitzung hat die Formatversion %1, dieses Bodkin liest die Versionen %2 bis %3; öffnen Sie sie mit der Version von Bodkin, die sie geschrieben hat</translation>
    </message>
    <message>
        <source>--case: %1</source>
        <translation>--case: %1</translation>
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
<context>
    <name>Words</name>
    <message>
        <source>contact #1 %</source>
        <translation>Kontakt #1 %</translation>
    </message>
    <message>
        <source>press #1 mm</source>
        <translation>eingedrückt #1 mm</translation>
    </message>
    <message>
        <source>FROZEN</source>
        <translation>ANGEHALTEN</translation>
    </message>
    <message>
        <source>The probe is outside the volume that the CT shows; move it to the patient's skin.</source>
        <translation>Der Schallkopf ist außerhalb des Volumens, das die CT zeigt; führen Sie ihn zur Haut des Patienten.</translation>
    </message>
    <message>
        <source>The probe does not touch the skin; press it on, or use gel.</source>
        <translation>Der Schallkopf berührt die Haut nicht; drücken Sie ihn an, oder nehmen Sie Gel.</translation>
    </message>
    <message>
        <source>The probe's face is inside the body; pull it back to the skin.</source>
        <translation>Die Fläche des Schallkopfs ist im Körper; ziehen Sie ihn zur Haut zurück.</translation>
    </message>
    <message>
        <source>The probe's pose is not a rigid placement of finite numbers; check where it comes from.</source>
        <translation>Die Lage des Schallkopfs besteht nicht aus endlichen Zahlen einer starren Bewegung; prüfen Sie, woher sie kommt.</translation>
    </message>
    <message>
        <source>operator '%1': phase '%2' waits for a share of the force at which '%3' gives way, but the patient's tissue library has no such tissue that gives way; expected the name of a tissue with a break_force_N</source>
        <translation>Bediener „%1“: Phase „%2“ wartet auf einen Anteil der Kraft, bei der „%3“ nachgibt, aber die Gewebebibliothek des Patienten hat kein solches Gewebe, das nachgibt; erwartet wird der Name eines Gewebes mit break_force_N</translation>
    </message>
    <message>
        <source>phase '%1' of operator '%2' waits for a share of a force, expected one in N for the patient</source>
        <translation>Phase „%1“ von Bediener „%2“ wartet auf einen Anteil einer Kraft, erwartet wird eine in N für den Patienten</translation>
    </message>
    <message>
        <source>servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>weight of the handle</source>
        <translation>Gewicht des Griffs</translation>
    </message>
    <message>
        <source>grasp time</source>
        <translation>Greifzeit</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>synthetic patient</source>
        <translation>künstlicher Patient</translation>
    </message>
    <message>
        <source>synthetic shoulder</source>
        <translation>künstliche Schulter</translation>
    </message>
    <message>
        <source>layered compression</source>
        <translation>geschichtete Kompression</translation>
    </message>
    <message>
        <source>live ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>longest time</source>
        <translation>Höchstdauer</translation>
    </message>
    <message>
        <source>age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>flexion</source>
        <translation>Beugung</translation>
    </message>
    <message>
        <source>scoliosis</source>
        <translation>Skoliose</translation>
    </message>
    <message>
        <source>calcification</source>
        <translation>Verkalkung</translation>
    </message>
    <message>
        <source>tissue surface</source>
        <translation>Gewebeoberfläche</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>moving body</source>
        <translation>bewegter Körper</translation>
    </message>
    <message>
        <source>face of the probe</source>
        <translation>Fläche der Sonde</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>force scale</source>
        <translation>Maßstab der Kraft</translation>
    </message>
    <message>
        <source>tremor</source>
        <translation>Zittern</translation>
    </message>
</context>
</TS>
