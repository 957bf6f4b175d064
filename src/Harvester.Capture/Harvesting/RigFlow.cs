using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Imaging;
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
        _scene = new FrozenScene(options, reader, budget, counters, calls);
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
    }

    public IReadOnlyList<TakenFrame> Taken { get; private set; } = [];

    public bool IsPassed { get; private set; }

    public double? TakenSeconds { get; private set; }

    /// <summary>Whether the next moment is to be taken, as in <see cref="FrozenFlow"/>.</summary>
    public required Func<bool> TakesNext { get; init; }

    public IEnumerable<HarvestPhase> TakeFrame()
    {
        Taken = [];
        IsPassed = false;
        TakenSeconds = null;
        bool isOurs = TakesNext();
        var taken = new List<TakenFrame>();
        _game.Pause.Freeze();
        try
        {
            foreach (HarvestPhase phase in _scene.Settle())
            {
                yield return phase;
            }

            if (_scene.Settled is not { } moment)
            {
                yield break;
            }

            foreach (LidarScanner lidar in _lidars)
            {
                lidar.AssignIds(moment);
            }

            foreach (ViewCapture view in _views)
            {
                foreach (HarvestPhase phase in Take(view, moment, isOurs ? taken : null))
                {
                    yield return phase;
                }

                if (view.Refusal is { } refusal)
                {
                    _counters.Discard(refusal);
                    yield break;
                }
            }

            foreach (HarvestPhase phase in isOurs ? Measure(moment, [.. taken.Select(static view => view.Draft)]) : [])
            {
                yield return phase;
            }

            foreach (HarvestPhase phase in _scene.Read(HarvestPhase.Labelling))
            {
                yield return phase;
            }

            if (_scene.Comparison.FirstDifference(moment with { Camera = _scene.Latest!.Camera }, _scene.Latest) is { } difference)
            {
                _counters.Discard(difference);
                yield break;
            }

            IsPassed = !isOurs;
            TakenSeconds = moment.TimeSeconds;
            Taken = [.. taken];
            taken.Clear();
        }
        finally
        {
            taken.ForEach(static frame => frame.Picture.Dispose());
            _game.RigCamera!.Show(_rig.Cameras[0], _views[0].Mount);
            _game.Pause.Unfreeze();
            _calls.Charge(HarvestPhase.Labelling);
        }
    }

    /// <summary>Takes one view; it sets the view's refusal if the picture cannot be used.</summary>
    private IEnumerable<HarvestPhase> Take(ViewCapture view, SceneSnapshot moment, List<TakenFrame>? taken)
    {
        view.Refusal = null;
        foreach (HarvestPhase phase in Show(view, moment.Ego.Pose))
        {
            yield return phase;
        }

        SceneSnapshot snapshot = SeenFrom(_game.World.ReadCamera(), moment);
        if (taken is null)
        {
            view.Labeller.Pass(snapshot);
            yield break;
        }

        GrabbedPicture picture = GrabbedPicture.Of(_game.Screen, view.Pool);
        if (picture.Refusal is { } refusal)
        {
            view.Refusal = refusal;
            picture.Dispose();
            yield break;
        }

        FrameDraft? draft = null;
        try
        {
            _budget.BeginSteps();
            foreach (FrameDraft? slice in view.Labeller.Label(snapshot, static () => true))
            {
                draft = slice;
                if (slice is null && _budget.IsSpent)
                {
                    yield return HarvestPhase.Labelling;
                }
            }

            // A camera that moved while its view was labelled shows another picture than the labels say.
            view.Refusal = IsAt(view, moment.Ego.Pose) ? null : "cameraMoved";
        }
        finally
        {
            if (draft is null || view.Refusal is not null)
            {
                picture.Dispose();
            }
        }

        if (view.Refusal is null)
        {
            draft!.View = view.View;
            taken.Add(new TakenFrame(draft, picture));
        }
    }

    /// <summary>Moves the camera to a view, and waits until it has stood there for as long as a picture may lag.</summary>
    /// <exception cref="HarvestFaultException">The camera does not come to its place.</exception>
    private IEnumerable<HarvestPhase> Show(ViewCapture view, Pose ego)
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

            yield return HarvestPhase.Settling;
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

    private IEnumerable<HarvestPhase> Measure(SceneSnapshot moment, IReadOnlyList<FrameDraft> views)
    {
        var sweeps = new List<LidarSweep>();
        _budget.BeginSteps();
        foreach (LidarScanner lidar in _lidars)
        {
            foreach (LidarSweep? sweep in lidar.Scan(moment))
            {
                if (sweep is not null)
                {
                    sweeps.Add(sweep);
                    foreach (FrameDraft view in views)
                    {
                        SweptDepth.Add(view, lidar.ExactPointsOf(sweep, moment));
                    }
                }
                else if (_budget.IsSpent)
                {
                    yield return HarvestPhase.Labelling;
                }
            }
        }

        if (sweeps.Count > 0)
        {
            views[0].Add(new SweptPoints(sweeps));
        }
    }
}
