using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class ServeCommandTests
{
    [Fact]
    public void Served_game_reports_its_address_and_progress()
    {
        CliRun run = CliRun.Of("serve", "--port", "0", "--duration", "0.5", "--traffic", "0");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        // Pictures at 0.0, 0.1 and so on to 0.5 s.
        Assert.Matches(@"^Serving at 127\.0\.0\.1:\d+\n6 frames, \d+ m driven in 0\.5 s\n$", run.Out);
    }

    [Fact]
    public async Task Served_game_reports_connections_and_client_errors()
    {
        IPEndPoint at = new(IPAddress.Loopback, FreePort.Find());
        using CancellationTokenSource stopping = new();
        Task<CliRun> serve = CliRun.BesideAsync(
            stopping.Token,
            "serve",
            "--port",
            at.Port.ToString(CultureInfo.InvariantCulture),
            "--traffic",
            "0",
            "--size",
            "80x60"
        );
        int client;
        using (SocketClient hailing = await ConnectAsync(at, serve))
        {
            client = hailing.LocalPort;
            AwaitTick(hailing);
            hailing.Send("""{"type":"environment","weather":"hail"}""");
            Assert.True(hailing.IsCutOff());
        }

        using (SocketClient next = await ConnectAsync(at, serve))
        {
            AwaitTick(next);
        }

        await stopping.CancelAsync();
        CliRun run = await serve;

        Assert.Equal(ExitCode.Cancelled, run.ExitCode);
        Assert.Contains($"\nConnected: 127.0.0.1:{client}\nDisconnected: 127.0.0.1:{client}\n", run.Out, StringComparison.Ordinal);
        Assert.Contains("'hail', which is not one of clear, ", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Shared_folder_gets_pictures_and_state()
    {
        using var folder = new TemporaryFolder();
        CliRun run = CliRun.Of("serve", "--folder", folder.Path, "--duration", "0.5", "--traffic", "0", "--size", "80x60");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(13, File.ReadLines(Path.Combine(folder.Path, "state.txt")).First().Split(' ').Length);
        Assert.NotEmpty(Directory.GetFiles(folder.Path, "frame_*.png"));
    }

    [Theory]
    [InlineData("session.json", "state.txt")]
    [InlineData("export.json")]
    [InlineData("drive.json")]
    [InlineData("holiday.png")]
    [InlineData("frame_00000001.png")]
    [InlineData("holiday.png", "frame_00000001.png")]
    [InlineData("session.json", "alive.txt", "frame_00000001.png")]
    public void Shared_folder_with_other_files_is_refused_and_left_unchanged(string foreign, params string[] others)
    {
        using var folder = new TemporaryFolder();
        string[] files = [foreign, .. others];
        foreach (string file in files)
        {
            folder.File(file, "mine");
        }

        CliRun serve = CliRun.Of("serve", "--folder", folder.Path, "--duration", "0.1");
        CliRun drive = CliRun.Of("drive", "--out", folder.PathOf("out"), "--bridge", "folder", "--folder", folder.Path, "--distance", "1");

        serve.AssertFailed(
            ExitCode.Usage,
            $"'{folder.Path}' has files that are not a bridge's, e.g. '{foreign}'. Name another folder with --folder."
        );
        drive.AssertFailed(ExitCode.Usage, "has files that are not a bridge's");
        Assert.Equal(
            files.Order(StringComparer.Ordinal),
            Directory.EnumerateFileSystemEntries(folder.Path).Select(Path.GetFileName).Order(StringComparer.Ordinal)
        );
    }

    [Theory]
    [InlineData("one", "one")]
    [InlineData("one", "one/session")]
    [InlineData("one/bridge", "one")]
    public void Recording_and_bridge_within_each_other_are_refused(string bridge, string session)
    {
        using var folder = new TemporaryFolder();

        CliRun
            .Of("serve", "--folder", folder.PathOf(bridge), "--record", folder.PathOf(session))
            .AssertFailed(ExitCode.Usage, bridge == session ? "name the same folder, '" : ", is inside that of --");
        Assert.Empty(Directory.EnumerateFileSystemEntries(folder.Path));
    }

    [Theory]
    [InlineData("controls.txt.tmp")]
    [InlineData("state.txt.0123456789abcdef.partial")]
    [InlineData("frame_00000007.png.0123456789abcdef.partial")]
    public void Shared_folder_of_a_waiting_client_or_killed_game_is_reused(string sign)
    {
        using var folder = new TemporaryFolder();
        folder.File(sign, "");
        folder.File("notes.txt", "mine");

        Assert.Equal(
            ExitCode.Done,
            CliRun.Of("serve", "--folder", folder.Path, "--duration", "0.1", "--traffic", "0", "--size", "80x60").ExitCode
        );
    }

    [Theory]
    [InlineData("--address", "0.0.0.0", "token")]
    [InlineData("--address", "here", "'here'")]
    [InlineData("--controller", "rails", "'rails'")]
    [InlineData("--weather", "hail", "'hail'")]
    [InlineData("--duration", "0", "greater than 0")]
    [InlineData("--record-every", "0.2", "--record-every needs --record.")]
    public void Impossible_option_value_is_refused(string option, string value, string message) =>
        CliRun.Of("serve", option, value).AssertFailed(ExitCode.Usage, message);

    /// <summary>Connects as soon as the game listens.</summary>
    private static async Task<SocketClient> ConnectAsync(IPEndPoint at, Task serve)
    {
        while (true)
        {
            try
            {
                return new SocketClient(at);
            }
            catch (SocketException) when (!serve.IsCompleted)
            {
                await Task.Delay(20);
            }
        }
    }

    /// <summary>Waits until the game has finished a tick with this client: the tick of the first frame has when the second comes.</summary>
    private static void AwaitTick(SocketClient client)
    {
        for (int frame = 0; frame < 2; frame++)
        {
            client.Send("""{"type":"requestFrame"}""");
            Assert.Equal("frame", client.Receive().Header.GetProperty("type").GetString());
        }
    }
}
