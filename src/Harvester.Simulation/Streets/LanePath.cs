using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>
/// A path on which vehicles drive: a lane of a road between the junctions, or a path through a junction from one lane to another.
/// </summary>
internal sealed class LanePath
{
    private const double SampleStep = 0.5;

    private LanePath(int index, Road? road, bool forward, int lane, Junction? junction, Polyline line)
    {
        Index = index;
        Road = road;
        IsForward = forward;
        Lane = lane;
        Junction = junction;
        Line = line;
    }

    public int Index { get; }

    /// <summary>The road to which the lane belongs; null within a junction.</summary>
    public Road? Road { get; }

    /// <summary>Whether the lane's direction is that of the road's line.</summary>
    public bool IsForward { get; }

    /// <summary>The lane's number from the left of its direction.</summary>
    public int Lane { get; }

    /// <summary>The junction of the path; null on a road.</summary>
    public Junction? Junction { get; }

    public Polyline Line { get; }

    public double Length => Line.Length;

    /// <summary>The paths that continue from its end.</summary>
    public List<LanePath> Next { get; } = [];

    /// <summary>The paths that lead to its start.</summary>
    public List<LanePath> Previous { get; } = [];

    /// <summary>Other paths of the same junction that come so close that two vehicles would touch.</summary>
    public List<LanePath> Conflicts { get; } = [];

    /// <summary>Whether a vehicle that follows it can drive on forever.</summary>
    public bool GoesOn { get; set; } = true;

    public static LanePath OnRoad(int index, Road road, bool forward, int lane, AsphaltHeights heights)
    {
        double offset = road.Layout.LaneCentre(forward, lane);
        double length = road.Length - road.StartTrim - road.EndTrim;
        int steps = Math.Max(1, (int)Math.Ceiling(length / SampleStep));
        Vector3D[] points = new Vector3D[steps + 1];
        Vector3D[] tangents = new Vector3D[steps + 1];
        for (int i = 0; i <= steps; i++)
        {
            double along = length * i / steps;
            double distance = forward ? road.StartTrim + along : road.Length - road.EndTrim - along;
            points[i] = road.Curve.OffsetAt(distance, offset);
            tangents[i] = forward ? road.Curve.TangentAt(distance) : -road.Curve.TangentAt(distance);
        }

        Drape(
            points,
            tangents,
            heights,
            along =>
            {
                double distance = forward ? road.StartTrim + (length * along) : road.Length - road.EndTrim - (length * along);
                return heights.IsShared(road, distance, distance);
            }
        );
        return new LanePath(index, road, forward, lane, null, new Polyline(points, tangents));
    }

    /// <summary>
    /// A cubic curve from the end of one lane to the start of another; its handles make a right-angled turn nearly a quarter circle.
    /// </summary>
    public static LanePath Through(int index, Junction junction, LanePath from, LanePath to, AsphaltHeights heights)
    {
        const double handle = 0.39;
        Vector3D start = from.Line.PositionAt(from.Length);
        Vector3D end = to.Line.PositionAt(0);
        double reach = (end - start).Length * handle;
        Vector3D a = start + (from.Line.TangentAt(from.Length) * reach);
        Vector3D b = end - (to.Line.TangentAt(0) * reach);
        int steps = Math.Max(2, (int)Math.Ceiling(reach / handle / SampleStep));
        Vector3D[] points = new Vector3D[steps + 1];
        Vector3D[] tangents = new Vector3D[steps + 1];
        for (int i = 0; i <= steps; i++)
        {
            double t = (double)i / steps;
            double u = 1 - t;
            points[i] = (start * (u * u * u)) + (a * (3 * u * u * t)) + (b * (3 * u * t * t)) + (end * (t * t * t));
            tangents[i] = (((a - start) * (u * u)) + ((b - a) * (2 * u * t)) + ((end - b) * (t * t))).Normalized();
        }

        Drape(points, tangents, heights, _ => true);
        LanePath path = new(index, null, forward: true, from.Lane, junction, new Polyline(points, tangents));
        Join(from, path);
        Join(path, to);
        return path;
    }

    /// <summary>Lays a path on the asphalt of roads that overlap.</summary>
    private static void Drape(Vector3D[] points, Vector3D[] tangents, AsphaltHeights heights, Func<double, bool> isShared)
    {
        const int stride = 4;
        double previous = 0;
        bool isChanged = false;
        for (int last = 0, first = 0; first < points.Length; first = last + 1)
        {
            last = first == 0 ? 0 : Math.Min(first + stride - 1, points.Length - 1);
            Vector3D place = points[last];
            bool isAlone = !isShared((double)last / (points.Length - 1));
            double change = isAlone ? 0 : (heights.Driven(place) ?? (place.Z + previous)) - place.Z;
            for (int i = first; i <= last; i++)
            {
                double fraction = (double)(i - first + 1) / (last - first + 1);
                points[i] += Horizontal.Up * (previous + ((change - previous) * fraction));
            }

            isChanged |= change != 0;
            previous = change;
        }

        for (int i = 0; isChanged && i < points.Length; i++)
        {
            Vector3D way = points[Math.Min(i + 1, points.Length - 1)] - points[Math.Max(i - 1, 0)];
            Vector3D level = tangents[i] with { Z = 0 };
            tangents[i] = (level.Normalized() with { Z = way.Z / (way with { Z = 0 }).Length }).Normalized();
        }
    }

    private static void Join(LanePath from, LanePath to)
    {
        from.Next.Add(to);
        to.Previous.Add(from);
    }
}
