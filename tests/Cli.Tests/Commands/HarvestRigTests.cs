using System.Text.Json.Nodes;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestRigTests(HarvestedRig harvested) : IClassFixture<HarvestedRig>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Each_moment_has_a_frame_for_each_camera()
    {
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];

        Assert.Equal(Enumerable.Range(0, 8), labels.Select(label => label.Frame));
        Assert.Equal([0, 0, 1, 1, 2, 2, 3, 3], labels.Select(label => label.Moment!.Value));
        Assert.Equal(["left", "right", "left", "right"], labels.Take(4).Select(label => label.View));
        Assert.Equal("frames/right/00000003.png", labels[3].Image);
        Assert.Equal((80, 60), (labels[0].Camera.Width, labels[0].Camera.Height));
        Assert.Equal((64, 64), (labels[1].Camera.Width, labels[1].Camera.Height));
        Assert.All(labels.Chunk(2), moment => Assert.Equal(moment[0].GameFrame, moment[1].GameFrame));
        Assert.All(labels, label => Assert.Equal(label.View == "left" ? 1 : 0, label.Lidar.Count));
    }

    [Fact]
    public void Views_of_a_moment_agree_about_its_objects()
    {
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];
        int common = 0;
        foreach (FrameLabel[] moment in labels.Chunk(2))
        {
            foreach (
                (ObjectLabel left, ObjectLabel right) in moment[0]
                    .Objects.Join(moment[1].Objects, item => item.Id, item => item.Id, (left, right) => (left, right))
            )
            {
                Assert.Equal((left.Class, left.Model, left.Box3D), (right.Class, right.Model, right.Box3D));
                common++;
            }
        }

        Assert.NotEqual(0, common);
    }

    [Fact]
    public void First_views_have_the_motion_between_moments()
    {
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];

        // At 60 ticks per second and 2 moments per second, 29 ticks lie between two moments of a place.
        Assert.Equal(29, labels[2].Motion!.Count);
        Assert.All(labels, label => Assert.Equal(label.View == "left", label.Motion is not null));
        MotionSample last = labels[2].Motion![^1];
        Assert.Equal(labels[2].TimeSeconds - (1 / 60.0), last.TimeSeconds, 5);
        double moved = (labels[2].Ego.Position - last.Pose.Position).Length;
        Assert.Equal(last.Velocity.Length / 60, moved, 2);
        Assert.InRange(last.Motion!.Throttle!.Value, 0, 1);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Resumed_rig_has_the_bytes_of_an_uninterrupted_one()
    {
        string session = _folder.PathOf("session");
        CopyTo(session);
        string labels = Path.Combine(session, "labels.jsonl");
        string[] lines = File.ReadAllLines(labels);
        File.WriteAllText(labels, string.Concat(lines.Take(5).Select(line => line + "\n")));
        string header = Path.Combine(session, "session.json");
        string text = File.ReadAllText(header);
        File.WriteAllText(header, text[..text.IndexOf("\n  \"state\"", StringComparison.Ordinal)] + "\n  \"state\": \"recording\"\n}\n");
        UnfinishedMark.Write(session, CommandText.Of(["harvest", "--rig", harvested.RigFile, .. HarvestedRig.Options]));

        CliRun.Of(["harvest", "--out", session, "--rig", harvested.RigFile, .. HarvestedRig.Options, "--resume"]).AssertDone();

        Assert.Equal(File.ReadAllBytes(Path.Combine(harvested.Session, "labels.jsonl")), File.ReadAllBytes(labels));
    }

    [Fact]
    public void Session_and_its_shards_are_valid()
    {
        foreach (string session in (string[])[harvested.Session, harvested.PathOf("part-1"), harvested.PathOf("part-2")])
        {
            CliRun run = CliRun.Of("validate", "--schema", session);
            Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        }
    }

    [Fact]
    public void Merged_shards_have_the_bytes_of_a_single_run()
    {
        CliRun
            .Of("merge", harvested.PathOf("part-2"), harvested.PathOf("part-1"), "--out", _folder.PathOf("whole"), "--no-report")
            .AssertDone();

        string[] files = [.. Files(harvested.Session)];
        Assert.Equal(files, Files(_folder.PathOf("whole")));
        Assert.All(
            files,
            file =>
                Assert.Equal(File.ReadAllBytes(Path.Combine(harvested.Session, file)), File.ReadAllBytes(_folder.PathOf($"whole/{file}")))
        );
    }

    [Fact]
    public void Relabelled_session_has_the_same_labels()
    {
        CliRun.Of("relabel", harvested.Session, "--out", _folder.PathOf("again"), "--no-report").AssertDone();

        Assert.Equal(
            File.ReadAllText(Path.Combine(harvested.Session, "labels.jsonl")),
            File.ReadAllText(_folder.PathOf("again/labels.jsonl"))
        );
        CliRun.Of("validate", _folder.PathOf("again")).AssertDone();
    }

    [Fact]
    public void Tracking_formats_have_a_sequence_for_each_place_and_view()
    {
        CliRun.Of("export", harvested.Session, "--format", "kitti-tracking", "--out", _folder.PathOf("tracks")).AssertDone();

        Assert.Equal(
            ["0000", "0001", "0002", "0003"],
            Directory.GetDirectories(_folder.PathOf("tracks/training/image_02")).Select(folder => Path.GetFileName(folder)).Order()
        );
        CliRun.Of("validate", _folder.PathOf("tracks")).AssertDone();
    }

    [Fact]
    public void Kitti_has_the_points_before_each_camera()
    {
        CliRun.Of("export", harvested.Session, "--format", "kitti", "--out", _folder.PathOf("kitti")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("kitti")).AssertDone();

        // The left camera is 0.3 m to the left of the LiDAR, 2 m ahead and 1.2 m below: the LiDAR is at right 0.3, down -1.2, forward -2.
        string calibration = File.ReadAllText(_folder.PathOf("kitti/training/calib/000000.txt"));
        Assert.Contains("Tr_velo_to_cam: 0 -1 0 0.3 0 0 -1 -1.2 1 0 0 -2\n", calibration, StringComparison.Ordinal);
        byte[] points = File.ReadAllBytes(_folder.PathOf("kitti/training/velodyne/000000.bin"));
        byte[] recorded = File.ReadAllBytes(Path.Combine(harvested.Session, "lidar/top/00000000.bin"));
        Assert.Equal(points, File.ReadAllBytes(_folder.PathOf("kitti/training/velodyne/000001.bin")));
        Assert.Equal(recorded.Length / 24, points.Length / 16);

        // Forward is the second number of a recorded point, and the first of KITTI's.
        Assert.Equal(BitConverter.ToSingle(recorded, 4), BitConverter.ToSingle(points, 0));
    }

    [Fact]
    public void Nuscenes_counts_the_points_that_met_each_object()
    {
        CliRun.Of("export", harvested.Session, "--format", "nuscenes", "--out", _folder.PathOf("nuscenes")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("nuscenes")).AssertDone();

        int counted = JsonNode
            .Parse(File.ReadAllText(_folder.PathOf("nuscenes/v1.0-gta/sample_annotation.json")))!
            .AsArray()
            .Sum(annotation => (int)annotation!["num_lidar_hits"]!);
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];
        int recorded = labels
            .Chunk(2)
            .Sum(moment =>
            {
                HashSet<int> vehicles =
                [
                    .. moment
                        .SelectMany(view => view.Objects)
                        .Where(item =>
                            item.Parent is null && item.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Other)
                        )
                        .Select(item => item.Id),
                ];
                byte[] points = File.ReadAllBytes(Path.Combine(harvested.Session, moment[0].Lidar[0].File));
                return Enumerable
                    .Range(0, points.Length / 24)
                    .Count(point => vehicles.Contains(BitConverter.ToUInt16(points, (24 * point) + 20)));
            });
        Assert.Equal(recorded, counted);
        Assert.NotEqual(0, counted);
    }

    [Fact]
    public void Damaged_points_are_found()
    {
        CopyTo(_folder.PathOf("damaged"));
        string points = _folder.PathOf("damaged/lidar/top/00000002.bin");
        File.WriteAllBytes(points, File.ReadAllBytes(points)[24..]);

        CliRun run = CliRun.Of("validate", _folder.PathOf("damaged"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("lidar 'lidar/top/00000002.bin' has", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Each_view_has_depth_maps_of_its_size()
    {
        foreach (FrameLabel label in new SessionReader(harvested.Session).ReadLabels())
        {
            DepthLabel depth = label.Depth!;
            Assert.Equal($"depth/{label.View}/{label.Frame:D8}.png", depth.Sparse);
            Assert.Equal($"depth-completed/{label.View}/{label.Frame:D8}.png", depth.Completed);
            Assert.Equal($"depth-error/{label.View}/{label.Frame:D8}.png", depth.Error);
            Assert.Equal(depth.RaysCast, label.Rays!.Of("depth"));
            Assert.InRange(depth.MeasuredPixels, 1, label.Camera.Width * label.Camera.Height);
            Assert.All(
                depth.Files,
                file =>
                {
                    // The header of a PNG has the width, the height and the bits of a value.
                    byte[] png = File.ReadAllBytes(Path.Combine(harvested.Session, file));
                    Assert.Equal(
                        (label.Camera.Width, label.Camera.Height, 16),
                        ((png[18] << 8) | png[19], (png[22] << 8) | png[23], png[24])
                    );
                }
            );
        }
    }

    [Fact]
    public void Depth_that_contradicts_its_label_is_found()
    {
        CopyTo(_folder.PathOf("damaged"));
        Replace("depth/left/00000002.png", "depth-completed/left/00000002.png");
        Replace("depth-error/left/00000004.png", "depth/left/00000000.png");
        File.Delete(_folder.PathOf("damaged/manifest.jsonl"));

        CliRun run = CliRun.Of("validate", _folder.PathOf("damaged"));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("depth map 'depth/left/00000002.png' has", run.Out, StringComparison.Ordinal);
        Assert.Contains("'depth-error/left/00000004.png' must have an error for each pixel", run.Out, StringComparison.Ordinal);

        void Replace(string name, string by) =>
            File.Copy(_folder.PathOf($"damaged/{by}"), _folder.PathOf($"damaged/{name}"), overwrite: true);
    }

    [Fact]
    public void Single_camera_has_measured_depth_without_masks()
    {
        CliRun
            .Of("harvest", "--out", _folder.PathOf("single"), "--frames", "2", "--size", "80x60", "--depth", "--seed", "3", "--no-report")
            .AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("single")).AssertDone();

        FrameLabel label = new SessionReader(_folder.PathOf("single")).ReadLabels().First();
        Assert.Equal(("depth/00000000.png", null, null), (label.Depth!.Sparse, label.Depth.Completed, label.Depth.Error));
        Assert.False(Directory.Exists(_folder.PathOf("single/depth-completed")));
    }

    [Theory]
    [InlineData("--size", "80x60", "--size cannot be used with --rig, which gives each camera its size")]
    [InlineData("--k1", "0.1", "--k1 cannot be used with --rig")]
    [InlineData("--masks", "coded", "With --rig, masks come from rays.")]
    public void Options_that_contradict_the_rig_are_refused(string option, string value, string message) =>
        CliRun
            .Of("harvest", "--out", _folder.PathOf("out"), "--rig", harvested.RigFile, option, value)
            .AssertFailed(ExitCode.Usage, message);

    [Theory]
    [InlineData("\"width\":80", "\"width\":8", ExitCode.BadData, "cameras[0].width must be a number from 32 to 8192.")]
    [InlineData("\"right\"", "\"left\"", ExitCode.BadData, "cameras[1].name must be unlike that of every other sensor")]
    [InlineData("[0.3,2,0.4]", "[0,0,0.2]", ExitCode.Usage, "'right' of the rig 'pair' is inside the body of the car")]
    [InlineData("\"columns\":40", "\"columns\":40000", ExitCode.BadData, "lidars[0].columns must be a number from 1 to 20000.")]
    public void Bad_rig_is_refused_in_one_line(string good, string bad, int exitCode, string message)
    {
        string rig = _folder.File("bad.json", HarvestedRig.Rig.Replace(good, bad, StringComparison.Ordinal));

        CliRun run = CliRun.Of("harvest", "--out", _folder.PathOf("out"), "--rig", rig, "--frames", "1");

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(1, run.Error.Count(character => character == '\n'));
        Assert.False(File.Exists(_folder.PathOf("out/session.json")));
    }

    [Fact]
    public void Rig_that_takes_too_long_is_refused_with_an_estimate()
    {
        string beams = string.Join(',', Enumerable.Range(0, 256).Select(beam => beam * 0.1));
        JsonNode rig = JsonNode.Parse(HarvestedRig.Rig)!;
        foreach (JsonNode? camera in rig["cameras"]!.AsArray())
        {
            (camera!["width"], camera["height"]) = (8192, 8192);
        }

        rig["lidars"] = new JsonArray([
            .. Enumerable
                .Range(0, 8)
                .Select(number =>
                    JsonNode.Parse($$"""{"name":"l{{number}}","position":[0,0,2],"beamsDegrees":[{{beams}}],"columns":7800}""")
                ),
        ]);

        // 8 · 256 · 7,800 rays at 300,000 a second are 53.2 s; twice 8,192 · 8,192 pixels at 5,000,000 a second are 26.8 s.
        CliRun
            .Of("harvest", "--out", _folder.PathOf("out"), "--rig", _folder.File("slow.json", rig.ToJsonString()))
            .AssertFailed(ExitCode.Usage, "A moment of the rig 'pair' takes about 80 s; at most 60 s are allowed.");
    }

    private static IEnumerable<string> Files(string folder) =>
        Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Select(file => Path.GetRelativePath(folder, file)).Order();

    private void CopyTo(string folder)
    {
        foreach (string file in Files(harvested.Session))
        {
            string copy = Path.Combine(folder, file);
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(Path.Combine(harvested.Session, file), copy);
        }
    }
}
