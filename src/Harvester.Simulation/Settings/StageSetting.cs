using Harvester.Geometry;

namespace Harvester.Simulation.Settings;

/// <summary>Where the ego begins a scenario, and what is cleared around it beforehand.</summary>
/// <param name="Ground">
/// Where the ego stands, on the ground, metres, world: the lane nearest to it that leads in its direction is taken.
/// </param>
/// <param name="HeadingDegrees">Direction in which it looks, degrees counter-clockwise from north.</param>
/// <param name="Speed">Its speed at the beginning, m/s.</param>
public sealed record StageSetting(Vector3D Ground, double HeadingDegrees, double Speed)
{
    /// <summary>The points that the ego drives along: at each choice it takes the lane that leads nearest to them; metres, world.</summary>
    public IReadOnlyList<Vector3D> Way { get; init; } = [];

    /// <summary>Vehicles in traffic within this distance of the ego's start are not there at the beginning, metres.</summary>
    public double ClearMetres { get; init; } = 150;

    /// <summary>Places where no vehicle is parked, each with a radius, metres.</summary>
    public IReadOnlyList<(Vector3D Middle, double Radius)> ClearOfParked { get; init; } = [];

    /// <summary>
    /// The seconds after the beginning in which the last lights are green that the ego comes to until then; those before are so for as long
    /// before it comes to them. Null to begin at any time. If they never are for so long, they are green at the end of that time.
    /// </summary>
    public (double From, double To)? Green { get; init; }

    internal bool IsKeptClear(Vector3D place) =>
        ClearOfParked.Any(zone =>
            ((place.X - zone.Middle.X) * (place.X - zone.Middle.X)) + ((place.Y - zone.Middle.Y) * (place.Y - zone.Middle.Y))
            < zone.Radius * zone.Radius
        );
}
