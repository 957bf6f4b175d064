using System.Formats.Tar;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

public sealed class PairsCommandTests(HarvestedPairs harvested) : IClassFixture<HarvestedPairs>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Made => _folder.PathOf("made");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Index_has_a_row_for_each_picture()
    {
        CliRun run = CliRun.Of("pairs", harvested.Session, "--out", Made);
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];
        int pictures = labels.Sum(label => 1 + label.Pairs.Count);

        Assert.Equal((ExitCode.Done, "", $"{Made}: 4 groups, {pictures} pictures\n"), (run.ExitCode, run.Error, run.Out));
        string[][] rows = [.. File.ReadAllLines(Path.Combine(Made, "index.csv")).Select(line => line.Split(','))];
        Assert.Equal(["group", "image", "weather", "time_of_day", "without", "x_min", "y_min", "x_max", "y_max"], rows[0]);
        Assert.Equal(pictures, rows.Length - 1);
        Assert.All(rows.Skip(1), row => Assert.True(File.Exists(Path.Combine(Made, row[1]))));
        Assert.Equal(
            File.ReadAllBytes(Path.Combine(harvested.Session, "pairs/00000000/rain-00.png")),
            File.ReadAllBytes(Path.Combine(Made, "images/00000000/rain-00.png"))
        );
        Assert.Equal(labels.Sum(label => label.Objects.Count), File.ReadAllLines(Path.Combine(Made, "objects.csv")).Length - 1);

        PairLabel hidden = labels[0].Pairs.First(pair => pair.Without.Count == 1);
        ObjectLabel item = labels[0].Objects.Single(item => item.Id == hidden.Without[0]);
        string[] row = rows.Single(row => row[1] == $"images/00000000/{Path.GetFileName(hidden.File)}");
        Assert.Equal($"{item.Id}", row[4]);
        Assert.Equal(item.Box2D.XMin, double.Parse(row[5]), 3);
        Assert.Equal(item.Box2D.YMax, double.Parse(row[8]), 3);
    }

    [Fact]
    public void Archive_has_a_sample_for_each_group()
    {
        CliRun.Of("pairs", harvested.Session, "--out", Made, "--format", "webdataset").AssertDone();
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];
        List<string> names = [];
        using (var tar = new TarReader(File.OpenRead(Path.Combine(Made, "pairs-000000.tar"))))
        {
            while (tar.GetNextEntry() is { } entry)
            {
                names.Add(entry.Name);
            }
        }

        Assert.Equal(
            labels.SelectMany(label =>
                ((string[])[".json", ".frame.png"])
                    .Concat(label.Pairs.Select(pair => "." + Path.GetFileName(pair.File)))
                    .Select(end => $"{label.Frame:D8}{end}")
            ),
            names
        );
        Assert.Contains(
            "pairs-000000.tar/00000000.rain-12.png",
            File.ReadAllText(Path.Combine(Made, "index.csv")),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Stopped_export_is_written_anew_by_the_same_command()
    {
        string[] command = ["pairs", harvested.Session, "--out", Made, "--format", "webdataset"];
        CliRun.Of(command).AssertDone();
        Dictionary<string, byte[]> whole = Directory.GetFiles(Made).ToDictionary(file => Path.GetFileName(file), File.ReadAllBytes);

        // What a kill leaves: the mark, and files that are not all of this export.
        UnfinishedMark.Write(Made, CommandText.Of(["pairs", harvested.Session, "--format", "webdataset"]));
        File.WriteAllText(Path.Combine(Made, "pairs-000007.tar"), "half");
        File.WriteAllText(Path.Combine(Made, "index.csv"), "half");
        CliRun.Of("pairs", harvested.Session, "--out", Made).AssertFailed(ExitCode.Usage, "is not empty");
        CliRun.Of(command).AssertDone();

        Assert.Equal(whole.Keys.Order(), Directory.GetFiles(Made).Select(file => Path.GetFileName(file)).Order());
        Assert.All(whole, file => Assert.Equal(file.Value, File.ReadAllBytes(Path.Combine(Made, file.Key))));
    }

    [Theory]
    [InlineData("whole", true)]
    [InlineData("byte", false)]
    [InlineData("short", false)]
    [InlineData("longer", false)]
    public void Resumed_export_keeps_archives_that_are_whole(string state, bool isKept)
    {
        string[] command = ["pairs", harvested.Session, "--out", Made, "--format", "webdataset", "--resume"];
        CliRun.Of(command).AssertDone();
        Dictionary<string, byte[]> whole = Directory.GetFiles(Made).ToDictionary(file => Path.GetFileName(file), File.ReadAllBytes);
        string archive = Path.Combine(Made, "pairs-000000.tar");
        byte[] bytes = File.ReadAllBytes(archive);
        bytes[bytes.Length / 2] ^= state == "byte" ? (byte)1 : (byte)0;
        File.WriteAllBytes(
            archive,
            state == "short" ? bytes[..(bytes.Length / 2)]
                : state == "longer" ? [.. bytes, .. bytes]
                : bytes
        );
        File.Copy(archive, Path.Combine(Made, "pairs-000001.tar"));
        UnfinishedMark.Write(Made, CommandText.Of(command.Where(word => word != Made && word is not ("--out" or "--resume"))));
        var longAgo = new DateTime(2001, 2, 3, 4, 5, 6, DateTimeKind.Utc);
        File.SetLastWriteTimeUtc(archive, longAgo);
        CliRun.Of(command).AssertDone();

        Assert.Equal(isKept, File.GetLastWriteTimeUtc(archive) == longAgo);
        Assert.Equal(whole.Keys.Order(), Directory.GetFiles(Made).Select(file => Path.GetFileName(file)).Order());
        Assert.All(whole, file => Assert.Equal(file.Value, File.ReadAllBytes(Path.Combine(Made, file.Key))));
    }

    [Fact]
    public void Resumed_export_keeps_pictures_that_are_whole()
    {
        string[] command = ["pairs", harvested.Session, "--out", Made, "--images", "copy", "--resume"];
        CliRun.Of(command).AssertDone();
        string[] pictures = Directory.GetFiles(Path.Combine(Made, "images", "00000000"));
        var longAgo = new DateTime(2001, 2, 3, 4, 5, 6, DateTimeKind.Utc);
        Array.ForEach(pictures, picture => File.SetLastWriteTimeUtc(picture, longAgo));
        byte[] first = File.ReadAllBytes(pictures[0]);
        File.WriteAllText(pictures[0], "half");
        File.WriteAllText(Path.Combine(Made, "images", "00000000", "other.png"), "of a session that was changed");
        Directory.CreateDirectory(Path.Combine(Made, "images", "00000077"));
        UnfinishedMark.Write(Made, CommandText.Of(["pairs", harvested.Session, "--images", "copy"]));
        CliRun.Of(command).AssertDone();

        Assert.Equal(first, File.ReadAllBytes(pictures[0]));
        Assert.All(pictures.Skip(1), picture => Assert.Equal(longAgo, File.GetLastWriteTimeUtc(picture)));
        Assert.Equal(pictures.Order(), Directory.GetFiles(Path.Combine(Made, "images", "00000000")).Order());
        Assert.Equal(4, Directory.GetDirectories(Path.Combine(Made, "images")).Length);
    }

    [Fact]
    public void Resumed_export_follows_no_link()
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        string[] command = ["pairs", harvested.Session, "--out", Made, "--resume"];
        string outside = Directory.CreateDirectory(_folder.PathOf("outside")).FullName;
        File.WriteAllText(Path.Combine(outside, "mine"), "mine");
        Directory.CreateDirectory(Path.Combine(Made, "images"));
        Directory.CreateSymbolicLink(Path.Combine(Made, "images", "00000000"), outside);
        UnfinishedMark.Write(Made, CommandText.Of(["pairs", harvested.Session]));

        CliRun.Of(command).AssertFailed(ExitCode.InputOutput, "is a link");
        Assert.Equal(["mine"], Directory.GetFiles(outside).Select(file => Path.GetFileName(file)));
    }

    [Theory]
    [InlineData("csv", "webdataset")]
    [InlineData("webdataset", "csv")]
    public void Resume_of_a_finished_export_is_success(string format, string other)
    {
        string[] command = ["pairs", harvested.Session, "--out", Made, "--resume", "--format"];
        CliRun.Of([.. command, format]).AssertDone();
        FolderContent complete = FolderContent.Of(Made);

        CliRun run = CliRun.Of([.. command, format]);

        run.AssertDone();
        Assert.EndsWith("; the export is finished already.\n", run.Out, StringComparison.Ordinal);
        CliRun.Of([.. command, other]).AssertFailed(ExitCode.Usage, "already has a finished export");
        Assert.Equal(complete, FolderContent.Of(Made));
    }

    [Fact]
    public void Resume_of_a_finished_export_of_other_labels_is_refused()
    {
        CliRun.Of("pairs", harvested.Session, "--out", Made).AssertDone();
        File.AppendAllText(Path.Combine(Made, "objects.csv"), "00000009,1,car,,,0,0,1,1,5\n");

        CliRun.Of("pairs", harvested.Session, "--out", Made, "--resume").AssertFailed(ExitCode.Usage, "already has a finished export");
    }

    [Fact]
    public void Folder_with_other_files_is_left_alone()
    {
        Directory.CreateDirectory(Made);
        File.WriteAllText(Path.Combine(Made, "index.csv"), "mine");

        CliRun.Of("pairs", harvested.Session, "--out", Made).AssertFailed(ExitCode.Usage, "already has a finished export");
        File.WriteAllText(Path.Combine(Made, "notes.txt"), "mine");
        CliRun.Of("pairs", harvested.Session, "--out", Made).AssertFailed(ExitCode.Usage, "is not empty");
        Assert.Equal("mine", File.ReadAllText(Path.Combine(Made, "index.csv")));
    }

    [Fact]
    public void Session_without_pairs_is_refused()
    {
        string plain = _folder.PathOf("plain");
        CliRun.Of("harvest", "--out", plain, "--frames", "1", "--size", "64x48", "--no-report").AssertDone();

        CliRun.Of("pairs", plain, "--out", Made).AssertFailed(ExitCode.BadData, "no further pictures");
        Assert.False(Directory.Exists(Made));
    }

    [Theory]
    [InlineData("\"file\":\"pairs/00000000/", "\"file\":\"../")]
    [InlineData("\"file\":\"pairs/00000000/rain-12.png\"", "\"file\":null")]
    [InlineData("\"without\":[]", "\"without\":[0]")]
    [InlineData("\"file\":\"pairs/00000000/rain-12.png\"", "\"file\":\"pairs/00000000/rain-00.png\"")]
    [InlineData("\"file\":\"pairs/00000000/rain-12.png\"", "\"file\":\"labels.jsonl\"")]
    public void Damaged_label_is_refused_in_one_line(string from, string to)
    {
        string session = _folder.PathOf("damaged");
        CliRun.Of("relabel", harvested.Session, "--out", session, "--images", "copy", "--no-report").AssertDone();
        string labels = Path.Combine(session, "labels.jsonl");
        string text = File.ReadAllText(labels);
        Assert.Contains(from, text, StringComparison.Ordinal);
        File.WriteAllText(labels, text.Replace(from, to, StringComparison.Ordinal));

        CliRun run = CliRun.Of("pairs", session, "--out", Made);
        Assert.Equal((ExitCode.BadData, 1), (run.ExitCode, run.Error.Count(letter => letter == '\n')));
        Assert.False(Directory.Exists(Made));
    }
}
