using Harvester.Geometry;

namespace Harvester.Capture.Harvesting;

/// <summary>Two greys that were drawn over the game, as pictures show them.</summary>
/// <param name="State">What became of them.</param>
/// <param name="Light">The grey of <see cref="LightGrey"/>, mean of its channels, 0 to 255.</param>
/// <param name="Middle">The grey of <see cref="MiddleGrey"/>, mean of its channels, 0 to 255.</param>
public sealed record ColourFinding(ColourState State, double Light, double Middle)
{
    /// <summary>A grey that is clipped if colours are overexposed.</summary>
    public const byte LightGrey = 192;

    /// <summary>A grey that changes if tones do.</summary>
    public const byte MiddleGrey = 128;

    /// <summary>The light grey is clipped if it comes back as at least this.</summary>
    internal const double ClippedLevel = 246;

    /// <summary>A mean colour may differ from what was drawn by scaling, compression and dithering, grey levels.</summary>
    internal const double ToleranceLevels = 6;

    private const int Channels = 3;

    /// <summary>The finding for what was seen of the two greys, red, green and blue.</summary>
    internal static ColourFinding Of(Vector3D light, Vector3D middle)
    {
        ColourState state =
            light.X >= ClippedLevel ? ColourState.Clipped
            : Math.Max(ErrorOf(light, LightGrey), ErrorOf(middle, MiddleGrey)) > ToleranceLevels ? ColourState.Changed
            : ColourState.Kept;
        return new ColourFinding(state, Mean(light), Mean(middle));
    }

    private static double ErrorOf(Vector3D seen, byte drawn) =>
        Math.Max(Math.Abs(seen.X - drawn), Math.Max(Math.Abs(seen.Y - drawn), Math.Abs(seen.Z - drawn)));

    private static double Mean(Vector3D colour) => (colour.X + colour.Y + colour.Z) / Channels;
}
