using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenarios;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// A drive that provokes events, in dense traffic, where now and then the built-in driver gives way to a program that brakes fully,
/// swerves, leaves the road or drives straight on at full throttle, or in a scenario. The events come from a harvest; what the game's
/// world was at every tick is recorded beside it.
/// </summary>
internal sealed class ProvokedDrive
{
    private const double TickSeconds = 1.0 / 60;

    /// <summary>Frames per second: hardly any, because the events of a frame are those that the world tells at its ticks.</summary>
    private const double FrameRate = 0.1;

    /// <summary>Distances of the ego from the line of a stop sign at which it starts, metres.</summary>
    private const double FarBefore = 30;
    private const double CloseBefore = 6;

    private static readonly DrivingControls[] Provocations =
    [
        new(0, 0, 1),
        new(0, 1, 0),
        new(0.12, 0.6, 0),
        new(-0.12, 0.6, 0),
        new(0.05, 1, 0),
        new(-0.05, 1, 0),
        new(0.35, 0.5, 0),
        new(-0.35, 0.5, 0),
    ];

    private ProvokedDrive(int seed) => Seed = seed;

    /// <summary>Seed of the town.</summary>
    public int Seed { get; }

    /// <summary>The events in the order in which they ended.</summary>
    public List<DrivingEvent> Events { get; } = [];

    /// <summary>The world at every tick.</summary>
    public List<TrueMoment> Truth { get; } = [];

    /// <summary>Drives for some time.</summary>
    public static ProvokedDrive Of(int seed, double seconds, bool hasCrashes = false)
    {
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = seed,
                TrafficDensity = 2.5,
                PedestrianDensity = 3,
                LaneChanges = 3,
                Wander = 1,
                HasCrashes = hasCrashes,
            }
        );
        var random = new Random(seed);
        double time = 0;
        double next = 4;
        double until = 0;
        DrivingControls controls = default;
        return Recorded(
            seed,
            game,
            () =>
            {
                if (time >= next)
                {
                    controls = Provocations[random.Next(Provocations.Length)];
                    until = time + 1 + (2 * random.NextDouble());
                    next = until + 3 + (4 * random.NextDouble());
                }

                if (time < until)
                {
                    game.Ports.Car!.Drive(controls);
                }

                time += TickSeconds;
                return time < seconds;
            }
        );
    }

    /// <summary>
    /// Passes stop signs of the town at full throttle, by turns from a start far before the line, so that the ego never stands near it, and
    /// from one close before it.
    /// </summary>
    /// <param name="seed">Seed of the town.</param>
    /// <param name="signs">Greatest number of signs.</param>
    public static ProvokedDrive PastStopSigns(int seed, int signs)
    {
        const double seconds = 6;
        Site site = SiteCache.Shared.Town(seed);
        var scenery = new Scenery(seed, site, ModelCatalogue.Shared, new HandleCounter());
        scenery.AddStopSigns(site.Plan, site.Signals.Has);
        RoadArm[] arms = [.. scenery.StopArms.Select(each => each.Arm).Where(IsStraightBefore).Take(signs)];
        var game = new SimulatedGame(new SimulationOptions { Seed = seed, TrafficDensity = 0.5 });
        double time = 0;
        int passed = 0;
        return Recorded(
            seed,
            game,
            () =>
            {
                if (passed < arms.Length && time >= passed * seconds)
                {
                    Place(game, arms[passed], passed % 2 == 0 ? FarBefore : CloseBefore);
                    passed++;
                }

                game.Ports.Car!.Drive(new DrivingControls(0, 1, 0));
                time += TickSeconds;
                return time < arms.Length * seconds;
            }
        );
    }

    /// <summary>Plays a scenario, in a town where it can happen; the ego takes no notice of its actors.</summary>
    /// <exception cref="ScenarioUnfitException">It cannot happen in the town of the seed.</exception>
    public static ProvokedDrive Staged(ScenarioTemplate template, int seed, bool hasCrashes = false)
    {
        StagedRun staged = StagedRun.Begin(
            new PlannedScenario(template, seed) { IsEgoBlind = hasCrashes },
            new SimulationOptions
            {
                Seed = seed,
                IsWarm = true,
                TrafficDensity = 0.5,
                ParkedDensity = 0.5,
                PedestrianDensity = 0.5,
                HasCrashes = hasCrashes,
            },
            near: null
        );
        SimulatedGame game = staged.Game;
        return Recorded(
            seed,
            game,
            () =>
            {
                staged.Tick();
                return !staged.IsOver;
            }
        );
    }

    private static bool IsStraightBefore(RoadArm arm)
    {
        const double straight = 0.9999;
        return arm.Road.Length > arm.Trim + FarBefore
            && arm.Road.Curve.TangentAt(arm.DistanceAt(arm.Trim)).Dot(arm.Road.Curve.TangentAt(arm.DistanceAt(arm.Trim + FarBefore)))
                > straight;
    }

    /// <summary>Places the ego before the line of an arm, on the leftmost lane of its traffic.</summary>
    private static void Place(SimulatedGame game, RoadArm arm, double before)
    {
        double distance = arm.DistanceAt(arm.Trim + before);
        Vector3D along = arm.Road.Curve.TangentAt(distance) * (arm.AtStart ? -1 : 1);
        Vector3D place = arm.Road.Curve.OffsetAt(distance, arm.Road.Layout.LaneCentre(!arm.AtStart, 0));
        game.Ports.Car!.Reset(place, Math.Atan2(-along.X, along.Y) * 180 / Math.PI);
    }

    /// <summary>Harvests a game that is steered in each tick until that ends the drive.</summary>
    private static ProvokedDrive Recorded(int seed, SimulatedGame game, Func<bool> steer)
    {
        var drive = new ProvokedDrive(seed);
        using var sink = new EventSink(drive);
        using var session = new HarvestSession(
            new HarvestOptions
            {
                Image = new ImageSize(32, 24),
                Freeze = false,
                LiveLag = new PictureLag(0, 0),
                ProbeLag = false,
                MaxCalibrationErrorPixels = null,
                RateHz = FrameRate,
                RangeMetres = 10,
                IgnoreRangeMetres = 0,
                Scenes = false,
                Events = new EventOptions(),
            },
            game.Ports with
            {
                Roads = new FixedRoads(game.Roads, "simulation"),
            },
            sink
        );
        Step();
        while (steer())
        {
            game.Tick(TickSeconds);
            Step();
        }

        session.Stop();
        Assert.Null(session.Fault);
        return drive;

        void Step()
        {
            session.Step();

            // What happened before the harvest began is not part of it.
            if (sink.IsOpen)
            {
                drive.Truth.Add(TrueMoment.Of(game.Ports.World));
            }
        }
    }

    /// <summary>An event with the handles of its participants, who are recognised by their places at its peak.</summary>
    public TrueEvent WithHandles(DrivingEvent happened)
    {
        TrueMoment moment = Truth.Find(each => each.Seconds == happened.PeakSeconds)!;
        int[] handles = [.. happened.Participants.Select(participant => HandleOf(moment, participant))];
        return new TrueEvent(happened.Kind, handles[0], handles.Length > 1 ? handles[1] : -1, happened.BeginSeconds, happened.EndSeconds);
    }

    private static int HandleOf(TrueMoment moment, EventParticipant participant) =>
        participant.Object is null
            ? 0
            : moment
                .Bodies.Single(body => body.Key != 0 && body.Value.Class == participant.Class && body.Value.Pose == participant.Pose)
                .Key;

    private sealed class EventSink(ProvokedDrive drive) : IFrameSink
    {
        public string? Fault => null;

        public int FirstFrame => 0;

        public int FirstObjectId => 1;

        public int FirstEventId => 1;

        public bool IsOpen { get; private set; }

        public void Open(SessionStart start) => IsOpen = true;

        public bool TryEnqueue(CapturedFrame frame)
        {
            drive.Events.AddRange(frame.EndedEvents);
            frame.Dispose();
            return true;
        }

        public void Close(SessionEnd end) => drive.Events.AddRange(end.Events!);

        public void Dispose() { }
    }
}
