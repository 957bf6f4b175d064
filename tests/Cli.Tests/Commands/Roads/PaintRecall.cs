using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// How much of the paint that is in view was measured, by length. Painted lines are sampled every half metre, gaps between dashes
/// included. A sample is in view if an image has it, no farther from the camera than <see cref="MaxDistance"/>; what vehicles hide counts
/// as in view, and so does what is worn or in shadow. It is found if a measured line passes close to it.
/// </summary>
internal sealed class PaintRecall
{
    /// <summary>The distance up to which links are searched is 30 m; at half of it, a stripe of 10 cm is four pixels wide.</summary>
    private const double MaxDistance = 15;

    /// <summary>Distance of a sample from a measured line, metres: half the distance of the nearest real lines, as for false
    /// ones.</summary>
    private const double MaxApart = 0.5;

    private const double Step = 0.25;

    private int _visible;
    private int _found;

    public double Share => (double)_found / _visible;

    public double VisibleMetres { get; private set; }

    /// <summary>Adds a table, what is painted on its roads, and the cameras of the session in which it was measured.</summary>
    public void Judge(PaintTable table, RoadCurves curves, IEnumerable<PaintedLine> painted, IReadOnlyList<Camera> cameras)
    {
        ILookup<(int X, int Y), Vector3D> measured = table
            .Links.SelectMany(link => link.Lines.SelectMany(line => PlacesOf(curves.Of(link.Link), line)))
            .ToLookup(CellOf);
        ILookup<(int X, int Y), Camera> near = cameras
            .SelectMany(camera => CellsAround(camera.Pose.Position).Select(cell => (cell, camera)))
            .ToLookup(pair => pair.cell, pair => pair.camera);
        foreach (PaintedLine line in painted)
        {
            for (int i = 0; i + 1 < line.Points.Count; i++)
            {
                (Vector3D a, Vector3D b) = (line.Points[i].World, line.Points[i + 1].World);
                Vector3D place = (a + b) / 2;
                if (near[BlockOf(place)].Any(camera => Sees(camera, place)))
                {
                    _visible++;
                    VisibleMetres += (b - a).Length;
                    _found += IsNear(measured, place) ? 1 : 0;
                }
            }
        }
    }

    private static IEnumerable<Vector3D> PlacesOf(RoadCurve curve, LinePaint line)
    {
        int samples = Math.Max(1, (int)Math.Ceiling((line.ToStation - line.FromStation) / Step));
        return Enumerable
            .Range(0, samples + 1)
            .Select(i => line.FromStation + (i * (line.ToStation - line.FromStation) / samples))
            .Select(station => curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station)));
    }

    private static bool Sees(Camera camera, Vector3D place) =>
        (camera.Pose.Position - place).Length <= MaxDistance && camera.Project(place).Outcome == ProjectionOutcome.InImage;

    private static bool IsNear(ILookup<(int X, int Y), Vector3D> measured, Vector3D place)
    {
        (int x, int y) = CellOf(place);
        return Enumerable
            .Range(0, 9)
            .SelectMany(i => measured[(x + (i % 3) - 1, y + (i / 3) - 1)])
            .Any(other => new Vector2D(other.X - place.X, other.Y - place.Y).Length <= MaxApart);
    }

    private static IEnumerable<(int X, int Y)> CellsAround(Vector3D place)
    {
        (int x, int y) = BlockOf(place);
        return Enumerable.Range(0, 9).Select(i => (x + (i % 3) - 1, y + (i / 3) - 1));
    }

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X), (int)Math.Floor(place.Y));

    private static (int X, int Y) BlockOf(Vector3D place) =>
        ((int)Math.Floor(place.X / MaxDistance), (int)Math.Floor(place.Y / MaxDistance));
}
