using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Cli.Tests.Commands;

public sealed class MasksCommandTests
{
    /// <summary>
    /// The harvest asks about 60 rays what hides a face a few pixels wide, of which the mask has one of two or three columns.
    /// </summary>
    private const double RaysAndPixels = 0.1;

    [Theory]
    [InlineData(false, "6")]
    [InlineData(true, "6")]
    [InlineData(false, "4")]
    [InlineData(true, "4")]
    [Trait("Category", "Heavy")]
    public void Importing_a_sessions_own_masks_keeps_visible_boxes_and_faces(bool match, string seed)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "2", "--seed", seed, "--masks", "--no-report", "--size", "640x480");
        string maps = folder.PathOf("maps");
        Directory.CreateDirectory(maps);
        foreach (string mask in Directory.GetFiles(Path.Combine(session, "masks")))
        {
            File.Copy(mask, Path.Combine(maps, Path.GetFileName(mask)));
        }

        List<string?> before = VisibleBoxes(session);
        List<double> faces = VisibleFaces(session);

        CliRun run = CliRun.Of(["masks", "import", session, maps, .. match ? (string[])["--match"] : []]);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Matches($@": 2 masks imported; \d+ of {before.Count} labelled objects have visible pixels\n$", run.Out);
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", session).ExitCode);
        Assert.NotEmpty(before.OfType<string>());
        Assert.Equal(before, VisibleBoxes(session));
        Assert.NotEmpty(faces);
        Assert.All(faces.Zip(VisibleFaces(session)), face => Assert.Equal(face.First, face.Second, RaysAndPixels));
        Assert.False(File.Exists(Path.Combine(session, "report.html")));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Matching_import_counts_the_pixels_that_it_drops()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "2", "--seed", "6", "--masks", "--no-report", "--size", "640x480");
        string maps = folder.PathOf("maps");
        Directory.CreateDirectory(maps);
        foreach (int frame in (int[])[0, 1])
        {
            // In the sky, six pixels of frame 1 belong to no object.
            var map = new InstanceMap(new ImageSize(640, 480));
            foreach (int at in frame == 0 ? (int[])[] : [0, 1, 2, 640, 641, 642])
            {
                map.Ids[at] = (ushort)(at < 640 ? 900 : 901);
            }

            using FileStream file = File.Create(Path.Combine(maps, $"{frame}.png"));
            new PngEncoder().Write(map, file);
        }

        CliRun run = CliRun.Of("masks", "import", session, maps, "--match");

        Assert.Equal(
            (ExitCode.Done, "harvester: 6 pixels match no object and are dropped, first in frame 1: values 900, 901\n"),
            (run.ExitCode, run.Error)
        );
    }

    /// <summary>The harvest recorded what rays found of objects and faces; what was imported since counts.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Relabel_keeps_faces_hidden_that_no_imported_map_shows()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "2", "--seed", "2", "--masks", "--no-report", "--size", "640x480");
        Assert.NotEmpty(VisibleFaces(session));
        string maps = folder.PathOf("maps");
        Directory.CreateDirectory(maps);
        foreach (string name in (string[])["0.png", "1.png"])
        {
            using FileStream map = File.Create(Path.Combine(maps, name));
            new PngEncoder().Write(new InstanceMap(new ImageSize(640, 480)), map);
        }

        Assert.Equal(ExitCode.Done, CliRun.Of("masks", "import", session, maps).ExitCode);
        Assert.Equal(ExitCode.Done, CliRun.Of("relabel", session, "--out", folder.PathOf("relabelled"), "--no-report").ExitCode);

        Assert.Empty(VisibleFaces(folder.PathOf("relabelled")));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Import_into_a_session_with_a_report_rewrites_it()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        string report = Path.Combine(session, "report.html");
        Assert.Equal(ExitCode.Done, CliRun.Of("harvest", "--out", session, "--frames", "1", "--masks", "--size", "160x120").ExitCode);
        byte[] page = File.ReadAllBytes(report);
        File.WriteAllText(report, "of yesterday");

        Assert.Equal(ExitCode.Done, CliRun.Of("masks", "import", session, Path.Combine(session, "masks")).ExitCode);
        Assert.InRange(new FileInfo(report).Length, page.Length / 2, page.Length * 2);
    }

    [Fact]
    public void Import_of_a_missing_folder_is_an_input_error()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 } }""");

        CliRun.Of("masks", "import", folder.Path, folder.PathOf("none")).AssertFailed(ExitCode.InputOutput, "Folder not found");
    }

    private static List<double> VisibleFaces(string session) =>
        [
            .. File.ReadLines(Path.Combine(session, "labels.jsonl"))
                .SelectMany(line => JsonNode.Parse(line)!["objects"]!.AsArray())
                .Where(item => item!["parent"] is not null)
                .Select(item => item!["visibleFraction"]!.GetValue<double>()),
        ];

    private static List<string?> VisibleBoxes(string session) =>
        [
            .. File.ReadLines(Path.Combine(session, "labels.jsonl"))
                .SelectMany(line => JsonNode.Parse(line)!["objects"]!.AsArray())
                .Select(item => item!["box2dVisible"]?.ToJsonString()),
        ];
}
