namespace Harvester.Simulation.Tests.Events;

/// <summary>Where a point lies on or beside a lane of the town.</summary>
/// <param name="Lane">The lane.</param>
/// <param name="Along">Metres along it on the ground.</param>
/// <param name="Right">Metres to the right of its line; negative to the left.</param>
/// <param name="HalfWidth">Half of its lane's width there, metres.</param>
/// <param name="Away">Distance from its strip, metres; 0 on it.</param>
/// <param name="Bearing">Direction of its line there, radians counter-clockwise from east.</param>
internal readonly record struct TownSpot(TownLane Lane, double Along, double Right, double HalfWidth, double Away, double Bearing);
