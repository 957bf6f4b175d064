using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FolderBridgeTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-bridge").FullName;

    [Fact]
    public void Frame_appears_as_a_picture_and_a_line_of_thirteen_numbers()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);

        bridge.Publish(Frames.State(4), Frames.Picture(9));
        Frames.Await(() => File.Exists(PathOf("state.txt")), "state.txt");

        string[] lines = File.ReadAllText(PathOf("state.txt")).Split('\n');
        double[] indicators = [.. lines[0].Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
        Assert.Equal([0, -7, 3.5, 7, 75, 75, -9.5, -5.5, 5.5, 9.5, 75, 75, 75], indicators);
        Assert.Equal("4 0.4 12.5 1 frame_00000004.png 0", lines[1]);
        Assert.True(File.Exists(PathOf("frame_00000004.png")));
    }

    [Fact]
    public void Only_the_last_pictures_are_kept()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);
        for (int frame = 0; frame < 30; frame++)
        {
            string picture = PathOf(string.Create(CultureInfo.InvariantCulture, $"frame_{frame:00000000}.png"));
            bridge.Publish(Frames.State(frame), Frames.Picture(9));
            Frames.Await(() => File.Exists(picture), picture);
        }

        Frames.Await(() => Directory.GetFiles(_folder, "frame_*.png").Length <= 10, "old pictures to go");
    }

    [Theory]
    [InlineData("writing.part")]
    [InlineData("state.txt.partial")]
    [InlineData("state.txt")]
    [InlineData("frame_00000004.png")]
    public void Planted_link_is_not_followed(string name)
    {
        string secret = Path.Combine(Directory.CreateDirectory(PathOf("elsewhere")).FullName, "secret");
        File.WriteAllText(secret, "mine");
        File.CreateSymbolicLink(PathOf(name), secret);
        using var bridge = new FolderBridge(_folder, Frames.Size);

        bridge.Publish(Frames.State(4), Frames.Picture(9));
        Frames.Await(() => File.Exists(PathOf("state.txt")) && new FileInfo(PathOf("state.txt")).LinkTarget is null, "state.txt");

        Assert.Equal("mine", File.ReadAllText(secret));
    }

    [Fact]
    public void Unfinished_files_of_a_killed_game_are_deleted()
    {
        string[] left = ["frame_00000004.png.0123456789abcdef.partial", "state.txt.0123456789abcdef.partial"];
        string client = PathOf("controls.txt.0123456789abcdef.partial");
        foreach (string path in left.Select(PathOf).Append(client))
        {
            File.WriteAllText(path, "");
        }

        using var bridge = new FolderBridge(_folder, Frames.Size);

        Frames.Await(() => File.Exists(PathOf("bridge.json")), "the hello, which is written next");
        Assert.Equal([PathOf("bridge.json"), client], Directory.GetFiles(_folder).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Controls_and_indicators_arrive_once_per_write()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);

        Drop("controls.txt", "0.5 0.25 0\n");
        Assert.Equal(new ControlsMessage(new DrivingControls(0.5, 0.25, 0), null), Frames.AwaitMessage(bridge));
        Drop("indicators.txt", "0.1 -7 3.5 7 75 75 -6 -2 2 6 60 60 60\n31\n");

        var indicators = Assert.IsType<IndicatorsMessage>(Frames.AwaitMessage(bridge));
        Assert.Equal(13, indicators.Values.Count);
        Assert.Equal(31, indicators.Frame);
        Assert.False(bridge.TryReceive(out _));
    }

    [Fact]
    public void Files_left_by_a_dead_client_are_not_read_as_new()
    {
        Drop("controls.txt", "1 1 0\n");
        using var bridge = new FolderBridge(_folder, Frames.Size);
        bridge.Publish(Frames.State(0), Frames.Picture(1));
        Frames.Await(() => File.Exists(PathOf("state.txt")), "state.txt");
        bridge.Publish(Frames.State(1), Frames.Picture(1));
        Frames.Await(() => File.Exists(PathOf("frame_00000001.png")), "a second frame");

        Assert.False(bridge.TryReceive(out _));
    }

    [Theory]
    [InlineData("controls.txt", "1 2\n")]
    [InlineData("controls.txt", "left 0 0\n")]
    [InlineData("controls.txt", "0.1 0.5 0")]
    [InlineData("indicators.txt", "")]
    [InlineData("command.json", "{\"type\":\"fly\"}")]
    public void Bad_file_is_reported_and_the_next_good_one_is_read(string name, string content)
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);

        Drop(name, content);
        Frames.Await(() => bridge.Problem is not null, "the problem to be reported");

        // Longer than all of them, as the times of files are coarse on some systems.
        Drop("controls.txt", "0.000 0.000 0.750\n");

        Assert.Equal(new ControlsMessage(new DrivingControls(0, 0, 0.75), null), Frames.AwaitMessage(bridge));
    }

    [PosixFact]
    public void Unreadable_file_is_reported_and_the_next_good_one_is_read()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);

        // What a link leads to that is not there can be seen and not be read, by anyone.
        File.CreateSymbolicLink(PathOf("controls.txt"), PathOf("nowhere"));
        Frames.Await(() => bridge.Problem is not null, "the problem to be reported");
        Assert.StartsWith("controls.txt cannot be read: ", bridge.Problem, StringComparison.Ordinal);
        Drop("controls.txt", "0 0 0.75\n");

        Assert.Equal(new ControlsMessage(new DrivingControls(0, 0, 0.75), null), Frames.AwaitMessage(bridge));
    }

    [PosixFact]
    public void Pipes_in_the_folder_block_nothing()
    {
        string[] names = ["controls.txt", "indicators.txt", "command.json", "alive.txt"];
        using var bridge = new FolderBridge(_folder, Frames.Size);
        foreach (string name in names)
        {
            using var make = System.Diagnostics.Process.Start("mkfifo", PathOf(name));
            make.WaitForExit();
        }

        Frames.Await(() => bridge.Problem?.Contains("is a pipe", StringComparison.Ordinal) ?? false, "the pipes to be reported");
        File.Delete(PathOf("controls.txt"));
        Drop("controls.txt", "0 0 0.75\n");

        Assert.Equal(new ControlsMessage(new DrivingControls(0, 0, 0.75), null), Frames.AwaitMessage(bridge));
    }

    [Fact]
    public void Hellos_name_the_versions_and_another_is_reported()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);
        Frames.Await(() => File.Exists(PathOf("bridge.json")), "the game's hello");
        Assert.Equal("{\"type\":\"hello\",\"version\":1}\n", File.ReadAllText(PathOf("bridge.json")));
        Drop("controls.txt", "0 0 0.75\n");
        Assert.IsType<ControlsMessage>(Frames.AwaitMessage(bridge));

        Drop("command.json", """{"type":"hello","version":7}""");
        Frames.Await(() => bridge.Problem is not null, "the version to be reported");

        Assert.Contains("version 7 of the bridge, the game version 1", bridge.Problem, StringComparison.Ordinal);
        Assert.False(bridge.TryReceive(out _));
    }

    [Fact]
    public void Pictures_of_an_earlier_drive_are_deleted()
    {
        File.WriteAllText(PathOf("frame_00000123.png"), "");
        using var bridge = new FolderBridge(_folder, Frames.Size);

        Frames.Await(() => !File.Exists(PathOf("frame_00000123.png")), "the old picture to go");
    }

    [Fact]
    public void Bridge_survives_a_client_killed_and_restarted_100_times()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);
        var random = new Random(3);
        for (int life = 0; life < 100; life++)
        {
            // A client killed in the middle of a writing leaves half a file in the place of a whole one.
            // Of another length than the one before, as the times of files are coarse on some systems.
            string whole = string.Create(CultureInfo.InvariantCulture, $"0.{life + 100} 0.5 0 {life}{new string(' ', life % 3)}\n");
            File.WriteAllText(PathOf("controls.txt"), whole[..random.Next(whole.Length)]);
            bridge.Publish(Frames.State(life), Frames.Picture((byte)life));
            Drop("controls.txt", whole);

            var last = (ControlsMessage)Frames.AwaitMessage(bridge);
            while (last.Frame != life)
            {
                last = (ControlsMessage)Frames.AwaitMessage(bridge);
            }
        }
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private string PathOf(string name) => Path.Combine(_folder, name);

    private void Drop(string name, string content)
    {
        File.WriteAllText(PathOf(name + ".part"), content);
        File.Move(PathOf(name + ".part"), PathOf(name), overwrite: true);
    }
}
