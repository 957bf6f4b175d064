using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Ports;

/// <summary>
/// The ground by known roads: lanes from their nodes, ways through junctions, crossings, and the paint that is known. What lies beside
/// lanes, such as shoulders and car parks, is unknown.
/// </summary>
/// <param name="roads">The roads.</param>
/// <param name="paint">The paint; null for none.</param>
internal sealed class KnownGround(IRoads roads, IRoadPaint? paint) : IGround
{
    /// <summary>Distance from a place within which the lanes are complete, metres.</summary>
    public const double ReachMetres = LaneMaps.ReachMetres;

    /// <summary>How far lines are lifted, metres, so that they lie above their lanes, whose heights are less exact.</summary>
    private const double Lift = 0.4;

    /// <inheritdoc/>
    public BirdsEyeSource Source => BirdsEyeSource.Roads;

    /// <inheritdoc/>
    public IReadOnlyList<GroundFace>? Near(Vector3D place, double range)
    {
        if (roads.Near(place)?.Maps.Value.Around(place) is not { } map)
        {
            return null;
        }

        var faces = new List<GroundFace>();
        foreach (MapLane lane in map.Lanes)
        {
            AddStrip(faces, GroundKind.Drivable, lane.Left, lane.Right);
            if (lane.Junction is null)
            {
                AddStrip(faces, GroundKind.Lane, lane.Left, lane.Right);
            }
        }

        foreach (MapCrossing crossing in map.Crossings)
        {
            for (int i = 2; i < crossing.Corners.Count; i++)
            {
                faces.Add(new GroundFace(GroundKind.Crossing, crossing.Corners[0], crossing.Corners[i - 1], crossing.Corners[i]));
            }
        }

        foreach (PaintedLine line in paint?.Near(place, range) ?? [])
        {
            Add(faces, line);
        }

        return faces;
    }

    private static void AddStrip(List<GroundFace> faces, GroundKind kind, IReadOnlyList<Vector3D> left, IReadOnlyList<Vector3D> right)
    {
        for (int i = 1; i < left.Count; i++)
        {
            AddQuad(faces, kind, left[i - 1], right[i - 1], right[i], left[i]);
        }
    }

    /// <summary>Adds the stretches between painted points.</summary>
    private static void Add(List<GroundFace> faces, PaintedLine line)
    {
        for (int i = 1; i < line.Points.Count; i++)
        {
            (LinePoint from, LinePoint to) = (line.Points[i - 1], line.Points[i]);
            Vector3D along = (to.World - from.World) with { Z = 0 };
            if (from.IsPainted && to.IsPainted && along.Length > 0)
            {
                Vector3D half = new Vector3D(along.Y, -along.X, 0) * (line.Paint.WidthMetres / 2 / along.Length);
                var up = new Vector3D(0, 0, Lift);
                (Vector3D near, Vector3D far) = (from.World + up, to.World + up);
                AddQuad(faces, GroundKind.Line, near - half, near + half, far + half, far - half);
            }
        }
    }

    private static void AddQuad(List<GroundFace> faces, GroundKind kind, Vector3D a, Vector3D b, Vector3D c, Vector3D d)
    {
        faces.Add(new GroundFace(kind, a, b, c));
        faces.Add(new GroundFace(kind, a, c, d));
    }
}
