using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
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
        string port = FreePort.Find().ToString(CultureInfo.InvariantCulture);
        Task<CliRun> serve = Task.Run(() => CliRun.Of("serve", "--port", port, "--duration", "3", "--traffic", "0", "--size", "80x60"));
        int client = await HailAsync(int.Parse(port, CultureInfo.InvariantCulture), serve);
        CliRun run = await serve;

        Assert.Equal(ExitCode.Done, run.ExitCode);
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

        serve
            .AssertFailed(
                ExitCode.Usage,
                $"'{folder.Path}' has files that are not a bridge's, e.g. '{foreign}'. Name another folder with --folder.");
        drive.AssertFailed(ExitCode.Usage, "has files that are not a bridge's");
        Assert.Equal(
            files.Order(StringComparer.Ordinal),
            Directory.EnumerateFileSystemEntries(folder.Path).Select(Path.GetFileName).Order(StringComparer.Ordinal));
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
            ExitCode.Done, CliRun.Of("serve", "--folder", folder.Path, "--duration", "0.1", "--traffic", "0", "--size", "80x60").ExitCode);
    }

    [Theory]
    [InlineData("--address", "0.0.0.0", "token")]
    [InlineData("--address", "here", "'here'")]
    [InlineData("--controller", "rails", "'rails'")]
    [InlineData("--weather", "hail", "'hail'")]
    [InlineData("--duration", "0", "greater than 0")]
    public void Impossible_option_value_is_refused(string option, string value, string message) =>
        CliRun.Of("serve", option, value).AssertFailed(ExitCode.Usage, message);

    /// <summary>
    /// Connects, sends a weather that the game does not have, and waits for the end of the connection; returns its own port.
    /// </summary>
    private static async Task<int> HailAsync(int port, Task serve)
    {
        while (true)
        {
            using var connection = new TcpClient();
            try
            {
                await connection.ConnectAsync(IPAddress.Loopback, port);
            }
            catch (SocketException) when (!serve.IsCompleted)
            {
                await Task.Delay(20);
                continue;
            }

            NetworkStream stream = connection.GetStream();
            await SendAsync(stream, """{"type":"hello","version":1}""");

            // Long enough for a tick of the game to see the connection.
            await Task.Delay(300);
            await SendAsync(stream, """{"type":"environment","weather":"hail"}""");
            byte[] answer = new byte[65_536];
            while (await stream.ReadAsync(answer) > 0)
            {
            }

            return ((IPEndPoint)connection.Client.LocalEndPoint!).Port;
        }
    }

    private static async Task SendAsync(NetworkStream stream, string json)
    {
        byte[] header = Encoding.UTF8.GetBytes(json);
        await stream.WriteAsync((byte[])[0, 0, 0, (byte)header.Length, 0, 0, 0, 0, .. header]);
    }
}
