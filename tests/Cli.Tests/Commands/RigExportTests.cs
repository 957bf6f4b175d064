using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Exports of a rig, and what validate finds in damaged ones. The cameras of this rig do not belong together for KITTI.</summary>
public sealed class RigExportTests(HarvestedRig harvested) : IClassFixture<HarvestedRig>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("kitti", "training/oxts/000001.txt")]
    [InlineData("kitti-odometry", "sequences/02/velodyne/000001.bin")]
    [InlineData("pcd", "clouds/top/00000006.pcd")]
    [InlineData("ply", "clouds/top/00000006.ply")]
    [InlineData("nuscenes", "can_bus/scene-2002_pose.json")]
    [InlineData("occ3d", "annotations.json")]
    [InlineData("mcap", "train/0002.mcap")]
    public void Export_of_a_rig_is_valid(string format, string file)
    {
        Export(format);

        CliRun.Of("validate", _folder.PathOf("out")).AssertDone();
        Assert.True(File.Exists(_folder.PathOf("out/" + file)));
    }

    [Theory]
    [InlineData("kitti-odometry")]
    [InlineData("pcd")]
    [InlineData("ply")]
    [InlineData("nuscenes")]
    [InlineData("occ3d")]
    [InlineData("mcap")]
    public void Empty_file_of_points_is_refused(string format)
    {
        string session = _folder.PathOf("session");
        foreach (string file in Directory.EnumerateFiles(harvested.Session, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(session, Path.GetRelativePath(harvested.Session, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        File.WriteAllBytes(Directory.EnumerateFiles(Path.Combine(session, "lidar"), "*", SearchOption.AllDirectories).Order().First(), []);

        CliRun
            .Of("export", session, "--format", format, "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.BadData, "are 0, but the label says");
    }

    [Theory]
    [InlineData("kitti", "training/oxts/000001.txt", 3, "it does not have 30 numbers.")]
    [InlineData("kitti-odometry", "poses/00.txt", 30, "it does not have 12 numbers.")]
    [InlineData("kitti-odometry", "sequences/00/labels/000000.label", 4, "it does not have four bytes for each point of its scan.")]
    [InlineData("kitti-odometry", "sequences/00/times.txt", 2, "it is not a time after the one before, from 0.")]
    [InlineData("pcd", "clouds/top/00000006.pcd", 1, "bytes, as its")]
    [InlineData("ply", "clouds.csv", 5, "its pose is no position and unit quaternion.")]
    [InlineData("nuscenes", "can_bus/scene-2002_pose.json", 3, "it is cut off.")]
    [InlineData("mcap", "train/0002.mcap", 9, "it is cut off.")]
    public void Cut_off_file_of_an_export_is_found(string format, string file, int bytes, string problem)
    {
        Export(format);
        string path = _folder.PathOf("out/" + file);
        File.WriteAllBytes(path, File.ReadAllBytes(path)[..^bytes]);

        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(problem, run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("kitti-odometry", "sequences/00/calib.txt", "Tr is missing.", "Tr: ", "Ts: ")]
    [InlineData("pcd", "clouds.csv", "it has the unknown split 'test'.", ",train,", ",test,")]
    [InlineData("pcd", "clouds/top/00000006.pcd", "its header is not that of", "0.7", "0.6")]
    [InlineData("mcap", "train/0000.mcap", "checksum", "/camera/left/image", "/camera/left/imagE")]
    [InlineData("nuscenes", "can_bus/scene-2001_pose.json", "its utime is not after that", "\"utime\":1", "\"utime\":-1")]
    public void Changed_file_of_an_export_is_found(string format, string file, string problem, string before, string after)
    {
        Export(format);
        string path = _folder.PathOf("out/" + file);
        File.WriteAllText(
            path,
            File.ReadAllText(path, System.Text.Encoding.Latin1).Replace(before, after, StringComparison.Ordinal),
            System.Text.Encoding.Latin1
        );

        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(problem, run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Cut_off_radar_file_of_nuscenes_is_found()
    {
        Export("nuscenes");
        string file = Directory.EnumerateFiles(_folder.PathOf("out/samples/ahead"), "*.pcd").Order().First();
        byte[] content = File.ReadAllBytes(file);
        File.WriteAllBytes(file, content[..^44]);

        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("does not have the header of a radar and the points that it counts.", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("sample_annotation", "num_lidar_pts\":([1-9])", "num_lidar_pts\":1$1", "points are inside its box.")]
    [InlineData("sample_annotation", "\"translation\":\\[[0-9]*", "\"translation\":[0", "its box is in no image of its sample.")]
    [InlineData("sample_annotation", "\"size\":\\[([^,]*),([^,]*),", "\"size\":[$2,$1,", "inside its box.|wider than long")]
    [InlineData("ego_pose", "\"rotation\":\\[([^,]*),([^\\]]*)\\]", "\"rotation\":[$2,$1]", "in no image of its sample.|inside its box.")]
    [InlineData("calibrated_sensor", "\"rotation\":\\[", "\"rotation\":[2", "its rotation is no unit quaternion.")]
    public void False_geometry_of_nuscenes_is_found(string table, string pattern, string replacement, string problems)
    {
        Export("nuscenes");
        string path = _folder.PathOf($"out/v1.0-gta/{table}.json");
        string before = File.ReadAllText(path);
        string after = System.Text.RegularExpressions.Regex.Replace(before, pattern, replacement);
        Assert.NotEqual(before, after);
        File.WriteAllText(path, after);

        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(problems.Split('|'), problem => run.Out.Contains(problem, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("")]
    [InlineData("\n")]
    public void Table_of_nuscenes_with_other_line_breaks_is_read(string between)
    {
        Export("nuscenes");
        string path = _folder.PathOf("out/v1.0-gta/sample.json");
        File.WriteAllText(
            path,
            File.ReadAllText(path)
                .Replace("\n", "", StringComparison.Ordinal)
                .Replace(",\"", "," + between + "\"", StringComparison.Ordinal)
        );
        File.Delete(_folder.PathOf("out/manifest.jsonl"));

        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));

        Assert.DoesNotContain("sample.json", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Format_without_points_says_so()
    {
        CliRun run = CliRun.Of("export", harvested.Session, "--format", "openlabel", "--out", _folder.PathOf("out"));

        Assert.Contains("openlabel does not have the points of the LiDAR", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Recording_has_the_channels_of_all_sensors()
    {
        Export("mcap");

        string recording = File.ReadAllText(_folder.PathOf("out/train/0000.mcap"), System.Text.Encoding.Latin1);
        string[] topics =
        [
            "/camera/left/image",
            "/camera/left/depth",
            "/camera/right/image",
            "/camera/right/calibration",
            "/camera/right/annotations",
            "/camera/right/depth",
            "/lidar/top",
            "/tf",
            "/objects",
        ];
        Assert.All(topics, topic => Assert.Contains(topic, recording, StringComparison.Ordinal));
        Assert.DoesNotContain("/camera/image", recording, StringComparison.Ordinal);
        Assert.Equal(2, Directory.EnumerateFiles(_folder.PathOf("out/train")).Count());
    }

    [Fact]
    public void Shards_of_a_rig_give_the_recording_of_the_whole()
    {
        Export("mcap");
        string[] shards = [_folder.PathOf("first"), _folder.PathOf("second")];
        for (int i = 0; i < shards.Length; i++)
        {
            CliRun.Of("export", harvested.Session, "--format", "mcap", "--out", shards[i], "--shard", $"{i + 1}/2").AssertDone();
        }

        CliRun.Of("merge", shards[0], shards[1], "--out", _folder.PathOf("merged")).AssertDone();

        foreach (string file in new[] { "train/0000.mcap", "train/0002.mcap" })
        {
            Assert.Equal(File.ReadAllBytes(_folder.PathOf("out/" + file)), File.ReadAllBytes(_folder.PathOf("merged/" + file)));
        }
    }

    [Fact]
    public void Split_between_neighbouring_frames_is_warned_of()
    {
        CliRun run = CliRun.Of(
            "export",
            harvested.Session,
            "--format",
            "coco",
            "--out",
            _folder.PathOf("out"),
            "--split",
            "train:0.5,val:0.5",
            "--split-block",
            "1",
            "--seed",
            "1"
        );

        Assert.Contains("which look alike, are in different splits", run.Error, StringComparison.Ordinal);
    }

    private void Export(string format) =>
        CliRun.Of("export", harvested.Session, "--format", format, "--out", _folder.PathOf("out")).AssertDone();
}
