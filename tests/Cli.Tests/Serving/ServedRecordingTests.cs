using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Serving;

/// <summary>
/// Recordings of a game served in real time. A client drives until some frames are recorded with its answers, however long that takes; only
/// the deadline, for a test that would never end, is a time.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class ServedRecordingTests : IDisposable
{
    private const int Answered = 3;

    /// <summary>Times have six decimals.</summary>
    private const double Rounding = 2e-6;

    private static readonly TimeSpan Deadline = TimeSpan.FromSeconds(60);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Drive_over_the_socket_in_real_time_is_recorded()
    {
        int number = FreePort.Find();
        string port = number.ToString(CultureInfo.InvariantCulture);
        await RecordAsync(["--port", port], ["--bridge", "socket", "--at", $"{IPAddress.Loopback}:{port}"], () => IsListening(number));
    }

    [Fact]
    public async Task Drive_over_the_shared_folder_is_recorded()
    {
        string shared = _folder.PathOf("shared");
        await RecordAsync(
            ["--folder", shared],
            ["--bridge", "folder", "--folder", shared],
            () => File.Exists(Path.Combine(shared, "bridge.json"))
        );
    }

    private static bool IsListening(int port)
    {
        try
        {
            using TcpClient connection = new();
            connection.Connect(IPAddress.Loopback, port);
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }

    private async Task RecordAsync(string[] bridge, string[] client, Func<bool> isOpen)
    {
        string session = _folder.PathOf("session");
        using CancellationTokenSource stopping = new();
        using CancellationTokenSource leaving = new();
        Task<CliRun> serve = CliRun.BesideAsync(
            stopping.Token,
            ["serve", "--record", session, "--size", "80x60", "--traffic", "0", "--seed", "1", .. bridge]
        );
        DateTime deadline = DateTime.UtcNow + Deadline;
        while (!isOpen() && !serve.IsCompleted && DateTime.UtcNow < deadline)
        {
            await Task.Delay(20);
        }

        Task<CliRun> drive = CliRun.BesideAsync(leaving.Token, ["drive", "--role", "client", .. client]);
        while (AnsweredIn(session) < Answered && !serve.IsCompleted && !drive.IsCompleted && DateTime.UtcNow < deadline)
        {
            await Task.Delay(20);
        }

        await leaving.CancelAsync();
        CliRun driven = await drive;
        await stopping.CancelAsync();
        CliRun served = await serve;

        Assert.Equal((ExitCode.Cancelled, "", ""), (served.ExitCode, served.Error, driven.Error));
        CliRun.Of("validate", session, "--schema").AssertDone();
        IEnumerable<string> lines = File.ReadLines(Path.Combine(session, "labels.jsonl"));
        CheckActions([.. lines.Select(line => JsonDocument.Parse(line).RootElement)]);
    }

    private static void CheckActions(JsonElement[] lines)
    {
        JsonElement[] drives = [.. lines.Select(line => line.GetProperty("drive"))];
        long[] frames = [.. drives.Select(drive => drive.GetProperty("bridgeFrame").GetInt64())];
        Assert.Equal(frames.Order().Distinct(), frames);
        int answered = 0;
        foreach ((JsonElement line, JsonElement next) in lines.Zip(lines.Skip(1)))
        {
            JsonElement drive = line.GetProperty("drive");
            double[] ticks = [.. drive.GetProperty("ticks").EnumerateArray().Select(tick => Number(tick, "timeSeconds"))];
            Assert.Equal(ticks.Order(), ticks);
            Assert.Equal(Number(next, "timeSeconds"), ticks[^1], Rounding);
            if (IsAnswered(drive))
            {
                // An answer that came after the next frame was sent would be that frame's.
                answered++;
                Assert.InRange(Number(drive, "answerSeconds"), 0, ticks[^1] - Number(line, "timeSeconds") + Rounding);
            }
        }

        Assert.True(answered >= Answered - 1, $"{answered} answered frames");
    }

    private static bool IsAnswered(JsonElement drive) =>
        drive.GetProperty("driver").GetString() == "client" && drive.GetProperty("controls").ValueKind == JsonValueKind.Object;

    private static double Number(JsonElement of, string name) => of.GetProperty(name).GetDouble();

    /// <summary>Number of whole lines with an answer of the client, while the session is written.</summary>
    private static int AnsweredIn(string session)
    {
        string labels = Path.Combine(session, "labels.jsonl");
        if (!File.Exists(labels))
        {
            return 0;
        }

        using var file = new FileStream(labels, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        using var reader = new StreamReader(file);
        string text = reader.ReadToEnd();
        return text[..(text.LastIndexOf('\n') + 1)]
            .Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Count(line => IsAnswered(JsonDocument.Parse(line).RootElement.GetProperty("drive")));
    }
}
