namespace Harvester.Geometry.Maps;

/// <summary>
/// Which lane leads to which through a junction: left turns from the leftmost lane into the leftmost, right turns from the rightmost into
/// the rightmost, straight on from every lane. If nothing leads straight on, the lanes share the exits. A lane to which none of this leads
/// begins beside the one next to it, or is a branch of a fork.
/// </summary>
internal static class TurnRules
{
    /// <summary>A bend of at most this leads straight on, radians: 35 degrees, at which roads merge and do not cross.</summary>
    private const double MaxStraight = 0.6;

    /// <summary>A sharper bend is a U-turn, radians: 137 degrees.</summary>
    private const double MaxTurn = 2.4;

    /// <summary>A lane of a fork leads into a branch whose nearest lane is at most this many lane widths aside.</summary>
    private const double MaxAside = 0.75;

    /// <summary>The ways through a junction.</summary>
    /// <param name="arms">The roads that meet there.</param>
    /// <param name="paths">Where the road data leads from one to another.</param>
    public static IEnumerable<(MapLane From, MapLane To, MapTurn Turn)> Ways(IReadOnlyList<JunctionArm> arms, JunctionPaths paths)
    {
        (MapLane From, MapLane To, MapTurn Turn)[] ways = [.. arms.SelectMany(arm => WaysFrom(arm, arms, paths))];
        var reached = new Dictionary<MapLane, MapLane>();
        foreach ((MapLane from, MapLane to, MapTurn turn) in ways)
        {
            // Of several lanes that lead to one, the one that goes straight on.
            if (!reached.ContainsKey(to) || turn == MapTurn.Straight)
            {
                reached[to] = from;
            }
        }

        return ways.Concat(
            arms.SelectMany(exit =>
                    exit.Outgoing.Where(lane => !reached.ContainsKey(lane)).Select(lane => Begun(lane, exit, arms, paths, reached))
                )
                .OfType<(MapLane, MapLane, MapTurn)>()
        );
    }

    /// <summary>
    /// The way to a lane to which no rule leads: from the lane that leads to the reached lane nearest to it, or, where none of its road is
    /// reached, from the road that bends least into it; null if a car would turn back to get there.
    /// </summary>
    private static (MapLane From, MapLane To, MapTurn Turn)? Begun(
        MapLane lane,
        JunctionArm exit,
        IReadOnlyList<JunctionArm> arms,
        JunctionPaths paths,
        Dictionary<MapLane, MapLane> reached
    )
    {
        MapLane? source = exit
            .Outgoing.Where(reached.ContainsKey)
            .OrderBy(other => Math.Abs(other.Index - lane.Index))
            .Select(other => reached[other])
            .FirstOrDefault();
        JunctionArm? arm = arms.Where(other =>
                other != exit
                && (source is null ? other.Incoming.Count > 0 : other.Incoming.Contains(source))
                && IsAhead(other, exit)
                && paths.Leads(other, exit)
                && Math.Abs(other.TurnInto(exit)) < MaxTurn
            )
            .OrderBy(other => Math.Abs(other.TurnInto(exit)))
            .FirstOrDefault();
        return arm is null ? null : (source ?? arm.Incoming.OrderBy(other => Aside(other, lane)).First(), lane, TurnOf(arm.TurnInto(exit)));
    }

    /// <summary>The ways from an arm: those of the rules and, where a road only goes on with more lanes, one to each that begins.</summary>
    private static IEnumerable<(MapLane From, MapLane To, MapTurn Turn)> WaysFrom(
        JunctionArm arm,
        IReadOnlyList<JunctionArm> arms,
        JunctionPaths paths
    )
    {
        (MapLane From, MapLane To, MapTurn Turn)[] ways = [.. ByRule(arm, arms, paths)];
        if (arms.Count != 2 || ways.Length == 0)
        {
            return ways;
        }

        JunctionArm exit = arms.First(other => other != arm);
        return ways.Concat(
            exit.Outgoing.Select((lane, index) => (From: arm.Incoming[Math.Min(index, arm.Incoming.Count - 1)], lane, ways[0].Turn))
                .Where(begun => !Array.Exists(ways, way => way.To == begun.lane))
        );
    }

    private static IEnumerable<(MapLane From, MapLane To, MapTurn Turn)> ByRule(
        JunctionArm arm,
        IReadOnlyList<JunctionArm> arms,
        JunctionPaths paths
    )
    {
        if (arm.Incoming.Count == 0)
        {
            yield break;
        }

        (JunctionArm Arm, double Turn)[] exits =
        [
            .. arms.Where(exit => exit != arm && exit.Outgoing.Count > 0 && IsAhead(arm, exit) && paths.Leads(arm, exit))
                .Select(exit => (Arm: exit, Turn: arm.TurnInto(exit)))
                .Where(exit => Math.Abs(exit.Turn) < MaxTurn)
                .OrderByDescending(exit => exit.Turn),
        ];
        JunctionArm[] straight = [.. exits.Where(exit => IsStraight(exit.Turn)).Select(exit => exit.Arm)];
        for (int lane = 0; lane < arm.Incoming.Count; lane++)
        {
            (JunctionArm Arm, double Turn)[] chosen =
            [
                .. exits.Where(exit =>
                    IsStraight(exit.Turn) ? straight.Length == 1 || LeadsInto(arm.Incoming[lane], exit.Arm, straight)
                    : exit.Turn > 0 ? lane == 0
                    : lane == arm.Incoming.Count - 1
                ),
            ];
            if (chosen.Length == 0 && exits.Length > 0)
            {
                chosen = [lane < arm.Incoming.Count / 2 ? exits[0] : exits[exits.Length - 1]];
            }

            foreach ((JunctionArm exit, double turn) in chosen)
            {
                yield return (arm.Incoming[lane], Target(arm, lane, exit, turn, arms), TurnOf(turn));
            }
        }
    }

    /// <summary>
    /// Whether a car can drive from one arm into another without turning back: the exit lies ahead of the arm's lanes, and they behind the
    /// exit's. In a junction of many nodes an arm may lie behind another.
    /// </summary>
    private static bool IsAhead(JunctionArm arm, JunctionArm exit)
    {
        MapLane from = arm.Incoming[0];
        Vector3D apart = exit.Outgoing[0].Centre[0] - from.Centre[from.Centre.Count - 1];
        var chord = new Vector2D(apart.X, apart.Y);
        return chord.Dot(from.EndDirection) > 0 && chord.Dot(exit.Outgoing[0].StartDirection) > 0;
    }

    private static bool IsStraight(double turn) => Math.Abs(turn) <= MaxStraight;

    private static MapTurn TurnOf(double turn) =>
        IsStraight(turn) ? MapTurn.Straight
        : turn > 0 ? MapTurn.Left
        : MapTurn.Right;

    private static MapLane Target(JunctionArm arm, int lane, JunctionArm exit, double turn, IReadOnlyList<JunctionArm> arms)
    {
        int exitLanes = exit.Outgoing.Count;
        bool isMerge =
            IsStraight(turn) && arms.Count(other => other.Incoming.Count > 0 && other != exit && IsStraight(other.TurnInto(exit))) > 1;
        return isMerge ? Nearest(arm.Incoming[lane], exit)
            : turn < -MaxStraight ? exit.Outgoing[Math.Max(0, exitLanes - arm.Incoming.Count + lane)]
            : exit.Outgoing[Math.Min(lane, exitLanes - 1)];
    }

    /// <summary>Whether a lane of a fork leads into a branch: one that lies ahead of it, or else the one nearest to it.</summary>
    private static bool LeadsInto(MapLane lane, JunctionArm branch, JunctionArm[] branches)
    {
        double aside = Aside(lane, Nearest(lane, branch));
        return aside <= MaxAside * lane.EndWidth || branches.Min(other => Aside(lane, Nearest(lane, other))) >= aside;
    }

    private static MapLane Nearest(MapLane lane, JunctionArm exit) => exit.Outgoing.OrderBy(target => Aside(lane, target)).First();

    /// <summary>How far a lane begins beside the continuation of another, metres.</summary>
    private static double Aside(MapLane lane, MapLane target)
    {
        Vector3D end = lane.Centre[lane.Centre.Count - 1];
        Vector3D start = target.Centre[0];
        return Math.Abs(lane.EndDirection.Cross(new Vector2D(start.X - end.X, start.Y - end.Y)));
    }
}
