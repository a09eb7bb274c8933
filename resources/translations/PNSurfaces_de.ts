<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A face that lies on a quadric; the placement follows it</source>
            <translation>Eine Fläche, die auf einer Quadrik liegt; die Lage folgt ihr</translation>
        </message>
        <message>
            <source>A ruled face, instead of the two curves</source>
            <translation>Eine Regelfläche, anstelle der zwei Kurven</translation>
        </message>
        <message>
            <source>Area of all faces, by integration</source>
            <translation>Inhalt aller Flächen, durch Integration</translation>
        </message>
        <message>
            <source>Bound on the distance to the true surface; proven, but for fits that are said to be measured</source>
            <translation>Schranke für den Abstand zur wahren Fläche; bewiesen, außer bei Näherungen, die als gemessen bezeichnet sind</translation>
        </message>
        <message>
            <source>Centres of the spheres A, B, C, AB, BC, CA: the control points of the mid-surface</source>
            <translation>Mittelpunkte der Kugeln A, B, C, AB, BC, CA: die Kontrollpunkte der Mittelfläche</translation>
        </message>
        <message>
            <source>Centres of the spheres: points of the mid-surface, a graph over the plane z = 0</source>
            <translation>Mittelpunkte der Kugeln: Punkte der Mittelfläche, eines Graphen über der Ebene z = 0</translation>
        </message>
        <message>
            <source>Conic constant at the end</source>
            <translation>Konische Konstante am Ende</translation>
        </message>
        <message>
            <source>Conic constant by the position s, a plain number, such as -1 + 0.5 * sin(pi*s)</source>
            <translation>Konische Konstante nach der Position s, eine reine Zahl, etwa -1 + 0.5 * sin(pi*s)</translation>
        </message>
        <message>
            <source>Conic constant, everywhere or at the start: below -1 a hyperbola, -1 a parabola, above an ellipse, 0 a circle</source>
            <translation>Konische Konstante, überall oder am Anfang: unter -1 eine Hyperbel, -1 eine Parabel, darüber eine Ellipse, 0 ein Kreis</translation>
        </message>
        <message>
            <source>Conic constants at the positions</source>
            <translation>Konische Konstanten an den Positionen</translation>
        </message>
        <message>
            <source>Degree along and across the faces</source>
            <translation>Grad entlang und quer zu den Flächen</translation>
        </message>
        <message>
            <source>Direction of parallel light</source>
            <translation>Richtung von parallelem Licht</translation>
        </message>
        <message>
            <source>Edges of the curve where the rulings end</source>
            <translation>Kanten der Kurve, an der die Erzeugenden enden</translation>
        </message>
        <message>
            <source>Edges of the curve where the rulings start</source>
            <translation>Kanten der Kurve, an der die Erzeugenden beginnen</translation>
        </message>
        <message>
            <source>Edges that the pipe runs through</source>
            <translation>Kanten, durch die das Rohr verläuft</translation>
        </message>
        <message>
            <source>Edges through the centres of the spheres</source>
            <translation>Kanten durch die Mittelpunkte der Kugeln</translation>
        </message>
        <message>
            <source>Edges through the centres or vertices of the sections</source>
            <translation>Kanten durch die Mitten oder Scheitel der Schnitte</translation>
        </message>
        <message>
            <source>Ellipses around the spine, or conics that open upwards from their vertex on the spine</source>
            <translation>Ellipsen um die Leitkurve oder Kegelschnitte, die sich vom Scheitel auf der Leitkurve nach oben öffnen</translation>
        </message>
        <message>
            <source>Estimated error of the area</source>
            <translation>Geschätzter Fehler des Flächeninhalts</translation>
        </message>
        <message>
            <source>Estimated error of the volume</source>
            <translation>Geschätzter Fehler des Volumens</translation>
        </message>
        <message>
            <source>Half-axes to the side at the positions, in mm</source>
            <translation>Halbachsen zur Seite an den Positionen, in mm</translation>
        </message>
        <message>
            <source>Half-axes upwards at the positions, in mm</source>
            <translation>Halbachsen nach oben an den Positionen, in mm</translation>
        </message>
        <message>
            <source>Half-axis a, along x</source>
            <translation>Halbachse a, entlang x</translation>
        </message>
        <message>
            <source>Half-axis b, along y</source>
            <translation>Halbachse b, entlang y</translation>
        </message>
        <message>
            <source>Half-axis c, along z; of a paraboloid its height at x = a</source>
            <translation>Halbachse c, entlang z; beim Paraboloid seine Höhe bei x = a</translation>
        </message>
        <message>
            <source>Half-axis to the side at the end</source>
            <translation>Halbachse zur Seite am Ende</translation>
        </message>
        <message>
            <source>Half-axis to the side by the position s and the length L of the spine, such as 20 mm + 5 mm * cos(pi*s)</source>
            <translation>Halbachse zur Seite aus der Position s und der Länge L der Leitkurve, etwa 20 mm + 5 mm * cos(pi*s)</translation>
        </message>
        <message>
            <source>Half-axis to the side, everywhere or at the start</source>
            <translation>Halbachse zur Seite, überall oder am Anfang</translation>
        </message>
        <message>
            <source>Half-axis upwards at the end</source>
            <translation>Halbachse nach oben am Ende</translation>
        </message>
        <message>
            <source>Half-axis upwards by the position s and the length L of the spine, such as 10 mm * exp(s)</source>
            <translation>Halbachse nach oben aus der Position s und der Länge L der Leitkurve, etwa 10 mm * exp(s)</translation>
        </message>
        <message>
            <source>Half-axis upwards, everywhere or at the start</source>
            <translation>Halbachse nach oben, überall oder am Anfang</translation>
        </message>
        <message>
            <source>How far a fit may be from what has no exact form</source>
            <translation>Wie weit eine Näherung von dem entfernt sein darf, was keine exakte Form hat</translation>
        </message>
        <message>
            <source>How far fits are off, part of the deviation; proven or measured</source>
            <translation>Wie weit Näherungen entfernt sind, Teil der Abweichung; bewiesen oder gemessen</translation>
        </message>
        <message>
            <source>How fast height and radius change along x, then along y, four numbers for every point; none to have them estimated</source>
            <translation>Wie schnell sich Höhe und Radius längs x ändern, dann längs y, vier Zahlen je Punkt; keine, damit sie geschätzt werden</translation>
        </message>
        <message>
            <source>How high a section goes above its vertex by the position s and the length L of the spine, such as 10 mm</source>
            <translation>Wie hoch ein Schnitt über seinen Scheitel reicht, nach der Position s und der Länge L der Leitkurve, etwa 10 mm</translation>
        </message>
        <message>
            <source>How high a section goes above its vertex, at the end</source>
            <translation>Wie hoch ein Schnitt am Ende über seinen Scheitel reicht</translation>
        </message>
        <message>
            <source>How high a section goes above its vertex, everywhere or at the start</source>
            <translation>Wie hoch ein Schnitt über seinen Scheitel reicht, überall oder am Anfang</translation>
        </message>
        <message>
            <source>How high sections go above their vertex at the positions, in mm</source>
            <translation>Wie hoch Schnitte an den Positionen über ihren Scheitel reichen, in mm</translation>
        </message>
        <message>
            <source>How the ends of a solid are closed</source>
            <translation>Wie die Enden eines Volumenkörpers geschlossen werden</translation>
        </message>
        <message>
            <source>How the measures of the sections run along the spine</source>
            <translation>Wie die Maße der Schnitte entlang der Leitkurve verlaufen</translation>
        </message>
        <message>
            <source>How the radius runs along the spine</source>
            <translation>Wie der Radius entlang der Leitkurve verläuft</translation>
        </message>
        <message>
            <source>How the squared radius runs along the spine</source>
            <translation>Wie der quadrierte Radius entlang der Leitkurve verläuft</translation>
        </message>
        <message>
            <source>Largest distance without a singular point</source>
            <translation>Größter Abstand ohne singulären Punkt</translation>
        </message>
        <message>
            <source>Largest measured distance of the face from the quadric</source>
            <translation>Größter gemessener Abstand der Fläche von der Quadrik</translation>
        </message>
        <message>
            <source>Largest x of the base surface</source>
            <translation>Größtes x der Grundfläche</translation>
        </message>
        <message>
            <source>Largest y of the base surface</source>
            <translation>Größtes y der Grundfläche</translation>
        </message>
        <message>
            <source>Largest z of the base surface</source>
            <translation>Größtes z der Grundfläche</translation>
        </message>
        <message>
            <source>Measured distance of the cut edges from the surface</source>
            <translation>Gemessener Abstand der Schnittkanten von der Fläche</translation>
        </message>
        <message>
            <source>Number of poles of all faces</source>
            <translation>Zahl der Kontrollpunkte aller Flächen</translation>
        </message>
        <message>
            <source>Open surfaces, or a solid with closed ends</source>
            <translation>Offene Flächen, oder ein Volumenkörper mit geschlossenen Enden</translation>
        </message>
        <message>
            <source>Positions of the radii on the spine, arc lengths in mm</source>
            <translation>Positionen der Radien auf der Leitkurve, Bogenlängen in mm</translation>
        </message>
        <message>
            <source>Positions of the rows of the table on the spine, arc lengths in mm</source>
            <translation>Positionen der Tabellenzeilen auf der Leitkurve, Bogenlängen in mm</translation>
        </message>
        <message>
            <source>Positions of the squared radii on the spine, arc lengths in mm</source>
            <translation>Positionen der quadrierten Radien auf der Leitkurve, Bogenlängen in mm</translation>
        </message>
        <message>
            <source>Radii at the vertices or positions, or Bezier coefficients, in mm</source>
            <translation>Radien an den Knoten oder Positionen, oder Bézier-Koeffizienten, in mm</translation>
        </message>
        <message>
            <source>Radii of curvature at the vertex at the positions, in mm</source>
            <translation>Krümmungsradien am Scheitel an den Positionen, in mm</translation>
        </message>
        <message>
            <source>Radii of the spheres in mm: half the thickness there</source>
            <translation>Radien der Kugeln in mm: dort die halbe Dicke</translation>
        </message>
        <message>
            <source>Radii of the spheres in mm: half the thickness, as control values</source>
            <translation>Radien der Kugeln in mm: die halbe Dicke, als Kontrollwerte</translation>
        </message>
        <message>
            <source>Radius at the end</source>
            <translation>Radius am Ende</translation>
        </message>
        <message>
            <source>Radius by the position s and the length L of the spine, such as 2 mm + 0.5 mm * sin(2*pi*s)</source>
            <translation>Radius nach der Position s und der Länge L der Leitkurve, zum Beispiel 2 mm + 0.5 mm * sin(2*pi*s)</translation>
        </message>
        <message>
            <source>Radius of curvature at the vertex by the position s and the length L of the spine, such as 20 mm + 5 mm * s</source>
            <translation>Krümmungsradius am Scheitel nach der Position s und der Länge L der Leitkurve, etwa 20 mm + 5 mm * s</translation>
        </message>
        <message>
            <source>Radius of curvature at the vertex, at the end</source>
            <translation>Krümmungsradius am Scheitel, am Ende</translation>
        </message>
        <message>
            <source>Radius of curvature at the vertex, everywhere or at the start</source>
            <translation>Krümmungsradius am Scheitel, überall oder am Anfang</translation>
        </message>
        <message>
            <source>Radius of the bore, the same everywhere</source>
            <translation>Radius der Bohrung, überall derselbe</translation>
        </message>
        <message>
            <source>Radius, or radius at the start</source>
            <translation>Radius, oder Radius am Anfang</translation>
        </message>
        <message>
            <source>Signed distance from the base surface</source>
            <translation>Abstand von der Grundfläche, mit Vorzeichen</translation>
        </message>
        <message>
            <source>Signed distance of the other one of two offsets</source>
            <translation>Abstand der anderen von zwei Versatzflächen, mit Vorzeichen</translation>
        </message>
        <message>
            <source>Smallest distance without a singular point</source>
            <translation>Kleinster Abstand ohne singulären Punkt</translation>
        </message>
        <message>
            <source>Smallest x of the base surface</source>
            <translation>Kleinstes x der Grundfläche</translation>
        </message>
        <message>
            <source>Smallest y of the base surface</source>
            <translation>Kleinstes y der Grundfläche</translation>
        </message>
        <message>
            <source>Smallest z of the base surface</source>
            <translation>Kleinstes z der Grundfläche</translation>
        </message>
        <message>
            <source>Smooth faces with even parameter lines, or the lowest degree</source>
            <translation>Glatte Flächen mit gleichmäßigen Parameterlinien, oder der kleinste Grad</translation>
        </message>
        <message>
            <source>Squared radii at the positions, or Bezier coefficients, in mm^2</source>
            <translation>Quadrierte Radien an den Positionen, oder Bézier-Koeffizienten, in mm^2</translation>
        </message>
        <message>
            <source>Squared radius at the end</source>
            <translation>Quadrierter Radius am Ende</translation>
        </message>
        <message>
            <source>Squared radius by the position s and the length L of the spine, such as 4 mm^2 + 5 mm^2 * sin(pi*s)</source>
            <translation>Quadrierter Radius nach der Position s und der Länge L der Leitkurve, zum Beispiel 4 mm^2 + 5 mm^2 * sin(pi*s)</translation>
        </message>
        <message>
            <source>Squared radius, or that at the start</source>
            <translation>Quadrierter Radius, oder der am Anfang</translation>
        </message>
        <message>
            <source>The direction that parallel sections are perpendicular to</source>
            <translation>Die Richtung, zu der parallele Schnitte senkrecht sind</translation>
        </message>
        <message>
            <source>The direction upwards: the height of a section runs along it, as far as its plane allows</source>
            <translation>Die Richtung nach oben: entlang dieser läuft die Höhe eines Schnitts, soweit seine Ebene es erlaubt</translation>
        </message>
        <message>
            <source>The kind of quadric, in standard position</source>
            <translation>Die Art der Quadrik, in Normallage</translation>
        </message>
        <message>
            <source>The light source, or a point of the plane where parallel light starts</source>
            <translation>Die Lichtquelle oder ein Punkt der Ebene, in der paralleles Licht beginnt</translation>
        </message>
        <message>
            <source>The mirror: a face, taken as its whole rectangle of parameters</source>
            <translation>Der Spiegel: eine Fläche, genommen mit ihrem ganzen Parameterrechteck</translation>
        </message>
        <message>
            <source>The quadric on which the face lies</source>
            <translation>Die Quadrik, auf der die Fläche liegt</translation>
        </message>
        <message>
            <source>The same bound as a number, in millimetres</source>
            <translation>Dieselbe Schranke als Zahl, in Millimetern</translation>
        </message>
        <message>
            <source>The surfaces that are made</source>
            <translation>Die Flächen, die erzeugt werden</translation>
        </message>
        <message>
            <source>Thickness of the wall, measured inwards</source>
            <translation>Dicke der Wand, nach innen gemessen</translation>
        </message>
        <message>
            <source>Three or six vertices in place of the centres: the corners first, then those between them</source>
            <translation>Drei oder sechs Knoten anstelle der Mittelpunkte: zuerst die Ecken, dann die dazwischen</translation>
        </message>
        <message>
            <source>Three points of every triangle, counterclockwise seen from above, counted from 0</source>
            <translation>Drei Punkte jedes Dreiecks, von oben gesehen gegen den Uhrzeigersinn, von 0 an gezählt</translation>
        </message>
        <message>
            <source>Valid, a warning or an error</source>
            <translation>Gültig, eine Warnung oder ein Fehler</translation>
        </message>
        <message>
            <source>Version of this list of properties</source>
            <translation>Version dieser Liste von Eigenschaften</translation>
        </message>
        <message>
            <source>Volume of a solid, by integration</source>
            <translation>Volumen eines Volumenkörpers, durch Integration</translation>
        </message>
        <message>
            <source>What else was done to the input</source>
            <translation>Was sonst mit der Eingabe geschah</translation>
        </message>
        <message>
            <source>What ends the base surface</source>
            <translation>Was die Grundfläche begrenzt</translation>
        </message>
        <message>
            <source>What positions on the spine count</source>
            <translation>Was Positionen auf der Leitkurve zählen</translation>
        </message>
        <message>
            <source>Where the sector begins, from x</source>
            <translation>Wo der Sektor beginnt, von x aus</translation>
        </message>
        <message>
            <source>Where the sector ends, from x</source>
            <translation>Wo der Sektor endet, von x aus</translation>
        </message>
        <message>
            <source>Whether only rounding to doubles deviates</source>
            <translation>Ob nur die Rundung auf Gleitkommazahlen abweicht</translation>
        </message>
        <message>
            <source>Whether sections are perpendicular to the spine, parallel to one another, or upright: through the direction upwards, perpendicular to the spine as it is seen along that</source>
            <translation>Ob Schnitte senkrecht zur Leitkurve, parallel zueinander oder aufrecht sind: durch die Richtung nach oben, senkrecht zur Leitkurve, wie sie entlang dieser gesehen wird</translation>
        </message>
        <message>
            <source>Whether the light is parallel or comes from a point</source>
            <translation>Ob das Licht parallel ist oder von einem Punkt kommt</translation>
        </message>
        <message>
            <source>Whether the pipe is hollow, and how its wall is given</source>
            <translation>Ob das Rohr hohl ist, und wie seine Wand angegeben wird</translation>
        </message>
        <message>
            <source>Whether the radius itself is rational, so that offsets are exact</source>
            <translation>Ob der Radius selbst rational ist, sodass Versatzflächen exakt sind</translation>
        </message>
        <message>
            <source>Whether the second curve is run through from its end</source>
            <translation>Ob die zweite Kurve von ihrem Ende her durchlaufen wird</translation>
        </message>
        <message>
            <source>Which of the two skins are made</source>
            <translation>Welche der beiden Hautflächen erzeugt werden</translation>
        </message>
    </context>
    <context>
        <name>CanalSurface</name>
        <message>
            <source>2 mm + 0.5 mm * sin(2*pi*s)</source>
            <translation>2 mm + 0.5 mm * sin(2*pi*s)</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation>Fügt unter der aktuellen Zeile eine Zeile ein</translation>
        </message>
        <message>
            <source>Canal surface</source>
            <translation>Kanalfläche</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Ende</translation>
        </message>
        <message>
            <source>Fit within</source>
            <translation>Angenähert auf</translation>
        </message>
        <message>
            <source>Hollow</source>
            <translation>Hohl</translation>
        </message>
        <message>
            <source>Inner radius</source>
            <translation>Innenradius</translation>
        </message>
        <message>
            <source>Paste</source>
            <translation>Einfügen</translation>
        </message>
        <message>
            <source>Position by</source>
            <translation>Position nach</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Profil</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Radius</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Removes the current row</source>
            <translation>Entfernt die aktuelle Zeile</translation>
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation>Ersetzt die Zeilen durch die aus einer Tabellenkalkulation kopierten (Strg+V fügt bei der aktuellen Zeile ein)</translation>
        </message>
        <message>
            <source>Spine</source>
            <translation>Leitkurve</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the profile</source>
            <translation>Nimmt die ausgewählten Kanten, den Kantenzug oder die Skizze als Profil</translation>
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation>Nimmt die ausgewählten Kanten, den Kantenzug oder die Skizze als Leitkurve</translation>
        </message>
        <message>
            <source>The curve through the centres of the spheres</source>
            <translation>Die Kurve durch die Mittelpunkte der Kugeln</translation>
        </message>
        <message>
            <source>The edges that the pipe runs through</source>
            <translation>Die Kanten, durch die das Rohr verläuft</translation>
        </message>
        <message>
            <source>Thickness</source>
            <translation>Dicke</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
    </context>
    <context>
        <name>Certificate</name>
        <message>
            <source>Also tries FreeCAD's offset of the same base surface and measures it, which may take seconds</source>
            <translation>Versucht auch FreeCADs Versatz derselben Grundfläche und misst ihn; das kann Sekunden dauern</translation>
        </message>
        <message>
            <source>Certificate</source>
            <translation>Zertifikat</translation>
        </message>
        <message>
            <source>Compare with FreeCAD's offset</source>
            <translation>Mit FreeCADs Versatz vergleichen</translation>
        </message>
        <message>
            <source>Copies the certificate as Markdown text</source>
            <translation>Kopiert das Zertifikat als Markdown-Text</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <source>Saves the certificate as Markdown or JSON</source>
            <translation>Speichert das Zertifikat als Markdown oder JSON</translation>
        </message>
        <message>
            <source>Save…</source>
            <translation>Speichern…</translation>
        </message>
    </context>
    <context>
        <name>MidSurfaceSkins</name>
        <message>
            <source>Mid-surface</source>
            <translation>Mittelfläche</translation>
        </message>
        <message>
            <source>Net</source>
            <translation>Netz</translation>
        </message>
        <message>
            <source>Skins</source>
            <translation>Hautflächen</translation>
        </message>
        <message>
            <source>Takes three corners, or three corners and the three points between them</source>
            <translation>Nimmt drei Ecken, oder drei Ecken und die drei Punkte dazwischen</translation>
        </message>
        <message>
            <source>The centres of the spheres: the control points of the mid-surface</source>
            <translation>Die Mittelpunkte der Kugeln: die Kontrollpunkte der Mittelfläche</translation>
        </message>
        <message>
            <source>The spheres: centres, and radii, which are half the thickness</source>
            <translation>Die Kugeln: Mittelpunkte, und Radien, welche die halbe Dicke sind</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
    </context>
    <context>
        <name>MirrorWavefront</name>
        <message>
            <source>Direction</source>
            <translation>Richtung</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Licht</translation>
        </message>
        <message>
            <source>Mirror</source>
            <translation>Spiegel</translation>
        </message>
        <message>
            <source>Origin</source>
            <translation>Ursprung</translation>
        </message>
        <message>
            <source>Takes a face as the mirror, a straight edge as the direction, or a vertex as the origin</source>
            <translation>Nimmt eine Fläche als Spiegel, eine gerade Kante als Richtung oder einen Knoten als Ursprung</translation>
        </message>
        <message>
            <source>The direction in which parallel light runs</source>
            <translation>Die Richtung, in der paralleles Licht läuft</translation>
        </message>
        <message>
            <source>The face that reflects</source>
            <translation>Die spiegelnde Fläche</translation>
        </message>
        <message>
            <source>The light source, or a point of the plane where parallel light starts</source>
            <translation>Die Lichtquelle oder ein Punkt der Ebene, in der paralleles Licht beginnt</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
    </context>
    <context>
        <name>MovingConicSection</name>
        <message>
            <source>-1 + 0.5 * sin(pi*s)</source>
            <translation>-1 + 0.5 * sin(pi*s)</translation>
        </message>
        <message>
            <source>10 mm</source>
            <translation>10 mm</translation>
        </message>
        <message>
            <source>10 mm * exp(s)</source>
            <translation>10 mm * exp(s)</translation>
        </message>
        <message>
            <source>20 mm + 5 mm * cos(pi*s)</source>
            <translation>20 mm + 5 mm * cos(pi*s)</translation>
        </message>
        <message>
            <source>20 mm + 5 mm * s</source>
            <translation>20 mm + 5 mm * s</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation>Fügt unter der aktuellen Zeile eine Zeile ein</translation>
        </message>
        <message>
            <source>Constant</source>
            <translation>Konstante</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Tiefe</translation>
        </message>
        <message>
            <source>Fit within</source>
            <translation>Angenähert auf</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <source>Moving conic section</source>
            <translation>Bewegter Kegelschnitt</translation>
        </message>
        <message>
            <source>Normal</source>
            <translation>Normale</translation>
        </message>
        <message>
            <source>Paste</source>
            <translation>Einfügen</translation>
        </message>
        <message>
            <source>Planes</source>
            <translation>Ebenen</translation>
        </message>
        <message>
            <source>Position by</source>
            <translation>Position nach</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Radius</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Removes the current row</source>
            <translation>Entfernt die aktuelle Zeile</translation>
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation>Ersetzt die Zeilen durch die aus einer Tabellenkalkulation kopierten (Strg+V fügt bei der aktuellen Zeile ein)</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Schnitt</translation>
        </message>
        <message>
            <source>Spine</source>
            <translation>Leitkurve</translation>
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation>Nimmt die ausgewählten Kanten, den Kantenzug oder die Skizze als Leitkurve</translation>
        </message>
        <message>
            <source>The curve through the centres of the sections</source>
            <translation>Die Kurve durch die Mitten der Schnitte</translation>
        </message>
        <message>
            <source>To the side</source>
            <translation>Zur Seite</translation>
        </message>
        <message>
            <source>Up</source>
            <translation>Oben</translation>
        </message>
        <message>
            <source>Upwards</source>
            <translation>Nach oben</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
        <message>
            <source>at end</source>
            <translation>am Ende</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
    </context>
    <context>
        <name>Offset</name>
        <message>
            <source>Caps</source>
            <translation>Enden</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linien</translation>
        </message>
        <message>
            <source>Offset</source>
            <translation>Versatz</translation>
        </message>
        <message>
            <source>Output</source>
            <translation>Ergebnis</translation>
        </message>
        <message>
            <source>Second distance</source>
            <translation>Zweiter Abstand</translation>
        </message>
        <message>
            <source>Sides</source>
            <translation>Seiten</translation>
        </message>
        <message>
            <source>These surfaces have no exact offsets: their unit normals are not rational.</source>
            <translation>Diese Flächen haben keine exakten Versatzflächen: ihre Einheitsnormalen sind nicht rational.</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces</name>
        <message>
            <source>&amp;Back</source>
            <translation>&amp;Zurück</translation>
        </message>
        <message>
            <source>&amp;Close</source>
            <translation>&amp;Schließen</translation>
        </message>
        <message>
            <source>A dish of elliptic outline: an elliptic paraboloid and its shell of even thickness.</source>
            <translation>Eine Schale mit elliptischem Umriss: ein elliptisches Paraboloid mit gleichmäßig dicker Wand.</translation>
        </message>
        <message>
            <source>A dish that light falls on obliquely, and the wavefronts on their way to the focus: exact offsets of each other.</source>
            <translation>Eine Schale, auf die Licht schräg fällt, und die Wellenfronten auf dem Weg zum Brennpunkt: exakte Versätze voneinander.</translation>
        </message>
        <message>
            <source>A duct from a flat opening to a round pipe, around a bend: true ellipses along a spine.</source>
            <translation>Ein Luftkanal von einer flachen Öffnung zu einem runden Rohr, um eine Biegung: wahre Ellipsen entlang einer Leitkurve.</translation>
        </message>
        <message>
            <source>A hollow hose between two fittings: a table of radii by arc length, and a bore of one radius.</source>
            <translation>Ein Schlauch zwischen zwei Anschlüssen: eine Tabelle von Radien über der Bogenlänge, innen überall derselbe Radius.</translation>
        </message>
        <message>
            <source>A hyperbolic paraboloid of concrete, equally thick everywhere.</source>
            <translation>Ein hyperbolisches Paraboloid aus Beton, überall gleich dick.</translation>
        </message>
        <message>
            <source>A reflector along a lamp: hyperbolas that spread its light, then a parabola, then ellipses that gather it.</source>
            <translation>Ein Reflektor entlang einer Lampe: Hyperbeln, die ihr Licht streuen, dann eine Parabel, dann Ellipsen, die es sammeln.</translation>
        </message>
        <message>
            <source>A rotor of blades between two offsets of the ruled surface from root to tip.</source>
            <translation>Ein Rotor aus Schaufeln zwischen zwei Versatzflächen der Regelfläche von der Wurzel zur Spitze.</translation>
        </message>
        <message>
            <source>A runner that flares towards the air: the wall between two offsets of a pipe with a radius at each point of its spine.</source>
            <translation>Ein Saugrohr, das sich zur Luft hin öffnet: die Wand zwischen zwei Versatzflächen eines Rohrs mit einem Radius an jedem Punkt der Leitkurve.</translation>
        </message>
        <message>
            <source>A tank with three different half-axes: the wall between two offsets of an ellipsoid, and its lining.</source>
            <translation>Ein Behälter mit drei verschiedenen Halbachsen: die Wand zwischen zwei Versatzflächen eines Ellipsoids, und seine Auskleidung.</translation>
        </message>
        <message>
            <source>Arc length</source>
            <translation>Bogenlänge</translation>
        </message>
        <message>
            <source>Base and offset</source>
            <translation>Grundfläche und Versatz</translation>
        </message>
        <message>
            <source>Bezier coefficients</source>
            <translation>Bézier-Koeffizienten</translation>
        </message>
        <message>
            <source>Both sides</source>
            <translation>Beide Seiten</translation>
        </message>
        <message>
            <source>Both skins</source>
            <translation>Beide Hautflächen</translation>
        </message>
        <message>
            <source>Both skins of an eight-sided dome whose wall grows from the oculus to the foot: a sphere and a tangent plane at each point of a triangulation.</source>
            <translation>Beide Hautflächen einer achteckigen Kuppel, deren Wand vom Auge zum Fuß hin zunimmt: eine Kugel und eine Tangentialebene in jedem Punkt einer Triangulierung.</translation>
        </message>
        <message>
            <source>Box</source>
            <translation>Quader</translation>
        </message>
        <message>
            <source>Canal surface</source>
            <translation>Kanalfläche</translation>
        </message>
        <message>
            <source>Canal surface from r²</source>
            <translation>Kanalfläche aus r²</translation>
        </message>
        <message>
            <source>Certificate</source>
            <translation>Zertifikat</translation>
        </message>
        <message>
            <source>Coefficient {}</source>
            <translation>Koeffizient {}</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Wird berechnet…</translation>
        </message>
        <message>
            <source>Cone</source>
            <translation>Kegel</translation>
        </message>
        <message>
            <source>Constant</source>
            <translation>Konstant</translation>
        </message>
        <message>
            <source>Cooling tower</source>
            <translation>Kühlturm</translation>
        </message>
        <message>
            <source>Cylinder</source>
            <translation>Zylinder</translation>
        </message>
        <message>
            <source>Degree {}, spans {}, vertices {}, closed, {}</source>
            <translation>Grad {}, Segmente {}, Knoten {}, geschlossen, {}</translation>
        </message>
        <message>
            <source>Degree {}, spans {}, vertices {}, {}</source>
            <translation>Grad {}, Segmente {}, Knoten {}, {}</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Tiefe</translation>
        </message>
        <message>
            <source>Distances without singular points; beyond the surface folds.</source>
            <translation>Abstände ohne singuläre Punkte; jenseits davon faltet sich die Fläche.</translation>
        </message>
        <message>
            <source>Dome</source>
            <translation>Kuppel</translation>
        </message>
        <message>
            <source>Duct</source>
            <translation>Luftkanal</translation>
        </message>
        <message>
            <source>Edit {}</source>
            <translation>{} bearbeiten</translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation>Ellipse</translation>
        </message>
        <message>
            <source>Ellipsoid</source>
            <translation>Ellipsoid</translation>
        </message>
        <message>
            <source>Ellipsoidal tank</source>
            <translation>Ellipsoidbehälter</translation>
        </message>
        <message>
            <source>Elliptic paraboloid</source>
            <translation>Elliptisches Paraboloid</translation>
        </message>
        <message>
            <source>Even</source>
            <translation>Gleichmäßig</translation>
        </message>
        <message>
            <source>Expression</source>
            <translation>Ausdruck</translation>
        </message>
        <message>
            <source>Flat</source>
            <translation>Eben</translation>
        </message>
        <message>
            <source>From a point</source>
            <translation>Von einem Punkt</translation>
        </message>
        <message>
            <source>From the vertex</source>
            <translation>Vom Scheitel aus</translation>
        </message>
        <message>
            <source>Gauss curvature, 1/mm²</source>
            <translation>Gaußsche Krümmung, 1/mm²</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Höhen</translation>
        </message>
        <message>
            <source>Hose</source>
            <translation>Schlauch</translation>
        </message>
        <message>
            <source>Hyperbolic paraboloid</source>
            <translation>Hyperbolisches Paraboloid</translation>
        </message>
        <message>
            <source>Inner radius</source>
            <translation>Innenradius</translation>
        </message>
        <message>
            <source>Inner skin</source>
            <translation>Innere Hautfläche</translation>
        </message>
        <message>
            <source>Intake horn</source>
            <translation>Ansaugtrichter</translation>
        </message>
        <message>
            <source>K</source>
            <translation>K</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>Linear</translation>
        </message>
        <message>
            <source>Lowest degree</source>
            <translation>Kleinster Grad</translation>
        </message>
        <message>
            <source>Markdown (*.md);;JSON (*.json)</source>
            <translation>Markdown (*.md);;JSON (*.json)</translation>
        </message>
        <message>
            <source>Mid-surface skins</source>
            <translation>Hautflächen einer Mittelfläche</translation>
        </message>
        <message>
            <source>Mirror wavefront</source>
            <translation>Wellenfront eines Spiegels</translation>
        </message>
        <message>
            <source>Mirror with its wavefronts</source>
            <translation>Spiegel mit Wellenfronten</translation>
        </message>
        <message>
            <source>More: menu PN Surfaces, Documentation, page {}.</source>
            <translation>Mehr: Menü PN Surfaces, Dokumentation, Seite {}.</translation>
        </message>
        <message>
            <source>Moving conic section</source>
            <translation>Bewegter Kegelschnitt</translation>
        </message>
        <message>
            <source>No</source>
            <translation>Nein</translation>
        </message>
        <message>
            <source>No distance is proved to be free of singular points.</source>
            <translation>Für keinen Abstand ist bewiesen, dass es keine singulären Punkte gibt.</translation>
        </message>
        <message>
            <source>No profile</source>
            <translation>Kein Profil</translation>
        </message>
        <message>
            <source>No spine</source>
            <translation>Keine Leitkurve</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <source>Of a face</source>
            <translation>Einer Fläche</translation>
        </message>
        <message>
            <source>Offset</source>
            <translation>Versatz</translation>
        </message>
        <message>
            <source>One-sheet hyperboloid</source>
            <translation>Einschaliges Hyperboloid</translation>
        </message>
        <message>
            <source>Outer skin</source>
            <translation>Äußere Hautfläche</translation>
        </message>
        <message>
            <source>Output</source>
            <translation>Ausgabe</translation>
        </message>
        <message>
            <source>PN Surfaces: documentation</source>
            <translation>PN Surfaces: Dokumentation</translation>
        </message>
        <message>
            <source>PN Surfaces: examples</source>
            <translation>PN Surfaces: Beispiele</translation>
        </message>
        <message>
            <source>Parabolic cylinder</source>
            <translation>Parabolischer Zylinder</translation>
        </message>
        <message>
            <source>Parallel</source>
            <translation>Parallel</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Parameter</translation>
        </message>
        <message>
            <source>Perpendicular</source>
            <translation>Senkrecht</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Position</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Profil</translation>
        </message>
        <message>
            <source>Quadric offset</source>
            <translation>Versatz einer Quadrik</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Radius</translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation>Rechteck</translation>
        </message>
        <message>
            <source>Reflector</source>
            <translation>Reflektor</translation>
        </message>
        <message>
            <source>Relative length</source>
            <translation>Relative Länge</translation>
        </message>
        <message>
            <source>Rounded bracket</source>
            <translation>Gerundeter Halter</translation>
        </message>
        <message>
            <source>Ruled surface offset</source>
            <translation>Versatz einer Regelfläche</translation>
        </message>
        <message>
            <source>STEP export</source>
            <translation>STEP-Export</translation>
        </message>
        <message>
            <source>STEP export cancelled.</source>
            <translation>STEP-Export abgebrochen.</translation>
        </message>
        <message>
            <source>STEP files (*.step *.stp)</source>
            <translation>STEP-Dateien (*.step *.stp)</translation>
        </message>
        <message>
            <source>Saddle roof</source>
            <translation>Hyparschale</translation>
        </message>
        <message>
            <source>Sector</source>
            <translation>Sektor</translation>
        </message>
        <message>
            <source>Select one face, one straight edge or one vertex.</source>
            <translation>Eine Fläche, eine gerade Kante oder einen Knoten auswählen.</translation>
        </message>
        <message>
            <source>Select one face.</source>
            <translation>Eine Fläche auswählen.</translation>
        </message>
        <message>
            <source>Select the mirror first: one face.</source>
            <translation>Zuerst den Spiegel auswählen: eine Fläche.</translation>
        </message>
        <message>
            <source>Select the spine first: edges of one object, a wire or a sketch.</source>
            <translation>Zuerst die Leitkurve auswählen: Kanten eines Objekts, einen Kantenzug oder eine Skizze.</translation>
        </message>
        <message>
            <source>Select three or six vertices of one object.</source>
            <translation>Drei oder sechs Knoten eines Objekts auswählen.</translation>
        </message>
        <message>
            <source>Select two edges, wires or sketches first, or one ruled face.</source>
            <translation>Zuerst zwei Kanten, Kantenzüge oder Skizzen auswählen, oder eine Regelfläche.</translation>
        </message>
        <message>
            <source>Select two edges, wires or sketches, or one ruled face.</source>
            <translation>Zwei Kanten, Kantenzüge oder Skizzen auswählen, oder eine Regelfläche.</translation>
        </message>
        <message>
            <source>Solid</source>
            <translation>Volumenkörper</translation>
        </message>
        <message>
            <source>Spherical</source>
            <translation>Kugelförmig</translation>
        </message>
        <message>
            <source>Spray</source>
            <translation>Sprühstrahl</translation>
        </message>
        <message>
            <source>Squared radius</source>
            <translation>Radius²</translation>
        </message>
        <message>
            <source>Stopped. The surface is that of earlier values.</source>
            <translation>Angehalten. Die Fläche gehört zu früheren Werten.</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <source>Table</source>
            <translation>Tabelle</translation>
        </message>
        <message>
            <source>The clipboard has no table of {} columns of numbers.</source>
            <translation>In der Zwischenablage ist keine Tabelle mit {} Spalten von Zahlen.</translation>
        </message>
        <message>
            <source>The union of all balls of six spheres, rounded everywhere, with a hole at each corner.</source>
            <translation>Die Vereinigung aller Kugeln aus sechs Kugeln, überall gerundet, mit einem Loch an jeder Ecke.</translation>
        </message>
        <message>
            <source>The wall of a one-sheet hyperboloid, equally thick from foot to rim.</source>
            <translation>Die Wand eines einschaligen Hyperboloids, vom Fuß bis zum Rand gleich dick.</translation>
        </message>
        <message>
            <source>To the side</source>
            <translation>Zur Seite</translation>
        </message>
        <message>
            <source>Trough</source>
            <translation>Rinne</translation>
        </message>
        <message>
            <source>Twisted blade</source>
            <translation>Verwundene Schaufel</translation>
        </message>
        <message>
            <source>Two offsets</source>
            <translation>Zwei Versätze</translation>
        </message>
        <message>
            <source>Two-sheet hyperboloid</source>
            <translation>Zweischaliges Hyperboloid</translation>
        </message>
        <message>
            <source>Typed below</source>
            <translation>Unten eingegeben</translation>
        </message>
        <message>
            <source>Upright</source>
            <translation>Aufrecht</translation>
        </message>
        <message>
            <source>Upwards</source>
            <translation>Nach oben</translation>
        </message>
        <message>
            <source>Valid</source>
            <translation>Gültig</translation>
        </message>
        <message>
            <source>Values at vertices</source>
            <translation>Werte an den Knoten</translation>
        </message>
        <message>
            <source>Vertex</source>
            <translation>Knoten</translation>
        </message>
        <message>
            <source>Vertex {}</source>
            <translation>Knoten {}</translation>
        </message>
        <message>
            <source>Wall thickness</source>
            <translation>Wanddicke</translation>
        </message>
        <message>
            <source>What evaporating drops sweep on their flight: the squared radius is linear along a parabola.</source>
            <translation>Was verdunstende Tropfen im Flug überstreichen: Der quadrierte Radius ist linear entlang einer Parabel.</translation>
        </message>
        <message>
            <source>Whole</source>
            <translation>Ganz</translation>
        </message>
        <message>
            <source>Yes</source>
            <translation>Ja</translation>
        </message>
        <message>
            <source>degree {} x {}</source>
            <translation>Grad {} x {}</translation>
        </message>
        <message>
            <source>degree {}, spans {}</source>
            <translation>Grad {}, Segmente {}</translation>
        </message>
        <message>
            <source>degree {}, spans {}, closed</source>
            <translation>Grad {}, Segmente {}, geschlossen</translation>
        </message>
        <message>
            <source>empty</source>
            <translation>leer</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keines</translation>
        </message>
        <message>
            <source>smallest radius {} mm</source>
            <translation>kleinster Radius {} mm</translation>
        </message>
        <message>
            <source>{} away from the face</source>
            <translation>{} von der Fläche entfernt</translation>
        </message>
        <message>
            <source>{} to {} mm</source>
            <translation>{} bis {} mm</translation>
        </message>
    </context>
    <context>
        <name>PNSurfacesPreferences</name>
        <message>
            <source>AP203</source>
            <translation>AP203</translation>
        </message>
        <message>
            <source>AP214</source>
            <translation>AP214</translation>
        </message>
        <message>
            <source>AP242</source>
            <translation>AP242</translation>
        </message>
        <message>
            <source>Curves of the edges in the parameters of their faces: without them the file is smaller, and other programs project the edges anew</source>
            <translation>Kurven der Kanten in den Parametern ihrer Flächen: ohne sie ist die Datei kleiner, und andere Programme projizieren die Kanten neu</translation>
        </message>
        <message>
            <source>Even</source>
            <translation>Gleichmäßig</translation>
        </message>
        <message>
            <source>Even lines give one smooth face, the lowest degree gives a face per arc</source>
            <translation>Gleichmäßige Linien ergeben eine glatte Fläche, der kleinste Grad ergibt eine Fläche je Bogen</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Allgemein</translation>
        </message>
        <message>
            <source>Lowest degree</source>
            <translation>Kleinster Grad</translation>
        </message>
        <message>
            <source>New surfaces</source>
            <translation>Neue Flächen</translation>
        </message>
        <message>
            <source>Offset distance</source>
            <translation>Versatzabstand</translation>
        </message>
        <message>
            <source>Parameter lines</source>
            <translation>Parameterlinien</translation>
        </message>
        <message>
            <source>STEP export</source>
            <translation>STEP-Export</translation>
        </message>
        <message>
            <source>Schema</source>
            <translation>Schema</translation>
        </message>
        <message>
            <source>The STEP application protocol of exported files</source>
            <translation>Das STEP-Anwendungsprotokoll exportierter Dateien</translation>
        </message>
        <message>
            <source>The offset distance that a new surface starts with</source>
            <translation>Der Versatzabstand, mit dem eine neue Fläche beginnt</translation>
        </message>
        <message>
            <source>Write parametric curves</source>
            <translation>Parametrische Kurven schreiben</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_CanalSurface</name>
        <message>
            <source>Canal Surface…</source>
            <translation>Kanalfläche…</translation>
        </message>
        <message>
            <source>Creates the exact pipe of varying radius around a spine, and its exact offsets</source>
            <translation>Erzeugt das exakte Rohr mit veränderlichem Radius um eine Leitkurve, und seine exakten Versatzflächen</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_Certificate</name>
        <message>
            <source>Certificate…</source>
            <translation>Zertifikat…</translation>
        </message>
        <message>
            <source>Shows what is proved and measured of the selected surfaces, to read, copy and save</source>
            <translation>Zeigt, was von den ausgewählten Flächen bewiesen und gemessen ist, zum Lesen, Kopieren und Speichern</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_Combs</name>
        <message>
            <source>Curvature Combs</source>
            <translation>Krümmungskämme</translation>
        </message>
        <message>
            <source>Shows combs of curvature along parameter lines of the selected surfaces, on and off</source>
            <translation>Zeigt Krümmungskämme entlang der Parameterlinien der ausgewählten Flächen, an und aus</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_ControlNet</name>
        <message>
            <source>Control Net</source>
            <translation>Kontrollnetz</translation>
        </message>
        <message>
            <source>Shows the poles of the selected surfaces, on and off</source>
            <translation>Zeigt die Kontrollpunkte der ausgewählten Flächen, an und aus</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_CurvatureMap</name>
        <message>
            <source>Colours the selected surfaces by their smallest radius of curvature, on and off</source>
            <translation>Färbt die ausgewählten Flächen nach ihrem kleinsten Krümmungsradius, an und aus</translation>
        </message>
        <message>
            <source>Curvature Map</source>
            <translation>Krümmungskarte</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_Documentation</name>
        <message>
            <source>Documentation</source>
            <translation>Dokumentation</translation>
        </message>
        <message>
            <source>Shows what the commands do, and the theorems they rest on</source>
            <translation>Zeigt, was die Befehle tun, und die Sätze, auf denen sie beruhen</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_Examples</name>
        <message>
            <source>Examples…</source>
            <translation>Beispiele…</translation>
        </message>
        <message>
            <source>Opens a ready document from the gallery of examples</source>
            <translation>Öffnet ein fertiges Dokument aus der Sammlung von Beispielen</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_ExportStep</name>
        <message>
            <source>STEP Export…</source>
            <translation>STEP-Export…</translation>
        </message>
        <message>
            <source>Writes the selected objects to a STEP file that keeps every digit</source>
            <translation>Schreibt die ausgewählten Objekte in eine STEP-Datei, die jede Stelle bewahrt</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_GaussMap</name>
        <message>
            <source>Colours the selected surfaces by their Gauss curvature, on and off</source>
            <translation>Färbt die ausgewählten Flächen nach ihrer Gaußschen Krümmung, an und aus</translation>
        </message>
        <message>
            <source>Gauss Curvature Map</source>
            <translation>Karte der Gaußschen Krümmung</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_MidSurfaceSkins</name>
        <message>
            <source>Creates both exact skins of a mid-surface whose thickness varies, from six spheres</source>
            <translation>Erzeugt beide exakten Hautflächen einer Mittelfläche mit veränderlicher Dicke, aus sechs Kugeln</translation>
        </message>
        <message>
            <source>Mid-Surface Skins…</source>
            <translation>Hautflächen einer Mittelfläche…</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_MirrorWavefront</name>
        <message>
            <source>Creates the exact wavefront of parallel light, or of light from a point, behind a mirror</source>
            <translation>Erzeugt die exakte Wellenfront von parallelem Licht oder von Licht aus einem Punkt hinter einem Spiegel</translation>
        </message>
        <message>
            <source>Mirror Wavefront…</source>
            <translation>Wellenfront eines Spiegels…</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_MovingConicSection</name>
        <message>
            <source>Creates the exact surface of ellipses, parabolas or hyperbolas along a spine, which change</source>
            <translation>Erzeugt die exakte Fläche von Ellipsen, Parabeln oder Hyperbeln entlang einer Leitkurve, die sich ändern</translation>
        </message>
        <message>
            <source>Moving Conic Section…</source>
            <translation>Bewegter Kegelschnitt…</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_ParameterLines</name>
        <message>
            <source>Parameter Lines</source>
            <translation>Parameterlinien</translation>
        </message>
        <message>
            <source>Shows the parameter lines of the selected surfaces, on and off</source>
            <translation>Zeigt die Parameterlinien der ausgewählten Flächen, an und aus</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_QuadricOffset</name>
        <message>
            <source>Creates the exact offset of an ellipsoid, hyperboloid, paraboloid, cone or cylinder</source>
            <translation>Erzeugt die exakte Versatzfläche eines Ellipsoids, Hyperboloids, Paraboloids, Kegels oder Zylinders</translation>
        </message>
        <message>
            <source>Quadric Offset…</source>
            <translation>Versatz einer Quadrik…</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_RuledOffset</name>
        <message>
            <source>Creates the exact offset of the surface of straight lines between two curves</source>
            <translation>Erzeugt die exakte Versatzfläche der Fläche aus Geraden zwischen zwei Kurven</translation>
        </message>
        <message>
            <source>Ruled Surface Offset…</source>
            <translation>Versatz einer Regelfläche…</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_SquaredRadiusCanal</name>
        <message>
            <source>Canal Surface from r²…</source>
            <translation>Kanalfläche aus r²…</translation>
        </message>
        <message>
            <source>Creates the exact envelope of spheres around a spine whose squared radius is given</source>
            <translation>Erzeugt die exakte Hüllfläche von Kugeln um eine Leitkurve, deren quadrierter Radius gegeben ist</translation>
        </message>
    </context>
    <context>
        <name>PNSurfaces_Zebra</name>
        <message>
            <source>Shows the stripes that the selected surfaces reflect, on and off</source>
            <translation>Zeigt die Streifen, die die ausgewählten Flächen spiegeln, an und aus</translation>
        </message>
        <message>
            <source>Zebra</source>
            <translation>Zebrastreifen</translation>
        </message>
    </context>
    <context>
        <name>QuadricOffset</name>
        <message>
            <source>Angle from</source>
            <translation>Winkel von</translation>
        </message>
        <message>
            <source>Angle to</source>
            <translation>Winkel bis</translation>
        </message>
        <message>
            <source>Face</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <source>Quadric</source>
            <translation>Quadrik</translation>
        </message>
        <message>
            <source>Region</source>
            <translation>Bereich</translation>
        </message>
        <message>
            <source>Takes the selected face</source>
            <translation>Nimmt die ausgewählte Fläche</translation>
        </message>
        <message>
            <source>The base surface, in standard position</source>
            <translation>Die Grundfläche, in Normallage</translation>
        </message>
        <message>
            <source>The face that lies on the quadric</source>
            <translation>Die Fläche, die auf der Quadrik liegt</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
        <message>
            <source>a</source>
            <translation>a</translation>
        </message>
        <message>
            <source>b</source>
            <translation>b</translation>
        </message>
        <message>
            <source>c</source>
            <translation>c</translation>
        </message>
        <message>
            <source>deg</source>
            <translation>deg</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
        <message>
            <source>x from</source>
            <translation>x von</translation>
        </message>
        <message>
            <source>x to</source>
            <translation>x bis</translation>
        </message>
        <message>
            <source>y from</source>
            <translation>y von</translation>
        </message>
        <message>
            <source>y to</source>
            <translation>y bis</translation>
        </message>
        <message>
            <source>z from</source>
            <translation>z von</translation>
        </message>
        <message>
            <source>z to</source>
            <translation>z bis</translation>
        </message>
    </context>
    <context>
        <name>Result</name>
        <message>
            <source>Area</source>
            <translation>Flächeninhalt</translation>
        </message>
        <message>
            <source>Cut edges</source>
            <translation>Schnittkanten</translation>
        </message>
        <message>
            <source>Degree</source>
            <translation>Grad</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <source>Exact</source>
            <translation>Exakt</translation>
        </message>
        <message>
            <source>Poles</source>
            <translation>Kontrollpunkte</translation>
        </message>
        <message>
            <source>Regular range</source>
            <translation>Regulärer Bereich</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Ergebnis</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Anhalten</translation>
        </message>
        <message>
            <source>Stops the computation and keeps the surface of earlier values</source>
            <translation>Hält die Berechnung an und behält die Fläche früherer Werte</translation>
        </message>
        <message>
            <source>Volume</source>
            <translation>Volumen</translation>
        </message>
    </context>
    <context>
        <name>RuledOffset</name>
        <message>
            <source>Curves</source>
            <translation>Kurven</translation>
        </message>
        <message>
            <source>Ruled surface</source>
            <translation>Regelfläche</translation>
        </message>
        <message>
            <source>Second curve reversed</source>
            <translation>Zweite Kurve umgekehrt</translation>
        </message>
        <message>
            <source>Takes the two selected edges, wires or sketches, or the selected ruled face</source>
            <translation>Nimmt die zwei ausgewählten Kanten, Kantenzüge oder Skizzen, oder die ausgewählte Regelfläche</translation>
        </message>
        <message>
            <source>The two curves between which straight lines run, or a ruled face</source>
            <translation>Die zwei Kurven, zwischen denen Geraden verlaufen, oder eine Regelfläche</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
    </context>
    <context>
        <name>SquaredRadiusCanal</name>
        <message>
            <source>4 mm^2 + 5 mm^2 * sin(pi*s)</source>
            <translation>4 mm^2 + 5 mm^2 * sin(pi*s)</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation>Fügt unter der aktuellen Zeile eine Zeile ein</translation>
        </message>
        <message>
            <source>Canal surface from r²</source>
            <translation>Kanalfläche aus r²</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Ende</translation>
        </message>
        <message>
            <source>Fit within</source>
            <translation>Angenähert auf</translation>
        </message>
        <message>
            <source>Offsets are exact where the radius itself is rational.</source>
            <translation>Versatzflächen sind exakt, wo der Radius selbst rational ist.</translation>
        </message>
        <message>
            <source>Paste</source>
            <translation>Einfügen</translation>
        </message>
        <message>
            <source>Position by</source>
            <translation>Position nach</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Removes the current row</source>
            <translation>Entfernt die aktuelle Zeile</translation>
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation>Ersetzt die Zeilen durch die aus einer Tabellenkalkulation kopierten (Strg+V fügt bei der aktuellen Zeile ein)</translation>
        </message>
        <message>
            <source>Spine</source>
            <translation>Leitkurve</translation>
        </message>
        <message>
            <source>Squared radius</source>
            <translation>Radius²</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation>Nimmt die ausgewählten Kanten, den Kantenzug oder die Skizze als Leitkurve</translation>
        </message>
        <message>
            <source>The curve through the centres of the spheres</source>
            <translation>Die Kurve durch die Mittelpunkte der Kugeln</translation>
        </message>
        <message>
            <source>Use selection</source>
            <translation>Auswahl übernehmen</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
        <message>
            <source>mm^2</source>
            <translation>mm^2</translation>
        </message>
    </context>
    <context>
        <name>TriangulatedSkins</name>
        <message>
            <source>Mid-surface</source>
            <translation>Mittelfläche</translation>
        </message>
        <message>
            <source>Skins</source>
            <translation>Hautflächen</translation>
        </message>
        <message>
            <source>The spheres: points of the mid-surface, and radii, which are half the thickness</source>
            <translation>Die Kugeln: Punkte der Mittelfläche, und Radien, die halbe Dicke</translation>
        </message>
    </context>
</TS>
