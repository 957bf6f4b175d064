namespace Harvester.Capture.Ports;

/// <summary>Whether an image was grabbed.</summary>
/// <param name="Refusal">
/// Why the image must not be used, as a short camelCase word for the counters (minimised, covered, black); null if it can be used.
/// </param>
public readonly record struct GrabResult(string? Refusal)
{
    /// <summary>The image was grabbed and can be used.</summary>
    public static GrabResult Good => default;

    /// <summary>Whether the image can be used.</summary>
    public bool IsGood => Refusal is null;

    /// <summary>The image must not be used.</summary>
    /// <param name="reason">The reason, as in <see cref="Refusal"/>.</param>
    public static GrabResult Refused(string reason) => new(reason);
}
