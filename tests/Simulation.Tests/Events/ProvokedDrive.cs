using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// A drive in dense traffic that provokes events: now and then the built-in driver gives way to a program that brakes fully, swerves or
/// drives straight on at full throttle. The events come from a harvest; what the game's world was at every tick is recorded beside it.
/// </summary>
internal sealed class ProvokedDrive
{
    private const double TickSeconds = 1.0 / 60;

    private static readonly DrivingControls[] Provocations =
    [
        new(0, 0, 1),
        new(0, 1, 0),
        new(0.12, 0.6, 0),
        new(-0.12, 0.6, 0),
        new(0.05, 1, 0),
        new(-0.05, 1, 0),
    ];

    private ProvokedDrive() { }

    /// <summary>The events in the order in which they ended.</summary>
    public List<DrivingEvent> Events { get; } = [];

    /// <summary>The labels of the frames, two a second.</summary>
    public List<FrameLabel> Labels { get; } = [];

    /// <summary>The world at every tick.</summary>
    public List<TrueMoment> Truth { get; } = [];

    /// <summary>Drives for some time.</summary>
    public static ProvokedDrive Of(int seed, double seconds, bool hasCrashes = false)
    {
        var drive = new ProvokedDrive();
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = seed,
                TrafficDensity = 2.5,
                PedestrianDensity = 3,
                LaneChanges = 1,
                Wander = 1,
                HasCrashes = hasCrashes,
            }
        );
        var random = new Random(seed);
        using var sink = new EventSink(drive);
        using var session = new HarvestSession(
            new HarvestOptions
            {
                Image = new ImageSize(32, 24),
                Freeze = false,
                LiveLag = new PictureLag(0, 0),
                ProbeLag = false,
                MaxCalibrationErrorPixels = null,
                RateHz = 2,
                RangeMetres = 10,
                IgnoreRangeMetres = 0,
                Scenes = false,
                Events = new EventOptions(),
            },
            game.Ports,
            sink
        );
        session.Step();
        double next = 4;
        double until = 0;
        DrivingControls controls = default;
        for (double time = 0; time < seconds; time += TickSeconds)
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

            game.Tick(TickSeconds);
            session.Step();
            drive.Truth.Add(TrueMoment.Of(game.Ports.World));
        }

        session.Stop();
        Assert.Null(session.Fault);
        return drive;
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

        public void Open(SessionStart start) { }

        public bool TryEnqueue(CapturedFrame frame)
        {
            drive.Events.AddRange(frame.EndedEvents);
            drive.Labels.Add(frame.Label);
            frame.Dispose();
            return true;
        }

        public void Close(SessionEnd end) => drive.Events.AddRange(end.Events!);

        public void Dispose() { }
    }
}
