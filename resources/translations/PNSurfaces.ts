<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A face that lies on a quadric; the placement follows it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A ruled face, instead of the two curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Area of all faces, by integration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Bound on the distance to the true surface; proven, but for fits that are said to be measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Centres of the spheres A, B, C, AB, BC, CA: the control points of the mid-surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Centres of the spheres: points of the mid-surface, a graph over the plane z = 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Conic constant at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Conic constant by the position s, a plain number, such as -1 + 0.5 * sin(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Conic constant, everywhere or at the start: below -1 a hyperbola, -1 a parabola, above an ellipse, 0 a circle</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Conic constants at the positions</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Degree along and across the faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Direction of parallel light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges of the curve where the rulings end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges of the curve where the rulings start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges that the pipe runs through</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges through the centres of the spheres</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges through the centres or vertices of the sections</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ellipses around the spine, or conics that open upwards from their vertex on the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Estimated error of the area</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Estimated error of the volume</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axes to the side at the positions, in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axes upwards at the positions, in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis a, along x</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis b, along y</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis c, along z; of a paraboloid its height at x = a</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis to the side at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis to the side by the position s and the length L of the spine, such as 20 mm + 5 mm * cos(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis to the side, everywhere or at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis upwards at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis upwards by the position s and the length L of the spine, such as 10 mm * exp(s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Half-axis upwards, everywhere or at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far a fit may be from what has no exact form</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far fits are off, part of the deviation; proven or measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How fast height and radius change along x, then along y, four numbers for every point; none to have them estimated</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How high a section goes above its vertex by the position s and the length L of the spine, such as 10 mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How high a section goes above its vertex, at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How high a section goes above its vertex, everywhere or at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How high sections go above their vertex at the positions, in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the ends of a solid are closed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the measures of the sections run along the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the radius runs along the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the squared radius runs along the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest distance without a singular point</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest measured distance of the face from the quadric</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest x of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest y of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest z of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measured distance of the cut edges from the surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of poles of all faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Open surfaces, or a solid with closed ends</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Positions of the radii on the spine, arc lengths in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Positions of the rows of the table on the spine, arc lengths in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Positions of the squared radii on the spine, arc lengths in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radii at the vertices or positions, or Bezier coefficients, in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radii of curvature at the vertex at the positions, in mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radii of the spheres in mm: half the thickness there</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radii of the spheres in mm: half the thickness, as control values</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius by the position s and the length L of the spine, such as 2 mm + 0.5 mm * sin(2*pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius of curvature at the vertex by the position s and the length L of the spine, such as 20 mm + 5 mm * s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius of curvature at the vertex, at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius of curvature at the vertex, everywhere or at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius of the bore, the same everywhere</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius, or radius at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Signed distance from the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Signed distance of the other one of two offsets</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Smallest distance without a singular point</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Smallest x of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Smallest y of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Smallest z of the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Smooth faces with even parameter lines, or the lowest degree</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radii at the positions, or Bezier coefficients, in mm^2</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radius at the end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radius by the position s and the length L of the spine, such as 4 mm^2 + 5 mm^2 * sin(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radius, or that at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The direction that parallel sections are perpendicular to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The direction upwards: the height of a section runs along it, as far as its plane allows</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The kind of quadric, in standard position</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The light source, or a point of the plane where parallel light starts</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The mirror: a face, taken as its whole rectangle of parameters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The quadric on which the face lies</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The same bound as a number, in millimetres</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The surfaces that are made</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Thickness of the wall, measured inwards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Three or six vertices in place of the centres: the corners first, then those between them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Three points of every triangle, counterclockwise seen from above, counted from 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Valid, a warning or an error</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Version of this list of properties</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Volume of a solid, by integration</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What else was done to the input</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What ends the base surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What positions on the spine count</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Where the sector begins, from x</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Where the sector ends, from x</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether only rounding to doubles deviates</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether sections are perpendicular to the spine, parallel to one another, or upright: through the direction upwards, perpendicular to the spine as it is seen along that</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether the light is parallel or comes from a point</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether the pipe is hollow, and how its wall is given</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether the radius itself is rational, so that offsets are exact</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether the second curve is run through from its end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Which of the two skins are made</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>CanalSurface</name>
        <message>
            <source>2 mm + 0.5 mm * sin(2*pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Add</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Canal surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>End</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Fit within</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Hollow</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Inner radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Paste</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Position by</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Profile</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Remove</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Removes the current row</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the profile</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The curve through the centres of the spheres</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The edges that the pipe runs through</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Thickness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Certificate</name>
        <message>
            <source>Also tries FreeCAD's offset of the same base surface and measures it, which may take seconds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Certificate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Compare with FreeCAD's offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Copies the certificate as Markdown text</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Copy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Saves the certificate as Markdown or JSON</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Save…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>MidSurfaceSkins</name>
        <message>
            <source>Mid-surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Net</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Skins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes three corners, or three corners and the three points between them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The centres of the spheres: the control points of the mid-surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The spheres: centres, and radii, which are half the thickness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>MirrorWavefront</name>
        <message>
            <source>Direction</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mirror</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Origin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes a face as the mirror, a straight edge as the direction, or a vertex as the origin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The direction in which parallel light runs</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The face that reflects</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The light source, or a point of the plane where parallel light starts</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>MovingConicSection</name>
        <message>
            <source>-1 + 0.5 * sin(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>10 mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>10 mm * exp(s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>20 mm + 5 mm * cos(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>20 mm + 5 mm * s</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Add</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Constant</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Depth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Fit within</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Law</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Moving conic section</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Normal</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Paste</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Planes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Position by</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Remove</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Removes the current row</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Section</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The curve through the centres of the sections</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>To the side</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Up</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Upwards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>at end</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Offset</name>
        <message>
            <source>Caps</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Distance</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lines</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Output</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Second distance</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Sides</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>These surfaces have no exact offsets: their unit normals are not rational.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces</name>
        <message>
            <source>&amp;Back</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>&amp;Close</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A dish of elliptic outline: an elliptic paraboloid and its shell of even thickness.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A dish that light falls on obliquely, and the wavefronts on their way to the focus: exact offsets of each other.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A duct from a flat opening to a round pipe, around a bend: true ellipses along a spine.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A hollow hose between two fittings: a table of radii by arc length, and a bore of one radius.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A hyperbolic paraboloid of concrete, equally thick everywhere.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A reflector along a lamp: hyperbolas that spread its light, then a parabola, then ellipses that gather it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A rotor of blades between two offsets of the ruled surface from root to tip.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A runner that flares towards the air: the wall between two offsets of a pipe with a radius at each point of its spine.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A tank with three different half-axes: the wall between two offsets of an ellipsoid, and its lining.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Arc length</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Base and offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Bezier coefficients</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Both sides</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Both skins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Both skins of an eight-sided dome whose wall grows from the oculus to the foot: a sphere and a tangent plane at each point of a triangulation.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Box</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Canal surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Canal surface from r²</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Certificate</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Coefficient {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Computing…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cone</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Constant</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cooling tower</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cylinder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Degree {}, spans {}, vertices {}, closed, {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Degree {}, spans {}, vertices {}, {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Depth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Distances without singular points; beyond the surface folds.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Dome</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Duct</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edit {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ellipse</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ellipsoid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ellipsoidal tank</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Elliptic paraboloid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Even</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Expression</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Flat</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>From a point</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>From the vertex</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Gauss curvature, 1/mm²</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Heights</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Hose</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Hyperbolic paraboloid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Inner radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Inner skin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Intake horn</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>K</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Linear</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lowest degree</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Markdown (*.md);;JSON (*.json)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mid-surface skins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mirror wavefront</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mirror with its wavefronts</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>More: menu PN Surfaces, Documentation, page {}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Moving conic section</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>No</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>No distance is proved to be free of singular points.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>No profile</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>No spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>None</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of a face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>One-sheet hyperboloid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Outer skin</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Output</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>PN Surfaces: documentation</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>PN Surfaces: examples</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parabolic cylinder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parallel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parameter</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Perpendicular</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Position</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Profile</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Quadric offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Rectangle</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Reflector</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Relative length</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Rounded bracket</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ruled surface offset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>STEP export</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>STEP export cancelled.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>STEP files (*.step *.stp)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Saddle roof</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Sector</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select one face, one straight edge or one vertex.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select one face.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select the mirror first: one face.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select the spine first: edges of one object, a wire or a sketch.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select three or six vertices of one object.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select two edges, wires or sketches first, or one ruled face.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select two edges, wires or sketches, or one ruled face.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Solid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Spherical</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Spray</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Stopped. The surface is that of earlier values.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Table</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The clipboard has no table of {} columns of numbers.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The union of all balls of six spheres, rounded everywhere, with a hole at each corner.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The wall of a one-sheet hyperboloid, equally thick from foot to rim.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>To the side</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Trough</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Twisted blade</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Two offsets</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Two-sheet hyperboloid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Typed below</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Upright</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Upwards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Valid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Values at vertices</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Vertex</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Vertex {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Wall thickness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What evaporating drops sweep on their flight: the squared radius is linear along a parabola.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whole</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Yes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>degree {} x {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>degree {}, spans {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>degree {}, spans {}, closed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>empty</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>smallest radius {} mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} away from the face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} to {} mm</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfacesPreferences</name>
        <message>
            <source>AP203</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>AP214</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>AP242</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Curves of the edges in the parameters of their faces: without them the file is smaller, and other programs project the edges anew</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Even</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Even lines give one smooth face, the lowest degree gives a face per arc</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>General</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lowest degree</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>New surfaces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Offset distance</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parameter lines</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>STEP export</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Schema</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The STEP application protocol of exported files</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The offset distance that a new surface starts with</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Write parametric curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_CanalSurface</name>
        <message>
            <source>Canal Surface…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Creates the exact pipe of varying radius around a spine, and its exact offsets</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_Certificate</name>
        <message>
            <source>Certificate…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shows what is proved and measured of the selected surfaces, to read, copy and save</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_Combs</name>
        <message>
            <source>Curvature Combs</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shows combs of curvature along parameter lines of the selected surfaces, on and off</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_ControlNet</name>
        <message>
            <source>Control Net</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shows the poles of the selected surfaces, on and off</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_CurvatureMap</name>
        <message>
            <source>Colours the selected surfaces by their smallest radius of curvature, on and off</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Curvature Map</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_Documentation</name>
        <message>
            <source>Documentation</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shows what the commands do, and the theorems they rest on</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_Examples</name>
        <message>
            <source>Examples…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Opens a ready document from the gallery of examples</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_ExportStep</name>
        <message>
            <source>STEP Export…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Writes the selected objects to a STEP file that keeps every digit</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_GaussMap</name>
        <message>
            <source>Colours the selected surfaces by their Gauss curvature, on and off</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Gauss Curvature Map</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_MidSurfaceSkins</name>
        <message>
            <source>Creates both exact skins of a mid-surface whose thickness varies, from six spheres</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mid-Surface Skins…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_MirrorWavefront</name>
        <message>
            <source>Creates the exact wavefront of parallel light, or of light from a point, behind a mirror</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mirror Wavefront…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_MovingConicSection</name>
        <message>
            <source>Creates the exact surface of ellipses, parabolas or hyperbolas along a spine, which change</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Moving Conic Section…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_ParameterLines</name>
        <message>
            <source>Parameter Lines</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shows the parameter lines of the selected surfaces, on and off</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_QuadricOffset</name>
        <message>
            <source>Creates the exact offset of an ellipsoid, hyperboloid, paraboloid, cone or cylinder</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Quadric Offset…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_RuledOffset</name>
        <message>
            <source>Creates the exact offset of the surface of straight lines between two curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ruled Surface Offset…</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_SquaredRadiusCanal</name>
        <message>
            <source>Canal Surface from r²…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Creates the exact envelope of spheres around a spine whose squared radius is given</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>PNSurfaces_Zebra</name>
        <message>
            <source>Shows the stripes that the selected surfaces reflect, on and off</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Zebra</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>QuadricOffset</name>
        <message>
            <source>Angle from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Angle to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Quadric</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Region</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the selected face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The base surface, in standard position</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The face that lies on the quadric</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>a</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>b</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>c</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>deg</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>x from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>x to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>y from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>y to</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>z from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>z to</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Result</name>
        <message>
            <source>Area</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cut edges</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Degree</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Deviation</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Esc</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Exact</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Poles</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Regular range</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Result</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Stop</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Stops the computation and keeps the surface of earlier values</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Volume</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>RuledOffset</name>
        <message>
            <source>Curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ruled surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Second curve reversed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the two selected edges, wires or sketches, or the selected ruled face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The two curves between which straight lines run, or a ruled face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>SquaredRadiusCanal</name>
        <message>
            <source>4 mm^2 + 5 mm^2 * sin(pi*s)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Add</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Adds a row below the current one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Canal surface from r²</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>End</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Fit within</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Offsets are exact where the radius itself is rational.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Paste</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Position by</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Remove</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Removes the current row</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Replaces the rows by those copied from a spreadsheet (Ctrl+V pastes at the current row)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Squared radius</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Takes the selected edges, wire or sketch as the spine</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The curve through the centres of the spheres</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selection</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>mm^2</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>TriangulatedSkins</name>
        <message>
            <source>Mid-surface</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Skins</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The spheres: points of the mid-surface, and radii, which are half the thickness</source>
            <translation type="unfinished" />
        </message>
    </context>
</TS>
