using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Collects the parts of a mesh. Coordinates are metres in the model's frame: x right, y forward, z up.</summary>
public sealed class MeshBuilder
{
    private readonly List<MeshTriangle> _triangles = [];

    /// <summary>What the surface of the mesh is.</summary>
    public SurfaceKind Kind { get; init; }

    /// <summary>Whether the mesh casts shadows and takes light of the sky.</summary>
    public bool CastsShadows { get; init; } = true;

    /// <summary>Creates the mesh of all parts added.</summary>
    public Mesh Build() => new(_triangles) { Kind = Kind, CastsShadows = CastsShadows };

    /// <summary>Adds a triangle.</summary>
    public MeshBuilder AddTriangle(Vector3D a, Vector3D b, Vector3D c, Rgb colour, Surface surface = Surface.Matte)
    {
        _triangles.Add(new MeshTriangle(a, b, c, colour, surface));
        return this;
    }

    /// <summary>Adds a flat quadrilateral; corners in order around it.</summary>
    public MeshBuilder AddQuad(Vector3D a, Vector3D b, Vector3D c, Vector3D d, Rgb colour, Surface surface = Surface.Matte) =>
        AddTriangle(a, b, c, colour, surface).AddTriangle(a, c, d, colour, surface);

    /// <summary>Adds a flat convex polygon; corners in order around it.</summary>
    public MeshBuilder AddPolygon(IReadOnlyList<Vector3D> corners, Rgb colour, Surface surface = Surface.Matte)
    {
        ArgumentNullException.ThrowIfNull(corners);
        for (int i = 2; i < corners.Count; i++)
        {
            AddTriangle(corners[0], corners[i - 1], corners[i], colour, surface);
        }

        return this;
    }

    /// <summary>Adds all triangles of a mesh, rotated and translated.</summary>
    public MeshBuilder AddMesh(Mesh mesh, Pose pose)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        foreach (MeshTriangle t in mesh.Triangles)
        {
            AddTriangle(pose.ToWorld(t.A), pose.ToWorld(t.B), pose.ToWorld(t.C), t.Colour, t.Surface);
        }

        return this;
    }

    /// <summary>Adds a box.</summary>
    public MeshBuilder AddBox(Vector3D min, Vector3D max, Rgb colour, Surface surface = Surface.Matte) =>
        AddFrustum(min, max, min, max, colour, surface);

    /// <summary>
    /// Adds a body between a rectangle at the height of <paramref name="min"/> and another at the height of <paramref name="max"/>: a box
    /// whose top has a rectangle of its own, as a car's cabin or a hipped roof.
    /// </summary>
    /// <param name="min">Rear, left corner of the lower rectangle.</param>
    /// <param name="max">Front, right corner of the lower rectangle, at the height of the upper one.</param>
    /// <param name="topMin">Rear, left corner of the upper rectangle; its height is ignored.</param>
    /// <param name="topMax">Front, right corner of the upper rectangle; its height is ignored.</param>
    /// <param name="colour">Colour of all faces.</param>
    /// <param name="surface">Surface of all faces.</param>
    public MeshBuilder AddFrustum(Vector3D min, Vector3D max, Vector3D topMin, Vector3D topMax, Rgb colour, Surface surface = Surface.Matte)
    {
        Vector3D[] low = Rectangle(min, max, min.Z);
        Vector3D[] high = Rectangle(topMin, topMax, max.Z);
        AddPolygon(low, colour, surface);
        AddPolygon(high, colour, surface);
        for (int i = 0; i < low.Length; i++)
        {
            int next = (i + 1) % low.Length;
            AddQuad(low[i], low[next], high[next], high[i], colour, surface);
        }

        return this;
    }

    /// <summary>Adds a prism: a convex outline extruded along a vector, with both ends and the sides.</summary>
    /// <param name="outline">Corners of the first end, in order around it.</param>
    /// <param name="along">The vector from the first end to the other.</param>
    /// <param name="colour">Colour of all faces.</param>
    /// <param name="surface">Surface of all faces.</param>
    public MeshBuilder AddPrism(IReadOnlyList<Vector3D> outline, Vector3D along, Rgb colour, Surface surface = Surface.Matte)
    {
        ArgumentNullException.ThrowIfNull(outline);
        var other = new Vector3D[outline.Count];
        for (int i = 0; i < other.Length; i++)
        {
            other[i] = outline[i] + along;
        }

        AddPolygon(outline, colour, surface);
        AddPolygon(other, colour, surface);
        for (int i = 0; i < other.Length; i++)
        {
            int next = (i + 1) % other.Length;
            AddQuad(outline[i], outline[next], other[next], other[i], colour, surface);
        }

        return this;
    }

    /// <summary>Adds a tapered cylinder between two points; a radius of 0 makes a cone.</summary>
    /// <param name="start">Centre of the first end.</param>
    /// <param name="end">Centre of the other end; a different point.</param>
    /// <param name="startRadius">Radius of the first end, metres.</param>
    /// <param name="endRadius">Radius of the other end, metres.</param>
    /// <param name="sides">Number of faces around; at least 3. The first corner lies along the first cross direction.</param>
    /// <param name="colour">Colour of all faces.</param>
    /// <param name="surface">Surface of all faces.</param>
    public MeshBuilder AddCylinder(
        Vector3D start,
        Vector3D end,
        double startRadius,
        double endRadius,
        int sides,
        Rgb colour,
        Surface surface = Surface.Matte
    )
    {
        Vector3D[] low = Circle(start, end - start, startRadius, sides);
        Vector3D[] high = Circle(end, end - start, endRadius, sides);
        AddPolygon(low, colour, surface);
        AddPolygon(high, colour, surface);
        for (int i = 0; i < sides; i++)
        {
            int next = (i + 1) % sides;
            AddQuad(low[i], low[next], high[next], high[i], colour, surface);
        }

        return this;
    }

    /// <summary>Adds an ellipsoid made of rings of faces, as for a head or the crown of a tree.</summary>
    public MeshBuilder AddEllipsoid(Vector3D centre, Vector3D radii, int sides, int rings, Rgb colour, Surface surface = Surface.Matte)
    {
        Vector3D Point(int side, int ring)
        {
            double turn = 2 * Math.PI * side / sides;
            double tilt = (Math.PI * ring / rings) - (Math.PI / 2);
            return centre
                + new Vector3D(
                    radii.X * Math.Cos(tilt) * Math.Cos(turn),
                    radii.Y * Math.Cos(tilt) * Math.Sin(turn),
                    radii.Z * Math.Sin(tilt)
                );
        }

        for (int ring = 0; ring < rings; ring++)
        {
            for (int side = 0; side < sides; side++)
            {
                AddQuad(Point(side, ring), Point(side + 1, ring), Point(side + 1, ring + 1), Point(side, ring + 1), colour, surface);
            }
        }

        return this;
    }

    private static Vector3D[] Rectangle(Vector3D min, Vector3D max, double height) =>
        [new(min.X, min.Y, height), new(max.X, min.Y, height), new(max.X, max.Y, height), new(min.X, max.Y, height)];

    private static Vector3D[] Circle(Vector3D centre, Vector3D axis, double radius, int sides)
    {
        Vector3D along = axis.Normalized();
        Vector3D first = Math.Abs(along.Z) > 0.9 ? new(1, 0, 0) : new(0, 0, 1);
        first = (first - (along * first.Dot(along))).Normalized();
        Vector3D second = along.Cross(first);
        var circle = new Vector3D[sides];
        for (int i = 0; i < sides; i++)
        {
            double turn = 2 * Math.PI * i / sides;
            circle[i] = centre + (first * (radius * Math.Cos(turn))) + (second * (radius * Math.Sin(turn)));
        }

        return circle;
    }
}
