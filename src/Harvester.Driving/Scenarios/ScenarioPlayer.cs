using Harvester.Capture.Ports;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Driving.Scenarios;

/// <summary>
/// Plays a scenario in a game: puts the actors into the world, looks at the ego and the actors in every tick, and gives orders when the
/// conditions of events hold. It decides nothing about what then happens.
/// </summary>
public sealed class ScenarioPlayer
{
    /// <summary>An actor is passed when it is so far behind the ego, metres.</summary>
    private const double PassedBy = 10;

    /// <summary>Time that is still played after the ego has touched an actor, seconds.</summary>
    private const double AfterCollision = 1;

    private readonly BoundScenario _bound;
    private readonly IStage _stage;
    private readonly IWorld _world;
    private readonly ActionOrders _orders;
    private readonly Dictionary<string, StagedActor> _actors = new(StringComparer.Ordinal);
    private readonly Dictionary<string, EventPhase> _phases = new(StringComparer.Ordinal);
    private readonly Dictionary<string, double> _since = new(StringComparer.Ordinal);
    private readonly List<ScenarioLogEntry> _log = [];
    private readonly bool _needsLight;
    private double _began;
    private readonly SortedSet<string> _touchedActors = new(StringComparer.Ordinal);
    private double? _touched;

    /// <summary>A scenario that has not begun.</summary>
    /// <param name="bound">The scenario at its place.</param>
    /// <param name="stage">Takes the orders.</param>
    /// <param name="world">The game's world.</param>
    public ScenarioPlayer(BoundScenario bound, IStage stage, IWorld world)
    {
        _bound = bound ?? throw new ArgumentNullException(nameof(bound));
        _stage = stage ?? throw new ArgumentNullException(nameof(stage));
        _world = world ?? throw new ArgumentNullException(nameof(world));
        _orders = new ActionOrders(bound, stage);
        _needsLight = bound.Scenario.Events.SelectMany(each => each.When).Any(condition => condition.Kind == ScenarioConditionKind.Light);
        foreach (ScenarioEvent each in bound.Scenario.Events)
        {
            _phases[each.Id] = EventPhase.Waiting;
        }
    }

    /// <summary>The state of the traffic light before the ego; unknown where the game does not tell.</summary>
    public Func<LightState> Light { get; init; } = static () => LightState.Unknown;

    /// <summary>Whether the ego's driver takes no notice of actors.</summary>
    public bool EgoIgnoresOthers { get; init; }

    /// <summary>What happened so far, in order.</summary>
    public IReadOnlyList<ScenarioLogEntry> Log => _log;

    /// <summary>The handles of the actors in the game, by id.</summary>
    public IReadOnlyDictionary<string, int> Handles => _actors.ToDictionary(each => each.Key, each => each.Value.Handle);

    /// <summary>Where the ego is along its way, metres from its start.</summary>
    public double EgoAt { get; private set; }

    /// <summary>Why it is over; null while it is not.</summary>
    public ScenarioOutcome? Outcome { get; private set; }

    /// <summary>The ids of actors that the ego has touched.</summary>
    public IReadOnlyCollection<string> Touched => _touchedActors;

    /// <summary>Puts the actors into the world and sends the ego on its way.</summary>
    /// <returns>Why that is impossible, as a sentence; null if it is done.</returns>
    public string? Begin()
    {
        DriveEgo();
        if (Place(isMoving: true) is { } reason)
        {
            return reason;
        }

        Go();
        return null;
    }

    /// <summary>
    /// Puts the actors into the world, where they wait for <see cref="Start"/>; for games in which they appear over ticks.
    /// </summary>
    /// <returns>Why that is impossible, as a sentence; null if it is done.</returns>
    public string? Place() => Place(isMoving: false);

    /// <summary>Sends the ego on its way, and the actors that <see cref="Place()"/> has put into the world.</summary>
    public void Start()
    {
        DriveEgo();
        foreach (StagedActor actor in _actors.Values)
        {
            actor.Observe(_stage.StateOf(actor.Handle));
        }

        Go();
    }

    private void DriveEgo()
    {
        _began = _world.TimeSeconds;
        _stage.DriveEgo(
            new StageOrder(_bound.Place.Track.Path(0, _bound.Place.Track.To), _bound.Scenario.Ego.Speed, 2)
            {
                IgnoresOthers = EgoIgnoresOthers,
            }
        );
    }

    private void Go()
    {
        foreach (StagedActor actor in _actors.Values)
        {
            _orders.Begin(actor);
        }
    }

    private string? Place(bool isMoving)
    {
        foreach (BoundActor bound in _bound.Actors)
        {
            StageSpawn spawn = _stage.Spawn(isMoving ? bound.Spawn : bound.Spawn with { Speed = 0 });
            if (spawn.Reason is { } reason)
            {
                Remove();
                return $"'{bound.Actor.Id}': {reason}";
            }

            var actor = new StagedActor(bound, spawn.Handle);
            _actors.Add(bound.Actor.Id, actor);
            actor.Observe(_stage.StateOf(spawn.Handle));
        }

        return null;
    }

    /// <summary>Looks at the world and gives orders for the coming tick.</summary>
    public void Tick()
    {
        if (Outcome is not null)
        {
            return;
        }

        EgoState ego = _world.ReadEgo();
        EgoAt = _bound.Place.Track.Locate(ego.Pose.Position, EgoAt).At;
        foreach (StagedActor actor in _actors.Values)
        {
            actor.Observe(_stage.StateOf(actor.Handle));
        }

        var view = new SceneView(_bound, _world.TimeSeconds - _began, ego, EgoAt, _needsLight ? Light() : LightState.Unknown);
        foreach (ScenarioEvent each in _bound.Scenario.Events)
        {
            Advance(each, view);
        }

        foreach (KeyValuePair<string, StagedActor> actor in _actors.Where(actor => view.IsTouching(actor.Value)))
        {
            _touchedActors.Add(actor.Key);
            _touched ??= view.Seconds;
        }

        Outcome = OutcomeOf(view);
    }

    /// <summary>What a session keeps of it.</summary>
    /// <param name="seed">The seed from which the parameters were drawn.</param>
    public ScenarioRecord Record(int seed) =>
        new(_bound.Scenario, seed, Handles, _log, Outcome is { } outcome ? JsonName.Of(outcome) : null, [.. Touched]);

    /// <summary>Takes the actors out of the world.</summary>
    public void Remove()
    {
        foreach (StagedActor actor in _actors.Values)
        {
            _stage.Remove(actor.Handle);
        }

        _actors.Clear();
    }

    private void Advance(ScenarioEvent each, SceneView view)
    {
        StagedActor actor = _actors[each.Actor];
        if (_phases[each.Id] == EventPhase.Waiting && Triggers.Hold(each, view, _actors, _phases))
        {
            Enter(each, EventPhase.Delayed, view);
        }

        if (_phases[each.Id] == EventPhase.Delayed && view.Seconds - _since[each.Id] >= each.Delay && actor.State is not null)
        {
            Enter(each, EventPhase.Running, view);
            _log.Add(new ScenarioLogEntry(each.Id, HasEnded: false, _world.GameFrame, view.Seconds));
            _orders.Give(actor, each.Action, view);
            return;
        }

        if (_phases[each.Id] == EventPhase.Running)
        {
            double seconds = view.Seconds - _since[each.Id];
            _orders.Continue(actor, each.Action, seconds);
            if (ActionOrders.IsDone(actor, each.Action, seconds))
            {
                Enter(each, EventPhase.Over, view);
                _log.Add(new ScenarioLogEntry(each.Id, HasEnded: true, _world.GameFrame, view.Seconds));
                _orders.End(actor, each.Action);
            }
        }
    }

    private void Enter(ScenarioEvent each, EventPhase phase, SceneView view)
    {
        _phases[each.Id] = phase;
        _since[each.Id] = view.Seconds;
    }

    private ScenarioOutcome? OutcomeOf(SceneView view)
    {
        ScenarioEnd end = _bound.Scenario.End;
        return end.Collision && _touched is { } touched && view.Seconds - touched >= AfterCollision ? ScenarioOutcome.Collision
            : end.EgoPassedAll && _actors.Values.All(actor => view.AheadOf(actor) < -PassedBy) ? ScenarioOutcome.PassedAll
            : view.EgoAt >= end.Metres ? ScenarioOutcome.Distance
            : view.Seconds >= end.Seconds ? ScenarioOutcome.Time
            : null;
    }
}
