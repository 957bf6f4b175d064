using Harvester.Geometry.Maps;

namespace Harvester.Driving.Scenarios;

/// <summary>The first junction ahead of the ego with roads from the sides.</summary>
/// <param name="Junction">The junction.</param>
/// <param name="Entry">Where the ego's track enters it, metres from the ego's start.</param>
/// <param name="Exit">Where the track leaves it.</param>
/// <param name="Lane">The ego's lane before it.</param>
/// <param name="Light">Whether it has traffic lights; found when it is first asked for.</param>
public sealed record StageJunction(MapJunction Junction, double Entry, double Exit, MapLane Lane, Lazy<bool> Light)
{
    /// <summary>Whether it has traffic lights.</summary>
    public bool HasLight => Light.Value;
}
