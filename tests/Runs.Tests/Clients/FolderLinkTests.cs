using System.Text.RegularExpressions;
using Harvester.Capture.Ports;
using Harvester.Runs.Clients;

namespace Harvester.Runs.Tests.Clients;

public sealed class FolderLinkTests : IDisposable
{
    private const string Indicators = "0 -7 3.5 7 75 75 -9.5 -2 2 9.5 75 75 75\n";
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan Little = TimeSpan.FromMilliseconds(10);
    private readonly string _folder = Directory.CreateTempSubdirectory().FullName;

    [Fact]
    public void Missing_folder_is_reported()
    {
        string missing = Path.Combine(_folder, "none");

        Assert.Contains(missing, Assert.Throws<IOException>(() => new FolderLink(missing)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Client_begins_with_a_hello_that_resumes_a_paused_world()
    {
        using FolderLink link = new(_folder);

        Assert.Equal("""{"type":"hello","version":1}""", File.ReadAllText(Path.Combine(_folder, "command.json")).TrimEnd());
    }

    [Fact]
    public void Frame_is_requested_by_hello_until_the_first_arrives()
    {
        using FolderLink link = new(_folder);
        string first = File.ReadAllText(Path.Combine(_folder, "command.json"));
        link.AskForFrame();
        string again = File.ReadAllText(Path.Combine(_folder, "command.json"));
        Assert.NotEqual(first, again);
        Assert.Equal("""{"type":"hello","version":1}""", again.TrimEnd());

        Write(Indicators + "3 0.3 5 1 frame_00000003.png -0.05\n");
        Assert.NotNull(link.Receive(Ample));
        link.AskForFrame();
        Assert.Equal("""{"type":"requestFrame"}""", File.ReadAllText(Path.Combine(_folder, "command.json")).TrimEnd());
    }

    [Fact]
    public void Receive_gives_each_new_state_once_and_none_from_before()
    {
        Write(Indicators + "3 0.3 5 1 frame_00000003.png -0.05\n");
        using FolderLink link = new(_folder);
        Assert.Null(link.Receive(Little));
        Write(Indicators + "0 0.1 5 1 frame_00000000.png -0.05\n");
        ClientFrame frame = link.Receive(Ample)!;

        Assert.Equal((0, 0.1, 5, true), (frame.Frame, frame.TimeSeconds, frame.State.SpeedMetresPerSecond, frame.State.IsFast));
        Assert.Equal((-0.05, 0), (frame.State.Indicators.Angle.Value, frame.State.TorcsEquivalent.Angle.Value));
        Assert.Null(link.Receive(Little));
    }

    [Theory]
    [InlineData("")]
    [InlineData("0 -7 3.5")]
    [InlineData("0 -7 3.5 7 75 75 -9.5 -2 2 9.5 75 75 seventy\n3 0.3 5 1 frame_00000003.png -0.05\n")]
    public void Receive_skips_an_incomplete_state(string state)
    {
        using FolderLink link = new(_folder);
        Write(state);
        Assert.Null(link.Receive(Little));
        Write(Indicators + "4 0.4 5 1 frame_00000004.png -0.05\n");

        Assert.Equal(4, link.Receive(Ample)!.Frame);
    }

    [Fact]
    public void Answers_and_steps_are_distinguished_from_earlier_ones()
    {
        using FolderLink link = new(_folder);
        link.Send(new DrivingControls(-0.5, 0.25, 0), 12);
        Assert.Equal("-0.5 0.25 0 12\n", File.ReadAllText(Path.Combine(_folder, "controls.txt")));

        HashSet<string> commands = [];
        for (int i = 0; i < 3; i++)
        {
            link.Step(0.1);
            commands.Add(File.ReadAllText(Path.Combine(_folder, "command.json")));
        }

        Assert.Equal(3, commands.Count);
        Assert.All(commands, command => Assert.Matches(new Regex("""^\{"type":"step","seconds":0.1\} *$"""), command));
    }

    [Fact]
    public void Game_of_another_version_is_refused()
    {
        File.WriteAllText(Path.Combine(_folder, "bridge.json"), """{"type":"hello","version":2}""");

        Assert.Contains(
            "the game speaks version 2 of the bridge, this program version 1",
            Assert.Throws<IOException>(() => new FolderLink(_folder)).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Game_of_another_version_that_begins_later_is_refused()
    {
        using FolderLink link = new(_folder);
        File.WriteAllText(Path.Combine(_folder, "bridge.json"), """{"type":"hello","version":2}""");
        Write(Indicators + "3 0.3 5 1 frame_00000003.png -0.05\n");

        Assert.Contains("version 2", Assert.Throws<IOException>(() => link.Receive(Ample)).Message, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Deleted_folder_is_reported_after_limited_retries()
    {
        using FolderLink link = new(_folder);
        Directory.Delete(_folder, recursive: true);

        Assert.ThrowsAny<IOException>(() => link.Step(0.1));
        Directory.CreateDirectory(_folder);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private void Write(string state) => File.WriteAllText(Path.Combine(_folder, "state.txt"), state);
}
