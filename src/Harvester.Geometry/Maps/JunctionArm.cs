namespace Harvester.Geometry.Maps;

/// <summary>A road's end at a junction.</summary>
/// <param name="Incoming">The lanes that lead into the junction, from left to right.</param>
/// <param name="Outgoing">The lanes that leave it, from left to right.</param>
/// <param name="Outward">Unit vector on the ground away from the junction.</param>
internal sealed record JunctionArm(IReadOnlyList<MapLane> Incoming, IReadOnlyList<MapLane> Outgoing, Vector2D Outward)
{
    /// <summary>The turn from this arm into another, radians, positive to the left, 0 straight on.</summary>
    public double TurnInto(JunctionArm exit) => Math.Atan2((Outward * -1).Cross(exit.Outward), (Outward * -1).Dot(exit.Outward));
}
