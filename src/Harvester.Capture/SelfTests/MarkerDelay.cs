using Harvester.Capture.Calibration;
using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.SelfTests;

/// <summary>Shows markers in a frozen world, and observes when they are seen.</summary>
internal sealed class MarkerDelay(SelfTestContext context)
{
    private const int Columns = 5;
    private const int Rows = 4;
    private static readonly double[] Depths = [1.2];

    /// <summary>Fewer spots may be anything.</summary>
    private const int MinMarkers = 4;

    /// <summary>Ticks until the markers were seen; null if they never were, or this game draws none.</summary>
    public int? SeenTicks { get; private set; }

    /// <summary>Shows the markers and removes them.</summary>
    public IEnumerable<WorkStep> Run()
    {
        if (context.Game.Markers is not { } markers)
        {
            yield break;
        }

        PixelBuffer without = context.Grab();
        markers.Show(MarkerPlan.Across(context.Camera, Columns, Rows, context.MarkerRadius, Depths).Markers);
        for (int tick = 1; tick <= PictureLag.MaxTicks && SeenTicks is null; tick++)
        {
            yield return WorkStep.Tick;
            SeenTicks = MarkerDetector.Find(without, context.Grab(), context.MarkerRadius).Count >= MinMarkers ? tick : null;
        }

        markers.Clear();
        for (int tick = 0; tick < (SeenTicks ?? 0); tick++)
        {
            yield return WorkStep.Tick;
        }
    }
}
