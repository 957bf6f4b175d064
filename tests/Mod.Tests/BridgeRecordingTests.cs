using System.Globalization;
using System.Text.Json;
using System.Windows.Forms;
using Harvester.Datasets.Validation;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>What is recorded while a client drives: each frame that it was sent, with its answer and what the car did then.</summary>
public sealed class BridgeRecordingTests : ServedGame
{
    private const string Recorded = "Record = On\nRecordSeconds = 0.1\n";

    private const double TickSeconds = 0.05;
    private const int Steps = 12;

    /// <summary>Labels have six decimals of controls and times.</summary>
    private const double LabelTolerance = 1e-6;

    [Fact]
    public void Frame_k_has_the_answer_to_k_and_the_ticks_after_it()
    {
        using ScriptDriver driver = Driven(Recorded);
        Dictionary<long, byte[]> sent = DriveInLockStep(driver);
        FrameLabel[] labels = End(driver);

        // Frames of the running game, before the client's pause, may have been replaced before they were sent.
        labels = [.. labels.Where(label => sent.ContainsKey(label.Drive!.BridgeFrame!.Value))];
        Assert.InRange(labels.Length, Steps - 1, Steps + 1);
        foreach (FrameLabel label in labels.SkipLast(1))
        {
            DriveLabel drive = label.Drive!;
            DriveControls answer = AnswerTo(drive.BridgeFrame!.Value);
            Assert.Equal(DriverKind.Client, drive.Driver);
            AssertClose(answer, drive.Controls);
            AssertClose(answer, drive.Applied);
            Assert.Equal(8, drive.SpeedMetresPerSecond);
            Assert.Equal(
                [label.TimeSeconds + TickSeconds, label.TimeSeconds + (2 * TickSeconds)],
                drive.Ticks.Select(tick => Math.Round(tick.TimeSeconds, 6)),
                (one, other) => Math.Abs(one - other) < LabelTolerance
            );
            Assert.All(drive.Ticks, tick => AssertClose(answer, tick.Applied));
            Assert.Equal((null, null, null), (drive.Route, drive.RouteMetres, drive.Truth));
        }

        foreach (FrameLabel label in labels)
        {
            byte[] image = File.ReadAllBytes(Path.Combine(Session(driver), label.Image));
            Assert.Equal(TestPngDecoder.Decode(sent[label.Drive!.BridgeFrame!.Value]).Samples, TestPngDecoder.Decode(image).Samples);
        }
    }

    [Fact]
    public void Recorded_session_is_valid_and_is_labelled_as_a_harvest()
    {
        using ScriptDriver driver = Driven(Recorded);
        DriveInLockStep(driver);
        FrameLabel[] labels = End(driver);
        var session = new SessionReader(Session(driver));

        Assert.Empty(SessionValidator.Validate(session).Problems);
        Assert.Empty(SchemaValidator.Problems(session));
        Assert.All(
            labels,
            label => Assert.Equal([ObjectClass.Car, ObjectClass.Pedestrian], label.Objects.Select(item => item.Class).Order())
        );
        Assert.Equal((280, 210), (labels[0].Camera.Width, labels[0].Camera.Height));
        Assert.StartsWith("drive-", Path.GetFileName(Session(driver)), StringComparison.Ordinal);
    }

    /// <summary>The test's game runs faster than real time, so answers come some ticks late, and frames with them.</summary>
    [Fact]
    public void Frames_of_a_running_game_are_recorded_with_their_answers()
    {
        using ScriptDriver driver = Driven("Record = On\nRecordSeconds = 0.2\n");
        using (SocketClient client = Connect())
        {
            for (int frame = 0; frame < 2 * Steps; frame++)
            {
                Answer(driver, client);
            }

            Until(driver, () => client.Stream.DataAvailable);
        }

        FrameLabel[] labels = End(driver);

        Assert.True(labels.Length > Steps / 2);

        // At most one in each period, counted from the first; one may be early by a quarter of it.
        Assert.Distinct(labels.Select(label => Math.Floor(((label.TimeSeconds - labels[0].TimeSeconds) / 0.2) + 0.25 + LabelTolerance)));
        Assert.All(labels[..^1], label => Assert.Equal(label.Drive!.BridgeFrame, FrameOf(label.Drive.Controls!.Value)));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Late_picture_of_a_running_game_has_the_labels_of_its_moment(int lag)
    {
        using ScriptDriver driver = Driven(
            string.Create(CultureInfo.InvariantCulture, $"Record = On\nRecordSeconds = 0.4\nRecordLag = {lag}\n")
        );
        GameEntity car = driver.Game.Entities[driver.Game.PlayersVehicle];
        driver.Game.PassFrame = () =>
            car.Pose = car.Pose with { Position = car.Pose.Position + (driver.Game.IsFrozen ? default : car.Velocity * TickSeconds) };
        using SocketClient client = Connect();
        for (int frame = 0; frame < 4 * Steps; frame++)
        {
            Answer(driver, client);
        }

        // A paused world is shown as it is.
        DriveInLockStep(driver, client);
        FrameLabel[] labels = End(driver);

        Assert.Empty(SessionValidator.Validate(new SessionReader(Session(driver))).Problems);
        Assert.True(labels.Count(label => label.LagFrames == lag) > Steps / 2);
        Assert.Contains(labels, label => label.LagFrames == 0);
        foreach (FrameLabel label in labels)
        {
            // TestScreen shows the number of the frame in which it was grabbed; the paused game has shown the same for some frames.
            byte level = TestPngDecoder.Decode(File.ReadAllBytes(Path.Combine(Session(driver), label.Image))).Samples[0];
            Assert.Equal(1 + ((label.GameFrame + label.LagFrames) % 255), level);
        }

        // Each tick belongs to one frame, from the frame's moment to that of the next.
        double[] ticks = [.. labels.SelectMany(label => label.Drive!.Ticks.Select(tick => tick.TimeSeconds))];
        Assert.All(ticks.Zip(ticks.Skip(1)), pair => Assert.Equal(TickSeconds, pair.Second - pair.First, LabelTolerance));
        Assert.All(
            labels.Zip(labels.Skip(1)),
            pair => Assert.Equal(pair.Second.TimeSeconds, pair.First.Drive!.Ticks[^1].TimeSeconds, LabelTolerance)
        );
    }

    [Fact]
    public void Silent_client_is_recorded_as_nobody_and_the_brake()
    {
        using ScriptDriver driver = Driven(Recorded);
        using SocketClient client = Connect();
        DriveInLockStep(driver, client);
        client.Send("""{"type":"pause","paused":false}""");
        Until(driver, () => !driver.Game.IsPaused);
        driver.Tick(20);
        FrameLabel[] labels = End(driver);

        DriveTick[] ticks = [.. labels.SelectMany(label => label.Drive!.Ticks)];
        DriveTick[] unled = [.. ticks.Where(tick => tick.Driver == DriverKind.None)];
        Assert.InRange(unled.Length, 5, 20);
        Assert.All(unled, tick => Assert.Equal(new DriveControls(0, 0, 1), tick.Applied));
        Assert.Contains(ticks, tick => tick.Driver == DriverKind.Client);
    }

    [Fact]
    public void Player_who_takes_the_wheel_is_not_recorded()
    {
        using ScriptDriver driver = Driven(Recorded);
        using SocketClient client = Connect();
        DriveInLockStep(driver, client);
        client.Send("""{"type":"pause","paused":false}""");
        Until(driver, () => !driver.Game.IsPaused);
        driver.Tick();
        driver.Game.PlayersControls.Add(Handbrake);
        driver.Tick(5);
        driver.WaitForDisk();
        FrameLabel[] labels = ReadLabels(driver);

        Assert.Contains("The car is yours.", driver.Game.Notifications[^1], StringComparison.Ordinal);
        DriveTick[] ticks = [.. labels.SelectMany(label => label.Drive!.Ticks)];
        Assert.Equal(DriverKind.Client, ticks[^1].Driver);
        Assert.All(ticks.Where(tick => tick.Driver == DriverKind.Client), tick => Assert.Equal(0, tick.Applied!.Value.Brake));
        Assert.Empty(SessionValidator.Validate(new SessionReader(Session(driver))).Problems);
    }

    [Fact]
    public void Drive_without_the_setting_writes_nothing()
    {
        using ScriptDriver driver = Driven();
        DriveInLockStep(driver);
        driver.Press(Keys.N);
        driver.WaitForDisk();

        Assert.Empty(Directory.Exists(driver.Output) ? Directory.GetDirectories(driver.Output) : []);
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("recorded", StringComparison.Ordinal));
    }

    [Fact]
    public void Waiting_without_a_client_writes_nothing()
    {
        using ScriptDriver driver = Driven(Recorded);
        driver.Tick(20);
        driver.Press(Keys.N);
        driver.WaitForDisk();

        Assert.Empty(Directory.Exists(driver.Output) ? Directory.GetDirectories(driver.Output) : []);
    }

    /// <summary>Without a limit, an hour without a client would be one line of 200,000 ticks.</summary>
    [Fact]
    public void Ticks_without_a_client_do_not_pile_up()
    {
        const int limit = 3600;
        using ScriptDriver driver = Driven(Recorded);
        DriveInLockStep(driver);
        driver.Tick(limit + 500);
        DriveLabel last = End(driver)[^1].Drive!;

        Assert.Equal(limit, last.Ticks.Count);
        Assert.Equal(DriverKind.None, last.Ticks[^1].Driver);
    }

    [Fact]
    public void Drive_without_images_is_reported_as_not_recorded()
    {
        using ScriptDriver driver = Driven(Recorded + "Rate = 0.1\n");
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"requestFrame","image":false}""", () => client.Stream.DataAvailable);
        driver.Press(Keys.N);
        driver.WaitForDisk();

        Assert.Contains(driver.Game.Notifications, message => message.Contains("The drive was not recorded", StringComparison.Ordinal));
        Assert.Empty(Directory.Exists(driver.Output) ? Directory.GetDirectories(driver.Output) : []);
    }

    [Theory]
    [InlineData(true, "The session of the drive cannot be begun: ")]
    [InlineData(false, "must stay free")]
    public void Faulty_disk_is_reported_and_the_drive_goes_on(bool isFileInTheWay, string complaint)
    {
        using var driver = new ScriptDriver(Ini(Port) + Recorded + (isFileInTheWay ? "" : "[Harvest]\nMinFree = 1000000\n"));
        if (isFileInTheWay)
        {
            File.WriteAllText(driver.Output, "");
        }

        Street(driver.Game);
        Start(driver);
        using SocketClient client = Connect();
        DriveInLockStep(driver, client);
        Until(driver, () => driver.Game.Notifications.Any(message => message.Contains(complaint, StringComparison.Ordinal)));
        string reported = driver.Game.Notifications.Single(message => message.Contains(complaint, StringComparison.Ordinal));

        Assert.Contains("The drive goes on without a recording.", reported, StringComparison.Ordinal);
        DriveInLockStep(driver, client);
        Assert.NotEmpty(driver.Game.Controls);
    }

    [Fact]
    public void Second_drive_of_a_run_gets_a_session_of_its_own()
    {
        using ScriptDriver driver = Driven(Recorded);
        DriveInLockStep(driver);
        driver.Press(Keys.N);
        driver.WaitForDisk();
        Start(driver);
        DriveInLockStep(driver);
        driver.Press(Keys.N);
        driver.WaitForDisk();

        string[] sessions = Directory.GetDirectories(driver.Output);
        Assert.Equal(2, sessions.Length);
        Assert.All(sessions, session => Assert.True(new SessionReader(session).CountLines() > Steps / 2));
    }

    private static DriveControls AnswerTo(long frame) => new(((frame % 64) - 32) / 64.0, 0.5, 0);

    private static long FrameOf(DriveControls answer) => (long)Math.Round(answer.Steering * 64) + 32;

    private static void AssertClose(DriveControls expected, DriveControls? actual)
    {
        Assert.NotNull(actual);
        Assert.Equal(expected.Steering, actual.Value.Steering, LabelTolerance);
        Assert.Equal(expected.Throttle, actual.Value.Throttle, LabelTolerance);
        Assert.Equal(expected.Brake, actual.Value.Brake, LabelTolerance);
    }

    /// <summary>Waits for a frame and sends the answer to it.</summary>
    private static (long Frame, byte[] Png) Answer(ScriptDriver driver, SocketClient client)
    {
        Until(driver, () => client.Stream.DataAvailable);
        (JsonElement header, byte[] png) = client.Receive();
        long frame = header.GetProperty("frame").GetInt64();
        DriveControls answer = AnswerTo(frame);
        client.Send(
            string.Create(
                CultureInfo.InvariantCulture,
                $$"""{"type":"controls","steering":{{answer.Steering}},"throttle":{{answer.Throttle}},"brake":0,"frame":{{frame}}}"""
            )
        );
        return (frame, png);
    }

    private Dictionary<long, byte[]> DriveInLockStep(ScriptDriver driver)
    {
        using SocketClient client = Connect();
        return DriveInLockStep(driver, client);
    }

    /// <summary>Steps of 0.1 s, each with the answer to the frame before it.</summary>
    /// <returns>The images, by the number of their frame.</returns>
    private static Dictionary<long, byte[]> DriveInLockStep(ScriptDriver driver, SocketClient client)
    {
        var sent = new Dictionary<long, byte[]>();
        Say(driver, client, """{"type":"pause","paused":true}""", () => driver.Game.IsPaused);
        client.Send("""{"type":"requestFrame"}""");
        for (int step = 0; step < Steps; step++)
        {
            (long frame, byte[] png) = Answer(driver, client);
            sent[frame] = png;
            client.Send("""{"type":"step","seconds":0.1}""");
        }

        Until(driver, () => client.Stream.DataAvailable);
        (JsonElement header, byte[] last) = client.Receive();
        sent[header.GetProperty("frame").GetInt64()] = last;
        return sent;
    }

    private static FrameLabel[] End(ScriptDriver driver)
    {
        driver.Press(Keys.N);
        driver.WaitForDisk();
        FrameLabel[] labels = ReadLabels(driver);
        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains($"The drive was recorded: {labels.Length} frames, in ", StringComparison.Ordinal)
        );
        return labels;
    }

    private static string Session(ScriptDriver driver) => Assert.Single(Directory.GetDirectories(driver.Output));

    private static FrameLabel[] ReadLabels(ScriptDriver driver) => [.. new SessionReader(Session(driver)).ReadLabels()];
}
