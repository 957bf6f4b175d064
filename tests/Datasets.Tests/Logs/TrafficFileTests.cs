using System.Text.RegularExpressions;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Tests.Logs;

/// <summary>The file of a log's traffic.</summary>
public sealed class TrafficFileTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Fact]
    public void File_has_what_was_written()
    {
        MotionLog log = Written();
        MotionLog read = TrafficFile.Read(_path);

        Assert.Equal((log.Id, log.Ego), (read.Id, read.Ego));
        Assert.Equal(log.Times, read.Times);
        foreach ((LogTrack one, LogTrack other) in log.Tracks.Zip(read.Tracks))
        {
            Assert.Equal((one.Id, one.Kind), (other.Id, other.Kind));
            Assert.Equal(one.States, other.States);
        }

        Assert.Equal(log.Signals.Select(step => step.Single().Light), read.Signals.Select(step => step.Single().Light));
    }

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData("\"version\":1", "\"version\":2", "it is no file of traffic of version 1, which 'harvester log import' writes.")]
    [InlineData("\"times\":\\[0,0.1", "\"times\":[0,0", "times do not rise.")]
    [InlineData("\"ego\":7", "\"ego\":8", "ego is 8, which is no vehicle of tracks.")]
    [InlineData("\"id\":8", "\"id\":7", "two tracks have the same id.")]
    [InlineData("\"firstStep\":1", "\"firstStep\":2", "a track has states before the first or after the last of times, or none.")]
    [InlineData("\"firstStep\":0", "\"firstStep\":-1", "a track has states before the first or after the last of times, or none.")]
    [InlineData("\"kind\":\"pedestrian\"", "\"kind\":\"horse\"", "the kind of a track is not vehicle, pedestrian or cyclist.")]
    [InlineData(
        "\\[1,2,3,4",
        "[1e300,2,3,4",
        "a state of a track has a place, size, heading or velocity beyond the limits of docs/logs.md."
    )]
    [InlineData("\\[1,2,3,4", "[1,2,3", "a state of a track is not a list of 9 numbers.")]
    [InlineData("\"states\":\\[4,", "\"states\":[9,", "a light has an unknown state.")]
    [InlineData("\"states\":\\[4,", "\"states\":[", "a light has not as many states as there are times.")]
    public void Damage_is_one_clear_line(string pattern, string replacement, string expected)
    {
        Written();
        string text = File.ReadAllText(_path);
        string damaged = new Regex(pattern, RegexOptions.CultureInvariant).Replace(text, replacement, 1);
        Assert.NotEqual(text, damaged);
        File.WriteAllText(_path, damaged);

        string message = Assert.Throws<DatasetFormatException>(() => TrafficFile.Read(_path)).Message;
        Assert.StartsWith($"{_path}: {expected}", message, StringComparison.Ordinal);
    }

    private MotionLog Written()
    {
        var state = new LogState(new Vector3D(1, 2, 3), 4, 2, 1.5, 0.25, new Vector2D(5, -1));
        MotionLog log = new(
            "a log",
            [0, 0.1, 0.2],
            [
                new LogTrack(7, TrafficLogKind.Vehicle, [state, null, state with { Heading = -3 }]),
                new LogTrack(8, TrafficLogKind.Pedestrian, [null, state, state]),
            ],
            0,
            [],
            [
                [Light(LogLight.Stop)],
                [Light(LogLight.Unknown)],
                [Light(LogLight.Go)],
            ]
        );
        using FileStream stream = File.Create(_path);
        TrafficFile.Write(stream, log, "log.json");
        return log;

        static LogSignal Light(LogLight light) => new(12, light, new Vector3D(9, 8, 7));
    }
}
