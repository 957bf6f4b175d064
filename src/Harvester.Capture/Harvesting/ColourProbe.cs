using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Draws two greys over the game before the first frame and looks for them in pictures: HDR clips them, and filters change them. They are
/// drawn twice, with their places exchanged, so that what follows them cannot be mistaken for the game.
/// </summary>
internal sealed class ColourProbe(HarvestOptions options, GamePorts game, PixelBufferPool pool)
{
    /// <summary>The places of the two greys, fractions of the window.</summary>
    private static readonly Box2D[] Places = [new(0.3, 0.45, 0.4, 0.55), new(0.6, 0.45, 0.7, 0.55)];

    /// <summary>The part of each side of a place that is looked at: its border may be blurred.</summary>
    private const double MeasuredFraction = 0.5;

    /// <summary>A pixel follows the greys if it differs by more between the two pictures, grey levels.</summary>
    private const int FollowingLevels = 30;

    /// <summary>The fraction of a place that must follow.</summary>
    private const double NearlyAll = 0.97;

    /// <summary>The finding; null if nothing was drawn, or pictures do not show it.</summary>
    public ColourFinding? Finding { get; private set; }

    /// <summary>The warning if colours do not come back; otherwise null.</summary>
    public CaptureFault? Warning =>
        Finding switch
        {
            { State: ColourState.Clipped } found => Fault(
                FormattableString.Invariant(
                    $"Bright colours of pictures are clipped: a grey of 192 comes back as {found.Light:0}, as with HDR or Auto HDR."
                ) + " Switch both off in Windows."
            ),
            { State: ColourState.Changed } found => Fault(
                FormattableString.Invariant(
                    $"Colours of pictures are changed: greys of 192 and 128 come back as {found.Light:0} and {found.Middle:0}."
                ) + " Switch off filters, colour profiles and HDR."
            ),
            _ => null,
        };

    /// <summary>Takes the two pictures, over several ticks. Nothing is drawn any more afterwards.</summary>
    public IEnumerable<WorkStep> Run()
    {
        if (!options.ChecksDisplay || game.Card is not { } card)
        {
            yield break;
        }

        var pictures = new List<PixelBuffer>();
        try
        {
            foreach (
                (byte left, byte right) in new[]
                {
                    (ColourFinding.LightGrey, ColourFinding.MiddleGrey),
                    (ColourFinding.MiddleGrey, ColourFinding.LightGrey),
                }
            )
            {
                card.Show([Patch(0, left), Patch(1, right)]);
                for (int tick = 0; tick < options.MaxPictureLagTicks + DisplayProbe.ChangeTicks; tick++)
                {
                    yield return WorkStep.Tick;
                }

                PixelBuffer picture = pool.Rent();
                pictures.Add(picture);
                if (!game.Screen.Grab(picture).IsGood)
                {
                    yield break;
                }
            }

            card.Clear();
            Finding = FindingOf(pictures[0], pictures[1]);
            for (int tick = 0; tick < options.MaxPictureLagTicks + DisplayProbe.ChangeTicks; tick++)
            {
                yield return WorkStep.Tick;
            }
        }
        finally
        {
            card.Clear();
            pictures.ForEach(pool.Return);
        }
    }

    private static ColourPatch Patch(int place, byte grey) => new(Places[place], grey, grey, grey);

    private static CaptureFault Fault(string message) => new(FaultCode.ColoursChanged, message);

    private ColourFinding? FindingOf(PixelBuffer first, PixelBuffer second)
    {
        Box2D[] inner = [.. Places.Select(InnerOf)];
        return inner.All(box => Follows(box, first, second))
            ? ColourFinding.Of(
                (PicturePixels.MeanOf(first, inner[0]) + PicturePixels.MeanOf(second, inner[1])) * 0.5,
                (PicturePixels.MeanOf(first, inner[1]) + PicturePixels.MeanOf(second, inner[0])) * 0.5
            )
            : null;
    }

    private static bool Follows(Box2D box, PixelBuffer first, PixelBuffer second) =>
        PicturePixels.ChangedIn(box, first, second, FollowingLevels) >= NearlyAll * Math.Ceiling(box.Width) * Math.Ceiling(box.Height);

    /// <summary>The inner part of a place in a picture, pixels.</summary>
    private Box2D InnerOf(Box2D place)
    {
        (int width, int height) = (options.Image.Width, options.Image.Height);
        (double x, double y) = (place.Width * (1 - MeasuredFraction) / 2, place.Height * (1 - MeasuredFraction) / 2);
        return new Box2D((place.XMin + x) * width, (place.YMin + y) * height, (place.XMax - x) * width, (place.YMax - y) * height);
    }
}
