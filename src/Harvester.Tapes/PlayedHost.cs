using GTA.Hosting;
using GTA.Math;

namespace Harvester.Tapes;

/// <summary>The stand-in's game: the mod's calls do not reach it, only its messages do.</summary>
/// <param name="folder">The folder that the mod appears to lie in.</param>
internal sealed class PlayedHost(string folder) : IGameHost
{
    /// <inheritdoc/>
    public string ScriptFile { get; } = Path.Combine(folder, "GtaDataHarvester.dll");

    /// <inheritdoc/>
    public void Call(NativeCall call) => throw new NotSupportedException($"{call.Native} bypassed the tape.");

    /// <inheritdoc/>
    public int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models) =>
        throw new NotSupportedException($"The list of {pool} bypassed the tape.");

    /// <inheritdoc/>
    public void Notify(string message) { }

    /// <inheritdoc/>
    public void Report(string fault) => throw new InvalidOperationException(fault);
}
