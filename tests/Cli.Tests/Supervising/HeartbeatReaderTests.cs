using Harvester.Runs.Supervising;
using Harvester.Sessions.Plans;

namespace Harvester.Cli.Tests.Supervising;

/// <summary>heartbeat.json as a program writes it, and as a damaged or hostile one leaves it.</summary>
public sealed class HeartbeatReaderTests : IDisposable
{
    private const string Good =
        """{"process": 12, "time": "2026-01-02T12:00:00.5Z", "state": "running", "trial": "rain-3", "frames": 4000000000}""";

    private readonly TemporaryFolder _folder = new();

    private string Path => _folder.PathOf("heartbeat.json");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Every_field_is_read() =>
        Assert.Equal(
            new SeenHeartbeat(
                12,
                new DateTime(2026, 1, 2, 12, 0, 0, 500, DateTimeKind.Utc),
                HeartbeatState.Running,
                "rain-3",
                4_000_000_000
            ),
            ReadText(Good).Heartbeat
        );

    [Theory]
    [InlineData(", \"trial\": \"rain-3\"", "", "")]
    [InlineData("\"rain-3\"", "null", "")]
    [InlineData("\"rain-3\"", "3", "3")]
    public void Trial_may_be_missing_or_a_number(string from, string to, string trial) =>
        Assert.Equal(trial, ReadText(Good.Replace(from, to, StringComparison.Ordinal)).Heartbeat?.Trial);

    [Theory]
    [InlineData("12", "1.5")]
    [InlineData("12", "\"12\"")]
    [InlineData("12", "99999999999")]
    [InlineData("running", "dancing")]
    [InlineData("2026-01-02T12:00:00.5Z", "noon")]
    [InlineData("4000000000", "-1")]
    [InlineData("4000000000", "1e300")]
    [InlineData("\"frames\"", "\"process\"")]
    [InlineData("}", "")]
    [InlineData("{", "[")]
    public void Damaged_file_has_no_heartbeat_but_a_problem(string from, string to)
    {
        HeartbeatReading reading = ReadText(Good.Replace(from, to, StringComparison.Ordinal));

        Assert.Null(reading.Heartbeat);
        Assert.NotNull(reading.Problem);
    }

    [Fact]
    public void Missing_file_is_no_problem() => Assert.Equal(HeartbeatReading.Missing, HeartbeatReader.Read(Path));

    [Fact]
    public void Large_file_is_not_read() => Assert.Equal("It has more than 65536 bytes.", ReadText(Good + new string(' ', 70_000)).Problem);

    [Fact]
    public void Link_is_not_followed()
    {
        File.WriteAllText(_folder.PathOf("real.json"), Good);
        File.CreateSymbolicLink(Path, _folder.PathOf("real.json"));

        Assert.Equal("It is a link, which is not followed.", HeartbeatReader.Read(Path).Problem);
    }

    [Fact]
    public void Folder_in_its_place_is_a_problem()
    {
        Directory.CreateDirectory(Path);

        Assert.NotNull(HeartbeatReader.Read(Path).Problem);
    }

    private HeartbeatReading ReadText(string text)
    {
        File.WriteAllText(Path, text);
        return HeartbeatReader.Read(Path);
    }
}
