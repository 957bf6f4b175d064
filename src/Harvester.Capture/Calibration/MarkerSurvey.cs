using System.Collections.Generic;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Imaging;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Calibration;

/// <summary>
/// Shows a grid of markers in a frozen world and finds where they are seen: a picture without them, one with them, both after
/// everything has stood still for longer than a picture may be late. Runs over many ticks; each step of the iteration ends one.
/// </summary>
internal sealed class MarkerSurvey(CalibrationOptions options, GamePorts game, IMarkers markers)
{
    private const double StillToleranceMetres = 0.0005;
    private const int GrabAttempts = 20;
    private readonly SceneReader _reader = new(game.World, options.StillRangeMetres);
    private readonly SceneComparison _comparison = new(StillToleranceMetres);
    private readonly PixelBuffer _without = new(options.Image);
    private readonly PixelBuffer _with = new(options.Image);

    /// <summary>The camera without a lens, as it stood in the last survey.</summary>
    public CameraIntrinsics? Camera { get; private set; }

    /// <summary>The markers that were seen in the last survey.</summary>
    public IReadOnlyList<Sighting> Sightings { get; private set; } = [];

    /// <summary>Markers shown in the last survey.</summary>
    public int Shown { get; private set; }

    /// <summary>Takes a survey; the world must be frozen, and stays so.</summary>
    /// <param name="columns">Markers in a row.</param>
    /// <param name="rows">Rows.</param>
    /// <param name="lens">The lens as it is known.</param>
    /// <exception cref="CalibrationException">Nothing stands still, or no picture can be grabbed.</exception>
    public IEnumerable<CalibrationPhase> Take(int columns, int rows, Lens lens)
    {
        Sightings = [];
        markers.Clear();
        foreach (CalibrationPhase phase in Picture(_without))
        {
            yield return phase;
        }

        SceneSnapshot before = _reader.Read();
        Camera = IntrinsicsOf(before.Camera, Lens.Ideal);
        var camera = new Camera(before.Camera.Pose, IntrinsicsOf(before.Camera, lens));
        MarkerPlan plan = MarkerPlan.Across(camera, columns, rows, options.MarkerRadiusPixels, options.MarkerDepths);
        Shown = plan.Markers.Count;
        try
        {
            markers.Show(plan.Markers);
            foreach (CalibrationPhase phase in Picture(_with))
            {
                yield return phase;
            }
        }
        finally
        {
            markers.Clear();
        }

        if (_comparison.FirstDifference(before, _reader.Read()) is { } difference)
        {
            throw new CalibrationException($"The world moved while the markers were shown ({difference}): stop the car and calibrate again.");
        }

        Sightings = MarkerMatcher.Match(plan, camera.Pose, MarkerDetector.Find(_without, _with, options.MarkerRadiusPixels));
    }

    private IEnumerable<CalibrationPhase> Picture(PixelBuffer target)
    {
        string? refusal = null;
        for (int attempt = 0; attempt < GrabAttempts; attempt++)
        {
            // What is shown from this tick on is in the state of the next one.
            yield return CalibrationPhase.Settling;
            var gate = new StillnessGate(_comparison);
            gate.Observe(_reader.Read());
            for (int ticks = 0; gate.StillTicks < options.MaxPictureLagTicks; ticks++)
            {
                if (ticks == options.MaxSettleTicks)
                {
                    throw new CalibrationException("The world does not come to stand still: stop the car and calibrate again.");
                }

                yield return CalibrationPhase.Settling;
                gate.Observe(_reader.Read());
            }

            refusal = game.Screen.Grab(target).Refusal;
            if (refusal is null)
            {
                yield break;
            }
        }

        throw new CalibrationException($"No picture of the game can be grabbed ({refusal}).");
    }

    private CameraIntrinsics IntrinsicsOf(CameraState camera, Lens lens) =>
        new(camera.VerticalFovDegrees, options.Image, camera.WindowAspect, camera.NearClip, lens);
}
