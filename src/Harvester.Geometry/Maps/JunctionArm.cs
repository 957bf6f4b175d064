using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>A road's end at a junction.</summary>
/// <param name="Incoming">The lanes that lead into the junction, from left to right.</param>
/// <param name="Outgoing">The lanes that leave it, from left to right.</param>
/// <param name="Outward">Unit vector on the ground away from the junction.</param>
/// <param name="Node">Index of the junction's node at which the road ends.</param>
internal sealed record JunctionArm(IReadOnlyList<MapLane> Incoming, IReadOnlyList<MapLane> Outgoing, Vector2D Outward, int Node)
{
    /// <summary>The turn from this arm into another, radians, positive to the left, 0 straight on.</summary>
    public double TurnInto(JunctionArm exit) => Math.Atan2((Outward * -1).Cross(exit.Outward), (Outward * -1).Dot(exit.Outward));

    /// <summary>The ends of a road at junctions, each with the index of its junction.</summary>
    /// <param name="road">The road.</param>
    /// <param name="link">Its link.</param>
    public static IEnumerable<(int Junction, JunctionArm Arm)> Of(RoadSegment road, RoadLink link)
    {
        if (road.Start.Junction is { } start)
        {
            yield return (start, new JunctionArm(road.Backward, road.Forward, LaneNetworkBuilder.Unit(road.Line.VelocityAt(0)), link.From));
        }

        if (road.End.Junction is { } end)
        {
            yield return (
                end,
                new JunctionArm(road.Forward, road.Backward, LaneNetworkBuilder.Unit(road.Line.VelocityAt(1)) * -1, link.To)
            );
        }
    }
}
