using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Features;

/// <summary>A screen that shows the image that a client has just been sent, so that the recorded one is the same.</summary>
internal sealed class SentPicture : IScreen
{
    /// <summary>The image; null if there is none.</summary>
    public PixelBuffer? Picture { get; set; }

    /// <inheritdoc/>
    public GrabResult Grab(PixelBuffer target)
    {
        if (Picture is not { } picture)
        {
            return GrabResult.Refused("notSent");
        }

        Buffer.BlockCopy(picture.Bytes, 0, target.Bytes, 0, target.Bytes.Length);
        return GrabResult.Good;
    }
}
