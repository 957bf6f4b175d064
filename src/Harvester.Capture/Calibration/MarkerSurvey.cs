using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Calibration;

/// <summary>
/// Shows a grid of markers in a frozen world and finds where they appear: an image without them, one with them, both after everything has
/// stood still for longer than a picture may lag. If few are visible, it keeps looking up to the longest lag that is measured, to
/// distinguish markers that appear too late from markers that are not shown. Runs over many ticks; each step of the iteration ends one.
/// </summary>
internal sealed class MarkerSurvey(CalibrationOptions options, GamePorts game, IMarkers markers)
{
    // 0.1 px at the nearest marker's 0.9 m and a focal length of 900 px, and along the axes the same in radians.
    private const double StillToleranceMetres = 1e-4;
    private const double StillToleranceOfAxes = 1e-4;
    private const int GrabAttempts = 20;
    private PixelBuffer _without = new(options.Image);
    private PixelBuffer _with = new(options.Image);
    private CameraState? _camera;

    /// <summary>The markers that were visible in the last survey.</summary>
    public IReadOnlyList<Sighting> Sightings { get; private set; } = [];

    /// <summary>Number of markers shown in the last survey.</summary>
    public int Shown { get; private set; }

    /// <summary>
    /// Number of ticks by which the picture lags behind the state, if that is more than the options allow, as markers that appeared late
    /// show; otherwise null.
    /// </summary>
    public int? ExcessiveLagTicks { get; private set; }

    /// <summary>Number of spots of the last identification that are not a marker.</summary>
    public int UnknownSpots { get; private set; }

    /// <summary>Whether at least half of the markers were visible in time.</summary>
    public bool IsSeen => IsMost(Sightings);

    /// <summary>Takes a survey; the world must be frozen and stays frozen.</summary>
    /// <param name="columns">Markers per row.</param>
    /// <param name="rows">Rows.</param>
    /// <param name="lens">The lens as far as it is known.</param>
    /// <exception cref="CalibrationException">The world does not stand still, or no image can be grabbed.</exception>
    public IEnumerable<WorkStep> Take(int columns, int rows, Lens lens)
    {
        Sightings = [];
        ExcessiveLagTicks = null;
        markers.Clear();
        yield return WorkStep.Do(Picture(_without));

        CameraState state = game.World.ReadCamera();
        _camera = state;
        var camera = new Camera(state.Pose, CameraWith(lens));
        MarkerPlan plan = MarkerPlan.Across(camera, columns, rows, options.MarkerRadiusPixels, options.MarkerDepths);
        Shown = plan.Markers.Count;
        try
        {
            markers.Show(plan.Markers);
            long firstFrame = game.World.GameFrame + 1;
            yield return WorkStep.Do(Picture(_with));

            Sightings = MarkersIn(plan, camera.Pose);
            if (!IsSeen)
            {
                yield return WorkStep.Do(LateMarkers(plan, camera.Pose, firstFrame));
            }
        }
        finally
        {
            markers.Clear();
        }

        ThrowIfMoved(state);
    }

    /// <summary>
    /// Takes a survey that identifies markers by the images that show them, so that they may appear anywhere; the world must be frozen and
    /// stays frozen.
    /// </summary>
    /// <param name="columns">Markers per row.</param>
    /// <param name="rows">Rows.</param>
    /// <param name="lens">The lens as far as it is known.</param>
    /// <exception cref="CalibrationException">The world does not stand still, or no image can be grabbed.</exception>
    public IEnumerable<WorkStep> Identify(int columns, int rows, Lens lens)
    {
        Sightings = [];
        markers.Clear();
        yield return WorkStep.Do(Picture(_without));

        CameraState state = game.World.ReadCamera();
        _camera = state;
        var camera = new Camera(state.Pose, CameraWith(lens));
        MarkerPlan plan = MarkerPlan.Across(camera, columns, rows, options.MarkerRadiusPixels, options.MarkerDepths);
        Shown = plan.Markers.Count;
        var identification = new MarkerIdentification(options.MarkerRadiusPixels);
        try
        {
            for (int picture = 0; picture < MarkerCode.Pictures; picture++)
            {
                markers.Show([.. plan.Markers.Where((_, marker) => MarkerCode.IsShown(marker, picture))]);
                yield return WorkStep.Do(Picture(_with));

                identification.Add(picture, MarkerDetector.Find(_without, _with, options.MarkerRadiusPixels));
            }
        }
        finally
        {
            markers.Clear();
        }

        ThrowIfMoved(state);
        Sightings = identification.SightingsOf(plan, camera.Pose);
        UnknownSpots = identification.UnknownCount;
    }

    /// <summary>The camera of the last survey with a lens.</summary>
    public CameraIntrinsics CameraWith(Lens lens) =>
        new(_camera!.VerticalFovDegrees, options.Image, _camera.WindowAspect, _camera.NearClip, lens);

    private static bool Stands(CameraState a, CameraState b) =>
        (a.Pose.Position - b.Pose.Position).Length <= StillToleranceMetres
        && (a.Pose.Axes.Right - b.Pose.Axes.Right).Length <= StillToleranceOfAxes
        && (a.Pose.Axes.Forward - b.Pose.Axes.Forward).Length <= StillToleranceOfAxes
        && a with { Pose = b.Pose } == b;

    private void ThrowIfMoved(CameraState before)
    {
        if (!Stands(before, game.World.ReadCamera()))
        {
            throw new CalibrationException("The camera moved while the markers were shown. Stop the car and try again.");
        }
    }

    private bool IsMost(IReadOnlyList<Sighting> sightings) => 2 * sightings.Count >= Shown;

    private IReadOnlyList<Sighting> MarkersIn(MarkerPlan plan, Pose camera) =>
        MarkerMatcher.Match(plan, camera, MarkerDetector.Find(_without, _with, options.MarkerRadiusPixels));

    /// <summary>
    /// Watches, tick by tick, for markers that were not visible in time. All appear at once, so each image is compared with the one before:
    /// anything else that changed since the markers were shown, as in a picture that lags behind traffic, is in both.
    /// </summary>
    /// <param name="plan">The markers.</param>
    /// <param name="camera">The camera, which does not move.</param>
    /// <param name="firstFrame">The first game frame whose state has the markers.</param>
    private IEnumerable<WorkStep> LateMarkers(MarkerPlan plan, Pose camera, long firstFrame)
    {
        while (ExcessiveLagTicks is null && game.World.GameFrame < firstFrame + PictureLag.MaxTicks)
        {
            yield return WorkStep.Tick;
            (_without, _with) = (_with, _without);
            if (game.Screen.Grab(_with).Refusal is not null)
            {
                (_without, _with) = (_with, _without);
            }
            else if (IsMost(MarkersIn(plan, camera)))
            {
                ExcessiveLagTicks = (int)(game.World.GameFrame - firstFrame);
            }
        }
    }

    private IEnumerable<WorkStep> Picture(PixelBuffer target)
    {
        string? refusal = null;
        for (int attempt = 0; attempt < GrabAttempts; attempt++)
        {
            yield return WorkStep.Do(Standstill());

            refusal = game.Screen.Grab(target).Refusal;
            if (refusal is null)
            {
                yield break;
            }
        }

        throw new CalibrationException($"The picture of the game cannot be grabbed ({refusal}).");
    }

    /// <summary>Waits until the camera has stood still for as many game frames as the picture may be late.</summary>
    private IEnumerable<WorkStep> Standstill()
    {
        // What is shown from this tick on is part of the state of the next one.
        yield return WorkStep.Tick;
        CameraState first = game.World.ReadCamera();
        long since = game.World.GameFrame;
        for (int ticks = 0; game.World.GameFrame - since < options.MaxPictureLagTicks; ticks++)
        {
            if (ticks == options.MaxSettleTicks)
            {
                throw new CalibrationException("The camera does not stand still. Stop the car and try again.");
            }

            yield return WorkStep.Tick;
            CameraState now = game.World.ReadCamera();
            if (!Stands(first, now))
            {
                first = now;
                since = game.World.GameFrame;
            }
        }
    }
}
