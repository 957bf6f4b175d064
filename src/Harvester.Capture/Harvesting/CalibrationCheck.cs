using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Calibration;
using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Holds the camera model of a harvest against a handful of markers before anything is recorded. Games that draw no markers are not
/// checked. Where not one marker is seen, however long is waited, the game may not draw them after all: then the harvest goes on with a
/// warning, for nothing is known against its model, and the session says that it was not checked. Markers also show how late the
/// picture is: when they are seen later than the options allow, the harvest does not start.
/// </summary>
internal sealed class CalibrationCheck(HarvestOptions options, GamePorts game)
{
    private const int Columns = 5;
    private const int Rows = 4;

    // One marker in ten may be mistaken for something else; the four in the corners, where a wrong lens shows first, are more than that.
    private const double JudgedFraction = 0.9;

    // Markers as large as a calibration's in an image of 600 rows, and smaller in smaller ones, so that they fit, narrow ones too; below
    // 1.5 pixels a picture hardly shows them.
    private const double SidesPerRadius = 100;
    private const double MinRadiusPixels = 1.5;

    /// <summary>By how much the model was off, here or when it was checked earlier, pixels; null when it was not checked.</summary>
    public double? ErrorPixels { get; private set; } = options.KnownCalibrationErrorPixels;

    /// <summary>Why the model was not checked though it should have been; null when all is well.</summary>
    public CaptureFault? Warning { get; private set; }

    /// <summary>Runs the check over some ticks; the game is frozen meanwhile.</summary>
    /// <exception cref="HarvestFaultException">The model is off, or the picture late, by more than the options allow, or too few markers
    /// are seen to tell.</exception>
    public IEnumerable<HarvestPhase> Run()
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
            foreach (CalibrationPhase phase in survey.Take(Columns, Rows, options.Lens))
            {
                yield return HarvestPhase.CheckingCalibration;
            }
        }
        finally
        {
            game.Pause.Unfreeze();
        }

        if (survey.ExcessiveLagTicks is { } lag)
        {
            throw new HarvestFaultException(
                PictureLag.Refusal(FormattableString.Invariant($"{lag} ticks"), "harvest", options.MaxPictureLagTicks));
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
                + "Check that the boxes align with the objects.");
            return;
        }

        if (2 * sightings.Count < Columns * Rows)
        {
            throw new HarvestFaultException(new CaptureFault(
                FaultCode.MarkersHidden,
                $"The camera model cannot be checked: only {sightings.Count} of {Columns * Rows} markers are visible. "
                + "Give the camera a free view, or a smaller field of view."));
        }

        double[] errors = [.. sightings.Select(sighting => ReprojectionError.Of(camera, [sighting]).MaxPixels).OrderBy(error => error)];
        double error = errors[(int)Math.Ceiling(JudgedFraction * errors.Length) - 1];
        if (error > allowed)
        {
            throw new HarvestFaultException(new CaptureFault(
                FaultCode.CameraModelOff,
                FormattableString.Invariant($"The camera model is off by {error:0.0} px, more than the {allowed:0.0} px allowed. Calibrate the camera first.")));
        }

        ErrorPixels = error;
    }
}
