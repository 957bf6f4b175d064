using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Takes all views of a moment of a frozen game: freeze, read until nothing moves; for each view move the camera, wait until it stands at
/// its place for as long as a picture may lag, grab and label; measure with the LiDARs; read again, unfreeze. All views are labelled from
/// the one scene that was read at the start. If a view fails, the whole moment is discarded.
/// </summary>
internal sealed class RigFlow : ICaptureFlow
{
    private readonly HarvestOptions _options;
    private readonly GamePorts _game;
    private readonly Rig _rig;
    private readonly ViewCapture[] _views;
    private readonly LidarScanner[] _lidars;
    private readonly RadarScanner[] _radars;
    private readonly FrozenScene _scene;
    private readonly TickBudget _budget;
    private readonly HarvestCounters _counters;
    private readonly PhaseCalls _calls;

    public RigFlow(
        HarvestOptions options,
        GamePorts game,
        SceneReader reader,
        Rig rig,
        Func<RigCamera, FrameLabeller> labellerOf,
        ObjectRegistry registry,
        TickBudget budget,
        HarvestCounters counters,
        PhaseCalls calls
    )
    {
        (_options, _game, _rig, _budget, _counters, _calls) = (options, game, rig, budget, counters, calls);
        _scene = new FrozenScene(options, game.World, reader, calls);
        _views =
        [
            .. rig.Cameras.Select(camera => new ViewCapture(
                new RigView(camera, rig.Cameras.Count),
                rig.OnVehicle(camera.Mount),
                labellerOf(camera),
                new PixelBufferPool(camera.Image)
            )),
        ];
        _lidars = [.. rig.Lidars.Select(lidar => new LidarScanner(lidar, rig.OnVehicle(lidar.Mount), options, game, registry))];
        _radars = [.. rig.Radars.Select(radar => new RadarScanner(radar, rig.OnVehicle(radar.Mount), options, game, registry))];
    }

    public IReadOnlyList<FrameDraft> Taken { get; private set; } = [];

    public bool IsPassed { get; private set; }

    public double? TakenSeconds { get; private set; }

    /// <summary>Says what is to be done with the views of the next moment, as in <see cref="FrozenFlow"/>.</summary>
    public required Func<FrameTurn> NextTurn { get; init; }

    public IEnumerable<WorkStep> TakeFrame()
    {
        Taken = [];
        IsPassed = false;
        TakenSeconds = null;
        FrameTurn turn = NextTurn();
        var taken = new List<FrameDraft>();
        _game.Pause.Freeze();
        try
        {
            yield return WorkStep.Do(_scene.Read(HarvestPhase.Settling, _options.MaxPictureLagTicks));

            if (_scene.Latest is not { } moment)
            {
                _counters.Discard("neverStill");
                yield break;
            }

            _counters.Settled(_scene.MovingTicks);

            foreach (LidarScanner lidar in _lidars)
            {
                lidar.AssignIds(moment);
            }

            foreach (RadarScanner radar in _radars)
            {
                radar.AssignIds(moment);
            }

            for (int index = 0; index < _views.Length; index++)
            {
                ViewCapture view = _views[index];
                yield return WorkStep.Do(Take(view, moment, turn.OfView(index), taken));

                if (view.Refusal is { } refusal)
                {
                    _counters.Discard(refusal);
                    yield break;
                }
            }

            if (turn.IsOurs)
            {
                yield return HarvestPhase.Labelling.Do(Measure(moment, taken));
            }

            yield return WorkStep.Do(_scene.Read(HarvestPhase.Labelling, stillTicks: 0));

            if (_scene.Comparison.FirstDifference(moment with { Camera = _scene.Latest!.Camera }, _scene.Latest) is { } difference)
            {
                _counters.Discard(difference);
                yield break;
            }

            IsPassed = !turn.IsOurs;
            TakenSeconds = moment.TimeSeconds;
            taken.ForEach(static frame => frame.IsKept = true);
            if (turn.IsOurs)
            {
                Taken = [.. taken];
                taken.Clear();
            }
        }
        finally
        {
            taken.ForEach(static frame => frame.Picture!.Dispose());
            _game.RigCamera!.Show(_rig.Cameras[0], _views[0].Mount);
            _game.Pause.Unfreeze();
            _calls.Charge(HarvestPhase.Labelling);
        }
    }

    /// <summary>Takes one view; it sets the view's refusal if the picture cannot be used.</summary>
    private IEnumerable<WorkStep> Take(ViewCapture view, SceneSnapshot moment, FrameTurn turn, List<FrameDraft> taken)
    {
        view.Refusal = null;
        yield return WorkStep.Do(Show(view, moment.Ego.Pose));

        SceneSnapshot seen = SeenFrom(_game.World.ReadCamera(), moment);
        Camera camera = view.Labeller.CameraOf(seen);
        var frame = new FrameDraft(seen, camera, view.Labeller.CandidatesOf(camera, seen)) { Number = turn.Number, Before = turn.Before };
        if (!turn.IsLabelled)
        {
            view.Labeller.Pass(frame);
            yield break;
        }

        var picture = new GrabbedPicture(_game.Screen, view.Pool);
        if (picture.Refusal is { } refusal)
        {
            view.Refusal = refusal;
            picture.Dispose();
            yield break;
        }

        bool isGood = false;
        try
        {
            _budget.BeginSteps();
            yield return HarvestPhase.Labelling.Do(view.Labeller.Label(frame, static () => true));

            // A camera that moved while its view was labelled shows another picture than the labels say.
            isGood = IsAt(view, moment.Ego.Pose);
            view.Refusal = isGood ? null : "cameraMoved";
        }
        finally
        {
            if (!isGood)
            {
                picture.Dispose();
            }
        }

        if (isGood)
        {
            (frame.View, frame.Picture) = (view.View, picture);
            taken.Add(frame);
        }
    }

    /// <summary>Moves the camera to a view, and waits until it has stood there for as long as a picture may lag.</summary>
    /// <exception cref="HarvestFaultException">The camera does not come to its place.</exception>
    private IEnumerable<WorkStep> Show(ViewCapture view, Pose ego)
    {
        _game.RigCamera!.Show(view.View.Camera, view.Mount);
        long stillSince = IsAt(view, ego) ? _game.World.GameFrame : -1;
        for (int ticks = 0; stillSince < 0 || _game.World.GameFrame - stillSince < _options.MaxPictureLagTicks; ticks++)
        {
            if (ticks > _options.MaxSettleTicks + _options.MaxPictureLagTicks)
            {
                throw new HarvestFaultException(
                    new CaptureFault(
                        FaultCode.ViewNotShown,
                        $"The camera does not come to its place for the view '{view.View.Camera.Name}' while the game is frozen. "
                            + "Freeze the game another way."
                    )
                );
            }

            yield return HarvestPhase.Settling.Tick();
            stillSince =
                !IsAt(view, ego) ? -1
                : stillSince < 0 ? _game.World.GameFrame
                : stillSince;
        }
    }

    /// <summary>Whether the camera that the game renders with is that of a view.</summary>
    private bool IsAt(ViewCapture view, Pose ego)
    {
        CameraState camera = _game.World.ReadCamera();
        return _scene.Comparison.IsSame(camera.Pose, ego.Compose(view.Mount))
            && Math.Abs(camera.VerticalFovDegrees - view.View.Camera.VerticalFovDegrees) <= ViewCapture.FovToleranceDegrees;
    }

    /// <summary>The moment as one of its cameras sees it: which entities are in range depends on the camera's position.</summary>
    private SceneSnapshot SeenFrom(CameraState camera, SceneSnapshot moment)
    {
        ILookup<bool, EntityState> byRange = moment
            .Entities.Where(entity => (entity.Pose.Position - camera.Pose.Position).Length < _options.ReadRangeMetres)
            .ToLookup(entity => _options.IsInRange(camera, entity));
        return moment with { Camera = camera, Entities = [.. byRange[true]], Distant = [.. byRange[false]] };
    }

    private IEnumerable<WorkStep> Measure(SceneSnapshot moment, List<FrameDraft> views)
    {
        var sweeps = new List<LidarSweep>();
        var swept = new WorkResult<LidarSweep>();
        _budget.BeginSteps();
        foreach (LidarScanner lidar in _lidars)
        {
            yield return WorkStep.Do(lidar.Scan(moment, swept));
            LidarSweep sweep = swept.Value!;
            sweeps.Add(sweep);
            foreach (FrameDraft view in views)
            {
                SweptDepth.Add(view, lidar.ExactPointsOf(sweep, moment));
            }
        }

        if (sweeps.Count > 0)
        {
            views[0].Add(new SweptPoints(sweeps));
        }

        yield return WorkStep.Do(MeasureByRadar(moment, views[0]));
    }

    private IEnumerable<WorkStep> MeasureByRadar(SceneSnapshot moment, FrameDraft first)
    {
        var scans = new List<RadarScan>();
        var scan = new WorkResult<RadarScan>();
        foreach (RadarScanner radar in _radars)
        {
            yield return WorkStep.Do(radar.Scan(moment, scan));
            scans.Add(scan.Value!);
        }

        if (scans.Count > 0)
        {
            first.Add(new RadarPart(scans));
        }
    }
}
