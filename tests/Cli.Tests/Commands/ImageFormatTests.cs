using Harvester.Cli.Terminals;
using Harvester.Exports.Formats;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Sessions and datasets with images in every format.</summary>
public sealed class ImageFormatTests(HarvestedFormats harvested) : IClassFixture<HarvestedFormats>, IDisposable
{
    /// <summary>What the paths of pictures that are no camera images contain.</summary>
    private static readonly string[] Maps = ["gtFine", "panoptic_", "/classes/", "/drivable/", "maps/", "flow_", "obj_map", "other-masks"];

    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string> Formats =>
        [.. DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name)];

    private string Out => _folder.PathOf("out");

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("bmp")]
    [InlineData("jpg")]
    public void Image_format_changes_no_label(string format)
    {
        string png = File.ReadAllText(Path.Combine(harvested.SessionOf("png"), "labels.jsonl"));

        string labels = File.ReadAllText(Path.Combine(harvested.SessionOf(format), "labels.jsonl"));

        Assert.Equal(png, labels.Replace($".{format}\"", ".png\"", StringComparison.Ordinal));
    }

    [Fact]
    public void Jpg_images_are_the_screenshots_in_the_requested_quality()
    {
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            Out,
            "--frames",
            "1",
            "--size",
            "160x120",
            "--seed",
            "6",
            "--hz",
            "2",
            "--image-format",
            "jpg",
            "--quality",
            "40"
        );

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(Jpeg(0, quality: 40), File.ReadAllBytes(Path.Combine(Out, "frames", "00000000.jpg")));
        Assert.Equal(Jpeg(0, quality: 95), harvested.Image("jpg", 0));
        Assert.Contains(
            "\"format\": \"jpeg\",\n    \"quality\": 40\n",
            File.ReadAllText(Path.Combine(Out, "session.json")),
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData("bmp")]
    [InlineData("jpg")]
    public void Every_command_reads_the_session(string format)
    {
        string session = harvested.SessionOf(format);
        string[][] commands =
        [
            ["validate", session],
            ["stats", session],
            ["report", session, "--out", _folder.PathOf("report.html")],
            ["report", session, "--still", "2", "--out", _folder.PathOf("still.png")],
            ["relabel", session, "--out", _folder.PathOf("relabelled")],
            ["validate", _folder.PathOf("relabelled")],
            ["masks", "import", _folder.PathOf("relabelled"), Path.Combine(session, "masks")],
        ];
        foreach (string[] command in commands)
        {
            CliRun run = CliRun.Of(command);
            Assert.True(run.ExitCode == ExitCode.Done, $"{command[0]}: {run.Error}{run.Out}");
        }
    }

    [Fact]
    public void Shards_of_jpg_images_merge_to_the_bytes_of_a_single_run()
    {
        foreach (string shard in (string[])["1/2", "2/2"])
        {
            CliRun.Of(
                "harvest",
                "--out",
                _folder.PathOf(shard[..1]),
                "--frames",
                "4",
                "--size",
                "160x120",
                "--seed",
                "6",
                "--hz",
                "2",
                "--masks",
                "--image-format",
                "jpg",
                "--shard",
                shard
            );
        }

        CliRun.Of("merge", _folder.PathOf("1"), _folder.PathOf("2"), "--out", Out);

        for (int frame = 0; frame < HarvestedFormats.Frames; frame++)
        {
            Assert.Equal(harvested.Image("jpg", frame), File.ReadAllBytes(Path.Combine(Out, "frames", $"{frame:D8}.jpg")));
        }
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void Exports_of_jpg_sessions_are_valid(string format) => AssertValidExport(format, harvested.SessionOf("jpg"));

    [Theory]
    [MemberData(nameof(Formats))]
    public void Exports_converted_to_jpg_are_valid_and_hold_no_other_images(string format)
    {
        AssertValidExport(format, harvested.SessionOf("png"), "--image-format", "jpg");

        string[] images =
        [
            .. Directory
                .EnumerateFiles(Out, "*", SearchOption.AllDirectories)
                .Where(IsImage)
                .Where(image => !image.Contains("laneseg_label", StringComparison.Ordinal)),
        ];
        Assert.Equal(
            format is "webdataset" or "mcap" or "pcd" or "ply" or "gpudrive" or "womd" ? 0
                : DatasetFormats.Find(format)!.NeedsFlow ? 2 * FlowsIn("png")
                : HarvestedFormats.Frames,
            images.Length
        );
        Assert.All(images, image => Assert.EndsWith(".jpg", image, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("png", "jpg")]
    [InlineData("bmp", "jpg")]
    [InlineData("bmp", "png")]
    public void Converted_images_equal_those_of_a_harvest_in_the_format(string from, string to)
    {
        AssertValidExport("kitti", harvested.SessionOf(from), "--image-format", to);

        for (int frame = 0; frame < HarvestedFormats.Frames; frame++)
        {
            Assert.Equal(harvested.Image(to, frame), File.ReadAllBytes(Path.Combine(Out, "training", "image_2", $"{frame:D6}.{to}")));
        }
    }

    [Theory]
    [InlineData("gif", null, "--image-format takes png, bmp or jpg")]
    [InlineData("jpg", "0", "--quality takes a whole number from 1 to 100")]
    [InlineData("png", "90", "--quality has no effect without --image-format jpg")]
    [InlineData(null, "90", "--quality has no effect without --image-format jpg")]
    public void Impossible_format_or_quality_is_refused(string? format, string? quality, string message)
    {
        string[] options =
        [
            .. format is null ? (string[])[] : ["--image-format", format],
            .. quality is null ? (string[])[] : ["--quality", quality],
        ];

        CliRun.Of(["harvest", "--out", Out, .. options]).AssertFailed(ExitCode.Usage, message);
        CliRun
            .Of(["export", harvested.SessionOf("png"), "--format", "csv", "--out", Out, .. options])
            .AssertFailed(ExitCode.Usage, message);
    }

    private void AssertValidExport(string format, string session, params string[] options)
    {
        CliRun export = CliRun.Of(["export", session, "--format", format, "--out", Out, .. options]);
        Assert.Equal((ExitCode.Done, ""), (export.ExitCode, export.Error));
        CliRun validate = CliRun.Of("validate", Out);
        Assert.True(validate.ExitCode == ExitCode.Done, validate.Out);
    }

    private int FlowsIn(string format) => Directory.GetFiles(Path.Combine(harvested.SessionOf(format), "flow-forward")).Length;

    private static bool IsImage(string path) =>
        Path.GetExtension(path) is ".png" or ".bmp" or ".jpg" && !Maps.Any(part => path.Contains(part, StringComparison.Ordinal));

    private byte[] Jpeg(int frame, int quality)
    {
        using var stream = new MemoryStream();
        new PictureEncoder(ImageFormat.Jpeg, quality).Write(
            PngDecoder.ReadRgb(Path.Combine(harvested.SessionOf("png"), "frames", $"{frame:D8}.png")),
            stream
        );
        return stream.ToArray();
    }
}
