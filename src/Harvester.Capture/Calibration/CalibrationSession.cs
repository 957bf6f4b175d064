using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Calibration;

/// <summary>
/// Calibrates the game's camera: call <see cref="Step"/> once in every tick, from the game's own thread, until it is over. First a coarse
/// grid of markers is shown, each identified by the images that show it, because an unknown lens may show them far from where a pinhole
/// camera would. Then a fine grid that reaches into the corners of the image is shown, and finally another one to validate the result.
/// After construction, nothing is thrown to the caller. The game always ends up running and without markers.
/// </summary>
public sealed class CalibrationSession : IDisposable
{
    private const int CoarseColumns = 7;
    private const int CoarseRows = 5;
    private const int FineColumns = 15;
    private const int FineRows = 11;

    // Other dimensions than the fine grid's, so that a grid mistaken for itself shifted by one cell does not fit this one too.
    private const int CheckColumns = 12;
    private const int CheckRows = 8;
    private readonly CalibrationOptions _options;
    private readonly GamePorts _game;
    private readonly IMarkers _markers;
    private readonly MarkerSurvey _survey;
    private readonly WorkRun _run;

    /// <summary>Creates a session. The game is not used before the first step.</summary>
    /// <param name="options">How to calibrate.</param>
    /// <param name="game">The game, with <see cref="GamePorts.Markers"/>.</param>
    /// <exception cref="ArgumentException">The game cannot draw markers.</exception>
    public CalibrationSession(CalibrationOptions options, GamePorts game)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        _game = game ?? throw new ArgumentNullException(nameof(game));
        _markers = game.Markers ?? throw new ArgumentException("This game cannot draw markers.", nameof(game));
        _survey = new MarkerSurvey(options, game, _markers);
        _run = new WorkRun(Run());
    }

    /// <summary>The current phase.</summary>
    public CalibrationPhase Phase { get; private set; } = CalibrationPhase.Settling;

    /// <summary>The result; null before the end and after a failure.</summary>
    public CalibrationResult? Result { get; private set; }

    /// <summary>Why there is no result; null if there was no failure.</summary>
    public CaptureFault? Failure { get; private set; }

    /// <summary>The message of <see cref="Failure"/>.</summary>
    public string? Fault => Failure?.Message;

    /// <summary>Does the work of one tick. After the end it does nothing.</summary>
    public CalibrationPhase Step()
    {
        if (Phase != CalibrationPhase.Settling)
        {
            return Phase;
        }

        try
        {
            if (!_run.Advance())
            {
                End(CalibrationPhase.Done);
            }
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Failure = exception is CalibrationException calibration ? calibration.Fault : Stopped(exception);
            End(CalibrationPhase.Failed);
        }

        return Phase;
    }

    /// <summary>Resumes the game and removes the markers; a calibration that is not over has no result.</summary>
    public void Dispose()
    {
        if (Phase == CalibrationPhase.Settling)
        {
            Failure = new CaptureFault(FaultCode.CalibrationFailed, "The calibration was stopped.");
            End(CalibrationPhase.Failed);
        }
    }

    private static CaptureFault Stopped(Exception exception) => new(FaultCode.Failed, $"The calibration stopped: {exception.Message}");

    private IEnumerable<WorkStep> Run()
    {
        _game.Pause.Freeze();
        yield return WorkStep.Do(_survey.Take(CoarseColumns, CoarseRows, Lens.Ideal));

        ThrowIfLate();
        yield return WorkStep.Do(_survey.Identify(CoarseColumns, CoarseRows, Lens.Ideal));

        IReadOnlyList<Sighting> coarse = _survey.Sightings;
        int shown = _survey.Shown;
        LensFit fit = Fit(coarse, shown);
        yield return WorkStep.Do(_survey.Take(FineColumns, FineRows, fit.Lens));

        ThrowIfLate();
        shown += _survey.Shown;
        IReadOnlyList<Sighting> fitted = [.. coarse, .. _survey.Sightings];
        fit = Fit(fitted, shown);
        yield return WorkStep.Do(_survey.Take(CheckColumns, CheckRows, fit.Lens));

        ThrowIfLate();
        ReprojectionError validation = CalibrationJudge.Validate(
            fit,
            _survey.CameraWith(fit.Lens),
            fitted,
            _survey.Sightings,
            _survey.Shown,
            _options
        );
        Result = new CalibrationResult(fit.Lens, fit.ErrorWithout, fit.Error, validation, fit.UncertaintyPixels, shown, fit.OutlierCount);
    }

    private void ThrowIfLate()
    {
        if (_survey.ExcessiveLagTicks is { } lag)
        {
            throw new CalibrationException(PictureLag.Refusal(Counted.Of(lag, "tick"), "calibration", _options.MaxPictureLagTicks));
        }
    }

    private LensFit Fit(IReadOnlyList<Sighting> sightings, int shown)
    {
        LensFit fit = LensFitter.Fit(_survey.CameraWith(Lens.Ideal), sightings);
        return fit.Outcome == LensFitOutcome.Fitted
            ? fit
            : throw new CalibrationException(
                $"The lens cannot be determined from {sightings.Count} of {shown} markers: {CauseOf(sightings)} Calibrate again."
            );
    }

    private string CauseOf(IReadOnlyList<Sighting> sightings) =>
        _survey.UnknownSpots > sightings.Count
            ? "too much else changes in the picture. Choose clear weather and a place where nothing moves."
        : sightings.Count >= LensFitter.MinSightings ? "they disagree. Check that no other mod moves the camera."
        : "something hides them or the lens shows them outside the image. Give the camera a free view.";

    private void End(CalibrationPhase phase)
    {
        Phase = phase;
        foreach (Action release in new Action[] { _run.Dispose, _markers.Clear, _game.Pause.Unfreeze })
        {
            try
            {
                release();
            }
#pragma warning disable CA1031 // The rest must be released too; the first fault is reported.
            catch (Exception exception)
#pragma warning restore CA1031
            {
                Failure ??= Stopped(exception);
                Phase = CalibrationPhase.Failed;
            }
        }
    }
}
