using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Finds the roads at a point: a grid on the ground whose cells list the samples of roads that reach into them.</summary>
internal sealed class StreetIndex
{
    private const double CellSize = 10;
    private const double SampleStep = 4;

    /// <summary>Maximum distance beside a carriageway at which positions are still found, metres.</summary>
    private const double Reach = 12;

    private readonly Dictionary<(int X, int Y), List<(Road Road, double Distance, Vector3D Point)>> _cells = [];

    public StreetIndex(IReadOnlyList<Road> roads)
    {
        foreach (Road road in roads)
        {
            int steps = Math.Max(1, (int)Math.Ceiling(road.Length / SampleStep));
            for (int i = 0; i <= steps; i++)
            {
                Insert(road, road.Length * i / steps);
            }
        }
    }

    /// <summary>The positions of a point on the roads on which or beside which it lies, except before or behind their ends.</summary>
    /// <param name="point">Metres, world.</param>
    /// <param name="pastTheEnd">Distance before or behind an end that still counts as beside the road, metres.</param>
    /// <param name="except">A road to ignore.</param>
    /// <param name="beside">Distance beside a carriageway that matters to the caller, metres; places farther away may be left out.</param>
    public IEnumerable<RoadPlace> PlacesAt(Vector3D point, double pastTheEnd = 0.05, Road? except = null, double beside = Reach)
    {
        if (!_cells.TryGetValue(CellOf(point), out List<(Road Road, double Distance, Vector3D Point)>? samples))
        {
            yield break;
        }

        int i = 0;
        while (i < samples.Count)
        {
            Road road = samples[i].Road;
            double nearest = 0;
            double best = double.PositiveInfinity;
            double nearestOnGround = double.PositiveInfinity;
            for (; i < samples.Count && samples[i].Road == road; i++)
            {
                double squared = (samples[i].Point - point).LengthSquared;
                nearestOnGround = Math.Min(nearestOnGround, Horizontal.SquaredDistance(samples[i].Point, point));
                if (squared < best)
                {
                    best = squared;
                    nearest = samples[i].Distance;
                }
            }

            if (road == except || nearestOnGround > Squared(road.Layout.HalfWidth + beside + pastTheEnd + SampleStep))
            {
                continue;
            }

            double distance = road.Curve.Project(point, nearest);
            Vector3D tangent = road.Curve.TangentAt(distance);
            Vector3D offset = point - road.Curve.PositionAt(distance);
            if (Math.Abs((offset.X * tangent.X) + (offset.Y * tangent.Y)) < pastTheEnd)
            {
                yield return new RoadPlace(road, distance, offset.Dot(Horizontal.RightOf(tangent)), offset.Z);
            }
        }
    }

    /// <summary>Whether no road but one may reach to a point.</summary>
    public bool IsAlone(Road? road, Vector3D point) =>
        !_cells.TryGetValue(CellOf(point), out List<(Road Road, double Distance, Vector3D Point)>? samples)
        || (samples[0].Road == samples[^1].Road && (road is null || samples[0].Road == road));

    /// <summary>Whether a point lies on the carriageway of another road on the same level.</summary>
    public bool IsOnAnother(Road? road, Vector3D point, double margin)
    {
        const double sameLevel = 2.5;
        return PlacesAt(point, except: road, beside: margin)
            .Any(place => Math.Abs(place.Height) < sameLevel && place.IsOnCarriageway(margin));
    }

    /// <summary>Whether a point lies on, over or under a carriageway extended by a margin, also past its ends, on any level.</summary>
    public bool IsAbreast(Vector3D point, double margin) =>
        PlacesAt(point, pastTheEnd: margin, beside: margin).Any(place => place.IsOnCarriageway(margin));

    private static double Squared(double value) => value * value;

    private static (int X, int Y) CellOf(Vector3D point) => ((int)Math.Floor(point.X / CellSize), (int)Math.Floor(point.Y / CellSize));

    private void Insert(Road road, double distance)
    {
        Vector3D point = road.Curve.PositionAt(distance);
        double reach = road.Layout.HalfWidth + Reach;
        Vector3D corner = new(reach, reach, 0);
        (int minX, int minY) = CellOf(point - corner);
        (int maxX, int maxY) = CellOf(point + corner);
        for (int x = minX; x <= maxX; x++)
        {
            for (int y = minY; y <= maxY; y++)
            {
                if (!_cells.TryGetValue((x, y), out List<(Road, double, Vector3D)>? list))
                {
                    _cells[(x, y)] = list = [];
                }

                list.Add((road, distance, point));
            }
        }
    }
}
