using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Driving.Scenarios;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Scenarios;

/// <summary>A scenario in the simulated game, from the choice of its place to its end.</summary>
public sealed class StagedRun
{
    /// <summary>Around actors no vehicle is parked within this distance, metres.</summary>
    private const double ParkedRoom = 14;

    /// <summary>Nor is one as far ahead of an actor that parks, metres.</summary>
    private const double ParkingWay = 56;

    private readonly PlannedScenario _planned;
    private ScenarioPlayer? _player;

    private StagedRun(PlannedScenario planned, BoundScenario bound) => (_planned, Bound) = (planned, bound);

    /// <summary>The scenario at its place.</summary>
    public BoundScenario Bound { get; }

    /// <summary>Whether it is over.</summary>
    public bool IsOver => _player?.Outcome is not null;

    /// <summary>What a session keeps of it; null before it has begun.</summary>
    public ScenarioRecord? Record => _player?.Record(_planned.Seed);

    /// <summary>Draws the parameters and finds a place.</summary>
    /// <param name="planned">The scenario.</param>
    /// <param name="roads">The roads; null for the town of the seed.</param>
    /// <param name="worldSeed">Seed of the world.</param>
    /// <param name="near">The place; null for any where it can happen.</param>
    /// <exception cref="ScenarioUnfitException">It cannot happen there; the message says why.</exception>
    public static StagedRun Bind(PlannedScenario planned, RoadNetwork? roads, int worldSeed, Vector2D? near)
    {
        ArgumentNullException.ThrowIfNull(planned);
        var town = new ScenarioTown(roads, worldSeed);
        Scenario scenario = planned.Template.Drawn(planned.Seed);
        BoundScenario? bound = near is { } place
            ? town.At(scenario, place, planned.HeadingDegrees, planned.Seed, out string? reason)
            : town.Anywhere(scenario, planned.Seed, out reason);
        return bound is null
            ? throw new ScenarioUnfitException($"The scenario '{scenario.Name}' cannot happen here. {reason}")
            : new StagedRun(planned, bound);
    }

    /// <summary>The options of a game in which it can be played.</summary>
    /// <param name="options">The options otherwise.</param>
    public SimulationOptions Options(SimulationOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        Vector3D forward = Bound.Place.Track.DirectionAt(0);
        return options with
        {
            Near = new Vector2D(Bound.Ego.X, Bound.Ego.Y),
            StartSeed = null,
            Wander = 0,
            LaneChanges = 0,
            Stage = new StageSetting(Bound.Ego, PathFollower.HeadingOf(new Vector2D(forward.X, forward.Y)), Bound.Scenario.Ego.Speed)
            {
                Way = Bound.Place.Track.Path(0, Bound.Place.Track.To),
                ClearOfParked = [.. Bound.Actors.SelectMany(ZonesOf)],
                Green = Bound.Green,
            },
        };
    }

    /// <summary>Puts the actors into the game and sends the ego on its way.</summary>
    /// <exception cref="ScenarioUnfitException">An actor cannot be put there; the message says why.</exception>
    public void Begin(SimulatedGame game)
    {
        ArgumentNullException.ThrowIfNull(game);
        IStage stage = game.Ports.Stage ?? throw new ArgumentException("The game has no stage.", nameof(game));
        _player = new ScenarioPlayer(Bound, stage, game.Ports.World)
        {
            EgoIgnoresOthers = _planned.IsEgoBlind,
            Light = () => game.Conduct.Light ?? LightState.Unknown,
        };
        if (_player.Begin() is { } reason)
        {
            throw new ScenarioUnfitException($"The scenario '{Bound.Scenario.Name}' cannot happen here. {reason}");
        }
    }

    /// <summary>Plays on for the coming tick, unless the game is frozen.</summary>
    public void Tick(SimulatedGame game)
    {
        ArgumentNullException.ThrowIfNull(game);
        if (!game.IsFrozen)
        {
            _player?.Tick();
        }
    }

    private IEnumerable<(Vector3D Middle, double Radius)> ZonesOf(BoundActor actor)
    {
        yield return (actor.Ground, ParkedRoom);
        bool parks = Bound.Scenario.Events.Any(each => each.Actor == actor.Actor.Id && each.Action.Kind == ScenarioActionKind.Park);
        for (double ahead = ParkedRoom; parks && ahead <= ParkingWay; ahead += ParkedRoom)
        {
            yield return (actor.Track.PositionAt(ahead), ParkedRoom);
        }
    }
}
