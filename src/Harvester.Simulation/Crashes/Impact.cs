using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>An impact of two bodies in one step of the world: what happened, not what a label says.</summary>
/// <param name="TimeSeconds">The world's time at the end of the step.</param>
/// <param name="First">Handle of one entity.</param>
/// <param name="Second">Handle of the other, on which the impulse acts; its opposite acts on the first.</param>
/// <param name="Impulse">N s, world x and y.</param>
/// <param name="Point">The contact, metres, world x and y.</param>
/// <param name="Normal">Unit vector from the first to the second.</param>
/// <param name="ClosingSpeed">Speed at which the two points approached each other along the normal, m/s.</param>
internal sealed record Impact(
    double TimeSeconds,
    int First,
    int Second,
    Vector2D Impulse,
    Vector2D Point,
    Vector2D Normal,
    double ClosingSpeed
);
