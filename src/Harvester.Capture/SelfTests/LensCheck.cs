using Harvester.Capture.Calibration;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>Calibrates the camera, and compares the lens in use with the one that is measured.</summary>
internal sealed class LensCheck(SelfTestContext context) : SelfCheck(context), IDisposable
{
    /// <summary>The error of a camera model that harvests accept, pixels, as <c>MaxError</c> by default.</summary>
    private const double AllowedPixels = 1;

    private const int GridSize = 5;

    private CalibrationSession? _session;

    public override string Title => "lens";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Lens];

    public override IEnumerable<WorkStep> Run()
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
            new CalibrationOptions { Image = Context.Options.Image, MaxPictureLagTicks = Context.PictureTicks },
            Game
        );
        while (_session.Step() == CalibrationPhase.Settling)
        {
            yield return WorkStep.Tick;
        }

        if (_session.Result is not { } result)
        {
            throw new SelfTestException(_session.Fault ?? "the calibration has no result.");
        }

        double error = Difference(result.Lens);
        bool isRight = error <= AllowedPixels;
        Context.MeasuredLens = isRight ? null : result.Lens;
        Context.Add(
            SelfTestChecks.Lens,
            isRight ? SelfTestVerdict.Good : SelfTestVerdict.Note,
            $"The lens in use is off by up to {error:0.00} px, the measured one by {result.Validation.RmsPixels:0.00} px."
        );
    }

    /// <summary>
    /// The greatest distance between the pixels to which the measured lens and the one in use project the same point, over a grid of 5 x 5
    /// pixels that leaves out the border, where a calibration knows least.
    /// </summary>
    private double Difference(Lens measured)
    {
        CameraState state = Game.World.ReadCamera();
        ImageSize image = Context.Options.Image;
        Camera fitted = CameraWith(state, measured);
        Camera used = CameraWith(state, Context.Options.Lens);
        return Enumerable
            .Range(0, GridSize * GridSize)
            .Max(number =>
            {
                var pixel = new Vector2D(
                    image.Width * ((number % GridSize) + 0.5) / GridSize,
                    image.Height * ((number / GridSize) + 0.5) / GridSize
                );
                return (used.Project(fitted.Unproject(pixel.X, pixel.Y, 1)).Pixel - pixel).Length;
            });
    }

    private Camera CameraWith(CameraState state, Lens lens) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Context.Options.Image, state.WindowAspect, state.NearClip, lens));

    public void Dispose() => Release();

    public override void Release() => _session?.Dispose();
}
