using Harvester.Capture.Ports;
using Harvester.Play.Tapes;
using Harvester.Sessions.Imaging;

namespace Harvester.Tapes;

/// <summary>
/// Grabs the pictures of a tape. Of a picture that is not on it only the fingerprint is known: it is replaced by one of a single colour,
/// equal where the recorded ones were equal.
/// </summary>
/// <param name="tape">The tape.</param>
internal sealed class PlayedScreen(TapeCursor tape) : IScreen
{
    private const int BitsPerByte = 8;

    /// <inheritdoc/>
    public GrabResult Grab(PixelBuffer target)
    {
        (int width, int height) = (target.Size.Width, target.Size.Height);
        TapeGrab grab = tape.Take<TapeGrab>(taped => taped.Width == width && taped.Height == height, () => Describe(width, height));
        if (grab.Refusal is { } refusal)
        {
            return GrabResult.Refused(refusal);
        }

        if (grab.Pixels is { } pixels)
        {
            pixels.CopyTo(target.Bytes, 0);
        }
        else
        {
            for (int i = 0; i < target.Bytes.Length; i++)
            {
                target.Bytes[i] = (byte)(grab.Fingerprint >> (BitsPerByte * (i % PixelBuffer.BytesPerPixel)));
            }
        }

        return GrabResult.Good;
    }

    /// <summary>A grab as text.</summary>
    public static string Describe(int width, int height) => FormattableString.Invariant($"a picture of {width} x {height} pixels");
}
