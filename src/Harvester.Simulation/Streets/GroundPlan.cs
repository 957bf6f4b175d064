using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Paint;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>The ground of a world as faces: what is drawn, and over it lanes and the areas of crossings, which are not.</summary>
internal sealed class GroundPlan
{
    private const double PatchSize = 40;

    private readonly IReadOnlyList<MeshInstance> _drawn;
    private readonly Dictionary<(int X, int Y), List<GroundFace>> _lanes = [];

    /// <summary>Collects the faces.</summary>
    /// <param name="roads">The roads.</param>
    /// <param name="asphalt">Their asphalt.</param>
    /// <param name="marks">The crossings.</param>
    /// <param name="drawn">The meshes of the ground.</param>
    public GroundPlan(IEnumerable<Road> roads, Asphalt asphalt, IEnumerable<PaintedMark> marks, IReadOnlyList<MeshInstance> drawn)
    {
        _drawn = [.. drawn.Where(instance => KindOf(instance.Mesh.Kind) is not null)];
        foreach (Road road in roads.Where(road => !road.IsInner))
        {
            LaneLayout layout = road.Layout;
            double median = layout.IsOneWay ? 0 : layout.MedianWidth / 2;
            AddLanes(asphalt.Of(road), road, layout.LeftEdge, -median);
            AddLanes(asphalt.Of(road), road, median, layout.RightEdge);
        }

        foreach (PaintedMark mark in marks.Where(mark => mark.Kind == MarkKind.Crossing))
        {
            for (int i = 2; i < mark.Corners.Count; i++)
            {
                Add(new GroundFace(GroundKind.Crossing, mark.Corners[0], mark.Corners[i - 1], mark.Corners[i]));
            }
        }
    }

    /// <summary>The faces around a place, and some farther away.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Horizontal distance, metres.</param>
    public List<GroundFace> Near(Vector3D place, double range)
    {
        List<GroundFace> faces = [];
        foreach (MeshInstance instance in _drawn.Where(instance => IsNear(instance.Mesh.Min, instance.Mesh.Max, place, range)))
        {
            GroundKind kind = KindOf(instance.Mesh.Kind)!.Value;
            foreach (ref readonly MeshTriangle triangle in instance.Mesh.Given)
            {
                faces.Add(new GroundFace(kind, triangle.A, triangle.B, triangle.C));
            }
        }

        for (int x = Patch(place.X - range) - 1; x <= Patch(place.X + range) + 1; x++)
        {
            for (int y = Patch(place.Y - range) - 1; y <= Patch(place.Y + range) + 1; y++)
            {
                faces.AddRange(_lanes.GetValueOrDefault((x, y)) ?? []);
            }
        }

        return faces;
    }

    private static bool IsNear(Vector3D min, Vector3D max, Vector3D place, double range) =>
        min.X <= place.X + range && max.X >= place.X - range && min.Y <= place.Y + range && max.Y >= place.Y - range;

    private static GroundKind? KindOf(SurfaceKind kind) =>
        kind switch
        {
            SurfaceKind.Terrain or SurfaceKind.Pavement => GroundKind.Other,
            SurfaceKind.Road => GroundKind.Drivable,
            SurfaceKind.Marking => GroundKind.Line,
            _ => null,
        };

    private static int Patch(double metres) => (int)Math.Floor(metres / PatchSize);

    private void AddLanes(RoadFacets facets, Road road, double left, double right)
    {
        foreach (Vector3D[] face in right > left ? facets.Cover(road.StartTrim, road.Length - road.EndTrim, left, right) : [])
        {
            Add(new GroundFace(GroundKind.Lane, face[0], face[1], face[2]));
            Add(new GroundFace(GroundKind.Lane, face[0], face[2], face[3]));
        }
    }

    private void Add(GroundFace face)
    {
        (int X, int Y) patch = (Patch(face.A.X), Patch(face.A.Y));
        if (!_lanes.TryGetValue(patch, out List<GroundFace>? faces))
        {
            _lanes[patch] = faces = [];
        }

        faces.Add(face);
    }
}
