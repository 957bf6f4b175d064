using Harvester.Runs.Evaluation.Figures;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Traffic;

namespace Harvester.Runs.Driving;

/// <summary>Samples the true state of the ego vehicle of a simulated _game.</summary>
public sealed class TruthSampler
{
    /// <summary>Vehicles farther from the ego vehicle cannot touch it, metres.</summary>
    private const double ContactRange = 25;

    private readonly SimulatedGame _game;
    private readonly List<DriveSample> _samples = [];
    private double _metres;

    /// <param name="game">The game, which counts collisions from now on.</param>
    public TruthSampler(SimulatedGame game)
    {
        _game = game;
        _ = game.Conduct;
    }

    /// <summary>The samples so far, in the order of time.</summary>
    public IReadOnlyList<DriveSample> Samples => _samples;

    /// <summary>Distance driven so far, metres.</summary>
    public double Metres => _metres;

    /// <summary>Takes a sample.</summary>
    /// <param name="isByController">Whether the controller drives, not the built-in driver.</param>
    public void Take(bool isByController)
    {
        EgoState ego = _game.Ports.World.ReadEgo();
        GroundBox body = GroundBox.Of(ego.Pose, ego.ModelMin, ego.ModelMax);
        double time = _game.Ports.World.TimeSeconds;
        DriveSample? before = _samples.LastOrDefault();
        double distance = before is null ? 0 : (body.Centre - before.Position).Length;
        bool isTeleported = before is null || Relocation.Is(distance, before.Speed, ego.Velocity.Length, time - before.TimeSeconds);
        _metres += isTeleported ? 0 : distance;
        _samples.Add(
            new DriveSample
            {
                TimeSeconds = time,
                Position = body.Centre,
                Speed = ego.Velocity.Length,
                IsByController = isByController,
                IsTeleported = isTeleported,
                Lane = TrueLane.Of(_game.Truth, ego).Placement,
                Touching =
                [
                    .. _game
                        .Ports.World.ReadEntities(ego.Pose.Position, ContactRange)
                        .Where(entity =>
                            VehicleClasses.AreVehicles(entity.Class)
                            && body.Overlaps(GroundBox.Of(entity.Pose, entity.ModelMin, entity.ModelMax))
                        )
                        .Select(entity => entity.Handle),
                ],
                Counters = CountersOf(_game.Conduct),
            }
        );
    }

    private static DriveCounters CountersOf(EgoConduct conduct) =>
        new(
            conduct.Collisions[(int)EgoContact.Vehicle],
            conduct.Collisions[(int)EgoContact.Parked],
            conduct.Collisions[(int)EgoContact.Pedestrian],
            conduct.RedLightsRun,
            conduct.StopSignsRun
        );
}
