using Harvester.Capture.Ports;
using Harvester.Driving.Scenarios;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Sessions.Scenarios;

namespace Harvester.Play.Plans;

/// <summary>
/// The scenario of a trial: finds its place on the lanes where the trial begins, makes its actors while the picture settles, gives them
/// orders while frames are taken, and takes them away.
/// </summary>
public sealed class TrialStaging
{
    private readonly TrialStage _stage;
    private readonly IWorld _world;
    private readonly Scenario _scenario;
    private readonly int _seed;
    private readonly Vector2D _near;
    private readonly double? _heading;
    private Task<(BoundScenario? Bound, string? Reason)>? _binding;
    private BoundScenario? _bound;
    private ScenarioPlayer? _player;
    private (int Log, int Touched) _noted;
    private volatile string _json = "";

    /// <summary>Draws the scenario of a trial.</summary>
    /// <param name="stage">The actors and the roads.</param>
    /// <param name="world">The game's world.</param>
    /// <param name="template">The scenario.</param>
    /// <param name="seed">The seed of the attempt.</param>
    /// <param name="near">Where the trial begins, metres, world.</param>
    /// <param name="headingDegrees">Direction of the ego there, degrees counter-clockwise from north; null for that of the lane.</param>
    public TrialStaging(TrialStage stage, IWorld world, ScenarioTemplate template, int seed, Vector2D near, double? headingDegrees)
    {
        _stage = stage ?? throw new ArgumentNullException(nameof(stage));
        _world = world ?? throw new ArgumentNullException(nameof(world));
        _scenario = (template ?? throw new ArgumentNullException(nameof(template))).Drawn(seed);
        (_seed, _near, _heading) = (seed, near, headingDegrees);
    }

    /// <summary>Why it cannot happen, as a sentence; null while nothing speaks against it.</summary>
    public string? Problem { get; private set; }

    /// <summary>Where the ego begins, on the road, metres, world; null while that is not known.</summary>
    public Vector3D? Start => _bound?.Ego;

    /// <summary>Where the ego looks at the beginning, degrees counter-clockwise from north.</summary>
    public double HeadingDegrees { get; private set; }

    /// <summary>Whether the actors are in the world.</summary>
    public bool IsReady => _player is not null && _stage.Stage.AreAllThere;

    /// <summary>Why it is over; null while it is not.</summary>
    public ScenarioOutcome? Outcome => _player?.Outcome;

    /// <summary>What the session of the trial keeps.</summary>
    public KeptScenario Kept =>
        new(
            [
                new("scenario", _scenario.Name),
                new("scenarioKind", _scenario.Kind),
                new("scenarioSeed", FormattableString.Invariant($"{_seed}")),
            ],
            () => _json
        );

    /// <summary>
    /// Looks for the place of the scenario. It is called in every tick until the place is known or <see cref="Problem"/> says why there is
    /// none.
    /// </summary>
    public void FindPlace()
    {
        if (_bound is not null || Problem is not null)
        {
            return;
        }

        if (_binding is not { } binding)
        {
            if (_stage.Roads(new Vector3D(_near.X, _near.Y, 0)) is { } roads)
            {
                _binding = Task.Run(() => Bind(roads));
            }

            return;
        }

        if (Background.IsDone(nameof(TrialStaging), () => binding.IsCompleted))
        {
            (_bound, string? reason) = binding.GetAwaiter().GetResult();
            Problem = reason is null ? null : $"The scenario '{_scenario.Name}' cannot happen here. {reason}";
            HeadingDegrees = _bound is { } bound ? Angles.HeadingDegrees(bound.Place.Track.DirectionAt(0)) : 0;
        }
    }

    /// <summary>Asks for the actors, which appear over the coming ticks.</summary>
    /// <exception cref="InvalidOperationException">Its place is not known.</exception>
    public void Place()
    {
        BoundScenario bound = _bound ?? throw new InvalidOperationException("The place of the scenario is not known.");
        _player = new ScenarioPlayer(bound, _stage.Stage, _world);
        Problem = _player.Place();
        Problem = Problem is { } reason ? $"The scenario '{_scenario.Name}' cannot happen here. {reason}" : null;
    }

    /// <summary>Sends the ego and the actors on their ways, at their speeds.</summary>
    /// <exception cref="InvalidOperationException">The actors were not asked for.</exception>
    public void Begin()
    {
        ScenarioPlayer player = Player;
        if (player.Handles.FirstOrDefault(actor => _stage.Stage.StateOf(actor.Value) is null) is { Key: { } missing })
        {
            Problem = $"The game did not make the actor '{missing}' of the scenario.";
            return;
        }

        player.Start();
        _stage.Stage.Launch(0, _scenario.Ego.Speed);
        foreach (BoundActor actor in _bound!.Actors.Where(static actor => actor.Spawn.Speed > 0))
        {
            _stage.Stage.Launch(player.Handles[actor.Actor.Id], actor.Spawn.Speed);
        }

        Note();
    }

    /// <summary>Looks at the world and gives orders for the coming tick.</summary>
    public void Tick()
    {
        Player.Tick();
        if (Outcome is not null || _noted != (Player.Log.Count, Player.Touched.Count))
        {
            Note();
        }
    }

    /// <summary>Takes the actors out of the world. Calling it again has no effect.</summary>
    public void End() => _stage.Stage.Clear();

    private ScenarioPlayer Player => _player ?? throw new InvalidOperationException("The actors of the scenario were not asked for.");

    private (BoundScenario? Bound, string? Reason) Bind(KnownRoads roads)
    {
        BoundScenario? bound = ScenarioBinder.BindNear(
            _scenario,
            _stage.LanesAround(roads, _near),
            _near,
            _heading,
            _seed,
            out string? reason
        );
        return (bound, reason);
    }

    /// <summary>Keeps the text of scenario.json, with the game's handles; the session's own thread reads it.</summary>
    private void Note()
    {
        ScenarioRecord record = Player.Record(_seed);
        _noted = (Player.Log.Count, Player.Touched.Count);
        _json = (
            record with
            {
                Handles = record.Handles.ToDictionary(actor => actor.Key, actor => _stage.Stage.EntityOf(actor.Value)),
            }
        ).ToJson();
    }
}
