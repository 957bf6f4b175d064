using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Lanes;

/// <summary>
/// A road whose line is known in closed form: pieces of constant curvature, from the origin to the north. It knows nothing of splines,
/// nodes or matching.
/// </summary>
internal sealed class AnalyticRoad
{
    private readonly List<(double Start, double X, double Y, double Angle, double Curvature, double Length)> _pieces = [];

    /// <param name="pieces">Curvature (1/m, positive to the left) and length (m) of each.</param>
    public AnalyticRoad(params (double Curvature, double Length)[] pieces)
    {
        double start = 0;
        (double x, double y, double angle) = (0, 0, Math.PI / 2);
        foreach ((double curvature, double length) in pieces)
        {
            _pieces.Add((start, x, y, angle, curvature, length));
            (x, y, angle) = Step(x, y, angle, curvature, length);
            start += length;
        }

        Length = start;
    }

    public double Length { get; }

    /// <summary>The line's point at a station, moved to the right, and the road's angle from east, radians.</summary>
    public (Vector3D Point, double Angle) At(double station, double right = 0)
    {
        (double start, double x, double y, double angle, double curvature, _) = _pieces.Last(piece => piece.Start <= station);
        (x, y, angle) = Step(x, y, angle, curvature, station - start);
        return (new Vector3D(x + (right * Math.Sin(angle)), y - (right * Math.Cos(angle)), 0), angle);
    }

    /// <summary>The road's heading at a station, degrees counter-clockwise from north.</summary>
    public double HeadingAt(double station) => Angles.WrapHeadingDegrees(Angles.ToDegrees(At(station).Angle) - 90);

    public double CurvatureAt(double station) => _pieces.Last(piece => piece.Start <= station).Curvature;

    public RoadNetwork Network(double spacing, int lanesForward, int lanesBackward, double? median = null)
    {
        int count = (int)Math.Round(Length / spacing) + 1;
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, count)
                .Select(i => new RoadNode(0, i, At(Math.Min(i * spacing, Length)).Point, string.Empty, RoadNodeFlags.None)),
        ];
        RoadLink[] links =
        [
            .. Enumerable.Range(0, count - 1).Select(i => new RoadLink(i, i + 1, lanesForward, lanesBackward, median, RoadLinkFlags.None)),
        ];
        return new RoadNetwork(nodes, links);
    }

    private static (double X, double Y, double Angle) Step(double x, double y, double angle, double curvature, double length)
    {
        if (curvature == 0)
        {
            return (x + (length * Math.Cos(angle)), y + (length * Math.Sin(angle)), angle);
        }

        // A circle of radius 1 / curvature about a centre to the left.
        double turned = angle + (curvature * length);
        return (x + ((Math.Sin(turned) - Math.Sin(angle)) / curvature), y - ((Math.Cos(turned) - Math.Cos(angle)) / curvature), turned);
    }
}
