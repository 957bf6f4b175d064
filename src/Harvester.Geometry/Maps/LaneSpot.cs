namespace Harvester.Geometry.Maps;

/// <summary>Where a place lies on or beside a lane.</summary>
/// <param name="Lane">The lane.</param>
/// <param name="Direction">Unit vector of the lane's direction on the ground, at the point of its middle that is nearest.</param>
/// <param name="Along">Metres along the lane's middle, on the ground, from its start to that point.</param>
/// <param name="Right">Metres from the lane's middle to the right, on the ground; negative to the left.</param>
/// <param name="HalfWidth">Half of the lane's width there, metres.</param>
/// <param name="FromLane">Distance from the lane on the ground, metres; 0 on it.</param>
public readonly record struct LaneSpot(MapLane Lane, Vector2D Direction, double Along, double Right, double HalfWidth, double FromLane);
