using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>
/// A random drive over a network: at each node on to another link that is driven that way, from a dead end to a new place. The car
/// follows centripetal Catmull-Rom splines through the nodes of its way, evaluated by Barry and Goldman's pyramid, beside the line
/// by the rule of the lanes (5.4 m wide, 4 m on narrow roads, right of the line and half the median on two-way roads, centred on
/// one-way roads), and wanders by up to half a metre.
/// </summary>
internal sealed class NetworkDrive(RoadNetwork network, int seed)
{
    private const double SampleStep = 2;
    private const double LaneWidth = 5.4;
    private const double NarrowLaneWidth = 4;
    private const double Wander = 0.5;
    private const double WanderLength = 40;
    private const double JunctionRadius = 15;

    private readonly Random _random = new(seed);

    public double Driven { get; private set; }

    public IEnumerable<DriveSample> Samples(double metres)
    {
        var junctions = Junctions();
        while (Driven < metres)
        {
            List<(int Link, bool IsForward)> way = Way();
            int wish = _random.Next(4);
            for (int i = 0; i < way.Count && Driven < metres; i++)
            {
                Vector3D p1 = Start(way[i]);
                Vector3D p2 = End(way[i]);
                Vector3D p0 = i > 0 ? Start(way[i - 1]) : p1 - (p2 - p1);
                Vector3D p3 = i + 1 < way.Count ? End(way[i + 1]) : p2 + (p2 - p1);
                double length = (p2 - p1).Length;
                int steps = Math.Max(1, (int)Math.Round(length / SampleStep));
                for (int step = 0; step < steps; step++)
                {
                    double t = (step + 0.5) / steps;
                    Vector3D line = Spline(p0, p1, p2, p3, t);
                    Vector3D ahead = Spline(p0, p1, p2, p3, t + 0.001) - Spline(p0, p1, p2, p3, t - 0.001);
                    double heading = Math.Atan2(-ahead.X, ahead.Y);
                    double right = OffsetOf(Lane(way[i], wish)) + (Wander * Math.Sin((Driven + (t * length)) / WanderLength * 2 * Math.PI));
                    var place = new Vector3D(line.X + (right * Math.Cos(heading)), line.Y + (right * Math.Sin(heading)), line.Z);
                    yield return new DriveSample(
                        place,
                        heading * 180 / Math.PI,
                        Lane(way[i], wish),
                        i > 0 ? Lane(way[i - 1], wish) : null,
                        i + 1 < way.Count ? Lane(way[i + 1], wish) : null,
                        t * length,
                        (1 - t) * length,
                        IsNear(junctions, line),
                        i == 0 && step == 0
                    );
                }

                Driven += length;
            }
        }
    }

    private List<(int Link, bool IsForward)> Way()
    {
        const int longest = 400;
        int first;
        do
        {
            first = _random.Next(network.Links.Count);
        } while (!IsForCars(first));

        var way = new List<(int Link, bool IsForward)> { (first, network.Links[first].LanesForward > 0) };
        while (way.Count < longest)
        {
            (int link, bool isForward) = way[^1];
            int node = isForward ? network.Links[link].To : network.Links[link].From;
            (int Link, bool IsForward)[] next =
            [
                .. network
                    .LinksOf(node)
                    .Where(other => other != link && IsForCars(other))
                    .Select(other => (other, network.Links[other].From == node))
                    .Where(other => (other.Item2 ? network.Links[other.other].LanesForward : network.Links[other.other].LanesBackward) > 0),
            ];
            if (next.Length == 0)
            {
                break;
            }

            way.Add(next[_random.Next(next.Length)]);
        }

        return way;
    }

    private bool IsForCars(int link)
    {
        RoadLink road = network.Links[link];
        RoadNodeFlags flags = network.Nodes[road.From].Flags | network.Nodes[road.To].Flags;
        return road.LanesForward + road.LanesBackward > 0 && (flags & RoadNodeFlags.Water) == 0;
    }

    private DriveLane Lane((int Link, bool IsForward) driven, int wish)
    {
        RoadLink road = network.Links[driven.Link];
        return new DriveLane(
            driven.Link,
            driven.IsForward,
            Math.Min(wish, (driven.IsForward ? road.LanesForward : road.LanesBackward) - 1)
        );
    }

    private double OffsetOf(DriveLane lane)
    {
        RoadLink road = network.Links[lane.Link];
        int mine = lane.IsForward ? road.LanesForward : road.LanesBackward;
        int oncoming = lane.IsForward ? road.LanesBackward : road.LanesForward;
        double width = (road.Flags & RoadLinkFlags.NarrowRoad) != 0 ? NarrowLaneWidth : LaneWidth;
        return oncoming > 0 ? ((road.MedianWidth ?? 0) / 2) + ((lane.Lane + 0.5) * width) : (lane.Lane + 0.5 - (mine / 2.0)) * width;
    }

    private Vector3D Start((int Link, bool IsForward) driven) =>
        network.Nodes[driven.IsForward ? network.Links[driven.Link].From : network.Links[driven.Link].To].Position;

    private Vector3D End((int Link, bool IsForward) driven) => Start((driven.Link, !driven.IsForward));

    private Dictionary<(int, int), List<Vector3D>> Junctions()
    {
        var found = new Dictionary<(int, int), List<Vector3D>>();
        for (int i = 0; i < network.Nodes.Count; i++)
        {
            if (network.LinksOf(i).Count > 2 || (network.Nodes[i].Flags & RoadNodeFlags.Junction) != 0)
            {
                (int, int) cell = Cell(network.Nodes[i].Position);
                (found.TryGetValue(cell, out List<Vector3D>? there) ? there : found[cell] = []).Add(network.Nodes[i].Position);
            }
        }

        return found;
    }

    private static bool IsNear(Dictionary<(int, int), List<Vector3D>> junctions, Vector3D place)
    {
        (int column, int row) = Cell(place);
        for (int x = column - 1; x <= column + 1; x++)
        {
            for (int y = row - 1; y <= row + 1; y++)
            {
                if (
                    junctions.TryGetValue((x, y), out List<Vector3D>? there)
                    && there.Exists(junction => (junction - place).Length < JunctionRadius)
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static (int Column, int Row) Cell(Vector3D place) =>
        ((int)Math.Floor(place.X / JunctionRadius), (int)Math.Floor(place.Y / JunctionRadius));

    private static Vector3D Spline(Vector3D p0, Vector3D p1, Vector3D p2, Vector3D p3, double t)
    {
        double t1 = Math.Sqrt((p1 - p0).Length);
        double t2 = t1 + Math.Sqrt((p2 - p1).Length);
        double t3 = t2 + Math.Sqrt((p3 - p2).Length);
        double at = t1 + (t * (t2 - t1));
        Vector3D a = Mix(p0, p1, 0, t1, at);
        Vector3D b = Mix(p1, p2, t1, t2, at);
        Vector3D c = Mix(p2, p3, t2, t3, at);
        return Mix(Mix(a, b, 0, t2, at), Mix(b, c, t1, t3, at), t1, t2, at);
    }

    private static Vector3D Mix(Vector3D a, Vector3D b, double from, double to, double at) =>
        (a * ((to - at) / (to - from))) + (b * ((at - from) / (to - from)));
}
