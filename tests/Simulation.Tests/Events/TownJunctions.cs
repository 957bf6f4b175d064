using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// Where the roads of a town end for junctions, as docs/maps.md defines it, from the nodes and widths of the town. The town's own traffic
/// ends its lanes elsewhere: before shoulders, pedestrian crossings and everything between roads that meet at a small angle.
/// </summary>
internal sealed class TownJunctions
{
    private const double Corner = 1.5;
    private const double Farthest = 30;
    private const double SmallAngle = 0.6;
    private const double Least = 8;
    private const double LeastPart = 0.3;
    private const double LeastRest = 1;

    private readonly Site _site;
    private readonly Dictionary<RoadArm, double> _corners = [];
    private readonly Dictionary<RoadArm, double> _extents = [];
    private readonly HashSet<Road> _inside = [];

    public TownJunctions(Site site)
    {
        _site = site;
        foreach (Junction junction in site.Plan.Junctions)
        {
            bool isJunction = junction.Arms.Count > 2 || junction.Flags.HasFlag(RoadNodeFlags.Junction);
            bool isChange = junction.Arms.Count == 2 && LayoutFrom(junction.Arms[0]).Reversed() != LayoutFrom(junction.Arms[1]);
            foreach (RoadArm arm in junction.Arms)
            {
                _corners[arm] = isJunction ? CornerOf(arm, junction) : 0;
                _extents[arm] = isJunction || isChange ? ExtentOf(arm, _corners[arm]) : 0;
            }
        }

        FindInside();
    }

    /// <summary>Metres of a road that its junction takes, from its node; of a road within junctions, those of its traffic.</summary>
    public double Of(RoadArm arm) => IsInside(arm.Road) ? arm.Trim : _extents[arm];

    /// <summary>Whether a road lies within junctions from end to end.</summary>
    public bool IsInside(Road road) => _inside.Contains(road);

    /// <summary>Roads of which nothing is left are in junctions, which then go on into the roads beyond.</summary>
    private void FindInside()
    {
        var open = new Queue<Road>(_site.Plan.Roads.Where(IsUsedUp));
        while (open.TryDequeue(out Road? road))
        {
            if (!_inside.Add(road))
            {
                continue;
            }

            foreach (bool atStart in new[] { true, false })
            {
                Junction end = _site.Plan.Junctions.First(junction => junction.Arms.Contains(new RoadArm(road, atStart)));
                double left = end.Arms.Count == 2 ? _corners[new RoadArm(road, !atStart)] - road.Length : 0;
                foreach (RoadArm beyond in end.Arms.Where(arm => arm.Road != road))
                {
                    _extents[beyond] = Math.Max(_extents[beyond], ExtentOf(beyond, left));
                    if (IsUsedUp(beyond.Road))
                    {
                        open.Enqueue(beyond.Road);
                    }
                }
            }
        }
    }

    private bool IsUsedUp(Road road) =>
        road.Length - _extents[new RoadArm(road, AtStart: true)] - _extents[new RoadArm(road, AtStart: false)] < LeastRest;

    private static LaneLayout LayoutFrom(RoadArm arm) => (arm.AtStart ? arm.Road.Layout : arm.Road.Layout.Reversed()) with { Paint = null };

    /// <summary>Lengths of the links of a road, from the junction on.</summary>
    private double[] LinksOf(RoadArm arm)
    {
        Vector3D[] nodes = [.. arm.Road.Nodes.Select(node => _site.Network.Nodes[node].Position)];
        IEnumerable<double> lengths = nodes.Zip(nodes.Skip(1), (a, b) => Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2)));
        return arm.AtStart ? [.. lengths] : [.. lengths.Reverse()];
    }

    /// <summary>
    /// A junction takes its corner, and of the link on which that ends at least a part; links of which nothing is left are in it.
    /// </summary>
    private double ExtentOf(RoadArm arm, double corner)
    {
        double passed = 0;
        foreach (double link in LinksOf(arm))
        {
            double taken = Math.Max(corner - passed, Math.Min(Least, LeastPart * link));
            if (link - taken >= LeastRest)
            {
                return passed + taken;
            }

            passed += link;
        }

        return arm.Road.Length;
    }

    /// <summary>Where the edge of a road meets those of others that it neither merges with nor continues, with room for a corner.</summary>
    private static double CornerOf(RoadArm arm, Junction junction)
    {
        bool goesOn = junction.Arms.Any(other =>
            other != arm
            && Math.Abs(Turn(arm, other)) > Math.PI - SmallAngle
            && LayoutFrom(arm).Forward == LayoutFrom(other).Backward
            && LayoutFrom(arm).Backward == LayoutFrom(other).Forward
        );
        double farthest = 0;
        foreach (RoadArm other in junction.Arms.Where(other => other != arm))
        {
            double turn = Turn(arm, other);
            double angle = Math.Abs(turn);
            if (angle > Math.PI - SmallAngle || (angle < SmallAngle && goesOn))
            {
                continue;
            }

            // Seen away from the node, a road to the left meets the left edge with its right one.
            (double own, double facing) = turn > 0 ? (-LeftOf(arm), RightOf(other)) : (RightOf(arm), -LeftOf(other));
            double meeting = (facing + (own * Math.Cos(angle))) / Math.Sin(angle);
            farthest = Math.Max(farthest, Corner + Math.Min(meeting, Farthest));
        }

        return farthest;
    }

    private static double LeftOf(RoadArm arm) => LayoutFrom(arm).LeftEdge;

    private static double RightOf(RoadArm arm) => LayoutFrom(arm).RightEdge;

    /// <summary>From one arm to another, both seen away from the node, radians, positive to the left.</summary>
    private static double Turn(RoadArm arm, RoadArm other) =>
        Math.IEEERemainder(Math.Atan2(other.Outward.Y, other.Outward.X) - Math.Atan2(arm.Outward.Y, arm.Outward.X), 2 * Math.PI);
}
