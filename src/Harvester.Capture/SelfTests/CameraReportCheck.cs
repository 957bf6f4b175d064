using Harvester.Geometry.Work;
using Harvester.Sessions.SelfTests;
using Harvester.Sessions.Text;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Measures by how many ticks the picture lags behind the game, and whether the camera is reported in time. In the frozen world the camera
/// is moved once, so that nothing else needs to move, and markers are shown once, which are drawn at once.
/// </summary>
internal sealed class CameraReportCheck(SelfTestContext context) : SelfCheck(context)
{
    public override string Title => "lag of the picture";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Lag, SelfTestChecks.CameraReport];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Game.MountedCamera is not { } camera || Context.BestFreeze is not { MovesCamera: true })
        {
            throw new SelfTestException("the camera cannot be moved in the frozen world.");
        }

        yield return WorkStep.Do(Freeze());

        var shift = new CameraShift(Context);
        yield return WorkStep.Do(shift.Run(camera));

        if (shift is not { SeenTicks: { } seen, ReportedTicks: { } reported })
        {
            throw new SelfTestException("a move of the camera was not seen.");
        }

        var markers = new MarkerDelay(Context);
        yield return WorkStep.Do(markers.Run());

        // Markers are in the picture of the next tick, so what they take beyond it is the lag of the picture: lag = seen(markers) - 1.
        // Without markers, the report of the camera takes their place.
        int lag = Math.Max(0, markers.SeenTicks is { } drawn ? drawn - 1 : seen - reported);
        Context.LagTicks = lag;
        SelfTestVerdict verdict =
            lag == 0 ? SelfTestVerdict.Good
            : lag <= Context.Options.MaxPictureLagTicks ? SelfTestVerdict.Note
            : SelfTestVerdict.Problem;
        Context.Add(
            SelfTestChecks.Lag,
            verdict,
            $"The picture is {Counted.Of(lag, "tick")} behind the game; harvests allow {Context.Options.MaxPictureLagTicks}."
        );

        // The move was rendered at seen - lag.
        bool isLate = reported > seen - lag;
        Context.Add(
            SelfTestChecks.CameraReport,
            isLate ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"The camera is reported {(isLate ? "after" : "in time for")} the picture that shows it."
        );
    }

    public override void Release() => Game.Markers?.Clear();
}
