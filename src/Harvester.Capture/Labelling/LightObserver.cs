using Harvester.Geometry;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Reads the state of traffic lights from the image: the lit lamp is a patch of its colour in its third of the head's box. Heads that are
/// small, partly hidden, truncated or seen from the side stay unknown, as do those in which no single lamp stands out.
/// </summary>
internal static class LightObserver
{
    /// <summary>
    /// Minimum height of a head, pixels. A lens of a smaller head is less than three pixels wide, and partly mixed with its edge.
    /// </summary>
    private const double MinHeadPixels = 12;

    /// <summary>Maximum facing angle; beyond it visors hide the lenses.</summary>
    private const double MaxFacingAngleDegrees = 70;

    /// <summary>Maximum fraction of a head that may be hidden or outside the image.</summary>
    private const double MaxHiddenFraction = 0.05;

    /// <summary>
    /// Minimum fraction of lit pixels. A lens covers about a tenth of its head's box, less from the side; a twentieth of that is a
    /// reflection or noise.
    /// </summary>
    private const double MinLitFraction = 0.005;

    /// <summary>Minimum ratio of the pixels of the lit lamp to those of the next.</summary>
    private const double Prominence = 2;

    /// <summary>Sets the states that the image shows in the labels of a frame; known states are kept.</summary>
    public static void Observe(FrameDraft draft, PixelBuffer picture) =>
        draft.Update(label => IsReadable(label) ? WithState(label, picture) : label);

    /// <summary>Whether there is a light whose state the image may show.</summary>
    public static bool NeedsPicture(FrameDraft draft) => draft.Objects.Any(IsReadable);

    private static bool IsReadable(ObjectLabel label) =>
        label.Face is { Light.Method: LightMethod.Unknown } face
        && face.FacingAngleDegrees <= MaxFacingAngleDegrees
        && label.Box2D.Height >= MinHeadPixels
        && label.TruncatedFraction <= MaxHiddenFraction
        && label.OccludedFraction <= MaxHiddenFraction;

    private static ObjectLabel WithState(ObjectLabel label, PixelBuffer picture)
    {
        Box2D box = label.Box2D;
        var lit = new int[3];
        int pixels = 0;
        for (int row = (int)box.YMin; row < box.YMax && row < picture.Size.Height; row++)
        {
            for (int column = (int)box.XMin; column < box.XMax && column < picture.Size.Width; column++)
            {
                pixels++;
                LightState colour = LampColour.Of(picture, column, row);
                if (colour != LightState.Unknown && IsInItsThird(colour, (row + 0.5 - box.YMin) / box.Height))
                {
                    lit[(int)colour - 1]++;
                }
            }
        }

        int most = lit.Max();
        int next = lit.OrderByDescending(count => count).ElementAt(1);
        return most < MinLitFraction * pixels || most == 0 || most < Prominence * next
            ? label
            : label with
            {
                Face = label.Face! with
                {
                    Light = new LightLabel((LightState)(1 + lit.ToList().IndexOf(most)), LightMethod.Observed, (double)most / pixels),
                },
            };
    }

    /// <summary>
    /// Whether a height, 0 at the upper edge and 1 at the lower, lies in a lamp's third of the box; the box of a head seen from below
    /// reaches slightly above the head.
    /// </summary>
    private static bool IsInItsThird(LightState colour, double height)
    {
        const double overlap = 0.1;
        double third = (int)colour - 1;
        return height >= (third / 3) - overlap && height <= ((third + 1) / 3) + overlap;
    }
}
