namespace Harvester.Capture.Ports;

/// <summary>Whether an actor came into the world.</summary>
/// <param name="Handle">Its handle; 0 if it could not be put there.</param>
/// <param name="Reason">Why not, as a sentence; null if it is there.</param>
public readonly record struct StageSpawn(int Handle, string? Reason)
{
    /// <summary>An actor that is there.</summary>
    public static StageSpawn Of(int handle) => new(handle, null);

    /// <summary>An actor that cannot be there.</summary>
    public static StageSpawn Refused(string reason) => new(0, reason);
}
