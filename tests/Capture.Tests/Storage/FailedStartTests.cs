using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

/// <summary>A harvest that fails before its first frame leaves no folder, unless it holds something else.</summary>
public sealed class FailedStartTests : IDisposable
{
    private static readonly SessionOrigin Origin = new() { Game = "test", Tool = "tests 1.0" };
    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Session_that_fails_before_its_first_frame_leaves_no_folder()
    {
        Write("It failed.");

        Assert.False(Directory.Exists(_folder.Session));
    }

    [Fact]
    public void Session_without_a_fault_keeps_its_folder()
    {
        Write(null);

        Assert.Contains("\"complete\"", _folder.Text("session.json"), StringComparison.Ordinal);
    }

    [Fact]
    public void Session_that_counted_discards_keeps_its_folder()
    {
        Write("It failed.", discards: 3);

        Assert.Contains("\"black\": 3", _folder.Text("session.json"), StringComparison.Ordinal);
    }

    [Fact]
    public void Session_whose_writer_is_not_asked_for_it_keeps_its_folder()
    {
        Write("It failed.", removes: false);

        Assert.Contains("It failed.", _folder.Text("session.json"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("notes.txt")]
    [InlineData("frames/000000.png")]
    public void Folder_with_another_file_stays_as_it_is(string name)
    {
        Write("It failed.", before: () => File.WriteAllText(Path.Combine(_folder.Session, name), "mine"));

        Assert.Equal("mine", _folder.Text(name));
        Assert.Contains("It failed.", _folder.Text("session.json"), StringComparison.Ordinal);
    }

    [PosixFact]
    public void Folder_with_a_link_stays_as_it_is()
    {
        string others = Directory.CreateDirectory(Path.Combine(_folder.Path, "others")).FullName;
        File.WriteAllText(Path.Combine(others, "empty"), string.Empty);
        Write("It failed.", before: () => Directory.CreateSymbolicLink(Path.Combine(_folder.Session, "link"), others));

        Assert.True(File.Exists(Path.Combine(others, "empty")));
        Assert.True(File.Exists(Path.Combine(_folder.Session, "session.json")));
    }

    private void Write(string? fault, int discards = 0, bool removes = true, Action? before = null)
    {
        using var writer = new SessionWriter(_folder.Session, Origin) { RemovesFailedStart = removes };
        var camera = new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 50, 0.1, 4.0 / 3);
        writer.Open(new SessionStart(new HarvestOptions { Image = new ImageSize(64, 48), Masks = true }, 0, 0, camera));
        while (!File.Exists(Path.Combine(_folder.Session, "session.json")))
        {
            Thread.Sleep(1);
        }

        before?.Invoke();
        KeyValuePair<string, int>[] discarded = discards == 0 ? [] : [new("black", discards)];
        writer.Close(new SessionEnd(1, 0.1, 0, discarded, [], null, fault));
    }
}
