using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Evaluation.Noise;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>
/// A drive in the simulated game with the controller in the same process, without images. Where the lanes are unknown, as in junctions,
/// and where the car must give way, its built-in driver follows the route.
/// </summary>
public sealed class DirectDrive(SimulatedGame game, IRoads roads, Func<IController> newController)
{
    private const double TickSeconds = 0.05;
    private const int TicksPerControl = 2;

    /// <summary>Range of the indicators plus half the length of the longest vehicle, metres.</summary>
    private const double VehicleRange = IndicatorCalculator.VehicleRange + 10;

    private readonly LaneTracker _lanes = new(roads, entity => entity.Handle);
    private readonly TruthSampler _sampler = new(game);
    private Handover _handover = new();
    private IController _controller = newController();

    /// <summary>Records the drive; null for none.</summary>
    public GameRecording? Recording { get; init; }

    /// <summary>Called before each tick of the game, as for actors that are staged in it; null for nothing.</summary>
    public Action? BeforeTick { get; init; }

    /// <summary>Disturbs the steering now and then; null for none.</summary>
    public SteeringDisturbance? Disturbance { get; init; }

    /// <summary>The samples until now, also after a fault.</summary>
    public IReadOnlyList<DriveSample> Samples => _sampler.Samples;

    /// <summary>Drives until the distance (metres) or the time limit (seconds of game time) is reached.</summary>
    public void Run(double metres, double seconds, Action<double> report, CancellationToken cancellation)
    {
        IDrivenCar car = game.Ports.Car!;
        DrivingControls controls = DrivingControls.Stop;
        bool isByController = false;
        Recording?.IsByBuiltInDriver = () => !isByController;
        for (
            int tick = 0;
            _sampler.Metres < metres && game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested;
            tick++
        )
        {
            if (tick % TicksPerControl == 0)
            {
                LaneObservation? seen = Look(game.Ports.World.ReadEgo());
                isByController = _handover.Decide(seen, game.NeedsOwnDriver);
                controls = _controller.Drive(StateOf(seen));
                if (Recording?.Look() ?? false)
                {
                    Recording.Answer(controls);
                }
            }

            double push = 0;
            if (isByController)
            {
                push = Disturbance?.Next(game.Ports.World.ReadEgo().Velocity.Length, TickSeconds) ?? 0;
                car.Drive(push == 0 ? controls : new DrivingControls(controls.Steering + push, controls.Throttle, controls.Brake));
            }

            BeforeTick?.Invoke();
            game.Tick(TickSeconds);
            Recording?.Tick(isByController ? DriverKind.Controller : DriverKind.BuiltIn, push != 0);
            if (tick % TicksPerControl == TicksPerControl - 1)
            {
                _sampler.Take(isByController);
                report(_sampler.Metres);
                if (_sampler.Samples[^1].IsTeleported)
                {
                    // What was known of the road does not hold at the new place.
                    _lanes.Reset();
                    _handover = new Handover();
                    _controller = newController();
                }
            }
        }
    }

    private LaneObservation? Look(EgoState ego) =>
        _lanes.Observe(ego, game.Ports.World.ReadEntities(ego.Pose.Position, VehicleRange))?.Seen;

    private DrivingState StateOf(LaneObservation? seen)
    {
        EgoState ego = game.Ports.World.ReadEgo();
        LaneIndicators indicators = seen?.Indicators ?? LaneIndicators.Unknown;
        return new DrivingState(
            indicators,
            seen?.Section is { } section
                ? TorcsEquivalent.Of(indicators, section, seen.OffsetFromLeftEdge, seen.IndicatorsAtCar.Angle)
                : indicators,
            seen?.IsFast ?? false,
            ego.Velocity.Length
        )
        {
            HeadingRadians = Angles.ToRadians(Angles.HeadingDegrees(ego.Pose.Axes.Forward)),
            PedalsInForce = DrivingState.PedalsOf(ego),
        };
    }
}
