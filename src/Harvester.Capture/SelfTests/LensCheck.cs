using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Calibration;

namespace Harvester.Capture.SelfTests;

/// <summary>Calibrates the camera, and compares the lens in use with the one that is measured.</summary>
internal sealed class LensCheck(SelfTestContext context) : SelfCheck(context)
{
    /// <summary>The error of a camera model that harvests accept, pixels, as <c>MaxError</c> by default.</summary>
    private const double AllowedPixels = 1;

    private CalibrationSession? _session;

    public override string Title => "lens";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Lens];

    public override IEnumerable<SelfTestPhase> Run()
    {
        NeedPictures();
        if (Game.Markers is null || Context.Lines.Any(line => line.Check == SelfTestChecks.Markers && line.Verdict != SelfTestVerdict.Good))
        {
            throw new SelfTestException("the markers of a calibration are not all visible.");
        }

        if (Context.BestFreeze is not { } best)
        {
            throw new SelfTestException("no freeze method stops the world.");
        }

        Game.Pause.Method = best.Method;
        _session = new CalibrationSession(
            new CalibrationOptions { Image = Context.Options.Image, MaxPictureLagTicks = Context.PictureTicks }, Game);
        while (_session.Step() == CalibrationPhase.Settling)
        {
            yield return SelfTestPhase.Running;
        }

        if (_session.Result is not { } result)
        {
            throw new SelfTestException(_session.Fault ?? "the calibration has no result.");
        }

        Harvester.Geometry.Cameras.Lens used = Context.Options.Lens;
        bool isKnown = used != Harvester.Geometry.Cameras.Lens.Ideal;
        double error = isKnown ? result.Lens.Equals(used) ? result.Validation.RmsPixels : double.NaN : result.Before.RmsPixels;
        bool isRight = error <= AllowedPixels;
        Context.MeasuredLens = isRight || isKnown ? null : result.Lens;
        Context.Add(
            SelfTestChecks.Lens, isKnown || isRight ? SelfTestVerdict.Good : SelfTestVerdict.Note,
            $"A pinhole camera is off by {result.Before.RmsPixels:0.00} px, the measured lens by {result.Validation.RmsPixels:0.00} px.");
    }

    public override void Release() => _session?.Dispose();
}
