using Harvester.Driving.Controllers;
using Harvester.Driving.Scenarios;
using Harvester.Geometry;
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

    /// <summary>Number of places that are tried where something stands in the way of an actor.</summary>
    private const int MaxPlaces = 8;

    private readonly PlannedScenario _planned;
    private ScenarioPlayer? _player;

    private StagedRun(PlannedScenario planned, BoundScenario bound) => (_planned, Bound) = (planned, bound);

    /// <summary>The scenario at its place.</summary>
    public BoundScenario Bound { get; }

    /// <summary>Whether it is over.</summary>
    public bool IsOver => _player?.Outcome is not null;

    /// <summary>How far the ego is along its way from its start, metres; 0 before the first tick.</summary>
    public double EgoAt => _player?.EgoAt ?? 0;

    /// <summary>What a session keeps of it; null before it has begun.</summary>
    public ScenarioRecord? Record => _player?.Record(_planned.Seed);

    /// <summary>The game in which it is played.</summary>
    public SimulatedGame Game { get; private set; } = null!;

    /// <summary>Draws the parameters, finds a place, makes the game there, puts the actors into it and sends the ego on its way.</summary>
    /// <param name="planned">The scenario.</param>
    /// <param name="options">The options of the game otherwise; with its roads and the seed of its world.</param>
    /// <param name="near">The place; null for any where it can happen, of several where something stands in the way.</param>
    /// <exception cref="ScenarioUnfitException">It cannot happen there; the message says why.</exception>
    public static StagedRun Begin(PlannedScenario planned, SimulationOptions options, Vector2D? near)
    {
        ArgumentNullException.ThrowIfNull(planned);
        ArgumentNullException.ThrowIfNull(options);
        Scenario scenario = planned.Template.Drawn(planned.Seed);
        var reasons = new Dictionary<string, int>(StringComparer.Ordinal);
        string? refusal = null;
        foreach (
            BoundScenario bound in Places(planned, scenario, ScenarioTown.Of(options.Roads, options.Seed), near, reasons).Take(MaxPlaces)
        )
        {
            var staged = new StagedRun(planned, bound);
            if (staged.Enter(options) is not { } reason)
            {
                return staged;
            }

            refusal ??= reason;
        }

        refusal ??=
            reasons.Count == 0 ? "The roads have no lanes, or no crossing or lights that it needs."
            : near is null ? $"No place fits; most often: {reasons.MaxBy(each => each.Value).Key}"
            : reasons.Keys.First();
        throw new ScenarioUnfitException($"The scenario '{scenario.Name}' cannot happen here. {refusal}");
    }

    private static IEnumerable<BoundScenario> Places(
        PlannedScenario planned,
        Scenario scenario,
        ScenarioTown town,
        Vector2D? near,
        Dictionary<string, int> reasons
    )
    {
        if (near is not { } place)
        {
            return town.Anywhere(scenario, planned.Seed, reasons);
        }

        BoundScenario? bound = town.At(scenario, place, planned.HeadingDegrees, planned.Seed, out string? reason);
        if (bound is null)
        {
            reasons.Add(reason!, 1);
        }

        return bound is null ? [] : [bound];
    }

    private SimulationOptions Options(SimulationOptions options)
    {
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

    /// <summary>Makes the game, puts the actors into it and sends the ego on its way.</summary>
    /// <returns>Why that is impossible, as a sentence; null if it is done.</returns>
    private string? Enter(SimulationOptions options)
    {
        try
        {
            Game = new SimulatedGame(Options(options));
        }
        catch (ArgumentException e)
        {
            return e.Message;
        }

        _player = new ScenarioPlayer(Bound, Game.Ports.Stage!, Game.Ports.World)
        {
            EgoIgnoresOthers = _planned.IsEgoBlind,
            Light = () => Game.Conduct.Light ?? LightState.Unknown,
        };
        return _player.Begin();
    }

    /// <summary>Plays on for the coming tick, unless the game is frozen.</summary>
    public void Tick()
    {
        if (!Game.IsFrozen)
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
