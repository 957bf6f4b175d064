using Harvester.Capture.Calibration;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Shows one half of the markers of a calibration, the other half, and all of them: a game that limits their number shows fewer together
/// than apart, whatever hides some of them.
/// </summary>
internal sealed class MarkerCheck(SelfTestContext context) : SelfCheck(context)
{
    private const int Columns = 15;
    private const int Rows = 11;
    private static readonly double[] Depths = [0.9, 1.2, 1.6];

    /// <summary>Fraction of the markers found one by one that must be found when all are drawn at once.</summary>
    private const double MinFraction = 0.9;

    /// <summary>Fewer spots may be anything.</summary>
    private const int MinMarkers = 8;

    public override string Title => "number of markers";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Markers];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Game.Markers is not { } markers)
        {
            throw new SelfTestException("this game draws no markers.");
        }

        yield return WorkStep.Do(Freeze());

        IReadOnlyList<PlannedMarker> all = MarkerPlan.Across(Context.Camera, Columns, Rows, Context.MarkerRadius, Depths).Markers;
        PixelBuffer without = Context.Grab();
        var found = new List<int>();
        PlannedMarker[][] shown =
        [
            [.. all.Where((_, number) => number % 2 == 0)],
            [.. all.Where((_, number) => number % 2 == 1)],
            [.. all],
        ];
        foreach (PlannedMarker[] part in shown)
        {
            markers.Show(part);
            yield return WorkStep.Do(Wait(Context.PictureTicks));

            PixelBuffer with = Context.Grab();
            found.Add(MarkerDetector.Find(without, with, Context.MarkerRadius).Count);
            if (found.Count == shown.Length)
            {
                Context.Keep("markers", with);
            }
        }

        int apart = found[0] + found[1];
        if (apart < MinMarkers)
        {
            Context.Add(
                SelfTestChecks.Markers,
                SelfTestVerdict.Problem,
                $"Only {apart} of {all.Count} markers are visible: ",
                "something is right in front of the camera, or this game does not draw them."
            );
        }
        else
        {
            bool areAll = found[2] >= MinFraction * apart;
            Context.Add(
                SelfTestChecks.Markers,
                areAll ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
                $"Of {all.Count} markers drawn at once, {found[2]} are visible; drawn in two halves, {apart}."
            );
        }
    }

    public override void Release() => Game.Markers?.Clear();
}
