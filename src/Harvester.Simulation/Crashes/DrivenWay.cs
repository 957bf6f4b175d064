using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>The way of a driven body in one step of the world: straight and evenly from one pose to another.</summary>
/// <param name="From">Its middle at the beginning, metres, world x and y.</param>
/// <param name="FromYaw">Its direction then, radians.</param>
/// <param name="To">Its middle at the end.</param>
/// <param name="Turn">Its change of direction, radians, positive to the left.</param>
internal readonly record struct DrivenWay(Vector2D From, double FromYaw, Vector2D To, double Turn)
{
    public Vector2D PositionAt(double share) => From + ((To - From) * share);

    public double YawAt(double share) => FromYaw + (Turn * share);
}
