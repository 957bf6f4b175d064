using Harvester.Capture.Storage;

namespace Harvester.Capture.Tests.Storage;

/// <summary>What resuming finds in a session whose last moment lacks views.</summary>
public sealed class WholeMomentTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(6, 3, 6)]
    [InlineData(7, 3, 6)]
    [InlineData(8, 3, 6)]
    [InlineData(2, 3, 0)]
    [InlineData(7, 1, 7)]
    public void Incomplete_last_moment_is_cut_off(int lines, int views, int kept)
    {
        string labels = Path.Combine(_folder, "labels.jsonl");
        string[] all = [.. Enumerable.Range(0, lines).Select(frame => $$"""{"frame":{{frame}},"objects":[]}""")];
        File.WriteAllText(labels, string.Concat(all.Select(line => line + "\n")) + "{\"frame\":");

        SessionContent content = SessionContent.Read(_folder, views);

        Assert.Equal((kept, kept - 1), (content.Frames, content.LastFrame));
        Assert.Equal(all.Take(kept), File.ReadAllLines(labels));
    }
}
