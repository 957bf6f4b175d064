using System.Text.Json;
using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests.Gym;

/// <summary>The environment for learners, in Python, drives the mod over its socket as it drives the simulated game.</summary>
public sealed class GymTests : ServedGame
{
    private const int Steps = 200;
    private const int StateNumbers = 28;

    /// <summary>Ticks after which the image of a paused world shows it for certain.</summary>
    private const int SettleTicks = 4;
    private const double TopSpeed = 5;
    private const double MetresPerSecondAndTick = 0.125;

    /// <summary>State and natives have single precision.</summary>
    private const double SinglePrecision = 1e-3;

    private readonly Dictionary<int, Moment> _moments = [];

    [PythonFact]
    [Trait("Category", "Heavy")]
    public void Environment_drives_the_mod_by_images_and_state()
    {
        using ScriptDriver driver = Served();
        using var python = new PythonDriver(Port, Steps);
        bool isOver = false;
        driver.Until(
            () =>
            {
                Note(driver.Game);
                if (!isOver && python.Lines.Any(IsDriven))
                {
                    isOver = true;
                    driver.Press(Keys.N);
                }

                return python.HasExited;
            },
            ClientsPauseMilliseconds
        );

        Assert.Equal((0, ""), (python.Finish(), python.Errors));
        JsonElement[] frames = [.. python.Lines.Where(line => line.TryGetProperty("shapes", out _))];
        Assert.Equal(Steps + 1, frames.Length);
        foreach (JsonElement frame in frames)
        {
            AssertObservation(frame);
        }

        AssertPlace(frames[0]);
        for (int step = 0; step < Steps; step++)
        {
            AssertStep(frames[step], frames[step + 1]);
        }

        Assert.Equal(
            ["GameEndedError", "GameStartError"],
            python.Lines[^1].GetProperty("errors").EnumerateArray().Select(error => error.GetString())
        );
    }

    private static bool IsDriven(JsonElement line) =>
        line.GetProperty("state") is { ValueKind: JsonValueKind.String } state && state.GetString() == "driven";

    /// <summary>The street with its road, whose car accelerates by its throttle and keeps its heading.</summary>
    private ScriptDriver Served()
    {
        var driver = new ScriptDriver(Ini(Port));
        Street(driver.Game);
        driver.Game.Roads = new FakeRoadSource(RoadTests.Road());
        Start(driver);
        for (int wait = 0; wait < 50; wait++)
        {
            driver.Tick();
            driver.WaitForDisk();
        }

        GameEntity car = driver.Game.Entities[driver.Game.PlayersVehicle];
        driver.Game.PassFrame = () =>
        {
            if (!driver.Game.IsFrozen)
            {
                double speed = Math.Min(TopSpeed, car.Velocity.Length + MetresPerSecondAndTick);
                car.Velocity = car.Pose.Axes.Forward * speed;
                car.Pose = car.Pose with { Position = car.Pose.Position + (car.Velocity * 0.05) };
            }
        };
        return driver;
    }

    /// <summary>Notes the world as the script has just seen it.</summary>
    private void Note(TestGame game)
    {
        GameEntity car = game.Entities[game.PlayersVehicle];
        if (!_moments.TryGetValue(game.TimerMilliseconds, out Moment? moment))
        {
            moment = new Moment();
            _moments[game.TimerMilliseconds] = moment;
        }

        moment.Steering = moment.Frames.Count == 0 ? game.Controls.GetValueOrDefault(Steer) : moment.Steering;
        moment.Frames.Add((game.Frame, car.Pose.Position, car.Velocity.Length));
    }

    private static void AssertObservation(JsonElement frame)
    {
        Assert.Equal("[[210, 280, 3], [" + StateNumbers + "]]", frame.GetProperty("shapes").GetRawText());
        Assert.Equal("[\"uint8\", \"float32\"]", frame.GetProperty("types").GetRawText());
        Assert.True(frame.GetProperty("isInSpace").GetBoolean());

        // The road's middle line is 2.625 m left of the car, the lane is 5.4 m wide, and both look north.
        JsonElement state = frame.GetProperty("state");
        Assert.Equal(0, state.GetProperty("angle").GetDouble(), SinglePrecision);
        Assert.Equal(-2.625, state.GetProperty("toMarkingML").GetDouble(), SinglePrecision);
        Assert.Equal(2.775, state.GetProperty("toMarkingMR").GetDouble(), SinglePrecision);
        Assert.Equal(1, state.GetProperty("lanesKnown").GetDouble());

        // What the game does not report.
        Assert.All(
            ["route:left", "route:straight", "route:right", "light:green", "light:amber", "light:red", "stopSign", "builtInDriver"],
            name => Assert.Equal(0, state.GetProperty(name).GetDouble())
        );
        Assert.Equal(100, state.GetProperty("routeMetres").GetDouble());
    }

    /// <summary>The car has been placed, at rest, and the image is one of the paused world after that.</summary>
    private void AssertPlace(JsonElement frame)
    {
        Assert.Equal([100, 190, 0.6], frame.GetProperty("position").EnumerateArray().Select(part => Math.Round(part.GetDouble(), 3)));
        Assert.Equal((0, 0), (frame.GetProperty("heading").GetDouble(), Speed(frame)));
        AssertSettledImage(frame, placed: true);
    }

    private void AssertStep(JsonElement before, JsonElement frame)
    {
        Assert.Equal(100, Milliseconds(frame) - Milliseconds(before));
        foreach (int tick in new[] { Milliseconds(frame) - 50, Milliseconds(frame) })
        {
            // The wheel's sign is the other way round in the game.
            Assert.Equal(-frame.GetProperty("steering").GetDouble(), _moments[tick].Steering);
        }

        (_, Vector3D position, double speed) = _moments[Milliseconds(frame)].Frames[^1];
        Assert.Equal(speed, Speed(frame), SinglePrecision);
        Assert.Equal(position.Y, frame.GetProperty("position")[1].GetDouble(), SinglePrecision);
        Assert.Equal("[null, null]", frame.GetProperty("ended").GetRawText().Replace("false", "null", StringComparison.Ordinal));

        // 0.1 for each metre; -0.1 for each second below 0.5 m/s.
        double reward = (0.1 * speed * 0.1) - (speed < 0.5 ? 0.01 : 0);
        Assert.Equal(reward, frame.GetProperty("reward").GetDouble(), SinglePrecision);
        AssertSettledImage(frame, placed: false);
    }

    /// <summary>The level of the image is the number of the frame in which it was grabbed (TestScreen).</summary>
    private void AssertSettledImage(JsonElement frame, bool placed)
    {
        int[] levels = [.. frame.GetProperty("levels").EnumerateArray().Select(level => level.GetInt32())];
        Assert.Equal(levels[0], levels[1]);
        (int Frame, Vector3D Position, double Speed)[] stood =
        [
            .. _moments[Milliseconds(frame)].Frames.Where(seen => !placed || seen.Position == new Vector3D(100, 190, (float)0.6)),
        ];
        Assert.Contains(stood.Skip(SettleTicks), seen => 1 + (seen.Frame % 255) == levels[0]);
    }

    private static double Speed(JsonElement frame) => frame.GetProperty("state").GetProperty("speed").GetDouble();

    private static int Milliseconds(JsonElement frame) => (int)Math.Round(frame.GetProperty("seconds").GetDouble() * 1000);

    /// <summary>A time of the game: the steering in force when it came, and its frames, more than one if the game stood still.</summary>
    private sealed class Moment
    {
        public double Steering { get; set; }

        public List<(int Frame, Vector3D Position, double Speed)> Frames { get; } = [];
    }
}
