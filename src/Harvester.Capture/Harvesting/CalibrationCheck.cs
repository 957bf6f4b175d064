using Harvester.Capture.Calibration;
using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Checks the camera model of a harvest by a few markers before anything is recorded. A game that draws no markers is not checked. If no
/// marker is visible, however long the check waits, the game may not draw them after all: the harvest then continues with a warning, and
/// the session records that the model was not checked. Markers also show the picture lag: if they appear later than the options allow, the
/// harvest does not start.
/// </summary>
internal sealed class CalibrationCheck(HarvestOptions options, GamePorts game)
{
    private const int Columns = 5;
    private const int Rows = 4;

    // One marker in ten may be mistaken for something else; the four in the corners, where a wrong lens shows first, are more than that.
    private const double JudgedFraction = 0.9;

    // Markers as large as those of a calibration in an image of 600 rows, and smaller in smaller images, so that they fit into narrow ones
    // too; below 1.5 px they are hardly visible.
    private const double SidesPerRadius = 100;
    private const double MinRadiusPixels = 1.5;

    /// <summary>The error of the camera model, measured here or earlier, pixels; null if it was not measured.</summary>
    public double? ErrorPixels { get; private set; } = options.KnownCalibrationErrorPixels;

    /// <summary>Why the model was not checked; null if it was, or needs no check.</summary>
    public CaptureFault? Warning { get; private set; }

    /// <summary>Runs the check over several ticks; the game is frozen meanwhile.</summary>
    /// <exception cref="HarvestFaultException">The error of the model or the picture lag is larger than the options allow, or too few
    /// markers are visible.</exception>
    public IEnumerable<WorkStep> Run()
    {
        if (options.MaxCalibrationErrorPixels is not { } allowed || game.Markers is not { } markers)
        {
            yield break;
        }

        var settings = new CalibrationOptions
        {
            Image = options.Image,
            MaxPictureLagTicks = options.MaxPictureLagTicks,
            MarkerRadiusPixels = Math.Max(MinRadiusPixels, Math.Min(options.Image.Width, options.Image.Height) / SidesPerRadius),
        };
        var survey = new MarkerSurvey(settings, game, markers);
        game.Pause.Freeze();
        try
        {
            yield return WorkStep.Do(survey.Take(Columns, Rows, options.Lens));
        }
        finally
        {
            game.Pause.Unfreeze();
        }

        if (survey.ExcessiveLagTicks is { } lag)
        {
            throw new HarvestFaultException(PictureLag.Refusal(Counted.Of(lag, "tick"), "harvest", options.MaxPictureLagTicks));
        }

        Judge(survey.CameraWith(options.Lens), survey.Sightings, allowed);
    }

    private void Judge(CameraIntrinsics camera, IReadOnlyList<Sighting> sightings, double allowed)
    {
        if (sightings.Count == 0)
        {
            Warning = new CaptureFault(
                FaultCode.CameraUnchecked,
                $"The camera model was not checked: none of {Columns * Rows} markers was visible in {PictureLag.MaxTicks} ticks. "
                    + "Check that the boxes align with the objects."
            );
            return;
        }

        if (2 * sightings.Count < Columns * Rows)
        {
            throw new HarvestFaultException(
                new CaptureFault(
                    FaultCode.MarkersHidden,
                    $"The camera model cannot be checked: too few markers are visible, {sightings.Count} of {Columns * Rows}. "
                        + "Give the camera a free view, or a smaller field of view."
                )
            );
        }

        double[] errors = [.. sightings.Select(sighting => ReprojectionError.Of(camera, [sighting]).MaxPixels).OrderBy(error => error)];
        double error = errors[(int)Math.Ceiling(JudgedFraction * errors.Length) - 1];
        if (error > allowed)
        {
            throw new HarvestFaultException(
                new CaptureFault(
                    FaultCode.CameraModelOff,
                    FormattableString.Invariant($"The camera model is off by {error:0.0} px, more than the {allowed:0.0} px allowed. ")
                        + "Calibrate the camera first."
                )
            );
        }

        ErrorPixels = error;
    }
}
