using Harvester.Geometry.Work;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Measures by how many ticks the picture lags behind the reported camera. The camera of the frozen world is moved once, so that nothing
/// else needs to move: the lag is the difference of the ticks in which the move is seen and reported.
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

        int lag = Math.Max(0, seen - reported);
        Context.LagTicks = lag;
        SelfTestVerdict verdict =
            lag == 0 ? SelfTestVerdict.Good
            : lag <= Context.Options.MaxPictureLagTicks ? SelfTestVerdict.Note
            : SelfTestVerdict.Problem;
        Context.Add(
            SelfTestChecks.Lag,
            verdict,
            $"The picture is {lag} ticks behind the game; harvests allow {Context.Options.MaxPictureLagTicks}."
        );
        bool isLate = reported > seen;
        Context.Add(
            SelfTestChecks.CameraReport,
            isLate ? SelfTestVerdict.Note : SelfTestVerdict.Good,
            $"The camera is reported {(isLate ? "a tick after" : "in time for")} the picture that shows it."
        );
    }
}
