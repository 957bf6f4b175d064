using System.Text.Json;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;

namespace Harvester.Sessions.Tests.Plans;

public sealed class HeartbeatTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("heartbeat").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void File_has_process_time_state_trial_and_frames()
    {
        var file = new HeartbeatFile(_folder, "p", Shard.Whole);
        file.End(HeartbeatState.Finished, 12);
        file.Wait();

        using JsonDocument beat = JsonDocument.Parse(File.ReadAllText(Path.Combine(_folder, "heartbeat.json")));
        Assert.Equal(Environment.ProcessId, beat.RootElement.GetProperty("process").GetInt32());
        Assert.Equal("finished", beat.RootElement.GetProperty("state").GetString());
        Assert.Equal(12, beat.RootElement.GetProperty("frames").GetInt32());
        Assert.Equal(JsonValueKind.Null, beat.RootElement.GetProperty("trial").ValueKind);
        DateTime time = beat.RootElement.GetProperty("time").GetDateTime();
        Assert.Equal(DateTimeKind.Utc, time.Kind);
        Assert.InRange(DateTime.UtcNow - time, TimeSpan.Zero, TimeSpan.FromMinutes(1));
    }

    [Fact]
    public void Beats_within_a_second_are_not_written()
    {
        var file = new HeartbeatFile(_folder, "p", Shard.Whole);
        file.Beat(HeartbeatState.Starting, "a", 0);
        string path = Path.Combine(_folder, "heartbeat.json");
        SpinWait.SpinUntil(() => File.Exists(path), TimeSpan.FromSeconds(30));
        for (int frame = 1; frame < 100; frame++)
        {
            file.Beat(HeartbeatState.Running, "a", frame);
        }

        Assert.Contains("\"frames\":0", File.ReadAllText(path), StringComparison.Ordinal);
    }

    [Fact]
    public void Folder_that_cannot_be_written_does_no_harm()
    {
        var file = new HeartbeatFile(Path.Combine(_folder, "missing"), "p", Shard.Whole);
        file.End(HeartbeatState.Failed, 0);
        file.Wait();
        Assert.Empty(Directory.GetFileSystemEntries(_folder));
    }
}
