using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Cli.Terminals;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Evaluation.Figures;
using Harvester.Evaluation.Noise;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Driving;

/// <summary>Builds the simulated games of a plan, one for each start, and drives in them.</summary>
/// <param name="plan">The drives.</param>
/// <param name="messages">Receives a line with the address at which a drive waits for a client.</param>
internal sealed class SimulatedDrives(DrivePlan plan, TextWriter messages)
{
    private readonly List<DriveSample> _samples = [];
    private FixedRoads? _roads;

    /// <summary>Records the drives; null for none.</summary>
    public DriveRecording? Recording { get; init; }

    /// <summary>The samples until now, also after a fault.</summary>
    public IReadOnlyList<DriveSample> Samples => _samples;

    /// <summary>Drives from each start in turn and adds to <see cref="Samples"/>.</summary>
    /// <param name="report">Receives the total distance driven, metres.</param>
    /// <param name="cancellation">Ends the drive; the samples are kept.</param>
    /// <exception cref="UsageException">There is no road near a start position.</exception>
    /// <exception cref="IOException">A bridge cannot be opened or fails, or the other side does not answer.</exception>
    /// <exception cref="GameFaultException">The game failed.</exception>
    public void Run(Action<int> report, CancellationToken cancellation)
    {
        int starts = Math.Max(1, plan.Starts.Count);
        for (int i = 0; i < starts && !cancellation.IsCancellationRequested; i++)
        {
            int seed = plan.Seed + i;
            double before = i * plan.Metres;
            SimulatedGame game = Build(plan.Starts.Count > 0 ? plan.Starts[i] : null, seed);
            using GameRecording? recording = Recording?.Of(game, RoadsOf(game), seed);
            if (plan.Bridge is { } bridge)
            {
                new RemoteDrives(bridge, messages) { Recording = recording }.Run(
                    game, RoadsOf(game), () =>
                        ControllerOf(seed), () => ControllerAtCar(seed), plan.Metres, plan.Seconds, _samples, cancellation);
            }
            else
            {
                _samples.AddRange(new LocalDrive(game, RoadsOf(game), () => ControllerOf(seed, recording))
                {
                    Recording = recording,
                    Disturbance = plan.IsDisturbed ? new SteeringDisturbance(seed, plan.Controller.Car) : null,
                }
                    .Run(plan.Metres, plan.Seconds, metres => report((int)(before + metres)), cancellation));
            }
        }
    }

    /// <summary>Roads of a file are prepared once for all starts; each generated town has its own.</summary>
    private FixedRoads RoadsOf(SimulatedGame game) => plan.Roads is null
        ? new FixedRoads(game.Roads, "simulation", LookAhead.OfMetres(plan.Controller.LookAheadMetres))
        : _roads ??= new FixedRoads(game.Roads, "roadFile", LookAhead.OfMetres(plan.Controller.LookAheadMetres));

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

    /// <summary>A game without pedestrians, because the indicators do not show them.</summary>
    private SimulatedGame Build(Vector2D? start, int seed)
    {
        try
        {
            return new SimulatedGame(new SimulationOptions
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
            });
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }
}
