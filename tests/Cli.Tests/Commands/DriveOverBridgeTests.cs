using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>harvester drive with something between game and controller, and what goes wrong there.</summary>
public sealed class DriveOverBridgeTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("socket")]
    [InlineData("folder")]
    [Trait("Category", "Heavy")]
    public void Drive_over_a_bridge_is_driven_by_its_client(string bridge)
    {
        CliRun run = CliRun.Of(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            bridge,
            "--distance",
            "45",
            "--traffic",
            "0",
            "--seed",
            "4"
        );

        Assert.Equal("", run.Error);
        using JsonDocument record = JsonDocument.Parse(File.ReadAllText(_folder.PathOf("out/drive.json")));
        JsonElement figures = record.RootElement.GetProperty("figures");

        // The car begins in a lane; without its client it would stand there and brake.
        Assert.InRange(figures.GetProperty("controllerMetres").GetDouble(), 30, 50);
        Assert.Equal(0, figures.GetProperty("laneDepartures").GetInt32());
        Assert.InRange(figures.GetProperty("largestLateralError").GetDouble(), 0, 0.5);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public async Task Client_and_game_in_separate_processes_drive_and_exit_cleanly()
    {
        string at = FreePlace();
        Task<CliRun> game = CliRun.BesideAsync(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "socket",
            "--role",
            "game",
            "--at",
            at,
            "--distance",
            "8",
            "--traffic",
            "0",
            "--seed",
            "4"
        );
        CliRun client = await ClientOf(at);

        Assert.Equal((0, ""), (client.ExitCode, client.Error));
        Assert.Matches(@"^\d+ frames answered, \d+ m driven in \d+ s; the game has closed the bridge\n$", client.Out);
        CliRun run = await game;
        Assert.Equal((0, ""), (run.ExitCode, run.Error));
        Assert.StartsWith($"Waiting up to 60 s for a client at {at}\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public async Task Folder_client_started_after_the_first_frame_drives_the_game()
    {
        string shared = _folder.PathOf("shared");
        Task<CliRun> game = CliRun.BesideAsync(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "folder",
            "--role",
            "game",
            "--folder",
            shared,
            "--distance",
            "4",
            "--traffic",
            "0",
            "--seed",
            "4"
        );
        while (!File.Exists(Path.Combine(shared, "state.txt")) && !game.IsCompleted)
        {
            await Task.Delay(10);
        }

        using CancellationTokenSource stopping = new();
        Task<CliRun> client = CliRun.BesideAsync(stopping.Token, "drive", "--bridge", "folder", "--role", "client", "--folder", shared);
        CliRun run = await game;
        stopping.Cancel();
        await client;

        Assert.Equal((0, ""), (run.ExitCode, run.Error));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Locks_of_a_killed_drive_are_no_files_of_others()
    {
        string lockFile = _folder.PathOf("out/.bridge.harvester-lock");
        Directory.CreateDirectory(_folder.PathOf("out/bridge"));
        File.WriteAllText(lockFile, "");
        File.WriteAllText(lockFile + ".txt", "process 1");

        CliRun
            .Of("drive", "--out", _folder.PathOf("out"), "--bridge", "folder", "--distance", "3", "--traffic", "0", "--seed", "4")
            .AssertDone();
    }

    [Fact]
    public async Task Client_with_a_wrong_token_gets_an_error_and_the_game_stops()
    {
        string at = FreePlace();
        using CancellationTokenSource stopping = new();
        Task<CliRun> game = CliRun.BesideAsync(
            stopping.Token,
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "socket",
            "--role",
            "game",
            "--at",
            at,
            "--token",
            "sesame",
            "--traffic",
            "0"
        );
        CliRun client = await ClientOf(at, "--token", "simsim");
        client.AssertFailed(ExitCode.InputOutput, "the first message must be a hello with the right token");
        stopping.Cancel();

        Assert.Equal(ExitCode.Cancelled, (await game).ExitCode);
    }

    [Fact]
    public void Game_without_a_client_gives_up()
    {
        CliRun run = CliRun.Of(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "folder",
            "--role",
            "game",
            "--patience",
            "0.2",
            "--traffic",
            "0"
        );

        Assert.Equal((ExitCode.InputOutput, "harvester: No client has driven for 0.2 s.\n"), (run.ExitCode, run.Error));
    }

    [Fact]
    public void Default_shared_folder_may_also_be_named()
    {
        CliRun run = CliRun.Of(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "folder",
            "--folder",
            _folder.PathOf("out/bridge/"),
            "--role",
            "game",
            "--patience",
            "0.2",
            "--traffic",
            "0"
        );

        Assert.Equal((ExitCode.InputOutput, "harvester: No client has driven for 0.2 s.\n"), (run.ExitCode, run.Error));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public async Task Game_that_loses_its_client_keeps_the_record()
    {
        string shared = _folder.PathOf("shared");
        Task<CliRun> game = CliRun.BesideAsync(
            "drive",
            "--out",
            _folder.PathOf("out"),
            "--bridge",
            "folder",
            "--role",
            "game",
            "--folder",
            shared,
            "--patience",
            "5",
            "--traffic",
            "0"
        );
        while (!File.Exists(Path.Combine(shared, "state.txt")) && !game.IsCompleted)
        {
            await Task.Delay(10);
        }

        // One word, and never another.
        File.WriteAllText(_folder.PathOf("new"), "0 0.3 0\n");
        File.Move(_folder.PathOf("new"), Path.Combine(shared, "controls.txt"));
        CliRun run = await game;

        Assert.Equal((ExitCode.InputOutput, "harvester: No client has driven for 5 s.\n"), (run.ExitCode, run.Error));
        using JsonDocument record = JsonDocument.Parse(File.ReadAllText(_folder.PathOf("out/drive.json")));
        Assert.True(record.RootElement.GetProperty("figures").GetProperty("metres").GetDouble() > 0);
        Assert.True(File.Exists(_folder.PathOf("out/report.html")));
        Assert.Contains("Stopped after ", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Client_without_frames_gives_up()
    {
        CliRun run = CliRun.Of("drive", "--bridge", "folder", "--role", "client", "--folder", _folder.Path, "--patience", "0.2");

        run.AssertFailed(ExitCode.InputOutput, "No frame has arrived from the game for 0.2 s.");
    }

    [Fact]
    public void Client_without_a_game_fails() =>
        CliRun
            .Of("drive", "--bridge", "socket", "--role", "client", "--at", "127.0.0.1:9")
            .AssertFailed(ExitCode.InputOutput, "Cannot connect to 127.0.0.1:9");

    [Fact]
    public void Client_of_a_missing_folder_fails() =>
        CliRun
            .Of("drive", "--bridge", "folder", "--role", "client", "--folder", _folder.PathOf("none"))
            .AssertFailed(ExitCode.InputOutput, _folder.PathOf("none"));

    [Fact]
    public void Port_in_use_is_reported()
    {
        using TcpListener other = new(IPAddress.Loopback, 0);
        other.Start();

        CliRun
            .Of("drive", "--out", _folder.PathOf("out"), "--bridge", "socket", "--at", other.LocalEndpoint.ToString()!)
            .AssertFailed(ExitCode.InputOutput, $"Cannot listen on {other.LocalEndpoint}");
    }

    [Fact]
    public void Shared_folder_that_is_a_file_is_reported()
    {
        File.WriteAllText(_folder.PathOf("file"), "");

        CliRun
            .Of("drive", "--out", _folder.PathOf("out"), "--bridge", "folder", "--folder", _folder.PathOf("file"))
            .AssertFailed(ExitCode.InputOutput, _folder.PathOf("file"));
    }

    [Theory]
    [InlineData("--role and --bridge", "--role game and --role client need --bridge", "--role", "client")]
    [InlineData("--bridge", "--bridge takes direct, folder or socket, not 'usb'", "--bridge", "usb")]
    [InlineData("--role", "--role takes both, game or client, not 'none'", "--role", "none")]
    [InlineData("--at", "--at takes an IP address with a port, e.g. 127.0.0.1:4567, not 'here'", "--bridge", "socket", "--at", "here")]
    [InlineData(
        "no token",
        "0.0.0.0 is reachable from other machines; set a --token",
        "--bridge",
        "socket",
        "--role",
        "game",
        "--at",
        "0.0.0.0:4567"
    )]
    [InlineData("no bridge", "--token needs --bridge", "--token", "sesame")]
    [InlineData("--patience", "--patience takes a number greater than 0", "--bridge", "socket", "--patience", "0")]
    public void Impossible_options_are_refused(string what, string message, params string[] options)
    {
        Assert.NotEmpty(what);
        CliRun.Of(["drive", "--out", _folder.PathOf("out"), .. options]).AssertFailed(ExitCode.Usage, message);
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>Runs a client as soon as the game listens.</summary>
    private static async Task<CliRun> ClientOf(string at, params string[] more)
    {
        DateTime deadline = DateTime.UtcNow.AddSeconds(60);
        CliRun run;
        do
        {
            run = await CliRun.BesideAsync(["drive", "--bridge", "socket", "--role", "client", "--at", at, .. more]);
        } while (run.Error.Contains("Cannot connect to", StringComparison.Ordinal) && DateTime.UtcNow < deadline);
        return run;
    }

    private static string FreePlace() => new IPEndPoint(IPAddress.Loopback, FreePort.Find()).ToString();
}
