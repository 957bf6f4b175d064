namespace Harvester.Sessions.Scenes;

/// <summary>Everything from which a frame's labels are made, read once. After it, the game is asked only for rays.</summary>
/// <param name="GameFrame">The game's frame count at the moment of reading.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="Camera">The camera that the game renders with.</param>
/// <param name="Ego">The vehicle that carries the camera.</param>
/// <param name="Entities">The entities within the labelling range, without the ego vehicle, in the order of their handles.</param>
/// <param name="Environment">Weather and time of day.</param>
public sealed record SceneSnapshot(
    long GameFrame,
    double TimeSeconds,
    CameraState Camera,
    EgoState Ego,
    IReadOnlyList<EntityState> Entities,
    EnvironmentState Environment
)
{
    /// <summary>The entities beyond the labelling range that are near enough to be visible, in the order of their handles.</summary>
    public IReadOnlyList<EntityState> Distant { get; init; } = [];
}
