using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Driving.Scenarios;

/// <summary>Makes tracks from lanes and those that precede and follow them.</summary>
internal static class LaneTracks
{
    /// <summary>Length of a track before and after its zero, metres, where the lanes are long enough.</summary>
    public const double Behind = 150;
    public const double Ahead = 320;

    /// <summary>The track through a place on a lane; its zero is there.</summary>
    /// <param name="lane">The lane.</param>
    /// <param name="along">Metres from the lane's start.</param>
    /// <param name="turn">Where it leads at the first junction with a choice; straight on at all others.</param>
    public static LaneTrack Of(MapLane lane, double along, MapTurn turn = MapTurn.Straight) => Chain(lane, along, turn).Track;

    /// <summary>The same with the lanes.</summary>
    public static LaneChain Chain(MapLane lane, double along, MapTurn turn)
    {
        List<MapLane> lanes = [lane];
        double ahead = lane.Length - along;
        bool hasTurned = false;
        while (ahead < Ahead && Next(lanes[lanes.Count - 1], hasTurned ? MapTurn.Straight : turn) is { } next && !lanes.Contains(next))
        {
            hasTurned |= IsChoice(lanes[lanes.Count - 1]);
            lanes.Add(next);
            ahead += next.Length;
        }

        double behind = along;
        while (
            behind < Behind
            && Straightest(lanes[0].Predecessors, lanes[0].StartDirection, isBefore: true) is { } before
            && !lanes.Contains(before)
        )
        {
            lanes.Insert(0, before);
            behind += before.Length;
        }

        double[] starts = new double[lanes.Count];
        starts[0] = -behind;
        for (int i = 1; i < starts.Length; i++)
        {
            starts[i] = starts[i - 1] + lanes[i - 1].Length;
        }

        return new LaneChain(new LaneTrack(lanes.SelectMany(each => each.Centre), -behind), lanes, starts);
    }

    /// <summary>Whether traffic can go several ways at the end of a lane.</summary>
    public static bool IsChoice(MapLane lane) => lane.Successors.Select(next => next.Turn).Distinct().Count() > 1;

    private static MapLane? Next(MapLane lane, MapTurn turn) =>
        turn != MapTurn.Straight && IsChoice(lane)
            ? lane.Successors.FirstOrDefault(next => next.Turn == turn)
            : Straightest(lane.Successors, lane.EndDirection, isBefore: false);

    private static MapLane? Straightest(IReadOnlyList<MapLane> lanes, Vector2D direction, bool isBefore) =>
        lanes
            .OrderBy(lane => lane.Turn is null or MapTurn.Straight ? 0 : 1)
            .ThenByDescending(lane => (isBefore ? lane.StartDirection : lane.EndDirection).Dot(direction))
            .FirstOrDefault();
}
