using System.IO.Compression;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Play.Tapes;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>
/// Small files that unpack to large ones, files without line ends and large ones that go up to the limits: none takes more than 1 GB of
/// memory, measured from outside. docs/reliability.md has the figures, which each test writes to its output.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class MemoryTests(ITestOutputHelper output) : IDisposable
{
    private const long MaxBytes = 1_000_000_000;
    private readonly BombFolder _bombs = new();

    public static TheoryData<string> Sessions => [.. "validate stats report still coco csv-jpg relabel masks".Split(' ')];

    public void Dispose() => _bombs.Dispose();

    [Theory]
    [InlineData("harvester roads,1\n", "1")]
    [InlineData("vnod\n", "1")]
    [InlineData("[{\"AreaId\": 1, \"Nodes\": [], \"x\": \"", "a")]
    [InlineData("[{\"AreaId\": 1, \"Nodes\": [", "{},")]
    [InlineData("<scene><objects><object class=\"vehiclenode\" guid=\"", "a")]
    [InlineData("<scene><objects><object class=\"vehiclelink\">", "<a/>")]
    [InlineData("<NodeDictionary>", "<a/>")]
    public void Packed_road_file_of_900_MB_is_refused(string start, string again)
    {
        string gzip = _bombs.PathOf("roads.gz");
        using (var stream = new GZipStream(File.Create(gzip), CompressionLevel.Fastest))
        {
            BombFolder.Fill(stream, start, again, megabytes: 900);
        }

        AssertRefused("roads", "info", gzip);
    }

    [Fact]
    public void Table_of_paint_with_very_many_lines_is_refused()
    {
        const string link = "harvester paint,1\nlink,0,0,-200,30,0,0,30,0,200\n";
        string roads = _bombs.PathOf("straight.csv");
        File.WriteAllText(roads, WritingCommand.Roads);
        string paint = _bombs.PathOf("paint.csv");
        using (FileStream stream = File.Create(paint))
        {
            BombFolder.Fill(stream, link, "line,0,0,100,2,2,solid,white,0.15,,,,0.02,1\n", megabytes: 200);
        }

        AssertRefused("lanes", "--roads", roads, "--paint", paint, "--position", "2,-100,30", "--heading", "0");
    }

    [Fact]
    public void Packed_file_of_900_MB_in_a_zip_is_refused()
    {
        string zip = _bombs.PathOf("roads.zip");
        using (var archive = new ZipArchive(File.Create(zip), ZipArchiveMode.Create))
        {
            using Stream entry = archive.CreateEntry("0.csv", CompressionLevel.Fastest).Open();
            BombFolder.Fill(entry, "harvester roads,1\n", "1", megabytes: 900);
        }

        AssertRefused("roads", "info", zip);
    }

    [Fact]
    public void Zip_of_very_many_files_is_refused()
    {
        string zip = _bombs.PathOf("roads.zip");
        ManyFilesZip.Write(zip, files: 200_000, "harvester roads,1\n");

        AssertRefused("roads", "info", zip);
    }

    [Fact]
    public void Tape_that_unpacks_to_more_than_4_GiB_is_refused()
    {
        string tape = _bombs.PathOf("bomb.tape");
        byte[] facts = TapeBytes.Facts(TapeFormat.MaxChunkBytes);
        byte[] one = TapeBytes.Of([], facts);
        byte[] chunk = one[TapeBytes.HeadBytes..];
        using (FileStream file = File.Create(tape))
        {
            file.Write(one);
            for (long unpacked = facts.Length; unpacked <= TapeFormat.MaxUnpackedBytes; unpacked += facts.Length)
            {
                file.Write(chunk);
            }
        }

        Assert.Contains("unpacked-size limit of 4 GiB", AssertBounded("tape", "play", tape).Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Tape_with_many_long_facts_is_refused()
    {
        const int bytes = 30_000_000;
        string tape = _bombs.PathOf("facts.tape");
        File.WriteAllBytes(
            tape,
            TapeBytes.Of([], [.. Enumerable.Range(0, 40).Select(i => TapeBytes.Encoded(new TapeFact($"fact {i}", new string('a', bytes))))])
        );

        AssertRefused("tape", "play", tape);
    }

    [Fact]
    public void Tape_with_a_call_of_millions_of_arguments_is_refused()
    {
        string tape = _bombs.PathOf("call.tape");
        File.WriteAllBytes(tape, TapeBytes.Of([], TapeBytes.Encoded(new TapeCall(1, new TapeValue[30_000_000], default, []))));

        AssertRefused("tape", "play", tape);
    }

    [Fact]
    public void Tape_of_millions_of_ticks_is_refused()
    {
        const byte tick = 2;
        string tape = _bombs.PathOf("ticks.tape");
        byte[] ticks = new byte[TapeFormat.MaxChunkBytes];
        Array.Fill(ticks, tick);
        File.WriteAllBytes(tape, TapeBytes.Of([], ticks));

        AssertRefused("tape", "play", tape);
    }

    [Fact]
    public void Line_of_100_MB_of_points_is_refused() =>
        AssertRefused(
            "project",
            "--position",
            "0,0,0",
            "--rotation",
            "0,0,0",
            "--fov",
            "50",
            "--size",
            "80x60",
            "--points",
            _bombs.File("points.csv", "", "1,", megabytes: 100)
        );

    [Fact]
    public void Millions_of_vehicles_are_refused() =>
        AssertRefused(
            "lanes",
            "--roads",
            _bombs.Roads(),
            "--position",
            "0,0,0",
            "--heading",
            "0",
            "--vehicles",
            _bombs.File("vehicles.csv", "", "10,20,0,90\n", megabytes: 100)
        );

    [Fact]
    public void List_of_31_MB_of_empty_props_is_refused() =>
        AssertRefused(
            "contact-sheet",
            "--out",
            _bombs.PathOf("sheet.png"),
            "--roads",
            _bombs.Roads(),
            "--props",
            _bombs.File("props.json", "[", "[],", megabytes: 31)
        );

    [Theory]
    [InlineData("stats", "[", 900)]
    [InlineData("validate", "[", 900)]
    [InlineData("validate", "x\n", 60)]
    public void Labels_that_are_none_are_refused(string command, string again, int megabytes)
    {
        _bombs.File("session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 } }""");
        File.AppendAllText(_bombs.File("labels.jsonl", "", again, megabytes), "\n");

        AssertRefused(command, _bombs.Folder);
    }

    [Theory]
    [MemberData(nameof(Sessions))]
    public void Pictures_of_the_largest_size_fit(string command) => AssertBounded(CommandOf(command, _bombs.SessionOfLargePictures()));

    [Theory]
    [InlineData("validate")]
    [InlineData("stats")]
    [InlineData("report")]
    public void Frames_of_very_many_labels_fit(string command) => AssertBounded(CommandOf(command, _bombs.SessionOfManyLabels()));

    /// <summary>What lies behind the last line of the picture is not unpacked.</summary>
    [Fact]
    public void Picture_that_unpacks_to_2_GB_fits()
    {
        string session = _bombs.SmallSession();
        BombFolder.WritePng(Path.Combine(session, "frames/00000000.png"), width: 80, height: 60, unpackedMegabytes: 2000);

        AssertBounded("report", session, "--still", "0", "--out", _bombs.PathOf("still.png"));
    }

    [Fact]
    public void Gallery_of_1_GB_of_photographs_is_refused() =>
        AssertRefused("spaces", "gallery", _bombs.Gallery(pictures: 20, megabytes: 50));

    [Theory]
    [InlineData("x", 63)]
    [InlineData("x\n", 63)]
    [InlineData("2026-01-01 10:00:00 a line of a log that is somewhat longer than others\n", 63)]
    [InlineData("2026-01-01 10:00:00 GtaDataHarvester 1.0.0, API v3.6.0, game 1.0.3095.0\n", 63)]
    public void Log_of_the_largest_size_fits(string again, int megabytes) =>
        AssertBounded("doctor", _bombs.File("GtaDataHarvester.log", "", again, megabytes));

    [Fact]
    public void Self_test_of_2_GB_is_refused() => AssertRefused("doctor", _bombs.SelfTest(megabytes: 2048));

    [Theory]
    [InlineData("entry of 2 GB")]
    [InlineData("name of 1 GB")]
    [InlineData("sample of 2 GB")]
    [InlineData("many entries")]
    public void Archive_bomb_is_refused(string bomb) => AssertRefused("validate", _bombs.WebDataset(bomb));

    [Theory]
    [InlineData("csv", "objects.csv", "\"", "\n", 900)]
    [InlineData("csv", "objects.csv", "", ",", 7)]
    [InlineData("csv", "objects.csv", "", "a\n", 100)]
    [InlineData("coco", "annotations/instances_train.json", "{\"images\": [", "{},", 200)]
    [InlineData("coco", "annotations/instances_train.json", "{\"images\": [], \"annotations\": [{\"segmentation\": [", "0,", 200)]
    [InlineData("csv", "export.json", "{\"plan\": [", "[],", 15)]
    [InlineData("kitti", "training/label_2/000000.txt", "", "Car ", 900)]
    [InlineData("kitti", "training/label_2/000000.txt", "", "Car\n", 100)]
    [InlineData("voc", "Annotations/00000000.xml", "<annotation>", "<a/>", 15)]
    [InlineData("voc", "Annotations/00000000.xml", "<annotation>", "<a/>", 900)]
    [InlineData("yolo", "labels/train/00000000.txt", "", "0 0 0 0 0\n", 100)]
    public void Dataset_bomb_is_refused(string format, string file, string start, string again, int megabytes)
    {
        string dataset = _bombs.Dataset(format);
        _bombs.File(Path.Combine(dataset, file), start, again, megabytes);

        AssertRefused("validate", dataset);
    }

    private string[] CommandOf(string name, string session) =>
        name switch
        {
            "still" => ["report", session, "--still", "0", "--out", _bombs.PathOf("still.png")],
            "report" => ["report", session, "--out", _bombs.PathOf("report.html")],
            "coco" => ["export", session, "--format", "coco", "--out", _bombs.PathOf("out")],
            "csv-jpg" => ["export", session, "--format", "csv", "--image-format", "jpg", "--out", _bombs.PathOf("out")],
            "relabel" => ["relabel", session, "--no-report", "--out", _bombs.PathOf("out")],
            "masks" => ["masks", "import", session, Path.Combine(session, "masks")],
            _ => [name, session],
        };

    private void AssertRefused(params string[] arguments)
    {
        MeasuredRun run = AssertBounded(arguments);
        Assert.True(run.ExitCode is ExitCode.BadData or ExitCode.InputOutput, $"{run.ExitCode}: {run.Error}");
    }

    private MeasuredRun AssertBounded(params string[] arguments)
    {
        MeasuredRun run = MeasuredRun.Of(arguments);
        output.WriteLine($"{run.PeakBytes / 1_000_000} MB, exit code {run.ExitCode}: {run.Error.Trim()}");
        Assert.True(run.ExitCode is ExitCode.Done or ExitCode.BadData or ExitCode.InputOutput, $"{run.ExitCode}: {run.Error}");
        Assert.InRange(run.Error.Count(character => character == '\n'), 0, 1);
        Assert.InRange(run.PeakBytes ?? 0, 0, MaxBytes);
        return run;
    }
}
