using Harvester.Capture.Harvesting;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenarios;

namespace Harvester.Play.Plans;

/// <summary>
/// One attempt at a trial in the game, tick by tick: board a vehicle, load the place, set the sky and let the picture settle, drive and
/// take frames. Whatever goes wrong ends the attempt with a reason; what can be put right for the next one is.
/// </summary>
public sealed class TrialRun
{
    /// <summary>Longest wait for the player to be alive, in control and in a vehicle, milliseconds.</summary>
    public const double MaxBoardingMilliseconds = 120_000;

    /// <summary>Longest wait for a place to load, milliseconds.</summary>
    public const double MaxLoadingMilliseconds = 30_000;

    /// <summary>Shortest wait after the sky was set, milliseconds.</summary>
    public const double MinSettlingMilliseconds = 3_000;

    /// <summary>After so long, frames are taken even if the picture has not settled, milliseconds.</summary>
    public const double MaxSettlingMilliseconds = 15_000;

    /// <summary>Farther from its path the car is lost, metres.</summary>
    public const double MaxOffPathMetres = 15;

    private const double SightMetres = 60;
    private const double AboveGroundMetres = 1;
    private const double SearchGroundFromMetres = 1_000;
    private readonly TrialSurroundings _world;
    private readonly Plan _plan;
    private readonly Trial _trial;
    private readonly string _folder;
    private readonly HarvestOptions _options;
    private readonly PathFollower? _follower;
    private readonly TrialStaging? _staging;
    private MishapWatch _watch = new();
    private double _phaseBegan;
    private Vector3D _start;
    private Vector3D? _last;
    private double _metres;
    private string? _failure;
    private bool _hasFrames;

    /// <summary>Begins an attempt.</summary>
    /// <param name="world">What it uses.</param>
    /// <param name="plan">The plan.</param>
    /// <param name="trial">The trial.</param>
    /// <param name="folder">The folder of its session, which must not exist.</param>
    /// <param name="rig">The rig of the trial's camera; null for a single camera.</param>
    /// <param name="scenario">The scenario of the trial, and the seed of the attempt; null without one.</param>
    /// <exception cref="ArgumentException">The place of the trial has no position.</exception>
    public TrialRun(
        TrialSurroundings world,
        Plan plan,
        Trial trial,
        string folder,
        Rig? rig,
        (ScenarioTemplate Template, int Seed)? scenario = null
    )
    {
        _world = world ?? throw new ArgumentNullException(nameof(world));
        _plan = plan ?? throw new ArgumentNullException(nameof(plan));
        _trial = trial ?? throw new ArgumentNullException(nameof(trial));
        _folder = folder;
        _options = TrialOptions.Of(world.Options, plan, trial, rig);
        Vector2D start =
            trial.Place.Start ?? throw new ArgumentException("The place of a trial is chosen before it begins.", nameof(trial));
        _start = new Vector3D(start.X, start.Y, 0);
        _follower = trial.Place.Path.Count > 0 ? new PathFollower(trial.Place.Path, plan.SpeedMetresPerSecond) : null;
        _staging = scenario is { } staged
            ? new TrialStaging(world.Stage, world.World, staged.Template, staged.Seed, start, trial.Place.HeadingDegrees)
            : null;
        _phaseBegan = world.Clock.Milliseconds;
    }

    /// <summary>What it is doing.</summary>
    public TrialPhase Phase { get; private set; }

    /// <summary>How it ended; null while it runs.</summary>
    public TrialEnding? Ending { get; private set; }

    private double InPhaseMilliseconds => _world.Clock.Milliseconds - _phaseBegan;

    private int Vehicle => _world.Car.Vehicle;

    /// <summary>Does one tick's work.</summary>
    public void Tick()
    {
        switch (Phase)
        {
            case TrialPhase.Boarding:
                Board();
                break;
            case TrialPhase.Loading:
                Load();
                break;
            case TrialPhase.Settling:
                Settle();
                break;
            case TrialPhase.Driving:
                Drive();
                break;
            case TrialPhase.Writing:
                if (!_world.Harvest.IsBusy)
                {
                    bool isSpaceLow = _hasFrames && _world.Harvest is { Fault: not null, IsSpaceLow: true };
                    string? failure = isSpaceLow ? _world.Harvest.Fault : _failure ?? _world.Harvest.Fault;
                    failure ??= _world.Harvest.Captured > 0 ? null : "The harvest took no frame.";
                    Ending = new TrialEnding(_hasFrames ? _world.Harvest.Captured : 0, failure, isSpaceLow);
                    Phase = TrialPhase.Over;
                }

                break;
        }
    }

    /// <summary>Ends it early and gives the game back what it had. Calling it again has no effect.</summary>
    /// <param name="reason">Why it ends.</param>
    public void Stop(string reason)
    {
        if (Phase is not (TrialPhase.Writing or TrialPhase.Over))
        {
            _failure = reason;
            Leave();
        }
    }

    private void Board()
    {
        GameSituation now = _world.Game.Read(Vehicle);
        Correct(now);
        if (now is { IsDead: false, IsInCutScene: false, IsSwitching: false } && _world.Car.Board())
        {
            _world.Grip.Protect(Vehicle);
            _world.Grip.BeginLoading(_start);
            Enter(TrialPhase.Loading);
        }
        else if (InPhaseMilliseconds > MaxBoardingMilliseconds)
        {
            Stop(
                now.IsDead ? MishapWatch.TextOf(Mishap.Dead)
                : now.IsInCutScene ? MishapWatch.TextOf(Mishap.CutScene)
                : now.IsSwitching ? MishapWatch.TextOf(Mishap.PlayerSwitch)
                : "The player has no vehicle."
            );
        }
    }

    private void Load()
    {
        _world.Game.RequestCollision(_start);
        double? ground = _world.Game.GroundBelow(_start with { Z = SearchGroundFromMetres });

        // Held above the ground as far as it is known: without collision, the vehicle would fall through it.
        _world.Grip.Hold(Vehicle, _start with { Z = (ground ?? 0) + AboveGroundMetres });
        if (Mishappened() || !HasPlace())
        {
            return;
        }

        if (ground is { } height && _world.Game.IsSceneLoaded && _world.Game.HasCollision(Vehicle))
        {
            _start = _start with { Z = height + AboveGroundMetres };
            _world.Grip.EndLoading();
            _world.Controls.Place(Vehicle, _start, Heading());
            _world.Grip.KeepWeather(_trial.Weather);
            _world.Controls.SetTimeOfDay(_trial.Hour);
            _world.Settling.Begin();
            Enter(TrialPhase.Settling);
            _staging?.Place();
        }
        else if (InPhaseMilliseconds > MaxLoadingMilliseconds)
        {
            Stop(FormattableString.Invariant($"The place did not load within {MaxLoadingMilliseconds / 1000} s."));
        }
    }

    private void Settle()
    {
        SetDensities();
        if (Mishappened() || IsUnstaged())
        {
            return;
        }

        bool isSettled = _world.Settling.Look();
        if (
            InPhaseMilliseconds < MinSettlingMilliseconds
            || (!(isSettled && _staging is null or { IsReady: true }) && InPhaseMilliseconds < MaxSettlingMilliseconds)
        )
        {
            return;
        }

        if (_staging is { IsReady: false })
        {
            Stop("The game did not make the actors of the scenario in time.");
            return;
        }

        if (!isSettled)
        {
            _world.Log($"{_trial.Id}: the picture has not settled; frames are taken all the same.");
        }

        _world.Controls.SetTimeOfDay(_trial.Hour);
        if (!_world.Harvest.Begin(_folder, _options, _trial.Camera.VerticalFovDegrees, _staging?.Kept))
        {
            Stop("The harvest did not begin; the message before this one says why.");
            return;
        }

        _hasFrames = true;
        _watch = new MishapWatch();
        Enter(TrialPhase.Driving);
        if (_staging is { } staging)
        {
            staging.Begin();
        }
        else if (_follower is null)
        {
            _world.Grip.DriveAlongRoads(Vehicle, _plan.SpeedMetresPerSecond);
        }
    }

    private void Drive()
    {
        SetDensities();
        if (Mishappened() || IsUnstaged())
        {
            return;
        }

        _staging?.Tick();
        if (
            _staging is { Outcome: not null }
            || (_follower?.IsAtEnd ?? false)
            || _metres >= _trial.Place.Metres
            || _world.Harvest.Captured >= _options.MaxFrames
        )
        {
            Leave();
            return;
        }

        if (!_world.Harvest.IsOn)
        {
            Stop(_world.Harvest.Fault ?? FormattableString.Invariant($"The harvest ended after {_world.Harvest.Captured} frames."));
            return;
        }

        if (_follower is { } follower && _world.World.ReadEgo() is { Handle: not 0 } ego)
        {
            _world.Driven.Drive(follower.Drive(ego, _world.World.ReadEntities(ego.Pose.Position, SightMetres)));
            if (follower.OffMetres > MaxOffPathMetres)
            {
                Stop(MishapWatch.TextOf(Mishap.OffPath));
            }
        }
    }

    private bool Mishappened()
    {
        GameSituation now = _world.Game.Read(Vehicle);
        if (Phase == TrialPhase.Driving)
        {
            _metres += _last is { } last ? (now.Position - last).Length : 0;
            _last = now.Position;
        }

        // A place that is not loaded has neither ground nor water.
        GameSituation judged = Phase == TrialPhase.Loading ? now with { IsInWater = false, IsUpsideDown = false } : now;
        if (_watch.Check(judged, _world.World.TimeSeconds) is not { } mishap)
        {
            return false;
        }

        Correct(now);
        Stop(MishapWatch.TextOf(mishap));
        return true;
    }

    /// <summary>Puts right what can be. The vehicle is placed upright on dry land at the beginning of the next attempt.</summary>
    private void Correct(GameSituation now)
    {
        if (now.WantedLevel > 0)
        {
            _world.Game.ClearWanted();
        }

        if (now.IsInCutScene)
        {
            _world.Game.EndCutScene();
        }
    }

    private double Heading()
    {
        if (_staging is { } staging)
        {
            return staging.HeadingDegrees;
        }

        if (_follower is { } follower)
        {
            return follower.StartHeadingDegrees;
        }

        if (_trial.Place.HeadingDegrees is { } given)
        {
            return given;
        }

        return _world.Roads.ClosestRoad(_start) is { } road ? LaneDirection.HeadingAt(road, _start) : 0;
    }

    /// <summary>Whether the place of a scenario is known; the vehicle is held at the place of the trial until then.</summary>
    private bool HasPlace()
    {
        if (_staging is not { } staging)
        {
            return true;
        }

        if (staging.Start is not null)
        {
            return true;
        }

        staging.FindPlace();
        if (staging.Start is { } start)
        {
            _start = _start with { X = start.X, Y = start.Y };
        }
        else if (!IsUnstaged() && InPhaseMilliseconds > MaxLoadingMilliseconds)
        {
            Stop("The roads around the place are not known, which the scenario needs: give a road file under [Roads].");
        }

        return false;
    }

    /// <summary>Ends the attempt if its scenario cannot happen.</summary>
    private bool IsUnstaged()
    {
        if (_staging?.Problem is not { } problem)
        {
            return false;
        }

        Stop(problem);
        return true;
    }

    private void SetDensities() => _world.Game.SetDensities(_plan.Traffic, _plan.Pedestrians, _plan.Parked);

    private void Enter(TrialPhase phase) => (Phase, _phaseBegan) = (phase, _world.Clock.Milliseconds);

    private void Leave()
    {
        // First, so that an exception of the game does not repeat all this.
        Enter(TrialPhase.Writing);
        try
        {
            _world.Harvest.End();
            _world.Grip.GiveBack();
        }
        finally
        {
            _staging?.End();
        }
    }
}
