namespace Harvester.Simulation.Streets;

/// <summary>All paths on which vehicles drive, and which follow which.</summary>
internal sealed class LaneGraph
{
    /// <summary>Paths closer together than this conflict, metres: a truck's width with a little room.</summary>
    private const double ConflictDistance = 3.2;

    /// <summary>Paths that cross at heights farther apart than this do not conflict, metres: one passes over the other.</summary>
    private const double SameLevel = 4;

    private const double MaxTurn = 2.4;
    private const double StraightAtMost = 0.6;

    private readonly AsphaltHeights _heights;
    private readonly List<LanePath> _paths = [];

    public LaneGraph(RoadPlan plan, AsphaltHeights heights)
    {
        _heights = heights;
        Dictionary<(Road, bool), List<LanePath>> lanes = [];
        foreach (Road road in plan.Roads)
        {
            foreach (bool forward in new[] { true, false })
            {
                List<LanePath> own = [];
                for (int lane = 0; lane < road.Layout.Lanes(forward); lane++)
                {
                    own.Add(LanePath.OnRoad(_paths.Count, road, forward, lane, heights));
                    _paths.Add(own[^1]);
                }

                lanes[(road, forward)] = own;
            }
        }

        foreach (Junction junction in plan.Junctions)
        {
            Connect(junction, lanes);
        }

        FindConflicts();
        MarkDeadEnds();
    }

    public IReadOnlyList<LanePath> Paths => _paths;

    private void Connect(Junction junction, Dictionary<(Road, bool), List<LanePath>> lanes)
    {
        foreach (RoadArm arm in junction.Arms)
        {
            List<LanePath> incoming = lanes[(arm.Road, !arm.AtStart)];
            List<(List<LanePath> Lanes, double Turn)> exits =
            [
                .. junction
                    .Arms.Where(exit => exit != arm)
                    .Select(exit => (lanes[(exit.Road, exit.AtStart)], Horizontal.Turn(-arm.Outward, exit.Outward)))
                    .Where(exit => exit.Item1.Count > 0 && Math.Abs(exit.Item2) < MaxTurn)
                    .OrderBy(exit => -exit.Item2),
            ];
            foreach (LanePath lane in incoming)
            {
                foreach ((List<LanePath> lanesOfExit, double turn) in ExitsOf(lane.Lane, incoming.Count, exits))
                {
                    LanePath target = lanesOfExit[TargetLane(lane.Lane, incoming.Count, lanesOfExit.Count, turn)];
                    _paths.Add(LanePath.Through(_paths.Count, junction, lane, target, _heights));
                }
            }
        }
    }

    /// <summary>
    /// Left turns from the leftmost lane, right turns from the rightmost, straight on from all; if nothing leads straight on, each lane has
    /// an exit.
    /// </summary>
    private static List<(List<LanePath> Lanes, double Turn)> ExitsOf(int lane, int lanes, List<(List<LanePath> Lanes, double Turn)> exits)
    {
        List<(List<LanePath> Lanes, double Turn)> chosen =
        [
            .. exits.Where(exit =>
                (exit.Turn > StraightAtMost && lane == 0)
                || (exit.Turn < -StraightAtMost && lane == lanes - 1)
                || Math.Abs(exit.Turn) <= StraightAtMost
            ),
        ];
        return chosen.Count > 0 || exits.Count == 0 ? chosen : [lane < lanes / 2 ? exits[0] : exits[^1]];
    }

    private static int TargetLane(int lane, int lanes, int exitLanes, double turn) =>
        turn < -StraightAtMost ? Math.Max(0, exitLanes - lanes + lane) : Math.Min(lane, exitLanes - 1);

    /// <summary>
    /// Finds the ways through junctions that conflict: of the same junction, and of junctions so close together that their ways overlap.
    /// </summary>
    private void FindConflicts()
    {
        List<LanePath> ways = [.. _paths.Where(path => path.Junction is not null).OrderBy(path => West(path))];
        double longest = ways.Select(way => way.Length).DefaultIfEmpty().Max();
        for (int i = 0; i < ways.Count; i++)
        {
            for (int j = i + 1; j < ways.Count && West(ways[j]) - West(ways[i]) < longest + ConflictDistance; j++)
            {
                if (
                    !AreSuccessive(ways[i], ways[j])
                    && !AreSuccessive(ways[j], ways[i])
                    && ways[i].Previous[0] != ways[j].Previous[0]
                    && AreNear(ways[i], ways[j])
                )
                {
                    ways[i].Conflicts.Add(ways[j]);
                    ways[j].Conflicts.Add(ways[i]);
                }
            }
        }
    }

    private static double West(LanePath way) => way.Line.Points[0].X;

    /// <summary>Whether a way leads to another by one lane: vehicles drive along both, one behind the other.</summary>
    private static bool AreSuccessive(LanePath way, LanePath next) => way.Next[0].Next.Contains(next);

    private static bool AreNear(LanePath a, LanePath b) =>
        Horizontal.Distance(a.Line.Points[0], b.Line.Points[0]) < a.Length + b.Length + ConflictDistance
        && a.Line.Points.Any(p =>
            b.Line.Points.Any(q =>
                Horizontal.SquaredDistance(p, q) < ConflictDistance * ConflictDistance && Math.Abs(p.Z - q.Z) < SameLevel
            )
        );

    /// <summary>Marks paths without an end: one continues if one of its followers does; computed backwards from the dead ends.</summary>
    private void MarkDeadEnds()
    {
        Stack<LanePath> ending = new(_paths.Where(path => path.Next.Count == 0));
        while (ending.TryPop(out LanePath? path))
        {
            if (path.GoesOn)
            {
                path.GoesOn = false;
                foreach (LanePath previous in path.Previous.Where(previous => previous.Next.All(next => !next.GoesOn)))
                {
                    ending.Push(previous);
                }
            }
        }
    }
}
