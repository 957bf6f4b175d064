using System.Runtime.ExceptionServices;
using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Evaluation.Noise;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Runs.Faults;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Driving;

/// <summary>Builds the simulated games of a plan, one for each episode, and drives in them.</summary>
/// <param name="plan">The drives.</param>
/// <param name="messages">Receives a line with the address at which a drive waits for a client.</param>
public sealed class EpisodeRunner(DriveSettings plan, TextWriter messages)
{
    private readonly IReadOnlyList<(int Seed, Vector2D? Start)> _plans = plan.Episodes;
    private readonly DriveEpisode?[] _episodes = new DriveEpisode?[plan.Episodes.Count];

    /// <summary>Roads of a file are prepared once for all starts; each generated town has its own.</summary>
    private readonly Lazy<FixedRoads>? _roads = plan.Roads is { } roads ? new(() => Prepared(plan, roads, "roadFile")) : null;

    private readonly Lock _reporting = new();
    private double _metres;

    /// <summary>Records the drives, one after the other; null for none.</summary>
    public DriveRecording? Recording { get; init; }

    /// <summary>The episodes with samples until now, also after a fault, in the order of the plan.</summary>
    public IReadOnlyList<DriveEpisode> Episodes => [.. _episodes.OfType<DriveEpisode>().Where(episode => episode.Samples.Count > 0)];

    /// <summary>The samples of all episodes.</summary>
    public IReadOnlyList<DriveSample> Samples => [.. Episodes.SelectMany(episode => episode.Samples)];

    /// <summary>Drives all episodes and adds them to <see cref="Episodes"/>. Their number at a time changes nothing in them.</summary>
    /// <param name="report">Receives the total distance driven, metres.</param>
    /// <param name="cancellation">Ends the drive; the samples are kept.</param>
    /// <exception cref="UsageException">There is no road near a start position.</exception>
    /// <exception cref="IOException">A bridge cannot be opened or fails, or the other side does not answer.</exception>
    /// <exception cref="GameFaultException">The game failed.</exception>
    public void Run(Action<int> report, CancellationToken cancellation)
    {
        var faults = new ExceptionDispatchInfo?[_plans.Count];
        var options = new ParallelOptions { MaxDegreeOfParallelism = plan.Bridge is null && Recording is null ? plan.Jobs : 1 };
        Parallel.For(
            0,
            _plans.Count,
            options,
            (i, loop) =>
            {
                if (cancellation.IsCancellationRequested)
                {
                    loop.Break();
                    return;
                }

                try
                {
                    Drive(i, report, cancellation);
                }
                catch (Exception e) when (e is IOException or UnauthorizedAccessException or GameFaultException or UsageException)
                {
                    faults[i] = ExceptionDispatchInfo.Capture(e);
                    loop.Break();
                }
            }
        );
        faults.FirstOrDefault(fault => fault is not null)?.Throw();
    }

    /// <summary>A new controller of the plan, with its noise.</summary>
    public IController ControllerOf(int seed, GameRecording? recording = null)
    {
        IController controller = plan.Controller.New();
        return Noisy(recording?.Watch(controller) ?? controller, seed);
    }

    /// <summary>As <see cref="ControllerOf"/>, for indicators with the angle at the car.</summary>
    private IController ControllerAtCar(int seed) => Noisy((plan.Controller with { LookAheadMetres = 0 }).New(), seed);

    private IController Noisy(IController controller, int seed) =>
        plan.Noise is { } noise ? new NoisyIndicators(controller, noise, seed) : controller;

    private static FixedRoads Prepared(DriveSettings plan, RoadNetwork roads, string source) =>
        new(roads, source, LookAhead.OfMetres(plan.Controller.LookAheadMetres), paint: plan.Paint);

    private void Drive(int index, Action<int> report, CancellationToken cancellation)
    {
        (int seed, Vector2D? start) = _plans[index];
        SimulatedGame game = Build(start, seed);
        IRoads roads = _roads?.Value ?? Prepared(plan, game.Roads, "simulation");
        using GameRecording? recording = Recording?.Of(game, roads, seed);
        List<DriveSample> samples = [];
        bool isStopped = true;
        double reported = 0;
        try
        {
            if (plan.Bridge is { } bridge)
            {
                new BridgeSetup(bridge, messages) { Recording = recording }.Run(
                    game,
                    roads,
                    () => ControllerOf(seed),
                    () => ControllerAtCar(seed),
                    plan.Metres,
                    plan.Seconds,
                    samples,
                    cancellation
                );
            }
            else
            {
                var drive = new DirectDrive(game, roads, () => ControllerOf(seed, recording))
                {
                    Recording = recording,
                    Disturbance = plan.IsDisturbed ? new SteeringDisturbance(seed, plan.Controller.Car) : null,
                };
                try
                {
                    drive.Run(plan.Metres, plan.Seconds, Report, cancellation);
                }
                finally
                {
                    samples.AddRange(drive.Samples);
                }
            }

            isStopped = cancellation.IsCancellationRequested;
        }
        finally
        {
            _episodes[index] = new DriveEpisode(seed, start, samples, plan.Metres, isStopped);
        }

        void Report(double metres)
        {
            lock (_reporting)
            {
                _metres += metres - reported;
                reported = metres;
                report((int)_metres);
            }
        }
    }

    /// <summary>A game without pedestrians, because the indicators do not show them.</summary>
    private SimulatedGame Build(Vector2D? start, int seed)
    {
        try
        {
            return new SimulatedGame(
                new SimulationOptions
                {
                    Seed = seed,
                    Roads = plan.Roads,
                    Near = start,
                    WindowAspect = plan.PictureSize?.Aspect ?? (plan.Bridge is null ? 1 : new DrivingOptions().Picture.Aspect),
                    TrafficDensity = plan.TrafficDensity,
                    Weather = plan.Weather,
                    TimeOfDay = plan.TimeOfDay,
                    DayOfYear = plan.DayOfYear,
                    PedestrianDensity = 0,
                }
            );
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }
}
