namespace Harvester.Play.Tapes;

/// <summary>A picture that was grabbed.</summary>
/// <param name="Width">Its width, pixels.</param>
/// <param name="Height">Its height, pixels.</param>
/// <param name="Refusal">Why it cannot be used; null if it can.</param>
/// <param name="Fingerprint">Equal for equal pictures; 0 if it was refused.</param>
/// <param name="Pixels">Its bytes, 3 per pixel; null if only the fingerprint was recorded.</param>
public sealed record TapeGrab(int Width, int Height, string? Refusal, ulong Fingerprint, byte[]? Pixels) : TapeEntry;
