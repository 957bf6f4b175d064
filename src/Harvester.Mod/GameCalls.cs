using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>Counts the calls of the mod to the game.</summary>
/// <param name="rays">Counts the rays.</param>
internal sealed class GameCalls(GameRays rays) : ICallCounter
{
    /// <inheritdoc/>
    public long Natives => Mod.Natives.Calls;

    /// <inheritdoc/>
    public long Rays => rays.Casts;
}
