using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>What the mod has asked of the game.</summary>
/// <param name="rays">Counts the rays.</param>
internal sealed class GameCalls(GameRays rays) : ICallCounter
{
    /// <inheritdoc/>
    public long Natives => Mod.Natives.Calls;

    /// <inheritdoc/>
    public long Rays => rays.Casts;
}
