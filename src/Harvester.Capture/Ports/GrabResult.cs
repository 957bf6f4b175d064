namespace Harvester.Capture.Ports;

/// <summary>Whether a picture was grabbed.</summary>
/// <param name="Refusal">Why the picture is not to be used, as a short camelCase word for the counters (minimised, covered, black); null when it is good.</param>
public readonly record struct GrabResult(string? Refusal)
{
    /// <summary>A good picture.</summary>
    public static GrabResult Good => default;

    /// <summary>Whether the picture can be used.</summary>
    public bool IsGood => Refusal is null;

    /// <summary>A picture not to be used.</summary>
    public static GrabResult Refused(string reason) => new(reason);
}
